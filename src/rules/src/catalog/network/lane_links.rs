//! Links of lanes.

use super::connections::add_to_link;
use crate::catalog::lanes::is_drivable;
use crate::example::Example::{Document, Junction, Lanes};
use crate::network::{Contact, LaneJoint, LinkTarget, Network};
use crate::rule::{Check, JointCheck, Rule, Tolerance};
use crate::sink::{PartOf, Sink};
use mapd_xodr::JunctionType as Kind;
use std::collections::BTreeSet;

/// Widths that count as none.
const NONE: Tolerance = Tolerance { name: "width that counts as none", value: 1e-6, unit: "m" };

/// Two sections with lanes to the right.
macro_rules! sections {
    ($first:literal, $second:literal) => {
        Lanes(concat!(
            r#"<laneSection s="0"><center><lane id="0" type="none"/></center><right>"#,
            $first,
            r#"</right></laneSection>
<laneSection s="50"><center><lane id="0" type="none"/></center><right>"#,
            $second,
            "</right></laneSection>"
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "mapd:xodr:1.4.0:ref.orphan_lane",
        "A lane's link names a lane of the adjacent section.",
        Check::joints(orphans),
        [
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#),
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-5"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.link.lanes_across_laneSections",
        "Two linked lanes each name the other.",
        Check::joints(both_ways),
        [
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#),
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#),
        ],
    )
    .also(&["asam.net:xodr:1.4.0:road.lane.link.lanes_across_lane_sections"]),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.link.new_lane_appear",
        "A lane that opens next to another has no link from it.",
        Check::Joints(JointCheck { lane: opening, rest: opening_connected }),
        [
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane><lane id="-2" type="driving"><width sOffset="0" a="0" b="0.06" c="0" d="0"/></lane>"#),
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-1"/><successor id="-2"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane><lane id="-2" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="0" b="0.06" c="0" d="0"/></lane>"#),
        ],
    )
    .within(&[NONE]),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.lane.link.zero_width_at_start",
        "A lane that begins without width has no predecessor.",
        Check::Joints(JointCheck {
            lane: |network, joint, sink| no_width(Contact::Start, network, joint, sink),
            rest: |network, sink| no_width_connected(Contact::Start, network, sink),
        }),
        [
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#),
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="0" b="0.06" c="0" d="0"/></lane>"#),
        ],
    )
    .within(&[NONE]),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.lane.link.zero_width_at_end",
        "A lane that ends without width has no successor.",
        Check::Joints(JointCheck {
            lane: |network, joint, sink| no_width(Contact::End, network, joint, sink),
            rest: |network, sink| no_width_connected(Contact::End, network, sink),
        }),
        [
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#),
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="-0.06" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#),
        ],
    )
    .within(&[NONE]),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.link.multiple_connections",
        "Where a lane splits or lanes merge abruptly, each of them has a width.",
        Check::joints(abrupt),
        [
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-1"/><successor id="-2"/></link><width sOffset="0" a="6" b="0" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane><lane id="-2" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#),
            sections!(r#"<lane id="-1" type="driving"><link><successor id="-1"/><successor id="-2"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane>"#, r#"<lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane><lane id="-2" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="0" b="0.06" c="0" d="0"/></lane>"#),
        ],
    )
    .within(&[NONE]),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.link.no_link",
        "A lane has no link at an end of its road that is linked to a junction or not linked.",
        Check::joints(without_partner),
        [
            Junction(r#"<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="-1"/></connection></junction>"#),
            Document(r#"<road id="1" length="50" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.4.0:road.lane.link.use_junctions",
        "Roads whose lanes do not link one to one are joined by a junction.",
        Check::joints(ambiguous),
        [
            roads(),
            Document(r#"<road id="1" length="50" junction="-1"><link><successor elementType="road" elementId="2" contactPoint="start"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><successor id="-1"/><successor id="-2"/></link><width sOffset="0" a="6" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane><lane id="-2" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#),
        ],
    ),
    Rule::warning(
        "mapd:xodr:1.4.0:topology.direction",
        "Linked lanes have the same direction of traffic.",
        Check::joints(directions),
        [
            roads(),
            Document(r#"<road id="1" length="50" junction="-1"><link><successor elementType="road" elementId="2" contactPoint="start"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><successor id="1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><left><lane id="1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center></laneSection></lanes></road>"#),
        ],
    ),
];

const fn roads() -> crate::example::Example {
    Document(
        r#"<road id="1" length="50" junction="-1"><link><successor elementType="road" elementId="2" contactPoint="start"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="50"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#,
    )
}

/// Adds a finding about a lane's link.
fn add(
    network: &Network,
    joint: &LaneJoint<'_>,
    sink: &mut Sink<'_>,
    expected: impl std::fmt::Display,
    found: impl std::fmt::Display,
) {
    let name = match joint.end {
        Contact::Start => "predecessor",
        Contact::End => "successor",
    };
    let (s, id) = (joint.section.s, joint.lane.id);
    let part = format!("lanes/laneSection[@s={s}]/lane[@id={id}]/link/{name}");
    sink.add_in(PartOf::road(network.name(joint.road.id), &part), joint.link.span, expected, found);
}

fn orphans(network: &Network, joint: &LaneJoint<'_>, sink: &mut Sink<'_>) {
    // Lane 0 is in every section.
    if let Some(neighbor) =
        joint.neighbor.filter(|_| joint.link.id != 0 && joint.target().is_none())
    {
        let road = network.name(neighbor.road.id);
        let expected = format_args!("a lane of road {road} at s = {}", neighbor.section.s);
        let found = format_args!("lane {}, which does not exist", joint.link.id);
        add(network, joint, sink, expected, found);
    }
}

fn both_ways(network: &Network, joint: &LaneJoint<'_>, sink: &mut Sink<'_>) {
    let Some(neighbor) = joint.neighbor else { return };
    // Where a road within a junction links to one outside of it, the way back is the junction's.
    if joint.road.junction.is_some() && neighbor.road.junction.is_none() {
        return;
    }
    let Some(target) = joint.target() else { return };
    let back = network.links_of(target, neighbor.end);
    if !back.iter().any(|link| link.id == joint.lane.id) {
        let road = network.name(neighbor.road.id);
        let expected = format_args!("a link back from lane {} of road {road}", target.id);
        add(network, joint, sink, expected, "none");
    }
}

/// What [`opening`] expects.
const UNOPENED: &str = "no link to a lane without width here";

fn opening(network: &Network, joint: &LaneJoint<'_>, sink: &mut Sink<'_>) {
    let is_open = joint.lane.width(joint.end) > NONE.value;
    let Some(neighbor) = joint.neighbor.filter(|_| is_open) else { return };
    let Some(target) = joint.target() else { return };
    if target.width(neighbor.end) <= NONE.value {
        add(network, joint, sink, UNOPENED, format_args!("one to lane {}", target.id));
    }
}

fn opening_connected(network: &Network, sink: &mut Sink<'_>) {
    for joint in network.connected_joints(Kind::Default) {
        let opens = joint.to.width() <= NONE.value && joint.from.width() > NONE.value;
        if opens && !network.links_back(&joint) {
            let found = format_args!("one to lane {}", joint.to.lane.id);
            add_to_link(network, &joint, sink, UNOPENED, found);
        }
    }
}

/// What [`no_width`] expects.
const UNLINKED: &str = "no link of a lane without width here";

fn no_width(end: Contact, network: &Network, joint: &LaneJoint<'_>, sink: &mut Sink<'_>) {
    let is_none = joint.end == end && joint.lane.width(end) <= NONE.value;
    if is_none && joint.target().is_some() {
        add(network, joint, sink, UNLINKED, format_args!("one to lane {}", joint.link.id));
    }
}

fn no_width_connected(end: Contact, network: &Network, sink: &mut Sink<'_>) {
    // A lane of several connections is told once; one that has links of its own was told with them.
    let mut told = BTreeSet::new();
    for joint in network.connected_joints(Kind::Default) {
        for of in [&joint.from, &joint.to] {
            if of.end != end
                || of.width() > NONE.value
                || !network.links_of(of.lane, of.end).is_empty()
            {
                continue;
            }
            if told.insert((of.road.id, of.lane.span.start)) {
                let (lane, road) = (of.lane.id, network.name(of.road.id));
                let found = format_args!("lane {lane} of road {road}");
                add_to_link(network, &joint, sink, UNLINKED, found);
            }
        }
    }
}

fn abrupt(network: &Network, joint: &LaneJoint<'_>, sink: &mut Sink<'_>) {
    let is_one_of_many = network.links_of(joint.lane, joint.end).len() > 1;
    let Some(neighbor) = joint.neighbor.filter(|_| is_one_of_many) else { return };
    let Some(target) = joint.target() else { return };
    let own = joint.lane.width(joint.end);
    let width = target.width(neighbor.end);
    if own <= NONE.value || width <= NONE.value {
        let expected = "widths of both lanes where several link";
        add(network, joint, sink, expected, format_args!("{own} and {width} m"));
    }
}

fn without_partner(network: &Network, joint: &LaneJoint<'_>, sink: &mut Sink<'_>) {
    if joint.neighbor.is_some() {
        return;
    }
    let found = match joint.road.link(joint.end).map(|link| &link.target) {
        None => "one at an end of the road that is linked to nothing".to_owned(),
        // In the middle of a main road, lanes link to its lanes.
        Some(LinkTarget::Road(_)) => return,
        Some(LinkTarget::Junction(id)) => format!("one into junction {}", network.name(*id)),
    };
    add(network, joint, sink, "no link", found);
}

fn ambiguous(network: &Network, joint: &LaneJoint<'_>, sink: &mut Sink<'_>) {
    let links = network.links_of(joint.lane, joint.end);
    let is_second = links.len() > 1 && links.first().is_none_or(|first| first.id != joint.link.id);
    let Some(neighbor) = joint.neighbor.filter(|_| is_second) else { return };
    let is_outside = joint.road.junction.is_none() && neighbor.road.junction.is_none();
    if neighbor.road.id != joint.road.id
        && is_outside
        && joint.target().is_some_and(|target| is_drivable(target.kind))
    {
        let expected = "one lane of the next road, or a junction";
        add(network, joint, sink, expected, format_args!("{}", links.len()));
    }
}

fn directions(network: &Network, joint: &LaneJoint<'_>, sink: &mut Sink<'_>) {
    let Some(neighbor) = joint.neighbor.filter(|_| is_drivable(joint.lane.kind)) else { return };
    let Some(target) = joint.target().filter(|target| is_drivable(target.kind)) else { return };
    let (Some(own), Some(other)) =
        (Network::goes_along(joint.road, joint.lane), Network::goes_along(neighbor.road, target))
    else {
        return;
    };
    let is_turned = joint.end == neighbor.end;
    if (own == other) == is_turned {
        let found = format_args!(
            "lane {} of road {}, where it comes from ahead",
            target.id,
            network.name(neighbor.road.id)
        );
        add(network, joint, sink, "a lane that goes on in the same direction", found);
    }
}
