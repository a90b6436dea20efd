//! Cubic records and coefficients of geometries, each sequence of them once.
//!
//! Most lanes of a section are as wide as their neighbours, and most roads are as flat. Most arcs of a map have one of few
//! curvatures, and its crossings few shapes. Stored once, they take less room, and few of them are waited for.

use bytemuck::NoUninit;
use mapd_archive::{ByHash, KeyedHash, Range, RowMapping};

/// Where sequences of the rows of one table lie, by a hash of their bytes.
#[derive(Default)]
pub(crate) struct Interned {
    known: ByHash<Range>,
    /// Of a part of a map: all sequences in the order in which they lie; with their hash, unless they lie for themselves.
    sequences: Option<Vec<(Range, Option<u64>)>>,
}

impl Interned {
    /// Of a part of a map, to be appended to the whole.
    pub(super) fn of_part() -> Self {
        Self { known: ByHash::default(), sequences: Some(Vec::new()) }
    }

    /// Takes the rows from `before` on; where the same ones are there already, those stand for them.
    pub(crate) fn add<T: NoUninit>(&mut self, rows: &mut Vec<T>, before: usize) -> Range {
        let Some(new) = rows.get(before..) else { return Range::default() };
        // Different sequences with one hash, written on purpose, make the archive larger, no more.
        let hash = KeyedHash::fixed().of(bytemuck::cast_slice(new));
        self.add_hashed(rows, before, hash)
    }

    fn add_hashed<T: NoUninit>(&mut self, rows: &mut Vec<T>, before: usize, hash: u64) -> Range {
        let own = super::between(before, rows.len());
        let bytes = |range: Range| bytemuck::cast_slice::<_, u8>(range.of(rows));
        let known = *self.known.entry(hash).or_insert(own);
        // Of two sequences with one hash the later one lies for itself.
        if known == own || bytes(known) != bytes(own) {
            // The empty sequence takes no room, so that the same one may come again at once.
            let is_new =
                |entries: &Vec<(Range, Option<u64>)>| entries.last() != Some(&(own, Some(hash)));
            if let Some(sequences) = self.sequences.as_mut().filter(|entries| is_new(entries)) {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Coefficients were kept for each geometry until all was read. Sequences of two parts become those of the whole, each
    /// where it would lie if there were no parts, and once.
    #[test]
    fn appended_sequences_are_those_of_one_table() {
        const UNUSED: f64 = -1.0;
        let shapes: [&[f64]; 7] = [&[], &[0.5], &[1.0, 2.0], &[0.5], &[2.0, 1.0], &[1.0, 2.0], &[]];
        let add = |interned: &mut Interned, rows: &mut Vec<f64>, shapes: &[&[f64]]| {
            let add = |shape: &&[f64]| {
                let before = rows.len();
                rows.extend_from_slice(shape);
                interned.add(rows, before)
            };
            shapes.iter().map(add).collect::<Vec<Range>>()
        };
        let (mut whole, mut expected) = (Interned::default(), Vec::new());
        let places = add(&mut whole, &mut expected, &shapes);
        assert_eq!(expected, [0.5, 1.0, 2.0, 2.0, 1.0]);
        for cut in 0..=shapes.len() {
            let (mut appended, mut rows, mut found) = (Interned::default(), Vec::new(), Vec::new());
            for shapes in [&shapes[..cut], &shapes[cut..]] {
                let (mut part, mut own) = (Interned::of_part(), vec![UNUSED]);
                let ranges = add(&mut part, &mut own, shapes);
                let moves = appended.append(&mut rows, (&part, &own));
                found.extend(ranges.into_iter().map(|range| moves.range(range)));
            }
            assert_eq!((&rows, &found), (&expected, &places), "cut at {cut}");
        }
    }
}
