//! Connections and priorities.

use super::kind;
use crate::cycles::on_cycles;
use crate::example::Example::Junction as In;
use crate::place::text;
use crate::rule::Check::Junction;
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::{self as xodr, JunctionType as Kind, Span};
use std::collections::BTreeSet;

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:junctions.connection.one_connection_element",
        "A road within a junction has one connection.",
        Junction(one_per_road),
        [
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><connection id="1" incomingRoad="3" connectingRoad="2" contactPoint="end"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    )
    .since(7)
    .until(7),
    Rule::warning(
        "mapd:xodr:1.4.0:junction.connection_ids",
        "The connections of a junction have different ids.",
        Junction(ids),
        [
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><connection id="0" incomingRoad="3" connectingRoad="2" contactPoint="end"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.4.0:junction.connection_roads",
        "A connection names the incoming road, the connecting road, and the contact point on the latter.",
        Junction(roads),
        [
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.priority.high_and_low_attr",
        "A priority names the road that has priority and the road that yields.",
        Junction(priority),
        [
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><priority high="1" low="3"/></junction>"#),
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><priority high="1"/></junction>"#),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.4.0:topology.priority_cycle",
        "No road yields to itself through others.",
        Junction(priority_cycle),
        [
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><priority high="1" low="3"/></junction>"#),
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><priority high="1" low="3"/><priority high="3" low="1"/></junction>"#),
        ],
    ),
];

/// Shows every element whose key another had before.
fn repeated<'a, K: Ord>(
    elements: impl Iterator<Item = (Option<K>, Span, &'a str)>,
    mut show: impl FnMut(Span, &'a str),
) {
    let mut seen = BTreeSet::new();
    for (key, span, name) in elements {
        if let Some(key) = key
            && !seen.insert(key)
        {
            show(span, name);
        }
    }
}

fn one_per_road(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    let roads = junction.connection.iter().map(|c| {
        (c.connecting_road.as_ref().map(|id| &id.value), c.span, text(&c.connecting_road))
    });
    repeated(roads, |span, road| {
        let found = format_args!("another of road {road}");
        sink.add_within("connection", span, "one connection of a road within the junction", found);
    });
}

fn ids(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    let ids = junction
        .connection
        .iter()
        .map(|c| (c.id.as_ref().map(|id| &id.value), c.span, text(&c.id)));
    repeated(ids, |span, id| {
        sink.add_within("connection", span, "an id that no other connection has", id);
    });
}

fn roads(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    let is_virtual = kind(junction) == Kind::Virtual;
    for c in &junction.connection {
        let entered =
            if kind(junction) == Kind::Direct { &c.linked_road } else { &c.connecting_road };
        for (name, is_there) in [
            ("@incomingRoad", c.incoming_road.is_some() || is_virtual),
            ("@connectingRoad or @linkedRoad", entered.is_some() || is_virtual),
            ("@contactPoint", c.contact_point.is_some() || is_virtual),
        ] {
            if !is_there {
                sink.add_within("connection", c.span, name, "none; no way leads through it");
            }
        }
    }
}

fn priority(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    for priority in &junction.priority {
        if priority.high.is_none() || priority.low.is_none() {
            sink.add_within("priority", priority.span, "both high and low", "not both");
        }
    }
}

/// Of a cycle, its first priority in the file is told.
fn priority_cycle(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    let of_two = |priority: &&xodr::Priority| priority.high.is_some() && priority.low.is_some();
    let stated: Vec<&xodr::Priority> = junction.priority.iter().filter(of_two).collect();
    let pairs: Vec<(&str, &str)> =
        stated.iter().map(|priority| (text(&priority.high), text(&priority.low))).collect();
    let first = on_cycles(&pairs).into_iter().zip(&pairs).position(|(is_on_one, (high, _))| {
        // An empty id is told elsewhere.
        is_on_one && !high.is_empty()
    });
    if let Some((priority, (high, low))) =
        first.and_then(|at| Some((stated.get(at)?, pairs.get(at)?)))
    {
        let found = format_args!("road {high} above road {low} and below it");
        sink.add_within("priority", priority.span, "an order of roads", found);
    }
}
