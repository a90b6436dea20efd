//! The search for roads that overlap.
//!
//! Stretches are sorted into cells, each cell's by road, and its roads by where they begin along x: those that lie apart are
//! never compared. What is left are roads that do lie over one another, and of these there may be as many pairs as the square of
//! their number. So pairs and steps have bounds that grow with the file; beyond them the search ends and says so.

use super::overlap::{CLEARANCE, Members, Overlap, Overlaps, TOUCH};
use super::stations::Heading;
use super::stretch::{CrossSection, Stretch, StretchSummary, bounds};
use super::{Name, Network};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

/// Side of the cells in which stretches are sorted `[m]`: about twice a stretch.
const CELL: f64 = 20.0;

/// Cells that one stretch is sorted into at most; wider ones are broken anyway.
const CELLS_OF_A_STRETCH: i64 = 256;

/// The map is looked at in strips along y, so that only one strip's stretches are held: so many strips at most.
const STRIPS: usize = 32;

/// Stretches that one strip has at least, unless the map has fewer.
const STRETCHES_OF_A_STRIP: usize = 1 << 15;

/// Pairs of roads of which it is remembered that their overlaps tell nothing; of others it is looked up for each pair of stretches.
const REMEMBERED: usize = 1 << 20;

/// Stretches of one road that are nearer along it than this are neighbors, however wide it is `[m]`.
const NEAR: f64 = 30.0;

/// Pairs of roads that overlap: so many are told of a map at least.
const PAIRS: usize = 1 << 16;

/// Pairs of roads that overlap which are told for each road of a map, beyond [`PAIRS`].
const PAIRS_OF_A_ROAD: usize = 16;

/// Steps that the search takes at most, as looks at two boxes: so many in any map, some tenths of a second.
const STEPS: u64 = 1 << 25;

/// Steps that the search takes at most for each stretch, beyond [`STEPS`]; in maps of cities they are some hundred.
const STEPS_OF_A_STRETCH: u64 = 1 << 12;

/// Steps that comparing two stretches corner by corner counts as.
const STEPS_OF_A_COMPARISON: u64 = 32;

/// What is known of pairs of roads, by their ranks, and how much more may be done.
struct Search<'a> {
    network: &'a Network,
    members: Members,
    found: BTreeMap<(u32, u32), Overlap>,
    /// Those whose overlaps tell nothing: as many as fit.
    expected: BTreeSet<(u32, u32)>,
    most_pairs: usize,
    steps: u64,
    most_steps: u64,
}

/// The stretches of one road in one cell.
struct Run<'a> {
    road: u32,
    junction: Option<Junction>,
    /// In the order of s.
    stretches: &'a [(Cell, u32)],
    /// Around all of them.
    bounds: [f64; 4],
    /// From the lowest to the highest.
    heights: [f64; 2],
}

/// A junction that a road has to do with.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Junction {
    /// By its rank.
    There(u32),
    /// The map does not have it.
    Named(Name),
}

/// Column of a cell, and below it its row, as one number that is sorted at once.
type Cell = u64;

/// The cell of a column and a row.
fn cell(column: i32, row: i32) -> Cell {
    let from_lowest = |number: i32| u64::from(number.abs_diff(i32::MIN));
    from_lowest(column) << u32::BITS | from_lowest(row)
}

/// Number of a column or row. Beyond 32 bits, 40 million kilometres away, all lies in one. (Casts of `clamp`ed numbers lose nothing.)
fn within_32_bits(number: i64) -> i32 {
    number.clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

/// Column or row that a coordinate `[m]` lies in.
fn number(value: f64) -> i64 {
    let number = value / CELL;
    // Rounded down. `floor` would be a call: not every x86-64 has an instruction for it.
    let cut = number as i64;
    cut.saturating_sub(i64::from(cut as f64 > number))
}

/// Column that an x `[m]` lies in.
fn column(x: f64) -> i32 {
    within_32_bits(number(x))
}

/// All overlaps of a network's roads.
pub(super) fn find(network: &Network) -> Overlaps {
    let stretches: usize = network.roads.iter().map(|road| network.stations_of(road).len()).sum();
    let mut search = Search {
        network,
        members: network.memberships(),
        found: BTreeMap::new(),
        expected: BTreeSet::new(),
        most_pairs: PAIRS + PAIRS_OF_A_ROAD * network.roads.len(),
        steps: 0,
        most_steps: STEPS + STEPS_OF_A_STRETCH * stretches as u64,
    };
    let (mut places, mut cells) = (Vec::new(), Vec::new());
    let strips = network.strips();
    let roads = network.roads_of(&strips);
    for (strip, roads) in strips.iter().zip(&roads) {
        places.clear();
        cells.clear();
        network.sort_into_cells(strip, roads, &mut places, &mut cells);
        cells.sort_unstable();
        let mut runs = Vec::new();
        for cell in cells.chunk_by(|a, b| a.0 == b.0) {
            search.look_in(&places, cell, &mut runs);
        }
    }
    Overlaps {
        is_cut: search.is_cut(),
        work: search.steps,
        pairs: search.found.into_values().collect(),
    }
}

impl<'a> Search<'a> {
    fn is_cut(&self) -> bool {
        self.steps >= self.most_steps || self.found.len() >= self.most_pairs
    }

    fn is_known(&self, pair: (u32, u32)) -> bool {
        self.found.contains_key(&pair) || self.expected.contains(&pair)
    }

    /// Looks for overlaps in a cell; `runs` is room for its roads.
    fn look_in<'c>(
        &mut self,
        places: &[StretchSummary],
        cell: &'c [(Cell, u32)],
        runs: &mut Vec<Run<'c>>,
    ) {
        let road = |entry: &(Cell, u32)| places.get(entry.1 as usize).map(|place| place.road);
        let own = cell.chunk_by(|a, b| road(a) == road(b));
        runs.clear();
        runs.extend(own.filter_map(|run| self.run(places, run)));
        runs.sort_by(|a, b| a.bounds[0].total_cmp(&b.bounds[0]).then(a.road.cmp(&b.road)));
        let ends = ends_of_junctions(runs);
        for (at, run) in runs.iter().enumerate() {
            self.look_along(places, run);
            let mut next = at + 1;
            while let Some(other) = runs.get(next) {
                if self.is_cut() || other.bounds[0] + TOUCH >= run.bounds[2] {
                    break;
                }
                self.steps += 1;
                if run.junction.is_some() && run.junction == other.junction {
                    // What lies over one another at one junction tells nothing.
                    next = ends.get(next).copied().unwrap_or(next + 1);
                    continue;
                }
                if run.may_meet(other) {
                    self.look_between(places, run, other);
                }
                next += 1;
            }
        }
    }

    fn run<'c>(&self, places: &[StretchSummary], stretches: &'c [(Cell, u32)]) -> Option<Run<'c>> {
        let own = || stretches.iter().filter_map(|(_, number)| places.get(*number as usize));
        let StretchSummary { road, bounds, z, .. } = own().next()?;
        let (mut all, mut heights) = (*bounds, [*z; 2]);
        for StretchSummary { bounds: [x0, y0, x1, y1], z, .. } in own() {
            all = [all[0].min(*x0), all[1].min(*y0), all[2].max(*x1), all[3].max(*y1)];
            heights = [heights[0].min(*z), heights[1].max(*z)];
        }
        let known = self.members.first_junction_of(*road).map(Junction::There);
        let named = || self.network.roads.get(*road as usize)?.junction.map(Junction::Named);
        let junction = known.or_else(named);
        Some(Run { road: *road, junction, stretches, bounds: all, heights })
    }

    /// Looks for the first two stretches of a road that overlap and are no neighbors along it.
    fn look_along(&mut self, places: &[StretchSummary], run: &Run<'_>) {
        let Some(length) = self.network.roads.get(run.road as usize).map(|road| road.length) else {
            return;
        };
        let place = |entry: &(Cell, u32)| places.get(entry.1 as usize);
        let s_of = |entry: Option<&(Cell, u32)>| entry.and_then(place).map(|stretch| stretch.s);
        if let (Some(first), Some(last)) = (s_of(run.stretches.first()), s_of(run.stretches.last()))
            && last - first <= NEAR
        {
            // As most do, all lie near each other.
            self.steps += run.stretches.len() as u64;
            return;
        }
        for (at, first) in run.stretches.iter().filter_map(place).enumerate() {
            let behind = &run.stretches[at + 1..];
            // A road may lead back to its own start.
            let apart = |entry: &(Cell, u32)| place(entry).map_or(0.0, |other| other.s - first.s);
            let from = behind.partition_point(|other| apart(other) <= NEAR);
            let to = behind.partition_point(|other| length - apart(other) > NEAR);
            self.steps += 1;
            for second in behind.get(from..to).unwrap_or_default().iter().filter_map(place) {
                if self.is_cut() || self.is_known((run.road, run.road)) {
                    return;
                }
                self.compare(first, second);
            }
        }
    }

    /// Looks for the first stretches of two roads that overlap.
    fn look_between(&mut self, places: &[StretchSummary], a: &Run<'_>, b: &Run<'_>) {
        let (a, b) = if a.road < b.road { (a, b) } else { (b, a) };
        let place = |entry: &(Cell, u32)| places.get(entry.1 as usize);
        let pair = (a.road, b.road);
        if self.is_known(pair) {
            return;
        }
        for first in a.stretches.iter().filter_map(place) {
            for second in b.stretches.iter().filter_map(place) {
                if self.is_cut() || (self.compare(first, second) && self.is_known(pair)) {
                    return;
                }
            }
        }
    }

    /// Notes the place where two roads overlap, if these stretches do. Whether they do.
    fn compare(&mut self, a: &StretchSummary, b: &StretchSummary) -> bool {
        self.steps += 1;
        if !a.is_near(b) {
            return false;
        }
        self.steps += STEPS_OF_A_COMPARISON;
        let stretches = (self.network.stretch(a), self.network.stretch(b));
        let (Some(first), Some(second)) = stretches else { return false };
        let depth = first.depth(&second);
        if depth <= TOUCH {
            return false;
        }
        let (pair, [s_a, s_b]) = ((a.road, b.road), [first.s, second.s]);
        if self.network.may_overlap(&first, &second, &self.members) {
            let [a, b] = [first.road, second.road];
            self.found.insert(pair, Overlap { a, b, s_a, s_b, depth });
        } else if self.expected.len() < REMEMBERED {
            self.expected.insert(pair);
        }
        true
    }
}

impl Run<'_> {
    /// Whether two roads of a cell, which lie over one another in x, may overlap.
    fn may_meet(&self, other: &Self) -> bool {
        let ([_, ay0, _, ay1], [_, by0, _, by1]) = (self.bounds, other.bounds);
        let [[a_low, a_high], [b_low, b_high]] = [self.heights, other.heights];
        ay0 + TOUCH < by1
            && by0 + TOUCH < ay1
            && a_low - b_high < CLEARANCE
            && b_low - a_high < CLEARANCE
    }
}

/// Of each run, the next one that has to do with another junction, or with none: there may be thousands of one junction in a cell.
fn ends_of_junctions(runs: &[Run<'_>]) -> Vec<usize> {
    let mut ends: Vec<usize> = (1..=runs.len()).collect();
    for at in (1..runs.len()).rev() {
        if runs[at].junction.is_some() && runs[at - 1].junction == runs[at].junction {
            ends[at - 1] = ends[at];
        }
    }
    ends
}

impl Network {
    /// Columns of cells, in strips that have about as many stretches each.
    fn strips(&self) -> Vec<RangeInclusive<i32>> {
        let mut starts: Vec<(i32, u32)> = self
            .roads
            .iter()
            .map(|road| (column(road.bounds[0]), self.stations_of(road).len() as u32))
            .collect();
        starts.sort_unstable();
        let all: usize = starts.iter().map(|(_, count)| *count as usize).sum();
        let most = (all / STRIPS).max(STRETCHES_OF_A_STRIP);
        let (mut strips, mut first, mut held) = (Vec::new(), i32::MIN, 0);
        for (column, count) in starts {
            if held >= most && column > first {
                strips.push(first..=column - 1);
                (first, held) = (column, 0);
            }
            held += count as usize;
        }
        strips.push(first..=i32::MAX);
        strips
    }

    /// Ranks of the roads that reach into each of some strips, ascending: each road is looked at once.
    fn roads_of(&self, strips: &[RangeInclusive<i32>]) -> Vec<Vec<u32>> {
        let mut roads = vec![Vec::new(); strips.len()];
        for (rank, road) in self.roads.iter().enumerate() {
            let [first, last] = [road.bounds[0], road.bounds[2]].map(column);
            let from = strips.partition_point(|strip| *strip.end() < first);
            let own = roads.iter_mut().zip(strips).skip(from);
            own.take_while(|(_, strip)| *strip.start() <= last)
                .for_each(|(roads, _)| roads.push(rank as u32));
        }
        roads
    }

    /// Takes the stretches of roads that lie in a strip, and the cells of it that each lies in.
    fn sort_into_cells(
        &self,
        strip: &RangeInclusive<i32>,
        roads: &[u32],
        places: &mut Vec<StretchSummary>,
        cells: &mut Vec<(Cell, u32)>,
    ) {
        let is_beside =
            |low: f64, high: f64| column(high) < *strip.start() || column(low) > *strip.end();
        let roads = roads.iter().filter_map(|rank| Some((*rank, self.roads.get(*rank as usize)?)));
        for (rank, road) in roads {
            let [x0, _, x1, _] = road.bounds;
            let is_within = [x0, x1].into_iter().all(|x| strip.contains(&column(x)));
            // The ends of a cross-section that two stretches share are computed once.
            let (mut known, mut heading) = (None, Heading::default());
            for (station, [a, b]) in self.stations_of(road).pairs().enumerate() {
                let before = known.take();
                let reach = || {
                    let reach = [a.left, a.right, b.left, b.right].map(f64::abs);
                    reach.into_iter().fold(0.0, f64::max)
                };
                let is_beside = |reach: f64| is_beside(a.x.min(b.x) - reach, a.x.max(b.x) + reach);
                if !is_within && is_beside(reach()) {
                    continue;
                }
                let ends = (before.unwrap_or_else(|| a.ends(&mut heading)), b.ends(&mut heading));
                known = Some(ends.1);
                let [from, to] = [(a, ends.0), (b, ends.1)]
                    .map(|(station, [left, right])| CrossSection { station, left, right });
                let stretch = Stretch::between(rank as usize, &from, &to);
                // A short one that is too narrow to be overlapped by more than a touch: there may be thousands in a metre.
                let is_narrow = |stretch: &Stretch| b.s - a.s <= TOUCH && stretch.width() <= TOUCH;
                let Some(stretch) = stretch.filter(|stretch| !is_narrow(stretch)) else { continue };
                let bounds = bounds(&stretch.corners);
                let [x0, y0, x1, y1] = bounds.map(number);
                let [width, height] = [x1.saturating_sub(x0), y1.saturating_sub(y0)];
                let count = width.saturating_add(1).saturating_mul(height.saturating_add(1));
                if count > CELLS_OF_A_STRETCH {
                    continue;
                }
                let place = places.len() as u32;
                for x in (x0..=x1).map(within_32_bits).filter(|x| strip.contains(x)) {
                    for y in y0..=y1 {
                        cells.push((cell(x, within_32_bits(y)), place));
                    }
                }
                let (road, station) = (rank, station as u32);
                places.push(StretchSummary { road, station, s: stretch.s, z: stretch.z, bounds });
            }
        }
    }

    fn stretch(&self, place: &StretchSummary) -> Option<Stretch> {
        let stations = self.stations_of(self.roads.get(place.road as usize)?);
        let first = place.station as usize;
        Stretch::new(place.road as usize, &stations.get(first)?, &stations.get(first + 1)?)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{RoadFacts, Station};
    use super::*;
    use mapd_xodr::Span;

    /// Steps per road that straight roads of 1 m take which begin where `place` says, as a map in which each is alone takes them.
    const ALONE: u64 = 4;

    fn network(count: u32, place: impl Fn(u32) -> [f64; 3]) -> Network {
        let mut network = Network::default();
        for rank in 0..count {
            let [x, y, z] = place(rank);
            let before = network.lines.len() as u32;
            for s in [0.0, 1.0] {
                let station =
                    Station { s, x: x + s, y, hdg: 0.0, z, roll: 0.0, left: 0.0, right: -3.0 };
                let (line, profile) = station.split();
                network.lines.push(line);
                network.profiles.push(profile);
            }
            let stations = before..before + 2;
            network.roads.push(RoadFacts {
                span: Span::default(),
                length: 1.0,
                bounds: [x, y - 3.0, x + 1.0, y],
                links: [None, None],
                rank,
                id: network.names.add(&format!("road {rank}")),
                junction: None,
                sections: 0..0,
                stations: stations.clone(),
                profiles: stations,
                is_straight: false,
                is_left_hand: false,
                has_crg: false,
                has_switches: false,
                has_lane_links: false,
                has_elevation: false,
            });
        }
        network.finish();
        network
    }

    fn check(what: &str, count: u32, place: impl Fn(u32) -> [f64; 3], most: u64) -> Overlaps {
        let found = find(&network(count, place));
        assert!(found.work <= most * u64::from(count), "{what}: {} steps", found.work);
        found
    }

    #[test]
    fn roads_apart_are_not_compared() {
        let row = |rank: u32| [f64::from(rank) * 2.0, 0.0, 0.0];
        for count in [1000, 10_000] {
            let found = check("in a row", count, row, ALONE + 20);
            assert!(found.pairs.is_empty() && !found.is_cut);
        }
    }

    /// All pairs overlap: so many are told, and the search says that there are more.
    #[test]
    fn pairs_and_steps_grow_with_the_roads() {
        for count in [2000, 4000] {
            let (count_64, base) = (u64::from(count), PAIRS as u64);
            let pairs = base + PAIRS_OF_A_ROAD as u64 * count_64;
            let most = (pairs * (STEPS_OF_A_COMPARISON + 2)).div_ceil(count_64) + ALONE;
            let found = check("at one place", count, |_| [0.0; 3], most);
            assert!(found.is_cut);
            assert_eq!(found.pairs.len() as u64, pairs);
        }
        let found = check("few at one place", 300, |_| [0.0; 3], 300 * (STEPS_OF_A_COMPARISON + 2));
        assert_eq!(found.pairs.len(), 300 * 299 / 2);
        assert!(!found.is_cut);
    }
}
