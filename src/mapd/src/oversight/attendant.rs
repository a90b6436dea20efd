//! The service manager's view: ready once every map has answered a query of the daemon's own, and alive as long as none
//! answers wrongly or not at all. Where there is no room to ask, nothing is known to be wrong, and a daemon that is started
//! again would have less of it: that alone never keeps the watchdog waiting. Nor does it that maps are many: those for which
//! there was no time are the first to be asked in the next round, and what a map answered last counts until then.

use super::periodic::{Periodic, Stop};
use super::self_query::{WAIT, ask};
use crate::control::{Board, MapState};
use mapd_client::Domain;
use sd_notify::NotifyState;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Pause before a first query that failed is tried again.
const PAUSE: Duration = Duration::from_millis(100);

/// Queries in one interval of the watchdog: two may fail or come late before the service manager acts.
const PER_INTERVAL: u32 = 3;

/// Wait for a map that is asked when the time of its round is nearly over: a client attaches in milliseconds.
const LEAST_WAIT: Duration = Duration::from_millis(100);

/// Begins to attend.
pub(super) fn start(
    domain: &Domain,
    board: &Arc<Board>,
    maps: &[String],
    stop: &Arc<Stop>,
) -> Periodic {
    let mut maps = Maps::new(domain, board, maps);
    Periodic::spawn("attendant", stop, move |stop| {
        while !maps.have_all_answered(stop) {
            if stop.sleep(PAUSE) {
                return;
            }
        }
        let status = format!("serving {}", maps.names());
        tell(&[NotifyState::Ready, NotifyState::Status(&status)]);
        tracing::debug!("ready: every map has answered a query of the daemon's own");
        let Some(interval) = sd_notify::watchdog_enabled() else { return };
        let pause = interval / PER_INTERVAL;
        while !stop.sleep(pause) {
            if maps.are_sound(WAIT.min(pause), stop) {
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

/// What came of asking a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Answer {
    Right,
    /// There was no room to ask.
    NoRoom,
    Wrong,
}

/// A map, and what came of asking it.
struct Asked {
    name: String,
    /// The newest generation that has answered.
    seen: u64,
    last: Option<Answer>,
}

/// All maps.
struct Maps {
    domain: Domain,
    board: Arc<Board>,
    maps: Vec<Asked>,
    /// The one that is asked first in the next round.
    next: usize,
}

impl Maps {
    fn new(domain: &Domain, board: &Arc<Board>, names: &[String]) -> Self {
        let asked = |name: &String| Asked { name: name.clone(), seen: 0, last: None };
        let maps = names.iter().map(asked).collect();
        Self { domain: domain.clone(), board: board.clone(), maps, next: 0 }
    }

    fn names(&self) -> String {
        let names: Vec<&str> = self.maps.iter().map(|map| map.name.as_str()).collect();
        names.join(", ")
    }

    /// Asks the maps that have not answered yet; whether none is left.
    fn have_all_answered(&mut self, stop: &Stop) -> bool {
        for map in self.maps.iter_mut().filter(|map| map.last != Some(Answer::Right)) {
            if stop.is_requested() {
                return false;
            }
            map.ask(&self.domain, &self.board, WAIT);
        }
        self.maps.iter().all(|map| map.last == Some(Answer::Right))
    }

    /// Asks as many maps as there is time for; whether none is known to be wrong.
    fn are_sound(&mut self, wait: Duration, stop: &Stop) -> bool {
        // For all maps together, so that the watchdog hears in time also where each query waits for room.
        let until = Instant::now() + wait;
        for _ in 0..self.maps.len() {
            if stop.is_requested() {
                return false;
            }
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() {
                break;
            }
            if let Some(map) = self.maps.get_mut(self.next) {
                map.ask(&self.domain, &self.board, left.max(LEAST_WAIT));
            }
            self.next = (self.next + 1) % self.maps.len();
        }
        let scrubs_fail = |status: &MapState| status.scrubs.last_failed == Some(true);
        !self.maps.iter().any(|map| map.last == Some(Answer::Wrong))
            && !self.board.status().maps.iter().any(scrubs_fail)
    }
}

impl Asked {
    /// Asks; writes down what came of it.
    fn ask(&mut self, domain: &Domain, board: &Board, wait: Duration) {
        let map = self.name.as_str();
        let answer = match ask(domain, map, self.seen, wait) {
            Ok(answered) => {
                self.seen = answered.generation;
                board.map(map, |state| state.self_queries.succeeded(answered.taken));
                Answer::Right
            }
            Err(error) if error.is_no_verdict() => {
                let text = error.to_string();
                tracing::warn!(map = %map, error = %text, "map {map}: no room for a query of the daemon's own: {text}");
                board.map(map, |state| state.self_queries.skipped(text));
                Answer::NoRoom
            }
            Err(error) => {
                let text = error.to_string();
                tracing::error!(map = %map, error = %text, "map {map}: a query of the daemon's own failed: {text}");
                board.map(map, |state| state.self_queries.failed(text));
                Answer::Wrong
            }
        };
        self.last = Some(answer);
    }
}
