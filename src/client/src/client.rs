//! Connecting by name and following generations.

use crate::error::ClientError;
use crate::snapshot::Snapshot;
use mapd_transport::{AttachError, Domain, GenerationInfo, Observer, OverlayState, Pinned, after};
#[cfg(feature = "subscriber")]
use mapd_transport::{AttachTiming, Subscription};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Looks after a deadline, each of which met a publication.
const LATE: u32 = 8;

/// How a client attaches to a map. Both ways read the same memory and offer the same calls.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Attach {
    /// Maps the files that the map's record names and writes nothing: it takes no lock and no slot, any number of observers may attach,
    /// and shared memory may be full. An observer can also attach to the map of a daemon that was killed, until another daemon
    /// replaces it; see [`Client::heartbeat_age`].
    #[default]
    Observer,
    /// Takes part in iceoryx2 as one of at most 64 subscribers of a map. The daemon counts subscribers and cleans up after them. A subscriber
    /// can attach only while a daemon serves the map. Needs the feature `subscriber`.
    #[cfg(feature = "subscriber")]
    Subscriber,
}

/// The source of generations.
enum Source {
    Observer(Observer),
    #[cfg(feature = "subscriber")]
    Subscriber(Box<Subscriber>),
}

/// A subscription, and where it looks for overlays, which are in no sample.
#[cfg(feature = "subscriber")]
struct Subscriber {
    subscription: Subscription,
    beside: Observer,
}

impl Source {
    #[cfg(feature = "subscriber")]
    fn subscriber(subscription: Subscription, domain: &Domain, map: &str) -> Self {
        let beside = Observer::idle(domain, map);
        Self::Subscriber(Box::new(Subscriber { subscription, beside }))
    }

    /// Where overlays are looked for.
    fn observer(&self) -> &Observer {
        match self {
            Self::Observer(observer) => observer,
            #[cfg(feature = "subscriber")]
            Self::Subscriber(subscriber) => &subscriber.beside,
        }
    }

    fn newer_than(&self, than: u64) -> Result<Option<Pinned>, AttachError> {
        match self {
            Self::Observer(observer) => observer.newer_than(than),
            #[cfg(feature = "subscriber")]
            Self::Subscriber(subscriber) => subscriber.subscription.newer_than(than),
        }
    }

    fn wait_newer(&self, than: u64, until: Instant) -> Result<Pinned, AttachError> {
        match self {
            Self::Observer(observer) => observer.wait_newer(than, until),
            #[cfg(feature = "subscriber")]
            Self::Subscriber(subscriber) => subscriber.subscription.wait_newer(than, until),
        }
    }
}

/// A connection to one served map. `Send` and `Sync`; queries run on [`Snapshot`]s and do not use the connection.
pub struct Client {
    name: String,
    domain: Domain,
    source: Source,
    current: Mutex<Snapshot>,
    populate: AtomicBool,
}

impl Client {
    /// Connects to a map as an observer and pins its newest generation. The environment names the domain (see [`Domain::from_env`]).
    /// Daemon and client may start in any order; waits `deadline` at most.
    ///
    /// Errors: what was still missing after `deadline`; the archive cannot be read.
    pub fn connect(map: &str, deadline: Duration) -> Result<Self, ClientError> {
        let domain = Domain::from_env().map_err(AttachError::from)?;
        Self::connect_in(&domain, map, deadline)
    }

    /// As [`Client::connect`], in a given domain.
    pub fn connect_in(domain: &Domain, map: &str, deadline: Duration) -> Result<Self, ClientError> {
        Self::connect_as(Attach::default(), domain, map, deadline)
    }

    /// As [`Client::connect_in`], attached in this way.
    ///
    /// Errors: as [`Client::connect`].
    pub fn connect_as(
        attach: Attach,
        domain: &Domain,
        map: &str,
        deadline: Duration,
    ) -> Result<Self, ClientError> {
        let until = after(deadline);
        let source = match attach {
            Attach::Observer => Source::Observer(Observer::connect(domain, map, until)?),
            #[cfg(feature = "subscriber")]
            Attach::Subscriber => {
                Source::subscriber(Subscription::connect(domain, map, until)?, domain, map)
            }
        };
        Self::with(source, domain, map, until)
    }

    /// Subscribes with a slot that is reserved for daemons if clients use all other slots, so that a daemon can query the map that
    /// it serves.
    ///
    /// Errors: as [`Client::connect_in`].
    #[cfg(feature = "subscriber")]
    #[doc(hidden)]
    pub fn connect_in_reserve(
        domain: &Domain,
        map: &str,
        deadline: Duration,
    ) -> Result<Self, ClientError> {
        let until = after(deadline);
        let subscription = Subscription::connect_in_reserve(domain, map, until)?;
        Self::with(Source::subscriber(subscription, domain, map), domain, map, until)
    }

    fn with(
        source: Source,
        domain: &Domain,
        map: &str,
        until: Instant,
    ) -> Result<Self, ClientError> {
        let mut late = 0;
        let current = loop {
            let pinned = source.wait_newer(0, until)?;
            let snapshot = Snapshot::from_pinned(pinned, map)?;
            if let Some(pair) = lay(source.observer(), &snapshot)? {
                break pair;
            }
            if !looks_again(source.observer(), until, &mut late) {
                return Err(none_came(domain, map, 0).into());
            }
        };
        let (current, populate) = (Mutex::new(current), AtomicBool::new(false));
        Ok(Self { name: map.to_owned(), domain: domain.clone(), source, current, populate })
    }

    /// How this client is attached.
    pub fn attachment(&self) -> Attach {
        match self.source {
            Source::Observer(_) => Attach::Observer,
            #[cfg(feature = "subscriber")]
            Source::Subscriber(_) => Attach::Subscriber,
        }
    }

    /// Time since the daemon's last heartbeat. A daemon that serves the map writes one about once a second. If the age exceeds a few seconds,
    /// the daemon was killed, is stopped or gets no processor time, and the snapshot may be out of date. `None`: the map is no longer served. Reads a
    /// small file in shared memory. The clock is the monotonic one, which stops while the machine sleeps; the age is meaningless if daemon and
    /// client are in different time namespaces.
    pub fn heartbeat_age(&self) -> Option<Duration> {
        mapd_transport::heartbeat_age(&self.domain, &self.name)
    }

    /// Name of the map.
    pub fn map_name(&self) -> &str {
        &self.name
    }

    /// Durations of the phases of attaching, for a subscriber; an observer has no phases. For benchmarks.
    #[cfg(feature = "subscriber")]
    #[doc(hidden)]
    pub fn attach_timing(&self) -> Option<AttachTiming> {
        match &self.source {
            Source::Observer(_) => None,
            Source::Subscriber(subscriber) => Some(subscriber.subscription.timing()),
        }
    }

    /// The newest generation that this client has seen. Does not look for a newer one.
    pub fn snapshot(&self) -> Snapshot {
        self.current.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Looks for a newer generation and for another overlay without waiting. Returns the newest generation with the overlay that belongs to it.
    ///
    /// Errors: the transport failed, or the new archive or overlay cannot be read; the old snapshot stays valid.
    pub fn refresh(&self) -> Result<Snapshot, ClientError> {
        let mut tried = None;
        loop {
            // One that could not be opened is no better the next time, and told each time.
            let newest = match self.source.newer_than(self.snapshot().generation())? {
                Some(pinned) => self.open(pinned)?,
                None => self.snapshot(),
            };
            if let Some(kept) = self.keep(&newest)? {
                return Ok(kept);
            }
            // The record is about another generation: a newer one that others may have seen already, or, where this one was sent at this moment, the one
            // before it still.
            if tried.replace(newest.generation()) == Some(newest.generation()) {
                return Ok(self.snapshot());
            }
        }
    }

    /// Waits `deadline` at most for a generation or overlay newer than those of the newest snapshot. Returns whether one has come;
    /// [`Client::snapshot`] then returns it.
    ///
    /// Errors: as [`Client::refresh`].
    pub fn wait_change(&self, deadline: Duration) -> Result<bool, ClientError> {
        let until = after(deadline);
        let pair = |snapshot: &Snapshot| (snapshot.generation(), snapshot.overlay_revision());
        let before = pair(&self.snapshot());
        loop {
            if pair(&self.refresh()?) != before {
                return Ok(true);
            }
            if Instant::now() >= until {
                return Ok(false);
            }
            self.source.observer().sleep(until);
        }
    }

    /// Waits `deadline` at most for a generation newer than the newest that this client has seen.
    ///
    /// Errors: none came in time; the transport failed; the new archive cannot be read.
    pub fn wait_next(&self, deadline: Duration) -> Result<Snapshot, ClientError> {
        self.wait_newer(self.snapshot().generation(), deadline)
    }

    /// Waits for a generation newer than `than`; one that is already there counts.
    pub(crate) fn wait_newer(
        &self,
        than: u64,
        deadline: Duration,
    ) -> Result<Snapshot, ClientError> {
        let (until, mut late) = (after(deadline), 0);
        loop {
            let pinned = self.source.wait_newer(than, until)?;
            if let Some(kept) = self.keep(&self.open(pinned)?)? {
                return Ok(kept);
            }
            if !looks_again(self.source.observer(), until, &mut late) {
                return Err(none_came(&self.domain, &self.name, than).into());
            }
        }
    }

    /// Sets whether all pages of a generation are mapped before it is returned, starting with the current one, so that no query
    /// waits for the kernel: see [`Snapshot::populate`]. The call that fetches a generation takes milliseconds longer per
    /// 100 MB, and this process needs 2 KB of page tables for each MB. Off by default.
    pub fn set_populate(&self, populate: bool) {
        self.populate.store(populate, Ordering::Relaxed);
        if populate {
            self.snapshot().populate();
        }
    }

    fn open(&self, pinned: Pinned) -> Result<Snapshot, ClientError> {
        let snapshot = Snapshot::from_pinned(pinned, &self.name)?;
        if self.populate.load(Ordering::Relaxed) {
            snapshot.populate();
        }
        Ok(snapshot)
    }

    /// Process id of the daemon that serves the map, in the daemon's process namespace; 0 if a daemon serves it but its id is not known; `None` if no daemon
    /// serves it or this cannot be determined.
    pub fn served_by(&self) -> Option<u32> {
        mapd_transport::served_by(&self.domain, &self.name)
    }

    /// Waits at most `deadline` for the generation of this number and returns it: processes that must change over together
    /// agree on the number of a staged generation, see [`Client::pending`], and each requires it.
    ///
    /// Errors: [`crate::AttachError::Superseded`] if a newer one is served already; it did not come in time; the transport
    /// failed; the archive cannot be read. The old snapshot stays valid.
    pub fn require(&self, generation: u64, deadline: Duration) -> Result<Snapshot, ClientError> {
        let held = self.snapshot();
        if held.generation() == generation {
            return Ok(held);
        }
        let pinned = self.source.wait_newer(generation.saturating_sub(1), after(deadline))?;
        let newest = pinned.info().generation;
        if newest > generation {
            let map = self.name.clone();
            return Err(AttachError::Superseded { map, wanted: generation, newest }.into());
        }
        let wanted = self.open(pinned)?;
        let until = after(deadline);
        loop {
            let kept = self.keep(&wanted)?;
            match kept {
                Some(kept) if kept.generation() == generation => return Ok(kept),
                None if Instant::now() < until => self.source.observer().sleep(until),
                kept => {
                    let newest = kept.map_or(generation, |kept| kept.generation());
                    let map = self.name.clone();
                    return Err(AttachError::Superseded { map, wanted: generation, newest }.into());
                }
            }
        }
    }

    /// The generation that is staged: verified, in shared memory, and served once `mapd activate` is called; `None` if there
    /// is none.
    pub fn pending(&self) -> Option<GenerationInfo> {
        mapd_transport::pending(&self.domain, &self.name)
    }

    /// Keeps the newer of two generations, with the overlay that the record names for it. `None`, without a change, while the record names
    /// another generation. Threads may race here.
    fn keep(&self, new: &Snapshot) -> Result<Option<Snapshot>, ClientError> {
        let mut current = self.current.lock().unwrap_or_else(PoisonError::into_inner);
        let is_newer = new.generation() > current.generation();
        let observer = self.source.observer();
        if !is_newer && observer.is_unchanged() {
            return Ok(Some(current.clone()));
        }
        let pair = lay(observer, if is_newer { new } else { &current })?;
        if let Some(pair) = &pair {
            *current = pair.clone();
        }
        Ok(pair)
    }
}

/// Whether to look again, after the record has named another generation than was had: that one is being sent at this moment, or its daemon was killed then, or a newer
/// one has followed. Sleeps until the record changes; after the deadline, there are only a few more looks, for the newest.
fn looks_again(observer: &Observer, until: Instant, late: &mut u32) -> bool {
    if Instant::now() < until {
        observer.sleep(until);
        return true;
    }
    *late += 1;
    *late <= LATE
}

/// No generation could be had together with its overlay, whether a daemon runs or not.
fn none_came(domain: &Domain, map: &str, newer_than: u64) -> AttachError {
    let daemon_alive = mapd_transport::served_by(domain, map).is_some();
    AttachError::NoGeneration { map: map.to_owned(), newer_than, daemon_alive }
}

/// A generation with the overlay that the record names for it; `None` if the record names another generation.
fn lay(observer: &Observer, snapshot: &Snapshot) -> Result<Option<Snapshot>, ClientError> {
    let laid = observer.laid_over(snapshot.generation(), snapshot.overlay_revision())?;
    Ok(match laid {
        OverlayState::Known => Some(snapshot.clone()),
        OverlayState::Nothing => Some(snapshot.bare()),
        OverlayState::New(pinned) => Some(snapshot.under(pinned)?),
        OverlayState::Other => None,
    })
}
