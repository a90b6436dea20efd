//! Lanes that are kept level.

use super::connections::add_to_link;
use crate::example::Example::Section as In;
use crate::network::{LaneFacts, LaneJoint, Network};
use crate::rule::{Check, JointCheck, Rule};
use crate::sink::{PartOf, Sink};
use mapd_xodr::{JunctionType as Kind, Severity};

pub(super) static RULES: &[Rule] = &[Rule::warning(
    "asam.net:xodr:1.7.0:road.lane.level_true_one_side",
    "If a lane is level, so are all lanes farther out on that side, and the lanes that it links to.",
    Check::Joints(JointCheck { lane: linked, rest: outwards }),
    [
        In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>
<lane id="-2" type="sidewalk" level="true"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#),
        In(r#"<center><lane id="0" type="none"/></center><right>
<lane id="-1" type="sidewalk" level="true"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>
<lane id="-2" type="driving" level="false"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#),
    ],
)];

/// What is expected of lanes that are linked.
const ALIKE: &str = "linked lanes that are both kept level or both not";

fn linked(network: &Network, joint: &LaneJoint<'_>, sink: &mut Sink<'_>) {
    let Some(target) = joint.target().filter(|target| target.is_level != joint.lane.is_level)
    else {
        return;
    };
    let part =
        format!("lanes/laneSection[@s={}]/lane[@id={}]/link", joint.section.s, joint.lane.id);
    let found = format_args!("lane {} otherwise", target.id);
    let road = network.name(joint.road.id);
    // As in ASAM's checker, milder than what stands in one section.
    sink.at_most(Severity::Warning, |sink| {
        sink.add_in(PartOf::road(road, &part), joint.link.span, ALIKE, found);
    });
}

/// Lanes of one section, from lane 0 outwards, and lanes that connections link.
fn outwards(network: &Network, sink: &mut Sink<'_>) {
    for road in &network.roads {
        for section in network.sections_of(road) {
            // By falling id: those to the left from the outermost, those to the right from the innermost.
            let (left, right) = {
                let lanes = network.lanes_of(section);
                lanes.split_at(lanes.partition_point(|lane| lane.id > 0))
            };
            let mut look = |lanes: &mut dyn Iterator<Item = &LaneFacts>| {
                let mut is_level = false;
                for lane in lanes {
                    if is_level && !lane.is_level {
                        let part =
                            format!("lanes/laneSection[@s={}]/lane[@id={}]", section.s, lane.id);
                        let found = format_args!("lane {} without it", lane.id);
                        let place = PartOf::road(network.name(road.id), &part);
                        sink.add_in(place, lane.span, "level lanes outside of a level lane", found);
                    }
                    is_level |= lane.is_level;
                }
            };
            look(&mut left.iter().rev());
            look(&mut right.iter());
        }
    }
    for joint in network.connected_joints(Kind::Default) {
        let (from, to) = (joint.from.lane, joint.to.lane);
        if from.is_level != to.is_level && !network.links_back(&joint) {
            let found = format_args!("lanes {} and {}, which are not", from.id, to.id);
            sink.at_most(Severity::Warning, |sink| {
                add_to_link(network, &joint, sink, ALIKE, found);
            });
        }
    }
}
