//! Decimal numbers and whole numbers.

use super::text::resolve;
use super::{Lexical, Quirk, trimmed};

/// Reads a finite number, rounded to the nearest double, ties to even. The table in [`values`](super) says what becomes of
/// texts that are not of the form of `xs:double`.
///
/// ```
/// use mapd_xodr::values::{Quirk, double};
///
/// assert_eq!(double(b"1.5e2").value, Some(150.0));
/// assert_eq!(double(b"INF").quirk, Some(Quirk::NotFinite));
/// ```
#[inline]
pub fn double(raw: &[u8]) -> Lexical<f64> {
    if is_plain_zero(raw) {
        return Lexical::clean(0.0);
    }
    match fast_float2::parse(raw) {
        Ok(value) if f64::is_finite(value) => Lexical::clean(value),
        _ => unusual(raw),
    }
}

/// Zero with as many digits and as much of an exponent as exporters write: many maps have many of them.
const ZERO: &[u8; 22] = b"0.0000000000000000e+00";
/// How long its beginning is without an exponent, and with one.
const DIGITS: usize = 18;
const EXPONENT: [usize; 2] = [21, 22];

/// Whether a text is [`ZERO`], or a beginning of it that is a number.
#[inline]
fn is_plain_zero(raw: &[u8]) -> bool {
    let len = raw.len();
    if raw.first() != Some(&b'0') || len > DIGITS && !EXPONENT.contains(&len) {
        return false;
    }
    let Some(due) = ZERO.get(..len) else { return false };
    match (raw.first_chunk::<8>(), raw.last_chunk::<8>()) {
        // Eight bytes at a time; the last ones overlap those before.
        (Some(first), Some(last)) => {
            Some(first) == due.first_chunk()
                && Some(last) == due.last_chunk()
                && (len <= 16 || raw.get(8..16) == due.get(8..16))
        }
        _ => raw.iter().zip(due).all(|(byte, due)| byte == due),
    }
}

/// Everything but a plain finite number.
#[cold]
fn unusual(raw: &[u8]) -> Lexical<f64> {
    if memchr::memchr(b'&', raw).is_some() {
        return match resolve(raw) {
            Some(text) => double(text.as_bytes()),
            None => Lexical::none(Quirk::NotANumber),
        };
    }
    let (text, space) = trimmed(raw);
    if text.is_empty() {
        return Lexical::none(Quirk::Empty);
    }
    if let Ok(value) = fast_float2::parse::<f64, _>(text) {
        if value.is_finite() {
            return Lexical { value: Some(value), quirk: space };
        }
        let has_digit = text.iter().any(u8::is_ascii_digit);
        return Lexical::none(if has_digit { Quirk::TooLarge } else { Quirk::NotFinite });
    }
    irregular(text)
}

/// A text that is no number of `xs:double`.
fn irregular(text: &[u8]) -> Lexical<f64> {
    let lower = text.to_ascii_lowercase();
    let unsigned = lower.strip_prefix(b"-").or(lower.strip_prefix(b"+")).unwrap_or(&lower);
    if unsigned.starts_with(b"0x") {
        return Lexical::none(Quirk::Hexadecimal);
    }
    // `1.#INF` and the like are Microsoft's, `nan(ind)` too.
    let is_nan = unsigned.starts_with(b"nan(") && unsigned.ends_with(b")");
    if is_nan || unsigned.starts_with(b"1.#") {
        return Lexical::none(Quirk::NotFinite);
    }
    if !unsigned.iter().any(u8::is_ascii_digit) {
        return Lexical::none(Quirk::NotANumber);
    }
    complex(&lower)
        .or_else(|| comma(&lower))
        .or_else(|| fortran(&lower))
        .or_else(|| without_letter(&lower))
        .unwrap_or_else(|| Lexical::none(Quirk::NotANumber))
}

/// A number of `xs:double`, finite.
fn plain(text: &[u8]) -> Option<f64> {
    fast_float2::parse(text).ok().filter(|value: &f64| value.is_finite())
}

/// `1.5+0i`, `1.5-0j`, `(1.5,0)`. None where it is none of these.
fn complex(text: &[u8]) -> Option<Lexical<f64>> {
    let (real, imaginary) = if let [b'(', inner @ .., b')'] = text {
        let comma = memchr::memchr(b',', inner)?;
        (inner[..comma].trim_ascii(), inner[comma + 1..].trim_ascii())
    } else if let [inner @ .., b'i' | b'j'] = text {
        // The sign of an exponent follows its letter.
        let sign = (1..inner.len())
            .rev()
            .find(|at| matches!(inner[*at], b'+' | b'-') && inner[at - 1] != b'e')?;
        (inner[..sign].trim_ascii(), inner[sign + 1..].trim_ascii())
    } else {
        return None;
    };
    let (real, imaginary) = (plain(real)?, plain(imaginary)?);
    Some(if imaginary == 0.0 {
        Lexical::some(real, Quirk::Complex)
    } else {
        Lexical::none(Quirk::Ambiguous)
    })
}

/// `1,5`; not `1,500`, which may be thousands. None where there is no comma between digits.
fn comma(text: &[u8]) -> Option<Lexical<f64>> {
    let at = memchr::memchr(b',', text)?;
    let mut with_point = text.to_vec();
    with_point[at] = b'.';
    let Some(value) = plain(&with_point) else {
        // Several numbers, or one with both signs: in any case nothing but digits and signs.
        let only = text.iter().all(|byte| byte.is_ascii_digit() || b",.+-e".contains(byte));
        return only.then(|| Lexical::none(Quirk::Ambiguous));
    };
    let before = text[..at].iter().filter(|byte| byte.is_ascii_digit());
    let whole = before.clone().count();
    let leading_zero = before.clone().next() == Some(&b'0');
    let behind = text[at + 1..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let end = at + 1 + behind;
    let may_be_thousands =
        end == text.len() && behind == 3 && (1..=3).contains(&whole) && !leading_zero;
    Some(if may_be_thousands || whole == 0 || behind == 0 {
        Lexical::none(Quirk::Ambiguous)
    } else {
        Lexical::some(value, Quirk::DecimalComma)
    })
}

/// `1.5d+02`.
fn fortran(text: &[u8]) -> Option<Lexical<f64>> {
    let at = memchr::memchr(b'd', text)?;
    let mut with_e = text.to_vec();
    with_e[at] = b'e';
    plain(&with_e).map(|value| Lexical::some(value, Quirk::FortranExponent))
}

/// `4.0+0`: a lost `e`, as also Fortran writes it where the exponent has three digits, or a sum. With zero, both are the
/// same number.
fn without_letter(text: &[u8]) -> Option<Lexical<f64>> {
    let sign = 1 + text.get(1..)?.iter().rposition(|byte| matches!(byte, b'+' | b'-'))?;
    let value = plain(&text[..sign])?;
    let exponent = &text[sign + 1..];
    if exponent.is_empty() || !exponent.iter().all(u8::is_ascii_digit) {
        return None;
    }
    Some(if exponent.iter().all(|digit| *digit == b'0') {
        Lexical::some(value, Quirk::NoExponentLetter)
    } else {
        Lexical::none(Quirk::Ambiguous)
    })
}

/// Reads a whole number: a sign or none, and digits. `3.0` is accepted as 3, `3.5` refused.
#[inline]
pub fn integer(raw: &[u8]) -> Lexical<i64> {
    match digits(raw) {
        Some(value) => Lexical::clean(value),
        None => unusual_integer(raw),
    }
}

/// Sign and digits of a number that fits 18 digits, so that no sum overflows.
fn digits(raw: &[u8]) -> Option<i64> {
    let (negative, digits) = match raw {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    if digits.is_empty() || digits.len() > 18 {
        return None;
    }
    let mut value = 0;
    for digit in digits {
        if !digit.is_ascii_digit() {
            return None;
        }
        value = value * 10 + i64::from(digit - b'0');
    }
    Some(if negative { -value } else { value })
}

#[cold]
fn unusual_integer(raw: &[u8]) -> Lexical<i64> {
    if memchr::memchr(b'&', raw).is_some() {
        return match resolve(raw) {
            Some(text) => integer(text.as_bytes()),
            None => Lexical::none(Quirk::NotANumber),
        };
    }
    let (text, space) = trimmed(raw);
    if text.is_empty() {
        return Lexical::none(Quirk::Empty);
    }
    if let Some(value) = digits(text) {
        return Lexical { value: Some(value), quirk: space };
    }
    let unsigned = text.strip_prefix(b"-").or(text.strip_prefix(b"+")).unwrap_or(text);
    if !unsigned.is_empty() && unsigned.iter().all(u8::is_ascii_digit) {
        // The standard library knows where 64 bits end, leading zeros and all.
        let value = std::str::from_utf8(text).ok().and_then(|text| text.parse().ok());
        return Lexical { value, quirk: value.map_or(Some(Quirk::TooLarge), |_| space) };
    }
    if let Some(point) = memchr::memchr(b'.', text)
        && let Some(value) = digits(&text[..point])
        && text[point + 1..].iter().all(|digit| *digit == b'0')
    {
        return Lexical::some(value, Quirk::PointInInteger);
    }
    let number = double(text);
    match number.quirk {
        None => Lexical::none(Quirk::NotAnInteger),
        Some(quirk) if number.value.is_none() => Lexical::none(quirk),
        Some(_) => Lexical::none(Quirk::NotAnInteger),
    }
}
