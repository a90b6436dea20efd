//! What changes today's road, in time: from publishing an overlay, and from asking a daemon for it, until a waiting reader has it; asking for news where there is none; and
//! compiling a map with a patch against without. Fails where a reader waits longer than a millisecond, in the median, for an overlay of up to 1,000 entries.

use mapd::control::{OverlayAction, Request, Response, ask};
use mapd::serve::{OverlayBytes, PublishMeta, Server, StopSignal};
use mapd_archive::{HEADER_LENGTH, Header};
use mapd_benches::{best, best_computed, maps, percentiles, print};
use mapd_client::{Attach, Client, Domain, Map, Snapshot};
use mapd_compiler::{CompileOptions, ReadOptions, compile, compile_from};
use mapd_tests::overlays::over;
use mapd_tests::town::town;
use mapd_xodr::Patch;
use std::fs::File;
use std::hint::black_box;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::sync::Arc;
use std::sync::mpsc::channel;
use std::time::{Duration, Instant, UNIX_EPOCH};

/// Overlays that a client waits for.
const REVISIONS: u64 = 500;
/// Pause between two of them: the client waits again by then.
const PAUSE: Duration = Duration::from_millis(5);
/// Longest wait for anything.
const WAIT: Duration = Duration::from_secs(60);
/// Blocks of the town that they are laid over, in either direction.
const BLOCKS: usize = 48;
/// Entries of overlays.
const ENTRIES: [usize; 3] = [1, 1_000, 10_000];
/// Most entries for which [`LATEST`] holds: writing the file of more takes longer by itself.
const PROMPT: usize = 1_000;
/// Longest median from publishing an overlay until a waiting client has it.
const LATEST: Duration = Duration::from_millis(1);
/// Overlays that a daemon is asked for.
const ASKED: u64 = 200;
/// Times that a client asks for news.
const LOOKS: u32 = 1_000_000;

fn main() -> ExitCode {
    let text = town(BLOCKS, BLOCKS);
    let compiled = compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {});
    let compiled = compiled.expect("reading works");
    let rows = compiled.rows.expect("accepted");
    let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    let snapshot = Snapshot::from_bytes(archive).expect("opens");
    let medians = ENTRIES.map(|count| waiting(&snapshot, count));
    let folder = tempfile::tempdir().expect("a folder");
    asking(&snapshot, &text, folder.path());
    for (name, path) in maps(folder.path()) {
        patching(name, &path, folder.path());
    }
    let mut code = ExitCode::SUCCESS;
    for (entries, median) in ENTRIES.into_iter().zip(medians) {
        if entries <= PROMPT && median > LATEST {
            print(&format!("{entries} entries: EXCEEDED, at most {LATEST:?} in the median"));
            code = ExitCode::FAILURE;
        }
    }
    code
}

/// From just before a daemon is asked for an entry until a client that waits has it: reading, resolving and the synced write of the state are in between. And what a client
/// pays that asks for news.
fn asking(snapshot: &Snapshot, text: &str, folder: &Path) {
    let map = folder.join("town.xodr");
    std::fs::write(&map, text).expect("the town is written");
    let domain = Domain::new(&format!("mapdasked{}_", std::process::id())).expect("a prefix");
    let mut command = Command::new(env!("CARGO_BIN_EXE_mapd_under_bench"));
    command.arg("--load").arg(&map).arg("--cache").arg(folder.join("cache"));
    command.env("MAPD_PREFIX", domain.prefix()).stderr(Stdio::null());
    let mut daemon = command.spawn().expect("starts");
    let client = Client::connect_as(Attach::Observer, &domain, "town", WAIT).expect("attaches");
    let lane = snapshot.map().lanes().find(|lane| lane.number() != 0).expect("a lane");
    let key = lane.key();
    let apply = |revision: u64| {
        let document = format!(
            r#"{{"entries":[{{"id":"1","kind":"closed","text":"{revision}","lanes":[{{"key":"{key}"}}]}}]}}"#
        );
        let (feed, unread, ended) = (None, Vec::new(), Vec::new());
        let action = OverlayAction::Apply { document, feed, unread, ended, signature: None };
        let request = Request::Overlay { map: "town".to_owned(), action };
        let answer = ask(&domain, "town", &request, WAIT).expect("an answer");
        assert!(matches!(answer, Response::Overlay(_)), "{answer:?}");
    };
    let mut times = Vec::new();
    for revision in 0..ASKED {
        std::thread::sleep(PAUSE);
        let taken = std::thread::scope(|scope| {
            let asks = scope.spawn(|| {
                std::thread::sleep(PAUSE);
                let begun = Instant::now();
                apply(revision);
                begun
            });
            assert!(client.wait_change(WAIT).expect("no error"), "it came");
            let now = Instant::now();
            now.duration_since(asks.join().expect("asked"))
        });
        times.push(taken);
        let own = client.snapshot();
        let said = own.view(UNIX_EPOCH).entries().next().map(|entry| entry.text().to_owned());
        assert_eq!(said, Some(revision.to_string()));
    }
    let (median, late) = percentiles(times);
    print(&format!(
        "a daemon that is asked for one entry: a waiting client has it {median:.2?} (99 %: {late:.2?}) after, {ASKED} times"
    ));
    let cache = std::fs::read_dir(folder.join("cache")).expect("a folder");
    let names = cache.map(|entry| entry.expect("an entry").path());
    let state = names.into_iter().find(|path| path.to_string_lossy().ends_with(".overlay.json"));
    synced(&std::fs::read(state.expect("the state")).expect("the state"), folder);
    let looks = best(3, || {
        for _ in 0..LOOKS {
            black_box(client.refresh().expect("the map"));
        }
    });
    print(&format!("asking for news where there is none: {:.0?} each", looks / LOOKS));
    Command::new("kill").arg(daemon.id().to_string()).status().expect("kill runs");
    daemon.wait().expect("waited for");
}

/// What the disk takes of that: the daemon's state written, synced and renamed by itself, with the folder synced.
fn synced(state: &[u8], folder: &Path) {
    let (draft, place) = (folder.join("state.new"), folder.join("state"));
    let write = || -> std::io::Result<()> {
        let mut file = File::create(&draft)?;
        file.write_all(state)?;
        file.sync_all()?;
        std::fs::rename(&draft, &place)?;
        File::open(folder)?.sync_all()
    };
    let times = (0..ASKED).map(|_| {
        std::thread::sleep(PAUSE);
        let begun = Instant::now();
        write().expect("the state is written");
        begun.elapsed()
    });
    let (median, late) = percentiles(times.collect());
    print(&format!(
        "its state of {} B, written, synced and renamed by itself: {median:.2?} (99 %: {late:.2?}), {ASKED} times",
        state.len()
    ));
}

/// Bytes of an overlay that closes the middle of as many lanes.
fn overlay(map: Map<'_>, entries: usize, revision: u64) -> OverlayBytes {
    let lanes = map.lanes().filter(|lane| lane.number() != 0).take(entries);
    let all = lanes.enumerate().map(|(i, lane)| {
        let (key, text) = (lane.key(), revision);
        format!(r#"{{"id":"{i}","kind":"closed","text":"{text}","lanes":[{{"key":"{key}"}}]}}"#)
    });
    let document = format!(r#"{{"entries":[{}]}}"#, all.collect::<Vec<_>>().join(","));
    let (bytes, _) = over(map, &document, false);
    let header = Header::decode(&bytes[..HEADER_LENGTH]).expect("a header");
    OverlayBytes { revision, content_hash: header.content_hash, bytes: bytes.to_vec() }
}

/// From just before an overlay is published until a client that waits has it and has asked it: the median.
fn waiting(snapshot: &Snapshot, entries: usize) -> Duration {
    let domain = Domain::new(&format!("mapdover{}_", std::process::id())).expect("a prefix");
    let stop = StopSignal::new().expect("a signal");
    let (ready, served) = channel();
    let (begun, begins) = channel();
    let kinds = [1, 2].map(|revision| overlay(snapshot.map(), entries, revision));
    let length = kinds[0].bytes.len();
    let times = std::thread::scope(|scope| {
        let (stop, domain) = (&stop, &domain);
        scope.spawn(move || {
            let mut server = Server::start(domain).expect("starts");
            let (bytes, header) = (snapshot.bytes(), snapshot.header());
            let fill = |loan: &mut [u8]| {
                loan.copy_from_slice(bytes);
                let (layout_id, content_hash) = ([0; 32], header.content_hash);
                Ok(PublishMeta { layout_id, content_hash, input_hash: [0; 32] })
            };
            server.publish("map", bytes.len(), fill).expect("publishes");
            ready.send(()).expect("told");
            // Until the client has attached.
            server.run(stop).expect("serves");
            for revision in 1..=REVISIONS {
                std::thread::sleep(PAUSE);
                let one = OverlayBytes { revision, ..kinds[revision as usize % 2].clone() };
                begun.send(Instant::now()).expect("told");
                server.lay("map", Some(&one)).expect("lays");
            }
            std::thread::sleep(PAUSE * 20);
        });
        served.recv().expect("serves");
        let client = Client::connect_as(Attach::Observer, domain, "map", WAIT).expect("attaches");
        stop.request();
        let mut times = Vec::new();
        while (times.len() as u64) < REVISIONS {
            assert!(client.wait_change(WAIT).expect("no error"), "it came");
            let snapshot = client.snapshot();
            assert_eq!(snapshot.view(UNIX_EPOCH).entries().count(), entries);
            let now = Instant::now();
            // Whatever else came meanwhile was seen with it.
            while (times.len() as u64) < snapshot.overlay_revision() {
                times.push(now.duration_since(begins.recv().expect("told")));
            }
        }
        times
    });
    let (median, late) = percentiles(times);
    print(&format!(
        "an overlay of {entries} entries ({length} B): a waiting client has it {median:.2?} (99 %: {late:.2?}) after it is published, {REVISIONS} times"
    ));
    median
}

/// A compilation with a patch that replaces roads by themselves, against one without.
fn patching(name: &str, path: &Path, folder: &Path) {
    let text = std::fs::read_to_string(path).expect("the map");
    let document = mapd_benches::own_roads(&text);
    let roads = document.matches("<road ").count();
    let file = folder.join("patch.xodr");
    std::fs::write(&file, &document).expect("the patch is written");
    let patch = Patch::removing(Vec::new()).with_document(file, document.into_bytes());
    let patch = Arc::new(patch.expect("a patch"));
    let runs = if text.len() > 50_000_000 { 3 } else { 10 };
    let options = CompileOptions::default();
    let [plain, patched] = [None, Some(patch)].map(|patch| {
        let reading = ReadOptions { patch, ..ReadOptions::default() };
        best_computed(runs, || {
            let from = || std::fs::File::open(path);
            let compiled = compile_from(from, &reading, &options, &mut |_| {}).expect("compiles");
            let rows = compiled.rows.expect("accepted");
            let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
            mapd_archive::verify(&archive).expect("proves");
        })
    });
    let more = |with: Duration, without: Duration| {
        100.0 * (with.as_secs_f64() / without.as_secs_f64() - 1.0)
    };
    print(&format!(
        "{name} with a patch of {} roads: {:.1?}, without {:.1?} ({:+.1} %); computed {:.1?} and {:.1?} ({:+.1} %)",
        roads,
        patched.0,
        plain.0,
        more(patched.0, plain.0),
        patched.1,
        plain.1,
        more(patched.1, plain.1)
    ));
}
