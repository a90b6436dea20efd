//! What is kept of junctions: connections, controllers and priorities, and of the few that have more than that the element.

use super::append::shift;
use super::collect::contact;
use super::facts::{Contact, PartKind};
use super::references::{Kinds, NamedAt, renamed};
use super::{Name, Network, rows};
use crate::catalog::junctions::kind;
use crate::place::{text, value};
use mapd_xodr::{Connection, ConnectionType, Junction, JunctionType, Span};
use std::ops::Range;

/// A junction.
#[derive(Clone, Debug)]
pub struct JunctionFacts {
    /// The start tag.
    pub span: Span,
    /// Id.
    pub id: Option<Name>,
    pub(super) connections: Range<u32>,
    pub(super) controllers: Range<u32>,
    pub(super) priorities: Range<u32>,
    /// Kind.
    pub kind: JunctionType,
    /// The element without objects, where it says more than which lanes it connects.
    pub written: Option<Box<Junction>>,
}

/// A controller that a junction names.
#[derive(Clone, Copy, Debug)]
pub struct ControllerFacts {
    /// Id of the controller.
    pub id: Name,
    /// Type of control, as written.
    pub kind: Name,
    /// Its rank among those that control the junction; none where it is not written or does not fit.
    pub sequence: Option<i32>,
}

/// Which road of a junction has priority over which.
#[derive(Clone, Copy, Debug)]
pub struct PriorityFacts {
    /// The road with priority.
    pub high: Name,
    /// The road that gives way.
    pub low: Name,
}

/// A connection, and the junction that it belongs to.
#[derive(Clone, Copy)]
pub struct JunctionConnection<'a> {
    /// The junction.
    pub junction: &'a JunctionFacts,
    /// The connection.
    pub connection: &'a ConnectionFacts,
}

/// A connection of a junction.
#[derive(Clone, Debug)]
pub struct ConnectionFacts {
    /// The start tag.
    pub span: Span,
    /// Id.
    pub id: Name,
    /// The road that leads in.
    pub incoming: Name,
    /// The road within.
    pub connecting: Name,
    /// The road that is entered directly.
    pub linked: Name,
    lane_links: Range<u32>,
    /// The end of the other road that touches.
    pub contact: Option<Contact>,
    /// Where both ends of the road that leads in lie at a direct junction: the one at which the lanes meet.
    pub(super) met: Option<Contact>,
}

/// Which lane leads into which: ids, as far as they are written.
#[derive(Clone, Copy, Debug)]
pub struct ConnectedLanes {
    /// The start tag.
    pub span: Span,
    /// The lane of the road that leads in.
    pub from: Option<i32>,
    /// The lane of the road that is entered.
    pub to: Option<i32>,
}

/// Whether a junction says more than which lanes it connects.
fn is_kept(junction: &Junction) -> bool {
    let is_common = matches!(kind(junction), JunctionType::Default | JunctionType::Direct);
    !is_common
        || !junction.road_section.is_empty()
        || !junction.cross_path.is_empty()
        || junction.main_road.is_some()
        || junction.surface.is_some()
        || junction.plan_view.is_some()
        || junction.boundary.is_some()
        || junction.elevation_grid.is_some()
        || junction.s_start.is_some()
        || junction.connection.iter().any(says_more)
}

/// Whether a connection says more than which lanes it connects: where inside roads it begins and ends, or how far lanes overlap.
fn says_more(connection: &Connection) -> bool {
    value(&connection.r#type) == Some(ConnectionType::Virtual)
        || connection.predecessor.is_some()
        || connection.successor.is_some()
        || connection.lane_link.iter().any(|link| link.overlap_zone.is_some())
}

impl Network {
    pub(super) fn add_junction(&mut self, junction: &Junction) {
        let from = self.part(PartKind::Junction, &junction.id, junction.span, None);
        let road = |at: NamedAt| at.of(Kinds::Road);
        if value(&junction.r#type) == Some(JunctionType::Virtual) {
            self.refer(road(NamedAt::MainRoad), &junction.main_road, from, junction.span);
        }
        let mut named = Vec::with_capacity(junction.connection.len());
        for c in &junction.connection {
            // Connections of virtual junctions may come from nowhere.
            let comes = text(&c.incoming_road) != "-1";
            let roads = [
                (NamedAt::IncomingRoad, comes.then_some(&c.incoming_road)),
                (NamedAt::ConnectingRoad, Some(&c.connecting_road)),
                (NamedAt::LinkedRoad, Some(&c.linked_road)),
            ];
            named.push(roads.map(|(at, id)| self.refer(road(at), id?, from, c.span)));
        }
        for priority in &junction.priority {
            self.refer(road(NamedAt::PriorityHigh), &priority.high, from, priority.span);
            self.refer(road(NamedAt::PriorityLow), &priority.low, from, priority.span);
        }
        for controller in &junction.controller {
            let at = NamedAt::JunctionController.of(Kinds::Controller);
            self.refer(at, &controller.id, from, controller.span);
        }
        for section in &junction.road_section {
            self.refer(road(NamedAt::RoadSection), &section.road_id, from, section.span);
        }
        for path in &junction.cross_path {
            self.refer(road(NamedAt::CrossingRoad), &path.crossing_road, from, path.span);
            self.refer(road(NamedAt::PathStart), &path.road_at_start, from, path.span);
            self.refer(road(NamedAt::PathEnd), &path.road_at_end, from, path.span);
        }
        for segment in junction.boundary.iter().flat_map(|boundary| &boundary.segment) {
            self.refer(road(NamedAt::BoundarySegment), &segment.road_id, from, segment.span);
        }
        if let Some(objects) = &junction.objects {
            self.add_objects(objects, NamedAt::JunctionObject, from, None);
        }
        let connections = self.add_connections(junction, &named);
        let (controllers, priorities) = self.add_right_of_way(junction);
        let written = || Box::new(Junction { objects: None, ..junction.clone() });
        self.junctions.push(JunctionFacts {
            span: junction.span,
            id: junction.id.is_some().then_some(from),
            connections,
            controllers,
            priorities,
            kind: kind(junction),
            written: is_kept(junction).then(written),
        });
    }

    /// Takes a junction's connections, with the ids of roads that each refers to.
    fn add_connections(&mut self, junction: &Junction, named: &[[Option<Name>; 3]]) -> Range<u32> {
        let before = self.connections.len() as u32;
        for (c, [incoming, connecting, linked]) in junction.connection.iter().zip(named) {
            let first = self.connected_lanes.len() as u32;
            let lanes = c.lane_link.iter().map(|link| ConnectedLanes {
                span: link.span,
                from: value(&link.from),
                to: value(&link.to),
            });
            self.connected_lanes.extend(lanes);
            let id = self.names.add(text(&c.id));
            let incoming = incoming.unwrap_or_else(|| self.names.add(text(&c.incoming_road)));
            self.connections.push(ConnectionFacts {
                span: c.span,
                id,
                incoming,
                connecting: connecting.unwrap_or_default(),
                linked: linked.unwrap_or_default(),
                lane_links: first..self.connected_lanes.len() as u32,
                contact: contact(&c.contact_point),
                met: None,
            });
        }
        before..self.connections.len() as u32
    }

    /// Takes a junction's controllers and priorities.
    fn add_right_of_way(&mut self, junction: &Junction) -> (Range<u32>, Range<u32>) {
        let before = [self.controllers.len(), self.priorities.len()].map(|count| count as u32);
        for controller in &junction.controller {
            let sequence = value(&controller.sequence).and_then(|s| i32::try_from(s).ok());
            let [id, kind] =
                [&controller.id, &controller.r#type].map(|name| self.names.add(text(name)));
            self.controllers.push(ControllerFacts { id, kind, sequence });
        }
        for priority in &junction.priority {
            let [high, low] = [&priority.high, &priority.low].map(|id| self.names.add(text(id)));
            self.priorities.push(PriorityFacts { high, low });
        }
        let after = [self.controllers.len(), self.priorities.len()].map(|count| count as u32);
        (before[0]..after[0], before[1]..after[1])
    }

    /// Controllers that a junction names.
    pub fn controllers_of(&self, junction: &JunctionFacts) -> &[ControllerFacts] {
        rows(&self.controllers, &junction.controllers)
    }

    /// Priorities of a junction.
    pub fn priorities_of(&self, junction: &JunctionFacts) -> &[PriorityFacts] {
        rows(&self.priorities, &junction.priorities)
    }

    /// Connections of a junction.
    pub fn connections_of(&self, junction: &JunctionFacts) -> &[ConnectionFacts] {
        rows(&self.connections, &junction.connections)
    }

    /// Connections with their junctions, but for those between places inside roads.
    pub fn real_connections(&self) -> impl Iterator<Item = JunctionConnection<'_>> {
        self.junctions.iter().flat_map(move |junction| {
            let written = junction.written.as_ref().map_or(&[][..], |written| &written.connection);
            let is_virtual = |at: usize| {
                let written = written.get(at);
                written.is_some_and(|c| c.predecessor.is_some() && c.successor.is_some())
            };
            let own = self.connections_of(junction).iter().enumerate();
            own.filter(move |(at, _)| !is_virtual(*at))
                .map(move |(_, connection)| JunctionConnection { junction, connection })
        })
    }

    /// Lanes that a connection links: from, to.
    pub fn connected_lanes(&self, connection: &ConnectionFacts) -> &[ConnectedLanes] {
        rows(&self.connected_lanes, &connection.lane_links)
    }

    /// Junctions that say more than which lanes they connect, as written but for their objects, in file order: those with
    /// paths, sections of roads, a boundary, a reference line, a surface or heights, and all that are virtual or crossings.
    pub fn junctions_as_written(&self) -> impl Iterator<Item = &Junction> {
        self.junctions.iter().filter_map(|junction| junction.written.as_deref())
    }

    /// Id of a junction; the empty one where it has none.
    pub fn junction_id(&self, junction: &JunctionFacts) -> &str {
        self.name(junction.id.unwrap_or_default())
    }
}

/// Rows of junctions' tables that come before.
#[derive(Clone, Copy)]
pub(super) struct Before {
    pub(super) connections: u32,
    pub(super) controllers: u32,
    pub(super) priorities: u32,
}

impl JunctionFacts {
    /// Moves its rows and ids to those of the whole.
    pub(super) fn moved(mut self, before: Before, names: &[Name]) -> Self {
        self.id = self.id.map(|id| renamed(id, names));
        shift(&mut self.connections, before.connections);
        shift(&mut self.controllers, before.controllers);
        shift(&mut self.priorities, before.priorities);
        self
    }
}

impl ControllerFacts {
    /// Moves its ids to those of the whole.
    pub(super) fn renamed(self, names: &[Name]) -> Self {
        let [id, kind] = [self.id, self.kind].map(|name| renamed(name, names));
        Self { id, kind, ..self }
    }
}

impl PriorityFacts {
    /// Moves its ids to those of the whole.
    pub(super) fn renamed(self, names: &[Name]) -> Self {
        let [high, low] = [self.high, self.low].map(|name| renamed(name, names));
        Self { high, low }
    }
}

impl ConnectionFacts {
    /// The road that is entered: the linked one where both are named.
    pub fn entered(&self) -> Name {
        if self.linked == Name::default() { self.connecting } else { self.linked }
    }

    /// Moves its rows and ids to those of the whole.
    pub(super) fn moved(mut self, lanes: u32, names: &[Name]) -> Self {
        shift(&mut self.lane_links, lanes);
        let ids = [&mut self.id, &mut self.incoming, &mut self.connecting, &mut self.linked];
        for id in ids {
            *id = renamed(*id, names);
        }
        self
    }
}
