//! The decoded text of one input, piece by piece.

use super::characters;
use super::encoding::{self, Decoder};
use super::gzip::{Input, MAGIC};
use super::limits::SourceLimits;
use super::note::{Note, NoteKind, Refusal, RefusalKind};
use super::places::Places;
use super::prolog;
use std::io::{self, BufRead, Read};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Bytes read, decoded and handed on at once. It bounds how far a piece can grow beyond its limit. Whoever reads into as much room or more
/// gets whole characters.
pub(crate) const WINDOW: usize = 64 << 10;
/// Illegal characters that are noted one by one.
const ILLEGAL_NOTES: usize = 64;

/// What the sources of one document share.
#[derive(Clone, Debug)]
pub(super) struct Shared {
    pub(super) limits: SourceLimits,
    pub(super) places: Places,
    /// Decoded bytes of all files.
    pub(super) decoded: Arc<AtomicU64>,
}

/// One input as UTF-8 text: decompressed, decoded, without byte order mark. Bytes handed out are whole valid UTF-8 up to
/// where an error ends them, and their lines are counted.
///
/// Errors of reading are those of the environment, or carry a [`Refusal`], see [`Source::refusal`]; a refusal comes after
/// all text before it has been handed out, and comes again when asked again.
pub struct Source<'a> {
    input: Opening<'a>,
    decoder: Decoder,
    shared: Shared,
    file: u16,
    /// Bytes not decoded yet, of encodings other than UTF-8.
    raw: Vec<u8>,
    raw_place: usize,
    raw_filled: usize,
    /// Text: handed on up to `place`, whole characters up to `valid`, the beginning of a character up to `filled`.
    buffer: Vec<u8>,
    place: usize,
    valid: usize,
    filled: usize,
    /// Offset of the buffer's first byte in the decoded text.
    base: u64,
    /// Bytes of text before the first `<` that were passed over.
    skipped: u64,
    /// Whether such text is passed over here.
    passes_over: bool,
    ended: bool,
    /// What ends the input instead of its end. Text before it is still handed out.
    damage: Option<RefusalKind>,
    pending: Option<Refusal>,
    notes: Vec<Note>,
    illegal: usize,
    c1_noted: bool,
    /// Bytes consumed since the current piece began, and how many it may have.
    taken: usize,
    piece_limit: usize,
}

/// An input before and after its first bytes were looked at.
enum Opening<'a> {
    Unread(Box<dyn Read + Send + 'a>),
    Open(Input<'a>),
    Failed,
}

impl<'a> Source<'a> {
    pub(super) fn new(input: Box<dyn Read + Send + 'a>, shared: Shared, file: u16) -> Self {
        Self {
            input: Opening::Unread(input),
            decoder: Decoder::Utf8,
            shared,
            file,
            raw: Vec::new(),
            raw_place: 0,
            raw_filled: 0,
            buffer: Vec::new(),
            place: 0,
            valid: 0,
            filled: 0,
            base: 0,
            skipped: 0,
            passes_over: true,
            ended: false,
            damage: None,
            pending: None,
            notes: Vec::new(),
            illegal: 0,
            c1_noted: false,
            taken: 0,
            piece_limit: usize::MAX,
        }
    }

    /// Hands out text before the first `<`, too: another source reads what this one hands out, and notes it.
    pub(super) fn with_all_text(self) -> Self {
        Self { passes_over: false, ..self }
    }

    /// A source that has ended.
    pub(super) fn nothing(shared: Shared, file: u16) -> Self {
        Self { ended: true, ..Self::new(Box::new(io::empty()), shared, file) }
    }

    /// The number of this file in [`Places`].
    pub fn file(&self) -> u16 {
        self.file
    }

    /// Offset in the decoded text of the next byte to be consumed.
    pub fn offset(&self) -> u64 {
        self.base + self.place as u64
    }

    /// Bytes of text before the first `<` that were passed over: the offset of the first byte handed out. Known once
    /// something was read.
    pub fn skipped(&self) -> u64 {
        self.skipped
    }

    /// The encoding's standard name. Known once something was read.
    pub fn encoding(&self) -> &'static str {
        self.decoder.name()
    }

    /// Bytes taken from the input itself so far, where it is compressed.
    pub fn compressed_bytes(&self) -> Option<u64> {
        match &self.input {
            Opening::Open(input) => input.raw_bytes(),
            Opening::Unread(_) | Opening::Failed => None,
        }
    }

    /// Takes the notes since the last call, in the order of their places.
    pub fn take_notes(&mut self) -> Vec<Note> {
        let mut notes = std::mem::take(&mut self.notes);
        // What was looked at to recognise the encoding may be refused before the place of a note.
        let end = self.base + self.valid as u64;
        for note in &mut notes {
            note.start = note.start.min(end);
        }
        notes
    }

    /// A new piece of markup or text begins, of `limit` bytes at most and a buffer's length.
    #[inline]
    pub fn begin_piece(&mut self, limit: usize) {
        self.taken = 0;
        self.piece_limit = limit;
    }

    #[inline]
    fn look_at_piece(&self) -> io::Result<()> {
        if self.taken > self.piece_limit {
            let kind = RefusalKind::Piece(self.piece_limit);
            return Err(invalid(Refusal { start: self.offset(), kind }));
        }
        Ok(())
    }

    /// The refusal that an error of reading carries; none if the environment failed.
    pub fn refusal(error: &io::Error) -> Option<&Refusal> {
        error.get_ref()?.downcast_ref()
    }

    fn refuse(&mut self, kind: RefusalKind) {
        let start = self.base + self.valid as u64;
        self.pending = Some(Refusal { start, kind });
    }

    /// Reads and decodes the next piece of text. At the end, or where the input is refused, there is none.
    fn refill(&mut self) -> io::Result<()> {
        while self.place == self.valid && !self.ended && self.pending.is_none() {
            if matches!(self.input, Opening::Unread(_)) {
                self.begin()?;
            }
            self.move_on();
            let mut buffer = std::mem::take(&mut self.buffer);
            let read = match self.decoder {
                Decoder::Utf8 => self.read_utf8(&mut buffer),
                Decoder::Latin1 | Decoder::Other(_) => self.read_other(&mut buffer),
            };
            if read.is_ok() {
                self.look_at_text(&buffer);
            }
            self.buffer = buffer;
            read?;
        }
        Ok(())
    }

    /// What was handed on is forgotten; the beginning of a character stays, at the buffer's start.
    fn move_on(&mut self) {
        self.base += self.valid as u64;
        self.buffer.copy_within(self.valid..self.filled, 0);
        (self.place, self.valid, self.filled) = (0, 0, self.filled - self.valid);
    }

    /// Whether the next text is read from the input as it is, and none waits.
    fn reads_through(&self) -> bool {
        let is_open = matches!((&self.input, &self.decoder), (Opening::Open(_), Decoder::Utf8));
        let is_empty = self.place == self.valid && self.raw_place == self.raw_filled;
        is_open && is_empty && !self.ended && self.pending.is_none()
    }

    /// As [`Source::refill`], but into a window's room elsewhere, where the text stays; how many bytes.
    fn refill_outside(&mut self, room: &mut [u8]) -> io::Result<usize> {
        loop {
            self.move_on();
            let begun = self.filled;
            room[..begun].copy_from_slice(&self.buffer[..begun]);
            self.read_utf8(room)?;
            self.look_at_text(room);
            let (count, rest) = (self.valid, self.valid..self.filled);
            // Behind what is handed on, the buffer has what the room has.
            self.buffer[rest.clone()].copy_from_slice(&room[rest]);
            self.move_on();
            if count > 0 || self.ended || self.pending.is_some() {
                return Ok(count);
            }
        }
    }

    /// Looks at the first bytes.
    fn begin(&mut self) -> io::Result<()> {
        let inner = match std::mem::replace(&mut self.input, Opening::Failed) {
            Opening::Unread(inner) => inner,
            Opening::Open(_) | Opening::Failed => return Ok(()),
        };
        let input = Input::open(inner)?;
        let is_gzip = input.is_gzip();
        self.input = Opening::Open(input);
        self.buffer.resize(WINDOW, 0);
        let mut head = vec![0; WINDOW];
        let mut count = 0;
        while count < head.len() {
            match self.read_input(&mut head[count..])? {
                0 => break,
                more => count += more,
            }
        }
        let first = &head[..count];
        if is_gzip && first.starts_with(&MAGIC) {
            self.refuse(RefusalKind::NestedGzip);
            return Ok(());
        }
        match encoding::detect(first) {
            Ok(detected) => {
                self.decoder = detected.decoder;
                self.notes = detected.notes;
                self.raw = head;
                (self.raw_place, self.raw_filled) = (detected.mark, count);
            }
            Err(kind) => self.refuse(kind),
        }
        Ok(())
    }

    /// Reads bytes; none at the end, or where the input is damaged.
    fn read_input(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.damage.is_some() {
            return Ok(0);
        }
        let Opening::Open(input) = &mut self.input else {
            return Err(io::Error::other("the input failed before"));
        };
        match input.read(buffer, &self.shared.limits)? {
            Ok(count) => Ok(count),
            Err(kind) => {
                self.damage = Some(kind);
                Ok(0)
            }
        }
    }

    /// The input has ended: by itself, or by damage.
    fn end(&mut self) {
        self.ended = true;
        if let Some(kind) = self.damage.take() {
            self.refuse(kind);
        }
    }

    /// Reads text behind what `buffer` holds already.
    fn read_utf8(&mut self, buffer: &mut [u8]) -> io::Result<()> {
        let count = if self.raw_place < self.raw_filled {
            // What was looked at to recognise the encoding.
            let from = &self.raw[self.raw_place..self.raw_filled];
            let count = from.len().min(buffer.len() - self.filled);
            buffer[self.filled..self.filled + count].copy_from_slice(&from[..count]);
            self.raw_place += count;
            count
        } else {
            self.raw = Vec::new();
            (self.raw_place, self.raw_filled) = (0, 0);
            self.read_input(&mut buffer[self.filled..])?
        };
        self.filled += count;
        let text = &buffer[..self.filled];
        self.valid = self.filled;
        if simdutf8::basic::from_utf8(text).is_err()
            && let Err(error) = std::str::from_utf8(text)
        {
            self.valid = error.valid_up_to();
            // The beginning of a character at the end of what was read may go on.
            if error.error_len().is_some() || (count == 0 && self.damage.is_none()) {
                self.refuse(RefusalKind::InvalidBytes(self.decoder.name()));
            }
        }
        if count == 0 {
            self.end();
        }
        Ok(())
    }

    fn read_other(&mut self, buffer: &mut [u8]) -> io::Result<()> {
        if self.raw_place == self.raw_filled {
            let mut raw = std::mem::take(&mut self.raw);
            let count = self.read_input(&mut raw);
            self.raw = raw;
            (self.raw_place, self.raw_filled) = (0, count?);
        }
        let from = &self.raw[self.raw_place..self.raw_filled];
        let last = from.is_empty();
        // Damage is told, not the half character before it.
        let decoded = self.decoder.decode(from, buffer, last && self.damage.is_none());
        self.raw_place += decoded.taken;
        (self.valid, self.filled) = (decoded.written, decoded.written);
        if decoded.invalid {
            self.refuse(RefusalKind::InvalidBytes(self.decoder.name()));
        }
        if last {
            self.end();
        }
        Ok(())
    }

    /// Counts lines and bytes of the text that was just decoded, and notes what it has wrong.
    fn look_at_text(&mut self, buffer: &[u8]) {
        let more = self.valid as u64;
        let before = self.shared.decoded.fetch_add(more, Ordering::Relaxed);
        let limit = self.shared.limits.decoded_bytes;
        if before.saturating_add(more) > limit {
            // Text up to the limit is handed out, up to a whole character.
            self.valid = usize::try_from(limit.saturating_sub(before)).unwrap_or(self.valid);
            while self.valid > 0 && buffer[self.valid] & 0xc0 == 0x80 {
                self.valid -= 1;
            }
            self.filled = self.valid;
            self.refuse(RefusalKind::DecodedBytes(limit));
        }
        let text = &buffer[..self.valid];
        let may_be_illegal = self.shared.places.feed(self.file, text);
        if self.base == 0 && self.passes_over {
            self.place = prolog::look(text).junk;
            self.skipped = self.place as u64;
            if self.place > 0 {
                let len = u32::try_from(self.place).unwrap_or(u32::MAX);
                self.notes.push(Note { start: 0, len, kind: NoteKind::TextBeforeMarkup });
            }
        }
        let control = match self.decoder {
            Decoder::Latin1 if !self.c1_noted => characters::find_c1(text),
            _ => None,
        };
        if may_be_illegal {
            self.note_illegal(text);
        }
        if let Some(at) = control {
            self.c1_noted = true;
            let start = self.base + at as u64;
            self.notes.push(Note { start, len: 2, kind: NoteKind::ControlInLatin1 });
        }
    }

    #[cold]
    fn note_illegal(&mut self, text: &[u8]) {
        let Ok(text) = std::str::from_utf8(text) else { return };
        let illegal = text.char_indices().filter(|(_, c)| !characters::is_legal(*c));
        for (at, character) in illegal {
            if self.illegal > ILLEGAL_NOTES {
                return;
            }
            self.illegal += 1;
            let kind = if self.illegal > ILLEGAL_NOTES {
                NoteKind::MoreIllegalCharacters
            } else {
                NoteKind::IllegalCharacter(character)
            };
            let len = character.len_utf8() as u32;
            self.notes.push(Note { start: self.base + at as u64, len, kind });
        }
    }
}

impl Read for Source<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.reads_through()
            && let Some(room) = buffer.get_mut(..WINDOW)
        {
            self.look_at_piece()?;
            let count = self.refill_outside(room)?;
            self.taken = self.taken.saturating_add(count);
            if count > 0 {
                return Ok(count);
            }
        }
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}

impl BufRead for Source<'_> {
    #[inline]
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.look_at_piece()?;
        if self.place == self.valid {
            self.refill()?;
            if self.place == self.valid
                && let Some(refusal) = &self.pending
            {
                return Err(invalid(refusal.clone()));
            }
        }
        Ok(&self.buffer[self.place..self.valid])
    }

    #[inline]
    fn consume(&mut self, count: usize) {
        let count = count.min(self.valid - self.place);
        self.place += count;
        self.taken = self.taken.saturating_add(count);
    }
}

fn invalid(refusal: Refusal) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, refusal)
}
