//! Landmarks: distances from and to a few places, from which routing takes lower bounds of what is left (ALT).
//!
//! Distances are over the graph that all motor vehicles together may use, with a price for each change of lane. So they hold
//! for each class; for a higher price of changes too, and for a lower one in proportion.

use super::anchors;
use super::csr::in_order;
use mapd_archive::{LaneNodeRow, NONE, Rows, VehicleClass, beside_row, node_flags};
use rayon::prelude::*;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Largest stored number of steps; the one above stands for "no way".
const MOST_STEPS: f64 = 65_534.0;
/// What a change of lane counts `[m]`: as routing counts it by default.
const CHANGE_LENGTH: f64 = 20.0;
/// What a change of lane counts `[s]`: as routing counts it by default.
const CHANGE_TIME: f64 = 2.0;

/// Distances by place, in steps.
#[derive(Default)]
struct Distances {
    /// Length `[m]` or time `[s]` of a step.
    step: f64,
    steps: Vec<u16>,
}

impl Distances {
    fn of(reached: &[Reached], places: &[usize], step: f64) -> Self {
        Self { step, steps: in_steps(reached, places, step) }
    }
}

/// What is found about landmarks.
#[derive(Default)]
pub(crate) struct Landmarks {
    /// Per node the place of its anchor in the tables of distances, and the steps of length and time from there.
    bounds: Vec<(u32, [u16; 2])>,
    /// Number of places.
    count: u32,
    landmarks: u32,
    lengths: Distances,
    times: Distances,
}

impl Landmarks {
    /// Fills the tables of distances and the nodes' places in them.
    pub(crate) fn store(self, rows: &mut Rows) {
        for (node, (bound, [length, time])) in rows.lane_nodes.iter_mut().zip(&self.bounds) {
            (node.bound, node.anchor_length, node.anchor_time) = (*bound, *length, *time);
        }
        if let Some(graph) = rows.graph.first_mut() {
            graph.bounds = self.count;
            (graph.change_length, graph.change_time) = (CHANGE_LENGTH, CHANGE_TIME);
            (graph.length_step, graph.time_step) = (self.lengths.step, self.times.step);
            graph.landmarks = self.landmarks;
        }
        rows.landmark_lengths = self.lengths.steps.into();
        rows.landmark_times = self.times.steps.into();
    }
}

/// Finds the distances of so many landmarks from and to the anchors of all nodes that motor vehicles may use.
pub(crate) fn find(rows: &Rows, landmarks: usize) -> Landmarks {
    let mut count = 0;
    let place = |node: &LaneNodeRow| {
        if node.access & VehicleClass::MOTOR == 0 {
            return NONE;
        }
        count += 1;
        count - 1
    };
    let places: Vec<u32> = rows.lane_nodes.iter().map(place).collect();
    if count == 0 || landmarks == 0 {
        return Landmarks {
            bounds: vec![(NONE, [0; 2]); places.len()],
            lengths: Distances { step: 1.0, steps: Vec::new() },
            times: Distances { step: 1.0, steps: Vec::new() },
            ..Landmarks::default()
        };
    }
    let ranks = ranks(rows, &places, count as usize);
    let ahead = Network::new(rows, &places, count as usize);
    let behind = ahead.turned();
    let Chosen { places: chosen, from, to } = choose(&ahead, &behind, &ranks, landmarks);
    let lengths: Vec<Reached> = from.into_iter().chain(to).collect();
    let times: Vec<(&Network, u32)> = [&ahead, &behind]
        .into_iter()
        .flat_map(|network| chosen.iter().map(move |place| (network, *place)))
        .collect();
    let times: Vec<Reached> = times
        .into_par_iter()
        .map(|(network, place)| Reached::of(&network.distances(place, |weight| weight.time)))
        .collect();
    let sizes = [step(&lengths), step(&times)];
    // Places in the network ascend with the nodes.
    let node_of = |place: &u32| places.iter().position(|own| own == place).unwrap_or(0) as u32;
    let fixed: Vec<u32> = chosen.iter().map(node_of).collect();
    let anchors = anchors::find(rows, &fixed, sizes);
    // Anchors in the nodes' order, by their places in the network, and each one's place in the tables.
    let mut kept = Vec::new();
    let mut tables = vec![NONE; places.len()];
    for (node, own) in anchors.iter().enumerate().filter(|(node, a)| a.anchor == *node as u32) {
        tables[node] = kept.len() as u32;
        kept.push(places[own.anchor as usize] as usize);
    }
    let bound =
        |a: &anchors::Anchored| (tables.get(a.anchor as usize).copied().unwrap_or(NONE), a.steps);
    Landmarks {
        bounds: anchors.iter().map(bound).collect(),
        count: kept.len() as u32,
        landmarks: chosen.len() as u32,
        lengths: Distances::of(&lengths, &kept, sizes[0]),
        times: Distances::of(&times, &kept, sizes[1]),
    }
}

/// Per place in the tables its place in an order that depends on names only.
fn ranks(rows: &Rows, bounds: &[u32], count: usize) -> Vec<u32> {
    let mut ranks = vec![NONE; count];
    for (rank, node) in in_order(rows).enumerate() {
        let bound = bounds.get(node as usize).copied().unwrap_or(NONE);
        if let Some(own) = ranks.get_mut(bound as usize) {
            *own = rank as u32;
        }
    }
    ranks
}

/// What an edge costs.
#[derive(Clone, Copy)]
struct Weight {
    length: f64,
    time: f64,
}

/// The graph of motor vehicles as compressed sparse rows.
struct Network {
    offsets: Vec<u32>,
    targets: Vec<(u32, Weight)>,
}

impl Network {
    fn new(rows: &Rows, bounds: &[u32], count: usize) -> Self {
        let bound = |node: u32| bounds.get(node as usize).copied().unwrap_or(NONE);
        let mut edges = Vec::new();
        for (number, (node, own)) in rows.lane_nodes.iter().zip(bounds).enumerate() {
            if *own == NONE {
                continue;
            }
            let at = |i: usize| rows.successor_offsets.get(i).copied().unwrap_or(0) as usize;
            let ahead = rows.successors.get(at(number)..at(number + 1)).unwrap_or(&[]);
            let pass = Weight { length: node.length.into(), time: node.time.into() };
            let change = Weight { length: CHANGE_LENGTH, time: CHANGE_TIME };
            let beside_it = [node.left, node.right].map(|beside| beside_row(number as u32, beside));
            let sides =
                [node_flags::CHANGE_LEFT, node_flags::CHANGE_RIGHT].into_iter().zip(beside_it);
            let beside = sides.filter(|(flag, _)| node.flags & flag != 0);
            let all = ahead.iter().map(|to| (*to, pass)).chain(beside.map(|(_, to)| (to, change)));
            let usable = all.map(|(to, weight)| (*own, bound(to), weight));
            edges.extend(usable.filter(|(_, to, _)| *to != NONE));
        }
        Self::of(edges, count)
    }

    fn of(mut edges: Vec<(u32, u32, Weight)>, count: usize) -> Self {
        edges.sort_by_key(|(from, ..)| *from);
        let mut offsets = vec![0; count + 1];
        for (from, ..) in &edges {
            offsets[*from as usize + 1] += 1;
        }
        for i in 0..count {
            offsets[i + 1] += offsets[i];
        }
        Self { offsets, targets: edges.into_iter().map(|(_, to, weight)| (to, weight)).collect() }
    }

    fn edges(&self, place: usize) -> &[(u32, Weight)] {
        let range = self.offsets[place] as usize..self.offsets[place + 1] as usize;
        self.targets.get(range).unwrap_or(&[])
    }

    fn turned(&self) -> Self {
        let count = self.offsets.len() - 1;
        let all = (0..count)
            .flat_map(|from| self.edges(from).iter().map(move |(to, w)| (*to, from as u32, *w)));
        Self::of(all.collect(), count)
    }

    /// Distances from a place to all (Dijkstra); infinite where there is no way.
    fn distances(&self, from: u32, weight: fn(&Weight) -> f64) -> Vec<f64> {
        let mut distances = vec![f64::INFINITY; self.offsets.len() - 1];
        distances[from as usize] = 0.0;
        // Distances are not negative: their bits order as they do.
        let mut open = BinaryHeap::from([Reverse((0f64.to_bits(), from))]);
        while let Some(Reverse((bits, place))) = open.pop() {
            let distance = f64::from_bits(bits);
            if distance > distances[place as usize] {
                continue;
            }
            for (to, cost) in self.edges(place as usize) {
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

/// Distances, but for the unreached places before the first that is reached and behind the last: of a map whose parts are not
/// joined, as tiles side by side, most are.
struct Reached {
    first: usize,
    distances: Vec<f64>,
}

impl Reached {
    fn of(all: &[f64]) -> Self {
        let is_reached = |distance: &f64| distance.is_finite();
        let first = all.iter().position(is_reached).unwrap_or(all.len());
        let end = all.iter().rposition(is_reached).map_or(first, |last| last + 1);
        Self { first, distances: all.get(first..end).unwrap_or_default().to_vec() }
    }

    /// The distance of a place; infinite where there is no way.
    fn get(&self, place: usize) -> f64 {
        let own = place.checked_sub(self.first).and_then(|at| self.distances.get(at));
        own.copied().unwrap_or(f64::INFINITY)
    }
}

/// Landmarks.
#[derive(Default)]
struct Chosen {
    places: Vec<u32>,
    /// Lengths from each.
    from: Vec<Reached>,
    /// Lengths to each.
    to: Vec<Reached>,
}

/// Chooses landmarks one after the other, each the farthest from those before, at the map's ends.
fn choose(ahead: &Network, behind: &Network, ranks: &[u32], wanted: usize) -> Chosen {
    let length = |weight: &Weight| weight.length;
    let mut chosen = Chosen::default();
    let first = (0..ranks.len() as u32).min_by_key(|place| ranks[*place as usize]);
    let Some(first) = first else { return chosen };
    let mut nearest = ahead.distances(first, length);
    while chosen.places.len() < wanted.min(ranks.len()) {
        // Places that cannot be reached come last: most are small islands.
        let far = |place: &u32| {
            let distance = nearest[*place as usize];
            let reached = distance.is_finite() && distance > 0.0;
            (reached, if reached { distance.to_bits() } else { 0 }, Reverse(ranks[*place as usize]))
        };
        let open = (0..ranks.len() as u32).filter(|place| !chosen.places.contains(place));
        let Some(place) = open.max_by_key(far) else { break };
        let (there, back) =
            rayon::join(|| ahead.distances(place, length), || behind.distances(place, length));
        if chosen.places.is_empty() {
            nearest.fill(f64::INFINITY);
        }
        chosen.places.push(place);
        for (near, (there, back)) in nearest.iter_mut().zip(there.iter().zip(&back)) {
            *near = near.min(*there).min(*back);
        }
        chosen.from.push(Reached::of(&there));
        chosen.to.push(Reached::of(&back));
    }
    chosen
}

/// The step in which the largest distance has so many as there may be.
fn step(distances: &[Reached]) -> f64 {
    let all = distances
        .iter()
        .flat_map(|of| &of.distances)
        .copied()
        .filter(|distance| distance.is_finite());
    let most = all.fold(0.0, f64::max);
    if most > 0.0 { most / MOST_STEPS } else { 1.0 }
}

/// Distances of all landmarks, place by place, in steps rounded down.
fn in_steps(distances: &[Reached], places: &[usize], step: f64) -> Vec<u16> {
    let mut out = Vec::with_capacity(places.len() * distances.len());
    for place in places {
        out.extend(distances.iter().map(|of| {
            let distance = of.get(*place);
            if distance.is_finite() { (distance / step) as u16 } else { u16::MAX }
        }));
    }
    out
}
