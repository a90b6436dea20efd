//! Row numbers of a part of a map in the whole.

use crate::codes::NONE;
use crate::table::Range;

/// Row numbers of one table of a part in the whole.
///
/// Row 0 of a part's table is never used ([`Rows::part`](crate::Rows::part)): 0, and an empty range from 0 on, stay what
/// they are, as [`NONE`] does.
#[derive(Clone, Debug)]
pub enum RowMapping {
    /// Appended in order.
    Appended(RowShift),
    /// Each row has its number in this list. [`Rows::append`](crate::Rows::append) leaves the table alone.
    To(Vec<u32>),
    /// Ranges of them, each of the first where the second says, by first row and count; others nowhere.
    /// [`Rows::append`](crate::Rows::append) leaves the table alone.
    Ranges(Vec<(Range, Range)>),
}

/// By how much row numbers rise: see [`RowMapping::appended_to`].
#[derive(Clone, Copy, Debug)]
pub struct RowShift(u32);

impl RowMapping {
    /// Appended to a table of this many rows. Tables that exceed 32 bits are refused before anything is written.
    pub fn appended_to(rows: usize) -> Self {
        Self::Appended(RowShift((rows as u32).wrapping_sub(1)))
    }

    /// Whether the rows are appended in order.
    pub fn is_appended(&self) -> bool {
        matches!(self, Self::Appended(_))
    }

    /// The row's number in the whole.
    #[inline]
    pub fn row(&self, row: u32) -> u32 {
        if row == 0 || row == NONE {
            return row;
        }
        match self {
            Self::Appended(RowShift(by)) => row.wrapping_add(*by),
            Self::To(places) => places.get(row as usize).copied().unwrap_or(NONE),
            Self::Ranges(_) => NONE,
        }
    }

    /// The range in the whole.
    #[inline]
    pub fn range(&self, range: Range) -> Range {
        if range.first == 0 {
            return range;
        }
        match self {
            Self::Appended(RowShift(by)) => {
                Range { first: range.first.wrapping_add(*by), count: range.count }
            }
            Self::To(_) => Range::default(),
            Self::Ranges(places) => {
                let key = |range: &Range| (range.first, range.count);
                let place = places.binary_search_by_key(&key(&range), |(from, _)| key(from));
                place.ok().and_then(|at| places.get(at)).map_or_else(Range::default, |(_, to)| *to)
            }
        }
    }
}
