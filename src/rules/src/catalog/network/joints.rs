//! Linked lanes meet.

use super::connections::add_to_link;
use crate::catalog::lanes::is_drivable;
use crate::example::Example::Lanes;
use crate::network::{
    ConnectedJoint, Contact, LaneEnd, LaneJoint, Neighbor, Network, RoadEnd, Station,
};
use crate::rule::Check::Network as All;
use crate::rule::{Check, JointCheck, Rule, Tolerance};
use crate::sink::{PartOf, Sink};
use mapd_geometry::normalize_angle;
use mapd_xodr::{JunctionType as Kind, Span};
use std::collections::BTreeMap;

/// Distance of corners that are meant to be one, as in ASAM's checker.
pub(super) const CORNER: Tolerance =
    Tolerance { name: "distance of corners", value: 0.01, unit: "m" };
/// Headings that are meant to be one.
pub(super) const KINK: Tolerance = Tolerance { name: "kink", value: 0.01, unit: "rad" };
/// Heights that are meant to be one.
pub(super) const STEP: Tolerance = Tolerance { name: "step of height", value: 0.01, unit: "m" };

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "asam.net:xodr:1.7.0:lane_smoothness.contact_point_no_horizontal_gaps",
        "The corners of two linked driving lanes coincide; if a lane continues as several, the outermost corners do.",
        Check::Joints(JointCheck { lane: corners, rest: corners_connected }),
        [
            Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection>
<laneSection s="50"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection>"#,
            ),
            Lanes(
                r#"<laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><successor id="-1"/></link><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection>
<laneSection s="50"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link><predecessor id="-1"/></link><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection>"#,
            ),
        ],
    )
    .within(&[CORNER]),
    Rule::warning(
        "mapd:xodr:1.4.0:lane_smoothness.height",
        "Linked roads meet at the same height.",
        All(heights),
        [
            crate::example::Example::Document(r#"<road id="1" length="50" junction="-1"><link><successor elementType="road" elementId="2" contactPoint="start"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><elevationProfile><elevation s="0" a="0" b="0.02" c="0" d="0"/></elevationProfile><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="50"><line/></geometry></planView><elevationProfile><elevation s="0" a="1" b="0" c="0" d="0"/></elevationProfile><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>"#),
            crate::example::Example::Document(r#"<road id="1" length="50" junction="-1"><link><successor elementType="road" elementId="2" contactPoint="start"/></link><planView><geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry></planView><elevationProfile><elevation s="0" a="0" b="0.02" c="0" d="0"/></elevationProfile><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>
<road id="2" length="50" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView><geometry s="0" x="50" y="0" hdg="0" length="50"><line/></geometry></planView><elevationProfile><elevation s="0" a="4" b="0" c="0" d="0"/></elevationProfile><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>"#),
        ],
    )
    .within(&[STEP]),
];

/// A lane at an end of its section, or somewhere along it.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    pub(super) station: Station,
    /// t of the inner and outer border `[m]`.
    pub(super) borders: [f64; 2],
}

impl Edge {
    /// A lane at an end of its section.
    pub(super) fn of(network: &Network, of: &LaneEnd<'_>) -> Option<Self> {
        let LaneEnd { road, section, lane, end } = *of;
        let s = match end {
            Contact::Start => section.s,
            Contact::End => section.s_end(lane.id),
        };
        let borders = [lane.inner[end as usize], lane.outer[end as usize]];
        Some(Self { station: network.station_at(road, s)?, borders })
    }

    /// The largest distance between the corners of two lanes `[m]`.
    pub(super) fn gap(&self, other: &Self) -> f64 {
        let [inner, outer] = self.apart(other);
        inner.max(outer)
    }

    /// The distances between the inner and between the outer corners of two lanes `[m]`.
    fn apart(&self, other: &Self) -> [f64; 2] {
        let [own, others] = [self, other].map(|edge| edge.station.all_at(edge.borders));
        let apart = |[ax, ay]: [f64; 2], [bx, by]: [f64; 2]| mapd_geometry::hypot(ax - bx, ay - by);
        [apart(own[0], others[0]), apart(own[1], others[1])]
    }

    /// The angle between the two reference lines, whichever way they run `[rad]`.
    pub(super) fn kink(&self, other: &Self) -> f64 {
        let angle = normalize_angle(self.station.hdg - other.station.hdg).abs();
        angle.min(std::f64::consts::PI - angle)
    }

    /// The difference of heights of the reference lines `[m]`.
    pub(super) fn step(&self, other: &Self) -> f64 {
        (self.station.z - other.station.z).abs()
    }
}

/// A corner that is not where it should be: of which of the lanes that lie there, and how far away `[m]`.
type Astray = (usize, f64);

/// Whether a lane meets those that it goes on as, or that go on as it: one of them whole; of several that lie side by side,
/// the inner corner of the innermost and the outer one of the outermost. Nothing is said of lanes on both sides of lane 0.
fn astray(network: &Network, own: &LaneEnd<'_>, others: &[LaneEnd<'_>]) -> [Option<Astray>; 2] {
    let is_told = is_drivable(own.lane.kind)
        && others.iter().all(|other| is_drivable(other.lane.kind))
        && others.windows(2).all(|pair| (pair[0].lane.id < 0) == (pair[1].lane.id < 0));
    let distance = |at: &usize| others.get(*at).map_or(0, |other| other.lane.id.unsigned_abs());
    let Some(edge) = is_told.then(|| Edge::of(network, own)).flatten() else { return [None; 2] };
    let edge_of = |at: usize| Edge::of(network, others.get(at)?);
    let found = |at: usize, apart: f64| (apart > CORNER.value).then_some((at, apart));
    if let [_] = others {
        return [edge_of(0).and_then(|other| found(0, edge.gap(&other))), None];
    }
    let ends = [
        (0..others.len()).min_by_key(distance).map(|at| (at, 0)),
        (0..others.len()).max_by_key(distance).map(|at| (at, 1)),
    ];
    ends.map(|end| end.and_then(|(at, corner)| found(at, edge.apart(&edge_of(at)?)[corner])))
}

/// Adds a finding about a link of a lane and the lane whose corners lie away.
fn add(
    network: &Network,
    joint: &LaneJoint<'_>,
    link: Span,
    (other, gap): (&LaneEnd<'_>, f64),
    sink: &mut Sink<'_>,
) {
    let (s, id) = (joint.section.s, joint.lane.id);
    let part = format!("lanes/laneSection[@s={s}]/lane[@id={id}]/link");
    let (own, road) = (network.name(joint.road.id), network.name(other.road.id));
    let expected = format_args!("the corners of lane {} of road {road}", other.lane.id);
    let found = format_args!("them {gap:.3} m away");
    sink.add_in(PartOf::road(own, &part), link, expected, found);
}

fn corners(network: &Network, joint: &LaneJoint<'_>, sink: &mut Sink<'_>) {
    let Some(Neighbor { road, section, end }) = joint.neighbor else { return };
    let own =
        LaneEnd { road: joint.road, section: joint.section, lane: joint.lane, end: joint.end };
    let links = network.links_of(joint.lane, joint.end);
    if let [first, _, ..] = links {
        // All links of a lane are looked at with the first of them.
        if first.span != joint.link.span {
            return;
        }
        let others = links.iter().filter_map(|link| {
            let lane = network.lane(section, link.id)?;
            let is_split = network.links_of(lane, end).len() > 1;
            (!is_split).then_some((link.span, LaneEnd { road, section, lane, end }))
        });
        let (spans, others): (Vec<_>, Vec<_>) = others.unzip();
        if others.len() == links.len() {
            let found = astray(network, &own, &others);
            for (at, gap) in found.into_iter().flatten() {
                if let (Some(span), Some(other)) = (spans.get(at), others.get(at)) {
                    add(network, joint, *span, (other, gap), sink);
                }
            }
        }
        return;
    }
    // Within a road, a pair of lanes is looked at once.
    let is_seen = joint.road.id == road.id && joint.end == Contact::Start && joint.rank > 0;
    let Some(lane) = (!is_seen).then(|| joint.target()).flatten() else { return };
    // Of lanes that merge here, only some corners are those of the one that they go on as.
    if network.links_of(lane, end).len() > 1 {
        return;
    }
    let other = LaneEnd { road, section, lane, end };
    if let [Some((_, gap)), _] = astray(network, &own, &[other]) {
        add(network, joint, joint.link.span, (&other, gap), sink);
    }
}

fn corners_connected(network: &Network, sink: &mut Sink<'_>) {
    let mut joints = Vec::new();
    for junction in network.junctions.iter().filter(|junction| junction.kind == Kind::Default) {
        for connection in network.connections_of(junction) {
            joints.clear();
            joints.extend(network.connected_joints_of(junction, connection));
            match joints.as_slice() {
                // As most connections are.
                [joint] => group_corners(network, &joint.from, &[joint.to], &[joint], sink),
                joints => connected_corners(network, joints, sink),
            }
        }
    }
}

/// The corners of lanes that a connection links: each pair, or the lanes side by side that one goes on as.
fn connected_corners(network: &Network, joints: &[ConnectedJoint<'_>], sink: &mut Sink<'_>) {
    let count = |id: fn(&ConnectedJoint<'_>) -> i32| {
        joints.iter().fold(BTreeMap::<i32, usize>::new(), |mut counts, joint| {
            *counts.entry(id(joint)).or_default() += 1;
            counts
        })
    };
    let (of_from, of_to) = (count(|joint| joint.from.lane.id), count(|joint| joint.to.lane.id));
    let are_several = |counts: &BTreeMap<i32, usize>, id| counts.get(&id).is_some_and(|n| *n > 1);
    let splits = |joint: &ConnectedJoint<'_>| are_several(&of_from, joint.from.lane.id);
    let merges = |joint: &ConnectedJoint<'_>| are_several(&of_to, joint.to.lane.id);
    let mut groups: BTreeMap<(i32, i32), Vec<&ConnectedJoint<'_>>> = BTreeMap::new();
    for joint in joints {
        let key = match (splits(joint), merges(joint)) {
            (true, true) => continue,
            (true, false) => (joint.from.lane.id, 0),
            (false, true) => (0, joint.to.lane.id),
            (false, false) => (joint.from.lane.id, joint.to.lane.id),
        };
        groups.entry(key).or_default().push(joint);
    }
    for ((_, to), group) in &groups {
        let Some(first) = group.first() else { continue };
        let is_split = *to == 0;
        let own = if is_split || group.len() == 1 { &first.from } else { &first.to };
        let others = group.iter().map(|j| if is_split || group.len() == 1 { j.to } else { j.from });
        group_corners(network, own, &others.collect::<Vec<_>>(), group, sink);
    }
}

/// The corners of a lane and of those that it goes on as or comes from, by as many links.
fn group_corners(
    network: &Network,
    own: &LaneEnd<'_>,
    others: &[LaneEnd<'_>],
    links: &[&ConnectedJoint<'_>],
    sink: &mut Sink<'_>,
) {
    // Where lanes link to one another themselves, their own links are looked at.
    if links.iter().any(|joint| network.links_back(joint)) {
        return;
    }
    for (at, gap) in astray(network, own, others).into_iter().flatten() {
        let Some(joint) = links.get(at) else { continue };
        let [from, to] = [&joint.from, &joint.to].map(|end| end.lane.id);
        let expected = format_args!("lanes {from} and {to} that meet");
        add_to_link(network, joint, sink, expected, format_args!("a gap of {gap:.3} m"));
    }
}

fn heights(network: &Network, sink: &mut Sink<'_>) {
    for road in &network.roads {
        for end in Contact::BOTH {
            let Some(RoadEnd { road: target, end: contact }) = network.linked_road(road, end)
            else {
                continue;
            };
            let (Some(own), Some(other)) =
                (network.station_of(road, end), network.station_of(target, contact))
            else {
                continue;
            };
            // Rolled reference lines that lie beside one another differ in height.
            let apart = mapd_geometry::hypot(own.x - other.x, own.y - other.y);
            let step = (own.z - other.z).abs();
            if step > STEP.value && apart <= CORNER.value {
                let span = road.link(end).map_or(road.span, |link| link.span);
                let target = network.name(target.id);
                let expected = format_args!("the height {:.3} m, that of road {target}", other.z);
                sink.add_in(
                    PartOf::road(network.name(road.id), "link"),
                    span,
                    expected,
                    format_args!("{:.3} m", own.z),
                );
            }
        }
    }
}
