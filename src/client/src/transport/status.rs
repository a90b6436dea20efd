//! What is served in a domain.

use super::attach_lock::AttachLock;
use super::claim::{SUFFIX, served_by};
use super::config::{TransportService, iceoryx2_config, silence_iceoryx2};
use super::domain::Domain;
use super::error::AttachError;
use super::limits::{DAEMON_NODE, service_name};
use super::observer::published;
use super::payload::GenerationInfo;
use super::user::check_owner;
use iceoryx2::node::NodeView;
use iceoryx2::prelude::{MessagingPattern, NodeState, Service, ServiceName};
use std::io;
use std::time::{Duration, Instant};

/// How long a daemon may hold the attach lock before the number of subscriptions is given up.
const LOCK_PATIENCE: Duration = Duration::from_millis(500);

/// One map of a domain.
#[derive(Clone, Debug)]
pub struct MapStatus {
    /// Name.
    pub name: String,
    /// Whether a daemon serves it now. If not, only processes that hold a generation can read it.
    pub alive: bool,
    /// What was published last.
    pub info: Option<GenerationInfo>,
    /// Subscriptions, of this and of all other processes; 0 as well if they cannot be counted.
    pub subscribers: usize,
}

/// Maps of a domain that are served, or were when their daemon was killed, by name. Attaches to nothing.
///
/// Errors: the domain belongs to another user, or cannot be read. A domain where no daemon has been is empty, not an error.
pub fn list_maps(domain: &Domain) -> Result<Vec<MapStatus>, AttachError> {
    silence_iceoryx2();
    match check_owner(domain) {
        Err(AttachError::Io { error, .. }) if error.kind() == io::ErrorKind::NotFound => {
            return Ok(Vec::new());
        }
        other => other?,
    }
    let names = claimed_names(domain).map_err(|error| AttachError::io(domain.root(), error))?;
    let status = |name: String| {
        let alive = served_by(domain, &name).is_some();
        let info = published(domain, &name);
        let subscribers = info.and_then(|_| count_subscriptions(domain, &name)).unwrap_or(0);
        MapStatus { name, alive, info, subscribers }
    };
    Ok(names.into_iter().map(status).collect())
}

/// Names of the maps that are served now, sorted.
pub(crate) fn alive_maps(domain: &Domain) -> Vec<String> {
    let names = claimed_names(domain).unwrap_or_default();
    names.into_iter().filter(|name| served_by(domain, name).is_some()).collect()
}

fn claimed_names(domain: &Domain) -> io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(domain.root())? {
        if let Some(map) = entry?.file_name().to_str().and_then(|name| name.strip_suffix(SUFFIX)) {
            names.push(map.to_owned());
        }
    }
    names.sort();
    Ok(names)
}

/// Living nodes that have the map's service open, without the daemon's: each subscription has one of its own.
fn count_subscriptions(domain: &Domain, map: &str) -> Option<usize> {
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
