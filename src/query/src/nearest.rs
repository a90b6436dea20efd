//! The nearest lane to a point.

use crate::area;
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::index;
use crate::lane::Lane;
use crate::map::Map;
use crate::types::{LanePosition, Point};
use mapd_archive::LaneType;
use mapd_geometry::normalize_angle;
use std::cmp::Ordering;

/// Default search radius `[m]`.
const DEFAULT_RADIUS: f64 = 10.0;

/// A set of lane types.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LaneTypes(u64);

impl LaneTypes {
    /// Every type, unknown ones too.
    pub const ALL: Self = Self(u64::MAX);
    /// No type.
    pub const NONE: Self = Self(0);

    /// Types on which motor vehicles travel.
    pub fn drivable() -> Self {
        LaneType::ALL
            .iter()
            .filter(|kind| kind.is_drivable())
            .fold(Self::NONE, |set, kind| set.with(*kind))
    }

    /// The set with one more type.
    #[must_use]
    pub fn with(self, kind: LaneType) -> Self {
        Self(self.0 | Self::bit(kind))
    }

    /// Whether a type is in the set.
    pub fn contains(self, kind: LaneType) -> bool {
        self.0 & Self::bit(kind) != 0
    }

    fn bit(kind: LaneType) -> u64 {
        // Codes stay below 63; what is unknown has the last bit.
        1 << kind.code().min(63)
    }
}

/// What counts as a match.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestOptions {
    /// Largest plan-view distance from the lane's area `[m]`; the search is always bounded. Default 10.
    pub radius: f64,
    /// Lane types that count. Default all.
    pub types: LaneTypes,
    /// Largest difference between the point's z and the lane's `[m]`; needs a point with z. Default none.
    pub z_tolerance: Option<f64>,
    /// Heading of travel `[rad]`: breaks ties, and excludes lanes by `heading_tolerance`. Default none.
    pub heading: Option<f64>,
    /// Largest difference between `heading` and the lane's driving direction `[rad]`. Default none.
    pub heading_tolerance: Option<f64>,
    /// The answer for a point nearby, such as the one before on a trajectory: tried first, so that the search can leave
    /// out what is farther. It changes the cost, never the answer; one of another map is ignored. Default none.
    pub hint: Option<Nearest>,
}

impl Default for NearestOptions {
    fn default() -> Self {
        Self {
            radius: DEFAULT_RADIUS,
            types: LaneTypes::ALL,
            z_tolerance: None,
            heading: None,
            heading_tolerance: None,
            hint: None,
        }
    }
}

impl NearestOptions {
    /// Errors: numbers that are not finite.
    pub(crate) fn check(&self, point: Point) -> Result<(), QueryError> {
        let numbers = [self.z_tolerance, self.heading, self.heading_tolerance, point.z];
        let finite = point.xy.is_finite()
            && self.radius.is_finite()
            && numbers.iter().flatten().all(|n| n.is_finite());
        if finite { Ok(()) } else { Err(QueryError::NotFinite) }
    }

    /// Between which heights lanes count, if only some do.
    pub(crate) fn heights(&self, point: Point) -> Option<[f64; 2]> {
        match (point.z, self.z_tolerance) {
            (Some(z), Some(tolerance)) => Some([z - tolerance, z + tolerance]),
            _ => None,
        }
    }
}

/// The nearest lane and the point in its coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// The lane.
    pub lane: LaneId,
    /// The point's place with respect to it.
    pub position: LanePosition,
}

/// A lane's stretch, as near as it comes.
#[derive(Clone, Copy)]
pub(crate) struct Candidate {
    lane: u32,
    pub(crate) position: LanePosition,
    heading_difference: f64,
    z_difference: f64,
}

impl Candidate {
    #[inline]
    fn new(
        lane: &Lane<'_>,
        position: LanePosition,
        point: Point,
        options: &NearestOptions,
    ) -> Self {
        let z_difference = point.z.map_or(0.0, |z| (z - position.z).abs());
        let heading_difference =
            options.heading.map_or(0.0, |heading| heading_difference(lane, &position, heading));
        Self { lane: lane.row_number(), position, heading_difference, z_difference }
    }

    pub(crate) fn lane_id(&self, map: Map<'_>) -> LaneId {
        LaneId { row: self.lane, content: map.content() }
    }

    pub(crate) fn nearest(&self, map: Map<'_>) -> Nearest {
        Nearest { lane: self.lane_id(map), position: self.position }
    }

    /// Distance; then heading difference, z difference, |offset|, key, s; and what two geometries that meet round differently.
    #[inline]
    pub(crate) fn order(&self, other: &Self, map: Map<'_>) -> Ordering {
        self.position
            .distance
            .total_cmp(&other.position.distance)
            .then(self.heading_difference.total_cmp(&other.heading_difference))
            .then(self.z_difference.total_cmp(&other.z_difference))
            .then(self.position.offset.abs().total_cmp(&other.position.offset.abs()))
            .then_with(|| self.order_by_key(other, map))
            // Where two stretches of one lane meet, so that the answer does not depend on which is visited first.
            .then(self.position.s.total_cmp(&other.position.s))
            .then(self.position.t.total_cmp(&other.position.t))
            .then(self.position.heading.total_cmp(&other.position.heading))
    }

    #[cold]
    fn order_by_key(&self, other: &Self, map: Map<'_>) -> Ordering {
        let key = |candidate: &Self| {
            let lane = Lane::new(map, candidate.lane)?;
            Some((lane.road.id(), lane.section.number(), lane.number()))
        };
        key(self).cmp(&key(other))
    }
}

impl<'a> Map<'a> {
    /// The lane whose area is nearest to a point in plan view, within the options' radius; distance 0 inside. Ties go
    /// by heading difference, z difference, |offset|, then key. `None` if nothing is near enough.
    ///
    /// The index proposes stretches of lanes; each that may be the nearest is decided on the exact curve.
    ///
    /// Errors: coordinates or options that are not finite.
    pub fn nearest_lane(
        &self,
        point: impl Into<Point>,
        options: &NearestOptions,
    ) -> Result<Option<Nearest>, QueryError> {
        let point = point.into();
        options.check(point)?;
        let local = point.xy - self.origin();
        let (place, mut best) = self.hinted(point, local, options).unzip();
        // Single precision rounds the bound; a little more than the radius loses nothing, the exact test follows.
        let start = round_up(best.as_ref().map_or(options.radius, |b| b.position.distance));
        let heights = options.heights(point);
        index::visit(self.tables(), local, heights, start, |leaf, qx, qy, mut bound| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let lower = index::lower_bounds(leaf, qx, qy, heights);
            let mut open = index::places_within(&lower, bound);
            let mut consider = |k: usize, limit: f64, bound: &mut f32| {
                if place == Some((lanes[k], segments[k])) {
                    return;
                }
                let found = self.candidate((lanes[k], segments[k]), point, local, options, limit);
                let Some(candidate) = found.filter(|c| c.position.distance <= options.radius)
                else {
                    return;
                };
                if best.as_ref().is_none_or(|b| candidate.order(b, *self) == Ordering::Less) {
                    *bound = bound.min(round_up(candidate.position.distance));
                    best = Some(candidate);
                }
            };
            // Whether a lane holds the point is cheaper to tell than how far off it is, and mostly one does.
            let mut around = open & index::places_within(&lower, 0.0);
            while around != 0 {
                consider(around.trailing_zeros() as usize, 0.0, &mut bound);
                around &= around - 1;
            }
            if bound > 0.0 {
                // The most promising comes first: what it yields excludes most of the others before they cost a projection.
                while let Some(k) = index::least(&lower, open) {
                    open &= !(1 << k);
                    consider(k, f64::from(bound), &mut bound);
                    open &= index::places_within(&lower, bound);
                }
            }
            bound
        });
        Ok(best.map(|b| b.nearest(*self)))
    }

    /// The hint's lane at the hint's place, if the point lies in it there, and which segment that is. How far off it is
    /// otherwise would cost more than it saves.
    fn hinted(
        &self,
        point: Point,
        local: glam::DVec2,
        options: &NearestOptions,
    ) -> Option<((u32, u16), Candidate)> {
        let hint = options.hint?;
        let lane = self.lane(hint.lane).ok()?;
        let segment = u16::try_from(area::segment_at(&lane, hint.position.s)?).ok()?;
        let place = (hint.lane.row(), segment);
        let candidate = self.candidate(place, point, local, options, 0.0)?;
        (candidate.position.distance == 0.0).then_some((place, candidate))
    }

    /// What a place on a lane has for ties.
    pub(crate) fn candidate_of(
        &self,
        found: &Nearest,
        point: Point,
        options: &NearestOptions,
    ) -> Option<Candidate> {
        let lane = Lane::new(*self, found.lane.row())?;
        Some(Candidate::new(&lane, found.position, point, options))
    }

    /// A lane's stretch as a candidate; `None` where the options exclude it, or it is farther than `limit` where that is
    /// cheap to tell.
    #[inline]
    pub(crate) fn candidate(
        &self,
        (lane, segment): (u32, u16),
        point: Point,
        local: glam::DVec2,
        options: &NearestOptions,
        limit: f64,
    ) -> Option<Candidate> {
        let lane = Lane::new(*self, lane)?;
        if !options.types.contains(lane.kind()) {
            return None;
        }
        let slab = area::slab(&lane, usize::from(segment))?;
        let position = area::position_in_slab(&lane, &slab, local, limit)?;
        let found = Candidate::new(&lane, position, point, options);
        let too_far = |limit: Option<f64>, known: bool, difference: f64| {
            known && limit.is_some_and(|limit| difference > limit)
        };
        let excluded = too_far(options.z_tolerance, point.z.is_some(), found.z_difference)
            || too_far(
                options.heading_tolerance,
                options.heading.is_some(),
                found.heading_difference,
            );
        (!excluded).then_some(found)
    }
}

/// Angle between a heading and the lane's driving direction `[rad]`, the smaller one for lanes used both ways.
fn heading_difference(lane: &Lane<'_>, position: &LanePosition, heading: f64) -> f64 {
    let along = normalize_angle(heading - position.heading).abs();
    let against = std::f64::consts::PI - along;
    if lane.is_bidirectional() {
        along.min(against)
    } else if lane.is_forward() {
        along
    } else {
        against
    }
}

/// To single precision, never smaller.
pub(crate) fn round_up(value: f64) -> f32 {
    let rounded = value as f32;
    if f64::from(rounded) < value { rounded.next_up() } else { rounded }
}
