//! The three services of a map.

use super::error::ServeError;
use iceoryx2::prelude::{MessagingPattern, Node, Service, ServiceName};
use iceoryx2::service::builder::event::{EventCreateError, EventOpenError, EventOpenOrCreateError};
use iceoryx2::service::builder::publish_subscribe::{
    PublishSubscribeCreateError, PublishSubscribeOpenError, PublishSubscribeOpenOrCreateError,
};
use iceoryx2::service::port_factory::{event, publish_subscribe};
use iceoryx2::service::service_hash::ServiceHash;
use mapd_transport as shared;
use mapd_transport::{AttachGuard, Chunk64, Domain, GenerationInfo, TransportService};
use std::fmt::Debug;
use std::fs;

/// The services of a map, as [`mapd_transport`] names and limits them.
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
                .max_subscribers(shared::MAX_SUBSCRIPTIONS)
                .max_nodes(shared::MAX_NODES)
                .enable_safe_overflow(true)
                .open_or_create()
        };
        let map_service =
            repairing(repair, &name, MessagingPattern::PublishSubscribe, why_not_map, create_map)?;
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
            repairing(repair, &name, MessagingPattern::Event, why_not_event, create)
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

/// Why iceoryx2 neither opens nor creates a service.
enum Refusal {
    /// Somebody was killed while making or removing it.
    HalfMade,
    /// Somebody still has it open who made it with other limits.
    OtherLimits,
    /// Somebody still has it open who uses another version of iceoryx2, or of the payload.
    OtherRelease,
    Else,
}

/// Opens or creates a service. If what is there is half made (iceoryx2 has waited for it), a daemon was killed while it
/// made or removed it. No process uses such a service and, under the exclusive attach lock, none creates one: its
/// description is removed, and it is made anew.
fn repairing<T, E: Debug>(
    repair: Option<&Domain>,
    name: &ServiceName,
    pattern: MessagingPattern,
    why: fn(&E) -> Refusal,
    create: impl Fn() -> Result<T, E>,
) -> Result<T, ServeError> {
    let result = match (create(), repair) {
        (Err(error), Some(domain)) if matches!(why(&error), Refusal::HalfMade) => {
            let hash =
                ServiceHash::new::<<TransportService as Service>::ServiceNameHasher>(name, pattern);
            let file = format!("{}{hash}.service", domain.prefix());
            // If it cannot be removed, the second attempt fails as the first.
            let _ = fs::remove_file(domain.root().join("services").join(file));
            create()
        }
        (other, _) => other,
    };
    result.map_err(|error| {
        let (service, text) = (name.to_string(), format!("{error:?}"));
        match why(&error) {
            Refusal::OtherLimits => ServeError::OtherLimits { service, error: text },
            Refusal::OtherRelease => ServeError::OtherRelease { service, error: text },
            Refusal::HalfMade | Refusal::Else => ServeError::Iceoryx {
                what: "creating a service",
                error: format!("{service}: {text}"),
            },
        }
    })
}

fn why_not_map(error: &PublishSubscribeOpenOrCreateError) -> Refusal {
    use PublishSubscribeOpenError as Open;
    use PublishSubscribeOpenOrCreateError as E;
    match error {
        E::SystemInFlux
        | E::PublishSubscribeOpenError(
            Open::HangsInCreation | Open::IsMarkedForDestruction | Open::ServiceInCorruptedState,
        )
        | E::PublishSubscribeCreateError(
            PublishSubscribeCreateError::HangsInCreation
            | PublishSubscribeCreateError::ServiceInCorruptedState,
        ) => Refusal::HalfMade,
        E::PublishSubscribeOpenError(
            Open::DoesNotSupportRequestedMinBufferSize
            | Open::DoesNotSupportRequestedMinHistorySize
            | Open::DoesNotSupportRequestedMinSubscriberBorrowedSamples
            | Open::DoesNotSupportRequestedAmountOfPublishers
            | Open::DoesNotSupportRequestedAmountOfSubscribers
            | Open::DoesNotSupportRequestedAmountOfNodes
            | Open::IncompatibleOverflowBehavior,
        ) => Refusal::OtherLimits,
        E::PublishSubscribeOpenError(
            Open::VersionMismatch | Open::IncompatibleTypes | Open::IncompatibleMessagingPattern,
        ) => Refusal::OtherRelease,
        _ => Refusal::Else,
    }
}

fn why_not_event(error: &EventOpenOrCreateError) -> Refusal {
    use EventOpenError as Open;
    use EventOpenOrCreateError as E;
    match error {
        E::SystemInFlux
        | E::EventOpenError(
            Open::HangsInCreation | Open::IsMarkedForDestruction | Open::ServiceInCorruptedState,
        )
        | E::EventCreateError(EventCreateError::ServiceInCorruptedState) => Refusal::HalfMade,
        E::EventOpenError(
            Open::DoesNotSupportRequestedAmountOfNotifiers
            | Open::DoesNotSupportRequestedAmountOfListeners
            | Open::DoesNotSupportRequestedMaxEventId
            | Open::DoesNotSupportRequestedAmountOfNodes,
        ) => Refusal::OtherLimits,
        E::EventOpenError(Open::VersionMismatch | Open::IncompatibleMessagingPattern) => {
            Refusal::OtherRelease
        }
        _ => Refusal::Else,
    }
}
