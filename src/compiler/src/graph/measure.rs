//! Length and time of each node, from the lane's own polynomials.

use crate::sample::view;
use mapd_archive::Rows;
use mapd_query::compiling::{ByRow as _, Measures, measures_along, measures_between};
use mapd_query::{LaneSection, Map, SRange};
use rayon::prelude::*;

/// Sections that one task measures.
const SECTIONS_PER_TASK: usize = 64;

/// Fills `length` and `time` of all nodes.
pub(crate) fn measure(rows: &mut Rows) {
    let measured: Vec<Vec<(u32, Measures)>> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let numbers: Vec<u32> = (0..rows.sections.len() as u32).collect();
        let of_sections = |sections: &[u32]| {
            let sections = sections.iter().filter_map(|number| map.section_by_row(*number));
            sections.flat_map(|section| of_section(&section)).collect()
        };
        numbers.par_chunks(SECTIONS_PER_TASK).map(of_sections).collect()
    };
    for (node, of_node) in measured.into_iter().flatten() {
        if let Some(node) = rows.lane_nodes.get_mut(node as usize) {
            (node.length, node.time) = (of_node.length as f32, of_node.time as f32);
        }
    }
}

/// Measures of the nodes of a section's lanes, which are all cut at the same places.
fn of_section(section: &LaneSection<'_>) -> Vec<(u32, Measures)> {
    let nodes = || section.lanes().flat_map(|lane| lane.nodes().map(move |node| (lane, node)));
    let ranges = || nodes().map(|(_, node)| node.s_range());
    let mut places: Vec<f64> = ranges().flat_map(|SRange { low, high }| [low, high]).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    let along = measures_along(section, &places);
    let first = section.lanes().next().map_or(0, |lane| lane.lane_id().row());
    let measured = nodes().map(|(lane, node)| {
        let SRange { low, high } = node.s_range();
        let of_lane =
            along.as_ref().and_then(|all| all.get((lane.lane_id().row() - first) as usize));
        let piece = places.binary_search_by(|place| place.total_cmp(&low)).ok();
        // Other places of a piece's lane are its ends, unless it has another one's between them.
        let piece = piece.filter(|at| places.get(at + 1) == Some(&high));
        let of_piece = piece.zip(of_lane).and_then(|(at, of_lane)| of_lane.get(at)).copied();
        let one = || measures_between(&lane, low, high);
        (node.node_id().row(), of_piece.unwrap_or_else(one))
    });
    measured.collect()
}
