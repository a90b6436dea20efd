//! Following one map.

use super::attach::{AttachTiming, Attaching, Ports, open_listener, open_ports};
use super::config::{TransportService, silence_iceoryx2};
use super::connections::KnownPublishers;
use super::sample::PinnedSample;
use super::shortage::{RECEIVE_DESCRIPTORS, check_descriptors, check_room};
use crate::claim::{served_by, who_serves};
use crate::domain::Domain;
use crate::error::AttachError;
use crate::limits::{MAX_PINNED, check_map_name};
use crate::pinned::{Memory, Pinned, Watch};
use iceoryx2::port::listener::Listener;
use iceoryx2::service::port_factory::PortFactory as _;
use std::fmt;
use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::{Duration, Instant};

/// First pause between two attempts to attach or to receive the first generation; doubles up to [`LONGEST_PAUSE`].
const FIRST_PAUSE: Duration = Duration::from_micros(50);

/// Longest pause between two such attempts.
const LONGEST_PAUSE: Duration = Duration::from_millis(10);

/// How often a client that waits for its first generation rings again, should the daemon have been unable to answer.
const RING_AGAIN: Duration = Duration::from_millis(100);

/// Longest sleep on the event of a new generation: a waiting subscriber checks this often even if the event was lost.
const COARSE_POLL: Duration = Duration::from_millis(100);

/// Longest wait for the attach lock while the subscription itself is locked, so that [`Subscription::latest`] of another
/// thread stays quick.
const LOCK_WAIT: Duration = Duration::from_millis(5);

/// Sleep of a thread that cannot listen to the event: another thread does, or the daemon has ended.
const SECOND_WAITER_POLL: Duration = Duration::from_millis(5);

/// A subscription to one map, holding its newest generation received so far. `Send` and `Sync`; its methods take a lock
/// for microseconds, queries on a [`Pinned`] take none.
///
/// It survives the daemon: generations that are held stay readable, and those of a restarted daemon arrive here.
pub struct Subscription {
    map: String,
    domain: Domain,
    /// Made by the first call that waits. Dropped before the state, with which the domain is left.
    changed: Mutex<Option<Listener<TransportService>>>,
    state: Mutex<State>,
}

struct State {
    current: Pinned,
    handed_out: u64,
    inbox: Inbox,
}

/// The ports, and what came through them that may still be held.
struct Inbox {
    ports: Ports,
    domain: Domain,
    attaching: Attaching,
    publishers: KnownPublishers,
    held: Vec<Watch>,
}

impl Subscription {
    /// Attaches to a map and receives its newest generation. Daemon and client may start in any order: tries again until
    /// the deadline while there is no daemon, no such map, or no generation.
    ///
    /// Errors: what was missing at the deadline; at once, what no waiting helps against: wrong names, another user's
    /// daemon, another release's daemon.
    pub fn connect(domain: &Domain, map: &str, deadline: Instant) -> Result<Self, AttachError> {
        Self::connect_as(domain, map, Attaching::Client, deadline)
    }

    /// As [`Subscription::connect`], for a daemon that looks at what it serves: also where clients have taken all places, and counted as none of them.
    ///
    /// Errors: as [`Subscription::connect`].
    #[doc(hidden)]
    pub fn connect_in_reserve(
        domain: &Domain,
        map: &str,
        deadline: Instant,
    ) -> Result<Self, AttachError> {
        Self::connect_as(domain, map, Attaching::Daemon, deadline)
    }

    fn connect_as(
        domain: &Domain,
        map: &str,
        attaching: Attaching,
        deadline: Instant,
    ) -> Result<Self, AttachError> {
        check_map_name(map)?;
        silence_iceoryx2();
        let mut pause = FIRST_PAUSE;
        let mut inbox = loop {
            match open_ports(domain, map, attaching, deadline).map_err(AttachError::or_shortage) {
                Ok(ports) => {
                    let (domain, publishers) = (domain.clone(), KnownPublishers::default());
                    break Inbox { ports, domain, attaching, publishers, held: Vec::new() };
                }
                Err(error) if error.may_pass() && Instant::now() < deadline => {
                    sleep(&mut pause, deadline)
                }
                Err(error) => return Err(error),
            }
        };
        let start = Instant::now();
        let current = inbox.first(domain, map, deadline)?;
        inbox.ports.timing.receive += start.elapsed();
        let state = Mutex::new(State { current, handed_out: 0, inbox });
        Ok(Self { map: map.to_owned(), domain: domain.clone(), state, changed: Mutex::new(None) })
    }

    /// The newest generation received so far. Looks for no other.
    pub fn current(&self) -> Pinned {
        let mut state = self.state();
        state.handed_out = state.current.info().generation;
        state.current.clone()
    }

    /// A generation newer than any handed out before, if one has come; takes the newest. Never waits: while a daemon
    /// cleans up (some milliseconds, seldom), and while shared memory is full, the answer is `None`.
    ///
    /// Errors: too many generations are held; shared memory failed. What is held stays valid.
    pub fn latest(&self) -> Result<Option<Pinned>, AttachError> {
        let mut state = self.state();
        match state.receive(&self.map, Instant::now()) {
            Err(AttachError::NoRoom { .. }) => return Ok(None),
            other => other?,
        }
        if state.current.info().generation <= state.handed_out {
            return Ok(None);
        }
        state.handed_out = state.current.info().generation;
        Ok(Some(state.current.clone()))
    }

    /// As [`Subscription::latest`], but newer than `than` instead of any handed out before.
    ///
    /// Errors: as [`Subscription::latest`].
    pub fn newer_than(&self, than: u64) -> Result<Option<Pinned>, AttachError> {
        self.latest()?;
        let state = self.state();
        Ok(Some(&state.current).filter(|current| current.info().generation > than).cloned())
    }

    /// Waits for a generation newer than `than`; one that has been received already counts. Keeps the deadline even if
    /// the daemon has died, and gets the generation of a restarted one. Several threads may wait.
    ///
    /// Errors: none came in time; too many generations are held; shared memory failed.
    pub fn wait_newer(&self, than: u64, deadline: Instant) -> Result<Pinned, AttachError> {
        loop {
            let mut no_room = None;
            {
                let mut state = self.state();
                match state.receive(&self.map, deadline.min(Instant::now() + LOCK_WAIT)) {
                    Err(error @ AttachError::NoRoom { .. }) => no_room = Some(error),
                    other => other?,
                }
                if state.current.info().generation > than {
                    state.handed_out = state.handed_out.max(state.current.info().generation);
                    return Ok(state.current.clone());
                }
            }
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Err(no_room.unwrap_or_else(|| AttachError::NoGeneration {
                    map: self.map.clone(),
                    newer_than: than,
                    daemon_alive: served_by(&self.domain, &self.map).is_some(),
                }));
            }
            self.sleep(left.min(COARSE_POLL))?;
        }
    }

    /// Subscriptions to this map now, of all processes, this one among them. One that was killed counts until the daemon
    /// has cleaned up.
    pub fn subscribers(&self) -> usize {
        self.state().inbox.ports.service.dynamic_config().number_of_subscribers()
    }

    /// Where the time of attaching went.
    pub fn timing(&self) -> AttachTiming {
        self.state().inbox.ports.timing
    }

    fn state(&self) -> MutexGuard<'_, State> {
        // A panic cannot leave the state half changed: it is changed by single assignments.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Sleeps until the daemon announces a generation, at most `longest`.
    fn sleep(&self, longest: Duration) -> Result<(), AttachError> {
        let mut changed = match self.changed.try_lock() {
            Ok(changed) => changed,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) => {
                std::thread::sleep(longest.min(SECOND_WAITER_POLL));
                return Ok(());
            }
        };
        if changed.is_none() {
            let state = self.state();
            let ports = &state.inbox.ports;
            if let Some(guard) = ports.lock.shared(Instant::now() + LOCK_WAIT)? {
                match open_listener(&ports.node, &self.map, &guard) {
                    Ok(listener) => {
                        *changed = Some(listener);
                        // What was published before the listener was there has to be looked for again.
                        return Ok(());
                    }
                    // The service ends with a daemon that is stopped, and comes back with the next.
                    Err(error) if error.may_pass() => {}
                    Err(error) => return Err(error),
                }
            }
        }
        match changed.as_ref().map(|listener| listener.timed_wait(|_| {}, longest)) {
            Some(Ok(_)) => {}
            // Nothing to sleep on, or interrupted by a signal: the caller looks again, and sleeps again.
            None | Some(Err(_)) => std::thread::sleep(longest.min(SECOND_WAITER_POLL)),
        }
        Ok(())
    }
}

impl State {
    fn receive(&mut self, map: &str, deadline: Instant) -> Result<(), AttachError> {
        if let Some(pinned) = self.inbox.receive(map, deadline)?
            && pinned.info().generation > self.current.info().generation
        {
            self.current = pinned;
        }
        Ok(())
    }
}

impl Inbox {
    /// Waits for the first generation, ringing again now and then.
    fn first(
        &mut self,
        domain: &Domain,
        map: &str,
        deadline: Instant,
    ) -> Result<Pinned, AttachError> {
        let mut pause = FIRST_PAUSE;
        let mut rung = Instant::now();
        loop {
            match self.receive(map, deadline) {
                Ok(Some(pinned)) => {
                    self.ports.wake = None;
                    return Ok(pinned);
                }
                Err(error) if !error.may_pass() => return Err(error),
                Err(error @ (AttachError::NoRoom { .. } | AttachError::NoDescriptors { .. }))
                    if Instant::now() >= deadline =>
                {
                    return Err(error);
                }
                // A publisher that was killed cannot be connected to until a daemon has cleaned up.
                Ok(None) | Err(_) => {}
            }
            if Instant::now() >= deadline {
                // iceoryx2 passes over a publisher that it can open no files of.
                check_descriptors(RECEIVE_DESCRIPTORS)?;
                let served = who_serves(domain, map);
                return Err(
                    match served.map_err(|error| AttachError::io(domain.root(), error))? {
                        Some(_) => AttachError::NoGeneration {
                            map: map.to_owned(),
                            newer_than: 0,
                            daemon_alive: true,
                        },
                        None => AttachError::NoDaemon {
                            map: map.to_owned(),
                            root: domain.root().to_owned(),
                        },
                    },
                );
            }
            sleep(&mut pause, deadline);
            if rung.elapsed() >= RING_AGAIN {
                rung = Instant::now();
                self.ring(deadline)?;
            }
        }
    }

    /// Takes part under another id. What is held stays.
    fn attach_anew(&mut self, map: &str, deadline: Instant) -> Result<(), AttachError> {
        self.ports = open_ports(&self.domain, map, self.attaching, deadline)?;
        self.ports.wake = None;
        self.publishers = KnownPublishers::default();
        Ok(())
    }

    fn ring(&self, deadline: Instant) -> Result<(), AttachError> {
        let guard = self.ports.lock.shared(deadline)?;
        if let (Some(wake), Some(_)) = (&self.ports.wake, guard) {
            wake.notify().map_err(AttachError::iceoryx)?;
        }
        Ok(())
    }

    /// Takes everything that has come and returns the newest of it. Under the attach lock, for receiving from a new
    /// publisher creates a segment; waits for the lock at most until the deadline, and finds nothing if it stays taken, or if a stranger has the name of a queue: then it
    /// attaches anew.
    ///
    /// Errors: shared memory is full; too many generations are held; a stranger has the name of a queue, and there is no room to attach anew; iceoryx2 refuses.
    fn receive(&mut self, map: &str, deadline: Instant) -> Result<Option<Pinned>, AttachError> {
        let Some(guard) = self.ports.lock.shared(deadline)? else { return Ok(None) };
        check_room()?;
        let Ports { service, subscriber, .. } = &self.ports;
        if let Err(stranger) = self.publishers.check(&self.domain, service, subscriber) {
            drop(guard);
            // Its queues have names that nobody can foresee; the daemon answers as it answers newcomers.
            return self.attach_anew(map, deadline).map_or(Err(stranger), |()| Ok(None));
        }
        self.held.retain(Watch::is_held);
        let mut newest: Option<Pinned> = None;
        loop {
            if self.held.len() >= MAX_PINNED {
                // What has just come is the last that can be held, and would not come again.
                let full = || AttachError::TooManyPinned { map: map.to_owned() };
                return newest.ok_or_else(full).map(Some);
            }
            // The last round, which finds nothing, also unmaps generations that are no longer held.
            let failed = |error| AttachError::iceoryx(error).or_shortage();
            let Some(sample) = self.ports.subscriber.receive().map_err(failed)? else {
                return Ok(newest);
            };
            let (info, sample) = PinnedSample::new(sample, map, &self.ports.presence)?;
            let pinned = Pinned::new(info, Memory::Sample(sample));
            self.held.push(pinned.watch());
            if newest
                .as_ref()
                .is_none_or(|newest| newest.info().generation < pinned.info().generation)
            {
                newest = Some(pinned);
            }
        }
    }
}

/// Sleeps and doubles the pause.
fn sleep(pause: &mut Duration, deadline: Instant) {
    std::thread::sleep((*pause).min(deadline.saturating_duration_since(Instant::now())));
    *pause = (*pause * 2).min(LONGEST_PAUSE);
}

impl fmt::Debug for Subscription {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Subscription")
            .field("map", &self.map)
            .field("domain", &self.domain)
            .finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn threads_may_share_them() {
        fn shared<T: Send + Sync>() {}
        shared::<Subscription>();
        shared::<Pinned>();
    }
}
