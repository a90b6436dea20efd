//! The ground below places, and the road marks beside them.

use crate::batch::{answer, fields, result};
use crate::errors::query;
use crate::held::{Held, content, id};
use crate::input::{NONE_ID, Rows, one_point, types_of};
use crate::lane::Lane;
use crate::room::{Column, Room};
use mapd_client::localisation::{Ground, GroundScratch, MarkFilter, MarkKinds, NearMark, Side};
use mapd_client::{LaneId, LaneTypes};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::sync::Arc;

/// z, normal, s and t.
fn ground_values(ground: &Ground<'_>) -> [f64; 6] {
    let n = ground.normal;
    [ground.z, n.x, n.y, n.z, ground.s, ground.t]
}

/// The ground at a point, or at many.
pub(crate) fn ground_at<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    points: &Bound<'py, PyAny>,
    expected: &[LaneId],
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    let map = held.map();
    if let Some(point) = one_point(points, "points")? {
        let found = map.ground_at(point, expected, &mut GroundScratch::default());
        let Some(ground) = found.map_err(query)? else {
            return Ok(None);
        };
        let [z, nx, ny, nz, s, t] = ground_values(&ground);
        let fields = fields!(
            py,
            z = z,
            nx = nx,
            ny = ny,
            nz = nz,
            s = s,
            t = t,
            lane = Lane::new(held, ground.lane.row()),
            level = ground.level,
            levels = ground.levels,
        );
        return result(py, "Ground", &fields).map(Some);
    }
    let mut room = Room::of(py, "Grounds", out)?;
    let points = Rows::of(points, "points", &[2, 3], &mut room)?;
    let (numbers, lanes, levels) = answer(py, || {
        let content = content(map);
        let mut numbers: [Vec<f64>; 6] = room.numbers(points.len());
        let mut lanes: Vec<u64> = room.take(points.len());
        let mut levels: [Vec<i64>; 2] = std::array::from_fn(|_| room.take(points.len()));
        for (row, point) in points.points().enumerate() {
            let found = map.ground_at(point, expected, &mut room.ground);
            let found = found.map_err(|error| (row, error))?;
            let values = found.as_ref().map_or([f64::NAN; 6], ground_values);
            numbers.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
            lanes.push(found.as_ref().map_or(NONE_ID, |ground| id(content, ground.lane.row())));
            let own = found.as_ref().map_or([0, 0], |ground| [ground.level, ground.levels]);
            levels.iter_mut().zip(own).for_each(|(column, value)| column.push(i64::from(value)));
        }
        points.give(&mut room);
        Ok((numbers, lanes, levels))
    })?;
    let mut all: Vec<_> = numbers.into_iter().map(Column::Numbers).collect();
    all.push(Column::Ids(lanes));
    all.extend(levels.into_iter().map(Column::Counts));
    room.columns(py, "Grounds", all, out).map(Some)
}

/// Which marks count, from what Python names.
pub(crate) fn filter(
    radius: f64,
    kinds: Option<Vec<String>>,
    types: Option<&Bound<'_, PyAny>>,
) -> PyResult<MarkFilter> {
    let kinds = kinds.map_or(Ok(MarkKinds::ALL), |names| {
        names.iter().try_fold(MarkKinds::NONE, |kinds, name| {
            let known =
                mapd_client::vocabulary::RoadMarkKind::ALL.iter().find(|kind| kind.name() == name);
            known.map(|kind| kinds.with(*kind)).ok_or_else(|| {
                let all: Vec<_> = mapd_client::vocabulary::RoadMarkKind::ALL
                    .iter()
                    .map(|kind| kind.name())
                    .collect();
                PyValueError::new_err(format!("kinds: expected some of {all:?}, found {name:?}"))
            })
        })
    })?;
    Ok(MarkFilter {
        radius,
        kinds,
        types: types.map_or(Ok(LaneTypes::ALL), types_of)?,
        ..MarkFilter::default()
    })
}

fn mark_values(mark: &NearMark) -> [f64; 5] {
    [mark.s, mark.place.x, mark.place.y, mark.distance, mark.width]
}

/// Left 1, right −1; kind; colour; painted 1, gap 0, unknown −1.
fn mark_codes(mark: &NearMark) -> [i8; 4] {
    [
        if mark.side_of_reference_line == Side::Left { 1 } else { -1 },
        mark.kind.code() as i8,
        mark.color.code() as i8,
        mark.painted.map_or(-1, i8::from),
    ]
}

/// The road mark nearest to a point, or to each of many.
pub(crate) fn nearest_mark<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    points: &Bound<'py, PyAny>,
    filter: &MarkFilter,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    let map = held.map();
    if let Some(point) = one_point(points, "points")? {
        let Some(mark) = map.nearest_mark(point.xy, filter).map_err(query)? else {
            return Ok(None);
        };
        let [s, x, y, distance, width] = mark_values(&mark);
        let fields = fields!(
            py,
            lane = Lane::new(held, mark.lane.row()),
            s = s,
            x = x,
            y = y,
            distance = distance,
            width = width,
            side = mark.side_of_reference_line.name(),
            kind = mark.kind.name(),
            color = mark.color.name(),
            painted = mark.painted,
        );
        return result(py, "NearMark", &fields).map(Some);
    }
    let mut room = Room::of(py, "NearMarks", out)?;
    let points = Rows::of(points, "points", &[2, 3], &mut room)?;
    let (lanes, numbers, codes) = answer(py, || {
        let content = content(map);
        let mut lanes: Vec<u64> = room.take(points.len());
        let mut numbers: [Vec<f64>; 5] = room.numbers(points.len());
        let mut codes: [Vec<i8>; 4] = std::array::from_fn(|_| room.take(points.len()));
        const NONE: [f64; 5] = [f64::NAN, f64::NAN, f64::NAN, f64::INFINITY, f64::NAN];
        for (row, point) in points.points().enumerate() {
            let found = map.nearest_mark(point.xy, filter).map_err(|error| (row, error))?;
            lanes.push(found.map_or(NONE_ID, |mark| id(content, mark.lane.row())));
            let values = found.as_ref().map_or(NONE, mark_values);
            numbers.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
            let own = found.as_ref().map_or([0, 0, 0, -1], mark_codes);
            codes.iter_mut().zip(own).for_each(|(column, value)| column.push(value));
        }
        points.give(&mut room);
        Ok((lanes, numbers, codes))
    })?;
    let mut all = vec![Column::Ids(lanes)];
    all.extend(numbers.into_iter().map(Column::Numbers));
    all.extend(codes.into_iter().map(Column::Codes));
    room.columns(py, "NearMarks", all, out).map(Some)
}
