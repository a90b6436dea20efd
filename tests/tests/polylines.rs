//! Polylines never lie farther from the exact lines than the options say: dense comparison, several tolerances.

use mapd_client::glam::DVec3;
use mapd_client::{Lane, Polyline, Snapshot, Track};
use mapd_compiler::{CompileOptions, compile};
use mapd_tests::maps::carried_and;
use std::path::Path;

/// Maps besides the carried ones.
const MAPS: [&str; 12] = [
    "carla/Town05",
    "Scenic/Town07",
    "Scenic/Issue295a",
    "Scenic/Issue189",
    "esmini/velodrome",
    "esmini/soderleden",
    "esmini/multi_intersections",
    "esmini/tunnels",
    "drone_dataset/rdb2",
    "gdal/5g_living_lab_A39_Wolfsburg-West",
    "maliput_malidrive/ParametricCubicCurveComplexRoad",
    "sumo/adlershof_dlr_netconvert",
];
/// Places compared between two points of a polyline.
const PLACES: usize = if cfg!(debug_assertions) { 7 } else { 31 };
/// Tolerances of centre lines and borders `[m]`: the default, a finer and a coarser pair.
const TOLERANCES: [(f64, f64); 3] = [(0.05, 0.01), (0.01, 0.002), (0.5, 0.1)];
/// Single precision of points relative to their lane's origin, as a share of the lane's size.
const ROUNDING: f64 = f32::EPSILON as f64;

fn open(path: &Path, index_tolerance: f64, bound_tolerance: f64) -> Snapshot {
    let options = CompileOptions { index_tolerance, bound_tolerance, ..CompileOptions::default() };
    let file = std::fs::File::open(path).expect("the map can be read");
    let compiled = compile(file, &options, &mut |_| {}).expect("reading works");
    let rows = compiled.rows.expect("the map is accepted");
    let bytes = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    Snapshot::from_bytes(bytes).expect("opens")
}

fn distance(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let along = b - a;
    let squared = along.length_squared();
    let share = if squared > 0.0 { (point - a).dot(along) / squared } else { 0.0 };
    point.distance(a + along * mapd_geometry::clamp(share, 0.0, 1.0))
}

/// Largest distance of the exact line from its polyline, less what single precision explains.
fn worst(lane: &Lane<'_>, line: Polyline<'_>, exact: impl Fn(f64) -> DVec3) -> f64 {
    let end = lane.section().s_end();
    let mut worst = 0f64;
    for i in 1..line.len() {
        let (a, b) = (line.position(i - 1).expect("a point"), line.position(i).expect("a point"));
        let from = line.s_start + f64::from(line.points[i - 1].s());
        let to = (line.s_start + f64::from(line.points[i].s())).min(end);
        // Both sides of a jump.
        if to <= from {
            continue;
        }
        let origin = line.origin;
        let rounding =
            (a.distance(origin).max(b.distance(origin)) + to - line.s_start) * 2.0 * ROUNDING;
        for place in 0..=PLACES {
            // Where records begin, stored s is rounded: what is asked lies well within.
            let share = (place as f64 + 0.5) / (PLACES + 1) as f64;
            let point = exact(from + (to - from) * share);
            worst = worst.max(distance(point, a, b) - rounding);
        }
    }
    worst
}

#[test]
fn no_polyline_exceeds_its_tolerance() {
    for path in carried_and(&MAPS) {
        for (center, bound) in TOLERANCES {
            let snapshot = open(&path, center, bound);
            let mut compared = 0;
            for row in 0..snapshot.map().tables().lanes.len() as u32 {
                let lane = snapshot.map().lane_by_row(row).expect("a lane");
                let road = lane.road();
                let at = |s: f64, t: f64| {
                    road.to_inertial(Track { s, t, h: 0.0 }).expect("a pose").position
                };
                let centers =
                    worst(&lane, lane.center_line(), |s| at(s, lane.edges_at(s).center()));
                let bounds = worst(&lane, lane.border(), |s| at(s, lane.edges_at(s).outer));
                for (name, off, limit) in
                    [("centre line", centers, center), ("border", bounds, bound)]
                {
                    assert!(
                        off <= limit,
                        "{}: {} of {} is {off} m off, allowed {limit}",
                        path.display(),
                        name,
                        lane.key()
                    );
                }
                compared += lane.border().len();
            }
            assert!(compared > 0, "{}", path.display());
        }
    }
}
