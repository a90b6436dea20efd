//! Changes of lane: a jump at their place, or a curve over a length.

use super::{Path, Span};
use crate::lane::Lane;
use crate::lane_edges::EdgeSlopes;
use crate::profile::{At, Slope};

/// Spans that a curve is cut into: S grows evenly enough on each.
pub(super) const PARTS: f64 = 16.0;
/// Share of a part that is rounding.
const ROUNDING: f64 = 1e-6;

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
    /// Over a length of the road's s `[m]`, positive, from the first place where the change is allowed, for each lane that is changed to: the line lies
    /// beside the new lane's centre by the distance of both centre lines times 1 − 10u³ + 15u⁴ − 6u⁵, u from 0 to 1 along the length, so that heading
    /// and curvature are continuous. Where the change has to be done on less, it stays a jump, and its joint is `short`.
    Lateral(f64),
}

/// A change of lane over a length.
#[derive(Clone, Copy)]
pub(super) struct Shift {
    /// The lane that is left.
    pub(super) from: u32,
    /// s at its beginning and end.
    pub(super) s: [f64; 2],
}

impl Shift {
    /// How far beside a lane's centre the line runs, to the left of the reference line.
    pub(super) fn at(&self, lane: &Lane<'_>, at: At, own: &EdgeSlopes) -> Slope {
        let Some(from) = Lane::new(lane.map, self.from) else { return Slope::default() };
        // Spans are cut where records of the own lane begin; those of the other one may begin anywhere.
        let other = from.edge_slopes(from.at(at.s));
        let apart =
            0.5 * (other.inner.value + other.outer.value - own.inner.value - own.outer.value);
        let growth = 0.5
            * (other.inner.derivative + other.outer.derivative
                - own.inner.derivative
                - own.outer.derivative);
        let length = self.s[1] - self.s[0];
        let u = mapd_geometry::clamp((at.s - self.s[0]) / length, 0.0, 1.0);
        let share = 1.0 - u * u * u * (10.0 - u * (15.0 - 6.0 * u));
        let slope = -30.0 * u * u * (1.0 - u) * (1.0 - u) / length;
        Slope { value: apart * share, derivative: growth * share + apart * slope }
    }

    /// The part of a stretch of s, in driving direction, up to where the curve is cut next or ends; all of it where there is no curve.
    pub(super) fn cut(&self, [from, to]: [f64; 2]) -> f64 {
        let part = (self.s[1] - self.s[0]) / PARTS;
        // What is left of a part by rounding alone is none.
        let gone = ((from - self.s[0]) / part + ROUNDING).floor();
        if gone >= PARTS {
            return to;
        }
        let end = if gone + 1.0 >= PARTS { self.s[1] } else { self.s[0] + part * (gone + 1.0) };
        if (to - from).abs() <= (end - from).abs() { to } else { end }
    }
}

impl<'b> Path<'_, 'b> {
    /// The change of lane that a span is part of.
    pub(super) fn shift(&self, span: &Span) -> Option<&'b Shift> {
        self.buffer.shifts.get(span.shift as usize)
    }
}
