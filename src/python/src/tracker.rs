//! The lane of a vehicle that drives, from fix to fix.

use crate::batch::{Positions, fields, result};
use crate::errors::{match_in_row, matching};
use crate::held::{Held, content};
use crate::input::{Rows, column, lanes_of, one_point, types_of, vehicle_of};
use crate::map::Map;
use crate::matching::{Covariances, lane_match};
use crate::room::{Column, Room};
use mapd_client::localisation::{
    MatchOptions, Tracked, TrackerFix, TrackerOptions, VehicleOutline, VehiclePose,
};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{LaneId, LaneTypes};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::{Arc, Mutex, PoisonError};

/// Words of what a tracker says, in the order of the codes in columns.
pub(crate) const STATES: [&str; 3] = ["lane", "no_lane", "unknown"];

/// Options, but for the lanes that are expected.
struct Options {
    types: LaneTypes,
    z_tolerance: Option<f64>,
    drive_deviation: f64,
    none: f64,
    vehicle: Option<VehicleClass>,
    closed: f64,
    unexpected: f64,
    outline: Option<VehicleOutline>,
    change_interval: f64,
    correlation_time: f64,
    memory: f64,
    enough: f64,
}

impl Options {
    fn with<'a>(&self, expected: &'a [LaneId]) -> TrackerOptions<'a> {
        TrackerOptions {
            matching: MatchOptions {
                types: self.types,
                z_tolerance: self.z_tolerance,
                drive_deviation: self.drive_deviation,
                none: self.none,
                vehicle: self.vehicle,
                closed: self.closed,
                expected,
                unexpected: self.unexpected,
                outline: self.outline,
            },
            change_interval: self.change_interval,
            correlation_time: self.correlation_time,
            memory: self.memory,
            enough: self.enough,
        }
    }
}

struct State {
    tracker: mapd_client::localisation::Tracker,
    /// The map of the last fix.
    held: Option<Arc<Held>>,
}

/// The lane of a vehicle that drives, from fix to fix (docs/localisation.md). Threads that share it wait for each other.
///
/// `change_interval` [s] is the mean time between changes of lane, `correlation_time` [s] that over which errors of fixes are alike, `memory` [s] the time without a fix after
/// which it begins anew, `enough` the probability from which a lane, or none, is the answer. Other options are those of Map.match_pose; `types` are those that motor vehicles
/// travel on.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct Tracker {
    state: Mutex<State>,
    options: Options,
}

impl Tracker {
    /// Runs with the state, which no other thread has meanwhile; the interpreter is not locked, as another thread may need it.
    fn with<T: Send>(&self, py: Python<'_>, run: impl FnOnce(&mut State) -> T + Send) -> T {
        py.detach(|| run(&mut self.state.lock().unwrap_or_else(PoisonError::into_inner)))
    }
}

#[pymethods]
impl Tracker {
    #[new]
    #[pyo3(signature = (*, types = None, z_tolerance = None, drive_deviation = 0.1, none = 0.01, vehicle = None,
        closed = 0.05, unexpected = 0.05, change_interval = 30.0, correlation_time = 0.0, memory = 30.0, enough = 0.5,
        outline = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn new(
        types: Option<&Bound<'_, PyAny>>,
        z_tolerance: Option<f64>,
        drive_deviation: f64,
        none: f64,
        vehicle: Option<&str>,
        closed: f64,
        unexpected: f64,
        change_interval: f64,
        correlation_time: f64,
        memory: f64,
        enough: f64,
        outline: Option<[f64; 4]>,
    ) -> PyResult<Self> {
        let options = Options {
            types: types.map_or(Ok(LaneTypes::routable()), types_of)?,
            z_tolerance,
            drive_deviation,
            none,
            vehicle: vehicle.map(vehicle_of).transpose()?,
            closed,
            unexpected,
            outline: outline.map(crate::matching::outline),
            change_interval,
            correlation_time,
            memory,
            enough,
        };
        let tracker = mapd_client::localisation::Tracker::new();
        Ok(Self { state: Mutex::new(State { tracker, held: None }), options })
    }

    /// Takes the next fix, or many in their order: time [s] that does not fall, heading [rad], covariance as of Map.match_pose.
    ///
    /// `odometer` is the way driven since any beginning [m], NaN where it is not known.
    #[pyo3(signature = (map, time, points, heading, covariance, *, odometer = None, expected = None, out = None))]
    #[expect(clippy::too_many_arguments, reason = "options by name, as Python has them")]
    fn update<'py>(
        &self,
        py: Python<'py>,
        map: &Bound<'py, Map>,
        time: &Bound<'py, PyAny>,
        points: &Bound<'py, PyAny>,
        heading: &Bound<'py, PyAny>,
        covariance: &Bound<'py, PyAny>,
        odometer: Option<&Bound<'py, PyAny>>,
        expected: Option<Vec<Bound<'py, PyAny>>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let held = map.get().held();
        let expected = lanes_of(held.map(), expected.as_deref())?;
        let options = self.options.with(&expected);
        if let Some(position) = one_point(points, "points")? {
            let fix = TrackerFix {
                time: time.extract()?,
                pose: VehiclePose { position, heading: heading.extract()? },
                covariance: Covariances::of(covariance, 1, &mut Room::default())?.of_row(0),
                odometer: odometer.map(|way| way.extract()).transpose()?,
            };
            let found = self.with(py, |state| {
                let found = state.tracker.update(held.map(), &fix, &options);
                if found.is_ok() {
                    state.held = Some(Arc::clone(held));
                }
                found
            });
            let (state, found) = match found.map_err(matching)? {
                Tracked::Lane(found) => (STATES[0], Some(lane_match(py, held, &found)?)),
                Tracked::NoLane => (STATES[1], None),
                Tracked::Unknown => (STATES[2], None),
            };
            return result(py, "Tracked", &fields!(py, state = state, found = found));
        }
        let mut room = Room::of(py, "TrackedFixes", out)?;
        let points = Rows::of(points, "points", &[2, 3], &mut room)?;
        let rows = points.len();
        let time = column(time, "time", rows, &mut room)?;
        let headings = column(heading, "heading", rows, &mut room)?;
        let covariances = Covariances::of(covariance, rows, &mut room)?;
        let ways = odometer.map(|way| column(way, "odometer", rows, &mut room)).transpose()?;
        let all = self.with(py, |state| {
            let content = content(held.map());
            let (mut states, mut forward) = (room.take(rows), room.take(rows));
            let mut numbers: [Vec<f64>; 2] = room.numbers(rows);
            let mut places = Positions::with_room(rows, &mut room);
            for (row, position) in points.points().enumerate() {
                let way = ways.as_ref().map(|all| all[row]).filter(|way| !way.is_nan());
                let fix = TrackerFix {
                    time: time[row],
                    pose: VehiclePose { position, heading: headings[row] },
                    covariance: covariances.of_row(row),
                    odometer: way,
                };
                let found = state.tracker.update(held.map(), &fix, &options);
                let found = found.map_err(|error| (row, error))?;
                state.held = Some(Arc::clone(held));
                let (code, is_forward, probability) = match found {
                    Tracked::Lane(found) => {
                        places.push(content, found.lane.row(), &found.position);
                        (0, found.forward, found.probability)
                    }
                    other => {
                        places.push_none();
                        (if other == Tracked::NoLane { 1 } else { 2 }, false, f64::NAN)
                    }
                };
                states.push(code);
                forward.push(is_forward);
                numbers[0].push(probability);
                numbers[1].push(state.tracker.none());
            }
            let mut all = vec![Column::Codes(states), Column::Flags(forward)];
            all.extend(numbers.into_iter().map(Column::Numbers));
            all.extend(places.columns());
            points.give(&mut room);
            covariances.give(&mut room);
            [Some(time), Some(headings), ways].into_iter().flatten().for_each(|one| room.give(one));
            Ok(all)
        });
        let all = all.map_err(match_in_row)?;
        room.columns(py, "TrackedFixes", all, out)
    }

    /// The lanes that the vehicle may be in, the most probable first, and the probability that it is in none.
    fn hypotheses<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (none, found, held) = self.with(py, |state| {
            (state.tracker.none(), state.tracker.hypotheses().to_vec(), state.held.clone())
        });
        let lanes = held.iter().flat_map(|held| found.iter().map(move |one| (held, one)));
        let lanes = lanes.map(|(held, one)| lane_match(py, held, one));
        let lanes = PyTuple::new(py, lanes.collect::<PyResult<Vec<_>>>()?)?;
        result(py, "PoseMatch", &fields!(py, none = none, lanes = lanes))
    }

    /// Probability that the vehicle is in one of these lanes, such as those of its route.
    fn probability_in(&self, py: Python<'_>, lanes: Vec<Bound<'_, PyAny>>) -> PyResult<f64> {
        let Some(held) = self.with(py, |state| state.held.clone()) else { return Ok(0.0) };
        let lanes = lanes_of(held.map(), Some(&lanes))?;
        Ok(self.with(py, |state| state.tracker.probability_in(&lanes)))
    }

    /// Forgets everything.
    fn reset(&self, py: Python<'_>) {
        self.with(py, |state| {
            state.tracker.reset();
            state.held = None;
        });
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        let (count, none) =
            self.with(py, |state| (state.tracker.hypotheses().len(), state.tracker.none()));
        format!("<mapd.Tracker {count} lanes, none {none:.2}>")
    }
}
