//! What a planner's process has of mapd: the client alone, in a profile that says nothing of code generation. Its binary asks queries
//! from outside of the crates that answer them, and its instructions are counted.

use mapd_client::Map;
use mapd_client::glam::DVec2;

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
