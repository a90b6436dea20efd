//! What is laid over the map now.

use super::things::{in_tiles, level_of};
use super::{parts, place};
use crate::drawing::{Drawing, EdgePoint, Fill, Pen};
use crate::paint::Paint;
use mapd_query::glam::DVec3;
use mapd_query::view::View;

/// How far apart the corners of a drawn stretch are at most `[m]`, unless there were too many.
const STEP: f64 = 2.0;

/// The stretch of a lane on which each entry holds: an area and its outline.
pub(super) fn stretches(view: View<'_>, drawing: &mut Drawing) {
    let map = view.map();
    let all = view.restrictions().filter_map(|one| {
        let lane = map.lane(one.lane).ok()?;
        Some((place(&lane.section()), (lane, one)))
    });
    for (at, (lane, one)) in in_tiles(all.collect()) {
        drawing.near(at.truncate());
        let (paint, level) = (Paint::from(one.entry.kind()) as u8, level_of(map, &lane));
        let length = one.s_to - one.s_from;
        let count = parts(length, STEP);
        let corners = |i: usize| {
            let s = one.s_from + length * i as f64 / count as f64;
            Some((s, lane.edge_points_at(s)?))
        };
        let cuts: Vec<(f64, [DVec3; 2])> = (0..=count).filter_map(corners).collect();
        let edge = |side: usize| {
            cuts.iter().map(move |(s, points)| EdgePoint { s: *s, position: points[side] })
        };
        let (inner, outer) = (|| edge(0), || edge(1));
        drawing.strip(inner(), outer(), Fill { paint, level });
        let around: Vec<DVec3> = inner().chain(outer().rev()).map(|point| point.position).collect();
        drawing.ring(&around, &Pen { paint, level, ..Pen::default() });
    }
}
