//! Elements of `signals`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/signals.toml; change that file instead.

#[allow(unused_imports, reason = "each part needs some")]
use super::*;
#[allow(unused_imports, reason = "each part needs some")]
use crate::attribute::{Attribute, PositionOrEnd, SpeedLimit};
use crate::extension::Extensions;
use crate::finding::Span;

/// Signals along a road (`t_road_signals`; section 14).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Signals {
    /// The start tag.
    pub span: Span,
    /// `signal`: A sign, light or marking that tells traffic something.
    pub signal: Vec<Signal>,
    /// `signalReference`: A signal of another road that concerns this one too.
    pub signal_reference: Vec<SignalReference>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A sign, light or marking that tells traffic something (`t_road_signals_signal_road`; section 14).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Signal {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@dynamic`: Whether its state changes. Required since 1.5.
    pub dynamic: Option<Attribute<bool>>,
    /// `@orientation`: Direction of travel that it is for: along s, against s, both. Required since 1.5.
    pub orientation: Option<Attribute<Orientation>>,
    /// `@country`: Country whose rules hold: two or three letters, or a name in older versions.
    pub country: Option<Attribute<Box<str>>>,
    /// `@countryRevision`: Year of the country's catalogue of signs. Since 1.5.
    pub country_revision: Option<Attribute<Box<str>>>,
    /// `@type`: Kind. Required since 1.5.
    pub r#type: Option<Attribute<Box<str>>>,
    /// `@subtype`: Further distinction of the type. Required since 1.5.
    pub subtype: Option<Attribute<Box<str>>>,
    /// `@value`: Value.
    pub value: Option<Attribute<f64>>,
    /// `@text`: Text shown.
    pub text: Option<Attribute<Box<str>>>,
    /// `@unit`: Unit of the value.
    pub unit: Option<Attribute<Unit>>,
    /// `@height` `[m]`: Height. At least 0 since 1.5. Required in 1.5.
    pub height: Option<Attribute<f64>>,
    /// `@length` `[m]`: Length. At least 0. Since 1.8.
    pub length: Option<Attribute<f64>>,
    /// `@hOffset` `[rad]`: Heading relative to the reference line.
    pub h_offset: Option<Attribute<f64>>,
    /// `@width` `[m]`: Width. At least 0 since 1.5. Required in 1.5.
    pub width: Option<Attribute<f64>>,
    /// `@roll` `[rad]`: Roll.
    pub roll: Option<Attribute<f64>>,
    /// `@pitch` `[rad]`: Pitch.
    pub pitch: Option<Attribute<f64>>,
    /// `@invalidated`: Whether it no longer holds. Since 1.9.
    pub invalidated: Option<Attribute<bool>>,
    /// `@temporary`: Whether it stands for a limited time. Since 1.9.
    pub temporary: Option<Attribute<bool>>,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required 1.5 to 1.7. Required by the text since 1.8.
    pub s: Option<Attribute<f64>>,
    /// `@t` `[m]`: Lateral distance from the reference line, positive to the left. Required 1.5 to 1.7. Required by the text since 1.8.
    pub t: Option<Attribute<f64>>,
    /// `@zOffset` `[m]`: Height above the reference line. Required 1.5 to 1.7. Required by the text since 1.8.
    pub z_offset: Option<Attribute<f64>>,
    /// `validity`: Lanes for which it holds.
    pub validity: Vec<LaneValidity>,
    /// `dependency`: A signal that this one controls or depends on.
    pub dependency: Vec<SignalDependency>,
    /// `reference`: An object or signal that belongs to the signal. Since 1.5.
    pub reference: Vec<SignalLink>,
    /// `positionInertial`: Where the signal stands, in inertial coordinates. Since 1.5.
    pub position_inertial: Option<Box<PositionInertial>>,
    /// `positionRoad`: Where the signal stands, in road coordinates. Since 1.5.
    pub position_road: Option<Box<PositionRoad>>,
    /// `semantics`: What a signal means. Since 1.8.
    pub semantics: Option<Box<Semantics>>,
    /// `staticBoard`: A board of signs. Since 1.8.
    pub static_board: Vec<StaticBoard>,
    /// `vmsBoard`: A variable message board. Since 1.8.
    pub vms_board: Vec<VmsBoard>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A signal that this one controls or depends on (`t_road_signals_signal_dependency`; section 14).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SignalDependency {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@type`: Kind.
    pub r#type: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// An object or signal that belongs to the signal (`t_road_signals_signal_reference`; section 14; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SignalLink {
    /// The start tag.
    pub span: Span,
    /// `@elementType`: Kind of what is linked. Required.
    pub element_type: Option<Attribute<ReferenceElementType>>,
    /// `@elementId`: Identifier of what is linked. Required.
    pub element_id: Option<Attribute<Box<str>>>,
    /// `@type`: Kind.
    pub r#type: Option<Attribute<Box<str>>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Where the signal stands, in inertial coordinates (`t_road_signals_signal_positionInertial`; section 14; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PositionInertial {
    /// The start tag.
    pub span: Span,
    /// `@x` `[m]`: Inertial x. Required.
    pub x: Option<Attribute<f64>>,
    /// `@y` `[m]`: Inertial y. Required.
    pub y: Option<Attribute<f64>>,
    /// `@z` `[m]`: Height coordinate. Required.
    pub z: Option<Attribute<f64>>,
    /// `@hdg` `[rad]`: Heading. Required.
    pub hdg: Option<Attribute<f64>>,
    /// `@pitch` `[rad]`: Pitch.
    pub pitch: Option<Attribute<f64>>,
    /// `@roll` `[rad]`: Roll.
    pub roll: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Where the signal stands, in road coordinates (`t_road_signals_signal_positionRoad`; section 14; since 1.5).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PositionRoad {
    /// The start tag.
    pub span: Span,
    /// `@roadId`: Road that is meant. Required.
    pub road_id: Option<Attribute<Box<str>>>,
    /// `@s` `[m]`: Distance along the reference line. At least 0. Required.
    pub s: Option<Attribute<f64>>,
    /// `@t` `[m]`: Lateral distance from the reference line, positive to the left. Required.
    pub t: Option<Attribute<f64>>,
    /// `@zOffset` `[m]`: Height above the reference line. Required.
    pub z_offset: Option<Attribute<f64>>,
    /// `@hOffset` `[rad]`: Heading relative to the reference line. Required.
    pub h_offset: Option<Attribute<f64>>,
    /// `@pitch` `[rad]`: Pitch.
    pub pitch: Option<Attribute<f64>>,
    /// `@roll` `[rad]`: Roll.
    pub roll: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A board of signs (`t_road_signals_staticBoard`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StaticBoard {
    /// The start tag.
    pub span: Span,
    /// `validity`: Lanes for which it holds.
    pub validity: Vec<LaneValidity>,
    /// `dependency`: A signal that this one controls or depends on.
    pub dependency: Vec<SignalDependency>,
    /// `reference`: An object or signal that belongs to the signal.
    pub reference: Vec<SignalLink>,
    /// `sign`: A sign on a board.
    pub sign: Vec<BoardSign>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A sign on a board (`t_road_signals_board_sign`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BoardSign {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required.
    pub id: Option<Attribute<Box<str>>>,
    /// `@name`: Name for people.
    pub name: Option<Attribute<Box<str>>>,
    /// `@dynamic`: Whether its state changes. Required.
    pub dynamic: Option<Attribute<bool>>,
    /// `@orientation`: Direction of travel that it is for: along s, against s, both. Required.
    pub orientation: Option<Attribute<Orientation>>,
    /// `@country`: Country whose rules hold: two or three letters, or a name in older versions.
    pub country: Option<Attribute<Box<str>>>,
    /// `@countryRevision`: Year of the country's catalogue of signs.
    pub country_revision: Option<Attribute<Box<str>>>,
    /// `@type`: Kind. Required.
    pub r#type: Option<Attribute<Box<str>>>,
    /// `@subtype`: Further distinction of the type. Required.
    pub subtype: Option<Attribute<Box<str>>>,
    /// `@value`: Value.
    pub value: Option<Attribute<f64>>,
    /// `@text`: Text shown.
    pub text: Option<Attribute<Box<str>>>,
    /// `@unit`: Unit of the value.
    pub unit: Option<Attribute<Unit>>,
    /// `@height` `[m]`: Height. At least 0.
    pub height: Option<Attribute<f64>>,
    /// `@length` `[m]`: Length. At least 0.
    pub length: Option<Attribute<f64>>,
    /// `@hOffset` `[rad]`: Heading relative to the reference line.
    pub h_offset: Option<Attribute<f64>>,
    /// `@width` `[m]`: Width. At least 0.
    pub width: Option<Attribute<f64>>,
    /// `@roll` `[rad]`: Roll.
    pub roll: Option<Attribute<f64>>,
    /// `@pitch` `[rad]`: Pitch.
    pub pitch: Option<Attribute<f64>>,
    /// `@invalidated`: Whether it no longer holds. Since 1.9.
    pub invalidated: Option<Attribute<bool>>,
    /// `@temporary`: Whether it stands for a limited time. Since 1.9.
    pub temporary: Option<Attribute<bool>>,
    /// `@v` `[m]`: Lateral coordinate in the local frame. Required by the text since 1.8.
    pub v: Option<Attribute<f64>>,
    /// `@z` `[m]`: Height coordinate. Required by the text since 1.8.
    pub z: Option<Attribute<f64>>,
    /// `validity`: Lanes for which it holds.
    pub validity: Vec<LaneValidity>,
    /// `dependency`: A signal that this one controls or depends on.
    pub dependency: Vec<SignalDependency>,
    /// `reference`: An object or signal that belongs to the signal.
    pub reference: Vec<SignalLink>,
    /// `positionInertial`: Where the signal stands, in inertial coordinates.
    pub position_inertial: Option<Box<PositionInertial>>,
    /// `positionRoad`: Where the signal stands, in road coordinates.
    pub position_road: Option<Box<PositionRoad>>,
    /// `semantics`: What a signal means.
    pub semantics: Option<Box<Semantics>>,
    /// `staticBoard`: A board of signs. In 1.8.
    pub static_board: Vec<StaticBoard>,
    /// `vmsBoard`: A variable message board. In 1.8.
    pub vms_board: Vec<VmsBoard>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A variable message board (`t_road_signals_vmsBoard`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VmsBoard {
    /// The start tag.
    pub span: Span,
    /// `@displayHeight` `[m]`: Height of the display.
    pub display_height: Option<Attribute<f64>>,
    /// `@displayType`: Technology of the display. Required by the text since 1.8.
    pub display_type: Option<Attribute<DisplayType>>,
    /// `@displayWidth` `[m]`: Width of the display.
    pub display_width: Option<Attribute<f64>>,
    /// `@v` `[m]`: Lateral coordinate in the local frame. Required by the text since 1.8.
    pub v: Option<Attribute<f64>>,
    /// `@z` `[m]`: Height coordinate. Required by the text since 1.8.
    pub z: Option<Attribute<f64>>,
    /// `validity`: Lanes for which it holds.
    pub validity: Vec<LaneValidity>,
    /// `dependency`: A signal that this one controls or depends on.
    pub dependency: Vec<SignalDependency>,
    /// `reference`: An object or signal that belongs to the signal.
    pub reference: Vec<SignalLink>,
    /// `displayArea`: A part of a variable message board.
    pub display_area: Vec<DisplayArea>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A part of a variable message board (`t_road_signals_displayArea`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DisplayArea {
    /// The start tag.
    pub span: Span,
    /// `@height` `[m]`: Height. Required by the text since 1.8.
    pub height: Option<Attribute<Box<str>>>,
    /// `@index`: Number of the area. Required by the text since 1.8.
    pub index: Option<Attribute<i32>>,
    /// `@v` `[m]`: Lateral coordinate in the local frame. Required by the text since 1.8.
    pub v: Option<Attribute<f64>>,
    /// `@width` `[m]`: Width. Required by the text since 1.8.
    pub width: Option<Attribute<Box<str>>>,
    /// `@z` `[m]`: Height coordinate. Required by the text since 1.8.
    pub z: Option<Attribute<f64>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A signal of another road that concerns this one too (`t_road_signals_signalReference`; section 14).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SignalReference {
    /// The start tag.
    pub span: Span,
    /// `@s` `[m]`: Distance along the reference line. At least 0 since 1.5. Required since 1.5.
    pub s: Option<Attribute<f64>>,
    /// `@t` `[m]`: Lateral distance from the reference line, positive to the left. Required since 1.5.
    pub t: Option<Attribute<f64>>,
    /// `@id`: Identifier, unique among its kind. Required since 1.5.
    pub id: Option<Attribute<Box<str>>>,
    /// `@orientation`: Direction of travel that it is for: along s, against s, both. Required since 1.5.
    pub orientation: Option<Attribute<Orientation>>,
    /// `validity`: Lanes for which it holds.
    pub validity: Vec<LaneValidity>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// Variable message boards that work together (`t_signalGroup_vmsGroup`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VmsGroup {
    /// The start tag.
    pub span: Span,
    /// `@id`: Identifier, unique among its kind. Required by the text since 1.8.
    pub id: Option<Attribute<Box<str>>>,
    /// `vmsBoardReference`: A board of a group.
    pub vms_board_reference: Vec<VmsBoardReference>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}

/// A board of a group (`t_signalGroup_vmsBoardReference`; section 14; since 1.8).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VmsBoardReference {
    /// The start tag.
    pub span: Span,
    /// `@signalId`: Signal that is meant. Required by the text since 1.8.
    pub signal_id: Option<Attribute<Box<str>>>,
    /// `@vmsIndex`: Number of the board at the signal. Required by the text since 1.8.
    pub vms_index: Option<Attribute<i32>>,
    /// `@groupIndex`: Rank in the group. Required by the text since 1.8.
    pub group_index: Option<Attribute<i32>>,
    /// What stands inside beyond the standard's own elements.
    pub extensions: Extensions,
}
