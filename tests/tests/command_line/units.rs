//! The example units of systemd: systemd finds nothing wrong with them, and their command lines do what they say.

use mapd_client::Client;
use mapd_tests::manager::Manager;
use mapd_tests::say;
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use std::process::{Child, Command};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

fn unit(name: &str) -> String {
    let path = mapd_tests::workspace().join("examples/systemd").join(name);
    std::fs::read_to_string(path).expect("read")
}

#[test]
fn systemd_finds_nothing_wrong() {
    if Command::new("systemd-analyze").arg("--version").output().is_err() {
        return say("SKIPPED: there is no systemd-analyze");
    }
    let folder = tempfile::tempdir().expect("a folder");
    let mut verify = Command::new("systemd-analyze");
    verify.arg("verify");
    for name in ["mapd.service", "planner.service"] {
        let path = folder.path().join(name);
        // Programs and users of a vehicle are not there.
        let text = unit(name)
            .replace("/usr/bin/mapd", "/bin/true")
            .replace("/usr/bin/planner", "/bin/true")
            .replace("=vehicle", "=root");
        std::fs::write(&path, text).expect("written");
        verify.arg(path);
    }
    let output = verify.output().expect("runs");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success() && said.is_empty(), "{said}");
}

/// A daemon; killed at the end.
struct Daemon(Child);

impl Drop for Daemon {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// The command of a setting, with what systemd would put into it.
fn command(setting: &str, map: &str, cache: &str) -> String {
    let text = unit("mapd.service");
    let line = text.lines().find_map(|line| line.strip_prefix(setting)?.strip_prefix('='));
    let line = line.unwrap_or_else(|| panic!("no {setting}"));
    let put = [("/usr/bin/mapd", MAPD), ("${MAP}", map), ("${CACHE_DIRECTORY}", cache)];
    put.iter().fold(line.to_owned(), |line, (name, value)| line.replace(name, value))
}

#[test]
fn its_commands_check_the_map_and_are_ready_once_it_answers() {
    let (place, manager) = (TestDomain::new(MAPD), Manager::new());
    let cache = tempfile::tempdir().expect("a folder");
    let cache = cache.path().display().to_string();
    let (map, bad) = (mapd_tests::carried("town.xodr"), format!("{cache}/bad.xodr"));
    std::fs::write(&bad, "<OpenDRIVE>").expect("written");
    let map = map.display().to_string();
    // An archive was refused: there is nothing to check in it that the daemon does not verify.
    let archive = format!("{cache}/town.mapd");
    let compiled = place.command().args(["compile", &map, "-o", &archive]).status();
    assert!(compiled.is_ok_and(|status| status.success()));
    for (file, accepted) in [(&map, true), (&bad, false), (&archive, true)] {
        let line = command("ExecStartPre", file, &cache).replace("$$", "$");
        let mut check = place.command_of("sh");
        let output = check.args(["-c", &line]).env("MAP", file).output().expect("runs");
        assert_eq!(output.status.success(), accepted, "{line}");
    }
    let line = format!("exec {}", command("ExecStart", &map, &cache));
    let mut start = place.command_of("sh");
    let _daemon = Daemon(manager.listen_to(start.args(["-c", &line])).spawn().expect("starts"));
    manager.expect("READY=1");
    Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    manager.expect("WATCHDOG=1");
}
