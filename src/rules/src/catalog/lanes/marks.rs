//! What road marks say about changes of lanes.

use crate::example::Example::Lane as In;
use crate::place::{SectionIn, Side, lane_part, value};
use crate::rule::Check::Section;
use crate::rule::Rule;
use crate::sink::Sink;
use mapd_xodr::{RoadMark, RoadMarkType};

pub(super) static RULES: &[Rule] = &[Rule::info(
    "mapd:xodr:1.4.0:lane.mark_without_lane_change",
    "A mark of two solid lines has a laneChange; without, the standard allows changes across it to both sides.",
    Section(unsaid),
    [
        In(r#"<roadMark sOffset="0" type="solid solid" color="white" laneChange="none"/>"#),
        In(r#"<roadMark sOffset="0" type="solid solid" color="white"/>"#),
    ],
)];

fn unsaid(of: &SectionIn<'_>, sink: &mut Sink<'_>) {
    let mut look = |part: &str, marks: &[RoadMark]| {
        let solid = marks.iter().filter(|m| value(&m.r#type) == Some(RoadMarkType::SolidSolid));
        for mark in solid.filter(|mark| mark.lane_change.is_none()) {
            let found = "none: changes are allowed, as the standard has it; --marks type reads marks by their type";
            sink.add_within(part, mark.span, "@laneChange of a mark of two solid lines", found);
        }
    };
    for lane in of.section.center.iter().flat_map(|center| &center.lane) {
        look("center/lane/roadMark", &lane.road_mark);
    }
    for lane in [Side::Left, Side::Right].into_iter().flat_map(|side| of.side(side)) {
        if !lane.road_mark.is_empty() {
            look(&lane_part(lane, "/roadMark"), &lane.road_mark);
        }
    }
}
