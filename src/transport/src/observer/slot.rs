//! What a slot of a record says, as words.

use super::WORDS;
use super::page::Words;
use crate::payload::{Chunk64, GenerationInfo};

/// Longest name of a segment \[bytes\].
const NAME_BYTES: usize = 8 * (OVERLAY - NAME);

const CHECKSUM: usize = 0;
const SEQUENCE: usize = 1;
const GENERATION: usize = 2;
const LENGTH: usize = 3;
const PUBLISHED: usize = 4;
const PID: usize = 5;
const LAYOUT: usize = 6;
const CONTENT: usize = 10;
const INPUT: usize = 14;
const OFFSET: usize = 18;
const INODE: usize = 19;
const NAME_LENGTH: usize = 20;
const NAME: usize = 21;
/// The overlay's revision, or 0; then its length, inode and content hash.
const OVERLAY: usize = 48;
const OVERLAY_LENGTH: usize = OVERLAY + 1;
const OVERLAY_INODE: usize = OVERLAY + 2;
const OVERLAY_CONTENT: usize = OVERLAY + 3;

/// Where the bytes of a generation lie.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SegmentLocation {
    /// Name of the file in the folder of shared memory.
    pub segment: String,
    /// Its inode: names may come back, files do not.
    pub inode: u64,
    /// Where the bytes begin in it; a multiple of 64 \[bytes\].
    pub offset: u64,
    /// The overlay that was made for this generation; `None` if nothing is laid over it.
    pub overlay: Option<OverlayLocation>,
}

/// Where the bytes of an overlay lie: in a file of the root folder that is named after map and revision, from its start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OverlayLocation {
    /// Rises with every overlay of a map that is published, also with one that says the same for another generation. At least 1.
    pub revision: u64,
    /// Exact length \[bytes\].
    pub length: u64,
    /// The file's inode.
    pub inode: u64,
    /// Hash of the overlay's content; opaque here.
    pub content_hash: [u8; 32],
}

/// What a slot says.
#[derive(Clone, Debug, PartialEq, Eq)]
#[expect(clippy::large_enum_variant, reason = "there is one for each record")]
pub(super) enum SlotContent {
    /// Nothing is served.
    Nothing,
    /// A generation is served.
    Served(GenerationInfo, SegmentLocation),
}

/// Words of a slot.
///
/// Errors: what cannot be written down, in words.
pub(super) fn encode(sequence: u32, said: &SlotContent) -> Result<Words, &'static str> {
    let mut words = [0; WORDS];
    words[SEQUENCE] = sequence.into();
    if let SlotContent::Served(info, place) = said {
        words[GENERATION] = info.generation;
        words[LENGTH] = info.length;
        words[PUBLISHED] = info.published_unix_ns;
        words[PID] = info.daemon_pid;
        put(&mut words[LAYOUT..CONTENT], &info.layout_id);
        put(&mut words[CONTENT..INPUT], &info.content_hash);
        put(&mut words[INPUT..OFFSET], &info.input_hash);
        words[OFFSET] = place.offset;
        words[INODE] = place.inode;
        words[NAME_LENGTH] = place.segment.len() as u64;
        if place.segment.len() > NAME_BYTES {
            return Err("the segment's name is too long");
        }
        put(&mut words[NAME..OVERLAY], place.segment.as_bytes());
        if let Some(overlay) = &place.overlay {
            words[OVERLAY] = overlay.revision;
            words[OVERLAY_LENGTH] = overlay.length;
            words[OVERLAY_INODE] = overlay.inode;
            put(&mut words[OVERLAY_CONTENT..], &overlay.content_hash);
        }
    }
    words[CHECKSUM] = checksum(&words);
    // Whatever readers would refuse is not published.
    decode(sequence, &words, "").map(|_| words)
}

/// What the words of a slot say. Segments of other domains than `prefix` are refused.
///
/// Errors: why they say nothing.
pub(super) fn decode(
    sequence: u32,
    words: &Words,
    prefix: &str,
) -> Result<SlotContent, &'static str> {
    if sequence == 0 {
        return Ok(SlotContent::Nothing);
    }
    if words[CHECKSUM] != checksum(words) {
        return Err("its checksum is wrong");
    }
    if words[SEQUENCE] != u64::from(sequence) {
        return Err("its sequence is that of another slot");
    }
    if words[GENERATION] == 0 {
        return Ok(SlotContent::Nothing);
    }
    let (length, offset) = (words[LENGTH], words[OFFSET]);
    if length == 0 || offset % align_of::<Chunk64>() as u64 != 0 {
        return Err("bytes of no length, or in no place");
    }
    // Room to spare for rounding up to pages.
    if length.checked_add(offset).is_none_or(|end| end > i64::MAX as u64 / 2) {
        return Err("longer than any file");
    }
    let name_length = usize::try_from(words[NAME_LENGTH]).unwrap_or(usize::MAX);
    let name = get::<NAME_BYTES>(&words[NAME..OVERLAY]);
    let name = name.get(..name_length).ok_or("the segment's name is too long")?;
    let plain = |byte: &u8| byte.is_ascii_alphanumeric() || matches!(byte, b'.' | b'_' | b'-');
    let is_plain = !name.is_empty() && name[0] != b'.' && name.iter().all(plain);
    let Some(segment) = std::str::from_utf8(name).ok().filter(|_| is_plain) else {
        return Err("the segment's name is no plain name");
    };
    if !segment.starts_with(prefix) {
        return Err("the segment is one of another domain");
    }
    let info = GenerationInfo {
        generation: words[GENERATION],
        length,
        published_unix_ns: words[PUBLISHED],
        daemon_pid: words[PID],
        layout_id: get(&words[LAYOUT..CONTENT]),
        content_hash: get(&words[CONTENT..INPUT]),
        input_hash: get(&words[INPUT..OFFSET]),
    };
    let overlay = overlay(words)?;
    let segment = segment.to_owned();
    Ok(SlotContent::Served(info, SegmentLocation { segment, inode: words[INODE], offset, overlay }))
}

/// What the words of a slot say of an overlay.
fn overlay(words: &Words) -> Result<Option<OverlayLocation>, &'static str> {
    if words[OVERLAY] == 0 {
        return Ok(None);
    }
    let length = words[OVERLAY_LENGTH];
    if length == 0 || length > i64::MAX as u64 / 2 {
        return Err("an overlay of no length, or longer than any file");
    }
    Ok(Some(OverlayLocation {
        revision: words[OVERLAY],
        length,
        inode: words[OVERLAY_INODE],
        content_hash: get(&words[OVERLAY_CONTENT..]),
    }))
}

/// Whether a slot says that nothing is served.
pub(super) fn says_nothing(words: &Words) -> bool {
    words[GENERATION] == 0
}

/// FNV-1a over all words but the first, byte by byte: each step can be undone, so that any one changed byte is seen.
fn checksum(words: &Words) -> u64 {
    const START: u64 = 0xcbf2_9ce4_8422_2325;
    const FACTOR: u64 = 0x0100_0000_01b3;
    // Bytes of 0 only multiply; of most slots half the words are 0.
    const ZERO_WORD: u64 = FACTOR.wrapping_pow(8);
    let step = |sum: u64, byte: u8| (sum ^ u64::from(byte)).wrapping_mul(FACTOR);
    words[SEQUENCE..].iter().fold(START, |sum, word| match word {
        0 => sum.wrapping_mul(ZERO_WORD),
        word => word.to_le_bytes().into_iter().fold(sum, step),
    })
}

fn put(words: &mut [u64], bytes: &[u8]) {
    for (word, part) in words.iter_mut().zip(bytes.chunks(8)) {
        let mut eight = [0; 8];
        eight[..part.len()].copy_from_slice(part);
        *word = u64::from_le_bytes(eight);
    }
}

fn get<const N: usize>(words: &[u64]) -> [u8; N] {
    let mut bytes = [0; N];
    for (part, word) in bytes.chunks_mut(8).zip(words) {
        part.copy_from_slice(&word.to_le_bytes()[..part.len()]);
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said() -> SlotContent {
        let info = GenerationInfo {
            generation: u64::MAX,
            length: 100,
            published_unix_ns: 2,
            daemon_pid: 3,
            layout_id: std::array::from_fn(|i| i as u8),
            content_hash: [0xff; 32],
            input_hash: [0xa0; 32],
        };
        let segment = "mapd_1f_42.data".to_owned();
        let overlay =
            OverlayLocation { revision: 9, length: 10, inode: 11, content_hash: [0x5a; 32] };
        SlotContent::Served(
            info,
            SegmentLocation { segment, inode: 7, offset: 384, overlay: Some(overlay) },
        )
    }

    fn with_overlay(overlay: Option<OverlayLocation>) -> SlotContent {
        let SlotContent::Served(info, place) = said() else { unreachable!() };
        SlotContent::Served(info, SegmentLocation { overlay, ..place })
    }

    #[test]
    fn what_is_written_is_read() {
        for (sequence, said) in
            [(1, said()), (u32::MAX, said()), (2, SlotContent::Nothing), (3, with_overlay(None))]
        {
            let words = encode(sequence, &said).expect("can be said");
            assert_eq!(decode(sequence, &words, "mapd_"), Ok(said));
        }
        assert_eq!(
            decode(0, &[u64::MAX; WORDS], ""),
            Ok(SlotContent::Nothing),
            "nothing was published"
        );
    }

    #[test]
    fn a_slot_with_a_changed_bit_says_nothing() {
        let words = encode(5, &said()).expect("can be said");
        for bit in 0..64 * WORDS {
            let mut changed = words;
            changed[bit / 64] ^= 1 << (bit % 64);
            assert!(decode(5, &changed, "").is_err(), "bit {bit}");
        }
        for bit in 0..32 {
            let other = 5 ^ (1 << bit);
            assert!(decode(other, &words, "").is_err(), "sequence {other}");
        }
    }

    #[test]
    fn the_checksum_is_that_of_all_bytes() {
        for said in [said(), with_overlay(None), SlotContent::Nothing] {
            let words = encode(1, &said).expect("can be said");
            let bytes = words[SEQUENCE..].iter().flat_map(|word| word.to_le_bytes());
            let sum = bytes.fold(0xcbf2_9ce4_8422_2325, |sum: u64, byte| {
                (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
            });
            assert_eq!(words[CHECKSUM], sum);
        }
    }

    /// A forged record with a checksum that fits leads no further than the domain's own files.
    #[test]
    fn what_must_not_be_said_is_refused() {
        let name = |name: &str| {
            let SlotContent::Served(info, place) = said() else { unreachable!() };
            SlotContent::Served(info, SegmentLocation { segment: name.to_owned(), ..place })
        };
        let long = "m".repeat(NAME_BYTES + 1);
        for bad in ["", ".", "..", ".hidden", "a/b", "../x", "a\0b", "stra\u{df}e", " x", &long] {
            assert!(encode(1, &name(bad)).is_err(), "{bad}");
        }
        let longest = "m".repeat(NAME_BYTES);
        assert!(encode(1, &name(&longest)).is_ok());
        let words = encode(1, &name("other_1.data")).expect("a plain name");
        assert!(decode(1, &words, "mapd_").is_err(), "of another domain");
        for (length, offset) in [(0, 384), (1, 1), (u64::MAX, 64), (1, u64::MAX - 63)] {
            let SlotContent::Served(info, place) = said() else { unreachable!() };
            let said = SlotContent::Served(
                GenerationInfo { length, ..info },
                SegmentLocation { offset, ..place },
            );
            assert!(encode(1, &said).is_err(), "{length} bytes at {offset}");
        }
        for length in [0, u64::MAX] {
            let overlay = OverlayLocation { revision: 1, length, inode: 1, content_hash: [0; 32] };
            assert!(encode(1, &with_overlay(Some(overlay))).is_err(), "overlay of {length} bytes");
        }
    }
}
