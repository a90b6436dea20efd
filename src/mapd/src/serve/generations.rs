//! Numbers of generations, which rise and never repeat.
//!
//! The first number that a daemon hands out for a map is above the last one that is known in this domain, and above the time in
//! milliseconds; each further one is one more. The last one is kept twice: in the domain's root folder, which exists as long as a process
//! of the domain does, and in a folder that survives a restart of the machine, if the daemon has one.
//!
//! What is not kept there is not lost: the clock has passed every number that was made of it, because generations come less often than
//! once a millisecond. Only a number that is ahead of the clock, because the clock was set back, has nothing else that vouches for it: where
//! there is such a folder and it cannot be written, that number is not handed out. Against a clock that is set back afterwards, the root
//! folder outlives its last process with the numbers that are nowhere else: those that such a folder did not take, and those that are
//! ahead of the clock.
//!
//! One case remains: both folders are lost, or there is only the first and no process of the domain, *and* the clock is set back
//! to before the last number meanwhile.

use super::error::ServeError;
use super::notice::Notice;
use crate::clock::since_epoch;
use mapd_transport::{
    Domain, GENERATION_SUFFIX, LARGEST_GENERATION, read_generation, read_generation_file,
    replace_text, replace_text_durably, write_generation,
};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// How far a number may be ahead of the clock for the clock to vouch for it: it is waited for. Clocks are set back by less all the
/// time, and several numbers may be handed out within a millisecond \[ms\].
const CLOCK_PATIENCE: u64 = 1000;

/// Suffix of the file that says, in the root folder, that a map's last number is kept nowhere else.
pub(super) const ONLY_HERE_SUFFIX: &str = ".only-here";

/// Assigns numbers.
#[derive(Debug)]
pub(crate) struct Generations {
    /// A folder that outlives the domain.
    folder: Option<PathBuf>,
    /// The last number of each map that this process has handed out.
    handed_out: RefCell<BTreeMap<String, u64>>,
    /// The time \[ms since 1970\].
    clock: fn() -> u64,
}

impl Default for Generations {
    fn default() -> Self {
        Self { folder: None, handed_out: RefCell::default(), clock: unix_ms }
    }
}

impl Generations {
    /// Keeps the last number in a folder that outlives the domain, too.
    pub(crate) fn keep_in(&mut self, folder: PathBuf) {
        self.folder = Some(folder);
    }

    /// Assigns the next number permanently, before a client can see it.
    ///
    /// Errors: the root folder cannot be written; there is no higher number; nothing vouches for the number.
    pub(crate) fn next(
        &self,
        domain: &Domain,
        map: &str,
        notify: &dyn Fn(&Notice),
    ) -> Result<u64, ServeError> {
        let path = || of_map(domain, map, GENERATION_SUFFIX);
        let kept = self.folder.as_ref().map(|folder| kept_file(folder, domain, map));
        // Nonsense in one place is no reason to serve nothing where the number is known, or can begin anew.
        let known = kept.as_deref().map_or(Ok(0), read_generation_file);
        let known = known.unwrap_or_else(|error| {
            let what = "reading the last generation that the cache folder keeps";
            notify(&Notice::Failed { what: what.to_owned(), error: error.to_string() });
            0
        });
        let own = self.handed_out.borrow().get(map).copied();
        let here = match read_generation(domain, map) {
            Err(error) if known.max(own.unwrap_or(0)) > 0 => {
                let what = format!("reading {}", path().display());
                notify(&Notice::Failed { what, error: error.to_string() });
                0
            }
            other => other.map_err(ServeError::io(path()))?,
        };
        let before = here.max(known).max(own.unwrap_or_else(self.clock));
        if before >= LARGEST_GENERATION {
            let message = format!("generation {before} is the highest possible number");
            return Err(ServeError::io(path())(io::Error::other(message)));
        }
        let next = before + 1;
        let only_here = of_map(domain, map, ONLY_HERE_SUFFIX);
        let in_root = |written: io::Result<()>| written.map_err(ServeError::io(domain.root()));
        match kept.map(|file| (replace_text_durably(&file, &next.to_string()), file)) {
            Some((Err(error), file)) => {
                if !self.is_passed(next) {
                    return Err(ServeError::NotKept { next, file, error });
                }
                in_root(replace_text(&only_here, ""))?;
                notify(&Notice::Failed {
                    what: format!("keeping the generation in {}", file.display()),
                    error: error.to_string(),
                });
            }
            Some((Ok(()), _)) => in_root(remove(&only_here))?,
            None => {}
        }
        write_generation(domain, map, next).map_err(ServeError::io(path()))?;
        self.handed_out.borrow_mut().insert(map.to_owned(), next);
        Ok(next)
    }

    /// Whether the clock has passed a number, so that every later one is above it. Waits where that is so in a moment.
    fn is_passed(&self, number: u64) -> bool {
        let ahead = number.saturating_sub((self.clock)());
        if ahead == 0 || ahead > CLOCK_PATIENCE {
            return ahead == 0;
        }
        std::thread::sleep(Duration::from_millis(ahead));
        // It may have been set back meanwhile.
        number <= (self.clock)()
    }

    /// Names of the files that must stay in the root folder after the domain's last process: they have numbers that are nowhere else.
    pub(crate) fn only_here(&self, domain: &Domain) -> Vec<String> {
        let entries = fs::read_dir(domain.root()).into_iter().flatten().flatten();
        let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
        let is_kept = |map: &str, number: u64| {
            let kept = self.folder.as_ref().map(|folder| kept_file(folder, domain, map));
            kept.is_some_and(|file| read_generation_file(&file).is_ok_and(|kept| kept >= number))
        };
        let is_only_here = |map: &str| {
            let number = read_generation(domain, map).unwrap_or(0);
            let is_marked = of_map(domain, map, ONLY_HERE_SUFFIX).exists();
            is_marked || !(is_kept(map, number) || self.is_passed(number))
        };
        let of_one = |name: String| {
            let map = name.strip_suffix(GENERATION_SUFFIX).filter(|map| is_only_here(map))?;
            Some([name.clone(), format!("{map}{ONLY_HERE_SUFFIX}")])
        };
        names.filter_map(of_one).flatten().collect()
    }
}

fn of_map(domain: &Domain, map: &str, suffix: &str) -> PathBuf {
    domain.root().join(format!("{map}{suffix}"))
}

fn remove(file: &Path) -> io::Result<()> {
    match fs::remove_file(file) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

fn kept_file(folder: &Path, domain: &Domain, map: &str) -> PathBuf {
    folder.join(format!("{}{map}{GENERATION_SUFFIX}", domain.prefix()))
}

fn unix_ms() -> u64 {
    u64::try_from(since_epoch().as_millis()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    /// A domain with a root folder, which is removed at the end.
    struct DomainFolder(Domain);

    impl DomainFolder {
        fn new(name: &str) -> Self {
            let domain = Domain::new(&format!("{name}{}_", std::process::id())).expect("a prefix");
            fs::create_dir_all(domain.root()).expect("a root folder");
            Self(domain)
        }
    }

    impl DomainFolder {
        /// As the last process does.
        fn leave(&self, numbers: &Generations) {
            let left = numbers.only_here(&self.0);
            for entry in fs::read_dir(self.0.root()).expect("a folder").flatten() {
                if !left.iter().any(|name| **name == *entry.file_name()) {
                    fs::remove_file(entry.path()).expect("removed");
                }
            }
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

    thread_local! {
        static CLOCK: Cell<u64> = const { Cell::new(0) };
    }

    /// A clock that goes on by a millisecond each time that it is read.
    fn ticking() -> u64 {
        CLOCK.replace(CLOCK.get() + 1)
    }

    fn at(clock: u64) {
        CLOCK.set(clock);
    }

    /// The first of them once wrote to a full cache: its number was in the root folder alone, which went with the process, and the
    /// next daemon gave the same number to another map.
    #[test]
    fn a_number_that_cannot_be_kept_is_never_handed_out_again() {
        let place = DomainFolder::new("gensfull");
        let folder = tempfile::tempdir().expect("a folder");
        let file = kept_file(folder.path(), &place.0, "m");
        fs::write(&file, "1000").expect("written");
        // Where a number is written first lies what is no file: nobody can write it, root neither.
        let in_the_way = file.with_extension("generation.new").join("full");
        fs::create_dir_all(&in_the_way).expect("made");
        // Each time another daemon.
        let numbers = || Generations {
            folder: Some(folder.path().to_owned()),
            clock: ticking,
            ..Generations::default()
        };
        let told = Cell::new(0);
        let next = || numbers().next(&place.0, "m", &|_| told.set(told.get() + 1));
        at(5000);
        assert_eq!(next().ok(), Some(5001), "the clock vouches for it");
        assert!(ticking() >= 5001 && told.get() == 1);
        place.leave(&numbers());
        // Set back between two daemons.
        at(3000);
        let refused = next().expect_err("nothing vouches for 5002").to_string();
        assert!(refused.contains("5002") && refused.contains("gensfull"), "{refused}");
        at(6000);
        assert_eq!(next().ok(), Some(6001));
        // By less than is waited for: several numbers within a millisecond.
        at(6000);
        assert_eq!(next().ok(), Some(6002));
        fs::remove_dir_all(place.0.root()).expect("lost");
        fs::create_dir_all(place.0.root()).expect("made");
        at(7000);
        assert_eq!(next().ok(), Some(7001), "whatever is lost");
        fs::remove_dir_all(in_the_way.parent().expect("a folder")).expect("removed");
        at(2000);
        assert_eq!(next().ok(), Some(7002), "there is room again, and the folder has it");
        place.leave(&numbers());
        assert_eq!(fs::read_dir(place.0.root()).expect("a folder").count(), 0);
        assert_eq!(next().ok(), Some(7003));
        assert_eq!(told.get(), 4);
    }

    #[test]
    fn without_a_folder_a_number_ahead_of_the_clock_outlives_the_domain() {
        let place = DomainFolder::new("gensnofolder");
        let numbers = || Generations { clock: ticking, ..Generations::default() };
        let next = || numbers().next(&place.0, "m", &|_| {}).ok();
        at(9000);
        assert_eq!(next(), Some(9001));
        place.leave(&numbers());
        assert_eq!(fs::read_dir(place.0.root()).expect("a folder").count(), 0, "the clock has it");
        at(9500);
        assert_eq!(next(), Some(9501));
        // While it is served.
        at(4000);
        assert_eq!(next(), Some(9502));
        place.leave(&numbers());
        at(5000);
        assert_eq!(next(), Some(9503));
        at(20_000);
        assert_eq!(next(), Some(20_001));
        place.leave(&numbers());
        assert_eq!(fs::read_dir(place.0.root()).expect("a folder").count(), 0);
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
        let told = Cell::new(0);
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
        let after = next().expect("a file without an end is not read");
        assert!(after > last && told.get() == 3, "{after} after {last}");
        assert_eq!(fs::read_to_string(&there).expect("a file").trim(), after.to_string());
    }

    /// As if somebody had emptied both folders under a daemon, and set the clock back.
    #[test]
    fn a_daemon_knows_its_own_numbers() {
        let place = DomainFolder::new("gensown");
        let numbers = Generations { clock: ticking, ..Generations::default() };
        let next = || numbers.next(&place.0, "m", &|_| {}).ok();
        at(9000);
        assert_eq!(next(), Some(9001));
        fs::remove_file(place.0.root().join("m.generation")).expect("was there");
        at(3000);
        assert_eq!(next(), Some(9002));
    }

    #[test]
    fn without_any_record_the_clock_begins() {
        let place = DomainFolder::new("gensfirst");
        let before = unix_ms();
        let first = Generations::default().next(&place.0, "m", &|_| {}).expect("a number");
        assert!(first > before && first <= unix_ms() + 1);
    }
}
