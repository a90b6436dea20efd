//! Headings and curvatures of lanes: those of the line that keeps its offset from the lane's centre, by differences of positions on every map.

use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::localisation::{MatchOptions, VehiclePose};
use mapd_client::route::RouteEnd;
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Lane, Map, NearestOptions, Point, Snapshot};
use mapd_geometry::normalize_angle;
use mapd_tests::graph_maps::{Line, document, road, section, wide};
use mapd_tests::maps::{self, open_text};
use mapd_tests::{carried, corpus, say};
use std::f64::consts::PI;

/// Lanes of a map that are looked at, at most, and places on each.
const LANES: usize = 300;
const PLACES: u32 = 5;
/// Half the stretch over which differences are taken `[m]`, and what of it lies beside records that begin: there are corners.
const HALF: f64 = 2e-3;
/// What a direction and a curvature by differences may be off: `[rad]`, `[1/m]` and as a share of the curvature.
const TURN: f64 = 1e-5;
const BEND: f64 = 1e-4;
/// Share of places at which differences are no measure: where a width opens or closes between records, or the line nearly stands still.
const FEW: f64 = 0.01;

/// The heading by a difference of positions, as driven: beyond the centre of curvature the line runs backwards.
fn by_positions(lane: &Lane<'_>, s: f64, offset: f64, half: f64) -> (f64, f64) {
    let at = |s: f64| lane.pose_at(s, offset).expect("a pose").position.truncate();
    let run = (at(s + half) - at(s - half)) / (2.0 * half);
    let way = if lane.is_forward() { run } else { -run };
    let line = lane.pose_of_reference_line(s, 0.0).expect("a pose").heading;
    let road = DVec2::from_angle(if lane.is_forward() { line } else { line + PI });
    let way = if way.dot(road) < 0.0 { -way } else { way };
    (way.to_angle(), run.length())
}

/// Places that were compared, and those at which differences are no measure.
fn check_map(name: &str, map: Map<'_>) -> [usize; 2] {
    let (mut compared, mut left_out) = (0, 0);
    let count = map.lanes().count();
    for lane in map.lanes().step_by(count.div_ceil(LANES).max(1)) {
        let (start, end) = (lane.section().s_start(), lane.section().s_end());
        let (end, length) = (end.min(lane.road().reference_end()), end - start);
        let breaks: Vec<f64> = lane.shape_breaks().collect();
        for place in 0..PLACES {
            let s = start + length * (0.1 + 0.8 * f64::from(place) / f64::from(PLACES - 1));
            let near = |at: &f64| (at - s).abs() <= 2.0 * HALF;
            if s - 2.0 * HALF <= start || s + 2.0 * HALF >= end || breaks.iter().any(near) {
                continue;
            }
            let waypoint = lane.waypoint_at(s).expect("a waypoint");
            let centre = lane.pose_at(s, 0.0).expect("a pose");
            assert_eq!((centre.position, centre.heading), (waypoint.position, waypoint.heading));
            for offset in [0.0, 0.4 * lane.width_at(s), -1.2] {
                let pose = lane.pose_at(s, offset).expect("a pose");
                let (fine, growth) = by_positions(&lane, s, offset, 0.5 * HALF);
                let (coarse, _) = by_positions(&lane, s, offset, HALF);
                if growth < 0.05 || normalize_angle(fine - coarse).abs() > TURN {
                    left_out += 1;
                    continue;
                }
                compared += 1;
                let what = format!("{name}, {} at {s}, {offset} m aside", lane.key());
                let off = normalize_angle(pose.heading - fine).abs();
                assert!(off <= TURN, "{what}: {} where positions say {fine}", pose.heading);
                // The curvature is that of the headings, by the length that is driven.
                let place = |s: f64| lane.pose_at(s, offset).expect("a pose");
                let bend = |half: f64| {
                    let [before, behind] = [place(s - half), place(s + half)];
                    let run = behind.position.truncate() - before.position.truncate();
                    let driven = run.dot(DVec2::from_angle(pose.heading));
                    normalize_angle(behind.heading - before.heading) / driven
                };
                let (coarse, fine) = (bend(HALF), bend(0.5 * HALF));
                let allowed = BEND * (1.0 + fine.abs());
                if (coarse - fine).abs() > 0.5 * allowed {
                    left_out += 1;
                    continue;
                }
                let off = (pose.curvature - fine).abs();
                assert!(off <= allowed, "{what}: {} beside {fine}", pose.curvature);
            }
            // The position of a place says the same as its pose.
            let beside = lane.pose_at(s, 0.3 * lane.width_at(s)).expect("a pose");
            let found = lane.position_of(beside.position.truncate()).expect("a position");
            let again = lane.pose_at(found.s, found.offset).expect("a pose");
            let off = normalize_angle(found.heading - again.heading).abs();
            assert!(off < 1e-9, "{name}, {} at {s}: {found:?} beside {again:?}", lane.key());
        }
    }
    [compared, left_out]
}

#[test]
fn headings_and_curvatures_are_those_of_positions() {
    let mut all = vec![("town".to_owned(), carried("town.xodr"))];
    all.push(("one_road".to_owned(), carried("one_road.xodr")));
    all.push(("surfaces".to_owned(), carried("surfaces.xodr")));
    all.extend(corpus().unwrap_or_default());
    let mut sum = [0, 0];
    for (name, path) in all {
        let Some(snapshot) = maps::open_accepted(&path) else { continue };
        let counts = check_map(&name, snapshot.map());
        sum = [sum[0] + counts[0], sum[1] + counts[1]];
    }
    say(&format!("{} places compared, {} left out", sum[0], sum[1]));
    assert!(sum[0] > 1000 && (sum[1] as f64) < FEW * sum[0] as f64, "{sum:?}");
}

/// A road of 100 m along x with a lane beside lane 0 that widens by 0.2 m per metre from 2 m on, steps to 10 m at s = 40, and from there on keeps its width.
/// The next section begins with 3 m at s = 60.
fn widening(left_hand: bool) -> Snapshot {
    let rule = if left_hand { "rule=\"LHT\"" } else { "" };
    let width = |at: &str, a: &str, b: &str| {
        format!("<width sOffset=\"{at}\" a=\"{a}\" b=\"{b}\" c=\"0\" d=\"0\"/>")
    };
    let lanes = wide(-1, "", "", "a=\"2\" b=\"0.2\" c=\"0\" d=\"0\"", &width("40", "10", "0"));
    let next = wide(-1, "", "", "a=\"3\" b=\"-0.01\" c=\"0\" d=\"0\"", "");
    let sections = section(0.0, "", &lanes) + &section(60.0, "", &next);
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    open_text(&document(&road("1", rule, line, "", &sections)))
}

#[test]
fn a_widening_lane_has_a_heading_of_its_own() {
    for left_hand in [false, true] {
        let snapshot = widening(left_hand);
        let map = snapshot.map();
        let lane = |key: &str| map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
        let (first, second) = (lane("1:0:-1"), lane("1:1:-1"));
        assert_eq!(first.is_forward(), !left_hand);
        let back = if left_hand { PI } else { 0.0 };
        // The centre moves away by half of what the lane widens by; at the step the later record counts, at the section's end the earlier.
        for (lane, s, slope) in [
            (first, 10.0, -0.1),
            (first, 40.0, 0.0),
            (first, 60.0, 0.0),
            (second, 60.0, 0.005),
            (second, 100.0, 0.005),
        ] {
            for offset in [-0.7, 0.0, 0.7] {
                let pose = lane.pose_at(s, offset).expect("a pose");
                let expected = normalize_angle(f64::atan(slope) + back);
                let off = normalize_angle(pose.heading - expected).abs();
                assert!(off < 1e-12, "{} at {s}: {pose:?}, not {expected}", lane.key());
                assert!(pose.curvature.abs() < 1e-12, "{pose:?}");
                let road = lane.pose_of_reference_line(s, offset).expect("a pose");
                assert_eq!((road.heading, road.curvature), (0.0, 0.0));
            }
        }
        // Everything that compares headings has the lane's own.
        let at = first.pose_at(20.0, 0.0).expect("a pose");
        let found = first.position_of(at.position.truncate()).expect("a position");
        assert!((found.heading - at.heading).abs() < 1e-12, "{found:?}");
        assert_eq!(found.heading_of_reference_line, 0.0);
        let own = f64::atan(0.1);
        for (turn, passes) in [(0.0, true), (0.04, true), (own, false)] {
            let options = NearestOptions {
                heading: Some(at.heading + turn),
                heading_tolerance: Some(0.05),
                ..NearestOptions::default()
            };
            let near = map.nearest_lane(at.position.truncate(), &options).expect("an answer");
            let holds = near.is_some_and(|near| near.position.distance == 0.0);
            assert_eq!(holds, passes, "{turn}: {near:?}");
        }
        // Ahead is within a right angle of the lane's heading, which is not one of the road's.
        let end = |heading: f64| {
            let point = Point::from(at.position.truncate());
            RouteEnd::of_pose(map, point, heading, VehicleClass::PassengerCar).expect("an answer")
        };
        let (right, beyond) = (0.5 * PI - 0.01, 0.5 * PI + 0.01);
        for side in [-1.0, 1.0] {
            assert!(
                end(at.heading + side * right).is_some_and(|end| end.forward == Some(!left_hand))
            );
            assert!(end(at.heading + side * beyond).is_none_or(|end| end.place.s > 40.0 - 1e-6));
        }
    }
}

/// A concentric lane bends by its own radius; beyond the centre it keeps the driving direction and bends to the other side.
#[test]
fn curvature_is_that_of_the_lane() {
    let lanes = wide(-1, "", "", "a=\"4\" b=\"0\" c=\"0\" d=\"0\"", "");
    let line = Line(0.0, 0.0, 0.0, 30.0, -0.1);
    let snapshot = open_text(&document(&road("1", "", line, "", &section(0.0, "", &lanes))));
    let lane = snapshot.map().lane_by_key(&"1:0:-1".parse().expect("a key")).expect("a lane");
    for (offset, expected) in [(0.0, -0.125), (1.0, -1.0 / 9.0), (-10.0, 0.5)] {
        let pose = lane.pose_at(5.0, offset).expect("a pose");
        assert!((pose.curvature - expected).abs() < 1e-12, "{offset}: {pose:?}");
        assert!(normalize_angle(pose.heading + 0.5).abs() < 1e-12, "{pose:?}");
    }
    assert_eq!(lane.pose_at(5.0, -8.0).expect("a pose").curvature, 0.0, "it stands still");
}

/// Who drives along the straight edge of a lane that widens, along its other edge or in its middle is in it, and hardly in none.
#[test]
fn along_every_edge_of_a_widening_lane_one_is_in_it() {
    for left_hand in [false, true] {
        let snapshot = widening(left_hand);
        let map = snapshot.map();
        let lane = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("a lane");
        let back = if left_hand { PI } else { 0.0 };
        let mut out = Vec::new();
        for share in [0.1, 0.5, 0.9] {
            let at = DVec2::new(30.0, -8.0 * share);
            let heading = -f64::atan(0.2 * share) + back;
            let pose = VehiclePose { position: Point::from(at), heading };
            let covariance = DMat3::from_diagonal(DVec3::new(0.09, 0.09, 2.5e-3));
            let options = MatchOptions::default();
            let none = map.match_pose(&pose, &covariance, &options, &mut out).expect("an answer");
            let best = out.first().expect("a lane");
            assert_eq!((best.lane, best.forward), (lane.lane_id(), !left_hand), "{share}");
            assert!(none < 5e-3, "{share}: none has {none}");
            // What the match says of the lane is its own heading.
            let own = lane.pose_at(best.position.s, best.position.offset).expect("a pose");
            let off = best.heading_difference - normalize_angle(heading - own.heading);
            assert!(off.abs() < 1e-12, "{best:?}");
        }
    }
}
