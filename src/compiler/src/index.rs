//! Builds the packed spatial index over the lanes' centre lines.

use crate::TooLarge;
use crate::lanes::view;
use crate::options::CompileOptions;
use glam::DVec2;
use mapd_archive::{IndexLeafRow, IndexNodeRow, NONE, Rows};
use mapd_geometry::clamp;
use mapd_query::{Lane, Map};
use rayon::prelude::*;

/// Children of a node, places of a leaf.
const WIDTH: usize = 16;
/// Added to every reach `[m]`, besides the tolerances: single precision within a leaf.
const REACH_MARGIN: f64 = 1e-4;
/// Relative rounding of single precision, doubled twice: coordinates are rounded once here and once in a query.
const ROUNDING: f64 = 4.0 * f32::EPSILON as f64;

/// A segment of a centre line with the area it stands for, relative to the local origin.
#[derive(Clone, Copy, Debug)]
struct Entry {
    a: DVec2,
    b: DVec2,
    reach: f64,
    lane: u32,
    point: u32,
}

impl Entry {
    fn middle(&self, axis: usize) -> f64 {
        self.a[axis] + self.b[axis]
    }
}

/// Fills `index_levels`, `index_nodes` and `index_leaves`.
pub(crate) fn build(rows: &mut Rows, options: &CompileOptions) -> Result<(), TooLarge> {
    let mut entries: Vec<Entry> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let numbers: Vec<u32> = (0..rows.lanes.len() as u32).collect();
        numbers.par_iter().flat_map_iter(|number| lane_entries(map, *number, options)).collect()
    };
    if entries.is_empty() {
        return Ok(());
    }
    u32::try_from(entries.len()).map_err(|_| TooLarge("index_leaves"))?;
    order(&mut entries);
    let (leaves, boxes): (Vec<_>, Vec<_>) = entries.par_chunks(WIDTH).map(leaf).unzip();
    let mut levels = Vec::new();
    let mut below = boxes;
    loop {
        let (nodes, boxes): (Vec<_>, Vec<_>) = below.chunks(WIDTH).map(node).unzip();
        let is_root = nodes.len() == 1;
        levels.push(nodes);
        below = boxes;
        if is_root {
            break;
        }
    }
    let mut first = 0;
    for nodes in levels.into_iter().rev() {
        rows.index_levels.push(first);
        first += nodes.len() as u32;
        rows.index_nodes.extend(nodes);
    }
    rows.index_levels.push(first);
    rows.index_leaves = leaves.into();
    Ok(())
}

fn lane_entries(map: Map<'_>, number: u32, options: &CompileOptions) -> Vec<Entry> {
    let Some(lane) = map.lane_by_row(number) else { return Vec::new() };
    let row = &map.tables().lanes[number as usize];
    let origin = DVec2::new(row.x(), row.y());
    let at = |i: usize| {
        let p = &lane.center_line().points[i];
        (origin + DVec2::new(f64::from(p.x()), f64::from(p.y())), p.s())
    };
    let first = row.center().first;
    let mut entries = Vec::new();
    for i in 0..lane.center_line().len().saturating_sub(1) {
        let ((a, s_a), (b, s_b)) = (at(i), at(i + 1));
        if s_a == s_b {
            // Both sides of a jump: no area between them.
            continue;
        }
        let reach = reach(&lane, map.local_origin(), a, b, s_a, s_b)
            + 2.0 * options.bound_tolerance
            + REACH_MARGIN;
        entries.push(Entry { a, b, reach, lane: number, point: first + i as u32 });
    }
    entries
}

/// Largest distance from a segment of either border between two s. Distance from a segment is convex, so that each
/// border's polyline is farthest at one of its points or where the stretch is cut.
fn reach(lane: &Lane<'_>, map_origin: DVec2, a: DVec2, b: DVec2, s_a: f32, s_b: f32) -> f64 {
    let mut reach = 0f64;
    for border in [lane.left_bound(), lane.right_bound()] {
        let origin = border.origin.truncate() - map_origin;
        let xy = |i: usize| {
            border
                .points
                .get(i)
                .map(|p| (origin + DVec2::new(f64::from(p.x()), f64::from(p.y())), p.s()))
        };
        let mut visit = |p: DVec2| reach = reach.max(distance_to_segment(p, a, b));
        let from = border.points.partition_point(|p| p.s() < s_a);
        let to = border.points.partition_point(|p| p.s() <= s_b);
        for i in from..to {
            xy(i).into_iter().for_each(|(p, _)| visit(p));
        }
        for (cut, i) in [(s_a, from), (s_b, to)] {
            if let (Some((p, s_p)), Some((q, s_q))) = (i.checked_sub(1).and_then(xy), xy(i))
                && s_q > s_p
            {
                visit(p.lerp(q, clamp(f64::from((cut - s_p) / (s_q - s_p)), 0.0, 1.0)));
            }
        }
    }
    reach
}

fn distance_to_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let d = b - a;
    let squared = d.length_squared();
    let along = if squared > 0.0 { clamp((p - a).dot(d) / squared, 0.0, 1.0) } else { 0.0 };
    p.distance(a + d * along)
}

/// Orders entries so that consecutive sixteens lie close together, and sixteens of sixteens as well: halves along the
/// longer side at multiples of whole subtrees. The order is total, so that the result does not depend on how it is
/// sorted.
fn order(entries: &mut [Entry]) {
    let mut unit = WIDTH;
    while unit * WIDTH < entries.len() {
        unit *= WIDTH;
    }
    if entries.len() <= WIDTH {
        entries.sort_by_key(|e| (e.lane, e.point));
        return;
    }
    let subtrees = entries.len().div_ceil(unit);
    let middle = subtrees / 2 * unit;
    let spread = |axis: usize| {
        let low = entries.iter().map(|e| e.middle(axis)).fold(f64::INFINITY, f64::min);
        let high = entries.iter().map(|e| e.middle(axis)).fold(f64::NEG_INFINITY, f64::max);
        high - low
    };
    let axis = usize::from(spread(1) > spread(0));
    entries.select_nth_unstable_by(middle, |p, q| {
        p.middle(axis).total_cmp(&q.middle(axis)).then((p.lane, p.point).cmp(&(q.lane, q.point)))
    });
    let (left, right) = entries.split_at_mut(middle);
    rayon::join(|| order(left), || order(right));
}

/// A box in double precision: smallest x, y, largest x, y.
type Bounds = [f64; 4];

const EMPTY: Bounds = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];

fn join(a: Bounds, b: Bounds) -> Bounds {
    [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])]
}

/// A leaf and the box of all areas in it.
fn leaf(entries: &[Entry]) -> (IndexLeafRow, Bounds) {
    let ends = entries.iter().fold(EMPTY, |bounds, e| {
        let (low, high) = (e.a.min(e.b), e.a.max(e.b));
        join(bounds, [low.x, low.y, high.x, high.y])
    });
    let (x, y) = (0.5 * (ends[0] + ends[2]), 0.5 * (ends[1] + ends[3]));
    let size = (ends[2] - ends[0]).max(ends[3] - ends[1]);
    let mut row = IndexLeafRow {
        x,
        y,
        start_x: [0.0; WIDTH],
        start_y: [0.0; WIDTH],
        delta_x: [0.0; WIDTH],
        delta_y: [0.0; WIDTH],
        reach: [0.0; WIDTH],
        lane: [NONE; WIDTH],
        point: [NONE; WIDTH],
    };
    let mut bounds = EMPTY;
    for (k, e) in entries.iter().enumerate().take(WIDTH) {
        row.start_x[k] = (e.a.x - x) as f32;
        row.start_y[k] = (e.a.y - y) as f32;
        row.delta_x[k] = (e.b.x - e.a.x) as f32;
        row.delta_y[k] = (e.b.y - e.a.y) as f32;
        row.reach[k] = round_up(e.reach + size * ROUNDING);
        row.lane[k] = e.lane;
        row.point[k] = e.point;
        let reach = DVec2::splat(f64::from(row.reach[k]));
        let (low, high) = (e.a.min(e.b) - reach, e.a.max(e.b) + reach);
        bounds = join(bounds, [low.x, low.y, high.x, high.y]);
    }
    (row, bounds)
}

/// A node over the boxes of its children.
fn node(children: &[Bounds]) -> (IndexNodeRow, Bounds) {
    // Empty boxes: nothing is near them, and every number stays finite.
    let mut row = IndexNodeRow {
        min_x: [f32::MAX; WIDTH],
        min_y: [f32::MAX; WIDTH],
        max_x: [f32::MIN; WIDTH],
        max_y: [f32::MIN; WIDTH],
    };
    let mut bounds = EMPTY;
    for (k, child) in children.iter().enumerate().take(WIDTH) {
        let margin = child.iter().fold(0f64, |m, v| m.max(v.abs())) * ROUNDING;
        row.min_x[k] = -round_up(-(child[0] - margin));
        row.min_y[k] = -round_up(-(child[1] - margin));
        row.max_x[k] = round_up(child[2] + margin);
        row.max_y[k] = round_up(child[3] + margin);
        bounds = join(bounds, *child);
    }
    (row, bounds)
}

/// To single precision, never smaller.
fn round_up(value: f64) -> f32 {
    let rounded = value as f32;
    if f64::from(rounded) < value { rounded.next_up() } else { rounded }
}
