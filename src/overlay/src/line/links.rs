//! Which lanes a line may go on to: by links, over lanes that are shorter than its steps.

use super::walk::{AS_NEAR, Candidate, Step, end};
use super::{NEAR_END, STEP};
use mapd_query::{Lane, Map};
use std::collections::BTreeMap;

/// Most that lanes measure together that lie between two places of a line `[m]`: a step of it on the outside of a bend.
const BETWEEN: f64 = 4.0 * STEP;

/// Most lanes that are looked at from one on.
const MOST_VISITED: usize = 128;

/// A lane moves back along its line by no more than this from place to place `[m]`: on the inside of a bend.
const BACK: f64 = STEP;

/// A lane that is reached by links, and the lanes between.
struct Reached<'a> {
    lane: Lane<'a>,
    between: Vec<Lane<'a>>,
    /// Of those together `[m]`.
    length: f64,
}

/// Links from lanes on, each looked up once.
#[derive(Default)]
pub(super) struct Links<'a> {
    known: BTreeMap<u32, Vec<Reached<'a>>>,
}

impl<'a> Links<'a> {
    /// Looks up what follows a lane.
    pub(super) fn learn(&mut self, map: Map<'a>, lane: &Lane<'a>) {
        self.known.entry(lane.lane_id().row()).or_insert_with(|| reached(map, lane));
    }

    /// How a way goes on between two places; lanes that were not learned have no links.
    pub(super) fn step(&self, from: &Candidate<'a>, to: &Candidate<'a>) -> Step<'_, 'a> {
        let is_same = from.lane.lane_id() == to.lane.lane_id();
        let moved = if to.lane.is_forward() { to.s - from.s } else { from.s - to.s };
        if is_same && moved >= -BACK {
            return Step::Beside;
        }
        let section = from.lane.section();
        if !is_same
            && section.section_id() == to.lane.section().section_id()
            && from.lane.is_forward() == to.lane.is_forward()
        {
            return Step::Beside;
        }
        let known = self.known.get(&from.lane.lane_id().row());
        let reached = known.into_iter().flatten().find(|r| r.lane.lane_id() == to.lane.lane_id());
        // What is far from both ends was not passed within a step.
        let left = (end(&from.lane, false) - from.s).abs();
        let entered = (end(&to.lane, true) - to.s).abs();
        match reached {
            Some(reached) if left.min(entered) <= BETWEEN + NEAR_END => {
                Step::Linked(&reached.between)
            }
            _ => Step::Jump,
        }
    }
}

/// All lanes that links lead to over no more than [`BETWEEN`].
fn reached<'a>(map: Map<'a>, lane: &Lane<'a>) -> Vec<Reached<'a>> {
    let mut found: Vec<Reached<'a>> = Vec::new();
    let mut open: Vec<(Vec<Lane<'a>>, Lane<'a>, f64)> = vec![(Vec::new(), *lane, 0.0)];
    let mut next = 0;
    while next < open.len() && found.len() < MOST_VISITED {
        let (between, last, length) = open[next].clone();
        next += 1;
        for id in last.successors() {
            let Ok(lane) = map.lane(id) else { continue };
            if let Some(known) = found.iter_mut().find(|known| known.lane.lane_id() == id) {
                known.also(&between, length);
                continue;
            }
            found.push(Reached { lane, between: between.clone(), length });
            let section = lane.section();
            let length = length + section.s_end() - section.s_start();
            if length <= BETWEEN {
                let mut between = between.clone();
                between.push(lane);
                open.push((between, lane, length));
            }
        }
    }
    found
}

impl<'a> Reached<'a> {
    /// Another way there: the shorter counts, and both if they are as long: then they lie over each other.
    fn also(&mut self, between: &[Lane<'a>], length: f64) {
        if length > self.length + AS_NEAR {
            return;
        }
        if length < self.length - AS_NEAR {
            self.between.clear();
        }
        for lane in between {
            if !self.between.iter().any(|known| known.lane_id() == lane.lane_id()) {
                self.between.push(*lane);
            }
        }
        self.length = self.length.min(length);
    }
}
