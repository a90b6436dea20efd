//! Signals of every map of the corpus: as many as the manifest says, each placed and either for lanes or named in a finding.

use mapd_archive::{Archive, Header, Rows};
use mapd_compiler::{Compilation, CompileOptions, ReadOptions, Verdict, compile_from};
use mapd_query::Map;
use mapd_query::signals::SignalPlace;
use mapd_query::vocabulary::Class;
use std::collections::{HashMap, HashSet};

/// Counts of one map: signals, references to signals, controllers.
type Counts = [usize; 3];

fn manifest() -> HashMap<String, Counts> {
    let path = mapd_tests::shared("maps").expect("asked before").join("manifest.tsv");
    let text = std::fs::read_to_string(path).expect("the manifest can be read");
    let mut lines = text.lines().map(|line| line.split('\t').collect::<Vec<_>>());
    let head = lines.next().expect("a head");
    let column = |name: &str| head.iter().position(|one| *one == name).expect("a column");
    let (map, wanted) = (column("map"), ["signals", "signalRefs", "controllers"].map(column));
    let number = |line: &[&str], at: usize| line.get(at).and_then(|n| n.parse().ok()).unwrap_or(0);
    lines
        .map(|line| {
            let name = line[map].trim_end_matches(".xodr").to_owned();
            (name, wanted.map(|at| number(&line, at)))
        })
        .collect()
}

fn view(rows: &Rows) -> Archive<'_> {
    Archive { header: Header::default(), tables: rows.as_tables() }
}

fn check(name: &str, compiled: &Compilation, expected: Counts) {
    let rows = compiled.rows.as_ref().expect("accepted maps have rows");
    let archive = view(rows);
    let map = Map::new(&archive, 0);
    let references = map.signal_places().filter(|place| place.is_reference()).count();
    // Signs on boards are rows of their own, which the manifest does not count.
    let own = map.signals().filter(|signal| signal.carrier().is_none()).count();
    let lost = |rule: &str| compiled.diagnostics.iter().filter(|d| d.finding.rule == rule).count();
    let missing = lost("mapd:compile.signal_reference");
    let found = [own, references + missing, map.controllers().len()];
    assert_eq!(found, expected, "{name}: signals, references, controllers");
    for signal in map.signals() {
        let p = signal.position();
        assert!(p.is_finite() && p != mapd_query::glam::DVec3::ZERO, "{name}: {}", signal.id());
    }
    // A signal may name the lanes of other roads alone; one that is for no lane at all is told.
    let with_lanes: HashSet<_> = map
        .signal_places()
        .flat_map(|place| place.lanes())
        .map(|one| one.signal().signal_id())
        .collect();
    let is_known = |place: &SignalPlace<'_>| {
        place.signal().is_some_and(|signal| with_lanes.contains(&signal.signal_id()))
    };
    let without = map.signal_places().filter(|place| place.lanes().count() == 0);
    let without = without.filter(|place| place.is_reference() || !is_known(place)).count();
    let told = lost("mapd:compile.signal_lanes");
    assert_eq!(without, told, "{name}: places without lanes");
    for one in map.signal_places().flat_map(|place| place.lanes()) {
        let lane = one.lane().expect("a lane");
        assert!(lane.signals().any(|own| own.place().s() == one.place().s()), "{name}");
        assert!(one.place().road().map(|road| road.id()) == Some(lane.road().id()), "{name}");
    }
}

#[test]
fn every_signal_of_the_corpus_is_placed() {
    let Some(corpus) = mapd_tests::corpus() else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    let manifest = manifest();
    let mut all = 0;
    for (name, path) in corpus {
        let open = || std::fs::File::open(&path);
        let (reading, options) = (ReadOptions::default(), CompileOptions::default());
        let compiled = compile_from(open, &reading, &options, &mut |_| {}).expect("reading works");
        if compiled.verdict == Verdict::Rejected {
            continue;
        }
        let expected = manifest.get(&name).copied().unwrap_or_default();
        all += expected[0];
        check(&name, &compiled, expected);
    }
    assert!(all > 600, "the corpus has {all} signals");
}

/// Lights of vehicles, and those of them that govern a movement; movements of vehicles, and those under a light. All 72 movements
/// of Town01 have one, whose orientation is against the lane that its validity names; of Issue189, 36 lights stand at the
/// map's edge.
const GOVERNED: [(&str, [usize; 4]); 4] = [
    ("ad_map_access/Town01", [36, 36, 72, 72]),
    ("esmini/multi_intersections", [34, 34, 59, 59]),
    ("Scenic/Issue189", [108, 72, 68, 62]),
    ("maliput_malidrive/CrossingComplex8Course", [10, 10, 20, 20]),
];

#[test]
fn lights_and_movements_of_several_vendors_find_each_other() {
    let Some(maps) = mapd_tests::shared("maps") else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    for (name, expected) in GOVERNED {
        let snapshot = mapd_tests::maps::open(&maps.join(format!("{name}.xodr")));
        let map = snapshot.map();
        let lights: Vec<_> =
            map.signals().filter(|signal| signal.class() == Class::TrafficLight).collect();
        let governing = lights.iter().filter(|light| light.movements().next().is_some());
        let movements: Vec<_> = map
            .lanes()
            .filter(|lane| lane.road().junction().is_some() && lane.kind().is_drivable())
            .filter(|lane| lane.entries().next().is_some())
            .collect();
        let lit = movements.iter().filter(|lane| lane.movement_lights().next().is_some());
        let found = [lights.len(), governing.count(), movements.len(), lit.count()];
        assert_eq!(found, expected, "{name}");
        for lane in &movements {
            for light in lane.movement_lights() {
                let start = lane.movement_start().lane_id();
                let back = light.signal().movements().any(|other| other.lane_id() == start);
                assert!(back, "{name}: {} does not know {}", light.signal().id(), lane.key());
            }
        }
    }
}
