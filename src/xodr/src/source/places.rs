//! Places in a document that consists of several files.

use super::line_index::{LineIndex, Position};
use std::collections::BTreeSet;
use std::fmt;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Bits of a start that hold the offset in a file: 256 TiB. The file's number stands above them.
const OFFSET_BITS: u32 = 48;
const OFFSET_MASK: u64 = (1 << OFFSET_BITS) - 1;

/// A place as printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceLocation {
    /// Name of the file as it was opened.
    pub file: Arc<str>,
    /// Line and column in the file's decoded text.
    pub position: Position,
}

impl fmt::Display for SourceLocation {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}:{}:{}", self.file, self.position.line, self.position.column)
    }
}

#[derive(Debug)]
struct File {
    name: Arc<str>,
    /// Where the `include` stands; none for the main file.
    included_at: Option<u64>,
    lines: LineIndex,
    /// Where stretches of its text come from, if they are not its own, ascending.
    pieces: Vec<SourcePiece>,
}

/// A stretch of a text, up to the next one.
#[derive(Clone, Copy, Debug)]
struct SourcePiece {
    /// Offset at which it begins.
    start: u64,
    /// The file that it comes from, and where it stands there.
    file: u16,
    at: Position,
}

impl File {
    /// The stretch that holds an offset; none if it is the file's own.
    fn piece(&self, offset: u64) -> Option<&SourcePiece> {
        self.pieces[..self.pieces.partition_point(|piece| piece.start <= offset)].last()
    }

    /// The file that an offset of this one's text comes from, and line and column there; none if it is its own.
    fn written(&self, offset: u64) -> Option<(u16, Position)> {
        let piece = self.piece(offset)?;
        let [begin, own] = [piece.start, offset].map(|offset| self.lines.position(offset));
        let at = match own.line - begin.line {
            0 => Position { column: piece.at.column + (own.column - begin.column), ..piece.at },
            more => Position { line: piece.at.line + more, column: own.column },
        };
        Some((piece.file, at))
    }
}

/// The files of a document and where their lines begin. Clones share what they know.
///
/// ```
/// use mapd_xodr::source::{Inputs, SourceLimits};
/// use std::io::Read as _;
///
/// let mut inputs = Inputs::new(SourceLimits::default());
/// let mut source = inputs.open(Box::new(&b"<a>\n<b/></a>"[..]), "tiny.xodr");
/// source.read_to_string(&mut String::new()).unwrap();
/// assert_eq!(inputs.places().place(4).to_string(), "tiny.xodr:2:1");
/// ```
#[derive(Clone, Debug, Default)]
pub struct Places {
    files: Arc<Mutex<Vec<File>>>,
    /// Files that were to be included and cannot be read.
    missing: Arc<Mutex<BTreeSet<PathBuf>>>,
    /// Whether some text comes from a patch: then the files know from where.
    has_pieces: Arc<AtomicBool>,
    /// Whether there are several files, or such a patch.
    has_several: Arc<AtomicBool>,
}

impl Places {
    /// The number of the file that a start lies in; 0 is the main file.
    pub fn file_of(start: u64) -> u16 {
        (start >> OFFSET_BITS) as u16
    }

    /// The offset in the decoded text of its file.
    pub fn offset_of(start: u64) -> u64 {
        start & OFFSET_MASK
    }

    /// A start from a file's number and an offset in its decoded text.
    pub fn start(file: u16, offset: u64) -> u64 {
        u64::from(file) << OFFSET_BITS | offset & OFFSET_MASK
    }

    /// File, line and column of a start. Of an unknown file: no name.
    pub fn place(&self, start: u64) -> SourceLocation {
        let files = self.lock();
        let Some(file) = files.get(usize::from(Self::file_of(start))) else {
            return SourceLocation { file: "".into(), position: Position::default() };
        };
        if let Some((number, position)) = file.written(Self::offset_of(start)) {
            let name = files.get(usize::from(number)).map_or_else(|| "".into(), |f| f.name.clone());
            return SourceLocation { file: name, position };
        }
        SourceLocation {
            file: file.name.clone(),
            position: file.lines.position(Self::offset_of(start)),
        }
    }

    /// The same for a stretch of one file's text, which one thread asks for places again and again.
    pub fn near(&self, start: u64, length: usize) -> NearPlaces {
        let files = self.lock();
        // Of a text that comes from several files, each place is looked up.
        let file =
            files.get(usize::from(Self::file_of(start))).filter(|file| file.pieces.is_empty());
        let from = Self::offset_of(start);
        let lines = file.map(|file| file.lines.part(from..from.saturating_add(length as u64)));
        let starts = start..start.saturating_add(lines.as_ref().map_or(0, |_| length as u64));
        NearPlaces { all: self.clone(), starts, lines: lines.unwrap_or_default() }
    }

    /// The same for the main file as far as it was read, for many threads that ask for places at once.
    pub fn main_file(&self) -> NearPlaces {
        let length = self.lock().first().map_or(0, |file| file.lines.bytes());
        self.near(0, usize::try_from(length).unwrap_or(usize::MAX))
    }

    /// The number of the file in which what is at a start is written: that of its text, or of a patch in it.
    pub fn file_at(&self, start: u64) -> u16 {
        let number = Self::file_of(start);
        // Asked for each element, by all threads: nothing is locked unless there is a patch, whose pieces are known before the
        // text that they are about is handed out.
        if !self.has_pieces.load(Ordering::Acquire) {
            return number;
        }
        let files = self.lock();
        let file = files.get(usize::from(number));
        file.and_then(|file| file.piece(Self::offset_of(start))).map_or(number, |own| own.file)
    }

    /// Line and column of a start in its file.
    pub fn position(&self, start: u64) -> Position {
        let files = self.lock();
        let file = files.get(usize::from(Self::file_of(start)));
        file.map_or_else(Position::default, |file| match file.written(Self::offset_of(start)) {
            Some((_, position)) => position,
            None => file.lines.position(Self::offset_of(start)),
        })
    }

    /// Where the file of a start was included; none for the main file.
    pub fn included_at(&self, start: u64) -> Option<u64> {
        self.lock().get(usize::from(Self::file_of(start)))?.included_at
    }

    /// Number of files opened so far.
    pub fn files(&self) -> usize {
        self.lock().len()
    }

    /// Whether all text so far stands in one file.
    pub fn is_one_file(&self) -> bool {
        !self.has_several.load(Ordering::Acquire)
    }

    /// Files that were to be included and cannot be read, by name.
    pub fn missing(&self) -> Vec<PathBuf> {
        self.missing.lock().unwrap_or_else(PoisonError::into_inner).iter().cloned().collect()
    }

    /// Notes that a file cannot be read. No more are noted than there can be files.
    pub(super) fn add_missing(&self, path: PathBuf) {
        let mut missing = self.missing.lock().unwrap_or_else(PoisonError::into_inner);
        if missing.len() < usize::from(u16::MAX) {
            missing.insert(path);
        }
    }

    /// Adds a file. Those beyond the numbers that there are share the last one.
    pub(super) fn add(&self, name: &str, included_at: Option<u64>) -> u16 {
        let mut files = self.lock();
        if files.len() <= usize::from(u16::MAX) {
            let (name, lines) = (name.into(), LineIndex::default());
            files.push(File { name, included_at, lines, pieces: Vec::new() });
            self.has_several.fetch_or(files.len() > 1, Ordering::AcqRel);
        }
        (files.len() - 1) as u16
    }

    /// From an offset of the main file's text on, up to the next such offset, it comes from this place of a file.
    pub(crate) fn piece(&self, start: u64, file: u16, at: Position) {
        if let Some(main) = self.lock().first_mut() {
            main.pieces.push(SourcePiece { start, file, at });
            self.has_pieces.store(true, Ordering::Release);
            self.has_several.store(true, Ordering::Release);
        }
    }

    /// Takes in the next bytes of a file's decoded text. Yields whether they may have a character that XML does not allow.
    pub(super) fn feed(&self, file: u16, bytes: &[u8]) -> bool {
        let mut files = self.lock();
        files.get_mut(usize::from(file)).is_some_and(|file| file.lines.feed(bytes))
    }

    /// Nothing here can be left half done, so a panic elsewhere while it was held is no reason to stop.
    fn lock(&self) -> MutexGuard<'_, Vec<File>> {
        self.files.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Places in a document, and the lines of a stretch of it: these are told without a look at what all threads share.
#[derive(Debug)]
pub struct NearPlaces {
    /// Places in the document.
    pub all: Places,
    /// The starts that are in the stretch.
    starts: Range<u64>,
    lines: LineIndex,
}

impl NearPlaces {
    /// Line and column of a start in its file.
    pub fn position(&self, start: u64) -> Position {
        if self.starts.contains(&start) {
            self.lines.position(Places::offset_of(start))
        } else {
            self.all.position(start)
        }
    }
}
