//! Telling the daemon what a process on board has seen.

use crate::batch::{fields, result};
use crate::client::seconds;
use crate::errors::{client as client_error, raise};
use mapd_client::overlay::{Decision, ProposeError, Proposer};
use mapd_client::{AttachError, Domain};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyString;

/// Proposes an entry of an overlay to the daemon that serves a map, and waits for its decision (docs/overlay.md).
///
/// `source` is what this process calls itself: the daemon's policy names it. `entry` is JSON, or what becomes JSON, by
/// schemas/overlay.schema.json; one of the same id is replaced, and so goes on to hold. A refusal raises
/// `ProposalRefusedError`, with the daemon's reason.
#[pyfunction]
#[pyo3(signature = (map, source, entry, *, timeout = 1.0, prefix = None))]
pub(crate) fn propose<'py>(
    py: Python<'py>,
    map: &str,
    source: &str,
    entry: &Bound<'py, PyAny>,
    timeout: f64,
    prefix: Option<&str>,
) -> PyResult<Bound<'py, PyAny>> {
    let entry: String = match entry.cast::<PyString>() {
        Ok(text) => text.extract()?,
        Err(_) => py.import("json")?.getattr("dumps")?.call1((entry,))?.extract()?,
    };
    let domain = Domain::from_env_or(prefix);
    let domain = domain.map_err(|error| client_error(AttachError::from(error).into()))?;
    let (proposer, wait) = (Proposer::new(&domain, map, source), seconds(timeout)?);
    let decision = py.detach(|| proposer.propose(&entry, wait)).map_err(undecided)?;
    let (accepted, agree, needed) = match decision {
        Decision::Accepted => (true, 0, 0),
        Decision::Waiting { agree, needed } => (false, agree, needed),
        Decision::Refused { reason } => return Err(raise("ProposalRefusedError", reason)),
    };
    result(py, "Decision", &fields!(py, accepted = accepted, agree = agree, needed = needed))
}

fn undecided(error: ProposeError) -> PyErr {
    let class = match &error {
        ProposeError::NoDaemon { .. } => "NoDaemonError",
        ProposeError::Denied { .. } => "NotPermittedError",
        ProposeError::Unfit => return PyValueError::new_err(error.to_string()),
        ProposeError::Late { .. } => "BusyError",
        _ => "AttachError",
    };
    raise(class, error.to_string())
}
