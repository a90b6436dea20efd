//! What lies in the domain: whose it is, who lives in it, what the dead have left.

use super::finding::{Finding, size};
use mapd_transport::{
    AttachError, AttachLock, Domain, DomainFiles, ForeignFile, Presence, SHARED_MEMORY_FOLDER,
    check_owner, domain_files, foreign_node_counter, unfinished_segments,
};
use std::fs::Metadata;
use std::os::unix::fs::MetadataExt;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Two looks for unfinished files so far apart: what a living process makes is finished in between.
const SECOND_LOOK: Duration = Duration::from_millis(100);

/// Longest wait for the attach lock: a daemon holds it for milliseconds.
const LOCK_PATIENCE: Duration = Duration::from_millis(500);

/// Any rights of others than the owner.
const OTHERS: u32 = 0o077;

/// Those of a root folder that is shared with a group.
const SHARED_FOLDER: u32 = 0o050;

/// Those of a file that is.
const SHARED_FILE: u32 = 0o040;

/// Endings of the files that may be: what is published.
const SHARED: [&str; 3] = [".data", ".published", ".staged"];

/// Examines the domain. Whether clients can go in.
pub(super) fn examine(domain: &Domain, out: &mut Vec<Finding>) -> bool {
    let check = "root folder";
    let root = domain.root().display();
    match check_owner(domain) {
        Ok(()) => {}
        Err(AttachError::Io { source, .. }) if source.kind() == std::io::ErrorKind::NotFound => {
            out.push(Finding::ok(
                check,
                format!("{root} does not exist: no daemon has been started"),
            ));
            leftovers(domain, true, out);
            strangers(domain, out);
            return false;
        }
        Err(AttachError::PermissionDenied { owner, trusted, .. }) => {
            out.push(Finding::problem(
                check,
                format!("{root} belongs to user {owner}, trusted is user {trusted}"),
                "run daemon and clients as one user, name the daemon's with --owner, or take another --prefix; if that user has nothing to do with mapd, remove it",
            ));
            return false;
        }
        Err(error) => {
            let advice = format!("remove {root}, and start the daemon again");
            out.push(Finding::problem(check, error.to_string(), advice));
            return false;
        }
    }
    // Whoever may not look inside can say nothing of what is there.
    if let Err(error) = std::fs::read_dir(domain.root()) {
        out.push(Finding::problem(
            check,
            format!("{root}, of user {}: {error}", domain.owner()),
            "run this as that user, or start its daemon with --share group:NAME, of a group that has both users",
        ));
        return false;
    }
    match domain.root().metadata() {
        Ok(metadata) => out.push(match metadata.mode() & OTHERS {
            0 => Finding::ok(check, format!("{root}, of user {} alone", metadata.uid())),
            SHARED_FOLDER => Finding::ok(
                check,
                format!("{root}, of user {}, shared with group {}", metadata.uid(), metadata.gid()),
            ),
            _ => Finding::problem(
                check,
                format!(
                    "{root} has mode {:04o}: other users may come in",
                    metadata.mode() & 0o7777
                ),
                format!("chmod 700 {root}, or 750 where a daemon shares with a group"),
            ),
        }),
        Err(error) => {
            out.push(Finding::problem(check, format!("{root}: {error}"), "start the daemon again"));
        }
    }
    let deserted = Presence::is_deserted(domain);
    lock(domain, out);
    unfinished(domain, deserted, out);
    leftovers(domain, deserted, out);
    rights(domain, out);
    strangers(domain, out);
    true
}

/// What other users have put where the domain's files are.
fn strangers(domain: &Domain, out: &mut Vec<Finding>) {
    let check = "other users' files";
    let DomainFiles { foreign, foreign_count, .. } = domain_files(domain);
    if let Some(counter) = foreign_node_counter(domain) {
        out.push(Finding::problem(
            check,
            format!("{counter}: it has a name that subscribers need, so that daemons serve observers alone"),
            "have it removed, and start the daemon again, or take another --prefix",
        ));
    }
    if foreign.is_empty() {
        out.push(Finding::ok(check, "none"));
        return;
    }
    let named: Vec<String> = foreign.iter().map(ForeignFile::to_string).collect();
    let more = match foreign_count - foreign.len() {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    out.push(Finding::note(
        check,
        format!("named as if they were of this domain, and ignored: {}{more}", named.join("; ")),
        "have their owners, or root, remove them: they take room in shared memory",
    ));
}

fn lock(domain: &Domain, out: &mut Vec<Finding>) {
    let check = "attach lock";
    let lock = match AttachLock::open(domain) {
        Ok(lock) => lock,
        Err(error) if error.kind() == std::io::ErrorKind::PermissionDenied => {
            out.push(Finding::ok(check, "its user's alone: an observer needs none"));
            return;
        }
        Err(_) => {
            out.push(Finding::ok(check, "not there: no daemon runs"));
            return;
        }
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

/// Files of the domain in shared memory, the root folder and what other users have put there left out. No link is followed.
pub(super) fn segments(domain: &Domain) -> Vec<(PathBuf, Metadata)> {
    let entries = std::fs::read_dir(SHARED_MEMORY_FOLDER).into_iter().flatten().flatten();
    let named = entries
        .filter(|entry| entry.file_name().to_string_lossy().starts_with(domain.prefix()))
        .filter_map(|entry| Some((entry.path(), entry.metadata().ok()?)));
    named.filter(|(_, file)| file.is_file() && file.uid() == domain.owner()).collect()
}

fn leftovers(domain: &Domain, deserted: bool, out: &mut Vec<Finding>) {
    let check = "files of dead processes";
    let sizes = segments(domain).into_iter().map(|(_, file)| file.len());
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
    let inside = std::fs::read_dir(domain.root()).into_iter().flatten().flatten();
    let inside = inside.filter_map(|entry| Some((entry.path(), entry.metadata().ok()?)));
    let files = segments(domain).into_iter().chain(inside);
    let is_open = |(path, file): &(PathBuf, Metadata)| {
        let is_published = SHARED.iter().any(|end| path.to_string_lossy().ends_with(end));
        let allowed = if is_published { SHARED_FILE } else { 0 };
        // Folders of iceoryx2's own show others names at most, and hold nothing that they may read.
        file.is_file() && file.mode() & OTHERS & !allowed != 0
    };
    out.push(match { files }.find(is_open) {
        Some((path, _)) => Finding::problem(
            "rights",
            format!("{} is open to other users", path.display()),
            "end all processes of the domain and start the daemon again; a daemon takes these rights away when it starts",
        ),
        None => Finding::ok("rights", "others may write nothing, and read no more than is shared"),
    });
}
