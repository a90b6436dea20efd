//! A planner as a process, which reports on itself: `planner_probe KIND NAME …`.
//!
//! - `manners NAME WAIT_MS`: what the process looks like before and after attaching, waiting and detaching.
//! - `faults NAME`: minor page faults of the checked access, and how the data segment is mapped.
//! - `write NAME`: writes to the map, which must end the process.
//! - `connect NAME WAIT_MS`: attaches with a deadline and says what came of it.
//! - `ask NAME WAIT_MS`: attaches, asks for a lane, detaches.
//! - `answers NAME WAIT_MS`: attaches and says what the map answers.
//! - `populated NAME FILE`: minor page faults of queries all over a map whose pages are all mapped, and of the same without;
//!   FILE is the same archive, on which everything is asked before, so that the program's own pages are not counted.
//! - `hold NAME`: attaches, touches the whole map, says so, and ends when stdin does.
//! - `locked NAME`: locks all memory that it will ever map, attaches, and asks for a lane.
//! - `empty`: makes a node of iceoryx2 and nothing else, says so, and ends when stdin does.
//! - `follow NAME TRUTH`: follows every generation and asks it, until stdin ends; each answer must be the one that the file
//!   TRUTH has for the generation's content: lines of content hash, x, y, lane.
//! - `steps NAME`: attaches between two calls of `getppid`, for who counts system calls; then attaches again and tells the page faults of that.
//! - `observe NAME`: follows, attaches anew all the while and proves every generation, until stdin ends; then waits for the last one and
//!   proves the first once more.
//! - `moment STEP NAME WAIT_MS`: takes a step (`attach`, `refresh`, `wait`) between two calls of `getppid`, for who stops it at the calls in between;
//!   proves what it holds and says on stderr which generation that is.
//! - `require NAME GENERATION WAIT_MS`: waits for this generation and no other.
//! - `release FROM TO`: writes the archive of one file to another as a release writes it that has a table more.
//! - `wait NAME WAIT_MS`: attaches, says so, reads a line from stdin, and waits for the next generation.
//!
//! All but `faults` attach as observers, with `PROBE_ATTACH=subscriber` as subscribers. One `key value` per line on stdout.
#![allow(unsafe_code, clippy::print_stdout)]

use iceoryx2::prelude::{NodeBuilder, SignalHandlingMode};
use mapd_client::{
    Attach, Client, ClientError, Domain, NearestOptions, Snapshot, glam::DVec2, raw,
};
use mapd_tests::releases::{Parts, UNKNOWN_TABLE};
use mapd_transport::{Subscription, TransportService, iceoryx2_config, silence_iceoryx2};
use std::collections::BTreeMap;
use std::io::{Read, Seek};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use syscalls::{Sysno, raw_syscall};

type Outcome = Result<(), Box<dyn std::error::Error>>;

/// Longest wait where none is given.
const WAIT: Duration = Duration::from_secs(10);

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let outcome = match args.as_slice() {
        ["manners", map, wait] => milliseconds(wait).and_then(|wait| manners(map, wait)),
        ["faults", map] => faults(map),
        ["write", map] => write(map),
        ["connect", map, wait] => milliseconds(wait).and_then(|wait| connect(map, wait)),
        ["ask", map, wait] => milliseconds(wait).and_then(|wait| ask(map, wait)),
        ["answers", map, wait] => milliseconds(wait).and_then(|wait| answers(map, wait)),
        ["populated", map, file] => populated(map, file),
        ["hold", map] => hold(map),
        ["locked", map] => locked(map),
        ["empty"] => empty(),
        ["follow", map, truth] => follow(map, truth),
        ["steps", map] => steps(map),
        ["observe", map] => observe(map),
        ["release", from, to] => release(from, to),
        ["moment", step, map, wait] => milliseconds(wait).and_then(|wait| moment(step, map, wait)),
        ["require", map, generation, wait] => {
            milliseconds(wait).and_then(|wait| require(map, generation, wait))
        }
        ["wait", map, wait] => milliseconds(wait).and_then(|wait| wait_next(map, wait)),
        _ => Err("unknown arguments".into()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            println!("error {error}");
            ExitCode::FAILURE
        }
    }
}

/// Attaches as an observer, or as a subscriber where the environment's `PROBE_ATTACH` says so.
fn connect_to(map: &str, wait: Duration) -> Result<Client, ClientError> {
    let attach = match std::env::var_os("PROBE_ATTACH") {
        Some(how) if how == "subscriber" => Attach::Subscriber,
        _ => Attach::Observer,
    };
    let domain = Domain::from_env().map_err(mapd_client::AttachError::from)?;
    Client::connect_as(attach, &domain, map, wait)
}

fn milliseconds(text: &str) -> Result<Duration, Box<dyn std::error::Error>> {
    Ok(Duration::from_millis(text.parse()?))
}

/// Caught signals, threads and open files, as the kernel sees them.
fn report(when: &str) -> Outcome {
    let status = std::fs::read_to_string("/proc/self/status")?;
    for key in ["SigCgt", "SigIgn", "SigBlk", "Threads"] {
        let value = status.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(':'));
        println!("{when}.{key} {}", value.unwrap_or("?").trim());
    }
    Ok(())
}

fn manners(map: &str, wait: Duration) -> Outcome {
    report("start")?;
    let client = connect_to(map, WAIT)?;
    report("attached")?;
    // Nothing new comes: this is the deadline.
    let error = client.wait_next(wait).err().ok_or("a generation came")?;
    println!("wait {error}");
    report("waited")?;
    drop(client);
    report("detached")?;
    Ok(())
}

fn connect(map: &str, wait: Duration) -> Outcome {
    let start = Instant::now();
    let outcome = connect_to(map, wait);
    println!("milliseconds {}", start.elapsed().as_millis());
    println!("generation {}", outcome?.snapshot().generation());
    Ok(())
}

fn ask(map: &str, wait: Duration) -> Outcome {
    let snapshot = connect_to(map, wait)?.snapshot();
    let hit = snapshot.map().nearest_lane(DVec2::new(50.0, -1.75), &NearestOptions::default())?;
    println!("lane {}", snapshot.map().lane(hit.ok_or("no lane")?.lane)?.key());
    Ok(())
}

fn answers(map: &str, wait: Duration) -> Outcome {
    let snapshot = connect_to(map, wait)?.snapshot();
    print!("{}", mapd_tests::releases::answers(snapshot.map())?);
    Ok(())
}

/// A point and its lane.
type Truth = BTreeMap<String, Vec<(DVec2, String)>>;

fn read_truth(path: &str) -> Result<Truth, Box<dyn std::error::Error>> {
    let mut truth = Truth::new();
    for line in std::fs::read_to_string(path)?.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let [hash, x, y, lane] = words.as_slice() else {
            return Err("a line of four words".into());
        };
        let point = DVec2::new(x.parse()?, y.parse()?);
        truth.entry((*hash).to_owned()).or_default().push((point, (*lane).to_owned()));
    }
    Ok(truth)
}

fn follow(map: &str, truth: &str) -> Outcome {
    let truth = read_truth(truth)?;
    let client = connect_to(map, WAIT)?;
    println!("attached {}", client.snapshot().generation());
    let ended = Arc::new(AtomicBool::new(false));
    let end = ended.clone();
    std::thread::spawn(move || {
        let _ = std::io::copy(&mut std::io::stdin().lock(), &mut std::io::sink());
        end.store(true, Ordering::Relaxed);
    });
    let (mut last, mut seen, mut asked) = (0, 0, 0_u64);
    while !ended.load(Ordering::Relaxed) {
        let snapshot = client.refresh()?;
        let generation = snapshot.generation();
        if generation < last {
            return Err(format!("generation {generation} after {last}").into());
        }
        seen += u64::from(generation > last);
        last = generation;
        let hash: String =
            snapshot.header().content_hash.iter().map(|byte| format!("{byte:02x}")).collect();
        for (point, lane) in truth.get(&hash).ok_or("a map that was never published")? {
            let hit = snapshot.map().nearest_lane(*point, &NearestOptions::default())?;
            let found = snapshot.map().lane(hit.ok_or("no lane")?.lane)?.key().to_string();
            if found != *lane {
                return Err(format!("{found} instead of {lane} in generation {generation}").into());
            }
            asked += 1;
        }
    }
    let last = client.refresh()?.generation();
    // Looking once more lets the one before go.
    client.refresh()?;
    let domain = Domain::from_env()?;
    let maps = std::fs::read_to_string("/proc/self/maps")?;
    let files = maps.lines().filter_map(|line| line.split_ascii_whitespace().nth(5));
    let mapped = files.filter(|f| f.contains(domain.prefix()) && f.ends_with(".data"));
    println!("seen {seen}\nasked {asked}\nlast {last}");
    println!("mapped {}", mapped.collect::<std::collections::BTreeSet<_>>().len());
    Ok(())
}

fn steps(map: &str) -> Outcome {
    let domain = Domain::from_env()?;
    let mut faults = Faults::new()?;
    // Code and memory of the program's own are there afterwards.
    let warm = Client::connect_in(&domain, map, WAIT)?;
    faults.count()?;
    nix::unistd::getppid();
    let client = Client::connect_in(&domain, map, WAIT)?;
    nix::unistd::getppid();
    let before = faults.count()?;
    let again = Client::connect_in(&domain, map, WAIT)?;
    let after = faults.count()?;
    println!("faults {}", after - before);
    println!("bytes {}", client.snapshot().bytes().len());
    drop((warm, client, again));
    Ok(())
}

fn observe(map: &str) -> Outcome {
    let domain = Domain::from_env()?;
    let follower = connect_to(map, WAIT)?;
    let first = follower.snapshot();
    println!("attached {}", first.generation());
    let ended = Arc::new(AtomicBool::new(false));
    let end = ended.clone();
    let input = std::thread::spawn(move || {
        let mut last = String::new();
        // Text that is not a number is no generation: the wait for it runs out.
        let _ = std::io::stdin().read_line(&mut last);
        end.store(true, Ordering::Relaxed);
        last.trim().parse::<u64>().unwrap_or(u64::MAX)
    });
    let (mut newest, mut attached, mut seen) = (0, 0_u64, 0_u64);
    while !ended.load(Ordering::Relaxed) {
        for snapshot in [Client::connect_in(&domain, map, WAIT)?.snapshot(), follower.refresh()?] {
            if snapshot.generation() < newest {
                return Err(format!("{} after {newest}", snapshot.generation()).into());
            }
            seen += u64::from(snapshot.generation() > newest);
            newest = snapshot.generation();
            snapshot.verify()?;
            attached += 1;
        }
    }
    let last = input.join().map_err(|_| "no last generation")?;
    let held = follower.require(last, WAIT)?;
    held.verify()?;
    first.verify()?;
    println!("last {}\nattached {attached}\nseen {seen}", held.generation());
    println!("first {}", first.generation());
    Ok(())
}

/// Does something between two calls of `getppid`.
fn marked<T>(step: impl FnOnce() -> T) -> T {
    nix::unistd::getppid();
    let done = step();
    nix::unistd::getppid();
    done
}

fn moment(step: &str, map: &str, wait: Duration) -> Outcome {
    let had = if step == "attach" {
        // Ending the connection is no part of it.
        marked(|| connect_to(map, wait))?.snapshot()
    } else {
        let client = connect_to(map, WAIT)?;
        let before = client.snapshot();
        let had = match step {
            "refresh" => marked(|| client.refresh())?,
            "wait" => marked(|| client.wait_next(wait))?,
            _ => return Err("no such step".into()),
        };
        before.verify()?;
        had
    };
    had.verify()?;
    mapd_tests::say(&format!("has {}", had.generation()));
    Ok(())
}

fn release(from: &str, to: &str) -> Outcome {
    let snapshot = Snapshot::open(from)?;
    let archive = Parts::of(snapshot.bytes()).with(UNKNOWN_TABLE, 24, &[7; 24 * 3]).to_archive();
    Ok(std::fs::write(to, &archive)?)
}

fn require(map: &str, generation: &str, wait: Duration) -> Outcome {
    let client = connect_to(map, WAIT)?;
    println!("attached {}", client.snapshot().generation());
    println!("pending {}", client.pending().map_or(0, |info| info.generation));
    println!("required {}", client.require(generation.parse()?, wait)?.generation());
    Ok(())
}

fn wait_next(map: &str, wait: Duration) -> Outcome {
    let client = connect_to(map, WAIT)?;
    println!("attached {}", client.snapshot().generation());
    std::io::stdin().read_line(&mut String::new())?;
    let start = Instant::now();
    let outcome = client.wait_next(wait);
    println!("milliseconds {}", start.elapsed().as_millis());
    client.snapshot().verify()?;
    println!("held {}", client.snapshot().generation());
    println!("generation {}", outcome?.generation());
    Ok(())
}

/// Counts this thread's minor page faults with a file that is already open and a buffer that is already touched.
struct Faults {
    file: std::fs::File,
    buffer: [u8; 1024],
}

impl Faults {
    fn new() -> std::io::Result<Self> {
        Ok(Self { file: std::fs::File::open("/proc/thread-self/stat")?, buffer: [1; 1024] })
    }

    fn count(&mut self) -> Result<u64, Box<dyn std::error::Error>> {
        self.file.rewind()?;
        let length = self.file.read(&mut self.buffer)?;
        let text = std::str::from_utf8(&self.buffer[..length])?;
        // Behind the name in brackets: state, parent, group, session, terminal, its group, flags, minor faults.
        let rest = text.rsplit(") ").next().ok_or("no name")?;
        Ok(rest.split(' ').nth(7).ok_or("too short")?.parse()?)
    }
}

fn faults(map: &str) -> Outcome {
    let domain = Domain::from_env()?;
    let subscription = Subscription::connect(&domain, map, Instant::now() + WAIT)?;
    let pinned = subscription.current();
    // The program's own pages are not meant: open something else first.
    let small = raw::encode(&raw::Rows::default(), &raw::Provenance::default())?;
    let mut faults = Faults::new()?;
    for _ in 0..3 {
        std::hint::black_box(raw::open(std::hint::black_box(&small))?);
        faults.count()?;
    }
    let before = faults.count()?;
    let opened = raw::open(std::hint::black_box(pinned.bytes()))?;
    let after = faults.count()?;
    println!("faults {}", after - before);
    println!("bytes {}", pinned.bytes().len());
    println!("body {}", opened.header.body_length);
    let address = pinned.bytes().as_ptr() as usize;
    for line in std::fs::read_to_string("/proc/self/maps")?.lines() {
        let mut words = line.split_ascii_whitespace();
        let (range, mode, file) = (words.next(), words.next(), words.nth(3));
        let (from, to) = range.and_then(|range| range.split_once('-')).ok_or("no range")?;
        let (from, to) = (usize::from_str_radix(from, 16)?, usize::from_str_radix(to, 16)?);
        if (from..to).contains(&address) {
            println!("mapping {}", mode.ok_or("no mode")?);
            println!("segment {}", file.ok_or("no file")?);
        }
    }
    Ok(())
}

/// Asks for the lane at a point of every lane; faults of the whole.
fn ask_everywhere(
    snapshot: &Snapshot,
    faults: &mut Faults,
) -> Result<u64, Box<dyn std::error::Error>> {
    let map = snapshot.map();
    let before = faults.count()?;
    for lane in map.lanes() {
        if let Some(point) = lane.center_line().positions().next() {
            std::hint::black_box(map.nearest_lane(point.truncate(), &NearestOptions::default())?);
        }
    }
    Ok(faults.count()? - before)
}

fn populated(map: &str, file: &str) -> Outcome {
    let mut faults = Faults::new()?;
    let file = Snapshot::open(file)?;
    for _ in 0..3 {
        ask_everywhere(&file, &mut faults)?;
    }
    for (name, populate) in [("without", false), ("with", true)] {
        // Another attach maps the segment anew.
        let client = connect_to(map, WAIT)?;
        client.set_populate(populate);
        println!("{name} {}", ask_everywhere(&client.snapshot(), &mut faults)?);
    }
    Ok(())
}

fn hold(map: &str) -> Outcome {
    let client = connect_to(map, WAIT)?;
    client.set_populate(true);
    let mut faults = Faults::new()?;
    ask_everywhere(&client.snapshot(), &mut faults)?;
    println!("held {}", client.snapshot().bytes().len());
    std::io::stdin().read_line(&mut String::new())?;
    Ok(())
}

fn locked(map: &str) -> Outcome {
    /// `MCL_FUTURE`: what is mapped from now on.
    const FUTURE: usize = 2;
    // SAFETY: locking pages changes nothing that anybody sees in them.
    unsafe { raw_syscall!(Sysno::mlockall, FUTURE) };
    let client = connect_to(map, WAIT)?;
    ask_everywhere(&client.snapshot(), &mut Faults::new()?)?;
    println!("locked {}", client.snapshot().bytes().len());
    Ok(())
}

fn empty() -> Outcome {
    silence_iceoryx2();
    let config = iceoryx2_config(&Domain::from_env()?)?;
    let node = NodeBuilder::new()
        .config(&config)
        .signal_handling_mode(SignalHandlingMode::Disabled)
        .create::<TransportService>()?;
    println!("held 0");
    std::io::stdin().read_line(&mut String::new())?;
    drop(node);
    Ok(())
}

fn write(map: &str) -> Outcome {
    let client = connect_to(map, WAIT)?;
    let snapshot = client.snapshot();
    let address = snapshot.bytes().as_ptr().cast_mut();
    println!("writing");
    // SAFETY: none: this is the crime whose punishment is tested. The page is mapped without the right to write, so that
    // the kernel ends the process before anything else can observe it.
    unsafe { address.write_volatile(0) };
    println!("written");
    Ok(())
}
