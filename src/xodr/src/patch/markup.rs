//! Where markup begins and ends, as far as cutting needs it.

use memchr::memmem::Finder;

/// What a piece of markup is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A start tag.
    Start,
    /// A tag of an element without content.
    Empty,
    /// An end tag.
    End,
    /// Comment, declaration, instruction, CDATA.
    Other,
}

/// A piece of markup.
#[derive(Clone, Copy, Debug)]
pub(super) struct Markup {
    pub(super) start: usize,
    pub(super) end: usize,
    pub(super) kind: Kind,
}

/// The first markup from a place on; none if it is not there, or not whole.
pub(super) fn markup(text: &[u8], from: usize) -> Option<Markup> {
    let start = from + memchr::memchr(b'<', text.get(from..)?)?;
    let rest = &text[start..];
    let until = |end: &[u8]| memchr::memmem::find(rest, end).map(|at| at + end.len());
    // Too short to tell.
    if rest.len() < b"<![CDATA[".len() && !rest.contains(&b'>') {
        return None;
    }
    let other = match rest {
        [b'<', b'!', b'-', b'-', ..] => {
            Some(memchr::memmem::find(rest.get(4..)?, b"-->").map(|at| at + 7))
        }
        _ if rest.starts_with(b"<![CDATA[") => Some(until(b"]]>")),
        [b'<', b'?', ..] => Some(until(b"?>")),
        [b'<', b'!', ..] => Some(until(b">")),
        _ => None,
    };
    if let Some(length) = other {
        return Some(Markup { start, end: start + length?, kind: Kind::Other });
    }
    let first = memchr::memchr(b'>', rest)?;
    let head = &rest[..first];
    let in_no_value = memchr::memchr(b'\'', head).is_none()
        && memchr::memchr_iter(b'"', head).count().is_multiple_of(2);
    // Values are looked at one by one only where one of them may hold the first `>`.
    let mut at = if in_no_value { first } else { 1 };
    loop {
        at += memchr::memchr3(b'>', b'"', b'\'', &rest[at..])?;
        match rest[at] {
            b'>' => break,
            quote => at += 2 + memchr::memchr(quote, rest.get(at + 1..)?)?,
        }
    }
    let kind = match (rest[1], rest[at - 1]) {
        (b'/', _) => Kind::End,
        (_, b'/') => Kind::Empty,
        _ => Kind::Start,
    };
    Some(Markup { start, end: start + at + 1, kind })
}

/// What is next within an open element, as far as it may end it or hide its end: tags of its own name, and all that is no tag. Tags of other names are passed
/// over. What was found is kept: each byte is searched once for each of them, however many there are.
#[derive(Debug)]
pub(super) struct Within {
    /// How a tag of its own name begins, and its end tag.
    nested: (Finder<'static>, Next),
    end: (Finder<'static>, Next),
    other: Next,
}

/// The next place of one kind.
#[derive(Debug, Default)]
struct Next {
    at: Option<usize>,
    /// Up to here there is no other.
    searched: usize,
}

impl Next {
    /// The first from a place on and before another. `longest` bytes before what was searched, one may have begun.
    fn first(
        &mut self,
        (from, until): (usize, usize),
        longest: usize,
        find: impl FnOnce(usize, usize) -> Option<usize>,
    ) -> Option<usize> {
        if self.at.is_none_or(|at| at < from) && self.searched < until {
            let begin = self.searched.saturating_sub(longest).max(from);
            self.at = find(begin, until);
            self.searched = self.at.map_or(until, |at| at + 1);
        }
        self.at.filter(|at| (from..until).contains(at))
    }

    fn forget(&mut self, count: usize) {
        self.at = self.at.and_then(|at| at.checked_sub(count));
        self.searched = self.searched.saturating_sub(count);
    }
}

impl Within {
    /// Within an element of this name, with its prefix.
    pub(super) fn new(own: &[u8]) -> Self {
        let tag = |open: &[u8]| Finder::new(&[open, own].concat()).into_owned();
        Self {
            nested: (tag(b"<"), Next::default()),
            end: (tag(b"</"), Next::default()),
            other: Next::default(),
        }
    }

    /// The start of the first markup from a place on, which lies in no tag.
    ///
    /// Errors: there is none yet; the place up to which the text need not be searched again.
    pub(super) fn next(&mut self, text: &[u8], mut from: usize) -> Result<usize, usize> {
        loop {
            let found = self.find(text, from);
            let searched = text.len().saturating_sub(self.end.0.needle().len()).max(from);
            let place = match found {
                Some(place) => place,
                None => match memchr::memrchr(b'<', text.get(from..searched).unwrap_or_default()) {
                    Some(last) => from + last,
                    None => return Err(searched),
                },
            };
            match (holder(text, from, place), found) {
                (Some(tag), _) => from = tag?,
                (None, Some(place)) => return Ok(place),
                (None, None) => {
                    return Err(markup(text, place).map_or(place, |tag| tag.end.max(searched)));
                }
            }
        }
    }

    fn find(&mut self, text: &[u8], from: usize) -> Option<usize> {
        let tag = |(begin, next): &mut (Finder<'static>, Next), until: usize| {
            let length = begin.needle().len();
            let ends = |at: &usize| text.get(at + length).is_some_and(ends_name);
            next.first((from, until), length, |from, until| {
                begin.find_iter(text.get(from..until)?).map(|at| from + at).find(ends)
            })
        };
        let end = tag(&mut self.end, text.len());
        let until = end.unwrap_or(text.len());
        let nested = tag(&mut self.nested, until);
        let until = nested.unwrap_or(until);
        let other = self.other.first((from, until), 1, |from, until| {
            let rest = text.get(from..until)?;
            let mut others = memchr::memchr2_iter(b'!', b'?', rest);
            others.find(|at| *at > 0 && rest[at - 1] == b'<').map(|at| from + at - 1)
        });
        other.or(nested).or(end)
    }

    /// So many bytes of the text are gone at its beginning.
    pub(super) fn forget(&mut self, count: usize) {
        [&mut self.nested.1, &mut self.end.1, &mut self.other]
            .into_iter()
            .for_each(|next| next.forget(count));
    }
}

/// The tag in one of whose values a place lies, where the reader goes on after `<` as well: its end; or its start, if it is not whole. Between `from`, which
/// lies in no tag, and the place there are only tags.
fn holder(text: &[u8], from: usize, place: usize) -> Option<Result<usize, usize>> {
    let before = text.get(from..place)?;
    // The quote that begins a value stands behind `=`: only where the last one does, the tags are looked at one by one.
    let begins_value = |quote: u8| {
        memchr::memrchr(quote, before)
            .is_some_and(|last| before[..last].trim_ascii_end().ends_with(b"="))
    };
    if !begins_value(b'"') && !begins_value(b'\'') {
        return None;
    }
    let mut at = from;
    loop {
        let start = at + memchr::memchr(b'<', text.get(at..place)?)?;
        match markup(text, start) {
            None => return Some(Err(start)),
            Some(tag) if tag.end > place => return Some(Ok(tag.end)),
            Some(tag) => at = tag.end,
        }
    }
}

/// Whether a byte is none of a name.
fn ends_name(byte: &u8) -> bool {
    byte.is_ascii_whitespace() || matches!(byte, b'/' | b'>')
}

/// The name of a tag's element, with its prefix.
pub(super) fn whole_name(tag: &[u8]) -> &[u8] {
    let begin = if tag.starts_with(b"</") { 2 } else { 1 };
    let rest = tag.get(begin..).unwrap_or_default();
    &rest[..rest.iter().position(ends_name).unwrap_or(rest.len())]
}

/// The name of a tag's element, without a prefix.
pub(super) fn name(tag: &[u8]) -> &[u8] {
    let whole = whole_name(tag);
    memchr::memrchr(b':', whole).map_or(whole, |colon| &whole[colon + 1..])
}

/// The value of an attribute of a start tag, references to characters of the five names resolved.
pub(super) fn attribute(tag: &[u8], wanted: &[u8]) -> Option<String> {
    let mut rest = tag;
    while let Some(equals) = memchr::memchr(b'=', rest) {
        let key = rest[..equals].trim_ascii_end();
        let begin = key.iter().rposition(u8::is_ascii_whitespace).map_or(0, |at| at + 1);
        let value = rest[equals + 1..].trim_ascii_start();
        let quote = *value.first()?;
        let value = value.get(1..)?;
        let end = memchr::memchr(quote, value)?;
        if &key[begin..] == wanted {
            let text = String::from_utf8_lossy(&value[..end]).into_owned();
            let names =
                [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&apos;", "'"), ("&amp;", "&")];
            return Some(names.iter().fold(text, |text, (name, is)| text.replace(name, is)));
        }
        rest = &value[end + 1..];
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Asking for the next place again and again searches each byte once.
    #[test]
    fn each_byte_is_searched_once() {
        let text = "<!---->".repeat(1000) + "</road";
        for needle in ["<!", "</road", "none"] {
            let (mut next, mut searched, mut calls) = (Next::default(), 0, 0);
            for from in (0..text.len()).step_by(7) {
                next.first((from, text.len()), needle.len(), |begin, until| {
                    let found = text[begin..until].find(needle).map(|at| begin + at);
                    searched += found.unwrap_or(until) - begin;
                    calls += 1;
                    found
                });
            }
            let most = text.len() + calls * needle.len();
            assert!(searched <= most, "{needle}: {searched} bytes of {}", text.len());
            assert_eq!(calls, if needle == "<!" { 1001 } else { 1 }, "{needle}");
        }
    }
}
