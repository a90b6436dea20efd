//! Cubic records and numbers of geometries, each sequence of them once.
//!
//! Most lanes of a section are as wide as their neighbours, and most roads are as flat. Most arcs of a map have one of few
//! curvatures, and its crossings few shapes. Stored once, they take less room, and few of them are waited for.

use bytemuck::NoUninit;
use mapd_archive::{Range, RowMapping};
use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};

/// Where sequences of the rows of one table lie, by a hash of their bytes.
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

    /// Takes the rows from `before` on; where the same ones are there already, those stand for them.
    pub(crate) fn add<T: NoUninit>(&mut self, rows: &mut Vec<T>, before: usize) -> Range {
        let Some(new) = rows.get(before..) else { return Range::default() };
        let mut hasher = DefaultHasher::new();
        bytemuck::cast_slice::<_, u8>(new).hash(&mut hasher);
        self.add_hashed(rows, before, hasher.finish())
    }

    fn add_hashed<T: NoUninit>(&mut self, rows: &mut Vec<T>, before: usize, hash: u64) -> Range {
        let own = super::between(before, rows.len());
        let bytes = |range: Range| bytemuck::cast_slice::<_, u8>(range.of(rows));
        let known = *self.known.entry(hash).or_insert(own);
        // Of two sequences with one hash the later one lies for itself.
        if known == own || bytes(known) != bytes(own) {
            if let Some(sequences) = &mut self.sequences {
                sequences.push((own, Some(hash)));
            }
            return own;
        }
        rows.truncate(before);
        known
    }

    /// Takes the rows from `before` on as they are, whatever is there already.
    pub(crate) fn add_apart<T>(&mut self, rows: &[T], before: usize) -> Range {
        let own = super::between(before, rows.len());
        if let Some(sequences) = &mut self.sequences {
            sequences.push((own, None));
        }
        own
    }

    /// Adds the rows of a part in its order; where each of its ranges comes to lie.
    pub(super) fn append<T: NoUninit>(
        &mut self,
        rows: &mut Vec<T>,
        (part, its_rows): (&Self, &[T]),
    ) -> RowMapping {
        let sequences = part.sequences.iter().flatten();
        let places = sequences.map(|(range, hash)| {
            let before = rows.len();
            rows.extend_from_slice(range.of(its_rows));
            let place = match hash {
                Some(hash) => self.add_hashed(rows, before, *hash),
                None => self.add_apart(rows, before),
            };
            (*range, place)
        });
        let mut places: Vec<_> = places.collect();
        places.sort_by_key(|(range, _)| (range.first, range.count));
        RowMapping::Ranges(places)
    }
}
