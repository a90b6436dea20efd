//! Drives along the lane graph that nobody drove: where the vehicle is, and what a receiver with noise says of it.

use crate::maps::Random;
use mapd_client::SRange;
use mapd_client::glam::{DMat3, DVec2, DVec3};
use mapd_client::graph::LaneNode;
use mapd_client::localisation::{
    LaneMatch, MatchOptions, TraceFix, TraceOptions, TraceScratch, Tracker, TrackerFix,
    TrackerOptions, VehiclePose,
};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{LaneId, LaneTypes, Map, NearestOptions, NodeId};
use std::collections::BTreeMap;
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
    let nearest = NearestOptions { types: LaneTypes::routable(), ..NearestOptions::default() };
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

/// Bins of stated probability.
pub const BINS: usize = 5;
/// Centre lines of lanes that are farther apart leave no doubt `[m]`.
const APART: f64 = 1.2;
/// Around a true place, in which other lanes count `[m]`.
const AROUND: f64 = 6.0;
/// Step along a lane, of the places where a vehicle may have been `[m]`.
const PLACE_STEP: f64 = 0.1;
/// Deviations of a place's distance from a fix, from which on it does not count.
const FAR: f64 = 8.0;

/// A lane that was said to be the one, and how probable.
trait Guess {
    fn lane(&self) -> LaneId;
    fn probability(&self) -> f64;
}

impl Guess for LaneMatch {
    fn lane(&self) -> LaneId {
        self.lane
    }

    fn probability(&self) -> f64 {
        self.probability
    }
}

impl Guess for (LaneId, f64) {
    fn lane(&self) -> LaneId {
        self.0
    }

    fn probability(&self) -> f64 {
        self.1
    }
}

/// How often an answer was right.
#[derive(Clone, Debug, Default)]
pub struct Score {
    /// Fixes, and those whose most probable lane is not the true one.
    pub all: f64,
    /// Of these.
    pub wrong: f64,
    /// The same of fixes where the centre lines of all other lanes are more than 1.2 m away from the true one.
    pub all_apart: f64,
    /// Of these.
    pub wrong_apart: f64,
    /// Of each bin of stated probability: hypotheses, the sum of what was stated, and how many were true.
    pub bins: [[f64; 3]; BINS],
}

impl Score {
    /// Adds the fixes of another.
    pub fn add(&mut self, other: &Self) {
        let counts = [
            (&mut self.all, other.all),
            (&mut self.wrong, other.wrong),
            (&mut self.all_apart, other.all_apart),
            (&mut self.wrong_apart, other.wrong_apart),
        ];
        counts.into_iter().for_each(|(own, more)| *own += more);
        for (own, more) in self.bins.iter_mut().flatten().zip(other.bins.iter().flatten()) {
            *own += more;
        }
    }

    /// Share of wrong lanes.
    pub fn wrong(&self) -> f64 {
        self.wrong / self.all.max(1.0)
    }

    /// Share of wrong lanes where no other lane's centre line is near.
    pub fn wrong_apart(&self) -> f64 {
        self.wrong_apart / self.all_apart.max(1.0)
    }

    /// The largest difference of stated and true shares over bins with so many hypotheses.
    pub fn worst_bin(&self, least: f64) -> f64 {
        let known = self.bins.iter().filter(|bin| bin[0] >= least);
        known.map(|[n, said, was]| (said - was).abs() / n).fold(0.0, f64::max)
    }

    fn take(&mut self, found: &[impl Guess], truth: &Truth, is_apart: bool) {
        let is_wrong = found.first().is_none_or(|best| best.lane() != truth.lane);
        let wrong = f64::from(u8::from(is_wrong));
        (self.all, self.wrong) = (self.all + 1.0, self.wrong + wrong);
        if is_apart {
            (self.all_apart, self.wrong_apart) = (self.all_apart + 1.0, self.wrong_apart + wrong);
        }
        for one in found {
            let bin = ((one.probability() * BINS as f64) as usize).min(BINS - 1);
            let [n, said, was] = &mut self.bins[bin];
            *n += 1.0;
            *said += one.probability();
            *was += f64::from(u8::from(one.lane() == truth.lane));
        }
    }
}

/// Answers on simulated drives.
#[derive(Clone, Debug, Default)]
pub struct Judgement {
    /// Of each pose alone.
    pub pose: Score,
    /// Of each pose, with the lanes that can be reached from the true lane of the fix before as expected ones.
    pub last_lane: Score,
    /// Of all poses up to each.
    pub tracker: Score,
    /// Of the best guess by each pose, the true lane of the fix before, and the way driven since then: by Bayes, from how drives are simulated, but
    /// without their changes of lane.
    pub bayes: Score,
}

/// How a driver keeps to the middle of a lane: standard deviations from it `[m]`, over some seconds alike, and from its direction `[rad]`.
pub type Wander = [f64; 2];
/// Time over which a driver's distance from the middle is alike `[s]`.
const WANDER_TIME: f64 = 5.0;

/// Moves the places of a drive as a driver would.
fn wander(truth: &mut [Truth], [aside, turn]: Wander, random: &mut Random) {
    let keeps = (-STEP / WANDER_TIME).exp();
    let mut away = aside * normal(random);
    for place in truth {
        place.position += DVec2::from_angle(place.heading).perp() * away;
        place.heading += turn * normal(random);
        away = keeps * away + (1.0 - keeps * keeps).sqrt() * aside * normal(random);
    }
}

/// Drives of two minutes, judged at every n-th place.
pub fn judge(
    map: Map<'_>,
    noise: [f64; 2],
    every: usize,
    wandering: Wander,
    drives: u64,
) -> Judgement {
    let types = LaneTypes::routable();
    let plain = MatchOptions { types, ..MatchOptions::default() };
    let (mut tracker, options) = (Tracker::new(), TrackerOptions::default());
    let (mut judged, mut out, mut guesses) = (Judgement::default(), Vec::new(), Vec::new());
    for seed in 1..=drives {
        let random = &mut Random(seed * 7919);
        let mut truth = drive(map, 120.0, random);
        wander(&mut truth, wandering, random);
        let fixes = localise(&truth, every, noise, true, random);
        tracker.reset();
        for (i, fix) in fixes.iter().enumerate() {
            let place = &truth[i * every];
            let is_apart = is_apart(map, place);
            tracker.update(map, fix, &options).expect("an answer");
            judged.tracker.take(tracker.hypotheses(), place, is_apart);
            let none = map.match_pose(&fix.pose, &fix.covariance, &plain, &mut out);
            none.expect("an answer");
            judged.pose.take(&out, place, is_apart);
            let Some(before) = i.checked_sub(1).map(|before| &truth[before * every]) else {
                continue;
            };
            let places = driven_to(map, before.lane, every as f64 * SPEED * STEP);
            let mut lanes: Vec<LaneId> = places.iter().map(|place| place.0).collect();
            lanes.sort();
            lanes.dedup();
            let expecting = MatchOptions { expected: &lanes, ..plain };
            let none = map.match_pose(&fix.pose, &fix.covariance, &expecting, &mut out);
            none.expect("an answer");
            judged.last_lane.take(&out, place, is_apart);
            let mut weights: BTreeMap<LaneId, f64> = BTreeMap::new();
            for (lane, s, share) in places {
                *weights.entry(lane).or_default() += share * likelihood(map, lane, s, fix, noise);
            }
            let sum: f64 = weights.values().sum();
            if sum > 0.0 {
                guesses.clear();
                guesses.extend(weights.into_iter().map(|(lane, weight)| (lane, weight / sum)));
                guesses.sort_by(|a, b| b.1.total_cmp(&a.1));
                judged.bayes.take(&guesses, place, is_apart);
            }
        }
    }
    judged
}

/// Where a vehicle may be that was anywhere in a lane and has driven some way: lane, s, and how probable that is.
fn driven_to(map: Map<'_>, lane: LaneId, way: f64) -> Vec<(LaneId, f64, f64)> {
    let own = map.lane(lane).expect("a lane");
    let mut all = Vec::new();
    for node in own.nodes().filter(is_driven) {
        let mut gone = 0.5 * PLACE_STEP;
        while gone < length(&node) {
            go_on(&node, gone + way, 1.0, &mut all);
            gone += PLACE_STEP;
        }
    }
    all
}

/// Places so far from a node's beginning, shared at forks.
fn go_on(node: &LaneNode<'_>, gone: f64, share: f64, out: &mut Vec<(LaneId, f64, f64)>) {
    let left = gone - length(node);
    if left <= 0.0 {
        let SRange { low, high } = node.s_range();
        let s = if node.is_forward() { low + gone } else { high - gone };
        return out.push((node.lane().expect("a lane").lane_id(), s, share));
    }
    let next: Vec<LaneNode<'_>> =
        node.edges().filter_map(|edge| edge.target()).filter(is_driven).collect();
    for after in &next {
        go_on(after, left, share / next.len() as f64, out);
    }
}

/// Density of a fix of a vehicle in the middle of a lane, up to a factor.
fn likelihood(map: Map<'_>, lane: LaneId, s: f64, fix: &TrackerFix, deviations: [f64; 2]) -> f64 {
    let [noise, turn] = deviations;
    let Ok(at) = map.lane(lane).expect("a lane").waypoint_at(s) else { return 0.0 };
    let away = at.position.truncate().distance_squared(fix.pose.position.xy);
    if away > (FAR * noise).powi(2) {
        return 0.0;
    }
    let error = (at.heading - fix.pose.heading + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
    (-0.5 * (away / (noise * noise) + error * error / (turn * turn))).exp()
}

/// Whether the centre lines of all other lanes with about the same direction are far from the true one's.
fn is_apart(map: Map<'_>, truth: &Truth) -> bool {
    let own = map.lane(truth.lane).expect("a lane");
    let Ok(at) = own.position_of(truth.position) else { return false };
    let Ok(center) = own.waypoint_at(at.s) else { return false };
    let options = NearestOptions {
        radius: AROUND,
        types: LaneTypes::routable(),
        heading: Some(truth.heading),
        heading_tolerance: Some(0.25 * TAU),
        ..NearestOptions::default()
    };
    let mut near = Vec::new();
    map.lanes_near(center.position.truncate(), &options, &mut near).expect("an answer");
    near.iter().filter(|one| one.lane != truth.lane).all(|one| {
        let lane = map.lane(one.lane).expect("a lane");
        let there = lane.waypoint_at(one.position.s).expect("a place");
        there.position.truncate().distance(center.position.truncate()) > APART
    })
}
