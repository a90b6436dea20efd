//! What is painted along and across lanes.

use super::{Column, Kind, Shape, Sink, Value, lanes, named, sections};
use crate::Result;
use mapd_client::glam::DVec3;
use mapd_client::roads::RoadMark;
use mapd_client::rules::{LaneLine, LineSource};
use mapd_client::{Lane, Map, Track};
use std::ops::Range;

pub(super) const BORDER_COLUMNS: &[Column] = &[
    ("key", Kind::Text),
    ("road", Kind::Text),
    ("section", Kind::Whole),
    ("lane", Kind::Whole),
    ("s_from_m", Kind::Number),
    ("s_to_m", Kind::Number),
    ("mark", Kind::Text),
    ("color", Kind::Text),
    ("weight", Kind::Text),
    ("lane_change", Kind::Text),
    ("width_m", Kind::Number),
    ("is_temporary", Kind::Flag),
];

pub(super) const STOP_COLUMNS: &[Column] = &[
    ("key", Kind::Text),
    ("road", Kind::Text),
    ("section", Kind::Whole),
    ("lane", Kind::Whole),
    ("s_m", Kind::Number),
    ("class", Kind::Text),
    ("source", Kind::Text),
    ("id", Kind::Text),
];

/// The outer border of each lane, and lane 0's line, piece by piece: one for each road mark, and for what has none.
pub(super) fn borders(map: Map<'_>, sink: &mut Sink<'_>) -> Result<()> {
    for section in sections(map) {
        let end = section.s_end();
        for lane in section.lanes() {
            let mut at = section.s_start();
            for mark in lane.road_marks() {
                border(&lane, at..mark.s(), None, sink)?;
                border(&lane, mark.s().max(at)..mark.s_end(), Some(&mark), sink)?;
                at = at.max(mark.s_end());
            }
            border(&lane, at..end, None, sink)?;
        }
    }
    Ok(())
}

fn border(
    lane: &Lane<'_>,
    stretch: Range<f64>,
    mark: Option<&RoadMark<'_>>,
    sink: &mut Sink<'_>,
) -> Result<()> {
    let Range { start: from, end: to } = stretch;
    // Also what is not a number.
    if !matches!(from.partial_cmp(&to), Some(std::cmp::Ordering::Less)) {
        return Ok(());
    }
    let place = |s: f64| {
        let track = Track { s, t: lane.edges_at(s).outer, h: 0.0 };
        lane.road().to_inertial(track).ok().map(|pose| pose.position)
    };
    let between = lane.border().points().filter(|point| (from < point.s) & (point.s < to));
    let points = between.map(|point| point.position);
    let points: Vec<DVec3> = place(from).into_iter().chain(points).chain(place(to)).collect();
    let [key, road, section, number] = named(lane);
    let values = [
        key,
        road,
        section,
        number,
        from.into(),
        to.into(),
        mark.map(|mark| mark.kind().name()).into(),
        mark.map(|mark| mark.color().name()).into(),
        mark.map(|mark| mark.weight().name()).into(),
        mark.map(|mark| mark.lane_change().name()).into(),
        mark.map(|mark| mark.width_or_default()).into(),
        lane.is_temporary().into(),
    ];
    sink(Shape::line(points), &values)
}

/// A line from edge to edge of a lane for each line at which its traffic stops or gives way.
pub(super) fn stop_lines(map: Map<'_>, sink: &mut Sink<'_>) -> Result<()> {
    for lane in lanes(map) {
        for line in lane.lines_to_stop_at() {
            let [key, road, section, number] = named(&lane);
            let (source, id) = source(map, &line);
            let class = line.class.name().into();
            let values = [key, road, section, number, line.s.into(), class, source, id];
            sink(across(&lane, line.s), &values)?;
        }
    }
    Ok(())
}

/// The line across a lane at s.
pub(super) fn across(lane: &Lane<'_>, s: f64) -> Shape {
    lane.edge_points_at(s).map_or(Shape::Nowhere, |edges| Shape::line(edges.to_vec()))
}

/// Who says that there is a line: `signal` or `object`, and its id.
pub(super) fn source<'a>(map: Map<'a>, line: &LaneLine) -> (Value<'a>, Value<'a>) {
    match line.source {
        LineSource::Signal(id) => {
            ("signal".into(), map.signal(id).ok().map(|signal| signal.id()).into())
        }
        LineSource::Object(id) => {
            ("object".into(), map.object(id).ok().map(|object| object.id()).into())
        }
    }
}
