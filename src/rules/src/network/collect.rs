//! Takes from each element what is kept of it.

use super::facts::{
    Contact, IdentifiedPart, LaneFacts, LaneLinkFacts, LinkFacts, LinkTarget, PartKind, RoadApart,
    RoadFacts, SectionFacts,
};
use super::references::{Kinds, NamedAt, Reference, ReferencePlace};
use super::{NONE, Name, Network};
use crate::line::ReferenceLine;
use crate::place::{SectionIn, Side, is_left_hand, junction_of, number, text, value};
use crate::profile::borders_at;
use mapd_xodr::{
    Attribute, ContactPoint, ElementType, Item, Lane, LaneDirection, LaneType, LayerType,
    LinkedElement, Objects, Road, Span,
};
use std::cmp::Reverse;
use std::ops::Range;

/// Word for the temporary layer of a linked lane (OpenDRIVE 1.9, e_layerType).
const TEMPORARY: &str = "temporary";

pub(super) type Text = Option<Attribute<Box<str>>>;

impl Network {
    /// Takes what is kept of a top-level element.
    pub(crate) fn add(&mut self, item: &Item, line: &ReferenceLine) {
        match item {
            Item::Header(header) => {
                self.header = Some(header.span);
                self.has_offset = header.offset.is_some();
            }
            Item::Road(road) => self.add_road(road, line),
            Item::Junction(junction) => self.add_junction(junction),
            Item::Controller(controller) => {
                let from = self.part(PartKind::Controller, &controller.id, controller.span, None);
                for control in &controller.control {
                    let at = NamedAt::Control.of(Kinds::Signal);
                    self.refer(at, &control.signal_id, from, control.span);
                }
            }
            Item::JunctionGroup(group) => {
                let from = self.part(PartKind::JunctionGroup, &group.id, group.span, None);
                for of in &group.junction_reference {
                    self.refer(
                        NamedAt::GroupJunction.of(Kinds::Junction),
                        &of.junction,
                        from,
                        of.span,
                    );
                }
            }
            Item::Station(station) => {
                let from = self.part(PartKind::Station, &station.id, station.span, None);
                for segment in station.platform.iter().flat_map(|platform| &platform.segment) {
                    let at = NamedAt::PlatformSegment.of(Kinds::Road);
                    self.refer(at, &segment.road_id, from, segment.span);
                }
            }
            Item::VmsGroup(group) => {
                let from = self.part(PartKind::VmsGroup, &group.id, group.span, None);
                for board in &group.vms_board_reference {
                    self.refer(
                        NamedAt::Board.of(Kinds::Signal),
                        &board.signal_id,
                        from,
                        board.span,
                    );
                }
            }
        }
    }

    /// Takes something with an id; yields the id, the empty one where it has none.
    pub(super) fn part(
        &mut self,
        kind: PartKind,
        id: &Text,
        span: Span,
        road: Option<u32>,
    ) -> Name {
        let name = self.names.add(text(id));
        if id.is_some() {
            self.parts.push(IdentifiedPart::new(kind, name, span, road));
        }
        name
    }

    /// Takes something that names an id, if it does; yields that id.
    pub(super) fn refer(
        &mut self,
        at: ReferencePlace,
        id: &Text,
        from: Name,
        span: Span,
    ) -> Option<Name> {
        let id = self.names.add(&id.as_ref()?.value);
        self.references.push(Reference::new(at, id, from, span));
        Some(id)
    }

    pub(super) fn add_objects(
        &mut self,
        objects: &Objects,
        at: NamedAt,
        from: Name,
        road: Option<u32>,
    ) {
        for object in &objects.object {
            self.part(PartKind::Object, &object.id, object.span, road);
        }
        for tunnel in &objects.tunnel {
            self.part(PartKind::Tunnel, &tunnel.id, tunnel.span, road);
        }
        for bridge in &objects.bridge {
            self.part(PartKind::Bridge, &bridge.id, bridge.span, road);
        }
        for object in &objects.object_reference {
            self.refer(at.of(Kinds::Object), &object.id, from, object.span);
        }
    }

    /// Takes a road that the rules do not look at.
    pub(crate) fn add_apart(&mut self, road: &Road) {
        let id = self.names.add(text(&road.id));
        let junction = junction_of(road).map(|junction| self.names.add(junction));
        self.roads_apart.push(RoadApart { span: road.span, id, junction });
    }

    fn add_road(&mut self, road: &Road, line: &ReferenceLine) {
        let rank = self.roads.len() as u32;
        let id = self.part(PartKind::Road, &road.id, road.span, None);
        let link = road.link.as_deref();
        for neighbor in link.iter().flat_map(|link| &link.neighbor) {
            self.refer(NamedAt::Neighbor.of(Kinds::Road), &neighbor.element_id, id, neighbor.span);
        }
        let junction = junction_of(road).map(|junction| self.names.add(junction));
        if let Some(junction) = junction {
            let at = NamedAt::RoadJunction.of(Kinds::Junction);
            self.references.push(Reference::new(at, junction, id, road.span));
        }
        let ends = [
            link.and_then(|link| link.predecessor.as_deref()),
            link.and_then(|link| link.successor.as_deref()),
        ];
        let named = [NamedAt::Predecessor, NamedAt::Successor];
        let links = [0, 1].map(|at| self.link_facts(named[at], ends[at]?, id));
        if let Some(objects) = &road.objects {
            self.add_objects(objects, NamedAt::RoadObject, id, Some(rank));
        }
        if let Some(signals) = &road.signals {
            self.add_signals(signals, id, rank);
        }
        self.add_switches(road, rank);
        let lane_links = self.lane_links.len();
        let sections = self.add_sections(road);
        let has_lane_links = self.lane_links.len() > lane_links;
        let stations = self.add_stations(road, line);
        let elevations = road.elevation_profile.iter().flat_map(|profile| &profile.elevation);
        let has_elevation =
            elevations.flat_map(|e| [&e.a, &e.b, &e.c, &e.d]).any(|value| number(value) != 0.0);
        self.roads.push(RoadFacts {
            span: road.span,
            length: number(&road.length),
            bounds: stations.bounds,
            links,
            rank,
            id,
            junction,
            sections,
            stations: stations.lines,
            profiles: stations.profiles,
            is_straight: stations.is_straight,
            is_left_hand: is_left_hand(road),
            has_crg: road.surface.as_ref().is_some_and(|surface| !surface.crg.is_empty()),
            has_switches: road.railroad.as_ref().is_some_and(|rail| !rail.switch.is_empty()),
            has_lane_links,
            has_elevation,
        });
    }

    fn add_switches(&mut self, road: &Road, rank: u32) {
        let switches = road.railroad.iter().flat_map(|railroad| &railroad.switch);
        for switch in switches {
            let from = self.part(PartKind::Switch, &switch.id, switch.span, Some(rank));
            for (track, at) in [
                (switch.main_track.as_ref().map(|t| &t.id), NamedAt::MainTrack),
                (switch.side_track.as_ref().map(|t| &t.id), NamedAt::SideTrack),
            ] {
                if let Some(id) = track {
                    self.refer(at.of(Kinds::Road), id, from, switch.span);
                }
            }
            if let Some(partner) = &switch.partner {
                self.refer(NamedAt::Partner.of(Kinds::Switch), &partner.id, from, partner.span);
            }
        }
    }

    /// A road's link as it is kept.
    fn link_facts(&mut self, at: NamedAt, link: &LinkedElement, road: Name) -> Option<LinkFacts> {
        let (kinds, target): (_, fn(Name) -> LinkTarget) = match value(&link.element_type) {
            Some(ElementType::Junction) => (Kinds::Junction, LinkTarget::Junction),
            _ => (Kinds::Road, LinkTarget::Road),
        };
        let target = target(self.refer(at.of(kinds), &link.element_id, road, link.span)?);
        Some(LinkFacts {
            span: link.span,
            target,
            contact: contact(&link.contact_point),
            dir: value(&link.element_dir),
            s: value(&link.element_s),
        })
    }

    fn add_sections(&mut self, road: &Road) -> Range<u32> {
        let before = self.sections.len();
        for section in permanent(road) {
            let first = self.lanes.len();
            let sides = [Side::Left, Side::Right];
            for side in sides {
                let at = |ds: f64| borders_at(&section, side, ds);
                let lanes = section.outwards(side).zip(at(0.0)).zip(at(section.length_of(side)));
                for ((lane, start), end) in lanes {
                    self.add_lane(lane, start, end);
                }
            }
            self.sort_lanes(first);
            self.sections.push(SectionFacts {
                span: section.section.span,
                s: section.s(),
                ends: sides.map(|side| section.s_end_of(side)),
                holds: sides.map(|side| section.holds(side)),
                before: [NONE; 2],
                behind: [NONE; 2],
                lanes: first as u32..self.lanes.len() as u32,
            });
        }
        SectionFacts::join(&mut self.sections[before..]);
        before as u32..self.sections.len() as u32
    }

    /// Takes a lane that has an id, and the inner and outer border at its section's start and end.
    fn add_lane(&mut self, lane: &Lane, start: Border, end: Border) {
        let Some(id) = value(&lane.id) else { return };
        let links = lane.link.as_deref();
        let first = self.lane_links.len() as u32;
        let ends = [links.map(|l| &l.predecessor), links.map(|l| &l.successor)].map(|list| {
            for link in list.into_iter().flatten() {
                if let Some(id) = value(&link.id) {
                    let to_temporary = text(&link.layer) == TEMPORARY;
                    self.lane_links.push(LaneLinkFacts { span: link.span, id, to_temporary });
                }
            }
            self.lane_links.len() as u32
        });
        self.lanes.push(LaneFacts {
            span: lane.span,
            id,
            inner: [start.1, end.1],
            outer: [start.2, end.2],
            links: [first, ends[0], ends[1]],
            kind: value(&lane.r#type).unwrap_or(LaneType::None),
            direction: value(&lane.direction).unwrap_or(LaneDirection::Standard),
            is_level: value(&lane.level) == Some(true),
        });
    }

    /// Sorts the lanes of the last section, which begin at a rank, by falling id.
    fn sort_lanes(&mut self, first: usize) {
        let lanes = &mut self.lanes[first..];
        lanes.sort_by_key(|lane| Reverse(lane.id));
        for same in lanes.chunk_by_mut(|a, b| a.id == b.id) {
            // Of lanes with one id, of which a rule tells, the first one written is meant; all have one lane's borders.
            if let [LaneFacts { inner, outer, .. }, _, ..] = *same {
                same.iter_mut().for_each(|lane| (lane.inner, lane.outer) = (inner, outer));
                same.sort_by_key(|lane| lane.span.start);
            }
        }
    }
}

/// A lane's id, inner and outer border: t `[m]`.
type Border = (i32, f64, f64);

/// Sections of the permanent layer.
pub(super) fn permanent(road: &Road) -> impl Iterator<Item = SectionIn<'_>> {
    let layers =
        road.lanes.iter().filter(|lanes| value(&lanes.layer) != Some(LayerType::Temporary));
    layers.take(1).flat_map(move |lanes| {
        let sections = lanes.lane_section.iter().enumerate();
        sections.map(move |(index, section)| SectionIn { road, lanes, section, index })
    })
}

/// The end that a contact point names.
pub(crate) fn contact(point: &Option<Attribute<ContactPoint>>) -> Option<Contact> {
    match value(point) {
        Some(ContactPoint::Start) => Some(Contact::Start),
        Some(ContactPoint::End) => Some(Contact::End),
        _ => None,
    }
}
