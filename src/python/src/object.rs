//! Objects.

use crate::batch::{fields, result, triples};
use crate::errors::query;
use crate::held::{Held, content, id};
use crate::input::triple;
use crate::road::Road;
use mapd_client::ObjectId;
use mapd_client::objects::ObjectPlacement;
use pyo3::prelude::*;
use std::sync::Arc;

/// A pole, a barrier, a building, a parking space.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct Object {
    held: Arc<Held>,
    object: ObjectId,
}

impl Object {
    pub(crate) fn new(held: &Arc<Held>, object: ObjectId) -> Self {
        Self { held: Arc::clone(held), object }
    }

    fn object(&self) -> PyResult<mapd_client::objects::Object<'_>> {
        self.held.map().object(self.object).map_err(query)
    }

    fn number(&self) -> u64 {
        id(content(self.held.map()), self.object.row())
    }
}

/// A place of an object as Python has it.
pub(crate) fn placement<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    place: &ObjectPlacement<'_>,
) -> PyResult<Bound<'py, PyAny>> {
    let id = place.placement_id();
    let (p, [heading, pitch, roll], mut corners) = (place.position(), place.angles(), Vec::new());
    place.footprint(&mut corners);
    let fields = fields!(
        py,
        object = Object::new(held, id.object),
        copy = id.copy,
        x = p.x,
        y = p.y,
        z = p.z,
        heading = heading,
        pitch = pitch,
        roll = roll,
        length = place.length(),
        width = place.width(),
        height = place.height(),
        radius = place.radius(),
        footprint = triples(py, corners.iter().flat_map(|p| [p.x, p.y, p.z]).collect())?,
    );
    result(py, "Placement", &fields)
}

#[pymethods]
impl Object {
    /// OpenDRIVE's id.
    #[getter]
    fn id(&self) -> PyResult<&str> {
        Ok(self.object()?.id())
    }

    /// OpenDRIVE's name.
    #[getter]
    fn name(&self) -> PyResult<&str> {
        Ok(self.object()?.name())
    }

    /// Its class in mapd's vocabulary (docs/ontology.md).
    #[getter]
    fn meaning(&self) -> PyResult<&'static str> {
        Ok(self.object()?.class().name())
    }

    /// Type as written.
    #[getter]
    fn kind(&self) -> PyResult<&str> {
        Ok(self.object()?.type_name())
    }

    /// Its origin [m].
    #[getter]
    fn position(&self) -> PyResult<(f64, f64, f64)> {
        Ok(triple(self.object()?.position()))
    }

    /// Of its u axis [rad].
    #[getter]
    fn heading(&self) -> PyResult<f64> {
        Ok(self.object()?.heading())
    }

    /// Length, width and height [m]; 0 where not given.
    #[getter]
    fn size(&self) -> PyResult<(f64, f64, f64)> {
        let object = self.object()?;
        Ok((object.length(), object.width(), object.height()))
    }

    /// Of a round object [m]; else 0.
    #[getter]
    fn radius(&self) -> PyResult<f64> {
        Ok(self.object()?.radius())
    }

    /// Whether it moves.
    #[getter]
    fn is_dynamic(&self) -> PyResult<bool> {
        Ok(self.object()?.is_dynamic())
    }

    /// The road that it is written in.
    #[getter]
    fn road(&self) -> PyResult<Option<Road>> {
        Ok(self.object()?.road().map(|road| Road::new(&self.held, road.road_id().row())))
    }

    /// s and t as written [m].
    #[getter]
    fn track(&self) -> PyResult<(f64, f64)> {
        let object = self.object()?;
        Ok((object.s(), object.t()))
    }

    /// Corners (M, 3) of what it covers [m].
    fn footprint<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let mut corners = Vec::new();
        self.object()?.footprint(&mut corners);
        triples(py, corners.iter().flat_map(|p| [p.x, p.y, p.z]).collect())
    }

    /// Where it stands: itself, or each of its copies.
    fn placements<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.object()?.placements().map(|one| placement(py, &self.held, &one)).collect()
    }

    /// Lanes that it is on or belongs to.
    fn lanes<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let all = self.object()?.lanes();
        all.filter_map(|one| crate::lane::object_lane(py, &self.held, &one).transpose()).collect()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get().number() == self.number())
    }

    fn __hash__(&self) -> u64 {
        self.number()
    }

    fn __repr__(&self) -> PyResult<String> {
        let object = self.object()?;
        let p = object.position();
        Ok(format!(
            "<mapd.Object {} {} at ({:.2}, {:.2}, {:.2})>",
            object.id(),
            object.class().name(),
            p.x,
            p.y,
            p.z
        ))
    }
}
