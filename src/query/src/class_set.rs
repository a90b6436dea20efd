//! Sets of classes of the vocabulary.

use mapd_archive::Class;

/// Bits of a word.
const WORD: usize = 64;
/// The last bit stands for classes that are not known; codes of the others end below it.
const LAST: usize = 255;

/// A set of classes of signals and objects (docs/ontology.md).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ClassSet([u64; 4]);

impl ClassSet {
    /// Every class, unknown ones too.
    pub const ALL: Self = Self([u64::MAX; 4]);
    /// No class.
    pub const NONE: Self = Self([0; 4]);
    /// What localisers find again: things that are fixed, seen from the road, and have a place of their own, as
    /// `schemas/ontology/classes.toml` says of each class.
    pub const LANDMARKS: Self = {
        let (mut set, mut i) = (Self::NONE, 0);
        while i < Class::ALL.len() {
            if Class::ALL[i].is_landmark() {
                set = set.with(Class::ALL[i]);
            }
            i += 1;
        }
        set
    };

    /// The set with one more class.
    #[must_use]
    pub const fn with(mut self, class: Class) -> Self {
        let bit = Self::bit(class);
        self.0[bit / WORD] |= 1 << (bit % WORD);
        self
    }

    /// Whether a class is in the set.
    #[inline]
    pub const fn contains(self, class: Class) -> bool {
        let bit = Self::bit(class);
        self.0[bit / WORD] >> (bit % WORD) & 1 == 1
    }

    /// The set as numbers, the lowest bits first: the bit of a class is that of its code, the highest one stands for unknown classes.
    pub const fn words(self) -> [u64; 4] {
        self.0
    }

    /// The set of [`Self::words`].
    pub const fn from_words(words: [u64; 4]) -> Self {
        Self(words)
    }

    const fn bit(class: Class) -> usize {
        let code = class.code() as usize;
        if code < LAST { code } else { LAST }
    }
}
