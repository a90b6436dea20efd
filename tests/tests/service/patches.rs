//! What changes geometry is a patch: compiled with the map and swapped in as a generation.

use mapd_client::route::{PositionOnLane, RouteScratch, ShortestLength};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Attach, Client, Snapshot};
use mapd_tests::test_domain::{Daemon, PATIENCE, TestDomain};
use mapd_tests::town::town;
use std::fs;
use std::time::UNIX_EPOCH;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// The text of a road.
fn road_of<'a>(text: &'a str, id: &str) -> &'a str {
    let own = format!(" id=\"{id}\"");
    let mut roads =
        text.split_inclusive("</road>").filter_map(|one| Some(&one[one.find("<road ")?..]));
    roads.find(|road| road[..road.find('>').expect("an end")].contains(&own)).expect("the road")
}

/// A town that is served with a patch, which is empty at first.
struct Patched {
    place: TestDomain,
    daemon: Option<Daemon>,
    folder: tempfile::TempDir,
    text: String,
}

impl Patched {
    fn new(text: String) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("town.xodr"), &text).expect("written");
        let mut patched = Self { place: TestDomain::new(MAPD), daemon: None, folder, text };
        patched.write("");
        let [map, patch] = ["town.xodr", "patch.xodr"].map(|name| patched.path(name));
        patched.daemon = Some(patched.place.serve(&[&map, "--patch", &patch]));
        patched
    }

    fn path(&self, name: &str) -> String {
        self.folder.path().join(name).display().to_string()
    }

    /// Writes the patch: these roads.
    fn write(&self, roads: &str) {
        let text = format!("<OpenDRIVE>{roads}</OpenDRIVE>");
        fs::write(self.folder.path().join("patch.xodr"), text).expect("written");
    }

    /// Has the map served with a patch of these roads, as an operator does.
    fn reload(&self, roads: &str) {
        self.write(roads);
        let output = self.place.command().args(["reload", "town"]).output().expect("ends");
        assert!(output.status.success(), "{output:?}");
    }

    fn served(&self) -> Snapshot {
        let client = Client::connect_as(Attach::Observer, &self.place.domain(), "town", PATIENCE);
        client.expect("attaches").snapshot()
    }

    /// `mapd overlay town …`, which must end with this code; what it says.
    fn overlay(&self, args: &[&str], code: i32) -> String {
        let output = self.place.command().args(["overlay", "town"]).args(args).output();
        let output = output.expect("ends");
        let said = String::from_utf8_lossy(&output.stdout).into_owned()
            + &String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{args:?}: {said}");
        said
    }
}

/// Entries hold on a map that is patched: on roads that the patch changes, on roads that only it has, and on those of the map again once it is taken back.
#[test]
fn an_overlay_lies_over_a_patched_map() {
    let patched = Patched::new(town(3, 3));
    let entries = patched.path("entries.json");
    let write = |roads: &[&str]| {
        let entry = |road: &&str| {
            format!(
                r#"{{"id":"{road}","kind":"closed","lanes":[{{"road":"{road}","s":[10,20],"lane":-1}}]}}"#
            )
        };
        let all: Vec<String> = roads.iter().map(entry).collect();
        fs::write(&entries, format!(r#"{{"entries":[{}]}}"#, all.join(","))).expect("written");
    };
    let closed = || {
        let snapshot = patched.served();
        let view = snapshot.view(UNIX_EPOCH);
        let closed = |id: &str| {
            let road = snapshot.map().road_by_id(id)?;
            let lane = road.section(0).and_then(|section| section.lane(-1)).expect("a lane");
            let answer = view.allows(lane.lane_id(), 15.0, VehicleClass::PassengerCar);
            let entry = answer.expect("an answer").restriction?.entry.id();
            Some((entry.to_owned(), lane.width_at(15.0)))
        };
        ["1", "new"].map(closed)
    };
    let on = |road: &str, width: f64| Some((road.to_owned(), width));
    write(&["1", "new"]);
    assert!(patched.overlay(&["apply", &entries], 2).contains("the map has no road \"new\""));
    write(&["1"]);
    patched.overlay(&["apply", &entries], 0);
    assert_eq!(closed(), [on("1", 3.5), None]);

    // Road 1 becomes wider, and there is a road of its own far away.
    let wider = road_of(&patched.text, "1").replace("a=\"3.5\"", "a=\"4.5\"");
    let apart = wider.replacen(" id=\"1\"", " id=\"new\"", 1).replace("y=\"0\"", "y=\"-500\"");
    let (from, to) = (apart.find("<link>").expect("links"), apart.find("</link>").expect("an end"));
    let apart = [&apart[..from], &apart[to + "</link>".len()..]].concat();
    patched.reload(&[&wider[..], &apart].concat());
    assert_eq!(closed(), [on("1", 4.5), None]);
    write(&["new"]);
    patched.overlay(&["apply", &entries], 0);
    assert_eq!(closed(), [on("1", 4.5), on("new", 4.5)]);

    // Taken back, and there again.
    patched.reload("");
    assert_eq!(closed(), [on("1", 3.5), None]);
    let list = patched.overlay(&["list"], 0);
    let unplaced = |line: &&str| line.starts_with("unplaced") && line.contains("no road \"new\"");
    assert_eq!(list.lines().filter(unplaced).count(), 1, "{list}");
    patched.reload(&apart);
    assert_eq!(closed(), [on("1", 3.5), on("new", 4.5)]);
}

/// A lane that is driven the other way is a patch of one road.
#[test]
fn a_lane_is_reversed_by_a_patch() {
    let text = town(3, 3).replacen("revMinor=\"7\"", "revMinor=\"8\"", 1);
    let patched = Patched::new(text);
    // Whether lane −1 of road 1 is driven towards its end, and whether cars come from its begin to its end and back on it.
    let driven = || {
        let snapshot = patched.served();
        let map = snapshot.map();
        let road = map.road_by_id("1").expect("a road");
        let lane = road.section(0).and_then(|section| section.lane(-1)).expect("a lane");
        let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
        let mut comes = |from: f64, to: f64| {
            let [from, to] = [from, to].map(|s| PositionOnLane { lane: lane.lane_id(), s });
            let (cost, car) = (ShortestLength::default(), VehicleClass::PassengerCar);
            let route = map.route(from, to, car, &cost, &mut scratch, &mut steps);
            route.expect("an answer").is_some_and(|route| (route.length - 60.0).abs() < 1e-6)
        };
        (lane.is_forward(), comes(5.0, 65.0), comes(65.0, 5.0))
    };
    assert_eq!(driven(), (true, true, false));
    let lane = r#"<lane id="-1" type="driving""#;
    let road = road_of(&patched.text, "1");
    assert!(road.contains(lane));
    patched.reload(&road.replace(lane, &format!("{lane} direction=\"reversed\"")));
    assert_eq!(driven(), (false, false, true));
    patched.reload("");
    assert_eq!(driven(), (true, true, false));
}

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
    let road = road_of(&text, "1");
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
