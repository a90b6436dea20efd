//! The ground below a place: that of the road's surface, on the level that z says.

use mapd_client::glam::DVec2;
use mapd_client::localisation::{GroundScratch, VehiclePose};
use mapd_client::{LaneId, Map, NearestOptions, Point, QueryError};
use mapd_tests::carried;
use mapd_tests::maps::{self, Random};
use std::f64::consts::{FRAC_PI_2, PI};

/// A road at the height 0 from west to east, one at the height 6 above it from south to north, 3.5 m for each way.
fn bridge() -> String {
    let road = |id: u32, x: f64, y: f64, hdg: f64, z: f64| {
        format!(
            r#"<road name="" length="100" id="{id}" junction="-1"><planView><geometry s="0" x="{x}" y="{y}" hdg="{hdg}" length="100"><line/></geometry></planView>
<elevationProfile><elevation s="0" a="{z}" b="0.01" c="0" d="0"/></elevationProfile>
<lanes><laneSection s="0"><left><lane id="1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></left>
<center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0" d="0"/><material sOffset="0" surface="asphalt" friction="0.8"/></lane></right></laneSection></lanes></road>"#
        )
    };
    let roads =
        road(1, -50.0, 0.0, 0.0, 0.0) + &road(2, 0.0, -50.0, std::f64::consts::FRAC_PI_2, 6.0);
    format!(r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>{roads}</OpenDRIVE>"#)
}

fn point(x: f64, y: f64, z: Option<f64>) -> Point {
    Point { xy: DVec2::new(x, y), z }
}

#[test]
fn z_decides_between_a_bridge_and_the_road_below() {
    let snapshot = maps::open_text(&bridge());
    let map = snapshot.map();
    let mut scratch = GroundScratch::default();
    let mut check = |at: Point, expected: Option<(f64, &str, u32, u32)>| {
        let ground = map.ground_at(at, &[], &mut scratch).expect("an answer");
        let got = ground.map(|ground| {
            let lane = map.lane(ground.lane).expect("a lane").key().to_string();
            ((ground.z * 1e9).round() / 1e9, lane, ground.level, ground.levels)
        });
        assert_eq!(got, expected.map(|(z, lane, a, b)| (z, lane.to_owned(), a, b)), "{at:?}");
    };
    // Both roads rise by 1 %: 0.5 m in their middles.
    check(point(1.0, -1.0, None), Some((0.51, "1:0:-1", 0, 2)));
    check(point(1.0, -1.0, Some(0.0)), Some((0.51, "1:0:-1", 0, 2)));
    check(point(1.0, -1.0, Some(3.4)), Some((0.51, "1:0:-1", 0, 2)));
    check(point(1.0, -1.0, Some(3.6)), Some((6.49, "2:0:-1", 1, 2)));
    check(point(1.0, -1.0, Some(1e6)), Some((6.49, "2:0:-1", 1, 2)));
    check(point(-20.0, 1.0, Some(6.0)), Some((0.3, "1:0:1", 0, 1)));
    check(point(-1.0, 30.0, None), Some((6.8, "2:0:1", 0, 1)));
    check(point(30.0, 30.0, None), None);
    let ground = map
        .ground_at(point(20.0, -1.0, None), &[], &mut scratch)
        .expect("an answer")
        .expect("ground");
    assert_eq!(ground.material.map(|material| material.surface), Some("asphalt"));
    let slope = 1.0 / (1.0f64 + 1e-4).sqrt();
    assert!(
        (ground.normal.z - slope).abs() < 1e-12 && (ground.normal.x + 0.01 * slope).abs() < 1e-12
    );
}

/// The lane of a key.
fn lane(map: Map<'_>, key: &str) -> LaneId {
    map.lane_by_key(&key.parse().expect("a key")).expect("a lane").lane_id()
}

/// Without z the lane that the vehicle was in tells the bridge from the road below, for one place, many, and four wheels; z goes first.
#[test]
fn the_last_lane_decides_between_a_bridge_and_the_road_below() {
    let snapshot = maps::open_text(&bridge());
    let (map, mut scratch) = (snapshot.map(), GroundScratch::default());
    let (below, above, away) = (lane(map, "1:0:-1"), lane(map, "2:0:-1"), lane(map, "2:0:1"));
    let at = |z: Option<f64>| point(1.0, -1.0, z);
    for (z, expected, height, key) in [
        (None, &[][..], 0.51, "1:0:-1"),
        (None, &[below], 0.51, "1:0:-1"),
        (None, &[above], 6.49, "2:0:-1"),
        // Where none of them is, the lowest; of several the lowest that has one.
        (None, &[away], 0.51, "1:0:-1"),
        (None, &[away, above], 6.49, "2:0:-1"),
        (None, &[above, below], 0.51, "1:0:-1"),
        (Some(0.0), &[above], 0.51, "1:0:-1"),
        (Some(6.0), &[below], 6.49, "2:0:-1"),
    ] {
        let found = map.ground_at(at(z), expected, &mut scratch).expect("an answer");
        let found = found.expect("ground");
        assert!((found.z - height).abs() < 1e-9, "{z:?} {expected:?}: {found:?}");
        assert_eq!(found.lane, lane(map, key), "{z:?} {expected:?}");
        let mut many = Vec::new();
        map.ground_below(&[at(z)], expected, &mut scratch, &mut many).expect("answers");
        assert_eq!(many, [Some(found)]);
    }
    let wheels = [[1.0, 0.8], [1.0, -0.8], [-1.0, 0.8], [-1.0, -0.8]].map(DVec2::from_array);
    let pose = VehiclePose { position: point(1.2, -1.7, None), heading: FRAC_PI_2 };
    let mut stand = |expected: &[LaneId]| {
        let found = map.stance(&pose, &wheels, expected, &mut scratch).expect("an answer");
        found.expect("ground").z
    };
    assert!((stand(&[above]) - 6.483).abs() < 1e-9 && (stand(&[below]) - 0.512).abs() < 1e-9);
    // Two wheels on the lane beside the expected one are on its level, whichever wheel is on which lane.
    for heading in [FRAC_PI_2, -FRAC_PI_2] {
        let pose = VehiclePose { position: point(0.1, -1.7, None), heading };
        let found = map.stance(&pose, &wheels, &[above], &mut scratch).expect("an answer");
        let found = found.expect("ground");
        assert!((found.z - 6.483).abs() < 1e-9 && found.roll.abs() < 1e-9, "{found:?}");
    }
}

/// Of the lanes that overlap in a junction, an expected one is the answer.
#[test]
fn an_expected_lane_of_a_level_is_the_answer() {
    let snapshot = maps::open(&carried("town.xodr"));
    let (map, mut scratch, mut random) = (snapshot.map(), GroundScratch::default(), Random(41));
    let (options, mut near, mut seen) =
        (NearestOptions { radius: 0.0, ..NearestOptions::default() }, Vec::new(), 0);
    for _ in 0..2_000 {
        let at = random.point(map);
        map.lanes_near(at, &options, &mut near).expect("an answer");
        let Some(last) = near.last().filter(|_| near.len() > 1) else { continue };
        let found = map.ground_at(at, &[last.lane], &mut scratch).expect("an answer");
        let found = found.expect("ground");
        assert_eq!((found.lane, found.levels), (last.lane, 1), "{at}");
        seen += 1;
    }
    assert!(seen > 20, "{seen}");
}

/// On roads that rise by 1 % ahead of the one and to the side of the other, at the pose's level.
#[test]
fn four_wheels_stand_on_the_ground() {
    let snapshot = maps::open_text(&bridge());
    let (map, mut scratch) = (snapshot.map(), GroundScratch::default());
    let wheels = [[2.8, 0.8], [2.8, -0.8], [0.0, 0.8], [0.0, -0.8]].map(DVec2::from_array);
    let mut ask = |x: f64, y: f64, z: Option<f64>, heading: f64, wheels: &[DVec2; 4]| {
        let pose = VehiclePose { position: point(x, y, z), heading };
        map.stance(&pose, wheels, &[], &mut scratch)
    };
    let slope = 0.01f64.atan();
    // Along the lower road, up and down, and along the upper one.
    for (at, heading, expected) in [
        ((20.0, -1.0, None), 0.0, [0.7, 0.0, -slope]),
        ((20.0, 1.0, None), PI, [0.7, 0.0, slope]),
        ((20.0, 0.0, None), FRAC_PI_2, [0.7, -slope, 0.0]),
        ((20.0, 0.0, None), -FRAC_PI_2, [0.7, slope, 0.0]),
        ((1.0, 0.0, Some(6.0)), FRAC_PI_2, [6.5, 0.0, -slope]),
    ] {
        let (x, y, z) = at;
        let found = ask(x, y, z, heading, &wheels).expect("an answer").expect("ground");
        for (got, expected) in [found.z, found.roll, found.pitch].iter().zip(expected) {
            assert!((got - expected).abs() < 1e-9, "{at:?} {heading}: {found:?}");
        }
        assert!(found.wheels.iter().all(Option::is_some));
    }
    // Three wheels on the road are enough, two are not.
    let beside = ask(20.0, -3.4, None, 0.3, &wheels).expect("an answer");
    let count = beside.map_or(2, |found| found.wheels.iter().flatten().count());
    assert!((2..4).contains(&count), "{beside:?}");
    assert_eq!(ask(20.0, 30.0, None, 0.0, &wheels), Ok(None));
    let line = [0.0, 1.0, 2.0, 3.0].map(|x| DVec2::new(x, 0.0));
    assert_eq!(ask(20.0, -1.0, None, 0.0, &line), Ok(None));
    let mut lost = wheels;
    lost[2].y = f64::NAN;
    assert_eq!(ask(20.0, -1.0, None, 0.0, &lost), Err(QueryError::NotFiniteAt(2)));
    assert_eq!(ask(20.0, -1.0, None, f64::NAN, &wheels), Err(QueryError::NotFinite));
}

/// Of many places the answers are those of each, and what is wrong has its number.
#[test]
fn many_places_answer_as_each_does() {
    let snapshot = maps::open_text(&bridge());
    let (map, mut random) = (snapshot.map(), Random(3));
    let mut points: Vec<Point> =
        (0..200).map(|i| Point { xy: random.point(map), z: (i % 2 == 0).then_some(5.0) }).collect();
    let (mut scratch, mut out) = (GroundScratch::default(), Vec::new());
    map.ground_below(&points, &[], &mut scratch, &mut out).expect("answers");
    let single =
        |at: &Point| map.ground_at(*at, &[], &mut GroundScratch::default()).expect("an answer");
    assert_eq!(out, points.iter().map(single).collect::<Vec<_>>());
    assert!(out.iter().flatten().count() > 10);
    points[7].z = Some(f64::NAN);
    let got = map.ground_below(&points, &[], &mut scratch, &mut out);
    assert_eq!(got, Err(QueryError::NotFiniteAt(7)));
    map.ground_below(&[], &[], &mut scratch, &mut out).expect("an answer");
    assert!(out.is_empty());
}

/// Places of the surface, by s and t, have themselves below them.
fn check_surface(map: Map<'_>, tolerance: f64) -> usize {
    let (mut random, mut scratch, mut seen) = (Random(9), GroundScratch::default(), 0);
    for lane in map.lanes() {
        let section = lane.section();
        for _ in 0..8 {
            let s = random.between(section.s_start(), section.s_end());
            let edges = lane.edges_at(s);
            if edges.width() < 0.5 {
                continue;
            }
            let t = edges.inner + (edges.outer - edges.inner) * random.between(0.2, 0.8);
            let surface = lane.road().surface_at(s, t).expect("a surface");
            let ground = map.ground_at(surface.position, &[], &mut scratch).expect("an answer");
            let ground = ground.expect("ground");
            if ground.lane == lane.lane_id() {
                let away = (ground.z - surface.position.z).abs();
                assert!(away <= tolerance, "{} at {s}, {t}: {away}", lane.key());
                seen += 1;
            }
        }
    }
    seen
}

#[test]
fn the_ground_is_the_roads_surface() {
    // Beside the plane, heights above it are shifted sideways by at most a few centimetres; along the slope that is made good.
    for (name, tolerance) in [("one_road.xodr", 1e-9), ("town.xodr", 1e-9), ("surfaces.xodr", 5e-3)]
    {
        let snapshot = maps::open(&carried(name));
        assert!(check_surface(snapshot.map(), tolerance) > 20, "{name}");
    }
}
