//! Who may drive where, which way a lane leads, and what yields rest on.

use mapd_client::glam::DVec2;
use mapd_client::vocabulary::{Relation, VehicleClass};
use mapd_client::{Lane, LanePosition, LaneTypes, NearestOptions, QueryError};
use mapd_query::compiling::position_along;
use mapd_query::rules::Basis;
use mapd_query::rules::YieldsTo;
use mapd_query::vocabulary::LaneType;
use mapd_tests::graph_maps::{Line, document, lane, road, section, wide};
use mapd_tests::maps::{Random, carried_and, open, open_text};

/// Points on each map.
const POINTS: usize = 300;
/// How far lanes are looked for `[m]`.
const RADIUS: f64 = 30.0;

/// The set of drivable lanes counted lanes that the lane graph closes to cars.
#[test]
fn lane_types_and_the_lane_graph_have_one_truth() {
    for vehicle in VehicleClass::ALL {
        for kind in LaneType::ALL {
            let open = VehicleClass::of_lane_type(*kind) & vehicle.bit() != 0;
            assert_eq!(LaneTypes::open_to(*vehicle).contains(*kind), open, "{vehicle:?} {kind:?}");
        }
    }
    let (drivable, routable) = (LaneTypes::drivable(), LaneTypes::routable());
    for (kind, is_drivable, is_routable) in [
        (LaneType::Driving, true, true),
        (LaneType::Bus, true, true),
        (LaneType::Border, true, false),
        (LaneType::Stop, true, false),
        (LaneType::Restricted, true, false),
        (LaneType::Sidewalk, false, false),
        (LaneType::Unknown, false, false),
    ] {
        assert_eq!(drivable.contains(kind), is_drivable, "{kind:?}");
        assert_eq!(routable.contains(kind), is_routable, "{kind:?}");
    }
    for word in ["all", "drivable", "routable", "driving"] {
        let set = LaneTypes::from_word(word);
        assert!(set.is_some_and(|set| set.contains(LaneType::Driving)), "{word}");
    }
    assert_eq!(LaneTypes::from_word("drivable"), Some(drivable));
    assert_eq!(LaneTypes::from_word("drive"), None);
}

#[test]
fn the_nearest_lane_for_a_vehicle_is_the_nearest_that_is_open_to_it() {
    for path in carried_and(&["carla/Town05", "esmini/multi_intersections"]) {
        let snapshot = open(&path);
        let map = snapshot.map();
        let mut random = Random(5);
        let (mut near, mut found) = (Vec::new(), 0);
        for _ in 0..POINTS {
            let point = random.point(map);
            for vehicle in [VehicleClass::PassengerCar, VehicleClass::Pedestrian] {
                let all = NearestOptions { radius: RADIUS, ..NearestOptions::default() };
                let options = NearestOptions { vehicle: Some(vehicle), ..all };
                let hit = map.nearest_lane(point, &options).expect("an answer");
                map.lanes_near(point, &all, &mut near).expect("an answer");
                let open = near.iter().find(|one| {
                    let lane = map.lane(one.lane).expect("known");
                    let way = |forward| lane.node_at(one.position.s, forward);
                    [way(true), way(false)].iter().flatten().any(|node| node.allows(vehicle))
                });
                // A lane that is open elsewhere may be near with another of its stretches.
                match (hit, open) {
                    (Some(hit), Some(open)) => {
                        assert!(hit.position.distance <= open.position.distance + 1e-9);
                        found += 1;
                    }
                    (None, Some(open)) => panic!("{}: missed {open:?}", path.display()),
                    _ => {}
                }
                if let Some(hit) = hit {
                    let lane = map.lane(hit.lane).expect("known");
                    let way = |forward| lane.node_at(hit.position.s, forward);
                    let open = [way(true), way(false)];
                    assert!(open.iter().flatten().any(|node| node.allows(vehicle)));
                }
            }
        }
        assert!(found > 10, "{}: {found}", path.display());
    }
}

/// `successors` of a lane that is used both ways gave one direction only.
/// Nobody drives where a lane has no width, whether it is written as 0 or by a cubic that goes on below it.
#[test]
fn nobody_drives_on_a_width_below_0() {
    let pieces = |width: &str| {
        let right = lane(-1, "") + &wide(-2, "", "", width, "");
        let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
        let text = document(&road("1", "junction=\"-1\"", line, "", &section(0.0, "", &right)));
        let snapshot = open_text(&text);
        let lane = snapshot.map().lane_by_key(&"1:0:-2".parse().expect("a key")).expect("a lane");
        lane.nodes()
            .map(|node| (node.s_range().low, node.s_range().high, node.is_open()))
            .collect::<Vec<_>>()
    };
    let falls = "a=\"3\" b=\"-0.075\" c=\"0\" d=\"0\"";
    let zero = "a=\"0\" b=\"0\" c=\"0\" d=\"0\"";
    let expected = [(0.0, 40.0, true), (40.0, 100.0, false)];
    assert_eq!(pieces(&format!("{falls}/><width sOffset=\"40\" {zero}")), expected);
    assert_eq!(pieces(falls), expected);
    assert_eq!(pieces(&format!("{falls}/><width sOffset=\"60\" {zero}")), expected);
}

#[test]
fn a_lane_that_is_used_both_ways_leads_both_ways() {
    let road = |id: u32, x: f64, link: &str, lane: &str, kind: &str| {
        format!(
            "<road id=\"{id}\" length=\"50\" junction=\"-1\"><link>{link}</link><planView>\
             <geometry s=\"0\" x=\"{x}\" y=\"0\" hdg=\"0\" length=\"50\"><line/></geometry></planView><lanes><laneSection s=\"0\">\
             <center><lane id=\"0\"/></center><right><lane id=\"-1\" type=\"{kind}\"><link>{lane}</link>\
             <width sOffset=\"0\" a=\"3\" b=\"0\" c=\"0\" d=\"0\"/></lane></right></laneSection></lanes></road>"
        )
    };
    let next = |contact: &str, id: u32, name: &str| {
        format!("<{name} elementType=\"road\" elementId=\"{id}\" contactPoint=\"{contact}\"/>")
    };
    for (kind, back) in [("bidirectional", true), ("driving", false)] {
        let text = format!(
            "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>{}{}</OpenDRIVE>",
            road(1, 0.0, &next("start", 2, "successor"), "<successor id=\"-1\"/>", kind),
            road(2, 50.0, &next("end", 1, "predecessor"), "<predecessor id=\"-1\"/>", kind),
        );
        let snapshot = open_text(&text);
        let map = snapshot.map();
        let lane = |key: &str| map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
        let (first, second) = (lane("1:0:-1"), lane("2:0:-1"));
        let ids = |lanes: &mut dyn Iterator<Item = mapd_client::LaneId>| lanes.collect::<Vec<_>>();
        assert_eq!(ids(&mut first.successors()), [second.lane_id()], "{kind}");
        assert_eq!(ids(&mut first.successors_towards(true)), [second.lane_id()], "{kind}");
        assert_eq!(ids(&mut second.predecessors_towards(true)), [first.lane_id()], "{kind}");
        let other_way = if back { vec![first.lane_id()] } else { Vec::new() };
        assert_eq!(ids(&mut second.successors_towards(false)), other_way, "{kind}");
        let other_way = if back { vec![second.lane_id()] } else { Vec::new() };
        assert_eq!(ids(&mut first.predecessors_towards(false)), other_way, "{kind}");
        assert_eq!(ids(&mut first.successors_towards(false)), [], "{kind}");
    }
}

/// What the places of two stretches that meet may differ by, where one of them rounds the foot to its end `[m]`.
const JOINT: f64 = 1e-12;

/// A lane's position of a point is the nearest of those in its stretches, one by one: what is left out changes nothing.
fn check_position(name: &str, lane: &Lane<'_>, point: DVec2) {
    let segments = 0..lane.center_line().len().saturating_sub(1);
    let all = segments.filter_map(|i| position_along(lane, i, point, f64::INFINITY));
    let all: Vec<LanePosition> = all.collect();
    let key = |p: &LanePosition| (p.distance, p.offset_of_reference_line.abs(), p.s);
    let nearest = all.iter().reduce(|a, b| if key(b) < key(a) { b } else { a });
    let what = || format!("{name}: lane {} at {point}", lane.key());
    let Some(nearest) = nearest else {
        assert_eq!(lane.position_of(point), Err(QueryError::Corrupt), "{}", what());
        assert_eq!(lane.contains(point), Err(QueryError::Corrupt), "{}", what());
        return;
    };
    let found = lane.position_of(point).expect("a position");
    assert!(all.contains(&found), "{}: {found:?}", what());
    // Where two stretches meet, either may answer.
    let is_joint = || lane.center_line().stations().any(|s| (s - found.s).abs() <= JOINT);
    let (own, least) = (key(&found), key(nearest));
    let is_near = (own.1 - least.1).abs() <= JOINT && (own.2 - least.2).abs() <= JOINT;
    let is_either = || own.0 == least.0 && is_near && is_joint();
    assert!(own == least || is_either(), "{}: {found:?}, {nearest:?}", what());
    assert_eq!(lane.contains(point), Ok(nearest.distance == 0.0), "{}", what());
}

#[test]
fn a_position_is_the_nearest_of_all_of_a_lanes_stretches() {
    let maps = ["esmini/velodrome", "esmini/soderleden", "carla/Town05", "carla/Town03"];
    for path in carried_and(&maps) {
        let (name, snapshot) = (path.display().to_string(), open(&path));
        let map = snapshot.map();
        let mut random = Random(11);
        let mut lanes: Vec<_> = map.lanes().collect();
        lanes.sort_by_key(|lane| std::cmp::Reverse(lane.center_line().len()));
        for lane in lanes.iter().take(6) {
            (0..40).for_each(|_| check_position(&name, lane, random.point(map)));
        }
        // Beside the lane, at its ends and where its stretches meet.
        for lane in lanes.iter().filter(|lane| lane.number() != 0) {
            let (start, end) = (lane.section().s_start(), lane.section().s_end());
            let joint = lane.center_line().station(1).unwrap_or(start);
            let inside = start + random.unit() * (end - start);
            for s in [start, joint, inside, end] {
                let offset = (random.unit() - 0.5) * 12.0;
                for offset in [0.0, 0.5 * lane.width_at(s), offset] {
                    let pose = lane.pose_at(s, offset).expect("a pose");
                    check_position(&name, lane, pose.position.truncate());
                }
            }
        }
    }
}

/// A motorway yielded "from the right" to a ramp; lanes that nobody may use were yielded to.
#[test]
fn yields_rest_on_what_is_written_and_name_open_lanes() {
    let maps = carried_and(&["carla/Town05", "carla/Town03", "esmini/multi_intersections"]);
    for path in maps {
        let snapshot = open(&path);
        let map = snapshot.map();
        for lane in map.lanes() {
            for YieldsTo { lane: other, reason } in lane.yields_to() {
                assert_eq!(Basis::of(reason), Basis::Written, "{}", path.display());
                assert!(other.nodes().any(|node| node.is_open()), "{}", path.display());
            }
            let written = lane.right_of_way().filter(|one| {
                let open = |lane: mapd_client::Lane<'_>| lane.nodes().any(|node| node.is_open());
                one.relation() == Relation::Yields && one.other().is_some_and(open)
            });
            assert_eq!(written.count(), lane.yields_to().count(), "{}", path.display());
        }
    }
}
