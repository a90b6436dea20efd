//! Compiled archives on disk, so that a map is compiled once and published again within milliseconds.
//!
//! An archive's name is its [`Key`]: a hash of everything that shapes it. Files appear under their names whole, by renaming;
//! they are never changed afterwards. The cache is a convenience and nothing else: it may be deleted, in part or as a whole,
//! at any time, by anyone; what is read from it is proved before it is used; a file that does not prove, or is not what its
//! name says, is removed. Pipes, folders and devices under its names are not waited for, links are not followed, and what belongs to another user is not there:
//! others may be able to write to a folder that is named for it.
//!
//! ```text
//! {folder}/{key}.mapd        an archive; the time of its last use is the file's
//! {folder}/{key}.includes    the files that a document includes, where it does
//! {folder}/{key}.known       a document's hash, and the state of its files when it was computed
//! {folder}/{prefix}{map}.served       the key of what was served last
//! {folder}/{prefix}{map}.generation   the last generation number of a map (see `mapd::serve`)
//! {folder}/.new-…            something that is being written, locked meanwhile; one that is not is removed at the next start
//! ```
//!
//! Several daemons may share a folder. All functions are about files only: nothing here knows how a map is compiled.

mod key;
mod known;

pub use key::{InputHash, Key};
pub use known::{HashedInput, Identity};

use crate::clock::since_epoch;
use mapd_transport::{open_owned, read_owned};
use std::ffi::OsStr;
use std::fs::{self, DirBuilder, File, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::os::unix::fs::{DirBuilderExt, OpenOptionsExt};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::time::SystemTime;

/// An archive that is opened for reading.
#[derive(Debug)]
pub struct OpenArchive {
    /// Its file.
    pub file: File,
    /// Its length \[bytes\].
    pub length: u64,
}

/// Bytes of archives that a cache holds, if nothing else is said.
pub const DEFAULT_LIMIT: u64 = 4 << 30;

/// Mode of the folder: maps may be confidential.
const FOLDER_MODE: u32 = 0o700;

/// Attempts to begin a file, should another daemon, which starts just now, take it for one that was left behind.
const ATTEMPTS: usize = 8;

/// Records of a kind, some hundred bytes each, that are kept; those that were written first go first. More than the maps of
/// any daemon: each has one of a kind.
const MOST_RECORDS: usize = 4096;

/// Records that are written before those that are too many are looked for again: looking takes as long as there are files.
const RECORDS_UNLOOKED: usize = 256;

/// Longest record that is read \[bytes\]: one names the files that a document includes.
const LONGEST_RECORD: u64 = 16 << 20;

const ARCHIVE: &str = "mapd";
const SERVED: &str = "served";
const INCLUDES: &str = "includes";
const UNFINISHED: &str = ".new-";

/// A folder of archives.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: PathBuf,
    limit: u64,
    /// Records written in this process.
    written: Arc<AtomicUsize>,
}

/// An archive that is being written. Removed when dropped, unless it is kept.
#[derive(Debug)]
pub struct Unfinished {
    path: PathBuf,
    kept: bool,
    /// Locked: the kernel unlocks it when this process ends, however it ends.
    locked: File,
}

impl Unfinished {
    /// Where it is to be written; an empty file is there.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        if !self.kept {
            // Else the next daemon removes it.
            let _ = fs::remove_file(&self.path);
        }
    }
}

impl Cache {
    /// The folder where nothing else is said: `$XDG_CACHE_HOME/mapd`, `$HOME/.cache/mapd`; `/var/cache/mapd` for root. `None`
    /// for a user without a home.
    pub fn default_folder() -> Option<PathBuf> {
        if rustix::process::geteuid().is_root() {
            return Some(PathBuf::from("/var/cache/mapd"));
        }
        let of = |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|p| p.is_absolute());
        let base = of("XDG_CACHE_HOME").or_else(|| Some(of("HOME")?.join(".cache")));
        base.map(|base| base.join("mapd"))
    }

    /// Opens a folder, which is made if it is not there, and removes what killed processes left in it. `limit`: bytes of
    /// archives that it may hold; the newest one is kept whatever its size. Of a folder that cannot be written, what lies in it is used all
    /// the same: see [`Cache::check_writable`].
    ///
    /// Errors: the folder cannot be made or read.
    pub fn open(folder: impl Into<PathBuf>, limit: u64) -> io::Result<Self> {
        let cache = Self { folder: folder.into(), limit, written: Arc::default() };
        cache.make_folder()?;
        for entry in fs::read_dir(&cache.folder)?.filter_map(Result::ok) {
            let unfinished = entry.file_name().to_string_lossy().starts_with(UNFINISHED);
            let path = entry.path();
            if unfinished && open_owned(&path, us()).is_ok_and(|file| file.try_lock().is_ok()) {
                // Tried again by the next.
                let _ = fs::remove_file(path);
            }
        }
        cache.drop_old_records();
        Ok(cache)
    }

    /// Looks whether anything can be added.
    ///
    /// Errors: why not. It may be read-only, or full.
    pub fn check_writable(&self) -> io::Result<()> {
        self.begin().map(drop)
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Bytes of archives that it may hold.
    pub fn limit(&self) -> u64 {
        self.limit
    }

    /// Bytes of archives that it holds now.
    pub fn bytes(&self) -> u64 {
        self.archives().iter().map(|(_, length, _)| length).sum()
    }

    /// An archive, opened for reading; it stays readable whatever becomes of its name. It has not
    /// been proved.
    pub fn get(&self, key: &Key) -> Option<OpenArchive> {
        let file = open_owned(&self.path(key, ARCHIVE), us()).ok()?;
        let metadata = file.metadata().ok()?;
        // The least recently used archives are removed first. On a read-only disk all of them stay.
        let _ = file.set_modified(SystemTime::now());
        Some(OpenArchive { file, length: metadata.len() })
    }

    /// A place to write an archive to.
    ///
    /// Errors: what the system says.
    pub fn begin(&self) -> io::Result<Unfinished> {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        // It may have been deleted.
        self.make_folder()?;
        for _ in 0..ATTEMPTS {
            let (process, number) = (std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed));
            let name = format!("{UNFINISHED}{process}-{number}-{}", since_epoch().as_nanos());
            let path = self.folder.join(name);
            let file = OpenOptions::new().write(true).create_new(true).mode(0o600).open(&path)?;
            // Without locks, no other process takes it for an abandoned one either.
            let taken = matches!(file.try_lock(), Err(TryLockError::WouldBlock));
            if !taken && path.exists() {
                return Ok(Unfinished { path, kept: false, locked: file });
            }
        }
        Err(io::ErrorKind::ResourceBusy.into())
    }

    /// Gives an archive its name, and opens it. Others make room for it if there are too many.
    ///
    /// Errors: what the system says.
    pub fn keep(&self, mut unfinished: Unfinished, key: &Key) -> io::Result<OpenArchive> {
        let file = open_owned(&unfinished.path, us())?;
        let length = file.metadata()?.len();
        fs::rename(&unfinished.path, self.path(key, ARCHIVE))?;
        unfinished.kept = true;
        self.make_room(key);
        Ok(OpenArchive { file, length })
    }

    /// Removes an archive, one that fails verification. Processes that have it open keep it.
    pub fn remove(&self, key: &Key) {
        // One that stays is found not to prove again.
        let _ = fs::remove_file(self.path(key, ARCHIVE));
    }

    /// Remembers which files a document includes. `document` is a key of the document alone.
    ///
    /// Errors: a name that is no text; what the system says.
    pub fn remember_includes(&self, document: &Key, files: &[PathBuf]) -> io::Result<()> {
        self.write(&self.path(document, INCLUDES), &serde_json::to_vec(files)?)
    }

    /// Remembers which archive is served under a name.
    ///
    /// Errors: what the system says.
    pub fn remember_served(&self, name: &str, key: &Key) -> io::Result<()> {
        self.write(&self.folder.join(format!("{name}.{SERVED}")), key.to_text().as_bytes())
    }

    /// The archive that was served last under a name, as far as is remembered.
    pub fn last_served(&self, name: &str) -> Option<Key> {
        Key::from_text(&self.read(&self.folder.join(format!("{name}.{SERVED}")))?)
    }

    /// Writes a record, which is there as a whole or not.
    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let mut unfinished = self.begin()?;
        (&unfinished.locked).write_all(bytes)?;
        fs::rename(&unfinished.path, path)?;
        unfinished.kept = true;
        if self.written.fetch_add(1, Ordering::Relaxed) % RECORDS_UNLOOKED == RECORDS_UNLOOKED - 1 {
            self.drop_old_records();
        }
        Ok(())
    }

    /// Removes the records that are too many.
    fn drop_old_records(&self) {
        for kind in [SERVED, INCLUDES, known::KNOWN] {
            let mut records = self.files(OsStr::new(kind));
            records.sort_by_key(|(_, _, written)| std::cmp::Reverse(*written));
            for (old, ..) in records.iter().skip(MOST_RECORDS) {
                // One that stays goes with the next.
                let _ = fs::remove_file(old);
            }
        }
    }

    /// The files that a document includes, as far as is remembered.
    pub fn includes(&self, document: &Key) -> Vec<PathBuf> {
        let text = self.read(&self.path(document, INCLUDES));
        text.and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default()
    }

    /// Reads a record; nothing where there is none, or something else has its name.
    fn read(&self, record: &Path) -> Option<String> {
        read_owned(record, us(), LONGEST_RECORD).ok()
    }

    fn make_folder(&self) -> io::Result<()> {
        DirBuilder::new().recursive(true).mode(FOLDER_MODE).create(&self.folder)
    }

    fn path(&self, key: &Key, ending: &str) -> PathBuf {
        self.folder.join(format!("{key}.{ending}"))
    }

    /// Archives: path, length, time of the last use.
    fn archives(&self) -> Vec<(PathBuf, u64, SystemTime)> {
        self.files(OsStr::new(ARCHIVE))
    }

    /// Files of a kind: path, length, time.
    fn files(&self, kind: &OsStr) -> Vec<(PathBuf, u64, SystemTime)> {
        let entries = fs::read_dir(&self.folder).into_iter().flatten().filter_map(Result::ok);
        let paths = entries.map(|entry| entry.path()).filter(|path| path.extension() == Some(kind));
        let known = paths.filter_map(|path| {
            let metadata = fs::metadata(&path).ok()?;
            Some((path, metadata.len(), metadata.modified().ok()?))
        });
        known.collect()
    }

    /// Removes the archives that have not been used for longest, but never the newest.
    fn make_room(&self, newest: &Key) {
        let mut archives = self.archives();
        archives.sort_by_key(|(_, _, used)| *used);
        let mut bytes: u64 = archives.iter().map(|(_, length, _)| length).sum();
        let newest = self.path(newest, ARCHIVE);
        for (path, length, _) in archives.iter().filter(|(path, ..)| *path != newest) {
            if bytes <= self.limit {
                return;
            }
            if fs::remove_file(path).is_ok() {
                bytes -= length;
            }
        }
    }
}

/// Whose files are used: this process's user's.
fn us() -> u32 {
    rustix::process::geteuid().as_raw()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read;
    use std::time::Duration;

    fn key(number: u8) -> Key {
        Key::of_archive(&[number; 32], &[0; 8])
    }

    fn put(cache: &Cache, key: &Key, length: usize) {
        let unfinished = cache.begin().expect("a place");
        fs::write(unfinished.path(), vec![7; length]).expect("written");
        assert_eq!(cache.keep(unfinished, key).expect("kept").length, length as u64);
    }

    #[test]
    fn the_least_recently_used_make_room() {
        let folder = tempfile::tempdir().expect("a folder");
        let cache = Cache::open(folder.path().join("new/folder"), 100).expect("opens");
        for number in 0..4 {
            put(&cache, &key(number), 30);
            std::thread::sleep(Duration::from_millis(5));
            assert!(cache.get(&key(0)).is_some(), "is used and stays");
            std::thread::sleep(Duration::from_millis(5));
        }
        let there: Vec<bool> = (0..4).map(|number| cache.get(&key(number)).is_some()).collect();
        assert_eq!(there, [true, false, true, true]);
        assert_eq!(cache.bytes(), 90);
        put(&cache, &key(9), 1000);
        assert_eq!(cache.bytes(), 1000, "the newest stays, whatever its size");
    }

    #[test]
    fn records_do_not_pile_up() {
        let folder = tempfile::tempdir().expect("a folder");
        let cache = Cache::open(folder.path(), 100).expect("opens");
        let records = || cache.files(OsStr::new(INCLUDES)).len();
        for number in 0..=MOST_RECORDS + RECORDS_UNLOOKED {
            let document = Key::of_document(&[7; 32], Path::new(&format!("/{number}")));
            cache.remember_includes(&document, &[PathBuf::from("x")]).expect("kept");
        }
        assert!(records() < MOST_RECORDS + RECORDS_UNLOOKED);
        Cache::open(folder.path(), 100).expect("opens");
        assert_eq!(records(), MOST_RECORDS);
    }

    #[test]
    fn it_may_be_deleted_at_any_time() {
        let folder = tempfile::tempdir().expect("a folder");
        let folder = folder.path().join("cache");
        let cache = Cache::open(&folder, 100).expect("opens");
        put(&cache, &key(1), 10);
        let mut file = cache.get(&key(1)).expect("there").file;
        fs::remove_dir_all(&folder).expect("deleted");
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).expect("still readable");
        assert_eq!(bytes.len(), 10);
        assert!(cache.get(&key(1)).is_none() && cache.includes(&key(2)).is_empty());
        put(&cache, &key(1), 10);
        assert!(cache.get(&key(1)).is_some());
    }

    #[test]
    fn what_killed_processes_leave_is_removed_and_what_is_being_written_is_not() {
        let folder = tempfile::tempdir().expect("a folder");
        let cache = Cache::open(folder.path(), 100).expect("opens");
        let unfinished = cache.begin().expect("a place");
        fs::write(folder.path().join(".new-1-2-3"), "left behind").expect("written");
        let again = Cache::open(folder.path(), 100).expect("opens");
        assert!(unfinished.path().exists() && !folder.path().join(".new-1-2-3").exists());
        again.keep(unfinished, &key(1)).expect("kept");
        assert!(cache.get(&key(1)).is_some());
    }

    #[test]
    fn what_is_not_kept_leaves_nothing() {
        let folder = tempfile::tempdir().expect("a folder");
        let cache = Cache::open(folder.path(), 100).expect("opens");
        drop(cache.begin().expect("a place"));
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0);
    }
}
