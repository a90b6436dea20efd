//! Why a map cannot be opened.

use mapd_archive::{OpenError, VerifyError};
use mapd_transport::AttachError;
use std::path::PathBuf;
use thiserror::Error;

/// Why a map cannot be opened.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ClientError {
    /// The daemon, the map or the generation is missing or refused the client.
    #[error(transparent)]
    Attach(#[from] AttachError),
    /// The bytes are not an archive that this release can read.
    #[error("{source_name}: {source}")]
    Open {
        /// File or map name.
        source_name: String,
        /// What is wrong.
        source: OpenError,
    },
    /// The archive failed verification.
    #[error("{source_name}: {source}")]
    Verify {
        /// File or map name.
        source_name: String,
        /// What is wrong.
        source: VerifyError,
    },
    /// The archive is not signed by the trusted key, or was changed after signing.
    #[cfg(feature = "trust")]
    #[error(transparent)]
    Trust(#[from] crate::trust::TrustError),
    /// The file cannot be read.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The system's error.
        source: std::io::Error,
    },
}

#[cfg(test)]
mod tests {
    use std::error::Error as _;

    #[test]
    fn a_file_that_cannot_be_opened_has_the_system_s_error_as_its_source() {
        let error = crate::Snapshot::open("/no/such/folder/town.mapd").err().expect("no file");
        assert!(error.to_string().starts_with("/no/such/folder/town.mapd: "), "{error}");
        let cause = error.source().and_then(|cause| cause.downcast_ref::<std::io::Error>());
        assert_eq!(cause.map(std::io::Error::kind), Some(std::io::ErrorKind::NotFound));
    }
}
