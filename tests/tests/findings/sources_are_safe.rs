//! Commands that write never write over what they read, however it is named; what a map says never commands a terminal.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Runs mapd in a folder.
fn run(folder: &Path, args: &[&str]) -> Output {
    Command::new(MAPD).current_dir(folder).args(args).output().expect("ends")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A map of its own in a folder of its own, with other names of it.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let map = folder.path().join("map.xodr");
    fs::copy(mapd_tests::carried("one_road.xodr"), &map).expect("copied");
    std::os::unix::fs::symlink("map.xodr", folder.path().join("link.xodr")).expect("linked");
    fs::hard_link(&map, folder.path().join("hard.xodr")).expect("linked");
    folder
}

#[test]
fn no_command_writes_over_its_source() {
    let folder = folder();
    let map = folder.path().join("map.xodr");
    let before = fs::read(&map).expect("the map");
    let absolute = map.display().to_string();
    let lanelets = ["export", "map.xodr", "--format", "lanelet2", "--origin", "48,11"];
    for args in [
        &["compile", "map.xodr", "-o", "map.xodr"][..],
        &["compile", "map.xodr", "-o", "./map.xodr"],
        &["compile", "map.xodr", "-o", &absolute],
        &["compile", "link.xodr", "-o", "map.xodr"],
        &["compile", "map.xodr", "-o", "hard.xodr"],
        &["compile", "map.xodr", "-o", "out.mapd", "--report", "./map.xodr"],
        &["compile", "map.xodr", "-o", "out.mapd", "--report", "link.xodr"],
        &["export", "map.xodr", "--format", "svg", "-o", "./map.xodr"],
        &[&lanelets[..], &["-o", "out.mapd", "--report", "map.xodr"]].concat(),
        &[&lanelets[..], &["-o", "out.mapd", "--report", "hard.xodr"]].concat(),
        &[&lanelets[..], &["--report", "link.xodr"]].concat(),
        &[&lanelets[..], &["-o", "out.mapd", "--report", "./out.mapd"]].concat(),
    ] {
        let output = run(folder.path(), args);
        assert_eq!(output.status.code(), Some(2), "{args:?}: {}", said(&output));
        assert!(said(&output).contains("overwrite"), "{args:?}: {}", said(&output));
        assert_eq!(fs::read(&map).expect("the map"), before, "{args:?}");
        assert!(!folder.path().join("out.mapd").exists(), "{args:?}");
    }
    let text = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/><include file=\"part.xml\"/></OpenDRIVE>";
    fs::write(folder.path().join("whole.xodr"), text).expect("written");
    fs::rename(&map, folder.path().join("part.xml")).expect("renamed");
    let output = run(folder.path(), &["compile", "whole.xodr", "-o", "part.xml"]);
    assert!(said(&output).contains("the map includes"), "{}", said(&output));
    assert_eq!(fs::read(folder.path().join("part.xml")).expect("the part"), before);
}

#[test]
fn what_a_map_says_never_commands_a_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>\n\
        <road id=\"1\" rule=\"\u{1b}[31mred\u{9b}1m\u{202e}turned\rback\" length=\"x\" junction=\"-1\"/></OpenDRIVE>\r\n";
    fs::write(folder.path().join("map.xodr"), text).expect("written");
    let output = run(folder.path(), &["check", "map.xodr"]);
    let all = [String::from_utf8_lossy(&output.stdout).into_owned(), said(&output)].concat();
    assert!(all.contains("rule=\"·[31mred·1m·turned·back\""), "{all:?}");
    let commands = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
    assert!(!all.contains(commands), "{all:?}");
}
