//! Too little of something: memory, places, rights; and other releases in the way. Each has its own clear error, and
//! leaves nothing behind.
//!
//! Some need a mount namespace or a control group of their own, which only root can make; they say aloud that they skip
//! where that is not allowed.

use iceoryx2::prelude::{NodeBuilder, ServiceName, SignalHandlingMode};
use mapd_client::{Attach, Client, ClientError};
use mapd_tests::say;
use mapd_tests::test_domain::{PATIENCE, TestDomain, until};
use mapd_transport::{
    AttachError, Chunk64, GenerationInfo, MAX_SUBSCRIBERS, Subscription, TransportService,
    iceoryx2_config, service_name, wake_name,
};
use std::fs::File;
use std::os::unix::fs::FileExt;
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};
use std::time::{Duration, Instant};

const PROBE: &str = env!("CARGO_BIN_EXE_planner_probe");
const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// A user without rights.
const NOBODY: &str = "65534";

fn place() -> TestDomain {
    TestDomain::new(MAPD)
}

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

/// Runs a shell script with `/dev/shm` replaced by an empty file system of so many KiB; `None` where that is not allowed.
fn with_small_shared_memory(place: &TestDomain, kilobytes: u32, script: &str) -> Option<Output> {
    let mount = format!("mount -t tmpfs -o size={kilobytes}k none /dev/shm");
    let unshare = || {
        let mut command = place.command_of("unshare");
        command.args(["--mount", "sh", "-c"]);
        command
    };
    if !unshare().arg(&mount).output().is_ok_and(|output| output.status.success()) {
        say("SKIPPED: this user may not mount a small /dev/shm of its own");
        return None;
    }
    Some(unshare().arg(format!("{mount} && {script}")).output().expect("the script runs"))
}

/// What a script said, and how it ended.
fn told(output: &Output) -> String {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    format!("{:?}: {}{}", output.status.code(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn too_small_at_the_start() {
    let place = place();
    let script = format!("{MAPD} --load {}; echo ended $?; ls -A /dev/shm", town());
    let Some(output) = with_small_shared_memory(&place, 512, &script) else { return };
    let text = told(&output);
    assert!(text.contains("bytes of shared memory") && text.contains("/dev/shm"), "{text}");
    assert!(text.contains("ended 1\n"), "{text}");
    let left = String::from_utf8_lossy(&output.stdout).lines().count();
    assert_eq!(left, 1, "something is left behind: {text}");
}

/// A subscriber that comes when shared memory is full is told so, and attaches once there is room; an observer needs none. The daemon
/// serves on.
#[test]
fn full_when_a_client_attaches() {
    let place = place();
    // A daemon that cleans up on a busy machine may keep the lock for longer than one attempt.
    let script = format!(
        "{MAPD} --load {} & while ! {PROBE} ask town 1000 >/dev/null 2>&1; do sleep 0.02; done; \
         head -c 100M /dev/zero > /dev/shm/filler 2>/dev/null; \
         for attempt in $(seq 60); do \
         said=$(PROBE_ATTACH=subscriber {PROBE} connect town 300); code=$?; \
         case $said in *'stayed locked'*) ;; *) break ;; esac; done; \
         echo \"$said\"; echo refused $code; \
         {PROBE} ask town 10000; echo observed $?; \
         {{ sleep 0.2; echo; }} | {PROBE} wait town 300; echo waited $?; rm /dev/shm/filler; \
         {PROBE} ask town 10000; echo attached $?; \
         kill $!; wait $!; echo ended $?; ls -A /dev/shm",
        town()
    );
    let Some(output) = with_small_shared_memory(&place, 8192, &script) else { return };
    let text = told(&output);
    let all = [
        "error attaching needs ",
        "left by /dev/shm",
        "refused 1\n",
        "observed 0\n",
        "held ",
        "waited 1\n",
        "attached 0\n",
        "ended 0\n",
    ];
    all.iter().for_each(|part| assert!(text.contains(part), "{part:?} is missing in {text}"));
    assert!(output.stdout.ends_with(b"ended 0\n"), "left behind: {text}");
}

/// Steps of a script with files in this folder. The first starts a client, `$waiting`, and goes on when it has attached; what it says is in
/// the file `$said`. The second has it wait for the next generation, so long \[ms\].
fn waiting_client(folder: &Path, wait: u32) -> (String, String) {
    let (told, said) = (folder.join("told"), folder.join("said"));
    let (told, said) = (told.display(), said.display());
    let start = format!(
        "said={said}; mkfifo {told}; {PROBE} wait town {wait} < {told} > $said & waiting=$!; exec 3> {told}; \
         while kill -0 $waiting && ! grep -q attached $said; do sleep 0.02; done;"
    );
    (start, "echo >&3; exec 3>&-;".to_owned())
}

/// A client that holds a generation and waits for the next keeps what it has.
#[test]
fn full_while_a_client_waits() {
    let place = place();
    let folder = tempfile::tempdir().expect("a folder");
    let (start, tell) = waiting_client(folder.path(), 400);
    let script = format!(
        "{MAPD} --load {} & daemon=$!; \
         while ! {PROBE} ask town 1000 >/dev/null 2>&1; do sleep 0.02; done; \
         {start} head -c 100M /dev/zero > /dev/shm/filler 2>/dev/null; \
         {tell} wait $waiting; echo waited $?; cat $said; rm /dev/shm/filler; \
         {PROBE} ask town 10000; echo attached $?; \
         kill $daemon; wait $daemon; echo ended $?; ls -A /dev/shm",
        town()
    );
    let Some(output) = with_small_shared_memory(&place, 8192, &script) else { return };
    let text = told(&output);
    let held = text.split_once("attached ").and_then(|(_, rest)| rest.lines().next());
    let held = format!("held {}\n", held.expect("a generation"));
    let all = [held.as_str(), "error ", "waited 1\n", "attached 0\n"];
    all.iter().for_each(|part| assert!(text.contains(part), "{part:?} is missing in {text}"));
    assert!(output.stdout.ends_with(b"ended 0\n"), "left behind: {text}");
}

/// A reload for which there is no room is refused, with the reason, and what is served stays; then it works.
#[test]
fn full_when_a_map_is_reloaded() {
    let place = place();
    let folder = tempfile::tempdir().expect("a folder");
    let (start, tell) = waiting_client(folder.path(), 20_000);
    let script = format!(
        "cp {} /tmp/$$.xodr; {MAPD} --load /tmp/$$.xodr --name town & daemon=$!; \
         while ! {PROBE} ask town 1000 >/dev/null 2>&1; do sleep 0.02; done; \
         {start} echo >> /tmp/$$.xodr; head -c 100M /dev/zero > /dev/shm/filler 2>/dev/null; \
         {MAPD} reload town; echo refused $?; rm /dev/shm/filler; \
         {MAPD} status --json | grep '\"reason\"'; \
         {PROBE} ask town 10000; echo attached $?; \
         {tell} {MAPD} reload town; echo reloaded $?; wait $waiting; echo waited $?; cat $said; \
         kill $daemon; wait $daemon; echo ended $?; rm /tmp/$$.xodr; ls -A /dev/shm",
        town()
    );
    let Some(output) = with_small_shared_memory(&place, 8192, &script) else { return };
    let text = told(&output);
    let all = [
        "refused 4\n",
        "bytes of shared memory",
        "\"reason\": \"map ",
        "attached 0\n",
        "reloaded 0\n",
        "waited 0\n",
    ];
    all.iter().for_each(|part| assert!(text.contains(part), "{part:?} is missing in {text}"));
    assert!(output.stdout.ends_with(b"ended 0\n"), "left behind: {text}");
}

/// Shared memory that is mounted read-only or is not there at all: a clear error. (Under a running daemon the kernel refuses to
/// make it read-only.)
#[test]
fn a_root_folder_that_cannot_be_made() {
    let place = place();
    let script = format!(
        "cp {} /tmp/$$.xodr; mount -o remount,ro /dev/shm; \
         timeout 20 {MAPD} --load /tmp/$$.xodr --name town; echo read-only $?; \
         umount /dev/shm; mount -t tmpfs none /dev; \
         timeout 20 {MAPD} --load /tmp/$$.xodr --name town; echo missing $?; rm /tmp/$$.xodr",
        town()
    );
    let Some(output) = with_small_shared_memory(&place, 8192, &script) else { return };
    let text = told(&output);
    let all =
        ["read-only 1\n", "missing 1\n", "Read-only file system", "No such file", "/dev/shm/"];
    all.iter().for_each(|part| assert!(text.contains(part), "{part:?} is missing in {text}"));
}

/// A control group of version 1 or 2 with this memory limit; removed at the end.
struct Group(PathBuf);

impl Group {
    fn new(limit: u64) -> Option<Self> {
        let name = format!("mapd-test-{}", std::process::id());
        let versions =
            [("/sys/fs/cgroup/memory", "memory.limit_in_bytes"), ("/sys/fs/cgroup", "memory.max")];
        for (root, file) in versions {
            let folder = Path::new(root).join(&name);
            if std::fs::create_dir(&folder).is_err() {
                continue;
            }
            let group = Self(folder);
            if std::fs::write(group.0.join(file), limit.to_string()).is_ok() {
                return Some(group);
            }
        }
        None
    }
}

impl Drop for Group {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir(&self.0);
    }
}

#[test]
fn a_control_group_below_the_archive() {
    // Enough for the program, which needs about a tenth of it, not for the archive.
    const LIMIT: u64 = 200 << 20;
    let Some(group) = Group::new(LIMIT) else {
        return say("SKIPPED: this user may not make a control group that limits memory");
    };
    let place = place();
    let folder = tempfile::tempdir().expect("a folder");
    let big = folder.path().join("big.mapd");
    let mut rows = mapd_archive::Rows::default();
    rows.coefficients.resize((LIMIT as usize) / size_of::<f64>(), 1.0);
    let archive =
        mapd_archive::encode(&rows, &mapd_archive::Provenance::default()).expect("encodes");
    std::fs::write(&big, &archive).expect("written");
    let script = format!(
        "echo $$ > {}/cgroup.procs && exec {MAPD} --load {}",
        group.0.display(),
        big.display()
    );
    let output = place.command_of("sh").args(["-c", &script]).output().expect("ends");
    let text = told(&output);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("control group"), "{text}");
    assert!(place.segments().is_empty() && !place.domain().root().exists(), "left behind");
}

#[test]
fn more_clients_than_places() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let domain = place.domain();
    let attach = || Subscription::connect(&domain, "town", Instant::now() + PATIENCE);
    let all: Vec<_> = (0..MAX_SUBSCRIBERS).map(|_| attach().expect("a place")).collect();
    // A daemon that cleans up on a busy machine may keep the lock for so long.
    let error = until("an answer", || {
        let deadline = Instant::now() + Duration::from_millis(200);
        match Subscription::connect(&domain, "town", deadline).expect_err("no place is left") {
            AttachError::Busy { .. } => None,
            error => Some(error),
        }
    });
    assert!(matches!(error, AttachError::TooManySubscribers { .. }), "{error}");
    assert!(error.to_string().contains(&MAX_SUBSCRIBERS.to_string()), "{error}");
    drop(all);
    attach().expect("places are free again");
}

/// As another user, if this one may become another.
fn as_nobody(place: &TestDomain, program: &str, args: &[&str]) -> Option<Output> {
    let become_nobody = |program: &str| {
        let mut command = place.command_of("setpriv");
        command.args(["--reuid", NOBODY, "--regid", NOBODY, "--clear-groups", program]);
        command
    };
    if !become_nobody(program)
        .arg("--version")
        .output()
        .is_ok_and(|o| o.status.code() != Some(127) && o.status.code() != Some(126))
    {
        return None;
    }
    let possible = become_nobody("true").output().is_ok_and(|output| output.status.success());
    possible.then(|| become_nobody(program).args(args).output().expect("ends"))
}

#[test]
fn another_user_is_told_so() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    // Programs must lie where everybody may run them.
    let folder = tempfile::tempdir_in("/tmp").expect("a folder");
    let everybody = std::os::unix::fs::PermissionsExt::from_mode(0o755);
    std::fs::set_permissions(folder.path(), everybody).expect("open to all");
    let copy = |program: &str, name: &str| {
        let path = folder.path().join(name);
        std::fs::copy(program, &path).expect("copied");
        path.display().to_string()
    };
    let (probe, mapd) = (copy(PROBE, "probe"), copy(MAPD, "mapd"));
    let map = copy(&town(), "town.xodr");
    let Some(client) = as_nobody(&place, &probe, &["connect", "town", "2000"]) else {
        return say("SKIPPED: this user may not become another one");
    };
    let text = told(&client);
    assert!(!client.status.success() && text.contains("as one user"), "{text}");
    let daemon =
        as_nobody(&place, &mapd, &["--load", &map, "--no-cache"]).expect("possible as before");
    let text = told(&daemon);
    assert_eq!(daemon.status.code(), Some(1), "{text}");
    assert!(text.contains("as one user"), "{text}");
    Client::connect_in(&place.domain(), "town", PATIENCE).expect("the first still serves");
}

/// Another version of iceoryx2 writes another version into what it shares. Here that number is changed by hand.
#[test]
fn another_version_of_iceoryx2_is_told_so() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let mut changed = 0;
    for path in place.segments() {
        if path.extension().is_some_and(|extension| extension == "dynamic") {
            let mut bytes = std::fs::read(&path).expect("readable");
            bytes[0] ^= 0x40;
            std::fs::write(&path, bytes).expect("writable");
            changed += 1;
        }
    }
    assert!(changed > 0, "the daemon shares nothing");
    let subscriber = Client::connect_as(Attach::Subscriber, &place.domain(), "town", PATIENCE);
    let error = subscriber.err().expect("refused");
    assert!(matches!(error, ClientError::Attach(AttachError::WrongTransport { .. })), "{error}");
    // Observers have no part in iceoryx2.
    Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
}

/// A daemon of another transport revision has published, and its services have other names.
#[test]
fn another_transport_revision_is_told_so() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let root = place.domain().root().to_owned();
    let record = File::options().read(true).write(true).open(root.join("town.published"));
    let (record, mut revision) = (record.expect("the record"), [0; 4]);
    record.read_exact_at(&mut revision, 8).expect("a revision");
    assert_eq!(u32::from_le_bytes(revision), mapd_transport::TRANSPORT_REVISION);
    record.write_all_at(&99_u32.to_le_bytes(), 8).expect("written");
    for entry in std::fs::read_dir(root.join("services")).expect("services").flatten() {
        std::fs::remove_file(entry.path()).expect("removed");
    }
    for attach in [Attach::Observer, Attach::Subscriber] {
        let connected = Client::connect_as(attach, &place.domain(), "town", PATIENCE);
        let error = connected.err().expect("refused");
        assert!(
            matches!(error, ClientError::Attach(AttachError::WrongTransport { .. })),
            "{error}"
        );
        assert!(error.to_string().contains("99"), "{error}");
    }
}

/// A client of another release lives on, with the service it has open. Here one makes it with fewer places.
#[test]
fn other_limits_of_a_living_client_are_told() {
    let place = place();
    // Makes the root folder, and ends.
    place.serve(&[&town()]).kill();
    for map_service in [true, false] {
        let domain = place.domain();
        let config = iceoryx2_config(&domain).expect("a configuration");
        let presence = mapd_transport::Presence::enter(&domain).expect("present");
        let node = NodeBuilder::new()
            .config(&config)
            .signal_handling_mode(SignalHandlingMode::Disabled)
            .create::<TransportService>()
            .expect("a node");
        let name = |text: String| ServiceName::new(&text).expect("a name");
        let mut services: (Option<_>, Option<_>) = (None, None);
        if map_service {
            let service = node
                .service_builder(&name(service_name("other")))
                .publish_subscribe::<[Chunk64]>()
                .user_header::<GenerationInfo>()
                .max_subscribers(2)
                .create();
            services.0 = Some(service.expect("a service"));
        } else {
            let service = node.service_builder(&name(wake_name("other"))).event().max_notifiers(2);
            services.1 = Some(service.create().expect("a service"));
        }
        let output = place
            .command()
            .args(["--load", &town(), "--name", "other"])
            .stdout(Stdio::null())
            .output()
            .expect("ends");
        let text = told(&output);
        assert_eq!(output.status.code(), Some(1), "{text}");
        assert!(text.contains("other limits"), "{text}");
        drop((services, node, presence));
    }
    // With the client gone the map can be served: also with the descriptors that children of other tests have until they execute another
    // program.
    until("a daemon that serves", || {
        place.start(&[&town(), "--name", "other"]).wait_for_serving().ok()
    });
}
