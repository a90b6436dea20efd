//! The packed index against rstar, and the nearest lane against looking at every lane.

use mapd_client::Bounds;
use mapd_client::NearestOptions;
use mapd_client::compiling::nearest_segment;
use mapd_tests::maps::{Random, carried_and, open};
use rstar::primitives::{GeomWithData, Line};
use rstar::{PointDistance, RTree};
use std::path::PathBuf;

/// Points per map for the index.
const POINTS: usize = 20_000;
/// Points per map for the nearest lane; each looks at every lane.
const LANE_POINTS: usize = 300;
/// Farthest search `[m]`.
const RADIUS: f64 = 200.0;

fn maps() -> Vec<PathBuf> {
    carried_and(&["carla/Town05", "Scenic/Issue295a", "esmini/velodrome"])
}

#[test]
fn the_packed_index_finds_what_rstar_finds() {
    for path in maps() {
        let snapshot = open(&path);
        let map = snapshot.map();
        let mut segments = Vec::new();
        for lane in map.lanes() {
            let line = lane.center_line();
            for i in 1..line.len() {
                let (a, b) =
                    (line.position(i - 1).expect("a point"), line.position(i).expect("a point"));
                if line.station(i - 1) != line.station(i) {
                    segments.push(GeomWithData::new(
                        Line::new([a.x, a.y], [b.x, b.y]),
                        lane.lane_id().row(),
                    ));
                }
            }
        }
        let tree = RTree::bulk_load(segments);
        let Bounds { low, high } = map.bounds();
        let size = (high - low).truncate().length()
            + low.truncate().abs().max(high.truncate().abs()).max_element();
        // Single precision: the distance in the leaf's frame, and the point on the map. And both ends of a segment are off by
        // half a step along each axis, or by one and a half of them where they would be the same.
        let steps = map.tables().index_leaves.iter().map(|leaf| f64::from(leaf.step()));
        let step = steps.fold(0.0, f64::max);
        let tolerance = 1e-5 + size * f64::from(f32::EPSILON) + 1.6 * step;
        assert!(step < 0.05, "{}: steps of {step} m", path.display());
        let mut random = Random(1);
        let mut found = 0;
        for _ in 0..POINTS {
            let point = random.point(map);
            let nearest = tree.nearest_neighbor([point.x, point.y]).expect("the map has lanes");
            let expected = nearest.distance_2(&[point.x, point.y]).sqrt();
            match nearest_segment(map, point, RADIUS) {
                Some(hit) => {
                    let error = (f64::from(hit.distance) - expected).abs();
                    assert!(
                        error <= tolerance,
                        "{}: {point} expected {expected}, found {hit:?}",
                        path.display()
                    );
                    found += 1;
                }
                None => assert!(
                    expected > RADIUS - tolerance,
                    "{}: {point} missed {expected}",
                    path.display()
                ),
            }
        }
        assert!(found > POINTS / 2, "{}: only {found} points were near the map", path.display());
    }
}

#[test]
fn the_nearest_lane_is_the_nearest_of_all() {
    let options = NearestOptions { radius: 50.0, ..NearestOptions::default() };
    for path in maps() {
        let snapshot = open(&path);
        let map = snapshot.map();
        let mut random = Random(2);
        for _ in 0..LANE_POINTS {
            let point = random.point(map);
            let expected = map
                .lanes()
                .map(|lane| lane.position_of(point).expect("a position").distance)
                .fold(f64::INFINITY, f64::min);
            let hit = map.nearest_lane(point, &options).expect("an answer");
            match hit {
                Some(hit) => {
                    let error = (hit.position.distance - expected).abs();
                    assert!(
                        error < 1e-7,
                        "{}: {point}: expected {expected}, found {hit:?}",
                        path.display()
                    );
                }
                None => assert!(
                    expected > options.radius - 1e-7,
                    "{}: {point} missed {expected}",
                    path.display()
                ),
            }
        }
    }
}
