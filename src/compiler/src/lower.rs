//! One element after the other, from what the file says to flat rows.

use crate::graph::Permissions;
use crate::options::CompileOptions;
use crate::{finding, origin};
use mapd_archive::{
    ContactPoint, CubicRow, GeometryRow, JunctionRow, LaneRow, LaneSpeedRow, LaneType, LinkKind,
    MapRow, NONE, Range, RoadRow, RoadType, RoadTypeRow, Rows, SectionRow, SpeedKind, StringTable,
    lane_flags,
};
use mapd_geometry::{Curve, ParameterRange, Primitive, Start, compile};
use mapd_xodr::{
    self as xodr, CubicRecord, Finding, GeometryShape, Header, Junction, LaneDirection, PRange,
    Position, Road, Severity, Span, SpeedMax, TrafficRule,
};

/// A parametric curve's stated length may differ from its true one by this much `[m]` before it is a finding
/// (as in ASAM's quality checker).
const LENGTH_MISMATCH: f64 = 1e-3;

/// Gaps between geometries up to this size `[m]` come from rounding in the file.
const GAP: f64 = 0.01;

/// Links as written, kept until every id is known.
#[derive(Default)]
pub(crate) struct Links {
    /// Per road: predecessor and successor as written.
    pub(crate) roads: Vec<[Option<xodr::RoadLink>; 2]>,
    /// Per road: the junction that it names.
    pub(crate) road_junctions: Vec<Option<String>>,
    /// Per road: place of its start tag.
    pub(crate) road_spans: Vec<Span>,
    /// Per lane row: predecessors and successors as written, ranges of `lane_numbers`.
    pub(crate) lanes: Vec<[Range; 2]>,
    pub(crate) lane_numbers: Vec<xodr::LinkedLane>,
    /// Junctions as written.
    pub(crate) junctions: Vec<Junction>,
}

/// The rows of what has been read so far.
#[derive(Default)]
pub(crate) struct Lowering {
    pub(crate) rows: Rows,
    pub(crate) strings: StringTable,
    pub(crate) links: Links,
    pub(crate) permissions: Permissions,
    map: Option<MapRow>,
}

impl Lowering {
    pub(crate) fn roads(&self) -> usize {
        self.rows.roads.len()
    }

    pub(crate) fn header(&mut self, header: &Header) {
        let mut row: MapRow = bytemuck::Zeroable::zeroed();
        row.stated_north = header.north.unwrap_or(0.0);
        row.stated_south = header.south.unwrap_or(0.0);
        row.stated_east = header.east.unwrap_or(0.0);
        row.stated_west = header.west.unwrap_or(0.0);
        row.name = self.strings.add(&header.name);
        row.version = self.strings.add(&header.version);
        row.date = self.strings.add(&header.date);
        row.vendor = self.strings.add(&header.vendor);
        row.geo_reference = self.strings.add(header.geo_reference.as_deref().unwrap_or(""));
        row.rev_major = header.rev_major.unwrap_or(0);
        row.rev_minor = header.rev_minor.unwrap_or(0);
        self.map = Some(row);
    }

    /// Appends a road. Its links are resolved later; whatever makes it unusable is an error finding.
    pub(crate) fn road(&mut self, road: &Road, position: Position, findings: &mut Vec<Finding>) {
        let path = format!("OpenDRIVE/road[@id={}]", road.id);
        let number = self.rows.roads.len() as u32;
        let geometries = self.geometries(road, &path, findings);
        let elevations = self.cubics(&road.elevations, 0.0);
        let superelevations = self.cubics(&road.superelevations, 0.0);
        let lane_offsets = self.cubics(&road.lane_offsets, 0.0);
        let types = self.types(road);
        let before = self.rows.sections.len();
        for (i, section) in road.sections.iter().enumerate() {
            let s_end = road.sections.get(i + 1).map_or(road.length, |next| next.s).max(section.s);
            self.section(road, number, i as u32, section, s_end, &path, findings);
        }
        let sections = between(before, self.rows.sections.len());
        self.links.roads.push([road.predecessor.clone(), road.successor.clone()]);
        self.links.road_junctions.push(road.junction.clone());
        self.links.road_spans.push(road.span);
        for name in &road.unsupported {
            let message = format!(
                "{name} is not built into the map yet: surface heights of this road lack it"
            );
            findings.push(finding(
                "mapd:compile.unsupported",
                Severity::Info,
                road.span,
                path.clone(),
                message,
                "",
            ));
        }
        let row = RoadRow {
            length: road.length,
            id: self.strings.add(&road.id),
            name: self.strings.add(&road.name),
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
            rule: u8::from(road.rule == TrafficRule::LeftHand),
            reserved: [0; 7],
        };
        self.rows.roads.push(row);
    }

    fn geometries(&mut self, road: &Road, path: &str, findings: &mut Vec<Finding>) -> Range {
        let before = self.rows.geometries.len();
        let mut end = None;
        for g in &road.plan_view {
            let path = || format!("{path}/planView/geometry[@s={}]", g.s);
            let (primitive, parameter_range) = primitive(&g.shape);
            if parameter_range == 0 && matches!(primitive, Primitive::ParamPoly3 { .. }) {
                let message =
                    "expected paramPoly3/@pRange, found none; read as normalized".to_owned();
                let hint = "write pRange=\"normalized\" or pRange=\"arcLength\"";
                findings.push(finding(
                    "mapd:compile.p_range",
                    Severity::Warning,
                    g.span,
                    path(),
                    message,
                    hint,
                ));
            }
            let compiled = match compile(&primitive, g.length) {
                Ok(compiled) => compiled,
                Err(error) => {
                    let message = format!("the curve cannot be evaluated: {error}");
                    findings.push(finding(
                        "mapd:compile.curve",
                        Severity::Error,
                        g.span,
                        path(),
                        message,
                        "",
                    ));
                    continue;
                }
            };
            if compiled.length_mismatch.abs() > LENGTH_MISMATCH {
                let message = format!(
                    "expected a curve of the stated length {} m, found one that is {:.6} m longer; evaluated in true arc length, scaled to the stated one",
                    g.length, compiled.length_mismatch
                );
                let rule = "asam.net:xodr:1.7.0:road.geometry.paramPoly3.length_match";
                findings.push(finding(rule, Severity::Warning, g.span, path(), message, ""));
            }
            let start = Start::new(g.x, g.y, g.hdg);
            let gap = end.map_or(0.0, |(x, y): (f64, f64)| {
                ((g.x - x) * (g.x - x) + (g.y - y) * (g.y - y)).sqrt()
            });
            if gap > GAP {
                let message = format!(
                    "expected a start where the geometry before ends, found one {gap:.3} m away; kept as written"
                );
                let rule = "asam.net:xodr:1.4.0:road.geometry.refline_no_gaps";
                findings.push(finding(rule, Severity::Warning, g.span, path(), message, ""));
            }
            end = Curve::new(compiled.kind, start, g.length, &compiled.coefficients).map(|curve| {
                let end = curve.evaluate(g.length);
                (end.x, end.y)
            });
            let first = self.rows.coefficients.len();
            self.rows.coefficients.extend_from_slice(&compiled.coefficients);
            self.rows.geometries.push(GeometryRow {
                s: g.s,
                x: g.x,
                y: g.y,
                hdg: g.hdg,
                cos: start.cos,
                sin: start.sin,
                length: g.length,
                coefficients: between(first, self.rows.coefficients.len()),
                error: (compiled.error as f32).next_up(),
                kind: compiled.kind.code(),
                parameter_range,
                reserved: [0; 2],
            });
        }
        between(before, self.rows.geometries.len())
    }

    /// Records with `shift` added to their s, by s. Where the file's order differs (a finding: by rounding a warning, else
    /// an error) s decides, because a record holds until the next one along the road.
    fn cubics(&mut self, records: &[CubicRecord], shift: f64) -> Range {
        let before = self.rows.cubics.len();
        let row = |r: &CubicRecord| CubicRow { s: r.s + shift, a: r.a, b: r.b, c: r.c, d: r.d };
        self.rows.cubics.extend(records.iter().map(row));
        self.rows.cubics[before..].sort_by(|a, b| a.s.total_cmp(&b.s));
        between(before, self.rows.cubics.len())
    }

    fn types(&mut self, road: &Road) -> Range {
        let before = self.rows.road_types.len();
        for record in &road.types {
            let (kind, speed) = speed(record.speed.as_ref());
            self.rows.road_types.push(RoadTypeRow {
                s: record.s,
                speed,
                country: self.strings.add(&record.country),
                kind: RoadType::from_name(record.kind.name()).code(),
                speed_kind: kind.code(),
                reserved: [0; 2],
            });
        }
        between(before, self.rows.road_types.len())
    }

    #[expect(clippy::too_many_arguments, reason = "the section's whole context, used once")]
    fn section(
        &mut self,
        road: &Road,
        road_number: u32,
        number: u32,
        section: &xodr::LaneSection,
        s_end: f64,
        path: &str,
        findings: &mut Vec<Finding>,
    ) {
        let path = format!("{path}/lanes/laneSection[@s={}]", section.s);
        if section.single_side {
            let message =
                "a section that replaces one side only (singleSide) is not built yet".to_owned();
            findings.push(finding(
                "mapd:compile.single_side",
                Severity::Error,
                section.span,
                path.clone(),
                message,
                "",
            ));
        }
        let section_row = self.rows.sections.len() as u32;
        let before = self.rows.lanes.len();
        let mut lanes: Vec<&xodr::Lane> = section.lanes.iter().collect();
        lanes.sort_by_key(|lane| std::cmp::Reverse(lane.id));
        for pair in lanes.windows(2).filter(|pair| pair[0].id == pair[1].id) {
            let message = format!("lane {} occurs twice in this section", pair[1].id);
            let rule = "asam.net:xodr:1.4.0:ids.id_unique_in_lane_section";
            findings.push(finding(rule, Severity::Error, pair[1].span, path.clone(), message, ""));
        }
        let center = lanes.partition_point(|lane| lane.id > 0);
        let has_center = lanes.get(center).is_some_and(|lane| lane.id == 0);
        if !has_center {
            let message =
                "expected a center lane with id 0, found none; the reference line stands in"
                    .to_owned();
            findings.push(finding(
                "mapd:compile.center_lane",
                Severity::Warning,
                section.span,
                path,
                message,
                "",
            ));
        }
        let (left, right) = lanes.split_at(center);
        for lane in left {
            self.lane(road, section, section_row, lane);
        }
        if !has_center {
            self.push_lane(
                section_row,
                0,
                LaneType::None.code(),
                0,
                [Range::default(); 2],
                [&[], &[]],
            );
        }
        for lane in right {
            self.lane(road, section, section_row, lane);
        }
        self.rows.sections.push(SectionRow {
            s_start: section.s,
            s_end,
            road: road_number,
            lanes: between(before, self.rows.lanes.len()),
            number,
        });
    }

    fn lane(
        &mut self,
        road: &Road,
        section: &xodr::LaneSection,
        section_row: u32,
        lane: &xodr::Lane,
    ) {
        // Width and border both present: width wins (OpenDRIVE 1.8.1, 11.6.2).
        let by_border = lane.widths.is_empty() && !lane.borders.is_empty();
        let records = if by_border { &lane.borders } else { &lane.widths };
        let widths = if lane.id == 0 { Range::default() } else { self.cubics(records, section.s) };
        let before = self.rows.lane_speeds.len();
        for record in &lane.speeds {
            let (kind, max) = speed(Some(&record.speed));
            let s = section.s + record.s;
            self.rows.lane_speeds.push(LaneSpeedRow {
                s,
                max,
                kind: kind.code().into(),
                reserved: 0,
            });
        }
        let speeds = between(before, self.rows.lane_speeds.len());
        let right_hand = road.rule == TrafficRule::RightHand;
        let mut forward = (lane.id < 0) == right_hand && lane.id != 0;
        let kind = LaneType::from_name(lane.kind.name());
        let mut flags = 0;
        match lane.direction {
            LaneDirection::Reversed => forward = !forward && lane.id != 0,
            LaneDirection::Both => flags |= lane_flags::BOTH,
            LaneDirection::Standard => {}
        }
        let set = [
            (forward, lane_flags::FORWARD),
            (lane.level, lane_flags::LEVEL),
            (by_border, lane_flags::BORDER),
            (kind == LaneType::Bidirectional, lane_flags::BOTH),
        ];
        flags |= set.iter().filter(|(on, _)| *on).fold(0, |all, (_, flag)| all | flag);
        let links = [lane.predecessors.as_slice(), lane.successors.as_slice()];
        self.permissions.lane(self.rows.lanes.len() as u32, kind, lane);
        self.push_lane(section_row, lane.id, kind.code(), flags, [widths, speeds], links);
    }

    fn push_lane(
        &mut self,
        section: u32,
        number: i32,
        kind: u8,
        flags: u8,
        [widths, speeds]: [Range; 2],
        links: [&[xodr::LinkedLane]; 2],
    ) {
        let ranges = links.map(|numbers| {
            let before = self.links.lane_numbers.len();
            self.links.lane_numbers.extend_from_slice(numbers);
            between(before, self.links.lane_numbers.len())
        });
        self.links.lanes.push(ranges);
        self.rows.lanes.push(LaneRow {
            x: 0.0,
            y: 0.0,
            z: 0.0,
            section,
            widths,
            speeds,
            nodes: Range::default(),
            center: Range::default(),
            border: Range::default(),
            number,
            kind,
            flags,
            reserved: [0; 6],
        });
    }

    pub(crate) fn junction(&mut self, junction: &Junction, position: Position) {
        self.rows.junctions.push(JunctionRow {
            id: self.strings.add(&junction.id),
            name: self.strings.add(&junction.name),
            connections: Range::default(),
            line: position.line,
            column: position.column,
            kind: match junction.kind {
                xodr::JunctionKind::Default => 0,
                xodr::JunctionKind::Direct => 1,
                xodr::JunctionKind::Virtual => 2,
                xodr::JunctionKind::Crossing => 3,
            },
            reserved: [0; 3],
        });
        self.links.junctions.push(junction.clone());
    }

    /// What can be said of the document as a whole.
    pub(crate) fn finish_reading(&mut self, findings: &mut Vec<Finding>) {
        if self.rows.roads.is_empty() {
            let message = "the map has no roads".to_owned();
            let path = "OpenDRIVE".to_owned();
            findings.push(finding(
                "mapd:compile.no_roads",
                Severity::Warning,
                Span::default(),
                path,
                message,
                "",
            ));
        }
        if self.strings.is_full() {
            let message = "names and ids need more than 4 GiB".to_owned();
            let path = "OpenDRIVE".to_owned();
            findings.push(finding(
                "mapd:compile.strings",
                Severity::Error,
                Span::default(),
                path,
                message,
                "",
            ));
        }
    }

    /// The tables so far, geometry moved to the local origin.
    pub(crate) fn into_rows(self, options: &CompileOptions) -> Rows {
        let mut rows = self.rows;
        let (x, y) = origin::choose(&rows.geometries);
        for g in rows.geometries.iter_mut() {
            g.x -= x;
            g.y -= y;
        }
        let mut map = self.map.unwrap_or_else(bytemuck::Zeroable::zeroed);
        (map.origin_x, map.origin_y) = (x, y);
        map.index_tolerance = options.index_tolerance;
        map.bound_tolerance = options.bound_tolerance;
        map.road_length = rows.roads.iter().map(|road| road.length).sum();
        rows.map.push(map);
        let (bytes, offsets) = self.strings.into_tables();
        rows.string_bytes = bytes.into();
        rows.string_offsets = offsets.into();
        rows
    }
}

/// Rows between two lengths. Tables that outgrow 32 bits are refused at the end, before anything is written.
pub(crate) fn between(before: usize, after: usize) -> Range {
    Range::between(before, after).unwrap_or_default()
}

/// The primitive and the code of `pRange` as written.
fn primitive(shape: &GeometryShape) -> (Primitive, u8) {
    match *shape {
        GeometryShape::Line => (Primitive::Line, 0),
        GeometryShape::Arc { curvature } => (Primitive::Arc { curvature }, 0),
        GeometryShape::Spiral { curv_start, curv_end } => {
            (Primitive::Spiral { curvature_start: curv_start, curvature_end: curv_end }, 0)
        }
        GeometryShape::Poly3 { a, b, c, d } => (Primitive::Poly3 { v: [a, b, c, d] }, 0),
        GeometryShape::ParamPoly3 { au, bu, cu, du, av, bv, cv, dv, p_range } => {
            let (range, code) = match p_range {
                Some(PRange::ArcLength) => (ParameterRange::ArcLength, 1),
                Some(PRange::Normalized) => (ParameterRange::Normalized, 2),
                None => (ParameterRange::Normalized, 0),
            };
            (Primitive::ParamPoly3 { u: [au, bu, cu, du], v: [av, bv, cv, dv], range }, code)
        }
    }
}

/// What a speed record says, in m/s.
fn speed(speed: Option<&xodr::Speed>) -> (SpeedKind, f64) {
    match speed {
        None => (SpeedKind::None, 0.0),
        Some(speed) => match speed.max {
            SpeedMax::NoLimit => (SpeedKind::NoLimit, 0.0),
            SpeedMax::Undefined => (SpeedKind::Undefined, 0.0),
            SpeedMax::Value(_) => (SpeedKind::Value, speed.meters_per_second().unwrap_or(0.0)),
        },
    }
}
