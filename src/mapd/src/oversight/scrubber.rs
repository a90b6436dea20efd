//! Proving what is served, again and again: memory can go bad.

use super::periodic::{Periodic, Stop};
use crate::control::Board;
use crate::serve::reserving;
use mapd_client::transport::Domain;
use mapd_client::{Client, ClientError};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Longest wait for a map.
const WAIT: Duration = Duration::from_secs(2);

/// Begins to scrub.
pub(super) fn start(
    domain: &Domain,
    board: &Arc<Board>,
    maps: &[String],
    interval: Duration,
    stop: &Arc<Stop>,
) -> Periodic {
    let (domain, board, maps) = (domain.clone(), board.clone(), maps.to_vec());
    Periodic::spawn("scrubber", stop, move |stop| {
        while !stop.sleep(interval) {
            for map in &maps {
                if stop.is_requested() {
                    return;
                }
                one(&domain, &board, map);
            }
        }
    })
}

fn one(domain: &Domain, board: &Board, map: &str) {
    let start = Instant::now();
    let client = match reserving(|| Client::connect_in_reserve(domain, map, WAIT)) {
        Ok(client) => client,
        Err(error) => {
            // Bytes that nobody has looked at are not known to be bad.
            let text = error.to_string();
            board.map(map, |state| state.scrubs.skipped(text.clone()));
            tracing::warn!(map = %map, error = %text, "map {map}: nothing is proved, for the daemon cannot attach: {text}");
            return;
        }
    };
    match prove(&client) {
        Ok(generation) => {
            let taken = start.elapsed();
            board.map(map, |state| state.scrubs.succeeded(taken));
            tracing::debug!(map = %map, generation, seconds = taken.as_secs_f64(), "map {map}: generation {generation} proves");
        }
        Err(error) => {
            let text = error.to_string();
            board.map(map, |state| state.scrubs.failed(text.clone()));
            tracing::error!(map = %map, error = %text, "map {map}: what is served does not prove: {text}");
        }
    }
}

/// Proves the bytes that readers see, through a mapping like theirs, against the hash that was published with them. The
/// generation is let go afterwards.
fn prove(client: &Client) -> Result<u64, ClientError> {
    let snapshot = client.snapshot();
    snapshot.verify()?;
    Ok(snapshot.generation())
}
