//! Boxes in a packed R-tree of 16 children a node, flattened level by level: what may meet a rectangle.

use glam::DVec2;
use mapd_archive::ArchivedBoxNodeRow;
use mapd_archive::packed_index::{LEVELS, WIDTH};

/// Places on the search stack: 15 siblings on each of these levels and some more.
const STACK: usize = 160;

/// Smallest x and y, largest x and y of a node's children, relative to the local origin `[m]`.
pub(crate) type Boxes<'a> = [&'a [f32; WIDTH]; 4];

/// Visits the number of every place below the last level whose box meets a box (smallest and largest coordinates, relative
/// to the local origin). `levels` are the first nodes of each level and the number of nodes, `node` gives the boxes of a row.
/// `most` is the number of nodes and places: of a damaged archive no more are visited.
pub(crate) fn visit_box<'a>(
    (levels, most): (&[u32], usize),
    node: impl Fn(usize) -> Option<Boxes<'a>>,
    [low, high]: [DVec2; 2],
    mut visit: impl FnMut(u32),
) {
    let depth = levels.len().checked_sub(1).filter(|depth| (1..=LEVELS).contains(depth));
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
        let first = levels.get(level as usize).copied().unwrap_or(0);
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
    (levels, nodes, items): (&[u32], &[ArchivedBoxNodeRow], &[u32]),
    region: [DVec2; 2],
    mut visit: impl FnMut(u32),
) {
    let node = |row: usize| {
        let node = nodes.get(row)?;
        Some([node.min_x(), node.min_y(), node.max_x(), node.max_y()])
    };
    visit_box((levels, nodes.len() + items.len()), node, region, |at| {
        items.get(at as usize).copied().into_iter().for_each(&mut visit);
    });
}
