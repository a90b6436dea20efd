//! Takes from each element what is kept of it.

use super::Network;
use super::facts::{
    Contact, LaneFacts, LaneLinkFacts, LinkFacts, LinkTarget, Part, PartKind, Reference, RoadFacts,
    SectionFacts, Station,
};
use crate::line::ReferenceLine;
use crate::place::{SectionIn, Side, is_left_hand, junction_of, number, text, value};
use crate::profile::{borders_at, elevation_at, outermost_at, superelevation_at};
use mapd_xodr::{
    Attribute, ContactPoint, ElementType, Item, Junction, LaneDirection, LaneType, LayerType,
    LinkedElement, Objects, Road, Span,
};

/// Cross-sections are this far apart at most `[m]`.
const STATION_STEP: f64 = 10.0;

/// Between cross-sections a curve leaves its chord by at most this much `[m]`.
const CHORD_ERROR: f64 = 0.02;

/// Cross-sections are this far apart at least `[m]`, however narrow a curve.
const STATION_STEP_MIN: f64 = 0.5;

/// Cross-sections of one road at most: a bound on memory for hostile files.
const STATIONS_OF_A_ROAD: usize = 100_000;

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
                self.part(PartKind::Controller, &controller.id, controller.span, None);
                for control in &controller.control {
                    self.refer(
                        &[PartKind::Signal],
                        &control.signal_id,
                        "control/@signalId",
                        ("controller", &controller.id),
                        control.span,
                    );
                }
            }
            Item::JunctionGroup(group) => {
                self.part(PartKind::JunctionGroup, &group.id, group.span, None);
                for of in &group.junction_reference {
                    self.refer(
                        &[PartKind::Junction],
                        &of.junction,
                        "junctionReference/@junction",
                        ("junctionGroup", &group.id),
                        of.span,
                    );
                }
            }
            Item::Station(station) => {
                self.part(PartKind::Station, &station.id, station.span, None);
                for segment in station.platform.iter().flat_map(|platform| &platform.segment) {
                    self.refer(
                        &[PartKind::Road],
                        &segment.road_id,
                        "segment/@roadId",
                        ("station", &station.id),
                        segment.span,
                    );
                }
            }
            Item::VmsGroup(group) => {
                self.part(PartKind::VmsGroup, &group.id, group.span, None);
                for board in &group.vms_board_reference {
                    self.refer(
                        &[PartKind::Signal],
                        &board.signal_id,
                        "vmsBoardReference/@signalId",
                        ("vmsGroup", &group.id),
                        board.span,
                    );
                }
            }
        }
    }

    pub(super) fn part(&mut self, kind: PartKind, id: &Text, span: Span, road: Option<usize>) {
        if let Some(id) = id {
            self.parts.push(Part { kind, id: id.value.clone(), span, road });
        }
    }

    pub(super) fn refer(
        &mut self,
        kinds: &'static [PartKind],
        id: &Text,
        what: &'static str,
        (element, from): (&'static str, &Text),
        span: Span,
    ) {
        if let Some(id) = id {
            let (id, from) = (id.value.clone(), text(from).into());
            self.references.push(Reference { kinds, id, what, element, from, span });
        }
    }

    fn add_junction(&mut self, junction: &Junction) {
        self.part(PartKind::Junction, &junction.id, junction.span, None);
        let from = ("junction", &junction.id);
        let road = &[PartKind::Road];
        if value(&junction.r#type) == Some(mapd_xodr::JunctionType::Virtual) {
            self.refer(road, &junction.main_road, "@mainRoad", from, junction.span);
        }
        for c in &junction.connection {
            // Connections of virtual junctions may come from nowhere.
            if text(&c.incoming_road) != "-1" {
                self.refer(road, &c.incoming_road, "connection/@incomingRoad", from, c.span);
            }
            self.refer(road, &c.connecting_road, "connection/@connectingRoad", from, c.span);
            self.refer(road, &c.linked_road, "connection/@linkedRoad", from, c.span);
        }
        for priority in &junction.priority {
            self.refer(road, &priority.high, "priority/@high", from, priority.span);
            self.refer(road, &priority.low, "priority/@low", from, priority.span);
        }
        for controller in &junction.controller {
            self.refer(
                &[PartKind::Controller],
                &controller.id,
                "controller/@id",
                from,
                controller.span,
            );
        }
        for section in &junction.road_section {
            self.refer(road, &section.road_id, "roadSection/@roadId", from, section.span);
        }
        for path in &junction.cross_path {
            self.refer(road, &path.crossing_road, "crossPath/@crossingRoad", from, path.span);
            self.refer(road, &path.road_at_start, "crossPath/@roadAtStart", from, path.span);
            self.refer(road, &path.road_at_end, "crossPath/@roadAtEnd", from, path.span);
        }
        for segment in junction.boundary.iter().flat_map(|boundary| &boundary.segment) {
            self.refer(road, &segment.road_id, "boundary/segment/@roadId", from, segment.span);
        }
        if let Some(objects) = &junction.objects {
            self.add_objects(objects, from, None);
        }
        self.junctions.push(Junction { objects: None, ..junction.clone() });
    }

    fn add_objects(&mut self, objects: &Objects, from: (&'static str, &Text), road: Option<usize>) {
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
            self.refer(
                &[PartKind::Object],
                &object.id,
                "objects/objectReference/@id",
                from,
                object.span,
            );
        }
    }

    fn add_road(&mut self, road: &Road, line: &ReferenceLine) {
        let rank = self.roads.len();
        self.part(PartKind::Road, &road.id, road.span, None);
        let link = road.link.as_deref();
        for neighbor in link.iter().flat_map(|link| &link.neighbor) {
            self.refer(
                &[PartKind::Road],
                &neighbor.element_id,
                "link/neighbor/@elementId",
                ("road", &road.id),
                neighbor.span,
            );
        }
        if let Some(id) = junction_of(road) {
            let what = "@junction";
            let (id, from) = (id.into(), text(&road.id).into());
            self.references.push(Reference {
                kinds: &[PartKind::Junction],
                id,
                what,
                element: "road",
                from,
                span: road.span,
            });
        }
        let ends = [
            link.and_then(|link| link.predecessor.as_deref()),
            link.and_then(|link| link.successor.as_deref()),
        ];
        for (end, what) in
            ends.iter().zip(["link/predecessor/@elementId", "link/successor/@elementId"])
        {
            let Some(end) = end else { continue };
            let kinds: &[PartKind] = match value(&end.element_type) {
                Some(ElementType::Junction) => &[PartKind::Junction],
                _ => &[PartKind::Road],
            };
            self.refer(kinds, &end.element_id, what, ("road", &road.id), end.span);
        }
        if let Some(objects) = &road.objects {
            self.add_objects(objects, ("road", &road.id), Some(rank));
        }
        if let Some(signals) = &road.signals {
            self.add_signals(signals, &road.id, rank);
        }
        let switches = road.railroad.iter().flat_map(|railroad| &railroad.switch);
        for switch in switches {
            self.part(PartKind::Switch, &switch.id, switch.span, Some(rank));
            for (track, what, span) in [
                (switch.main_track.as_ref().map(|t| &t.id), "switch/mainTrack/@id", switch.span),
                (switch.side_track.as_ref().map(|t| &t.id), "switch/sideTrack/@id", switch.span),
            ] {
                if let Some(id) = track {
                    self.refer(&[PartKind::Road], id, what, ("switch", &switch.id), span);
                }
            }
            if let Some(partner) = &switch.partner {
                self.refer(
                    &[PartKind::Switch],
                    &partner.id,
                    "switch/partner/@id",
                    ("switch", &switch.id),
                    partner.span,
                );
            }
        }
        let sections = self.add_sections(road);
        let (stations, bounds) = self.add_stations(road, line);
        let elevations = road.elevation_profile.iter().flat_map(|profile| &profile.elevation);
        let has_elevation =
            elevations.flat_map(|e| [&e.a, &e.b, &e.c, &e.d]).any(|value| number(value) != 0.0);
        self.roads.push(RoadFacts {
            span: road.span,
            rank,
            id: text(&road.id).into(),
            junction: junction_of(road).map(Into::into),
            length: number(&road.length),
            is_left_hand: is_left_hand(road),
            links: ends.map(|end| end.and_then(link_facts)),
            sections,
            stations,
            bounds,
            has_crg: road.surface.as_ref().is_some_and(|surface| !surface.crg.is_empty()),
            has_switches: road.railroad.as_ref().is_some_and(|rail| !rail.switch.is_empty()),
            has_elevation,
        });
    }

    fn add_sections(&mut self, road: &Road) -> std::ops::Range<usize> {
        let before = self.sections.len();
        for section in permanent(road) {
            let first = self.lanes.len();
            let length = section.length();
            let mut inner: [Vec<_>; 2] = [Vec::new(), Vec::new()];
            for (at, ds) in [(0, 0.0), (1, length)] {
                for side in [Side::Left, Side::Right] {
                    inner[at].extend(borders_at(&section, side, ds));
                }
            }
            for lane in section.lanes() {
                let Some(id) = value(&lane.id) else { continue };
                let find = |at: usize| {
                    let borders: &[(i32, f64, f64)] = &inner[at];
                    borders.iter().find(|border| border.0 == id).map_or([0.0; 2], |b| [b.1, b.2])
                };
                let (start, end) = (find(0), find(1));
                let links = lane.link.as_deref();
                let links =
                    [links.map(|l| &l.predecessor), links.map(|l| &l.successor)].map(|list| {
                        let first = self.lane_links.len();
                        for link in list.into_iter().flatten() {
                            if let Some(id) = value(&link.id) {
                                self.lane_links.push(LaneLinkFacts { span: link.span, id });
                            }
                        }
                        first..self.lane_links.len()
                    });
                let direction = value(&lane.direction).unwrap_or(LaneDirection::Standard);
                let kind = value(&lane.r#type).unwrap_or(LaneType::None);
                self.lanes.push(LaneFacts {
                    span: lane.span,
                    id,
                    kind,
                    direction,
                    is_level: value(&lane.level) == Some(true),
                    widths: [(start[1] - start[0]).abs(), (end[1] - end[0]).abs()],
                    inner: [start[0], end[0]],
                    outer: [start[1], end[1]],
                    links,
                });
            }
            self.lanes[first..].sort_by_key(|lane| -lane.id);
            self.sections.push(SectionFacts {
                span: section.section.span,
                s: section.s(),
                s_end: section.s_end(),
                lanes: first..self.lanes.len(),
            });
        }
        before..self.sections.len()
    }

    fn add_stations(
        &mut self,
        road: &Road,
        line: &ReferenceLine,
    ) -> (std::ops::Range<usize>, [f64; 4]) {
        let before = self.stations.len();
        let mut bounds = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
        let end = number(&road.length).min(line.end());
        let sections: Vec<SectionIn<'_>> = permanent(road).collect();
        for s in places(line, &sections, end) {
            let Some(point) = line.at(s) else { break };
            let [left, right] = extent_at(&sections, s);
            let station = Station {
                s,
                x: point.x,
                y: point.y,
                hdg: point.heading,
                z: elevation_at(road, s),
                roll: superelevation_at(road, s),
                left,
                right,
            };
            for [x, y] in [station.at(left), station.at(right)] {
                bounds = [bounds[0].min(x), bounds[1].min(y), bounds[2].max(x), bounds[3].max(y)];
            }
            self.stations.push(station);
        }
        (before..self.stations.len(), bounds)
    }
}

/// Smallest x, smallest y, largest x, largest y of a road's surface `[m]`; none where its reference line cannot be built.
pub fn extent(road: &Road) -> Option<[f64; 4]> {
    let line = ReferenceLine::new(road.plan_view.as_deref());
    let (_, bounds) = Network::default().add_stations(road, &line);
    bounds.iter().all(|value| value.is_finite()).then_some(bounds)
}

/// Sections of the permanent layer.
fn permanent(road: &Road) -> impl Iterator<Item = SectionIn<'_>> {
    let layers =
        road.lanes.iter().filter(|lanes| value(&lanes.layer) != Some(LayerType::Temporary));
    layers.take(1).flat_map(move |lanes| {
        let sections = lanes.lane_section.iter().enumerate();
        sections.map(move |(index, section)| SectionIn { road, lanes, section, index })
    })
}

/// t of the outermost borders at `s`: left, right `[m]`.
fn extent_at(sections: &[SectionIn<'_>], s: f64) -> [f64; 2] {
    let after = sections.partition_point(|section| section.s() <= s);
    let begun = sections.get(..after).unwrap_or_default();
    [Side::Left, Side::Right].map(|side| {
        // A section of one side leaves the other as it was.
        let holds = begun.iter().rev().find(|section| {
            let is_there = match side {
                Side::Left => section.section.left.is_some(),
                Side::Right => section.section.right.is_some(),
            };
            is_there || value(&section.section.single_side) != Some(true)
        });
        let Some(section) = holds else { return 0.0 };
        outermost_at(section, side, s.min(section.s_end()) - section.s())
    })
}

/// Where cross-sections are kept, ascending.
fn places(line: &ReferenceLine, sections: &[SectionIn<'_>], end: f64) -> Vec<f64> {
    let mut places = Vec::new();
    for piece in &line.pieces {
        let until = (piece.s + piece.length).min(end);
        let mut s = piece.s;
        while s < until && places.len() < STATIONS_OF_A_ROAD {
            places.push(s);
            let bend = piece.at(s - piece.s).map_or(0.0, |p| p.curvature.abs());
            let ahead = piece.at(s - piece.s + STATION_STEP_MIN).map_or(0.0, |p| p.curvature.abs());
            let step = (8.0 * CHORD_ERROR / bend.max(ahead)).sqrt().min(STATION_STEP);
            s += step.max(STATION_STEP_MIN);
        }
    }
    places.extend(sections.iter().map(|section| section.s()).filter(|s| *s >= 0.0 && *s < end));
    places.push(end);
    places.retain(|s| s.is_finite());
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// A link as it is kept.
fn link_facts(link: &LinkedElement) -> Option<LinkFacts> {
    let id = link.element_id.as_ref()?.value.clone();
    let target = match value(&link.element_type) {
        Some(ElementType::Junction) => LinkTarget::Junction(id),
        _ => LinkTarget::Road(id),
    };
    Some(LinkFacts {
        span: link.span,
        target,
        contact: contact(&link.contact_point),
        s: value(&link.element_s),
        dir: value(&link.element_dir),
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
