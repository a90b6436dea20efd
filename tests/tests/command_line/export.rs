//! `mapd export --format svg`: every lane is drawn once, and the drawing is well-formed XML.

use mapd_tests::maps::{carried_and, open};
use std::path::Path;
use std::process::Command;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Draws a map and returns the drawing.
fn draw(map: &Path, arguments: &[&str]) -> String {
    let mut command = Command::new(MAPD);
    command.arg("export").arg(map).args(["--format", "svg"]).args(arguments);
    let output = command.output().expect("runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// Number of elements with this class.
fn count(drawing: &str, class: &str) -> usize {
    drawing.matches(&format!("class=\"{class}")).count()
}

#[test]
fn every_lane_is_drawn_once() {
    for path in carried_and(&["esmini/velodrome", "esmini/soderleden"]) {
        let snapshot = open(&path);
        let lanes = snapshot.map().lanes().filter(|lane| lane.center_line().len() > 1).count();
        let drawing = draw(&path, &[]);
        let places = (count(&drawing, "lane"), count(&drawing, "bound"), count(&drawing, "leaf"));
        assert_eq!(places, (lanes, lanes, 0), "{}", path.display());
        let segments = snapshot.map().tables().index_leaves.iter().flat_map(|leaf| leaf.lane());
        let segments = segments.filter(|lane| **lane != mapd_archive::NONE).count();
        assert_eq!(count(&draw(&path, &["--index-boxes"]), "leaf"), segments, "{}", path.display());
        let mut reader = quick_xml::Reader::from_str(&drawing);
        while reader.read_event().expect("well-formed XML") != quick_xml::events::Event::Eof {}
    }
}

#[test]
fn a_drawing_goes_to_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("town.svg");
    let map = mapd_tests::carried("town.xodr");
    let text = draw(&map, &["-o", file.to_str().expect("a path")]);
    assert!(text.is_empty());
    assert_eq!(std::fs::read_to_string(file).expect("written"), draw(&map, &[]));
}

/// The driven line is drawn from end to end; what is no route is an error that says so.
#[test]
fn a_route_is_drawn_as_its_driven_line() {
    let map = mapd_tests::carried("one_road.xodr");
    let drawing = draw(&map, &["--route", "1,2,-1:1,12,-1"]);
    assert_eq!(count(&drawing, "route\""), 1);
    assert_eq!(count(&draw(&map, &[]), "route\""), 0);
    let line = drawing.lines().find(|line| line.contains("class=\"route\"")).expect("a line");
    assert_eq!(line.matches(',').count(), 21, "a point every half metre: {line}");
    for (route, code, said) in [
        ("1,2,-1", 2, "expected ROAD,S,LANE:ROAD,S,LANE"),
        ("1,2,-1:x,2,-1", 1, "the map has no road"),
        ("1,2,-1:1,2,-9", 1, "has no lane -9"),
        ("1,12,-1:1,2,-1", 1, "no way"),
    ] {
        let mut command = Command::new(MAPD);
        let output = command.arg("export").arg(&map).args(["--format", "svg", "--route", route]);
        let output = output.output().expect("runs");
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(code), "{route}: {text}");
        assert!(text.contains(said), "{route}: {text}");
    }
}
