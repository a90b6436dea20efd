//! The service manager's view: ready once every map has answered a query of the daemon's own, and alive as long as none
//! answers wrongly or not at all. Where there is no room to ask, nothing is known to be wrong, and a daemon that is started
//! again would have less of it: that alone never keeps the watchdog waiting.

use super::periodic::{Periodic, Stop};
use super::self_query::{WAIT, ask};
use crate::control::Board;
use mapd_client::Domain;
use sd_notify::NotifyState;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Pause before a first query that failed is tried again.
const PAUSE: Duration = Duration::from_millis(100);

/// Queries in one interval of the watchdog: two may fail or come late before the service manager acts.
const PER_INTERVAL: u32 = 3;

/// Wait for a map where those before it have used up the time.
const LEAST_WAIT: Duration = Duration::from_millis(20);

/// Begins to attend.
pub(super) fn start(
    domain: &Domain,
    board: &Arc<Board>,
    maps: &[String],
    stop: &Arc<Stop>,
) -> Periodic {
    let (domain, board, maps) = (domain.clone(), board.clone(), maps.to_vec());
    Periodic::spawn("attendant", stop, move |stop| {
        let mut maps = Asked::new(domain, board.clone(), maps);
        // No watchdog waits yet.
        while !maps.all_answered {
            maps.ask(None, stop);
            if !maps.all_answered && stop.sleep(PAUSE) {
                return;
            }
        }
        let status = format!("serving {}", maps.join(", "));
        tell(&[NotifyState::Ready, NotifyState::Status(&status)]);
        tracing::debug!("ready: every map has answered a query of the daemon's own");
        let Some(interval) = sd_notify::watchdog_enabled() else { return };
        let pause = interval / PER_INTERVAL;
        let wait = WAIT.min(pause);
        while !stop.sleep(pause) {
            let sound = board.status().maps.iter().all(|map| map.scrubs.last_failed != Some(true));
            if ask_all(&domain, &board, &maps, &mut seen, (wait, stop)) != Answers::Wrong && sound {
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

/// What came of asking all maps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Answers {
    All,
    /// There was no room to ask some of them.
    NoRoom,
    Wrong,
}

/// Asks every map; writes down what came of it.
fn ask_all(
    domain: &Domain,
    board: &Board,
    maps: &[String],
    seen: &mut BTreeMap<String, u64>,
    (wait, stop): (Duration, &Stop),
) -> Answers {
    let mut all = Answers::All;
    // For all maps together, so that the watchdog hears in time also where each query waits for room.
    let until = Instant::now() + wait;
    for map in maps {
        if stop.is_requested() {
            return Answers::NoRoom;
        }
        all = all.max(ask_one(domain, board, map, seen, until));
    }
    all
}

/// Asks a map; writes down what came of it.
fn ask_one(
    domain: &Domain,
    board: &Board,
    map: &str,
    seen: &mut BTreeMap<String, u64>,
    until: Instant,
) -> Answers {
    let before = seen.get(map).copied().unwrap_or(0);
    let left = until.saturating_duration_since(Instant::now()).max(LEAST_WAIT);
    match ask(domain, map, before, left) {
        Ok(answered) => {
            seen.insert(map.to_owned(), answered.generation);
            board.map(map, |state| state.self_queries.succeeded(answered.taken));
            Answers::All
        }
        Err(error) if error.is_no_verdict() => {
            let text = error.to_string();
            tracing::warn!(map = %map, error = %text, "map {map}: no room for a query of the daemon's own: {text}");
            board.map(map, |state| state.self_queries.skipped(text));
            Answers::NoRoom
        }
        Err(error) => {
            let text = error.to_string();
            tracing::error!(map = %map, error = %text, "map {map}: a query of the daemon's own failed: {text}");
            board.map(map, |state| state.self_queries.failed(text));
            Answers::Wrong
        }
    }
}
