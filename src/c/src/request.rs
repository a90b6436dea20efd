//! Routes by request: several starts and goals, lanes to avoid, costs of turns; alternatives; the network that can be reached.

use crate::code::{Failure, Outcome, answer, mapd_code, mapd_error};
use crate::ids::mapd_lane_id;
use crate::list::{List, entries, finite, get, get_mut, put_raw};
use crate::options::{given_options, put_defaults};
use crate::route::{
    Cost, MAPD_COST_LENGTH, cost_of, enter_code, mapd_cost, mapd_route_step, mapd_route_sum,
};
use crate::scratch::mapd_scratch;
use crate::snapshot::{map_of, mapd_snapshot};
use crate::view::{mapd_view, view_of};
use crate::view_ways::mapd_reached_piece;
use mapd_client::LaneId;
use mapd_client::route::{
    AlternativeOptions, PositionOnLane, Reach, Route, RouteEnd, RouteError, RouteRequest,
    RouteScratch, RouteStep, Routes, WithFactors, WithTurns,
};
use mapd_client::vocabulary::VehicleClass;

/// `direction` of a start or goal: either way.
pub const MAPD_DIRECTION_EITHER: u8 = 0;
/// `direction` of a start or goal: towards +s.
pub const MAPD_DIRECTION_FORWARD: u8 = 1;
/// `direction` of a start or goal: towards −s.
pub const MAPD_DIRECTION_BACKWARD: u8 = 2;

/// A start or goal.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_route_end {
    /// The lane.
    pub lane: mapd_lane_id,
    /// On the road \[m\].
    pub s: f64,
    /// What it costs to start or end there, beside the way. One that is negative, infinite or no number closes it.
    pub cost: f64,
    /// The way in which the lane is travelled there: a `MAPD_DIRECTION_…`.
    pub direction: u8,
}

/// What is asked of a search: from any of some starts to any of some goals. Set it with `mapd_route_request_init`, then fill it in.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct mapd_route_request {
    /// Size of this struct as the caller knows it: later releases may append to it.
    pub size: usize,
    /// Where the way may begin. Their lanes may be closed to the vehicle.
    pub starts: *const mapd_route_end,
    /// How many starts there are.
    pub start_count: usize,
    /// Where it may end.
    pub goals: *const mapd_route_end,
    /// How many goals there are.
    pub goal_count: usize,
    /// Lanes that are not entered; a start may lie on one. Default null.
    pub avoid: *const mapd_lane_id,
    /// How many lanes to avoid there are.
    pub avoid_count: usize,
    /// What ways cost, and who travels. Default metres, a passenger car and 20 m for a change of lane.
    pub cost: mapd_cost,
    /// What a turn to the left at a junction costs beside it, in its unit. Default 0.
    pub turn_left: f64,
    /// What a turn to the right costs. Default 0.
    pub turn_right: f64,
    /// What a turn back costs. Default 0.
    pub turn_back: f64,
}

/// Which alternatives are wanted. Set it with `mapd_alternative_options_init`, then change what should differ.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct mapd_alternative_options {
    /// Size of this struct as the caller knows it: later releases may append to it.
    pub size: usize,
    /// Routes, the best one among them: 1 to 32. Default 3.
    pub count: usize,
    /// Share of its length that each drives on other sections of road, or the other way, than any one of those before it, 0 to 1. 0 for the k best
    /// routes, which may differ by a change of lane. Default 0.3.
    pub share: f64,
    /// How many times the cheapest one's cost a route may cost, at least 1. Default 1.5.
    pub longest: f64,
}

/// How one goes on from one piece that is reached to another.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct mapd_reach_link {
    /// Number of the one.
    pub from: usize,
    /// Number of the other.
    pub to: usize,
    /// How it is entered: a `MAPD_ENTER_…`.
    pub enter: u8,
}

impl From<RouteError> for Failure {
    #[cold]
    fn from(error: RouteError) -> Self {
        let code = match error {
            RouteError::Start { source, .. }
            | RouteError::Goal { source, .. }
            | RouteError::Place { source, .. }
            | RouteError::Avoid { source, .. }
            | RouteError::Query(source) => Self::from(source).code(),
            _ => mapd_code::ARGUMENT,
        };
        Self::new(code, error.to_string())
    }
}

/// Errors: a direction that is none.
fn end(end: &mapd_route_end) -> Result<RouteEnd, Failure> {
    let forward = match end.direction {
        MAPD_DIRECTION_EITHER => None,
        MAPD_DIRECTION_FORWARD => Some(true),
        MAPD_DIRECTION_BACKWARD => Some(false),
        other => return Err(Failure::argument(format!("{other} is no direction"))),
    };
    let place = PositionOnLane { lane: end.lane.into(), s: end.s };
    Ok(RouteEnd { place, forward, cost: end.cost })
}

type Asked<'a> = WithTurns<WithFactors<'a, Cost>>;

/// A caller's request, whose lists are copied.
struct Own<'a> {
    starts: Vec<RouteEnd>,
    goals: Vec<RouteEnd>,
    avoid: Vec<LaneId>,
    vehicle: VehicleClass,
    cost: Asked<'a>,
}

impl<'a> Own<'a> {
    fn request(&self) -> RouteRequest<'_, Asked<'a>> {
        let Self { starts, goals, avoid, vehicle, cost } = self;
        RouteRequest { starts, goals, vehicle: *vehicle, cost, avoid }
    }
}

/// # Safety
///
/// As [`given_options`]; lists are valid for reads of their counts.
unsafe fn request_of<'a>(request: *const mapd_route_request) -> Result<Own<'a>, Failure> {
    let given = unsafe { given_options(request, "mapd_route_request_init") }?;
    let given = given.ok_or_else(|| Failure::null("the request"))?;
    // SAFETY: as promised above.
    let (starts, goals, avoid, (vehicle, base)) = unsafe {
        (
            entries(given.starts, given.start_count, "the starts")?,
            entries(given.goals, given.goal_count, "the goals")?,
            entries(given.avoid, given.avoid_count, "the lanes to avoid")?,
            cost_of(given.cost)?,
        )
    };
    let (left, right, back) = (given.turn_left, given.turn_right, given.turn_back);
    Ok(Own {
        starts: starts.iter().map(end).collect::<Result<_, _>>()?,
        goals: goals.iter().map(end).collect::<Result<_, _>>()?,
        avoid: avoid.iter().map(|lane| LaneId::from(*lane)).collect(),
        vehicle,
        cost: WithTurns { base, left, right, back },
    })
}

/// Sets a request to its defaults: no starts and no goals. `size` is `sizeof(mapd_route_request)`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_route_request_init(
    request: *mut mapd_route_request,
    size: usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let cost = mapd_cost {
                by: MAPD_COST_LENGTH,
                vehicle: VehicleClass::PassengerCar.code().into(),
                lane_change: mapd_client::route::ShortestLength::default().lane_change,
                factors: std::ptr::null(),
                factor_count: 0,
            };
            let none = mapd_route_request {
                size,
                starts: std::ptr::null(),
                start_count: 0,
                goals: std::ptr::null(),
                goal_count: 0,
                avoid: std::ptr::null(),
                avoid_count: 0,
                cost,
                turn_left: 0.0,
                turn_right: 0.0,
                turn_back: 0.0,
            };
            put_defaults(request, size, none)
        })
    }
}

/// Sets options to their defaults. `size` is `sizeof(mapd_alternative_options)`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_alternative_options_init(
    options: *mut mapd_alternative_options,
    size: usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let AlternativeOptions { count, share, longest } = AlternativeOptions::default();
            put_defaults(options, size, mapd_alternative_options { size, count, share, longest })
        })
    }
}

/// Writes a route.
///
/// # Safety
///
/// As [`List::write`].
unsafe fn tell_route(
    found: Option<Route>,
    steps: &[RouteStep],
    sum: *mut mapd_route_sum,
    list: List<mapd_route_step>,
) -> Outcome {
    unsafe {
        let code = list.write(steps.iter().filter(|_| found.is_some()).map(|s| (*s).into()))?;
        let Some(found) = found else { return Ok(mapd_code::NONE) };
        put_raw(sum, found.into())?;
        Ok(code)
    }
}

/// The cheapest way from any start of a request to any of its goals, in driving direction and by allowed lane changes only. `sum`: what it comes to, and from
/// which start to which goal it leads; null is fine. `MAPD_CODE_NONE` if there is no way, and the count is 0.
///
/// Errors: `MAPD_CODE_FOREIGN_ID`, `MAPD_CODE_NOT_FINITE`, by the number of the start, goal or lane; `MAPD_CODE_ARGUMENT` for an unknown cost, class or
/// direction.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_find_route(
    snapshot: *const mapd_snapshot,
    request: *const mapd_route_request,
    scratch: *mut mapd_scratch,
    sum: *mut mapd_route_sum,
    out: *mut mapd_route_step,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (map, own) = (map_of(snapshot)?, request_of(request)?);
            let mapd_scratch { route, steps, .. } = get_mut(scratch, "a scratch")?;
            let found = map.find_route(&own.request(), route, steps)?;
            tell_route(found, steps, sum, List { out, capacity, count })
        })
    }
}

/// As `mapd_find_route`, heeding what holds now.
///
/// Errors: as `mapd_find_route`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_find_route(
    view: *const mapd_view,
    request: *const mapd_route_request,
    scratch: *mut mapd_scratch,
    sum: *mut mapd_route_sum,
    out: *mut mapd_route_step,
    capacity: usize,
    count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, own) = (view_of(view)?, request_of(request)?);
            let mapd_scratch { route, steps, .. } = get_mut(scratch, "a scratch")?;
            let found = view.find_route(&own.request(), route, steps)?;
            tell_route(found, steps, sum, List { out, capacity, count })
        })
    }
}

/// Asks for alternatives and writes them.
///
/// # Safety
///
/// As [`List::write`], of all three.
unsafe fn alternatives(
    options: *const mapd_alternative_options,
    scratch: *mut mapd_scratch,
    sums: List<mapd_route_sum>,
    ends: *mut usize,
    steps: List<mapd_route_step>,
    ask: impl FnOnce(&AlternativeOptions, &mut RouteScratch, &mut Routes) -> Result<(), RouteError>,
) -> Outcome {
    unsafe {
        let given = given_options(options, "mapd_alternative_options_init")?;
        let options = given.map_or_else(AlternativeOptions::default, |given| AlternativeOptions {
            count: given.count,
            share: given.share,
            longest: given.longest,
        });
        let mapd_scratch { route, routes, .. } = get_mut(scratch, "a scratch")?;
        ask(&options, route, routes)?;
        let (capacity, mut count) = (sums.capacity, 0);
        let told = sums.write(routes.iter().map(|(route, _)| (*route).into()))?;
        let at = routes.iter().scan(0, |end, (_, steps)| {
            *end += steps.len();
            Some(*end)
        });
        List { out: ends, capacity, count: &mut count }.write(at)?;
        let all = routes.iter().flat_map(|(_, steps)| steps).map(|step| (*step).into());
        let steps = steps.write(all)?;
        Ok(if told == mapd_code::OK { steps } else { told })
    }
}

/// The cheapest route of a request and alternatives to it, cheapest first. `sums` and `ends` have room for `capacity` routes each: what each comes to, and
/// where its steps end in `out`. `options`: null is the default.
///
/// Errors: as `mapd_find_route`; `MAPD_CODE_ARGUMENT` for options out of their domain.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_alternatives(
    snapshot: *const mapd_snapshot,
    request: *const mapd_route_request,
    options: *const mapd_alternative_options,
    scratch: *mut mapd_scratch,
    sums: *mut mapd_route_sum,
    ends: *mut usize,
    capacity: usize,
    count: *mut usize,
    out: *mut mapd_route_step,
    step_capacity: usize,
    step_count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (map, own) = (map_of(snapshot)?, request_of(request)?);
            let sums = List { out: sums, capacity, count };
            let steps = List { out, capacity: step_capacity, count: step_count };
            alternatives(options, scratch, sums, ends, steps, |options, scratch, out| {
                map.alternatives(&own.request(), options, scratch, out)
            })
        })
    }
}

/// As `mapd_alternatives`, heeding what holds now.
///
/// Errors: as `mapd_alternatives`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_alternatives(
    view: *const mapd_view,
    request: *const mapd_route_request,
    options: *const mapd_alternative_options,
    scratch: *mut mapd_scratch,
    sums: *mut mapd_route_sum,
    ends: *mut usize,
    capacity: usize,
    count: *mut usize,
    out: *mut mapd_route_step,
    step_capacity: usize,
    step_count: *mut usize,
    error: *mut mapd_error,
) -> mapd_code {
    unsafe {
        answer(error, || {
            let (view, own) = (view_of(view)?, request_of(request)?);
            let sums = List { out: sums, capacity, count };
            let steps = List { out, capacity: step_capacity, count: step_count };
            alternatives(options, scratch, sums, ends, steps, |options, scratch, out| {
                view.alternatives(&own.request(), options, scratch, out)
            })
        })
    }
}

/// Writes what is reached, and the links.
///
/// # Safety
///
/// As [`List::write`], of both.
pub(crate) unsafe fn tell_reach(
    reach: &Reach,
    pieces: List<mapd_reached_piece>,
    links: List<mapd_reach_link>,
) -> Outcome {
    unsafe {
        let told = pieces.write(reach.reached().iter().map(Into::into))?;
        let of = |from: usize| {
            let links = reach.links(from).iter();
            links.map(move |link| mapd_reach_link {
                from,
                to: link.to,
                enter: enter_code(link.enter),
            })
        };
        let links = links.write((0..reach.reached().len()).flat_map(of))?;
        Ok(if told == mapd_code::OK { links } else { told })
    }
}

/// What can be reached from a request's starts within a cost, nearest first, with the ways on; with `to` not 0 from where its goals can be reached, and the
/// ways back. What lies beyond the limit is not among the links.
///
/// Errors: as `mapd_find_route`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_reach(
    snapshot: *const mapd_snapshot,
    request: *const mapd_route_request,
    limit: f64,
    to: u8,
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
            let (map, own, limit) = (map_of(snapshot)?, request_of(request)?, finite(limit)?);
            let mapd_scratch { route, reach, .. } = get_mut(scratch, "a scratch")?;
            if to == 0 {
                map.reach(&own.request(), limit, route, reach)?;
            } else {
                map.reach_to(&own.request(), limit, route, reach)?;
            }
            let links = List { out: links, capacity: link_capacity, count: link_count };
            tell_reach(reach, List { out, capacity, count }, links)
        })
    }
}

/// As `mapd_reach`, heeding what holds now. Where the overlay cuts a node, each piece is told of by itself.
///
/// Errors: as `mapd_reach`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mapd_view_reach(
    view: *const mapd_view,
    request: *const mapd_route_request,
    limit: f64,
    to: u8,
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
            let (view, own, limit) = (view_of(view)?, request_of(request)?, finite(limit)?);
            let mapd_scratch { route, reach, .. } = get_mut(scratch, "a scratch")?;
            if to == 0 {
                view.reach(&own.request(), limit, route, reach)?;
            } else {
                view.reach_to(&own.request(), limit, route, reach)?;
            }
            let links = List { out: links, capacity: link_capacity, count: link_count };
            tell_reach(reach, List { out, capacity, count }, links)
        })
    }
}
