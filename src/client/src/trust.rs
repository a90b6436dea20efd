//! Signed archives: Ed25519 over the Blake2b hash of the bytes, in minisign's format.
//!
//! ```text
//! minisign -G -p map.pub -s map.key        a pair of keys, once
//! mapd sign town.mapd --key map.key        writes town.mapd.minisig; `minisign -Sm town.mapd -s map.key` does the same
//! mapd --load town.mapd --trust map.pub    refuses archives that this key has not signed
//! ```
//!
//! ```no_run
//! use mapd_client::{Snapshot, TrustedKey};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let key = TrustedKey::open("map.pub")?;
//! let snapshot = Snapshot::open_trusted("town.mapd", &key)?;
//! # Ok(())
//! # }
//! ```

use crate::error::ClientError;
use crate::snapshot::Snapshot;
use minisign_verify::{Error as MinisignError, PublicKey, Signature};
use std::ffi::OsString;
use std::fmt;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Suffix of a signature's file name, after the archive's name.
pub const SIGNATURE_SUFFIX: &str = ".minisig";

/// Largest size of a key or signature file \[bytes\]; real ones have a few hundred.
const LARGEST: u64 = 64 << 10;

/// Why an archive is not trusted.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TrustError {
    /// The public key is invalid.
    #[error(
        "{name}: expected a minisign public key, {reason}; name the file that `minisign -G` wrote with -p"
    )]
    Key {
        /// The key's file.
        name: String,
        /// What is wrong.
        reason: String,
    },
    /// There is no signature.
    #[error("{archive} is not signed: {}: {source}; sign it with `mapd sign {archive} --key SECRET`", signature.display())]
    Unsigned {
        /// The archive.
        archive: String,
        /// Where its signature should be.
        signature: PathBuf,
        /// The system's error.
        source: std::io::Error,
    },
    /// The signature cannot be read.
    #[error(
        "{archive}: expected a minisign signature, found another text ({reason}); sign it again with `mapd sign`"
    )]
    Malformed {
        /// The archive.
        archive: String,
        /// What is wrong.
        reason: String,
    },
    /// The signature was made with another key.
    #[error(
        "{archive} is signed with another key than the trusted one; get the signer's public key, or sign it again"
    )]
    OtherKey {
        /// The archive.
        archive: String,
    },
    /// A signed document is no document of entries.
    #[error("{document}: {reason}; it is signed, but no document of entries")]
    Document {
        /// The document.
        document: String,
        /// What is wrong.
        reason: String,
    },
    /// An entry of an overlay is in no signed document.
    #[error(
        "map {map:?}: entry {id:?} of its overlay is in none of the signed documents; get all that were applied, or remove the entry"
    )]
    UnsignedEntry {
        /// The map.
        map: String,
        /// The entry.
        id: String,
    },
    /// An overlay is not what its signed entries make of the map.
    #[error(
        "map {map:?}: its overlay is not what the signed documents say, or was made by another release of mapd"
    )]
    OtherOverlay {
        /// The map.
        map: String,
    },
    /// The archive was changed after it was signed.
    #[error(
        "{archive} is not what was signed: the file or its signature has been altered; get both again from their source"
    )]
    Altered {
        /// The archive.
        archive: String,
    },
}

/// A public key: archives that were signed with its secret key are trusted.
#[derive(Clone)]
pub struct TrustedKey {
    key: PublicKey,
    name: Box<str>,
}

impl TrustedKey {
    /// Reads a public key from a file in the format of `minisign -G`.
    ///
    /// Errors: [`TrustError::Key`].
    pub fn open(path: impl AsRef<Path>) -> Result<Self, TrustError> {
        let path = path.as_ref();
        let name = path.display().to_string();
        match read(path) {
            Ok(text) => Self::parse(&text, &name),
            Err(error) => Err(TrustError::Key { name, reason: error.to_string() }),
        }
    }

    /// A public key from text: the content of its file, or only the line in Base64. `name` is for messages.
    ///
    /// Errors: [`TrustError::Key`].
    pub fn parse(text: &str, name: &str) -> Result<Self, TrustError> {
        let text = text.trim();
        let key = match text.lines().count() {
            1 => PublicKey::from_base64(text),
            _ => PublicKey::decode(text),
        };
        let reason = |error: MinisignError| format!("found another text ({error})");
        let key = key.map_err(|e| TrustError::Key { name: name.to_owned(), reason: reason(e) })?;
        Ok(Self { key, name: name.into() })
    }

    /// Verifies bytes with a signature in minisign's format. Linear in their number.
    /// `archive` is for messages.
    ///
    /// Errors: [`TrustError::Malformed`], [`TrustError::OtherKey`], [`TrustError::Altered`].
    pub fn verify(&self, archive: &str, bytes: &[u8], signature: &str) -> Result<(), TrustError> {
        let archive = archive.to_owned();
        let signature = match Signature::decode(signature) {
            Ok(signature) => signature,
            Err(error) => {
                return Err(TrustError::Malformed { archive, reason: error.to_string() });
            }
        };
        // Signatures over the bytes themselves, as minisign made them before 0.6, are refused: `false`.
        self.key.verify(bytes, &signature, false).map_err(|error| match error {
            MinisignError::UnexpectedKeyId => TrustError::OtherKey { archive },
            MinisignError::InvalidSignature => TrustError::Altered { archive },
            other => TrustError::Malformed { archive, reason: other.to_string() },
        })
    }

    /// As [`TrustedKey::verify`], with the signature in the file next to the archive; see [`signature_path`].
    ///
    /// Errors: [`TrustError::Unsigned`]; those of [`TrustedKey::verify`].
    pub fn verify_beside(&self, archive: &Path, bytes: &[u8]) -> Result<(), TrustError> {
        self.verify(&archive.display().to_string(), bytes, &read_signature(archive)?)
    }
}

impl fmt::Debug for TrustedKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TrustedKey").field("name", &self.name).finish_non_exhaustive()
    }
}

/// Path of an archive's signature: `town.mapd.minisig` next to `town.mapd`.
pub fn signature_path(archive: &Path) -> PathBuf {
    let mut path = OsString::from(archive.as_os_str());
    path.push(SIGNATURE_SUFFIX);
    path.into()
}

/// Reads the signature next to an archive.
///
/// Errors: [`TrustError::Unsigned`].
pub fn read_signature(archive: &Path) -> Result<String, TrustError> {
    let signature = signature_path(archive);
    read(&signature).map_err(|source| TrustError::Unsigned {
        archive: archive.display().to_string(),
        signature,
        source,
    })
}

/// Reads a small text.
fn read(path: &Path) -> std::io::Result<String> {
    mapd_transport::read_regular(path, LARGEST)
}

impl Snapshot {
    /// Opens a signed `.mapd` file in place; the signature is next to it, see [`signature_path`]. Reads the whole
    /// file. A user with write permission can still change the file afterwards: if that is not only the map's owner, let the
    /// daemon serve the map, which verifies the bytes in shared memory.
    ///
    /// Errors: those of [`Snapshot::open`]; [`ClientError::Trust`].
    pub fn open_trusted(path: impl AsRef<Path>, key: &TrustedKey) -> Result<Self, ClientError> {
        let snapshot = Self::open(path.as_ref())?;
        key.verify_beside(path.as_ref(), snapshot.bytes())?;
        Ok(snapshot)
    }

    /// Verifies the bytes with a signature, also of a generation in shared memory: for clients
    /// that trust a key and not the daemon. Reads all bytes.
    ///
    /// Errors: [`ClientError::Trust`].
    pub fn verify_signature(&self, key: &TrustedKey, signature: &str) -> Result<(), ClientError> {
        Ok(key.verify(self.source_name(), self.bytes(), signature)?)
    }
}
