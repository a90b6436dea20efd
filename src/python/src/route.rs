//! Routes, what can be reached, and what lies ahead.

use crate::batch::{Column, columns, fields, result};
use crate::errors::query;
use crate::held::{Held, content, id};
use crate::input::{place_of, vehicle_of};
use crate::lane::Lane;
use crate::signal::Signal;
use mapd_client::SRange;
use mapd_client::graph::LaneNode;
use mapd_client::route::{
    CostBound, Enter, LaneSequences, Reached, Route, RouteCost, RouteScratch, RouteStep,
    ShortestLength, ShortestTime,
};
use mapd_client::signals::SignalsAhead;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::sync::Arc;

/// What is kept small.
pub(crate) enum Cost {
    Length(ShortestLength),
    Time(ShortestTime),
}

impl Cost {
    /// `length` or `time`, with what a change of lane costs.
    pub(crate) fn named(name: &str, lane_change: Option<f64>) -> PyResult<Self> {
        match name {
            "length" => Ok(Self::Length(match lane_change {
                Some(lane_change) => ShortestLength { lane_change },
                None => ShortestLength::default(),
            })),
            "time" => Ok(Self::Time(match lane_change {
                Some(lane_change) => ShortestTime { lane_change },
                None => ShortestTime::default(),
            })),
            _ => Err(PyValueError::new_err(format!(
                "by: expected \"length\" or \"time\", found {name:?}"
            ))),
        }
    }
}

impl RouteCost for Cost {
    fn pass(&self, node: &LaneNode<'_>) -> f64 {
        match self {
            Self::Length(cost) => cost.pass(node),
            Self::Time(cost) => cost.pass(node),
        }
    }

    fn change(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        match self {
            Self::Length(cost) => cost.change(from, to),
            Self::Time(cost) => cost.change(from, to),
        }
    }

    fn bound(&self) -> CostBound {
        match self {
            Self::Length(cost) => cost.bound(),
            Self::Time(cost) => cost.bound(),
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
        .map_err(query)?;
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
        lane_changes = route.lane_changes,
        steps = steps,
    );
    result(py, "Route", &fields)
}

/// Columns of what can be reached: lane, forward, from and to [m], cost.
pub(crate) type Pieces = Vec<(u32, bool, f64, f64, f64)>;

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
    let pieces = py
        .detach(|| {
            let map = held.map();
            let (mut scratch, mut found) = (RouteScratch::default(), Vec::new());
            if to {
                map.reachable_to(place, limit, vehicle, cost, &mut scratch, &mut found)?;
            } else {
                map.reachable(place, limit, vehicle, cost, &mut scratch, &mut found)?;
            }
            let piece = |reached: &Reached| {
                let node = map.lane_node(reached.node)?;
                let lane = node.lane().ok_or(mapd_client::QueryError::Corrupt)?;
                let SRange { low, high } = node.s_range();
                Ok((lane.lane_id().row(), node.is_forward(), low, high, reached.cost))
            };
            found.iter().map(piece).collect::<Result<Pieces, mapd_client::QueryError>>()
        })
        .map_err(query)?;
    pieces_result(py, held, &pieces)
}

/// Pieces of lanes as Python has them.
pub(crate) fn pieces_result<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    pieces: &Pieces,
) -> PyResult<Bound<'py, PyAny>> {
    let content = content(held.map());
    let all = vec![
        Column::Ids(pieces.iter().map(|one| id(content, one.0)).collect()),
        Column::Flags(pieces.iter().map(|one| one.1).collect()),
        Column::Numbers(pieces.iter().map(|one| one.2).collect()),
        Column::Numbers(pieces.iter().map(|one| one.3).collect()),
        Column::Numbers(pieces.iter().map(|one| one.4).collect()),
    ];
    columns(py, "Reached", all, None)
}

/// Every way on without a change of lane.
pub(crate) fn sequences(
    held: &Arc<Held>,
    start: &Bound<'_, PyAny>,
    distance: f64,
    vehicle: &str,
) -> PyResult<Vec<Vec<Lane>>> {
    let map = held.map();
    let (start, vehicle) = (place_of(map, start)?, vehicle_of(vehicle)?);
    let mut found = LaneSequences::default();
    map.lane_sequences_ahead(start, distance, vehicle, &mut found).map_err(query)?;
    let lanes = |ids: &[mapd_client::LaneId]| {
        ids.iter().map(|id| Lane::new(held, id.row())).collect::<Vec<_>>()
    };
    Ok(found.iter().map(lanes).collect())
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
