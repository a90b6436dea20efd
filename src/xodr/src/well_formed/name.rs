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
    let len = letters(text);
    match text.get(len) {
        // Nearly all names are nothing but letters.
        Some(end) if CLASS[usize::from(*end)] & REST == 0 => Head { len, is_name: len > 0 },
        _ => any_head(text),
    }
}

/// How many letters of ASCII a text begins with, as far as it goes on for eight bytes.
#[inline]
fn letters(text: &[u8]) -> usize {
    const ONES: u64 = u64::from_le_bytes([1; 8]);
    const HIGH: u64 = ONES << 7;
    let (eights, _) = text.as_chunks::<8>();
    let mut len = 0;
    for eight in eights {
        let word = u64::from_le_bytes(*eight);
        // In lower case, without the highest bits, so that sums stay within their bytes.
        let lower = (word | ONES << 5) & !HIGH;
        let from_a = lower + ONES * u64::from(0x80 - b'a');
        let behind_z = lower + ONES * u64::from(0x7f - b'z');
        let others = !(from_a & !behind_z & !word) & HIGH;
        len += others.trailing_zeros() as usize / 8;
        if others != 0 {
            break;
        }
    }
    len
}

/// As [`head`], byte by byte.
#[inline(never)]
fn any_head(text: &[u8]) -> Head {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Names of letters alone are read eight bytes at a time: all are what they are byte by byte.
    #[test]
    fn names_of_letters_are_read_as_any() {
        for length in 0..20 {
            let letters: Vec<u8> =
                (b'A'..=b'Z').chain(b'a'..=b'z').cycle().skip(length * 5).take(length).collect();
            for byte in 0..=u8::MAX {
                for at in 0..=length {
                    for tail in ["", "=\"1\" b=\"2\"", "x"] {
                        let text =
                            [&letters[..at], &[byte], &letters[at..], tail.as_bytes()].concat();
                        let (one, other) = (head(&text), any_head(&text));
                        assert_eq!((one.len, one.is_name), (other.len, other.is_name), "{text:?}");
                    }
                }
            }
        }
    }
}
