//! Many reloads under clients that ask without pause.
//!
//! `MAPD_RELOADS=1000 cargo test -p mapd-tests --test service reload_storm::` is the long form.

use mapd::control::ReloadResult;
use mapd_tests::say;
use mapd_tests::test_domain::TestDomain;
use mapd_tests::two_maps::TwoMaps;
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read};
use std::process::Stdio;
use std::time::{Duration, Instant};

/// Clients, each a process.
const CLIENTS: usize = 8;

/// Reloads of the short form, and the variable that asks for more.
const RELOADS: usize = 60;
const VARIABLE: &str = "MAPD_RELOADS";

/// What killed readers and dropped generations hold is given back within some rounds of the daemon.
const SETTLE: Duration = Duration::from_secs(10);

#[test]
fn each_client_sees_generations_rise_and_every_answer_is_one_generations_truth() {
    let reloads = std::env::var(VARIABLE).ok().and_then(|n| n.parse().ok()).unwrap_or(RELOADS);
    let (place, maps) = (TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test")), TwoMaps::new());
    let daemon = place.serve(&[maps.path().to_str().expect("text")]);
    let archives = |place: &TestDomain| {
        let data = |path: &std::path::PathBuf| path.extension().is_some_and(|e| e == "data");
        place.segments().into_iter().filter(data).count()
    };
    assert_eq!(archives(&place), 1);
    let first = place.state("map").served.expect("served").generation;
    let clients: Vec<_> = (0..CLIENTS)
        .map(|_| {
            let mut command = place.command_of(env!("CARGO_BIN_EXE_planner_probe"));
            command.args(["follow", "map"]).arg(maps.truth()).stdin(Stdio::piped());
            let mut child = command.spawn().expect("starts");
            let mut lines = BufReader::new(child.stdout.take().expect("stdout"));
            let mut line = String::new();
            lines.read_line(&mut line).expect("readable");
            assert!(line.starts_with("attached"), "{line}");
            (child, lines)
        })
        .collect();
    let (start, mut last) = (Instant::now(), first);
    for number in 1..=reloads {
        maps.put(number);
        let report = place.reload("map");
        assert_eq!(report.result, ReloadResult::Published, "{}", report.reason);
        assert_eq!(report.generation, Some(last + 1));
        last += 1;
    }
    let taken = start.elapsed();
    let mut asked = 0;
    for (mut child, mut lines) in clients {
        drop(child.stdin.take());
        let mut rest = String::new();
        lines.read_to_string(&mut rest).expect("readable");
        assert!(child.wait().expect("ends").success(), "{rest}");
        let told: BTreeMap<&str, u64> = rest
            .lines()
            .filter_map(|line| line.split_once(' '))
            .filter_map(|(key, value)| Some((key, value.parse().ok()?)))
            .collect();
        assert_eq!(told["last"], last, "{rest}");
        assert_eq!(told["mapped"], 1, "only the newest is mapped: {rest}");
        assert!(told["asked"] > 0 && told["seen"] > 1, "{rest}");
        asked += told["asked"];
    }
    say(&format!("{reloads} reloads in {taken:.1?} under {CLIENTS} clients, {asked} answers"));
    let until = Instant::now() + SETTLE;
    while archives(&place) > 1 && Instant::now() < until {
        std::thread::sleep(Duration::from_millis(50));
    }
    assert_eq!(archives(&place), 1, "memory returns to one archive");
    assert_eq!(daemon.stop(), 0);
    assert!(!place.domain().root().exists());
}
