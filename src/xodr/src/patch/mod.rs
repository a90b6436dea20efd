//! Roads and junctions that take the place of others while a document is read: a shifted lane, a new road, one that is torn out.
//!
//! ```text
//!  document ── Splice ──► the same text, in which patched elements are those of the patch ──► Reader, which knows nothing of it
//!                 └── tells Places which stretch comes from which file, so that findings name line and column there
//! ```
//!
//! Invariants: the document is never whole in memory, the patch is; what is not patched is passed on byte for byte, behind a byte order
//! mark, so that what is noted on its bytes is the same as without a patch. Deliberately absent: whether a
//! road that is gone leaves links behind, which the rules find as in any other document.

mod markup;
mod splice;

use crate::source::Position;
use markup::{Kind, attribute, markup, name};
use std::collections::BTreeSet;
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;
use thiserror::Error;

pub(crate) use splice::Splice;

/// Longest patch \[bytes\].
pub const LONGEST_PATCH: u64 = 256 << 20;

/// The byte order mark of UTF-8.
const MARK: &[u8] = b"\xef\xbb\xbf";

/// What can be patched.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PatchedKind {
    /// A road.
    Road,
    /// A junction.
    Junction,
}

impl PatchedKind {
    /// The element's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Road => "road",
            Self::Junction => "junction",
        }
    }

    fn of(name: &[u8]) -> Option<Self> {
        [Self::Road, Self::Junction].into_iter().find(|kind| kind.name().as_bytes() == name)
    }
}

/// A road or junction by its id: `road:ID` or `junction:ID`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PatchedId {
    /// What it is.
    pub kind: PatchedKind,
    /// Its id.
    pub id: String,
}

impl fmt::Display for PatchedId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.kind.name(), self.id)
    }
}

impl FromStr for PatchedId {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (kind, id) = text.split_once(':').unwrap_or((text, ""));
        match PatchedKind::of(kind.as_bytes()) {
            Some(kind) if !id.is_empty() => Ok(Self { kind, id: id.to_owned() }),
            _ => Err("expected road:ID or junction:ID".to_owned()),
        }
    }
}

/// Why there is no patch, or why it does not fit the document.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum PatchError {
    /// Something in the patch.
    #[error("{file}:{line}:{column}: {why}")]
    Wrong {
        /// The patch.
        file: String,
        /// Line, from 1.
        line: u32,
        /// Column, from 1.
        column: u32,
        /// What is wrong.
        why: String,
    },
    /// What is to be removed is not there.
    #[error("the map has no {0} to remove")]
    NotThere(PatchedId),
    /// The patch has what is to be removed.
    #[error("{0} is to be removed, and the patch has it")]
    Both(PatchedId),
    /// The document's text cannot be put together with the patch's.
    #[error("the map is written in {0}; only UTF-8 can be patched")]
    Encoding(&'static str),
}

/// Elements that take the place of those of the same id, those that are new, and ids of those that go.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Patch {
    file: Option<PathBuf>,
    text: Vec<u8>,
    elements: Vec<PatchElement>,
    removed: Vec<PatchedId>,
}

/// An element of a patch.
#[derive(Clone, Debug, PartialEq, Eq)]
struct PatchElement {
    id: PatchedId,
    /// From where to where in the text.
    range: (usize, usize),
    at: Position,
}

impl Patch {
    /// A patch that removes these.
    pub fn removing(removed: Vec<PatchedId>) -> Self {
        Self { removed, ..Self::default() }
    }

    /// With the roads and junctions of an OpenDRIVE document. Its header says nothing: all is in the frame of the map that is patched.
    ///
    /// Errors: what is wrong with it, by line and column: it is no OpenDRIVE, has something else than roads and junctions, or one id twice.
    pub fn with_document(mut self, file: PathBuf, mut text: Vec<u8>) -> Result<Self, PatchError> {
        if text.starts_with(MARK) {
            text.drain(..MARK.len());
        }
        let wrong = |at: usize, why: &str| {
            let Position { line, column } = position(&text, at);
            let file = file.display().to_string();
            PatchError::Wrong { file, line, column, why: why.to_owned() }
        };
        if let Err(error) = std::str::from_utf8(&text) {
            return Err(wrong(error.valid_up_to(), "not UTF-8"));
        }
        let (mut elements, mut ids) = (Vec::new(), BTreeSet::new());
        let (mut depth, mut from, mut open) = (0_usize, 0, None);
        let mut ends = Vec::new();
        let (mut here, mut passed) = (Position { line: 1, column: 1 }, 0);
        while let Some(found) = markup(&text, from) {
            let tag = &text[found.start..found.end];
            from = found.end;
            match found.kind {
                Kind::Other => continue,
                Kind::Start | Kind::Empty
                    if depth == 0 && (name(tag) != b"OpenDRIVE" || !ends.is_empty()) =>
                {
                    return Err(wrong(found.start, "expected one element OpenDRIVE"));
                }
                Kind::Start | Kind::Empty if depth == 1 => match PatchedKind::of(name(tag)) {
                    Some(kind) => {
                        let id = attribute(tag, b"id").unwrap_or_default();
                        open = Some((PatchedId { kind, id }, found.start));
                    }
                    None if name(tag) == b"header" => {}
                    None => {
                        let why = "a patch has roads and junctions, nothing else";
                        return Err(wrong(found.start, why));
                    }
                },
                _ => {}
            }
            match found.kind {
                Kind::Start => {
                    ends.truncate(depth);
                    ends.push(name(tag).to_vec());
                    depth += 1;
                }
                Kind::End => {
                    let is_own =
                        depth > 0 && ends.get(depth - 1).map(Vec::as_slice) == Some(name(tag));
                    if !is_own {
                        return Err(wrong(found.start, "the end of what was not begun"));
                    }
                    depth -= 1;
                }
                Kind::Empty if depth == 0 => ends.push(Vec::new()),
                _ => {}
            }
            if depth == 1
                && let Some((id, start)) = open.take()
            {
                if id.id.is_empty() {
                    return Err(wrong(start, "has no id"));
                }
                if !ids.insert(id.clone()) {
                    return Err(wrong(start, &format!("a second {id}")));
                }
                advance(&mut here, &text[passed..start]);
                passed = start;
                elements.push(PatchElement { id, range: (start, found.end), at: here });
            }
        }
        if depth > 0 || ends.is_empty() {
            return Err(wrong(text.len(), "ends before OpenDRIVE does"));
        }
        if let Some(both) = elements.iter().find(|own| self.removed.contains(&own.id)) {
            return Err(PatchError::Both(both.id.clone()));
        }
        (self.file, self.text, self.elements) = (Some(file), text, elements);
        Ok(self)
    }

    /// The file that the elements come from.
    pub fn file(&self) -> Option<&PathBuf> {
        self.file.as_ref()
    }

    /// All that shapes what is read.
    pub fn bytes(&self) -> impl Iterator<Item = Vec<u8>> + '_ {
        let removed = self.removed.iter().map(|id| id.to_string().into_bytes());
        std::iter::once(self.text.clone()).chain(removed)
    }
}

fn position(text: &[u8], at: usize) -> Position {
    let mut here = Position { line: 1, column: 1 };
    advance(&mut here, &text[..at.min(text.len())]);
    here
}

/// Passes over a text.
fn advance(here: &mut Position, passed: &[u8]) {
    match memchr::memrchr(b'\n', passed) {
        Some(last) => {
            here.line += memchr::memchr_iter(b'\n', passed).count() as u32;
            here.column = (passed.len() - last) as u32;
        }
        None => here.column += passed.len() as u32,
    }
}
