//! Elements of `lanes`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/lanes.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// The lanes of a road (`t_road_lanes`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lanes {
    /// The start tag.
    pub span: Span,
    /// `@layer`: Layer that is meant: permanent or temporary. Since 1.9.
    pub layer: Option<Attribute<LayerType>>,
    /// `laneOffset`: Shift of lane 0 off the reference line, a cubic of the distance from s.
    pub lane_offset: Vec<LaneOffset>,
    /// `laneSection`: A stretch of road with the same lanes.
    pub lane_section: Vec<LaneSection>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Shift of lane 0 off the reference line, a cubic of the distance from s (`t_road_lanes_laneOffset`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneOffset {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@a` `[m]`: Coefficient of the polynomial: constant. Required since 1.5.
    pub a: Option<Attribute<f64>>,
    /// `@b` `[1]`: Coefficient of the polynomial: linear. Required since 1.5.
    pub b: Option<Attribute<f64>>,
    /// `@c` `[1/m]`: Coefficient of the polynomial: quadratic. Required since 1.5.
    pub c: Option<Attribute<f64>>,
    /// `@d` `[1/m²]`: Coefficient of the polynomial: cubic. Required since 1.5.
    pub d: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A stretch of road with the same lanes (`t_road_lanes_laneSection`; section 11.3).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneSection {
    /// The start tag.
    pub span: Span,
    /// `@length` `[m]`: Length. At least 0. Since 1.9.
    pub length: Option<Attribute<f64>>,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@singleSide`: Whether the section replaces one side of the road only.
    pub single_side: Option<Attribute<bool>>,
    /// `left`: The lanes of one side.
    pub left: Option<Box<LaneSectionSide>>,
    /// `center`: The center of a section.
    pub center: Option<Box<LaneSectionCenter>>,
    /// `right`: The lanes of one side.
    pub right: Option<Box<LaneSectionSide>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The lanes of one side (`t_road_lanes_laneSection_left`, `t_road_lanes_laneSection_right`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneSectionSide {
    /// The start tag.
    pub span: Span,
    /// `lane`: A lane.
    pub lane: Vec<Lane>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A lane (`t_road_lanes_laneSection_left_lane`, `t_road_lanes_laneSection_right_lane`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lane {
    /// The start tag.
    pub span: Span,
    /// `@type`: Kind. Required since 1.5.
    pub r#type: Option<Attribute<LaneType>>,
    /// `@advisory`: Side on which the lane is advisory. Since 1.8.
    pub advisory: Option<Attribute<LaneAdvisory>>,
    /// `@direction`: Direction of travel. Since 1.8.
    pub direction: Option<Attribute<LaneDirection>>,
    /// `@dynamicLaneType`: Whether the lane type changes over time. Since 1.8.
    pub dynamic_lane_type: Option<Attribute<bool>>,
    /// `@dynamicLaneDirection`: Whether the direction of travel changes over time. Since 1.8.
    pub dynamic_lane_direction: Option<Attribute<bool>>,
    /// `@level`: Whether the lane keeps level instead of following the superelevation.
    pub level: Option<Attribute<bool>>,
    /// `@roadWorks`: Whether there are road works. Since 1.8.
    pub road_works: Option<Attribute<bool>>,
    /// `@id`: Number of the lane: positive to the left of the reference line, negative to the right. Not 0 since 1.5. Required since 1.5.
    pub id: Option<Attribute<i32>>,
    /// `link`: Lanes before and after.
    pub link: Option<Box<LaneLink>>,
    /// `border`: Outer border of a lane, a cubic of the distance from sOffset.
    pub border: Vec<LaneBorder>,
    /// `width`: Width of a lane, a cubic of the distance from sOffset.
    pub width: Vec<LaneWidth>,
    /// `roadMark`: Mark on the outer border of a lane.
    pub road_mark: Vec<RoadMark>,
    /// `material`: Surface of a lane.
    pub material: Vec<LaneMaterial>,
    /// `visibility`: How far one sees from a lane. Until 1.5.
    pub visibility: Vec<LaneVisibility>,
    /// `speed`: Speed limit of a lane.
    pub speed: Vec<LaneSpeed>,
    /// `access`: Who may use a lane.
    pub access: Vec<LaneAccess>,
    /// `height`: Height of a lane above the road surface.
    pub height: Vec<LaneHeight>,
    /// `rule`: A rule in words.
    pub rule: Vec<LaneRule>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Lanes before and after (`t_road_lanes_laneSection_lcr_lane_link`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneLink {
    /// The start tag.
    pub span: Span,
    /// `predecessor`: A lane before or after.
    pub predecessor: Vec<LinkedLane>,
    /// `successor`: A lane before or after.
    pub successor: Vec<LinkedLane>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A lane before or after (`t_road_lanes_laneSection_lcr_lane_link_predecessorSuccessor`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinkedLane {
    /// The start tag.
    pub span: Span,
    /// `@id`: Number of the linked lane. Required since 1.5.
    pub id: Option<Attribute<i32>>,
    /// `@layer`: Layer that is meant: permanent or temporary. Since 1.9.
    pub layer: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Outer border of a lane, a cubic of the distance from sOffset (`t_road_lanes_laneSection_lr_lane_border`; section 11.6).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneBorder {
    /// The start tag.
    pub span: Span,
    /// `@sOffset` `[m]`: Distance from the start of the lane section. At least 0 since 1.5. Required since 1.5.
    pub s_offset: Option<Attribute<f64>>,
    /// `@a` `[m]`: Coefficient of the polynomial: constant. Required since 1.5.
    pub a: Option<Attribute<f64>>,
    /// `@b` `[1]`: Coefficient of the polynomial: linear. Required since 1.5.
    pub b: Option<Attribute<f64>>,
    /// `@c` `[1/m]`: Coefficient of the polynomial: quadratic. Required since 1.5.
    pub c: Option<Attribute<f64>>,
    /// `@d` `[1/m²]`: Coefficient of the polynomial: cubic. Required since 1.5.
    pub d: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Width of a lane, a cubic of the distance from sOffset (`t_road_lanes_laneSection_lr_lane_width`; section 11.6).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneWidth {
    /// The start tag.
    pub span: Span,
    /// `@sOffset` `[m]`: Distance from the start of the lane section. At least 0 since 1.5. Required since 1.5.
    pub s_offset: Option<Attribute<f64>>,
    /// `@a` `[m]`: Coefficient of the polynomial: constant. Required since 1.5.
    pub a: Option<Attribute<f64>>,
    /// `@b` `[1]`: Coefficient of the polynomial: linear. Required since 1.5.
    pub b: Option<Attribute<f64>>,
    /// `@c` `[1/m]`: Coefficient of the polynomial: quadratic. Required since 1.5.
    pub c: Option<Attribute<f64>>,
    /// `@d` `[1/m²]`: Coefficient of the polynomial: cubic. Required since 1.5.
    pub d: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Surface of a lane (`t_road_lanes_laneSection_lr_lane_material`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneMaterial {
    /// The start tag.
    pub span: Span,
    /// `@sOffset` `[m]`: Distance from the start of the lane section. At least 0 since 1.5. Required since 1.5.
    pub s_offset: Option<Attribute<f64>>,
    /// `@surface`: Code of the surface.
    pub surface: Option<Attribute<Box<str>>>,
    /// `@friction` `[-]`: Friction coefficient. At least 0 since 1.5. Required since 1.5.
    pub friction: Option<Attribute<f64>>,
    /// `@roughness`: Roughness. At least 0 since 1.5.
    pub roughness: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Speed limit of a lane (`t_road_lanes_laneSection_lr_lane_speed`; section 11.9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneSpeed {
    /// The start tag.
    pub span: Span,
    /// `@sOffset` `[m]`: Distance from the start of the lane section. At least 0 since 1.5. Required since 1.5.
    pub s_offset: Option<Attribute<f64>>,
    /// `@max`: Greatest speed allowed. At least 0 since 1.5. Required since 1.5.
    pub max: Option<Attribute<SpeedLimit>>,
    /// `@unit`: Unit of the value.
    pub unit: Option<Attribute<UnitSpeed>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// How far one sees from a lane (`t_road_lanes_laneSection_lr_lane_visibility`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneVisibility {
    /// The start tag.
    pub span: Span,
    /// `@sOffset` `[m]`: Distance from the start of the lane section. At least 0 in 1.5. Required in 1.5. Until 1.5.
    pub s_offset: Option<Attribute<f64>>,
    /// `@forward` `[m]`: Distance seen ahead. At least 0 in 1.5. Required in 1.5. Until 1.5.
    pub forward: Option<Attribute<f64>>,
    /// `@back` `[m]`: Distance seen behind. At least 0 in 1.5. Required in 1.5. Until 1.5.
    pub back: Option<Attribute<f64>>,
    /// `@left` `[m]`: Distance seen to the left. At least 0 in 1.5. Required in 1.5. Until 1.5.
    pub left: Option<Attribute<f64>>,
    /// `@right` `[m]`: Distance seen to the right. At least 0 in 1.5. Required in 1.5. Until 1.5.
    pub right: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Who may use a lane (`t_road_lanes_laneSection_lr_lane_access`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneAccess {
    /// The start tag.
    pub span: Span,
    /// `@sOffset` `[m]`: Distance from the start of the lane section. At least 0 since 1.5. Required since 1.5.
    pub s_offset: Option<Attribute<f64>>,
    /// `@rule`: Rule that holds. Required in 1.5. Since 1.5.
    pub rule: Option<Attribute<AccessRule>>,
    /// `@restriction`: Who is meant. Required 1.5 to 1.7. Deprecated since 1.8.
    pub restriction: Option<Attribute<Box<str>>>,
    /// `restriction`: One kind of user. Since 1.8.
    pub restriction_element: Vec<AccessRestriction>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// One kind of user (`t_road_lanes_laneSection_lr_lane_access_restriction`; section 11; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AccessRestriction {
    /// The start tag.
    pub span: Span,
    /// `@type`: Kind. Required by the text since 1.8.
    pub r#type: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Height of a lane above the road surface (`t_road_lanes_laneSection_lr_lane_height`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneHeight {
    /// The start tag.
    pub span: Span,
    /// `@sOffset` `[m]`: Distance from the start of the lane section. At least 0 since 1.5. Required since 1.5.
    pub s_offset: Option<Attribute<f64>>,
    /// `@inner` `[m]`: Height of the inner edge. Required since 1.5.
    pub inner: Option<Attribute<f64>>,
    /// `@outer` `[m]`: Height of the outer edge. Required since 1.5.
    pub outer: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A rule in words (`t_road_lanes_laneSection_lr_lane_rule`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneRule {
    /// The start tag.
    pub span: Span,
    /// `@sOffset` `[m]`: Distance from the start of the lane section. At least 0 since 1.5. Required since 1.5.
    pub s_offset: Option<Attribute<f64>>,
    /// `@value`: Rule in words. Required since 1.5.
    pub value: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The center of a section (`t_road_lanes_laneSection_center`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LaneSectionCenter {
    /// The start tag.
    pub span: Span,
    /// `lane`: Lane 0, which has no width.
    pub lane: Vec<CenterLane>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Lane 0, which has no width (`t_road_lanes_laneSection_center_lane`; section 11).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CenterLane {
    /// The start tag.
    pub span: Span,
    /// `@id`: Number of the lane, always 0. Always 0. Required since 1.5.
    pub id: Option<Attribute<i32>>,
    /// `@type`: Kind. Required 1.5 to 1.7. Deprecated since 1.8.
    pub r#type: Option<Attribute<LaneType>>,
    /// `@level`: Whether the lane keeps level instead of following the superelevation. Deprecated since 1.8.
    pub level: Option<Attribute<bool>>,
    /// `link`: Lanes before and after.
    pub link: Option<Box<LaneLink>>,
    /// `border`: Outer border of a lane, a cubic of the distance from sOffset. 1.6 to 1.7.
    pub border: Vec<LaneBorder>,
    /// `width`: Width of a lane, a cubic of the distance from sOffset. 1.6 to 1.7.
    pub width: Vec<LaneWidth>,
    /// `roadMark`: Mark on the outer border of a lane.
    pub road_mark: Vec<RoadMark>,
    /// `material`: Surface of a lane. 1.6 to 1.7.
    pub material: Vec<LaneMaterial>,
    /// `speed`: Speed limit of a lane. 1.6 to 1.7.
    pub speed: Vec<LaneSpeed>,
    /// `access`: Who may use a lane. 1.6 to 1.7.
    pub access: Vec<LaneAccess>,
    /// `height`: Height of a lane above the road surface. 1.6 to 1.7.
    pub height: Vec<LaneHeight>,
    /// `rule`: A rule in words. 1.6 to 1.7.
    pub rule: Vec<LaneRule>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
