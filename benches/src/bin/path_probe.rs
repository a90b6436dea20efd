//! One process that opens an archive and asks a number of questions about a path: `path_probe PATH KIND COUNT`, for counting
//! instructions. Kinds: `project` (a point with the answer before as a hint), `build` (the path), `corridor` (150 m with a station each metre), `surface` (that with
//! its surface), `segments`, `conflicts`, `none`.

use mapd_benches::{Random, long_way};
use mapd_client::Snapshot;
use mapd_client::glam::DVec2;
use mapd_client::path::{Corridor, PathBuffer, PathOptions};
use mapd_client::route::RouteScratch;
use mapd_client::vocabulary::VehicleClass;
use std::hint::black_box;
use std::process::ExitCode;

/// Length of the way, at least `[m]`.
const LENGTH: f64 = 500.0;
/// Points that are prepared; questions go round them.
const POINTS: usize = 1_000;
/// Largest offset of a point from the path `[m]`.
const OFFSET: f64 = 3.0;
/// Length of the corridor `[m]`.
const ROOM: f64 = 150.0;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [path, kind, count] = args.as_slice() else { return ExitCode::from(2) };
    let (Ok(snapshot), Ok(count)) =
        (Snapshot::open(std::path::Path::new(path)), count.parse::<usize>())
    else {
        return ExitCode::from(1);
    };
    let (map, car) = (snapshot.map(), VehicleClass::PassengerCar);
    let (mut buffer, mut other) = (PathBuffer::default(), PathBuffer::default());
    let Some(steps) = long_way(map, LENGTH, &mut RouteScratch::default()) else {
        return ExitCode::from(1);
    };
    let options = PathOptions::default();
    let Ok(path) = map.path(&steps, &options, &mut buffer) else { return ExitCode::from(1) };
    let mut random = Random(7);
    let places = (0..POINTS).filter_map(|i| {
        let at = path.at(path.length() * i as f64 / POINTS as f64).ok()?;
        let left = DVec2::from_angle(at.heading).perp();
        Some(at.position.truncate() + left * ((2.0 * random.unit() - 1.0) * OFFSET))
    });
    let points: Vec<DVec2> = places.collect();
    let (mut room, mut segments, mut conflicts) = (Corridor::default(), Vec::new(), Vec::new());
    let mut hint = None;
    for i in 0..count {
        match kind.as_str() {
            "project" => {
                hint = path.project(points[i % points.len()], hint).ok().map(|own| own.along);
                black_box(hint);
            }
            "build" => {
                black_box(map.path(&steps, &options, &mut other).map(|_| ()).ok());
            }
            "corridor" | "surface" => {
                black_box(path.corridor(0.0, ROOM, 1.0, car, &mut room).ok());
                if kind == "surface" {
                    black_box(path.corridor_surface(&mut room).ok());
                }
            }
            "segments" => path.segments(car, &mut segments),
            "conflicts" => path.conflicts(&mut conflicts),
            _ => {}
        }
    }
    ExitCode::SUCCESS
}
