//! What attaching does to the process that attaches: nothing but what it says. And deadlines hold, whatever the daemon does.

use mapd_tests::test_domain::{PATIENCE, TestDomain};
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};
use std::process::Stdio;
use std::time::Duration;

const PROBE: &str = env!("CARGO_BIN_EXE_planner_probe");

/// Deadline that is given to calls which cannot succeed.
const DEADLINE: Duration = Duration::from_millis(300);

fn place() -> TestDomain {
    TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"))
}

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

fn report(stdout: &[u8]) -> BTreeMap<String, String> {
    let text = String::from_utf8_lossy(stdout);
    let pair = |line: &str| line.split_once(' ').map(|(k, v)| (k.to_owned(), v.to_owned()));
    text.lines().filter_map(pair).collect()
}

#[test]
fn attaching_leaves_signals_threads_and_streams_alone() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let wait = DEADLINE.as_millis().to_string();
    let output =
        place.command_of(PROBE).args(["manners", "town", &wait]).output().expect("the probe runs");
    let report = report(&output.stdout);
    assert!(output.status.success(), "{report:?}");
    for phase in ["attached", "waited", "detached"] {
        for key in ["SigCgt", "SigIgn", "SigBlk", "Threads"] {
            let (before, after) =
                (&report[&format!("start.{key}")], &report[&format!("{phase}.{key}")]);
            assert_eq!(before, after, "{key} changed: {phase}");
        }
    }
    assert_eq!(report["start.Threads"], "1");
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    // Four reports of four lines and the outcome of the wait: nobody else has printed.
    assert_eq!(String::from_utf8_lossy(&output.stdout).lines().count(), 17);
}

/// iceoryx2 would read such a file from the working or home folder if it were asked for its global configuration.
#[test]
fn configuration_in_the_working_directory_is_not_read() {
    let place = place();
    let folder = tempfile::tempdir().expect("a folder");
    let bad = "[global]\nprefix = \"elsewhere_\"\nroot-path = \"/nonexistent\"\nnonsense = 1\n";
    for path in ["config/iceoryx2.toml", "iceoryx2/iceoryx2.toml", ".config/iceoryx2/iceoryx2.toml"]
    {
        let path = folder.path().join(path);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("made");
        std::fs::write(path, bad).expect("written");
    }
    let _daemon = place.serve(&[&town()]);
    let output = place
        .command_of(PROBE)
        .args(["connect", "town", "10000"])
        .current_dir(folder.path())
        .env("HOME", folder.path())
        .env("XDG_CONFIG_HOME", folder.path())
        .output()
        .expect("the probe runs");
    let report = report(&output.stdout);
    assert!(output.status.success(), "{report:?}");
    assert!(report["generation"].parse::<u64>().is_ok(), "{report:?}");
}

/// What has become of the daemon when the client asks.
#[derive(Clone, Copy, Debug)]
enum Daemon {
    Absent,
    Killed,
    Stopped,
}

#[test]
fn connecting_keeps_its_deadline() {
    for state in [Daemon::Absent, Daemon::Killed, Daemon::Stopped] {
        let place = place();
        let mut daemon = match state {
            Daemon::Absent => None,
            _ => Some(place.serve(&[&town()])),
        };
        match state {
            Daemon::Absent => {}
            Daemon::Killed => daemon.take().expect("there").kill(),
            Daemon::Stopped => daemon.as_ref().expect("there").pause(&place),
        }
        let wait = DEADLINE.as_millis().to_string();
        let connect = |how| {
            let mut command = place.command_of(PROBE);
            command.args(["connect", "town", &wait]).env("PROBE_ATTACH", how);
            command.output().expect("runs")
        };
        // What a daemon serves that is stopped, or served before it was killed, is there for observers.
        let observer = connect("observer");
        let is_absent = matches!(state, Daemon::Absent);
        assert_eq!(observer.status.success(), !is_absent, "{state:?}");
        let output = connect("subscriber");
        let report = report(&output.stdout);
        assert!(!output.status.success(), "{state:?}: {report:?}");
        let taken: u128 = report["milliseconds"].parse().expect("a number");
        assert!(taken < PATIENCE.as_millis(), "{state:?}: {taken} ms instead of {wait}");
        let expected = match state {
            Daemon::Absent | Daemon::Killed => "no daemon is running",
            Daemon::Stopped => "no generation newer than 0 came in time; the daemon is running",
        };
        assert!(report["error"].contains(expected), "{state:?}: {report:?}");
    }
}

#[test]
fn waiting_keeps_its_deadline_and_what_is_held() {
    let both = |how| [(how, Daemon::Killed), (how, Daemon::Stopped)];
    for (how, state) in ["observer", "subscriber"].into_iter().flat_map(both) {
        let place = place();
        let daemon = place.serve(&[&town()]);
        let wait = DEADLINE.as_millis().to_string();
        let mut child = place
            .command_of(PROBE)
            .args(["wait", "town", &wait])
            .env("PROBE_ATTACH", how)
            .stdin(Stdio::piped())
            .spawn()
            .expect("runs");
        let mut lines = BufReader::new(child.stdout.take().expect("stdout"));
        let mut line = String::new();
        lines.read_line(&mut line).expect("a line");
        let held = line.trim().strip_prefix("attached ").expect("a generation").to_owned();
        match state {
            Daemon::Stopped => daemon.pause(&place),
            _ => daemon.signal("KILL"),
        }
        child.stdin.take().expect("stdin").write_all(b"\n").expect("told");
        let mut rest = Vec::new();
        std::io::Read::read_to_end(&mut lines, &mut rest).expect("the rest");
        let report = report(&rest);
        assert!(!child.wait().expect("ends").success(), "{state:?}: {report:?}");
        let taken: u128 = report["milliseconds"].parse().expect("a number");
        assert!(taken < PATIENCE.as_millis(), "{state:?}: {taken} ms instead of {wait}");
        assert_eq!(report["held"], held, "{state:?}");
        let expected = format!("no generation newer than {held}");
        assert!(report["error"].contains(&expected), "{state:?}: {report:?}");
    }
}
