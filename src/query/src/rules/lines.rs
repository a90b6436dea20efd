//! Stop lines and crosswalks, whether the file writes them as signals or as objects.

use super::movement::ENTRY_REACH;
use crate::error::QueryError;
use crate::extents::SRange;
use crate::ids::{LaneId, ObjectId, SignalId};
use crate::lane::Lane;
use crate::map::Map;
use crate::route::RouteStep;
use crate::signals::met;
use mapd_archive::Class;

/// An object this near to a lane lies on it `[m]`: markings end a little before the lane's edges.
const ON_LANE: f64 = 0.5;

/// Lines at which traffic stops or gives way.
const TO_STOP_AT: &[Class] = &[Class::StopLine, Class::WaitingLine];
/// What crosses lanes.
const CROSSINGS: &[Class] = &[Class::Crosswalk, Class::BicycleCrossing];

/// Who says that there is a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum LineSource {
    /// A signal.
    Signal(SignalId),
    /// An object.
    Object(ObjectId),
}

/// A stop line or crosswalk on a lane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LaneLine {
    /// Who says so.
    pub source: LineSource,
    /// What it is.
    pub class: Class,
    /// The lane.
    pub lane: LaneId,
    /// Where the lane's traffic meets it first, on the road `[m]`.
    pub s: f64,
}

/// A stop line or crosswalk that a route passes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LineAhead {
    /// The line.
    pub line: LaneLine,
    /// Distance along the lanes' centre lines from the route's start `[m]`.
    pub distance: f64,
}

impl Map<'_> {
    /// Stop lines, lines to give way at, crosswalks and bicycle crossings along a route, nearest first, whether the file writes
    /// them as signals or as objects; one over several lanes stands once for each that is driven on. `out` is emptied first; it
    /// grows only if its capacity is too small.
    ///
    /// Errors: ids of another map.
    pub fn lines_along(
        &self,
        steps: &[RouteStep],
        out: &mut Vec<LineAhead>,
    ) -> Result<(), QueryError> {
        out.clear();
        let mut passed = 0.0;
        for (i, step) in steps.iter().enumerate() {
            let lane = self.lane(step.lane)?;
            let last = i + 1 == steps.len();
            for line in lane.all_lines(step.forward) {
                if let Some(distance) = met(&lane, step, line.s, last) {
                    out.push(LineAhead { line, distance: passed + distance });
                }
            }
            passed += lane.length_between(step.s_from, step.s_to);
        }
        // Sorting in place allocates nothing; what lies at one place keeps an order of its own.
        out.sort_unstable_by(|a, b| {
            a.distance.total_cmp(&b.distance).then(a.line.source.cmp(&b.line.source))
        });
        Ok(())
    }
}

impl<'a> Lane<'a> {
    /// Lines at which the lane's traffic stops or gives way: signals first, then objects.
    pub fn lines_to_stop_at(&self) -> impl Iterator<Item = LaneLine> + use<'a> {
        self.lines(TO_STOP_AT, self.is_forward())
    }

    /// Crosswalks and bicycle crossings over the lane: signals first, then objects.
    pub fn crossings(&self) -> impl Iterator<Item = LaneLine> + use<'a> {
        self.lines(CROSSINGS, self.is_forward())
    }

    /// Lines to stop at and crossings for traffic towards +s, or for that towards −s.
    pub(crate) fn all_lines(&self, forward: bool) -> impl Iterator<Item = LaneLine> + use<'a> {
        self.lines(TO_STOP_AT, forward).chain(self.lines(CROSSINGS, forward))
    }

    /// Lines of these classes for traffic towards +s, or for that towards −s.
    fn lines(
        &self,
        classes: &'static [Class],
        forward: bool,
    ) -> impl Iterator<Item = LaneLine> + use<'a> {
        let lane = *self;
        let signals =
            self.signals().filter(move |one| one.is_for(forward)).map(move |one| LaneLine {
                source: LineSource::Signal(one.signal().signal_id()),
                class: one.signal().class(),
                lane: lane.lane_id(),
                s: one.s_on(&lane),
            });
        let objects = self.objects().filter_map(move |one| {
            let object = one.object().filter(|_| one.distance() <= ON_LANE)?;
            // An object's lanes are those that it is for; its orientation, along its own road, tells the two directions of one lane.
            let is_own = object.road().is_some_and(|road| road.road_id() == lane.road().road_id());
            let both = is_own && lane.is_bidirectional();
            let is_for = !both || object.orientation().is_for(forward);
            let SRange { low, high } = one.s_range();
            is_for.then(|| LaneLine {
                source: LineSource::Object(object.object_id()),
                class: object.class(),
                lane: lane.lane_id(),
                s: if forward { low } else { high },
            })
        });
        signals.chain(objects).filter(move |line| classes.contains(&line.class))
    }

    /// Distance of a place on the lane from its end, or from its beginning, in driving direction `[m]`.
    fn away(&self, s: f64, from_end: bool) -> f64 {
        let section = self.section();
        let at_high = self.is_forward() == from_end;
        self.length_between(s, if at_high { section.s_end() } else { section.s_start() })
    }

    /// Where the movement through this lane of a junction stops: at the marked line nearest to the junction, up to 30 m before
    /// it or on the movement's first lane; without one at its light; under a stop or yield sign without marking at the last place before the movement
    /// meets another lane, or where it enters the junction if it meets none. None where none of these is known.
    pub fn movement_stop(&self) -> Option<LaneLine> {
        self.movement_stop_where(|_| true)
    }

    /// As [`Lane::movement_stop`], at lights that work alone.
    pub(crate) fn movement_stop_where(&self, works: impl Fn(SignalId) -> bool) -> Option<LaneLine> {
        let start = self.movement_start();
        let leading = self.approaches().flat_map(|(lane, before)| {
            lane.lines_to_stop_at().map(move |line| (before + lane.away(line.s, true), line))
        });
        let inside = start.lines_to_stop_at().map(|line| (start.away(line.s, false), line));
        let near = leading.chain(inside).filter(|(distance, _)| *distance <= ENTRY_REACH);
        let marked = near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, line)| line);
        let at_light = || {
            let light = self.movement_lights().find(|one| works(one.signal().signal_id()))?;
            let lane = light.lane()?;
            let source = LineSource::Signal(light.signal().signal_id());
            let (class, s) = (light.signal().class(), light.s_on(&lane));
            Some(LaneLine { source, class, lane: lane.lane_id(), s })
        };
        marked.or_else(at_light).or_else(|| self.stop_at_sign(&start))
    }

    /// Where the movement waits that a stop or yield sign at its entry tells to give way, if nothing is marked.
    fn stop_at_sign(&self, start: &Lane<'a>) -> Option<LaneLine> {
        let gives_way = |class: Class| matches!(class, Class::Stop | Class::Yield);
        let signs = self.entry_signals().map(|one| one.signal.signal());
        let sign = signs.into_iter().find(|sign| gives_way(sign.class()))?;
        let source = LineSource::Signal(sign.signal_id());
        let line = |lane: &Lane<'a>, s: f64| {
            let (class, lane) = (sign.class(), lane.lane_id());
            LaneLine { source, class, lane, s }
        };
        let first = |lane: Lane<'a>| {
            let all = lane.conflicts().map(|conflict| conflict.s_range());
            let s = match lane.is_forward() {
                true => all.map(|range| range.low).min_by(f64::total_cmp),
                false => all.map(|range| range.high).max_by(f64::total_cmp),
            };
            s.map(|s| line(&lane, s))
        };
        let section = start.section();
        let entry = if start.is_forward() { section.s_start() } else { section.s_end() };
        start.movement_lanes().find_map(first).or_else(|| Some(line(start, entry)))
    }

    /// Crosswalks and bicycle crossings that the movement through this lane of a junction passes: up to 30 m before it, on its
    /// own lanes, and up to 30 m behind it.
    pub fn movement_crossings(&self) -> impl Iterator<Item = LaneLine> + use<'a> {
        let before = self.approaches().flat_map(|(lane, before)| {
            let near = move |line: &LaneLine| before + lane.away(line.s, true) <= ENTRY_REACH;
            lane.crossings().filter(near)
        });
        let inside = self.movement_lanes().flat_map(|lane| lane.crossings());
        let behind = self.departures().flat_map(|(lane, behind)| {
            let near = move |line: &LaneLine| behind + lane.away(line.s, false) <= ENTRY_REACH;
            lane.crossings().filter(near)
        });
        before.chain(inside).chain(behind)
    }
}
