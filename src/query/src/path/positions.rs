//! Many points in a path's coordinates.

use super::{Path, PathPosition};
use crate::batch::Places;
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::types::Clamped;

/// Points in a path's coordinates, a column for each part of [`PathPosition`].
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathPositions {
    /// S of the feet `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub along: Vec<f64>,
    /// Offsets to the left of the driven line `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub d: Vec<f64>,
    /// Plan-view distances from the driven line `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub distance: Vec<f64>,
    /// Headings of the driven line at the feet `[rad]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub heading: Vec<f64>,
    /// The driven lanes there.
    pub lane: Vec<LaneId>,
    /// s on their roads `[m]`.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::numbers::list"))]
    pub s: Vec<f64>,
    /// Whether the points lie before the path's start or after its end.
    pub clamped: Vec<Clamped>,
}

impl PathPositions {
    /// Answers for how many points there are.
    pub fn len(&self) -> usize {
        self.along.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.along.is_empty()
    }

    /// The answer for a point, by its number: what [`Path::project`] gives.
    pub fn get(&self, i: usize) -> Option<PathPosition> {
        Some(PathPosition {
            along: *self.along.get(i)?,
            d: *self.d.get(i)?,
            distance: *self.distance.get(i)?,
            heading: *self.heading.get(i)?,
            lane: *self.lane.get(i)?,
            s: *self.s.get(i)?,
            clamped: *self.clamped.get(i)?,
        })
    }

    fn clear(&mut self) {
        let Self { along, d, distance, heading, lane, s, clamped } = self;
        [along, d, distance, heading, s].into_iter().for_each(Vec::clear);
        lane.clear();
        clamped.clear();
    }

    fn reserve(&mut self, count: usize) {
        let Self { along, d, distance, heading, lane, s, clamped } = self;
        [along, d, distance, heading, s].into_iter().for_each(|column| column.reserve(count));
        lane.reserve(count);
        clamped.reserve(count);
    }

    fn push(&mut self, own: &PathPosition) {
        self.along.push(own.along);
        self.d.push(own.d);
        self.distance.push(own.distance);
        self.heading.push(own.heading);
        self.lane.push(own.lane);
        self.s.push(own.s);
        self.clamped.push(own.clamped);
    }
}

impl Path<'_, '_> {
    /// As [`Path::project`] without a hint, of many points, bit for bit: such as those of other road users. Heights and headings of the places
    /// count for nothing. `out` is emptied first; it grows only if it is too small.
    ///
    /// Errors: a column that is not as long as the others, by its name; coordinates that are not finite, by the number of the point; a
    /// damaged archive.
    pub fn project_batch(
        &self,
        places: Places<'_>,
        out: &mut PathPositions,
    ) -> Result<(), QueryError> {
        out.clear();
        places.check()?;
        out.reserve(places.len());
        (0..places.len()).try_for_each(|i| {
            out.push(&self.project(places.xy(i), None)?);
            Ok(())
        })
    }
}
