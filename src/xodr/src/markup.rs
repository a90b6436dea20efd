//! Pieces of markup: tags, comments, text.

use crate::cursor::{Cursor, Markup, Name, OpenTag, RawAttribute, Scope, Tag, path_of};
use crate::finding::{Severity, Span};
use crate::findings::About;
use crate::rule_ids;
use crate::same::{same, without_prefix};
use crate::source::Places;
use crate::values;
use crate::well_formed::{self, Attributes, Fault, Faults};

/// What to do with text between tags.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Text {
    /// Only white space may stand there.
    None,
    /// It is the element's content.
    Content,
    /// It may stand there and is passed over.
    Any,
}

impl Cursor<'_> {
    /// The next piece of markup.
    #[inline]
    pub(crate) fn markup(&mut self, text: Text) -> Markup {
        loop {
            if self.over {
                return Markup::Over;
            }
            if text == Text::Content {
                self.collect_text();
            }
            match self.window.skip_space() {
                Some(b'<') => {}
                Some(_) => {
                    self.pass_text(text);
                    continue;
                }
                None if self.scope == Scope::Batch && self.is_between_items() => {
                    self.scope = Scope::WholeBatch;
                    return Markup::Over;
                }
                None => {
                    self.unclosed();
                    return Markup::Over;
                }
            }
            match self.window.ahead().get(1) {
                Some(b'/') => return self.end_tag(),
                Some(b'!' | b'?') => self.other_markup(text),
                Some(_) => return self.start_tag(),
                None => {
                    self.window.want(2);
                    if self.window.ahead().len() < 2 {
                        self.truncated();
                    }
                }
            }
        }
    }

    /// Whether nothing but the root is open.
    fn is_between_items(&self) -> bool {
        self.frames.len() == 1 && self.outer.is_empty() && !self.within_extension
    }

    #[cold]
    fn unclosed(&mut self) {
        let name = match self.frames.last() {
            Some(frame) => format!("the end of element {}", self.name_of(&frame.name)),
            None => "an element".to_owned(),
        };
        self.stopped(Some(&name));
    }

    /// The text ends within markup.
    #[cold]
    fn truncated(&mut self) {
        let start = self.window.start();
        let at_end = matches!(self.window.stop, Some(crate::window::Stop::End));
        self.stopped(None);
        if at_end {
            self.refuse(rule_ids::XML, start, Fault::Truncated.to_string());
        }
    }

    pub(crate) fn name_of(&self, name: &Name) -> String {
        match *name {
            Name::Known(name) => name.to_owned(),
            Name::Other(from, len) => {
                String::from_utf8_lossy(self.names.get(from..from + len).unwrap_or_default())
                    .into_owned()
            }
        }
    }

    /// Reads a start tag.
    #[inline]
    fn start_tag(&mut self) -> Markup {
        let Some(mut end) = self.window.find(b'>', 1) else {
            self.truncated();
            return Markup::Over;
        };
        let start = self.window.start();
        let mut faults = Faults::default();
        split(
            self.window.ahead().get(1..end).unwrap_or_default(),
            start,
            &mut self.tag,
            &mut faults,
        );
        if !faults.is_empty() {
            match self.faulty_tag(end, &mut faults) {
                Some(real) => end = real,
                None => return Markup::Over,
            }
        }
        let length = end + 1;
        if length > self.limits.tag_bytes || self.tag.attributes.len() > self.limits.attributes {
            let (bytes, attributes) = (self.limits.tag_bytes, self.limits.attributes);
            let message = format!(
                "expected a tag of at most {bytes} bytes and {attributes} attributes, found more"
            );
            self.refuse(rule_ids::LIMIT, start, message);
            return Markup::Over;
        }
        self.window.take(length);
        self.tag.span = Span { start, len: u32::try_from(length).unwrap_or(u32::MAX) };
        if self.frames.len() >= self.limits.depth {
            let message =
                format!("expected at most {} nested elements, found more", self.limits.depth);
            self.refuse(rule_ids::LIMIT, start, message);
            return Markup::Over;
        }
        Markup::Start
    }

    /// A tag with faults: one of them may be that `>` stands in a value, so that the tag ends later. Where it ends; none
    /// where the text ends before.
    #[cold]
    fn faulty_tag(&mut self, end: usize, faults: &mut Faults) -> Option<usize> {
        let mut end = end;
        let mut found = faults.take();
        if found.iter().any(|(_, fault)| *fault == Fault::NoClosingQuote) {
            end = match self.quoted_end() {
                Some(end) => end,
                None => {
                    self.truncated();
                    return None;
                }
            };
            let start = self.window.start();
            let content = self.window.ahead().get(1..end).unwrap_or_default();
            split(content, start, &mut self.tag, faults);
            found = faults.take();
        }
        for (start, fault) in found {
            self.fault(start, fault);
        }
        Some(end)
    }

    /// Where the tag ends by its quotes.
    fn quoted_end(&mut self) -> Option<usize> {
        let mut at = 1;
        loop {
            let rest = self.window.ahead().get(at..).unwrap_or_default();
            match memchr::memchr3(b'"', b'\'', b'>', rest) {
                Some(found) if rest[found] == b'>' => return Some(at + found),
                Some(found) => {
                    let quote = rest[found];
                    at = self.window.find(quote, at + found + 1)? + 1;
                }
                None => {
                    at += rest.len();
                    self.window.find(b'>', at)?;
                }
            }
        }
    }

    /// Adds a finding that something is not well-formed.
    #[cold]
    pub(crate) fn fault(&mut self, start: u64, fault: Fault) {
        let rule = match fault {
            Fault::LateDeclaration => rule_ids::BEFORE_DECLARATION,
            _ => rule_ids::XML,
        };
        let detail = format!("{fault:?}");
        let span = Span { start, len: 1 };
        let (frames, names) = (&self.frames, &self.names);
        self.findings.add(rule, fault.severity(), span, About::text(&detail), || {
            (path_of(frames, names), fault.to_string())
        });
    }

    pub(crate) fn faults(&mut self, mut faults: Faults) {
        for (start, fault) in faults.take() {
            self.fault(start, fault);
        }
    }

    /// Reads an end tag.
    #[inline]
    fn end_tag(&mut self) -> Markup {
        if let Some(length) = self.plain_end() {
            self.window.take(length);
            return Markup::End;
        }
        let Some(end) = self.window.find(b'>', 2) else {
            self.truncated();
            return Markup::Over;
        };
        let written = self.window.ahead().get(2..end).unwrap_or_default();
        let matches = self.frames.last().is_some_and(|frame| match frame.name {
            Name::Known(name) => {
                let local = without_prefix(written, &self.prefix);
                local.is_some_and(|local| same(local, name.as_bytes()))
            }
            Name::Other(from, len) => self.names.get(from..from + len) == Some(written),
        });
        if !matches && !self.matches_with_space(end) {
            let start = self.window.start();
            self.refuse(rule_ids::XML, start, Fault::Mismatch.to_string());
            return Markup::Over;
        }
        self.window.take(end + 1);
        Markup::End
    }

    /// The length of an end tag that is all there, has no prefix and no space, and ends the innermost element.
    #[inline]
    fn plain_end(&self) -> Option<usize> {
        let Some(OpenTag { name: Name::Known(name), .. }) = self.frames.last() else { return None };
        let ahead = self.window.ahead();
        let end = name.len() + 2;
        let ends = self.prefix.is_empty()
            && ahead.get(end) == Some(&b'>')
            && same(ahead.get(2..end)?, name.as_bytes());
        ends.then_some(end + 1)
    }

    /// Whether an end tag with white space before its `>` fits.
    #[cold]
    fn matches_with_space(&self, end: usize) -> bool {
        let written = self.window.ahead().get(2..end).unwrap_or_default().trim_ascii_end();
        self.frames.last().is_some_and(|frame| match frame.name {
            Name::Known(name) => {
                written.strip_prefix(self.prefix.as_slice()) == Some(name.as_bytes())
            }
            Name::Other(from, len) => self.names.get(from..from + len) == Some(written),
        })
    }

    /// Passes over a comment, an instruction, a document type; takes in CDATA.
    #[cold]
    pub(crate) fn other_markup(&mut self, text: Text) {
        self.window.want(9);
        let start = self.window.start();
        let ahead = self.window.ahead();
        let mut faults = Faults::default();
        let end = if ahead.starts_with(b"<!--") {
            let end = self.window.find_end(b"-->", 4);
            if let Some(content) = end.and_then(|end| self.window.ahead().get(4..end - 3)) {
                well_formed::comment(content, start + 4, &mut faults);
            }
            end
        } else if ahead.starts_with(b"<![CDATA[") {
            let end = self.window.find_end(b"]]>", 9);
            if let Some(end) = end {
                self.section(end, text, start, &mut faults);
            }
            end
        } else if ahead.starts_with(b"<!DOCTYPE") {
            let end = self.doctype_end();
            if let Some(markup) = end.and_then(|end| self.window.ahead().get(..end)) {
                self.structure.document_type(markup, start, &mut faults);
            }
            end
        } else if ahead.starts_with(b"<?") {
            let end = self.window.find_end(b"?>", 2);
            if let Some(content) = end.and_then(|end| self.window.ahead().get(2..end - 2)) {
                let is_declaration = content
                    .strip_prefix(b"xml")
                    .is_some_and(|rest| rest.first().is_none_or(u8::is_ascii_whitespace));
                if is_declaration {
                    let is_first = Places::offset_of(start) == 0;
                    self.structure.declaration(start, is_first, &mut faults);
                    well_formed::declaration(content, start + 2, &mut faults);
                } else {
                    well_formed::instruction(content, start + 2, &mut faults);
                }
            }
            end
        } else {
            faults.add(start, Fault::UnknownMarkup);
            self.window.find(b'>', 2).map(|at| at + 1)
        };
        match end {
            Some(end) => {
                self.window.take(end);
                if end > self.limits.text_bytes {
                    let message = format!(
                        "expected at most {} bytes in one comment, section or instruction, found more",
                        self.limits.text_bytes
                    );
                    self.refuse(rule_ids::LIMIT, start, message);
                }
            }
            None => self.truncated(),
        }
        self.faults(faults);
    }

    /// A CDATA section that ends `end` bytes behind the token's start.
    fn section(&mut self, end: usize, text: Text, start: u64, faults: &mut Faults) {
        if self.frames.is_empty() {
            self.structure.section(start, faults);
            return;
        }
        let content = self.window.ahead().get(9..end - 3).unwrap_or_default();
        match text {
            Text::Content => {
                let content = String::from_utf8_lossy(content).into_owned();
                self.content_start.get_or_insert(start + 9);
                if self.has_room(content.len(), start) {
                    self.content += &content;
                }
            }
            Text::None if !content.trim_ascii().is_empty() => self.stray_text(start),
            Text::None | Text::Any => {}
        }
    }

    /// Where a document type ends, its own declarations in brackets included.
    fn doctype_end(&mut self) -> Option<usize> {
        let end = self.window.find(b'>', 9)?;
        let open = memchr::memchr(b'[', self.window.ahead().get(..end).unwrap_or_default());
        match open {
            None => Some(end + 1),
            Some(open) => {
                let close = self.window.find(b']', open)?;
                self.window.find(b'>', close).map(|at| at + 1)
            }
        }
    }

    /// Passes over text that is no white space.
    #[cold]
    fn pass_text(&mut self, text: Text) {
        let start = self.window.start();
        let Some(end) = self.window.find(b'<', 0) else {
            self.window.take(usize::MAX);
            self.unclosed();
            return;
        };
        let mut faults = Faults::default();
        let content = self.window.ahead().get(..end).unwrap_or_default();
        if self.frames.is_empty() {
            self.structure.text(content, start, &mut faults);
        }
        well_formed::text(content, start, &mut faults);
        self.window.take(end);
        self.faults(faults);
        if text == Text::None && !self.frames.is_empty() {
            self.stray_text(start);
        }
    }

    fn stray_text(&mut self, start: u64) {
        let message = "expected elements only, found text between them; passed over".to_owned();
        self.add(rule_ids::TEXT, Severity::Warning, Span { start, len: 1 }, "", message);
    }

    /// Whether the content may grow by some bytes; the walk ends where it may not.
    fn has_room(&mut self, bytes: usize, start: u64) -> bool {
        let most = self.limits.text_bytes;
        let has_room = self.content.len() + bytes <= most;
        if !has_room {
            let message =
                format!("expected at most {most} bytes of text in one element, found more");
            self.refuse(rule_ids::LIMIT, start, message);
        }
        self.spend(bytes);
        has_room && !self.over
    }

    /// Takes in text up to the next markup as content.
    fn collect_text(&mut self) {
        self.window.begin();
        let start = self.window.start();
        let Some(end) = self.window.find(b'<', 0) else {
            self.window.take(usize::MAX);
            return;
        };
        let mut faults = Faults::default();
        let content = self.window.ahead().get(..end).unwrap_or_default();
        well_formed::text(content, start, &mut faults);
        if let Some(first) = content.iter().position(|byte| !byte.is_ascii_whitespace()) {
            self.content_start.get_or_insert(start + first as u64);
        }
        let content = content.to_vec();
        if self.has_room(content.len(), start) {
            values::push_resolved(&mut self.content, &String::from_utf8_lossy(&content));
        }
        self.window.take(end);
        self.faults(faults);
    }
}

/// Splits what stands between `<` and `>`.
#[inline]
fn split(content: &[u8], start: u64, tag: &mut Tag, faults: &mut Faults) {
    let (content, empty) = match content {
        [content @ .., b'/'] => (content, true),
        content => (content, false),
    };
    tag.empty = empty;
    tag.declares = false;
    tag.attributes.clear();
    let mut attributes = Attributes::new(content, start + 1, faults);
    tag.name = attributes.element().len();
    while let Some(attribute) = attributes.next(faults) {
        let place = |at: usize, len: usize| ((at + 1) as u32, (at + 1 + len) as u32);
        tag.declares |= attribute.name.starts_with(b"xmlns");
        tag.attributes.push(RawAttribute {
            name: place(attribute.name_at, attribute.name.len()),
            value: place(attribute.value_at, attribute.value.len()),
        });
    }
}
