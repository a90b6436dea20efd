//! Where markup begins and ends, as far as cutting needs it.

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

/// Looks for the first markup within an element that may end it or hide its end: tags of its own name, and all that is no tag. Tags of other names are
/// passed over: no value has `<` in it. Its start; or how far the text was searched, where the beginning of such markup may follow.
pub(super) fn within(text: &[u8], from: usize, own: &[u8]) -> Result<usize, usize> {
    let tag = |open: &[u8], until: usize| {
        let begin = [open, own].concat();
        let ends = |at: &usize| text.get(at + begin.len()).is_some_and(ends_name);
        let found = memchr::memmem::find_iter(text.get(from..until)?, &begin);
        found.map(|at| from + at).find(ends)
    };
    let searched = text.len().saturating_sub(own.len() + 2).max(from);
    let end = tag(b"</", text.len());
    let until = end.unwrap_or(text.len());
    let nested = tag(b"<", until);
    let until = nested.unwrap_or(until);
    let rest = text.get(from..until).unwrap_or_default();
    let mut others = memchr::memchr2_iter(b'!', b'?', rest);
    let other = others.find(|at| *at > 0 && rest[at - 1] == b'<').map(|at| from + at - 1);
    other.or(nested).or(end).ok_or(searched)
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
