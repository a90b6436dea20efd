//! Publishing maps and serving those who arrive.

use super::error::{ServeError, refused};
use super::generation::Lease;
use super::stop::StopSignal;
use super::{loan, room, sweep};
use iceoryx2::port::listener::Listener;
use iceoryx2::port::notifier::Notifier;
use iceoryx2::port::publisher::Publisher;
use iceoryx2::port::update_connections::UpdateConnections;
use iceoryx2::prelude::*;
use iceoryx2::service::port_factory::event::PortFactory as EventService;
use iceoryx2::service::port_factory::publish_subscribe::PortFactory as ArchiveService;
use mapd_client::Domain;
use mapd_client::transport::protocol::{
    Channel, Chunk64, Ipc, MAX_LISTENERS, MAX_NODES, MAX_PUBLISHERS, MAX_SUBSCRIBERS, service_name,
};
use mapd_client::transport::{AttachLock, GenerationInfo, LockMode};
use std::collections::BTreeSet;
use std::error::Error as StdError;
use std::fs;
use std::os::unix::fs::{DirBuilderExt, PermissionsExt};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Wait for the attach lock at start. A client that is stopped in the middle of attaching holds it longer; the daemon
/// then goes on without sweeping.
const LOCK_WAIT: Duration = Duration::from_secs(2);
/// Time between two clean-ups after the dead.
const TICK: Duration = Duration::from_secs(1);
/// Mode of the root folder: one user.
const ROOT_MODE: u32 = 0o700;
/// Mode of a filled data segment: nobody writes it any more.
const READ_ONLY: u32 = 0o444;

/// What is published with an archive besides its bytes.
#[derive(Clone, Copy, Debug, Default)]
pub struct PublishMeta {
    /// Layout id, padded with zeros.
    pub layout_id: [u8; 32],
    /// BLAKE3 of the archive's body.
    pub content_hash: [u8; 32],
    /// BLAKE3 of the input.
    pub input_hash: [u8; 32],
}

/// A map that is being served. Fields are dropped in order: the right to the name last.
struct Served {
    name: String,
    publisher: Option<Publisher<Ipc, [Chunk64], GenerationInfo>>,
    wake: Listener<Ipc>,
    changed: Notifier<Ipc>,
    archive: ArchiveService<Ipc, [Chunk64], GenerationInfo>,
    wake_service: EventService<Ipc>,
    _changed_service: EventService<Ipc>,
    lease: Lease,
}

/// Publishes maps and serves clients as they arrive.
pub struct Server {
    maps: Vec<Served>,
    node: Node<Ipc>,
    domain: Domain,
}

impl Server {
    /// Makes the domain ready: root folder, clean-up after processes that were killed.
    ///
    /// Errors: the root folder cannot be made; iceoryx2 refuses.
    pub fn start(domain: &Domain) -> Result<Self, ServeError> {
        set_log_level(LogLevel::Fatal);
        let root = domain.root();
        let failed = |error| ServeError::File { path: root.to_owned(), error };
        fs::DirBuilder::new().recursive(true).mode(ROOT_MODE).create(root).map_err(failed)?;
        let lock = AttachLock::take(domain, LockMode::Exclusive, Instant::now() + LOCK_WAIT)
            .map_err(failed)?;
        if lock.is_some() {
            sweep::sweep(domain);
        }
        let config = domain.config().ok_or_else(|| ServeError::Iceoryx2 {
            action: "use the root folder",
            reason: root.display().to_string(),
        })?;
        let node = NodeBuilder::new()
            .config(&config)
            .signal_handling_mode(SignalHandlingMode::Disabled)
            .create::<Ipc>()
            .map_err(|e| refused("create a node")(&e))?;
        if lock.is_some() {
            node.try_cleanup_dead_nodes();
        }
        Ok(Self { maps: Vec::new(), node, domain: domain.clone() })
    }

    /// Publishes a map of exactly `length` bytes under a name. `fill` writes and proves them in place.
    ///
    /// Errors: the name is served elsewhere; no room; `fill` fails. Nothing of this generation is left behind then.
    pub fn publish(
        &mut self,
        map: &str,
        length: usize,
        fill: impl FnOnce(&mut [u8]) -> Result<PublishMeta, Box<dyn StdError + Send + Sync>>,
    ) -> Result<u64, ServeError> {
        room::check(&self.domain, map, length)?;
        // Shared with clients: a sweeping daemon of the same domain must not take what is half-made here.
        let _lock = AttachLock::take(&self.domain, LockMode::Shared, Instant::now() + LOCK_WAIT);
        if !self.maps.iter().any(|served| served.name == map) {
            let served = open(&self.node, &self.domain, map)?;
            self.maps.push(served);
        }
        let Some(at) = self.maps.iter().position(|served| served.name == map) else { return Ok(0) };
        let served = &mut self.maps[at];
        match send(served, &self.domain, length, fill) {
            Ok(generation) => Ok(generation),
            Err(error) => {
                if served.publisher.is_none() {
                    self.maps.remove(at);
                }
                Err(error)
            }
        }
    }

    /// Serves until stopped.
    ///
    /// Errors: iceoryx2 fails.
    pub fn run(&mut self, stop: &StopSignal) -> Result<(), ServeError> {
        let waitset = WaitSetBuilder::new()
            .signal_handling_mode(SignalHandlingMode::Disabled)
            .create::<Ipc>()
            .map_err(|e| refused("create a wait set")(&e))?;
        let mut guards = Vec::new();
        for served in &self.maps {
            guards.push(
                waitset
                    .attach_notification(&served.wake)
                    .map_err(|e| refused("wait for clients")(&e))?,
            );
        }
        let tick = waitset.attach_interval(TICK).map_err(|e| refused("wait for time")(&e))?;
        if let Some(served) = self.maps.first() {
            let notifier = served.wake_service.notifier_builder().create();
            let notifier = notifier.map_err(|e| refused("create a notifier")(&e))?;
            stop.on_stop(Some(Box::new(move || {
                // A daemon that cannot be woken looks at its next tick.
                let _ = notifier.notify();
            })));
        }
        let served = waitset.wait_and_process(|event| {
            if stop.is_stopped() {
                return CallbackProgression::Stop;
            }
            for (guard, served) in guards.iter().zip(&self.maps) {
                if event.has_event_from(guard) {
                    let _ = served.wake.try_wait(|_| {});
                    connect(served);
                }
            }
            if event.has_event_from(&tick) {
                self.clean_up();
            }
            CallbackProgression::Continue
        });
        stop.on_stop(None);
        served.map(|_| ()).map_err(|e| refused("wait")(&e))
    }

    /// Sweeps and cleans up, if nobody is attaching; else the next tick will.
    fn clean_up(&self) {
        if let Ok(Some(_lock)) = AttachLock::take(&self.domain, LockMode::Exclusive, Instant::now())
        {
            sweep::sweep(&self.domain);
            self.node.try_cleanup_dead_nodes();
        }
    }
}

/// Connects clients that have arrived; they are sent the newest generation. One that died meanwhile is no reason to stop.
fn connect(served: &Served) {
    if let Some(publisher) = &served.publisher {
        let _ = publisher.update_connections();
    }
}

/// Takes the name and opens or makes its services.
fn open(node: &Node<Ipc>, domain: &Domain, map: &str) -> Result<Served, ServeError> {
    let names = [Channel::Archive, Channel::Wake, Channel::Changed]
        .map(|channel| service_name(map, channel));
    let [archive, wake, changed] = names;
    let lease = Lease::take(domain, map)?;
    let archive = node
        .service_builder(&archive?)
        .publish_subscribe::<[Chunk64]>()
        .user_header::<GenerationInfo>()
        .history_size(1)
        .subscriber_max_buffer_size(1)
        .subscriber_max_borrowed_samples(1)
        .max_publishers(MAX_PUBLISHERS)
        .max_subscribers(MAX_SUBSCRIBERS)
        .max_nodes(MAX_NODES)
        .enable_safe_overflow(true)
        .open_or_create()
        .map_err(|e| refused("open the map's service")(&e))?;
    let event = |name: &ServiceName| {
        node.service_builder(name)
            .event()
            .max_notifiers(MAX_SUBSCRIBERS)
            .max_listeners(MAX_LISTENERS)
            .max_nodes(MAX_NODES)
            .open_or_create()
            .map_err(|e| refused("open a service of events")(&e))
    };
    let (wake_service, changed_service) = (event(&wake?)?, event(&changed?)?);
    let wake =
        wake_service.listener_builder().create().map_err(|e| refused("listen for clients")(&e))?;
    let changed = changed_service
        .notifier_builder()
        .create()
        .map_err(|e| refused("create a notifier")(&e))?;
    Ok(Served {
        name: map.to_owned(),
        publisher: None,
        wake,
        changed,
        archive,
        wake_service,
        _changed_service: changed_service,
        lease,
    })
}

/// Publishes one generation: a publisher of its exact size takes the place of the one before.
fn send(
    served: &mut Served,
    domain: &Domain,
    length: usize,
    fill: impl FnOnce(&mut [u8]) -> Result<PublishMeta, Box<dyn StdError + Send + Sync>>,
) -> Result<u64, ServeError> {
    let chunks = length.div_ceil(size_of::<Chunk64>());
    let before: BTreeSet<_> = sweep::segments(domain).into_iter().map(|(path, _)| path).collect();
    let publisher = served
        .archive
        .publisher_builder()
        .initial_max_slice_len(chunks)
        .allocation_strategy(AllocationStrategy::Static)
        .max_loaned_samples(1)
        .override_sample_preallocation(|_| 1)
        .create()
        .map_err(|e| refused("create a publisher")(&e))?;
    let mut sample =
        publisher.loan_slice_uninit(chunks).map_err(|e| refused("loan the map's memory")(&e))?;
    let failed = |error| ServeError::Fill { name: served.name.clone(), error };
    let bytes = loan::bytes(sample.payload_mut()).map_err(|error| failed(error.into()))?;
    let exact = bytes.get_mut(..length).ok_or_else(|| failed("the loan is too short".into()))?;
    let meta = fill(exact).map_err(failed)?;
    let generation = served.lease.next()?;
    *sample.user_header_mut() = GenerationInfo {
        generation,
        length: length as u64,
        published_unix_ns: SystemTime::now()
            .duration_since(UNIX_EPOCH)
            .unwrap_or_default()
            .as_nanos() as u64,
        daemon_pid: u64::from(std::process::id()),
        layout_id: meta.layout_id,
        content_hash: meta.content_hash,
        input_hash: meta.input_hash,
    };
    // Filled: from here on nobody opens the archive for writing.
    for (path, metadata) in sweep::segments(domain) {
        if metadata.len() >= length as u64 && !before.contains(&path) {
            let read_only = fs::Permissions::from_mode(READ_ONLY);
            fs::set_permissions(&path, read_only)
                .map_err(|error| ServeError::File { path, error })?;
        }
    }
    loan::filled(sample).send().map_err(|e| refused("send the map")(&e))?;
    served.publisher = Some(publisher);
    // Clients without a listener look by themselves.
    let _ = served.changed.notify();
    Ok(generation)
}
