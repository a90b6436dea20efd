//! Which corners of borders are one point: Lanelet2 knows no neighbours but those that share points.

use mapd_client::glam::DVec3;

/// Ends of lanes that follow each other become one point if they are at most this far apart `[m]`.
pub(super) const SNAP: f64 = 0.1;

/// Corners, put together to points.
pub(super) struct Joints {
    parents: Vec<u32>,
    /// The box around the corners of a point `[m]`.
    boxes: Vec<[DVec3; 2]>,
}

impl Joints {
    /// Each corner a point of its own.
    pub(super) fn new(corners: &[DVec3]) -> Self {
        Self {
            parents: (0..corners.len() as u32).collect(),
            boxes: corners.iter().map(|corner| [*corner; 2]).collect(),
        }
    }

    /// The number that all corners of one point have in common.
    pub(super) fn point(&self, corner: u32) -> u32 {
        let mut at = corner;
        while let Some(parent) = self.parents.get(at as usize).filter(|parent| **parent != at) {
            at = *parent;
        }
        at
    }

    /// Where a corner's point lies `[m]`: in the middle of all its corners, none of which is farther away than half of [`SNAP`].
    pub(super) fn place(&self, corner: u32) -> DVec3 {
        let around = self.boxes.get(self.point(corner) as usize);
        around.map_or(DVec3::NAN, |[low, high]| 0.5 * (*low + *high))
    }

    /// Diagonal of the box around both corners' points `[m]`.
    fn extent(&self, a: u32, b: u32) -> f64 {
        let around = |corner| self.boxes.get(self.point(corner) as usize);
        match (around(a), around(b)) {
            (Some([low, high]), Some([other_low, other_high])) => {
                (high.max(*other_high) - low.min(*other_low)).length()
            }
            _ => f64::NAN,
        }
    }

    /// Makes each pair one point and returns whether all are; where a corner would move by more than half of [`SNAP`], none is, or
    /// that pair is not.
    pub(super) fn join(&mut self, pairs: &[(u32, u32)]) -> bool {
        pairs.iter().all(|(a, b)| self.fits(*a, *b))
            && pairs.iter().fold(true, |all, (a, b)| self.join_one(*a, *b) && all)
    }

    fn fits(&self, a: u32, b: u32) -> bool {
        self.point(a) == self.point(b) || self.extent(a, b) <= SNAP
    }

    fn join_one(&mut self, a: u32, b: u32) -> bool {
        if !self.fits(a, b) {
            return false;
        }
        let (a, b) = (self.point(a), self.point(b));
        let (kept, gone) = (a.min(b), a.max(b));
        if let (Some([low, high]), true) = (self.boxes.get(gone as usize).copied(), a != b) {
            if let Some(around) = self.boxes.get_mut(kept as usize) {
                *around = [around[0].min(low), around[1].max(high)];
            }
            if let Some(parent) = self.parents.get_mut(gone as usize) {
                *parent = kept;
            }
        }
        true
    }
}
