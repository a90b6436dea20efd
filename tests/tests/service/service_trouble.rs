//! A daemon in trouble that is not its own: no room, too many clients, clients that dawdle, signals at the wrong moment. What is
//! served stays served, and requests are answered truthfully.

use mapd::control::{ReloadResult, Request, Response, ask};
use mapd_client::{Attach, AttachError, Client, ClientError};
use mapd_tests::manager::Manager;
use mapd_tests::small::{Filler, in_small_shared_memory};
use mapd_tests::test_domain::{HeldCompiler, PATIENCE, TestDomain, slow, until};
use mapd_tests::two_maps::TwoMaps;
use std::fs;
use std::io::{Read, Write};
use std::os::unix::net::UnixStream;
use std::process::Stdio;
use std::time::{Duration, Instant};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Room for one small map and all that serves it.
const SHARED_MEMORY: u64 = 8 << 20;

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

/// The socket on which the only map of this place is asked about.
fn control_socket(place: &TestDomain) -> std::path::PathBuf {
    let entries = fs::read_dir(place.domain().root()).expect("the root folder");
    let mut sockets = entries
        .flatten()
        .filter(|entry| entry.file_name().to_string_lossy().starts_with("control-"))
        .map(|entry| entry.path());
    sockets.next().expect("a socket")
}

/// The watchdog once had a sound daemon killed where nobody, so not the daemon either, could attach for want of memory.
#[test]
fn full_shared_memory_is_no_reason_to_be_killed() {
    in_small_shared_memory(SHARED_MEMORY, || {
        let (place, manager) = (TestDomain::new(MAPD), Manager::new());
        let mut command = place.command();
        manager.listen_to(&mut command).args(["--scrub", "1", "--load", &town()]);
        let _daemon = place.spawn(command);
        manager.expect("READY=1");
        // Right after a scrub, which comes once in a second: one that was under way would fail.
        until("a scrub", || (place.state("town").scrubs.ok > 0).then_some(()));
        let filler = Filler::fill().expect("filled");
        let skipped = || {
            let state = place.state("town");
            (state.self_queries.skipped, state.scrubs.skipped)
        };
        manager.drain();
        // A ping says that the queries before it met a lack of room at worst. One that was late, on a busy machine, is a failure of its own,
        // after which others come.
        for _ in 0..3 {
            let before = skipped();
            until("a query and a scrub that are skipped", || {
                let now = skipped();
                (now.0 > before.0 && now.1 > before.1).then_some(())
            });
            manager.drain();
            manager.expect("WATCHDOG=1");
        }
        drop(filler);
        let scrubs = place.state("town").scrubs;
        assert!(scrubs.failures <= 1, "{scrubs:?}");
    });
}

/// Clients are refused at a number of their own, and the daemon still looks at what it serves.
#[test]
fn places_are_kept_for_the_daemon() {
    use mapd_transport::MAX_SUBSCRIBERS;
    let (place, manager) = (TestDomain::new(MAPD), Manager::new());
    let mut command = place.command();
    manager.listen_to(&mut command).args(["--load", &town()]);
    let _daemon = place.spawn(command);
    manager.expect("READY=1");
    let connect = |wait| Client::connect_as(Attach::Subscriber, &place.domain(), "town", wait);
    let clients: Vec<_> =
        (0..MAX_SUBSCRIBERS).map(|_| connect(PATIENCE).expect("attaches")).collect();
    // A daemon that cleans up on a busy machine may keep the lock for so long.
    let refused = until("an answer", || match connect(Duration::from_millis(50)).err() {
        Some(ClientError::Attach(AttachError::Busy { .. })) => None,
        outcome => Some(outcome.expect("one more than there are places")),
    });
    let is_full = matches!(&refused, ClientError::Attach(AttachError::TooManySubscribers { .. }));
    assert!(is_full && refused.to_string().contains("64"), "{refused}");
    let asked = place.state("town").self_queries.ok;
    manager.drain();
    manager.expect("WATCHDOG=1");
    manager.expect("WATCHDOG=1");
    let queries = place.state("town").self_queries;
    // Without a place it would be skipped; failures are answers that were late, on a busy machine.
    assert!(queries.ok > asked && queries.skipped == 0, "{queries:?}");
    drop(clients);
    connect(PATIENCE).expect("there is room again");
}

#[test]
fn who_waits_for_ever_may_say_so() {
    let place = TestDomain::new(MAPD);
    let _daemon = place.serve(&[&town()]);
    let client = Client::connect_in(&place.domain(), "town", Duration::MAX).expect("attaches");
    let generation = client.snapshot().generation();
    client.require(generation, Duration::MAX).expect("is served");
    let wait = place.command().args(["inspect", "shm:nothing", "--wait", "1e19"]).spawn();
    let mut wait = wait.expect("starts");
    std::thread::sleep(Duration::from_millis(300));
    assert!(wait.try_wait().expect("looked at").is_none(), "it waits");
    wait.kill().and_then(|()| wait.wait()).expect("ended");
}

/// A signal that came while maps were compiled ended the daemon as if it knew none.
#[test]
fn signals_at_the_start_are_obeyed() {
    let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
    let map = slow(&fs::read(town()).expect("the town"));
    let start = |name: &str| {
        let file = folder.path().join(name);
        fs::write(&file, &map).expect("written");
        let daemon = place.start(&[&file.display().to_string(), "--no-cache"]);
        (daemon, HeldCompiler::of(&file))
    };
    let (daemon, compiler) = start("town.xodr");
    daemon.signal("HUP");
    compiler.go_on();
    let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("serves after all");
    drop(client);
    drop(daemon);
    let (daemon, _compiler) = start("other.xodr");
    assert_eq!(daemon.stop(), 0, "SIGTERM before anything was served");
}

/// The daemon's own queries wait for the daemon, which at the end waits for them.
#[test]
fn a_daemon_ends_at_once_whatever_it_looks_at() {
    let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
    for number in 0..12 {
        fs::copy(town(), folder.path().join(format!("m{number}.xodr"))).expect("copied");
    }
    let path = folder.path().display().to_string();
    for _ in 0..3 {
        let daemon = place.serve(&[&path, "--scrub", "1"]);
        // Within the first scrub, which begins after a second.
        std::thread::sleep(Duration::from_millis(1010));
        let start = Instant::now();
        assert_eq!(daemon.stop(), 0);
        assert!(start.elapsed() < PATIENCE, "{:?}", start.elapsed());
    }
}

/// Either all maps are served or none: an archive that does not prove shows only when it is copied.
#[test]
fn of_several_maps_all_are_served_or_none() {
    let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
    let [good, bad] = ["a.mapd", "b.mapd"].map(|name| folder.path().join(name));
    let mut compile = place.command();
    let compiled = compile.args(["compile", &town(), "-o"]).arg(&good).output().expect("runs");
    assert!(compiled.status.success());
    let mut bytes = fs::read(&good).expect("an archive");
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(&bad, &bytes).expect("written");
    let output = |args: &[&str]| {
        let output = place.command().arg("--load").args(args).output().expect("ends");
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let [good, bad] = [good, bad].map(|path| path.display().to_string());
    let (code, said) = output(&[&good, &bad]);
    assert_eq!(code, Some(4), "{said}");
    assert!(!said.contains("serving") && said.contains("map \"b\""), "{said}");
    for (bytes, words) in [(&b"hi"[..], "cut off: 2 bytes"), (&[7; 4096], "archive")] {
        fs::write(&bad, bytes).expect("written");
        let (code, said) = output(&[&bad]);
        assert!(code == Some(4) && said.contains(words), "{code:?} {said}");
    }
    let daemon = place.serve(&[&good, &town()]);
    for map in ["a", "town"] {
        Client::connect_in(&place.domain(), map, PATIENCE).expect("is served");
        assert!(place.state(map).staged.is_none(), "{map}");
    }
    drop(daemon);
}

/// What the file does not hold any more is not served later.
#[test]
fn a_map_that_is_withdrawn_cannot_be_activated() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let _daemon = place.serve(&[&maps.path().display().to_string()]);
    let reload = |stage| place.change("map", &Request::Reload { map: "map".to_owned(), stage });
    for stage in [true, false] {
        maps.put(1);
        let staged = reload(true);
        assert_eq!(staged.result, ReloadResult::Staged);
        maps.put(0);
        let report = reload(stage);
        assert_eq!(report.result, ReloadResult::Unchanged, "{report:?}");
        assert!(report.reason.contains("given up"), "{report:?}");
        assert_eq!(place.state("map").staged, None);
        let activated = place.ask("map", &Request::Activate { map: "map".to_owned() });
        assert!(matches!(activated, Some(Response::Refused { .. })), "{activated:?}");
        let client = Client::connect_in(&place.domain(), "map", PATIENCE).expect("attaches");
        assert!(maps.is(&client.snapshot(), 0) && client.pending().is_none());
    }
}

/// An archive that was written over in place while it could be gone back to.
#[test]
fn what_is_lost_is_left_out_when_going_back() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let archive = maps.folder().join("map.mapd");
    let compile = |number| {
        maps.put(number);
        let mut command = place.command();
        command.arg("compile").arg(maps.path()).arg("-o").arg(&archive);
        assert!(command.output().expect("ends").status.success());
    };
    let change = |request: Request| place.change("map", &request);
    let reload = || change(Request::Reload { map: "map".to_owned(), stage: false });
    let rollback = || change(Request::Rollback { map: "map".to_owned(), stage: false });
    compile(0);
    let _daemon = place.serve(&[&archive.display().to_string()]);
    let first = place.state("map").served.expect("served").generation;
    compile(1);
    assert_eq!(reload().result, ReloadResult::Published);
    let aside = maps.folder().join("aside");
    fs::rename(&archive, &aside).expect("renamed");
    compile(0);
    assert_eq!(reload().result, ReloadResult::Published);
    fs::write(&aside, "written over").expect("written");
    let report = rollback();
    assert_eq!(report.result, ReloadResult::Published, "{report:?}");
    let said =
        [format!("what generation {first} was"), format!("generation {} is lost", first + 1)];
    assert!(said.iter().all(|words| report.reason.contains(words)), "{report:?}");
    assert_eq!(place.state("map").rollbacks, 0);
    let request = Request::Rollback { map: "map".to_owned(), stage: false };
    let answer = place.ask("map", &request);
    assert!(matches!(answer, Some(Response::Refused { .. })), "{answer:?}");
}

/// Whoever connects and says nothing, or a byte now and then, keeps nobody out: the oldest of them loses its place.
#[test]
fn dawdlers_keep_nobody_out() {
    let place = TestDomain::new(MAPD);
    let _daemon = place.serve(&[&town()]);
    let socket = control_socket(&place);
    let mut dawdlers: Vec<_> =
        (0..200).map(|_| UnixStream::connect(&socket).expect("connects")).collect();
    for _ in 0..20 {
        for dawdler in &mut dawdlers {
            // Fails once it has been hung up on.
            let _ = dawdler.write_all(b" ");
        }
        let answer = ask(&place.domain(), "town", &Request::Status, PATIENCE).expect("an answer");
        assert!(matches!(answer, Response::Status(_)), "{answer:?}");
    }
    assert_eq!(dawdlers[0].read(&mut [0]).unwrap_or(0), 0, "its place is another's");
}

/// A daemon that is stopped keeps clients waiting no longer than their deadline, however many requests came before.
#[test]
fn nobody_waits_for_ever_for_a_daemon_that_is_stopped() {
    let place = TestDomain::new(MAPD);
    let daemon = place.serve(&[&town()]);
    daemon.pause(&place);
    let socket = control_socket(&place);
    // A client that has gone keeps its place in the queue. The line's length is the kernel's; none that is known has more places.
    let most = 10_000;
    let mut connected = 0;
    while connected < most {
        let (done, asked) = std::sync::mpsc::channel();
        let path = socket.clone();
        std::thread::spawn(move || done.send(UnixStream::connect(path).map(drop)));
        match asked.recv_timeout(Duration::from_millis(500)) {
            Ok(Ok(())) => connected += 1,
            Ok(Err(error)) => panic!("{error}"),
            Err(_) => break,
        }
    }
    assert!(connected < most, "the line is never full");
    let start = Instant::now();
    let answer = ask(&place.domain(), "town", &Request::Status, Duration::from_millis(200));
    assert!(answer.is_err(), "{answer:?}");
    assert!(start.elapsed() < PATIENCE, "{:?}", start.elapsed());
    daemon.signal("CONT");
}

#[test]
fn wrong_usage_is_told_from_a_failing_environment() {
    let (place, folder) = (TestDomain::new(MAPD), tempfile::tempdir().expect("a folder"));
    let (town, empty) = (town(), folder.path().display().to_string());
    let check = |args: &[&str]| {
        let mut command = place.command();
        let output = command.args(args).stdin(Stdio::null()).output().expect("ends");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{args:?}: {said}");
        assert!(!said.contains("serving"), "{args:?}: {said}");
    };
    for args in [
        &["--load", &town, "--prefix", "x"][..],
        &["status", "--prefix", "x"],
        &["--load", &town, "--name", "a b"],
        &["--load", &town, &town],
        &["--load", &town, &town, "--name", "one"],
        &["--load", &empty],
        &["--load", &town, "--metrics", "0.0.0.0:0"],
        &["query", &town, "nearest", "--radius", "nan"],
        &["query", &town, "nearest", "--radius=-3"],
        &["query", &town, "nearest", "--z-tolerance", "inf"],
    ] {
        check(args);
    }
    // A port that is in use is the environment's fault, and shows before anything is served.
    let taken = std::net::TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = taken.local_addr().expect("an address").to_string();
    let mut command = place.command();
    let output = command.args(["--load", &town, "--metrics", &address]).output().expect("ends");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(1) && !said.contains("serving"), "{said}");
}

/// A generation was said to be staged whose record could not be written, so that no client saw it as pending.
#[test]
fn what_clients_cannot_see_is_not_staged() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let daemon = place.serve(&[&maps.path().display().to_string()]);
    let stage = || place.change("map", &Request::Reload { map: "map".to_owned(), stage: true });
    let in_the_way = place.domain().root().join("map.staged.new");
    std::fs::create_dir(&in_the_way).expect("made");
    maps.put(1);
    let report = stage();
    assert_eq!(report.result, ReloadResult::Failed, "{}", report.reason);
    assert_eq!(place.state("map").staged, None);
    std::fs::remove_dir(&in_the_way).expect("removed");
    assert_eq!(stage().result, ReloadResult::Staged);
    assert!(place.state("map").staged.is_some());
    assert_eq!(daemon.stop(), 0);
}
