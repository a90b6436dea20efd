//! Elements of `header`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/header.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// What concerns the whole map (`t_header`; section 6.4).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Header {
    /// The start tag.
    pub span: Span,
    /// `@revMajor`: Major revision of the standard. Always 1. Required since 1.5.
    pub rev_major: Option<Attribute<i32>>,
    /// `@revMinor`: Minor revision of the standard. Required since 1.5.
    pub rev_minor: Option<Attribute<i32>>,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@version`: Version of the map.
    pub version: Option<Attribute<Box<str>>>,
    /// `@date`: Date of creation.
    pub date: Option<Attribute<Box<str>>>,
    /// `@north` `[m]`: Greatest y of the map.
    pub north: Option<Attribute<f64>>,
    /// `@south` `[m]`: Smallest y of the map.
    pub south: Option<Attribute<f64>>,
    /// `@east` `[m]`: Greatest x of the map.
    pub east: Option<Attribute<f64>>,
    /// `@west` `[m]`: Smallest x of the map.
    pub west: Option<Attribute<f64>>,
    /// `@vendor`: Who made the map.
    pub vendor: Option<Attribute<Box<str>>>,
    /// `geoReference`: The projection of the map, as text.
    pub geo_reference: Option<Box<GeoReference>>,
    /// `offset`: Shift and turn of the inertial frame. Since 1.5.
    pub offset: Option<Box<Offset>>,
    /// `license`: License of the map. Since 1.8.
    pub license: Option<Box<License>>,
    /// `defaultRegulations`: Rules that hold unless a road or signal says otherwise. Since 1.8.
    pub default_regulations: Option<Box<DefaultRegulations>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// The projection of the map, as text (`t_header_GeoReference`; section 6.4).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GeoReference {
    /// The start tag.
    pub span: Span,
    /// The text inside.
    pub content: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Shift and turn of the inertial frame (`t_header_Offset`; section 6.4; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Offset {
    /// The start tag.
    pub span: Span,
    /// `@x` `[m]`: Offset in x from the inertial frame. Required.
    pub x: Option<Attribute<f64>>,
    /// `@y` `[m]`: Offset in y from the inertial frame. Required.
    pub y: Option<Attribute<f64>>,
    /// `@z` `[m]`: Offset in z from the inertial frame. Required.
    pub z: Option<Attribute<f64>>,
    /// `@hdg` `[rad]`: Turn of the inertial frame. Required.
    pub hdg: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// License of the map (`t_license`; section 6.4; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct License {
    /// The start tag.
    pub span: Span,
    /// `@name`: Name for people. Required by the text since 1.8.
    pub name: Option<Attribute<Box<str>>>,
    /// `@spdxid`: SPDX identifier of the license.
    pub spdxid: Option<Attribute<Box<str>>>,
    /// `@text`: Text shown.
    pub text: Option<Attribute<Box<str>>>,
    /// `@resource`: Address of the license.
    pub resource: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Rules that hold unless a road or signal says otherwise (`t_header_defaultRegulations`; section 6.4; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DefaultRegulations {
    /// The start tag.
    pub span: Span,
    /// `roadRegulations`: Rules for a type of road.
    pub road_regulations: Vec<RoadRegulation>,
    /// `signalRegulations`: Rules for a type of signal.
    pub signal_regulations: Vec<SignalRegulation>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Rules for a type of road (`t_header_roadRegulation`; section 6.4; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RoadRegulation {
    /// The start tag.
    pub span: Span,
    /// `@type`: Kind. Required by the text since 1.8.
    pub r#type: Option<Attribute<RoadType>>,
    /// `semantics`: What a signal means.
    pub semantics: Option<Box<Semantics>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Rules for a type of signal (`t_header_signalRegulation`; section 6.4; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SignalRegulation {
    /// The start tag.
    pub span: Span,
    /// `@type`: Kind. Required by the text since 1.8.
    pub r#type: Option<Attribute<Box<str>>>,
    /// `@subtype`: Further distinction of the type. Required by the text since 1.8.
    pub subtype: Option<Attribute<Box<str>>>,
    /// `semantics`: What a signal means.
    pub semantics: Option<Box<Semantics>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
