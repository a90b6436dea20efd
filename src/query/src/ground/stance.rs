//! How a vehicle stands on the ground below its wheels.

use super::GroundScratch;
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::map::Map;
use crate::matching::VehiclePose;
use crate::types::Point;
use glam::{DMat3, DVec2, DVec3};
use mapd_geometry::cos_sin;

/// Wheels with ground below them that make a plane.
const FEWEST_WHEELS: usize = 3;
/// Square of the area that the wheels span, as a share of the fourth power of their largest distance, below which they stand in a line.
const LINE: f64 = 1e-6;

/// How a vehicle stands.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stance {
    /// Height of the ground's plane below the vehicle's reference point `[m]`.
    pub z: f64,
    /// Roll `[rad]`; positive lifts the left side (ISO 8855).
    pub roll: f64,
    /// Pitch `[rad]`; positive lowers the front (ISO 8855).
    pub pitch: f64,
    /// Height of the ground below each wheel `[m]`, in the order given; none beside all lanes.
    pub wheels: [Option<f64>; 4],
}

impl Map<'_> {
    /// How a vehicle stands at a pose: the plane through the ground below its wheels, nearest to all four (least squares). `wheels` are the places where they touch the
    /// ground, from the reference point ahead (x) and to the left (y) `[m]`; the pose's z, if known, decides on which level. Without it, the reference point decides if it lies on an expected lane, else the first wheel that does, and all wheels are on its level. Pitch and roll follow heading, in
    /// this order. Wheels count where they are in plan view on level ground: on a slope of 10 % that is 0.5 % off. `None` with ground below fewer than three
    /// wheels, or wheels in a line.
    ///
    /// Errors: numbers that are not finite: of a wheel by its number, of the pose without one; a damaged archive.
    pub fn stance(
        &self,
        pose: &VehiclePose,
        wheels: &[DVec2; 4],
        expected: &[LaneId],
        scratch: &mut GroundScratch,
    ) -> Result<Option<Stance>, QueryError> {
        let xy = pose.position.xy;
        if !(pose.position.is_place() && pose.heading.is_finite()) {
            return Err(QueryError::NotFinite);
        }
        let (cos, sin) = cos_sin(pose.heading);
        let below = |wheel: &DVec2| xy + DVec2::new(cos, sin).rotate(*wheel);
        // All wheels are on one level: where no z says which, that of the first place on an expected lane does.
        let mut z = pose.position.z;
        if z.is_none() && !expected.is_empty() {
            for (i, wheel) in [DVec2::ZERO].iter().chain(wheels).enumerate() {
                let point = Point { xy: below(wheel), z };
                let found = self.ground_at(point, expected, scratch);
                // The place itself comes first, and has no number.
                let found = match i.checked_sub(1) {
                    Some(number) => found.map_err(|error| error.at(number))?,
                    None => found?,
                };
                z = found.filter(|ground| expected.contains(&ground.lane)).map(|ground| ground.z);
                if z.is_some() {
                    break;
                }
            }
        }
        let mut heights = [None; 4];
        for (i, wheel) in wheels.iter().enumerate() {
            let point = Point { xy: below(wheel), z };
            let ground = self.ground_at(point, expected, scratch).map_err(|error| error.at(i))?;
            heights[i] = ground.map(|ground| ground.z);
        }
        Ok(stance(wheels, heights))
    }
}

/// The plane z + a·x + b·y nearest to the heights, relative to the mean of the wheels.
fn stance(wheels: &[DVec2; 4], heights: [Option<f64>; 4]) -> Option<Stance> {
    let known = || wheels.iter().zip(heights).filter_map(|(wheel, z)| Some((*wheel, z?)));
    let count = known().count();
    if count < FEWEST_WHEELS {
        return None;
    }
    let share = 1.0 / count as f64;
    let middle = known().fold(DVec3::ZERO, |sum, (wheel, z)| sum + wheel.extend(z)) * share;
    let mut squares = DMat3::ZERO;
    for (wheel, z) in known() {
        let away = wheel.extend(z) - middle;
        squares += DMat3::from_cols(away * away.x, away * away.y, away * away.z);
    }
    let (xx, xy, yy) = (squares.x_axis.x, squares.x_axis.y, squares.y_axis.y);
    let determinant = xx * yy - xy * xy;
    let size = xx + yy;
    // Also where one is no number.
    let spans = determinant > LINE * size * size;
    if !spans {
        return None;
    }
    let (xz, yz) = (squares.x_axis.z, squares.y_axis.z);
    let ahead = (xz * yy - yz * xy) / determinant;
    let left = (yz * xx - xz * xy) / determinant;
    Some(Stance {
        z: middle.z - ahead * middle.x - left * middle.y,
        roll: libm::atan2(left, libm::sqrt(1.0 + ahead * ahead)),
        pitch: -libm::atan(ahead),
        wheels: heights,
    })
}
