//! The same bytes from the same input: twice, from one and two threads, over dirty memory, and on every machine.

use mapd_archive::{AlignedBytes, encode, encode_into, encoded_length};
use mapd_compiler::{CompileOptions, compile};
use std::path::Path;

/// Content hashes of the carried maps with the options' defaults, and in target frames whose functions are the same on every
/// machine. They change when the format or the compiler changes;
/// then this is where the change is owned up to.
const GOLDEN: [(&str, &str, &str); 4] = [
    ("one_road.xodr", "", "34458416cfc6d3f66c1233ae75cafef323a8f170f53c838fbaf7f487ba264394"),
    ("town.xodr", "", "510a5177e2a4876c71a9b2f75f3485e2bef619c67104e619e24467b261906422"),
    ("one_road.xodr", "utm", "531d610abf5f3818392eb7cc56565b50beda65bb5eede6afe88a3ae02d8d863a"),
    (
        "one_road.xodr",
        "enu:48,11,500",
        "e3456a8e06572df51823bafd14f2db18e941eaf4c885231746d6ebd09b8fc932",
    ),
];

fn archive(path: &Path, crs: &str, threads: usize) -> AlignedBytes {
    let crs = (!crs.is_empty()).then(|| crs.parse().expect("a target"));
    let options = CompileOptions { crs, ..CompileOptions::default() };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    pool.install(|| {
        let file = std::fs::File::open(path).expect("the map can be read");
        let compiled = compile(file, &options, &mut |_| {}).expect("reading works");
        encode(&compiled.rows.expect("accepted"), &compiled.provenance).expect("encodes")
    })
}

fn check(path: &Path, crs: &str) {
    let once = archive(path, crs, 1);
    for (what, other) in [
        ("again", archive(path, crs, 1)),
        ("two threads", archive(path, crs, 2)),
        ("eight", archive(path, crs, 8)),
    ] {
        assert!(once[..] == other[..], "{}: {what} gives other bytes", path.display());
    }
}

#[test]
fn the_same_bytes_from_any_number_of_threads() {
    check(&mapd_tests::carried("one_road.xodr"), "");
    check(&mapd_tests::carried("one_road.xodr"), "epsg:31468");
    check(&mapd_tests::carried("town.xodr"), "");
    match mapd_tests::shared("maps") {
        Some(maps) => {
            check(&maps.join("carla/Town05.xodr"), "");
            check(&maps.join("carla/Town05.xodr"), "utm");
        }
        None => mapd_tests::say("SKIPPED in part: no shared corpus beside the workspace"),
    }
}

#[test]
fn golden_hashes() {
    let found = GOLDEN.map(|(name, crs, _)| {
        let bytes = archive(&mapd_tests::carried(name), crs, 2);
        let header = mapd_archive::open(&bytes).expect("opens").header;
        (
            name,
            crs,
            header.content_hash.iter().map(|byte| format!("{byte:02x}")).collect::<String>(),
        )
    });
    let expected = GOLDEN.map(|(name, crs, hash)| (name, crs, hash.to_owned()));
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
    assert!(carried == mapd_tests::town::town(3, 3), "run make_map again");
}
