//! Reading one element: its attributes into fields, its children one after the other.

use crate::cursor::{Cursor, NextChild};
use crate::extension::Extensions;
use crate::finding::Span;
use crate::schema::ElementSchema;

/// A type of element. Implementations are generated.
pub(crate) trait Element: Default {
    /// What the standard says of it.
    fn schema() -> &'static ElementSchema;
    /// Takes the span of the start tag.
    fn begin(&mut self, span: Span);
    /// What stands inside beyond the standard's own elements.
    fn extensions(&mut self) -> &mut Extensions;
    /// Reads the cursor's attribute into the field of a slot.
    fn attribute(&mut self, _slot: usize, _cursor: &mut Cursor<'_>) {}
    /// Reads the text inside.
    fn content(&mut self, _cursor: &mut Cursor<'_>) {}
    /// Reads the child that the cursor stands on into the field of a slot.
    fn child(&mut self, _slot: usize, _cursor: &mut Cursor<'_>) {}
}

/// Reads the element whose start tag the cursor has just read, up to its end, into an empty one, in place: some are hundreds of bytes, which
/// would be copied.
pub(crate) fn read<T: Element>(value: &mut T, cursor: &mut Cursor<'_>) {
    let mut open = cursor.open(T::schema());
    value.begin(open.span);
    while let Some(slot) = cursor.next_attribute(&mut open) {
        value.attribute(slot, cursor);
    }
    cursor.finish_attributes(&mut open);
    loop {
        match cursor.next_child(&mut open) {
            NextChild::Child(slot) => value.child(slot, cursor),
            NextChild::Extension(extension) => value.extensions().push(extension),
            NextChild::End => break,
        }
    }
    if T::schema().content.is_some() {
        value.content(cursor);
    }
}
