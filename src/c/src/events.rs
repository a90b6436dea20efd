//! Following a map: generations, and the daemon's end and return.

use crate::client::{mapd_client, wait};
use crate::code::{answer, mapd_code, mapd_error};
use crate::list::{close, get, get_mut, hand_out, put};
use ::mapd_client::{Client, Events, MapEvent};
use std::sync::Arc;

/// A follower of a map. It belongs to one thread at a time and keeps its client.
pub struct mapd_events {
    /// Borrows from `client`; declared first, dropped first.
    events: Events<'static>,
    _client: Arc<Client>,
}

/// `kind` of an event: a newer generation is served; `mapd_client_snapshot` gives it from now on.
pub const MAPD_EVENT_GENERATION: u32 = 1;
/// `kind` of an event: a generation waits to be activated, see `mapd_client_pending`.
pub const MAPD_EVENT_PENDING: u32 = 2;
/// `kind` of an event: the daemon has ended. Snapshots stay readable; new subscribers cannot attach.
pub const MAPD_EVENT_DAEMON_GONE: u32 = 3;
/// `kind` of an event: a daemon serves the map again, or another daemon has replaced the one before.
pub const MAPD_EVENT_DAEMON_BACK: u32 = 4;
/// `kind` of an event that this release does not know.
pub const MAPD_EVENT_OTHER: u32 = 255;

/// An event of a map or its daemon.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct mapd_event {
    /// A `MAPD_EVENT_…`.
    pub kind: u32,
    /// Of `DAEMON_BACK`: its process id, in its own process namespace; 0 if it is not known.
    pub pid: u32,
    /// Of `GENERATION` and `PENDING`: the number.
    pub generation: u64,
}

/// Follows the map from now on. Each follower sees every event; a change that is undone between two calls gives no event. Close it
/// with `mapd_events_close`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_events_new(
    client: *const mapd_client,
    out: *mut *mut mapd_events,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let client = get(client, "a client")?.0.clone();
            // SAFETY: the client lies in the `Arc` that moves into the same handle; it neither moves nor ends before the events, which are
            // dropped first, are private, and are never handed out.
            let borrowed: &'static Client = &*Arc::as_ptr(&client);
            hand_out(out, mapd_events { events: borrowed.events(), _client: client })
        })
    }
}

/// Closes a follower and sets the handle to null. Null, or a handle that is null, is fine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_events_close(events: *mut *mut mapd_events) {
    unsafe { close(events) }
}

/// The next event; waits at most `wait_s` \[s\]. `MAPD_CODE_NONE`: no event.
///
/// Errors: the transport failed, or the new archive cannot be read; the old snapshot stays valid, and the next call continues.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_events_next(
    events: *mut mapd_events,
    wait_s: f64,
    out: *mut mapd_event,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            get(out, "the answer")?;
            let wait = wait(wait_s)?;
            let none = mapd_event { kind: MAPD_EVENT_OTHER, pid: 0, generation: 0 };
            let event = match get_mut(events, "events")?.events.next(wait)? {
                None => return Ok(mapd_code::NONE),
                Some(MapEvent::Generation(snapshot)) => mapd_event {
                    kind: MAPD_EVENT_GENERATION,
                    generation: snapshot.generation(),
                    ..none
                },
                Some(MapEvent::Pending { generation }) => {
                    mapd_event { kind: MAPD_EVENT_PENDING, generation, ..none }
                }
                Some(MapEvent::DaemonGone) => mapd_event { kind: MAPD_EVENT_DAEMON_GONE, ..none },
                Some(MapEvent::DaemonBack { pid }) => {
                    mapd_event { kind: MAPD_EVENT_DAEMON_BACK, pid, ..none }
                }
                Some(_) => none,
            };
            put(out, event)
        })
    }
}
