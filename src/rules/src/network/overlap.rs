//! Where roads overlap, in the plane and in height.

use super::{LinkTarget, Network, RoadFacts, Station};
use crate::place::text;

/// Roads may touch by this much without overlapping `[m]`: borders of neighbors are rounded, and drawn a little over.
pub const TOUCH: f64 = 0.25;

/// Roads whose heights differ by this much pass over one another `[m]`: lower than any vehicle's clearance.
pub const CLEARANCE: f64 = 2.0;

/// Side of the cells in which stretches are sorted `[m]`: about twice a stretch.
const CELL: f64 = 20.0;

/// Cells that one stretch is sorted into at most; wider ones are broken anyway.
const CELLS_OF_A_STRETCH: i64 = 256;

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
    z: f64,
    bounds: [f64; 4],
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
        if a.left - a.right <= 2.0 * TOUCH {
            return None;
        }
        let corners = [a.at(a.right), a.at(a.left), b.at(b.left), b.at(b.right)];
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
                stations.windows(2).filter_map(|pair| Stretch::new(1, &pair[0], &pair[1])).any(
                    |other| (other.z - stretch.z).abs() < CLEARANCE && other.depth(&stretch) > 0.0,
                );
            if is_over {
                range = Some((range.map_or(from, |range| range.0), to));
            }
        }
        range
    }

    /// Junctions that each road has to do with, by rank, ascending.
    fn memberships(&self) -> Vec<Vec<usize>> {
        let mut members = vec![Vec::new(); self.roads.len()];
        for (rank, junction) in self.junctions.iter().enumerate() {
            let connections = junction.connection.iter();
            let paths = junction.cross_path.iter();
            let named = connections
                .flat_map(|c| [&c.incoming_road, &c.connecting_road, &c.linked_road])
                .chain(paths.flat_map(|p| [&p.crossing_road, &p.road_at_start, &p.road_at_end]))
                .chain(junction.road_section.iter().map(|section| &section.road_id))
                .chain([&junction.main_road]);
            let mut roads: Vec<usize> = named.filter_map(|id| self.road_rank(text(id))).collect();
            let within = self.connecting.get(text(&junction.id)).into_iter().flatten();
            roads.extend(within);
            roads.sort_unstable();
            roads.dedup();
            for road in roads {
                if let Some(list) = members.get_mut(road) {
                    list.push(rank);
                }
            }
        }
        members
    }

    fn find_overlaps(&self) -> Vec<Overlap> {
        let members = self.memberships();
        let pairs = self.roads.iter().map(|road| self.stations_of(road).len().saturating_sub(1));
        let mut places = Vec::with_capacity(pairs.sum());
        for (rank, road) in self.roads.iter().enumerate() {
            for (station, pair) in self.stations_of(road).windows(2).enumerate() {
                let Some(stretch) = Stretch::new(rank, &pair[0], &pair[1]) else { continue };
                let bounds = bounds(&stretch.corners);
                places.push(Place {
                    road: rank as u32,
                    station: station as u32,
                    z: stretch.z,
                    bounds,
                });
            }
        }
        let mut cells: Vec<((i32, i32), u32)> = Vec::new();
        for (rank, place) in places.iter().enumerate() {
            let [x0, y0, x1, y1] = place.bounds.map(|value| (value / CELL).floor() as i64);
            let [width, height] = [x1.saturating_sub(x0), y1.saturating_sub(y0)];
            if width.saturating_add(1).saturating_mul(height.saturating_add(1)) > CELLS_OF_A_STRETCH
            {
                continue;
            }
            // Beyond 32 bits, 40 million kilometres away, all lies in one cell. (Casts of `clamp`ed numbers lose nothing.)
            let cell = |value: i64| value.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
            for x in x0..=x1 {
                cells.extend((y0..=y1).map(|y| ((cell(x), cell(y)), rank as u32)));
            }
        }
        cells.sort_unstable();
        let mut found = std::collections::BTreeMap::new();
        for cell in cells.chunk_by(|a, b| a.0 == b.0) {
            for (at, (_, first)) in cell.iter().enumerate() {
                for (_, second) in &cell[at + 1..] {
                    let (Some(a), Some(b)) =
                        (places.get(*first as usize), places.get(*second as usize))
                    else {
                        continue;
                    };
                    // What is cheap and excludes most comes first.
                    if !a.is_near(b) || self.are_of_one_junction(a, b) {
                        continue;
                    }
                    let (Some(a), Some(b)) = (self.stretch(a), self.stretch(b)) else { continue };
                    let (a, b) = (&a, &b);
                    if self.are_neighbors(a, b) {
                        continue;
                    }
                    let key = (a.road, b.road);
                    let depth = a.depth(b);
                    let is_new = || !found.contains_key(&key);
                    if depth > TOUCH && is_new() && self.may_overlap(a, b, &members) {
                        found.insert(
                            key,
                            Overlap { a: a.road, b: b.road, s_a: a.s, s_b: b.s, depth },
                        );
                    }
                }
            }
        }
        found.into_values().collect()
    }

    fn stretch(&self, place: &Place) -> Option<Stretch> {
        let stations = self.stations_of(self.roads.get(place.road as usize)?);
        let first = place.station as usize;
        Stretch::new(place.road as usize, stations.get(first)?, stations.get(first + 1)?)
    }

    /// Whether two stretches are of different roads of one junction.
    fn are_of_one_junction(&self, a: &Place, b: &Place) -> bool {
        let junction = |place: &Place| self.roads.get(place.road as usize)?.junction.as_ref();
        a.road != b.road && junction(a).is_some() && junction(a) == junction(b)
    }

    /// Whether two stretches are neighbors on one road.
    fn are_neighbors(&self, a: &Stretch, b: &Stretch) -> bool {
        let apart = (a.s - b.s).abs();
        // A road may lead back to its own start.
        let is_near = |road: &RoadFacts| apart <= NEAR || road.length - apart <= NEAR;
        a.road == b.road && self.roads.get(a.road).is_some_and(is_near)
    }

    /// Whether an overlap of two roads would tell something: not where they touch, nor where they meet at one junction.
    fn may_overlap(&self, a: &Stretch, b: &Stretch, members: &[Vec<usize>]) -> bool {
        let (Some(road_a), Some(road_b)) = (self.roads.get(a.road), self.roads.get(b.road)) else {
            return false;
        };
        if a.road == b.road {
            return true;
        }
        let touches = |road: &RoadFacts, other: &RoadFacts| {
            road.links.iter().flatten().any(|link| match &link.target {
                LinkTarget::Road(id) => *id == other.id,
                LinkTarget::Junction(id) => {
                    // Roads at one junction meet there, and so do the roads within.
                    other.junction.as_ref() == Some(id)
                        || other.links.iter().flatten().any(|o| o.target == link.target)
                }
            })
        };
        let share_neighbor = || {
            let mut targets = road_a.links.iter().flatten().map(|link| &link.target);
            targets.any(|target| road_b.links.iter().flatten().any(|link| link.target == *target))
        };
        let share_junction = || {
            let (Some(of_a), Some(of_b)) = (members.get(a.road), members.get(b.road)) else {
                return false;
            };
            of_a.iter().any(|junction| of_b.binary_search(junction).is_ok())
        };
        !share_junction()
            && !touches(road_a, road_b)
            && !touches(road_b, road_a)
            && !share_neighbor()
    }
}
