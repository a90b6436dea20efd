//! Borders stand for widths and offsets, not beside them.

use crate::example::Example::{Lanes, Section as In};
use crate::place::{RoadIn, SectionIn, Side, lane_part, number};
use crate::profile::borders_at;
use crate::rule::Check::{Road, Section};
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;

/// Crossings that come from rounding in the file.
const CROSSING: Tolerance = Tolerance { name: "crossing", value: 1e-3, unit: "m" };
/// Along a section, borders are compared at this distance.
const STEP: f64 = 1.0;
/// Places at which the borders of one section are compared at most.
const PLACES: usize = 1000;

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.border.exclusive_width_border",
        "The lanes of a side have either widths or borders.",
        Section(exclusive_width),
        [
            In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="-1" type="driving"><border sOffset="0" a="-3" b="0" c="0" d="0"/></lane></right>"#),
            In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="-1" type="driving"><border sOffset="0" a="-3" b="0" c="0" d="0"/></lane>
<lane id="-2" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#),
        ],
    )
    .also(&["asam.net:xodr:1.9.0:road.lane.width.no_width_with_border"]),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.border.exclusive_offset_border",
        "A road whose lanes have borders has no lane offset.",
        Road(exclusive_offset),
        [
            Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><border sOffset="0" a="-3" b="0" c="0" d="0"/></lane></right></laneSection>"#,
            ),
            Lanes(
                r#"<laneOffset s="0" a="1" b="0" c="0" d="0"/><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><border sOffset="0" a="-3" b="0" c="0" d="0"/></lane></right></laneSection>"#,
            ),
        ],
    )
    .also(&["asam.net:xodr:1.4.0:road.lanes.lane_offset.no_offset_if_border_defined"]),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.border.overlap_with_inner_lanes",
        "A border does not cross lanes nearer to the center.",
        Section(overlaps),
        [
            In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="-1" type="driving"><border sOffset="0" a="-3" b="0" c="0" d="0"/></lane>
<lane id="-2" type="driving"><border sOffset="0" a="-6" b="0" c="0" d="0"/></lane></right>"#),
            In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="-1" type="driving"><border sOffset="0" a="-3" b="0" c="0" d="0"/></lane>
<lane id="-2" type="driving"><border sOffset="0" a="-4" b="0.1" c="0" d="0"/></lane></right>"#),
        ],
    )
    .within(&[CROSSING]),
];

fn exclusive_width(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    for side in [Side::Left, Side::Right] {
        let lanes = of.side(side);
        let width = lanes.iter().find_map(|lane| lane.width.first());
        let border = lanes.iter().find_map(|lane| Some((lane, lane.border.first()?)));
        if let (Some(_), Some((lane, border))) = (width, border) {
            sink.add_within(
                &lane_part(lane, "/border"),
                border.span,
                "either widths or borders on a side",
                "both",
            );
        }
    }
}

fn exclusive_offset(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for lanes in &of.road.lanes {
        let is_offset = |offset: &&mapd_xodr::LaneOffset| {
            [&offset.a, &offset.b, &offset.c, &offset.d].iter().any(|value| number(value) != 0.0)
        };
        let Some(offset) = lanes.lane_offset.iter().find(is_offset) else { continue };
        let sections = of.sections().filter(|section| std::ptr::eq(section.lanes, lanes));
        let mut all = sections.flat_map(|section| section.lanes());
        if all.any(|lane| !lane.border.is_empty() && lane.width.is_empty()) {
            sink.add_within(
                "lanes/laneOffset",
                offset.span,
                "no lane offset beside borders",
                "one",
            );
        }
    }
}

fn overlaps(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    for (side, sign) in [(Side::Left, 1.0), (Side::Right, -1.0)] {
        if of.side(side).iter().all(|lane| lane.border.is_empty()) {
            continue;
        }
        let length = of.length_of(side);
        let steps = ((length / STEP).ceil() as usize).clamp(1, PLACES);
        let mut worst: Option<(i32, f64, f64)> = None;
        for step in 0..=steps {
            let ds = length * step as f64 / steps as f64;
            for (id, inner, outer) in borders_at(of, side, ds) {
                let crossing = sign * (inner - outer);
                if crossing > CROSSING.value && worst.is_none_or(|worst| crossing > worst.1) {
                    worst = Some((id, crossing, of.s() + ds));
                }
            }
        }
        if let Some((id, crossing, s)) = worst
            && let Some(lane) = of.lane(id)
        {
            let found = format_args!("lane {id} {crossing:.3} m inside it at s = {s:.3}");
            sink.add_within(
                &lane_part(lane, "/border"),
                lane.span,
                "a border outside of the lane before it",
                found,
            );
        }
    }
}
