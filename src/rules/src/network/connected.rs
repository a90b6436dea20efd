//! Where lanes go on through the connections of junctions.

use super::joints::RoadEnd;
use super::{
    ConnectedLanes, ConnectionFacts, Contact, JunctionFacts, LaneFacts, LinkTarget, Network,
    RoadFacts, SectionFacts,
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
        if !matches!(junction.kind, Kind::Default | Kind::Direct) {
            return [None; 2];
        }
        let to = RoadEnd::of(self.road_named(connection.entered()), connection.contact);
        let from = self.road_named(connection.incoming).and_then(|road| {
            let id = junction.id.unwrap_or_default();
            // Roads of a direct junction name the junction, not one another.
            let end = connection.met.or_else(|| self.end_at_junction(road, id, to));
            Some(RoadEnd { road, end: end? })
        });
        [from, to]
    }

    /// Finds at which of its ends a road that leads in meets the linked one, where both ends lie at one direct junction.
    pub(super) fn find_where_roads_meet(&mut self) {
        let mut found = Vec::new();
        for junction in self.junctions.iter().filter(|junction| junction.kind == Kind::Direct) {
            let target = Some(LinkTarget::Junction(junction.id.unwrap_or_default()));
            let first = junction.connections.start as usize;
            for (number, connection) in (first..).zip(self.connections_of(junction)) {
                let incoming = self.road_named(connection.incoming);
                let is_here = |road: &&RoadFacts| {
                    Contact::BOTH.iter().all(|end| road.link(*end).map(|l| l.target) == target)
                };
                let to = RoadEnd::of(self.road_named(connection.entered()), connection.contact);
                if let (Some(road), Some(to)) = (incoming.filter(is_here), to) {
                    let [start, end] = Contact::BOTH
                        .map(|end| self.gap_between(RoadEnd { road, end }, to, connection));
                    let met = if start < end { Contact::Start } else { Contact::End };
                    found.push((number, met));
                }
            }
        }
        for (number, met) in found {
            if let Some(connection) = self.connections.get_mut(number) {
                connection.met = Some(met);
            }
        }
    }

    /// The largest distance between the corners of the lanes that a connection links, left and right as one passes from one
    /// road to the other; without such lanes, between the reference lines `[m]`.
    fn gap_between(&self, from: RoadEnd<'_>, to: RoadEnd<'_>, connection: &ConnectionFacts) -> f64 {
        let gap = |own: [f64; 2], other: [f64; 2]| -> Option<f64> {
            let own = self.corners(from, own, from.end == Contact::End)?;
            let other = self.corners(to, other, to.end == Contact::Start)?;
            let apart = |side: usize| {
                let ([ax, ay], [bx, by]) = (own[side], other[side]);
                mapd_geometry::hypot(ax - bx, ay - by)
            };
            Some(apart(0).max(apart(1)))
        };
        let borders = |at: RoadEnd<'_>, id: i32| {
            let lane = self.lane_end(at, id)?.lane;
            Some([lane.inner, lane.outer].map(|border| border[at.end as usize]))
        };
        let links = self.connected_lanes(connection).iter();
        let gaps = links.filter_map(|link| gap(borders(from, link.from?)?, borders(to, link.to?)?));
        let strip = || gap([1.0, -1.0], [1.0, -1.0]);
        gaps.reduce(f64::max).or_else(strip).unwrap_or(f64::INFINITY)
    }

    /// The points at two lateral distances at the end of a road, the left one first as one travels along s or against it.
    fn corners(&self, at: RoadEnd<'_>, [a, b]: [f64; 2], along: bool) -> Option<[[f64; 2]; 2]> {
        let (low, high) = (a.min(b), a.max(b));
        let sides = if along { [high, low] } else { [low, high] };
        Some(self.station_of(at.road, at.end)?.all_at(sides))
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
