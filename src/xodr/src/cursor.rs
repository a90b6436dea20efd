//! Walking through the document: one event after the other, with place and path.

use crate::attributes::{Attributes, Context};
use crate::finding::{Finding, Severity, Span};
use crate::limits::Limits;
use crate::rule_ids;
use crate::source::LineIndex;
use quick_xml::events::{BytesRef, Event};
use std::io::{self, BufRead, Read};

/// What a limit's I/O error says; it never leaves this module.
const TOO_LARGE: &str = "one piece of markup or text is larger than the limits allow";

/// The input: counts lines, and bounds what one event may take.
pub(crate) struct Source<R> {
    inner: R,
    pub(crate) lines: LineIndex,
    /// Bytes consumed since the current event began.
    taken: usize,
    limit: usize,
}

impl<R: BufRead> Read for Source<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let available = self.fill_buf()?;
        let count = available.len().min(buffer.len());
        buffer[..count].copy_from_slice(&available[..count]);
        self.consume(count);
        Ok(count)
    }
}

impl<R: BufRead> BufRead for Source<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken > self.limit {
            return Err(io::Error::other(TOO_LARGE));
        }
        self.inner.fill_buf()
    }

    fn consume(&mut self, count: usize) {
        // What is being consumed lies in the buffer: asking for it again reads nothing.
        if let Ok(bytes) = self.inner.fill_buf() {
            self.lines.feed(bytes.get(..count).unwrap_or(bytes));
        }
        self.taken += count;
        self.inner.consume(count);
    }
}

/// A step through the document.
pub(crate) enum Step {
    /// An element begins; its attributes are in the cursor's hands.
    Start(Attributes),
    /// The innermost element ends.
    End,
    /// Text, CDATA or a resolved reference.
    Text(String),
    /// The input has ended, or reading it makes no more sense.
    Over,
}

/// The walk through a document.
pub(crate) struct Cursor<R> {
    xml: quick_xml::Reader<Source<R>>,
    buffer: Vec<u8>,
    limits: Limits,
    pub(crate) findings: Vec<Finding>,
    /// Names of the open elements.
    path: Vec<String>,
    /// Prefix of the root with its colon; children of the core have it too.
    prefix: String,
    over: bool,
    failed: Option<io::Error>,
}

impl<R: BufRead> Cursor<R> {
    pub(crate) fn new(input: R, limits: Limits) -> Self {
        let limit = limits.tag_bytes.max(limits.text_bytes);
        let source = Source { inner: input, lines: LineIndex::default(), taken: 0, limit };
        let mut xml = quick_xml::Reader::from_reader(source);
        xml.config_mut().expand_empty_elements = true;
        Self {
            xml,
            buffer: Vec::new(),
            limits,
            findings: Vec::new(),
            path: Vec::new(),
            prefix: String::new(),
            over: false,
            failed: None,
        }
    }

    pub(crate) fn lines(&self) -> &LineIndex {
        &self.xml.get_ref().lines
    }

    pub(crate) fn offset(&self) -> u64 {
        self.xml.buffer_position()
    }

    /// Whether the document has ended, for whatever reason.
    pub(crate) fn is_over(&self) -> bool {
        self.over
    }

    /// The failure of the environment that ended the walk.
    pub(crate) fn take_failure(&mut self) -> Option<io::Error> {
        self.failed.take()
    }

    /// Where findings about the current element go.
    pub(crate) fn context(&mut self) -> Context<'_> {
        Context { path: self.path.join("/"), findings: &mut self.findings }
    }

    pub(crate) fn add(
        &mut self,
        rule: &'static str,
        severity: Severity,
        span: Span,
        message: String,
    ) {
        self.context().add(rule, severity, span, message);
    }

    /// Ends the walk with an error finding.
    pub(crate) fn refuse(&mut self, rule: &'static str, start: u64, message: String) {
        self.add(rule, Severity::Error, Span { start, len: 0 }, message);
        self.over = true;
    }

    /// Names the current element more closely in paths.
    pub(crate) fn name_element(&mut self, name: String) {
        if let Some(last) = self.path.last_mut() {
            *last = name;
        }
    }

    /// Local name of the innermost element, empty for elements of another namespace.
    pub(crate) fn set_root_prefix(&mut self, prefix: String) {
        self.prefix = prefix;
    }

    /// The next step.
    pub(crate) fn step(&mut self) -> Step {
        loop {
            if self.over {
                return Step::Over;
            }
            let start = self.xml.buffer_position();
            self.xml.get_mut().taken = 0;
            self.buffer.clear();
            let event = match self.xml.read_event_into(&mut self.buffer) {
                Ok(event) => event,
                Err(error) => {
                    let at = self.xml.error_position();
                    return self.fail(error, at);
                }
            };
            match event {
                Event::Start(tag) if tag.len() > self.limits.tag_bytes => {
                    self.refuse(rule_ids::LIMIT, start, TOO_LARGE.to_owned());
                    return Step::Over;
                }
                Event::Start(tag) => {
                    let mut attributes = Attributes::default();
                    let parsed = attributes.parse(tag.as_bytes(), start);
                    let name = tag.name().as_ref().to_owned();
                    if let Err((message, at)) = parsed {
                        self.refuse(rule_ids::XML, start + 1 + at as u64, message);
                        return Step::Over;
                    }
                    self.path.push(name);
                    if self.path.len() > self.limits.depth {
                        let message = format!(
                            "expected at most {} nested elements, found more",
                            self.limits.depth
                        );
                        self.refuse(rule_ids::LIMIT, start, message);
                        return Step::Over;
                    }
                    return Step::Start(attributes);
                }
                Event::End(_) => {
                    self.path.pop();
                    return Step::End;
                }
                Event::Text(text) => return Step::Text(text.to_string()),
                Event::CData(text) => return Step::Text(text.to_string()),
                Event::GeneralRef(reference) => return Step::Text(resolve(&reference)),
                Event::Decl(declaration) => {
                    let encoding = declaration.encoding().and_then(Result::ok);
                    let encoding = encoding.map(|e| e.to_ascii_lowercase());
                    if start > 3 {
                        let message = "expected the XML declaration at the start of the file, found it after something else".to_owned();
                        self.add(
                            rule_ids::BEFORE_DECLARATION,
                            Severity::Warning,
                            Span { start, len: 5 },
                            message,
                        );
                    }
                    if let Some(encoding) = encoding
                        .filter(|e| !matches!(e.as_str(), "utf-8" | "utf8" | "us-ascii" | "ascii"))
                    {
                        let message = format!(
                            "expected UTF-8, found the encoding {encoding:?}, which is not read yet"
                        );
                        self.refuse(rule_ids::ENCODING, start, message);
                        return Step::Over;
                    }
                }
                Event::Eof => {
                    if let Some(open) = self.path.last() {
                        let message = format!(
                            "expected the end of element {open}, found the end of the file"
                        );
                        self.refuse(rule_ids::XML, start, message);
                    }
                    self.over = true;
                    return Step::Over;
                }
                Event::Empty(_) | Event::Comment(_) | Event::PI(_) | Event::DocType(_) => {}
            }
        }
    }

    fn fail(&mut self, error: quick_xml::Error, at: u64) -> Step {
        match error {
            quick_xml::Error::Io(error) if error.to_string() == TOO_LARGE => {
                self.refuse(rule_ids::LIMIT, at, TOO_LARGE.to_owned());
            }
            quick_xml::Error::Io(error) => {
                self.failed = Some(io::Error::new(error.kind(), error.to_string()));
                self.over = true;
            }
            error => self.refuse(rule_ids::XML, at, error.to_string()),
        }
        Step::Over
    }

    /// Visits the children of the current element up to its end. `visit` gets the child's local name and attributes
    /// and must walk to the child's end, by `children`, `text` or `skip`.
    pub(crate) fn children(&mut self, mut visit: impl FnMut(&mut Self, &str, Attributes)) {
        loop {
            match self.step() {
                Step::Start(attributes) => {
                    let name = self.path.last().map(String::as_str).unwrap_or("");
                    match name
                        .strip_prefix(self.prefix.as_str())
                        .filter(|local| !local.contains(':'))
                    {
                        Some(local) => {
                            let local = local.to_owned();
                            visit(self, &local, attributes);
                        }
                        None => self.skip(),
                    }
                }
                Step::Text(_) => {}
                Step::End | Step::Over => return,
            }
        }
    }

    /// Walks to the end of the current element.
    pub(crate) fn skip(&mut self) {
        let mut depth = 1;
        while depth > 0 {
            match self.step() {
                Step::Start(_) => depth += 1,
                Step::End => depth -= 1,
                Step::Text(_) => {}
                Step::Over => return,
            }
        }
    }

    /// Text of the current element up to its end, that of children left out.
    pub(crate) fn text(&mut self) -> String {
        let mut out = String::new();
        loop {
            match self.step() {
                Step::Start(_) => self.skip(),
                Step::Text(text) => out.push_str(&text),
                Step::End | Step::Over => return out,
            }
        }
    }
}

/// The text of a reference: the five of XML itself and characters by number; others stay as written.
fn resolve(reference: &BytesRef<'_>) -> String {
    if let Ok(Some(character)) = reference.resolve_char_ref() {
        return character.to_string();
    }
    let name = reference.to_string();
    match quick_xml::escape::resolve_xml_entity(&name) {
        Some(text) => text.to_owned(),
        None => format!("&{name};"),
    }
}
