//! Junctions.

use crate::batch::{fields, result};
use crate::errors::query;
use crate::held::{Held, content, id};
use crate::road::Road;
use mapd_client::JunctionId;
use pyo3::prelude::*;
use std::sync::Arc;

/// A junction: roads, and which lanes lead from one to another.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct Junction {
    held: Arc<Held>,
    junction: JunctionId,
}

impl Junction {
    pub(crate) fn new(held: &Arc<Held>, junction: JunctionId) -> Self {
        Self { held: Arc::clone(held), junction }
    }

    fn junction(&self) -> PyResult<mapd_client::Junction<'_>> {
        self.held.map().junction(self.junction).map_err(query)
    }

    fn number(&self) -> u64 {
        id(content(self.held.map()), self.junction.row())
    }
}

#[pymethods]
impl Junction {
    /// OpenDRIVE's id.
    #[getter]
    fn id(&self) -> PyResult<&str> {
        Ok(self.junction()?.id())
    }

    /// OpenDRIVE's name.
    #[getter]
    fn name(&self) -> PyResult<&str> {
        Ok(self.junction()?.name())
    }

    /// Connections in file order.
    fn connections<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let road = |road: Option<mapd_client::Road<'_>>| {
            road.map(|road| Road::new(&self.held, road.road_id().row()))
        };
        let connections = self.junction()?.connections().map(|one| {
            let links: Vec<_> = one.lane_links().map(|link| (link.from, link.to)).collect();
            let fields = fields!(
                py,
                id = one.id(),
                incoming_road = road(one.incoming_road()),
                connecting_road = road(one.connecting_road()),
                contact_point = one.contact_point().name(),
                lane_links = links,
            );
            result(py, "Connection", &fields)
        });
        connections.collect()
    }

    /// Ids of the controllers of its lights.
    fn controllers(&self) -> PyResult<Vec<&str>> {
        Ok(self.junction()?.controllers().map(|one| one.id()).collect())
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get().number() == self.number())
    }

    fn __hash__(&self) -> u64 {
        self.number()
    }

    fn _repr_html_<'py>(this: Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        this.py().import("mapd._pictures")?.call_method1("junction_html", (this,))
    }

    fn __repr__(&self) -> PyResult<String> {
        let junction = self.junction()?;
        Ok(format!(
            "<mapd.Junction {} with {} connections>",
            junction.id(),
            junction.connections().len()
        ))
    }
}
