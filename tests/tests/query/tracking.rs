//! The running filter: its lanes on simulated drives against what no answer can beat, routes that are left, places off the map,
//! jumps, and what is refused.

use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::graph::LaneNode;
use mapd_client::localisation::{
    MatchError, MatchOptions, Tracked, Tracker, TrackerFix, TrackerOptions, VehiclePose,
};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{LaneId, Map, NearestOptions};
use mapd_tests::drives::{self, Truth};
use mapd_tests::graph_maps::{Line, document, lane, road, section};
use mapd_tests::maps::{self, Random};
use mapd_tests::{carried, say, shared};
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;

/// Standard deviations of places `[m]` and headings `[rad]`.
const NOISE: [f64; 2] = [0.3, 0.05];
/// Between places of a simulated drive `[s]`.
const STEP: f64 = 0.1;
/// A drive has left its route that long after they have separated, at the latest `[s]`.
const NOTICED: f64 = 2.0;

/// Share of wrong lanes of fixes each second, which no answer by a pose and the last lane can beat (Bayes), and which a tracker
/// must not exceed by more than a tenth. Lanes that begin on each other cause most of it.
#[test]
fn few_lanes_are_wrong() {
    // A map that the folder lacks is an error: it was left out in silence.
    let mut known = vec![(carried("town.xodr"), 0.054)];
    match shared("maps/carla") {
        Some(folder) => {
            known.extend(
                [("Town05.xodr", 0.054), ("Town03.xodr", 0.084)]
                    .map(|(name, bayes)| (folder.join(name), bayes)),
            );
        }
        None => say("SKIPPED in part: no shared corpus beside the workspace"),
    }
    known.extend(maps::found("maps/rdb6.xodr").map(|path| (path, 0.128)));
    for (path, bayes) in known {
        let snapshot = maps::open(&path);
        for (every, odometer) in [(1, true), (10, false)] {
            let [right, said] = drives::tracked(snapshot.map(), NOISE, every, odometer, 5);
            let (wrong, name) = (1.0 - right, path.display());
            assert!(wrong <= 1.1 * bayes, "{name}, every {every}: {wrong} wrong");
            assert!((said - right).abs() <= 0.05, "{name}, every {every}: {said} said, {right}");
        }
    }
}

/// Drivable nodes that follow a lane's end.
fn following<'a>(map: Map<'a>, lane: LaneId) -> Vec<LaneNode<'a>> {
    let lane = map.lane(lane).expect("a lane");
    let last = lane.nodes().filter(|node| node.is_forward() == lane.is_forward()).last();
    let next = last.into_iter().flat_map(|node| node.edges()).filter_map(|edge| edge.target());
    next.filter(|node| node.allows(VehicleClass::PassengerCar)).collect()
}

/// A route that a drive leaves at one of its forks: its lanes up to there, then another way.
fn left_route(map: Map<'_>, truth: &[Truth]) -> Option<Vec<LaneId>> {
    let mut lanes: Vec<LaneId> = truth.iter().map(|place| place.lane).collect();
    lanes.dedup();
    let of = |node: &LaneNode<'_>| node.lane().expect("a lane").lane_id();
    // Some way in, so that the tracker trusts the route.
    let fork = (3..lanes.len().checked_sub(1)?).find_map(|i| {
        let next = following(map, lanes[i]);
        let taken = next.iter().any(|node| of(node) == lanes[i + 1]);
        let other = next.iter().find(|node| of(node) != lanes[i + 1]).filter(|_| taken)?;
        Some((i, of(other)))
    });
    let (last, mut lane) = fork?;
    let mut route = lanes[..=last].to_vec();
    for _ in 0..8 {
        route.push(lane);
        let Some(next) = following(map, lane).first().map(of) else { break };
        lane = next;
    }
    (!route.contains(&lanes[last + 1])).then_some(route)
}

/// Whether any of these lanes holds a place.
fn holds(map: Map<'_>, lanes: &[LaneId], place: DVec2) -> bool {
    let (options, mut found) =
        (NearestOptions { radius: 0.0, ..NearestOptions::default() }, Vec::new());
    map.lanes_near(place, &options, &mut found).expect("an answer");
    found.iter().any(|found| lanes.contains(&found.lane))
}

#[test]
fn leaving_the_route_is_noticed() {
    check_left_routes(&carried("town.xodr"), 40, 15);
    if let Some(folder) = shared("maps") {
        check_left_routes(&folder.join("carla/Town05.xodr"), 20, 4);
    }
}

/// Drives that leave their routes, of which there are at least so many; each route is the prior.
fn check_left_routes(path: &Path, drives: u64, least: usize) {
    let snapshot = maps::open(path);
    let (map, mut tracker) = (snapshot.map(), Tracker::new());
    let (mut left, mut kept, mut trusted) = (0, 0.0, 0.0);
    for seed in 1..=drives {
        let random = &mut Random(seed * 104_729);
        let truth = drives::drive(map, 60.0, random);
        let fixes = drives::localise(&truth, 1, NOISE, true, random);
        let Some(route) = left_route(map, &truth) else { continue };
        let matching = MatchOptions { expected: &route, ..TrackerOptions::default().matching };
        let options = TrackerOptions { matching, ..TrackerOptions::default() };
        tracker.reset();
        let mut separated = None;
        let mut noticed = None;
        for (i, (fix, place)) in fixes.iter().zip(&truth).enumerate() {
            tracker.update(map, fix, &options).expect("an answer");
            let on_route = tracker.probability_in(&route) >= 0.5;
            if separated.is_none() && holds(map, &route, place.position) {
                (kept, trusted) = (kept + 1.0, trusted + f64::from(u8::from(on_route)));
                continue;
            }
            separated.get_or_insert(i);
            if !on_route {
                noticed = Some(i);
                break;
            }
        }
        let Some(separated) = separated.filter(|i| i + 20 < truth.len()) else { continue };
        left += 1;
        let late = noticed.map_or(f64::INFINITY, |i| (i - separated) as f64 * STEP);
        assert!(late <= NOTICED, "drive {seed}: noticed after {late} s");
    }
    assert!(left >= least, "only {left} drives leave their route");
    // Before they separate the vehicle is on its route, and that is what is said, but near forks.
    assert!(trusted / kept > 0.9, "trusted {} of the fixes on a route", trusted / kept);
}

fn fix(time: f64, xy: [f64; 2], heading: f64) -> TrackerFix {
    let deviations = DVec3::new(0.3, 0.3, 0.05);
    TrackerFix {
        time,
        pose: VehiclePose { position: DVec2::from_array(xy).into(), heading },
        covariance: DMat3::from_diagonal(deviations * deviations),
        odometer: None,
    }
}

/// Answers on `one_road.xodr`, whose first 60 m run along x with two lanes of 3.5 m: the lane's number, 0 for none, `None` where nobody knows.
fn on_one_road(fixes: &[TrackerFix], options: &TrackerOptions<'_>) -> Vec<Option<i32>> {
    let snapshot = maps::open(&carried("one_road.xodr"));
    let (map, mut tracker) = (snapshot.map(), Tracker::new());
    let ask = |fix: &TrackerFix| {
        let found = tracker.update(map, fix, options).expect("an answer");
        let sum = tracker.none() + tracker.hypotheses().iter().map(|h| h.probability).sum::<f64>();
        assert!((sum - 1.0).abs() < 1e-9, "the sum is {sum}");
        match found {
            Tracked::Lane(found) => Some(map.lane(found.lane).expect("a lane").number()),
            Tracked::NoLane => Some(0),
            Tracked::Unknown => None,
        }
    };
    fixes.iter().map(ask).collect()
}

#[test]
fn drives_off_the_lanes_and_across_them_are_on_none() {
    let options = TrackerOptions::default();
    let beside = [-1.7, -1.8, -6.0, -9.0, -14.0, -14.0, -9.0, -6.0, -1.7, -1.8];
    let fixes: Vec<_> = (0u8..)
        .zip(beside)
        .map(|(i, y)| fix(f64::from(i), [5.0 + 4.0 * f64::from(i), y], 0.0))
        .collect();
    let out = on_one_road(&fixes, &options);
    assert_eq!((out[1], out[4], out[5], out[9]), (Some(-1), Some(0), Some(0), Some(-1)), "{out:?}");
    let across: Vec<_> =
        (0u8..6).map(|i| fix(f64::from(i), [30.0, f64::from(i) - 3.0], FRAC_PI_2)).collect();
    assert_eq!(on_one_road(&across, &options)[5], Some(0));
}

#[test]
fn a_jump_is_not_believed_at_once_and_time_forgets() {
    let options = TrackerOptions::default();
    // From lane −1 to lane 1, which goes the other way, in a second.
    let jump = [(0.0, -1.75, 0.0), (1.0, -1.75, 0.0), (2.0, 1.75, PI), (3.0, 1.75, PI)];
    let fixes = jump.map(|(time, y, heading)| fix(time, [30.0, y], heading));
    assert_eq!(on_one_road(&fixes, &options), [Some(-1), Some(-1), None, Some(1)]);
    // After a long while nothing is left to contradict.
    let later = [fixes[0], fixes[1], TrackerFix { time: 100.0, ..fixes[2] }];
    assert_eq!(on_one_road(&later, &options)[2], Some(1));
}

#[test]
fn between_two_lanes_nobody_knows() {
    let mut between = fix(0.0, [30.0, 0.0], FRAC_PI_2);
    between.covariance.z_axis.z = 1e6;
    assert_eq!(on_one_road(&[between], &TrackerOptions::default()), [None]);
}

/// Fixes whose errors are alike count less: the same ten say no more than one.
#[test]
fn fixes_that_err_together_count_once() {
    let snapshot = maps::open(&carried("one_road.xodr"));
    let sure = |correlation_time: f64| {
        let options = TrackerOptions { correlation_time, ..TrackerOptions::default() };
        let mut tracker = Tracker::new();
        for i in 0..10u8 {
            let mut one = fix(0.1 * f64::from(i), [30.0, 0.2], 0.0);
            one.covariance.z_axis.z = 1e6;
            tracker.update(snapshot.map(), &one, &options).expect("an answer");
        }
        tracker.hypotheses()[0].probability
    };
    assert!(sure(0.0) > 0.95 && sure(5.0) < 0.9, "{} {}", sure(0.0), sure(5.0));
}

/// Between two fixes a drive may pass many short nodes with lanes beside them: the way straight ahead is not forgotten for them.
#[test]
fn many_short_nodes_between_fixes_end_no_way() {
    let each = |number: u16| {
        let before = if number > 0 { "p" } else { "" };
        let next = if number < 99 { "s" } else { "" };
        let link =
            |way: &str, id: i32| if way.is_empty() { String::new() } else { format!("{way}{id} ") };
        let one = |id: i32| lane(id, &(link(before, id) + &link(next, id)));
        section(f64::from(number) * 3.0, "", &(one(-1) + &one(-2) + &one(-3)))
    };
    let sections: String = (0..100).map(each).collect();
    let line = Line(0.0, 0.0, 0.0, 300.0, 0.0);
    let snapshot = maps::open_text(&document(&road("a", "", line, "", &sections)));
    let (map, mut tracker, options) = (snapshot.map(), Tracker::new(), TrackerOptions::default());
    for (time, x) in [(0.0, 5.0), (10.0, 150.0), (20.0, 295.0)] {
        let fix = TrackerFix { odometer: Some(x), ..fix(time, [x, -5.25], 0.0) };
        let found = tracker.update(map, &fix, &options).expect("an answer");
        let Tracked::Lane(found) = found else { panic!("at {x} m: {found:?}") };
        assert_eq!(map.lane(found.lane).expect("a lane").number(), -2, "at {x} m");
    }
}

/// An odometer that jumps, or begins anew, is one that is not there.
#[test]
fn an_odometer_that_jumps_says_nothing() {
    let snapshot = maps::open(&carried("town.xodr"));
    let (map, random) = (snapshot.map(), &mut Random(9));
    let truth = drives::drive(map, 30.0, random);
    let fixes = drives::localise(&truth, 1, NOISE, true, random);
    let answers = |change: &dyn Fn(usize, f64) -> Option<f64>| {
        let (mut tracker, options) = (Tracker::new(), TrackerOptions::default());
        let each = fixes.iter().enumerate().map(|(i, fix)| {
            let odometer = fix.odometer.and_then(|way| change(i, way));
            tracker.update(map, &TrackerFix { odometer, ..*fix }, &options).expect("an answer")
        });
        each.collect::<Vec<_>>()
    };
    // Without the odometer of one fix, two ways are unknown: to it and from it.
    let jump = 150;
    for far in [1e12, -1e12, 1e3, -1e3] {
        let jumped = answers(&|i, way| Some(if i == jump { way + far } else { way }));
        let without = answers(&|i, way| (i != jump).then_some(way));
        assert_eq!(jumped, without, "{far}");
    }
}

#[test]
fn another_map_begins_anew() {
    let (first, second) =
        (maps::open(&carried("one_road.xodr")), maps::open(&carried("town.xodr")));
    let (mut tracker, options) = (Tracker::new(), TrackerOptions::default());
    let one = fix(0.0, [30.0, -1.75], 0.0);
    assert!(matches!(tracker.update(first.map(), &one, &options), Ok(Tracked::Lane(_))));
    tracker.update(second.map(), &one, &options).expect("an answer");
    let known =
        |found: &mapd_client::localisation::LaneMatch| second.map().lane(found.lane).is_ok();
    assert!(tracker.hypotheses().iter().all(known));
}

#[test]
fn what_is_wrong_with_a_fix_is_named_and_changes_nothing() {
    let snapshot = maps::open(&carried("one_road.xodr"));
    let (map, mut tracker) = (snapshot.map(), Tracker::new());
    let (good, options) = (fix(1.0, [30.0, -1.75], 0.0), TrackerOptions::default());
    tracker.update(map, &good, &options).expect("an answer");
    let before = tracker.hypotheses().to_vec();
    let mut check = |fix: TrackerFix, options: TrackerOptions<'_>, expected| {
        assert_eq!(tracker.update(map, &fix, &options), Err(expected));
        assert_eq!(tracker.hypotheses(), before);
    };
    check(TrackerFix { time: 0.5, ..good }, options, MatchError::Earlier);
    check(TrackerFix { time: f64::NAN, ..good }, options, MatchError::Pose("time"));
    let lost = TrackerFix { odometer: Some(f64::INFINITY), ..good };
    check(lost, options, MatchError::Pose("odometer"));
    let mut wrong = good;
    wrong.pose.heading = f64::NAN;
    check(wrong, options, MatchError::Pose("heading"));
    let mut wrong = good;
    wrong.covariance.x_axis.x = -1.0;
    check(wrong, options, MatchError::Negative(0));
    let mut wrong = good;
    (wrong.covariance.x_axis.y, wrong.covariance.y_axis.x) = (1.0, 1.0);
    check(wrong, options, MatchError::Indefinite(0, 1));
    let never = TrackerOptions { memory: 0.0, ..options };
    check(good, never, MatchError::Option("memory"));
    check(good, TrackerOptions { enough: 2.0, ..options }, MatchError::Option("enough"));
}
