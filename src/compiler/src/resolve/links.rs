//! Ids become rows: roads, junctions, connections.

use crate::draft::{Draft, between};
use crate::findings::finding;
use crate::quarantine::Exclusions;
use mapd_archive::{ConnectionLaneLinkRow, ConnectionRow, ContactPoint, LinkKind, NONE, RoadRow};
use mapd_rules::catalog::building;
use mapd_xodr::{self as xodr, Finding, Severity};
use std::collections::HashMap;

/// Rows by the number of their id's string.
type ById = HashMap<u32, u32>;

/// Resolves every id and sorts the look-up tables. What is not found is kept as unresolved; the rules say so.
///
/// Nothing leads to a road that is kept as its reference line alone: it has no lanes that could be entered.
pub(crate) fn resolve(draft: &mut Draft, without: &Exclusions, findings: &mut Vec<Finding>) {
    let mut roads = by_id(draft.rows.roads.iter().map(|road| road.id));
    roads.retain(|_, row| {
        let span = draft.links.road_spans.get(*row as usize);
        !span.is_some_and(|span| without.is_bare(span.start))
    });
    let junctions = by_id(draft.rows.junctions.iter().map(|junction| junction.id));
    let names = Named::new(draft, &roads, &junctions);
    for number in 0..draft.rows.roads.len() {
        resolve_road(draft, number, &names, findings);
    }
    resolve_connections(draft, &names);
    sort_by_id(draft);
}

/// Rows by their ids. Where several have one, of which a rule tells, the first is meant.
fn by_id(ids: impl Iterator<Item = u32>) -> ById {
    let mut rows = ById::new();
    for (row, id) in ids.enumerate() {
        rows.entry(id).or_insert(row as u32);
    }
    rows
}

/// What the ids mean that links name, by their numbers.
struct Named {
    roads: Vec<Option<u32>>,
    junctions: Vec<Option<u32>>,
}

impl Named {
    fn new(draft: &Draft, roads: &ById, junctions: &ById) -> Self {
        let Draft { links, strings, .. } = draft;
        let row = |rows: &ById, id: Option<u32>| rows.get(&id?).copied();
        let ids = (0..links.names.len() as u32)
            .map(|number| strings.number_of(links.names.bytes_of(number)));
        let (roads, junctions) = ids.map(|id| (row(roads, id), row(junctions, id))).unzip();
        Self { roads, junctions }
    }

    fn road(&self, id: u32) -> Option<u32> {
        self.roads.get(id as usize).copied().flatten()
    }

    fn junction(&self, id: u32) -> Option<u32> {
        self.junctions.get(id as usize).copied().flatten()
    }
}

fn road_path(draft: &Draft, number: usize) -> String {
    let id = draft.rows.roads.get(number).map_or(0, |road| road.id);
    format!("OpenDRIVE/road[@id={}]", String::from_utf8_lossy(draft.strings.bytes_of(id)))
}

fn resolve_road(draft: &mut Draft, number: usize, names: &Named, findings: &mut Vec<Finding>) {
    let junction = draft.links.road_junctions.get(number).copied();
    // Without an id there is none.
    let junction = junction.filter(|id| *id != 0).and_then(|id| names.junction(id));
    if let Some(junction) = junction {
        draft.rows.roads[number].junction = junction;
    }
    let links = draft.links.roads.get(number).copied().unwrap_or_default();
    for (i, link) in links.iter().enumerate() {
        let Some(link) = link else { continue };
        let to_junction = link.to_junction;
        let (known, found, missing) = if to_junction {
            (LinkKind::Junction, names.junction(link.id), LinkKind::UnresolvedJunction)
        } else {
            (LinkKind::Road, names.road(link.id), LinkKind::UnresolvedRoad)
        };
        let end = if i == 0 { "predecessor" } else { "successor" };
        let mut contact = contact_code(link.contact);
        if let Some(target) = found
            && !to_junction
            && contact == ContactPoint::None.code()
            && link.s.is_none()
        {
            contact = nearer_end(draft, number, i == 1, target as usize);
            let message = format!(
                "expected @contactPoint, found none; read as {} because that end is nearer",
                ContactPoint::from_code(contact).name()
            );
            let path = format!("{}/link/{end}", road_path(draft, number));
            findings.push(finding(
                &building::CONTACT_POINT,
                Severity::Warning,
                link.span,
                path,
                message,
                "",
            ));
        }
        let kind = if found.is_some() { known } else { missing }.code();
        let row = &mut draft.rows.roads[number];
        if i == 0 {
            (row.predecessor, row.predecessor_kind, row.predecessor_contact) =
                (found.unwrap_or(NONE), kind, contact);
        } else {
            (row.successor, row.successor_kind, row.successor_contact) =
                (found.unwrap_or(NONE), kind, contact);
        }
    }
}

fn contact_code(contact: Option<xodr::ContactPoint>) -> u8 {
    match contact {
        Some(xodr::ContactPoint::Start) => ContactPoint::Start,
        Some(xodr::ContactPoint::End) => ContactPoint::End,
        _ => ContactPoint::None,
    }
    .code()
}

/// Which end of `target` lies nearer to this road's end.
fn nearer_end(draft: &Draft, road: usize, at_end: bool, target: usize) -> u8 {
    let ends = |row: &RoadRow| {
        let geometries = row.geometries.of(&draft.rows.geometries);
        let start = geometries.first().map_or((0.0, 0.0), |g| (g.x, g.y));
        // The last geometry's end, straight on: enough to tell two ends of a road apart.
        let end = geometries
            .last()
            .map_or((0.0, 0.0), |g| (g.x + g.cos * g.length, g.y + g.sin * g.length));
        (start, end)
    };
    let (Some(from), Some(to)) = (draft.rows.roads.get(road), draft.rows.roads.get(target)) else {
        return ContactPoint::None.code();
    };
    let here = if at_end { ends(from).1 } else { ends(from).0 };
    let squared = |p: (f64, f64)| (p.0 - here.0) * (p.0 - here.0) + (p.1 - here.1) * (p.1 - here.1);
    let (start, end) = ends(to);
    if squared(start) <= squared(end) { ContactPoint::Start } else { ContactPoint::End }.code()
}

fn resolve_connections(draft: &mut Draft, names: &Named) {
    let Draft { rows, strings, links, .. } = draft;
    for (number, junction) in links.junctions.iter().enumerate() {
        let before = rows.connections.len();
        for connection in junction.connections.of(&links.connections) {
            let connecting = match connection.linked {
                0 => connection.connecting,
                linked => linked,
            };
            let row = |id: u32| Some(id).filter(|id| *id != 0).and_then(|id| names.road(id));
            let written = connection.lane_links.of(&links.connected);
            let before = rows.connection_lane_links.len();
            let pairs = written.iter().map(|l| ConnectionLaneLinkRow { from: l.from, to: l.to });
            rows.connection_lane_links.extend(pairs);
            rows.connections.push(ConnectionRow {
                id: strings.add(links.name(connection.id)),
                incoming_road: row(connection.incoming).unwrap_or(NONE),
                connecting_road: row(connecting).unwrap_or(NONE),
                lane_links: between(before, rows.connection_lane_links.len()),
                contact: contact_code(connection.contact),
                reserved: [0; 3],
            });
        }
        let connections = between(before, rows.connections.len());
        if let Some(row) = rows.junctions.get_mut(number) {
            row.connections = connections;
        }
    }
}

/// Rows in byte order of their ids, for looking ids up.
fn sort_by_id(draft: &mut Draft) {
    let Draft { rows, strings, .. } = draft;
    let order = |ids: Vec<u32>| {
        let mut by_id: Vec<u32> = (0..ids.len() as u32).collect();
        by_id.sort_by(|a, b| {
            let text = |row: u32| ids.get(row as usize).map_or(&[][..], |id| strings.bytes_of(*id));
            text(*a).cmp(text(*b)).then(a.cmp(b))
        });
        by_id
    };
    rows.roads_by_id = order(rows.roads.iter().map(|road| road.id).collect()).into();
    rows.junctions_by_id =
        order(rows.junctions.iter().map(|junction| junction.id).collect()).into();
}
