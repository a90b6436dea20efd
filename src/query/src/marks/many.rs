//! The nearest marks to many points: what may be nearest to points near each other is found once for all of them.

use super::search::{Candidate, Search, courses_near, shift};
use super::{MarkFilter, NearMark};
use crate::batch::curve_key;
use crate::map::Map;
use glam::DVec2;

/// Points that are ordered at once, in the stack's memory.
const RUN: usize = 1024;
/// Fewer points than this are asked one by one.
const FEWEST: usize = 4;
/// Largest extent of a tile along x and y `[m]`.
const EXTENT: f64 = 2.5;
/// Courses of a tile at most; points with more around them are asked one by one.
const MOST_COURSES: usize = 48;
/// What rounding makes of distances `[m]`, and more.
const SLACK: f64 = 1e-6;

/// Answers for all points, which are finite.
pub(super) fn answer(
    map: Map<'_>,
    points: &[DVec2],
    filter: &MarkFilter,
    out: &mut [Option<NearMark>],
) {
    let shift = shift(map);
    let mut tile = Tile { map, courses: [const { None }; MOST_COURSES], count: 0 };
    for (points, out) in points.chunks(RUN).zip(out.chunks_mut(RUN)) {
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for point in points {
            (low, high) = (low.min(*point), high.max(*point));
        }
        let mut keys = [0u64; RUN];
        let Some(keys) = keys.get_mut(..points.len()) else { continue };
        for (i, (key, point)) in keys.iter_mut().zip(points).enumerate() {
            *key = u64::from(curve_key(*point, low, high)) << 32 | i as u64;
        }
        keys.sort_unstable();
        let place = |key: &u64| points.get(*key as u32 as usize).copied().unwrap_or(DVec2::NAN);
        let mut left: &[u64] = keys;
        while let Some(key) = left.first() {
            let (mut low, mut high) = (place(key), place(key));
            let fits = |key: &&u64| {
                (low, high) = (low.min(place(key)), high.max(place(key)));
                (high - low).max_element() <= EXTENT
            };
            let mut count = left.iter().take_while(fits).count().max(1);
            // Where too much lies around them, half of them may have less.
            let mut is_tile =
                count >= FEWEST && tile.fill(bounds(left, count, place), filter, shift);
            while !is_tile && count >= 2 * FEWEST {
                count /= 2;
                is_tile = tile.fill(bounds(left, count, place), filter, shift);
            }
            let (own, rest) = left.split_at(count);
            left = rest;
            let origin = map.origin();
            for key in own {
                let local = place(key) - origin;
                let mut search = Search::new(map, filter);
                match is_tile {
                    true => tile.ask(local, &mut search),
                    false => search.everywhere(local),
                }
                if let Some(out) = out.get_mut(*key as u32 as usize) {
                    *out = search.found(local);
                }
            }
        }
    }
}

/// The box around the first few places.
fn bounds(keys: &[u64], count: usize, place: impl Fn(&u64) -> DVec2) -> [DVec2; 2] {
    let empty = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    let around = |[low, high]: [DVec2; 2], at: DVec2| [low.min(at), high.max(at)];
    keys.iter().take(count).map(place).fold(empty, around)
}

/// What may be nearest to one of several points near each other.
struct Tile<'m> {
    map: Map<'m>,
    /// With the distance of each from the tile's middle `[m]`, less what the points are away from that: none of them is nearer.
    courses: [Option<(f64, Candidate<'m>)>; MOST_COURSES],
    count: usize,
}

impl<'m> Tile<'m> {
    /// Finds what may be nearest to a point in a box; whether everything has room.
    fn fill(&mut self, [low, high]: [DVec2; 2], filter: &MarkFilter, shift: f64) -> bool {
        self.count = 0;
        let (low, high) = (low - self.map.origin(), high - self.map.origin());
        let (middle, around) = (0.5 * (low + high), 0.5 * (high - low).length() + SLACK);
        let (mut limit, mut fits) = (filter.radius + around, true);
        courses_near(self.map, middle, filter, [limit, shift], &mut |course| {
            let candidate = Candidate::new(course);
            match candidate.form.distance(middle) {
                // Of a course that is searched nothing is known for sure: every point asks it.
                None => fits &= self.add(f64::NEG_INFINITY, candidate, limit - around),
                Some(distance) if distance <= limit => {
                    // What is farther from the middle than this one by the tile's size is farther from every point.
                    limit = limit.min(distance + 2.0 * around);
                    fits &= self.add(distance - around, candidate, limit - around);
                }
                Some(_) => {}
            }
            // Without room it is in vain.
            if fits { limit } else { f64::NEG_INFINITY }
        });
        if fits {
            self.keep(limit - around);
            self.sort();
        }
        fits
    }

    /// Whether there is room; what has turned out to be too far makes some.
    fn add(&mut self, least: f64, candidate: Candidate<'m>, limit: f64) -> bool {
        if self.count == MOST_COURSES {
            self.keep(limit);
        }
        let Some(place) = self.courses.get_mut(self.count) else { return false };
        *place = Some((least, candidate));
        self.count += 1;
        true
    }

    /// Leaves out what is farther than a limit.
    fn keep(&mut self, limit: f64) {
        let mut kept = 0;
        for i in 0..self.count {
            let Some(Some((least, _))) = self.courses.get(i) else { continue };
            if *least <= limit {
                self.courses.swap(kept, i);
                kept += 1;
            }
        }
        self.count = kept;
    }

    /// What may be nearest comes first.
    fn sort(&mut self) {
        let least = |of: &Option<(f64, Candidate<'m>)>| of.as_ref().map_or(f64::INFINITY, |c| c.0);
        if let Some(all) = self.courses.get_mut(..self.count) {
            all.sort_unstable_by(|a, b| least(a).total_cmp(&least(b)));
        }
    }

    fn ask(&self, local: DVec2, search: &mut Search<'m, '_>) {
        for (least, candidate) in self.courses.iter().take(self.count).flatten() {
            if *least > search.limit() {
                break;
            }
            search.consider(*candidate, local);
        }
    }
}
