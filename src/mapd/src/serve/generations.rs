//! Numbers of generations, which rise and never repeat.
//!
//! A number is one more than the last one handed out for the map in this domain. The last one is kept twice: in the domain's
//! root folder, which lives as long as anybody of the domain does, and in a folder that outlives the machine's restart, if
//! the daemon has one. Where neither knows, the first number is the time in milliseconds: beyond every number handed out
//! before, as generations come less often than once a millisecond.
//!
//! The clock is asked only where nothing is kept, so that one that jumps, in either direction, changes nothing. What is left:
//! the folders are empty *and* the clock stands before the moment when the lost first number was handed out.

use super::error::ServeError;
use super::notice::Notice;
use crate::clock::since_epoch;
use mapd_client::transport::{
    Domain, GENERATION_SUFFIX, read_generation, replace_text_durably, write_generation,
};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Hands out numbers.
#[derive(Debug, Default)]
pub(crate) struct Generations {
    /// A folder that outlives the domain.
    folder: Option<PathBuf>,
}

impl Generations {
    /// Keeps the last number in a folder that outlives the domain, too.
    pub(crate) fn keep_in(&mut self, folder: PathBuf) {
        self.folder = Some(folder);
    }

    /// Hands out the next number, for good, before anyone can see it.
    ///
    /// Errors: the root folder cannot be written; there is no higher number.
    pub(crate) fn next(
        &self,
        domain: &Domain,
        map: &str,
        notify: &dyn Fn(&Notice),
    ) -> Result<u64, ServeError> {
        let path = || domain.root().join(format!("{map}{GENERATION_SUFFIX}"));
        let kept = self.folder.as_ref().map(|folder| kept_file(folder, domain, map));
        let known = kept.as_deref().map_or(0, read_kept);
        let here = match read_generation(domain, map) {
            // Nonsense here is no reason to serve nothing where the number is known.
            Err(error) if error.kind() == io::ErrorKind::InvalidData && known > 0 => 0,
            other => other.map_err(ServeError::io(path()))?,
        };
        let last = here.max(known);
        let before = if last == 0 { unix_ms() } else { last };
        let next = before.checked_add(1).ok_or(io::ErrorKind::InvalidData.into());
        let next = next.map_err(ServeError::io(path()))?;
        write_generation(domain, map, next).map_err(ServeError::io(path()))?;
        if let Some(file) = kept
            && let Err(error) = replace_text_durably(&file, &next.to_string())
        {
            // The domain knows it; after its end the clock does.
            notify(&Notice::Failed {
                what: format!("keeping the generation in {}", file.display()),
                error: error.to_string(),
            });
        }
        Ok(next)
    }
}

fn kept_file(folder: &Path, domain: &Domain, map: &str) -> PathBuf {
    folder.join(format!("{}{map}{GENERATION_SUFFIX}", domain.prefix()))
}

/// What is kept; 0 where nothing that makes sense is.
fn read_kept(file: &Path) -> u64 {
    fs::read_to_string(file).ok().and_then(|text| text.trim().parse().ok()).unwrap_or(0)
}

fn unix_ms() -> u64 {
    u64::try_from(since_epoch().as_millis()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A domain with a root folder, which is removed at the end.
    struct Place(Domain);

    impl Place {
        fn new(name: &str) -> Self {
            let domain = Domain::new(&format!("{name}{}_", std::process::id())).expect("a prefix");
            fs::create_dir_all(domain.root()).expect("a root folder");
            Self(domain)
        }
    }

    impl Drop for Place {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(self.0.root());
        }
    }

    #[test]
    fn numbers_rise_whatever_is_lost() {
        let place = Place::new("gens");
        let kept = tempfile::tempdir().expect("a folder");
        let mut numbers = Generations::default();
        numbers.keep_in(kept.path().to_owned());
        let here = place.0.root().join("m.generation");
        let there = kept_file(kept.path(), &place.0, "m");
        let mut last = 0;
        for round in 0..64_u32 {
            // Each of the records is lost, or made nonsense, now and then.
            if round % 4 == 1 {
                fs::remove_file(&here).expect("was there");
            }
            if round % 4 == 2 {
                fs::remove_file(&there).expect("was there");
            }
            if round % 4 == 3 {
                fs::write(&there, "cut off").expect("written");
            }
            let next = numbers.next(&place.0, "m", &|_| {}).expect("a number");
            assert!(next > last, "{next} after {last}");
            last = next;
        }
    }

    #[test]
    fn a_clock_that_was_ahead_does_not_matter() {
        let place = Place::new("gensclock");
        let kept = tempfile::tempdir().expect("a folder");
        let mut numbers = Generations::default();
        numbers.keep_in(kept.path().to_owned());
        // Handed out when the clock was years ahead.
        let ahead = unix_ms() + 100_000_000_000;
        fs::write(kept_file(kept.path(), &place.0, "m"), ahead.to_string()).expect("written");
        assert_eq!(numbers.next(&place.0, "m", &|_| {}).ok(), Some(ahead + 1));
        fs::write(place.0.root().join("m.generation"), u64::MAX.to_string()).expect("written");
        assert!(
            numbers.next(&place.0, "m", &|_| {}).is_err(),
            "the last number is refused, not repeated"
        );
    }

    #[test]
    fn without_any_record_the_clock_begins() {
        let place = Place::new("gensfirst");
        let before = unix_ms();
        let first = Generations::default().next(&place.0, "m", &|_| {}).expect("a number");
        assert!(first > before && first <= unix_ms() + 1);
    }
}
