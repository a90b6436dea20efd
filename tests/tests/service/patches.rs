//! What changes geometry is a patch: compiled with the map and swapped in as a generation.

use mapd_client::{Attach, Client};
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use mapd_tests::town::town;
use std::fs;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// A daemon reads its patch again at each reload; one that is wrong is told, and what is served stays.
#[test]
fn a_patch_is_swapped_in() {
    let folder = tempfile::tempdir().expect("a folder");
    let [map, patch] = ["town.xodr", "patch.xodr"].map(|name| folder.path().join(name));
    let text = town(3, 3);
    fs::write(&map, &text).expect("written");
    fs::write(&patch, "<OpenDRIVE/>").expect("written");
    let [map, file] = [&map, &patch].map(|path| path.to_str().expect("a name"));
    let domain = TestDomain::new(MAPD);
    let _daemon = domain.serve(&[map, "--patch", file]);
    let client = Client::connect_as(Attach::Observer, &domain.domain(), "town", PATIENCE);
    let client = client.expect("attaches");
    let width = || {
        let snapshot = client.refresh().expect("the newest");
        let road = snapshot.map().road_by_id("1").expect("a road");
        let lane = road.section(0).and_then(|section| section.lane(-1)).expect("a lane");
        (snapshot.generation(), lane.width_at(10.0))
    };
    let (first, plain) = width();
    let from = text.find("<road ").expect("a road");
    let mut at = from;
    while !text[at..at + text[at..].find('>').expect("an end")].contains(" id=\"1\"") {
        at += 1 + text[at + 1..].find("<road ").expect("road 1");
    }
    let road = &text[at..at + text[at..].find("</road>").expect("its end") + "</road>".len()];
    let wider = road.replace(&format!("a=\"{plain}\""), "a=\"4.5\"");
    fs::write(&patch, format!("<OpenDRIVE>{wider}</OpenDRIVE>")).expect("written");
    domain.reload("town");
    assert_eq!(width(), (first + 1, 4.5));
    fs::write(&patch, "<OpenDRIVE>\n<lane/></OpenDRIVE>").expect("written");
    let report = domain.reload("town");
    assert!(report.reason.contains(":2:1: a patch has roads"), "{}", report.reason);
    assert_eq!(width(), (first + 1, 4.5));
    fs::write(&patch, "<OpenDRIVE/>").expect("written");
    domain.reload("town");
    assert_eq!(width().1, plain);
    // The command line: what does not fit is wrong usage, told by its place.
    let output = |more: &[&str]| {
        let archive = folder.path().join("out.mapd");
        let mut command = domain.command();
        command.args(["compile", map, "-o", archive.to_str().expect("a name")]).args(more);
        let output = command.output().expect("ends");
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    assert_eq!(output(&["--patch", file]).0, Some(0));
    let (code, said) = output(&["--remove", "road:none"]);
    assert!(code == Some(2) && said.contains("no road:none to remove"), "{code:?} {said}");
    assert_eq!(output(&["--remove", "lane:1"]).0, Some(2));
    fs::write(&patch, "<OpenDRIVE>").expect("written");
    let (code, said) = output(&["--patch", file]);
    assert!(code == Some(2) && said.contains("patch.xodr:1:12:"), "{code:?} {said}");
}
