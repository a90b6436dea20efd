//! The spatial index as boxes: those of its nodes, and the rectangles around the segments in its leaves.

use super::Paper;
use mapd_archive::NONE;
use mapd_archive::packed_index::{REACH_UNIT, WIDTH};
use mapd_client::Map;
use mapd_client::glam::DVec2;
use std::io::{Result, Write};

/// Draws all boxes.
///
/// Errors: what writing gives.
pub(super) fn write(map: Map<'_>, paper: Paper, out: &mut dyn Write) -> Result<()> {
    let (tables, origin) = (map.tables(), map.local_origin());
    for node in tables.index_nodes {
        for k in 0..WIDTH {
            let low = DVec2::new(f64::from(node.min_x()[k]), f64::from(node.min_y()[k]));
            let high = DVec2::new(f64::from(node.max_x()[k]), f64::from(node.max_y()[k]));
            // Unused places are empty.
            if low.x > high.x {
                continue;
            }
            let corner = paper.at(origin + DVec2::new(low.x, high.y));
            let size = high - low;
            writeln!(
                out,
                "<rect class=\"node\" x=\"{:.3}\" y=\"{:.3}\" width=\"{:.3}\" height=\"{:.3}\"/>",
                corner.x, corner.y, size.x, size.y
            )?;
        }
    }
    let unit = f64::from(REACH_UNIT);
    for leaf in tables.index_leaves {
        for k in (0..WIDTH).filter(|k| leaf.lane()[*k] != NONE) {
            let corner = origin + DVec2::new(f64::from(leaf.x()), f64::from(leaf.y()));
            let place = |x: u16, y: u16| {
                corner + DVec2::new(f64::from(x), f64::from(y)) * f64::from(leaf.step())
            };
            let start = place(leaf.start_x()[k], leaf.start_y()[k]);
            let delta = place(leaf.end_x()[k], leaf.end_y()[k]) - start;
            let along = delta.normalize_or_zero();
            let before = along * (f64::from(leaf.overshoot()[k]) * unit);
            let beside = along.perp() * (f64::from(leaf.reach()[k]) * unit);
            let (a, b) = (start - before, start + delta + before);
            let corners = [a - beside, b - beside, b + beside, a + beside];
            write!(out, "<path class=\"leaf\" d=\"")?;
            for (i, corner) in corners.into_iter().enumerate() {
                let p = paper.at(corner);
                write!(out, "{}{:.3},{:.3}", if i == 0 { 'M' } else { ' ' }, p.x, p.y)?;
            }
            writeln!(out, "z\"/>")?;
        }
    }
    Ok(())
}
