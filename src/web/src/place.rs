//! What lies at a place.

use crate::drawing::level;
use crate::sheet::{Kind, Link};
use mapd_query::geodesy::Geodetic;
use mapd_query::glam::{DVec2, DVec3};
use mapd_query::{Map, Nearest, NearestOptions, QueryError};
use serde::Serialize;

/// Distance from a lane up to which a place counts as beside it `[m]`.
const BESIDE: f64 = 10.0;

/// A place in plan view.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlanPoint {
    /// Inertial `[m]`.
    pub x: f64,
    /// Inertial `[m]`.
    pub y: f64,
    /// Latitude and longitude `[deg]`, if the map has a georeference whose projection this build has.
    pub geodetic: Option<[f64; 2]>,
    /// The lane at the place, or beside it.
    pub lane: Option<LaneHere>,
}

/// A place with respect to a lane.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LaneHere {
    /// Its key.
    pub key: String,
    /// Its row.
    pub row: u32,
    /// Its type.
    pub kind: &'static str,
    /// Id of its road.
    pub road: String,
    /// Along the reference line `[m]`.
    pub s: f64,
    /// From the reference line `[m]`, positive to the left.
    pub t: f64,
    /// From the lane's centre `[m]`, positive to the left as its traffic goes.
    pub offset: f64,
    /// From the lane's area `[m]`, 0 inside.
    pub distance: f64,
    /// Height of the plane h = 0 `[m]`.
    pub z: f64,
    /// The way the lane's traffic goes `[rad]`.
    pub heading: f64,
}

impl PlanPoint {
    /// What lies at x and y: of lanes above each other the highest, on one level one that is driven on first.
    ///
    /// Errors: coordinates that are not finite.
    pub fn at(map: Map<'_>, x: f64, y: f64) -> Result<Self, QueryError> {
        let found = top_lane(map, DVec2::new(x, y), |_| true)?;
        let lane = found.and_then(|found| {
            let (lane, position) = (map.lane(found.lane).ok()?, found.position);
            Some(LaneHere {
                key: lane.key().to_string(),
                row: found.lane.row(),
                kind: lane.kind().name(),
                road: lane.road().id().to_owned(),
                s: position.s,
                t: position.t,
                offset: position.offset,
                distance: position.distance,
                z: position.z,
                heading: position.heading,
            })
        });
        let z = lane.as_ref().map_or(map.bounds().low.z, |lane| lane.z);
        let projector = map.projector().ok();
        let place = projector.and_then(|one| one.to_geodetic(DVec3::new(x, y, z)).ok());
        let geodetic = place.map(|place| [place.latitude, place.longitude]);
        Ok(Self { x, y, geodetic, lane })
    }

    /// What lies at a latitude and longitude `[deg]`.
    ///
    /// Errors: a sentence that says why there is no such place on the map.
    pub fn at_geodetic(map: Map<'_>, latitude: f64, longitude: f64) -> Result<Self, String> {
        let projector = map.projector().map_err(|error| error.to_string())?;
        let place = Geodetic { latitude, longitude, altitude: map.bounds().low.z };
        let point = projector.from_geodetic(place).map_err(|error| error.to_string())?;
        Self::at(map, point.x, point.y).map_err(|error| error.to_string())
    }
}

/// The lane that is seen at a point: the nearest; of several that hold the point the highest, on one level one that is driven
/// on first.
///
/// Errors: coordinates that are not finite.
pub(crate) fn top_lane(
    map: Map<'_>,
    point: DVec2,
    wanted: impl Fn(&mapd_query::Lane<'_>) -> bool,
) -> Result<Option<Nearest>, QueryError> {
    let options = NearestOptions { radius: BESIDE, ..NearestOptions::default() };
    let mut near = Vec::new();
    map.lanes_near(point, &options, &mut near)?;
    near.retain(|found| map.lane(found.lane).is_ok_and(|lane| wanted(&lane)));
    let rank = |found: &Nearest| {
        let is_driven = map.lane(found.lane).is_ok_and(|lane| lane.kind().is_drivable());
        (level(found.position.z), is_driven)
    };
    // The first of equals, which is the one that the query prefers.
    let inside = near.iter().rev().filter(|found| found.position.distance == 0.0);
    Ok(inside.max_by_key(|found| rank(found)).or(near.first()).copied())
}

/// What lies at a point, what is seen first at first: signals and objects as near as `radius` `[m]`, lanes, and parts that are
/// left out.
///
/// Errors: numbers that are not finite.
pub fn pick(map: Map<'_>, x: f64, y: f64, radius: f64) -> Result<Vec<Link>, QueryError> {
    let point = DVec2::new(x, y);
    let (mut signals, mut objects, mut lanes) = (Vec::new(), Vec::new(), Vec::new());
    map.signals_near(point, radius, &mut signals)?;
    let mut found: Vec<Link> = Vec::new();
    let link = |kind, row| Link { kind, row };
    found.extend(signals.iter().map(|near| link(Kind::Signal, near.signal.row())));
    map.objects_near(point, radius, &mut objects)?;
    found.extend(objects.iter().map(|near| link(Kind::Object, near.place.object.row())));
    let parts = map.quarantined().enumerate();
    let here = parts.filter(|(_, part)| part.distance(point) == Some(0.0));
    found.extend(here.map(|(row, _)| link(Kind::Quarantine, row as u32)));
    let top = top_lane(map, point, |_| true)?.filter(|top| top.position.distance <= radius);
    found.extend(top.map(|top| link(Kind::Lane, top.lane.row())));
    let options = NearestOptions { radius: 0.0, ..NearestOptions::default() };
    map.lanes_near(point, &options, &mut lanes)?;
    found.extend(lanes.iter().map(|near| link(Kind::Lane, near.lane.row())));
    let mut seen = Vec::new();
    found.retain(|one| {
        let is_new = !seen.contains(one);
        seen.push(*one);
        is_new
    });
    Ok(found)
}
