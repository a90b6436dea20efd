//! Roads above, beside and around each other: the right one wins.

use mapd_client::glam::{DVec2, DVec3};
use mapd_client::{Map, NearestOptions, QueryError, Snapshot, Track};
use mapd_tests::maps::open_text;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::fmt::Write;

/// Width of every lane `[m]`: one to each side of the reference line.
const WIDTH: f64 = 3.5;
/// How near in height a lane must be `[m]`; levels lie farther apart.
const LEVEL: f64 = 2.0;
/// Places looked at on each road.
const PLACES: usize = 40;

/// A road of a test map.
struct Way {
    start: DVec2,
    heading: f64,
    /// Curvature at the start and at the end `[1/m]`, and length `[m]`, of each geometry.
    parts: Vec<(f64, f64, f64)>,
    /// Elevation: a + b·s + c·s² + d·s³.
    elevation: [f64; 4],
    superelevation: f64,
}

impl Way {
    fn new(start: DVec2, heading: f64, parts: &[(f64, f64, f64)], z: f64) -> Self {
        Self {
            start,
            heading,
            parts: parts.to_vec(),
            elevation: [z, 0.0, 0.0, 0.0],
            superelevation: 0.0,
        }
    }

    fn text(&self, id: usize) -> String {
        let (mut at, mut heading, mut s) = (self.start, self.heading, 0.0);
        let mut geometries = String::new();
        for &(curvature_start, curvature_end, length) in &self.parts {
            let (element, primitive) = if curvature_start == curvature_end {
                let element = format!("<arc curvature=\"{curvature_start:e}\"/>");
                (element, mapd_geometry::Primitive::Arc { curvature: curvature_start })
            } else {
                let element = format!(
                    "<spiral curvStart=\"{curvature_start:e}\" curvEnd=\"{curvature_end:e}\"/>"
                );
                (element, mapd_geometry::Primitive::Spiral { curvature_start, curvature_end })
            };
            let _ = write!(
                geometries,
                "<geometry s=\"{s:e}\" x=\"{:e}\" y=\"{:e}\" hdg=\"{heading:e}\" length=\"{length:e}\">{element}</geometry>",
                at.x, at.y
            );
            let compiled = mapd_geometry::compile(&primitive, length).expect("a curve");
            let start = mapd_geometry::Start::new(at.x, at.y, heading);
            let curve =
                mapd_geometry::Curve::new(compiled.kind, start, length, &compiled.coefficients);
            let end = curve.expect("fits").evaluate(length);
            (at, heading, s) = (DVec2::new(end.x, end.y), end.heading, s + length);
        }
        let [a, b, c, d] = self.elevation;
        let lane = |id: i32| {
            format!(
                "<lane id=\"{id}\" type=\"driving\"><width sOffset=\"0\" a=\"{WIDTH}\" b=\"0\" c=\"0\" d=\"0\"/></lane>"
            )
        };
        format!(
            "<road id=\"{id}\" length=\"{s:e}\" junction=\"-1\"><planView>{geometries}</planView>\
             <elevationProfile><elevation s=\"0\" a=\"{a:e}\" b=\"{b:e}\" c=\"{c:e}\" d=\"{d:e}\"/></elevationProfile>\
             <lateralProfile><superelevation s=\"0\" a=\"{:e}\" b=\"0\" c=\"0\" d=\"0\"/></lateralProfile>\
             <lanes><laneSection s=\"0\"><left>{}</left><center><lane id=\"0\" type=\"none\"/></center><right>{}</right></laneSection></lanes></road>",
            self.superelevation,
            lane(1),
            lane(-1)
        )
    }
}

fn open(ways: &[Way]) -> Snapshot {
    let roads: String = ways.iter().enumerate().map(|(id, way)| way.text(id)).collect();
    let text = format!("<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>{roads}</OpenDRIVE>");
    open_text(&text)
}

/// From places on every lane's centre to points and back: with its height, each is found on the lane it came from; `plan`
/// says whether that must hold without a height too.
fn check(map: Map<'_>, plan: bool) {
    let options = NearestOptions { z_tolerance: Some(LEVEL), ..NearestOptions::default() };
    let mut hint = None;
    for lane in map.lanes() {
        let (road, length) = (lane.road(), lane.road().reference_end());
        for place in 0..PLACES {
            let s = length * (place as f64 + 0.5) / PLACES as f64;
            let t = lane.edges_at(s).center();
            let point = road.to_inertial(Track { s, t, h: 0.0 }).expect("a pose").position;
            for options in [options, NearestOptions { hint, ..options }] {
                let hit = map.nearest_lane(point, &options).expect("an answer").expect("a lane");
                let found = map.lane(hit.lane).expect("its own lane");
                assert_eq!(
                    (found.key(), hit.position.distance),
                    (lane.key(), 0.0),
                    "s = {s}: {hit:?}"
                );
                assert!(
                    (hit.position.s - s).abs() < 1e-7 && hit.position.offset.abs() < 1e-7,
                    "{hit:?} for s = {s}"
                );
                hint = Some(hit);
            }
            if plan {
                let hit = map.nearest_lane(point.truncate(), &NearestOptions::default());
                let hit = hit.expect("an answer").expect("a lane");
                assert_eq!(map.lane(hit.lane).expect("its own lane").key(), lane.key(), "s = {s}");
            }
            let track = road.to_track(DVec3::new(point.x, point.y, point.z)).expect("a foot");
            assert!(
                (track.s - s).abs() < 1e-7 && (track.t - t).abs() < 1e-7,
                "{track:?} for s = {s}, t = {t}"
            );
        }
    }
}

#[test]
fn a_ring_road_beside_itself() {
    // A whole circle of 20 m radius, entered by four straights that end at its outer edge.
    let ring = Way::new(DVec2::new(20.0, 0.0), FRAC_PI_2, &[(0.05, 0.05, TAU * 20.0)], 0.0);
    let mut ways = vec![ring];
    for arm in 0..4 {
        let direction = DVec2::from_angle(FRAC_PI_2 * f64::from(arm));
        let start = direction * 74.0;
        ways.push(Way::new(start, FRAC_PI_2 * f64::from(arm) + PI, &[(0.0, 0.0, 50.0)], 0.0));
    }
    check(open(&ways).map(), true);
}

#[test]
fn a_clover_leaf_on_two_levels() {
    // Two roads that cross at a right angle, one 6 m above the other, and four loops of three quarters of a circle that
    // climb from one to the other.
    let mut ways = vec![
        Way::new(DVec2::new(-200.0, 0.0), 0.0, &[(0.0, 0.0, 400.0)], 0.0),
        Way::new(DVec2::new(0.0, -200.0), FRAC_PI_2, &[(0.0, 0.0, 400.0)], 6.0),
    ];
    for leaf in 0..4 {
        let turn = DVec2::from_angle(FRAC_PI_2 * f64::from(leaf));
        let (radius, length) = (40.0, 1.5 * PI * 40.0);
        let from = turn.rotate(DVec2::new(10.0, -50.0));
        let heading = FRAC_PI_2 * f64::from(leaf);
        let mut way = Way::new(from, heading, &[(1.0 / radius, 1.0 / radius, length)], 0.0);
        let [low, high] = if leaf % 2 == 0 { [0.0, 6.0] } else { [6.0, 0.0] };
        // Level at both ends: a cubic from low to high.
        let climb = high - low;
        way.elevation = [low, 0.0, 3.0 * climb / length.powi(2), -2.0 * climb / length.powi(3)];
        ways.push(way);
    }
    // Loops pass over and under the roads at other heights than theirs, and where they meet a road at its own height two
    // lanes are equally right: only the two roads themselves are asked there.
    let snapshot = open(&ways);
    let map = snapshot.map();
    let options = NearestOptions { z_tolerance: Some(LEVEL), ..NearestOptions::default() };
    for (road, z) in [("0", 0.0), ("1", 6.0)] {
        for x in [-1.0, 0.0, 1.0] {
            for y in [-1.0, 0.0, 1.0] {
                let hit = map.nearest_lane(DVec3::new(x, y, z), &options).expect("an answer");
                let lane = map.lane(hit.expect("a lane").lane).expect("its own lane");
                assert_eq!(lane.road().id(), road, "{x}, {y}, {z}");
            }
        }
    }
}

#[test]
fn a_tunnel_under_a_road_along_it() {
    // A tunnel 8 m below a road, in the same place in plan view, and a bridge 7 m above both.
    let along =
        |z: f64| Way::new(DVec2::new(0.0, 0.0), 0.3, &[(0.0, 0.01, 100.0), (0.01, 0.01, 80.0)], z);
    let mut sinking = along(0.0);
    sinking.elevation = [-8.0, 0.02, 0.0, 0.0];
    check(open(&[along(0.0), sinking, along(7.0)]).map(), false);
}

#[test]
fn an_oval_with_steep_turns() {
    // Two straights and two half circles with transitions, superelevated by 0.6 rad all round: the inner lane's plan view
    // shrinks to 83 %.
    let turn = |curvature: f64, length: f64| (curvature, curvature, length);
    let half = |radius: f64| {
        let curvature = 1.0 / radius;
        let transition = 20.0;
        // Both transitions turn by κ·l/2 each; the circle does the rest of π.
        let circle = (PI - curvature * transition) / curvature;
        vec![(0.0, curvature, transition), turn(curvature, circle), (curvature, 0.0, transition)]
    };
    let mut parts = vec![turn(0.0, 60.0)];
    parts.extend(half(25.0));
    parts.push(turn(0.0, 60.0));
    parts.extend(half(25.0));
    let mut way = Way::new(DVec2::new(0.0, 0.0), 0.0, &parts, 0.0);
    way.superelevation = 0.6;
    check(open(&[way]).map(), true);
}

#[test]
fn a_spiral_that_winds_around_itself() {
    // Curvature from 1/60 to 1/20 over 300 m: more than one and a half turns, the second one inside the first, 9.4 m apart
    // where they are nearest.
    check(open(&[Way::new(DVec2::ZERO, 0.0, &[(1.0 / 60.0, 1.0 / 20.0, 300.0)], 0.0)]).map(), true);
}

#[test]
fn a_ramp_that_winds_above_itself() {
    // Three turns of one circle, 4.5 m of climb a turn.
    let length = 3.0 * TAU * 15.0;
    let mut way = Way::new(DVec2::ZERO, 0.0, &[(1.0 / 15.0, 1.0 / 15.0, length)], 0.0);
    way.elevation = [0.0, 4.5 / (TAU * 15.0), 0.0, 0.0];
    let snapshot = open(&[way]);
    let map = snapshot.map();
    let options = NearestOptions { z_tolerance: Some(LEVEL), ..NearestOptions::default() };
    for lane in map.lanes() {
        for place in 0..PLACES {
            let s = length * (place as f64 + 0.5) / PLACES as f64;
            let point = lane.pose_at(s, 0.3).expect("a pose").position;
            let hit = map.nearest_lane(point, &options).expect("an answer").expect("a lane");
            assert_eq!(map.lane(hit.lane).expect("its own lane").key(), lane.key());
            assert!((hit.position.s - s).abs() < 1e-7, "{hit:?} for s = {s}");
            // Of the places on one lane the same one is named among all lanes nearby.
            let mut near = Vec::new();
            map.lanes_near(point, &NearestOptions::default(), &mut near).expect("an answer");
            let alone = map.nearest_lane(point, &NearestOptions::default()).expect("an answer");
            assert_eq!(near.first().copied(), alone, "s = {s}");
        }
    }
}

/// Beside a banked lane its height is that of its edge: the point's own t would put it metres lower. With and without a hint.
#[test]
fn beside_a_banked_lane_its_edge_tells_the_level() {
    let mut way = Way::new(DVec2::ZERO, 0.0, &[(0.0, 0.0, 100.0)], 0.0);
    way.superelevation = 0.3;
    let snapshot = open(&[way]);
    let map = snapshot.map();
    let edge = -WIDTH * 0.3_f64.sin();
    let mut hint = None;
    for (y, z, known) in [
        (-1.0, edge / 2.0, true),
        (-6.0, edge, true),
        (-6.0, -6.0 * 0.3_f64.tan(), false),
        (-11.0, edge, true),
        (-11.0, -3.4, false),
        (8.0, -edge, true),
        (8.0, 2.5, false),
    ] {
        let options = NearestOptions { z_tolerance: Some(0.5), ..NearestOptions::default() };
        let point = DVec3::new(50.0, y, z);
        for options in [options, NearestOptions { hint, ..options }] {
            let found = map.nearest_lane(point, &options).expect("an answer");
            assert_eq!(found.is_some(), known, "{point}: {found:?}");
            hint = found.or(hint);
        }
    }
}

/// Absurd coordinates are refused, and far ones are in no lane.
#[test]
fn far_away_is_in_no_lane_and_absurd_places_are_refused() {
    let arc = Way::new(DVec2::ZERO, 0.0, &[(0.01, 0.01, 100.0)], 0.0);
    let line = Way::new(DVec2::new(0.0, 50.0), 0.0, &[(0.0, 0.0, 100.0)], 0.0);
    let snapshot = open(&[arc, line]);
    let map = snapshot.map();
    let options = NearestOptions { radius: f64::MAX, ..NearestOptions::default() };
    let places = |far: f64| [DVec2::new(far, 50.0), DVec2::new(0.0, -far), DVec2::new(far, far)];
    for point in places(1e9) {
        for lane in map.lanes().filter(|lane| lane.number() != 0) {
            assert!(!lane.contains(point).expect("an answer"), "{point}");
        }
        let found = map.nearest_lane(point, &options).expect("an answer");
        assert!(found.is_none_or(|found| found.position.distance > 0.9e9), "{point}: {found:?}");
    }
    for far in [1.1e9, 1e150, 1e156, 1e300, f64::MAX, f64::INFINITY, f64::NAN] {
        for point in places(far) {
            for lane in map.lanes().filter(|lane| lane.number() != 0) {
                assert_eq!(lane.contains(point), Err(QueryError::NotFinite), "{point}");
                let road = lane.road();
                assert_eq!(road.to_track(point).err(), Some(QueryError::NotFinite), "{point}");
                let track = Track { s: 1.0, t: far, h: 0.0 };
                assert_eq!(road.to_inertial(track).err(), Some(QueryError::NotFinite), "{point}");
            }
            assert_eq!(map.nearest_lane(point, &options), Err(QueryError::NotFinite), "{point}");
        }
    }
}
