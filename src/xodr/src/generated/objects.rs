//! Elements of `objects`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/objects.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// Objects along a road (`t_road_objects`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Objects {
    /// The start tag.
    pub span: Span,
    /// `object`: An object along the road.
    pub object: Vec<Object>,
    /// `objectReference`: An object of another road that concerns this one too.
    pub object_reference: Vec<ObjectReference>,
    /// `tunnel`: A tunnel.
    pub tunnel: Vec<Tunnel>,
    /// `bridge`: A bridge.
    pub bridge: Vec<Bridge>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// An object along the road (`t_road_objects_object`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Object {
    /// The start tag.
    pub span: Span,
    /// `@t` `[m]`: Lateral distance from the reference line, positive to the left. Required since 1.5.
    pub t: Option<Attribute<f64>>,
    /// `@zOffset` `[m]`: Height above the reference line. Required since 1.5.
    pub z_offset: Option<Attribute<f64>>,
    /// `@type`: Kind.
    pub r#type: Option<Attribute<Box<str>>>,
    /// `@validLength` `[m]`: Length along s over which it holds. At least 0 since 1.5. Required in 1.5.
    pub valid_length: Option<Attribute<f64>>,
    /// `@orientation`: Direction of travel that it is for: along s, against s, both. Required in 1.5.
    pub orientation: Option<Attribute<Orientation>>,
    /// `@subtype`: Further distinction of the type. Since 1.5.
    pub subtype: Option<Attribute<Box<str>>>,
    /// `@dynamic`: Whether its state changes. Required in 1.5. Since 1.5.
    pub dynamic: Option<Attribute<bool>>,
    /// `@hdg` `[rad]`: Heading. Required in 1.5.
    pub hdg: Option<Attribute<f64>>,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@pitch` `[rad]`: Pitch. Required in 1.5.
    pub pitch: Option<Attribute<f64>>,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@roll` `[rad]`: Roll. Required in 1.5.
    pub roll: Option<Attribute<f64>>,
    /// `@height` `[m]`: Height. At least 0 since 1.7. Required in 1.5.
    pub height: Option<Attribute<f64>>,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@length` `[m]`: Length. Above 0 since 1.7.
    pub length: Option<Attribute<f64>>,
    /// `@width` `[m]`: Width.
    pub width: Option<Attribute<f64>>,
    /// `@radius` `[m]`: Radius. Above 0 since 1.7.
    pub radius: Option<Attribute<f64>>,
    /// `@perpToRoad`: Whether the object stands perpendicular to the road surface. Since 1.7.
    pub perp_to_road: Option<Attribute<bool>>,
    /// `@invalidated`: Whether it no longer holds. Since 1.9.
    pub invalidated: Option<Attribute<bool>>,
    /// `@temporary`: Whether it stands for a limited time. Since 1.9.
    pub temporary: Option<Attribute<bool>>,
    /// `repeat`: The object, repeated along the road.
    pub repeat: Vec<ObjectRepeat>,
    /// `outline`: An outline of an object.
    pub outline: Option<Box<Outline>>,
    /// `outlines`: Outlines of an object. Since 1.5.
    pub outlines: Option<Box<Outlines>>,
    /// `material`: Surface of an object.
    pub material: Vec<ObjectMaterial>,
    /// `validity`: Lanes for which it holds.
    pub validity: Vec<LaneValidity>,
    /// `parkingSpace`: The object is a parking space.
    pub parking_space: Option<Box<ParkingSpace>>,
    /// `markings`: Markings of an object. Since 1.5.
    pub markings: Option<Box<Markings>>,
    /// `borders`: Borders of an object. Since 1.5.
    pub borders: Option<Box<ObjectBorders>>,
    /// `surface`: Surface data of the object. Since 1.7.
    pub surface: Option<Box<ObjectSurface>>,
    /// `skeleton`: Lines that describe the object. Since 1.8.
    pub skeleton: Option<Box<Skeleton>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The object, repeated along the road (`t_road_objects_object_repeat`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ObjectRepeat {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@length` `[m]`: Length. At least 0 since 1.5. Required since 1.5.
    pub length: Option<Attribute<f64>>,
    /// `@distance` `[m]`: Distance between two repetitions; 0 means without gap. At least 0 since 1.5. Required since 1.5.
    pub distance: Option<Attribute<f64>>,
    /// `@tStart` `[m]`: Lateral position at the start. Required since 1.5.
    pub t_start: Option<Attribute<f64>>,
    /// `@tEnd` `[m]`: Lateral position at the end. Required since 1.5.
    pub t_end: Option<Attribute<f64>>,
    /// `@heightStart` `[m]`: Height at the start. At least 0 since 1.7. Required since 1.5. Optional by the text of 1.9.
    pub height_start: Option<Attribute<f64>>,
    /// `@heightEnd` `[m]`: Height at the end. At least 0 since 1.7. Required since 1.5. Optional by the text of 1.9.
    pub height_end: Option<Attribute<f64>>,
    /// `@zOffsetStart` `[m]`: Height above the reference line at the start. Required since 1.5.
    pub z_offset_start: Option<Attribute<f64>>,
    /// `@zOffsetEnd` `[m]`: Height above the reference line at the end. Required since 1.5.
    pub z_offset_end: Option<Attribute<f64>>,
    /// `@widthStart` `[m]`: Width at the start. At least 0 since 1.5. Required in 1.5.
    pub width_start: Option<Attribute<f64>>,
    /// `@widthEnd` `[m]`: Width at the end. At least 0 since 1.5. Required in 1.5.
    pub width_end: Option<Attribute<f64>>,
    /// `@lengthStart` `[m]`: Length at the start. At least 0. Since 1.5.
    pub length_start: Option<Attribute<f64>>,
    /// `@lengthEnd` `[m]`: Length at the end. At least 0. Since 1.5.
    pub length_end: Option<Attribute<f64>>,
    /// `@radiusStart` `[m]`: Radius at the start. At least 0. Since 1.5.
    pub radius_start: Option<Attribute<f64>>,
    /// `@radiusEnd` `[m]`: Radius at the end. At least 0. Since 1.5.
    pub radius_end: Option<Attribute<f64>>,
    /// `@detachFromReferenceLine`: Whether repetitions follow a straight line instead of the reference line. Since 1.8.
    pub detach_from_reference_line: Option<Attribute<bool>>,
    /// `@bT`: Lateral offset: linear coefficient. At least 0. Since 1.9.
    pub b_t: Option<Attribute<f64>>,
    /// `@cT`: Lateral offset: quadratic coefficient. At least 0. Since 1.9.
    pub c_t: Option<Attribute<f64>>,
    /// `@dT`: Lateral offset: cubic coefficient. At least 0. Since 1.9.
    pub d_t: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Surface of an object (`t_road_objects_object_material`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ObjectMaterial {
    /// The start tag.
    pub span: Span,
    /// `@surface`: Code of the surface.
    pub surface: Option<Attribute<Box<str>>>,
    /// `@friction` `[-]`: Friction coefficient. At least 0 since 1.5.
    pub friction: Option<Attribute<f64>>,
    /// `@roughness`: Roughness. At least 0 since 1.5.
    pub roughness: Option<Attribute<f64>>,
    /// `@roadMarkColor`: Color of painted markings. Since 1.8.
    pub road_mark_color: Option<Attribute<RoadMarkColor>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Lanes for which it holds (`t_road_objects_object_laneValidity`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneValidity {
    /// The start tag.
    pub span: Span,
    /// `@fromLane`: First lane. Required since 1.5.
    pub from_lane: Option<Attribute<i32>>,
    /// `@toLane`: Last lane. Required since 1.5.
    pub to_lane: Option<Attribute<i32>>,
    /// `@layer`: Layer that is meant: permanent or temporary. Since 1.9.
    pub layer: Option<Attribute<LayerType>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The object is a parking space (`t_road_objects_object_parkingSpace`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParkingSpace {
    /// The start tag.
    pub span: Span,
    /// `@access`: Who may park. Required since 1.5.
    pub access: Option<Attribute<ParkingSpaceAccess>>,
    /// `@restrictions`: Who may park, in words.
    pub restrictions: Option<Attribute<Box<str>>>,
    /// `marking`: Marking of a side of the parking space. In 1.4.
    pub marking: Vec<ParkingSpaceMarking>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Marking of a side of the parking space (section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParkingSpaceMarking {
    /// The start tag.
    pub span: Span,
    /// `@side`: Side. In 1.4.
    pub side: Option<Attribute<ParkingSpaceMarkingSide>>,
    /// `@type`: Kind. In 1.4.
    pub r#type: Option<Attribute<RoadMarkType>>,
    /// `@width` `[m]`: Width. In 1.4.
    pub width: Option<Attribute<f64>>,
    /// `@color`: Color. In 1.4.
    pub color: Option<Attribute<RoadMarkColor>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Surface data of the object (`t_road_objects_object_surface`; section 13; since 1.7).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ObjectSurface {
    /// The start tag.
    pub span: Span,
    /// `CRG`: Surface data in an OpenCRG file.
    pub crg: Option<Box<ObjectCrg>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Surface data in an OpenCRG file (`t_road_objects_object_surface_CRG`; section 13; since 1.7).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ObjectCrg {
    /// The start tag.
    pub span: Span,
    /// `@file`: Path of the file, relative to this one. Required by the text since 1.8.
    pub file: Option<Attribute<Box<str>>>,
    /// `@hideRoadSurfaceCRG`: Whether the road's own surface data are hidden below it. Required by the text since 1.8.
    pub hide_road_surface_crg: Option<Attribute<bool>>,
    /// `@zScale`: Factor on heights. Required by the text since 1.8.
    pub z_scale: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// An object of another road that concerns this one too (`t_road_objects_objectReference`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ObjectReference {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@t` `[m]`: Lateral distance from the reference line, positive to the left. Required since 1.5.
    pub t: Option<Attribute<f64>>,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@zOffset` `[m]`: Height above the reference line. Required in 1.5.
    pub z_offset: Option<Attribute<f64>>,
    /// `@validLength` `[m]`: Length along s over which it holds. At least 0 since 1.5. Required in 1.5.
    pub valid_length: Option<Attribute<f64>>,
    /// `@orientation`: Direction of travel that it is for: along s, against s, both. Required since 1.5.
    pub orientation: Option<Attribute<Orientation>>,
    /// `validity`: Lanes for which it holds.
    pub validity: Vec<LaneValidity>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A tunnel (`t_road_objects_tunnel`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tunnel {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@length` `[m]`: Length. At least 0 since 1.5. Required since 1.5.
    pub length: Option<Attribute<f64>>,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@type`: Kind. Required since 1.5.
    pub r#type: Option<Attribute<TunnelType>>,
    /// `@lighting`: Degree of artificial light. From 0 to 1 since 1.5.
    pub lighting: Option<Attribute<f64>>,
    /// `@daylight`: Degree of daylight. From 0 to 1 since 1.5.
    pub daylight: Option<Attribute<f64>>,
    /// `validity`: Lanes for which it holds.
    pub validity: Vec<LaneValidity>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A bridge (`t_road_objects_bridge`; section 13).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bridge {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@length` `[m]`: Length. At least 0 since 1.5. Required since 1.5.
    pub length: Option<Attribute<f64>>,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@type`: Kind. Required since 1.5.
    pub r#type: Option<Attribute<BridgeType>>,
    /// `validity`: Lanes for which it holds.
    pub validity: Vec<LaneValidity>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
