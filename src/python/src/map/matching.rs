//! The lanes that poses and traces are in.

use super::Map;
use crate::input::{types_of, vehicle_of};
use mapd_client::LaneTypes;
use mapd_client::localisation::{MatchOptions, TraceOptions};
use pyo3::prelude::*;

#[pymethods]
impl Map {
    /// The lanes that vehicles may be in, and the probability that they are in none (docs/localisation.md).
    ///
    /// `heading` [rad]; `covariance` of (x, y, heading) [m^2, m rad, rad^2], one (3, 3) for all or (N, 3, 3). `drive_deviation` [rad] is
    /// how drivers deviate from their lane's direction, `none` the prior of no lane; `closed` and `unexpected` are the shares of the
    /// prior that lanes have which `vehicle` may not use, and which are not among `expected`. With `outline`, how far the vehicle reaches
    /// ahead, back, left and right of the point [m], a lane counts by the share of the vehicle that lies in it.
    #[pyo3(signature = (points, heading, covariance, *, types = None, z_tolerance = None,
        drive_deviation = 0.1, none = 0.01, vehicle = None, closed = 0.05, expected = None, unexpected = 0.05,
        outline = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn match_pose<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        heading: &Bound<'py, PyAny>,
        covariance: &Bound<'py, PyAny>,
        types: Option<&Bound<'py, PyAny>>,
        z_tolerance: Option<f64>,
        drive_deviation: f64,
        none: f64,
        vehicle: Option<&str>,
        closed: f64,
        expected: Option<Vec<Bound<'py, PyAny>>>,
        unexpected: f64,
        outline: Option<[f64; 4]>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let expected = crate::input::lanes_of(self.map(), expected.as_deref())?;
        let options = MatchOptions {
            types: types.map_or(Ok(LaneTypes::ALL), types_of)?,
            z_tolerance,
            drive_deviation,
            none,
            vehicle: vehicle.map(vehicle_of).transpose()?,
            closed,
            expected: &expected,
            unexpected,
            outline: outline.map(crate::matching::outline),
        };
        let map = self.map();
        crate::matching::match_pose(py, &self.0, points, heading, covariance, |pose, own, out| {
            map.match_pose(pose, own, &options, out)
        })
    }

    /// The most probable way through a trace, a place for each fix.
    ///
    /// `time` [s] does not fall; `heading` [rad] is NaN where it is not known; `deviation` [m] is that of x and y, `heading_deviation` [rad] that of headings, `change_interval` [s]
    /// the mean time between changes of lane.
    #[pyo3(signature = (time, points, *, heading = None, deviation = 1.0, heading_deviation = 0.1,
        change_interval = 30.0, vehicle = "passengerCar", types = None, out = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn match_trace<'py>(
        &self,
        py: Python<'py>,
        time: &Bound<'py, PyAny>,
        points: &Bound<'py, PyAny>,
        heading: Option<&Bound<'py, PyAny>>,
        deviation: f64,
        heading_deviation: f64,
        change_interval: f64,
        vehicle: &str,
        types: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let options = TraceOptions {
            deviation,
            heading_deviation,
            vehicle: vehicle_of(vehicle)?,
            change_interval,
            types: types.map_or(Ok(LaneTypes::routable()), types_of)?,
        };
        crate::matching::match_trace(py, &self.0, time, points, heading, &options, out)
    }
}
