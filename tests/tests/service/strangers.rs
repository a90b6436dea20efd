//! What another user without rights, who can write to /dev/shm, puts there: it is no part of the domain, changes nothing, and stops nobody who does not need its name.

use mapd::control::{ReloadResult, Request, Response};
use mapd_client::{Attach, AttachError, Client, ClientError};
use mapd_tests::manager::Manager;
use mapd_tests::other_user::{USER, command};
use mapd_tests::test_domain::{PATIENCE, TestDomain, until};
use mapd_tests::tracer::{Side, Then, Traced};
use mapd_tests::two_maps::TwoMaps;
use nix::errno::Errno;
use nix::sys::signal::{Signal, kill};
use serde_json::Value;
use std::fs::{self, File};
use std::io::{Read, Write};
use std::net::TcpStream;
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Names of what iceoryx2 makes, after the prefix.
const COUNTER: &str = "9204dd183d1c4d8e1ff592a30766ffa6765aa8b5_node.0_10_0.global_mgmt";
const QUEUE: &str = "b9fc73e5c1f646968758453273c6c65cb372831b";

/// What a counter of nodes holds: the version of iceoryx2, and no node.
const COUNTED: &str = r"\0\0\012\0\0\0\0\0\0\0\0\0\0\0\0\0";

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

/// A domain, and somebody who is not its user.
struct Scene {
    place: TestDomain,
}

impl Scene {
    /// `None`, with the reason on stderr, where nobody can be another user.
    fn new() -> Option<Self> {
        let place = TestDomain::new(MAPD);
        command(&place, "", "/bin/sh").map(|_| Self { place })
    }

    /// A name in `/dev/shm` that has the prefix.
    fn at(&self, name: &str) -> PathBuf {
        Path::new("/dev/shm").join(format!("{}{name}", self.place.domain().prefix()))
    }

    /// The stranger's shell; `$1` is the path.
    fn shell(&self, script: &str, path: &Path) -> Command {
        let mut shell = command(&self.place, "", "/bin/sh").expect("as before");
        shell.args(["-c", &format!("umask 0; {script}"), "stranger"]).arg(path);
        shell
    }

    /// Has the stranger do something.
    fn stranger(&self, script: &str, path: &Path) {
        let output = self.shell(script, path).output().expect("runs");
        assert!(output.status.success(), "{script}: {output:?}");
    }

    /// A daemon whose log goes into a file.
    fn logged(&self, log: &Path, args: &[&str]) -> Logged {
        let mut command = self.place.command();
        command.args(["--load", &town()]).args(args);
        self.spawn(log, &mut command)
    }

    fn spawn(&self, log: &Path, command: &mut Command) -> Logged {
        let file = File::create(log).expect("a log");
        let child = command.stderr(file).stdout(Stdio::null()).spawn().expect("starts");
        let logged = Logged { child, log: log.to_owned() };
        until("serving", || logged.said().contains("serving ").then_some(()));
        logged
    }

    fn subscribe(&self, wait: Duration) -> Result<Client, ClientError> {
        Client::connect_as(Attach::Subscriber, &self.place.domain(), "town", wait)
    }

    /// State and words of the lines of the doctor's check.
    fn doctor(&self, check: &str) -> Vec<(String, String)> {
        let args = ["doctor", "--json", "--wait", "5"];
        let output = self.place.command().args(args).output().expect("runs");
        let report: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        let lines = report["findings"].as_array().expect("a list").iter();
        let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
        let lines = lines.filter(|line| line["check"] == check);
        lines.map(|line| (text(&line["state"]), text(&line["found"]))).collect()
    }
}

impl Drop for Scene {
    fn drop(&mut self) {
        for entry in fs::read_dir("/dev/shm").expect("a folder").flatten() {
            if entry.file_name().to_string_lossy().starts_with(self.place.domain().prefix()) {
                let path = entry.path();
                let _ = fs::remove_file(&path).or_else(|_| fs::remove_dir_all(&path));
            }
        }
    }
}

/// A daemon; killed at the end.
struct Logged {
    child: Child,
    log: PathBuf,
}

impl Logged {
    fn said(&self) -> String {
        fs::read_to_string(&self.log).expect("a log")
    }

    fn stop(mut self) -> Option<i32> {
        let pid = self.child.id().to_string();
        assert!(Command::new("kill").arg(&pid).status().expect("kill runs").success());
        self.child.wait().expect("waited for").code()
    }
}

impl Drop for Logged {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The names by which tests and code know iceoryx2's files are those that it uses, and nothing is there for others to write.
#[test]
fn the_counter_of_nodes_is_the_daemons_own() {
    let place = TestDomain::new(MAPD);
    let daemon = place.serve(&[&town()]);
    let client = Client::connect_as(Attach::Subscriber, &place.domain(), "town", PATIENCE);
    let client = client.expect("attaches");
    let names: Vec<String> = place
        .segments()
        .iter()
        .map(|path| path.file_name().expect("a name").to_string_lossy().into_owned())
        .collect();
    let prefix = place.domain().prefix().to_owned();
    let counters: Vec<_> = names.iter().filter(|name| name.ends_with(".global_mgmt")).collect();
    assert_eq!(counters, [&format!("{prefix}{COUNTER}")]);
    let counter = Path::new("/dev/shm").join(counters[0]);
    let found = fs::metadata(&counter).expect("there");
    assert_eq!(found.permissions().mode() & 0o777, 0o600);
    let is_queue = |name: &&String| name.ends_with(".connection");
    let queues: Vec<_> = names.iter().filter(is_queue).collect();
    let is_known = |name: &&String| name.starts_with(&format!("{prefix}{QUEUE}_"));
    assert!(!queues.is_empty() && queues.iter().all(is_known), "{names:?}");
    drop(client);
    daemon.kill();
    let daemon = place.serve(&[&town()]);
    let kept = fs::metadata(&counter).expect("there").ino();
    assert_eq!(kept, found.ino(), "at no moment could a stranger take the name");
    assert_eq!(daemon.stop(), 0);
    assert!(!counter.exists());
}

/// A daemon changed the mode of whatever a stranger's link led to: a file or a folder of its user's became 0600.
#[test]
fn links_lead_to_no_change() {
    let Some(scene) = Scene::new() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let (file, inner) = (folder.path().join("file"), folder.path().join("inner"));
    fs::write(&file, "x").expect("written");
    fs::create_dir(&inner).expect("a folder");
    let mode = |path: &Path| fs::metadata(path).expect("there").permissions().mode() & 0o7777;
    let set = |path: &Path, mode| fs::set_permissions(path, fs::Permissions::from_mode(mode));
    set(&file, 0o644).and_then(|()| set(&inner, 0o755)).expect("changed");
    let names = [
        "x.global_mgmt",
        "y.global_mgmt",
        "1_2.data",
        "3_4.connection",
        "5.event_mgmt",
        "6_7.dynamic",
    ];
    for (name, victim) in names.iter().zip([&file, &inner].into_iter().cycle()) {
        scene.stranger(&format!("ln -s {} \"$1\"", victim.display()), &scene.at(name));
    }
    let daemon = scene.logged(&folder.path().join("log"), &[]);
    scene.subscribe(PATIENCE).expect("subscribes");
    assert_eq!((mode(&file), mode(&inner)), (0o644, 0o755));
    assert_eq!(daemon.stop(), Some(0));
    // Under the one name that is opened.
    scene.stranger(&format!("ln -s {} \"$1\"", file.display()), &scene.at(COUNTER));
    let daemon = scene.logged(&folder.path().join("log"), &[]);
    assert!(daemon.said().contains(&format!("belongs to user {USER}")), "{}", daemon.said());
    Client::connect_in(&scene.place.domain(), "town", PATIENCE).expect("observers attach");
    assert_eq!(daemon.stop(), Some(0));
    assert_eq!((mode(&file), mode(&inner)), (0o644, 0o755));
    assert_eq!(fs::read_to_string(&file).expect("there"), "x");
    assert!(names.iter().all(|name| fs::symlink_metadata(scene.at(name)).is_ok()), "a stranger's");
}

/// An empty file counted as one that a killed process had left unfinished. No daemon could remove it: nobody could subscribe, and the service manager heard neither
/// READY=1 nor WATCHDOG=1.
#[test]
fn what_a_stranger_leaves_stops_nobody() {
    let Some(scene) = Scene::new() else { return };
    let (folder, manager) = (tempfile::tempdir().expect("a folder"), Manager::new());
    let kinds = [
        ("empty", ": > \"$1\""),
        ("unreadable", "echo x > \"$1\"; chmod 0 \"$1\""),
        ("pipe", "mkfifo \"$1\""),
        ("folder", "mkdir \"$1\""),
        ("link", "ln -s /dev/zero \"$1\""),
        ("1_2.dynamic", ": > \"$1\""),
        ("turn\u{1b}[31m", ": > \"$1\""),
    ];
    let (before, later) = kinds.split_at(3);
    let make = |kinds: &[(&str, &str)]| {
        kinds.iter().for_each(|(name, script)| scene.stranger(script, &scene.at(name)));
    };
    make(before);
    let mut program = scene.place.command();
    manager.listen_to(program.args(["--load", &town()]));
    let daemon = scene.spawn(&folder.path().join("log"), &mut program);
    manager.expect("READY=1");
    make(later);
    scene.subscribe(PATIENCE).expect("subscribes");
    manager.drain();
    for _ in 0..4 {
        manager.expect("WATCHDOG=1");
    }
    let escaped = |name: &str| format!("{:?} belongs to user {USER}", scene.at(name));
    let times = |name: &str| daemon.said().matches(&escaped(name)).count();
    for (name, _) in kinds {
        until("a line of the log", || (times(name) > 0).then_some(()));
    }
    let report = scene.place.reload("town");
    assert_eq!(report.result, ReloadResult::Unchanged, "{}", report.reason);
    assert!(kinds.iter().all(|(name, _)| times(name) == 1), "{}", daemon.said());
    assert!(!daemon.said().contains('\u{1b}'), "{:?}", daemon.said());
    let lines = scene.doctor("other users' files");
    let [(state, found)] = lines.as_slice() else { panic!("{lines:?}") };
    assert_eq!(state, "note");
    assert!(kinds.iter().all(|(name, _)| found.contains(&escaped(name))), "{found}");
    for check in ["unfinished files", "rights", "subscribe"] {
        let lines = scene.doctor(check);
        assert!(lines.iter().all(|(state, _)| state == "ok"), "{check}: {lines:?}");
    }
    assert_eq!(daemon.stop(), Some(0));
    for (name, _) in kinds {
        assert!(fs::symlink_metadata(scene.at(name)).is_ok(), "{name} is not ours to remove");
    }
    assert!(scene.doctor("files of dead processes")[0].1.contains("none"));
}

/// A counter of nodes that a stranger had made first ended the daemon, and subscribers, by SIGBUS, or kept it from starting with an error that named no file.
#[test]
fn a_strangers_counter_keeps_subscribers_out_and_nobody_else() {
    let kinds = [
        format!("printf '{COUNTED}' > \"$1\""),
        ": > \"$1\"".to_owned(),
        "echo x > \"$1\"; chmod 600 \"$1\"".to_owned(),
        "mkfifo \"$1\"".to_owned(),
        "mkdir \"$1\"".to_owned(),
        "ln -s /dev/null \"$1\"".to_owned(),
    ];
    for kind in &kinds {
        let Some(scene) = Scene::new() else { return };
        let (folder, manager) = (tempfile::tempdir().expect("a folder"), Manager::new());
        let counter = scene.at(COUNTER);
        scene.stranger(kind, &counter);
        let named = format!("{counter:?} belongs to user {USER}");
        let mut program = scene.place.command();
        manager.listen_to(program.args(["--load", &town()]));
        let daemon = scene.spawn(&folder.path().join("log"), &mut program);
        assert_eq!(daemon.said().matches(&named).count(), 2, "{kind}: {}", daemon.said());
        let ready = manager.hear(PATIENCE).unwrap_or_default();
        let (says, is_ready) = (ready.contains(&named), ready.contains("READY=1"));
        assert!(says && is_ready, "{kind}: {ready}");
        manager.expect("WATCHDOG=1");
        let observer = Client::connect_in(&scene.place.domain(), "town", PATIENCE);
        observer.expect("observers attach").snapshot().verify().expect("whole");
        match scene.subscribe(PATIENCE) {
            Err(ClientError::Attach(AttachError::PermissionDenied { path, owner, .. })) => {
                assert_eq!((path, owner), (counter.clone(), USER), "{kind}");
            }
            other => panic!("{kind}: {:?}", other.err()),
        }
        let status = scene.place.command().arg("status").output().expect("runs");
        let status = String::from_utf8_lossy(&status.stdout).into_owned();
        assert!(
            status.contains(&format!("without subscribers, who need that name: {named}")),
            "{status}"
        );
        match scene.place.ask("town", &Request::Status) {
            Some(Response::Status(status)) => {
                assert_eq!(status.without_subscribers.as_ref(), Some(&named), "{kind}");
                assert_eq!(status.maps[0].subscribers, None);
            }
            other => panic!("{kind}: {other:?}"),
        }
        let lines = scene.doctor("other users' files");
        assert!(lines.iter().any(|(state, found)| state == "problem" && found.contains(&named)));
        assert_eq!(daemon.stop(), Some(0));
        assert_eq!(fs::symlink_metadata(&counter).expect("a stranger's").uid(), USER);
        assert!(!scene.place.domain().root().exists());
    }
}

/// All that a daemon does, it does for observers alone, too; whatever the stranger does with his file meanwhile.
#[test]
fn observers_are_served_without_subscribers() {
    let Some(scene) = Scene::new() else { return };
    let (folder, maps) = (tempfile::tempdir().expect("a folder"), TwoMaps::new());
    let counter = scene.at(COUNTER);
    scene.stranger(&format!("printf '{COUNTED}' > \"$1\""), &counter);
    let toggle = "while :; do : > \"$1\"; truncate -s 16 \"$1\"; done";
    let mut toggles = scene.shell(toggle, &counter).spawn().expect("starts");
    let mut program = scene.place.command();
    program.arg("--load").arg(maps.path()).args(["--scrub", "1", "--metrics", "127.0.0.1:0"]);
    let daemon = scene.spawn(&folder.path().join("log"), &mut program);
    let client = Client::connect_in(&scene.place.domain(), "map", PATIENCE).expect("attaches");
    let first = client.snapshot();
    let ours = || {
        let segments = scene.place.segments().into_iter();
        segments.filter(|path| path.extension().is_some_and(|end| end == "data")).count()
    };
    let map = || "map".to_owned();
    for round in 1..4 {
        maps.put(round);
        let report = scene.place.reload("map");
        assert_eq!(report.result, ReloadResult::Published, "{}", report.reason);
        let next = client.wait_next(PATIENCE).expect("a generation");
        assert_eq!(Some(next.generation()), report.generation);
        next.verify().expect("whole");
        assert_eq!(ours(), 1, "the one before is gone");
    }
    maps.put(4);
    let staged = scene.place.change("map", &Request::Reload { map: map(), stage: true });
    assert_eq!(client.pending().map(|info| info.generation), staged.generation);
    let active = scene.place.change("map", &Request::Activate { map: map() });
    assert_eq!((active.result, active.generation), (ReloadResult::Published, staged.generation));
    let held = scene.place.state("map").held;
    assert_eq!(held.len(), 2, "{held:?}");
    let back = scene.place.change("map", &Request::Rollback { map: map(), stage: false });
    assert_eq!(back.result, ReloadResult::Published, "{}", back.reason);
    client.wait_next(PATIENCE).expect("a generation").verify().expect("whole");
    first.verify().expect("whole, as long as it is held");
    let state = || scene.place.state("map");
    until("a scrub", || (state().scrubs.ok > 0).then_some(()));
    assert_eq!((state().scrubs.failures, state().self_queries.failures), (0, 0));
    let address = until("an address", || {
        let said = daemon.said();
        let rest = said.split_once("metrics at http://")?.1;
        rest.split_once("/metrics").map(|(address, _)| address.to_owned())
    });
    let mut page = String::new();
    let mut stream = TcpStream::connect(&address).expect("connects");
    write!(stream, "GET /metrics HTTP/1.1\r\nHost: {address}\r\n\r\n").expect("written");
    stream.read_to_string(&mut page).expect("an answer");
    assert!(page.lines().any(|line| line == "mapd_serves_subscribers 0.0"), "{page}");
    // A killed one's successor goes on, and clears away what it left, beside a daemon that lives.
    let second = scene.logged(&folder.path().join("second"), &["--name", "other"]);
    drop(daemon);
    let mut program = scene.place.command();
    program.arg("--load").arg(maps.path());
    let daemon = scene.spawn(&folder.path().join("log"), &mut program);
    client.wait_next(PATIENCE).expect("a generation");
    assert_eq!(ours(), 2, "one for each map");
    toggles.kill().and_then(|()| toggles.wait()).expect("ends");
    assert_eq!((second.stop(), daemon.stop()), (Some(0), Some(0)));
    assert_eq!(ours(), 0);
}

/// iceoryx2 opens queues by their names when it cleans up, and waits for an empty one without end: a stranger who read a publisher's name could stop the daemon for ever.
#[test]
fn a_queue_that_a_stranger_names_does_not_stop_the_clean_up() {
    let Some(scene) = Scene::new() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let daemon = scene.logged(&folder.path().join("log"), &[]);
    // It keeps the domain from being emptied, so that the successor has iceoryx2 clean up.
    let holder = scene.subscribe(PATIENCE).expect("subscribes");
    let data = scene
        .place
        .segments()
        .into_iter()
        .find(|path| path.extension().is_some_and(|end| end == "data"));
    let data = data.expect("a segment").file_stem().expect("a name").to_string_lossy().into_owned();
    let publisher = data.rsplit_once('_').expect("an id").1.to_owned();
    scene.stranger(": > \"$1\"", &scene.at(&format!("{QUEUE}_{publisher}_77.connection")));
    scene.stranger("echo x > \"$1\"", &scene.at(&format!("{QUEUE}_{publisher}_78.connection")));
    drop(daemon);
    let daemon = scene.logged(&folder.path().join("log"), &[]);
    holder.wait_next(PATIENCE).expect("a generation of the successor");
    let failed = "could not clean up";
    assert!(!daemon.said().contains(failed), "{}", daemon.said());
    assert_eq!(daemon.stop(), Some(0));
}

/// A publisher's name is seen before its queues are made, and iceoryx2 opens whatever has a queue's name: a stranger who was faster, which is easy, had daemon and subscriber map
/// a file that he can truncate.
#[test]
fn a_stranger_who_is_faster_stops_no_generation() {
    let Some(scene) = Scene::new() else { return };
    let (maps, place) = (TwoMaps::new(), &scene.place);
    let mut command = place.command();
    command.arg("--load").arg(maps.path());
    let (traced, _) = match Traced::start(&command, "", Stdio::null()) {
        Err(error) if error.raw_os_error() == Some(Errno::EPERM as i32) => {
            return mapd_tests::say("SKIPPED: tracing is not permitted");
        }
        started => started.expect("starts"),
    };
    let named = |ending: &str| -> Vec<String> {
        let names = place.segments().into_iter();
        let names = names.filter(|path| path.extension().is_some_and(|end| end == ending));
        names.map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned()).collect()
    };
    let last = |name: &String| name.rsplit_once('_').expect("an id").1.to_owned();
    let (pid, known) = (traced.pid(), Mutex::new(None));
    let squatted = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        let follows = scope.spawn(|| {
            let subscribe =
                || Client::connect_as(Attach::Subscriber, &place.domain(), "map", PATIENCE);
            let client = subscribe().expect("subscribes");
            let first = client.snapshot();
            // The daemon listens a moment after it serves.
            place.state("map");
            *known.lock().expect("no panic") = Some(named("data"));
            maps.put(1);
            let report = place.reload("map");
            assert_eq!(report.result, ReloadResult::Published, "{}", report.reason);
            let next = client.wait_next(PATIENCE).expect("a generation");
            assert_eq!(Some(next.generation()), report.generation);
            next.verify().and_then(|()| first.verify()).expect("whole");
            drop(next);
            subscribe().expect("newcomers attach");
            kill(pid, Signal::SIGTERM).expect("its own child");
        });
        let ended = traced.run(|moment| {
            let mut known = known.lock().expect("no panic");
            let is_first = moment.thread == 0 && moment.side == Side::After;
            if let (true, Some(before)) = (is_first, known.as_ref()) {
                let all = named("data");
                let new: Vec<_> = all.iter().filter(|name| !before.contains(name)).collect();
                for (publisher, queue) in new.iter().flat_map(|name| {
                    named("connection").into_iter().map(|queue| (last(name), queue))
                }) {
                    let name = format!("{QUEUE}_{publisher}_{}.connection", last(&queue));
                    File::create_new(scene.at(&name)).expect("nobody was faster");
                    std::os::unix::fs::chown(scene.at(&name), Some(USER), None).expect("given");
                    squatted.fetch_add(1, Ordering::Relaxed);
                }
                if !new.is_empty() {
                    *known = None;
                }
            }
            Then::Continue
        });
        follows.join().expect("follows");
        assert_eq!(ended.expect("runs").code(), Some(0));
    });
    assert!(squatted.into_inner() > 0, "nothing was in the way");
}

/// Somebody else's folder, link or file under the root folder's name: the error names it and its owner, for whoever meets it.
#[test]
fn a_strangers_root_folder_is_named() {
    for kind in ["mkdir -m 755 \"$1\"", "ln -s /tmp \"$1\"", ": > \"$1\"", "mkfifo \"$1\""] {
        let Some(scene) = Scene::new() else { return };
        let root = scene.place.domain().root().to_owned();
        scene.stranger(kind, &root);
        let words = format!("{} belongs to user {USER}", root.display());
        for args in [
            &["--load", &town(), "--no-cache"][..],
            &["status"],
            &["reload", "town"],
            &["overlay", "town", "list"],
            &["inspect", "shm:town"],
            &["inspect", "shm:town", "--attach", "subscriber"],
            &["doctor"],
        ] {
            let output = scene.place.command().args(args).output().expect("ends");
            let said = [output.stdout, output.stderr].concat();
            let said = String::from_utf8_lossy(&said).into_owned();
            assert_eq!(output.status.code(), Some(1), "{kind} {args:?}: {said}");
            assert!(said.contains(&words), "{kind} {args:?}: {said}");
        }
    }
}

/// What belongs to somebody else in a cache folder that others can write to is not there, but where it must not be overlooked.
#[test]
fn a_strangers_files_in_the_cache_are_not_used() {
    let Some(scene) = Scene::new() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let log = folder.path().join("log");
    assert_eq!(scene.logged(&log, &[]).stop(), Some(0));
    let daemon = scene.logged(&log, &[]);
    assert!(daemon.said().contains("from the cache"), "{}", daemon.said());
    assert_eq!(daemon.stop(), Some(0));
    let files: Vec<PathBuf> = fs::read_dir(scene.place.cache())
        .expect("a folder")
        .flatten()
        .map(|entry| entry.path())
        .collect();
    for file in &files {
        fs::set_permissions(file, fs::Permissions::from_mode(0o644)).expect("changed");
        std::os::unix::fs::chown(file, Some(USER), None).expect("given away");
    }
    let daemon = scene.logged(&log, &[]);
    assert!(!daemon.said().contains("from the cache"), "{}", daemon.said());
    assert_eq!(daemon.stop(), Some(0));
    let kept =
        scene.place.cache().join(format!("{}town.overlay.json", scene.place.domain().prefix()));
    fs::write(&kept, "{\"entries\": []}").expect("written");
    std::os::unix::fs::chown(&kept, Some(USER), None).expect("given away");
    let refused = scene.place.command().args(["--load", &town()]).output().expect("ends");
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    let words = format!("belongs to user {USER}");
    assert!(said.contains(&words) && said.contains("town.overlay.json"), "{said}");
}
