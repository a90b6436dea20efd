//! A route as one line.

use crate::batch::{Speeds, answer, clamped_code, fields, result, speed_rule};
use crate::errors::{query, raise};
use crate::held::{Held, content, id};
use crate::input::{Rows, finite, lane_of, one_point, rules_of, vehicle_of};
use crate::lane::Lane;
use crate::room::{Column, Room};
use mapd_client::QueryError;
use mapd_client::path::{PathBuffer, PathOptions, PathPoint, PathPosition};
use mapd_client::route::{Enter, PositionOnLane, RouteStep};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::sync::Arc;

/// A route as one line. S counts the metres driven along centre lines; left and right are the driver's.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct Path {
    held: Arc<Held>,
    steps: Vec<RouteStep>,
    buffer: PathBuffer,
}

/// A step of a route from what Python has of it.
pub(crate) fn step(map: mapd_client::Map<'_>, step: &Bound<'_, PyAny>) -> PyResult<RouteStep> {
    let enter: String = step.getattr("enter")?.extract()?;
    let enter = match enter.as_str() {
        "start" => Enter::Start,
        "ahead" => Enter::Ahead,
        "left" => Enter::Left,
        "right" => Enter::Right,
        _ => return Err(PyValueError::new_err(format!("enter: found {enter:?}"))),
    };
    Ok(RouteStep {
        lane: lane_of(map, &step.getattr("lane")?)?.lane_id(),
        forward: step.getattr("forward")?.extract()?,
        enter,
        s_from: step.getattr("s_from")?.extract()?,
        s_to: step.getattr("s_to")?.extract()?,
        s_latest: step.getattr("s_latest")?.extract()?,
    })
}

/// Steps of a route, or those that are given.
pub(crate) fn steps_of(
    map: mapd_client::Map<'_>,
    what: &Bound<'_, PyAny>,
) -> PyResult<Vec<RouteStep>> {
    let of_route = what.getattr_opt("steps")?;
    let steps = of_route.as_ref().unwrap_or(what);
    steps.try_iter()?.map(|one| step(map, &one?)).collect()
}

/// The path along a route's steps.
pub(crate) fn path(
    held: &Arc<Held>,
    steps: &Bound<'_, PyAny>,
    options: &PathOptions,
) -> PyResult<Path> {
    let map = held.map();
    let steps = steps_of(map, steps)?;
    let mut buffer = PathBuffer::default();
    map.path(&steps, options, &mut buffer)
        .map_err(|error| raise("PathError", error.to_string()))?;
    Ok(Path { held: Arc::clone(held), steps, buffer })
}

impl Path {
    pub(crate) fn path(&self) -> Result<mapd_client::path::Path<'_, '_>, mapd_client::QueryError> {
        mapd_client::path::Path::of(self.held.map(), &self.buffer)
    }

    fn lane(&self, lane: mapd_client::LaneId) -> Lane {
        Lane::new(&self.held, lane.row())
    }
}

fn point_values(at: &PathPoint) -> [f64; 12] {
    let p = at.position;
    [
        at.along,
        p.x,
        p.y,
        p.z,
        at.heading,
        at.curvature,
        at.curvature_rate,
        at.grade,
        at.superelevation,
        at.left,
        at.right,
        at.s,
    ]
}

fn position_values(at: &PathPosition) -> [f64; 5] {
    [at.along, at.d, at.distance, at.heading, at.s]
}

/// Columns of numbers, of lanes and of what was clamped.
struct Columns<const N: usize> {
    numbers: [Vec<f64>; N],
    lanes: Vec<u64>,
    clamped: Vec<i8>,
}

impl<const N: usize> Columns<N> {
    fn with_room(rows: usize, room: &mut Room) -> Self {
        Self { numbers: room.numbers(rows), lanes: room.take(rows), clamped: room.take(rows) }
    }

    fn push(&mut self, values: [f64; N], lane: u64, clamped: i8) {
        self.numbers.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        self.lanes.push(lane);
        self.clamped.push(clamped);
    }

    fn columns(self) -> Vec<Column> {
        let mut columns: Vec<_> = self.numbers.into_iter().map(Column::Numbers).collect();
        columns.push(Column::Ids(self.lanes));
        columns.push(Column::Codes(self.clamped));
        columns
    }
}

#[pymethods]
impl Path {
    /// The largest S [m].
    #[getter]
    fn length(&self) -> PyResult<f64> {
        Ok(self.path().map_err(query)?.length())
    }

    /// Whether there is a gap of more than 0.1 m or a kink of more than 0.3 rad.
    #[getter]
    fn is_broken(&self) -> PyResult<bool> {
        Ok(self.path().map_err(query)?.is_broken())
    }

    /// The lanes that are driven on.
    fn lanes(&self) -> PyResult<Vec<Lane>> {
        Ok(self.path().map_err(query)?.lanes().map(|own| self.lane(own.lane)).collect())
    }

    /// S of a place on one of its lanes [m]; None for one that it does not pass.
    fn along_of(&self, place: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
        let PositionOnLane { lane, s } = crate::input::place_of(self.held.map(), place)?;
        Ok(self.path().map_err(query)?.along_of(lane, s))
    }

    /// Places at S [m]; S outside is moved to the nearer end and flagged.
    #[pyo3(signature = (along, *, out = None))]
    fn at<'py>(
        &self,
        py: Python<'py>,
        along: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let path = self.path().map_err(query)?;
        if let Ok(along) = along.extract::<f64>() {
            let at = path.at(along).map_err(query)?;
            let p = at.position;
            let fields = fields!(
                py,
                along = at.along,
                x = p.x,
                y = p.y,
                z = p.z,
                heading = at.heading,
                curvature = at.curvature,
                curvature_rate = at.curvature_rate,
                grade = at.grade,
                superelevation = at.superelevation,
                left = at.left,
                right = at.right,
                s = at.s,
                lane = self.lane(at.lane),
                clamped = clamped_code(at.clamped),
            );
            return result(py, "PathPoint", &fields);
        }
        let mut room = Room::of(py, "PathPoints", out)?;
        let along = crate::input::column_of_any(along, "along", &mut room)?;
        let found = answer(py, || {
            let content = content(self.held.map());
            let mut found = Columns::with_room(along.len(), &mut room);
            for (row, along) in along.iter().enumerate() {
                let at = path.at(*along).map_err(|error| (row, error))?;
                let lane = id(content, at.lane.row());
                found.push(point_values(&at), lane, clamped_code(at.clamped));
            }
            room.give(along);
            Ok(found)
        })?;
        room.columns(py, "PathPoints", found.columns(), out)
    }

    /// Points in the path's coordinates. `hint` is an S [m] near which to look first.
    #[pyo3(signature = (points, *, hint = None, out = None))]
    fn project<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        hint: Option<f64>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let path = self.path().map_err(query)?;
        if let Some(point) = one_point(points, "points")? {
            let at = path.project(point.xy, hint).map_err(query)?;
            let fields = fields!(
                py,
                along = at.along,
                d = at.d,
                distance = at.distance,
                heading = at.heading,
                s = at.s,
                lane = self.lane(at.lane),
                clamped = clamped_code(at.clamped),
            );
            return result(py, "PathPosition", &fields);
        }
        let mut room = Room::of(py, "PathPositions", out)?;
        let points = Rows::of(points, "points", &[2, 3], &mut room)?;
        let found = answer(py, || {
            let content = content(self.held.map());
            let mut found = Columns::with_room(points.len(), &mut room);
            for (row, point) in points.points().enumerate() {
                let at = path.project(point.xy, hint).map_err(|error| (row, error))?;
                let lane = id(content, at.lane.row());
                found.push(position_values(&at), lane, clamped_code(at.clamped));
            }
            points.give(&mut room);
            Ok(found)
        })?;
        room.columns(py, "PathPositions", found.columns(), out)
    }

    /// Speed limits at S [m]; in a junction those that come in on the path.
    #[pyo3(signature = (along, *, out = None))]
    fn speed_at<'py>(
        &self,
        py: Python<'py>,
        along: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let path = self.path().map_err(query)?;
        // Of a finite S there is always a rule; a damaged archive has none.
        let rule = |along: f64| path.speed_at(finite(along)?).ok_or(QueryError::Corrupt);
        if let Ok(along) = along.extract::<f64>() {
            return speed_rule(py, &self.held, &rule(along).map_err(query)?);
        }
        let mut room = Room::of(py, "SpeedRules", out)?;
        let along = crate::input::column_of_any(along, "along", &mut room)?;
        let found = answer(py, || {
            let mut found = Speeds::with_room(along.len(), &mut room);
            for (row, along) in along.iter().enumerate() {
                found.push(&rule(*along).map_err(|error| (row, error))?);
            }
            room.give(along);
            Ok(found)
        })?;
        room.columns(py, "SpeedRules", found.columns(), out)
    }

    /// The room along the path, a station every `step` [m] from `start` [m] on, `length` [m] far.
    #[pyo3(signature = (step = 1.0, *, start = 0.0, length = None, vehicle = "passengerCar", out = None))]
    fn corridor<'py>(
        &self,
        py: Python<'py>,
        step: f64,
        start: f64,
        length: Option<f64>,
        vehicle: &str,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let path = self.path().map_err(query)?;
        let vehicle = vehicle_of(vehicle)?;
        let length = length.unwrap_or_else(|| path.length());
        crate::along::corridor(py, &self.held, out, |found| {
            path.corridor(start, length, step, vehicle, found)
        })
    }

    /// The road's surface at the stations that corridor has for the same numbers [m].
    #[pyo3(signature = (step = 1.0, *, start = 0.0, length = None, out = None))]
    fn corridor_surface<'py>(
        &self,
        py: Python<'py>,
        step: f64,
        start: f64,
        length: Option<f64>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let path = self.path().map_err(query)?;
        let length = length.unwrap_or_else(|| path.length());
        crate::along::surface(py, &path, [start, length, step], out)
    }

    /// What it comes by, in ascending S: junctions, signals, lines, types of roads and lanes, countries, access, bridges, tunnels, holes.
    fn facts<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (path, mut found) = (self.path().map_err(query)?, Vec::new());
        py.detach(|| path.facts(&mut found));
        crate::along::facts(py, &self.held, &found)
    }

    /// The speed limits along it, in ascending S without gaps.
    fn speeds<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        crate::along::speeds(py, &self.held, &self.path().map_err(query)?)
    }

    /// How long a vehicle takes from one S to another [m] at the speed limits.
    #[pyo3(signature = (start = 0.0, end = None))]
    fn travel_time<'py>(
        &self,
        py: Python<'py>,
        start: f64,
        end: Option<f64>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let path = self.path().map_err(query)?;
        let found = path.travel_time([start, end.unwrap_or_else(|| path.length())]);
        let found = found.map_err(|error| raise("PathError", error.to_string()))?;
        result(py, "PathTime", &fields!(py, time = found.time, unlimited = found.unlimited))
    }

    /// From which lanes its goal is reached along the same roads, and until where a change of lane may wait.
    #[pyo3(signature = (*, vehicle = "passengerCar"))]
    fn segments<'py>(&self, py: Python<'py>, vehicle: &str) -> PyResult<Bound<'py, PyAny>> {
        let path = self.path().map_err(query)?;
        crate::along::segments(py, &self.held, &path, vehicle_of(vehicle)?)
    }

    /// Crosswalks and bicycle crossings over it, in ascending S.
    fn crossings<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (path, mut found) = (self.path().map_err(query)?, Vec::new());
        path.crossings(&mut found);
        crate::along::crossings(py, &self.held, &found)
    }

    /// Gaps, overlaps and kinks, and changes of lane, in ascending S.
    fn joints<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        crate::along::joints(py, &self.path().map_err(query)?)
    }

    /// The part of its steps from one S to another [m], for a path over that part.
    fn steps_between<'py>(
        &self,
        py: Python<'py>,
        start: f64,
        end: f64,
    ) -> PyResult<Bound<'py, pyo3::types::PyTuple>> {
        let path = self.path().map_err(query)?;
        crate::along::steps_between(py, &self.held, &path, &self.steps, [start, end])
    }

    /// Its way on another map, such as the next version of its own, and what has changed.
    #[pyo3(signature = (map, *, vehicle = "passengerCar", by = "length", lane_change = None, factors = None))]
    fn rebase<'py>(
        &self,
        py: Python<'py>,
        map: &Bound<'py, crate::map::Map>,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (path, cost) =
            (self.path().map_err(query)?, crate::route::Cost::named(by, lane_change, factors)?);
        crate::along::rebase(py, &path, map.get().held(), vehicle_of(vehicle)?, &cost)
    }

    /// Where other traffic meets it, in ascending S. Who yields is what the file says; where that says nothing, what the rules of a `country` say ("DE"), if it is named.
    #[pyo3(signature = (country = None))]
    fn conflicts<'py>(
        &self,
        py: Python<'py>,
        country: Option<&str>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let rules = rules_of(country)?;
        let (mut found, mut lanes) = (Vec::new(), Vec::new());
        self.path().map_err(query)?.conflicts(&mut found, &mut lanes);
        crate::along::conflicts(py, &self.held, &found, &lanes, rules)
    }

    fn _repr_html_<'py>(this: Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        this.py().import("mapd._pictures")?.call_method1("path_html", (this,))
    }

    fn __repr__(&self) -> PyResult<String> {
        let path = self.path().map_err(query)?;
        Ok(format!("<mapd.Path {:.1} m over {} lanes>", path.length(), path.lanes().len()))
    }
}
