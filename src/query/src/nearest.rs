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
}

impl Default for NearestOptions {
    fn default() -> Self {
        Self {
            radius: DEFAULT_RADIUS,
            types: LaneTypes::ALL,
            z_tolerance: None,
            heading: None,
            heading_tolerance: None,
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

struct Candidate<'a> {
    lane: Lane<'a>,
    position: LanePosition,
    heading_difference: f64,
    z_difference: f64,
}

impl Candidate<'_> {
    /// Distance; then heading difference, z difference, |offset|, key.
    fn order(&self, other: &Self) -> Ordering {
        self.position
            .distance
            .total_cmp(&other.position.distance)
            .then(self.heading_difference.total_cmp(&other.heading_difference))
            .then(self.z_difference.total_cmp(&other.z_difference))
            .then(self.position.offset.abs().total_cmp(&other.position.offset.abs()))
            .then_with(|| self.lane.road.id().cmp(other.lane.road.id()))
            .then_with(|| self.lane.section.number().cmp(&other.lane.section.number()))
            .then_with(|| self.lane.number().cmp(&other.lane.number()))
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
        let numbers = [options.z_tolerance, options.heading, options.heading_tolerance, point.z];
        if !point.xy.is_finite()
            || !options.radius.is_finite()
            || numbers.iter().flatten().any(|n| !n.is_finite())
        {
            return Err(QueryError::NotFinite);
        }
        let local = point.xy - self.origin();
        let mut best: Option<Candidate<'a>> = None;
        // Single precision rounds the bound; a little more than the radius loses nothing, the exact test follows.
        let start = round_up(options.radius);
        let heights = match (point.z, options.z_tolerance) {
            (Some(z), Some(tolerance)) => Some([z - tolerance, z + tolerance]),
            _ => None,
        };
        index::visit(self.tables(), local, heights, start, |leaf, qx, qy, mut bound| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let lower = index::lower_bounds(leaf, qx, qy, heights);
            let mut open = index::places_within(&lower, bound);
            // The most promising comes first: what it yields excludes most of the others before they cost a projection.
            while let Some(k) = index::least(&lower, open) {
                open &= !(1 << k);
                if lower[k] > bound {
                    break;
                }
                let Some(candidate) = self.candidate(lanes[k], segments[k], point, local, options)
                else {
                    continue;
                };
                if candidate.position.distance > options.radius {
                    continue;
                }
                if best.as_ref().is_none_or(|b| candidate.order(b) == Ordering::Less) {
                    bound = bound.min(round_up(candidate.position.distance));
                    best = Some(candidate);
                }
            }
            bound
        });
        Ok(best.map(|b| Nearest { lane: b.lane.lane_id(), position: b.position }))
    }

    /// A lane's stretch as a candidate; `None` where the options exclude it.
    #[inline]
    fn candidate(
        &self,
        lane: u32,
        segment: u16,
        point: Point,
        local: glam::DVec2,
        options: &NearestOptions,
    ) -> Option<Candidate<'a>> {
        let lane = Lane::new(*self, lane)?;
        if !options.types.contains(lane.kind()) {
            return None;
        }
        let slab = area::slab(&lane, usize::from(segment))?;
        let position = area::position_in_slab(&lane, slab, local)?;
        let z_difference = point.z.map_or(0.0, |z| (z - position.z).abs());
        let heading_difference =
            options.heading.map_or(0.0, |heading| heading_difference(&lane, &position, heading));
        let excluded =
            options.z_tolerance.is_some_and(|limit| point.z.is_some() && z_difference > limit)
                || options
                    .heading_tolerance
                    .is_some_and(|limit| options.heading.is_some() && heading_difference > limit);
        (!excluded).then_some(Candidate { lane, position, heading_difference, z_difference })
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
fn round_up(value: f64) -> f32 {
    let rounded = value as f32;
    if f64::from(rounded) < value { rounded.next_up() } else { rounded }
}
