//! What is kept of roads, sections, lanes, and of whatever has or names an id.

use super::Name;
use mapd_xodr::{ElementDir, LaneDirection, LaneType, Span};
use std::ops::Range;

/// An end of a road.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Contact {
    /// Where s is 0.
    Start,
    /// Where s is the length.
    End,
}

/// What a road's link names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkTarget {
    /// A road.
    Road(Name),
    /// A junction.
    Junction(Name),
}

/// A link of a road as written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkFacts {
    /// The start tag.
    pub span: Span,
    /// What it names.
    pub target: LinkTarget,
    /// Which end of the target it touches.
    pub contact: Option<Contact>,
    /// In which direction it goes on there.
    pub dir: Option<ElementDir>,
    /// Where it touches a virtual junction's main road `[m]`.
    pub s: Option<f64>,
}

/// A road.
#[derive(Clone, Debug)]
pub struct RoadFacts {
    /// The start tag.
    pub span: Span,
    /// Length as written `[m]`.
    pub length: f64,
    /// Smallest x, smallest y, largest x, largest y of its surface `[m]`; empty where it has no cross-sections.
    pub bounds: [f64; 4],
    /// Predecessor and successor.
    pub links: [Option<LinkFacts>; 2],
    /// Rank among the roads.
    pub(super) rank: u32,
    /// Id.
    pub id: Name,
    /// Junction that it belongs to.
    pub junction: Option<Name>,
    pub(super) sections: Range<u32>,
    pub(super) stations: Range<u32>,
    /// One for each cross-section, or one for all.
    pub(super) profiles: Range<u32>,
    /// Only the first and the last of its cross-sections are kept.
    pub(super) is_straight: bool,
    /// Traffic drives on the left.
    pub is_left_hand: bool,
    /// It has surface data of its own.
    pub has_crg: bool,
    /// It has railway switches.
    pub has_switches: bool,
    /// It has elevations other than 0.
    pub has_elevation: bool,
}

impl RoadFacts {
    /// The link at an end.
    pub fn link(&self, end: Contact) -> Option<&LinkFacts> {
        self.links[end as usize].as_ref()
    }

    /// s of an end `[m]`.
    pub fn s_of(&self, end: Contact) -> f64 {
        match end {
            Contact::Start => 0.0,
            Contact::End => self.length,
        }
    }
}

/// The side of a lane: 0 to the left, 1 to the right.
fn side_of(id: i32) -> usize {
    usize::from(id < 0)
}

/// A lane section of the permanent layer.
#[derive(Clone, Debug)]
pub struct SectionFacts {
    /// The start tag.
    pub span: Span,
    /// Where it begins `[m]`.
    pub s: f64,
    /// Where its lanes end: to the left, to the right `[m]`.
    pub(super) ends: [f64; 2],
    /// Whether it says what lies to the left, to the right.
    pub(super) holds: [bool; 2],
    pub(super) lanes: Range<u32>,
}

impl SectionFacts {
    /// Where its lanes on the side of an id end `[m]`.
    pub fn s_end(&self, id: i32) -> f64 {
        self.ends[side_of(id)]
    }

    /// Whether it says what lies on the side of an id: one for the other side only does not. Lane 0 is on both.
    pub fn holds(&self, id: i32) -> bool {
        id == 0 || self.holds[side_of(id)]
    }

    /// Ranks of its lanes in [`Network::lanes`](super::Network::lanes).
    pub fn lane_ranks(&self) -> Range<usize> {
        self.lanes.start as usize..self.lanes.end as usize
    }
}

/// A lane to the left or right.
#[derive(Clone, Debug)]
pub struct LaneFacts {
    /// The start tag.
    pub span: Span,
    /// Id.
    pub id: i32,
    /// Inner border at the section's start and end: t `[m]`.
    pub inner: [f64; 2],
    /// Outer border at the section's start and end: t `[m]`.
    pub outer: [f64; 2],
    /// Where its predecessors begin in [`Network::lane_links`](super::Network::lane_links), its successors, and what comes
    /// behind them.
    pub(super) links: [u32; 3],
    /// Type.
    pub kind: LaneType,
    /// Direction of travel.
    pub direction: LaneDirection,
    /// It is kept level.
    pub is_level: bool,
}

impl LaneFacts {
    /// Width at an end of the section `[m]`.
    pub fn width(&self, end: Contact) -> f64 {
        (self.outer[end as usize] - self.inner[end as usize]).abs()
    }
}

/// A link of a lane.
#[derive(Clone, Copy, Debug)]
pub struct LaneLinkFacts {
    /// The start tag.
    pub span: Span,
    /// The lane that it names.
    pub id: i32,
}

impl LaneLinkFacts {
    pub(super) fn new(span: Span, id: i32) -> Self {
        Self { span, id }
    }
}

/// Kinds of parts whose ids form a class of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PartKind {
    /// `road`
    Road,
    /// `junction`
    Junction,
    /// `junctionGroup`
    JunctionGroup,
    /// `controller`
    Controller,
    /// `station`
    Station,
    /// `object`
    Object,
    /// `signal`
    Signal,
    /// `sign` on a board
    Sign,
    /// `tunnel`
    Tunnel,
    /// `bridge`
    Bridge,
    /// `switch`
    Switch,
    /// `vmsGroup`
    VmsGroup,
}

impl PartKind {
    /// All of them in their order.
    pub const ALL: [Self; 12] = [
        Self::Road,
        Self::Junction,
        Self::JunctionGroup,
        Self::Controller,
        Self::Station,
        Self::Object,
        Self::Signal,
        Self::Sign,
        Self::Tunnel,
        Self::Bridge,
        Self::Switch,
        Self::VmsGroup,
    ];

    /// A bit of its own.
    pub(crate) fn bit(self) -> u16 {
        1 << self as u16
    }

    /// Name of the element.
    pub fn name(self) -> &'static str {
        match self {
            Self::Road => "road",
            Self::Junction => "junction",
            Self::JunctionGroup => "junctionGroup",
            Self::Controller => "controller",
            Self::Station => "station",
            Self::Object => "object",
            Self::Signal => "signal",
            Self::Sign => "sign",
            Self::Tunnel => "tunnel",
            Self::Bridge => "bridge",
            Self::Switch => "switch",
            Self::VmsGroup => "vmsGroup",
        }
    }
}

/// Something with an id.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// The start tag.
    pub span: Span,
    /// Its id.
    pub id: Name,
    /// Rank of the road that it stands along, or the largest number there is.
    pub(super) road: u32,
    /// What it is.
    pub kind: PartKind,
}

impl Part {
    pub(super) fn new(kind: PartKind, id: Name, span: Span, road: Option<u32>) -> Self {
        Self { span, id, road: road.unwrap_or(u32::MAX), kind }
    }

    /// Moves its road by so many places, and gives it the id's number in the whole.
    pub(super) fn moved(self, roads: u32, id: Name) -> Self {
        let is_along = self.road != u32::MAX;
        let road = if is_along { self.road.saturating_add(roads) } else { self.road };
        Self { id, road, ..self }
    }
}
