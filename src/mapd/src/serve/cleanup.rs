//! Removing the files of killed processes, and at the end those of the daemon.

use super::nodes;
use super::notice::Notice;
use iceoryx2::prelude::Node;
use mapd_transport::{
    AttachGuard, Domain, GENERATION_SUFFIX, RECORD_SUFFIX, SHARED_MEMORY_FOLDER, TransportService,
    unfinished_segments,
};
use std::fs;
use std::path::Path;

/// Removes unfinished segments. Under the exclusive attach lock no process creates any.
pub(crate) fn sweep(domain: &Domain, _exclusive: &AttachGuard, notify: &dyn Fn(&Notice)) {
    for file in unfinished_segments(domain) {
        match fs::remove_file(&file) {
            Ok(()) => notify(&Notice::Removed { file }),
            Err(error) => {
                notify(&Notice::Failed {
                    what: format!("removing {}", file.display()),
                    error: error.to_string(),
                });
            }
        }
    }
}

/// Sweeps, then has iceoryx2 release what killed processes held: places, queues, borrowed samples. In this order: it
/// would wait for an unfinished segment without end.
pub(crate) fn clean(
    domain: &Domain,
    node: &Node<TransportService>,
    exclusive: &AttachGuard,
    notify: &dyn Fn(&Notice),
) {
    sweep(domain, exclusive, notify);
    nodes::purge(domain, node.config(), exclusive);
    let done = node.try_cleanup_dead_nodes();
    if done.cleanups > 0 {
        notify(&Notice::CleanedUp { nodes: done.cleanups });
    }
    if done.failed_cleanups > 0 {
        notify(&Notice::CleanUpFailed { nodes: done.failed_cleanups });
        nodes::purge(domain, node.config(), exclusive);
    }
}

/// Removes every file of a domain without processes, so that leftovers of killed processes cannot get in the way. Unless
/// `all` is set, keeps the domain's lock files, the generation numbers, and the records, on which observers may wait. Under the
/// exclusive attach lock no process enters the domain.
pub(crate) fn wipe(domain: &Domain, all: bool, _exclusive: &AttachGuard) {
    // What cannot be removed is swept, reused or tried again by the next daemon.
    for entry in entries(Path::new(SHARED_MEMORY_FOLDER)) {
        let ours = entry.file_name().to_str().is_some_and(|name| name.starts_with(domain.prefix()));
        if ours && entry.file_type().is_ok_and(|kind| kind.is_file()) {
            let _ = fs::remove_file(entry.path());
        }
    }
    if all {
        let _ = fs::remove_dir_all(domain.root());
        return;
    }
    for entry in entries(domain.root()) {
        let is_kept = |name: &str| {
            name.starts_with('.')
                || [GENERATION_SUFFIX, RECORD_SUFFIX].iter().any(|s| name.ends_with(s))
        };
        let kept = entry.file_name().to_str().is_some_and(is_kept);
        if !kept {
            let path = entry.path();
            let _ = if path.is_dir() { fs::remove_dir_all(&path) } else { fs::remove_file(&path) };
        }
    }
}

fn entries(folder: &Path) -> impl Iterator<Item = fs::DirEntry> {
    fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok)
}
