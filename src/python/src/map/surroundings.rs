//! What is around a place: ground, marks, lanes, signals, objects, landmarks.

use super::Map;
use crate::errors::query;
use crate::input::{classes_of, region_of, types_of};
use crate::lane::{self, Lane};
use crate::object::Object;
use crate::signal::Signal;
use mapd_client::LaneTypes;
use mapd_client::glam::DVec2;
use mapd_client::localisation::{MarkFilter, Sensor};
use pyo3::prelude::*;

#[pymethods]
impl Map {
    /// The surface below points [m], on the level whose height is nearest to z; on the lowest one of points without z, with `expected` on the lowest that has one of these lanes.
    ///
    /// Heights more than 2 m apart are levels of their own. Nothing beside all lanes.
    #[pyo3(signature = (points, *, expected = None, out = None))]
    fn ground_at<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        expected: Option<Vec<Bound<'py, PyAny>>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let expected = crate::input::lanes_of(self.map(), expected.as_deref())?;
        crate::ground::ground_at(py, &self.0, points, &expected, out)
    }

    /// The nearest road mark on its exact course, at most `radius` [m] away; lines count along their whole length, gaps included.
    ///
    /// `kinds` are the kinds that count, `types` the types of the lanes beside them.
    #[pyo3(signature = (points, *, radius = 5.0, kinds = None, types = None, out = None))]
    fn nearest_mark<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        radius: f64,
        kinds: Option<Vec<String>>,
        types: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let filter = crate::ground::filter(radius, kinds, types)?;
        crate::ground::nearest_mark(py, &self.0, points, &filter, out)
    }

    /// Lanes whose area meets a rectangle (x_min, y_min, x_max, y_max) [m].
    #[pyo3(signature = (region, *, types = None))]
    fn lanes_in(&self, region: [f64; 4], types: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<Lane>> {
        let types = types.map_or(Ok(LaneTypes::ALL), types_of)?;
        let mut found = Vec::new();
        self.map().lanes_in(region_of(region), types, &mut found).map_err(query)?;
        Ok(found.iter().map(|id| Lane::new(&self.0, id.row())).collect())
    }

    /// Signals within a radius [m] with their distances [m], nearest first.
    fn signals_near(&self, point: (f64, f64), radius: f64) -> PyResult<Vec<(Signal, f64)>> {
        let mut found = Vec::new();
        let point = DVec2::new(point.0, point.1);
        self.map().signals_near(point, radius, &mut found).map_err(query)?;
        Ok(found.iter().map(|near| (Signal::new(&self.0, near.signal), near.distance)).collect())
    }

    /// Objects whose area comes within a radius [m], with their distances [m], nearest first; once for each of their places.
    fn objects_near(&self, point: (f64, f64), radius: f64) -> PyResult<Vec<(Object, f64)>> {
        let mut found = Vec::new();
        let point = DVec2::new(point.0, point.1);
        self.map().objects_near(point, radius, &mut found).map_err(query)?;
        let object =
            |near: &mapd_client::objects::NearObject| Object::new(&self.0, near.place.object);
        Ok(found.iter().map(|near| (object(near), near.distance)).collect())
    }

    /// Signals that stand in a rectangle (x_min, y_min, x_max, y_max) [m].
    fn signals_in(&self, region: [f64; 4]) -> PyResult<Vec<Signal>> {
        let mut found = Vec::new();
        self.map().signals_in(region_of(region), &mut found).map_err(query)?;
        Ok(found.iter().map(|id| Signal::new(&self.0, *id)).collect())
    }

    /// Objects whose area meets a rectangle (x_min, y_min, x_max, y_max) [m]; once for each of their places.
    fn objects_in(&self, region: [f64; 4]) -> PyResult<Vec<Object>> {
        let mut found = Vec::new();
        self.map().objects_in(region_of(region), &mut found).map_err(query)?;
        Ok(found.iter().map(|place| Object::new(&self.0, place.object)).collect())
    }

    /// Centre lines, or left or right bounds, of all lanes, or of those in a rectangle, decoded at once.
    #[pyo3(signature = (region = None, *, types = None, which = "center"))]
    fn lines<'py>(
        &self,
        py: Python<'py>,
        region: Option<[f64; 4]>,
        types: Option<&Bound<'py, PyAny>>,
        which: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        let types = types.map_or(Ok(LaneTypes::ALL), types_of)?;
        lane::lines(py, &self.0, region.map(region_of), types, lane::Line::named(which)?)
    }

    /// Signals and objects that localisers find again, or those of these `classes` ("pole"), within a radius [m], nearest first.
    #[pyo3(signature = (point, radius, *, classes = None))]
    fn landmarks_near<'py>(
        &self,
        py: Python<'py>,
        point: (f64, f64),
        radius: f64,
        classes: Option<Vec<String>>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        crate::sensing::landmarks_near(py, &self.0, point, radius, classes_of(classes)?)
    }

    /// What a sensor at a point that looks along `heading` [rad] sees of them: up to `range` [m], half of `field_of_view` [rad] to either side, nearest first.
    ///
    /// Signals are seen from the front only, and nothing hides anything.
    #[pyo3(signature = (point, heading, range, field_of_view, *, classes = None))]
    fn landmarks_in_view<'py>(
        &self,
        py: Python<'py>,
        point: (f64, f64),
        heading: f64,
        range: f64,
        field_of_view: f64,
        classes: Option<Vec<String>>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let position = DVec2::new(point.0, point.1);
        let sensor = Sensor { position, heading, range, field_of_view };
        crate::sensing::landmarks_in_view(py, &self.0, &sensor, classes_of(classes)?)
    }

    /// Painted places of road marks and, with `objects`, of painted objects in a rectangle, at every multiple of `spacing` [m] along each; gaps have none.
    #[pyo3(signature = (region, spacing, *, kinds = None, types = None, objects = true))]
    fn mark_points<'py>(
        &self,
        py: Python<'py>,
        region: [f64; 4],
        spacing: f64,
        kinds: Option<Vec<String>>,
        types: Option<&Bound<'py, PyAny>>,
        objects: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let filter = MarkFilter { objects, ..crate::ground::filter(0.0, kinds, types)? };
        crate::sensing::mark_points(py, &self.0, region_of(region), spacing, &filter)
    }

    /// How vehicles stand on the ground below their wheels: places (4, 2) ahead of and to the left of the reference point [m]. `heading` [rad]; z [m] tells levels apart, or `expected` lanes.
    ///
    /// Nothing with ground below fewer than three wheels.
    #[pyo3(signature = (points, heading, wheels, *, expected = None, out = None))]
    fn stance<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        heading: &Bound<'py, PyAny>,
        wheels: &Bound<'py, PyAny>,
        expected: Option<Vec<Bound<'py, PyAny>>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let expected = crate::input::lanes_of(self.map(), expected.as_deref())?;
        crate::sensing::stance(py, &self.0, points, heading, wheels, &expected, out)
    }
}
