//! Direct junctions, seen with the roads that they join.

use super::connections::add_to_connection;
use super::joints::{CORNER, Edge, KINK, STEP};
use crate::catalog::lanes::is_drivable;
use crate::example::Example::Document;
use crate::network::{ConnectionFacts, Contact, JunctionFacts, Network, RoadFacts};
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
        "Roads that a direct junction joins have one heading there.",
        All(heading),
        [split!("-3", "0", "0", ""), split!("-3", "-0.2", "0", "")],
    )
    .within(&[KINK]),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.direct.flat_exits_entries",
        "Roads that a direct junction joins have one height there.",
        All(height),
        [split!("-3", "0", "0", ""), split!("-3", "0", "2", "")],
    )
    .within(&[STEP]),
];

struct Joined<'a> {
    network: &'a Network,
    junction: &'a JunctionFacts,
    connection: &'a ConnectionFacts,
    incoming: (&'a RoadFacts, Contact),
    linked: (&'a RoadFacts, Contact),
}

fn joined(network: &Network) -> impl Iterator<Item = Joined<'_>> {
    let junctions = network.junctions.iter().filter(|junction| junction.kind == Kind::Direct);
    junctions.flat_map(move |junction| {
        let id = junction.id.unwrap_or_default();
        network.connections_of(junction).iter().filter_map(move |connection| {
            let incoming = network.road_named(connection.incoming)?;
            let linked = (network.road_named(connection.linked)?, connection.contact?);
            let incoming = (incoming, network.end_at_junction(incoming, id, None)?);
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
        let about = (self.network, self.junction, self.connection);
        add_to_connection(about, sink, expected, found);
    }

    /// The two lanes of each link, as far as they are there.
    fn edges<'a>(
        &'a self,
        network: &'a Network,
    ) -> impl Iterator<Item = (i32, i32, Edge, Edge)> + 'a {
        let ends = [self.incoming, self.linked]
            .map(|(road, end)| network.section_at(road, end).map(|s| (road, s, end)));
        network.connected_lanes(self.connection).iter().filter_map(move |[from, to]| {
            let (from, to) = ((*from)?, (*to)?);
            let [a, b] = ends;
            let (a, b) = (a?, b?);
            let (lane_a, lane_b) = (network.lane(a.1, from)?, network.lane(b.1, to)?);
            if !is_drivable(lane_a.kind) || !is_drivable(lane_b.kind) {
                return None;
            }
            let a = Edge::of(network, a.0, a.1, lane_a, a.2)?;
            Some((from, to, a, Edge::of(network, b.0, b.1, lane_b, b.2)?))
        })
    }

    /// The two reference lines where they meet.
    fn lines(&self, network: &Network) -> Option<(Edge, Edge)> {
        let edge = |(road, end): (&RoadFacts, Contact)| {
            Some(Edge { station: network.station_of(road, end)?, borders: [0.0; 2] })
        };
        Some((edge(self.incoming)?, edge(self.linked)?))
    }
}

fn smooth(network: &Network, sink: &mut Sink<'_>) {
    for joined in joined(network) {
        for (from, to, a, b) in joined.edges(network) {
            let gap = a.gap(&b);
            if gap > CORNER.value {
                joined.add(
                    sink,
                    format_args!("lanes {from} and {to} that meet"),
                    format_args!("a gap of {gap:.3} m"),
                );
            }
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
