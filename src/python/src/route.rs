//! Routes, what can be reached, and what lies ahead.

use crate::batch::{columns, fields, result};
use crate::errors::{query, routing};
use crate::held::{Held, content, id};
use crate::input::{column_of_any, place_of, vehicle_of};
use crate::lane::Lane;
use crate::request::network_result;
use crate::room::{Column, Room};
use crate::signal::Signal;
use mapd_client::graph::LaneNode;
use mapd_client::route::{
    CostBound, Enter, Reached, Route, RouteCost, RouteScratch, RouteStep, ShortestLength,
    ShortestTime, WithFactors,
};
use mapd_client::signals::SignalsAhead;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::sync::{Arc, Mutex, PoisonError};

/// What is kept small.
enum Plain {
    Length(ShortestLength),
    Time(ShortestTime),
}

/// What is kept small, with a factor for each lane.
pub(crate) struct Cost {
    plain: Plain,
    factors: Vec<f64>,
}

impl Cost {
    /// `length` or `time`, with what a change of lane costs, and a factor for each lane by its row.
    pub(crate) fn named(
        name: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let plain = match name {
            "length" => Plain::Length(match lane_change {
                Some(lane_change) => ShortestLength { lane_change },
                None => ShortestLength::default(),
            }),
            "time" => Plain::Time(match lane_change {
                Some(lane_change) => ShortestTime { lane_change },
                None => ShortestTime::default(),
            }),
            _ => {
                return Err(PyValueError::new_err(format!(
                    "by: expected \"length\" or \"time\", found {name:?}"
                )));
            }
        };
        let factors =
            factors.map(|all| column_of_any(all, "factors", &mut Room::default())).transpose()?;
        Ok(Self { plain, factors: factors.unwrap_or_default() })
    }

    fn with_factors(&self) -> WithFactors<'_, &Plain> {
        WithFactors { base: &self.plain, factors: &self.factors }
    }
}

impl RouteCost for Cost {
    fn pass(&self, node: &LaneNode<'_>) -> f64 {
        self.with_factors().pass(node)
    }

    fn change(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        self.with_factors().change(from, to)
    }

    fn bound(&self) -> CostBound {
        self.with_factors().bound()
    }
}

impl RouteCost for &Plain {
    fn pass(&self, node: &LaneNode<'_>) -> f64 {
        match self {
            Plain::Length(cost) => cost.pass(node),
            Plain::Time(cost) => cost.pass(node),
        }
    }

    fn change(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        match self {
            Plain::Length(cost) => cost.change(from, to),
            Plain::Time(cost) => cost.change(from, to),
        }
    }

    fn bound(&self) -> CostBound {
        match self {
            Plain::Length(cost) => cost.bound(),
            Plain::Time(cost) => cost.bound(),
        }
    }
}

pub(crate) fn entered(enter: Enter) -> &'static str {
    match enter {
        Enter::Start => "start",
        Enter::Ahead => "ahead",
        Enter::Left => "left",
        Enter::Right => "right",
    }
}

/// The cheapest way through places.
pub(crate) fn route<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    places: &[&Bound<'py, PyAny>],
    vehicle: &str,
    cost: Cost,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    let vehicle = vehicle_of(vehicle)?;
    let places = places.iter().map(|place| place_of(held.map(), place));
    let places = places.collect::<PyResult<Vec<_>>>()?;
    let (route, steps) = py
        .detach(|| {
            let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
            let map = held.map();
            let route = map.route_via(&places, vehicle, &cost, &mut scratch, &mut steps)?;
            Ok((route, steps))
        })
        .map_err(routing)?;
    route.map(|route| found_route(py, held, &route, &steps)).transpose()
}

/// A step as Python has it.
pub(crate) fn step_result<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    step: &RouteStep,
) -> PyResult<Bound<'py, PyAny>> {
    let fields = fields!(
        py,
        lane = Lane::new(held, step.lane.row()),
        forward = step.forward,
        enter = entered(step.enter),
        s_from = step.s_from,
        s_to = step.s_to,
        s_latest = step.s_latest,
    );
    result(py, "RouteStep", &fields)
}

/// A route as Python has it.
pub(crate) fn found_route<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    route: &Route,
    steps: &[RouteStep],
) -> PyResult<Bound<'py, PyAny>> {
    let steps = steps.iter().map(|step| step_result(py, held, step));
    let steps = pyo3::types::PyTuple::new(py, steps.collect::<PyResult<Vec<_>>>()?)?;
    let fields = fields!(
        py,
        cost = route.cost,
        length = route.length,
        travel_time = route.travel_time,
        assumed_time = route.assumed_time,
        lane_changes = route.lane_changes,
        steps = steps,
        start = route.start,
        goal = route.goal,
    );
    result(py, "Route", &fields)
}

/// What can be reached within a cost, or, with `to`, from where a place can.
pub(crate) fn reachable<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    place: &Bound<'py, PyAny>,
    limit: f64,
    vehicle: &str,
    cost: &Cost,
    to: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let vehicle = vehicle_of(vehicle)?;
    let place = place_of(held.map(), place)?;
    let found = py
        .detach(|| {
            let (map, mut scratch, mut found) = (held.map(), RouteScratch::default(), Vec::new());
            if to {
                map.reachable_to(place, limit, vehicle, cost, &mut scratch, &mut found)?;
            } else {
                map.reachable(place, limit, vehicle, cost, &mut scratch, &mut found)?;
            }
            Ok(found)
        })
        .map_err(query)?;
    pieces_result(py, held, &found)
}

/// Pieces of lanes as Python has them.
pub(crate) fn pieces_result<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    pieces: &[Reached],
) -> PyResult<Bound<'py, PyAny>> {
    let content = content(held.map());
    let numbers = |of: fn(&Reached) -> f64| Column::Numbers(pieces.iter().map(of).collect());
    let all = vec![
        Column::Ids(pieces.iter().map(|one| id(content, one.lane.row())).collect()),
        Column::Flags(pieces.iter().map(|one| one.forward).collect()),
        numbers(|one| one.s_from),
        numbers(|one| one.s_to),
        numbers(|one| one.cost),
        Column::Counts(pieces.iter().map(|one| i64::from(one.lane_changes)).collect()),
    ];
    columns(py, "Reached", all)
}

/// All sequences of lanes ahead of a place, or behind it, without changes of lane. Iterate over it to get one by one, each a list of lanes; their number doubles with each fork.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct LaneSequences {
    held: Arc<Held>,
    found: Mutex<mapd_client::route::LaneSequences>,
}

impl LaneSequences {
    /// Finds them.
    pub(crate) fn new(
        py: Python<'_>,
        held: &Arc<Held>,
        place: &Bound<'_, PyAny>,
        distance: f64,
        vehicle: &str,
        ahead: bool,
    ) -> PyResult<Self> {
        let map = held.map();
        let (place, vehicle) = (place_of(map, place)?, vehicle_of(vehicle)?);
        let (mut scratch, mut found) = (RouteScratch::default(), Default::default());
        let result = py.detach(|| {
            if ahead {
                map.lane_sequences_ahead(place, distance, vehicle, &mut scratch, &mut found)
            } else {
                map.lane_sequences_behind(place, distance, vehicle, &mut scratch, &mut found)
            }
        });
        result.map_err(query)?;
        Ok(Self { held: Arc::clone(held), found: Mutex::new(found) })
    }
}

#[pymethods]
impl LaneSequences {
    fn __iter__(this: PyRef<'_, Self>) -> PyRef<'_, Self> {
        this
    }

    fn __next__(&self) -> Option<Vec<Lane>> {
        let mut found = self.found.lock().unwrap_or_else(PoisonError::into_inner);
        let lanes = found.next_sequence()?;
        Some(lanes.iter().map(|id| Lane::new(&self.held, id.row())).collect())
    }

    /// What all of them lead over, each piece of a lane once, nearest first; its size grows with the map ahead, not with the number of sequences.
    #[getter]
    fn network<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        // Not under the lock: results are made by Python code, in between which other threads run.
        let found = self.found.lock().unwrap_or_else(PoisonError::into_inner).network().clone();
        network_result(py, &self.held, &found)
    }
}

/// Signals that one comes to without a change of lane.
pub(crate) fn signals_ahead<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    start: &Bound<'py, PyAny>,
    distance: f64,
    vehicle: &str,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let map = held.map();
    let (start, vehicle) = (place_of(map, start)?, vehicle_of(vehicle)?);
    let mut found = SignalsAhead::default();
    map.signals_ahead(start, distance, vehicle, &mut found).map_err(query)?;
    ahead_result(py, held, &found)
}

/// Signals ahead as Python has them.
pub(crate) fn ahead_result<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    found: &SignalsAhead,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let one = |ahead: &mapd_client::signals::SignalAhead| {
        let fields = fields!(
            py,
            signal = Signal::new(held, ahead.signal),
            distance = ahead.distance,
            lane = Lane::new(held, ahead.lane.row()),
            s = ahead.s,
        );
        result(py, "SignalAhead", &fields)
    };
    found.iter().map(one).collect()
}
