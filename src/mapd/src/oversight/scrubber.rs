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
                one(&domain, &board, map);
            }
        }
    })
}

fn one(domain: &Domain, board: &Board, map: &str) {
    let start = Instant::now();
    match prove(domain, map) {
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
fn prove(domain: &Domain, map: &str) -> Result<u64, ClientError> {
    let client = reserving(|| Client::connect_in(domain, map, WAIT))?;
    let snapshot = client.snapshot();
    snapshot.verify()?;
    Ok(snapshot.generation())
}
