//! Attaching to a map and following its generations.

use super::domain::Domain;
use super::error::AttachError;
use super::locks::{AttachLock, LockMode};
use super::pinned::Pinned;
use super::protocol::{Channel, Chunk64, GenerationInfo, Ipc, MAX_SUBSCRIBERS, service_name};
use iceoryx2::port::listener::Listener;
use iceoryx2::port::subscriber::{Subscriber, SubscriberCreateError};
use iceoryx2::prelude::*;
use iceoryx2::service::builder::event::EventOpenError;
use iceoryx2::service::builder::publish_subscribe::PublishSubscribeOpenError;
use std::os::unix::fs::MetadataExt;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Pause between two tries while daemon or map are not there yet.
const RETRY: Duration = Duration::from_millis(5);
/// Longest wait for the attach lock within one try.
const LOCK_WAIT: Duration = Duration::from_millis(100);
/// Pause between two looks for the first sample, which comes some hundred microseconds after waking the daemon.
const FIRST_LOOK: Duration = Duration::from_micros(50);
/// After this time without a sample, waiting goes over to events.
const FIRST_WAIT: Duration = Duration::from_millis(20);
/// Longest sleep on events before looking again: covers a daemon that died before it could notify.
const EVENT_WAIT: Duration = Duration::from_millis(50);

/// One subscription to a map. May be shared by threads; attaching and receiving take a lock, reading does not.
pub struct Subscription {
    domain: Domain,
    map: String,
    ports: Mutex<Ports>,
}

/// iceoryx2's ports. Fields are dropped in order: the node last.
struct Ports {
    listener: Option<Listener<Ipc>>,
    subscriber: Subscriber<Ipc, [Chunk64], GenerationInfo>,
    newest: u64,
    node: Node<Ipc>,
}

impl Subscription {
    /// Attaches to a map, waiting for daemon and map until the deadline.
    ///
    /// Errors: what was missing when the deadline passed; refusals that waiting cannot mend come at once.
    pub fn connect(domain: &Domain, map: &str, deadline: Instant) -> Result<Self, AttachError> {
        service_name(map, Channel::Archive)?;
        loop {
            match attach(domain, map) {
                Ok(ports) => {
                    return Ok(Self {
                        domain: domain.clone(),
                        map: map.to_owned(),
                        ports: Mutex::new(ports),
                    });
                }
                Err(error) if is_final(&error) || Instant::now() + RETRY >= deadline => {
                    return Err(error);
                }
                Err(_) => std::thread::sleep(RETRY),
            }
        }
    }

    fn ports(&self) -> MutexGuard<'_, Ports> {
        self.ports.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A generation newer than any handed out before, if there is one. Does not wait.
    ///
    /// Errors: iceoryx2 fails.
    pub fn latest(&self) -> Result<Option<Pinned>, AttachError> {
        self.receive(&mut self.ports())
    }

    /// Waits for a generation newer than `than`.
    ///
    /// Errors: none came before the deadline, whether the daemon lives or not; iceoryx2 fails.
    pub fn wait_newer(&self, than: u64, deadline: Instant) -> Result<Pinned, AttachError> {
        let start = Instant::now();
        loop {
            let mut ports = self.ports();
            if let Some(pinned) =
                self.receive(&mut ports)?.filter(|pinned| pinned.info().generation > than)
            {
                return Ok(pinned);
            }
            let now = Instant::now();
            if now >= deadline {
                return Err(AttachError::NoGeneration { name: self.map.clone(), than });
            }
            if now - start < FIRST_WAIT {
                drop(ports);
                std::thread::sleep(FIRST_LOOK);
                continue;
            }
            if ports.listener.is_none() {
                ports.listener = self.listen(&ports.node)?;
                // What was published before we listened is received in the next round.
                continue;
            }
            if let Some(listener) = &ports.listener {
                let pause = EVENT_WAIT.min(deadline - now);
                listener
                    .timed_wait(|_| {}, pause)
                    .map_err(|error| refused("wait for an event", &error))?;
            }
        }
    }

    /// Takes what has arrived and keeps the newest. A publisher that appears makes iceoryx2 create a connection here, so
    /// that this needs the attach lock; where a daemon is sweeping, the next look finds what is there.
    fn receive(&self, ports: &mut Ports) -> Result<Option<Pinned>, AttachError> {
        let lock = AttachLock::take(&self.domain, LockMode::Shared, Instant::now());
        if !matches!(lock, Ok(Some(_))) {
            return Ok(None);
        }
        let mut best: Option<Pinned> = None;
        loop {
            let received = ports
                .subscriber
                .receive()
                .map_err(|error| refused("receive a generation", &error))?;
            let Some(sample) = received else { break };
            let generation = sample.user_header().generation;
            if generation > ports.newest {
                best = Some(Pinned::new(sample, &self.map)?);
                ports.newest = generation;
            }
        }
        Ok(best)
    }

    fn listen(&self, node: &Node<Ipc>) -> Result<Option<Listener<Ipc>>, AttachError> {
        let _lock = AttachLock::take(&self.domain, LockMode::Shared, Instant::now() + LOCK_WAIT);
        let service = match node
            .service_builder(&service_name(&self.map, Channel::Changed)?)
            .event()
            .open()
        {
            Ok(service) => service,
            // The daemon is being restarted; the next round tries again.
            Err(EventOpenError::DoesNotExist) => {
                std::thread::sleep(RETRY);
                return Ok(None);
            }
            Err(error) => return Err(refused("open the service of events", &error)),
        };
        service
            .listener_builder()
            .create()
            .map(Some)
            .map_err(|error| refused("listen for events", &error))
    }
}

fn refused(action: &'static str, error: &dyn std::fmt::Debug) -> AttachError {
    AttachError::Iceoryx2 { action, reason: format!("{error:?}") }
}

/// Whether waiting cannot help.
fn is_final(error: &AttachError) -> bool {
    !matches!(
        error,
        AttachError::NoDaemon { .. } | AttachError::NoSuchMap { .. } | AttachError::Locked { .. }
    )
}

/// One try.
fn attach(domain: &Domain, map: &str) -> Result<Ports, AttachError> {
    set_log_level(LogLevel::Fatal);
    let root = domain.root();
    let no_daemon = || AttachError::NoDaemon { root: root.to_owned() };
    let owner = std::fs::metadata(root).map_err(|_| no_daemon())?.uid();
    let user = rustix::process::geteuid().as_raw();
    if user != 0 && owner != user {
        return Err(AttachError::OtherUser { root: root.to_owned(), owner, user });
    }
    let _lock = AttachLock::take(domain, LockMode::Shared, Instant::now() + LOCK_WAIT)
        .map_err(|_| no_daemon())?
        .ok_or_else(|| AttachError::Locked { lock: AttachLock::path(domain) })?;
    let config = domain.config().ok_or_else(no_daemon)?;
    let node = NodeBuilder::new()
        .config(&config)
        .signal_handling_mode(SignalHandlingMode::Disabled)
        .create::<Ipc>()
        .map_err(|error| refused("create a node", &error))?;
    let no_such_map = || AttachError::NoSuchMap { name: map.to_owned() };
    let service = node
        .service_builder(&service_name(map, Channel::Archive)?)
        .publish_subscribe::<[Chunk64]>()
        .user_header::<GenerationInfo>()
        .open()
        .map_err(|error| match error {
            PublishSubscribeOpenError::DoesNotExist
            | PublishSubscribeOpenError::IsMarkedForDestruction
            | PublishSubscribeOpenError::HangsInCreation => no_such_map(),
            error => refused("open the map's service", &error),
        })?;
    let subscriber = service.subscriber_builder().create().map_err(|error| match error {
        SubscriberCreateError::ExceedsMaxSupportedSubscribers => {
            AttachError::TooManyClients { name: map.to_owned(), limit: MAX_SUBSCRIBERS }
        }
        error => refused("create a subscriber", &error),
    })?;
    let wake = node.service_builder(&service_name(map, Channel::Wake)?).event().open().map_err(
        |error| match error {
            EventOpenError::DoesNotExist
            | EventOpenError::IsMarkedForDestruction
            | EventOpenError::HangsInCreation => no_such_map(),
            error => refused("open the service of events", &error),
        },
    )?;
    let notifier =
        wake.notifier_builder().create().map_err(|error| refused("create a notifier", &error))?;
    notifier.notify().map_err(|error| refused("wake the daemon", &error))?;
    Ok(Ports { listener: None, subscriber, newest: 0, node })
}
