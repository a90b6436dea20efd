//! Points along road marks and painted objects, to compare with what sensors see of the paint.

use super::MarkFilter;
use super::painted::{self, Asked};
use super::search::{Markless, each_course, shift};
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::index;
use crate::map::Map;
use crate::nearest::round_up;
use crate::objects::PlacementId;
use crate::region::Region;
use glam::{DVec2, DVec3};
use mapd_archive::{RoadMarkColor, RoadMarkKind};

/// Points are no nearer to each other than this `[m]`, whatever is asked for.
const LEAST_SPACING: f64 = 0.01;

/// What a painted place belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum MarkSource {
    /// A road mark: the lane on whose outer border it lies; lane 0 for marks of the centre.
    Lane(LaneId),
    /// A line along an object where it stands: one of its markings, or its border of paint or kerb (OpenDRIVE 1.8.1, 13.7 and 13.9).
    Line(PlacementId),
    /// The outline of an object that is painted as a whole, such as a stop line, a crosswalk or an arrow, and for which the file gives no lines.
    Outline(PlacementId),
}

/// A painted place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MarkPoint {
    /// Where, inertial `[m]`: in the middle of the line; of a road mark on the plane h = 0.
    pub position: DVec3,
    /// What it belongs to.
    pub source: MarkSource,
    /// Along the road `[m]`; of an object that of its origin.
    pub s: f64,
    /// Kind; of an object `broken` or `solid`, or `curb`.
    pub kind: RoadMarkKind,
    /// Colour: the line's own, or the mark's; of an object as its marking says.
    pub color: RoadMarkColor,
    /// Width of the line `[m]`; 0 of an outline, and where an object's line gives none.
    pub width: f64,
}

impl Map<'_> {
    /// Points along all paint and kerbs in a rectangle, the same ones whatever rectangle they are asked for by. Gaps of broken lines have none; where the file does not say
    /// which places are gaps, all have. They are in no particular order. `out` is emptied first; it grows only if its capacity is too small. A
    /// spacing below 1 cm counts as 1 cm.
    ///
    /// - Road marks have a point at every multiple of `spacing` `[m]` of their road's s. Kinds and lane types are the filter's.
    /// - Objects, unless the filter leaves them out, have points along their markings and along borders of the types `paint` and `curb`, at
    ///   multiples of the spacing from where the first stroke begins. Painted objects without such lines have them along their outlines;
    ///   stop lines also around their boxes. Lines longer than 10 km are no paint. Signals have none: the file does not say which way they extend.
    ///
    /// Errors: numbers that are not finite; a spacing that gives more than a million points between two stored points of a lane.
    pub fn mark_points(
        &self,
        region: Region,
        spacing: f64,
        filter: &MarkFilter,
        out: &mut Vec<MarkPoint>,
    ) -> Result<(), QueryError> {
        out.clear();
        region.check()?;
        if !spacing.is_finite() {
            return Err(QueryError::NotFinite);
        }
        let spacing = spacing.max(LEAST_SPACING);
        let [low, high] = region.local(self.origin());
        // Sway and offsets of lines lead out of their lane.
        let shift = shift(*self);
        let (from, to) = (low - shift, high + shift);
        let (middle, reach) = (0.5 * (from + to), round_up(0.5 * (to - from).length()));
        let (mut markless, mut result) = (Markless::NONE, Ok(()));
        index::visit_box(self.tables(), from, to, |leaf| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let away = middle - DVec2::new(f64::from(leaf.x()), f64::from(leaf.y()));
            let lower = index::lower_bounds(leaf, away.x as f32, away.y as f32, None);
            for k in (0..lower.len()).filter(|k| lower[*k] <= reach) {
                each_course(*self, lanes[k], segments[k], filter, &mut markless, |course| {
                    if result.is_err() {
                        return;
                    }
                    result = course.points(spacing, |s, local| {
                        let flat = local.truncate();
                        if flat.cmpge(low).all() && flat.cmple(high).all() {
                            let position = local + self.origin().extend(0.0);
                            out.push(course.mark_point(s, position));
                        }
                    });
                });
            }
        });
        result?;
        painted::each_point(*self, &Asked { region, spacing, filter }, &mut |point| {
            out.push(point)
        });
        Ok(())
    }
}
