//! Cross-sections of roads: the reference line at each, and how high, how rolled and how wide the road is.
//!
//! Many roads are as high and as wide everywhere. Their cross-sections share one [`Profile`].

use super::{Network, RoadFacts, rows};

/// A cross-section of a road.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Distance along the reference line `[m]`.
    pub s: f64,
    /// Reference line: x `[m]`.
    pub x: f64,
    /// Reference line: y `[m]`.
    pub y: f64,
    /// Reference line: heading `[rad]`, continuous along the road as far as the file has it so.
    pub hdg: f64,
    /// Reference line: z `[m]`.
    pub z: f64,
    /// Superelevation `[rad]`.
    pub roll: f64,
    /// t of the outermost border to the left `[m]`.
    pub left: f64,
    /// t of the outermost border to the right `[m]`.
    pub right: f64,
}

impl Station {
    /// Linear between two.
    pub fn between(&self, other: &Self, s: f64) -> Self {
        let span = other.s - self.s;
        let part = if span > 0.0 { (s - self.s) / span } else { 0.0 };
        let part = mapd_geometry::clamp(part, 0.0, 1.0);
        let mix = |a: f64, b: f64| a + part * (b - a);
        Self {
            s: mix(self.s, other.s),
            x: mix(self.x, other.x),
            y: mix(self.y, other.y),
            hdg: mix(self.hdg, other.hdg),
            z: mix(self.z, other.z),
            roll: mix(self.roll, other.roll),
            left: mix(self.left, other.left),
            right: mix(self.right, other.right),
        }
    }

    /// The point at a lateral distance `[m]`.
    pub fn at(&self, t: f64) -> [f64; 2] {
        let (cos, sin) = mapd_geometry::cos_sin(self.hdg);
        [self.x - t * sin, self.y + t * cos]
    }

    /// The points at the outermost borders: left, right `[m]`.
    pub fn ends(&self) -> [[f64; 2]; 2] {
        let (cos, sin) = mapd_geometry::cos_sin(self.hdg);
        [self.left, self.right].map(|t| [self.x - t * sin, self.y + t * cos])
    }

    pub(super) fn split(&self) -> (OnLine, Profile) {
        let Self { s, x, y, hdg, z, roll, left, right } = *self;
        (OnLine { s, x, y, hdg }, Profile { z, roll, left, right })
    }
}

/// A place on a reference line.
#[derive(Clone, Copy, Debug)]
pub(super) struct OnLine {
    s: f64,
    x: f64,
    y: f64,
    hdg: f64,
}

/// Height, roll and width of a road.
#[derive(Clone, Copy, Debug)]
pub(super) struct Profile {
    z: f64,
    roll: f64,
    left: f64,
    right: f64,
}

impl Profile {
    /// Whether two are the same, bit by bit.
    pub(super) fn is(&self, other: &Self) -> bool {
        let bits = |p: &Self| [p.z, p.roll, p.left, p.right].map(f64::to_bits);
        bits(self) == bits(other)
    }
}

/// The cross-sections of a road, by s.
#[derive(Clone, Copy, Debug)]
pub struct Stations<'a> {
    lines: &'a [OnLine],
    /// One for each of them, or one for all.
    profiles: &'a [Profile],
}

impl<'a> Stations<'a> {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    /// Whether there are none: the reference line cannot be built.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// The one of a number, from 0.
    pub fn get(&self, number: usize) -> Option<Station> {
        let OnLine { s, x, y, hdg } = *self.lines.get(number)?;
        let Profile { z, roll, left, right } =
            *self.profiles.get(number.min(self.profiles.len().checked_sub(1)?))?;
        Some(Station { s, x, y, hdg, z, roll, left, right })
    }

    /// The first one.
    pub fn first(&self) -> Option<Station> {
        self.get(0)
    }

    /// The last one.
    pub fn last(&self) -> Option<Station> {
        self.get(self.len().checked_sub(1)?)
    }

    /// All of them.
    pub fn iter(self) -> impl Iterator<Item = Station> + use<'a> {
        (0..self.len()).filter_map(move |number| self.get(number))
    }

    /// Each with the next one.
    pub fn pairs(self) -> impl Iterator<Item = (Station, Station)> + use<'a> {
        self.iter().zip(self.iter().skip(1))
    }

    /// The cross-section at `s` `[m]`, between those that are kept linear.
    pub fn over(&self, s: f64) -> Option<Station> {
        let after = self.lines.partition_point(|line| line.s <= s);
        let (a, b) = (self.get(after.saturating_sub(1))?, self.get(after));
        Some(b.map_or(a, |b| a.between(&b, s)))
    }
}

impl Network {
    /// Cross-sections of a road by s.
    pub fn stations_of(&self, road: &RoadFacts) -> Stations<'_> {
        let lines = rows(&self.lines, &road.stations);
        Stations { lines, profiles: rows(&self.profiles, &road.profiles) }
    }

    /// The cross-section of a road at `s` `[m]`, between those that are kept linear. None where the road has none.
    pub fn station_at(&self, road: &RoadFacts, s: f64) -> Option<Station> {
        self.stations_of(road).over(s)
    }
}
