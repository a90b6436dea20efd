//! A reader that means harm, with whatever rights it is given: `hostile_reader NAME`.
//!
//! Tries to change, shorten, remove, replace and lock every file of the domain, and says what it could do, a line each. Then it keeps what it holds: locks,
//! mappings, descriptors; and moves processes that sleep on the map's record to another word, until stdin ends.
#![allow(unsafe_code, clippy::print_stdout)]

use mapd_client::{Client, Domain};
use mapd_transport::{Mapping, RECORD_SUFFIX, SHARED_MEMORY_FOLDER};
use std::fs::{File, OpenOptions, Permissions};
use std::io;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use syscalls::{Sysno, raw_syscall};

/// `FUTEX_REQUEUE`: wakes some, and has the others sleep on another word.
const REQUEUE: usize = 3;

/// Bytes of a record, and where its word lies on which readers sleep.
const PAGE: usize = 4096;
const SEQUENCE: usize = 12;

/// Longest wait for the map.
const WAIT: Duration = Duration::from_secs(10);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let map = std::env::args().nth(1).ok_or("expected a map")?;
    let domain = Domain::from_env()?;
    let held = Client::connect_in(&domain, &map, WAIT)?.snapshot();
    let locks: Vec<File> = files(&domain)?.iter().filter_map(|path| harm(path)).collect();
    if File::create(domain.root().join(format!("{map}.overlay"))).is_ok() {
        println!("made a file");
    }
    let record = File::open(domain.root().join(format!("{map}{RECORD_SUFFIX}")))?;
    // SAFETY: nobody looks at the bytes; the kernel is asked about the address of one of its words.
    let mapping = unsafe { Mapping::read_only(&record, PAGE)? };
    let ended = AtomicBool::new(false);
    println!("ready {} {}", locks.len(), held.generation());
    std::thread::scope(|scope| {
        scope.spawn(|| {
            while !ended.load(Ordering::Relaxed) {
                move_sleepers(&mapping);
            }
        });
        let ends = io::stdin().read_line(&mut String::new());
        ended.store(true, Ordering::Relaxed);
        ends
    })?;
    Ok(())
}

fn files(domain: &Domain) -> io::Result<Vec<PathBuf>> {
    let mut all = vec![domain.root().to_owned()];
    for folder in [Path::new(SHARED_MEMORY_FOLDER), domain.root()] {
        for entry in std::fs::read_dir(folder)? {
            let entry = entry?;
            let ours = entry.file_name().to_string_lossy().starts_with(domain.prefix());
            if ours || folder == domain.root() {
                all.push(entry.path());
            }
        }
    }
    Ok(all)
}

/// Tries everything on a file; what it locked.
fn harm(path: &Path) -> Option<File> {
    let told = |what: &str, done: bool| {
        if done {
            println!("{what} {}", path.display());
        }
    };
    told("opened for writing", OpenOptions::new().append(true).open(path).is_ok());
    told("shortened", OpenOptions::new().write(true).truncate(true).open(path).is_ok());
    told(
        "changed the rights of",
        std::fs::set_permissions(path, Permissions::from_mode(0o777)).is_ok(),
    );
    told("renamed", std::fs::rename(path, path.with_extension("away")).is_ok());
    told("removed", std::fs::remove_file(path).is_ok());
    let file = File::open(path).ok()?;
    let locked = file.try_lock().is_ok();
    let is_known = path.is_dir()
        || [".data", RECORD_SUFFIX].iter().any(|end| path.to_string_lossy().ends_with(end));
    told("locked", locked && !is_known);
    locked.then_some(file)
}

/// Moves processes that sleep on the record's word to another word of the page.
fn move_sleepers(record: &Mapping) {
    let word = record.bytes().as_ptr() as usize + SEQUENCE;
    // SAFETY: the call looks up who sleeps on two addresses, which are mapped, and changes no memory.
    let _ =
        unsafe { raw_syscall!(Sysno::futex, word, REQUEUE, 0_usize, i32::MAX as usize, word + 4) };
}
