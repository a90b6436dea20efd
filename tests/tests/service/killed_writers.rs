//! `mapd compile` killed at each system call of its writing: under the final name is the old archive, whole, or the new one,
//! whole, or nothing; and what is left over hinders nobody.

use mapd_tests::say;
use mapd_tests::tracer::{Side, Then, Traced};
use nix::errno::Errno;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};
use std::time::Duration;
use tempfile::TempDir;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Moments at which writers are killed, at most; they have fewer.
const MOMENTS: usize = 400;

/// Tiles that are compiled together.
const TILES: usize = 6;

/// Each run of tiles lives this much longer than the one before.
const STEP: Duration = Duration::from_millis(40);

/// Time in which the kernel ends the children of a process that was killed.
const MOMENT: Duration = Duration::from_millis(100);

/// What is written, and where.
struct Scene {
    folder: TempDir,
    /// The archive as a run without a kill writes it.
    new: Vec<u8>,
    /// Another map's archive.
    old: Vec<u8>,
}

impl Scene {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        let archive = |map: &str| {
            let source = at(&format!("{map}.xodr"));
            fs::copy(mapd_tests::carried(&format!("{map}.xodr")), &source).expect("copied");
            let done = Command::new(MAPD).arg("compile").arg(&source).output().expect("runs");
            assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
            let path = at(&format!("{map}.mapd"));
            let bytes = fs::read(&path).expect("written");
            fs::remove_file(path).expect("removed");
            bytes
        };
        let (new, old) = (archive("one_road"), archive("town"));
        fs::create_dir(at("out")).expect("made");
        Self { folder, new, old }
    }

    fn out(&self) -> PathBuf {
        self.folder.path().join("out")
    }

    fn archive(&self) -> PathBuf {
        self.out().join("map.mapd")
    }

    fn report(&self) -> PathBuf {
        self.out().join("map.json")
    }

    fn command(&self) -> Command {
        let mut command = Command::new(MAPD);
        command.arg("compile").arg(self.folder.path().join("one_road.xodr"));
        command.arg("-o").arg(self.archive()).arg("--report").arg(self.report());
        command
    }

    /// As it is before a run: with the old archive, or without one.
    fn reset(&self, has_old: bool) {
        fs::remove_dir_all(self.out()).expect("removed");
        fs::create_dir(self.out()).expect("made");
        if has_old {
            fs::write(self.archive(), &self.old).expect("written");
        }
    }

    fn names(&self) -> Vec<String> {
        names(&self.out())
    }

    /// What a kill may leave.
    fn check(&self, has_old: bool, when: &str) {
        match fs::read(self.archive()) {
            Ok(bytes) if bytes == self.new => {}
            Ok(bytes) => assert!(has_old && bytes == self.old, "{when}: half an archive"),
            Err(error) => assert!(!has_old, "{when}: the old archive is gone: {error}"),
        }
        if let Ok(report) = fs::read(self.report()) {
            let report: serde_json::Result<serde_json::Value> = serde_json::from_slice(&report);
            assert!(report.is_ok(), "{when}: half a report");
        }
        let left = self.names();
        let done = self.command().output().expect("runs");
        let told = String::from_utf8_lossy(&done.stderr).into_owned();
        assert!(done.status.success(), "{when}: the next run fails: {told}; left were {left:?}");
        assert!(fs::read(self.archive()).expect("there") == self.new, "{when}");
        assert_eq!(self.names(), ["map.json", "map.mapd"], "{when}: left over by the next run");
    }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder").flatten();
    let mut names: Vec<String> =
        entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// A moment of writing: before or after a call, and which of the calls of that name it is, counted from the first change in the folder. How often the
/// first thread waits for others differs from run to run, so that all its calls together cannot be counted.
type Met = (String, usize);

/// Runs the command and kills it at the first moment of its writing that has not been met. How it ended, and the moment. `None` where tracing is not
/// permitted.
fn kill_at_another(scene: &Scene, met: &BTreeSet<Met>) -> Option<(ExitStatus, Met)> {
    let (traced, _) = match Traced::start(&scene.command(), "", Stdio::null()) {
        Err(error) if error.raw_os_error() == Some(Errno::EPERM as i32) => return None,
        started => started.expect("starts"),
    };
    let before = scene.names();
    let (mut begun, mut calls, mut when) = (false, BTreeMap::new(), ("at its end".to_owned(), 0));
    let ended = traced.run(|moment| {
        // No other call of a writer's changes the names in a folder.
        let may_name = ["open", "rename", "link", "mkdir"]
            .iter()
            .any(|part| moment.name.name().contains(part));
        begun = begun || moment.side == Side::After && may_name && names(&scene.out()) != before;
        // The others wait, or end.
        if !begun || moment.thread != 0 {
            return Then::Continue;
        }
        let side = if moment.side == Side::Before { "before" } else { "after" };
        let name = format!("{side} {}", moment.name);
        let count = calls.entry(name.clone()).or_insert(0);
        *count += 1;
        let this = (name, *count);
        if met.contains(&this) {
            return Then::Continue;
        }
        when = this;
        Then::Kill
    });
    Some((ended.expect("runs"), when))
}

#[test]
fn killed_at_every_system_call_of_writing() {
    let scene = Scene::new();
    for has_old in [false, true] {
        let mut killed = BTreeSet::new();
        for _ in 0..MOMENTS {
            scene.reset(has_old);
            let Some((ended, when)) = kill_at_another(&scene, &killed) else {
                return say("SKIPPED: tracing is not permitted");
            };
            scene.check(has_old, &format!("{} {}", when.0, when.1));
            if ended.code().is_some() {
                break;
            }
            killed.insert(when);
        }
        // Archive and report are drafts that are renamed; each call is met before and after.
        let met = |part: &str| killed.iter().filter(|(when, _)| when == part).count();
        for (part, least) in [("before rename", 2), ("after rename", 2), ("before fallocate", 1)] {
            assert!(met(part) >= least, "{part} was not met: {killed:?}");
        }
        assert!(killed.len() < MOMENTS, "not all moments were met: {}", killed.len());
        say(&format!("killed at {} moments, old archive: {has_old}", killed.len()));
    }
}

/// Drafts of killed writers are taken over.
#[test]
fn what_is_left_over_is_taken_by_the_next_run() {
    let scene = Scene::new();
    for name in [".map.mapd.new", ".map.json.new"] {
        fs::write(scene.out().join(name), vec![7; 1 << 20]).expect("written");
    }
    scene.check(false, "two drafts are left");
}

/// A killed run over tiles takes its compilers along, and the next run does what is left to do.
#[test]
fn tiles_go_on_where_a_kill_has_ended_them() {
    let scene = Scene::new();
    let tiles: Vec<String> = (0..TILES).map(|number| format!("tile{number}")).collect();
    let folder = scene.folder.path().join("tiles");
    fs::create_dir(&folder).expect("made");
    for tile in &tiles {
        let source = mapd_tests::carried("one_road.xodr");
        fs::copy(source, folder.join(format!("{tile}.xodr"))).expect("copied");
    }
    let command = || {
        let mut command = Command::new(MAPD);
        command.arg("compile").arg(&folder).arg("--output-dir").arg(scene.out());
        command.args(["--jobs", "2", "--json"]).stdout(Stdio::piped()).stderr(Stdio::null());
        command
    };
    let mut finished = 0;
    for kill in 0.. {
        let mut child = command().arg("--force").spawn().expect("starts");
        std::thread::sleep(STEP * kill);
        let is_over = child.try_wait().expect("waited for").is_some();
        child.kill().expect("killed");
        child.wait().expect("waited for");
        // Its compilers are dead, or will be in a moment.
        std::thread::sleep(MOMENT);
        for name in names(&scene.out()).iter().filter(|name| name.ends_with(".mapd")) {
            let bytes = fs::read(scene.out().join(name)).expect("there");
            assert!(bytes == scene.new, "killed after {kill} steps: half an archive {name}");
            finished += 1;
        }
        if is_over {
            break;
        }
    }
    assert!(finished > 0, "nothing was ever finished");
    let done = command().output().expect("runs");
    assert_eq!(done.status.code(), Some(0));
    let table: serde_json::Value = serde_json::from_slice(&done.stdout).expect("JSON");
    assert_eq!(table["sums"]["accepted"], TILES);
    let expected =
        tiles.iter().flat_map(|tile| [format!("{tile}.mapd"), format!("{tile}.report.json")]);
    assert_eq!(scene.names(), expected.collect::<Vec<_>>());
}
