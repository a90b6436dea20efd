//! What a path comes by, and who meets it; as Python has it.

use crate::batch::{SPEED_ORIGINS, columns, fields, result, speed_rule};
use crate::errors::query;
use crate::held::{Held, content, id};
use crate::lane::Lane;
use crate::object::Object;
use crate::room::{Column, Kept, Room};
use crate::route::{Cost, found_route, step_result};
use crate::signal::Signal;
use mapd_client::QueryError;
use mapd_client::glam::{DVec2, DVec3};
use mapd_client::path::{
    ConflictLane, Corridor, CorridorEdges, EdgeKind, EdgeMark, Path, PathChange, PathChangeKind,
    PathConflict, PathCrossing, PathFact, PathFactKind, YieldsBy,
};
use mapd_client::route::{RouteScratch, RouteStep};
use mapd_client::rules::{LaneLine, LineSource, Turn};
use mapd_client::vocabulary::{ConflictKind, Relation, RelationReason, RoadRules, VehicleClass};
use numpy::IntoPyArray;
use numpy::ndarray::Array2;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::Arc;

/// What lies beyond an edge, in the order of the codes in columns.
pub(crate) const EDGES: [&str; 3] = ["lane", "kerb", "end"];

fn edge_code(mark: &EdgeMark) -> u8 {
    let kind: EdgeKind = mark.edge;
    EDGES.iter().position(|name| *name == kind.name()).unwrap_or(0) as u8
}

pub(crate) fn turn_name(turn: Turn) -> &'static str {
    match turn {
        Turn::Left => "left",
        Turn::Straight => "straight",
        Turn::Right => "right",
        Turn::Back => "back",
    }
}

/// A stop line or crossing: signal, object, lane, s, class.
pub(crate) fn line<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    line: &LaneLine,
) -> PyResult<Bound<'py, PyAny>> {
    let (signal, object) = match line.source {
        LineSource::Signal(signal) => (Some(Signal::new(held, signal)), None),
        LineSource::Object(object) => (None, Some(Object::new(held, object))),
    };
    let fields = fields!(
        py,
        signal = signal,
        object = object,
        lane = Lane::new(held, line.lane.row()),
        s = line.s,
        meaning = line.class.name(),
    );
    result(py, "LaneLine", &fields)
}

fn triple<'py>(py: Python<'py>, p: DVec3) -> PyResult<Bound<'py, PyTuple>> {
    PyTuple::new(py, [p.x, p.y, p.z])
}

fn fact<'py>(py: Python<'py>, held: &Arc<Held>, fact: &PathFact) -> PyResult<Bound<'py, PyAny>> {
    let fields = fields!(
        py,
        start = fact.along[0],
        end = fact.along[1],
        lane = Lane::new(held, fact.lane.row()),
    );
    match fact.kind {
        PathFactKind::Junction { junction, turn } => {
            fields.set_item("kind", "junction")?;
            fields.set_item("junction", held.map().junction(junction).map_err(query)?.id())?;
            fields.set_item("name", turn_name(turn))?;
        }
        PathFactKind::Signal { signal, governs } => {
            fields.set_item("kind", "signal")?;
            fields.set_item("signal", Signal::new(held, signal))?;
            fields.set_item("governs", governs)?;
        }
        PathFactKind::Line { line: own, ends: [left, right] } => {
            fields.set_item("kind", "line")?;
            fields.set_item("name", own.class.name())?;
            fields.set_item("line", line(py, held, &own)?)?;
            fields.set_item("left", triple(py, left)?)?;
            fields.set_item("right", triple(py, right)?)?;
        }
        PathFactKind::RoadType(kind) => {
            fields.set_item("kind", "road_type")?;
            fields.set_item("name", kind.name())?;
        }
        PathFactKind::LaneType(kind) => {
            fields.set_item("kind", "lane_type")?;
            fields.set_item("name", kind.name())?;
        }
        PathFactKind::Structure { kind, number } => {
            fields.set_item("kind", "structure")?;
            fields.set_item("name", kind.name())?;
            fields.set_item("number", number)?;
        }
        PathFactKind::Hole { number } => {
            fields.set_item("kind", "hole")?;
            fields.set_item("number", number)?;
        }
        PathFactKind::Country { number } => {
            fields.set_item("kind", "country")?;
            fields.set_item("name", held.map().country(number))?;
        }
        PathFactKind::Access { classes } => {
            let all = VehicleClass::ALL.iter().filter(|class| classes & class.bit() != 0);
            fields.set_item("kind", "access")?;
            fields.set_item(
                "vehicles",
                PyTuple::new(py, all.map(|class| class.name()).collect::<Vec<_>>())?,
            )?;
        }
        _ => fields.set_item("kind", "other")?,
    }
    result(py, "PathFact", &fields)
}

pub(crate) fn facts<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    found: &[PathFact],
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    found.iter().map(|one| fact(py, held, one)).collect()
}

pub(crate) fn speeds<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    path: &Path<'_, '_>,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let mut found = Vec::new();
    path.speeds(&mut found);
    let one = |own: &mapd_client::path::PathSpeed| {
        let rule = speed_rule(py, held, &own.rule)?;
        result(py, "PathSpeed", &fields!(py, start = own.along[0], end = own.along[1], rule = rule))
    };
    found.iter().map(one).collect()
}

pub(crate) fn segments<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    path: &Path<'_, '_>,
    vehicle: VehicleClass,
) -> PyResult<Bound<'py, PyAny>> {
    let mut found = Vec::new();
    py.detach(|| path.segments(vehicle, &mut found));
    segment_columns(py, held, &found)
}

/// Columns of lanes from which a path's goal is reached.
pub(crate) fn segment_columns<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    found: &[mapd_client::path::PathSegment],
) -> PyResult<Bound<'py, PyAny>> {
    let content = content(held.map());
    let numbers = |of: fn(&mapd_client::path::PathSegment) -> f64| {
        Column::Numbers(found.iter().map(of).collect())
    };
    let all = vec![
        numbers(|own| own.along[0]),
        numbers(|own| own.along[1]),
        Column::Ids(found.iter().map(|own| id(content, own.lane.row())).collect()),
        Column::Flags(found.iter().map(|own| own.forward).collect()),
        Column::Flags(found.iter().map(|own| own.driven).collect()),
        Column::Counts(found.iter().map(|own| i64::from(own.changes)).collect()),
        numbers(|own| own.last_change),
        numbers(|own| own.lane_end),
    ];
    columns(py, "PathSegments", all)
}

pub(crate) fn crossings<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    found: &[PathCrossing],
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let one = |own: &PathCrossing| {
        let fields = fields!(
            py,
            start = own.along[0],
            end = own.along[1],
            line = line(py, held, &own.line)?,
            yields = own.yields.name(),
            wait = own.wait,
        );
        result(py, "PathCrossing", &fields)
    };
    found.iter().map(one).collect()
}

pub(crate) fn joints<'py>(
    py: Python<'py>,
    path: &Path<'_, '_>,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let one = |own: &mapd_client::path::PathJoint| {
        let fields = fields!(
            py,
            along = own.along,
            gap = own.gap,
            kink = own.kink,
            enter = crate::route::entered(own.enter),
            broken = own.broken,
            short = own.short,
        );
        result(py, "PathJoint", &fields)
    };
    path.joints().iter().map(one).collect()
}

fn change<'py>(py: Python<'py>, own: &PathChange) -> PyResult<Bound<'py, PyAny>> {
    let (kind, distance) = match own.kind {
        PathChangeKind::Moved(distance) => ("moved", Some(distance)),
        PathChangeKind::Replaced(distance) => ("replaced", Some(distance)),
        _ => ("gone", None),
    };
    let [start, end] = own.along;
    let fields = fields!(py, start = start, end = end, kind = kind, distance = distance);
    result(py, "PathChange", &fields)
}

/// The way of a path on another map.
pub(crate) fn rebase<'py>(
    py: Python<'py>,
    path: &Path<'_, '_>,
    to: &Arc<Held>,
    vehicle: VehicleClass,
    cost: &Cost,
) -> PyResult<Bound<'py, PyAny>> {
    let (mut steps, mut changes) = (Vec::new(), Vec::new());
    let found = py
        .detach(|| {
            let mut scratch = RouteScratch::default();
            path.rebase(to.map(), vehicle, cost, &mut scratch, &mut steps, &mut changes)
        })
        .map_err(query)?;
    let route = found.map(|route| found_route(py, to, &route, &steps)).transpose()?;
    let changes = changes.iter().map(|own| change(py, own)).collect::<PyResult<Vec<_>>>()?;
    let fields = fields!(py, route = route, changes = PyTuple::new(py, changes)?);
    result(py, "Rebased", &fields)
}

pub(crate) fn steps_between<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    path: &Path<'_, '_>,
    steps: &[RouteStep],
    span: [f64; 2],
) -> PyResult<Bound<'py, PyTuple>> {
    let mut part = Vec::new();
    path.steps_between(steps, span, &mut part)
        .map_err(|error| crate::errors::raise("PathError", error.to_string()))?;
    let part = part.iter().map(|step| step_result(py, held, step));
    PyTuple::new(py, part.collect::<PyResult<Vec<_>>>()?)
}

/// A column of what is said of each entry of a list.
fn of_each<T, N: Kept>(room: &mut Room, all: &[T], of: impl Fn(&T) -> N) -> Vec<N> {
    let mut column = room.take(all.len());
    column.extend(all.iter().map(of));
    column
}

/// Columns of the corridor that `ask` fills.
pub(crate) fn corridor<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    out: Option<&Bound<'py, PyAny>>,
    ask: impl FnOnce(&mut Corridor) -> Result<(), QueryError> + Send,
) -> PyResult<Bound<'py, PyAny>> {
    let mut room = Room::of(py, "Corridor", out)?;
    let mut found = std::mem::take(&mut room.corridor);
    py.detach(|| ask(&mut found)).map_err(query)?;
    let content = content(held.map());
    let mut all = vec![
        Column::Numbers(of_each(&mut room, &found.along, |along| *along)),
        Column::Ids(of_each(&mut room, &found.lane, |lane| id(content, lane.row()))),
    ];
    for points in [&found.left, &found.right, &found.outer_left, &found.outer_right] {
        for part in [|p: &DVec3| p.x, |p: &DVec3| p.y, |p: &DVec3| p.z] {
            all.push(Column::Numbers(of_each(&mut room, points, part)));
        }
    }
    let marks =
        [&found.left_mark, &found.right_mark, &found.outer_left_mark, &found.outer_right_mark];
    for marks in marks {
        let kinds = of_each(&mut room, marks, |mark| mark.kind.code() as i8);
        let colors = of_each(&mut room, marks, |mark| mark.color.code() as i8);
        all.extend([Column::Codes(kinds), Column::Codes(colors)]);
        all.push(Column::Flags(of_each(&mut room, marks, |mark| mark.may_cross)));
        all.push(Column::Codes(of_each(&mut room, marks, |mark| edge_code(mark) as i8)));
    }
    all.push(Column::Numbers(of_each(&mut room, &found.s, |s| *s)));
    let max = |rule: &mapd_client::rules::SpeedRule| rule.max.unwrap_or(f64::NAN);
    all.push(Column::Numbers(of_each(&mut room, &found.speed, max)));
    let origin = |rule: &mapd_client::rules::SpeedRule| {
        let name = rule.origin.name();
        SPEED_ORIGINS.iter().position(|own| *own == name).unwrap_or(0) as i8
    };
    all.push(Column::Codes(of_each(&mut room, &found.speed, origin)));
    room.corridor = found;
    room.columns(py, "Corridor", all, out)
}

/// The road's surface along a path.
pub(crate) fn surface<'py>(
    py: Python<'py>,
    path: &Path<'_, '_>,
    [start, length, step]: [f64; 3],
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let mut room = Room::of(py, "CorridorSurface", out)?;
    let mut found = std::mem::take(&mut room.corridor);
    py.detach(|| {
        path.corridor(start, length, step, VehicleClass::PassengerCar, &mut found)?;
        path.corridor_surface(&mut found)
    })
    .map_err(query)?;
    let parts: [fn(&mapd_client::path::CorridorSurface) -> f64; 8] = [
        |own| own.position.x,
        |own| own.position.y,
        |own| own.position.z,
        |own| own.normal.x,
        |own| own.normal.y,
        |own| own.normal.z,
        |own| own.friction.unwrap_or(f64::NAN),
        |own| own.roughness.unwrap_or(f64::NAN),
    ];
    let mut all = vec![Column::Numbers(of_each(&mut room, &found.along, |along| *along))];
    for part in parts {
        all.push(Column::Numbers(of_each(&mut room, &found.surface, part)));
    }
    room.corridor = found;
    room.columns(py, "CorridorSurface", all, out)
}

/// The room between left and right edges (N, 2) as one polygon (M, 2) [m], and whether it is simple.
#[pyfunction]
pub(crate) fn outline<'py>(
    py: Python<'py>,
    left: &Bound<'py, PyAny>,
    right: &Bound<'py, PyAny>,
) -> PyResult<(Bound<'py, PyAny>, bool)> {
    let rows = |what: &Bound<'py, PyAny>, name: &str| -> PyResult<Vec<DVec3>> {
        let rows = crate::input::Rows::of(what, name, &[2], &mut Room::default())?;
        Ok(rows.points().map(|point| point.xy.extend(0.0)).collect())
    };
    let (left, right) = (rows(left, "left")?, rows(right, "right")?);
    let (points, is_simple) = py.detach(|| {
        let mut points: Vec<DVec2> = Vec::new();
        let room = Corridor { left, right, ..Corridor::default() };
        let is_simple = room.outline(CorridorEdges::Driven, &mut points);
        (points, is_simple)
    });
    let numbers = points.iter().flat_map(|point| [point.x, point.y]).collect();
    let array = Array2::from_shape_vec((points.len(), 2), numbers)
        .map_err(|error| PyValueError::new_err(error.to_string()))?;
    Ok((array.into_pyarray(py).into_any(), is_simple))
}

/// Conflicts of a path, with the lanes of each, as the file or a country's rules say who yields.
pub(crate) fn conflicts<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    found: &[PathConflict],
    lanes: &[ConflictLane],
    rules: Option<&RoadRules>,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let lane = |lane: &ConflictLane| {
        let said = YieldsBy { yields: lane.yields, basis: lane.basis() };
        let YieldsBy { yields, basis } = rules.map_or(said, |rules| lane.yields_by(rules));
        let fields = fields!(
            py,
            start = lane.along[0],
            end = lane.along[1],
            other = Lane::new(held, lane.other.row()),
            other_start = lane.other_s[0],
            other_end = lane.other_s[1],
            kind = lane.kind.name(),
            yields = yields.name(),
            reason = lane.reason.name(),
            basis = basis.name(),
            wait = lane.wait,
        );
        result(py, "ConflictLane", &fields)
    };
    let one = |conflict: &PathConflict| {
        let said = YieldsBy { yields: conflict.yields, basis: conflict.basis() };
        let YieldsBy { yields, basis } =
            rules.map_or(said, |rules| conflict.yields_by(lanes, rules));
        let own = conflict.lanes_of(lanes).iter().map(lane).collect::<PyResult<Vec<_>>>()?;
        let fields = fields!(
            py,
            start = conflict.along[0],
            end = conflict.along[1],
            other = Lane::new(held, conflict.other.row()),
            other_start = conflict.other_s[0],
            other_end = conflict.other_s[1],
            kind = conflict.kind.name(),
            yields = yields.name(),
            reason = conflict.reason.name(),
            basis = basis.name(),
            wait = conflict.wait,
            lanes = own,
        );
        result(py, "PathConflict", &fields)
    };
    found.iter().map(one).collect()
}

/// The lanes that lead to where other lanes meet a path; what Python has of a conflict names those.
pub(crate) fn approaches<'py>(
    py: Python<'py>,
    held: &Arc<Held>,
    conflict: &Bound<'py, PyAny>,
    distance: f64,
    vehicle: VehicleClass,
) -> PyResult<Bound<'py, PyAny>> {
    let map = held.map();
    // Which other lanes, and where, is all that counts.
    let lane = |lane: Bound<'py, PyAny>| {
        let number = |name: &str| -> PyResult<f64> { lane.getattr(name)?.extract() };
        Ok(ConflictLane {
            along: [0.0; 2],
            other: crate::input::lane_of(map, &lane.getattr("other")?)?.lane_id(),
            other_s: [number("other_start")?, number("other_end")?],
            kind: ConflictKind::Unknown,
            yields: mapd_client::path::Yields::Unknown,
            reason: RelationReason::Unknown,
            relation: Relation::Unknown,
            equal_roads: false,
            wait: 0.0,
        })
    };
    let lanes = conflict.getattr("lanes")?.try_iter()?;
    let lanes = lanes.map(|own| lane(own?)).collect::<PyResult<Vec<_>>>()?;
    let mut found = Vec::new();
    py.detach(|| map.approaches(&lanes, distance, vehicle, &mut found)).map_err(query)?;
    let content = content(map);
    let numbers = |of: fn(&mapd_client::path::ConflictApproach) -> f64| {
        Column::Numbers(found.iter().map(of).collect())
    };
    let all = vec![
        Column::Ids(found.iter().map(|own| id(content, own.lane.row())).collect()),
        Column::Flags(found.iter().map(|own| own.forward).collect()),
        numbers(|own| own.s[0]),
        numbers(|own| own.s[1]),
        numbers(|own| own.distance[0]),
        numbers(|own| own.distance[1]),
    ];
    columns(py, "Approaches", all)
}
