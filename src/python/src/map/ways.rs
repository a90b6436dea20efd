//! Ways through the network, and what lies on them.

use super::Map;
use crate::errors::query;
use crate::input::vehicle_of;
use crate::junction::Junction;
use crate::route::LaneSequences;
use mapd_client::path::{LaneChange, PathOptions};
use mapd_client::route::AlternativeOptions;
use pyo3::prelude::*;

#[pymethods]
impl Map {
    /// The cheapest way in driving direction, by allowed changes of lane only; None if there is none.
    ///
    /// A place is (lane, s) or what nearest_lane found. `lane_change` is what a change costs: default 20 m, or 2 s by time. `factors`
    /// multiply the cost of each lane, by its row (mapd.raw.rows): infinity closes it; lanes beyond their end have the factor 1.
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
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        let places: Vec<_> =
            std::iter::once(start).chain(via.iter().flatten()).chain([goal]).collect();
        crate::route::route(py, &self.0, &places, vehicle, cost)
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
        let (held, ends) = (&self.0, [Some(starts), Some(goals)]);
        let asked =
            crate::request::Asked::of(held.map(), ends, avoid.as_deref(), vehicle, cost, turns)?;
        crate::request::find(py, held, |scratch, steps| {
            self.map().find_route(&asked.request(), scratch, steps)
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
        let (held, ends) = (&self.0, [Some(starts), Some(goals)]);
        let asked =
            crate::request::Asked::of(held.map(), ends, avoid.as_deref(), vehicle, cost, turns)?;
        let wanted = AlternativeOptions { count, share, longest };
        crate::request::alternatives(py, held, &wanted, |options, scratch, out| {
            self.map().alternatives(&asked.request(), options, scratch, out)
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
        let (held, ends, to) = (&self.0, [starts, goals], goals.is_some());
        if starts.is_some() == to {
            return Err(pyo3::exceptions::PyValueError::new_err(
                "expected starts, from which one drives, or goals, to which one comes",
            ));
        }
        let asked =
            crate::request::Asked::of(held.map(), ends, avoid.as_deref(), vehicle, cost, turns)?;
        crate::request::reach(py, held, |scratch, out| {
            if to {
                self.map().reach_to(&asked.request(), limit, scratch, out)
            } else {
                self.map().reach(&asked.request(), limit, scratch, out)
            }
        })
    }

    /// A route, or steps made by hand, as one line; PathError names the step that does not follow.
    ///
    /// `change_length` [m] makes each change of lane a smooth curve of that length, over lanes that follow as far as the `vehicle` may change there; without room the line
    /// jumps. With `shortest_change` [m], less room makes it shorter, and what has even less is a broken joint. `change_delay` [m] is how far behind the first place where it
    /// can be it begins, as far as there is room: `math.inf` for as late as can be. Joints with a larger gap than `broken_gap` [m] or kink than `broken_kink` [rad] are broken.
    #[pyo3(signature = (steps, *, change_length = None, shortest_change = None, change_delay = 0.0, vehicle = "passengerCar",
        broken_gap = 0.1, broken_kink = 0.3))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn path(
        &self,
        steps: &Bound<'_, PyAny>,
        change_length: Option<f64>,
        shortest_change: Option<f64>,
        change_delay: f64,
        vehicle: &str,
        broken_gap: f64,
        broken_kink: f64,
    ) -> PyResult<crate::path::Path> {
        let change = change_length.map_or(LaneChange::Jump, LaneChange::Lateral);
        let vehicle = vehicle_of(vehicle)?;
        let options =
            PathOptions { broken_gap, broken_kink, change, shortest_change, change_delay, vehicle };
        crate::path::path(&self.0, steps, &options)
    }

    /// The lanes on which traffic comes to a conflict of a path, back to a distance [m], nearest first; the other lane itself comes first.
    ///
    /// `vehicle` is the class of who comes, not of who drives the path: lanes that are closed to it bring none, the other lane neither.
    #[pyo3(signature = (conflict, distance, *, vehicle = "passengerCar"))]
    fn approaches<'py>(
        &self,
        py: Python<'py>,
        conflict: &Bound<'py, PyAny>,
        distance: f64,
        vehicle: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        crate::along::approaches(py, &self.0, conflict, distance, vehicle_of(vehicle)?)
    }

    /// Pieces of lanes whose beginning can be reached within a limit [m, or s by time], nearest first.
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
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        crate::route::reachable(py, &self.0, start, limit, vehicle, &cost, false)
    }

    /// Pieces of lanes from whose beginning a place can be reached within a limit [m, or s by time], nearest first.
    #[pyo3(signature = (goal, limit, *, vehicle = "passengerCar", by = "length", lane_change = None, factors = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn reachable_to<'py>(
        &self,
        py: Python<'py>,
        goal: &Bound<'py, PyAny>,
        limit: f64,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        crate::route::reachable(py, &self.0, goal, limit, vehicle, &cost, true)
    }

    /// All sequences of lanes that one can follow without a change of lane, until each is `distance` [m] long or ends.
    #[pyo3(signature = (start, distance, *, vehicle = "passengerCar"))]
    fn lane_sequences_ahead(
        &self,
        py: Python<'_>,
        start: &Bound<'_, PyAny>,
        distance: f64,
        vehicle: &str,
    ) -> PyResult<LaneSequences> {
        LaneSequences::new(py, &self.0, start, distance, vehicle, true)
    }

    /// The next junction ahead of a place and the distance to it [m]; 0 on a connecting road, None if there is none within `distance` [m].
    ///
    /// Follows the lanes as long as there is but one way on, or all ways lead into one junction.
    #[pyo3(signature = (start, distance, *, vehicle = "passengerCar"))]
    fn next_junction(
        &self,
        start: &Bound<'_, PyAny>,
        distance: f64,
        vehicle: &str,
    ) -> PyResult<Option<(Junction, f64)>> {
        let start = crate::input::place_of(self.map(), start)?;
        let next = self.map().next_junction(start, distance, vehicle_of(vehicle)?);
        Ok(next.map_err(query)?.map(|one| (Junction::new(&self.0, one.junction), one.distance)))
    }

    /// Signals for traffic that goes on without a change of lane, up to a distance [m].
    #[pyo3(signature = (start, distance, *, vehicle = "passengerCar"))]
    fn signals_ahead<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'py, PyAny>,
        distance: f64,
        vehicle: &str,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        crate::route::signals_ahead(py, &self.0, start, distance, vehicle)
    }
}
