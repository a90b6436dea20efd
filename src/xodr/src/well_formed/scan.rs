//! Reads a whole document for nothing but what is wrong with it as XML.

use super::fault::{Fault, Faults};
use super::structure::Structure;
use super::{Attributes, comment, declaration, duplicates, instruction, text};
use crate::limits::Limits;
use crate::source::{Note, Refusal, Source};
use quick_xml::Error;
use quick_xml::errors::{IllFormedError, SyntaxError};
use quick_xml::events::Event;
use std::io::{self, BufRead};

/// What a document has wrong as XML.
#[derive(Debug, Default)]
pub struct Scan {
    /// Faults with the offset in the decoded text of the file.
    pub faults: Vec<(u64, Fault)>,
    /// Notes about the bytes.
    pub notes: Vec<Note>,
    /// Why reading ended early, by the input itself.
    pub refusal: Option<Refusal>,
    /// Whether elements nest deeper than the limit, with the offset of the first that does.
    pub too_deep: Option<u64>,
    /// Start tags read.
    pub elements: u64,
}

impl Scan {
    /// Whether the document was read to its end and XML allows everything in it, but for what mapd tolerates.
    pub fn is_well_formed(&self) -> bool {
        use crate::finding::Severity;
        self.refusal.is_none()
            && self.too_deep.is_none()
            && self.faults.iter().all(|(_, fault)| fault.severity() < Severity::Error)
            && !self.notes.iter().any(|note| note.kind.is_error())
    }
}

/// Scans a document. Faults that leave no doubt about what follows do not end it. Includes are not followed.
///
/// Errors: reading the input failed.
pub fn scan(mut source: Source<'_>, limits: &Limits) -> io::Result<Scan> {
    let mut scan = Scan::default();
    let mut faults = Faults::default();
    // Something must be read before the input knows what it passed over.
    match source.fill_buf() {
        Ok(_) => {}
        Err(error) if Source::refusal(&error).is_some() => {}
        Err(error) => return Err(error),
    }
    let skipped = source.skipped();
    let mut xml = quick_xml::Reader::from_reader(source);
    let config = xml.config_mut();
    config.allow_dangling_amp = true;
    config.check_end_names = true;
    let mut structure = Structure::default();
    let mut buffer = Vec::new();
    let piece = limits.tag_bytes.max(limits.text_bytes);
    loop {
        buffer.clear();
        xml.get_mut().begin_piece(piece);
        let start = skipped + xml.buffer_position();
        let is_first = start == 0;
        let mut is_doctype = false;
        match xml.read_event_into(&mut buffer) {
            Ok(Event::Start(tag)) => {
                scan.elements += 1;
                attributes(tag.as_bytes(), start + 1, &mut faults);
                structure.start(start, &mut faults);
                if structure.depth() > limits.depth {
                    scan.too_deep = Some(start);
                    break;
                }
            }
            Ok(Event::Empty(tag)) => {
                scan.elements += 1;
                attributes(tag.as_bytes(), start + 1, &mut faults);
                structure.start(start, &mut faults);
                structure.end();
            }
            Ok(Event::End(_)) => structure.end(),
            Ok(Event::Text(content)) => {
                structure.text(content.as_bytes(), start, &mut faults);
                text(content.as_bytes(), start, &mut faults);
            }
            Ok(Event::GeneralRef(name)) => {
                structure.section(start, &mut faults);
                text(format!("&{};", &*name).as_bytes(), start, &mut faults);
            }
            Ok(Event::CData(_)) => structure.section(start, &mut faults),
            Ok(Event::Comment(content)) => comment(content.as_bytes(), start + 4, &mut faults),
            Ok(Event::PI(content)) => instruction(content.as_bytes(), start + 2, &mut faults),
            Ok(Event::Decl(content)) => {
                structure.declaration(start, is_first, &mut faults);
                declaration(content.as_bytes(), start + 2, &mut faults);
            }
            Ok(Event::DocType(_)) => is_doctype = true,
            Ok(Event::Eof) => {
                structure.finish(start, &mut faults);
                break;
            }
            Err(Error::Io(error)) => match Source::refusal(&error) {
                Some(refusal) => {
                    scan.refusal = Some(refusal.clone());
                    break;
                }
                None => return Err(io::Error::new(error.kind(), error.to_string())),
            },
            Err(error) => {
                faults.add(skipped + xml.error_position(), fault(&error));
                break;
            }
        }
        if is_doctype {
            // The event has lost how it began.
            structure.document_type(&buffer, start, &mut faults);
        }
    }
    scan.faults = faults.take();
    scan.notes = xml.get_mut().take_notes();
    Ok(scan)
}

/// Looks at a tag's name and attributes.
fn attributes(content: &[u8], base: u64, faults: &mut Faults) {
    let mut attributes = Attributes::new(content, base, faults);
    let mut names = Vec::new();
    while let Some(attribute) = attributes.next(faults) {
        names.push((attribute.name, base + attribute.name_at as u64));
    }
    duplicates(&names, faults);
}

/// What quick-xml finds by itself, in our words.
fn fault(error: &Error) -> Fault {
    match error {
        Error::Syntax(SyntaxError::InvalidBangMarkup) => Fault::UnknownMarkup,
        Error::IllFormed(
            IllFormedError::MismatchedEndTag { .. }
            | IllFormedError::UnmatchedEndTag(_)
            | IllFormedError::MissingEndTag(_),
        ) => Fault::Mismatch,
        Error::IllFormed(IllFormedError::MissingDoctypeName) => Fault::Name,
        _ => Fault::Truncated,
    }
}
