//! Elements of `road`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/road.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// A road: reference line, lanes and what stands along it (`t_road`; section 10).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Road {
    /// The start tag.
    pub span: Span,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@length` `[m]`: Length of the reference line in the plane. At least 0 in 1.5. Above 0 since 1.7. Required since 1.5.
    pub length: Option<Attribute<f64>>,
    /// `@id`: Identifier, unique among roads. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@junction`: Junction that the road belongs to; -1 for none. Required since 1.5.
    pub junction: Option<Attribute<Box<str>>>,
    /// `@rule`: Side on which traffic drives. Since 1.5.
    pub rule: Option<Attribute<TrafficRule>>,
    /// `link`: What lies before and after the road.
    pub link: Option<Box<RoadLink>>,
    /// `type`: Type of road from s on.
    pub r#type: Vec<RoadTypeRecord>,
    /// `planView`: The reference line in the plane.
    pub plan_view: Option<Box<PlanView>>,
    /// `elevationProfile`: Heights along the reference line.
    pub elevation_profile: Option<Box<ElevationProfile>>,
    /// `lateralProfile`: Shape of the surface across the road.
    pub lateral_profile: Option<Box<LateralProfile>>,
    /// `lanes`: The lanes of a road.
    pub lanes: Vec<Lanes>,
    /// `objects`: Objects along a road.
    pub objects: Option<Box<Objects>>,
    /// `signals`: Signals along a road.
    pub signals: Option<Box<Signals>>,
    /// `surface`: Surface data of a road or junction.
    pub surface: Option<Box<RoadSurface>>,
    /// `railroad`: Railway equipment.
    pub railroad: Option<Box<Railroad>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// What lies before and after the road (`t_road_link`; section 10.3).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoadLink {
    /// The start tag.
    pub span: Span,
    /// `predecessor`: The road or junction before or after.
    pub predecessor: Option<Box<LinkedElement>>,
    /// `successor`: The road or junction before or after.
    pub successor: Option<Box<LinkedElement>>,
    /// `neighbor`: A road beside this one. Until 1.5.
    pub neighbor: Vec<Neighbor>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The road or junction before or after (`t_road_link_predecessorSuccessor`; section 10.3).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinkedElement {
    /// The start tag.
    pub span: Span,
    /// `@elementId`: Identifier of what is linked. Required since 1.5.
    pub element_id: Option<Attribute<Box<str>>>,
    /// `@elementType`: Kind of what is linked. Required in 1.5. Required by the text since 1.8.
    pub element_type: Option<Attribute<ElementType>>,
    /// `@contactPoint`: End of the road that touches.
    pub contact_point: Option<Attribute<ContactPoint>>,
    /// `@elementS` `[m]`: Where the link touches along the linked road. At least 0. Since 1.5.
    pub element_s: Option<Attribute<f64>>,
    /// `@elementDir`: Direction on the linked road. Since 1.5.
    pub element_dir: Option<Attribute<ElementDir>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A road beside this one (`t_road_link_neighbor`; section 10).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Neighbor {
    /// The start tag.
    pub span: Span,
    /// `@side`: Side. Required in 1.5. Until 1.5.
    pub side: Option<Attribute<NeighborSide>>,
    /// `@elementId`: Identifier of what is linked. Required in 1.5. Until 1.5.
    pub element_id: Option<Attribute<Box<str>>>,
    /// `@direction`: Direction of travel. Required in 1.5. Until 1.5.
    pub direction: Option<Attribute<Direction>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Type of road from s on (`t_road_type`; section 10.4).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoadTypeRecord {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@type`: Kind. Required since 1.5.
    pub r#type: Option<Attribute<RoadType>>,
    /// `@country`: Country whose rules hold: two or three letters, or a name in older versions. Since 1.5.
    pub country: Option<Attribute<Box<str>>>,
    /// `speed`: Speed limit of a type of road.
    pub speed: Option<Box<RoadSpeed>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Speed limit of a type of road (`t_road_type_speed`; section 10.4).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoadSpeed {
    /// The start tag.
    pub span: Span,
    /// `@max`: Greatest speed allowed. At least 0. Required since 1.5.
    pub max: Option<Attribute<SpeedLimit>>,
    /// `@unit`: Unit of the value. Required by the text since 1.8.
    pub unit: Option<Attribute<UnitSpeed>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Surface data of a road or junction (`t_road_surface`; section 10).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoadSurface {
    /// The start tag.
    pub span: Span,
    /// `CRG`: Surface data in an OpenCRG file.
    pub crg: Vec<RoadCrg>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Surface data in an OpenCRG file (`t_road_surface_CRG`; section 10).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoadCrg {
    /// The start tag.
    pub span: Span,
    /// `@file`: Path of the file, relative to this one. Required since 1.5.
    pub file: Option<Attribute<Box<str>>>,
    /// `@sStart` `[m]`: Where it begins along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s_start: Option<Attribute<f64>>,
    /// `@sEnd` `[m]`: Where it ends along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s_end: Option<Attribute<f64>>,
    /// `@orientation`: Direction of travel that it is for: along s, against s, both. Required since 1.5.
    pub orientation: Option<Attribute<Direction>>,
    /// `@mode`: How it is applied. Required since 1.5.
    pub mode: Option<Attribute<CrgMode>>,
    /// `@purpose`: What the surface data describe.
    pub purpose: Option<Attribute<CrgPurpose>>,
    /// `@sOffset` `[m]`: Distance from the start of the lane section.
    pub s_offset: Option<Attribute<f64>>,
    /// `@tOffset` `[m]`: Lateral offset.
    pub t_offset: Option<Attribute<f64>>,
    /// `@xOffset` `[m]`: Offset in x. Since 1.9.
    pub x_offset: Option<Attribute<f64>>,
    /// `@yOffset` `[m]`: Offset in y. Since 1.9.
    pub y_offset: Option<Attribute<f64>>,
    /// `@zOffset` `[m]`: Height above the reference line.
    pub z_offset: Option<Attribute<f64>>,
    /// `@zScale`: Factor on heights.
    pub z_scale: Option<Attribute<f64>>,
    /// `@hOffset` `[rad]`: Heading relative to the reference line.
    pub h_offset: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
