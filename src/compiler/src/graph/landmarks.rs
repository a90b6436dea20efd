//! Landmarks: distances from and to a few places, from which routing takes lower bounds of what is left (ALT).
//!
//! Distances are between groups: nodes side by side that travel the same way. Within a group changes of lane are free and
//! forbidden ones allowed, and a group is passed for what its cheapest lane costs; so the bounds hold for every vehicle
//! with a motor and every price of lane changes, and there are fewer of them.

use super::csr::in_order;
use super::nodes::pieces;
use mapd_archive::{NONE, Rows, VehicleClass, node_flags};
use rayon::prelude::*;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Largest stored number of steps; the one above stands for "no way".
const MOST_STEPS: f64 = 65_534.0;

/// Gives every node its group and stores the distances of so many landmarks.
pub(crate) fn build(rows: &mut Rows, landmarks: usize) {
    let count = group(rows);
    let ranks = ranks(rows, count as usize);
    if let Some(graph) = rows.graph.first_mut() {
        graph.groups = count;
    }
    if count == 0 || landmarks == 0 {
        return;
    }
    let ahead = Groups::new(rows, count as usize);
    let behind = ahead.turned();
    let places = choose(&ahead, &behind, &ranks, landmarks);
    let store = |weight: fn(&Weight) -> f64| {
        let distances: Vec<Vec<f64>> = [&ahead, &behind]
            .into_iter()
            .flat_map(|graph| places.iter().map(move |place| (graph, *place)))
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(|(graph, place)| graph.distances(place, weight))
            .collect();
        steps(&distances)
    };
    let (length_step, lengths) = store(|weight| weight.length);
    let (time_step, times) = store(|weight| weight.time);
    rows.landmark_lengths = lengths.into();
    rows.landmark_times = times.into();
    if let Some(graph) = rows.graph.first_mut() {
        (graph.length_step, graph.time_step) = (length_step, time_step);
        graph.landmarks = places.len() as u32;
    }
}

/// Numbers the groups in the order of nodes.
fn group(rows: &mut Rows) -> u32 {
    let Rows { sections, lanes, lane_nodes, .. } = rows;
    let mut count = 0;
    let mut of_section = Vec::new();
    for section in sections.iter() {
        of_section.clear();
        for lane in section.lanes.of(lanes) {
            let pieces = pieces(lane) as usize;
            of_section.resize(2 * pieces, NONE);
            for (i, node) in (lane.nodes.first..lane.nodes.end() as u32).enumerate() {
                let Some(row) = lane_nodes.get_mut(node as usize) else { continue };
                if row.access & VehicleClass::MOTOR == 0 {
                    continue;
                }
                let forward = row.flags & node_flags::FORWARD != 0;
                let place = i % pieces + if forward { 0 } else { pieces };
                let Some(own) = of_section.get_mut(place) else { continue };
                if *own == NONE {
                    *own = count;
                    count += 1;
                }
                row.group = *own;
            }
        }
    }
    count
}

/// Per group its place in an order that depends on names only.
fn ranks(rows: &Rows, groups: usize) -> Vec<u32> {
    let mut ranks = vec![NONE; groups];
    for (place, node) in in_order(rows).enumerate() {
        let group = rows.lane_nodes.get(node as usize).map_or(NONE, |row| row.group);
        if let Some(rank) = ranks.get_mut(group as usize).filter(|rank| **rank == NONE) {
            *rank = place as u32;
        }
    }
    ranks
}

/// What passing a group costs on the way to another.
#[derive(Clone, Copy)]
struct Weight {
    length: f64,
    time: f64,
}

/// The graph of groups as compressed sparse rows.
struct Groups {
    offsets: Vec<u32>,
    targets: Vec<(u32, Weight)>,
}

impl Groups {
    fn new(rows: &Rows, count: usize) -> Self {
        let mut edges = Vec::new();
        for (number, node) in rows.lane_nodes.iter().enumerate().filter(|(_, n)| n.group != NONE) {
            let at = |i: usize| rows.successor_offsets.get(i).copied().unwrap_or(0) as usize;
            for to in rows.successors.get(at(number)..at(number + 1)).unwrap_or(&[]) {
                let to = rows.lane_nodes.get(*to as usize).map_or(NONE, |row| row.group);
                if to != NONE && to != node.group {
                    let weight = Weight { length: node.length.into(), time: node.time.into() };
                    edges.push((node.group, to, weight));
                }
            }
        }
        Self::of(edges, count)
    }

    fn of(mut edges: Vec<(u32, u32, Weight)>, count: usize) -> Self {
        edges.sort_by_key(|(from, to, _)| (*from, *to));
        edges.dedup_by(|later, first| {
            let same = (later.0, later.1) == (first.0, first.1);
            if same {
                first.2.length = first.2.length.min(later.2.length);
                first.2.time = first.2.time.min(later.2.time);
            }
            same
        });
        let mut offsets = vec![0; count + 1];
        for (from, ..) in &edges {
            offsets[*from as usize + 1] += 1;
        }
        for i in 0..count {
            offsets[i + 1] += offsets[i];
        }
        Self { offsets, targets: edges.into_iter().map(|(_, to, weight)| (to, weight)).collect() }
    }

    fn edges(&self, group: usize) -> &[(u32, Weight)] {
        self.targets
            .get(self.offsets[group] as usize..self.offsets[group + 1] as usize)
            .unwrap_or(&[])
    }

    fn turned(&self) -> Self {
        let count = self.offsets.len() - 1;
        let all = (0..count)
            .flat_map(|from| self.edges(from).iter().map(move |(to, w)| (*to, from as u32, *w)));
        Self::of(all.collect(), count)
    }

    /// Distances from a group to all (Dijkstra); infinite where there is no way.
    fn distances(&self, from: u32, weight: fn(&Weight) -> f64) -> Vec<f64> {
        let mut distances = vec![f64::INFINITY; self.offsets.len() - 1];
        distances[from as usize] = 0.0;
        // Distances are not negative: their bits order as they do.
        let mut open = BinaryHeap::from([Reverse((0f64.to_bits(), from))]);
        while let Some(Reverse((bits, group))) = open.pop() {
            let distance = f64::from_bits(bits);
            if distance > distances[group as usize] {
                continue;
            }
            for (to, cost) in self.edges(group as usize) {
                let there = distance + weight(cost);
                if there < distances[*to as usize] {
                    distances[*to as usize] = there;
                    open.push(Reverse((there.to_bits(), *to)));
                }
            }
        }
        distances
    }
}

/// Chooses landmarks one after the other, each the farthest from those before, at the map's ends.
fn choose(ahead: &Groups, behind: &Groups, ranks: &[u32], wanted: usize) -> Vec<u32> {
    let length = |weight: &Weight| weight.length;
    let first = (0..ranks.len() as u32).min_by_key(|group| ranks[*group as usize]);
    let Some(first) = first else { return Vec::new() };
    let mut places: Vec<u32> = Vec::new();
    let mut nearest = ahead.distances(first, length);
    while places.len() < wanted.min(ranks.len()) {
        // Places that cannot be reached come last: most are small islands.
        let far = |group: &u32| {
            let distance = nearest[*group as usize];
            let reached = distance.is_finite() && distance > 0.0;
            (reached, if reached { distance.to_bits() } else { 0 }, Reverse(ranks[*group as usize]))
        };
        let open = (0..ranks.len() as u32).filter(|group| !places.contains(group));
        let Some(place) = open.max_by_key(far) else { break };
        let (there, back) =
            rayon::join(|| ahead.distances(place, length), || behind.distances(place, length));
        if places.is_empty() {
            nearest.fill(f64::INFINITY);
        }
        places.push(place);
        for (near, (there, back)) in nearest.iter_mut().zip(there.iter().zip(&back)) {
            *near = near.min(*there).min(*back);
        }
    }
    places
}

/// Distances of all landmarks, group by group, in steps rounded down.
fn steps(distances: &[Vec<f64>]) -> (f64, Vec<u16>) {
    let all = || distances.iter().flatten().copied().filter(|distance| distance.is_finite());
    let most = all().fold(0.0, f64::max);
    let step = if most > 0.0 { most / MOST_STEPS } else { 1.0 };
    let groups = distances.first().map_or(0, Vec::len);
    let mut out = Vec::with_capacity(groups * distances.len());
    for group in 0..groups {
        out.extend(distances.iter().map(|of| {
            let distance = of.get(group).copied().unwrap_or(f64::INFINITY);
            if distance.is_finite() { (distance / step) as u16 } else { u16::MAX }
        }));
    }
    (step, out)
}
