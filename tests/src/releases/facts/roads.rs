//! Roads: courses, heights, surfaces, links; junctions and their groups.

use super::line::{Fine, Lines};
use super::{at, key, keys, road_id, stations};
use mapd_client::{Map, Track};
use mapd_query::roads::RoadLink;
use mapd_query::{Junction, LaneSection, Road};

/// Lateral places at which a road's surface is asked about \[m\].
const LATERAL: [f64; 5] = [-6.0, -2.0, 0.0, 2.0, 6.0];

pub(super) fn facts(map: Map<'_>, lines: &mut Lines) {
    for road in map.roads() {
        of_road(map, road, lines);
        course(map, road, lines);
        for structure in road.structures() {
            lines
                .about(format_args!("structure {} {:?}", structure.kind().name(), structure.id()))
                .with("road", road_id(structure.road()))
                .with("name", structure.name())
                .with("type", structure.type_name())
                .with("s", structure.s_range())
                .with("lanes", structure.validities().collect::<Vec<_>>())
                .with("light", [structure.lighting(), structure.daylight()])
                .word("at", at(structure.source_position()));
        }
    }
    for junction in map.junctions() {
        of_junction(map, junction, lines);
    }
    in_tables(map, lines);
    for group in map.junction_groups() {
        let members = group.members();
        let members = members.map(|one| (one.id(), one.junction().map(|junction| junction.id())));
        let (ids, found): (Vec<_>, Vec<_>) = members.unzip();
        lines
            .about(format_args!("junction group {:?}", group.id()))
            .with("name", group.name())
            .word("kind", group.kind().name())
            .with("members", ids)
            .with("junctions", found)
            .with("ring", group.ring().map(|lane| key(map, lane)).collect::<Vec<_>>())
            .word("at", at(group.source_position()));
    }
}

fn link(link: Option<RoadLink<'_>>) -> String {
    match link {
        Some(RoadLink::Road(road, end)) => format!("road {} {}", road.id(), end.name()),
        Some(RoadLink::Junction(junction)) => format!("junction {}", junction.id()),
        Some(RoadLink::Unresolved) => "unresolved".to_owned(),
        None => "-".to_owned(),
    }
}

fn of_road(map: Map<'_>, road: Road<'_>, lines: &mut Lines) {
    lines
        .about(format_args!("road {:?}", road.id()))
        .with("name", road.name())
        .with("by_id", road_id(map.road_by_id(road.id())))
        .with("length", road.length())
        .with("end", road.reference_end())
        .with("junction", road.junction().map(|junction| junction.id()))
        .with("from", link(road.predecessor()))
        .with("to", link(road.successor()))
        .with("left_hand", road.is_left_hand_traffic())
        .with("breaks", road.shape_breaks().collect::<Vec<_>>())
        .word("at", at(road.source_position()));
    for record in road.types() {
        lines
            .about(format_args!("type {}", record.kind.name()))
            .with("s", record.s)
            .word("limit", record.speed_kind.name())
            .with("speed", record.speed)
            .with("country", record.country.and_then(|number| map.country(number)));
    }
    for section in road.sections() {
        of_section("section", section, lines);
    }
    for section in road.temporary_sections() {
        of_section("temporary section", section, lines);
    }
}

fn of_section(what: &str, section: LaneSection<'_>, lines: &mut Lines) {
    lines
        .about(format_args!("{what} {}", section.number()))
        .with("road", road_id(section.road()))
        .with("s", [section.s_start(), section.s_end()])
        .with("lanes", keys(section.lanes()));
}

fn course(map: Map<'_>, road: Road<'_>, lines: &mut Lines) {
    for s in stations(0.0, road.length()) {
        let line = lines
            .about(format_args!("course {s:.3}"))
            .with("elevation", road.elevation_at(s))
            .with("superelevation", Fine(road.superelevation_at(s)))
            .with("lane_offset", road.lane_offset_at(s));
        if let Ok(pose) = road.to_inertial(Track { s, t: 1.5, h: 0.5 }) {
            let angles = [pose.heading, pose.curvature, pose.slope, pose.superelevation];
            let line = line.with("place", pose.position).with("angles", angles.map(Fine));
            if let Ok(back) = road.to_track(pose.position) {
                line.with("s", back.s)
                    .with("t", back.t)
                    .with("h", back.h)
                    .with("clamped", back.clamped);
            }
        }
        for t in LATERAL {
            let Ok(surface) = road.surface_at(s, t) else { continue };
            lines
                .about(format_args!("surface {s:.3} {t:.3}"))
                .with("lane", surface.lane.map(|lane| key(map, lane)))
                .with("place", surface.position)
                .with("normal", surface.normal.to_array().map(Fine))
                .with("material", surface.material.map(|material| material.surface));
        }
    }
}

/// What no query tells, but who reads the tables.
fn in_tables(map: Map<'_>, lines: &mut Lines) {
    let tables = map.tables();
    let road = |row: u32| map.roads().find(|road| road.road_id().row() == row);
    let junction = |row: u32| map.junctions().find(|one| one.junction_id().row() == row);
    for row in tables.junction_priorities {
        lines
            .about("priority")
            .with("junction", junction(row.junction()).map(|junction| junction.id()))
            .with("roads", [road_id(road(row.high())), road_id(road(row.low()))]);
    }
    for row in tables.junctions {
        lines.about("junction as written").with("kind", row.kind()).with("line", row.line());
    }
}

fn of_junction(map: Map<'_>, junction: Junction<'_>, lines: &mut Lines) {
    lines
        .about(format_args!("junction {:?}", junction.id()))
        .with("name", junction.name())
        .with("by_id", map.junction_by_id(junction.id()).map(|junction| junction.id()))
        .with("grid", junction.grid_stations().collect::<Vec<_>>())
        .with("groups", junction.groups().map(|group| group.id()).collect::<Vec<_>>())
        .with("objects", junction.objects().map(|object| object.id()).collect::<Vec<_>>());
    for connection in junction.connections() {
        lines
            .about(format_args!("connection {:?}", connection.id()))
            .with("from", road_id(connection.incoming_road()))
            .with("over", road_id(connection.connecting_road()))
            .word("end", connection.contact_point().name())
            .with("lanes", connection.lane_links().map(|l| [l.from, l.to]).collect::<Vec<_>>());
    }
    for one in junction.controllers() {
        lines
            .about(format_args!("controller of junction {:?}", one.id()))
            .with("controller", one.controller().map(|controller| controller.id()))
            .with("sequence", one.sequence());
    }
}
