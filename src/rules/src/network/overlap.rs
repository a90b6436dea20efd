//! Where roads overlap, in the plane and in height.

use super::stretch::Stretch;
use super::{LinkTarget, Network, RoadFacts};
use crate::place::text;
use std::collections::BTreeMap;
use std::ops::Range;

/// Roads may touch by this much without overlapping `[m]`: borders of neighbors are rounded, and drawn a little over.
pub const TOUCH: f64 = 0.25;

/// Roads whose heights differ by this much pass over one another `[m]`: lower than any vehicle's clearance.
pub const CLEARANCE: f64 = 2.0;

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

/// All overlaps of a map's roads, or as many as its size allows.
#[derive(Clone, Debug, Default)]
pub(super) struct Overlaps {
    /// By rank of the first road, then of the second.
    pub(super) pairs: Vec<Overlap>,
    /// Whether there may be more.
    pub(super) is_cut: bool,
    /// Steps that finding them took.
    #[cfg_attr(not(test), expect(dead_code, reason = "tests count them"))]
    pub(super) work: u64,
}

/// Junctions that roads have to do with: ranks of roads with those of junctions, ascending.
pub(super) struct Members(pub(super) Vec<(u32, u32)>);

impl Members {
    /// Junctions that a road has to do with, ascending.
    fn junctions_of(&self, road: u32) -> &[(u32, u32)] {
        let [first, end] = [road, road.saturating_add(1)]
            .map(|road| self.0.partition_point(|(rank, _)| *rank < road));
        self.0.get(first..end).unwrap_or_default()
    }

    /// The first junction that a road has to do with.
    pub(super) fn first_junction_of(&self, road: u32) -> Option<u32> {
        self.junctions_of(road).first().map(|(_, junction)| *junction)
    }

    /// Whether there is a junction that both roads have to do with.
    pub(super) fn share_junction(&self, a: u32, b: u32) -> bool {
        let [a, b] = [a, b].map(|road| self.junctions_of(road));
        let (few, many) = if a.len() < b.len() { (a, b) } else { (b, a) };
        few.iter().any(|(_, junction)| many.binary_search_by_key(junction, |(_, of)| *of).is_ok())
    }
}

impl Network {
    /// Pairs of roads that overlap, and roads that overlap themselves: for each pair one place, by rank.
    pub fn overlaps(&self) -> &[Overlap] {
        &self.all_overlaps().pairs
    }

    /// Whether there are more overlaps than [`Network::overlaps`] has: so many roads lie over one another that they are not
    /// all looked at. False where no rule asks for overlaps.
    pub(crate) fn has_more_overlaps(&self) -> bool {
        self.overlaps.get().is_some_and(|all| all.is_cut)
    }

    pub(super) fn all_overlaps(&self) -> &Overlaps {
        self.overlaps.get_or_init(|| super::overlap_search::find(self))
    }

    /// From where to where one road is overlapped by another: s `[m]`.
    pub fn overlap_along(&self, road: &RoadFacts, other: &RoadFacts) -> Option<Range<f64>> {
        // Cross-sections are too far apart for this: the road is looked at in small steps.
        const STEPS: usize = 400;
        let mut range: Option<Range<f64>> = None;
        let ([ax0, ay0, ax1, ay1], [bx0, by0, bx1, by1]) = (road.bounds, other.bounds);
        if ax1 < bx0 || bx1 < ax0 || ay1 < by0 || by1 < ay0 {
            return None;
        }
        let length = road.length;
        for step in 0..STEPS {
            let [from, to] = [step, step + 1].map(|at| length * at as f64 / STEPS as f64);
            let stretch =
                Stretch::new(0, &self.station_at(road, from)?, &self.station_at(road, to)?)?;
            let stations = self.stations_of(other);
            let is_over =
                stations.pairs().filter_map(|[a, b]| Stretch::new(1, &a, &b)).any(|other| {
                    (other.z - stretch.z).abs() < CLEARANCE && other.depth(&stretch) > 0.0
                });
            if is_over {
                range = Some(range.map_or(from, |range| range.start)..to);
            }
        }
        range
    }

    /// Ranks of roads with those of the junctions that they have to do with, ascending.
    pub(super) fn memberships(&self) -> Members {
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
        Members(members)
    }

    /// Whether an overlap of two roads would tell something: not where they touch, nor where they meet at one junction.
    pub(super) fn may_overlap(&self, a: &Stretch, b: &Stretch, members: &Members) -> bool {
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
        !members.share_junction(road_a.rank, road_b.rank)
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
                has_lane_links: false,
                has_elevation: false,
            });
            network.junctions.push(JunctionFacts {
                span: Span::default(),
                id: Some(id),
                connections: 0..0,
                controllers: 0..0,
                priorities: 0..0,
                kind: JunctionType::Default,
                written: None,
            });
        }
        network.finish();
        let expected: Vec<_> = (0..EACH).map(|road| (road, 0)).collect();
        assert_eq!(network.memberships().0, expected);
    }
}
