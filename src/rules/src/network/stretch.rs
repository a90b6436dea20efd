//! Stretches between two cross-sections of a road, and how deep two of them overlap.

use super::Station;
use super::overlap::{CLEARANCE, TOUCH};
use super::stations::Heading;

/// A stretch between two cross-sections.
pub(super) struct Stretch {
    /// Rank of its road.
    pub(super) road: usize,
    /// Its middle `[m]`.
    pub(super) s: f64,
    /// Its height `[m]`.
    pub(super) z: f64,
    pub(super) corners: [[f64; 2]; 4],
}

/// What is kept of all stretches at once: enough to tell most pairs apart. The rest is computed again for those that are near.
pub(super) struct StretchSummary {
    /// Rank of its road.
    pub(super) road: u32,
    /// Number of the first of its two cross-sections.
    pub(super) station: u32,
    /// Its middle `[m]`.
    pub(super) s: f64,
    /// Its height `[m]`.
    pub(super) z: f64,
    /// Smallest x, smallest y, largest x, largest y `[m]`.
    pub(super) bounds: [f64; 4],
}

/// Smallest x, smallest y, largest x, largest y.
pub(super) fn bounds(corners: &[[f64; 2]; 4]) -> [f64; 4] {
    let [x, y] = corners[0];
    corners
        .iter()
        .fold([x, y, x, y], |b, [x, y]| [b[0].min(*x), b[1].min(*y), b[2].max(*x), b[3].max(*y)])
}

/// A cross-section, and where its ends lie: x, y `[m]`.
pub(super) struct CrossSection {
    pub(super) station: Station,
    pub(super) left: [f64; 2],
    pub(super) right: [f64; 2],
}

impl Stretch {
    pub(super) fn new(road: usize, a: &Station, b: &Station) -> Option<Self> {
        let mut heading = Heading::default();
        let [a, b] = [a, b].map(|station| {
            let [left, right] = station.ends(&mut heading);
            CrossSection { station: *station, left, right }
        });
        Self::between(road, &a, &b)
    }

    /// As [`Stretch::new`], where the ends of the cross-sections are known.
    pub(super) fn between(road: usize, from: &CrossSection, to: &CrossSection) -> Option<Self> {
        let (a, b) = (&from.station, &to.station);
        if a.left - a.right <= 2.0 * TOUCH {
            return None;
        }
        let corners = [from.right, from.left, to.left, to.right];
        corners.iter().flatten().all(|value| value.is_finite()).then_some(Self {
            road,
            s: (a.s + b.s) / 2.0,
            z: (a.z + b.z) / 2.0,
            corners,
        })
    }

    /// How wide it is where it is narrowest `[m]`: no other one overlaps it deeper.
    pub(super) fn width(&self) -> f64 {
        self.depth(self)
    }

    /// How deep two stretches overlap `[m]`; 0 or less where they do not. Corners are taken as those of convex areas.
    pub(super) fn depth(&self, other: &Self) -> f64 {
        let mut depth = f64::INFINITY;
        for corners in [&self.corners, &other.corners] {
            for edge in 0..4 {
                let ([ax, ay], [bx, by]) = (corners[edge], corners[(edge + 1) % 4]);
                let length = mapd_geometry::hypot(bx - ax, by - ay);
                if length <= 0.0 {
                    continue;
                }
                let normal = [(by - ay) / length, (ax - bx) / length];
                let range = |points: &[[f64; 2]; 4]| {
                    let along = points.map(|[x, y]| x * normal[0] + y * normal[1]);
                    let low = along.iter().copied().fold(f64::INFINITY, f64::min);
                    (low, along.iter().copied().fold(f64::NEG_INFINITY, f64::max))
                };
                let ((low_a, high_a), (low_b, high_b)) =
                    (range(&self.corners), range(&other.corners));
                depth = depth.min(high_a.min(high_b) - low_a.max(low_b));
            }
        }
        depth
    }
}

impl StretchSummary {
    /// Whether two stretches are not one above the other, and their boxes overlap by more than a touch.
    pub(super) fn is_near(&self, other: &Self) -> bool {
        let ([ax0, ay0, ax1, ay1], [bx0, by0, bx1, by1]) = (self.bounds, other.bounds);
        (self.z - other.z).abs() < CLEARANCE
            && ax0 + TOUCH < bx1
            && bx0 + TOUCH < ax1
            && ay0 + TOUCH < by1
            && by0 + TOUCH < ay1
    }
}
