//! What is kept of a document after it has streamed by: a few hundred bytes for each road, lane and part with an id, never the
//! elements themselves. The rules look at it, and who builds the document takes its links from here.

mod append;
mod collect;
mod collect_signals;
mod collect_stations;
mod connected;
mod facts;
mod joints;
mod junctions;
mod names;
mod overlap;
mod overlap_search;
mod references;
mod stations;
mod stretch;

pub use collect_stations::extent;
pub use connected::{ConnectedEnds, ConnectedJoint, LaneEnd};
pub use facts::{
    Contact, IdentifiedPart, LaneFacts, LaneLinkFacts, LinkFacts, LinkTarget, PartKind, RoadApart,
    RoadFacts, SectionFacts,
};
pub use joints::{Foot, LaneJoint, Neighbor, RoadEnd};
pub use junctions::{
    ConnectedLanes, ConnectionFacts, ControllerFacts, JunctionConnection, JunctionFacts,
    PriorityFacts,
};
pub use names::Name;
pub use overlap::{CLEARANCE, Overlap, TOUCH};
pub use references::{Kinds, NamedAt, Reference};
pub use stations::{Station, Stations};

pub(crate) use collect::contact;

use mapd_xodr::Span;
use names::IdTable;
use std::mem::take;

/// No row.
const NONE: u32 = u32::MAX;

/// The compact form of a document. Ids are numbers, which [`Network::name`] writes out.
#[derive(Clone, Debug, Default)]
pub struct Network {
    /// Where the header stands, if there is one.
    pub header: Option<Span>,
    /// Whether the header has an offset.
    pub has_offset: bool,
    /// Roads in file order.
    pub roads: Vec<RoadFacts>,
    /// Roads that the rules do not look at, in file order.
    pub roads_apart: Vec<RoadApart>,
    /// Sections of all roads.
    pub sections: Vec<SectionFacts>,
    /// Lanes of all sections, each section's by falling id.
    pub lanes: Vec<LaneFacts>,
    /// Links of all lanes.
    pub lane_links: Vec<LaneLinkFacts>,
    /// Junctions in file order.
    pub junctions: Vec<JunctionFacts>,
    /// Everything that has an id, but lanes.
    pub parts: Vec<IdentifiedPart>,
    /// References to ids.
    pub references: Vec<Reference>,
    names: IdTable,
    /// Cross-sections of all roads.
    lines: Vec<stations::OnLine>,
    profiles: Vec<stations::Profile>,
    /// Connections of all junctions.
    connections: Vec<ConnectionFacts>,
    /// Lane links of all connections.
    connected_lanes: Vec<ConnectedLanes>,
    /// Controllers of all junctions.
    controllers: Vec<ControllerFacts>,
    /// Priorities of all junctions.
    priorities: Vec<PriorityFacts>,
    overlaps: std::sync::OnceLock<overlap::Overlaps>,
    /// By road and end: rank of the road that it is linked to, doubled, and the end of that.
    linked: Vec<[u32; 2]>,
    /// By the number of an id: the first road that has it.
    road_of: Vec<u32>,
    /// Roads within junctions, by the junction's id and rank.
    within: Vec<(Name, u32)>,
    /// Ends of roads that are linked to junctions: the junction's id, the road's rank, the end's number.
    leading_in: Vec<(Name, u32, u8)>,
}

/// Rows of a table.
fn rows<'a, T>(table: &'a [T], range: &std::ops::Range<u32>) -> &'a [T] {
    table.get(range.start as usize..range.end as usize).unwrap_or_default()
}

impl Network {
    /// Nothing yet, to be appended to this.
    pub(crate) fn another(&self) -> Self {
        Self { names: self.names.another(), ..Self::default() }
    }

    /// The id of a number.
    pub fn name(&self, name: Name) -> &str {
        self.names.text(name)
    }

    /// The number of an id; none where nothing has or names it.
    pub fn name_of(&self, id: &str) -> Option<Name> {
        self.names.find(id)
    }

    /// Whether the document has roads, whatever may be wrong with them.
    pub fn has_roads(&self) -> bool {
        !self.roads.is_empty() || !self.roads_apart.is_empty()
    }

    /// Whether the ids that the document has and names are together longer than 4 GiB, so that some of them count as empty.
    pub fn lacks_ids(&self) -> bool {
        self.names.is_incomplete()
    }

    /// How many ids there are, the empty one among them: numbers of names are smaller.
    pub fn names(&self) -> usize {
        self.names.len()
    }

    /// The first road of an id.
    pub fn road(&self, id: &str) -> Option<&RoadFacts> {
        self.road_named(self.name_of(id)?)
    }

    /// The first road of an id.
    pub fn road_named(&self, id: Name) -> Option<&RoadFacts> {
        self.roads.get(*self.road_of.get(id.number())? as usize)
    }

    /// Roads that belong to a junction, in file order.
    pub fn roads_within(&self, junction: Name) -> impl Iterator<Item = &RoadFacts> {
        let first = self.within.partition_point(|(id, _)| *id < junction);
        let within = self.within.get(first..).unwrap_or_default().iter();
        let own = within.take_while(move |(id, _)| *id == junction);
        own.filter_map(|(_, rank)| self.roads.get(*rank as usize))
    }

    /// Roads that are linked to a junction, in file order; one twice that is linked to it at both ends.
    pub fn roads_into(&self, junction: Name) -> impl Iterator<Item = &RoadFacts> {
        let first = self.leading_in.partition_point(|(id, ..)| *id < junction);
        let own = self.leading_in.get(first..).unwrap_or_default().iter();
        let own = own.take_while(move |(id, ..)| *id == junction);
        own.filter_map(|(_, rank, _)| self.roads.get(*rank as usize))
    }

    /// The road that something stands along.
    pub fn road_along(&self, part: &IdentifiedPart) -> Option<&RoadFacts> {
        self.roads.get(part.road as usize)
    }

    /// Sections of a road.
    pub fn sections_of(&self, road: &RoadFacts) -> &[SectionFacts] {
        rows(&self.sections, &road.sections)
    }

    /// Lanes of a section, by falling id, without lane 0.
    pub fn lanes_of(&self, section: &SectionFacts) -> &[LaneFacts] {
        rows(&self.lanes, &section.lanes)
    }

    /// The lane of an id in a section.
    pub fn lane<'a>(&'a self, section: &SectionFacts, id: i32) -> Option<&'a LaneFacts> {
        self.lanes.get(self.lane_rank(section, id)?)
    }

    /// Rank among all lanes of the lane of an id in a section.
    pub fn lane_rank(&self, section: &SectionFacts, id: i32) -> Option<usize> {
        let at = facts::rank_of(self.lanes_of(section), id, |lane| lane.id)?;
        Some(section.lane_ranks().start + at)
    }

    /// The section of a road that touches one of its ends on the side of a lane.
    pub fn section_at(&self, road: &RoadFacts, end: Contact, lane: i32) -> Option<&SectionFacts> {
        let sections = self.sections_of(road);
        let rank = match end {
            Contact::Start => 0,
            Contact::End => sections.len().checked_sub(1)?,
        };
        let own = sections.get(rank)?;
        // The search goes on into the road, away from its end.
        if own.holds(lane) { Some(own) } else { sections.get(own.next(rank, end.other(), lane)?) }
    }

    /// The section that says what lies on the side of a lane in the stretch from a section's start, given by its rank in its road,
    /// to the next one's: that section or one before it.
    pub fn section_written(
        &self,
        road: &RoadFacts,
        rank: usize,
        lane: i32,
    ) -> Option<&SectionFacts> {
        let sections = self.sections_of(road);
        let own = sections.get(rank)?;
        if own.holds(lane) {
            Some(own)
        } else {
            sections.get(own.next(rank, Contact::Start, lane)?)
        }
    }

    /// The section of a road at `s` `[m]` on the side of a lane.
    pub fn section_over(&self, road: &RoadFacts, s: f64, lane: i32) -> Option<&SectionFacts> {
        let sections = self.sections_of(road);
        let after = sections.partition_point(|section| section.s <= s);
        self.section_written(road, after.saturating_sub(1), lane)
    }

    /// The links for who builds from them: ids, roads, lanes and junctions; and what only rules look at, which takes time to free.
    pub fn into_links(mut self) -> (Self, Self) {
        let rules = Self {
            parts: take(&mut self.parts),
            references: take(&mut self.references),
            overlaps: take(&mut self.overlaps),
            lines: take(&mut self.lines),
            profiles: take(&mut self.profiles),
            leading_in: take(&mut self.leading_in),
            ..Self::default()
        };
        (self, rules)
    }

    /// Completes what needs the whole document.
    pub(crate) fn finish(&mut self) {
        self.road_of = vec![NONE; self.names.len()];
        // Of those with one id, the first.
        for road in self.roads.iter().rev() {
            if let Some(first) = self.road_of.get_mut(road.id.number()) {
                *first = road.rank;
            }
        }
        let within = self.roads.iter().filter_map(|road| Some((road.junction?, road.rank)));
        self.within = within.collect();
        self.within.sort_unstable();
        let ends = self.roads.iter().flat_map(|road| Contact::BOTH.map(|end| (road, end)));
        let leading_in = ends.filter_map(|(road, end)| match road.link(end)?.target {
            LinkTarget::Junction(junction) => Some((junction, road.rank, end as u8)),
            LinkTarget::Road(_) => None,
        });
        self.leading_in = leading_in.collect();
        self.leading_in.sort_unstable();
        self.link_roads();
        self.find_where_roads_meet();
    }
}
