//! Events of a map and its daemon.

use crate::client::Client;
use crate::error::ClientError;
use crate::snapshot::Snapshot;
use mapd_transport::{AttachError, after};
use std::fmt;
use std::time::{Duration, Instant};

/// Interval of the checks whether the daemon lives, and so the longest delay until its end is known. A new generation is known at once.
const LOOK: Duration = Duration::from_millis(50);

/// An event of a map.
#[derive(Clone)]
#[non_exhaustive]
pub enum MapEvent {
    /// A newer generation is served. [`Client::snapshot`] returns it from now on; earlier snapshots stay valid.
    Generation(Snapshot),
    /// A generation is staged and waits to be activated; see [`Client::pending`] and [`Client::require`].
    Pending {
        /// Its number.
        generation: u64,
    },
    /// The daemon has ended or was killed. Snapshots stay readable; new subscribers cannot attach.
    DaemonGone,
    /// A daemon serves the map again, or another daemon has replaced the one before.
    DaemonBack {
        /// Its process id, in its own process namespace; 0 if it is not known.
        pid: u32,
    },
}

impl fmt::Debug for MapEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Generation(snapshot) => {
                f.debug_tuple("Generation").field(&snapshot.generation()).finish()
            }
            Self::Pending { generation } => {
                f.debug_struct("Pending").field("generation", generation).finish()
            }
            Self::DaemonGone => f.write_str("DaemonGone"),
            Self::DaemonBack { pid } => f.debug_struct("DaemonBack").field("pid", pid).finish(),
        }
    }
}

/// Follows a map; see [`Client::events`]. Each follower sees every event; a change
/// that is undone between two calls gives no event.
pub struct Events<'a> {
    client: &'a Client,
    seen: u64,
    pending: Option<u64>,
    daemon: Option<u32>,
}

impl Client {
    /// Follows the map from now on, in the thread that calls [`Events::next`].
    ///
    /// ```no_run
    /// use mapd_client::{Client, MapEvent};
    /// use std::time::Duration;
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let client = Client::connect("town", Duration::from_secs(5))?;
    /// let mut events = client.events();
    /// loop {
    ///     match events.next(Duration::from_secs(1))? {
    ///         Some(MapEvent::Generation(snapshot)) => println!("generation {}", snapshot.generation()),
    ///         Some(MapEvent::DaemonGone) => println!("the daemon is gone; the snapshot stays valid"),
    ///         Some(_) | None => {}
    ///     }
    /// }
    /// # }
    /// ```
    pub fn events(&self) -> Events<'_> {
        let (seen, daemon) = (self.snapshot().generation(), self.served_by());
        Events { client: self, seen, pending: None, daemon }
    }
}

impl Events<'_> {
    /// The next event; waits `deadline` at most. `None`: no event.
    ///
    /// Errors: the transport failed, or the new archive cannot be read. The old snapshot stays valid, and the next call
    /// continues.
    pub fn next(&mut self, deadline: Duration) -> Result<Option<MapEvent>, ClientError> {
        let until = after(deadline);
        loop {
            if let Some(event) = self.look() {
                return Ok(Some(event));
            }
            let left = until.saturating_duration_since(Instant::now());
            match self.client.wait_newer(self.seen, left.min(LOOK)) {
                Ok(snapshot) => {
                    self.seen = snapshot.generation();
                    return Ok(Some(MapEvent::Generation(snapshot)));
                }
                Err(ClientError::Attach(AttachError::NoGeneration { .. })) => {}
                Err(error) => return Err(error),
            }
            if left.is_zero() {
                return Ok(self.look());
            }
        }
    }

    /// Changes other than a new generation.
    fn look(&mut self) -> Option<MapEvent> {
        let daemon = self.client.served_by();
        let before = std::mem::replace(&mut self.daemon, daemon);
        match (before, daemon) {
            (Some(_), None) => return Some(MapEvent::DaemonGone),
            (None, Some(pid)) => return Some(MapEvent::DaemonBack { pid }),
            // A daemon that has just claimed the map has not said who it is.
            (Some(before), Some(pid)) if before != 0 && pid != 0 && before != pid => {
                return Some(MapEvent::DaemonBack { pid });
            }
            _ => {}
        }
        let pending = self.client.pending().map(|info| info.generation);
        if std::mem::replace(&mut self.pending, pending) == pending {
            return None;
        }
        pending.map(|generation| MapEvent::Pending { generation })
    }
}

impl fmt::Debug for Events<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Events")
            .field("seen", &self.seen)
            .field("pending", &self.pending)
            .field("daemon", &self.daemon)
            .finish_non_exhaustive()
    }
}
