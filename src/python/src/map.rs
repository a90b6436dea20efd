//! A map: one pinned generation and what is asked of all of it.

use crate::batch::{Column, Positions, Speeds, answer, columns, fields, in_row, result};
use crate::errors::{client, query, raise};
use crate::held::{Held, content};
use crate::input::{
    Rows, column, finite, lane_of, lane_of_id, one_point, places, region_of, triple, types_of,
    vehicle_of,
};
use crate::lane::{self, Lane};
use crate::object::Object;
use crate::road::Road;
use crate::signal::Signal;
use mapd_client::Bounds;
use mapd_client::batch::{BatchScratch, NearestLanes, Places};
use mapd_client::document::Revision;
use mapd_client::geodesy::Geodetic;
use mapd_client::glam::{DVec2, DVec3};
use mapd_client::localisation::{MatchOptions, Sensor, TraceOptions};
use mapd_client::path::{LaneChange, PathOptions};
use mapd_client::raw::AlignedBytes;
use mapd_client::{LaneTypes, Nearest, NearestOptions, Snapshot};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
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

    fn nearest_result<'py>(&self, py: Python<'py>, hit: &Nearest) -> PyResult<Bound<'py, PyAny>> {
        let at = &hit.position;
        let lane = Lane::new(&self.0, hit.lane.row());
        let fields = fields!(
            py,
            lane = lane,
            s = at.s,
            t = at.t,
            offset = at.offset,
            distance = at.distance,
            z = at.z,
            heading = at.heading,
        );
        result(py, "Nearest", &fields)
    }
}

/// Opens an archive in place; what `mapd.open` calls.
#[pyfunction]
pub(crate) fn open_archive(py: Python<'_>, path: PathBuf) -> PyResult<Map> {
    let snapshot = py.detach(|| Snapshot::open(&path)).map_err(client)?;
    Ok(Map::of(Arc::new(Held::new(snapshot))))
}

/// What one call asks of all its points, but for the headings.
fn options(
    radius: f64,
    types: Option<&Bound<'_, PyAny>>,
    z_tolerance: Option<f64>,
    heading_tolerance: Option<f64>,
) -> PyResult<NearestOptions> {
    let types = types.map_or(Ok(LaneTypes::ALL), types_of)?;
    Ok(NearestOptions {
        radius,
        types,
        z_tolerance,
        heading_tolerance,
        ..NearestOptions::default()
    })
}

/// A heading for each row, if any.
fn headings(heading: Option<&Bound<'_, PyAny>>, rows: usize) -> PyResult<Option<Vec<f64>>> {
    heading.map(|heading| column(heading, "heading", rows)).transpose()
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

    /// The lane whose area is nearest in plan view, at most `radius` [m] away; of several, by heading difference, height, offset.
    ///
    /// `types` are the lane types that count ("drivable", or OpenDRIVE's names). `z_tolerance` [m] tells levels apart and needs points
    /// with z; `heading` [rad] of travel breaks ties, and excludes lanes by `heading_tolerance` [rad].
    #[pyo3(signature = (points, *, radius = 10.0, types = None, z_tolerance = None, heading = None,
        heading_tolerance = None, out = None))]
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
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let mut options = options(radius, types, z_tolerance, heading_tolerance)?;
        if let Some(point) = one_point(points, "points")? {
            options.heading = heading.map(|heading| heading.extract()).transpose()?;
            let hit = self.map().nearest_lane(point, &options).map_err(query)?;
            return hit.map(|hit| self.nearest_result(py, &hit)).transpose();
        }
        let points = Rows::of(points, "points", &[2, 3])?;
        let headings = headings(heading, points.len())?;
        let found = answer(py, || {
            let (map, columns) = (self.map(), points.columns());
            let places = Places { heading: headings.as_deref(), ..places(&columns) };
            let (mut scratch, mut found) = (BatchScratch::default(), NearestLanes::default());
            map.nearest_lanes(places, &options, &mut scratch, &mut found).map_err(in_row)?;
            Ok(Positions::of(content(map), found))
        })?;
        columns(py, "NearestLanes", found.columns(), out).map(Some)
    }

    /// Every lane within `radius` [m], nearest first; options as of nearest_lane.
    #[pyo3(signature = (points, *, radius = 10.0, types = None, z_tolerance = None, heading = None,
        heading_tolerance = None))]
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
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut options = options(radius, types, z_tolerance, heading_tolerance)?;
        if let Some(point) = one_point(points, "points")? {
            options.heading = heading.map(|heading| heading.extract()).transpose()?;
            let mut near = Vec::new();
            self.map().lanes_near(point, &options, &mut near).map_err(query)?;
            let hits = near.iter().map(|hit| self.nearest_result(py, hit));
            let hits = hits.collect::<PyResult<Vec<_>>>()?;
            return Ok(pyo3::types::PyList::new(py, hits)?.into_any());
        }
        let points = Rows::of(points, "points", &[2, 3])?;
        let headings = headings(heading, points.len())?;
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
        columns(py, "LanesNear", all, None)
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
        let points = Rows::of(points, "points", &[2, 3])?;
        let lanes = crate::input::ids(lanes, "lanes", Some(points.len()))?;
        let found = answer(py, || {
            let map = self.map();
            let content = content(map);
            let mut found = Positions::with_capacity(points.len());
            for (row, (point, id)) in points.points().zip(&lanes).enumerate() {
                let lane = lane_of_id(map, *id).map_err(|error| (row, error))?;
                let at = lane.position_of(point).map_err(|error| (row, error))?;
                found.push(content, lane.lane_id().row(), &at);
            }
            Ok(found)
        })?;
        columns(py, "NearestLanes", found.columns(), out)
    }

    /// Poses on lanes as their traffic has them, at s [m], `offset` [m] to the left of the lane's centre.
    #[pyo3(signature = (lanes, s, offset = None, *, out = None))]
    fn pose_at<'py>(
        &self,
        py: Python<'py>,
        lanes: &Bound<'py, PyAny>,
        s: &Bound<'py, PyAny>,
        offset: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let lanes = crate::input::ids(lanes, "lanes", None)?;
        let s = column(s, "s", lanes.len())?;
        let offset = match offset {
            Some(offset) => column(offset, "offset", lanes.len())?,
            None => vec![0.0; lanes.len()],
        };
        let found = answer(py, || {
            let map = self.map();
            let mut found = crate::batch::Poses::with_capacity(lanes.len());
            for (row, id) in lanes.iter().enumerate() {
                let lane = lane_of_id(map, *id).map_err(|error| (row, error))?;
                found.push(&lane.pose_at(s[row], offset[row]).map_err(|error| (row, error))?);
            }
            Ok(found)
        })?;
        columns(py, "Poses", found.columns(), out)
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
        let lanes = crate::input::ids(lanes, "lanes", None)?;
        let s = column(s, "s", lanes.len())?;
        let found = answer(py, || {
            let mut found = Speeds::with_capacity(lanes.len());
            for (row, id) in lanes.iter().enumerate() {
                let lane = lane_of_id(self.map(), *id).map_err(|error| (row, error))?;
                let s = finite(s[row]).map_err(|error| (row, error))?;
                found.push(&lane.speed_rule_at(s));
            }
            Ok(found)
        })?;
        columns(py, "SpeedRules", found.columns(), out)
    }

    /// The surface below points [m], on the level whose height is nearest to z; on the lowest one of points without z.
    ///
    /// Heights more than 2 m apart are levels of their own. Nothing beside all lanes.
    #[pyo3(signature = (points, *, out = None))]
    fn ground_at<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        crate::ground::ground_at(py, &self.0, points, out)
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

    /// The lanes that vehicles may be in, and the probability that they are in none (docs/localisation.md).
    ///
    /// `heading` [rad]; `covariance` of (x, y, heading) [m^2, m rad, rad^2], one (3, 3) for all or (N, 3, 3). `drive_deviation` [rad] is
    /// how drivers deviate from their lane's direction, `none` the prior of no lane; `closed` and `unexpected` are the shares of the
    /// prior that lanes have which `vehicle` may not use, and which are not among `expected`.
    #[pyo3(signature = (points, heading, covariance, *, types = None, z_tolerance = None,
        drive_deviation = 0.1, none = 0.01, vehicle = None, closed = 0.05, expected = None, unexpected = 0.05))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn match_pose<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        heading: &Bound<'py, PyAny>,
        covariance: &Bound<'py, PyAny>,
        types: Option<&Bound<'py, PyAny>>,
        z_tolerance: Option<f64>,
        drive_deviation: f64,
        none: f64,
        vehicle: Option<&str>,
        closed: f64,
        expected: Option<Vec<Bound<'py, PyAny>>>,
        unexpected: f64,
    ) -> PyResult<Bound<'py, PyAny>> {
        let expected = crate::input::lanes_of(self.map(), expected.as_deref())?;
        let options = MatchOptions {
            types: types.map_or(Ok(LaneTypes::ALL), types_of)?,
            z_tolerance,
            drive_deviation,
            none,
            vehicle: vehicle.map(vehicle_of).transpose()?,
            closed,
            expected: &expected,
            unexpected,
        };
        let map = self.map();
        crate::matching::match_pose(py, &self.0, points, heading, covariance, |pose, own, out| {
            map.match_pose(pose, own, &options, out)
        })
    }

    /// The most probable way through a trace, a place for each fix.
    ///
    /// `time` [s] does not fall; `heading` [rad] is NaN where it is not known; `deviation` [m] is that of x and y, `heading_deviation` [rad] that of headings, `change_interval` [s]
    /// the mean time between changes of lane.
    #[pyo3(signature = (time, points, *, heading = None, deviation = 1.0, heading_deviation = 0.1,
        change_interval = 30.0, vehicle = "passengerCar", types = None, out = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn match_trace<'py>(
        &self,
        py: Python<'py>,
        time: &Bound<'py, PyAny>,
        points: &Bound<'py, PyAny>,
        heading: Option<&Bound<'py, PyAny>>,
        deviation: f64,
        heading_deviation: f64,
        change_interval: f64,
        vehicle: &str,
        types: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let options = TraceOptions {
            deviation,
            heading_deviation,
            vehicle: vehicle_of(vehicle)?,
            change_interval,
            types: types.map_or(Ok(LaneTypes::drivable()), types_of)?,
        };
        crate::matching::match_trace(py, &self.0, time, points, heading, &options, out)
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

    /// The cheapest way in driving direction, by allowed changes of lane only; None if there is none.
    ///
    /// A place is (lane, s) or what nearest_lane found. `lane_change` is what a change costs: default 20 m, or 2 s by time. `factors`
    /// multiply the cost of each lane, by its row (mapd.raw.rows): infinity closes it; lanes beyond their end have the factor 1.
    #[pyo3(signature = (start, goal, *, via = None, vehicle = "passengerCar", by = "length", lane_change = None, factors = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn route<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'py, PyAny>,
        goal: &Bound<'py, PyAny>,
        via: Option<Vec<Bound<'py, PyAny>>>,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        let places: Vec<_> =
            std::iter::once(start).chain(via.iter().flatten()).chain([goal]).collect();
        crate::route::route(py, &self.0, &places, vehicle, cost)
    }

    /// The cheapest way from any of some starts to any of some goals, which may be `RouteEnd`; lanes to avoid are not entered.
    ///
    /// `turns` are what turns to the left, to the right and back at junctions cost beside the way, in its unit; other options are those of route.
    #[pyo3(signature = (starts, goals, *, avoid = None, vehicle = "passengerCar", by = "length", lane_change = None,
        factors = None, turns = [0.0; 3]))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn find_route<'py>(
        &self,
        py: Python<'py>,
        starts: &Bound<'py, PyAny>,
        goals: &Bound<'py, PyAny>,
        avoid: Option<Vec<Bound<'py, PyAny>>>,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
        turns: [f64; 3],
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        let (held, ends) = (&self.0, [Some(starts), Some(goals)]);
        let asked =
            crate::request::Asked::of(held.map(), ends, avoid.as_deref(), vehicle, cost, turns)?;
        crate::request::find(py, held, |scratch, steps| {
            self.map().find_route(&asked.request(), scratch, steps)
        })
    }

    /// The cheapest way and alternatives to it, cheapest first: `count` at most, each on other roads for a `share` of its length, none `longest` times as expensive.
    #[pyo3(signature = (starts, goals, *, count = 3, share = 0.3, longest = 1.5, avoid = None,
        vehicle = "passengerCar", by = "length", lane_change = None, factors = None, turns = [0.0; 3]))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn alternatives<'py>(
        &self,
        py: Python<'py>,
        starts: &Bound<'py, PyAny>,
        goals: &Bound<'py, PyAny>,
        count: usize,
        share: f64,
        longest: f64,
        avoid: Option<Vec<Bound<'py, PyAny>>>,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
        turns: [f64; 3],
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        let (held, ends) = (&self.0, [Some(starts), Some(goals)]);
        let asked =
            crate::request::Asked::of(held.map(), ends, avoid.as_deref(), vehicle, cost, turns)?;
        let wanted = (count, share, longest);
        crate::request::alternatives(py, held, wanted, |options, scratch, out| {
            self.map().alternatives(&asked.request(), options, scratch, out)
        })
    }

    /// The network that can be reached from starts within a limit [m, or s by time], or from which goals can be, with the ways on.
    #[pyo3(signature = (limit, *, starts = None, goals = None, avoid = None, vehicle = "passengerCar", by = "length",
        lane_change = None, factors = None, turns = [0.0; 3]))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn reach<'py>(
        &self,
        py: Python<'py>,
        limit: f64,
        starts: Option<&Bound<'py, PyAny>>,
        goals: Option<&Bound<'py, PyAny>>,
        avoid: Option<Vec<Bound<'py, PyAny>>>,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
        turns: [f64; 3],
    ) -> PyResult<Bound<'py, PyAny>> {
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        let (held, ends, to) = (&self.0, [starts, goals], goals.is_some());
        if starts.is_some() == to {
            return Err(pyo3::exceptions::PyValueError::new_err(
                "expected starts, from which one drives, or goals, to which one comes",
            ));
        }
        let asked =
            crate::request::Asked::of(held.map(), ends, avoid.as_deref(), vehicle, cost, turns)?;
        crate::request::reach(py, held, |scratch, out| {
            if to {
                self.map().reach_to(&asked.request(), limit, scratch, out)
            } else {
                self.map().reach(&asked.request(), limit, scratch, out)
            }
        })
    }

    /// A route, or steps made by hand, as one line; PathError names the step that does not follow.
    ///
    /// `change_length` [m] makes each change of lane a smooth curve of that length where there is room; else the line jumps. Joints with a larger gap than `broken_gap` [m]
    /// or kink than `broken_kink` [rad] are broken.
    #[pyo3(signature = (steps, *, change_length = None, broken_gap = 0.1, broken_kink = 0.3))]
    fn path(
        &self,
        steps: &Bound<'_, PyAny>,
        change_length: Option<f64>,
        broken_gap: f64,
        broken_kink: f64,
    ) -> PyResult<crate::path::Path> {
        let change = change_length.map_or(LaneChange::Jump, LaneChange::Lateral);
        crate::path::path(&self.0, steps, &PathOptions { broken_gap, broken_kink, change })
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

    /// The lanes on which traffic comes to a conflict of a path, back to a distance [m], nearest first; the other lane itself comes first.
    #[pyo3(signature = (conflict, distance, *, vehicle = "passengerCar"))]
    fn approaches<'py>(
        &self,
        py: Python<'py>,
        conflict: &Bound<'py, PyAny>,
        distance: f64,
        vehicle: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        crate::along::approaches(py, &self.0, conflict, distance, vehicle_of(vehicle)?)
    }

    /// Signals and objects that localisers find again, within a radius [m], nearest first.
    fn landmarks_near<'py>(
        &self,
        py: Python<'py>,
        point: (f64, f64),
        radius: f64,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        crate::sensing::landmarks_near(py, &self.0, point, radius)
    }

    /// What a sensor at a point that looks along `heading` [rad] sees of them: up to `range` [m], half of `field_of_view` [rad] to either side, nearest first.
    ///
    /// Signals are seen from the front only, and nothing hides anything.
    fn landmarks_in_view<'py>(
        &self,
        py: Python<'py>,
        point: (f64, f64),
        heading: f64,
        range: f64,
        field_of_view: f64,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let position = DVec2::new(point.0, point.1);
        let sensor = Sensor { position, heading, range, field_of_view };
        crate::sensing::landmarks_in_view(py, &self.0, &sensor)
    }

    /// Painted places of road marks in a rectangle, at every multiple of `spacing` [m] of their road's s; gaps have none.
    #[pyo3(signature = (region, spacing, *, kinds = None, types = None))]
    fn mark_points<'py>(
        &self,
        py: Python<'py>,
        region: [f64; 4],
        spacing: f64,
        kinds: Option<Vec<String>>,
        types: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let filter = crate::ground::filter(0.0, kinds, types)?;
        crate::sensing::mark_points(py, &self.0, region_of(region), spacing, &filter)
    }

    /// How vehicles stand on the ground below their wheels: places (4, 2) ahead of and to the left of the reference point [m]. `heading` [rad]; z [m] tells levels apart.
    ///
    /// Nothing with ground below fewer than three wheels.
    #[pyo3(signature = (points, heading, wheels, *, out = None))]
    fn stance<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        heading: &Bound<'py, PyAny>,
        wheels: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        crate::sensing::stance(py, &self.0, points, heading, wheels, out)
    }

    /// Pieces of lanes whose beginning can be reached within a limit [m, or s by time], nearest first.
    #[pyo3(signature = (start, limit, *, vehicle = "passengerCar", by = "length", lane_change = None, factors = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn reachable<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'py, PyAny>,
        limit: f64,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        crate::route::reachable(py, &self.0, start, limit, vehicle, &cost, false)
    }

    /// Pieces of lanes from whose beginning a place can be reached within a limit [m, or s by time], nearest first.
    #[pyo3(signature = (goal, limit, *, vehicle = "passengerCar", by = "length", lane_change = None, factors = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn reachable_to<'py>(
        &self,
        py: Python<'py>,
        goal: &Bound<'py, PyAny>,
        limit: f64,
        vehicle: &str,
        by: &str,
        lane_change: Option<f64>,
        factors: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let cost = crate::route::Cost::named(by, lane_change, factors)?;
        crate::route::reachable(py, &self.0, goal, limit, vehicle, &cost, true)
    }

    /// All sequences of lanes that one can follow without a change of lane, until each is `distance` [m] long; at most 1,024.
    #[pyo3(signature = (start, distance, *, vehicle = "passengerCar"))]
    fn lane_sequences_ahead<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'py, PyAny>,
        distance: f64,
        vehicle: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        crate::route::sequences(py, &self.0, start, distance, vehicle)
    }

    /// Signals for traffic that goes on without a change of lane, up to a distance [m].
    #[pyo3(signature = (start, distance, *, vehicle = "passengerCar"))]
    fn signals_ahead<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'py, PyAny>,
        distance: f64,
        vehicle: &str,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        crate::route::signals_ahead(py, &self.0, start, distance, vehicle)
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

/// Three numbers for each row of two or three.
fn converted<'py>(
    py: Python<'py>,
    what: &Bound<'py, PyAny>,
    name: &str,
    class: &str,
    ask: impl Fn(&[f64]) -> Result<[f64; 3], mapd_client::geodesy::ProjectionError> + Sync,
) -> PyResult<Bound<'py, PyAny>> {
    let said = |row: usize, error: mapd_client::geodesy::ProjectionError| {
        raise("ProjectionError", format!("row {row}: {error}"))
    };
    if let Some(one) = crate::input::one(what, name, &[2, 3])? {
        let [a, b, c] = ask(&one).map_err(|error| said(0, error))?;
        return Ok(pyo3::types::PyTuple::new(py, [a, b, c])?.into_any());
    }
    let rows = Rows::of(what, name, &[2, 3])?;
    let found = py.detach(|| {
        let mut found: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::with_capacity(rows.len()));
        for (row, one) in rows.rows().enumerate() {
            let values = ask(one).map_err(|error| (row, error))?;
            found.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        }
        Ok(found)
    });
    let found = found.map_err(|(row, error)| said(row, error))?;
    columns(py, class, found.into_iter().map(Column::Numbers).collect(), None)
}
