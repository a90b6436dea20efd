//! One process that opens an archive and asks a number of queries: `query_probe PATH KIND COUNT`, for counting
//! instructions. Kinds: `nearest` (random over the roads), `trajectory` (in steps of half a metre), `hinted` (the same with
//! the last answer as a hint), `inertial` and `inertial-trajectory` (s, t to x, y, z), `none`.

use mapd_benches::places;
use mapd_client::{NearestOptions, Snapshot, Track, glam::DVec2};
use std::hint::black_box;
use std::process::ExitCode;

/// Places that are prepared; queries go round them.
const PLACES: usize = 4_096;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [path, kind, count] = args.as_slice() else { return ExitCode::from(2) };
    let (Ok(snapshot), Ok(count)) =
        (Snapshot::open(std::path::Path::new(path)), count.parse::<usize>())
    else {
        return ExitCode::from(1);
    };
    let map = snapshot.map();
    let along = matches!(kind.as_str(), "trajectory" | "hinted" | "inertial-trajectory");
    let places = places(map, along, PLACES);
    let roads: Vec<_> = map.roads().collect();
    let point = |&(road, s, t): &(u32, f64, f64)| {
        roads[road as usize].to_inertial(Track { s, t, h: 0.0 }).ok().map(|pose| pose.position)
    };
    let points: Vec<DVec2> =
        places.iter().filter_map(|place| Some(point(place)?.truncate())).collect();
    let mut options = NearestOptions::default();
    for i in 0..count {
        match kind.as_str() {
            "nearest" | "trajectory" => {
                black_box(map.nearest_lane(points[i % points.len()], &options).ok());
            }
            "hinted" => {
                let hit = map.nearest_lane(points[i % points.len()], &options);
                options.hint = black_box(hit.ok().flatten());
            }
            "inertial" | "inertial-trajectory" => {
                black_box(point(&places[i % places.len()]));
            }
            _ => {}
        }
    }
    ExitCode::SUCCESS
}
