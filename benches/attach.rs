//! From exec to the first answer, fresh processes, interleaved with the same program on plain open and mmap. Then attaching alone beside the same steps in C
//! (`attach.c`, compiled by `cc`), to one of many maps beside the only one, and when an observer hears of a generation beside a subscriber. Fails where
//! a ratio is above its goal.

use mapd::serve::{Doorbell, PublishMeta, Server, StopSignal};
use mapd_benches::{percentiles, print};
use mapd_client::{Attach, Client, Domain, MapEvent};
use mapd_compiler::{CompileOptions, compile};
use mapd_tests::test_domain::StopAtEnd;
use std::collections::BTreeMap;
use std::io::Read;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::sync::Barrier;
use std::sync::mpsc::Sender;
use std::time::{Duration, Instant};

/// Fresh processes of each kind.
const PROCESSES: usize = 60;

/// From before the process is made until its answer is here, and what else it says.
fn time(prefix: &str, how: &str, what: &str) -> (Duration, String) {
    let start = Instant::now();
    let mut child = Command::new(env!("CARGO_BIN_EXE_attach_probe"))
        .env("MAPD_PREFIX", prefix)
        .args([how, what])
        .stdout(Stdio::piped())
        .spawn()
        .expect("the probe runs");
    let mut out = child.stdout.take().expect("a pipe");
    let answered = out.read_exact(&mut [0]);
    let taken = start.elapsed();
    answered.expect("the probe found no answer");
    let mut rest = String::new();
    out.read_to_string(&mut rest).expect("the rest");
    assert!(child.wait().expect("ends").success());
    (taken, rest)
}

/// Processes that are all started at once, as at boot, and how often.
const AT_ONCE: [usize; 2] = [33, 200];
const BOOTS: usize = 7;

/// From when the first of so many processes is started until the last has its answer.
fn at_once(count: usize, prefix: &str, how: &str, what: &str) -> Duration {
    let barrier = Barrier::new(count);
    let spans: Vec<(Instant, Instant)> = std::thread::scope(|scope| {
        let start = || {
            barrier.wait();
            let begun = Instant::now();
            (begun, begun + time(prefix, how, what).0)
        };
        let threads: Vec<_> = (0..count).map(|_| scope.spawn(start)).collect();
        threads.into_iter().map(|thread| thread.join().expect("answered")).collect()
    });
    let first = spans.iter().map(|(begun, _)| *begun).min().expect("some");
    spans.iter().map(|(_, ended)| *ended).max().expect("some") - first
}

/// Medians of the phases of an attach.
fn phases(reports: &[String]) -> String {
    let names = ["lock", "node", "service", "subscriber", "receive"];
    let median = |(i, name): (usize, &&str)| {
        let mut values: Vec<u64> =
            reports.iter().filter_map(|report| report.split(' ').nth(i)?.parse().ok()).collect();
        values.sort_unstable();
        format!("{name} {} \u{b5}s", values.get(values.len() / 2).unwrap_or(&0))
    };
    names.iter().enumerate().map(median).collect::<Vec<_>>().join(", ")
}

/// An archive of half a gigabyte: the first map's, with a table blown up.
const LARGE: usize = 512 << 20;

/// Attaches of a running process between two turns, and turns.
const TIMES: usize = 200;
const TURNS: usize = 15;

/// Maps of a daemon that has many.
const MANY: usize = 900;

/// Generations whose events are heard.
const EVENTS: usize = 200;

/// What an observer may take at most of what open and mmap take, from exec to the first answer and until the last of many processes has its own.
const AS_A_FILE: f64 = 1.15;
/// What attaching alone may take of what the same steps take in C.
const AS_IN_C: f64 = 1.5;
/// What attaching to one of many maps may take of what the only one takes.
const AS_THE_ONLY_ONE: f64 = 1.2;
/// How much later than a subscriber an observer may hear of a generation, in the median `[ms]`.
const LATER: f64 = 1.0;

/// Longest wait for anything.
const WAIT: Duration = Duration::from_secs(60);

/// Publishes bytes as they are.
fn publish(server: &mut Server, map: &str, bytes: &[u8]) -> u64 {
    let fill = |loan: &mut [u8]| {
        loan.copy_from_slice(bytes);
        let content_hash = mapd_archive::open(bytes)?.header.content_hash;
        Ok(PublishMeta { layout_id: [0; 32], content_hash, input_hash: [0; 32] })
    };
    server.publish(map, bytes.len(), fill).expect("publishes")
}

/// Times that a program prints, a line each.
fn printed(command: &mut Command) -> Vec<Duration> {
    let output = command.output().expect("runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("text");
    text.lines().map(|line| Duration::from_nanos(line.parse().expect("a number"))).collect()
}

/// Attaches in a running process, in Rust.
fn attaches(prefix: &str, map: &str) -> Vec<Duration> {
    let mut probe = Command::new(env!("CARGO_BIN_EXE_attach_probe"));
    let probe = probe.env("MAPD_PREFIX", prefix).env("PROBE_TIMES", TIMES.to_string());
    printed(probe.args(["times", map]))
}

/// Prints both times and their ratio; whether that is more than the goal.
fn exceeds(
    what: &str,
    ours: Vec<Duration>,
    beside: &str,
    theirs: Vec<Duration>,
    goal: Option<f64>,
) -> bool {
    let ((ours, ours99), (theirs, theirs99)) = (percentiles(ours), percentiles(theirs));
    let ratio = ours.as_secs_f64() / theirs.as_secs_f64();
    let is_exceeded = goal.is_some_and(|goal| ratio > goal);
    print(&format!(
        "{what} p50 {ours:.2?} p99 {ours99:.2?}; {beside} p50 {theirs:.2?} p99 {theirs99:.2?}; ratio {ratio:.2}{}{}",
        goal.map_or(String::new(), |goal| format!(", goal {goal}")),
        mark(is_exceeded)
    ));
    is_exceeded
}

fn mark(is_exceeded: bool) -> &'static str {
    if is_exceeded { ": EXCEEDED" } else { "" }
}

/// Attaching alone in a running process, beside the same system calls in C; whether it takes more than it may.
fn beside_c(folder: &Path, prefix: &str, map: &str) -> bool {
    let program = folder.join("attach");
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("attach.c");
    let compiled =
        Command::new("cc").args(["-O2", "-Wall", "-o"]).arg(&program).arg(source).output();
    match compiled {
        Ok(output) if output.status.success() => {}
        other => {
            print(&format!("skipped: no attach in C, for cc does not compile it: {other:?}"));
            return false;
        }
    }
    let (mut rust, mut c) = (Vec::new(), Vec::new());
    for _ in 0..TURNS {
        rust.extend(attaches(prefix, map));
        c.extend(printed(Command::new(&program).args([prefix, map, &TIMES.to_string()])));
    }
    exceeds("attaching alone, observer", rust, "the same steps in C", c, Some(AS_IN_C))
}

/// Attaching to one of many maps, beside the only one of another daemon; whether it takes more than it may.
fn one_of_many() -> bool {
    let path = mapd_tests::carried("one_road.xodr");
    let archive = mapd_benches::compiled(&path);
    let prefixes = ["many", "one"].map(|name| format!("mapd{name}{}_", std::process::id()));
    let domains = prefixes.each_ref().map(|prefix| Domain::new(prefix).expect("a prefix"));
    let mut servers = domains.each_ref().map(|domain| Server::start(domain).expect("starts"));
    let start = Instant::now();
    let names: Vec<String> = (0..MANY).map(|number| format!("m{number}")).collect();
    // All at once, as a daemon does.
    servers[0].claim_all(names.iter().map(String::as_str)).expect("claims");
    for name in &names {
        publish(&mut servers[0], name, archive.bytes());
    }
    let taken = start.elapsed();
    publish(&mut servers[1], "m", archive.bytes());
    let (mut many, mut one) = (Vec::new(), Vec::new());
    for _ in 0..TURNS {
        many.extend(attaches(&prefixes[0], &names[MANY / 2]));
        one.extend(attaches(&prefixes[1], "m"));
    }
    let what = format!("attaching to one of {MANY} maps (published in {taken:.1?})");
    let is_exceeded = exceeds(&what, many, "to the only one", one, Some(AS_THE_ONLY_ONE));
    drop(servers);
    for domain in &domains {
        let _ = std::fs::remove_dir_all(domain.root());
    }
    is_exceeded
}

/// When a client hears of each generation, from when it has told that it is there.
fn heard(attach: Attach, domain: &Domain, there: Sender<()>) -> BTreeMap<u64, Instant> {
    let client = Client::connect_as(attach, domain, "m", WAIT).expect("attaches");
    let mut events = client.events();
    there.send(()).expect("awaited");
    drop(there);
    let mut heard = BTreeMap::new();
    let last = client.snapshot().generation() + EVENTS as u64;
    while client.snapshot().generation() < last {
        match events.next(WAIT).expect("no error") {
            Some(MapEvent::Generation(snapshot)) => {
                heard.insert(snapshot.generation(), Instant::now());
            }
            Some(_) => {}
            None => panic!("no generation came"),
        }
    }
    heard
}

/// How much later an observer hears of a generation than a subscriber; whether that is more than it may be.
fn events() -> bool {
    let domain = Domain::new(&format!("mapdevents{}_", std::process::id())).expect("a prefix");
    let archive = mapd_benches::compiled(&mapd_tests::carried("one_road.xodr"));
    let (stop, door) = (StopSignal::new().expect("a signal"), Doorbell::new().expect("a bell"));
    let ringer = door.ringer().expect("a ringer");
    let (published, news) = std::sync::mpsc::channel();
    let later = std::thread::scope(|scope| {
        // However this ends, the server does.
        let _stop = StopAtEnd(&stop);
        let (bytes, stopped, of) = (archive.bytes(), &stop, &domain);
        scope.spawn(move || {
            let mut server = Server::start(of).expect("starts");
            while !stopped.is_requested() {
                publish(&mut server, "m", bytes);
                // Nobody listens any more at the end.
                let _ = published.send(());
                server.run_until(stopped, &door).expect("serves");
                door.answer();
            }
        });
        news.recv().expect("published");
        let (there, both) = std::sync::mpsc::channel();
        let [observer, subscriber] = [Attach::Observer, Attach::Subscriber].map(|attach| {
            let there = there.clone();
            scope.spawn(move || heard(attach, of, there))
        });
        drop(there);
        (0..2).for_each(|_| both.recv().expect("attached"));
        for _ in 0..EVENTS {
            ringer.ring();
            news.recv().expect("published");
            std::thread::sleep(Duration::from_millis(5));
        }
        let (observer, subscriber) =
            (observer.join().expect("ends"), subscriber.join().expect("ends"));
        let both =
            observer.iter().filter_map(|(number, when)| Some((*when, *subscriber.get(number)?)));
        both.map(|(ours, theirs)| {
            let sign = if ours > theirs { 1.0 } else { -1.0 };
            sign * 1e3 * ours.max(theirs).duration_since(ours.min(theirs)).as_secs_f64()
        })
        .collect::<Vec<f64>>()
    });
    let mut later = later;
    later.sort_by(f64::total_cmp);
    let at = |share: f64| later[((later.len() - 1) as f64 * share) as usize];
    print(&format!(
        "{} generations' events: an observer hears of one later than a subscriber by p50 {:.3} ms, p90 {:.3} ms, p99 {:.3} ms (negative: earlier), goal {LATER} ms{}",
        later.len(),
        at(0.5),
        at(0.9),
        at(0.99),
        mark(at(0.5) > LATER)
    ));
    let _ = std::fs::remove_dir_all(domain.root());
    at(0.5) > LATER
}

fn main() -> ExitCode {
    let mut is_exceeded = false;
    let folder = tempfile::tempdir().expect("a folder");
    let (name, path) = mapd_benches::small_map();
    for (size, bytes) in [("as it is", 0), ("blown up", LARGE)] {
        let prefix = format!("mapdbench{}_", std::process::id());
        let domain = Domain::new(&prefix).expect("a prefix");
        let file = std::fs::File::open(&path).expect("the map opens");
        let compiled =
            compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
        let mut rows = compiled.rows.expect("accepted");
        let numbers = rows.coefficients.len().max(bytes / size_of::<f64>());
        rows.coefficients.resize(numbers, 0.0);
        let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
        drop(rows);
        let saved = folder.path().join(format!("{name}.mapd"));
        std::fs::write(&saved, &archive).expect("written");
        let saved = saved.display().to_string();
        let stop = StopSignal::new().expect("a signal");
        let (ready, served) = std::sync::mpsc::channel();
        std::thread::scope(|scope| {
            let (domain, stop_here, bytes) = (&domain, &stop, &archive);
            scope.spawn(move || {
                let mut server = Server::start(domain).expect("starts");
                publish(&mut server, name, bytes);
                ready.send(()).expect("told");
                server.run(stop_here).expect("serves");
            });
            let _stop = StopAtEnd(&stop);
            served.recv().expect("served");
            let (mut plain, mut reports) = (Vec::new(), Vec::new());
            let mut shared = [("observer", "shm"), ("subscriber", "subscriber")]
                .map(|(title, how)| (title, how, Vec::new()));
            for _ in 0..PROCESSES {
                plain.push(time(&prefix, "file", &saved).0);
                for (_, how, times) in &mut shared {
                    let (taken, report) = time(&prefix, how, name);
                    times.push(taken);
                    reports.extend(Some(report).filter(|report| !report.is_empty()));
                }
            }
            for (title, how, times) in shared {
                let bytes = archive.len();
                let what =
                    format!("attach {name} {size} ({bytes} B) as {title}: exec to first answer");
                // A subscriber is a full participant of the transport: nothing is promised of what that takes.
                let goal = (how == "shm").then_some(AS_A_FILE);
                is_exceeded |= exceeds(&what, times, "open+mmap", plain.clone(), goal);
            }
            print(&format!("  phases, medians: {}", phases(&reports)));
            is_exceeded |= beside_c(folder.path(), &prefix, name);
            for count in AT_ONCE {
                let (mut shared, mut file) = (Vec::new(), Vec::new());
                for _ in 0..BOOTS {
                    shared.push(at_once(count, &prefix, "shm", name));
                    file.push(at_once(count, &prefix, "file", &saved));
                }
                let what = format!("{count} processes at once, until the last answers, observer");
                is_exceeded |= exceeds(&what, shared, "open+mmap", file, Some(AS_A_FILE));
            }
        });
        let _ = std::fs::remove_dir_all(domain.root());
    }
    is_exceeded |= one_of_many();
    is_exceeded |= events();
    if is_exceeded { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
