//! What junctions of each kind have.

use super::kind;
use crate::example::Example::Junction as In;
use crate::place::{text, value};
use crate::rule::Check::Junction;
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::{self as xodr, ConnectionType, JunctionType as Kind, Severity};
use std::collections::BTreeSet;

const SOUND: crate::example::Example = In(
    r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#,
);

pub(super) static RULES: &[Rule] = &[
    Rule::error(
        "asam.net:xodr:1.7.0:junctions.type_default_no_linked_road",
        [
            "Only connections of direct junctions name a linked road.",
            "a connection with a connecting and a linked road is ambiguous; one with only a linked road is used (warning)",
        ],
        Junction(linked_road),
        [
            SOUND,
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" linkedRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    )
    .also(&["asam.net:xodr:1.7.0:junctions.direct.correct_type_linked_road_usage"]),
    Rule::error(
        "asam.net:xodr:1.7.0:junctions.type_direct_no_conn_road",
        [
            "Connections of direct junctions name no connecting road.",
            "a connection with a connecting and a linked road is ambiguous; one with only a connecting road is used (warning)",
        ],
        Junction(connecting_road),
        [
            SOUND,
            In(r#"<junction id="9" name="" type="direct"><connection id="0" incomingRoad="1" connectingRoad="2" linkedRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    )
    .also(&[
        "asam.net:xodr:1.9.0:junctions.connection.no_connecting_road_direct",
        "asam.net:xodr:1.7.0:junctions.direct.connecting_road_attribute_usage",
    ]),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.common.direct_junction_attributes",
        "Only direct junctions have zones where lanes overlap.",
        Junction(overlap_zone),
        [
            SOUND,
            In(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1" overlapZone="20"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.5.0:junctions.common.virtual_junction_attributes",
        "Only virtual junctions have a main road, a range on it and an orientation.",
        Junction(virtual_attributes),
        [
            SOUND,
            In(r#"<junction id="9" name="" mainRoad="1" sStart="1" sEnd="2" orientation="none"><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:junctions.virtual.no_controllers",
        "Virtual junctions have no controllers.",
        Junction(controllers),
        [
            SOUND,
            In(r#"<junction id="9" name="" type="virtual" mainRoad="1" sStart="1" sEnd="2" orientation="none"><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><controller id="5"/></junction><controller id="5"><control signalId="1"/></controller>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:junctions.virtual.connections.only_virtual_junctions",
        "Only virtual junctions have connections of the type virtual.",
        Junction(virtual_connections),
        [
            SOUND,
            In(r#"<junction id="9" name=""><connection id="0" type="virtual" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.crossing.only_road_sections",
        "Crossings have stretches of roads and no connections.",
        Junction(crossing),
        [
            SOUND,
            In(r#"<junction id="9" name="" type="crossing"><roadSection id="0" roadId="1" sStart="1" sEnd="2"/><roadSection id="1" roadId="3" sStart="1" sEnd="2"/><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    )
    .since(8),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.boundary.only_for_common_junctions",
        "Only default junctions have a boundary.",
        Junction(boundary),
        [
            SOUND,
            In(r#"<junction id="9" name="" type="direct"><connection id="0" incomingRoad="1" linkedRoad="3" contactPoint="start"><laneLink from="-1" to="-1"/></connection><boundary><segment type="lane" roadId="1" boundaryLane="-1" sStart="start" sEnd="end"/></boundary></junction>"#),
        ],
    )
    .since(8),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.direct.road_connectivity",
        "A direct junction joins one road on one side with two or more on the other.",
        Junction(one_to_many),
        [
            SOUND,
            In(r#"<junction id="9" name="" type="direct"><connection id="0" incomingRoad="1" linkedRoad="3" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.direct.overlap_zone_exclusivity",
        "Links of a direct junction that have a zone where lanes overlap share a lane.",
        Junction(one_zone),
        [
            SOUND,
            In(r#"<junction id="9" name="" type="direct"><connection id="0" incomingRoad="1" linkedRoad="3" contactPoint="start"><laneLink from="-1" to="-1" overlapZone="20"/><laneLink from="-2" to="-2" overlapZone="20"/></connection></junction>"#),
        ],
    ),
];

/// An error where it is open which road is entered; where one alone is named, that is it.
fn open(connection: &xodr::Connection) -> Severity {
    match connection.linked_road.is_some() && connection.connecting_road.is_some() {
        true => Severity::Error,
        false => Severity::Warning,
    }
}

fn linked_road(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    if kind(junction) == Kind::Direct {
        return;
    }
    for connection in junction.connection.iter().filter(|c| c.linked_road.is_some()) {
        let kind = kind(junction).name();
        let found = format_args!("one in a junction of the kind {kind}");
        let severity = open(connection);
        sink.add_milder(severity, "connection", connection.span, "no @linkedRoad", found);
    }
}

fn connecting_road(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    if kind(junction) != Kind::Direct {
        return;
    }
    for connection in junction.connection.iter().filter(|c| c.connecting_road.is_some()) {
        let expected = "no @connectingRoad in a direct junction";
        sink.add_milder(open(connection), "connection", connection.span, expected, "one");
    }
}

fn overlap_zone(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    if kind(junction) == Kind::Direct {
        return;
    }
    let links = junction.connection.iter().flat_map(|connection| &connection.lane_link);
    for link in links.filter(|link| link.overlap_zone.is_some()) {
        let kind = kind(junction).name();
        let found = format_args!("one in a junction of the kind {kind}");
        sink.add_within("connection/laneLink", link.span, "no @overlapZone", found);
    }
}

fn virtual_attributes(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    if kind(junction) == Kind::Virtual {
        return;
    }
    for (name, given) in [
        ("mainRoad", junction.main_road.is_some()),
        ("sStart", junction.s_start.is_some()),
        ("sEnd", junction.s_end.is_some()),
        ("orientation", junction.orientation.is_some()),
    ] {
        if given {
            let kind = kind(junction).name();
            let found = format_args!("one in a junction of the kind {kind}");
            sink.add(junction.span, format_args!("no @{name}"), found);
        }
    }
}

fn controllers(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    if kind(junction) == Kind::Virtual
        && let Some(controller) = junction.controller.first()
    {
        sink.add_within(
            "controller",
            controller.span,
            "no controller of a virtual junction",
            "one",
        );
    }
}

fn virtual_connections(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    if kind(junction) == Kind::Virtual {
        return;
    }
    for connection in &junction.connection {
        if connection.r#type.is_some_and(|kind| kind.value == ConnectionType::Virtual) {
            let kind = kind(junction).name();
            let found = format_args!("one in a junction of the kind {kind}");
            sink.add_within("connection", connection.span, "no virtual connection", found);
        }
    }
}

fn crossing(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    if kind(junction) == Kind::Crossing {
        if let Some(connection) = junction.connection.first() {
            sink.add_within("connection", connection.span, "no connection in a crossing", "one");
        }
    } else if let Some(section) = junction.road_section.first() {
        sink.add_within(
            "roadSection",
            section.span,
            "stretches of roads in crossings alone",
            "one",
        );
    }
}

fn boundary(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    if let Some(boundary) = junction.boundary.as_ref().filter(|_| kind(junction) != Kind::Default) {
        let kind = kind(junction).name();
        let found = format_args!("one in a junction of the kind {kind}");
        sink.add_within("boundary", boundary.span, "no boundary", found);
    }
}

fn one_to_many(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    if kind(junction) != Kind::Direct || junction.connection.is_empty() {
        return;
    }
    let pairs = junction.connection.iter().map(|c| [text(&c.incoming_road), text(&c.linked_road)]);
    // A pair may be written in both directions, each time with some of its lanes.
    let is_split = pairs.clone().next().into_iter().flatten().any(|one| {
        let others = pairs.clone().map(|[a, b]| match (a == one, b == one) {
            (true, _) => Some(b),
            (_, true) => Some(a),
            _ => None,
        });
        others.collect::<Option<BTreeSet<&str>>>().is_some_and(|others| others.len() >= 2)
    });
    if !is_split {
        let [incoming, linked] =
            [0, 1].map(|side| pairs.clone().map(|pair| pair[side]).collect::<BTreeSet<_>>().len());
        let found = format_args!("{incoming} and {linked}");
        sink.add(junction.span, "one road on one side and two or more on the other", found);
    }
}

fn one_zone(junction: &xodr::Junction, sink: &mut Sink<'_>) {
    if kind(junction) != Kind::Direct {
        return;
    }
    // Road and lane on both sides of each link with a zone.
    let links = junction.connection.iter().flat_map(|connection| {
        let [from, to] = [&connection.incoming_road, &connection.linked_road].map(text);
        connection
            .lane_link
            .iter()
            .filter(|link| link.overlap_zone.is_some())
            .map(move |link| (link.span, [(from, value(&link.from)), (to, value(&link.to))]))
    });
    let mut shared: Option<Vec<_>> = None;
    for (span, lanes) in links {
        match &mut shared {
            None => shared = Some(lanes.to_vec()),
            Some(shared) => {
                shared.retain(|lane| lanes.contains(lane));
                if shared.is_empty() {
                    let expected = "zones where lanes overlap at links of one lane";
                    let found = "one at a link of others";
                    sink.add_within("connection/laneLink", span, expected, found);
                    return;
                }
            }
        }
    }
}
