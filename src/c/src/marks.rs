//! Road marks and borders.

use crate::code::{answer, mapd_code, mapd_error};
use crate::ground::{filter_of, mapd_mark_filter};
use crate::ids::{MAPD_NO_ROW, mapd_lane_id, mapd_object_id};
use crate::list::{List, finite, get_mut, put_some};
use crate::lookup::lane_of;
use crate::objects::mapd_placement_id;
use crate::point::{mapd_region, mapd_vec3};
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use mapd_client::LaneTypes;
use mapd_client::localisation::{MarkPoint, MarkSource};
use mapd_client::roads::{BoundarySegment, RoadMark, RoadMarkSegment};

/// A road mark on a lane's outer border, for lane 0 on its own line.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_road_mark {
    /// Where it begins: s on the road \[m\], not before the lane's section.
    pub s: f64,
    /// Where the lane's next mark or the section's end takes over \[m\].
    pub s_end: f64,
    /// Width \[m\]; negative where not given; of marks of two lines, that of each.
    pub width: f64,
    /// Width \[m\]; where the file gives none 0.12 m, for bold marks 0.25 m; 0 for the kind `none`.
    pub width_or_default: f64,
    /// Height above the road \[m\]; negative where not given.
    pub height: f64,
    /// A `MAPD_ROAD_MARK_KIND_…`.
    pub kind: u8,
    /// A `MAPD_ROAD_MARK_COLOR_…`.
    pub color: u8,
    /// A `MAPD_ROAD_MARK_WEIGHT_…`.
    pub weight: u8,
    /// Which lane changes it says it allows: a `MAPD_MARK_LANE_CHANGE_…`.
    pub lane_change: u8,
}

/// A straight piece of a lane's border.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_boundary_segment {
    /// The lane whose outer border it is; lane 0 for the line between left and right lanes.
    pub lane: mapd_lane_id,
    /// s of the first end \[m\].
    pub s_from: f64,
    /// s of the second end \[m\].
    pub s_to: f64,
    /// First end, inertial \[m\].
    pub from: mapd_vec3,
    /// Second end, inertial \[m\].
    pub to: mapd_vec3,
}

/// A straight piece of a road mark's course.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_road_mark_segment {
    /// The piece of the lane's border.
    pub segment: mapd_boundary_segment,
    /// The mark's width \[m\], or the default one.
    pub width: f64,
    /// A `MAPD_ROAD_MARK_KIND_…`.
    pub kind: u8,
    /// A `MAPD_ROAD_MARK_COLOR_…`.
    pub color: u8,
}

/// A painted place.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_mark_point {
    /// In the middle of the line, of a road mark on the plane h = 0, inertial \[m\].
    pub position: mapd_vec3,
    /// The lane on whose outer border the mark lies, lane 0 for marks of the centre; of an object a row of `MAPD_NO_ROW`.
    pub lane: mapd_lane_id,
    /// Along the road \[m\]; of an object that of its origin.
    pub s: f64,
    /// Width of the line \[m\]; 0 of an outline, and where an object's line gives none.
    pub width: f64,
    /// A `MAPD_ROAD_MARK_KIND_…`; of an object broken or solid, or a curb.
    pub kind: u8,
    /// A `MAPD_ROAD_MARK_COLOR_…`: the line's own, or the mark's.
    pub color: u8,
    /// 1: on the outline of an object that is painted as a whole, and for which the file gives no lines.
    pub is_outline: u8,
    /// The place of the object that it belongs to; its object's row is `MAPD_NO_ROW` for a mark of a lane.
    pub place: mapd_placement_id,
}

fn mark(one: &RoadMark<'_>) -> mapd_road_mark {
    mapd_road_mark {
        s: one.s(),
        s_end: one.s_end(),
        width: one.width().unwrap_or(-1.0),
        width_or_default: one.width_or_default(),
        height: one.height().unwrap_or(-1.0),
        kind: one.kind().code(),
        color: one.color().code(),
        weight: one.weight().code(),
        lane_change: one.lane_change().code(),
    }
}

fn segment(one: &BoundarySegment) -> mapd_boundary_segment {
    let ([s_from, s_to], [from, to]) = (one.s, one.ends);
    mapd_boundary_segment { lane: one.lane.into(), s_from, s_to, from: from.into(), to: to.into() }
}

fn mark_segment(one: &RoadMarkSegment) -> mapd_road_mark_segment {
    mapd_road_mark_segment {
        segment: segment(&one.segment),
        width: one.width,
        kind: one.kind.code(),
        color: one.color.code(),
    }
}

/// A lane's road marks in ascending s, those that hold somewhere in its section. The kind `none` is among them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_road_marks(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    out: *mut mapd_road_mark,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let lane = lane_of(snapshot, lane)?;
            List { out, capacity, count }.write(lane.road_marks().map(|one| mark(&one)))
        })
    }
}

/// The road mark that holds at s; at a boundary the later one. `MAPD_CODE_NONE` before the first and beyond the section.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_road_mark_at(
    snapshot: *const mapd_snapshot,
    lane: mapd_lane_id,
    s: f64,
    out: *mut mapd_road_mark,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let lane = lane_of(snapshot, lane)?;
            put_some(out, lane.road_mark_at(finite(s)?).map(|one| mark(&one)))
        })
    }
}

/// Every piece of the borders of lanes of these types that meets a rectangle in plan view, each once, in the order of their lanes and of s.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_boundary_segments(
    snapshot: *const mapd_snapshot,
    region: mapd_region,
    types: u64,
    scratch: *mut mapd_scratch,
    out: *mut mapd_boundary_segment,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch { lanes, bounds, .. } = get_mut(scratch, "a scratch")?;
            let types = LaneTypes::from_bits(types);
            map_of(snapshot)?.boundary_segments(region.into(), types, lanes, bounds)?;
            List { out, capacity, count }.write(bounds.iter().map(segment))
        })
    }
}

/// Every piece of the road marks of lanes of these types that meets a rectangle in plan view, along the borders, without sway.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_mark_segments(
    snapshot: *const mapd_snapshot,
    region: mapd_region,
    types: u64,
    scratch: *mut mapd_scratch,
    out: *mut mapd_road_mark_segment,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch { lanes, bounds, marks, .. } = get_mut(scratch, "a scratch")?;
            let types = LaneTypes::from_bits(types);
            map_of(snapshot)?.road_mark_segments(region.into(), types, lanes, bounds, marks)?;
            List { out, capacity, count }.write(marks.iter().map(mark_segment))
        })
    }
}

/// Points along all paint and kerbs in a rectangle, at every multiple of `spacing` \[m\] of their road's s, of lines along objects from their beginning; 1 cm at
/// least: the same ones whatever rectangle they are asked for by. Gaps of broken lines have none; where the file does not say which places are gaps, all
/// have. Of the filter kinds, lane types and `objects` count; null is the default. In no particular order.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_mark_points(
    snapshot: *const mapd_snapshot,
    region: mapd_region,
    spacing: f64,
    filter: *const mapd_mark_filter,
    scratch: *mut mapd_scratch,
    out: *mut mapd_mark_point,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let found = &mut get_mut(scratch, "a scratch")?.mark_points;
            map_of(snapshot)?.mark_points(region.into(), spacing, &filter_of(filter)?, found)?;
            let no_place = mapd_placement_id { object: mapd_object_id::NONE, copy: MAPD_NO_ROW };
            let point = |one: &MarkPoint| {
                let (lane, place, is_outline) = match one.source {
                    MarkSource::Lane(lane) => (lane.into(), no_place, 0),
                    MarkSource::Line(place) => (mapd_lane_id::NONE, place.into(), 0),
                    MarkSource::Outline(place) => (mapd_lane_id::NONE, place.into(), 1),
                };
                mapd_mark_point {
                    position: one.position.into(),
                    lane,
                    s: one.s,
                    width: one.width,
                    kind: one.kind.code(),
                    color: one.color.code(),
                    is_outline,
                    place,
                }
            };
            List { out, capacity, count }.write(found.iter().map(point))
        })
    }
}
