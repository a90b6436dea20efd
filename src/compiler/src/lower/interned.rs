//! Cubic records, each sequence of them once.
//!
//! Most lanes of a section are as wide as their neighbours, and most roads are as flat.

use mapd_archive::{CubicRow, Range};
use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};

/// Where sequences of records lie, by a hash of their bytes.
#[derive(Default)]
pub(super) struct Interned(HashMap<u64, Range>);

impl Interned {
    /// Orders the records from `before` on by s; where the same ones are there already, those stand for them.
    pub(super) fn add(&mut self, cubics: &mut Vec<CubicRow>, before: usize) -> Range {
        let Some(new) = cubics.get_mut(before..) else { return Range::default() };
        new.sort_by(|a, b| a.s.total_cmp(&b.s));
        let own = super::between(before, cubics.len());
        let bytes = |range: Range| bytemuck::cast_slice::<_, u8>(range.of(cubics));
        let mut hasher = DefaultHasher::new();
        bytes(own).hash(&mut hasher);
        let known = *self.0.entry(hasher.finish()).or_insert(own);
        // Of two sequences with one hash the later one lies for itself.
        if known == own || bytes(known) != bytes(own) {
            return own;
        }
        cubics.truncate(before);
        known
    }
}
