//! Cubic records along a road or section: which holds where, and its value.

use crate::place::{SectionIn, Side, number};
use mapd_geometry::Cubic;
use mapd_xodr::{Attribute, Lane, Road};

/// A record `a + b·ds + c·ds² + d·ds³` that holds from `s` on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Record {
    /// Where it begins `[m]`.
    pub(crate) s: f64,
    pub(crate) cubic: Cubic,
}

type Number = Option<Attribute<f64>>;

impl Record {
    pub(crate) fn new(s: &Number, [a, b, c, d]: [&Number; 4]) -> Self {
        Self { s: number(s), cubic: Cubic::new([number(a), number(b), number(c), number(d)]) }
    }
}

/// Makes a record of an element with coefficients.
macro_rules! record {
    ($element:expr, $s:ident) => {{
        let e = $element;
        $crate::profile::Record::new(&e.$s, [&e.a, &e.b, &e.c, &e.d])
    }};
}
pub(crate) use record;

/// The value at `s`: of the last record that begins at or before it, else 0.
pub(crate) fn value_at(records: impl Iterator<Item = Record>, s: f64) -> f64 {
    let holds = records.filter(|record| record.s <= s).last();
    holds.map_or(0.0, |record| record.cubic.value(s - record.s))
}

/// Height of the reference line at `s` `[m]`.
pub(crate) fn elevation_at(road: &Road, s: f64) -> f64 {
    let records = road.elevation_profile.iter().flat_map(|profile| &profile.elevation);
    value_at(records.map(|e| record!(e, s)), s)
}

/// Superelevation at `s` `[rad]`.
pub(crate) fn superelevation_at(road: &Road, s: f64) -> f64 {
    let records = road.lateral_profile.iter().flat_map(|profile| &profile.superelevation);
    value_at(records.map(|e| record!(e, s)), s)
}

/// Offset of lane 0 at `s` `[m]`.
pub(crate) fn lane_offset_at(section: &SectionIn<'_>, s: f64) -> f64 {
    value_at(section.lanes.lane_offset.iter().map(|e| record!(e, s)), s)
}

/// Width of a lane at a distance from its section's start `[m]`; none where it has borders instead.
pub(crate) fn width_at(lane: &Lane, ds: f64) -> Option<f64> {
    if lane.width.is_empty() && !lane.border.is_empty() {
        return None;
    }
    Some(value_at(lane.width.iter().map(|e| record!(e, s_offset)), ds))
}

/// The borders of a side at a distance from the section's start: (id, inner t, outer t) from the center outwards.
pub(crate) fn borders_at(section: &SectionIn<'_>, side: Side, ds: f64) -> Vec<(i32, f64, f64)> {
    let sign = if side == Side::Left { 1.0 } else { -1.0 };
    let mut inner = lane_offset_at(section, section.s() + ds);
    let mut borders = Vec::new();
    for lane in section.outwards(side) {
        let outer = match width_at(lane, ds) {
            Some(width) => inner + sign * width,
            None => value_at(lane.border.iter().map(|e| record!(e, s_offset)), ds),
        };
        borders.push((lane.id.map_or(0, |id| id.value), inner, outer));
        inner = outer;
    }
    borders
}
