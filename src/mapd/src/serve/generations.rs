//! Numbers of generations, which rise and never repeat.
//!
//! A number is one more than the last one handed out for the map in this domain. The last one is kept twice: in the domain's
//! root folder, which exists as long as a process of the domain does, and in a folder that survives a restart of the machine, if
//! the daemon has one. If neither has it, the first number is the time in milliseconds. It is larger than every earlier number,
//! because generations come less often than once a millisecond.
//!
//! The clock is read only if no number is kept, so a clock that jumps changes nothing. One case remains: the folders are empty
//! *and* the clock is earlier than the moment at which the lost first number was assigned.

use super::error::ServeError;
use super::notice::Notice;
use crate::clock::since_epoch;
use mapd_transport::{
    Domain, GENERATION_SUFFIX, LARGEST_GENERATION, read_generation, read_generation_file,
    replace_text_durably, write_generation,
};
use std::io;
use std::path::PathBuf;

/// Assigns numbers.
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

    /// Assigns the next number permanently, before a client can see it.
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
        // Nonsense in one place is no reason to serve nothing where the number is known, or can begin anew.
        let known = kept.as_deref().map_or(Ok(0), read_generation_file);
        let known = known.unwrap_or_else(|error| {
            let what = "reading the last generation that the cache folder keeps";
            notify(&Notice::Failed { what: what.to_owned(), error: error.to_string() });
            0
        });
        let here = match read_generation(domain, map) {
            Err(error) if known > 0 => {
                let what = format!("reading {}", path().display());
                notify(&Notice::Failed { what, error: error.to_string() });
                0
            }
            other => other.map_err(ServeError::io(path()))?,
        };
        let last = here.max(known);
        let before = if last == 0 { unix_ms() } else { last };
        if before >= LARGEST_GENERATION {
            let message = format!("generation {before} is the highest possible number");
            return Err(ServeError::io(path())(io::Error::other(message)));
        }
        let next = before + 1;
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

fn kept_file(folder: &std::path::Path, domain: &Domain, map: &str) -> PathBuf {
    folder.join(format!("{}{map}{GENERATION_SUFFIX}", domain.prefix()))
}

fn unix_ms() -> u64 {
    u64::try_from(since_epoch().as_millis()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    /// A domain with a root folder, which is removed at the end.
    struct DomainFolder(Domain);

    impl DomainFolder {
        fn new(name: &str) -> Self {
            let domain = Domain::new(&format!("{name}{}_", std::process::id())).expect("a prefix");
            fs::create_dir_all(domain.root()).expect("a root folder");
            Self(domain)
        }
    }

    impl Drop for DomainFolder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(self.0.root());
        }
    }

    #[test]
    fn numbers_rise_whatever_is_lost() {
        let place = DomainFolder::new("gens");
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
        let place = DomainFolder::new("gensclock");
        let kept = tempfile::tempdir().expect("a folder");
        let mut numbers = Generations::default();
        numbers.keep_in(kept.path().to_owned());
        // Delivered out when the clock was years ahead.
        let ahead = unix_ms() + 100_000_000_000;
        fs::write(kept_file(kept.path(), &place.0, "m"), ahead.to_string()).expect("written");
        assert_eq!(numbers.next(&place.0, "m", &|_| {}).ok(), Some(ahead + 1));
        fs::write(place.0.root().join("m.generation"), LARGEST_GENERATION.to_string())
            .expect("written");
        assert!(
            numbers.next(&place.0, "m", &|_| {}).is_err(),
            "the last number is refused, not repeated"
        );
    }

    /// A number that was never assigned once left room for a single generation.
    #[test]
    fn a_number_that_makes_no_sense_is_not_gone_on_from() {
        let (place, kept) = (DomainFolder::new("gensend"), tempfile::tempdir().expect("a folder"));
        let mut numbers = Generations::default();
        numbers.keep_in(kept.path().to_owned());
        let there = kept_file(kept.path(), &place.0, "m");
        let told = std::cell::Cell::new(0);
        let next = || numbers.next(&place.0, "m", &|_| told.set(told.get() + 1));
        let mut last = 0;
        for nonsense in [(u64::MAX - 1).to_string(), (LARGEST_GENERATION + 1).to_string()] {
            fs::write(&there, nonsense).expect("written");
            let first = next().expect("a number");
            assert!(first > last && first < LARGEST_GENERATION / 2, "{first}");
            last = first;
        }
        fs::remove_file(&there).expect("was there");
        std::os::unix::fs::symlink("/dev/zero", &there).expect("a link");
        assert_eq!(next().ok(), Some(last + 1), "a file without an end is not read");
        assert_eq!(told.get(), 3);
        assert_eq!(fs::read_to_string(&there).expect("a file").trim(), (last + 1).to_string());
    }

    #[test]
    fn without_any_record_the_clock_begins() {
        let place = DomainFolder::new("gensfirst");
        let before = unix_ms();
        let first = Generations::default().next(&place.0, "m", &|_| {}).expect("a number");
        assert!(first > before && first <= unix_ms() + 1);
    }
}
