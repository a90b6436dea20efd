//! Whether a view and a map with the same written into it find the same ways, and say the same along one path.

use mapd_query::Map;
use mapd_query::path::{Corridor, Path, PathBuffer, PathError, PathOptions, PathSegment, PathTime};
use mapd_query::roads::travel_speed;
use mapd_query::route::{Enter, RouteStep};
use mapd_query::rules::SpeedOrigin;
use mapd_query::view::{OverlayKind, View};
use mapd_query::vocabulary::VehicleClass;
use mapd_tests::overlays::Stretch;

const CAR: VehicleClass = VehicleClass::PassengerCar;
/// What a map stores of a place in single precision differs from the view's by less `[m]`.
const SAME_PLACE: f64 = 1e-3;
/// Two ways that cost the same differ by less, in proportion.
const TIE: f64 = 1e-9;
/// Shorter pieces are not cut, and what holds in a piece's middle holds for all of it `[m]`.
const CUT: f64 = 0.11;
/// From station to station of a corridor `[m]`.
const STEP: f64 = 7.3;
/// What a sign says stands above a record in the file, and what is written on the lane that leads into a junction goes on holding there.
pub(crate) const BEYOND_THE_LANE: [SpeedOrigin; 3] =
    [SpeedOrigin::Signal, SpeedOrigin::Entry, SpeedOrigin::Depends];

/// What ways are measured by.
#[derive(Clone, Copy)]
pub(crate) struct Measure {
    pub(crate) by_time: bool,
    pub(crate) lane_change: f64,
}

/// A lane that is driven on: by its name, and between which s on its road.
#[derive(Debug)]
struct Driven {
    lane: String,
    forward: bool,
    s: [f64; 2],
}

/// What is driven on, lane by lane, however it is cut; lanes that are only changed over are not among them.
fn driven(map: Map<'_>, steps: &[RouteStep]) -> Vec<Driven> {
    let mut out: Vec<Driven> = Vec::new();
    for step in steps.iter().filter(|step| step.s_from != step.s_to) {
        let lane = map.lane(step.lane).expect("a lane").key().to_string();
        let goes_on = |last: &&mut Driven| {
            last.lane == lane
                && last.forward == step.forward
                && (last.s[1] - step.s_from).abs() < SAME_PLACE
        };
        match out.last_mut().filter(goes_on) {
            Some(last) => last.s[1] = step.s_to,
            None => {
                out.push(Driven { lane, forward: step.forward, s: [step.s_from, step.s_to] });
            }
        }
    }
    out
}

/// Steps on another map of the same lanes.
fn over_there(map: Map<'_>, steps: &[RouteStep], other: Map<'_>) -> Vec<RouteStep> {
    let moved = |step: &RouteStep| {
        let key = map.lane(step.lane).expect("a lane").key();
        RouteStep { lane: other.lane_by_key(&key).expect("the same lanes").lane_id(), ..*step }
    };
    steps.iter().map(moved).collect()
}

/// What a way costs today, in double precision.
fn cost(view: View<'_>, steps: &[RouteStep], measure: Measure) -> f64 {
    let of_step = |step: &RouteStep| {
        let lane = view.map().lane(step.lane).expect("a lane");
        let length = lane.length_between(step.s_from, step.s_to);
        let middle = 0.5 * (step.s_from + step.s_to);
        let today = view.speed_rule_at(step.lane, middle, CAR).expect("an answer");
        let entered = matches!(step.enter, Enter::Left | Enter::Right);
        let change = if entered { measure.lane_change } else { 0.0 };
        change
            + match today.restriction.and(today.max) {
                _ if !measure.by_time => length,
                Some(max) => length / travel_speed(max),
                None => lane.time_between(step.s_from, step.s_to),
            }
    };
    steps.iter().map(of_step).sum()
}

/// Why steps are no way on the map that found them; none if they are.
fn fault(map: Map<'_>, steps: &[RouteStep]) -> Option<PathError> {
    let mut buffer = PathBuffer::default();
    let built = map.path(steps, &PathOptions::default(), &mut buffer).map(|_| ());
    built.err().filter(|error| *error != PathError::Empty)
}

/// What a way enters though it is closed today; none if nothing. What is closed may be left where the way begins.
fn entered_closed(view: View<'_>, steps: &[RouteStep]) -> Option<String> {
    let mut met = Vec::new();
    for step in steps.iter().skip(1) {
        view.restrictions_along(&[*step], CAR, &mut met).expect("an answer");
        let lane = view.map().lane(step.lane).expect("a lane");
        if step.s_from == step.s_to || lane.is_forward() != step.forward {
            continue;
        }
        let allowed = view.allows(step.lane, 0.5 * (step.s_from + step.s_to), CAR);
        let (low, high) = (step.s_from.min(step.s_to), step.s_from.max(step.s_to));
        let is_closed = met.iter().any(|one| {
            one.entry.kind() == OverlayKind::Closed
                && one.s_to.min(high) - one.s_from.max(low) > SAME_PLACE
        });
        if is_closed || !allowed.expect("an answer").is_allowed {
            return Some(format!("{step:?} is closed: {met:?}"));
        }
    }
    None
}

/// Whether two ways, of a view and of another map, are the same (true), or both can be driven and cost the same (false).
///
/// Panics: they are neither.
pub(crate) fn are_same(
    (view, steps): (View<'_>, &[RouteStep]),
    (other, expected): (Map<'_>, &[RouteStep]),
    (measure, kept): (Measure, &[Stretch]),
    what: &str,
) -> bool {
    let (own, there) = (driven(view.map(), steps), driven(other, expected));
    let near = |a: f64, b: f64| (a - b).abs() < SAME_PLACE;
    let same = |(a, b): (&Driven, &Driven)| {
        a.lane == b.lane && a.forward == b.forward && near(a.s[0], b.s[0]) && near(a.s[1], b.s[1])
    };
    assert_eq!(fault(view.map(), steps), None, "{what}: {own:?}");
    assert_eq!(fault(other, expected), None, "{what}: {there:?}");
    assert_eq!(entered_closed(view, steps), None, "{what}: {own:?}");
    if own.len() == there.len() && own.iter().zip(&there).all(same) {
        return true;
    }
    let mut expected = over_there(other, expected, view.map());
    // A cut is stored in single precision there: back to where it is written.
    let written = |(road, section): (&str, u32), s: f64| {
        let here = |one: &&Stretch| one.road == road && one.section == section as usize;
        let own = kept.iter().filter(here).flat_map(|one| one.s);
        own.into_iter().find(|end| near(*end, s)).unwrap_or(s)
    };
    for step in &mut expected {
        let lane = view.map().lane(step.lane).expect("a lane");
        let here = (lane.road().id(), lane.key().section);
        [step.s_from, step.s_to] = [step.s_from, step.s_to].map(|s| written(here, s));
    }
    assert_eq!(entered_closed(view, &expected), None, "{what}: {there:?}");
    let costs = [cost(view, steps, measure), cost(view, &expected, measure)];
    let is_tie = (costs[0] - costs[1]).abs() <= TIE * (1.0 + costs[1]);
    assert!(is_tie, "{what}: {costs:?}\n{own:?}\n{there:?}");
    false
}

/// A lane from which the goal of a path is reached, however the path is cut into stretches.
#[derive(Debug, PartialEq)]
struct Reaching {
    lane: String,
    forward: bool,
    driven: bool,
    changes: u32,
    /// S of both ends, the last place for a change, the lane's end.
    s: [f64; 4],
}

fn reaching(map: Map<'_>, segments: &[PathSegment]) -> Vec<Reaching> {
    let mut out: Vec<Reaching> = Vec::new();
    for own in segments {
        let [from, to] = own.along;
        let next = Reaching {
            lane: map.lane(own.lane).expect("a lane").key().to_string(),
            forward: own.forward,
            driven: own.driven,
            changes: own.changes,
            s: [from, to, own.last_change, own.lane_end],
        };
        let goes_on = |before: &&mut Reaching| {
            let ends = [before.s[1], before.s[2], before.s[3]];
            let same = ends.iter().zip([from, next.s[2], next.s[3]]);
            (&before.lane, before.forward, before.driven, before.changes)
                == (&next.lane, next.forward, next.driven, next.changes)
                && same.into_iter().all(|(a, b)| (a - b).abs() < SAME_PLACE)
        };
        match out.iter_mut().rev().find(goes_on) {
            Some(before) => before.s[1] = to,
            None => out.push(next),
        }
    }
    out.retain(|own| own.s[1] - own.s[0] > CUT);
    out
}

/// Compares what a view and another map say along one path, of steps that each has found for itself, or that are the plain map's for both.
pub(crate) fn compare_path(
    (view, steps): (View<'_>, &[RouteStep]),
    (other, steps_there): (Map<'_>, Option<&[RouteStep]>),
    kept: &[Stretch],
) {
    let map = view.map();
    let moved = over_there(map, steps, other);
    let (mut buffer, mut there) = (PathBuffer::default(), PathBuffer::default());
    let options = PathOptions::default();
    let Ok(path) = map.path(steps, &options, &mut buffer) else { return };
    let path_there = other.path(steps_there.unwrap_or(&moved), &options, &mut there);
    let path_there = path_there.expect("the same path");
    assert!((path.length() - path_there.length()).abs() < SAME_PLACE);
    compare_segments(view, &path, other, &path_there);
    compare_rooms(view, &path, &path_there, kept);
    let mut speeds = Vec::new();
    view.speeds_on_path(&path, CAR, &mut speeds).expect("an answer");
    let (mut sum, mut last) = (PathTime { time: 0.0, unlimited: 0.0 }, 0.0);
    for one in &speeds {
        let [from, to] = one.along;
        assert!(from == last && to > from, "{speeds:?}");
        last = to;
        let middle = view.speed_on_path(&path, 0.5 * (from + to), CAR).expect("an answer");
        assert_eq!(one.today.max, middle.max, "{speeds:?}");
        match one.today.max.filter(|max| *max > 0.0 && max.is_finite()) {
            Some(max) => sum.time += (to - from) / max,
            None => sum.unlimited += to - from,
        }
    }
    assert_eq!(last, path.length());
    let all = [0.0, path.length()];
    let time = view.travel_time_on_path(&path, all, CAR).expect("an answer");
    let near = |a: f64, b: f64| (a - b).abs() < 1e-6 * (1.0 + b);
    let same = |a: PathTime, b: PathTime| near(a.time, b.time) && near(a.unlimited, b.unlimited);
    assert!(same(time, sum), "{time:?} {sum:?}");
    let mut rules = Vec::new();
    path_there.speeds(&mut rules);
    if !rules.iter().any(|one| BEYOND_THE_LANE.contains(&one.rule.origin)) {
        let expected = path_there.travel_time(all).expect("an answer");
        assert!(same(time, expected), "{time:?} {expected:?}\n{speeds:?}\n{rules:?}");
    }
}

fn compare_segments(
    view: View<'_>,
    path: &Path<'_, '_>,
    other: Map<'_>,
    path_there: &Path<'_, '_>,
) {
    let (mut own, mut expected) = (Vec::new(), Vec::new());
    view.segments_on_path(path, CAR, &mut own).expect("an answer");
    path_there.segments(CAR, &mut expected);
    let (own, expected) = (reaching(view.map(), &own), reaching(other, &expected));
    let same = |(a, b): (&Reaching, &Reaching)| {
        (&a.lane, a.forward, a.driven, a.changes) == (&b.lane, b.forward, b.driven, b.changes)
            && a.s.iter().zip(b.s).all(|(a, b)| (a - b).abs() < CUT)
    };
    let alike = own.len() == expected.len() && own.iter().zip(&expected).all(same);
    let listed = |all: &[Reaching]| all.iter().map(|one| format!("{one:?}\n")).collect::<String>();
    assert!(alike, "{}\n{}", listed(&own), listed(&expected));
}

fn compare_rooms(view: View<'_>, path: &Path<'_, '_>, path_there: &Path<'_, '_>, kept: &[Stretch]) {
    let (mut own, mut expected) = (Corridor::default(), Corridor::default());
    let length = path.length();
    view.corridor(path, 0.0, length, STEP, CAR, &mut own).expect("a corridor");
    path_there.corridor(0.0, length, STEP, CAR, &mut expected).expect("a corridor");
    assert_eq!(own.len(), expected.len());
    let crossed = |room: &Corridor, i: usize| {
        [&room.left_mark, &room.right_mark].map(|marks| marks[i].may_cross)
    };
    for (i, along) in own.along.iter().enumerate() {
        let is_crossed = crossed(&own, i) == crossed(&expected, i);
        let [left, right] = [
            own.outer_left[i].distance(expected.outer_left[i]),
            own.outer_right[i].distance(expected.outer_right[i]),
        ];
        let is_near = left < SAME_PLACE && right < SAME_PLACE;
        let is_slowed = BEYOND_THE_LANE.contains(&expected.speed[i].origin)
            || own.speed[i].max == expected.speed[i].max;
        if is_crossed && is_near && is_slowed {
            continue;
        }
        // Whatever differs lies at a cut.
        let lane = view.map().lane(own.lane[i]).expect("a lane");
        let (road, section, s) = (lane.road(), lane.key().section as usize, own.s[i]);
        let is_cut = |one: &Stretch| {
            (one.road.as_str(), one.section) == (road.id(), section)
                && one.s.iter().any(|end| (end - s).abs() < CUT)
        };
        assert!(
            kept.iter().any(is_cut),
            "{} at {s}, S {along}: {left} m and {right} m apart, crossed {:?} and {:?}, {:?} and {:?}",
            lane.key(),
            crossed(&own, i),
            crossed(&expected, i),
            own.speed[i],
            expected.speed[i]
        );
    }
}
