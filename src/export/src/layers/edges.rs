//! The lane graph.

use super::{Column, Kind, Shape, Sink};
use crate::Result;
use mapd_client::Map;
use mapd_client::SRange;
use mapd_client::glam::DVec3;
use mapd_client::graph::LaneNode;
use mapd_client::vocabulary::VehicleClass;

pub(super) const COLUMNS: &[Column] = &[
    ("from", Kind::Text),
    ("from_s_from_m", Kind::Number),
    ("from_s_to_m", Kind::Number),
    ("from_is_forward", Kind::Flag),
    ("to", Kind::Text),
    ("to_s_from_m", Kind::Number),
    ("to_s_to_m", Kind::Number),
    ("to_is_forward", Kind::Flag),
    ("kind", Kind::Text),
    ("length_m", Kind::Number),
    ("time_s", Kind::Number),
    ("speed_limit_m_s", Kind::Number),
    ("vehicles", Kind::Text),
    ("closes_loop", Kind::Flag),
];

/// One line for each edge: from the middle of the node that is left over its end to the middle of the one that is entered.
pub(super) fn edges(map: Map<'_>, sink: &mut Sink<'_>) -> Result<()> {
    for (from, edge) in map.lane_nodes().flat_map(|from| from.edges().map(move |e| (from, e))) {
        let to = edge.target();
        let key = |node: LaneNode<'_>| node.lane().map(|lane| lane.key().to_string());
        let range = to.map(|to| to.s_range());
        let classes = VehicleClass::ALL.iter().filter(|class| edge.allows(**class));
        let vehicles: Vec<&str> = classes.map(|class| class.name()).collect();
        let points = [place(&from, 0.5), place(&from, 1.0), to.and_then(|to| place(&to, 0.5))];
        let values = [
            key(from).into(),
            from.s_range().low.into(),
            from.s_range().high.into(),
            from.is_forward().into(),
            to.and_then(key).into(),
            range.map(|range| range.low).into(),
            range.map(|range| range.high).into(),
            to.map(|to| to.is_forward()).into(),
            edge.kind().name().into(),
            edge.length().into(),
            from.travel_time().into(),
            edge.speed_limit().into(),
            vehicles.join(",").into(),
            edge.closes_loop().into(),
        ];
        sink(Shape::line(points.into_iter().flatten().collect()), &values)?;
    }
    Ok(())
}

/// A place on a node's centre line, 0 where it is entered, 1 where it is left.
fn place(node: &LaneNode<'_>, part: f64) -> Option<DVec3> {
    let SRange { low, high } = node.s_range();
    let part = if node.is_forward() { part } else { 1.0 - part };
    let pose = node.lane()?.pose_at(low + part * (high - low), 0.0).ok()?;
    Some(pose.position)
}
