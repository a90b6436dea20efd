//! What holds along routes and paths.

use super::{Speeds, View};
use crate::batch::{answer, fields, result};
use crate::errors::{query, raise};
use crate::input::{rules_of, vehicle_of};
use crate::path::Path;
use crate::room::Room;
use mapd_client::path::PathError;
use pyo3::prelude::*;

#[pymethods]
impl View {
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

    /// As Path.conflicts, with lights that are out of service now left out: where they would decide, signs do, then priorities of the file, then the rules of a `country`.
    #[pyo3(signature = (path, country = None))]
    fn conflicts<'py>(
        &self,
        py: Python<'py>,
        path: &Bound<'py, Path>,
        country: Option<&str>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (path, rules) = (path.get().path().map_err(query)?, rules_of(country)?);
        let (mut found, mut lanes) = (Vec::new(), Vec::new());
        self.view().conflicts(&path, &mut found, &mut lanes).map_err(query)?;
        crate::along::conflicts(py, &self.held, &found, &lanes, rules)
    }

    /// As Path.crossings, with lights that are out of service now left out.
    fn crossings<'py>(
        &self,
        py: Python<'py>,
        path: &Bound<'py, Path>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (path, mut found) = (path.get().path().map_err(query)?, Vec::new());
        self.view().crossings(&path, &mut found).map_err(query)?;
        crate::along::crossings(py, &self.held, &found)
    }

    /// As Path.facts, with today's permissions; a light that is out of service now governs nothing.
    fn facts<'py>(
        &self,
        py: Python<'py>,
        path: &Bound<'py, Path>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (path, view, mut found) = (path.get().path().map_err(query)?, self.view(), Vec::new());
        py.detach(|| view.facts(&path, &mut found)).map_err(query)?;
        crate::along::facts(py, &self.held, &found)
    }

    /// As Path.corridor [m], under the overlay's current entries, beside the path too; speeds are today's.
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
}
