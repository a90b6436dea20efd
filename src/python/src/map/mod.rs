//! A map: one pinned generation and what is asked of all of it.

mod earth;
mod graph;
mod matching;
mod places;
mod records;
mod region;
mod steps;
mod surroundings;
mod ways;

use crate::errors::{client, raise};
use crate::held::Held;
use crate::input::{lane_of, triple};
use crate::junction::Junction;
use crate::lane::Lane;
use crate::object::Object;
use crate::road::Road;
use crate::signal::Signal;
use mapd_client::document::Revision;
use mapd_client::raw::AlignedBytes;
use mapd_client::{Bounds, Snapshot, TrustedKey};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
pub(crate) use records::controller;
use std::path::PathBuf;
use std::sync::Arc;

/// One generation of a map, pinned: immutable, shared by threads, readable as long as it or anything that came from it lives.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct Map(Arc<Held>);

impl Map {
    pub(crate) fn of(held: Arc<Held>) -> Self {
        Self(held)
    }

    pub(crate) fn held(&self) -> &Arc<Held> {
        &self.0
    }

    pub(crate) fn map(&self) -> mapd_client::Map<'_> {
        self.0.map()
    }
}

/// Opens an archive in place, if it was signed with a key where one is given; what `mapd.open` calls.
#[pyfunction]
#[pyo3(signature = (path, key = None))]
pub(crate) fn open_archive(py: Python<'_>, path: PathBuf, key: Option<PathBuf>) -> PyResult<Map> {
    let open = || match key {
        Some(key) => Snapshot::open_trusted(&path, &TrustedKey::open(key)?),
        None => Snapshot::open(&path),
    };
    let snapshot = py.detach(open).map_err(client)?;
    Ok(Map::of(Arc::new(Held::new(snapshot))))
}

#[pymethods]
impl Map {
    /// Number of the generation; 0 for a file.
    #[getter]
    fn generation(&self) -> u64 {
        self.map().generation()
    }

    /// Name in the file's header.
    #[getter]
    fn name(&self) -> &str {
        self.map().name()
    }

    /// BLAKE3 of the archive's body.
    #[getter]
    fn content_hash<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.map().content_hash())
    }

    /// BLAKE3 of the OpenDRIVE file that it was compiled from.
    #[getter]
    fn source_hash<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.map().source_hash())
    }

    /// OpenDRIVE's version: revMajor, revMinor.
    #[getter]
    fn revision(&self) -> (u16, u16) {
        let Revision { major, minor } = self.map().revision();
        (major, minor)
    }

    /// Smallest and largest x, y, z of all lanes [m].
    #[getter]
    fn bounds(&self) -> ((f64, f64, f64), (f64, f64, f64)) {
        let Bounds { low, high } = self.map().bounds();
        (triple(low), triple(high))
    }

    /// Sum of the roads' lengths [m].
    #[getter]
    fn road_length(&self) -> f64 {
        self.map().road_length()
    }

    /// The georeference as written.
    #[getter]
    fn geo_reference(&self) -> &str {
        self.map().geo_reference()
    }

    /// The georeference as PROJ parameters; empty if there is none that can be used.
    #[getter]
    fn projection(&self) -> &str {
        self.map().projection()
    }

    /// Verifies the whole archive, its content hash included; linear in its size.
    fn verify(&self, py: Python<'_>) -> PyResult<()> {
        py.detach(|| self.0.snapshot().verify()).map_err(client)
    }

    /// Maps every page of the archive into this process now.
    fn populate(&self, py: Python<'_>) {
        py.detach(|| self.0.snapshot().populate());
    }

    /// All lanes, lane 0 of each section left out.
    fn lanes(&self) -> Vec<Lane> {
        self.map().lanes().map(|lane| Lane::new(&self.0, lane.lane_id().row())).collect()
    }

    /// All roads in file order.
    fn roads(&self) -> Vec<Road> {
        self.map().roads().map(|road| Road::new(&self.0, road.road_id().row())).collect()
    }

    /// All junctions.
    fn junctions(&self) -> Vec<Junction> {
        self.map().junctions().map(|one| Junction::new(&self.0, one.junction_id())).collect()
    }

    /// All signals.
    fn signals(&self) -> Vec<Signal> {
        self.map().signals().map(|signal| Signal::new(&self.0, signal.signal_id())).collect()
    }

    /// All objects.
    fn objects(&self) -> Vec<Object> {
        self.map().objects().map(|object| Object::new(&self.0, object.object_id())).collect()
    }

    /// The lane of a key such as "12:0:-1", or of an id.
    fn lane(&self, lane: &Bound<'_, PyAny>) -> PyResult<Lane> {
        Ok(Lane::new(&self.0, lane_of(self.map(), lane)?.lane_id().row()))
    }

    /// The road with OpenDRIVE's id.
    fn road(&self, id: &str) -> PyResult<Road> {
        let road = self.map().road_by_id(id);
        road.map(|road| Road::new(&self.0, road.road_id().row()))
            .ok_or_else(|| raise("NoSuchPartError", format!("the map has no road {id:?}")))
    }

    /// The junction with OpenDRIVE's id.
    fn junction(&self, id: &str) -> PyResult<Junction> {
        let junction = self.map().junction_by_id(id);
        junction
            .map(|junction| Junction::new(&self.0, junction.junction_id()))
            .ok_or_else(|| raise("NoSuchPartError", format!("the map has no junction {id:?}")))
    }

    /// The signal with OpenDRIVE's id.
    fn signal(&self, id: &str) -> PyResult<Signal> {
        let signal = self.map().signal_by_id(id);
        signal
            .map(|signal| Signal::new(&self.0, signal.signal_id()))
            .ok_or_else(|| raise("NoSuchPartError", format!("the map has no signal {id:?}")))
    }

    /// The object with OpenDRIVE's id.
    fn object(&self, id: &str) -> PyResult<Object> {
        let object = self.map().object_by_id(id);
        object
            .map(|object| Object::new(&self.0, object.object_id()))
            .ok_or_else(|| raise("NoSuchPartError", format!("the map has no object {id:?}")))
    }

    /// The map under what is laid over it, at a moment: seconds since 1970 in UTC [s], a datetime, or now.
    #[pyo3(signature = (at = None))]
    fn view(&self, at: Option<&Bound<'_, PyAny>>) -> PyResult<crate::view::View> {
        crate::view::view(&self.0, at)
    }

    /// Revision of what is laid over it, which rises with each change; 0 where nothing is.
    #[getter]
    fn overlay_revision(&self) -> u64 {
        self.0.snapshot().overlay_revision()
    }

    /// The same map under an overlay that mapd encoded for it. What a client attaches to is under the daemon's without this.
    fn with_overlay(&self, py: Python<'_>, overlay: Vec<u8>) -> PyResult<Self> {
        let under = py.detach(|| {
            let mut bytes = AlignedBytes::with_capacity(overlay.len());
            bytes.extend_from_slice(&overlay);
            self.0.snapshot().with_overlay(bytes)
        });
        Ok(Self::of(Arc::new(Held::new(under.map_err(client)?))))
    }

    fn _bytes(this: Bound<'_, Self>) -> Bound<'_, numpy::PyArray1<u8>> {
        crate::raw::bytes(&this)
    }

    fn _tables(&self) -> PyResult<Vec<crate::raw::Entry>> {
        crate::raw::tables(self)
    }

    fn _repr_html_<'py>(this: Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        this.py().import("mapd._pictures")?.call_method1("map_html", (this,))
    }

    fn __repr__(&self) -> String {
        let map = self.map();
        let (roads, lanes) = (map.tables().roads.len(), map.lanes().count());
        format!(
            "<mapd.Map {:?} generation {}: {roads} roads, {lanes} lanes, {:.1} km>",
            map.name(),
            map.generation(),
            map.road_length() / 1000.0
        )
    }
}
