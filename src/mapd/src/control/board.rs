//! Where the daemon writes down what it does, so that requests read it without waiting for the daemon.

use super::status::{CacheStatus, DaemonStatus, MapState};
use crate::clock::unix_ns;
use mapd_client::{Attach, Domain};
use mapd_transport::count_subscriptions;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// How long subscriptions are counted: of a domain whose lock a stopped process holds, or with very many maps, the rest is left out.
const COUNTING: Duration = Duration::from_millis(300);

/// The daemon's own account of itself, shared by its threads. A lock is held for microseconds only.
#[derive(Debug)]
pub struct Board {
    started: Instant,
    domain: Domain,
    status: Mutex<DaemonStatus>,
}

impl Board {
    /// Of a daemon that starts now.
    pub fn new(domain: &Domain, cache: Option<CacheStatus>) -> Self {
        let status = DaemonStatus {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            pid: std::process::id(),
            prefix: domain.prefix().to_owned(),
            started_unix_ns: unix_ns(),
            uptime_seconds: 0.0,
            cache,
            without_subscribers: None,
            maps: Vec::new(),
        };
        Self { started: Instant::now(), domain: domain.clone(), status: Mutex::new(status) }
    }

    /// What is so now.
    pub fn status(&self) -> DaemonStatus {
        let mut status = self.lock().clone();
        status.uptime_seconds = self.started.elapsed().as_secs_f64();
        status
    }

    /// What is so now, with how many subscribe: that is counted anew, which may wait for the attach lock.
    pub fn status_with_subscribers(&self) -> DaemonStatus {
        let mut status = self.status();
        let begun = Instant::now();
        for map in &mut status.maps {
            if begun.elapsed() > COUNTING || status.without_subscribers.is_some() {
                break;
            }
            map.subscribers = count_subscriptions(&self.domain, &map.name);
        }
        status
    }

    /// Changes what is said about a map; it is added where it was not.
    pub fn map(&self, name: &str, change: impl FnOnce(&mut MapState)) {
        let mut status = self.lock();
        let place = match status.maps.binary_search_by(|map| map.name.as_str().cmp(name)) {
            Ok(place) => place,
            Err(place) => {
                status
                    .maps
                    .insert(place, MapState { name: name.to_owned(), ..MapState::default() });
                place
            }
        };
        if let Some(map) = status.maps.get_mut(place) {
            change(map);
            let bytes = |generation: &Option<_>| {
                generation.as_ref().map_or(0, |g: &super::GenerationStatus| g.bytes)
            };
            map.memory_bytes = bytes(&map.served) + bytes(&map.staged);
        }
    }

    /// Says why nobody can subscribe.
    pub fn without_subscribers(&self, reason: String) {
        self.lock().without_subscribers = Some(reason);
    }

    /// How the daemon looks at what it serves: as its most demanding clients do.
    pub(crate) fn attach(&self) -> Attach {
        match self.lock().without_subscribers {
            Some(_) => Attach::Observer,
            None => Attach::Subscriber,
        }
    }

    /// Changes what is said about the cache.
    pub fn cache(&self, cache: CacheStatus) {
        self.lock().cache = Some(cache);
    }

    fn lock(&self) -> MutexGuard<'_, DaemonStatus> {
        self.status.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::GenerationStatus;

    #[test]
    fn maps_are_sorted_and_their_memory_is_summed() {
        let board = Board::new(&Domain::new("board_").expect("a prefix"), None);
        let of = |bytes| Some(GenerationStatus { bytes, ..GenerationStatus::default() });
        board.map("b", |map| map.served = of(3));
        board.map("a", |map| map.staged = of(1));
        board.map("b", |map| map.staged = of(4));
        let status = board.status();
        let maps: Vec<_> = status.maps.iter().map(|m| (m.name.as_str(), m.memory_bytes)).collect();
        assert_eq!(maps, [("a", 1), ("b", 7)]);
    }
}
