//! Attaching to a served map and following its generations.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::list::{close, get, hand_out, put, put_some};
use crate::snapshot::mapd_snapshot;
use crate::text::{given, given_or_null};
use ::mapd_client::AttachError;
use ::mapd_client::{Client, ClientError, Domain};
use std::ffi::c_char;
use std::sync::Arc;
use std::time::Duration;

/// A connection to one served map. Several threads may use it at once.
pub struct mapd_client(pub(crate) Arc<Client>);

/// A generation of a map in shared memory.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct mapd_generation {
    /// Its number; rises with every swap.
    pub generation: u64,
    /// Length of its archive in bytes.
    pub length: u64,
}

/// A wait in seconds; infinity waits without a limit.
///
/// Errors: negative or not a number.
pub(crate) fn wait(seconds: f64) -> Result<Duration, Failure> {
    if seconds >= 0.0 {
        return Ok(Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX));
    }
    Err(Failure::argument(format!("expected seconds to wait, 0 or more, found {seconds}")))
}

unsafe fn client<'a>(client: *const mapd_client) -> Result<&'a Client, Failure> {
    unsafe { Ok(&get(client, "a client")?.0) }
}

/// Connects to the map of this name, whichever side starts first, and pins its newest generation. Waits at most `wait_s` \[s\];
/// infinity waits without a limit. `prefix` names the domain; null: the one of the environment variable MAPD_PREFIX, else the default one.
/// `MAPD_OWNER` names the user whose daemon is trusted, whatever the prefix; without it, this process's own.
/// Close the client with `mapd_client_close`.
///
/// Errors: the codes of attaching, what was missing when the wait ended; `MAPD_CODE_NAME`; `MAPD_CODE_NOT_AN_ARCHIVE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_connect(
    map: *const c_char,
    prefix: *const c_char,
    wait_s: f64,
    out: *mut *mut mapd_client,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            get(out, "the handle")?;
            let (map, wait) = (given(map, "the map's name")?, wait(wait_s)?);
            let named = given_or_null(prefix, "the prefix")?;
            let domain = Domain::from_env_or(named);
            let domain = domain.map_err(|e| ClientError::from(AttachError::from(e)))?;
            hand_out(out, mapd_client(Arc::new(Client::connect_in(&domain, map, wait)?)))
        })
    }
}

/// Closes a client and sets the handle to null. Snapshots and events that came from it stay valid. Null, or a handle that is null,
/// is fine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_close(client: *mut *mut mapd_client) {
    unsafe { close(client) }
}

/// The newest generation that this client has seen. Does not look for a newer one. Close it with `mapd_snapshot_close`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_snapshot(
    client_handle: *const mapd_client,
    out: *mut *mut mapd_snapshot,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || hand_out(out, mapd_snapshot(client(client_handle)?.snapshot()))) }
}

/// Looks for a newer generation without waiting and returns the newest. Close it with `mapd_snapshot_close`.
///
/// Errors: the transport failed, or the new archive cannot be read; the old snapshot stays valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_refresh(
    client_handle: *const mapd_client,
    out: *mut *mut mapd_snapshot,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || hand_out(out, mapd_snapshot(client(client_handle)?.refresh()?))) }
}

/// Waits at most `wait_s` \[s\] for a generation newer than the newest that this client has seen. Close it with `mapd_snapshot_close`.
///
/// Errors: `MAPD_CODE_NO_GENERATION` if none came in time; as `mapd_client_refresh`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_wait_next(
    client_handle: *const mapd_client,
    wait_s: f64,
    out: *mut *mut mapd_snapshot,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let next = client(client_handle)?.wait_next(wait(wait_s)?)?;
            hand_out(out, mapd_snapshot(next))
        })
    }
}

/// Waits at most `wait_s` \[s\] for another generation, or for another overlay over the one that is served: `out` gets 1 if one has come. Then
/// `mapd_client_snapshot` has it.
///
/// Errors: as `mapd_client_refresh`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_wait_change(
    client_handle: *const mapd_client,
    wait_s: f64,
    out: *mut u8,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            get(out, "the answer")?;
            put(out, client(client_handle)?.wait_change(wait(wait_s)?)?.into())
        })
    }
}

/// Waits at most `wait_s` \[s\] for the generation of this number: processes that must change over together agree on the number of a staged
/// generation, see `mapd_client_pending`, and each requires it. Close it with `mapd_snapshot_close`.
///
/// Errors: `MAPD_CODE_SUPERSEDED` if a newer one is served already; as `mapd_client_wait_next`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_require(
    client_handle: *const mapd_client,
    generation: u64,
    wait_s: f64,
    out: *mut *mut mapd_snapshot,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let wanted = client(client_handle)?.require(generation, wait(wait_s)?)?;
            hand_out(out, mapd_snapshot(wanted))
        })
    }
}

/// The generation that is staged: verified, in shared memory, and served once `mapd activate` is called. `MAPD_CODE_NONE` if there
/// is none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_pending(
    client_handle: *const mapd_client,
    out: *mut mapd_generation,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let pending = client(client_handle)?
                .pending()
                .map(|info| mapd_generation { generation: info.generation, length: info.length });
            put_some(out, pending)
        })
    }
}

/// Process id of the daemon that serves the map, in its own process namespace; 0 if it is not known. `MAPD_CODE_NONE` if no daemon serves it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_served_by(
    client_handle: *const mapd_client,
    pid: *mut u32,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put_some(pid, client(client_handle)?.served_by())) }
}

/// Time since the daemon's last heartbeat \[s\]. A daemon that serves the map writes one about once a second. If the age exceeds a few seconds, the daemon
/// was killed, is stopped or gets no processor time, and the snapshot may be out of date. The clock is the monotonic one, which stops while the
/// machine sleeps. `MAPD_CODE_NONE` if the map is no longer served.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_heartbeat_age(
    client_handle: *const mapd_client,
    age_s: *mut f64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            put_some(age_s, client(client_handle)?.heartbeat_age().map(|age| age.as_secs_f64()))
        })
    }
}

/// Sets whether all pages of a generation are mapped before it is returned, starting with the current one, so that no query waits
/// for the kernel: as `mapd_snapshot_populate`. 0: no, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_set_populate(
    client_handle: *const mapd_client,
    populate: u8,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            client(client_handle)?.set_populate(populate != 0);
            Ok(mapd_code::OK)
        })
    }
}

/// Number of the newest generation that this client has seen.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_client_generation(
    client_handle: *const mapd_client,
    out: *mut u64,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe { answer(error, || put(out, client(client_handle)?.snapshot().generation())) }
}
