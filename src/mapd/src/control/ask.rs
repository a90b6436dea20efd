//! Asking a daemon.

use super::message::{Request, Response};
use super::{LONGEST_LINE, socket_path};
use crate::similar::did_you_mean;
use mapd_client::Domain;
use mapd_transport::{after, connect_until, list_maps};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::time::Duration;
use thiserror::Error;

/// Why a daemon does not answer.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum AskError {
    /// No daemon serves the map, or the daemon is starting or ending.
    #[error("map {map:?}: no daemon answers; {}", which(map, served))]
    NoDaemon {
        /// The map.
        map: String,
        /// Maps that are served now.
        served: Vec<String>,
    },
    /// The map's daemon ended without cleaning up, as if killed.
    #[error(
        "map {map:?}: its daemon was killed; readers keep what they hold; start it again: mapd --load FILE --name {map}"
    )]
    Killed {
        /// The map.
        map: String,
    },
    /// No answer arrived within the wait; the request may still be carried out.
    #[error(
        "map {map:?}: no answer within {} s; the daemon goes on with what was asked, `mapd status` tells what became of it",
        wait.as_secs_f64()
    )]
    Late {
        /// The map.
        map: String,
        /// How long was waited.
        wait: Duration,
    },
    /// The daemon ended before it answered.
    #[error("map {map:?}: the daemon ended before it answered; readers keep what they hold")]
    Ended {
        /// The map.
        map: String,
    },
    /// The answer is one to another question.
    #[error(
        "map {map:?}: the daemon sent an unexpected answer; are daemon and command of the same release?"
    )]
    Unexpected {
        /// The map.
        map: String,
    },
    /// Only the daemon's user may ask it.
    #[error(
        "map {map:?}: only user {owner}, who runs its daemon, may ask it; run the command as that user"
    )]
    Denied {
        /// The map.
        map: String,
        /// User id of the domain's owner.
        owner: u32,
    },
    /// The socket cannot be used, or the answer not be understood.
    #[error("map {map:?}: request to the daemon: {source}")]
    Io {
        /// The map.
        map: String,
        /// What the system says.
        source: io::Error,
    },
}

/// What is served instead.
fn which(map: &str, served: &[String]) -> String {
    if served.is_empty() {
        return "no map is served: `mapd --load FILE` serves one".to_owned();
    }
    let meant = did_you_mean(map, served.iter().map(String::as_str));
    format!("served are {}{meant}", served.join(", "))
}

/// Why nobody answers for a map. Who cannot see the domain sees no maps.
fn no_daemon(domain: &Domain, map: String) -> AskError {
    let maps = list_maps(domain).unwrap_or_default();
    if maps.iter().any(|one| !one.alive && one.name == map) {
        return AskError::Killed { map };
    }
    // The daemon of the one asked for may be ending.
    let others = maps.into_iter().filter(|one| one.alive && one.name != map);
    AskError::NoDaemon { served: others.map(|one| one.name).collect(), map }
}

/// Asks the daemon that serves `map`, and waits for its answer at most so long.
///
/// Errors: no daemon, no answer in time, a daemon that ends meanwhile.
pub fn ask(
    domain: &Domain,
    map: &str,
    request: &Request,
    wait: Duration,
) -> Result<Response, AskError> {
    let fail = |error: io::Error| {
        let map = map.to_owned();
        match error.kind() {
            io::ErrorKind::NotFound | io::ErrorKind::ConnectionRefused => no_daemon(domain, map),
            io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut => AskError::Late { map, wait },
            io::ErrorKind::BrokenPipe
            | io::ErrorKind::ConnectionReset
            | io::ErrorKind::UnexpectedEof => AskError::Ended { map },
            io::ErrorKind::PermissionDenied => AskError::Denied { map, owner: domain.owner() },
            _ => AskError::Io { map, source: error },
        }
    };
    exchange(domain, map, request, wait).map_err(fail)
}

fn exchange(domain: &Domain, map: &str, request: &Request, wait: Duration) -> io::Result<Response> {
    let mut stream = connect_until(domain, &socket_path(domain, map), after(wait))?;
    // A timeout of zero would be refused.
    let wait = Some(wait.max(Duration::from_millis(1)));
    stream.set_read_timeout(wait)?;
    stream.set_write_timeout(wait)?;
    let mut line = serde_json::to_vec(request)?;
    line.push(b'\n');
    // A daemon that refuses may have answered and closed the socket before it has read the request.
    let written = match stream.write_all(&line) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Err(error),
        other => Ok(other?),
    };
    let mut answer = String::new();
    let read = BufReader::new(stream.take(LONGEST_LINE)).read_line(&mut answer);
    if answer.is_empty() {
        written?;
    }
    read?;
    if !answer.ends_with('\n') {
        return Err(io::ErrorKind::UnexpectedEof.into());
    }
    Ok(serde_json::from_str(&answer)?)
}
