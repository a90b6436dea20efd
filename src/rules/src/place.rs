//! Elements with what surrounds them.

use crate::line::ReferenceLine;
use mapd_xodr::{Lane, LaneSection, Lanes, LayerType, Object, Road, Signal, TrafficRule};

/// Side of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Positive lane ids.
    Left,
    /// Negative lane ids.
    Right,
}

/// A road and its reference line.
#[derive(Clone, Copy)]
pub struct RoadIn<'a> {
    /// The road.
    pub road: &'a Road,
    /// Its reference line.
    pub line: &'a ReferenceLine,
}

impl<'a> RoadIn<'a> {
    /// The sections of all layers.
    pub fn sections(&self) -> impl Iterator<Item = SectionIn<'a>> + use<'a> {
        let road = self.road;
        road.lanes.iter().flat_map(move |lanes| {
            let sections = lanes.lane_section.iter().enumerate();
            sections.map(move |(index, section)| SectionIn { road, lanes, section, index })
        })
    }
}

/// A lane section in its road.
#[derive(Clone, Copy)]
pub struct SectionIn<'a> {
    /// The road.
    pub road: &'a Road,
    /// The layer.
    pub lanes: &'a Lanes,
    /// The section.
    pub section: &'a LaneSection,
    /// Rank among the layer's sections.
    pub index: usize,
}

impl<'a> SectionIn<'a> {
    /// Where it begins `[m]`.
    pub fn s(&self) -> f64 {
        number(&self.section.s)
    }

    /// Where it ends: at its own length, the next section or the end of the road `[m]`.
    pub fn s_end(&self) -> f64 {
        if let Some(length) = &self.section.length {
            return self.s() + length.value;
        }
        let next = self.lanes.lane_section.get(self.index + 1);
        next.map_or(number(&self.road.length), |next| number(&next.s)).max(self.s())
    }

    /// Length `[m]`, not negative.
    pub fn length(&self) -> f64 {
        self.s_end() - self.s()
    }

    /// Whether it says what lies to a side. A section for one side only (`singleSide`) leaves the other as it was; one with
    /// lanes on both or none, the first of its road, and those of temporary lanes count for both.
    pub fn holds(&self, side: Side) -> bool {
        let is_temporary = value(&self.lanes.layer) == Some(LayerType::Temporary);
        value(&self.section.single_side) != Some(true)
            || self.index == 0
            || is_temporary
            || !self.side(side).is_empty()
            || (self.side(Side::Left).is_empty() && self.side(Side::Right).is_empty())
    }

    /// Where its lanes of a side end: at its own length, the next section that holds for the side, or the end of the road `[m]`.
    pub fn s_end_of(&self, side: Side) -> f64 {
        // The search ends at the next section that holds for the side: all of a road's together look at each section once.
        if self.section.length.is_some() || !self.holds(side) {
            return self.s_end();
        }
        let later = self.lanes.lane_section.iter().enumerate().skip(self.index + 1);
        let mut later = later.map(|(index, section)| SectionIn { section, index, ..*self });
        let next = later.find(|section| section.holds(side));
        next.map_or(number(&self.road.length), |next| next.s()).max(self.s())
    }

    /// Length of its lanes of a side `[m]`, not negative.
    pub fn length_of(&self, side: Side) -> f64 {
        self.s_end_of(side) - self.s()
    }

    /// Lanes of a side in file order.
    pub fn side(&self, side: Side) -> &'a [Lane] {
        let side = match side {
            Side::Left => &self.section.left,
            Side::Right => &self.section.right,
        };
        side.as_ref().map_or(&[], |side| &side.lane)
    }

    /// Lanes to the left and right in file order.
    pub fn lanes(&self) -> impl Iterator<Item = &'a Lane> + use<'a> {
        self.side(Side::Left).iter().chain(self.side(Side::Right))
    }

    /// Lanes of a side from the center outwards; of those as far out as one another, the first written comes first.
    pub fn outwards(&self, side: Side) -> impl Iterator<Item = &'a Lane> + use<'a> {
        let lanes = self.side(side);
        let number = |lane: &Lane| lane.id.map_or(0, |id| id.value).unsigned_abs();
        // Nearly all stand from the left to the right, so that nothing has to be sorted.
        let none = (&[][..], &[][..], Vec::new());
        let (forth, back, sorted) = if lanes.is_sorted_by_key(number) {
            (lanes, none.1, none.2)
        } else if lanes.is_sorted_by(|a, b| number(a) > number(b)) {
            (none.0, lanes, none.2)
        } else {
            let mut sorted: Vec<&Lane> = lanes.iter().collect();
            sorted.sort_by_key(|lane| number(lane));
            (none.0, none.1, sorted)
        };
        forth.iter().chain(back.iter().rev()).chain(sorted)
    }

    /// The lane of an id.
    pub fn lane(&self, id: i32) -> Option<&'a Lane> {
        self.lanes().find(|lane| lane.id.is_some_and(|own| own.value == id))
    }
}

/// A lane in its section.
#[derive(Clone, Copy)]
pub struct LaneIn<'a> {
    /// The section.
    pub section: SectionIn<'a>,
    /// The side.
    pub side: Side,
    /// The lane.
    pub lane: &'a Lane,
}

/// An object in its road or junction.
#[derive(Clone, Copy)]
pub struct ObjectIn<'a> {
    /// The road; none for an object of a junction.
    pub road: Option<&'a Road>,
    /// The object.
    pub object: &'a Object,
}

/// A signal in its road.
#[derive(Clone, Copy)]
pub struct SignalIn<'a> {
    /// The road.
    pub road: &'a Road,
    /// The signal.
    pub signal: &'a Signal,
}

/// Path of a lane, or of something in it, from its section.
pub(crate) fn lane_part(lane: &Lane, within: &str) -> String {
    match lane.id {
        Some(id) => format!("lane[@id={}]{within}", id.value),
        None => format!("lane{within}"),
    }
}

/// A number, or 0 where it is not there.
pub(crate) fn number(value: &Option<mapd_xodr::Attribute<f64>>) -> f64 {
    value.map_or(0.0, |value| value.value)
}

/// A text, or an empty one where it is not there.
pub(crate) fn text(value: &Option<mapd_xodr::Attribute<Box<str>>>) -> &str {
    value.as_ref().map_or("", |value| &value.value)
}

/// A value, where it is there.
pub(crate) fn value<T: Copy>(value: &Option<mapd_xodr::Attribute<T>>) -> Option<T> {
    value.as_ref().map(|value| value.value)
}

/// Whether traffic drives on the left.
pub(crate) fn is_left_hand(road: &Road) -> bool {
    value(&road.rule) == Some(TrafficRule::Lht)
}

/// The junction that a road names; none for -1 and nothing.
pub(crate) fn junction_of(road: &Road) -> Option<&str> {
    Some(text(&road.junction)).filter(|id| !id.is_empty() && *id != "-1")
}
