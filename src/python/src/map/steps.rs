//! Steps: made of lanes, and what lies along them.

use super::Map;
use crate::along::line;
use crate::batch::{fields, result};
use crate::errors::{query, raise};
use crate::input::{lanes_of, place_of};
use crate::path::steps_of;
use crate::route::{LaneSequences, ahead_result, step_result};
use mapd_client::route::next_lane_change;
use mapd_client::signals::SignalsAhead;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

#[pymethods]
impl Map {
    /// The steps over lanes that follow each other, such as those of a sequence, from s on the first to s on the last [m], each moved to its lane's nearer end.
    ///
    /// Each lane is driven in its own direction; one for both directions in the one that links ask for, and alone in the one from s to s. PathError names the
    /// lane that does not follow.
    fn steps_of_lanes<'py>(
        &self,
        py: Python<'py>,
        lanes: Vec<Bound<'py, PyAny>>,
        s_from: f64,
        s_to: f64,
    ) -> PyResult<Bound<'py, PyTuple>> {
        let (lanes, mut steps) = (lanes_of(self.map(), Some(&lanes))?, Vec::new());
        mapd_client::path::steps_of_lanes(self.map(), &lanes, [s_from, s_to], &mut steps)
            .map_err(|error| raise("PathError", error.to_string()))?;
        let steps = steps.iter().map(|step| step_result(py, &self.0, step));
        PyTuple::new(py, steps.collect::<PyResult<Vec<_>>>()?)
    }

    /// Lines to stop or give way at, crosswalks and bicycle crossings along a route, nearest first; one over several lanes stands once for each that is driven on.
    fn lines_along<'py>(
        &self,
        py: Python<'py>,
        steps: &Bound<'py, PyAny>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (steps, mut found) = (steps_of(self.map(), steps)?, Vec::new());
        self.map().lines_along(&steps, &mut found).map_err(query)?;
        let ahead = |one: &mapd_client::rules::LineAhead| {
            let line = line(py, &self.0, &one.line)?;
            result(py, "LineAhead", &fields!(py, line = line, distance = one.distance))
        };
        found.iter().map(ahead).collect()
    }

    /// Signals for traffic along a route, nearest first.
    fn signals_along<'py>(
        &self,
        py: Python<'py>,
        steps: &Bound<'py, PyAny>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (steps, mut found) = (steps_of(self.map(), steps)?, SignalsAhead::default());
        self.map().signals_along(&steps, &mut found).map_err(query)?;
        ahead_result(py, &self.0, &found)
    }

    /// The next change of lane on a route, seen from a place on its step number `at`; None if it needs no more.
    fn next_lane_change<'py>(
        &self,
        py: Python<'py>,
        steps: &Bound<'py, PyAny>,
        at: usize,
        place: &Bound<'py, PyAny>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let (steps, place) = (steps_of(self.map(), steps)?, place_of(self.map(), place)?);
        let next = next_lane_change(self.map(), &steps, at, place).map_err(query)?;
        let change = |one: mapd_client::route::LaneChangeAhead| {
            let side = if one.left { "left" } else { "right" };
            let fields =
                fields!(py, step = one.step, side = side, start = one.from, end = one.until);
            result(py, "LaneChangeAhead", &fields)
        };
        next.map(change).transpose()
    }

    /// As lane_sequences_ahead, of ways that lead to a place: each sequence begins with its lane and goes back against driving direction.
    #[pyo3(signature = (goal, distance, *, vehicle = "passengerCar"))]
    fn lane_sequences_behind(
        &self,
        py: Python<'_>,
        goal: &Bound<'_, PyAny>,
        distance: f64,
        vehicle: &str,
    ) -> PyResult<LaneSequences> {
        LaneSequences::new(py, &self.0, goal, distance, vehicle, false)
    }
}
