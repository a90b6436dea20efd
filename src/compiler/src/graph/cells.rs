//! Quadrangles that lanes are cut into, and whether two of them share more than a strip.

use glam::DVec2;
use std::cell::OnceCell;

/// Areas that share a strip of at most this width `[m]` only touch: lanes side by side share their border.
const STRIP: f64 = 0.05;

/// A rectangle along the axes.
#[derive(Clone, Copy)]
pub(super) struct Bounds {
    low: DVec2,
    high: DVec2,
}

impl Bounds {
    /// Around nothing: it meets no other.
    pub(super) const NONE: Self = Self { low: DVec2::INFINITY, high: DVec2::NEG_INFINITY };

    fn of(points: &[DVec2; 4]) -> Self {
        points
            .iter()
            .fold(Self::NONE, |all, p| Self { low: all.low.min(*p), high: all.high.max(*p) })
    }

    /// Around both.
    pub(super) fn with(&self, other: &Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    #[inline]
    pub(super) fn meets(&self, other: &Self) -> bool {
        // All of it at once: what is near is as likely to miss along one axis as along the other.
        (self.low.x <= other.high.x)
            & (self.high.x >= other.low.x)
            & (self.low.y <= other.high.y)
            & (self.high.y >= other.low.y)
    }
}

/// A side of a quadrangle: the direction across it, and from where to where the quadrangle reaches in that direction.
#[derive(Clone, Copy)]
struct Side {
    normal: DVec2,
    reach: (f64, f64),
}

/// A quadrangle of a lane's area.
pub(super) struct Cell {
    corners: [DVec2; 4],
    /// Its sides but those that are too short to have a direction; each is computed when it is first asked for.
    sides: [OnceCell<Option<Side>>; 4],
    pub(super) z: f64,
    /// From the section's start.
    pub(super) s_from: f32,
    pub(super) s_to: f32,
}

impl Cell {
    /// Between two cross-sections, each from its inner to its outer end; at a height `[m]`, from one s to another.
    pub(super) fn new([a, b]: [[DVec2; 2]; 2], z: f64, [s_from, s_to]: [f32; 2]) -> Self {
        let corners = [a[0], a[1], b[1], b[0]];
        Self { corners, sides: [const { OnceCell::new() }; 4], z, s_from, s_to }
    }

    pub(super) fn bounds(&self) -> Bounds {
        Bounds::of(&self.corners)
    }

    fn side(&self, i: usize) -> Option<Side> {
        *self.sides.get(i)?.get_or_init(|| side(&self.corners, i))
    }

    /// Middle of the cross-sections at both ends.
    fn center(&self) -> [DVec2; 2] {
        let [a, b, c, d] = self.corners;
        [0.5 * (a + b), 0.5 * (c + d)]
    }

    /// Whether two convex quadrangles share more than a strip: no edge's normal keeps them apart. `hint` is the edge that kept
    /// apart those before, which are likely to lie alike: the first one's, then the other's.
    pub(super) fn overlaps(&self, other: &Self, hint: &mut usize) -> bool {
        let apart = |at: usize| {
            let (own, other) = if at < 4 { (self, other) } else { (other, self) };
            own.side(at % 4).is_some_and(|side| {
                let other = reach(&other.corners, side.normal);
                side.reach.1.min(other.1) - side.reach.0.max(other.0) <= STRIP
            })
        };
        if apart(*hint) {
            return false;
        }
        match (0..8).find(|at| at != hint && apart(*at)) {
            Some(at) => {
                *hint = at;
                false
            }
            None => true,
        }
    }

    /// Whether the centre lines of two cells cross.
    pub(super) fn centers_cross(&self, other: &Self) -> bool {
        let ([a0, a1], [b0, b1]) = (self.center(), other.center());
        let side = |from: DVec2, to: DVec2, p: DVec2| (to - from).perp_dot(p - from);
        side(a0, a1, b0) * side(a0, a1, b1) <= 0.0 && side(b0, b1, a0) * side(b0, b1, a1) <= 0.0
    }
}

/// The side behind a corner; none where it is too short to have a direction.
fn side(corners: &[DVec2; 4], i: usize) -> Option<Side> {
    let edge = corners[(i + 1) % 4] - corners[i % 4];
    let length = edge.length();
    let normal = DVec2::new(-edge.y, edge.x) / length;
    (length >= STRIP).then(|| Side { normal, reach: reach(corners, normal) })
}

/// From where to where a quadrangle reaches along an axis.
#[inline]
fn reach(corners: &[DVec2; 4], axis: DVec2) -> (f64, f64) {
    let along = corners.map(|corner| corner.dot(axis));
    let (low, high) = (f64::INFINITY, f64::NEG_INFINITY);
    along.into_iter().fold((low, high), |(low, high), d| {
        (if d < low { d } else { low }, if d > high { d } else { high })
    })
}
