//! The road mark that is nearest to a point: on its exact course, with what is painted there.

mod course;
mod form;
mod many;
mod painted;
mod points;
mod search;

pub use points::{MarkPoint, MarkSource};

use crate::error::QueryError;
use crate::ids::LaneId;
use crate::map::Map;
use crate::nearest::LaneTypes;
use crate::types::is_place;
use glam::DVec2;
use mapd_archive::{RoadMarkColor, RoadMarkKind};
use search::Search;

/// How far `[m]` a mark's line may lie from its lane's border (by sway and offsets of its lines) and still be found for sure.
const MARK_SHIFT: f64 = 2.0;
/// Default of [`MarkFilter::radius`] `[m]`.
const DEFAULT_RADIUS: f64 = 5.0;

/// A set of kinds of road marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MarkKinds(u64);

impl MarkKinds {
    /// Every kind, unknown ones too.
    pub const ALL: Self = Self(u64::MAX);
    /// No kind.
    pub const NONE: Self = Self(0);

    /// The set with one more kind.
    #[must_use]
    pub fn with(self, kind: RoadMarkKind) -> Self {
        Self(self.0 | Self::bit(kind))
    }

    /// Whether a kind is in the set.
    pub fn contains(self, kind: RoadMarkKind) -> bool {
        self.0 & Self::bit(kind) != 0
    }

    /// The set as a number: the bit of a kind is that of its code, the highest one stands for unknown kinds.
    pub const fn bits(self) -> u64 {
        self.0
    }

    /// The set of [`Self::bits`].
    pub const fn from_bits(bits: u64) -> Self {
        Self(bits)
    }

    fn bit(kind: RoadMarkKind) -> u64 {
        // Codes stay below 63; what is unknown has the last bit.
        1 << kind.code().min(63)
    }
}

/// Which road marks count.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct MarkFilter {
    /// Largest distance in plan view `[m]`; the search is always bounded. Default 5.
    pub radius: f64,
    /// Kinds that count; the kind `none` never does. Default all.
    pub kinds: MarkKinds,
    /// Types of lanes whose borders count, on either side. Default all.
    pub types: LaneTypes,
    /// Whether what is painted as an object counts in [`Map::mark_points`]; the nearest mark is always one on a lane's border. Default true.
    pub objects: bool,
}

impl Default for MarkFilter {
    fn default() -> Self {
        Self { radius: DEFAULT_RADIUS, kinds: MarkKinds::ALL, types: LaneTypes::ALL, objects: true }
    }
}

/// The side of something, looking along the reference line.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum Side {
    /// To the left.
    Left,
    /// To the right.
    Right,
}

impl Side {
    /// `left` or `right`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

/// The place of a road mark that is nearest to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NearMark {
    /// The lane on whose outer border the mark lies; lane 0 for marks of the centre.
    pub lane: LaneId,
    /// Where, on the road `[m]`.
    pub s: f64,
    /// The nearest place of the middle of the mark's line, inertial `[m]`.
    pub place: DVec2,
    /// How far away that is in plan view `[m]`.
    pub distance: f64,
    /// The side of the point on which the mark is, looking along the road's reference line.
    pub side_of_reference_line: Side,
    /// Kind.
    pub kind: RoadMarkKind,
    /// Colour: the line's own, or the mark's.
    pub color: RoadMarkColor,
    /// Width of the line `[m]`, as [`RoadMark::width_or_default`](crate::roads::RoadMark::width_or_default) where it has none of its own.
    pub width: f64,
    /// Whether the line is painted at this s, or has a gap; `None` where the kind has gaps and the file does not say which.
    pub painted: Option<bool>,
}

impl Map<'_> {
    /// The road mark that is nearest to a point: on the exact course of each of its lines, with sway and the lines' own offsets.
    /// Lines count along their whole length; whether the nearest place is a gap is said by `painted`. `None` if none is near enough.
    /// Ties go by lane, then s.
    ///
    /// Errors: coordinates or a radius that are not finite.
    pub fn nearest_mark(
        &self,
        point: DVec2,
        filter: &MarkFilter,
    ) -> Result<Option<NearMark>, QueryError> {
        if !filter.radius.is_finite() {
            return Err(QueryError::Option("radius"));
        }
        if !is_place(point) {
            return Err(QueryError::NotFinite);
        }
        let local = point - self.origin();
        let mut search = Search::new(*self, filter);
        search.everywhere(local);
        Ok(search.found(local))
    }

    /// [`Map::nearest_mark`] of many points, in their order, bit for bit; it may find more of the lines that sway or lie far from their border. Points near each other, in whatever order, cost a fraction of single
    /// calls. `out` is emptied first; it grows only if its capacity is too small.
    ///
    /// Errors: coordinates that are not finite, by the number of the point; a radius that is not.
    pub fn nearest_marks(
        &self,
        points: &[DVec2],
        filter: &MarkFilter,
        out: &mut Vec<Option<NearMark>>,
    ) -> Result<(), QueryError> {
        out.clear();
        if !filter.radius.is_finite() && !points.is_empty() {
            return Err(QueryError::Option("radius"));
        }
        if let Some(i) = points.iter().position(|point| !is_place(*point)) {
            return Err(QueryError::NotFiniteAt(i));
        }
        out.resize(points.len(), None);
        many::answer(*self, points, filter, out);
        Ok(())
    }
}
