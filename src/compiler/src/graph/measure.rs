//! Length and time of each node, from the lane's own polynomials.

use crate::sample::view;
use mapd_archive::Rows;
use mapd_geometry::clamp;
use mapd_query::{Lane, Map};
use rayon::prelude::*;

/// Speed assumed where the file states none `[m/s]`: 50 km/h, the usual limit in towns.
const ASSUMED_SPEED: f64 = 50.0 / 3.6;
/// Speed assumed where there is no limit `[m/s]`: 130 km/h, the recommended one on motorways.
const UNLIMITED_SPEED: f64 = 130.0 / 3.6;
/// Lowest speed counted `[m/s]`: a limit of 0 must not make a lane take for ever.
const LOWEST_SPEED: f64 = 0.1;
/// Lanes that one task measures.
const LANES_PER_TASK: usize = 256;

/// Length and time of one node.
type Measures = (f32, f32);

/// Fills `length` and `time` of all nodes.
pub(crate) fn measure(rows: &mut Rows) {
    let measured: Vec<Vec<Measures>> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let numbers: Vec<u32> = (0..rows.lanes.len() as u32).collect();
        numbers.par_chunks(LANES_PER_TASK).map(|lanes| of_lanes(map, lanes)).collect()
    };
    for (node, (length, time)) in rows.lane_nodes.iter_mut().zip(measured.into_iter().flatten()) {
        (node.length, node.time) = (length, time);
    }
}

/// Measures of the nodes of consecutive lanes: nodes lie lane by lane.
fn of_lanes(map: Map<'_>, lanes: &[u32]) -> Vec<Measures> {
    let lanes = lanes.iter().filter_map(|number| map.lane_by_row(*number));
    lanes.flat_map(|lane| lane.nodes().map(move |node| of_piece(&lane, node.s_range()))).collect()
}

fn of_piece(lane: &Lane<'_>, (from, to): (f64, f64)) -> Measures {
    let length = lane.length_between(from, to);
    let inside = |s: &f64| *s > from && *s < to;
    let mut changes: Vec<f64> = lane.speeds().map(|record| record.s).filter(inside).collect();
    changes.extend(lane.road().types().map(|record| record.s).filter(inside));
    changes.push(to);
    changes.sort_by(f64::total_cmp);
    let (mut time, mut last) = (0.0, from);
    for s in changes {
        let part = if last == from && s == to { length } else { lane.length_between(last, s) };
        let speed = lane.speed_limit_at(0.5 * (last + s)).unwrap_or(ASSUMED_SPEED);
        time += part / clamp(speed, LOWEST_SPEED, UNLIMITED_SPEED);
        last = s;
    }
    (length as f32, time as f32)
}
