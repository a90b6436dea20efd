//! Where cross-sections of a road are kept.

use super::Network;
use super::collect::permanent;
use super::stations::{Heading, OnLine, STATION_STEP, Station};
use crate::line::{ReferenceLine, Walk};
use crate::place::{SectionIn, Side, number};
use crate::profile::{elevation_at, outermost_at, superelevation_at};
use mapd_geometry::CurvePoint;
use mapd_xodr::Road;
use std::ops::Range;

/// Between cross-sections a curve leaves its chord by at most this much `[m]`.
const CHORD_ERROR: f64 = 0.02;

/// Cross-sections are this far apart at least `[m]`, however narrow a curve.
const STATION_STEP_MIN: f64 = 0.5;

/// Cross-sections of one geometry at most, but for those of lane sections; of longer ones they are farther apart than
/// [`STATION_STEP`].
const STATIONS_OF_A_GEOMETRY: f64 = 1024.0;

/// Room for the cross-sections of most roads.
const STATIONS_AT_FIRST: usize = 16;

/// Cross-sections of one road at most: a bound on memory for hostile files.
const STATIONS_OF_A_ROAD: usize = 100_000;

/// Lanes in all cross-sections of one road at most, each counted in each that it lies in: a bound on work for hostile files,
/// whose every lane may go on past every section. Cross-sections beyond it are left out, but for the one at the road's end.
const LANES_OF_A_ROAD: usize = 1 << 21;

/// The cross-sections of a road.
pub(super) struct RoadStations {
    pub(super) lines: Range<u32>,
    /// Only the first and the last one are kept.
    pub(super) is_straight: bool,
    pub(super) profiles: Range<u32>,
    /// Smallest x, smallest y, largest x, largest y of its surface `[m]`.
    pub(super) bounds: [f64; 4],
}

impl Network {
    /// Takes the cross-sections of a road.
    pub(super) fn add_stations(&mut self, road: &Road, line: &ReferenceLine) -> RoadStations {
        let (before, profiles) = (self.lines.len(), self.profiles.len());
        let mut bounds = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
        let end = number(&road.length).min(line.end());
        let mut heading = Heading::default();
        let sections: Vec<SectionIn<'_>> = permanent(road).collect();
        let written = written(&sections);
        let (mut lanes, mut walk) = (0, Walk::new(line));
        for Place { s, point } in places(line, &sections, end) {
            let sides = sides_at(&sections, &written, s);
            lanes += sides.iter().map(|side| side.lanes(&sections)).sum::<usize>();
            if lanes > LANES_OF_A_ROAD && s < end {
                continue;
            }
            let Some(point) = point.or_else(|| walk.at(s)) else { break };
            let [left, right] = sides.map(|side| side.outermost(&sections, s));
            let station = Station {
                s,
                x: point.x,
                y: point.y,
                hdg: point.heading,
                z: elevation_at(road, s),
                roll: superelevation_at(road, s),
                left,
                right,
            };
            for [x, y] in station.ends(&mut heading) {
                bounds = [bounds[0].min(x), bounds[1].min(y), bounds[2].max(x), bounds[3].max(y)];
            }
            let (line, profile) = station.split();
            self.lines.push(line);
            self.profiles.push(profile);
        }
        let own = self.profiles.get(profiles..).unwrap_or_default();
        if own.first().is_some_and(|first| own.iter().all(|other| first.is(other))) {
            self.profiles.truncate(profiles + 1);
        }
        let own = self.lines.get(before..).unwrap_or_default();
        let is_straight = OnLine::are_straight(own);
        if let Some(last) = own.last().copied().filter(|_| is_straight) {
            self.lines.truncate(before + 1);
            self.lines.push(last);
        }
        let lines = before as u32..self.lines.len() as u32;
        RoadStations {
            lines,
            is_straight,
            profiles: profiles as u32..self.profiles.len() as u32,
            bounds,
        }
    }
}

/// Smallest x, smallest y, largest x, largest y of a road's surface `[m]`; none where its reference line cannot be built.
pub fn extent(road: &Road) -> Option<[f64; 4]> {
    let line = ReferenceLine::new(road.plan_view.as_deref());
    let RoadStations { bounds, .. } = Network::default().add_stations(road, &line);
    bounds.iter().all(|value| value.is_finite()).then_some(bounds)
}

/// A section by its rank, and where its lanes of a side end `[m]`.
type SectionEnd = Option<(usize, f64)>;

/// For each section the ones in which its left and its right lanes are written: a section of one side leaves the other
/// as it was.
fn written(sections: &[SectionIn<'_>]) -> Vec<[SectionEnd; 2]> {
    let mut last = [None; 2];
    let own = sections.iter().enumerate().map(|(at, section)| {
        for (last, side) in last.iter_mut().zip([Side::Left, Side::Right]) {
            if section.holds(side) {
                *last = Some((at, section.s_end_of(side)));
            }
        }
        last
    });
    own.collect()
}

/// A side of a road at an s: the section in which its lanes are written.
struct SideAt {
    side: Side,
    written: SectionEnd,
}

impl SideAt {
    /// Number of its lanes.
    fn lanes(&self, sections: &[SectionIn<'_>]) -> usize {
        let section = self.written.and_then(|(at, _)| sections.get(at));
        section.map_or(0, |section| section.side(self.side).len())
    }

    /// t of its outermost border at `s` `[m]`.
    fn outermost(&self, sections: &[SectionIn<'_>], s: f64) -> f64 {
        let Some((at, end)) = self.written else { return 0.0 };
        let Some(section) = sections.get(at) else { return 0.0 };
        outermost_at(section, self.side, s.min(end) - section.s())
    }
}

/// The left and the right side at `s`.
fn sides_at(sections: &[SectionIn<'_>], written: &[[SectionEnd; 2]], s: f64) -> [SideAt; 2] {
    let begun = sections.partition_point(|section| section.s() <= s);
    let holds = begun.checked_sub(1).and_then(|last| written.get(last)).copied();
    let [left, right] = holds.unwrap_or_default();
    [SideAt { side: Side::Left, written: left }, SideAt { side: Side::Right, written: right }]
}

/// Where a cross-section is kept.
struct Place {
    /// `[m]`
    s: f64,
    /// The point of the reference line there, where it is known already.
    point: Option<CurvePoint>,
}

/// Where cross-sections are kept, ascending.
fn places(line: &ReferenceLine, sections: &[SectionIn<'_>], end: f64) -> Vec<Place> {
    let steps = mapd_geometry::clamp(end / STATION_STEP, 0.0, STATIONS_OF_A_GEOMETRY) as usize;
    let count = steps + line.pieces.len() + sections.len() + 1;
    let mut places = Vec::with_capacity(count.max(STATIONS_AT_FIRST));
    for (rank, piece) in line.pieces.iter().enumerate() {
        let until = (piece.s + piece.length).min(end);
        let (mut s, curve) = (piece.s, piece.curve());
        while s < until && places.len() < STATIONS_OF_A_ROAD {
            let point = curve.map(|curve| curve.evaluate(s - piece.s));
            let ahead = curve.map_or(0.0, |curve| curve.curvature(s - piece.s + STATION_STEP_MIN));
            let bend = point.map_or(0.0, |point| point.curvature.abs()).max(ahead.abs());
            // Where pieces lie over one another, another one may be the line's.
            places.push(Place { s, point: point.filter(|_| line.rank_at(s) == rank) });
            let step = (8.0 * CHORD_ERROR / bend).sqrt().min(STATION_STEP);
            s += step.max(STATION_STEP_MIN).max(piece.length / STATIONS_OF_A_GEOMETRY);
        }
    }
    // Most roads have one section, which begins with them.
    let first = places.first().map(|place: &Place| place.s);
    let others = sections.iter().map(|section| section.s());
    let others = others.filter(|s| *s >= 0.0 && *s < end && Some(*s) != first);
    places.extend(others.chain([end]).map(|s| Place { s, point: None }));
    places.retain(|place| place.s.is_finite());
    places.sort_by(|a, b| a.s.total_cmp(&b.s));
    places.dedup_by_key(|place| place.s);
    places
}
