//! SOURCE: an OpenDRIVE file, an archive, or a live map.

use crate::exit::UsageError;
use anyhow::{Context, Result};
use mapd_archive::{MAGIC, encode};
use mapd_client::{Attach, Client, Domain, Snapshot};
use mapd_compiler::{Compilation, CompileOptions, Progress, ReadOptions, compile_from};
use mapd_xodr::PatchError;
use std::ffi::OsString;
use std::fmt;
use std::fs::File;
use std::io::{self, Read, Seek};
use std::os::unix::fs::FileTypeExt;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Prefix of a live map's name.
const SHARED: &str = "shm:";
/// How long to wait for a live map by default.
pub const WAIT: Duration = Duration::from_secs(2);

/// A source that answers queries, or the report of why it does not.
pub enum Opened {
    /// A map; of an OpenDRIVE file also what was found, without the rows.
    Map(Snapshot, Option<Box<Compilation>>),
    /// An OpenDRIVE file that was rejected.
    Rejected(Box<Compilation>),
}

/// Whether a file is an archive by its name.
pub fn is_archive(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "mapd")
}

/// A SOURCE as it is named: a live map, or a file, whose name need not be UTF-8.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Source {
    /// A live map, by its name.
    Live(String),
    /// An OpenDRIVE file or an archive.
    File(PathBuf),
}

impl From<OsString> for Source {
    fn from(text: OsString) -> Self {
        match text.to_str().and_then(|text| text.strip_prefix(SHARED)) {
            Some(name) => Self::Live(name.to_owned()),
            None => Self::File(text.into()),
        }
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Live(name) => write!(f, "{SHARED}{name}"),
            Self::File(path) => path.display().fmt(f),
        }
    }
}

impl Source {
    /// Whether it is a map that is compiled already: live, or an archive.
    pub(crate) fn is_compiled(&self) -> bool {
        match self {
            Self::Live(_) => true,
            Self::File(path) => is_archive(path),
        }
    }

    /// The file; none of a live map.
    pub(crate) fn file(&self) -> Option<&Path> {
        match self {
            Self::Live(_) => None,
            Self::File(path) => Some(path),
        }
    }

    /// What a page calls it: a file without its folder and kind, a live map by its name.
    pub(crate) fn title(&self) -> String {
        let name = match self {
            Self::Live(name) => Path::new(name),
            Self::File(path) => path,
        };
        name.file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }
}

/// Compiles an OpenDRIVE file, compressed with gzip or not. Files are included from its folder.
///
/// Errors: the file cannot be read. A rejected map is no error.
pub fn compile_file(
    path: &Path,
    options: &CompileOptions,
    progress: &mut dyn FnMut(Progress),
) -> Result<Compilation> {
    let reading = ReadOptions::default();
    compile_file_with(path, Compiling { reading: &reading, options }, progress)
}

/// As [`compile_file`], with rules and a policy. Files are included from the file's folder unless another is given.
///
/// Errors: the file cannot be read. A rejected map is no error.
pub fn compile_file_with(
    path: &Path,
    compiling: Compiling<'_>,
    progress: &mut dyn FnMut(Progress),
) -> Result<Compilation> {
    let Compiling { reading, options } = compiling;
    let reading = ReadOptions {
        include_folder: reading.include_folder.clone().or_else(|| folder(path)),
        ..reading.clone()
    };
    let mut input = Input::open(path)?;
    let compiled = compile_from(|| input.reopen(), &reading, options, progress);
    compiled.map_err(|error| {
        let is_unfit = error.get_ref().is_some_and(|inner| inner.is::<PatchError>());
        let said = format!("reading {}", path.display());
        match is_unfit {
            true => UsageError(format!("{said}: {error}")).into(),
            false => anyhow::Error::from(error).context(said),
        }
    })
}

/// The folder of a file, from which it may include others.
pub(crate) fn folder(path: &Path) -> Option<PathBuf> {
    let parent = path.parent()?;
    Some(if parent.as_os_str().is_empty() { PathBuf::from(".") } else { parent.to_owned() })
}

/// An OpenDRIVE file that is opened. What was opened first is read first: the writer of a pipe may be done with its first reader.
pub(crate) struct Input<'a> {
    path: &'a Path,
    first: Option<File>,
    is_pipe: bool,
}

impl<'a> Input<'a> {
    /// Opens a file.
    ///
    /// Errors: it cannot be opened, is a folder, or an archive by its first bytes.
    pub(crate) fn open(path: &'a Path) -> Result<Self> {
        let file = open_input(path)?;
        let is_pipe = file.metadata()?.file_type().is_fifo();
        Ok(Self { path, first: Some(file), is_pipe })
    }

    /// The file from its start.
    ///
    /// Errors: it cannot be opened again, as a pipe.
    pub(crate) fn reopen(&mut self) -> io::Result<File> {
        match self.first.take() {
            Some(first) => Ok(first),
            None if self.is_pipe => Err(io::Error::other(
                "a pipe cannot be read again, which leaving out what has errors needs; write it to a file first",
            )),
            None => File::open(self.path),
        }
    }
}

fn open_input(path: &Path) -> Result<File> {
    let mut file = File::open(path).with_context(|| format!("opening {}", path.display()))?;
    let kind = file.metadata()?.file_type();
    anyhow::ensure!(!kind.is_dir(), "{} is a folder, expected an OpenDRIVE file", path.display());
    // What is read from a pipe is gone.
    if kind.is_file() {
        let mut first = Vec::with_capacity(MAGIC.len());
        file.by_ref().take(MAGIC.len() as u64).read_to_end(&mut first)?;
        anyhow::ensure!(
            first != MAGIC,
            "{} is an archive, compiled already, expected an OpenDRIVE file; `mapd inspect` shows what it holds",
            path.display()
        );
        file.rewind()?;
    }
    Ok(file)
}

/// How an OpenDRIVE file is read and compiled.
#[derive(Clone, Copy)]
pub struct Compiling<'a> {
    /// How it is read and judged.
    pub reading: &'a ReadOptions,
    /// What is made of it.
    pub options: &'a CompileOptions,
}

/// How live maps are attached to.
#[derive(Clone, Copy)]
pub struct Attaching<'a> {
    /// Where they are.
    pub domain: &'a Domain,
    /// As what.
    pub attach: Attach,
    /// Longest wait for daemon and map.
    pub wait: Duration,
}

/// Opens a SOURCE: `shm:NAME`, a `.mapd` file in place, or an OpenDRIVE file compiled in memory.
///
/// Errors: files that cannot be read, archives that this release cannot read, no such live map.
pub fn open(
    source: &Source,
    compiling: Compiling<'_>,
    live: Attaching<'_>,
    progress: &mut dyn FnMut(Progress),
) -> Result<Opened> {
    let path = match source {
        Source::File(path) => path,
        Source::Live(name) => {
            let client = Client::connect_as(live.attach, live.domain, name, live.wait)?;
            return Ok(Opened::Map(client.snapshot(), None));
        }
    };
    if is_archive(path) {
        return Ok(Opened::Map(Snapshot::open(path)?, None));
    }
    let mut compiled = compile_file_with(path, compiling, progress)?;
    match compiled.rows.take() {
        Some(rows) => {
            let snapshot = Snapshot::from_bytes(encode(&rows, &compiled.provenance)?)?;
            Ok(Opened::Map(snapshot, Some(Box::new(compiled))))
        }
        None => Ok(Opened::Rejected(Box::new(compiled))),
    }
}

/// Says on stderr that a file without an overlay is written, if one lies over the map.
pub fn say_without_overlay(snapshot: &Snapshot, program: &str) {
    use std::io::Write as _;
    let entries = snapshot.view(SystemTime::UNIX_EPOCH).entries().count();
    if entries > 0 {
        // A closed stderr is nobody's loss.
        let _ = writeln!(
            io::stderr(),
            "{program}: {entries} entries of the overlay are left out: this format has no place for them"
        );
    }
}
