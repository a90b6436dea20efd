//! `--trust KEY`: only archives that are signed by this key.

use crate::serve::ServeError;
use anyhow::Result;
use clap::Args;
use mapd_client::{ClientError, TrustError, TrustedKey};
use std::path::{Path, PathBuf};

/// Whom to trust.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct TrustArgs {
    /// Refuse every map that is not an archive signed by this minisign public key; its signature lies beside it (FILE.mapd.minisig)
    #[arg(long, value_name = "KEY.pub")]
    trust: Option<PathBuf>,
}

impl TrustArgs {
    /// This key, or if none is named, that of the configuration file.
    pub(crate) fn or(self, file: Option<&PathBuf>) -> Self {
        Self { trust: self.trust.or_else(|| file.cloned()) }
    }

    /// The key, if one is named.
    ///
    /// Errors: it cannot be read.
    pub(crate) fn key(&self) -> Result<Option<TrustedKey>> {
        Ok(self.trust.as_ref().map(TrustedKey::open).transpose()?)
    }
}

/// Something that a signature cannot stand for.
#[derive(Debug, thiserror::Error)]
pub(crate) enum NotSignable {
    /// An OpenDRIVE file: what it includes, and how it is compiled, would not be covered.
    #[error(
        "{}: --trust goes with archives (.mapd): compile it and sign the archive with `mapd sign`", file.display()
    )]
    Source {
        /// The file.
        file: PathBuf,
    },
    /// A live map.
    #[error(
        "{name}: --trust goes with archives (.mapd); for a live map, start its daemon with --trust"
    )]
    Live {
        /// The source.
        name: String,
    },
}

/// Checks that a file can be signed at all.
///
/// Errors: it is no archive.
pub(crate) fn signable(file: &Path) -> Result<(), NotSignable> {
    match crate::source::is_archive(file) {
        true => Ok(()),
        false => Err(NotSignable::Source { file: file.to_owned() }),
    }
}

/// Whether this is why something failed: a map that is not trusted is a rejected one.
pub(crate) fn is_distrust(error: &anyhow::Error) -> bool {
    error.chain().any(|cause| {
        let filling = match cause.downcast_ref() {
            Some(ServeError::Fill { error, .. }) => error.is::<TrustError>(),
            _ => false,
        };
        let opening = match cause.downcast_ref() {
            Some(ClientError::Trust(error)) => Some(error),
            _ => cause.downcast_ref(),
        };
        let of_map = opening.is_some_and(|error| !matches!(error, TrustError::Key { .. }));
        filling || of_map || cause.is::<NotSignable>()
    })
}
