//! What callers give: points, lanes, places, names.

use crate::errors::{query, raise};
use crate::held::content;
use crate::lane::Lane;
use crate::room::{Kept, Room};
use mapd_client::batch::Places;
use mapd_client::compiling::ByRow as _;
use mapd_client::glam::{DVec2, DVec3};
use mapd_client::route::PositionOnLane;
use mapd_client::vocabulary::{Class, ClassSet, LaneType, RoadRules, VehicleClass};
use mapd_client::{LaneKey, LaneTypes, Map, Point, QueryError, Region};
use numpy::{Element, PyArrayDyn, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyString, PyTuple};

/// Stands for "no lane" in columns of ids.
pub(crate) const NONE_ID: u64 = u64::MAX;

/// Rows of numbers, copied while the interpreter is locked: what is answered without the lock cannot change meanwhile.
pub(crate) struct Rows {
    numbers: Vec<f64>,
    pub(crate) width: usize,
}

impl Rows {
    /// An array of shape (N, width) for one of the widths.
    ///
    /// Errors: anything else, by what it is.
    pub(crate) fn of(
        what: &Bound<'_, PyAny>,
        name: &str,
        widths: &[usize],
        room: &mut Room,
    ) -> PyResult<Self> {
        let array = floats(what, name, &shapes(widths))?;
        let shape = array.shape().to_vec();
        match shape.as_slice() {
            [_, width] if widths.contains(width) => {
                Ok(Self { numbers: values(&array, room)?, width: *width })
            }
            _ => Err(PyValueError::new_err(format!(
                "{name}: expected an array of shape {}, found {shape:?}",
                shapes(widths)
            ))),
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.numbers.len() / self.width
    }

    pub(crate) fn rows(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.numbers.chunks_exact(self.width)
    }

    /// The rows' numbers column by column.
    pub(crate) fn columns(&self, room: &mut Room) -> Vec<Vec<f64>> {
        let column = |k: usize| {
            let mut column = room.take(self.len());
            column.extend(self.rows().map(|row| row[k]));
            column
        };
        (0..self.width).map(column).collect()
    }

    /// Leaves their memory with the room.
    pub(crate) fn give(self, room: &mut Room) {
        room.give(self.numbers);
    }

    pub(crate) fn points(&self) -> impl ExactSizeIterator<Item = Point> {
        self.rows().map(point_of)
    }
}

/// Columns of points, x, y and perhaps z, as places.
pub(crate) fn places(columns: &[Vec<f64>]) -> Places<'_> {
    let column = |k: usize| columns.get(k).map(Vec::as_slice);
    let [x, y] = [column(0), column(1)].map(Option::unwrap_or_default);
    Places { x, y, z: column(2), heading: None }
}

fn shapes(widths: &[usize]) -> String {
    let shapes: Vec<_> = widths.iter().map(|width| format!("(N, {width})")).collect();
    shapes.join(" or ")
}

/// A point from x, y and, where there is a third, z.
fn point_of(row: &[f64]) -> Point {
    Point { xy: DVec2::new(row[0], row[1]), z: row.get(2).copied() }
}

/// An array of float64.
fn floats<'py>(
    what: &Bound<'py, PyAny>,
    name: &str,
    shape: &str,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    if let Ok(array) = what.cast::<PyArrayDyn<f64>>() {
        return Ok(array.clone());
    }
    let found = match what.cast::<PyUntypedArray>() {
        Ok(array) => format!("an array of {}", array.dtype()),
        Err(_) => what.get_type().name()?.to_string(),
    };
    Err(PyTypeError::new_err(format!(
        "{name}: expected an array of float64 of shape {shape}, found {found}"
    )))
}

/// An array's values in the order of its rows, whatever its strides.
fn values<'py, T: Kept + Element>(
    array: &Bound<'py, PyArrayDyn<T>>,
    room: &mut Room,
) -> PyResult<Vec<T>> {
    // Fields of packed records lie at any address, where no reference to a number may point.
    let aligned: bool = array.getattr("flags")?.get_item("ALIGNED")?.extract()?;
    let copy;
    let array = if aligned {
        array
    } else {
        copy = array.call_method0("copy")?.cast_into::<PyArrayDyn<T>>()?;
        &copy
    };
    let array = array.try_readonly().map_err(|error| PyValueError::new_err(error.to_string()))?;
    let mut values = room.take(array.len());
    let array = array.as_array();
    // Only what lies row by row: what lies column by column is in one piece, too.
    match array.as_slice() {
        Some(slice) => values.extend_from_slice(slice),
        None => values.extend(array.iter().copied()),
    }
    Ok(values)
}

/// One number for all rows, or an array with one for each.
pub(crate) fn column(
    what: &Bound<'_, PyAny>,
    name: &str,
    rows: usize,
    room: &mut Room,
) -> PyResult<Vec<f64>> {
    if let Ok(number) = what.extract::<f64>() {
        let mut column = room.take(rows);
        column.resize(rows, number);
        return Ok(column);
    }
    let array = floats(what, name, "(N,)")?;
    if array.shape() != [rows] {
        return Err(PyValueError::new_err(format!(
            "{name}: expected an array of shape ({rows},), found {:?}",
            array.shape()
        )));
    }
    values(&array, room)
}

/// An array of any length.
pub(crate) fn column_of_any(
    what: &Bound<'_, PyAny>,
    name: &str,
    room: &mut Room,
) -> PyResult<Vec<f64>> {
    let array = floats(what, name, "(N,)")?;
    match array.shape() {
        [_] => values(&array, room),
        shape => Err(PyValueError::new_err(format!(
            "{name}: expected an array of shape (N,), found {shape:?}"
        ))),
    }
}

/// Matrices of three by three, row by row: one for all rows, or one for each.
pub(crate) fn matrices(
    what: &Bound<'_, PyAny>,
    name: &str,
    rows: usize,
    room: &mut Room,
) -> PyResult<Vec<f64>> {
    let array = floats(what, name, "(3, 3) or (N, 3, 3)")?;
    match array.shape() {
        [3, 3] => values(&array, room),
        [count, 3, 3] if *count == rows => values(&array, room),
        shape => Err(PyValueError::new_err(format!(
            "{name}: expected an array of shape (3, 3) or ({rows}, 3, 3), found {shape:?}"
        ))),
    }
}

/// A number that has to be finite.
pub(crate) fn finite(number: f64) -> Result<f64, QueryError> {
    if number.is_finite() { Ok(number) } else { Err(QueryError::NotFinite) }
}

/// An array of ids, one for each row.
pub(crate) fn ids(
    what: &Bound<'_, PyAny>,
    name: &str,
    rows: Option<usize>,
    room: &mut Room,
) -> PyResult<Vec<u64>> {
    let Ok(array) = what.cast::<PyArrayDyn<u64>>() else {
        let found = what.get_type().name()?.to_string();
        return Err(PyTypeError::new_err(format!(
            "{name}: expected an array of uint64 of shape (N,), found {found}"
        )));
    };
    let shape = array.shape().to_vec();
    if shape.len() != 1 || rows.is_some_and(|rows| shape[0] != rows) {
        let wanted = rows.map_or("N".to_owned(), |rows| rows.to_string());
        return Err(PyValueError::new_err(format!(
            "{name}: expected an array of shape ({wanted},), found {shape:?}"
        )));
    }
    values(array, room)
}

/// A single point, which is a tuple; an array is many.
pub(crate) fn one_point(what: &Bound<'_, PyAny>, name: &str) -> PyResult<Option<Point>> {
    let Some(numbers) = one(what, name, &[2, 3])? else { return Ok(None) };
    Ok(Some(point_of(&numbers)))
}

/// A tuple of so many numbers; none for what is no tuple.
pub(crate) fn one(
    what: &Bound<'_, PyAny>,
    name: &str,
    widths: &[usize],
) -> PyResult<Option<Vec<f64>>> {
    let Ok(tuple) = what.cast::<PyTuple>() else { return Ok(None) };
    let numbers: Vec<f64> = tuple.extract()?;
    if !widths.contains(&numbers.len()) {
        return Err(PyValueError::new_err(format!(
            "{name}: expected a tuple of {widths:?} numbers, found {}",
            numbers.len()
        )));
    }
    Ok(Some(numbers))
}

/// The lane of an id.
pub(crate) fn lane_of_id(map: Map<'_>, id: u64) -> Result<mapd_client::Lane<'_>, QueryError> {
    if id == NONE_ID {
        return Err(QueryError::NoId);
    }
    if (id >> 32) as u32 != content(map) {
        return Err(QueryError::ForeignId);
    }
    map.lane_by_row(id as u32).ok_or(QueryError::Corrupt)
}

/// A lane by itself, its key or its id.
pub(crate) fn lane_of<'a>(
    map: Map<'a>,
    what: &Bound<'_, PyAny>,
) -> PyResult<mapd_client::Lane<'a>> {
    if let Ok(lane) = what.cast::<Lane>() {
        return lane_of_id(map, lane.get().id()).map_err(query);
    }
    if let Ok(text) = what.cast::<PyString>() {
        let text = text.to_string();
        let key: LaneKey<'static> =
            text.parse().map_err(|error| PyValueError::new_err(format!("{error}")))?;
        return map
            .lane_by_key(&key)
            .ok_or_else(|| raise("NoSuchPartError", format!("the map has no lane {text}")));
    }
    match what.extract::<u64>() {
        Ok(id) => lane_of_id(map, id).map_err(query),
        Err(_) => Err(PyTypeError::new_err(format!(
            "expected a lane, its key or its id, found {}",
            what.get_type().name()?
        ))),
    }
}

/// Ids of lanes; none for none.
pub(crate) fn lanes_of(
    map: Map<'_>,
    lanes: Option<&[Bound<'_, PyAny>]>,
) -> PyResult<Vec<mapd_client::LaneId>> {
    let lanes = lanes.unwrap_or_default().iter();
    lanes.map(|lane| lane_of(map, lane).map(|lane| lane.lane_id())).collect()
}

/// A place: a tuple that begins with a lane and s.
pub(crate) fn place_of(map: Map<'_>, what: &Bound<'_, PyAny>) -> PyResult<PositionOnLane> {
    let tuple = what.cast::<PyTuple>().ok().filter(|tuple| tuple.len() >= 2).ok_or_else(|| {
        PyTypeError::new_err("expected a place: (lane, s), or what nearest_lane found")
    })?;
    let lane = lane_of(map, &tuple.get_item(0)?)?.lane_id();
    Ok(PositionOnLane { lane, s: tuple.get_item(1)?.extract()? })
}

/// A rectangle: (x_min, y_min, x_max, y_max).
pub(crate) fn region_of([x_min, y_min, x_max, y_max]: [f64; 4]) -> Region {
    Region { low: DVec2::new(x_min, y_min), high: DVec2::new(x_max, y_max) }
}

/// Lane types: `all`, `drivable`, `routable`, or names as OpenDRIVE has them.
pub(crate) fn types_of(what: &Bound<'_, PyAny>) -> PyResult<LaneTypes> {
    let names: Vec<String> = match what.cast::<PyString>() {
        Ok(one) => vec![one.to_string()],
        Err(_) => what.try_iter()?.map(|name| name?.extract()).collect::<PyResult<_>>()?,
    };
    let mut types = LaneTypes::NONE;
    for name in names {
        let Some(meant) = LaneTypes::from_word(&name) else {
            let known: Vec<_> = LaneType::ALL.iter().map(|kind| kind.name()).collect();
            return Err(PyValueError::new_err(format!(
                "expected \"all\", \"drivable\", \"routable\" or one of {known:?}, found {name:?}"
            )));
        };
        types = types.union(meant);
    }
    Ok(types)
}

/// A class of vehicles, as OpenDRIVE's `access/@restriction` has it.
pub(crate) fn vehicle_of(name: &str) -> PyResult<VehicleClass> {
    match VehicleClass::from_name(name) {
        VehicleClass::Unknown => {
            let known: Vec<_> = VehicleClass::ALL.iter().map(|class| class.name()).collect();
            Err(PyValueError::new_err(format!("expected one of {known:?}, found {name:?}")))
        }
        known => Ok(known),
    }
}

/// Classes of signals and objects by their words; those of landmarks where none are named.
pub(crate) fn classes_of(names: Option<Vec<String>>) -> PyResult<ClassSet> {
    let Some(names) = names else { return Ok(ClassSet::LANDMARKS) };
    names.iter().try_fold(ClassSet::NONE, |set, name| match Class::from_name(name) {
        Class::Unknown if name != Class::Unknown.name() => Err(PyValueError::new_err(format!(
            "expected a class of the vocabulary, found {name:?}"
        ))),
        class => Ok(set.with(class)),
    })
}

/// A country's rules of the road by its two letters; none where no country is named.
pub(crate) fn rules_of(country: Option<&str>) -> PyResult<Option<&'static RoadRules>> {
    let Some(country) = country else { return Ok(None) };
    let rules = RoadRules::of(country).map(Some);
    rules.ok_or_else(|| {
        let known: Vec<_> = RoadRules::ALL.iter().map(|rules| rules.country).collect();
        PyValueError::new_err(format!("expected one of {known:?}, found {country:?}"))
    })
}

pub(crate) fn triple(p: DVec3) -> (f64, f64, f64) {
    (p.x, p.y, p.z)
}
