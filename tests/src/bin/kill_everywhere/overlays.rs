//! A daemon killed at every system call of starting with an overlay that is kept, of laying others over what it serves, and of writing them down.

use crate::changes::{Asked, killed, stage};
use crate::report::{Choice, Report};
use mapd_client::{Attach, AttachError, ClientError};
use mapd_tests::stage::{Checked, Stage};
use std::path::Path;
use std::time::{Duration, SystemTime};

/// Overlays that are applied one after the other: of each, all entries say its number.
const REVISIONS: usize = 3;

/// Entries of each: more than one, so that half of them would be seen.
const ENTRIES: usize = 8;

pub(crate) fn daemon(mapd: &Path, choice: Choice<'_>) -> Checked<Report> {
    let (stage, folder) = stage(mapd)?;
    let mut asked = Asked::new();
    for revision in 0..REVISIONS {
        let entry = |i: usize| {
            format!(
                r#"{{"id":"{i}","kind":"warning","text":"{revision}","lanes":[{{"road":"1","s":[{i},{}]}}]}}"#,
                i + 1
            )
        };
        let entries: Vec<String> = (0..ENTRIES).map(entry).collect();
        let path = folder.path().join(format!("{revision}.json"));
        std::fs::write(&path, format!(r#"{{"entries":[{}]}}"#, entries.join(",")))
            .map_err(|error| error.to_string())?;
        let (name, path) = (stage.name(), path.display().to_string());
        let args = ["overlay", &name, "apply", &path, "--wait", "5"];
        asked.push(args.map(str::to_owned).to_vec());
    }
    killed(
        &stage,
        "daemon, while overlays are laid over what it serves",
        &asked,
        choice,
        Some(revision),
    )
}

/// The revision that a client finds when it attaches, whole.
fn revision(stage: &Stage) -> Checked<Option<usize>> {
    let client = match stage.client(Attach::Observer, Duration::ZERO) {
        Ok(client) => client,
        Err(ClientError::Attach(
            AttachError::NoDaemon { .. } | AttachError::NoGeneration { .. },
        )) => return Ok(None),
        Err(error) => return Err(format!("the overlay: {error}")),
    };
    let snapshot = client.snapshot();
    let view = snapshot.view(SystemTime::UNIX_EPOCH);
    let said: Vec<&str> = view.entries().map(|entry| entry.text()).collect();
    match said.first().and_then(|text| text.parse().ok()) {
        Some(one) if said.len() == ENTRIES && said.iter().all(|text| *text == said[0]) => {
            Ok(Some(one))
        }
        _ => Err(format!("no whole overlay: {said:?}")),
    }
}
