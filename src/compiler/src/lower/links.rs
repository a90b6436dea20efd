//! Links of roads, lanes and junctions as written, kept until every id is known.
//!
//! Of a junction only what is built from is kept: its connections and lane links in tables of all junctions, its ids as
//! numbers. The few that say more keep the element.

use super::{Joint, between};
use mapd_archive::{Moved, Range, StringTable};
use mapd_xodr::{
    Connection, ConnectionType, ContactPoint, ElementDir, ElementType, Junction, JunctionType,
    LinkedElement, Span, Text as _, Value as _,
};

/// Links as written.
#[derive(Default)]
pub(crate) struct Links {
    /// Ids that links name, each once. They are not the archive's: what is named need not be there.
    pub(crate) names: StringTable,
    /// Per road: predecessor and successor as written.
    pub(crate) roads: Vec<[Option<RoadLink>; 2]>,
    /// Per road: the junction that it names, in `names`; 0 where it names none.
    pub(crate) road_junctions: Vec<u32>,
    /// Per road: place of its start tag.
    pub(crate) road_spans: Vec<Span>,
    /// Per lane row: predecessors and successors as written, ranges of `lane_links`.
    pub(crate) lanes: Vec<[Range; 2]>,
    pub(crate) lane_links: Vec<WrittenLink>,
    /// Junctions as written.
    pub(crate) junctions: Vec<WrittenJunction>,
    /// Connections of all junctions, in the order of their rows.
    pub(crate) connections: Vec<WrittenConnection>,
    /// Lane links of all connections that name both lanes.
    pub(crate) connected: Vec<ConnectedLanes>,
    /// Controllers of all junctions.
    pub(crate) controllers: Vec<WrittenController>,
    /// Priorities of all junctions: ids of the roads with high and low priority, in `names`.
    pub(crate) priorities: Vec<[u32; 2]>,
    /// Joints of junctions with an elevation grid.
    pub(crate) joints: Vec<Joint>,
}

/// A road's link as written.
#[derive(Clone, Copy)]
pub(crate) struct RoadLink {
    start: u64,
    len: u32,
    /// What it names, in [`Links::names`].
    pub(crate) id: u32,
    pub(crate) contact: Option<ContactPoint>,
    /// Direction on the linked road.
    pub(crate) dir: Option<ElementDir>,
    /// Whether it names a junction.
    pub(crate) to_junction: bool,
    /// Where it touches the linked road `[m]`.
    pub(crate) s: Option<f64>,
}

impl RoadLink {
    /// The element's start tag.
    pub(crate) fn span(&self) -> Span {
        Span { start: self.start, len: self.len }
    }
}

/// A lane's link as written.
#[derive(Clone, Copy)]
pub(crate) struct WrittenLink {
    start: u64,
    len: u32,
    /// Number of the linked lane.
    pub(crate) number: i32,
}

impl WrittenLink {
    /// The link with a start tag.
    pub(crate) fn new(number: i32, span: Span) -> Self {
        Self { start: span.start, len: span.len, number }
    }

    /// The element's start tag.
    pub(crate) fn span(&self) -> Span {
        Span { start: self.start, len: self.len }
    }
}

/// A junction as written.
pub(crate) struct WrittenJunction {
    pub(crate) span: Span,
    /// Range of [`Links::connections`].
    pub(crate) connections: Range,
    /// Range of [`Links::controllers`].
    pub(crate) controllers: Range,
    /// Range of [`Links::priorities`].
    pub(crate) priorities: Range,
    pub(crate) kind: JunctionType,
    /// The element, where more is built of it than its connections, controllers and priorities.
    pub(crate) element: Option<Box<Junction>>,
}

/// A connection as written.
#[derive(Clone, Copy)]
pub(crate) struct WrittenConnection {
    start: u64,
    len: u32,
    /// Ids in [`Links::names`]; 0 where there is none.
    pub(crate) id: u32,
    pub(crate) incoming: u32,
    pub(crate) connecting: u32,
    pub(crate) linked: u32,
    /// Range of [`Links::connected`].
    pub(crate) lane_links: Range,
    pub(crate) contact: Option<ContactPoint>,
}

impl WrittenConnection {
    /// The element's start tag.
    pub(crate) fn span(&self) -> Span {
        Span { start: self.start, len: self.len }
    }
}

/// Which lane leads into which.
#[derive(Clone, Copy)]
pub(crate) struct ConnectedLanes {
    start: u64,
    len: u32,
    pub(crate) from: i32,
    pub(crate) to: i32,
}

impl ConnectedLanes {
    /// The element's start tag.
    pub(crate) fn span(&self) -> Span {
        Span { start: self.start, len: self.len }
    }
}

/// A controller of a junction.
#[derive(Clone, Copy)]
pub(crate) struct WrittenController {
    /// Ids in [`Links::names`].
    pub(crate) id: u32,
    pub(crate) r#type: u32,
    pub(crate) sequence: Option<i32>,
}

/// A range behind so many rows. Tables that outgrow 32 bits are refused before anything is written.
fn behind(range: Range, rows: u32) -> Range {
    Range { first: range.first.wrapping_add(rows), count: range.count }
}

/// Whether more is built of a junction than its connections, controllers and priorities.
fn says_more(junction: &Junction) -> bool {
    let is_virtual = |c: &Connection| {
        c.r#type.value() == Some(ConnectionType::Virtual)
            || c.predecessor.is_some()
            || c.successor.is_some()
    };
    let has_zone = |c: &Connection| c.lane_link.iter().any(|l| l.overlap_zone.is_some());
    !junction.road_section.is_empty()
        || !junction.cross_path.is_empty()
        || junction.main_road.is_some()
        || junction.s_start.is_some()
        || junction.connection.iter().any(|c| is_virtual(c) || has_zone(c))
}

impl Links {
    /// A road's link, if it names anything.
    pub(super) fn road_link(&mut self, link: &LinkedElement) -> Option<RoadLink> {
        let id = self.names.add(&link.element_id.as_ref()?.value);
        Some(RoadLink {
            start: link.span.start,
            len: link.span.len,
            id,
            contact: link.contact_point.value(),
            dir: link.element_dir.value(),
            // Files without the type link roads.
            to_junction: link.element_type.value() == Some(ElementType::Junction),
            s: link.element_s.value(),
        })
    }

    /// Takes a junction.
    pub(super) fn junction(&mut self, mut junction: Junction) {
        let before = [self.connections.len(), self.controllers.len(), self.priorities.len()];
        for c in &junction.connection {
            let first = self.connected.len();
            self.connected.extend(c.lane_link.iter().filter_map(|link| {
                let Span { start, len } = link.span;
                let (from, to) = (link.from.value()?, link.to.value()?);
                Some(ConnectedLanes { start, len, from, to })
            }));
            let [id, incoming, connecting, linked] =
                [&c.id, &c.incoming_road, &c.connecting_road, &c.linked_road]
                    .map(|id| self.names.add(id.text()));
            self.connections.push(WrittenConnection {
                start: c.span.start,
                len: c.span.len,
                id,
                incoming,
                connecting,
                linked,
                lane_links: between(first, self.connected.len()),
                contact: c.contact_point.value(),
            });
        }
        for controller in &junction.controller {
            let sequence = controller.sequence.value().and_then(|s| i32::try_from(s).ok());
            let [id, r#type] =
                [&controller.id, &controller.r#type].map(|text| self.names.add(text.text()));
            self.controllers.push(WrittenController { id, r#type, sequence });
        }
        for priority in &junction.priority {
            let roads = [&priority.high, &priority.low].map(|id| self.names.add(id.text()));
            self.priorities.push(roads);
        }
        let kind = junction.r#type.value().unwrap_or(JunctionType::Default);
        let says_more = says_more(&junction);
        junction.objects = None;
        self.junctions.push(WrittenJunction {
            span: junction.span,
            connections: between(before[0], self.connections.len()),
            controllers: between(before[1], self.controllers.len()),
            priorities: between(before[2], self.priorities.len()),
            kind,
            element: says_more.then(|| Box::new(junction)),
        });
    }

    /// An id of [`Links::names`].
    pub(crate) fn name(&self, number: u32) -> &str {
        std::str::from_utf8(self.names.bytes_of(number)).unwrap_or_default()
    }

    /// Junctions of which more is built than connections, controllers and priorities.
    pub(crate) fn elements(&self) -> impl Iterator<Item = &Junction> {
        self.junctions.iter().filter_map(|junction| junction.element.as_deref())
    }

    /// Takes those of the part that comes next; so many elevation grids come before its own.
    pub(super) fn append(&mut self, part: Self, grids: usize) {
        let names = Moved::To(self.names.append(&part.names));
        let [lane_links, connections, connected, controllers, priorities] = [
            self.lane_links.len(),
            self.connections.len(),
            self.connected.len(),
            self.controllers.len(),
            self.priorities.len(),
        ]
        .map(|count| count as u32);
        let lanes = part.lanes.into_iter();
        self.lanes.extend(lanes.map(|links| links.map(|link| behind(link, lane_links))));
        self.lane_links.extend(part.lane_links);
        self.roads.extend(part.roads.into_iter().map(|links| {
            links.map(|link| link.map(|link| RoadLink { id: names.row(link.id), ..link }))
        }));
        self.road_junctions.extend(part.road_junctions.into_iter().map(|id| names.row(id)));
        self.road_spans.extend(part.road_spans);
        self.junctions.extend(part.junctions.into_iter().map(|junction| WrittenJunction {
            connections: behind(junction.connections, connections),
            controllers: behind(junction.controllers, controllers),
            priorities: behind(junction.priorities, priorities),
            ..junction
        }));
        self.connections.extend(part.connections.into_iter().map(|c| WrittenConnection {
            id: names.row(c.id),
            incoming: names.row(c.incoming),
            connecting: names.row(c.connecting),
            linked: names.row(c.linked),
            lane_links: behind(c.lane_links, connected),
            ..c
        }));
        self.connected.extend(part.connected);
        self.controllers.extend(part.controllers.into_iter().map(|c| WrittenController {
            id: names.row(c.id),
            r#type: names.row(c.r#type),
            ..c
        }));
        let roads = part.priorities.into_iter();
        self.priorities.extend(roads.map(|ids| ids.map(|id| names.row(id))));
        // Row 0 of a part is not used.
        self.joints.extend(part.joints.into_iter().map(|mut joint| {
            joint.grid = joint.grid + grids - 1;
            joint
        }));
    }
}
