//! What commands say about how far they are, and where: never on stdout, nothing at all if that is asked for.

use mapd_tests::{command::on_a_terminal, say, town::town};
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};
use tempfile::TempDir;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// A line after each step.
const EACH: [&str; 2] = ["--progress-interval", "0"];

struct Scene(TempDir);

impl Scene {
    /// A folder with a town, and a map that is rejected.
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        fs::create_dir(folder.path().join("maps")).expect("made");
        fs::copy(mapd_tests::carried("town.xodr"), folder.path().join("maps/town.xodr"))
            .expect("copied");
        let bad = "<OpenDRIVE>\n<road id=\"1\" length=\"nan\"/></OpenDRIVE>";
        fs::write(folder.path().join("bad.xodr"), bad).expect("written");
        Self(folder)
    }

    fn at(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn run(&self, args: &[&str]) -> (String, String) {
        let output = Command::new(MAPD).args(args).current_dir(self.0.path()).output();
        let Output { stdout, stderr, .. } = output.expect("runs");
        let text = |bytes| String::from_utf8(bytes).expect("text");
        (text(stdout), text(stderr))
    }
}

#[test]
fn lines_where_there_is_no_terminal() {
    let scene = Scene::new();
    let limited = ["compile", "maps/town.xodr", "--max-memory", "1GiB"];
    for (command, name, parts) in [
        (
            &["compile", "maps/town.xodr"][..],
            "town.xodr",
            &[" kB of 46.2 kB (", " roads, ", "/s, ", " s left", "sampling", "so far"][..],
        ),
        (&["check", "maps/town.xodr"], "town.xodr", &[" kB of 46.2 kB (", " roads, ", " s left"]),
        (&limited, "town.xodr", &[" kB of 46.2 kB (", " roads, ", "sampling"]),
        (&["compile", "maps", "--force"], "compiling", &["(100 %), 1 of 1 tiles, 56 roads, "]),
    ] {
        let plain = scene.run(command);
        assert_eq!(plain.1, "", "{command:?}: all is done before a line is due");
        let (out, told) = scene.run(&[command, &EACH].concat());
        assert!(told.lines().all(|line| line.starts_with(&format!("{name}: "))), "{told}");
        for part in parts {
            assert!(told.contains(part), "{command:?}: {part:?} is missing in {told}");
        }
        // What it is measured by differs from run to run: seconds.
        let words = |text: &str| text.lines().count();
        assert_eq!(words(&out), words(&plain.0), "{command:?}: stdout has results alone");
        assert!(!out.contains(" s left"), "{out}");
    }
}

/// An export says how far compiling is, then how far writing is, in every format, unless it is told to be quiet.
#[test]
fn an_export_says_what_it_writes() {
    let scene = Scene::new();
    for (format, parts) in [
        ("svg", &["writing lanes", "writing objects and signals"][..]),
        ("geojson", &["writing lanes", "writing edges"]),
        ("flatgeobuf", &["writing lanes", "writing edges", "writing the index"]),
        ("html", &["writing packing the map"]),
        (
            "lanelet2",
            &[
                "writing joining lanes",
                "writing aligning borders",
                "writing points",
                "writing lanelets",
            ],
        ),
    ] {
        let mut command = vec!["export", "maps/town.xodr", "--format", format, "-o", "out"];
        if ["geojson", "lanelet2"].contains(&format) {
            command.extend(["--origin", "49,8.4"]);
        }
        let nothing = (String::new(), String::new());
        assert_eq!(scene.run(&command), nothing, "{format}: all is done before a line is due");
        let (_, told) = scene.run(&[&command[..], &EACH].concat());
        for part in ["town.xodr: ", " roads, "] {
            assert!(told.contains(part), "{format}: {part:?} is missing in {told}");
        }
        for part in parts {
            let part = format!("out: {part}");
            assert!(told.contains(&part), "{format}: {part:?} is missing in {told}");
        }
        let quiet = scene.run(&[&command[..], &["--quiet"], &EACH].concat());
        assert_eq!(quiet, nothing);
    }
}

#[test]
fn quiet_says_nothing_but_findings_and_errors() {
    let scene = Scene::new();
    let quiet = |args: &[&str]| scene.run(&[args, &["--quiet"], &EACH].concat());
    for args in [
        &["compile", "maps/town.xodr"][..],
        &["compile", "maps/town.xodr", "--max-memory", "1GiB"],
        &["compile", "maps", "--force"],
    ] {
        assert_eq!(quiet(args), (String::new(), String::new()), "{args:?}");
    }
    assert!(scene.at("maps/town.mapd").exists());
    let check = ["check", "maps/town.xodr"];
    assert_eq!(quiet(&check), (scene.run(&check).0, String::new()), "findings are its result");
    for args in [
        &["compile", "bad.xodr"][..],
        &["compile", "bad.xodr", "--max-memory", "1GiB"],
        &["compile", "bad.xodr", "maps"],
    ] {
        let (out, told) = quiet(args);
        assert!(out.is_empty() && told.contains("bad.xodr:2:22: error"), "{args:?}: {told}");
        let is_finding = |line: &str| line.starts_with("bad.xodr:") || line.starts_with("    at ");
        assert!(told.lines().all(is_finding), "{args:?}: {told}");
        assert!(told.ends_with("bad.xodr: rejected, 3 errors\n"), "{args:?}: {told}");
    }
    let (out, told) = quiet(&["compile", "missing.xodr"]);
    assert!(out.is_empty() && told.starts_with("mapd: opening missing.xodr"), "{told}");
    // What is asked for as JSON is a result.
    assert!(quiet(&["compile", "maps", "--json"]).0.starts_with('{'));
}

#[test]
fn a_bar_on_a_terminal() {
    let scene = Scene::new();
    // Large enough to be drawn while it is read.
    fs::write(scene.at("large.xodr"), town(20, 20)).expect("written");
    let shown_of =
        |command: &str| on_a_terminal(&format!("{MAPD} {command}"), 80, scene.0.path(), &[]);
    for command in [
        "compile large.xodr",
        "compile large.xodr --max-memory 2GiB",
        "compile maps large.xodr --force",
        "check large.xodr",
    ] {
        let Some(shown) = shown_of(command) else {
            return say("SKIPPED: there is no program `script` that offers a terminal");
        };
        let has_bar = |shown: &str| [" roads [", " lanes ["].iter().any(|bar| shown.contains(bar));
        assert!(has_bar(&shown), "{command}: {shown:?}");
        let quiet = shown_of(&format!("{command} --quiet")).expect("as before");
        assert!(!has_bar(&quiet), "{command}: {quiet:?}");
    }
}
