//! Linked lanes meet.

use crate::catalog::lanes::is_drivable;
use crate::example::Example::Lanes;
use crate::network::{Contact, LaneFacts, Network, RoadFacts, SectionFacts, Station};
use crate::rule::Check::Network as All;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_geometry::normalize_angle;

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
        "The corners of two linked lanes for driving lie on one another.",
        All(corners),
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
        "Linked roads meet at one height.",
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
    pub(super) fn of(
        network: &Network,
        road: &RoadFacts,
        section: &SectionFacts,
        lane: &LaneFacts,
        end: Contact,
    ) -> Option<Self> {
        let s = match end {
            Contact::Start => section.s,
            Contact::End => section.s_end,
        };
        let borders = [lane.inner[end as usize], lane.outer[end as usize]];
        Some(Self { station: network.station_at(road, s)?, borders })
    }

    /// The largest distance between the corners of two lanes `[m]`.
    pub(super) fn gap(&self, other: &Self) -> f64 {
        let distance = |corner: usize| {
            let [ax, ay] = self.station.at(self.borders[corner]);
            let [bx, by] = other.station.at(other.borders[corner]);
            (ax - bx).hypot(ay - by)
        };
        distance(0).max(distance(1))
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

fn corners(network: &Network, sink: &mut Sink<'_>) {
    network.lane_joints().for_each(|joint| {
        let (Some(neighbor), Some(target)) = (joint.neighbor, joint.target) else { return };
        if !is_drivable(joint.lane.kind) || !is_drivable(target.kind) {
            return;
        }
        // Lanes that split or merge at a line share only some corners.
        let several = |lane, end| network.links_of(lane, end).len() > 1;
        if several(joint.lane, joint.end) || several(target, neighbor.end) {
            return;
        }
        let is_same_road = joint.road.id == neighbor.road.id;
        // Within a road, a pair of lanes is looked at once.
        if is_same_road && joint.end == Contact::Start && joint.rank > 0 {
            return;
        }
        let own = Edge::of(network, joint.road, joint.section, joint.lane, joint.end);
        let other = Edge::of(network, neighbor.road, neighbor.section, target, neighbor.end);
        let (Some(own), Some(other)) = (own, other) else { return };
        let gap = own.gap(&other);
        if gap > CORNER.value {
            let (s, id) = (joint.section.s, joint.lane.id);
            let part = format!("lanes/laneSection[@s={s}]/lane[@id={id}]/link");
            let road = network.name(neighbor.road.id);
            let expected = format_args!("the corners of lane {} of road {road}", target.id);
            let found = format_args!("them {gap:.3} m away");
            let own = network.name(joint.road.id);
            sink.add_in(("road", own, &part), joint.link.span(), expected, found);
        }
    });
}

fn heights(network: &Network, sink: &mut Sink<'_>) {
    for road in &network.roads {
        for end in Contact::BOTH {
            let Some((target, contact)) = network.linked_road(road, end) else { continue };
            let (Some(own), Some(other)) =
                (network.station_of(road, end), network.station_of(target, contact))
            else {
                continue;
            };
            // Rolled reference lines that lie beside one another differ in height.
            let apart = (own.x - other.x).hypot(own.y - other.y);
            let step = (own.z - other.z).abs();
            if step > STEP.value && apart <= CORNER.value {
                let span = road.link(end).map_or(road.span, |link| link.span());
                let target = network.name(target.id);
                let expected = format_args!("the height {:.3} m, that of road {target}", other.z);
                sink.add_in(
                    ("road", network.name(road.id), "link"),
                    span,
                    expected,
                    format_args!("{:.3} m", own.z),
                );
            }
        }
    }
}
