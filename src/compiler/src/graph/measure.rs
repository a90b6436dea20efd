//! Length and time of each node, from the lane's own polynomials.

use crate::sample::view;
use mapd_archive::Rows;
use mapd_query::compiling::{ByRow as _, Measures, measures_between};
use mapd_query::{Lane, Map, SRange};
use rayon::prelude::*;

/// Lanes that one task measures.
const LANES_PER_TASK: usize = 256;

/// Fills `length` and `time` of all nodes.
pub(crate) fn measure(rows: &mut Rows) {
    let measured: Vec<Vec<Measures>> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let numbers: Vec<u32> = (0..rows.lanes.len() as u32).collect();
        numbers.par_chunks(LANES_PER_TASK).map(|lanes| of_lanes(map, lanes)).collect()
    };
    for (node, of_node) in rows.lane_nodes.iter_mut().zip(measured.into_iter().flatten()) {
        (node.length, node.time) = (of_node.length as f32, of_node.time as f32);
    }
}

/// Measures of the nodes of consecutive lanes: nodes lie lane by lane.
fn of_lanes(map: Map<'_>, lanes: &[u32]) -> Vec<Measures> {
    let lanes = lanes.iter().filter_map(|number| map.lane_by_row(*number));
    lanes.flat_map(|lane| lane.nodes().map(move |node| of_piece(&lane, node.s_range()))).collect()
}

fn of_piece(lane: &Lane<'_>, SRange { low: from, high: to }: SRange) -> Measures {
    measures_between(lane, from, to)
}
