//! The maps of CARLA, esmini and RoadRunner have no errors but those that docs/checks.md justifies.

use mapd_compiler::{ReadOptions, check_from};
use mapd_xodr::Severity;
use std::collections::BTreeMap;

/// Errors: rule, how many. Each takes a part out.
type Errors = &'static [(&'static str, usize)];

/// Maps with errors.
const JUSTIFIED: [(&str, Errors); 1] = [(
    "opendrive-cpp/only-unittest",
    &[
        ("asam.net:xodr:1.4.0:road.geometry.refline_no_gaps", 2),
        ("asam.net:xodr:1.4.0:road.geometry.refline_no_kinks", 2),
    ],
)];

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
        let mut found: BTreeMap<&str, usize> = BTreeMap::new();
        for d in checked.diagnostics.iter().filter(|d| d.finding.severity == Severity::Error) {
            *found.entry(d.finding.rule).or_default() += 1;
        }
        assert_eq!(checked.dropped[2], 0, "{name}: errors beyond those kept");
        let found: Vec<_> = found.into_iter().collect();
        let due = JUSTIFIED.iter().find(|(map, _)| map == name).map_or(&[][..], |(_, due)| *due);
        assert_eq!(found, due, "{name}");
    }
    assert_eq!(maps, MAPS, "the corpus has other maps of these programs");
}
