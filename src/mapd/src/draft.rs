//! Files that appear under their names whole, whatever ends who writes them.
//!
//! A file is written as `.NAME.new` beside its place and renamed there. It is locked meanwhile: the kernel unlocks it when
//! its writer ends, however it ends, and the next writer of NAME then takes what is left over for its own draft. Should
//! another process be writing the same file just now, or the file system know no locks, the draft has a name of its own.

use crate::clock::since_epoch;
use anyhow::{Context, Result, ensure};
use mapd_transport::open_guarded;
use rustix::fs::{Mode, OFlags};
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

/// Attempts to take over a draft, should its writer finish it just then.
const ATTEMPTS: usize = 8;

/// Mode of a file that is made, less what the umask takes away.
const NEW_FILE: u32 = 0o666;

/// A file that is being written. Removed when dropped, unless it is published.
pub(crate) struct Draft {
    path: PathBuf,
    place: PathBuf,
    file: File,
    is_published: bool,
}

impl Draft {
    /// An empty file, readable and writable, for what will be at `place`.
    ///
    /// Errors: the folder cannot be written; something other than a file is at `place`.
    pub(crate) fn begin(place: &Path) -> Result<Self> {
        ensure!(
            fs::metadata(place).map_or(true, |there| there.is_file()),
            "{} is there already and no file",
            place.display()
        );
        let named = |ending: &str| {
            draft_of(place, ending).with_context(|| format!("{} names no file", place.display()))
        };
        let path = named(".new")?;
        let taken = (0..ATTEMPTS).find_map(|_| take(&path).transpose());
        let (path, file) = match taken {
            Some(Ok(file)) => (path, file),
            _ => {
                let now = since_epoch().as_nanos();
                let path = named(&format!(".{}-{now}.new", std::process::id()))?;
                let mut options = OpenOptions::new();
                let file = options.read(true).write(true).create_new(true).open(&path)?;
                (path, file)
            }
        };
        Ok(Self { path, place: place.to_owned(), file, is_published: false })
    }

    /// Where it is until it is published.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// The file.
    pub(crate) fn file(&self) -> &File {
        &self.file
    }

    /// Gives it its name, in the place of what was there.
    ///
    /// Errors: what the system says.
    pub(crate) fn publish(mut self) -> io::Result<()> {
        fs::rename(&self.path, &self.place)?;
        self.is_published = true;
        Ok(())
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        if !self.is_published {
            // One that stays is taken by the next writer.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// Opens or makes a draft and locks it. `None`: its last writer published or removed it just then.
///
/// Errors: another writer has it; it is not ours to write.
fn take(path: &Path) -> io::Result<Option<File>> {
    // Whatever it held is of no use, but must not go before it is ours.
    let access = OFlags::RDWR | OFlags::CREATE;
    let us = rustix::process::geteuid().as_raw();
    let (file, _) = open_guarded(path, access, Mode::from_raw_mode(NEW_FILE), us)?;
    let file = File::from(file);
    file.try_lock().map_err(io::Error::from)?;
    let own = file.metadata()?;
    // Another name of it may be that of a file that is to stay as it is.
    if own.nlink() > 1 {
        return Err(io::ErrorKind::PermissionDenied.into());
    }
    let same = |there: fs::Metadata| (there.dev(), there.ino()) == (own.dev(), own.ino());
    if !fs::symlink_metadata(path).is_ok_and(same) {
        return Ok(None);
    }
    file.set_len(0)?;
    Ok(Some(file))
}

/// Removes what a writer that was killed has left of a file.
pub(crate) fn remove_left(place: &Path) {
    let Some(path) = draft_of(place, ".new") else { return };
    if path.exists()
        && let Ok(Some(_locked)) = take(&path)
    {
        // One that stays is taken by the next writer.
        let _ = fs::remove_file(&path);
    }
}

/// Where drafts of a file are.
fn draft_of(place: &Path, ending: &str) -> Option<PathBuf> {
    let mut draft = OsString::from(".");
    draft.push(place.file_name()?);
    draft.push(ending);
    Some(place.with_file_name(draft))
}

/// Writes a small file, which is there as a whole or not. What is no file, such as a pipe or a terminal, is written to.
///
/// Errors: what the system says.
pub(crate) fn write(place: &Path, bytes: &[u8]) -> Result<()> {
    write_by(place, |out| Ok(out.write_all(bytes)?))
}

/// As [`write`], piece by piece. Returns what `fill` does.
///
/// Errors: what the system or `fill` says; then nothing is left behind.
pub fn write_by<T>(place: &Path, fill: impl FnOnce(&mut dyn Write) -> Result<T>) -> Result<T> {
    let writing = || format!("writing {}", place.display());
    let fill = |file: &File| -> Result<T> {
        let mut out = BufWriter::new(file);
        let filled = fill(&mut out)?;
        out.flush()?;
        Ok(filled)
    };
    if fs::metadata(place).is_ok_and(|there| !there.is_file() && !there.is_dir()) {
        let file = OpenOptions::new().write(true).open(place).with_context(writing)?;
        return fill(&file).with_context(writing);
    }
    let draft = Draft::begin(place).with_context(writing)?;
    let filled = fill(draft.file()).with_context(writing)?;
    draft.publish().with_context(writing)?;
    Ok(filled)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("a folder").flatten();
        let mut names: Vec<String> =
            entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    #[test]
    fn what_a_killed_writer_leaves_is_taken_by_the_next() {
        let folder = tempfile::tempdir().expect("a folder");
        let place = folder.path().join("map.mapd");
        fs::write(folder.path().join(".map.mapd.new"), "half of it, and more").expect("written");
        write(&place, b"whole").expect("written");
        assert_eq!(fs::read(&place).expect("there"), b"whole");
        assert_eq!(names(folder.path()), ["map.mapd"]);
    }

    #[test]
    fn two_writers_do_not_meet() {
        let folder = tempfile::tempdir().expect("a folder");
        let place = folder.path().join("map.mapd");
        let begin = || Draft::begin(&place).expect("begun");
        let (first, second) = (begin(), begin());
        for (draft, text) in [(&first, "first"), (&second, "second")] {
            io::Write::write_all(&mut draft.file(), text.as_bytes()).expect("written");
        }
        second.publish().expect("published");
        assert_eq!(fs::read(&place).expect("there"), b"second");
        first.publish().expect("published");
        assert_eq!(fs::read(&place).expect("there"), b"first");
        drop(begin());
        assert_eq!(names(folder.path()), ["map.mapd"]);
    }

    #[test]
    fn nothing_but_files_is_replaced() {
        let folder = tempfile::tempdir().expect("a folder");
        assert!(Draft::begin(folder.path()).is_err());
        assert!(Draft::begin(Path::new("/dev/null")).is_err());
        write(Path::new("/dev/null"), b"gone").expect("written to");
        let place = folder.path().join("map.mapd");
        // A draft that is not ours to write, or leads elsewhere, is left alone.
        std::os::unix::fs::symlink("/dev/null", folder.path().join(".map.mapd.new"))
            .expect("a link");
        write(&place, b"whole").expect("written");
        assert_eq!(names(folder.path()), [".map.mapd.new", "map.mapd"]);
    }
}
