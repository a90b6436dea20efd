//! The document: header, place on Earth, what was left out, data without a table of its own.

use super::at;
use super::line::{Fine, Lines};
use mapd_client::Map;
use mapd_query::Bounds;
use mapd_query::document::HeaderOffset;

pub(super) fn facts(map: Map<'_>, lines: &mut Lines) {
    header(map, lines);
    left_out(map, lines);
    annotations(map, lines);
}

fn header(map: Map<'_>, lines: &mut Lines) {
    let (revision, Bounds { low, high }) = (map.revision(), map.bounds());
    let HeaderOffset { shift, heading } = map.header_offset();
    lines
        .about("map")
        .with("name", map.name())
        .with("revision", [revision.major, revision.minor])
        .with("origin", map.local_origin())
        .with("low", low)
        .with("high", high)
        .with("roads", map.road_length())
        .with("geo_reference", map.geo_reference())
        .word("form", map.geo_reference_form().name())
        .with("projection", map.projection())
        .with("offset", shift)
        .with("turn", Fine(heading))
        .with("negated", map.offset_is_negated())
        .with("geodetic", map.geodetic_bounds().map(|bounds| bounds.map(Fine)));
    if let Some(frame) = map.file_frame() {
        let (HeaderOffset { shift, heading }, Bounds { low, high }) =
            (frame.offset(), frame.bounds());
        lines
            .about("file frame")
            .with("target", frame.target())
            .with("projection", frame.projection())
            .with("offset", shift)
            .with("turn", Fine(heading))
            .with("low", low)
            .with("high", high)
            .with("height_shift", frame.height_shift())
            .with("error", Fine(frame.error()))
            .with("height_error", Fine(frame.height_error()))
            .with("scale", [Fine(frame.scale_min()), Fine(frame.scale_max())]);
    }
}

fn left_out(map: Map<'_>, lines: &mut Lines) {
    for part in map.quarantined() {
        lines
            .about(format_args!("left out {} {:?}", part.kind().name(), part.id()))
            .word("owner_kind", part.owner_kind().name())
            .with("owner", part.owner())
            .with("reference_line", part.is_reference_line())
            .with("extent", part.extent().map(|region| [region.low, region.high]))
            .with("length", part.length())
            .with("rule", part.rule())
            .with("message", part.message())
            .with("file", part.source_file())
            .word("at", at(part.source_position()));
    }
}

fn annotations(map: Map<'_>, lines: &mut Lines) {
    for file in map.included_files() {
        lines
            .about(format_args!("file {:?}", file.name()))
            .with("by", file.included_by().map(|by| by.name()))
            .word("at", at(file.source_position()));
    }
    for one in map.annotations() {
        lines
            .about(format_args!("annotation {}", one.kind().name()))
            .word("owner", format_args!("{:?}", one.owner_kind().name()))
            .with("path", one.path())
            .with("name", one.name())
            .with("value", one.value())
            .with("text", one.text())
            .word("at", at(one.source_position()));
    }
    // By owner: how many belong to each.
    lines.about("annotations of document").with("count", map.document_annotations().len());
    for road in map.roads().filter(|road| road.annotations().len() > 0) {
        let names: Vec<_> = road.annotations().map(|one| one.name()).collect();
        lines.about(format_args!("annotations of road {}", road.id())).with("names", names);
    }
    for lane in map.lanes().filter(|lane| lane.annotations().len() > 0) {
        let names: Vec<_> = lane.annotations().map(|one| one.name()).collect();
        lines.about(format_args!("annotations of lane {}", lane.key())).with("names", names);
    }
}
