//! What an archive is compiled from, as a name.

use mapd_archive::{Header, LAYOUT_ID};
use mapd_transport::open_regular;
use std::fmt;
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// Names an archive by everything that shapes it: its input, the options, the compiler, the layout.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Key([u8; 32]);

impl Key {
    /// Of an archive. `input` is the hash of all files read and `options` that of all options, as the archive's header has
    /// them (see [`InputHash`] and [`mapd_compiler::ReadOptions::hash`]).
    pub fn of_archive(input: &[u8; 32], options: &[u8; 8]) -> Self {
        Self::of(b"archive", &[input, options, program(), &LAYOUT_ID])
    }

    /// Of the archive that has this header.
    pub fn of_header(header: &Header) -> Self {
        Self::of_archive(&header.provenance.input_hash, &header.provenance.options_hash)
    }

    /// Of a document without what it includes, and of the folder that it includes from.
    pub fn of_document(document: &[u8; 32], folder: &Path) -> Self {
        let folder = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
        Self::of(b"document", &[document, folder.as_os_str().as_encoded_bytes()])
    }

    /// Of a document's place, whatever it holds.
    pub fn of_place(document: &Path) -> Self {
        Self::of(b"place", &[document.as_os_str().as_encoded_bytes()])
    }

    /// All of it, as text.
    pub(super) fn to_text(self) -> String {
        crate::report::hex(&self.0)
    }

    /// From its text.
    pub(super) fn from_text(text: &str) -> Option<Self> {
        let mut bytes = [0; 32];
        if text.len() != 2 * bytes.len() || !text.is_ascii() {
            return None;
        }
        for (i, byte) in bytes.iter_mut().enumerate() {
            *byte = u8::from_str_radix(text.get(2 * i..2 * i + 2)?, 16).ok()?;
        }
        Some(Self(bytes))
    }

    fn of(kind: &[u8], parts: &[&[u8]]) -> Self {
        let mut hasher = blake3::Hasher::new();
        for part in std::iter::once(&kind).chain(parts) {
            hasher.update(&(part.len() as u64).to_le_bytes()).update(part);
        }
        Self(*hasher.finalize().as_bytes())
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Half of it is more than enough for a name.
        self.0[..16].iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

impl fmt::Debug for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Key({self})")
    }
}

/// Which compiler this is: its version, and the program's size and time, for programs of one version may differ.
fn program() -> &'static [u8] {
    static PROGRAM: OnceLock<Vec<u8>> = OnceLock::new();
    PROGRAM.get_or_init(|| {
        // The program that runs, also after another one has taken its name.
        let file = std::fs::metadata("/proc/self/exe");
        let file = file.map(|m| (m.size(), m.mtime(), m.mtime_nsec())).unwrap_or_default();
        format!("{} {file:?}", env!("CARGO_PKG_VERSION")).into_bytes()
    })
}

/// Hashes of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InputHash {
    /// Of the document alone.
    pub document: [u8; 32],
    /// Of the document and what it includes: the input hash in an archive's header.
    pub input: [u8; 32],
}

impl InputHash {
    /// Of a document, and of the files that `includes` names for the document's own hash.
    ///
    /// Errors: a file cannot be read.
    pub fn of(
        document: &Path,
        includes: impl FnOnce(&[u8; 32]) -> Vec<PathBuf>,
    ) -> io::Result<Self> {
        let mut hasher = blake3::Hasher::new();
        hasher.update_reader(open_regular(document)?)?;
        let alone = *hasher.finalize().as_bytes();
        for file in includes(&alone) {
            hasher.update_reader(open_regular(&file)?)?;
        }
        Ok(Self { document: alone, input: *hasher.finalize().as_bytes() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whatever_shapes_an_archive_changes_its_name() {
        let names = [
            Key::of_archive(&[0; 32], &[0; 8]),
            Key::of_archive(&[1; 32], &[0; 8]),
            Key::of_archive(&[0; 32], &[1; 8]),
            Key::of_document(&[0; 32], Path::new("/a")),
            Key::of_document(&[0; 32], Path::new("/b")),
        ];
        let different: std::collections::BTreeSet<_> = names.iter().map(Key::to_string).collect();
        assert_eq!(different.len(), names.len());
        for name in names {
            assert_eq!(Key::from_text(&name.to_text()), Some(name));
        }
        assert_eq!(Key::from_text("12"), None);
    }

    #[test]
    fn the_hash_is_that_in_the_archive() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("map.xodr");
        let text = r#"<OpenDRIVE><header revMajor="1" revMinor="7"/></OpenDRIVE>"#;
        std::fs::write(&path, text).expect("written");
        let compiled = crate::source::compile_file(&path, &Default::default(), &mut |_| {});
        let compiled = compiled.expect("compiles");
        let hash = InputHash::of(&path, |_| compiled.included.clone()).expect("hashed");
        assert_eq!(hash.input, compiled.provenance.input_hash);
        assert_eq!(hash.input, hash.document, "nothing is included");
    }
}
