//! What iceoryx2 opens in the folder of shared memory, where every user can put files.
//!
//! iceoryx2 opens, maps and writes whatever has the name that it looks for. Some of these names can be foreseen: that of a queue from a new publisher, or from one that a
//! killed process has left, has parts that everybody can read in other names. Who is faster than the daemon could end it by SIGBUS, or have it wait without end. A
//! program whose `shm_open` is the one of this module ([`program`](crate::program) says so) does not see files of other users: to iceoryx2 they are not there.
#![allow(unsafe_code)]

use mapd_transport::{SHARED_MEMORY_FOLDER, Untrusted, open_guarded};
use rustix::fs::{Mode, OFlags};
use rustix::io::Errno;
use std::ffi::{CStr, OsStr, c_char, c_int};
use std::io;
use std::os::fd::IntoRawFd;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;

/// Rights that nobody but the owner of a segment has: what others can write they can truncate.
const OTHERS_WRITE: Mode = Mode::WGRP.union(Mode::WOTH);

/// What `shm_open` does in a program that serves maps: the same as the C library's, but that what belongs to another user, or can be written by one, is not there. Where it
/// is in the way of a new segment, the error is `EACCES`: after `EEXIST` iceoryx2 would try again without end.
///
/// # Safety
///
/// The same as of the C library's: `name` is a text of C.
pub unsafe fn shm_open(name: *const c_char, flags: c_int, mode: u32) -> c_int {
    // SAFETY: the caller's duty.
    let name = unsafe { CStr::from_ptr(name) };
    match open(name.to_bytes(), OFlags::from_bits_retain(flags.cast_unsigned()), mode) {
        Ok(file) => file,
        Err(error) => {
            errno::set_errno(errno::Errno(error.raw_os_error()));
            -1
        }
    }
}

fn open(name: &[u8], flags: OFlags, mode: u32) -> Result<c_int, Errno> {
    let plain = name.strip_prefix(b"/").unwrap_or(name);
    if plain.is_empty() || plain.contains(&b'/') {
        return Err(Errno::INVAL);
    }
    let path = Path::new(SHARED_MEMORY_FOLDER).join(OsStr::from_bytes(plain));
    let us = rustix::process::geteuid().as_raw();
    match open_guarded(&path, flags, Mode::from_raw_mode(mode), us) {
        Ok((file, stat)) => match Mode::from_raw_mode(stat.st_mode).intersects(OTHERS_WRITE) {
            true => Err(Errno::NOENT),
            false => Ok(file.into_raw_fd()),
        },
        Err(Untrusted::OtherOwner(_)) if flags.contains(OFlags::CREATE) => Err(Errno::ACCESS),
        Err(Untrusted::OtherOwner(_)) => Err(Errno::NOENT),
        Err(Untrusted::Io(error)) => Err(as_errno(&error)),
    }
}

/// What the system said; of what is no file, that it may not be opened.
fn as_errno(error: &io::Error) -> Errno {
    Errno::from_io_error(error).unwrap_or(Errno::ACCESS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::os::fd::{FromRawFd, OwnedFd};
    use std::os::unix::fs::PermissionsExt;

    /// Opens under a name below `/dev/shm`, and closes again.
    fn opened(name: &str, flags: OFlags) -> Result<(), Errno> {
        let file = open(format!("/{name}").as_bytes(), flags, 0o600)?;
        // SAFETY: it was opened here, and nobody else has it.
        drop(unsafe { OwnedFd::from_raw_fd(file) });
        Ok(())
    }

    #[test]
    fn only_what_this_user_alone_can_write_is_there() {
        let name = format!("mapdguard{}", std::process::id());
        let path = Path::new(SHARED_MEMORY_FOLDER).join(&name);
        let make = OFlags::RDWR | OFlags::CREATE | OFlags::EXCL;
        assert_eq!(opened(&name, OFlags::RDWR), Err(Errno::NOENT));
        assert_eq!(opened(&name, make), Ok(()));
        assert_eq!(opened(&name, make), Err(Errno::EXIST));
        assert_eq!(opened(&name, OFlags::RDWR), Ok(()));
        fs::set_permissions(&path, fs::Permissions::from_mode(0o666)).expect("changed");
        assert_eq!(opened(&name, OFlags::RDWR), Err(Errno::NOENT));
        fs::remove_file(&path).expect("removed");
        std::os::unix::fs::symlink("/dev/null", &path).expect("a link");
        assert_eq!(opened(&name, OFlags::RDWR), Err(Errno::LOOP));
        fs::remove_file(&path).expect("removed");
        for wrong in ["", "a/b", "/"] {
            assert_eq!(opened(wrong, OFlags::RDWR), Err(Errno::INVAL), "{wrong:?}");
        }
    }
}
