//! Errors: a class per kind, in `mapd._errors`.

use mapd_client::localisation::MatchError;
use mapd_client::route::RouteError;
use mapd_client::{AttachError, ClientError, QueryError};
use pyo3::IntoPyObject;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// An error of a class of `mapd._errors`.
pub(crate) fn raise(class: &str, message: impl Into<String>) -> PyErr {
    Python::attach(|py| with(py, class, (message.into(),).into_pyobject(py)))
}

fn with<'py>(py: Python<'py>, class: &str, args: PyResult<Bound<'py, PyTuple>>) -> PyErr {
    let made = || -> PyResult<PyErr> {
        let class = py.import("mapd._errors")?.getattr(class)?;
        Ok(PyErr::from_value(class.call1(args?)?))
    };
    made().unwrap_or_else(|error| error)
}

fn query_class(error: &QueryError) -> &'static str {
    match error {
        QueryError::ForeignId => "ForeignIdError",
        QueryError::Corrupt => "CorruptError",
        QueryError::NotFinite | QueryError::NotFiniteAt(_) => "NotFiniteError",
        _ => "QueryError",
    }
}

/// Why a query has no answer, as Python has it.
pub(crate) fn query(error: QueryError) -> PyErr {
    raise(query_class(&error), error.to_string())
}

/// As [`query`], of a row of a batch.
pub(crate) fn query_in_row((row, error): (usize, QueryError)) -> PyErr {
    raise(query_class(&error), format!("row {row}: {error}"))
}

/// Why a route cannot be asked for; what was given wrongly is Python's own error.
pub(crate) fn routing(error: RouteError) -> PyErr {
    match &error {
        RouteError::Option(_) => PyValueError::new_err(error.to_string()),
        _ => raise(query_class(&QueryError::from(error)), error.to_string()),
    }
}

/// Why a pose or trace has no match; what was given wrongly is Python's own error.
fn match_error(row: &str, error: MatchError) -> PyErr {
    match &error {
        MatchError::Query(query) => raise(query_class(query), format!("{row}{error}")),
        MatchError::Pose(_) | MatchError::NotFinite(..) | MatchError::Fix(_) => {
            raise("NotFiniteError", format!("{row}{error}"))
        }
        _ => PyValueError::new_err(format!("{row}{error}")),
    }
}

/// As [`query`], of a match.
pub(crate) fn matching(error: MatchError) -> PyErr {
    match_error("", error)
}

/// As [`query_in_row`], of a match.
pub(crate) fn match_in_row((row, error): (usize, MatchError)) -> PyErr {
    match_error(&format!("row {row}: "), error)
}

/// Why a map cannot be opened, as an exception.
pub(crate) fn client(error: ClientError) -> PyErr {
    let class = match &error {
        ClientError::Attach(attach) => attach_class(attach),
        ClientError::File { path, source } => return file(path, source),
        ClientError::Open { .. } | ClientError::Verify { .. } => "ArchiveError",
        ClientError::Trust(_) => "NotTrustedError",
        _ => "MapdError",
    };
    raise(class, error.to_string())
}

/// A file that cannot be read, with the system's number.
pub(crate) fn file(path: &std::path::Path, error: &std::io::Error) -> PyErr {
    let name = path.display().to_string();
    Python::attach(|py| match error.raw_os_error() {
        Some(number) => {
            let said = error.to_string();
            let said = said.split(" (os error").next().unwrap_or_default().to_owned();
            with(py, "FileError", (number, said, name).into_pyobject(py))
        }
        None => with(py, "FileError", (format!("{name}: {error}"),).into_pyobject(py)),
    })
}

fn attach_class(error: &AttachError) -> &'static str {
    match error {
        AttachError::Domain(_) | AttachError::MapName { .. } => "BadNameError",
        AttachError::NoDaemon { .. } => "NoDaemonError",
        AttachError::NoSuchMap { .. } => "NoSuchMapError",
        AttachError::NoGeneration { .. } => "NoGenerationError",
        AttachError::Superseded { .. } => "SupersededError",
        AttachError::WrongTransport { .. } => "WrongTransportError",
        AttachError::TooManySubscribers { .. }
        | AttachError::TooManyPinned { .. }
        | AttachError::NoRoom { .. }
        | AttachError::LockLimit { .. }
        | AttachError::NoDescriptors { .. } => "ExhaustedError",
        AttachError::PermissionDenied { .. }
        | AttachError::OnlyObservers { .. }
        | AttachError::NoSubscribers { .. }
        | AttachError::UnknownOwner { .. }
        | AttachError::NotShared { .. } => "NotPermittedError",
        AttachError::Stuck { .. } | AttachError::Busy { .. } => "BusyError",
        _ => "AttachError",
    }
}
