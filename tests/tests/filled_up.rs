//! Shared memory that somebody fills up at a system call of a daemon, whichever it is: a clear error or success, never a
//! signal, and nothing is left behind.

use mapd_tests::say;
use mapd_tests::small::{Filler, in_small_shared_memory};
use mapd_tests::stage::Stage;
use mapd_tests::tracer::{Moment, Side, Then, Traced};
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::io::Read;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use syscalls::Sysno;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Room for one map and all that serves it; filling it takes some milliseconds.
const SHARED_MEMORY: u64 = 8 << 20;

/// One of so many moments is tried; a prime, so that no pattern of calls is left out.
const STEP: usize = 11;

fn stage() -> Stage {
    let map = mapd_tests::carried("one_road.xodr");
    Stage::new(Path::new(MAPD), &map, "x,y\n10,-1.5\n").expect("the map answers from its file")
}

/// Runs a program and does something at each of its moments; how it ended and what it said.
fn run(command: &Command, at: impl FnMut(Pid, &Moment)) -> (ExitStatus, String) {
    let (traced, stderr) = Traced::start(command, "", Stdio::piped()).expect("starts");
    let (pid, mut at) = (traced.pid(), at);
    let run = traced.run(|moment| {
        at(pid, moment);
        Then::Continue
    });
    let (status, mut said) = (run.expect("ends"), String::new());
    stderr.expect("piped").read_to_string(&mut said).expect("text");
    (status, said)
}

/// A daemon is asked to stop as soon as it waits for clients.
fn stop_when_waiting(pid: Pid, moment: &Moment) {
    if moment.thread == 0 && matches!(moment.name, Sysno::epoll_wait | Sysno::epoll_pwait) {
        // Fails only if it has ended.
        let _ = kill(pid, Signal::SIGTERM);
    }
}

#[test]
fn while_a_daemon_starts_publishes_and_stops() {
    in_small_shared_memory(SHARED_MEMORY, || {
        let stage = stage();
        let mut moments = Vec::new();
        run(&stage.daemon_command(), |pid, moment| {
            moments.push(*moment);
            stop_when_waiting(pid, moment);
        });
        let (mut well, mut told) = (0, 0);
        for chosen in moments.iter().filter(|m| m.side == Side::Before).step_by(STEP) {
            let mut filler = None;
            let (status, said) = run(&stage.daemon_command(), |pid, moment| {
                if (moment.thread, moment.call, moment.side)
                    == (chosen.thread, chosen.call, chosen.side)
                {
                    filler = Filler::fill().ok();
                }
                stop_when_waiting(pid, moment);
            });
            drop(filler);
            let end = format!("filled up {chosen}: {status}: {said}");
            if status.success() {
                well += 1;
            } else {
                assert_eq!(status.signal(), None, "{end}");
                assert!(said.contains("bytes of shared memory"), "{end}");
                told += 1;
            }
            let left = stage.files();
            assert!(left.is_empty(), "{end}\nleft behind: {left:?}");
        }
        say(&format!("{} moments, {well} ended well, {told} with a clear error", moments.len()));
        assert!(well > 0 && told > 0, "both happen");
    });
}
