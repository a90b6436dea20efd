//! Bounds on what a document may ask for.

use crate::source::SourceLimits;

/// Deepest nesting that any OpenDRIVE document needs is about 12.
const DEPTH: usize = 64;
/// A start tag of OpenDRIVE has some hundred bytes.
const TAG_BYTES: usize = 1 << 20;
/// A geoReference has some thousand bytes.
const TEXT_BYTES: usize = 1 << 20;
/// Attributes of one tag; the standard's largest element has 24.
const ATTRIBUTES: usize = 1024;
/// User data of one element, such as a vector graphic.
const EXTENSION_BYTES: usize = 1 << 20;
/// The longest roads known have 2 MB of text and 16,000 elements, which count as 6 MB.
const ITEM_BYTES: usize = 64 << 20;
/// Bytes that an element counts beyond its text: about what the largest one takes as a value.
pub(crate) const ELEMENT_BYTES: usize = 256;
/// Findings of one kind about one type of element that are kept. The first dozen show what is wrong.
const FINDINGS_OF_A_KIND: u32 = 100;

/// Bounds on nesting, sizes and counts; beyond them the document is refused, or a part of it is not kept, as each says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Nested elements; deeper documents are refused. Default 64.
    pub depth: usize,
    /// Bytes of one tag with its attributes; documents with longer ones are refused. Default 1 MiB.
    pub tag_bytes: usize,
    /// Bytes of one stretch of text, comment or CDATA; documents with longer ones are refused. Default 1 MiB.
    pub text_bytes: usize,
    /// Attributes of one element; documents with more are refused. Default 1,024.
    pub attributes: usize,
    /// Bytes of an element beyond the standard's own that is kept as text; of larger ones only the place is kept.
    /// Default 1 MiB.
    pub extension_bytes: usize,
    /// Bytes of one top-level element: its tags and texts, and 256 for each element. Documents with larger ones are
    /// refused. As many are kept of what stands in the root beyond the standard's own elements. Default 64 MiB.
    pub item_bytes: usize,
    /// Findings of one kind about one type of element that are kept; more are counted. Default 100.
    pub findings_of_a_kind: u32,
    /// Whether the place of each finding that is only counted is kept, for callers to whom any of them matters. Default: only of those that say of an
    /// attribute that its value is not there.
    pub places_of_all: bool,
    /// Bounds on the input: its size, compression, includes.
    pub source: SourceLimits,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            depth: DEPTH,
            tag_bytes: TAG_BYTES,
            text_bytes: TEXT_BYTES,
            attributes: ATTRIBUTES,
            extension_bytes: EXTENSION_BYTES,
            item_bytes: ITEM_BYTES,
            findings_of_a_kind: FINDINGS_OF_A_KIND,
            places_of_all: false,
            source: SourceLimits::default(),
        }
    }
}
