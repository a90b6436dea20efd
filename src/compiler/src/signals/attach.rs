//! Which lanes signals are for.

use crate::findings::finding;
use crate::resolve::{PlaceWritten, Resolved};
use crate::sample::view;
use mapd_archive::{LaneMethod, Orientation, Rows, SignalLaneRow, SignalPlaceRow};
use mapd_geometry::clamp;
use mapd_query::compiling::SectionCutter;
use mapd_query::{Lane, LaneEdges, LaneSection, Map, Road};
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity};
use rayon::prelude::*;

/// The lanes that a signal's place is for.
struct SignalLanes {
    /// What they are chosen by.
    method: LaneMethod,
    lanes: Vec<LaneBeside>,
}

/// A lane and how far it is from a place.
struct LaneBeside {
    row: u32,
    /// From the place to the lane's nearer edge `[m]`; 0 inside.
    distance: f64,
}

impl PlaceWritten {
    /// Whether a validity limits it to lane 0 alone, which is nobody's lane: to none of the road's. Exporters write it where
    /// other roads' references name the lanes, and where they do not know.
    fn names_no_lane(&self) -> bool {
        self.lanes.is_center_alone()
    }
}

/// Fills the signals' places, their lanes and the lanes' signals.
pub(super) fn attach(rows: &mut Rows, resolved: &Resolved, reach: f64) -> Vec<Finding> {
    let mut findings = Vec::new();
    let found: Vec<Option<SignalLanes>> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let roads: Vec<Road<'_>> = map.roads().collect();
        // By road and s: those within a section share what it is made of.
        let of_road = resolved.places.par_chunk_by(|a, b| a.road == b.road);
        let lanes = |places: &[PlaceWritten]| {
            let road = places.first().and_then(|place| roads.get(place.road as usize));
            let mut across = None;
            let lanes = |place: &PlaceWritten| lanes_of(road?, place, reach, &mut across);
            places.iter().map(lanes).collect::<Vec<_>>()
        };
        of_road.flat_map_iter(lanes).collect()
    };
    let mut has_lanes = vec![false; rows.signals.len()];
    for (place, _) in resolved.places.iter().zip(&found).filter(|(_, found)| found.is_some()) {
        if let Some(own) = has_lanes.get_mut(place.signal as usize) {
            *own = true;
        }
    }
    for (place, found) in resolved.places.iter().zip(found) {
        let number = rows.signal_places.len() as u32;
        let before = rows.signal_lanes.len();
        match found {
            Some(SignalLanes { method, lanes }) => {
                for LaneBeside { row, distance } in lanes {
                    rows.signal_lanes.push(SignalLaneRow {
                        place: number,
                        lane: row,
                        distance: distance as f32,
                        method: method.code(),
                        reserved: [0; 3],
                    });
                }
            }
            // For none of this road's lanes, as it says; its references name others.
            None if place.names_no_lane()
                && has_lanes.get(place.signal as usize).is_some_and(|has| *has) => {}
            None => findings.push(finding(
                &building::SIGNAL_LANES,
                Severity::Warning,
                place.span,
                "OpenDRIVE/road/signals".to_owned(),
                if place.names_no_lane() && place.has_references {
                    "no validity names a lane that it is for; it is kept on the road".to_owned()
                } else {
                    "no lane runs in the direction that it applies to; it is kept on the road"
                        .to_owned()
                },
                "give it the validity and orientation of the lanes that it applies to",
            )),
        }
        rows.signal_places.push(SignalPlaceRow {
            s: place.s,
            t: place.t,
            signal: place.signal,
            road: place.road,
            lanes: crate::draft::between(before, rows.signal_lanes.len()),
            line: place.line,
            column: place.column,
            orientation: place.orientation,
            kind: place.kind,
            reserved: [0; 6],
        });
    }
    let mut by_lane: Vec<u32> = (0..rows.signal_lanes.len() as u32).collect();
    by_lane
        .sort_by_key(|row| (rows.signal_lanes.get(*row as usize).map_or(0, |one| one.lane), *row));
    rows.lane_signals = by_lane.into();
    findings
}

/// The lanes of a section, cut across at one place after the other.
struct Across<'a> {
    section: LaneSection<'a>,
    cutter: Option<SectionCutter<'a>>,
    lanes: Vec<Lane<'a>>,
    edges: Vec<LaneEdges>,
    /// Where the edges are, if they are anywhere yet.
    s: Option<f64>,
}

/// A lane with its edges at a place.
type CutLane<'c, 'a> = (&'c Lane<'a>, &'c LaneEdges);

impl<'a> Across<'a> {
    fn new(section: LaneSection<'a>) -> Self {
        let lanes: Vec<_> = section.lanes().collect();
        let edges = vec![LaneEdges { inner: 0.0, outer: 0.0 }; lanes.len()];
        Self { section, cutter: SectionCutter::new(section), lanes, edges, s: None }
    }

    /// Cuts at s. Widths add up from lane 0 outwards: once for all lanes, not for each one.
    fn cut(&mut self, s: f64) {
        let s = clamp(s, self.section.s_start(), self.section.s_end());
        if self.s == Some(s) {
            return;
        }
        let cut = self.cutter.as_mut().and_then(|cutter| cutter.edges(s, &mut self.edges));
        if cut.is_none() {
            let one_by_one = self.lanes.iter().map(|lane| lane.edges_at(s));
            self.edges.iter_mut().zip(one_by_one).for_each(|(edges, one)| *edges = one);
        }
        self.s = Some(s);
    }

    /// All lanes but lane 0.
    fn lanes(&self) -> impl Iterator<Item = CutLane<'_, 'a>> {
        self.lanes.iter().zip(&self.edges).filter(|(lane, _)| lane.number() != 0)
    }
}

/// By validity; without any, all lanes that travel the way the signal is for (OpenDRIVE 1.8.1, 14.2); if there are none, the
/// lane that it stands on; else the nearest within `reach` `[m]` that travels that way. A validity of lane 0 alone names no lane: with
/// references to the signal that is all, without any its orientation is the only thing to go by, and the answer says so.
/// `across` is the section of the place before.
fn lanes_of<'a>(
    road: &Road<'a>,
    place: &PlaceWritten,
    reach: f64,
    across: &mut Option<Across<'a>>,
) -> Option<SignalLanes> {
    let s = clamp(place.s, 0.0, road.length());
    let section = road.section_at(s)?;
    let is_guess = place.names_no_lane();
    if is_guess && place.has_references {
        return None;
    }
    let ends = |section: &LaneSection<'_>| [section.s_start(), section.s_end()];
    let known = across.take().filter(|one| ends(&one.section) == ends(&section));
    let across = across.insert(known.unwrap_or_else(|| Across::new(section)));
    across.cut(s);
    let orientation = Orientation::from_code(place.orientation);
    let fits = |(lane, _): &CutLane<'_, '_>| {
        lane.is_bidirectional() || orientation.is_for(lane.is_forward())
    };
    let is_open = |(_, edges): &CutLane<'_, '_>| edges.width() > 0.0;
    let reaches = |edges: &LaneEdges| (edges.inner.min(edges.outer), edges.inner.max(edges.outer));
    let beside = |(lane, edges): CutLane<'_, '_>| {
        let (low, high) = reaches(edges);
        let distance = (low - place.t).max(place.t - high).max(0.0);
        LaneBeside { row: lane.lane_id().row(), distance }
    };
    if !is_guess && !place.lanes.is_empty() {
        let named = |(lane, _): &CutLane<'_, '_>| place.lanes.contains(lane.number());
        let both: Vec<_> = across.lanes().filter(named).filter(fits).map(beside).collect();
        let named: Vec<_> =
            if both.is_empty() { across.lanes().filter(named).map(beside).collect() } else { both };
        if !named.is_empty() {
            return Some(SignalLanes { method: LaneMethod::Validity, lanes: named });
        }
    } else {
        let drivable = |one: &CutLane<'_, '_>| one.0.kind().is_drivable() && is_open(one);
        let all: Vec<_> = across.lanes().filter(fits).filter(drivable).map(beside).collect();
        if !all.is_empty() {
            let method =
                if is_guess { LaneMethod::OrientationGuess } else { LaneMethod::Orientation };
            return Some(SignalLanes { method, lanes: all });
        }
    }
    // As [`LaneSection::lane_at`] finds it.
    let is_on = |one: &CutLane<'_, '_>| {
        let (low, high) = reaches(one.1);
        is_open(one) && low <= place.t && place.t <= high
    };
    let on = across.lanes().filter(is_on).min_by_key(|(lane, _)| lane.number().unsigned_abs());
    if let Some(one) = on.filter(fits) {
        return Some(SignalLanes { method: LaneMethod::Track, lanes: vec![beside(one)] });
    }
    let nearest = across.lanes().filter(fits).filter(is_open).map(beside);
    let nearest = nearest.filter(|lane| lane.distance <= reach);
    let nearest = nearest.min_by(|a, b| a.distance.total_cmp(&b.distance))?;
    Some(SignalLanes { method: LaneMethod::Nearest, lanes: vec![nearest] })
}
