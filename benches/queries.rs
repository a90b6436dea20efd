//! Nearest lane and (s, t) → (x, y, z), against rstar and the crate `xodr`, in one run.

use mapd_benches::{PARTICLES, best, cloud, maps, percentiles, places, print, wait};
use mapd_client::batch::{
    BatchScratch, NearestLanes, Places, PoseMatches, Poses, TrackPositions, Tracks,
};
use mapd_client::compiling::ByRow as _;
use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::localisation::{GroundScratch, MarkFilter, MatchOptions, VehiclePose};
use mapd_client::{Map, NearestOptions, Point, Snapshot, Track};
use mapd_compiler::{CompileOptions, compile};
use rstar::RTree;
use rstar::primitives::{GeomWithData, Line};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Queries of each kind.
const QUERIES: usize = 20_000;
/// Queries timed together: a single one is near the clock's resolution.
const BATCH: usize = 8;
/// Places of a batch strewn over the map; times that each batch is asked; clouds of particles.
const STREWN: usize = 100_000;
const ROUNDS: usize = 5;
const CLOUDS: usize = 4;
/// The slow peer gets fewer.
const PEER_QUERIES: usize = 2_000;

fn ns(time: Duration) -> String {
    format!("{} ns", time.as_nanos())
}

/// Percentiles of the time of one query, all of them asked once before: the first round, of which only the half is told, waits for
/// memory that was not read before.
fn time<T>(inputs: &[T], mut query: impl FnMut(&T)) -> [Duration; 3] {
    let (first, _) = round(inputs, &mut query);
    let (p50, p99) = round(inputs, &mut query);
    [p50, p99, first]
}

/// Percentiles of the time of one query in one round over the inputs.
fn round<T>(inputs: &[T], query: &mut impl FnMut(&T)) -> (Duration, Duration) {
    let batches = inputs.chunks_exact(BATCH).map(|batch| {
        let start = Instant::now();
        batch.iter().for_each(&mut *query);
        start.elapsed() / BATCH as u32
    });
    percentiles(batches.collect())
}

/// Best times of one place each, of single calls and of a batch, in turns.
fn batch(map: Map<'_>, what: &str, points: &[DVec2]) {
    let (x, y): (Vec<f64>, Vec<f64>) = points.iter().map(|p| (p.x, p.y)).unzip();
    let places = Places { x: &x, y: &y, z: None, heading: None };
    let (options, mut scratch, mut out) =
        (NearestOptions::default(), BatchScratch::default(), NearestLanes::default());
    let (mut single, mut together) = (Duration::MAX, Duration::MAX);
    for _ in 0..ROUNDS {
        single = single.min(best(1, || {
            for point in points {
                black_box(map.nearest_lane(*point, &options).expect("an answer"));
            }
        }));
        together = together.min(best(1, || {
            map.nearest_lanes(places, &options, &mut scratch, &mut out).expect("answers");
        }));
    }
    print_pair(what, points.len(), single, together);
}

/// Best times of one of so many places, of single calls and of a batch, in turns.
fn pair(what: &str, count: usize, mut one_by_one: impl FnMut(), mut as_batch: impl FnMut()) {
    let (mut single, mut together) = (Duration::MAX, Duration::MAX);
    for _ in 0..ROUNDS {
        single = single.min(best(1, &mut one_by_one));
        together = together.min(best(1, &mut as_batch));
    }
    print_pair(what, count, single, together);
}

/// The nearest road mark, and the ground.
fn marks_and_ground(map: Map<'_>, what: &str, points: &[DVec2]) {
    let (filter, mut out) = (MarkFilter::default(), Vec::new());
    let single = || {
        for point in points {
            black_box(map.nearest_mark(*point, &filter).expect("an answer"));
        }
    };
    let together = || map.nearest_marks(points, &filter, &mut out).expect("answers");
    pair(&format!("nearest mark, {what}"), points.len(), single, together);
    let places: Vec<Point> = points.iter().map(|point| (*point).into()).collect();
    let (mut room, mut scratch, mut out) =
        (GroundScratch::default(), GroundScratch::default(), Vec::new());
    let single = || {
        for place in &places {
            black_box(map.ground_at(*place, &[], &mut room).expect("an answer"));
        }
    };
    let together = || map.ground_below(&places, &[], &mut scratch, &mut out).expect("answers");
    pair(&format!("ground, {what}"), points.len(), single, together);
}

/// Poses of a cloud that head as the lane below each does.
fn matches(map: Map<'_>, what: &str, points: &[DVec2]) {
    let options = NearestOptions::default();
    let pose = |point: &DVec2| {
        let lane = map.nearest_lane(*point, &options).expect("an answer");
        let heading = lane.map_or(0.0, |lane| lane.position.heading);
        VehiclePose { position: (*point).into(), heading }
    };
    let poses: Vec<VehiclePose> = points.iter().map(pose).collect();
    let covariance = [DMat3::from_diagonal(DVec3::new(0.09, 0.09, 0.0025))];
    let (options, mut own) = (MatchOptions::default(), Vec::new());
    let single = || {
        for pose in &poses {
            black_box(map.match_pose(pose, &covariance[0], &options, &mut own)).expect("an answer");
        }
    };
    let (mut scratch, mut out) = (BatchScratch::default(), PoseMatches::default());
    let together = || {
        map.match_poses(&poses, &covariance, &options, &mut scratch, &mut out).expect("answers");
    };
    pair(&format!("match of poses, {what}"), points.len(), single, together);
}

/// Places all over the longest road, to its coordinates and from them.
fn tracks(map: Map<'_>, name: &str) {
    let road = map.roads().max_by(|a, b| a.length().total_cmp(&b.length())).expect("a road");
    let s: Vec<f64> = (0..PARTICLES).map(|i| road.length() * i as f64 / PARTICLES as f64).collect();
    let t: Vec<f64> = (0..PARTICLES).map(|i| (i % 9) as f64 - 4.0).collect();
    let columns = Tracks { s: &s, t: &t, h: None };
    let mut poses = Poses::default();
    let single = || {
        for (s, t) in s.iter().zip(&t) {
            black_box(road.to_inertial(Track { s: *s, t: *t, h: 0.0 }).expect("a place"));
        }
    };
    let together = || road.to_inertial_batch(columns, &mut poses).expect("places");
    pair(&format!("to_inertial, the longest road, {name}"), PARTICLES, single, together);
    let mut feet = TrackPositions::default();
    let Poses { x, y, .. } = &poses;
    let single = || {
        for (x, y) in x.iter().zip(y) {
            black_box(road.to_track(DVec2::new(*x, *y)).expect("a foot"));
        }
    };
    let places = Places { x, y, z: None, heading: None };
    let together = || road.to_track_batch(places, &mut feet).expect("feet");
    pair(&format!("to_track, the longest road, {name}"), PARTICLES, single, together);
}

/// Tells what one of so many places costs, asked one by one and together.
fn print_pair(what: &str, count: usize, single: Duration, together: Duration) {
    let each = |time: Duration| time.as_secs_f64() * 1e9 / count as f64;
    print(&format!(
        "{what}: {:.0} ns one by one, {:.0} ns as a batch ({:.1} ×)",
        each(single),
        each(together),
        each(single) / each(together)
    ));
}

/// What is asked of a lane that is known, against the place on its road's reference line alone.
fn on_known_lane(map: Map<'_>, what: &str, points: &[DVec2]) {
    let options = NearestOptions::default();
    let lane = |at: &DVec2| map.lane(map.nearest_lane(*at, &options).ok()??.lane).ok();
    let known: Vec<_> = points.iter().filter_map(|at| Some((*at, lane(at)?))).collect();
    let [track, ..] = time(&known, |(at, lane)| {
        black_box(lane.road().to_track(*at).expect("a foot"));
    });
    let [position, ..] = time(&known, |(at, lane)| {
        black_box(lane.position_of(*at).expect("a place"));
    });
    let [contains, ..] = time(&known, |(at, lane)| {
        black_box(lane.contains(*at).expect("an answer"));
    });
    let ratio = |time: Duration| time.as_secs_f64() / track.as_secs_f64();
    print(&format!(
        "on a known lane, {what}: to_track p50 {}; position_of {} ({:.2} ×), contains {} ({:.2} ×)",
        ns(track),
        ns(position),
        ratio(position),
        ns(contains),
        ratio(contains)
    ));
}

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, path) in maps(folder.path()) {
        let file = std::fs::File::open(&path).expect("the map opens");
        let compiled =
            compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
        let rows = compiled.rows.expect("accepted");
        let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
        let bytes = archive.len();
        let snapshot = Snapshot::from_bytes(archive).expect("opens");
        let map = snapshot.map();
        let roads: Vec<_> = map.roads().collect();
        let options = NearestOptions::default();
        let mut segments = Vec::new();
        for lane in map.lanes() {
            let points: Vec<_> = lane.center_line().positions().collect();
            let row = lane.lane_id().row();
            segments.extend(
                points
                    .windows(2)
                    .map(|p| GeomWithData::new(Line::new([p[0].x, p[0].y], [p[1].x, p[1].y]), row)),
            );
        }
        let tree = RTree::bulk_load(segments);
        let peer =
            if std::env::var_os("NOPEER").is_some() { None } else { xodr::load_file(&path).ok() };
        let on_roads = |count: usize| -> Vec<DVec2> {
            let at = |&(road, s, t): &(u32, f64, f64)| {
                let pose = roads[road as usize].to_inertial(Track { s, t, h: 0.0 });
                pose.expect("a pose").position.truncate()
            };
            places(map, false, count).iter().map(at).collect()
        };
        for (i, middle) in on_roads(CLOUDS).into_iter().enumerate() {
            let particles = cloud(middle, PARTICLES);
            batch(map, &format!("cloud {i} of particles, {name}"), &particles);
            marks_and_ground(map, &format!("cloud {i} of particles, {name}"), &particles);
            matches(map, &format!("cloud {i} of particles, {name}"), &particles);
        }
        tracks(map, name);
        let strewn = on_roads(STREWN);
        batch(map, &format!("{STREWN} places, {name}"), &strewn);
        marks_and_ground(map, &format!("{STREWN} places, {name}"), &strewn);
        print(&format!(
            "a read that waits for the one before, in {bytes} B as {name}'s archive has: {}",
            ns(wait(bytes))
        ));
        for (kind, along) in [("random", false), ("along a trajectory", true)] {
            let places = places(map, along, QUERIES);
            let track = |&(road, s, t): &(u32, f64, f64)| {
                roads[road as usize].to_inertial(Track { s, t, h: 0.0 }).expect("a pose").position
            };
            let points: Vec<DVec2> = places.iter().map(|place| track(place).truncate()).collect();
            let [near, near99, near1] = time(&points, |p| {
                black_box(map.nearest_lane(*p, &options).expect("an answer"));
            });
            // rstar finds the segment; the same projection then gives s and offset.
            let [rstar, ..] = time(&points, |p| {
                let hit = tree.nearest_neighbor([p.x, p.y]).expect("the map has lanes");
                let road = map.lane_by_row(hit.data).expect("a lane").road();
                black_box(road.to_track(*p).expect("a foot"));
            });
            let other = peer.as_ref().map(|net| {
                let few = &points[..PEER_QUERIES.min(points.len())];
                time(few, |p| {
                    black_box(net.lane_position(xodr::Point::new(p.x as f32, p.y as f32, 0.0)));
                })
            });
            let ratio = |other: Duration| other.as_secs_f64() / near.as_secs_f64();
            let other = other.map_or("xodr did not load".to_owned(), |[p50, ..]| {
                format!("xodr lane_position p50 {} ({:.1} ×)", ns(p50), ratio(p50))
            });
            print(&format!(
                "nearest lane, {name}, {kind}: p50 {} p99 {}, {} in the first round; rstar and projection p50 {} ({:.1} ×); {other}",
                ns(near),
                ns(near99),
                ns(near1),
                ns(rstar),
                ratio(rstar)
            ));
            on_known_lane(map, &format!("{name}, {kind}"), &points);
            let [to_xyz, to_xyz99, to_xyz1] = time(&places, |place| {
                black_box(track(place));
            });
            // The peer's own road positions of the same points.
            let other = peer.as_ref().map_or("xodr did not load".to_owned(), |net| {
                let few = &points[..PEER_QUERIES.min(points.len())];
                let at =
                    |p: &DVec2| net.road_position(xodr::Point::new(p.x as f32, p.y as f32, 0.0));
                let positions: Vec<_> = few.iter().filter_map(at).collect();
                let [p50, ..] = time(&positions, |at| {
                    black_box(net.road_point(*at));
                });
                format!(
                    "xodr road_point p50 {} ({:.1} ×)",
                    ns(p50),
                    p50.as_secs_f64() / to_xyz.as_secs_f64()
                )
            });
            print(&format!(
                "(s,t) → x,y,z, {name}, {kind}: p50 {} p99 {}, {} in the first round; {other}",
                ns(to_xyz),
                ns(to_xyz99),
                ns(to_xyz1),
            ));
        }
    }
}
