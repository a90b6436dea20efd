//! Following files that a fetcher writes.
//!
//! Looked at a few times a second, as the daemon looks at its sources. A file that cannot be applied is told once, and what it said before stays.

use super::OverlayCommand;
use crate::cache::Identity;
use crate::control::OverlayAction;
use crate::exit::{UsageError, explained};
use crate::printable::printable;
use anyhow::{Result, bail};
use mapd_client::{SIGNATURE_SUFFIX, signature_path};
use mapd_overlay::Document;
use mapd_transport::list_maps;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Time between two looks. A file must have been the same in two of them: its writer has finished then.
const LOOK: Duration = Duration::from_millis(300);

/// Time after which a file that was refused is tried again: what stood in its way, as another feed's entry of the same name, may be gone.
const RETRY: Duration = Duration::from_secs(10);

/// What is followed: a file, or all files of a folder.
struct Followed<'a> {
    path: &'a Path,
    /// What feeds are called: the file, or the folder and the file.
    name: String,
    is_folder: bool,
}

/// A file and its signature: one that comes after its file is a change as well.
#[derive(Clone, Copy, PartialEq, Eq)]
struct FileVersion {
    file: Identity,
    signature: Option<Identity>,
}

/// What a file was applied as.
#[derive(PartialEq, Eq)]
struct Applied {
    version: FileVersion,
    /// The generation that it was matched with.
    generation: Option<u64>,
}

/// Applies what is followed whenever it changes, or the map does. Ends only with the process.
///
/// Errors: the path is stdin, or cannot be named; writing to `out` fails.
pub(super) fn follow(
    command: &OverlayCommand,
    path: &Path,
    tolerance: f64,
    out: &mut dyn Write,
) -> Result<()> {
    let name = path.file_name().and_then(|name| name.to_str());
    let Some(name) = name.filter(|name| *name != "-") else {
        bail!(UsageError(format!(
            "{}: --watch needs a file or folder with a name",
            path.display()
        )));
    };
    let followed = Followed { path, name: name.to_owned(), is_folder: path.is_dir() };
    let domain = command.domain.domain()?;
    let (mut last, mut done) = (BTreeMap::new(), BTreeMap::<PathBuf, Applied>::new());
    let (mut said, mut swept) = (String::new(), None);
    let (mut refused, mut tried) = (BTreeSet::<PathBuf>::new(), Instant::now());
    loop {
        if tried.elapsed() >= RETRY {
            done.retain(|file, _| !refused.contains(file));
            refused.clear();
            tried = Instant::now();
        }
        let now = followed.look();
        let served = list_maps(&domain).ok().and_then(|maps| {
            let own = maps.into_iter().find(|map| map.name == command.name)?;
            Some(own.info?.generation)
        });
        let mut failed = None;
        if now == last {
            let files: BTreeSet<PathBuf> = now.keys().cloned().collect();
            for (file, version) in &now {
                let state = Applied { version: *version, generation: served };
                if done.get(file) == Some(&state) {
                    continue;
                }
                let feed = followed.feed(file);
                // A file that was renamed says what it said, under another name.
                let ended = match followed.is_folder && swept.as_ref() != Some(&files) {
                    true => followed.ended(command, &files),
                    false => Ok(Vec::new()),
                };
                let applied =
                    ended.and_then(|ended| command.apply(file, tolerance, Some(&feed), ended));
                let told = applied.and_then(|applied| Ok(command.tell(file, &applied, out)?));
                match told {
                    Ok(()) => drop(done.insert(file.clone(), state)),
                    Err(error) => {
                        // What is wrong with a file mostly stays so until it changes; a daemon may come back.
                        if error.is::<UsageError>() {
                            done.insert(file.clone(), state);
                            refused.insert(file.clone());
                        }
                        let why = explained(&error);
                        failed = Some(format!("{}: {why}; what it said stays", file.display()));
                    }
                }
            }
            if followed.is_folder && swept.as_ref() != Some(&files) {
                match followed.sweep(command, &files) {
                    Ok(()) => swept = Some(files),
                    Err(error) => {
                        failed = Some(explained(&error));
                        // A daemon that takes only signed entries goes on to refuse it.
                        if error.is::<UsageError>() {
                            swept = Some(files);
                        }
                    }
                }
            }
            out.flush()?;
        }
        if let Some(why) = failed.filter(|why| *why != said) {
            // A closed stderr is nobody's loss.
            let _ = writeln!(io::stderr(), "mapd: {}", printable(&why));
            said = why;
        }
        last = now;
        std::thread::sleep(LOOK);
    }
}

impl Followed<'_> {
    /// The files that are there, and their states.
    fn look(&self) -> BTreeMap<PathBuf, FileVersion> {
        let mut files = vec![self.path.to_owned()];
        if self.is_folder {
            let found = std::fs::read_dir(self.path).into_iter().flatten().flatten();
            // Fetchers write beside the name, under one that begins with a dot, and rename.
            let is_seen = |path: &PathBuf| {
                let name = path.file_name().and_then(|name| name.to_str());
                let is_document =
                    |name: &str| !name.starts_with('.') && !name.ends_with(SIGNATURE_SUFFIX);
                name.is_some_and(is_document) && path.is_file()
            };
            files = found.map(|entry| entry.path()).filter(is_seen).collect();
        }
        let known = |file: PathBuf| {
            let signature = Identity::of(&signature_path(&file)).ok();
            let version = FileVersion { file: Identity::of(&file).ok()?, signature };
            Some((file, version))
        };
        files.into_iter().filter_map(known).collect()
    }

    fn feed(&self, file: &Path) -> String {
        let own = file.file_name().unwrap_or_default().to_string_lossy();
        if self.is_folder { format!("{}/{own}", self.name) } else { self.name.clone() }
    }

    /// Feeds of files that are no longer in the folder.
    fn ended(&self, command: &OverlayCommand, files: &BTreeSet<PathBuf>) -> Result<Vec<String>> {
        let known: BTreeSet<String> = files.iter().map(|file| self.feed(file)).collect();
        let own = format!("{}/", self.name);
        let listed = command.ask(OverlayAction::List)?.entries;
        let feeds: BTreeSet<String> = listed.into_iter().map(|one| one.entry.feed).collect();
        let has_ended = |feed: &String| feed.starts_with(&own) && !known.contains(feed);
        Ok(feeds.into_iter().filter(has_ended).collect())
    }

    /// Removes what files said that are no longer in the folder.
    fn sweep(&self, command: &OverlayCommand, files: &BTreeSet<PathBuf>) -> Result<()> {
        for feed in self.ended(command, files)? {
            let document = Document::default().to_json();
            let (feed, unread, ended) = (Some(feed), Vec::new(), Vec::new());
            command.ask(OverlayAction::Apply { document, feed, unread, ended, signature: None })?;
        }
        Ok(())
    }
}
