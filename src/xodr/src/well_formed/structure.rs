//! The order of a document's parts: declaration, document type, one root. (XML 1.0, 2.1 and 2.8)

use super::fault::{Fault, Faults};
use super::name::{head, is_name};

/// Which part of a document the reading is in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum DocumentPart {
    #[default]
    Prolog,
    Root,
    Epilog,
}

/// Follows the parts of one file. Every piece of markup and text is told to it once.
#[derive(Clone, Debug, Default)]
pub struct Structure {
    part: DocumentPart,
    /// Open elements.
    depth: usize,
    has_declaration: bool,
    has_doctype: bool,
}

impl Structure {
    /// Elements that are open.
    #[inline]
    pub fn depth(&self) -> usize {
        self.depth
    }

    /// A start tag, also that of an empty element, whose [`end`](Self::end) must be told as well.
    #[inline]
    pub fn start(&mut self, start: u64, faults: &mut Faults) {
        if self.depth == 0 {
            if self.part == DocumentPart::Epilog {
                faults.add(start, Fault::SecondRoot);
            }
            self.part = DocumentPart::Root;
        }
        self.depth += 1;
    }

    /// The end of an element.
    #[inline]
    pub fn end(&mut self) {
        self.depth = self.depth.saturating_sub(1);
        if self.depth == 0 {
            self.part = DocumentPart::Epilog;
        }
    }

    /// Text between tags.
    #[inline]
    pub fn text(&mut self, text: &[u8], start: u64, faults: &mut Faults) {
        if self.depth == 0 {
            let is_space = |byte: &u8| matches!(byte, b' ' | b'\t' | b'\n' | b'\r');
            if let Some(at) = text.iter().position(|byte| !is_space(byte)) {
                faults.add(start + at as u64, Fault::TextOutside);
            }
        }
    }

    /// A CDATA section or a reference.
    #[inline]
    pub fn section(&mut self, start: u64, faults: &mut Faults) {
        if self.depth == 0 {
            faults.add(start, Fault::TextOutside);
        }
    }

    /// An XML declaration. `is_first` says that it is the first thing in the file.
    pub fn declaration(&mut self, start: u64, is_first: bool, faults: &mut Faults) {
        if self.part != DocumentPart::Prolog || self.has_declaration || self.has_doctype {
            faults.add(start, Fault::ReservedTarget);
        } else if !is_first {
            faults.add(start, Fault::LateDeclaration);
        }
        self.has_declaration = true;
    }

    /// A document type, given from `<!DOCTYPE` to `>`.
    pub fn document_type(&mut self, markup: &[u8], start: u64, faults: &mut Faults) {
        if self.part != DocumentPart::Prolog || self.has_doctype {
            faults.add(start, Fault::MisplacedDocumentType);
        }
        self.has_doctype = true;
        let behind = markup.strip_prefix(b"<!DOCTYPE").unwrap_or_default();
        let name = behind.trim_ascii_start();
        let name = &name[..head(name).len];
        let is_spaced = behind.first().is_some_and(u8::is_ascii_whitespace);
        let fault = if !is_spaced || !is_name(name) {
            Fault::UnknownMarkup
        } else if memchr::memchr(b'[', behind).is_some() {
            Fault::InternalSubset
        } else {
            Fault::DocumentType
        };
        faults.add(start, fault);
    }

    /// The end of the file. `start` is the offset behind its last byte.
    pub fn finish(&self, start: u64, faults: &mut Faults) {
        match self.part {
            DocumentPart::Prolog => faults.add(start, Fault::NoRoot),
            DocumentPart::Root => faults.add(start, Fault::Unclosed),
            DocumentPart::Epilog => {}
        }
    }
}
