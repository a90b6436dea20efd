//! The lane network: what hangs together, and what leads nowhere.

use super::meeting::{met_by_dead, named};
use crate::catalog::lanes::is_drivable;
use crate::example::Example::Document;
use crate::network::{Contact, JunctionConnection, LaneEnd, Name, Network, RoadEnd, RoadFacts};
use crate::place::{text, value};
use crate::rule::Check::Network as All;
use crate::rule::Rule;
use crate::sink::{PartOf, Sink};
use mapd_xodr::{ConnectionEnd, JunctionLaneLink, JunctionType as Kind, LaneType};
use std::collections::BTreeMap;

/// Two roads; the second one's links and the first one's.
macro_rules! pair {
    ($first:literal, $lane:literal, $second:literal, $back:literal) => {
        Document(concat!(
            r#"<road id="1" length="50" junction="-1"><link>"#, $first, r#"</link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving">"#, $lane, r#"<width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link>"#, $second, r#"</link><planView><geometry s="0" x="50" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving">"#, $back, r#"<width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#
        ))
    };
}

pub(super) use pair;

pub(super) static RULES: &[Rule] = &[
    Rule::info(
        "mapd:xodr:1.4.0:topology.disconnected",
        "Driving lanes form one connected network.",
        All(disconnected),
        [
            pair!(
                r#"<successor elementType="road" elementId="2" contactPoint="start"/>"#,
                r#"<link><successor id="-1"/></link>"#,
                r#"<predecessor elementType="road" elementId="1" contactPoint="end"/>"#,
                r#"<link><predecessor id="-1"/></link>"#
            ),
            pair!("", "", "", ""),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.4.0:topology.dead_lane",
        "A driving lane has a predecessor or successor, unless it is at an unconnected end of a road.",
        All(dead),
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
    ),
];

/// The representative of a set, with paths halved on the way.
fn root(parents: &mut [usize], mut at: usize) -> usize {
    while let Some(&parent) = parents.get(at).filter(|parent| **parent != at) {
        let next = parents.get(parent).copied().unwrap_or(parent);
        parents[at] = next;
        at = next;
    }
    at
}

/// Every pair of lanes that are linked, by rank among all lanes.
fn linked_lanes(network: &Network, mut show: impl FnMut(usize, usize)) {
    network.each_lane_joint(|joint| {
        let target = joint.neighbor.and_then(|n| network.lane_rank(n.section, joint.link.id));
        if let Some(target) = target {
            show(joint.lane_rank, target);
        }
    });
    for junction in network.junctions_as_written() {
        for connection in &junction.connection {
            if let (Some(from), Some(to)) = (&connection.predecessor, &connection.successor) {
                virtually_linked(network, [from, to], &connection.lane_link, &mut show);
            }
        }
    }
    for JunctionConnection { junction, connection } in network.real_connections() {
        let Some(incoming) = network.road_named(connection.incoming) else { continue };
        let Some(other) = network.road_named(connection.entered()) else { continue };
        let Some(contact) = connection.contact else { continue };
        let id = junction.id.unwrap_or_default();
        let within = Some(RoadEnd { road: other, end: contact });
        let from = match junction.kind {
            Kind::Direct => network.connected_ends(junction, connection)[0].map(|at| at.end),
            _ => network.end_at_junction(incoming, id, within),
        };
        // Roads leave the main road of a virtual junction somewhere.
        let s = other.link(contact).and_then(|link| link.s);
        for link in network.connected_lanes(connection) {
            let (Some(a), Some(b)) = (link.from, link.to) else { continue };
            let from = match (from, s) {
                (Some(end), _) => network.section_at(incoming, end, a),
                (None, Some(s)) => network.section_over(incoming, s, a),
                (None, None) => None,
            };
            let (Some(from), Some(to)) = (from, network.section_at(other, contact, b)) else {
                continue;
            };
            if let (Some(a), Some(b)) = (network.lane_rank(from, a), network.lane_rank(to, b)) {
                show(a, b);
            }
        }
    }
}

/// The pairs of lanes that a virtual connection links: at places inside roads.
fn virtually_linked(
    network: &Network,
    ends: [&ConnectionEnd; 2],
    links: &[JunctionLaneLink],
    show: &mut impl FnMut(usize, usize),
) {
    let [from, to] = ends.map(|end| network.road(text(&end.element_id)).zip(value(&end.element_s)));
    let rank = |place: Option<(&RoadFacts, f64)>, lane: i32| {
        let (road, s) = place?;
        network.lane_rank(network.section_over(road, s, lane)?, lane)
    };
    for (left, entered) in links.iter().filter_map(|l| value(&l.from).zip(value(&l.to))) {
        if let (Some(a), Some(b)) = (rank(from, left), rank(to, entered)) {
            show(a, b);
        }
    }
}

fn disconnected(network: &Network, sink: &mut Sink<'_>) {
    let mut parents: Vec<usize> = (0..network.lanes.len()).collect();
    linked_lanes(network, |a, b| {
        let (a, b) = (root(&mut parents, a), root(&mut parents, b));
        // The smaller rank stands for the set, whatever the order.
        parents[a.max(b)] = a.min(b);
    });
    // Lanes side by side are of one part.
    for section in &network.sections {
        let mut before = None;
        for (rank, lane) in section.lane_ranks().zip(network.lanes_of(section)) {
            if !is_drivable(lane.kind) {
                continue;
            }
            let own = root(&mut parents, rank);
            if let Some(other) = before.replace(rank) {
                let other = root(&mut parents, other);
                parents[own.max(other)] = own.min(other);
            }
        }
    }
    let mut parts: BTreeMap<usize, usize> = BTreeMap::new();
    for rank in 0..network.lanes.len() {
        if network.lanes.get(rank).is_some_and(|lane| is_drivable(lane.kind)) {
            *parts.entry(root(&mut parents, rank)).or_default() += 1;
        }
    }
    let Some(largest) = parts
        .iter()
        .max_by_key(|(rank, count)| (**count, std::cmp::Reverse(**rank)))
        .map(|(rank, _)| *rank)
    else {
        return;
    };
    if parts.len() == 1 {
        return;
    }
    let mut roads: BTreeMap<usize, Name> = BTreeMap::new();
    for road in &network.roads {
        for section in network.sections_of(road) {
            roads.extend(parts.range(section.lane_ranks()).map(|(rank, _)| (*rank, road.id)));
        }
    }
    for (rank, count) in parts.iter().filter(|(rank, _)| **rank != largest) {
        let Some(lane) = network.lanes.get(*rank) else { continue };
        let id = network.name(roads.get(rank).copied().unwrap_or_default());
        let lanes = if *count == 1 { "lane" } else { "lanes" };
        let found = format_args!("a group of {count} {lanes} apart, one of {} groups", parts.len());
        sink.add_in(
            PartOf::road(id, "lanes"),
            lane.span,
            "lanes that are linked to the others",
            found,
        );
    }
}

/// Whether traffic drives on lanes of a type, and not only where it must, as at a lane's border.
pub(super) fn is_driven(kind: LaneType) -> bool {
    use LaneType as T;
    is_drivable(kind) && !matches!(kind, T::Border | T::Stop | T::Restricted | T::RoadWorks)
}

fn dead(network: &Network, sink: &mut Sink<'_>) {
    let mut is_linked = vec![false; network.lanes.len()];
    linked_lanes(network, |a, b| {
        for rank in [a, b] {
            if let Some(linked) = is_linked.get_mut(rank) {
                *linked = true;
            }
        }
    });
    for road in &network.roads {
        // Where neither end of a road goes on, a lane may begin or end with it.
        let stands_alone = road.links.iter().all(Option::is_none);
        let sections = network.sections_of(road);
        let inside =
            if stands_alone { 1..sections.len().saturating_sub(1) } else { 0..sections.len() };
        for (number, section) in inside.clone().zip(sections.get(inside).unwrap_or_default()) {
            for (rank, lane) in section.lane_ranks().zip(network.lanes_of(section)) {
                let has_width = Contact::BOTH.into_iter().any(|end| lane.width(end) > 0.0);
                if is_driven(lane.kind)
                    && has_width
                    && !is_linked.get(rank).copied().unwrap_or(true)
                {
                    let part = format!("lanes/laneSection[@s={}]/lane[@id={}]", section.s, lane.id);
                    let part = PartOf::road(network.name(road.id), &part);
                    let found = "none at either end";
                    // The road that has the lane need not be the one that lacks the link.
                    let met = Contact::BOTH.into_iter().find_map(|end| {
                        let own = LaneEnd { road, section, lane, end };
                        Some((end, met_by_dead(network, &own, number)?))
                    });
                    let Some((end, other)) = met else {
                        sink.add_in(part, lane.span, "a link of the lane", found);
                        continue;
                    };
                    let (other, end) = (named(network, road, &other), end.name());
                    let expected =
                        format!("a link of the lane with {other}, which it meets at its {end}");
                    sink.add_in(part, lane.span, expected, found);
                }
            }
        }
    }
}
