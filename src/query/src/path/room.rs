//! Where on a route a change of lane has room to be a curve, and how much of it.

use super::PathOptions;
use super::change::{LaneChange, apart};
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::lane::Lane;
use crate::map::Map;
use crate::route::{Enter, RouteStep};
use mapd_archive::VehicleClass;

/// A curve is at least so many times as long as it leads to the side: at 1.875 it would run straight across.
const LEAST_SLENDER: f64 = 2.0;
/// A curve that bends shorten may be this slender.
const MOST_STEEP: f64 = 1.9;
/// Changes behind one that are looked at, whether they still have room behind it.
const MOST_BEHIND: u32 = 8;
/// Halvings between the longest and the shortest curve, when the next change needs room.
const HALVINGS: u32 = 12;
/// An s this near to another is the same `[m]`.
const SAME: f64 = 1e-6;

/// The changes of lane of a route.
#[derive(Clone, Copy)]
pub(super) struct Changes<'a, 's> {
    pub(super) map: Map<'a>,
    pub(super) steps: &'s [RouteStep],
    pub(super) options: &'s PathOptions,
}

/// Lengths from where the route changes up to a place `[m]`: along the lanes that it drives, and the least and the most that any line between the two lanes has.
#[derive(Clone, Copy, Default)]
struct Gone {
    driven: f64,
    low: f64,
    high: f64,
}

/// A stretch on which a change is allowed all along.
#[derive(Clone, Copy)]
struct Room {
    begin: Gone,
    end: Gone,
    /// Whether it ends there; else more of it may follow.
    is_whole: bool,
}

impl Room {
    /// The curve of a length that begins in it as early as it can, not before a place; none if it is too short.
    fn early(&self, after: f64, length: f64) -> Option<[f64; 2]> {
        let begin = self.begin.high.max(after);
        let has_room = self.end.driven - self.begin.driven.max(after) >= length;
        has_room.then(|| [begin, (begin + length).min(self.end.low)])
    }

    /// Whether more of it would not make a curve of it longer.
    fn is_enough(&self, curve: &[f64; 2], length: f64) -> bool {
        self.is_whole || self.end.low - curve[0] >= length
    }

    /// The one that ends with it, not before a place.
    fn late(&self, after: f64, length: f64) -> Option<[f64; 2]> {
        let [begin, end] = self.early(after, length)?;
        Some([begin.max(self.end.low - length), end.max(self.end.low)])
    }
}

/// Two lanes beside each other, on a step of the route, and whether the vehicle may change from the one to the other.
struct Pair<'a> {
    from: LaneNode<'a>,
    to: LaneNode<'a>,
    on: usize,
    is_allowed: bool,
}

pub(super) fn is_change(step: &RouteStep) -> bool {
    matches!(step.enter, Enter::Left | Enter::Right)
}

impl<'a> Changes<'a, '_> {
    /// Where the change into a step becomes a curve, from where the route changes, not before a place behind it `[m]`. None where it has no room.
    pub(super) fn place(&self, number: usize, after: f64) -> Option<[f64; 2]> {
        let [least, longest] = self.lengths(number)?;
        let fits = |curve: &[f64; 2]| self.leaves_room(number, curve[1], MOST_BEHIND);
        let curve = self.placed(number, after, [least, longest], fits)?;
        let is_slender = curve[1] - curve[0] >= MOST_STEEP * self.aside(number);
        is_slender.then_some(curve)
    }

    fn placed(
        &self,
        number: usize,
        after: f64,
        [least, longest]: [f64; 2],
        fits: impl Fn(&[f64; 2]) -> bool,
    ) -> Option<[f64; 2]> {
        let delay = self.options.change_delay;
        if delay > 0.0
            && let Some(late) = self.late(number, after, after + delay, longest).filter(&fits)
        {
            return Some(late);
        }
        let early = |length: f64| self.early(number, after, length);
        let whole = early(longest);
        if let Some(whole) = whole.filter(&fits) {
            return Some(whole);
        }
        let shortest = early(least)?;
        // What leaves no room for the next one, however short it is, need not be short.
        let counts = |curve: &[f64; 2]| !fits(&shortest) || fits(curve);
        let (mut best, mut low, mut high) = (shortest, least, longest);
        if let Some(whole) = whole.filter(&counts) {
            return Some(whole);
        }
        for _ in 0..HALVINGS {
            let middle = low.midpoint(high);
            match early(middle).filter(&counts) {
                Some(curve) => (best, low) = (curve, middle),
                None => high = middle,
            }
        }
        Some(best)
    }

    /// The least and the greatest length of the change into a step.
    fn lengths(&self, number: usize) -> Option<[f64; 2]> {
        let LaneChange::Lateral(length) = self.options.change else { return None };
        // Over several lanes at one place.
        let step = self.steps.get(number)?;
        let is_here = |own: &&RouteStep| is_change(own) && (own.s_from - step.s_from).abs() <= SAME;
        let before = self.steps.get(..number)?.iter().rev().take_while(is_here).count();
        let behind = self.steps.get(number + 1..)?.iter().take_while(is_here).count();
        let lanes = (1 + before + behind) as f64;
        let shortest = self.options.shortest_change.unwrap_or(length).min(length) / lanes;
        let slender = LEAST_SLENDER * self.aside(number);
        Some([shortest.max(slender), length.max(slender)])
    }

    /// How far the change into a step leads to the side `[m]`.
    fn aside(&self, number: usize) -> f64 {
        let pair = number.checked_sub(1).and_then(|before| self.steps.get(before..=number));
        let Some([before, step]) = pair else { return f64::INFINITY };
        apart(self.map, [before.lane.row(), step.lane.row()], step.s_from)
    }

    /// Whether the changes behind the one into a step have room behind a place.
    fn leaves_room(&self, number: usize, end: f64, most: u32) -> bool {
        let Some((next, gone)) = self.next(number, end).filter(|_| most > 0) else { return true };
        let Some([least, _]) = self.lengths(next) else { return true };
        let curve = self.early(next, end - gone, least);
        curve.is_some_and(|curve| self.leaves_room(next, curve[1], most - 1))
    }

    /// The next change behind the one into a step, and what is driven up to it `[m]`; none from a length on.
    fn next(&self, number: usize, limit: f64) -> Option<(usize, f64)> {
        let mut gone = 0.0;
        for (own, step) in self.steps.iter().enumerate().skip(number) {
            if gone >= limit {
                return None;
            }
            if own > number && is_change(step) {
                return Some((own, gone));
            }
            gone += self.map.lane(step.lane).ok()?.length_between(step.s_from, step.s_to);
        }
        None
    }

    /// The first curve of a length, not before a place.
    fn early(&self, number: usize, after: f64, length: f64) -> Option<[f64; 2]> {
        let mut found = None;
        self.each_room(number, &mut |room| {
            found = room.early(after, length);
            found.is_some_and(|curve| room.is_enough(&curve, length))
        });
        found
    }

    /// The first curve of a length that does not begin before the second place, else the last one that does not before the first.
    fn late(&self, number: usize, after: f64, wanted: f64, length: f64) -> Option<[f64; 2]> {
        let (mut found, mut last) = (None, None);
        self.each_room(number, &mut |room| {
            found = room.early(wanted, length);
            if room.is_whole {
                last = room.late(after, length).or(last);
            }
            found.is_some_and(|curve| room.is_enough(&curve, length))
        });
        found.or(last)
    }

    /// Tells of the stretches on which the change into a step is allowed, each several times while it grows, until one is enough.
    fn each_room(&self, number: usize, is_enough: &mut dyn FnMut(&Room) -> bool) -> Option<()> {
        let step = self.steps.get(number)?;
        let before = self.steps.get(number.checked_sub(1)?)?;
        let (forward, is_left) = (step.forward, step.enter == Enter::Left);
        let node = |own: &RouteStep| self.map.lane(own.lane).ok()?.node_at(step.s_from, forward);
        let (mut from, mut to) = (node(before)?, node(step)?);
        if from.lane()?.row.section() != to.lane()?.row.section() {
            return None;
        }
        let (mut s, mut on, mut gone) = (step.s_from, number, Gone::default());
        let mut room = Some(Room { begin: gone, end: gone, is_whole: false });
        loop {
            let (end, is_last) = self.end_of(number, on, &to, s);
            let lanes = [from.lane()?, to.lane()?];
            let driven = self.driven(on, &lanes[1], s, end);
            let [a, b] = lanes.map(|lane| lane.length_between(s, end));
            gone.driven += driven;
            gone.low += a.min(b).min(driven);
            gone.high += a.max(b).max(driven);
            let next = if is_last { None } else { self.pair_behind(on, is_left, &from, &to) };
            let is_allowed = next.as_ref().is_some_and(|next| next.is_allowed);
            if let Some(room) = &mut room {
                (room.end, room.is_whole) = (gone, !is_allowed);
                if is_enough(room) {
                    return Some(());
                }
            }
            let Pair { from: left, to: next, on: on_step, .. } = next?;
            room = match (is_allowed, room) {
                (false, _) => None,
                (true, None) => Some(Room { begin: gone, end: gone, is_whole: false }),
                (true, known) => known,
            };
            let SRange { low, high } = next.s_range();
            s = if next.is_forward() { low } else { high };
            (from, to, on) = (left, next, on_step);
        }
    }

    /// The lanes that two beside each other lead on to along the route, if they are beside each other again and the vehicle may stay in the one that is left.
    fn pair_behind(
        &self,
        on: usize,
        is_left: bool,
        from: &LaneNode<'a>,
        to: &LaneNode<'a>,
    ) -> Option<Pair<'a>> {
        let ahead = to.edges().filter_map(|edge| edge.target());
        let (next, on) = ahead.filter_map(|node| Some((node, self.step_at(on, &node)?))).next()?;
        let left = if is_left { next.right() } else { next.left() }?;
        let mut targets = from.edges().filter_map(|edge| edge.target());
        if !(targets.any(|to| to.number == left.number) && self.is_open(from, &left)) {
            return None;
        }
        let change = if is_left { left.change_left() } else { left.change_right() };
        let is_allowed = change.is_some_and(|node| node.number == next.number)
            && next.allows(self.options.vehicle);
        Some(Pair { from: left, to: next, on, is_allowed })
    }

    /// Where a node of the lane that is changed to ends, and whether it ends there for good: with the route, or with the last place that its step names.
    fn end_of(&self, number: usize, on: usize, to: &LaneNode<'a>, s: f64) -> (f64, bool) {
        let SRange { low, high } = to.s_range();
        let forward = to.is_forward();
        let end = if forward { high } else { low };
        let way = if forward { 1.0 } else { -1.0 };
        let is_before = |place: f64| (end - place) * way > SAME;
        let latest = self.steps.get(number).filter(|own| own.lane.row() == to.row.lane());
        // The end of the piece on which it begins is none of the change: more of the lane follows.
        let latest = latest.filter(|own| own.s_from == s || (own.s_latest - s) * way > SAME);
        let latest = latest.map(|own| own.s_latest);
        let section = |own: &RouteStep| self.map.lane(own.lane).map(|lane| lane.row.section());
        let last = self.steps.last().filter(|last| {
            let here = self.steps.get(on).and_then(|own| section(own).ok());
            let rest = self.steps.get(on..).unwrap_or(&[]);
            here.is_some()
                && rest.iter().all(|own| section(own).ok() == here)
                && last.forward == forward
        });
        let limits = [latest, last.map(|last| last.s_to)];
        let limit = limits.into_iter().flatten().filter(|limit| is_before(*limit));
        let nearest = limit.min_by(|a, b| ((a - b) * way).total_cmp(&0.0));
        match nearest {
            Some(limit) => (if (limit - s) * way > 0.0 { limit } else { s }, true),
            None => (end, last.is_some_and(|last| (end - last.s_to) * way >= -SAME)),
        }
    }

    /// What the route drives from one s to another of the section that a step lies in.
    fn driven(&self, on: usize, beside: &Lane<'a>, s: f64, end: f64) -> f64 {
        let (low, high) = (s.min(end), s.max(end));
        let mut sum = 0.0;
        for step in self.steps.get(on..).unwrap_or(&[]) {
            let lane = self.map.lane(step.lane).ok();
            let Some(lane) = lane.filter(|lane| lane.row.section() == beside.row.section()) else {
                break;
            };
            let (from, to) = (step.s_from.min(step.s_to), step.s_from.max(step.s_to));
            let (from, to) = (from.max(low), to.min(high));
            if from < to {
                sum += lane.length_between(from, to);
            }
        }
        sum
    }

    /// The first step at or behind one of the section that a node lies in, if the route comes there next.
    fn step_at(&self, on: usize, node: &LaneNode<'a>) -> Option<usize> {
        let section = |own: &RouteStep| Some(self.map.lane(own.lane).ok()?.row.section());
        let wanted = node.lane()?.row.section();
        let here = section(self.steps.get(on)?)?;
        if here == wanted {
            return Some(on);
        }
        let rest = self.steps.get(on..)?.iter();
        let next = on + rest.take_while(|own| section(own) == Some(here)).count();
        let step = self.steps.get(next)?;
        (section(step) == Some(wanted) && step.forward == node.is_forward()).then_some(next)
    }

    /// Whether the vehicle may drive from one lane that is left on to the next.
    fn is_open(&self, from: &LaneNode<'a>, next: &LaneNode<'a>) -> bool {
        let vehicle: VehicleClass = self.options.vehicle;
        let is_same = from.row.lane() == next.row.lane();
        next.allows(vehicle) || (is_same && !from.allows(vehicle))
    }
}
