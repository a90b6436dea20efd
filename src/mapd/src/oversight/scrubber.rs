//! Proving what is served, again and again: memory can go bad.

use super::periodic::{Periodic, Stop};
use super::proof::{Proof, prove};
use crate::control::Board;
use mapd_transport::Domain;
use std::sync::Arc;
use std::time::{Duration, Instant};

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
    match prove(domain, board, map) {
        Proof::Sound(generation) => {
            let taken = start.elapsed();
            board.map(map, |state| state.scrubs.succeeded(taken));
            tracing::debug!(map = %map, generation, seconds = taken.as_secs_f64(), "map {map}: generation {generation} proves");
        }
        Proof::Damaged(text) => {
            board.map(map, |state| state.scrubs.failed(text.clone()));
            tracing::error!(map = %map, error = %text, "map {map}: the served archive fails verification: {text}");
        }
        Proof::NotExamined(text) => {
            board.map(map, |state| state.scrubs.skipped(text.clone()));
            tracing::warn!(map = %map, error = %text, "map {map}: no verification, because the daemon cannot attach: {text}");
        }
    }
}
