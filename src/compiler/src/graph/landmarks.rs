//! Landmarks: distances from and to a few places, from which routing takes lower bounds of what is left (ALT).
//!
//! Distances are over the graph that all motor vehicles together may use, with a price for each change of lane. So they hold
//! for each class; for a higher price of changes too, and for a lower one in proportion.

use super::anchors;
use super::motor_edges::{CHANGE_LENGTH, CHANGE_TIME, Places, Weight};
use super::motor_ways::{MotorWays, Reached, Room, both_ways};
use mapd_archive::{NONE, Rows};
use rayon::prelude::*;
use std::cmp::Reverse;

/// Largest stored number of steps; the one above stands for "no way".
const MOST_STEPS: f64 = 65_534.0;
/// Places whose distances one task writes.
const PLACES_PER_TASK: usize = 4096;

/// Distances by place, in steps.
#[derive(Default)]
struct Distances {
    /// Length `[m]` or time `[s]` of a step.
    step: f64,
    steps: Vec<u16>,
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
            (graph.change_length, graph.change_time) = (CHANGE_LENGTH.into(), CHANGE_TIME.into());
            (graph.length_step, graph.time_step) = (self.lengths.step, self.times.step);
            graph.landmarks = self.landmarks;
        }
        rows.landmark_lengths = self.lengths.steps.into();
        rows.landmark_times = self.times.steps.into();
    }
}

/// Finds the distances of so many landmarks from and to the anchors of all nodes that motor vehicles may use.
pub(crate) fn find(rows: &Rows, landmarks: usize) -> Landmarks {
    let places = Places::of(rows);
    if places.count == 0 || landmarks == 0 {
        return Landmarks {
            bounds: vec![(NONE, [0; 2]); places.of_nodes.len()],
            lengths: Distances { step: 1.0, steps: Vec::new() },
            times: Distances { step: 1.0, steps: Vec::new() },
            ..Landmarks::default()
        };
    }
    let [ahead, behind] = both_ways(rows, &places);
    let Chosen { places: chosen, from, to } =
        choose([&ahead, &behind], &places.ranks(rows), landmarks);
    let (length, time) = (|weight: &Weight| weight.length, |weight: &Weight| weight.time);
    let ways = || [&ahead, &behind].into_iter();
    let both = ways().zip([from, to]);
    let searched =
        both.flat_map(|(ways, all)| all.into_iter().map(move |reached| Searched { ways, reached }));
    let by_length: Vec<Searched<'_>> = searched.collect();
    let starts: Vec<(&MotorWays, u32)> =
        ways().flat_map(|ways| chosen.iter().map(move |place| (ways, *place))).collect();
    let searched = starts.into_par_iter().map_init(Room::default, |room, (ways, place)| Searched {
        ways,
        reached: ways.distances(place, time, room),
    });
    let by_time: Vec<Searched<'_>> = searched.collect();
    let sizes = [step(&by_length), step(&by_time)];
    let node_of = |place: &u32| places.of_nodes.iter().position(|own| own == place);
    let fixed: Vec<u32> = chosen.iter().filter_map(node_of).map(|node| node as u32).collect();
    let anchors = anchors::find(rows, &fixed, sizes);
    // Anchors by their nodes and by their places, in the nodes' order.
    let mut kept = Kept { numbers: vec![NONE; places.count], count: 0 };
    let mut tables = vec![NONE; anchors.len()];
    for (node, own) in anchors.iter().enumerate().filter(|(node, a)| a.anchor == *node as u32) {
        tables[node] = kept.count as u32;
        kept.add(places.get(own.anchor));
    }
    let bound =
        |a: &anchors::Anchored| (tables.get(a.anchor as usize).copied().unwrap_or(NONE), a.steps);
    let bounds = anchors.iter().map(bound).collect();
    // Memory is short now: all distances are there twice while they are put in order.
    drop((anchors, tables, places));
    Landmarks {
        bounds,
        count: kept.count as u32,
        landmarks: chosen.len() as u32,
        lengths: kept.distances(by_length, sizes[0], length),
        times: kept.distances(by_time, sizes[1], time),
    }
}

/// Places whose distances are kept.
struct Kept {
    /// By place its number among them, or [`NONE`].
    numbers: Vec<u32>,
    /// How many there are.
    count: usize,
}

impl Kept {
    fn add(&mut self, place: u32) {
        self.numbers[place as usize] = self.count as u32;
        self.count += 1;
    }

    /// Their distances, rounded down; those that are not reached have the largest number.
    fn distances(
        &self,
        searched: Vec<Searched<'_>>,
        step: f64,
        weight: impl Fn(&Weight) -> f32 + Copy + Sync,
    ) -> Distances {
        let column = |room: &mut Room, Searched { ways, reached }: Searched<'_>| {
            let mut column = vec![u16::MAX; self.count];
            ways.visit(&reached, weight, room, |place, distance| {
                if let Some(own) = column.get_mut(self.numbers[place as usize] as usize) {
                    *own = (distance / step) as u16;
                }
            });
            column
        };
        let columns = searched.into_par_iter().map_init(Room::default, column);
        let columns: Vec<Vec<u16>> = columns.collect();
        let width = columns.len();
        let mut steps = vec![0; self.count * width];
        let rows = steps.par_chunks_mut(PLACES_PER_TASK * width.max(1));
        rows.enumerate().for_each(|(task, rows)| {
            for (place, row) in (task * PLACES_PER_TASK..).zip(rows.chunks_mut(width.max(1))) {
                for (own, column) in row.iter_mut().zip(&columns) {
                    *own = column[place];
                }
            }
        });
        Distances { step, steps }
    }
}

/// What a search found, and where.
struct Searched<'a> {
    ways: &'a MotorWays,
    reached: Reached,
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
fn choose([ahead, behind]: [&MotorWays; 2], ranks: &[u32], wanted: usize) -> Chosen {
    let length = |weight: &Weight| weight.length;
    let mut chosen = Chosen::default();
    let first = (0..ranks.len() as u32).min_by_key(|place| ranks[*place as usize]);
    let Some(first) = first else { return chosen };
    let mut nearest = vec![f64::INFINITY; ranks.len()];
    let near = |nearest: &mut [f64], ways: &MotorWays, room: &Room| {
        for (place, distance) in ways.found(room) {
            let near = &mut nearest[place as usize];
            *near = near.min(distance);
        }
    };
    let [mut room, mut room_behind] = [Room::default(), Room::default()];
    ahead.distances(first, length, &mut room);
    near(&mut nearest, ahead, &room);
    while chosen.places.len() < wanted.min(ranks.len()) {
        let first = |place: &u32| Reverse(ranks[*place as usize]);
        let far = |place: &u32| (nearest[*place as usize].to_bits(), first(place));
        let places = || 0..ranks.len() as u32;
        // A landmark is at none from itself.
        let is_apart = |distance: f64| distance > 0.0 && distance.is_finite();
        let reached = places().filter(|place| is_apart(nearest[*place as usize]));
        // Places that cannot be reached come last: most are small islands.
        let others = || places().filter(|place| !chosen.places.contains(place)).max_by_key(first);
        let Some(place) = reached.max_by_key(far).or_else(others) else { break };
        let (there, back) = rayon::join(
            || ahead.distances(place, length, &mut room),
            || behind.distances(place, length, &mut room_behind),
        );
        if chosen.places.is_empty() {
            nearest.fill(f64::INFINITY);
        }
        chosen.places.push(place);
        near(&mut nearest, ahead, &room);
        near(&mut nearest, behind, &room_behind);
        chosen.from.push(there);
        chosen.to.push(back);
    }
    chosen
}

/// The step in which the largest distance has so many as there may be.
fn step(searched: &[Searched<'_>]) -> f64 {
    let most = searched.iter().map(|one| one.reached.largest).fold(0.0, f64::max);
    if most > 0.0 { most / MOST_STEPS } else { 1.0 }
}
