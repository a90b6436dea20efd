//! Records that say nothing new.

use crate::example::Example::Road as In;
use crate::place::{RoadIn, number};
use crate::profile::{Record, record};
use crate::rule::Check::Road;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{Severity, Span};

/// Coefficients that are the same.
const SAME: Tolerance = Tolerance { name: "difference of coefficients", value: 1e-6, unit: "" };

pub(super) static RULES: &[Rule] = &[Rule::info(
    "asam.net:xodr:1.8.1:performance.avoid_redundant_info",
    "A record that continues the one before it unchanged, or a line that continues the line before it, is omitted.",
    Road(redundant),
    [
        In(r#"<elevationProfile><elevation s="0" a="0" b="0.01" c="0" d="0"/><elevation s="50" a="0.5" b="0.02" c="0" d="0"/></elevationProfile>"#),
        In(r#"<elevationProfile><elevation s="0" a="0" b="0.01" c="0" d="0"/><elevation s="50" a="0.5" b="0.01" c="0" d="0"/></elevationProfile>"#),
    ],
)
.also(&["asam.net:xodr:1.7.0:performance.avoid_redundant_info"])
.within(&[SAME])
.asam(Severity::Warning)
.advisory()];

/// Whether a record yields what the one before it would.
fn goes_on(before: &Record, record: &Record) -> bool {
    let ds = record.s - before.s;
    let (a, b) = (&before.cubic, &record.cubic);
    let shifted = [a.value(ds), a.derivative(ds), a.second_derivative(ds) / 2.0, a.d];
    let own = [b.a, b.b, b.c, b.d];
    shifted.iter().zip(own).all(|(shifted, own)| (shifted - own).abs() <= SAME.value)
}

fn look(part: &str, records: impl Iterator<Item = (Record, Span)>, sink: &mut Sink<'_>) {
    let mut before: Option<Record> = None;
    for (record, span) in records {
        if before.is_some_and(|before| goes_on(&before, &record)) {
            sink.add_within(part, span, "a change", "the values of the record before it");
        }
        before = Some(record);
    }
}

fn redundant(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let road = of.road;
    let elevations = road.elevation_profile.iter().flat_map(|profile| &profile.elevation);
    look("elevationProfile/elevation", elevations.map(|e| (record!(e, s), e.span)), sink);
    let rolls = road.lateral_profile.iter().flat_map(|profile| &profile.superelevation);
    look("lateralProfile/superelevation", rolls.map(|e| (record!(e, s), e.span)), sink);
    for lanes in &road.lanes {
        look("lanes/laneOffset", lanes.lane_offset.iter().map(|e| (record!(e, s), e.span)), sink);
    }
    for lane in of.sections().flat_map(|section| section.lanes()) {
        look(
            "lanes/laneSection/lane/width",
            lane.width.iter().map(|e| (record!(e, s_offset), e.span)),
            sink,
        );
        look(
            "lanes/laneSection/lane/border",
            lane.border.iter().map(|e| (record!(e, s_offset), e.span)),
            sink,
        );
    }
    let geometries = road.plan_view.iter().flat_map(|plan_view| &plan_view.geometry);
    let mut before = None;
    for geometry in geometries {
        let is_line = geometry.line.is_some();
        if let Some((x, y, hdg)) = before.filter(|_| is_line) {
            let same = |a: f64, b: f64| (a - b).abs() <= SAME.value;
            if same(x, number(&geometry.x))
                && same(y, number(&geometry.y))
                && same(hdg, number(&geometry.hdg))
            {
                sink.add_within(
                    "planView/geometry",
                    geometry.span,
                    "a bend",
                    "a line in line with the one before it",
                );
            }
        }
        let (cos, sin) = mapd_geometry::cos_sin(number(&geometry.hdg));
        let length = number(&geometry.length);
        before = is_line.then(|| {
            (
                number(&geometry.x) + length * cos,
                number(&geometry.y) + length * sin,
                number(&geometry.hdg),
            )
        });
    }
}
