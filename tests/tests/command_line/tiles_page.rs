//! What `docs/tiles.md` shows works word for word: the rule for make, the line for GNU parallel, the command of a pod.

use mapd_tests::say;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// The page's block of a language that has this in it.
fn block(language: &str, part: &str) -> String {
    let page = mapd_tests::workspace().join("docs/tiles.md");
    let page = fs::read_to_string(page).expect("the page");
    let fence = format!("```{language}\n");
    let blocks = page.split(&fence).skip(1);
    let mut blocks = blocks.map(|rest| rest.split("```").next().unwrap_or_default().to_owned());
    blocks.find(|block| block.contains(part)).unwrap_or_else(|| panic!("no {language} with {part}"))
}

/// A folder with two tiles in `maps`, one of them in a folder of its own, and mapd in `bin`.
fn scene() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    fs::create_dir_all(at("maps/north")).expect("made");
    fs::create_dir(at("bin")).expect("made");
    fs::copy(mapd_tests::carried("one_road.xodr"), at("maps/a.xodr")).expect("copied");
    fs::copy(mapd_tests::carried("town.xodr"), at("maps/north/b.xodr")).expect("copied");
    std::os::unix::fs::symlink(MAPD, at("bin/mapd")).expect("linked");
    folder
}

/// Runs a program in the folder. `None` if there is none.
fn run(folder: &Path, program: &str, args: &[&str], more: &[(&str, &str)]) -> Option<Output> {
    let path = std::env::var("PATH").unwrap_or_default();
    let path = format!("{}:{path}", folder.join("bin").display());
    let mut command = Command::new(program);
    command.args(args).current_dir(folder).env("PATH", path).envs(more.iter().copied());
    command.output().ok()
}

fn succeeds(output: &Output) {
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{told}");
}

fn check(folder: &Path) {
    for made in ["a.mapd", "a.report.json", "north/b.mapd", "north/b.report.json"] {
        assert!(folder.join("archives").join(made).exists(), "{made} is missing");
    }
}

#[test]
fn the_rule_for_make() {
    let scene = scene();
    fs::write(scene.path().join("Makefile"), block("make", "ARCHIVES")).expect("written");
    let make = || run(scene.path(), "make", &["-j2"], &[]);
    let Some(first) = make() else { return say("SKIPPED: there is no make") };
    succeeds(&first);
    check(scene.path());
    let second = String::from_utf8(make().expect("as before").stdout).expect("text");
    assert!(second.contains("Nothing to be done"), "{second}");
}

#[test]
fn the_command_of_a_pod() {
    let scene = scene();
    let block = block("yaml", "kind: Job");
    let command = block.split("- |\n").nth(1).and_then(|rest| rest.split("resources:").next());
    let root = scene.path().display().to_string();
    let command = command.expect("a command").replace("/maps", &format!("{root}/maps"));
    let command = command.replace("/archives", &format!("{root}/archives"));
    fs::write(scene.path().join("maps/tiles.txt"), "a.xodr\nnorth/b.xodr\nmissing.xodr\n")
        .expect("written");
    let pod = |index: &str| {
        let index = [("JOB_COMPLETION_INDEX", index)];
        run(scene.path(), "sh", &["-c", &command], &index).expect("runs")
    };
    succeeds(&pod("0"));
    succeeds(&pod("1"));
    check(scene.path());
    let again = String::from_utf8(pod("1").stdout).expect("text");
    assert!(again.contains("accepted, up to date"), "{again}");
    assert_eq!(pod("2").status.code(), Some(1));
}

#[test]
fn the_line_for_parallel() {
    let scene = scene();
    // No other machines here, and no file that names them.
    let line = block("sh", "parallel").replace("--sshloginfile machines", "");
    let has_parallel = run(scene.path(), "parallel", &["--version"], &[]);
    if !has_parallel.is_some_and(|output| String::from_utf8_lossy(&output.stdout).contains("GNU")) {
        return say("SKIPPED: there is no GNU parallel");
    }
    succeeds(&run(scene.path(), "sh", &["-c", &line], &[]).expect("runs"));
    check(scene.path());
}
