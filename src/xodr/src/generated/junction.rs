//! Elements of `junction`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/junction.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// Where more than two roads meet (`t_junction_common`, `t_junction_crossing`, `t_junction_direct`, `t_junction_virtual`; section 12).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Junction {
    /// The start tag.
    pub span: Span,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@type`: Kind. Since 1.5.
    pub r#type: Option<Attribute<JunctionType>>,
    /// `@mainRoad`: Road that runs through the virtual junction. Required by the text since 1.8. Of variant virtual. Since 1.7.
    pub main_road: Option<Attribute<Box<str>>>,
    /// `@sStart` `[m]`: Where it begins along the reference line. At least 0. Required by the text since 1.8. Of variant virtual. Since 1.7.
    pub s_start: Option<Attribute<f64>>,
    /// `@sEnd` `[m]`: Where it ends along the reference line. At least 0. Required by the text since 1.8. Of variant virtual. Since 1.7.
    pub s_end: Option<Attribute<f64>>,
    /// `@orientation`: Direction of travel that it is for: along s, against s, both. Required by the text since 1.8. Of variant virtual. Since 1.7.
    pub orientation: Option<Attribute<Orientation>>,
    /// `connection`: A way through a junction. Of variant default, direct, virtual.
    pub connection: Vec<Connection>,
    /// `roadSection`: A stretch of road that belongs to a crossing. Since 1.8. Of variant crossing.
    pub road_section: Vec<RoadSection>,
    /// `crossPath`: A path across the roads of a junction. Since 1.8. Of variant default, virtual.
    pub cross_path: Vec<CrossPath>,
    /// `priority`: Which road has priority over which.
    pub priority: Vec<Priority>,
    /// `controller`: A controller of the junction.
    pub controller: Vec<JunctionController>,
    /// `surface`: Surface data of a junction. Since 1.5.
    pub surface: Option<Box<JunctionSurface>>,
    /// `planView`: The reference line in the plane. Since 1.8.
    pub plan_view: Option<Box<PlanView>>,
    /// `objects`: Objects along a road. Since 1.8.
    pub objects: Option<Box<Objects>>,
    /// `boundary`: Closed line around a junction. Since 1.8. Of variant default.
    pub boundary: Option<Box<Boundary>>,
    /// `elevationGrid`: Heights of the junction's area. Since 1.8. Of variant default.
    pub elevation_grid: Option<Box<ElevationGrid>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A way through a junction (`t_junction_connection_common`, `t_junction_connection_direct`, `t_junction_connection_virtual`, `t_junction_connection_virtual_default`; section 12.4).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Connection {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@incomingRoad`: Road that leads into the junction. Required in 1.5.
    pub incoming_road: Option<Attribute<Box<str>>>,
    /// `@contactPoint`: End of the road that touches. Required in 1.5.
    pub contact_point: Option<Attribute<ContactPoint>>,
    /// `@type`: Kind. Of variant virtual, virtual_connection. Since 1.5.
    pub r#type: Option<Attribute<ConnectionType>>,
    /// `@connectingRoad`: Road within the junction. Required in 1.5. Required by the text since 1.8. Of variant default, virtual, virtual_connection.
    pub connecting_road: Option<Attribute<Box<str>>>,
    /// `@linkedRoad`: Road that is entered directly. Required by the text since 1.8. Of variant direct. Since 1.7.
    pub linked_road: Option<Attribute<Box<str>>>,
    /// `@connectionMaster`: Connection that controls this one. In 1.5.
    pub connection_master: Option<Attribute<Box<str>>>,
    /// `laneLink`: Which lane leads into which.
    pub lane_link: Vec<JunctionLaneLink>,
    /// `predecessor`: End of a virtual connection on the main road. Since 1.5. Of variant virtual_connection.
    pub predecessor: Option<Box<ConnectionEnd>>,
    /// `successor`: End of a virtual connection on the main road. Since 1.5. Of variant virtual_connection.
    pub successor: Option<Box<ConnectionEnd>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Which lane leads into which (`t_junction_connection_laneLink`; section 12.4).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JunctionLaneLink {
    /// The start tag.
    pub span: Span,
    /// `@from`: Lane that is left. Required since 1.5.
    pub from: Option<Attribute<i32>>,
    /// `@to`: Lane that is entered. Required since 1.5.
    pub to: Option<Attribute<i32>>,
    /// `@overlapZone` `[m]`: Length over which the lanes overlap. Above 0. Since 1.8.
    pub overlap_zone: Option<Attribute<f64>>,
    /// `@fromLayer`: Layer of the lane that is left. Since 1.9.
    pub from_layer: Option<Attribute<LayerType>>,
    /// `@toLayer`: Layer of the lane that is entered. Since 1.9.
    pub to_layer: Option<Attribute<LayerType>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// End of a virtual connection on the main road (`t_junction_predecessorSuccessor`; section 12; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ConnectionEnd {
    /// The start tag.
    pub span: Span,
    /// `@elementType`: Kind of what is linked. Always road. Required. Deprecated since 1.8.
    pub element_type: Option<Attribute<Box<str>>>,
    /// `@elementId`: Identifier of what is linked. Required. Deprecated since 1.8.
    pub element_id: Option<Attribute<Box<str>>>,
    /// `@elementS` `[m]`: Where the link touches along the linked road. Above 0 1.5 to 1.6. At least 0 since 1.7. Required. Deprecated since 1.8.
    pub element_s: Option<Attribute<f64>>,
    /// `@elementDir`: Direction on the linked road. Required 1.5 to 1.7. Required by the text since 1.8. Deprecated since 1.8.
    pub element_dir: Option<Attribute<ElementDir>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A stretch of road that belongs to a crossing (`t_junction_roadSection`; section 12; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoadSection {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required by the text since 1.8.
    pub id: Option<Attribute<Box<str>>>,
    /// `@roadId`: Road that is meant. Required by the text since 1.8.
    pub road_id: Option<Attribute<Box<str>>>,
    /// `@sStart` `[m]`: Where it begins along the reference line. At least 0. Required by the text since 1.8.
    pub s_start: Option<Attribute<f64>>,
    /// `@sEnd` `[m]`: Where it ends along the reference line. At least 0. Required by the text since 1.8.
    pub s_end: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A path across the roads of a junction (`t_junction_crossPath`; section 12; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CrossPath {
    /// The start tag.
    pub span: Span,
    /// `@crossingRoad`: Road that carries the crossing path. Required by the text since 1.8.
    pub crossing_road: Option<Attribute<Box<str>>>,
    /// `@id`: Identifier, unique among its kind. Required by the text since 1.8.
    pub id: Option<Attribute<Box<str>>>,
    /// `@roadAtEnd`: Road that is crossed at the end. Required by the text since 1.8.
    pub road_at_end: Option<Attribute<Box<str>>>,
    /// `@roadAtStart`: Road that is crossed at the start. Required by the text since 1.8.
    pub road_at_start: Option<Attribute<Box<str>>>,
    /// `startLaneLink`: Where a crossing path meets a road.
    pub start_lane_link: Option<Box<CrossPathLaneLink>>,
    /// `endLaneLink`: Where a crossing path meets a road.
    pub end_lane_link: Option<Box<CrossPathLaneLink>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Where a crossing path meets a road (`t_junction_crossPath_laneLink`; section 12; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CrossPathLaneLink {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Distance along the reference line. At least 0. Required by the text since 1.8.
    pub s: Option<Attribute<f64>>,
    /// `@from`: Lane that is left. Required by the text since 1.8.
    pub from: Option<Attribute<i32>>,
    /// `@to`: Lane that is entered. Required by the text since 1.8.
    pub to: Option<Attribute<i32>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Which road has priority over which (`t_junction_priority`; section 12).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Priority {
    /// The start tag.
    pub span: Span,
    /// `@high`: Road that has priority. Required since 1.8.1.
    pub high: Option<Attribute<Box<str>>>,
    /// `@low`: Road that gives way. Required since 1.8.1.
    pub low: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A controller of the junction (`t_junction_controller`; section 12).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JunctionController {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@type`: Kind.
    pub r#type: Option<Attribute<Box<str>>>,
    /// `@sequence`: Rank in a sequence.
    pub sequence: Option<Attribute<u32>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Closed line around a junction (`t_junction_boundary`; section 12; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Boundary {
    /// The start tag.
    pub span: Span,
    /// `segment`: A piece of the boundary: along a lane, or across a road.
    pub segment: Vec<BoundarySegment>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A piece of the boundary: along a lane, or across a road (`t_junction_boundary_segment_joint`, `t_junction_boundary_segment_lane`; section 12; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BoundarySegment {
    /// The start tag.
    pub span: Span,
    /// `@roadId`: Road that is meant.
    pub road_id: Option<Attribute<Box<str>>>,
    /// `@type`: Kind. Required by the text since 1.8.
    pub r#type: Option<Attribute<SegmentType>>,
    /// `@boundaryLane`: Lane that bounds the junction. Required by the text since 1.8. Of variant lane.
    pub boundary_lane: Option<Attribute<i32>>,
    /// `@sStart` `[m]`: Where it begins along the reference line. Required by the text since 1.8. Of variant lane.
    pub s_start: Option<Attribute<PositionOrEnd>>,
    /// `@sEnd` `[m]`: Where it ends along the reference line. Required by the text since 1.8. Of variant lane.
    pub s_end: Option<Attribute<PositionOrEnd>>,
    /// `@contactPoint`: End of the road that touches. Required by the text since 1.8. Of variant joint.
    pub contact_point: Option<Attribute<PositionOrEnd>>,
    /// `@jointLaneStart`: Lane at which the joint begins. Of variant joint.
    pub joint_lane_start: Option<Attribute<i32>>,
    /// `@jointLaneEnd`: Lane at which the joint ends. Of variant joint.
    pub joint_lane_end: Option<Attribute<i32>>,
    /// `@transitionLength` `[m]`: Length over which heights blend. At least 0. Of variant joint.
    pub transition_length: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Heights of the junction's area (`t_junction_elevationGrid`; section 12; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ElevationGrid {
    /// The start tag.
    pub span: Span,
    /// `@sStart` `[m]`: Where it begins along the reference line. Required by the text since 1.8.
    pub s_start: Option<Attribute<Box<str>>>,
    /// `@gridSpacing` `[m]`: Distance of grid points along the reference line, and laterally. Required by the text since 1.8.
    pub grid_spacing: Option<Attribute<Box<str>>>,
    /// `elevation`: A row of heights across the grid.
    pub elevation: Vec<GridElevation>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A row of heights across the grid (`t_junction_elevationGrid_elevation`; section 12; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GridElevation {
    /// The start tag.
    pub span: Span,
    /// `@left` `[m]`: Heights to the left of the center, from the inside outwards, separated by spaces.
    pub left: Option<Attribute<Box<str>>>,
    /// `@center` `[m]`: Height at the center. Required by the text since 1.8.
    pub center: Option<Attribute<Box<str>>>,
    /// `@right` `[m]`: Heights to the right of the center, from the inside outwards, separated by spaces.
    pub right: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Junctions that belong together (`t_junctionGroup`; section 12).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JunctionGroup {
    /// The start tag.
    pub span: Span,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@type`: Kind. Required since 1.5.
    pub r#type: Option<Attribute<JunctionGroupType>>,
    /// `junctionReference`: A junction of a group.
    pub junction_reference: Vec<JunctionReference>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A junction of a group (`t_junctionGroup_junctionReference`; section 12).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JunctionReference {
    /// The start tag.
    pub span: Span,
    /// `@junction`: Junction that it belongs to. Required since 1.5.
    pub junction: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Surface data of a junction (`t_junction_surface`; section 12; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JunctionSurface {
    /// The start tag.
    pub span: Span,
    /// `CRG`: Surface data of a junction in an OpenCRG file.
    pub crg: Vec<JunctionCrg>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Surface data of a junction in an OpenCRG file (`t_junction_surface_CRG`; section 12; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JunctionCrg {
    /// The start tag.
    pub span: Span,
    /// `@file`: Path of the file, relative to this one. Required.
    pub file: Option<Attribute<Box<str>>>,
    /// `@sStart` `[m]`: Where it begins along the reference line. At least 0. Required. Since 1.8.
    pub s_start: Option<Attribute<f64>>,
    /// `@sEnd` `[m]`: Where it ends along the reference line. At least 0. Required. Since 1.8.
    pub s_end: Option<Attribute<f64>>,
    /// `@orientation`: Direction of travel that it is for: along s, against s, both. Required. Since 1.8.
    pub orientation: Option<Attribute<Direction>>,
    /// `@mode`: How it is applied. Required.
    pub mode: Option<Attribute<CrgMode>>,
    /// `@purpose`: What the surface data describe.
    pub purpose: Option<Attribute<CrgPurpose>>,
    /// `@sOffset` `[m]`: Offset along the reference line. Since 1.8.
    pub s_offset: Option<Attribute<f64>>,
    /// `@tOffset` `[m]`: Lateral offset. Since 1.8.
    pub t_offset: Option<Attribute<f64>>,
    /// `@xOffset` `[m]`: Offset in x. Since 1.9.
    pub x_offset: Option<Attribute<f64>>,
    /// `@yOffset` `[m]`: Offset in y. Since 1.9.
    pub y_offset: Option<Attribute<f64>>,
    /// `@zOffset` `[m]`: Height above the reference line.
    pub z_offset: Option<Attribute<f64>>,
    /// `@zScale`: Factor on heights.
    pub z_scale: Option<Attribute<f64>>,
    /// `@hOffset` `[rad]`: Heading relative to the reference line. Since 1.8.
    pub h_offset: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
