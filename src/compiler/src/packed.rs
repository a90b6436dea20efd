//! Packs R-trees of 16 children a node, level by level: that over lanes, and those over places of objects and signals.

use glam::DVec2;
use mapd_archive::BoxNodeRow;

/// Children of a node.
pub(crate) const WIDTH: usize = 16;
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
pub(crate) fn pack(mut entries: Vec<Entry>) -> Packed {
    if entries.is_empty() {
        return Packed::default();
    }
    order(&mut entries, |e, axis| e.low[axis] + e.high[axis], |e| e.item);
    let boxes = entries.iter().map(|e| (e.low, e.high)).collect();
    let (levels, nodes) = stack(boxes, node);
    Packed { levels, nodes, items: entries.iter().map(|entry| entry.item).collect() }
}

/// Orders entries so that consecutive sixteens lie close together, and sixteens of sixteens as well: halves along the
/// longer side of their middles at multiples of whole subtrees. `key` makes the order total, so that the result does not
/// depend on how it is sorted.
pub(crate) fn order<T: Send, K: Ord>(
    entries: &mut [T],
    middle: fn(&T, usize) -> f64,
    key: fn(&T) -> K,
) {
    if entries.len() <= WIDTH {
        entries.sort_by_key(key);
        return;
    }
    let mut unit = WIDTH;
    while unit * WIDTH < entries.len() {
        unit *= WIDTH;
    }
    let half = entries.len().div_ceil(unit) / 2 * unit;
    let spread = |axis: usize| {
        let low = entries.iter().map(|e| middle(e, axis)).fold(f64::INFINITY, f64::min);
        let high = entries.iter().map(|e| middle(e, axis)).fold(f64::NEG_INFINITY, f64::max);
        high - low
    };
    let axis = usize::from(spread(1) > spread(0));
    entries.select_nth_unstable_by(half, |p, q| {
        middle(p, axis).total_cmp(&middle(q, axis)).then_with(|| key(p).cmp(&key(q)))
    });
    let (left, right) = entries.split_at_mut(half);
    rayon::join(|| order(left, middle, key), || order(right, middle, key));
}

/// Nodes over boxes, root first, and the first node of each level with the number of nodes behind the last.
pub(crate) fn stack<B, R>(mut below: Vec<B>, node: fn(&[B]) -> (R, B)) -> (Vec<u32>, Vec<R>) {
    let mut levels = Vec::new();
    loop {
        let (nodes, boxes): (Vec<_>, Vec<_>) = below.chunks(WIDTH).map(node).unzip();
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
