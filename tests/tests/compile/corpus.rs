//! Every map of the shared corpus ends in an accepted map or in a clear error with its place.

use mapd_archive::{encode, verify};
use mapd_compiler::{CompileOptions, ReadOptions, Verdict, compile_from};

/// Maps that are broken on purpose, and where the first error must be found: line, column.
const REJECTED: [(&str, (u32, u32)); 5] = [
    ("gdal/empty", (5, 4)),
    ("maliput_malidrive/SingleRoadNanValues", (71, 53)),
    ("qc-opendrive/negative18", (7, 3)),
    ("qc-opendrive/root_tag_is_opendrive_negative", (3, 1)),
    ("qc-opendrive/xml.valid_xml_document.negative", (226, 22)),
];

/// Maps that lose parts: roads, other parts.
const QUARANTINED: [(&str, (usize, usize)); 4] = [
    ("SMARTS/od_newmarket_map", (23, 0)),
    ("Scenic/borregasave", (1, 0)),
    ("ivsg/scenario1_3_WithObjects_WithSigns", (0, 2)),
    ("opendrive-cpp/only-unittest", (1, 0)),
];

#[test]
fn every_map_is_accepted_or_refused_with_its_place() {
    let Some(corpus) = mapd_tests::corpus() else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    assert_eq!(corpus.len(), 60, "the corpus has another size");
    for (name, path) in &corpus {
        let (reading, options) = (ReadOptions::default(), CompileOptions::default());
        let open = || std::fs::File::open(path);
        let compiled = compile_from(open, &reading, &options, &mut |_| {}).expect("reading works");
        let error = compiled.diagnostics.iter().find(|d| d.rejects);
        match REJECTED.iter().find(|(rejected, _)| rejected == name) {
            Some((_, place)) => {
                let error = error.unwrap_or_else(|| panic!("{name} should be rejected"));
                assert_eq!((error.line, error.column), *place, "{name}: {error:?}");
                assert_eq!(compiled.verdict, Verdict::Rejected);
                assert!(compiled.rows.is_none());
            }
            None => {
                let lost = QUARANTINED.iter().find(|(map, _)| map == name);
                let parts: Vec<&str> =
                    compiled.quarantined.iter().map(|part| part.kind.name()).collect();
                let roads = parts.iter().filter(|kind| **kind == "road").count();
                let found = (roads, parts.len() - roads);
                assert_eq!(found, lost.map_or((0, 0), |(_, lost)| *lost), "{name}: {error:?}");
                let verdict = if lost.is_some() { Verdict::Quarantined } else { Verdict::Accepted };
                assert_eq!(compiled.verdict, verdict, "{name}");
                let rows = compiled.rows.as_ref().unwrap_or_else(|| panic!("{name} has no rows"));
                let bytes = encode(rows, &compiled.provenance).expect("encodes");
                verify(&bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
            }
        }
    }
}
