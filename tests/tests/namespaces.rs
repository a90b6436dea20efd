//! Daemon and clients in process namespaces of their own, as in containers that share `/dev/shm`: process ids then say
//! nothing about who lives; the kernel's locks do.

use mapd_client::Client;
use mapd_tests::say;
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const PROBE: &str = env!("CARGO_BIN_EXE_planner_probe");
const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// A command that becomes process 1 of a namespace of its own.
fn alone(place: &TestDomain, program: &str, args: &[&str]) -> Command {
    let mut command = place.command_of("unshare");
    command.args(["--pid", "--fork", "--kill-child", "--mount-proc", program]).args(args);
    command
}

/// A process in a namespace; killed when dropped, with all that is in the namespace.
struct Contained(Child);

impl Drop for Contained {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn possible(place: &TestDomain) -> bool {
    let possible = alone(place, "true", &[]).output().is_ok_and(|output| output.status.success());
    if !possible {
        say("SKIPPED: this user may not make a process namespace");
    }
    possible
}

/// A daemon in a container, once it serves.
fn serve(place: &TestDomain) -> Contained {
    let town = mapd_tests::carried("town.xodr").display().to_string();
    let mut daemon = Contained(alone(place, MAPD, &["--load", &town]).spawn().expect("starts"));
    let mut lines = BufReader::new(daemon.0.stderr.take().expect("stderr"));
    let mut line = String::new();
    while lines.read_line(&mut line).expect("readable") > 0 && !line.contains("serving") {}
    assert!(line.contains("serving"), "{line}");
    std::thread::spawn(move || std::io::copy(&mut lines, &mut std::io::sink()));
    daemon
}

/// A client in a container that has attached and waits for a line before it waits for the next generation; and the one that
/// it holds.
fn holder(place: &TestDomain) -> (Contained, BufReader<std::process::ChildStdout>, u64) {
    let wait = PATIENCE.as_millis().to_string();
    let mut command = alone(place, PROBE, &["wait", "town", &wait]);
    // Observers have nothing that could be cleared away.
    command.env("PROBE_ATTACH", "subscriber");
    let mut child = Contained(command.stdin(Stdio::piped()).spawn().expect("starts"));
    let mut lines = BufReader::new(child.0.stdout.take().expect("stdout"));
    let mut line = String::new();
    lines.read_line(&mut line).expect("readable");
    let held = line.trim().strip_prefix("attached ").and_then(|held| held.parse().ok());
    (child, lines, held.expect("a generation"))
}

#[test]
fn clients_attach_across_namespaces() {
    let place = TestDomain::new(MAPD);
    if !possible(&place) {
        return;
    }
    let _daemon = serve(&place);
    for how in ["observer", "subscriber"].repeat(3) {
        let mut command = alone(&place, PROBE, &["ask", "town", "10000"]);
        let output = command.env("PROBE_ATTACH", how).output().expect("ends");
        assert_eq!(String::from_utf8_lossy(&output.stdout), "lane 1:0:-1\n");
    }
    Client::connect_in(&place.domain(), "town", PATIENCE).expect("from outside as well");
}

/// The daemon must not take a living client in another namespace for a dead one because its process id is not here, or is
/// somebody else's here: nor the other way round.
#[test]
fn the_living_are_left_alone_and_the_dead_are_cleared_away() {
    let place = TestDomain::new(MAPD);
    if !possible(&place) {
        return;
    }
    let first = serve(&place);
    let (mut living, mut lines, held) = holder(&place);
    let dead: Vec<_> = (0..3).map(|_| holder(&place)).collect();
    let with_all = place.segments().len();
    drop(dead);
    // The dead ones' queues go away, the living one's stays.
    let start = Instant::now();
    while place.segments().len() > with_all - 3 && start.elapsed() < PATIENCE {
        std::thread::sleep(Duration::from_millis(50));
    }
    assert_eq!(place.segments().len(), with_all - 3, "{:?}", place.segments());
    // A daemon that is killed, and its successor in yet another namespace, with the same process id: 1.
    drop(first);
    let _second = serve(&place);
    living.0.stdin.take().expect("stdin").write_all(b"\n").expect("told");
    let mut rest = String::new();
    lines.read_to_string(&mut rest).expect("readable");
    let next = rest.lines().find_map(|line| line.split_once("generation ")?.1.parse::<u64>().ok());
    assert!(next > Some(held), "{held}: {rest}");
    assert!(living.0.wait().expect("ends").success(), "{rest}");
}
