//! Stop lines and crosswalks, whether the file writes them as signals or as objects.

use crate::ids::{LaneId, ObjectId, SignalId};
use crate::lane::Lane;
use crate::signals::movement::ENTRY_REACH;
use mapd_archive::Class;

/// An object this near to a lane lies on it `[m]`: markings end a little before the lane's edges.
const ON_LANE: f64 = 0.5;

/// Who says that there is a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineSource {
    /// A signal.
    Signal(SignalId),
    /// An object.
    Object(ObjectId),
}

/// A stop line or crosswalk on a lane.
#[derive(Clone, Copy, Debug, PartialEq)]
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

impl<'a> Lane<'a> {
    /// Lines at which the lane's traffic stops or gives way: signals first, then objects.
    pub fn lines_to_stop_at(&self) -> impl Iterator<Item = LaneLine> + use<'a> {
        self.lines(&[Class::StopLine, Class::WaitingLine])
    }

    /// Crosswalks and bicycle crossings over the lane: signals first, then objects.
    pub fn crossings(&self) -> impl Iterator<Item = LaneLine> + use<'a> {
        self.lines(&[Class::Crosswalk, Class::BicycleCrossing])
    }

    fn lines(&self, classes: &'static [Class]) -> impl Iterator<Item = LaneLine> + use<'a> {
        let (lane, forward) = (*self, self.is_forward());
        let signals =
            self.signals().filter(move |one| one.is_for(forward)).map(move |one| LaneLine {
                source: LineSource::Signal(one.signal().signal_id()),
                class: one.signal().class(),
                lane: lane.lane_id(),
                s: one.s_on(&lane),
            });
        let objects = self.objects().filter_map(move |one| {
            let object = one.object().filter(|_| one.distance() <= ON_LANE)?;
            let (low, high) = one.s_range();
            object.orientation().is_for(forward).then(|| LaneLine {
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
    /// it or on the movement's first lane; without one at its light. None where neither is known.
    pub fn movement_stop(&self) -> Option<LaneLine> {
        let start = self.movement_start();
        let leading = self.approaches().flat_map(|(lane, before)| {
            lane.lines_to_stop_at().map(move |line| (before + lane.away(line.s, true), line))
        });
        let inside = start.lines_to_stop_at().map(|line| (start.away(line.s, false), line));
        let near = leading.chain(inside).filter(|(distance, _)| *distance <= ENTRY_REACH);
        let marked = near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, line)| line);
        marked.or_else(|| {
            let light = self.movement_lights().next()?;
            let lane = light.lane()?;
            let source = LineSource::Signal(light.signal().signal_id());
            let (class, s) = (light.signal().class(), light.s_on(&lane));
            Some(LaneLine { source, class, lane: lane.lane_id(), s })
        })
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
