//! Stores how long lanes of very many records are up to some of these.

use crate::sample::view;
use mapd_archive::{LaneLengthRow, Rows};
use mapd_query::Map;
use mapd_query::compiling::{ByRow as _, lengths_along};
use rayon::prelude::*;

/// Lanes that one task looks at.
const LANES_PER_TASK: usize = 256;

/// Fills `lane_lengths`.
pub(crate) fn build(rows: &mut Rows) {
    let stored: Vec<Vec<LaneLengthRow>> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let numbers: Vec<u32> = (0..rows.lanes.len() as u32).collect();
        numbers.par_chunks(LANES_PER_TASK).map(|lanes| of_lanes(map, lanes)).collect()
    };
    rows.lane_lengths = stored.into_iter().flatten().collect::<Vec<_>>().into();
}

fn of_lanes(map: Map<'_>, lanes: &[u32]) -> Vec<LaneLengthRow> {
    let mut stored = Vec::new();
    for number in lanes {
        let along = map.lane_by_row(*number).map(|lane| lengths_along(&lane)).unwrap_or_default();
        let rows = along.into_iter();
        stored.extend(rows.map(|(s, length)| LaneLengthRow {
            s,
            length,
            lane: *number,
            reserved: 0,
        }));
    }
    stored
}
