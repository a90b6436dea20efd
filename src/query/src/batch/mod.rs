//! Many places at once: columns of numbers in, columns of answers out.
//!
//! Places are asked in the order of a curve that keeps near ones together (Morton 1966), so that each finds in the processor's cache
//! what the one before has read, and answers stand in the caller's order. What lies within a few metres of each other is answered
//! together: the index is searched once for all, and the stretches of lanes that it finds are made ready once.
//!
//! Answers are those of single calls, bit for bit.

mod lanes;
mod order;
mod poses;
mod rectangle;
mod tile;
mod tracks;

pub use lanes::NearestLanes;
pub(crate) use order::{Order, curve_key};
pub use poses::{PoseError, PoseMatches};
pub use tracks::{Poses, TrackPositions, Tracks};

use crate::error::QueryError;
use crate::types::{Point, is_coordinate};
use glam::DVec2;

/// Places, a column for each coordinate. All columns are as long as `x`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Places<'a> {
    /// Inertial x `[m]`.
    pub x: &'a [f64],
    /// Inertial y `[m]`.
    pub y: &'a [f64],
    /// Heights `[m]`, if known.
    pub z: Option<&'a [f64]>,
    /// Headings of travel `[rad]`, if known.
    pub heading: Option<&'a [f64]>,
}

impl Places<'_> {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.x.is_empty()
    }

    pub(crate) fn xy(&self, i: usize) -> DVec2 {
        DVec2::new(number(self.x, i), number(self.y, i))
    }

    pub(crate) fn point(&self, i: usize) -> Point {
        Point { xy: self.xy(i), z: self.z.map(|z| number(z, i)) }
    }

    pub(crate) fn heading(&self, i: usize) -> Option<f64> {
        self.heading.map(|heading| number(heading, i))
    }

    /// Errors: the name of a column that is not as long as x; the number of the first place with a part that is not finite.
    pub(crate) fn check(&self) -> Result<(), QueryError> {
        let columns =
            [("x", Some(self.x)), ("y", Some(self.y)), ("z", self.z), ("heading", self.heading)];
        check_columns(&columns)
    }
}

/// As [`Places::check`]; columns that are not there count for nothing.
fn check_columns(columns: &[(&'static str, Option<&[f64]>)]) -> Result<(), QueryError> {
    let given = || columns.iter().filter_map(|(name, column)| Some((name, (*column)?)));
    let count = given().next().map_or(0, |(_, column)| column.len());
    if let Some((name, _)) = given().find(|(_, column)| column.len() != count) {
        return Err(QueryError::Length(name));
    }
    // As single calls: an s far outside is moved to the road's end, a heading may have turned often.
    let first = |(name, column): (&&str, &[f64])| {
        let known = if matches!(*name, "s" | "heading") { f64::is_finite } else { is_coordinate };
        column.iter().position(|number| !known(*number))
    };
    match given().filter_map(first).min() {
        Some(i) => Err(QueryError::NotFiniteAt(i)),
        None => Ok(()),
    }
}

/// An entry of a column whose length was looked at.
#[inline]
fn number(column: &[f64], i: usize) -> f64 {
    column.get(i).copied().unwrap_or(f64::NAN)
}

/// Room to work in; used again, it allocates no more.
#[derive(Clone, Debug, Default)]
pub struct BatchScratch {
    pub(crate) order: Order,
}

impl BatchScratch {
    /// Room for batches of this many places.
    pub fn with_capacity(places: usize) -> Self {
        Self { order: Order::with_capacity(places) }
    }
}
