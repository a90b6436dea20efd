//! What the service manager is told: the daemon is ready when every map has answered a self-query, and alive as long as no map
//! gives a wrong answer or none. If there is no room for a self-query, nothing is known to be wrong, and a restarted daemon
//! would have even less room: this alone never delays the watchdog. Many maps do not delay it either. Maps for which a round
//! had no time are asked in the next rounds; until then their last answer counts. A map whose last answer was wrong is asked
//! first in every round, so it delays the watchdog no longer than necessary.

use super::periodic::{Periodic, Stop};
use super::rounds::{Maps, Surroundings};
use super::self_query::{Answered, SelfQueryError, ask};
use crate::control::Board;
use mapd_client::{Attach, Domain};
use sd_notify::NotifyState;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Pause before a first query that failed is tried again.
const PAUSE: Duration = Duration::from_millis(100);

/// Starts the thread.
pub(super) fn start(
    domain: &Domain,
    board: &Arc<Board>,
    maps: &[String],
    stop: &Arc<Stop>,
) -> Periodic {
    let mut maps = Maps::new(board, maps);
    let (domain, attach) = (domain.clone(), board.attach());
    let without_subscribers = board.status().without_subscribers;
    Periodic::spawn("attendant", stop, move |stop| {
        let served = Served { domain, attach, stop };
        while !maps.have_all_answered(&served) {
            if stop.sleep(PAUSE) {
                return;
            }
        }
        let status = match without_subscribers {
            Some(reason) => format!("serving {}, without subscribers: {reason}", maps.names()),
            None => format!("serving {}", maps.names()),
        };
        tell(&[NotifyState::Ready, NotifyState::Status(&status)]);
        tracing::debug!("ready: every map has answered a self-query");
        let Some(interval) = sd_notify::watchdog_enabled() else { return };
        maps.attend(interval, &served);
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
        tracing::warn!(%error, "the service manager cannot be notified: {error}");
    }
}

/// The maps as they are served.
struct Served<'a> {
    domain: Domain,
    attach: Attach,
    stop: &'a Stop,
}

impl Surroundings for Served<'_> {
    fn ask(&self, map: &str, before: u64, wait: Duration) -> Result<Answered, SelfQueryError> {
        ask(self.attach, &self.domain, map, before, wait)
    }

    fn now(&self) -> Instant {
        Instant::now()
    }

    fn sleep(&self, time: Duration) -> bool {
        self.stop.sleep(time)
    }

    fn ping(&self) {
        tell(&[NotifyState::Watchdog]);
    }
}
