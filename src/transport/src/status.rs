//! What is served in a domain.

use crate::claim::{SUFFIX, served_by};
use crate::domain::Domain;
use crate::error::AttachError;
use crate::limits::check_map_name;
use crate::observer::published;
use crate::payload::GenerationInfo;
use crate::user::check_owner;
use std::io;

/// One map of a domain.
#[derive(Clone, Debug)]
pub struct MapStatus {
    /// Name.
    pub name: String,
    /// Whether a daemon serves it now. If not, only processes that hold a generation can read it.
    pub alive: bool,
    /// What was published last.
    pub info: Option<GenerationInfo>,
}

/// Maps of a domain that are served, or were when their daemon was killed, by name. Attaches to nothing.
///
/// Errors: the domain belongs to another user, or cannot be read. A domain where no daemon has been is empty, not an error.
pub fn list_maps(domain: &Domain) -> Result<Vec<MapStatus>, AttachError> {
    match check_owner(domain) {
        Err(AttachError::Io { source, .. }) if source.kind() == io::ErrorKind::NotFound => {
            return Ok(Vec::new());
        }
        other => other?,
    }
    let names = claimed_names(domain).map_err(|error| AttachError::io(domain.root(), error))?;
    let status = |name: String| {
        let alive = served_by(domain, &name).is_some();
        let info = published(domain, &name);
        MapStatus { name, alive, info }
    };
    Ok(names.into_iter().map(status).collect())
}

/// Names of the maps that are served now, sorted.
pub(crate) fn alive_maps(domain: &Domain) -> Vec<String> {
    let names = claimed_names(domain).unwrap_or_default();
    names.into_iter().filter(|name| served_by(domain, name).is_some()).collect()
}

fn claimed_names(domain: &Domain) -> io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(domain.root())? {
        let file = entry?.file_name();
        let name = file.to_str().and_then(|name| name.strip_suffix(SUFFIX));
        // Another user's folder may have any names, which are shown on terminals.
        names.extend(name.filter(|name| check_map_name(name).is_ok()).map(str::to_owned));
    }
    names.sort();
    Ok(names)
}
