//! The density of a pose, and its integral along a line across a lane.

use super::MatchError;
use glam::{DMat2, DMat3, DVec2, DVec3};
use mapd_geometry::normalize_angle;
use std::f64::consts::{FRAC_1_SQRT_2, PI, TAU};

/// Standard deviation of the map itself `[m]`, added to every pose's: nothing is known more exactly, and it lets a pose be exact.
pub(super) const MAP_DEVIATION: f64 = 1e-3;
/// As [`MAP_DEVIATION`], of directions `[rad]`.
const MAP_HEADING_DEVIATION: f64 = 1e-4;
/// Deviations out to which lanes count: what lies beyond has 1.5e-8 of a position's probability.
pub(super) const REACH: f64 = 6.0;
/// Deviation of the heading `[rad]` from which on every direction is equally probable, within 1e-5 of it.
const UNKNOWN_HEADING: f64 = 5.0;
/// Density of a heading of which nothing is known `[1/rad]`.
pub(super) const ANY_HEADING: f64 = 1.0 / TAU;

/// A line across a lane: places `foot + normal·l` with l between `low` and `high`, from the pose's position `[m]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct CrossLine {
    pub(super) foot: DVec2,
    /// Unit vector to the left of the reference line.
    pub(super) normal: DVec2,
    /// Direction of the reference line, as the lane is driven `[rad]`.
    pub(super) direction: f64,
    /// Of the reference line `[1/m]`: at l, a metre of s is 1 − κ·l long.
    pub(super) curvature: f64,
    pub(super) low: f64,
    pub(super) high: f64,
}

impl CrossLine {
    /// Unit vector along the reference line.
    pub(super) fn tangent(&self) -> DVec2 {
        DVec2::new(self.normal.y, -self.normal.x)
    }

    /// Without what lies beyond the centre of curvature: there is no area of this s.
    #[inline]
    pub(super) fn within_curvature(&self) -> Self {
        let mut line = *self;
        if line.curvature > 0.0 {
            line.high = line.high.min(1.0 / line.curvature);
        } else if line.curvature < 0.0 {
            line.low = line.low.max(1.0 / line.curvature);
        }
        line
    }
}

/// The normal density of (x, y, heading) relative to a pose's place; headings a turn apart are one.
#[derive(Clone, Copy, Debug)]
pub(super) struct PoseDensity {
    heading: f64,
    heading_deviation: f64,
    /// Inverse of the covariance, of (x, y, heading) and of (x, y).
    precision: DMat3,
    plane: DMat2,
    /// Density at the mean, of either `[1/(m²·rad)]`, `[1/m²]`.
    peak: f64,
    plane_peak: f64,
    /// How far lanes count `[m]`.
    pub(super) reach: f64,
}

impl PoseDensity {
    /// Errors: variances so large that their product is no number.
    pub(super) fn new(
        heading: f64,
        covariance: &DMat3,
        drive_deviation: f64,
    ) -> Result<Self, MatchError> {
        let place = MAP_DEVIATION * MAP_DEVIATION;
        let turn =
            MAP_HEADING_DEVIATION * MAP_HEADING_DEVIATION + drive_deviation * drive_deviation;
        let spread = *covariance + DMat3::from_diagonal(DVec3::new(place, place, turn));
        let flat = DMat2::from_cols(spread.x_axis.truncate(), spread.y_axis.truncate());
        let (a, b, d) = (flat.x_axis.x, flat.x_axis.y, flat.y_axis.y);
        let largest = 0.5 * (a + d) + libm::hypot(0.5 * (a - d), b);
        let heading_deviation = spread.z_axis.z.sqrt();
        let precision = spread.inverse();
        let plane = flat.inverse();
        let peak = 1.0 / (TAU * TAU.sqrt() * spread.determinant().sqrt());
        let plane_peak = 1.0 / (TAU * flat.determinant().sqrt());
        let unknown = heading_deviation >= UNKNOWN_HEADING;
        let sound = plane.is_finite() && plane_peak.is_finite() && largest.is_finite();
        if !sound || !(unknown || precision.is_finite() && peak.is_finite()) {
            return Err(MatchError::Determinant);
        }
        let reach = REACH * largest.sqrt();
        Ok(Self { heading, heading_deviation, precision, plane, peak, plane_peak, reach })
    }

    fn knows_heading(&self) -> bool {
        self.heading_deviation < UNKNOWN_HEADING
    }

    /// Mahalanobis distance of a place, relative to the pose's, with a direction.
    pub(super) fn distance(&self, away: DVec2, direction: f64) -> f64 {
        if !self.knows_heading() {
            return away.dot(self.plane * away).max(0.0).sqrt();
        }
        let error = away.extend(normalize_angle(direction - self.heading));
        error.dot(self.precision * error).max(0.0).sqrt()
    }

    /// Deviation `[m]` along a line that runs in a direction, bends by `curvature` and passes `stretch` of its s.
    pub(super) fn deviation_along(&self, tangent: DVec2, stretch: f64, curvature: f64) -> f64 {
        let step = tangent * stretch;
        let square = match self.knows_heading() {
            true => step.extend(curvature).dot(self.precision * step.extend(curvature)),
            false => step.dot(self.plane * step),
        };
        1.0 / square.sqrt()
    }

    /// Inverse of the position's covariance given the heading, and by how much its mean moves with a direction that differs from the pose's
    /// heading `[m/rad]`.
    pub(super) fn given_heading(&self) -> (DMat2, DVec2) {
        if !self.knows_heading() {
            return (self.plane, DVec2::ZERO);
        }
        let [x, y, turn] = [self.precision.x_axis, self.precision.y_axis, self.precision.z_axis];
        let own = DMat2::from_cols(x.truncate(), y.truncate());
        (own, -(own.inverse() * turn.truncate()))
    }

    /// Deviation of the heading `[rad]`, if anything is known of it.
    pub(super) fn known_deviation(&self) -> Option<f64> {
        self.knows_heading().then_some(self.heading_deviation)
    }

    /// The least turn `[rad]` that leads from the pose's heading to a direction; 0 where nothing is known of it.
    pub(super) fn turn_to(&self, direction: f64) -> f64 {
        if self.knows_heading() { normalize_angle(direction - self.heading) } else { 0.0 }
    }

    /// Tells of every turn that leads from the pose's heading to a direction, with its density.
    pub(super) fn each_turn(&self, direction: f64, mut tell: impl FnMut(f64, f64)) {
        if !self.knows_heading() {
            return tell(ANY_HEADING, 0.0);
        }
        let turn = normalize_angle(direction - self.heading);
        let limit = REACH * self.heading_deviation;
        let turns = ((limit + PI) / TAU).floor() as i32;
        for whole in -turns..=turns {
            let turn = turn + f64::from(whole) * TAU;
            if turn.abs() <= limit {
                let z = turn / self.heading_deviation;
                tell(libm::exp(-0.5 * z * z) / (TAU.sqrt() * self.heading_deviation), turn);
            }
        }
    }

    /// Integral of the density times 1 − κ·l along a line across.
    pub(super) fn integral(&self, line: &CrossLine) -> f64 {
        let line = line.within_curvature();
        // Also where one is no number.
        let has_area = line.low < line.high;
        if !has_area {
            return 0.0;
        }
        if !self.knows_heading() {
            let (across, away) = (self.plane * line.normal, self.plane * line.foot);
            let square = [line.normal.dot(across), line.foot.dot(across), line.foot.dot(away)];
            return self.plane_peak * ANY_HEADING * normal_between(square, &line);
        }
        let turn = normalize_angle(line.direction - self.heading);
        let across = self.precision * line.normal.extend(0.0);
        let limit = REACH * self.heading_deviation;
        // Headings that differ by whole turns are one: all that matter are added.
        let turns = ((limit + PI) / TAU).floor() as i32;
        let mut sum = 0.0;
        for whole in -turns..=turns {
            let turn = turn + f64::from(whole) * TAU;
            if whole != 0 && turn.abs() > limit {
                continue;
            }
            let away = line.foot.extend(turn);
            let square = [
                line.normal.extend(0.0).dot(across),
                away.dot(across),
                away.dot(self.precision * away),
            ];
            sum += normal_between(square, &line);
        }
        self.peak * sum
    }
}

/// ∫ (1 − κ·l) exp(−(a·l² + 2b·l + c)/2) dl along a line.
fn normal_between([a, b, c]: [f64; 3], line: &CrossLine) -> f64 {
    let middle = -b / a;
    let height = libm::exp(-0.5 * (c + b * middle).max(0.0));
    if height == 0.0 {
        return 0.0;
    }
    let scale = a.sqrt();
    let [low, high] = [line.low, line.high].map(|l| (l - middle) * scale);
    let mass = TAU.sqrt() / scale * share_between(low, high);
    let bell = |x: f64| libm::exp(-0.5 * x * x);
    let lean = line.curvature / a * (bell(high) - bell(low));
    // Of a line that ends at the centre of curvature rounding may leave less than nothing.
    height * ((1.0 - line.curvature * middle) * mass + lean).max(0.0)
}

/// Share of the standard normal distribution between two values, exact in its tails as well.
pub(super) fn share_between(low: f64, high: f64) -> f64 {
    let beyond = |x: f64| 0.5 * libm::erfc(x * FRAC_1_SQRT_2);
    if low >= 0.0 {
        beyond(low) - beyond(high)
    } else if high <= 0.0 {
        beyond(-high) - beyond(-low)
    } else {
        1.0 - beyond(-low) - beyond(high)
    }
}
