//! Lanes, as areas and as centre lines.

use super::{Column, Kind, Shape, Sink, Value, lanes, named};
use crate::Result;
use mapd_client::glam::DVec3;
use mapd_client::{Lane, Map};

pub(super) const AREA_COLUMNS: &[Column] = &[
    ("key", Kind::Text),
    ("road", Kind::Text),
    ("section", Kind::Whole),
    ("lane", Kind::Whole),
    ("road_name", Kind::Text),
    ("junction", Kind::Text),
    ("type", Kind::Text),
    ("s_from_m", Kind::Number),
    ("s_to_m", Kind::Number),
    ("width_from_m", Kind::Number),
    ("width_to_m", Kind::Number),
    ("speed_limit_m_s", Kind::Number),
    ("has_no_speed_limit", Kind::Flag),
    ("is_forward", Kind::Flag),
    ("is_bidirectional", Kind::Flag),
    ("is_temporary", Kind::Flag),
];

pub(super) const LINE_COLUMNS: &[Column] = &[
    ("key", Kind::Text),
    ("road", Kind::Text),
    ("section", Kind::Whole),
    ("lane", Kind::Whole),
    ("type", Kind::Text),
    ("is_forward", Kind::Flag),
    ("is_bidirectional", Kind::Flag),
    ("is_temporary", Kind::Flag),
    ("successors", Kind::Text),
];

/// One polygon for each lane: along its left border by the reference line, back along the right one.
pub(super) fn areas(map: Map<'_>, sink: &mut Sink<'_>) -> Result<()> {
    for lane in lanes(map) {
        let (section, road) = (lane.section(), lane.road());
        let (from, to) = (section.s_start(), section.s_end());
        let limit = lane.speed_rule_at(0.5 * (from + to)).max;
        let mut corners: Vec<DVec3> = lane.left_bound_of_reference_line().positions().collect();
        let right: Vec<DVec3> = lane.right_bound_of_reference_line().positions().collect();
        corners.extend(right.into_iter().rev());
        let [key, road_id, number, lane_number] = named(&lane);
        let values = [
            key,
            road_id,
            number,
            lane_number,
            road.name().into(),
            road.junction().map(|junction| junction.id()).into(),
            lane.kind().name().into(),
            from.into(),
            to.into(),
            lane.width_at(from).into(),
            lane.width_at(to).into(),
            limit.into(),
            limit.is_some_and(f64::is_infinite).into(),
            lane.is_forward().into(),
            lane.is_bidirectional().into(),
            lane.is_temporary().into(),
        ];
        sink(Shape::polygon(corners), &values)?;
    }
    Ok(())
}

/// One line for each lane, from where its traffic enters to where it leaves.
pub(super) fn center_lines(map: Map<'_>, sink: &mut Sink<'_>) -> Result<()> {
    for lane in lanes(map) {
        let mut points: Vec<DVec3> = lane.center_line().positions().collect();
        if !lane.is_forward() {
            points.reverse();
        }
        let [key, road, section, number] = named(&lane);
        let values = [
            key,
            road,
            section,
            number,
            lane.kind().name().into(),
            lane.is_forward().into(),
            lane.is_bidirectional().into(),
            lane.is_temporary().into(),
            successors(map, &lane),
        ];
        sink(Shape::line(points), &values)?;
    }
    Ok(())
}

/// Keys of the lanes that are entered from a lane, separated by commas, which keys do not hold.
fn successors(map: Map<'_>, lane: &Lane<'_>) -> Value<'static> {
    let next = lane.successors().filter_map(|id| map.lane(id).ok());
    let keys: Vec<String> = next.map(|lane| lane.key().to_string()).collect();
    keys.join(",").into()
}
