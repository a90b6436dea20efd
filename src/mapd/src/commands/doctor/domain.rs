//! What lies in the domain: whose it is, who lives in it, what the dead have left.

use super::finding::{Finding, size};
use mapd_transport::{
    AttachError, AttachLock, Domain, Presence, SHARED_MEMORY_FOLDER, check_owner,
    unfinished_segments,
};
use std::os::unix::fs::MetadataExt;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Two looks for unfinished files so far apart: what a living process makes is finished in between.
const SECOND_LOOK: Duration = Duration::from_millis(100);

/// Longest wait for the attach lock: a daemon holds it for milliseconds.
const LOCK_PATIENCE: Duration = Duration::from_millis(500);

/// Any rights of others than the owner.
const OTHERS: u32 = 0o077;

/// Examines the domain. Whether clients can go in.
pub(super) fn examine(domain: &Domain, out: &mut Vec<Finding>) -> bool {
    let check = "root folder";
    let root = domain.root().display();
    match check_owner(domain) {
        Ok(()) => {}
        Err(AttachError::Io { error, .. }) if error.kind() == std::io::ErrorKind::NotFound => {
            out.push(Finding::ok(
                check,
                format!("{root} is not there: no daemon has been started"),
            ));
            leftovers(domain, true, out);
            return false;
        }
        Err(AttachError::PermissionDenied { owner, us, .. }) => {
            out.push(Finding::problem(
                check,
                format!("{root} belongs to user {owner}, this process runs as user {us}"),
                "run daemon and clients as one user, or take another --prefix",
            ));
            return false;
        }
        Err(error) => {
            let advice = format!("remove {root}, and start the daemon again");
            out.push(Finding::problem(check, error.to_string(), advice));
            return false;
        }
    }
    match domain.root().metadata() {
        Ok(metadata) if metadata.mode() & OTHERS != 0 => out.push(Finding::problem(
            check,
            format!("{root} has mode {:04o}: other users may come in", metadata.mode() & 0o7777),
            format!("chmod 700 {root}"),
        )),
        Ok(_) => out.push(Finding::ok(check, format!("{root}, this user's alone"))),
        Err(error) => {
            out.push(Finding::problem(check, format!("{root}: {error}"), "start the daemon again"));
        }
    }
    let deserted = Presence::is_deserted(domain);
    lock(domain, out);
    unfinished(domain, deserted, out);
    leftovers(domain, deserted, out);
    rights(domain, out);
    true
}

fn lock(domain: &Domain, out: &mut Vec<Finding>) {
    let check = "attach lock";
    let Ok(lock) = AttachLock::open(domain) else {
        out.push(Finding::ok(check, "not there: no daemon runs"));
        return;
    };
    out.push(match lock.shared(Instant::now() + LOCK_PATIENCE) {
        Ok(Some(_)) => Finding::ok(check, "free"),
        Ok(None) => Finding::problem(
            check,
            format!("{} stays locked: a daemon that creates or cleans up is stopped", lock.path().display()),
            "continue that daemon (kill -CONT) or end it (kill -KILL); the kernel then releases the lock",
        ),
        Err(error) => Finding::problem(check, error.to_string(), "start the daemon again"),
    });
}

fn unfinished(domain: &Domain, deserted: bool, out: &mut Vec<Finding>) {
    let before = unfinished_segments(domain);
    if !before.is_empty() {
        std::thread::sleep(SECOND_LOOK);
    }
    let mut still = unfinished_segments(domain);
    still.retain(|file| before.contains(file));
    let found = match still.first() {
        None => {
            out.push(Finding::ok("unfinished files", "none"));
            return;
        }
        Some(file) => format!("{} of killed processes, such as {}", still.len(), file.display()),
    };
    out.push(if deserted {
        Finding::note("unfinished files", found, "start a daemon: it removes them first")
    } else {
        Finding::problem(
            "unfinished files",
            found,
            "wait some seconds: a running daemon removes them; else start one",
        )
    });
}

/// Files of the domain in shared memory, the root folder left out.
pub(super) fn segments(domain: &Domain) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(SHARED_MEMORY_FOLDER) else { return Vec::new() };
    let own = |path: &PathBuf| {
        path.is_file()
            && path.file_name().is_some_and(|n| n.to_string_lossy().starts_with(domain.prefix()))
    };
    entries.flatten().map(|entry| entry.path()).filter(own).collect()
}

fn leftovers(domain: &Domain, deserted: bool, out: &mut Vec<Finding>) {
    let check = "files of dead processes";
    let sizes =
        segments(domain).into_iter().filter_map(|path| path.metadata().ok()).map(|m| m.len());
    let (count, bytes) = sizes.fold((0_u64, 0_u64), |(n, sum), len| (n + 1, sum + len));
    let found = format!("{count} file(s), {} in {SHARED_MEMORY_FOLDER}", size(bytes));
    out.push(match (count, deserted) {
        // iceoryx2 keeps a counter of a few bytes for each prefix.
        (0, _) | (1, true) if bytes < 64 => Finding::ok(check, "none"),
        (_, false) => Finding::ok(check, format!("none; {found} in use")),
        (_, true) => Finding::note(
            check,
            format!("{found}, and nobody uses the domain"),
            format!(
                "start a daemon: it empties the domain; or rm -r {}* once nothing of mapd runs",
                domain.root().with_file_name(domain.prefix()).display()
            ),
        ),
    });
}

fn rights(domain: &Domain, out: &mut Vec<Finding>) {
    let open = segments(domain)
        .into_iter()
        .find(|path| path.metadata().is_ok_and(|metadata| metadata.mode() & OTHERS != 0));
    out.push(match open {
        Some(path) => Finding::problem(
            "rights",
            format!("{} is open to other users", path.display()),
            "end all processes of the domain and start the daemon again; a daemon takes these rights away when it starts",
        ),
        None => Finding::ok("rights", "nothing is open to other users"),
    });
}
