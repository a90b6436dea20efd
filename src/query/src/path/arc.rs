//! A span as a circle or a straight line.

use glam::DVec2;

/// Less curved is straight `[1/m]`: over the longest span a nanometre.
const STRAIGHT: f64 = 1e-12;
/// Nearness to the centre, as a share of the radius, below which a foot is not taken from the circle.
const MIN_ROOM: f64 = 0.2;
/// Tangents up to this have their angle by its series, to the last digits.
const SMALL: f64 = 0.04;

/// The circle, or straight line, with the ends and the turn of a span.
#[derive(Clone, Copy, Default)]
pub(super) struct Arc {
    /// Its place halfway.
    middle: DVec2,
    /// Its direction there.
    way: DVec2,
    curvature: f64,
    length: f64,
    ends: [DVec2; 2],
    /// Cosine and sine of half the turn.
    half: DVec2,
    /// Whether the span is this arc, to a nanometre.
    pub(super) is_exact: bool,
}

/// The place of an arc that is nearest to a point.
pub(super) struct Near {
    /// From its start `[m]`.
    pub(super) gone: f64,
    pub(super) distance: f64,
    /// Of the point from the place, ahead and to the left `[m]`.
    pub(super) ahead: f64,
    pub(super) d: f64,
    /// Direction there.
    pub(super) way: DVec2,
}

impl Arc {
    pub(super) fn new([a, b]: [DVec2; 2], length: f64, turn: f64) -> Self {
        let way = (b - a).normalize_or(DVec2::X);
        let (cos, sin) = mapd_geometry::cos_sin(0.5 * turn);
        // The chord lies beside the arc's middle, towards the centre; 1 − cos without cancellation.
        let curvature = turn / length;
        let bow =
            if curvature.abs() < STRAIGHT { 0.0 } else { sin * sin / (1.0 + cos) / curvature };
        let middle = 0.5 * (a + b) - way.perp() * bow;
        let half = DVec2::new(cos, sin);
        Self { middle, way, curvature, length, ends: [a, b], half, is_exact: false }
    }

    /// The place at a distance from the start.
    pub(super) fn at(&self, gone: f64) -> DVec2 {
        let half = 0.5 * self.curvature * (gone - 0.5 * self.length);
        let (cos, sin) = mapd_geometry::cos_sin(half);
        let chord = if half == 0.0 { gone - 0.5 * self.length } else { 2.0 * sin / self.curvature };
        self.middle + self.way.rotate(DVec2::new(cos, sin)) * chord
    }

    /// About where the foot of a point is, from the start; not within the arc's ends.
    pub(super) fn guess(&self, local: DVec2) -> f64 {
        let away = local - self.middle;
        let room = (1.0 - self.curvature * self.way.perp_dot(away)).max(MIN_ROOM);
        0.5 * self.length + away.dot(self.way) / room
    }

    /// The nearest place; none for a point near the centre or beyond.
    pub(super) fn nearest(&self, local: DVec2) -> Option<Near> {
        let away = local - self.middle;
        let (ahead, d) = (away.dot(self.way), self.way.perp_dot(away));
        let k = self.curvature;
        let room = 1.0 - k * d;
        if room < MIN_ROOM {
            return None;
        }
        let tangent = ahead * k / room;
        let from_middle = if tangent.abs() < SMALL {
            let squared = tangent * tangent;
            let series = 1.0 - squared * (1.0 / 3.0 - squared * (0.2 - squared / 7.0));
            ahead / room * series
        } else {
            mapd_geometry::atan2(ahead * k, room) / k
        };
        let half = 0.5 * self.length;
        if from_middle.abs() <= half {
            // The distance from the centre is `reach` radii.
            let reach = (room * room + ahead * k * ahead * k).sqrt();
            let d = (2.0 * d - k * (d * d + ahead * ahead)) / (1.0 + reach);
            let way = self.way.rotate(DVec2::new(room, ahead * k) / reach);
            return Some(Near { gone: half + from_middle, distance: d.abs(), ahead: 0.0, d, way });
        }
        let is_end = from_middle > 0.0;
        let turned = if is_end { self.half } else { DVec2::new(self.half.x, -self.half.y) };
        let way = self.way.rotate(turned);
        let away = local - self.ends[usize::from(is_end)];
        let (ahead, d) = (away.dot(way), way.perp_dot(away));
        let gone = if is_end { self.length } else { 0.0 };
        Some(Near { gone, distance: away.length(), ahead, d, way })
    }
}
