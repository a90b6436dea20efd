//! A point's place with respect to one lane as a whole.

use crate::area::{SlabPosition, place_at_foot, place_by_call, slab};
use crate::fetch;
use crate::index;
use crate::lane::Lane;
use crate::nearest::round_up;
use crate::profile;
use crate::road::geometry_at;
use crate::types::LanePosition;
use glam::DVec2;
use mapd_archive::lane_flags;
use mapd_geometry::OnlyFoot;

/// Segments of a lane up to which all are looked at, and which are otherwise for a first bound on its distance.
const PROBES: usize = 16;
/// What single precision and records that begin beside a slab's end may cost a bound on a lane's distance `[m]`.
const ROUNDING: f64 = 1e-3;

/// Geometries of a lane's section up to which a point's foot is looked for on each.
const GEOMETRIES: usize = 8;
/// Nearness to the line's centre of curvature, as a share of the radius, below which stretches are looked at one by one.
const MIN_CONTRACTION: f64 = 0.2;
/// Nearness of a foot to where a record begins or ends, below which what is on its other side may hold the point as well, per metre of the
/// point's distance and at least this much `[m]`: well above what projecting rounds.
const BESIDE_END: f64 = 1e-6;

/// What the feet of a point on the reference line along a lane say of its place.
enum HoldingStretch<'a> {
    /// One stretch alone holds it, and nothing begins or ends within so much of the foot `[m]`, heights apart.
    In(SlabPosition<'a>, f64),
    /// None does.
    Nowhere,
    /// That is to be seen.
    Unknown,
}

/// The stretch that holds a point, where the lane's geometries are few lines and arcs on which the point has but one foot. A stretch
/// holds no point without a foot on it.
#[inline]
fn held<'a>(lane: &Lane<'a>, local: DVec2) -> HoldingStretch<'a> {
    let (start, end) = (lane.section.s_start(), lane.section.s_end());
    let rows = lane.road.geometries();
    let first = geometry_at(rows, start);
    let mut foot: Option<(usize, [f64; 2])> = None;
    for at in first..first + GEOMETRIES {
        let next = rows.get(at + 1).map(|next| next.s()).filter(|next| *next < end);
        let Some(piece) = rows.get(at).and_then(|g| lane.road.simple_piece(g)) else {
            return HoldingStretch::Unknown;
        };
        let low = (start - piece.s).max(0.0) - ROUNDING;
        let high = (next.unwrap_or(end) - piece.s).min(piece.curve.length()) + ROUNDING;
        match piece.curve.only_foot(local.x, local.y, low, high) {
            OnlyFoot::At(own) if foot.is_none() => foot = Some((at, own)),
            OnlyFoot::At(_) | OnlyFoot::Unknown => return HoldingStretch::Unknown,
            OnlyFoot::Nowhere => {}
        }
        if next.is_none() {
            let Some((at, foot)) = foot else { return HoldingStretch::Nowhere };
            return held_at(lane, at, foot).unwrap_or(HoldingStretch::Unknown);
        }
    }
    HoldingStretch::Unknown
}

/// As [`held`], where the only foot is known: on which geometry, and its u and lateral offset. Away from where records begin it needs no
/// stretch of the lane to tell which of them hold.
#[inline]
fn held_at<'a>(lane: &Lane<'a>, at: usize, [u, lateral]: [f64; 2]) -> Option<HoldingStretch<'a>> {
    let geometry = lane.road.geometries().get(at)?;
    let piece = lane.road.simple_piece(geometry)?;
    let s = piece.s + u;
    let (start, end) = (lane.section.s_start(), lane.section.s_end());
    // Stretches end where records begin, rounded to single precision.
    let rounding = (end - start) * f64::from(f32::EPSILON);
    let margin = BESIDE_END * (1.0 + lateral.abs()) + rounding;
    let geometry_end = lane.road.geometry_end(at, geometry);
    let is_apart = s - start.max(piece.s) > margin && end.min(geometry_end) - s > margin;
    let has_area = lane.row.center_count() > 1;
    if !(is_apart && has_area && u <= piece.curve.length())
        || 1.0 - piece.curve.curvature(u) * lateral < MIN_CONTRACTION
    {
        return None;
    }
    let found = place_at_foot(lane, geometry, [s, lateral], margin)?;
    Some(found.map_or(HoldingStretch::Nowhere, |found| HoldingStretch::In(found, margin)))
}

/// Whether a lane's area holds a point: whether its distance by [`position_in`] is 0. None without an area.
pub(crate) fn is_in(lane: &Lane<'_>, local: DVec2) -> Option<bool> {
    fetch::known(lane);
    match held(lane, local) {
        HoldingStretch::In(..) => Some(true),
        HoldingStretch::Nowhere if lane.row.center_count() > 1 => Some(false),
        _ => Some(nearest_stretch(lane, local)?.distance == 0.0),
    }
}

/// Position with respect to the whole lane: the nearest of its stretches; of equally near ones that nearer to the lane's centre, then the
/// first.
pub(crate) fn position_in(lane: &Lane<'_>, local: DVec2) -> Option<LanePosition> {
    fetch::known(lane);
    fetch::heights(lane);
    if let HoldingStretch::In(found, margin) = held(lane, local)
        && let Some(elevation) = profile::apart(lane.road.elevations(), found.s(), margin)
    {
        let line = found.heading_of_reference_line(lane);
        return Some(found.position_with(lane, line, elevation));
    }
    nearest_stretch(lane, local).map(|found| found.position(lane))
}

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

/// The nearest of a lane's slabs. The index leaves out what is farther than the best so far, so that long lanes cost little more than
/// short ones.
fn nearest_stretch<'a>(lane: &Lane<'a>, local: DVec2) -> Option<SlabPosition<'a>> {
    let points = lane.center_points();
    let segments = points.len().saturating_sub(1);
    let mut best: Option<SlabPosition<'a>> = None;
    let mut consider = |segment: usize| {
        let found = slab(lane, segment).map(|slab| place_by_call(lane, &slab, local));
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
        return best;
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
        return best;
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
    best
}
