//! A map under what is laid over it, at a moment.

use crate::batch::{answer, columns, fields, overtaking_rule, result, speed_rule};
use crate::errors::{query, raise, routing};
use crate::held::{Held, content, id};
use crate::input::{column, finite, lane_of_id, place_of, vehicle_of};
use crate::lane::Lane;
use crate::path::Path;
use crate::room::{Column, Room};
use crate::route::{Cost, ahead_result, found_route, pieces_result};
use crate::signal::Signal;
use mapd_client::QueryError;
use mapd_client::path::PathError;
use mapd_client::route::{AlternativeOptions, RouteScratch};
use mapd_client::signals::SignalsAhead;
use mapd_client::view::{OverlayEntry, Restriction, SpeedToday};
use mapd_client::vocabulary::VehicleClass;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::Arc;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// A map under what is laid over it, at a moment: what is closed, slower or told of. Without an overlay it is the map.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct View {
    held: Arc<Held>,
    at: SystemTime,
}

/// A moment: none is now, a number seconds since 1970 in UTC, anything else what its `timestamp()` says.
fn moment(at: Option<&Bound<'_, PyAny>>) -> PyResult<SystemTime> {
    let Some(at) = at else { return Ok(SystemTime::now()) };
    let seconds: f64 = match at.extract() {
        Ok(seconds) => seconds,
        Err(_) => at.call_method0("timestamp")?.extract()?,
    };
    let away = Duration::try_from_secs_f64(seconds.abs()).ok();
    let moment = away.and_then(|away| {
        if seconds < 0.0 { UNIX_EPOCH.checked_sub(away) } else { UNIX_EPOCH.checked_add(away) }
    });
    moment.ok_or_else(|| PyValueError::new_err(format!("at: {seconds} s is no moment")))
}

pub(crate) fn view(held: &Arc<Held>, at: Option<&Bound<'_, PyAny>>) -> PyResult<View> {
    Ok(View { held: Arc::clone(held), at: moment(at)? })
}

/// Number of the entry that decides; −1 where the map does.
fn number(restriction: Option<&Restriction<'_>>) -> i64 {
    restriction.map_or(-1, |one| i64::from(one.entry.number()))
}

impl View {
    fn view(&self) -> mapd_client::view::View<'_> {
        self.held.snapshot().view(self.at)
    }

    fn entry<'py>(&self, py: Python<'py>, own: &OverlayEntry<'_>) -> PyResult<Bound<'py, PyAny>> {
        let concerned = VehicleClass::ALL.iter().filter(|class| own.concerns(**class));
        let names: Vec<_> = concerned.map(|class| class.name()).collect();
        let vehicles = PyTuple::new(py, names)?;
        let fields = fields!(
            py,
            number = own.number(),
            id = own.id(),
            kind = own.kind().name(),
            value = own.value(),
            source = own.source(),
            text = own.text(),
            confidence = own.confidence(),
            vehicles = vehicles,
            holds = self.view().holds(own),
        );
        result(py, "OverlayEntry", &fields)
    }

    fn restriction<'py>(
        &self,
        py: Python<'py>,
        own: &Restriction<'_>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let fields = fields!(
            py,
            entry = self.entry(py, &own.entry)?,
            lane = Lane::new(&self.held, own.lane.row()),
            s_from = own.s_from,
            s_to = own.s_to,
        );
        result(py, "Restriction", &fields)
    }

    fn some<'py>(
        &self,
        py: Python<'py>,
        own: Option<&Restriction<'_>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        own.map(|own| self.restriction(py, own)).transpose()
    }

    fn speed<'py>(&self, py: Python<'py>, today: &SpeedToday<'_>) -> PyResult<Bound<'py, PyAny>> {
        let fields = fields!(
            py,
            max = today.max,
            map = speed_rule(py, &self.held, &today.map)?,
            restriction = self.some(py, today.restriction.as_ref())?,
        );
        result(py, "SpeedToday", &fields)
    }
}

/// Columns of speed limits of today.
struct Speeds {
    max: Vec<f64>,
    map: Vec<f64>,
    entry: Vec<i64>,
}

impl Speeds {
    fn with_room(rows: usize, room: &mut Room) -> Self {
        let [max, map] = room.numbers(rows);
        Self { max, map, entry: room.take(rows) }
    }

    fn push(&mut self, today: &SpeedToday<'_>) {
        self.max.push(today.max.unwrap_or(f64::NAN));
        self.map.push(today.map.max.unwrap_or(f64::NAN));
        self.entry.push(number(today.restriction.as_ref()));
    }

    fn columns(self) -> Vec<Column> {
        vec![Column::Numbers(self.max), Column::Numbers(self.map), Column::Counts(self.entry)]
    }
}

#[pymethods]
impl View {
    /// The moment: seconds since 1970 in UTC [s].
    #[getter]
    fn at(&self) -> f64 {
        match self.at.duration_since(UNIX_EPOCH) {
            Ok(after) => after.as_secs_f64(),
            Err(before) => -before.duration().as_secs_f64(),
        }
    }

    /// The map below.
    #[getter]
    fn map(&self) -> crate::map::Map {
        crate::map::Map::of(Arc::clone(&self.held))
    }

    /// Everything that the overlay says, whether it holds now or not; entry k has the number k.
    fn entries<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.view().entries().map(|own| self.entry(py, &own)).collect()
    }

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

    /// What holds now along a route.
    #[pyo3(signature = (steps, *, vehicle = "passengerCar"))]
    fn restrictions_along<'py>(
        &self,
        py: Python<'py>,
        steps: &Bound<'py, PyAny>,
        vehicle: &str,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let steps = crate::path::steps_of(self.held.map(), steps)?;
        let mut found = Vec::new();
        self.view().restrictions_along(&steps, vehicle_of(vehicle)?, &mut found).map_err(query)?;
        found.iter().map(|own| self.restriction(py, own)).collect()
    }

    /// What holds now along a path, in ascending S.
    #[pyo3(signature = (path, *, vehicle = "passengerCar"))]
    fn restrictions_on_path<'py>(
        &self,
        py: Python<'py>,
        path: &Bound<'py, Path>,
        vehicle: &str,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (path, mut found) = (path.get().path().map_err(query)?, Vec::new());
        let view = self.view();
        view.restrictions_on_path(&path, vehicle_of(vehicle)?, &mut found).map_err(query)?;
        let one = |own: &mapd_client::view::PathRestriction<'_>| {
            let restriction = self.restriction(py, &own.restriction)?;
            let [start, end] = own.along;
            let fields = fields!(py, start = start, end = end, restriction = restriction);
            result(py, "PathRestriction", &fields)
        };
        found.iter().map(one).collect()
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

    /// The speed limit at S of a path [m].
    #[pyo3(signature = (path, along, *, vehicle = "passengerCar", out = None))]
    fn speed_on_path<'py>(
        &self,
        py: Python<'py>,
        path: &Bound<'py, Path>,
        along: &Bound<'py, PyAny>,
        vehicle: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (view, vehicle) = (self.view(), vehicle_of(vehicle)?);
        let path = path.get().path().map_err(query)?;
        if let Ok(along) = along.extract::<f64>() {
            return self.speed(py, &view.speed_on_path(&path, along, vehicle).map_err(query)?);
        }
        let mut room = Room::of(py, "SpeedsToday", out)?;
        let along = crate::input::column_of_any(along, "along", &mut room)?;
        let found = answer(py, || {
            let mut found = Speeds::with_room(along.len(), &mut room);
            for (row, along) in along.iter().enumerate() {
                let today = view.speed_on_path(&path, *along, vehicle);
                found.push(&today.map_err(|error| (row, error))?);
            }
            room.give(along);
            Ok(found)
        })?;
        room.columns(py, "SpeedsToday", found.columns(), out)
    }

    /// The speed limits along a path, in ascending S without gaps.
    #[pyo3(signature = (path, *, vehicle = "passengerCar"))]
    fn speeds_on_path<'py>(
        &self,
        py: Python<'py>,
        path: &Bound<'py, Path>,
        vehicle: &str,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (path, mut found) = (path.get().path().map_err(query)?, Vec::new());
        self.view().speeds_on_path(&path, vehicle_of(vehicle)?, &mut found).map_err(query)?;
        let one = |own: &mapd_client::view::PathSpeedToday<'_>| {
            let ([start, end], speed) = (own.along, self.speed(py, &own.today)?);
            let fields = fields!(py, start = start, end = end, speed = speed);
            result(py, "PathSpeedToday", &fields)
        };
        found.iter().map(one).collect()
    }

    /// How long a vehicle takes from one S of a path to another [m] at these limits. What is closed takes as long as if it were open.
    #[pyo3(signature = (path, start = 0.0, end = None, *, vehicle = "passengerCar"))]
    fn travel_time_on_path<'py>(
        &self,
        py: Python<'py>,
        path: &Bound<'py, Path>,
        start: f64,
        end: Option<f64>,
        vehicle: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        let path = path.get().path().map_err(query)?;
        let part = [start, end.unwrap_or_else(|| path.length())];
        let found = self.view().travel_time_on_path(&path, part, vehicle_of(vehicle)?);
        let found = found.map_err(|error| match error {
            PathError::Map(error) => query(error),
            error => raise("PathError", error.to_string()),
        })?;
        result(py, "PathTime", &fields!(py, time = found.time, unlimited = found.unlimited))
    }

    /// From which lanes a path's goal is reached, none of them through what is closed now, and until where a change of lane may wait.
    #[pyo3(signature = (path, *, vehicle = "passengerCar"))]
    fn segments_on_path<'py>(
        &self,
        py: Python<'py>,
        path: &Bound<'py, Path>,
        vehicle: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (path, mut found) = (path.get().path().map_err(query)?, Vec::new());
        let (view, vehicle) = (self.view(), vehicle_of(vehicle)?);
        py.detach(|| view.segments_on_path(&path, vehicle, &mut found)).map_err(query)?;
        crate::along::segment_columns(py, &self.held, &found)
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

    /// As Map.route, with the overlay's current entries applied.
    #[pyo3(signature = (start, goal, *, via = None, vehicle = "passengerCar", by = "length", lane_change = None, factors = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn route<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'py, PyAny>,
        goal: &Bound<'py, PyAny>,
        via: Option<Vec<Bound<'py, PyAny>>>,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let (cost, vehicle) = (Cost::named(by, lane_change, factors)?, vehicle_of(vehicle)?);
        let places = std::iter::once(start).chain(via.iter().flatten()).chain([goal]);
        let places = places.map(|place| place_of(self.held.map(), place));
        let (places, mut steps) = (places.collect::<PyResult<Vec<_>>>()?, Vec::new());
        let route = py
            .detach(|| {
                let mut scratch = RouteScratch::default();
                self.view().route_via(&places, vehicle, &cost, &mut scratch, &mut steps)
            })
            .map_err(routing)?;
        route.map(|route| found_route(py, &self.held, &route, &steps)).transpose()
    }

    /// The cheapest way from any of some starts to any of some goals, which may be `RouteEnd`; lanes to avoid are not entered.
    ///
    /// `turns` are what turns to the left, to the right and back at junctions cost beside the way, in its unit; other options are those of route.
    #[pyo3(signature = (starts, goals, *, avoid = None, vehicle = "passengerCar", by = "length", lane_change = None,
        factors = None, turns = [0.0; 3]))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn find_route<'py>(
        &self,
        py: Python<'py>,
        starts: &Bound<'py, PyAny>,
        goals: &Bound<'py, PyAny>,
        avoid: Option<Vec<Bound<'py, PyAny>>>,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
        turns: [f64; 3],
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        let (held, ends) = (&self.held, [Some(starts), Some(goals)]);
        let asked =
            crate::request::Asked::of(held.map(), ends, avoid.as_deref(), vehicle, cost, turns)?;
        crate::request::find(py, held, |scratch, steps| {
            self.view().find_route(&asked.request(), scratch, steps)
        })
    }

    /// The cheapest way and alternatives to it, cheapest first: `count` at most, each on other roads for a `share` of its length, none `longest` times as expensive.
    #[pyo3(signature = (starts, goals, *, count = 3, share = 0.3, longest = 1.5, avoid = None,
        vehicle = "passengerCar", by = "length", lane_change = None, factors = None, turns = [0.0; 3]))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn alternatives<'py>(
        &self,
        py: Python<'py>,
        starts: &Bound<'py, PyAny>,
        goals: &Bound<'py, PyAny>,
        count: usize,
        share: f64,
        longest: f64,
        avoid: Option<Vec<Bound<'py, PyAny>>>,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
        turns: [f64; 3],
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        let (held, ends) = (&self.held, [Some(starts), Some(goals)]);
        let asked =
            crate::request::Asked::of(held.map(), ends, avoid.as_deref(), vehicle, cost, turns)?;
        let wanted = AlternativeOptions { count, share, longest };
        crate::request::alternatives(py, held, &wanted, |options, scratch, out| {
            self.view().alternatives(&asked.request(), options, scratch, out)
        })
    }

    /// The network that can be reached from starts within a limit [m, or s by time], or from which goals can be, with the ways on.
    #[pyo3(signature = (limit, *, starts = None, goals = None, avoid = None, vehicle = "passengerCar", by = "length",
        lane_change = None, factors = None, turns = [0.0; 3]))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn reach<'py>(
        &self,
        py: Python<'py>,
        limit: f64,
        starts: Option<&Bound<'py, PyAny>>,
        goals: Option<&Bound<'py, PyAny>>,
        avoid: Option<Vec<Bound<'py, PyAny>>>,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
        turns: [f64; 3],
    ) -> PyResult<Bound<'py, PyAny>> {
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        let (held, ends, to) = (&self.held, [starts, goals], goals.is_some());
        if starts.is_some() == to {
            return Err(pyo3::exceptions::PyValueError::new_err(
                "expected starts, from which one drives, or goals, to which one comes",
            ));
        }
        let asked =
            crate::request::Asked::of(held.map(), ends, avoid.as_deref(), vehicle, cost, turns)?;
        crate::request::reach(py, held, |scratch, out| {
            if to {
                self.view().reach_to(&asked.request(), limit, scratch, out)
            } else {
                self.view().reach(&asked.request(), limit, scratch, out)
            }
        })
    }

    /// As Map.reachable, with the overlay's current entries applied [m, or s by time].
    #[pyo3(signature = (start, limit, *, vehicle = "passengerCar", by = "length", lane_change = None, factors = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn reachable<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'py, PyAny>,
        limit: f64,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (cost, vehicle) = (Cost::named(by, lane_change, factors)?, vehicle_of(vehicle)?);
        let start = place_of(self.held.map(), start)?;
        let found = py
            .detach(|| {
                let (mut scratch, mut found) = (RouteScratch::default(), Vec::new());
                self.view().reachable(start, limit, vehicle, &cost, &mut scratch, &mut found)?;
                Ok(found)
            })
            .map_err(query)?;
        pieces_result(py, &self.held, &found)
    }

    /// As Path.corridor [m], with the overlay's current entries applied beside the path; speeds are the map's.
    #[pyo3(signature = (path, step = 1.0, *, start = 0.0, length = None, vehicle = "passengerCar", out = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn corridor<'py>(
        &self,
        py: Python<'py>,
        path: &Bound<'py, Path>,
        step: f64,
        start: f64,
        length: Option<f64>,
        vehicle: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (path, vehicle) = (path.get().path().map_err(query)?, vehicle_of(vehicle)?);
        let length = length.unwrap_or_else(|| path.length());
        crate::along::corridor(py, &self.held, out, |found| {
            self.view().corridor(&path, start, length, step, vehicle, found)
        })
    }

    /// As Map.signals_ahead [m]: ways through closed lanes are not followed.
    #[pyo3(signature = (start, distance, *, vehicle = "passengerCar"))]
    fn signals_ahead<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'py, PyAny>,
        distance: f64,
        vehicle: &str,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (start, vehicle) = (place_of(self.held.map(), start)?, vehicle_of(vehicle)?);
        let mut found = SignalsAhead::default();
        self.view().signals_ahead(start, distance, vehicle, &mut found).map_err(query)?;
        ahead_result(py, &self.held, &found)
    }

    /// As Map.match_pose: a lane that is closed to the vehicle now has the prior of closed ones.
    #[pyo3(signature = (points, heading, covariance, *, types = None, z_tolerance = None,
        drive_deviation = 0.1, none = 0.01, vehicle = None, closed = 0.05, expected = None, unexpected = 0.05))]
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

    fn __repr__(&self) -> String {
        let (all, view) = (self.view().entries().count(), self.view());
        let now = view.entries().filter(|own| view.holds(own)).count();
        format!("<mapd.View {:?}: {now} of {all} entries hold>", self.held.map().name())
    }
}
