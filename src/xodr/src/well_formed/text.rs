//! Text, comments and instructions.

use super::fault::{Fault, Faults};
use super::name::is_name;
use super::tag::Attributes;
use crate::values::{reference, reference_end};

/// Finds what is not well-formed in text between tags. `start` is its offset in the document.
#[inline]
pub fn text(text: &[u8], start: u64, faults: &mut Faults) {
    if memchr::memchr2(b'&', b']', text).is_some() {
        references(text, start, faults);
        for at in memchr::memmem::find_iter(text, b"]]>") {
            faults.add(start + at as u64, Fault::SectionEnd);
        }
    }
}

/// Finds references that mean nothing, in text or in an attribute's value.
pub fn references(text: &[u8], start: u64, faults: &mut Faults) {
    for at in memchr::memchr_iter(b'&', text) {
        if let Some(fault) = reference_fault(&text[at..]) {
            faults.add(start + at as u64, fault);
        }
    }
}

/// What is wrong with the reference that text begins with.
fn reference_fault(text: &[u8]) -> Option<Fault> {
    let Some(end) = reference_end(text) else { return Some(Fault::Ampersand) };
    let name = &text[1..end - 1];
    if reference(name).is_some() {
        None
    } else if name.starts_with(b"#") {
        Some(Fault::CharacterReference)
    } else if is_name(name) {
        Some(Fault::Entity)
    } else {
        Some(Fault::Ampersand)
    }
}

/// Finds what is not well-formed in a comment, given between `<!--` and `-->`.
pub fn comment(content: &[u8], start: u64, faults: &mut Faults) {
    let double = memchr::memmem::find(content, b"--");
    let at = double.or_else(|| content.ends_with(b"-").then(|| content.len() - 1));
    if let Some(at) = at {
        faults.add(start + at as u64, Fault::Hyphens);
    }
}

/// Finds what is not well-formed in a processing instruction, given between `<?` and `?>`.
pub fn instruction(content: &[u8], start: u64, faults: &mut Faults) {
    let target = content.iter().position(|byte| byte.is_ascii_whitespace());
    let target = &content[..target.unwrap_or(content.len())];
    if target.eq_ignore_ascii_case(b"xml") {
        faults.add(start, Fault::ReservedTarget);
    } else if !is_name(target) {
        faults.add(start, Fault::Name);
    }
}

/// Finds what is not well-formed in an XML declaration, given between `<?` and `?>`: version, then encoding or none, then
/// standalone or none.
pub fn declaration(content: &[u8], start: u64, faults: &mut Faults) {
    let before = faults.len();
    let mut attributes = Attributes::new(content, start, faults);
    // The parts that may still come: each one only behind those before it.
    let mut allowed: &[&[u8]] = &[b"version", b"encoding", b"standalone"];
    let mut is_first = true;
    let mut is_due = true;
    while let Some(attribute) = attributes.next(faults) {
        let Some(at) = allowed.iter().position(|name| *name == attribute.name) else {
            is_due = false;
            break;
        };
        is_due &= !is_first || at == 0;
        is_first = false;
        is_due &= match attribute.name {
            b"version" => is_version(attribute.value),
            b"encoding" => is_encoding(attribute.value),
            _ => matches!(attribute.value, b"yes" | b"no"),
        };
        allowed = &allowed[at + 1..];
    }
    if (is_first || !is_due) && faults.len() == before {
        faults.add(start, Fault::Declaration);
    }
}

fn is_version(text: &[u8]) -> bool {
    text.strip_prefix(b"1.")
        .is_some_and(|minor| !minor.is_empty() && minor.iter().all(u8::is_ascii_digit))
}

fn is_encoding(text: &[u8]) -> bool {
    text.first().is_some_and(u8::is_ascii_alphabetic)
        && text.iter().all(|byte| byte.is_ascii_alphanumeric() || b"._-".contains(byte))
}
