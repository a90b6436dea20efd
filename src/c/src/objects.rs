//! Objects: what they are and where they stand.

use crate::code::{answer, mapd_code, mapd_error};
use crate::ids::{MAPD_NO_ROW, mapd_junction_id, mapd_lane_id, mapd_object_id, mapd_road_id};
use crate::list::{List, get_mut, put};
use crate::lookup::lane_of;
use crate::point::{mapd_region, mapd_vec2, mapd_vec3};
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use crate::text::mapd_text;
use mapd_client::SRange;
use mapd_client::objects::{Object, ObjectLane, ObjectPlacement, PlacementId};

/// A place of an object.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct mapd_placement_id {
    /// The object.
    pub object: mapd_object_id,
    /// Which of its copies, from 0; `MAPD_NO_ROW` for an object that is not repeated.
    pub copy: u32,
}

/// An object.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_object_facts {
    /// The object itself.
    pub object: mapd_object_id,
    /// The road that it is written in, if any.
    pub road: mapd_road_id,
    /// The junction that it is written in, if any.
    pub junction: mapd_junction_id,
    /// OpenDRIVE's id, verbatim.
    pub id: mapd_text,
    /// Name for people.
    pub name: mapd_text,
    /// `type` as written.
    pub kind: mapd_text,
    /// `subtype` as written.
    pub subtype: mapd_text,
    /// As written \[m\].
    pub s: f64,
    /// As written \[m\].
    pub t: f64,
    /// Height of the origin above the reference line at s \[m\].
    pub z_offset: f64,
    /// Length along s over which it holds \[m\]; 0 if not given.
    pub valid_length: f64,
    /// Number of places where it stands.
    pub placements: u32,
    /// What it means: a `MAPD_CLASS_…`.
    pub class_code: u16,
    /// What its extent is made of: a `MAPD_OBJECT_SHAPE_…`.
    pub shape: u8,
    /// Direction of travel that it is for: a `MAPD_ORIENTATION_…`.
    pub orientation: u8,
    /// 1: its state may change.
    pub is_dynamic: u8,
    /// 1: it is repeated, and stands at the copies alone.
    pub is_repeated: u8,
    /// 1: it stands for a limited time.
    pub is_temporary: u8,
    /// 1: it is written to hold no longer.
    pub is_invalidated: u8,
    /// 1: its s lies beyond the road, so that it stands beside its end.
    pub is_clamped: u8,
    /// 1: it is a parking space.
    pub is_parking_space: u8,
    /// 1: `value` is there.
    pub has_value: u8,
    /// What its class means by its value: \[m/s\], \[m\] or \[kg\]; counts only with `has_value`.
    pub value: f64,
    /// Unit in which the number of its value is read, such as `km/h`: objects state none. Empty without a value.
    pub assumed_unit: mapd_text,
    /// Of a parking space who may park, as written: all, car, women, handicapped, bus, truck, electric, residents.
    pub parking_access: mapd_text,
    /// Of a parking space its restrictions in words.
    pub parking_restrictions: mapd_text,
}

/// An object where it stands.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_placement_facts {
    /// Names the place.
    pub place: mapd_placement_id,
    /// Inertial position of the origin \[m\].
    pub position: mapd_vec3,
    /// Inertial heading of the u axis \[rad\], in (−π, π].
    pub heading: f64,
    /// Pitch \[rad\]; positive lowers the front.
    pub pitch: f64,
    /// Roll \[rad\]; positive lifts the left side.
    pub roll: f64,
    /// Along its own u axis \[m\]; 0 if not given.
    pub length: f64,
    /// Along its own v axis \[m\]; 0 if not given.
    pub width: f64,
    /// Height \[m\]; 0 if none is given.
    pub height: f64,
    /// Radius \[m\]; 0 if not given.
    pub radius: f64,
    /// On the object's road \[m\].
    pub s: f64,
    /// On the object's road \[m\], positive to the left.
    pub t: f64,
    /// 1: it is the object without gaps along a stretch of road.
    pub is_swept: u8,
}

/// An object near a point.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_near_object {
    /// Where it stands.
    pub place: mapd_placement_id,
    /// Plan-view distance of the point from what it covers \[m\]; 0 on it.
    pub distance: f64,
}

/// An object's belonging to a lane.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_object_lane {
    /// The object.
    pub object: mapd_object_id,
    /// The lane.
    pub lane: mapd_lane_id,
    /// From where on the road it lies on the lane, or beside it \[m\].
    pub s_low: f64,
    /// To where \[m\].
    pub s_high: f64,
    /// Distance of the object from the lane's area in plan view \[m\]; 0 on it.
    pub distance: f64,
    /// How the object came to the lane: a `MAPD_LANE_METHOD_…`.
    pub method: u8,
}

impl From<PlacementId> for mapd_placement_id {
    fn from(id: PlacementId) -> Self {
        Self { object: id.object.into(), copy: id.copy.unwrap_or(MAPD_NO_ROW) }
    }
}

impl From<mapd_placement_id> for PlacementId {
    fn from(id: mapd_placement_id) -> Self {
        Self { object: id.object.into(), copy: (id.copy != MAPD_NO_ROW).then_some(id.copy) }
    }
}

fn facts(object: &Object<'_>) -> mapd_object_facts {
    let parking = object.parking_space();
    mapd_object_facts {
        object: object.object_id().into(),
        road: object.road().map(|road| road.road_id()).into(),
        junction: object.junction().map(|junction| junction.junction_id()).into(),
        id: object.id().into(),
        name: object.name().into(),
        kind: object.type_name().into(),
        subtype: object.subtype().into(),
        s: object.s(),
        t: object.t(),
        z_offset: object.z_offset(),
        valid_length: object.valid_length(),
        placements: object.placements().count() as u32,
        class_code: object.class().code(),
        shape: object.shape().code(),
        orientation: object.orientation().code(),
        is_dynamic: object.is_dynamic().into(),
        is_repeated: object.is_repeated().into(),
        is_temporary: object.is_temporary().into(),
        is_invalidated: object.is_invalidated().into(),
        is_clamped: object.is_clamped().into(),
        is_parking_space: parking.is_some().into(),
        has_value: object.value().is_some().into(),
        value: object.value().unwrap_or(0.0),
        assumed_unit: object.assumed_unit().into(),
        parking_access: parking.map_or("", |space| space.access()).into(),
        parking_restrictions: parking.map_or("", |space| space.restrictions()).into(),
    }
}

fn placement(place: &ObjectPlacement<'_>) -> mapd_placement_facts {
    let [heading, pitch, roll] = place.angles();
    mapd_placement_facts {
        place: place.placement_id().into(),
        position: place.position().into(),
        heading,
        pitch,
        roll,
        length: place.length(),
        width: place.width(),
        height: place.height(),
        radius: place.radius(),
        s: place.s(),
        t: place.t(),
        is_swept: place.is_swept().into(),
    }
}

fn object_lane(one: ObjectLane<'_>) -> mapd_object_lane {
    let SRange { low: s_low, high: s_high } = one.s_range();
    mapd_object_lane {
        object: one.object().map(|object| object.object_id()).into(),
        lane: one.lane().map(|lane| lane.lane_id()).into(),
        s_low,
        s_high,
        distance: one.distance(),
        method: one.method().code(),
    }
}

/// What an object is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_object_facts_of(
    snapshot: *const mapd_snapshot,
    object: mapd_object_id,
    out: *mut mapd_object_facts,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, facts(&map_of(snapshot)?.object(object.into())?))) }
}

/// Every place where an object stands: its own, or those of its copies.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_object_placements(
    snapshot: *const mapd_snapshot,
    object: mapd_object_id,
    out: *mut mapd_placement_facts,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.object(object.into())?.placements();
            List { out, capacity, count }.write(all.map(|one| placement(&one)))
        })
    }
}

/// An object where it stands.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_placement_facts_of(
    snapshot: *const mapd_snapshot,
    place: mapd_placement_id,
    out: *mut mapd_placement_facts,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, placement(&map_of(snapshot)?.placement(place.into())?))) }
}

/// Corners of the area that an object covers, at its foot, inertial \[m\].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_placement_footprint(
    snapshot: *const mapd_snapshot,
    place: mapd_placement_id,
    scratch: *mut mapd_scratch,
    out: *mut mapd_vec3,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let corners = &mut get_mut(scratch, "a scratch")?.corners;
            map_of(snapshot)?.placement(place.into())?.footprint(corners);
            List { out, capacity, count }.write(corners.iter().map(|one| (*one).into()))
        })
    }
}

/// Lanes that an object belongs to, nearer ones first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_object_lanes(
    snapshot: *const mapd_snapshot,
    object: mapd_object_id,
    out: *mut mapd_object_lane,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let lanes = map_of(snapshot)?.object(object.into())?.lanes();
            List { out, capacity, count }.write(lanes.map(object_lane))
        })
    }
}

/// Objects that belong to a lane, in ascending s: crosswalks, stop lines, parking spaces, what stands beside it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_objects(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_object_lane,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            List { out, capacity, count }.write(lane_of(snapshot, lane)?.objects().map(object_lane))
        })
    }
}

/// Every place of an object whose area comes as near to a point as `radius` \[m\] in plan view, nearest first.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_objects_near(
    snapshot: *const mapd_snapshot,
    point: mapd_vec2,
    radius: f64,
    scratch: *mut mapd_scratch,
    out: *mut mapd_near_object,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let near = &mut get_mut(scratch, "a scratch")?.near_objects;
            map_of(snapshot)?.objects_near(point.into(), radius, near)?;
            let all = near.iter();
            let all =
                all.map(|one| mapd_near_object { place: one.place.into(), distance: one.distance });
            List { out, capacity, count }.write(all)
        })
    }
}

/// Every place of an object whose area meets a rectangle in plan view, in the order of their rows.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_objects_in(
    snapshot: *const mapd_snapshot,
    region: mapd_region,
    scratch: *mut mapd_scratch,
    out: *mut mapd_placement_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let objects = &mut get_mut(scratch, "a scratch")?.objects;
            map_of(snapshot)?.objects_in(region.into(), objects)?;
            List { out, capacity, count }.write(objects.iter().map(|one| (*one).into()))
        })
    }
}
