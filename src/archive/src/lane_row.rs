//! Ranges of a lane's row, which are stored with counts of 16 bits.

use crate::generated::network_rows::{ArchivedLaneRow, LaneRow};
use crate::table::Range;

/// Records, nodes or points of one kind that a lane may have.
pub const MOST_OF_LANE: usize = u16::MAX as usize;

impl ArchivedLaneRow {
    /// Its rows of `cubics`: width `[m]` over s, or the outer border's t `[m]` where flag 4 is set.
    #[inline]
    pub fn widths(&self) -> Range {
        Range { first: self.first_width(), count: self.width_count().into() }
    }

    /// Its rows of `lane_nodes`: pieces in driving order, then, if the lane is travelled the other way too, those of the other way.
    #[inline]
    pub fn nodes(&self) -> Range {
        Range { first: self.first_node(), count: self.node_count().into() }
    }
}

impl LaneRow {
    /// As [`ArchivedLaneRow::widths`].
    pub fn widths(&self) -> Range {
        Range { first: self.first_width, count: self.width_count.into() }
    }

    /// As [`ArchivedLaneRow::nodes`].
    pub fn nodes(&self) -> Range {
        Range { first: self.first_node, count: self.node_count.into() }
    }
}
