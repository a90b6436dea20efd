//! Courses of marks that are lines and arcs, on which the nearest place to a point is known at once.

use super::course::CoursePoint;
use glam::DVec2;
use std::f64::consts::PI;

/// Turn `[rad]` up to which a point beside neither end is nearest to what lies between them.
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
    /// Both ends, and the directions of the line there.
    ends: [DVec2; 2],
    tangents: [DVec2; 2],
    /// Of the course `[1/m]`, positive to the left.
    curvature: f64,
    /// Of the reference line.
    line_curvature: f64,
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
    /// The arc at an offset to the left of a reference line, from its ends and directions there. None where that is not a plain arc.
    pub(super) fn new(
        ends: [DVec2; 2],
        tangents: [DVec2; 2],
        line_curvature: f64,
        offset: f64,
        s: [f64; 2],
    ) -> Option<Self> {
        let turn = (s[1] - s[0]) * line_curvature.abs();
        // On the other side of the centre it leads the other way.
        let share = 1.0 - line_curvature * offset;
        let curvature = line_curvature / share;
        let is_plain = share > 0.0 && turn <= MOST_TURN && curvature.is_finite();
        is_plain.then_some(Self { s, ends, tangents, curvature, line_curvature })
    }

    /// The end that is nearest, if not a place between them is.
    #[inline]
    fn end(&self, local: DVec2) -> Option<usize> {
        let [first, last] = self.ends.map(|end| local - end);
        let is_beside = first.dot(self.tangents[0]) >= 0.0 && last.dot(self.tangents[1]) <= 0.0;
        let end = usize::from(last.length_squared() < first.length_squared());
        (!is_beside).then_some(end)
    }

    /// Along the first end's direction and to its left, both from there to the point; then the direction from the centre to the point, and the point's
    /// distance from that, times the curvature.
    #[inline]
    fn seen_from_start(&self, local: DVec2) -> (DVec2, DVec2, f64) {
        let away = local - self.ends[0];
        let own = DVec2::new(away.dot(self.tangents[0]), self.tangents[0].perp_dot(away));
        let turned = DVec2::new(1.0 - self.curvature * own.y, self.curvature * own.x);
        (own, turned, turned.length())
    }

    /// How far to the left of the arc a point lies that is beside it: (1 − r) / κ without what cancels as κ falls to 0.
    #[inline]
    fn lateral(&self, own: DVec2, radius: f64) -> f64 {
        (2.0 * own.y - self.curvature * own.length_squared()) / (1.0 + radius)
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
            Self::Round(arc) => Some(match arc.end(local) {
                Some(end) => arc.ends[end].distance(local),
                None => {
                    let (own, _, radius) = arc.seen_from_start(local);
                    arc.lateral(own, radius).abs()
                }
            }),
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
                if let Some(end) = arc.end(local) {
                    let normal = arc.tangents[end].perp();
                    return Some(CoursePoint { s: arc.s[end], place: arc.ends[end], normal });
                }
                let (own, turned, radius) = arc.seen_from_start(local);
                let turn = libm::atan2(turned.y, turned.x);
                let s = arc.s[0] + turn / arc.line_curvature;
                // At the centre every direction is as good.
                let turned = if radius > 0.0 { turned / radius } else { DVec2::X };
                let normal = turned.rotate(arc.tangents[0].perp());
                let place = local - normal * arc.lateral(own, radius);
                Some(CoursePoint { s: mapd_geometry::clamp(s, arc.s[0], arc.s[1]), place, normal })
            }
            Self::Searched => None,
        }
    }
}
