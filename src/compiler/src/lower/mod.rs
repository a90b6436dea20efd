//! One element after the other, from what the file says to flat rows.

mod annotations;
mod georeference;
mod grid;
mod junction_groups;
mod lane_words;
mod marks;
mod need;
mod object_details;
mod object_outlines;
mod object_repeats;
mod objects;
mod permissions;
mod railway;
mod reference_line;
mod sections;
mod semantics;
mod signals;
mod speeds;
mod structures;
mod surface;

use crate::draft::{Draft, StatedGeoreference, between};
use crate::findings::finding;
use mapd_archive::{
    ContactPoint, JunctionRow, LaneLayerRow, LinkKind, MapRow, NONE, Range, RoadRow, RoadType,
    RoadTypeRow, SpeedKind,
};
use mapd_rules::catalog::building;
use mapd_rules::line::ReferenceLine;
use mapd_xodr::{
    self as xodr, Finding, Header, Junction, JunctionType, Position, Road, Severity, Span,
    Text as _, TrafficRule, Value as _,
};
use need::{ElementContext, ElementPath};
pub(crate) use objects::{ObjectContext, Owner};
use objects::{assumed_unit, lanes, orientation};
use sections::{Layer, OnRoad};
use speeds::speed;

/// Most that a road has of something along it times the lanes of one of its sections: what is made for each lane at each of them would else grow with the square of
/// the text.
#[derive(Clone, Copy)]
struct TimesLanes {
    most: usize,
    /// Beyond these, for each of what there is and for each lane.
    of_each: usize,
}

/// Records that shape all lanes, each of which is a point of each lane's lines. Maps at hand have up to 16,014.
const SHAPES: TimesLanes = TimesLanes { most: 1 << 17, of_each: 64 };
/// Speeds of road types, each of which is a step along each lane where its time is added up. Maps at hand have up to 18.
const SPEEDS: TimesLanes = TimesLanes { most: 1 << 12, of_each: 32 };

impl TimesLanes {
    /// What is wrong with so many records and lanes, if there are too many.
    fn exceeded(self, what: &str, records: usize, lanes: usize) -> Option<String> {
        let most = self.most.saturating_add(self.of_each.saturating_mul(records + lanes));
        (records.saturating_mul(lanes) > most).then(|| {
            format!("expected {what} times lanes of a section of at most {most}, found {records} times {lanes}")
        })
    }
}

impl Draft {
    pub(crate) fn header(&mut self, header: &Header, findings: &mut Vec<Finding>) {
        let mut row: MapRow = bytemuck::Zeroable::zeroed();
        row.stated_north = header.north.value().unwrap_or(0.0);
        row.stated_south = header.south.value().unwrap_or(0.0);
        row.stated_east = header.east.value().unwrap_or(0.0);
        row.stated_west = header.west.value().unwrap_or(0.0);
        row.name = self.strings.add(header.name.text());
        row.version = self.strings.add(header.version.text());
        row.date = self.strings.add(header.date.text());
        row.vendor = self.strings.add(header.vendor.text());
        let reference = header.geo_reference.as_ref().map_or("", |g| g.content.text());
        row.geo_reference = self.strings.add(reference);
        self.placed = StatedGeoreference::read(header, findings);
        row.geo_reference_form = self.placed.form.code();
        row.projection = self.strings.add(&self.placed.definition);
        let revision = |n: Option<i32>| n.and_then(|n| u16::try_from(n).ok()).unwrap_or(0);
        row.rev_major = revision(header.rev_major.value());
        row.rev_minor = revision(header.rev_minor.value());
        self.map = Some(row);
        self.default_speeds(header, findings);
    }

    /// Appends a road. Its links are resolved later, from the network; whatever makes it unusable is an error finding.
    pub(crate) fn road(
        &mut self,
        road: &Road,
        line: &ReferenceLine,
        position: Position,
        findings: &mut Vec<Finding>,
    ) {
        let path = ["OpenDRIVE/road[@id=", road.id.text(), "]"].concat();
        let mut part =
            ElementContext { span: road.span, path: ElementPath::of_owner(&path), findings };
        let id = part.need(road.id.as_ref(), "id");
        let length = part.need_along(road.length.value(), "length");
        if length.is_some_and(|length| length < 0.0) {
            let message = "expected a length that is not negative".to_owned();
            part.unusable("length", message);
        }
        let plan_view = road.plan_view.as_deref();
        match plan_view {
            None => part.unusable("planView", "expected the element planView, found none".into()),
            Some(plan_view) if plan_view.geometry.is_empty() => {
                part.span = plan_view.span;
                part.unusable("geometry", "expected the element geometry, found none".into());
            }
            Some(_) => {}
        }
        let lanes = self.layer(road, &path, findings);
        // Without id and length there is nothing to hang the road on; the errors say so.
        let (Some(_), Some(length)) = (id, length.filter(|length| *length >= 0.0)) else { return };
        let number = self.rows.roads.len() as u32;
        let geometries = plan_view.map_or_else(Range::default, |plan_view| {
            self.geometries(plan_view, line, &path, findings)
        });
        let records = road.elevation_profile.as_ref().map_or(&[][..], |p| &p.elevation);
        let elevations = self.cubics(
            records,
            0.0,
            ElementPath::new(&path, "elevationProfile/elevation"),
            findings,
        );
        let records = road.lateral_profile.as_ref().map_or(&[][..], |p| &p.superelevation);
        let superelevations = self.cubics(
            records,
            0.0,
            ElementPath::new(&path, "lateralProfile/superelevation"),
            findings,
        );
        let records = lanes.map_or(&[][..], |lanes| &lanes.lane_offset);
        let lane_offsets =
            self.cubics(records, 0.0, ElementPath::new(&path, "lanes/laneOffset"), findings);
        let types = self.types(road, &path, findings);
        let sections = lanes.map_or(&[][..], |lanes| &lanes.lane_section);
        let right_hand = road.rule.value() != Some(TrafficRule::Lht);
        self.check_times_lanes(road, sections, &path, findings);
        let on = OnRoad { row: number, length, right_hand, path: &path };
        let sections = self.sections(on, Layer { is_temporary: false }, sections, findings);
        if let Some(lanes) = road.temporary_lanes() {
            self.temporary(on, lanes, findings);
        }
        self.road_spans.push(road.span);
        self.surface(road, number, &path, findings);
        self.signals(road, number, &path, findings);
        let row = RoadRow {
            length,
            id: self.strings.add(road.id.text()),
            name: self.strings.add(road.name.text()),
            junction: NONE,
            predecessor: NONE,
            successor: NONE,
            geometries,
            elevations,
            superelevations,
            lane_offsets,
            sections,
            types,
            line: position.line,
            column: position.column,
            predecessor_kind: LinkKind::None.code(),
            successor_kind: LinkKind::None.code(),
            predecessor_contact: ContactPoint::None.code(),
            successor_contact: ContactPoint::None.code(),
            rule: u8::from(!right_hand),
            reserved: [0; 7],
        };
        self.rows.roads.push(row);
    }

    /// The lanes that the road is built of: the first permanent ones.
    fn layer<'a>(
        &mut self,
        road: &'a Road,
        path: &str,
        findings: &mut Vec<Finding>,
    ) -> Option<&'a xodr::Lanes> {
        let chosen = road.permanent_lanes();
        let mut part =
            ElementContext { span: road.span, path: ElementPath::new(path, "lanes"), findings };
        let built = [chosen, road.temporary_lanes()].map(|lanes| lanes.map(|lanes| lanes.span));
        for lanes in road.lanes.iter().filter(|lanes| !built.contains(&Some(lanes.span))) {
            let message =
                "a second layer of lanes of one kind is not built; the first one is".into();
            part.span = lanes.span;
            part.add(&building::LANE_LAYER, Severity::Info, message);
        }
        match chosen {
            None => {
                part =
                    ElementContext { span: road.span, path: ElementPath::of_owner(path), ..part };
                part.unusable("lanes", "expected the element lanes, found none".into());
            }
            Some(lanes) if lanes.lane_section.is_empty() => {
                part.span = lanes.span;
                part.unusable("laneSection", "expected the element laneSection, found none".into());
            }
            Some(_) => {}
        }
        chosen
    }

    /// Appends the lanes of a temporary layer. They hang on no other row than their own.
    fn temporary(&mut self, on: OnRoad<'_>, lanes: &xodr::Lanes, findings: &mut Vec<Finding>) {
        let path = ElementPath::new(on.path, "lanes/laneOffset");
        let lane_offsets = self.cubics(&lanes.lane_offset, 0.0, path, findings);
        let layer = Layer { is_temporary: true };
        let sections = self.sections(on, layer, &lanes.lane_section, findings);
        self.rows.lane_layers.push(LaneLayerRow { road: on.row, sections, lane_offsets });
    }

    /// Says if what runs along a road is too much for its lanes.
    fn check_times_lanes(
        &self,
        road: &Road,
        sections: &[xodr::LaneSection],
        path: &str,
        findings: &mut Vec<Finding>,
    ) {
        let lanes_of = |section: &xodr::LaneSection| {
            let sides = [&section.left, &section.right].into_iter().flatten();
            sides.map(|side| side.lane.len()).sum::<usize>()
        };
        let lanes = sections.iter().map(lanes_of).max().unwrap_or(0);
        let shapes = road.plan_view.as_ref().map_or(0, |plan| plan.geometry.len())
            + road.elevation_profile.as_ref().map_or(0, |profile| profile.elevation.len())
            + road.lateral_profile.as_ref().map_or(0, |profile| profile.superelevation.len())
            + road.permanent_lanes().map_or(0, |lanes| lanes.lane_offset.len());
        let speeds = road.r#type.iter().filter(|record| record.speed.is_some()).count();
        let shapes = SHAPES.exceeded("geometries, heights and offsets", shapes, lanes);
        let speeds = SPEEDS.exceeded("speeds of road types", speeds, lanes);
        for message in [shapes, speeds].into_iter().flatten() {
            let span = road.lanes.first().map_or(road.span, |lanes| lanes.span);
            let mut part = ElementContext { span, path: ElementPath::new(path, "lanes"), findings };
            part.add(&building::TOO_LARGE, Severity::Error, message);
        }
    }

    fn types(&mut self, road: &Road, path: &str, findings: &mut Vec<Finding>) -> Range {
        let before = self.rows.road_types.len();
        for record in &road.r#type {
            let mut part = ElementContext {
                span: record.span,
                path: ElementPath::new(path, "type"),
                findings,
            };
            let Some(s) = surface::place(record.s.value(), "s", &mut part) else { continue };
            let (kind, speed) = match record.speed.as_deref() {
                Some(stated) => speed(stated.max.value(), stated.unit.value(), &mut part),
                None => (SpeedKind::None, 0.0),
            };
            let word = record.r#type.value().map_or("", xodr::RoadType::name);
            self.rows.road_types.push(RoadTypeRow {
                s,
                speed,
                country: self.strings.add(record.country.text()),
                kind: RoadType::from_name(word).code(),
                speed_kind: kind.code(),
                reserved: [0; 2],
            });
        }
        between(before, self.rows.road_types.len())
    }

    /// Appends a junction. Its connections are resolved later, from the network.
    pub(crate) fn junction(
        &mut self,
        junction: &Junction,
        line: &ReferenceLine,
        position: Position,
        findings: &mut Vec<Finding>,
    ) {
        let path = "OpenDRIVE/junction";
        let mut part =
            ElementContext { span: junction.span, path: ElementPath::of_owner(path), findings };
        if part.need(junction.id.as_ref(), "id").is_none() {
            return;
        }
        let path = [path, "[@id=", junction.id.text(), "]"].concat();
        self.elevation_grid(junction, line, &path, findings);
        self.rows.junctions.push(JunctionRow {
            id: self.strings.add(junction.id.text()),
            name: self.strings.add(junction.name.text()),
            connections: Range::default(),
            line: position.line,
            column: position.column,
            kind: match junction.r#type.value() {
                Some(JunctionType::Direct) => 1,
                Some(JunctionType::Virtual) => 2,
                Some(JunctionType::Crossing) => 3,
                _ => 0,
            },
            reserved: [0; 3],
        });
        for link in junction.connection.iter().flat_map(|connection| &connection.lane_link) {
            let path = ElementPath::new(&path, "connection/laneLink");
            let mut part = ElementContext { span: link.span, path, findings };
            part.need(link.from.value(), "from");
            part.need(link.to.value(), "to");
        }
        self.connections += junction.connection.len();
    }

    /// What can be said of the document as a whole.
    pub(crate) fn finish_reading(&mut self, findings: &mut Vec<Finding>) {
        if self.strings.is_full() {
            let message = "names and ids need more than 4 GiB".to_owned();
            let path = "OpenDRIVE".to_owned();
            findings.push(finding(
                &building::TOO_LARGE,
                Severity::Error,
                Span::default(),
                path,
                message,
                "",
            ));
        }
    }
}
