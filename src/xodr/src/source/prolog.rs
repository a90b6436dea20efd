//! A first look at what stands before the root element, in any encoding that keeps ASCII.

/// What stands before the root.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Prolog<'a> {
    /// Bytes before the first `<`, none where there is no `<` or only white space before it.
    pub(super) junk: usize,
    /// The name of the encoding in the XML declaration, with the place of the declaration.
    pub(super) encoding: Option<(&'a [u8], usize)>,
}

/// Looks at the first bytes of a document. Text, comments and processing instructions before the declaration are passed
/// over: files in the wild have them.
pub(super) fn look(head: &[u8]) -> Prolog<'_> {
    let mut prolog = Prolog::default();
    let Some(first) = memchr::memchr(b'<', head) else { return prolog };
    if !head[..first].iter().all(u8::is_ascii_whitespace) {
        prolog.junk = first;
    }
    let mut place = first;
    loop {
        let Some(open) = memchr::memchr(b'<', &head[place..]) else { return prolog };
        place += open;
        let rest = &head[place..];
        let end = if rest.starts_with(b"<!--") {
            memchr::memmem::find(&rest[4..], b"-->").map(|at| at + 7)
        } else if rest.starts_with(b"<?") {
            memchr::memmem::find(rest, b"?>").map(|at| at + 2)
        } else {
            return prolog;
        };
        // Text between comments may hold "<" only as markup: nothing to skip but the piece itself.
        let Some(end) = end else { return prolog };
        let piece = &rest[..end];
        if piece.starts_with(b"<?xml") && piece.get(5).is_some_and(u8::is_ascii_whitespace) {
            prolog.encoding = pseudo_attribute(&piece[5..], b"encoding").map(|name| (name, place));
            return prolog;
        }
        place += end;
    }
}

/// Value of `name="…"` in a declaration.
fn pseudo_attribute<'a>(declaration: &'a [u8], name: &[u8]) -> Option<&'a [u8]> {
    let mut rest = declaration;
    loop {
        let at = memchr::memmem::find(rest, name)?;
        let spaced = at > 0 && rest[at - 1].is_ascii_whitespace();
        rest = &rest[at + name.len()..];
        let Some(behind) = rest.trim_ascii_start().strip_prefix(b"=").filter(|_| spaced) else {
            continue;
        };
        let value = behind.trim_ascii_start();
        let (quote, value) = value.split_first()?;
        if !matches!(quote, b'"' | b'\'') {
            return None;
        }
        return Some(&value[..memchr::memchr(*quote, value)?]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(head: &str, junk: usize, encoding: Option<&str>) {
        let prolog = look(head.as_bytes());
        assert_eq!(prolog.junk, junk, "{head}");
        assert_eq!(prolog.encoding.map(|(name, _)| name), encoding.map(str::as_bytes), "{head}");
    }

    #[test]
    fn finds_the_declaration() {
        check("<?xml version='1.0' encoding='latin1'?><a/>", 0, Some("latin1"));
        check("<?xml version=\"1.0\" encoding = \"UTF-16\" ?><a/>", 0, Some("UTF-16"));
        check(" \n<!-- <?xml encoding='x'?> --><?xml encoding='y'?>", 0, Some("y"));
        check("<?pi encoding='x'?><?xml xencoding='x' encoding='y'?>", 0, Some("y"));
        check("junk<?xml version='1.0'?>", 4, None);
        check("<a><?xml version='1.0' encoding='x'?>", 0, None);
        check("<?xml version='1.0' encoding=x?><a/>", 0, None);
        check("<?xml version='1.0' encoding='x", 0, None);
        check("<?xml-stylesheet encoding='x'?><a/>", 0, None);
        check("no markup", 0, None);
        check("", 0, None);
    }
}
