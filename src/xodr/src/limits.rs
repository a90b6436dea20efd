//! Bounds on what a document may ask for.

/// Deepest nesting that any OpenDRIVE document needs is about 12.
const DEPTH: usize = 64;
/// A start tag of OpenDRIVE has some hundred bytes.
const TAG_BYTES: usize = 1 << 20;
/// A geoReference has some thousand bytes.
const TEXT_BYTES: usize = 1 << 20;

/// Bounds on nesting and sizes; beyond them the document is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Nested elements. Default 64.
    pub depth: usize,
    /// Bytes of one start tag with its attributes. Default 1 MiB.
    pub tag_bytes: usize,
    /// Bytes of one stretch of text, comment or CDATA. Default 1 MiB.
    pub text_bytes: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { depth: DEPTH, tag_bytes: TAG_BYTES, text_bytes: TEXT_BYTES }
    }
}
