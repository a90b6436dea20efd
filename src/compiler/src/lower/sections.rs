//! Lane sections and lanes.

use super::need::{ElementContext, ElementPath};
use super::permissions::is_open;
use super::speeds::speed;
use super::surface::place;
use crate::draft::{Draft, between};
use bytemuck::Zeroable as _;
use mapd_archive::{
    AnnotationOwner, LaneRow, LaneSpeedRow, LaneType, MOST_OF_LANE, NONE, Range, SectionRow,
    VehicleClass, lane_flags,
};
use mapd_rules::catalog::building;
use mapd_xodr::{self as xodr, Finding, LaneDirection, Severity, Span, Text as _, Value as _};

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

/// The road on which lanes lie.
#[derive(Clone, Copy)]
pub(super) struct OnRoad<'a> {
    pub(super) row: u32,
    /// Length `[m]`.
    pub(super) length: f64,
    /// Traffic keeps to the right.
    pub(super) right_hand: bool,
    /// Path of the element in findings.
    pub(super) path: &'a str,
}

/// Lanes that a section has at most, without lane 0. Many things are for all lanes of a section, or lie beside all that are further in. Maps at hand have up to 16.
const LANES: usize = 1024;

/// Lanes that go on past sections for the other side, at most: so many for each section of their road, all together. Each is a
/// row for each such section, so that without a limit rows would grow with the square of the text.
const CONTINUED_LANES: usize = 64;

/// Where the lanes of one side of a stretch are written.
#[derive(Clone, Copy)]
struct Side {
    layer: Layer,
    /// Start of the section in which they are `[m]`.
    s: f64,
    /// The stretch's start `[m]`.
    begins: f64,
    /// Number of sections of the road between that one and the stretch; 0 where the stretch is the section itself.
    continues: u16,
}

/// The stretch from a section's start to the next one's.
struct Stretch<'a, 'b> {
    /// The section's start tag.
    span: Span,
    /// Its start `[m]`.
    s: f64,
    sides: [Side; 2],
    /// Lanes to the left and to the right, each from the leftmost on.
    lanes: &'b [Vec<AnyLane<'a>>; 2],
    /// Lane 0, which is always that of the section itself.
    center: Option<&'b AnyLane<'a>>,
}

/// The usable lanes of a section, from the leftmost on. Of lanes with one id, of which a rule tells, the first is meant.
fn lanes_of<'a>(
    section: &'a xodr::LaneSection,
    road: &str,
    findings: &mut Vec<Finding>,
) -> Vec<AnyLane<'a>> {
    let mut id = |span, id: &Option<xodr::Attribute<i32>>| {
        ElementContext { span, path: ElementPath::new(road, LANE), findings }
            .need_lane(id.value(), "id")
    };
    let sides = [section.left.as_deref(), section.right.as_deref()];
    let sides = sides.map(|side| side.map_or(&[][..], |side| &side.lane));
    let mut lanes = Vec::with_capacity(sides.iter().map(|side| side.len()).sum::<usize>() + 1);
    for lane in sides.into_iter().flatten() {
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
    lanes.dedup_by_key(|lane| lane.id);
    lanes
}

/// For the stretch from each section's start to the next one's, where its left and its right lanes are written: in that
/// section, or, where that is for the other side only (`singleSide`), in the last one for their side
/// (OpenDRIVE 1.8.1, 11.3).
fn sides(
    placed: &[(f64, &xodr::LaneSection)],
    layer: Layer,
    road: &str,
    findings: &mut Vec<Finding>,
) -> Vec<[Side; 2]> {
    let has = |section: &xodr::LaneSection| {
        [&section.left, &section.right]
            .map(|side| side.as_ref().is_some_and(|side| !side.lane.is_empty()))
    };
    let mut written = [0usize; 2];
    let mut stretches: Vec<[Side; 2]> = Vec::with_capacity(placed.len());
    for (i, (s, section)) in placed.iter().enumerate() {
        let mut replaces = [true; 2];
        // Of temporary lanes, what a section does not have is not there.
        if section.single_side.value() == Some(true) && !layer.is_temporary {
            let has = has(section);
            let mut part = ElementContext {
                span: section.span,
                path: ElementPath::new(road, "lanes/laneSection"),
                findings,
            };
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
        let mut stretch = [Side { layer, s: *s, begins: *s, continues: 0 }; 2];
        for (k, side) in stretch.iter_mut().enumerate() {
            if replaces[k] {
                written[k] = i;
            } else if let Some(before) = stretches.last().and_then(|before| before.get(k)) {
                let continues = u16::try_from(i - written[k]);
                if continues.is_err() && i - written[k] == usize::from(u16::MAX) + 1 {
                    let path = ElementPath::new(road, "lanes/laneSection");
                    let mut part = ElementContext { span: section.span, path, findings };
                    let message = format!(
                        "expected lanes that go on past at most {} sections with singleSide, found more",
                        u16::MAX
                    );
                    part.add(&building::TOO_LARGE, Severity::Error, message);
                }
                let continues = continues.unwrap_or(u16::MAX);
                *side = Side { begins: *s, continues, ..*before };
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
        on: OnRoad<'_>,
        layer: Layer,
        sections: &[xodr::LaneSection],
        findings: &mut Vec<Finding>,
    ) -> Range {
        let path = on.path;
        let before = self.rows.sections.len();
        // A section without s has no place: it is passed over, and the map with it.
        let placed: Vec<(f64, &xodr::LaneSection)> = sections
            .iter()
            .filter_map(|section| {
                let path = ElementPath::new(path, "lanes/laneSection");
                let mut part = ElementContext { span: section.span, path, findings };
                Some((part.need_along(section.s.value(), "s")?, section))
            })
            .collect();
        let sides = sides(&placed, layer, path, findings);
        let mut lanes = [Vec::new(), Vec::new()];
        let mut spare = CONTINUED_LANES * placed.len();
        for (i, (s, section)) in placed.iter().enumerate() {
            let next = placed.get(i + 1).map_or(on.length, |(next, _)| *next);
            // Only sections of the temporary layer have a length of their own (OpenDRIVE 1.9, laneSection@length).
            let own = section.length.value().filter(|_| layer.is_temporary);
            let s_end = own.map_or(next, |own| next.min(s + own)).max(*s);
            let row = self.rows.sections.len() as u32;
            self.owners.add(section.span, AnnotationOwner::Section, row);
            let mut right = lanes_of(section, path, findings);
            if right.len() > LANES + 1 {
                let path = ElementPath::new(path, "lanes/laneSection");
                let mut part = ElementContext { span: section.span, path, findings };
                let message =
                    format!("expected at most {LANES} lanes in a section, found {}", right.len());
                part.add(&building::TOO_LARGE, Severity::Error, message);
                right.clear();
            }
            let count = right.partition_point(|lane| lane.id > 0);
            // Of one id there is one lane.
            let center = right.get(count).copied().filter(|lane| lane.id == 0);
            let others = count + usize::from(center.is_some());
            let left = right.drain(..others).take(count).collect();
            for ((lanes, side), own) in lanes.iter_mut().zip(sides[i]).zip([left, right]) {
                if side.continues == 0 {
                    *lanes = own;
                } else if let Some(left) = spare.checked_sub(lanes.len()) {
                    spare = left;
                } else {
                    // They end here, which the error says once.
                    lanes.clear();
                    let path = ElementPath::new(path, "lanes/laneSection");
                    let mut part = ElementContext { span: section.span, path, findings };
                    let message = format!(
                        "expected at most {CONTINUED_LANES} lanes for each section that go on past sections with singleSide, found more"
                    );
                    part.add(&building::TOO_LARGE, Severity::Error, message);
                }
            }
            let (span, sides, center) = (section.span, sides[i], center.as_ref());
            let stretch = Stretch { span, s: *s, sides, lanes: &lanes, center };
            let lanes = self.stretch(on, &stretch, findings);
            self.rows.sections.push(SectionRow {
                s_start: *s,
                s_end,
                road: on.row,
                lanes,
                number: i as u32,
                ..SectionRow::zeroed()
            });
        }
        between(before, self.rows.sections.len())
    }

    /// Appends the lanes of a stretch between two section starts.
    fn stretch(
        &mut self,
        on: OnRoad<'_>,
        stretch: &Stretch<'_, '_>,
        findings: &mut Vec<Finding>,
    ) -> Range {
        let [left_side, right_side] = stretch.sides;
        let [left, right] = stretch.lanes;
        if stretch.center.is_none() {
            let s = stretch.s;
            let message =
                "expected a center lane with id 0, found none; the reference line stands in"
                    .to_owned();
            let tail = format!("lanes/laneSection[@s={s}]");
            let mut part = ElementContext {
                span: stretch.span,
                path: ElementPath::new(on.path, &tail),
                findings,
            };
            part.add(&building::CENTER_LANE, Severity::Warning, message);
        }
        let section_row = self.rows.sections.len() as u32;
        let before = self.rows.lanes.len();
        for lane in left {
            self.lane(on, section_row, left_side, lane, findings);
        }
        match stretch.center {
            Some(lane) => {
                let Stretch { s, .. } = *stretch;
                let side = Side { s, begins: s, continues: 0, ..right_side };
                self.lane(on, section_row, side, lane, findings);
            }
            None => self.rows.lanes.push(LaneRow {
                section: section_row,
                first_mark: NONE,
                kind: LaneType::None.code(),
                flags: left_side.layer.flags(),
                ..LaneRow::zeroed()
            }),
        }
        for lane in right {
            self.lane(on, section_row, right_side, lane, findings);
        }
        between(before, self.rows.lanes.len())
    }

    fn lane(
        &mut self,
        on: OnRoad<'_>,
        section: u32,
        side: Side,
        lane: &AnyLane<'_>,
        findings: &mut Vec<Finding>,
    ) {
        let (road, section_s) = (on.path, side.s);
        self.lane_surface(lane.height, lane.material, section_s, road, findings);
        let marks = self.lane_marks(lane.road_mark, section_s, road, findings);
        // Width and border both present: width wins (OpenDRIVE 1.8.1, 11.6.2).
        let by_border = lane.width.is_empty() && !lane.border.is_empty();
        let widths = if lane.id == 0 {
            Range::default()
        } else if by_border {
            let path = ElementPath::new(road, "lanes/laneSection/lane/border");
            self.cubics(lane.border, section_s, path, findings)
        } else {
            self.cubics(
                lane.width,
                section_s,
                ElementPath::new(road, "lanes/laneSection/lane/width"),
                findings,
            )
        };
        if widths.count as usize > MOST_OF_LANE {
            let path = ElementPath::new(road, "lanes/laneSection/lane");
            let mut part = ElementContext { span: lane.span, path, findings };
            let found = widths.count;
            let message =
                format!("expected at most {MOST_OF_LANE} records of width, found {found}");
            part.add(&building::TOO_LARGE, Severity::Error, message);
        }
        let own = self.rows.lanes.len() as u32;
        for record in lane.speed {
            let path = ElementPath::new(road, "lanes/laneSection/lane/speed");
            let mut part = ElementContext { span: record.span, path, findings };
            let s = place(record.s_offset.value(), "sOffset", &mut part);
            let Some(s) = s else { continue };
            let (kind, max) = speed(record.max.value(), record.unit.value(), &mut part);
            self.rows.lane_speeds.push(LaneSpeedRow {
                s: section_s + s,
                max,
                lane: own,
                kind: kind.code().into(),
            });
        }
        self.lane_words(lane.visibility, lane.rule, section_s, road, findings);
        let mut forward = (lane.id < 0) == on.right_hand && lane.id != 0;
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
        let shift = side.begins - side.s;
        let row = self.rows.lanes.len() as u32;
        if side.continues == 0 {
            self.owners.add(lane.span, AnnotationOwner::Lane, row);
            for record in lane.access.iter().filter(|record| lane.id != 0 && is_open(record)) {
                let path = ElementPath::new(road, "lanes/laneSection/lane/access");
                let mut part = ElementContext { span: record.span, path, findings };
                let read_as = match record.rule.value() {
                    Some(xodr::AccessRule::Allow) => "it opens the lane to nobody",
                    _ => "it closes the lane to all motor vehicles",
                };
                let message = format!(
                    "expected a word of the standard for who is meant, found none; {read_as}"
                );
                part.add(&building::ACCESS, Severity::Warning, message);
            }
        }
        self.permissions.lane(row, shift, (lane.id, kind), lane.road_mark, lane.access);
        // Links into another layer are no links between these lanes.
        let other = if side.layer.is_temporary { PERMANENT } else { TEMPORARY };
        let links = lane.link.into_iter().flat_map(|link| [&link.predecessor, &link.successor]);
        for link in links.flatten().filter(|link| link.layer.text() != other) {
            let path = ElementPath::new(road, "lanes/laneSection/lane/link");
            place(link.id.value(), "id", &mut ElementContext { span: link.span, path, findings });
        }
        self.rows.lanes.push(LaneRow {
            section,
            first_width: widths.first,
            first_mark: marks,
            // More are an error.
            width_count: u16::try_from(widths.count).unwrap_or(u16::MAX),
            number: lane.id,
            kind: kind.code(),
            flags,
            continues: side.continues,
            ..LaneRow::zeroed()
        });
    }
}
