//! A map under what is laid over it, at a moment.

mod paths;
mod places;
mod routes;

use crate::batch::{fields, result, speed_rule};
use crate::held::Held;
use crate::lane::Lane;
use crate::room::{Column, Room};
use mapd_client::view::{OverlayEntry, Restriction, SpeedToday};
use mapd_client::vocabulary::VehicleClass;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::Arc;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// A map under what is laid over it, at a moment: what is closed, slower or told of. Without an overlay it is the map.
#[pyclass(frozen, module = "mapd")]
pub(crate) struct View {
    held: Arc<Held>,
    at: SystemTime,
}

/// A moment: none is now, a number seconds since 1970 in UTC, anything else what its `timestamp()` says.
fn moment(at: Option<&Bound<'_, PyAny>>) -> PyResult<SystemTime> {
    let Some(at) = at else { return Ok(SystemTime::now()) };
    let seconds: f64 = match at.extract() {
        Ok(seconds) => seconds,
        Err(_) => at.call_method0("timestamp")?.extract()?,
    };
    let away = Duration::try_from_secs_f64(seconds.abs()).ok();
    let moment = away.and_then(|away| {
        if seconds < 0.0 { UNIX_EPOCH.checked_sub(away) } else { UNIX_EPOCH.checked_add(away) }
    });
    moment.ok_or_else(|| PyValueError::new_err(format!("at: {seconds} s is no moment")))
}

pub(crate) fn view(held: &Arc<Held>, at: Option<&Bound<'_, PyAny>>) -> PyResult<View> {
    Ok(View { held: Arc::clone(held), at: moment(at)? })
}

/// Number of the entry that decides; −1 where the map does.
fn number(restriction: Option<&Restriction<'_>>) -> i64 {
    restriction.map_or(-1, |one| i64::from(one.entry.number()))
}

impl View {
    fn view(&self) -> mapd_client::view::View<'_> {
        self.held.snapshot().view(self.at)
    }

    fn entry<'py>(&self, py: Python<'py>, own: &OverlayEntry<'_>) -> PyResult<Bound<'py, PyAny>> {
        let concerned = VehicleClass::ALL.iter().filter(|class| own.concerns(**class));
        let names: Vec<_> = concerned.map(|class| class.name()).collect();
        let vehicles = PyTuple::new(py, names)?;
        let fields = fields!(
            py,
            number = own.number(),
            id = own.id(),
            kind = own.kind().name(),
            value = own.value(),
            source = own.source(),
            text = own.text(),
            confidence = own.confidence(),
            vehicles = vehicles,
            holds = self.view().holds(own),
        );
        result(py, "OverlayEntry", &fields)
    }

    fn restriction<'py>(
        &self,
        py: Python<'py>,
        own: &Restriction<'_>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let fields = fields!(
            py,
            entry = self.entry(py, &own.entry)?,
            lane = Lane::new(&self.held, own.lane.row()),
            s_from = own.s_from,
            s_to = own.s_to,
        );
        result(py, "Restriction", &fields)
    }

    fn some<'py>(
        &self,
        py: Python<'py>,
        own: Option<&Restriction<'_>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        own.map(|own| self.restriction(py, own)).transpose()
    }

    fn speed<'py>(&self, py: Python<'py>, today: &SpeedToday<'_>) -> PyResult<Bound<'py, PyAny>> {
        let fields = fields!(
            py,
            max = today.max,
            map = speed_rule(py, &self.held, &today.map)?,
            restriction = self.some(py, today.restriction.as_ref())?,
        );
        result(py, "SpeedToday", &fields)
    }
}

/// Columns of speed limits of today.
struct Speeds {
    max: Vec<f64>,
    map: Vec<f64>,
    entry: Vec<i64>,
}

impl Speeds {
    fn with_room(rows: usize, room: &mut Room) -> Self {
        let [max, map] = room.numbers(rows);
        Self { max, map, entry: room.take(rows) }
    }

    fn push(&mut self, today: &SpeedToday<'_>) {
        self.max.push(today.max.unwrap_or(f64::NAN));
        self.map.push(today.map.max.unwrap_or(f64::NAN));
        self.entry.push(number(today.restriction.as_ref()));
    }

    fn columns(self) -> Vec<Column> {
        vec![Column::Numbers(self.max), Column::Numbers(self.map), Column::Counts(self.entry)]
    }
}

#[pymethods]
impl View {
    /// The moment: seconds since 1970 in UTC [s].
    #[getter]
    fn at(&self) -> f64 {
        match self.at.duration_since(UNIX_EPOCH) {
            Ok(after) => after.as_secs_f64(),
            Err(before) => -before.duration().as_secs_f64(),
        }
    }

    /// The map below.
    #[getter]
    fn map(&self) -> crate::map::Map {
        crate::map::Map::of(Arc::clone(&self.held))
    }

    /// Everything that the overlay says, whether it holds now or not; entry k has the number k.
    fn entries<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.view().entries().map(|own| self.entry(py, &own)).collect()
    }

    fn __repr__(&self) -> String {
        let (all, view) = (self.view().entries().count(), self.view());
        let now = view.entries().filter(|own| view.holds(own)).count();
        format!("<mapd.View {:?}: {now} of {all} entries hold>", self.held.map().name())
    }
}
