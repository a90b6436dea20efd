//! Places by latitude and longitude: lines that are driven along, and areas.
//!
//! Lines are of `line`. Of an area each lane's cross-sections are compared with it. Heights are not looked at: lanes above and below each other lie in
//! the same area.

use crate::line::Lines;
use crate::place::EarthPlace;
use crate::places::{PlaceError, Stretch, WIDENED};
use mapd_query::geodesy::{Geodetic, Projector};
use mapd_query::glam::DVec2;
use mapd_query::{Lane, LaneTypes, Map, Region};
use std::ops::RangeInclusive;

/// How far apart cross-sections are compared with an area `[m]`. What is smaller is found by its corners.
const AREA_STEP: f64 = 0.5;

/// Cross-sections between two stored points of a lane at most: those of 1,000 km. Only a damaged archive has longer stretches.
const MOST_STATIONS: usize = 1 << 21;

/// Ends are found to this `[m]`.
const EXACT: f64 = 1e-3;

/// Halvings towards an end at most: between large numbers there may be none that is near enough.
const MOST_HALVINGS: usize = 64;

/// The stretches of one place.
pub(crate) struct ResolvedPlace<'a> {
    pub(crate) stretches: Vec<Stretch<'a>>,
    /// What could not be placed.
    pub(crate) unplaced: Vec<PlaceError>,
}

/// The stretches that a place means.
///
/// Errors: none can be told; the first reason.
pub(crate) fn on_earth<'a>(
    map: Map<'a>,
    lines: &Lines<'a>,
    projector: &Projector,
    place: &EarthPlace,
) -> Result<ResolvedPlace<'a>, PlaceError> {
    let field = if place.area.is_empty() { "line" } else { "area" };
    let given = if place.area.is_empty() { &place.line } else { &place.area };
    let mut points = Vec::with_capacity(given.len());
    for (i, [latitude, longitude]) in given.iter().copied().enumerate() {
        let point = projector
            .from_geodetic(Geodetic { latitude, longitude, altitude: 0.0 })
            .map_err(|error| {
                let why = format!("outside the map's projection: {error}");
                PlaceError::new(format!("{field}[{i}]"), why)
            })?;
        points.push(point.truncate());
    }
    if place.area.is_empty() {
        lines.stretches(&points, place)
    } else {
        Area::new(&points, place.tolerance.unwrap_or(0.0)).stretches(map)
    }
}

/// Rows into which an area is cut at most, so that a cross-section is compared with the sides near it alone.
const MOST_ROWS: usize = 256;

/// An area and what is not farther from it than a tolerance.
struct Area<'p> {
    ring: &'p [DVec2],
    tolerance: f64,
    /// Lowest y, and rows for each metre upwards.
    low: f64,
    rows_per_metre: f64,
    /// Of each row the sides that touch it, by the number of the corner that they begin at.
    rows: Vec<Vec<u32>>,
}

impl<'p> Area<'p> {
    fn new(ring: &'p [DVec2], tolerance: f64) -> Self {
        let ends = ring.iter().map(|corner| corner.y);
        let (low, high) = ends
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
        let count = ring.len().clamp(1, MOST_ROWS);
        let rows_per_metre = count as f64 / (high - low).max(EXACT);
        let rows = vec![Vec::new(); count];
        let mut area = Self { ring, tolerance, low, rows_per_metre, rows };
        for number in 0..ring.len() as u32 {
            let [p, q] = area.side(number);
            for row in area.rows_of(p.y.min(q.y), p.y.max(q.y)) {
                area.rows[row].push(number);
            }
        }
        area
    }

    fn side(&self, number: u32) -> [DVec2; 2] {
        let i = number as usize;
        [self.ring[i], self.ring[(i + 1) % self.ring.len()]]
    }

    /// Rows between two y; the outermost ones have all beyond.
    fn rows_of(&self, from: f64, to: f64) -> RangeInclusive<usize> {
        let row =
            |y: f64| (((y - self.low) * self.rows_per_metre) as usize).min(self.rows.len() - 1);
        row(from)..=row(to)
    }

    /// Sides that may have a place between two y; one may be told several times.
    fn sides(&self, from: f64, to: f64) -> impl Iterator<Item = [DVec2; 2]> {
        let rows = self.rows_of(from, to);
        rows.flat_map(|row| &self.rows[row]).map(|number| self.side(*number))
    }

    fn stretches<'a>(&self, map: Map<'a>) -> Result<ResolvedPlace<'a>, PlaceError> {
        let unfit = |why: String| PlaceError::new("area", why);
        let low = self.ring.iter().copied().reduce(DVec2::min).unwrap_or_default();
        let high = self.ring.iter().copied().reduce(DVec2::max).unwrap_or_default();
        let region = Region { low: low - self.tolerance, high: high + self.tolerance };
        let mut lanes = Vec::new();
        map.lanes_in(region, LaneTypes::ALL, &mut lanes)
            .map_err(|error| unfit(error.to_string()))?;
        let mut stretches = Vec::new();
        for lane in lanes.into_iter().filter_map(|id| map.lane(id).ok()) {
            if lane.nodes().next().is_some() {
                self.of_lane(lane, region, &mut stretches);
            }
        }
        match stretches.is_empty() {
            true => Err(unfit("no lane lies in it".to_owned())),
            false => Ok(ResolvedPlace { stretches, unplaced: Vec::new() }),
        }
    }

    /// Adds the stretches of a lane whose cross-sections meet the area.
    fn of_lane<'a>(&self, lane: Lane<'a>, region: Region, found: &mut Vec<Stretch<'a>>) {
        let mut stations: Vec<f64> = Vec::new();
        let line: Vec<_> = lane.center_line().points().collect();
        for pair in line.windows(2) {
            let [from, to] = [pair[0].s, pair[1].s];
            let reach = lane.width_at(from).max(lane.width_at(to));
            let [a, b] = [pair[0], pair[1]].map(|point| point.position.truncate());
            let is_near = a.max(b).cmpge(region.low - reach).all()
                && a.min(b).cmple(region.high + reach).all();
            if is_near {
                let count = (((to - from) / AREA_STEP).ceil() as usize).clamp(1, MOST_STATIONS);
                let at = |i: usize| from + (to - from) * i as f64 / count as f64;
                stations.extend((0..=count).map(at));
            }
        }
        // What is narrower than a step.
        let lows = line.iter().map(|point| point.position.truncate()).reduce(DVec2::min);
        let highs = line.iter().map(|point| point.position.truncate()).reduce(DVec2::max);
        let (Some(low), Some(high)) = (lows, highs) else { return };
        let widest = line.iter().map(|point| lane.width_at(point.s)).fold(0.0, f64::max);
        let reach = widest + self.tolerance;
        let is_near =
            |corner: &&DVec2| corner.cmpge(low - reach).all() && corner.cmple(high + reach).all();
        let corners = self.ring.iter().filter(is_near);
        let corners = corners.filter_map(|corner| lane.position_of(*corner).ok());
        stations.extend(corners.filter(|at| at.distance <= self.tolerance).map(|at| at.s));
        stations.sort_by(f64::total_cmp);
        let mut last: Option<(f64, bool)> = None;
        let mut begin = None;
        for s in stations {
            let meets = self.meets(&lane, s);
            match last {
                _ if meets && begin.is_none() => {
                    let out = last.filter(|(before, _)| s - before <= AREA_STEP + EXACT);
                    begin = Some(out.map_or(s, |(out, _)| self.end(&lane, s, out)));
                }
                Some((inside, true)) if !meets => {
                    push(lane, begin.take(), self.end(&lane, inside, s), found);
                }
                Some((inside, true)) if s - inside > AREA_STEP + EXACT => {
                    push(lane, begin.replace(s), inside, found);
                }
                _ => {}
            }
            last = Some((s, meets));
        }
        if let Some((end, true)) = last {
            push(lane, begin, end, found);
        }
    }

    /// Where the area ends between a station in it and one outside.
    fn end(&self, lane: &Lane<'_>, mut inside: f64, mut outside: f64) -> f64 {
        for _ in 0..MOST_HALVINGS {
            if (outside - inside).abs() <= EXACT {
                break;
            }
            let middle = 0.5 * (inside + outside);
            if self.meets(lane, middle) { inside = middle } else { outside = middle }
        }
        inside
    }

    /// Whether the lane's cross-section meets the area.
    fn meets(&self, lane: &Lane<'_>, s: f64) -> bool {
        let Some([a, b]) = lane.edge_points_at(s).map(|ends| ends.map(|end| end.truncate())) else {
            return false;
        };
        let crossed = self.sides(a.y, a.y).filter(|[p, q]| {
            let is_between = (p.y > a.y) != (q.y > a.y);
            is_between && a.x < p.x + (a.y - p.y) / (q.y - p.y) * (q.x - p.x)
        });
        crossed.count() % 2 == 1
            || self
                .sides(a.y.min(b.y) - self.tolerance, a.y.max(b.y) + self.tolerance)
                .any(|side| distance([a, b], side) <= self.tolerance)
    }
}

fn push<'a>(lane: Lane<'a>, begin: Option<f64>, end: f64, found: &mut Vec<Stretch<'a>>) {
    let Some(begin) = begin else { return };
    let (middle, half) = (0.5 * (begin + end), (0.5 * (end - begin)).max(0.5 * WIDENED));
    found.push(Stretch { lane, s_from: middle - half, s_to: middle + half });
}

/// Distance of two segments.
fn distance([a, b]: [DVec2; 2], [p, q]: [DVec2; 2]) -> f64 {
    let side = |a: DVec2, b: DVec2, p: DVec2| (b - a).perp_dot(p - a);
    let apart = |a, b, p, q| side(a, b, p) * side(a, b, q) > 0.0;
    let parallel = (b - a).perp_dot(q - p) == 0.0;
    if !parallel && !apart(a, b, p, q) && !apart(p, q, a, b) {
        return 0.0;
    }
    let to = |x: DVec2, a: DVec2, b: DVec2| {
        let along = b - a;
        let share = (x - a).dot(along) / along.length_squared();
        // Also of no number, where both ends are one.
        x.distance(a + along * if share > 0.0 { share.min(1.0) } else { 0.0 })
    };
    to(a, p, q).min(to(b, p, q)).min(to(p, a, b)).min(to(q, a, b))
}
