//! What is kept of roads, sections, lanes, and of whatever has or names an id.

use super::{NONE, Name};
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
    /// Lanes of it have links.
    pub(super) has_lane_links: bool,
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

/// A road that the rules do not look at, because its reference line alone is built.
#[derive(Clone, Copy, Debug)]
pub struct RoadApart {
    /// The start tag.
    pub span: Span,
    /// Id.
    pub id: Name,
    /// Junction that it belongs to.
    pub junction: Option<Name>,
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
    /// Rank in its road of the last section before it that says what lies to the left, to the right.
    pub(super) before: [u32; 2],
    /// Rank in its road of the first section behind it that does.
    pub(super) behind: [u32; 2],
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

    /// Rank in its road, from its own, of the nearest section towards an end that says what lies on the side of an id; there need
    /// be none of that rank.
    pub(super) fn next(&self, own: usize, end: Contact, id: i32) -> Option<usize> {
        match (end, id) {
            (Contact::Start, 0) => own.checked_sub(1),
            (Contact::End, 0) => own.checked_add(1),
            (Contact::Start, id) => Some(self.before[side_of(id)] as usize),
            (Contact::End, id) => Some(self.behind[side_of(id)] as usize),
        }
    }

    /// Tells the sections of a road of each other.
    pub(super) fn join(road: &mut [Self]) {
        let ranks = 0..road.len();
        Self::pass(road, ranks.clone(), |section| &mut section.before);
        Self::pass(road, ranks.rev(), |section| &mut section.behind);
    }

    fn pass(
        road: &mut [Self],
        ranks: impl Iterator<Item = usize>,
        passed: impl Fn(&mut Self) -> &mut [u32; 2],
    ) {
        let mut last = [NONE; 2];
        for rank in ranks {
            let Some(section) = road.get_mut(rank) else { continue };
            *passed(section) = last;
            for (last, holds) in last.iter_mut().zip(section.holds) {
                if holds {
                    *last = rank as u32;
                }
            }
        }
    }

    /// Ranks of its lanes in [`Network::lanes`](super::Network::lanes).
    pub fn lane_ranks(&self) -> Range<usize> {
        self.lanes.start as usize..self.lanes.end as usize
    }
}

/// Rank of the first row of an id among rows by falling id.
pub(super) fn rank_of<T>(rows: &[T], id: i32, id_of: impl Fn(&T) -> i32) -> Option<usize> {
    let at = rows.partition_point(|row| id_of(row) > id);
    rows.get(at).is_some_and(|row| id_of(row) == id).then_some(at)
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
    /// It names one of the temporary layer (1.9): no link between permanent lanes.
    pub to_temporary: bool,
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
pub struct IdentifiedPart {
    /// The start tag.
    pub span: Span,
    /// Its id.
    pub id: Name,
    /// Rank of the road that it stands along, or the largest number there is.
    pub(super) road: u32,
    /// What it is.
    pub kind: PartKind,
}

impl IdentifiedPart {
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    /// All rows of a section were looked at for each lane and for each link to one.
    #[test]
    fn a_lane_is_found_with_few_looks() {
        let ids: Vec<i32> = (-30_000..30_000).rev().flat_map(|id| [2 * id; 2]).collect();
        let looks = Cell::new(0);
        let find = |id: i32| {
            looks.set(0);
            let found = rank_of(&ids, id, |own| {
                looks.set(looks.get() + 1);
                *own
            });
            assert!(looks.get() <= 20, "{} looks at {} rows", looks.get(), ids.len());
            found
        };
        for id in (-60_010..60_010).step_by(7) {
            assert_eq!(find(id), ids.iter().position(|own| *own == id), "{id}");
        }
    }

    /// The sections between one and the next that says what lies on a side were passed one by one.
    #[test]
    fn sections_know_the_next_one_that_says_what_lies_on_a_side() {
        let held = [[true, true], [true, false], [false, true], [true, false], [true, false]];
        let section = |holds: [bool; 2]| SectionFacts {
            span: Span::default(),
            s: 0.0,
            ends: [0.0; 2],
            holds,
            before: [0; 2],
            behind: [0; 2],
            lanes: 0..0,
        };
        let mut road = held.map(section);
        SectionFacts::join(&mut road);
        for (own, section) in road.iter().enumerate() {
            for id in [-1, 0, 1] {
                let holds = |rank: &usize| road[*rank].holds(id);
                let is_there = |rank: &usize| *rank < road.len();
                let before = section.next(own, Contact::Start, id).filter(is_there);
                assert_eq!(before, (0..own).rev().find(holds), "before {own}, {id}");
                let behind = section.next(own, Contact::End, id).filter(is_there);
                assert_eq!(behind, (own + 1..road.len()).find(holds), "behind {own}, {id}");
            }
        }
    }
}
