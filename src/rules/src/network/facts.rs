//! What is kept of roads, sections, lanes, and of whatever has or names an id.

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
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LinkTarget {
    /// A road.
    Road(Box<str>),
    /// A junction.
    Junction(Box<str>),
}

/// A link of a road as written.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkFacts {
    /// The start tag.
    pub span: Span,
    /// What it names.
    pub target: LinkTarget,
    /// Which end of the target it touches.
    pub contact: Option<Contact>,
    /// Where it touches a virtual junction's main road `[m]`.
    pub s: Option<f64>,
    /// In which direction it goes on there.
    pub dir: Option<ElementDir>,
}

/// A road.
#[derive(Clone, Debug)]
pub struct RoadFacts {
    /// The start tag.
    pub span: Span,
    /// Rank among the roads.
    pub rank: usize,
    /// Id.
    pub id: Box<str>,
    /// Junction that it belongs to.
    pub junction: Option<Box<str>>,
    /// Length as written `[m]`.
    pub length: f64,
    /// Traffic drives on the left.
    pub is_left_hand: bool,
    /// Predecessor and successor.
    pub links: [Option<LinkFacts>; 2],
    /// Its sections in [`Network::sections`](super::Network::sections), permanent layer.
    pub sections: Range<usize>,
    /// Its cross-sections in [`Network::stations`](super::Network::stations).
    pub stations: Range<usize>,
    /// Smallest x, smallest y, largest x, largest y of its surface `[m]`; empty where it has no cross-sections.
    pub bounds: [f64; 4],
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

/// A lane section of the permanent layer.
#[derive(Clone, Debug)]
pub struct SectionFacts {
    /// The start tag.
    pub span: Span,
    /// Where it begins `[m]`.
    pub s: f64,
    /// Where it ends `[m]`.
    pub s_end: f64,
    /// Its lanes in [`Network::lanes`](super::Network::lanes).
    pub lanes: Range<usize>,
}

/// A lane to the left or right.
#[derive(Clone, Debug)]
pub struct LaneFacts {
    /// The start tag.
    pub span: Span,
    /// Id.
    pub id: i32,
    /// Type.
    pub kind: LaneType,
    /// Direction of travel.
    pub direction: LaneDirection,
    /// It is kept level.
    pub is_level: bool,
    /// Width at the section's start and end `[m]`.
    pub widths: [f64; 2],
    /// Inner border at the section's start and end: t `[m]`.
    pub inner: [f64; 2],
    /// Outer border at the section's start and end: t `[m]`.
    pub outer: [f64; 2],
    /// Predecessors and successors in [`Network::lane_links`](super::Network::lane_links).
    pub links: [Range<usize>; 2],
}

/// A link of a lane.
#[derive(Clone, Copy, Debug)]
pub struct LaneLinkFacts {
    /// The start tag.
    pub span: Span,
    /// The lane that it names.
    pub id: i32,
}

/// A cross-section of a road.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Distance along the reference line `[m]`.
    pub s: f64,
    /// Reference line: x `[m]`.
    pub x: f64,
    /// Reference line: y `[m]`.
    pub y: f64,
    /// Reference line: heading `[rad]`, continuous along the road as far as the file has it so.
    pub hdg: f64,
    /// Reference line: z `[m]`.
    pub z: f64,
    /// Superelevation `[rad]`.
    pub roll: f64,
    /// t of the outermost border to the left `[m]`.
    pub left: f64,
    /// t of the outermost border to the right `[m]`.
    pub right: f64,
}

impl Station {
    /// Linear between two.
    pub fn between(&self, other: &Self, s: f64) -> Self {
        let span = other.s - self.s;
        let part = if span > 0.0 { (s - self.s) / span } else { 0.0 };
        let part = mapd_geometry::clamp(part, 0.0, 1.0);
        let mix = |a: f64, b: f64| a + part * (b - a);
        Self {
            s: mix(self.s, other.s),
            x: mix(self.x, other.x),
            y: mix(self.y, other.y),
            hdg: mix(self.hdg, other.hdg),
            z: mix(self.z, other.z),
            roll: mix(self.roll, other.roll),
            left: mix(self.left, other.left),
            right: mix(self.right, other.right),
        }
    }

    /// The point at a lateral distance `[m]`.
    pub fn at(&self, t: f64) -> [f64; 2] {
        let (cos, sin) = mapd_geometry::cos_sin(self.hdg);
        [self.x - t * sin, self.y + t * cos]
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
#[derive(Clone, Debug)]
pub struct Part {
    /// What it is.
    pub kind: PartKind,
    /// Its id.
    pub id: Box<str>,
    /// The start tag.
    pub span: Span,
    /// Rank of the road that it stands along.
    pub road: Option<usize>,
}

/// Something that names an id.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Kinds of what may be meant.
    pub kinds: &'static [PartKind],
    /// The id that is named.
    pub id: Box<str>,
    /// Element and attribute, as a path names them.
    pub what: &'static str,
    /// Name of the element that `what` is a path from.
    pub element: &'static str,
    /// Its id.
    pub from: Box<str>,
    /// The start tag.
    pub span: Span,
}

impl Reference {
    /// Where it stands: elements from the root, with the id of the one that has one.
    pub fn path(&self) -> String {
        let Self { what, element, from, .. } = self;
        // What stands along a road, by its kind alone.
        let above = match *element {
            "signal" => "road/signals/",
            "switch" => "road/railroad/",
            _ => "",
        };
        let within = what.strip_prefix(element).and_then(|rest| rest.strip_prefix('/'));
        format!("OpenDRIVE/{above}{element}[@id={from}]/{}", within.unwrap_or(what))
    }
}
