//! What is laid over a map now, as it is drawn.

use mapd_client::Map;
use mapd_client::glam::DVec3;
#[cfg(feature = "svg")]
use mapd_client::view::OverlayKind;
use mapd_client::view::Restriction;

/// How far apart the corners of a drawn stretch are at most `[m]`, unless it had more than [`MOST_PARTS`].
const STEP: f64 = 2.0;
/// Parts that one stretch is drawn in at most: none is so long but in a damaged archive.
const MOST_PARTS: usize = 1 << 14;

/// Its class in a drawing.
#[cfg(feature = "svg")]
pub(super) fn class(kind: OverlayKind) -> &'static str {
    match kind {
        OverlayKind::Closed => "closed",
        OverlayKind::Open => "opened",
        OverlayKind::Speed => "slower",
        _ => "told",
    }
}

/// Corners of the stretch of a lane on which an entry holds: along its inner edge, back along the outer one. None on a damaged archive.
pub(super) fn area(map: Map<'_>, one: &Restriction<'_>) -> Option<Vec<DVec3>> {
    let lane = map.lane(one.lane).ok()?;
    let length = one.s_to - one.s_from;
    let count = ((length / STEP).ceil() as usize).clamp(1, MOST_PARTS);
    let at = |i: usize| lane.edge_points_at(one.s_from + length * i as f64 / count as f64);
    let edges: Vec<[DVec3; 2]> = (0..=count).map(at).collect::<Option<_>>()?;
    let inner = edges.iter().map(|[inner, _]| *inner);
    Some(inner.chain(edges.iter().rev().map(|[_, outer]| *outer)).collect())
}
