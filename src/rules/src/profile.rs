//! Cubic records along a road or section: which holds where, and its value.

use crate::place::{SectionIn, Side, number};
use mapd_geometry::Cubic;
use mapd_xodr::{Attribute, CubicRecord, Lane, Road};

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

/// The value at `s`: of the last record that begins at or before it, else 0. Records that do not ascend are a finding of
/// their own; of such, any may be taken.
pub(crate) fn value_at<R: CubicRecord>(records: &[R], s: f64) -> f64 {
    let after = records.partition_point(|record| record.start().unwrap_or(0.0) <= s);
    let Some(record) = after.checked_sub(1).and_then(|last| records.get(last)) else { return 0.0 };
    let coefficients = record.coefficients().map(|value| value.unwrap_or(0.0));
    Cubic::new(coefficients).value(s - record.start().unwrap_or(0.0))
}

/// Height of the reference line at `s` `[m]`.
pub(crate) fn elevation_at(road: &Road, s: f64) -> f64 {
    road.elevation_profile.as_ref().map_or(0.0, |profile| value_at(&profile.elevation, s))
}

/// Superelevation at `s` `[rad]`.
pub(crate) fn superelevation_at(road: &Road, s: f64) -> f64 {
    road.lateral_profile.as_ref().map_or(0.0, |profile| value_at(&profile.superelevation, s))
}

/// Offset of lane 0 at `s` `[m]`.
pub(crate) fn lane_offset_at(section: &SectionIn<'_>, s: f64) -> f64 {
    value_at(&section.lanes.lane_offset, s)
}

/// Width of a lane at a distance from its section's start `[m]`, as written; none where it has borders instead.
pub(crate) fn width_at(lane: &Lane, ds: f64) -> Option<f64> {
    if lane.width.is_empty() && !lane.border.is_empty() {
        return None;
    }
    Some(value_at(&lane.width, ds))
}

/// Width that a lane is built with: one below 0 is none.
fn built_width_at(lane: &Lane, ds: f64) -> Option<f64> {
    Some(width_at(lane, ds)?.max(0.0))
}

/// The borders of a side at a distance from the section's start: (id, inner t, outer t) from the center outwards.
pub(crate) fn borders_at<'a>(
    section: &SectionIn<'a>,
    side: Side,
    ds: f64,
) -> impl Iterator<Item = (i32, f64, f64)> + use<'a> {
    let sign = if side == Side::Left { 1.0 } else { -1.0 };
    let mut inner = lane_offset_at(section, section.s() + ds);
    section.outwards(side).map(move |lane| {
        let outer = match built_width_at(lane, ds) {
            Some(width) => inner + sign * width,
            None => value_at(&lane.border, ds),
        };
        let border = (lane.id.map_or(0, |id| id.value), inner, outer);
        inner = outer;
        border
    })
}

/// t of the outermost border of a side at a distance from the section's start; of lane 0 where the side has no lanes.
pub(crate) fn outermost_at(section: &SectionIn<'_>, side: Side, ds: f64) -> f64 {
    let (lanes, center) = (section.side(side), lane_offset_at(section, section.s() + ds));
    let sign = if side == Side::Left { 1.0 } else { -1.0 };
    // Widths may be added in any order.
    let sum = lanes.iter().try_fold(0.0, |sum, lane| Some(sum + built_width_at(lane, ds)?));
    match sum {
        Some(sum) => center + sign * sum,
        None => borders_at(section, side, ds).last().map_or(center, |border| border.2),
    }
}
