//! A lane in the graph, and what it shares with other parts.

use super::Lane;
use crate::batch::{fields, pose, result};
use crate::errors::query;
use crate::held::Held;
use crate::input::finite;
use crate::object::Object;
use crate::signal::Signal;
use mapd_client::objects::ObjectLane;
use pyo3::prelude::*;
use std::sync::Arc;

/// An object on a lane as Python has it; nothing of a damaged archive.
pub(crate) fn object_lane<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    one: &ObjectLane<'_>,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    let Some((object, lane)) = one.object().zip(one.lane()) else { return Ok(None) };
    let range = one.s_range();
    let fields = fields!(
        py,
        object = Object::new(held, object.object_id()),
        lane = Lane::new(held, lane.lane_id().row()),
        s_from = range.low,
        s_to = range.high,
        distance = one.distance(),
    );
    result(py, "ObjectLane", &fields).map(Some)
}

#[pymethods]
impl Lane {
    /// The centre line's exact place at s [m], with its own direction; s outside the lane's section is moved to its nearer end and flagged.
    fn waypoint_at<'py>(&self, py: Python<'py>, s: f64) -> PyResult<Bound<'py, PyAny>> {
        let at = self.lane()?.waypoint_at(s).map_err(query)?;
        let p = at.position;
        let fields = fields!(
            py,
            s = at.s,
            x = p.x,
            y = p.y,
            z = p.z,
            heading = at.heading,
            width = at.width,
            clamped = crate::batch::clamped_code(at.clamped),
        );
        result(py, "Waypoint", &fields)
    }

    /// As pose_at, in the road's frame: heading and curvature of the reference line, ahead towards +s, `offset` [m] to the left of that.
    #[pyo3(signature = (s, offset = 0.0))]
    fn pose_of_reference_line<'py>(
        &self,
        py: Python<'py>,
        s: f64,
        offset: f64,
    ) -> PyResult<Bound<'py, PyAny>> {
        pose(py, &self.lane()?.pose_of_reference_line(s, offset).map_err(query)?)
    }

    /// The limit [m/s] that lane or road record at s [m]; infinite where there is none, None where nothing is recorded. What holds may be another: speed_rule_at.
    fn recorded_speed_limit_at(&self, s: f64) -> PyResult<Option<f64>> {
        Ok(self.lane()?.recorded_speed_limit_at(finite(s).map_err(query)?))
    }

    /// What a route by time counts from one place to another [m]: at recorded limits, at 50 km/h where there is none [s].
    fn time_between(&self, s_from: f64, s_to: f64) -> PyResult<f64> {
        let [from, to] = [s_from, s_to].map(finite);
        Ok(self.lane()?.time_between(from.map_err(query)?, to.map_err(query)?))
    }

    /// Where its area meets those of other lanes of its junction.
    fn conflicts<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let one = |one: mapd_client::graph::Conflict<'_>| {
            let (own, other) = (one.s_range(), one.other_range());
            let fields = fields!(
                py,
                other = self.other(one.other()),
                kind = one.kind().name(),
                relation = one.relation().name(),
                reason = one.reason().name(),
                basis = one.basis().name(),
                s_from = own.low,
                s_to = own.high,
                other_from = other.low,
                other_to = other.high,
            );
            result(py, "LaneConflict", &fields)
        };
        self.lane()?.conflicts().map(one).collect()
    }

    /// The row among the nodes of Map.lane_graph that holds s [m], towards +s or not; of the lane's own direction where that is not said. None where it is not travelled so.
    #[pyo3(signature = (s, forward = None))]
    fn node_at(&self, s: f64, forward: Option<bool>) -> PyResult<Option<u32>> {
        let (lane, s) = (self.lane()?, finite(s).map_err(query)?);
        let node = lane.node_at(s, forward.unwrap_or_else(|| lane.is_forward()));
        Ok(node.map(|node| node.node_id().row()))
    }

    /// As objects, with where each is on the lane.
    fn objects_on<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let all = self.lane()?.objects();
        all.filter_map(|one| object_lane(py, &self.held, &one).transpose()).collect()
    }

    /// As movement_lights, with the lane before the junction on which each counts.
    fn movement_lights_on<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let one = |one: mapd_client::signals::LaneSignal<'_>| {
            let lane = one.lane()?;
            let fields = || {
                Ok(fields!(
                    py,
                    signal = Signal::new(&self.held, one.signal().signal_id()),
                    lane = Self::new(&self.held, lane.lane_id().row()),
                    s = one.s_on(&lane),
                    distance = one.distance(),
                ))
            };
            Some(fields().and_then(|fields| result(py, "LaneSignal", &fields)))
        };
        self.lane()?.movement_lights().filter_map(one).collect()
    }
}
