//! Following a line: the cheapest way through the lanes near its places.

use super::links::Links;
use super::{Followed, HEADING_TOLERANCE, NEAR_END, STEP};
use crate::places::Stretch;
use mapd_query::glam::DVec2;
use mapd_query::{Lane, LaneTypes, Map, Nearest, NearestOptions};

/// Lanes that are farther than the nearest by no more than this may be meant in its place, if links say so `[m]`.
pub(super) const AS_NEAR: f64 = 0.5;

/// Most lanes that are weighed at a place: the nearest.
const MOST_LANES: usize = 8;

/// What a metre from a lane's centre costs, in metres from its edge: it decides among lanes that lie on each other.
const CENTRE: f64 = 0.01;

/// What going on to a lane costs that is neither linked with the one before nor beside it, in metres from a lane's edge for a step.
const JUMP: f64 = 3.0;

/// Places after which the way so far is settled, so that a long line takes bounded memory.
const SETTLED: usize = 4096;

/// A lane at a place of a line.
#[derive(Clone, Copy)]
pub(super) struct Candidate<'a> {
    pub(super) lane: Lane<'a>,
    pub(super) s: f64,
    /// What it costs to be on it.
    cost: f64,
    /// What the way to here costs, and the candidate before, by its number.
    total: f64,
    before: u8,
}

/// How a way goes on from one lane to another.
pub(super) enum Step<'l, 'a> {
    /// On the same lane, or to one beside it.
    Beside,
    /// By links, through these lanes.
    Linked(&'l [Lane<'a>]),
    /// In no known way.
    Jump,
}

/// Follows a line.
pub(super) struct Walk<'a> {
    map: Map<'a>,
    options: NearestOptions,
    links: Links<'a>,
    /// Places that are not settled yet: the candidates of each.
    columns: Vec<Vec<Candidate<'a>>>,
    /// The lane that the settled way is on, how far, and whether it was entered at its beginning.
    open: Option<Stretch<'a>>,
    near: Vec<Nearest>,
    /// Places at which no lane was, one after the other, up to two; and what is said of the first.
    missing: u8,
    off: String,
    pub(super) out: Followed<'a>,
}

impl<'a> Walk<'a> {
    pub(super) fn new(map: Map<'a>, tolerance: f64) -> Self {
        let options = NearestOptions {
            radius: tolerance,
            types: LaneTypes::routable(),
            heading_tolerance: Some(HEADING_TOLERANCE),
            ..NearestOptions::default()
        };
        Self {
            map,
            options,
            links: Links::default(),
            columns: Vec::new(),
            open: None,
            near: Vec::new(),
            missing: 0,
            off: String::new(),
            out: Followed::default(),
        }
    }

    /// Visits places along the line, both ends included. Ends where what lies within the map is more than is `left`.
    pub(super) fn along(&mut self, points: &[DVec2], left: f64) {
        let tolerance = self.options.radius;
        let bounds = self.map.bounds();
        let box_ = [bounds.low.truncate() - tolerance, bounds.high.truncate() + tolerance];
        let (mut next, mut last, mut is_first) = (0.0, None, true);
        for (i, pair) in points.windows(2).enumerate() {
            let [a, b] = [pair[0], pair[1]];
            let length = a.distance(b);
            if length == 0.0 {
                continue;
            }
            let [enters, leaves] = within(a, b, box_).map(|share| share * length);
            self.out.within += (leaves - enters).max(0.0);
            if self.out.within > left {
                return;
            }
            let heading = libm::atan2(b.y - a.y, b.x - a.x);
            if next < enters.min(length) {
                // Beyond the map nothing is near.
                let steps = ((enters.min(length) - next) / STEP).ceil();
                self.miss(steps, i, is_first);
                (next, is_first) = (next + steps * STEP, false);
            }
            while next < length && next <= leaves {
                if !self.visit(a + (b - a) * (next / length), heading, is_first) {
                    self.miss(1.0, i, is_first);
                }
                (next, is_first) = (next + STEP, false);
            }
            if next < length {
                let steps = ((length - next) / STEP).ceil();
                self.miss(steps, i, is_first);
                next += steps * STEP;
            }
            next -= length;
            last = Some((i, b, heading));
        }
        if let Some((i, end, heading)) = last
            && !self.visit(end, heading, is_first)
        {
            self.miss(1.0, i, is_first);
        }
        if self.missing == 1 {
            self.miss(0.0, points.len(), is_first);
        }
        self.settle();
        if let Some(open) = self.open.take() {
            self.out.passed.push(open);
        }
    }

    /// Takes the lanes near a place into account; false if there is none.
    fn visit(&mut self, point: DVec2, heading: f64, is_first: bool) -> bool {
        self.options.heading = Some(heading);
        let hit = self.map.nearest_lane(point, &self.options).ok().flatten();
        self.options.hint = hit;
        let Some(hit) = hit else { return false };
        if self.missing == 1 && self.columns.is_empty() {
            // The line begins beside all lanes.
            self.out.off.add(STEP, || self.off.clone());
        }
        self.missing = 0;
        let reach = NearestOptions { radius: hit.position.distance + AS_NEAR, ..self.options };
        if self.map.lanes_near(point, &reach, &mut self.near).is_err() {
            self.near.clear();
        }
        let candidate = |near: &Nearest| {
            let lane = self.map.lane(near.lane).ok()?;
            let cost = near.position.distance + CENTRE * near.position.offset.abs();
            let s = near.position.s;
            Some(Candidate { lane, s, cost, total: cost, before: 0 })
        };
        let mut column: Vec<Candidate<'a>> = self.near.iter().filter_map(candidate).collect();
        if column.is_empty() {
            column.extend(candidate(&hit));
        }
        column.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        column.truncate(MOST_LANES);
        if let Some(before) = self.columns.last() {
            before.iter().for_each(|from| self.links.learn(self.map, &from.lane));
            for own in &mut column {
                let ways = before.iter().enumerate().map(|(number, from)| {
                    let jump = match self.links.step(from, own) {
                        Step::Jump => JUMP,
                        _ => 0.0,
                    };
                    (number as u8, from.total + jump)
                });
                if let Some((number, total)) = ways.min_by(|a, b| a.1.total_cmp(&b.1)) {
                    (own.before, own.total) = (number, total + own.cost);
                }
            }
        } else if !is_first && self.open.is_none() {
            // The line comes from where no lane is.
            for own in &mut column {
                own.s = reaching(&own.lane, own.s, true);
            }
        }
        let is_sure = column.len() == 1;
        self.columns.push(column);
        if is_sure || self.columns.len() >= SETTLED {
            self.settle();
        }
        true
    }

    /// Places at which no lane is. One alone says nothing: a line may have a kink, and go on along the same lane.
    fn miss(&mut self, steps: f64, after: usize, is_first: bool) {
        let tolerance = self.options.radius;
        let missed = (self.missing as f64 + steps) * STEP;
        if self.missing == 0 {
            self.off = format!(
                "no lane that is driven that way within {tolerance} m of it after point {after}"
            );
        }
        if self.missing == 0 && steps == 1.0 {
            self.missing = 1;
            return;
        }
        if self.missing < 2 {
            if !is_first {
                self.leave();
            }
            self.out.off.add(missed, || self.off.clone());
        } else {
            self.out.off.add(steps * STEP, String::new);
        }
        self.missing = 2;
    }

    /// The line goes on where no lane is.
    fn leave(&mut self) {
        self.settle();
        self.columns.clear();
        if let Some(mut open) = self.open.take() {
            let s = if open.lane.is_forward() { open.s_to } else { open.s_from };
            let s = reaching(&open.lane, s, false);
            widen(&mut open, s);
            self.out.passed.push(open);
        }
    }

    /// Takes the cheapest way through the places so far. The last one stays, with the candidate that was chosen.
    fn settle(&mut self) {
        let Some(last) = self.columns.last() else { return };
        let cheapest = last.iter().enumerate().min_by(|a, b| a.1.total.total_cmp(&b.1.total));
        let Some((mut number, _)) = cheapest else { return };
        let mut way = Vec::with_capacity(self.columns.len());
        for column in self.columns.iter().rev() {
            let Some(own) = column.get(number) else { break };
            way.push(*own);
            number = own.before.into();
        }
        way.reverse();
        for pair in way.windows(2) {
            self.pass(&pair[0], &pair[1]);
        }
        if self.open.is_none()
            && let Some(only) = way.last()
        {
            self.open = Some(Stretch { lane: only.lane, s_from: only.s, s_to: only.s });
        }
        if let Some(chosen) = way.last() {
            self.columns.clear();
            self.columns.push(vec![Candidate { total: 0.0, before: 0, ..*chosen }]);
        }
    }

    /// Goes from one place to the next.
    fn pass(&mut self, from: &Candidate<'a>, to: &Candidate<'a>) {
        let start = Stretch { lane: from.lane, s_from: from.s, s_to: from.s };
        let mut own = self.open.take().unwrap_or(start);
        if from.lane.lane_id() == to.lane.lane_id()
            && !matches!(self.links.step(from, to), Step::Linked(_))
        {
            widen(&mut own, to.s);
            self.open = Some(own);
            return;
        }
        let mut next = Stretch { lane: to.lane, s_from: to.s, s_to: to.s };
        match self.links.step(from, to) {
            // In between it is on both.
            Step::Beside => {
                widen(&mut own, to.s);
                widen(&mut next, from.s);
            }
            Step::Linked(between) => {
                widen(&mut own, end(&from.lane, false));
                widen(&mut next, end(&to.lane, true));
                self.out.passed.push(own);
                self.out.passed.extend(between.iter().map(whole));
                self.open = Some(next);
                return;
            }
            Step::Jump => {
                widen(&mut own, reaching(&from.lane, from.s, false));
                widen(&mut next, reaching(&to.lane, to.s, true));
            }
        }
        self.out.passed.push(own);
        self.open = Some(next);
    }
}

/// Where a lane begins as traffic goes, or where it ends.
pub(super) fn end(lane: &Lane<'_>, begins: bool) -> f64 {
    let section = lane.section();
    if lane.is_forward() == begins { section.s_start() } else { section.s_end() }
}

/// s, or where the lane begins or ends, if that is near.
fn reaching(lane: &Lane<'_>, s: f64, begins: bool) -> f64 {
    let end = end(lane, begins);
    if (end - s).abs() <= NEAR_END { end } else { s }
}

fn widen(stretch: &mut Stretch<'_>, s: f64) {
    (stretch.s_from, stretch.s_to) = (stretch.s_from.min(s), stretch.s_to.max(s));
}

fn whole<'a>(lane: &Lane<'a>) -> Stretch<'a> {
    let section = lane.section();
    Stretch { lane: *lane, s_from: section.s_start(), s_to: section.s_end() }
}

/// From which share of a segment to which it lies in a box; the first is larger where it does not.
fn within(a: DVec2, b: DVec2, [low, high]: [DVec2; 2]) -> [f64; 2] {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for (a, b, low, high) in [(a.x, b.x, low.x, high.x), (a.y, b.y, low.y, high.y)] {
        if a == b {
            if a < low || a > high {
                return [2.0, -1.0];
            }
            continue;
        }
        let [p, q] = [(low - a) / (b - a), (high - a) / (b - a)];
        (from, to) = (from.max(p.min(q)), to.min(p.max(q)));
    }
    if from <= to { [from, to] } else { [2.0, -1.0] }
}
