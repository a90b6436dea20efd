//! What a signature can stand for, and whether the want of one is why something failed.

use crate::serve::ServeError;
use mapd_client::{ClientError, TrustError};
use std::path::{Path, PathBuf};

/// Something that a signature cannot stand for, or that has none.
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
    /// Entries of an overlay that came without a signature.
    #[error(
        "the entries are not signed, and the daemon takes only signed ones (--overlay-trust): `mapd sign FILE --key SECRET` signs a file of entries; a WZDx feed cannot be signed, for lanes are found for it before it is sent"
    )]
    Unsigned,
    /// An entry that is kept without a signature.
    #[error(
        "entry {id:?} is not signed, and --overlay-trust takes only signed ones: apply what it says signed, or start without --overlay-trust"
    )]
    Kept {
        /// Its name.
        id: String,
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
            Some(ServeError::Fill { source, .. }) => source.is::<TrustError>(),
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
