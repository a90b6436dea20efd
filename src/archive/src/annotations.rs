//! Annotations as they are written: as differences from the one before, each different one once.
//!
//! Tools write the same few things of every lane, some lines apart, so that a map has many annotations and few differences.

use crate::generated::annotation_rows::{
    AnnotationBlockRow, AnnotationRow, ArchivedAnnotationBlockRow, ArchivedAnnotationRow,
};
use crate::generated::rows::Rows;
use crate::generated::tables::Tables;
use crate::hashed::KeyedHash;
use crate::points::low;
use std::collections::HashMap;

/// Annotations between two places from which reading may begin.
pub(crate) const BLOCK: usize = 256;

/// An annotation: what its row says, counted from the one before.
#[derive(Clone, Copy)]
pub struct AnnotationEntry<'a> {
    /// What it is and says; its owner and line there are differences.
    pub row: &'a ArchivedAnnotationRow,
    /// Row of the owner in the table that `owner_kind` means.
    pub owner: u32,
    /// Line of the start tag, from 1.
    pub line: u32,
}

impl AnnotationEntry<'_> {
    /// The annotation with its owner and line in full, as [`Rows::set_annotations`] takes it.
    pub fn in_full(&self) -> AnnotationRow {
        let row = self.row;
        AnnotationRow {
            owner: self.owner,
            path: row.path(),
            name: row.name(),
            value: row.value(),
            text: row.text(),
            line: self.line,
            column: row.column(),
            file: row.file(),
            kind: row.kind(),
            owner_kind: row.owner_kind(),
        }
    }

    /// What annotations are ordered by.
    fn key(&self) -> (u8, u32) {
        (self.row.owner_kind(), self.owner)
    }
}

/// Annotations one after the other.
#[derive(Clone)]
pub struct AnnotationEntries<'a> {
    rows: &'a [ArchivedAnnotationRow],
    numbers: &'a [u8],
    next: usize,
    end: usize,
    /// Owner and line of the annotation before.
    owner: u32,
    line: u32,
}

/// Bits of the number of one of so many rows.
pub(crate) fn number_bits(rows: usize) -> usize {
    (usize::BITS - rows.saturating_sub(1).leading_zeros()) as usize
}

impl<'a> Iterator for AnnotationEntries<'a> {
    type Item = AnnotationEntry<'a>;

    fn next(&mut self) -> Option<AnnotationEntry<'a>> {
        if self.next >= self.end {
            return None;
        }
        let bits = number_bits(self.rows.len());
        let at = self.next.checked_mul(bits)?;
        // Rows are counted with 32 bits: a number and the bits before it in its byte are in eight bytes.
        let bytes = low(self.numbers.get(at / 8..).unwrap_or(&[]));
        let number = bytes >> (at % 8) & !u64::MAX.unbounded_shl(bits as u32);
        let row = self.rows.get(number as usize)?;
        self.next += 1;
        self.owner = self.owner.wrapping_add(row.owner());
        self.line = self.line.wrapping_add(row.line());
        Some(AnnotationEntry { row, owner: self.owner, line: self.line })
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.end.saturating_sub(self.next);
        (left, Some(left))
    }
}

impl ExactSizeIterator for AnnotationEntries<'_> {}

impl<'a> Tables<'a> {
    /// Annotations from the first one of a block on.
    fn annotations_from(&self, block: usize) -> AnnotationEntries<'a> {
        let blocks = self.annotation_blocks;
        let last = blocks.last().map_or(0, |last| usize::from(last.count()));
        let end = blocks.len().saturating_sub(1) * BLOCK + last;
        let before = blocks.get(block).map_or((0, 0), |row| (row.owner(), row.line()));
        let (next, (owner, line)) = (block * BLOCK, before);
        let (rows, numbers) = (self.annotations, self.annotation_numbers);
        AnnotationEntries { rows, numbers, next, end, owner, line }
    }

    /// All annotations, by the kinds and rows of their owners, those of one owner in file order.
    pub fn all_annotations(&self) -> AnnotationEntries<'a> {
        self.annotations_from(0)
    }

    /// Annotations of the part with a kind ([`crate::AnnotationOwner::code`]) and a row, in file order.
    pub fn annotations_of(&self, owner_kind: u8, owner: u32) -> AnnotationEntries<'a> {
        let wanted = (owner_kind, owner);
        let before = |block: &ArchivedAnnotationBlockRow| (block.owner_kind(), block.owner());
        let after = self.annotation_blocks.partition_point(|block| before(block) < wanted);
        let mut found = self.annotations_from(after.saturating_sub(1));
        let mut ahead = found.clone();
        while ahead.next().is_some_and(|entry| entry.key() < wanted) {
            found = ahead.clone();
        }
        let mut own = found.clone();
        let count = own.by_ref().take_while(|entry| entry.key() == wanted).count();
        found.end = found.next + count;
        found
    }
}

impl Rows {
    /// Writes annotations, which are ordered by the kinds and rows of their owners and have these and their lines in full.
    pub fn set_annotations(&mut self, all: &[AnnotationRow]) {
        let mut numbers = HashMap::with_hasher(KeyedHash::default());
        let (mut rows, mut order, mut blocks) = (Vec::new(), Vec::new(), Vec::new());
        let (mut owner_kind, mut owner, mut line) = (0, 0, 0);
        for (i, row) in all.iter().enumerate() {
            if i % BLOCK == 0 {
                let count = (all.len() - i).min(BLOCK) as u16;
                blocks.push(AnnotationBlockRow { owner, line, count, owner_kind, reserved: 0 });
            }
            let difference = AnnotationRow {
                owner: row.owner.wrapping_sub(owner),
                line: row.line.wrapping_sub(line),
                ..*row
            };
            (owner_kind, owner, line) = (row.owner_kind, row.owner, row.line);
            let key: [u8; size_of::<AnnotationRow>()] = bytemuck::cast(difference);
            order.push(*numbers.entry(key).or_insert_with(|| {
                rows.push(difference);
                rows.len() as u64 - 1
            }));
        }
        let bits = number_bits(rows.len());
        let mut bytes = Vec::with_capacity((order.len() * bits).div_ceil(8));
        let (mut held, mut count) = (0u64, 0);
        for number in order {
            held |= number << count;
            count += bits;
            while count >= 8 {
                bytes.push(held as u8);
                (held, count) = (held >> 8, count - 8);
            }
        }
        if count > 0 {
            bytes.push(held as u8);
        }
        self.annotations = rows.into();
        self.annotation_numbers = bytes.into();
        self.annotation_blocks = blocks.into();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Writes so many annotations of so many different kinds and reads them again: all, and those of each owner.
    #[track_caller]
    fn check(count: u32, different: u32) {
        let owner = |i: u32| (i * 7 / count.max(1), i / 3);
        let all: Vec<AnnotationRow> = (0..count)
            .map(|i| AnnotationRow {
                owner: owner(i).1,
                path: i % different,
                name: 0,
                value: 0,
                text: 0,
                line: (different - i % different) * 10,
                column: 9,
                file: 0,
                kind: 0,
                owner_kind: owner(i).0 as u8,
            })
            .collect();
        let mut rows = Rows::default();
        rows.set_annotations(&all);
        let tables = rows.as_tables();
        let read = |found: AnnotationEntries<'_>| found.map(|e| e.in_full()).collect::<Vec<_>>();
        assert_eq!(tables.all_annotations().len(), all.len());
        assert_eq!(read(tables.all_annotations()), all);
        for kind in 0..8 {
            for row in (0..=count / 3 + 1).step_by(29) {
                let is_own = |one: &&AnnotationRow| (one.owner_kind, one.owner) == (kind, row);
                let own: Vec<AnnotationRow> = all.iter().filter(is_own).copied().collect();
                let found = tables.annotations_of(kind, row);
                assert_eq!((found.len(), read(found)), (own.len(), own), "{kind} {row}");
            }
        }
    }

    #[test]
    fn annotations_come_back() {
        for count in [0, 1, 2, 255, 256, 257, 512, 1_000] {
            for different in [1, 2, 3, 50, 100_000] {
                check(count, different);
            }
        }
    }

    /// Damaged tables: some annotations or none, nothing panics.
    #[test]
    fn damaged_tables_read_something() {
        let mut rows = Rows::default();
        let row: AnnotationRow = bytemuck::Zeroable::zeroed();
        rows.set_annotations(&[row, AnnotationRow { owner: 5, ..row }]);
        rows.annotation_numbers.clear();
        assert_eq!(rows.as_tables().all_annotations().count(), 2);
        rows.annotations.clear();
        assert_eq!(rows.as_tables().all_annotations().count(), 0);
        assert_eq!(rows.as_tables().annotations_of(0, 5).count(), 0);
    }
}
