//! What a map has beside its lanes: bridges and tunnels, references to objects, holes.

use crate::code::{answer, mapd_code, mapd_error};
use crate::ids::{mapd_object_id, mapd_road_id};
use crate::list::{List, put_some};
use crate::point::{mapd_region, mapd_vec2};
use crate::snapshot::{map_of, mapd_snapshot};
use crate::text::{given, mapd_text};
use mapd_client::document::{Quarantined, SourcePosition};
use mapd_client::roads::LaneRange;
use mapd_client::vocabulary::QuarantinedKind;
use mapd_client::{Region, SRange};
use std::ffi::c_char;

/// A bridge or tunnel.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_structure {
    /// OpenDRIVE's id, verbatim.
    pub id: mapd_text,
    /// OpenDRIVE's name.
    pub name: mapd_text,
    /// Type as written, such as concrete or underpass.
    pub type_name: mapd_text,
    /// The road.
    pub road: mapd_road_id,
    /// Where it begins on the road \[m\].
    pub s_from: f64,
    /// Where it ends \[m\].
    pub s_to: f64,
    /// Degree of artificial light in a tunnel, 0 to 1; negative where not given.
    pub lighting: f64,
    /// Degree of daylight in a tunnel, 0 to 1; negative where not given.
    pub daylight: f64,
    /// Smallest number of the lanes that it is written to hold for; counts only with `has_lanes`, else it holds for all.
    pub lane_from: i32,
    /// Largest number of those lanes. Of several ranges this is the whole from the first to the last.
    pub lane_to: i32,
    /// 1: it holds for some lanes only.
    pub has_lanes: u8,
    /// A `MAPD_STRUCTURE_KIND_…`.
    pub kind: u8,
}

/// An object of another road that concerns a road too.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_object_reference {
    /// Id of the object as written.
    pub id: mapd_text,
    /// The object; one that names nothing where the map has none of this id.
    pub object: mapd_object_id,
    /// The road that refers to it.
    pub road: mapd_road_id,
    /// s on the referring road \[m\].
    pub s: f64,
    /// t on the referring road \[m\].
    pub t: f64,
    /// Height above the referring road's reference line \[m\].
    pub z_offset: f64,
    /// Length along s over which it holds \[m\]; 0 where not given.
    pub valid_length: f64,
    /// Direction of travel on the referring road that it is for: a `MAPD_ORIENTATION_…`.
    pub orientation: u8,
}

/// A part of the document that is not in the map as written.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_quarantined {
    /// OpenDRIVE's id, verbatim.
    pub id: mapd_text,
    /// Id of the road or junction that it belongs to; its own for a road or junction.
    pub owner: mapd_text,
    /// Id of the rule whose finding is the reason.
    pub rule: mapd_text,
    /// What the finding says.
    pub message: mapd_text,
    /// Name of the included file that the finding stands in; empty for the document itself.
    pub file: mapd_text,
    /// The rectangle around it; counts only with `has_extent`.
    pub extent: mapd_region,
    /// Length of a road as written \[m\]; 0 for other parts.
    pub length: f64,
    /// Place of the finding in its file: line, from 1.
    pub line: u32,
    /// Place of the finding in its file: column, from 1.
    pub column: u32,
    /// What it is: a `MAPD_QUARANTINED_KIND_…`.
    pub kind: u8,
    /// What the owner is.
    pub owner_kind: u8,
    /// 1: it is a road that is in the map as its bare reference line.
    pub is_reference_line: u8,
    /// 1: its place is known.
    pub has_extent: u8,
}

fn quarantined(part: &Quarantined<'_>) -> mapd_quarantined {
    let SourcePosition { line, column } = part.source_position();
    let extent = part
        .extent()
        .map(|Region { low, high }| mapd_region { low: low.into(), high: high.into() });
    mapd_quarantined {
        id: part.id().into(),
        owner: part.owner().into(),
        rule: part.rule().into(),
        message: part.message().into(),
        file: part.source_file().unwrap_or_default().into(),
        extent: extent.unwrap_or_default(),
        length: part.length(),
        line,
        column,
        kind: part.kind().code(),
        owner_kind: part.owner_kind().code(),
        is_reference_line: part.is_reference_line().into(),
        has_extent: extent.is_some().into(),
    }
}

/// All bridges and tunnels, by road.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_structures(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_structure,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.structures().map(|one| {
                let SRange { low: s_from, high: s_to } = one.s_range();
                let lanes = one.validities().reduce(|all, own| LaneRange {
                    from: all.from.min(own.from),
                    to: all.to.max(own.to),
                });
                mapd_structure {
                    id: one.id().into(),
                    name: one.name().into(),
                    type_name: one.type_name().into(),
                    road: one.road().map(|road| road.road_id()).into(),
                    s_from,
                    s_to,
                    lighting: one.lighting().unwrap_or(-1.0),
                    daylight: one.daylight().unwrap_or(-1.0),
                    lane_from: lanes.map_or(0, |lanes| lanes.from),
                    lane_to: lanes.map_or(0, |lanes| lanes.to),
                    has_lanes: lanes.is_some().into(),
                    kind: one.kind().code(),
                }
            });
            List { out, capacity, count }.write(all)
        })
    }
}

/// All references to objects of other roads, by referring road.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_object_references(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_object_reference,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.object_references().map(|one| mapd_object_reference {
                id: one.id().into(),
                object: one.object().map(|object| object.object_id()).into(),
                road: one.road().map(|road| road.road_id()).into(),
                s: one.s(),
                t: one.t(),
                z_offset: one.z_offset(),
                valid_length: one.valid_length(),
                orientation: one.orientation().code(),
            });
            List { out, capacity, count }.write(all)
        })
    }
}

/// Parts of the document that are not in the map as written, in the order of the document. None of a map that was accepted whole.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_quarantined_parts(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_quarantined,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.quarantined();
            List { out, capacity, count }.write(all.map(|part| quarantined(&part)))
        })
    }
}

/// Those whose extent comes as near to a point as `radius` \[m\] in plan view: an answer about that place may lack them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_quarantined_near(
    snapshot: *const mapd_snapshot,
    point: mapd_vec2,
    radius: f64,
    out: *mut mapd_quarantined,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let near = map_of(snapshot)?.quarantined_near(point.into(), radius);
            List { out, capacity, count }.write(near.map(|part| quarantined(&part)))
        })
    }
}

/// Why the map has no part of this kind and id, or has a road without its lanes; `kind` is a `MAPD_QUARANTINED_KIND_…`. `MAPD_CODE_NONE` where the document
/// has no such part, or the map has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_left_out(
    snapshot: *const mapd_snapshot,
    kind: u8,
    id: *const c_char,
    out: *mut mapd_quarantined,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (kind, id) = (QuarantinedKind::from_code(kind), given(id, "the id")?);
            let part = map_of(snapshot)?.left_out(kind, id);
            put_some(out, part.map(|part| quarantined(&part)))
        })
    }
}
