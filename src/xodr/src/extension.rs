//! What files have beyond the standard's own elements.

use crate::finding::Span;

/// Kinds of what stands beyond the standard's own elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExtensionKind {
    /// `userData`.
    UserData,
    /// `dataQuality`.
    DataQuality,
    /// `include` that was not resolved.
    Include,
    /// An element of the standard's namespace that the standard does not have in this place.
    Unknown,
    /// An element of another namespace.
    Foreign,
}

/// An element beyond the standard's own, as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extension {
    /// What it is.
    pub kind: ExtensionKind,
    /// The whole element as written, with everything inside; empty where it was larger than the limit.
    pub text: Box<str>,
    /// The start tag.
    pub span: Span,
}

/// The extensions of an element in file order; most elements have none, and pay eight bytes.
#[expect(
    clippy::box_collection,
    reason = "every element has this field, and few have an extension"
)]
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Extensions(Option<Box<Vec<Extension>>>);

impl Extensions {
    pub(crate) fn push(&mut self, extension: Extension) {
        self.0.get_or_insert_default().push(extension);
    }

    /// The extensions in file order.
    pub fn as_slice(&self) -> &[Extension] {
        self.0.as_ref().map_or(&[], |all| all.as_slice())
    }
}

impl<'a> IntoIterator for &'a Extensions {
    type Item = &'a Extension;
    type IntoIter = std::slice::Iter<'a, Extension>;

    fn into_iter(self) -> Self::IntoIter {
        self.as_slice().iter()
    }
}
