//! Points on Earth.

use super::Map;
use crate::batch::columns;
use crate::errors::{query, raise};
use crate::input::Rows;
use crate::room::{Column, Room};
use mapd_client::geodesy::{EnuFrame, Geodetic, GeodeticError, GeodeticPoint, Projector};
use mapd_client::glam::DVec3;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

#[pymethods]
impl Map {
    /// As nearest_lane, from latitude, longitude [deg] and, if given, altitude [m] on WGS 84.
    #[pyo3(signature = (place, *, radius = 10.0, types = None, z_tolerance = None, heading = None,
        heading_tolerance = None, vehicle = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn nearest_lane_geodetic<'py>(
        &self,
        py: Python<'py>,
        place: &Bound<'py, PyAny>,
        radius: f64,
        types: Option<&Bound<'py, PyAny>>,
        z_tolerance: Option<f64>,
        heading: Option<f64>,
        heading_tolerance: Option<f64>,
        vehicle: Option<&str>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let mut options =
            super::places::options(radius, types, z_tolerance, heading_tolerance, vehicle)?;
        options.heading = heading;
        let numbers = crate::input::one(place, "place", &[2, 3])?
            .ok_or_else(|| PyTypeError::new_err("place: expected a tuple of 2 or 3 numbers"))?;
        let at = GeodeticPoint {
            latitude: numbers[0],
            longitude: numbers[1],
            altitude: numbers.get(2).copied(),
        };
        let projector = self.map().projector();
        let projector = projector.map_err(|error| raise("ProjectionError", error.to_string()))?;
        let hit = self.map().nearest_lane_geodetic(&projector, at, &options);
        let hit = hit.map_err(|error| match error {
            GeodeticError::Query(error) => query(error),
            error => raise("ProjectionError", error.to_string()),
        })?;
        hit.map(|hit| self.nearest_result(py, &hit)).transpose()
    }

    /// Latitude and longitude [deg] and altitude [m] on WGS 84.
    fn to_geodetic<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let projector = self.map().projector();
        let projector = projector.map_err(|error| raise("ProjectionError", error.to_string()))?;
        let ask = |p: &[f64]| {
            let z = p.get(2).copied().unwrap_or(0.0);
            let place = projector.to_geodetic(DVec3::new(p[0], p[1], z));
            place.map(|place| [place.latitude, place.longitude, place.altitude])
        };
        converted(py, points, "points", "Geodetics", ask)
    }

    /// Inertial points [m] of latitude, longitude [deg] and, if given, altitude [m] on WGS 84.
    #[expect(clippy::wrong_self_convention, reason = "as the projector's, which it stands for")]
    fn from_geodetic<'py>(
        &self,
        py: Python<'py>,
        places: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let projector = self.map().projector();
        let projector = projector.map_err(|error| raise("ProjectionError", error.to_string()))?;
        let ask = |p: &[f64]| {
            let altitude = p.get(2).copied().unwrap_or(0.0);
            let point =
                projector.from_geodetic(Geodetic { latitude: p[0], longitude: p[1], altitude });
            point.map(|point| [point.x, point.y, point.z])
        };
        converted(py, places, "places", "Inertials", ask)
    }

    /// Heading of true north [rad] at a point, or at each of many, counter-clockwise from x.
    ///
    /// A heading that a receiver gives clockwise from true north is this minus that one.
    fn north_at<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let projector = self.projector()?;
        let ask = |p: &[f64]| projector.north_at(place_of(p)).map(|north| [north]);
        let [found] = match rows_of(py, points, "points", ask)? {
            Converted::One([one]) => return Ok(one.into_pyobject(py)?.into_any()),
            Converted::Many(columns) => columns,
        };
        Ok(numpy::PyArray1::from_vec(py, found).into_any())
    }

    /// East, north and up [m] of points, from `origin`, a point of the map: the topocentric frame, in the plane that touches the Earth there.
    fn to_enu<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        origin: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let projector = self.projector()?;
        let frame = frame_at(&projector, origin)?;
        let ask = |p: &[f64]| frame.to_enu(place_of(p)).map(|place| place.to_array());
        converted(py, points, "points", "Inertials", ask)
    }

    /// Inertial points [m] of easts, norths and, if given, ups [m] from `origin`, a point of the map.
    #[expect(clippy::wrong_self_convention, reason = "as the projector's, which it stands for")]
    fn from_enu<'py>(
        &self,
        py: Python<'py>,
        places: &Bound<'py, PyAny>,
        origin: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let projector = self.projector()?;
        let frame = frame_at(&projector, origin)?;
        let ask = |p: &[f64]| frame.from_enu(place_of(p)).map(|point| point.to_array());
        converted(py, places, "places", "Inertials", ask)
    }
}

impl Map {
    fn projector(&self) -> PyResult<Projector> {
        let projector = self.map().projector();
        projector.map_err(|error| raise("ProjectionError", error.to_string()))
    }
}

fn place_of(p: &[f64]) -> DVec3 {
    DVec3::new(p[0], p[1], p.get(2).copied().unwrap_or(0.0))
}

fn frame_at<'a>(projector: &'a Projector, origin: &Bound<'_, PyAny>) -> PyResult<EnuFrame<'a>> {
    let numbers = crate::input::one(origin, "origin", &[2, 3])?
        .ok_or_else(|| PyTypeError::new_err("origin: expected a tuple of 2 or 3 numbers"))?;
    let frame = projector.enu_at(place_of(&numbers));
    frame.map_err(|error| raise("ProjectionError", format!("origin: {error}")))
}

/// An answer for a row, or a column for each number of all rows' answers.
enum Converted<const N: usize> {
    One([f64; N]),
    Many([Vec<f64>; N]),
}

/// Three numbers for each row of two or three.
fn converted<'py>(
    py: Python<'py>,
    what: &Bound<'py, PyAny>,
    name: &str,
    class: &str,
    ask: impl Fn(&[f64]) -> Result<[f64; 3], mapd_client::geodesy::ProjectionError> + Sync,
) -> PyResult<Bound<'py, PyAny>> {
    match rows_of(py, what, name, ask)? {
        Converted::One(one) => Ok(pyo3::types::PyTuple::new(py, one)?.into_any()),
        Converted::Many(found) => {
            columns(py, class, found.into_iter().map(Column::Numbers).collect())
        }
    }
}

/// Numbers for each row of two or three.
fn rows_of<const N: usize>(
    py: Python<'_>,
    what: &Bound<'_, PyAny>,
    name: &str,
    ask: impl Fn(&[f64]) -> Result<[f64; N], mapd_client::geodesy::ProjectionError> + Sync,
) -> PyResult<Converted<N>> {
    let said = |row: usize, error: mapd_client::geodesy::ProjectionError| {
        raise("ProjectionError", format!("row {row}: {error}"))
    };
    if let Some(one) = crate::input::one(what, name, &[2, 3])? {
        return Ok(Converted::One(ask(&one).map_err(|error| said(0, error))?));
    }
    let rows = Rows::of(what, name, &[2, 3], &mut Room::default())?;
    let found = py.detach(|| {
        let mut found: [Vec<f64>; N] = std::array::from_fn(|_| Vec::with_capacity(rows.len()));
        for (row, one) in rows.rows().enumerate() {
            let values = ask(one).map_err(|error| (row, error))?;
            found.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        }
        Ok(found)
    });
    Ok(Converted::Many(found.map_err(|(row, error)| said(row, error))?))
}
