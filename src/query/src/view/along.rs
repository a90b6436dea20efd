//! What a view says of a way: along a path, beside it, of signals ahead; and of a pose.

use super::heed::OverlaidGraph;
use super::{Restriction, SpeedToday, View};
use crate::error::QueryError;
use crate::localisation::{LaneMatch, MatchError, MatchOptions, VehiclePose};
use crate::path::{
    ConflictLane, Corridor, Path, PathConflict, PathCrossing, PathError, PathFact, PathLane,
    PathSegment, PathTime,
};
use crate::route::PositionOnLane;
use crate::rules::SpeedRule;
use crate::signals::SignalsAhead;
use glam::DMat3;
use mapd_archive::VehicleClass;

/// Pieces of one entry that are this near to each other along a path are one stretch `[m]`: the other lengths of a path are not exact.
const TOGETHER: f64 = 1e-3;
/// The same place along a path by two ways differs by less `[m]`.
const ROUNDING: f64 = 1e-6;

/// An entry that holds on a stretch of a path.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PathRestriction<'a> {
    /// S of the beginning and end of what is driven of it `[m]`.
    pub along: [f64; 2],
    /// The entry, on the lane that is driven there.
    pub restriction: Restriction<'a>,
}

/// A stretch of a path on which one speed limit holds today.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PathSpeedToday<'a> {
    /// S of its beginning and end `[m]`.
    pub along: [f64; 2],
    /// What holds there. Where an entry states it, the stretch is on one lane.
    pub today: SpeedToday<'a>,
}

impl<'a> View<'a> {
    /// What holds now for a class of vehicles along a path, in ascending S: each entry once for each stretch of a driven lane. The path itself
    /// is the map's: a lane that is closed stays where it is. `out` is emptied first; it grows only if its capacity is too small.
    ///
    /// Errors: a path on another map.
    pub fn restrictions_on_path(
        &self,
        path: &Path<'a, '_>,
        vehicle: VehicleClass,
        out: &mut Vec<PathRestriction<'a>>,
    ) -> Result<(), QueryError> {
        out.clear();
        for (number, PathLane { lane, forward, along, s, .. }) in path.lanes().enumerate() {
            let lane = self.map.lane(lane)?;
            let first = out.len();
            let (low, high) = (s[0].min(s[1]), s[0].max(s[1]));
            for node in lane.nodes().filter(|node| node.is_forward() == forward) {
                for piece in self.pieces_of(node.number) {
                    for one in self.restrictions_on(Some(piece)) {
                        let (from, to) = (one.s_from.max(low), one.s_to.min(high));
                        if from >= to || !one.entry.concerns(vehicle) {
                            continue;
                        }
                        let [begin, end] = if forward { [from, to] } else { [to, from] };
                        let begin = path.along_lane(number, begin).unwrap_or(along[0]);
                        let end = path.along_lane(number, end).unwrap_or(along[1]);
                        let own = out.get_mut(first..).unwrap_or(&mut []);
                        let goes_on = |before: &&mut PathRestriction<'a>| {
                            before.restriction.entry.number() == one.entry.number()
                                && (before.along[1] - begin).abs() <= TOGETHER
                        };
                        if let Some(before) = own.iter_mut().find(goes_on) {
                            before.along[1] = end;
                            let known = &mut before.restriction;
                            known.s_from = known.s_from.min(one.s_from);
                            known.s_to = known.s_to.max(one.s_to);
                        } else {
                            out.push(PathRestriction { along: [begin, end], restriction: one });
                        }
                    }
                }
            }
        }
        // Sorting in place allocates nothing.
        out.sort_unstable_by(|a, b| {
            let number = |one: &PathRestriction<'a>| one.restriction.entry.number();
            a.along[0].total_cmp(&b.along[0]).then(number(a).cmp(&number(b)))
        });
        Ok(())
    }

    /// The speed limit at S of a path for a class of vehicles: the lowest that an entry states, else the map's by the way that the path has come
    /// ([`Path::speed_at`]).
    ///
    /// Errors: a path on another map; an S that is not finite.
    pub fn speed_on_path(
        &self,
        path: &Path<'a, '_>,
        along: f64,
        vehicle: VehicleClass,
    ) -> Result<SpeedToday<'a>, QueryError> {
        let map = path.speed_at(along).ok_or(QueryError::NotFinite)?;
        let at = path.at(along)?;
        let lane = self.map.lane(at.lane)?;
        let mut today = SpeedToday { max: map.max, map, restriction: None };
        self.lower(&mut today, &lane, self.piece_at(&lane, at.s, at.forward), vehicle);
        Ok(today)
    }

    /// As [`Path::speeds`] for a class of vehicles, with the overlay's current entries applied, each place as [`View::speed_on_path`] has it. `out` is emptied first; it
    /// grows only if its capacity is too small.
    ///
    /// Errors: a path on another map.
    pub fn speeds_on_path(
        &self,
        path: &Path<'a, '_>,
        vehicle: VehicleClass,
        out: &mut Vec<PathSpeedToday<'a>>,
    ) -> Result<(), QueryError> {
        out.clear();
        path.check(self.map)?;
        self.each_limit(path, [0.0, path.length()], vehicle, |along, today| {
            let goes_on = |before: &&mut PathSpeedToday<'a>| {
                let known = (before.today.restriction, today.restriction);
                before.today.map == today.map
                    && match known {
                        (None, None) => true,
                        (Some(known), Some(own)) => {
                            (known.entry.number(), known.lane) == (own.entry.number(), own.lane)
                        }
                        _ => false,
                    }
            };
            let Some(before) = out.last_mut().filter(goes_on) else {
                return out.push(PathSpeedToday { along, today });
            };
            before.along[1] = along[1];
            if let (Some(known), Some(own)) = (&mut before.today.restriction, today.restriction) {
                known.s_from = known.s_from.min(own.s_from);
                known.s_to = known.s_to.max(own.s_to);
            }
        });
        Ok(())
    }

    /// As [`Path::travel_time`] for a class of vehicles, at the limits of [`View::speeds_on_path`]. What is closed takes as long as if it were open:
    /// [`View::restrictions_on_path`] tells of it.
    ///
    /// Errors: as [`Path::travel_time`]; a path on another map.
    pub fn travel_time_on_path(
        &self,
        path: &Path<'a, '_>,
        part: [f64; 2],
        vehicle: VehicleClass,
    ) -> Result<PathTime, PathError> {
        path.check(self.map)?;
        let mut sum = PathTime { time: 0.0, unlimited: 0.0 };
        self.each_limit(path, path.part(part)?, vehicle, |along, today| sum.add(along, today.max));
        Ok(sum)
    }

    /// Tells today's limits between two S on a path, in ascending S without gaps.
    fn each_limit(
        &self,
        path: &Path<'a, '_>,
        part: [f64; 2],
        vehicle: VehicleClass,
        mut tell: impl FnMut([f64; 2], SpeedToday<'a>),
    ) {
        let plain = |map: SpeedRule| SpeedToday { max: map.max, map, restriction: None };
        path.each_limit(part, |number, [begin, end], map| {
            let driven = path.driven(number).filter(|(lane, _)| self.touches(lane));
            let Some((lane, forward)) = driven else {
                return tell([begin, end], plain(map));
            };
            let mut told = begin;
            let nodes = lane.nodes().filter(|node| node.is_forward() == forward);
            for piece in nodes.flat_map(|node| self.pieces_of(node.number)) {
                let mut today = plain(map);
                self.lower(&mut today, &lane, Some(piece), vehicle);
                let Some(by) = today.restriction else { continue };
                let ends = if forward { [by.s_from, by.s_to] } else { [by.s_to, by.s_from] };
                let [from, to] = ends.map(|s| path.along_lane(number, s).unwrap_or(begin));
                let from = if from - told < ROUNDING { told } else { from };
                let to = if end - to < ROUNDING { end } else { to };
                if to - from < ROUNDING {
                    continue;
                }
                if from > told {
                    tell([told, from], plain(map));
                }
                tell([from, to], today);
                told = to;
            }
            if told < end {
                tell([told, end], plain(map));
            }
        });
    }

    /// As [`Path::conflicts`], with lights that are out of service now left out: where they would decide, signs do, then priorities of the file, then rules of the road.
    ///
    /// Errors: a path on another map.
    pub fn conflicts(
        &self,
        path: &Path<'a, '_>,
        out: &mut Vec<PathConflict>,
        lanes: &mut Vec<ConflictLane>,
    ) -> Result<(), QueryError> {
        path.check(self.map)?;
        path.conflicts_in(Some(*self), out, lanes);
        Ok(())
    }

    /// As [`Path::crossings`], with lights that are out of service now left out.
    ///
    /// Errors: a path on another map.
    pub fn crossings(
        &self,
        path: &Path<'a, '_>,
        out: &mut Vec<PathCrossing>,
    ) -> Result<(), QueryError> {
        path.check(self.map)?;
        path.crossings_in(Some(*self), out);
        Ok(())
    }

    /// As [`Path::facts`], with today's permissions; a light that is out of service now governs nothing, and [`View::signal_out_of_service`] names the entry.
    ///
    /// Errors: a path on another map.
    pub fn facts(&self, path: &Path<'a, '_>, out: &mut Vec<PathFact>) -> Result<(), QueryError> {
        path.check(self.map)?;
        path.facts_in(Some(*self), out);
        Ok(())
    }

    /// As [`Path::segments`], with the overlay's current entries applied: a lane that is closed is not entered, so that before it a change of lane is due; one that is opened
    /// may be.
    ///
    /// Errors: a path on another map.
    pub fn segments_on_path(
        &self,
        path: &Path<'a, '_>,
        vehicle: VehicleClass,
        out: &mut Vec<PathSegment>,
    ) -> Result<(), QueryError> {
        out.clear();
        path.check(self.map)?;
        if self.overlay.is_none() {
            path.segments(vehicle, out);
        } else {
            path.segments_on(OverlaidGraph::new(*self, vehicle), vehicle, out);
        }
        Ok(())
    }

    /// As [`Path::corridor`], with the overlay's current entries applied: beside the path a lane that is closed cannot be changed to and adds no room, and one that is
    /// opened may and does; the column `speed` has today's limits. [`View::restrictions_at`] and [`View::speeds_on_path`] name the entries.
    ///
    /// Errors: as [`Path::corridor`]; a path on another map.
    pub fn corridor(
        &self,
        path: &Path<'a, '_>,
        from: f64,
        length: f64,
        step: f64,
        vehicle: VehicleClass,
        out: &mut Corridor,
    ) -> Result<(), QueryError> {
        path.check(self.map)?;
        if self.overlay.is_none() {
            return path.corridor(from, length, step, vehicle, out);
        }
        path.corridor_on(OverlaidGraph::new(*self, vehicle), from, length, step, vehicle, out)
    }

    /// As [`crate::Map::signals_ahead`], with the overlay's current entries applied: ways through closed lanes are not followed. Signals that are out of service are
    /// among them; [`View::signal_out_of_service`] tells which are, and by which entry.
    ///
    /// Errors: as [`crate::Map::signals_ahead`].
    pub fn signals_ahead(
        &self,
        from: PositionOnLane,
        distance: f64,
        vehicle: VehicleClass,
        out: &mut SignalsAhead,
    ) -> Result<(), QueryError> {
        if self.overlay.is_none() {
            return self.map.signals_ahead(from, distance, vehicle, out);
        }
        crate::signals::ahead(OverlaidGraph::new(*self, vehicle), from, distance, vehicle, out)
    }

    /// As [`crate::Map::match_pose`], with the overlay's current entries applied: a lane that is closed to [`MatchOptions::vehicle`] has the prior of closed ones.
    /// [`View::allows`] names the entry.
    ///
    /// Errors: as [`crate::Map::match_pose`].
    pub fn match_pose(
        &self,
        pose: &VehiclePose,
        covariance: &DMat3,
        options: &MatchOptions<'_>,
        out: &mut Vec<LaneMatch>,
    ) -> Result<f64, MatchError> {
        let vehicle = options.vehicle.unwrap_or(VehicleClass::PassengerCar);
        let ways = OverlaidGraph::new(*self, vehicle);
        crate::matching::match_at_most(ways, usize::MAX, pose, covariance, options, out)
    }
}
