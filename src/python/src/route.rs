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
    CostBound, Enter, LaneSequences, RouteCost, RouteScratch, ShortestLength, ShortestTime,
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

fn entered(enter: Enter) -> &'static str {
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
    let Some(route) = route else { return Ok(None) };
    let steps = steps.iter().map(|step| {
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
    });
    let steps = pyo3::types::PyTuple::new(py, steps.collect::<PyResult<Vec<_>>>()?)?;
    let fields = fields!(
        py,
        cost = route.cost,
        length = route.length,
        travel_time = route.travel_time,
        lane_changes = route.lane_changes,
        steps = steps,
    );
    result(py, "Route", &fields).map(Some)
}

/// What can be reached within a cost.
pub(crate) fn reachable<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    start: &Bound<'py, PyAny>,
    limit: f64,
    vehicle: &str,
    cost: Cost,
) -> PyResult<Bound<'py, PyAny>> {
    let vehicle = vehicle_of(vehicle)?;
    let start = place_of(held.map(), start)?;
    let (ids, forward, numbers) = py
        .detach(|| {
            let map = held.map();
            let (mut scratch, mut found) = (RouteScratch::default(), Vec::new());
            map.reachable(start, limit, vehicle, &cost, &mut scratch, &mut found)?;
            let content = content(map);
            let (mut ids, mut forward) = (Vec::new(), Vec::new());
            let mut numbers: [Vec<f64>; 3] = Default::default();
            for reached in &found {
                let node = map.lane_nodes().nth(reached.node.row() as usize);
                let Some((node, lane)) = node.and_then(|node| Some((node, node.lane()?))) else {
                    return Err(mapd_client::QueryError::Corrupt);
                };
                let SRange { low: from, high: to } = node.s_range();
                ids.push(id(content, lane.lane_id().row()));
                forward.push(node.is_forward());
                let values = [from, to, reached.cost];
                numbers.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
            }
            Ok((ids, forward, numbers))
        })
        .map_err(query)?;
    let mut all = vec![Column::Ids(ids), Column::Flags(forward)];
    all.extend(numbers.into_iter().map(Column::Numbers));
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
