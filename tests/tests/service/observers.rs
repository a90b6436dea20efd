//! Readers that write nothing: what attaching takes, swaps under many of them, and daemons that end.

use mapd::serve::{Doorbell, PublishMeta, Server, StopSignal};
use mapd_client::{Attach, AttachError, Client, ClientError};
use mapd_tests::test_domain::{PATIENCE, StopAtEnd, TestDomain, publish, until};
use mapd_tests::tracer::{Side, Then, Traced};
use mapd_tests::two_maps::archives;
use mapd_tests::{number, say};
use nix::errno::Errno;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::Stdio;
use std::time::{Duration, Instant};
use syscalls::Sysno;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");
const PROBE: &str = env!("CARGO_BIN_EXE_planner_probe");

/// System calls that attaching as an observer may take.
const CALLS: usize = 12;

/// Swaps, where `MAPD_SWAPS` says nothing else.
const SWAPS: u64 = 300;

/// Processes that observe them, where `MAPD_OBSERVERS` says nothing else.
const OBSERVERS: usize = 20;

/// Processes that hold one map, where `MAPD_HOLDERS` says nothing else.
const HOLDERS: usize = 40;

/// Waits until the heart of the daemon that a client reads from has beaten after a moment.
fn beats_after(client: &Client, moment: Instant) {
    until("a heartbeat", || {
        // Taken first: an age below it is of a beat after `moment`.
        let since = moment.elapsed();
        client.heartbeat_age().filter(|age| *age < since)
    });
}

/// A heartbeat of this age is late: daemons beat once a second.
const LATE: Duration = Duration::from_millis(1500);

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

#[test]
fn attaching_takes_few_system_calls_and_leaves_nothing() {
    let place = TestDomain::new(MAPD);
    let _daemon = place.serve(&[&town()]);
    let files = place.segments();
    let mut command = place.command_of(PROBE);
    command.args(["steps", "town"]);
    let (traced, _) = match Traced::start(&command, "", Stdio::null()) {
        Err(error) if error.raw_os_error() == Some(Errno::EPERM as i32) => {
            return say("SKIPPED: tracing is not permitted");
        }
        started => started.expect("starts"),
    };
    let (mut calls, mut marks) = (Vec::new(), 0);
    let status = traced.run(|moment| {
        if moment.side == Side::Before {
            match moment.name {
                Sysno::getppid => marks += 1,
                // Rust's library asks before it closes a file whether it is open, where assertions are on.
                Sysno::fcntl => {}
                name if marks == 1 => calls.push(name),
                _ => {}
            }
        }
        Then::Continue
    });
    assert!(status.expect("runs").success());
    assert_eq!(marks, 2);
    say(&format!("system calls of an observer's attach: {calls:?}"));
    assert!(calls.len() <= CALLS, "{calls:?}");
    assert!(calls.contains(&Sysno::mmap), "nothing was counted: {calls:?}");
    let writing = [Sysno::write, Sysno::flock, Sysno::ftruncate, Sysno::unlink, Sysno::socket];
    assert!(!calls.iter().any(|call| writing.contains(call)), "{calls:?}");
    assert_eq!(place.segments(), files);
}

/// Hundreds of generations, each proved by every process that meets it; in the end all have the last one.
#[test]
fn swaps_under_many_observers() {
    let (swaps, observers) = (number("MAPD_SWAPS", SWAPS), number("MAPD_OBSERVERS", OBSERVERS));
    let place = TestDomain::new(MAPD);
    let archives = archives();
    let mut server = Server::start(&place.domain()).expect("starts");
    let mut publish = |number: u64| publish(&mut server, "m", &archives[(number % 2) as usize]);
    publish(0);
    let mut children: Vec<_> = (0..observers)
        .map(|_| {
            let mut command = place.command_of(PROBE);
            let mut child =
                command.args(["observe", "m"]).stdin(Stdio::piped()).spawn().expect("starts");
            let mut out = BufReader::new(child.stdout.take().expect("stdout"));
            let mut line = String::new();
            out.read_line(&mut line).expect("a line");
            assert!(line.starts_with("attached "), "{line}");
            (child, out)
        })
        .collect();
    let last = (1..=swaps).map(&mut publish).max().expect("some");
    let (mut attached, mut seen) = (0, 0);
    for (child, _) in &mut children {
        let mut stdin = child.stdin.take().expect("stdin");
        writeln!(stdin, "{last}").expect("told");
    }
    for (mut child, mut out) in children {
        let mut text = String::new();
        out.read_to_string(&mut text).expect("the report");
        assert!(child.wait().expect("ends").success(), "{text}");
        assert!(text.contains(&format!("last {last}\n")), "{text}");
        let of = |key: &str| -> u64 {
            let line = text.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(' '));
            line.and_then(|number| number.parse().ok()).expect("a number")
        };
        attached += of("attached");
        seen += of("seen");
    }
    say(&format!(
        "{swaps} swaps, {observers} observers: {attached} proved, {seen} newer ones seen"
    ));
    assert!(seen > observers as u64, "nobody saw a swap");
}

/// Many processes that hold one map at the same moment, all of it mapped: each has its answers, and there is one copy.
#[test]
fn one_map_held_by_many_observers() {
    let observers = number("MAPD_HOLDERS", HOLDERS);
    let place = TestDomain::new(MAPD);
    let _daemon = place.serve(&[&town()]);
    let files = place.segments();
    // One pipe for all of them: they end when it does.
    let (stdin, end) = std::io::pipe().expect("a pipe");
    let (said, stdout) = std::io::pipe().expect("a pipe");
    let start = Instant::now();
    let mut children: Vec<_> = (0..observers)
        .map(|_| {
            let mut command = place.command_of(PROBE);
            command.args(["hold", "town"]);
            command.stdin(stdin.try_clone().expect("a descriptor"));
            command.stdout(stdout.try_clone().expect("a descriptor"));
            command.stderr(Stdio::inherit()).spawn().expect("starts")
        })
        .collect();
    drop((stdin, stdout));
    // Read in a thread: if one of them fails, the pipe stays open, for the others have it.
    let (told, lines) = std::sync::mpsc::channel();
    std::thread::spawn(move || BufReader::new(said).lines().try_for_each(|line| told.send(line)));
    let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    let size = client.snapshot().bytes().len();
    for _ in 0..observers {
        let line = lines.recv_timeout(PATIENCE).expect("a line").expect("text");
        assert_eq!(line, format!("held {size}"));
    }
    let taken = start.elapsed();
    assert_eq!(place.segments(), files, "observers make nothing");
    let sum = |file, key| -> u64 {
        let memory = |child: &std::process::Child| -> u64 {
            let path = format!("/proc/{}/{file}", child.id());
            let text = std::fs::read_to_string(path).expect("a process");
            let line = text.lines().find_map(|line| line.strip_prefix(key)).expect("a line");
            line.trim().trim_end_matches(" kB").parse().expect("a number")
        };
        children.iter().map(memory).sum()
    };
    // In shares of what is shared, each rounded down.
    let (all, shares) = (sum("smaps_rollup", "Pss:"), sum("smaps_rollup", "Pss_Shmem:"));
    // Of the mappings of shared memory one by one: the kernel's own sums are approximate.
    let held = |child: &std::process::Child| -> u64 {
        let path = format!("/proc/{}/smaps", child.id());
        let text = std::fs::read_to_string(path).expect("a process");
        let (mut is_shared, mut sum) = (false, 0);
        for line in text.lines() {
            if let Some(number) = line.strip_prefix("Rss:").filter(|_| is_shared) {
                sum += number.trim().trim_end_matches(" kB").parse::<u64>().expect("a number");
            } else if !line.contains(": ") {
                is_shared = line.contains(" /dev/shm/");
            }
        }
        sum
    };
    let (mapped, size) = (children.iter().map(held).sum::<u64>(), size as u64 / 1024);
    assert!(mapped >= size * observers as u64, "{mapped} KiB are not all of it for each");
    assert!(shares < size * 2, "{shares} KiB for one map of {size} KiB");
    drop(end);
    for child in &mut children {
        assert!(child.wait().expect("ends").success());
    }
    say(&format!(
        "{observers} observers hold one map, the last {taken:.2?} after the first was started; together they take {all} KiB, {shares} KiB of them for the map of {size} KiB"
    ));
}

/// What a killed daemon served last is found, and its age seen; a client that waits gets the successor's.
#[test]
fn after_the_daemons_death() {
    let place = TestDomain::new(MAPD);
    let daemon = place.serve(&[&town()]);
    let before = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    assert_eq!(before.attachment(), Attach::Observer);
    beats_after(&before, Instant::now());
    daemon.kill();
    let after = Client::connect_in(&place.domain(), "town", Duration::ZERO).expect("attaches");
    assert_eq!(after.snapshot().generation(), before.snapshot().generation());
    after.snapshot().verify().expect("whole");
    assert_eq!(after.served_by(), None);
    std::thread::sleep(LATE);
    let (first, second) = (after.heartbeat_age(), before.heartbeat_age());
    assert!(first.is_some_and(|age| age >= LATE) && second >= first, "{first:?}, {second:?}");
    let waiting = std::thread::spawn(move || after.wait_next(PATIENCE));
    let start = Instant::now();
    let _successor = place.serve(&[&town()]);
    let next = waiting.join().expect("no panic").expect("the successor's generation");
    assert!(next.generation() > before.snapshot().generation());
    next.verify().expect("whole");
    beats_after(&before, start);
}

/// Where another daemon serves in the same domain, it removes what a killed one left: then nothing is served until the successor comes, and clients say so.
#[test]
fn after_the_daemons_death_beside_another() {
    let place = TestDomain::new(MAPD);
    let daemon = place.serve(&[&town()]);
    let _other = place.serve(&[&mapd_tests::carried("one_road.xodr").display().to_string()]);
    let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    let held = client.snapshot();
    let connect_now = || Client::connect_in(&place.domain(), "town", Duration::ZERO);
    let start = Instant::now();
    daemon.kill();
    let error = until("the removal", || connect_now().err());
    say(&format!("a killed daemon's segment is removed by another after {:.2?}", start.elapsed()));
    let available = vec!["one_road".to_owned()];
    let expected = AttachError::NoSuchMap { map: "town".to_owned(), available };
    assert_eq!(error.to_string(), ClientError::from(expected).to_string());
    held.verify().expect("what is held stays");
    assert_eq!(client.refresh().expect("no error").generation(), held.generation());
    let waiting = std::thread::spawn(move || client.wait_next(PATIENCE));
    let _successor = place.serve(&[&town()]);
    let next = waiting.join().expect("no panic").expect("the successor's generation");
    assert!(next.generation() > held.generation());
    next.verify().expect("whole");
    assert_eq!(connect_now().expect("attaches").snapshot().generation(), next.generation());
}

/// A clean end removes the record; a client that waits on it is told, and finds the next daemon's.
#[test]
fn after_a_clean_end() {
    let place = TestDomain::new(MAPD);
    let daemon = place.serve(&[&town()]);
    let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    let held = client.snapshot();
    let connect_now = || Client::connect_in(&place.domain(), "town", Duration::ZERO);
    std::thread::scope(|scope| {
        let waiting = scope.spawn(|| client.wait_next(PATIENCE));
        std::thread::sleep(LATE / 10);
        assert_eq!(daemon.stop(), 0);
        assert!(!place.domain().root().exists(), "observers keep nothing");
        assert_eq!(client.heartbeat_age(), None);
        assert!(connect_now().is_err(), "nothing is served");
        held.verify().expect("what is held stays");
        assert_eq!(client.refresh().expect("no error").generation(), held.generation());
        let _next = place.serve(&[&town()]);
        let next = waiting.join().expect("no panic").expect("the next daemon's generation");
        assert!(next.generation() > held.generation());
        let fresh = connect_now().expect("attaches").snapshot();
        assert_eq!(fresh.generation(), next.generation());
    });
}

/// Everything of the domain is removed by hand under a daemon and a reader, and another daemon comes.
#[test]
fn after_the_root_folder_was_removed() {
    let place = TestDomain::new(MAPD);
    let daemon = place.serve(&[&town()]);
    let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    let held = client.snapshot().generation();
    std::fs::remove_dir_all(place.domain().root()).expect("removed");
    daemon.kill();
    let _next = place.serve(&[&town()]);
    let next = client.wait_next(PATIENCE).expect("the next daemon's generation");
    assert!(next.generation() > held);
}

/// A map that is withdrawn and comes again, in one daemon.
#[test]
fn a_map_is_withdrawn_and_comes_again() {
    let place = TestDomain::new(MAPD);
    let rows = mapd_archive::Rows::default();
    let bytes = mapd_archive::encode(&rows, &mapd_archive::Provenance::default()).expect("encodes");
    let mut server = Server::start(&place.domain()).expect("starts");
    let publish = |server: &mut Server| publish(server, "m", &bytes);
    let first = publish(&mut server);
    let client = Client::connect_in(&place.domain(), "m", PATIENCE).expect("attaches");
    assert_eq!(client.snapshot().generation(), first);
    server.withdraw("m");
    assert!(Client::connect_in(&place.domain(), "m", Duration::ZERO).is_err());
    assert_eq!(client.refresh().expect("no error").generation(), first);
    let second = publish(&mut server);
    assert_eq!(client.wait_next(PATIENCE).expect("the next").generation(), second);
    server
        .stage("m", bytes.len(), |loan| {
            loan.copy_from_slice(&bytes);
            let content_hash = mapd_archive::open(loan)?.header.content_hash;
            Ok(PublishMeta { layout_id: [0; 32], content_hash, input_hash: [0; 32] })
        })
        .expect("staged");
    assert_eq!(client.refresh().expect("no error").generation(), second, "staged is not served");
    let third = server.activate("m").expect("activated");
    assert_eq!(client.refresh().expect("no error").generation(), third);
}

/// One generation after the other, each waited for.
#[test]
fn every_generation_is_waited_for() {
    const ROUNDS: usize = 40;
    let place = TestDomain::new(MAPD);
    let rows = mapd_archive::Rows::default();
    let bytes = mapd_archive::encode(&rows, &mapd_archive::Provenance::default()).expect("encodes");
    let (stop, door) = (StopSignal::new().expect("a signal"), Doorbell::new().expect("a bell"));
    let ringer = door.ringer().expect("a ringer");
    std::thread::scope(|scope| {
        let _stop = StopAtEnd(&stop);
        let (domain, stopped, bytes) = (place.domain(), &stop, &bytes);
        scope.spawn(move || {
            let mut server = Server::start(&domain).expect("starts");
            while !stopped.is_requested() {
                publish(&mut server, "m", bytes);
                server.run_until(stopped, &door).expect("serves");
                door.answer();
            }
        });
        let client = Client::connect_in(&place.domain(), "m", PATIENCE).expect("attaches");
        let begun = Instant::now();
        for _ in 0..ROUNDS {
            let before = client.snapshot().generation();
            ringer.ring();
            let next = client.wait_next(PATIENCE).expect("the next");
            assert_eq!(next.generation(), before + 1);
        }
        let taken = begun.elapsed();
        say(&format!("{ROUNDS} generations waited for in {taken:?}"));
    });
}
