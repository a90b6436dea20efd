//! `--lock-memory`: what is served is kept from swap, one generation of it, and a limit that is too low is said at once.

use mapd_client::Client;
use mapd_tests::say;
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use std::path::Path;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// A limit that no map keeps \[KiB\].
const LIMIT: u32 = 16;

/// Memory that a process has locked \[KiB\].
fn locked(pid: u32) -> u64 {
    let status = std::fs::read_to_string(format!("/proc/{pid}/status")).expect("a status");
    let line = status.lines().find_map(|line| line.strip_prefix("VmLck:")).expect("a line");
    line.split_whitespace().next().and_then(|kib| kib.parse().ok()).expect("a number")
}

#[test]
fn one_generation_is_locked() {
    let place = TestDomain::new(MAPD);
    let folder = tempfile::tempdir().expect("a folder");
    let map = folder.path().join("town.xodr");
    let put =
        |name: &str| std::fs::copy(mapd_tests::carried(name), &map).map(|_| ()).expect("copied");
    put("town.xodr");
    let daemon = place.serve(&[&map.display().to_string(), "--lock-memory"]);
    let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    let kib = |client: &Client| client.snapshot().bytes().len() as u64 / 1024;
    // Beside the archive: the sample's header and rounding to pages.
    let fits = |locked: u64, archive: u64| (archive..archive + 16).contains(&locked);
    assert!(fits(locked(daemon.id()), kib(&client)), "{} KiB", locked(daemon.id()));
    put("one_road.xodr");
    let before = kib(&client);
    let output = place.command().args(["reload", "town"]).output().expect("runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    client.refresh().expect("the new generation");
    let after = kib(&client);
    assert!(after < before, "another map");
    assert!(fits(locked(daemon.id()), after), "{} KiB of {after}", locked(daemon.id()));
    assert_eq!(daemon.stop(), 0);
}

#[test]
fn a_limit_that_is_too_low_is_said() {
    let place = TestDomain::new(MAPD);
    let town = mapd_tests::carried("town.xodr").display().to_string();
    // Root may lock without limit: as root, without that right.
    let drop = "setpriv --bounding-set -ipc_lock --inh-caps -ipc_lock";
    let root = is_root();
    let wrapper = if root { drop } else { "" };
    if root && !possible(&place, &format!("{drop} true")) {
        return say("SKIPPED: this root may not give up the right to lock memory");
    }
    let script = format!("ulimit -l {LIMIT} && exec {wrapper} {MAPD} --load {town} --lock-memory");
    let output = place.command_of("sh").args(["-c", &script]).output().expect("ends");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("LimitMEMLOCK=") && said.contains(&(LIMIT * 1024).to_string()), "{said}");
    assert!(place.segments().is_empty() && !place.domain().root().exists(), "left behind");
    let script = format!("ulimit -l {LIMIT} && exec {wrapper} {MAPD} doctor");
    let output = place.command_of("sh").args(["-c", &script]).output().expect("ends");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(text.lines().any(|line| line.starts_with("note    locked memory")), "{text}");
}

fn possible(place: &TestDomain, script: &str) -> bool {
    place.command_of("sh").args(["-c", script]).output().is_ok_and(|o| o.status.success())
}

fn is_root() -> bool {
    Path::new("/proc/self").metadata().is_ok_and(|m| std::os::unix::fs::MetadataExt::uid(&m) == 0)
}
