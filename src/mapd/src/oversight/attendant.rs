//! The service manager's view: ready once every map has answered a query of the daemon's own, and alive as long as they do.

use super::periodic::{Periodic, Stop};
use super::self_query::ask;
use crate::control::Board;
use mapd_client::Domain;
use sd_notify::NotifyState;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

/// Pause before a first query that failed is tried again.
const PAUSE: Duration = Duration::from_millis(100);

/// Queries in one interval of the watchdog: two may fail or come late before the service manager acts.
const PER_INTERVAL: u32 = 3;

/// Begins to attend.
pub(super) fn start(
    domain: &Domain,
    board: &Arc<Board>,
    maps: &[String],
    stop: &Arc<Stop>,
) -> Periodic {
    let (domain, board, maps) = (domain.clone(), board.clone(), maps.to_vec());
    Periodic::spawn("attendant", stop, move |stop| {
        let mut seen = BTreeMap::new();
        while !all_answer(&domain, &board, &maps, &mut seen) {
            if stop.sleep(PAUSE) {
                return;
            }
        }
        let status = format!("serving {}", maps.join(", "));
        tell(&[NotifyState::Ready, NotifyState::Status(&status)]);
        tracing::debug!("ready: every map has answered a query of the daemon's own");
        let Some(interval) = sd_notify::watchdog_enabled() else { return };
        while !stop.sleep(interval / PER_INTERVAL) {
            let sound = board.status().maps.iter().all(|map| map.scrubs.last_failed != Some(true));
            if all_answer(&domain, &board, &maps, &mut seen) && sound {
                tell(&[NotifyState::Watchdog]);
            }
        }
    })
}

/// Whether a service manager listens.
pub(super) fn is_managed() -> bool {
    std::env::var_os("NOTIFY_SOCKET").is_some()
}

/// Says that the daemon ends.
pub(super) fn stopping() {
    tell(&[NotifyState::Stopping]);
}

fn tell(states: &[NotifyState<'_>]) {
    if let Err(error) = sd_notify::notify(states) {
        tracing::warn!(%error, "the service manager cannot be told: {error}");
    }
}

/// Asks every map; writes down what came of it.
fn all_answer(
    domain: &Domain,
    board: &Board,
    maps: &[String],
    seen: &mut BTreeMap<String, u64>,
) -> bool {
    let mut all = true;
    for map in maps {
        let before = seen.get(map).copied().unwrap_or(0);
        match ask(domain, map, before) {
            Ok(answered) => {
                seen.insert(map.clone(), answered.generation);
                board.map(map, |state| state.self_queries.succeeded(answered.taken));
            }
            Err(error) => {
                let text = error.to_string();
                tracing::error!(map = %map, error = %text, "map {map}: a query of the daemon's own failed: {text}");
                board.map(map, |state| state.self_queries.failed(text));
                all = false;
            }
        }
    }
    all
}
