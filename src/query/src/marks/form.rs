//! Courses of marks that are lines and arcs, on which the nearest place to a point is known at once.

use super::course::CoursePoint;
use glam::DVec2;
use std::f64::consts::PI;

/// Curvature `[1/m]` below which an arc is not told from a line: its centre is so far away that distances from it lose digits.
const LEAST_CURVATURE: f64 = 1e-4;
/// Turn `[rad]` up to which the middle of an arc is nearer to both its ends than what lies opposite.
const MOST_TURN: f64 = 0.9 * PI;

/// What a course is made of.
#[derive(Clone, Copy)]
pub(super) enum Form {
    Straight(Straight),
    Round(Round),
    /// Something else, on which the nearest place is looked for.
    Searched,
}

/// A line.
#[derive(Clone, Copy)]
pub(super) struct Straight {
    s: [f64; 2],
    start: DVec2,
    /// Way for a metre of s.
    along: DVec2,
    /// 1 / its squared length.
    inverse: f64,
    normal: DVec2,
}

/// An arc that turns by less than half a circle.
#[derive(Clone, Copy)]
pub(super) struct Round {
    s: [f64; 2],
    center: DVec2,
    radius: f64,
    /// Directions from the centre to both ends.
    ends: [DVec2; 2],
    /// Of the reference line.
    curvature: f64,
}

impl Straight {
    pub(super) fn new(start: DVec2, tangent: DVec2, growth: f64, s: [f64; 2]) -> Self {
        let normal = tangent.perp();
        let along = tangent + normal * growth;
        Self { s, start, along, inverse: along.length_squared().recip(), normal }
    }

    #[inline]
    fn gone(&self, local: DVec2) -> f64 {
        let gone = (local - self.start).dot(self.along) * self.inverse;
        mapd_geometry::clamp(gone, 0.0, self.s[1] - self.s[0])
    }
}

impl Round {
    /// The arc at an offset to the left of a reference line around a centre, between two normals of that line. None where that is not a plain arc.
    pub(super) fn new(
        center: DVec2,
        normals: [DVec2; 2],
        curvature: f64,
        offset: f64,
        s: [f64; 2],
    ) -> Option<Self> {
        let turn = (s[1] - s[0]) * curvature.abs();
        let radius = curvature.signum() * (1.0 / curvature - offset);
        // On the other side of the centre, or at it, the ends change places.
        if !(curvature.abs() >= LEAST_CURVATURE && turn <= MOST_TURN && radius > 0.0) {
            return None;
        }
        let ends = normals.map(|normal| -normal * curvature.signum());
        Some(Self { s, center, radius, ends, curvature })
    }

    /// The direction from the centre to the nearest place, if that is no end.
    #[inline]
    fn between(&self, away: DVec2) -> bool {
        let [first, last] = self.ends;
        let side = self.curvature.signum();
        side * first.perp_dot(away) >= 0.0 && side * away.perp_dot(last) >= 0.0
    }

    #[inline]
    fn nearer_end(&self, away: DVec2) -> usize {
        let [first, last] = self.ends;
        usize::from(away.dot(last) > away.dot(first))
    }
}

impl Form {
    /// Plan-view distance from a point, by which courses are compared; none where it has to be searched.
    #[inline]
    pub(super) fn distance(&self, local: DVec2) -> Option<f64> {
        match self {
            Self::Straight(line) => {
                Some((line.start + line.along * line.gone(local)).distance(local))
            }
            Self::Round(arc) => {
                let away = local - arc.center;
                Some(match arc.between(away) {
                    true => (away.length() - arc.radius).abs(),
                    false => (arc.ends[arc.nearer_end(away)] * arc.radius).distance(away),
                })
            }
            Self::Searched => None,
        }
    }

    /// The nearest place to a point; none where it has to be searched.
    pub(super) fn nearest(&self, local: DVec2) -> Option<CoursePoint> {
        match self {
            Self::Straight(line) => {
                let gone = line.gone(local);
                let place = line.start + line.along * gone;
                Some(CoursePoint { s: line.s[0] + gone, place, normal: line.normal })
            }
            Self::Round(arc) => {
                let away = local - arc.center;
                let (direction, s) = if arc.between(away) && away != DVec2::ZERO {
                    let [first, _] = arc.ends;
                    let turned = libm::atan2(first.perp_dot(away), first.dot(away));
                    let s = arc.s[0] + turned / arc.curvature;
                    (away / away.length(), mapd_geometry::clamp(s, arc.s[0], arc.s[1]))
                } else {
                    let end = arc.nearer_end(away);
                    (arc.ends[end], arc.s[end])
                };
                let place = arc.center + direction * arc.radius;
                Some(CoursePoint { s, place, normal: -direction * arc.curvature.signum() })
            }
            Self::Searched => None,
        }
    }
}
