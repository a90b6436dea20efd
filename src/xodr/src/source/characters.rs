//! Which characters XML allows. (XML 1.0, 2.2)

use wide::u8x16;

/// Whether a character may stand in a document, as itself or as a reference.
pub(crate) fn is_legal(character: char) -> bool {
    matches!(character, '\t' | '\n' | '\r' | ' '..='\u{d7ff}' | '\u{e000}'..='\u{fffd}' | '\u{10000}'..)
}

/// Bytes that are looked at together, a bit for each.
const BLOCK: usize = u64::BITS as usize;
/// Bytes of them that one instruction compares.
const LANES: usize = 16;

/// Passes over UTF-8 text once. Calls `line_feed` with the place of each line feed. Yields whether the text has a control character that is not
/// allowed, or may have one of the two other characters that are not: U+FFFE and U+FFFF.
pub(super) fn look(text: &[u8], mut line_feed: impl FnMut(usize)) -> bool {
    let (mut all, mut is_illegal, mut at) = (u8x16::ZERO, false, 0);
    let mut each = |block: &[u8; BLOCK]| {
        let (mut line_feeds, mut controls) = (0, 0);
        for (place, bytes) in block.as_chunks().0.iter().enumerate() {
            let bytes = u8x16::new(*bytes);
            let bits = |found: u8x16| u64::from(found.to_bitmask()) << (place * LANES);
            line_feeds |= bits(bytes.simd_eq(u8x16::splat(b'\n')));
            controls |= bits(bytes.min(u8x16::splat(b' ' - 1)).simd_eq(bytes));
            all |= bytes;
        }
        is_illegal |= controls != line_feeds && has_illegal_control(block);
        while line_feeds != 0 {
            line_feed(at + line_feeds.trailing_zeros() as usize);
            line_feeds &= line_feeds - 1;
        }
        at += BLOCK;
    };
    let (blocks, rest) = text.as_chunks::<BLOCK>();
    blocks.iter().for_each(&mut each);
    let mut last = [b' '; BLOCK];
    if let Some(room) = last.get_mut(..rest.len()) {
        room.copy_from_slice(rest);
    }
    each(&last);
    let is_ascii = all.to_bitmask() == 0;
    is_illegal || (!is_ascii && memchr::memmem::find(text, b"\xef\xbf").is_some())
}

/// Whether there is a control character that is not allowed. Branch-free, so that it is compiled to vector instructions.
fn has_illegal_control(block: &[u8; BLOCK]) -> bool {
    block.iter().fold(false, |found, &byte| {
        let is_space = (byte == b'\t') | (byte == b'\n') | (byte == b'\r');
        found | ((byte < b' ') & !is_space)
    })
}

/// The first control character from 80 to 9F hex.
pub(super) fn find_c1(text: &[u8]) -> Option<usize> {
    memchr::memchr_iter(0xc2, text)
        .find(|at| text.get(at + 1).is_some_and(|byte| (0x80..0xa0).contains(byte)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_illegal_character_is_noticed() {
        for character in '\0'..=char::MAX {
            let mut bytes = [b'x'; 40];
            let mut buffer = [0; 4];
            let text = character.encode_utf8(&mut buffer).as_bytes();
            bytes[20..20 + text.len()].copy_from_slice(text);
            assert!(is_legal(character) || look(&bytes, |_| ()), "{character:?}");
        }
        assert!(!look("a\tb\r\nä€😀\u{7f}\u{85}".as_bytes(), |_| ()));
    }

    #[test]
    fn each_line_feed_and_control_is_found_wherever_it_stands() {
        for length in [0, 1, 15, 16, 63, 64, 65, 128, 200] {
            for at in 0..length {
                for byte in 0..=b' ' {
                    let mut text = vec![b'x'; length];
                    text[at] = byte;
                    text[length / 2] = b'\n';
                    let mut found = Vec::new();
                    let is_illegal = look(&text, |at| found.push(at));
                    let feeds = (0..length).filter(|at| text[*at] == b'\n').collect::<Vec<_>>();
                    assert_eq!(found, feeds, "{byte} at {at} of {length}");
                    assert_eq!(is_illegal, text.iter().any(|byte| !is_legal(char::from(*byte))));
                }
            }
        }
    }
}
