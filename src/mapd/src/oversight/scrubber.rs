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
    let proof = prove(domain, board, map);
    note(board, map, proof, start.elapsed());
}

/// Writes down, and says, what came of a proof.
fn note(board: &Board, map: &str, proof: Proof, taken: Duration) {
    match proof {
        Proof::Sound(generation) => {
            board.map(map, |state| state.scrubs.succeeded(taken));
            tracing::debug!(map = %map, generation, seconds = taken.as_secs_f64(), "map {map}: generation {generation} proves");
        }
        Proof::Damaged { generation, reason: text } => {
            let mut is_served = false;
            board.map(map, |state| {
                // What has taken its place was proved when it was filled in.
                is_served = state.served.as_ref().map(|served| served.generation) == generation;
                if is_served {
                    state.scrubs.failed(text.clone());
                }
            });
            if !is_served {
                tracing::info!(map = %map, error = %text, "map {map}: a generation that is not served any more failed verification: {text}");
                return;
            }
            tracing::error!(map = %map, error = %text, "map {map}: the served archive fails verification: {text}");
        }
        Proof::NotExamined(text) => {
            board.map(map, |state| state.scrubs.skipped(text.clone()));
            tracing::warn!(map = %map, error = %text, "map {map}: no verification, because the daemon cannot attach: {text}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::GenerationStatus;

    /// A scrub that ended after a reload once said of the new generation what it had found of the one before: the watchdog stayed silent
    /// until the next scrub.
    #[test]
    fn what_is_found_of_a_generation_is_said_of_no_other() {
        let board = Board::new(&Domain::new("scrubber_").expect("a prefix"), None);
        let serve = |generation| {
            let served = GenerationStatus { generation, ..GenerationStatus::default() };
            board.map("town", |state| state.served = Some(served));
        };
        let find = |generation| {
            let proof = Proof::Damaged { generation, reason: "bad".to_owned() };
            note(&board, "town", proof, Duration::ZERO);
            let state = board.status().maps.into_iter().next().expect("the map");
            (state.scrubs.failures, state.scrubs.last_failed)
        };
        serve(2);
        assert_eq!(find(Some(1)), (0, None), "it is not served any more");
        assert_eq!(find(None), (0, None), "nothing was served");
        assert_eq!(find(Some(2)), (1, Some(true)));
    }
}
