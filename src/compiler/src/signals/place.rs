//! Where signals stand, and where they face: against the traffic that they are for.

use crate::draft::Position;
use crate::findings::finding;
use crate::resolve::Resolved;
use crate::sample::view;
use glam::DVec3;
use mapd_archive::{Class, Orientation, Rows, SignalRow, signal_flags};
use mapd_geometry::{beside, clamp, normalize_angle};
use mapd_query::compiling::ByRow as _;
use mapd_query::{Map, Road, Track};
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity};
use std::f64::consts::{FRAC_PI_4, PI};

/// A place in space and the direction of the face's normal.
type Standing = (DVec3, f64);

/// Traffic that travels within this of a face's normal sees the back of it `[rad]`.
const BACK: f64 = FRAC_PI_4;

/// Fills x, y, z and facing of all signals, whose lanes are known. Carriers of boards come before what they carry. Those that are turned round are findings.
pub(super) fn place(rows: &mut Rows, resolved: &Resolved) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut found: Vec<Option<Standing>> = Vec::with_capacity(rows.signals.len());
    {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let roads: Vec<Road<'_>> = map.roads().collect();
        let mut by_signal: Vec<usize> = (0..rows.signal_places.len()).collect();
        by_signal.sort_by_key(|place| rows.signal_places[*place].signal);
        let mut rest = &by_signal[..];
        let signals = rows.signals.iter().zip(&resolved.positions);
        for (number, (row, (position, on_carrier))) in (0..).zip(signals) {
            let count = rest.partition_point(|place| rows.signal_places[*place].signal <= number);
            let (places, later) = rest.split_at(count);
            rest = later;
            let mut own = standing(&roads, row, position, &resolved.roads);
            // Who comes the wrong way is to see a sign against entering.
            if let Some((_, facing)) = &mut own
                && row.class != Class::NoEntry.code()
                && shows_back(map, rows, places, *facing)
            {
                *facing = normalize_angle(*facing + PI);
                findings.extend(places.first().and_then(|place| turned(resolved, *place)));
            }
            let carrier = found.get(row.carrier as usize).copied().flatten();
            found.push(match (on_carrier, carrier) {
                (Some(shift), Some(carrier)) => Some(on(carrier, **shift, own)),
                _ => own,
            });
        }
    }
    for (row, found) in rows.signals.iter_mut().zip(found) {
        if let Some((p, facing)) = found {
            (row.x, row.y, row.z, row.facing) = (p.x, p.y, p.z, facing);
        }
        let length = rows.roads.get(row.road as usize).map_or(0.0, |road| road.length);
        if row.s != clamp(row.s, 0.0, length) {
            row.flags |= signal_flags::CLAMPED;
        }
    }
    findings
}

/// Whether all drivable lanes that some places of a signal are for travel the way that its face looks: RoadRunner wrote signs so for years.
fn shows_back(map: Map<'_>, rows: &Rows, places: &[usize], facing: f64) -> bool {
    let mut shows = false;
    for place in places.iter().filter_map(|place| rows.signal_places.get(*place)) {
        for one in place.lanes.of(&rows.signal_lanes) {
            let Some(lane) = map.lane_by_row(one.lane).filter(|lane| lane.kind().is_drivable())
            else {
                continue;
            };
            let way = lane.waypoint_at(place.s).map(|at| normalize_angle(at.heading - facing));
            let is_back = way.is_ok_and(|way| way.abs() <= BACK) && !lane.is_bidirectional();
            if !is_back {
                return false;
            }
            shows = true;
        }
    }
    shows
}

/// A signal that is turned round, by one of its places.
fn turned(resolved: &Resolved, place: usize) -> Option<Finding> {
    Some(finding(
        &building::SIGNAL_FACING,
        Severity::Warning,
        resolved.places.get(place)?.span,
        "OpenDRIVE/road/signals".to_owned(),
        "it would show its back to all lanes that it applies to; it is turned to face them"
            .to_owned(),
        "write the orientation and hOffset of the traffic that it is for",
    ))
}

fn standing(
    roads: &[Road<'_>],
    row: &SignalRow,
    position: &Position,
    by_id: &[(u32, u32)],
) -> Option<Standing> {
    let own = roads.get(row.road as usize)?;
    match position {
        Position::Track => {
            let (s, t) = (row.s, row.t);
            on_road(own, [s, t, row.z_offset, row.h_offset], row.orientation)
        }
        Position::Road(place) => {
            let (id, at) = &**place;
            let named = by_id.binary_search_by_key(id, |(id, _)| *id).ok();
            let named = named.and_then(|at| by_id.get(at)).map(|(_, row)| *row);
            let road = named.and_then(|row| roads.get(row as usize)).unwrap_or(own);
            on_road(road, *at, row.orientation)
        }
        Position::Inertial(place) => {
            let [x, y, z, heading] = &**place;
            Some((DVec3::new(*x, *y, *z), normalize_angle(*heading)))
        }
    }
}

/// The point (s, t) of the road's plane in plan view, zOffset above the reference line; the normal of a face points against
/// the traffic that it is for (OpenDRIVE 1.8.1, 14.1).
fn on_road(road: &Road<'_>, [s, t, z, h]: [f64; 4], orientation: u8) -> Option<Standing> {
    let pose = road.to_inertial(Track { s, t, h: 0.0 }).ok()?;
    let s = clamp(s, 0.0, road.reference_end().max(0.0));
    let turned = if Orientation::from_code(orientation) == Orientation::Along { PI } else { 0.0 };
    let p = DVec3::new(pose.position.x, pose.position.y, road.elevation_at(s) + z);
    Some((p, normalize_angle(pose.heading + turned + h)))
}

/// On a board: v to the left of the carrier's face, z above the carrier.
fn on((origin, facing): Standing, (v, z): (f64, f64), own: Option<Standing>) -> Standing {
    (beside(origin, facing, v, z), own.map_or(facing, |(_, own)| own))
}
