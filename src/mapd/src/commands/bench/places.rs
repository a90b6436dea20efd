//! What is asked: places on the map, the same in every run.

use mapd_client::route::PositionOnLane;
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Map, Point, Track, glam::DVec2};

/// Step along a road of the queries that follow a trajectory `[m]`: 20 ms at 25 m/s.
const STEP: f64 = 0.5;

/// Offset of a trajectory from the reference line `[m]`: in the first lane of most roads with right-hand traffic.
const OFFSET: f64 = -1.5;

/// Queries at random lie at most so far from the reference line `[m]`.
const SPREAD: f64 = 4.0;

/// Roads shorter than this have no trajectory `[m]`.
const SHORTEST: f64 = 1.0;

/// A place beside a road: row of the road, place on it, position in the plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoadPoint {
    pub(crate) road: u32,
    pub(crate) track: Track,
    pub(crate) position: DVec2,
}

impl RoadPoint {
    /// The position as queries take it.
    pub(crate) fn point(&self) -> Point {
        self.position.into()
    }
}

/// So many places, at random over the map or in small steps along roads; none on a map without roads.
pub(crate) fn places(map: Map<'_>, along: bool, count: usize) -> Vec<RoadPoint> {
    let roads: Vec<_> = map.roads().filter(|road| road.length() > SHORTEST).collect();
    let mut random = Random::default();
    let mut places = Vec::with_capacity(count);
    // Roads whose places cannot be computed are passed over; a map of nothing else ends the search.
    let mut misses = 0;
    while places.len() < count && misses < count.saturating_add(roads.len()) && !roads.is_empty() {
        let Some(road) = roads.get(random.below(roads.len())) else { break };
        let before = places.len();
        let steps = if along { (road.length() / STEP) as usize } else { 1 };
        for step in 0..steps.min(count - before) {
            let (s, t) = if along {
                (step as f64 * STEP, OFFSET)
            } else {
                (random.unit() * road.length(), (2.0 * random.unit() - 1.0) * SPREAD)
            };
            let track = Track { s, t, h: 0.0 };
            if let Ok(pose) = road.to_inertial(track) {
                let position = pose.position.truncate();
                places.push(RoadPoint { road: road.road_id().row(), track, position });
            }
        }
        if places.len() == before {
            misses += 1;
        }
    }
    places
}

/// Ends of so many routes, on lanes that are open to cars; none on a map without such lanes.
pub(crate) fn ends(map: Map<'_>, count: usize) -> Vec<[PositionOnLane; 2]> {
    let car = VehicleClass::PassengerCar;
    let open = |lane: &mapd_client::Lane<'_>| lane.nodes().any(|node| node.allows(car));
    let lanes: Vec<_> = map.lanes().filter(open).collect();
    let mut random = Random::default();
    let mut place = || {
        let lane = lanes.get(random.below(lanes.len()))?;
        let section = lane.section();
        let s = section.s_start() + random.unit() * (section.s_end() - section.s_start());
        Some(PositionOnLane { lane: lane.lane_id(), s })
    };
    (0..count).map_while(|_| Some([place()?, place()?])).collect()
}

/// Numbers that look random (xorshift64), the same in every run.
struct Random(u64);

impl Default for Random {
    fn default() -> Self {
        Self(7)
    }
}

impl Random {
    /// In [0, 1).
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// In 0..n; 0 where n is 0.
    fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }
}
