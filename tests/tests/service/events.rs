//! What a client hears of its map and daemon, and the error of a wait that ends without a map.

use mapd::serve::{Doorbell, PublishMeta, Server, StopSignal};
use mapd_archive::OpenError;
use mapd_client::{Attach, Client, ClientError, Events, MapEvent};
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use mapd_transport::{AttachError, AttachLock, MAX_PINNED, Pinned, Subscription};
use std::path::Path;
use std::time::{Duration, Instant};

/// A wait that ends without a map.
const SHORT: Duration = Duration::from_millis(300);

fn place() -> TestDomain {
    TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"))
}

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

/// The next event in words.
fn next(events: &mut Events<'_>) -> String {
    let event = events.next(PATIENCE).expect("no error").expect("an event");
    match event {
        MapEvent::Generation(_) => "generation".to_owned(),
        MapEvent::Pending { .. } => "pending".to_owned(),
        MapEvent::DaemonGone => "gone".to_owned(),
        MapEvent::DaemonBack { .. } => "back".to_owned(),
        other => format!("{other:?}"),
    }
}

#[test]
fn a_daemon_goes_and_comes_back_with_a_new_generation() {
    for attach in [Attach::Observer, Attach::Subscriber] {
        goes_and_comes_back(attach);
    }
}

fn goes_and_comes_back(attach: Attach) {
    let place = place();
    let daemon = place.serve(&[&town()]);
    let client = Client::connect_as(attach, &place.domain(), "town", PATIENCE).expect("attaches");
    assert_eq!(client.attachment(), attach);
    let mut events = client.events();
    assert!(events.next(Duration::ZERO).expect("no error").is_none(), "nothing has happened");
    let before = client.snapshot();
    daemon.kill();
    assert_eq!(next(&mut events), "gone");
    assert_eq!(client.served_by(), None);
    before.verify().expect("still readable");
    assert!(events.next(SHORT).expect("no error").is_none(), "nothing more has happened");
    let successor = place.serve(&[&town()]);
    let mut heard = [next(&mut events), next(&mut events)];
    heard.sort();
    assert_eq!(heard, ["back", "generation"]);
    assert_eq!(client.served_by(), Some(successor.id()));
    assert!(client.snapshot().generation() > before.generation());
}

#[test]
fn a_staged_generation_is_pending_until_it_is_activated() {
    for attach in [Attach::Observer, Attach::Subscriber] {
        staged(attach);
    }
}

fn staged(attach: Attach) {
    let place = place();
    let folder = tempfile::tempdir().expect("a folder");
    let map = folder.path().join("town.xodr");
    let put = |from: &Path| std::fs::copy(from, &map).map(|_| ()).expect("copied");
    put(&mapd_tests::carried("town.xodr"));
    let _daemon = place.serve(&[&map.display().to_string()]);
    let client = Client::connect_as(attach, &place.domain(), "town", PATIENCE).expect("attaches");
    let mut events = client.events();
    put(&mapd_tests::carried("one_road.xodr"));
    let run = |args: &[&str]| {
        let output = place.command().args(args).output().expect("runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    };
    run(&["reload", "town", "--stage"]);
    let event = events.next(PATIENCE).expect("no error");
    let Some(MapEvent::Pending { generation }) = event else { panic!("{event:?}") };
    run(&["activate", "town"]);
    let event = events.next(PATIENCE).expect("no error");
    let Some(MapEvent::Generation(snapshot)) = event else { panic!("{event:?}") };
    assert_eq!(snapshot.generation(), generation);
    assert!(events.next(SHORT).expect("no error").is_none(), "nothing is pending any more");
}

/// Why a wait ended without a map, and how long it took.
fn refused(attach: Attach, place: &TestDomain, map: &str) -> (ClientError, Duration) {
    refused_within(attach, place, map, SHORT)
}

/// The same of a wait of this length.
fn refused_within(
    attach: Attach,
    place: &TestDomain,
    map: &str,
    wait: Duration,
) -> (ClientError, Duration) {
    let start = Instant::now();
    let error = Client::connect_as(attach, &place.domain(), map, wait).err().expect("no map");
    (error, start.elapsed())
}

/// Each reason is an error of its own type, and comes at the deadline if waiting might have helped, else at once. Others:
/// `shortage.rs` (no room, no place, other user, other transport, other version of iceoryx2).
#[test]
fn every_wait_in_vain_says_why() {
    for attach in [Attach::Observer, Attach::Subscriber] {
        wait_in_vain(attach);
    }
}

fn wait_in_vain(attach: Attach) {
    let place = place();
    let refused = |place, map| refused(attach, place, map);
    let (error, taken) = refused(&place, "town");
    assert!(matches!(error, ClientError::Attach(AttachError::NoDaemon { .. })), "{error}");
    assert!(taken >= SHORT, "given up after {taken:?}");

    let (error, taken) = refused_within(attach, &place, "../etc", PATIENCE);
    assert!(matches!(error, ClientError::Attach(AttachError::MapName { .. })), "{error}");
    assert!(taken < PATIENCE, "waited {taken:?} for nothing");

    let daemon = place.serve(&[&town()]);
    let (error, taken) = refused(&place, "village");
    let ClientError::Attach(AttachError::NoSuchMap { available, .. }) = &error else {
        panic!("{error}")
    };
    assert_eq!(available, &["town"]);
    assert!(taken >= SHORT, "given up after {taken:?}");

    let lock = AttachLock::open(&place.domain()).expect("a lock");
    let guard = lock.exclusive(Instant::now() + PATIENCE).expect("locks").expect("in time");
    if attach == Attach::Observer {
        Client::connect_in(&place.domain(), "town", SHORT).expect("observers take no lock");
        drop(guard);
        daemon.kill();
        Client::connect_in(&place.domain(), "town", SHORT).expect("what was served last");
        let (error, _) = refused(&place, "village");
        assert!(matches!(error, ClientError::Attach(AttachError::NoDaemon { .. })), "{error}");
        return;
    }
    let (error, taken) = refused(&place, "town");
    assert!(matches!(error, ClientError::Attach(AttachError::Busy { .. })), "{error}");
    assert!(taken >= SHORT, "given up after {taken:?}");
    drop(guard);

    daemon.kill();
    let (error, _) = refused(&place, "town");
    assert!(matches!(error, ClientError::Attach(AttachError::NoDaemon { .. })), "{error}");
}

/// A daemon that is there and has not published, and one that has published what this release cannot read.
#[test]
fn a_map_that_is_coming_and_one_that_cannot_be_read() {
    let place = place();
    let mut server = Server::start(&place.domain()).expect("starts");
    server.claim("town").expect("claimed");
    for attach in [Attach::Observer, Attach::Subscriber] {
        let (error, taken) = refused(attach, &place, "town");
        let coming =
            AttachError::NoGeneration { map: "town".into(), newer_than: 0, daemon_alive: true };
        assert_eq!(error.to_string(), coming.to_string());
        assert!(taken >= SHORT, "given up after {taken:?}");
    }

    let rows = mapd_archive::Rows::default();
    let mut archive = mapd_archive::encode(&rows, &mapd_archive::Provenance::default())
        .expect("encodes")
        .to_vec();
    archive[..8].copy_from_slice(b"notamapd");
    server
        .publish("town", archive.len(), |loan| {
            loan.copy_from_slice(&archive);
            let none = [0; 32];
            Ok(PublishMeta { layout_id: none, content_hash: none, input_hash: none })
        })
        .expect("opaque bytes");
    let stop = std::sync::Arc::new(StopSignal::new().expect("a signal"));
    std::thread::scope(|scope| {
        let (waits, here) = (stop.clone(), &place);
        let client = scope.spawn(move || {
            let refused = Client::connect_in(&here.domain(), "town", PATIENCE).err();
            waits.request();
            refused
        });
        server.run(&stop).expect("serves");
        let error = client.join().expect("no panic").expect("refused");
        let unreadable =
            matches!(error, ClientError::Open { source: OpenError::NotAnArchive { .. }, .. });
        assert!(unreadable, "{error}");
    });
}

/// Ends the server also when an assertion fails.
struct StopAtEnd<'a>(&'a StopSignal);

impl Drop for StopAtEnd<'_> {
    fn drop(&mut self) {
        self.0.request();
    }
}

/// A reader that lets no generation go gets no further ones, keeps what it has, and goes on once it lets one go.
#[test]
fn generations_that_nobody_lets_go_are_bounded() {
    let place = place();
    let (stop, door) = (StopSignal::new().expect("a signal"), Doorbell::new().expect("a bell"));
    let ringer = door.ringer().expect("a ringer");
    std::thread::scope(|scope| {
        let (domain, stopped) = (place.domain(), &stop);
        // Publishes whenever it is rung for.
        scope.spawn(move || {
            let mut server = Server::start(&domain).expect("starts");
            for number in 0..u8::MAX {
                let filled = server.publish("m", 64, |loan| {
                    loan.fill(number);
                    let none = [0; 32];
                    Ok(PublishMeta { layout_id: none, content_hash: none, input_hash: none })
                });
                filled.expect("publishes");
                server.run_until(stopped, &door).expect("serves");
                door.answer();
                if stopped.is_requested() {
                    break;
                }
            }
        });
        let _end = StopAtEnd(&stop);
        let soon = || Instant::now() + PATIENCE;
        let subscription = Subscription::connect(&place.domain(), "m", soon()).expect("attaches");
        let mut held = vec![subscription.current()];
        let last = |held: &[Pinned]| held.last().map_or(0, |pinned| pinned.info().generation);
        let error = loop {
            ringer.ring();
            match subscription.wait_newer(last(&held), soon()) {
                Ok(pinned) => held.push(pinned),
                Err(error) => break error,
            }
        };
        assert!(matches!(error, AttachError::TooManyPinned { .. }), "{error}");
        assert_eq!(held.len(), MAX_PINNED);
        let numbers: Vec<u8> = held.iter().map(|pinned| pinned.bytes()[0]).collect();
        assert!(numbers.windows(2).all(|two| two[0] < two[1]), "{numbers:?}");
        held.remove(0);
        let next = subscription.wait_newer(last(&held), soon()).expect("goes on");
        assert!(next.bytes()[0] > numbers[MAX_PINNED - 1]);
    });
}
