//! `mapd doctor`: each trouble is named with what to do about it, and a sound domain has none.

use mapd_tests::say;
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use serde_json::Value;
use std::process::{Command, Output};
use std::time::Instant;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

fn place() -> TestDomain {
    TestDomain::new(MAPD)
}

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

fn doctor(place: &TestDomain) -> Output {
    place.command().args(["doctor", "--json", "--wait", "5"]).output().expect("runs")
}

/// State, finding and advice of every line of a check.
fn lines(output: &Output, check: &str) -> Vec<[String; 3]> {
    let report: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let lines = report["findings"].as_array().expect("a list").iter();
    lines
        .filter(|line| line["check"] == check)
        .map(|line| ["state", "found", "advice"].map(|key| text(&line[key])))
        .collect()
}

/// The version of iceoryx2 that the workspace depends on, exactly.
fn iceoryx2() -> String {
    let manifest =
        std::fs::read_to_string(mapd_tests::workspace().join("Cargo.toml")).expect("read");
    let line =
        manifest.lines().find_map(|line| line.strip_prefix("iceoryx2 = \"=")).expect("there");
    line.trim_end_matches('"').to_owned()
}

#[test]
fn another_version_of_iceoryx2() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let file = format!("/dev/shm/{}abc_node.0_9_1.global_mgmt", place.domain().prefix());
    std::fs::write(file, [0; 16]).expect("written");
    expect(&doctor(&place), "versions", "problem", "iceoryx2 0.9.1 is in use");
}

/// A line of this check has this state and these words, and the exit code fits.
fn expect(output: &Output, check: &str, state: &str, words: &str) {
    let lines = lines(output, check);
    let found = lines.iter().any(|[s, found, advice]| {
        s == state
            && format!("{found} {advice}").contains(words)
            && (s == "ok") == advice.is_empty()
    });
    assert!(found, "no line {check}, {state}, {words:?} in {lines:?}");
    if state == "problem" {
        assert_eq!(output.status.code(), Some(1));
    }
}

#[test]
fn nothing_is_wrong_before_and_while_a_map_is_served() {
    let place = place();
    let before = doctor(&place);
    expect(&before, "root folder", "ok", "no daemon has been started");
    expect(&before, "files of dead processes", "ok", "none");
    let daemon = place.serve(&[&town()]);
    let during = doctor(&place);
    for (check, words) in [
        ("root folder", "alone"),
        ("attach lock", "free"),
        ("unfinished files", "none"),
        ("files of dead processes", "in use"),
        ("rights", "others may write nothing"),
        ("versions", &format!("iceoryx2 {},", iceoryx2())),
        ("daemon", &daemon.id().to_string()),
        ("attach", "page faults"),
    ] {
        expect(&during, check, "ok", words);
    }
    let text = place.command().args(["doctor"]).output().expect("runs");
    assert_eq!(text.status.code(), during.status.code());
    let text = String::from_utf8_lossy(&text.stdout).into_owned();
    assert!(text.lines().any(|line| line.starts_with("ok      attach ")), "{text}");
    assert_eq!(daemon.stop(), 0);
}

/// Whatever daemon and clients make: nobody else may read or write it.
#[test]
fn nothing_is_open_to_other_users() {
    use std::os::unix::fs::PermissionsExt;
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let client = mapd_client::Client::connect_in(&place.domain(), "town", PATIENCE);
    let client = client.expect("attaches");
    let waited = client.wait_next(std::time::Duration::from_millis(50));
    assert!(waited.is_err(), "nothing new comes, but the listener is made");
    let mut all = place.segments();
    assert!(all.len() > 5, "{all:?}");
    // What lies below the root folder is behind its own mode.
    all.push(place.domain().root().to_owned());
    for path in all {
        let mode = path.metadata().expect("there").permissions().mode();
        assert_eq!(mode & 0o077, 0, "{} has mode {mode:o}", path.display());
    }
}

#[test]
fn what_a_killed_daemon_leaves() {
    let place = place();
    place.serve(&[&town()]).kill();
    let output = doctor(&place);
    expect(&output, "daemon", "problem", "start it again: mapd --load FILE --name town");
    expect(&output, "files of dead processes", "note", "start a daemon");
    let _successor = place.serve(&[&town()]);
    assert!(lines(&doctor(&place), "daemon").iter().all(|[state, ..]| state == "ok"));
}

#[test]
fn a_daemon_that_is_stopped() {
    let place = place();
    let daemon = place.serve(&[&town()]);
    // A stopped daemon seldom holds the lock: the test holds it in its place.
    let lock = mapd_transport::AttachLock::open(&place.domain()).expect("a lock");
    let guard = lock.exclusive(Instant::now() + PATIENCE).expect("locks").expect("in time");
    let mut command = place.command();
    let output = command.args(["doctor", "--json", "--wait", "0.1"]).output().expect("runs");
    expect(&output, "attach lock", "problem", "kill -CONT");
    expect(&output, "subscribe", "problem", "stayed locked");
    drop(guard);
    // Status and doctor showed one as if nothing were wrong.
    daemon.signal("STOP");
    let output = command.output().expect("runs");
    expect(&output, "daemon", "problem", "does not answer");
    let output = place.command().arg("status").output().expect("runs");
    let said = String::from_utf8_lossy(&output.stdout);
    daemon.signal("CONT");
    assert!(said.contains("its daemon does not answer"), "{said}");
    assert_eq!(daemon.stop(), 0);
}

#[test]
fn an_unfinished_file_beside_a_daemon_that_cannot_remove_it() {
    let place = place();
    let daemon = place.serve(&[&town()]);
    daemon.pause(&place);
    let file = format!("/dev/shm/{}half_made.dynamic", place.domain().prefix());
    std::fs::write(&file, "").expect("written");
    let output = doctor(&place);
    expect(&output, "unfinished files", "problem", "half_made");
    daemon.signal("CONT");
    let until = Instant::now() + PATIENCE;
    while std::path::Path::new(&file).exists() {
        assert!(Instant::now() < until, "the daemon does not remove it");
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
}

#[test]
fn rights_that_are_too_wide() {
    use std::os::unix::fs::PermissionsExt;
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let open = |path: &std::path::Path, mode| {
        std::fs::set_permissions(path, std::fs::Permissions::from_mode(mode)).expect("changed");
    };
    open(place.domain().root(), 0o755);
    let data =
        place.segments().into_iter().find(|path| path.extension().is_some_and(|e| e == "data"));
    open(&data.expect("a data segment"), 0o666);
    let output = doctor(&place);
    expect(&output, "root folder", "problem", "chmod 700");
    expect(&output, "rights", "problem", "is open to other users");
}

/// "ok files of dead processes", "ok rights", and then "maps: Permission denied", with the advice to see a line that was ok.
#[test]
fn a_domain_that_a_stranger_may_not_enter() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let Some(mut command) = mapd_tests::other_user::command(&place, "", MAPD) else { return };
    let owner = place.domain().owner().to_string();
    let output = command.args(["doctor", "--json", "--owner", &owner]).output().expect("runs");
    expect(&output, "root folder", "problem", "Permission denied");
    expect(&output, "root folder", "problem", "--share group:NAME");
    for check in ["attach lock", "unfinished files", "files of dead processes", "rights", "maps"] {
        assert!(lines(&output, check).is_empty(), "{check}: {output:?}");
    }
}

/// The program with limits, by the shell's `ulimit`.
fn limited(place: &TestDomain, limit: &str, archive: &str) -> Output {
    let script = format!("ulimit {limit} && exec {MAPD} doctor --json {archive}");
    place.command_of("sh").args(["-c", &script]).output().expect("runs")
}

#[test]
fn limits_of_the_process() {
    let place = place();
    expect(&limited(&place, "-v 2000000", ""), "address space", "problem", "LimitAS=");
    expect(&limited(&place, "-f 100", ""), "file size", "problem", "SIGXFSZ");
    expect(&limited(&place, "-n 64", ""), "open files", "note", "LimitNOFILE=");
}

/// Nothing of it was read but its length: all of these were fine.
#[test]
fn an_archive_is_proved() {
    let place = place();
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let compile = place.command().args(["compile", &town(), "-o"]).arg(at("town.mapd")).output();
    assert_eq!(compile.expect("runs").status.code(), Some(0));
    let whole = std::fs::read(at("town.mapd")).expect("read");
    let mut altered = whole.clone();
    altered[whole.len() / 2] ^= 1;
    let written = [
        ("cut.mapd", &whole[..1000]),
        ("altered.mapd", &altered),
        ("points.mapd", b"x,y\n1,2\n"),
        ("empty.mapd", b""),
    ];
    for (name, bytes) in written {
        std::fs::write(at(name), bytes).expect("written");
    }
    for (file, state, words) in [
        (at("town.mapd"), "ok", "every byte verified"),
        (at("cut.mapd"), "problem", "the archive is cut off"),
        (at("altered.mapd"), "problem", "copy the archive again"),
        (at("points.mapd"), "problem", "mapd compile FILE.xodr"),
        (at("empty.mapd"), "problem", "empty.mapd: "),
        (town().into(), "problem", "not a mapd archive"),
        (folder.path().to_owned(), "problem", "name a file"),
        (at("none.mapd"), "problem", "No such file"),
    ] {
        let output = place.command().args(["doctor", "--json"]).arg(&file).output().expect("runs");
        expect(&output, "archive", state, words);
        let lines = lines(&output, "archive");
        assert_eq!(lines.len(), 1, "{lines:?}");
        assert!(lines[0][1].contains(&file.display().to_string()), "{lines:?}");
    }
    assert!(lines(&doctor(&place), "archive").is_empty());
}

#[test]
fn an_archive_that_does_not_fit() {
    let place = place();
    let file = tempfile::NamedTempFile::new().expect("a file");
    file.as_file().set_len(1 << 43).expect("a sparse file");
    let archive = file.path().display().to_string();
    let output = place.command().args(["doctor", "--json", &archive]).output().expect("runs");
    expect(&output, "shared memory", "problem", "--shm-size");
    expect(&output, "machine memory", "problem", "free some");
}

#[test]
fn a_containers_default() {
    let place = place();
    let mount = "mount -t tmpfs -o size=64m none /dev/shm";
    let script = format!("{mount} && {MAPD} doctor --json");
    let allowed = Command::new("unshare").args(["--mount", "sh", "-c", mount]).output();
    if !allowed.is_ok_and(|output| output.status.success()) {
        say("SKIPPED: this user may not mount a small /dev/shm of its own");
        return;
    }
    let output = place.command_of("unshare").args(["--mount", "sh", "-c", &script]).output();
    expect(&output.expect("runs"), "shared memory", "note", "a container's default");
}

#[test]
fn configurations_are_read_as_the_daemon_reads_them() {
    let place = place();
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("mapd.toml");
    let town = town();
    let packaged = mapd_tests::workspace().join("src/mapd/package/mapd.toml");
    let packaged = std::fs::read_to_string(packaged).expect("read");
    // Of this machine, so that there is such a group and such a file.
    let packaged = packaged
        .replace("group:mapd", "group:root")
        .replace("/usr/share/mapd/maps/town.xodr", &town);
    let service = std::fs::read_to_string(mapd_tests::workspace().join("docs/service.md"));
    let service = service.expect("read");
    let (_, example) = service.split_once("```toml\n").expect("an example of all keys");
    let (example, _) = example.split_once("```").expect("an end");
    let map = format!("[[map]]\nfile = {town:?}\n");
    let twice = map.repeat(2);
    let options = format!("{map}options.ontology = [\"no_such.toml\"]\n");
    for (text, check, state, words) in [
        (example, "configuration", "ok", "2 map(s)"),
        (packaged.as_str(), "configuration", "ok", "1 map(s)"),
        (packaged.as_str(), "configured map", "ok", town.as_str()),
        ("", "configuration", "note", "no maps"),
        ("watsch = true", "configuration", "problem", "line 1, column 1"),
        ("watsch = true", "configuration", "problem", "did you mean \"watch\"?"),
        (twice.as_str(), "configured map", "problem", "two maps would be named town"),
        (options.as_str(), "configured map", "problem", "no_such.toml"),
        ("[[map]]\nfile = \"none.xodr\"", "configured map", "problem", "No such file"),
    ] {
        std::fs::write(&file, text).expect("written");
        let mut command = place.command();
        let command = command.args(["doctor", "--json", "--config"]).arg(&file);
        expect(&command.output().expect("runs"), check, state, words);
    }
}

/// Columns of `mapd status` stand below each other, however long a map's name is.
#[test]
fn status_is_aligned_and_rounded() {
    let place = place();
    let folder = tempfile::tempdir().expect("a folder");
    let long = folder.path().join("a_map_with_a_name_of_some_length.xodr");
    std::fs::copy(town(), &long).expect("copied");
    let _daemon = place.serve(&[&town(), &long.display().to_string()]);
    let output = place.command().arg("status").output().expect("runs");
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    let starts: Vec<_> = table.lines().map(|line| line.find(" kB ")).collect();
    assert!(starts.len() == 3 && starts[1].is_some() && starts[1] == starts[2], "{table}");
}

#[test]
fn health_is_an_exit_code() {
    let place = place();
    let code = || {
        let mut command = place.command();
        command.args(["status", "--healthy"]).output().expect("runs").status.code()
    };
    assert_eq!(code(), Some(1), "nothing is served");
    let daemon = place.serve(&[&town()]);
    assert_eq!(code(), Some(0));
    drop(daemon);
    assert_eq!(code(), Some(1), "the daemon has gone");
}
