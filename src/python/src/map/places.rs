//! Points in the coordinates of lanes, and lanes at points.

use super::Map;
use crate::batch::{Positions, Speeds, answer, columns, in_row, nearest, position_fields, result};
use crate::errors::query;
use crate::held::content;
use crate::input::{Rows, column, finite, lane_of_id, one_point, places, types_of, vehicle_of};
use crate::lane::Lane;
use crate::room::{Column, Room};
use mapd_client::batch::Places;
use mapd_client::{Clamped, LanePosition, LaneTypes, Nearest, NearestOptions};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;

impl Map {
    pub(super) fn nearest_result<'py>(
        &self,
        py: Python<'py>,
        hit: &Nearest,
    ) -> PyResult<Bound<'py, PyAny>> {
        let fields = position_fields(py, &hit.position)?;
        fields.set_item("lane", Lane::new(&self.0, hit.lane.row()))?;
        result(py, "Nearest", &fields)
    }
}

/// What one call asks of all its points, but for the headings.
pub(super) fn options(
    radius: f64,
    types: Option<&Bound<'_, PyAny>>,
    z_tolerance: Option<f64>,
    heading_tolerance: Option<f64>,
    vehicle: Option<&str>,
) -> PyResult<NearestOptions> {
    let types = types.map_or(Ok(LaneTypes::ALL), types_of)?;
    Ok(NearestOptions {
        radius,
        types,
        vehicle: vehicle.map(vehicle_of).transpose()?,
        z_tolerance,
        heading_tolerance,
        ..NearestOptions::default()
    })
}

/// An answer as a hint, of which lane and s count; none of another map's.
fn hinted(map: mapd_client::Map<'_>, hint: &Bound<'_, PyAny>) -> PyResult<Option<Nearest>> {
    let (lane, s) = (hint.getattr("lane"), hint.getattr("s").and_then(|s| s.extract::<f64>()));
    let known = match (&lane, s) {
        (Ok(lane), Ok(s)) => lane.cast::<Lane>().ok().map(|lane| (lane.get().id(), s)),
        _ => None,
    };
    let Some((lane, s)) = known else {
        let expected = "hint: expected what nearest_lane returned for one point";
        return Err(PyTypeError::new_err(expected));
    };
    Ok(lane_of_id(map, lane).ok().map(|lane| Nearest {
        lane: lane.lane_id(),
        position: LanePosition {
            s,
            t: 0.0,
            offset: 0.0,
            offset_of_reference_line: 0.0,
            distance: 0.0,
            z: 0.0,
            heading: 0.0,
            heading_of_reference_line: 0.0,
            clamped: Clamped::No,
        },
    }))
}

/// A heading for each row, if any.
fn headings(
    heading: Option<&Bound<'_, PyAny>>,
    rows: usize,
    room: &mut Room,
) -> PyResult<Option<Vec<f64>>> {
    heading.map(|heading| column(heading, "heading", rows, room)).transpose()
}

#[pymethods]
impl Map {
    /// The lane whose area is nearest in plan view, at most `radius` [m] away; of several, by heading difference, height, offset.
    ///
    /// `types` are the lane types that count ("drivable", or OpenDRIVE's names). `z_tolerance` [m] tells levels apart and needs points
    /// with z; `heading` [rad] of travel breaks ties, and excludes places by `heading_tolerance` [rad]. Of a `vehicle` ("bicycle"), only places that it may use count.
    /// `hint` is an answer nearby, such as the last one: the search for one point begins there, and its answer is the same. A batch needs none.
    #[pyo3(signature = (points, *, radius = 10.0, types = None, z_tolerance = None, heading = None,
        heading_tolerance = None, vehicle = None, hint = None, out = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn nearest_lane<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        radius: f64,
        types: Option<&Bound<'py, PyAny>>,
        z_tolerance: Option<f64>,
        heading: Option<&Bound<'py, PyAny>>,
        heading_tolerance: Option<f64>,
        vehicle: Option<&str>,
        hint: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let mut options = options(radius, types, z_tolerance, heading_tolerance, vehicle)?;
        if let Some(point) = one_point(points, "points")? {
            options.heading = heading.map(|heading| heading.extract()).transpose()?;
            options.hint = hint.map_or(Ok(None), |hint| hinted(self.map(), hint))?;
            let hit = self.map().nearest_lane(point, &options).map_err(query)?;
            return hit.map(|hit| self.nearest_result(py, &hit)).transpose();
        }
        if hint.is_some() {
            return Err(PyValueError::new_err("a hint goes with one point, not with a batch"));
        }
        let mut room = Room::of(py, "NearestLanes", out)?;
        let points = Rows::of(points, "points", &[2, 3], &mut room)?;
        let headings = headings(heading, points.len(), &mut room)?;
        let found = answer(py, || {
            let (map, columns) = (self.map(), points.columns(&mut room));
            let places = Places { heading: headings.as_deref(), ..places(&columns) };
            let mut found = nearest(points.len(), &mut room);
            map.nearest_lanes(places, &options, &mut room.batch, &mut found).map_err(in_row)?;
            columns.into_iter().chain(headings).for_each(|column| room.give(column));
            points.give(&mut room);
            Ok(Positions::of(content(map), found, &mut room))
        })?;
        room.columns(py, "NearestLanes", found.columns(), out).map(Some)
    }

    /// Every lane within `radius` [m], nearest first; options as of nearest_lane.
    #[pyo3(signature = (points, *, radius = 10.0, types = None, z_tolerance = None, heading = None,
        heading_tolerance = None, vehicle = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn lanes_near<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        radius: f64,
        types: Option<&Bound<'py, PyAny>>,
        z_tolerance: Option<f64>,
        heading: Option<&Bound<'py, PyAny>>,
        heading_tolerance: Option<f64>,
        vehicle: Option<&str>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut options = options(radius, types, z_tolerance, heading_tolerance, vehicle)?;
        if let Some(point) = one_point(points, "points")? {
            options.heading = heading.map(|heading| heading.extract()).transpose()?;
            let mut near = Vec::new();
            self.map().lanes_near(point, &options, &mut near).map_err(query)?;
            let hits = near.iter().map(|hit| self.nearest_result(py, hit));
            let hits = hits.collect::<PyResult<Vec<_>>>()?;
            return Ok(pyo3::types::PyList::new(py, hits)?.into_any());
        }
        let mut room = Room::default();
        let points = Rows::of(points, "points", &[2, 3], &mut room)?;
        let headings = headings(heading, points.len(), &mut room)?;
        let (of, found) = answer(py, || {
            let map = self.map();
            let content = content(map);
            let mut of = Vec::new();
            let mut found = Positions::default();
            let mut near = Vec::new();
            for (row, point) in points.points().enumerate() {
                options.heading = headings.as_ref().map(|headings| headings[row]);
                map.lanes_near(point, &options, &mut near).map_err(|error| (row, error))?;
                for hit in &near {
                    of.push(row as i64);
                    found.push(content, hit.lane.row(), &hit.position);
                }
            }
            Ok((of, found))
        })?;
        let mut all = vec![Column::Counts(of)];
        all.extend(found.columns());
        columns(py, "LanesNear", all)
    }

    /// Each point in the coordinates of its lane.
    #[pyo3(signature = (lanes, points, *, out = None))]
    fn position_of<'py>(
        &self,
        py: Python<'py>,
        lanes: &Bound<'py, PyAny>,
        points: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut room = Room::of(py, "NearestLanes", out)?;
        let points = Rows::of(points, "points", &[2, 3], &mut room)?;
        let lanes = crate::input::ids(lanes, "lanes", Some(points.len()), &mut room)?;
        let found = answer(py, || {
            let map = self.map();
            let content = content(map);
            let mut found = Positions::with_room(points.len(), &mut room);
            for (row, (point, id)) in points.points().zip(&lanes).enumerate() {
                let lane = lane_of_id(map, *id).map_err(|error| (row, error))?;
                let at = lane.position_of(point).map_err(|error| (row, error))?;
                found.push(content, lane.lane_id().row(), &at);
            }
            points.give(&mut room);
            room.give(lanes);
            Ok(found)
        })?;
        room.columns(py, "NearestLanes", found.columns(), out)
    }

    /// Poses on lanes as their traffic has them, at s [m], `offset` [m] to the left of the lane's centre. Heading and curvature are those of the line that keeps this offset.
    #[pyo3(signature = (lanes, s, offset = None, *, out = None))]
    fn pose_at<'py>(
        &self,
        py: Python<'py>,
        lanes: &Bound<'py, PyAny>,
        s: &Bound<'py, PyAny>,
        offset: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut room = Room::of(py, "Poses", out)?;
        let lanes = crate::input::ids(lanes, "lanes", None, &mut room)?;
        let s = column(s, "s", lanes.len(), &mut room)?;
        let offset = offset.map(|offset| column(offset, "offset", lanes.len(), &mut room));
        let offset = offset.transpose()?;
        let found = answer(py, || {
            let map = self.map();
            let mut found = crate::batch::Poses::with_room(lanes.len(), &mut room);
            for (row, id) in lanes.iter().enumerate() {
                let lane = lane_of_id(map, *id).map_err(|error| (row, error))?;
                let offset = offset.as_ref().map_or(0.0, |offset| offset[row]);
                found.push(&lane.pose_at(s[row], offset).map_err(|error| (row, error))?);
            }
            room.give(lanes);
            [Some(s), offset].into_iter().flatten().for_each(|column| room.give(column));
            Ok(found)
        })?;
        room.columns(py, "Poses", found.columns(), out)
    }

    /// Speed limits on lanes at s [m], signs included.
    #[pyo3(signature = (lanes, s, *, out = None))]
    fn speed_rule_at<'py>(
        &self,
        py: Python<'py>,
        lanes: &Bound<'py, PyAny>,
        s: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut room = Room::of(py, "SpeedRules", out)?;
        let lanes = crate::input::ids(lanes, "lanes", None, &mut room)?;
        let s = column(s, "s", lanes.len(), &mut room)?;
        let found = answer(py, || {
            let mut found = Speeds::with_room(lanes.len(), &mut room);
            for (row, id) in lanes.iter().enumerate() {
                let lane = lane_of_id(self.map(), *id).map_err(|error| (row, error))?;
                let s = finite(s[row]).map_err(|error| (row, error))?;
                found.push(&lane.speed_rule_at(s));
            }
            room.give(lanes);
            room.give(s);
            Ok(found)
        })?;
        room.columns(py, "SpeedRules", found.columns(), out)
    }
}
