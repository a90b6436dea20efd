//! From byte offsets to lines and columns.

/// A place in a text file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// Line, from 1.
    pub line: u32,
    /// Column in bytes, from 1.
    pub column: u32,
}

/// Lines between two checkpoints.
const STRIDE: usize = 1024;

/// Lengths of lines, one to five bytes each, with a checkpoint every 1024 lines.
#[derive(Debug, Default)]
pub struct LineIndex {
    /// Lengths of finished lines, newline included, as little-endian base 128.
    lengths: Vec<u8>,
    /// Start of every 1024th line: byte offset in the input, place in `lengths`.
    checkpoints: Vec<(u64, usize)>,
    lines: usize,
    /// Offset of the line that is being read.
    line_start: u64,
    /// Offset of the next byte.
    next: u64,
}

impl LineIndex {
    /// Takes in the next bytes of the input.
    pub(crate) fn feed(&mut self, bytes: &[u8]) {
        for newline in memchr::memchr_iter(b'\n', bytes) {
            let end = self.next + newline as u64 + 1;
            if self.lines.is_multiple_of(STRIDE) {
                self.checkpoints.push((self.line_start, self.lengths.len()));
            }
            let mut length = end - self.line_start;
            while length >= 128 {
                self.lengths.push((length & 127) as u8 | 128);
                length >>= 7;
            }
            self.lengths.push(length as u8);
            self.lines += 1;
            self.line_start = end;
        }
        self.next += bytes.len() as u64;
    }

    /// Line and column of a byte; of the last line for offsets beyond what was read.
    pub fn position(&self, offset: u64) -> Position {
        let at = |line: usize, start: u64| Position {
            line: u32::try_from(line + 1).unwrap_or(u32::MAX),
            column: u32::try_from(offset - start + 1).unwrap_or(u32::MAX),
        };
        if offset >= self.line_start {
            return at(self.lines, self.line_start);
        }
        let checkpoint =
            self.checkpoints.partition_point(|(start, _)| *start <= offset).saturating_sub(1);
        let Some(&(mut start, mut place)) = self.checkpoints.get(checkpoint) else {
            return at(0, 0);
        };
        let mut line = checkpoint * STRIDE;
        while let Some((length, next)) = self.length_at(place) {
            if offset < start + length {
                break;
            }
            start += length;
            place = next;
            line += 1;
        }
        at(line, start)
    }

    /// The length at a place of `lengths`, and the place of the next.
    fn length_at(&self, mut place: usize) -> Option<(u64, usize)> {
        let (mut length, mut shift) = (0, 0);
        loop {
            let byte = *self.lengths.get(place)?;
            length |= u64::from(byte & 127) << shift;
            place += 1;
            shift += 7;
            if byte < 128 {
                return Some((length, place));
            }
        }
    }
}
