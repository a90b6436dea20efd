//! What an input has wrong as bytes, and files that are included.

use crate::cursor::{Cursor, Markup, Scope};
use crate::finding::{Severity, Span};
use crate::findings::About;
use crate::markup::Text;
use crate::rule_ids;
use crate::source::{IncludeRefusal, Note, NoteKind, Places, RefusalKind};
use crate::well_formed::Fault;
use crate::window::{Stop, Window};

/// The rule by which an input is refused.
pub(crate) fn rule_of(kind: &RefusalKind) -> &'static str {
    match kind {
        RefusalKind::InvalidBytes(_) | RefusalKind::UnknownEncoding(_) => rule_ids::ENCODING,
        RefusalKind::Gzip(_) | RefusalKind::NestedGzip => rule_ids::COMPRESSION,
        RefusalKind::GzipRatio(_) | RefusalKind::DecodedBytes(_) | RefusalKind::Piece(_) => {
            rule_ids::LIMIT
        }
    }
}

impl Cursor<'_> {
    /// Turns the input's notes into findings.
    pub(crate) fn take_notes(&mut self) {
        let notes = self.window.source.take_notes();
        if !notes.is_empty() {
            self.add_notes(notes, self.window.source.file());
        }
    }

    /// Turns notes on a file into findings.
    pub(crate) fn add_notes(&mut self, notes: Vec<Note>, file: u16) {
        for note in notes {
            let severity = if note.kind.is_error() { Severity::Error } else { Severity::Warning };
            let rule = match note.kind {
                NoteKind::TextBeforeMarkup => rule_ids::BEFORE_DECLARATION,
                NoteKind::IllegalCharacter(_) | NoteKind::MoreIllegalCharacters => rule_ids::XML,
                _ => rule_ids::ENCODING,
            };
            let span = Span { start: Places::start(file, note.start), len: note.len };
            let message = note.kind.to_string();
            self.findings.add(rule, severity, span, About::text(""), || (String::new(), message));
        }
    }

    /// Opens a file that stands for its root's children, and reads its root. False, with a finding, where it is not read.
    pub(crate) fn enter_include(&mut self, reference: &str, at: Span) -> bool {
        if self.scope != Scope::Document {
            self.scope = Scope::Abandoned;
            self.over = true;
            return true;
        }
        let source = match self.inputs.include(reference, at.start) {
            Ok(source) => source,
            Err(refusal) => {
                let rule = if refusal.is_limit() { rule_ids::LIMIT } else { rule_ids::INCLUDE };
                let hint = match refusal {
                    IncludeRefusal::NoFolder => "; read without it",
                    _ => "",
                };
                self.add(rule, Severity::Error, at, "", format!("{refusal}{hint}"));
                return false;
            }
        };
        let limits = &self.limits;
        let window =
            Window::new(source, limits.tag_bytes.max(limits.text_bytes), limits.extension_bytes);
        let outer = std::mem::replace(&mut self.window, window);
        let structure = std::mem::take(&mut self.structure);
        self.outer.push((outer, structure));
        // The frames of the including file are no matter of the included root.
        let root = loop {
            match self.window.skip_space() {
                Some(b'<') => {}
                Some(_) | None => {
                    self.stopped(Some("an element to include"));
                    return true;
                }
            }
            self.window.want(2);
            match self.window.ahead().get(1) {
                Some(b'!' | b'?') => self.other_markup(Text::None),
                _ => break self.markup(Text::None),
            }
            if self.over {
                return true;
            }
        };
        if !matches!(root, Markup::Start) {
            return true;
        }
        let name = self.bytes((1, 1 + self.tag.name as u32)).to_vec();
        let parent = self.frames.last().map(|frame| self.name_of(&frame.name)).unwrap_or_default();
        let local = name.strip_prefix(self.prefix.as_slice()).unwrap_or(&name);
        if local != parent.as_bytes() {
            let found = String::from_utf8_lossy(&name).into_owned();
            let message = format!(
                "expected an included file whose root is {parent}, found {found}; passed over"
            );
            let span = self.tag.span;
            self.add(rule_ids::INCLUDE, Severity::Error, span, "", message);
            self.skip();
            self.leave_include();
        } else if self.tag.empty {
            self.leave_include();
        }
        true
    }

    /// The included root has ended: nothing but comments may follow; then on behind the include.
    pub(crate) fn leave_include(&mut self) {
        self.finish_file();
        self.take_notes();
        if self.over {
            return;
        }
        if let Some((outer, structure)) = self.outer.pop() {
            self.window = outer;
            self.structure = structure;
            self.inputs.leave();
        }
    }

    /// Reads what stands behind a file's root.
    pub(crate) fn finish_file(&mut self) {
        while !self.over {
            match self.window.skip_space() {
                None => break,
                Some(b'<') => {
                    self.window.want(2);
                    match self.window.ahead().get(1) {
                        Some(b'!' | b'?') => self.other_markup(Text::None),
                        _ => {
                            let start = self.window.start();
                            self.refuse(rule_ids::XML, start, Fault::SecondRoot.to_string());
                            return;
                        }
                    }
                }
                Some(_) => {
                    let start = self.window.start();
                    self.refuse(rule_ids::XML, start, Fault::TextOutside.to_string());
                    return;
                }
            }
        }
        match self.window.stop {
            Some(Stop::End) | None => {}
            Some(_) => self.stopped(None),
        }
    }
}
