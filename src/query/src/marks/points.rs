//! Points along road marks, to compare with what sensors see of the paint.

use super::course::{self, Course};
use super::{MARK_SHIFT, MarkFilter};
use crate::area;
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::index;
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::round_up;
use crate::region::Region;
use glam::{DVec2, DVec3};
use mapd_archive::{NONE, RoadMarkColor, RoadMarkKind};

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
        let (from, to) = (low - MARK_SHIFT, high + MARK_SHIFT);
        let (middle, reach) = (0.5 * (from + to), round_up(0.5 * (to - from).length()));
        index::visit_box(self.tables(), from, to, |leaf| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let away = middle - DVec2::new(f64::from(leaf.x()), f64::from(leaf.y()));
            let lower = index::lower_bounds(leaf, away.x as f32, away.y as f32, None);
            for k in 0..lower.len() {
                if lower[k] > reach || lanes[k] == NONE {
                    continue;
                }
                let lane = Lane::new(*self, lanes[k]).filter(|l| filter.types.contains(l.kind()));
                let Some(lane) = lane else { continue };
                let Some(slab) = area::slab(&lane, usize::from(segments[k])) else { continue };
                // Each border once: a lane's outer one, and lane 0 with one of the two lanes beside it.
                let centre =
                    lane.inner().filter(|inner| inner.number() == 0 && has_centre(&lane, filter));
                for owner in [Some(lane), centre].into_iter().flatten() {
                    course::along(&owner, &slab, filter, |course: Course<'_, '_>| {
                        course.points(spacing, |s, local| {
                            let flat = local.truncate();
                            if flat.cmpge(low).all() && flat.cmple(high).all() {
                                let position = local + self.origin().extend(0.0);
                                out.push(course.mark_point(s, position));
                            }
                        });
                    });
                }
            }
        });
        Ok(())
    }
}

/// Whether lane 0 comes with this lane: the one to its right, or where the filter leaves that out or it is not there, the one to its left.
fn has_centre(lane: &Lane<'_>, filter: &MarkFilter) -> bool {
    let right = lane.section().lane(-1).filter(|right| filter.types.contains(right.kind()));
    lane.number() < 0 || right.is_none()
}
