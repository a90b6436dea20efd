//! Polylines as they lie in the archive.

use glam::DVec3;
use mapd_archive::ArchivedPointRow;

/// A polyline of bounded error, borrowed from the archive: points relative to an origin in double precision.
#[derive(Clone, Copy)]
pub struct Polyline<'a> {
    /// Inertial position that the points are relative to `[m]`.
    pub origin: DVec3,
    /// s of the section's start, to which the points' s is relative `[m]`.
    pub s_start: f64,
    /// The points in ascending s, as stored.
    pub points: &'a [ArchivedPointRow],
}

impl<'a> Polyline<'a> {
    /// Number of points.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there are no points (lane 0 has no centre line).
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Inertial position of a point `[m]`.
    pub fn position(&self, i: usize) -> Option<DVec3> {
        self.points.get(i).map(|p| at(self.origin, p))
    }

    /// s of the points on the road `[m]`.
    pub fn stations(&self) -> impl ExactSizeIterator<Item = f64> + use<'a> {
        let s_start = self.s_start;
        self.points.iter().map(move |p| s_start + f64::from(p.s()))
    }

    /// Inertial positions in ascending s `[m]`.
    pub fn positions(&self) -> impl ExactSizeIterator<Item = DVec3> + use<'a> {
        let origin = self.origin;
        self.points.iter().map(move |p| at(origin, p))
    }
}

fn at(origin: DVec3, p: &ArchivedPointRow) -> DVec3 {
    origin + DVec3::new(f64::from(p.x()), f64::from(p.y()), f64::from(p.z()))
}
