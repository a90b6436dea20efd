//! A point's place with respect to one lane as a whole.

use crate::area::{SlabPosition, place, slab};
use crate::index;
use crate::lane::Lane;
use crate::nearest::round_up;
use crate::profile;
use crate::types::LanePosition;
use glam::DVec2;
use mapd_archive::lane_flags;

/// Segments of a lane up to which all are looked at, and which are otherwise for a first bound on its distance.
const PROBES: usize = 16;
/// What single precision and records that begin beside a slab's end may cost a bound on a lane's distance `[m]`.
const ROUNDING: f64 = 1e-3;

/// Squared distance of a point from a segment in plan view `[m²]`.
fn squared(point: DVec2, (a, b): (DVec2, DVec2)) -> f64 {
    let (from, along) = (point - a, b - a);
    let (forward, length) = (from.dot(along), along.length_squared());
    if forward <= 0.0 {
        from.length_squared()
    } else if forward >= length {
        (point - b).length_squared()
    } else {
        let sideways = from.perp_dot(along);
        sideways * sideways / length
    }
}

impl Lane<'_> {
    /// A width that the lane nowhere exceeds `[m]`: of each width record the largest of its numbers as a Bézier curve. Infinite
    /// for lanes that are written as borders.
    fn largest_width(&self) -> f64 {
        if self.row.flags() & lane_flags::BORDER != 0 {
            return f64::INFINITY;
        }
        let (start, end) = (self.section.s_start(), self.section.s_end());
        let records = self.row.widths().of(self.map.tables().cubics);
        let mut largest = 0.0f64;
        for (i, record) in records.iter().enumerate() {
            let next = records.get(i + 1).map_or(end, |next| next.s().min(end));
            let from = record.s().max(start) - record.s();
            let length = next - record.s() - from;
            if length >= 0.0 {
                let cubic = profile::cubic(record);
                let (value, slope) = (cubic.value(from), cubic.derivative(from) * length);
                let bend = (cubic.c + 3.0 * cubic.d * from) * length * length;
                let twist = cubic.d * length * length * length;
                let ends = value.max(value + slope + bend + twist);
                let inner = (value + slope / 3.0).max(value + (2.0 * slope + bend) / 3.0);
                largest = largest.max(ends).max(inner);
            }
        }
        largest
    }
}

/// Position with respect to the whole lane: the nearest of its slabs; of equally near ones that nearer to the lane's centre, then the
/// first. The index leaves out what is farther than the best so far, so that long lanes cost little more than short ones.
pub(crate) fn position_in(lane: &Lane<'_>, local: DVec2) -> Option<LanePosition> {
    let points = lane.center_points();
    let segments = points.len().saturating_sub(1);
    let mut best: Option<SlabPosition<'_>> = None;
    let mut consider = |segment: usize| {
        let found = slab(lane, segment).map(|slab| place(lane, &slab, local));
        let key = |place: &SlabPosition<'_>| (place.distance, place.offset.abs(), place.s());
        if let Some(found) = found
            && best.as_ref().is_none_or(|best| key(&found) < key(best))
        {
            best = Some(found);
        }
        best.as_ref().map_or(f64::INFINITY, |best| best.distance)
    };
    // Queries in space leave temporary lanes out, and so does the index.
    if segments <= 1 || lane.is_temporary() {
        for segment in 0..segments {
            consider(segment);
        }
        return best.map(|best| best.position(lane));
    }
    // The polyline says where to begin; what it excludes costs no projection.
    let probes = segments.min(PROBES);
    let mut near = [f64::INFINITY; PROBES];
    let frame = DVec2::new(lane.section.row.x().into(), lane.section.row.y().into());
    if segments <= PROBES {
        let mut ends = points.in_plan(0);
        let mut from = ends.next().unwrap_or_default();
        for (near, to) in near.iter_mut().zip(ends) {
            *near = squared(local - frame, (from, to));
            from = to;
        }
    } else {
        for (probe, near) in near.iter_mut().enumerate() {
            let mut ends = points.in_plan(probe * segments / probes);
            let ends = (ends.next().unwrap_or_default(), ends.next().unwrap_or_default());
            *near = squared(local - frame, ends);
        }
    }
    let nearest = near.iter().enumerate().reduce(|a, b| if b.1 < a.1 { b } else { a })?.0;
    let first = nearest * segments / probes;
    let mut bound = consider(first);
    if segments <= PROBES {
        let reach = lane.largest_width() / 2.0 + lane.map.index_tolerance() + ROUNDING;
        for (segment, near) in near.iter().enumerate().take(segments) {
            let limit = bound + reach;
            // What is no number excludes nothing.
            let is_excluded = *near > limit * limit;
            if segment != nearest && !is_excluded {
                bound = consider(segment);
            }
        }
        return best.map(|best| best.position(lane));
    }
    let own = lane.row_number();
    for probe in 0..probes {
        // The first one has no area where the line jumps.
        if bound == f64::INFINITY {
            bound = consider(probe * segments / probes);
        }
    }
    // Single precision rounds the bound; a little more loses nothing.
    let bound = round_up(bound);
    index::visit(lane.map.tables(), local, None, bound, |leaf, qx, qy, mut bound| {
        let (lanes, numbers) = (leaf.lane(), leaf.segment());
        let lower = index::lower_bounds(leaf, qx, qy, None);
        for k in 0..lanes.len() {
            let is_new = lanes[k] == own && usize::from(numbers[k]) != first;
            if is_new && lower[k] <= bound {
                bound = bound.min(round_up(consider(usize::from(numbers[k]))));
            }
        }
        bound
    });
    best.map(|best| best.position(lane))
}
