//! The room along a path.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::graph::vehicle_of;
use crate::ids::mapd_lane_id;
use crate::list::{List, entries, get_mut, put_raw};
use crate::path::{mapd_path, path_of};
use crate::point::{mapd_vec2, mapd_vec3};
use crate::scratch::mapd_scratch;
use crate::signals::{mapd_speed_rule, speed_rule};
use mapd_client::path::{Corridor, CorridorEdges, CorridorSurface, EdgeKind, EdgeMark};
use mapd_client::vocabulary::VehicleClass;

/// `edge` of an edge: another lane of the road lies beyond, of whatever type, on the same level.
pub const MAPD_PATH_EDGE_LANE: u8 = 0;
/// `edge` of an edge: a kerb, by its mark, by the lane beyond, or by a step of 3 cm or more.
pub const MAPD_PATH_EDGE_KERB: u8 = 1;
/// `edge` of an edge: the road has no lane beyond. In a junction, that of another road may lie there.
pub const MAPD_PATH_EDGE_ROAD_END: u8 = 2;

/// What lies on an edge of a lane.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_edge_mark {
    /// A `MAPD_ROAD_MARK_KIND_…`; none where there is none.
    pub kind: u8,
    /// A `MAPD_ROAD_MARK_COLOR_…`.
    pub color: u8,
    /// 1: a change of lane over this edge is allowed, into a lane of its direction that the vehicle may use.
    pub may_cross: u8,
    /// What lies beyond: a `MAPD_PATH_EDGE_…`.
    pub edge: u8,
}

/// The room at one station of a path. Left and right are as seen by the driver; edges lie on the plane h = 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_corridor_station {
    /// S \[m\].
    pub along: f64,
    /// The driven lane.
    pub lane: mapd_lane_id,
    /// s on its road \[m\].
    pub s: f64,
    /// Left edge of the driven lane \[m\].
    pub left: mapd_vec3,
    /// Right edge of the driven lane \[m\].
    pub right: mapd_vec3,
    /// Left edge of the leftmost lane beside it that has its direction and is open to the vehicle \[m\].
    pub outer_left: mapd_vec3,
    /// Right edge of the rightmost such lane \[m\].
    pub outer_right: mapd_vec3,
    /// The speed limit, as `mapd_path_speed_at` has it; in what a view says today's.
    pub speed: mapd_speed_rule,
    /// What lies on the left edge of the driven lane.
    pub left_mark: mapd_edge_mark,
    /// What lies on its right edge.
    pub right_mark: mapd_edge_mark,
    /// What lies on the left edge of the leftmost lane.
    pub outer_left_mark: mapd_edge_mark,
    /// What lies on the right edge of the rightmost lane.
    pub outer_right_mark: mapd_edge_mark,
}

/// The road's surface at one station of a path.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_corridor_surface {
    /// Inertial position of the lane's middle on the surface \[m\].
    pub position: mapd_vec3,
    /// Unit normal, upwards.
    pub normal: mapd_vec3,
    /// Friction coefficient; negative where not given.
    pub friction: f64,
    /// Roughness as written; negative where not given.
    pub roughness: f64,
}

/// `edges` of an outline: those of the driven lane.
pub const MAPD_CORRIDOR_EDGES_DRIVEN: u32 = 0;
/// `edges` of an outline: those of all lanes beside it that have its direction and are open to the vehicle.
pub const MAPD_CORRIDOR_EDGES_OPEN: u32 = 1;

impl From<EdgeMark> for mapd_edge_mark {
    fn from(mark: EdgeMark) -> Self {
        let (kind, color) = (mark.kind.code(), mark.color.code());
        let edge = match mark.edge {
            EdgeKind::Kerb => MAPD_PATH_EDGE_KERB,
            EdgeKind::RoadEnd => MAPD_PATH_EDGE_ROAD_END,
            // One that has no name in C yet is at least no end of the road.
            _ => MAPD_PATH_EDGE_LANE,
        };
        Self { kind, color, may_cross: mark.may_cross.into(), edge }
    }
}

impl From<&CorridorSurface> for mapd_corridor_surface {
    fn from(own: &CorridorSurface) -> Self {
        Self {
            position: own.position.into(),
            normal: own.normal.into(),
            friction: own.friction.unwrap_or(-1.0),
            roughness: own.roughness.unwrap_or(-1.0),
        }
    }
}

/// The stations of a corridor.
pub(crate) fn stations(room: &Corridor) -> impl Iterator<Item = mapd_corridor_station> {
    (0..room.len()).map(|i| mapd_corridor_station {
        along: room.along[i],
        lane: room.lane[i].into(),
        s: room.s[i],
        left: room.left[i].into(),
        right: room.right[i].into(),
        outer_left: room.outer_left[i].into(),
        outer_right: room.outer_right[i].into(),
        speed: speed_rule(room.speed[i]),
        left_mark: room.left_mark[i].into(),
        right_mark: room.right_mark[i].into(),
        outer_left_mark: room.outer_left_mark[i].into(),
        outer_right_mark: room.outer_right_mark[i].into(),
    })
}

/// The room along the path from S, `from` \[m\], on: a station every `step` \[m\] and one at the end, `length` \[m\] on or where the path ends.
/// `vehicle` is a `MAPD_VEHICLE_CLASS_…`.
///
/// Errors: `MAPD_CODE_NOT_FINITE` of `from` and `length`; `MAPD_CODE_ARGUMENT` for a step that is not positive or gives more than a million stations,
/// and for an unknown class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_corridor(
    path: *const mapd_path,
    from: f64,
    length: f64,
    step: f64,
    vehicle: u8,
    scratch: *mut mapd_scratch,
    out: *mut mapd_corridor_station,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let room = &mut get_mut(scratch, "a scratch")?.corridor;
            path_of(path)?.corridor(from, length, step, vehicle_of(vehicle)?, room)?;
            List { out, capacity, count }.write(stations(room))
        })
    }
}

/// The road's surface at the stations that `mapd_path_corridor` has for the same numbers.
///
/// Errors: as `mapd_path_corridor`; `MAPD_CODE_CORRUPT`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_path_corridor_surface(
    path: *const mapd_path,
    from: f64,
    length: f64,
    step: f64,
    scratch: *mut mapd_scratch,
    out: *mut mapd_corridor_surface,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let room = &mut get_mut(scratch, "a scratch")?.corridor;
            let path = path_of(path)?;
            // Who may use the lanes beside says nothing of the surface.
            path.corridor(from, length, step, VehicleClass::PassengerCar, room)?;
            path.corridor_surface(room)?;
            List { out, capacity, count }.write(room.surface.iter().map(Into::into))
        })
    }
}

/// The room of stations as one polygon in plan view: along the right edges, then back along the left ones, counter-clockwise where it is simple and
/// driven forwards, without the first point again at its end. `edges` is a `MAPD_CORRIDOR_EDGES_…`. `is_simple`: 1 where no two of its sides meet
/// but neighbours in their common end; null is fine.
///
/// Errors: `MAPD_CODE_ARGUMENT` for unknown edges.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_corridor_outline(
    stations: *const mapd_corridor_station,
    station_count: usize,
    edges: u32,
    scratch: *mut mapd_scratch,
    out: *mut mapd_vec2,
    capacity: usize,
    count: *mut usize,
    is_simple: *mut u8,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch { corridor: room, outline, .. } = get_mut(scratch, "a scratch")?;
            let stations = entries(stations, station_count, "the stations")?;
            let kind = match edges {
                MAPD_CORRIDOR_EDGES_DRIVEN => CorridorEdges::Driven,
                MAPD_CORRIDOR_EDGES_OPEN => CorridorEdges::Open,
                other => return Err(Failure::argument(format!("{other} names no edges"))),
            };
            let is_driven = kind == CorridorEdges::Driven;
            room.left.clear();
            room.right.clear();
            for own in stations {
                let outer = (own.outer_left, own.outer_right);
                let (left, right) = if is_driven { (own.left, own.right) } else { outer };
                room.left.push(left.into());
                room.right.push(right.into());
            }
            // Which ones they are is decided: they stand where those of the driven lane do.
            let simple = room.outline(CorridorEdges::Driven, outline);
            put_raw(is_simple, simple.into())?;
            List { out, capacity, count }.write(outline.iter().map(|point| (*point).into()))
        })
    }
}
