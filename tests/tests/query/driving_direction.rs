//! Left, right and ahead are those of a lane's traffic; s that lies outside or is no number is treated in one way.

use mapd_client::{Map, Track, glam::DVec2};
use mapd_query::{Clamped, QueryError};
use mapd_tests::annotated::{document, road};
use mapd_tests::maps::{carried_and, open, open_text};

/// Lanes on either side of lane 0, on straight and bent roads, in left-hand traffic too.
const MAPS: [&str; 3] = ["carla/Town05", "sumo/lefthand_netconvert", "esmini/e6mini"];
/// What places may be off `[m]`.
const TOLERANCE: f64 = 1e-6;
/// Every how many lanes of a large map are looked at.
const STEP: usize = 5;

/// Looks at lanes of every map that are wide at their middle.
fn each_lane(check: impl Fn(Map<'_>, mapd_client::Lane<'_>, f64)) {
    for path in carried_and(&MAPS) {
        let snapshot = open(&path);
        let map = snapshot.map();
        let mut looked_at = 0;
        for lane in map.lanes().step_by(STEP) {
            let s = 0.5 * (lane.section().s_start() + lane.section().s_end());
            if lane.width_at(s) > 0.5 && lane.center_line().len() > 1 {
                check(map, lane, s);
                looked_at += 1;
            }
        }
        assert!(looked_at > 0, "{}", path.display());
    }
}

/// `Lane::left` looked along the reference line, `LaneNode::left` along the traffic.
#[test]
fn lanes_and_nodes_have_one_left() {
    each_lane(|_, lane, s| {
        let node = lane.node_at(s, lane.is_forward()).expect("a node");
        for (beside, of_node) in [(lane.left(), node.left()), (lane.right(), node.right())] {
            let of_node = of_node.and_then(|node| node.lane());
            if let Some(of_node) = of_node {
                let beside = beside.map(|lane| lane.lane_id());
                assert_eq!(beside, Some(of_node.lane_id()), "lane {}", lane.key());
            }
        }
        let turned = [lane.right_of_reference_line(), lane.left_of_reference_line()];
        let along = [lane.left_of_reference_line(), lane.right_of_reference_line()];
        let wanted = if lane.is_forward() { along } else { turned };
        let found = [lane.left(), lane.right()];
        assert_eq!(found.map(|l| l.map(|l| l.lane_id())), wanted.map(|l| l.map(|l| l.lane_id())));
    });
}

#[test]
fn bounds_offsets_and_headings_are_those_of_the_traffic() {
    each_lane(|map, lane, s| {
        let pose = lane.pose_at(s, 0.0).expect("a pose");
        let left = DVec2::from_angle(pose.heading).perp();
        let [left_edge, right_edge] = lane.bounds_at(s).expect("edges");
        let middle = pose.position.truncate();
        assert!((left_edge.truncate() - middle).dot(left) > 0.0, "lane {}", lane.key());
        assert!((right_edge.truncate() - middle).dot(left) < 0.0, "lane {}", lane.key());
        let is_left = |line: mapd_query::roads::Polyline<'_>, edge: DVec2| {
            let points: Vec<DVec2> = line.positions().map(|p| p.truncate()).collect();
            points.windows(2).any(|w| {
                let along = w[1] - w[0];
                let part = (edge - w[0]).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
                (w[0] + along * mapd_geometry::clamp(part, 0.0, 1.0)).distance(edge) < 0.3
            })
        };
        assert!(is_left(lane.left_bound(), left_edge.truncate()), "lane {}", lane.key());
        assert!(is_left(lane.right_bound(), right_edge.truncate()), "lane {}", lane.key());
        // A point to the left of the traffic has a positive offset, and is found again by it.
        let offset = 0.2 * lane.width_at(s);
        let beside = lane.pose_at(s, offset).expect("a pose");
        assert!((beside.position.truncate() - middle).dot(left) > 0.0, "lane {}", lane.key());
        let found = lane.position_of(beside.position.truncate()).expect("a position");
        if found.distance == 0.0 && (found.s - s).abs() < TOLERANCE {
            assert!((found.offset - offset).abs() < TOLERANCE, "{found:?}");
            let sign = if lane.is_forward() { 1.0 } else { -1.0 };
            assert!((found.offset_of_reference_line - sign * offset).abs() < TOLERANCE);
            let turn = DVec2::from_angle(found.heading).dot(DVec2::from_angle(pose.heading));
            assert!(turn > 1.0 - TOLERANCE, "{found:?} beside {pose:?}");
            let line = DVec2::from_angle(found.heading_of_reference_line);
            assert!(sign * line.dot(DVec2::from_angle(found.heading)) > 0.0);
        }
        let again = map.lane(lane.lane_id()).expect("its own");
        let along = again.pose_of_reference_line(s, offset).expect("a pose");
        let same = lane.pose_at(s, if lane.is_forward() { offset } else { -offset });
        assert_eq!(along.position, same.expect("a pose").position);
    });
}

/// `to_inertial{s: NaN}` and `pose_at(NaN)` answered as if s were 0, `waypoint_at(1e6)` with x = 6e11.
#[test]
fn what_is_no_place_is_an_error_and_what_lies_outside_is_clamped_and_said() {
    each_lane(|_, lane, _| {
        let road = lane.road();
        for s in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let wrong = Some(QueryError::NotFinite);
            assert_eq!(road.to_inertial(Track { s, t: 0.0, h: 0.0 }).err(), wrong);
            assert_eq!(road.surface_at(s, 0.0).err(), wrong);
            assert_eq!(lane.pose_at(s, 0.0).err(), wrong);
            assert_eq!(lane.pose_of_reference_line(s, 0.0).err(), wrong);
            assert_eq!(lane.waypoint_at(s).err(), wrong);
            assert!(lane.width_at(s).is_nan() && lane.edges_at(s).center().is_nan());
            assert!(road.elevation_at(s).is_nan() && road.superelevation_at(s).is_nan());
            assert!(road.lane_offset_at(s).is_nan() && lane.height_at(s).inner.is_nan());
            assert!(lane.length_between(s, 0.0).is_nan());
            assert!(road.section_at(s).is_none() && road.cross_section(s).is_none());
            assert!(lane.edge_points_at(s).is_none() && lane.node_at(s, true).is_none());
            assert!(
                lane.recorded_speed_limit_at(s).is_none() && lane.speed_rule_at(s).max.is_none()
            );
            assert!(lane.road_mark_at(s).is_none());
        }
        let (start, end) = (lane.section().s_start(), lane.section().s_end());
        for (s, inside, clamped) in [
            (start - 50.0, start, Clamped::Before),
            (start, start, Clamped::No),
            (end, end, Clamped::No),
            (1e6, end, Clamped::After),
        ] {
            let pose = lane.pose_at(s, 0.0).expect("a pose");
            let wanted = lane.pose_at(inside, 0.0).expect("a pose");
            assert_eq!((pose.position, pose.clamped), (wanted.position, clamped), "{}", lane.key());
            let point = lane.waypoint_at(s).expect("a waypoint");
            assert_eq!(
                (point.s, point.position, point.clamped),
                (inside, wanted.position, clamped)
            );
            assert_eq!(lane.edges_at(s), lane.edges_at(inside));
        }
        let whole = road.to_inertial(Track { s: 1e7, t: 0.0, h: 0.0 }).expect("a pose");
        assert_eq!(whole.clamped, Clamped::After);
    });
}

/// Lane 0 has no side: its search for the next lane once took steps of none, without an end.
#[test]
fn lane_0_has_no_opposite() {
    let snapshot = open_text(&document(8, "", &road("1", 0.0, "", "", "")));
    let section = snapshot.map().road_by_id("1").and_then(|road| road.section(0)).expect("one");
    assert!(section.lane(0).expect("lane 0").opposite().is_none());
}
