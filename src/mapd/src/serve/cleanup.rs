//! Removing the files of killed processes, and at the end those of the daemon.

use super::generations::ONLY_HERE_SUFFIX;
use super::nodes;
use super::notice::Notice;
use super::strangers::Strangers;
use iceoryx2::prelude::Node;
use mapd_transport::{
    AttachGuard, Domain, GENERATION_SUFFIX, RECORD_SUFFIX, SHARED_MEMORY_FOLDER, TransportService,
    domain_files, is_ours, node_counter,
};
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::Path;

/// Removes unfinished segments. Under the exclusive attach lock no process creates any. Tells of files of other users.
pub(crate) fn sweep(
    domain: &Domain,
    _exclusive: &AttachGuard,
    notify: &dyn Fn(&Notice),
    strangers: &mut Strangers,
) {
    let found = domain_files(domain);
    strangers.tell(&found, notify);
    for file in found.unfinished {
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

/// Sweeps, then has iceoryx2, if there is a node, release what killed processes held: places, queues, borrowed samples. In this order: it
/// would wait for an unfinished segment without end.
pub(crate) fn clean(
    domain: &Domain,
    node: Option<&Node<TransportService>>,
    exclusive: &AttachGuard,
    notify: &dyn Fn(&Notice),
    strangers: &mut Strangers,
) {
    sweep(domain, exclusive, notify, strangers);
    let Some(node) = node else { return };
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

/// Removes every file of this user's in a domain without processes, so that leftovers of killed processes cannot get in the way. Keeps the
/// domain's lock files, the generation numbers, and the records, on which observers may wait. Under the exclusive attach lock no
/// process enters the domain.
pub(crate) fn wipe(domain: &Domain, exclusive: &AttachGuard) {
    let kept = [GENERATION_SUFFIX, ONLY_HERE_SUFFIX, RECORD_SUFFIX];
    // Nor the counter of nodes: a stranger who watches could take its name before it is made anew.
    wipe_but(domain, exclusive, Some(&node_counter(domain)), |name| {
        name.starts_with('.') || kept.iter().any(|suffix| name.ends_with(suffix))
    });
}

/// As [`wipe`], by the last process: keeps only files of these names, and root folder and lock files only for them.
pub(crate) fn wipe_all(domain: &Domain, kept: &[String], exclusive: &AttachGuard) {
    let is_lock = |name: &str| !kept.is_empty() && name.starts_with('.');
    wipe_but(domain, exclusive, None, |name| is_lock(name) || kept.iter().any(|kept| kept == name));
    // One that is not empty stays.
    let _ = fs::remove_dir(domain.root());
}

fn wipe_but(
    domain: &Domain,
    _exclusive: &AttachGuard,
    kept: Option<&Path>,
    is_kept: impl Fn(&str) -> bool,
) {
    // What cannot be removed is swept, reused or tried again by the next daemon.
    for entry in entries(Path::new(SHARED_MEMORY_FOLDER)) {
        let is_named = |name: &str| name.starts_with(domain.prefix());
        // Of this very entry: root could remove another user's, too.
        let is_own = |file: fs::Metadata| file.is_file() && is_ours(file.uid());
        if kept == Some(&*entry.path()) {
            continue;
        }
        if entry.file_name().to_str().is_some_and(is_named) && entry.metadata().is_ok_and(is_own) {
            let _ = fs::remove_file(entry.path());
        }
    }
    for entry in entries(domain.root()) {
        if !entry.file_name().to_str().is_some_and(&is_kept) {
            let path = entry.path();
            let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
            let _ = if is_folder { fs::remove_dir_all(&path) } else { fs::remove_file(&path) };
        }
    }
}

fn entries(folder: &Path) -> impl Iterator<Item = fs::DirEntry> {
    fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok)
}
