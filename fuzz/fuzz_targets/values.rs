//! Reads any bytes as values. Plain numbers are those of the standard library, bit by bit.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mapd_xodr::values::{Lexical, Speed, boolean, country, double, integer, speed, text};

fuzz_target!(|bytes: &[u8]| {
    fn check<T>(read: Lexical<T>) {
        assert!(read.value.is_some() || read.quirk.is_some());
        if let Some(quirk) = read.quirk {
            assert!(!quirk.to_string().is_empty());
        }
    }
    let number = double(bytes);
    assert!(number.value.is_none_or(f64::is_finite));
    check(number);
    check(integer(bytes));
    check(boolean(bytes));
    check(country(bytes));
    let limit = speed(bytes);
    assert!(!matches!(limit.value, Some(Speed::Limit(value)) if !value.is_finite()));
    check(limit);
    let Ok(words) = std::str::from_utf8(bytes) else { return };
    let resolved = text(words);
    assert!(resolved.len() <= words.len());
    match words.parse::<f64>() {
        Ok(value) if value.is_finite() => {
            assert_eq!(number.value.map(f64::to_bits), Some(value.to_bits()));
            assert_eq!(number.quirk, None);
        }
        // Everything else has a quirk, but for a number with its digits as references.
        _ => assert!(number.quirk.is_some() || words.contains('&')),
    }
    if let Ok(value) = words.parse::<i64>() {
        assert_eq!(integer(bytes).value, Some(value));
    }
});
