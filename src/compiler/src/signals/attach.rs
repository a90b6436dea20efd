//! Which lanes signals are for.

use crate::findings::finding;
use crate::resolve::{PlaceWritten, Resolved};
use crate::sample::view;
use mapd_archive::{LaneMethod, Orientation, Rows, SignalLaneRow, SignalPlaceRow};
use mapd_geometry::clamp;
use mapd_query::{Lane, Map, Road};
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
        !self.validity.is_empty() && self.validity.iter().all(|range| *range == (0, 0))
    }
}

/// Fills the signals' places, their lanes and the lanes' signals.
pub(super) fn attach(rows: &mut Rows, resolved: &Resolved, reach: f64) -> Vec<Finding> {
    let mut findings = Vec::new();
    let found: Vec<Option<SignalLanes>> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let roads: Vec<Road<'_>> = map.roads().collect();
        let lanes = |place: &PlaceWritten| lanes_of(roads.get(place.road as usize)?, place, reach);
        resolved.places.par_iter().map(lanes).collect()
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

/// By validity; without any, all lanes that travel the way the signal is for (OpenDRIVE 1.8.1, 14.2); if there are none, the
/// lane that it stands on; else the nearest within `reach` `[m]` that travels that way. A validity of lane 0 alone names no lane: with
/// references to the signal that is all, without any its orientation is the only thing to go by, and the answer says so.
fn lanes_of(road: &Road<'_>, place: &PlaceWritten, reach: f64) -> Option<SignalLanes> {
    let s = clamp(place.s, 0.0, road.length());
    let section = road.section_at(s)?;
    let far = |lane: &Lane<'_>| {
        let edges = lane.edges_at(s);
        let (low, high) = (edges.inner.min(edges.outer), edges.inner.max(edges.outer));
        (low - place.t).max(place.t - high).max(0.0)
    };
    let beside = |lane: Lane<'_>| LaneBeside { row: lane.lane_id().row(), distance: far(&lane) };
    let lanes = || section.lanes().filter(|lane| lane.number() != 0);
    let orientation = Orientation::from_code(place.orientation);
    let fits = |lane: &Lane<'_>| lane.is_bidirectional() || orientation.is_for(lane.is_forward());
    let named = |lane: &Lane<'_>| {
        let number = lane.number();
        place.validity.iter().any(|(a, b)| (*a..=*b).contains(&number))
    };
    let is_guess = place.names_no_lane();
    if is_guess && place.has_references {
        return None;
    }
    if !is_guess && !place.validity.is_empty() {
        let both: Vec<_> = lanes().filter(named).filter(fits).map(beside).collect();
        let named: Vec<_> =
            if both.is_empty() { lanes().filter(named).map(beside).collect() } else { both };
        if !named.is_empty() {
            return Some(SignalLanes { method: LaneMethod::Validity, lanes: named });
        }
    } else {
        let drivable = |lane: &Lane<'_>| lane.kind().is_drivable() && lane.width_at(s) > 0.0;
        let all: Vec<_> = lanes().filter(fits).filter(drivable).map(beside).collect();
        if !all.is_empty() {
            let method =
                if is_guess { LaneMethod::OrientationGuess } else { LaneMethod::Orientation };
            return Some(SignalLanes { method, lanes: all });
        }
    }
    let on = section.lane_at(s, place.t).filter(fits);
    if let Some(lane) = on {
        return Some(SignalLanes { method: LaneMethod::Track, lanes: vec![beside(lane)] });
    }
    let nearest = lanes().filter(fits).filter(|lane| lane.width_at(s) > 0.0).map(beside);
    let nearest = nearest.filter(|lane| lane.distance <= reach);
    let nearest = nearest.min_by(|a, b| a.distance.total_cmp(&b.distance))?;
    Some(SignalLanes { method: LaneMethod::Nearest, lanes: vec![nearest] })
}
