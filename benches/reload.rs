//! How soon a waiting client has a new generation, and how soon a killed daemon's successor serves again.

use mapd::serve::{PublishMeta, Server, StopSignal};
use mapd_benches::{best, maps, percentiles, print};
use mapd_client::Domain;
use mapd_transport::Subscription;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::channel;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Generations that a client waits for.
const GENERATIONS: usize = 200;

/// Pause between two of them: the client waits again by then.
const PAUSE: Duration = Duration::from_millis(10);

/// Restarts of a killed daemon, of each map.
const RESTARTS: usize = 7;

/// A file is believed to be what it was without being read once it is older.
const SETTLED: Duration = Duration::from_secs(3);

/// Longest wait for anything.
const WAIT: Duration = Duration::from_secs(60);

fn main() {
    waiting();
    let folder = tempfile::tempdir().expect("a folder");
    for (name, path) in maps(folder.path()) {
        restarting(name, &path, folder.path());
    }
}

fn unix_ns() -> u64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    u64::try_from(now.as_nanos()).unwrap_or(u64::MAX)
}

/// From just before a generation is sent until a client that waits for it has it.
fn waiting() {
    let bytes = vec![7; 1 << 20];
    let domain = Domain::new(&format!("mapdwait{}_", std::process::id())).expect("a prefix");
    let stop = StopSignal::new().expect("a signal");
    let (ready, served) = channel();
    let times = std::thread::scope(|scope| {
        let (stop, domain) = (&stop, &domain);
        scope.spawn(move || {
            let mut server = Server::start(domain).expect("starts");
            let publish = |server: &mut Server| {
                let fill = |loan: &mut [u8]| {
                    loan.copy_from_slice(&bytes);
                    let none = [0; 32];
                    Ok(PublishMeta { layout_id: none, content_hash: none, input_hash: none })
                };
                server.publish("map", bytes.len(), fill).expect("publishes")
            };
            publish(&mut server);
            ready.send(()).expect("told");
            // Until the client has attached.
            server.run(stop).expect("serves");
            for _ in 0..GENERATIONS {
                std::thread::sleep(PAUSE);
                publish(&mut server);
            }
            // What has been sent stays to be taken for a while.
            std::thread::sleep(PAUSE * 20);
        });
        served.recv().expect("serves");
        let until = Instant::now() + WAIT;
        let subscription = Subscription::connect(domain, "map", until).expect("attaches");
        let (mut last, mut times) = (subscription.current().info().generation, Vec::new());
        let end = last + GENERATIONS as u64;
        stop.request();
        while last < end {
            let pinned = subscription.wait_newer(last, until).expect("the next");
            let (now, info) = (unix_ns(), *pinned.info());
            last = info.generation;
            times.push(Duration::from_nanos(now.saturating_sub(info.published_unix_ns)));
        }
        times
    });
    let (count, (median, late)) = (times.len(), percentiles(times));
    print(&format!(
        "a waiting client has a new generation {median:.0?} (99 %: {late:.0?}) after it is published, {count} times"
    ));
}

/// From exec until a killed daemon's successor serves, against reading, copying and verifying the same archive.
fn restarting(name: &str, map: &Path, folder: &Path) {
    let prefix = format!("mapdagain{}_", std::process::id());
    let cache = folder.join(format!("cache-{name}"));
    let serve = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_mapd_under_bench"));
        command.env("MAPD_PREFIX", &prefix).arg("--load").arg(map).arg("--cache").arg(&cache);
        let start = Instant::now();
        let mut daemon = command.stderr(Stdio::piped()).spawn().expect("starts");
        let lines = BufReader::new(daemon.stderr.take().expect("stderr")).lines();
        let serving = |line: &std::io::Result<String>| {
            line.as_ref().is_ok_and(|line| line.contains("serving"))
        };
        let said = lines.into_iter().find(serving).expect("it serves").expect("text");
        (daemon, start.elapsed(), said)
    };
    let kill = |mut daemon: Child| {
        daemon.kill().expect("killed");
        daemon.wait().expect("waited for");
    };
    let (first, compiled, _) = serve();
    kill(first);
    std::thread::sleep(SETTLED);
    let mut times = Vec::new();
    for number in 0..=RESTARTS {
        let (daemon, time, said) = serve();
        assert!(said.contains("from the cache"), "{said}");
        kill(daemon);
        // The first one notes that the map's file is what it was.
        if number > 0 {
            times.push(time);
        }
    }
    // The domain is deserted: the next daemon would empty it.
    let (last, ..) = serve();
    Command::new("kill").arg(last.id().to_string()).status().expect("kill runs");
    let mut last = last;
    last.wait().expect("waited for");
    let entries = std::fs::read_dir(&cache).expect("the cache").flatten();
    let archive = entries.map(|e| e.path()).find(|p| p.extension().is_some_and(|e| e == "mapd"));
    let archive = archive.expect("an archive");
    let bytes = std::fs::metadata(&archive).expect("there").len();
    let floor = best(3, || {
        let bytes = std::fs::read(&archive).expect("readable");
        let mut copy = mapd_archive::AlignedBytes::with_capacity(bytes.len());
        copy.extend_from_slice(&bytes);
        mapd_archive::verify(&copy).expect("proves");
    });
    let (median, _) = percentiles(times);
    let beyond = median.saturating_sub(floor);
    print(&format!(
        "{name}: {bytes} bytes, first start {compiled:.1?}; a killed daemon's successor serves after {median:.1?}, \
         reading, copying and verifying alone take {floor:.1?}: {beyond:.1?} beyond"
    ));
}
