//! Which lanes a pose may be in: against Monte Carlo integration of the same model, calibrated on poses drawn from it, and
//! refused by name where pose, covariance or options are wrong.

use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::localisation::{LaneMatch, MatchError, MatchOptions, VehicleOutline, VehiclePose};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{LaneId, LaneTypes, Map, Nearest, NearestOptions, Point};
use mapd_tests::maps::{self, Random};
use mapd_tests::{carried, crossroads};
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// What the model adds to a pose: the map's own deviations.
const MAP: DVec3 = DVec3::new(1e-6, 1e-6, 1e-8);

/// Normally distributed (Box and Muller).
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
    radius * (TAU * random.unit()).cos()
}

fn wrapped(angle: f64) -> f64 {
    let angle = angle.rem_euclid(TAU);
    if angle > PI { angle - TAU } else { angle }
}

fn pose(xy: DVec2, heading: f64) -> VehiclePose {
    VehiclePose { position: Point { xy, z: None }, heading }
}

fn diagonal(deviations: [f64; 3]) -> DMat3 {
    let deviations = DVec3::from_array(deviations);
    DMat3::from_diagonal(deviations * deviations)
}

/// A root L of a positive definite matrix: L·Lᵀ.
fn root(m: DMat3) -> DMat3 {
    let at = |row: usize, column: usize| m.col(column)[row];
    let a = at(0, 0).sqrt();
    let (b, c) = (at(1, 0) / a, at(2, 0) / a);
    let d = (at(1, 1) - b * b).sqrt();
    let e = (at(2, 1) - c * b) / d;
    let f = (at(2, 2) - c * c - e * e).sqrt();
    DMat3::from_cols(DVec3::new(a, b, c), DVec3::new(0.0, d, e), DVec3::new(0.0, 0.0, f))
}

/// A covariance of any shape: these deviations, turned and correlated.
fn covariance(random: &mut Random, deviations: [f64; 3]) -> DMat3 {
    let mut mixed = DMat3::IDENTITY;
    for column in 0..3 {
        *mixed.col_mut(column) +=
            0.6 * DVec3::from_array([(); 3].map(|()| random.between(-1.0, 1.0)));
    }
    let root = DMat3::from_diagonal(DVec3::from_array(deviations)) * mixed;
    let m = root * root.transpose();
    // Exactly symmetric.
    (m + m.transpose()) * 0.5
}

/// Lanes that hold a point.
fn holders(map: Map<'_>, point: DVec2, out: &mut Vec<Nearest>) {
    let options = NearestOptions { radius: 0.0, ..NearestOptions::default() };
    map.lanes_near(point, &options, out).expect("an answer");
}

/// Directions of the reference line as a lane is driven where it holds a point: towards +s or not, and the heading.
fn directions(map: Map<'_>, found: &Nearest) -> Vec<(bool, f64)> {
    let lane = map.lane(found.lane).expect("a lane");
    let line = found.position.heading_of_reference_line;
    let heading = if lane.is_forward() { line } else { line + PI };
    let mut all = vec![(lane.is_forward(), heading)];
    if lane.is_bidirectional() {
        all.push((!lane.is_forward(), heading + PI));
    }
    all
}

/// A place on a vehicle, ahead and to the left of its pose's.
fn place_on(outline: &VehicleOutline, random: &mut Random) -> DVec2 {
    let VehicleOutline { front, back, left, right } = *outline;
    DVec2::new(random.between(-back, front), random.between(-right, left))
}

/// Probabilities by drawing places from the pose's density and asking which lanes hold them; with their standard errors.
fn drawn(
    map: Map<'_>,
    pose: &VehiclePose,
    spread: DMat3,
    options: &MatchOptions<'_>,
    (random, draws): (&mut Random, usize),
) -> (BTreeMap<(LaneId, bool), [f64; 2]>, f64) {
    let spread = spread + DMat3::from_diagonal(MAP);
    let at = |row: usize, column: usize| spread.col(column)[row];
    // Of the heading, given the place.
    let det = at(0, 0) * at(1, 1) - at(0, 1) * at(0, 1);
    let gain = DVec2::new(
        (at(0, 2) * at(1, 1) - at(1, 2) * at(0, 1)) / det,
        (at(1, 2) * at(0, 0) - at(0, 2) * at(0, 1)) / det,
    );
    let rest =
        at(2, 2) - gain.dot(DVec2::new(at(0, 2), at(1, 2))) + options.drive_deviation.powi(2);
    let root = root(spread);
    let mut sums: BTreeMap<(LaneId, bool), [f64; 2]> = BTreeMap::new();
    let mut found = Vec::new();
    for _ in 0..draws {
        let away = root * DVec3::new(normal(random), normal(random), 0.0);
        let away = away.truncate();
        let on_it = options.outline.map_or(DVec2::ZERO, |outline| place_on(&outline, random));
        let there = away + DVec2::from_angle(pose.heading).rotate(on_it);
        holders(map, pose.position.xy + there, &mut found);
        for one in &found {
            for (forward, heading) in directions(map, one) {
                let turn = wrapped(heading - pose.heading - gain.dot(away));
                let density: f64 = (-3..=3)
                    .map(|k| turn + TAU * f64::from(k))
                    .map(|turn| (-0.5 * turn * turn / rest).exp() / (TAU * rest).sqrt())
                    .sum();
                let sum = sums.entry((one.lane, forward)).or_default();
                *sum = [sum[0] + density, sum[1] + density * density];
            }
        }
    }
    let n = draws as f64;
    let weights: BTreeMap<_, [f64; 2]> = sums
        .into_iter()
        .map(|(key, [sum, squares])| {
            let mean = sum / n;
            // Of what is met once in a while, a few draws more or less are no wonder.
            let few = 2.0 / ((TAU * rest).sqrt() * n);
            (key, [mean, ((squares / n - mean * mean).max(0.0) / n).sqrt() + few])
        })
        .collect();
    let none = options.none / TAU;
    let all = none + weights.values().map(|w| w[0]).sum::<f64>();
    let error = weights.values().map(|w| w[1]).sum::<f64>();
    let share = |w: [f64; 2]| [w[0] / all, (w[1] + error * w[0] / all) / all];
    (weights.into_iter().map(|(key, w)| (key, share(w))).collect(), none / all)
}

/// Poses around lanes of a map, each against Monte Carlo integration; the largest number of candidates with a per mille.
fn check_drawn(map: Map<'_>, seed: u64, poses: usize, outline: Option<VehicleOutline>) -> usize {
    let mut random = Random(seed);
    let (mut out, mut found, mut most) = (Vec::new(), Vec::new(), 0);
    let mut asked = 0;
    while asked < poses {
        let point = random.point(map);
        holders(map, point, &mut found);
        let Some(first) = found.first() else { continue };
        let deviations = [[0.3, 0.3, 0.05], [1.5, 0.5, 0.2], [4.0, 3.0, 0.6], [0.4, 2.0, 1.4]];
        let spread = covariance(&mut random, deviations[asked % deviations.len()]);
        asked += 1;
        let heading = first.position.heading + random.between(-0.3, 0.3);
        let beside = DVec2::new(random.between(-2.0, 2.0), random.between(-2.0, 2.0));
        let pose = pose(point + beside, heading);
        let options = MatchOptions { drive_deviation: 0.15, outline, ..MatchOptions::default() };
        let none = map.match_pose(&pose, &spread, &options, &mut out).expect("an answer");
        let (expected, none_expected) = drawn(map, &pose, spread, &options, (&mut random, 6000));
        let close = |what: &str, got: f64, [mean, error]: [f64; 2]| {
            let bound = 5.0 * error + 1e-3;
            assert!(
                (got - mean).abs() <= bound,
                "{what} at {pose:?} {spread}: {got}, drawn {mean} ± {error}"
            );
        };
        let error: f64 = expected.values().map(|e| e[1]).sum();
        close("none", none, [none_expected, error]);
        for one in &out {
            let key = map.lane(one.lane).expect("a lane").key().to_string();
            // What no draw met is judged by the errors of all.
            let drawn = expected.get(&(one.lane, one.forward)).copied();
            close(&key, one.probability, drawn.unwrap_or([0.0, error]));
        }
        for (key, drawn) in &expected {
            let got = out.iter().find(|one| (one.lane, one.forward) == *key);
            close("a lane", got.map_or(0.0, |one| one.probability), *drawn);
        }
        let sum = none + out.iter().map(|one| one.probability).sum::<f64>();
        assert!((sum - 1.0).abs() < 1e-6, "the sum is {sum}");
        assert!(out.windows(2).all(|two| two[0].probability >= two[1].probability));
        most = most.max(out.iter().filter(|one| one.probability > 1e-3).count());
    }
    most
}

#[test]
fn probabilities_are_those_of_monte_carlo_integration() {
    for (name, poses) in [("town.xodr", 40), ("one_road.xodr", 24)] {
        let snapshot = maps::open(&carried(name));
        let most = check_drawn(snapshot.map(), 5, poses, None);
        assert!(most >= 3, "{name}: never more than {most} lanes compete");
    }
    let snapshot = maps::open_text(&crossroads::furnished());
    assert!(check_drawn(snapshot.map(), 6, 24, None) >= 5);
}

#[test]
fn shares_of_an_outline_are_those_of_monte_carlo_integration() {
    let car = VehicleOutline { front: 3.6, back: 1.0, left: 0.9, right: 0.9 };
    let trailer = VehicleOutline { front: 0.0, back: 13.0, left: 1.2, right: 1.3 };
    for (name, outline, poses) in [("town.xodr", car, 20), ("one_road.xodr", trailer, 12)] {
        let snapshot = maps::open(&carried(name));
        let most = check_drawn(snapshot.map(), 8, poses, Some(outline));
        assert!(most >= 3, "{name}: never more than {most} lanes compete");
    }
    let snapshot = maps::open_text(&crossroads::furnished());
    assert!(check_drawn(snapshot.map(), 9, 12, Some(car)) >= 5);
}

/// Poses drawn from the model: of all candidates to which it gives a probability, that share must be where the vehicle is.
#[test]
fn probabilities_are_calibrated() {
    const BINS: usize = 10;
    let snapshot = maps::open(&carried("town.xodr"));
    let map = snapshot.map();
    let mut random = Random(17);
    // Nobody is on no lane here.
    let options = MatchOptions { none: 1e-9, ..MatchOptions::default() };
    let (mut found, mut out) = (Vec::new(), Vec::new());
    let mut bins = [[0.0f64; 3]; BINS];
    let mut poses = 0;
    while poses < 4000 {
        let point = random.point(map);
        holders(map, point, &mut found);
        // Each lane that holds a place is a truth of its own: lanes are drawn by their areas.
        for one in &found {
            for (forward, heading) in directions(map, one) {
                poses += 1;
                let deviations = [[0.3, 0.3, 0.05], [1.5, 1.5, 0.3]][poses % 2];
                let spread = diagonal(deviations);
                let noise = DVec3::from_array(deviations.map(|d| d * normal(&mut random)));
                let heading = heading + options.drive_deviation * normal(&mut random);
                let measured = pose(point + noise.truncate(), heading + noise.z);
                map.match_pose(&measured, &spread, &options, &mut out).expect("an answer");
                for candidate in &out {
                    let bin = ((candidate.probability * BINS as f64) as usize).min(BINS - 1);
                    let hit = (candidate.lane, candidate.forward) == (one.lane, forward);
                    let [n, said, was] = &mut bins[bin];
                    *n += 1.0;
                    *said += candidate.probability;
                    *was += f64::from(u8::from(hit));
                }
            }
        }
    }
    let mut judged = 0;
    for [n, said, was] in bins {
        if n < 400.0 {
            continue;
        }
        judged += 1;
        assert!((said - was).abs() / n <= 0.05, "said {}, was {} of {n}", said / n, was / n);
    }
    assert!(judged >= 6, "only {judged} bins have enough poses");
}

/// What is asked of one pose on the road of `one_road.xodr`, whose first 60 m run along x with two lanes of 3.5 m.
fn ask(
    xy: [f64; 2],
    heading: f64,
    spread: DMat3,
    options: &MatchOptions<'_>,
) -> (Vec<LaneMatch>, f64) {
    let snapshot = maps::open(&carried("one_road.xodr"));
    let mut out = Vec::new();
    let asked = snapshot.map().match_pose(
        &pose(DVec2::from_array(xy), heading),
        &spread,
        options,
        &mut out,
    );
    (out, asked.expect("an answer"))
}

fn lane_id(key: &str) -> LaneId {
    let snapshot = maps::open(&carried("one_road.xodr"));
    snapshot.map().lane_by_key(&key.parse().expect("a key")).expect("a lane").lane_id()
}

#[test]
fn a_pose_within_a_lane_is_in_it() {
    let (out, none) = ask([30.0, -1.0], 0.02, diagonal([0.3, 0.3, 0.05]), &MatchOptions::default());
    let best = out.first().expect("a lane");
    assert_eq!((best.lane, best.forward), (lane_id("1:0:-1"), true));
    assert!(best.probability > 0.99 && none < 1e-3);
    assert!((best.heading_difference - 0.02).abs() < 1e-12);
    assert!((best.position.s - 30.0).abs() < 1e-9 && (best.position.offset - 0.75).abs() < 1e-9);
    let variance = [0.09 + MAP.y, 0.0025 + 0.01 + MAP.z];
    let expected = (0.75f64.powi(2) / variance[0] + 0.02f64.powi(2) / variance[1]).sqrt();
    assert!((best.mahalanobis - expected).abs() < 1e-9);
}

#[test]
fn what_lies_beside_or_across_all_lanes_is_in_none() {
    let sure = diagonal([0.3, 0.3, 0.05]);
    for (xy, heading) in [([30.0, -1.0], FRAC_PI_2), ([30.0, 8.0], 0.0), ([1e4, 1e4], 0.0)] {
        let (out, none) = ask(xy, heading, sure, &MatchOptions::default());
        assert!(none > 0.95, "{xy:?}: {none} {out:?}");
    }
}

#[test]
fn exact_and_unknown_parts_have_an_answer() {
    let options = MatchOptions::default();
    let (out, _) = ask([30.0, -1.0], 0.0, DMat3::ZERO, &options);
    assert!(out[0].probability > 0.99);
    // Nothing known of the heading: it counts for nothing, and whole turns never do.
    let blind = |heading: f64| ask([30.0, 0.0], heading, diagonal([0.5, 0.5, 1e3]), &options);
    let (out, _) = blind(0.3);
    assert!((out[0].probability - out[1].probability).abs() < 1e-9);
    assert_eq!(
        out.iter().map(|one| one.probability).collect::<Vec<_>>(),
        blind(2.0).0.iter().map(|one| one.probability).collect::<Vec<_>>()
    );
    let turned =
        |turns: f64| ask([30.0, 0.3], 0.3 + TAU * turns, diagonal([0.5, 0.5, 0.2]), &options);
    assert!((turned(0.0).0[0].probability - turned(5.0).0[0].probability).abs() < 1e-9);
}

#[test]
fn priors_weigh_lanes() {
    let spread = diagonal([0.5, 0.5, 1e3]);
    let share = |options: &MatchOptions<'_>, key: &str| {
        let (out, _) = ask([30.0, 3.5], 0.0, spread, options);
        out.iter().filter(|one| one.lane == lane_id(key)).map(|one| one.probability).sum::<f64>()
    };
    let plain = MatchOptions::default();
    let (driving, shoulder) = (share(&plain, "1:0:1"), share(&plain, "1:0:2"));
    // 1.5 m of shoulder hold a little less than a half.
    assert!((driving / shoulder - 1.0).abs() < 0.01, "{driving} {shoulder}");
    let expected = [lane_id("1:0:2")];
    let route = MatchOptions { expected: &expected, unexpected: 0.2, ..plain };
    assert!(
        (share(&route, "1:0:1") / share(&route, "1:0:2") - 0.2 * driving / shoulder).abs() < 1e-9
    );
    let car = MatchOptions { vehicle: Some(VehicleClass::PassengerCar), closed: 0.1, ..plain };
    assert!(share(&car, "1:0:2") < 0.2 * share(&car, "1:0:1"));
    let drivable = MatchOptions { types: LaneTypes::routable(), ..plain };
    assert_eq!(share(&drivable, "1:0:2"), 0.0);
}

#[test]
fn levels_are_told_apart_by_z() {
    let snapshot = maps::open(&carried("one_road.xodr"));
    let options = MatchOptions { z_tolerance: Some(2.0), ..MatchOptions::default() };
    let mut out = Vec::new();
    for (z, near) in [(10.5, true), (13.0, false)] {
        let position = Point { xy: DVec2::new(30.0, -1.0), z: Some(z) };
        let pose = VehiclePose { position, heading: 0.0 };
        let none =
            snapshot.map().match_pose(&pose, &diagonal([0.3, 0.3, 0.05]), &options, &mut out);
        assert_eq!((none.expect("an answer") < 0.5, out.is_empty()), (near, !near));
    }
}

#[test]
fn what_is_wrong_is_named() {
    let snapshot = maps::open(&carried("one_road.xodr"));
    let good = diagonal([0.3, 0.3, 0.05]);
    let check = |xy: [f64; 2],
                 heading: f64,
                 entries: &[(usize, usize, f64)],
                 options: MatchOptions<'_>,
                 expected| {
        let mut spread = good;
        for (row, column, value) in entries {
            spread.col_mut(*column)[*row] = *value;
        }
        let mut out = Vec::new();
        let pose = pose(DVec2::from_array(xy), heading);
        let got = snapshot.map().match_pose(&pose, &spread, &options, &mut out);
        assert_eq!(got, Err(expected), "{entries:?}");
        assert!(out.is_empty());
    };
    let plain = MatchOptions::default();
    check([f64::NAN, 0.0], 0.0, &[], plain, MatchError::Pose("x"));
    check([0.0, f64::INFINITY], 0.0, &[], plain, MatchError::Pose("y"));
    check([0.0, 0.0], f64::NAN, &[], plain, MatchError::Pose("heading"));
    check([0.0; 2], 0.0, &[(0, 2, f64::NAN)], plain, MatchError::NotFinite(0, 2));
    check([0.0; 2], 0.0, &[(1, 1, -1.0)], plain, MatchError::Negative(1));
    check([0.0; 2], 0.0, &[(0, 1, 0.01)], plain, MatchError::Asymmetric(0, 1));
    check([0.0; 2], 0.0, &[(0, 2, 0.5), (2, 0, 0.5)], plain, MatchError::Indefinite(0, 2));
    let pair = |row, column, value| [(row, column, value), (column, row, value)];
    let all: Vec<_> = [pair(0, 1, 0.08), pair(0, 2, -0.0135), pair(1, 2, 0.0135)].concat();
    check([0.0; 2], 0.0, &all, plain, MatchError::Determinant);
    check([0.0; 2], 0.0, &[], MatchOptions { none: 0.0, ..plain }, MatchError::Option("none"));
    check([0.0; 2], 0.0, &[], MatchOptions { closed: 1.5, ..plain }, MatchError::Option("closed"));
    let wide = MatchOptions { drive_deviation: f64::NAN, ..plain };
    check([0.0; 2], 0.0, &[], wide, MatchError::Option("drive_deviation"));
}
