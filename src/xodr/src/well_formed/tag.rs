//! The attributes of one tag.

use super::fault::{Fault, Faults};
use super::name::head;
use super::text::references;
use std::collections::HashSet;

/// An attribute as written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Attribute<'t> {
    /// Its name with prefix.
    pub name: &'t [u8],
    /// Its value between the quotes, references not resolved.
    pub value: &'t [u8],
    /// Place of the name in the tag's content.
    pub name_at: usize,
    /// Place of the value in the tag's content.
    pub value_at: usize,
}

/// Splits the content of a tag (from behind `<` up to before `>` or `/>`) into attributes, and finds what is not well-formed
/// in it. After a fault it goes on with the next attribute.
///
/// ```
/// use mapd_xodr::well_formed::{Attributes, Faults};
///
/// let mut faults = Faults::default();
/// let mut attributes = Attributes::new(b"road id='1'length='2'", 1, &mut faults);
/// assert_eq!(attributes.next(&mut faults).unwrap().value, b"1");
/// assert_eq!(attributes.next(&mut faults).unwrap().name, b"length");
/// assert!(attributes.next(&mut faults).is_none());
/// assert_eq!(faults.take().len(), 1);
/// ```
#[derive(Clone, Debug)]
pub struct Attributes<'t> {
    content: &'t [u8],
    /// Bytes of the element's name.
    name: usize,
    /// Where the next attribute is looked for.
    place: usize,
    /// Offset of the content in the document.
    base: u64,
}

#[inline]
fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\n' | b'\t' | b'\r')
}

impl<'t> Attributes<'t> {
    /// Begins with the element's name. `base` is the offset of the content in the document: one more than that of `<`.
    #[inline]
    pub fn new(content: &'t [u8], base: u64, faults: &mut Faults) -> Self {
        let head = head(content);
        let mut name = head.len;
        let ends = content.get(name).is_none_or(|byte| is_space(*byte));
        if !head.is_name || !ends {
            faults.add(base, Fault::Name);
            let rest = &content[name..];
            name += rest.iter().position(|byte| is_space(*byte)).unwrap_or(rest.len());
        }
        Self { content, name, place: name, base }
    }

    /// The element's name with prefix.
    #[inline]
    pub fn element(&self) -> &'t [u8] {
        &self.content[..self.name]
    }

    /// The next attribute; none at the end of the tag.
    #[inline]
    pub fn next(&mut self, faults: &mut Faults) -> Option<Attribute<'t>> {
        if self.place >= self.content.len() {
            return None;
        }
        match self.plain() {
            Some(attribute) => Some(attribute),
            None => self.any(faults),
        }
    }

    /// The next attribute if it is written as nearly all are: behind one space, with nothing but a name before `="`, and no `<` or `&` in its value.
    #[inline]
    fn plain(&mut self) -> Option<Attribute<'t>> {
        let [b' ', named @ ..] = self.content.get(self.place..)? else { return None };
        let head = head(named);
        let (name, valued) = named.split_at_checked(head.len).filter(|_| head.is_name)?;
        let [b'=', b'"', quoted @ ..] = valued else { return None };
        let (value, rest) = quoted.split_at_checked(value_end(b'"', quoted)?)?;
        rest.first().filter(|end| **end == b'"')?;
        let name_at = self.place + 1;
        let value_at = name_at + name.len() + 2;
        self.place = value_at + value.len() + 1;
        Some(Attribute { name, value, name_at, value_at })
    }

    /// The next attribute, however it is written.
    #[inline(never)]
    fn any(&mut self, faults: &mut Faults) -> Option<Attribute<'t>> {
        let content = self.content;
        loop {
            let before = self.place;
            while is_space(*content.get(self.place)?) {
                self.place += 1;
            }
            let name_at = self.place;
            let head = head(&content[name_at..]);
            let mut place = name_at + head.len;
            let name = &content[name_at..place];
            if !head.is_name {
                faults.add(self.base + name_at as u64, Fault::Name);
                if name.is_empty() {
                    self.skip_word();
                    continue;
                }
            }
            if before == name_at {
                faults.add(self.base + name_at as u64, Fault::NoSpace);
            }
            if content.get(place) != Some(&b'=') {
                place = self.skip_space(place);
                if content.get(place) != Some(&b'=') {
                    faults.add(self.base + name_at as u64, Fault::NoValue);
                    self.place = name_at + name.len();
                    if self.place < content.len() && !is_space(content[self.place]) {
                        self.skip_word();
                    }
                    continue;
                }
            }
            place += 1;
            if !matches!(content.get(place), Some(b'"' | b'\'')) {
                place = self.skip_space(place);
            }
            let Some(quote) = content.get(place).copied() else {
                faults.add(self.base + name_at as u64, Fault::NoValue);
                self.place = content.len();
                return None;
            };
            if !matches!(quote, b'"' | b'\'') {
                faults.add(self.base + place as u64, Fault::NoQuotes);
                self.place = place;
                self.skip_word();
                let value = &content[place..self.place];
                return Some(Attribute { name, value, name_at, value_at: place });
            }
            let value_at = place + 1;
            let value = self.value(value_at, quote, faults);
            self.place = (value_at + value.len() + 1).min(content.len());
            return Some(Attribute { name, value, name_at, value_at });
        }
    }

    /// The value that ends with `quote`.
    #[inline]
    fn value(&self, value_at: usize, quote: u8, faults: &mut Faults) -> &'t [u8] {
        let rest = &self.content[value_at..];
        match value_end(quote, rest) {
            Some(end) if rest[end] == quote => &rest[..end],
            _ => self.unusual_value(value_at, quote, faults),
        }
    }

    /// A value with `<` or `&` in it, or without an end.
    #[cold]
    fn unusual_value(&self, value_at: usize, quote: u8, faults: &mut Faults) -> &'t [u8] {
        let rest = &self.content[value_at..];
        let base = self.base + value_at as u64;
        let end = memchr::memchr(quote, rest).unwrap_or_else(|| {
            faults.add(base, Fault::NoClosingQuote);
            rest.len()
        });
        let value = &rest[..end];
        for at in memchr::memchr_iter(b'<', value) {
            faults.add(base + at as u64, Fault::LessThan);
        }
        references(value, base, faults);
        value
    }

    fn skip_space(&self, from: usize) -> usize {
        let rest = &self.content[from..];
        from + rest.iter().position(|byte| !is_space(*byte)).unwrap_or(rest.len())
    }

    /// Goes on at the next white space, at least one byte further.
    fn skip_word(&mut self) {
        let rest = &self.content[self.place..];
        let len = rest.iter().skip(1).position(|byte| is_space(*byte));
        self.place += len.map_or(rest.len(), |len| len + 1);
    }
}

/// Words of eight bytes in which the end of a value is looked for here: most are that short, and a call costs as much.
const WORDS: usize = 4;

/// Where the first of a quote, `<` and `&` stands.
#[inline]
fn value_end(quote: u8, text: &[u8]) -> Option<usize> {
    if quote == b'"' {
        for (number, eight) in text.as_chunks().0.iter().take(WORDS).enumerate() {
            if let Some(at) = first_special(*eight) {
                return Some(8 * number + at);
            }
        }
        if text.len() < 8 {
            return text.iter().position(|byte| matches!(byte, b'"' | b'<' | b'&'));
        }
        // Of the last eight bytes, those that were looked at already are none of them.
        if let Some(last) = text.last_chunk().filter(|_| text.len() < 8 * (WORDS + 1)) {
            return first_special(*last).map(|at| text.len() - 8 + at);
        }
    }
    memchr::memchr3(quote, b'<', b'&', text)
}

/// The first `"`, `<` or `&` of eight bytes.
#[inline]
fn first_special(bytes: [u8; 8]) -> Option<usize> {
    const ONES: u64 = u64::from_le_bytes([1; 8]);
    let word = u64::from_le_bytes(bytes);
    // `"` and `&` differ in one bit. Of bytes that are zero, the lowest is told for certain.
    let quotes = (word & (ONES * 0xfb)) ^ (ONES * u64::from(b'"'));
    let less = word ^ (ONES * u64::from(b'<'));
    let zeros = (quotes.wrapping_sub(ONES) & !quotes) | (less.wrapping_sub(ONES) & !less);
    let zeros = zeros & (ONES * 0x80);
    (zeros != 0).then(|| zeros.trailing_zeros() as usize / 8)
}

/// Attributes that are compared pair by pair; beyond them a hash set is faster.
const PAIRS: usize = 16;

/// Finds attributes whose name an earlier one has. `names` are names and their places in the document. Takes time in
/// proportion to their number, even for a hundred thousand.
pub fn duplicates(names: &[(&[u8], u64)], faults: &mut Faults) {
    if names.len() <= PAIRS {
        for (at, (name, start)) in names.iter().enumerate() {
            if names[..at].iter().any(|(earlier, _)| earlier == name) {
                faults.add(*start, Fault::Duplicate);
            }
        }
        return;
    }
    let mut seen = HashSet::with_capacity(names.len());
    for (name, start) in names {
        if !seen.insert(*name) {
            faults.add(*start, Fault::Duplicate);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Attributes as most are written are read apart from others: both ways give the same.
    #[test]
    fn plain_attributes_are_read_as_any() {
        let contents = [
            "a b=\"1\" c=\"2\"",
            "a b=\"\" c='2' d=\"3\"",
            "a  b=\"1\"\n\tc=\"2\" ",
            "a b = \"1\" c=\"x&lt;y\" d=\"z\"",
            "a b=\"1\"c=\"2\" 3=\"d\" e",
            "a ü=\"ä\" x:y=\"<\" b=\"no end",
            "a b=1 c=\"2\" =\"3\" d=",
        ];
        for content in contents {
            let (mut faults, mut others) = (Faults::default(), Faults::default());
            let mut attributes = Attributes::new(content.as_bytes(), 7, &mut faults);
            let mut any = Attributes::new(content.as_bytes(), 7, &mut others);
            loop {
                let (one, other) = (attributes.next(&mut faults), any.any(&mut others));
                assert_eq!(one, other, "{content}");
                if one.is_none() {
                    break;
                }
            }
            assert_eq!(faults.take(), others.take(), "{content}");
        }
    }

    #[test]
    fn the_end_of_a_value_is_the_first_byte_that_cannot_be_in_it() {
        let plain: Vec<u8> = (0..=u8::MAX).filter(|byte| !b"\"'<&".contains(byte)).collect();
        for length in 0..60 {
            let text: Vec<u8> =
                plain.iter().cycle().skip(length * 7).take(length).copied().collect();
            for quote in *b"\"'" {
                assert_eq!(value_end(quote, &text), None, "{length}");
                for at in 0..length {
                    for special in [quote, b'<', b'&'] {
                        let mut text = text.clone();
                        text[at] = special;
                        text[length - 1] = special;
                        assert_eq!(value_end(quote, &text), Some(at), "{length}, {at}, {special}");
                    }
                    let mut text = text.clone();
                    text[at] = b'"' + b'\'' - quote;
                    assert_eq!(value_end(quote, &text), None, "{length}, {at}");
                }
            }
        }
        for byte in 0..=u8::MAX {
            let at = b"\"<&".contains(&byte).then_some(3);
            let bytes = [b'1', b'.', b'#', byte, b'=', b'%', b'!', b';'];
            assert_eq!(first_special(bytes), at, "{byte}");
        }
    }
}
