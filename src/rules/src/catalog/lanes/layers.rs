//! Layers of lanes: permanent, and for a while. (OpenDRIVE 1.9)

use super::is_lane_drivable;
use crate::example::Example::{self, Road as InRoad};
use crate::place::{LaneIn, RoadIn, SectionIn, Side, number, text, value};
use crate::profile::borders_at;
use crate::rule::Check::{Lane, Road, Section};
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{LaneType, LayerType};

/// Places that come from rounding in the file.
const ROUNDING: Tolerance = Tolerance { name: "difference of s", value: 0.01, unit: "m" };
/// Widths that come from rounding in the file.
const WIDTH: Tolerance = Tolerance { name: "difference of widths", value: 0.01, unit: "m" };
/// Places along a section at which widths are compared.
const PLACES: usize = 10;

/// A road with a permanent layer of three sections and a temporary one beside the middle.
macro_rules! road {
    ($temporary:literal) => {
        road!($temporary, "")
    };
    ($temporary:literal, $permanent:literal) => {
        InRoad(concat!(
            r#"<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection>
<laneSection s="40"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection>
<laneSection s="60"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection>"#,
            $permanent,
            "</lanes>\n",
            $temporary
        ))
    };
}

const SOUND: Example = road!(
    r#"<lanes layer="temporary"><laneSection s="40" length="20"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1" layer="permanent"/><successor id="-1" layer="permanent"/></link><width sOffset="0" a="2.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes>"#
);

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.9.0:road.lane.layer.layer_limits",
        "A road has one permanent layer and at most one temporary one.",
        Road(limits),
        [
            SOUND,
            InRoad(
                r#"<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes>"#,
            ),
        ],
    ),
    Rule::error(
        "asam.net:xodr:1.9.0:road.lane.layer.layer_mandatory_permanent",
        [
            "A road has permanent lanes along its whole length.",
            "a road is built from its permanent lanes",
        ],
        Road(has_permanent),
        [
            SOUND,
            InRoad(
                r#"<lanes layer="temporary"><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes>"#,
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.lane.layer.length_only_temporary",
        "Only sections of the temporary layer have a length of their own.",
        Section(length_of_permanent),
        [
            SOUND,
            InRoad(
                r#"<lanes><laneSection s="0" length="100"><center><lane id="0" type="none"/></center></laneSection></lanes>"#,
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.lane_section.lanesec_length_limit_road",
        "A section ends within its road.",
        Section(ends_within),
        [
            SOUND,
            road!(
                r#"<lanes layer="temporary"><laneSection s="40" length="200"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1" layer="permanent"/><successor id="-1" layer="permanent"/></link><width sOffset="0" a="2.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes>"#
            ),
        ],
    )
    .within(&[ROUNDING]),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.lane.layer.lane_phys_attr_temporary",
        "Lanes of the temporary layer have neither height nor material.",
        Lane(physical),
        [
            SOUND,
            road!(
                r#"<lanes layer="temporary"><laneSection s="40" length="20"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1" layer="permanent"/><successor id="-1" layer="permanent"/></link><width sOffset="0" a="2.5" b="0" c="0" d="0"/><material sOffset="0" friction="0.8"/></lane></right></laneSection></lanes>"#
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.lane.layer.lane_group_width_temporary",
        "The lanes of the temporary layer together are no wider than the permanent ones.",
        Section(not_wider),
        [
            SOUND,
            road!(
                r#"<lanes layer="temporary"><laneSection s="40" length="20"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1" layer="permanent"/><successor id="-1" layer="permanent"/></link><width sOffset="0" a="5" b="0" c="0" d="0"/></lane></right></laneSection></lanes>"#
            ),
        ],
    )
    .within(&[WIDTH]),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.lane.link.temporary_layer_section_link_permanent",
        "Temporary lanes for driving link to permanent ones at the start and end of the layer.",
        Lane(linked),
        [
            SOUND,
            road!(
                r#"<lanes layer="temporary"><laneSection s="40" length="20"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1" layer="permanent"/></link><width sOffset="0" a="2.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes>"#
            ),
        ],
    )
    .within(&[ROUNDING]),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.lane_section.new_lanesec_link_temp_to_perm",
        "A temporary lane links to a permanent one only at the start of a permanent section.",
        Lane(breaks),
        [
            SOUND,
            road!(
                r#"<lanes layer="temporary"><laneSection s="45" length="15"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1" layer="permanent"/><successor id="-1" layer="permanent"/></link><width sOffset="0" a="2.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes>"#
            ),
        ],
    )
    .within(&[ROUNDING]),
];

fn is_temporary(of: &SectionIn<'_>) -> bool {
    value(&of.lanes.layer) == Some(LayerType::Temporary)
}

fn limits(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let mut seen = [false; 2];
    for lanes in &of.road.lanes {
        let kind = usize::from(value(&lanes.layer) == Some(LayerType::Temporary));
        if std::mem::replace(&mut seen[kind], true) {
            sink.add_within("lanes", lanes.span, "one layer of a kind", "another; not used");
        }
    }
}

fn has_permanent(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let all = &of.road.lanes;
    if !all.is_empty() && all.iter().all(|l| value(&l.layer) == Some(LayerType::Temporary)) {
        sink.add(of.road.span, "permanent lanes", "only temporary ones");
    }
}

fn length_of_permanent(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    if let Some(length) = of.section.length.filter(|_| !is_temporary(of)) {
        sink.add(of.section.span, "no length of a permanent section", length.value);
    }
}

fn ends_within(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    let (end, length) = (of.s_end(), number(&of.road.length));
    if of.section.length.is_some() && end > length + ROUNDING.value {
        sink.add(of.section.span, format_args!("an end within the road's {length} m"), end);
    }
}

fn physical(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
    if !is_temporary(&of.section) {
        return;
    }
    let height = of.lane.height.first().map(|height| ("height", height.span));
    let material = of.lane.material.first().map(|material| ("material", material.span));
    for (name, span) in [height, material].into_iter().flatten() {
        sink.add_within(name, span, format_args!("no {name} of a temporary lane"), "one");
    }
}

/// Sections of the permanent layer.
fn permanent<'a>(of: &SectionIn<'a>) -> impl Iterator<Item = SectionIn<'a>> {
    let road = of.road;
    let layers = road.lanes.iter().filter(|l| value(&l.layer) != Some(LayerType::Temporary));
    layers.flat_map(move |lanes| {
        let sections = lanes.lane_section.iter().enumerate();
        sections.map(move |(index, section)| SectionIn { road, lanes, section, index })
    })
}

fn not_wider(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    if !is_temporary(of) {
        return;
    }
    let width = |section: &SectionIn<'_>, side, ds| {
        borders_at(section, side, ds).map(|(_, inner, outer)| (outer - inner).abs()).sum::<f64>()
    };
    for side in [Side::Left, Side::Right] {
        for place in 0..PLACES {
            let ds = of.length() * place as f64 / PLACES as f64;
            let s = of.s() + ds;
            let Some(below) = permanent(of).filter(|section| section.s() <= s).last() else {
                continue;
            };
            let (own, due) = (width(of, side, ds), width(&below, side, s - below.s()));
            if own > due + WIDTH.value {
                let expected = format_args!("lanes within the {due:.3} m of the permanent ones");
                sink.add(of.section.span, expected, format_args!("{own:.3} m at s = {s:.3}"));
                break;
            }
        }
    }
}

/// The ends of a temporary section at which the layer begins or ends: place and whether it is the end.
fn layer_ends(of: &SectionIn<'_>) -> impl Iterator<Item = (f64, bool)> {
    let (s, end, length) = (of.s(), of.s_end(), number(&of.road.length));
    let touches = |at: f64| {
        let sections = of.lanes.lane_section.iter().enumerate();
        let others = sections
            .filter(|(index, _)| *index != of.index)
            .map(|(index, section)| SectionIn { section, index, ..*of });
        others.into_iter().any(|other| {
            (other.s() - at).abs() <= ROUNDING.value || (other.s_end() - at).abs() <= ROUNDING.value
        })
    };
    let begins = (s > ROUNDING.value && !touches(s)).then_some((s, false));
    let ends = (end < length - ROUNDING.value && !touches(end)).then_some((end, true));
    [begins, ends].into_iter().flatten()
}

fn linked(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
    let kind = value(&of.lane.r#type).unwrap_or(LaneType::None);
    if !is_temporary(&of.section) || !is_lane_drivable(kind, value(&of.lane.advisory)) {
        return;
    }
    for (_, is_end) in layer_ends(&of.section) {
        let link = of.lane.link.as_deref();
        let has_one = link.is_some_and(|link| {
            let list = if is_end { &link.successor } else { &link.predecessor };
            list.iter().any(|link| text(&link.layer) == "permanent")
        });
        if !has_one {
            let what = if is_end { "successor" } else { "predecessor" };
            sink.add(of.lane.span, format_args!("a permanent {what}"), "none");
        }
    }
}

fn breaks(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
    if !is_temporary(&of.section) {
        return;
    }
    for (s, is_end) in layer_ends(&of.section) {
        let Some(link) = of.lane.link.as_deref() else { return };
        let list = if is_end { &link.successor } else { &link.predecessor };
        let Some(link) = list.iter().find(|link| text(&link.layer) == "permanent") else {
            continue;
        };
        if !permanent(&of.section).any(|section| (section.s() - s).abs() <= ROUNDING.value) {
            let expected = format_args!("a permanent section that begins at s = {s}");
            sink.add_within("link", link.span, expected, "none");
        }
    }
}
