//! Cubic records, each sequence of them once.
//!
//! Most lanes of a section are as wide as their neighbours, and most roads are as flat.

use mapd_archive::{CubicRow, Range, RowMapping};
use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};

/// Where sequences of records lie, by a hash of their bytes.
#[derive(Default)]
pub(crate) struct Interned {
    known: HashMap<u64, Range>,
    /// Of a part of a map: all sequences in the order in which they lie; with their hash, unless they lie for themselves.
    sequences: Option<Vec<(Range, Option<u64>)>>,
}

impl Interned {
    /// Of a part of a map, to be appended to the whole.
    pub(super) fn of_part() -> Self {
        Self { known: HashMap::new(), sequences: Some(Vec::new()) }
    }

    /// Takes the records from `before` on; where the same ones are there already, those stand for them.
    pub(crate) fn add(&mut self, cubics: &mut Vec<CubicRow>, before: usize) -> Range {
        let Some(new) = cubics.get(before..) else { return Range::default() };
        let mut hasher = DefaultHasher::new();
        bytemuck::cast_slice::<_, u8>(new).hash(&mut hasher);
        self.add_hashed(cubics, before, hasher.finish())
    }

    fn add_hashed(&mut self, cubics: &mut Vec<CubicRow>, before: usize, hash: u64) -> Range {
        let own = super::between(before, cubics.len());
        let bytes = |range: Range| bytemuck::cast_slice::<_, u8>(range.of(cubics));
        let known = *self.known.entry(hash).or_insert(own);
        // Of two sequences with one hash the later one lies for itself.
        if known == own || bytes(known) != bytes(own) {
            if let Some(sequences) = &mut self.sequences {
                sequences.push((own, Some(hash)));
            }
            return own;
        }
        cubics.truncate(before);
        known
    }

    /// Takes the records from `before` on as they are, whatever is there already.
    pub(crate) fn add_apart(&mut self, cubics: &[CubicRow], before: usize) -> Range {
        let own = super::between(before, cubics.len());
        if let Some(sequences) = &mut self.sequences {
            sequences.push((own, None));
        }
        own
    }

    /// Adds the records of a part in its order; where each of its ranges comes to lie.
    pub(super) fn append(
        &mut self,
        cubics: &mut Vec<CubicRow>,
        (part, its_cubics): (&Self, &[CubicRow]),
    ) -> RowMapping {
        let sequences = part.sequences.iter().flatten();
        let places = sequences.map(|(range, hash)| {
            let before = cubics.len();
            cubics.extend_from_slice(range.of(its_cubics));
            let place = match hash {
                Some(hash) => self.add_hashed(cubics, before, *hash),
                None => self.add_apart(cubics, before),
            };
            (*range, place)
        });
        let mut places: Vec<_> = places.collect();
        places.sort_by_key(|(range, _)| (range.first, range.count));
        RowMapping::Ranges(places)
    }
}
