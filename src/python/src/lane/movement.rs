//! Through a junction on a lane: turn, lights, lines, right of way.

use super::Lane;
use crate::along::{line, turn_name};
use crate::batch::{fields, result};
use crate::input::rules_of;
use crate::signal::Signal;
use mapd_client::rules::LaneLine;
use mapd_client::signals::LaneSignal;
use mapd_client::vocabulary::Relation;
use pyo3::prelude::*;

impl Lane {
    fn lines<'py>(
        &self,
        py: Python<'py>,
        lines: impl Iterator<Item = LaneLine>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        lines.map(|one| line(py, &self.held, &one)).collect()
    }

    fn signals<'a>(&'a self, signals: impl Iterator<Item = LaneSignal<'a>>) -> Vec<Signal> {
        signals.map(|one| Signal::new(&self.held, one.signal().signal_id())).collect()
    }
}

#[pymethods]
impl Lane {
    /// Where the movement through this lane of a junction leads: "left", "straight", "right" or "back".
    #[getter]
    fn turn(&self) -> PyResult<&'static str> {
        Ok(turn_name(self.lane()?.turn()))
    }

    /// Lanes from which the junction is entered on the way through this one.
    fn entries(&self) -> PyResult<Vec<Self>> {
        Ok(self.others(self.lane()?.entries().map(|lane| lane.lane_id())))
    }

    /// Lanes of the junction that the movement through this one goes over, first to last; itself where it is in no junction.
    fn movement_lanes(&self) -> PyResult<Vec<Self>> {
        Ok(self.others(self.lane()?.movement_lanes().map(|lane| lane.lane_id())))
    }

    /// Who goes first where this lane of a junction meets others, by what the file says; where that says nothing, by the rules of a `country` ("DE"), if it is named.
    ///
    /// That these hold there is for the caller to know.
    #[pyo3(signature = (country = None))]
    fn right_of_way<'py>(
        &self,
        py: Python<'py>,
        country: Option<&str>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let rules = rules_of(country)?;
        let ways = self.lane()?.right_of_way().map(|one| {
            let (relation, basis) = match rules {
                Some(rules) => {
                    (one.relation_by(rules).unwrap_or(Relation::Unknown), one.basis_by(rules))
                }
                None => (one.relation(), one.basis()),
            };
            let fields = fields!(
                py,
                other = self.other(one.other()),
                relation = relation.name(),
                reason = one.reason().name(),
                basis = basis.name(),
            );
            result(py, "RightOfWay", &fields)
        });
        ways.collect()
    }

    /// Lanes to which this lane of a junction gives way by what the file says; such as are closed to every vehicle are left out.
    fn yields_to(&self) -> PyResult<Vec<Self>> {
        Ok(self.others(self.lane()?.yields_to().map(|one| one.lane.lane_id())))
    }

    /// Lights for the traffic of this lane.
    fn traffic_lights(&self) -> PyResult<Vec<Signal>> {
        Ok(self.signals(self.lane()?.traffic_lights()))
    }

    /// Lights that govern the movement through this lane of a junction.
    fn movement_lights(&self) -> PyResult<Vec<Signal>> {
        Ok(self.signals(self.lane()?.movement_lights()))
    }

    /// Where the movement through this lane of a junction stops: at the marked line nearest to the junction, up to 30 m before it.
    ///
    /// Without one at its light; under a stop or yield sign without marking at the last place before the movement meets another lane, or where it
    /// enters the junction. None where none of these is known.
    fn movement_stop<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.lane()?.movement_stop().map(|one| line(py, &self.held, &one)).transpose()
    }

    /// Crosswalks and bicycle crossings that the movement through this lane passes: up to 30 m before it, on its own lanes, and up to 30 m behind it.
    fn movement_crossings<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.lines(py, self.lane()?.movement_crossings())
    }

    /// Lines at which the lane's traffic stops or gives way: signals first, then objects.
    fn lines_to_stop_at<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.lines(py, self.lane()?.lines_to_stop_at())
    }

    /// Crosswalks and bicycle crossings over the lane: signals first, then objects.
    fn crossings<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.lines(py, self.lane()?.crossings())
    }
}
