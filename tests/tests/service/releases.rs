//! Daemon and client of different ages: a client reads archives with a table more, and with one less, than its release knows.

use mapd::serve::{PublishMeta, Server, StopSignal};
use mapd_archive::AlignedBytes;
use mapd_client::Snapshot;
use mapd_tests::crossroads;
use mapd_tests::maps;
use mapd_tests::releases::{Parts, UNKNOWN_TABLE, answers};
use mapd_tests::test_domain::{PATIENCE, TestDomain};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");
const PROBE: &str = env!("CARGO_BIN_EXE_planner_probe");

/// What the map of a daemon answers to a client that is a process of its own.
fn asked(place: &TestDomain) -> String {
    let wait = PATIENCE.as_millis().to_string();
    let output = place.command_of(PROBE).args(["answers", "map", &wait]).output().expect("runs");
    String::from_utf8(output.stdout).expect("text")
}

/// Archives as releases with other tables write them: one more, one less, both.
fn of_other_releases() -> Vec<(&'static str, AlignedBytes)> {
    let snapshot = maps::open_text(&crossroads::furnished());
    let bytes = snapshot.bytes();
    let infos = snapshot.map().tables().infos();
    let less = infos.iter().find(|info| info.name == "board_groups" && info.count > 0);
    let less = less.expect("a table with rows").number;
    let rows = [7; 24 * 3];
    vec![
        ("the same", Parts::of(bytes).to_archive()),
        ("one more", Parts::of(bytes).with(UNKNOWN_TABLE, 24, &rows).to_archive()),
        ("one less", Parts::of(bytes).without(less).to_archive()),
        ("both", Parts::of(bytes).without(less).with(UNKNOWN_TABLE, 24, &rows).to_archive()),
    ]
}

fn expected(bytes: &AlignedBytes) -> String {
    answers(Snapshot::from_bytes(bytes.clone()).expect("opens").map()).expect("text")
}

/// A daemon of this release serves what other releases have compiled, and warns of what it does not know.
#[test]
fn archives_of_other_releases_are_served() {
    for (name, bytes) in of_other_releases() {
        let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
        let file = folder.path().join("map.mapd");
        std::fs::write(&file, &bytes).expect("written");
        let mut daemon = place.start(&[file.to_str().expect("text")]);
        let said = daemon.wait_for_serving().expect("serves");
        let warned = said.contains("table 60000 with 3 rows of 24 bytes is not known");
        assert_eq!(warned, Parts::of(&bytes).numbers().contains(&UNKNOWN_TABLE), "{name}: {said}");
        assert_eq!(asked(&place), expected(&bytes), "{name}");
        assert_eq!(daemon.stop(), 0, "{name}");
    }
}

/// A daemon of another release publishes what it writes, and says so.
#[test]
fn a_client_reads_what_another_release_publishes() {
    let place = TestDomain::new(MAPD);
    let archives = of_other_releases();
    let mut server = Server::start(&place.domain()).expect("starts");
    for (name, bytes) in &archives {
        let stop = StopSignal::new().expect("a signal");
        let fill = |loan: &mut [u8]| {
            loan.copy_from_slice(bytes);
            let content_hash = mapd_archive::open(loan)?.header.content_hash;
            Ok(PublishMeta { layout_id: [0xab; 32], content_hash, input_hash: [0; 32] })
        };
        server.publish("map", bytes.len(), fill).expect("publishes");
        std::thread::scope(|scope| {
            let asking = scope.spawn(|| {
                let text = asked(&place);
                stop.request();
                text
            });
            server.run(&stop).expect("serves");
            assert_eq!(asking.join().expect("asked"), expected(bytes), "{name}");
        });
    }
}
