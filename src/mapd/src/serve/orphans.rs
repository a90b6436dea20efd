//! State of services that are no more.
//!
//! iceoryx2 removes a service in two steps: its description, then its shared state. A daemon killed in between leaves the
//! state, which nobody can open any more; as long as a client lives in the domain, each such kill would leave another.

use super::notice::Notice;
use iceoryx2::prelude::{CallbackProgression, Config, Service};
use mapd_client::transport::{AttachGuard, Domain, SHARED_MEMORY_FOLDER, TransportService};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Ending of the file with a service's shared state. iceoryx2 names it prefix, hash of a type name, `_`, service, ending.
const STATE_ENDING: &str = ".dynamic";

/// Ending of a service's description.
const DESCRIPTION_ENDING: &str = ".service";

/// Removes the state of services that have no description. Processes that have such a service open keep what they have
/// mapped. Under the exclusive attach lock nobody is making a service. If a description cannot be read, nothing is removed.
pub(crate) fn remove(
    domain: &Domain,
    config: &Config,
    _exclusive: &AttachGuard,
    notify: &dyn Fn(&Notice),
) {
    let mut known = BTreeSet::new();
    let listed = TransportService::list(config, |service| {
        known.insert(service.static_details.unique_service_id().value());
        CallbackProgression::Continue
    });
    let descriptions = names(&domain.root().join("services"))
        .filter(|name| name.ends_with(DESCRIPTION_ENDING))
        .count();
    if listed.is_err() || descriptions != known.len() {
        return;
    }
    for name in names(Path::new(SHARED_MEMORY_FOLDER)) {
        if service_of(domain, &name).is_some_and(|service| !known.contains(&service)) {
            let file = Path::new(SHARED_MEMORY_FOLDER).join(name);
            // What cannot be removed now is tried again by the next daemon.
            if fs::remove_file(&file).is_ok() {
                notify(&Notice::Removed { file });
            }
        }
    }
}

/// The service whose state a file holds.
fn service_of(domain: &Domain, name: &str) -> Option<u128> {
    let name = name.strip_prefix(domain.prefix())?.strip_suffix(STATE_ENDING)?;
    name.split_once('_')?.1.parse().ok()
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
}
