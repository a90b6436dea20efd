//! Roads that lead into junctions.

use super::connections::{add_to_connection, add_to_link};
use crate::catalog::lanes::is_drivable;
use crate::example::Example::{Document, Junction as In};
use crate::network::{Contact, JunctionConnection, LaneEnd, Name, Network};
use crate::rule::Check::Network as All;
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::JunctionType as Kind;
use std::collections::BTreeSet;

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.4.0:junctions.connection.connect_road_no_incoming_road",
        "A road within a junction does not lead into another junction.",
        All(within),
        [
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>
<junction id="8" name=""><connection id="0" incomingRoad="2" connectingRoad="3" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.connection.one_link_to_incoming",
        "An incoming road and a road within the junction have one connection, and it links lanes that lead into the junction.",
        All(one_link),
        [
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
            Document(r#"<road id="1" length="50" junction="-1"><link><successor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><left><lane id="1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center></laneSection></lanes></road>
<road id="2" length="20" junction="9"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="20"><line/></geometry></planView><lanes><laneSection s="0"><left><lane id="1" type="driving"><link><predecessor id="1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center></laneSection></lanes></road>
<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="1" to="1"/></connection></junction>"#),
        ],
    )
    .also(&["mapd:xodr:1.4.0:junction.lane_direction"]),
];

fn within(network: &Network, sink: &mut Sink<'_>) {
    for junction in &network.junctions {
        if matches!(junction.kind, Kind::Direct | Kind::Crossing) {
            continue;
        }
        let connections = network.connections_of(junction);
        let entered: BTreeSet<Name> = connections.iter().map(|c| c.connecting).collect();
        for connection in connections.iter().filter(|c| c.incoming != Name::default()) {
            let road = network.road_named(connection.incoming);
            // The main road of a virtual junction may be within another one.
            let is_within =
                junction.kind == Kind::Default && road.is_some_and(|road| road.junction.is_some());
            if is_within || entered.contains(&connection.incoming) {
                let road = network.name(connection.incoming);
                let found = format_args!("road {road}, which is within a junction");
                let expected = "a road that leads into the junction from outside";
                let at = JunctionConnection { junction, connection };
                add_to_connection(network, at, sink, expected, found);
            }
        }
    }
}

fn one_link(network: &Network, sink: &mut Sink<'_>) {
    for junction in &network.junctions {
        let mut pairs = BTreeSet::new();
        for connection in network.connections_of(junction) {
            let (from, to) = (connection.incoming, connection.connecting);
            if from != Name::default() && to != Name::default() && !pairs.insert((from, to)) {
                let road = network.name(to);
                let found = format_args!("another to road {road}");
                let at = JunctionConnection { junction, connection };
                add_to_connection(network, at, sink, "one connection of two roads", found);
            }
        }
    }
    // Traffic leaves the incoming road at its end and enters the other one there.
    let leads_off = |end: &LaneEnd<'_>, leaves: bool| {
        let due = (end.end == Contact::End) == leaves;
        let along = Network::goes_along(end.road, end.lane);
        is_drivable(end.lane.kind) && along.is_some_and(|along| along != due)
    };
    for joint in network.connected_joints(Kind::Default) {
        let ends = [(&joint.from, true), (&joint.to, false)];
        let Some((end, _)) = ends.into_iter().find(|(end, leaves)| leads_off(end, *leaves)) else {
            continue;
        };
        let (lane, road) = (end.lane.id, network.name(end.road.id));
        let found = format_args!("lane {lane} of road {road}, which leads the other way");
        add_to_link(network, &joint, sink, "lanes that lead into the junction", found);
    }
}
