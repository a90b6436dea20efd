//! Lanes and borders near a point or in a rectangle, against looking at every lane; hints; waypoints.

use mapd_client::Bounds;
use mapd_client::{
    Lane, LaneId, LaneTypes, Map, NearestOptions, Point, QueryError, Region, Snapshot, Track,
    glam::DVec2,
};
use mapd_tests::maps::{Random, carried_and, open, open_text};
use std::path::PathBuf;

/// Points per map; each looks at every lane.
const POINTS: usize = 100;
/// Points along a trajectory per map.
const STEPS: usize = 3_000;
/// What two ways of deciding may differ by \[m\]: the foot on a border is found by iteration.
const TOLERANCE: f64 = 1e-7;

fn maps() -> Vec<(PathBuf, Snapshot)> {
    carried_and(&["carla/Town05", "esmini/velodrome", "esmini/multi_intersections"])
        .into_iter()
        .map(|path| (path.clone(), open(&path)))
        .collect()
}

#[test]
fn lanes_near_are_those_within_the_radius_nearest_first() {
    for (path, snapshot) in maps() {
        let (map, mut random, mut out) = (snapshot.map(), Random(3), Vec::new());
        for _ in 0..POINTS {
            let point = random.point(map);
            let options =
                NearestOptions { radius: random.between(0.5, 30.0), ..NearestOptions::default() };
            map.lanes_near(point, &options, &mut out).expect("an answer");
            let first = map.nearest_lane(point, &options).expect("an answer");
            assert_eq!(out.first().map(|n| n.lane), first.map(|n| n.lane), "{}", path.display());
            assert!(out.windows(2).all(|w| w[0].position.distance <= w[1].position.distance));
            let mut found: Vec<LaneId> = out.iter().map(|n| n.lane).collect();
            found.sort_by_key(|id| id.row());
            assert!(found.windows(2).all(|w| w[0] != w[1]), "a lane twice");
            for lane in map.lanes() {
                let distance = lane.position_of(point).expect("a position").distance;
                let is_in =
                    found.binary_search_by_key(&lane.lane_id().row(), |id| id.row()).is_ok();
                let border = (distance - options.radius).abs() < TOLERANCE;
                assert!(
                    border || is_in == (distance < options.radius),
                    "{}: {point} within {}, lane {} at {distance}",
                    path.display(),
                    options.radius,
                    lane.key()
                );
            }
        }
    }
}

#[test]
fn a_hint_changes_no_answer() {
    for (path, snapshot) in maps() {
        let (map, mut random) = (snapshot.map(), Random(4));
        let roads: Vec<_> = map.roads().filter(|road| road.length() > 1.0).collect();
        let mut hint = None;
        for i in 0..STEPS {
            // Along a road, now and then to another place: the hint is then far away.
            let road = &roads[i / 100 * 7 % roads.len()];
            let track = Track {
                s: (i % 100) as f64 * road.length() / 100.0,
                t: random.between(-6.0, 6.0),
                h: 0.0,
            };
            let place = road.to_inertial(track).expect("a pose").position;
            let plain = NearestOptions::default();
            let level = NearestOptions { z_tolerance: Some(0.5), heading: Some(1.0), ..plain };
            let mut expected = None;
            for (point, options) in [(place.into(), level), (Point::from(place.truncate()), plain)]
            {
                expected = map.nearest_lane(point, &options).expect("an answer");
                let found = map.nearest_lane(point, &NearestOptions { hint, ..options });
                assert_eq!(found, Ok(expected), "{}: {point:?}", path.display());
            }
            hint = expected;
        }
    }
}

/// Whether any of a lane's area, looked at on a grid, lies in a rectangle.
fn grid_meets(lane: &Lane<'_>, region: Region) -> bool {
    let (start, end) = (lane.section().s_start(), lane.section().s_end());
    let steps = ((end - start) / 0.1).ceil().max(1.0) as usize;
    (0..=steps).any(|i| {
        let s = start + (end - start) * i as f64 / steps as f64;
        let edges = lane.edges_at(s);
        (0..=20).any(|k| {
            let t = edges.inner + (edges.outer - edges.inner) * f64::from(k) / 20.0;
            let pose = lane.road().to_inertial(Track { s, t, h: 0.0 }).expect("a pose");
            let p = pose.position.truncate();
            p.cmpge(region.low).all() && p.cmple(region.high).all()
        })
    })
}

/// A rectangle grown or shrunk.
fn grown(region: Region, by: f64) -> Region {
    Region { low: region.low - by, high: region.high + by }
}

/// Empty places of the index met rectangles that reach beyond single precision, and were counted among what may be looked at.
#[test]
fn nothing_is_missing_in_the_largest_rectangle() {
    let everywhere = Region { low: DVec2::MIN, high: DVec2::MAX };
    for (path, snapshot) in maps() {
        let map = snapshot.map();
        let Bounds { low, high } = map.bounds();
        let around = Region { low: low.truncate() - 1000.0, high: high.truncate() + 1000.0 };
        let found = [everywhere, around].map(|region| {
            let (mut lanes, mut places, mut signals) = (Vec::new(), Vec::new(), Vec::new());
            map.lanes_in(region, LaneTypes::ALL, &mut lanes).expect("an answer");
            map.objects_in(region, &mut places).expect("an answer");
            map.signals_in(region, &mut signals).expect("an answer");
            lanes.sort_by_key(|lane| lane.row());
            places.sort();
            signals.sort_by_key(|signal| signal.row());
            (lanes, places, signals)
        });
        assert_eq!(found[0], found[1], "{}", path.display());
        assert!(found[0].0.len() > 1, "{}", path.display());
    }
}

#[test]
fn lanes_in_a_rectangle_are_those_whose_area_meets_it() {
    // The grid's step and the borders' tolerance.
    const SLACK: f64 = 0.15;
    let road = carried_and(&[]);
    for path in road {
        let snapshot = open(&path);
        let (map, mut random, mut out) = (snapshot.map(), Random(5), Vec::new());
        for _ in 0..20 {
            let region = Region::around(random.point(map), random.between(0.3, 12.0));
            map.lanes_in(region, LaneTypes::ALL, &mut out).expect("an answer");
            for lane in map.lanes() {
                let is_in = out.contains(&lane.lane_id());
                let (low, high) = (lane_box(&lane), region);
                let far = low.0.cmpgt(high.high).any() || low.1.cmplt(high.low).any();
                if far {
                    assert!(!is_in, "{}: {} is far from {region:?}", path.display(), lane.key());
                } else if is_in {
                    assert!(grid_meets(&lane, grown(region, SLACK)), "{} {region:?}", lane.key());
                } else {
                    assert!(!grid_meets(&lane, grown(region, -SLACK)), "{} {region:?}", lane.key());
                }
            }
        }
    }
}

/// A box around both borders of a lane, a little more.
fn lane_box(lane: &Lane<'_>) -> (DVec2, DVec2) {
    let points = || lane.left_bound().positions().chain(lane.right_bound().positions());
    let low = points().fold(DVec2::INFINITY, |low, p| low.min(p.truncate()));
    let high = points().fold(DVec2::NEG_INFINITY, |high, p| high.max(p.truncate()));
    (low - 0.5, high + 0.5)
}

#[test]
fn border_segments_in_a_rectangle_are_all_there_once() {
    for (path, snapshot) in maps() {
        let (map, mut random) = (snapshot.map(), Random(6));
        let (mut lanes, mut out) = (Vec::new(), Vec::new());
        for _ in 0..POINTS {
            let region = Region::around(random.point(map), random.between(0.5, 40.0));
            map.boundary_segments(region, LaneTypes::ALL, &mut lanes, &mut out).expect("an answer");
            // Points of borders in the rectangle must be ends of segments that were found.
            let mut expected = 0;
            for section in map.roads().flat_map(|road| road.sections()) {
                for lane in section.lanes() {
                    let positions: Vec<_> = lane.border().positions().collect();
                    for pair in positions.windows(2) {
                        let inside = |p: &mapd_client::glam::DVec3| {
                            p.truncate().cmpge(region.low).all()
                                && p.truncate().cmple(region.high).all()
                        };
                        if pair.iter().any(inside) {
                            expected += 1;
                            let known = out
                                .iter()
                                .filter(|s| s.lane == lane.lane_id() && s.ends[..] == *pair)
                                .count();
                            assert!(known >= 1, "{}: {} {pair:?}", path.display(), lane.key());
                        }
                    }
                }
            }
            assert!(out.len() >= expected);
            for w in out.windows(2) {
                let ascending = (w[0].lane.row(), w[0].s[0]) <= (w[1].lane.row(), w[1].s[0]);
                assert!(ascending && w[0] != w[1], "{}", path.display());
            }
        }
    }
}

#[test]
fn a_point_is_covered_where_a_lane_is() {
    for (_, snapshot) in maps() {
        let (map, mut random) = (snapshot.map(), Random(8));
        for _ in 0..POINTS {
            let point = random.point(map);
            let covered = map.covers(point, None).expect("an answer");
            let inside = |lane: Lane<'_>| lane.contains(point).expect("an answer");
            assert_eq!(covered, map.lanes().any(inside), "{point}");
        }
    }
}

/// Heights tell stacked roads apart already in the index: with a tolerance only lanes at that height are found.
#[test]
fn heights_exclude_other_levels() {
    let snapshot = open(&mapd_tests::carried("one_road.xodr"));
    let map: Map<'_> = snapshot.map();
    let lane = map.lanes().next().expect("a lane");
    let place = lane.waypoint_at(20.0).expect("a place").position;
    let options = NearestOptions { z_tolerance: Some(1.0), ..NearestOptions::default() };
    for (above, found) in [(0.0, true), (0.9, true), (-0.9, true), (1.1, false), (-40.0, false)] {
        let point = Point { xy: place.truncate(), z: Some(place.z + above) };
        let hit = map.nearest_lane(point, &options).expect("an answer");
        assert_eq!(hit.is_some(), found, "{above} m above");
    }
}

#[test]
fn waypoints_run_along_the_lane_at_their_step() {
    for (path, snapshot) in maps() {
        let map = snapshot.map();
        for lane in map.lanes().step_by(7) {
            let (start, end) = (lane.section().s_start(), lane.section().s_end());
            for step in [0.25, 1.0, 7.3] {
                let points: Vec<_> = lane
                    .waypoints(step)
                    .expect("a step")
                    .collect::<Result<_, _>>()
                    .expect("waypoints");
                let (first, last) = (points[0], points[points.len() - 1]);
                let forward = lane.is_forward();
                let ends = if forward { (start, end) } else { (end, start) };
                assert_eq!((first.s, last.s), ends, "{}: {}", path.display(), lane.key());
                for w in points.windows(2) {
                    let gone = (w[1].s - w[0].s).abs();
                    assert!(gone <= step + 1e-9, "{gone} m at a step of {step}");
                    assert!(w[0].heading.abs() <= std::f64::consts::PI);
                }
                for p in &points {
                    let exact = lane.pose_at(p.s, 0.0).expect("a pose").position;
                    assert_eq!(p.position, exact);
                    assert_eq!(p.width, lane.width_at(p.s));
                }
            }
            assert!(lane.waypoints(0.0).is_err() && lane.waypoints(f64::NAN).is_err());
        }
    }
}

/// A step that is too small for its lane is refused before any place is looked at, and the number of places is known without looking.
#[test]
fn waypoints_are_counted_first_and_at_most_a_million() {
    for (path, snapshot) in maps() {
        for lane in snapshot.map().lanes().step_by(7) {
            let length = lane.section().s_end() - lane.section().s_start();
            let what = || format!("{}: {}", path.display(), lane.key());
            for step in [1e-9, 1e-300] {
                let refused = lane.waypoints(step * length).err();
                assert_eq!(refused, Some(QueryError::Option("step")), "{}", what());
            }
            let many = lane.waypoints(2e-6 * length).map(|all| all.len());
            assert!(many.is_ok_and(|many| many.abs_diff(500_001) <= 1), "{}", what());
            // As they have been: at every multiple of the step before the end, and at the end.
            for step in [0.1, 0.7, length / 3.0, length / 49.0, length, 2.0 * length] {
                let before = (0u32..).take_while(|n| f64::from(*n) * step < length).count();
                let all = lane.waypoints(step).expect("a step");
                assert_eq!(all.len(), before + 1, "{} at {step} m", what());
                assert_eq!(all.count(), before + 1, "{} at {step} m", what());
            }
        }
    }
}

/// The heading of a waypoint is the direction of the centre line itself: compared with a difference of places.
#[test]
fn waypoints_head_where_the_centre_line_goes() {
    const STEP: f64 = 1e-4;
    for (path, snapshot) in maps() {
        let map = snapshot.map();
        let mut compared = 0;
        for lane in map.lanes() {
            let (start, end) = (lane.section().s_start(), lane.section().s_end());
            let s = start + 0.47 * (end - start);
            let near_break = lane.shape_breaks().any(|b| (b - s).abs() < 2.0 * STEP);
            if near_break || end - start < 1.0 || lane.width_at(s) == 0.0 {
                continue;
            }
            let at = |s: f64| lane.waypoint_at(s).expect("a place");
            let mut gone = (at(s + STEP).position - at(s - STEP).position).truncate();
            if !lane.is_forward() {
                gone = -gone;
            }
            let heading = DVec2::from_angle(at(s).heading);
            let off = heading.angle_to(gone).abs();
            assert!(off < 1e-6, "{}: lane {} at {s}: {off} rad", path.display(), lane.key());
            compared += 1;
        }
        assert!(compared > 0, "{}", path.display());
    }
}

/// A lane of 6 m inside a bend of 2 m runs back along it; traffic goes on with the road all the same. Outside of the bend,
/// and within its radius, the direction is that of the line.
#[test]
fn waypoints_of_a_folded_lane_keep_to_the_driving_direction() {
    let map = |curvature: f64, rule: &str| {
        format!(
            r#"<OpenDRIVE><header revMajor="1" revMinor="8"/><road id="1" length="5" junction="-1" rule="{rule}"><planView><geometry s="0" x="0" y="0" hdg="0" length="5"><arc curvature="{curvature}"/></geometry></planView><lanes><laneSection s="0"><left><lane id="1" type="driving"><width sOffset="0" a="6" b="0.1" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center></laneSection></lanes></road></OpenDRIVE>"#
        )
    };
    for (curvature, rule) in [(0.5, "RHT"), (0.5, "LHT"), (0.1, "RHT"), (0.1, "LHT"), (-0.5, "LHT")]
    {
        let snapshot = open_text(&map(curvature, rule));
        let lane = snapshot.map().lanes().find(|lane| lane.number() == 1).expect("the lane");
        for place in 0..=10 {
            let s = 0.5 * f64::from(place);
            let back = if rule == "RHT" { std::f64::consts::PI } else { 0.0 };
            let along = DVec2::from_angle(curvature * s + back);
            let heading = DVec2::from_angle(lane.waypoint_at(s).expect("a place").heading);
            let off = heading.angle_to(along).abs();
            assert!(off < 0.5, "{off} rad off at {s} in a bend of {curvature} 1/m, {rule}");
        }
    }
}
