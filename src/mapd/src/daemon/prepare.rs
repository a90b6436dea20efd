//! From a map's source to an archive in a file: as it is, from the cache, or compiled.

use super::child::{self, Means, Refusal};
use super::log::say;
use super::settings::MapSettings;
use crate::cache::{Cache, HashedInput, InputHash, Key, OpenArchive};
use crate::source;
use crate::trust::signable;
use mapd_archive::{HEADER_LENGTH, Header};
use mapd_client::{Domain, TrustError, TrustedKey, read_signature, signature_path};
use mapd_compiler::Policy;
use mapd_transport::open_regular;
use std::fs::File;
use std::io;
use std::os::unix::fs::FileExt;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// An archive in a file; not proved yet.
#[derive(Clone, Debug)]
pub(crate) struct Prepared {
    pub(crate) file: Arc<File>,
    pub(crate) length: u64,
    pub(crate) header: Header,
    /// Its name in the cache.
    pub(crate) key: Option<Key>,
    pub(crate) from_cache: bool,
    /// Whether the file may be kept for going back to: it takes no memory.
    pub(crate) is_on_disk: bool,
    /// All files that it comes from.
    pub(crate) files: Vec<PathBuf>,
    /// Its signature, read when the archive was opened; only where a key is trusted.
    pub(crate) signature: Option<String>,
    /// What may be in quarantine; none where the compiler has judged by the map's own options.
    pub(crate) policy: Option<Policy>,
}

impl Prepared {
    /// Proves that these bytes, copied from the archive, are what was signed.
    ///
    /// Errors: they are not, or nothing is; only where a key is trusted.
    pub(crate) fn prove_signature(
        &self,
        trust: Option<&TrustedKey>,
        bytes: &[u8],
    ) -> Result<(), TrustError> {
        let Some(key) = trust else { return Ok(()) };
        let name = self.files.first().map(|file| file.display().to_string()).unwrap_or_default();
        // Without a signature an archive is not prepared where a key is trusted; no text is none that proves.
        key.verify(&name, bytes, self.signature.as_deref().unwrap_or_default())
    }
}

/// What preparing needs besides a map.
#[derive(Clone, Debug)]
pub(crate) struct Preparer {
    pub(crate) cache: Option<Cache>,
    pub(crate) means: Means,
    /// Whose archives alone are served.
    pub(crate) trust: Option<TrustedKey>,
    /// Set when the daemon ends.
    pub(crate) cancelled: Arc<AtomicBool>,
}

impl Preparer {
    /// Prepares a map. `anew`: not from the cache, whose archive did not prove.
    ///
    /// Errors: why there is no archive.
    pub(crate) fn prepare(&self, map: &MapSettings, anew: bool) -> Result<Prepared, Refusal> {
        if self.trust.is_some() {
            signable(&map.source).map_err(|error| Refusal::Rejected(error.to_string()))?;
        }
        let prepared = if source::is_archive(&map.source) {
            self.open_archive(map)
        } else {
            // The compiler would wait for who writes into a pipe, and with it all other maps.
            if let Err(error) = open_regular(&map.source) {
                let why = format!("opening {}: {error}", map.source.display());
                return Err(Refusal::Failed(why));
            }
            match self.look_up(map, anew)? {
                Some(found) => Ok(found),
                None => self.compile(map),
            }
        }?;
        match map.max_bytes {
            Some(most) if prepared.length > most => Err(Refusal::Failed(format!(
                "the archive has {} bytes, the map may have {most} (max_bytes)",
                prepared.length
            ))),
            _ => Ok(prepared),
        }
    }

    fn open_archive(&self, map: &MapSettings) -> Result<Prepared, Refusal> {
        let failed = |error| Refusal::Failed(format!("{}: {error}", map.source.display()));
        let (reading, _) = map.options.parse().map_err(|error| failed(format!("{error:#}")))?;
        let file = open_regular(&map.source).map_err(|error| failed(error.to_string()))?;
        let metadata = file.metadata().map_err(|error| failed(error.to_string()))?;
        let header = read_header(&file).map_err(|error| match error.kind() {
            io::ErrorKind::UnexpectedEof => Refusal::Rejected(format!(
                "{}: no archive, or one that was cut off: {} bytes, a header alone has {HEADER_LENGTH}",
                map.source.display(),
                metadata.len()
            )),
            io::ErrorKind::Other => {
                Refusal::Rejected(format!("{}: {error}", map.source.display()))
            }
            _ => failed(error.to_string()),
        })?;
        let mut files = vec![absolute(&map.source)];
        let signature = match self.trust {
            None => None,
            Some(_) => {
                // A signature that comes after its archive is a change as well.
                files.push(signature_path(&absolute(&map.source)));
                let read = read_signature(&map.source);
                Some(read.map_err(|error| Refusal::Rejected(error.to_string()))?)
            }
        };
        Ok(Prepared {
            file: Arc::new(file),
            length: metadata.len(),
            header,
            key: None,
            from_cache: false,
            is_on_disk: true,
            files,
            signature,
            policy: Some(reading.policy),
        })
    }

    /// Looks for the archive of what the files hold now. Whatever goes wrong here goes wrong again, with better words, when
    /// the map is compiled.
    fn look_up(&self, map: &MapSettings, anew: bool) -> Result<Option<Prepared>, Refusal> {
        let Some(cache) = self.cache.as_ref().filter(|_| !anew) else { return Ok(None) };
        let (reading, options) =
            map.options.parse().map_err(|error| Refusal::Failed(format!("{error:#}")))?;
        let folder = source::folder(&map.source).unwrap_or_default();
        let Ok(HashedInput { hash, files }) = cache.input_hash(&map.source, &folder) else {
            return Ok(None);
        };
        let key = Key::of_archive(&hash.input, &reading.hash(&options));
        let Some(OpenArchive { file, length }) = cache.get(&key) else { return Ok(None) };
        let Some(header) = header_of(&file, &key) else {
            say(&format!(
                "map {}: an archive in the cache is not what its name says; it is removed",
                map.name
            ));
            cache.remove(&key);
            return Ok(None);
        };
        Ok(Some(Prepared {
            file: Arc::new(file),
            length,
            header,
            key: Some(key),
            from_cache: true,
            is_on_disk: true,
            files,
            signature: None,
            policy: None,
        }))
    }

    /// The archive that was served last under this name, where the map's settings allow it.
    pub(crate) fn last_served(&self, domain: &Domain, map: &MapSettings) -> Option<Prepared> {
        // What was served is not signed: only archives are, and of those none is kept.
        let cache = self.cache.as_ref().filter(|_| map.last_good && self.trust.is_none())?;
        let key = cache.last_served(&name_in_cache(domain, &map.name))?;
        let OpenArchive { file, length } = cache.get(&key)?;
        Some(Prepared {
            header: header_of(&file, &key)?,
            file: Arc::new(file),
            length,
            key: Some(key),
            from_cache: true,
            is_on_disk: true,
            files: vec![absolute(&map.source)],
            signature: None,
            policy: None,
        })
    }

    /// Notes that an archive is served. Without the note a later start can fall back on nothing, which it then says.
    pub(crate) fn note_served(&self, domain: &Domain, map: &str, archive: &Prepared) {
        if let (Some(cache), Some(key)) = (&self.cache, &archive.key) {
            let _ = cache.remember_served(&name_in_cache(domain, map), key);
        }
    }

    fn compile(&self, map: &MapSettings) -> Result<Prepared, Refusal> {
        let failed = |error: io::Error| Refusal::Failed(format!("the compiled archive: {error}"));
        let run =
            |output: &Path| child::compile(map, output.as_os_str(), self.means, &self.cancelled);
        // A cache that cannot be written any more is done without.
        let without = |why: &dyn std::fmt::Display| {
            say(&format!("map {}: continuing without the cache: {why}", map.name));
        };
        let begun = self.cache.as_ref().and_then(|cache| {
            let begun = cache.begin().inspect_err(|error| without(error));
            Some((cache, begun.ok()?))
        });
        let in_cache = match begun {
            Some((cache, unfinished)) => match run(unfinished.path()) {
                Ok(told) => Some((cache, unfinished, told)),
                Err(Refusal::Unwritten(reason)) => {
                    without(&reason);
                    None
                }
                Err(refusal) => return Err(refusal),
            },
            None => None,
        };
        let (file, length, header, key, told, is_on_disk) = match in_cache {
            Some((cache, unfinished, told)) => {
                let file = open_regular(unfinished.path()).map_err(failed)?;
                let header = read_header(&file).map_err(failed)?;
                let length = file.metadata().map_err(failed)?.len();
                // Of what has been read, whatever the files hold meanwhile.
                let key = Key::of_header(&header);
                // The file is open: it is served also where it cannot have its name.
                let kept = cache.keep(unfinished, &key).inspect_err(|error| without(error));
                self.remember_includes(cache, map, &told.included);
                (file, length, header, kept.is_ok().then_some(key), told, true)
            }
            None => {
                let (file, path) = child::nameless().map_err(failed)?;
                let told = run(&path)?;
                let header = read_header(&file).map_err(failed)?;
                let length = file.metadata().map_err(failed)?.len();
                (file, length, header, None, told, false)
            }
        };
        let mut files = vec![absolute(&map.source)];
        files.extend(told.included);
        Ok(Prepared {
            file: Arc::new(file),
            length,
            header,
            key,
            from_cache: false,
            is_on_disk,
            files,
            signature: None,
            policy: None,
        })
    }

    fn remember_includes(&self, cache: &Cache, map: &MapSettings, included: &[PathBuf]) {
        if included.is_empty() {
            return;
        }
        let folder = source::folder(&map.source).unwrap_or_default();
        // If they are forgotten, or the document has changed meanwhile, the map is compiled again.
        let _ = InputHash::of(&map.source, |_| Vec::new()).and_then(|hash| {
            cache.remember_includes(&Key::of_document(&hash.document, &folder), included)
        });
    }
}

/// A map's name among those of all domains that share a cache.
fn name_in_cache(domain: &Domain, map: &str) -> String {
    format!("{}{map}", domain.prefix())
}

fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// The header of an archive in the cache, if it is the one that its name says: files can be copied, and renamed.
fn header_of(file: &File, key: &Key) -> Option<Header> {
    read_header(file).ok().filter(|header| Key::of_header(header) == *key)
}

fn read_header(file: &File) -> io::Result<Header> {
    let mut bytes = [0; HEADER_LENGTH];
    file.read_exact_at(&mut bytes, 0)?;
    Header::decode(&bytes).map_err(io::Error::other)
}
