//! Roads.

use crate::code::{answer, mapd_code, mapd_error};
use crate::ids::{mapd_junction_id, mapd_lane_id, mapd_road_id};
use crate::list::{List, entries, fill, finite, put, put_answer, put_some};
use crate::lookup::{ask_road, road_of};
use crate::point::{mapd_point, mapd_pose, mapd_track, mapd_track_position};
use crate::snapshot::mapd_snapshot;
use crate::text::mapd_text;
use mapd_client::Road;
use mapd_client::document::SourcePosition;
use mapd_client::roads::RoadLink;

/// `kind` of a road link: nothing is written.
pub const MAPD_ROAD_LINK_NONE: u8 = 0;
/// `kind` of a road link: a road.
pub const MAPD_ROAD_LINK_ROAD: u8 = 1;
/// `kind` of a road link: a junction.
pub const MAPD_ROAD_LINK_JUNCTION: u8 = 2;
/// `kind` of a road link: something that the map does not have.
pub const MAPD_ROAD_LINK_UNRESOLVED: u8 = 3;

/// What a road is linked to at one of its ends.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct mapd_road_link {
    /// The road, of a link to one.
    pub road: mapd_road_id,
    /// The junction, of a link to one.
    pub junction: mapd_junction_id,
    /// A `MAPD_ROAD_LINK_…`.
    pub kind: u8,
    /// Which end of the road is touched: a `MAPD_CONTACT_POINT_…`.
    pub contact: u8,
}

/// A road.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_road_facts {
    /// The road itself.
    pub road: mapd_road_id,
    /// The junction that this is a connecting road of, if any.
    pub junction: mapd_junction_id,
    /// OpenDRIVE's id, verbatim.
    pub id: mapd_text,
    /// OpenDRIVE's name.
    pub name: mapd_text,
    /// Length of the reference line as written \[m\].
    pub length: f64,
    /// Largest s that the reference line reaches \[m\].
    pub reference_end: f64,
    /// What lies at s = 0.
    pub predecessor: mapd_road_link,
    /// What lies at s = length.
    pub successor: mapd_road_link,
    /// Number of lane sections.
    pub sections: u32,
    /// Line of the start tag in the file, from 1.
    pub line: u32,
    /// Column of the start tag in the file, from 1.
    pub column: u32,
    /// 1: traffic keeps to the left.
    pub is_left_hand_traffic: u8,
}

fn link(link: Option<RoadLink<'_>>) -> mapd_road_link {
    let none = mapd_road_link {
        road: mapd_road_id::NONE,
        junction: mapd_junction_id::NONE,
        kind: MAPD_ROAD_LINK_NONE,
        contact: 0,
    };
    match link {
        None => none,
        Some(RoadLink::Road(road, contact)) => mapd_road_link {
            road: road.road_id().into(),
            kind: MAPD_ROAD_LINK_ROAD,
            contact: contact.code(),
            ..none
        },
        Some(RoadLink::Junction(junction)) => mapd_road_link {
            junction: junction.junction_id().into(),
            kind: MAPD_ROAD_LINK_JUNCTION,
            ..none
        },
        Some(RoadLink::Unresolved) => mapd_road_link { kind: MAPD_ROAD_LINK_UNRESOLVED, ..none },
    }
}

fn facts(road: &Road<'_>) -> mapd_road_facts {
    let SourcePosition { line, column } = road.source_position();
    mapd_road_facts {
        road: road.road_id().into(),
        junction: road.junction().map(|junction| junction.junction_id()).into(),
        id: road.id().into(),
        name: road.name().into(),
        length: road.length(),
        reference_end: road.reference_end(),
        predecessor: link(road.predecessor()),
        successor: link(road.successor()),
        sections: road.sections().count() as u32,
        line,
        column,
        is_left_hand_traffic: road.is_left_hand_traffic().into(),
    }
}

/// What a road is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_facts_of(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    out: *mut mapd_road_facts,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, facts(&road_of(snapshot, road)?))) }
}

/// Inertial pose of a track position: (x, y, e) + t along the rolled lateral axis + h along its normal. s beyond the reference line
/// is moved to its end and flagged.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_to_inertial(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    track: mapd_track,
    out: *mut mapd_pose,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, move || {
            ask_road(snapshot, road, move |road| put_answer(out, road.to_inertial(track.into())))
        })
    }
}

/// Track position of a point: the foot on the nearest place of the whole reference line. Without z in plan view.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_to_track(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    point: mapd_point,
    out: *mut mapd_track_position,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, move || {
            ask_road(snapshot, road, move |road| put_answer(out, road.to_track(point)))
        })
    }
}

/// As `mapd_road_to_inertial`, of `count` track positions; `out` has room for as many.
///
/// Errors: as `mapd_road_to_inertial`; the answers before the entry that has one are written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_to_inertial_batch(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    tracks: *const mapd_track,
    count: usize,
    out: *mut mapd_pose,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let road = road_of(snapshot, road)?;
            let tracks = entries(tracks, count, "the track positions")?;
            fill(out, tracks, |track| road.to_inertial((*track).into()).map(Into::into))
        })
    }
}

/// As `mapd_road_to_track`, of `count` points; `out` has room for as many.
///
/// Errors: as `mapd_road_to_track`; the answers before the point that has one are written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_to_track_batch(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    points: *const mapd_point,
    count: usize,
    out: *mut mapd_track_position,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let road = road_of(snapshot, road)?;
            let points = entries(points, count, "the points")?;
            fill(out, points, |point| road.to_track(*point).map(Into::into))
        })
    }
}

/// Elevation of the reference line at s \[m\]. s outside the road counts as its nearer end.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_elevation_at(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    s: f64,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, road_of(snapshot, road)?.elevation_at(finite(s)?))) }
}

/// Superelevation at s \[rad\]; positive lifts the left side. s outside the road counts as its nearer end.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_superelevation_at(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    s: f64,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, road_of(snapshot, road)?.superelevation_at(finite(s)?))) }
}

/// Lane offset at s \[m\]; positive to the left. s outside the road counts as its nearer end.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_lane_offset_at(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    s: f64,
    out: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, road_of(snapshot, road)?.lane_offset_at(finite(s)?))) }
}

/// The lane that covers (s, t); on a shared edge the one nearer to lane 0. `MAPD_CODE_NONE` beside all lanes.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_lane_at(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    s: f64,
    t: f64,
    out: *mut mapd_lane_id,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (s, t) = (finite(s)?, finite(t)?);
            let section = road_of(snapshot, road)?.section_at(s);
            let lane = section.and_then(|section| section.lane_at(s, t));
            put_some(out, lane.map(|lane| lane.lane_id().into()))
        })
    }
}

/// The lane with OpenDRIVE's number at s; at a boundary of two sections that of the later one. `MAPD_CODE_NONE` if there is none.
///
/// Errors: `MAPD_CODE_NOT_FINITE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_lane_numbered(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    s: f64,
    number: i32,
    out: *mut mapd_lane_id,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let section = road_of(snapshot, road)?.section_at(finite(s)?);
            let lane = section.and_then(|section| section.lane(number));
            put_some(out, lane.map(|lane| lane.lane_id().into()))
        })
    }
}

/// Lanes of a section of the road, by the section's number from 0, from left to right, lane 0 among them. `MAPD_CODE_NONE` for a section
/// that there is not.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_road_section_lanes(
    snapshot: *const mapd_snapshot,
    road: mapd_road_id,
    section: u32,
    out: *mut mapd_lane_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let Some(section) = road_of(snapshot, road)?.section(section) else {
                return Ok(mapd_code::NONE);
            };
            let lanes = section.lanes().map(|lane| lane.lane_id().into());
            List { out, capacity, count }.write(lanes)
        })
    }
}
