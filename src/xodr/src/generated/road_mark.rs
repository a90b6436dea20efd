//! Elements of `road_mark`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/road_mark.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// Mark on the outer border of a lane (`t_road_lanes_laneSection_lcr_lane_roadMark`; section 11.10).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoadMark {
    /// The start tag.
    pub span: Span,
    /// `@sOffset` `[m]`: Distance from the start of the lane section. At least 0 since 1.5. Required since 1.5.
    pub s_offset: Option<Attribute<f64>>,
    /// `@type`: Kind of mark. Required since 1.5.
    pub r#type: Option<Attribute<RoadMarkType>>,
    /// `@weight`: Visual weight of the mark.
    pub weight: Option<Attribute<RoadMarkWeight>>,
    /// `@color`: Color. Required since 1.5.
    pub color: Option<Attribute<RoadMarkColor>>,
    /// `@material`: Material.
    pub material: Option<Attribute<Box<str>>>,
    /// `@width` `[m]`: Width of the mark. At least 0 since 1.5.
    pub width: Option<Attribute<f64>>,
    /// `@laneChange`: Which lane changes across the mark are allowed.
    pub lane_change: Option<Attribute<LaneChange>>,
    /// `@height` `[m]`: Height of the mark. Above 0 since 1.7.
    pub height: Option<Attribute<f64>>,
    /// `sway`: Lateral shift of a mark, a cubic of the distance from ds. Since 1.5.
    pub sway: Vec<Sway>,
    /// `type`: Pattern of a mark.
    pub type_element: Option<Box<RoadMarkPattern>>,
    /// `explicit`: Marks line by line. Since 1.5.
    pub explicit: Option<Box<ExplicitRoadMark>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Lateral shift of a mark, a cubic of the distance from ds (`t_road_lanes_laneSection_lcr_lane_roadMark_sway`; section 11.10; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sway {
    /// The start tag.
    pub span: Span,
    /// `@ds` `[m]`: Distance along the reference line. At least 0. Required.
    pub ds: Option<Attribute<f64>>,
    /// `@a` `[m]`: Coefficient of the polynomial: constant. Required.
    pub a: Option<Attribute<f64>>,
    /// `@b` `[1]`: Coefficient of the polynomial: linear. Required.
    pub b: Option<Attribute<f64>>,
    /// `@c` `[1/m]`: Coefficient of the polynomial: quadratic. Required.
    pub c: Option<Attribute<f64>>,
    /// `@d` `[1/m²]`: Coefficient of the polynomial: cubic. Required.
    pub d: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Pattern of a mark (`t_road_lanes_laneSection_lcr_lane_roadMark_type`; section 11.10).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoadMarkPattern {
    /// The start tag.
    pub span: Span,
    /// `@name`: Name for people. Required since 1.5.
    pub name: Option<Attribute<Box<str>>>,
    /// `@width` `[m]`: Width. At least 0 1.5 to 1.6. Above 0 since 1.7. Required since 1.5.
    pub width: Option<Attribute<f64>>,
    /// `line`: A line of the pattern, repeated.
    pub line: Vec<RoadMarkLine>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A line of the pattern, repeated (`t_road_lanes_laneSection_lcr_lane_roadMark_type_line`; section 11.10).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoadMarkLine {
    /// The start tag.
    pub span: Span,
    /// `@length` `[m]`: Length. At least 0 in 1.5, 1.7, 1.8, 1.8.1, 1.9. Required since 1.5.
    pub length: Option<Attribute<f64>>,
    /// `@space` `[m]`: Length of the gap between two lines. At least 0 since 1.5. Required since 1.5.
    pub space: Option<Attribute<f64>>,
    /// `@tOffset` `[m]`: Lateral offset. Required since 1.5.
    pub t_offset: Option<Attribute<f64>>,
    /// `@sOffset` `[m]`: Distance from the start of the lane section. At least 0 since 1.5. Required since 1.5.
    pub s_offset: Option<Attribute<f64>>,
    /// `@rule`: Passing rule seen from inside.
    pub rule: Option<Attribute<RoadMarkRule>>,
    /// `@width` `[m]`: Width. At least 0 in 1.5. Above 0 since 1.7. Required in 1.5.
    pub width: Option<Attribute<f64>>,
    /// `@color`: Color. Since 1.5.
    pub color: Option<Attribute<RoadMarkColor>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Marks line by line (`t_road_lanes_laneSection_lcr_lane_roadMark_explicit`; section 11.10; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExplicitRoadMark {
    /// The start tag.
    pub span: Span,
    /// `line`: One line of an explicit mark.
    pub line: Vec<ExplicitLine>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// One line of an explicit mark (`t_road_lanes_laneSection_lcr_lane_roadMark_explicit_line`; section 11.10; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExplicitLine {
    /// The start tag.
    pub span: Span,
    /// `@length` `[m]`: Length. At least 0 in 1.5. Above 0 since 1.7. Required.
    pub length: Option<Attribute<f64>>,
    /// `@tOffset` `[m]`: Lateral offset. Required.
    pub t_offset: Option<Attribute<f64>>,
    /// `@sOffset` `[m]`: Distance from the start of the lane section. At least 0. Required.
    pub s_offset: Option<Attribute<f64>>,
    /// `@rule`: Passing rule seen from inside.
    pub rule: Option<Attribute<RoadMarkRule>>,
    /// `@width` `[m]`: Width. At least 0 in 1.5. Above 0 since 1.7. Required in 1.5.
    pub width: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
