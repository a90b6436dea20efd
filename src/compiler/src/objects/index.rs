//! Builds the packed spatial index over the places of objects.

use crate::index::round_up;
use crate::lanes::view;
use glam::DVec2;
use mapd_archive::{ObjectIndexNodeRow, Rows};
use mapd_query::{Map, ObjectPlacement};

/// Children of a node.
const WIDTH: usize = 16;
/// Relative rounding of single precision, doubled twice: coordinates are rounded once here and once in a query.
const ROUNDING: f64 = 4.0 * f32::EPSILON as f64;
/// Added to every box `[m]`: corners lie in single precision.
const MARGIN: f64 = 1e-3;

/// What a place covers, relative to the local origin.
#[derive(Clone, Copy)]
struct Entry {
    low: DVec2,
    high: DVec2,
    item: u32,
}

impl Entry {
    fn middle(&self, axis: usize) -> f64 {
        self.low[axis] + self.high[axis]
    }
}

/// Fills `object_index_levels`, `object_index_nodes` and `object_index_items`.
pub(crate) fn build(rows: &mut Rows) {
    let mut entries: Vec<Entry> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let origin = map.local_origin();
        let entry = |place: ObjectPlacement<'_>| {
            let bounds = place.bounds();
            Entry {
                low: bounds.low - origin - MARGIN,
                high: bounds.high - origin + MARGIN,
                item: place.item(),
            }
        };
        map.objects().flat_map(|object| object.placements()).map(entry).collect()
    };
    if entries.is_empty() {
        return;
    }
    order(&mut entries);
    rows.object_index_items = entries.iter().map(|entry| entry.item).collect::<Vec<_>>().into();
    let mut levels = Vec::new();
    let mut below: Vec<(DVec2, DVec2)> = entries.iter().map(|e| (e.low, e.high)).collect();
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
        rows.object_index_levels.push(first);
        first += nodes.len() as u32;
        rows.object_index_nodes.extend(nodes);
    }
    rows.object_index_levels.push(first);
}

/// Orders places so that consecutive sixteens lie close together, and sixteens of sixteens as well: halves along the longer
/// side at multiples of whole subtrees, as the lanes' index does. The order is total.
fn order(entries: &mut [Entry]) {
    if entries.len() <= WIDTH {
        entries.sort_by_key(|entry| entry.item);
        return;
    }
    let mut unit = WIDTH;
    while unit * WIDTH < entries.len() {
        unit *= WIDTH;
    }
    let middle = entries.len().div_ceil(unit) / 2 * unit;
    let spread = |axis: usize| {
        let low = entries.iter().map(|e| e.middle(axis)).fold(f64::INFINITY, f64::min);
        let high = entries.iter().map(|e| e.middle(axis)).fold(f64::NEG_INFINITY, f64::max);
        high - low
    };
    let axis = usize::from(spread(1) > spread(0));
    entries.select_nth_unstable_by(middle, |p, q| {
        p.middle(axis).total_cmp(&q.middle(axis)).then(p.item.cmp(&q.item))
    });
    let (left, right) = entries.split_at_mut(middle);
    rayon::join(|| order(left), || order(right));
}

/// A node over the boxes of its children.
fn node(children: &[(DVec2, DVec2)]) -> (ObjectIndexNodeRow, (DVec2, DVec2)) {
    // Empty boxes: nothing is near them, and every number stays finite.
    let mut row = ObjectIndexNodeRow {
        min_x: [f32::MAX; WIDTH],
        min_y: [f32::MAX; WIDTH],
        max_x: [f32::MIN; WIDTH],
        max_y: [f32::MIN; WIDTH],
    };
    let mut all = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for (k, (low, high)) in children.iter().enumerate().take(WIDTH) {
        let margin = low.abs().max(high.abs()).max_element() * ROUNDING;
        row.min_x[k] = finite(-round_up(-(low.x - margin)));
        row.min_y[k] = finite(-round_up(-(low.y - margin)));
        row.max_x[k] = finite(round_up(high.x + margin));
        row.max_y[k] = finite(round_up(high.y + margin));
        all = (all.0.min(*low), all.1.max(*high));
    }
    (row, all)
}

/// The nearest finite number: what lies beyond single precision is never near.
fn finite(value: f32) -> f32 {
    if value > f32::MIN { value.min(f32::MAX) } else { f32::MIN }
}
