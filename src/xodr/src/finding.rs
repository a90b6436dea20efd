//! What is wrong, and where.

/// A byte range of the decoded input.
///
/// Packed to 12 bytes: millions are kept next to the data that they locate. A field cannot be borrowed, only read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[repr(C, packed(4))]
pub struct Span {
    /// First byte, from the start of the input.
    pub start: u64,
    /// Number of bytes.
    pub len: u32,
}

/// How bad a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Worth knowing.
    Info,
    /// Read on as described.
    Warning,
    /// The schema forbids it, or nothing can be built from it. Who judges the map decides what remains an error: such takes its part out of the map.
    Error,
}

/// Something that the document has wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Id of the rule that found it.
    pub rule: &'static str,
    /// How bad it is.
    pub severity: Severity,
    /// Where it stands.
    pub span: Span,
    /// Path of elements, such as `OpenDRIVE/road[@id=12]/planView/geometry`.
    pub path: String,
    /// Name of the attribute or child that it is about; empty where it is about the element.
    pub subject: Box<str>,
    /// What was expected and what was found.
    pub message: String,
    /// The way out; may be empty.
    pub hint: String,
    /// How many findings it stands for: one, or as many as were only counted; none if another has counted it.
    pub count: u32,
}

/// Bytes of a message or a path that are kept.
const SHOWN_BYTES: usize = 1024;
/// Bytes of an id in a path.
pub(crate) const KEY_BYTES: usize = 64;

/// The beginning of a text, of at most so many bytes.
pub(crate) fn shorten(text: &str, bytes: usize) -> &str {
    let end = (0..=bytes.min(text.len())).rev().find(|end| text.is_char_boundary(*end));
    text.get(..end.unwrap_or_default()).unwrap_or(text)
}

/// A message or a path as findings keep it: of at most 1,024 bytes, with `…` where it goes on.
pub fn shorten_message(text: String) -> String {
    match shorten(&text, SHOWN_BYTES) {
        short if short.len() < text.len() => format!("{short}…"),
        _ => text,
    }
}

/// An id as paths of findings have it: its first 64 bytes.
pub fn shorten_id(id: &str) -> &str {
    shorten(id, KEY_BYTES)
}
