//! One attempt to attach.

use super::config::{TransportService, iceoryx2_config};
use super::node_counter::check_node_counter;
use super::shortage::check_room;
use crate::attach_lock::{AttachGuard, AttachLock};
use crate::claim::who_serves;
use crate::domain::Domain;
use crate::error::AttachError;
use crate::limits::{
    DAEMON_NODE, MAX_SUBSCRIBERS, MAX_SUBSCRIPTIONS, TRANSPORT_REVISION, changed_name,
    service_name, wake_name,
};
use crate::observer::{published, revision_of};
use crate::payload::{Chunk64, GenerationInfo};
use crate::presence::Presence;
use crate::status::alive_maps;
use crate::unfinished::look;
use crate::user::check_own;
use iceoryx2::port::listener::Listener;
use iceoryx2::port::notifier::Notifier;
use iceoryx2::port::subscriber::{Subscriber, SubscriberCreateError};
use iceoryx2::prelude::{Node, NodeBuilder, NodeName, ServiceName, SignalHandlingMode};
use iceoryx2::service::builder::event::EventOpenError;
use iceoryx2::service::builder::publish_subscribe::PublishSubscribeOpenError;
use iceoryx2::service::port_factory::PortFactory as _;
use iceoryx2::service::port_factory::publish_subscribe::PortFactory;
use std::io;
use std::sync::Arc;
use std::time::{Duration, Instant};

pub(crate) type MapService = PortFactory<TransportService, [Chunk64], GenerationInfo>;
pub(crate) type MapSubscriber = Subscriber<TransportService, [Chunk64], GenerationInfo>;

/// Segments that only their creator and one publisher meet, and that no attaching client opens.
const OF_OTHER_CLIENTS: [&str; 2] = [".connection", ".event_mgmt"];

/// Where the time of an attach went.
#[derive(Clone, Copy, Debug, Default)]
pub struct AttachTiming {
    /// Finding the daemon and taking the attach lock.
    pub lock: Duration,
    /// Creating the node.
    pub node: Duration,
    /// Opening the service.
    pub service: Duration,
    /// Creating the subscriber.
    pub subscriber: Duration,
    /// Telling the daemon and receiving the first generation.
    pub receive: Duration,
}

/// The ports of a subscription. Fields are dropped in the order they are written.
pub(crate) struct Ports {
    pub(crate) subscriber: MapSubscriber,
    pub(crate) service: MapService,
    pub(crate) wake: Option<Notifier<TransportService>>,
    pub(crate) node: Node<TransportService>,
    pub(crate) lock: AttachLock,
    pub(crate) presence: Arc<Presence>,
    pub(crate) timing: AttachTiming,
}

/// Who attaches.
#[derive(Clone, Copy)]
pub(crate) enum Attaching {
    /// A client.
    Client,
    /// A daemon that looks at what it serves: also where clients have taken all places, and it is counted as none of them.
    Daemon,
}

/// Creates node and ports, once. Everything happens under the attach lock, which is free again at the end.
///
/// Errors: whatever is missing; [`AttachError::may_pass`] tells whether to try again.
pub(crate) fn open_ports(
    domain: &Domain,
    map: &str,
    attaching: Attaching,
    deadline: Instant,
) -> Result<Ports, AttachError> {
    let mut clock = Instant::now();
    let mut lap = || {
        let now = Instant::now();
        now.duration_since(std::mem::replace(&mut clock, now))
    };
    let mut timing = AttachTiming::default();
    let (lock, _guard) = enter(domain, map, deadline)?;
    let presence =
        Presence::enter(domain).map_err(|error| AttachError::io(domain.root(), error))?;
    check_node_counter(domain, map)?;
    timing.lock = lap();
    let config = iceoryx2_config(domain)?;
    let (most, name) = match attaching {
        Attaching::Client => (MAX_SUBSCRIBERS, ""),
        Attaching::Daemon => (MAX_SUBSCRIPTIONS, DAEMON_NODE),
    };
    let node = NodeBuilder::new()
        .name(&NodeName::new(name).map_err(AttachError::iceoryx)?)
        .config(&config)
        .signal_handling_mode(SignalHandlingMode::Disabled)
        .create::<TransportService>()
        .map_err(AttachError::iceoryx)?;
    timing.node = lap();
    let service = node
        .service_builder(&service_name_of(&service_name(map))?)
        .publish_subscribe::<[Chunk64]>()
        .user_header::<GenerationInfo>()
        .open()
        .map_err(|error| service_error(domain, map, error))?;
    // iceoryx2 has places for more, which are kept; a few clients that come at one moment may take one of them.
    if service.dynamic_config().number_of_subscribers() >= most {
        return Err(AttachError::TooManySubscribers { map: map.to_owned() });
    }
    timing.service = lap();
    let subscriber = service.subscriber_builder().create().map_err(|error| match error {
        SubscriberCreateError::ExceedsMaxSupportedSubscribers => {
            AttachError::TooManySubscribers { map: map.to_owned() }
        }
        other => AttachError::iceoryx(other),
    })?;
    timing.subscriber = lap();
    let wake = node
        .service_builder(&service_name_of(&wake_name(map))?)
        .event()
        .open()
        .map_err(|e| event_error(map, e))?;
    let wake = wake.notifier_builder().create().map_err(AttachError::iceoryx)?;
    wake.notify().map_err(AttachError::iceoryx)?;
    timing.receive = lap();
    Ok(Ports {
        subscriber,
        service,
        wake: Some(wake),
        node,
        lock,
        presence: Arc::new(presence),
        timing,
    })
}

/// Opens the port that hears of new generations. Under the attach lock.
pub(crate) fn open_listener(
    node: &Node<TransportService>,
    map: &str,
    _guard: &AttachGuard,
) -> Result<Listener<TransportService>, AttachError> {
    check_room()?;
    let changed = node
        .service_builder(&service_name_of(&changed_name(map))?)
        .event()
        .open()
        .map_err(|e| event_error(map, e))?;
    changed.listener_builder().create().map_err(AttachError::iceoryx)
}

/// Finds the daemon and takes the attach lock, with nothing unfinished in the way.
fn enter(
    domain: &Domain,
    map: &str,
    deadline: Instant,
) -> Result<(AttachLock, AttachGuard), AttachError> {
    let missing = || AttachError::NoDaemon { map: map.to_owned(), root: domain.root().to_owned() };
    match check_own(domain) {
        Err(AttachError::Io { source, .. }) if source.kind() == io::ErrorKind::NotFound => {
            return Err(missing());
        }
        other => other?,
    }
    let served = who_serves(domain, map).map_err(|error| AttachError::io(domain.root(), error))?;
    if served.is_none() {
        let available = alive_maps(domain);
        return Err(if available.is_empty() {
            missing()
        } else {
            AttachError::NoSuchMap { map: map.to_owned(), available }
        });
    }
    let lock = AttachLock::open(domain).map_err(|error| AttachError::io(domain.root(), error))?;
    let busy = || AttachError::Busy { lock: lock.path().to_owned() };
    let guard = lock.shared(deadline)?.ok_or_else(busy)?;
    if !lock.is_current() {
        return Err(missing());
    }
    let in_the_way = |name: &str| !OF_OTHER_CLIENTS.iter().any(|suffix| name.ends_with(suffix));
    match look(domain, in_the_way).unfinished.into_iter().next() {
        Some(file) => Err(AttachError::Stuck { file }),
        None => {
            check_room()?;
            Ok((lock, guard))
        }
    }
}

fn service_name_of(name: &str) -> Result<ServiceName, AttachError> {
    ServiceName::new(name).map_err(AttachError::iceoryx)
}

fn service_error(domain: &Domain, map: &str, error: PublishSubscribeOpenError) -> AttachError {
    let map = map.to_owned();
    match error {
        PublishSubscribeOpenError::DoesNotExist => match revision_of(domain, &map) {
            Some(revision) if revision != TRANSPORT_REVISION => {
                AttachError::WrongTransport { map, found: revision.to_string() }
            }
            _ if published(domain, &map).is_some() => AttachError::NoSubscribers { map },
            // Claimed, but not published yet.
            _ => AttachError::NoGeneration { map, newer_than: 0, daemon_alive: true },
        },
        PublishSubscribeOpenError::ExceedsMaxNumberOfNodes => {
            AttachError::TooManySubscribers { map }
        }
        PublishSubscribeOpenError::IncompatibleTypes
        | PublishSubscribeOpenError::IncompatibleMessagingPattern
        | PublishSubscribeOpenError::VersionMismatch => {
            AttachError::WrongTransport { map, found: format!("{error:?}") }
        }
        other => AttachError::iceoryx(other),
    }
}

fn event_error(map: &str, error: EventOpenError) -> AttachError {
    let map = map.to_owned();
    match error {
        EventOpenError::ExceedsMaxNumberOfNodes => AttachError::TooManySubscribers { map },
        EventOpenError::VersionMismatch => {
            AttachError::WrongTransport { map, found: format!("{error:?}") }
        }
        other => AttachError::iceoryx(other),
    }
}
