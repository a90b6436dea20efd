//! How a running daemon is asked and told: a Unix socket per map in the domain's root folder.
//!
//! Why a socket and not a request-response service of iceoryx2: a service is made of segments in shared memory, each of
//! which is half made at some system call; a process that is killed there is in everybody's way until a daemon has cleaned
//! up. A socket is the kernel's: if either side is killed, at any system call, the other reads the end of the stream at once,
//! and the name that a killed daemon leaves refuses connections until the next one, which holds the map's claim, replaces
//! it. Nothing can wait for ever, and readers of maps never meet it.
//!
//! One line of JSON each way: a [`Request`], a [`Response`]. The root folder has mode 0700, the socket 0600: only the
//! domain's user gets through.
//!
//! Invariants: a daemon never waits for a client (deadlines on both sides, a bound on connections and on the length of a
//! line); a request runs to its end whether or not its client still listens.

mod ask;
mod board;
mod listener;
mod message;
mod status;

pub use ask::{AskError, ask};
pub use board::Board;
pub use listener::ControlListener;
pub use message::{ListedEntry, OverlayAction, OverlayReport, Request, Response};
pub use status::{
    CacheStatus, CheckStatus, DaemonStatus, GenerationStatus, MapCounts, MapState, OverlayStatus,
    ReloadReport, ReloadResult, Trigger,
};

use mapd_client::Domain;
use std::path::PathBuf;

/// Longest answer \[bytes\]: a list of overlay entries.
const LONGEST_LINE: u64 = 64 << 20;

/// The socket of a map. Its name holds a hash instead of the map's name: the path of a socket has 107 bytes.
fn socket_path(domain: &Domain, map: &str) -> PathBuf {
    let hash = blake3::hash(map.as_bytes()).to_hex();
    domain.root().join(format!("control-{}", &hash[..16]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_names_fit_a_socket() {
        let domain = Domain::new("abcdefghijklmnopqrs_").expect("a prefix");
        let path = socket_path(&domain, &"m".repeat(mapd_transport::MAX_MAP_NAME_LENGTH));
        assert!(path.as_os_str().len() < 100, "{}", path.display());
    }
}
