//! Lane sections cover the road.

use crate::example::Example::{Lanes, Road};
use crate::place::{RoadIn, SectionIn, Side, lane_part, number, value};
use crate::rule::Check::{self, Section};
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::LayerType;

/// Places that come from rounding in the file.
const ROUNDING: Tolerance = Tolerance { name: "difference of s", value: 0.01, unit: "m" };
/// Sections shorter than this have no length.
const SHORT: Tolerance = Tolerance { name: "least length", value: 1e-6, unit: "m" };

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.9.0:road.lane.lane_sect_first",
        "The first lane section begins at s = 0.",
        Check::Road(first_at_zero),
        [
            Lanes(r#"<laneSection s="0"><center><lane id="0" type="none"/></center></laneSection>"#),
            Lanes(r#"<laneSection s="5"><center><lane id="0" type="none"/></center></laneSection>"#),
        ],
    )
    .within(&[ROUNDING]),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane_section.valid_length",
        "A lane section is longer than 0.",
        Check::Road(lengths),
        [
            Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center></laneSection>
<laneSection s="50"><center><lane id="0" type="none"/></center></laneSection>"#,
            ),
            Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center></laneSection>
<laneSection s="0"><center><lane id="0" type="none"/></center></laneSection>"#,
            ),
        ],
    )
    .within(&[SHORT]),
    Rule::warning(
        "mapd:xodr:1.4.0:lane.section_boundaries",
        "Lane sections begin within the road, and records of their lanes begin within the section.",
        Section(boundaries),
        [
            Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center></laneSection>
<laneSection s="50"><center><lane id="0" type="none"/></center></laneSection>"#,
            ),
            Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center></laneSection>
<laneSection s="150"><center><lane id="0" type="none"/></center></laneSection>"#,
            ),
        ],
    )
    .within(&[ROUNDING]),
    Rule::info(
        "asam.net:xodr:1.9.0:road.lane.lane_section_drivable",
        "If a road has lanes, each of its sections has lanes to the left or right.",
        Section(has_lanes),
        [
            Road(""),
            Road(
                r#"<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection><laneSection s="50"><center><lane id="0" type="none"/></center></laneSection></lanes>"#,
            ),
        ],
    )
    .advisory(),
];

fn first_at_zero(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let permanent = |lanes: &&mapd_xodr::Lanes| value(&lanes.layer) != Some(LayerType::Temporary);
    for lanes in of.road.lanes.iter().filter(permanent) {
        let Some(first) = lanes.lane_section.first() else { continue };
        let s = number(&first.s);
        if s.abs() > ROUNDING.value {
            sink.add_within("lanes/laneSection", first.span, "the first section at s = 0", s);
        }
    }
}

fn lengths(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    for lanes in &of.road.lanes {
        for pair in lanes.lane_section.windows(2) {
            // What is missing is told of as such.
            let (Some(s), Some(next)) = (pair[0].s, pair[1].s) else { continue };
            let (s, next) = (s.value, next.value);
            // A section of one side may begin where one of the other side does.
            let is_single = pair.iter().any(|section| value(&section.single_side) == Some(true));
            if next - s <= SHORT.value && next >= s && !is_single {
                let found = format_args!("one from s = {s} to {next}");
                sink.add_within(
                    "lanes/laneSection",
                    pair[0].span,
                    "a section with a length",
                    found,
                );
            }
        }
    }
}

fn boundaries(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    let (s, length) = (of.s(), number(&of.road.length));
    let is_known = of.road.length.is_some();
    if is_known && (s > length + ROUNDING.value || (s >= length && of.index > 0)) {
        sink.add(of.section.span, format_args!("a section within the road's {length} m"), s);
        return;
    }
    let both = [Side::Left, Side::Right].into_iter();
    let lengths = both.map(|side| (side, of.length_of(side)));
    let lanes = lengths.flat_map(|(side, length)| of.side(side).iter().map(move |l| (l, length)));
    for (lane, length) in lanes {
        let widths = lane.width.iter().map(|e| (&e.s_offset, e.span));
        let borders = lane.border.iter().map(|e| (&e.s_offset, e.span));
        let marks = lane.road_mark.iter().map(|e| (&e.s_offset, e.span));
        let speeds = lane.speed.iter().map(|e| (&e.s_offset, e.span));
        for (s_offset, span) in widths.chain(borders).chain(marks).chain(speeds) {
            let s_offset = number(s_offset);
            if s_offset > length + ROUNDING.value {
                let expected = format_args!("sOffset within the section's {length} m");
                sink.add_within(&lane_part(lane, ""), span, expected, s_offset);
            }
        }
    }
}

fn has_lanes(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    let is_empty = |section: &SectionIn<'_>| section.lanes().next().is_none();
    let sections = of.lanes.lane_section.iter().enumerate();
    let mut others = sections.map(|(index, section)| SectionIn { section, index, ..*of });
    if is_empty(of) && others.any(|other| !is_empty(&other)) {
        sink.add(of.section.span, "lanes to the left or right", "none");
    }
}
