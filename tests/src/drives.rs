//! Drives along the lane graph that nobody drove: where the vehicle is, and what a receiver with noise says of it.

use crate::maps::Random;
use mapd_client::SRange;
use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::graph::LaneNode;
use mapd_client::localisation::{
    TraceFix, TraceOptions, TraceScratch, Tracker, TrackerFix, TrackerOptions, VehiclePose,
};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{LaneId, LaneTypes, Map, NearestOptions, NodeId};
use std::f64::consts::TAU;

/// Speed `[m/s]`.
const SPEED: f64 = 12.0;
/// Between places of a drive `[s]`.
const STEP: f64 = 0.1;
/// Mean time between changes of lane, where one is allowed, and how long one takes `[s]`.
const CHANGE_INTERVAL: f64 = 20.0;
const CHANGE_TIME: f64 = 3.0;

/// Where a vehicle was.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    /// When `[s]`.
    pub time: f64,
    /// In which lane: that of the middle of the vehicle.
    pub lane: LaneId,
    /// Where `[m]`.
    pub position: DVec2,
    /// Which way `[rad]`.
    pub heading: f64,
}

/// Normally distributed (Box and Muller).
pub fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
    radius * (TAU * random.unit()).cos()
}

/// Whether a drive may use a node.
fn is_driven(node: &LaneNode<'_>) -> bool {
    let lane = node.lane().filter(|lane| lane.kind().is_drivable());
    node.allows(VehicleClass::PassengerCar)
        && lane.is_some_and(|lane| lane.is_forward() == node.is_forward())
}

/// Metres of s along a node.
fn length(node: &LaneNode<'_>) -> f64 {
    let SRange { low, high } = node.s_range();
    high - low
}

/// A place in the middle of a node's lane.
fn place(node: &LaneNode<'_>, s: f64) -> Option<(DVec2, f64)> {
    let at = node.lane()?.waypoint_at(s).ok()?;
    Some((at.position.truncate(), at.heading))
}

/// A drive of some seconds, ten places a second, from a place drawn by chance; shorter where the lanes end. Junctions are passed
/// by chance, lanes are changed where marks allow it.
pub fn drive(map: Map<'_>, seconds: f64, random: &mut Random) -> Vec<Truth> {
    let nodes: Vec<NodeId> =
        map.lane_nodes().filter(is_driven).map(|node| node.node_id()).collect();
    let of = |id: NodeId| map.lane_nodes().find(|node| node.node_id() == id);
    let Some(mut node) = of(nodes[(random.unit() * nodes.len() as f64) as usize]) else {
        return vec![];
    };
    let (mut gone, mut from, mut truth) = (0.0, None::<(LaneNode<'_>, f64)>, Vec::new());
    for i in 0..(seconds / STEP) as usize {
        let SRange { low, high } = node.s_range();
        let s = if node.is_forward() { low + gone } else { high - gone };
        let Some((mut position, heading)) = place(&node, s) else { break };
        let mut lane = node.lane().expect("a lane").lane_id();
        if let Some((before, start)) = from {
            let share = (i as f64 * STEP - start) / CHANGE_TIME;
            let share = 0.5 - 0.5 * (0.5 * TAU * share.min(1.0)).cos();
            if let Some((beside, _)) = place(&before, s) {
                position = beside.lerp(position, share);
                if share < 0.5 {
                    lane = before.lane().expect("a lane").lane_id();
                }
            }
            if share >= 1.0 {
                from = None;
            }
        }
        truth.push(Truth { time: i as f64 * STEP, lane, position, heading });
        gone += SPEED * STEP;
        // Enough is left of the node to end a change on it.
        let is_long = length(&node) - gone > SPEED * (CHANGE_TIME + STEP);
        if from.is_none() && is_long && random.unit() < STEP / CHANGE_INTERVAL {
            let sides = [node.change_left(), node.change_right()];
            let side = sides[usize::from(random.unit() < 0.5)].filter(is_driven);
            // The pieces must run side by side from here on.
            if let Some(side) = side.filter(|side| side.s_range() == node.s_range()) {
                from = Some((node, i as f64 * STEP));
                node = side;
            }
        }
        while gone > length(&node) {
            gone -= length(&node);
            from = None;
            let next: Vec<LaneNode<'_>> =
                node.edges().filter_map(|edge| edge.target()).filter(is_driven).collect();
            if next.is_empty() {
                return truth;
            }
            node = next[(random.unit() * next.len() as f64) as usize];
        }
    }
    truth
}

/// What a receiver says of every n-th place: with normal noise `[m]`, without a heading.
pub fn receive(truth: &[Truth], every: usize, noise: f64, random: &mut Random) -> Vec<TraceFix> {
    let mut one = |truth: &Truth| {
        let away = DVec2::new(normal(random), normal(random)) * noise;
        TraceFix { time: truth.time, position: (truth.position + away).into(), heading: None }
    };
    truth.iter().step_by(every).map(&mut one).collect()
}

/// What a localiser says of every n-th place: with normal noise `[m]` and `[rad]`, and the covariance of that; with an exact odometer
/// or none.
pub fn localise(
    truth: &[Truth],
    every: usize,
    [noise, turn]: [f64; 2],
    odometer: bool,
    random: &mut Random,
) -> Vec<TrackerFix> {
    let deviations = DVec3::new(noise, noise, turn);
    let covariance = DMat3::from_diagonal(deviations * deviations);
    let mut one = |(i, truth): (usize, &Truth)| {
        let away = DVec2::new(normal(random), normal(random)) * noise;
        let heading = truth.heading + turn * normal(random);
        TrackerFix {
            time: truth.time,
            pose: VehiclePose { position: (truth.position + away).into(), heading },
            covariance,
            odometer: odometer.then_some(i as f64 * SPEED * STEP),
        }
    };
    truth.iter().enumerate().step_by(every).map(&mut one).collect()
}

/// Share of fixes whose lane a tracker finds, each by those before it, and the mean of the probabilities that it gives them.
pub fn tracked(
    map: Map<'_>,
    noise: [f64; 2],
    every: usize,
    odometer: bool,
    drives: u64,
) -> [f64; 2] {
    let (mut tracker, options) = (Tracker::new(), TrackerOptions::default());
    let (mut right, mut said, mut all) = (0.0, 0.0, 0.0);
    for seed in 1..=drives {
        let random = &mut Random(seed * 7919);
        let truth = drive(map, 120.0, random);
        let fixes = localise(&truth, every, noise, odometer, random);
        tracker.reset();
        for (fix, truth) in fixes.iter().zip(truth.iter().step_by(every)) {
            tracker.update(map, fix, &options).expect("an answer");
            let best = tracker.hypotheses().first();
            right += f64::from(u8::from(best.is_some_and(|best| best.lane == truth.lane)));
            said += best.map_or(0.0, |best| best.probability);
            all += 1.0;
        }
    }
    [right, said].map(|sum| sum / f64::max(all, 1.0))
}

/// Shares of fixes whose lane is right: of the trace matched as a whole, and of the nearest lane to each fix.
pub fn accuracy(map: Map<'_>, noise: f64, every: usize, drives: u64) -> [f64; 2] {
    let options = TraceOptions { deviation: noise, ..TraceOptions::default() };
    let nearest = NearestOptions { types: LaneTypes::drivable(), ..NearestOptions::default() };
    let (mut scratch, mut out) = (TraceScratch::default(), Vec::new());
    let (mut right, mut all) = ([0.0, 0.0], 0.0);
    for seed in 1..=drives {
        let random = &mut Random(seed * 7919);
        let truth = drive(map, 120.0, random);
        let fixes = receive(&truth, every, noise, random);
        map.match_trace(&fixes, &options, &mut scratch, &mut out).expect("an answer");
        for ((fix, found), truth) in fixes.iter().zip(&out).zip(truth.iter().step_by(every)) {
            let plain = map.nearest_lane(fix.position, &nearest).expect("an answer");
            let lanes = [found.place.map(|place| place.lane), plain.map(|plain| plain.lane)];
            for (right, lane) in right.iter_mut().zip(lanes) {
                *right += f64::from(u8::from(lane == Some(truth.lane)));
            }
            all += 1.0;
        }
    }
    right.map(|right| right / f64::max(all, 1.0))
}
