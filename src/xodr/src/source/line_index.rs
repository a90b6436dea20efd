//! From byte offsets to lines and columns.

use super::characters;
use std::ops::Range;

/// A place in a text file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// Line, from 1. Lines end with a line feed.
    pub line: u32,
    /// Column in bytes of the decoded text (UTF-8), from 1; a tab is one byte, a byte order mark none.
    pub column: u32,
}

/// Lines between two checkpoints: a look-up walks over at most so many lengths, a checkpoint costs 16 bytes.
const STRIDE: usize = 64;
/// Lines between two checkpoints where lengths are no longer kept.
const COARSE_STRIDE: usize = 1024;
/// Value bits in one byte of a stored length.
const BITS: u32 = 7;
/// Marks a byte of a stored length that another one follows.
const MORE: u8 = 1 << BITS;
/// Bytes of lengths that are kept: about 20 million lines. Bounds what a file of empty lines can ask for.
const LENGTHS: usize = 24 << 20;

/// Where the lines of a document begin: about five bytes for four lines, more for lines of 128 bytes and more.
///
/// Of lines beyond the first 24 MiB of lengths, one in 1,024 is kept. Places there are counted from that one: its line, and
/// the bytes since.
#[derive(Debug)]
pub struct LineIndex {
    /// Lengths of finished lines, line feed included, base 128, low digits first.
    lengths: Vec<u8>,
    checkpoints: Vec<Checkpoint>,
    /// Finished lines.
    lines: usize,
    /// Offset of the line that has not ended yet.
    line_start: u64,
    /// Offset of the next byte.
    next: u64,
    /// Bytes that `lengths` may have.
    capacity: usize,
}

/// A line from which look-ups start.
#[derive(Clone, Copy, Debug)]
struct Checkpoint {
    /// Its offset in the input.
    start: u64,
    /// Its length's place in `lengths`.
    place: u32,
    /// Its number, from 0.
    line: u32,
}

impl Default for LineIndex {
    fn default() -> Self {
        Self::with_capacity(LENGTHS)
    }
}

impl LineIndex {
    fn with_capacity(capacity: usize) -> Self {
        let (lengths, checkpoints) = (Vec::new(), Vec::new());
        Self { lengths, checkpoints, lines: 0, line_start: 0, next: 0, capacity }
    }

    /// Takes in the next bytes of the input. Yields whether they may have a character that XML does not allow, which is looked for in the same pass.
    pub(crate) fn feed(&mut self, bytes: &[u8]) -> bool {
        let next = self.next;
        let may_be_illegal = characters::look(bytes, |at| self.line(next + at as u64 + 1));
        self.next += bytes.len() as u64;
        may_be_illegal
    }

    fn line(&mut self, end: u64) {
        let is_kept = self.lengths.len() < self.capacity;
        if self.lines.is_multiple_of(if is_kept { STRIDE } else { COARSE_STRIDE }) {
            // Of lines beyond 32 bits, places say the largest number.
            let number = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
            let (place, line) = (number(self.lengths.len()), number(self.lines));
            self.checkpoints.push(Checkpoint { start: self.line_start, place, line });
        }
        if is_kept {
            let mut length = end - self.line_start;
            while length >= u64::from(MORE) {
                self.lengths.push(length as u8 | MORE);
                length >>= BITS;
            }
            self.lengths.push(length as u8);
        }
        self.lines += 1;
        self.line_start = end;
    }

    /// Bytes taken in.
    pub(super) fn bytes(&self) -> u64 {
        self.next
    }

    /// What is known of the lines that hold a stretch of the text: its places are the same.
    pub(super) fn part(&self, stretch: Range<u64>) -> Self {
        let after = |offset: u64| self.checkpoints.partition_point(|known| known.start <= offset);
        let (first, end) = (after(stretch.start).saturating_sub(1), after(stretch.end));
        let place = |known: &Checkpoint| known.place as usize;
        let base = self.checkpoints.get(first).map_or(self.lengths.len(), place);
        let mut part = Self { capacity: self.capacity, next: self.next, ..Self::default() };
        (part.lines, part.line_start) = (self.lines, self.line_start);
        let mut behind = self.lengths.len();
        if let Some(known) = self.checkpoints.get(end) {
            (part.lines, part.line_start, behind) =
                (known.line as usize, known.start, place(known));
        }
        part.lengths.extend_from_slice(self.lengths.get(base..behind).unwrap_or_default());
        let own = self.checkpoints.get(first..end).unwrap_or_default().iter();
        part.checkpoints.extend(own.map(|k| Checkpoint { place: k.place - base as u32, ..*k }));
        part
    }

    /// Line and column of the byte at an offset of the decoded text.
    ///
    /// Offsets beyond what was read count as in the last line.
    pub fn position(&self, offset: u64) -> Position {
        let at = |line: usize, start: u64| Position {
            line: u32::try_from(line + 1).unwrap_or(u32::MAX),
            column: u32::try_from((offset - start).saturating_add(1)).unwrap_or(u32::MAX),
        };
        if offset >= self.line_start {
            return at(self.lines, self.line_start);
        }
        let after = self.checkpoints.partition_point(|checkpoint| checkpoint.start <= offset);
        let Some(checkpoint) = self.checkpoints.get(after.saturating_sub(1)) else {
            return at(0, 0);
        };
        let (mut start, mut line) = (checkpoint.start, checkpoint.line as usize);
        let mut lengths = self.lengths.get(checkpoint.place as usize..).unwrap_or_default();
        while let Some((eight, _)) = lengths.split_first_chunk()
            && let Some(several) = SeveralLines::of(u64::from_le_bytes(*eight))
            && offset >= start + several.length
        {
            start += several.length;
            line += several.lines;
            lengths = lengths.get(several.bytes..).unwrap_or_default();
        }
        let (mut length, mut shift) = (0, 0);
        for byte in lengths {
            length |= u64::from(byte & !MORE) << shift;
            shift += BITS;
            if *byte >= MORE {
                continue;
            }
            if offset < start + length {
                break;
            }
            start += length;
            line += 1;
            (length, shift) = (0, 0);
        }
        at(line, start)
    }
}

/// The lines whose lengths stand in the next eight bytes as a whole.
struct SeveralLines {
    lines: usize,
    /// Of all together.
    length: u64,
    /// Of what is stored of them.
    bytes: usize,
}

impl SeveralLines {
    /// None where a line has 16 KiB or more.
    #[inline]
    fn of(eight: u64) -> Option<Self> {
        const MORES: u64 = u64::from_ne_bytes([MORE; 8]);
        const ONES: u64 = u64::from_ne_bytes([1; 8]);
        let more = eight & MORES;
        if more & (more << u8::BITS) != 0 {
            return None;
        }
        // Of a length that goes on behind the eight bytes nothing is taken.
        let bytes =
            if more.leading_zeros() == 0 { u64::BITS / u8::BITS - 1 } else { u64::BITS / u8::BITS };
        let more = more & (u64::MAX >> 1);
        let taken = eight & !MORES & (u64::MAX >> (u64::BITS - u8::BITS * bytes));
        // 1 in each byte with upper digits, which is one behind a mark.
        let upper = more << 1;
        let is_upper = (upper << BITS) - upper;
        let length = sum_of_bytes(taken & !is_upper) + (sum_of_bytes(taken & is_upper) << BITS);
        let marks = (more >> BITS).wrapping_mul(ONES) >> (u64::BITS - u8::BITS);
        let bytes = bytes as usize;
        Some(Self { lines: bytes - marks as usize, length, bytes })
    }
}

/// Sum of eight bytes.
#[inline]
fn sum_of_bytes(eight: u64) -> u64 {
    // Every second byte, and 1 in each of four pairs.
    const EVEN: u64 = 0x00ff_00ff_00ff_00ff;
    const ONES: u64 = 0x0001_0001_0001_0001;
    let pairs = (eight & EVEN) + (eight >> u8::BITS & EVEN);
    pairs.wrapping_mul(ONES) >> 48
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines of many lengths, so that lengths of one, two and three bytes and several checkpoints occur.
    fn text() -> Vec<u8> {
        let mut text = Vec::new();
        for line in 0..3000_usize {
            let length = if line == 1500 { 40_000 } else { line * 7 % 300 };
            text.extend(std::iter::repeat_n(b'x', length));
            text.push(b'\n');
        }
        text.extend_from_slice(b"end");
        text
    }

    #[test]
    fn positions_are_those_of_counting() {
        let text = text();
        let mut index = LineIndex::default();
        for piece in text.chunks(997) {
            index.feed(piece);
        }
        let (mut line, mut column) = (1, 1);
        for (offset, byte) in text.iter().enumerate() {
            if offset % 13 == 0 || *byte == b'\n' {
                assert_eq!(index.position(offset as u64), Position { line, column }, "{offset}");
            }
            (line, column) = if *byte == b'\n' { (line + 1, 1) } else { (line, column + 1) };
        }
    }

    #[test]
    fn places_in_a_part_are_those_of_the_whole() {
        let text = text();
        for capacity in [100, 2000, LENGTHS] {
            let mut index = LineIndex::with_capacity(capacity);
            index.feed(&text);
            let length = text.len() as u64;
            for from in [0, 1, 63, 5_000, 9_999, length / 2, length - 1_000, length - 1] {
                for to in [from, from + 1, from + 777, from + 100_000].map(|to| to.min(length)) {
                    let part = index.part(from..to);
                    for offset in (from..=to).step_by(97).chain([to]) {
                        assert_eq!(part.position(offset), index.position(offset), "{offset}");
                    }
                }
            }
        }
        assert_eq!(LineIndex::default().part(0..9).position(3), Position { line: 1, column: 4 });
    }

    #[test]
    fn beyond_its_capacity_it_counts_from_the_last_checkpoint() {
        let mut index = LineIndex::with_capacity(100);
        index.feed(&[b'\n'; 5000]);
        assert_eq!(index.position(50), Position { line: 51, column: 1 });
        assert_eq!(index.position(2049), Position { line: 2049, column: 2 });
        assert_eq!(index.position(5000), Position { line: 5001, column: 1 });
        assert!(index.lengths.len() <= 101);
    }
}
