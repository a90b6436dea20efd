//! Readers that are stopped, at any moment, while generations and daemons change: they hold what they held, and go on with what is served then.

use mapd::serve::Server;
use mapd_archive::AlignedBytes;
use mapd_tests::test_domain::{PATIENCE, TestDomain, publish, until};
use mapd_tests::tracer::{Moment, Side, Then, Traced};
use mapd_tests::two_maps::{TwoMaps, archives};
use mapd_tests::{number, say};
use nix::errno::Errno;
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::fs::File;
use std::io::{BufRead, BufReader, Read, Write};
use std::os::unix::fs::{FileExt, MetadataExt};
use std::path::Path;
use std::process::{Child, ChildStdout, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use syscalls::Sysno;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");
const PROBE: &str = env!("CARGO_BIN_EXE_planner_probe");

/// Swaps during all stops together, where `MAPD_SWAPS` says nothing else.
const SWAPS: u64 = 60;

/// How often readers are stopped.
const STOPS: u64 = 3;

/// Swaps at each moment of an attach, where `MAPD_MOMENT_SWAPS` says nothing else.
const MOMENT_SWAPS: u64 = 2;

/// A daemon in this process that serves one archive after the other.
struct Served<'a> {
    place: &'a TestDomain,
    archives: [AlignedBytes; 2],
    server: Server,
    /// The generation that is served.
    newest: u64,
}

impl<'a> Served<'a> {
    fn new(place: &'a TestDomain) -> Self {
        let server = Server::start(&place.domain()).expect("starts");
        let mut served = Self { place, archives: archives(), server, newest: 0 };
        served.swap(1);
        served
    }

    fn swap(&mut self, times: u64) {
        for _ in 0..times {
            let archive = &self.archives[self.newest as usize % 2];
            self.newest = publish(&mut self.server, "m", archive);
        }
    }

    /// Ends in order, and starts again.
    fn restart(self) -> Self {
        let Self { place, archives, server, newest } = self;
        drop(server);
        let server = Server::start(&place.domain()).expect("starts");
        let mut served = Self { place, archives, server, newest };
        served.swap(1);
        served
    }
}

/// A probe and what it says; killed when dropped, also where it is stopped.
struct Probe {
    child: Child,
    out: BufReader<ChildStdout>,
}

impl Probe {
    /// Starts it and returns once it has attached.
    fn start(place: &TestDomain, attach: &str, args: &[&str]) -> Self {
        let mut command = place.command_of(PROBE);
        command.args(args).env("PROBE_ATTACH", attach).stdin(Stdio::piped());
        let mut child = command.spawn().expect("starts");
        let out = BufReader::new(child.stdout.take().expect("stdout"));
        let (mut probe, mut line) = (Self { child, out }, String::new());
        probe.out.read_line(&mut line).expect("a line");
        assert!(line.starts_with("attached "), "{line}");
        probe
    }

    fn tell(&mut self, line: &str) {
        writeln!(self.child.stdin.as_mut().expect("stdin"), "{line}").expect("told");
    }

    fn state(&self) -> char {
        let stat = std::fs::read_to_string(format!("/proc/{}/stat", self.child.id()));
        let stat = stat.expect("a process");
        stat.rsplit(") ").next().and_then(|rest| rest.chars().next()).expect("a state")
    }

    /// Whether it sleeps in a system call of these; in any, where the kernel does not tell.
    fn sleeps_in(&self, calls: &[Sysno]) -> bool {
        let call = std::fs::read_to_string(format!("/proc/{}/syscall", self.child.id()));
        let number = |text: String| text.split(' ').next().and_then(|word| word.parse().ok());
        let is_in = match call {
            Ok(text) => number(text).and_then(Sysno::new).is_some_and(|call| calls.contains(&call)),
            Err(_) => true,
        };
        is_in && self.state() == 'S'
    }

    fn signal(&self, signal: Signal) {
        let pid = i32::try_from(self.child.id()).expect("an id");
        kill(Pid::from_raw(pid), signal).expect("sent");
        if signal == Signal::SIGSTOP {
            until("its stop", || (self.state() == 'T').then_some(()));
        }
    }

    /// Waits for its end; what it said since it attached.
    fn end(mut self) -> String {
        let mut text = String::new();
        self.out.read_to_string(&mut text).expect("the report");
        assert!(self.child.wait().expect("ends").success(), "{text}");
        text
    }
}

impl Drop for Probe {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The system calls that a client waits in for a generation. It reads its stdin in another.
fn waits_in(attach: &str) -> &'static [Sysno] {
    if attach == "observer" { &[Sysno::futex] } else { &[Sysno::recvfrom] }
}

/// Stopped while they attach and follow, while they sleep, and while they only hold: all that they hold is whole, and then they have the newest.
#[test]
fn readers_stopped_through_many_swaps() {
    let swaps = number("MAPD_SWAPS", SWAPS) / STOPS;
    let long = Duration::from_secs(number("MAPD_STOPPED_SECONDS", 0)) / STOPS as u32;
    let place = TestDomain::new(MAPD);
    let mut served = Served::new(&place);
    let first = served.newest;
    let wait = PATIENCE.as_millis().to_string();
    // These are stopped wherever they happen to be.
    let mut busy: Vec<Probe> =
        (0..4).map(|_| Probe::start(&place, "observer", &["observe", "m"])).collect();
    for _ in 0..STOPS {
        served.swap(1);
        let held = served.newest;
        let mut waiting: Vec<Probe> = ["observer", "subscriber"]
            .iter()
            .flat_map(|attach| [(attach, true), (attach, false)])
            .map(|(attach, sleeps)| {
                let start = || Probe::start(&place, attach, &["wait", "m", &wait]);
                let mut probe = served.server.meanwhile(start).expect("greets");
                if sleeps {
                    probe.tell("go");
                    until("its sleep", || probe.sleeps_in(waits_in(attach)).then_some(()));
                }
                probe
            })
            .collect();
        let all = || busy.iter().chain(&waiting);
        all().for_each(|probe| probe.signal(Signal::SIGSTOP));
        let begun = Instant::now();
        for swap in 1..=swaps {
            served.swap(1);
            let until = begun + long.mul_f64(swap as f64 / swaps as f64);
            std::thread::sleep(until.saturating_duration_since(Instant::now()));
        }
        all().for_each(|probe| probe.signal(Signal::SIGCONT));
        for (i, mut probe) in waiting.drain(..).enumerate() {
            if i % 2 == 1 {
                probe.tell("go");
            }
            let text = probe.end();
            assert!(text.contains(&format!("held {}\n", served.newest)), "{i}: {text}");
            assert!(text.contains(&format!("generation {}\n", served.newest)), "{i}: {text}");
            assert!(served.newest > held);
        }
    }
    for probe in &mut busy {
        probe.tell(&served.newest.to_string());
    }
    for probe in busy {
        let text = probe.end();
        assert!(text.contains(&format!("last {}\n", served.newest)), "{text}");
        assert!(text.contains(&format!("first {first}\n")), "{text}");
    }
    say(&format!("8 readers stopped {STOPS} times, each for {swaps} swaps and {long:?}"));
}

/// What happens while a reader is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Meanwhile {
    /// Other generations.
    Swaps(u64),
    /// The daemon ends in order and another starts.
    Restart,
}

/// What a probe did that took a step.
struct Taken {
    /// All moments of the step.
    moments: Vec<Moment>,
    said: String,
    /// It came to the moment at which something was to happen.
    met: bool,
}

/// Runs a probe that takes a step and has something happen at one of its moments; `None` where tracing is not permitted.
fn take(
    served: &mut Option<Served<'_>>,
    step: &str,
    wait: &str,
    at: Option<(Moment, Meanwhile)>,
) -> Option<Taken> {
    let place = served.as_ref().expect("a daemon").place;
    let mut command = place.command_of(PROBE);
    command.args(["moment", step, "m", wait]);
    let (traced, stderr) = match Traced::start(&command, "", Stdio::piped()) {
        Err(error) if error.raw_os_error() == Some(Errno::EPERM as i32) => {
            say("SKIPPED: tracing is not permitted");
            return None;
        }
        started => started.expect("starts"),
    };
    let (mut moments, mut marks, mut met) = (Vec::new(), 0, false);
    // Who waits or refreshes meets one generation in any case.
    let mut awaited = step != "attach";
    let status = traced.run(|moment| {
        if moment.name == Sysno::getppid {
            marks += usize::from(moment.side == Side::Before);
        } else if marks == 1 {
            moments.push(*moment);
        }
        // Who may wait has slept once before, and looks again. (`every_generation_is_waited_for` wakes sleepers.)
        let is_due = match (step, wait) {
            ("wait", "0") | ("refresh", _) => marks == 1,
            _ => marks == 1 && moment.name == Sysno::futex && moment.side == Side::After,
        };
        if is_due && std::mem::take(&mut awaited) {
            served.as_mut().expect("a daemon").swap(1);
        }
        match at {
            Some((place, what)) if place == *moment && marks == 1 => {
                met = true;
                match what {
                    Meanwhile::Swaps(times) => served.as_mut().expect("a daemon").swap(times),
                    Meanwhile::Restart => *served = served.take().map(Served::restart),
                }
            }
            _ => {}
        }
        Then::Continue
    });
    let mut said = String::new();
    stderr.expect("stderr").read_to_string(&mut said).expect("text");
    assert!(status.expect("runs").success(), "{step} {at:?}: {said}");
    assert_eq!(marks, 2, "{step} {at:?}");
    Some(Taken { moments, said, met })
}

/// Stopped at each system call of attaching, looking and waiting: then they have the newest, whatever happened meanwhile, and however little time they had.
#[test]
fn readers_stopped_at_each_system_call() {
    let swaps = number("MAPD_MOMENT_SWAPS", MOMENT_SWAPS);
    let patience = PATIENCE.as_millis().to_string();
    let (mut stops, mut tried) = (0, 0);
    let place = TestDomain::new(MAPD);
    let mut served = Some(Served::new(&place));
    let swaps = Meanwhile::Swaps(swaps);
    // Where a daemon ends and another starts, there is a moment without any.
    for (step, wait, what) in [
        ("attach", "0", swaps),
        ("attach", &patience, swaps),
        ("attach", &patience, Meanwhile::Restart),
        ("refresh", "0", swaps),
        ("wait", "0", swaps),
        ("wait", &patience, swaps),
        ("wait", &patience, Meanwhile::Restart),
    ] {
        let Some(Taken { moments, .. }) = take(&mut served, step, wait, None) else { return };
        assert!(moments.len() > 10, "{step} has few moments: {moments:?}");
        for moment in moments {
            let at = Some((moment, what));
            let Some(Taken { said, met, .. }) = take(&mut served, step, wait, at) else { return };
            let newest = served.as_ref().expect("a daemon").newest;
            assert!(
                said.contains(&format!("has {newest}\n")),
                "{step} with {wait} ms, {what:?} {moment}: {said}, newest is {newest}"
            );
            (stops, tried) = (stops + usize::from(met), tried + 1);
        }
    }
    // A step may take a call less the second time.
    assert!(stops * 10 >= tried * 9, "{stops} stops at {tried} moments");
    say(&format!(
        "readers stopped {stops} times at {tried} system calls, each for {swaps:?} or a restart"
    ));
}

/// What a record says: generation and segment; `None` if nothing is served.
fn said(record: &[u8]) -> Option<(u64, String)> {
    let number = |at: usize| u64::from_le_bytes(record[at..at + 8].try_into().expect("a word"));
    let sequence = u32::from_le_bytes(record[12..16].try_into().expect("a word"));
    let word = |i: usize| 24 + (sequence as usize % 2 * 55 + i) * 8;
    let (generation, length) = (number(word(2)), number(word(20)) as usize);
    let name = String::from_utf8_lossy(&record[word(21)..][..length]).into_owned();
    (sequence > 0 && generation > 0).then_some((generation, name))
}

/// Kills a traced daemon if its thread panics: nobody else would end it, and its tracer waits for its end.
struct KilledOnPanic<'a> {
    daemon: Pid,
    /// It has ended already, and its id may be another's.
    ended: &'a AtomicBool,
}

impl Drop for KilledOnPanic<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() && !self.ended.load(Ordering::Relaxed) {
            let _ = kill(self.daemon, Signal::SIGKILL);
        }
    }
}

/// At each of a daemon's system calls, what its record names is there; and the record goes once it says that nothing is served.
#[test]
fn what_the_record_names_is_there_at_every_moment() {
    let (place, maps) = (TestDomain::new(MAPD), TwoMaps::new());
    let mut command = place.command();
    command.arg("--load").arg(maps.path());
    let (traced, _) = match Traced::start(&command, "", Stdio::null()) {
        Err(error) if error.raw_os_error() == Some(Errno::EPERM as i32) => {
            return say("SKIPPED: tracing is not permitted");
        }
        started => started.expect("starts"),
    };
    let (daemon, record) = (traced.pid(), place.domain().root().join("map.published"));
    let (mut kept, mut generations, mut closed, mut looks) =
        (None, std::collections::BTreeSet::new(), false, 0);
    let ended = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let _guard = KilledOnPanic { daemon, ended: &ended };
            for round in 1..=3 {
                place.state("map");
                maps.put(round);
                place.reload("map");
            }
            kill(daemon, Signal::SIGTERM).expect("sent");
        });
        let status = traced.run(|moment| {
            match File::open(&record) {
                Ok(file) => {
                    let mut page = [0; 4096];
                    file.read_exact_at(&mut page, 0).expect("a page");
                    if let Some((generation, segment)) = said(&page) {
                        let segment = Path::new("/dev/shm").join(segment);
                        let mode = segment.metadata().map(|found| found.mode() & 0o777);
                        assert_eq!(mode.ok(), Some(0o400), "{generation} {moment}");
                        generations.insert(generation);
                        looks += 1;
                    }
                    kept = Some(file);
                }
                // Removed: whoever has it mapped sees that it is left.
                Err(_) => {
                    if let Some(file) = &kept {
                        let mut page = [0; 4096];
                        file.read_exact_at(&mut page, 0).expect("a page");
                        assert_eq!(said(&page), None, "{moment}");
                        closed = true;
                    }
                }
            }
            Then::Continue
        });
        ended.store(true, Ordering::Relaxed);
        assert!(status.expect("runs").success());
    });
    assert!(closed && generations.len() == 4, "{generations:?}");
    say(&format!("what the record names was there at {looks} moments of a daemon"));
}
