//! What the line of a path is: how far its parts lie apart, how it bends and rolls, and which of two rounds is meant.

use crate::paths::each_path_of;
use mapd_client::Map;
use mapd_query::path::{Path, PathBuffer, PathOptions, PathPoint, steps_of_lanes};
use mapd_tests::graph_maps::{Line, all, document, lane, road, section, wide};
use mapd_tests::maps::{carried_and, open_text};

/// Distance from a joint at which both of its sides are asked `[m]`.
const BESIDE: f64 = 1e-7;
/// What positions and headings may be off there: rounding, and what is driven meanwhile.
const ROUNDING: f64 = 2e-6;
/// Pairs of places on each map between which a way is looked for.
const PAIRS: usize = 12;

/// How far the line's two sides at S lie apart `[m]`, and by how much it turns `[rad]`.
fn apart(path: &Path<'_, '_>, along: f64) -> (f64, f64) {
    let [before, after] = [along - BESIDE, along + BESIDE].map(|s| path.at(s).expect("a place"));
    let gap = before.position.truncate().distance(after.position.truncate());
    (gap, mapd_geometry::normalize_angle(after.heading - before.heading))
}

/// Positions at joints lie apart by the listed sizes and no more, on every carried and shared map; where no joint is listed, they meet.
#[test]
fn places_at_joints_lie_apart_by_what_is_listed() {
    let mut files = carried_and(&[]);
    match mapd_tests::corpus() {
        Some(corpus) => files.extend(corpus.into_iter().map(|(_, path)| path)),
        None => mapd_tests::say("SKIPPED in part: no shared corpus beside the workspace"),
    }
    let options = PathOptions::default();
    each_path_of(files, PAIRS, &options, |_, path, _, name, _| {
        for joint in path.joints() {
            // What lies nearer to another joint is that one's too.
            let alone = path.joints().iter().filter(|j| (j.along - joint.along).abs() < 1e-3);
            if alone.count() > 1 || joint.along < BESIDE || joint.along + BESIDE > path.length() {
                continue;
            }
            let (gap, kink) = apart(path, joint.along);
            assert!((gap - joint.gap).abs() < ROUNDING, "{name}: {gap} m at {joint:?}");
            let off = mapd_geometry::normalize_angle(kink - joint.kink).abs();
            assert!(off < 1e-4, "{name}: {kink} at {joint:?}");
        }
        for own in path.lanes().skip(1) {
            let along = own.along[0];
            if path.joints().iter().all(|joint| (joint.along - along).abs() > 1e-3) {
                let (gap, kink) = apart(path, along);
                assert!(gap < ROUNDING && kink.abs() < 1e-4, "{name}: {gap} m, {kink} at {along}");
            }
        }
    });
}

fn over<'a, 'b>(
    map: Map<'a>,
    keys: &[&str],
    ends: [f64; 2],
    buffer: &'b mut PathBuffer,
) -> Path<'a, 'b> {
    let id = |key: &&str| map.lane_by_key(&key.parse().expect("a key")).expect("a lane").lane_id();
    let (lanes, mut steps): (Vec<_>, _) = (keys.iter().map(id).collect(), Vec::new());
    steps_of_lanes(map, &lanes, ends, &mut steps).expect("steps");
    map.path(&steps, &PathOptions::default(), buffer).expect("a path")
}

/// A roundabout that is driven twice: every place is there twice, and the hint alone says which round is meant.
#[test]
fn of_two_rounds_the_hint_says_which() {
    let ring = all().into_iter().find(|one| one.name == "roundabout").expect("the map");
    let snapshot = open_text(&ring.text);
    let round = ["1:0:-1", "2:0:-1", "3:0:-1", "4:0:-1"];
    let keys = [round, round].concat();
    let mut buffer = PathBuffer::default();
    let path = over(snapshot.map(), &keys, [0.0, f64::MAX.min(1e3)], &mut buffer);
    let once = 0.5 * path.length();
    for i in 1..40 {
        let first = once * f64::from(i) / 40.0;
        let point = path.at(first).expect("a place").position.truncate();
        for (hint, expected) in [
            (None, first),
            (Some(first), first),
            (Some(first + once), first + once),
            (Some(first + once - 5.0), first + once),
            (Some(first + 5.0), first),
        ] {
            let found = path.project(point, hint).expect("a foot");
            assert!((found.along - expected).abs() < 1e-6, "{hint:?}: {found:?}, not {expected}");
        }
    }
}

/// A clothoid with a lane beside it: the driven line's curvature and its rate have a closed form, κ/(1 − κt) and κ'/(1 − κt)³.
#[test]
fn a_driven_line_bends_as_its_own_curve_does() {
    let spiral = "<spiral curvStart=\"0.002\" curvEnd=\"0.03\"/>";
    let line = Line(0.0, 0.0, 0.3, 140.0, 1.0);
    let lanes =
        section(0.0, &wide(1, "", "", "a=\"4\" b=\"0\" c=\"0\" d=\"0\"", ""), &lane(-1, ""));
    let text =
        road("1", "junction=\"-1\"", line, "", &lanes).replace("<arc curvature=\"1\"/>", spiral);
    assert!(text.contains(spiral));
    let snapshot = open_text(&document(&text));
    let growth = (0.03 - 0.002) / 140.0;
    for (key, t, ends, way) in
        [("1:0:-1", -1.75, [0.0, 140.0], 1.0), ("1:0:1", 2.0, [140.0, 0.0], -1.0)]
    {
        let mut buffer = PathBuffer::default();
        let path = over(snapshot.map(), &[key], ends, &mut buffer);
        for i in 1..50 {
            let at = path.at(path.length() * f64::from(i) / 50.0).expect("a place");
            let kappa = 0.002 + growth * at.s;
            let ahead = 1.0 - kappa * t;
            let (curvature, rate) = (way * kappa / ahead, growth / ahead.powi(3));
            assert!((at.curvature - curvature).abs() < 1e-6, "{key}: {at:?}, not {curvature}");
            assert!((at.curvature_rate - rate).abs() < 1e-5, "{key}: {at:?}, not {rate}");
        }
    }
}

/// On every map: the rate is that by which the curvature differs a metre on, and the roll that of the road, as the driver sees it.
#[test]
fn rates_and_rolls_are_those_of_finite_differences() {
    const REACH: f64 = 0.5;
    let options = PathOptions::default();
    each_path_of(
        carried_and(&["carla/Town05", "esmini/multi_intersections"]),
        PAIRS,
        &options,
        |map, path, _, name, random| {
            for _ in 0..20 {
                let along = random.between(REACH, path.length() - REACH);
                let places = [-REACH, 0.0, REACH].map(|d| path.at(along + d).expect("a place"));
                let [before, at, after] = places;
                let road = map.lane(at.lane).expect("its lane").road();
                let roll = road.superelevation_at(at.s);
                let roll = if at.forward { roll } else { -roll };
                assert!((at.superelevation - roll).abs() < 1e-9, "{name}: {at:?}");
                let turn = |a: &PathPoint, b: &PathPoint| {
                    mapd_geometry::normalize_angle(b.heading - a.heading)
                };
                // Where the line bends evenly the second difference of its heading is the rate.
                let rate = (turn(&at, &after) - turn(&before, &at)) / (REACH * REACH);
                let even = (before.curvature_rate - after.curvature_rate).abs() < 1e-4;
                let smooth = (before.curvature + after.curvature - 2.0 * at.curvature).abs() < 1e-4;
                if even && smooth && !crate::paths::is_near_joint(path, along) {
                    assert!((at.curvature_rate - rate).abs() < 1e-2, "{name}: {at:?}, not {rate}");
                }
            }
        },
    );
}
