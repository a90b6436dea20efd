//! Where roads overlap, in the plane and in height.

use super::stations::Heading;
use super::{LinkTarget, Network, RoadFacts, Station};
use crate::place::text;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

/// Roads may touch by this much without overlapping `[m]`: borders of neighbors are rounded, and drawn a little over.
pub const TOUCH: f64 = 0.25;

/// Roads whose heights differ by this much pass over one another `[m]`: lower than any vehicle's clearance.
pub const CLEARANCE: f64 = 2.0;

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

/// Two roads, or two stretches of one, that overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// Rank of the first road.
    pub a: usize,
    /// Rank of the second road.
    pub b: usize,
    /// Where on the first road `[m]`.
    pub s_a: f64,
    /// Where on the second road `[m]`.
    pub s_b: f64,
    /// How deep `[m]`.
    pub depth: f64,
}

/// A stretch between two cross-sections.
struct Stretch {
    road: usize,
    s: f64,
    z: f64,
    corners: [[f64; 2]; 4],
}

/// What is kept of all stretches at once: enough to tell most pairs apart. The rest is computed again for those that are near.
struct Place {
    road: u32,
    /// Number of the first of its two cross-sections.
    station: u32,
    s: f64,
    z: f64,
    bounds: [f64; 4],
}

/// What is known of pairs of roads, by their ranks.
struct Pairs {
    /// Ranks of roads with those of the junctions that they have to do with, ascending.
    members: Vec<(u32, u32)>,
    found: BTreeMap<(usize, usize), Overlap>,
    /// Those whose overlaps tell nothing: as many as fit.
    expected: BTreeSet<(usize, usize)>,
}

impl Pairs {
    /// Junctions that a road has to do with, ascending.
    fn junctions_of(&self, road: u32) -> &[(u32, u32)] {
        let [first, end] = [road, road.saturating_add(1)]
            .map(|road| self.members.partition_point(|(rank, _)| *rank < road));
        self.members.get(first..end).unwrap_or_default()
    }

    /// Whether there is a junction that both roads have to do with.
    fn share_junction(&self, a: u32, b: u32) -> bool {
        let [a, b] = [a, b].map(|road| self.junctions_of(road));
        let (few, many) = if a.len() < b.len() { (a, b) } else { (b, a) };
        few.iter().any(|(_, junction)| many.binary_search_by_key(junction, |(_, of)| *of).is_ok())
    }
}

/// Smallest x, smallest y, largest x, largest y.
fn bounds(corners: &[[f64; 2]; 4]) -> [f64; 4] {
    let [x, y] = corners[0];
    corners
        .iter()
        .fold([x, y, x, y], |b, [x, y]| [b[0].min(*x), b[1].min(*y), b[2].max(*x), b[3].max(*y)])
}

impl Stretch {
    fn new(road: usize, a: &Station, b: &Station) -> Option<Self> {
        let mut heading = Heading::default();
        Self::between(road, (a, a.ends(&mut heading)), (b, b.ends(&mut heading)))
    }

    /// As [`Stretch::new`], where the ends of the cross-sections are known.
    fn between(
        road: usize,
        (a, [a_left, a_right]): (&Station, [[f64; 2]; 2]),
        (b, [b_left, b_right]): (&Station, [[f64; 2]; 2]),
    ) -> Option<Self> {
        if a.left - a.right <= 2.0 * TOUCH {
            return None;
        }
        let corners = [a_right, a_left, b_left, b_right];
        corners.iter().flatten().all(|value| value.is_finite()).then_some(Self {
            road,
            s: (a.s + b.s) / 2.0,
            z: (a.z + b.z) / 2.0,
            corners,
        })
    }

    /// How deep two stretches overlap `[m]`; 0 or less where they do not. Corners are taken as those of convex areas.
    fn depth(&self, other: &Self) -> f64 {
        let mut depth = f64::INFINITY;
        for corners in [&self.corners, &other.corners] {
            for edge in 0..4 {
                let ([ax, ay], [bx, by]) = (corners[edge], corners[(edge + 1) % 4]);
                let length = (bx - ax).hypot(by - ay);
                if length <= 0.0 {
                    continue;
                }
                let normal = [(by - ay) / length, (ax - bx) / length];
                let range = |points: &[[f64; 2]; 4]| {
                    let along = points.map(|[x, y]| x * normal[0] + y * normal[1]);
                    let low = along.iter().copied().fold(f64::INFINITY, f64::min);
                    (low, along.iter().copied().fold(f64::NEG_INFINITY, f64::max))
                };
                let ((low_a, high_a), (low_b, high_b)) =
                    (range(&self.corners), range(&other.corners));
                depth = depth.min(high_a.min(high_b) - low_a.max(low_b));
            }
        }
        depth
    }
}

/// Number of a cell. Beyond 32 bits, 40 million kilometres away, all lies in one. (Casts of `clamp`ed numbers lose nothing.)
fn within_32_bits(cell: i64) -> i32 {
    cell.clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

/// Column or row of the cell that a coordinate `[m]` lies in.
fn cell(value: f64) -> i32 {
    within_32_bits((value / CELL).floor() as i64)
}

impl Place {
    /// Whether two stretches are not one above the other, and their boxes overlap by more than a touch.
    fn is_near(&self, other: &Self) -> bool {
        let ([ax0, ay0, ax1, ay1], [bx0, by0, bx1, by1]) = (self.bounds, other.bounds);
        (self.z - other.z).abs() < CLEARANCE
            && ax0 + TOUCH < bx1
            && bx0 + TOUCH < ax1
            && ay0 + TOUCH < by1
            && by0 + TOUCH < ay1
    }
}

impl Network {
    /// Pairs of roads that overlap, and roads that overlap themselves: for each pair the first place found, by rank.
    pub fn overlaps(&self) -> &[Overlap] {
        self.overlaps.get_or_init(|| self.find_overlaps())
    }

    /// From where to where one road is overlapped by another: s `[m]`.
    pub fn overlap_along(&self, road: &RoadFacts, other: &RoadFacts) -> Option<(f64, f64)> {
        // Cross-sections are too far apart for this: the road is looked at in small steps.
        const STEPS: usize = 400;
        let mut range: Option<(f64, f64)> = None;
        let length = road.length;
        for step in 0..STEPS {
            let [from, to] = [step, step + 1].map(|at| length * at as f64 / STEPS as f64);
            let stretch =
                Stretch::new(0, &self.station_at(road, from)?, &self.station_at(road, to)?)?;
            let stations = self.stations_of(other);
            let is_over =
                stations.pairs().filter_map(|(a, b)| Stretch::new(1, &a, &b)).any(|other| {
                    (other.z - stretch.z).abs() < CLEARANCE && other.depth(&stretch) > 0.0
                });
            if is_over {
                range = Some((range.map_or(from, |range| range.0), to));
            }
        }
        range
    }

    /// Ranks of roads with those of the junctions that they have to do with, ascending.
    fn memberships(&self) -> Vec<(u32, u32)> {
        let mut members = Vec::new();
        // Junctions of one id count as one, so that the roads within are taken once.
        let mut first_of = BTreeMap::new();
        for (rank, junction) in self.junctions.iter().enumerate() {
            let first = junction.id.map_or(rank, |id| *first_of.entry(id).or_insert(rank));
            let connections = self.connections_of(junction).iter();
            let named = connections.flat_map(|c| [c.incoming, c.connecting, c.linked]);
            let written = junction.written.as_deref();
            let main = written.map_or("", |junction| text(&junction.main_road));
            let paths = written.into_iter().flat_map(|junction| &junction.cross_path);
            let sections = written.into_iter().flat_map(|junction| &junction.road_section);
            let others = paths
                .flat_map(|p| [&p.crossing_road, &p.road_at_start, &p.road_at_end])
                .chain(sections.map(|section| &section.road_id))
                .map(text)
                .chain([main]);
            let named = named.chain(others.filter_map(|id| self.name_of(id)));
            let id = junction.id.filter(|_| first == rank);
            let within = id.into_iter().flat_map(|id| self.roads_within(id));
            let roads = named.filter_map(|id| self.road_named(id)).chain(within);
            members.extend(roads.map(|road| (road.rank, first as u32)));
        }
        members.sort_unstable();
        members.dedup();
        members
    }

    /// Columns of cells, in strips that have about as many stretches each.
    fn strips(&self) -> Vec<RangeInclusive<i32>> {
        let mut starts: Vec<(i32, u32)> = self
            .roads
            .iter()
            .map(|road| (cell(road.bounds[0]), self.stations_of(road).len() as u32))
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

    fn find_overlaps(&self) -> Vec<Overlap> {
        let mut pairs = Pairs {
            members: self.memberships(),
            found: BTreeMap::new(),
            expected: BTreeSet::new(),
        };
        let (mut places, mut cells) = (Vec::new(), Vec::new());
        for strip in self.strips() {
            places.clear();
            cells.clear();
            self.sort_into_cells(&strip, &mut places, &mut cells);
            cells.sort_unstable();
            for cell in cells.chunk_by(|a, b| a.0 == b.0) {
                for (at, (_, first)) in cell.iter().enumerate() {
                    for (_, second) in &cell[at + 1..] {
                        let (Some(a), Some(b)) =
                            (places.get(*first as usize), places.get(*second as usize))
                        else {
                            continue;
                        };
                        self.compare(a, b, &mut pairs);
                    }
                }
            }
        }
        pairs.found.into_values().collect()
    }

    /// Takes the stretches that lie in a strip, and the cells of it that each lies in.
    fn sort_into_cells(
        &self,
        strip: &RangeInclusive<i32>,
        places: &mut Vec<Place>,
        cells: &mut Vec<((i32, i32), u32)>,
    ) {
        let is_beside =
            |low: f64, high: f64| cell(high) < *strip.start() || cell(low) > *strip.end();
        for (rank, road) in self.roads.iter().enumerate() {
            if is_beside(road.bounds[0], road.bounds[2]) {
                continue;
            }
            // The ends of a cross-section that two stretches share are computed once.
            let (mut known, mut heading) = (None, Heading::default());
            for (station, (a, b)) in self.stations_of(road).pairs().enumerate() {
                let before = known.take();
                let reach = [a.left, a.right, b.left, b.right].map(f64::abs);
                let reach = reach.into_iter().fold(0.0, f64::max);
                if is_beside(a.x.min(b.x) - reach, a.x.max(b.x) + reach) {
                    continue;
                }
                let ends = (before.unwrap_or_else(|| a.ends(&mut heading)), b.ends(&mut heading));
                known = Some(ends.1);
                let stretch = Stretch::between(rank, (&a, ends.0), (&b, ends.1));
                let Some(stretch) = stretch else { continue };
                let bounds = bounds(&stretch.corners);
                let [x0, y0, x1, y1] = bounds.map(|value| (value / CELL).floor() as i64);
                let [width, height] = [x1.saturating_sub(x0), y1.saturating_sub(y0)];
                let count = width.saturating_add(1).saturating_mul(height.saturating_add(1));
                if count > CELLS_OF_A_STRETCH {
                    continue;
                }
                let number = places.len() as u32;
                let columns = (x0..=x1).map(within_32_bits).filter(|x| strip.contains(x));
                cells.extend(
                    columns.flat_map(|x| (y0..=y1).map(move |y| ((x, within_32_bits(y)), number))),
                );
                let (road, station) = (rank as u32, station as u32);
                places.push(Place { road, station, s: stretch.s, z: stretch.z, bounds });
            }
        }
    }

    /// Notes the place where two roads overlap, if these stretches do and none is known.
    fn compare(&self, a: &Place, b: &Place, pairs: &mut Pairs) {
        // What is cheap and excludes most comes first.
        if !a.is_near(b) || self.are_of_one_junction(a, b) || self.are_neighbors(a, b) {
            return;
        }
        let (Some(a), Some(b)) = (self.stretch(a), self.stretch(b)) else { return };
        let (a, b) = (&a, &b);
        let key = (a.road, b.road);
        let depth = a.depth(b);
        let is_known = || pairs.found.contains_key(&key) || pairs.expected.contains(&key);
        if depth <= TOUCH || is_known() {
            return;
        }
        if self.may_overlap(a, b, pairs) {
            pairs.found.insert(key, Overlap { a: a.road, b: b.road, s_a: a.s, s_b: b.s, depth });
        } else if pairs.expected.len() < REMEMBERED {
            pairs.expected.insert(key);
        }
    }

    fn stretch(&self, place: &Place) -> Option<Stretch> {
        let stations = self.stations_of(self.roads.get(place.road as usize)?);
        let first = place.station as usize;
        Stretch::new(place.road as usize, &stations.get(first)?, &stations.get(first + 1)?)
    }

    /// Whether two stretches are of different roads of one junction.
    fn are_of_one_junction(&self, a: &Place, b: &Place) -> bool {
        let junction = |place: &Place| self.roads.get(place.road as usize)?.junction;
        a.road != b.road && junction(a).is_some() && junction(a) == junction(b)
    }

    /// Whether two stretches are neighbors on one road.
    fn are_neighbors(&self, a: &Place, b: &Place) -> bool {
        let apart = (a.s - b.s).abs();
        // A road may lead back to its own start.
        let is_near = |road: &RoadFacts| apart <= NEAR || road.length - apart <= NEAR;
        a.road == b.road && self.roads.get(a.road as usize).is_some_and(is_near)
    }

    /// Whether an overlap of two roads would tell something: not where they touch, nor where they meet at one junction.
    fn may_overlap(&self, a: &Stretch, b: &Stretch, pairs: &Pairs) -> bool {
        let (Some(road_a), Some(road_b)) = (self.roads.get(a.road), self.roads.get(b.road)) else {
            return false;
        };
        if a.road == b.road {
            return true;
        }
        let touches = |road: &RoadFacts, other: &RoadFacts| {
            road.links.iter().flatten().any(|link| match link.target {
                LinkTarget::Road(id) => id == other.id,
                LinkTarget::Junction(id) => {
                    // Roads at one junction meet there, and so do the roads within.
                    other.junction == Some(id)
                        || other.links.iter().flatten().any(|o| o.target == link.target)
                }
            })
        };
        let share_neighbor = || {
            let mut targets = road_a.links.iter().flatten().map(|link| link.target);
            targets.any(|target| road_b.links.iter().flatten().any(|link| link.target == target))
        };
        !pairs.share_junction(road_a.rank, road_b.rank)
            && !touches(road_a, road_b)
            && !touches(road_b, road_a)
            && !share_neighbor()
    }
}

#[cfg(test)]
mod tests {
    use super::super::JunctionFacts;
    use super::*;
    use mapd_xodr::{JunctionType, Span};

    /// Roads within a junction are taken once, however many junctions have its id.
    #[test]
    fn roads_within_junctions_of_one_id_are_taken_once() {
        const EACH: u32 = 100;
        let mut network = Network::default();
        let id = network.names.add("9");
        for rank in 0..EACH {
            network.roads.push(RoadFacts {
                span: Span::default(),
                length: 1.0,
                bounds: [0.0; 4],
                links: [None, None],
                rank,
                id: network.names.add(&format!("road {rank}")),
                junction: Some(id),
                sections: 0..0,
                stations: 0..0,
                profiles: 0..0,
                is_straight: true,
                is_left_hand: false,
                has_crg: false,
                has_switches: false,
                has_elevation: false,
            });
            network.junctions.push(JunctionFacts {
                span: Span::default(),
                id: Some(id),
                connections: 0..0,
                kind: JunctionType::Default,
                written: None,
            });
        }
        network.finish();
        let expected: Vec<_> = (0..EACH).map(|road| (road, 0)).collect();
        assert_eq!(network.memberships(), expected);
    }
}
