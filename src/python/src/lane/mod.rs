//! Lanes, and many lanes' lines at once.

mod graph;
mod movement;
mod shape;

use crate::batch::{
    columns, fields, overtaking_rule, pose, position_fields, result, speed_rule, triples,
};
use crate::errors::query;
use crate::held::{Held, content, id};
use crate::input::{one_point, vehicle_of};
use crate::road::Road;
use crate::room::Column;
pub(crate) use graph::object_lane;
use mapd_client::compiling::ByRow as _;
use mapd_client::roads::{LinePoint, Polyline};
use mapd_client::{LaneTypes, QueryError, Region};
use numpy::IntoPyArray;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use std::sync::Arc;

/// A lane. Left, right and ahead are those of its traffic. Equal lanes are those of one content.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct Lane {
    held: Arc<Held>,
    row: u32,
}

impl Lane {
    pub(crate) fn new(held: &Arc<Held>, row: u32) -> Self {
        Self { held: Arc::clone(held), row }
    }

    fn lane(&self) -> PyResult<mapd_client::Lane<'_>> {
        self.held.map().lane_by_row(self.row).ok_or_else(|| query(QueryError::Corrupt))
    }

    fn others(&self, ids: impl Iterator<Item = mapd_client::LaneId>) -> Vec<Self> {
        ids.map(|id| Self::new(&self.held, id.row())).collect()
    }

    fn other(&self, lane: Option<mapd_client::Lane<'_>>) -> Option<Self> {
        lane.map(|lane| Self::new(&self.held, lane.lane_id().row()))
    }

    fn line<'py>(
        &self,
        py: Python<'py>,
        line: impl Fn(&mapd_client::Lane<'_>) -> Vec<f64>,
    ) -> PyResult<Bound<'py, PyAny>> {
        triples(py, line(&self.lane()?))
    }
}

/// x, y, z of a line's points.
fn flat(line: Polyline<'_>) -> Vec<f64> {
    line.positions().flat_map(|p| [p.x, p.y, p.z]).collect()
}

#[pymethods]
impl Lane {
    /// What columns name it by; bound to the map's content. What may be stored is the key.
    #[getter]
    pub(crate) fn id(&self) -> u64 {
        id(content(self.held.map()), self.row)
    }

    /// Stable name, road:section:lane.
    #[getter]
    fn key(&self) -> PyResult<String> {
        Ok(self.lane()?.key().to_string())
    }

    /// OpenDRIVE's number: positive left of lane 0.
    #[getter]
    fn number(&self) -> PyResult<i32> {
        Ok(self.lane()?.number())
    }

    /// Lane type in the words of OpenDRIVE.
    #[getter]
    fn kind(&self) -> PyResult<&'static str> {
        Ok(self.lane()?.kind().name())
    }

    /// Its road.
    #[getter]
    fn road(&self) -> PyResult<Road> {
        Ok(Road::new(&self.held, self.lane()?.road().road_id().row()))
    }

    /// Number of its section in the road, from 0.
    #[getter]
    fn section(&self) -> PyResult<u32> {
        Ok(self.lane()?.section().number())
    }

    /// Both ends of its section on the road [m].
    #[getter]
    fn s_range(&self) -> PyResult<(f64, f64)> {
        let section = self.lane()?.section();
        Ok((section.s_start(), section.s_end()))
    }

    /// Of the centre line in plan view [m].
    #[getter]
    fn length(&self) -> PyResult<f64> {
        let (from, to) = self.s_range()?;
        Ok(self.lane()?.length_between(from, to))
    }

    /// Whether its traffic goes towards +s.
    #[getter]
    fn is_forward(&self) -> PyResult<bool> {
        Ok(self.lane()?.is_forward())
    }

    /// Whether it may be travelled both ways.
    #[getter]
    fn is_bidirectional(&self) -> PyResult<bool> {
        Ok(self.lane()?.is_bidirectional())
    }

    /// Lanes entered from this one.
    fn successors(&self) -> PyResult<Vec<Self>> {
        Ok(self.others(self.lane()?.successors()))
    }

    /// Lanes from which this one is entered.
    fn predecessors(&self) -> PyResult<Vec<Self>> {
        Ok(self.others(self.lane()?.predecessors()))
    }

    /// The next lane to the left, whichever way it is travelled.
    fn left(&self) -> PyResult<Option<Self>> {
        Ok(self.other(self.lane()?.left()))
    }

    /// The next lane to the right, whichever way it is travelled.
    fn right(&self) -> PyResult<Option<Self>> {
        Ok(self.other(self.lane()?.right()))
    }

    /// The nearest lane beside it that is travelled the other way.
    fn opposite(&self) -> PyResult<Option<Self>> {
        Ok(self.other(self.lane()?.opposite()))
    }

    /// Width at s [m].
    fn width_at(&self, s: f64) -> PyResult<f64> {
        Ok(self.lane()?.width_at(s))
    }

    /// Speed limit at s, signs included, and who says so.
    fn speed_rule_at<'py>(&self, py: Python<'py>, s: f64) -> PyResult<Bound<'py, PyAny>> {
        let rule = self.lane()?.speed_rule_at(crate::input::finite(s).map_err(query)?);
        speed_rule(py, &self.held, &rule)
    }

    /// The speed limits along it, in ascending s without gaps.
    fn speed_rules<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let one = |own: mapd_client::rules::SpeedStretch| {
            let rule = speed_rule(py, &self.held, &own.rule)?;
            let fields = fields!(
                py,
                s_from = own.s.low,
                s_to = own.s.high,
                rule = rule,
                lowest = own.lowest
            );
            result(py, "SpeedStretch", &fields)
        };
        self.lane()?.speed_rules().map(one).collect()
    }

    /// The signs that forbid overtaking at s [m].
    fn overtaking_rule_at<'py>(&self, py: Python<'py>, s: f64) -> PyResult<Bound<'py, PyAny>> {
        let rule = self.lane()?.overtaking_rule_at(crate::input::finite(s).map_err(query)?);
        overtaking_rule(py, &self.held, &rule)
    }

    /// Whether a class of vehicles may use it at s.
    #[pyo3(signature = (s, vehicle = "passengerCar"))]
    fn allows_at(&self, s: f64, vehicle: &str) -> PyResult<bool> {
        Ok(self.lane()?.allows_at(s, vehicle_of(vehicle)?))
    }

    /// Pose at s [m] as its traffic has it, `offset` [m] to the left of its centre. Heading and curvature are those of the line that keeps this offset.
    #[pyo3(signature = (s, offset = 0.0))]
    fn pose_at<'py>(&self, py: Python<'py>, s: f64, offset: f64) -> PyResult<Bound<'py, PyAny>> {
        pose(py, &self.lane()?.pose_at(s, offset).map_err(query)?)
    }

    /// A point in its coordinates.
    fn position_of<'py>(
        &self,
        py: Python<'py>,
        point: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let point = one_point(point, "point")?
            .ok_or_else(|| PyTypeError::new_err("point: expected a tuple (x, y) or (x, y, z)"))?;
        let at = self.lane()?.position_of(point).map_err(query)?;
        let fields = position_fields(py, &at)?;
        result(py, "LanePosition", &fields)
    }

    /// Centre line (M, 3) in ascending s [m].
    fn center_line<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.line(py, |lane| flat(lane.center_line()))
    }

    /// Left border (M, 3) in ascending s [m].
    fn left_bound<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.line(py, |lane| flat(lane.left_bound()))
    }

    /// Right border (M, 3) in ascending s [m].
    fn right_bound<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.line(py, |lane| flat(lane.right_bound()))
    }

    /// Places on the centre line in driving direction, `step` [m] of s apart.
    fn waypoints<'py>(&self, py: Python<'py>, step: f64) -> PyResult<Bound<'py, PyAny>> {
        let mut numbers: [Vec<f64>; 6] = Default::default();
        for waypoint in self.lane()?.waypoints(step).map_err(query)? {
            let at = waypoint.map_err(query)?;
            let p = at.position;
            let values = [at.s, p.x, p.y, p.z, at.heading, at.width];
            numbers.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        }
        columns(py, "Waypoints", numbers.into_iter().map(Column::Numbers).collect())
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get().id() == self.id())
    }

    fn __hash__(&self) -> u64 {
        self.id()
    }

    fn _repr_html_<'py>(this: Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        this.py().import("mapd._pictures")?.call_method1("lane_html", (this,))
    }

    fn __repr__(&self) -> PyResult<String> {
        let (lane, (from, to)) = (self.lane()?, self.s_range()?);
        Ok(format!("<mapd.Lane {} {} s {from:.2} to {to:.2} m>", lane.key(), lane.kind().name()))
    }
}

/// Which line of a lane.
#[derive(Clone, Copy)]
pub(crate) enum Line {
    Center,
    Left,
    Right,
}

impl Line {
    pub(crate) fn named(name: &str) -> PyResult<Self> {
        match name {
            "center" => Ok(Self::Center),
            "left" => Ok(Self::Left),
            "right" => Ok(Self::Right),
            _ => Err(PyValueError::new_err(format!(
                "which: expected \"center\", \"left\" or \"right\", found {name:?}"
            ))),
        }
    }
}

/// One line of each of many lanes, decoded at once.
pub(crate) fn lines<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    region: Option<Region>,
    types: LaneTypes,
    which: Line,
) -> PyResult<Bound<'py, PyAny>> {
    let decoded = py.detach(|| {
        let map = held.map();
        let content = content(map);
        let rows: Vec<u32> = match region {
            None => {
                let lanes = map.lanes().filter(|lane| types.contains(lane.kind()));
                lanes.map(|lane| lane.lane_id().row()).collect()
            }
            Some(region) => {
                let mut found = Vec::new();
                map.lanes_in(region, types, &mut found)?;
                found.iter().map(|id| id.row()).collect()
            }
        };
        let (mut points, mut stations) = (Vec::new(), Vec::new());
        let (mut offsets, mut lanes) = (vec![0i64], Vec::with_capacity(rows.len()));
        for row in rows {
            let Some(lane) = map.lane_by_row(row) else { return Err(QueryError::Corrupt) };
            let line = match which {
                Line::Center => lane.center_line(),
                Line::Left => lane.left_bound(),
                Line::Right => lane.right_bound(),
            };
            for LinePoint { s, position: p } in line.points() {
                stations.push(s);
                points.extend([p.x, p.y, p.z]);
            }
            offsets.push(stations.len() as i64);
            lanes.push(id(content, row));
        }
        Ok((points, stations, offsets, lanes))
    });
    let (points, stations, offsets, lanes) = decoded.map_err(query)?;
    let fields = fields!(
        py,
        points = triples(py, points)?,
        s = stations.into_pyarray(py),
        offsets = offsets.into_pyarray(py),
        lane = lanes.into_pyarray(py),
    );
    result(py, "Lines", &fields)
}
