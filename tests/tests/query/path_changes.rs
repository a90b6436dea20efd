//! Changes of lane as a curve over a length.

use crate::paths::{each_path_with, is_near_joint};
use mapd_query::path::{LaneChange, PathBuffer, PathError, PathJoint, PathOptions, steps_of_lanes};
use mapd_query::route::{Enter, RouteStep};
use mapd_tests::graph_maps::{Line, document, lane, road, section, wide};
use mapd_tests::maps::open_text;

/// Length of a change `[m]`.
const LENGTH: f64 = 6.0;
/// Chords along a change, and by how much S may be off within it `[m]`.
const CHORDS: u32 = 400;
const ALONG: f64 = 3e-4;
/// What places may be off `[m]`.
const TOLERANCE: f64 = 1e-6;

fn options(length: f64) -> PathOptions {
    PathOptions { change: LaneChange::Lateral(length), ..PathOptions::default() }
}

#[test]
fn a_curve_has_no_jump_and_is_projected_back() {
    let counts = std::cell::Cell::new([0, 0]);
    each_path_with(&options(LENGTH), |map, path, steps, name, random| {
        for joint in path.joints() {
            let changes = matches!(joint.enter, Enter::Left | Enter::Right);
            assert!(changes || !joint.short, "{name}: {joint:?}");
            if !changes {
                continue;
            }
            // Where lanes do not meet, there is a gap with a curve, too.
            assert!(joint.short || joint.broken || joint.gap < 0.1, "{name}: {joint:?}");
            let mut all = counts.get();
            all[usize::from(joint.short)] += 1;
            counts.set(all);
            // S is what is driven.
            let end = joint.along + 0.9 * LENGTH;
            let is_in = |other: &&PathJoint| other.along > joint.along && other.along <= end;
            if end < path.length() && path.joints().iter().find(is_in).is_none() {
                let place = |i: u32| {
                    let along =
                        joint.along + (end - joint.along) * f64::from(i) / f64::from(CHORDS);
                    path.at(along).expect("a place").position.truncate()
                };
                let driven: f64 = (0..CHORDS).map(|i| place(i).distance(place(i + 1))).sum();
                let off = (driven - (end - joint.along)).abs();
                assert!(off < ALONG, "{name}: {driven} m from {} to {end}", joint.along);
            }
            for _ in 0..8 {
                let along = joint.along + random.between(0.0, LENGTH);
                if along > path.length() || is_near_joint(path, along) {
                    continue;
                }
                let at = path.at(along).expect("a place");
                let found = path.project(at.position.truncate(), Some(along)).expect("a foot");
                assert!(found.distance < TOLERANCE, "{name}: {found:?} of {at:?}");
                let off = (found.along - along).abs();
                assert!(off < TOLERANCE, "{name}: {off} m of {at:?}, {found:?}");
                let turned = found.heading_difference(at.heading).abs();
                assert!(turned < 1e-6, "{name}: {turned}");
                // On one of the route's lanes.
                let on = steps.iter().any(|own| {
                    let lane = map.lane(own.lane).expect("a lane");
                    lane.position_of(at.position.truncate())
                        .is_ok_and(|position| position.distance < TOLERANCE)
                });
                assert!(on, "{name}: {at:?}");
            }
        }
    });
    let [curves, jumps] = counts.get();
    // The carried maps have one change of lane on these paths: without the others, which is said aloud, there is nothing to count.
    let has_others = mapd_tests::shared("maps").is_some();
    assert!(!has_others || curves > 20 && jumps > 0, "{curves} curves, {jumps} jumps");
}

/// Two lanes of 3.5 m: the line goes from one middle to the other over the length, and not beyond the last place for the change.
#[test]
fn from_one_middle_to_the_next() {
    let free = "<roadMark sOffset=\"0\" type=\"broken\" laneChange=\"both\"/>";
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let lanes = wide(-1, "", "", width, free) + &lane(-2, "");
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let text = document(&road("1", "junction=\"-1\"", line, "", &section(0.0, "", &lanes)));
    let snapshot = open_text(&text);
    let map = snapshot.map();
    let id = |key: &str| map.lane_by_key(&key.parse().expect("a key")).expect("a lane").lane_id();
    let step = |key: &str, enter, [s_from, s_to]: [f64; 2], s_latest| RouteStep {
        lane: id(key),
        forward: true,
        enter,
        s_from,
        s_to,
        s_latest,
    };
    let steps = [
        step("1:0:-1", Enter::Start, [10.0, 20.0], 10.0),
        step("1:0:-2", Enter::Right, [20.0, 90.0], 60.0),
    ];
    let mut buffer = PathBuffer::default();
    let path = map.path(&steps, &options(30.0), &mut buffer).expect("a path");
    let y = |x: f64| {
        let found = path.project(mapd_client::glam::DVec2::new(x, -3.5), None).expect("a foot");
        let at = path.at(found.along).expect("a place");
        (at.position.y, at.left + at.right)
    };
    // 1 − 10u³ + 15u⁴ − 6u⁵ is one half in the middle.
    for (x, expected) in [(20.0, -1.75), (35.0, -3.5), (50.0, -5.25), (80.0, -5.25)] {
        let (y, width) = y(x);
        assert!((y - expected).abs() < 0.02, "{x}: {y}");
        assert!((width - 3.5).abs() < 1e-9, "{width}");
    }
    let start = path.at(10.0).expect("its beginning");
    assert!((start.left + 1.75).abs() < 1e-9 && start.curvature.abs() < 1e-2, "{start:?}");
    assert_eq!(path.joints().len(), 1, "{:?}", path.joints());
    assert!(!path.joints()[0].short && path.joints()[0].gap < TOLERANCE);
    assert!(path.length() > 80.0 && path.length() < 80.5, "{}", path.length());
    let path = map.path(&steps, &options(50.0), &mut buffer).expect("a path");
    assert!(path.joints()[0].short && (path.joints()[0].gap - 3.5).abs() < TOLERANCE);
    assert_eq!(path.length(), 80.0);
}

#[test]
fn options_out_of_their_domain_are_refused_by_name() {
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let snapshot = open_text(&document(&road("1", "", line, "", &section(0.0, "", &lane(-1, "")))));
    let map = snapshot.map();
    let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
    let id = map.lanes().find(|lane| lane.number() == -1).expect("a lane").lane_id();
    steps_of_lanes(map, &[id], [0.0, 100.0], &mut steps).expect("steps");
    let mut built = |options: PathOptions| map.path(&steps, &options, &mut buffer).err();
    let normal = PathOptions::default();
    let never = PathOptions { broken_gap: f64::INFINITY, broken_kink: f64::INFINITY, ..normal };
    assert_eq!((built(normal), built(never)), (None, None));
    for bad in [f64::NAN, -1.0] {
        let refused = |name| Some(PathError::Option(name));
        assert_eq!(built(PathOptions { broken_gap: bad, ..normal }), refused("broken_gap"));
        assert_eq!(built(PathOptions { broken_kink: bad, ..normal }), refused("broken_kink"));
        assert_eq!(built(options(bad)), refused("change"));
    }
    assert_eq!(built(options(f64::INFINITY)), Some(PathError::Option("change")));
}

/// The lane that is left narrows from a place within the change on, where the other lane goes on as before.
#[test]
fn the_lane_that_is_left_may_change_its_width_on_the_way() {
    let free = "<roadMark sOffset=\"0\" type=\"broken\" laneChange=\"both\"/>";
    let taper = "<width sOffset=\"50\" a=\"3.5\" b=\"-0.05\" c=\"0\" d=\"0\"/>";
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let lanes = wide(-1, "", "", width, free) + &wide(-2, "", "", width, &format!("{taper}{free}"));
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let text = document(&road("1", "junction=\"-1\"", line, "", &section(0.0, "", &lanes)));
    let snapshot = open_text(&text);
    let map = snapshot.map();
    let id = |key: &str| map.lane_by_key(&key.parse().expect("a key")).expect("a lane").lane_id();
    let step = |key: &str, enter, [s_from, s_to]: [f64; 2], s_latest| RouteStep {
        lane: id(key),
        forward: true,
        enter,
        s_from,
        s_to,
        s_latest,
    };
    let steps = [
        step("1:0:-2", Enter::Start, [0.0, 10.0], 0.0),
        step("1:0:-1", Enter::Left, [10.0, 95.0], 90.0),
    ];
    let mut buffer = PathBuffer::default();
    let path = map.path(&steps, &options(80.0), &mut buffer).expect("a path");
    let gaps = path.joints().iter().map(|joint| joint.gap).fold(0.0, f64::max);
    assert!(gaps < TOLERANCE, "{:?}", path.joints());
    for along in (0..95).map(f64::from) {
        let at = path.at(along).expect("a place");
        let u = mapd_geometry::clamp((at.s - 10.0) / 80.0, 0.0, 1.0);
        let share = 1.0 - u * u * u * (10.0 - u * (15.0 - 6.0 * u));
        let width = 3.5 - 0.05 * (at.s - 50.0).max(0.0);
        let expected = -1.75 - share * 0.5 * (3.5 + width);
        assert!((at.position.y - expected).abs() < TOLERANCE, "{expected}: {at:?}");
        let found = path.project(at.position.truncate(), Some(along)).expect("a foot");
        assert!((found.along - along).abs() < 1e-3 && found.distance < TOLERANCE, "{found:?}");
    }
}
