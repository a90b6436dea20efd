//! `mapd compile` of many files: one archive and one report each, whatever becomes of the others.

use mapd_tests::test_domain::PATIENCE;
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// A map that is rejected.
const BAD: &str = "<OpenDRIVE>\n<road id=\"1\" length=\"nan\"/></OpenDRIVE>";

/// A map without roads.
const EMPTY: &str = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/></OpenDRIVE>";

/// Memory that is too little for any map, and yet enough to begin with `[bytes]`.
const TOO_LITTLE: &str = "64KiB";

struct Scene {
    folder: TempDir,
}

impl Scene {
    /// A folder with files; `one_road` and `town` stand for the carried maps.
    fn new(files: &[(&str, &str)]) -> Self {
        let scene = Self { folder: tempfile::tempdir().expect("a folder") };
        files.iter().for_each(|(name, text)| scene.put(name, text));
        scene
    }

    fn at(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn put(&self, name: &str, text: &str) {
        let path = self.at(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("made");
        match text {
            "one_road" | "town" => {
                let carried = mapd_tests::carried(&format!("{text}.xodr"));
                fs::copy(carried, path).map(drop).expect("copied");
            }
            text => fs::write(path, text).expect("written"),
        }
    }

    /// Runs `mapd compile` in the folder.
    fn run(&self, args: &[&str]) -> Output {
        let mut command = Command::new(MAPD);
        command.arg("compile").args(args).current_dir(self.folder.path());
        command.output().expect("runs")
    }

    /// Runs it with the table as JSON: exit code, rows as (tile, outcome, up to date), and all of the table.
    fn table(&self, args: &[&str]) -> (i32, Vec<(String, String, bool)>, Value) {
        let output = self.run(&[args, &["--json"]].concat());
        let table: Value = serde_json::from_slice(&output.stdout).expect("JSON and nothing else");
        let text = |value: &Value| value.as_str().expect("text").to_owned();
        let row = |row: &Value| {
            let up_to_date = row["up_to_date"].as_bool().expect("yes or no");
            (text(&row["tile"]), text(&row["outcome"]), up_to_date)
        };
        let rows = table["tiles"].as_array().expect("rows").iter().map(row).collect();
        (output.status.code().expect("a code"), rows, table)
    }

    /// All files, by their paths within the folder.
    fn files(&self) -> Vec<String> {
        fn list(folder: &Path, root: &Path, out: &mut Vec<String>) {
            for entry in fs::read_dir(folder).expect("a folder").flatten() {
                let path = entry.path();
                if path.is_dir() {
                    list(&path, root, out);
                } else {
                    out.push(path.strip_prefix(root).expect("within").display().to_string());
                }
            }
        }
        let mut out = Vec::new();
        list(self.folder.path(), self.folder.path(), &mut out);
        out.sort();
        out
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.at(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn rows(expected: &[(&str, &str, bool)]) -> Vec<(String, String, bool)> {
    expected
        .iter()
        .map(|(tile, outcome, is)| (tile.to_string(), outcome.to_string(), *is))
        .collect()
}

#[test]
fn files_and_folders_become_archives_and_reports() {
    let scene = Scene::new(&[
        ("maps/deep/er/b.xodr", "one_road"),
        ("maps/a.xodr", "town"),
        ("maps/notes.txt", "no map"),
        ("single.xodr", EMPTY),
    ]);
    let (code, found, table) = scene.table(&["single.xodr", "maps", "--output-dir", "out/put"]);
    let expected = [
        ("maps/a.xodr", "accepted", false),
        ("maps/deep/er/b.xodr", "accepted", false),
        ("single.xodr", "accepted", false),
    ];
    assert_eq!((code, found), (0, rows(&expected)));
    let made = |file: &String| file.starts_with("out");
    let all = [
        "out/put/a.mapd",
        "out/put/a.report.json",
        "out/put/deep/er/b.mapd",
        "out/put/deep/er/b.report.json",
        "out/put/single.mapd",
        "out/put/single.report.json",
    ];
    assert_eq!(scene.files().into_iter().filter(made).collect::<Vec<_>>(), all);
    // What is in them is what a single file becomes.
    let single = scene.run(&["maps/a.xodr", "-o", "a.mapd", "--report", "a.json"]);
    assert_eq!(single.status.code(), Some(0));
    assert!(scene.bytes("a.mapd") == scene.bytes("out/put/a.mapd"));
    assert_eq!(text(&scene.bytes("a.json")), text(&scene.bytes("out/put/a.report.json")));
    let row = &table["tiles"][0];
    let report: Value = serde_json::from_slice(&scene.bytes("a.json")).expect("JSON");
    assert_eq!(row["archive"]["bytes"], scene.bytes("a.mapd").len());
    assert!(row["archive"]["roads"].as_u64() > Some(1) && row["seconds"].as_f64() > Some(0.0));
    assert_eq!(row["findings"], report["counts"]);
    // Beside the inputs, where nothing else is said, and in any order and number of jobs.
    let (code, found, _) = scene.table(&["single.xodr", "maps", "maps/a.xodr", "--jobs", "1"]);
    assert_eq!((code, found), (0, rows(&expected)));
    assert!(scene.bytes("maps/a.mapd") == scene.bytes("a.mapd"));
}

#[test]
fn a_bad_tile_leaves_the_others_alone() {
    let scene = Scene::new(&[("a.xodr", "town"), ("b.xodr", BAD), ("d.xodr", "one_road")]);
    let args = ["a.xodr", "b.xodr", "c.xodr", "d.xodr", "--output-dir", "out"];
    let (code, found, table) = scene.table(&args);
    let expected = [
        ("a.xodr", "accepted", false),
        ("b.xodr", "rejected", false),
        ("c.xodr", "failed", false),
        ("d.xodr", "accepted", false),
    ];
    assert_eq!((code, found), (1, rows(&expected)));
    let reason = table["tiles"][2]["reason"].as_str().expect("a reason");
    assert!(reason.contains("opening c.xodr"), "{reason}");
    assert!(scene.at("out/b.report.json").exists() && !scene.at("out/b.mapd").exists());
    // The same as text: a line each, numbers of those that have some.
    let output = scene.run(&[&args[..2], &args[3..]].concat());
    assert_eq!(output.status.code(), Some(4));
    let table = text(&output.stdout);
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines.len(), 5, "{table}");
    assert!(lines[0].starts_with("tile") && lines[1].contains("accepted, up to date"), "{table}");
    assert!(
        lines[2].contains("rejected") && lines[4].starts_with("3 tiles: 2 accepted"),
        "{table}"
    );
    let told = text(&output.stderr);
    assert!(told.contains("b.xodr:2:22: error") && !told.contains("memory"), "{told}");
}

#[test]
fn what_is_up_to_date_is_left_alone() {
    let scene = Scene::new(&[
        ("maps/a.xodr", "one_road"),
        (
            "maps/b.xodr",
            "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/><include file=\"part.xml\"/></OpenDRIVE>",
        ),
        ("maps/part.xml", "<OpenDRIVE/>"),
    ]);
    let args = ["maps", "--output-dir", "out"];
    let check = |more: &[&str], expected: [bool; 2], why: &str| {
        let (code, found, table) = scene.table(&[&args, more].concat());
        assert_eq!(code, 0, "{table}");
        let expected = [("maps/a.xodr", expected[0]), ("maps/b.xodr", expected[1])];
        let expected = expected.map(|(tile, is)| (tile, "accepted", is));
        assert_eq!(found, rows(&expected), "{why}");
        table
    };
    let first = check(&[], [false; 2], "there is nothing");
    let second = check(&[], [true; 2], "nothing has changed");
    for (a, b) in [(0, "archive"), (1, "archive"), (0, "findings"), (1, "findings")] {
        assert_eq!(first["tiles"][a][b], second["tiles"][a][b], "what is known is told");
    }
    let before = fs::metadata(scene.at("out/a.mapd")).expect("there").modified().expect("a time");
    check(&["--force"], [false; 2], "--force");
    let after = fs::metadata(scene.at("out/a.mapd")).expect("there").modified().expect("a time");
    assert!(after > before);
    check(&["--index-tolerance", "0.25"], [false; 2], "other options");
    check(&[], [false; 2], "other options again");
    scene.put("maps/part.xml", "<OpenDRIVE> </OpenDRIVE>");
    check(&[], [true, false], "an included file has changed");
    scene.put("maps/a.xodr", "town");
    check(&[], [false, true], "a file has changed");
    fs::remove_file(scene.at("out/b.report.json")).expect("removed");
    check(&[], [true, false], "a report is missing");
    scene.put("out/a.report.json", "nonsense");
    check(&[], [false, true], "a report is damaged");
    let mut bytes = scene.bytes("out/a.mapd");
    bytes.pop();
    fs::write(scene.at("out/a.mapd"), &bytes).expect("written");
    check(&[], [false, true], "an archive is too short");
    let report = text(&scene.bytes("out/a.report.json"));
    let key = report.split("\"key\": \"").nth(1).and_then(|rest| rest.split('"').next());
    let other = report.replace(key.expect("a key"), &"0".repeat(32));
    scene.put("out/a.report.json", &other);
    check(&[], [false, true], "another program has made it");
    check(&[], [true; 2], "nothing has changed");
}

#[test]
fn two_inputs_of_one_output_are_refused() {
    let scene = Scene::new(&[
        ("x/a.xodr", "one_road"),
        ("y/a.xodr", "one_road"),
        ("x/b.xodr", "one_road"),
        ("z/b.xodr", "one_road"),
        ("z/b.xodrz", "one_road"),
        ("w/m.xodr", "one_road"),
    ]);
    fs::copy(scene.at("x/a.xodr"), scene.at("x/m.mapd")).expect("copied");
    std::os::unix::fs::symlink(scene.at("x"), scene.at("link")).expect("a link");
    let before = scene.files();
    for args in [
        &["x/a.xodr", "y/a.xodr", "--output-dir", "out"][..],
        &["x", "y", "--output-dir", "out"],
        &["z"],
        &["z/b.xodr", "z/b.xodrz"],
        &["x/a.xodr", "x/m.mapd"],
        &["w/m.xodr", "x/m.mapd", "--output-dir", "x"],
    ] {
        let output = scene.run(args);
        assert_eq!(output.status.code(), Some(2), "{args:?}: {}", text(&output.stderr));
        assert!(text(&output.stderr).contains("writ") && output.stdout.is_empty(), "{args:?}");
    }
    for wrong in [
        &["x", "-o", "a.mapd"][..],
        &["x", "--report", "a.json"],
        &["x/a.xodr", "-o", "a.mapd", "--json"],
        &["x/a.xodr", "-o", "a.mapd", "--jobs", "2"],
        &["x/a.xodr", "--report", "a.json", "--output-dir", "out"],
        &["x", "--jobs", "0"],
        &["x", "--threads", "0"],
        &["x", "--progress-interval", "-1"],
        &[],
    ] {
        assert_eq!(scene.run(wrong).status.code(), Some(2), "{wrong:?}");
    }
    assert_eq!(scene.files(), before, "nothing has been begun");
    // The same file under two names is one.
    let (code, found, _) = scene.table(&["x/a.xodr", "link/a.xodr", "x/../x/a.xodr"]);
    assert_eq!((code, found.len()), (0, 1));
}

/// A pattern of a shell may find one file as well.
#[test]
fn a_single_tile_has_a_table_if_one_is_asked_for() {
    let scene = Scene::new(&[("a.xodr", "one_road")]);
    let (code, found, _) = scene.table(&["a.xodr"]);
    assert_eq!((code, found), (0, rows(&[("a.xodr", "accepted", false)])));
    let text_of = |args: &[&str]| text(&scene.run(args).stdout);
    let jobs = text_of(&["a.xodr", "--jobs", "3"]);
    assert!(jobs.contains("accepted, up to date"), "{jobs}");
    for args in [&["a.xodr"][..], &["a.xodr", "--force"], &["a.xodr", "-o", "a.mapd", "--force"]] {
        let line = text_of(args);
        assert!(line.starts_with("a.mapd: ") && line.lines().count() == 1, "{line}");
    }
}

#[test]
fn a_tile_that_needs_too_much_memory_fails_alone() {
    let scene = Scene::new(&[("a.xodr", "town"), ("b.xodr", "one_road")]);
    let args = ["a.xodr", "b.xodr", "--output-dir", "out", "--max-memory", TOO_LITTLE];
    let (code, found, table) = scene.table(&args);
    let failed = [("a.xodr", "failed", false), ("b.xodr", "failed", false)];
    assert_eq!((code, found), (1, rows(&failed)), "{table}");
    assert!(scene.files().iter().all(|file| !file.starts_with("out")), "{:?}", scene.files());
    let reason = table["tiles"][0]["reason"].as_str().expect("a reason");
    assert!(reason.contains("memory") || reason.contains("threads"), "{reason}");
}

/// A town that needs some megabytes more than the program itself.
fn large_town() -> String {
    mapd_tests::town::town(18, 18)
}

#[test]
fn a_limit_of_memory_is_told_and_leaves_nothing() {
    let scene = Scene::new(&[("large.xodr", &large_town()), ("small.xodr", "one_road")]);
    let compile = |limit: &str| {
        let args = ["large.xodr", "-o", "large.mapd", "--threads", "1", "--max-memory", limit];
        scene.run(&args)
    };
    // Halved until it is too little: how much is needed differs between builds.
    let (mut limit, mut enough) = (1 << 30, None);
    let refused = loop {
        let output = compile(&format!("{limit}"));
        if !output.status.success() {
            break output;
        }
        enough = Some(limit);
        fs::remove_file(scene.at("large.mapd")).expect("written");
        limit /= 2;
    };
    let told = text(&refused.stderr);
    assert_eq!(refused.status.code(), Some(1), "{told}");
    let enough = enough.expect("a gigabyte is enough");
    assert_eq!(scene.files(), ["large.xodr", "small.xodr"], "{told}");
    let size = format!("{} MiB of --max-memory", limit >> 20);
    assert!(told.starts_with("mapd: large.xodr: ") && told.contains(&size), "{told}");
    assert!(told.contains("another ") && told.lines().count() == 1, "{told}");
    // Two jobs have half of it each: what does not fit is compiled again, alone.
    // A half more than what was enough once: how much is needed is not the same each time.
    let memory = (enough + enough / 2).to_string();
    let args = ["large.xodr", "small.xodr", "--jobs", "2", "--threads", "1", "--max-memory"];
    let all = [&args[..], &[memory.as_str()]].concat();
    let (code, found, table) = scene.table(&all);
    let both = [("large.xodr", "accepted", false), ("small.xodr", "accepted", false)];
    assert_eq!((code, found), (0, rows(&both)), "{table}");
    fs::remove_file(scene.at("large.mapd")).expect("written");
    let memory = limit.to_string();
    let (code, found, table) = scene.table(&[&args[..], &[memory.as_str()]].concat());
    let one = [("large.xodr", "failed", false), ("small.xodr", "accepted", true)];
    assert_eq!((code, found), (1, rows(&one)), "{table}");
    let reason = table["tiles"][0]["reason"].as_str().expect("a reason");
    assert!(reason.contains(&size), "{reason}");
}

/// The processes that a process has started.
fn children(process: u32) -> Vec<i32> {
    let tasks = fs::read_dir(format!("/proc/{process}/task")).into_iter().flatten().flatten();
    let of = |task: fs::DirEntry| fs::read_to_string(task.path().join("children"));
    let text: String = tasks.flat_map(of).collect();
    text.split_whitespace().filter_map(|number| number.parse().ok()).collect()
}

/// The compiler of a tile, once it has been started.
fn compiler_of(tile: &str, parent: u32) -> Pid {
    let compiles = |child: &i32| {
        let line = fs::read_to_string(format!("/proc/{child}/cmdline"));
        line.is_ok_and(|line| line.contains(tile))
    };
    let until = Instant::now() + PATIENCE;
    while Instant::now() < until {
        if let Some(child) = children(parent).into_iter().find(compiles) {
            return Pid::from_raw(child);
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    panic!("nobody compiles {tile}");
}

/// Starts compiling a folder of three tiles, of which the second is a pipe that nobody writes to, and waits until its compiler
/// waits for it. That one is returned.
fn wait_for_a_pipe(scene: &Scene) -> (Child, Pid) {
    let pipe = scene.at("maps/b.xodr");
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("runs").success());
    let mut command = Command::new(MAPD);
    command.args(["compile", "maps", "--output-dir", "out", "--jobs", "1", "--json"]);
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).current_dir(scene.folder.path());
    let parent = command.spawn().expect("starts");
    let child = compiler_of("maps/b.xodr", parent.id());
    (parent, child)
}

fn outcomes(output: &Output) -> (Vec<String>, String) {
    let table: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let tiles = table["tiles"].as_array().expect("rows");
    let outcomes = tiles.iter().map(|row| row["outcome"].as_str().expect("text").to_owned());
    (outcomes.collect(), tiles[1]["reason"].as_str().expect("a reason").to_owned())
}

#[test]
fn a_compiler_that_is_killed_takes_its_tile_alone() {
    let scene = Scene::new(&[("maps/a.xodr", "one_road"), ("maps/c.xodr", "one_road")]);
    let (parent, child) = wait_for_a_pipe(&scene);
    kill(child, Signal::SIGKILL).expect("killed");
    let output = parent.wait_with_output().expect("ends");
    let (outcomes, reason) = outcomes(&output);
    assert_eq!(outcomes, ["accepted", "failed", "accepted"]);
    assert!(reason.contains("signal: 9"), "{reason}");
    assert!(text(&output.stderr).starts_with("mapd: maps/b.xodr: "), "{}", text(&output.stderr));
    assert_eq!(output.status.code(), Some(1));
}

#[test]
fn who_is_asked_to_end_does_so_with_a_table() {
    let scene = Scene::new(&[("maps/a.xodr", "one_road"), ("maps/c.xodr", "one_road")]);
    let (parent, child) = wait_for_a_pipe(&scene);
    kill(Pid::from_raw(parent.id().cast_signed()), Signal::SIGTERM).expect("sent");
    let output = parent.wait_with_output().expect("ends");
    let (outcomes, _) = outcomes(&output);
    assert_eq!(outcomes, ["accepted", "failed", "failed"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(kill(child, None).is_err(), "the compiler has ended");
    assert_eq!(scene.files().iter().filter(|file| file.starts_with("out")).count(), 2);
}
