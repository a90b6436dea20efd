//! How many readers take part.

use super::config::{TransportService, iceoryx2_config, silence_iceoryx2};
use crate::attach_lock::AttachLock;
use crate::domain::Domain;
use crate::limits::{DAEMON_NODE, service_name};
use iceoryx2::node::NodeView;
use iceoryx2::prelude::{MessagingPattern, NodeState, Service, ServiceName};
use std::time::{Duration, Instant};

/// How long a daemon may hold the attach lock before the number of subscriptions is given up.
const LOCK_PATIENCE: Duration = Duration::from_millis(500);

/// Subscriptions to a map, of this and of all other processes: living nodes that have its service open, without the daemon's, which also subscribes to look at what it serves; each
/// subscription has one of its own. `None` if they cannot be counted.
pub fn count_subscriptions(domain: &Domain, map: &str) -> Option<usize> {
    silence_iceoryx2();
    let lock = AttachLock::open(domain).ok()?;
    let _guard = lock.shared(Instant::now() + LOCK_PATIENCE).ok()??;
    let name = ServiceName::new(&service_name(map)).ok()?;
    let config = iceoryx2_config(domain).ok()?;
    let details =
        TransportService::details(&name, &config, MessagingPattern::PublishSubscribe).ok()??;
    let living = |state: &NodeState<TransportService>| match state {
        NodeState::Alive(node) => {
            node.details().as_ref().is_some_and(|details| details.name().as_str() != DAEMON_NODE)
        }
        _ => false,
    };
    Some(details.dynamic_details?.nodes.iter().filter(|state| living(state)).count())
}
