//! The reader's side: finding, mapping and following what a record names.

use super::memory::{Record, Refusal, identity, map_segment};
use super::page::{MAGIC, Page};
use super::slot::{SegmentLocation, SlotContent, decode, says_nothing};
use crate::claim::served_by;
use crate::domain::{Domain, SHARED_MEMORY_FOLDER};
use crate::error::AttachError;
use crate::limits::{TRANSPORT_REVISION, check_map_name};
use crate::payload::GenerationInfo;
use crate::pinned::Pinned;
use crate::record::RECORD_SUFFIX;
use crate::room::{Descriptors, descriptors};
use crate::status::alive_maps;
use crate::user::{check_owned_by, not_owned};
use rustix::io::Errno;
use rustix::thread::futex;
use rustix::time::{ClockId, Timespec};
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Longest sleep on a record: a waiting reader checks this often even if a wake-up was lost or delayed by another process.
pub(super) const LOOK: Duration = Duration::from_millis(100);

/// First pause before another attempt where there is nothing to sleep on; doubles up to [`LONGEST_PAUSE`].
const FIRST_PAUSE: Duration = Duration::from_micros(50);

/// Longest such pause.
const LONGEST_PAUSE: Duration = Duration::from_millis(10);

/// Readings of a record in a row, each of which met a publication, or named a file that was gone: a daemon needs a millisecond for each.
pub(super) const READINGS: usize = 64;

/// A heartbeat of this age makes a reader look whether the record is still the one under its name. Daemons beat about once a second.
const SILENCE: Duration = Duration::from_secs(3);

/// Follows one map without writing anything anywhere. `Send` and `Sync`; its methods take a lock for as long as a slot takes to read, about a microsecond, queries on a
/// [`Pinned`] take none. It survives the daemon: what is held stays readable, and generations of a restarted daemon arrive here.
pub struct Observer {
    pub(super) map: String,
    pub(super) domain: Domain,
    pub(super) path: PathBuf,
    /// Whose files are trusted.
    pub(super) owner: u32,
    pub(super) record: Mutex<Option<Arc<Record>>>,
    current: Mutex<Option<Pinned>>,
    /// Sequence of the record when it was last looked at for an overlay; 0 for never.
    pub(super) looked: AtomicU32,
}

/// What one look at the record found.
enum RecordState {
    /// A generation that is newer than was asked for.
    Newer(Pinned),
    /// None, or none that is newer; wait until the record has another sequence.
    Nothing(Arc<Record>, u32),
}

impl Observer {
    /// Finds a map and maps its newest generation. Daemon and client may start in any order: tries again until the deadline while
    /// there is no daemon, no such map, or no generation. Where the daemon was killed, its last generation is found: [`heartbeat_age`] tells.
    ///
    /// Errors: what was missing at the deadline; at once, what no waiting helps against: wrong names, another user's daemon, another release's daemon.
    pub fn connect(domain: &Domain, map: &str, deadline: Instant) -> Result<Self, AttachError> {
        check_map_name(map)?;
        let observer = Self::idle(domain, map);
        observer.wait_newer(0, deadline)?;
        Ok(observer)
    }

    /// One that has not looked yet, of a map whose name is known to be one.
    pub fn idle(domain: &Domain, map: &str) -> Self {
        Self {
            map: map.to_owned(),
            domain: domain.clone(),
            path: domain.map_file(map, RECORD_SUFFIX),
            owner: domain.owner(),
            record: Mutex::default(),
            current: Mutex::default(),
            looked: AtomicU32::new(0),
        }
    }

    /// A generation newer than `than`, if there is one; never waits.
    ///
    /// Errors: files of the domain cannot be used.
    pub fn newer_than(&self, than: u64) -> Result<Option<Pinned>, AttachError> {
        match self.look(than) {
            Ok(RecordState::Newer(pinned)) => Ok(Some(pinned)),
            Ok(RecordState::Nothing(..)) => Ok(None),
            // Root folder or record of a daemon that has ended.
            Err(AttachError::Io { source, .. }) if source.kind() == io::ErrorKind::NotFound => {
                Ok(None)
            }
            Err(error) => Err(error),
        }
    }

    /// Waits for a generation newer than `than`; one that is served already counts. Keeps the deadline even if the daemon has died,
    /// and gets the generation of a restarted one. Several threads may wait.
    ///
    /// Errors: none came in time; files of the domain cannot be used.
    pub fn wait_newer(&self, than: u64, deadline: Instant) -> Result<Pinned, AttachError> {
        let mut pause = FIRST_PAUSE;
        loop {
            let seen = self.look(than);
            let left = deadline.saturating_duration_since(Instant::now());
            match seen {
                Ok(RecordState::Newer(pinned)) => return Ok(pinned),
                Err(error) if !error.may_pass() => return Err(error),
                Err(error) if left.is_zero() && !is_missing(&error) => return Err(error),
                _ if left.is_zero() => return Err(self.why_none(than)),
                Ok(RecordState::Nothing(record, sequence)) => {
                    sleep_on(record.page(), sequence, left.min(LOOK));
                    pause = FIRST_PAUSE;
                }
                Err(_) => {
                    std::thread::sleep(pause.min(left));
                    pause = (pause * 2).min(LONGEST_PAUSE);
                }
            }
        }
    }

    /// Looks once.
    fn look(&self, than: u64) -> Result<RecordState, AttachError> {
        let record = self.record()?;
        let mut gone = 0;
        for _ in 0..READINGS {
            let (sequence, said) = read(&record, &self.domain, &self.map, &self.path)?;
            let SlotContent::Served(info, place) = &*said else {
                return Ok(RecordState::Nothing(record, sequence));
            };
            if info.generation <= than {
                return Ok(RecordState::Nothing(record, sequence));
            }
            let mut current = self.current.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some(pinned) = current.as_ref().filter(|pinned| pinned.info() == info) {
                return Ok(RecordState::Newer(pinned.clone()));
            }
            if let Some(pinned) = open(info, place, self.owner)? {
                *current = Some(pinned.clone());
                return Ok(RecordState::Newer(pinned));
            }
            // A daemon removes a file once the record names another. Where it still names this one, the daemon was killed, and its successor or
            // another daemon of the domain has removed it.
            if std::mem::replace(&mut gone, sequence) == sequence {
                break;
            }
        }
        Ok(RecordState::Nothing(record, gone))
    }

    /// The record under its name: the one that is mapped, unless there is reason to think that another has taken its place.
    pub(super) fn record(&self) -> Result<Arc<Record>, AttachError> {
        let mut mapped = self.record.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(record) = mapped.as_ref()
            && (!is_left(record.page()) || is_named(record, &self.path))
        {
            return Ok(record.clone());
        }
        *mapped = None;
        let record = Arc::new(open_record(&self.domain, &self.path, self.owner)?);
        *mapped = Some(record.clone());
        Ok(record)
    }

    /// Why no generation was found.
    fn why_none(&self, than: u64) -> AttachError {
        let (map, newer_than) = (self.map.clone(), than);
        match served_by(&self.domain, &self.map) {
            Some(_) => AttachError::NoGeneration { map, newer_than, daemon_alive: true },
            None if than > 0 => AttachError::NoGeneration { map, newer_than, daemon_alive: false },
            None => match alive_maps(&self.domain) {
                maps if maps.is_empty() => {
                    AttachError::NoDaemon { map, root: self.domain.root().to_owned() }
                }
                available => AttachError::NoSuchMap { map, available },
            },
        }
    }
}

/// Maps what a record names; `None` if it is gone.
fn open(
    info: &GenerationInfo,
    place: &SegmentLocation,
    owner: u32,
) -> Result<Option<Pinned>, AttachError> {
    let path = Path::new(SHARED_MEMORY_FOLDER).join(&place.segment);
    match map_segment(&path, place.inode, place.offset + info.length, owner) {
        Ok(mapping) => Ok(Some(Pinned::of_segment(mapping, place.offset, *info))),
        Err(Refusal::Io(error)) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(refusal) => Err(refused(&path, refusal, owner)),
    }
}

pub(super) fn refused(path: &Path, refusal: Refusal, owner: u32) -> AttachError {
    match refusal {
        Refusal::OtherOwner(found) => not_owned(path, found, owner),
        Refusal::LockLimit(needed) => AttachError::LockLimit { path: path.to_owned(), needed },
        Refusal::Io(error) if error.kind() == io::ErrorKind::PermissionDenied => {
            AttachError::NotShared { path: path.to_owned() }
        }
        Refusal::Io(error) if error.kind() == io::ErrorKind::InvalidData => {
            AttachError::Record { path: path.to_owned(), why: error.to_string() }
        }
        Refusal::Io(error) => match descriptors() {
            Some(Descriptors { left, limit })
                if error.raw_os_error() == Some(Errno::MFILE.raw_os_error()) =>
            {
                AttachError::NoDescriptors { left, limit }
            }
            _ => AttachError::io(path, error),
        },
    }
}

/// Opens a record, in a root folder of the same owner.
fn open_record(domain: &Domain, path: &Path, owner: u32) -> Result<Record, AttachError> {
    check_owned_by(domain, owner)?;
    Record::open(path, owner).map_err(|refusal| refused(path, refusal, owner))
}

/// What a record says now, and its sequence.
///
/// Errors: it is none, or damaged.
pub(super) fn read(
    record: &Record,
    domain: &Domain,
    map: &str,
    path: &Path,
) -> Result<(u32, Arc<SlotContent>), AttachError> {
    let page = record.page();
    let refused = |why: &str| AttachError::Record { path: path.to_owned(), why: why.to_owned() };
    if page.magic.load(Ordering::Acquire) != MAGIC {
        return Err(refused("its first bytes are those of something else"));
    }
    let revision = page.revision.load(Ordering::Relaxed);
    if revision != TRANSPORT_REVISION {
        return Err(AttachError::WrongTransport {
            map: map.to_owned(),
            found: revision.to_string(),
        });
    }
    let mut last = record.last.lock().unwrap_or_else(PoisonError::into_inner);
    let sequence = page.sequence.load(Ordering::Acquire);
    if let Some((known, said)) = last.as_ref()
        && *known == sequence
    {
        // The slot that holds is never written.
        return Ok((sequence, said.clone()));
    }
    let whole = || (0..READINGS).find_map(|_| page.read());
    let (sequence, words) = whole().ok_or_else(|| refused("it does not come to rest"))?;
    let said = Arc::new(decode(sequence, &words, domain.prefix()).map_err(refused)?);
    *last = Some((sequence, said.clone()));
    Ok((sequence, said))
}

/// Whether the daemon may have left this record for another.
fn is_left(page: &Page) -> bool {
    let closed = || page.read().is_some_and(|(_, words)| says_nothing(&words));
    age(page).is_none_or(|age| age > SILENCE) || closed()
}

/// Whether a record is the one that has the name.
pub(super) fn is_named(record: &Record, path: &Path) -> bool {
    rustix::fs::lstat(path).is_ok_and(|stat| identity(&stat) == record.identity)
}

/// Whether it was simply not there.
fn is_missing(error: &AttachError) -> bool {
    matches!(error, AttachError::Io { source, .. } if source.kind() == io::ErrorKind::NotFound)
}

/// Sleeps until the record has another sequence, at most `longest`.
pub(super) fn sleep_on(page: &Page, sequence: u32, longest: Duration) {
    let longest = Timespec {
        tv_sec: longest.as_secs().try_into().unwrap_or(i64::MAX),
        tv_nsec: longest.subsec_nanos().into(),
    };
    match futex::wait(&page.sequence, futex::Flags::empty(), sequence, Some(&longest)) {
        // Woken, too late to sleep, slept enough, or interrupted: the caller looks again.
        Ok(()) | Err(Errno::AGAIN | Errno::TIMEDOUT | Errno::INTR) => {}
        // A system without futexes on such files: looking is all there is.
        Err(_) => std::thread::sleep(LONGEST_PAUSE.min(LOOK)),
    }
}

/// Nanoseconds of the monotonic clock, which all processes of a machine share.
pub(super) fn monotonic_ns() -> u64 {
    let now = rustix::time::clock_gettime(ClockId::Monotonic);
    let seconds = u64::try_from(now.tv_sec).unwrap_or(0);
    seconds.saturating_mul(1_000_000_000).saturating_add(now.tv_nsec.unsigned_abs())
}

/// How long ago the daemon last said that it lives; `None` if it never has.
fn age(page: &Page) -> Option<Duration> {
    let beat = page.heartbeat.load(Ordering::Relaxed);
    (beat != 0).then(|| Duration::from_nanos(monotonic_ns().saturating_sub(beat)))
}

/// How long ago the daemon of a map last said that it lives; `None` if the map has no record.
pub fn heartbeat_age(domain: &Domain, map: &str) -> Option<Duration> {
    let record = Record::open(&domain.map_file(map, RECORD_SUFFIX), domain.owner()).ok()?;
    age(record.page())
}

/// Process id of the daemon that serves a map, by its heartbeat alone: for processes that may not examine its lock.
pub(crate) fn daemon_heard(domain: &Domain, map: &str) -> Option<u32> {
    heartbeat_age(domain, map).filter(|age| *age <= SILENCE)?;
    Some(published(domain, map).map_or(0, |info| u32::try_from(info.daemon_pid).unwrap_or(0)))
}

/// What was published last, and the revision of the transport of who did; `None` if nothing is served, or the record is damaged.
pub(crate) fn published(domain: &Domain, map: &str) -> Option<GenerationInfo> {
    let path = domain.map_file(map, RECORD_SUFFIX);
    let record = Record::open(&path, domain.owner()).ok()?;
    match &*read(&record, domain, map, &path).ok()?.1 {
        SlotContent::Served(info, _) => Some(*info),
        SlotContent::Nothing => None,
    }
}

/// The revision of the transport that a map's record has; `None` if there is no record.
pub fn revision_of(domain: &Domain, map: &str) -> Option<u32> {
    let record = Record::open(&domain.map_file(map, RECORD_SUFFIX), domain.owner()).ok()?;
    let page = record.page();
    (page.magic.load(Ordering::Acquire) == MAGIC).then(|| page.revision.load(Ordering::Relaxed))
}

impl fmt::Debug for Observer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Observer")
            .field("map", &self.map)
            .field("domain", &self.domain)
            .finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::super::RecordWriter;
    use super::*;
    use crate::share::Share;

    fn served(generation: u64) -> (GenerationInfo, SegmentLocation) {
        let info = GenerationInfo { generation, length: 1, ..GenerationInfo::default() };
        (info, SegmentLocation { segment: "mapd_x".to_owned(), inode: 1, offset: 0, overlay: None })
    }

    /// A domain with a root folder, which is removed at the end.
    struct Folder(Domain);

    impl Folder {
        fn new(name: &str) -> Self {
            let domain = Domain::new(&format!("{name}{}_", std::process::id())).expect("a prefix");
            std::fs::create_dir_all(domain.root()).expect("a root folder");
            Self(domain)
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(self.0.root());
        }
    }

    /// A reader that sleeps without a deadline would sleep forever if no process woke it.
    #[test]
    fn who_sleeps_is_woken() {
        let folder = Folder::new("recordwake");
        let mut writer = RecordWriter::open(&folder.0, "m", Share::Private).expect("a record");
        let path = folder.0.map_file("m", RECORD_SUFFIX);
        for generation in 1..20 {
            let record = open_record(&folder.0, &path, rustix::process::geteuid().as_raw());
            let record = record.expect("opens");
            let before = record.page().sequence.load(Ordering::Relaxed);
            std::thread::scope(|scope| {
                let sleeper = scope.spawn(|| {
                    while record.page().sequence.load(Ordering::Relaxed) == before {
                        sleep_on(record.page(), before, Duration::from_secs(3600));
                    }
                });
                std::thread::sleep(Duration::from_millis(generation % 4));
                let (info, place) = served(generation);
                let prepared = writer.prepare(&info, &place).expect("can be said");
                writer.hold(prepared);
                sleeper.join().expect("woken");
            });
        }
        writer.close().expect("removed");
        assert!(!path.exists());
    }

    /// The page that a killed daemon left is gone on with, so that readers that wait on it are woken by its successor; one that is damaged, or of another
    /// release, is not.
    #[test]
    fn a_record_is_gone_on_with() {
        let folder = Folder::new("recordreuse");
        let path = folder.0.map_file("m", RECORD_SUFFIX);
        let owner = rustix::process::geteuid().as_raw();
        let open = || open_record(&folder.0, &path, owner).expect("opens");
        let publish = |generation| {
            let mut writer = RecordWriter::open(&folder.0, "m", Share::Private).expect("a record");
            let (info, place) = served(generation);
            let prepared = writer.prepare(&info, &place).expect("can be said");
            writer.hold(prepared);
            // A slot that is prepared but not current is not visible to readers.
            let (info, place) = served(generation + 1);
            let _ = writer.prepare(&info, &place).expect("can be said");
        };
        publish(1);
        let first = open();
        publish(2);
        assert!(first.identity == open().identity);
        let domain = Domain::new("mapd_").expect("a prefix");
        let (sequence, said) = read(&first, &domain, "m", &path).expect("whole");
        let (info, place) = served(2);
        assert_eq!((sequence, &*said), (2, &SlotContent::Served(info, place)));
        std::fs::write(&path, "revision 2\ngeneration 7\n").expect("written");
        publish(3);
        assert!(first.identity != open().identity);
        assert!(!is_named(&first, &path) && is_named(&open(), &path));
        assert_eq!(published(&folder.0, "m"), None, "its segment is one of another domain");
    }

    /// Whatever becomes of the page, the next publication has one that readers find; who waited on the page before finds it as well. A damaged page
    /// once kept every newcomer out for as long as its daemon ran, which said that all was well.
    #[test]
    fn a_page_that_readers_cannot_use_is_made_anew() {
        type Case<'a> = (&'a str, &'a dyn Fn(&Path));
        let over = |path: &Path, at: u64, bytes: &[u8]| {
            use std::os::unix::fs::FileExt;
            let file = std::fs::File::options().write(true).open(path).expect("opens");
            file.write_all_at(bytes, at).expect("written");
        };
        let cases: [Case<'_>; 6] = [
            ("nothing happens", &|_| {}),
            ("noise at its beginning", &|path| over(path, 0, b"garbage")),
            ("another sequence", &|path| over(path, 12, &[77])),
            ("the slot that holds is damaged", &|path| over(path, 24 + 8 * 55 + 16, &[0xff; 9])),
            ("no name", &|path| std::fs::remove_file(path).expect("removed")),
            ("another file has the name", &|path| {
                std::fs::rename(path, path.with_extension("aside")).expect("renamed");
                std::fs::write(path, "garbage").expect("written");
            }),
        ];
        let owner = rustix::process::geteuid().as_raw();
        let domain = Domain::new("mapd_").expect("a prefix");
        for (case, (name, damage)) in cases.into_iter().enumerate() {
            let folder = Folder::new(&format!("recmend{case}"));
            let path = folder.0.map_file("m", RECORD_SUFFIX);
            let mut writer = RecordWriter::open(&folder.0, "m", Share::Private).expect("a record");
            let mut publish = |generation| {
                let (info, place) = served(generation);
                let prepared = writer.prepare(&info, &place).expect("can be said");
                let meanwhile = open_record(&folder.0, &path, owner).expect("opens");
                let (_, said) = read(&meanwhile, &domain, "m", &path).expect("whole");
                writer.hold(prepared);
                said
            };
            publish(1);
            let left = open_record(&folder.0, &path, owner).expect("opens");
            damage(&path);
            let (before, place) = served(1);
            assert_eq!(*publish(2), SlotContent::Served(before, place), "{name}: meanwhile");
            let new = open_record(&folder.0, &path, owner).expect("opens");
            let (sequence, said) = read(&new, &domain, "m", &path).expect("whole");
            let (info, place) = served(2);
            assert_eq!(*said, SlotContent::Served(info, place), "{name}");
            assert!(sequence > 1, "{name}: {sequence}");
            let is_same = new.identity == left.identity;
            assert_eq!(is_same, case == 0, "{name}");
            assert!(is_same || is_left(left.page()), "{name}: its readers stay on it");
            assert!(!is_left(new.page()), "{name}: its heart beats");
        }
    }

    #[test]
    fn what_a_record_says_is_worked_out_once_for_each_sequence() {
        let folder = Folder::new("recordonce");
        let mut writer = RecordWriter::open(&folder.0, "m", Share::Private).expect("a record");
        let path = folder.0.map_file("m", RECORD_SUFFIX);
        let owner = rustix::process::geteuid().as_raw();
        let record = open_record(&folder.0, &path, owner).expect("opens");
        let domain = Domain::new("mapd_").expect("a prefix");
        for generation in 1..4 {
            let (info, place) = served(generation);
            let prepared = writer.prepare(&info, &place).expect("can be said");
            writer.hold(prepared);
            let [first, second] =
                [(); 2].map(|()| read(&record, &domain, "m", &path).expect("whole"));
            assert_eq!((first.0, &*first.1), (second.0, &SlotContent::Served(info, place)));
            assert!(Arc::ptr_eq(&first.1, &second.1));
        }
    }

    #[test]
    fn threads_may_share_them() {
        fn shared<T: Send + Sync>() {}
        shared::<Observer>();
        shared::<RecordWriter>();
    }
}
