//! Rules that need no entry in the catalog: what the schema says already, what reading does, and what is left out.

use crate::example::Example::{
    self, Document, Header, Junction, Lanes, Objects, PlanView, Road, Signals,
};
use mapd_xodr::rule_ids as ids;

/// Rules for which a finding of the schema's stands.
pub struct Structural {
    /// ASAM's ids, or ours.
    pub ids: &'static [&'static str],
    /// Id of the finding that stands for them.
    pub by: &'static str,
    /// The attribute or child that the finding is about; empty for any.
    pub subject: &'static str,
    /// What breaks them, in OpenDRIVE 1.8.
    pub invalid: Example,
}

const fn entry(
    ids: &'static [&'static str],
    by: &'static str,
    subject: &'static str,
    invalid: Example,
) -> Structural {
    Structural { ids, by, subject, invalid }
}

/// What the schema says already.
pub static STRUCTURAL: &[Structural] = &[
    entry(
        &["asam.net:xodr:1.0.0:xml.valid_xml_document"],
        ids::XML,
        "",
        Example::File(r#"<OpenDRIVE><header revMajor="1" revMinor="8"></OpenDRIVE>"#),
    ),
    entry(
        &["asam.net:xodr:1.0.0:xml.valid_schema"],
        ids::UNKNOWN_ELEMENT,
        "",
        Document("<street/>"),
    ),
    entry(
        &["mapd:xodr:1.4.0:xml.namespace"],
        ids::NAMESPACE,
        "",
        Example::File(
            r#"<OpenDRIVE xmlns="urn:another"><header revMajor="1" revMinor="8"/></OpenDRIVE>"#,
        ),
    ),
    entry(
        &["mapd:xodr:1.4.0:xml.include_cycle"],
        ids::INCLUDE,
        "",
        Document(r#"<include file="../beside.xodr"/>"#),
    ),
    entry(
        &["mapd:xodr:1.4.0:xml.finite_numbers"],
        ids::FINITE,
        "",
        PlanView(r#"<geometry s="0" x="INF" y="0" hdg="0" length="100"><line/></geometry>"#),
    ),
    entry(
        &["asam.net:xodr:1.9.0:header.proj.max_one_proj"],
        ids::OCCURRENCE,
        "geoReference",
        Header("<geoReference>a</geoReference><geoReference>b</geoReference>"),
    ),
    entry(
        &["asam.net:xodr:1.4.0:junctions.common.junctions_no_pred_succ"],
        ids::UNKNOWN_ELEMENT,
        "",
        Junction(
            r#"<junction id="9" name=""><predecessor elementType="road" elementId="1"/></junction>"#,
        ),
    ),
    entry(
        &["asam.net:xodr:1.8.0:junctions.elevation_grid.only_one_elev_grid"],
        ids::OCCURRENCE,
        "elevationGrid",
        Junction(
            r#"<junction id="9" name=""><elevationGrid sStart="0" gridSpacing="5"/><elevationGrid sStart="0" gridSpacing="5"/></junction>"#,
        ),
    ),
    entry(
        &["asam.net:xodr:1.9.0:junctions.virtual.only_one_start_end"],
        ids::XML,
        "",
        Junction(
            r#"<junction id="9" name="" type="virtual" mainRoad="1" sStart="1" sStart="2" sEnd="3" orientation="none"/>"#,
        ),
    ),
    entry(
        &["asam.net:xodr:1.4.0:road.geometry.one_geom_elem_per_spec"],
        ids::CHOICE,
        "",
        PlanView(
            r#"<geometry s="0" x="0" y="0" hdg="0" length="100"><line/><arc curvature="0.1"/></geometry>"#,
        ),
    ),
    entry(
        &["asam.net:xodr:1.4.0:road.geometry.only_one_refline"],
        ids::OCCURRENCE,
        "planView",
        Road(
            r#"<planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView><planView/>"#,
        ),
    ),
    entry(
        &["asam.net:xodr:1.4.0:road.geometry.refline_exists"],
        ids::ELEMENT,
        "geometry",
        PlanView(""),
    ),
    entry(
        &[
            "asam.net:xodr:1.4.0:road.lane.lane_sect_min_amount",
            "asam.net:xodr:1.4.0:road.lane_section.lane_sect_req",
        ],
        ids::ELEMENT,
        "laneSection",
        Lanes(""),
    ),
    entry(
        &["asam.net:xodr:1.4.0:road.lane.s_attr_value"],
        ids::MISSING,
        "s",
        Lanes(r#"<laneSection><center><lane id="0" type="none"/></center></laneSection>"#),
    ),
    entry(
        &["asam.net:xodr:1.7.0:road.object.s_t_coords"],
        ids::MISSING,
        "t",
        Objects(r#"<object id="1" type="pole" s="10" zOffset="0" orientation="none"/>"#),
    ),
    entry(
        &["asam.net:xodr:1.7.0:road.object.bridges.type_definition"],
        ids::MISSING,
        "type",
        Objects(r#"<bridge id="1" s="10" length="5"/>"#),
    ),
    entry(
        &["asam.net:xodr:1.7.0:road.object.tunnels.type_definition"],
        ids::MISSING,
        "type",
        Objects(r#"<tunnel id="1" s="10" length="5"/>"#),
    ),
    entry(
        &[
            "asam.net:xodr:1.7.0:road.object.marking.colour",
            "asam.net:xodr:1.8.2:road.object.object_marking.colour",
        ],
        ids::MISSING,
        "color",
        Objects(
            r#"<object id="1" type="parkingSpace" s="10" t="4" zOffset="0" orientation="none"><markings><marking side="left" spaceLength="0" lineLength="1" startOffset="0" stopOffset="0"/></markings></object>"#,
        ),
    ),
    entry(
        &[
            "asam.net:xodr:1.8.0:road.object.skeleton.polyline_followed_by_vertex",
            "asam.net:xodr:1.8.0:road.object.skeleton.vertex_local.element_min_amount",
        ],
        ids::OCCURRENCE,
        "vertexLocal",
        Objects(
            r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"><skeleton><polyline id="1"><vertexLocal id="1" u="0" v="0" z="0"/></polyline></skeleton></object>"#,
        ),
    ),
    entry(
        &["asam.net:xodr:1.8.0:road.object.skeleton.vertex_road.element_min_amount"],
        ids::OCCURRENCE,
        "vertexRoad",
        Objects(
            r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"><skeleton><polyline id="1"><vertexRoad id="1" s="10" t="4" dz="0"/></polyline></skeleton></object>"#,
        ),
    ),
    entry(
        &[
            "asam.net:xodr:1.9.0:road.object.skeleton.vertex_local.no_mixing_road_local",
            "asam.net:xodr:1.8.0:road.object.skeleton.vertex_road.polyline_elements",
        ],
        ids::CHOICE,
        "",
        Objects(
            r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"><skeleton><polyline id="1"><vertexRoad id="1" s="10" t="4" dz="0"/><vertexRoad id="2" s="10" t="4" dz="1"/><vertexLocal id="3" u="0" v="0" z="0"/><vertexLocal id="4" u="0" v="0" z="1"/></polyline></skeleton></object>"#,
        ),
    ),
    entry(
        &[
            "asam.net:xodr:1.8.0:road.object.skeleton.vertex_local.vertex_local_elements",
            "asam.net:xodr:1.8.0:road.object.skeleton.vertex_road.no_radius_with_width_length",
        ],
        ids::UNKNOWN_ATTRIBUTE,
        "",
        Objects(
            r#"<object id="1" type="pole" s="10" t="4" zOffset="0" orientation="none"><skeleton><polyline id="1"><vertexLocal id="1" u="0" v="0" z="0" radius="1" width="1" length="1"/><vertexLocal id="2" u="0" v="0" z="1" radius="1"/></polyline></skeleton></object>"#,
        ),
    ),
    entry(
        &["asam.net:xodr:1.7.0:road.object.surface.only_one_crg_file"],
        ids::OCCURRENCE,
        "CRG",
        Objects(
            r#"<object id="1" type="patch" s="10" t="0" zOffset="0" orientation="none" length="2" width="2"><surface><CRG file="a.crg" hideRoadSurfaceCRG="false" zScale="1"/><CRG file="b.crg" hideRoadSurfaceCRG="false" zScale="1"/></surface></object>"#,
        ),
    ),
    entry(
        &[
            "asam.net:xodr:1.7.0:road.railroad.platforms.min_amount",
            "asam.net:xodr:1.7.0:road.railroad.stations.one_platform_per_station",
        ],
        ids::ELEMENT,
        "platform",
        Document(r#"<station name="a" id="1" type="small"/>"#),
    ),
    entry(
        &[
            "asam.net:xodr:1.7.0:road.railroad.platforms.min_segments",
            "asam.net:xodr:1.7.0:road.railroad.segment.segments_per_platform_min_amount",
        ],
        ids::ELEMENT,
        "segment",
        Document(r#"<station name="a" id="1" type="small"><platform id="2" name="b"/></station>"#),
    ),
    entry(
        &["asam.net:xodr:1.7.0:road.signal.signal_type"],
        ids::MISSING,
        "subtype",
        Signals(
            r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" country="DE"/>"#,
        ),
    ),
    entry(
        &["asam.net:xodr:1.7.0:road.signal.reference.specify_direction"],
        ids::MISSING,
        "orientation",
        Signals(r#"<signalReference id="1" s="20" t="0"/>"#),
    ),
];

/// Rules that other rules of the catalog say together, or that what mapd does keeps: id, and what does.
pub static KEPT: &[(&str, &str)] = &[
    (
        "asam.net:xodr:1.4.0:road.lane.lane_properties.elem_asc_order",
        "the rules on the order of each kind of record of a lane",
    ),
    (
        "mapd:xodr:1.4.0:xml.position",
        "every finding has a span; tests of the reader check line and column",
    ),
    ("mapd:xodr:1.4.0:xml.quarantine", "the compiler's verdict"),
    (
        "mapd:xodr:1.4.0:topology.elementtype",
        "the compiler makes links into junctions only from connections",
    ),
    (
        "mapd:xodr:1.4.0:topology.cycle",
        "the lane graph, whose `mapd:graph.no_progress` and `mapd:graph.junction_cycle` name each step of the cycle \
         (graph.md); `mapd:xodr:1.4.0:topology.dependency_cycle`",
    ),
    (
        "mapd:xodr:1.4.0:object.nearest_lane",
        "the compiler, which reports how it found the lanes of an object",
    ),
];

/// Rules that are left out, and why.
pub static LEFT_OUT: &[(&str, &str)] = &[
    (
        "asam.net:xodr:1.8.0:junctions.direct.overlap_zone_coverage",
        "the end of the overlap of a ramp's lanes depends on borders that the text does not define",
    ),
    (
        "asam.net:xodr:1.8.0:junctions.elevation_grid.entry_exit_smoothness",
        "needs the surface of elevation grids, which rules do not have",
    ),
    (
        "asam.net:xodr:1.8.0:junctions.elevation_grid.perpendicular_vectors",
        "the format cannot break it: rows have no direction of their own",
    ),
    (
        "asam.net:xodr:1.9.0:road.object.marking.markings_without_outline",
        "the format cannot break it: markings of an outline are inside the outline",
    ),
    (
        "asam.net:xodr:1.7.0:road.object.surface.object_reference_on_overlap",
        "needs the boxes of all objects with surface data on all roads; no known map has two such roads",
    ),
];
