//! What rules need to keep of a document after it has streamed by: a few hundred bytes for each road, lane and part with an
//! id, never the elements themselves.

mod append;
mod collect;
mod collect_signals;
mod facts;
mod joints;
mod overlap;

pub(crate) use collect::contact;
pub use collect::extent;
pub use facts::{
    Contact, LaneFacts, LaneLinkFacts, LinkFacts, LinkTarget, Part, PartKind, Reference, RoadFacts,
    SectionFacts, Station,
};
pub use joints::{LaneJoint, Neighbor};
pub use overlap::{CLEARANCE, Overlap, TOUCH};

use mapd_xodr::{Attribute, Junction, Span};
use std::collections::HashMap;

/// The compact form of a document.
#[derive(Clone, Debug, Default)]
pub struct Network {
    /// Where the header stands, if there is one.
    pub header: Option<Span>,
    /// Whether the header has an offset.
    pub has_offset: bool,
    /// Roads in file order.
    pub roads: Vec<RoadFacts>,
    /// Sections of all roads.
    pub sections: Vec<SectionFacts>,
    /// Lanes of all sections, each section's by falling id.
    pub lanes: Vec<LaneFacts>,
    /// Links of all lanes.
    pub lane_links: Vec<LaneLinkFacts>,
    /// Cross-sections of all roads.
    pub stations: Vec<Station>,
    /// Junctions in file order, without their objects.
    pub junctions: Vec<Junction>,
    /// Everything that has an id, but lanes.
    pub parts: Vec<Part>,
    /// References to ids.
    pub references: Vec<Reference>,
    overlaps: std::sync::OnceLock<Vec<Overlap>>,
    /// By road and end: rank of the road that it is linked to, and the end of that.
    linked: Vec<[Option<(usize, Contact)>; 2]>,
    road_of: HashMap<Box<str>, usize>,
    junction_of: HashMap<Box<str>, usize>,
    connecting: HashMap<Box<str>, Vec<usize>>,
}

impl Network {
    /// The first road of an id.
    pub fn road(&self, id: &str) -> Option<&RoadFacts> {
        self.road_of.get(id).and_then(|at| self.roads.get(*at))
    }

    /// Rank of the first road of an id.
    pub fn road_rank(&self, id: &str) -> Option<usize> {
        self.road_of.get(id).copied()
    }

    /// The first junction of an id.
    pub fn junction(&self, id: &str) -> Option<&Junction> {
        self.junction_of.get(id).and_then(|at| self.junctions.get(*at))
    }

    /// Roads that belong to a junction, in file order.
    pub fn roads_within(&self, junction: &str) -> impl Iterator<Item = &RoadFacts> {
        let ranks = self.connecting.get(junction).map_or(&[][..], Vec::as_slice);
        ranks.iter().filter_map(|at| self.roads.get(*at))
    }

    /// Sections of a road.
    pub fn sections_of(&self, road: &RoadFacts) -> &[SectionFacts] {
        self.sections.get(road.sections.clone()).unwrap_or_default()
    }

    /// Lanes of a section, by falling id, without lane 0.
    pub fn lanes_of(&self, section: &SectionFacts) -> &[LaneFacts] {
        self.lanes.get(section.lanes.clone()).unwrap_or_default()
    }

    /// Cross-sections of a road by s.
    pub fn stations_of(&self, road: &RoadFacts) -> &[Station] {
        self.stations.get(road.stations.clone()).unwrap_or_default()
    }

    /// The lane of an id in a section.
    pub fn lane<'a>(&'a self, section: &SectionFacts, id: i32) -> Option<&'a LaneFacts> {
        self.lanes_of(section).iter().find(|lane| lane.id == id)
    }

    /// Rank among all lanes of the lane of an id in a section.
    pub fn lane_rank(&self, section: &SectionFacts, id: i32) -> Option<usize> {
        let at = self.lanes_of(section).iter().position(|lane| lane.id == id)?;
        Some(section.lanes.start + at)
    }

    /// The section of a road that touches one of its ends.
    pub fn section_at(&self, road: &RoadFacts, end: Contact) -> Option<&SectionFacts> {
        match end {
            Contact::Start => self.sections_of(road).first(),
            Contact::End => self.sections_of(road).last(),
        }
    }

    /// The section of a road at `s` `[m]`.
    pub fn section_over(&self, road: &RoadFacts, s: f64) -> Option<&SectionFacts> {
        let sections = self.sections_of(road);
        let after = sections.partition_point(|section| section.s <= s);
        sections.get(after.saturating_sub(1))
    }

    /// The cross-section of a road at `s` `[m]`, between those that are kept linear. None where the road has none.
    pub fn station_at(&self, road: &RoadFacts, s: f64) -> Option<Station> {
        let stations = self.stations_of(road);
        let after = stations.partition_point(|station| station.s <= s);
        let (a, b) = (stations.get(after.saturating_sub(1))?, stations.get(after));
        Some(b.map_or(*a, |b| a.between(b, s)))
    }

    /// Completes what needs the whole document.
    pub(crate) fn finish(&mut self) {
        for (rank, road) in self.roads.iter().enumerate() {
            self.road_of.entry(road.id.clone()).or_insert(rank);
            if let Some(junction) = &road.junction {
                self.connecting.entry(junction.clone()).or_default().push(rank);
            }
        }
        for (rank, junction) in self.junctions.iter().enumerate() {
            if let Some(Attribute { value, .. }) = &junction.id {
                self.junction_of.entry(value.clone()).or_insert(rank);
            }
        }
        self.link_roads();
    }
}
