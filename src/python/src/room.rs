//! Memory of a batch: columns that are filled without the interpreter's lock, and what is needed meanwhile.
//!
//! A call without `out` hands its columns to Python. A call with `out` copies them into the arrays of `out`, once all rows are answered, and leaves its memory with
//! `out` for the next call, which then allocates nothing that grows with the number of rows.

use mapd_client::batch::BatchScratch;
use mapd_client::localisation::{GroundScratch, TraceFix, TraceMatch, TraceScratch};
use mapd_client::path::Corridor;
use mapd_client::{Clamped, LaneId};
use numpy::{
    Element, IntoPyArray, PyArray1, PyArrayMethods, PyReadwriteArray1, PyUntypedArrayMethods,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::sync::{Mutex, PoisonError};

/// A column of any type.
pub(crate) enum Column {
    Ids(Vec<u64>),
    Numbers(Vec<f64>),
    Codes(Vec<i8>),
    Flags(Vec<bool>),
    Counts(Vec<i64>),
}

impl Column {
    fn array<'py>(self, py: Python<'py>) -> Bound<'py, PyAny> {
        match self {
            Self::Ids(column) => column.into_pyarray(py).into_any(),
            Self::Numbers(column) => column.into_pyarray(py).into_any(),
            Self::Codes(column) => column.into_pyarray(py).into_any(),
            Self::Flags(column) => column.into_pyarray(py).into_any(),
            Self::Counts(column) => column.into_pyarray(py).into_any(),
        }
    }

    /// Errors: an array that it cannot be copied to.
    fn fits(&self, array: &Bound<'_, PyAny>) -> PyResult<()> {
        match self {
            Self::Ids(column) => writable(column, array).map(drop),
            Self::Numbers(column) => writable(column, array).map(drop),
            Self::Codes(column) => writable(column, array).map(drop),
            Self::Flags(column) => writable(column, array).map(drop),
            Self::Counts(column) => writable(column, array).map(drop),
        }
    }

    /// Copies it into an array that it fits, and leaves its memory with the room.
    fn copy_to(self, array: &Bound<'_, PyAny>, room: &mut Room) -> PyResult<()> {
        match self {
            Self::Ids(column) => copy(column, array, room),
            Self::Numbers(column) => copy(column, array, room),
            Self::Codes(column) => copy(column, array, room),
            Self::Flags(column) => copy(column, array, room),
            Self::Counts(column) => copy(column, array, room),
        }
    }
}

/// An array of a column's type and length, to be written to.
fn writable<'py, T: Element>(
    column: &[T],
    array: &Bound<'py, PyAny>,
) -> PyResult<PyReadwriteArray1<'py, T>> {
    let array = array.cast::<PyArray1<T>>().map_err(|_| {
        PyTypeError::new_err("out: expected the arrays that it was made with, found another")
    })?;
    let array = array.try_readwrite().map_err(|_| {
        PyValueError::new_err("out: expected arrays that can be written to, found a read-only one")
    })?;
    let (rows, found) = (column.len(), array.len());
    if found != rows {
        return Err(PyValueError::new_err(format!("out: expected {rows} rows, found {found}")));
    }
    Ok(array)
}

fn copy<T: Kept + Element>(
    column: Vec<T>,
    array: &Bound<'_, PyAny>,
    room: &mut Room,
) -> PyResult<()> {
    let mut array = writable(&column, array)?;
    array.as_array_mut().iter_mut().zip(&column).for_each(|(to, from)| *to = *from);
    room.give(column);
    Ok(())
}

/// What vectors are kept of.
pub(crate) trait Kept: Copy {
    fn kept(room: &mut Room) -> &mut Vec<Vec<Self>>;
}

macro_rules! kept {
    ($($name:ident: $type:ty),* $(,)?) => {
        /// Memory of one call, or of `out` between two.
        #[derive(Default)]
        pub(crate) struct Room {
            $($name: Vec<Vec<$type>>,)*
            pub(crate) batch: BatchScratch,
            pub(crate) ground: GroundScratch,
            pub(crate) trace: TraceScratch,
            pub(crate) fixes: Vec<TraceFix>,
            pub(crate) matches: Vec<TraceMatch>,
            pub(crate) corridor: Corridor,
        }

        $(impl Kept for $type {
            fn kept(room: &mut Room) -> &mut Vec<Vec<Self>> {
                &mut room.$name
            }
        })*
    };
}
kept! {
    ids: u64,
    numbers: f64,
    codes: i8,
    flags: bool,
    counts: i64,
    lanes: Option<LaneId>,
    clamped: Clamped,
}

/// What `out` keeps for the next call that fills it.
#[pyclass(frozen, module = "mapd._mapd")]
pub(crate) struct Memory(Mutex<Box<Room>>);

impl Memory {
    fn swap(&self, room: Box<Room>) -> Box<Room> {
        std::mem::replace(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner), room)
    }
}

impl Room {
    /// Memory of a call whose answer is a class of `mapd._columns`: what `out` has kept, where it is given.
    ///
    /// Errors: `out` is of another class.
    pub(crate) fn of(
        py: Python<'_>,
        class: &str,
        out: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Box<Self>> {
        let Some(out) = out else { return Ok(Box::default()) };
        let wanted = py.import(intern!(py, "mapd._columns"))?.getattr(class)?;
        if !out.get_type().is(&wanted) {
            let found = out.get_type().name()?;
            return Err(PyTypeError::new_err(format!("out: expected {class}, found {found}")));
        }
        let memory = out.getattr(intern!(py, "_memory"))?;
        let memory = memory.cast::<Memory>().ok();
        Ok(memory.map_or_else(Box::default, |memory| memory.get().swap(Box::default())))
    }

    /// An empty vector with room for so many: the smallest of those that are kept, or the largest made larger.
    pub(crate) fn take<T: Kept>(&mut self, rows: usize) -> Vec<T> {
        let kept = T::kept(self);
        let all = || kept.iter().map(Vec::capacity).enumerate();
        let fitting = all().filter(|(_, own)| *own >= rows).min_by_key(|(_, own)| *own);
        let found = fitting.or_else(|| all().max_by_key(|(_, own)| *own));
        let mut column = found.map(|(place, _)| kept.swap_remove(place)).unwrap_or_default();
        column.reserve(rows);
        column
    }

    /// Keeps a vector's memory.
    pub(crate) fn give<T: Kept>(&mut self, mut column: Vec<T>) {
        column.clear();
        T::kept(self).push(column);
    }

    /// So many empty vectors of numbers.
    pub(crate) fn numbers<const N: usize>(&mut self, rows: usize) -> [Vec<f64>; N] {
        std::array::from_fn(|_| self.take(rows))
    }

    /// Columns of a class of `mapd._columns`, in the order in which it names them; into `out`, where there is one, which then has this memory.
    pub(crate) fn columns<'py>(
        mut self: Box<Self>,
        py: Python<'py>,
        class: &str,
        columns: Vec<Column>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let Some(out) = out else {
            let arrays = PyList::new(py, columns.into_iter().map(|column| column.array(py)))?;
            let class = py.import(intern!(py, "mapd._columns"))?.getattr(class)?;
            return class.call_method1(intern!(py, "_of"), (arrays,));
        };
        let arrays = out.getattr(intern!(py, "_arrays"))?.cast_into::<PyDict>()?;
        // All or nothing: what does not fit is found before anything is written.
        for (array, column) in arrays.values().iter().zip(&columns) {
            column.fits(&array)?;
        }
        for (array, column) in arrays.values().iter().zip(columns) {
            column.copy_to(&array, &mut self)?;
        }
        match out.getattr(intern!(py, "_memory"))?.cast::<Memory>() {
            Ok(memory) => drop(memory.get().swap(self)),
            Err(_) => {
                out.setattr(intern!(py, "_memory"), Py::new(py, Memory(Mutex::new(self)))?)?;
            }
        }
        Ok(out.clone())
    }
}
