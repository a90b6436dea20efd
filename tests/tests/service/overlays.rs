//! What is laid over a served map: readers see it, it outlives the daemon, and comes with each new generation at once.

use ct_codecs::{Base64, Decoder};
use flate2::read::GzDecoder;
use mapd_client::view::OverlayKind;
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Attach, AttachError, Client, ClientError, Snapshot};
use mapd_tests::json_schema::{schema, wrong};
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use mapd_tests::town::town;
use serde_json::Value;
use std::fs;
use std::io::{Read, Write};
use std::path::PathBuf;
use std::process::{Output, Stdio};
use std::time::{Duration, UNIX_EPOCH};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// A place with a town in a file.
pub(super) struct Scene {
    pub(super) place: TestDomain,
    pub(super) folder: tempfile::TempDir,
    pub(super) map: PathBuf,
}

impl Scene {
    pub(super) fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let map = folder.path().join("town.xodr");
        fs::write(&map, town(3, 3)).expect("written");
        Self { place: TestDomain::new(MAPD), folder, map }
    }

    pub(super) fn args(&self) -> [&str; 1] {
        [self.map.to_str().expect("a name")]
    }

    /// `mapd overlay town …` with this on stdin.
    pub(super) fn overlay(&self, args: &[&str], stdin: &str) -> Output {
        let mut command = self.place.command();
        command.args(["overlay", "town"]).args(args).stdin(Stdio::piped());
        let mut child = command.spawn().expect("starts");
        let _ = child.stdin.take().expect("stdin").write_all(stdin.as_bytes());
        child.wait_with_output().expect("ends")
    }

    /// As [`Scene::overlay`], which must end with this code; what it says.
    pub(super) fn ends(&self, args: &[&str], stdin: &str, code: i32) -> String {
        let output = self.overlay(args, stdin);
        let said = String::from_utf8_lossy(&output.stdout).into_owned()
            + &String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{args:?}: {said}");
        said
    }

    pub(super) fn list(&self) -> Value {
        let output = self.overlay(&["list", "--json"], "");
        assert!(output.status.success(), "{output:?}");
        serde_json::from_slice(&output.stdout).expect("JSON")
    }

    pub(super) fn client(&self, attach: Attach) -> Client {
        Client::connect_as(attach, &self.place.domain(), "town", PATIENCE).expect("attaches")
    }
}

/// Closes a lane of road 1.
pub(super) fn closed(id: &str, lane: i32) -> String {
    format!(
        r#"{{"entries":[{{"id":"{id}","kind":"closed","lanes":[{{"road":"1","s":[10,20],"lane":{lane}}}]}}]}}"#
    )
}

/// Two feeds with an entry of one name: the later took the place of the earlier, and lifted its closure when it went.
#[test]
fn a_feed_takes_no_entry_of_another() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    scene.ends(&["apply", "-", "--feed", "county"], &closed("1", -1), 0);
    for args in [&["apply", "-", "--feed", "city"][..], &["apply", "-"]] {
        let said = scene.ends(args, &closed("1", 1), 2);
        assert!(said.contains("\"1\"") && said.contains("the feed \"county\""), "{said}");
    }
    scene.ends(&["apply", "-", "--feed", "city"], r#"{"entries":[]}"#, 0);
    assert_eq!(scene.list()["entries"][0]["lanes"][0]["lane"], -1);
    scene.ends(&["apply", "-", "--feed", "county"], r#"{"entries":[]}"#, 0);
    scene.ends(&["apply", "-", "--feed", "city"], &closed("1", 1), 0);
    assert_eq!(scene.list()["entries"][0]["feed"], "city");
}

/// The entry that closes lane −1 of road 1 at 15 m.
pub(super) fn closes(snapshot: &Snapshot) -> Option<String> {
    let view = snapshot.view(UNIX_EPOCH);
    let road = snapshot.map().road_by_id("1").expect("a road");
    let lane = road.section(0).and_then(|section| section.lane(-1)).expect("a lane").lane_id();
    let answer = view.allows(lane, 15.0, VehicleClass::PassengerCar).expect("an answer");
    answer.restriction.map(|one| {
        assert_eq!(one.entry.kind(), OverlayKind::Closed);
        one.entry.id().to_owned()
    })
}

/// A generation whose overlay is gone is not had; the error says whether a daemon runs. It said always that it had ended.
#[test]
fn an_overlay_is_gone() {
    let scene = Scene::new();
    let daemon = scene.place.serve(&scene.args());
    scene.ends(&["apply", "-"], &closed("works", -1), 0);
    let domain = scene.place.domain();
    let revision = scene.client(Attach::Observer).snapshot().overlay_revision();
    fs::remove_file(mapd_transport::overlay_file(&domain, "town", revision)).expect("removed");
    let alive = || match Client::connect_in(&domain, "town", Duration::ZERO) {
        Err(ClientError::Attach(AttachError::NoGeneration { daemon_alive, .. })) => daemon_alive,
        other => panic!("{:?}", other.map(|client| client.snapshot().generation())),
    };
    assert!(alive());
    daemon.kill();
    assert!(!alive());
}

/// Applied, seen by readers of both kinds, listed, replaced, removed, cleared.
#[test]
fn readers_see_it() {
    let scene = Scene::new();
    let daemon = scene.place.serve(&scene.args());
    let clients = [Attach::Observer, Attach::Subscriber].map(|attach| scene.client(attach));
    let seen = |expected: Option<&str>| {
        for client in &clients {
            let snapshot = client.refresh().expect("the newest");
            assert_eq!(closes(&snapshot).as_deref(), expected, "{:?}", client.attachment());
        }
        assert_eq!(closes(&scene.client(Attach::Observer).snapshot()).as_deref(), expected);
    };
    seen(None);
    let held = clients[0].snapshot();
    scene.ends(&["apply", "-"], &closed("works", -1), 0);
    seen(Some("works"));
    assert_eq!(closes(&held), None, "what is held stays what it was");
    let first = clients[0].snapshot().overlay_revision();
    scene.ends(&["apply", "-"], &closed("works", 1), 0);
    seen(None);
    let file = scene.folder.path().join("overlay.json");
    fs::write(&file, closed("more", -1)).expect("written");
    scene.ends(&["apply", file.to_str().expect("a name")], "", 0);
    seen(Some("more"));
    assert!(clients[0].snapshot().overlay_revision() > first);
    let list = scene.list();
    let ids: Vec<_> =
        list["entries"].as_array().expect("a list").iter().map(|e| &e["id"]).collect();
    assert_eq!(ids, ["works", "more"]);
    assert_eq!(list["entries"][1]["state"], "active");
    assert!(scene.ends(&["show", "more"], "", 0).contains("\"kind\": \"closed\""));
    assert!(scene.ends(&["list"], "", 0).contains("works"));
    scene.ends(&["remove", "more"], "", 0);
    seen(None);
    scene.ends(&["clear"], "", 0);
    assert_eq!(scene.list()["entries"], Value::Array(Vec::new()));
    assert_eq!(clients[0].refresh().expect("the newest").overlay_revision(), 0);
    drop((held, clients));
    assert_eq!(daemon.stop(), 0);
    assert!(!scene.place.domain().root().exists());
}

/// What changes it tells what is laid over the map then, as `list` does.
#[test]
fn changes_are_told_as_json() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    let mut last = 0;
    let changes: [(&[&str], &str, usize); 4] = [
        (&["apply", "-", "--json"], &closed("works", -1), 1),
        (&["apply", "--json", "-"], &closed("more", -1), 2),
        (&["remove", "works", "--json"], "", 1),
        (&["clear", "--json"], "", 0),
    ];
    for (args, stdin, left) in changes {
        let told: Value = serde_json::from_str(&scene.ends(args, stdin, 0)).expect("JSON");
        assert_eq!(told["entries"].as_array().map(Vec::len), Some(left), "{args:?}");
        assert_eq!(told, scene.list(), "{args:?}");
        let revision = told["revision"].as_u64().expect("a number");
        assert!(revision > last, "{args:?}: {told}");
        last = revision;
    }
    scene.ends(&["apply", "-", "--watch", "--json"], "", 2);
}

/// Status and drawings of a live map show it.
#[test]
fn it_is_shown() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    let run = |args: &[&str]| {
        let output = scene.place.command().args(args).output().expect("ends");
        assert!(output.status.success(), "{args:?}: {output:?}");
        String::from_utf8(output.stdout).expect("text")
    };
    let svg = ["export", "shm:town", "--format", "svg"];
    let layer =
        ["export", "shm:town", "--format", "geojson", "--layers", "overlay", "--origin", "48,11"];
    assert!(!run(&svg).contains("class=\"overlay"));
    assert!(!run(&["status"]).contains("overlay:"));
    scene.ends(&["apply", "-"], &closed("a<b", -1), 0);
    assert!(run(&svg).contains("class=\"overlay closed\""));
    assert!(run(&svg).contains("a&lt;b: closed"));
    let features: Value = serde_json::from_str(&run(&layer)).expect("JSON");
    let told = &features["features"][0]["properties"];
    assert_eq!(
        (&told["entry"], &told["s_from_m"], &told["lane"]),
        (&"a<b".into(), &10.0.into(), &(-1).into())
    );
    let revision = scene.list()["revision"].as_u64();
    let said = format!("overlay: revision {}, 1 entries", revision.expect("a number"));
    assert!(run(&["status"]).contains(&said), "{}", run(&["status"]));
    // The page has it as it is served.
    let page = run(&["export", "shm:town", "--format", "html"]);
    let (_, rest) = page.split_once("id=\"overlay\">").expect("its element");
    let packed = rest.split_once("</script>").expect("its end").0;
    let packed = Base64::decode_to_vec(packed, None).expect("base64");
    let mut bytes = Vec::new();
    GzDecoder::new(&packed[..]).read_to_end(&mut bytes).expect("gzip");
    assert!(!bytes.is_empty());
    assert_eq!(bytes, scene.client(Attach::Observer).snapshot().overlay_bytes());
    // A format without a place for it says so.
    let mut lanelets = scene.place.command();
    lanelets.args(["export", "shm:town", "--format", "lanelet2", "--origin", "48,11"]);
    let output = lanelets.output().expect("ends");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.contains("1 entries of the overlay"), "{said}");
}

/// A waiting client is woken by a change, and by nothing else.
#[test]
fn who_waits_is_woken() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    let client = scene.client(Attach::Observer);
    assert!(!client.wait_change(Duration::from_millis(1)).expect("an answer"));
    std::thread::scope(|scope| {
        let waits = scope.spawn(|| client.wait_change(PATIENCE).expect("an answer"));
        scene.ends(&["apply", "-"], &closed("works", -1), 0);
        assert!(waits.join().expect("ends"));
    });
    assert_eq!(closes(&client.snapshot()).as_deref(), Some("works"));
}

/// Routes of the command line heed it, at a moment.
#[test]
fn routes_heed_it() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    let text = closed("works", -1).replace(r#""kind""#, r#""until":"2030-01-01T00:00:00Z","kind""#);
    let route = |more: &[&str]| {
        let mut command = scene.place.command();
        command.args(["query", "shm:town", "route"]).args(more).stdin(Stdio::piped());
        let mut child = command.spawn().expect("starts");
        let row = "from_road,from_s,from_lane,to_road,to_s,to_lane\n1,5,-1,1,25,-1\n";
        child.stdin.take().expect("stdin").write_all(row.as_bytes()).expect("written");
        let output = child.wait_with_output().expect("ends");
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stdout).expect("text").lines().nth(1).expect("a row").to_owned()
    };
    let plain = route(&[]);
    assert_eq!(route(&["--overlay"]), plain);
    scene.ends(&["apply", "-"], &text, 0);
    assert_eq!(route(&[]), plain);
    let moment = |at: &str| route(&["--overlay", "--at", at]);
    assert_ne!(moment("2029-12-31T23:59:59Z"), plain);
    assert_eq!(moment("2030-01-01T00:00:00Z"), plain);
    assert_eq!(moment("1893456000"), plain, "in seconds");
    let query = scene.place.command().args(["query", "town.xodr", "route", "--at", "5"]).output();
    assert_eq!(query.expect("ends").status.code(), Some(2));
}

/// Speeds along a route and at a place are today's: they were the map's. Kinds that heed no overlay refuse the option, which they took in silence.
#[test]
fn speeds_heed_it() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    let slow =
        r#"{"entries":[{"id":"slow","kind":"speed","value":5,"lanes":[{"road":"1","lane":-1}]}]}"#;
    scene.ends(&["apply", "-"], slow, 0);
    let ask = |kind: &str, more: &[&str], rows: &str| {
        let mut command = scene.place.command();
        command.args(["query", "shm:town", kind]).args(more);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("starts");
        // A command that refuses its options reads nothing.
        let _ = child.stdin.take().expect("stdin").write_all(rows.as_bytes());
        child.wait_with_output().expect("ends")
    };
    let way = "from_road,from_s,from_lane,to_road,to_s,to_lane\n1,38,-1,1,60,-1\n";
    let place = "road_id,s,lane_id\n1,38,-1\n";
    for (kind, rows) in [("path", way), ("corridor", way), ("speed", place)] {
        let speeds = |more: &[&str]| {
            let output = ask(kind, more, rows);
            assert!(output.status.success(), "{output:?}");
            let mut table = csv::Reader::from_reader(&*output.stdout);
            let column = table.headers().expect("a head").iter().position(|h| h == "speed");
            let column = column.expect("a column of speeds");
            table.records().map(|row| row.expect("a row")[column].to_owned()).collect::<Vec<_>>()
        };
        let (plain, today) = (speeds(&[]), speeds(&["--overlay"]));
        assert_eq!(plain.len(), today.len());
        assert!(
            !plain.is_empty() && plain.iter().all(|speed| speed.starts_with("13.88")),
            "{kind}: {plain:?}"
        );
        assert!(today.iter().all(|speed| speed == "5.0"), "{kind}: {today:?}");
    }
    let said = ask("speed", &["--overlay"], place);
    assert!(String::from_utf8_lossy(&said.stdout).contains("5.0,overlay"), "{said:?}");
    let refused = ask("nearest", &["--overlay"], "x,y\n1,1\n");
    assert_eq!(refused.status.code(), Some(2), "{refused:?}");
    assert!(String::from_utf8_lossy(&refused.stderr).contains("nearest does not heed --overlay"));
}

/// `query signals` with the option follows no lanes that are closed today and marks what is out of service, and without it the map's.
#[test]
fn signals_heed_it() {
    let scene = Scene::new();
    let light = r#"<signals><signal s="40" t="-4" id="light" dynamic="yes" orientation="+" type="1000001" subtype="-1" country="OpenDRIVE" zOffset="3" height="1" width="0.4"/></signals>"#;
    let text = town(3, 3).replacen("</lanes>", &format!("</lanes>{light}"), 1);
    fs::write(&scene.map, text).expect("written");
    let _daemon = scene.place.serve(&scene.args());
    scene.ends(&["apply", "-"], &closed("works", -1), 0);
    let lights = |more: &[&str]| {
        let mut command = scene.place.command();
        command.args(["query", "shm:town", "signals"]).args(more);
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().expect("starts");
        let rows = b"from,road_id,s,lane_id,distance\nbefore,1,5,-1,60\nbehind,1,25,-1,60\n";
        child.stdin.take().expect("stdin").write_all(rows).expect("written");
        let output = child.wait_with_output().expect("ends");
        assert!(output.status.success(), "{output:?}");
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        let seen = said.lines().filter(|row| row.contains(",light,"));
        // The place, and the entry by which it is out of service.
        let ends = |row: &str| {
            let fields: Vec<_> = row.split(',').collect();
            format!("{} {}", fields[0], fields[fields.len() - 2])
        };
        seen.map(ends).collect::<Vec<_>>()
    };
    // A place from which no signal is seen has no row.
    assert_eq!(lights(&[]), ["before ", "behind "]);
    assert_eq!(lights(&["--overlay"]), ["behind "]);
    let off = r#"{"entries":[{"id":"dark","kind":"signal-off","signals":["light"]}]}"#;
    scene.ends(&["apply", "-"], off, 0);
    assert_eq!(lights(&[]), ["before ", "behind "]);
    assert_eq!(lights(&["--overlay"]), ["behind dark"]);
}

/// Where daemon and client meet may be said behind what is done, too: it was refused there.
#[test]
fn options_stand_before_and_behind_what_is_done() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    scene.ends(&["apply", "-"], &closed("works", -1), 0);
    let domain = scene.place.domain();
    let own = ["--prefix", domain.prefix(), "--wait", "5"];
    for args in [
        [&["overlay"][..], &own, &["town", "list"]].concat(),
        [&["overlay", "town"][..], &own, &["list"]].concat(),
        [&["overlay", "town", "list"][..], &own].concat(),
    ] {
        let mut command = std::process::Command::new(MAPD);
        let output = command.env_remove("MAPD_PREFIX").args(&args).output().expect("ends");
        let said = String::from_utf8_lossy(&output.stdout);
        assert!(output.status.success() && said.contains("works"), "{args:?}: {output:?}");
    }
}

/// Commands say which entries hold at a moment; one that has ended goes at the next change.
#[test]
fn entries_hold_at_moments() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    let times = r#""from":"2030-01-01T00:00:00Z","until":"2031-01-01T00:00:00Z","kind""#;
    scene.ends(&["apply", "-"], &closed("works", -1).replace(r#""kind""#, times), 0);
    for (at, state) in [
        ("2029-12-31T23:59:59Z", "waiting"),
        ("2030-01-01T00:00:00Z", "active"),
        ("1924991999", "active"),
        ("2031-01-01T00:00:00Z", "ended"),
    ] {
        let list = scene.ends(&["list", "--json", "--at", at], "", 0);
        let list: Value = serde_json::from_str(&list).expect("JSON");
        assert_eq!(list["entries"][0]["state"], state, "{at}");
        assert!(scene.ends(&["list", "--at", at], "", 0).starts_with(state), "{at}");
        let shown = scene.ends(&["show", "works", "--at", at], "", 0);
        let shown: Value = serde_json::from_str(&shown).expect("JSON");
        assert_eq!(shown["state"], state, "{at}");
    }
    let past = closed("past", 1).replace(r#""kind""#, r#""until":"2020-01-01T00:00:00Z","kind""#);
    scene.ends(&["apply", "-"], &past, 0);
    assert_eq!(scene.list()["entries"][1]["state"], "ended");
    scene.ends(&["apply", "-"], &closed("more", 1), 0);
    let list = scene.list();
    let ids: Vec<_> =
        list["entries"].as_array().expect("a list").iter().map(|e| &e["id"]).collect();
    assert_eq!(ids, ["works", "more"]);
}

/// It outlives a daemon that ends, and one that is killed, and is there with the first generation of the next.
#[test]
fn it_outlives_the_daemon() {
    let scene = Scene::new();
    let daemon = scene.place.serve(&scene.args());
    scene.ends(&["apply", "-"], &closed("works", -1), 0);
    assert_eq!(daemon.stop(), 0);
    let daemon = scene.place.serve(&scene.args());
    let client = scene.client(Attach::Observer);
    assert_eq!(closes(&client.snapshot()).as_deref(), Some("works"));
    daemon.kill();
    assert_eq!(closes(&client.snapshot()).as_deref(), Some("works"));
    let fresh = scene.client(Attach::Observer);
    assert_eq!(closes(&fresh.snapshot()).as_deref(), Some("works"), "what a killed daemon left");
    let last = scene.place.serve(&scene.args());
    let next = client.wait_next(PATIENCE).expect("the next generation");
    assert_eq!(closes(&next).as_deref(), Some("works"));
    // A file that cannot be read is told, and no closure forgotten in silence.
    let state =
        scene.place.cache().join(format!("{}town.overlay.json", scene.place.domain().prefix()));
    assert_eq!(last.stop(), 0);
    fs::write(&state, "{").expect("written");
    let starts = scene.place.command().arg("--load").args(scene.args()).output().expect("ends");
    let said = String::from_utf8_lossy(&starts.stderr);
    assert_eq!(starts.status.code(), Some(1), "{said}");
    assert!(said.contains(state.to_str().expect("a name")), "{said}");
}

/// What a feed no longer says does not hold any more: by the file's name for WZDx, by `--feed` for others.
#[test]
fn a_feed_applied_again_is_all_that_it_says() {
    let scene = Scene::new();
    let georeference = "+proj=tmerc +lat_0=48 +lon_0=11 +k=1 +x_0=0 +y_0=0 +datum=WGS84";
    let text = town(3, 3).replacen(
        "vendor=\"mapd\"/>",
        &format!(
            "vendor=\"mapd\"><geoReference><![CDATA[{georeference}]]></geoReference></header>"
        ),
        1,
    );
    fs::write(&scene.map, text).expect("written");
    let _daemon = scene.place.serve(&scene.args());
    let ids = || -> Vec<String> {
        let list = scene.list();
        let entries = list["entries"].as_array().expect("a list");
        entries.iter().filter_map(|entry| entry["id"].as_str()).map(str::to_owned).collect()
    };
    scene.ends(&["apply", "-"], &closed("own", -1), 0);
    scene.ends(&["apply", "-", "--feed", "works"], &closed("first", -1), 0);
    scene.ends(&["apply", "-", "--feed", "works"], &closed("second", -1), 0);
    assert_eq!(ids(), ["own", "second"]);

    // A work zone along the lane at the place of `own`, as many kilometres as it takes degrees.
    let zone = |status: &str| {
        let at = |x: f64| [11.0 + x / 74_600.0, 48.0 - 1.75 / 111_200.0];
        let feed_info = serde_json::json!({
            "update_date": "2026-01-01T00:00:00Z", "version": "4.2", "publisher": "mapd tests",
            "data_sources": [{"data_source_id": "test", "organization_name": "mapd tests"}],
        });
        serde_json::json!({"feed_info": feed_info, "type": "FeatureCollection", "features": [{
            "type": "Feature", "id": "zone",
            "properties": {
                "core_details": {
                    "event_type": "work-zone", "data_source_id": "test", "direction": "eastbound", "road_names": ["A"],
                },
                "start_date": "2026-01-01T00:00:00Z", "end_date": "2036-01-01T00:00:00Z",
                "is_start_date_verified": true, "is_end_date_verified": false,
                "is_start_position_verified": true, "is_end_position_verified": true,
                "location_method": "unknown",
                "vehicle_impact": "all-lanes-closed", "event_status": status,
            },
            "geometry": {"type": "LineString", "coordinates": [at(20.0), at(60.0)]},
        }]})
    };
    let feed = scene.folder.path().join("feed.geojson");
    let apply = |status: &str| {
        fs::write(&feed, zone(status).to_string()).expect("written");
        scene.ends(&["apply", feed.to_str().expect("a name")], "", 0)
    };
    let said = apply("active");
    assert_eq!(ids(), ["own", "second", "zone", "zone/closed"], "{said}");
    // A date that cannot be read lifts nothing.
    fs::write(&feed, zone("active").to_string().replace("2036-01-01", "2036-02-31"))
        .expect("written");
    let said = scene.ends(&["apply", feed.to_str().expect("a name")], "", 3);
    assert!(said.contains("features[0].properties.end_date"), "{said}");
    assert_eq!(ids(), ["own", "second", "zone", "zone/closed"], "{said}");
    apply("cancelled");
    assert_eq!(ids(), ["own", "second"]);
    fs::write(&feed, zone("active").to_string().replace("47.9", "47.8")).expect("written");
    let told = scene.ends(&["apply", feed.to_str().expect("a name"), "--json"], "", 0);
    let told: Value = serde_json::from_str(&told).expect("JSON");
    assert_eq!(wrong(&schema("overlay-list"), &told), None, "{told:#}");
    let found = told["findings"][0]["place"].as_str();
    assert!(found.is_some_and(|place| place.starts_with("features[0]")), "{told}");
    let said = scene.ends(&["apply", feed.to_str().expect("a name"), "--tolerance", "500"], "", 2);
    assert!(said.contains("at most 100 m"), "{said}");
}
