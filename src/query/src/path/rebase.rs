//! A path on another version of its map.

use super::{Path, Piece};
use crate::error::QueryError;
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::NearestOptions;
use crate::route::{Enter, PositionOnLane, Route, RouteCost, RouteScratch, RouteStep};
use glam::DVec2;
use mapd_archive::VehicleClass;
use std::f64::consts::FRAC_PI_4;

/// A lane of the same key whose line lies within this of the old one is the same `[m]`: rounding, and a shift that nobody notices.
const SAME: f64 = 0.1;
/// A line farther away than this is another one `[m]`: less than the width of a lane.
pub(super) const FAR: f64 = 2.0;
/// The heading of a lane in the place of another differs by less than this `[rad]`.
const TURNED: f64 = FRAC_PI_4;
/// Shorter pieces are not looked for one by one `[m]`: what lies around them leads over them.
const SHORT: f64 = 1.0;

/// What has become of a stretch of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathChange {
    /// S on the old path `[m]`.
    pub along: [f64; 2],
    /// What has become of it.
    pub kind: PathChangeKind,
}

/// What has become of a stretch of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum PathChangeKind {
    /// Its lane has the same key and has moved, at most this far where it was looked at `[m]`.
    Moved(f64),
    /// A lane with another key lies there, at most this far away where it was looked at `[m]`.
    Replaced(f64),
    /// No lane lies there for the vehicle and its direction.
    Gone,
}

impl Path<'_, '_> {
    /// The way of this path on another map, such as the next version of its own: its lanes are found by key, and where there is none or it
    /// lies elsewhere by their place. Where all are there by key and are entered as before, its steps are this path's; else a way is searched. `steps` is emptied first and holds the new route, for [`Map::path`]; `changes` what has
    /// changed and where, in ascending S of the old path: nothing for a map on which all is the same. None if no way leads along what is
    /// left of the path. This allocates: it is for the moment after a swap, not for each cycle.
    ///
    /// Errors: a damaged archive.
    pub fn rebase(
        &self,
        map: Map<'_>,
        vehicle: VehicleClass,
        cost: &impl RouteCost,
        scratch: &mut RouteScratch,
        steps: &mut Vec<RouteStep>,
        changes: &mut Vec<PathChange>,
    ) -> Result<Option<Route>, QueryError> {
        steps.clear();
        changes.clear();
        let mut places: Vec<PositionOnLane> = Vec::new();
        let last = self.buffer.pieces.len().saturating_sub(1);
        for (number, piece) in self.buffer.pieces.iter().enumerate() {
            let [from, to] = self.ends_of(piece);
            let is_end = number == 0 || number == last;
            if to - from < SHORT && !is_end {
                continue;
            }
            let mut worst: Option<PathChangeKind> = None;
            let middle = 0.5 * (from + to);
            for along in [from, middle, to] {
                let (place, kind) = self.found_at(piece, along, map, vehicle)?;
                worst = worse(worst, kind);
                let counts = along == middle
                    || (number == 0 && along == from)
                    || (number == last && along == to);
                places.extend(place.filter(|_| counts));
            }
            if let Some(kind) = worst {
                changes.push(PathChange { along: [from, to], kind });
            }
        }
        // Its own steps say where a change of lane is possible; a search through the middles of lanes would narrow that.
        if changes.iter().all(|change| matches!(change.kind, PathChangeKind::Moved(_))) {
            match self.keep(map, vehicle, cost, steps) {
                Some(route) => return Ok(Some(route)),
                None => steps.clear(),
            }
        }
        let found = map.route_via(&places, vehicle, cost, scratch, steps)?;
        // Where one leg ends and the next begins, the lane goes on.
        steps.dedup_by(|next, before| {
            let goes_on = next.enter == Enter::Start
                && next.lane == before.lane
                && next.forward == before.forward
                && next.s_from == before.s_to;
            if goes_on {
                before.s_to = next.s_to;
            }
            goes_on
        });
        Ok(found)
    }

    /// The place on another map that a place of a piece has become, and what has changed.
    fn found_at(
        &self,
        piece: &Piece,
        along: f64,
        map: Map<'_>,
        vehicle: VehicleClass,
    ) -> Result<(Option<PositionOnLane>, Option<PathChangeKind>), QueryError> {
        let lane = Lane::new(self.map, piece.lane).ok_or(QueryError::Corrupt)?;
        let spans = self.spans_of(piece);
        let span = spans.iter().rfind(|span| span.along <= along).or(spans.first());
        let span = span.ok_or(QueryError::Corrupt)?;
        let s = span.s_at(along - span.along);
        let shift = self.shift_at(span, along);
        let own = super::along::center(&lane, span.place(s), piece.forward, shift.as_ref())?;
        let point = own.position.truncate();
        let by_key = map
            .lane_by_key(&lane.key())
            .filter(|lane| lane.node_at(s, piece.forward).is_some_and(|node| node.allows(vehicle)));
        if let Some(same) = by_key {
            let there = same.pose_at(s, 0.0).map(|pose| pose.position.truncate());
            let moved = there.map_or(f64::INFINITY, |there: DVec2| there.distance(point));
            if moved <= FAR {
                let kind = (moved > SAME).then_some(PathChangeKind::Moved(moved));
                return Ok((Some(PositionOnLane { lane: same.lane_id(), s }), kind));
            }
        }
        let options = NearestOptions {
            radius: FAR,
            vehicle: Some(vehicle),
            heading: Some(own.heading),
            heading_tolerance: Some(TURNED),
            ..NearestOptions::default()
        };
        Ok(match map.nearest_lane(point, &options)? {
            Some(found) => {
                let (lane, s) = (found.lane, found.position.s);
                let there = map.lane(lane)?.pose_at(s, 0.0)?;
                let away = there.position.truncate().distance(point);
                (Some(PositionOnLane { lane, s }), Some(PathChangeKind::Replaced(away)))
            }
            None => (None, Some(PathChangeKind::Gone)),
        })
    }
}

/// The one that changes more.
fn worse(a: Option<PathChangeKind>, b: Option<PathChangeKind>) -> Option<PathChangeKind> {
    let rank = |kind: &PathChangeKind| match kind {
        PathChangeKind::Moved(by) => (0, *by),
        PathChangeKind::Replaced(by) => (1, *by),
        PathChangeKind::Gone => (2, 0.0),
    };
    match (a, b) {
        (Some(a), Some(b)) if rank(&a) >= rank(&b) => Some(a),
        (a, b) => b.or(a),
    }
}
