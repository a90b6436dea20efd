//! A document's text with a patch in it.

use super::markup::{Kind, Markup, attribute, markup, name};
use super::{Patch, PatchError, PatchedId, PatchedKind};
use crate::source::{Places, Position, Source};
use std::collections::BTreeSet;
use std::io::{self, Read};

/// Bytes that are read at once.
const WINDOW: usize = 256 << 10;

/// Longest markup that is looked at as one \[bytes\]: what is longer is passed on as it is, and refused by who reads it.
const LONGEST_MARKUP: usize = 64 << 20;

/// Elements that come after all roads, and those that come after all junctions.
const AFTER_ROADS: [&[u8]; 4] = [b"controller", b"junction", b"junctionGroup", b"station"];
const AFTER_JUNCTIONS: [&[u8]; 2] = [b"junctionGroup", b"station"];

/// Passes a document on, with a patch in it.
pub(crate) struct Splice<'a> {
    source: Source<'a>,
    patch: &'a Patch,
    places: Places,
    /// Number of the patch among the files.
    file: u16,
    /// Text that is not passed on yet: from `at` on.
    text: Vec<u8>,
    at: usize,
    is_read: bool,
    /// Where `at` stands in the document.
    here: Position,
    depth: usize,
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
}

impl<'a> Splice<'a> {
    pub(crate) fn new(source: Source<'a>, patch: &'a Patch, places: Places, file: u16) -> Self {
        Self {
            source,
            patch,
            places,
            file,
            text: Vec::new(),
            at: 0,
            is_read: false,
            here: Position { line: 1, column: 1 },
            depth: 0,
            skips: None,
            is_cut: false,
            out: Vec::new(),
            taken: 0,
            made: 0,
            done: BTreeSet::new(),
        }
    }

    /// Passes on, or leaves out, up to a place of the text.
    fn pass(&mut self, to: usize) {
        let piece = &self.text[self.at..to];
        if self.skips.is_none() && !piece.is_empty() {
            if std::mem::take(&mut self.is_cut) {
                self.places.piece(self.made, 0, self.here);
            }
            self.out.extend_from_slice(piece);
            self.made += piece.len() as u64;
        }
        match memchr::memrchr(b'\n', piece) {
            Some(last) => {
                self.here.line += memchr::memchr_iter(b'\n', piece).count() as u32;
                self.here.column = (piece.len() - last) as u32;
            }
            None => self.here.column += piece.len() as u32,
        }
        self.at = to;
    }

    /// Passes on elements of the patch that are not yet.
    fn insert(&mut self, is_wanted: impl Fn(&PatchedId) -> bool) {
        for element in &self.patch.elements {
            if is_wanted(&element.id) && self.done.insert(element.id.clone()) {
                self.places.piece(self.made, self.file, element.at);
                let text = &self.patch.text[element.range.0..element.range.1];
                self.out.extend_from_slice(text);
                self.made += text.len() as u64;
                self.is_cut = true;
            }
        }
    }

    /// Looks at markup that is next.
    fn look(&mut self, found: Markup) {
        self.pass(found.start);
        match found.kind {
            Kind::Other => {}
            Kind::Start | Kind::Empty => {
                if self.depth == 1 {
                    let tag = self.text[found.start..found.end].to_vec();
                    self.element(&tag);
                }
                let deeper = usize::from(found.kind == Kind::Start);
                self.pass(found.end);
                self.depth += deeper;
                if deeper == 0 && self.skips == Some(self.depth) {
                    self.resume();
                }
            }
            Kind::End => {
                if self.depth == 1 {
                    self.insert(|_| true);
                }
                self.pass(found.end);
                self.depth = self.depth.saturating_sub(1);
                if self.skips == Some(self.depth) {
                    self.resume();
                }
            }
        }
        if found.kind == Kind::Other {
            self.pass(found.end);
        }
    }

    fn resume(&mut self) {
        self.skips = None;
        self.is_cut = true;
    }

    /// A top-level element begins.
    fn element(&mut self, tag: &[u8]) {
        let name = name(tag);
        if AFTER_ROADS.contains(&name) {
            self.insert(|id| id.kind == PatchedKind::Road);
        }
        if AFTER_JUNCTIONS.contains(&name) {
            self.insert(|_| true);
        }
        let Some(kind) = PatchedKind::of(name) else { return };
        let id = PatchedId { kind, id: attribute(tag, b"id").unwrap_or_default() };
        if self.patch.removed.contains(&id) {
            self.done.insert(id);
            self.skips = Some(self.depth);
        } else if self.patch.elements.iter().any(|own| own.id == id) {
            self.insert(|own| *own == id);
            self.skips = Some(self.depth);
        }
    }

    /// Makes more text.
    fn make(&mut self) -> io::Result<()> {
        if let Some(found) = markup(&self.text, self.at) {
            self.look(found);
            return Ok(());
        }
        if self.is_read || self.text.len() - self.at > LONGEST_MARKUP {
            self.pass(self.text.len());
        }
        if self.is_read {
            return Ok(());
        }
        self.text.drain(..self.at);
        self.at = 0;
        let before = self.text.len();
        self.text.resize(before + WINDOW, 0);
        let count = self.source.read(&mut self.text[before..])?;
        self.text.truncate(before + count);
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
