//! Paths across the roads of a junction.

use crate::catalog::junctions::kind;
use crate::example::Example::Document;
use crate::network::{Contact, Foot, Network, RoadFacts};
use crate::place::{number, text, value};
use crate::rule::Check::Network as All;
use crate::rule::{Rule, Tolerance};
use crate::sink::{PartOf, Sink};
use mapd_xodr::{CrossPath, CrossPathLaneLink, Junction, JunctionType as Kind, LaneType};

/// How far the end of a path may be outside of its lane.
const OUTSIDE: Tolerance = Tolerance { name: "reach outside of the lane", value: 0.1, unit: "m" };
/// How far a path may be outside of its junction.
const AREA: Tolerance = Tolerance { name: "reach outside of the junction", value: 1.0, unit: "m" };

/// A main road with sidewalks, a virtual junction, and a path across: its junction, where it begins, how long it is, the lane
/// at its start.
macro_rules! path {
    ($junction:literal, $y:literal, $length:literal, $lane:literal) => {
        Document(concat!(
            r#"<road id="1" length="100" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView><lanes><laneSection s="0"><left><lane id="2" type="walking"><width sOffset="0" a="2" b="0" c="0" d="0"/></lane><lane id="1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane><lane id="-2" type="walking"><width sOffset="0" a="2" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length=""#, $length, r#"" junction=""#, $junction, r#""><planView><geometry s="0" x="50" y=""#, $y, r#"" hdg="1.5707963267948966" length=""#, $length, r#""><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="walking"><width sOffset="0" a="2" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<junction id="9" name="" type="virtual" mainRoad="1" sStart="45" sEnd="55" orientation="none"><crossPath id="5" crossingRoad="2" roadAtStart="1" roadAtEnd="1"><startLaneLink s="50" from=""#, $lane, r#"" to="-1"/><endLaneLink s="50" from="2" to="-1"/></crossPath></junction>"#
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.cross_path.correct_junction_id",
        "The road of a path names the junction that it crosses.",
        All(junction_id),
        [path!("9", "-4", "8", "-2"), path!("-1", "-4", "8", "-2")],
    )
    .since(8),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.cross_path.only_connect_correct_type",
        "A path joins lanes for walking or biking.",
        All(lane_types),
        [path!("9", "-4", "8", "-2"), path!("9", "-2", "6", "-1")],
    )
    .since(8),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.cross_path.lane_linkage",
        "A path links lanes that are there.",
        All(lanes_there),
        [path!("9", "-4", "8", "-2"), path!("9", "-4", "8", "-7")],
    )
    .since(8),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.cross_path.start_end_contained",
        "A path begins and ends within the lanes that it links.",
        All(contained),
        [path!("9", "-4", "8", "-2"), path!("9", "-2", "6", "-2")],
    )
    .within(&[OUTSIDE])
    .since(8),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.virtual.crossPath.cross_road_check_s_t",
        "A path across a main road stays within its sides.",
        All(within_main_road),
        [path!("9", "-4", "8", "-2"), path!("9", "-4", "30", "-2")],
    )
    .within(&[AREA])
    .since(8),
    Rule::warning(
        "asam.net:xodr:1.8.0:junctions.cross_path.within_junction_area",
        "A path stays within the box of its junction's roads.",
        All(within_junction),
        [
            path!("9", "-4", "8", "-2"),
            Document(r#"<road id="1" length="50" junction="-1"><link><successor elementType="junction" elementId="9"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="walking"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="20" junction="9"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="20"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="4" length="20" junction="9"><planView><geometry s="0" x="200" y="0" hdg="0" length="20"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="walking"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection><crossPath id="5" crossingRoad="4" roadAtStart="1" roadAtEnd="1"><startLaneLink s="50" from="-1" to="-1"/><endLaneLink s="50" from="-1" to="-1"/></crossPath></junction>"#),
        ],
    )
    .within(&[AREA])
    .since(8),
];

/// An end of a path: the end of its road, the road that it touches and its link.
struct End<'a> {
    junction: &'a Junction,
    path: &'a CrossPath,
    contact: Contact,
    touched: Option<&'a RoadFacts>,
    link: &'a CrossPathLaneLink,
}

fn paths(network: &Network) -> impl Iterator<Item = (&Junction, &CrossPath)> {
    network
        .junctions_as_written()
        .flat_map(|junction| junction.cross_path.iter().map(move |path| (junction, path)))
}

fn ends(network: &Network) -> impl Iterator<Item = End<'_>> {
    paths(network).flat_map(move |(junction, path)| {
        let ends = [
            (Contact::Start, &path.road_at_start, &path.start_lane_link),
            (Contact::End, &path.road_at_end, &path.end_lane_link),
        ];
        ends.into_iter().filter_map(move |(contact, road, link)| {
            let touched = network.road(text(road));
            Some(End { junction, path, contact, touched, link: link.as_deref()? })
        })
    })
}

fn add(
    junction: &Junction,
    path: &CrossPath,
    sink: &mut Sink<'_>,
    expected: impl std::fmt::Display,
    found: impl std::fmt::Display,
) {
    let part = format!("crossPath[@id={}]", text(&path.id));
    sink.add_in(PartOf::junction(text(&junction.id), &part), path.span, expected, found);
}

fn junction_id(network: &Network, sink: &mut Sink<'_>) {
    for (junction, path) in paths(network) {
        let Some(road) = network.road(text(&path.crossing_road)) else { continue };
        let id = text(&junction.id);
        let own = road.junction.map(|junction| network.name(junction));
        if own != Some(id) {
            let expected = format_args!("road {} of junction {id}", network.name(road.id));
            add(junction, path, sink, expected, own.unwrap_or("none"));
        }
    }
}

fn lane_types(network: &Network, sink: &mut Sink<'_>) {
    for end in ends(network) {
        let (Some(road), Some(from)) = (end.touched, value(&end.link.from)) else { continue };
        let section = network.section_over(road, number(&end.link.s), from);
        let Some(lane) = section.and_then(|section| network.lane(section, from)) else { continue };
        if !matches!(
            lane.kind,
            LaneType::Walking | LaneType::Biking | LaneType::Sidewalk | LaneType::Shared
        ) {
            let road = network.name(road.id);
            let found = format_args!("lane {from} of road {road}, for {}", lane.kind.name());
            add(end.junction, end.path, sink, "a lane for walking or biking", found);
        }
    }
}

fn lanes_there(network: &Network, sink: &mut Sink<'_>) {
    for end in ends(network) {
        let crossing = network.road(text(&end.path.crossing_road));
        let (from, to) = (value(&end.link.from), value(&end.link.to));
        let touched = end.touched.zip(from).and_then(|(road, id)| {
            Some((road, network.section_over(road, number(&end.link.s), id)?, id))
        });
        let own = crossing
            .zip(to)
            .and_then(|(road, id)| Some((road, network.section_at(road, end.contact, id)?, id)));
        for (road, section, id) in [touched, own].into_iter().flatten() {
            if network.lane(section, id).is_none() && id != 0 {
                let name = network.name(road.id);
                let expected = format_args!("a lane of road {name}");
                add(
                    end.junction,
                    end.path,
                    sink,
                    expected,
                    format_args!("lane {id}, which does not exist"),
                );
            }
        }
    }
}

fn contained(network: &Network, sink: &mut Sink<'_>) {
    for end in ends(network) {
        let Some(crossing) = network.road(text(&end.path.crossing_road)) else { continue };
        let (Some(road), Some(from)) = (end.touched, value(&end.link.from)) else { continue };
        let Some(station) = network.station_of(crossing, end.contact) else { continue };
        let Some(Foot { s, t, .. }) = network.project(road, [station.x, station.y]) else {
            continue;
        };
        let section = network.section_over(road, number(&end.link.s), from);
        let Some((section, lane)) =
            section.and_then(|section| Some((section, network.lane(section, from)?)))
        else {
            continue;
        };
        let [inner, outer] = Network::borders_over(section, lane, s);
        let (low, high) = (inner.min(outer) - OUTSIDE.value, inner.max(outer) + OUTSIDE.value);
        if t < low || t > high {
            let expected = format_args!(
                "an end within lane {from} of road {}, t from {low:.2} to {high:.2}",
                network.name(road.id)
            );
            add(end.junction, end.path, sink, expected, format_args!("{t:.2}"));
        }
    }
}

fn within_main_road(network: &Network, sink: &mut Sink<'_>) {
    for (junction, path) in paths(network).filter(|(junction, _)| kind(junction) == Kind::Virtual) {
        let (Some(main), Some(crossing)) =
            (network.road(text(&junction.main_road)), network.road(text(&path.crossing_road)))
        else {
            continue;
        };
        for station in network.stations_of(crossing).iter() {
            let Some(Foot { s, t, .. }) = network.project(main, [station.x, station.y]) else {
                continue;
            };
            let Some(across) = network.station_at(main, s) else { continue };
            if t > across.left + AREA.value || t < across.right - AREA.value {
                let expected = format_args!(
                    "t from {:.2} to {:.2} on road {}",
                    across.right,
                    across.left,
                    network.name(main.id)
                );
                add(junction, path, sink, expected, format_args!("{t:.2}"));
                break;
            }
        }
    }
}

fn within_junction(network: &Network, sink: &mut Sink<'_>) {
    for (junction, path) in paths(network).filter(|(junction, _)| kind(junction) == Kind::Default) {
        let Some(crossing) = network.road(text(&path.crossing_road)) else { continue };
        let mut area = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
        let paths = junction.cross_path.iter();
        let crossings: Vec<_> =
            paths.filter_map(|path| network.name_of(text(&path.crossing_road))).collect();
        let within = network.name_of(text(&junction.id)).into_iter();
        let within = within.flat_map(|junction| network.roads_within(junction));
        for road in within.filter(|road| !crossings.contains(&road.id)) {
            let b = road.bounds;
            area = [area[0].min(b[0]), area[1].min(b[1]), area[2].max(b[2]), area[3].max(b[3])];
        }
        let reach = AREA.value;
        let is_outside = |s: &crate::network::Station| {
            s.x < area[0] - reach
                || s.y < area[1] - reach
                || s.x > area[2] + reach
                || s.y > area[3] + reach
        };
        if area[0] <= area[2]
            && let Some(station) = network.stations_of(crossing).iter().find(is_outside)
        {
            let found = format_args!("it at ({:.2}, {:.2})", station.x, station.y);
            add(junction, path, sink, "a path within the junction", found);
        }
    }
}
