//! A line at one distance beside a reference line, which the compiler cuts into points.

use crate::road::GeometryPiece;
use mapd_geometry::{Bends, BendsFrom};

/// Such a line, as far as one geometry reaches.
#[derive(Clone, Copy)]
pub struct Parallel<'a> {
    piece: GeometryPiece<'a>,
    /// Offset along the left normal, in plan view `[m]`.
    lateral: f64,
    is_level: bool,
}

/// Tells of the parts of a [`Parallel`] one behind the other.
pub struct ParallelFrom<'a> {
    bends: BendsFrom<'a>,
    /// Where the geometry begins `[m]`.
    s: f64,
    lateral: f64,
    is_level: bool,
}

/// How far a part of a line bends at most: its second derivative times its squared length `[m]`.
#[derive(Clone, Copy, Debug)]
pub struct MostBend {
    /// In any direction.
    pub any: f64,
    /// Across its chord: the part leaves that by an eighth of this at most.
    pub across: f64,
}

impl<'a> Parallel<'a> {
    pub(crate) fn new(piece: GeometryPiece<'a>, lateral: f64, is_level: bool) -> Self {
        Self { piece, lateral, is_level }
    }

    /// Tells of parts, the first of which begins at s. None where nothing is known of them.
    pub fn from(&self, s: f64) -> Option<ParallelFrom<'a>> {
        let Self { piece, lateral, is_level } = *self;
        let bends = piece.curve.bends_from(s - piece.s)?;
        Some(ParallelFrom { bends, s: piece.s, lateral, is_level })
    }
}

impl ParallelFrom<'_> {
    /// How far the line bends at most up to s, from where the last part ended. None where that is not known.
    pub fn up_to(&mut self, s: f64) -> Option<MostBend> {
        let bends = self.bends.up_to(s - self.s)?;
        let Bends { curvature: [low, high], change, squared_length } = bends;
        if !(low.is_finite() && high.is_finite()) {
            return None;
        }
        // By the reference line's length, the second derivative is κ·(1 − κ·t) to the left and κ'·t backwards.
        let t = self.lateral;
        let left = |curvature: f64| (curvature * (1.0 - curvature * t)).abs();
        let (at_low, at_high) = (left(low), left(high));
        let mut most_left = if at_low > at_high { at_low } else { at_high };
        // Between them it may turn round.
        if (1.0 - 2.0 * low * t) * (1.0 - 2.0 * high * t) < 0.0 {
            most_left = most_left.max(left(0.5 / t));
        }
        let back = (change * t).abs();
        let any = (most_left * most_left + back * back).sqrt();
        // A line that runs ahead all along has the direction of its chord somewhere: backwards is across that by the sine of what it turns.
        let runs_ahead = low * t < 1.0 && high * t < 1.0;
        let across = if self.is_level && runs_ahead {
            let curvature = if -low > high { -low } else { high };
            let across = most_left + back * (curvature * squared_length.sqrt());
            if across < any { across } else { any }
        } else {
            any
        };
        Some(MostBend { any: any * squared_length, across: across * squared_length })
    }
}
