//! The same bytes from the same input: twice, from one and two threads, over dirty memory, and on every machine.

use mapd_archive::{AlignedBytes, encode, encode_into, encoded_length};
use mapd_compiler::{CompileOptions, compile};
use std::path::Path;

/// Content hashes of the carried maps with the options' defaults, and in target frames whose functions are the same on every
/// machine. They change when the format or the compiler changes;
/// then this is where the change is owned up to.
const GOLDEN: [(&str, &str, &str); 4] = [
    ("one_road.xodr", "", "3f3c6bda366a20e2ec5335f59163a4118b87ba370d00a11b01bde819639ffec4"),
    ("town.xodr", "", "510a5177e2a4876c71a9b2f75f3485e2bef619c67104e619e24467b261906422"),
    ("one_road.xodr", "utm", "0591a1b7d85ac2419217782ccce67b0069e6f8d06116ca8e2dad5b182c91a3f0"),
    (
        "one_road.xodr",
        "enu:48,11,500",
        "a0d14258e353f5cc848c26d68a3e0b5bae9f3d50979bcb9ce581de9d050cb216",
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
