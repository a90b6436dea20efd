//! What belongs together: junctions of a roundabout, signals of a controller, what a signal names.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::ids::{mapd_junction_id, mapd_lane_id, mapd_object_id, mapd_signal_id};
use crate::list::List;
use crate::lookup::junction_of;
use crate::snapshot::{map_of, mapd_snapshot};
use crate::text::mapd_text;
use mapd_client::Map;
use mapd_client::junctions::JunctionGroup;
use mapd_client::signals::{Controller, SignalLink};

/// Junctions that belong together: a roundabout, an interchange.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_junction_group {
    /// OpenDRIVE's id, verbatim.
    pub id: mapd_text,
    /// OpenDRIVE's name.
    pub name: mapd_text,
    /// What the group is: a `MAPD_JUNCTION_GROUP_KIND_…`.
    pub kind: u8,
}

/// A group of signals that switch together.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_controller {
    /// OpenDRIVE's id, verbatim.
    pub id: mapd_text,
    /// OpenDRIVE's name.
    pub name: mapd_text,
    /// Its rank; negative where not given.
    pub sequence: i32,
}

/// Something that a signal names.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_signal_link {
    /// Id as written.
    pub id: mapd_text,
    /// Type as written.
    pub kind: mapd_text,
    /// The signal, where it is one and the map has it.
    pub signal: mapd_signal_id,
    /// The object, where it is one and the map has it.
    pub object: mapd_object_id,
    /// 1: an object is named.
    pub is_object: u8,
}

/// `which` of `mapd_signal_links`: signals that it controls or depends on.
pub const MAPD_SIGNAL_LINKS_DEPENDENCIES: u32 = 0;
/// `which` of `mapd_signal_links`: objects and signals that belong to it, such as the pole that it hangs from.
pub const MAPD_SIGNAL_LINKS_BELONGINGS: u32 = 1;

fn group(map: Map<'_>, number: u32) -> Result<JunctionGroup<'_>, Failure> {
    let found = map.junction_groups().nth(number as usize);
    found.ok_or_else(|| Failure::argument(format!("the map has no group of junctions {number}")))
}

fn controller(map: Map<'_>, number: u32) -> Result<Controller<'_>, Failure> {
    let found = map.controllers().nth(number as usize);
    found.ok_or_else(|| Failure::argument(format!("the map has no controller {number}")))
}

fn link(one: &SignalLink<'_>) -> mapd_signal_link {
    mapd_signal_link {
        id: one.id.into(),
        kind: one.kind.into(),
        signal: one.signal.map(|signal| signal.signal_id()).into(),
        object: one.object.map(|object| object.object_id()).into(),
        is_object: one.is_object.into(),
    }
}

/// All groups of junctions in file order: group k has the number k.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_junction_groups(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_junction_group,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.junction_groups().map(|one| mapd_junction_group {
                id: one.id().into(),
                name: one.name().into(),
                kind: one.kind().code(),
            });
            List { out, capacity, count }.write(all)
        })
    }
}

/// Junctions of a group in file order, by its number; those that the map does not have are left out.
///
/// Errors: `MAPD_CODE_ARGUMENT` for a number that there is not.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_junction_group_members(
    snapshot: *const mapd_snapshot,
    number: u32,
    out: *mut mapd_junction_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let members = group(map_of(snapshot)?, number)?.members();
            let all = members.filter_map(|one| Some(one.junction()?.junction_id().into()));
            List { out, capacity, count }.write(all)
        })
    }
}

/// Lanes of a roundabout's ring, by its group's number; none of other groups.
///
/// Errors: `MAPD_CODE_ARGUMENT` for a number that there is not.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_junction_group_ring(
    snapshot: *const mapd_snapshot,
    number: u32,
    out: *mut mapd_lane_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let ring = group(map_of(snapshot)?, number)?.ring();
            List { out, capacity, count }.write(ring.map(Into::into))
        })
    }
}

/// All controllers in file order: controller k has the number k.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_controllers(
    snapshot: *const mapd_snapshot,
    out: *mut mapd_controller,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.controllers().map(|one| mapd_controller {
                id: one.id().into(),
                name: one.name().into(),
                sequence: one.sequence().unwrap_or(-1),
            });
            List { out, capacity, count }.write(all)
        })
    }
}

/// Signals of a controller that the map has, in file order, by its number.
///
/// Errors: `MAPD_CODE_ARGUMENT` for a number that there is not.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_controller_signals(
    snapshot: *const mapd_snapshot,
    number: u32,
    out: *mut mapd_signal_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = controller(map_of(snapshot)?, number)?.signals();
            List { out, capacity, count }.write(all.map(|one| one.signal_id().into()))
        })
    }
}

/// Numbers of the controllers that switch a signal.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_signal_controllers(
    snapshot: *const mapd_snapshot,
    signal: mapd_signal_id,
    out: *mut u32,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = map_of(snapshot)?.signal(signal.into())?.controllers();
            List { out, capacity, count }.write(all.map(|one| one.controller_id().row()))
        })
    }
}

/// Numbers of the controllers of a junction's synchronisation group, in file order; those that the map does not have are left out.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_junction_controllers(
    snapshot: *const mapd_snapshot,
    junction: mapd_junction_id,
    out: *mut u32,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let all = junction_of(snapshot, junction)?.controllers();
            let all = all.filter_map(|one| Some(one.controller()?.controller_id().row()));
            List { out, capacity, count }.write(all)
        })
    }
}

/// What a signal names; `which` is a `MAPD_SIGNAL_LINKS_…`.
///
/// Errors: `MAPD_CODE_ARGUMENT` for an unknown `which`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_signal_links(
    snapshot: *const mapd_snapshot,
    signal: mapd_signal_id,
    which: u32,
    out: *mut mapd_signal_link,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (signal, list) =
                (map_of(snapshot)?.signal(signal.into())?, List { out, capacity, count });
            match which {
                MAPD_SIGNAL_LINKS_DEPENDENCIES => {
                    list.write(signal.dependencies().map(|one| link(&one)))
                }
                MAPD_SIGNAL_LINKS_BELONGINGS => list.write(signal.links().map(|one| link(&one))),
                _ => Err(Failure::argument(format!("{which} names no links of a signal"))),
            }
        })
    }
}
