//! The text around the place where the reader stands, in one piece.

use crate::source::{Places, Refusal, Source};
use std::io::{self, BufRead as _};

/// Bytes that the window has room for at first; tags and text that need more make it grow, up to the limits.
const ROOM: usize = 128 << 10;

/// Why there is no more text.
#[derive(Debug)]
pub(crate) enum Stop {
    /// It has ended.
    End,
    /// One piece is larger than the limit.
    TooLarge,
    /// The input is refused.
    Refused(Refusal),
    /// Reading failed.
    Failed(io::Error),
}

impl Stop {
    /// What an error of reading means.
    pub(crate) fn of(error: io::Error) -> Self {
        match Source::refusal(&error) {
            Some(refusal) => Self::Refused(refusal.clone()),
            None => Self::Failed(error),
        }
    }
}

/// What is not read yet of an input.
pub(crate) struct Unread<'a> {
    pub(crate) source: Source<'a>,
    /// Text of it that was taken from the source.
    pub(crate) text: Vec<u8>,
    /// Where that begins in the document's text.
    pub(crate) start: u64,
}

/// A window on the text of one input. The token is what lies between `start` and `at`; it stays while more is read.
pub(crate) struct Window<'a> {
    pub(crate) source: Source<'a>,
    buffer: Vec<u8>,
    /// First byte of the token.
    start: usize,
    /// Next byte to be looked at.
    at: usize,
    /// End of what was read.
    end: usize,
    /// Start, as in spans, of the buffer's first byte.
    base: u64,
    /// A byte before the token from which on everything stays.
    hold: Option<usize>,
    /// Bytes that the token may have.
    pub(crate) limit: usize,
    /// Bytes that may be held.
    hold_limit: usize,
    begun: bool,
    /// Whether a token had more bytes than the limit, which is told only where text had to be read for it.
    pub(crate) passed_limit: bool,
    pub(crate) stop: Option<Stop>,
}

impl<'a> Window<'a> {
    pub(crate) fn new(source: Source<'a>, limit: usize, hold_limit: usize) -> Self {
        // Where the text begins, unless something before it is passed over.
        let base = Places::start(source.file(), 0);
        Self {
            source,
            buffer: vec![0; ROOM],
            start: 0,
            at: 0,
            end: 0,
            base,
            hold: None,
            limit,
            hold_limit,
            begun: false,
            passed_limit: false,
            stop: None,
        }
    }

    /// A window on a text that is there as a whole, and where it begins.
    pub(crate) fn over(text: Vec<u8>, base: u64, source: Source<'a>, limit: usize) -> Self {
        let end = text.len();
        Self {
            source,
            buffer: text,
            start: 0,
            at: 0,
            end,
            base,
            hold: None,
            limit,
            hold_limit: usize::MAX,
            begun: true,
            passed_limit: false,
            stop: Some(Stop::End),
        }
    }

    /// Takes away what is not read yet; nothing is left but an end.
    pub(crate) fn hand_over(&mut self, nothing: Source<'a>) -> Unread<'a> {
        let text = self.buffer.get(self.at..self.end).unwrap_or_default().to_vec();
        let start = self.offset();
        let empty = Self::over(Vec::new(), start, nothing, self.limit);
        Unread { source: std::mem::replace(self, empty).source, text, start }
    }

    /// Puts text before what the source still has; `stop` where it has nothing more.
    pub(crate) fn go_on(
        &mut self,
        text: Vec<u8>,
        base: u64,
        source: Source<'a>,
        hold_limit: usize,
        stop: Option<Stop>,
    ) {
        *self = Self { hold_limit, stop, ..Self::over(text, base, source, self.limit) };
    }

    /// The text, of a window over one.
    pub(crate) fn into_text(self) -> Vec<u8> {
        self.buffer
    }

    /// Says where the next byte would stand, of a window over nothing.
    pub(crate) fn move_to(&mut self, start: u64) {
        self.base = start;
    }

    /// Start, as in spans, of the token.
    pub(crate) fn start(&self) -> u64 {
        self.base + self.start as u64
    }

    /// Start, as in spans, of the next byte.
    pub(crate) fn offset(&self) -> u64 {
        self.base + self.at as u64
    }

    /// The token.
    pub(crate) fn token(&self) -> &[u8] {
        self.buffer.get(self.start..self.at).unwrap_or_default()
    }

    /// What was read from the token's start on.
    pub(crate) fn ahead(&self) -> &[u8] {
        self.buffer.get(self.start..self.end).unwrap_or_default()
    }

    /// The token ends here and the next one begins.
    pub(crate) fn begin(&mut self) {
        self.start = self.at;
    }

    /// The token has `length` bytes.
    pub(crate) fn take(&mut self, length: usize) {
        self.passed_limit |= length > self.limit;
        self.at = self.start.saturating_add(length).min(self.end);
    }

    /// From the token's start on everything stays, until [`Window::release`].
    pub(crate) fn hold(&mut self) {
        self.hold = Some(self.start);
    }

    /// What was held, up to the token's end; none if it was more than the window holds.
    pub(crate) fn release(&mut self) -> Option<&[u8]> {
        let from = self.hold.take()?;
        self.buffer.get(from..self.at)
    }

    /// Reads more text. False where there is none; `stop` then says why.
    #[cold]
    #[inline(never)]
    pub(crate) fn more(&mut self) -> bool {
        if self.stop.is_some() {
            return false;
        }
        if self.end - self.start > self.limit {
            self.stop = Some(Stop::TooLarge);
            return false;
        }
        if self.hold.is_some_and(|hold| self.end - hold > self.hold_limit) {
            self.hold = None;
        }
        let keep = self.hold.unwrap_or(self.start);
        self.buffer.copy_within(keep..self.end, 0);
        self.base += keep as u64;
        (self.start, self.at, self.end) = (self.start - keep, self.at - keep, self.end - keep);
        self.hold = self.hold.map(|_| 0);
        if self.end == self.buffer.len() {
            self.buffer.resize((self.buffer.len() * 2).max(ROOM), 0);
        }
        let chunk = match self.source.fill_buf() {
            Ok(chunk) => chunk,
            Err(error) => {
                self.stop = Some(Stop::of(error));
                return false;
            }
        };
        let count = chunk.len().min(self.buffer.len() - self.end);
        if count == 0 {
            self.stop = Some(Stop::End);
            return false;
        }
        self.buffer[self.end..self.end + count].copy_from_slice(&chunk[..count]);
        if !self.begun {
            self.begun = true;
            self.base = Places::start(self.source.file(), self.source.offset());
        }
        self.source.consume(count);
        self.end += count;
        true
    }

    /// Passes over white space; the token begins behind it. The byte there; none at the end.
    #[inline]
    pub(crate) fn skip_space(&mut self) -> Option<u8> {
        loop {
            let rest = self.buffer.get(self.at..self.end).unwrap_or_default();
            let count = space_len(rest);
            self.at += count;
            self.start = self.at;
            if let Some(byte) = rest.get(count) {
                return Some(*byte);
            }
            if !self.more() {
                return None;
            }
        }
    }

    /// Where a byte stands, from `from` bytes behind the token's start on, counted from there; none where the text ends.
    #[inline]
    pub(crate) fn find(&mut self, byte: u8, from: usize) -> Option<usize> {
        let mut from = from;
        loop {
            if let Some(at) = memchr::memchr(byte, self.ahead().get(from..).unwrap_or_default()) {
                return Some(from + at);
            }
            from = from.max(self.end - self.start);
            if !self.more() {
                return None;
            }
        }
    }

    /// Where a sequence that ends with `>` ends, counted from the token's start; none where the text ends.
    pub(crate) fn find_end(&mut self, sequence: &[u8], from: usize) -> Option<usize> {
        let mut at = from;
        loop {
            at = self.find(b'>', at)? + 1;
            let ends = at >= from + sequence.len();
            if ends && self.ahead().get(..at).is_some_and(|text| text.ends_with(sequence)) {
                return Some(at);
            }
        }
    }

    /// Makes sure that `count` bytes from the token's start on are there, if the text has them.
    pub(crate) fn want(&mut self, count: usize) {
        while self.end - self.start < count && self.more() {}
    }
}

/// Number of bytes of white space at the beginning: a line break and indentation for most tags.
#[inline]
fn space_len(text: &[u8]) -> usize {
    let mut count = 0;
    while let Some(byte @ (b' ' | b'\n' | b'\t' | b'\r')) = text.get(count).copied() {
        count += 1;
        // A run of one kind of space is passed over eight bytes at a time.
        while let Some(eight) = text.get(count..).and_then(<[u8]>::first_chunk) {
            let others = u64::from_le_bytes(*eight) ^ u64::from_le_bytes([byte; 8]);
            if others != 0 {
                count += others.trailing_zeros() as usize / 8;
                break;
            }
            count += 8;
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn space_is_passed_over_up_to_the_first_other_byte() {
        for head in ["", "\n", "\r\n", "\t\t\t", "\n\n\n\n\n\n\n\n\n\n"] {
            for spaces in 0..40 {
                for tail in ["", "<", "<road id", "\t", "\u{a0}         "] {
                    let text = format!("{head}{}{tail}", " ".repeat(spaces));
                    let is_space = |byte: &u8| b" \n\t\r".contains(byte);
                    let due = text.bytes().take_while(is_space).count();
                    assert_eq!(space_len(text.as_bytes()), due, "{text:?}");
                }
            }
        }
    }
}
