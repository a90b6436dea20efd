//! Compiling and checking files in this process.

use crate::batch::{fields, result};
use crate::errors::{client, file, raise};
use crate::held::Held;
use crate::map::Map;
use mapd_archive::encode;
use mapd_client::Snapshot;
use mapd_compiler::{
    Compilation, CompileOptions, OnError, ReadOptions, Treatment, Verdict, check_with, compile_from,
};
use mapd_rules::Profile;
use mapd_xodr::Severity;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The folder of a file, from which it may include others.
fn folder(path: &Path) -> Option<PathBuf> {
    let parent = path.parent()?;
    Some(if parent.as_os_str().is_empty() { PathBuf::from(".") } else { parent.to_owned() })
}

/// Compiles a file, or only checks it: a map, if one was built, and a report; what `mapd.compile` and `mapd.check` call.
#[pyfunction]
#[pyo3(signature = (path, *, build, profile, on_error, index_tolerance, bound_tolerance, lane_reach, landmarks, threads))]
#[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
pub(crate) fn read_file<'py>(
    py: Python<'py>,
    path: PathBuf,
    build: bool,
    profile: &str,
    on_error: &str,
    index_tolerance: Option<f64>,
    bound_tolerance: Option<f64>,
    lane_reach: Option<f64>,
    landmarks: Option<u8>,
    threads: usize,
) -> PyResult<(Option<Map>, Bound<'py, PyAny>)> {
    let (reading, options) = {
        let mut reading = ReadOptions { include_folder: folder(&path), ..ReadOptions::default() };
        reading.rules.profile = Profile::named(profile).ok_or_else(|| {
            let known = Profile::ALL.map(|(name, _)| name);
            PyValueError::new_err(format!("profile: expected one of {known:?}, found {profile:?}"))
        })?;
        reading.policy.on_error = match on_error {
            "quarantine" => OnError::Quarantine,
            "reject" => OnError::Reject,
            "reference-line" => OnError::ReferenceLine,
            _ => {
                return Err(PyValueError::new_err(format!(
                    "on_error: expected \"quarantine\", \"reject\" or \"reference-line\", found {on_error:?}"
                )));
            }
        };
        let plain = CompileOptions::default();
        let options = CompileOptions {
            index_tolerance: index_tolerance.unwrap_or(plain.index_tolerance),
            bound_tolerance: bound_tolerance.unwrap_or(plain.bound_tolerance),
            lane_reach: lane_reach.unwrap_or(plain.lane_reach),
            landmarks: landmarks.unwrap_or(plain.landmarks),
            ..plain
        };
        options.validate().map_err(|error| PyValueError::new_err(error.to_string()))?;
        (reading, options)
    };
    if path.is_dir() {
        return Err(raise("FileError", format!("{} is a folder", path.display())));
    }
    // Threads of its own: those of a pool that lasts are not there any more in a process that was forked off.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
    let compiled = py.detach(|| {
        pool.install(|| {
            let open = || File::open(&path);
            if build {
                compile_from(open, &reading, &options, &mut |_| {})
            } else {
                check_with(open, &reading, &options, &mut |_| {})
            }
        })
    });
    let compiled = compiled.map_err(|error| file(&path, &error))?;
    let map = match &compiled.rows {
        Some(rows) if build => {
            let bytes = py.detach(|| encode(rows, &compiled.provenance));
            let bytes = bytes.map_err(|error| raise("ArchiveError", error.to_string()))?;
            let snapshot = Snapshot::from_bytes(bytes).map_err(client)?;
            Some(Map::of(Arc::new(Held::new(snapshot))))
        }
        _ => None,
    };
    Ok((map, report(py, &compiled)?))
}

fn severity(severity: Severity) -> &'static str {
    match severity {
        Severity::Info => "info",
        Severity::Warning => "warning",
        Severity::Error => "error",
    }
}

fn report<'py>(py: Python<'py>, compiled: &Compilation) -> PyResult<Bound<'py, PyAny>> {
    let findings = compiled.diagnostics.iter().map(|diagnostic| {
        let finding = &diagnostic.finding;
        let fields = fields!(
            py,
            rule = finding.rule,
            severity = severity(finding.severity),
            message = &finding.message,
            hint = &finding.hint,
            path = &finding.path,
            subject = &*finding.subject,
            file = &*diagnostic.file,
            line = diagnostic.line,
            column = diagnostic.column,
            rejects = diagnostic.rejects,
        );
        result(py, "Finding", &fields)
    });
    let findings = pyo3::types::PyTuple::new(py, findings.collect::<PyResult<Vec<_>>>()?)?;
    let quarantined = compiled.quarantined.iter().map(|part| {
        let fields = fields!(
            py,
            kind = part.kind.name(),
            id = &part.id,
            owner = &part.owner,
            owner_kind = part.owner_kind.name(),
            dropped = part.treatment == Treatment::Dropped,
            length = part.length,
            rule = part.rule,
            message = &part.message,
            file = &*part.file,
            line = part.line,
            column = part.column,
        );
        result(py, "QuarantinedPart", &fields)
    });
    let quarantined = pyo3::types::PyTuple::new(py, quarantined.collect::<PyResult<Vec<_>>>()?)?;
    let verdict = match compiled.verdict {
        Verdict::Accepted => "accepted",
        Verdict::Quarantined => "quarantined",
        Verdict::Rejected => "rejected",
    };
    let [infos, warnings, errors] = compiled.dropped;
    let fields = fields!(
        py,
        verdict = verdict,
        findings = findings,
        dropped = (infos, warnings, errors),
        quarantined = quarantined,
        version = &compiled.version.stated,
        checked_against = compiled.version.checked,
    );
    result(py, "Report", &fields)
}
