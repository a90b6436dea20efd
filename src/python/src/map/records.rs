//! What a map has of the file's records besides roads and lanes: controllers, groups, bridges, references, what is left out, what is said besides.

use super::Map;
use crate::batch::{fields, result};
use crate::held::Held;
use crate::junction::Junction;
use crate::lane::Lane;
use crate::object::Object;
use crate::road::Road;
use crate::signal::Signal;
use mapd_client::document::{Annotated, Annotation, Quarantined, SourcePosition};
use mapd_client::junctions::JunctionGroup;
use mapd_client::objects::ObjectReference;
use mapd_client::signals::Controller;
use mapd_client::vocabulary::QuarantinedKind;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::Arc;

type Any<'py> = Bound<'py, PyAny>;

/// A controller as Python has it.
pub(crate) fn controller<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    one: &Controller<'_>,
) -> PyResult<Any<'py>> {
    let signals = one.signals().map(|own| Signal::new(held, own.signal_id()));
    let junctions = one.junctions().map(|own| Junction::new(held, own.junction_id()));
    let fields = fields!(
        py,
        number = one.controller_id().row(),
        id = one.id(),
        name = one.name(),
        sequence = one.sequence(),
        signals = PyTuple::new(py, signals.collect::<Vec<_>>())?,
        junctions = PyTuple::new(py, junctions.collect::<Vec<_>>())?,
    );
    result(py, "Controller", &fields)
}

impl Map {
    fn group<'py>(&self, py: Python<'py>, one: &JunctionGroup<'_>) -> PyResult<Any<'py>> {
        let members = one.members().filter_map(|own| own.junction());
        let members = members.map(|own| Junction::new(&self.0, own.junction_id()));
        let ring = one.ring().map(|lane| Lane::new(&self.0, lane.row()));
        let fields = fields!(
            py,
            id = one.id(),
            name = one.name(),
            kind = one.kind().name(),
            junctions = PyTuple::new(py, members.collect::<Vec<_>>())?,
            ring = PyTuple::new(py, ring.collect::<Vec<_>>())?,
        );
        result(py, "JunctionGroup", &fields)
    }

    fn road_of(&self, road: Option<mapd_client::Road<'_>>) -> Option<Road> {
        road.map(|road| Road::new(&self.0, road.road_id().row()))
    }

    fn reference<'py>(&self, py: Python<'py>, one: &ObjectReference<'_>) -> PyResult<Any<'py>> {
        let fields = fields!(
            py,
            id = one.id(),
            object = one.object().map(|own| Object::new(&self.0, own.object_id())),
            road = self.road_of(one.road()),
            s = one.s(),
            t = one.t(),
            z_offset = one.z_offset(),
            valid_length = one.valid_length(),
            orientation = one.orientation().name(),
        );
        result(py, "ObjectReference", &fields)
    }

    fn part<'py>(&self, py: Python<'py>, one: &Quarantined<'_>) -> PyResult<Any<'py>> {
        let SourcePosition { line, column } = one.source_position();
        let fields = fields!(
            py,
            kind = one.kind().name(),
            id = one.id(),
            owner = one.owner(),
            owner_kind = one.owner_kind().name(),
            dropped = !one.is_reference_line(),
            length = one.length(),
            rule = one.rule(),
            message = one.message(),
            file = one.source_file().unwrap_or_default(),
            line = line,
            column = column,
        );
        result(py, "QuarantinedPart", &fields)
    }

    fn annotation<'py>(&self, py: Python<'py>, one: &Annotation<'_>) -> PyResult<Any<'py>> {
        let held = &self.0;
        let owner = match one.owner() {
            Some(Annotated::Road(own)) => {
                Some(Bound::new(py, Road::new(held, own.row()))?.into_any())
            }
            Some(Annotated::Lane(own)) => {
                Some(Bound::new(py, Lane::new(held, own.row()))?.into_any())
            }
            Some(Annotated::Junction(own)) => {
                Some(Bound::new(py, Junction::new(held, own))?.into_any())
            }
            Some(Annotated::Object(own)) => {
                Some(Bound::new(py, Object::new(held, own))?.into_any())
            }
            Some(Annotated::Signal(own)) => {
                Some(Bound::new(py, Signal::new(held, own))?.into_any())
            }
            _ => None,
        };
        let SourcePosition { line, column } = one.source_position();
        let fields = fields!(
            py,
            kind = one.kind().name(),
            owner_kind = one.owner_kind().name(),
            owner = owner,
            path = one.path(),
            name = one.name(),
            value = one.value(),
            text = one.text(),
            file = one.file().map_or("", |file| file.name()),
            line = line,
            column = column,
        );
        result(py, "Annotation", &fields)
    }
}

#[pymethods]
impl Map {
    /// All controllers of signals, in file order.
    fn controllers<'py>(&self, py: Python<'py>) -> PyResult<Vec<Any<'py>>> {
        self.map().controllers().map(|one| controller(py, &self.0, &one)).collect()
    }

    /// All groups of junctions, such as roundabouts, in file order.
    fn junction_groups<'py>(&self, py: Python<'py>) -> PyResult<Vec<Any<'py>>> {
        self.map().junction_groups().map(|one| self.group(py, &one)).collect()
    }

    /// All bridges and tunnels, by road.
    fn structures<'py>(&self, py: Python<'py>) -> PyResult<Vec<Any<'py>>> {
        let one = |one: mapd_client::objects::Structure<'_>| {
            let range = one.s_range();
            let fields = fields!(
                py,
                kind = one.kind().name(),
                id = one.id(),
                name = one.name(),
                type = one.type_name(),
                road = self.road_of(one.road()),
                s_from = range.low,
                s_to = range.high,
            );
            result(py, "Structure", &fields)
        };
        self.map().structures().map(one).collect()
    }

    /// All references of roads to objects of other roads, by the road that refers.
    fn object_references<'py>(&self, py: Python<'py>) -> PyResult<Vec<Any<'py>>> {
        self.map().object_references().map(|one| self.reference(py, &one)).collect()
    }

    /// Parts of the file that are not in the map as written, in file order; none where it was accepted whole.
    fn quarantined<'py>(&self, py: Python<'py>) -> PyResult<Vec<Any<'py>>> {
        self.map().quarantined().map(|one| self.part(py, &one)).collect()
    }

    /// Why the map has no part of this kind ("road", "junction", "object", "signal", ...) and id; None where the file has no such part either.
    fn left_out<'py>(&self, py: Python<'py>, kind: &str, id: &str) -> PyResult<Option<Any<'py>>> {
        let known = match QuarantinedKind::from_name(kind) {
            QuarantinedKind::Unknown => {
                let all: Vec<_> = QuarantinedKind::ALL.iter().map(|one| one.name()).collect();
                let text = format!("kind: expected one of {all:?}, found {kind:?}");
                return Err(PyValueError::new_err(text));
            }
            known => known,
        };
        self.map().left_out(known, id).map(|one| self.part(py, &one)).transpose()
    }

    /// What the file says besides, such as user data: the document's first, then those of roads, lanes, junctions and so on.
    fn annotations<'py>(&self, py: Python<'py>) -> PyResult<Vec<Any<'py>>> {
        self.map().annotations().map(|one| self.annotation(py, &one)).collect()
    }

    /// South, north, west and east [deg] as the file's header writes them; None where it does not.
    #[getter]
    fn geodetic_bounds(&self) -> Option<(f64, f64, f64, f64)> {
        self.map().geodetic_bounds().map(|[south, north, west, east]| (south, north, west, east))
    }
}
