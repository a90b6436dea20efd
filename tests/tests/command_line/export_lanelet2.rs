//! `mapd export --format lanelet2`: a file that is whole, lies where the map lies, and links what the map links.

use mapd_client::SRange;
use mapd_client::geodesy::{Geodetic, Projector};
use mapd_client::glam::DVec3;
use mapd_client::graph::LaneNode;
use mapd_client::vocabulary::LaneType;
use mapd_client::{Lane, Map, Snapshot, Track};
use mapd_tests::carried;
use mapd_tests::maps::{carried_and, open};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");
/// Maps of many kinds: short sections and roads, gaps, narrow turns, left-hand traffic, lights, signs, crosswalks.
const MAPS: [&str; 10] = [
    "carla/Town01",
    "carla/Town05",
    "drone_dataset/rdb5",
    "esmini/fabriksgatan_traffic_lights",
    "esmini/highway_example_with_merge_and_split",
    "esmini/parking_demo",
    "gdal/5g_living_lab_A39_Wolfsburg-West",
    "qc-opendrive/positive18",
    "sumo/lefthand_netconvert",
    "maliput_malidrive/onramp",
];
/// Has borders that cross themselves in narrow turns, which are cut.
const NARROW_TURNS: &str = "Scenic/Issue295a";
/// A point lies at most this far from its lane's edge `[m]`: half of what ends are put together over.
const NEAR: f64 = 0.05 + 1e-3;
/// A latitude and longitude is the place that the map's coordinates beside it say, to this `[m]`.
const SAME: f64 = 1e-3;

type Tags = BTreeMap<String, String>;

#[derive(Default)]
struct Element {
    tags: Tags,
    /// Role (empty for points of a way) and id.
    members: Vec<(String, u64)>,
    place: Option<[f64; 2]>,
}

#[derive(Default)]
struct Osm {
    nodes: HashMap<u64, Element>,
    ways: HashMap<u64, Element>,
    relations: BTreeMap<u64, Element>,
}

fn attributes(start: &BytesStart<'_>) -> Tags {
    let pair = |attribute: quick_xml::events::attributes::Attribute<'_>| {
        let name = attribute.key.as_ref().to_owned();
        let value = quick_xml::escape::unescape(&attribute.value).expect("text").into_owned();
        (name, value)
    };
    start.attributes().map(|attribute| pair(attribute.expect("an attribute"))).collect()
}

fn read(path: &Path) -> Osm {
    let text = fs::read_to_string(path).expect("written");
    let (mut reader, mut osm) = (Reader::from_str(&text), Osm::default());
    let mut open: Option<(String, u64, Element)> = None;
    let mut ids = BTreeSet::new();
    loop {
        let (start, is_empty) = match reader.read_event().expect("XML") {
            Event::Eof => return osm,
            Event::Start(start) => (start.into_owned(), false),
            Event::Empty(start) => (start.into_owned(), true),
            Event::End(end) => {
                let name = end.name().as_ref().to_owned();
                if let Some((_, id, element)) = open.take_if(|(own, ..)| *own == name) {
                    match name.as_str() {
                        "node" => drop(osm.nodes.insert(id, element)),
                        "way" => drop(osm.ways.insert(id, element)),
                        _ => drop(osm.relations.insert(id, element)),
                    }
                }
                continue;
            }
            _ => continue,
        };
        let name = start.name().as_ref().to_owned();
        let values = attributes(&start);
        let number = |name: &str| values[name].parse::<f64>().expect("a number");
        match (name.as_str(), &mut open) {
            ("node" | "way" | "relation", _) => {
                assert!(!is_empty, "{values:?}");
                let id = values["id"].parse().expect("an id");
                assert!(ids.insert(id), "{id} twice");
                let place = (name == "node").then(|| [number("lat"), number("lon")]);
                open = Some((name, id, Element { place, ..Element::default() }));
            }
            ("tag", Some((_, _, element))) => {
                let before = element.tags.insert(values["k"].clone(), values["v"].clone());
                assert_eq!(before, None, "{values:?} twice");
            }
            ("nd", Some((_, _, element))) => {
                element.members.push((String::new(), values["ref"].parse().expect("an id")));
            }
            ("member", Some((_, _, element))) => {
                let id = values["ref"].parse().expect("an id");
                element.members.push((values["role"].clone(), id));
            }
            ("osm" | "MetaInfo", _) => {}
            _ => panic!("{name} {values:?}"),
        }
    }
}

/// Checks that what is around an area, or each hole in it, is closed and has at least three corners; what is around it runs clockwise.
fn check_rings(osm: &Osm, area: &Element, role: &str, name: &str) {
    let ways = area.members.iter().filter(|(own, _)| own == role);
    let ways: Vec<Vec<u64>> = ways
        .map(|(_, way)| osm.ways[way].members.iter().map(|(_, point)| *point).collect())
        .collect();
    assert!(role != "outer" || !ways.is_empty(), "{name} has nothing around it");
    let rings = if role == "outer" { vec![joined(&ways, name)] } else { ways };
    for ring in rings {
        assert!(ring.len() > 3 && ring.first() == ring.last(), "{name}: {ring:?}");
        let places = ring.iter().map(|point| osm.place(*point).truncate());
        let places: Vec<_> = places.collect();
        let twice: f64 =
            places.windows(2).map(|pair| (pair[0] - places[0]).perp_dot(pair[1] - places[0])).sum();
        assert!(role != "outer" || twice < 0.0, "{name} runs counter-clockwise, or has no area");
    }
}

/// Ways that follow each other, each in the direction in which it goes on from the one before.
fn joined(ways: &[Vec<u64>], name: &str) -> Vec<u64> {
    let mut ring = ways[0].clone();
    if let Some(next) = ways.get(1)
        && ![next.first(), next.last()].contains(&ring.last())
    {
        ring.reverse();
    }
    for way in &ways[1..] {
        let end = ring.last().copied();
        let mut way = way.clone();
        if way.first().copied() != end {
            way.reverse();
        }
        assert_eq!(way.first().copied(), end, "{name}: {ways:?}");
        ring.extend(&way[1..]);
    }
    ring
}

impl Osm {
    fn place(&self, node: u64) -> DVec3 {
        let tags = &self.nodes[&node].tags;
        let [x, y, z] =
            ["local_x", "local_y", "ele"].map(|name| tags[name].parse().expect("a number"));
        DVec3::new(x, y, z)
    }

    /// Points of a lanelet's border as they stand in its way.
    fn border(&self, lanelet: &Element, role: &str) -> Vec<u64> {
        let mut ways = lanelet.members.iter().filter(|(own, _)| own == role);
        let (Some((_, way)), None) = (ways.next(), ways.next()) else { panic!("{role}") };
        self.ways[way].members.iter().map(|(_, node)| *node).collect()
    }
}

fn run(arguments: &[&str], folder: &Path) -> Output {
    let mut command = Command::new(MAPD);
    command.args(["export", "--format", "lanelet2"]).args(arguments);
    command.current_dir(folder).output().expect("runs")
}

/// Exports a map; one without a georeference lies at 49° N, 8.4° E.
fn export(map: Map<'_>, path: &Path) -> (Osm, Vec<csv::StringRecord>, Projector) {
    let folder = tempfile::tempdir().expect("a folder");
    let mut arguments =
        vec![path.to_str().expect("a path"), "-o", "out.osm", "--report", "out.csv"];
    let projector = map.projector().unwrap_or_else(|_| {
        arguments.extend(["--origin", "49,8.4"]);
        let plane = "+proj=tmerc +lat_0=49 +lon_0=8.4 +datum=WGS84";
        Projector::new(plane, mapd_client::geodesy::Offset::default()).expect("a projector")
    });
    let output = run(&arguments, folder.path());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let mut report = csv::Reader::from_path(folder.path().join("out.csv")).expect("a report");
    let report = report.records().map(|record| record.expect("a record")).collect();
    (read(&folder.path().join("out.osm")), report, projector)
}

/// One lanelet with its points in the direction of travel towards +s.
struct Lanelet<'a> {
    lane: Lane<'a>,
    s: [f64; 2],
    /// Left and right of the reference line's direction.
    borders: [Vec<u64>; 2],
}

fn lanelets<'a>(map: Map<'a>, osm: &Osm) -> Vec<Lanelet<'a>> {
    let of_lanes = |element: &&Element| {
        says(element, "type", "lanelet") && element.tags.contains_key("lane_key")
    };
    let all = osm.relations.values().filter(of_lanes).map(|element| {
        let s = ["s_from", "s_to"].map(|name| element.tags[name].parse::<f64>().expect("a number"));
        let key = element.tags["lane_key"].parse().expect("a key");
        let lane = map.lane_by_key(&key).expect("a lane");
        // A key may stand for several sections in a row.
        let road = lane.road();
        let sections = road
            .sections()
            .filter(|one| one.s_start() <= s[0] + 1e-5 && s[1] <= one.s_end() + 1e-5);
        let lane = sections.last().and_then(|one| one.lane(lane.number())).expect("a lane");
        let (left, right) = if lane.is_forward() { ("left", "right") } else { ("right", "left") };
        Lanelet { lane, s, borders: [left, right].map(|role| osm.border(element, role)) }
    });
    all.collect()
}

/// Points on the left and right of travel where a lanelet is entered or left.
fn ends(lanelet: &Lanelet<'_>, forward: bool, at_end: bool) -> [u64; 2] {
    let [left, right] = &lanelet.borders;
    let end = |border: &Vec<u64>| {
        let end = if forward == at_end { border.last() } else { border.first() };
        *end.expect("points")
    };
    if forward { [end(left), end(right)] } else { [end(right), end(left)] }
}

/// The keys that the borders of each lanelet of a lane are called by, behind the lane's own.
fn named_borders(osm: &Osm) -> Vec<(String, BTreeSet<String>)> {
    let lanelets = osm.relations.values().filter(|one| says(one, "type", "lanelet"));
    let named = lanelets.filter_map(|one| {
        let borders = one.members.iter().filter(|(role, _)| role == "left" || role == "right");
        let keys = borders.map(|(_, way)| osm.ways[way].tags["lane_key"].clone());
        Some((one.tags.get("lane_key")?.clone(), keys.collect()))
    });
    named.collect()
}

#[test]
fn every_reference_has_its_element_and_every_element_its_tags() {
    let mut shared = 0;
    // No carried map has an area: one with its left shoulder as a place to park.
    let folder = tempfile::tempdir().expect("a folder");
    let parking = folder.path().join("parking.xodr");
    let text = fs::read_to_string(carried("one_road.xodr")).expect("a map");
    fs::write(&parking, text.replace(r#"id="2" type="shoulder""#, r#"id="2" type="parking""#))
        .expect("written");
    for path in carried_and(&MAPS).into_iter().chain([parking]) {
        let snapshot = open(&path);
        let (osm, ..) = export(snapshot.map(), &path);
        let name = path.display();
        for way in osm.ways.values() {
            assert!(way.members.len() > 1, "{name}");
            assert!(way.members.iter().all(|(_, node)| osm.nodes.contains_key(node)), "{name}");
            assert!(way.tags.contains_key("type"), "{name} {:?}", way.tags);
        }
        for (lanelet, own) in named_borders(&osm) {
            // Its outer border is called as it is itself, its inner one as the lane beside it towards lane 0.
            let lane = snapshot.map().lane_by_key(&lanelet.parse().expect("a key"));
            let lane = lane.expect("a lane");
            let inner = lane.inner().expect("a lane").key().to_string();
            let expected = BTreeSet::from([lanelet.clone(), inner]);
            assert_eq!(own, expected, "{name}: borders of {lanelet}");
        }
        for (id, relation) in &osm.relations {
            let is_there = |id: &u64| osm.ways.contains_key(id) || osm.relations.contains_key(id);
            assert!(relation.members.iter().all(|(_, id)| is_there(id)), "{name}: {id}");
            match relation.tags["type"].as_str() {
                "lanelet" => {
                    for tag in ["subtype", "location", "one_way"] {
                        assert!(relation.tags.contains_key(tag), "{name}: {id} has no {tag}");
                    }
                    let mut tags = relation.tags.keys();
                    assert!(tags.any(|tag| tag.starts_with("participant:")), "{name}: {id}");
                }
                "regulatory_element" => {
                    let refers = |other: &Element| {
                        other
                            .members
                            .iter()
                            .any(|(role, own)| role == "regulatory_element" && own == id)
                    };
                    assert!(osm.relations.values().any(refers), "{name}: nobody heeds {id}");
                }
                "multipolygon" => {
                    assert!(relation.tags.contains_key("subtype"), "{name}: {id}");
                    for role in ["outer", "inner"] {
                        check_rings(&osm, relation, role, &format!("{name}: {id}"));
                    }
                }
                other => panic!("{name}: {other}"),
            }
        }
        let keyed = |kind: &str| {
            let of_kind = osm.relations.values().filter(move |one| says(one, "type", kind));
            of_kind.filter_map(|one| one.tags.get("lane_key")).collect::<BTreeSet<_>>()
        };
        let (driven, areas) = (keyed("lanelet"), keyed("multipolygon"));
        let lanes = snapshot.map().lanes().filter(|lane| !lane.is_temporary());
        let stands =
            lanes.filter(|lane| matches!(lane.kind(), LaneType::Parking | LaneType::Median));
        // A section that became part of its neighbours has no area, and none has a lane without a width.
        let extends = |lane: &Lane<'_>| {
            let (low, high) = (lane.section().s_start(), lane.section().s_end());
            let places = (0..=8).map(|part| low + (high - low) * f64::from(part) / 8.0);
            high - low >= 0.1 && places.into_iter().any(|s| lane.width_at(s) >= 0.01)
        };
        let stands = stands.filter(extends);
        let keys: BTreeSet<String> = stands.map(|lane| lane.key().to_string()).collect();
        let expected: BTreeSet<&String> = keys.iter().filter(|key| !driven.contains(key)).collect();
        assert_eq!(areas, expected, "{name}");
        let ways = |kind: &str| -> BTreeSet<u64> {
            let of_kind = osm.relations.values().filter(move |one| says(one, "type", kind));
            of_kind.flat_map(|one| one.members.iter().map(|(_, member)| *member)).collect()
        };
        shared += ways("lanelet").intersection(&ways("multipolygon")).count();
    }
    assert!(shared > 0, "no area has a border of a lanelet");
}

#[test]
fn every_point_lies_at_the_edge_of_its_lane() {
    let mut cuts = 0;
    for path in carried_and(&[&MAPS[..], &[NARROW_TURNS]].concat()) {
        let snapshot = open(&path);
        let map = snapshot.map();
        let (osm, report, projector) = export(map, &path);
        for node in osm.nodes.values() {
            let [latitude, longitude] = node.place.expect("a place");
            let number = |name: &str| node.tags[name].parse::<f64>().expect("a number");
            let altitude = number("ele");
            let point = projector
                .from_geodetic(Geodetic { latitude, longitude, altitude })
                .expect("a place");
            let local = DVec3::new(number("local_x"), number("local_y"), point.z);
            assert!(point.distance(local) < SAME, "{}: {point} {local}", path.display());
        }
        // Where a border is cut, it goes on at the point where it crossed itself.
        let cut = told(&report, "cut");
        cuts += cut.len();
        let shift = map.header_offset().shift.z;
        for lanelet in lanelets(map, &osm) {
            if cut.contains(&(lanelet.lane.key().to_string().as_str(), "")) {
                continue;
            }
            let middle = 0.5 * (lanelet.s[0] + lanelet.s[1]);
            for (number, border) in lanelet.borders.iter().enumerate() {
                for node in border {
                    let point = osm.place(*node)
                        - DVec3::Z * if map.projection().is_empty() { 0.0 } else { shift };
                    let is_near = |s: f64| {
                        let edges = lanelet.lane.edges_at(s);
                        let t = if (number == 0) == (lanelet.lane.number() > 0) {
                            edges.outer
                        } else {
                            edges.inner
                        };
                        let edge = lanelet.lane.road().to_inertial(Track { s, t, h: 0.0 });
                        edge.is_ok_and(|edge| edge.position.distance(point) < NEAR)
                    };
                    let (from, to) = (lanelet.s[0], lanelet.s[1]);
                    let steps = (((to - from) / 0.02) as u32).max(1);
                    let on_road =
                        lanelet.lane.road().to_track(point).map_or(middle, |track| track.s);
                    let places =
                        (0..=steps).map(|i| from + (to - from) * f64::from(i) / f64::from(steps));
                    assert!(
                        is_near(mapd_geometry::clamp(on_road, from, to))
                            || places.into_iter().any(is_near),
                        "{}: {} {point}",
                        path.display(),
                        lanelet.lane.key()
                    );
                }
            }
        }
    }
    assert!(cuts > 0 || mapd_tests::shared("maps").is_none(), "no border is cut");
}

/// What Lanelet2 has no words for is counted in the report, and only what there is.
#[test]
fn the_report_counts_what_cannot_be_said() {
    let mut seen = BTreeSet::new();
    let folder = tempfile::tempdir().expect("a folder");
    // The kept maps have something of everything.
    let kept = mapd_tests::golden_maps::all().into_iter().map(|golden| {
        let path = folder.path().join(format!("{}.mapd", golden.name));
        let archive = golden.compile().expect("compiled");
        fs::write(&path, &archive).expect("written");
        (path, Snapshot::from_bytes(archive).expect("opens"))
    });
    let maps = carried_and(&MAPS).into_iter().map(|path| (path.clone(), open(&path)));
    for (path, snapshot) in maps.chain(kept) {
        let map = snapshot.map();
        let (_, report, _) = export(map, &path);
        let temporary = map.roads().map(|road| road.temporary_sections().count()).sum();
        for (what, count) in [
            ("controllers of signals", map.controllers().count()),
            ("tunnels and bridges", map.structures().len()),
            ("other data of the file", map.annotations().len()),
            ("temporary sections of lanes", temporary),
            ("rules of lanes in words", map.lanes().map(|lane| lane.rules().len()).sum()),
        ] {
            let told = report.iter().find(|one| &one[0] == what);
            let told = told.map_or(0, |one| one[6].parse().expect("a number"));
            assert_eq!(told, count, "{}: {what}", path.display());
            seen.extend((count > 0).then_some(what));
        }
    }
    assert_eq!(seen.len(), 5, "{seen:?}");
    // The town is flat; the road over a hill lies in its plane, too; a surface of its own does not.
    for (name, is_told) in [("town.xodr", false), ("surfaces.xodr", true)] {
        let path = carried(name);
        let (_, report, _) = export(open(&path).map(), &path);
        let told = report.iter().any(|one| one[0].starts_with("surfaces: "));
        assert_eq!(told, is_told, "{name}");
    }
}

/// What the report says became of pairs of lanes.
fn told<'r>(report: &'r [csv::StringRecord], what: &str) -> BTreeSet<(&'r str, &'r str)> {
    let of_kind = report.iter().filter(|one| &one[0] == what);
    of_kind.map(|one| (one.get(1).unwrap_or(""), one.get(2).unwrap_or(""))).collect()
}

#[test]
fn lanelets_follow_each_other_as_lanes_do_or_the_report_says_so() {
    for path in carried_and(&MAPS) {
        let snapshot = open(&path);
        let map = snapshot.map();
        let (osm, report, _) = export(map, &path);
        let all = lanelets(map, &osm);
        let (lost, extra) = (told(&report, "lost"), told(&report, "extra"));
        let find = |node: &LaneNode<'_>, at_end: bool| {
            let SRange { low: from, high: to } = node.s_range();
            let s = if node.is_forward() == at_end { to } else { from };
            let lane = node.lane()?.lane_id();
            all.iter().find(|one| {
                let end = one.s[usize::from(node.is_forward() == at_end)];
                one.lane.lane_id() == lane && (end - s).abs() < 1e-5
            })
        };
        // What the map says: from every way to every way.
        let mut expected = BTreeSet::new();
        for node in map.lane_nodes().filter(LaneNode::is_open) {
            let Some(own) = find(&node, true) else { continue };
            let end = ends(own, node.is_forward(), true);
            let (mut open, mut seen) = (vec![node], BTreeSet::new());
            while let Some(node) = open.pop() {
                for target in
                    node.edges().filter_map(|edge| edge.target()).filter(LaneNode::is_open)
                {
                    if let Some(next) = find(&target, false) {
                        let start = ends(next, target.is_forward(), false);
                        let from = own.lane.key().to_string();
                        let to = next.lane.key().to_string();
                        let is_lost = lost.contains(&(from.as_str(), to.as_str()));
                        assert!(start == end || is_lost, "{}: {from} {to}", path.display());
                        expected.insert((from, to));
                    } else if seen.insert(target.node_id()) {
                        open.push(target);
                    }
                }
            }
        }
        let mut starts: HashMap<[u64; 2], Vec<&Lanelet<'_>>> = HashMap::new();
        let ways = |one: &Lanelet<'_>| {
            let both = one.lane.nodes().any(|node| node.is_forward() != one.lane.is_forward());
            let own = one.lane.is_forward();
            [Some(own), both.then_some(!own)].into_iter().flatten().collect::<Vec<bool>>()
        };
        for one in &all {
            for forward in ways(one) {
                starts.entry(ends(one, forward, false)).or_default().push(one);
            }
        }
        for one in &all {
            for forward in ways(one) {
                for next in starts.get(&ends(one, forward, true)).into_iter().flatten() {
                    let (from, to) = (one.lane.key().to_string(), next.lane.key().to_string());
                    let shares = one.lane.nodes().any(|a| {
                        let mut classes = mapd_client::vocabulary::VehicleClass::ALL.iter();
                        classes.any(|class| {
                            a.allows(*class) && next.lane.nodes().any(|b| b.allows(*class))
                        })
                    });
                    let is_told = extra.contains(&(from.as_str(), to.as_str()));
                    let is_known = from == to || expected.contains(&(from.clone(), to.clone()));
                    assert!(is_known || is_told || !shares, "{}: {from} {to}", path.display());
                }
            }
        }
    }
}

/// What an element says in its tags.
fn says(element: &Element, name: &str, value: &str) -> bool {
    element.tags.get(name).is_some_and(|own| own == value)
}

#[test]
fn text_of_the_map_is_text_and_a_sign_is_a_rule_where_it_holds() {
    let folder = tempfile::tempdir().expect("a folder");
    let hostile = "</script><tag k=\"a\" v='1'/>&quot;\\";
    let id = hostile.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    let sign = format!(
        "</lanes><signals><signal s=\"20\" t=\"-5\" id=\"{id}\" name=\"\" dynamic=\"no\" orientation=\"+\" zOffset=\"2\" country=\"DE\" \
         type=\"274\" subtype=\"-1\" value=\"50\" unit=\"km/h\"/></signals>"
    );
    let text = fs::read_to_string(carried("one_road.xodr")).expect("a map");
    let path = folder.path().join("map.xodr");
    let text = text.replace("</lanes>", &sign);
    let road = format!("id=\"{id}\" junction");
    fs::write(&path, text.replacen("id=\"1\" junction", &road, 1)).expect("written");
    let snapshot = open(&path);
    let (osm, ..) = export(snapshot.map(), &path);
    let named = named_borders(&osm);
    assert!(!named.is_empty());
    for key in named.iter().flat_map(|(lanelet, borders)| borders.iter().chain([lanelet])) {
        let lane = snapshot.map().lane_by_key(&key.parse().expect("a key")).expect("a lane");
        assert_eq!(lane.road().id(), hostile);
    }
    let (line, way) =
        osm.ways.iter().find(|(_, way)| way.tags.contains_key("signal_id")).expect("the sign");
    assert!(says(way, "signal_id", hostile) && says(way, "subtype", "de274-50"), "{:?}", way.tags);
    let refers = |rule: &&Element| rule.members.contains(&("refers".to_owned(), *line));
    let rules: Vec<&Element> = osm.relations.values().filter(refers).collect();
    assert!(matches!(rules[..], [rule] if says(rule, "subtype", "speed_limit")));
    let mut limited = osm.relations.values().filter(|one| says(one, "speed_limit", "50"));
    assert!(limited.any(|one| one.tags["s_from"].parse::<f64>().is_ok_and(|s| s >= 20.0)));
}

#[test]
fn a_map_without_a_georeference_wants_an_origin_and_only_such_a_map() {
    let folder = tempfile::tempdir().expect("a folder");
    let [town, road] = ["town.xodr", "one_road.xodr"].map(carried);
    let [town, road] = [&town, &road].map(|path| path.to_str().expect("a path"));
    let check = |arguments: &[&str], code: i32, words: &[&str]| {
        let output = run(arguments, folder.path());
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
        assert!(words.iter().all(|word| said.contains(word)), "{arguments:?}: {said}");
    };
    check(&[town], 1, &["header/geoReference", "+proj=", "--origin"]);
    check(&[town, "--origin", "49.01,8.43", "-o", "town.osm"], 0, &[]);
    check(&[town, "--origin", "-33.9,-151.2", "-o", "town.osm"], 0, &[]);
    check(&[road, "--origin", "49.01,8.43"], 1, &["has a georeference", "--origin"]);
    for wrong in ["49.01", "49.01;8.43", "91,8", "49,181", "nan,8", ",", ""] {
        check(&[town, "--origin", wrong], 2, &["--origin"]);
    }
}

/// Borders that jump right before the end of their section run up to the jump.
#[test]
fn a_border_runs_up_to_where_it_jumps() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("map.xodr");
    let section = |s: f64, link: &str| {
        format!(
            r#"<laneSection s="{s}"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link>{link}</link>
            <width sOffset="0" a="4" b="0" c="0" d="0"/></lane></right></laneSection>"#
        )
    };
    for jump in [50.0 - 1e-8, 50.0 - 1e-4, 50.0, 50.0 + 1e-8, 50.0 + 1e-4] {
        let text = format!(
            r#"<OpenDRIVE><header revMajor="1" revMinor="8"><geoReference>+proj=utm +zone=32 +datum=WGS84</geoReference></header>
            <road id="1" length="100" junction="-1"><planView><geometry s="0" x="500000" y="5400000" hdg="0" length="100"><line/></geometry></planView>
            <lanes><laneOffset s="0" a="0" b="0" c="0" d="0"/><laneOffset s="{jump}" a="3" b="0" c="0" d="0"/>{}{}</lanes></road></OpenDRIVE>"#,
            section(0.0, r#"<successor id="-1"/>"#),
            section(50.0, r#"<predecessor id="-1"/>"#),
        );
        fs::write(&path, text).expect("written");
        let snapshot = open(&path);
        let map = snapshot.map();
        let (osm, ..) = export(map, &path);
        let corner = |x: f64, y: f64| DVec3::new(500_000.0 + x, 5_400_000.0 + y, 0.0);
        let all = lanelets(map, &osm);
        let near = |place: DVec3| {
            let points = all.iter().flat_map(|lanelet| lanelet.borders.iter().flatten());
            points.filter(|node| osm.place(**node).distance(place) < 0.01).count()
        };
        for (x, y) in [(50.0, 0.0), (50.0, -4.0), (50.0, 3.0), (50.0, -1.0)] {
            assert!(near(corner(x, y)) > 0, "{jump}: nothing at {x}, {y}");
        }
        assert_eq!(all.len(), 2, "{jump}");
        for node in all.iter().flat_map(|lanelet| lanelet.borders.iter().flatten()) {
            let place = osm.place(*node) - corner(0.0, 0.0);
            let edges = if place.x < 50.0 { [0.0, -4.0] } else { [3.0, -1.0] };
            let is_at_edge = edges.iter().any(|y| (place.y - y).abs() < 0.01);
            assert!(is_at_edge || (place.x - 50.0).abs() < 0.01, "{jump}: {place}");
        }
    }
}

/// With `--autoware` a crosswalk has the rule that refers to it, and a stop sign is called as Autoware calls it; without, neither is there.
#[test]
fn autoware_has_its_crosswalks_and_stop_signs() {
    let folder = tempfile::tempdir().expect("a folder");
    let sign = r#"</objects><signals><signal id="stop" s="40" t="-5" zOffset="2" orientation="+" dynamic="no" country="DE" type="206" subtype="-1" value="-1"/></signals>"#;
    let text = std::fs::read_to_string(mapd_tests::carried("objects.xodr")).expect("a map");
    assert!(text.contains("</objects>") && !text.contains("<signals>"));
    std::fs::write(folder.path().join("map.xodr"), text.replacen("</objects>", sign, 1))
        .expect("written");
    for is_wanted in [false, true] {
        let mut arguments = vec!["map.xodr", "-o", "out.osm", "--origin", "49,8.4"];
        arguments.extend(is_wanted.then_some("--autoware"));
        let output = run(&arguments, folder.path());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let osm = read(&folder.path().join("out.osm"));
        let crossings = || {
            let all = osm.relations.iter().filter(|(_, one)| says(one, "type", "lanelet"));
            all.filter(|(_, one)| says(one, "subtype", "crosswalk")).map(|(id, _)| *id)
        };
        let is_rule = |one: &&Element| {
            says(one, "type", "regulatory_element") && says(one, "subtype", "crosswalk")
        };
        let rules = osm.relations.values().filter(is_rule);
        let referred = rules.map(|rule| {
            let mut refers = rule.members.iter().filter(|(role, _)| role == "refers");
            let (Some((_, crossing)), None) = (refers.next(), refers.next()) else {
                panic!("{:?}", rule.members)
            };
            assert!(rule.members.iter().any(|(role, _)| role == "crosswalk_polygon"));
            *crossing
        });
        let expected: Vec<u64> = if is_wanted { crossings().collect() } else { Vec::new() };
        assert!(crossings().next().is_some());
        assert_eq!(referred.collect::<Vec<_>>(), expected);
        let signs = osm.ways.values().filter(|way| says(way, "type", "traffic_sign"));
        let subtypes = signs.map(|way| way.tags["subtype"].as_str()).collect::<Vec<_>>();
        assert_eq!(subtypes, [if is_wanted { "stop_sign" } else { "de206" }]);
    }
}
