//! Telling the daemon what a process on board has seen: a lane that is closed, ice.
//!
//! ```text
//!  Proposer ── source, entry ──► the daemon's socket for proposals ── its policy decides ──► accepted, waiting, refused
//! ```
//!
//! What is accepted is laid over the map for all readers. By default a daemon has no such socket and accepts nothing (docs/overlay.md). Nothing here needs
//! iceoryx2; each proposal is a connection of its own, and none is waited for longer than is said.

use mapd_transport::{Domain, LONGEST_PROPOSAL, after, connect_until, proposals_socket};
use std::io::{self, Read, Write};
use std::net::Shutdown;
use std::path::PathBuf;
use std::time::Duration;
use thiserror::Error;

/// Longest answer \[bytes\].
const LONGEST_ANSWER: u64 = 4 << 10;

/// What becomes of a proposal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Decision {
    /// It is laid over the map, and readers see it.
    Accepted,
    /// Others must say the same first.
    Waiting {
        /// Sources that have said so, with this one.
        agree: u32,
        /// Sources that must.
        needed: u32,
    },
    /// It is not taken.
    Refused {
        /// Why.
        reason: String,
    },
}

/// Why a proposal has no decision.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ProposeError {
    /// No daemon serves the map, or the daemon accepts no proposals.
    #[error("map {map:?}: no daemon takes proposals (--overlay-from)")]
    NoDaemon {
        /// The map.
        map: String,
    },
    /// The socket is for others.
    #[error("map {map:?}: this user may not propose anything")]
    Denied {
        /// The map.
        map: String,
    },
    /// The proposal has more than 65,536 bytes, or the source's name has a line break.
    #[error(
        "a proposal has at most {LONGEST_PROPOSAL} bytes, and the name of its source is one line"
    )]
    Unfit,
    /// No decision arrived within the wait; it may still be made.
    #[error("map {map:?}: no decision within {} s", wait.as_secs_f64())]
    Late {
        /// The map.
        map: String,
        /// How long was waited.
        wait: Duration,
    },
    /// The socket cannot be used, or the answer not be understood.
    #[error("map {map:?}: proposal to the daemon: {source}")]
    Io {
        /// The map.
        map: String,
        /// What the system says.
        source: io::Error,
    },
}

/// Proposes entries of an overlay to the daemon that serves a map.
///
/// ```no_run
/// use mapd_client::Domain;
/// use mapd_client::overlay::{Decision, Proposer};
/// use std::time::Duration;
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let proposer = Proposer::new(&Domain::from_env()?, "town", "camera-front");
/// let cones = r#"{"id": "cones", "kind": "closed", "lanes": [{"road": "1", "s": [10, 40], "lane": -2}], "confidence": 0.9}"#;
/// match proposer.propose(cones, Duration::from_secs(1))? {
///     Decision::Accepted => println!("closed for all"),
///     Decision::Waiting { agree, needed } => println!("{agree} of {needed} say so"),
///     Decision::Refused { reason } => println!("not taken: {reason}"),
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Proposer {
    domain: Domain,
    path: PathBuf,
    map: String,
    source: String,
}

impl Proposer {
    /// A proposer to the daemon that serves a map of this name. `source` is what it calls itself: the daemon's policy names it. Nothing is connected yet.
    pub fn new(domain: &Domain, map: &str, source: &str) -> Self {
        let path = proposals_socket(domain, map);
        let domain = domain.clone();
        Self { domain, path, map: map.to_owned(), source: source.to_owned() }
    }

    /// Proposes an entry, as JSON by `schemas/overlay.schema.json`, and waits at most so long for the decision. An entry of the same id is replaced, and
    /// so goes on to hold.
    ///
    /// Errors: no daemon that takes proposals, no rights, no decision in time.
    pub fn propose(&self, entry: &str, wait: Duration) -> Result<Decision, ProposeError> {
        let length = self.source.len() + 1 + entry.len();
        if length > LONGEST_PROPOSAL || self.source.contains('\n') {
            return Err(ProposeError::Unfit);
        }
        self.exchange(entry, wait).map_err(|error| {
            let map = self.map.clone();
            match error.kind() {
                io::ErrorKind::NotFound | io::ErrorKind::ConnectionRefused => {
                    ProposeError::NoDaemon { map }
                }
                io::ErrorKind::PermissionDenied => ProposeError::Denied { map },
                io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut => {
                    ProposeError::Late { map, wait }
                }
                _ => ProposeError::Io { map, source: error },
            }
        })
    }

    fn exchange(&self, entry: &str, wait: Duration) -> io::Result<Decision> {
        let mut stream = connect_until(&self.domain, &self.path, after(wait))?;
        // A timeout of zero would be refused.
        let wait = Some(wait.max(Duration::from_millis(1)));
        stream.set_read_timeout(wait)?;
        stream.set_write_timeout(wait)?;
        // A daemon that refuses at once may close the socket before it has read the request.
        let written = stream
            .write_all(format!("{}\n{entry}", self.source).as_bytes())
            .and_then(|()| stream.shutdown(Shutdown::Write));
        let mut answer = String::new();
        stream.take(LONGEST_ANSWER).read_to_string(&mut answer)?;
        if answer.is_empty() {
            written?;
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        decision(answer.trim_end()).ok_or_else(|| io::ErrorKind::InvalidData.into())
    }
}

impl Decision {
    /// As the daemon writes it: `accepted`, `waiting 1 2`, `refused REASON`.
    pub fn line(&self) -> String {
        match self {
            Self::Accepted => "accepted".to_owned(),
            Self::Waiting { agree, needed } => format!("waiting {agree} {needed}"),
            Self::Refused { reason } => format!("refused {}", reason.replace('\n', " ")),
        }
    }
}

fn decision(line: &str) -> Option<Decision> {
    let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
    match word {
        "accepted" => Some(Decision::Accepted),
        "waiting" => {
            let (agree, needed) = rest.split_once(' ')?;
            Some(Decision::Waiting { agree: agree.parse().ok()?, needed: needed.parse().ok()? })
        }
        "refused" => Some(Decision::Refused { reason: rest.to_owned() }),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decisions_are_read_as_they_are_written() {
        let all = [
            Decision::Accepted,
            Decision::Waiting { agree: 1, needed: 3 },
            Decision::Refused { reason: "entry \"a\": no such road".to_owned() },
        ];
        for one in all {
            assert_eq!(decision(&one.line()), Some(one));
        }
        for wrong in ["", "yes", "waiting", "waiting 1", "waiting x 2"] {
            assert_eq!(decision(wrong), None, "{wrong}");
        }
    }
}
