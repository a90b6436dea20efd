//! `include`: which file it means, and whether it may be read.

use super::limits::SourceLimits;
use super::places::Places;
use super::text::{Shared, Source};
use crate::patch::{Patch, Splice};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicU64;

/// Why a file is not included.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum IncludeRefusal {
    /// The reference is empty.
    #[error("expected the name of a file to include, found none")]
    Empty,
    /// A URL, an absolute path or one with a drive. mapd never fetches.
    #[error("expected a path relative to the including file, found {0:?}")]
    NotRelative(String),
    /// The document was not read from a file and no folder was given.
    #[error("expected a folder to include files from, found a document without one")]
    NoFolder,
    /// Resolved, symbolic links followed, it lies outside the folder that files may be included from.
    #[error("expected a file within {0}, found {1} outside of it")]
    Outside(PathBuf, PathBuf),
    /// There is no such file, it is no regular file, or it cannot be read.
    #[error("expected a file that can be read, found {0}: {1}")]
    Unreadable(PathBuf, String),
    /// The file includes itself, directly or through others.
    #[error("expected no file to include itself, found that {0} does")]
    Cycle(PathBuf),
    /// Includes within includes beyond the limit.
    #[error("expected at most {0} includes within each other, found more")]
    Depth(usize),
    /// More files than the limit.
    #[error("expected at most {0} files in one document, found more")]
    Files(usize),
}

impl IncludeRefusal {
    /// Whether a limit was passed rather than something being wrong.
    pub fn is_limit(&self) -> bool {
        matches!(self, Self::Depth(_) | Self::Files(_))
    }
}

/// An open file.
#[derive(Debug)]
struct Open {
    number: u16,
    /// Where the file really lies; none for inputs that are no files.
    path: Option<PathBuf>,
}

/// Opens the files of one document: the main one and what it includes, one within the other.
///
/// ```
/// use mapd_xodr::source::{IncludeRefusal, Inputs, SourceLimits};
///
/// let mut inputs = Inputs::new(SourceLimits::default());
/// let main = inputs.open(Box::new(&b"<OpenDRIVE/>"[..]), "from memory");
/// assert_eq!(main.file(), 0);
/// assert_eq!(inputs.include("roads.xodr", 0).err(), Some(IncludeRefusal::NoFolder));
/// ```
#[derive(Debug)]
pub struct Inputs {
    shared: Shared,
    /// Where files may be included from, as given.
    base: Option<PathBuf>,
    anywhere: bool,
    /// The files that are open, the innermost last.
    open: Vec<Open>,
}

impl Inputs {
    /// Nothing opened yet. Files may be included from the main file's folder.
    pub fn new(limits: SourceLimits) -> Self {
        let shared =
            Shared { limits, places: Places::default(), decoded: Arc::new(AtomicU64::new(0)) };
        Self { shared, base: None, anywhere: false, open: Vec::new() }
    }

    /// Sets the folder that files may be included from, instead of the main file's.
    pub fn with_include_folder(mut self, folder: impl Into<PathBuf>) -> Self {
        self.base = Some(folder.into());
        self
    }

    /// Lets files be included from anywhere by a relative path. Only for documents that are trusted.
    pub fn with_includes_from_anywhere(mut self) -> Self {
        self.anywhere = true;
        self
    }

    /// The files' names and lines.
    pub fn places(&self) -> &Places {
        &self.shared.places
    }

    /// A source that has ended, of a file's number.
    pub(crate) fn nothing(&self, file: u16) -> Source<'static> {
        Source::nothing(self.shared.clone(), file)
    }

    /// Opens an input that is no file, such as bytes in memory.
    pub fn open<'a>(&mut self, input: Box<dyn Read + Send + 'a>, name: &str) -> Source<'a> {
        self.push(input, name, None, None)
    }

    /// Opens an input that is no file, with a patch in it. The patch is the file after the main one.
    pub fn open_patched<'a>(
        &mut self,
        input: Box<dyn Read + Send + 'a>,
        name: &str,
        patch: &'a Patch,
    ) -> Source<'a> {
        let (places, decoded) = (Places::default(), Arc::default());
        let limits = self.shared.limits;
        let shared = Shared { limits, places, decoded };
        // What is wrong with its bytes is noted on the text that is made of it.
        let written = Source::new(input, shared.clone(), shared.places.add(name, None));
        let written = written.with_all_text();
        let number = self.shared.places.add(name, None);
        let file = match patch.file() {
            Some(file) => self.shared.places.add(&file.display().to_string(), None),
            None => number,
        };
        self.open.push(Open { number, path: None });
        let places = self.shared.places.clone();
        let spliced = Splice::new(written, shared.places, patch, places, file);
        Source::new(Box::new(spliced), self.shared.clone(), number)
    }

    /// Opens the main file. Errors: it cannot be opened.
    pub fn open_file(&mut self, path: &Path) -> io::Result<Source<'static>> {
        let file = File::open(path)?;
        // A path that cannot be followed, such as a pipe's, leaves a document without a folder.
        let real = path.canonicalize().ok().filter(|real| real.is_file());
        Ok(self.push(Box::new(file), &path.display().to_string(), real, None))
    }

    /// Opens the file that the innermost open file includes. `at` is where the `include` stands. Every file opened so
    /// must be left by [`leave`](Self::leave).
    pub fn include(&mut self, reference: &str, at: u64) -> Result<Source<'static>, IncludeRefusal> {
        let limits = &self.shared.limits;
        // The main file is no include.
        if self.open.len() > limits.include_depth {
            return Err(IncludeRefusal::Depth(limits.include_depth));
        }
        let files = limits.files.min(usize::from(u16::MAX) + 1);
        if self.shared.places.files() >= files {
            return Err(IncludeRefusal::Files(files));
        }
        let (path, real) = self.resolve(reference).inspect_err(|refusal| self.note(refusal))?;
        if self.open.iter().any(|open| open.path.as_ref() == Some(&real)) {
            return Err(IncludeRefusal::Cycle(real));
        }
        let file = File::open(&real)
            .map_err(|error| unreadable(&path, &error))
            .inspect_err(|refusal| self.note(refusal))?;
        Ok(self.push(Box::new(file), &path.display().to_string(), Some(real), Some(at)))
    }

    /// A caller that waits for a file to appear needs its name.
    fn note(&self, refusal: &IncludeRefusal) {
        if let IncludeRefusal::Unreadable(path, _) = refusal {
            self.shared.places.add_missing(path.clone());
        }
    }

    /// The innermost included file has been read: back to the one that includes it.
    pub fn leave(&mut self) {
        if self.open.len() > 1 {
            self.open.pop();
        }
    }

    /// Files that are open within each other.
    pub fn depth(&self) -> usize {
        self.open.len()
    }

    /// The path that a reference means, as printed and as it really is.
    fn resolve(&self, reference: &str) -> Result<(PathBuf, PathBuf), IncludeRefusal> {
        let reference = reference.trim_ascii();
        if reference.is_empty() {
            return Err(IncludeRefusal::Empty);
        }
        // Files made on Windows have its separator, which no name in the wild has as a character.
        let relative = PathBuf::from(reference.replace('\\', "/"));
        let is_rooted = relative
            .components()
            .any(|part| matches!(part, Component::RootDir | Component::Prefix(_)));
        if is_rooted || has_scheme(reference) {
            return Err(IncludeRefusal::NotRelative(reference.to_owned()));
        }
        let including = self.open.last().and_then(|open| open.path.as_deref());
        let main = self.open.first().and_then(|open| open.path.as_deref());
        let folder = including.and_then(Path::parent).or(self.base.as_deref());
        let folder = folder.ok_or(IncludeRefusal::NoFolder)?;
        let path = folder.join(relative);
        let real = path.canonicalize().map_err(|error| unreadable(&path, &error))?;
        if !self.anywhere {
            let base = self.base.as_deref().or(main.and_then(Path::parent));
            let base = base.ok_or(IncludeRefusal::NoFolder)?;
            let base = base.canonicalize().map_err(|error| unreadable(base, &error))?;
            if !real.starts_with(&base) {
                return Err(IncludeRefusal::Outside(base, real));
            }
        }
        // A pipe would block, a device never end.
        if !real.is_file() {
            return Err(IncludeRefusal::Unreadable(path, "it is no regular file".to_owned()));
        }
        Ok((path, real))
    }

    fn push<'a>(
        &mut self,
        input: Box<dyn Read + Send + 'a>,
        name: &str,
        path: Option<PathBuf>,
        included_at: Option<u64>,
    ) -> Source<'a> {
        let number = self.shared.places.add(name, included_at);
        self.open.push(Open { number, path });
        Source::new(input, self.shared.clone(), number)
    }

    /// The number of the innermost open file.
    pub fn current(&self) -> u16 {
        self.open.last().map_or(0, |open| open.number)
    }
}

/// Whether a reference begins as a URL or with a drive: letters, digits, `+`, `-`, `.`, then a colon. (RFC 3986, 3.1)
fn has_scheme(reference: &str) -> bool {
    let Some((scheme, _)) = reference.split_once(':') else { return false };
    scheme.starts_with(|first: char| first.is_ascii_alphabetic())
        && scheme.bytes().all(|b| b.is_ascii_alphanumeric() || b"+-.".contains(&b))
}

fn unreadable(path: &Path, error: &io::Error) -> IncludeRefusal {
    IncludeRefusal::Unreadable(path.to_owned(), error.to_string())
}
