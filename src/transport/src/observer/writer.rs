//! The daemon's side of a record.

use super::memory::{Record, Refusal, open_own};
use super::page::{MAGIC, PAGE_BYTES, Page, Words};
use super::reader::{is_named, monotonic_ns};
use super::slot::{SegmentLocation, SlotContent, decode, encode};
use crate::domain::Domain;
use crate::limits::TRANSPORT_REVISION;
use crate::payload::GenerationInfo;
use crate::record::{RECORD_SUFFIX, create_anew, remove_text, unfinished};
use crate::share::Share;
use rustix::fs::FallocateFlags;
use rustix::thread::futex;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

/// The record of a map, written by the daemon that has claimed it. Dropping it leaves it as it is; [`RecordWriter::close`] removes it.
pub struct RecordWriter {
    record: Record,
    path: PathBuf,
    share: Share,
    /// What the page says, and under which sequence.
    said: (u32, SlotContent),
}

/// What will be said once the generation is sent.
#[must_use = "says nothing before it holds"]
#[derive(Debug)]
pub struct Prepared {
    sequence: u32,
    said: SlotContent,
}

impl RecordWriter {
    /// Goes on with the record that a killed daemon left, else makes a new one, whose page is there for good: writing it never fails.
    ///
    /// Errors: what the system says; no room; a group that this user is not in.
    pub fn open(domain: &Domain, map: &str, share: Share) -> io::Result<Self> {
        let path = domain.map_file(map, RECORD_SUFFIX);
        let us = rustix::process::geteuid().as_raw();
        let record = match open_own(&path, us, share) {
            Ok(record) if is_ours(record.page()) => record,
            // None, one of another release, or one that is damaged: a reader that waits on it finds by the name that another has taken its place.
            _ => {
                create(&path, share, None)?;
                open_own(&path, us, share).map_err(as_io)?
            }
        };
        let said = says(record.page()).unwrap_or((0, SlotContent::Nothing));
        let writer = Self { record, path, share, said };
        writer.beat();
        Ok(writer)
    }

    /// Writes what is to be served without making it visible to readers. A page that is damaged, or has lost its name, is made anew first.
    ///
    /// Errors: what cannot be said: a segment's name that is too long, or not plain; no page can be made.
    pub fn prepare(
        &mut self,
        info: &GenerationInfo,
        place: &SegmentLocation,
    ) -> io::Result<Prepared> {
        self.mend()?;
        self.write(SlotContent::Served(*info, place.clone()))
    }

    /// Has what was prepared hold, and wakes those who wait. Call it between sending the generation and dropping the publisher before.
    pub fn hold(&mut self, prepared: Prepared) {
        hold(self.page(), prepared.sequence);
        self.said = (prepared.sequence, prepared.said);
        self.beat();
    }

    /// Says that the daemon lives.
    pub fn beat(&self) {
        self.page().heartbeat.store(monotonic_ns(), Ordering::Relaxed);
    }

    /// Says that nothing is served any more, wakes those who wait, and removes the record.
    ///
    /// Errors: what the system says; by then readers know.
    pub fn close(mut self) -> io::Result<()> {
        let prepared = self.write(SlotContent::Nothing)?;
        self.hold(prepared);
        remove_text(&self.path)
    }

    fn write(&self, said: SlotContent) -> io::Result<Prepared> {
        let sequence = write(self.page(), &said)?;
        Ok(Prepared { sequence, said })
    }

    /// Where readers would not find in the folder what this page was last made to say, makes another that says it, whole before it has the name.
    /// Then the page before is closed, so that who waits on it goes on to the one that has the name.
    fn mend(&mut self) -> io::Result<()> {
        let page = self.page();
        if is_ours(page)
            && says(page).as_ref() == Some(&self.said)
            && is_named(&self.record, &self.path)
        {
            return Ok(());
        }
        // What readers have seen of the page before, they have seen under another sequence.
        let sequence = Page::next(self.said.0);
        create(&self.path, self.share, Some((sequence, &words(sequence, &self.said.1)?)))?;
        let us = rustix::process::geteuid().as_raw();
        let new = open_own(&self.path, us, self.share).map_err(as_io)?;
        let left = std::mem::replace(&mut self.record, new);
        self.said.0 = sequence;
        self.beat();
        hold(left.page(), write(left.page(), &SlotContent::Nothing)?);
        Ok(())
    }

    fn page(&self) -> &Page {
        self.record.page()
    }
}

/// Of a file that this user has just made.
fn as_io(refusal: Refusal) -> io::Error {
    match refusal {
        Refusal::Io(error) => error,
        Refusal::OtherOwner(_) => io::ErrorKind::PermissionDenied.into(),
        Refusal::LockLimit(_) => io::ErrorKind::OutOfMemory.into(),
    }
}

/// What a page says, and its sequence; none if the slot that holds is damaged. Nobody else writes it meanwhile.
fn says(page: &Page) -> Option<(u32, SlotContent)> {
    let (sequence, words) = page.read()?;
    Some((sequence, decode(sequence, &words, "").ok()?))
}

fn words(sequence: u32, said: &SlotContent) -> io::Result<Words> {
    encode(sequence, said).map_err(|why| io::Error::new(io::ErrorKind::InvalidInput, why))
}

/// Writes the slot that does not hold; the sequence under which it will.
fn write(page: &Page, said: &SlotContent) -> io::Result<u32> {
    let next = Page::next(page.sequence.load(Ordering::Relaxed));
    page.write(next, &words(next, said)?);
    Ok(next)
}

/// Has a slot hold, and wakes those who wait.
fn hold(page: &Page, sequence: u32) {
    page.hold(sequence);
    // Fails for no word that is mapped; a reader that is not woken looks by itself.
    let _ = futex::wake(&page.sequence, futex::Flags::empty(), i32::MAX as u32);
}

fn is_ours(page: &Page) -> bool {
    page.magic.load(Ordering::Relaxed) == MAGIC
        && page.revision.load(Ordering::Relaxed) == TRANSPORT_REVISION
}

/// Makes a record that says this under this sequence, or nothing; whole from the moment it has its name.
fn create(path: &Path, share: Share, said: Option<(u32, &Words)>) -> io::Result<()> {
    let new = unfinished(path);
    let us = rustix::process::geteuid().as_raw();
    let file = create_anew(&new)?;
    let made = rustix::fs::fallocate(&file, FallocateFlags::empty(), 0, PAGE_BYTES as u64)
        .map_err(io::Error::from)
        .and_then(|()| {
            let record = open_own(&new, us, share).map_err(as_io)?;
            let page = record.page();
            if let Some((sequence, words)) = said {
                page.write(sequence, words);
                page.hold(sequence);
                page.heartbeat.store(monotonic_ns(), Ordering::Relaxed);
            }
            page.revision.store(TRANSPORT_REVISION, Ordering::Relaxed);
            page.magic.store(MAGIC, Ordering::Release);
            std::fs::rename(&new, path)
        });
    made.inspect_err(|_| {
        // What cannot be removed is written over by the next daemon.
        let _ = std::fs::remove_file(&new);
    })
}

impl fmt::Debug for RecordWriter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RecordWriter").field("path", &self.path).finish_non_exhaustive()
    }
}
