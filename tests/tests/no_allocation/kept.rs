//! Attached and let go, opened and closed, ten thousand times: this process is left as it was.

use crate::LIVE;
use mapd_client::{Client, Domain, NearestOptions, Snapshot, glam::DVec2};
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use std::cell::Cell;
use std::path::Path;

/// Times that a map is attached to, and a file opened.
const TIMES: usize = 10_000;
/// Times before that: what is made once in a process is made then.
const WARM: usize = 10;

/// What a process has of places whose names contain a text: mappings, then open files.
fn held(of: &str) -> [usize; 2] {
    let maps = std::fs::read_to_string("/proc/self/maps").expect("readable");
    let files = std::fs::read_dir("/proc/self/fd").expect("readable").flatten();
    let targets = files.filter_map(|file| std::fs::read_link(file.path()).ok());
    [
        maps.lines().filter(|line| line.contains(of)).count(),
        targets.filter(|target| target.to_string_lossy().contains(of)).count(),
    ]
}

fn answers(snapshot: &Snapshot) {
    let hit = snapshot.map().nearest_lane(DVec2::new(50.0, -1.75), &NearestOptions::default());
    assert!(hit.expect("finite").is_some_and(|hit| hit.position.distance == 0.0));
}

fn attach(domain: &Domain) {
    let client = Client::connect_in(domain, "town", PATIENCE).expect("attaches");
    let mut events = client.events();
    answers(&client.snapshot());
    let event = events.next(std::time::Duration::ZERO).expect("no error");
    assert!(event.is_none(), "an event");
}

fn open(archive: &Path) {
    answers(&Snapshot::open(archive).expect("opens"));
}

/// Nothing is kept, neither at once nor a little each time.
fn leaves_nothing(what: &str, of: &str, mut once: impl FnMut()) {
    (0..WARM).for_each(|_| once());
    let before = LIVE.with(Cell::get);
    (0..TIMES).for_each(|_| once());
    let kept = LIVE.with(Cell::get) - before;
    assert_eq!((kept, held(of)), (0, [0, 0]), "{what} {TIMES} times: bytes; mappings, files");
}

#[test]
fn nothing_is_kept_of_ten_thousand_attaches() {
    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    let _daemon = place.serve(&[&mapd_tests::carried("town.xodr").display().to_string()]);
    let domain = place.domain();
    let prefix = domain.prefix().to_owned();
    let client = Client::connect_in(&domain, "town", PATIENCE).expect("attaches");
    assert_ne!(held(&prefix)[0], 0, "what is held is seen");
    drop(client);
    leaves_nothing("attached", &prefix, || attach(&domain));
}

#[test]
fn nothing_is_kept_of_ten_thousand_opened_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let archive = folder.path().join("town.mapd");
    let file = std::fs::File::open(mapd_tests::carried("town.xodr")).expect("opens");
    let options = mapd_compiler::CompileOptions::default();
    let compiled = mapd_compiler::compile(file, &options, &mut |_| {}).expect("reads");
    let rows = compiled.rows.expect("accepted");
    let bytes = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    std::fs::write(&archive, &bytes).expect("written");
    leaves_nothing("opened", &archive.display().to_string(), || open(&archive));
}
