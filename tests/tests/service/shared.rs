//! A map that is shared with a group: its members read, and can do no more; nobody else can do anything.

use mapd::control::ReloadResult;
use mapd_client::{AttachError, Client, ClientError, Domain};
use mapd_tests::other_user::{GROUP, command};
use mapd_tests::say;
use mapd_tests::test_domain::{Daemon, PATIENCE, TestDomain};
use mapd_tests::two_maps::TwoMaps;
use std::io::{BufRead, BufReader};
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");
const PROBE: &str = env!("CARGO_BIN_EXE_planner_probe");
const HOSTILE: &str = env!("CARGO_BIN_EXE_hostile_reader");

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

/// A daemon that shares, with a umask that would let everybody write.
fn share(place: &TestDomain, map: &Path, options: &str) -> Daemon {
    let mut shell = place.command_of("sh");
    shell.args(["-c", "umask 0; exec \"$0\" \"$@\"", MAPD, "--load"]).arg(map);
    shell.args(options.split_whitespace());
    let mut daemon = place.spawn(shell);
    daemon.wait_until_serving();
    daemon
}

fn group() -> String {
    format!("--share group:{GROUP}")
}

/// What a probe of another user says.
fn said(command: &mut Command) -> String {
    let output = command.output().expect("runs");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// The user of this process, who owns what it makes.
fn us() -> String {
    std::fs::metadata("/proc/self").expect("a process").uid().to_string()
}

/// Who may attach: members of the group that name the owner, and nobody else.
#[test]
fn members_of_the_group_read() {
    let place = TestDomain::new(MAPD);
    let member = GROUP.to_string();
    let (Some(mut reads), Some(mut other), Some(mut unnamed)) = (
        command(&place, &member, PROBE),
        command(&place, "", PROBE),
        command(&place, &member, PROBE),
    ) else {
        return;
    };
    let daemon = share(&place, Path::new(&town()), &group());
    let own = said(place.command_of(PROBE).args(["answers", "town", "0"]));
    let answers = said(reads.env("MAPD_OWNER", us()).args(["answers", "town", "2000"]));
    assert_eq!(answers, own);
    let refused = said(other.env("MAPD_OWNER", us()).args(["connect", "town", "0"]));
    assert!(refused.contains("may not read"), "{refused}");
    let refused = said(unnamed.args(["connect", "town", "0"]));
    assert!(refused.contains("--owner"), "{refused}");
    // The health check asked the daemon, which members may not.
    if let Some(mut status) = command(&place, &member, MAPD) {
        let output = status.args(["status", "--healthy", "--owner", &us()]).output().expect("runs");
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
    }
    drop(daemon);
}

/// A private daemon after one that shared, and one that shares after a private one.
#[test]
fn what_is_private_stays_so() {
    let place = TestDomain::new(MAPD);
    for (options, folder, record) in [
        ("", 0o700, 0o600),
        (&*group(), 0o750, 0o640),
        ("", 0o700, 0o600),
        ("--share private", 0o700, 0o600),
    ] {
        let daemon = share(&place, Path::new(&town()), options);
        let mode = |path: &Path| path.metadata().expect("there").permissions().mode() & 0o777;
        let root = place.domain().root().to_owned();
        assert_eq!(
            (mode(&root), mode(&root.join("town.published"))),
            (folder, record),
            "{options}"
        );
        let shared = folder == 0o750;
        for path in place.segments() {
            let data = path.extension().is_some_and(|end| end == "data");
            let allowed = if data && shared { 0o440 } else { 0o700 };
            assert_eq!(mode(&path) & !allowed, 0, "{} {:o}", path.display(), mode(&path));
        }
        let doctor = place.command().args(["doctor", "--wait", "2"]).output().expect("runs");
        let told = String::from_utf8_lossy(&doctor.stdout).into_owned();
        assert!(told.contains("others may write nothing"), "{told}");
        // Killed: what it leaves is the next one's.
        daemon.kill();
    }
}

/// The folder stayed open to the group of a daemon that had ended beside a private one, and no other group could be shared with.
#[test]
fn the_folder_is_closed_with_the_last_daemon_that_shares() {
    let place = TestDomain::new(MAPD);
    let root = place.domain().root().to_owned();
    let found = || {
        let folder = root.metadata().expect("there");
        (folder.permissions().mode() & 0o777, folder.gid())
    };
    let town = town();
    let start = |name: &str, group: u32| {
        share(&place, Path::new(&town), &format!("--name {name} --share group:{group}"))
    };
    let private = share(&place, Path::new(&town), "");
    assert_eq!(found().0, 0o700);
    let (first, second) = (start("a", GROUP), start("b", GROUP));
    assert_eq!(found(), (0o750, GROUP));
    let other = format!("group:{}", GROUP + 1);
    let refused = ["--load", &town, "--name", "c", "--share", &other];
    let refused = place.command().args(refused).output().expect("runs");
    let told = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(!refused.status.success() && told.contains("shared with group"), "{told}");
    assert_eq!(first.stop(), 0);
    assert_eq!(found(), (0o750, GROUP), "another shares");
    assert_eq!(second.stop(), 0);
    assert_eq!(found().0, 0o700);
    // One that is killed leaves it open; the next one is not kept from anything.
    start("d", GROUP).kill();
    let third = start("e", GROUP + 1);
    assert_eq!(found(), (0o750, GROUP + 1));
    assert_eq!(third.stop(), 0);
    assert_eq!(found().0, 0o700);
    assert_eq!(private.stop(), 0);
    assert!(!root.exists());
}

/// What a member of the group is told where it may not do something, and what it cannot see.
#[test]
fn a_member_is_told_the_truth() {
    let place = TestDomain::new(MAPD);
    let member = GROUP.to_string();
    if command(&place, &member, MAPD).is_none() {
        return;
    }
    let daemon = share(&place, Path::new(&town()), &group());
    let us = us();
    let run = |args: &[&str]| {
        let mut command = command(&place, &member, MAPD).expect("as before");
        let output = command.args(args).args(["--owner", &us]).output().expect("runs");
        let told =
            [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
        (output.status.code(), told.concat())
    };
    for (args, code, words) in [
        (&["inspect", "shm:town", "--attach", "subscriber"][..], 1, "attach as an observer"),
        (&["reload", "town"], 1, "who runs its daemon, may ask it"),
        (&["status", "--json"], 0, "\"subscribers\": null"),
        (&["bench", "shm:town", "--clients", "2", "--queries", "10", "--routes", "1"], 0, "attach"),
    ] {
        let (found, told) = run(args);
        assert_eq!(found, Some(code), "{args:?}: {told}");
        assert!(told.contains(words), "{args:?}: {told}");
    }
    assert_eq!(daemon.stop(), 0);
}

/// Whatever a member tries: it changes nothing, and generations go on.
#[test]
fn a_hostile_member_holds_and_delays_and_no_more() {
    const ROUNDS: usize = 11;
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let Some(mut hostile) = command(&place, &GROUP.to_string(), HOSTILE) else { return };
    let daemon = share(&place, &maps.path(), &group());
    hostile.env("MAPD_OWNER", us()).arg("map").stdin(Stdio::piped());
    let mut hostile = hostile.spawn().expect("starts");
    let mut lines = BufReader::new(hostile.stdout.take().expect("stdout")).lines();
    let first = lines.next().expect("a line").expect("text");
    assert!(first.starts_with("ready"), "{first}");
    let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
    let mut delays = Vec::new();
    for round in 1..=ROUNDS {
        std::thread::scope(|scope| {
            let waiting = scope.spawn(|| (client.wait_next(PATIENCE), Instant::now()));
            maps.put(round);
            let report = place.reload("map");
            let told = Instant::now();
            assert_eq!(report.result, ReloadResult::Published, "{}", report.reason);
            let (seen, when) = waiting.join().expect("ends");
            assert_eq!(report.generation, Some(seen.expect("in time").generation()));
            delays.push(when.saturating_duration_since(told));
        });
    }
    delays.sort();
    say(&format!(
        "{ROUNDS} generations beside a hostile reader, seen {:.1?} after the reload was reported in the median, {:.1?} at the latest",
        delays[ROUNDS / 2],
        delays[ROUNDS - 1]
    ));
    drop(hostile.stdin.take());
    assert!(hostile.wait().expect("ends").success());
    assert_eq!(daemon.stop(), 0);
}

/// A process that makes the folder first is not taken for the daemon.
#[test]
fn a_squatted_folder_is_refused() {
    let place = TestDomain::new(MAPD);
    let Some(mut squats) = command(&place, "", "/bin/mkdir") else { return };
    assert!(
        squats.args(["-m", "755"]).arg(place.domain().root()).status().is_ok_and(|s| s.success())
    );
    let refused =
        Client::connect_in(&place.domain(), "town", Duration::ZERO).err().expect("refused");
    assert!(
        matches!(refused, ClientError::Attach(AttachError::PermissionDenied { .. })),
        "{refused}"
    );
    let daemon = place.command().args(["--load", &town()]).output().expect("runs");
    let told = String::from_utf8_lossy(&daemon.stderr).into_owned();
    assert!(!daemon.status.success() && told.contains("belongs to user"), "{told}");
}

/// In a user namespace that maps nobody, all files seem to be this process's own.
#[test]
fn an_owner_that_is_not_mapped_is_nobody() {
    let place = TestDomain::new(MAPD);
    let _daemon = place.serve(&[&town()]);
    let mut unmapped = place.command_of("unshare");
    let output = unmapped.args(["--user", PROBE, "connect", "town", "0"]).output();
    match output {
        Ok(output) if output.stderr.is_empty() => {
            let told = String::from_utf8_lossy(&output.stdout).into_owned();
            assert!(told.contains("no id in this user namespace"), "{told}");
        }
        _ => say("SKIPPED: this user may not make a user namespace"),
    }
}

/// A daemon is its own user's, whatever user is named.
#[test]
fn a_daemon_serves_as_itself() {
    let place = TestDomain::new(MAPD);
    let output = place
        .command()
        .env("MAPD_OWNER", "61001")
        .args(["--load", &town()])
        .output()
        .expect("runs");
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!output.status.success() && told.contains("names user 61001"), "{told}");
    assert!(!told.contains("belongs to"), "nothing is there: {told}");
    assert!(!Domain::root(&place.domain()).exists());
}
