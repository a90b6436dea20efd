//! Questions about places: batches, matches, marks, heights.

use mapd_client::batch::{BatchScratch, NearestLanes, Places, Poses, TrackPositions, Tracks};
use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::localisation::{
    GroundScratch, MarkFilter, MatchOptions, Sensor, TraceFix, TraceOptions, TraceScratch, Tracker,
    TrackerFix, TrackerOptions, VehicleOutline, VehiclePose,
};
use mapd_client::vocabulary::ClassSet;
use mapd_client::{Map, NearestOptions, Point, Region};

/// From one place of the map to the next, where something is.
const STEP: f64 = 15.0;
/// Places of batches and drives.
const COUNT: usize = 5;

/// A heading and a height pass few places, which are then looked for.
fn picky() -> NearestOptions {
    NearestOptions {
        radius: 30.0,
        heading: Some(2.0),
        heading_tolerance: Some(0.2),
        z_tolerance: Some(0.5),
        ..NearestOptions::default()
    }
}

pub(super) fn ask(map: Map<'_>) {
    let flat: Vec<DVec2> = (0..COUNT).map(|i| DVec2::new(STEP * i as f64, 1.0)).collect();
    let points: Vec<Point> = flat.iter().map(|at| Point::from(at.extend(0.3))).collect();
    let (x, y): (Vec<f64>, Vec<f64>) = flat.iter().map(|at| (at.x, at.y)).unzip();
    let places = Places { x: &x, y: &y, ..Places::default() };
    let (mut scratch, mut lanes) = (BatchScratch::default(), NearestLanes::default());
    let _ = map.nearest_lanes(places, &NearestOptions::default(), &mut scratch, &mut lanes);
    let _ = map.nearest_lanes(places, &picky(), &mut scratch, &mut lanes);
    let mut near = Vec::new();
    for point in &points {
        let _ = map.lanes_near(*point, &picky(), &mut near);
        let _ = map.nearest_lane(*point, &picky());
    }
    let (mut feet, mut poses) = (TrackPositions::default(), Poses::default());
    for road in map.roads().take(super::FEW) {
        let _ = road.to_track_batch(places, &mut feet);
        let tracks = Tracks { s: &feet.s, t: &feet.t, h: None };
        let _ = road.to_inertial_batch(tracks, &mut poses);
    }
    let (mut ground, mut grounds) = (GroundScratch::default(), Vec::new());
    let _ = map.ground_below(&points, &[], &mut ground, &mut grounds);
    let wheels = [[2.7, 0.8], [2.7, -0.8], [0.0, 0.8], [0.0, -0.8]].map(DVec2::from);
    let pose = VehiclePose { position: points[1], heading: 0.3 };
    let _ = map.ground_at(pose.position, &[], &mut ground);
    let _ = map.stance(&pose, &wheels, &[], &mut ground);
    let sensor = Sensor { position: flat[0], heading: 0.5, range: 200.0, field_of_view: 6.2 };
    let _ = map.landmarks_in_view(&sensor, ClassSet::ALL, &mut Vec::new());
    let (filter, region) = (MarkFilter::default(), Region::around(flat[1], 40.0));
    let _ = map.nearest_marks(&flat, &filter, &mut Vec::new());
    let _ = map.nearest_mark(flat[2], &filter);
    let _ = map.mark_points(region, 0.5, &filter, &mut Vec::new());
    matches(map, &pose, &points);
}

fn matches(map: Map<'_>, pose: &VehiclePose, points: &[Point]) {
    let outline = VehicleOutline { front: 3.6, back: 1.0, left: 0.9, right: 0.9 };
    let thin = DMat3::from_diagonal(DVec3::new(4.0, 0.01, 0.1));
    for (outline, covariance) in [(None, DMat3::IDENTITY), (Some(outline), thin)] {
        let options = MatchOptions { outline, ..MatchOptions::default() };
        let _ = map.match_pose(pose, &covariance, &options, &mut Vec::new());
    }
    let fix = |(i, position): (usize, &Point)| TraceFix {
        time: i as f64,
        position: *position,
        heading: Some(0.1),
    };
    let fixes: Vec<TraceFix> = points.iter().enumerate().map(fix).collect();
    let mut scratch = TraceScratch::default();
    let _ = map.match_trace(&fixes, &TraceOptions::default(), &mut scratch, &mut Vec::new());
    let mut tracker = Tracker::new();
    for TraceFix { time, position, .. } in fixes {
        let pose = VehiclePose { position, heading: 0.1 };
        let fix = TrackerFix { time, pose, covariance: DMat3::IDENTITY, odometer: None };
        let _ = tracker.update(map, &fix, &TrackerOptions::default());
    }
}
