//! Where lanes go on through the connections of junctions.

use super::joints::RoadEnd;
use super::{
    ConnectedLanes, ConnectionFacts, Contact, JunctionFacts, LaneFacts, Network, RoadFacts,
    SectionFacts,
};
use mapd_xodr::JunctionType as Kind;

/// A lane at an end of its road.
#[derive(Clone, Copy, Debug)]
pub struct LaneEnd<'a> {
    /// Its road.
    pub road: &'a RoadFacts,
    /// The section that touches the end.
    pub section: &'a SectionFacts,
    /// The lane.
    pub lane: &'a LaneFacts,
    /// The end.
    pub end: Contact,
}

impl LaneEnd<'_> {
    /// Width there `[m]`.
    pub fn width(&self) -> f64 {
        self.lane.width(self.end)
    }
}

/// A connection's link of two lanes that are there.
#[derive(Clone, Copy, Debug)]
pub struct ConnectedJoint<'a> {
    /// The junction.
    pub junction: &'a JunctionFacts,
    /// Its connection.
    pub connection: &'a ConnectionFacts,
    /// The link as written.
    pub link: &'a ConnectedLanes,
    /// The lane that leads in.
    pub from: LaneEnd<'a>,
    /// The lane that is entered.
    pub to: LaneEnd<'a>,
}

/// The ends of roads that a connection joins: that of the road that leads in and that of the one that is entered, as far as
/// they are there.
pub type ConnectedEnds<'a> = [Option<RoadEnd<'a>>; 2];

impl Network {
    /// The ends of roads that a connection of a default or direct junction joins; none of other junctions.
    pub fn connected_ends(
        &self,
        junction: &JunctionFacts,
        connection: &ConnectionFacts,
    ) -> ConnectedEnds<'_> {
        let entered = match junction.kind {
            Kind::Default => connection.connecting,
            Kind::Direct => connection.linked,
            _ => return [None; 2],
        };
        let to = RoadEnd::of(self.road_named(entered), connection.contact);
        let from = self.road_named(connection.incoming).and_then(|road| {
            let id = junction.id.unwrap_or_default();
            // Roads of a direct junction name the junction, not one another.
            let within = to.filter(|_| junction.kind == Kind::Default);
            Some(RoadEnd { road, end: self.end_at_junction(road, id, within)? })
        });
        [from, to]
    }

    /// A lane at an end of a road.
    pub fn lane_end<'a>(&'a self, at: RoadEnd<'a>, id: i32) -> Option<LaneEnd<'a>> {
        let RoadEnd { road, end } = at;
        let section = self.section_at(road, end, id)?;
        Some(LaneEnd { road, section, lane: self.lane(section, id)?, end })
    }

    /// The links of a connection whose lanes are there.
    pub fn connected_joints_of<'a>(
        &'a self,
        junction: &'a JunctionFacts,
        connection: &'a ConnectionFacts,
    ) -> impl Iterator<Item = ConnectedJoint<'a>> {
        let [from, to] = self.connected_ends(junction, connection);
        self.connected_lanes(connection).iter().filter_map(move |link| {
            let from = self.lane_end(from?, link.from?)?;
            let to = self.lane_end(to?, link.to?)?;
            Some(ConnectedJoint { junction, connection, link, from, to })
        })
    }

    /// The links of all connections of junctions of a kind, default or direct, whose lanes are there.
    pub fn connected_joints(&self, kind: Kind) -> impl Iterator<Item = ConnectedJoint<'_>> {
        let junctions = self.junctions.iter().filter(move |junction| junction.kind == kind);
        junctions.flat_map(move |junction| {
            let connections = self.connections_of(junction).iter();
            connections.flat_map(move |connection| self.connected_joints_of(junction, connection))
        })
    }

    /// Whether the lane that is entered links to the other one itself: what holds of such a pair is looked at there.
    pub fn links_back(&self, joint: &ConnectedJoint<'_>) -> bool {
        let LaneEnd { road, lane, end, .. } = joint.to;
        let is_linked = |linked: RoadEnd<'_>| {
            linked.road.id == joint.from.road.id && linked.end == joint.from.end
        };
        self.links_of(lane, end).iter().any(|link| link.id == joint.from.lane.id)
            && self.linked_road(road, end).is_some_and(is_linked)
    }
}
