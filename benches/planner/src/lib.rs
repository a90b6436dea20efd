//! What a planner's process has of mapd: the client alone, in a profile that says nothing of code generation. Its binaries ask queries
//! from outside of the crates that answer them, and their instructions are counted.

use mapd_client::glam::DVec2;
use mapd_client::route::{PositionOnLane, RouteScratch, RouteStep, ShortestLength};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Lane, Map};

/// A xorshift generator: the same numbers on every machine.
pub struct Random(pub u64);

impl Random {
    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Places on roads: (road row, s, t), at random over the map, or in small steps along roads.
pub fn places(map: Map<'_>, along: bool, count: usize) -> Vec<(u32, f64, f64)> {
    let mut random = Random(7);
    let roads: Vec<_> = map.roads().filter(|road| road.length() > 1.0).collect();
    let mut places = Vec::new();
    while places.len() < count {
        let road = &roads[(random.unit() * roads.len() as f64) as usize];
        let row = road.road_id().row();
        if along {
            let steps = (road.length() / 0.5) as usize;
            places.extend((0..steps).map(|i| (row, i as f64 * 0.5, -1.5)));
        } else {
            places.push((row, random.unit() * road.length(), random.unit() * 8.0 - 4.0));
        }
    }
    places.truncate(count);
    places
}

/// Particles of a [`cloud`].
pub const PARTICLES: usize = 5_000;
/// Radius of a [`cloud`] `[m]`.
const CLOUD: f64 = 5.0;

/// Particles of a filter around a place, evenly over a circle.
pub fn cloud(middle: DVec2, count: usize) -> Vec<DVec2> {
    let mut random = Random(3);
    let mut particles = Vec::with_capacity(count);
    while particles.len() < count {
        let away = DVec2::new(random.unit(), random.unit()) * 2.0 - 1.0;
        if away.length() <= 1.0 {
            particles.push(middle + CLOUD * away);
        }
    }
    particles
}

/// Places that a long way leads over at most.
const MOST_PLACES: usize = 400;

/// The steps of a passenger car's route over random places that is at least so long `[m]`; none where some hundred places are not enough.
pub fn long_way(map: Map<'_>, length: f64, scratch: &mut RouteScratch) -> Option<Vec<RouteStep>> {
    let car = VehicleClass::PassengerCar;
    let open = |lane: &Lane<'_>| lane.nodes().any(|node| node.allows(car));
    let lanes: Vec<Lane<'_>> = map.lanes().filter(open).collect();
    let mut random = Random(5);
    let (mut places, mut steps) = (Vec::new(), Vec::new());
    let cost = ShortestLength::default();
    for _ in 0..MOST_PLACES {
        let lane = &lanes[(random.unit() * lanes.len() as f64) as usize];
        let section = lane.section();
        let s = 0.5 * (section.s_start() + section.s_end());
        places.push(PositionOnLane { lane: lane.lane_id(), s });
        if places.len() < 2 {
            continue;
        }
        let found = map.route_via(&places, car, &cost, scratch, &mut steps);
        match found.expect("an answer") {
            Some(route) if route.length >= length => return Some(steps),
            Some(_) => {}
            None => {
                places.pop();
            }
        }
    }
    None
}
