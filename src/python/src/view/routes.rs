//! Ways through the network, and the signals on them.

use super::View;
use crate::errors::{query, routing};
use crate::input::{place_of, vehicle_of};
use crate::route::{Cost, ahead_result, found_route, pieces_result};
use mapd_client::route::{AlternativeOptions, RouteScratch};
use mapd_client::signals::SignalsAhead;
use pyo3::prelude::*;

#[pymethods]
impl View {
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
}
