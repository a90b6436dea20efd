//! Cross-sections of roads: the reference line at each, and how high, how rolled and how wide the road is.
//!
//! Many roads are as high and as wide everywhere. Their cross-sections share one [`Profile`]. Of roads that are straight, the
//! cross-sections between the first and the last one are computed when they are asked for.

use super::{Network, RoadFacts, rows};

/// Cross-sections are this far apart at most `[m]`.
pub(super) const STATION_STEP: f64 = 10.0;

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
        let [point] = self.all_at([t]);
        point
    }

    /// The points at lateral distances `[m]`.
    pub(crate) fn all_at<const N: usize>(&self, t: [f64; N]) -> [[f64; 2]; N] {
        let (cos, sin) = mapd_geometry::cos_sin(self.hdg);
        t.map(|t| [self.x - t * sin, self.y + t * cos])
    }

    /// The points at the outermost borders: left, right `[m]`.
    pub(super) fn ends(&self, heading: &mut Heading) -> [[f64; 2]; 2] {
        let (cos, sin) = heading.cos_sin(self.hdg);
        [self.left, self.right].map(|t| [self.x - t * sin, self.y + t * cos])
    }

    pub(super) fn split(&self) -> (OnLine, Profile) {
        let Self { s, x, y, hdg, z, roll, left, right } = *self;
        (OnLine { s, x, y, hdg }, Profile { z, roll, left, right })
    }
}

/// The heading that was asked for last: along straight roads it stays the same.
pub(super) struct Heading {
    hdg: u64,
    cos_sin: (f64, f64),
}

impl Default for Heading {
    fn default() -> Self {
        Self { hdg: 0.0_f64.to_bits(), cos_sin: (1.0, 0.0) }
    }
}

impl Heading {
    /// Cosine and sine of a heading `[rad]`.
    fn cos_sin(&mut self, hdg: f64) -> (f64, f64) {
        if hdg.to_bits() != self.hdg {
            *self = Self { hdg: hdg.to_bits(), cos_sin: mapd_geometry::cos_sin(hdg) };
        }
        self.cos_sin
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

impl OnLine {
    /// The place of a number on a straight line from here in a direction.
    fn straight_on(&self, (cos, sin): (f64, f64), number: usize) -> Self {
        let s = number as f64 * STATION_STEP;
        Self { s, x: self.x + cos * s, y: self.y + sin * s, hdg: self.hdg }
    }

    fn bits(&self) -> [u64; 4] {
        [self.s, self.x, self.y, self.hdg].map(f64::to_bits)
    }

    /// Whether the first and the last of these places tell all others, bit by bit.
    pub(super) fn are_straight(places: &[Self]) -> bool {
        let [first, between @ .., last] = places else { return false };
        let is_even = |place: &Self| place.hdg.to_bits() == first.hdg.to_bits();
        if first.s.to_bits() != 0
            || !between.first().is_some_and(is_even)
            || places.len() != straight_count(last)
        {
            return false;
        }
        let direction = mapd_geometry::cos_sin(first.hdg);
        let is_straight_on = |(number, place): (usize, &Self)| {
            first.straight_on(direction, number + 1).bits() == place.bits()
        };
        between.iter().enumerate().all(is_straight_on)
    }
}

/// How many cross-sections a straight road has that ends here.
fn straight_count(last: &OnLine) -> usize {
    ((last.s / STATION_STEP).ceil() as usize).saturating_add(1)
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
    /// Each of them, or the first and the last one of a straight road.
    lines: &'a [OnLine],
    /// One for each of them, or one for all.
    profiles: &'a [Profile],
    count: usize,
}

impl<'a> Stations<'a> {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there are none: the reference line cannot be built.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Whether only the ends are kept.
    fn is_straight(&self) -> bool {
        self.count > self.lines.len()
    }

    /// The direction of a road of which only the ends are kept.
    fn direction(&self) -> Option<(f64, f64)> {
        let first = self.lines.first().filter(|_| self.is_straight())?;
        Some(mapd_geometry::cos_sin(first.hdg))
    }

    /// The one of a number, in a direction that is known where it is needed: both ends are kept.
    fn towards(&self, direction: Option<(f64, f64)>, number: usize) -> Option<Station> {
        let line = match direction {
            _ if number >= self.count => return None,
            _ if number + 1 == self.count => *self.lines.last()?,
            Some(direction) if number > 0 => self.lines.first()?.straight_on(direction, number),
            _ => *self.lines.get(number)?,
        };
        let OnLine { s, x, y, hdg } = line;
        let Profile { z, roll, left, right } =
            *self.profiles.get(number.min(self.profiles.len().checked_sub(1)?))?;
        Some(Station { s, x, y, hdg, z, roll, left, right })
    }

    /// The one of a number, from 0.
    pub fn get(&self, number: usize) -> Option<Station> {
        let is_end = number == 0 || number + 1 == self.count;
        self.towards(if is_end { None } else { self.direction() }, number)
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
        let direction = self.direction();
        (0..self.count).filter_map(move |number| self.towards(direction, number))
    }

    /// Each with the next one.
    pub fn pairs(self) -> impl Iterator<Item = [Station; 2]> + use<'a> {
        let mut before = None;
        self.iter().filter_map(move |station| Some([before.replace(station)?, station]))
    }

    /// s of the one of a number `[m]`.
    fn s_of(&self, number: usize) -> f64 {
        let kept = match self.is_straight() {
            true if number + 1 < self.count => return number as f64 * STATION_STEP,
            true => self.lines.last(),
            false => self.lines.get(number),
        };
        kept.map_or(0.0, |line| line.s)
    }

    /// The cross-section at `s` `[m]`, between those that are kept linear.
    pub fn over(&self, s: f64) -> Option<Station> {
        let (mut after, mut end) = (0, self.count);
        while after < end {
            let middle = after.midpoint(end);
            if self.s_of(middle) <= s {
                after = middle + 1;
            } else {
                end = middle;
            }
        }
        let a = self.get(after.saturating_sub(1))?;
        let b = if s > a.s { self.get(after) } else { None };
        Some(b.map_or(a, |b| a.between(&b, s)))
    }
}

impl Network {
    /// Cross-sections of a road by s.
    pub fn stations_of(&self, road: &RoadFacts) -> Stations<'_> {
        let lines = rows(&self.lines, &road.stations);
        let profiles = rows(&self.profiles, &road.profiles);
        let straight = lines.last().filter(|_| road.is_straight).map(straight_count);
        Stations { lines, profiles, count: straight.unwrap_or(lines.len()) }
    }

    /// The cross-section of a road at `s` `[m]`, between those that are kept linear. None where the road has none.
    pub fn station_at(&self, road: &RoadFacts, s: f64) -> Option<Station> {
        self.stations_of(road).over(s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Straight or not, all cross-sections are those that were put in; a road that only looks straight is kept whole.
    #[test]
    fn straight_roads_are_what_they_were() {
        let profile = Profile { z: 1.0, roll: 0.0, left: 3.0, right: -3.0 };
        let direction = mapd_geometry::cos_sin(0.7);
        let first = OnLine { s: 0.0, x: 1e6, y: -3.0, hdg: 0.7 };
        for (length, is_bent) in [(95.5, false), (100.0, false), (11.0, false), (95.5, true)] {
            let inside = (1..).take_while(|number| *number as f64 * STATION_STEP < length);
            let mut all: Vec<OnLine> =
                inside.map(|number| first.straight_on(direction, number)).collect();
            if is_bent && let Some(middle) = all.get_mut(4) {
                middle.y += 1e-9;
            }
            all.insert(0, first);
            let (cos, sin) = direction;
            let (x, y) = (first.x + cos * length, first.y + sin * length);
            all.push(OnLine { s: length, x, y, hdg: 0.7 });
            assert_eq!(OnLine::are_straight(&all), !is_bent, "{length} m");
            let kept = if is_bent { all.clone() } else { vec![first, all[all.len() - 1]] };
            let count = if is_bent { kept.len() } else { straight_count(&kept[1]) };
            let stations = Stations { lines: &kept, profiles: &[profile], count };
            let bits: Vec<_> = stations.iter().map(|station| station.split().0.bits()).collect();
            assert_eq!(bits, all.iter().map(OnLine::bits).collect::<Vec<_>>(), "{length} m");
            for (number, line) in all.iter().enumerate() {
                let own = stations.get(number).map(|station| station.split().0.bits());
                assert_eq!(own, Some(line.bits()), "{number} of {length} m");
                let over = stations.over(line.s).map(|station| station.s);
                assert_eq!(over, Some(line.s), "{number} of {length} m");
            }
            assert!(stations.get(count).is_none());
            assert_eq!(stations.pairs().count() + 1, count);
        }
    }
}
