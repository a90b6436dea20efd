//! Why a query has no answer.

use thiserror::Error;

/// Why a query has no answer.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum QueryError {
    /// The id was handed out by a map with other content.
    #[error("the id belongs to another map content; look it up again by its key in this snapshot")]
    ForeignId,
    /// The archive contradicts itself here.
    #[error("the archive is damaged at this place; `mapd inspect --verify` names the row")]
    Corrupt,
    /// A coordinate that is not a finite number.
    #[error("the coordinates are not finite numbers")]
    NotFinite,
}
