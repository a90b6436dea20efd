//! The kinds of queries and their columns.

use super::earth::Earth;
use super::holes::Holes;
use super::path::{self, PathQuestion, Paths};
use super::route::Router;
use super::row::Row;
use super::{besides, landmarks, localising, matching, signals};
use clap::ValueEnum;
use mapd_client::localisation::VehicleOutline;
use mapd_client::{Lane, Map, NearestOptions, Point, QueryError, Road, Track};
use mapd_query::glam::DVec2;
use mapd_query::route::PositionOnLane;

/// Origin of a speed limit that an entry of the overlay states.
const OVERLAY: &str = "overlay";

/// A value of s may lie this far `[m]` outside the road: rounding in somebody's file.
const S_TOLERANCE: f64 = 1e-6;

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// `road_id,s,t[,h]` → x,y,z,hdg
    Inertial,
    /// `road_id,s,t` → x,y,z of the road's surface, its normal, the lane's friction and roughness
    Surface,
    /// `road_id,s,lane_id` → width,t_inner,t_outer,x,y,z,hdg of the lane's centre
    Lane,
    /// `x,y[,z][,hdg]` or `lat,lon[,alt][,hdg]` → lane,road_id,lane_id,s,t,offset,distance
    Nearest,
    /// `x,y,hdg,sx,sy,shdg[,z]` → a row for each lane that a pose may be in: lane,direction,probability,s,offset,heading_difference,mahalanobis
    Match,
    /// `x,y[,z]` → z,nx,ny,nz,lane,material,level of the ground there
    Ground,
    /// `x,y` → distance,side,kind,color,lane,s,painted of the nearest road mark
    NearestMarks,
    /// `x,y[,z]` → lat,lon,alt
    Geodetic,
    /// `lat,lon[,alt]` → x,y,z
    FromGeodetic,
    /// `road_id,x,y[,z]` → s,t,h, whether s was clamped, and whether s, t, h is exactly the point
    Track,
    /// `road_id,s,lane_id` → successors in driving direction
    Successors,
    /// `from_road,from_s,from_lane,to_road,to_s,to_lane` → length,lane_changes,lanes
    Route,
    /// `x,y,radius` → a row for each object there: id,class,distance,road_id,s,t,x,y,z
    Objects,
    /// `x,y,radius[,classes]` → a row for each landmark for localisation there: as objects, and hdg,length,width,height,kind
    Landmarks,
    /// as route → a row for each station: S,x,y,z,hdg,curvature,lane,left,right,speed
    Path,
    /// as route → a row for each station: S, both edges of the driven lane, their marks, whether a lane change is allowed there, what lies beyond, speed, friction
    Corridor,
    /// as route, and `x,y[,hdg]` → S,d,heading_difference,lane,clamped
    Project,
    /// as route → a row for each conflict on the path: S_from,S_to, the other lane and its s, kind, who yields, why, where to wait, what that rests on, all lanes
    Conflicts,
    /// `road_id,s,lane_id` → speed limit and its origin
    Speed,
    /// `road_id,s,lane_id,distance` → a row for each signal ahead: id,class,distance,road_id,s,t,x,y,z,state_machine,method,value,out_of_service
    Signals,
    /// `owner[,id]` → a row for each annotation: kind,path,name,value,text,file,line,column
    Annotations,
    /// `road_id,s,lane_id` → forward,back,left,right: visibility range
    Visibility,
    /// `road_id,s,lane_id` → rule as text
    LaneRule,
    /// `junction_id` → a row for each group of the junction: group,name,type,junctions,ring
    JunctionGroups,
}

/// What questions are answered with, kept from row to row.
pub(crate) struct Tools<'a> {
    /// Finds routes.
    pub(super) router: Router<'a>,
    /// The path of the last route.
    pub(super) paths: Paths,
    /// Latitudes and longitudes.
    pub(super) earth: Earth,
    /// What is left out of the map.
    pub(super) holes: Holes<'a>,
    /// Plan view of the vehicles.
    pub(super) outline: Option<VehicleOutline>,
}

impl Kind {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Inertial => "inertial",
            Self::Surface => "surface",
            Self::Lane => "lane",
            Self::Nearest => "nearest",
            Self::Match => "match",
            Self::Ground => "ground",
            Self::NearestMarks => "nearest-marks",
            Self::Geodetic => "geodetic",
            Self::FromGeodetic => "from-geodetic",
            Self::Track => "track",
            Self::Successors => "successors",
            Self::Route => "route",
            Self::Objects => "objects",
            Self::Landmarks => "landmarks",
            Self::Signals => "signals",
            Self::Path => "path",
            Self::Corridor => "corridor",
            Self::Project => "project",
            Self::Conflicts => "conflicts",
            Self::Speed => "speed",
            Self::Annotations => "annotations",
            Self::Visibility => "visibility",
            Self::LaneRule => "lane-rule",
            Self::JunctionGroups => "junction-groups",
        }
    }

    /// Columns that the input must have: those of one of these.
    pub(crate) fn needs(self) -> &'static [&'static [&'static str]] {
        match self {
            Self::Inertial | Self::Surface => &[&["road_id", "s", "t"]],
            Self::Lane | Self::Successors | Self::Speed | Self::Visibility | Self::LaneRule => {
                &[&["road_id", "s", "lane_id"]]
            }
            Self::Annotations => &[&["owner"]],
            Self::JunctionGroups => &[&["junction_id"]],
            Self::Nearest => &[&["x", "y"], &["lat", "lon"]],
            Self::Match => &[&["x", "y", "hdg", "sx", "sy", "shdg"]],
            Self::Geodetic | Self::Ground | Self::NearestMarks => &[&["x", "y"]],
            Self::FromGeodetic => &[&["lat", "lon"]],
            Self::Track => &[&["road_id", "x", "y"]],
            Self::Route | Self::Path | Self::Corridor | Self::Conflicts => &[&path::ROUTE],
            Self::Project => {
                &[&["from_road", "from_s", "from_lane", "to_road", "to_s", "to_lane", "x", "y"]]
            }
            Self::Signals => &[&["road_id", "s", "lane_id", "distance"]],
            Self::Objects | Self::Landmarks => &[&["x", "y", "radius"]],
        }
    }

    /// Columns of the answer.
    pub(crate) fn answers(self) -> &'static [&'static str] {
        match self {
            Self::Inertial => &["x", "y", "z", "hdg"],
            Self::Surface => &["x", "y", "z", "nx", "ny", "nz", "friction", "roughness"],
            Self::Lane => &["width", "t_inner", "t_outer", "x", "y", "z", "hdg"],
            Self::Nearest => &["lane", "road_id", "lane_id", "s", "t", "offset", "distance"],
            Self::Match => matching::COLUMNS,
            Self::Ground => localising::GROUND,
            Self::NearestMarks => localising::MARKS,
            Self::Geodetic => &["lat", "lon", "alt"],
            Self::FromGeodetic => &["x", "y", "z"],
            Self::Track => &["s", "t", "h", "clamped", "exact"],
            Self::Successors => &["successors"],
            Self::Route => &["length", "lane_changes", "lanes"],
            Self::Objects => {
                &["id", "class", "distance", "road_id", "s", "t", "x", "y", "z", "value"]
            }
            Self::Path => {
                &["S", "x", "y", "z", "hdg", "curvature", "lane", "left", "right", "speed"]
            }
            Self::Corridor => &[
                "S",
                "left_x",
                "left_y",
                "right_x",
                "right_y",
                "left_mark",
                "right_mark",
                "left_may_cross",
                "right_may_cross",
                "left_edge",
                "right_edge",
                "speed",
                "friction",
            ],
            Self::Project => &["S", "d", "heading_difference", "lane", "clamped"],
            Self::Conflicts => &[
                "S_from",
                "S_to",
                "other_lane",
                "other_s_from",
                "other_s_to",
                "kind",
                "yields",
                "reason",
                "wait_S",
                "basis",
                "other_lanes",
            ],
            Self::Speed => &["speed", "origin"],
            Self::Landmarks => landmarks::COLUMNS,
            Self::Signals => signals::COLUMNS,
            Self::Annotations => besides::ANNOTATIONS,
            Self::Visibility => &["forward", "back", "left", "right"],
            Self::LaneRule => &["rule"],
            Self::JunctionGroups => besides::GROUPS,
        }
    }

    /// Whether it is about places of the map, some of which may be in quarantine.
    pub(crate) fn concerns_places(self) -> bool {
        !matches!(self, Self::Geodetic | Self::FromGeodetic)
    }

    /// Whether it answers with any number of rows.
    pub(crate) fn lists(self) -> bool {
        matches!(
            self,
            Self::Match
                | Self::Objects
                | Self::Route
                | Self::Path
                | Self::Corridor
                | Self::Conflicts
                | Self::Landmarks
                | Self::Signals
                | Self::Annotations
                | Self::JunctionGroups
        )
    }

    /// Answers one row; the error says why there is no answer.
    pub(crate) fn answer<'a>(
        self,
        map: Map<'a>,
        options: &NearestOptions,
        tools: &mut Tools<'a>,
        row: &Row<'_>,
        out: &mut Vec<String>,
    ) -> Result<(), String> {
        let Tools { router, earth, holes, outline, .. } = &mut *tools;
        match self {
            Self::Inertial => {
                let road = road(holes, map, row)?;
                let track = Track {
                    s: s_on(&road, row)?,
                    t: row.number("t")?,
                    h: row.optional("h")?.unwrap_or(0.0),
                };
                let pose = road.to_inertial(track).map_err(text)?;
                numbers(out, &[pose.position.x, pose.position.y, pose.position.z, pose.heading]);
            }
            Self::Surface => {
                let road = road(holes, map, row)?;
                let found = road.surface_at(s_on(&road, row)?, row.number("t")?).map_err(text)?;
                numbers(out, &found.position.to_array());
                numbers(out, &found.normal.to_array());
                let material = found.material;
                for value in [material.and_then(|m| m.friction), material.and_then(|m| m.roughness)]
                {
                    out.push(value.map(number).unwrap_or_default());
                }
            }
            Self::Lane => {
                let (lane, s) = lane(holes, map, row)?;
                let edges = lane.edges_at(s);
                let pose = lane.pose_at(s, 0.0).map_err(text)?;
                let (p, hdg) = (pose.position, pose.heading);
                numbers(out, &[edges.width(), edges.inner, edges.outer, p.x, p.y, p.z, hdg]);
            }
            Self::Nearest => nearest(map, options, point_in(row, earth)?, row, out)?,
            Self::Match => matching::answer(map, options, *outline, row, out)?,
            Self::Ground => localising::ground(map, point(row)?, out)?,
            Self::NearestMarks => localising::mark(map, point(row)?, options, out)?,
            Self::Geodetic => {
                let point = point(row)?;
                numbers(out, &earth.place(point.xy.extend(point.z.unwrap_or(0.0)))?);
            }
            Self::FromGeodetic => numbers(out, &earth.point(row)?.to_array()),
            Self::Track => {
                let road = road(holes, map, row)?;
                let point = point(row)?;
                let track = road.to_track(point).map_err(text)?;
                numbers(out, &[track.s, track.t]);
                out.push(track.h.map(number).unwrap_or_default());
                out.push(track.clamped.name().to_owned());
                out.push(u8::from(track.exact).to_string());
            }
            Self::Successors => {
                let (lane, _) = lane(holes, map, row)?;
                let mut keys = Vec::new();
                successors(map, &lane, &mut keys).map_err(text)?;
                out.push(keys.join(";"));
            }
            Self::Path => path::answer(PathQuestion::Line, tools, map, row, out)?,
            Self::Corridor => path::answer(PathQuestion::Corridor, tools, map, row, out)?,
            Self::Project => path::answer(PathQuestion::Project, tools, map, row, out)?,
            Self::Conflicts => path::answer(PathQuestion::Conflicts, tools, map, row, out)?,
            Self::Speed => {
                let (lane, s) = lane(holes, map, row)?;
                let rule = router.view().speed_rule_at(lane.lane_id(), s, router.vehicle());
                let rule = rule.map_err(text)?;
                out.push(rule.max.map(number).unwrap_or_default());
                let by_overlay = rule.restriction.map(|_| OVERLAY);
                out.push(by_overlay.unwrap_or(rule.map.origin.name()).to_owned());
            }
            Self::Route => router.answer(holes, map, row, out)?,
            Self::Objects => super::objects::answer(map, row, out)?,
            Self::Landmarks => landmarks::answer(map, row, out)?,
            Self::Signals => {
                let (lane, s) = lane(holes, map, row)?;
                let from = PositionOnLane { lane: lane.lane_id(), s };
                signals::answer(router, from, row.not_negative("distance")?, out)?;
            }
            Self::Annotations => besides::annotations(map, holes, row, out)?,
            Self::Visibility => {
                let (lane, s) = lane(holes, map, row)?;
                besides::visibility(lane.visibility_at(s), out);
            }
            Self::LaneRule => {
                let (lane, s) = lane(holes, map, row)?;
                out.push(lane.rule_at(s).map_or("", |rule| rule.value).to_owned());
            }
            Self::JunctionGroups => besides::groups(map, holes, row, out)?,
        }
        Ok(())
    }
}

fn nearest(
    map: Map<'_>,
    options: &NearestOptions,
    point: Point,
    row: &Row<'_>,
    out: &mut Vec<String>,
) -> Result<(), String> {
    let options = NearestOptions { heading: row.optional("hdg")?, ..*options };
    let hit = map.nearest_lane(point, &options).map_err(text)?;
    let hit = hit.ok_or_else(|| format!("no lane within {} m", options.radius))?;
    let lane = map.lane(hit.lane).map_err(text)?;
    out.push(lane.key().to_string());
    out.push(lane.road().id().to_owned());
    out.push(lane.number().to_string());
    let position = hit.position;
    let offset = position.offset_of_reference_line;
    numbers(out, &[position.s, position.t, offset, position.distance]);
    Ok(())
}

/// Keys of a lane's successors; where the lane itself goes on, those of its last piece.
fn successors(map: Map<'_>, lane: &Lane<'_>, keys: &mut Vec<String>) -> Result<(), QueryError> {
    let mut last = *lane;
    // A road has no more pieces of a lane than sections.
    for _ in 0..map.tables().sections.len() {
        let next = last.successors().map(|id| map.lane(id)).find(|next| {
            // A ring's lane may follow itself; that is no piece of it.
            let section = last.section().section_id();
            next.as_ref()
                .is_ok_and(|n| n.key() == lane.key() && n.section().section_id() != section)
        });
        match next {
            Some(next) => last = next?,
            None => break,
        }
    }
    for id in last.successors() {
        keys.push(map.lane(id)?.key().to_string());
    }
    Ok(())
}

pub(super) fn text(error: QueryError) -> String {
    error.to_string()
}

pub(crate) fn number(value: f64) -> String {
    // Debug is the shortest form that reads back as the same number, with an exponent where that is shorter.
    format!("{value:?}")
}

pub(crate) fn numbers(out: &mut Vec<String>, values: &[f64]) {
    out.extend(values.iter().map(|value| number(*value)));
}

fn point(row: &Row<'_>) -> Result<Point, String> {
    Ok(Point { xy: DVec2::new(row.number("x")?, row.number("y")?), z: row.optional("z")? })
}

/// The point of a row that has x and y, or latitude and longitude.
pub(crate) fn point_in(row: &Row<'_>, earth: &Earth) -> Result<Point, String> {
    if row.has("x") && row.has("y") {
        return point(row);
    }
    let at = earth.point(row)?;
    Ok(Point { xy: at.truncate(), z: row.optional("alt")?.map(|_| at.z) })
}

fn road<'a>(holes: &Holes<'_>, map: Map<'a>, row: &Row<'_>) -> Result<Road<'a>, String> {
    road_in(holes, map, row, "road_id")
}

fn road_in<'a>(
    holes: &Holes<'_>,
    map: Map<'a>,
    row: &Row<'_>,
    column: &str,
) -> Result<Road<'a>, String> {
    let id = row.text(column)?;
    map.road_by_id(id).ok_or_else(|| holes.no_road(id))
}

fn s_on(road: &Road<'_>, row: &Row<'_>) -> Result<f64, String> {
    s_in(road, row, "s")
}

/// s within the road, give or take rounding.
fn s_in(road: &Road<'_>, row: &Row<'_>, column: &str) -> Result<f64, String> {
    let s = row.number(column)?;
    let length = road.length();
    if s < -S_TOLERANCE || s > length + S_TOLERANCE {
        return Err(format!("s must lie between 0 and the road's length {length:?}, found {s:?}"));
    }
    Ok(if s > length { length } else { s.max(0.0) })
}

/// The lane with a number at s.
pub(super) fn lane<'a>(
    holes: &Holes<'_>,
    map: Map<'a>,
    row: &Row<'_>,
) -> Result<(Lane<'a>, f64), String> {
    lane_in(holes, map, row, LaneColumns { road: "road_id", s: "s", lane: "lane_id" })
}

/// Names of the columns that say where on a lane.
pub(super) struct LaneColumns {
    pub(super) road: &'static str,
    pub(super) s: &'static str,
    /// Its number.
    pub(super) lane: &'static str,
}

/// As [`lane`], from columns of these names.
pub(super) fn lane_in<'a>(
    holes: &Holes<'_>,
    map: Map<'a>,
    row: &Row<'_>,
    columns: LaneColumns,
) -> Result<(Lane<'a>, f64), String> {
    let road = road_in(holes, map, row, columns.road)?;
    let s = s_in(&road, row, columns.s)?;
    let number = row.lane_number(columns.lane)?;
    let missing =
        |what: String| holes.because(road.id(), format!("road {:?} has {what}", road.id()));
    let section = road.section_at(s).ok_or_else(|| missing("no lane section".to_owned()))?;
    let lane =
        section.lane(number).ok_or_else(|| missing(format!("no lane {number} at s = {s:?}")))?;
    Ok((lane, s))
}
