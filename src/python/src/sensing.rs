//! What sensors and wheels meet: landmarks, paint, the plane below a vehicle.

use crate::batch::{answer, columns, fields, in_row, result};
use crate::errors::query;
use crate::held::{Held, content, id};
use crate::input::{NONE_ID, Rows, column, one_point};
use crate::object::Object;
use crate::room::{Column, Room};
use crate::signal::Signal;
use mapd_client::glam::DVec2;
use mapd_client::localisation::{
    GroundScratch, Landmark, LandmarkSource, MarkFilter, MarkPoint, MarkSource, Sensor, Stance,
    VehiclePose,
};
use mapd_client::vocabulary::ClassSet;
use mapd_client::{LaneId, Region};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::Arc;

pub(crate) fn landmark<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    one: &Landmark,
) -> PyResult<Bound<'py, PyAny>> {
    let (signal, object, copy) = match one.source {
        LandmarkSource::Signal(signal) => (Some(Signal::new(held, signal)), None, None),
        LandmarkSource::Object(place) => (None, Some(Object::new(held, place.object)), place.copy),
    };
    let fields = fields!(
        py,
        signal = signal,
        object = object,
        copy = copy,
        meaning = one.class.name(),
        x = one.position.x,
        y = one.position.y,
        z = one.position.z,
        heading = one.heading,
        length = one.size[0],
        width = one.size[1],
        height = one.size[2],
        distance = one.distance,
    );
    result(py, "Landmark", &fields)
}

/// Landmarks near a point.
pub(crate) fn landmarks_near<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    point: (f64, f64),
    radius: f64,
    classes: ClassSet,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let (point, mut found) = (DVec2::new(point.0, point.1), Vec::new());
    let map = held.map();
    py.detach(|| map.landmarks_near(point, radius, classes, &mut found)).map_err(query)?;
    found.iter().map(|one| landmark(py, held, one)).collect()
}

/// Landmarks that a sensor sees.
pub(crate) fn landmarks_in_view<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    sensor: &Sensor,
    classes: ClassSet,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let (map, mut found) = (held.map(), Vec::new());
    py.detach(|| map.landmarks_in_view(sensor, classes, &mut found)).map_err(query)?;
    let one = |seen: &mapd_client::localisation::LandmarkInView| {
        let landmark = landmark(py, held, &seen.landmark)?;
        let fields = fields!(py, landmark = landmark, bearing = seen.bearing, facing = seen.facing);
        result(py, "LandmarkInView", &fields)
    };
    found.iter().map(one).collect()
}

/// Points along paint and kerbs in a rectangle.
pub(crate) fn mark_points<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    region: Region,
    spacing: f64,
    filter: &MarkFilter,
) -> PyResult<Bound<'py, PyAny>> {
    let map = held.map();
    let found = py
        .detach(|| {
            let mut found = Vec::new();
            map.mark_points(region, spacing, filter, &mut found).map(|()| found)
        })
        .map_err(query)?;
    let content = content(map);
    let lane = |one: &MarkPoint| match one.source {
        MarkSource::Lane(lane) => Some(lane),
        MarkSource::Line(_) | MarkSource::Outline(_) => None,
    };
    let place = |one: &MarkPoint| match one.source {
        MarkSource::Lane(_) => None,
        MarkSource::Line(place) | MarkSource::Outline(place) => Some(place),
    };
    let copy = |one: &MarkPoint| place(one).and_then(|place| place.copy);
    let numbers = |of: fn(&MarkPoint) -> f64| Column::Numbers(found.iter().map(of).collect());
    let codes =
        |of: fn(&MarkPoint) -> u8| Column::Codes(found.iter().map(|one| of(one) as i8).collect());
    let all = vec![
        numbers(|one| one.position.x),
        numbers(|one| one.position.y),
        numbers(|one| one.position.z),
        Column::Ids(
            found
                .iter()
                .map(|one| lane(one).map_or(NONE_ID, |lane| id(content, lane.row())))
                .collect(),
        ),
        numbers(|one| one.s),
        numbers(|one| one.width),
        codes(|one| one.kind.code()),
        codes(|one| one.color.code()),
        Column::Ids(
            found
                .iter()
                .map(|one| place(one).map_or(NONE_ID, |at| id(content, at.object.row())))
                .collect(),
        ),
        Column::Counts(found.iter().map(|one| copy(one).map_or(-1, i64::from)).collect()),
        Column::Codes(
            found.iter().map(|one| matches!(one.source, MarkSource::Outline(_)).into()).collect(),
        ),
    ];
    columns(py, "MarkPoints", all)
}

/// Four wheels, from an array of shape (4, 2).
fn wheels_of(what: &Bound<'_, PyAny>) -> PyResult<[DVec2; 4]> {
    let rows = Rows::of(what, "wheels", &[2], &mut Room::default())?;
    let all: Vec<DVec2> = rows.points().map(|point| point.xy).collect();
    all.try_into().map_err(|all: Vec<DVec2>| {
        PyValueError::new_err(format!(
            "wheels: expected an array of shape (4, 2), found ({}, 2)",
            all.len()
        ))
    })
}

fn values(stance: Option<&Stance>) -> [f64; 7] {
    let Some(own) = stance else { return [f64::NAN; 7] };
    let [a, b, c, d] = own.wheels.map(|wheel| wheel.unwrap_or(f64::NAN));
    [own.z, own.roll, own.pitch, a, b, c, d]
}

/// How a vehicle stands, or many.
pub(crate) fn stance<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    points: &Bound<'py, PyAny>,
    heading: &Bound<'py, PyAny>,
    wheels: &Bound<'py, PyAny>,
    expected: &[LaneId],
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    let (map, wheels) = (held.map(), wheels_of(wheels)?);
    if let Some(position) = one_point(points, "points")? {
        let pose = VehiclePose { position, heading: heading.extract()? };
        let found = map.stance(&pose, &wheels, expected, &mut GroundScratch::default());
        let Some(own) = found.map_err(query)? else {
            return Ok(None);
        };
        let wheels = PyTuple::new(py, own.wheels)?;
        let fields = fields!(py, z = own.z, roll = own.roll, pitch = own.pitch, wheels = wheels);
        return result(py, "Stance", &fields).map(Some);
    }
    let mut room = Room::of(py, "Stances", out)?;
    let points = Rows::of(points, "points", &[2, 3], &mut room)?;
    let headings = column(heading, "heading", points.len(), &mut room)?;
    let numbers = answer(py, || {
        let mut numbers: [Vec<f64>; 7] = room.numbers(points.len());
        for (row, position) in points.points().enumerate() {
            let pose = VehiclePose { position, heading: headings[row] };
            let found = map.stance(&pose, &wheels, expected, &mut room.ground);
            let found = found.map_err(|error| (row, in_row(error).1))?;
            let values = values(found.as_ref());
            numbers.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        }
        points.give(&mut room);
        room.give(headings);
        Ok(numbers)
    })?;
    let all = numbers.into_iter().map(Column::Numbers).collect();
    room.columns(py, "Stances", all, out).map(Some)
}
