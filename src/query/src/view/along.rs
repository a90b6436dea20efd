//! What a view says of a way: along a path, beside it, of signals ahead; and of a pose.

use super::heed::OverlaidGraph;
use super::{Restriction, SpeedToday, View};
use crate::error::QueryError;
use crate::localisation::{LaneMatch, MatchError, MatchOptions, VehiclePose};
use crate::path::{Corridor, Path, PathLane};
use crate::route::PositionOnLane;
use crate::signals::SignalsAhead;
use glam::DMat3;
use mapd_archive::VehicleClass;

/// Pieces of one entry that are this near to each other along a path are one stretch `[m]`: the other lengths of a path are not exact.
const TOGETHER: f64 = 1e-3;

/// An entry that holds on a stretch of a path.
#[derive(Clone, Copy, Debug)]
pub struct PathRestriction<'a> {
    /// S of the beginning and end of what is driven of it `[m]`.
    pub along: [f64; 2],
    /// The entry, on the lane that is driven there.
    pub restriction: Restriction<'a>,
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

    /// As [`Path::corridor`], with the overlay's current entries applied: beside the path a lane that is closed cannot be changed to and adds no room, and one that is
    /// opened may and does. [`View::restrictions_at`] names the entries. The column `speed` is the map's: [`View::speed_on_path`] has today's.
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
