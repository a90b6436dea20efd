//! Node files that iceoryx2 0.10 cannot clean up.
//!
//! When a process is killed between making the tag of a port and registering the port, or while it makes or removes its
//! node, cleaning up fails after the node's details have been removed; and for a node without details iceoryx2 looks into
//! its *global* configuration, that is into another domain, and finds nothing to do, for ever. By then the node holds
//! nothing any more but its own files, which are removed here.

use iceoryx2::node::NodeView;
use iceoryx2::prelude::{CallbackProgression, Config, Node, NodeState};
use mapd_transport::{AttachGuard, Domain, TransportService};
use std::collections::BTreeSet;
use std::fs;

/// Removes the files of dead nodes that have no details, and of what is no node. Under the exclusive attach lock no process
/// creates a node; a process that is removing one finds that its last files are gone already.
pub(crate) fn purge(domain: &Domain, config: &Config, _exclusive: &AttachGuard) {
    let mut in_use = BTreeSet::new();
    let mut hopeless = BTreeSet::new();
    let listed = Node::<TransportService>::list(config, |state| {
        match &state {
            NodeState::Dead(node) if node.details().is_none() => hopeless.insert(node.id().value()),
            other => in_use.insert(other.node_id().value()),
        };
        CallbackProgression::Continue
    });
    if listed.is_err() {
        return;
    }
    let Ok(entries) = fs::read_dir(domain.root().join("nodes")) else { return };
    for entry in entries.filter_map(Result::ok) {
        let name = entry.file_name();
        let Some(id) = name.to_str().and_then(|name| node_of(domain, name)) else { continue };
        let path = entry.path();
        if hopeless.contains(&id) || !in_use.contains(&id) {
            // What cannot be removed now is tried again a second later.
            let _ = if path.is_dir() { fs::remove_dir_all(&path) } else { fs::remove_file(&path) };
        }
    }
}

/// The node that an entry of the nodes folder belongs to: a folder `{id}`, or a file `{prefix}{id}.…`.
fn node_of(domain: &Domain, name: &str) -> Option<u128> {
    let name = name.strip_prefix(domain.prefix()).unwrap_or(name);
    name.split('.').next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_node_files() {
        let domain = Domain::new("mapd_").expect("a good prefix");
        let node = |name| node_of(&domain, name);
        assert_eq!(
            node("1029966421004884919806872003281"),
            Some(1_029_966_421_004_884_919_806_872_003_281)
        );
        assert_eq!(node("mapd_42.node_monitor_context"), Some(42));
        assert_eq!(node("other_42.node_monitor"), None);
        assert_eq!(node("mapd_x.node_monitor"), None);
    }
}
