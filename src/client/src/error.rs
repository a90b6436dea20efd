//! Why a map cannot be had.

use mapd_archive::{OpenError, VerifyError};
use mapd_transport::AttachError;
use std::path::PathBuf;
use thiserror::Error;

/// Why a map cannot be had.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ClientError {
    /// The daemon, the map or a generation was not there, or refused us.
    #[error(transparent)]
    Attach(#[from] AttachError),
    /// The bytes are no archive that this program reads.
    #[error("{source_name}: {error}")]
    Open {
        /// File or map name.
        source_name: String,
        /// What is wrong.
        error: OpenError,
    },
    /// The archive does not prove.
    #[error("{source_name}: {error}")]
    Verify {
        /// File or map name.
        source_name: String,
        /// What is wrong.
        error: VerifyError,
    },
    /// The archive is not signed by a trusted key, or not what was signed.
    #[cfg(feature = "trust")]
    #[error(transparent)]
    Trust(#[from] crate::trust::TrustError),
    /// The file cannot be read.
    #[error("{}: {error}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: std::io::Error,
    },
}
