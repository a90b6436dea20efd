//! Noticing that a map's files have changed.
//!
//! The thread looks at the files' identity, size and times a few times a second. That costs microseconds, and sees what
//! notifications of the kernel do not: files on network and overlay file systems, behind symbolic links that are turned to
//! another folder, on volumes that are mounted anew, and includes that were not known before.

use super::child::{OtherFiles, Refusal};
use super::orders::{Change, Order, Orders};
use crate::cache::Identity;
use crate::control::Trigger;
use std::collections::BTreeMap;
use std::io;
use std::path::PathBuf;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Time between two looks.
const LOOK: Duration = Duration::from_millis(100);

/// Files must have been the same for so long before they are read: a process that writes several of them, or one in place, has
/// finished then.
const QUIET: Duration = Duration::from_millis(400);

/// A file that has been gone for so long is not being replaced: reading a map's own fails, which is told; without an included one there may be less of the
/// map, so that is told, and the map is not read.
const GONE: Duration = Duration::from_secs(3);

/// A state of several files; `None`: one that is not there.
pub(crate) type Identities = Vec<Option<Identity>>;

/// The state of files now.
pub(crate) fn identities(files: &[PathBuf]) -> Identities {
    files.iter().map(|file| Identity::of(file).ok()).collect()
}

/// A map's files as they were last read.
pub(crate) struct Watched {
    pub(crate) files: Vec<PathBuf>,
    pub(crate) read: Identities,
    pub(crate) stage: bool,
}

/// The files of all watched maps. The thread that serves writes down what it has read.
pub(crate) type WatchList = Arc<Mutex<BTreeMap<String, Watched>>>;

/// What else may mend a map that was rejected is watched besides what it was made of before: with it the map may be accepted.
pub(crate) fn watch_more(list: &WatchList, map: &str, refusal: &Refusal) {
    let Some(OtherFiles { included, missing }) = refusal.other_files() else { return };
    let mut list = list.lock().unwrap_or_else(PoisonError::into_inner);
    let Some(watched) = list.get_mut(map) else { return };
    // One that was missing was not there, whether or not it has come since.
    let included = included.iter().map(|file| (file, Identity::of(file).ok()));
    let missing = missing.iter().map(|file| (file, None));
    for (file, read) in included.chain(missing) {
        if !watched.files.contains(file) {
            watched.files.push(file.clone());
            watched.read.push(read);
        }
    }
}

/// Watches in a thread of its own, which dropping ends.
pub(crate) struct Watcher {
    stop: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Watcher {
    /// Errors: no thread can be had.
    pub(crate) fn start(list: WatchList, orders: Orders) -> io::Result<Self> {
        let (stop, stopped) = channel::<()>();
        let work = move || {
            let mut changed = BTreeMap::new();
            while stopped.recv_timeout(LOOK) == Err(RecvTimeoutError::Timeout) {
                let now = Instant::now();
                for (map, settled) in settled(&list, &mut changed, now) {
                    let stage = match settled {
                        Settled::Changed { stage } => stage,
                        Settled::Gone { included } => {
                            let file = included.display();
                            tracing::warn!(map, file = %file, "map {map}: {file}, which it includes, is gone: the map is read again when it is back");
                            continue;
                        }
                    };
                    let trigger = Trigger::Watch;
                    let change = Change { map, trigger, stage, begun: now, reply: None };
                    if !orders.give(Order::Change(change)) {
                        return;
                    }
                }
            }
        };
        let thread = std::thread::Builder::new().name("watch".to_owned()).spawn(work)?;
        Ok(Self { stop: Some(stop), thread: Some(thread) })
    }
}

impl Drop for Watcher {
    fn drop(&mut self) {
        self.stop = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// What has become of a map's files.
#[derive(Debug, PartialEq)]
enum Settled {
    /// They are to be read, though the map's own may be gone; `stage` is that of [`Watched`].
    Changed { stage: bool },
    /// A file that the map includes stays away.
    Gone { included: PathBuf },
}

/// A state of a map's files that is not the one that was read.
struct Changed {
    seen: Identities,
    since: Instant,
    /// Whether it has been told.
    told: bool,
}

/// Maps whose files have changed and have been as they are for a while. Each change is told once.
fn settled(
    list: &WatchList,
    changed: &mut BTreeMap<String, Changed>,
    now: Instant,
) -> Vec<(String, Settled)> {
    let mut settled = Vec::new();
    for (map, watched) in list.lock().unwrap_or_else(PoisonError::into_inner).iter_mut() {
        let seen = identities(&watched.files);
        if seen == watched.read {
            changed.remove(map);
            continue;
        }
        // A file that is being replaced may be gone for a moment.
        let is_gone = |(read, seen): (&Option<_>, &Option<_>)| read.is_some() && seen.is_none();
        let gone = watched.read.iter().zip(&seen).position(is_gone);
        let included = gone.filter(|file| *file > 0).and_then(|file| watched.files.get(file));
        let Some(own) = changed.get_mut(map).filter(|own| own.seen == seen) else {
            changed.insert(map.clone(), Changed { seen, since: now, told: false });
            continue;
        };
        let quiet = if gone.is_some() { GONE } else { QUIET };
        if own.told || now.duration_since(own.since) < quiet {
            continue;
        }
        own.told = true;
        let what = match included {
            Some(included) => Settled::Gone { included: included.clone() },
            None => {
                watched.read = seen;
                Settled::Changed { stage: watched.stage }
            }
        };
        settled.push((map.clone(), what));
    }
    settled
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn a_change_is_told_once_when_it_has_settled() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("m.xodr");
        fs::write(&file, "one").expect("written");
        let files = vec![file.clone()];
        let watched = Watched { read: identities(&files), files, stage: false };
        let list = Arc::new(Mutex::new(BTreeMap::from([("m".to_owned(), watched)])));
        let (mut changed, start) = (BTreeMap::new(), Instant::now());
        let mut look =
            |ms: u64| settled(&list, &mut changed, start + Duration::from_millis(ms)).len();
        assert_eq!(look(0) + look(1000), 0, "nothing has changed");
        fs::write(&file, "two!").expect("written");
        assert_eq!(look(2000), 0, "it may still be written");
        fs::write(&file, "three").expect("written");
        assert_eq!(look(2300) + look(2600), 0, "it was");
        assert_eq!(look(2800), 1);
        assert_eq!(look(2900) + look(9000), 0, "it has been told");
        fs::rename(&file, folder.path().join("away")).expect("renamed");
        assert_eq!(look(10_000) + look(12_900), 0, "it may come back");
        assert_eq!(look(13_000), 1, "it is not replaced, and that is told");
        assert_eq!(look(13_100) + look(20_000), 0, "once");
        fs::write(folder.path().join("new"), "four").expect("written");
        fs::rename(folder.path().join("new"), &file).expect("renamed");
        assert_eq!(look(30_000) + look(30_500), 1);
    }

    /// Nothing said that a map is not read again while a file that it includes is gone.
    #[test]
    fn an_included_file_that_stays_away_is_told_once_and_not_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let files = ["m.xodr", "part.xml"].map(|name| folder.path().join(name));
        let write =
            |text: &str| files.each_ref().map(|file| fs::write(file, text).expect("written"));
        write("one");
        let watched = Watched { read: identities(&files), files: files.to_vec(), stage: false };
        let list = Arc::new(Mutex::new(BTreeMap::from([("m".to_owned(), watched)])));
        let (mut changed, start) = (BTreeMap::new(), Instant::now());
        let mut look = |ms: u64| settled(&list, &mut changed, start + Duration::from_millis(ms));
        fs::remove_file(&files[1]).expect("removed");
        assert_eq!([look(0), look(2_900)], [[], []], "it may come back");
        let gone = Settled::Gone { included: files[1].clone() };
        assert_eq!(look(3_000), [("m".to_owned(), gone)]);
        assert_eq!([look(3_100), look(60_000)], [[], []]);
        write("other");
        assert_eq!(look(61_000), []);
        assert_eq!(look(61_400), [("m".to_owned(), Settled::Changed { stage: false })]);
        assert_eq!(look(70_000), []);
    }
}
