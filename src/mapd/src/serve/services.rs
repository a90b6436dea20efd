//! The three services of a map.

use super::error::ServeError;
use iceoryx2::prelude::{MessagingPattern, Node, Service, ServiceName};
use iceoryx2::service::builder::event::{EventCreateError, EventOpenError, EventOpenOrCreateError};
use iceoryx2::service::builder::publish_subscribe::{
    PublishSubscribeCreateError, PublishSubscribeOpenError, PublishSubscribeOpenOrCreateError,
};
use iceoryx2::service::port_factory::{event, publish_subscribe};
use iceoryx2::service::service_hash::ServiceHash;
use mapd_client::transport as shared;
use mapd_client::transport::{AttachGuard, Chunk64, Domain, GenerationInfo, TransportService};
use std::fmt::Debug;
use std::fs;

/// The services of a map, as [`mapd_client::transport`] names and limits them.
pub(crate) struct MapServices {
    /// Carries the generations.
    pub(crate) map: publish_subscribe::PortFactory<TransportService, [Chunk64], GenerationInfo>,
    /// Rung by newcomers.
    pub(crate) wake: event::PortFactory<TransportService>,
    /// Rung for those who wait for a generation.
    pub(crate) changed: event::PortFactory<TransportService>,
}

impl MapServices {
    /// Opens what living clients hold, creates the rest. Repairs only under the exclusive attach lock.
    ///
    /// Errors: iceoryx2 refuses.
    pub(crate) fn open_or_create(
        domain: &Domain,
        node: &Node<TransportService>,
        map: &str,
        exclusive: Option<&AttachGuard>,
    ) -> Result<Self, ServeError> {
        let repair = exclusive.is_some().then_some(domain);
        let name = parse(&shared::service_name(map))?;
        let create_map = || {
            node.service_builder(&name)
                .publish_subscribe::<[Chunk64]>()
                .user_header::<GenerationInfo>()
                .history_size(shared::HISTORY)
                .subscriber_max_buffer_size(shared::SUBSCRIBER_BUFFER)
                .subscriber_max_borrowed_samples(shared::SUBSCRIBER_BORROWED)
                .max_publishers(shared::MAX_PUBLISHERS)
                .max_subscribers(shared::MAX_SUBSCRIBERS)
                .max_nodes(shared::MAX_NODES)
                .enable_safe_overflow(true)
                .open_or_create()
        };
        let map_service = repairing(
            repair,
            &name,
            MessagingPattern::PublishSubscribe,
            map_is_half_made,
            create_map,
        )?;
        let event = |name: &str, notifiers, listeners| {
            let name = parse(name)?;
            let create = || {
                node.service_builder(&name)
                    .event()
                    .max_notifiers(notifiers)
                    .max_listeners(listeners)
                    .max_nodes(shared::MAX_NODES)
                    .open_or_create()
            };
            repairing(repair, &name, MessagingPattern::Event, event_is_half_made, create)
        };
        let wake = event(&shared::wake_name(map), shared::MAX_NODES, shared::MAX_EVENT_DAEMONS)?;
        let changed =
            event(&shared::changed_name(map), shared::MAX_EVENT_DAEMONS, shared::MAX_NODES)?;
        Ok(Self { map: map_service, wake, changed })
    }
}

fn parse(name: &str) -> Result<ServiceName, ServeError> {
    ServiceName::new(name).map_err(ServeError::iceoryx("naming a service"))
}

/// Opens or creates a service. If what is there is half made (iceoryx2 has waited for it), a daemon was killed while it
/// made or removed it. Nobody uses such a service and, under the exclusive attach lock, nobody is making one: its
/// description is removed, and it is made anew.
fn repairing<T, E: Debug>(
    repair: Option<&Domain>,
    name: &ServiceName,
    pattern: MessagingPattern,
    is_half_made: fn(&E) -> bool,
    create: impl Fn() -> Result<T, E>,
) -> Result<T, ServeError> {
    let result = match (create(), repair) {
        (Err(error), Some(domain)) if is_half_made(&error) => {
            let hash =
                ServiceHash::new::<<TransportService as Service>::ServiceNameHasher>(name, pattern);
            let file = format!("{}{hash}.service", domain.prefix());
            // If it cannot be removed, the second attempt fails as the first.
            let _ = fs::remove_file(domain.root().join("services").join(file));
            create()
        }
        (other, _) => other,
    };
    result.map_err(|error| ServeError::Iceoryx {
        what: "creating a service",
        error: format!("{name}: {error:?}"),
    })
}

fn map_is_half_made(error: &PublishSubscribeOpenOrCreateError) -> bool {
    use PublishSubscribeOpenOrCreateError as E;
    matches!(
        error,
        E::SystemInFlux
            | E::PublishSubscribeOpenError(
                PublishSubscribeOpenError::HangsInCreation
                    | PublishSubscribeOpenError::IsMarkedForDestruction
                    | PublishSubscribeOpenError::ServiceInCorruptedState
            )
            | E::PublishSubscribeCreateError(
                PublishSubscribeCreateError::HangsInCreation
                    | PublishSubscribeCreateError::ServiceInCorruptedState
            )
    )
}

fn event_is_half_made(error: &EventOpenOrCreateError) -> bool {
    use EventOpenOrCreateError as E;
    matches!(
        error,
        E::SystemInFlux
            | E::EventOpenError(
                EventOpenError::HangsInCreation
                    | EventOpenError::IsMarkedForDestruction
                    | EventOpenError::ServiceInCorruptedState
            )
            | E::EventCreateError(EventCreateError::ServiceInCorruptedState)
    )
}
