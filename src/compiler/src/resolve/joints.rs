//! Joints of junctions with an elevation grid, once all roads are there.

use crate::draft::{Joint, between};
use crate::sample::view;
use glam::DVec2;
use mapd_archive::{ContactPoint, GridTransitionRow, Rows};
use mapd_query::{Map, Road, Track};

/// Fills the grids' transitions, once all roads are there. Joints of roads that the map does not have are left out: the
/// finding about the boundary is the rules'.
pub(super) fn transitions(rows: &mut Rows, joints: &[Joint]) {
    let placed: Vec<(usize, GridTransitionRow)> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let placed = |joint: &Joint| Some((joint.grid, place(map, joint)?));
        joints.iter().filter_map(placed).collect()
    };
    for of_one in placed.chunk_by(|(a, _), (b, _)| a == b) {
        let before = rows.grid_transitions.len();
        rows.grid_transitions.extend(of_one.iter().map(|(_, row)| *row));
        let range = between(before, rows.grid_transitions.len());
        if let Some((grid, _)) = of_one.first() {
            rows.elevation_grids[*grid].transitions = range;
        }
    }
}

/// Where a joint lies, the junction to its left.
fn place(map: Map<'_>, joint: &Joint) -> Option<GridTransitionRow> {
    let road = map.road_by_id(&joint.road)?;
    let at_end = joint.contact == ContactPoint::End;
    let s = if at_end { road.reference_end() } else { 0.0 };
    let [a, b] = edges(&road, s, joint.lanes)?.map(|t| {
        let pose = road.to_inertial(Track { s, t, h: 0.0 }).ok()?;
        Some((pose.position.truncate() - map.local_origin(), pose.heading))
    });
    let ((a, heading), (b, _)) = (a?, b?);
    let out_of_road = DVec2::from_angle(heading) * if at_end { 1.0 } else { -1.0 };
    let (start, end) = if (b - a).perp_dot(out_of_road) > 0.0 { (a, b) } else { (b, a) };
    Some(GridTransitionRow {
        start_x: start.x,
        start_y: start.y,
        end_x: end.x,
        end_y: end.y,
        length: joint.length,
    })
}

/// t of both ends of a joint: the outer edges of its lanes, or of the road's outermost ones.
fn edges(road: &Road<'_>, s: f64, lanes: [Option<i32>; 2]) -> Option<[f64; 2]> {
    let section = road.section_at(s)?;
    let outermost: Vec<i32> = section.lanes().map(|lane| lane.number()).collect();
    let ends = [lanes[0].or(outermost.first().copied())?, lanes[1].or(outermost.last().copied())?];
    let [a, b] = ends.map(|number| section.lane(number).map(|lane| lane.edges_at(s)));
    let (a, b) = (a?, b?);
    // The two edges that lie farthest apart: lanes may be named in either order.
    let all = [a.inner, a.outer, b.inner, b.outer];
    let low = all.iter().fold(f64::INFINITY, |low, t| low.min(*t));
    let high = all.iter().fold(f64::NEG_INFINITY, |high, t| high.max(*t));
    (low < high).then_some([low, high])
}
