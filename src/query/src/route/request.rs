//! What is asked of a search.

use super::PositionOnLane;
use super::cost::RouteCost;
use super::scratch::RouteScratch;
use crate::error::QueryError;
use crate::graph::LaneNode;
use crate::map::Map;
use crate::nearest::NearestOptions;
use crate::types::Point;
use mapd_archive::VehicleClass;
use mapd_geometry::normalize_angle;
use std::f64::consts::FRAC_PI_2;
use thiserror::Error;

/// What is asked of a search: from any of some starts to any of some goals. The calls with a place each are short forms of it.
#[derive(Clone, Copy, Debug)]
pub struct RouteRequest<'r, C> {
    /// Where the way may begin. Their lanes may be closed to the vehicle.
    pub starts: &'r [RouteEnd],
    /// Where it may end.
    pub goals: &'r [RouteEnd],
    /// Who travels.
    pub vehicle: VehicleClass,
    /// What ways cost: [`ShortestLength`](super::ShortestLength), [`ShortestTime`](super::ShortestTime), one's own; with factors for
    /// lanes ([`WithFactors`](super::WithFactors)) and costs of turns ([`WithTurns`](super::WithTurns)).
    pub cost: &'r C,
    /// Lanes that are not entered; a start may lie on one.
    pub avoid: &'r [crate::LaneId],
}

/// A start or goal.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RouteEnd {
    /// Where.
    pub place: PositionOnLane,
    /// Whether the lane is travelled towards +s there: the heading with which one starts or arrives. `None` for either way.
    pub forward: Option<bool>,
    /// What it costs to start or end there, beside the way. One that is negative, infinite or no number closes it.
    pub cost: f64,
}

impl From<PositionOnLane> for RouteEnd {
    /// In either direction, for nothing.
    fn from(place: PositionOnLane) -> Self {
        Self { place, forward: None, cost: 0.0 }
    }
}

impl RouteEnd {
    /// The start or goal of a pose: the nearest lane within 10 m that the vehicle may use and that is travelled within 90° of the heading
    /// `[rad]`, in that direction, for nothing. `None` if there is none. Where several lanes hold the pose, as in a junction, give each as an
    /// end of its own ([`Map::lanes_near`], [`Map::match_pose`]).
    ///
    /// Errors: numbers that are not finite.
    pub fn of_pose(
        map: Map<'_>,
        point: impl Into<Point>,
        heading: f64,
        vehicle: VehicleClass,
    ) -> Result<Option<Self>, QueryError> {
        let options = NearestOptions {
            vehicle: Some(vehicle),
            heading: Some(heading),
            heading_tolerance: Some(FRAC_PI_2),
            ..NearestOptions::default()
        };
        let Some(found) = map.nearest_lane(point, &options)? else { return Ok(None) };
        let lane = map.lane(found.lane)?;
        let s = found.position.s;
        let ahead = normalize_angle(heading - found.position.heading).abs() <= FRAC_PI_2;
        let forward = lane.is_forward() == ahead;
        Ok(Some(Self {
            place: PositionOnLane { lane: found.lane, s },
            forward: Some(forward),
            cost: 0.0,
        }))
    }
}

/// Why a request has no answer. Starts, goals, places and lanes are counted from 0.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum RouteError {
    /// A start cannot be asked.
    #[error("start {number}: {source}")]
    Start {
        /// Which one.
        number: usize,
        /// What is wrong with it.
        source: QueryError,
    },
    /// A goal cannot be asked.
    #[error("goal {number}: {source}")]
    Goal {
        /// Which one.
        number: usize,
        /// What is wrong with it.
        source: QueryError,
    },
    /// A place of a way through several cannot be asked: the first one is the start, the last one the goal.
    #[error("place {number}: {source}")]
    Place {
        /// Which one.
        number: usize,
        /// What is wrong with it.
        source: QueryError,
    },
    /// A lane to be avoided is none of the map.
    #[error("lane {number} of those to avoid: {source}")]
    Avoid {
        /// Which one.
        number: usize,
        /// What is wrong with it.
        source: QueryError,
    },
    /// An option out of its domain.
    #[error("the option {0} is out of its domain")]
    Option(&'static str),
    /// The query itself failed.
    #[error(transparent)]
    Query(#[from] QueryError),
}

impl From<RouteError> for QueryError {
    /// What is wrong, without where.
    fn from(error: RouteError) -> Self {
        match error {
            RouteError::Start { source, .. }
            | RouteError::Goal { source, .. }
            | RouteError::Place { source, .. }
            | RouteError::Avoid { source, .. }
            | RouteError::Query(source) => source,
            RouteError::Option(_) => Self::NotFinite,
        }
    }
}

impl<C> RouteRequest<'_, C> {
    /// Errors: by number, a start, goal or lane of another map, a place that is not finite.
    pub(super) fn check(&self, map: Map<'_>) -> Result<(), RouteError> {
        let first = |ends: &[RouteEnd]| {
            let wrong = |end: &RouteEnd| check_place(map, &end.place).err();
            ends.iter().enumerate().find_map(|(number, end)| Some((number, wrong(end)?)))
        };
        if let Some((number, source)) = first(self.starts) {
            return Err(RouteError::Start { number, source });
        }
        if let Some((number, source)) = first(self.goals) {
            return Err(RouteError::Goal { number, source });
        }
        for (number, lane) in self.avoid.iter().enumerate() {
            map.lane(*lane).map_err(|source| RouteError::Avoid { number, source })?;
        }
        Ok(())
    }

    /// The lanes to avoid as bits by their rows, in the scratch's own buffer, to be given back.
    pub(super) fn closed(&self, map: Map<'_>, scratch: &mut RouteScratch) -> Vec<u64> {
        let mut closed = std::mem::take(&mut scratch.closed);
        closed.clear();
        if self.avoid.is_empty() {
            return closed;
        }
        closed.resize(map.tables().lanes.len().div_ceil(64), 0);
        for lane in self.avoid {
            if let Some(word) = closed.get_mut(lane.row() as usize / 64) {
                *word |= 1 << (lane.row() % 64);
            }
        }
        closed
    }
}

/// Errors: an id of another map; an s that is no finite number.
pub(super) fn check_place(map: Map<'_>, place: &PositionOnLane) -> Result<(), QueryError> {
    map.lane(place.lane)?;
    if place.s.is_finite() { Ok(()) } else { Err(QueryError::NotFinite) }
}

/// A cost by which some lanes are not entered.
pub(super) struct Avoiding<'s, C> {
    pub(super) base: &'s C,
    /// Bits by rows of lanes.
    pub(super) closed: &'s [u64],
}

impl<C> Avoiding<'_, C> {
    #[inline]
    fn is_closed(&self, node: &LaneNode<'_>) -> bool {
        let row = node.row.lane();
        self.closed.get(row as usize / 64).is_some_and(|word| word >> (row % 64) & 1 != 0)
    }
}

impl<C: RouteCost> RouteCost for Avoiding<'_, C> {
    #[inline]
    fn pass(&self, node: &LaneNode<'_>) -> f64 {
        self.base.pass(node)
    }

    #[inline]
    fn change(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        if self.is_closed(to) { f64::INFINITY } else { self.base.change(from, to) }
    }

    #[inline]
    fn enter(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        // A lane that one is on already may be left at its end: its next piece is not entered.
        let stays = from.row.lane() == to.row.lane();
        if self.is_closed(to) && !stays { f64::INFINITY } else { self.base.enter(from, to) }
    }

    fn bound(&self) -> super::CostBound {
        self.base.bound()
    }
}
