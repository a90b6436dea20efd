//! Ids become rows: signals, controllers, groups, priorities.

use crate::draft::{Draft, LaneNumbers, Links, OnCarrier, Position, Signals, between};
use crate::findings::finding;
use glam::DVec3;
use mapd_archive::{JunctionControllerRow, JunctionPriorityRow, NONE, Range, Rows};
use mapd_rules::catalog::building;
use mapd_rules::network::Name;
use mapd_xodr::source::Places;
use mapd_xodr::{Finding, Severity, Span};
use std::collections::HashMap;

/// Rows by the number of their id's string.
type ById = HashMap<u32, u32>;

/// A place where a signal counts, before its lanes are known.
pub(crate) struct PlaceWritten {
    pub(crate) signal: u32,
    pub(crate) road: u32,
    pub(crate) s: f64,
    pub(crate) t: f64,
    pub(crate) orientation: u8,
    pub(crate) kind: u8,
    pub(crate) lanes: LaneNumbers,
    /// Whether roads refer to the signal, or to what carries it: then they say which lanes it is for where a validity names none.
    pub(crate) has_references: bool,
    pub(crate) span: Span,
    pub(crate) line: u32,
    pub(crate) column: u32,
}

/// What `complete` needs besides rows.
#[derive(Default)]
pub(crate) struct Resolved {
    pub(crate) places: Vec<PlaceWritten>,
    /// Per signal row: where it stands.
    pub(crate) positions: Vec<(Position, OnCarrier)>,
    /// Rows of roads by the numbers of their ids.
    pub(crate) roads: Vec<(u32, u32)>,
}

impl Resolved {
    /// Moves places that are written in x, y and z; what has no image stays and lies beside the map, as its roads do not.
    pub(crate) fn move_by(&mut self, image: &dyn Fn(DVec3, f64) -> Option<(DVec3, f64)>) {
        for (position, _) in &mut self.positions {
            if let Position::Inertial(place) = position
                && let [x, y, z, heading] = &mut **place
                && let Some((at, turned)) = image(DVec3::new(*x, *y, *z), *heading)
            {
                (*x, *y, *z, *heading) = (at.x, at.y, at.z, turned);
            }
        }
    }
}

/// Resolves every id of signals. What is named but not there is a finding where something is lost by it.
pub(crate) fn resolve(
    draft: &mut Draft,
    links: &Links<'_>,
    places: &Places,
    findings: &mut Vec<Finding>,
) -> Resolved {
    let pending = std::mem::take(&mut draft.signals);
    // Of signals with one id, the first is meant.
    let mut signals = ById::new();
    // Nothing refers to one without an id.
    let with_id = draft.rows.signals.iter().enumerate().filter(|(_, signal)| signal.id != 0);
    for (row, signal) in with_id {
        signals.entry(signal.id).or_insert(row as u32);
    }
    let found = |id: u32| signals.get(&id).copied().unwrap_or(NONE);
    for row in draft.rows.signal_dependencies.iter_mut() {
        row.signal = found(row.id);
    }
    for row in draft.rows.signal_links.iter_mut().filter(|row| row.kind == 1) {
        row.signal = found(row.id);
    }
    for (row, written) in draft.rows.signals.iter_mut().zip(&pending.signals) {
        (row.line, row.column) = line_of(places, written.span);
    }
    let found_places = signal_places(draft, &pending, &signals, places, findings);
    controllers(draft, &pending, &signals, places);
    for group in &pending.board_groups {
        draft
            .rows
            .board_groups
            .push(mapd_archive::BoardGroupRow { signal: found(group.id), ..*group });
    }
    junctions(draft, links);
    sort_by_id(draft);
    let roads = draft.rows.roads.iter().enumerate().map(|(row, road)| (road.id, row as u32));
    let mut roads: Vec<(u32, u32)> = roads.collect();
    roads.sort_unstable();
    let positions = pending.signals.into_iter().map(|one| (one.position, one.on_carrier));
    Resolved { places: found_places, positions: positions.collect(), roads }
}

/// Places of signals and of references to them, by road and s.
fn signal_places(
    draft: &Draft,
    pending: &Signals,
    signals: &ById,
    places: &Places,
    findings: &mut Vec<Finding>,
) -> Vec<PlaceWritten> {
    let rows = draft.rows.signals.iter().zip(&pending.signals).enumerate();
    let referenced = referenced(draft, pending, signals);
    let has_references = |number: u32| referenced.get(number as usize).copied().unwrap_or(false);
    // A sign on a board is for the lanes that the board's carrier is for, unless it says otherwise. Carriers come first.
    let mut lanes: Vec<LaneNumbers> = Vec::with_capacity(pending.signals.len());
    let mut out: Vec<PlaceWritten> = rows
        .map(|(number, (row, written))| {
            let own = if written.validity.is_empty() {
                lanes.get(row.carrier as usize).cloned().unwrap_or_default()
            } else {
                LaneNumbers::new(&written.validity)
            };
            lanes.push(own.clone());
            PlaceWritten {
                signal: number as u32,
                road: row.road,
                s: row.s,
                t: row.t,
                orientation: row.orientation,
                kind: 0,
                lanes: own,
                has_references: has_references(number as u32),
                span: written.span,
                line: row.line,
                column: row.column,
            }
        })
        .collect();
    for reference in &pending.references {
        let Some(signal) = signals.get(&reference.id).copied() else {
            let id = String::from_utf8_lossy(draft.strings.bytes_of(reference.id)).into_owned();
            findings.push(finding(
                &building::SIGNAL_REFERENCE,
                Severity::Warning,
                reference.span,
                "OpenDRIVE/road/signals/signalReference/@id".to_owned(),
                format!("expected a signal of the map, found {id:?}, which it does not have"),
                "",
            ));
            continue;
        };
        let (line, column) = line_of(places, reference.span);
        out.push(PlaceWritten {
            signal,
            road: reference.road,
            s: reference.s,
            t: reference.t,
            orientation: reference.orientation,
            kind: 1,
            lanes: LaneNumbers::new(&reference.validity),
            has_references: true,
            span: reference.span,
            line,
            column,
        });
    }
    out.sort_by(|a, b| a.road.cmp(&b.road).then(a.s.total_cmp(&b.s)).then(a.signal.cmp(&b.signal)));
    out
}

/// Of each signal's row, whether a road refers to it, or to the signal whose board it is on. Carriers come first.
fn referenced(draft: &Draft, pending: &Signals, signals: &ById) -> Vec<bool> {
    let mut referenced = vec![false; draft.rows.signals.len()];
    for number in pending.references.iter().filter_map(|reference| signals.get(&reference.id)) {
        if let Some(own) = referenced.get_mut(*number as usize) {
            *own = true;
        }
    }
    for (number, row) in draft.rows.signals.iter().enumerate() {
        let of_carrier = referenced.get(row.carrier as usize).copied().unwrap_or(false);
        if let Some(own) = referenced.get_mut(number) {
            *own |= of_carrier;
        }
    }
    referenced
}

/// Controllers with their signals, and signals with their controllers.
fn controllers(draft: &mut Draft, pending: &Signals, signals: &ById, places: &Places) {
    let rows: &mut Rows = &mut draft.rows;
    let mut turned: Vec<(u32, u32)> = Vec::new();
    for (row, controls, span) in &pending.controllers {
        let before = rows.controls.len();
        for control in controls {
            let signal = signals.get(&control.id).copied().unwrap_or(NONE);
            if signal != NONE {
                turned.push((signal, rows.controllers.len() as u32));
            }
            rows.controls.push(mapd_archive::ControlRow { signal, ..*control });
        }
        let (line, column) = line_of(places, *span);
        let controls = between(before, rows.controls.len());
        rows.controllers.push(mapd_archive::ControllerRow { controls, line, column, ..*row });
    }
    turned.sort_unstable();
    turned.dedup();
    for of_signal in turned.chunk_by(|a, b| a.0 == b.0) {
        let before = rows.signal_controllers.len();
        rows.signal_controllers.extend(of_signal.iter().map(|(_, controller)| *controller));
        let range: Range = between(before, rows.signal_controllers.len());
        if let Some(row) = of_signal.first().and_then(|(s, _)| rows.signals.get_mut(*s as usize)) {
            row.controllers = range;
        }
    }
}

/// Synchronisation groups and priorities of junctions.
fn junctions(draft: &mut Draft, links: &Links<'_>) {
    let Draft { rows, strings, .. } = draft;
    let network = links.network;
    let by_id = |ids: Vec<u32>| -> ById {
        // Of those with one id, the first is meant.
        ids.into_iter().enumerate().rev().map(|(row, id)| (id, row as u32)).collect()
    };
    let controllers = by_id(rows.controllers.iter().map(|row| row.id).collect());
    let roads = by_id(rows.roads.iter().map(|row| row.id).collect());
    for (number, junction) in links.junctions().enumerate() {
        let junction_row = number as u32;
        for controller in network.controllers_of(junction) {
            let id = strings.add(network.name(controller.id));
            rows.junction_controllers.push(JunctionControllerRow {
                junction: junction_row,
                controller: controllers.get(&id).copied().unwrap_or(NONE),
                id,
                r#type: strings.add(network.name(controller.kind)),
                sequence: controller.sequence.unwrap_or(-1),
            });
        }
        for priority in network.priorities_of(junction) {
            let road = |named: Name| {
                let id = strings.number(network.name(named));
                id.and_then(|id| roads.get(&id)).copied().unwrap_or(NONE)
            };
            let [high, low] = [priority.high, priority.low].map(road);
            rows.junction_priorities.push(JunctionPriorityRow {
                junction: junction_row,
                high,
                low,
            });
        }
    }
}

fn sort_by_id(draft: &mut Draft) {
    let Draft { rows, strings, .. } = draft;
    let mut by_id: Vec<u32> = (0..rows.signals.len() as u32).collect();
    let id_of = |row: u32| {
        let id = rows.signals.get(row as usize).map_or(0, |signal| signal.id);
        strings.bytes_of(id)
    };
    // Those of one id stay in the order of their rows.
    by_id.sort_by(|a, b| id_of(*a).cmp(id_of(*b)));
    rows.signals_by_id = by_id.into();
}

/// Line and column of a place.
fn line_of(places: &Places, span: Span) -> (u32, u32) {
    let position = places.place(span.start).position;
    (position.line, position.column)
}
