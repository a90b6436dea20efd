//! Elements of `railroad`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/railroad.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// Railway equipment (`t_road_railroad`; section 15).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Railroad {
    /// The start tag.
    pub span: Span,
    /// `switch`: A railway switch.
    pub switch: Vec<Switch>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A railway switch (`t_road_railroad_switch`; section 15).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Switch {
    /// The start tag.
    pub span: Span,
    /// `@name`: Name for people. Required since 1.5.
    pub name: Option<Attribute<Box<str>>>,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@position`: State of the switch. Required since 1.5.
    pub position: Option<Attribute<SwitchPosition>>,
    /// `mainTrack`: The straight track.
    pub main_track: Option<Box<MainTrack>>,
    /// `sideTrack`: The branching track.
    pub side_track: Option<Box<SideTrack>>,
    /// `partner`: The switch at the other end.
    pub partner: Option<Box<SwitchPartner>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The straight track (`t_road_railroad_switch_mainTrack`; section 15).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MainTrack {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@dir`: Direction along the track. Required since 1.5.
    pub dir: Option<Attribute<ElementDir>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The branching track (`t_road_railroad_switch_sideTrack`; section 15).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SideTrack {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@dir`: Direction along the track. Required since 1.5.
    pub dir: Option<Attribute<ElementDir>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The switch at the other end (`t_road_railroad_switch_partner`; section 15).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SwitchPartner {
    /// The start tag.
    pub span: Span,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A railway station (`t_station`; section 15).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Station {
    /// The start tag.
    pub span: Span,
    /// `@name`: Name for people. Required since 1.5.
    pub name: Option<Attribute<Box<str>>>,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@type`: Kind.
    pub r#type: Option<Attribute<StationType>>,
    /// `platform`: A platform.
    pub platform: Vec<Platform>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A platform (`t_station_platform`; section 15).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Platform {
    /// The start tag.
    pub span: Span,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `segment`: A stretch of road beside the platform.
    pub segment: Vec<PlatformSegment>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A stretch of road beside the platform (`t_station_platform_segment`; section 15).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlatformSegment {
    /// The start tag.
    pub span: Span,
    /// `@roadId`: Road that is meant. Required since 1.5.
    pub road_id: Option<Attribute<Box<str>>>,
    /// `@sStart` `[m]`: Where it begins along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s_start: Option<Attribute<f64>>,
    /// `@sEnd` `[m]`: Where it ends along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s_end: Option<Attribute<f64>>,
    /// `@side`: Side. Required since 1.5.
    pub side: Option<Attribute<PlatformSide>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
