//! Signals.

use crate::batch::{fields, result};
use crate::errors::query;
use crate::held::{Held, content, id};
use crate::input::triple;
use crate::lane::Lane;
use crate::map::{Map, controller};
use crate::object::Object;
use crate::road::Road;
use mapd_client::SignalId;
use mapd_client::signals::SignalLink;
use pyo3::prelude::*;
use std::sync::Arc;

/// A sign, a light, or a marking across lanes.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct Signal {
    held: Arc<Held>,
    signal: SignalId,
}

impl Signal {
    pub(crate) fn new(held: &Arc<Held>, signal: SignalId) -> Self {
        Self { held: Arc::clone(held), signal }
    }

    fn signal(&self) -> PyResult<mapd_client::signals::Signal<'_>> {
        self.held.map().signal(self.signal).map_err(query)
    }

    pub(crate) fn signal_id(&self) -> SignalId {
        self.signal
    }

    fn number(&self) -> u64 {
        id(content(self.held.map()), self.signal.row())
    }

    fn link<'py>(&self, py: Python<'py>, one: &SignalLink<'_>) -> PyResult<Bound<'py, PyAny>> {
        let fields = fields!(
            py,
            id = one.id,
            kind = one.kind,
            is_object = one.is_object,
            signal = one.signal.map(|own| Self::new(&self.held, own.signal_id())),
            object = one.object.map(|own| Object::new(&self.held, own.object_id())),
        );
        result(py, "SignalLink", &fields)
    }
}

#[pymethods]
impl Signal {
    /// OpenDRIVE's id.
    #[getter]
    fn id(&self) -> PyResult<&str> {
        Ok(self.signal()?.id())
    }

    /// OpenDRIVE's name.
    #[getter]
    fn name(&self) -> PyResult<&str> {
        Ok(self.signal()?.name())
    }

    /// Its class in mapd's vocabulary (docs/ontology.md).
    #[getter]
    fn meaning(&self) -> PyResult<&'static str> {
        Ok(self.signal()?.class().name())
    }

    /// As written: country, its revision, type, subtype.
    #[getter]
    fn code(&self) -> PyResult<(&str, &str, &str, &str)> {
        let [country, revision, kind, subtype] = self.signal()?.code();
        Ok((country, revision, kind, subtype))
    }

    /// Text shown.
    #[getter]
    fn text(&self) -> PyResult<&str> {
        Ok(self.signal()?.shown_text())
    }

    /// What the class means by its value: [m/s], [m] or [kg].
    #[getter]
    fn value(&self) -> PyResult<Option<f64>> {
        Ok(self.signal()?.value())
    }

    /// Whether its state changes.
    #[getter]
    fn is_dynamic(&self) -> PyResult<bool> {
        Ok(self.signal()?.is_dynamic())
    }

    /// Where it stands [m].
    #[getter]
    fn position(&self) -> PyResult<(f64, f64, f64)> {
        Ok(triple(self.signal()?.position()))
    }

    /// Direction of its face's normal [rad], in (-pi, pi].
    #[getter]
    fn facing(&self) -> PyResult<f64> {
        Ok(self.signal()?.facing())
    }

    /// Width, height and length [m], where given.
    #[getter]
    fn size(&self) -> PyResult<(Option<f64>, Option<f64>, Option<f64>)> {
        let [width, height, length] = self.signal()?.size();
        Ok((width, height, length))
    }

    /// The road that it is written in.
    #[getter]
    fn road(&self) -> PyResult<Option<Road>> {
        Ok(self.signal()?.road().map(|road| Road::new(&self.held, road.road_id().row())))
    }

    /// s and t as written [m].
    #[getter]
    fn track(&self) -> PyResult<(f64, f64)> {
        let [s, t, ..] = self.signal()?.track();
        Ok((s, t))
    }

    /// Objects and signals that belong to it, such as the pole that it hangs from.
    fn links<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.signal()?.links().map(|one| self.link(py, &one)).collect()
    }

    /// Signals that it controls or depends on.
    fn dependencies<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.signal()?.dependencies().map(|one| self.link(py, &one)).collect()
    }

    /// Lanes of junctions whose movements it governs, where it is a light.
    fn movements(&self) -> PyResult<Vec<Lane>> {
        let lanes = self.signal()?.movements();
        Ok(lanes.map(|lane| Lane::new(&self.held, lane.lane_id().row())).collect())
    }

    /// Its controllers.
    fn controllers<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.signal()?.controllers().map(|one| controller(py, &self.held, &one)).collect()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get().number() == self.number())
    }

    fn __hash__(&self) -> u64 {
        self.number()
    }

    fn _repr_html_<'py>(this: Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let map = Map::of(Arc::clone(&this.get().held));
        this.py().import("mapd._pictures")?.call_method1("signal_html", (this, map))
    }

    fn __repr__(&self) -> PyResult<String> {
        let signal = self.signal()?;
        let p = signal.position();
        Ok(format!(
            "<mapd.Signal {} {} at ({:.2}, {:.2}, {:.2})>",
            signal.id(),
            signal.class().name(),
            p.x,
            p.y,
            p.z
        ))
    }
}
