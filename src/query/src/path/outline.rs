//! The room along a path as one polygon.

use super::Corridor;
use super::boxes::Extent;
use glam::{DVec2, DVec3};
use std::ops::Range;

/// Which edges bound the outline of a [`Corridor`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum CorridorEdges {
    /// Those of the driven lane.
    Driven,
    /// Those of all lanes beside it that have its direction and are open to the vehicle.
    Open,
}

impl Corridor {
    /// The room as one polygon in plan view `[m]`: along the left edges, then back along the right ones, counter-clockwise where it is
    /// simple and driven forwards, without the first point again at its end. Points that repeat the one before are left out. Whether
    /// it is simple, that is, no two of its sides meet but neighbours in their common end: it is where the path does not meet itself and
    /// bends less than the lanes' edges allow (|κ| times the distance of either edge below 1), and fails to be where it jumps
    /// over more than its width. `out` is emptied first; it grows only if its capacity is too small.
    pub fn outline(&self, edges: CorridorEdges, out: &mut Vec<DVec2>) -> bool {
        out.clear();
        let (left, right) = match edges {
            CorridorEdges::Driven => (&self.left, &self.right),
            CorridorEdges::Open => (&self.outer_left, &self.outer_right),
        };
        // Forwards on the right and back on the left has the room on its left.
        let points = right.iter().chain(left.iter().rev()).map(|point: &DVec3| point.truncate());
        for point in points {
            if out.last() != Some(&point) {
                out.push(point);
            }
        }
        while out.len() > 1 && out.first() == out.last() {
            out.pop();
        }
        out.len() > 2 && !meets_itself(out, 0..out.len())
    }
}

/// Whether two of these sides of a ring meet other than as neighbours; side `i` leads from point `i` to the next.
fn meets_itself(ring: &[DVec2], sides: Range<usize>) -> bool {
    if sides.len() < 2 {
        return false;
    }
    let middle = sides.start + sides.len() / 2;
    let (a, b) = (sides.start..middle, middle..sides.end);
    meets_itself(ring, a.clone()) || meets_itself(ring, b.clone()) || meet(ring, a, b)
}

/// Whether a side of one range meets one of another, which lies behind it.
fn meet(ring: &[DVec2], a: Range<usize>, b: Range<usize>) -> bool {
    let extent = |sides: &Range<usize>| {
        Extent::of((sides.start..=sides.end).filter_map(|i| ring.get(i % ring.len()).copied()))
    };
    if a.is_empty() || b.is_empty() || !extent(&a).meets(&extent(&b)) {
        return false;
    }
    if a.len() == 1 && b.len() == 1 {
        return sides_meet(ring, a.start, b.start);
    }
    if a.len() >= b.len() {
        let middle = a.start + a.len() / 2;
        meet(ring, a.start..middle, b.clone()) || meet(ring, middle..a.end, b)
    } else {
        let middle = b.start + b.len() / 2;
        meet(ring, a.clone(), b.start..middle) || meet(ring, a, middle..b.end)
    }
}

fn sides_meet(ring: &[DVec2], i: usize, j: usize) -> bool {
    let at = |i: usize| ring.get(i % ring.len()).copied().unwrap_or_default();
    let (a, b, c, d) = (at(i), at(i + 1), at(j), at(j + 1));
    // Neighbours share a point; they meet otherwise only where the ring turns back on itself.
    let back = |before: DVec2, common: DVec2, behind: DVec2| {
        let (x, y) = (before - common, behind - common);
        x.perp_dot(y) == 0.0 && x.dot(y) > 0.0
    };
    if i + 1 == j {
        return back(a, b, d);
    }
    if (j + 1) % ring.len() == i {
        return back(c, a, b);
    }
    let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    let (of_a, of_b) = (side(c, d, a), side(c, d, b));
    let (of_c, of_d) = (side(a, b, c), side(a, b, d));
    if of_a == 0.0 && of_b == 0.0 && of_c == 0.0 && of_d == 0.0 {
        // On one line: their extents decide.
        return Extent::of([a, b]).meets(&Extent::of([c, d]));
    }
    let apart = |x: f64, y: f64| (x > 0.0 && y > 0.0) || (x < 0.0 && y < 0.0);
    !apart(of_a, of_b) && !apart(of_c, of_d)
}
