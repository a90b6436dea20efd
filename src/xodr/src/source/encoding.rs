//! From bytes to UTF-8.

use super::note::{Note, NoteKind, RefusalKind};
use super::prolog;
use encoding_rs::{DecoderResult, Encoding, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};

/// How the bytes of an input become UTF-8.
pub(super) enum Decoder {
    /// They are UTF-8 already.
    Utf8,
    /// Each byte is the character of that number.
    Latin1,
    /// Any other encoding.
    Other(Box<encoding_rs::Decoder>),
}

/// What decoding a piece came to.
pub(super) struct Decoded {
    /// Bytes taken from the input.
    pub(super) taken: usize,
    /// Bytes written, all of them whole characters.
    pub(super) written: usize,
    /// Whether the bytes behind those are no character.
    pub(super) invalid: bool,
}

/// What the first bytes of an input say.
pub(super) struct Detected {
    pub(super) decoder: Decoder,
    /// Bytes of the byte order mark.
    pub(super) mark: usize,
    pub(super) notes: Vec<Note>,
}

/// Recognises the encoding from the first bytes: by the byte order mark, by the pattern of zeros, by the declaration.
/// (XML 1.0, appendix F)
pub(super) fn detect(head: &[u8]) -> Result<Detected, RefusalKind> {
    let mut notes = Vec::new();
    let refuse = |label: &str| Err(RefusalKind::UnknownEncoding(label.to_owned()));
    let wide = |encoding: &'static Encoding| {
        Decoder::Other(Box::new(encoding.new_decoder_without_bom_handling()))
    };
    let (decoder, mark) = match head {
        [0xff, 0xfe, 0, 0, ..]
        | [0, 0, 0xfe, 0xff, ..]
        | [b'<', 0, 0, 0, ..]
        | [0, 0, 0, b'<', ..] => {
            return refuse("UTF-32");
        }
        [0xff, 0xfe, ..] => (wide(UTF_16LE), 2),
        [0xfe, 0xff, ..] => (wide(UTF_16BE), 2),
        [b'<', 0, ..] => (wide(UTF_16LE), 0),
        [0, b'<', ..] => (wide(UTF_16BE), 0),
        [0xef, 0xbb, 0xbf, ..] => (Decoder::Utf8, 3),
        _ => return declared(head, notes),
    };
    if mark == 0 {
        notes.push(Note { start: 0, len: 1, kind: NoteKind::NoByteOrderMark });
    }
    if mark == 3 {
        let found = prolog::look(&head[mark..]);
        if let Some((label, at)) = found.encoding.filter(|(label, _)| !is_utf8(label)) {
            notes.push(disagrees(label, at, UTF_8.name()));
        }
    }
    Ok(Detected { decoder, mark, notes })
}

/// The encoding that the declaration names.
fn declared(head: &[u8], mut notes: Vec<Note>) -> Result<Detected, RefusalKind> {
    let utf8 = |notes| Ok(Detected { decoder: Decoder::Utf8, mark: 0, notes });
    let Some((label, at)) = prolog::look(head).encoding else { return utf8(notes) };
    if is_utf8(label) {
        return utf8(notes);
    }
    let text = String::from_utf8_lossy(label).into_owned();
    let Some(encoding) = Encoding::for_label_no_replacement(label) else {
        return Err(RefusalKind::UnknownEncoding(text));
    };
    let decoder = match encoding {
        // Markup could be read, so the bytes are not what the declaration says.
        _ if encoding == UTF_16LE || encoding == UTF_16BE => {
            notes.push(disagrees(label, at, UTF_8.name()));
            Decoder::Utf8
        }
        // The web reads ISO-8859-1 as Windows-1252; XML does not.
        _ if encoding == WINDOWS_1252 && !text.contains("1252") => Decoder::Latin1,
        // Escape sequences change what `<` means.
        _ if !encoding.is_ascii_compatible() => return Err(RefusalKind::UnknownEncoding(text)),
        _ => Decoder::Other(Box::new(encoding.new_decoder_without_bom_handling())),
    };
    Ok(Detected { decoder, mark: 0, notes })
}

/// ASCII is read as the UTF-8 that it is.
fn is_utf8(label: &[u8]) -> bool {
    let ascii: [&[u8]; 3] = [b"us-ascii", b"ascii", b"ansi_x3.4-1968"];
    ascii.iter().any(|name| label.eq_ignore_ascii_case(name))
        || Encoding::for_label(label).is_some_and(|encoding| encoding == UTF_8)
}

fn disagrees(label: &[u8], at: usize, used: &'static str) -> Note {
    let declared = String::from_utf8_lossy(label).into_owned();
    Note { start: at as u64, len: 5, kind: NoteKind::EncodingDisagrees { declared, used } }
}

impl Decoder {
    /// The standard name of the encoding.
    pub(super) fn name(&self) -> &'static str {
        match self {
            Self::Utf8 => UTF_8.name(),
            Self::Latin1 => "ISO-8859-1",
            Self::Other(decoder) => decoder.encoding().name(),
        }
    }

    /// Decodes bytes of an encoding other than UTF-8. `last` says that no more follow.
    pub(super) fn decode(&mut self, from: &[u8], to: &mut [u8], last: bool) -> Decoded {
        match self {
            Self::Utf8 => {
                let written = from.len().min(to.len());
                to[..written].copy_from_slice(&from[..written]);
                Decoded { taken: written, written, invalid: false }
            }
            Self::Latin1 => {
                let (taken, written) = encoding_rs::mem::convert_latin1_to_utf8_partial(from, to);
                Decoded { taken, written, invalid: false }
            }
            Self::Other(decoder) => {
                let (result, taken, written) =
                    decoder.decode_to_utf8_without_replacement(from, to, last);
                let invalid = matches!(result, DecoderResult::Malformed(..));
                Decoded { taken, written, invalid }
            }
        }
    }
}
