//! The maps of CARLA, esmini and RoadRunner have no errors but those that docs/checks.md justifies.

use mapd_compiler::{ReadOptions, check_from};
use mapd_xodr::Severity;
use std::collections::BTreeMap;

/// Errors: rule, how many, whether they take out a part.
type Errors = &'static [(&'static str, usize, bool)];

/// Maps with errors.
const JUSTIFIED: [(&str, Errors); 3] = [
    ("ad_map_access/TownEmpty", &[("mapd:structure.missing_element", 1, false)]),
    (
        "drone_dataset/rdb2",
        &[("mapd:structure.missing_attribute", 73, false), ("mapd:value.enumeration", 4, false)],
    ),
    (
        "opendrive-cpp/only-unittest",
        &[
            ("asam.net:xodr:1.4.0:road.geometry.refline_no_gaps", 2, true),
            ("asam.net:xodr:1.4.0:road.geometry.refline_no_kinks", 2, true),
            ("mapd:structure.choice", 10, false),
        ],
    ),
];

/// Maps of these programs in the corpus.
const MAPS: usize = 24;

#[test]
fn clean_maps_have_no_errors_that_are_not_justified() {
    let Some(corpus) = mapd_tests::corpus() else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    let mut maps = 0;
    for (name, path) in &corpus {
        let text = std::fs::read(path).expect("the map is there");
        let text = String::from_utf8_lossy(&text);
        let is_of = name.starts_with("carla/") || name.starts_with("esmini/");
        if !is_of && !text.contains("program=\"RoadRunner\"") {
            continue;
        }
        maps += 1;
        let open = || Ok(text.as_bytes());
        let checked = check_from(open, &ReadOptions::default(), &mut |_| {}).expect("reads");
        let mut found: BTreeMap<&str, (usize, bool)> = BTreeMap::new();
        for d in checked.diagnostics.iter().filter(|d| d.finding.severity == Severity::Error) {
            let entry = found.entry(d.finding.rule).or_default();
            *entry = (entry.0 + 1, entry.1 || d.rejects);
        }
        assert_eq!(checked.dropped[2], 0, "{name}: errors beyond those kept");
        let found: Vec<_> =
            found.into_iter().map(|(rule, (n, rejects))| (rule, n, rejects)).collect();
        let due = JUSTIFIED.iter().find(|(map, _)| map == name).map_or(&[][..], |(_, due)| *due);
        assert_eq!(found, due, "{name}");
    }
    assert_eq!(maps, MAPS, "the corpus has other maps of these programs");
}
