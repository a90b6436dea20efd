//! Search in the packed spatial index: an R-tree of 16 children a node, flattened level by level.

use crate::packed;
use glam::{DVec2, Vec4};
use mapd_archive::packed_index::{ANY, HEIGHT_UNIT, LEVELS, REACH_UNIT, WIDTH};
use mapd_archive::{ArchivedIndexLeafRow, ArchivedIndexNodeRow, NONE, Tables, prefetch};

/// Places on the search stack: 15 siblings on each of 8 levels (16⁸ leaves) and some more.
const STACK: usize = 160;

/// The greater of two numbers that are not not-a-number, in one instruction.
#[inline]
fn more(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// A segment of a lane's centre line found by [`nearest_segment`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SegmentHit {
    /// Row of the lane.
    pub lane: u32,
    /// Number of the segment within the lane's centre line.
    pub segment: u16,
    /// Plan-view distance `[m]`, in single precision.
    pub distance: f32,
}

/// A node or leaf to be visited: its squared distance (whose bits are ordered as it is, for it is not negative) above its
/// level and number, so that comparing places compares distances first.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
struct NodeToVisit(u64);

/// Bits of the number of a node or leaf within its level: 2²⁸ leaves hold 2³² segments.
const NUMBER_BITS: u32 = 28;

impl NodeToVisit {
    #[inline]
    fn new(squared: f32, level: u32, at: u32) -> Self {
        let node = level << NUMBER_BITS | at & ((1 << NUMBER_BITS) - 1);
        Self(u64::from(squared.to_bits()) << 32 | u64::from(node))
    }

    #[inline]
    fn squared(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    /// Level, and number within it.
    #[inline]
    fn node(self) -> (u32, u32) {
        let node = self.0 as u32;
        (node >> NUMBER_BITS, node & ((1 << NUMBER_BITS) - 1))
    }
}

/// Levels of nodes above the leaves; none without an index. A damaged archive may state more than there can be.
#[inline]
fn depth(tables: &Tables<'_>) -> Option<usize> {
    tables.index_levels.len().checked_sub(1).filter(|depth| *depth <= LEVELS)
}

/// Visits every leaf whose box is not farther from the point than the bound, nearer children first; with
/// `heights`, only those that reach between them. `visit` gets the leaf and the point relative to the leaf's origin and returns the new bound `[m]`, which must not grow.
#[inline]
pub(crate) fn visit<'a>(
    tables: &Tables<'a>,
    local: DVec2,
    heights: Option<[f64; 2]>,
    mut bound: f32,
    mut visit: impl FnMut(&'a ArchivedIndexLeafRow, f32, f32, f32) -> f32,
) {
    let Some(depth) = depth(tables) else { return };
    let (px, py) = (local.x as f32, local.y as f32);
    let mut stack = [NodeToVisit(0); STACK];
    let mut top = 1;
    while top > 0 {
        top -= 1;
        let Some(place) = stack.get(top) else { return };
        let (level, at) = place.node();
        if place.squared() > bound * bound {
            continue;
        }
        if level as usize == depth {
            let Some(leaf) = tables.index_leaves.get(at as usize) else { continue };
            let (x, y) = (f64::from(leaf.x()), f64::from(leaf.y()));
            bound = visit(leaf, (local.x - x) as f32, (local.y - y) as f32, bound);
            continue;
        }
        let first = tables.index_levels.get(level as usize).copied().unwrap_or(0);
        let Some(node) = tables.index_nodes.get(first.wrapping_add(at) as usize) else { continue };
        let (min_x, min_y, max_x, max_y) = (node.min_x(), node.min_y(), node.max_x(), node.max_y());
        let mut squares = [0f32; WIDTH];
        for k in 0..WIDTH {
            let dx = more(more(min_x[k] - px, px - max_x[k]), 0.0);
            let dy = more(more(min_y[k] - py, py - max_y[k]), 0.0);
            squares[k] = dx * dx + dy * dy;
        }
        if let Some([low, high]) = heights {
            let (min_z, max_z) = (node.min_z(), node.max_z());
            for k in 0..WIDTH {
                if f64::from(max_z[k]) < low || f64::from(min_z[k]) > high {
                    squares[k] = f32::INFINITY;
                }
            }
        }
        let mut hits = places_within(&squares, bound * bound);
        let base = top;
        while hits != 0 {
            let k = hits.trailing_zeros() as usize;
            hits &= hits - 1;
            if top >= STACK {
                return;
            }
            let child = at.wrapping_mul(WIDTH as u32).wrapping_add(k as u32);
            let new = NodeToVisit::new(squares[k], level + 1, child);
            // Insertion keeps the nearest child on top.
            let mut place = top;
            while place > base && stack[place - 1] < new {
                stack[place] = stack[place - 1];
                place -= 1;
            }
            stack[place] = new;
            top += 1;
        }
    }
}

/// The children of a node whose boxes hold a place, as bits; with `heights`, only those that reach between them.
#[inline]
fn children_around(
    node: &ArchivedIndexNodeRow,
    px: f32,
    py: f32,
    heights: Option<[f64; 2]>,
) -> u32 {
    let (x, y) = (Vec4::splat(px), Vec4::splat(py));
    let fours = |values: &[f32; WIDTH], k: usize| {
        let [a, b, c, d] = [4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 3].map(|k| values[k]);
        Vec4::new(a, b, c, d)
    };
    let (min_x, min_y, max_x, max_y) = (node.min_x(), node.min_y(), node.max_x(), node.max_y());
    let mut around = 0;
    for k in 0..WIDTH / 4 {
        let inside = fours(min_x, k).cmple(x)
            & fours(max_x, k).cmpge(x)
            & fours(min_y, k).cmple(y)
            & fours(max_y, k).cmpge(y);
        around |= inside.bitmask() << (4 * k);
    }
    if let Some([low, high]) = heights {
        let (min_z, max_z) = (node.min_z(), node.max_z());
        for k in 0..WIDTH {
            if f64::from(max_z[k]) < low || f64::from(min_z[k]) > high {
                around &= !(1 << k);
            }
        }
    }
    around
}

/// Brings several leaves of a node, so that memory is waited for side by side.
#[inline]
fn prefetch_leaves(tables: &Tables<'_>, first: u32, mut children: u32) {
    while children != 0 {
        let leaf = tables.index_leaves.get(first.wrapping_add(children.trailing_zeros()) as usize);
        children &= children - 1;
        leaf.into_iter().for_each(prefetch);
    }
}

/// Visits every leaf whose box holds the point; with `heights`, only those that reach between them. `visit` gets the leaf and
/// the point relative to the leaf's origin. As [`visit`] with a bound of 0, for less: nothing has to be sorted.
#[inline]
pub(crate) fn visit_around<'a>(
    tables: &Tables<'a>,
    local: DVec2,
    heights: Option<[f64; 2]>,
    mut visit: impl FnMut(&'a ArchivedIndexLeafRow, f32, f32),
) {
    let Some(depth) = depth(tables) else { return };
    let (px, py) = (local.x as f32, local.y as f32);
    // Of the nodes above: the number of their first child, and which of their children are still to be visited.
    let mut above = [(0u32, 0u32); LEVELS];
    let (mut level, mut at) = (0, 0u32);
    loop {
        if level == depth {
            if let Some(leaf) = tables.index_leaves.get(at as usize) {
                let (x, y) = (f64::from(leaf.x()), f64::from(leaf.y()));
                visit(leaf, (local.x - x) as f32, (local.y - y) as f32);
            }
        } else {
            let first = tables.index_levels.get(level).copied().unwrap_or(0);
            let node = tables.index_nodes.get(first.wrapping_add(at) as usize);
            if let (Some(node), Some(place)) = (node, above.get_mut(level)) {
                let children = children_around(node, px, py, heights);
                if level + 1 == depth && children & children.wrapping_sub(1) != 0 {
                    prefetch_leaves(tables, at.wrapping_mul(WIDTH as u32), children);
                }
                *place = (at.wrapping_mul(WIDTH as u32), children);
                level += 1;
            }
        }
        // The next child of the nearest node above that has one left.
        loop {
            let Some((first, children)) =
                level.checked_sub(1).and_then(|level| above.get_mut(level))
            else {
                return;
            };
            if *children != 0 {
                at = first.wrapping_add(children.trailing_zeros());
                *children &= *children - 1;
                break;
            }
            level -= 1;
        }
    }
}

/// A segment of a lane's centre line, as a leaf names it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct LaneSegment {
    /// Row of the lane.
    pub(crate) lane: u32,
    /// Number of the segment within the centre line.
    pub(crate) segment: u16,
}

impl LaneSegment {
    /// Of no lane.
    pub(crate) const NONE: Self = Self { lane: NONE, segment: 0 };
}

/// Visits every leaf that may hold something of a box (relative to the local origin, smallest and largest coordinates).
pub(crate) fn visit_box<'a>(
    tables: &Tables<'a>,
    low: DVec2,
    high: DVec2,
    mut visit: impl FnMut(&'a ArchivedIndexLeafRow),
) {
    let node = |row: usize| {
        let node = tables.index_nodes.get(row)?;
        Some([node.min_x(), node.min_y(), node.max_x(), node.max_y()])
    };
    let most = tables.index_nodes.len() + tables.index_leaves.len();
    let levels = packed::Levels { starts: tables.index_levels, most };
    packed::visit_box(levels, node, [low, high], |leaf| {
        tables.index_leaves.get(leaf as usize).into_iter().for_each(&mut visit);
    });
}

/// Start of each of a leaf's segments from the leaf's corner, and its end from its start `[m]`.
struct Segments {
    start: [[f32; WIDTH]; 2],
    delta: [[f32; WIDTH]; 2],
}

impl Segments {
    #[inline(always)]
    fn of(leaf: &ArchivedIndexLeafRow) -> Self {
        let step = leaf.step();
        let mut segments = Self { start: [[0.0; WIDTH]; 2], delta: [[0.0; WIDTH]; 2] };
        let ends = [(leaf.start_x(), leaf.end_x()), (leaf.start_y(), leaf.end_y())];
        for (axis, (start, end)) in ends.into_iter().enumerate() {
            for k in 0..WIDTH {
                let (start, end) = (f32::from(start[k]), f32::from(end[k]));
                segments.start[axis][k] = start * step;
                segments.delta[axis][k] = (end - start) * step;
            }
        }
        segments
    }
}

/// Squared distances of a point (relative to the leaf's corner) from the leaf's segments `[m²]`.
#[inline]
pub(crate) fn squared_distances(leaf: &ArchivedIndexLeafRow, qx: f32, qy: f32) -> [f32; WIDTH] {
    let Segments { start: [ax, ay], delta: [dx, dy] } = Segments::of(leaf);
    let mut out = [0f32; WIDTH];
    for k in 0..WIDTH {
        let (ex, ey) = (qx - ax[k], qy - ay[k]);
        let length = (dx[k] * dx[k] + dy[k] * dy[k]).max(f32::MIN_POSITIVE);
        let along = (ex * dx[k] + ey * dy[k]) / length;
        let along = if along > 0.0 { along.min(1.0) } else { 0.0 };
        let (fx, fy) = (ex - along * dx[k], ey - along * dy[k]);
        out[k] = fx * fx + fy * fy;
    }
    out
}

/// The places whose value is not above a limit, as bits.
#[inline]
pub(crate) fn places_within(values: &[f32; WIDTH], limit: f32) -> u32 {
    let limit = Vec4::splat(limit);
    let (fours, _) = values.as_chunks::<4>();
    let bits = |four: &[f32; 4]| Vec4::from_array(*four).cmple(limit).bitmask();
    fours.iter().enumerate().fold(0, |all, (i, four)| all | bits(four) << (4 * i))
}

/// The place with the least value among those whose bit is set.
#[inline]
pub(crate) fn least(values: &[f32; WIDTH], mut places: u32) -> Option<usize> {
    let mut best = None;
    let mut least = f32::INFINITY;
    while places != 0 {
        let k = places.trailing_zeros() as usize;
        places &= places - 1;
        if best.is_none() || values[k] < least {
            (best, least) = (Some(k), values[k]);
        }
    }
    best
}

/// For each of a leaf's segments a distance than which no point of the lane's stretch is nearer `[m]`: that to the
/// rectangle around the segment. Infinite for unused places and for stretches outside `heights`.
#[inline]
pub(crate) fn lower_bounds(
    leaf: &ArchivedIndexLeafRow,
    qx: f32,
    qy: f32,
    heights: Option<[f64; 2]>,
) -> [f32; WIDTH] {
    let Segments { start: [ax, ay], delta: [dx, dy] } = Segments::of(leaf);
    let (reach, overshoot, lanes) = (leaf.reach(), leaf.overshoot(), leaf.lane());
    let mut out = [0f32; WIDTH];
    for k in 0..WIDTH {
        let (ex, ey) = (qx - ax[k], qy - ay[k]);
        let length = more(dx[k] * dx[k] + dy[k] * dy[k], f32::MIN_POSITIVE).sqrt();
        let forward = (ex * dx[k] + ey * dy[k]) / length;
        let sideways = (ex * dy[k] - ey * dx[k]).abs() / length;
        let past = more(-forward, forward - length) - f32::from(overshoot[k]) * REACH_UNIT;
        let beside = sideways - f32::from(reach[k]) * REACH_UNIT;
        let past = if overshoot[k] == ANY { 0.0 } else { more(past, 0.0) };
        let beside = if reach[k] == ANY { 0.0 } else { more(beside, 0.0) };
        let bound = (past * past + beside * beside).sqrt();
        out[k] = if lanes[k] == NONE { f32::INFINITY } else { bound };
    }
    if let Some([low, high]) = heights {
        let outside = outside_heights(leaf, low, high);
        for (k, bound) in out.iter_mut().enumerate() {
            if outside & 1 << k != 0 {
                *bound = f32::INFINITY;
            }
        }
    }
    out
}

/// The places of a leaf that do not reach between two heights `[m]`, as bits.
fn outside_heights(leaf: &ArchivedIndexLeafRow, low: f64, high: f64) -> u32 {
    let (z_low, z_high) = (leaf.z_low(), leaf.z_high());
    let z = f64::from(leaf.z());
    let (low, high) = ((low - z) as f32, (high - z) as f32);
    let outside = |k: &usize| {
        let below = z_high[*k] != ANY && f32::from(z_high[*k]) * HEIGHT_UNIT < low;
        below || f32::from(z_low[*k]) * HEIGHT_UNIT > high
    };
    (0..WIDTH).filter(outside).fold(0, |all, k| all | 1 << k)
}

/// A little more than the rounding of the products in [`places_around`], as a share.
pub(crate) const PRODUCTS: f32 = 1.0 + 1.0 / (1 << 20) as f32;

/// The places of a leaf whose rectangles around their segments hold a point.
pub(crate) struct PlacesAround {
    /// As bits.
    pub(crate) places: u32,
    /// Not more than the squared distances of the point from the lines through the segments, of all places `[m²]`.
    pub(crate) beside_squared: [f32; WIDTH],
}

/// The places of a leaf whose rectangle around the segment holds the point: those whose lower bound is 0. No root is taken. With
/// `heights`, without those outside.
#[inline]
pub(crate) fn places_around(
    leaf: &ArchivedIndexLeafRow,
    qx: f32,
    qy: f32,
    heights: Option<[f64; 2]>,
) -> PlacesAround {
    let (reach, overshoot) = (leaf.reach(), leaf.overshoot());
    let any = (0..WIDTH).fold(false, |any, k| any | (reach[k] == ANY) | (overshoot[k] == ANY));
    let mut around =
        if any { unlimited_rectangles(leaf, qx, qy) } else { rectangles::<false>(leaf, qx, qy) };
    if let Some([low, high]) = heights {
        around.places &= !outside_heights(leaf, low, high);
    }
    around
}

#[cold]
#[inline(never)]
fn unlimited_rectangles(leaf: &ArchivedIndexLeafRow, qx: f32, qy: f32) -> PlacesAround {
    rectangles::<true>(leaf, qx, qy)
}

/// As [`places_around`], of all heights; `ANY_REACH`: whether some rectangles may be unlimited.
#[inline(always)]
fn rectangles<const ANY_REACH: bool>(
    leaf: &ArchivedIndexLeafRow,
    qx: f32,
    qy: f32,
) -> PlacesAround {
    let Segments { start: [ax, ay], delta: [dx, dy] } = Segments::of(leaf);
    let (reach, overshoot) = (leaf.reach(), leaf.overshoot());
    let distance = |units: u16| {
        if ANY_REACH && units == ANY { f32::INFINITY } else { f32::from(units) * REACH_UNIT }
    };
    // 1 where the point lies outside, else 0. What is no number is not outside.
    let mut outside = [0f32; WIDTH];
    let mut beside_squared = [0f32; WIDTH];
    for k in 0..WIDTH {
        let (ex, ey) = (qx - ax[k], qy - ay[k]);
        let squared = more(dx[k] * dx[k] + dy[k] * dy[k], f32::MIN_POSITIVE);
        let forward = ex * dx[k] + ey * dy[k];
        let sideways = ex * dy[k] - ey * dx[k];
        // Times the segment's length, as reach and overshoot are where they are compared with.
        let past = more(more(-forward, forward - squared), 0.0);
        let (reach, overshoot) = (distance(reach[k]), distance(overshoot[k]));
        let squared = squared * PRODUCTS;
        let beside = sideways * sideways > reach * reach * squared;
        let beyond = past * past > overshoot * overshoot * squared;
        outside[k] = if beside | beyond { 1.0 } else { 0.0 };
        beside_squared[k] = sideways * sideways / squared;
    }
    PlacesAround { places: places_within(&outside, 0.0), beside_squared }
}

/// The segment of any lane's centre line that is nearest to an inertial point, within `radius` `[m]`. This is the bare
/// index, whose segments are written in steps of a leaf ([`mapd_archive::ArchivedIndexLeafRow::step`]); lanes are found by [`crate::Map::nearest_lane`], which knows their areas.
pub fn nearest_segment(map: crate::Map<'_>, point: DVec2, radius: f64) -> Option<SegmentHit> {
    let mut best: Option<SegmentHit> = None;
    visit(map.tables(), point - map.origin(), None, radius as f32, |leaf, qx, qy, mut bound| {
        let squares = squared_distances(leaf, qx, qy);
        let (lanes, segments) = (leaf.lane(), leaf.segment());
        for k in 0..WIDTH {
            if lanes[k] != NONE && squares[k] <= bound * bound {
                let distance = squares[k].sqrt();
                if best.is_none_or(|b| distance < b.distance) {
                    best = Some(SegmentHit { lane: lanes[k], segment: segments[k], distance });
                }
                bound = distance;
            }
        }
        bound
    });
    best
}
