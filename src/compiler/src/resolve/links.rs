//! Ids become rows: roads, junctions, connections.

use crate::draft::{Draft, Links, RoadWritten, between};
use crate::findings::finding;
use mapd_archive::{ConnectionLaneLinkRow, ConnectionRow, ContactPoint, LinkKind, NONE};
use mapd_rules::catalog::building;
use mapd_rules::network::{Contact, LinkTarget, Name};
use mapd_xodr::{Finding, Severity};

/// Resolves every id and sorts the look-up tables. What is not found is kept as unresolved; the rules say so.
///
/// Nothing leads to a road that is kept as its reference line alone: it has no lanes that could be entered.
pub(crate) fn resolve(draft: &mut Draft, links: &Links<'_>, findings: &mut Vec<Finding>) {
    let names = Named::new(draft, links);
    for number in 0..draft.rows.roads.len() {
        resolve_road(draft, links, number, &names, findings);
    }
    resolve_connections(draft, links, &names);
    sort_by_id(draft);
}

/// Rows of roads and junctions by their ids.
struct Named {
    roads: Vec<u32>,
    junctions: Vec<u32>,
}

impl Named {
    fn new(draft: &Draft, links: &Links<'_>) -> Self {
        let ids = || vec![NONE; links.network.names()];
        let mut named = Self { roads: ids(), junctions: ids() };
        let roads = || 0..draft.rows.roads.len() as u32;
        // Where several have one id, of which a rule tells, the first is meant.
        for row in roads().rev() {
            let Some(road) = links.road(row) else { continue };
            named.roads[road.id().number()] = row;
        }
        for row in roads() {
            let Some(RoadWritten::Apart(road)) = links.road(row) else { continue };
            let own = &mut named.roads[road.id.number()];
            if *own == row {
                *own = NONE;
            }
        }
        let junctions: Vec<_> = links.junctions().map(|junction| junction.id).collect();
        for (row, id) in junctions.into_iter().enumerate().rev() {
            named.junctions[id.unwrap_or_default().number()] = row as u32;
        }
        named
    }

    fn road(&self, id: Name) -> Option<u32> {
        self.roads.get(id.number()).copied().filter(|row| *row != NONE)
    }

    fn junction(&self, id: Name) -> Option<u32> {
        self.junctions.get(id.number()).copied().filter(|row| *row != NONE)
    }
}

fn road_path(draft: &Draft, number: usize) -> String {
    let id = draft.rows.roads.get(number).map_or(0, |road| road.id);
    format!("OpenDRIVE/road[@id={}]", String::from_utf8_lossy(draft.strings.bytes_of(id)))
}

fn resolve_road(
    draft: &mut Draft,
    links: &Links<'_>,
    number: usize,
    names: &Named,
    findings: &mut Vec<Finding>,
) {
    let junction = links.road(number as u32).and_then(|road| names.junction(road.junction()?));
    if let Some(junction) = junction {
        draft.rows.roads[number].junction = junction;
    }
    for at in Contact::BOTH {
        let Some(link) = links.road_link(number as u32, at) else { continue };
        let (known, found, missing) = match link.target {
            LinkTarget::Junction(id) => {
                (LinkKind::Junction, names.junction(id), LinkKind::UnresolvedJunction)
            }
            LinkTarget::Road(id) => (LinkKind::Road, names.road(id), LinkKind::UnresolvedRoad),
        };
        let end = if at == Contact::Start { "predecessor" } else { "successor" };
        let mut contact = contact_code(link.contact);
        if found.is_some()
            && known == LinkKind::Road
            && contact == ContactPoint::None.code()
            && link.s.is_none()
            && let Some(nearer) = links.linked_end(number as u32, at)
        {
            contact = contact_code(Some(nearer));
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
        if at == Contact::Start {
            (row.predecessor, row.predecessor_kind, row.predecessor_contact) =
                (found.unwrap_or(NONE), kind, contact);
        } else {
            (row.successor, row.successor_kind, row.successor_contact) =
                (found.unwrap_or(NONE), kind, contact);
        }
    }
}

fn contact_code(contact: Option<Contact>) -> u8 {
    match contact {
        Some(Contact::Start) => ContactPoint::Start,
        Some(Contact::End) => ContactPoint::End,
        None => ContactPoint::None,
    }
    .code()
}

fn resolve_connections(draft: &mut Draft, links: &Links<'_>, names: &Named) {
    let Draft { rows, strings, .. } = draft;
    let none = Name::default();
    for (number, junction) in links.junctions().enumerate() {
        let before = rows.connections.len();
        for connection in links.network.connections_of(junction) {
            let row = |id: Name| Some(id).filter(|id| *id != none).and_then(|id| names.road(id));
            let before = rows.connection_lane_links.len();
            let written = links.connected(connection);
            let pairs = written.map(|l| ConnectionLaneLinkRow { from: l.from, to: l.to });
            rows.connection_lane_links.extend(pairs);
            rows.connections.push(ConnectionRow {
                id: strings.add(links.network.name(connection.id)),
                incoming_road: row(connection.incoming).unwrap_or(NONE),
                connecting_road: row(connection.entered()).unwrap_or(NONE),
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
