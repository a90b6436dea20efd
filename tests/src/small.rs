//! Shared memory, or another folder, of any size: a thread that sees one of its own, and whatever it starts sees the same.

use crate::tracer::Moment;
use nix::mount::{MsFlags, mount};
use nix::sched::{CloneFlags, unshare};
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use syscalls::Sysno;

/// Runs `work` in a thread whose `/dev/shm` is empty and holds at most `bytes`. `None`, with the reason said aloud, where
/// that is not permitted.
pub fn in_small_shared_memory<T: Send>(bytes: u64, work: impl FnOnce() -> T + Send) -> Option<T> {
    in_small_folder(Path::new("/dev/shm"), bytes, work)
}

/// The same of any folder.
pub fn in_small_folder<T: Send>(
    folder: &Path,
    bytes: u64,
    work: impl FnOnce() -> T + Send,
) -> Option<T> {
    beside_others(folder, || mount_own(folder, bytes), work)
}

/// Likewise in a thread for which a folder is read-only, with what is in it.
pub fn in_read_only_folder<T: Send>(folder: &Path, work: impl FnOnce() -> T + Send) -> Option<T> {
    let nothing: Option<&str> = None;
    let make = || {
        mount(Some(folder), folder, nothing, MsFlags::MS_BIND, nothing)?;
        let flags = MsFlags::MS_BIND | MsFlags::MS_REMOUNT | MsFlags::MS_RDONLY;
        Ok(mount(nothing, folder, nothing, flags, nothing)?)
    };
    beside_others(folder, make, work)
}

/// Runs `work` in a thread that sees what `make` mounts at a folder, which others do not.
fn beside_others<T: Send>(
    folder: &Path,
    make: impl FnOnce() -> io::Result<()> + Send,
    work: impl FnOnce() -> T + Send,
) -> Option<T> {
    std::thread::scope(|scope| {
        let thread = scope.spawn(|| match leave_others().and_then(|()| make()) {
            Ok(()) => Some(work()),
            Err(error) => {
                crate::say(&format!(
                    "skipped: {} of our own cannot be mounted: {error}",
                    folder.display()
                ));
                None
            }
        });
        thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

fn leave_others() -> io::Result<()> {
    let nothing: Option<&str> = None;
    unshare(CloneFlags::CLONE_NEWNS)?;
    // Else the new mount would be seen outside.
    mount(nothing, "/", nothing, MsFlags::MS_REC | MsFlags::MS_PRIVATE, nothing)?;
    Ok(())
}

fn mount_own(folder: &Path, bytes: u64) -> io::Result<()> {
    let options = format!("size={bytes},mode=1777");
    mount(Some("tmpfs"), folder, Some("tmpfs"), MsFlags::empty(), Some(options.as_str()))?;
    Ok(())
}

/// Moments of a traced program between which it takes nothing of `/dev/shm`, gives nothing back and asks neither how much is left nor what is there, as one number: whoever
/// fills it up at one of them makes the same of it as at any other. What others ask is not seen.
#[derive(Default)]
pub struct SameRoom {
    number: usize,
    left: Option<[u64; 2]>,
    asked: bool,
}

impl SameRoom {
    /// The number of the moment that has come.
    ///
    /// Errors: there is no `/dev/shm`.
    pub fn number(&mut self, moment: &Moment) -> io::Result<usize> {
        let room = rustix::fs::statvfs("/dev/shm")?;
        let left = Some([room.f_bfree, room.f_ffree]);
        self.number += usize::from(self.asked || left != self.left);
        self.left = left;
        self.asked = matches!(moment.name, Sysno::statfs | Sysno::fstatfs | Sysno::getdents64);
        Ok(self.number)
    }
}

/// A file that takes all of `/dev/shm` that is left. Dropping it gives it back.
pub struct Filler(PathBuf);

impl Filler {
    /// Takes everything.
    ///
    /// Errors: the file cannot be made. That it cannot grow any more is what is wanted.
    pub fn fill() -> io::Result<Self> {
        let path = PathBuf::from("/dev/shm/filler");
        let mut file = File::create(&path)?;
        let filler = Self(path);
        for chunk in [1 << 16, 1 << 12, 1] {
            let zeros = vec![0; chunk];
            while file.write_all(&zeros).is_ok() {}
        }
        Ok(filler)
    }
}

impl Drop for Filler {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}
