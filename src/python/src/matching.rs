//! Which lanes vehicles may be in, by poses or by a trace.

use crate::batch::{Positions, columns, fields, position_fields, result};
use crate::errors::{match_in_row, matching};
use crate::held::{Held, content};
use crate::input::{Rows, column, matrices, one_point};
use crate::lane::Lane;
use crate::room::{Column, Room};
use mapd_client::glam::DMat3;
use mapd_client::localisation::{
    LaneMatch, MatchError, TraceFix, TraceOptions, VehicleOutline, VehiclePose,
};
use pyo3::prelude::*;
use std::sync::Arc;

/// An outline of a caller's.
pub(crate) fn outline([front, back, left, right]: [f64; 4]) -> VehicleOutline {
    VehicleOutline { front, back, left, right }
}

/// A covariance for each of `rows` poses: one matrix for all, or as many.
pub(crate) struct Covariances {
    numbers: Vec<f64>,
}

impl Covariances {
    pub(crate) fn of(what: &Bound<'_, PyAny>, rows: usize, room: &mut Room) -> PyResult<Self> {
        Ok(Self { numbers: matrices(what, "covariance", rows, room)? })
    }

    pub(crate) fn of_row(&self, row: usize) -> DMat3 {
        let begin = if self.numbers.len() == 9 { 0 } else { 9 * row };
        let mut own = [0.0; 9];
        own.copy_from_slice(&self.numbers[begin..begin + 9]);
        DMat3::from_cols_array(&own).transpose()
    }

    /// Leaves their memory with the room.
    pub(crate) fn give(self, room: &mut Room) {
        room.give(self.numbers);
    }
}

pub(crate) fn lane_match<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    found: &LaneMatch,
) -> PyResult<Bound<'py, PyAny>> {
    let fields = position_fields(py, &found.position)?;
    fields.set_item("lane", Lane::new(held, found.lane.row()))?;
    fields.set_item("forward", found.forward)?;
    fields.set_item("probability", found.probability)?;
    fields.set_item("mahalanobis", found.mahalanobis)?;
    fields.set_item("heading_difference", found.heading_difference)?;
    result(py, "LaneMatch", &fields)
}

/// The lanes that a vehicle may be in, or each of many, as `ask` matches a pose.
pub(crate) fn match_pose<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    points: &Bound<'py, PyAny>,
    heading: &Bound<'py, PyAny>,
    covariance: &Bound<'py, PyAny>,
    ask: impl Fn(&VehiclePose, &DMat3, &mut Vec<LaneMatch>) -> Result<f64, MatchError> + Sync,
) -> PyResult<Bound<'py, PyAny>> {
    let map = held.map();
    let mut near = Vec::new();
    if let Some(position) = one_point(points, "points")? {
        let pose = VehiclePose { position, heading: heading.extract()? };
        let covariance = Covariances::of(covariance, 1, &mut Room::default())?;
        let none = ask(&pose, &covariance.of_row(0), &mut near);
        let none = none.map_err(matching)?;
        let lanes = near.iter().map(|found| lane_match(py, held, found));
        let lanes = pyo3::types::PyTuple::new(py, lanes.collect::<PyResult<Vec<_>>>()?)?;
        return result(py, "PoseMatch", &fields!(py, none = none, lanes = lanes));
    }
    let mut room = Room::default();
    let points = Rows::of(points, "points", &[2, 3], &mut room)?;
    let headings = column(heading, "heading", points.len(), &mut room)?;
    let covariance = Covariances::of(covariance, points.len(), &mut room)?;
    let all = py.detach(|| {
        let content = content(map);
        let (mut of, mut forward) = (Vec::new(), Vec::new());
        let mut numbers: [Vec<f64>; 3] = Default::default();
        let mut found = Positions::default();
        for (row, position) in points.points().enumerate() {
            let pose = VehiclePose { position, heading: headings[row] };
            let none = ask(&pose, &covariance.of_row(row), &mut near);
            let none = none.map_err(|error| (row, error))?;
            let mut push = |is_forward: bool, values: [f64; 3]| {
                of.push(row as i64);
                forward.push(is_forward);
                numbers.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
            };
            for one in &near {
                push(one.forward, [one.probability, one.mahalanobis, one.heading_difference]);
                found.push(content, one.lane.row(), &one.position);
            }
            push(false, [none, f64::NAN, f64::NAN]);
            found.push_none();
        }
        let mut all = vec![Column::Counts(of), Column::Flags(forward)];
        all.extend(numbers.into_iter().map(Column::Numbers));
        all.extend(found.columns());
        Ok(all)
    });
    columns(py, "LaneMatches", all.map_err(match_in_row)?)
}

/// Where each fix of a trace was.
pub(crate) fn match_trace<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    time: &Bound<'py, PyAny>,
    points: &Bound<'py, PyAny>,
    heading: Option<&Bound<'py, PyAny>>,
    options: &TraceOptions,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let mut room = Room::of(py, "TraceMatches", out)?;
    let points = Rows::of(points, "points", &[2, 3], &mut room)?;
    let rows = points.len();
    let time = column(time, "time", rows, &mut room)?;
    let headings =
        heading.map(|heading| column(heading, "heading", rows, &mut room)).transpose()?;
    let all = py
        .detach(|| {
            room.fixes.clear();
            room.fixes.extend(points.points().enumerate().map(|(row, position)| TraceFix {
                time: time[row],
                position,
                heading: headings.as_ref().map(|all| all[row]).filter(|heading| !heading.is_nan()),
            }));
            points.give(&mut room);
            [Some(time), headings].into_iter().flatten().for_each(|column| room.give(column));
            let Room { fixes, trace, matches, .. } = &mut *room;
            held.map().match_trace(fixes, options, trace, matches)?;
            let content = content(held.map());
            let mut places = Positions::with_room(rows, &mut room);
            let (mut forward, mut probability) = (room.take(rows), room.take(rows));
            for one in &room.matches {
                match &one.place {
                    Some(place) => places.push(content, place.lane.row(), &place.position),
                    None => places.push_none(),
                }
                forward.push(one.forward);
                probability.push(one.probability);
            }
            let mut all = vec![Column::Flags(forward), Column::Numbers(probability)];
            all.extend(places.columns());
            Ok::<_, MatchError>(all)
        })
        .map_err(matching)?;
    room.columns(py, "TraceMatches", all, out)
}
