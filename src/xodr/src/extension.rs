//! What files have beyond the standard's own elements.

use crate::finding::Span;
use quick_xml::escape::unescape;
use quick_xml::events::Event;

/// Kinds of what stands beyond the standard's own elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExtensionKind {
    /// `userData`.
    UserData,
    /// `dataQuality`.
    DataQuality,
    /// `include` that was not resolved.
    Include,
    /// An element of the standard's namespace that the standard does not have in this place.
    Unknown,
    /// An element of another namespace.
    Foreign,
}

/// An element beyond the standard's own, as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extension {
    /// What it is.
    pub kind: ExtensionKind,
    /// The whole element as written, with everything inside; empty where it was larger than the limit.
    pub text: Box<str>,
    /// The start tag.
    pub span: Span,
}

/// The extensions of an element in file order; most elements have none, and pay eight bytes.
#[expect(
    clippy::box_collection,
    reason = "every element has this field, and few have an extension"
)]
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Extensions(Option<Box<Vec<Extension>>>);

impl Extensions {
    pub(crate) fn push(&mut self, extension: Extension) {
        self.0.get_or_insert_default().push(extension);
    }

    /// The extensions in file order.
    pub fn as_slice(&self) -> &[Extension] {
        self.0.as_ref().map_or(&[], |all| all.as_slice())
    }
}

impl<'a> IntoIterator for &'a Extensions {
    type Item = &'a Extension;
    type IntoIter = std::slice::Iter<'a, Extension>;

    fn into_iter(self) -> Self::IntoIter {
        self.as_slice().iter()
    }
}

/// An element in an extension's text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ExtensionElement {
    /// Tags from the extension itself down to it, with `/` in between.
    pub path: String,
    /// Its attributes as written, entities resolved.
    pub attributes: Vec<(String, String)>,
}

/// A start tag without attributes.
struct BareTag<'t> {
    name: &'t str,
    /// Where the text behind it begins; none where the tag ends its element, too.
    inside: Option<usize>,
}

impl Extension {
    /// The start tag, if it is nothing but a name, as most are: nobody needs to parse it.
    fn bare_tag(&self) -> Option<BareTag<'_>> {
        let tag = self.text.strip_prefix('<')?;
        let end = tag.bytes().position(|byte| !byte.is_ascii_alphanumeric())?;
        let (name, rest) = tag.split_at_checked(end)?;
        let is_open = rest.starts_with('>');
        let is_bare = !name.is_empty() && (is_open || rest.starts_with("/>"));
        is_bare.then_some(BareTag { name, inside: is_open.then_some(end + 2) })
    }

    /// The element itself; none where its text was not kept.
    pub fn element(&self) -> Option<ExtensionElement> {
        if let Some(tag) = self.bare_tag() {
            return Some(ExtensionElement { path: tag.name.to_owned(), attributes: Vec::new() });
        }
        self.elements(1).pop()
    }

    /// The element itself and those inside, in file order, so many at most.
    pub fn elements(&self, most: usize) -> Vec<ExtensionElement> {
        let mut xml = quick_xml::Reader::from_str(&self.text);
        let (mut path, mut out) = (Vec::new(), Vec::new());
        // The text was found well-formed when it was read: what follows a fault is nobody's.
        while out.len() < most
            && let Ok(event) = xml.read_event()
        {
            let (tag, is_open) = match &event {
                Event::Start(tag) => (tag, true),
                Event::Empty(tag) => (tag, false),
                Event::End(_) => {
                    path.pop();
                    continue;
                }
                Event::Eof => break,
                _ => continue,
            };
            path.push(tag.name().as_ref().to_owned());
            let attributes = tag.attributes().flatten().map(|attribute| {
                let value = unescape(&attribute.value).unwrap_or_default().into_owned();
                (attribute.key.as_ref().to_owned(), value)
            });
            out.push(ExtensionElement { path: path.join("/"), attributes: attributes.collect() });
            if !is_open {
                path.pop();
            }
        }
        out
    }

    /// What stands between its start and its end tag, without the space around it.
    pub fn inner(&self) -> &str {
        let start = match self.bare_tag() {
            Some(tag) => tag.inside,
            None => self.behind_tag(),
        };
        let Some(start) = start else { return "" };
        // Its end tag has the last bracket.
        let end = self.text.rfind('<').unwrap_or(0);
        // Nearly all space is ASCII, which is quick to trim.
        self.text.get(start..end).unwrap_or("").trim_ascii().trim()
    }

    /// Where the text behind the start tag begins; none where the tag ends its element, too.
    fn behind_tag(&self) -> Option<usize> {
        let mut xml = quick_xml::Reader::from_str(&self.text);
        match xml.read_event() {
            Ok(Event::Start(_)) => usize::try_from(xml.buffer_position()).ok(),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_extension_is_read_from_its_text() {
        let of = |text: &str| Extension {
            kind: ExtensionKind::UserData,
            text: text.into(),
            span: Span::default(),
        };
        let plain = of("<userData code=\"a&amp;b\" value='1'/>");
        assert_eq!(plain.inner(), "");
        let element = plain.element().expect("there");
        assert_eq!(element.path, "userData");
        let pairs = [("code", "a&b"), ("value", "1")];
        assert_eq!(element.attributes, pairs.map(|(k, v)| (k.to_owned(), v.to_owned())));
        let nested = of("<userData code=\"x\">\n <a b='>'><c/></a>t\n</userData>");
        assert_eq!(nested.inner(), "<a b='>'><c/></a>t");
        let paths: Vec<_> = nested.elements(9).into_iter().map(|e| e.path).collect();
        assert_eq!(paths, ["userData", "userData/a", "userData/a/c"]);
        assert_eq!(nested.elements(2).len(), 2);
        let bare = of("<userData>\n  <a/>\n \u{a0}</userData>");
        assert_eq!(bare.inner(), "<a/>");
        let due = ExtensionElement { path: "userData".to_owned(), attributes: Vec::new() };
        for text in
            ["<userData/>", "<userData />", "<userData></userData>", "<userData >t</userData>"]
        {
            assert_eq!(of(text).element().as_ref(), Some(&due), "{text}");
            assert_eq!(of(text).inner(), if text.contains(">t<") { "t" } else { "" }, "{text}");
        }
        assert_eq!(of("<a:userData>t</a:userData>").inner(), "t");
        assert_eq!(of("").element(), None);
    }
}
