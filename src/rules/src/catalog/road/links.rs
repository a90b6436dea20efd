//! What a road's links say of themselves.

use crate::example::Example::{Document, Junction};
use crate::place::{RoadIn, value};
use crate::rule::Check::Road;
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::{ElementType, LinkedElement};

/// Two roads in a row; the first one's link has more attributes.
macro_rules! pair {
    ($link:literal) => {
        Document(concat!(
            r#"<road id="1" length="50" junction="-1"><link><successor "#,
            $link,
            r#"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link>
<planView><geometry s="0" x="50" y="0" hdg="0" length="50"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>"#
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.4.0:road.linkage.road_link_attribute_usage",
        "A link to a road has a contact point.",
        Road(to_road),
        [
            pair!(r#"elementType="road" elementId="2" contactPoint="start""#),
            pair!(r#"elementType="road" elementId="2""#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.linkage.junc_link_attribute_usage",
        "A link to a junction has only its kind and id.",
        Road(to_junction),
        [
            Junction(
                r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#,
            ),
            Document(
                r#"<road id="1" length="50" junction="-1"><link><successor elementType="junction" elementId="9" contactPoint="start"/></link>
<planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road><junction id="9" name=""/>"#,
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.linkage.virtjunc_link_attribute_usage",
        "A link into the middle of a road has elementS and elementDir together, and no contact point.",
        Road(to_middle),
        [
            pair!(r#"elementType="road" elementId="2" contactPoint="start""#),
            pair!(r#"elementType="road" elementId="2" elementS="5""#),
        ],
    ),
];

fn links<'a>(of: &RoadIn<'a>) -> impl Iterator<Item = (&'static str, &'a LinkedElement)> + use<'a> {
    let link = of.road.link.as_deref();
    let ends = [
        ("link/predecessor", link.and_then(|link| link.predecessor.as_deref())),
        ("link/successor", link.and_then(|link| link.successor.as_deref())),
    ];
    ends.into_iter().filter_map(|(part, link)| Some((part, link?)))
}

fn is_into_middle(link: &LinkedElement) -> bool {
    link.element_s.is_some() || link.element_dir.is_some()
}

fn to_road(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for (part, link) in links(of) {
        let is_road = value(&link.element_type) == Some(ElementType::Road);
        if is_road && link.contact_point.is_none() && !is_into_middle(link) {
            sink.add_within(part, link.span, "contactPoint", "none; the nearer end is taken");
        }
    }
}

fn to_junction(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for (part, link) in links(of) {
        if value(&link.element_type) != Some(ElementType::Junction) {
            continue;
        }
        for (name, given) in [
            ("contactPoint", link.contact_point.is_some()),
            ("elementS", link.element_s.is_some()),
            ("elementDir", link.element_dir.is_some()),
        ] {
            if given {
                sink.add_within(
                    part,
                    link.span,
                    format_args!("no {name} in a link to a junction"),
                    "one",
                );
            }
        }
    }
}

fn to_middle(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for (part, link) in links(of) {
        if value(&link.element_type) != Some(ElementType::Road) || !is_into_middle(link) {
            continue;
        }
        if link.element_s.is_none() {
            sink.add_within(part, link.span, "elementS together with elementDir", "none");
        }
        if link.element_dir.is_none() {
            sink.add_within(part, link.span, "elementDir beside elementS", "none");
        }
        if link.contact_point.is_some() {
            sink.add_within(part, link.span, "either a contact point or a place", "both");
        }
    }
}
