//! Generations that readers hold after others have taken their place: who runs the daemon sees them, with their memory, until they are let go.

use mapd::serve::{PublishMeta, ServeError, Server};
use mapd_client::{Attach, Client};
use mapd_tests::test_domain::{PATIENCE, TestDomain, until};
use mapd_tests::two_maps::TwoMaps;
use std::time::{Duration, Instant};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

fn held(place: &TestDomain) -> Vec<(u64, u64)> {
    place.state("map").held.iter().map(|held| (held.generation, held.bytes)).collect()
}

/// In `mapd status`, by both kinds of readers, and not any more once it was let go.
#[test]
fn what_is_held_is_told() {
    for attach in [Attach::Observer, Attach::Subscriber] {
        let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
        let _daemon = place.serve(&[maps.path().to_str().expect("text")]);
        let client =
            Client::connect_as(attach, &place.domain(), "map", PATIENCE).expect("attaches");
        let first = client.snapshot();
        assert_eq!(held(&place), [], "{attach:?}");
        maps.put(1);
        place.reload("map");
        assert!(client.wait_next(PATIENCE).expect("the next").generation() > first.generation());
        // A status waits only for a moment for the latest numbers; then it has those of a moment ago.
        let (generation, bytes) = until("what is held", || match held(&place)[..] {
            [] => None,
            [only] => Some(only),
            ref more => panic!("{attach:?}: {more:?}"),
        });
        assert_eq!(generation, first.generation());
        assert!(bytes >= first.bytes().len() as u64);
        let line = format!("held by readers: generation {generation}, ");
        until(&line, || {
            let said = place.command().arg("status").output().expect("runs").stdout;
            String::from_utf8_lossy(&said).contains(&line).then_some(())
        });
        drop(first);
        // A subscriber unmaps what it has let go when it looks for more.
        let until = Instant::now() + PATIENCE;
        while !held(&place).is_empty() && Instant::now() < until {
            client.refresh().expect("no error");
            std::thread::sleep(Duration::from_millis(5));
        }
        assert_eq!(held(&place), [], "{attach:?}");
    }
}

/// A map that does not fit names what readers hold.
#[test]
fn too_little_room_names_what_is_held() {
    let place = TestDomain::new(MAPD);
    let rows = mapd_archive::Rows::default();
    let bytes = mapd_archive::encode(&rows, &mapd_archive::Provenance::default()).expect("encodes");
    let mut server = Server::start(&place.domain()).expect("starts");
    let publish = |server: &mut Server, length: usize| {
        server.publish("m", length, |loan| {
            loan.copy_from_slice(&bytes);
            let content_hash = mapd_archive::open(loan)?.header.content_hash;
            Ok(PublishMeta { layout_id: [0; 32], content_hash, input_hash: [0; 32] })
        })
    };
    let first = publish(&mut server, bytes.len()).expect("publishes");
    let client = Client::connect_in(&place.domain(), "m", PATIENCE).expect("attaches");
    publish(&mut server, bytes.len()).expect("publishes");
    let refused = publish(&mut server, 1 << 50).expect_err("no machine has so much");
    assert!(matches!(refused, ServeError::NotEnoughMemory { .. }), "{refused}");
    assert!(
        refused.to_string().contains(&format!("readers still hold generation {first} of map m")),
        "{refused}"
    );
    drop(client);
    // A child that another test forks has the mapping for a moment.
    until("an error without readers", || {
        let refused = publish(&mut server, 1 << 50).expect_err("no machine has so much");
        (!refused.to_string().contains("hold")).then_some(())
    });
}

/// A core dump of a planner does not hold the map.
#[test]
fn core_dumps_leave_the_map_out() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let _daemon = place.serve(&[maps.path().to_str().expect("text")]);
    for attach in [Attach::Observer, Attach::Subscriber] {
        let client =
            Client::connect_as(attach, &place.domain(), "map", PATIENCE).expect("attaches");
        let address = client.snapshot().bytes().as_ptr().addr();
        let maps = std::fs::read_to_string("/proc/self/smaps").expect("readable");
        let mut lines = maps.lines().skip_while(|line| {
            let range = line.split_whitespace().next().and_then(|range| range.split_once('-'));
            let number = |text| usize::from_str_radix(text, 16).ok();
            !range
                .and_then(|(from, to)| Some((number(from)?..number(to)?).contains(&address)))
                .unwrap_or(false)
        });
        let flags = lines.find(|line| line.starts_with("VmFlags:")).expect("flags");
        assert!(flags.split_whitespace().any(|flag| flag == "dd"), "{attach:?}: {flags}");
    }
}
