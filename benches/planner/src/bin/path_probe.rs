//! One process that opens an archive and asks a number of questions about a path and of routes: `path_probe PATH KIND COUNT`, for counting
//! instructions. Kinds: `project` (a point with the answer before as a hint), `project-batch` (1,000 points at once), `at`, `build` (the path), `corridor` (150 m
//! with a station each metre), `surface` (that with its surface), `segments`, `conflicts`; between both ends of the path's way `request` (a search),
//! `alternatives` and `reach` (within 500 m); `none`.

use mapd_client::batch::Places;
use mapd_client::path::{Corridor, PathBuffer, PathOptions, PathPositions};
use mapd_client::route::{
    AlternativeOptions, PositionOnLane, Reach, RouteRequest, RouteScratch, Routes, ShortestLength,
};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Snapshot, glam::DVec2};
use mapd_planner::{Random, long_way};
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
    let (map, vehicle) = (snapshot.map(), VehicleClass::PassengerCar);
    let (mut buffer, mut other) = (PathBuffer::default(), PathBuffer::default());
    let mut scratch = RouteScratch::default();
    let Some(mut steps) = long_way(map, LENGTH, &mut scratch) else {
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
    let (x, y): (Vec<f64>, Vec<f64>) = points.iter().map(|p| (p.x, p.y)).unzip();
    let (mut room, mut segments) = (Corridor::default(), Vec::new());
    let (mut conflicts, mut met) = (Vec::new(), Vec::new());
    let (mut feet, mut routes, mut reach) =
        (PathPositions::default(), Routes::default(), Reach::default());
    let cost = ShortestLength::default();
    let end = |step: Option<(_, f64)>| step.map(|(lane, s)| PositionOnLane { lane, s }.into());
    let ends = (
        end(steps.first().map(|step| (step.lane, step.s_from))),
        end(steps.last().map(|step| (step.lane, step.s_to))),
    );
    let (Some(start), Some(goal)) = ends else { return ExitCode::from(1) };
    let (starts, goals) = (&[start], &[goal]);
    let request = RouteRequest { starts, goals, vehicle, cost: &cost, avoid: &[] };
    let mut hint = None;
    for i in 0..count {
        match kind.as_str() {
            "project" => {
                hint = path.project(points[i % points.len()], hint).ok().map(|own| own.along);
                black_box(hint);
            }
            "project-batch" => {
                let places = Places { x: &x, y: &y, ..Places::default() };
                black_box(path.project_batch(places, &mut feet).ok());
            }
            "at" => {
                black_box(path.at(path.length() * (i % POINTS) as f64 / POINTS as f64).ok());
            }
            "build" => {
                black_box(map.path(&steps, &options, &mut other).map(|_| ()).ok());
            }
            "corridor" | "surface" => {
                black_box(path.corridor(0.0, ROOM, 1.0, vehicle, &mut room).ok());
                if kind == "surface" {
                    black_box(path.corridor_surface(&mut room).ok());
                }
            }
            "segments" => path.segments(vehicle, &mut segments),
            "conflicts" => path.conflicts(&mut conflicts, &mut met),
            "request" => {
                black_box(map.find_route(&request, &mut scratch, &mut steps).ok());
            }
            "alternatives" => {
                let options = AlternativeOptions::default();
                black_box(map.alternatives(&request, &options, &mut scratch, &mut routes).ok());
            }
            "reach" => {
                black_box(map.reach(&request, LENGTH, &mut scratch, &mut reach).ok());
            }
            _ => {}
        }
    }
    ExitCode::SUCCESS
}
