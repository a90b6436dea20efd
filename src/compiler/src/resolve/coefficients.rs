//! Numbers of geometries, each sequence of them once.
//!
//! Most arcs of a map have one of few curvatures. Stored once, they take less room, and few of them are waited for.

use mapd_archive::{Range, Rows};
use std::collections::HashMap;

/// Lets geometries with equal numbers share them. Each sequence lies where the first geometry that has it comes.
pub(crate) fn share(rows: &mut Rows) {
    let mut known: HashMap<&[u8], Range> = HashMap::new();
    let mut shared = Vec::new();
    for row in rows.geometries.iter_mut() {
        let own = row.coefficients.of(&rows.coefficients);
        row.coefficients = *known.entry(bytemuck::cast_slice(own)).or_insert_with(|| {
            let before = shared.len();
            shared.extend_from_slice(own);
            crate::draft::between(before, shared.len())
        });
    }
    rows.coefficients = shared.into();
}
