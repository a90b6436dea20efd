//! Archives of releases of other ages: what this one does not know is left alone, what it would misread is refused by name.

use mapd_archive::{
    AlignedBytes, FEATURES, Feature, FeatureRow, OpenError, Unknown, encode, open, unknown, verify,
    verify_overlay,
};
use mapd_client::Snapshot;
use mapd_compiler::{Compilation, CompileOptions, compile};
use mapd_tests::damage::{ask_everything, seal};
use mapd_tests::releases::{
    MOMENT, Parts, UNKNOWN_TABLE, answers, answers_today, golden, kept, texts,
};
use mapd_tests::{carried, crossroads};
use std::collections::BTreeSet;
use std::path::Path;
use std::time::UNIX_EPOCH;

fn read(path: &Path) -> AlignedBytes {
    let mut bytes = AlignedBytes::new();
    bytes.extend_from_slice(&std::fs::read(path).expect("readable"));
    bytes
}

fn compiled(text: &str) -> Compilation {
    compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {}).expect("reading works")
}

fn crossing() -> AlignedBytes {
    let map = compiled(&crossroads::furnished());
    encode(&map.rows.expect("accepted"), &map.provenance).expect("encodes")
}

fn answers_of(bytes: AlignedBytes) -> String {
    answers(Snapshot::from_bytes(bytes).expect("opens").map()).expect("text")
}

#[test]
fn format_1_is_refused_by_name() {
    let error = open(&read(&golden().join("format-1.mapd"))).err().expect("refused");
    assert_eq!(error, OpenError::Format { expected: 2, found: 1 });
    assert!(error.to_string().contains("format 1"), "{error}");
}

/// What a release has written, every later one reads, and answers the same.
#[test]
fn archives_of_released_layouts_are_read_and_answer_as_ever() {
    let kept = kept();
    assert!(!kept.is_empty(), "no archive of a released layout");
    for path in kept {
        let bytes = read(&path);
        verify(&bytes).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let snapshot = Snapshot::from_bytes(bytes.clone()).expect("opens");
        for (extension, found) in texts(snapshot.map()).expect("text") {
            let path = path.with_extension(extension);
            let expected = std::fs::read_to_string(&path).expect("readable");
            let differs = found.lines().zip(expected.lines()).find(|(found, due)| found != due);
            assert_eq!(differs, None, "{}", path.display());
            assert_eq!(found.lines().count(), expected.lines().count(), "{}", path.display());
        }
        ask_everything(bytes);
    }
}

/// A table that no kept archive fills could change its meaning unseen.
#[test]
fn kept_archives_fill_every_table() {
    let mut empty: BTreeSet<_> = names(&crossing(), |_| true);
    for path in kept() {
        let filled = names(&read(&path), |count| count > 0);
        empty.retain(|name| !filled.contains(name));
    }
    // A row for each feature that this release has added to the format.
    let due = if FEATURES.is_empty() { BTreeSet::from(["features"]) } else { BTreeSet::new() };
    assert_eq!(empty, due);
}

/// Names of the tables of an archive that have so many rows.
fn names(bytes: &AlignedBytes, rows: impl Fn(usize) -> bool) -> BTreeSet<&'static str> {
    let infos = open(bytes).expect("opens").tables.infos();
    infos.iter().filter(|info| rows(info.count)).map(|info| info.name).collect()
}

/// The same of overlays: `NAME.overlay` is over `NAME.mapd`.
#[test]
fn overlays_of_released_layouts_are_read_and_answer_as_ever() {
    let mut asked = 0;
    for entry in std::fs::read_dir(golden()).expect("a folder").flatten() {
        let path = entry.path();
        if path.extension().is_none_or(|extension| extension != "overlay") {
            continue;
        }
        let bytes = read(&path);
        verify_overlay(&bytes).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let map = Snapshot::open(path.with_extension("mapd")).expect("its map");
        let snapshot = map.with_overlay(bytes).expect("opens");
        let expected = std::fs::read_to_string(path.with_extension("overlay.txt"));
        let found = answers_today(snapshot.view(UNIX_EPOCH + MOMENT)).expect("text");
        assert_eq!(found, expected.expect("readable"), "{}", path.display());
        asked += 1;
    }
    assert!(asked > 0, "no overlay of a released layout");
}

#[test]
fn a_table_of_a_later_release_is_left_alone() {
    let good = crossing();
    let rows: Vec<u8> = (0..5 * 12).collect();
    let bytes = Parts::of(&good).with(UNKNOWN_TABLE, 12, &rows).to_archive();
    verify(&bytes).expect("proves");
    assert_eq!(
        unknown(&bytes).expect("opens"),
        [Unknown::Table { number: UNKNOWN_TABLE, row_bytes: 12, count: 5 }]
    );
    assert_eq!(unknown(&good).expect("opens"), []);
    let file = tempfile::NamedTempFile::with_suffix(".mapd").expect("a file");
    std::fs::write(file.path(), &bytes).expect("written");
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_mapd_under_test"))
        .args(["inspect", "--verify", file.path().to_str().expect("text")])
        .output()
        .expect("ends");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{text}");
    assert!(text.contains("warning       table 60000 with 5 rows of 12 bytes"), "{text}");
    assert_eq!(answers_of(bytes.clone()), answers_of(good));
    // Its bytes are proved all the same.
    let mut bad = bytes;
    let last = bad.len() - 1;
    bad[last] ^= 1;
    assert!(verify(&bad).is_err(), "a flip in the unknown table is not found");
}

/// Without any one optional table an archive is read; whatever is missing, nothing panics.
#[test]
fn optional_tables_may_be_missing() {
    let mut left_out = BTreeSet::new();
    let mut required = BTreeSet::new();
    for path in kept() {
        let good = read(&path);
        for number in Parts::of(&good).numbers() {
            let bytes = Parts::of(&good).without(number).to_archive();
            let archive = match open(&bytes) {
                Err(OpenError::NoTable { table }) => {
                    required.insert(table);
                    continue;
                }
                other => other.unwrap_or_else(|error| panic!("without {number}: {error}")),
            };
            let was = open(&good).expect("opens").tables.infos();
            let is = archive.tables.infos();
            let missing = was.iter().zip(is).filter(|(was, is)| was.count != is.count);
            let missing: Vec<_> = missing.map(|(was, _)| was.name).collect();
            assert_eq!(missing.len(), 1, "without {number}");
            left_out.extend(missing);
            ask_everything(bytes);
        }
    }
    let mut all = names(&crossing(), |_| true);
    if FEATURES.is_empty() {
        all.remove("features");
    }
    let tried: BTreeSet<_> = left_out.union(&required).copied().collect();
    assert_eq!(tried, all);
}

#[test]
fn what_would_be_misread_is_refused_by_name() {
    type Edit = fn(Parts) -> Parts;
    let cases: [(&str, Edit, &str); 10] = [
        ("required table", |p| p.without(5), "no table `roads`"),
        ("other rows", |p| p.edit(5, |t| t.row_id ^= 1), "table `roads` has rows of kind"),
        ("longer rows", |p| p.edit(5, |t| t.row_bytes += 8), "table `roads`"),
        ("optional table", |p| p.edit(46, |t| t.row_id ^= 1), "table `signals` has rows of kind"),
        ("endless", |p| p.edit(5, |t| t.count = u64::MAX), "table `roads`"),
        ("too long", |p| p.edit(5, |t| t.count += 1), "does not lie inside"),
        (
            "no bytes",
            |p| p.with(UNKNOWN_TABLE, 1, &[]).edit(UNKNOWN_TABLE, |t| t.row_bytes = 0),
            "table `60000`",
        ),
        (
            "unknown and endless",
            |p| p.with(UNKNOWN_TABLE, 4, &[0; 8]).edit(UNKNOWN_TABLE, |t| t.count = 3),
            "table `60000`",
        ),
        (
            "twice",
            |p| p.with(UNKNOWN_TABLE, 4, &[0; 8]).with(UNKNOWN_TABLE, 4, &[0; 8]),
            "table `60000`",
        ),
        ("out of order", |p| p.edit(4, |t| t.number = 3).edit(5, |t| t.number = 1), "does not lie"),
    ];
    let good = crossing();
    for (name, edit, expected) in cases {
        let bytes = edit(Parts::of(&good)).to_archive();
        let error = open(&bytes).err().unwrap_or_else(|| panic!("{name}: opened")).to_string();
        assert!(error.contains(expected), "{name}: {error}");
        ask_everything(bytes);
    }
}

/// Offsets that a faulty writer could choose: into another table, off by a byte, into the directory, beyond all.
#[test]
fn tables_lie_apart_and_aligned() {
    let good = crossing();
    let tables = open(&good).expect("opens").header.tables as usize;
    let place = |entry: usize| 128 + entry * 32 + 16;
    for entry in 0..tables {
        let offset = u64::from_le_bytes(*good[place(entry)..].first_chunk().expect("bytes"));
        for wrong in [0, 128, offset - 8, offset + 1, offset + 4, u64::MAX - 7, good.len() as u64] {
            let mut bad = good.clone();
            bad[place(entry)..place(entry) + 8].copy_from_slice(&wrong.to_le_bytes());
            seal(&mut bad);
            let sound = open(&bad).is_ok();
            let is_empty = bad[place(entry) + 8..place(entry) + 16] == [0; 8];
            // Where nothing lies, it may lie anywhere in the order.
            assert!(!sound || is_empty || wrong == offset, "entry {entry} at {wrong}");
            ask_everything(bad);
        }
    }
}

#[test]
fn a_feature_of_a_later_release_is_named() {
    let map = compiled(&crossroads::furnished());
    let mut rows = map.rows.expect("accepted");
    let feature = Feature { bit: 40, name: "roads that float", release: [3, 1, 4] };
    rows.features.push(FeatureRow::of(&feature));
    let bytes = encode(&rows, &map.provenance).expect("encodes");
    let error = open(&bytes).err().expect("refused");
    let due = OpenError::NotUnderstood { bit: 40, name: feature.name.into(), release: [3, 1, 4] };
    assert_eq!(error, due);
    assert!(error.to_string().contains("`roads that float`"), "{error}");
    assert!(error.to_string().contains("mapd 3.1.4"), "{error}");
    // A bit that no row names is refused by its number.
    let mut bare = crossing();
    bare[16 + 5] |= 1;
    seal(&mut bare);
    let error = open(&bare).err().expect("refused").to_string();
    assert!(error.contains("feature 40"), "{error}");
}

/// A kind of object that a later release knows is a warning; a kind of geometry that nobody has announced is an error.
#[test]
fn codes_of_a_later_release_are_warnings_unless_others_depend_on_them() {
    let map = compiled(&std::fs::read_to_string(carried("objects.xodr")).expect("readable"));
    let mut rows = map.rows.expect("accepted");
    for row in rows.objects.iter_mut().take(2) {
        row.orientation = 77;
    }
    let bytes = encode(&rows, &map.provenance).expect("encodes");
    verify(&bytes).expect("no error");
    let found = unknown(&bytes).expect("opens");
    let due = Unknown::Code { table: "objects", field: "orientation", code: 77, row: 0, rows: 2 };
    assert_eq!(found, [due]);
    assert!(found[0].to_string().contains("orientation has code 77"), "{}", found[0]);
    ask_everything(bytes);
    if let Some(row) = rows.geometries.first_mut() {
        row.kind = 77;
    }
    let bytes = encode(&rows, &map.provenance).expect("encodes");
    let error = verify(&bytes).err().expect("refused").to_string();
    assert!(error.contains("geometries") && error.contains("77"), "{error}");
}
