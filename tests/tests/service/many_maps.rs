//! One daemon with many maps: what it does at its start and at its end is done once for all maps, or once for each, and never
//! once for each and all.

use mapd_tests::say;
use mapd_tests::test_domain::TestDomain;
use mapd_tests::tracer::{Side, Then, Traced};
use nix::errno::Errno;
use nix::sys::signal::{Signal, kill};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use syscalls::Sysno;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Maps of the smallest daemon; the next ones have twice and four times as many.
const FEWEST: usize = 8;

/// What doubling the maps added may be more than doubled by this factor: folders that other tests fill meanwhile are read as
/// well. Where all maps are looked at for each, it is 2 in the end, and 1.7 with these numbers.
const TOLERANCE: f64 = 1.2;

/// Shares of the start's system calls after which it is told to end, in percent: while maps are claimed, and while they are
/// filled.
const STOPPED_AT: [usize; 4] = [30, 45, 60, 75];

/// Calls by which a thread waits for others, or for a while: how many depends on the machine's load.
const WAITING: [Sysno; 3] = [Sysno::clock_nanosleep, Sysno::futex, Sysno::sched_yield];

/// System calls of a daemon that serves this many maps, from its start until it waits for clients, and then to its end;
/// those that are compiled come from the cache. `None` where tracing is not permitted.
fn calls(files: &[String]) -> Option<usize> {
    let place = TestDomain::new(MAPD);
    if files.iter().any(|file| file.ends_with(".xodr")) {
        let files: Vec<&str> = files.iter().map(String::as_str).collect();
        assert_eq!(place.serve(&files).stop(), 0);
    }
    let mut command = place.command();
    command.args(files.iter().flat_map(|file| ["--load", file.as_str()]));
    let (traced, _) = match Traced::start(&command, "", Stdio::null()) {
        Err(error) if error.raw_os_error() == Some(Errno::EPERM as i32) => return None,
        started => started.expect("starts"),
    };
    let (pid, mut calls, mut serves) = (traced.pid(), 0, false);
    let ended = traced.run(|moment| {
        calls += usize::from(!WAITING.contains(&moment.name));
        if !serves && moment.thread == 0 && moment.name == Sysno::epoll_wait {
            serves = true;
            kill(pid, Signal::SIGTERM).expect("its own child");
        }
        Then::Continue
    });
    assert_eq!(ended.expect("runs").code(), Some(0), "{} maps", files.len());
    assert!(serves, "{} maps were never served", files.len());
    Some(calls)
}

/// This many files of one map, with names of their own.
fn files(folder: &Path, count: usize, ending: &str) -> Vec<String> {
    let first = folder.join(format!("first.{ending}"));
    let source = mapd_tests::carried("one_road.xodr");
    if ending == "xodr" {
        fs::copy(source, &first).expect("copied");
    } else {
        let done = Command::new(MAPD).arg("compile").arg(source).arg("-o").arg(&first).output();
        assert!(done.expect("runs").status.success());
    }
    let copy = |number| {
        let file = folder.join(format!("map{number}.{ending}"));
        fs::copy(&first, &file).expect("copied");
        file.display().to_string()
    };
    (0..count).map(copy).collect()
}

/// Counts what daemons of such files do.
fn check(ending: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    let files = files(folder.path(), 4 * FEWEST, ending);
    let of = |count: usize| calls(files.get(..count).expect("as many"));
    let (Some(few), Some(twice), Some(most)) = (of(FEWEST), of(2 * FEWEST), of(4 * FEWEST)) else {
        return say("SKIPPED: tracing is not permitted");
    };
    say(&format!(
        "{ending}: system calls of {FEWEST}, twice, four times as many maps: {few}, {twice}, {most}"
    ));
    let growth = (most - twice) as f64 / (2 * (twice - few)) as f64;
    assert!(growth < TOLERANCE, "{few}, {twice}, {most}: the growth grows by {growth:.2}");
}

/// A daemon of these files that is told to end at a call of its first thread, [`WAITING`] not counted: after how many calls it first waits
/// for clients, and what it says, if it ended well. `None` where tracing is not permitted.
fn stopped_at(files: &[String], call: usize) -> Option<(usize, String)> {
    let place = TestDomain::new(MAPD);
    let mut command = place.command();
    command.args(files.iter().flat_map(|file| ["--load", file.as_str()]));
    let (traced, stderr) = match Traced::start(&command, "", Stdio::piped()) {
        Err(error) if error.raw_os_error() == Some(Errno::EPERM as i32) => return None,
        started => started.expect("starts"),
    };
    let mut stderr = stderr.expect("piped");
    let said = std::thread::spawn(move || std::io::read_to_string(&mut stderr).expect("text"));
    let (pid, mut is_told, mut calls, mut waits) = (traced.pid(), false, 0, 0);
    let ended = traced.run(|moment| {
        if moment.thread == 0 {
            let is_counted = moment.side == Side::Before && !WAITING.contains(&moment.name);
            calls += usize::from(is_counted);
            let is_waiting = moment.name == Sysno::epoll_wait;
            if is_waiting && waits == 0 {
                waits = calls;
            }
            if !is_told && (is_waiting || calls >= call) {
                is_told = true;
                kill(pid, Signal::SIGTERM).expect("its own child");
            }
        }
        Then::Continue
    });
    let said = said.join().expect("read");
    assert_eq!(ended.expect("runs").code(), Some(0), "told at call {call}: {said}");
    assert_eq!(place.segments(), Vec::<PathBuf>::new(), "told at call {call}");
    Some((waits, said))
}

/// Of many maps the start takes longer than a service manager waits for the end.
#[test]
fn a_stop_is_obeyed_while_maps_are_claimed_and_filled() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = files(folder.path(), FEWEST, "mapd");
    let Some((start, said)) = stopped_at(&files, usize::MAX) else {
        return say("SKIPPED: tracing is not permitted");
    };
    assert_eq!(said.matches("serving map").count(), FEWEST, "{said}");
    for percent in STOPPED_AT {
        let (waits, said) = stopped_at(&files, start * percent / 100).expect("as before");
        say(&format!("told to end at {percent} % of {start} calls, waits at {waits}: {said}"));
        assert!(waits == 0 && !said.contains("serving"), "{percent} %: {said}");
        assert!(said.contains("stopped"), "{percent} %: {said}");
    }
}

/// The start was once quadratic: 300 maps took a minute, 900 took ten.
#[test]
fn twice_as_many_archives_are_twice_the_work() {
    check("mapd");
}

#[test]
fn twice_as_many_documents_are_twice_the_work() {
    check("xodr");
}
