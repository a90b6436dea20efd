//! Lane ids count from the center outwards.

use crate::example::Example::Section as In;
use crate::place::{LaneIn, RoadIn, SectionIn, Side, lane_part, value};
use crate::rule::Check::{CenterLane, Lane, Road, Section};
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::{self as xodr, LayerType};
use std::collections::BTreeSet;

const CENTER: &str = r#"<center><lane id="0" type="none"/></center><right>
<lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>
<lane id="-2" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#;

pub(super) static RULES: &[Rule] = &[
    Rule::error(
        "asam.net:xodr:1.4.0:ids.id_unique_in_lane_section",
        [
            "A lane id occurs once in a section.",
            "lanes are identified by their ids: it is unclear to which lane widths and links belong",
        ],
        Section(unique),
        [
            In(CENTER),
            In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>
<lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#),
        ],
    )
    .also(&["asam.net:xodr:1.9.0:road.lane.lane_id_unique"]),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.lanes_numbered_correctly",
        "Lanes to the left have ids above 0, lanes to the right below 0.",
        Lane(signs),
        [
            In(CENTER),
            In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.lane_order_no_gaps",
        "Lane ids of a side start with 1 or -1 next to the center and continue outwards without a gap.",
        Section(gaps),
        [
            In(CENTER),
            In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>
<lane id="-3" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#),
        ],
    )
    .also(&["asam.net:xodr:1.4.0:road.lane.lane_order", "mapd:xodr:1.4.0:lane.id_progression"]),
    Rule::info(
        "asam.net:xodr:1.4.0:road.lane.lane_listing",
        "Lanes are listed from left to right, with descending ids.",
        Section(listing),
        [
            In(CENTER),
            In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="-2" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>
<lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#),
        ],
    )
    .advisory(),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.center_elem_definition",
        "A section of the permanent layer has a center.",
        Section(has_center),
        [
            In(CENTER),
            In(r#"<right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#),
        ],
    )
    .also(&["asam.net:xodr:1.9.0:road.lane.layer.center_lane_permanent"]),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.lane.center_lane",
        "A road has a center lane.",
        Road(has_center_lane),
        [
            In(CENTER),
            In(r#"<right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.lane.center_lane_singular",
        "A center has exactly one lane.",
        Section(one_center_lane),
        [
            In(r#"<center><lane id="0" type="none"/></center>"#),
            In(r#"<center><lane id="0" type="none"/><lane id="0" type="none"/></center>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.center_lane_id",
        "The center lane has the id 0.",
        CenterLane(center_id),
        [
            In(r#"<center><lane id="0" type="none"/></center>"#),
            In(r#"<center><lane id="5" type="none"/></center>"#),
        ],
    ),
];

fn unique(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    let center = of.section.center.iter().flat_map(|center| &center.lane);
    let center = center.map(|lane| (lane.id, lane.span));
    let left = of.side(Side::Left).iter().map(|lane| (lane.id, lane.span));
    let right = of.side(Side::Right).iter().map(|lane| (lane.id, lane.span));
    let all = left.chain(center).chain(right);
    // As nearly all stand.
    if all.clone().filter_map(|(id, _)| value(&id)).is_sorted_by(|id, next| id > next) {
        return;
    }
    let mut ids = BTreeSet::new();
    for (id, span) in all {
        let Some(id) = value(&id).filter(|id| !ids.insert(*id)) else { continue };
        let part = format!("lane[@id={id}]");
        sink.add_within(&part, span, "a lane id that no other lane of the section has", id);
    }
}

fn signs(of: &LaneIn<'_>, sink: &mut Sink<'_>) {
    let Some(id) = value(&of.lane.id) else { return };
    let (fits, expected) = match of.side {
        Side::Left => (id > 0, "a lane id above 0 to the left"),
        Side::Right => (id < 0, "a lane id below 0 to the right"),
    };
    if !fits {
        sink.add(of.lane.span, expected, format_args!("{id}; the sign decides"));
    }
}

fn gaps(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    for (side, sign) in [(Side::Left, 1), (Side::Right, -1)] {
        let mut before = 0;
        for lane in of.outwards(side) {
            let Some(id) = value(&lane.id).filter(|id| id.signum() == sign) else { continue };
            if id != before && id != before.saturating_add(sign) {
                let next = before.saturating_add(sign);
                let expected = format_args!("lane {next}");
                sink.add_within(
                    &lane_part(lane, ""),
                    lane.span,
                    expected,
                    format_args!("lane {id}"),
                );
            }
            before = id;
        }
    }
}

fn listing(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    for side in [Side::Left, Side::Right] {
        for pair in of.side(side).windows(2) {
            if let (Some(before), Some(id)) = (value(&pair[0].id), value(&pair[1].id))
                && id > before
            {
                let expected = format_args!("a lane id below {before}, that of the one before");
                sink.add_within(&lane_part(&pair[1], ""), pair[1].span, expected, id);
            }
        }
    }
}

fn has_center(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    let is_permanent = value(&of.lanes.layer) != Some(LayerType::Temporary);
    if of.section.center.is_none() && is_permanent {
        sink.add(of.section.span, "a center", "none; the reference line stands in");
    }
}

fn has_center_lane(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let mut centers = of.sections().filter_map(|section| section.section.center.as_ref());
    if !of.road.lanes.is_empty() && !centers.any(|center| !center.lane.is_empty()) {
        sink.add(of.road.span, "a center lane", "none; the reference line stands in");
    }
}

fn one_center_lane(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    let Some(center) = &of.section.center else { return };
    if center.lane.len() != 1 {
        sink.add_within("center", center.span, "one center lane", center.lane.len());
    }
}

fn center_id(lane: &xodr::CenterLane, sink: &mut Sink<'_>) {
    if let Some(id) = value(&lane.id).filter(|id| *id != 0) {
        sink.add(lane.span, "the id 0 for the center lane", id);
    }
}
