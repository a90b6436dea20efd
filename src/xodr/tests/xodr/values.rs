//! What texts mean: tables of cases, and agreement with the standard library on random ones.

use mapd_xodr::values::{
    Country, CountryForm, Quirk, Speed, boolean, country, double, integer, speed, text,
};

#[track_caller]
fn check_double(raw: &str, value: Option<f64>, quirk: Option<Quirk>) {
    let read = double(raw.as_bytes());
    assert_eq!((read.value, read.quirk), (value, quirk), "{raw:?}");
}

#[test]
fn doubles() {
    use Quirk::*;
    for raw in [
        "0",
        "-0",
        "1.5",
        ".5",
        "5.",
        "+1e-3",
        "4.9000000000000000e+1",
        "1E+5",
        "1e-400",
        "0001",
        "1e308",
        "5e-324",
    ] {
        check_double(raw, raw.parse().ok(), None);
    }
    for (raw, value) in [("12 ", 12.0), ("\t\n-1.5\r", -1.5), (" 1e3", 1e3), (" .5", 0.5)] {
        check_double(raw, Some(value), Some(Space));
    }
    for (raw, value, quirk) in [
        ("4.00000000000000000+0", 4.0, NoExponentLetter),
        ("-4.5-000", -4.5, NoExponentLetter),
        (" 4+0 ", 4.0, NoExponentLetter),
        ("1.5D+02", 150.0, FortranExponent),
        ("1d0", 1.0, FortranExponent),
        ("1,5", 1.5, DecimalComma),
        ("-0,125", -0.125, DecimalComma),
        ("0,125", 0.125, DecimalComma),
        ("1234,567", 1234.567, DecimalComma),
        ("1,50e-3", 1.5e-3, DecimalComma),
        ("1,500e-3", 1.5e-3, DecimalComma),
        ("1.5+0i", 1.5, Complex),
        ("-1.5e-3-0.0j", -1.5e-3, Complex),
        ("1.5 + 0i", 1.5, Complex),
        ("(1.5,0)", 1.5, Complex),
        ("(1.5, 0.0)", 1.5, Complex),
    ] {
        check_double(raw, Some(value), Some(quirk));
    }
    check_double("&#49;.5", Some(1.5), None);
    check_double("1&#x20;", Some(1.0), Some(Space));
    for (quirk, raws) in [
        (Empty, &["", " ", "\n\t"][..]),
        (
            NotFinite,
            &[
                "INF",
                "-INF",
                "+INF",
                "NaN",
                "nan",
                "inf",
                "Infinity",
                "-nan(ind)",
                "nan(snan)",
                "1.#INF",
                "-1.#IND00",
                "1.#QNAN",
                " NaN ",
            ],
        ),
        (TooLarge, &["1e999", "-1e309", "1.8e308"]),
        (Hexadecimal, &["0x1p3", "0X10", "-0xff", "0x"]),
        (
            Ambiguous,
            &[
                "4.0+2", "1.5-100", "1,500", "-12,345", "1,5,0", "1.000,5", "1,000.5", ",5", "5,",
                "1.5+2i", "(1,2)",
            ],
        ),
        (
            NotANumber,
            &[
                "abc",
                "None",
                "3.5 m",
                "1 000",
                "1.5.2",
                "--1",
                "+",
                ".",
                "e5",
                "1e",
                "1e+",
                "1_000",
                "5 km/h",
                "i",
                "1i",
                "null",
                "\u{2212}1.5",
                "1.5;",
                "\u{feff}1",
                "()",
                "(,)",
                "&amp;",
                "&bogus;1",
                "1d",
                "1\0",
                "#",
                "infinit",
                "++INF",
            ],
        ),
    ] {
        for raw in raws {
            check_double(raw, None, Some(quirk));
        }
    }
}

/// A generator of numbers with a fixed start, so that a failure can be repeated. (Marsaglia, Xorshift RNGs, 2003)
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
}

/// Every text that the standard library reads is read to the very same bits.
#[test]
fn doubles_are_rounded_correctly() {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let agree = |raw: &str| {
        let expected: f64 = raw.parse().expect("the standard library reads it");
        let read = double(raw.as_bytes());
        let expected = expected.is_finite().then_some(expected.to_bits());
        assert_eq!(read.value.map(f64::to_bits), expected, "{raw}");
        assert_eq!(read.quirk, expected.is_none().then_some(Quirk::TooLarge), "{raw}");
    };
    for _ in 0..200_000 {
        let bits = f64::from_bits(random.next());
        if bits.is_finite() {
            // Shortest, with many digits, and halfway to the next double.
            agree(&format!("{bits:e}"));
            agree(&format!("{bits:.17e}"));
            agree(&format!("{bits:.30e}"));
        }
        let small = (random.next() as i32 as f64) / f64::from(1 << (random.next() % 24) as u32);
        agree(&format!("{small}"));
        agree(&format!("{small:.16e}"));
        agree(&format!("{:.6}", small * 1e-3));
        let (whole, part) = (random.next() >> (random.next() % 64), random.next());
        agree(&format!("{whole}.{part}e{}", (random.next() % 700) as i64 - 350));
    }
    // Exactly halfway between two doubles, and just beside it.
    for _ in 0..20_000 {
        let low = (1_u64 << 53) + (random.next() >> 12 << 1);
        for text in [format!("{}", low + 1), format!("{}.0001", low + 1), format!("{low}.9999")] {
            agree(&text);
        }
    }
}

/// Zeros as exporters write them, and what is like them, read as the standard library reads them.
#[test]
fn zeros_are_those_of_the_standard_library() {
    let zero = "0.0000000000000000e+00";
    for length in 0..=zero.len() {
        for at in 0..length {
            for other in "019.e+-x".chars() {
                let mut raw = zero[..length].to_owned();
                raw.replace_range(at..=at, other.encode_utf8(&mut [0; 4]));
                let read = double(raw.as_bytes());
                match raw.parse::<f64>() {
                    Ok(due) => {
                        assert_eq!(read.value.map(f64::to_bits), Some(due.to_bits()), "{raw}");
                        assert_eq!(read.quirk, None, "{raw}");
                    }
                    Err(_) => assert!(read.quirk.is_some(), "{raw}"),
                }
            }
        }
    }
}

/// Whatever the bytes are, there is a value or a quirk, and values are finite.
#[test]
fn any_bytes_are_read() {
    let mut random = Random(7);
    let alphabet = b"0123456789+-.,eEdDijxINFanf()#& \t;\xff\xc3";
    for _ in 0..300_000 {
        let len = random.next() % 12;
        let raw: Vec<u8> =
            (0..len).map(|_| alphabet[(random.next() % alphabet.len() as u64) as usize]).collect();
        let read = double(&raw);
        assert!(read.value.is_some() || read.quirk.is_some(), "{raw:?}");
        assert!(read.value.is_none_or(f64::is_finite), "{raw:?}");
        for none in [
            integer(&raw).map_or_none(),
            boolean(&raw).map_or_none(),
            speed(&raw).map_or_none(),
            country(&raw).map_or_none(),
        ] {
            assert!(none, "{raw:?}");
        }
    }
}

trait HasOutcome {
    fn map_or_none(&self) -> bool;
}

impl<T> HasOutcome for mapd_xodr::values::Lexical<T> {
    fn map_or_none(&self) -> bool {
        self.value.is_some() || self.quirk.is_some()
    }
}

#[test]
fn integers() {
    use Quirk::*;
    let max = i64::MAX.to_string();
    for (raw, value, quirk) in [
        ("0", Some(0), None),
        ("-1", Some(-1), None),
        ("+12", Some(12), None),
        ("007", Some(7), None),
        (&max, Some(i64::MAX), None),
        ("-9223372036854775808", Some(i64::MIN), None),
        ("00000000000000000000000001", Some(1), None),
        ("12 ", Some(12), Some(Space)),
        ("3.0", Some(3), Some(PointInInteger)),
        ("-3.", Some(-3), Some(PointInInteger)),
        ("&#49;", Some(1), None),
        ("9223372036854775808", None, Some(TooLarge)),
        ("3.5", None, Some(NotAnInteger)),
        ("1e3", None, Some(NotAnInteger)),
        ("", None, Some(Empty)),
        ("0x10", None, Some(Hexadecimal)),
        ("NaN", None, Some(NotFinite)),
        ("1,5", None, Some(NotAnInteger)),
        ("1,500", None, Some(Ambiguous)),
        ("-", None, Some(NotANumber)),
        ("Kalle", None, Some(NotANumber)),
    ] {
        let read = integer(raw.as_bytes());
        assert_eq!((read.value, read.quirk), (value, quirk), "{raw:?}");
    }
}

#[test]
fn booleans() {
    use Quirk::*;
    for (raw, value, quirk) in [
        ("true", Some(true), None),
        ("false", Some(false), None),
        (" true", Some(true), Some(Space)),
        ("1", Some(true), Some(OtherBoolean)),
        ("0", Some(false), Some(OtherBoolean)),
        ("True", Some(true), Some(OtherBoolean)),
        ("FALSE", Some(false), Some(OtherBoolean)),
        ("yes", Some(true), Some(OtherBoolean)),
        ("no", Some(false), Some(OtherBoolean)),
        ("", None, Some(Empty)),
        ("2", None, Some(NotABoolean)),
        ("maybe", None, Some(NotABoolean)),
    ] {
        let read = boolean(raw.as_bytes());
        assert_eq!((read.value, read.quirk), (value, quirk), "{raw:?}");
    }
}

#[test]
fn speeds() {
    use Quirk::*;
    for (raw, value, quirk) in [
        ("50", Some(Speed::Limit(50.0)), None),
        ("-1", Some(Speed::Limit(-1.0)), None),
        ("no limit", Some(Speed::NoLimit), None),
        ("undefined", Some(Speed::Undefined), None),
        ("no limit ", Some(Speed::NoLimit), Some(Space)),
        ("No Limit", Some(Speed::NoLimit), Some(OtherCase)),
        ("no_limit", Some(Speed::NoLimit), Some(OtherCase)),
        ("nolimit", Some(Speed::NoLimit), Some(OtherCase)),
        ("13,9", Some(Speed::Limit(13.9)), Some(DecimalComma)),
        ("", None, Some(Empty)),
        ("INF", None, Some(NotFinite)),
        ("50 km/h", None, Some(NotANumber)),
        ("limit", None, Some(NotANumber)),
    ] {
        let read = speed(raw.as_bytes());
        assert_eq!((read.value, read.quirk), (value, quirk), "{raw:?}");
    }
}

#[test]
fn countries() {
    use CountryForm::*;
    use Quirk::*;
    for (raw, value, quirk) in [
        ("DE", Some(Country::Code(*b"DE", Alpha2)), None),
        ("DEU", Some(Country::Code(*b"DE", Alpha3)), None),
        ("Germany", Some(Country::Code(*b"DE", Name)), None),
        ("USA", Some(Country::Code(*b"US", Alpha3)), None),
        ("ZW", Some(Country::Code(*b"ZW", Alpha2)), None),
        ("OpenDRIVE", Some(Country::Generic), None),
        ("DE ", Some(Country::Code(*b"DE", Alpha2)), Some(Space)),
        ("se", Some(Country::Code(*b"SE", Alpha2)), Some(OtherCase)),
        ("germany", Some(Country::Code(*b"DE", Name)), Some(OtherCase)),
        ("opendrive", Some(Country::Generic), Some(OtherCase)),
        ("", None, Some(Empty)),
        ("D", None, Some(UnknownCountry)),
        ("D ", None, Some(UnknownCountry)),
        ("XX", None, Some(UnknownCountry)),
        ("EAN", None, Some(UnknownCountry)),
        ("Narnia", None, Some(UnknownCountry)),
        ("-1", None, Some(UnknownCountry)),
    ] {
        let read = country(raw.as_bytes());
        assert_eq!((read.value, read.quirk), (value, quirk), "{raw:?}");
    }
}

#[test]
fn texts() {
    for (raw, expected) in [
        ("plain", "plain"),
        ("a &amp; b &lt;&gt;&quot;&apos;", "a & b <>\"'"),
        ("&#65;&#x42;&#x1F6E3;", "AB\u{1f6e3}"),
        ("a\tb\r\nc\rd\ne", "a b c d e"),
        ("&#10;", "\n"),
        ("&amp;amp;", "&amp;"),
        (
            "&bogus; &#0; &#xd800; &#+65; &#x; &; & &unfinished",
            "&bogus; &#0; &#xd800; &#+65; &#x; &; & &unfinished",
        ),
    ] {
        assert_eq!(text(raw), expected, "{raw:?}");
    }
}

#[test]
fn every_quirk_has_a_sentence() {
    assert_eq!(
        Quirk::DecimalComma.to_string(),
        "expected a decimal point, found a comma; read as the point"
    );
}
