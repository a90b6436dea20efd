//! Lane sections and lanes.

use super::need::Part;
use super::speeds::speed;
use super::surface::place;
use crate::draft::{Draft, WrittenLink, between};
use bytemuck::Zeroable as _;
use mapd_archive::{
    AnnotationOwner, LaneRow, LaneSpeedRow, LaneType, MOST_OF_LANE, NONE, Range, SectionRow,
    VehicleClass, lane_flags,
};
use mapd_rules::catalog::building;
use mapd_xodr::{
    self as xodr, Finding, LaneDirection, Road, Severity, Span, Text as _, TrafficRule, Value as _,
};

/// Path of lanes below their road.
const LANE: &str = "lanes/laneSection/lane";
/// Words for the layer of a linked lane (OpenDRIVE 1.9, e_layerType).
const PERMANENT: &str = "permanent";
const TEMPORARY: &str = "temporary";

/// A lane of any of the three groups.
#[derive(Clone, Copy)]
struct AnyLane<'a> {
    id: i32,
    kind: Option<xodr::LaneType>,
    level: bool,
    direction: Option<LaneDirection>,
    link: Option<&'a xodr::LaneLink>,
    width: &'a [xodr::LaneWidth],
    border: &'a [xodr::LaneBorder],
    speed: &'a [xodr::LaneSpeed],
    height: &'a [xodr::LaneHeight],
    material: &'a [xodr::LaneMaterial],
    road_mark: &'a [xodr::RoadMark],
    access: &'a [xodr::LaneAccess],
    visibility: &'a [xodr::LaneVisibility],
    rule: &'a [xodr::LaneRule],
    span: Span,
}

/// Of which layer lanes are.
#[derive(Clone, Copy)]
pub(super) struct Layer {
    /// They replace others for a time (1.9).
    pub(super) is_temporary: bool,
}

impl Layer {
    fn flags(self) -> u8 {
        if self.is_temporary { lane_flags::TEMPORARY } else { 0 }
    }
}

/// Where the lanes of one side of a stretch are written.
#[derive(Clone, Copy)]
struct Side<'a> {
    layer: Layer,
    section: &'a xodr::LaneSection,
    /// The section's start `[m]`.
    s: f64,
    /// The stretch's start `[m]`.
    begins: f64,
    /// Number of sections of the road between that one and the stretch; 0 where the stretch is the section itself.
    continues: u16,
    /// Whether the lanes go on in the next stretch.
    goes_on: bool,
}

/// The usable lanes of a section, from the leftmost on.
fn lanes_of<'a>(
    section: &'a xodr::LaneSection,
    road: &str,
    findings: &mut Vec<Finding>,
) -> Vec<AnyLane<'a>> {
    let mut id = |span, id: &Option<xodr::Attribute<i32>>| {
        Part { span, path: (road, LANE), findings }.need_lane(id.value(), "id")
    };
    let mut lanes = Vec::new();
    let sides = [section.left.as_deref(), section.right.as_deref()];
    for lane in sides.into_iter().flatten().flat_map(|side| &side.lane) {
        lanes.extend(id(lane.span, &lane.id).map(|id| AnyLane {
            id,
            kind: lane.r#type.value(),
            level: lane.level.value().unwrap_or(false),
            direction: lane.direction.value(),
            link: lane.link.as_deref(),
            width: &lane.width,
            border: &lane.border,
            speed: &lane.speed,
            height: &lane.height,
            material: &lane.material,
            road_mark: &lane.road_mark,
            access: &lane.access,
            visibility: &lane.visibility,
            rule: &lane.rule,
            span: lane.span,
        }));
    }
    for lane in section.center.iter().flat_map(|center| &center.lane) {
        lanes.extend(id(lane.span, &lane.id).map(|id| AnyLane {
            id,
            kind: lane.r#type.value(),
            level: lane.level.value().unwrap_or(false),
            direction: None,
            link: lane.link.as_deref(),
            width: &lane.width,
            border: &lane.border,
            speed: &lane.speed,
            height: &lane.height,
            material: &lane.material,
            road_mark: &lane.road_mark,
            access: &lane.access,
            visibility: &[],
            rule: &lane.rule,
            span: lane.span,
        }));
    }
    lanes.sort_by_key(|lane| (std::cmp::Reverse(lane.id), lane.span.start));
    lanes
}

/// For the stretch from each section's start to the next one's, where its left and its right lanes are written: in that
/// section, or, where that is for the other side only (`singleSide`), in the last one for their side
/// (OpenDRIVE 1.8.1, 11.3).
fn sides<'a>(
    placed: &[(f64, &'a xodr::LaneSection)],
    layer: Layer,
    road: &str,
    findings: &mut Vec<Finding>,
) -> Vec<[Side<'a>; 2]> {
    let has = |section: &xodr::LaneSection| {
        [&section.left, &section.right]
            .map(|side| side.as_ref().is_some_and(|side| !side.lane.is_empty()))
    };
    let mut written = [0usize; 2];
    let mut stretches: Vec<[Side<'a>; 2]> = Vec::with_capacity(placed.len());
    for (i, (s, section)) in placed.iter().enumerate() {
        let mut replaces = [true; 2];
        // Of temporary lanes, what a section does not have is not there.
        if section.single_side.value() == Some(true) && !layer.is_temporary {
            let has = has(section);
            let mut part = Part { span: section.span, path: (road, "lanes/laneSection"), findings };
            if has[0] == has[1] {
                let message = "expected lanes on one side of a section with singleSide, found them on both or none; read as a section for both".to_owned();
                part.add(&building::SINGLE_SIDE, Severity::Warning, message);
            } else if i == 0 {
                let message = "the road's first section is for one side only: the other one begins without lanes".to_owned();
                part.add(&building::SINGLE_SIDE, Severity::Warning, message);
            } else {
                replaces = has;
            }
        }
        let mut stretch =
            [Side { layer, section, s: *s, begins: *s, continues: 0, goes_on: false }; 2];
        for (k, side) in stretch.iter_mut().enumerate() {
            if replaces[k] {
                written[k] = i;
            } else if let Some(before) = stretches.last_mut().and_then(|before| before.get_mut(k)) {
                before.goes_on = true;
                let continues = u16::try_from(i - written[k]).unwrap_or(u16::MAX);
                *side = Side { begins: *s, continues, goes_on: false, ..*before };
            }
        }
        stretches.push(stretch);
    }
    stretches
}

impl Draft {
    /// Appends a road's sections.
    pub(super) fn sections(
        &mut self,
        road: &Road,
        (sections, layer): (&[xodr::LaneSection], Layer),
        (number, length): (u32, f64),
        path: &str,
        findings: &mut Vec<Finding>,
    ) -> Range {
        let before = self.rows.sections.len();
        // A section without s has no place: it is passed over, and the map with it.
        let placed: Vec<(f64, &xodr::LaneSection)> = sections
            .iter()
            .filter_map(|section| {
                let path = (path, "lanes/laneSection");
                let mut part = Part { span: section.span, path, findings };
                Some((part.need_along(section.s.value(), "s")?, section))
            })
            .collect();
        let right_hand = road.rule.value() != Some(TrafficRule::Lht);
        let sides = sides(&placed, layer, path, findings);
        for (i, (s, section)) in placed.iter().enumerate() {
            let next = placed.get(i + 1).map_or(length, |(next, _)| *next);
            // Only sections of the temporary layer have a length of their own (OpenDRIVE 1.9, laneSection@length).
            let own = section.length.value().filter(|_| layer.is_temporary);
            let s_end = own.map_or(next, |own| next.min(s + own)).max(*s);
            let row = self.rows.sections.len() as u32;
            self.owners.add(section.span, AnnotationOwner::Section, row);
            let lanes = self.section(section, sides[i], right_hand, path, findings);
            self.rows.sections.push(SectionRow {
                s_start: *s,
                s_end,
                road: number,
                lanes,
                number: i as u32,
                ..SectionRow::zeroed()
            });
        }
        between(before, self.rows.sections.len())
    }

    /// Appends the lanes of a stretch between two section starts.
    fn section(
        &mut self,
        section: &xodr::LaneSection,
        [left_side, right_side]: [Side<'_>; 2],
        right_hand: bool,
        road: &str,
        findings: &mut Vec<Finding>,
    ) -> Range {
        let s = if left_side.continues == 0 { left_side.s } else { right_side.s };
        let tail = || format!("lanes/laneSection[@s={s}]");
        let mut lanes = lanes_of(section, road, findings);
        for (side, sign) in [(left_side, 1), (right_side, -1)] {
            if side.continues > 0 {
                lanes.retain(|lane| lane.id.signum() != sign);
                // What is wrong with them has been said where they are written.
                let written = lanes_of(side.section, road, &mut Vec::new());
                lanes.extend(written.into_iter().filter(|lane| lane.id.signum() == sign));
            }
        }
        lanes.sort_by_key(|lane| (std::cmp::Reverse(lane.id), lane.span.start));
        // Of lanes with one id, of which a rule tells, the first is meant.
        lanes.dedup_by_key(|lane| lane.id);
        let center = lanes.partition_point(|lane| lane.id > 0);
        let has_center = lanes.get(center).is_some_and(|lane| lane.id == 0);
        if !has_center {
            let message =
                "expected a center lane with id 0, found none; the reference line stands in"
                    .to_owned();
            let mut part = Part { span: section.span, path: (road, &tail()), findings };
            part.add(&building::CENTER_LANE, Severity::Warning, message);
        }
        let section_row = self.rows.sections.len() as u32;
        let before = self.rows.lanes.len();
        let (left, right) = lanes.split_at(center);
        for lane in left {
            self.lane(section_row, left_side, right_hand, lane, road, findings);
        }
        if !has_center {
            let kind = LaneType::None.code();
            self.push_lane(
                section_row,
                (0, kind, left_side.layer.flags(), 0),
                (Range::default(), NONE),
                [&[], &[]],
            );
        }
        for lane in right {
            self.lane(section_row, right_side, right_hand, lane, road, findings);
        }
        between(before, self.rows.lanes.len())
    }

    fn lane(
        &mut self,
        section: u32,
        side: Side<'_>,
        right_hand: bool,
        lane: &AnyLane<'_>,
        road: &str,
        findings: &mut Vec<Finding>,
    ) {
        let section_s = side.s;
        self.lane_surface(lane.height, lane.material, section_s, road, findings);
        let marks = self.lane_marks(lane.road_mark, section_s, road, findings);
        // Width and border both present: width wins (OpenDRIVE 1.8.1, 11.6.2).
        let by_border = lane.width.is_empty() && !lane.border.is_empty();
        let widths = if lane.id == 0 {
            Range::default()
        } else if by_border {
            let path = (road, "lanes/laneSection/lane/border");
            self.cubics(lane.border, section_s, path, findings)
        } else {
            self.cubics(lane.width, section_s, (road, "lanes/laneSection/lane/width"), findings)
        };
        if widths.count as usize > MOST_OF_LANE {
            let path = (road, "lanes/laneSection/lane");
            let mut part = Part { span: lane.span, path, findings };
            let found = widths.count;
            let message =
                format!("expected at most {MOST_OF_LANE} records of width, found {found}");
            part.add(&building::TOO_LARGE, Severity::Error, message);
        }
        let own = self.rows.lanes.len() as u32;
        for record in lane.speed {
            let path = (road, "lanes/laneSection/lane/speed");
            let mut part = Part { span: record.span, path, findings };
            let s = place(record.s_offset.value(), "sOffset", &mut part);
            let Some(s) = s else { continue };
            let (kind, max) = speed(record.max.value(), record.unit.value());
            self.rows.lane_speeds.push(LaneSpeedRow {
                s: section_s + s,
                max,
                lane: own,
                kind: kind.code().into(),
            });
        }
        self.lane_words(lane.visibility, lane.rule, section_s, road, findings);
        let mut forward = (lane.id < 0) == right_hand && lane.id != 0;
        let kind = LaneType::from_name(lane.kind.map_or("", xodr::LaneType::name));
        let mut flags = side.layer.flags();
        match lane.direction {
            Some(LaneDirection::Reversed) => forward = !forward && lane.id != 0,
            Some(LaneDirection::Both) => flags |= lane_flags::BOTH,
            _ => {}
        }
        let set = [
            (forward, lane_flags::FORWARD),
            (lane.level, lane_flags::LEVEL),
            (by_border, lane_flags::BORDER),
            (kind == LaneType::Bidirectional, lane_flags::BOTH),
            (
                VehicleClass::of_lane_type(kind) == VehicleClass::Pedestrian.bit(),
                lane_flags::WALKED,
            ),
        ];
        flags |= set.iter().filter(|(on, _)| *on).fold(0, |all, (_, flag)| all | flag);
        // Lane 0 is always that of the stretch's own section.
        let shift = if lane.id == 0 { 0.0 } else { side.begins - side.s };
        let row = self.rows.lanes.len() as u32;
        if side.continues == 0 || lane.id == 0 {
            self.owners.add(lane.span, AnnotationOwner::Lane, row);
        }
        self.permissions.lane((row, shift), kind, lane.road_mark, lane.access);
        let mut numbers = |linked: &[xodr::LinkedLane]| -> Vec<WrittenLink> {
            let number = |link: &xodr::LinkedLane| {
                let span = link.span;
                let path = (road, "lanes/laneSection/lane/link");
                let mut part = Part { span, path, findings };
                let number = place(link.id.value(), "id", &mut part)?;
                Some(WrittenLink { number, span })
            };
            // Links into another layer are no links between these lanes.
            let other = if side.layer.is_temporary { PERMANENT } else { TEMPORARY };
            linked.iter().filter(|link| link.layer.text() != other).filter_map(number).collect()
        };
        let [mut before, mut behind] = lane.link.map_or_else(Default::default, |link| {
            [numbers(&link.predecessor), numbers(&link.successor)]
        });
        // Where the other side alone begins a section, the lane goes on as itself.
        let itself = WrittenLink { number: lane.id, span: lane.span };
        if lane.id != 0 && side.continues > 0 {
            before = vec![itself];
        }
        if lane.id != 0 && side.goes_on {
            behind = vec![itself];
        }
        let links = [before.as_slice(), behind.as_slice()];
        let continues = if lane.id == 0 { 0 } else { side.continues };
        self.push_lane(section, (lane.id, kind.code(), flags, continues), (widths, marks), links);
    }

    fn push_lane(
        &mut self,
        section: u32,
        (number, kind, flags, continues): (i32, u8, u8, u16),
        (widths, first_mark): (Range, u32),
        links: [&[WrittenLink]; 2],
    ) {
        let ranges = links.map(|numbers| {
            let before = self.links.lane_links.len();
            self.links.lane_links.extend_from_slice(numbers);
            between(before, self.links.lane_links.len())
        });
        self.links.lanes.push(ranges);
        self.rows.lanes.push(LaneRow {
            section,
            first_width: widths.first,
            first_mark,
            // More are an error.
            width_count: u16::try_from(widths.count).unwrap_or(u16::MAX),
            number,
            kind,
            flags,
            continues,
            ..LaneRow::zeroed()
        });
    }
}
