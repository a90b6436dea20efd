//! Vehicles with an outline: their shares against the average of poses all over the outline, and against areas worked out by hand.

use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::localisation::{
    LaneMatch, MatchError, MatchOptions, Tracked, Tracker, TrackerFix, TrackerOptions,
    VehicleOutline, VehiclePose,
};
use mapd_client::{LaneId, LaneTypes, Map};
use mapd_tests::graph_maps::{Line, document, lane, road, section};
use mapd_tests::maps::{self, Random};
use mapd_tests::{carried, crossroads};
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

/// By how much a share may be off.
const ERROR: f64 = 1e-4;
/// Places and weights of Gauss and Legendre's rule on [−1, 1].
const RULE: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];
const CAR: VehicleOutline = VehicleOutline { front: 3.6, back: 1.0, left: 0.9, right: 0.9 };

fn pose(xy: DVec2, heading: f64) -> VehiclePose {
    VehiclePose { position: xy.into(), heading }
}

fn diagonal(deviations: [f64; 3]) -> DMat3 {
    let deviations = DVec3::from_array(deviations);
    DMat3::from_diagonal(deviations * deviations)
}

/// Places of the rule along a side in parts no longer than `part`, with shares that add up to 1.
fn along(from: f64, to: f64, part: f64) -> Vec<(f64, f64)> {
    let parts = ((to - from) / part).ceil().max(1.0) as usize;
    let half = 0.5 * (to - from) / parts as f64;
    let middles = (0..parts).map(|i| from + half * (2 * i + 1) as f64);
    let each = middles.flat_map(|middle| RULE.map(|(x, w)| (middle + half * x, w)));
    each.map(|(x, weight)| (x, 0.5 * weight / parts as f64)).collect()
}

type Shares = BTreeMap<(LaneId, bool), f64>;

/// The shares of an outline as an average over poses all over it, each a point: `none` has the same weight in all of them.
fn averaged(
    map: Map<'_>,
    at: &VehiclePose,
    spread: &DMat3,
    options: &MatchOptions<'_>,
    outline: &VehicleOutline,
    part: f64,
) -> (Shares, f64) {
    let mut weights = Shares::new();
    let mut out = Vec::new();
    for (ahead, share) in along(-outline.back, outline.front, part) {
        for (aside, other) in along(-outline.right, outline.left, part) {
            let there = DVec2::from_angle(at.heading).rotate(DVec2::new(ahead, aside));
            let moved = pose(at.position.xy + there, at.heading);
            let none = map.match_pose(&moved, spread, options, &mut out).expect("an answer");
            for one in &out {
                let weight = weights.entry((one.lane, one.forward)).or_default();
                *weight += share * other * one.probability / none;
            }
        }
    }
    let all = 1.0 + weights.values().sum::<f64>();
    (weights.into_iter().map(|(key, weight)| (key, weight / all)).collect(), 1.0 / all)
}

/// Poses around lanes, with covariances of every shape, against the average.
fn check_averaged(map: Map<'_>, seed: u64, poses: usize, outline: VehicleOutline) {
    let mut random = Random(seed);
    let plain = MatchOptions { drive_deviation: 0.15, ..MatchOptions::default() };
    let options = MatchOptions { outline: Some(outline), ..plain };
    let (mut out, mut asked) = (Vec::<LaneMatch>::new(), 0);
    while asked < poses {
        let point = random.point(map);
        let near = map.nearest_lane(point, &Default::default()).expect("an answer");
        let Some(near) = near.filter(|near| near.position.distance < 3.0) else { continue };
        asked += 1;
        let deviations = [[0.3, 0.3, 0.05], [1.5, 0.4, 0.2], [0.5, 0.5, 1.4], [0.4, 2.0, 1e3]];
        let [x, y, turn] = deviations[asked % deviations.len()];
        let (a, b) = (random.between(-0.6, 0.6), random.between(-0.6, 0.6));
        let mixed = DMat3::from_cols(DVec3::X, DVec3::new(a, 1.0, 0.0), DVec3::new(b, -a, 1.0));
        let root = DMat3::from_diagonal(DVec3::new(x, y, turn)) * mixed;
        let spread = root * root.transpose();
        let spread = (spread + spread.transpose()) * 0.5;
        let heading = near.position.heading + random.between(-0.5, 0.5) * (1.0 + turn.min(2.0));
        let at = pose(point, heading);
        let none = map.match_pose(&at, &spread, &options, &mut out).expect("an answer");
        // Parts of the average are no longer than the smaller deviation.
        let part = x.min(y).max(0.3);
        let (expected, none_expected) = averaged(map, &at, &spread, &plain, &outline, part);
        let close = |what: &str, got: f64, wanted: f64| {
            assert!(
                (got - wanted).abs() <= ERROR,
                "{what} at {at:?} {spread}: {got}, averaged {wanted}"
            );
        };
        close("none", none, none_expected);
        for one in &out {
            let wanted = expected.get(&(one.lane, one.forward)).copied().unwrap_or(0.0);
            close(&map.lane(one.lane).expect("a lane").key().to_string(), one.probability, wanted);
        }
        for (key, wanted) in &expected {
            let got = out.iter().find(|one| (one.lane, one.forward) == *key);
            close("a lane", got.map_or(0.0, |one| one.probability), *wanted);
        }
        assert!(out.windows(2).all(|two| two[0].probability >= two[1].probability));
    }
}

#[test]
fn shares_are_the_average_over_the_outline() {
    let truck = VehicleOutline { front: 1.4, back: 6.0, left: 1.25, right: 1.25 };
    let corner = VehicleOutline { front: 0.2, back: 3.0, left: 1.6, right: 0.1 };
    let town = maps::open(&carried("town.xodr"));
    check_averaged(town.map(), 3, 12, CAR);
    check_averaged(town.map(), 4, 6, truck);
    let bends = maps::open(&carried("one_road.xodr"));
    check_averaged(bends.map(), 5, 12, corner);
    check_averaged(bends.map(), 6, 6, truck);
    let crossing = maps::open_text(&crossroads::furnished());
    check_averaged(crossing.map(), 7, 8, CAR);
}

/// Shares of lanes by number, of a pose on `one_road.xodr`, whose first 60 m run along x: lane −1 from y = −3.5 m to 0, lane 1 to 3.5 m. Nothing is
/// known of the heading as a measurement, so that both ways count alike.
fn on_one_road(xy: [f64; 2], heading: f64, outline: VehicleOutline) -> BTreeMap<i32, f64> {
    let snapshot = maps::open(&carried("one_road.xodr"));
    let options = MatchOptions {
        types: LaneTypes::routable(),
        outline: Some(outline),
        none: 1e-9,
        ..MatchOptions::default()
    };
    let at = pose(DVec2::from_array(xy), heading);
    let mut out = Vec::new();
    let spread = diagonal([0.0, 0.0, 1e3]);
    snapshot.map().match_pose(&at, &spread, &options, &mut out).expect("an answer");
    let number = |one: &LaneMatch| snapshot.map().lane(one.lane).expect("a lane").number();
    out.iter().map(|one| (number(one), one.probability)).collect()
}

fn check_shares(xy: [f64; 2], heading: f64, outline: VehicleOutline, expected: &[(i32, f64)]) {
    let found = on_one_road(xy, heading, outline);
    for (number, share) in expected {
        let got = found.get(number).copied().unwrap_or(0.0);
        assert!((got - share).abs() <= ERROR, "{xy:?} {heading}: lane {number} {got}, not {share}");
    }
}

#[test]
fn a_vehicle_known_exactly_is_in_lanes_by_its_area() {
    let front = VehicleOutline { front: 3.0, back: 1.0, left: 0.9, right: 0.9 };
    check_shares([30.0, 0.0], 0.0, front, &[(-1, 0.5), (1, 0.5)]);
    check_shares([30.0, 0.45], 0.0, front, &[(-1, 0.25), (1, 0.75)]);
    check_shares([30.0, 0.45], TAU / 2.0, front, &[(-1, 0.25), (1, 0.75)]);
    check_shares([30.0, 1.75], 0.0, front, &[(-1, 0.0), (1, 1.0)]);
    // Not in the middle of its reference point.
    let aside = VehicleOutline { left: 1.5, right: 0.3, ..front };
    check_shares([30.0, 0.0], 0.0, aside, &[(-1, 1.0 / 6.0), (1, 5.0 / 6.0)]);
    // Across: three metres in front of the line, one behind it.
    check_shares([30.0, 0.0], FRAC_PI_2, front, &[(-1, 0.25), (1, 0.75)]);
    check_shares([30.0, 0.0], -FRAC_PI_2, front, &[(-1, 0.75), (1, 0.25)]);
    // A square on its corner: of its half diagonals of √2 m, the lower is cut off where the lane's border is 0.7 m below the middle.
    let square = VehicleOutline { front: 1.0, back: 1.0, left: 1.0, right: 1.0 };
    let cut = 2f64.sqrt() - 0.7;
    check_shares(
        [30.0, 0.7],
        FRAC_PI_4,
        square,
        &[(-1, cut * cut / 4.0), (1, 1.0 - cut * cut / 4.0)],
    );
    // Without a width it is a line.
    let line = VehicleOutline { left: 0.0, right: 0.0, ..front };
    check_shares([30.0, 0.0], FRAC_PI_2, line, &[(-1, 0.25), (1, 0.75)]);
}

/// Sections of three metres below a vehicle of twelve: a quarter is in each.
#[test]
fn a_vehicle_longer_than_its_lanes_is_in_all_of_them() {
    let link = |id: i32, number: u16| {
        let before = if number > 0 { format!("p{id} ") } else { String::new() };
        let next = if number < 9 { format!("s{id} ") } else { String::new() };
        before + &next
    };
    let each = |number: u16| section(f64::from(number) * 3.0, "", &lane(-1, &link(-1, number)));
    let sections: String = (0..10).map(each).collect();
    let line = Line(0.0, 0.0, 0.0, 30.0, 0.0);
    let snapshot = maps::open_text(&document(&road("a", "", line, "", &sections)));
    let map = snapshot.map();
    let outline = VehicleOutline { front: 9.0, back: 3.0, left: 1.0, right: 1.0 };
    let options = MatchOptions { outline: Some(outline), none: 1e-9, ..MatchOptions::default() };
    let mut out = Vec::new();
    let at = pose(DVec2::new(12.0, -1.75), 0.0);
    map.match_pose(&at, &diagonal([0.0, 0.0, 0.05]), &options, &mut out).expect("an answer");
    let whole: Vec<f64> =
        out.iter().map(|one| one.probability).filter(|share| *share > 1e-3).collect();
    assert_eq!(whole.len(), 4, "{whole:?}");
    assert!(whole.iter().all(|share| (share - 0.25).abs() <= ERROR), "{whole:?}");
}

/// An outline without any size is none, bit for bit.
#[test]
fn no_size_is_no_outline() {
    let snapshot = maps::open(&carried("town.xodr"));
    let (map, mut random) = (snapshot.map(), Random(12));
    let nothing = VehicleOutline { front: 0.0, back: 0.0, left: 0.0, right: 0.0 };
    let plain = MatchOptions::default();
    let sized = MatchOptions { outline: Some(nothing), ..plain };
    let (mut a, mut b) = (Vec::new(), Vec::new());
    for _ in 0..200 {
        let at = pose(random.point(map), random.between(-3.0, 3.0));
        let spread = diagonal([0.5, 0.8, 0.2]);
        let one = map.match_pose(&at, &spread, &plain, &mut a).expect("an answer");
        let other = map.match_pose(&at, &spread, &sized, &mut b).expect("an answer");
        assert_eq!((one.to_bits(), &a), (other.to_bits(), &b));
    }
}

#[test]
fn sizes_that_are_wrong_are_named() {
    let snapshot = maps::open(&carried("one_road.xodr"));
    let check = |outline: VehicleOutline, name| {
        let options = MatchOptions { outline: Some(outline), ..MatchOptions::default() };
        let at = pose(DVec2::new(30.0, -1.0), 0.0);
        let mut out = Vec::new();
        let spread = diagonal([0.3, 0.3, 0.05]);
        let got = snapshot.map().match_pose(&at, &spread, &options, &mut out);
        assert_eq!(got, Err(MatchError::Option(name)));
    };
    check(VehicleOutline { front: -0.1, ..CAR }, "outline.front");
    check(VehicleOutline { back: f64::NAN, ..CAR }, "outline.back");
    check(VehicleOutline { left: f64::INFINITY, ..CAR }, "outline.left");
    check(VehicleOutline { right: 101.0, ..CAR }, "outline.right");
}

/// A vehicle that keeps half beyond the line is in neither lane for sure; without an outline it would be in that of its reference point.
#[test]
fn a_tracked_vehicle_that_straddles_is_in_two_lanes() {
    let sections = section(0.0, "", &(lane(-1, "") + &lane(-2, "")));
    let line = Line(0.0, 0.0, 0.0, 300.0, 0.0);
    let snapshot = maps::open_text(&document(&road("a", "", line, "", &sections)));
    let shares = |outline: Option<VehicleOutline>| {
        let matching = MatchOptions { outline, ..TrackerOptions::default().matching };
        let options = TrackerOptions { matching, ..TrackerOptions::default() };
        let (mut tracker, mut found) = (Tracker::new(), Tracked::Unknown);
        for i in 0..3u8 {
            let fix = TrackerFix {
                time: f64::from(i),
                pose: pose(DVec2::new(20.0 + 10.0 * f64::from(i), -3.4), 0.0),
                covariance: diagonal([0.02, 0.02, 0.02]),
                odometer: None,
            };
            found = tracker.update(snapshot.map(), &fix, &options).expect("an answer");
        }
        let of = |row: usize| tracker.hypotheses().get(row).map_or(0.0, |one| one.probability);
        (of(0), of(1), found)
    };
    let (first, second, found) = shares(None);
    assert!(first > 0.99 && second < 0.01, "{first} {second} {found:?}");
    let (first, second, found) = shares(Some(CAR));
    assert!(second > 0.2 && first < 0.8, "{first} {second} {found:?}");
}

/// A pose of whose heading nothing is known, and whose place is known within `thin` in one direction, within `long` in another `[m]`.
struct Thin {
    at: VehiclePose,
    long: f64,
    thin: f64,
    /// Where it is known least `[rad]`.
    direction: f64,
}

impl Thin {
    fn spread(&self) -> DMat3 {
        let root = DMat3::from_rotation_z(self.direction)
            * DMat3::from_diagonal(DVec3::new(self.long, self.thin, 0.0));
        let spread = root * root.transpose();
        (spread + spread.transpose()) * 0.5 + diagonal([0.0, 0.0, 1e3])
    }

    /// Shares, and that of `none`.
    fn shares(&self, map: Map<'_>, outline: VehicleOutline) -> (Shares, f64) {
        let options = MatchOptions { outline: Some(outline), ..MatchOptions::default() };
        let mut out = Vec::new();
        let none = map.match_pose(&self.at, &self.spread(), &options, &mut out);
        let shares = out.iter().map(|one| ((one.lane, one.forward), one.probability));
        (shares.collect(), none.expect("an answer"))
    }

    /// The same as an average over poses along the direction, each known as well in every direction: the trapezoidal rule, exact for a density.
    fn averaged(&self, map: Map<'_>, outline: VehicleOutline) -> (Shares, f64) {
        let along = (self.long * self.long - self.thin * self.thin).sqrt();
        let step = 1.1 * self.thin / along;
        let count = (4.8 / step).ceil() as i32;
        let mut weights = Shares::new();
        for i in -count..=count {
            let z = f64::from(i) * step;
            let moved = self.at.position.xy + DVec2::from_angle(self.direction) * (along * z);
            let one = Self { at: pose(moved, self.at.heading), long: self.thin, ..*self };
            let (shares, none) = one.shares(map, outline);
            let share = step * (-0.5 * z * z).exp() / TAU.sqrt();
            for (key, found) in shares {
                *weights.entry(key).or_default() += share * found / none;
            }
        }
        let all = 1.0 + weights.values().sum::<f64>();
        (weights.into_iter().map(|(key, weight)| (key, weight / all)).collect(), 1.0 / all)
    }

    fn check(&self, map: Map<'_>, outline: VehicleOutline, expected: &(Shares, f64)) {
        let (got, none) = self.shares(map, outline);
        let Self { at, long, thin, direction } = self;
        let close = |got: f64, wanted: f64| {
            assert!(
                (got - wanted).abs() <= ERROR,
                "{at:?} {long} {thin} {direction}: {got}, not {wanted}"
            );
        };
        close(none, expected.1);
        for key in got.keys().chain(expected.0.keys()) {
            let [one, other] = [&got, &expected.0].map(|of| of.get(key).copied().unwrap_or(0.0));
            close(one, other);
        }
    }
}

/// A pose known a hundred times better along the lane than across it had no share in the lane: no place of the rule met the density. The road is
/// straight there: shares are the same wherever the pose is.
#[test]
fn a_pose_known_well_only_along_the_lane_is_in_it() {
    let snapshot = maps::open(&carried("one_road.xodr"));
    let motorcycle = VehicleOutline { front: 1.1, back: 1.1, left: 0.4, right: 0.4 };
    let square = VehicleOutline { front: 1.0, back: 1.0, left: 1.0, right: 1.0 };
    for (outline, long, thin) in
        [(CAR, 5.0, 0.05), (CAR, 3.0, 0.05), (motorcycle, 2.0, 0.02), (square, 5.0, 0.02)]
    {
        let at = |x: f64| pose(DVec2::new(x, 5.0), FRAC_PI_2);
        let one = |x: f64| Thin { at: at(x), long, thin, direction: FRAC_PI_2 };
        let expected = one(30.0).averaged(snapshot.map(), outline);
        assert!(expected.1 < 0.1, "none {}", expected.1);
        for i in 0..200u8 {
            one(10.0 + 0.167 * f64::from(i)).check(snapshot.map(), outline, &expected);
        }
    }
}

/// Deviations up to 250 times as large in one direction as in the other, at any angle to straight and bent lanes.
fn check_known_in_one_direction(name: &str, seed: u64) {
    let snapshot = maps::open(&carried(name));
    let (map, mut random) = (snapshot.map(), Random(seed));
    for ratio in [10.0, 30.0, 60.0, 120.0, 250.0] {
        let near = loop {
            let point = random.point(map);
            let near = map.nearest_lane(point, &Default::default()).expect("an answer");
            if let Some(near) = near.filter(|near| near.position.distance < 4.0) {
                break (point, near.position.heading);
            }
        };
        let long = random.between(1.0, 4.0);
        let heading = near.1 + random.between(-3.0, 3.0);
        let direction = random.between(-3.0, 3.0);
        let one = Thin { at: pose(near.0, heading), long, thin: long / ratio, direction };
        one.check(map, CAR, &one.averaged(map, CAR));
    }
}

#[test]
fn shares_are_the_average_for_places_known_in_one_direction_on_a_road() {
    check_known_in_one_direction("one_road.xodr", 21);
}

#[test]
fn shares_are_the_average_for_places_known_in_one_direction_in_a_town() {
    check_known_in_one_direction("town.xodr", 22);
}
