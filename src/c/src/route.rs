//! Routes, what can be reached, and what comes next.

use crate::code::{Failure, answer, mapd_code, mapd_error};
use crate::graph::vehicle_of;
use crate::ids::{mapd_junction_id, mapd_lane_id, mapd_node_id};
use crate::list::{List, entries, finite, get, get_mut, put_raw, put_some};
use crate::request::{mapd_reach_link, tell_reach};
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use crate::view_ways::mapd_reached_piece;
use mapd_client::QueryError;
use mapd_client::graph::LaneNode;
use mapd_client::route::{
    CostBound, Enter, PositionOnLane, Reached, Route, RouteCost, RouteStep, ShortestLength,
    ShortestTime, WithFactors,
};
use mapd_client::vocabulary::VehicleClass;

/// A place on a lane.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_position_on_lane {
    /// The lane.
    pub lane: mapd_lane_id,
    /// On the road \[m\]; outside the lane's section its nearer end counts.
    pub s: f64,
}

/// `by` of a cost: metres along centre lines.
pub const MAPD_COST_LENGTH: u32 = 0;
/// `by` of a cost: seconds at the speed limits.
pub const MAPD_COST_TIME: u32 = 1;

/// What a route keeps small, and for whom.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_cost {
    /// A `MAPD_COST_…`.
    pub by: u32,
    /// Who travels: a `MAPD_VEHICLE_CLASS_…`.
    pub vehicle: u32,
    /// What a change of lane costs, in the cost's unit; usual are 20 m and 2 s. One that is negative or no number closes the way.
    pub lane_change: f64,
    /// A factor for each lane, by the row of its id: 1 changes nothing, infinity closes the lane, as does what is negative or no number. Lanes beyond
    /// the last have the factor 1. Null: none.
    pub factors: *const f64,
    /// How many factors there are.
    pub factor_count: usize,
}

/// `enter` of a step: the route starts on its lane.
pub const MAPD_ENTER_START: u8 = 0;
/// `enter` of a step: from behind, over the end of another lane.
pub const MAPD_ENTER_AHEAD: u8 = 1;
/// `enter` of a step: by a change of lane to the left, in driving direction.
pub const MAPD_ENTER_LEFT: u8 = 2;
/// `enter` of a step: by a change of lane to the right, in driving direction.
pub const MAPD_ENTER_RIGHT: u8 = 3;

/// A lane of a route. A lane that is only changed from is driven for no length.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_route_step {
    /// The lane.
    pub lane: mapd_lane_id,
    /// s on the road at which the route enters it \[m\]; of a change, the first place where it may happen.
    pub s_from: f64,
    /// s on the road at which the route leaves it \[m\].
    pub s_to: f64,
    /// Of a change, the last place where it may happen, else `s_from` \[m\].
    pub s_latest: f64,
    /// 1: it is travelled towards +s.
    pub forward: u8,
    /// How it is entered: a `MAPD_ENTER_…`.
    pub enter: u8,
}

/// What a route comes to.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_route_sum {
    /// What the cost adds up to.
    pub cost: f64,
    /// Length along the lanes' centre lines \[m\].
    pub length: f64,
    /// What the graph counts as time \[s\], as `mapd_lane_time_between`, under an overlay at the speeds that entries state. The time at the limits that hold on the way is
    /// `mapd_path_travel_time`.
    pub travel_time: f64,
    /// What of it is at speeds that are assumed, because no limit is recorded or there is none \[s\].
    pub assumed_time: f64,
    /// Number of lane changes.
    pub lane_changes: u32,
    /// Of a request, number of the start from which it leads; else 0.
    pub start: u32,
    /// Of a request, number of the goal to which it leads; else 0.
    pub goal: u32,
}

/// A node that can be reached.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_reached {
    /// The node.
    pub node: mapd_node_id,
    /// Least cost up to its beginning.
    pub cost: f64,
}

/// The next junction on a lane's way.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_next_junction {
    /// The junction.
    pub junction: mapd_junction_id,
    /// Distance to its first connecting road, along centre lines \[m\].
    pub distance: f64,
}

/// `MAPD_ENTER_…`.
pub(crate) fn enter_code(enter: Enter) -> u8 {
    match enter {
        Enter::Start => MAPD_ENTER_START,
        Enter::Ahead => MAPD_ENTER_AHEAD,
        Enter::Left => MAPD_ENTER_LEFT,
        Enter::Right => MAPD_ENTER_RIGHT,
    }
}

impl From<mapd_position_on_lane> for PositionOnLane {
    fn from(place: mapd_position_on_lane) -> Self {
        Self { lane: place.lane.into(), s: place.s }
    }
}

impl From<RouteStep> for mapd_route_step {
    fn from(step: RouteStep) -> Self {
        Self {
            lane: step.lane.into(),
            s_from: step.s_from,
            s_to: step.s_to,
            s_latest: step.s_latest,
            forward: step.forward.into(),
            enter: enter_code(step.enter),
        }
    }
}

/// A step of a caller's.
///
/// Errors: numbers that are not finite; an unknown way of entering.
pub(crate) fn step_of(step: mapd_route_step) -> Result<RouteStep, Failure> {
    if [step.s_from, step.s_to, step.s_latest].iter().any(|s| !s.is_finite()) {
        return Err(QueryError::NotFinite.into());
    }
    Ok(RouteStep {
        lane: step.lane.into(),
        forward: step.forward != 0,
        enter: match step.enter {
            MAPD_ENTER_START => Enter::Start,
            MAPD_ENTER_AHEAD => Enter::Ahead,
            MAPD_ENTER_LEFT => Enter::Left,
            MAPD_ENTER_RIGHT => Enter::Right,
            other => return Err(Failure::argument(format!("a step is entered by no {other}"))),
        },
        s_from: step.s_from,
        s_to: step.s_to,
        s_latest: step.s_latest,
    })
}

impl From<Route> for mapd_route_sum {
    fn from(route: Route) -> Self {
        let Route { cost, length, travel_time, assumed_time, lane_changes, start, goal } = route;
        let (start, goal) = (start as u32, goal as u32);
        Self { cost, length, travel_time, assumed_time, lane_changes, start, goal }
    }
}

fn reached(one: &Reached) -> mapd_reached {
    mapd_reached { node: one.node.into(), cost: one.cost }
}

/// Takes a caller's steps into a scratch.
///
/// # Safety
///
/// As [`entries`].
pub(crate) unsafe fn take_steps(
    steps: *const mapd_route_step,
    count: usize,
    into: &mut Vec<RouteStep>,
) -> Result<(), Failure> {
    into.clear();
    for (number, step) in unsafe { entries(steps, count, "the steps") }?.iter().enumerate() {
        into.push(step_of(*step).map_err(|wrong| wrong.of_entry(number))?);
    }
    Ok(())
}

/// Takes a caller's places into a scratch.
///
/// # Safety
///
/// As [`entries`].
pub(crate) unsafe fn take_places(
    places: *const mapd_position_on_lane,
    count: usize,
    into: &mut Vec<PositionOnLane>,
) -> Result<(), Failure> {
    into.clear();
    let given = unsafe { entries(places, count, "the places") }?;
    into.extend(given.iter().map(|place| PositionOnLane::from(*place)));
    Ok(())
}

/// What a caller keeps small, without factors.
pub(crate) enum Cost {
    Length(ShortestLength),
    Time(ShortestTime),
}

impl RouteCost for Cost {
    #[inline]
    fn pass(&self, node: &LaneNode<'_>) -> f64 {
        match self {
            Self::Length(cost) => cost.pass(node),
            Self::Time(cost) => cost.pass(node),
        }
    }

    #[inline]
    fn change(&self, from: &LaneNode<'_>, to: &LaneNode<'_>) -> f64 {
        match self {
            Self::Length(cost) => cost.change(from, to),
            Self::Time(cost) => cost.change(from, to),
        }
    }

    fn bound(&self) -> CostBound {
        match self {
            Self::Length(cost) => cost.bound(),
            Self::Time(cost) => cost.bound(),
        }
    }
}

/// Who travels, and what a caller keeps small.
///
/// Errors: an unknown cost or class.
///
/// # Safety
///
/// As [`entries`], of the factors.
pub(crate) unsafe fn cost_of<'a>(
    cost: mapd_cost,
) -> Result<(VehicleClass, WithFactors<'a, Cost>), Failure> {
    let mapd_cost { by, vehicle, lane_change, factors, factor_count } = cost;
    let vehicle = vehicle_of(u8::try_from(vehicle).unwrap_or(u8::MAX))?;
    let base = match by {
        MAPD_COST_LENGTH => Cost::Length(ShortestLength { lane_change }),
        MAPD_COST_TIME => Cost::Time(ShortestTime { lane_change }),
        by => return Err(Failure::argument(format!("{by} is no cost"))),
    };
    // SAFETY: as promised above.
    let factors = unsafe { entries(factors, factor_count, "the factors") }?;
    Ok((vehicle, WithFactors { base, factors }))
}

/// The cheapest way through `place_count` places, two or more, in their order, in driving direction and by allowed lane changes only. `sum`: what
/// it comes to; null is fine. Fewer than two places, or no way: `MAPD_CODE_NONE`, and the count is 0.
///
/// The lane of the start may be any; every other one must be open to the vehicle. Each leg is the cheapest by itself.
///
/// Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`; `MAPD_CODE_ARGUMENT` for an unknown cost or class.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_route(
    snapshot: *const mapd_snapshot,
    places: *const mapd_position_on_lane,
    place_count: usize,
    cost: mapd_cost,
    scratch: *mut mapd_scratch,
    sum: *mut mapd_route_sum,
    out: *mut mapd_route_step,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (map, (vehicle, cost)) = (map_of(snapshot)?, cost_of(cost)?);
            let mapd_scratch { route, steps, places: own, .. } = get_mut(scratch, "a scratch")?;
            take_places(places, place_count, own)?;
            let found = map.route_via(own, vehicle, &cost, route, steps)?;
            let code = List { out, capacity, count }.write(steps.iter().map(|s| (*s).into()))?;
            let Some(found) = found else { return Ok(mapd_code::NONE) };
            put_raw(sum, found.into())?;
            Ok(code)
        })
    }
}

/// Every node whose beginning can be reached within a cost, nearest first; the start's own node and those beside it come first of all.
///
/// Errors: as `mapd_route`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_reachable(
    snapshot: *const mapd_snapshot,
    from: mapd_position_on_lane,
    limit: f64,
    cost: mapd_cost,
    scratch: *mut mapd_scratch,
    out: *mut mapd_reached,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (map, (vehicle, cost)) = (map_of(snapshot)?, cost_of(cost)?);
            let mapd_scratch { route, reached: found, .. } = get_mut(scratch, "a scratch")?;
            map.reachable(from.into(), finite(limit)?, vehicle, &cost, route, found)?;
            List { out, capacity, count }.write(found.iter().map(reached))
        })
    }
}

/// Every node from whose beginning a place can be reached within a cost, nearest first: who can come here. The place's own node and those beside it
/// come with what is to be driven on them.
///
/// Errors: as `mapd_route`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_reachable_to(
    snapshot: *const mapd_snapshot,
    to: mapd_position_on_lane,
    limit: f64,
    cost: mapd_cost,
    scratch: *mut mapd_scratch,
    out: *mut mapd_reached,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (map, (vehicle, cost)) = (map_of(snapshot)?, cost_of(cost)?);
            let mapd_scratch { route, reached: found, .. } = get_mut(scratch, "a scratch")?;
            map.reachable_to(to.into(), finite(limit)?, vehicle, &cost, route, found)?;
            List { out, capacity, count }.write(found.iter().map(reached))
        })
    }
}

/// All sequences of lanes that a vehicle can follow from a place without changing lanes (`ahead` not 0), or on which it can have come there,
/// until each is `distance` \[m\] long or ends: what they have in common, as `mapd_reach` writes it, each piece of a lane once. `mapd_next_sequence` tells them one
/// by one. The lane of the place may be any; every other one must be open to the vehicle.
///
/// Errors: as `mapd_route`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_lane_sequences(
    snapshot: *const mapd_snapshot,
    from: mapd_position_on_lane,
    distance: f64,
    vehicle: u8,
    ahead: u8,
    scratch: *mut mapd_scratch,
    out: *mut mapd_reached_piece,
    capacity: usize,
    count: *mut usize,
    links: *mut mapd_reach_link,
    link_capacity: usize,
    link_count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            get(link_count, "the count of links")?;
            let (map, vehicle) = (map_of(snapshot)?, vehicle_of(vehicle)?);
            let mapd_scratch { route, sequences, sequence_is_due, .. } =
                get_mut(scratch, "a scratch")?;
            *sequence_is_due = false;
            if ahead != 0 {
                map.lane_sequences_ahead(from.into(), distance, vehicle, route, sequences)?;
            } else {
                map.lane_sequences_behind(from.into(), distance, vehicle, route, sequences)?;
            }
            let links = List { out: links, capacity: link_capacity, count: link_count };
            tell_reach(sequences.network(), List { out, capacity, count }, links)
        })
    }
}

/// The next of the sequences that the last `mapd_lane_sequences` with this scratch found: its lanes, from the one of the place on, in the direction in which it is
/// followed. `MAPD_CODE_NONE` after the last one. After `MAPD_CODE_TOO_SMALL` the next call tells the same one. Their number doubles with each fork; one of more than 65,536
/// pieces of lanes ends there.
///
/// Errors: null where something is needed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_next_sequence(
    scratch: *mut mapd_scratch,
    out: *mut mapd_lane_id,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let mapd_scratch { sequences, sequence_is_due, .. } = get_mut(scratch, "a scratch")?;
            get(count, "the count")?;
            if !*sequence_is_due && sequences.next_sequence().is_none() {
                put_raw(count, 0)?;
                return Ok(mapd_code::NONE);
            }
            let lanes = sequences.sequence().iter().map(|lane| (*lane).into());
            let code = List { out, capacity, count }.write(lanes);
            *sequence_is_due = !matches!(code, Ok(mapd_code::OK));
            code
        })
    }
}

/// The next junction ahead of a place within a distance \[m\], following the lanes as long as there is but one way on, or all ways lead into one
/// junction. On a connecting road the distance is 0. `MAPD_CODE_NONE` if there is none.
///
/// Errors: as `mapd_route`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_next_junction_of(
    snapshot: *const mapd_snapshot,
    from: mapd_position_on_lane,
    distance: f64,
    vehicle: u8,
    out: *mut mapd_next_junction,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let vehicle = vehicle_of(vehicle)?;
            let next = map_of(snapshot)?.next_junction(from.into(), distance, vehicle)?;
            let next = next.map(|next| mapd_next_junction {
                junction: next.junction.into(),
                distance: next.distance,
            });
            put_some(out, next)
        })
    }
}
