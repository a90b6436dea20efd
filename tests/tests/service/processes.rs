//! Daemon and clients as processes: any order of starting, crashes, restarts, one name twice.

use mapd_client::{Attach, Client, NearestOptions, glam::DVec2};
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use std::io::Write;
use std::path::Path;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

fn place() -> TestDomain {
    TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"))
}

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

/// The lane of a known point of the town.
fn ask(client: &Client) -> String {
    let snapshot = client.snapshot();
    let map = snapshot.map();
    let hit =
        map.nearest_lane(DVec2::new(50.0, -1.75), &NearestOptions::default()).expect("an answer");
    map.lane(hit.expect("a lane").lane).expect("known").key().to_string()
}

const ANSWER: &str = "1:0:-1";

#[test]
fn daemon_before_client_and_clean_end() {
    let place = place();
    let daemon = place.serve(&[&town()]);
    let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    assert_eq!(ask(&client), ANSWER);
    drop(client);
    assert_eq!(daemon.stop(), 0);
    let left = place.segments();
    // iceoryx2 keeps one counter of a few bytes per prefix.
    assert!(
        left.iter().all(|path| path.metadata().is_ok_and(|m| m.len() < 64)),
        "left behind: {left:?}"
    );
}

#[test]
fn client_before_daemon() {
    let place = place();
    let domain = place.domain();
    let waiting = std::thread::spawn(move || {
        Client::connect_in(&domain, "town", PATIENCE).map(|client| ask(&client))
    });
    std::thread::sleep(Duration::from_millis(200));
    let _daemon = place.serve(&[&town()]);
    assert_eq!(waiting.join().expect("no panic").expect("attaches"), ANSWER);
}

#[test]
fn without_a_daemon_the_deadline_holds_and_the_error_says_what_to_do() {
    let place = place();
    let start = Instant::now();
    let error = Client::connect_in(&place.domain(), "town", Duration::from_millis(300))
        .err()
        .expect("no daemon");
    assert!(start.elapsed() < PATIENCE);
    assert!(error.to_string().contains("mapd --load"), "{error}");
}

#[test]
fn a_map_that_is_not_served_is_named() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let error = Client::connect_in(&place.domain(), "village", Duration::from_millis(300))
        .err()
        .expect("no map");
    assert!(error.to_string().contains("village"), "{error}");
}

#[test]
fn twenty_clients_at_once() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let csv = "x,y\n50,-1.75\n";
    let children: Vec<Child> = (0..20)
        .map(|_| {
            let mut command = place.command();
            let mut child = command
                .args(["query", "shm:town", "nearest"])
                .stdin(Stdio::piped())
                .spawn()
                .expect("starts");
            child.stdin.take().expect("stdin").write_all(csv.as_bytes()).expect("written");
            child
        })
        .collect();
    for child in children {
        let output = child.wait_with_output().expect("ends");
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(
            output.status.success() && text.contains(ANSWER),
            "{text}{}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
}

#[test]
fn a_killed_daemon_leaves_readers_right_and_its_successor_reaches_them() {
    let place = place();
    let daemon = place.serve(&[&town()]);
    let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    let before = client.snapshot();
    daemon.kill();
    before.verify().expect("the archive is whole");
    assert_eq!(ask(&client), ANSWER);
    for asked in [&["reload", "town"][..], &["overlay", "town", "list"]] {
        let output = place.command().args(asked).output().expect("ends");
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(1), "{asked:?}: {errors}");
        assert!(errors.contains("its daemon was killed"), "{asked:?}: {errors}");
        assert!(errors.contains("mapd --load FILE --name town"), "{asked:?}: {errors}");
    }
    let _successor = place.serve(&[&town()]);
    let after = client.wait_next(PATIENCE).expect("the next generation comes");
    assert!(after.generation() > before.generation());
    assert_eq!(after.map().content_hash(), before.map().content_hash());
    before.verify().expect("the old generation is still whole");
    assert_eq!(ask(&client), ANSWER);
}

#[test]
fn a_killed_client_costs_nothing() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    for _ in 0..10 {
        let mut child = place
            .command()
            .args(["query", "shm:town", "nearest"])
            .stdin(Stdio::piped())
            .spawn()
            .expect("starts");
        std::thread::sleep(Duration::from_millis(3));
        child.kill().expect("killed");
        child.wait().expect("waited for");
    }
    let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    assert_eq!(ask(&client), ANSWER);
}

#[test]
fn a_second_daemon_for_one_name_is_refused() {
    let place = place();
    let first = place.serve(&[&town()]);
    let output = place.command().args(["--load", &town()]).output().expect("ends");
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(text.contains(&first.id().to_string()) && text.contains("already"), "{text}");
    let client =
        Client::connect_in(&place.domain(), "town", PATIENCE).expect("the first still serves");
    assert_eq!(ask(&client), ANSWER);
}

#[test]
fn several_maps_in_one_daemon_and_status() {
    let place = place();
    let one_road = mapd_tests::carried("one_road.xodr").display().to_string();
    let mut daemon = place.start(&[&town(), &one_road]);
    daemon.wait_until_serving();
    let subscriber = |map| Client::connect_as(Attach::Subscriber, &place.domain(), map, PATIENCE);
    let _town = subscriber("town").expect("attaches");
    let _road = Client::connect_in(&place.domain(), "one_road", PATIENCE).expect("attaches");
    let output = place.command().args(["status", "--json"]).output().expect("ends");
    let status: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let names: Vec<&str> =
        status.as_array().expect("a list").iter().filter_map(|m| m["name"].as_str()).collect();
    assert_eq!(names, ["one_road", "town"]);
    assert_eq!(status[1]["subscribers"], 1);
    let generation = status[1]["generation"].as_u64();
    assert_eq!(status[1]["state"]["served"]["generation"].as_u64(), generation);
    assert!(generation.is_some_and(|generation| generation > 0));
}

#[test]
fn answers_from_shared_memory_equal_those_from_the_file() {
    let place = place();
    let folder = tempfile::tempdir().expect("a folder");
    let archive = folder.path().join("town.mapd");
    let archive = archive.to_str().expect("text");
    let compiled =
        place.command().args(["compile", &town(), "-o", archive]).output().expect("ends");
    assert!(compiled.status.success());
    let _daemon = place.serve(&[archive]);
    let mut csv = "x,y,z,hdg\n".to_owned();
    for i in 0..500 {
        csv += &format!(
            "{},{},0,{}\n",
            f64::from(i) * 0.41,
            f64::from(i * 7 % 211),
            f64::from(i) * 0.1
        );
    }
    let shared = place.query("shm:town", "nearest", &csv);
    for source in [archive, &town()] {
        let other = place.query(source, "nearest", &csv);
        assert!(other.status.success() && shared.status.success());
        assert!(other.stdout == shared.stdout, "{source} answers differently");
    }
}

#[test]
fn a_rejected_map_leaves_nothing_behind() {
    let place = place();
    let folder = tempfile::tempdir().expect("a folder");
    let bad = folder.path().join("bad.xodr");
    std::fs::write(&bad, "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/><road id=\"1\"")
        .expect("written");
    let output = place
        .command()
        .args(["--load", bad.to_str().expect("text"), &town()])
        .output()
        .expect("ends");
    assert_eq!(output.status.code(), Some(4), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(place.segments().is_empty());
    assert!(!Path::new(place.domain().root()).exists());
}

#[test]
fn threads_share_a_snapshot() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    let snapshot = client.snapshot();
    std::thread::scope(|scope| {
        for thread in 0..4 {
            let snapshot = &snapshot;
            scope.spawn(move || {
                let map = snapshot.map();
                for i in 0..1000 {
                    let point = DVec2::new(f64::from(i % 200), f64::from(thread * 50));
                    map.nearest_lane(point, &NearestOptions::default()).expect("an answer");
                }
            });
        }
    });
}

/// Clients of a killed daemon answer as if it lived, and no command told that it does not.
#[test]
fn status_tells_when_a_daemon_was_last_heard_of() {
    let place = place();
    let daemon = place.serve(&[&town()]);
    let status = |args: &[&str]| {
        let output = place.command().arg("status").args(args).output().expect("ends");
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    let heard = || {
        let status: serde_json::Value = serde_json::from_str(&status(&["--json"])).expect("JSON");
        status[0]["heard_seconds"].as_f64().expect("a time")
    };
    assert!(heard() < PATIENCE.as_secs_f64());
    assert!(!status(&[]).contains("last heard of"));
    daemon.kill();
    let killed = heard();
    let text = status(&[]);
    assert!(text.contains("its daemon was killed, and last heard of"), "{text}");
    assert!(heard() > killed);
}
