//! Boxes in a packed R-tree of 16 children a node, flattened level by level: what may meet a rectangle.

use glam::DVec2;
use mapd_archive::ArchivedBoxNodeRow;
use mapd_archive::packed_index::{LEVELS, WIDTH};

/// Places on the search stack: 15 siblings on each of these levels and some more.
const STACK: usize = 160;

/// Smallest x and y, largest x and y of a node's children, relative to the local origin `[m]`.
pub(crate) type Boxes<'a> = [&'a [f32; WIDTH]; 4];

/// The levels of a packed tree.
#[derive(Clone, Copy)]
pub(crate) struct Levels<'a> {
    /// First node of each level, root first, then the number of nodes.
    pub(crate) starts: &'a [u32],
    /// Number of nodes and places: of a damaged archive no more are visited.
    pub(crate) most: usize,
}

/// An index over places as it lies in the archive.
#[derive(Clone, Copy)]
pub(crate) struct PackedIndex<'a> {
    /// First node of each level, root first, then the number of nodes.
    pub(crate) levels: &'a [u32],
    /// The nodes, level by level.
    pub(crate) nodes: &'a [ArchivedBoxNodeRow],
    /// What lies below the last level.
    pub(crate) items: &'a [u32],
}

/// Visits the number of every place below the last level whose box meets a box (smallest and largest coordinates, relative
/// to the local origin). `node` gives the boxes of a row.
pub(crate) fn visit_box<'a>(
    Levels { starts, most }: Levels<'_>,
    node: impl Fn(usize) -> Option<Boxes<'a>>,
    [low, high]: [DVec2; 2],
    mut visit: impl FnMut(u32),
) {
    let depth = starts.len().checked_sub(1).filter(|depth| (1..=LEVELS).contains(depth));
    let Some(depth) = depth else { return };
    let mut stack = [(0u32, 0u32); STACK];
    let (mut top, mut visited) = (1, 0);
    while top > 0 && visited < most {
        (top, visited) = (top - 1, visited + 1);
        let Some((level, at)) = stack.get(top).copied() else { return };
        if level as usize >= depth {
            visit(at);
            continue;
        }
        let first = starts.get(level as usize).copied().unwrap_or(0);
        let Some(boxes) = node(first.wrapping_add(at) as usize) else { continue };
        let [min_x, min_y, max_x, max_y] = boxes;
        for k in 0..WIDTH {
            // A place without a child has an empty box, which meets nothing, however large the region.
            let apart = min_x[k] > max_x[k]
                || f64::from(min_x[k]) > high.x
                || f64::from(max_x[k]) < low.x
                || f64::from(min_y[k]) > high.y
                || f64::from(max_y[k]) < low.y;
            if apart {
                continue;
            }
            let Some(place) = stack.get_mut(top) else { return };
            *place = (level + 1, at.wrapping_mul(WIDTH as u32).wrapping_add(k as u32));
            top += 1;
        }
    }
}

/// Visits every item of an index over places whose box meets a box, as [`visit_box`].
pub(crate) fn visit_items(
    PackedIndex { levels, nodes, items }: PackedIndex<'_>,
    region: [DVec2; 2],
    mut visit: impl FnMut(u32),
) {
    let node = |row: usize| {
        let node = nodes.get(row)?;
        Some([node.min_x(), node.min_y(), node.max_x(), node.max_y()])
    };
    let levels = Levels { starts: levels, most: nodes.len() + items.len() };
    visit_box(levels, node, region, |at| {
        items.get(at as usize).copied().into_iter().for_each(&mut visit);
    });
}
