//! Links of roads, lanes and junctions as written, kept until every id is known.
//!
//! Of a junction only what is built from is kept: its connections and lane links in tables of all junctions, its ids as
//! numbers. The few that say more keep the element.

use mapd_archive::{Moved, Range, StringTable};
use mapd_xodr::{ContactPoint, ElementDir, Junction, JunctionType, Span};

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
    /// The element's start tag.
    pub(crate) span: Span,
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

/// A lane's link as written.
#[derive(Clone, Copy)]
pub(crate) struct WrittenLink {
    /// The element's start tag.
    pub(crate) span: Span,
    /// Number of the linked lane.
    pub(crate) number: i32,
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
    /// The element's start tag.
    pub(crate) span: Span,
    /// Ids in [`Links::names`]; 0 where there is none.
    pub(crate) id: u32,
    pub(crate) incoming: u32,
    pub(crate) connecting: u32,
    pub(crate) linked: u32,
    /// Range of [`Links::connected`].
    pub(crate) lane_links: Range,
    pub(crate) contact: Option<ContactPoint>,
}

/// Which lane leads into which.
#[derive(Clone, Copy)]
pub(crate) struct ConnectedLanes {
    /// The element's start tag.
    pub(crate) span: Span,
    pub(crate) from: i32,
    pub(crate) to: i32,
}

/// A controller of a junction.
#[derive(Clone, Copy)]
pub(crate) struct WrittenController {
    /// Ids in [`Links::names`].
    pub(crate) id: u32,
    pub(crate) r#type: u32,
    pub(crate) sequence: Option<i32>,
}

/// A joint of a junction with a grid, until its road is known.
pub(crate) struct Joint {
    pub(crate) grid: usize,
    pub(crate) road: String,
    pub(crate) contact: mapd_archive::ContactPoint,
    /// Lanes between whose outer edges the joint lies; none: the whole road.
    pub(crate) lanes: [Option<i32>; 2],
    /// Length of the transition `[m]`.
    pub(crate) length: f64,
}

/// A range behind so many rows. Tables that outgrow 32 bits are refused before anything is written.
fn behind(range: Range, rows: u32) -> Range {
    Range { first: range.first.wrapping_add(rows), count: range.count }
}

impl Links {
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
