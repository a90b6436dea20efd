//! Packs R-trees of 16 children a node, level by level: that over lanes, and those over places of objects and signals.

use glam::DVec2;
use mapd_archive::BoxNodeRow;
use mapd_archive::packed_index::WIDTH;
use rayon::prelude::*;

/// Entries that one task orders.
const TOGETHER: usize = 4096;
/// Relative rounding of single precision, doubled twice: coordinates are rounded once here and once in a query.
pub(crate) const ROUNDING: f64 = 4.0 * f32::EPSILON as f64;

/// What an item covers in plan view, relative to the local origin.
#[derive(Clone, Copy)]
pub(crate) struct Entry {
    pub(crate) low: DVec2,
    pub(crate) high: DVec2,
    pub(crate) item: u32,
}

/// A packed tree over items.
#[derive(Default)]
pub(crate) struct Packed {
    /// First node of each level, root first, then the number of nodes; empty without items.
    pub(crate) levels: Vec<u32>,
    pub(crate) nodes: Vec<BoxNodeRow>,
    pub(crate) items: Vec<u32>,
}

/// Packs items.
pub(crate) fn pack(entries: Vec<Entry>) -> Packed {
    if entries.is_empty() {
        return Packed::default();
    }
    let number = |(number, e): (usize, &Entry)| Key::new(e.low + e.high, number as u64);
    let numbers = ordered(entries.par_iter().enumerate().map(number).collect());
    let entries: Vec<Entry> = numbers.iter().map(|number| entries[*number as usize]).collect();
    let boxes = entries.iter().map(|e| (e.low, e.high)).collect();
    let (levels, nodes) = stack(boxes, node);
    Packed { levels, nodes, items: entries.iter().map(|entry| entry.item).collect() }
}

/// An entry while entries are ordered.
#[derive(Clone, Copy, bytemuck::Zeroable)]
pub(crate) struct Key {
    /// Twice the middle, as numbers that compare as the coordinates do.
    middle: [i64; 2],
    /// Number of the entry, which breaks ties.
    entry: u64,
}

impl Key {
    /// An entry by twice its middle.
    pub(crate) fn new(middle: DVec2, entry: u64) -> Self {
        Self { middle: middle.to_array().map(comparable), entry }
    }

    /// What entries are compared by along an axis: one number, so that no comparison takes a branch.
    fn along(&self, axis: usize) -> i128 {
        i128::from(self.middle[axis]) << u64::BITS | i128::from(self.entry)
    }
}

/// A number that compares as the coordinate does.
fn comparable(value: f64) -> i64 {
    let bits = value.to_bits() as i64;
    bits ^ ((bits >> 63) & i64::MAX)
}

/// The coordinate of such a number.
fn coordinate(comparable: i64) -> f64 {
    f64::from_bits((comparable ^ ((comparable >> 63) & i64::MAX)) as u64)
}

/// The keys of all parts in their order. What the parts need is freed, and memory for all is first touched, by all threads.
pub(crate) fn joined(parts: Vec<Vec<Key>>) -> Vec<Key> {
    let mut all = bytemuck::zeroed_vec(parts.iter().map(Vec::len).sum());
    let mut rest = all.as_mut_slice();
    let places = parts.into_iter().map(|part| {
        let place = rest.split_off_mut(..part.len()).unwrap_or_default();
        (place, part)
    });
    let places: Vec<_> = places.collect();
    places.into_par_iter().for_each(|(place, part)| place.copy_from_slice(&part));
    all
}

/// Entries so ordered that consecutive sixteens lie close together, and sixteens of sixteens as well. No two are equal.
pub(crate) fn ordered(mut keys: Vec<Key>) -> Vec<u64> {
    order(&mut keys);
    keys.par_iter().map(|key| key.entry).collect()
}

/// Halves along the longer side at multiples of whole subtrees. The order is total, so that the result does not depend on
/// how it is sorted.
fn order(keys: &mut [Key]) {
    let mut unit = WIDTH;
    while unit * WIDTH < keys.len() {
        unit *= WIDTH;
    }
    if keys.len() <= WIDTH {
        keys.sort_unstable_by_key(|key| key.entry);
        return;
    }
    let subtrees = keys.len().div_ceil(unit);
    let middle = subtrees / 2 * unit;
    let (mut low, mut high) = ([i64::MAX; 2], [i64::MIN; 2]);
    for key in keys.iter() {
        for axis in 0..2 {
            low[axis] = low[axis].min(key.middle[axis]);
            high[axis] = high[axis].max(key.middle[axis]);
        }
    }
    let spread = |axis: usize| coordinate(high[axis]) - coordinate(low[axis]);
    let axis = usize::from(spread(1) > spread(0));
    keys.select_nth_unstable_by_key(middle, |key| key.along(axis));
    let (left, right) = keys.split_at_mut(middle);
    if left.len() + right.len() < TOGETHER {
        order(left);
        order(right);
    } else {
        rayon::join(|| order(left), || order(right));
    }
}

/// Nodes over boxes, root first, and the first node of each level with the number of nodes behind the last.
pub(crate) fn stack<B: Send + Sync, R: Send>(
    mut below: Vec<B>,
    node: fn(&[B]) -> (R, B),
) -> (Vec<u32>, Vec<R>) {
    let mut levels = Vec::new();
    loop {
        let groups = below.par_chunks(WIDTH).with_min_len(TOGETHER / WIDTH);
        let (nodes, boxes): (Vec<_>, Vec<_>) = groups.map(node).unzip();
        let is_root = nodes.len() <= 1;
        levels.push(nodes);
        below = boxes;
        if is_root {
            break;
        }
    }
    let (mut starts, mut all) = (Vec::new(), Vec::new());
    for nodes in levels.into_iter().rev() {
        starts.push(all.len() as u32);
        all.extend(nodes);
    }
    starts.push(all.len() as u32);
    (starts, all)
}

/// A node over the boxes of its children.
fn node(children: &[(DVec2, DVec2)]) -> (BoxNodeRow, (DVec2, DVec2)) {
    // Empty boxes: nothing is near them, and every number stays finite.
    let mut row = BoxNodeRow {
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

/// To single precision, never smaller.
pub(crate) fn round_up(value: f64) -> f32 {
    let rounded = value as f32;
    if f64::from(rounded) < value { rounded.next_up() } else { rounded }
}
