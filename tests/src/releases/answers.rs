//! Answers of a map that every later build must give again: nearest lanes, links, signals, routes, what is left out; and those under an overlay.

use mapd_client::{Map, NearestOptions, glam::DVec2};
use mapd_query::Bounds;
use mapd_query::route::{PositionOnLane, RouteScratch, ShortestLength, ShortestTime};
use mapd_query::view::View;
use mapd_query::vocabulary::{QuarantinedKind, VehicleClass};
use std::fmt::{self, Write as _};

/// Points to ask about along each axis of a map.
const POINTS: usize = 6;
/// Lanes between which routes are asked for.
const ROUTED: usize = 12;

/// Ids of objects that a map may have left out.
const LEFT_OUT: [&str; 2] = ["1", "2"];

/// What a map answers, as text: the same for ever. Millimetres are the finest that is said.
///
/// Errors: what writing to a string gives, which is none.
pub fn answers(map: Map<'_>) -> Result<String, fmt::Error> {
    let mut out = String::new();
    for info in map.tables().infos().iter().filter(|info| info.count > 0) {
        writeln!(out, "table {} {}", info.name, info.count)?;
    }
    let Bounds { low, high } = map.bounds();
    for i in 0..POINTS * POINTS {
        let share = DVec2::new((i % POINTS) as f64, (i / POINTS) as f64) / (POINTS - 1) as f64;
        let point = low.truncate() + (high - low).truncate() * share;
        let Ok(Some(hit)) = map.nearest_lane(point, &NearestOptions::default()) else { continue };
        let key = map.lane(hit.lane).map(|lane| lane.key().to_string()).unwrap_or_default();
        let at = hit.position;
        writeln!(out, "nearest {i} {key} {:.3} {:.3} {:.3}", at.s, at.t, at.distance)?;
    }
    let key = |id| map.lane(id).map(|lane| lane.key().to_string()).unwrap_or_default();
    for lane in map.lanes() {
        write!(out, "lane {} {} ->", lane.key(), lane.kind().name())?;
        lane.successors().try_for_each(|next| write!(out, " {}", key(next)))?;
        lane.road_marks().try_for_each(|mark| write!(out, ", {}", mark.kind().name()))?;
        writeln!(out)?;
    }
    for signal in map.signals() {
        let (class, at) = (signal.class().name(), signal.position());
        writeln!(out, "signal {} {class} {:.3} {:.3}", signal.id(), at.x, at.y)?;
    }
    for object in map.objects() {
        write!(out, "object {} {}", object.id(), object.class().name())?;
        match object.value() {
            Some(value) => writeln!(out, " {value:.3} {}", object.assumed_unit())?,
            None => writeln!(out)?,
        }
    }
    for group in map.junction_groups() {
        let (id, kind) = (group.id(), group.kind().name());
        writeln!(out, "group {id} {kind} {}", group.ring().map(key).collect::<Vec<_>>().join(" "))?;
    }
    for part in map.quarantined() {
        let (kind, id, owner) = (part.kind().name(), part.id(), part.owner());
        let (file, place) = (part.source_file().unwrap_or("-"), part.source_position());
        let (length, rule) = (part.length(), part.rule());
        writeln!(
            out,
            "quarantined {kind} {id} {owner} {length:.3} {file}:{}:{} {rule}",
            place.line, place.column
        )?;
    }
    for id in LEFT_OUT {
        if let Some(part) = map.left_out(QuarantinedKind::Object, id) {
            writeln!(out, "left out: object {id} with {} {}", part.kind().name(), part.id())?;
        }
    }
    for one in map.annotations() {
        let (owner, kind, file) = (one.owner_kind().name(), one.kind().name(), one.file());
        let file = file.map_or("-", |file| file.name());
        writeln!(
            out,
            "{kind} of {owner} {:?} {:?} {:?} {file}",
            one.name(),
            one.value(),
            one.text()
        )?;
    }
    let places: Vec<_> = map.lanes().take(ROUTED).collect();
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    for (from, to) in places.iter().flat_map(|a| places.iter().map(move |b| (a, b))) {
        let place = |lane: &mapd_query::Lane<'_>| PositionOnLane { lane: lane.lane_id(), s: 1.0 };
        let (car, cost) = (VehicleClass::PassengerCar, ShortestLength::default());
        if let Ok(Some(_)) = map.route(place(from), place(to), car, &cost, &mut scratch, &mut steps)
        {
            write!(out, "route")?;
            steps.iter().try_for_each(|step| write!(out, " {}", key(step.lane)))?;
            writeln!(out)?;
        }
    }
    Ok(out)
}

/// Where a lane is asked about, as a share of its section: within each stretch that the overlay names.
const ASKED_AT: f64 = 0.3;
/// Classes that overlays are asked about.
const VEHICLES: [VehicleClass; 3] =
    [VehicleClass::PassengerCar, VehicleClass::Truck, VehicleClass::Bicycle];

/// What a map with an overlay answers at a moment, as text: the same for ever.
///
/// Errors: what writing to a string gives, which is none.
pub fn answers_today(view: View<'_>) -> Result<String, fmt::Error> {
    let mut out = String::new();
    let map = view.map();
    let key = |id| map.lane(id).map(|lane| lane.key().to_string()).unwrap_or_default();
    for entry in view.entries() {
        let (id, kind, holds) = (entry.id(), entry.kind().name(), view.holds(&entry));
        let (value, confidence) = (entry.value(), entry.confidence());
        let vehicles = VehicleClass::ALL.iter().filter(|class| entry.concerns(**class)).count();
        let (source, text) = (entry.source(), entry.text());
        writeln!(
            out,
            "entry {id} {kind} {holds} {value:?} {confidence:.3} {vehicles} {source:?} {text:?}"
        )?;
    }
    for one in view.restrictions() {
        let (from, to) = (one.s_from, one.s_to);
        writeln!(out, "holds {} {} {from:.3} {to:.3}", one.entry.id(), key(one.lane))?;
    }
    for signal in map.signals() {
        if let Ok(Some(entry)) = view.signal_out_of_service(signal.signal_id()) {
            writeln!(out, "out of service {} {}", signal.id(), entry.id())?;
        }
    }
    for lane in map.lanes() {
        let (from, to) = (lane.section().s_start(), lane.section().s_end());
        let (id, s) = (lane.lane_id(), from + ASKED_AT * (to - from));
        for vehicle in VEHICLES {
            let (Ok(allows), Ok(speed), Ok(overtaking)) = (
                view.allows(id, s, vehicle),
                view.speed_rule_at(id, s, vehicle),
                view.overtaking_rule_at(id, s, vehicle),
            ) else {
                continue;
            };
            let allowed = allows.is_allowed;
            let max = speed.max.unwrap_or(f64::NAN);
            let by = [allows.restriction, speed.restriction, overtaking.restriction]
                .map(|one| one.map_or("-", |one| one.entry.id()));
            writeln!(
                out,
                "lane {} {} {allowed} {max:.3} {}",
                lane.key(),
                vehicle.name(),
                by.join(" ")
            )?;
        }
    }
    let places: Vec<_> = map.lanes().collect();
    let (mut scratch, mut steps) = (RouteScratch::default(), Vec::new());
    for (from, to) in places.iter().flat_map(|a| places.iter().map(move |b| (a, b))) {
        let place = |lane: &mapd_query::Lane<'_>| PositionOnLane { lane: lane.lane_id(), s: 1.0 };
        let (car, cost) = (VehicleClass::PassengerCar, ShortestTime::default());
        let found = view.route(place(from), place(to), car, &cost, &mut scratch, &mut steps);
        if let Ok(Some(route)) = found {
            write!(out, "route {:.3}", route.cost)?;
            steps.iter().try_for_each(|step| write!(out, " {}", key(step.lane)))?;
            writeln!(out)?;
        }
    }
    Ok(out)
}
