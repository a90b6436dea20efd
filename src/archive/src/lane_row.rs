//! What 16 bits are enough for: numbers of what a lane has, and places on its section.

use crate::generated::network_rows::{ArchivedLaneRow, LaneRow};
use crate::points::exponent;
use crate::table::Range;

/// Records, nodes or points of one kind that a lane may have.
pub const MOST_OF_LANE: usize = u16::MAX as usize;

/// Step in which places on a section of this length are stored with 16 bits `[m]`: the least power of two above a 65,535th of the length.
#[inline]
pub fn section_step(length: f64) -> f64 {
    let next = exponent(length / f64::from(u16::MAX)) + 1;
    f64::from_bits(((next + 1023) as u64) << 52)
}

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

#[cfg(test)]
mod tests {
    use super::section_step;

    #[test]
    fn every_place_of_a_section_fits_16_bits() {
        for length in [0.0, 1e-9, 0.1, 63.999, 64.0, 65_535.0, 65_536.0, 1e9] {
            let step = section_step(length);
            let finest = length / f64::from(u16::MAX);
            assert!(step > finest && (step <= 2.0 * finest || length == 0.0), "{length}: {step}");
        }
    }
}
