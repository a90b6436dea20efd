//! Questions about a path beside what one does by hand without it, in one run.
//!
//! By hand: a point is found by the nearest lane, which is looked up among the route's steps; a corridor is asked lane by lane; and whether a
//! lane reaches the goal is asked of a search.

use mapd_benches::{Random, best, long_way, maps, print};
use mapd_client::batch::Places;
use mapd_client::glam::DVec2;
use mapd_client::path::{Corridor, Path, PathBuffer, PathOptions, PathPositions};
use mapd_client::route::{PositionOnLane, RouteScratch, RouteStep, ShortestLength};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Map, NearestOptions};
use std::hint::black_box;
use std::time::Duration;

/// Vehicle that drives.
const CAR: VehicleClass = VehicleClass::PassengerCar;
/// Rounds, of which the best counts.
const ROUNDS: usize = 30;
/// Points that are projected.
const POINTS: usize = 1_000;
/// Length of the path that they are projected on `[m]`.
const SHORT: f64 = 500.0;
/// Length of the route whose lanes are told `[m]`.
const LONG: f64 = 5_000.0;
/// Length of the corridor `[m]`.
const ROOM: f64 = 150.0;
/// Largest offset of a point from the path `[m]`.
const OFFSET: f64 = 3.0;

fn ns(time: Duration, each: usize) -> String {
    format!("{:.0} ns", time.as_secs_f64() * 1e9 / each as f64)
}

fn us(time: Duration) -> String {
    format!("{:.1} µs", time.as_secs_f64() * 1e6)
}

fn times(by_hand: Duration, own: Duration) -> String {
    format!("{:.1} ×", by_hand.as_secs_f64() / own.as_secs_f64())
}

/// Points beside a path, one after the other.
fn points(path: &Path<'_, '_>) -> Vec<DVec2> {
    let mut random = Random(7);
    let place = |i: usize| {
        let along = path.length() * i as f64 / POINTS as f64;
        let at = path.at(along).expect("a place");
        let left = DVec2::from_angle(at.heading).perp();
        at.position.truncate() + left * ((2.0 * random.unit() - 1.0) * OFFSET)
    };
    (0..POINTS).map(place).collect()
}

fn project(name: &str, map: Map<'_>, path: &Path<'_, '_>, steps: &[RouteStep]) {
    let points = points(path);
    let coherent = best(ROUNDS, || {
        let mut hint = None;
        for point in &points {
            hint = path.project(*point, hint).ok().map(|found| black_box(found).along);
        }
    });
    let (x, y): (Vec<f64>, Vec<f64>) = points.iter().map(|point| (point.x, point.y)).unzip();
    let places = Places { x: &x, y: &y, ..Places::default() };
    let mut feet = PathPositions::default();
    let batch = best(ROUNDS, || path.project_batch(black_box(places), &mut feet).expect("feet"));
    let options = NearestOptions { vehicle: Some(CAR), ..NearestOptions::default() };
    let by_hand = best(ROUNDS, || {
        for point in &points {
            let Ok(Some(found)) = map.nearest_lane(*point, &options) else { continue };
            let number = steps.iter().position(|step| step.lane == found.lane);
            let gone = number.and_then(|number| {
                let lane = map.lane(found.lane).ok()?;
                Some((number, lane.length_between(steps[number].s_from, found.position.s)))
            });
            black_box(gone);
        }
    });
    let (coherent_ns, batch_ns) = (ns(coherent, POINTS), ns(batch, POINTS));
    print(&format!(
        "project, {name}, {POINTS} points on {:.0} m: {coherent_ns} each with a hint, {batch_ns} in a batch without; nearest lane and its step {} ({})",
        path.length(),
        ns(by_hand, POINTS),
        times(by_hand, coherent)
    ));
}

fn corridor(name: &str, map: Map<'_>, path: &Path<'_, '_>) {
    let mut room = Corridor::default();
    let without = best(ROUNDS, || path.corridor(0.0, ROOM, 1.0, CAR, &mut room).expect("a room"));
    let with = best(ROUNDS, || {
        path.corridor(0.0, ROOM, 1.0, CAR, &mut room).expect("a room");
        path.corridor_surface(&mut room).expect("surfaces");
    });
    let (lanes, s) = (room.lane.clone(), room.s.clone());
    let by_hand = best(ROUNDS, || {
        for (id, s) in lanes.iter().zip(&s) {
            let Ok(lane) = map.lane(*id) else { continue };
            black_box(lane.bounds_at(*s));
            for beside in [lane.left(), lane.right()].into_iter().flatten() {
                black_box(beside.bounds_at(*s));
            }
            black_box(lane.road_mark_at(*s).map(|mark| mark.kind()));
            black_box(lane.inner().and_then(|inner| inner.road_mark_at(*s)).map(|m| m.kind()));
            black_box(lane.speed_rule_at(*s));
        }
    });
    print(&format!(
        "corridor, {name}, {} stations: {}, {} with surface; lane by lane without surface {} ({})",
        room.len(),
        us(without),
        us(with),
        us(by_hand),
        times(by_hand, without)
    ));
}

fn segments(name: &str, map: Map<'_>, path: &Path<'_, '_>, scratch: &mut RouteScratch) {
    let mut found = Vec::new();
    let own = best(ROUNDS, || path.segments(CAR, &mut found));
    let Some(last) = path.lanes().last() else { return };
    let to = PositionOnLane { lane: last.lane, s: last.s[1] };
    let (cost, mut steps) = (ShortestLength::default(), Vec::new());
    let by_hand = best(1, || {
        for segment in &found {
            let Ok(lane) = map.lane(segment.lane) else { continue };
            let section = lane.section();
            let s = 0.5 * (section.s_start() + section.s_end());
            let from = PositionOnLane { lane: segment.lane, s };
            black_box(map.route(from, to, CAR, &cost, scratch, &mut steps).ok());
        }
    });
    print(&format!(
        "segments, {name}, {} of {:.0} m: {}; a search for each {} ({})",
        found.len(),
        path.length(),
        us(own),
        us(by_hand),
        times(by_hand, own)
    ));
}

/// All figures of a map.
fn measure(name: &str, map: Map<'_>) {
    let (mut scratch, mut buffer) = (RouteScratch::default(), PathBuffer::default());
    let options = PathOptions::default();
    if let Some(mut steps) = long_way(map, SHORT, &mut scratch) {
        let mut part = Vec::new();
        {
            let path = map.path(&steps, &options, &mut buffer).expect("a path");
            path.steps_between(&steps, [0.0, SHORT], &mut part).expect("steps");
        }
        std::mem::swap(&mut steps, &mut part);
        let path = map.path(&steps, &options, &mut buffer).expect("a path");
        project(name, map, &path, &steps);
        corridor(name, map, &path);
    }
    let Some(steps) = long_way(map, LONG, &mut scratch) else {
        print(&format!("skipped: {name} has no way of {LONG} m"));
        return;
    };
    let build = best(ROUNDS, || {
        black_box(map.path(black_box(&steps), &options, &mut buffer).map(|_| ()).ok());
    });
    let path = map.path(&steps, &options, &mut buffer).expect("a path");
    let metres = path.length();
    print(&format!(
        "build, {name}, {metres:.0} m: {} ({} per metre)",
        us(build),
        ns(build, metres as usize)
    ));
    segments(name, map, &path, &mut scratch);
    let (mut conflicts, mut met) = (Vec::new(), Vec::new());
    let (mut facts, mut speeds) = (Vec::new(), Vec::new());
    print(&format!(
        "along it, {name}: conflicts {}, facts {}, speeds {}",
        us(best(ROUNDS, || path.conflicts(&mut conflicts, &mut met))),
        us(best(ROUNDS, || path.facts(&mut facts))),
        us(best(ROUNDS, || path.speeds(&mut speeds)))
    ));
}

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, path) in maps(folder.path()) {
        measure(name, mapd_benches::compiled(&path).map());
    }
}
