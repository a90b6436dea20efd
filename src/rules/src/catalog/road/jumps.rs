//! Profiles along a road do not jump.

use crate::catalog::lanes::is_drivable;
use crate::example::Example::Road as In;
use crate::place::{RoadIn, SectionIn, Side, lane_part, number, value};
use crate::profile::value_at;
use crate::rule::Check::Road;
use crate::rule::{Rule, Tolerance};
use crate::sink::Sink;
use mapd_xodr::{CubicRecord, Lane, LaneType};

/// Steps of height, lane offset and width that come from rounding in the file.
const STEP: Tolerance = Tolerance { name: "step", value: 0.01, unit: "m" };
/// Steps of superelevation that come from rounding in the file.
const ROLL: Tolerance = Tolerance { name: "step of superelevation", value: 0.01, unit: "rad" };
/// A lane section begins within this distance of its own s, and a road at s = 0.
const AT: Tolerance =
    Tolerance { name: "distance of the start of a section", value: 1e-6, unit: "m" };

pub(super) static RULES: &[Rule] = &[Rule::warning(
    "mapd:xodr:1.4.0:lane_smoothness.within_road",
    "Within a road, height and superelevation do not jump where a record begins, also from the 0 before the first one; within a lane section, nor do the lane offset and the widths of driving lanes.",
    Road(jumps),
    [
        In(r#"<elevationProfile><elevation s="0" a="5" b="0.02" c="0" d="0"/><elevation s="50" a="6" b="0" c="0" d="0"/></elevationProfile>"#),
        In(r#"<elevationProfile><elevation s="0" a="5" b="0.02" c="0" d="0"/><elevation s="50" a="8" b="0" c="0" d="0"/></elevationProfile>"#),
    ],
)
.within(&[STEP, ROLL, AT])];

/// Reports records of one element, of which each begins somewhere along `length`, that do not go on where those before end.
fn report<R: CubicRecord>(
    records: &[R],
    length: f64,
    tolerance: &Tolerance,
    may_jump: impl Fn(f64) -> bool,
    path: impl Fn() -> String,
    sink: &mut Sink<'_>,
) {
    for pair in records.windows(2) {
        let [last, next] = pair else { continue };
        let (Some(from), Some(at)) = (last.start(), next.start()) else { continue };
        // What is not in order, or begins where another does, is a finding of its own.
        if !(from < at && at < length) || may_jump(at) {
            continue;
        }
        let before = value_at(std::slice::from_ref(last), at);
        let after = value_at(std::slice::from_ref(next), at);
        if (after - before).abs() > tolerance.value {
            let expected =
                format_args!("{before:.3} {}, as before {} = {at}", tolerance.unit, R::START);
            let found = format_args!("{after:.3} {}", tolerance.unit);
            sink.add_within(&path(), next.span(), expected, found);
        }
    }
}

/// Reports a first record that begins along `length` and does not go on from the 0 that holds before it, as [`report`] does those behind it.
fn report_first<R: CubicRecord>(
    records: &[R],
    length: f64,
    tolerance: &Tolerance,
    may_jump: impl Fn(f64) -> bool,
    path: &str,
    sink: &mut Sink<'_>,
) {
    let Some((first, at)) = records.first().and_then(|first| Some((first, first.start()?))) else {
        return;
    };
    if !(at > AT.value && at < length) || may_jump(at) {
        return;
    }
    let after = value_at(std::slice::from_ref(first), at);
    if after.abs() > tolerance.value {
        let expected =
            format_args!("0 {}, as before the first record at {} = {at}", tolerance.unit, R::START);
        sink.add_within(
            path,
            first.span(),
            expected,
            format_args!("{after:.3} {}", tolerance.unit),
        );
    }
}

fn jumps(of: &RoadIn<'_>, sink: &mut Sink<'_>) {
    let road = of.road;
    let length = number(&road.length);
    if let Some(profile) = &road.elevation_profile {
        let path = "elevationProfile/elevation";
        report_first(&profile.elevation, length, &STEP, |_| false, path, sink);
        report(&profile.elevation, length, &STEP, |_| false, || path.to_owned(), sink);
    }
    if let Some(profile) = &road.lateral_profile {
        let path = "lateralProfile/superelevation";
        report_first(&profile.superelevation, length, &ROLL, |_| false, path, sink);
        report(&profile.superelevation, length, &ROLL, |_| false, || path.to_owned(), sink);
    }
    for lanes in &road.lanes {
        // Where a section begins, lanes are counted anew: lane 0 may be another line.
        let begins = |s: f64| {
            let sections = &lanes.lane_section;
            let next = sections.partition_point(|own| number(&own.s) < s - AT.value);
            sections.get(next).is_some_and(|own| number(&own.s) <= s + AT.value)
        };
        let path = "lanes/laneOffset";
        report_first(&lanes.lane_offset, length, &STEP, begins, path, sink);
        report(&lanes.lane_offset, length, &STEP, begins, || path.to_owned(), sink);
    }
    for section in of.sections() {
        for side in [Side::Left, Side::Right] {
            widths(&section, side, sink);
        }
    }
}

fn widths(section: &SectionIn<'_>, side: Side, sink: &mut Sink<'_>) {
    let is_drivable = |lane: &Lane| is_drivable(value(&lane.r#type).unwrap_or(LaneType::None));
    let several = |lane: &&Lane| lane.width.len() > 1 && is_drivable(lane);
    let mut lanes = section.side(side).iter().filter(several).peekable();
    // A section of one side alone looks for its end among those that follow.
    let Some(length) = lanes.peek().map(|_| section.length_of(side)) else { return };
    for lane in lanes {
        let part =
            || format!("lanes/laneSection[@s={}]/{}", section.s(), lane_part(lane, "/width"));
        report(&lane.width, length, &STEP, |_| false, part, sink);
    }
}
