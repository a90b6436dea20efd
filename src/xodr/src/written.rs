//! Elements whatever their type: what stands in them, one below the other.
//!
//! The implementations are generated from the table of OpenDRIVE. They name those attributes that the table says nothing
//! is built from and nothing else stores, so that code that keeps the rest forgets none.

use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// Takes an attribute by its name; the text of an element has none.
pub type Keep<'a> = &'a mut dyn FnMut(&'static str, &dyn Shown);
/// Takes a child by its tag and its number among those of one tag, from 1; 0 where there can be only one.
pub type Visit<'a> = &'a mut dyn FnMut(&'static str, u32, &dyn Written);

/// An element of any type.
pub trait Written {
    /// Name of its type.
    fn kind(&self) -> &'static str;
    /// The start tag.
    fn span(&self) -> Span;
    /// What stands inside beyond the standard's own elements.
    fn extensions(&self) -> &Extensions;
    /// Hands out the attributes of which the table of OpenDRIVE says no use, where they are written.
    fn kept(&self, _to: Keep<'_>) {}
    /// Hands out the children, tag by tag, in file order.
    fn children(&self, _visit: Visit<'_>) {}
    /// Whether neither it nor anything inside has an extension or an attribute to hand out.
    fn is_bare(&self) -> bool {
        let mut is_bare = self.extensions().as_slice().is_empty();
        self.kept(&mut |_, _| is_bare = false);
        self.children(&mut |_, _, child| is_bare = is_bare && child.is_bare());
        is_bare
    }
}

/// A value that can be written again.
pub trait Shown {
    /// The value as text: numbers in shortest form, words as the standard has them.
    fn shown(&self) -> String;
}

impl Shown for f64 {
    fn shown(&self) -> String {
        self.to_string()
    }
}

impl Shown for i32 {
    fn shown(&self) -> String {
        self.to_string()
    }
}

impl Shown for u32 {
    fn shown(&self) -> String {
        self.to_string()
    }
}

impl Shown for bool {
    fn shown(&self) -> String {
        self.to_string()
    }
}

impl Shown for Box<str> {
    fn shown(&self) -> String {
        self.to_string()
    }
}

impl Shown for PositionOrEnd {
    fn shown(&self) -> String {
        match self {
            Self::At(s) => s.shown(),
            Self::Start => "start".to_owned(),
            Self::End => "end".to_owned(),
        }
    }
}

impl Shown for SpeedLimit {
    fn shown(&self) -> String {
        match self {
            Self::Limit(speed) => speed.shown(),
            Self::NoLimit => "no limit".to_owned(),
            Self::Undefined => "undefined".to_owned(),
        }
    }
}

/// Hands out an attribute, if it is written.
#[inline]
pub(crate) fn keep<T: Shown>(name: &'static str, attribute: &Option<Attribute<T>>, to: Keep<'_>) {
    if let Some(attribute) = attribute {
        to(name, &attribute.value);
    }
}

/// Hands out a child that there can be one of.
#[inline]
#[expect(clippy::ref_option, reason = "the fields are what they are")]
pub(crate) fn child<T: Written>(tag: &'static str, child: &Option<Box<T>>, visit: Visit<'_>) {
    if let Some(child) = child {
        visit(tag, 0, &**child);
    }
}

/// Hands out children that there can be several of.
#[inline]
pub(crate) fn children<T: Written>(tag: &'static str, children: &[T], visit: Visit<'_>) {
    for (number, child) in (1..).zip(children) {
        visit(tag, number, child);
    }
}
