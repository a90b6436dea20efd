//! Changes of lane: a jump at their place, or a curve over a length.

use super::{Path, Span};
use crate::lane::Lane;
use crate::lane_edges::EdgeSlopes;
use crate::map::Map;
use crate::profile::At;

/// Spans that a curve is cut into: S grows evenly enough on each.
const PARTS: f64 = 16.0;
/// Parts that a stretch beside a curve is cut into at most, however short the curve is.
pub(super) const MOST_PARTS: u32 = 4096;

/// How the driven line changes lanes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum LaneChange {
    /// At one place: S goes on, and the line jumps to the side.
    #[default]
    Jump,
    /// Over a length of S `[m]`, positive, for each lane that is changed to: the line lies beside the new lane's centre by the distance of both centre lines
    /// times 1 − 10u³ + 15u⁴ − 6u⁵, u from 0 to 1 along the length, so that the curve adds nothing to heading and curvature where it begins and ends. It begins
    /// where the route changes ([`PathOptions::change_delay`](super::PathOptions) says otherwise) and may go on over lanes that follow, as long as the change is allowed
    /// there. It is at least twice as long as it leads to the side. A change that comes before the last one is done waits for it. Over several lanes at one place
    /// the length may shrink to that of one change in all. Where less is allowed, the change stays a jump, and its joint is `short`
    /// ([`PathOptions::shortest_change`](super::PathOptions) lets it be shorter).
    Lateral(f64),
}

/// A curve from one lane to the next, where both lie beside a piece.
#[derive(Clone, Copy)]
pub(super) struct Shift {
    /// Rows of the lane that is left and of the one that is changed to.
    pub(super) from: u32,
    pub(super) to: u32,
    /// Whether that lies to the left, as driven.
    pub(super) left: bool,
    /// The piece.
    pub(super) piece: u32,
    /// S at its beginning and end: before, the line runs in the lane that is left, behind in the other one.
    pub(super) along: [f64; 2],
}

/// A curve at a place of it.
#[derive(Clone, Copy)]
pub(super) struct ShiftAt {
    pub(super) shift: Shift,
    /// S of the place.
    pub(super) along: f64,
}

/// How far a line lies to the left of a lane's centre, as seen along the reference line, and by what that changes.
#[derive(Clone, Copy, Default)]
pub(super) struct Displacement {
    /// `[m]`
    pub(super) value: f64,
    /// Metres per metre of s, as the lanes have it.
    pub(super) growth: f64,
    /// Metres per metre of S, as the curve has it.
    pub(super) per_along: f64,
}

impl ShiftAt {
    /// How the line lies beside a lane, whose edges are known.
    pub(super) fn beside(&self, lane: &Lane<'_>, at: At, own: &EdgeSlopes) -> Displacement {
        let Self { shift, along } = self;
        let center = |row: u32| {
            if row == lane.row_number() {
                return Some(own.center());
            }
            // Spans are cut where records of the own lane begin; those of the other one may begin anywhere.
            let other = Lane::new(lane.map, row)?;
            Some(other.edge_slopes(other.at(at.s)).center())
        };
        let (Some(from), Some(to)) = (center(shift.from), center(shift.to)) else {
            return Displacement::default();
        };
        let own = own.center();
        let [begin, end] = shift.along;
        let u = mapd_geometry::clamp((along - begin) / (end - begin), 0.0, 1.0);
        let share = 1.0 - u * u * u * (10.0 - u * (15.0 - 6.0 * u));
        let slope = -30.0 * u * u * (1.0 - u) * (1.0 - u) / (end - begin);
        let apart = from.value - to.value;
        Displacement {
            value: to.value - own.value + apart * share,
            growth: to.derivative - own.derivative + (from.derivative - to.derivative) * share,
            per_along: apart * slope,
        }
    }
}

impl Shift {
    /// The part of a stretch of s, in driving direction, that is short beside the curve, but no shorter than `least` `[m]`.
    pub(super) fn cut(&self, [from, to]: [f64; 2], least: f64) -> f64 {
        let part = ((self.along[1] - self.along[0]) / PARTS).max(least);
        if (to - from).abs() <= part { to } else { from + part.copysign(to - from) }
    }
}

/// How far apart the centres of two lanes of a section lie at s `[m]`.
pub(super) fn apart(map: Map<'_>, lanes: [u32; 2], s: f64) -> f64 {
    let center = |row: u32| Lane::new(map, row).map(|lane| lane.edges_at(s).center());
    let [from, to] = lanes.map(center);
    from.zip(to).map_or(f64::INFINITY, |(from, to)| (from - to).abs())
}

impl Path<'_, '_> {
    /// The curve of a change of lane that a span is part of, at S on it.
    pub(super) fn shift_at(&self, span: &Span, along: f64) -> Option<ShiftAt> {
        shift_at(&self.buffer.shifts, span.shift, along)
    }
}

/// The curve that is not done at S, of those of a piece from a number on.
pub(super) fn shift_at(shifts: &[Shift], number: u32, along: f64) -> Option<ShiftAt> {
    let first = shifts.get(number as usize)?;
    let own = shifts.get(number as usize..)?.iter().take_while(|own| own.piece == first.piece);
    let shift = own.clone().find(|own| along < own.along[1]).or(own.last())?;
    Some(ShiftAt { shift: *shift, along })
}
