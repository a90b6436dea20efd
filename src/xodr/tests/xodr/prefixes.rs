//! Documents that end too early: wherever one is cut, reading ends with an error that says so, and what came before the cut is
//! what the whole document has there.

use flate2::{Compression, write::GzEncoder};
use mapd_xodr::{Finding, Item, Limits, Reader, Severity, rule_ids};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Bytes between two cuts. Odd, so that cuts fall anywhere in words that repeat.
const STEP: usize = 61;

/// Maps outside the project, of several tools and versions; together small enough to be read at each cut.
const CORPUS: [&str; 10] = [
    "bark/road_corridor_test.xodr",
    "esmini/straight_500m_signs.xodr",
    "esmini/tunnels.xodr",
    "esmini/velodrome.xodr",
    "ivsg/workzone_100m_Lane_Offset.xodr",
    "maliput_malidrive/SingleRoadNanValues.xodr",
    "maliput_malidrive/StraightRoadMultipleLaneDirections.xodr",
    "opendrive-cpp/only-unittest.xodr",
    "qc-opendrive/namespace.xodr",
    "qc-opendrive/rule_341_road_signal_boards_multi_board_have_sub_boards_valid.xodr",
];

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(bytes: &[u8]) -> (Vec<Item>, Vec<Finding>) {
    let mut reader = Reader::new(bytes, Limits::default());
    let mut items = Vec::new();
    while let Some(item) = reader.next().expect("memory does not fail") {
        items.push(item);
    }
    (items, reader.take_findings())
}

/// Reads the beginnings of a document that end at the cuts. Each must give some of the whole's elements, and an error of one of
/// the rules.
fn check(name: &str, bytes: &[u8], step: usize, rules: &[&str]) {
    let start = Instant::now();
    let (whole, _) = read(bytes);
    let end = bytes.trim_ascii_end().len();
    for cut in (0..end).step_by(step) {
        let (items, findings) = read(&bytes[..cut]);
        assert!(items.len() <= whole.len(), "{name}, {cut} bytes: more elements than in the whole");
        assert!(
            items == whole[..items.len()],
            "{name}, {cut} bytes: other elements than the whole's"
        );
        let is_error = |f: &Finding| f.severity == Severity::Error && rules.contains(&f.rule);
        assert!(findings.iter().any(is_error), "{name}, {cut} bytes: {findings:?}");
    }
    let _ = writeln!(
        std::io::stderr(),
        "{name}: {} cuts in {:.1} s",
        end.div_ceil(step),
        start.elapsed().as_secs_f64()
    );
}

const XML: &[&str] = &[rule_ids::XML, rule_ids::ROOT];

#[test]
fn carried_maps_cut_anywhere() {
    let one_road =
        std::fs::read(workspace().join("examples/maps/one_road.xodr")).expect("it is carried");
    check("one_road", &one_road, 1, XML);
    let town = std::fs::read(workspace().join("examples/maps/town.xodr")).expect("it is carried");
    check("town", &town, STEP, XML);
}

#[test]
fn other_forms_cut_anywhere() {
    let text = std::fs::read_to_string(workspace().join("examples/maps/one_road.xodr"))
        .expect("it is carried");
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(text.as_bytes()).expect("memory does not fail");
    let gzip = encoder.finish().expect("memory does not fail");
    // The first bytes alone are no gzip, but no text either.
    check(
        "gzip",
        &gzip,
        1,
        &[rule_ids::COMPRESSION, rule_ids::XML, rule_ids::ROOT, rule_ids::ENCODING],
    );
    let utf_16: Vec<u8> = "\u{feff}"
        .encode_utf16()
        .chain(text.trim_end().encode_utf16())
        .flat_map(u16::to_le_bytes)
        .collect();
    // Between the two bytes of a character, the encoding is at fault.
    check("UTF-16", &utf_16, 1, &[rule_ids::XML, rule_ids::ROOT, rule_ids::ENCODING]);
}

#[test]
fn corpus_cut_anywhere() {
    let maps = workspace().join("../shared/maps");
    if !maps.is_dir() {
        let _ = writeln!(std::io::stderr(), "skipped: there is no ../shared/maps");
        return;
    }
    for name in CORPUS {
        let bytes = std::fs::read(maps.join(name)).expect("a map of the corpus");
        check(name, &bytes, STEP, XML);
    }
}
