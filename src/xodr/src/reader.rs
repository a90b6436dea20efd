//! The stream of top-level elements.

use crate::attributes::Context;
use crate::cursor::{Cursor, Step};
use crate::elements;
use crate::finding::{Finding, Severity, Span};
use crate::limits::Limits;
use crate::rule_ids;
use crate::source::LineIndex;
use crate::types::{Header, Junction, Road};
use std::io::{self, BufRead};

/// Name of the root element.
const ROOT: &str = "OpenDRIVE";

/// A top-level element.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// `header`.
    Header(Box<Header>),
    /// `road`.
    Road(Box<Road>),
    /// `junction`.
    Junction(Box<Junction>),
}

/// Where the walk stands.
#[derive(PartialEq)]
enum State {
    BeforeRoot,
    Inside,
    Done,
}

/// Reads a document as a stream of top-level elements.
pub struct Reader<R> {
    cursor: Cursor<R>,
    state: State,
    has_header: bool,
}

impl<R: BufRead> Reader<R> {
    /// A reader of a document.
    pub fn new(input: R, limits: Limits) -> Self {
        Self { cursor: Cursor::new(input, limits), state: State::BeforeRoot, has_header: false }
    }

    /// The next top-level element that mapd reads; none at the end of the document, or where an error makes reading on
    /// pointless.
    ///
    /// Errors: reading the input failed. What is wrong with the document is a finding.
    #[expect(
        clippy::should_implement_trait,
        reason = "an iterator could not be asked for findings in between"
    )]
    pub fn next(&mut self) -> io::Result<Option<Item>> {
        if self.state == State::BeforeRoot {
            self.root();
        }
        let item = if self.state == State::Inside { self.item() } else { None };
        match self.cursor.take_failure() {
            Some(error) => Err(error),
            None => Ok(item),
        }
    }

    /// Takes the findings since the last call.
    pub fn take_findings(&mut self) -> Vec<Finding> {
        std::mem::take(&mut self.cursor.findings)
    }

    /// Lines read so far.
    pub fn line_index(&self) -> &LineIndex {
        self.cursor.lines()
    }

    /// Bytes read so far.
    pub fn bytes_read(&self) -> u64 {
        self.cursor.offset()
    }

    /// Walks to the root and looks at it.
    fn root(&mut self) {
        loop {
            match self.cursor.step() {
                Step::Start(attributes) => {
                    let name = self.cursor.context().path;
                    let (prefix, local) = match name.rsplit_once(':') {
                        Some((prefix, local)) => (format!("{prefix}:"), local),
                        None => (String::new(), name.as_str()),
                    };
                    if local == ROOT {
                        self.cursor.set_root_prefix(prefix);
                        self.state = State::Inside;
                    } else {
                        let message = format!("expected the root element {ROOT}, found {name}");
                        self.cursor.refuse(rule_ids::ROOT, attributes.span.start, message);
                        self.state = State::Done;
                    }
                    return;
                }
                Step::Text(text) if text.trim().is_empty() => {}
                Step::Text(_) | Step::End => {
                    let start = self.cursor.offset();
                    self.cursor.refuse(
                        rule_ids::XML,
                        start,
                        format!("expected the element {ROOT}, found text"),
                    );
                    self.state = State::Done;
                    return;
                }
                Step::Over => {
                    if self.cursor.findings.iter().all(|f| f.severity != Severity::Error) {
                        let message =
                            format!("expected the root element {ROOT}, found the end of the file");
                        self.cursor.refuse(rule_ids::ROOT, 0, message);
                    }
                    self.state = State::Done;
                    return;
                }
            }
        }
    }

    fn item(&mut self) -> Option<Item> {
        loop {
            let attributes = match self.cursor.step() {
                Step::Start(attributes) => attributes,
                Step::Text(_) => continue,
                Step::End => {
                    self.finish();
                    return None;
                }
                Step::Over => {
                    self.state = State::Done;
                    return None;
                }
            };
            let path = self.cursor.context().path;
            let name = path.rsplit(['/', ':']).next().unwrap_or("").to_owned();
            let item = match name.as_str() {
                "header" => {
                    self.has_header = true;
                    Some(Item::Header(Box::new(elements::header(&mut self.cursor, &attributes))))
                }
                "road" => elements::road(&mut self.cursor, &attributes)
                    .map(|road| Item::Road(Box::new(road))),
                "junction" => elements::junction(&mut self.cursor, &attributes)
                    .map(|junction| Item::Junction(Box::new(junction))),
                _ => {
                    self.cursor.skip();
                    None
                }
            };
            // An element that the end of input cut off is not handed out.
            if self.cursor.is_over() {
                self.state = State::Done;
                return None;
            }
            if item.is_some() {
                return item;
            }
        }
    }

    /// The root has ended: nothing but white space and comments may follow.
    fn finish(&mut self) {
        self.state = State::Done;
        if !self.has_header {
            let message = "expected the element header, found none".to_owned();
            let mut context =
                Context { findings: &mut self.cursor.findings, path: ROOT.to_owned() };
            context.add(rule_ids::ELEMENT, Severity::Warning, Span::default(), message);
        }
        loop {
            let start = self.cursor.offset();
            match self.cursor.step() {
                Step::Text(text) if text.trim().is_empty() => {}
                Step::Over => return,
                _ => {
                    let message = format!("expected the end of the file after {ROOT}, found more");
                    self.cursor.refuse(rule_ids::XML, start, message);
                    return;
                }
            }
        }
    }
}
