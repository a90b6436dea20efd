//! Connections of junctions, seen with the roads that they join.

use super::joints::{Edge, KINK};
use crate::catalog::lanes::is_drivable;
use crate::example::Example::{Document, Junction as In};
use crate::network::{
    ConnectedJoint, ConnectionFacts, Contact, JunctionConnection, JunctionFacts, LinkTarget, Name,
    Network, RoadEnd, RoadFacts,
};
use crate::place::text;
use crate::rule::Check::Network as All;
use crate::rule::Rule;
use crate::sink::{PartOf, Sink};
use mapd_xodr::JunctionType as Kind;
use std::collections::{BTreeMap, BTreeSet};

const SOUND: crate::example::Example = In(
    r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#,
);

/// A road into junction 9, two roads within it and one behind; the example gives the second one's heading and surface.
macro_rules! split {
    ($hdg:literal, $surface:literal, $junction:literal) => {
        Document(concat!(
            r#"<road id="1" length="50" junction="-1"><link><successor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="20" junction="9"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg=""#, $hdg, r#"" length="20"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes>"#, $surface, r#"</road>
<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection>"#, $junction, "</junction>"
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:junctions.connection.start_along_linkage",
        "A connection at the start of a connecting road matches that road's predecessor.",
        All(start_along),
        [
            SOUND,
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="3" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:junctions.connection.end_opposite_linkage",
        "A connection at the end of a connecting road matches that road's successor.",
        All(end_opposite),
        [
            SOUND,
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="end"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.4.0:junction.connecting_road",
        "A road within a junction names the junction.",
        All(belongs),
        [
            SOUND,
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="3" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.4.0:junction.entered_road",
        "Where a junction has connections, each road within it that vehicles drive on is the connecting road of one.",
        All(is_entered),
        [
            SOUND,
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="3" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.4.0:ref.orphan_lane_link",
        "A connection links lanes that its roads have where they meet.",
        All(lane_links),
        [
            SOUND,
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-5" to="-1"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:junctions.connection.smooth_fit",
        "Linked lanes of an incoming road and a road within the junction meet with the same heading.",
        All(smooth),
        [split!("0", "", ""), split!("0.1", "", "")],
    )
    .within(&[KINK]),
    Rule::info(
        "asam.net:xodr:1.9.0:junctions.common.not_only_two",
        "A junction joins more than two roads.",
        All(not_only_two),
        [
            In(r#"<junction id="9" name="" type="crossing"><roadSection id="0" roadId="1" sStart="1" sEnd="2"/><roadSection id="1" roadId="3" sStart="1" sEnd="2"/></junction>"#),
            SOUND,
        ],
    )
    .advisory(),
    Rule::info(
        "asam.net:xodr:1.4.0:junctions.common.when_to_use",
        "A junction exists only where traffic can choose or merges.",
        All(has_choice),
        [
            In(r#"<junction id="9" name="" type="crossing"><roadSection id="0" roadId="1" sStart="1" sEnd="2"/><roadSection id="1" roadId="3" sStart="1" sEnd="2"/></junction>"#),
            SOUND,
        ],
    )
    .advisory(),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.crg.junction",
        "If a junction has surface data, the roads within have none.",
        All(surface),
        [
            split!("0", "", r#"<surface><CRG file="a.crg" sStart="0" sEnd="0" orientation="same" mode="global" purpose="elevation"/></surface>"#),
            split!("0", r#"<surface><CRG file="b.crg" sStart="0" sEnd="20" orientation="same" mode="attached" purpose="elevation"/></surface>"#, r#"<surface><CRG file="a.crg" sStart="0" sEnd="0" orientation="same" mode="global" purpose="elevation"/></surface>"#),
        ],
    ),
];

/// A connection of a default or virtual junction with the roads that it joins, as far as they are there.
struct Joined<'a> {
    network: &'a Network,
    junction: &'a JunctionFacts,
    connection: &'a ConnectionFacts,
    incoming: Option<&'a RoadFacts>,
    connecting: Option<&'a RoadFacts>,
    /// The end of the connecting road that touches the incoming one.
    contact: Option<Contact>,
    /// The end of the incoming road that touches the junction.
    incoming_end: Option<Contact>,
}

fn joined(network: &Network) -> impl Iterator<Item = Joined<'_>> {
    let junctions = network.junctions.iter().filter(|junction| junction.kind == Kind::Default);
    junctions.flat_map(move |junction| {
        let id = junction.id.unwrap_or_default();
        network.connections_of(junction).iter().map(move |connection| {
            let incoming = network.road_named(connection.incoming);
            let connecting = network.road_named(connection.connecting);
            let contact = connection.contact;
            let incoming_end = incoming.and_then(|road| {
                network.end_at_junction(road, id, RoadEnd::of(connecting, contact))
            });
            Joined { network, junction, connection, incoming, connecting, contact, incoming_end }
        })
    })
}

/// Adds a finding about a connection.
pub(super) fn add_to_connection(
    network: &Network,
    at: JunctionConnection<'_>,
    sink: &mut Sink<'_>,
    expected: impl std::fmt::Display,
    found: impl std::fmt::Display,
) {
    let id = network.name(at.connection.id);
    let path = format!("connection[@id={id}]");
    let part = PartOf::junction(network.junction_id(at.junction), &path);
    sink.add_in(part, at.connection.span, expected, found);
}

/// Adds a finding about a link of a connection.
pub(super) fn add_to_link(
    network: &Network,
    joint: &ConnectedJoint<'_>,
    sink: &mut Sink<'_>,
    expected: impl std::fmt::Display,
    found: impl std::fmt::Display,
) {
    let path = format!("connection[@id={}]/laneLink", network.name(joint.connection.id));
    let part = PartOf::junction(network.junction_id(joint.junction), &path);
    sink.add_in(part, joint.link.span, expected, found);
}

impl Joined<'_> {
    fn add(
        &self,
        sink: &mut Sink<'_>,
        expected: impl std::fmt::Display,
        found: impl std::fmt::Display,
    ) {
        let at = JunctionConnection { junction: self.junction, connection: self.connection };
        add_to_connection(self.network, at, sink, expected, found);
    }
}

fn linkage(network: &Network, end: Contact, sink: &mut Sink<'_>) {
    for joined in joined(network).filter(|joined| joined.contact == Some(end)) {
        let (Some(incoming), Some(connecting)) = (joined.incoming, joined.connecting) else {
            continue;
        };
        let link = connecting.link(end).map(|link| link.target);
        if link != Some(LinkTarget::Road(incoming.id)) {
            let found = link_to(network, link);
            let expected = format_args!(
                "a link from the {} of road {} to road {}",
                end.name(),
                network.name(connecting.id),
                network.name(incoming.id)
            );
            joined.add(sink, expected, found);
        }
    }
}

fn start_along(network: &Network, sink: &mut Sink<'_>) {
    linkage(network, Contact::Start, sink);
}

fn end_opposite(network: &Network, sink: &mut Sink<'_>) {
    linkage(network, Contact::End, sink);
}

fn belongs(network: &Network, sink: &mut Sink<'_>) {
    for joined in joined(network) {
        let Some(road) = joined.connecting else { continue };
        if road.junction != joined.junction.id.or(Some(Name::default())) {
            let junction = road.junction.map_or("none", |junction| network.name(junction));
            let found = format_args!("road {} of {junction}", network.name(road.id));
            let id = network.junction_id(joined.junction);
            joined.add(sink, format_args!("a road of junction {id}"), found);
        }
    }
}

/// Roads that no connection leads into: nobody gets onto them from outside the junction.
fn is_entered(network: &Network, sink: &mut Sink<'_>) {
    for junction in &network.junctions {
        let Some(id) =
            junction.id.filter(|_| matches!(junction.kind, Kind::Default | Kind::Virtual))
        else {
            continue;
        };
        let connections = network.connections_of(junction);
        if connections.is_empty() {
            continue;
        }
        let connecting: BTreeSet<Name> = connections.iter().map(|own| own.connecting).collect();
        for road in network.roads_within(id).filter(|road| !connecting.contains(&road.id)) {
            let mut lanes = network.sections_of(road).iter().flat_map(|own| network.lanes_of(own));
            if lanes.any(|lane| is_drivable(lane.kind)) {
                sink.add_in(
                    PartOf::road(network.name(road.id), ""),
                    road.span,
                    format_args!(
                        "a connection of junction {} that leads into it",
                        network.name(id)
                    ),
                    "none",
                );
            }
        }
    }
}

fn lane_links(network: &Network, sink: &mut Sink<'_>) {
    for joined in joined(network) {
        let sides = [(joined.incoming, joined.incoming_end), (joined.connecting, joined.contact)];
        for link in network.connected_lanes(joined.connection) {
            for ((road, end), id) in sides.iter().zip([link.from, link.to]) {
                let (Some(road), Some(end), Some(id)) = (road, end, id) else { continue };
                let Some(section) = network.section_at(road, *end, id) else { continue };
                if network.lane(section, id).is_none() && id != 0 {
                    let expected = format_args!(
                        "a lane at the {} of road {}",
                        end.name(),
                        network.name(road.id)
                    );
                    let span = link.span;
                    let found = format_args!("lane {id}, which does not exist");
                    let id = network.name(joined.connection.id);
                    let path = format!("connection[@id={id}]/laneLink");
                    let part = PartOf::junction(network.junction_id(joined.junction), &path);
                    sink.add_in(part, span, expected, found);
                }
            }
        }
    }
}

fn smooth(network: &Network, sink: &mut Sink<'_>) {
    for joint in network.connected_joints(Kind::Default) {
        if !is_drivable(joint.from.lane.kind) || !is_drivable(joint.to.lane.kind) {
            continue;
        }
        let (Some(a), Some(b)) = (Edge::of(network, &joint.from), Edge::of(network, &joint.to))
        else {
            continue;
        };
        let kink = a.kink(&b);
        if kink > KINK.value {
            let [from, to] = [&joint.from, &joint.to].map(|end| end.lane.id);
            let expected = format_args!("lanes {from} and {to} with one heading");
            add_to_link(network, &joint, sink, expected, format_args!("a kink of {kink:.4} rad"));
        }
    }
}

/// What a link leads to, in words.
pub(super) fn link_to(network: &Network, link: Option<LinkTarget>) -> String {
    match link {
        None => "none".to_owned(),
        Some(LinkTarget::Road(id)) => format!("one to road {}", network.name(id)),
        Some(LinkTarget::Junction(id)) => format!("one to junction {}", network.name(id)),
    }
}

/// Roads that lead into or out of a junction.
fn arms(network: &Network, junction: &JunctionFacts) -> BTreeSet<Name> {
    let roads = network.roads_within(junction.id.unwrap_or_default());
    let links = roads.flat_map(|road| road.links.iter().flatten());
    let linked = links.filter_map(|link| match link.target {
        LinkTarget::Road(id) => Some(id),
        LinkTarget::Junction(_) => None,
    });
    let connections = network.connections_of(junction).iter();
    let mut arms: BTreeSet<Name> =
        linked.chain(connections.flat_map(|c| [c.incoming, c.linked])).collect();
    arms.remove(&Name::default());
    arms
}

fn not_only_two(network: &Network, sink: &mut Sink<'_>) {
    let junctions = network.junctions.iter();
    for junction in junctions.filter(|j| matches!(j.kind, Kind::Default | Kind::Direct)) {
        let arms = arms(network, junction);
        if arms.len() <= 2 && !network.connections_of(junction).is_empty() {
            let part = PartOf::junction(network.junction_id(junction), "");
            sink.add_in(part, junction.span, "more than two roads", arms.len());
        }
    }
}

fn has_choice(network: &Network, sink: &mut Sink<'_>) {
    for junction in network.junctions.iter().filter(|j| j.kind == Kind::Default) {
        let (mut from, mut to): (BTreeMap<Name, usize>, BTreeMap<Name, usize>) = Default::default();
        for connection in network.connections_of(junction) {
            *from.entry(connection.incoming).or_default() += 1;
            let Some(road) = network.road_named(connection.connecting) else { continue };
            let Some(contact) = connection.contact else { continue };
            if let Some(LinkTarget::Road(id)) = road.link(contact.other()).map(|link| link.target) {
                *to.entry(id).or_default() += 1;
            }
        }
        if !from.is_empty() && from.values().chain(to.values()).all(|count| *count == 1) {
            let part = PartOf::junction(network.junction_id(junction), "");
            sink.add_in(
                part,
                junction.span,
                "a choice or a merge",
                "only one route from each road to another",
            );
        }
    }
}

fn surface(network: &Network, sink: &mut Sink<'_>) {
    for junction in network.junctions_as_written() {
        if junction.surface.as_ref().is_none_or(|surface| surface.crg.is_empty()) {
            continue;
        }
        let id = text(&junction.id);
        let Some(name) = network.name_of(id) else { continue };
        for road in network.roads_within(name).filter(|road| road.has_crg) {
            let expected = format_args!("no surface data, for junction {id} has some");
            sink.add_in(
                PartOf::road(network.name(road.id), "surface"),
                road.span,
                expected,
                "some",
            );
        }
    }
}
