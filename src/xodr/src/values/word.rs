//! Yes and no, and speed limits, which are a number or a word.

use super::{Lexical, Quirk, double, trimmed};

/// Reads yes or no. `true` and `false` are the standard's; `1`, `0`, `yes`, `no` in any case, and the two in another case are
/// accepted.
#[inline]
pub fn boolean(raw: &[u8]) -> Lexical<bool> {
    match raw {
        b"true" => Lexical::clean(true),
        b"false" => Lexical::clean(false),
        _ => unusual_boolean(raw),
    }
}

#[cold]
fn unusual_boolean(raw: &[u8]) -> Lexical<bool> {
    let (text, space) = trimmed(raw);
    let quirk = match text {
        b"" => return Lexical::none(Quirk::Empty),
        b"true" | b"false" => space,
        _ => Some(Quirk::OtherBoolean),
    };
    let is_one_of =
        |words: [&str; 3]| words.iter().any(|w| text.eq_ignore_ascii_case(w.as_bytes()));
    let value = if is_one_of(["true", "1", "yes"]) {
        true
    } else if is_one_of(["false", "0", "no"]) {
        false
    } else {
        return Lexical::none(Quirk::NotABoolean);
    };
    Lexical { value: Some(value), quirk }
}

/// A speed limit as written. (`t_maxSpeed`)
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speed {
    /// A number, in the unit that stands beside it.
    Limit(f64),
    /// `no limit`
    NoLimit,
    /// `undefined`
    Undefined,
}

/// Reads a speed limit: a number, `no limit` or `undefined`. The words are accepted in any case, and with `_`, `-` or nothing
/// for the space.
#[inline]
pub fn speed(raw: &[u8]) -> Lexical<Speed> {
    match fast_float2::parse(raw) {
        Ok(value) if f64::is_finite(value) => Lexical::clean(Speed::Limit(value)),
        _ => unusual_speed(raw),
    }
}

#[cold]
fn unusual_speed(raw: &[u8]) -> Lexical<Speed> {
    let (text, space) = trimmed(raw);
    let exact = match text {
        b"no limit" => Some(Speed::NoLimit),
        b"undefined" => Some(Speed::Undefined),
        _ => None,
    };
    if let Some(value) = exact {
        return Lexical { value: Some(value), quirk: space };
    }
    let letters = text.iter().filter(|byte| !b" _-".contains(byte)).map(u8::to_ascii_lowercase);
    match letters.collect::<Vec<_>>().as_slice() {
        b"nolimit" => Lexical::some(Speed::NoLimit, Quirk::OtherCase),
        b"undefined" => Lexical::some(Speed::Undefined, Quirk::OtherCase),
        _ => double(raw).map(Speed::Limit),
    }
}
