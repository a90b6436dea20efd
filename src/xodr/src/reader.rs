//! The stream of top-level elements.

use crate::batch::{
    Batch, Context, ContextData, Cutter, Entered, ReadBatch, ReadPart, RestOfDocument, RootChild,
};
use crate::counted::CountedFindings;
use crate::cursor::{Cursor, Markup, NextChild, Open};
use crate::extension::{Extension, Extensions};
use crate::finding::{Finding, Severity, Span};
use crate::findings::{Findings, KeptFinding};
use crate::generated::{Item, read_document, schema_document};
use crate::limits::{ELEMENT_BYTES, Limits};
use crate::markup::Text;
use crate::other;
use crate::rule_ids;
use crate::schema::NAMES;
use crate::source::{Inputs, Places, Position, Source};
use crate::well_formed::{Fault, Faults};
use crate::window::Window;
use std::collections::VecDeque;
use std::io::{self, Read};
use std::path::Path;

/// Name of the root element.
pub(crate) const ROOT: &str = "OpenDRIVE";

/// Where the walk stands.
enum State {
    BeforeRoot,
    Inside(Box<Open>),
    Done,
}

/// Reads a document as a stream of top-level elements.
pub struct Reader<'a> {
    cursor: Cursor<'a>,
    state: State,
    extensions: Extensions,
    /// Bytes of these.
    extended: usize,
    /// What was read ahead of it.
    accepted: VecDeque<Accepted>,
}

/// A top-level element of a batch.
pub enum Delivered {
    /// The element.
    Item(Item),
    /// It was taken away: [`Context::read_each`].
    Taken,
}

/// A step of what was read ahead.
enum Accepted {
    /// A child of the root, and what was found about it.
    Child(RootChild, (Vec<KeptFinding>, CountedFindings), Option<Misplaced>),
    /// The batch has ended.
    Rest(Findings),
}

/// A child of the root that stands behind others that it should stand before.
struct Misplaced {
    name: &'static str,
    entered: Entered,
    message: String,
}

impl Reader<'static> {
    /// A reader of a file, compressed or not; what it includes must lie in its folder.
    ///
    /// Errors: the file cannot be opened.
    pub fn open(path: &Path, limits: Limits) -> io::Result<Self> {
        let mut inputs = Inputs::new(limits.source);
        let source = inputs.open_file(path)?;
        Ok(Self::with_source(inputs, source, limits))
    }
}

impl<'a> Reader<'a> {
    /// A reader of a document that is no file, such as bytes in memory. It cannot include files.
    pub fn new(input: impl Read + Send + 'a, limits: Limits) -> Self {
        let mut inputs = Inputs::new(limits.source);
        let source = inputs.open(Box::new(input), "");
        Self::with_source(inputs, source, limits)
    }

    /// A reader of the main input, opened with `inputs`, which says where files may be included from.
    pub fn with_source(inputs: Inputs, source: Source<'a>, limits: Limits) -> Self {
        let limit = limits.tag_bytes.max(limits.text_bytes);
        let window = Window::new(source, limit, limits.extension_bytes);
        Self {
            cursor: Cursor::new(inputs, window, limits),
            state: State::BeforeRoot,
            extensions: Extensions::default(),
            extended: 0,
            accepted: VecDeque::new(),
        }
    }

    /// The next top-level element; none at the end of the document, or where an error makes reading on pointless. An
    /// element that the end of the input cuts off is not handed out.
    ///
    /// Errors: reading the input failed. What is wrong with the document is a finding.
    #[expect(
        clippy::should_implement_trait,
        reason = "an iterator could not be asked for findings in between"
    )]
    pub fn next(&mut self) -> io::Result<Option<Item>> {
        self.cursor.findings.set_counted(CountedFindings::default());
        if matches!(self.state, State::BeforeRoot) {
            self.root();
        }
        let item = self.item();
        self.cursor.take_notes();
        if item.is_none() {
            self.state = State::Done;
            self.cursor.findings.finish();
        }
        match self.cursor.failed.take() {
            Some(error) => Err(error),
            None => Ok(item),
        }
    }

    /// Takes the findings since the last call. Where many are of one kind, the last call has how many more there were.
    pub fn take_findings(&mut self) -> Vec<Finding> {
        self.cursor.take_findings()
    }

    /// Takes what was only counted about the item that was handed out last, and says of an attribute that its value is not there.
    pub fn take_counted(&mut self) -> CountedFindings {
        self.cursor.findings.take_counted()
    }

    /// The revision that the header states, such as `1.7`; empty before the header and where it states none.
    pub fn stated_version(&self) -> &str {
        &self.cursor.stated
    }

    /// The version of the standard that the document is checked against.
    pub fn checked_version(&self) -> &'static str {
        NAMES[self.cursor.version]
    }

    /// Files and lines read so far.
    pub fn places(&self) -> &Places {
        self.cursor.inputs.places()
    }

    /// Line and column of a span's start in its file.
    pub fn position(&self, start: u64) -> Position {
        self.places().position(start)
    }

    /// Bytes of decoded text read so far of the file that is being read.
    pub fn bytes_read(&self) -> u64 {
        Places::offset_of(self.cursor.window.offset())
    }

    /// What stands in the root beyond the standard's own elements, as far as it was read.
    pub fn extensions(&self) -> &Extensions {
        &self.extensions
    }

    /// Walks to the root and looks at it.
    fn root(&mut self) {
        let cursor = &mut self.cursor;
        let markup = loop {
            match cursor.window.skip_space() {
                Some(b'<') => {
                    cursor.window.want(2);
                    match cursor.window.ahead().get(1) {
                        Some(b'!' | b'?') => cursor.other_markup(Text::None),
                        Some(b'/') => {
                            let start = cursor.window.start();
                            cursor.refuse(rule_ids::XML, start, Fault::Mismatch.to_string());
                        }
                        _ => break cursor.markup(Text::None),
                    }
                }
                Some(_) => {
                    let start = cursor.window.start();
                    cursor.refuse(rule_ids::XML, start, Fault::TextOutside.to_string());
                }
                None => {
                    cursor.stopped(None);
                    let start = cursor.window.start();
                    if cursor.findings.errors == 0 && cursor.failed.is_none() {
                        let message =
                            format!("expected the root element {ROOT}, found the end of the file");
                        cursor.refuse(rule_ids::ROOT, start, message);
                    }
                }
            }
            if cursor.over {
                return;
            }
        };
        if matches!(markup, Markup::Start) {
            self.enter_root();
        }
    }

    /// Looks at the root's name and namespace.
    fn enter_root(&mut self) {
        let cursor = &mut self.cursor;
        let full = cursor.bytes((1, 1 + cursor.tag.name as u32)).to_vec();
        let prefix = memchr::memrchr(b':', &full).map_or(0, |at| at + 1);
        let (prefix, local) = full.split_at(prefix);
        let span = cursor.tag.span;
        cursor.structure.start(span.start, &mut Faults::default());
        if local != ROOT.as_bytes() {
            let found = String::from_utf8_lossy(&full).into_owned();
            let message = format!("expected the root element {ROOT}, found {found}");
            cursor.refuse(rule_ids::ROOT, span.start, message);
            return;
        }
        cursor.prefix = prefix.to_vec();
        let key = match prefix.strip_suffix(b":") {
            Some(prefix) => format!("xmlns:{}", String::from_utf8_lossy(prefix)),
            None => "xmlns".to_owned(),
        };
        cursor.namespace = cursor.attribute_text(&key).into_bytes();
        cursor.pending = ROOT;
        let mut open = cursor.open(&schema_document::OPEN_DRIVE);
        if !other::is_opendrive(&cursor.namespace) {
            let found = String::from_utf8_lossy(&cursor.namespace).into_owned();
            let message = format!(
                "expected no namespace or one of OpenDRIVE's, found {found}; read as OpenDRIVE"
            );
            let span = Span { len: 0, ..span };
            cursor.add(rule_ids::NAMESPACE, Severity::Warning, span, "", message);
        }
        while cursor.next_attribute(&mut open).is_some() {}
        cursor.finish_attributes(&mut open);
        self.state = State::Inside(Box::new(open));
    }

    fn item(&mut self) -> Option<Item> {
        let State::Inside(open) = &mut self.state else { return None };
        let cursor = &mut self.cursor;
        loop {
            if cursor.over {
                return None;
            }
            match cursor.next_child(open) {
                NextChild::Child(slot) => {
                    if cursor.pending == "header" {
                        cursor.set_version();
                    }
                    let item = read_document::item(slot, cursor);
                    cursor.spent = 0;
                    return item.filter(|_| !cursor.over);
                }
                NextChild::Extension(extension) => {
                    cursor.spent = 0;
                    let kept = (&mut self.extensions, &mut self.extended);
                    keep(extension, kept, cursor);
                }
                NextChild::End => {
                    if !cursor.over {
                        cursor.structure.end();
                        cursor.finish_file();
                    }
                    return None;
                }
            }
        }
    }
}

/// Keeps an extension of the root, as long as there are not too many.
fn keep(
    extension: Extension,
    (extensions, extended): (&mut Extensions, &mut usize),
    cursor: &mut Cursor<'_>,
) {
    let bytes = extension.text.len() + ELEMENT_BYTES;
    if *extended + bytes <= cursor.limits.item_bytes {
        *extended += bytes;
        extensions.push(extension);
        return;
    }
    let message =
        "expected less beyond the standard's own elements in the root, found more; not kept";
    cursor.add(rule_ids::NOT_KEPT, Severity::Warning, extension.span, "", message.to_owned());
}

/// Reading ahead. The same items and findings come as without it, in the same order.
impl<'a> Reader<'a> {
    /// Takes away the rest of the document, to be read in batches, and what their reading needs to know. None where that
    /// cannot be done here, as within an included file. Sensible behind the header, which settles the version.
    pub fn split(&mut self) -> Option<RestOfDocument<'a>> {
        let State::Inside(root) = &self.state else { return None };
        let cursor = &mut self.cursor;
        if cursor.over || !cursor.outer.is_empty() || cursor.window.stop.is_some() {
            return None;
        }
        let file = cursor.window.source.file();
        let context = Context::new(ContextData {
            limits: cursor.limits,
            file,
            version: cursor.version,
            stated: cursor.stated.clone(),
            prefix: cursor.prefix.clone(),
            namespace: cursor.namespace.clone(),
            root: (**root).clone(),
            counts: cursor.counts.clone(),
            structure: cursor.structure.clone(),
        });
        let nothing = cursor.inputs.nothing(file);
        let rest = cursor.window.hand_over(nothing);
        Some(RestOfDocument { context, cutter: Cutter::new(rest, &cursor.prefix) })
    }

    /// The context for the next batch: that of [`Reader::split`], with the kinds of findings of which no more are kept by now. Of those the
    /// batch only counts what it finds.
    pub fn context(&self, split: &Context) -> Context {
        split.with_used_up(self.cursor.findings.used_up())
    }

    /// Takes what was read of the next batch; [`Reader::accepted`] hands it out. Yields the room of its text. Errors: it cannot be read by itself, and is
    /// given back: from it on the document has to be read as one, see [`Reader::go_on`].
    pub fn accept(&mut self, mut read: ReadBatch) -> Result<Vec<u8>, Batch> {
        let State::Inside(root) = &mut self.state else { return Err(read.batch) };
        let slots = read.parts.iter().filter_map(|part| part.slot);
        if !read.is_whole || !self.cursor.are_new(root, slots) {
            return Err(read.batch);
        }
        let cursor = &mut self.cursor;
        let notes = read.batch.take_notes();
        cursor.add_notes(notes, cursor.window.source.file());
        cursor.window.move_to(read.batch.start + read.batch.text.len() as u64);
        for ReadPart { slot, part, findings, counted, entered } in read.parts {
            let child = slot.and_then(|slot| root.schema.children.get(slot));
            let misplaced = child.filter(|child| child.order < root.order).map(|child| {
                let (name, message) = (child.name, cursor.misplaced(root, child));
                Misplaced { name, entered, message }
            });
            if let Some(slot) = slot {
                cursor.count(root, slot);
            }
            self.accepted.push_back(Accepted::Child(part, (findings, counted), misplaced));
        }
        cursor.kind = root.schema;
        self.accepted.push_back(Accepted::Rest(read.rest));
        Ok(read.batch.text)
    }

    /// The next top-level element of the batch that was accepted last; none at its end. Those that were taken away are passed
    /// over.
    pub fn accepted(&mut self) -> Option<Item> {
        loop {
            if let Delivered::Item(item) = self.delivered()? {
                return Some(item);
            }
        }
    }

    /// As [`Reader::accepted`], but tells where an element was that [`Context::read_each`] gave away.
    pub fn delivered(&mut self) -> Option<Delivered> {
        loop {
            match self.accepted.pop_front()? {
                Accepted::Child(part, (mut findings, counted), misplaced) => {
                    let cursor = &mut self.cursor;
                    cursor.findings.set_counted(counted);
                    if let Some(Misplaced { name, entered, message }) = misplaced {
                        let behind = findings.split_off(entered.findings.min(findings.len()));
                        findings.into_iter().for_each(|kept| cursor.findings.add_again(kept));
                        findings = behind;
                        let (rule, severity) = (rule_ids::ORDER, Severity::Warning);
                        cursor.add(rule, severity, entered.span, name, message);
                    }
                    findings.into_iter().for_each(|kept| cursor.findings.add_again(kept));
                    match part {
                        RootChild::Item(item) => return Some(Delivered::Item(item)),
                        RootChild::Taken => return Some(Delivered::Taken),
                        RootChild::Extension(extension) => {
                            let kept = (&mut self.extensions, &mut self.extended);
                            keep(extension, kept, cursor);
                        }
                    }
                }
                Accepted::Rest(mut findings) => {
                    let kept = findings.take_kept();
                    kept.into_iter().for_each(|kept| self.cursor.findings.add_again(kept));
                    self.cursor.findings.add_counts(findings);
                }
            }
        }
    }

    /// Reads on as if nothing had been taken away: first these batches, which follow each other, then what the cutter has.
    pub fn go_on(&mut self, batches: impl IntoIterator<Item = Batch>, cutter: Cutter<'a>) {
        let (mut text, mut start) = (Vec::new(), None);
        for mut batch in batches {
            start = start.or(Some(batch.start));
            text.extend_from_slice(&batch.text);
            self.cursor.add_notes(batch.take_notes(), cutter.source.file());
        }
        let start = start.unwrap_or(cutter.start);
        text.extend_from_slice(cutter.text());
        let hold_limit = self.cursor.limits.extension_bytes;
        self.cursor.window.go_on(text, start, cutter.source, hold_limit, cutter.stop);
    }
}
