//! Elements of `object_outlines`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/object_outlines.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// An outline of an object (`t_road_objects_object_outlines_outline`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required in 1.5. Since 1.5.
    pub id: Option<Attribute<u32>>,
    /// `@fillType`: What fills the outline. Required in 1.5. Since 1.5.
    pub fill_type: Option<Attribute<OutlineFillType>>,
    /// `@outer`: Whether the outline is an outer one. Required in 1.5. Since 1.5.
    pub outer: Option<Attribute<bool>>,
    /// `@closed`: Whether the outline is closed. Required in 1.5. Since 1.5.
    pub closed: Option<Attribute<bool>>,
    /// `@laneType`: Lane type that the outline stands for. Required in 1.5. Since 1.5.
    pub lane_type: Option<Attribute<LaneType>>,
    /// `cornerRoad`: A corner in road coordinates.
    pub corner_road: Vec<CornerRoad>,
    /// `cornerLocal`: A corner in the object's frame.
    pub corner_local: Vec<CornerLocal>,
    /// `curveLocal`: A curve of the outline in the object's frame. Since 1.9.
    pub curve_local: Vec<CurveLocal>,
    /// `markings`: Markings of an object. Since 1.9.
    pub markings: Option<Box<Markings>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A corner in road coordinates (`t_road_objects_object_outlines_outline_cornerRoad`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CornerRoad {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required in 1.5. Since 1.5.
    pub id: Option<Attribute<u32>>,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@t` `[m]`: Lateral distance from the reference line, positive to the left. Required since 1.5.
    pub t: Option<Attribute<f64>>,
    /// `@dz` `[m]`: Height above the reference line. Required since 1.5.
    pub dz: Option<Attribute<f64>>,
    /// `@height` `[m]`: Height. At least 0 since 1.7. Required since 1.5.
    pub height: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A corner in the object's frame (`t_road_objects_object_outlines_outline_cornerLocal`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CornerLocal {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required in 1.5. Since 1.5.
    pub id: Option<Attribute<u32>>,
    /// `@u` `[m]`: Longitudinal coordinate in the local frame. Required since 1.5.
    pub u: Option<Attribute<f64>>,
    /// `@v` `[m]`: Lateral coordinate in the local frame. Required since 1.5.
    pub v: Option<Attribute<f64>>,
    /// `@z` `[m]`: Height coordinate. Required since 1.5.
    pub z: Option<Attribute<f64>>,
    /// `@height` `[m]`: Height. At least 0 since 1.7. Required since 1.5.
    pub height: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A curve of the outline in the object's frame (`t_road_objects_object_outlines_outline_curveLocal`; section 13; since 1.9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurveLocal {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind.
    pub id: Option<Attribute<u32>>,
    /// `@u` `[m]`: Longitudinal coordinate in the local frame. Required.
    pub u: Option<Attribute<f64>>,
    /// `@v` `[m]`: Lateral coordinate in the local frame. Required.
    pub v: Option<Attribute<f64>>,
    /// `@z` `[m]`: Height coordinate. Required.
    pub z: Option<Attribute<f64>>,
    /// `@height` `[m]`: Height. At least 0. Required.
    pub height: Option<Attribute<f64>>,
    /// `@length` `[m]`: Length. Above 0. Required. Optional by the text of 1.9.
    pub length: Option<Attribute<f64>>,
    /// `@hdg` `[rad]`: Heading. Required. Optional by the text of 1.9.
    pub hdg: Option<Attribute<f64>>,
    /// `arc`: The curve is an arc.
    pub arc: Option<Box<CurveLocalArc>>,
    /// `line`: The curve is a line.
    pub line: Option<Box<CurveLocalLine>>,
    /// `paramPoly3`: The curve is a parametric cubic.
    pub param_poly3: Option<Box<CurveLocalParamPoly3>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The curve is an arc (`t_road_objects_object_outlines_outline_curveLocal_arc`; section 13; since 1.9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurveLocalArc {
    /// The start tag.
    pub span: Span,
    /// `@curvature` `[1/m]`: Curvature, positive to the left. Required.
    pub curvature: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The curve is a line (`t_road_objects_object_outlines_outline_curveLocal_line`; section 13; since 1.9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurveLocalLine {
    /// The start tag.
    pub span: Span,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The curve is a parametric cubic (`t_road_objects_object_outlines_outline_curveLocal_paramPoly3`; section 13; since 1.9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurveLocalParamPoly3 {
    /// The start tag.
    pub span: Span,
    /// `@aU` `[m]`: Coefficient of u: constant. Required.
    pub a_u: Option<Attribute<f64>>,
    /// `@bU` `[1]`: Coefficient of u: linear. Required.
    pub b_u: Option<Attribute<f64>>,
    /// `@cU` `[1/m]`: Coefficient of u: quadratic. Required.
    pub c_u: Option<Attribute<f64>>,
    /// `@dU` `[1/m²]`: Coefficient of u: cubic. Required.
    pub d_u: Option<Attribute<f64>>,
    /// `@aV` `[m]`: Coefficient of v: constant. Required.
    pub a_v: Option<Attribute<f64>>,
    /// `@bV` `[1]`: Coefficient of v: linear. Required.
    pub b_v: Option<Attribute<f64>>,
    /// `@cV` `[1/m]`: Coefficient of v: quadratic. Required.
    pub c_v: Option<Attribute<f64>>,
    /// `@dV` `[1/m²]`: Coefficient of v: cubic. Required.
    pub d_v: Option<Attribute<f64>>,
    /// `@pRange`: Range of the curve parameter. Required.
    pub p_range: Option<Attribute<ParamPoly3Range>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Markings of an object (`t_road_objects_object_markings`; section 13; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Markings {
    /// The start tag.
    pub span: Span,
    /// `marking`: A marking along the object.
    pub marking: Vec<Marking>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A marking along the object (`t_road_objects_object_markings_marking`; section 13; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Marking {
    /// The start tag.
    pub span: Span,
    /// `@side`: Side. Required in 1.5.
    pub side: Option<Attribute<SideType>>,
    /// `@weight`: Visual weight of the mark. Required in 1.5.
    pub weight: Option<Attribute<RoadMarkWeight>>,
    /// `@width` `[m]`: Width. At least 0 in 1.5. Above 0 since 1.7.
    pub width: Option<Attribute<f64>>,
    /// `@color`: Color. Required.
    pub color: Option<Attribute<RoadMarkColor>>,
    /// `@zOffset` `[m]`: Height above the reference line. At least 0.
    pub z_offset: Option<Attribute<f64>>,
    /// `@spaceLength` `[m]`: Length of the gap between two lines. At least 0. Required.
    pub space_length: Option<Attribute<f64>>,
    /// `@lineLength` `[m]`: Length of the visible line. At least 0 in 1.5. Above 0 since 1.7. Required.
    pub line_length: Option<Attribute<f64>>,
    /// `@startOffset` `[m]`: Offset of the start from the first corner. Required.
    pub start_offset: Option<Attribute<f64>>,
    /// `@stopOffset` `[m]`: Offset of the end from the last corner. Required.
    pub stop_offset: Option<Attribute<f64>>,
    /// `cornerReference`: A corner of the outline.
    pub corner_reference: Vec<CornerReference>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A corner of the outline (`t_road_objects_object_markings_marking_cornerReference`; section 13; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CornerReference {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required.
    pub id: Option<Attribute<u32>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Outlines of an object (`t_road_objects_object_outlines`; section 13; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outlines {
    /// The start tag.
    pub span: Span,
    /// `outline`: An outline of an object.
    pub outline: Vec<Outline>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Borders of an object (`t_road_objects_object_borders`; section 13; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ObjectBorders {
    /// The start tag.
    pub span: Span,
    /// `border`: A border along an outline.
    pub border: Vec<ObjectBorder>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A border along an outline (`t_road_objects_object_borders_border`; section 13; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ObjectBorder {
    /// The start tag.
    pub span: Span,
    /// `@width` `[m]`: Width. At least 0. Required.
    pub width: Option<Attribute<f64>>,
    /// `@type`: Kind. Required.
    pub r#type: Option<Attribute<BorderType>>,
    /// `@outlineId`: Outline that is meant. Required.
    pub outline_id: Option<Attribute<u32>>,
    /// `@useCompleteOutline`: Whether the whole outline is used.
    pub use_complete_outline: Option<Attribute<bool>>,
    /// `cornerReference`: A corner of the outline.
    pub corner_reference: Vec<CornerReference>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Lines that describe the object (`t_road_objects_object_skeleton`; section 13; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skeleton {
    /// The start tag.
    pub span: Span,
    /// `polyline`: A line of the skeleton.
    pub polyline: Vec<Polyline>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A line of the skeleton (`t_road_objects_object_skeleton_polyline`; section 13; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polyline {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. At least 1.
    pub id: Option<Attribute<u32>>,
    /// `vertexRoad`: A vertex in road coordinates.
    pub vertex_road: Vec<VertexRoad>,
    /// `vertexLocal`: A vertex in the object's frame.
    pub vertex_local: Vec<VertexLocal>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A vertex in road coordinates (`t_road_objects_object_skeleton_polyline_vertexRoad`; section 13; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VertexRoad {
    /// The start tag.
    pub span: Span,
    /// `@dz` `[m]`: Height above the reference line. Required by the text since 1.8.
    pub dz: Option<Attribute<f64>>,
    /// `@radius` `[m]`: Radius.
    pub radius: Option<Attribute<f64>>,
    /// `@intersectionPoint`: Whether the vertex is where the object meets the ground.
    pub intersection_point: Option<Attribute<bool>>,
    /// `@id`: Identifier, unique among its kind. At least 1.
    pub id: Option<Attribute<u32>>,
    /// `@s` `[m]`: Distance along the reference line. At least 0. Required by the text since 1.8.
    pub s: Option<Attribute<f64>>,
    /// `@t` `[m]`: Lateral distance from the reference line, positive to the left. Required by the text since 1.8.
    pub t: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A vertex in the object's frame (`t_road_objects_object_skeleton_polyline_vertexLocal`; section 13; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VertexLocal {
    /// The start tag.
    pub span: Span,
    /// `@radius` `[m]`: Radius.
    pub radius: Option<Attribute<f64>>,
    /// `@intersectionPoint`: Whether the vertex is where the object meets the ground.
    pub intersection_point: Option<Attribute<bool>>,
    /// `@id`: Identifier, unique among its kind. At least 1.
    pub id: Option<Attribute<u32>>,
    /// `@u` `[m]`: Longitudinal coordinate in the local frame. Required by the text since 1.8.
    pub u: Option<Attribute<f64>>,
    /// `@v` `[m]`: Lateral coordinate in the local frame. Required by the text since 1.8.
    pub v: Option<Attribute<f64>>,
    /// `@z` `[m]`: Height coordinate. Required by the text since 1.8.
    pub z: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
