//! Batches of top-level elements, each of which can be read by itself.
//!
//! A [`Cutter`] cuts the text behind the end of a road or junction. Whether the cut is right is only known when the batch has
//! been read: an end tag may stand in a comment. A batch counts if those before it ended between two elements and it does
//! itself; from the first on that does not, the document is read on as one.

use crate::counted::CountedFindings;
use crate::cursor::{Cursor, Name, NextChild, Open, Scope};
use crate::extension::Extension;
use crate::finding::Span;
use crate::findings::{Counts, Findings, KeptFinding};
use crate::generated::{Item, read_document};
use crate::limits::Limits;
use crate::source::{Inputs, NearPlaces, Note, Places, Source, WINDOW};
use crate::well_formed::Structure;
use crate::window::{Stop, Unread, Window};
use std::io::Read as _;
use std::sync::Arc;

/// Bytes of text that a batch has at least. The longest part of a batch's cost that does not grow with it is waking the thread that takes
/// what it was read to, some microseconds; a batch of this size takes two milliseconds.
const BATCH_BYTES: usize = 512 << 10;
/// The same at the beginning of a document: a small one is to be shared among several threads, too.
const EARLY_BATCH_BYTES: usize = 256 << 10;
/// Bytes of text that are its beginning.
const EARLY_BYTES: u64 = 8 << 20;
/// Bytes of text in which no end of a road or junction is found: such a document is read on as one.
const CUTLESS_BYTES: usize = 8 << 20;
/// Rooms that are larger than so many of the smallest batches are not kept for others.
const ROOM_BATCHES: usize = 4;
/// Top-level elements that are large or many; behind their ends the text is cut.
const CUT_BEHIND: [&str; 2] = ["road", "junction"];

/// Text that begins between two top-level elements, if the text before it does not end within one.
pub struct Batch {
    pub(crate) text: Vec<u8>,
    /// Start, as in spans, of its first byte.
    pub(crate) start: u64,
    notes: Vec<Note>,
}

impl Batch {
    /// Places in the document, those of the batch at hand.
    pub fn places(&self, all: &Places) -> NearPlaces {
        all.near(self.start, self.text.len())
    }

    /// Takes what the input has wrong in it as bytes.
    pub(crate) fn take_notes(&mut self) -> Vec<Note> {
        std::mem::take(&mut self.notes)
    }
}

/// The rest of a document that is read in batches.
pub struct RestOfDocument<'a> {
    /// What reading a batch needs to know of the document.
    pub context: Context,
    /// The text, to be cut into batches.
    pub cutter: Cutter<'a>,
}

/// Cuts what is left of a document into batches.
pub struct Cutter<'a> {
    pub(crate) source: Source<'a>,
    /// Text that is in no batch yet, and room behind it.
    room: Vec<u8>,
    filled: usize,
    pub(crate) start: u64,
    /// Bytes of it in which no end was found.
    searched: usize,
    /// Why there is no more text.
    pub(crate) stop: Option<Stop>,
    ends: [Vec<u8>; 2],
    /// Bytes of text that a batch has at least, if they are not those of this module.
    fixed: Option<usize>,
    /// Room of batches that are done with.
    spare: Vec<Vec<u8>>,
}

impl<'a> Cutter<'a> {
    pub(crate) fn new(unread: Unread<'a>, prefix: &[u8]) -> Self {
        let Unread { source, text, start } = unread;
        let ends = CUT_BEHIND.map(|name| [b"</", prefix, name.as_bytes(), b">"].concat());
        Self {
            source,
            filled: text.len(),
            room: text,
            start,
            searched: 0,
            stop: None,
            ends,
            fixed: None,
            spare: Vec::new(),
        }
    }

    /// Sets the bytes of text that a batch has at least, instead of 256 KiB, then 512 KiB.
    pub fn with_batch_bytes(mut self, least: usize) -> Self {
        self.fixed = Some(least);
        self
    }

    /// Bytes of text that the next batch has at least.
    fn least(&self) -> usize {
        let is_early = Places::offset_of(self.start) < EARLY_BYTES;
        self.fixed.unwrap_or(if is_early { EARLY_BATCH_BYTES } else { BATCH_BYTES })
    }

    /// The next batch; none where the rest of the document has to be read as one, which is so at its end at the latest.
    #[expect(clippy::should_implement_trait, reason = "where it ends, there is more to read")]
    pub fn next(&mut self) -> Option<Batch> {
        loop {
            if self.filled >= self.least() {
                if let Some(end) = self.end() {
                    let rest = self.room.get(end..self.filled).unwrap_or_default();
                    let mut room = self.spare.pop().unwrap_or_default();
                    make_room(&mut room, rest.len());
                    if let Some(place) = room.get_mut(..rest.len()) {
                        place.copy_from_slice(rest);
                    }
                    self.filled = rest.len();
                    let mut text = std::mem::replace(&mut self.room, room);
                    text.truncate(end);
                    let start = self.start;
                    self.start += end as u64;
                    self.searched = 0;
                    return Some(Batch { text, start, notes: self.source.take_notes() });
                }
                if self.filled > CUTLESS_BYTES {
                    return None;
                }
            }
            if !self.more() {
                return None;
            }
        }
    }

    /// Text that is in no batch yet.
    pub(crate) fn text(&self) -> &[u8] {
        self.room.get(..self.filled).unwrap_or_default()
    }

    /// Takes the room of a batch that is done with, for those to come. It keeps its length: nothing has to be cleared before it is read into.
    pub fn give_back(&mut self, room: Vec<u8>) {
        if room.capacity() <= ROOM_BATCHES * self.fixed.unwrap_or(BATCH_BYTES) {
            self.spare.push(room);
        }
    }

    /// Where the first road or junction ends that makes the batch large enough.
    fn end(&mut self) -> Option<usize> {
        // A tag may have been read in part.
        let longest = self.ends.iter().map(Vec::len).max().unwrap_or_default();
        let from = self.searched.max(self.least().saturating_sub(longest));
        let rest = self.text().get(from..).unwrap_or_default();
        let ends = self.ends.iter();
        let ends = ends.filter_map(|tag| Some(memchr::memmem::find(rest, tag)? + tag.len()));
        let end = ends.min().map(|end| from + end);
        self.searched = self.filled.saturating_sub(longest);
        end
    }

    fn more(&mut self) -> bool {
        if self.stop.is_some() {
            return false;
        }
        make_room(&mut self.room, self.filled + WINDOW);
        let count = match self.source.read(self.room.get_mut(self.filled..).unwrap_or_default()) {
            Ok(count) => count,
            Err(error) => {
                self.stop = Some(Stop::of(error));
                return false;
            }
        };
        if count == 0 {
            self.stop = Some(Stop::End);
        }
        self.filled += count;
        count > 0
    }
}

fn make_room(room: &mut Vec<u8>, bytes: usize) {
    if room.len() < bytes {
        room.resize(bytes, 0);
    }
}

/// What the reading of a batch needs to know of the document: the root as it is open, and the version.
#[derive(Clone)]
pub struct Context {
    known: Arc<ContextData>,
    /// Kinds of findings that no batch has to keep.
    used_up: Counts,
}

pub(crate) struct ContextData {
    pub(crate) limits: Limits,
    pub(crate) file: u16,
    pub(crate) version: usize,
    pub(crate) stated: String,
    pub(crate) prefix: Vec<u8>,
    pub(crate) namespace: Vec<u8>,
    pub(crate) root: Open,
    pub(crate) counts: Vec<u16>,
    pub(crate) structure: Structure,
}

/// A child of the root.
pub(crate) enum RootChild {
    Item(Item),
    /// An item that was taken away.
    Taken,
    Extension(Extension),
}

/// A child of the root, with what was found about it.
pub(crate) struct ReadPart {
    /// Its slot, if the schema has it.
    pub(crate) slot: Option<usize>,
    pub(crate) part: RootChild,
    pub(crate) findings: Vec<KeptFinding>,
    pub(crate) counted: CountedFindings,
    pub(crate) entered: Entered,
}

/// Where the start tag of a child of the root was read, before anything within.
#[derive(Clone, Copy, Default)]
pub(crate) struct Entered {
    /// The start tag.
    pub(crate) span: Span,
    /// Findings about it up to here.
    pub(crate) findings: usize,
}

/// A batch that has been read.
pub struct ReadBatch {
    pub(crate) batch: Batch,
    /// Children of the root.
    pub(crate) parts: Vec<ReadPart>,
    /// What was found behind the last of them, and what was not kept.
    pub(crate) rest: Findings,
    /// Whether it ends between two top-level elements, and none of them is a header, from which on another version may count.
    pub(crate) is_whole: bool,
}

impl ReadBatch {
    /// The batch, unread.
    pub fn into_batch(self) -> Batch {
        self.batch
    }
}

impl Context {
    pub(crate) fn new(known: ContextData) -> Self {
        Self { known: Arc::new(known), used_up: Counts::new() }
    }

    /// The same for the next batch, with what is known of findings by now.
    pub(crate) fn with_used_up(&self, used_up: Counts) -> Self {
        Self { known: Arc::clone(&self.known), used_up }
    }

    /// Reads a batch, on any thread.
    pub fn read(&self, batch: Batch) -> ReadBatch {
        self.read_each(batch, &mut Some)
    }

    /// Reads a batch, on any thread. Each top-level element goes through `take` as soon as it is read: what that does not give
    /// back is not handed out later, where [`Reader::delivered`](crate::Reader::delivered) says that there was one. A batch may turn
    /// out to be refused when all of them are taken; it is read again then.
    pub fn read_each(&self, batch: Batch, take: &mut dyn FnMut(Item) -> Option<Item>) -> ReadBatch {
        let known = &*self.known;
        let Batch { text, start, notes } = batch;
        let inputs = Inputs::new(known.limits.source);
        let limit = known.limits.tag_bytes.max(known.limits.text_bytes);
        let window = Window::over(text, start, inputs.nothing(known.file), limit);
        let mut cursor = Cursor::new(inputs, window, known.limits);
        cursor.version = known.version;
        cursor.stated.clone_from(&known.stated);
        cursor.prefix.clone_from(&known.prefix);
        cursor.namespace.clone_from(&known.namespace);
        cursor.counts.clone_from(&known.counts);
        cursor.structure = known.structure.clone();
        cursor.findings = Findings::behind(&known.limits, self.used_up.clone());
        cursor.push_frame(Name::Known(crate::reader::ROOT), 0);
        cursor.scope = Scope::Batch;
        let mut root = known.root.clone();
        let (mut parts, mut has_header) = (Vec::new(), false);
        while !cursor.over {
            // Whether an element stands behind others is seen where batches are taken one after the other.
            root.order = 0;
            let step = cursor.next_child(&mut root);
            let findings = cursor.findings.kept();
            let entered = Entered { span: cursor.tag.span, findings };
            let (slot, part) = match step {
                NextChild::Child(slot) => match read_document::item(slot, &mut cursor) {
                    Some(item) => {
                        has_header |= matches!(item, Item::Header(_));
                        (Some(slot), take(item).map_or(RootChild::Taken, RootChild::Item))
                    }
                    None => break,
                },
                NextChild::Extension(extension) => (None, RootChild::Extension(extension)),
                NextChild::End => break,
            };
            cursor.spent = 0;
            let (findings, counted) = (cursor.findings.take_kept(), cursor.findings.take_counted());
            parts.push(ReadPart { slot, part, findings, counted, entered });
        }
        let is_whole = cursor.scope == Scope::WholeBatch
            && !cursor.findings.is_full()
            && !cursor.window.passed_limit
            && !has_header;
        let rest = std::mem::replace(&mut cursor.findings, Findings::new(&known.limits));
        let batch = Batch { text: cursor.window.into_text(), start, notes };
        ReadBatch { batch, parts, rest, is_whole }
    }
}
