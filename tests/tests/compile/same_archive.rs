//! The same archive, whatever form the map comes in and however many threads compile it.

use mapd_archive::{
    AlignedBytes, AnnotationEntry, AnnotationRow, HEADER_LENGTH, Header, Provenance, encode,
};
use mapd_compiler::{CompileOptions, Extra, ReadOptions, compile_from};
use mapd_tests::test_domain::{PATIENCE, TestDomain, slow};
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command};
use std::time::{Duration, Instant};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// The last line of the carried town's header.
const HEADER_END: &str = "vendor=\"mapd\"/>\n";

fn run(args: &[&str]) -> (String, Option<i32>) {
    let output = Command::new(MAPD).args(args).output().expect("runs");
    let text =
        [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    (text.concat(), output.status.code())
}

fn text(path: &Path) -> String {
    path.display().to_string()
}

/// Compiles a file, as options have it.
fn archive(source: &Path, options: &[&str]) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    let (source, out) = (text(source), text(&folder.path().join("out.mapd")));
    let (told, code) = run(&[&["compile", source.as_str(), "-o", out.as_str()], options].concat());
    assert_eq!(code, Some(0), "{told}");
    fs::read(out).expect("written")
}

/// An archive without what says which bytes it was read from.
fn without_input(bytes: &[u8]) -> (Header, &[u8]) {
    let (header, body) = bytes.split_at(HEADER_LENGTH);
    let mut header = Header::decode(header).expect("a header");
    header.provenance.input_hash = [0; 32];
    (header, body)
}

/// The town in a folder: as one file, compressed, and with all but its header in an included file.
fn town_in_all_forms(folder: &Path) -> [PathBuf; 3] {
    let town = fs::read_to_string(mapd_tests::carried("town.xodr")).expect("readable");
    let end = town.find(HEADER_END).expect("a header") + HEADER_END.len();
    let (head, rest) = town.split_at(end);
    let at = |name: &str| folder.join(name);
    fs::write(at("town.xodr"), &town).expect("written");
    let compressed = File::create(at("town.xodrz")).expect("made");
    let mut gzip = flate2::write::GzEncoder::new(compressed, flate2::Compression::default());
    gzip.write_all(town.as_bytes()).expect("compresses");
    gzip.finish().expect("compresses");
    let main = format!("{head}<include file=\"rest.xml\"/>\n</OpenDRIVE>");
    fs::write(at("main.xodr"), main).expect("written");
    fs::write(at("rest.xml"), format!("<OpenDRIVE>{rest}")).expect("written");
    ["town.xodr", "town.xodrz", "main.xodr"].map(at)
}

/// Where things stand in which file is part of an archive. Without that, as an archive.
fn without_places(source: &Path) -> AlignedBytes {
    let include_folder = source.parent().map(Path::to_owned);
    let reading = ReadOptions { include_folder, ..ReadOptions::default() };
    let open = || File::open(source);
    let without = [Extra::Includes].into_iter().collect();
    let options = CompileOptions { without, ..CompileOptions::default() };
    let compiled = compile_from(open, &reading, &options, &mut |_| {});
    let mut rows = compiled.expect("read").rows.expect("accepted");
    rows.roads.iter_mut().for_each(|road| (road.line, road.column) = (0, 0));
    rows.junctions.iter_mut().for_each(|place| (place.line, place.column) = (0, 0));
    rows.edges.iter_mut().for_each(|edge| (edge.line, edge.column, edge.file) = (0, 0, 0));
    let annotations = rows.as_tables().all_annotations();
    let nowhere =
        |entry: AnnotationEntry<'_>| AnnotationRow { line: 0, column: 0, ..entry.in_full() };
    let annotations: Vec<AnnotationRow> = annotations.map(nowhere).collect();
    rows.set_annotations(&annotations);
    encode(&rows, &Provenance::default()).expect("encodes")
}

#[test]
fn from_plain_compressed_and_included_text() {
    let folder = tempfile::tempdir().expect("a folder");
    let [plain, compressed, included] = town_in_all_forms(folder.path());
    let (plain_bytes, bytes) = (archive(&plain, &[]), archive(&compressed, &[]));
    assert!(without_input(&bytes) == without_input(&plain_bytes));
    assert!(bytes != plain_bytes, "it is another input");
    assert!(without_places(&included)[..] == without_places(&plain)[..]);
}

#[test]
fn from_any_number_of_threads() {
    let mut maps = vec![mapd_tests::carried("town.xodr"), mapd_tests::carried("one_road.xodr")];
    match mapd_tests::shared("maps") {
        Some(shared) => maps.push(shared.join("carla/Town05.xodr")),
        None => mapd_tests::say("SKIPPED in part: no shared corpus beside the workspace"),
    }
    for map in &maps {
        let source = text(map);
        let once = archive(map, &["--threads", "1"]);
        let check =
            |threads: &str| run(&["check", &source, "--format", "json", "--threads", threads]);
        let findings = check("1");
        for threads in ["2", "8"] {
            assert!(archive(map, &["--threads", threads]) == once, "{source}: {threads}");
            assert!(check(threads) == findings, "{source}: {threads}");
        }
        // In a child with a ceiling as well.
        let limited = archive(map, &["--threads", "2", "--max-memory", "1GiB"]);
        assert!(limited == once, "{source}");
    }
}

/// Threads of a process that waits for a map that does not come.
struct Waiting(Child);

impl Waiting {
    /// Waits until the process has so many threads.
    fn has(&self, threads: usize, what: &str) {
        has_threads(self.0.id(), threads, what);
    }
}

impl Drop for Waiting {
    fn drop(&mut self) {
        // It has ended, then.
        let _ = self.0.kill().and_then(|()| self.0.wait());
    }
}

fn has_threads(process: u32, expected: usize, what: &str) {
    let count = || fs::read_dir(format!("/proc/{process}/task")).map_or(0, Iterator::count);
    let until = Instant::now() + PATIENCE;
    while count() != expected {
        assert!(Instant::now() < until, "{what}: {} threads, expected {expected}", count());
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// The number that is asked for is the number that there are: seen while a pipe is waited for, and, as a daemon takes no pipe, while a long file is read.
#[test]
fn as_many_threads_as_are_asked_for() {
    let place = TestDomain::new(MAPD);
    let folder = tempfile::tempdir().expect("a folder");
    let pipe = text(&folder.path().join("map.xodr"));
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("runs").success());
    let long = text(&folder.path().join("long.xodr"));
    let town = fs::read(mapd_tests::carried("town.xodr")).expect("a map");
    fs::write(&long, slow(&town)).expect("written");
    let wait = |args: &[&str]| {
        let mut command = place.command();
        Waiting(command.args(args).spawn().expect("starts"))
    };
    for threads in [1, 3] {
        let number = threads.to_string();
        let options = ["--threads", number.as_str()];
        let out = text(&folder.path().join("out.mapd"));
        let compile = [&["compile", pipe.as_str(), "-o", out.as_str()], &options[..]].concat();
        wait(&compile).has(1 + threads, "compile");
        wait(&[&["check", pipe.as_str()], &options[..]].concat()).has(1 + threads, "check");
        let daemon = wait(&[&["--load", long.as_str(), "--no-cache"], &options[..]].concat());
        let compiler = compiler_of(daemon.0.id());
        has_threads(compiler, 1 + threads, "--load");
    }
}

/// The child of a daemon.
fn compiler_of(daemon: u32) -> u32 {
    let until = Instant::now() + PATIENCE;
    loop {
        // The thread that waits for it has made it.
        let tasks = fs::read_dir(format!("/proc/{daemon}/task")).expect("threads");
        let children = tasks.flatten().filter_map(|task| {
            fs::read_to_string(task.path().join("children"))
                .ok()?
                .split_whitespace()
                .next()?
                .parse()
                .ok()
        });
        if let Some(child) = { children }.next() {
            return child;
        }
        assert!(Instant::now() < until, "nobody compiles");
        std::thread::sleep(Duration::from_millis(5));
    }
}
