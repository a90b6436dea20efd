//! What lies in a rectangle of the map: lanes, and pieces of their borders.
//!
//! Both are decided on the stored borders, so that whatever is nearer to the rectangle's edge than the map's
//! `bound_tolerance` may be in or out.

use crate::error::QueryError;
use crate::ids::LaneId;
use crate::index;
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::LaneTypes;
use crate::polyline::Polyline;
use crate::types::is_place;
use glam::{DVec2, DVec3};
use mapd_archive::NONE;

/// A rectangle along the axes, in inertial coordinates `[m]`, edges included.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Region {
    /// Smallest x and y.
    pub low: DVec2,
    /// Largest x and y.
    pub high: DVec2,
}

/// A straight piece of a lane's border.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BoundarySegment {
    /// The lane whose outer border it is; lane 0 for the line between left and right lanes.
    pub lane: LaneId,
    /// s of both ends `[m]`, ascending.
    pub s: [f64; 2],
    /// Both ends, inertial `[m]`.
    pub ends: [DVec3; 2],
}

impl Region {
    /// The rectangle with this middle and this distance from it to its edges.
    pub fn around(middle: DVec2, half: f64) -> Self {
        Self { low: middle - half, high: middle + half }
    }

    /// The rectangle around a circle; a radius below 0 counts as 0.
    ///
    /// Errors: numbers that are not finite.
    pub(crate) fn around_circle(middle: DVec2, radius: f64) -> Result<Self, QueryError> {
        if !(is_place(middle) && radius.is_finite()) {
            return Err(QueryError::NotFinite);
        }
        Ok(Self::around(middle, radius.max(0.0)))
    }

    /// Smallest and largest coordinates relative to an origin.
    pub(crate) fn local(&self, origin: DVec2) -> [DVec2; 2] {
        [self.low - origin, self.high - origin]
    }

    pub(crate) fn check(&self) -> Result<(), QueryError> {
        let finite = self.low.is_finite() && self.high.is_finite();
        if finite { Ok(()) } else { Err(QueryError::NotFinite) }
    }

    /// Distance of a point in plan view `[m]`; 0 inside.
    pub(crate) fn distance(&self, p: DVec2) -> f64 {
        (self.low - p).max(p - self.high).max(DVec2::ZERO).length()
    }

    pub(crate) fn holds(&self, p: DVec2) -> bool {
        p.cmpge(self.low).all() && p.cmple(self.high).all()
    }

    /// Whether a segment and the rectangle have a point in common (Liang and Barsky's clipping).
    pub(crate) fn meets(&self, a: DVec2, b: DVec2) -> bool {
        let d = b - a;
        let (mut from, mut to) = (0f64, 1f64);
        for axis in 0..2 {
            let (start, step) = (a[axis], d[axis]);
            if step == 0.0 {
                if start < self.low[axis] || start > self.high[axis] {
                    return false;
                }
                continue;
            }
            let (p, q) = ((self.low[axis] - start) / step, (self.high[axis] - start) / step);
            (from, to) = (from.max(p.min(q)), to.min(p.max(q)));
        }
        from <= to
    }
}

impl Map<'_> {
    /// Every lane of these types whose area meets a rectangle in plan view, in the order of their rows. `out` is emptied
    /// first; it grows only if its capacity is too small.
    ///
    /// Errors: a rectangle that is not finite.
    pub fn lanes_in(
        &self,
        region: Region,
        types: LaneTypes,
        out: &mut Vec<LaneId>,
    ) -> Result<(), QueryError> {
        region.check()?;
        self.candidates(region, out);
        out.retain(|id| {
            let lane = Lane::new(*self, id.row());
            lane.is_some_and(|lane| types.contains(lane.kind()) && area_meets(&lane, region))
        });
        Ok(())
    }

    /// Every piece of the borders of lanes of these types that meets a rectangle in plan view, each once, in the order of
    /// their lanes and of s. `out` is emptied first, `lanes` is room to work in; both grow only if their capacities are
    /// too small.
    ///
    /// Errors: a rectangle that is not finite.
    pub fn boundary_segments(
        &self,
        region: Region,
        types: LaneTypes,
        lanes: &mut Vec<LaneId>,
        out: &mut Vec<BoundarySegment>,
    ) -> Result<(), QueryError> {
        region.check()?;
        out.clear();
        self.candidates(region, lanes);
        lanes.retain(|id| {
            Lane::new(*self, id.row()).is_some_and(|lane| types.contains(lane.kind()))
        });
        // Each border belongs to the lane on its inner side: a lane's other border is its inner neighbour's.
        for i in 0..lanes.len() {
            let Some(lane) = lanes.get(i).and_then(|id| Lane::new(*self, id.row())) else {
                continue;
            };
            lanes.extend(lane.inner().map(|inner| inner.lane_id()));
        }
        lanes.sort_unstable_by_key(|id| id.row());
        lanes.dedup();
        for lane in lanes.iter().filter_map(|id| Lane::new(*self, id.row())) {
            let border = lane.border();
            for i in 1..border.len() {
                let (Some(a), Some(b)) = (border.position(i - 1), border.position(i)) else {
                    continue;
                };
                if region.meets(a.truncate(), b.truncate()) {
                    let s = [i - 1, i].map(|i| border.station(i).unwrap_or_default());
                    out.push(BoundarySegment { lane: lane.lane_id(), s, ends: [a, b] });
                }
            }
        }
        Ok(())
    }

    /// Lanes that the index does not rule out, each once, by row.
    fn candidates(&self, region: Region, out: &mut Vec<LaneId>) {
        out.clear();
        let [low, high] = region.local(self.origin());
        let content = self.content();
        index::visit_box(self.tables(), low, high, |leaf| {
            let known = leaf.lane().iter().copied().filter(|lane| *lane != NONE);
            for row in known {
                let id = LaneId::new(row, content);
                // Neighbouring places are mostly of one lane.
                if out.last() != Some(&id) {
                    out.push(id);
                }
            }
        });
        out.sort_unstable_by_key(|id| id.row());
        out.dedup();
    }
}

/// Whether an edge crosses the ray from a point towards +x: a polygon's edges do so an odd number of times around it.
pub(crate) fn crosses(a: DVec2, b: DVec2, point: DVec2) -> bool {
    (a.y > point.y) != (b.y > point.y)
        && a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x) > point.x
}

/// Whether a lane's area, the polygon between its borders, meets a rectangle.
fn area_meets(lane: &Lane<'_>, region: Region) -> bool {
    let left = lane.left_bound_of_reference_line();
    let right = lane.right_bound_of_reference_line();
    let middle = 0.5 * (region.low + region.high);
    // A border or an end in the rectangle, else the rectangle whole in the area: its middle then is inside, which an odd
    // number of crossings of a ray tells.
    let mut crossings = 0u32;
    let mut meets = false;
    edges(left, right, |a, b| {
        meets |= region.holds(a) || region.meets(a, b);
        crossings += u32::from(crosses(a, b, middle));
    });
    meets || crossings % 2 == 1
}

/// The polygon's edges: the left border, the far end, the right border, the near end.
fn edges(left: Polyline<'_>, right: Polyline<'_>, mut visit: impl FnMut(DVec2, DVec2)) {
    let xy = |line: &Polyline<'_>, i: usize| line.position(i).map(DVec3::truncate);
    for line in [&left, &right] {
        for i in 1..line.len() {
            if let (Some(a), Some(b)) = (xy(line, i - 1), xy(line, i)) {
                visit(a, b);
            }
        }
    }
    let ends = [(0, 0), (left.len().wrapping_sub(1), right.len().wrapping_sub(1))];
    for (l, r) in ends {
        if let (Some(a), Some(b)) = (xy(&left, l), xy(&right, r)) {
            visit(a, b);
        }
    }
}
