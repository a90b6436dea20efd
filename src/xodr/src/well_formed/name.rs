//! Names. (XML 1.0, 2.3)

/// Bits of [`CLASS`].
const START: u8 = 1;
const REST: u8 = 2;
const WIDE: u8 = 4;

/// What each byte may be in a name. Bytes of characters beyond ASCII may be anything here; `is_name` looks at them.
const CLASS: [u8; 256] = {
    let mut class = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        class[byte] = match byte as u8 {
            b'A'..=b'Z' | b'a'..=b'z' | b'_' | b':' => START | REST,
            0x80.. => START | REST | WIDE,
            b'0'..=b'9' | b'-' | b'.' => REST,
            _ => 0,
        };
        byte += 1;
    }
    class
};

/// What a text begins with, as far as it may belong to a name.
pub(super) struct Head {
    /// Its bytes.
    pub(super) len: usize,
    /// Whether they are a name.
    pub(super) is_name: bool,
}

/// The beginning of a text that may belong to a name, looked at once.
#[inline]
pub(super) fn head(text: &[u8]) -> Head {
    let (mut len, mut classes) = (0, 0);
    for byte in text {
        let class = CLASS[usize::from(*byte)];
        if class & REST == 0 {
            break;
        }
        classes |= class;
        len += 1;
    }
    let starts = text.first().is_some_and(|first| CLASS[usize::from(*first)] & START != 0);
    let is_name = starts && (classes & WIDE == 0 || is_wide_name(&text[..len]));
    Head { len, is_name }
}

/// Whether a text is a name.
#[inline]
pub fn is_name(text: &[u8]) -> bool {
    let head = head(text);
    head.is_name && head.len == text.len()
}

#[cold]
fn is_wide_name(text: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(text) else { return false };
    text.chars()
        .enumerate()
        .all(|(at, character)| is_start(character) || (at > 0 && is_rest(character)))
}

/// NameStartChar.
fn is_start(character: char) -> bool {
    matches!(character,
        ':' | '_' | 'A'..='Z' | 'a'..='z' | '\u{c0}'..='\u{d6}' | '\u{d8}'..='\u{f6}' | '\u{f8}'..='\u{2ff}'
        | '\u{370}'..='\u{37d}' | '\u{37f}'..='\u{1fff}' | '\u{200c}'..='\u{200d}' | '\u{2070}'..='\u{218f}'
        | '\u{2c00}'..='\u{2fef}' | '\u{3001}'..='\u{d7ff}' | '\u{f900}'..='\u{fdcf}' | '\u{fdf0}'..='\u{fffd}'
        | '\u{10000}'..='\u{effff}')
}

/// NameChar that is no NameStartChar.
fn is_rest(character: char) -> bool {
    matches!(character, '-' | '.' | '0'..='9' | '\u{b7}' | '\u{300}'..='\u{36f}' | '\u{203f}'..='\u{2040}')
}
