//! The same bytes from the same input: twice, from one and two threads, over dirty memory, and on every machine.

use mapd_archive::{AlignedBytes, encode, encode_into, encoded_length};
use mapd_compiler::{CompileOptions, compile};
use std::path::Path;

/// Content hashes of the carried maps with the options' defaults. They change when the layout or the compiler changes;
/// then this is where the change is owned up to.
const GOLDEN: [(&str, &str); 2] = [
    ("one_road.xodr", "95d6df459341f2c739685c657c0f04b60d407dc7fc1e9e7b2157c034c1dc1f45"),
    ("town.xodr", "a553507c7a2eeefbe0f8d4269b1a0abe85e4cec2a4eaee14edbf0595b6dfb9b6"),
];

fn archive(path: &Path, threads: usize) -> AlignedBytes {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    pool.install(|| {
        let file = std::fs::File::open(path).expect("the map can be read");
        let compiled =
            compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
        encode(&compiled.rows.expect("accepted"), &compiled.provenance).expect("encodes")
    })
}

fn check(path: &Path) {
    let once = archive(path, 1);
    for (what, other) in [
        ("again", archive(path, 1)),
        ("two threads", archive(path, 2)),
        ("eight", archive(path, 8)),
    ] {
        assert!(once[..] == other[..], "{}: {what} gives other bytes", path.display());
    }
}

#[test]
fn the_same_bytes_from_any_number_of_threads() {
    check(&mapd_tests::carried("one_road.xodr"));
    check(&mapd_tests::carried("town.xodr"));
    match mapd_tests::shared("maps") {
        Some(maps) => check(&maps.join("carla/Town05.xodr")),
        None => mapd_tests::say("SKIPPED in part: no shared corpus beside the workspace"),
    }
}

#[test]
fn golden_hashes() {
    let found = GOLDEN.map(|(name, _)| {
        let bytes = archive(&mapd_tests::carried(name), 2);
        let header = mapd_archive::open(&bytes).expect("opens").header;
        (name, header.content_hash.iter().map(|byte| format!("{byte:02x}")).collect::<String>())
    });
    let expected = GOLDEN.map(|(name, hash)| (name, hash.to_owned()));
    assert_eq!(found, expected, "maps compile to other bytes than before");
}

#[test]
fn what_the_destination_held_does_not_show() {
    let file = std::fs::File::open(mapd_tests::carried("town.xodr")).expect("the map can be read");
    let compiled = compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
    let rows = compiled.rows.expect("accepted");
    let clean = encode(&rows, &compiled.provenance).expect("encodes");
    let mut dirty = AlignedBytes::new();
    dirty.resize(encoded_length(&rows).expect("a length"), 0xa5);
    encode_into(&rows, &compiled.provenance, &mut dirty).expect("encodes");
    assert!(clean[..] == dirty[..]);
}

#[test]
fn the_carried_town_is_what_the_generator_writes() {
    let carried =
        std::fs::read_to_string(mapd_tests::carried("town.xodr")).expect("the map can be read");
    assert!(carried == mapd_tests::town::town(3, 3), "run make_town again");
}
