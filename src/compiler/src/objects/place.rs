//! Origin and axes of an object.

use super::line::{Line, Station};
use crate::draft::Object;
use crate::draft::single;
use glam::DVec3;
use mapd_archive::{ObjectRow, object_flags};
use mapd_geometry::{Attitude, normalize_angle};

/// Where something stands and how.
#[derive(Clone, Copy, Debug)]
pub(super) struct Standing {
    /// Relative to the local origin `[m]`.
    pub(super) origin: DVec3,
    pub(super) axes: Attitude,
    /// Heading, pitch, roll `[rad]`, inertial.
    pub(super) angles: [f64; 3],
}

/// Axes at a station. Heading counts from the line's; pitch and roll from the x/y plane or, for an object perpendicular to
/// the road, from the road's own (OpenDRIVE 1.8.1, 13.1).
pub(super) fn stand_at(
    station: &Station,
    z_offset: f64,
    [heading, pitch, roll]: [f64; 3],
    is_perpendicular: bool,
) -> Option<Standing> {
    let origin = station.position + DVec3::Z * z_offset;
    let (axes, angles) = if is_perpendicular {
        let axes = station.inclined.then(&Attitude::new(heading, pitch, roll));
        (axes, axes.angles())
    } else {
        let heading = normalize_angle(station.heading + heading);
        (
            Attitude::new(heading, pitch, roll),
            [heading, normalize_angle(pitch), normalize_angle(roll)],
        )
    };
    let is_finite = origin.is_finite() && angles.iter().all(|angle| angle.is_finite());
    is_finite.then_some(Standing { origin, axes, angles })
}

/// Fills what follows from an object's place; none where no number can hold it.
pub(super) fn stand(line: &Line<'_>, object: &Object, row: &mut ObjectRow) -> Option<Standing> {
    let station = line.at(row.s, row.t)?;
    let is_perpendicular = row.flags & object_flags::PERPENDICULAR != 0;
    let standing = stand_at(&station, object.z_offset, object.angles, is_perpendicular)?;
    (row.x, row.y, row.z) = standing.origin.into();
    row.heading = standing.angles[0];
    (row.pitch, row.roll) = (single(standing.angles[1]), single(standing.angles[2]));
    if station.clamped {
        row.flags |= object_flags::CLAMPED;
    }
    Some(standing)
}
