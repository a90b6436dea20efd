//! The walk through a document: where it stands, and one step after the other.
//!
//! What a sound file needs on every element stands here; what is asked only where something is wrong, in `checks`.

use crate::checks::standard;
use crate::element::{self, Element};
use crate::extension::Extension;
use crate::finding::{Finding, KEY_BYTES, Severity, Span, shorten_id};
use crate::findings::{About, Findings};
use crate::limits::{ELEMENT_BYTES, Limits};
use crate::markup::Text;
use crate::rule_ids;
use crate::same::{same, without_prefix};
use crate::schema::{AttributeSchema, Choice, ElementSchema};
use crate::source::Inputs;
use crate::values;
use crate::well_formed::Structure;
use crate::window::{Stop, Window};
use std::io;

/// An attribute as it stands in the tag: places of its name and its value, counted from the tag's `<`.
#[derive(Clone, Copy, Default)]
pub(crate) struct RawAttribute {
    pub(crate) name: (u32, u32),
    pub(crate) value: (u32, u32),
}

/// The start tag that was read last.
#[derive(Default)]
pub(crate) struct Tag {
    pub(crate) attributes: Vec<RawAttribute>,
    /// Bytes of the name.
    pub(crate) name: usize,
    /// Whether it ends with `/>`.
    pub(crate) empty: bool,
    /// Whether it declares namespaces.
    pub(crate) declares: bool,
    pub(crate) span: Span,
}

/// An open element's name.
pub(crate) enum Name {
    /// One of the schema.
    Known(&'static str),
    /// Another, in the cursor's names: from where on, and how long.
    Other(usize, usize),
}

/// An open element.
pub(crate) struct OpenTag {
    pub(crate) name: Name,
    /// What tells it from others of its kind, in the cursor's names: the attribute, from where on, and how long.
    pub(crate) key: Option<(&'static str, usize, usize)>,
    /// Length of the cursor's names before it.
    names: usize,
}

/// An element of the schema while it is being read.
#[derive(Clone)]
pub(crate) struct Open {
    pub(crate) schema: &'static ElementSchema,
    /// The start tag.
    pub(crate) span: Span,
    /// Attributes seen, as bits.
    pub(crate) seen: u64,
    /// Children seen at all and more than once, as bits.
    pub(crate) children: u64,
    pub(crate) repeated: u64,
    /// Order of the last child.
    pub(crate) order: u16,
    pub(crate) variant: u8,
    /// Place of its counters.
    pub(crate) counts: usize,
    /// Files that were open when it began.
    pub(crate) files: usize,
    empty: bool,
    /// The attribute that is next in the tag, and the one of the schema that it should be.
    next: usize,
    expected: usize,
    /// The child that was last.
    last: usize,
}

/// The slot of an attribute that is not the expected one; none where the schema has no such attribute.
#[inline(never)]
fn slot_of(open: &Open, name: &[u8]) -> Option<usize> {
    let known = open.schema.attributes;
    let is = |slot: &usize| known.get(*slot).is_some_and(|a| same(a.name.as_bytes(), name));
    (open.expected + 1..known.len()).chain(0..open.expected).find(is)
}

/// A step through the children of an element.
pub(crate) enum NextChild {
    /// A child of the schema; its start tag has been read.
    Child(usize),
    /// Something else, read to its end.
    Extension(Extension),
    /// The element has ended, or the document has.
    End,
}

/// A piece of markup.
pub(crate) enum Markup {
    Start,
    End,
    /// The document has ended, or reading it makes no more sense.
    Over,
}

/// Where the value that is being read comes from.
#[derive(Clone, Copy)]
pub(crate) enum Current {
    Attribute(RawAttribute),
    Content,
}

/// The walk through a document.
pub(crate) struct Cursor<'a> {
    pub(crate) window: Window<'a>,
    /// The files that include the one that is being read.
    pub(crate) outer: Vec<(Window<'a>, Structure)>,
    pub(crate) inputs: Inputs,
    pub(crate) limits: Limits,
    pub(crate) findings: Findings,
    pub(crate) tag: Tag,
    pub(crate) current: Current,
    /// The schema of the value that is being read, and the span of its element.
    pub(crate) schema: &'static AttributeSchema,
    pub(crate) element: Span,
    /// Type of the element that is being read.
    pub(crate) kind: &'static ElementSchema,
    /// Rank of the version that is checked against.
    pub(crate) version: usize,
    /// The version as the file states it.
    pub(crate) stated: String,
    pub(crate) frames: Vec<OpenTag>,
    /// Names and keys of open elements, one behind the other.
    pub(crate) names: Vec<u8>,
    /// The child whose start tag has been read, and the variant of its parent.
    pub(crate) pending: &'static str,
    pub(crate) pending_variant: u8,
    pub(crate) counts: Vec<u16>,
    /// Prefix of the root with its colon; elements of the standard have it too.
    pub(crate) prefix: Vec<u8>,
    /// Namespace of the root.
    pub(crate) namespace: Vec<u8>,
    /// Text of the innermost element that has content, and where it begins.
    pub(crate) content: String,
    pub(crate) content_start: Option<u64>,
    /// Order of the parts of the file.
    pub(crate) structure: Structure,
    /// Whether an element beyond the standard's own is being read.
    pub(crate) within_extension: bool,
    /// Bytes that the top-level element has taken so far, as [`Limits::item_bytes`] counts them.
    pub(crate) spent: usize,
    pub(crate) scope: Scope,
    pub(crate) over: bool,
    pub(crate) failed: Option<io::Error>,
}

/// What is read: the document, or a batch of its top-level elements by itself.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scope {
    Document,
    Batch,
    /// A batch whose text ended where the next top-level element could begin.
    WholeBatch,
    /// A batch that needs what only the document's own reader has.
    Abandoned,
}

/// What is read where no element is.
static NO_ELEMENT: ElementSchema = ElementSchema::new("", &[], &[]);

/// Path of open elements, such as `OpenDRIVE/road[@id=12]/planView`.
pub(crate) fn path_of(frames: &[OpenTag], names: &[u8]) -> String {
    /// Bytes of a name or a key that are shown.
    const SHOWN: usize = KEY_BYTES;
    let text = |from: usize, len: usize| {
        let to = from + len.min(SHOWN);
        String::from_utf8_lossy(names.get(from..to).unwrap_or_default())
    };
    // A reference is longer than the character that it stands for.
    let key_text = |from: usize, len: usize| {
        let to = from + len.min(8 * SHOWN);
        let raw = String::from_utf8_lossy(names.get(from..to).unwrap_or_default());
        shorten_id(&values::text(&raw)).to_owned()
    };
    let mut path = String::new();
    for frame in frames {
        if !path.is_empty() {
            path.push('/');
        }
        match frame.name {
            Name::Known(name) => path += name,
            Name::Other(from, len) => path += &text(from, len),
        }
        if let Some((key, from, len)) = frame.key {
            path += &format!("[@{key}={}]", key_text(from, len));
        }
    }
    path
}

impl<'a> Cursor<'a> {
    pub(crate) fn new(inputs: Inputs, window: Window<'a>, limits: Limits) -> Self {
        Self {
            window,
            outer: Vec::new(),
            inputs,
            limits,
            findings: Findings::new(&limits),
            tag: Tag::default(),
            current: Current::Content,
            schema: &crate::checks::CONTENT,
            element: Span::default(),
            kind: &NO_ELEMENT,
            version: crate::schema::COUNT - 1,
            stated: String::new(),
            frames: Vec::new(),
            names: Vec::new(),
            pending: "",
            pending_variant: 0,
            counts: Vec::new(),
            prefix: Vec::new(),
            namespace: Vec::new(),
            content: String::new(),
            content_start: None,
            structure: Structure::default(),
            within_extension: false,
            spent: 0,
            scope: Scope::Document,
            over: false,
            failed: None,
        }
    }

    /// Begins the element whose start tag has been read.
    pub(crate) fn open(&mut self, schema: &'static ElementSchema) -> Open {
        self.spend(self.tag.span.len as usize + ELEMENT_BYTES);
        let name = Name::Known(self.pending);
        self.frames.push(OpenTag { name, key: None, names: self.names.len() });
        let counts = self.counts.len();
        if schema.counted != 0 {
            self.counts.resize(counts + schema.children.len(), 0);
        }
        if schema.content.is_some() {
            self.content.clear();
            self.content_start = None;
        }
        self.element = self.tag.span;
        self.kind = schema;
        Open {
            schema,
            span: self.tag.span,
            seen: 0,
            children: 0,
            repeated: 0,
            order: 0,
            variant: self.pending_variant,
            counts,
            files: self.outer.len(),
            empty: self.tag.empty,
            next: 0,
            expected: 0,
            last: 0,
        }
    }

    /// Bytes of the tag.
    pub(crate) fn bytes(&self, (from, to): (u32, u32)) -> &[u8] {
        self.window.token().get(from as usize..to as usize).unwrap_or_default()
    }

    /// The slot of the tag's next attribute that the schema knows; its value is then the current one.
    #[inline]
    pub(crate) fn next_attribute(&mut self, open: &mut Open) -> Option<usize> {
        loop {
            let raw = *self.tag.attributes.get(open.next)?;
            open.next += 1;
            let known = open.schema.attributes;
            let name = self.bytes(raw.name);
            let is_expected =
                known.get(open.expected).is_some_and(|a| same(a.name.as_bytes(), name));
            // Most files write attributes in the schema's order, some left out.
            let slot = if is_expected { Some(open.expected) } else { slot_of(open, name) };
            let Some(slot) = slot else {
                self.other_attribute(raw);
                continue;
            };
            let bit = 1 << slot;
            if open.seen & bit != 0 {
                self.twice(raw);
                continue;
            }
            open.seen |= bit;
            open.expected = slot + 1;
            self.current = Current::Attribute(raw);
            self.schema = &known[slot];
            if open.schema.key == Some(slot) {
                self.set_key(self.schema.name, raw);
            }
            return Some(slot);
        }
    }

    /// Lets paths name the element by an attribute.
    #[inline(never)]
    fn set_key(&mut self, name: &'static str, raw: RawAttribute) {
        let (from, to) = raw.value;
        let value = self.window.token().get(from as usize..to as usize).unwrap_or_default();
        let at = self.names.len();
        self.names.extend_from_slice(value);
        if let Some(frame) = self.frames.last_mut() {
            frame.key = Some((name, at, value.len()));
        }
    }

    /// Lets paths name the element whose attributes are being read, where the one that does stands behind the one that a finding is about.
    #[cold]
    pub(crate) fn find_key(&mut self) {
        let schema = self.kind;
        let name = schema.key.and_then(|slot| schema.attributes.get(slot)).map(|known| known.name);
        let is_named = self.frames.last().is_none_or(|frame| frame.key.is_some());
        if let Some(name) = name.filter(|_| !is_named)
            && let Some(raw) = self.find_attribute(name)
        {
            self.set_key(name, raw);
        }
    }

    /// All attributes have been read: are the right ones there?
    #[inline]
    pub(crate) fn finish_attributes(&mut self, open: &mut Open) {
        let schema = open.schema;
        let odd = open.seen & !schema.plain[self.version];
        let missing = schema.wanted[self.version] & !open.seen;
        if odd | missing != 0 || schema.variant.is_some() {
            self.check_attributes(open, odd, missing);
        }
    }

    /// The next child of an element.
    #[inline]
    pub(crate) fn next_child(&mut self, open: &mut Open) -> NextChild {
        if open.empty {
            self.close(open);
            return NextChild::End;
        }
        loop {
            // What is found between children is the element's own, whatever was read within them.
            self.kind = open.schema;
            let text = match (open.schema.content, open.schema.any) {
                (Some(_), _) => Text::Content,
                (None, true) => Text::Any,
                (None, false) => Text::None,
            };
            match self.markup(text) {
                Markup::Start => {}
                Markup::End if self.outer.len() > open.files => {
                    self.leave_include();
                    continue;
                }
                Markup::End => {
                    self.close(open);
                    return NextChild::End;
                }
                Markup::Over => return NextChild::End,
            }
            if let Some(slot) = self.child_slot(open) {
                self.enter(open, slot);
                return NextChild::Child(slot);
            }
            if let Some(extension) = self.other_child(open) {
                return NextChild::Extension(extension);
            }
            if self.over {
                return NextChild::End;
            }
        }
    }

    /// The slot of the child whose start tag has been read; none where the schema has no such child here.
    #[inline]
    fn child_slot(&self, open: &mut Open) -> Option<usize> {
        if self.tag.declares && self.is_redeclared() {
            return None;
        }
        let name = without_prefix(self.bytes((1, 1 + self.tag.name as u32)), &self.prefix)?;
        let children = open.schema.children;
        let is = |slot: usize| children.get(slot).is_some_and(|c| same(c.name.as_bytes(), name));
        // Most children stand in rows of one kind.
        if is(open.last) {
            return Some(open.last);
        }
        (open.last + 1..children.len()).chain(0..open.last).find(|slot| is(*slot))
    }

    /// Takes note of a child whose start tag has been read.
    #[inline]
    fn enter(&mut self, open: &mut Open, slot: usize) {
        let child = &open.schema.children[slot];
        let bit = 1 << slot;
        let order = open.order;
        self.count(open, slot);
        let plain = open.schema.plain_children[self.version];
        let again = open.repeated & bit & open.schema.single_children[self.version] != 0;
        if bit & !plain != 0 || again || child.order < order {
            self.check_child(open, child, again);
        }
        self.pending = child.name;
        self.pending_variant = open.variant;
    }

    /// Remembers a child.
    #[inline]
    pub(crate) fn count(&mut self, open: &mut Open, slot: usize) {
        let Some(child) = open.schema.children.get(slot) else { return };
        let bit = 1 << slot;
        open.repeated |= open.children & bit;
        open.children |= bit;
        open.last = slot;
        open.order = open.order.max(child.order);
        if open.schema.counted != 0
            && let Some(count) = self.counts.get_mut(open.counts + slot)
        {
            *count = count.saturating_add(1);
        }
    }

    /// Whether none of these children is there once too often, with those that an element has already.
    pub(crate) fn are_new(&self, open: &Open, slots: impl Iterator<Item = usize>) -> bool {
        let mut children = open.children;
        slots.into_iter().all(|slot| {
            let bit = 1 << slot;
            let again = children & bit & open.schema.single_children[self.version] != 0;
            children |= bit;
            !again
        })
    }

    /// An element has ended: are the right children there?
    #[inline]
    fn close(&mut self, open: &mut Open) {
        let schema = open.schema;
        let missing = schema.wanted_children[self.version] & !open.children;
        let chosen = (open.children & schema.chosen).count_ones();
        let badly = match schema.choice {
            Choice::One => chosen != 1,
            Choice::AtMostOne => chosen > 1,
            Choice::Any => false,
        };
        if missing != 0 || badly || self.miscounted(open).next().is_some() {
            self.check_children(open, missing);
        }
        self.counts.truncate(open.counts);
        self.pop_frame();
        self.element = open.span;
        if schema.content.is_some() {
            self.current = Current::Content;
            self.schema = &crate::checks::CONTENT;
            self.kind = schema;
        }
    }

    pub(crate) fn push_frame(&mut self, name: Name, names: usize) {
        self.frames.push(OpenTag { name, key: None, names });
    }

    pub(crate) fn pop_frame(&mut self) {
        if let Some(frame) = self.frames.pop() {
            self.names.truncate(frame.names);
        }
    }

    /// Path of the open elements.
    pub(crate) fn path(&self) -> String {
        path_of(&self.frames, &self.names)
    }

    /// Adds a finding about the innermost element. `detail` tells findings of one rule and element apart.
    pub(crate) fn add(
        &mut self,
        rule: &'static str,
        severity: Severity,
        span: Span,
        detail: &str,
        message: String,
    ) {
        self.add_by_standard(rule, severity, span, detail, |_| message);
    }

    /// As [`Self::add`], with a message that is made only where the finding is kept, from the standard's name.
    pub(crate) fn add_by_standard(
        &mut self,
        rule: &'static str,
        severity: Severity,
        span: Span,
        detail: &str,
        message: impl FnOnce(&str) -> String,
    ) {
        let (frames, names, stated, version) =
            (&self.frames, &self.names, &self.stated, self.version);
        let known = |frame: Option<&OpenTag>| match frame {
            Some(OpenTag { name: Name::Known(name), .. }) => *name,
            _ => "",
        };
        let (tag, top) = (known(frames.last()), known(frames.get(1)));
        let about = About { element: self.kind.name, tag, top, detail };
        self.findings.add(rule, severity, span, about, || {
            (path_of(frames, names), message(&standard(stated, version)))
        });
    }

    /// Counts what the top-level element takes; ends the walk where that is too much.
    #[inline]
    pub(crate) fn spend(&mut self, bytes: usize) {
        self.spent += bytes;
        if self.spent > self.limits.item_bytes && !self.over {
            self.overspent();
        }
    }

    #[cold]
    fn overspent(&mut self) {
        let message = format!(
            "expected at most {} bytes in one top-level element, {ELEMENT_BYTES} for each element within counted, found more",
            self.limits.item_bytes
        );
        self.refuse(rule_ids::LIMIT, self.window.start(), message);
    }

    /// Ends the walk with an error.
    pub(crate) fn refuse(&mut self, rule: &'static str, start: u64, message: String) {
        let path = self.path();
        let span = Span { start, len: 0 };
        self.findings.add(rule, Severity::Error, span, About::text(""), || (path, message));
        self.over = true;
    }

    /// Ends the walk because there is no more text. `expected` says what was still to come; none if nothing was.
    #[cold]
    pub(crate) fn stopped(&mut self, expected: Option<&str>) {
        self.over = true;
        let start = self.window.start();
        self.take_notes();
        match self.window.stop.take() {
            Some(Stop::Refused(refusal)) => {
                let start = crate::source::Places::start(self.window.source.file(), refusal.start);
                let rule = crate::notes::rule_of(&refusal.kind);
                self.refuse(rule, start, refusal.to_string());
            }
            Some(Stop::TooLarge) => {
                let message = format!(
                    "expected at most {} bytes in one piece of markup or text, found more",
                    self.window.limit
                );
                self.refuse(rule_ids::LIMIT, start, message);
            }
            Some(Stop::Failed(error)) => self.failed = Some(error),
            Some(Stop::End) | None => {
                if let Some(expected) = expected {
                    let start = self.window.offset();
                    self.refuse(
                        rule_ids::XML,
                        start,
                        format!("expected {expected}, found the end of the file"),
                    );
                }
            }
        }
    }

    /// Takes the findings since the last call.
    pub(crate) fn take_findings(&mut self) -> Vec<Finding> {
        self.findings.take()
    }
}

impl Cursor<'_> {
    /// Reads a child that may stand once; of several the first is kept.
    pub(crate) fn put<T: Element>(&mut self, place: &mut Option<Box<T>>) {
        let child = self.boxed();
        if place.is_none() {
            *place = Some(child);
        }
    }

    /// Reads a child that may stand several times.
    pub(crate) fn push<T: Element>(&mut self, list: &mut Vec<T>) {
        if list.capacity() == 0 {
            // Nearly all lists of lanes have one entry, and entries have hundreds of bytes.
            list.reserve_exact(1);
        }
        list.push(T::default());
        if let Some(child) = list.last_mut() {
            element::read(child, self);
        }
    }

    /// Reads an element that stands alone.
    pub(crate) fn boxed<T: Element>(&mut self) -> Box<T> {
        let mut child = Box::<T>::default();
        element::read(&mut *child, self);
        child
    }
}
