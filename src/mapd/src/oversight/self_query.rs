//! A query as any client would ask it.

use crate::serve::reserving;
use mapd_client::compiling::ByRow as _;
use mapd_client::{Attach, AttachError, Client, ClientError, NearestOptions, QueryError};
use mapd_transport::Domain;
use std::time::{Duration, Instant};
use thiserror::Error;

/// Longest wait for a map: a client attaches in milliseconds, and daemons clean up for less than a second.
pub(crate) const WAIT: Duration = Duration::from_secs(2);

/// Why a daemon's own query has no answer.
#[derive(Debug, Error)]
pub(crate) enum SelfQueryError {
    /// A newcomer cannot attach.
    #[error(transparent)]
    Client(#[from] ClientError),
    /// The map cannot be asked.
    #[error(transparent)]
    Query(#[from] QueryError),
    /// A newcomer gets an older generation than one before.
    #[error("generation {found} came after {before}")]
    WentBack {
        /// The generation that came.
        found: u64,
        /// One that came earlier.
        before: u64,
    },
}

impl SelfQueryError {
    /// Whether this says nothing of what is served: there was no room to look at it.
    pub(crate) fn is_no_verdict(&self) -> bool {
        matches!(self, Self::Client(error) if could_not_look(error))
    }

    /// Whether a longer wait might have ended better: attaching was tried until the deadline.
    pub(crate) fn may_be_late(&self) -> bool {
        matches!(
            self,
            Self::Client(ClientError::Attach(
                AttachError::NoDaemon { .. }
                    | AttachError::NoSuchMap { .. }
                    | AttachError::NoGeneration { .. }
                    | AttachError::Busy { .. }
                    | AttachError::Stuck { .. }
                    | AttachError::Io { .. }
                    | AttachError::Iceoryx(_)
            ))
        )
    }
}

/// Whether a client met nothing but a lack of room for itself: shared memory is full, all places are taken, or
/// this process may open no more files. Readers keep
/// what they have, and another daemon could serve nothing better.
fn could_not_look(error: &ClientError) -> bool {
    matches!(
        error,
        ClientError::Attach(
            AttachError::NoRoom { .. }
                | AttachError::NoDescriptors { .. }
                | AttachError::TooManySubscribers { .. }
        )
    )
}

/// What an answer took.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Answered {
    pub(crate) generation: u64,
    pub(crate) taken: Duration,
}

/// Attaches anew in this way, within `wait`, asks for the lane at a point of the map's middle lane, and detaches.
///
/// Errors: what a client would meet; a generation older than `before`.
pub(crate) fn ask(
    attach: Attach,
    domain: &Domain,
    map: &str,
    before: u64,
    wait: Duration,
) -> Result<Answered, SelfQueryError> {
    let start = Instant::now();
    // What the client makes must not end the daemon by SIGBUS, should shared memory be filled up at this moment.
    let client = match attach {
        Attach::Subscriber => reserving(|| Client::connect_in_reserve(domain, map, wait))?,
        _ => Client::connect_as(attach, domain, map, wait)?,
    };
    let snapshot = client.snapshot();
    let view = snapshot.map();
    let middle = u32::try_from(view.tables().lanes.len() / 2).unwrap_or(0);
    if let Some(lane) = view.lane_by_row(middle)
        && let Some(point) = lane.center_line().positions().next()
    {
        view.nearest_lane(point.truncate(), &NearestOptions::default())?;
    }
    let found = snapshot.generation();
    if found < before {
        return Err(SelfQueryError::WentBack { found, before });
    }
    Ok(Answered { generation: found, taken: start.elapsed() })
}
