//! Generations without iceoryx2, where another user holds a name that subscribers need: the daemon makes their segments itself, for observers alone.

use super::loan::random_words;
use super::segment::Segment;
use mapd_transport::{AttachGuard, Domain, SHARED_MEMORY_FOLDER, open_owned};
use std::fs::{self, File};
use std::io;
use std::path::Path;

/// Ending of such a segment, after prefix and a number that nobody can foresee.
const ENDING: &str = ".observers.data";

/// A segment of the daemon's own. Its name goes with the value. Locked as long: one that is not was left by a killed daemon.
pub(crate) struct OwnSegment(Segment);

impl OwnSegment {
    /// Makes one of so many bytes, whose pages are not there yet. Under the attach lock, so that no starting daemon takes it for one that was left.
    ///
    /// Errors: what the system says.
    pub(crate) fn create(
        domain: &Domain,
        length: usize,
        _exclusive: Option<&AttachGuard>,
    ) -> io::Result<Self> {
        let [first, second] = random_words();
        let name = format!("{}{first:016x}{second:016x}{ENDING}", domain.prefix());
        // From here on it is removed again if something fails.
        let made = Self(Segment::create(name, length as u64)?);
        made.0.file().try_lock()?;
        Ok(made)
    }

    /// It.
    pub(crate) fn segment(&self) -> &Segment {
        &self.0
    }

    /// Its file, open for reading and writing.
    pub(crate) fn file(&self) -> &File {
        self.0.file()
    }
}

impl Drop for OwnSegment {
    fn drop(&mut self) {
        // What stays is removed by the next daemon.
        let _ = fs::remove_file(self.0.path());
    }
}

/// Removes those that killed daemons have left; readers keep what they have mapped.
pub(crate) fn remove_left(domain: &Domain, _exclusive: &AttachGuard) {
    for entry in fs::read_dir(SHARED_MEMORY_FOLDER).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let is_one = |name: &str| name.starts_with(domain.prefix()) && name.ends_with(ENDING);
        if !name.to_str().is_some_and(is_one) {
            continue;
        }
        let path = Path::new(SHARED_MEMORY_FOLDER).join(name);
        if open_owned(&path, domain.owner()).is_ok_and(|file| file.try_lock().is_ok()) {
            // Tried again by the next daemon.
            let _ = fs::remove_file(path);
        }
    }
}
