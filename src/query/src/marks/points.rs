//! Points along road marks, to compare with what sensors see of the paint.

use super::MarkFilter;
use super::search::{each_course, shift};
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::index;
use crate::map::Map;
use crate::nearest::round_up;
use crate::region::Region;
use glam::{DVec2, DVec3};
use mapd_archive::{RoadMarkColor, RoadMarkKind};

/// Points are no nearer to each other than this `[m]`, whatever is asked for.
const LEAST_SPACING: f64 = 0.01;

/// A painted place of a road mark.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MarkPoint {
    /// Where: in the middle of the line, on the plane h = 0, inertial `[m]`.
    pub position: DVec3,
    /// The lane on whose outer border the mark lies; lane 0 for marks of the centre.
    pub lane: LaneId,
    /// Along the road `[m]`.
    pub s: f64,
    /// Kind.
    pub kind: RoadMarkKind,
    /// Colour: the line's own, or the mark's.
    pub color: RoadMarkColor,
    /// Width of the line `[m]`.
    pub width: f64,
}

impl Map<'_> {
    /// Points along the lines of road marks in a rectangle, at every multiple of `spacing` `[m]` of their road's s: the same ones whatever rectangle they are
    /// asked for by. Gaps of broken lines have none; where the file does not say which places are gaps, all have. Kinds and lane types are the
    /// filter's. Points are in no particular order. `out` is emptied first; it grows only if its capacity is too small. A spacing below 1 cm counts as 1 cm.
    ///
    /// Errors: numbers that are not finite.
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
        index::visit_box(self.tables(), from, to, |leaf| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let away = middle - DVec2::new(f64::from(leaf.x()), f64::from(leaf.y()));
            let lower = index::lower_bounds(leaf, away.x as f32, away.y as f32, None);
            for k in (0..lower.len()).filter(|k| lower[*k] <= reach) {
                each_course(*self, lanes[k], segments[k], filter, |course| {
                    course.points(spacing, |s, local| {
                        let flat = local.truncate();
                        if flat.cmpge(low).all() && flat.cmple(high).all() {
                            let position = local + self.origin().extend(0.0);
                            out.push(course.mark_point(s, position));
                        }
                    });
                });
            }
        });
        Ok(())
    }
}
