//! Stretches of lanes that may hold one of several places near each other, made ready once for all of them.

use super::order::Part;
use super::rectangle::Rectangle;
use crate::area::{self, Slab};
use crate::index;
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::{Best, Candidate, LaneTypes, NearestOptions};
use crate::types::Point;
use glam::DVec2;
use mapd_archive::NONE;

/// Places of a tile at most.
const MOST_PLACES: usize = 128;
/// Fewer places than this are asked one by one, which then costs less.
const FEWEST_PLACES: usize = 3;
/// Largest extent of a tile along x and y `[m]`: over more than a lane's width too many stretches are looked at for nothing.
const EXTENT: f64 = 2.5;
/// Stretches of a tile at most; places with more around them are asked one by one.
const MOST_STRETCHES: usize = 32;
/// By how much a tile's box is widened `[m]`, and as a share of its coordinates: more than single precision rounds them.
const SLACK: f64 = 1e-3;
const SLACK_SHARE: f64 = 1e-6;

/// Cuts the first tile off the ordered places that begin at `from`: how many there are, and their box in inertial coordinates.
pub(super) fn cut(part: &Part<'_>, from: usize, place: impl Fn(usize) -> DVec2) -> Cut {
    let start = place(part.number(from));
    let mut cut = Cut { count: 1, low: start, high: start };
    let end = part.len().min(from + MOST_PLACES);
    for k in from + 1..end {
        let at = place(part.number(k));
        let (low, high) = (cut.low.min(at), cut.high.max(at));
        if (high - low).max_element() > EXTENT {
            break;
        }
        cut = Cut { count: cut.count + 1, low, high };
    }
    cut
}

/// Places near each other.
pub(super) struct Cut {
    pub(super) count: usize,
    low: DVec2,
    high: DVec2,
}

impl Cut {
    pub(super) fn is_worth_it(&self) -> bool {
        self.count >= FEWEST_PLACES
    }
}

/// A stretch of a lane with its rectangle in the index.
struct Stretch<'a> {
    lane: Lane<'a>,
    slab: Slab<'a>,
    rectangle: Rectangle,
}

/// What may hold places of a tile.
pub(super) struct Tile<'a> {
    map: Map<'a>,
    stretches: [Option<Stretch<'a>>; MOST_STRETCHES],
    count: usize,
}

impl<'a> Tile<'a> {
    /// None where there is too much.
    pub(super) fn new(map: Map<'a>, cut: &Cut, types: LaneTypes) -> Option<Self> {
        let (low, high) = (cut.low - map.origin(), cut.high - map.origin());
        let slack = SLACK + SLACK_SHARE * low.abs().max(high.abs()).max_element();
        let (low, high) = (low - slack, high + slack);
        let (middle, reach) = (0.5 * (low + high), 0.5 * (high - low).length() + slack);
        let mut tile = Self { map, stretches: [const { None }; MOST_STRETCHES], count: 0 };
        let mut fits = true;
        index::visit_box(map.tables(), low, high, |leaf| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let from = middle - DVec2::new(f64::from(leaf.x()), f64::from(leaf.y()));
            let lower = index::lower_bounds(leaf, from.x as f32, from.y as f32, None);
            for k in 0..lower.len() {
                if f64::from(lower[k]) > reach || lanes[k] == NONE {
                    continue;
                }
                let lane = Lane::new(map, lanes[k]).filter(|lane| types.contains(lane.kind()));
                let Some(lane) = lane else { continue };
                let Some(slab) = area::slab(&lane, usize::from(segments[k])) else { continue };
                let Some(place) = tile.stretches.get_mut(tile.count) else {
                    fits = false;
                    return;
                };
                *place = Some(Stretch { lane, slab, rectangle: Rectangle::of(leaf, k) });
                tile.count += 1;
            }
        });
        fits.then_some(tile)
    }

    /// The best of the lanes that hold a point, as [`Map::nearest_lane`] begins.
    #[inline]
    pub(super) fn lane_around(
        &self,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) -> Option<Candidate<'a>> {
        let mut best = Best::default();
        for stretch in self.stretches.iter().take(self.count).flatten() {
            if stretch.rectangle.holds(local) {
                let Stretch { lane, slab, .. } = stretch;
                best.consider(
                    Candidate::around(lane, slab, point, local, options),
                    self.map,
                    options,
                );
            }
        }
        best.found()
    }
}
