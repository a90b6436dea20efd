//! The ground below a place, and the road mark beside it.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::ids::mapd_lane_id;
use crate::list::{entries, fill, get_mut, put_found};
use crate::matching::mapd_vehicle_pose;
use crate::options::{given_options, put_defaults};
use crate::point::{mapd_point, mapd_vec2, mapd_vec3};
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use crate::surface::{mapd_material, material_or_none};
use mapd_client::glam::DVec2;
use mapd_client::localisation::{Ground, MarkFilter, MarkKinds, NearMark, Side, Stance};
use mapd_client::{LaneId, LaneTypes};

/// The ground at a place.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_ground {
    /// Height of the surface at the place \[m\].
    pub z: f64,
    /// Unit normal of the surface, upwards.
    pub normal: mapd_vec3,
    /// The lane that holds the place; of a place of a batch that has none, a row of `MAPD_NO_ROW`.
    pub lane: mapd_lane_id,
    /// Along its road \[m\].
    pub s: f64,
    /// Lateral on its road \[m\].
    pub t: f64,
    /// What the lane is made of; counts only with `has_material`.
    pub material: mapd_material,
    /// Which level this is, the lowest one 0.
    pub level: u32,
    /// How many levels of lanes there are at the place.
    pub levels: u32,
    /// 1: the map says what the lane is made of.
    pub has_material: u8,
}

/// How a vehicle stands.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_stance {
    /// Height of the ground's plane below the vehicle's reference point \[m\].
    pub z: f64,
    /// Roll \[rad\]; positive lifts the left side (ISO 8855).
    pub roll: f64,
    /// Pitch \[rad\]; positive lowers the front (ISO 8855).
    pub pitch: f64,
    /// Height of the ground below each wheel \[m\], in the order given; counts only with `has_wheel`.
    pub wheels: [f64; 4],
    /// 1: there is ground below the wheel.
    pub has_wheel: [u8; 4],
}

/// Which road marks count. Set it with `mapd_mark_filter_init`, then change what should differ.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_mark_filter {
    /// Size of this struct as the caller knows it: later releases may append to it.
    pub size: usize,
    /// Largest distance in plan view \[m\]. Default 5.
    pub radius: f64,
    /// Kinds that count: the bit of each is `1 << code`; `UINT64_MAX`, the default, is all. The kind `none` never counts.
    pub kinds: u64,
    /// Types of lanes whose borders count, on either side, as in `mapd_nearest_options`. Default all.
    pub types: u64,
    /// 0: what is painted as an object does not count in `mapd_mark_points`. Default 1.
    pub objects: u8,
}

/// `painted` of a road mark: there is paint.
pub const MAPD_PAINTED_YES: u8 = 1;
/// `painted` of a road mark: there is a gap.
pub const MAPD_PAINTED_NO: u8 = 0;
/// `painted` of a road mark: its kind has gaps, and the file does not say which.
pub const MAPD_PAINTED_UNKNOWN: u8 = 2;

/// The place of a road mark that is nearest to a point.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_near_mark {
    /// The lane on whose outer border the mark lies, lane 0 for marks of the centre; of a point of a batch that has none, a row of `MAPD_NO_ROW`.
    pub lane: mapd_lane_id,
    /// Where, on the road \[m\].
    pub s: f64,
    /// The nearest place of the middle of the mark's line, inertial \[m\].
    pub place: mapd_vec2,
    /// How far away that is in plan view \[m\].
    pub distance: f64,
    /// Width of the line \[m\], the default one where it has none of its own.
    pub width: f64,
    /// 1: the mark is to the left of the point, looking along the road's reference line.
    pub left_of_reference_line: u8,
    /// A `MAPD_ROAD_MARK_KIND_…`.
    pub kind: u8,
    /// A `MAPD_ROAD_MARK_COLOR_…`: the line's own, or the mark's.
    pub color: u8,
    /// Whether there is paint at this s: a `MAPD_PAINTED_…`.
    pub painted: u8,
}

impl From<Ground<'_>> for mapd_ground {
    fn from(ground: Ground<'_>) -> Self {
        Self {
            z: ground.z,
            normal: ground.normal.into(),
            lane: ground.lane.into(),
            s: ground.s,
            t: ground.t,
            material: material_or_none(ground.material),
            level: ground.level,
            levels: ground.levels,
            has_material: ground.material.is_some().into(),
        }
    }
}

impl From<Stance> for mapd_stance {
    fn from(stance: Stance) -> Self {
        let Stance { z, roll, pitch, wheels } = stance;
        let has_wheel = wheels.map(|wheel| wheel.is_some().into());
        Self { z, roll, pitch, wheels: wheels.map(|wheel| wheel.unwrap_or(0.0)), has_wheel }
    }
}

/// What a place without ground gets.
fn no_ground() -> mapd_ground {
    mapd_ground {
        z: 0.0,
        normal: mapd_vec3 { x: 0.0, y: 0.0, z: 0.0 },
        lane: mapd_lane_id::NONE,
        s: 0.0,
        t: 0.0,
        material: material_or_none(None),
        level: 0,
        levels: 0,
        has_material: 0,
    }
}

impl From<NearMark> for mapd_near_mark {
    fn from(mark: NearMark) -> Self {
        Self {
            lane: mark.lane.into(),
            s: mark.s,
            place: mark.place.into(),
            distance: mark.distance,
            width: mark.width,
            left_of_reference_line: (mark.side_of_reference_line == Side::Left).into(),
            kind: mark.kind.code(),
            color: mark.color.code(),
            painted: mark.painted.map_or(MAPD_PAINTED_UNKNOWN, u8::from),
        }
    }
}

/// What a point without marks gets.
const NO_MARK: mapd_near_mark = mapd_near_mark {
    lane: mapd_lane_id::NONE,
    s: 0.0,
    place: mapd_vec2 { x: 0.0, y: 0.0 },
    distance: 0.0,
    width: 0.0,
    left_of_reference_line: 0,
    kind: 0,
    color: 0,
    painted: 0,
};

/// The filter of a caller's; null is the default.
///
/// # Safety
///
/// As [`given_options`].
pub(crate) unsafe fn filter_of(filter: *const mapd_mark_filter) -> Result<MarkFilter, Failure> {
    let given = unsafe { given_options(filter, "mapd_mark_filter_init") }?;
    Ok(given.map_or_else(MarkFilter::default, |given| MarkFilter {
        radius: given.radius,
        kinds: MarkKinds::from_bits(given.kinds),
        types: LaneTypes::from_bits(given.types),
        objects: given.objects != 0,
    }))
}

/// The lanes that a caller expects, in a scratch's memory.
///
/// # Safety
///
/// `expected` is valid for reads of `count` entries.
unsafe fn expected_of(
    expected: *const mapd_lane_id,
    count: usize,
    lanes: &mut Vec<LaneId>,
) -> Result<&[LaneId], Failure> {
    lanes.clear();
    // SAFETY: as promised above.
    let expected = unsafe { entries(expected, count, "the expected lanes") }?;
    lanes.extend(expected.iter().map(|lane| LaneId::from(*lane)));
    Ok(lanes)
}

/// The ground at a place, on the level whose height is nearest to the point's z. A point without z is on the lowest level with one of `expected_count` lanes, such as the one
/// that the vehicle was in and those that it can reach from there; with none of them, on the lowest one. Heights more than 2 m apart are levels of
/// their own. `expected`: null with a count of 0 is fine. `MAPD_CODE_NONE` beside all lanes.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_ground_at(
    snapshot: *const mapd_snapshot,
    point: mapd_point,
    expected: *const mapd_lane_id,
    expected_count: usize,
    scratch: *mut mapd_scratch,
    out: *mut mapd_ground,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch { ground, lanes, .. } = get_mut(scratch, "a scratch")?;
            let expected = expected_of(expected, expected_count, lanes)?;
            put_found(out, map_of(snapshot)?.ground_at(point, expected, ground))
        })
    }
}

/// As `mapd_ground_at`, of `count` points; `out` has room for as many answers. What has none gets a lane with the row `MAPD_NO_ROW`.
///
/// Errors: as `mapd_ground_at`; the answers before the point that has one are written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_ground_at_batch(
    snapshot: *const mapd_snapshot,
    points: *const mapd_point,
    count: usize,
    expected: *const mapd_lane_id,
    expected_count: usize,
    scratch: *mut mapd_scratch,
    out: *mut mapd_ground,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let map = map_of(snapshot)?;
            let mapd_scratch { ground, lanes, .. } = get_mut(scratch, "a scratch")?;
            let expected = expected_of(expected, expected_count, lanes)?;
            let points = entries(points, count, "the points")?;
            fill(out, points, |point| {
                let found = map.ground_at(*point, expected, ground);
                found.map(|found| found.map_or_else(no_ground, mapd_ground::from))
            })
        })
    }
}

/// How a vehicle stands at a pose: the plane through the ground below its wheels, nearest to all four. `wheels` are four places where they touch the
/// ground, from the reference point ahead (x) and to the left (y) \[m\]; the pose's z, if known, decides on which level, then the expected lanes, as in `mapd_ground_at`. Pitch and roll follow heading, in
/// this order. `MAPD_CODE_NONE` with ground below fewer than three wheels, or wheels in a line.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_stance_at(
    snapshot: *const mapd_snapshot,
    pose: mapd_vehicle_pose,
    wheels: *const mapd_vec2,
    expected: *const mapd_lane_id,
    expected_count: usize,
    scratch: *mut mapd_scratch,
    out: *mut mapd_stance,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let map = map_of(snapshot)?;
            let mapd_scratch { ground, lanes, .. } = get_mut(scratch, "a scratch")?;
            let expected = expected_of(expected, expected_count, lanes)?;
            let mut own = [DVec2::ZERO; 4];
            for (own, wheel) in own.iter_mut().zip(entries(wheels, 4, "the wheels")?) {
                *own = (*wheel).into();
            }
            put_found(out, map.stance(&pose.into(), &own, expected, ground))
        })
    }
}

/// Sets a filter to its defaults. `size` is `sizeof(mapd_mark_filter)`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_mark_filter_init(
    filter: *mut mapd_mark_filter,
    size: usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let MarkFilter { radius, kinds, types, objects } = MarkFilter::default();
            let (kinds, types) = (kinds.bits(), types.bits());
            let objects = objects.into();
            put_defaults(filter, size, mapd_mark_filter { size, radius, kinds, types, objects })
        })
    }
}

/// The road mark that is nearest to a point, on the exact course of each of its lines. Lines count along their whole length, gaps included.
/// `filter`: null is the default. `MAPD_CODE_NONE` if none is near enough.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_nearest_mark(
    snapshot: *const mapd_snapshot,
    point: mapd_vec2,
    filter: *const mapd_mark_filter,
    out: *mut mapd_near_mark,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            put_found(out, map_of(snapshot)?.nearest_mark(point.into(), &filter_of(filter)?))
        })
    }
}

/// As `mapd_nearest_mark`, of `count` points; `out` has room for as many answers. What has none gets a lane with the row `MAPD_NO_ROW`.
///
/// Errors: as `mapd_nearest_mark`; the answers before the point that has one are written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_nearest_mark_batch(
    snapshot: *const mapd_snapshot,
    points: *const mapd_vec2,
    count: usize,
    filter: *const mapd_mark_filter,
    out: *mut mapd_near_mark,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (map, filter) = (map_of(snapshot)?, filter_of(filter)?);
            let points = entries(points, count, "the points")?;
            fill(out, points, |point| {
                let found = map.nearest_mark((*point).into(), &filter);
                found.map(|found| found.map_or(NO_MARK, mapd_near_mark::from))
            })
        })
    }
}
