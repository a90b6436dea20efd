//! Opening files under names that anything may have: a pipe, a folder, a device that never ends.

use crate::user::trusts;
use rustix::fs::OFlags;
use std::fs::{File, OpenOptions};
use std::io::{self, Read};
use std::os::unix::fs::{MetadataExt, OpenOptionsExt};
use std::path::Path;

/// Opens a regular file for reading; never waits for the other end of a pipe.
///
/// Errors: what the system says; [`io::ErrorKind::InvalidInput`] for what is no regular file.
pub fn open_regular(path: &Path) -> io::Result<File> {
    // Of a regular file it changes nothing.
    open_with(path, OFlags::NONBLOCK)
}

fn open_with(path: &Path, flags: OFlags) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true).custom_flags(flags.bits().cast_signed());
    let file = options.open(path)?;
    match file.metadata()?.is_file() {
        true => Ok(file),
        false => Err(io::Error::new(io::ErrorKind::InvalidInput, "not a file")),
    }
}

/// Reads a text of at most `most` bytes from a regular file of this user; follows no link.
///
/// Errors: those of [`read_regular`]; [`io::ErrorKind::PermissionDenied`] for another user's.
pub(crate) fn read_owned(path: &Path, owner: u32, most: u64) -> io::Result<String> {
    read_text(open_owned(path, owner)?, most)
}

/// Opens a regular file of this user for reading; follows no link.
///
/// Errors: as [`read_owned`].
pub(crate) fn open_owned(path: &Path, owner: u32) -> io::Result<File> {
    let file = open_with(path, OFlags::NONBLOCK | OFlags::NOFOLLOW)?;
    match trusts(owner, file.metadata()?.uid()) {
        true => Ok(file),
        false => Err(io::ErrorKind::PermissionDenied.into()),
    }
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
}
