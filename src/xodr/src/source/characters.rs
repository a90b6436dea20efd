//! Which characters XML allows. (XML 1.0, 2.2)

/// Whether a character may stand in a document, as itself or as a reference.
pub(crate) fn is_legal(character: char) -> bool {
    matches!(character, '\t' | '\n' | '\r' | ' '..='\u{d7ff}' | '\u{e000}'..='\u{fffd}' | '\u{10000}'..)
}

/// Whether UTF-8 text has a control character that is not allowed, or may have one of the two other characters that are
/// not: U+FFFE and U+FFFF. Costs half an instruction a byte.
pub(super) fn may_be_illegal(text: &[u8]) -> bool {
    // Branch-free and one pass, so that it is compiled to vector instructions.
    let (control, all) = text.iter().fold((0_u8, 0_u8), |(found, all), &byte| {
        let is_control = u8::from(byte < b' ');
        let is_space = u8::from(byte == b'\t') | u8::from(byte == b'\n') | u8::from(byte == b'\r');
        (found | (is_control & (is_space ^ 1)), all | byte)
    });
    control != 0 || (!all.is_ascii() && memchr::memmem::find(text, b"\xef\xbf").is_some())
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
            assert!(is_legal(character) || may_be_illegal(&bytes), "{character:?}");
        }
        assert!(!may_be_illegal("a\tb\r\nä€😀\u{7f}\u{85}".as_bytes()));
    }
}
