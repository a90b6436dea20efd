//! Stores how long lanes of very many records are up to some of these.

use crate::sample::view;
use mapd_archive::{LaneLengthRow, Rows};
use mapd_query::Map;
use mapd_query::compiling::{ByRow as _, lengths_along};
use rayon::prelude::*;

/// Sections that one task looks at.
const SECTIONS_PER_TASK: usize = 256;

/// Fills `lane_lengths`: whatever asks for lengths along such lanes goes faster from then on.
pub(crate) fn build(rows: &mut Rows) {
    let stored: Vec<Vec<LaneLengthRow>> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let numbers: Vec<u32> = (0..rows.sections.len() as u32).collect();
        numbers.par_chunks(SECTIONS_PER_TASK).map(|sections| of_sections(map, sections)).collect()
    };
    let mut stored: Vec<_> = stored.into_iter().flatten().collect();
    stored.sort_by_key(|row| row.lane);
    rows.lane_lengths = stored.into();
}

fn of_sections(map: Map<'_>, sections: &[u32]) -> Vec<LaneLengthRow> {
    let sections = sections.iter().filter_map(|number| map.section_by_row(*number));
    sections.flat_map(|section| lengths_along(&section)).collect()
}
