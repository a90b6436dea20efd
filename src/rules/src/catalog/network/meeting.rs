//! Lanes that meet others which nobody links to them.

use super::joints::{CORNER, Edge};
use super::topology::{is_driven, pair};
use crate::example::Example::Document;
use crate::network::{
    Contact, LaneEnd, LaneFacts, LinkTarget, Name, Neighbor, Network, RoadEnd, RoadFacts,
};
use crate::rule::Check::Network as All;
use crate::rule::{Rule, Tolerance};
use crate::sink::{PartOf, Sink};
use std::collections::BTreeSet;

/// Widths that count as none.
const NONE: Tolerance = Tolerance { name: "width that counts as none", value: 1e-6, unit: "m" };
/// Roads of a junction that are looked through for one with a lane that meets a dead one: no known junction has as many that leave by one road.
const MOST_ROADS: usize = 64;

pub(super) static RULES: &[Rule] = &[Rule::warning(
    "mapd:xodr:1.4.0:topology.missing_link",
    "Driving lanes that meet at their corners and have the same direction of traffic are linked.",
    All(missing),
    [
        pair!(
            r#"<successor elementType="road" elementId="2" contactPoint="start"/>"#,
            r#"<link><successor id="-1"/></link>"#,
            r#"<predecessor elementType="road" elementId="1" contactPoint="end"/>"#,
            r#"<link><predecessor id="-1"/></link>"#
        ),
        pair!(
            r#"<successor elementType="road" elementId="2" contactPoint="start"/>"#,
            "",
            r#"<predecessor elementType="road" elementId="1" contactPoint="end"/>"#,
            ""
        ),
    ],
)
.within(&[CORNER, NONE])];

/// Whether traffic drives on a lane where it ends.
fn is_open(of: &LaneEnd<'_>) -> bool {
    is_driven(of.lane.kind) && of.width() > NONE.value
}

/// The lane that a lane goes on as if what touches it there does: traffic drives alike on both, and their corners are the same.
fn met_in<'a>(
    network: &'a Network,
    own: &LaneEnd<'_>,
    Neighbor { road, section, end }: Neighbor<'a>,
) -> Option<LaneEnd<'a>> {
    let edge = Edge::of(network, own)?;
    let [[ax, ay], [bx, by]] = edge.station.all_at(edge.borders);
    let s = match end {
        Contact::Start => section.s,
        Contact::End => section.s_end(own.lane.id),
    };
    let station = network.station_at(road, s)?;
    let (cos, sin) = mapd_geometry::cos_sin(station.hdg);
    let t = (0.5 * (ay + by) - station.y) * cos - (0.5 * (ax + bx) - station.x) * sin;
    // Lanes stand by falling id, and so by falling t.
    let lanes = network.lanes_of(section);
    let low = |lane: &LaneFacts| lane.inner[end as usize].min(lane.outer[end as usize]);
    let at = lanes.partition_point(|lane| low(lane) > t);
    let other = LaneEnd { road, section, lane: lanes.get(at)?, end };
    let [own_along, other_along] = [own, &other].map(|of| Network::goes_along(of.road, of.lane));
    let is_turned = own.end == end;
    let goes_on = match (own_along, other_along) {
        (None, None) => true,
        (Some(own), Some(other)) => (own == other) != is_turned,
        _ => false,
    };
    let meets = goes_on && is_open(&other);
    (meets && edge.gap(&Edge::of(network, &other)?) <= CORNER.value).then_some(other)
}

/// The lane that a lane of a section, given by its rank in its road, meets in the next section or in the road that its road is linked to.
fn met<'a>(network: &'a Network, own: &LaneEnd<'a>, rank: usize) -> Option<LaneEnd<'a>> {
    if !is_open(own) {
        return None;
    }
    met_in(network, own, network.neighbor(own.road, rank, own.end, own.lane.id)?)
}

/// A lane that a lane meets, which no link leads to or from: as [`met`], or a lane of a road within the junction that its road is linked to.
pub(super) fn met_by_dead<'a>(
    network: &'a Network,
    own: &LaneEnd<'a>,
    rank: usize,
) -> Option<LaneEnd<'a>> {
    if let Some(other) = met(network, own, rank) {
        return Some(other);
    }
    let is_last = network.section_at(own.road, own.end, own.lane.id)?.span == own.section.span;
    let Some(LinkTarget::Junction(junction)) = own.road.link(own.end).map(|link| link.target)
    else {
        return None;
    };
    if !is_last || !is_open(own) {
        return None;
    }
    let within = network.roads_within(junction).take(MOST_ROADS);
    let mut ends = within.flat_map(|road| Contact::BOTH.map(|end| RoadEnd { road, end }));
    ends.find_map(|RoadEnd { road, end }| {
        let linked = network.linked_road(road, end)?;
        if linked.road.id != own.road.id || linked.end != own.end {
            return None;
        }
        let is_turned = own.end == end;
        let id = if is_turned { own.lane.id.saturating_neg() } else { own.lane.id };
        let section = network.section_at(road, end, id)?;
        met_in(network, own, Neighbor { road, section, end })
    })
}

/// What connections of junctions link.
#[derive(Default)]
struct Connected {
    /// Lanes by their spans.
    lanes: BTreeSet<[u64; 2]>,
    /// Roads whose connection has no lane links, and so links lanes of equal numbers.
    roads: BTreeSet<[Name; 2]>,
}

impl Connected {
    fn of(network: &Network) -> Self {
        let mut own = Self::default();
        for joint in network.junctions.iter().flat_map(|junction| {
            let connections = network.connections_of(junction).iter();
            connections.flat_map(move |c| network.connected_joints_of(junction, c))
        }) {
            own.lanes.insert(sorted([joint.from.lane.span.start, joint.to.lane.span.start]));
        }
        for connection in network.junctions.iter().flat_map(|j| network.connections_of(j)) {
            if network.connected_lanes(connection).is_empty() {
                own.roads.insert(sorted([connection.incoming, connection.connecting]));
            }
        }
        own
    }

    fn has(&self, [a, b]: [&LaneEnd<'_>; 2]) -> bool {
        self.lanes.contains(&sorted([a.lane.span.start, b.lane.span.start]))
            || self.roads.contains(&sorted([a.road.id, b.road.id]))
    }
}

fn sorted<T: Ord>([a, b]: [T; 2]) -> [T; 2] {
    if a <= b { [a, b] } else { [b, a] }
}

/// A lane in words, as seen from a road.
pub(super) fn named(network: &Network, from: &RoadFacts, of: &LaneEnd<'_>) -> String {
    let LaneEnd { road, section, lane, .. } = of;
    match road.id == from.id {
        true => format!("lane {} of the section at s = {}", lane.id, section.s),
        false => format!("lane {} of road {}", lane.id, network.name(road.id)),
    }
}

fn missing(network: &Network, sink: &mut Sink<'_>) {
    let is_within = |road: &RoadFacts| road.junction.is_some();
    let mut connected = None;
    for road in &network.roads {
        for (rank, section) in network.sections_of(road).iter().enumerate() {
            for lane in network.lanes_of(section) {
                for end in Contact::BOTH {
                    let own = LaneEnd { road, section, lane, end };
                    let is_free = |of: &LaneEnd<'_>| network.links_of(of.lane, of.end).is_empty();
                    if !is_free(&own) {
                        continue;
                    }
                    let Some(other) = met(network, &own, rank).filter(is_free) else { continue };
                    if is_within(road) || is_within(other.road) {
                        let connected = connected.get_or_insert_with(|| Connected::of(network));
                        if connected.has([&own, &other]) {
                            continue;
                        }
                    }
                    let part = format!("lanes/laneSection[@s={}]/lane[@id={}]", section.s, lane.id);
                    let expected = format!(
                        "a link to {}, which the lane meets at its {}",
                        named(network, road, &other),
                        end.name()
                    );
                    let part = PartOf::road(network.name(road.id), &part);
                    sink.add_in(part, lane.span, expected, "none on either side");
                }
            }
        }
    }
}
