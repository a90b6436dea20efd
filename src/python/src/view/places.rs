//! What holds at places of a map: restrictions, permissions, speed limits, signals, and the lanes that a pose may be in.

use super::{Speeds, View, number};
use crate::batch::{answer, columns, fields, overtaking_rule, result};
use crate::errors::query;
use crate::held::{content, id};
use crate::input::{column, finite, lane_of_id, place_of, vehicle_of};
use crate::room::{Column, Room};
use crate::signal::Signal;
use mapd_client::QueryError;
use pyo3::prelude::*;

#[pymethods]
impl View {
    /// What holds now, wherever it does.
    fn restrictions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let content = content(self.held.map());
        let (lane, from, to, entry) = py.detach(|| {
            let mut found = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
            for own in self.view().restrictions() {
                found.0.push(id(content, own.lane.row()));
                found.1.push(own.s_from);
                found.2.push(own.s_to);
                found.3.push(i64::from(own.entry.number()));
            }
            found
        });
        let all = vec![
            Column::Ids(lane),
            Column::Numbers(from),
            Column::Numbers(to),
            Column::Counts(entry),
        ];
        columns(py, "Restrictions", all)
    }

    /// Entries that hold now at a place, in the lane's own direction.
    fn restrictions_at<'py>(
        &self,
        py: Python<'py>,
        place: &Bound<'py, PyAny>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let place = place_of(self.held.map(), place)?;
        let found = self.view().restrictions_at(place.lane, place.s).map_err(query)?;
        found.map(|own| self.restriction(py, &own)).collect()
    }

    /// Whether a class of vehicles may use a lane at a place, or many lanes, by their ids, each at its s [m].
    #[pyo3(signature = (place, s = None, *, vehicle = "passengerCar", out = None))]
    fn allows<'py>(
        &self,
        py: Python<'py>,
        place: &Bound<'py, PyAny>,
        s: Option<&Bound<'py, PyAny>>,
        vehicle: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (view, vehicle) = (self.view(), vehicle_of(vehicle)?);
        let Some(s) = s else {
            let place = place_of(self.held.map(), place)?;
            let found = view.allows(place.lane, place.s, vehicle).map_err(query)?;
            let restriction = self.some(py, found.restriction.as_ref())?;
            let fields = fields!(py, is_allowed = found.is_allowed, restriction = restriction);
            return result(py, "Permission", &fields);
        };
        let mut room = Room::of(py, "Permissions", out)?;
        let lanes = crate::input::ids(place, "lanes", None, &mut room)?;
        let s = column(s, "s", lanes.len(), &mut room)?;
        let (flags, entries) = answer(py, || {
            let (mut flags, mut entries) = (room.take(lanes.len()), room.take(lanes.len()));
            for (row, id) in lanes.iter().enumerate() {
                let of_row = |error: QueryError| (row, error);
                let lane = lane_of_id(self.held.map(), *id).map_err(of_row)?;
                let found = view.allows(lane.lane_id(), s[row], vehicle).map_err(of_row)?;
                flags.push(found.is_allowed);
                entries.push(number(found.restriction.as_ref()));
            }
            room.give(lanes);
            room.give(s);
            Ok((flags, entries))
        })?;
        room.columns(py, "Permissions", vec![Column::Flags(flags), Column::Counts(entries)], out)
    }

    /// The speed limit at a place, or of many lanes, by their ids, each at its s [m]: the lowest that an entry states, else the map's.
    #[pyo3(signature = (place, s = None, *, vehicle = "passengerCar", out = None))]
    fn speed_rule_at<'py>(
        &self,
        py: Python<'py>,
        place: &Bound<'py, PyAny>,
        s: Option<&Bound<'py, PyAny>>,
        vehicle: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (view, vehicle) = (self.view(), vehicle_of(vehicle)?);
        let Some(s) = s else {
            let place = place_of(self.held.map(), place)?;
            let found = view.speed_rule_at(place.lane, place.s, vehicle).map_err(query)?;
            return self.speed(py, &found);
        };
        let mut room = Room::of(py, "SpeedsToday", out)?;
        let lanes = crate::input::ids(place, "lanes", None, &mut room)?;
        let s = column(s, "s", lanes.len(), &mut room)?;
        let found = answer(py, || {
            let mut found = Speeds::with_room(lanes.len(), &mut room);
            for (row, id) in lanes.iter().enumerate() {
                let of_row = |error: QueryError| (row, error);
                let lane = lane_of_id(self.held.map(), *id).map_err(of_row)?;
                let s = finite(s[row]).map_err(of_row)?;
                found.push(&view.speed_rule_at(lane.lane_id(), s, vehicle).map_err(of_row)?);
            }
            room.give(lanes);
            room.give(s);
            Ok(found)
        })?;
        room.columns(py, "SpeedsToday", found.columns(), out)
    }

    /// Whether a class of vehicles may overtake at a place: what signs forbid, and entries. What road marks forbid is with the lane graph's lane changes.
    #[pyo3(signature = (place, *, vehicle = "passengerCar"))]
    fn overtaking_rule_at<'py>(
        &self,
        py: Python<'py>,
        place: &Bound<'py, PyAny>,
        vehicle: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (place, vehicle) = (place_of(self.held.map(), place)?, vehicle_of(vehicle)?);
        let today = self.view().overtaking_rule_at(place.lane, place.s, vehicle).map_err(query)?;
        let fields = fields!(
            py,
            is_forbidden = today.is_forbidden,
            map = overtaking_rule(py, &self.held, &today.map)?,
            restriction = self.some(py, today.restriction.as_ref())?,
        );
        result(py, "OvertakingToday", &fields)
    }

    /// The entry by which a signal is out of service now.
    fn signal_out_of_service<'py>(
        &self,
        py: Python<'py>,
        signal: &Bound<'py, Signal>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let found = self.view().signal_out_of_service(signal.get().signal_id()).map_err(query)?;
        found.map(|own| self.entry(py, &own)).transpose()
    }

    /// As Map.match_pose: a lane that is closed to the vehicle now has the prior of closed ones.
    #[pyo3(signature = (points, heading, covariance, *, types = None, z_tolerance = None,
        drive_deviation = 0.1, none = 0.01, vehicle = None, closed = 0.05, expected = None, unexpected = 0.05,
        outline = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn match_pose<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        heading: &Bound<'py, PyAny>,
        covariance: &Bound<'py, PyAny>,
        types: Option<&Bound<'py, PyAny>>,
        z_tolerance: Option<f64>,
        drive_deviation: f64,
        none: f64,
        vehicle: Option<&str>,
        closed: f64,
        expected: Option<Vec<Bound<'py, PyAny>>>,
        unexpected: f64,
        outline: Option<[f64; 4]>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let expected = crate::input::lanes_of(self.held.map(), expected.as_deref())?;
        let types = types.map_or(Ok(mapd_client::LaneTypes::ALL), crate::input::types_of)?;
        let vehicle = vehicle.map(vehicle_of).transpose()?;
        let options = mapd_client::localisation::MatchOptions {
            types,
            z_tolerance,
            drive_deviation,
            none,
            vehicle,
            closed,
            expected: &expected,
            unexpected,
            outline: outline.map(crate::matching::outline),
        };
        let view = self.view();
        crate::matching::match_pose(
            py,
            &self.held,
            points,
            heading,
            covariance,
            |pose, covariance, out| view.match_pose(pose, covariance, &options, out),
        )
    }
}
