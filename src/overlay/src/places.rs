//! Where an entry holds on a map: stretches of lanes.

use crate::entry::Entry;
use crate::line::Lines;
use crate::on_earth::on_earth;
use crate::place::LaneStretch;
use mapd_query::geodesy::Projector;
use mapd_query::{Lane, LaneKey, Map, Road, SRange};
use std::cell::OnceCell;
use thiserror::Error;

/// Shortest stretch `[m]`: of a shorter one nothing might be left where lanes are cut.
pub(crate) const SHORTEST: f64 = 0.1;

/// Length to which what is shorter is widened where it was not given as an s, such as an object `[m]`: enough to be left between cuts.
pub(crate) const WIDENED: f64 = 0.3;

/// How far beyond a road's end an s may lie `[m]`: lengths are written rounded.
const ROUNDED: f64 = 0.01;

/// A stretch of a lane.
pub(crate) struct Stretch<'a> {
    pub(crate) lane: Lane<'a>,
    pub(crate) s_from: f64,
    pub(crate) s_to: f64,
}

/// Why a place does not fit the map.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{field}: {why}")]
pub struct PlaceError {
    /// The field that does not fit, such as `lanes[0].road`.
    pub field: String,
    /// Why.
    pub why: String,
}

impl PlaceError {
    pub(crate) fn new(field: impl Into<String>, why: impl Into<String>) -> Self {
        Self { field: field.into(), why: why.into() }
    }
}

/// Resolves places on a map.
pub(crate) struct PlaceResolver<'a> {
    pub(crate) map: Map<'a>,
    lines: Lines<'a>,
    /// Made once, where a place needs it.
    projector: OnceCell<Result<Projector, String>>,
}

impl<'a> PlaceResolver<'a> {
    pub(crate) fn new(map: Map<'a>) -> Self {
        Self { map, lines: Lines::new(map), projector: OnceCell::new() }
    }

    /// What lines may measure yet within the map `[m]`; negative: there were too many.
    pub(crate) fn left(&self) -> f64 {
        self.lines.left()
    }

    fn projector(&self) -> Result<&Projector, String> {
        let make = || self.map.projector().map_err(|error| error.to_string());
        self.projector.get_or_init(make).as_ref().map_err(Clone::clone)
    }
}

/// The stretches of all places of an entry.
pub(crate) struct ResolvedPlaces<'a> {
    pub(crate) stretches: Vec<Stretch<'a>>,
    /// What could not be placed.
    pub(crate) unplaced: Vec<PlaceError>,
    /// Where the stretches of each place end, in the order of [`field`].
    pub(crate) ends: Vec<u32>,
}

/// The field of an entry that one of its places was given in, by its number: places on Earth come first, then lanes, then objects.
pub(crate) fn field(entry: &Entry, number: usize) -> String {
    let [places, lanes] = [entry.places.len(), entry.places.len() + entry.lanes.len()];
    match number {
        _ if number < places => format!("places[{number}]"),
        _ if number < lanes => format!("lanes[{}].s", number - places),
        _ => format!("objects[{}]", number - lanes),
    }
}

/// Resolves all places of an entry.
///
/// Errors: the first place that the map does not have.
pub(crate) fn resolve_places<'a>(
    resolver: &PlaceResolver<'a>,
    entry: &Entry,
) -> Result<ResolvedPlaces<'a>, PlaceError> {
    let map = resolver.map;
    let (mut stretches, mut unplaced, mut ends) = (Vec::new(), Vec::new(), Vec::new());
    for (i, place) in entry.places.iter().enumerate() {
        let named =
            |error: PlaceError| PlaceError::new(format!("places[{i}].{}", error.field), error.why);
        let none = |why: String| PlaceError::new(format!("places[{i}]"), why);
        let projector = resolver.projector().map_err(none)?;
        let place = on_earth(map, &resolver.lines, projector, place).map_err(named)?;
        stretches.extend(place.stretches);
        unplaced.extend(place.unplaced.into_iter().map(named));
        ends.push(stretches.len() as u32);
    }
    for (i, place) in entry.lanes.iter().enumerate() {
        of_lanes(map, place, &mut stretches)
            .map_err(|(field, why)| PlaceError::new(format!("lanes[{i}].{field}"), why))?;
        ends.push(stretches.len() as u32);
    }
    for (i, id) in entry.objects.iter().enumerate() {
        let unfit = |why: &str| PlaceError::new(format!("objects[{i}]"), why);
        let object = map.object_by_id(id).ok_or_else(|| unfit("the map has no such object"))?;
        let before = stretches.len();
        for on in object.lanes() {
            if let Some(lane) = on.lane().filter(|lane| lane.nodes().next().is_some()) {
                let SRange { low: s_from, high: s_to } = on.s_range();
                let middle = 0.5 * (s_from + s_to);
                let half = (0.5 * (s_to - s_from)).max(0.5 * WIDENED);
                stretches.push(Stretch { lane, s_from: middle - half, s_to: middle + half });
            }
        }
        if stretches.len() == before {
            return Err(unfit("the object lies on no lane"));
        }
        ends.push(stretches.len() as u32);
    }
    Ok(ResolvedPlaces { stretches, unplaced, ends })
}

fn of_lanes<'a>(
    map: Map<'a>,
    place: &LaneStretch,
    found: &mut Vec<Stretch<'a>>,
) -> Result<(), (&'static str, String)> {
    if let Some(text) = &place.key {
        let key: LaneKey<'_> = text.parse().map_err(|error| ("key", format!("{error}")))?;
        let lane = map.lane_by_key(&key).filter(|lane| lane.nodes().next().is_some());
        let lane =
            lane.ok_or_else(|| ("key", "the map has no such lane to drive on".to_owned()))?;
        let (start, end) = (lane.section().s_start(), lane.section().s_end());
        let (s_from, s_to) = range(place, &lane.road())?;
        if s_from >= end || s_to <= start {
            return Err(("s", format!("the lane reaches from {start} m to {end} m")));
        }
        found.push(Stretch { lane, s_from: s_from.max(start), s_to: s_to.min(end) });
        return Ok(());
    }
    let id = place.road.as_ref().map(ToString::to_string).unwrap_or_default();
    let road =
        map.road_by_id(&id).ok_or_else(|| ("road", format!("the map has no road {id:?}")))?;
    let (s_from, s_to) = range(place, &road)?;
    let before = found.len();
    for section in road.sections() {
        let (from, to) = (section.s_start().max(s_from), section.s_end().min(s_to));
        if from >= to {
            continue;
        }
        let wanted = |lane: &Lane<'a>| place.lane.is_none_or(|number| lane.number() == number);
        let driven = |lane: &Lane<'a>| lane.nodes().next().is_some();
        for lane in section.lanes().filter(wanted).filter(driven) {
            found.push(Stretch { lane, s_from: from, s_to: to });
        }
    }
    if found.len() == before {
        let lane = place.lane.map_or_else(|| "lanes".to_owned(), |number| format!("lane {number}"));
        return Err(("lane", format!("road {id} has no {lane} from {s_from} m to {s_to} m")));
    }
    Ok(())
}

/// From where to where, on the road.
fn range(place: &LaneStretch, road: &Road<'_>) -> Result<(f64, f64), (&'static str, String)> {
    let length = road.length();
    let Some([from, to]) = place.s else { return Ok((0.0, length)) };
    if from < -ROUNDED || to > length + ROUNDED {
        return Err(("s", format!("road {} reaches from 0 m to {length} m", road.id())));
    }
    if to - from < SHORTEST {
        return Err(("s", format!("shorter than {SHORTEST} m")));
    }
    Ok((from.max(0.0), to.min(length)))
}
