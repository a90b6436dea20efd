//! What a daemon shows while it runs: logs, metrics, the service manager's socket, proofs of what is served.

use mapd_tests::json_schema::{schema, wrong};
use mapd_tests::manager::{Manager, WATCHDOG};
use mapd_tests::test_domain::{PATIENCE, TestDomain, until};
use mapd_transport::{AttachLock, Subscription};
use serde_json::Value;
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::net::TcpStream;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Child, ChildStderr, Command};
use std::time::{Duration, Instant};

/// Queries in an interval: see `oversight::attendant`.
const PER_INTERVAL: u32 = 3;

fn place() -> TestDomain {
    TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"))
}

fn town() -> String {
    mapd_tests::carried("town.xodr").display().to_string()
}

/// A daemon whose log is read line by line; killed at the end.
struct Logged {
    child: Child,
    lines: BufReader<ChildStderr>,
    /// What a line of JSON is held to.
    schema: Value,
}

impl Logged {
    fn start(command: &mut Command, args: &[&str]) -> Self {
        Self::spawn(command.arg("--load").arg(town()).args(args))
    }

    fn spawn(command: &mut Command) -> Self {
        let mut child = command.spawn().expect("starts");
        let lines = BufReader::new(child.stderr.take().expect("stderr"));
        Self { child, lines, schema: schema("log") }
    }

    fn line(&mut self) -> Option<String> {
        let mut line = String::new();
        let read = self.lines.read_line(&mut line).expect("stderr can be read");
        (read > 0).then(|| line.trim_end().to_owned())
    }

    /// The next line of JSON whose message holds these words.
    fn event(&mut self, words: &str) -> Value {
        loop {
            let line = self.line().expect("the daemon ended");
            let event: Value = serde_json::from_str(&line).expect("a line of JSON");
            assert_eq!(wrong(&self.schema, &event), None, "{line}");
            if event["message"].as_str().is_some_and(|message| message.contains(words)) {
                return event;
            }
        }
    }

    fn terminate(&mut self) -> Option<i32> {
        let pid = self.child.id().to_string();
        assert!(Command::new("kill").args(["-TERM", &pid]).status().expect("kill runs").success());
        self.child.wait().expect("waited for").code()
    }
}

impl Drop for Logged {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn get(address: &str, request: &str) -> String {
    let mut stream = TcpStream::connect(address).expect("connects");
    write!(stream, "{request}\r\nHost: {address}\r\n\r\n").expect("written");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("an answer");
    answer
}

/// The value of a line of the metrics.
fn metric(address: &str, line: &str) -> Option<f64> {
    let page = get(address, "GET /metrics HTTP/1.1");
    page.lines().find_map(|l| l.strip_prefix(line)?.trim().parse().ok())
}

#[test]
fn logs_as_text_and_as_json_and_as_grave_as_wanted() {
    let place = place();
    let mut daemon = Logged::start(&mut place.command(), &[]);
    let text = until("the line", || daemon.line().filter(|line| line.contains("serving")));
    assert!(text.starts_with("mapd: serving town, generation "), "{text}");
    assert_eq!(daemon.terminate(), Some(0));
    assert_eq!(daemon.line().as_deref(), Some("mapd: stopped"));

    let mut daemon = Logged::start(
        &mut place.command(),
        &["--log", "json", "--log-level", "debug", "--metrics", "127.0.0.1:0"],
    );
    let event = daemon.event("serving");
    assert_eq!((&event["map"], &event["level"]), (&"town".into(), &"INFO".into()));
    assert!(event["generation"].is_u64() && event["bytes"].is_u64(), "{event}");
    assert!(event["timestamp"].as_str().is_some_and(|time| time.contains('T')), "{event}");
    daemon.event("ready");
    assert_eq!(daemon.terminate(), Some(0));
    daemon.event("stopped");

    let mut daemon = Logged::start(&mut place.command(), &["--log-level", "error"]);
    until("a generation", || {
        place.command().args(["inspect", "shm:town"]).status().ok().filter(|s| s.success())
    });
    assert_eq!(daemon.terminate(), Some(0));
    assert_eq!(daemon.line(), None);
}

/// With `--log json`, the error that ended the daemon was a line of text.
#[test]
fn errors_that_end_a_daemon_are_in_its_log() {
    let place = place();
    let mut first = Logged::start(&mut place.command(), &["--log", "json"]);
    first.event("serving");
    let (schema, missing) = (schema("log"), "nofile.toml");
    for (args, exit, words) in [
        (&["--no-cache"][..], 1, "is served by process"),
        (&["--overlay-from", missing], 2, missing),
        (&["--metrics", "0.0.0.0:0"], 2, "--metrics-open"),
        (&["--metrics-open"], 2, "--metrics-open goes with --metrics"),
        (&["--prefix", "no/prefix"], 2, "no/prefix"),
        (&["--no-cache", "--last-good"], 2, "--last-good needs the cache"),
        (&["--no-cache", "--cache-size", "1GiB"], 2, "--cache-size needs the cache"),
    ] {
        let ended = |format: &str| {
            let load = ["--load", &town(), "--log", format];
            let ended = place.command().args(load).args(args).output().expect("ends");
            let said = String::from_utf8(ended.stderr).expect("text");
            assert_eq!(ended.status.code(), Some(exit), "{args:?}: {said}");
            said
        };
        let said = ended("json");
        let mut events = said.lines().map(|line| {
            let event: Value = serde_json::from_str(line).expect("a line of JSON");
            assert_eq!(wrong(&schema, &event), None, "{line}");
            event
        });
        let last = events.next_back().expect("a line");
        let message = last["message"].as_str().expect("a text");
        assert!(last["level"] == "ERROR" && message.contains(words), "{args:?}: {last}");
        // Text is as it was: the same words, without a level.
        let text = ended("text");
        assert_eq!(text.lines().last(), Some(format!("mapd: {message}").as_str()));
    }
    assert_eq!(first.terminate(), Some(0));
}

/// What the configuration file says counts where the command line is silent.
#[test]
fn a_configuration_file_may_say_it() {
    let (place, folder) = (place(), tempfile::tempdir().expect("a folder"));
    let file = folder.path().join("mapd.toml");
    let text = format!(
        "metrics = '127.0.0.1:0'\nscrub = 1\nno_cache = true\n[[map]]\nfile = '{}'\n",
        town()
    );
    std::fs::write(&file, &text).expect("written");
    let mut command = place.command();
    command.arg("--config").arg(&file).args(["--log", "json", "--log-level", "debug"]);
    let mut daemon = Logged::spawn(&mut command);
    daemon.event("metrics at");
    daemon.event("proves");
    assert_eq!(daemon.terminate(), Some(0));
    std::fs::write(&file, format!("trust = 'missing.pub'\n{text}")).expect("written");
    let refused = place.command().arg("--config").arg(&file).output().expect("ends");
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(refused.status.code() == Some(1) && said.contains("missing.pub"), "{said}");
}

#[test]
fn metrics_are_read_over_http_by_this_machine_only() {
    let place = place();
    let args = ["--log", "json", "--metrics", "127.0.0.1:0"];
    let mut daemon = Logged::start(&mut place.command(), &args);
    let serving = daemon.event("serving");
    let generation = serving["generation"].as_f64();
    let event = daemon.event("metrics at");
    let address = event["address"].as_str().expect("an address").to_owned();
    for (line, value) in [
        ("mapd_map_generation{map=\"town\"}", generation.expect("a number")),
        ("mapd_map_reload_failures_total{map=\"town\"}", 0.0),
        ("mapd_checks_total{map=\"town\",check=\"self_query\",result=\"failed\"}", 0.0),
    ] {
        assert_eq!(metric(&address, line), Some(value), "{line}");
    }
    let bytes = serving["bytes"].as_f64().filter(|bytes| *bytes > 0.0);
    assert_eq!(metric(&address, "mapd_map_archive_bytes{map=\"town\"}"), bytes, "{serving}");
    assert!(metric(&address, "mapd_shared_memory_free_bytes").is_some_and(|b| b > 0.0));
    let ok = "mapd_checks_total{map=\"town\",check=\"self_query\",result=\"ok\"}";
    until("a query of the daemon's own", || metric(&address, ok).filter(|count| *count >= 1.0));
    assert!(get(&address, "GET / HTTP/1.1").starts_with("HTTP/1.1 404"));
    assert!(get(&address, "GET /metrics?from=here HTTP/1.1").starts_with("HTTP/1.1 200"));
    let head = get(&address, "HEAD /metrics HTTP/1.1");
    assert!(head.contains("\r\nCross-Origin-Resource-Policy: same-origin\r\n"), "{head}");
    assert!(head.starts_with("HTTP/1.1 200") && head.ends_with("\r\n\r\n"), "{head}");
    let post = get(&address, "POST /metrics HTTP/1.1");
    assert!(
        post.starts_with("HTTP/1.1 405") && post.contains("\r\nAllow: GET, HEAD\r\n"),
        "{post}"
    );
    // Who connects and says nothing, or too much, is let go; the page is there again for others, and the map all along.
    let silent = TcpStream::connect(&address).expect("connects");
    let client = mapd_client::Client::connect_in(&place.domain(), "town", PATIENCE);
    client.expect("attaches");
    assert_eq!(metric(&address, "mapd_map_generation{map=\"town\"}"), generation);
    drop(silent);
    let mut endless = TcpStream::connect(&address).expect("connects");
    let _ = endless.write_all(&vec![b'x'; 1 << 20]);
    assert_eq!(metric(&address, "mapd_map_generation{map=\"town\"}"), generation);
    assert_eq!(daemon.terminate(), Some(0));

    let open = ["--load", &town(), "--metrics", "0.0.0.0:0"];
    let refused = place.command().args(open).output().expect("ends");
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(refused.status.code() == Some(2) && said.contains("--metrics-open"), "{said}");
}

/// A page of somebody else whose name leads here, as by DNS rebinding, read the names of all maps.
#[test]
fn metrics_are_asked_for_by_a_name_of_this_machine() {
    let place = place();
    for (listen, is_open) in [("127.0.0.1:0", false), ("0.0.0.0:0", true)] {
        let args = ["--log", "json", "--metrics", listen, "--metrics-open"];
        let args = if is_open { &args[..] } else { &args[..4] };
        let mut daemon = Logged::start(&mut place.command(), args);
        let address = daemon.event("metrics at")["address"].as_str().expect("text").to_owned();
        let port = address.rsplit(':').next().expect("a port").to_owned();
        let status = |method: &str, hosts: &[&str]| {
            let mut stream = TcpStream::connect(format!("127.0.0.1:{port}")).expect("connects");
            let hosts: String = hosts.iter().map(|host| format!("Host: {host}\r\n")).collect();
            write!(stream, "{method} /metrics HTTP/1.1\r\n{}\r\n", hosts.replace("PORT", &port))
                .expect("written");
            let mut answer = String::new();
            stream.read_to_string(&mut answer).expect("an answer");
            let is_told = answer.contains("mapd_map");
            (answer.split(' ').nth(1).expect("a status").to_owned(), is_told)
        };
        let [ok, no] = [("200".to_owned(), true), ("403".to_owned(), false)];
        for host in ["127.0.0.1:PORT", "localhost:PORT", "[::1]:PORT"] {
            assert_eq!(status("GET", &[host]), ok, "{host}");
        }
        let other = status("GET", &["192.0.2.1:PORT"]);
        assert_eq!(other, if is_open { ok.clone() } else { no.clone() });
        for host in ["evil.example:PORT", "127.0.0.1.evil.example:PORT", "127.0.0.1:1", "evil"] {
            assert_eq!(status("GET", &[host]), no, "{host}");
            assert_eq!(status("HEAD", &[host]), no, "{host}");
        }
        assert_eq!(status("GET", &[]), no);
        assert_eq!(status("GET", &["127.0.0.1:PORT", "evil.example:PORT"]), no);
        assert_eq!(daemon.terminate(), Some(0));
    }
}

/// Metrics and status said that nobody subscribes, whoever did; then they counted the daemon's own subscriptions, by which it looks at what it serves.
#[test]
fn subscribers_are_counted() {
    let place = place();
    let args = ["--log", "json", "--metrics", "127.0.0.1:0"];
    let mut daemon = Logged::start(&mut place.command(), &args);
    let address = daemon.event("metrics at")["address"].as_str().expect("an address").to_owned();
    let clients = || metric(&address, "mapd_map_clients{map=\"town\"}");
    assert_eq!(clients(), Some(0.0));
    let looking = mapd_client::Client::connect_in_reserve(&place.domain(), "town", PATIENCE);
    let looking = looking.expect("attaches as a daemon does");
    let subscriber = mapd_client::Client::connect_as(
        mapd_client::Attach::Subscriber,
        &place.domain(),
        "town",
        PATIENCE,
    );
    let subscriber = subscriber.expect("attaches");
    assert_eq!(clients(), Some(1.0));
    assert_eq!(place.state("town").subscribers, Some(1));
    drop((looking, subscriber));
    assert_eq!(daemon.terminate(), Some(0));
}

/// A reload that failed was information without fields, and the compiler's reason bore the program's name.
#[test]
fn a_failed_reload_is_a_warning() {
    let (place, folder) = (place(), tempfile::tempdir().expect("a folder"));
    let file = folder.path().join("town.xodr");
    std::fs::copy(town(), &file).expect("copied");
    let mut command = place.command();
    let mut daemon = Logged::spawn(command.arg("--load").arg(&file).args(["--log", "json"]));
    daemon.event("serving");
    std::fs::write(&file, mapd_archive::MAGIC).expect("written");
    let _ = place.reload("town");
    let compiler = daemon.event("is an archive");
    let said = compiler["message"].as_str().expect("text");
    assert!(compiler["level"] == "ERROR" && !said.starts_with("mapd:"), "{compiler}");
    let event = daemon.event("reload: failed");
    assert_eq!((&event["level"], &event["map"]), (&"WARN".into(), &"town".into()), "{event}");
    assert!(
        event["error"].as_str().is_some_and(|error| error.contains("is an archive")),
        "{event}"
    );
    assert_eq!(daemon.terminate(), Some(0));
}

/// Who connected and said nothing once kept everybody else waiting, two seconds each.
#[test]
fn no_reader_of_metrics_waits_for_another() {
    const IDLE: usize = 100;
    let place = place();
    let args = ["--log", "json", "--metrics", "127.0.0.1:0"];
    let mut daemon = Logged::start(&mut place.command(), &args);
    let address = daemon.event("metrics at")["address"].as_str().expect("an address").to_owned();
    // On a machine that stands still for longer than they may be silent, another time.
    let is_answered_beside_them = (0..5).any(|_| {
        let idle: Vec<_> =
            (0..IDLE).map(|_| TcpStream::connect(&address).expect("connects")).collect();
        let mut slow = TcpStream::connect(&address).expect("connects");
        write!(slow, "GET /metrics HTTP/1.1\r\nHost: {address}\r\n").expect("written");
        assert!(metric(&address, "mapd_map_generation{map=\"town\"}").is_some());
        let last = idle.last().expect("one");
        last.set_nonblocking(true).expect("set");
        // Who came last is still listened to, who came first has made room.
        let is_open = last.peek(&mut [0]).is_err_and(|e| e.kind() == ErrorKind::WouldBlock);
        assert_eq!(idle[0].peek(&mut [0]).unwrap_or(0), 0, "its place is another's");
        let mut page = String::new();
        let answered = write!(slow, "\r\n").and_then(|()| slow.read_to_string(&mut page));
        is_open && answered.is_ok() && page.contains("mapd_map_generation")
    });
    assert!(is_answered_beside_them);
    assert_eq!(daemon.terminate(), Some(0));
}

#[test]
fn the_service_manager_hears_ready_then_the_watchdog_then_the_end() {
    let (place, manager) = (place(), Manager::new());
    let start = Instant::now();
    let mut daemon = Logged::start(manager.listen_to(&mut place.command()), &[]);
    manager.expect("READY=1");
    // Ready means that a newcomer attaches at once.
    let client = mapd_client::Client::connect_in(&place.domain(), "town", Duration::from_secs(2));
    client.expect("attaches");
    for _ in 0..2 * PER_INTERVAL {
        manager.expect("WATCHDOG=1");
    }
    assert!(start.elapsed() >= 2 * WATCHDOG, "not by time: {:?}", start.elapsed());
    assert_eq!(daemon.terminate(), Some(0));
    loop {
        match manager.hear(PATIENCE).as_deref() {
            Some("STOPPING=1\n") => break,
            Some("WATCHDOG=1\n") => {}
            other => panic!("{other:?} instead of STOPPING=1"),
        }
    }
}

#[test]
fn the_watchdog_falls_silent_where_newcomers_cannot_attach() {
    let (place, manager) = (place(), Manager::new());
    let _daemon = Logged::start(manager.listen_to(&mut place.command()), &[]);
    manager.expect("READY=1");
    manager.expect("WATCHDOG=1");
    let lock = AttachLock::open(&place.domain()).expect("a lock");
    let guard = lock.exclusive(Instant::now() + PATIENCE).expect("locks").expect("in time");
    // One query may have been under way; once another has failed, its ping has been sent.
    let failures = || place.state("town").self_queries.failures;
    let before = failures();
    until("a query that fails", || (failures() > before).then_some(()));
    manager.drain();
    assert_eq!(manager.hear(2 * WATCHDOG), None, "pinged although nobody can attach");
    drop(guard);
    manager.expect("WATCHDOG=1");
}

#[test]
fn the_published_hash_is_of_the_bytes_that_readers_see() {
    let place = place();
    let _daemon = place.serve(&[&town()]);
    let until = Instant::now() + PATIENCE;
    let subscription = Subscription::connect(&place.domain(), "town", until).expect("attaches");
    let pinned = subscription.current();
    let archive = mapd_archive::verify(pinned.bytes()).expect("proves");
    assert_eq!(pinned.info().content_hash, archive.header.content_hash);
    assert_eq!(pinned.info().input_hash, archive.header.provenance.input_hash);
}

#[test]
fn a_scrub_finds_a_changed_byte_and_the_watchdog_falls_silent() {
    let (place, manager) = (place(), Manager::new());
    let args =
        ["--log", "json", "--log-level", "debug", "--scrub", "1", "--metrics", "127.0.0.1:0"];
    let mut daemon = Logged::start(manager.listen_to(&mut place.command()), &args);
    let generation = daemon.event("serving")["generation"].clone();
    let address = daemon.event("metrics at")["address"].as_str().expect("an address").to_owned();
    assert_eq!(daemon.event("proves")["generation"], generation);
    let count = |result: &str| {
        let line = format!("mapd_checks_total{{map=\"town\",check=\"scrub\",result=\"{result}\"}}");
        metric(&address, &line).expect("a count")
    };
    assert!(count("ok") >= 1.0 && count("failed") == 0.0);
    let data = place.segments().into_iter().find(|p| p.extension().is_some_and(|e| e == "data"));
    let data = data.expect("a data segment");
    std::fs::set_permissions(&data, std::fs::Permissions::from_mode(0o600)).expect("our own");
    let mut bytes = std::fs::read(&data).expect("read");
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    let file = std::fs::OpenOptions::new().write(true).open(&data).expect("opens");
    std::os::unix::fs::FileExt::write_all_at(&file, &bytes[middle..=middle], middle as u64)
        .expect("written");
    let event = daemon.event("fails verification");
    assert_eq!((&event["level"], &event["map"]), (&"ERROR".into(), &"town".into()));
    until("the count", || (count("failed") >= 1.0).then_some(()));
    let status = place.command().args(["status", "--json"]).output().expect("runs");
    let status: Value = serde_json::from_slice(&status.stdout).expect("JSON");
    let scrubs = &status[0]["state"]["scrubs"];
    assert!(scrubs["failures"].as_u64() >= Some(1) && scrubs["last_failed"] == true, "{status}");
    let status = place.command().arg("status").output().expect("runs");
    let text = String::from_utf8_lossy(&status.stdout).into_owned();
    assert!(text.contains("scrub failed: "), "{text}");
    // One query may have been under way; once another has been answered, its ping has been sent.
    let answered = || place.state("town").self_queries.ok;
    let before = answered();
    until("a query", || (answered() > before).then_some(()));
    manager.drain();
    assert_eq!(manager.hear(2 * WATCHDOG), None, "pinged although memory is bad");
}

/// What may happen to a record while its daemon runs.
type Damage = fn(&Path);

/// A record that kept every newcomer out was sound to scrubs and to `mapd status --healthy`, and no reload repaired it.
#[test]
fn a_record_that_keeps_newcomers_out_is_found_and_mended() {
    let cases: [(&str, Damage); 3] = [
        ("damaged", |record| {
            let file = std::fs::OpenOptions::new().write(true).open(record).expect("opens");
            std::os::unix::fs::FileExt::write_all_at(&file, b"garbage", 0).expect("written");
        }),
        ("missing", |record| std::fs::remove_file(record).expect("removed")),
        ("another's", |record| {
            std::fs::remove_file(record).expect("removed");
            std::fs::write(record, "garbage").expect("written");
        }),
    ];
    for (case, damage) in cases {
        let place = place();
        let args = ["--log", "json", "--log-level", "debug", "--scrub", "1"];
        let mut daemon = Logged::start(&mut place.command(), &args);
        daemon.event("proves");
        let connect = |wait| mapd_client::Client::connect_in(&place.domain(), "town", wait);
        let held = connect(PATIENCE).expect("attaches");
        let status = |args: &[&str]| {
            let output = place.command().arg("status").args(args).output().expect("runs");
            (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned())
        };
        until("health", || (status(&["--healthy"]).0 == Some(0)).then_some(()));
        damage(&place.domain().root().join("town.published"));
        assert!(connect(Duration::ZERO).is_err(), "{case}");
        let (code, text) = status(&["--healthy"]);
        assert_eq!(code, Some(1), "{case}: {text}");
        assert!(text.contains("new readers cannot attach"), "{case}: {text}");
        let event = daemon.event("fails verification");
        assert_eq!(event["level"], "ERROR", "{case}: {event}");
        let failures = || place.state("town").scrubs.failures;
        until("the count", || (failures() > 0).then_some(()));
        // Its file has not changed: a reload repairs what is served all the same.
        let generation = place.reload("town").generation;
        let client = connect(Duration::ZERO).unwrap_or_else(|error| panic!("{case}: {error}"));
        assert_eq!(Some(client.snapshot().generation()), generation, "{case}");
        let newer = held.wait_next(PATIENCE).unwrap_or_else(|error| panic!("{case}: {error}"));
        assert_eq!(Some(newer.generation()), generation, "{case}");
        let (code, text) = status(&["--healthy"]);
        assert_eq!(code, Some(0), "{case}: {text}");
        daemon.event("proves");
        assert_eq!(daemon.terminate(), Some(0), "{case}");
    }
}
