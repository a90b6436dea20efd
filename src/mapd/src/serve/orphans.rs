//! State of services and listeners that no longer exist.
//!
//! iceoryx2 removes a service in two steps: its description, then its shared state. A daemon killed in between leaves the
//! state, which can no longer be opened. Listeners and queues are created before they are registered with their service, and removed
//! afterwards. As long as a client lives in the domain, each such kill would leave more files.

use super::notice::Notice;
use iceoryx2::prelude::{CallbackProgression, Node, PortFactory as _, Service, ServiceName};
use iceoryx2::service::static_config::messaging_pattern::MessagingPattern;
use mapd_transport::{
    AttachGuard, Chunk64, Domain, GenerationInfo, SHARED_MEMORY_FOLDER, TransportService, is_ours,
};
use std::collections::BTreeSet;
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::Path;

/// Ending of the file with a service's shared state. iceoryx2 names it prefix, hash of a type name, `_`, service, ending.
const STATE_ENDING: &str = ".dynamic";

/// Ending of the file with a listener's shared state, which is named as that of a service.
const LISTENER_STATE_ENDING: &str = ".event_mgmt";

/// Ending of a listener's socket in the root folder: prefix, listener, ending.
const SOCKET_ENDING: &str = ".event";

/// Ending of a queue from a publisher to a subscriber: prefix, hash of a type name, `_`, publisher, `_`, subscriber, ending.
const QUEUE_ENDING: &str = ".connection";

/// Ending of a service's description.
const DESCRIPTION_ENDING: &str = ".service";

/// Removes the state of services that have no description, and what listeners and publishers left that no service knows.
/// Processes that have such a file open keep what they have mapped. Under the exclusive attach lock no process creates a
/// service or a port; a process that is removing one finds that its last files are gone already. Files whose owner is unknown are
/// kept.
pub(crate) fn remove(
    domain: &Domain,
    node: &Node<TransportService>,
    _exclusive: &AttachGuard,
    notify: &dyn Fn(&Notice),
) {
    let (mut known, mut events, mut maps) = (BTreeSet::new(), Vec::new(), Vec::new());
    let listed = TransportService::list(node.config(), |service| {
        known.insert(service.static_details.unique_service_id().value());
        let name = *service.static_details.name();
        match service.static_details.messaging_pattern() {
            MessagingPattern::Event(_) => events.push(name),
            MessagingPattern::PublishSubscribe(_) => maps.push(name),
            _ => {}
        }
        CallbackProgression::Continue
    });
    let descriptions = names(&domain.root().join("services"))
        .filter(|name| name.ends_with(DESCRIPTION_ENDING))
        .count();
    if listed.is_err() || descriptions != known.len() {
        return;
    }
    remove_where(Path::new(SHARED_MEMORY_FOLDER), notify, |name| {
        service_of(domain, name).is_some_and(|service| !known.contains(&service))
    });
    if let Some(listeners) = listeners(node, &events) {
        let orphan = |name: &str| {
            listener_of(domain, name).is_some_and(|listener| !listeners.contains(&listener))
        };
        remove_where(Path::new(SHARED_MEMORY_FOLDER), notify, orphan);
        remove_where(domain.root(), notify, orphan);
    }
    if let Some(publishers) = publishers(node, &maps) {
        remove_where(Path::new(SHARED_MEMORY_FOLDER), notify, |name| {
            publisher_of(domain, name).is_some_and(|publisher| !publishers.contains(&publisher))
        });
    }
}

/// The publishers of these services; `None` if one cannot be opened.
fn publishers(node: &Node<TransportService>, maps: &[ServiceName]) -> Option<BTreeSet<u128>> {
    let mut all = BTreeSet::new();
    for name in maps {
        let builder = node.service_builder(name).publish_subscribe::<[Chunk64]>();
        let service = builder.user_header::<GenerationInfo>().open().ok()?;
        service.dynamic_config().list_publishers(|publisher| {
            all.insert(publisher.publisher_id.value());
            CallbackProgression::Continue
        });
    }
    Some(all)
}

/// The listeners of these services; `None` if one cannot be opened.
fn listeners(node: &Node<TransportService>, events: &[ServiceName]) -> Option<BTreeSet<u128>> {
    let mut all = BTreeSet::new();
    for name in events {
        let service = node.service_builder(name).event().open().ok()?;
        service.dynamic_config().list_listeners(|listener| {
            all.insert(listener.listener_id.value());
            CallbackProgression::Continue
        });
    }
    Some(all)
}

fn remove_where(folder: &Path, notify: &dyn Fn(&Notice), orphan: impl Fn(&str) -> bool) {
    for name in names(folder).filter(|name| orphan(name)) {
        let file = folder.join(name);
        let is_own = fs::symlink_metadata(&file).is_ok_and(|file| is_ours(file.uid()));
        // What cannot be removed now is tried again by the next daemon.
        if is_own && fs::remove_file(&file).is_ok() {
            notify(&Notice::Removed { file });
        }
    }
}

/// The service whose state a file holds.
fn service_of(domain: &Domain, name: &str) -> Option<u128> {
    let name = name.strip_prefix(domain.prefix())?.strip_suffix(STATE_ENDING)?;
    name.split_once('_')?.1.parse().ok()
}

/// The listener whose socket or state a file is.
fn listener_of(domain: &Domain, name: &str) -> Option<u128> {
    let name = name.strip_prefix(domain.prefix())?;
    match name.strip_suffix(LISTENER_STATE_ENDING) {
        Some(state) => state.split_once('_')?.1.parse().ok(),
        None => name.strip_suffix(SOCKET_ENDING)?.parse().ok(),
    }
}

/// The publisher whose queue to a subscriber a file is.
fn publisher_of(domain: &Domain, name: &str) -> Option<u128> {
    let name = name.strip_prefix(domain.prefix())?.strip_suffix(QUEUE_ENDING)?;
    name.split_once('_')?.1.split_once('_')?.0.parse().ok()
}

fn names(folder: &Path) -> impl Iterator<Item = String> {
    let entries = fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
    entries.filter_map(|entry| entry.file_name().into_string().ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_state() {
        let domain = Domain::new("mapd_").expect("a good prefix");
        let service = |name| service_of(&domain, name);
        assert_eq!(
            service("mapd_112437a1_158456682472491759299.dynamic"),
            Some(158_456_682_472_491_759_299)
        );
        assert_eq!(service("mapd_112437a1_42_43.connection"), None);
        assert_eq!(service("other_112437a1_42.dynamic"), None);
        assert_eq!(service("mapd_9204dd18_node.0_10_0.global_mgmt"), None);
    }

    #[test]
    fn names_of_listeners() {
        let domain = Domain::new("mapd_").expect("a good prefix");
        let listener = |name| listener_of(&domain, name);
        assert_eq!(
            listener("mapd_237684920473650085668847640542.event"),
            Some(237_684_920_473_650_085_668_847_640_542)
        );
        assert_eq!(listener("mapd_33c1ac61_23768.event_mgmt"), Some(23_768));
        assert_eq!(listener("mapd_33c1ac61_42_43.connection"), None);
        assert_eq!(listener("other_42.event"), None);
    }

    #[test]
    fn names_of_queues() {
        let domain = Domain::new("mapd_").expect("a good prefix");
        let publisher = |name| publisher_of(&domain, name);
        assert_eq!(publisher("mapd_b9fc73e5_42_43.connection"), Some(42));
        assert_eq!(publisher("mapd_33c1ac61_42.event_mgmt"), None);
        assert_eq!(publisher("other_b9fc73e5_42_43.connection"), None);
    }
}
