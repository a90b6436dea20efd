//! Routes over the lane graph: shortest, alternatives, reachable, ahead.
//!
//! A [`RouteRequest`] says all that a search can be asked: several starts and goals, each with its cost and heading, lanes to avoid, a cost of one's own.
//! [`Map::find_route`], [`Map::alternatives`], [`Map::reach`] and [`Map::reach_to`] take one; [`Map::route`] and the others with a place each are short
//! forms.
//!
//! A route is found by A* with landmark bounds that the archive carries, or by Dijkstra's algorithm where it has none. A
//! search uses the caller's [`RouteScratch`] and nothing else.
//!
//! **What a route costs.** Each piece of a lane that is left at its end costs what the [`RouteCost`] says, in proportion on
//! the first and last one; each change of lane costs extra. A change may happen anywhere on the piece where it is allowed,
//! so it drives no length of its own: the length counts on the lane that the piece is left on.

mod alternatives;
mod around;
mod bound;
mod cost;
mod ends;
mod reach;
mod request;
mod scratch;
mod search;
mod sequences;
mod steps;
mod ways;

pub(crate) use alternatives::alternatives;
pub use alternatives::{AlternativeOptions, Routes};
pub(crate) use bound::Bounds;
pub use cost::{CostBound, RouteCost, ShortestLength, ShortestTime, WithFactors, WithTurns};
pub(crate) use ends::share_before;
pub use reach::{Reach, ReachLink, Reached};
pub(crate) use reach::{WithinCost, network, reach};
pub use request::{RouteEnd, RouteError, RouteRequest};
pub use scratch::RouteScratch;
pub use sequences::{LaneSequences, NextJunction};
pub use steps::{Enter, LaneChangeAhead, RouteStep, next_lane_change};
pub(crate) use ways::Ways;

use crate::graph::LaneNode;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::map::Map;
use mapd_archive::VehicleClass;

/// A position on a lane by s alone: an end of a route, or where a search begins. ([`LanePosition`](crate::LanePosition) has a point's offsets too.)
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PositionOnLane {
    /// The lane.
    pub lane: LaneId,
    /// The road's s `[m]`; outside the lane's section its nearer end counts.
    pub s: f64,
}

/// What a route costs in all.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Route {
    /// What the [`RouteCost`] adds up to.
    pub cost: f64,
    /// Length along the lanes' centre lines `[m]`.
    pub length: f64,
    /// What the graph counts as time `[s]`, which [`ShortestTime`] minimises: as [`Lane::time_between`](crate::Lane::time_between), under an overlay at the speeds that entries
    /// state. The time at the limits that hold on the way is [`Path::travel_time`](crate::path::Path::travel_time)'s.
    pub travel_time: f64,
    /// What of it is at speeds that are assumed, because no limit is recorded or there is none `[s]`.
    pub assumed_time: f64,
    /// Number of lane changes.
    pub lane_changes: u32,
    /// Number of the start that it takes.
    pub start: usize,
    /// Number of the goal that it comes to.
    pub goal: usize,
}

impl Route {
    /// Adds what is driven of a node of a lane, from s to s over a length.
    pub(crate) fn drive(&mut self, node: &LaneNode<'_>, lane: &Lane<'_>, s: [f64; 2], length: f64) {
        self.length += length;
        let whole = node.length();
        if whole > 0.0 {
            let time = node.travel_time() * (length / whole);
            self.travel_time += time;
            if !node.is_speed_stated() {
                self.assumed_time += lane.assumed_time(s[0], s[1], time);
            }
        }
    }
}

impl<'a> Map<'a> {
    /// The cheapest way from one place to another for a class of vehicles, in driving direction and by allowed lane
    /// changes only. Its lanes are written to `steps`; `None` if there is no way.
    ///
    /// The lane of the start may be any; every other one must be open to the vehicle. Equal costs are decided by the order
    /// of lanes in the archive.
    ///
    /// Errors: [`RouteError::Place`] with the number 0 for the start and 1 for the goal: an id of another map, an s that is no finite number.
    pub fn route(
        &self,
        from: PositionOnLane,
        to: PositionOnLane,
        vehicle: VehicleClass,
        cost: &impl RouteCost,
        scratch: &mut RouteScratch,
        steps: &mut Vec<RouteStep>,
    ) -> Result<Option<Route>, RouteError> {
        self.route_via(&[from, to], vehicle, cost, scratch, steps)
    }

    /// As [`Map::route`], through all of these places in their order. Each leg is the cheapest by itself, starting in the
    /// direction in which the one before arrives. Fewer than two places have no route.
    ///
    /// Errors: as [`Map::route`], by the number of the place.
    pub fn route_via(
        &self,
        places: &[PositionOnLane],
        vehicle: VehicleClass,
        cost: &impl RouteCost,
        scratch: &mut RouteScratch,
        steps: &mut Vec<RouteStep>,
    ) -> Result<Option<Route>, RouteError> {
        find_via(*self, places, vehicle, cost, scratch, steps)
    }

    /// The cheapest way from any start of a request to any of its goals: as [`Map::route`], which is its short form.
    ///
    /// Errors: [`RouteError`], which names the start, goal or lane.
    pub fn find_route(
        &self,
        request: &RouteRequest<'_, impl RouteCost>,
        scratch: &mut RouteScratch,
        steps: &mut Vec<RouteStep>,
    ) -> Result<Option<Route>, RouteError> {
        steps.clear();
        find(*self, request, scratch, steps)
    }
}

/// Appends the cheapest way of a request, on a map or under an overlay.
///
/// Errors: as [`Map::find_route`].
pub(crate) fn find<'a>(
    ways: impl Ways<'a>,
    request: &RouteRequest<'_, impl RouteCost>,
    scratch: &mut RouteScratch,
    steps: &mut Vec<RouteStep>,
) -> Result<Option<Route>, RouteError> {
    request.check(ways.map())?;
    let ends = [request.starts, request.goals];
    if request.avoid.is_empty() {
        let search = search::Search::new(ways, request.vehicle, request.cost, scratch);
        return Ok(search.run(ends, steps)?);
    }
    let closed = request.closed(ways.map(), scratch);
    let cost = request::Avoiding { base: request.cost, closed: &closed };
    let found = search::Search::new(ways, request.vehicle, &cost, scratch).run(ends, steps);
    scratch.closed = closed;
    Ok(found?)
}

/// The cheapest way through places, on a map or under an overlay.
///
/// Errors: as [`Map::route_via`].
pub(crate) fn find_via<'a>(
    ways: impl Ways<'a>,
    places: &[PositionOnLane],
    vehicle: VehicleClass,
    cost: &impl RouteCost,
    scratch: &mut RouteScratch,
    steps: &mut Vec<RouteStep>,
) -> Result<Option<Route>, RouteError> {
    steps.clear();
    for (number, place) in places.iter().enumerate() {
        let wrong = |source| RouteError::Place { number, source };
        request::check_place(ways.map(), place).map_err(wrong)?;
    }
    let mut whole: Option<Route> = None;
    let mut forward = None;
    for leg in places.windows(2) {
        let starts = &[RouteEnd { forward, ..leg[0].into() }];
        let goals = &[leg[1].into()];
        let request = RouteRequest { starts, goals, vehicle, cost, avoid: &[] };
        let Some(route) = find(ways, &request, scratch, steps)? else {
            steps.clear();
            return Ok(None);
        };
        forward = steps.last().map(|step| step.forward);
        let sum = whole.get_or_insert_default();
        sum.cost += route.cost;
        sum.length += route.length;
        sum.travel_time += route.travel_time;
        sum.assumed_time += route.assumed_time;
        sum.lane_changes += route.lane_changes;
    }
    Ok(whole)
}
