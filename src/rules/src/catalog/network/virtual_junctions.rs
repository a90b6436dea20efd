//! Virtual junctions, seen with their main road.

use super::joints::{CORNER, Edge, KINK};
use crate::catalog::junctions::kind;
use crate::example::Example::Document;
use crate::network::{Contact, LinkTarget, Network, RoadEnd, RoadFacts};
use crate::place::{text, value};
use crate::rule::Check::Network as All;
use crate::rule::{Rule, Tolerance};
use crate::sink::{PartOf, Sink};
use mapd_xodr::{Junction, JunctionType as Kind};

/// Places along the main road that are meant to be one.
const PLACE: Tolerance = Tolerance { name: "difference of s", value: 0.1, unit: "m" };

/// A main road of 100 m and a road that leaves it at s, as far from it, with a heading.
macro_rules! leave {
    ($s:literal, $x:literal, $y:literal, $hdg:literal) => {
        Document(concat!(
            r#"<road id="1" length="100" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="20" junction="9"><link><predecessor elementType="road" elementId="1" elementS=""#, $s, r#"" elementDir="+"/></link><planView><geometry s="0" x=""#, $x, r#"" y=""#, $y, r#"" hdg=""#, $hdg, r#"" length="20"><arc curvature="-0.05"/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<junction id="9" name="" type="virtual" mainRoad="1" sStart="40" sEnd="60" orientation="none"><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.9.0:junctions.virtual.connecting_roads_start_end",
        "Roads within a virtual junction begin or end at the junction's ends on the main road.",
        All(at_ends),
        [leave!("40", "40", "0", "0"), leave!("50", "50", "0", "0")],
    )
    .within(&[PLACE]),
    Rule::warning(
        "asam.net:xodr:1.9.0:junctions.virtual.heading_equal_mainroad",
        "Roads within a virtual junction leave the main road in its direction.",
        All(heading),
        [leave!("40", "40", "0", "0"), leave!("40", "40", "0", "-0.3")],
    )
    .within(&[KINK]),
    Rule::warning(
        "asam.net:xodr:1.9.0:junctions.virtual.linked_lanes_smooth_fit",
        "Lanes that a virtual junction links meet without a gap.",
        All(smooth),
        [leave!("40", "40", "0", "0"), leave!("40", "40", "-1", "0")],
    )
    .within(&[CORNER]),
];

/// A road within a virtual junction, the end of it that touches the main road, and where on that.
struct Leaving<'a> {
    network: &'a Network,
    junction: &'a Junction,
    main: &'a RoadFacts,
    road: &'a RoadFacts,
    end: Contact,
    s: f64,
}

fn leaving(network: &Network) -> impl Iterator<Item = Leaving<'_>> {
    let junctions =
        network.junctions_as_written().filter(|junction| kind(junction) == Kind::Virtual);
    junctions.flat_map(move |junction| {
        let main = network.road(text(&junction.main_road));
        let within = network.name_of(text(&junction.id)).into_iter();
        let within = within.flat_map(|junction| network.roads_within(junction));
        within.flat_map(move |road| {
            Contact::BOTH.into_iter().filter_map(move |end| {
                let link = road.link(end)?;
                let main = main?;
                let is_main = link.target == LinkTarget::Road(main.id);
                Some(Leaving { network, junction, main, road, end, s: link.s.filter(|_| is_main)? })
            })
        })
    })
}

impl Leaving<'_> {
    fn add(
        &self,
        sink: &mut Sink<'_>,
        expected: impl std::fmt::Display,
        found: impl std::fmt::Display,
    ) {
        let part = match self.end {
            Contact::Start => "link/predecessor",
            Contact::End => "link/successor",
        };
        let span = self.road.link(self.end).map_or(self.road.span, |link| link.span);
        sink.add_in(PartOf::road(self.network.name(self.road.id), part), span, expected, found);
    }
}

fn at_ends(network: &Network, sink: &mut Sink<'_>) {
    for leaving in leaving(network) {
        let junction = leaving.junction;
        // What is missing is told of as such.
        let (Some(start), Some(end)) = (junction.s_start, junction.s_end) else { continue };
        let ends = [start.value, end.value];
        if ends.iter().all(|end| (leaving.s - end).abs() > PLACE.value) {
            let main = network.name(leaving.main.id);
            let expected = format_args!("s of {} or {} on road {main}", ends[0], ends[1]);
            leaving.add(sink, expected, leaving.s);
        }
    }
}

fn heading(network: &Network, sink: &mut Sink<'_>) {
    for leaving in leaving(network) {
        let (Some(main), Some(own)) = (
            network.station_at(leaving.main, leaving.s),
            network.station_of(leaving.road, leaving.end),
        ) else {
            continue;
        };
        let kink = Edge { station: main, borders: [0.0; 2] }
            .kink(&Edge { station: own, borders: [0.0; 2] });
        if kink > KINK.value {
            let main = network.name(leaving.main.id);
            let expected = format_args!("the heading of road {main}");
            leaving.add(sink, expected, format_args!("one that differs by {kink:.4} rad"));
        }
    }
}

fn smooth(network: &Network, sink: &mut Sink<'_>) {
    for leaving in leaving(network) {
        let connections = leaving.junction.connection.iter();
        let own = network.name(leaving.road.id);
        for connection in connections.filter(|c| text(&c.connecting_road) == own) {
            if crate::network::contact(&connection.contact_point) != Some(leaving.end) {
                continue;
            }
            for link in &connection.lane_link {
                let (Some(from), Some(to)) = (value(&link.from), value(&link.to)) else { continue };
                let Some(gap) = gap(network, &leaving, from, to) else { continue };
                if gap > CORNER.value {
                    let main = network.name(leaving.main.id);
                    let expected = format_args!("lane {to} at lane {from} of road {main}");
                    leaving.add(sink, expected, format_args!("a gap of {gap:.3} m"));
                }
            }
        }
    }
}

/// The gap between a lane of the main road and one of the road that leaves it `[m]`.
fn gap(network: &Network, leaving: &Leaving<'_>, from: i32, to: i32) -> Option<f64> {
    let over = network.section_over(leaving.main, leaving.s, from)?;
    let borders = Network::borders_over(over, network.lane(over, from)?, leaving.s);
    let main = Edge { station: network.station_at(leaving.main, leaving.s)?, borders };
    let own = Edge::of(
        network,
        &network.lane_end(RoadEnd { road: leaving.road, end: leaving.end }, to)?,
    )?;
    Some(main.gap(&own))
}
