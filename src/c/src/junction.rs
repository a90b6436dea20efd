//! Junctions.

use crate::code::{answer, mapd_code, mapd_error};
use crate::ids::{mapd_junction_id, mapd_road_id};
use crate::list::{List, put};
use crate::lookup::junction_of;
use crate::snapshot::mapd_snapshot;
use crate::text::mapd_text;

/// A junction.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_junction_facts {
    /// The junction itself.
    pub junction: mapd_junction_id,
    /// OpenDRIVE's id, verbatim.
    pub id: mapd_text,
    /// OpenDRIVE's name.
    pub name: mapd_text,
    /// Number of connections.
    pub connections: usize,
}

/// A connection of a junction, as written.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_connection {
    /// OpenDRIVE's id, verbatim.
    pub id: mapd_text,
    /// Road that leads into the junction, where the map has it.
    pub incoming_road: mapd_road_id,
    /// Connecting road, or the linked road of a direct junction, where the map has it.
    pub connecting_road: mapd_road_id,
    /// End of the connecting road that touches the incoming one: a `MAPD_CONTACT_POINT_…`.
    pub contact: u8,
}

/// What a junction is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_junction_facts_of(
    snapshot: *const mapd_snapshot,
    junction: mapd_junction_id,
    out: *mut mapd_junction_facts,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let junction = junction_of(snapshot, junction)?;
            put(
                out,
                mapd_junction_facts {
                    junction: junction.junction_id().into(),
                    id: junction.id().into(),
                    name: junction.name().into(),
                    connections: junction.connections().len(),
                },
            )
        })
    }
}

/// Connections of a junction in file order.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_junction_connections(
    snapshot: *const mapd_snapshot,
    junction: mapd_junction_id,
    out: *mut mapd_connection,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = junction_of(snapshot, junction)?.connections().map(|one| mapd_connection {
                id: one.id().into(),
                incoming_road: one.incoming_road().map(|road| road.road_id()).into(),
                connecting_road: one.connecting_road().map(|road| road.road_id()).into(),
                contact: one.contact_point().code(),
            });
            List { out, capacity, count }.write(all)
        })
    }
}
