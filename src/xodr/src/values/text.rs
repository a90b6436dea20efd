//! Text of attributes and elements as it is meant: references resolved.

use crate::source::is_legal;
use std::borrow::Cow;

/// The text of an attribute's value: references resolved, each tab and line break a space. (XML 1.0, 3.3.3) References that
/// mean nothing stay as written; [`well_formed`](crate::well_formed) finds them.
pub fn text(raw: &str) -> Cow<'_, str> {
    // Most have a few bytes: all are looked at, many at a time, and no call is made.
    let is_plain = |byte: u8| !matches!(byte, b'&' | b'\r' | b'\n' | b'\t');
    if raw.bytes().fold(true, |all, byte| all & is_plain(byte)) {
        return Cow::Borrowed(raw);
    }
    let mut out = String::with_capacity(raw.len());
    resolve_into(&mut out, raw, push_spaced);
    Cow::Owned(out)
}

/// Adds the text of an element's content: references resolved, each line break a line feed. (XML 1.0, 2.11)
pub(crate) fn push_resolved(out: &mut String, raw: &str) {
    resolve_into(out, raw, push_lines);
}

/// Adds text with its references resolved. What lies between them is added by `push`.
fn resolve_into(out: &mut String, raw: &str, push: fn(&mut String, &str)) {
    let mut rest = raw;
    while let Some(at) = memchr::memchr(b'&', rest.as_bytes()) {
        push(out, &rest[..at]);
        let end = reference_end(&rest.as_bytes()[at..]).map(|end| at + end);
        match end.and_then(|end| Some((end, reference(&rest.as_bytes()[at + 1..end - 1])?))) {
            Some((end, character)) => {
                out.push(character);
                rest = &rest[end..];
            }
            None => {
                out.push('&');
                rest = &rest[at + 1..];
            }
        }
    }
    push(out, rest);
}

/// Longest reference that is looked at: `&#x` and 8 digits and `;`, or a name.
const REFERENCE: usize = 64;

/// The bytes of the reference that text begins with, `&` and `;` included.
pub(crate) fn reference_end(text: &[u8]) -> Option<usize> {
    let head = text.get(..REFERENCE).unwrap_or(text);
    let end = memchr::memchr3(b';', b'<', b' ', head)?;
    (head[end] == b';').then_some(end + 1)
}

/// The character of a reference, given without `&` and `;`: by number, or one of XML's five names.
pub(crate) fn reference(name: &[u8]) -> Option<char> {
    let number = match name {
        b"amp" => return Some('&'),
        b"lt" => return Some('<'),
        b"gt" => return Some('>'),
        b"quot" => return Some('"'),
        b"apos" => return Some('\''),
        _ => std::str::from_utf8(name.strip_prefix(b"#")?).ok()?,
    };
    let (digits, radix) = match number.strip_prefix('x') {
        Some(digits) => (digits, 16),
        None => (number, 10),
    };
    // The standard library would take a sign.
    if !digits.starts_with(|first: char| first.is_ascii_hexdigit()) {
        return None;
    }
    let character = char::from_u32(u32::from_str_radix(digits, radix).ok()?)?;
    is_legal(character).then_some(character)
}

/// Text with its references resolved; none where one means nothing, or the bytes are no text.
pub(super) fn resolve(raw: &[u8]) -> Option<String> {
    let resolved = text(std::str::from_utf8(raw).ok()?);
    // What is still there came from `&amp;` or means nothing: no number has it.
    (memchr::memchr(b'&', resolved.as_bytes()).is_none()).then(|| resolved.into_owned())
}

fn push_spaced(out: &mut String, text: &str) {
    // A line break of two bytes is one character. (XML 1.0, 2.11)
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        match character {
            '\r' if characters.peek() == Some(&'\n') => {}
            '\r' | '\n' | '\t' => out.push(' '),
            other => out.push(other),
        }
    }
}

fn push_lines(out: &mut String, text: &str) {
    let mut rest = text;
    while let Some((line, after)) = rest.split_once('\r') {
        out.push_str(line);
        out.push('\n');
        rest = after.strip_prefix('\n').unwrap_or(after);
    }
    out.push_str(rest);
}
