//! Road marks: where each begins, and how it looks.

use super::need::{ElementContext, ElementPath};
use super::surface::place;
use crate::draft::Draft;
use mapd_archive::{
    CubicRow, MarkLaneChange, Range, RoadMarkColor, RoadMarkKind, RoadMarkLineRow, RoadMarkRule,
    RoadMarkStyleRow, RoadMarkWeight,
};
use mapd_rules::catalog::building;
use mapd_xodr::{self as xodr, Finding, Severity, Text as _, Value as _};

/// Stands for a number that the file does not give, and for the gap of a line that is not repeated.
const NOT_GIVEN: f64 = -1.0;

fn given(number: Option<f64>) -> f64 {
    number.filter(|n| *n >= 0.0).unwrap_or(NOT_GIVEN)
}

fn color(color: Option<xodr::RoadMarkColor>) -> u8 {
    RoadMarkColor::from_name(color.map_or("", xodr::RoadMarkColor::name)).code()
}

fn rule(rule: Option<xodr::RoadMarkRule>) -> u8 {
    RoadMarkRule::from_name(rule.map_or("", xodr::RoadMarkRule::name)).code()
}

impl Draft {
    /// First row of a lane's marks.
    pub(super) fn lane_marks(
        &mut self,
        marks: &[xodr::RoadMark],
        section_s: f64,
        road: &str,
        findings: &mut Vec<Finding>,
    ) -> u32 {
        self.styles.begin();
        for mark in marks {
            let path = ElementPath::new(road, "lanes/laneSection/lane/roadMark");
            let mut part = ElementContext { span: mark.span, path, findings };
            let Some(s) = place(mark.s_offset.value(), "sOffset", &mut part) else { continue };
            let style = self.style(mark, section_s + s, &mut part);
            self.styles.then(s, style);
        }
        self.styles.end(&mut self.rows)
    }

    fn style(&mut self, mark: &xodr::RoadMark, s: f64, part: &mut ElementContext<'_>) -> u32 {
        let before = self.rows.road_mark_lines.len();
        let pattern = mark.type_element.as_deref();
        for line in pattern.iter().flat_map(|pattern| &pattern.line) {
            self.rows.road_mark_lines.push(RoadMarkLineRow {
                length: line.length.value().unwrap_or(0.0),
                space: line.space.value().filter(|space| *space >= 0.0).unwrap_or(0.0),
                t_offset: line.t_offset.value().unwrap_or(0.0),
                s_offset: line.s_offset.value().unwrap_or(0.0),
                // A line without a width has that of the pattern.
                width: given(line.width.value().or(pattern.and_then(|p| p.width.value()))),
                rule: rule(line.rule.value()),
                color: color(line.color.value()),
                reserved: [0; 6],
            });
        }
        for line in mark.explicit.iter().flat_map(|explicit| &explicit.line) {
            self.rows.road_mark_lines.push(RoadMarkLineRow {
                length: line.length.value().unwrap_or(0.0),
                space: NOT_GIVEN,
                t_offset: line.t_offset.value().unwrap_or(0.0),
                s_offset: line.s_offset.value().unwrap_or(0.0),
                width: given(line.width.value()),
                rule: rule(line.rule.value()),
                color: color(None),
                reserved: [0; 6],
            });
        }
        let style = RoadMarkStyleRow {
            width: given(mark.width.value()),
            height: given(mark.height.value()),
            material: self.strings.add(mark.material.text()),
            name: self.strings.add(pattern.map_or("", |pattern| pattern.name.text())),
            lines: Range::default(),
            sway: self.sway(&mark.sway, s, part),
            kind: RoadMarkKind::from_name(mark.r#type.value().map_or("", xodr::RoadMarkType::name))
                .code(),
            weight: RoadMarkWeight::from_name(
                mark.weight.value().map_or("", xodr::RoadMarkWeight::name),
            )
            .code(),
            color: color(mark.color.value()),
            lane_change: MarkLaneChange::from_name(
                mark.lane_change.value().map_or("", xodr::LaneChange::name),
            )
            .code(),
            reserved: [0; 4],
        };
        self.styles.add(&mut self.rows, style, before)
    }

    /// Sway records of a mark that begins at s. One that lacks a number is left out alone: nothing else is built from it.
    fn sway(&mut self, records: &[xodr::Sway], s: f64, part: &mut ElementContext<'_>) -> Range {
        if records.is_empty() {
            return Range::default();
        }
        let before = self.rows.cubics.len();
        for record in records {
            let numbers =
                [&record.ds, &record.a, &record.b, &record.c, &record.d].map(|n| n.value());
            let [Some(ds), Some(a), Some(b), Some(c), Some(d)] = numbers else {
                let path =
                    ElementPath::new(part.path.owner, "lanes/laneSection/lane/roadMark/sway");
                let mut part = ElementContext { span: record.span, path, findings: part.findings };
                let message = "expected @ds, @a, @b, @c and @d, found one that can't be used; the record is left out";
                part.add(&building::RECORD, Severity::Warning, message.to_owned());
                continue;
            };
            self.rows.cubics.push(CubicRow { s: s + ds, a, b, c, d });
        }
        self.cubics.add(&mut self.rows.cubics, before)
    }
}
