//! Every map of the shared corpus ends in an accepted map or in a clear error with its place.

use mapd_archive::{encode, verify};
use mapd_compiler::{CompileOptions, Verdict, compile};

/// Maps that are broken on purpose, and where the first error must be found: line, column.
const REJECTED: [(&str, (u32, u32)); 5] = [
    ("gdal/empty", (5, 4)),
    ("maliput_malidrive/SingleRoadNanValues", (71, 53)),
    ("qc-opendrive/negative18", (7, 3)),
    ("qc-opendrive/root_tag_is_opendrive_negative", (3, 1)),
    ("qc-opendrive/xml.valid_xml_document.negative", (226, 22)),
];

#[test]
fn every_map_is_accepted_or_refused_with_its_place() {
    let Some(corpus) = mapd_tests::corpus() else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    assert_eq!(corpus.len(), 60, "the corpus has another size");
    for (name, path) in &corpus {
        let file = std::fs::File::open(path).expect("the map can be read");
        let compiled =
            compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
        let error = compiled.diagnostics.iter().find(|d| d.rejects);
        match REJECTED.iter().find(|(rejected, _)| rejected == name) {
            Some((_, place)) => {
                let error = error.unwrap_or_else(|| panic!("{name} should be rejected"));
                assert_eq!((error.line, error.column), *place, "{name}: {error:?}");
                assert_eq!(compiled.verdict, Verdict::Rejected);
                assert!(compiled.rows.is_none());
            }
            None => {
                assert!(error.is_none(), "{name}: {error:?}");
                let rows = compiled.rows.as_ref().unwrap_or_else(|| panic!("{name} has no rows"));
                let bytes = encode(rows, &compiled.provenance).expect("encodes");
                verify(&bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
            }
        }
    }
}
