//! Nearest lane and (s, t) → (x, y, z), against rstar and the crate `xodr`, in one run.

use mapd_benches::{PARTICLES, best, cloud, maps, percentiles, places, print};
use mapd_client::batch::{BatchScratch, NearestLanes, Places};
use mapd_client::compiling::ByRow as _;
use mapd_client::localisation::MarkFilter;
use mapd_client::{Map, NearestOptions, Snapshot, Track, glam::DVec2};
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

/// Best times of one place each for the nearest road mark, of single calls and of a batch, in turns.
fn marks(map: Map<'_>, what: &str, points: &[DVec2]) {
    let (filter, mut out) = (MarkFilter::default(), Vec::new());
    let (mut single, mut together) = (Duration::MAX, Duration::MAX);
    for _ in 0..ROUNDS {
        single = single.min(best(1, || {
            for point in points {
                black_box(map.nearest_mark(*point, &filter).expect("an answer"));
            }
        }));
        together = together.min(best(1, || {
            map.nearest_marks(points, &filter, &mut out).expect("answers");
        }));
    }
    print_pair(&format!("nearest mark, {what}"), points.len(), single, together);
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

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, path) in maps(folder.path()) {
        let file = std::fs::File::open(&path).expect("the map opens");
        let compiled =
            compile(file, &CompileOptions::default(), &mut |_| {}).expect("reading works");
        let rows = compiled.rows.expect("accepted");
        let archive = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
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
            marks(map, &format!("cloud {i} of particles, {name}"), &particles);
        }
        let strewn = on_roads(STREWN);
        batch(map, &format!("{STREWN} places, {name}"), &strewn);
        marks(map, &format!("{STREWN} places, {name}"), &strewn);
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
