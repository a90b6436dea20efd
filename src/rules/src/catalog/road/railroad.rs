//! Railways.

use crate::example::Example::Section as InSection;
use crate::place::{SectionIn, Side, value};
use crate::profile::borders_at;
use crate::rule::Check::Section;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{Lane, LaneType};

/// How far the middle of a track may be from the reference line.
const CENTERED: Tolerance = Tolerance { name: "distance from the middle", value: 0.01, unit: "m" };

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:road.railroad.one_rail_per_road",
        "A road has one track: tram and rail lanes of one side, or a pair about the reference line.",
        Section(one_track),
        [
            InSection(r#"<center><lane id="0" type="none"/></center><right><lane id="-1" type="tram"><width sOffset="0" a="1.5" b="0" c="0" d="0"/></lane></right>"#),
            InSection(r#"<center><lane id="0" type="none"/></center><right><lane id="-1" type="tram"><width sOffset="0" a="1.5" b="0" c="0" d="0"/></lane><lane id="-2" type="rail"><width sOffset="0" a="1.5" b="0" c="0" d="0"/></lane></right>"#),
        ],
    ),
    Rule::info(
        "asam.net:xodr:1.7.0:road.railroad.rail_refline_centered",
        "The reference line is in the middle of a track.",
        Section(centered),
        [
            InSection(r#"<left><lane id="1" type="rail"><width sOffset="0" a="1.5" b="0" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center><right><lane id="-1" type="rail"><width sOffset="0" a="1.5" b="0" c="0" d="0"/></lane></right>"#),
            InSection(r#"<left><lane id="1" type="rail"><width sOffset="0" a="1.5" b="0" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center><right><lane id="-1" type="rail"><width sOffset="0" a="1" b="0" c="0" d="0"/></lane></right>"#),
        ],
    )
    .within(&[CENTERED]),
];

fn is_rail(lane: &Lane) -> bool {
    matches!(value(&lane.r#type), Some(LaneType::Tram | LaneType::Rail))
}

fn one_track(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    for side in [Side::Left, Side::Right] {
        if let Some(second) = of.side(side).iter().filter(|lane| is_rail(lane)).nth(1) {
            sink.add_within("lane", second.span, "one tram or rail lane on a side", "another");
        }
    }
}

fn centered(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    let width = |side| {
        let lane = of.side(side).iter().find(|lane| is_rail(lane))?;
        let id = value(&lane.id)?;
        let border = borders_at(of, side, 0.0).find(|border| border.0 == id)?;
        Some((lane.span, border.1 + border.2))
    };
    let (left, right) = (width(Side::Left), width(Side::Right));
    let Some((span, _)) = right.or(left) else { return };
    let middle = (left.map_or(0.0, |lane| lane.1) + right.map_or(0.0, |lane| lane.1)) / 2.0;
    if left.is_some() && right.is_some() && middle.abs() > CENTERED.value {
        let away = middle.abs();
        let found = format_args!("it {away:.3} m away");
        sink.add_within("lane", span, "the middle of the track at the reference line", found);
    }
}
