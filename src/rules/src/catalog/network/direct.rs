//! Direct junctions, seen with the roads that they join.

use super::connections::{add_to_connection, add_to_link};
use super::joints::{CORNER, Edge, KINK, STEP};
use crate::catalog::lanes::is_drivable;
use crate::example::Example::Document;
use crate::network::{ConnectionFacts, JunctionConnection, JunctionFacts, Network, RoadEnd};
use crate::rule::Check::Network as All;
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::JunctionType as Kind;

/// A road that splits into two others at direct junction 9; the second one begins at y with a heading, height and width.
macro_rules! split {
    ($y:literal, $hdg:literal, $z:literal, $overlap:literal) => {
        Document(concat!(
            r#"<road id="1" length="50" junction="-1"><link><successor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane><lane id="-2" type="exit"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link><predecessor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="3" length="50" junction="-1"><link><predecessor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="50" y=""#, $y, r#"" hdg=""#, $hdg, r#"" length="50"><line/></geometry></planView><elevationProfile><elevation s="0" a=""#, $z, r#"" b="0" c="0" d="0"/></elevationProfile><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="exit"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<junction id="9" name="" type="direct"><connection id="0" incomingRoad="1" linkedRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><connection id="1" incomingRoad="1" linkedRoad="3" contactPoint="start"><laneLink from="-2" to="-1" "#, $overlap, "/></connection></junction>"
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:junctions.direct.linked_lane_smoothness",
        "Lanes that a direct junction links meet without a gap.",
        All(smooth),
        [split!("-3", "0", "0", ""), split!("-4", "0", "0", "")],
    )
    .within(&[CORNER]),
    Rule::warning(
        "asam.net:xodr:1.7.0:junctions.direct.road_ramp_heading",
        "Roads that a direct junction joins have the same heading there.",
        All(heading),
        [split!("-3", "0", "0", ""), split!("-3", "-0.2", "0", "")],
    )
    .within(&[KINK]),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.direct.flat_exits_entries",
        "Roads that a direct junction joins have the same height there.",
        All(height),
        [split!("-3", "0", "0", ""), split!("-3", "0", "2", "")],
    )
    .within(&[STEP]),
];

struct Joined<'a> {
    network: &'a Network,
    junction: &'a JunctionFacts,
    connection: &'a ConnectionFacts,
    incoming: RoadEnd<'a>,
    linked: RoadEnd<'a>,
}

fn joined(network: &Network) -> impl Iterator<Item = Joined<'_>> {
    let junctions = network.junctions.iter().filter(|junction| junction.kind == Kind::Direct);
    junctions.flat_map(move |junction| {
        network.connections_of(junction).iter().filter_map(move |connection| {
            let [incoming, linked] = network.connected_ends(junction, connection);
            let (incoming, linked) = (incoming?, linked?);
            Some(Joined { network, junction, connection, incoming, linked })
        })
    })
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

    /// The two reference lines where they meet.
    fn lines(&self, network: &Network) -> Option<(Edge, Edge)> {
        let edge = |at: RoadEnd<'_>| {
            Some(Edge { station: network.station_of(at.road, at.end)?, borders: [0.0; 2] })
        };
        Some((edge(self.incoming)?, edge(self.linked)?))
    }
}

fn smooth(network: &Network, sink: &mut Sink<'_>) {
    for joint in network.connected_joints(Kind::Direct) {
        if !is_drivable(joint.from.lane.kind) || !is_drivable(joint.to.lane.kind) {
            continue;
        }
        let (Some(a), Some(b)) = (Edge::of(network, &joint.from), Edge::of(network, &joint.to))
        else {
            continue;
        };
        let gap = a.gap(&b);
        if gap > CORNER.value {
            let [from, to] = [&joint.from, &joint.to].map(|end| end.lane.id);
            let expected = format_args!("lanes {from} and {to} that meet");
            add_to_link(network, &joint, sink, expected, format_args!("a gap of {gap:.3} m"));
        }
    }
}

fn heading(network: &Network, sink: &mut Sink<'_>) {
    for joined in joined(network) {
        let Some((a, b)) = joined.lines(network) else { continue };
        let kink = a.kink(&b);
        if kink > KINK.value {
            joined.add(sink, "one heading", format_args!("a kink of {kink:.4} rad"));
        }
    }
}

fn height(network: &Network, sink: &mut Sink<'_>) {
    for joined in joined(network) {
        let Some((a, b)) = joined.lines(network) else { continue };
        let step = a.step(&b);
        // Rolled reference lines that lie beside one another differ in height.
        if step > STEP.value && a.station.roll == 0.0 && b.station.roll == 0.0 {
            joined.add(sink, "one height", format_args!("a step of {step:.3} m"));
        }
    }
}
