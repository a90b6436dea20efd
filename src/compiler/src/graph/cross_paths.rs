//! Paths across roads (OpenDRIVE 1.8.1, 12.9, `crossPath`): ways for walking and cycling between lanes at places inside roads
//! and the road that carries the path.
//!
//! The path's road begins at `startLaneLink` and ends at `endLaneLink`; each names a place on the road that is touched, its
//! lane and the lane of the path's road. Traffic on the touched lane may turn into the path there, and out of it.

use super::Source;
use super::attach::{DirectedPosition, Missing, node_at};
use super::cuts::Cuts;
use super::findings::{Problem, Problems};
use super::nodes::{first_node, pieces};
use super::walk::{Edge, lane_of};
use super::zones::road_of;
use crate::draft::Draft;
use mapd_archive::{EdgeKind, VehicleClass};
use mapd_xodr::{CrossPath, CrossPathLaneLink, Text as _, Value as _};

/// Path of a link of a path.
const LINK: &str = "OpenDRIVE/junction/crossPath";
/// Who uses paths across roads.
const USERS: u16 = VehicleClass::Pedestrian.bit() | VehicleClass::Bicycle.bit();

/// One end of a path.
struct End<'a> {
    path: &'a CrossPath,
    link: &'a CrossPathLaneLink,
    /// Id of the road that is touched.
    touched: &'a str,
    /// Whether it is the start of the path's road.
    start: bool,
}

/// Places inside roads that paths touch: (road row, s).
pub(crate) fn places(source: Source<'_>) -> impl Iterator<Item = (u32, f64)> {
    ends(source)
        .filter_map(move |end| Some((road_of(source.draft, end.touched)?, end.link.s.value()?)))
}

/// Edges from and to all paths.
pub(crate) fn edges(
    source: Source<'_>,
    cuts: &Cuts,
    problems: &mut Problems,
    edges: &mut Vec<Edge>,
) {
    for end in ends(source) {
        if let Err(message) = join(source.draft, cuts, &end, edges) {
            let message = format!("{message}; not linked");
            problems.add(Problem::NoPlace { path: LINK, message, span: end.link.span });
        }
    }
}

fn ends(source: Source<'_>) -> impl Iterator<Item = End<'_>> {
    let paths = source.links.elements().flat_map(|junction| &junction.cross_path);
    paths.flat_map(|path| {
        let start = (&path.start_lane_link, path.road_at_start.text(), true);
        let end = (&path.end_lane_link, path.road_at_end.text(), false);
        [start, end].into_iter().filter_map(move |(link, touched, start)| {
            Some(End { path, link: link.as_deref()?, touched, start })
        })
    })
}

/// Adds the edges over one end; says what is missing.
fn join(draft: &Draft, cuts: &Cuts, end: &End<'_>, edges: &mut Vec<Edge>) -> Result<(), String> {
    let rows = &draft.rows;
    let road = |id: &str| {
        let row = road_of(draft, id);
        row.ok_or_else(|| {
            format!("expected a road of the map, found {id:?}, which it does not have")
        })
    };
    let carrying = end.path.crossing_road.text();
    let (crossing, touched) = (road(carrying)?, road(end.touched)?);
    let link = end.link;
    let (Some(s), Some(from), Some(to)) = (link.s.value(), link.from.value(), link.to.value())
    else {
        return Err("expected @s, @from and @to, found less".to_owned());
    };
    let missing = |id: &str, number: i32| {
        format!("expected a lane {number} of road {id:?} there, found none")
    };
    let sections = rows.roads.get(crossing as usize).map(|road| road.sections).unwrap_or_default();
    let section = if end.start { sections.first.into() } else { sections.end().saturating_sub(1) };
    let lane = u32::try_from(section).ok().and_then(|section| lane_of(draft, section, to));
    let lane = lane.and_then(|lane| rows.lanes.get(lane as usize));
    let lane = lane.ok_or_else(|| missing(carrying, to))?;
    // Into the path's road at its start one travels towards +s, out of it there towards −s.
    let into = first_node(lane, end.start);
    let out_of = first_node(lane, !end.start).map(|first| first + pieces(lane) - 1);
    let mut found = false;
    for forward in [true, false] {
        let place = DirectedPosition { road: touched, s, forward };
        for (entering, path_node) in [(false, into), (true, out_of)] {
            match (node_at(draft, cuts, place, from, entering), path_node) {
                (Ok(node), Some(path_node)) => {
                    found = true;
                    let (from, to) = if entering { (path_node, node) } else { (node, path_node) };
                    let access = |node: u32| {
                        rows.lane_nodes.get(node as usize).map_or(0, |row| row.access & USERS)
                    };
                    if access(from) & access(to) != 0 {
                        edges.push(Edge { from, to, kind: EdgeKind::CrossPath, span: link.span });
                    }
                }
                (Err(Missing::Lane(_)), _) => {}
                (Err(Missing::Direction(_) | Missing::Stretch) | Ok(_), _) => found = true,
            }
        }
    }
    if found { Ok(()) } else { Err(missing(end.touched, from)) }
}
