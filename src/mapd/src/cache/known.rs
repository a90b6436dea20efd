//! Hashes that need not be computed again: those of files that have not been touched since.
//!
//! Reading half a gigabyte of text to learn that it is what it was takes longer than publishing the archive. A file's node,
//! size and the times of its content and its node tell the same: the kernel sets the latter at each change, and nobody else
//! can.

use super::key::InputHash;
use super::{Cache, Key};
use crate::clock::since_epoch;
use serde::{Deserialize, Serialize};
use std::fs;
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::time::Duration;

pub(super) const KNOWN: &str = "known";

/// Files that were changed so shortly before they were looked at may be changed again without a new time: the kernel's
/// clock for files ticks every few milliseconds.
const SETTLED: Duration = Duration::from_secs(1);

/// What tells one state of a file from another: device, node, size, times of content and of node \[s, ns\].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Identity {
    device: u64,
    node: u64,
    size: u64,
    modified: (i64, i64),
    changed: (i64, i64),
}

impl Identity {
    /// Of a file now.
    ///
    /// Errors: it is not there, or cannot be looked at.
    pub fn of(file: &Path) -> io::Result<Self> {
        let m = fs::metadata(file)?;
        Ok(Self {
            device: m.dev(),
            node: m.ino(),
            size: m.len(),
            modified: (m.mtime(), m.mtime_nsec()),
            changed: (m.ctime(), m.ctime_nsec()),
        })
    }

    /// Whether the file had its last change a while before `looked`, when somebody began to look at it \[since the Unix epoch\]. Of a
    /// clock that has jumped nothing follows: then it had not.
    fn is_settled(&self, looked: Duration) -> bool {
        let (Ok(seconds), Ok(nanoseconds)) = (self.changed.0.try_into(), self.changed.1.try_into())
        else {
            return false;
        };
        let changed = Duration::from_secs(seconds).checked_add(Duration::from_nanos(nanoseconds));
        let age = changed.and_then(|changed| looked.checked_sub(changed));
        age.is_some_and(|age| age > SETTLED)
    }
}

/// A document and what it includes.
#[derive(Debug, PartialEq)]
pub struct HashedInput {
    /// Their hashes.
    pub hash: InputHash,
    /// The document first, then what it includes.
    pub files: Vec<PathBuf>,
}

/// What is known of a document.
#[derive(Serialize, Deserialize)]
struct DocumentRecord {
    /// The document and what it includes.
    files: Vec<(PathBuf, Identity)>,
    document: [u8; 32],
    input: [u8; 32],
}

impl Cache {
    /// Hashes of a document and of what it includes, and all these files: known from before where nothing has been touched,
    /// else computed.
    ///
    /// Errors: a file cannot be read.
    pub fn input_hash(&self, document: &Path, folder: &Path) -> io::Result<HashedInput> {
        let document = std::path::absolute(document)?;
        let record = self.path(&Key::of_place(&document), KNOWN);
        let known =
            self.read(&record).and_then(|text| serde_json::from_str::<DocumentRecord>(&text).ok());
        if let Some(known) = known.filter(|known| known.holds(&document)) {
            let files = known.files.into_iter().map(|(file, _)| file).collect();
            let hash = InputHash { document: known.document, input: known.input };
            return Ok(HashedInput { hash, files });
        }
        // Before they are read: what changes meanwhile is not known.
        let looked = since_epoch();
        let mut files = vec![(document.clone(), Identity::of(&document)?)];
        let mut included = Vec::new();
        let hash = InputHash::of(&document, |alone| {
            included = self.includes(&Key::of_document(alone, folder));
            files.extend(included.iter().filter_map(|f| Some((f.clone(), Identity::of(f).ok()?))));
            included.clone()
        })?;
        if files.len() == included.len() + 1
            && files.iter().all(|(_, file)| file.is_settled(looked))
        {
            let known = DocumentRecord { files, document: hash.document, input: hash.input };
            // Without it the files are read again.
            let _ = self.write(&record, &serde_json::to_vec(&known)?);
        }
        included.insert(0, document);
        Ok(HashedInput { hash, files: included })
    }
}

impl DocumentRecord {
    /// Whether all of it is as it was, and it is about this document.
    fn holds(&self, document: &Path) -> bool {
        let same =
            |(file, then): &(PathBuf, Identity)| Identity::of(file).is_ok_and(|now| now == *then);
        self.files.first().is_some_and(|(first, _)| first == document)
            && self.files.iter().all(same)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Instant;

    /// The age of a change was once counted from the beginning of its second: up to a second too long.
    #[test]
    fn the_age_of_a_change_counts_its_nanoseconds() {
        let file = tempfile::NamedTempFile::new().expect("a file");
        let of = Identity::of(file.path()).expect("there");
        let changed = Duration::new(1_000, 900_000_000);
        let at = |changed| Identity { changed, ..of };
        let tick = Duration::from_nanos(1);
        for (changed, looked, is_settled) in [
            ((1_000, 900_000_000), changed, false),
            ((1_000, 900_000_000), Duration::from_secs(1_001) + tick, false),
            ((1_000, 900_000_000), changed + SETTLED, false),
            ((1_000, 900_000_000), changed + SETTLED + tick, true),
            // After it was looked at, by a clock that has jumped.
            ((1_000, 900_000_000), changed - tick, false),
            // Before the epoch.
            ((-1, 900_000_000), changed, false),
            ((i64::MAX, 999_999_999), changed, false),
        ] {
            assert_eq!(at(changed).is_settled(looked), is_settled, "{changed:?} {looked:?}");
        }
    }

    #[test]
    fn a_file_that_was_not_touched_is_not_read_again() {
        let folder = tempfile::tempdir().expect("a folder");
        let cache = Cache::open(folder.path().join("cache"), 1000).expect("opens");
        let file = folder.path().join("map.xodr");
        let part = folder.path().join("part.xodr");
        let hash = || cache.input_hash(&file, folder.path()).expect("hashed");
        let records = || fs::read_dir(cache.folder()).expect("a folder").count();
        let start = Instant::now();
        fs::write(&file, "one").expect("written");
        let HashedInput { hash: first, files } = hash();
        assert_eq!(files, std::slice::from_ref(&file));
        // A machine that stood still for so long says nothing of it.
        assert!(records() == 0 || start.elapsed() > SETTLED, "it has just been written");
        std::thread::sleep(SETTLED + Duration::from_millis(100));
        assert_eq!((hash().hash, records()), (first, 1));
        assert_eq!(hash().hash, first, "known");
        // The record is what is believed, as long as the file is the same.
        let record =
            fs::read_dir(cache.folder()).expect("a folder").flatten().next().expect("one").path();
        let text = fs::read_to_string(&record).expect("readable");
        let mut known: DocumentRecord = serde_json::from_str(&text).expect("JSON");
        known.input = [7; 32];
        fs::write(&record, serde_json::to_vec(&known).expect("JSON")).expect("written");
        assert_eq!(hash().hash.input, [7; 32]);
        // The same size and time of content do not help: the node has another.
        let before = fs::metadata(&file).expect("there").modified().expect("a time");
        fs::write(&file, "two").expect("written");
        fs::File::options()
            .write(true)
            .open(&file)
            .and_then(|f| f.set_modified(before))
            .expect("set");
        let second = hash().hash;
        assert_ne!(second.input, first.input);
        assert_ne!(second.input, [7; 32]);
        // What it includes counts.
        fs::write(&part, "part").expect("written");
        cache
            .remember_includes(
                &Key::of_document(&second.document, folder.path()),
                std::slice::from_ref(&part),
            )
            .expect("kept");
        let HashedInput { hash: third, files } = hash();
        assert_eq!((third.document, files.len()), (second.document, 2));
        assert_ne!(third.input, second.input);
        fs::remove_file(part).expect("removed");
        assert!(cache.input_hash(&file, folder.path()).is_err(), "a part is missing");
        fs::write(record, "nonsense").expect("written");
    }
}
