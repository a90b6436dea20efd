//! What must go on working: fresh clients, and one that holds a generation.

use crate::beside;
use mapd_client::{Client, Domain, NearestOptions, Snapshot, glam::DVec2};
use mapd_tests::place::Place;
use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};

/// Within this a fresh client must have its answer while a daemon serves.
pub(crate) const DEADLINE: Duration = Duration::from_secs(5);

/// What everybody asks.
const POINT: DVec2 = DVec2::new(50.0, -1.75);

/// Name of the map.
pub(crate) const MAP: &str = "one_road";

/// A place for one victim with an archive to serve, and the answer that is right.
pub(crate) struct Stage {
    pub(crate) place: Place,
    pub(crate) archive: PathBuf,
    pub(crate) answer: String,
    // Removed with the stage.
    _folder: tempfile::TempDir,
}

impl Stage {
    pub(crate) fn new() -> Result<Self, Box<dyn std::error::Error>> {
        let place = Place::new(beside("mapd_under_test"));
        let folder = tempfile::tempdir()?;
        let archive = folder.path().join(format!("{MAP}.mapd"));
        let source = mapd_tests::carried("one_road.xodr");
        let made = place.command().arg("compile").arg(source).arg("-o").arg(&archive).status()?;
        if !made.success() {
            return Err("the map cannot be compiled".into());
        }
        let answer = ask(&Snapshot::open(&archive)?)?;
        Ok(Self { place, archive, answer, _folder: folder })
    }

    pub(crate) fn domain(&self) -> Domain {
        self.place.domain()
    }

    /// The daemon's command.
    pub(crate) fn daemon(&self) -> Command {
        let mut command = self.place.command();
        command.arg("--load").arg(&self.archive);
        command
    }

    /// The client's command: attach, ask once, detach.
    pub(crate) fn client(&self) -> Command {
        let mut command = self.place.command_of(beside("planner_probe"));
        command.args(["ask", MAP, &DEADLINE.as_millis().to_string()]);
        command
    }

    /// Attaches afresh, in this process, and compares the answer.
    ///
    /// Errors: what was wrong. The time taken otherwise.
    pub(crate) fn fresh(&self) -> Result<Duration, String> {
        let start = Instant::now();
        let client = Client::connect_in(&self.domain(), MAP, DEADLINE);
        let client = client.map_err(|error| format!("attaching: {error}"))?;
        self.check(&client.snapshot())?;
        Ok(start.elapsed())
    }

    /// Compares a snapshot's answer, and proves its bytes.
    pub(crate) fn check(&self, snapshot: &Snapshot) -> Result<(), String> {
        let answer = ask(snapshot).map_err(|error| error.to_string())?;
        if answer != self.answer {
            return Err(format!("expected the answer {}, found {answer}", self.answer));
        }
        snapshot.verify().map_err(|error| error.to_string())
    }

    /// Everything of the domain that is in shared memory.
    pub(crate) fn left(&self) -> Vec<PathBuf> {
        let mut left = self.place.segments();
        let mut folders = vec![self.domain().root().to_owned()];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
                let path = entry.path();
                if path.is_dir() { folders.push(path) } else { left.push(path) }
            }
        }
        left
    }
}

/// Lane and all digits of the place.
fn ask(snapshot: &Snapshot) -> Result<String, Box<dyn std::error::Error>> {
    let map = snapshot.map();
    let hit = map.nearest_lane(POINT, &NearestOptions::default())?.ok_or("no lane")?;
    Ok(format!("{} {:?}", map.lane(hit.lane)?.key(), hit.position))
}
