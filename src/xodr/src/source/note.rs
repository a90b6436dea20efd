//! What an input has wrong as bytes: notes, which it is read on with, and refusals, which end it.

use std::fmt;

/// Something about the input that is read on with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// First byte in the decoded text.
    pub start: u64,
    /// Number of bytes of the decoded text.
    pub len: u32,
    /// What it is.
    pub kind: NoteKind,
}

/// Kinds of notes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoteKind {
    /// Text other than white space stands before the first `<`. It is passed over. (XML 1.0, 2.1 and 2.8)
    TextBeforeMarkup,
    /// A character that XML does not allow, not even as a reference. It is kept. (XML 1.0, 2.2)
    IllegalCharacter(char),
    /// More illegal characters than are noted one by one.
    MoreIllegalCharacters,
    /// The declaration names another encoding than the bytes are in. The bytes win. (XML 1.0, 4.3.3)
    EncodingDisagrees {
        /// The name in the declaration.
        declared: String,
        /// What the input is read as.
        used: &'static str,
    },
    /// UTF-16 without a byte order mark; its order was seen from the first characters. (XML 1.0, 4.3.3)
    NoByteOrderMark,
    /// A byte from 80 to 9F hex in ISO-8859-1, where it is a control character: Windows-1252 was probably meant.
    ControlInLatin1,
}

impl NoteKind {
    /// Whether the document is not well-formed for it.
    pub fn is_error(&self) -> bool {
        matches!(self, Self::IllegalCharacter(_) | Self::MoreIllegalCharacters)
    }
}

impl fmt::Display for NoteKind {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TextBeforeMarkup => {
                write!(out, "expected the XML to begin, found text before the first <; passed over")
            }
            Self::IllegalCharacter(character) => {
                let code = u32::from(*character);
                write!(out, "expected a character that XML allows, found U+{code:04X}; kept")
            }
            Self::MoreIllegalCharacters => {
                write!(out, "expected characters that XML allows, found more of others")
            }
            Self::EncodingDisagrees { declared, used } => {
                write!(
                    out,
                    "expected the declared encoding {declared:?}, found {used}; read as {used}"
                )
            }
            Self::NoByteOrderMark => {
                write!(
                    out,
                    "expected a byte order mark before UTF-16, found none; order seen from the first characters"
                )
            }
            Self::ControlInLatin1 => {
                write!(
                    out,
                    "expected text in ISO-8859-1, found a control character from 80 to 9F hex; kept as that"
                )
            }
        }
    }
}

/// Why an input is not read further.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{kind}")]
pub struct Refusal {
    /// Byte of the decoded text where it ends.
    pub start: u64,
    /// Why.
    pub kind: RefusalKind,
}

/// Kinds of refusals.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RefusalKind {
    /// Bytes that are no character in the encoding.
    #[error("expected text in {0}, found invalid bytes")]
    InvalidBytes(&'static str),
    /// The declared encoding is not known, or one that hides markup.
    #[error("expected an encoding that is read, found {0:?}")]
    UnknownEncoding(String),
    /// The compressed data is damaged or ends early.
    #[error("expected gzip data, found other data ({0})")]
    Gzip(String),
    /// Gzip within gzip.
    #[error("expected XML within gzip, found gzip again")]
    NestedGzip,
    /// Gzip shrunk the input more than allowed.
    #[error("expected gzip to shrink at most {0} times, found more")]
    GzipRatio(u64),
    /// The document with its includes is too large.
    #[error("expected at most {0} bytes in the document with its includes, found more")]
    DecodedBytes(u64),
    /// One tag, text, comment or other piece is too large.
    #[error("expected at most {0} bytes in one piece of markup or text, found more")]
    Piece(usize),
}

impl RefusalKind {
    /// Whether a limit was passed rather than something being wrong.
    pub fn is_limit(&self) -> bool {
        matches!(self, Self::GzipRatio(_) | Self::DecodedBytes(_) | Self::Piece(_))
    }
}
