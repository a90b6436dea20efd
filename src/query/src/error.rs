//! Why a query has no answer.

use thiserror::Error;

/// Why a query has no answer.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum QueryError {
    /// The id was handed out by a map with other content.
    #[error("the id belongs to another map content; look it up again by its key in this snapshot")]
    ForeignId,
    /// The id names nothing: it stands where nothing was found, as in a column of a batch.
    #[error("the id names nothing: it stands where nothing was found")]
    NoId,
    /// The archive contradicts itself here.
    #[error("the archive is damaged at this place; `mapd inspect --verify` names the row")]
    Corrupt,
    /// As [`QueryError::NotFinite`], of one of several places: by its number from 0.
    #[error("the coordinates of place {0} are not finite numbers of at most 1e9")]
    NotFiniteAt(usize),
    /// A column of a batch that is not as long as the others, or not there: by its name.
    #[error("the column {0} is not as long as the others")]
    Length(&'static str),
    /// An option that no answer can be given with: by its name.
    #[error("the option {0} is outside of its domain")]
    Option(&'static str),
    /// A coordinate that is not a finite number, or lies farther than 10⁹ m from 0, where no map has anything.
    #[error("the coordinates are not finite numbers of at most 1e9")]
    NotFinite,
}

/// Row of an id that names nothing, wherever ids are plain numbers: in C, in columns, in Python.
const NO_ROW: u32 = u32::MAX;

impl QueryError {
    /// As it is of an id with this row, which may name nothing in any map.
    #[cold]
    pub(crate) fn of_row(self, row: u32) -> Self {
        if row == NO_ROW { Self::NoId } else { self }
    }

    /// As it is of one of several places.
    pub(crate) fn at(self, place: usize) -> Self {
        match self {
            Self::NotFinite => Self::NotFiniteAt(place),
            other => other,
        }
    }
}
