//! Batches: columns that are filled without the interpreter's lock.

use crate::errors::query_in_row;
use crate::held::{Held, id};
use crate::input::NONE_ID;
use crate::room::{Column, Room};
use crate::signal::Signal;
use mapd_client::batch::{self, NearestLanes};
use mapd_client::roads::Material;
use mapd_client::rules::{OvertakingRule, SpeedRule};
use mapd_client::{Clamped, LaneId, LanePosition, Pose, QueryError};
use numpy::IntoPyArray;
use numpy::ndarray::Array2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Columns of a class of `mapd._columns`, in the order in which it names them.
pub(crate) fn columns<'py>(
    py: Python<'py>,
    class: &str,
    columns: Vec<Column>,
) -> PyResult<Bound<'py, PyAny>> {
    Box::<Room>::default().columns(py, class, columns, None)
}

/// A result of a class of `mapd._results`.
pub(crate) fn result<'py>(
    py: Python<'py>,
    class: &str,
    fields: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyAny>> {
    py.import("mapd._results")?.getattr(class)?.call((), Some(fields))
}

/// Makes a dictionary of fields.
macro_rules! fields {
    ($py:expr, $($name:ident = $value:expr),* $(,)?) => {{
        let fields = pyo3::types::PyDict::new($py);
        $(fields.set_item(stringify!($name), $value)?;)*
        fields
    }};
}
pub(crate) use fields;

/// An array of shape (N, 3).
pub(crate) fn triples<'py>(py: Python<'py>, numbers: Vec<f64>) -> PyResult<Bound<'py, PyAny>> {
    let rows = numbers.len() / 3;
    let array = Array2::from_shape_vec((rows, 3), numbers)
        .map_err(|error| pyo3::exceptions::PyRuntimeError::new_err(error.to_string()))?;
    Ok(array.into_pyarray(py).into_any())
}

/// Answers row by row without the interpreter's lock.
///
/// Errors: that of the first row that has none, with its number.
pub(crate) fn answer<T: Send>(
    py: Python<'_>,
    ask: impl FnOnce() -> Result<T, (usize, QueryError)> + Send,
) -> PyResult<T> {
    py.detach(ask).map_err(query_in_row)
}

/// The row of a batch's error, and the error as of a single place.
pub(crate) fn in_row(error: QueryError) -> (usize, QueryError) {
    match error {
        QueryError::NotFiniteAt(row) => (row, QueryError::NotFinite),
        other => (0, other),
    }
}

/// −1 before, 0 within, 1 after.
pub(crate) fn clamped_code(clamped: Clamped) -> i8 {
    match clamped {
        Clamped::No => 0,
        Clamped::Before => -1,
        Clamped::After => 1,
    }
}

/// Codes of what is clamped.
fn codes(clamped: Vec<Clamped>, room: &mut Room) -> Vec<i8> {
    let mut codes = room.take(clamped.len());
    codes.extend(clamped.iter().copied().map(clamped_code));
    room.give(clamped);
    codes
}

/// Empty columns of nearest lanes.
pub(crate) fn nearest(rows: usize, room: &mut Room) -> NearestLanes {
    let [s, t, offset, distance, z, heading, heading_of_reference_line] = room.numbers(rows);
    NearestLanes {
        lane: room.take(rows),
        s,
        t,
        offset,
        distance,
        z,
        heading,
        heading_of_reference_line,
        clamped: room.take(rows),
    }
}

/// Columns of places on lanes.
#[derive(Default)]
pub(crate) struct Positions {
    pub(crate) lane: Vec<u64>,
    numbers: [Vec<f64>; 6],
    clamped: Vec<i8>,
    of_reference_line: [Vec<f64>; 2],
}

/// What stands in `of_reference_line` where no lane is.
const NOWHERE: [f64; 2] = [f64::NAN; 2];

impl Positions {
    pub(crate) fn with_room(rows: usize, room: &mut Room) -> Self {
        Self {
            lane: room.take(rows),
            numbers: room.numbers(rows),
            clamped: room.take(rows),
            of_reference_line: room.numbers(rows),
        }
    }

    /// Nearest lanes as they are; [`nearest`] has their memory.
    pub(crate) fn of(content: u32, found: NearestLanes, room: &mut Room) -> Self {
        let mut turned = room.take(found.len());
        turned.extend((0..found.len()).filter_map(|i| found.offset_of_reference_line(i)));
        let NearestLanes {
            lane,
            s,
            t,
            offset,
            distance,
            z,
            heading,
            heading_of_reference_line,
            clamped,
        } = found;
        let mut ids = room.take(lane.len());
        let id_of = |lane: LaneId| id(content, lane.row());
        ids.extend(lane.iter().map(|lane| lane.map_or(NONE_ID, id_of)));
        room.give(lane);
        Self {
            lane: ids,
            numbers: [s, t, offset, distance, z, heading],
            clamped: codes(clamped, room),
            of_reference_line: [turned, heading_of_reference_line],
        }
    }

    fn push_of_reference_line(&mut self, values: [f64; 2]) {
        self.of_reference_line.iter_mut().zip(values).for_each(|(column, one)| column.push(one));
    }

    #[inline]
    pub(crate) fn push(&mut self, content: u32, row: u32, at: &LanePosition) {
        self.lane.push(id(content, row));
        let values = [at.s, at.t, at.offset, at.distance, at.z, at.heading];
        self.numbers.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        self.clamped.push(clamped_code(at.clamped));
        self.push_of_reference_line([at.offset_of_reference_line, at.heading_of_reference_line]);
    }

    /// A row for a point that is near no lane.
    #[inline]
    pub(crate) fn push_none(&mut self) {
        self.lane.push(NONE_ID);
        let values = [f64::NAN, f64::NAN, f64::NAN, f64::INFINITY, f64::NAN, f64::NAN];
        self.numbers.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        self.clamped.push(0);
        self.push_of_reference_line(NOWHERE);
    }

    pub(crate) fn columns(self) -> Vec<Column> {
        let mut columns = vec![Column::Ids(self.lane)];
        columns.extend(self.numbers.into_iter().map(Column::Numbers));
        columns.push(Column::Codes(self.clamped));
        columns.extend(self.of_reference_line.into_iter().map(Column::Numbers));
        columns
    }
}

/// Fields of a point in a lane's coordinates, to which callers add theirs.
pub(crate) fn position_fields<'py>(
    py: Python<'py>,
    at: &LanePosition,
) -> PyResult<Bound<'py, PyDict>> {
    Ok(fields!(
        py,
        s = at.s,
        t = at.t,
        offset = at.offset,
        distance = at.distance,
        z = at.z,
        heading = at.heading,
        clamped = clamped_code(at.clamped),
        offset_of_reference_line = at.offset_of_reference_line,
        heading_of_reference_line = at.heading_of_reference_line,
    ))
}

/// Words of speed limits' origins; columns hold their places.
pub(crate) const SPEED_ORIGINS: [&str; 7] =
    ["written", "sign", "entry", "default", "depends", "unknown", "overlay"];

/// Columns of speed limits.
pub(crate) struct Speeds {
    max: Vec<f64>,
    origin: Vec<i8>,
}

impl Speeds {
    pub(crate) fn with_room(rows: usize, room: &mut Room) -> Self {
        Self { max: room.take(rows), origin: room.take(rows) }
    }

    pub(crate) fn push(&mut self, rule: &SpeedRule) {
        let name = rule.origin.name();
        self.max.push(rule.max.unwrap_or(f64::NAN));
        let place = SPEED_ORIGINS.iter().position(|one| *one == name);
        self.origin.push(place.map_or(-1, |place| place as i8));
    }

    pub(crate) fn columns(self) -> Vec<Column> {
        vec![Column::Numbers(self.max), Column::Codes(self.origin)]
    }
}

/// A speed limit as a result.
pub(crate) fn speed_rule<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    rule: &SpeedRule,
) -> PyResult<Bound<'py, PyAny>> {
    let signal = rule.signal.map(|signal| Signal::new(held, signal));
    let fields = fields!(py, max = rule.max, origin = rule.origin.name(), signal = signal);
    result(py, "SpeedRule", &fields)
}

/// What `<material>` says of a surface.
pub(crate) fn material<'py>(
    py: Python<'py>,
    material: Option<Material<'_>>,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    let Some(one) = material else { return Ok(None) };
    let fields = fields!(
        py,
        s = one.s,
        surface = one.surface,
        friction = one.friction,
        roughness = one.roughness,
    );
    result(py, "Material", &fields).map(Some)
}

pub(crate) fn overtaking_rule<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    rule: &OvertakingRule,
) -> PyResult<Bound<'py, PyAny>> {
    let [all, trucks] =
        [rule.all, rule.trucks].map(|sign| sign.map(|sign| Signal::new(held, sign)));
    result(py, "OvertakingRule", &fields!(py, all = all, trucks = trucks))
}

/// Columns of poses.
pub(crate) struct Poses {
    numbers: [Vec<f64>; 7],
    clamped: Vec<i8>,
}

impl Poses {
    pub(crate) fn with_room(rows: usize, room: &mut Room) -> Self {
        Self { numbers: room.numbers(rows), clamped: room.take(rows) }
    }

    pub(crate) fn push(&mut self, pose: &Pose) {
        let p = pose.position;
        let values = [p.x, p.y, p.z, pose.heading, pose.curvature, pose.slope, pose.superelevation];
        self.numbers.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        self.clamped.push(clamped_code(pose.clamped));
    }

    pub(crate) fn columns(self) -> Vec<Column> {
        let mut columns: Vec<_> = self.numbers.into_iter().map(Column::Numbers).collect();
        columns.push(Column::Codes(self.clamped));
        columns
    }
}

/// Empty columns of a batch's poses.
pub(crate) fn poses(rows: usize, room: &mut Room) -> batch::Poses {
    let [x, y, z, heading, curvature, slope, superelevation] = room.numbers(rows);
    let clamped = room.take(rows);
    batch::Poses { x, y, z, heading, curvature, slope, superelevation, clamped }
}

/// Columns of a batch's poses.
pub(crate) fn pose_columns(poses: batch::Poses, room: &mut Room) -> Vec<Column> {
    let batch::Poses { x, y, z, heading, curvature, slope, superelevation, clamped } = poses;
    let numbers = [x, y, z, heading, curvature, slope, superelevation];
    let mut columns: Vec<_> = numbers.into_iter().map(Column::Numbers).collect();
    columns.push(Column::Codes(codes(clamped, room)));
    columns
}

/// Empty columns of feet on a road's reference line.
pub(crate) fn feet(rows: usize, room: &mut Room) -> batch::TrackPositions {
    let [s, t, h, distance] = room.numbers(rows);
    batch::TrackPositions { s, t, h, distance, clamped: room.take(rows), exact: room.take(rows) }
}

/// Columns of feet on a road's reference line.
pub(crate) fn track_columns(feet: batch::TrackPositions, room: &mut Room) -> Vec<Column> {
    let batch::TrackPositions { s, t, h, distance, clamped, exact } = feet;
    let mut columns: Vec<_> = [s, t, h, distance].into_iter().map(Column::Numbers).collect();
    columns.push(Column::Codes(codes(clamped, room)));
    columns.push(Column::Flags(exact));
    columns
}

/// A pose as a result.
pub(crate) fn pose<'py>(py: Python<'py>, pose: &Pose) -> PyResult<Bound<'py, PyAny>> {
    let p = pose.position;
    let fields = fields!(
        py,
        x = p.x,
        y = p.y,
        z = p.z,
        heading = pose.heading,
        curvature = pose.curvature,
        slope = pose.slope,
        superelevation = pose.superelevation,
        clamped = clamped_code(pose.clamped),
    );
    result(py, "Pose", &fields)
}
