//! A found way, lane by lane.

use super::scratch::PathNode;
use super::ways::Ways;
use super::{PositionOnLane, Route, ends};
use crate::error::QueryError;
use crate::extents::SRange;
use crate::ids::LaneId;
use crate::map::Map;

/// How a lane of a route is entered.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum Enter {
    /// The route starts on it.
    Start,
    /// From behind, over the end of another lane.
    Ahead,
    /// By a change of lane to the left, in driving direction.
    Left,
    /// By a change of lane to the right, in driving direction.
    Right,
}

/// A lane of a route. A lane that is only changed from is driven for no length: the change may happen at once.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RouteStep {
    /// The lane.
    pub lane: LaneId,
    /// Whether it is travelled towards +s.
    pub forward: bool,
    /// How it is entered.
    pub enter: Enter,
    /// s on the road at which the route enters it `[m]`; of a change, the first place where it may happen.
    pub s_from: f64,
    /// s on the road at which the route leaves it `[m]`.
    pub s_to: f64,
    /// Of a change, the last place where it may happen, else `s_from` `[m]`.
    pub s_latest: f64,
}

/// The next change of lane on a route.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LaneChangeAhead {
    /// Number of the step that is entered by it.
    pub step: usize,
    /// Whether it goes to the left.
    pub left: bool,
    /// Distance along the route to the first place where it may happen `[m]`.
    pub from: f64,
    /// Distance along the route to the last place where it may happen `[m]`.
    pub until: f64,
}

/// Appends a way's steps and adds up what they measure.
pub(super) fn write<'a>(
    ways: impl Ways<'a>,
    path: &[PathNode],
    [s_from, s_to]: [f64; 2],
    mut route: Route,
    out: &mut Vec<RouteStep>,
) -> Route {
    let map = ways.map();
    let first_step = out.len();
    let mut entry = s_from;
    let mut last: Option<u32> = None;
    for (i, step) in path.iter().enumerate() {
        let Some(node) = ways.node(step.node) else { continue };
        let SRange { low, high } = node.s_range();
        let (begin, end) = if node.is_forward() { (low, high) } else { (high, low) };
        if step.enter == Enter::Ahead {
            entry = begin;
        }
        let next = path.get(i + 1).map(|next| next.enter);
        let exit = match next {
            None => s_to,
            Some(Enter::Ahead) => end,
            Some(_) => entry,
        };
        let changed = matches!(step.enter, Enter::Left | Enter::Right);
        route.lane_changes += u32::from(changed);
        if let Some(lane) = node.lane() {
            route.drive(&node, &lane, [entry, exit], lane.length_between(entry, exit));
        }
        let lane = LaneId::new(node.row.lane(), map.content());
        let goes_on = out.len() > first_step
            && step.enter == Enter::Ahead
            && last.is_some_and(|last| ways.follows(last, step.node));
        match out.last_mut().filter(|before| goes_on && before.lane == lane) {
            Some(before) => before.s_to = exit,
            None => out.push(RouteStep {
                lane,
                forward: node.is_forward(),
                enter: step.enter,
                s_from: entry,
                s_to: exit,
                s_latest: if !changed {
                    entry
                } else if next.is_none() {
                    s_to
                } else {
                    end
                },
            }),
        }
        last = Some(step.node);
    }
    route
}

/// The next change of lane on a route, seen from a place on step number `at`; none if the route needs no more.
///
/// Errors: ids of another map; an s that is no finite number.
pub fn next_lane_change(
    map: Map<'_>,
    steps: &[RouteStep],
    at: usize,
    place: PositionOnLane,
) -> Result<Option<LaneChangeAhead>, QueryError> {
    if !place.s.is_finite() {
        return Err(QueryError::NotFinite);
    }
    let mut distance = 0.0;
    let mut here = Some(ends::inside(&map.lane(place.lane)?, place.s));
    for (i, step) in steps.iter().enumerate().skip(at) {
        let lane = map.lane(step.lane)?;
        if i > at && matches!(step.enter, Enter::Left | Enter::Right) {
            let window = lane.length_between(step.s_from, step.s_latest);
            let left = step.enter == Enter::Left;
            // On the piece of the change itself, part of the window may be passed already.
            let passed = here.map_or(0.0, |s| lane.length_between(step.s_from, s));
            let until = distance + (window - passed).max(0.0);
            return Ok(Some(LaneChangeAhead { step: i, left, from: distance, until }));
        }
        let ahead = |s: f64| if step.forward { step.s_to >= s } else { step.s_to <= s };
        match here {
            // A lane that is only changed from is left where it is entered; one may still be anywhere on it.
            Some(s) if ahead(s) && step.s_from != step.s_to => {
                distance += lane.length_between(s, step.s_to);
                here = None;
            }
            Some(_) => {}
            None => distance += lane.length_between(step.s_from, step.s_to),
        }
    }
    Ok(None)
}
