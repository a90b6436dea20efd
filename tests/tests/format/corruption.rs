//! Damaged archives: typed errors or merely wrong answers, never a panic or a read outside.

use mapd_archive::{
    AlignedBytes, HEADER_LENGTH, MOST_TABLES, OpenError, TableEntry, TableInfo, Tables,
    VerifyError, encode, open, verify,
};
use mapd_compiler::{CompileOptions, compile};
use mapd_tests::damage::{ask_everything, ask_rows, random, seal, seal_header};

fn archive(name: &str) -> AlignedBytes {
    let file = std::fs::File::open(mapd_tests::carried(name)).expect("the map can be read");
    let compiled = compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
    encode(&compiled.rows.expect("accepted"), &compiled.provenance).expect("encodes")
}

/// As [`archive`], moved into another frame.
fn transformed(name: &str) -> AlignedBytes {
    let file = std::fs::File::open(mapd_tests::carried(name)).expect("the map can be read");
    let options =
        CompileOptions { crs: Some("utm".parse().expect("a target")), ..CompileOptions::default() };
    let compiled = compile(file, &options, &mut |_| {}).expect("reading works");
    encode(&compiled.rows.expect("accepted"), &compiled.provenance).expect("encodes")
}

#[test]
fn every_flipped_byte_of_the_header_is_an_error() {
    let good = archive("one_road.xodr");
    for at in 0..HEADER_LENGTH {
        for bit in 0..8 {
            let mut bad = good.clone();
            bad[at] ^= 1 << bit;
            assert!(open(&bad).is_err(), "byte {at} bit {bit} of the header does not matter");
        }
    }
}

#[test]
fn every_truncation_is_an_error() {
    let good = archive("one_road.xodr");
    for length in 0..good.len() {
        let error = open(&good[..length]).err().expect("a cut archive is refused");
        assert!(
            matches!(error, OpenError::TooShort { .. } | OpenError::Length { .. }),
            "{length}: {error}"
        );
    }
}

/// Every so many bytes of the archive one is damaged for the queries; `verify` is asked about every byte.
const FLIP_STEP: usize = 7;

#[test]
fn verify_finds_a_flip_of_any_byte() {
    let mut bytes = archive("one_road.xodr");
    for at in 0..bytes.len() {
        bytes[at] ^= 0x10;
        assert!(verify(&bytes).is_err(), "a flip at {at} is not found");
        bytes[at] ^= 0x10;
    }
    verify(&bytes).expect("whole again");
}

#[test]
fn queries_survive_flips() {
    for good in [archive("one_road.xodr"), transformed("one_road.xodr")] {
        survive_flips(&good);
    }
}

fn survive_flips(good: &AlignedBytes) {
    for at in (HEADER_LENGTH..good.len()).step_by(FLIP_STEP) {
        let mut bad = good.clone();
        bad[at] ^= 0x55;
        let error = verify(&bad).err().unwrap_or_else(|| panic!("a flip at {at} is not found"));
        assert!(
            matches!(error, VerifyError::ContentHash { .. } | VerifyError::Open(_)),
            "{at}: {error}"
        );
        ask_rows(bad);
    }
    // The directory lies behind the header: every byte of it, every value that is likely to hurt.
    let tables = open(good).expect("opens").header.tables as usize;
    for at in HEADER_LENGTH..HEADER_LENGTH + tables * size_of::<TableEntry>() {
        for value in [0, 1, 0x7f, 0x80, 0xff] {
            let mut bad = good.clone();
            bad[at] = value;
            seal(&mut bad);
            ask_rows(bad);
        }
    }
}

/// Where the bytes of each table that has rows lie in the archive, by name.
fn places(tables: &Tables<'_>, base: usize) -> Vec<(&'static str, std::ops::Range<usize>)> {
    let place = |info: &TableInfo| {
        let start = info.address - base;
        (info.name, start..start + info.count * info.element_bytes)
    };
    tables.infos().iter().filter(|info| info.count > 0).map(place).collect()
}

/// Flips per table of the town.
const FLIPS: usize = 10;

#[test]
fn flips_in_every_table_are_found_and_survived_even_with_fitting_hashes() {
    for map in ["town.xodr", "surfaces.xodr", "marks.xodr", "objects.xodr"] {
        flip_every_table(&archive(map));
    }
    flip_every_table(&crossing());
    for path in mapd_tests::releases::kept() {
        let mut bytes = AlignedBytes::new();
        bytes.extend_from_slice(&std::fs::read(path).expect("readable"));
        flip_every_table(&bytes);
    }
}

/// A crossing with everything that signals can have, which fills every table of theirs.
fn crossing() -> AlignedBytes {
    let text = mapd_tests::crossroads::furnished();
    let compiled = compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {});
    let compiled = compiled.expect("reading works");
    let rows = compiled.rows.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let bytes = encode(&rows, &compiled.provenance).expect("encodes");
    let archive = verify(&bytes).expect("proves");
    let signals = |name: &str| {
        let own = ["signal", "controller", "display_areas", "board_groups", "conflicts"];
        own.iter().any(|part| name.contains(part)) && name != "default_speeds"
    };
    for info in archive.tables.infos() {
        assert!(info.count > 0 || !signals(info.name), "{} is empty", info.name);
    }
    bytes
}

/// What rows say about each other is proven: a reference moved to another row, a place left out or named twice.
#[test]
fn what_signals_and_their_index_say_is_proven() {
    let good = crossing();
    let places = places(&open(&good).expect("opens").tables, good.as_ptr() as usize);
    for (table, found) in [
        ("signal_index_items", "a place, each once"),
        ("signal_index_levels", "nodes"),
        ("object_signals", "links of objects"),
    ] {
        let (_, place) = places.iter().find(|(name, _)| *name == table).expect("a table");
        let mut bad = good.clone();
        // The last number becomes the first, or another one where there is but one.
        let [first, last] = [place.start, place.end - 4];
        bad[last] = if first == last { bad[first] ^ 1 } else { bad[first] };
        seal(&mut bad);
        let error = verify(&bad).err().unwrap_or_else(|| panic!("{table} is not proven"));
        assert!(error.to_string().contains(found), "{table}: {error}");
        ask_everything(bad);
    }
}

fn flip_every_table(good: &AlignedBytes) {
    let places = places(&open(good).expect("opens").tables, good.as_ptr() as usize);
    let mut random = Random(7);
    for (name, place) in places {
        for _ in 0..if place.is_empty() { 0 } else { FLIPS } {
            let mut bad = good.clone();
            let at = place.start + random.below(place.len());
            bad[at] ^= 1 << random.below(8);
            let error = verify(&bad).err();
            assert!(
                matches!(error, Some(VerifyError::ContentHash { .. })),
                "{name}, byte {at}: {error:?}"
            );
            seal(&mut bad);
            ask_everything(bad);
        }
    }
}

/// Found by damaging archives at random: lengths beyond 2⁵³ m, where no number is larger by 1, made loops endless that counted metres and parts of them.
#[test]
fn numbers_without_neighbours_end() {
    for map in ["one_road.xodr", "marks.xodr"] {
        let good = archive(map);
        let places = places(&open(&good).expect("opens").tables, good.as_ptr() as usize);
        for (_, place) in places.iter().filter(|(name, _)| LENGTHS.contains(name)) {
            for at in place.clone().step_by(size_of::<f64>()) {
                for value in [1e15_f64, 1e17, -1e17] {
                    let mut bad = good.clone();
                    bad[at..at + size_of::<f64>()].copy_from_slice(&value.to_le_bytes());
                    seal(&mut bad);
                    ask_everything(bad);
                }
            }
        }
    }
}

/// Tables that say how long something is.
const LENGTHS: [&str; 2] = ["geometries", "sections"];

/// Damage of every kind to every table, alone and together, the same in every run. `MAPD_DAMAGED` says how many archives are damaged; the program `damaged` of this
/// package does the same for as long as it is told to.
#[test]
fn random_damage_is_survived() {
    let crossing = crossing();
    for good in [archive("surfaces.xodr"), archive("marks.xodr"), crossing] {
        let tables =
            random::places(&open(&good).expect("opens").tables.infos(), good.as_ptr() as usize);
        for seed in 0..mapd_tests::number("MAPD_DAMAGED", 40) {
            let mut bad = good.clone();
            random::damage(&mut bad, &tables, &mut random::Random::new(seed));
            ask_everything(bad);
        }
    }
}

/// More levels than an index can have led the search round in circles.
#[test]
fn an_index_of_too_many_levels_ends() {
    let file = std::fs::File::open(mapd_tests::carried("one_road.xodr")).expect("the map is there");
    let compiled = compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
    let mut rows = compiled.rows.expect("accepted");
    for levels in [9, 17, 18, 40] {
        rows.index_levels = vec![0; levels].into();
        let bad = encode(&rows, &compiled.provenance).expect("encodes");
        assert!(verify(&bad).is_err(), "{levels} levels are not found");
        ask_everything(bad);
    }
}

/// Found by fuzzing: numbers that are none, as bounds of `f64::clamp`, made the nearest lane panic.
#[test]
fn numbers_that_are_none_do_not_panic() {
    for map in ["one_road.xodr", "surfaces.xodr", "objects.xodr"] {
        put_no_numbers(&archive(map));
    }
}

/// Tables that hold numbers in double precision.
const NUMBERS: [&str; 14] = [
    "cubics",
    "geometries",
    "sections",
    "coefficients",
    "shape_stations",
    "lane_heights",
    "elevation_grids",
    "grid_heights",
    "grid_transitions",
    "objects",
    "object_copies",
    "object_points",
    "object_references",
    "structures",
];

fn put_no_numbers(good: &AlignedBytes) {
    let places = places(&open(good).expect("opens").tables, good.as_ptr() as usize);
    for (_, place) in places.iter().filter(|(name, _)| NUMBERS.contains(name)) {
        for at in place.clone().step_by(7 * size_of::<f64>()) {
            for value in [f64::NAN, f64::INFINITY, -f64::MAX] {
                let mut bad = good.clone();
                if let Some(bytes) = bad.get_mut(at..at + size_of::<f64>()) {
                    bytes.copy_from_slice(&value.to_le_bytes());
                }
                seal(&mut bad);
                ask_everything(bad);
            }
        }
    }
}

/// Found by fuzzing: a section with a damaged count of lanes, and a lane with one of nodes, were walked through to their end,
/// four thousand million rows.
#[test]
fn damaged_counts_end_at_the_table() {
    for map in ["one_road.xodr", "objects.xodr"] {
        damage_counts(&archive(map));
    }
}

fn damage_counts(good: &AlignedBytes) {
    let opened = open(good).expect("opens");
    let base = good.as_ptr() as usize;
    for table in opened.tables.infos().iter().filter(|table| table.count > 0) {
        // The highest byte of every number of the second row, where there is one: the first lane has no nodes.
        let row = table.address - base + table.element_bytes * (table.count - 1).min(1);
        for at in (row..row + table.element_bytes).skip(3).step_by(4) {
            let mut bad = good.clone();
            bad[at] = 0x7f;
            seal(&mut bad);
            ask_everything(bad);
        }
    }
}

/// Small and repeatable (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % bound as u64) as usize
    }
}

#[test]
fn headers_of_others_are_refused_for_their_reason() {
    /// Place, bytes to write there, and which error is due.
    type Case = (&'static str, usize, Vec<u8>, fn(&OpenError) -> bool);
    let good = archive("one_road.xodr");
    let length = good.len() as u64 - HEADER_LENGTH as u64;
    let is_length = |error: &OpenError| matches!(error, OpenError::Length { .. });
    let is_directory = |error: &OpenError| matches!(error, OpenError::Directory { .. });
    let cases: [Case; 10] = [
        ("mark", 0, b"PK\x03\x04....".to_vec(), |e| matches!(e, OpenError::NotAnArchive { .. })),
        ("byte order", 8, good[8..12].iter().rev().copied().collect(), |e| {
            matches!(e, OpenError::Endianness)
        }),
        ("no byte order", 8, vec![0; 4], |e| matches!(e, OpenError::Endianness)),
        ("format", 12, vec![0xff; 4], |e| matches!(e, OpenError::Format { found: u32::MAX, .. })),
        ("format of old", 12, vec![1, 0, 0, 0], |e| {
            matches!(e, OpenError::Format { found: 1, .. })
        }),
        ("a feature of later", 16, vec![0, 0, 1], |e| {
            matches!(e, OpenError::NotUnderstood { bit: 16, .. })
        }),
        ("too many tables", 24, (MOST_TABLES + 1).to_le_bytes().to_vec(), is_directory),
        ("more tables than bytes", 24, MOST_TABLES.to_le_bytes().to_vec(), is_directory),
        ("longer", 32, (length + 1).to_le_bytes().to_vec(), is_length),
        ("endless", 32, u64::MAX.to_le_bytes().to_vec(), is_length),
    ];
    for (name, at, bytes, is_due) in cases {
        let mut bad = good.clone();
        bad[at..at + bytes.len()].copy_from_slice(&bytes);
        seal_header(&mut bad);
        let error = open(&bad).err().unwrap_or_else(|| panic!("{name}: opened"));
        assert!(is_due(&error), "{name}: {error}");
    }
}

/// What the command says of a file that is no archive, or a damaged one: an exit code, a sentence, no panic.
#[test]
fn the_command_names_what_is_wrong_with_a_file() {
    let good = archive("one_road.xodr");
    let folder = tempfile::tempdir().expect("a folder");
    let flipped = |at: usize| {
        let mut bytes = good.to_vec();
        bytes[at] ^= 4;
        bytes
    };
    let cases: [(&str, Vec<u8>, &str); 7] = [
        ("empty", Vec::new(), "at least 128 bytes"),
        ("text", b"not a map at all\n".repeat(20), "not a mapd archive"),
        ("cut", good[..good.len() - 1].to_vec(), "cut off"),
        ("longer", [&good[..], b"x"].concat(), "something appended"),
        ("features", flipped(20), "checksum"),
        ("row", flipped(good.len() / 2), "content hash"),
        ("last", flipped(good.len() - 1), ""),
    ];
    for (name, bytes, expected) in cases {
        let path = folder.path().join(format!("{name}.mapd"));
        std::fs::write(&path, bytes).expect("written");
        let path = path.display().to_string();
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_mapd_under_test"))
            .args(["inspect", "--verify", &path])
            .output()
            .expect("ends");
        let text = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{name}: {text}");
        assert!(text.contains(&path) && text.contains(expected), "{name}: {text}");
    }
}

#[test]
fn other_files_are_refused_by_name() {
    let mut aligned = AlignedBytes::new();
    aligned.extend_from_slice(&[b'x'; 300]);
    assert!(matches!(open(&aligned).err(), Some(OpenError::NotAnArchive { .. })));
    let good = archive("one_road.xodr");
    let mut shifted = AlignedBytes::new();
    shifted.push(0);
    shifted.extend_from_slice(&good);
    assert!(matches!(open(&shifted[1..]).err(), Some(OpenError::Alignment { .. })));
}
