//! Links of roads.

use super::connections::link_to;
use crate::example::Example::Document;
use crate::network::{Contact, LinkTarget, Name, Network, RoadEnd};
use crate::rule::Check::Network as All;
use crate::rule::{Rule, Tolerance};
use crate::sink::{PartOf, Sink};
use std::collections::HashMap;

/// Distance of two ends that come from rounding in the file.
const APART: Tolerance = Tolerance { name: "distance of ends", value: 0.01, unit: "m" };

/// Two roads in a row: links of the first, links and start of the second.
macro_rules! pair {
    ($first:literal, $second:literal, $x:literal) => {
        pair!($first, $second, $x, "")
    };
    ($first:literal, $second:literal, $x:literal, $more:literal) => {
        Document(concat!(
            r#"<road id="1" length="50" junction="-1"><link>"#, $first, r#"</link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link>"#, $second, r#"</link><planView><geometry s="0" x=""#, $x, r#"" y="0" hdg="0" length="50"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>"#, $more
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:road.geometry.contact_point",
        "The reference lines of linked roads meet at the ends that the link names.",
        All(meet),
        [
            pair!(
                r#"<successor elementType="road" elementId="2" contactPoint="start"/>"#,
                r#"<predecessor elementType="road" elementId="1" contactPoint="end"/>"#,
                "50"
            ),
            pair!(
                r#"<successor elementType="road" elementId="2" contactPoint="start"/>"#,
                r#"<predecessor elementType="road" elementId="1" contactPoint="end"/>"#,
                "52"
            ),
        ],
    )
    .within(&[APART]),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.linkage.both_sides_consistency",
        "Two linked roads each name the other, with the contact point.",
        All(consistent),
        [
            pair!(
                r#"<successor elementType="road" elementId="2" contactPoint="start"/>"#,
                r#"<predecessor elementType="road" elementId="1" contactPoint="end"/>"#,
                "50"
            ),
            pair!(
                r#"<successor elementType="road" elementId="2" contactPoint="start"/>"#,
                "",
                "50"
            ),
        ],
    )
    .also(&["mapd:xodr:1.4.0:topology.asymmetric_link"]),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.linkage.is_junction_needed",
        "An end of a road is linked to one road; links to several roads need a junction.",
        All(one_to_one),
        [
            pair!(
                r#"<successor elementType="road" elementId="2" contactPoint="start"/>"#,
                r#"<predecessor elementType="road" elementId="1" contactPoint="end"/>"#,
                "50"
            ),
            pair!(
                r#"<successor elementType="road" elementId="2" contactPoint="start"/>"#,
                r#"<predecessor elementType="road" elementId="1" contactPoint="end"/>"#,
                "50",
                r#"<road id="3" length="50" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg="0.2" length="50"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>"#
            ),
        ],
    ),
];

fn part(end: Contact) -> &'static str {
    match end {
        Contact::Start => "link/predecessor",
        Contact::End => "link/successor",
    }
}

fn meet(network: &Network, sink: &mut Sink<'_>) {
    for road in &network.roads {
        for end in Contact::BOTH {
            let Some(RoadEnd { road: target, end: contact }) = network.linked_road(road, end)
            else {
                continue;
            };
            let (Some(own), Some(other)) =
                (network.station_of(road, end), network.station_of(target, contact))
            else {
                continue;
            };
            let apart = mapd_geometry::hypot(own.x - other.x, own.y - other.y);
            // Within a junction, reference lines may be beside one another: lanes meet, not they.
            if apart > APART.value && road.junction.is_none() && target.junction.is_none() {
                let span = road.link(end).map_or(road.span, |link| link.span);
                let found = format_args!("road {} {apart:.3} m away", network.name(target.id));
                sink.add_in(
                    PartOf::road(network.name(road.id), part(end)),
                    span,
                    "a road that begins or ends here",
                    found,
                );
            }
        }
    }
}

fn consistent(network: &Network, sink: &mut Sink<'_>) {
    for road in &network.roads {
        for end in Contact::BOTH {
            let Some(RoadEnd { road: target, end: contact }) = network.linked_road(road, end)
            else {
                continue;
            };
            let back = target.link(contact);
            let names_junction =
                back.is_some_and(|link| matches!(link.target, LinkTarget::Junction(_)));
            // Roads within a junction name roads, those outside of it the junction.
            if names_junction && road.junction.is_some() {
                continue;
            }
            let is_back = network
                .linked_road(target, contact)
                .is_some_and(|back| back.road.id == road.id && back.end == end);
            if !is_back {
                let span = road.link(end).map_or(road.span, |link| link.span);
                let (touched, target) = (contact.name(), network.name(target.id));
                let expected = format_args!("a link back from the {touched} of road {target}");
                let found = link_to(network, back.map(|link| link.target));
                sink.add_in(PartOf::road(network.name(road.id), part(end)), span, expected, found);
            }
        }
    }
}

fn one_to_one(network: &Network, sink: &mut Sink<'_>) {
    let mut claimed: HashMap<(Name, Contact), Name> = HashMap::new();
    for road in network.roads.iter().filter(|road| road.junction.is_none()) {
        for end in Contact::BOTH {
            let Some(RoadEnd { road: target, end: contact }) = network.linked_road(road, end)
            else {
                continue;
            };
            let before = claimed.insert((target.id, contact), road.id);
            if let Some(before) = before.filter(|before| *before != road.id) {
                let span = road.link(end).map_or(road.span, |link| link.span);
                let expected = format_args!(
                    "one road at the {} of road {}, or a junction",
                    contact.name(),
                    network.name(target.id)
                );
                let [before, own] = [before, road.id].map(|id| network.name(id));
                let found = format_args!("roads {before} and {own}");
                sink.add_in(PartOf::road(network.name(road.id), part(end)), span, expected, found);
            }
        }
    }
}
