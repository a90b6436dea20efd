//! Which lanes a vehicle may be in, and how sure that is: from a pose and its covariance.
//!
//! The hypotheses are every lane in each of its directions of travel, and `none`: the vehicle is on no lane, or across one. A
//! lane's weight is its prior times the integral over its area of the density of (x, y, heading), spread by the map's own
//! deviations and, in heading, by how far drivers deviate from their lane's direction. `none` is a vehicle that heads anywhere
//! with the same probability, wherever it is: its weight is its prior over 2π. Weights are normalised over all hypotheses, for
//! lanes overlap in junctions. `docs/localisation.md` derives it.

mod cuts;
mod density;
mod error;
mod footprint;
mod spread;
mod stretch;
mod trace;
mod tracker;

pub use error::MatchError;
pub use footprint::VehicleOutline;
pub use trace::{TraceFix, TraceMatch, TraceOptions, TracePosition, TraceScratch};
pub use tracker::{Tracked, Tracker, TrackerFix, TrackerOptions};

use crate::area;
use crate::error::QueryError;
use crate::graph::LaneNode;
use crate::ids::LaneId;
use crate::index;
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::{LaneTypes, round_up};
use crate::route::Ways;
use crate::types::{LanePosition, Point, turned};
use density::PoseDensity;
use footprint::Footprint;
use glam::{DMat3, DVec2};
use mapd_archive::{NONE, VehicleClass};
use mapd_geometry::normalize_angle;

/// Candidates less probable than this are left out; what they have is no part of the others' probability.
const LEAST_PROBABILITY: f64 = 1e-9;
/// Default of [`MatchOptions::drive_deviation`] `[rad]`: six degrees.
const DRIVE_DEVIATION: f64 = 0.1;
/// Default of [`MatchOptions::none`].
const NONE_PRIOR: f64 = 0.01;
/// Default of [`MatchOptions::closed`] and [`MatchOptions::unexpected`].
const UNLIKELY: f64 = 0.05;

/// What somebody measured: where a vehicle is and which way it heads.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct VehiclePose {
    /// Place, inertial `[m]`; z only if known.
    pub position: Point,
    /// Heading `[rad]`, counter-clockwise from x; any turn of it.
    pub heading: f64,
}

/// How hypotheses are weighed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct MatchOptions<'a> {
    /// Lane types that are hypotheses. Default all.
    pub types: LaneTypes,
    /// Largest difference between the pose's z and the lane's `[m]`, of poses that have z. Default none.
    pub z_tolerance: Option<f64>,
    /// Standard deviation of a driver's heading from the lane's direction `[rad]`, not negative. Default 0.1.
    pub drive_deviation: f64,
    /// Prior of `none`, where a lane has 1; positive. Default 0.01.
    pub none: f64,
    /// The class of the vehicle: lanes that it may not use have the prior `closed`. Default: no class.
    pub vehicle: Option<VehicleClass>,
    /// Share of the prior that lanes have which the vehicle may not use, in (0, 1]. Default 0.05.
    pub closed: f64,
    /// Lanes that are expected, such as those of a route, or those that can be reached from the last known lane
    /// ([`Map::reachable`]); all others have the prior `unexpected`. Default none, which expects nothing. JSON leaves it out, because it is borrowed.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub expected: &'a [LaneId],
    /// Share of the prior that lanes have which are not expected, in (0, 1]: routes are left, and last lanes were wrong.
    /// Default 0.05.
    pub unexpected: f64,
    /// Plan view of the vehicle: a lane's weight is then the share of the vehicle that lies in it. Default none: where the pose's place lies counts.
    pub outline: Option<VehicleOutline>,
}

impl Default for MatchOptions<'_> {
    fn default() -> Self {
        Self {
            types: LaneTypes::ALL,
            z_tolerance: None,
            drive_deviation: DRIVE_DEVIATION,
            none: NONE_PRIOR,
            vehicle: None,
            closed: UNLIKELY,
            expected: &[],
            unexpected: UNLIKELY,
            outline: None,
        }
    }
}

/// A lane that a vehicle may be in, in one of its directions.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LaneMatch {
    /// The lane.
    pub lane: LaneId,
    /// Whether the vehicle travels towards +s.
    pub forward: bool,
    /// Probability among all hypotheses.
    pub probability: f64,
    /// Mahalanobis distance of the pose from the lane's centre line at the pose's s, headed as that line is driven, by the
    /// covariance of the model.
    pub mahalanobis: f64,
    /// The given heading minus the driving direction at the pose's s and offset `[rad]`, in (−π, π].
    pub heading_difference: f64,
    /// The pose's place with respect to the lane: s, t, both offsets, distance.
    pub position: LanePosition,
}

impl Map<'_> {
    /// The lanes that a vehicle may be in by a measured pose, the most probable first; returns the probability that it is in
    /// none. With the rest of `out` that makes 1, but for what candidates below 1e-9 have. `covariance` is that of (x, y, heading) in `[m²]`,
    /// `[m·rad]` and `[rad²]`; a heading that is not known has a large one (from 25 rad² on it counts for nothing). Lanes count
    /// out to six of the largest deviations, from the vehicle's outline if there is one. `out` is emptied first; it grows only if its capacity is too small.
    ///
    /// Errors: numbers that are not finite; a covariance that is not symmetric and positive semi-definite, with the place of
    /// what is wrong; options out of their domain.
    pub fn match_pose(
        &self,
        pose: &VehiclePose,
        covariance: &DMat3,
        options: &MatchOptions<'_>,
        out: &mut Vec<LaneMatch>,
    ) -> Result<f64, MatchError> {
        match_at_most(*self, usize::MAX, pose, covariance, options, out)
    }

    /// Puts the integral over each lane into its `probability`.
    fn weigh(
        &self,
        (pose, local): (&VehiclePose, DVec2),
        (density, footprint): (&PoseDensity, Option<&Footprint>),
        options: &MatchOptions<'_>,
        most: usize,
        out: &mut Vec<LaneMatch>,
    ) {
        let heights = pose.position.z.zip(options.z_tolerance).map(|(z, by)| [z - by, z + by]);
        let reach = round_up(density.reach + footprint.map_or(0.0, Footprint::radius));
        index::visit(self.tables(), local, heights, reach, |leaf, qx, qy, bound| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let lower = index::lower_bounds(leaf, qx, qy, heights);
            for k in 0..lower.len() {
                if lower[k] > bound || lanes[k] == NONE {
                    continue;
                }
                let lane = Lane::new(*self, lanes[k]).filter(|l| options.types.contains(l.kind()));
                let Some(lane) = lane else { continue };
                let Some(slab) = area::slab(&lane, usize::from(segments[k])) else { continue };
                let place = area::place_by_call(&lane, &slab, local);
                let level = place.level(&lane);
                if heights.is_some_and(|[low, high]| !(low <= level && level <= high)) {
                    continue;
                }
                let ways = [lane.is_forward(), !lane.is_forward()];
                let ways = if lane.is_bidirectional() { &ways[..] } else { &ways[..1] };
                for forward in ways.iter().copied() {
                    let (stretch, foot) = ((&lane, &slab), place.s());
                    let weight = match footprint {
                        None => stretch::weight(stretch, foot, local, density, forward),
                        Some(vehicle) => vehicle.weight(stretch, foot, local, density, forward),
                    };
                    let id = lane.lane_id();
                    match out.iter_mut().find(|m| m.lane == id && m.forward == forward) {
                        Some(known) => {
                            known.probability += weight;
                            if place.distance < known.position.distance {
                                known.position = place.position(&lane);
                            }
                        }
                        None => {
                            let found = LaneMatch {
                                lane: id,
                                forward,
                                probability: weight,
                                mahalanobis: 0.0,
                                heading_difference: 0.0,
                                position: place.position(&lane),
                            };
                            put(found, most, out);
                        }
                    }
                }
            }
            bound
        });
    }

    /// Makes probabilities of the weights and fills in the rest; returns the probability of `none`.
    fn normalise(
        &self,
        pose: &VehiclePose,
        density: &PoseDensity,
        options: &MatchOptions<'_>,
        prior: impl Fn(&LaneMatch) -> f64,
        out: &mut Vec<LaneMatch>,
    ) -> f64 {
        for found in out.iter_mut() {
            found.probability *= prior(found);
        }
        // Sorting in place allocates nothing; the sum is one of sorted numbers, whatever the index's order.
        out.sort_unstable_by(|a, b| {
            b.probability
                .total_cmp(&a.probability)
                .then((a.lane, a.forward).cmp(&(b.lane, b.forward)))
        });
        let none = options.none * density::ANY_HEADING;
        let sum = none + out.iter().map(|found| found.probability).sum::<f64>();
        out.retain_mut(|found| {
            found.probability /= sum;
            found.probability >= LEAST_PROBABILITY
        });
        for found in out.iter_mut() {
            let Ok(lane) = self.lane(found.lane) else { continue };
            let as_driven =
                |own: f64| if found.forward == lane.is_forward() { own } else { turned(own) };
            let LanePosition { s, heading, .. } = found.position;
            found.heading_difference = normalize_angle(pose.heading - as_driven(heading));
            let center = lane.pose_at(s, 0.0);
            found.mahalanobis = center.map_or(f64::NAN, |center| {
                let away = center.position.truncate() - pose.position.xy;
                density.distance(away, as_driven(center.heading))
            });
        }
        none / sum
    }
}

/// The lanes of a pose, on a map or under an overlay, as [`Map::match_pose`] has them; no more than so many, the most probable.
pub(crate) fn match_at_most<'a>(
    ways: impl Ways<'a>,
    most: usize,
    pose: &VehiclePose,
    covariance: &DMat3,
    options: &MatchOptions<'_>,
    out: &mut Vec<LaneMatch>,
) -> Result<f64, MatchError> {
    out.clear();
    error::check_pose(pose)?;
    error::check_options(options)?;
    error::check_covariance(covariance)?;
    let map = ways.map();
    let local = pose.position.xy - map.origin();
    let density = PoseDensity::new(pose.heading, covariance, options.drive_deviation)?;
    let none = options.none * density::ANY_HEADING;
    let outline = options.outline.as_ref();
    let footprint = match outline {
        Some(own) => Footprint::new(own, pose.heading, &density, none)?,
        None => None,
    };
    map.weigh((pose, local), (&density, footprint.as_ref()), options, most, out);
    let prior = |found: &LaneMatch| {
        let lane = map.lane(found.lane).ok();
        let node = || ways.node(ways.at(&lane?, found.position.s, found.forward)?);
        options.prior(found.lane, node)
    };
    Ok(map.normalise(pose, &density, options, prior, out))
}

impl MatchOptions<'_> {
    /// Prior of a lane where it is open as its node says, which only matters with a vehicle.
    fn prior<'a>(&self, lane: LaneId, node: impl FnOnce() -> Option<LaneNode<'a>>) -> f64 {
        let allows = |vehicle| node().is_some_and(|node| node.allows(vehicle));
        let open = self.vehicle.is_none_or(allows);
        let expected = self.expected.is_empty() || self.expected.contains(&lane);
        (if open { 1.0 } else { self.closed }) * (if expected { 1.0 } else { self.unexpected })
    }
}

/// Adds a candidate; to a list that is full, in place of the least one.
fn put(found: LaneMatch, most: usize, out: &mut Vec<LaneMatch>) {
    if out.len() < most {
        return out.push(found);
    }
    let least = out.iter_mut().min_by(|a, b| a.probability.total_cmp(&b.probability));
    if let Some(least) = least.filter(|least| least.probability < found.probability) {
        *least = found;
    }
}

impl From<QueryError> for MatchError {
    fn from(error: QueryError) -> Self {
        Self::Query(error)
    }
}
