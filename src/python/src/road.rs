//! Roads and their track coordinates.

use crate::batch::{
    answer, clamped_code, feet, fields, in_row, material, pose, pose_columns, poses, result,
    track_columns,
};
use crate::errors::query;
use crate::held::{Held, content, id};
use crate::input::{Rows, one, one_point, places};
use crate::lane::Lane;
use crate::room::Room;
use mapd_client::batch::Tracks;
use mapd_client::compiling::ByRow as _;
use mapd_client::{QueryError, Track};
use pyo3::prelude::*;
use std::sync::Arc;

/// A road.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct Road {
    held: Arc<Held>,
    row: u32,
}

impl Road {
    pub(crate) fn new(held: &Arc<Held>, row: u32) -> Self {
        Self { held: Arc::clone(held), row }
    }

    fn road(&self) -> PyResult<mapd_client::Road<'_>> {
        self.held.map().road_by_row(self.row).ok_or_else(|| query(QueryError::Corrupt))
    }
}

fn track(row: &[f64]) -> Track {
    Track { s: row[0], t: row[1], h: row.get(2).copied().unwrap_or(0.0) }
}

#[pymethods]
impl Road {
    /// OpenDRIVE's id.
    #[getter]
    fn id(&self) -> PyResult<&str> {
        Ok(self.road()?.id())
    }

    /// OpenDRIVE's name.
    #[getter]
    fn name(&self) -> PyResult<&str> {
        Ok(self.road()?.name())
    }

    /// Of the reference line as written [m].
    #[getter]
    fn length(&self) -> PyResult<f64> {
        Ok(self.road()?.length())
    }

    /// Whether traffic keeps to the left.
    #[getter]
    fn is_left_hand_traffic(&self) -> PyResult<bool> {
        Ok(self.road()?.is_left_hand_traffic())
    }

    /// Id of the junction that it is a connecting road of.
    #[getter]
    fn junction(&self) -> PyResult<Option<&str>> {
        Ok(self.road()?.junction().map(|junction| junction.id()))
    }

    /// Lanes of all sections, by s and from left to right; with `center` also lane 0 of each, which has no area.
    #[pyo3(signature = (*, center = false))]
    fn lanes(&self, center: bool) -> PyResult<Vec<Lane>> {
        let road = self.road()?;
        let lanes = road.sections().flat_map(|section| section.lanes());
        let lanes = lanes.filter(|lane| center || lane.number() != 0);
        Ok(lanes.map(|lane| Lane::new(&self.held, lane.lane_id().row())).collect())
    }

    /// Elevation of the reference line at s [m].
    fn elevation_at(&self, s: f64) -> PyResult<f64> {
        Ok(self.road()?.elevation_at(s))
    }

    /// Superelevation at s [rad]; positive lifts the left side.
    fn superelevation_at(&self, s: f64) -> PyResult<f64> {
        Ok(self.road()?.superelevation_at(s))
    }

    /// Lane offset at s [m]; positive to the left.
    fn lane_offset_at(&self, s: f64) -> PyResult<f64> {
        Ok(self.road()?.lane_offset_at(s))
    }

    /// The surface at (s, t) [m]; s beyond the reference line is moved to its end and flagged. Beside all lanes the lateral profiles go on.
    fn surface_at<'py>(&self, py: Python<'py>, s: f64, t: f64) -> PyResult<Bound<'py, PyAny>> {
        let at = self.road()?.surface_at(s, t).map_err(query)?;
        let (p, normal) = (at.position, at.normal);
        let fields = fields!(
            py,
            x = p.x,
            y = p.y,
            z = p.z,
            nx = normal.x,
            ny = normal.y,
            nz = normal.z,
            lane = at.lane.map(|lane| Lane::new(&self.held, lane.row())),
            material = material(py, at.material)?,
            clamped = clamped_code(at.clamped),
        );
        result(py, "Surface", &fields)
    }

    /// The lane that covers (s, t); None beside all lanes.
    fn lane_at(&self, s: f64, t: f64) -> PyResult<Option<Lane>> {
        let section = self.road()?.section_at(s);
        let lane = section.and_then(|section| section.lane_at(s, t));
        Ok(lane.map(|lane| Lane::new(&self.held, lane.lane_id().row())))
    }

    /// Poses of track coordinates s, t and, if given, h [m].
    #[pyo3(signature = (tracks, *, out = None))]
    fn to_inertial<'py>(
        &self,
        py: Python<'py>,
        tracks: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let road = self.road()?;
        if let Some(numbers) = one(tracks, "tracks", &[2, 3])? {
            return pose(py, &road.to_inertial(track(&numbers)).map_err(query)?);
        }
        let mut room = Room::of(py, "Poses", out)?;
        let tracks = Rows::of(tracks, "tracks", &[2, 3], &mut room)?;
        let found = answer(py, || {
            let columns = tracks.columns(&mut room);
            let mut found = poses(tracks.len(), &mut room);
            let column = |k: usize| columns.get(k).map(Vec::as_slice);
            let [s, t] = [column(0), column(1)].map(Option::unwrap_or_default);
            road.to_inertial_batch(Tracks { s, t, h: column(2) }, &mut found).map_err(in_row)?;
            columns.into_iter().for_each(|column| room.give(column));
            tracks.give(&mut room);
            Ok(pose_columns(found, &mut room))
        })?;
        room.columns(py, "Poses", found, out)
    }

    /// Feet of points on the reference line.
    #[pyo3(signature = (points, *, out = None))]
    fn to_track<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let road = self.road()?;
        if let Some(point) = one_point(points, "points")? {
            let at = road.to_track(point).map_err(query)?;
            let fields = fields!(
                py,
                s = at.s,
                t = at.t,
                h = at.h,
                distance = at.distance,
                clamped = clamped_code(at.clamped),
                exact = at.exact,
            );
            return result(py, "TrackPosition", &fields);
        }
        let mut room = Room::of(py, "Tracks", out)?;
        let points = Rows::of(points, "points", &[2, 3], &mut room)?;
        let found = answer(py, || {
            let columns = points.columns(&mut room);
            let mut found = feet(points.len(), &mut room);
            road.to_track_batch(places(&columns), &mut found).map_err(in_row)?;
            columns.into_iter().for_each(|column| room.give(column));
            points.give(&mut room);
            Ok(track_columns(found, &mut room))
        })?;
        room.columns(py, "Tracks", found, out)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        let own = |road: &Self| id(content(road.held.map()), road.row);
        other.cast::<Self>().is_ok_and(|other| own(other.get()) == own(self))
    }

    fn __hash__(&self) -> u64 {
        id(content(self.held.map()), self.row)
    }

    fn _repr_html_<'py>(this: Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        this.py().import("mapd._pictures")?.call_method1("road_html", (this,))
    }

    fn __repr__(&self) -> PyResult<String> {
        let road = self.road()?;
        let name =
            if road.name().is_empty() { String::new() } else { format!(" {:?}", road.name()) };
        Ok(format!("<mapd.Road {}{name} {:.2} m>", road.id(), road.length()))
    }
}
