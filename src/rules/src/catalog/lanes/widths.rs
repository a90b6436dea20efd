//! Widths are there, and not negative.

use crate::example::Example::{Lane as OfLane, Lanes};
use crate::place::{LaneIn, number};
use crate::profile::{Record, record, width_at};
use crate::rule::Check::Lane;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;

/// Widths below 0 that come from rounding in the file.
const NEGATIVE: Tolerance =
    Tolerance { name: "width below 0 that counts as rounding", value: 1e-3, unit: "m" };
/// Offsets that count as 0.
const ROUNDING: Tolerance = Tolerance { name: "sOffset that counts as 0", value: 1e-6, unit: "m" };
/// Widths that count as none.
const NONE: Tolerance = Tolerance { name: "width that counts as none", value: 1e-6, unit: "m" };
/// A lane without width may go on for this long.
const LONG: Tolerance = Tolerance { name: "length without width", value: 50.0, unit: "m" };

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:road.lane.width.width_defined_whole_section",
        "The first width of a lane begins at the start of the section.",
        Lane(from_the_start),
        [
            OfLane(r#"<width sOffset="0" a="3" b="0" c="0" d="0"/>"#),
            OfLane(r#"<width sOffset="20" a="3" b="0" c="0" d="0"/>"#),
        ],
    )
    .within(&[ROUNDING]),
    Rule::warning(
        "mapd:xodr:1.4.0:lane.without_width",
        "A lane has a width or a border; without, it is 0 m wide.",
        Lane(without_width),
        [
            OfLane(r#"<width sOffset="0" a="3" b="0" c="0" d="0"/>"#),
            Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"/></right></laneSection>"#,
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.width.lane_width_validity",
        "The width of a lane is never below 0.",
        Lane(not_negative),
        [
            OfLane(r#"<width sOffset="0" a="3" b="-0.03" c="0" d="0"/>"#),
            OfLane(r#"<width sOffset="0" a="3" b="-0.05" c="0" d="0"/>"#),
        ],
    )
    .within(&[NEGATIVE]),
    Rule::info(
        "asam.net:xodr:1.9.0:road.lane_section.lane_long_zero_width",
        "A lane does not continue for long with a width of 0.",
        Lane(long_without),
        [
            OfLane(r#"<width sOffset="0" a="3" b="0" c="0" d="0"/>"#),
            OfLane(r#"<width sOffset="0" a="0" b="0" c="0" d="0"/>"#),
        ],
    )
    .within(&[NONE, LONG])
    .advisory(),
];

fn from_the_start(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
    let Some(first) = of.lane.width.first() else { return };
    let s_offset = number(&first.s_offset);
    if s_offset.abs() > ROUNDING.value {
        sink.add_within("width", first.span, "the first width at sOffset = 0", s_offset);
    }
}

fn without_width(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
    if of.lane.width.is_empty() && of.lane.border.is_empty() {
        sink.add(of.lane.span, "a width or a border of the lane", "none; it is 0 m wide");
    }
}

/// The least value of a record from its start over a length, and where.
fn least(record: &Record, length: f64) -> (f64, f64) {
    let cubic = &record.cubic;
    let mut least = (cubic.value(0.0), 0.0);
    let mut try_at = |ds: f64| {
        if ds > 0.0 && ds <= length && cubic.value(ds) < least.0 {
            least = (cubic.value(ds), ds);
        }
    };
    try_at(length);
    // Where the slope b + 2c·ds + 3d·ds² is 0.
    let (b, c, d) = (cubic.b, 2.0 * cubic.c, 3.0 * cubic.d);
    if d == 0.0 {
        try_at(-b / c);
    } else {
        let root = (c * c - 4.0 * d * b).sqrt();
        try_at((-c - root) / (2.0 * d));
        try_at((-c + root) / (2.0 * d));
    }
    least
}

fn not_negative(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
    let length = of.section.length_of(of.side);
    for (rank, width) in of.lane.width.iter().enumerate() {
        let record = record!(width, s_offset);
        let next = of.lane.width.get(rank + 1);
        let end = next.map_or(length, |next| number(&next.s_offset));
        let (value, ds) = least(&record, end.min(length) - record.s);
        if value < -NEGATIVE.value && record.s <= length {
            let s = of.section.s() + record.s + ds;
            let found = format_args!("{value:.4} m at s = {s:.3}; taken as 0");
            sink.add_within("width", width.span, "a width of at least 0", found);
        }
    }
}

fn long_without(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
    let section_length = of.section.length_of(of.side);
    // A cubic without width at its ends and two places between has none at all.
    let is_none = |ds: f64| width_at(of.lane, ds).is_some_and(|width| width.abs() <= NONE.value);
    for (rank, width) in of.lane.width.iter().enumerate() {
        let start = number(&width.s_offset);
        let next = of.lane.width.get(rank + 1);
        let end = next.map_or(section_length, |next| number(&next.s_offset));
        let length = end - start;
        // The next record holds at its own start.
        let before_end = start + 0.999 * length;
        // What cannot be read is told of as such.
        if width.a.is_some()
            && length > LONG.value
            && [start, start + length / 3.0, start + length / 1.5, before_end]
                .into_iter()
                .all(is_none)
        {
            let found = format_args!("{length} m of it");
            sink.add_within("width", width.span, "no long stretch without width", found);
        }
    }
}
