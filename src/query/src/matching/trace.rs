//! Which lanes a recorded trace was driven in: a hidden Markov model whose states are lanes (Newson and Krumm 2009), solved for
//! the whole trace at once.
//!
//! States of a fix are the lanes that [`Map::match_pose`] gives it, and none; their weights are what the fix says of them. Two
//! states of successive fixes fit together as well as the way along the lane graph between them is as long as the straight one;
//! a change of lane costs what its rarity says. A jump, wherever to, is possible and most improbable: gaps of the map, turns
//! where none is foreseen and changes over solid lines break no trace.

use super::{LaneMatch, MatchError, MatchOptions, VehiclePose};
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::LaneTypes;
use crate::route::{PositionOnLane, Reached, RouteScratch, ShortestLength, share_before};
use crate::types::{LanePosition, Point};
use glam::{DMat3, DVec3};
use mapd_archive::VehicleClass;

/// States of a fix at most, the most probable ones, `none` not counted.
const MOST_STATES: usize = 32;
/// Deviation of a heading that was not measured `[rad]`: it counts for nothing.
const NO_HEADING: f64 = 1e2;
/// Mean difference between the way along the lanes and the straight one `[m]`, of exact fixes.
const DETOUR: f64 = 1.0;
/// The same of fixes far apart, as a share of the straight way: streets go round corners.
const DETOUR_SHARE: f64 = 0.25;
/// Ways longer than the straight one by this factor, and by this many deviations, are not looked for.
const LONGEST_DETOUR: f64 = 2.0;
const LONGEST_NOISE: f64 = 6.0;
/// Changes of lane between two fixes that are looked for.
const MOST_CHANGES: f64 = 2.0;
/// Probability of a change of lane is never said to be below this, however close together fixes are.
const LEAST_CHANGE: f64 = 1e-6;
/// Edges over which noise may lead back.
const MOST_BACK: usize = 3;
/// Logarithms of the probabilities of a turn on the spot, of a jump, of leaving all lanes, and of coming back to one of them.
const TURN: f64 = -9.0;
const JUMP: f64 = -14.0;
const LEAVE: f64 = -5.0;
const RETURN: f64 = -3.0;

/// A place of a trace.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TraceFix {
    /// When `[s]`; does not fall along the trace.
    pub time: f64,
    /// Where, inertial `[m]`.
    pub position: Point,
    /// Which way it heads `[rad]`, if known.
    pub heading: Option<f64>,
}

/// How a trace is matched.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct TraceOptions {
    /// Standard deviation of x and of y `[m]`, positive. Default 1.
    pub deviation: f64,
    /// Standard deviation of headings `[rad]`, of fixes that have one. Default 0.1.
    pub heading_deviation: f64,
    /// The class of the vehicle: lanes that it may not use are improbable. Default: passenger car.
    pub vehicle: VehicleClass,
    /// Mean time between changes of lane `[s]`, positive. Default 30.
    pub change_interval: f64,
    /// Lane types that count. Default those that motor vehicles travel on.
    pub types: LaneTypes,
}

impl Default for TraceOptions {
    fn default() -> Self {
        Self {
            deviation: 1.0,
            heading_deviation: 0.1,
            vehicle: VehicleClass::PassengerCar,
            change_interval: 30.0,
            types: LaneTypes::routable(),
        }
    }
}

/// A lane, and a position with respect to it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TracePosition {
    /// The lane.
    pub lane: LaneId,
    /// The place with respect to it.
    pub position: LanePosition,
}

/// Where a fix of a trace was.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TraceMatch {
    /// The lane and the place with respect to it; `None` where the trace is on no lane.
    pub place: Option<TracePosition>,
    /// Whether it travels towards +s.
    pub forward: bool,
    /// Probability of this state, given the whole trace.
    pub probability: f64,
}

/// Room to work in; used again, it does not allocate unless a trace is larger.
#[derive(Default)]
pub struct TraceScratch {
    route: RouteScratch,
    reached: Vec<Reached>,
    candidates: Vec<LaneMatch>,
    /// States of all fixes, those of each one after another; `None` is on no lane.
    states: Vec<Option<LaneMatch>>,
    /// Where each fix's states begin, and their end.
    first: Vec<usize>,
    /// Logarithm of what each fix says of its states.
    seen: Vec<f64>,
    /// Logarithms of steps: of each fix but the last, for each of its states all those of the next.
    steps: Vec<f32>,
    /// Where each fix's steps begin.
    first_step: Vec<usize>,
    /// Logarithms over states: of the best way there and all ways there, and of all ways from there.
    best: Vec<f64>,
    ahead: Vec<f64>,
    behind: Vec<f64>,
    /// State before, on the best way.
    before: Vec<usize>,
}

impl Map<'_> {
    /// The lanes of a trace, a place for each fix: the most probable way through all of them, with the probability of each place
    /// given the whole trace. `out` is emptied first; it and `scratch` grow only if they are too small.
    ///
    /// Errors: by the number of the fix, what is not finite and times that fall; options out of their domain.
    pub fn match_trace(
        &self,
        fixes: &[TraceFix],
        options: &TraceOptions,
        scratch: &mut TraceScratch,
        out: &mut Vec<TraceMatch>,
    ) -> Result<(), MatchError> {
        out.clear();
        check(fixes, options)?;
        scratch.clear();
        for fix in fixes {
            self.states_of(fix, options, scratch)?;
        }
        scratch.first.push(scratch.states.len());
        for (number, pair) in fixes.windows(2).enumerate() {
            self.steps_between(number, pair, options, scratch)?;
        }
        scratch.solve(out);
        Ok(())
    }

    fn states_of(
        &self,
        fix: &TraceFix,
        options: &TraceOptions,
        scratch: &mut TraceScratch,
    ) -> Result<(), MatchError> {
        let heading = fix.heading.map_or(NO_HEADING, |_| options.heading_deviation);
        let deviations = DVec3::new(options.deviation, options.deviation, heading);
        let covariance = DMat3::from_diagonal(deviations * deviations);
        let pose = VehiclePose { position: fix.position, heading: fix.heading.unwrap_or(0.0) };
        let matching = MatchOptions {
            types: options.types,
            vehicle: Some(options.vehicle),
            ..MatchOptions::default()
        };
        let none = self.match_pose(&pose, &covariance, &matching, &mut scratch.candidates)?;
        scratch.first.push(scratch.states.len());
        for candidate in scratch.candidates.iter().take(MOST_STATES) {
            scratch.states.push(Some(*candidate));
            scratch.seen.push(libm::log(candidate.probability));
        }
        scratch.states.push(None);
        scratch.seen.push(libm::log(none.max(f64::MIN_POSITIVE)));
        Ok(())
    }

    /// How well each state of the fix of this number is followed by each of the next one's.
    fn steps_between(
        &self,
        number: usize,
        pair: &[TraceFix],
        options: &TraceOptions,
        scratch: &mut TraceScratch,
    ) -> Result<(), MatchError> {
        let [from, to] = pair else { return Ok(()) };
        // Of two places with noise the square of the distance is greater by four variances.
        let noise = 4.0 * options.deviation * options.deviation;
        let straight = from.position.xy.distance_squared(to.position.xy);
        let straight = (straight - noise).max(0.0).sqrt();
        let scale = DETOUR + options.deviation + DETOUR_SHARE * straight;
        let change = 1.0 - libm::exp(-(to.time - from.time) / options.change_interval);
        let cost = ShortestLength { lane_change: -libm::log(change.max(LEAST_CHANGE)) * scale };
        let limit =
            LONGEST_DETOUR * straight + LONGEST_NOISE * scale + MOST_CHANGES * cost.lane_change;
        let [first, next, end] = [0, 1, 2].map(|i| scratch.first[number + i]);
        scratch.first_step.push(scratch.steps.len());
        for state in first..next {
            let Some(a) = scratch.states[state] else {
                let stays =
                    |state: &Option<LaneMatch>| if state.is_none() { 0.0 } else { RETURN as f32 };
                scratch.steps.extend(scratch.states[next..end].iter().map(stays));
                continue;
            };
            let place = PositionOnLane { lane: a.lane, s: a.position.s };
            let (route, reached) = (&mut scratch.route, &mut scratch.reached);
            self.reachable(place, limit, options.vehicle, &cost, route, reached)?;
            for b in &scratch.states[next..end] {
                let step = match b {
                    None => LEAVE,
                    Some(b) => {
                        let least = if self.turns(&a, b) { TURN } else { JUMP };
                        let way = self.way(&a, b, reached);
                        way.map_or(least, |way| (-(way - straight).abs() / scale).max(least))
                    }
                };
                scratch.steps.push(step as f32);
            }
        }
        Ok(())
    }

    /// Whether a state heads back on the other's road.
    fn turns(&self, a: &LaneMatch, b: &LaneMatch) -> bool {
        let road = |m: &LaneMatch| self.lane(m.lane).ok().map(|lane| lane.road().road_id());
        a.forward != b.forward && road(a) == road(b)
    }

    /// What the way from a state to another costs `[m]`; below 0 where it leads back along the lane or into the one before.
    fn way(&self, a: &LaneMatch, b: &LaneMatch, reached: &[Reached]) -> Option<f64> {
        let node = |m: &LaneMatch| self.lane(m.lane).ok()?.node_at(m.position.s, m.forward);
        let (from, to) = (node(a)?, node(b)?);
        let done =
            |node: &LaneNode<'_>, m: &LaneMatch| share_before(node, m.position.s) * node.length();
        let (done_a, done_b) = (done(&from, a), done(&to, b));
        let beside = |lane: &Lane<'_>| {
            self.lane(a.lane)
                .is_ok_and(|own| own.section().section_id() == lane.section().section_id())
        };
        match reached.iter().find(|reached| reached.node == to.node_id()) {
            // Beside the start, and the start itself: what was passed of it is passed here too.
            Some(found)
                if a.forward == b.forward
                    && to.lane().is_some_and(|lane| beside(&lane))
                    && overlap(&from, &to) =>
            {
                Some(found.cost + done_b - done_a)
            }
            Some(found) => Some(found.cost + done_b),
            None => way_back(&from, &to, MOST_BACK)
                .map(|between| -(done_a + between + to.length() - done_b)),
        }
    }
}

/// Length of the nodes between one and another that leads to it over no more than so many edges `[m]`.
fn way_back(from: &LaneNode<'_>, to: &LaneNode<'_>, edges: usize) -> Option<f64> {
    let left = edges.checked_sub(1)?;
    let through = |before: LaneNode<'_>| match before.node_id() == to.node_id() {
        true => Some(0.0),
        false => way_back(&before, to, left).map(|between| before.length() + between),
    };
    from.predecessors().filter_map(through).min_by(f64::total_cmp)
}

/// Whether two nodes of a section have an s in common.
fn overlap(a: &LaneNode<'_>, b: &LaneNode<'_>) -> bool {
    let SRange { low: from, high: to } = a.s_range();
    let SRange { low, high } = b.s_range();
    from < high && low < to
}

fn check(fixes: &[TraceFix], options: &TraceOptions) -> Result<(), MatchError> {
    let positive = |value: f64| value > 0.0 && value.is_finite();
    let rules = [
        ("deviation", positive(options.deviation)),
        (
            "heading_deviation",
            options.heading_deviation >= 0.0 && options.heading_deviation.is_finite(),
        ),
        ("change_interval", positive(options.change_interval)),
    ];
    if let Some((name, _)) = rules.iter().find(|(_, holds)| !holds) {
        return Err(MatchError::Option(name));
    }
    let mut last = f64::NEG_INFINITY;
    for (number, fix) in fixes.iter().enumerate() {
        let numbers = [Some(fix.time), fix.heading];
        if !fix.position.is_place() || !numbers.iter().flatten().all(|n| n.is_finite()) {
            return Err(MatchError::Fix(number));
        }
        if fix.time < last {
            return Err(MatchError::Time(number));
        }
        last = fix.time;
    }
    Ok(())
}

/// Logarithm of a sum, of two logarithms.
fn add(a: f64, b: f64) -> f64 {
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    if low == f64::NEG_INFINITY { high } else { high + libm::log1p(libm::exp(low - high)) }
}

impl TraceScratch {
    fn clear(&mut self) {
        let numbers = [&mut self.seen, &mut self.best, &mut self.ahead, &mut self.behind];
        numbers.into_iter().for_each(Vec::clear);
        [&mut self.first, &mut self.first_step, &mut self.before].into_iter().for_each(Vec::clear);
        self.states.clear();
        self.steps.clear();
    }

    /// Viterbi's way, and forwards and backwards over all ways.
    fn solve(&mut self, out: &mut Vec<TraceMatch>) {
        let fixes = self.first.len().saturating_sub(1);
        let count = self.states.len();
        for numbers in [&mut self.best, &mut self.ahead, &mut self.behind] {
            numbers.resize(count, f64::NEG_INFINITY);
        }
        self.before.resize(count, 0);
        for fix in 0..fixes {
            let (first, end) = (self.first[fix], self.first[fix + 1]);
            let start = fix.checked_sub(1).map_or(first, |before| self.first[before]);
            for state in first..end {
                let (mut best, mut all) = ((f64::NEG_INFINITY, start), f64::NEG_INFINITY);
                if fix == 0 {
                    (best.0, all) = (0.0, 0.0);
                }
                for before in start..first {
                    let at = self.first_step[fix - 1] + (before - start) * (end - first);
                    let step = f64::from(self.steps[at + state - first]);
                    if self.best[before] + step > best.0 {
                        best = (self.best[before] + step, before);
                    }
                    all = add(all, self.ahead[before] + step);
                }
                self.best[state] = best.0 + self.seen[state];
                self.before[state] = best.1;
                self.ahead[state] = all + self.seen[state];
            }
        }
        for fix in (0..fixes).rev() {
            let (first, end) = (self.first[fix], self.first[fix + 1]);
            for state in first..end {
                self.behind[state] = match self.first.get(fix + 2) {
                    None => 0.0,
                    Some(after) => (end..*after).fold(f64::NEG_INFINITY, |all, next| {
                        let at = self.first_step[fix] + (state - first) * (after - end);
                        let step = f64::from(self.steps[at + next - end]);
                        add(all, step + self.seen[next] + self.behind[next])
                    }),
                };
            }
        }
        let last = fixes.checked_sub(1).map_or(0, |last| self.first[last]);
        let Some(mut state) = (last..count).max_by(|a, b| self.best[*a].total_cmp(&self.best[*b]))
        else {
            return;
        };
        for fix in (0..fixes).rev() {
            let whole = (self.first[fix]..self.first[fix + 1])
                .map(|state| self.ahead[state] + self.behind[state])
                .fold(f64::NEG_INFINITY, add);
            let own = self.ahead[state] + self.behind[state];
            let found = self.states[state];
            out.push(TraceMatch {
                place: found
                    .map(|found| TracePosition { lane: found.lane, position: found.position }),
                forward: found.is_some_and(|found| found.forward),
                probability: libm::exp(own - whole).min(1.0),
            });
            state = self.before[state];
        }
        out.reverse();
    }
}
