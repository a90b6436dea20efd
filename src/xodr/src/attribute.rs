//! Values with their places.

use crate::finding::Span;
use crate::schema::WordList;
pub use crate::values::Speed as SpeedLimit;
use std::num::NonZeroU32;

/// The value of an attribute and where it stands. An optional one costs no more than a plain one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attribute<T> {
    /// What is written.
    pub value: T,
    /// Bytes from the start of the element's tag to the value; never 0, for the tag has a name before it.
    offset: NonZeroU32,
    len: u32,
}

impl<T> Attribute<T> {
    pub(crate) fn new(value: T, offset: usize, len: usize) -> Self {
        let clamped = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        let offset = NonZeroU32::new(clamped(offset)).unwrap_or(NonZeroU32::MIN);
        Self { value, offset, len: clamped(len) }
    }

    /// Where the value stands, without its quotes. `element` is the span of the element that has it.
    pub fn span(&self, element: Span) -> Span {
        Span { start: element.start + u64::from(self.offset.get()), len: self.len }
    }
}

/// Short way to what an optional attribute says.
///
/// ```
/// use mapd_xodr::{Road, Text, Value};
/// assert_eq!(Road::default().length.value(), None);
/// assert_eq!(Road::default().id.text(), "");
/// ```
pub trait Value {
    /// The attribute's type.
    type Value;

    /// What is written; none where the attribute is absent or cannot be read.
    fn value(&self) -> Option<Self::Value>;
}

impl<T: Copy> Value for Option<Attribute<T>> {
    type Value = T;

    #[inline]
    fn value(&self) -> Option<T> {
        self.as_ref().map(|attribute| attribute.value)
    }
}

/// Short way to the text of an optional attribute.
pub trait Text {
    /// What is written; empty where the attribute is absent or empty.
    fn text(&self) -> &str;
}

impl Text for Option<Attribute<Box<str>>> {
    fn text(&self) -> &str {
        self.as_ref().map_or("", |attribute| &attribute.value)
    }
}

/// A place along a road.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PositionOrEnd {
    /// Distance along the reference line `[m]`.
    At(f64),
    /// `start`, in examples also `begin`.
    Start,
    /// `end`.
    End,
}

/// Words that stand for values.
pub(crate) trait Enumeration: Sized {
    /// The words as the schema has them.
    fn list() -> &'static WordList;
    /// The value of the word of a rank.
    fn of_rank(rank: usize) -> Self;
    /// A word that the standard does not list.
    const UNLISTED: Self;
}

macro_rules! enumeration {
    ($(#[$doc:meta])* $name:ident: $list:ident {
        $($variant:ident = $text:literal,)*
    } words { $($word:ident)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum $name {
            $(#[doc = concat!("`", $text, "`")] $variant,)*
            /// A word that the standard does not list; the finding about it has the word.
            Unlisted,
        }

        impl $name {
            /// All words that the standard lists, in the order of its schema.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// The word; empty for `Unlisted`.
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $text,)* Self::Unlisted => "" }
            }
        }

        impl $crate::written::Shown for $name {
            fn shown(&self) -> String {
                self.name().to_owned()
            }
        }

        impl $crate::attribute::Enumeration for $name {
            fn list() -> &'static $crate::schema::WordList { &$list }
            fn of_rank(rank: usize) -> Self {
                const BY_RANK: &[$name] = &[$($name::$word),*];
                BY_RANK.get(rank).copied().unwrap_or(Self::Unlisted)
            }
            const UNLISTED: Self = Self::Unlisted;
        }
    };
}
pub(crate) use enumeration;
