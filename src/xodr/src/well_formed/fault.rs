//! What makes a document not well-formed, in words.

use crate::finding::Severity;
use std::fmt;

/// Something that XML does not allow, or that mapd does not read. All sections are those of XML 1.0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fault {
    /// A name with a character that names do not have, or none where one is due. (2.3)
    Name,
    /// An attribute that follows another one, or the tag's name, without white space. (3.1)
    NoSpace,
    /// An attribute without `=` and value. (3.1)
    NoValue,
    /// An attribute's value without quotes. (3.1)
    NoQuotes,
    /// An attribute's value whose closing quote is missing. (3.1)
    NoClosingQuote,
    /// Two attributes of one name. (3.1)
    Duplicate,
    /// `<` in an attribute's value. (3.1)
    LessThan,
    /// `&` that begins no reference. (2.4)
    Ampersand,
    /// A reference to an entity that is not one of the five. (4.1)
    Entity,
    /// A reference to a character that XML does not allow. (4.1)
    CharacterReference,
    /// `]]>` in text. (2.4)
    SectionEnd,
    /// `--` in a comment, or `-` at its end. (2.5)
    Hyphens,
    /// A processing instruction named `xml` in some case. (2.6)
    ReservedTarget,
    /// An XML declaration not at the start of the document. Read on: files in the wild have comments or line breaks before it.
    /// (2.8)
    LateDeclaration,
    /// An XML declaration that is not of the form due. (2.8)
    Declaration,
    /// A `DOCTYPE` that refers to a document type elsewhere or only names one. Not fetched. (2.8)
    DocumentType,
    /// A `DOCTYPE` with declarations of its own. None of them is applied. (2.8)
    InternalSubset,
    /// A `DOCTYPE` behind the root's start or a second one. (2.8)
    MisplacedDocumentType,
    /// A second root element. (2.1)
    SecondRoot,
    /// Text, a reference or a CDATA section outside of the root. (2.1)
    TextOutside,
    /// No root element. (2.1)
    NoRoot,
    /// The end of the document within an element. (3)
    Unclosed,
    /// Markup that ends with the document. (3)
    Truncated,
    /// `<!` that begins nothing known, such as a `doctype` in small letters. (2)
    UnknownMarkup,
    /// An end tag of another element than the innermost open one. (3)
    Mismatch,
}

impl Fault {
    /// How bad it is. Everything that XML forbids is an error, but the declaration's place.
    pub fn severity(self) -> Severity {
        match self {
            Self::LateDeclaration | Self::DocumentType => Severity::Warning,
            _ => Severity::Error,
        }
    }

    /// What was expected, and what was found and done.
    pub fn sentence(self) -> (&'static str, &'static str) {
        match self {
            Self::Name => ("a name", "a character that names do not have"),
            Self::NoSpace => ("white space before an attribute", "none"),
            Self::NoValue => ("= and a value behind an attribute's name", "none"),
            Self::NoQuotes => ("quotes around an attribute's value", "none"),
            Self::NoClosingQuote => ("the closing quote of an attribute's value", "the tag's end"),
            Self::Duplicate => ("each attribute once", "one with the name of an earlier one"),
            Self::LessThan => ("&lt; in an attribute's value", "<"),
            Self::Ampersand => ("&amp; or a reference", "& alone"),
            Self::Entity => {
                ("one of the entities amp, lt, gt, quot, apos", "another one; not expanded")
            }
            Self::CharacterReference => {
                ("the number of a character that XML allows", "another one; kept as written")
            }
            Self::SectionEnd => ("]]&gt; in text", "]]>"),
            Self::Hyphens => ("no -- in a comment", "some"),
            Self::ReservedTarget => ("another name than xml for an instruction", "that"),
            Self::LateDeclaration => (
                "the XML declaration at the start of the file",
                "it after something else, which is skipped",
            ),
            Self::Declaration => {
                ("an XML declaration with version, encoding, standalone", "another form")
            }
            Self::DocumentType => ("no document type", "one; not fetched and not used"),
            Self::InternalSubset => {
                ("no declarations within the document", "some; none of them is applied")
            }
            Self::MisplacedDocumentType => {
                ("a document type once, before the root", "it elsewhere")
            }
            Self::SecondRoot => ("the end of the document behind the root", "another element"),
            Self::TextOutside => ("no text outside of the root", "some"),
            Self::NoRoot => ("a root element", "the end of the document"),
            Self::Unclosed => ("the end of the element", "the end of the document"),
            Self::Truncated => ("the end of the markup", "the end of the document"),
            Self::UnknownMarkup => ("a comment, CDATA or DOCTYPE behind <!", "something else"),
            Self::Mismatch => ("the end tag of the innermost open element", "another one"),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (expected, found) = self.sentence();
        write!(out, "expected {expected}, found {found}")
    }
}

/// Collects faults with their places: offsets in the document's decoded text.
#[derive(Debug, Default)]
pub struct Faults {
    found: Vec<(u64, Fault)>,
    more: u64,
}

/// Faults that are kept; a document of faults only has one every few bytes.
const KEPT: usize = 1000;

impl Faults {
    /// Adds a fault. Beyond the first 1,000, faults are only counted.
    #[cold]
    pub fn add(&mut self, start: u64, fault: Fault) {
        if self.found.len() < KEPT {
            self.found.push((start, fault));
        } else {
            self.more += 1;
        }
    }

    /// Whether none was added since the last [`take`](Self::take).
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// Number of faults since the last [`take`](Self::take), those counted only among them.
    pub fn len(&self) -> usize {
        self.found.len().saturating_add(usize::try_from(self.more).unwrap_or(usize::MAX))
    }

    /// Takes the faults since the last call.
    pub fn take(&mut self) -> Vec<(u64, Fault)> {
        std::mem::take(&mut self.found)
    }

    /// Faults that were counted only.
    pub fn more(&self) -> u64 {
        self.more
    }
}
