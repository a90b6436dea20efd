//! Objects: places, outlines, copies, lanes, markings; railways.

use super::line::{Fine, Lines};
use super::{at, road_id};
use mapd_client::Map;
use mapd_query::objects::{Object, ObjectPlacement};

pub(super) fn facts(map: Map<'_>, lines: &mut Lines) {
    for object in map.objects() {
        of_object(map, object, lines);
        details(object, lines);
        object.placements().for_each(|placement| of_placement(placement, lines));
    }
    for lane in map.lanes() {
        for one in lane.objects() {
            lines
                .about(format_args!("object of lane {}", lane.key()))
                .with("object", one.object().map(|object| object.id()))
                .with("s", one.s_range())
                .word("method", one.method().name())
                .with("distance", one.distance());
        }
    }
    for reference in map.object_references() {
        lines
            .about(format_args!("object reference {:?}", reference.id()))
            .with("object", reference.object().map(|object| object.id()))
            .with("road", road_id(reference.road()))
            .with("place", [reference.s(), reference.t(), reference.z_offset()])
            .with("length", reference.valid_length())
            .word("orientation", reference.orientation().name())
            .with("lanes", reference.validities().collect::<Vec<_>>());
    }
    railways(map, lines);
}

fn of_object(map: Map<'_>, object: Object<'_>, lines: &mut Lines) {
    let flags = [
        object.is_dynamic(),
        object.is_perpendicular(),
        object.is_temporary(),
        object.is_invalidated(),
        object.is_clamped(),
        object.is_repeated(),
    ];
    lines
        .about(format_args!("object {:?}", object.id()))
        .with("name", object.name())
        .with("by_id", map.object_by_id(object.id()).map(|object| object.id()))
        .word("class", object.class().name())
        .with("type", [object.type_name(), object.subtype()])
        .with("road", road_id(object.road()))
        .with("junction", object.junction().map(|junction| junction.id()))
        .with("track", [object.s(), object.t(), object.z_offset()])
        .with("place", object.position())
        .with("on_surface", object.position_on_surface().ok())
        .with("angles", [object.heading(), object.pitch(), object.roll()].map(Fine))
        .with("size", [object.length(), object.width(), object.height(), object.radius()])
        .word("shape", object.shape().name())
        .word("orientation", object.orientation().name())
        .with("valid_length", object.valid_length())
        .with("lanes", object.validities().collect::<Vec<_>>())
        .with("flags", flags)
        .with("value", object.value())
        .with("unit", object.assumed_unit())
        .with("signals", object.signals().map(|signal| signal.id()).collect::<Vec<_>>())
        .word("at", at(object.source_position()));
    for one in object.lanes() {
        lines
            .about("object on lane")
            .with("lane", one.lane().map(|lane| lane.key().to_string()))
            .with("s", one.s_range())
            .word("method", one.method().name())
            .with("distance", one.distance());
    }
}

fn details(object: Object<'_>, lines: &mut Lines) {
    if let Some(space) = object.parking_space() {
        lines.about("parking").with("access", space.access()).with("only", space.restrictions());
    }
    for material in object.materials() {
        lines
            .about(format_args!("object material {:?}", material.surface()))
            .with("color", material.road_mark_color())
            .with("friction", material.friction())
            .with("roughness", material.roughness());
    }
    let template = object.template();
    for marking in template.markings() {
        lines
            .about(format_args!("marking {:?}", marking.kind()))
            .with("outline", marking.outline().map(|outline| outline.id()))
            .with("corners", marking.corners().collect::<Vec<_>>())
            .with("side", marking.side().map(|side| side.name()))
            .with("color", marking.color())
            .with("weight", marking.weight())
            .with("size", [marking.width(), marking.z_offset()])
            .with("stroke", [marking.stroke_length(), marking.gap_length()])
            .with("offsets", [marking.start_offset(), marking.stop_offset()]);
    }
    for border in template.borders() {
        lines
            .about(format_args!("object border {:?}", border.kind()))
            .with("outline", border.outline().map(|outline| outline.id()))
            .with("corners", border.corners().collect::<Vec<_>>())
            .with("width", border.width());
    }
    for skeleton in template.skeletons() {
        let vertices = skeleton.vertices();
        let vertices = vertices.map(|one| (one.position, (one.radius, one.is_on_ground)));
        let (places, rest): (Vec<_>, Vec<_>) = vertices.unzip();
        let (radii, on_ground): (Vec<_>, Vec<_>) = rest.into_iter().unzip();
        lines
            .about("skeleton")
            .with("places", places)
            .with("radii", radii)
            .with("on_ground", on_ground);
    }
}

fn of_placement(placement: ObjectPlacement<'_>, lines: &mut Lines) {
    let size = [placement.length(), placement.width(), placement.height(), placement.radius()];
    let mut footprint = Vec::new();
    placement.footprint(&mut footprint);
    lines
        .about(format_args!("placement {}", placement.item()))
        .with("place", placement.position())
        .with("angles", placement.angles().map(Fine))
        .with("s", placement.s())
        .with("t", placement.t())
        .with("size", size)
        .word("shape", placement.shape().name())
        .with("swept", placement.is_swept())
        .with("footprint", footprint);
    for outline in placement.outlines() {
        lines
            .about("outline")
            .with("id", outline.id())
            .with("outer", outline.is_outer())
            .with("closed", outline.is_closed())
            .word("fill", outline.fill().name())
            .word("lane_type", outline.lane_type().name())
            .with("places", outline.positions().collect::<Vec<_>>())
            .with("heights", outline.heights().collect::<Vec<_>>());
    }
}

fn railways(map: Map<'_>, lines: &mut Lines) {
    for switch in map.switches() {
        let tracks = [switch.main_track(), switch.side_track()];
        lines
            .about(format_args!("switch {:?}", switch.id()))
            .with("name", switch.name())
            .with("road", road_id(switch.road()))
            .with("position", switch.position().map(|position| position.name()))
            .with("tracks", tracks.map(|track| road_id(track.road)))
            .with("s", tracks.map(|track| track.s))
            .with("directions", tracks.map(|track| track.direction.name()))
            .with("partner", switch.partner().map(|partner| partner.id()));
    }
    for station in map.stations() {
        lines
            .about(format_args!("station {:?}", station.id()))
            .with("name", station.name())
            .with("type", station.type_name());
        for platform in station.platforms() {
            lines.about(format_args!("platform {:?}", platform.id())).with("name", platform.name());
            for segment in platform.segments() {
                lines
                    .about("platform segment")
                    .with("road", road_id(segment.road))
                    .with("s", segment.s)
                    .word("side", segment.side.name());
            }
        }
    }
}
