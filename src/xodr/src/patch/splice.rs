//! A document's text with a patch in it.

use super::markup::{Kind, Markup, Within, attribute, markup, name, whole_name};
use super::{MARK, Patch, PatchError, PatchedId, PatchedKind};
use crate::source::{Places, Source};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, BufRead as _, Read};

/// Bytes that are made at once.
const WINDOW: usize = 256 << 10;

/// Longest markup that is looked at as one \[bytes\]: what is longer is passed on as it is. The reader refuses it, whose own limits are 1 MiB unless the caller raises
/// them. Text twice as long may be held here, which stays below the bound on memory.
const LONGEST_MARKUP: usize = 32 << 20;

/// Elements that come after all roads, and those that come after all junctions.
const AFTER_ROADS: [&[u8]; 4] = [b"controller", b"junction", b"junctionGroup", b"station"];
const AFTER_JUNCTIONS: [&[u8]; 2] = [b"junctionGroup", b"station"];

const BOTH: [PatchedKind; 2] = [PatchedKind::Road, PatchedKind::Junction];

/// Passes a document on, with a patch in it.
pub(crate) struct Splice<'a> {
    source: Source<'a>,
    /// The lines of its text.
    written: Places,
    patch: &'a Patch,
    places: Places,
    /// Number of the patch among the files.
    file: u16,
    /// Text that is not passed on yet: from `at` on; markup is looked for from `seen` on.
    text: Vec<u8>,
    at: usize,
    seen: usize,
    /// Bytes of text from which on looking again makes sense: each time twice as many, so that long markup is not searched again and again.
    wanted: usize,
    is_read: bool,
    depth: usize,
    /// The top-level element that is open: only its own tags are looked at in it.
    inside: Option<Within>,
    /// Depth at which what is left out ends.
    skips: Option<usize>,
    /// Whether what is passed on next does not follow what was passed on before.
    is_cut: bool,
    out: Vec<u8>,
    taken: usize,
    /// Bytes that were made in all.
    made: u64,
    /// Elements that are done: passed on, or left out.
    done: BTreeSet<PatchedId>,
    /// The patch's elements by their ids, and what goes.
    own: BTreeMap<&'a PatchedId, usize>,
    removed: BTreeSet<&'a PatchedId>,
    /// Kinds of which all elements are passed on.
    inserted: BTreeSet<PatchedKind>,
}

impl<'a> Splice<'a> {
    /// `places` are those of the text that is made, `written` those of the source.
    pub(crate) fn new(
        source: Source<'a>,
        written: Places,
        patch: &'a Patch,
        places: Places,
        file: u16,
    ) -> Self {
        Self {
            source,
            written,
            patch,
            places,
            file,
            text: Vec::new(),
            at: 0,
            seen: 0,
            wanted: 0,
            is_read: false,
            depth: 0,
            inside: None,
            skips: None,
            is_cut: false,
            // The declaration may name another encoding; the text is UTF-8.
            out: MARK.to_vec(),
            taken: 0,
            made: 0,
            done: BTreeSet::new(),
            own: patch.elements.iter().enumerate().map(|(i, own)| (&own.id, i)).collect(),
            removed: patch.removed.iter().collect(),
            inserted: BTreeSet::new(),
        }
    }

    /// Passes on, or leaves out, up to a place of the text.
    fn pass(&mut self, to: usize) {
        let piece = &self.text[self.at..to];
        if self.skips.is_none() && !piece.is_empty() {
            if std::mem::take(&mut self.is_cut) {
                let at = self.source.offset() - (self.text.len() - self.at) as u64;
                self.places.piece(self.made, 0, self.written.position(at));
            }
            self.out.extend_from_slice(piece);
            self.made += piece.len() as u64;
        }
        self.at = to;
    }

    /// Passes on elements of the patch of these kinds that are not yet.
    fn insert(&mut self, kinds: &[PatchedKind]) {
        if kinds.iter().all(|kind| self.inserted.contains(kind)) {
            return;
        }
        for (number, element) in self.patch.elements.iter().enumerate() {
            if kinds.contains(&element.id.kind) {
                self.insert_one(number);
            }
        }
        self.inserted.extend(kinds);
    }

    /// Passes on an element of the patch, if it is not yet.
    fn insert_one(&mut self, number: usize) {
        let element = &self.patch.elements[number];
        if self.done.insert(element.id.clone()) {
            self.places.piece(self.made, self.file, element.at);
            let text = &self.patch.text[element.range.0..element.range.1];
            self.out.extend_from_slice(text);
            self.made += text.len() as u64;
            self.is_cut = true;
        }
    }

    /// Looks at markup that is next. What lies within an element is passed on with what comes behind.
    fn look(&mut self, found: Markup) {
        self.seen = found.end;
        match found.kind {
            Kind::Other => {}
            Kind::Start | Kind::Empty => {
                if self.depth == 1 {
                    self.pass(found.start);
                    let tag = self.text[found.start..found.end].to_vec();
                    self.element(&tag);
                    self.inside = Some(Within::new(whole_name(&tag)));
                }
                let deeper = usize::from(found.kind == Kind::Start);
                self.depth += deeper;
                if self.depth == 1 {
                    self.inside = None;
                }
                if deeper == 0 && self.skips == Some(self.depth) {
                    self.resume();
                }
            }
            Kind::End => {
                if self.depth == 1 {
                    self.pass(found.start);
                    self.insert(&BOTH);
                }
                self.depth = self.depth.saturating_sub(1);
                if self.depth <= 1 {
                    self.inside = None;
                }
                if self.skips == Some(self.depth) {
                    self.resume();
                }
            }
        }
    }

    /// What was left out is over.
    fn resume(&mut self) {
        self.pass(self.seen);
        self.skips = None;
        self.is_cut = true;
    }

    /// A top-level element begins.
    fn element(&mut self, tag: &[u8]) {
        let name = name(tag);
        if AFTER_ROADS.contains(&name) {
            self.insert(&[PatchedKind::Road]);
        }
        if AFTER_JUNCTIONS.contains(&name) {
            self.insert(&BOTH);
        }
        let Some(kind) = PatchedKind::of(name) else { return };
        let id = PatchedId { kind, id: attribute(tag, b"id").unwrap_or_default() };
        if self.removed.contains(&id) {
            self.done.insert(id);
            self.skips = Some(self.depth);
        } else if let Some(number) = self.own.get(&id) {
            self.insert_one(*number);
            self.skips = Some(self.depth);
        }
    }

    /// Makes more text.
    fn make(&mut self) -> io::Result<()> {
        if self.text.len() >= self.wanted || self.is_read {
            let start = match &mut self.inside {
                Some(within) => within.next(&self.text, self.seen),
                None => Ok(self.seen),
            };
            if let Ok(start) = start
                && let Some(found) = markup(&self.text, start)
            {
                self.wanted = 0;
                self.look(found);
                return Ok(());
            }
            self.seen = match start {
                Ok(start) => memchr::memchr(b'<', &self.text[start..])
                    .map_or(self.text.len(), |begin| start + begin),
                Err(searched) => searched,
            };
            self.wanted = (2 * (self.text.len() - self.seen)).min(LONGEST_MARKUP + 1);
        }
        self.pass(self.seen);
        if self.is_read || self.text.len() - self.at > LONGEST_MARKUP {
            self.pass(self.text.len());
            self.seen = self.at;
            self.wanted = 0;
        }
        if self.is_read {
            return Ok(());
        }
        self.text.drain(..self.at);
        if let Some(within) = &mut self.inside {
            within.forget(self.at);
        }
        (self.at, self.seen) = (0, 0);
        let more = self.source.fill_buf()?;
        self.text.extend_from_slice(more);
        let count = more.len();
        self.source.consume(count);
        self.is_read = count == 0;
        if !matches!(self.source.encoding(), "UTF-8" | "US-ASCII") {
            let error = PatchError::Encoding(self.source.encoding());
            return Err(io::Error::new(io::ErrorKind::InvalidInput, error));
        }
        Ok(())
    }
}

impl Read for Splice<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.taken == self.out.len() {
            self.out.clear();
            self.taken = 0;
        }
        let enough = buffer.len().min(WINDOW);
        while self.out.len() < enough && !(self.is_read && self.at == self.text.len()) {
            self.make()?;
        }
        let is_over = self.is_read && self.at == self.text.len();
        if is_over && self.taken == self.out.len() {
            let missing = self.patch.removed.iter().find(|id| !self.done.contains(id));
            if let Some(id) = missing {
                let error = PatchError::NotThere(id.clone());
                return Err(io::Error::new(io::ErrorKind::InvalidInput, error));
            }
        }
        let count = buffer.len().min(self.out.len() - self.taken);
        buffer[..count].copy_from_slice(&self.out[self.taken..self.taken + count]);
        self.taken += count;
        Ok(count)
    }
}
