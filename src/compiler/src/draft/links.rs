//! Links as written, by the rows of what has them. The network that the rules look at has them once for both.

use mapd_archive::Rows;
use mapd_rules::Network;
use mapd_rules::network::{
    ConnectionFacts, Contact, JunctionFacts, LaneLinkFacts, LinkFacts, Name, RoadApart, RoadFacts,
};
use mapd_xodr::{Junction, Span};

/// A road's row in the network.
#[derive(Clone, Copy)]
pub(crate) enum RoadWritten<'a> {
    Whole(&'a RoadFacts),
    /// It is built as its reference line alone: it has no links, and nothing leads to it.
    Apart(&'a RoadApart),
}

impl RoadWritten<'_> {
    /// Its id.
    pub(crate) fn id(self) -> Name {
        match self {
            Self::Whole(road) => road.id,
            Self::Apart(road) => road.id,
        }
    }

    /// The junction that it names.
    pub(crate) fn junction(self) -> Option<Name> {
        match self {
            Self::Whole(road) => road.junction,
            Self::Apart(road) => road.junction,
        }
    }
}

/// Links as written.
pub(crate) struct Links<'a> {
    pub(crate) network: &'a Network,
    /// By row.
    roads: Vec<Option<RoadWritten<'a>>>,
    /// By row.
    junctions: Vec<&'a JunctionFacts>,
    /// By row.
    connections: Vec<&'a ConnectionFacts>,
}

impl<'a> Links<'a> {
    /// Of roads with these start tags, in the document's order. The network has more roads and junctions: those of which no row
    /// can be built.
    pub(crate) fn new(road_spans: &[Span], network: &'a Network) -> Self {
        let (mut whole, mut apart) = (network.roads.iter(), network.roads_apart.iter().peekable());
        let written = |span: &Span| match apart.next_if(|road| road.span == *span) {
            Some(road) => Some(RoadWritten::Apart(road)),
            None => whole.find(|road| road.span == *span).map(RoadWritten::Whole),
        };
        let roads = road_spans.iter().map(written).collect();
        let junctions = network.junctions.iter().filter(|junction| junction.id.is_some());
        let junctions: Vec<_> = junctions.collect();
        let connections = junctions.iter().flat_map(|junction| network.connections_of(junction));
        Self { network, roads, connections: connections.collect(), junctions }
    }

    /// A road.
    pub(crate) fn road(&self, row: u32) -> Option<RoadWritten<'a>> {
        self.roads.get(row as usize).copied().flatten()
    }

    /// The link at an end of a road.
    pub(crate) fn road_link(&self, row: u32, end: Contact) -> Option<&'a LinkFacts> {
        match self.road(row)? {
            RoadWritten::Whole(road) => road.link(end),
            RoadWritten::Apart(_) => None,
        }
    }

    /// The end of another road that an end of a road is linked to: as written, else the nearer one.
    pub(crate) fn linked_end(&self, row: u32, end: Contact) -> Option<Contact> {
        match self.road(row)? {
            RoadWritten::Whole(road) => Some(self.network.linked_road(road, end)?.end),
            RoadWritten::Apart(_) => None,
        }
    }

    /// Junctions by their rows.
    pub(crate) fn junctions(&self) -> impl Iterator<Item = &'a JunctionFacts> + '_ {
        self.junctions.iter().copied()
    }

    /// A junction.
    pub(crate) fn junction(&self, row: u32) -> Option<&'a JunctionFacts> {
        self.junctions.get(row as usize).copied()
    }

    /// Junctions that say more than which lanes they connect, as written.
    pub(crate) fn elements(&self) -> impl Iterator<Item = &'a Junction> + '_ {
        self.junctions().filter_map(|junction| junction.written.as_deref())
    }

    /// A connection.
    pub(crate) fn connection(&self, row: u32) -> Option<&'a ConnectionFacts> {
        self.connections.get(row as usize).copied()
    }

    /// Lanes that a connection links, where it names both.
    pub(crate) fn connected(&self, connection: &ConnectionFacts) -> impl Iterator<Item = LaneLink> {
        let links = self.network.connected_lanes(connection).iter();
        links.filter_map(|link| Some(LaneLink { span: link.span, from: link.from?, to: link.to? }))
    }

    /// Predecessors or successors of a permanent lane in its layer. Where a section for the other side begins, it goes on as itself.
    pub(crate) fn of_lane(
        &self,
        rows: &Rows,
        lane: u32,
        end: Contact,
    ) -> impl Iterator<Item = LaneLinkFacts> + use<'a> {
        let (itself, written) = self.find_lane(rows, lane, end).unwrap_or_default();
        let written = written.iter().filter(|link| !link.to_temporary);
        itself.into_iter().chain(written.copied())
    }

    fn find_lane(&self, rows: &Rows, lane: u32, end: Contact) -> Option<LinksOfLane<'a>> {
        let row = rows.lanes.get(lane as usize)?;
        let stretch = rows.sections.get(row.section as usize)?;
        let RoadWritten::Whole(road) = self.road(stretch.road)? else { return None };
        let (network, number) = (self.network, stretch.number as usize);
        let written = network.section_written(road, number, row.number)?;
        let lane = network.lane(written, row.number)?;
        let next = || network.sections_of(road).get(number + 1);
        let goes_on = match end {
            Contact::Start => row.continues > 0,
            Contact::End => next().is_some_and(|next| !next.holds(row.number)),
        };
        Some(if goes_on {
            (Some(LaneLinkFacts { span: lane.span, id: lane.id, to_temporary: false }), &[])
        } else {
            (None, network.links_of(lane, end))
        })
    }
}

/// A lane's link to itself in the next stretch, or its links as written.
type LinksOfLane<'a> = (Option<LaneLinkFacts>, &'a [LaneLinkFacts]);

/// Which lane of a connection leads into which.
#[derive(Clone, Copy)]
pub(crate) struct LaneLink {
    /// The element's start tag.
    pub(crate) span: Span,
    pub(crate) from: i32,
    pub(crate) to: i32,
}
