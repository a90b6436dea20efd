//! The common core of OpenDRIVE as written. Each `span` is the element's start tag.

use crate::finding::Span;
use crate::names::{LaneKind, RoadTypeKind};

/// `header` (OpenDRIVE 1.8.1, 6.4).
#[derive(Clone, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Header {
    pub rev_major: Option<u16>,
    pub rev_minor: Option<u16>,
    pub name: String,
    pub version: String,
    pub date: String,
    pub vendor: String,
    pub north: Option<f64>,
    pub south: Option<f64>,
    pub east: Option<f64>,
    pub west: Option<f64>,
    /// Text of `geoReference`, trimmed.
    pub geo_reference: Option<String>,
    pub offset: Option<HeaderOffset>,
    pub span: Span,
}

/// `header/offset` (1.5 and later).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct HeaderOffset {
    pub x: f64,
    pub y: f64,
    pub z: f64,
    pub hdg: f64,
    pub span: Span,
}

/// Side of the road on which traffic drives (`road/@rule`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TrafficRule {
    /// RHT.
    #[default]
    RightHand,
    /// LHT.
    LeftHand,
}

/// `road` (1.8.1, 10).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Road {
    /// `@id`, verbatim.
    pub id: String,
    /// `@name`.
    pub name: String,
    /// `@length` `[m]`.
    pub length: f64,
    /// `@junction`; none where it is absent, empty or -1.
    pub junction: Option<String>,
    /// `@rule`.
    pub rule: TrafficRule,
    /// `link/predecessor`.
    pub predecessor: Option<RoadLink>,
    /// `link/successor`.
    pub successor: Option<RoadLink>,
    /// `type`.
    pub types: Vec<RoadType>,
    /// `planView/geometry`.
    pub plan_view: Vec<Geometry>,
    /// `elevationProfile/elevation` `[m]`.
    pub elevations: Vec<CubicRecord>,
    /// `lateralProfile/superelevation` `[rad]`.
    pub superelevations: Vec<CubicRecord>,
    /// `lanes/laneOffset` `[m]`.
    pub lane_offsets: Vec<CubicRecord>,
    /// `lanes/laneSection`.
    pub sections: Vec<LaneSection>,
    /// Elements that shape the surface but are not read yet.
    pub unsupported: Vec<&'static str>,
    /// The start tag.
    pub span: Span,
}

/// What a road link names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkElement {
    /// A road.
    Road,
    /// A junction.
    Junction,
}

/// End of a road.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactPoint {
    /// s = 0.
    Start,
    /// s = length.
    End,
}

/// Direction along a road.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Towards +s.
    Plus,
    /// Towards −s.
    Minus,
}

/// `road/link/predecessor` or `successor` (1.8.1, 10.3).
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct RoadLink {
    pub element_type: LinkElement,
    pub element_id: String,
    pub contact_point: Option<ContactPoint>,
    /// `[m]`, of virtual junctions.
    pub element_s: Option<f64>,
    pub element_dir: Option<Direction>,
    pub span: Span,
}

/// `road/type` (1.8.1, 10.4).
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct RoadType {
    pub s: f64,
    pub kind: RoadTypeKind,
    pub country: String,
    pub speed: Option<Speed>,
    pub span: Span,
}

/// What `@max` of a speed record says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpeedMax {
    /// A number in the record's unit.
    Value(f64),
    /// `no limit`.
    NoLimit,
    /// `undefined`.
    Undefined,
}

/// Unit of a speed record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpeedUnit {
    /// m/s, also where no unit is given.
    MetersPerSecond,
    /// km/h.
    KilometersPerHour,
    /// mph.
    MilesPerHour,
}

/// `speed` of a road type or a lane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Speed {
    pub max: SpeedMax,
    pub unit: SpeedUnit,
    pub span: Span,
}

impl Speed {
    /// The limit `[m/s]`, if there is one.
    pub fn meters_per_second(&self) -> Option<f64> {
        let SpeedMax::Value(value) = self.max else { return None };
        Some(match self.unit {
            SpeedUnit::MetersPerSecond => value,
            SpeedUnit::KilometersPerHour => value / 3.6,
            SpeedUnit::MilesPerHour => value * 0.44704,
        })
    }
}

/// `planView/geometry` (1.8.1, 9.2).
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Geometry {
    pub s: f64,
    pub x: f64,
    pub y: f64,
    pub hdg: f64,
    pub length: f64,
    pub shape: GeometryShape,
    pub span: Span,
}

/// `paramPoly3/@pRange`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PRange {
    /// p ∈ [0, length].
    ArcLength,
    /// p ∈ [0, 1].
    Normalized,
}

/// The shape child of a geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum GeometryShape {
    Line,
    Arc {
        curvature: f64,
    },
    Spiral {
        curv_start: f64,
        curv_end: f64,
    },
    Poly3 {
        a: f64,
        b: f64,
        c: f64,
        d: f64,
    },
    ParamPoly3 {
        au: f64,
        bu: f64,
        cu: f64,
        du: f64,
        av: f64,
        bv: f64,
        cv: f64,
        dv: f64,
        p_range: Option<PRange>,
    },
}

/// A record a + b·ds + c·ds² + d·ds³. `s` is `@s` or `@sOffset` as written.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct CubicRecord {
    pub s: f64,
    pub a: f64,
    pub b: f64,
    pub c: f64,
    pub d: f64,
    pub span: Span,
}

/// `lanes/laneSection` (1.8.1, 11.3).
#[derive(Clone, Debug, PartialEq)]
pub struct LaneSection {
    /// `@s` `[m]`.
    pub s: f64,
    /// `@singleSide`.
    pub single_side: bool,
    /// All lanes in file order.
    pub lanes: Vec<Lane>,
    /// The start tag.
    pub span: Span,
}

/// Group that a lane stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Side {
    Left,
    Center,
    Right,
}

/// `lane/@direction` (1.8).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum LaneDirection {
    #[default]
    Standard,
    Reversed,
    Both,
}

/// `lane` (1.8.1, 11.4 to 11.9).
#[derive(Clone, Debug, PartialEq)]
pub struct Lane {
    /// `@id`.
    pub id: i32,
    /// `@type`.
    pub kind: LaneKind,
    /// `@level`.
    pub level: bool,
    /// `@direction`.
    pub direction: LaneDirection,
    /// `link/predecessor`.
    pub predecessors: Vec<LinkedLane>,
    /// `link/successor`.
    pub successors: Vec<LinkedLane>,
    /// `roadMark`, as far as lane changes go.
    pub road_marks: Vec<RoadMark>,
    /// `access`.
    pub accesses: Vec<LaneAccess>,
    /// `width`.
    pub widths: Vec<CubicRecord>,
    /// `border`.
    pub borders: Vec<CubicRecord>,
    /// `speed`.
    pub speeds: Vec<LaneSpeed>,
    /// Group that the lane stands in.
    pub side: Side,
    /// The start tag.
    pub span: Span,
}

/// `lane/link/predecessor` or `successor` (1.8.1, 11.5).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub struct LinkedLane {
    pub id: i32,
    pub span: Span,
}

/// `roadMark/@laneChange` (1.8.1, 11.9).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum LaneChange {
    Increase,
    Decrease,
    #[default]
    Both,
    None,
}

/// `lane/roadMark` (1.8.1, 11.9).
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct RoadMark {
    pub s: f64,
    pub lane_change: LaneChange,
    pub span: Span,
}

/// `lane/access` (1.8.1, 11.8.1).
#[derive(Clone, Debug, PartialEq)]
pub struct LaneAccess {
    /// `@sOffset` `[m]`.
    pub s: f64,
    /// `@rule` is `allow`.
    pub allow: bool,
    /// `@restriction` and `restriction/@type`, verbatim.
    pub restrictions: Vec<String>,
    /// The start tag.
    pub span: Span,
}

/// `lane/speed` (1.8.1, 11.9).
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct LaneSpeed {
    pub s: f64,
    pub speed: Speed,
    pub span: Span,
}

/// `junction/@type`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum JunctionKind {
    #[default]
    Default,
    Direct,
    Virtual,
    Crossing,
}

/// `junction` (1.8.1, 12).
#[derive(Clone, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Junction {
    pub id: String,
    pub name: String,
    pub kind: JunctionKind,
    pub connections: Vec<Connection>,
    pub span: Span,
}

/// `junction/connection` (1.8.1, 12.4).
#[derive(Clone, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Connection {
    pub id: String,
    pub incoming_road: String,
    pub connecting_road: Option<String>,
    pub linked_road: Option<String>,
    pub contact_point: Option<ContactPoint>,
    pub lane_links: Vec<LaneLink>,
    pub span: Span,
}

/// `connection/laneLink`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub struct LaneLink {
    pub from: i32,
    pub to: i32,
    pub span: Span,
}
