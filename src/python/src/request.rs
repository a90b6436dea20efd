//! Routes by request: several starts and goals, lanes to avoid, costs of turns; alternatives; the network that can be reached.

use crate::batch::{columns, fields, result};
use crate::errors::routing;
use crate::held::Held;
use crate::input::{lanes_of, place_of, vehicle_of};
use crate::room::Column;
use crate::route::{Cost, found_route, pieces_result};
use mapd_client::route::{
    AlternativeOptions, Enter, Reach, Route, RouteEnd, RouteError, RouteRequest, RouteScratch,
    RouteStep, Routes, WithTurns,
};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{LaneId, Map};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use std::sync::Arc;

/// What callers ask, with lists of their own.
pub(crate) struct Asked {
    starts: Vec<RouteEnd>,
    goals: Vec<RouteEnd>,
    avoid: Vec<LaneId>,
    vehicle: VehicleClass,
    cost: WithTurns<Cost>,
}

/// A start or goal: a place, which may say in which direction its lane is travelled and what it costs to be there.
fn end(map: Map<'_>, what: &Bound<'_, PyAny>) -> PyResult<RouteEnd> {
    let place = place_of(map, what)?;
    // Tuples of other calls, such as what nearest_lane finds, have neither.
    let is_end = what.get_type().name()? == "RouteEnd";
    if !is_end {
        return Ok(place.into());
    }
    let forward = what.getattr("forward")?.extract()?;
    Ok(RouteEnd { place, forward, cost: what.getattr("cost")?.extract()? })
}

/// One place, or a list of them.
fn ends(map: Map<'_>, what: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<RouteEnd>> {
    let Some(what) = what else { return Ok(Vec::new()) };
    if what.is_instance_of::<pyo3::types::PyTuple>() {
        return Ok(vec![end(map, what)?]);
    }
    let all = what
        .try_iter()
        .map_err(|_| PyTypeError::new_err("expected a place, (lane, s), or a list of places"))?;
    all.map(|one| end(map, &one?)).collect()
}

impl Asked {
    pub(crate) fn of<'py>(
        map: Map<'_>,
        [starts, goals]: [Option<&Bound<'py, PyAny>>; 2],
        avoid: Option<&[Bound<'py, PyAny>]>,
        vehicle: &str,
        base: Cost,
        [left, right, back]: [f64; 3],
    ) -> PyResult<Self> {
        Ok(Self {
            starts: ends(map, starts)?,
            goals: ends(map, goals)?,
            avoid: lanes_of(map, avoid)?,
            vehicle: vehicle_of(vehicle)?,
            cost: WithTurns { base, left, right, back },
        })
    }

    pub(crate) fn request(&self) -> RouteRequest<'_, WithTurns<Cost>> {
        let Self { starts, goals, avoid, vehicle, cost } = self;
        RouteRequest { starts, goals, vehicle: *vehicle, cost, avoid }
    }
}

/// The cheapest way.
pub(crate) fn find<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    search: impl FnOnce(&mut RouteScratch, &mut Vec<RouteStep>) -> Result<Option<Route>, RouteError>
    + Send,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    let mut steps = Vec::new();
    let found = py.detach(|| search(&mut RouteScratch::default(), &mut steps)).map_err(routing)?;
    found.map(|route| found_route(py, held, &route, &steps)).transpose()
}

/// The cheapest way and alternatives.
pub(crate) fn alternatives<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    options: &AlternativeOptions,
    search: impl FnOnce(&AlternativeOptions, &mut RouteScratch, &mut Routes) -> Result<(), RouteError>
    + Send,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let mut routes = Routes::default();
    py.detach(|| search(options, &mut RouteScratch::default(), &mut routes)).map_err(routing)?;
    routes.iter().map(|(route, steps)| found_route(py, held, route, steps)).collect()
}

/// What is reached, and how one goes on from each.
pub(crate) fn reach<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    search: impl FnOnce(&mut RouteScratch, &mut Reach) -> Result<(), RouteError> + Send,
) -> PyResult<Bound<'py, PyAny>> {
    let mut found = Reach::default();
    py.detach(|| search(&mut RouteScratch::default(), &mut found)).map_err(routing)?;
    network_result(py, held, &found)
}

/// What is reached, and how one goes on from each, as Python has it.
pub(crate) fn network_result<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    found: &Reach,
) -> PyResult<Bound<'py, PyAny>> {
    let (mut from, mut to, mut enter) = (Vec::new(), Vec::new(), Vec::new());
    for number in 0..found.reached().len() {
        for link in found.links(number) {
            from.push(number as i64);
            to.push(link.to as i64);
            enter.push(match link.enter {
                Enter::Start => 0,
                Enter::Ahead => 1,
                Enter::Left => 2,
                Enter::Right => 3,
            });
        }
    }
    let links = vec![Column::Counts(from), Column::Counts(to), Column::Codes(enter)];
    let fields = fields!(
        py,
        pieces = pieces_result(py, held, found.reached())?,
        links = columns(py, "ReachLinks", links)?,
    );
    result(py, "Reach", &fields)
}
