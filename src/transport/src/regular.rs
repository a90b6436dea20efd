//! Opening files under names that anything may have: a pipe, a folder, a device that never ends. In a folder that other users can write to, such as that of shared
//! memory, also a link to somebody else's file, or a file that a stranger has put there: [`open_guarded`] is the one way to open a file there.

use crate::user::trusts;
use rustix::fd::OwnedFd;
use rustix::fs::{FileType, Mode, OFlags, Stat};
use rustix::io::Errno;
use std::fs::{File, OpenOptions};
use std::io::{self, Read};
use std::os::unix::fs::OpenOptionsExt;
use std::path::Path;

/// Mode of a file that is made: its user alone.
pub const OWN_FILE: Mode = Mode::RUSR.union(Mode::WUSR);

/// Why a file in a folder that other users can write to is not used.
#[derive(Debug)]
pub enum Untrusted {
    /// It belongs to this user.
    OtherOwner(u32),
    /// The system refuses; or, of kind invalid-input, it is no regular file.
    Io(io::Error),
}

impl From<Untrusted> for io::Error {
    fn from(untrusted: Untrusted) -> Self {
        match untrusted {
            Untrusted::OtherOwner(owner) => {
                let message = format!("belongs to user {owner}");
                Self::new(io::ErrorKind::PermissionDenied, message)
            }
            Untrusted::Io(error) => error,
        }
    }
}

/// Opens a regular file of `owner` in a folder that other users can write to: follows no link, waits for no pipe, and asks the file that it has opened what it is
/// and whose. With [`OFlags::CREATE`] it makes one of this mode; a file that was there must pass the same examination.
///
/// Errors: the name is another user's, whatever has it; what the system says; [`io::ErrorKind::InvalidInput`] for what is no regular file.
pub fn open_guarded(
    path: &Path,
    access: OFlags,
    mode: Mode,
    owner: u32,
) -> Result<(OwnedFd, Stat), Untrusted> {
    let flags = access | OFlags::NOFOLLOW | OFlags::NONBLOCK | OFlags::CLOEXEC | OFlags::NOCTTY;
    let opened = rustix::fs::open(path, flags, mode)
        .and_then(|file| rustix::fs::fstat(&file).map(|stat| (file, stat)));
    let (file, stat) = opened.map_err(|error| match rustix::fs::lstat(path) {
        // A link, or a file that its owner keeps to himself.
        Ok(found) if error != Errno::NOENT && !trusts(owner, found.st_uid) => {
            Untrusted::OtherOwner(found.st_uid)
        }
        _ => Untrusted::Io(error.into()),
    })?;
    if !trusts(owner, stat.st_uid) {
        return Err(Untrusted::OtherOwner(stat.st_uid));
    }
    match FileType::from_raw_mode(stat.st_mode) {
        FileType::RegularFile => Ok((file, stat)),
        _ => Err(Untrusted::Io(io::Error::new(io::ErrorKind::InvalidInput, "not a file"))),
    }
}

/// Opens or makes a file of this process's user for reading and writing, as [`open_guarded`] does.
///
/// Errors: as [`open_guarded`].
pub fn create_guarded(path: &Path) -> io::Result<File> {
    let us = rustix::process::geteuid().as_raw();
    let (file, _) = open_guarded(path, OFlags::RDWR | OFlags::CREATE, OWN_FILE, us)?;
    Ok(file.into())
}

/// Opens a regular file for reading; never waits for the other end of a pipe.
///
/// Errors: what the system says; [`io::ErrorKind::InvalidInput`] for what is no regular file.
pub fn open_regular(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    // Of a regular file it changes nothing.
    options.read(true).custom_flags(OFlags::NONBLOCK.bits().cast_signed());
    let file = options.open(path)?;
    match file.metadata()?.is_file() {
        true => Ok(file),
        false => Err(io::Error::new(io::ErrorKind::InvalidInput, "not a file")),
    }
}

/// Reads a text of at most `most` bytes from a regular file of this user; follows no link.
///
/// Errors: those of [`open_owned`]; [`io::ErrorKind::InvalidData`] for a longer one, and for what is no text.
pub fn read_owned(path: &Path, owner: u32, most: u64) -> io::Result<String> {
    read_text(open_owned(path, owner)?, most)
}

/// Opens a regular file of this user for reading; follows no link.
///
/// Errors: as [`open_guarded`]; another user's is [`io::ErrorKind::PermissionDenied`].
pub fn open_owned(path: &Path, owner: u32) -> io::Result<File> {
    let (file, _) = open_guarded(path, OFlags::RDONLY, Mode::empty(), owner)?;
    Ok(file.into())
}

/// Reads a text of at most `most` bytes from a regular file.
///
/// Errors: those of [`open_regular`]; [`io::ErrorKind::InvalidData`] for a longer one, and for what is no text.
pub fn read_regular(path: &Path, most: u64) -> io::Result<String> {
    read_text(open_regular(path)?, most)
}

fn read_text(file: File, most: u64) -> io::Result<String> {
    let mut text = String::new();
    file.take(most.saturating_add(1)).read_to_string(&mut text)?;
    match text.len() as u64 > most {
        true => {
            let message = format!("expected at most {most} bytes, found more");
            Err(io::Error::new(io::ErrorKind::InvalidData, message))
        }
        false => Ok(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_but_a_short_file_is_read() {
        let folder = std::env::temp_dir().join(format!("mapd-regular-{}", std::process::id()));
        std::fs::create_dir(&folder).expect("a folder");
        let [file, pipe] = ["file", "pipe"].map(|name| folder.join(name));
        std::fs::write(&file, "four").expect("written");
        let made = rustix::fs::mknodat(
            rustix::fs::CWD,
            &pipe,
            rustix::fs::FileType::Fifo,
            rustix::fs::Mode::RUSR,
            0,
        );
        made.expect("a pipe");
        assert_eq!(read_regular(&file, 4).ok().as_deref(), Some("four"));
        let refused = |path: &Path| read_regular(path, 3).expect_err("refused").kind();
        assert_eq!(refused(&file), io::ErrorKind::InvalidData);
        for other in [&pipe, &folder, Path::new("/dev/zero")] {
            assert_eq!(refused(other), io::ErrorKind::InvalidInput, "{}", other.display());
        }
        std::fs::remove_dir_all(folder).expect("removed");
    }

    /// Whatever has the name, no link is followed, no pipe waited for, and nothing but a file of the owner opened.
    #[test]
    fn a_guarded_name_is_a_file_of_its_owner() {
        let folder = std::env::temp_dir().join(format!("mapd-guarded-{}", std::process::id()));
        std::fs::create_dir(&folder).expect("a folder");
        let [file, pipe, link, lost] = ["file", "pipe", "link", "lost"].map(|n| folder.join(n));
        std::fs::write(&file, "four").expect("written");
        let (kind, mode) = (rustix::fs::FileType::Fifo, Mode::RUSR | Mode::WUSR);
        rustix::fs::mknodat(rustix::fs::CWD, &pipe, kind, mode, 0).expect("a pipe");
        std::os::unix::fs::symlink(&file, &link).expect("a link");
        std::os::unix::fs::symlink(folder.join("made"), &lost).expect("a link");
        let us = rustix::process::geteuid().as_raw();
        for access in [OFlags::RDONLY, OFlags::RDWR, OFlags::RDWR | OFlags::CREATE] {
            let open = |path: &Path, owner| open_guarded(path, access, OWN_FILE, owner);
            assert!(open(&file, us).is_ok(), "{access:?}");
            for other in [&pipe, &link, &lost, &folder] {
                let refused = open(other, us);
                assert!(matches!(refused, Err(Untrusted::Io(_))), "{}", other.display());
            }
            for other in [&file, &pipe, &link, &lost, &folder] {
                let refused = open(other, us + 1);
                let is_named = matches!(refused, Err(Untrusted::OtherOwner(owner)) if owner == us);
                assert!(is_named, "{}: {refused:?}", other.display());
            }
        }
        assert!(!folder.join("made").exists(), "no link is followed");
        std::fs::remove_dir_all(folder).expect("removed");
    }
}
