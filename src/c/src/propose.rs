//! Telling the daemon what a process on board has seen.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::list::{get, put};
use crate::text::{given, given_or_null};
use mapd_client::Domain;
use mapd_client::overlay::{Decision, ProposeError, Proposer};
use mapd_client::{AttachError, ClientError};
use std::ffi::c_char;

/// What becomes of a proposal that is not refused.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct mapd_decision {
    /// 1: it is laid over the map, and readers see it. 0: others must say the same first.
    pub is_accepted: u8,
    /// Where it is not: sources that have said so, with this one.
    pub agree: u32,
    /// Where it is not: sources that must.
    pub needed: u32,
}

/// Proposes an entry of an overlay to the daemon that serves a map, and waits at most `wait_s` \[s\] for its decision. `prefix` as for
/// `mapd_client_connect`. `source` is what the process calls itself: the daemon's policy names it. `entry` is JSON by
/// schemas/overlay.schema.json; one of the same id is replaced, and so goes on to hold.
///
/// Errors: `MAPD_CODE_REFUSED`, with the daemon's reason as the message; `MAPD_CODE_NO_DAEMON` if none takes proposals
/// (`--overlay-from`); `MAPD_CODE_PERMISSION_DENIED`; `MAPD_CODE_LATE`, and it may still be taken; `MAPD_CODE_ARGUMENT` for a longer entry than
/// 64 KiB; `MAPD_CODE_TRANSPORT`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_propose(
    map: *const c_char,
    prefix: *const c_char,
    source: *const c_char,
    entry: *const c_char,
    wait_s: f64,
    out: *mut mapd_decision,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            get(out, "the decision")?;
            let (map, wait) = (given(map, "the map's name")?, crate::client::wait(wait_s)?);
            let named = given_or_null(prefix, "the prefix")?;
            let domain = Domain::from_env_or(named);
            let domain = domain.map_err(|e| ClientError::from(AttachError::from(e)))?;
            let proposer = Proposer::new(&domain, map, given(source, "the source")?);
            let decision = match proposer.propose(given(entry, "the entry")?, wait)? {
                Decision::Accepted => mapd_decision { is_accepted: 1, agree: 0, needed: 0 },
                Decision::Waiting { agree, needed } => {
                    mapd_decision { is_accepted: 0, agree, needed }
                }
                Decision::Refused { reason } => {
                    return Err(Failure::new(mapd_code::REFUSED, reason));
                }
            };
            put(out, decision)
        })
    }
}

impl From<ProposeError> for Failure {
    #[cold]
    fn from(error: ProposeError) -> Self {
        let code = match &error {
            ProposeError::NoDaemon { .. } => mapd_code::NO_DAEMON,
            ProposeError::Denied { .. } => mapd_code::PERMISSION_DENIED,
            ProposeError::Unfit => mapd_code::ARGUMENT,
            ProposeError::Late { .. } => mapd_code::LATE,
            ProposeError::Io { .. } => mapd_code::TRANSPORT,
            _ => mapd_code::OTHER,
        };
        Self::new(code, error.to_string())
    }
}
