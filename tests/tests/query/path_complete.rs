//! Nothing along a path is left out and nothing is told that is not there: what another way of asking collects, lane by lane and place by place.

use crate::path_meets::lane_by;
use crate::paths::each_path_of;
use mapd_client::vocabulary::{Class, VehicleClass};
use mapd_client::{LaneId, Map, SignalId};
use mapd_query::path::{
    Path, PathBuffer, PathFact, PathFactKind, PathLane, PathOptions, PathSpeed, steps_of_lanes,
};
use mapd_query::rules::{LineSource, SpeedOrigin, SpeedStretch};
use mapd_query::view::View;
use mapd_tests::crossroads::{ARMS, crossroads, light, signal};
use mapd_tests::graph_maps::{Line, document, lane, road, section};
use mapd_tests::maps::{Random, carried_and, open, open_accepted, open_text};
use std::cell::{Cell, RefCell};
use std::path::PathBuf;
use std::time::SystemTime;

/// Towns with lights, lines and crossings, tunnels, left-hand traffic, types of roads.
pub(crate) const MAPS: [&str; 6] = [
    "carla/Town05",
    "esmini/tunnels",
    "esmini/fabriksgatan_traffic_lights",
    "sumo/lefthand_netconvert",
    "Scenic/Town10HD",
    "drone_dataset/rdb5",
];
/// Pairs of places on each map between which a way is looked for.
pub(crate) const PAIRS: usize = 20;
/// Places on each path.
const PLACES: usize = 40;
/// Lengths and places may differ by this `[m]`.
const ROUNDING: f64 = 1e-6;
/// An object this near to a lane lies on it `[m]`.
const ON_LANE: f64 = 0.5;

fn each_path(check: impl Fn(Map<'_>, &Path<'_, '_>, &str)) {
    let files = carried_and(&MAPS);
    each_path_of(files, PAIRS, &PathOptions::default(), |map, path, _, name, _| {
        check(map, path, name);
    });
}

/// The lanes of a path that are driven at a place of one of its roads' lanes, with S there.
fn driven(path: &Path<'_, '_>, lane: LaneId, s: f64, forward: impl Fn(bool) -> bool) -> Vec<f64> {
    let holds = |own: &PathLane| {
        let [a, b] = own.s;
        own.lane == lane && forward(own.forward) && a.min(b) <= s && s <= a.max(b)
    };
    let share = |own: PathLane| (own.along, own.s);
    // S within a lane is looked up by bisection over places: s grows or falls with it.
    let place = |([from, to], [a, b]): ([f64; 2], [f64; 2])| {
        let (mut low, mut high) = (from, to);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let at = path.at(middle).expect("a place");
            let before = if a < b { at.s < s } else { at.s > s };
            // At the end of the lane the next one answers.
            if before && at.lane == lane { low = middle } else { high = middle }
        }
        if s == b { to } else { low }
    };
    path.lanes().filter(holds).map(share).map(place).collect()
}

/// Compares two lists of what lies at a place.
fn same<K: PartialEq + std::fmt::Debug>(
    mut told: Vec<(f64, K)>,
    mut expected: Vec<(f64, K)>,
    name: &str,
) -> usize {
    let by = |a: &(f64, K), b: &(f64, K)| a.0.total_cmp(&b.0);
    told.sort_by(by);
    expected.sort_by(by);
    assert_eq!(told.len(), expected.len(), "{name}: {told:?}, {expected:?}");
    for (along, kind) in &told {
        let fits = |(other, own): &(f64, K)| (along - other).abs() < 1e-3 && own == kind;
        let at = expected.iter().position(fits);
        expected.remove(at.unwrap_or_else(|| panic!("{name}: {kind:?} at {along}: {expected:?}")));
    }
    told.len()
}

/// Every signal, from the places of signals; whether it governs, from its lamps and the next turn.
fn signals(map: Map<'_>, path: &Path<'_, '_>, facts: &[PathFact], name: &str) -> [usize; 2] {
    let junction = |lane: LaneId| map.lane(lane).expect("a lane").road().junction().is_some();
    let turn_from = |along: f64| {
        let next = path.lanes().find(|own| own.along[1] > along && junction(own.lane));
        next.map(|own| map.lane(own.lane).expect("a lane").turn())
    };
    let mut expected: Vec<(f64, (SignalId, bool))> = Vec::new();
    let mut partly = 0;
    for place in map.signal_places() {
        for one in place.lanes().filter(|one| !one.signal().is_invalidated()) {
            let lane = one.lane().expect("a lane");
            for along in driven(path, lane.lane_id(), one.s_on(&lane), |way| one.is_for(way)) {
                let light = one.signal().light();
                let turn = turn_from(along - ROUNDING);
                let bits = light.map_or(0, |light| light.arrows);
                let governs = bits == 0 || turn.is_none_or(|turn| bits & turn.bit() != 0);
                partly += usize::from(!governs);
                expected.push((along, (one.signal().signal_id(), governs)));
            }
        }
    }
    let told = facts.iter().filter_map(|fact| match fact.kind {
        PathFactKind::Signal { signal, governs } => Some((fact.along[0], (signal, governs))),
        _ => None,
    });
    [same(told.collect(), expected, name), partly]
}

/// Every stop line and crossing, from the places of signals and from the lanes of objects.
fn lines(map: Map<'_>, path: &Path<'_, '_>, facts: &[PathFact], name: &str) -> usize {
    let is_line = |class: Class| {
        matches!(
            class,
            Class::StopLine | Class::WaitingLine | Class::Crosswalk | Class::BicycleCrossing
        )
    };
    let mut expected: Vec<(f64, LineSource)> = Vec::new();
    let mut add = |lane: LaneId, s: f64, source: LineSource, way: &dyn Fn(bool) -> bool| {
        expected.extend(driven(path, lane, s, way).into_iter().map(|along| (along, source)));
    };
    for one in map.signal_places().flat_map(|place| place.lanes()) {
        if is_line(one.signal().class()) {
            let (lane, source) =
                (one.lane().expect("a lane"), LineSource::Signal(one.signal().signal_id()));
            add(lane.lane_id(), one.s_on(&lane), source, &|way| one.is_for(way));
        }
    }
    for object in map.objects().filter(|object| is_line(object.class())) {
        let source = LineSource::Object(object.object_id());
        for one in object.lanes().filter(|one| one.distance() <= ON_LANE) {
            let lane = one.lane().expect("a lane");
            let same_road = object.road().map(|road| road.road_id()) == Some(lane.road().road_id());
            let both = same_road && lane.is_bidirectional();
            let is_for = |way: bool| !both || object.orientation().is_for(way);
            let ends = one.s_range();
            add(lane.lane_id(), ends.low, source, &|way| way && is_for(way));
            add(lane.lane_id(), ends.high, source, &|way| !way && is_for(way));
        }
    }
    let told: Vec<_> = facts
        .iter()
        .filter_map(|fact| match fact.kind {
            PathFactKind::Line { line, ends } => {
                let lane = map.lane(line.lane).expect("a lane");
                let [left, right] = lane.bounds_at(line.s).expect("bounds");
                let ends_are = [[left, right], [right, left]].contains(&ends);
                assert!(ends_are, "{name}: {fact:?}");
                Some((fact.along[0], line.source))
            }
            _ => None,
        })
        .collect();
    // One over both lanes of a change counts once.
    let mut at: Vec<(f64, LineSource)> = Vec::new();
    for own in expected {
        if !at.iter().any(|other| other.1 == own.1 && (other.0 - own.0).abs() < ROUNDING) {
            at.push(own);
        }
    }
    same(told, at, name)
}

/// What holds at a place, by the facts and by the road's and lane's own records; how many holes there are near.
fn at_place(map: Map<'_>, path: &Path<'_, '_>, facts: &[PathFact], along: f64, name: &str) {
    let at = path.at(along).expect("a place");
    let lane = map.lane(at.lane).expect("a lane");
    let (road, s) = (lane.road(), at.s);
    let mut expected = vec![format!("{:?}", PathFactKind::LaneType(lane.kind()))];
    if let Some(junction) = road.junction() {
        let (junction, turn) = (junction.junction_id(), lane.turn());
        expected.push(format!("{:?}", PathFactKind::Junction { junction, turn }));
    }
    if let Some(own) = road.types().take_while(|own| own.s <= s).last() {
        expected.push(format!("{:?}", PathFactKind::RoadType(own.kind)));
        let country = own.country.map(|number| PathFactKind::Country { number });
        expected.extend(country.map(|kind| format!("{kind:?}")));
    }
    let classes = VehicleClass::ALL.iter().filter(|class| {
        let node = lane.node_at(s, at.forward);
        node.is_some_and(|node| node.allows(**class))
    });
    let classes = classes.fold(0, |bits, class| bits | class.bit());
    expected.push(format!("{:?}", PathFactKind::Access { classes }));
    for (number, structure) in (0u32..).zip(map.structures()) {
        let range = structure.s_range();
        let mut valid = structure.validities();
        let holds =
            valid.len() == 0 || valid.any(|lanes| (lanes.from..=lanes.to).contains(&lane.number()));
        let own = structure.road().map(|road| road.road_id()) == Some(road.road_id());
        if own && holds && range.low <= s && s < range.high {
            let kind = structure.kind();
            expected.push(format!("{:?}", PathFactKind::Structure { kind, number }));
        }
    }
    let holds = |fact: &&PathFact| fact.along[0] <= along && along < fact.along[1];
    let lasts = |fact: &&PathFact| {
        !matches!(
            fact.kind,
            PathFactKind::Signal { .. } | PathFactKind::Line { .. } | PathFactKind::Hole { .. }
        )
    };
    let mut told: Vec<String> =
        facts.iter().filter(holds).filter(lasts).map(|fact| format!("{:?}", fact.kind)).collect();
    told.sort();
    expected.sort();
    assert_eq!(told, expected, "{name} at {along}");
}

/// Compares all facts of a path; how many signals, lights for other turns, lines and structures there are.
fn compare(map: Map<'_>, path: &Path<'_, '_>, name: &str, random: &mut Random) -> [usize; 4] {
    let mut facts = Vec::new();
    path.facts(&mut facts);
    let [told, partly] = signals(map, path, &facts, name);
    let lines = lines(map, path, &facts, name);
    let structure = |fact: &&PathFact| matches!(fact.kind, PathFactKind::Structure { .. });
    let structures = facts.iter().filter(structure).count();
    for _ in 0..PLACES {
        at_place(map, path, &facts, random.between(0.0, path.length()), name);
    }
    [told, partly, lines, structures]
}

#[test]
fn all_facts_along_a_path_are_told() {
    let counts = RefCell::new([0usize; 4]);
    let options = PathOptions::default();
    each_path_of(carried_and(&MAPS), PAIRS, &options, |map, path, _, name, random| {
        let own = compare(map, path, name, random);
        counts.borrow_mut().iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
    });
    let [signals, _, lines, _] = counts.into_inner();
    assert!(signals > 0 && lines > 0 || mapd_tests::shared("maps").is_none(), "{signals}, {lines}");
}

/// Arm 0 has a tunnel for its incoming lane, types of roads in a country, and a light whose arrow points to the left.
#[test]
fn a_tunnel_and_an_arrow_light_are_told_of_the_lanes_and_turns_that_they_are_for() {
    let arrow =
        light("L").replace("1000001", "1000011").replace("subtype=\"-1\"", "subtype=\"10\"");
    let mut signals: [String; ARMS] = std::array::from_fn(|_| String::new());
    signals[0] = arrow + &signal("S", 2.0, 1.75, "-", "294", "");
    let tunnel = "<objects><tunnel id=\"t\" type=\"standard\" s=\"30\" length=\"20\"><validity fromLane=\"1\" toLane=\"1\"/></tunnel></objects>";
    let kinds = "<type s=\"0\" type=\"town\" country=\"DE\"/><type s=\"40\" type=\"rural\" country=\"DE\"/>";
    let text = crossroads(signals, "", "")
        .replacen("<signals>", &format!("{tunnel}<signals>"), 1)
        .replacen("<planView>", &format!("{kinds}<planView>"), 1);
    let snapshot = open_text(&text);
    let map = snapshot.map();
    let mut random = Random(17);
    for (arms, expected) in
        [([0, 3], [2, 0, 1, 1]), ([0, 2], [2, 1, 1, 1]), ([0, 1], [2, 1, 1, 1]), ([2, 0], [0; 4])]
    {
        let [from, to] = arms;
        let keys = [format!("{from}:0:1"), format!("{from}{to}:0:-1"), format!("{to}:0:-1")];
        let lanes = keys.map(|key| lane_by(map, &key).lane_id());
        let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
        steps_of_lanes(map, &lanes, [80.0, 80.0], &mut steps).expect("steps");
        let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
        let name = format!("from {from} to {to}");
        assert_eq!(compare(map, &path, &name, &mut random), expected, "{name}");
    }
}

/// What holds along a path, from the lanes alone: a lane's own answer, or in a junction where nothing else is said what holds at the end of the lane before.
#[test]
fn all_speed_limits_along_a_path_are_those_of_its_lanes() {
    let compared = RefCell::new([0usize; 2]);
    each_path(|map, path, name| {
        let zones = map.signals().any(|one| one.class() == Class::SpeedLimitZone);
        let lanes: Vec<PathLane> = path.lanes().collect();
        let mut speeds: Vec<PathSpeed> = Vec::new();
        path.speeds(&mut speeds);
        for (number, own) in lanes.iter().enumerate() {
            let along = 0.5 * (own.along[0] + own.along[1]);
            let at = path.at(along).expect("a place");
            if at.lane != own.lane || own.along[1] - own.along[0] < ROUNDING {
                continue;
            }
            let (mut rule, mut back) =
                (map.lane(own.lane).expect("a lane").speed_rule_at(at.s), number);
            let came_in = |origin| matches!(origin, SpeedOrigin::Entry | SpeedOrigin::Depends);
            let direct = !came_in(rule.origin);
            let mut inside = true;
            while came_in(rule.origin) && back > 0 && inside && !zones {
                let lane = map.lane(lanes[back].lane).expect("a lane");
                inside = lane.road().junction().is_some();
                back -= usize::from(inside);
                if inside {
                    let before = map.lane(lanes[back].lane).expect("a lane");
                    rule = before.speed_rule_at(lanes[back].s[1]);
                }
            }
            if came_in(rule.origin) || (!direct && rule.max.is_none()) {
                continue;
            }
            let told = speeds.iter().find(|own| own.along[0] <= along && along < own.along[1]);
            let told = told.unwrap_or_else(|| panic!("{name}: nothing at {along}"));
            assert_eq!(told.rule.max, rule.max, "{name} at {along}: {told:?}, {rule:?}");
            compared.borrow_mut()[usize::from(direct)] += 1;
        }
    });
    let [came_in, direct] = compared.into_inner();
    // The carried maps alone have fewer routes.
    let has_corpus = mapd_tests::shared("maps").is_some();
    assert!(direct > if has_corpus { 100 } else { 40 }, "{direct}");
    assert!(came_in > 0 || !has_corpus, "{came_in}");
}

/// Every call that tells a speed limit says the same: lanes, edges and views of all places, paths where the lane knows; and no way has less than the lowest that the lane tells.
#[test]
fn all_calls_agree_on_speed_limits() {
    /// Pairs of places on each map between which a way is looked for.
    const FEW: usize = 6;
    let folders = ["found/maps", "found/lanes", "found/views"];
    let folders = folders.iter().filter_map(|name| mapd_tests::shared(name));
    let found =
        folders.flat_map(|folder| std::fs::read_dir(folder).into_iter().flatten().flatten());
    let found = found.map(|file| file.path());
    let corpus = mapd_tests::corpus().unwrap_or_default().into_iter().map(|(_, path)| path);
    let mut files: Vec<PathBuf> =
        found.chain(corpus).filter(|path| path.extension().is_some_and(|e| e == "xodr")).collect();
    files.sort();
    files.extend(carried_and(&[]));
    let (lanes, on_paths, depends) = (Cell::new(0), Cell::new(0), Cell::new(0));
    for file in &files {
        let Some(snapshot) = open_accepted(file) else { continue };
        let name = file.display();
        let map = snapshot.map();
        let view = View::new(map, None, SystemTime::UNIX_EPOCH).expect("its own");
        for lane in map.lanes().filter(|lane| lane.number() != 0) {
            let section = lane.section();
            let mut end = section.s_start();
            let mut last: Option<SpeedStretch> = None;
            for own in lane.speed_rules() {
                let what = format!("{name}: {} {own:?}", lane.key());
                assert!(own.s.low == end && own.s.high > end, "{what}");
                end = own.s.high;
                let middle = 0.5 * (own.s.low + own.s.high);
                assert_eq!(lane.speed_rule_at(middle), own.rule, "{what}");
                let today = view.speed_rule_at(lane.lane_id(), middle, VehicleClass::Truck);
                assert_eq!(today.expect("an answer").map, own.rule, "{what}");
                if own.rule.origin != SpeedOrigin::Depends {
                    assert_eq!(own.lowest, own.rule.max, "{what}");
                }
                let goes_on =
                    |last: SpeedStretch| (last.rule, last.lowest) == (own.rule, own.lowest);
                assert!(!last.is_some_and(goes_on), "{what}");
                last = Some(own);
                lanes.set(lanes.get() + 1);
            }
            assert!(end == section.s_end() || section.s_end() <= section.s_start(), "{name}");
        }
        let check = |map: Map<'_>, path: &Path<'_, '_>, name: &str| {
            let mut speeds: Vec<PathSpeed> = Vec::new();
            path.speeds(&mut speeds);
            for own in speeds.iter().filter(|own| own.along[1] - own.along[0] > ROUNDING) {
                let at = path.at(0.5 * (own.along[0] + own.along[1])).expect("a place");
                let lane = map.lane(at.lane).expect("a lane");
                let mut along = lane.speed_rules();
                let Some(there) = along.find(|there| there.s.low < at.s && at.s < there.s.high)
                else {
                    continue;
                };
                let what = format!("{name}: {own:?} {there:?}");
                assert_eq!(path.speed_at(at.along), Some(own.rule), "{what}");
                if there.rule.origin != SpeedOrigin::Depends {
                    assert_eq!(own.rule.max, there.rule.max, "{what}");
                    on_paths.set(on_paths.get() + 1);
                } else if let Some(max) = own.rule.max {
                    assert!(there.lowest.is_some_and(|lowest| lowest <= max), "{what}");
                    depends.set(depends.get() + 1);
                }
            }
        };
        each_path_of(vec![file.clone()], FEW, &PathOptions::default(), |map, path, _, name, _| {
            check(map, path, name);
        });
    }
    let has_corpus = files.len() > 2;
    let counts = [lanes.get(), on_paths.get(), depends.get()];
    mapd_tests::say(&format!("{counts:?} stretches of lanes, of paths, of those that depend"));
    assert!(lanes.get() > if has_corpus { 10_000 } else { 10 }, "{counts:?}");
    assert!(on_paths.get() > if has_corpus { 300 } else { 1 }, "{counts:?}");
}

/// A part that is left out of the map is told where the path comes near.
#[test]
fn a_hole_beside_a_path_is_told_where_it_is_near() {
    let plain = "junction=\"-1\"";
    let own =
        road("1", plain, Line(0.0, 0.0, 0.0, 200.0, 0.0), "", &section(0.0, "", &lane(-1, "")));
    // Across the path's end at x = 100 m, with a width that is no number.
    let bad =
        road("2", plain, Line(100.0, 5.0, 0.0, 20.0, 0.0), "", &section(0.0, "", &lane(-1, "")))
            .replace("a=\"3.5\"", "a=\"east\"");
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("map.xodr");
    std::fs::write(&file, document(&(own + &bad))).expect("written");
    let snapshot = open(&file);
    let map = snapshot.map();
    let part = map.quarantined().next().expect("a part is left out");
    let (mut steps, mut buffer, mut facts) = (Vec::new(), PathBuffer::default(), Vec::new());
    steps_of_lanes(map, &[lane_by(map, "1:0:-1").lane_id()], [0.0, 200.0], &mut steps)
        .expect("steps");
    let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
    path.facts(&mut facts);
    let holes: Vec<_> =
        facts.iter().filter(|fact| matches!(fact.kind, PathFactKind::Hole { number: 0 })).collect();
    assert_eq!(holes.len(), 1, "{facts:?}");
    for i in 0..=200 {
        let at = path.at(f64::from(i)).expect("a place").position.truncate();
        let near = part.distance(at).expect("its extent") <= 10.0;
        let told = holes[0].along[0] <= f64::from(i) && f64::from(i) <= holes[0].along[1];
        assert!(told || !near, "at {i}");
    }
    assert!(holes[0].along[1] - holes[0].along[0] < 200.0 + ROUNDING, "{holes:?}");
}
