//! Stretches of lanes that may hold one of several places near each other, made ready once for all of them.

use super::order::OrderedRun;
use super::rectangle::Rectangle;
use crate::area::{self, Slab};
use crate::index;
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::{Best, Candidate, LaneTypes, Nearest, NearestOptions};
use crate::ready::Ready;
use crate::types::Point;
use glam::DVec2;
use mapd_archive::NONE;
use mapd_geometry::normalize_angle;

/// Places of a tile at most.
const MOST_PLACES: usize = 256;
/// Fewer places than this are asked one by one, which then costs less.
const FEWEST_PLACES: usize = 3;
/// Largest extent of a tile along x and y `[m]`: over more than a lane's width too many stretches are looked at for nothing.
const EXTENT: f64 = 2.5;
/// Stretches of a tile at most; places with more around them are asked one by one.
const MOST_STRETCHES: usize = 32;
/// By how much a tile's box is widened `[m]`, and as a share of its coordinates: more than single precision rounds them.
const SLACK: f64 = 1e-3;
const SLACK_SHARE: f64 = 1e-6;

/// Places near each other, which follow each other along the curve.
pub(super) struct Cut {
    pub(super) count: usize,
    low: DVec2,
    high: DVec2,
}

impl Cut {
    /// Cuts the first tile off the ordered places that begin at `from`.
    pub(super) fn first(
        part: &OrderedRun<'_>,
        from: usize,
        place: impl Fn(usize) -> DVec2,
    ) -> Self {
        let mut cut = Self { count: 0, low: DVec2::INFINITY, high: DVec2::NEG_INFINITY };
        for i in part.numbers(from, MOST_PLACES) {
            let at = place(i);
            let (low, high) = (cut.low.min(at), cut.high.max(at));
            if high.x - low.x > EXTENT || high.y - low.y > EXTENT {
                break;
            }
            cut = Self { count: cut.count + 1, low, high };
        }
        cut
    }
}

/// A stretch of a lane.
struct Stretch<'a> {
    lane: Lane<'a>,
    slab: Slab<'a>,
    ready: Ready,
}

/// What a tile knows of a point.
pub(super) enum Around<'a> {
    /// A lane holds it: this one is the nearest.
    Held(Nearest),
    /// No lane holds it, or it lies on an edge; the best so far.
    Open(Best<'a>),
}

/// What may hold places of a tile. It is filled again for the next one.
pub(super) struct Tile<'a> {
    map: Map<'a>,
    rectangles: [Rectangle; MOST_STRETCHES],
    stretches: [Option<Stretch<'a>>; MOST_STRETCHES],
    count: usize,
}

impl<'a> Tile<'a> {
    pub(super) fn new(map: Map<'a>) -> Self {
        Self {
            map,
            rectangles: [Rectangle::NOWHERE; MOST_STRETCHES],
            stretches: [const { None }; MOST_STRETCHES],
            count: 0,
        }
    }

    /// Finds what may hold the places; whether that is worth while and everything has room.
    pub(super) fn fill(&mut self, cut: &Cut, types: LaneTypes) -> bool {
        self.count = 0;
        if cut.count < FEWEST_PLACES {
            return false;
        }
        let map = self.map;
        let (low, high) = (cut.low - map.origin(), cut.high - map.origin());
        let slack = SLACK + SLACK_SHARE * low.abs().max(high.abs()).max_element();
        let (low, high) = (low - slack, high + slack);
        let (middle, reach) = (0.5 * (low + high), 0.5 * (high - low).length() + slack);
        let tolerance = map.index_tolerance() as f32;
        let mut fits = true;
        index::visit_box(map.tables(), low, high, |leaf| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let from = middle - DVec2::new(f64::from(leaf.x()), f64::from(leaf.y()));
            let lower = index::lower_bounds(leaf, from.x as f32, from.y as f32, None);
            for k in 0..lower.len() {
                if fits && f64::from(lower[k]) <= reach && lanes[k] != NONE {
                    let segment = usize::from(segments[k]);
                    fits = self.add(lanes[k], segment, Rectangle::of(leaf, k, tolerance), types);
                }
            }
        });
        if fits {
            self.put_first(middle);
        }
        fits
    }

    /// Puts the stretch first whose centre may be nearest to a point: most places around it lie in the same one, and what comes after the nearest
    /// hardly costs anything.
    fn put_first(&mut self, middle: DVec2) {
        let rectangles = self.rectangles.get(..self.count).unwrap_or_default();
        let off_center = |(k, rectangle): (usize, &Rectangle)| {
            rectangle.holds(middle).map(|beside| (rectangle.off_center(beside), k))
        };
        let held = rectangles.iter().enumerate().filter_map(off_center);
        if let Some((_, k)) = held.min_by(|a, b| a.0.total_cmp(&b.0)) {
            self.rectangles.swap(0, k);
            self.stretches.swap(0, k);
        }
    }

    /// Whether there is room; what cannot hold anything needs none.
    fn add(&mut self, lane: u32, segment: usize, rectangle: Rectangle, types: LaneTypes) -> bool {
        let lane = Lane::new(self.map, lane).filter(|lane| types.contains(lane.kind()));
        let Some(lane) = lane else { return true };
        let Some(slab) = area::slab(&lane, segment) else { return true };
        let Some(ready) = Ready::new(&lane, &slab) else { return false };
        let room = (self.rectangles.get_mut(self.count), self.stretches.get_mut(self.count));
        let (Some(own), Some(stretch)) = room else { return false };
        (*own, *stretch) = (rectangle, Some(Stretch { lane, slab, ready }));
        self.count += 1;
        true
    }

    /// What the lanes that hold a point say, as [`Map::nearest_lane`] begins.
    #[inline(always)]
    pub(super) fn around(
        &self,
        point: Point,
        local: DVec2,
        options: &NearestOptions,
    ) -> Around<'a> {
        let (mut best, mut nearest) = (Best::default(), None);
        let is_by_offset = options.is_by_offset(point);
        let rectangles = self.rectangles.get(..self.count).unwrap_or_default();
        for (k, rectangle) in rectangles.iter().enumerate() {
            let Some(beside) = rectangle.holds(local) else { continue };
            // Without one yet, there is no need for the root.
            if is_by_offset
                && nearest.is_some()
                && best.is_nearer_than(rectangle.off_center(beside))
            {
                continue;
            }
            let Some(Some(stretch)) = self.stretches.get(k) else { continue };
            let Stretch { lane, slab, ready } = stretch;
            let found = Candidate::around(lane, ready, slab, point, local, options);
            if best.consider(found.as_ref(), self.map, options) {
                nearest = Some(stretch);
            }
        }
        match (best.found(), nearest) {
            (Some(found), Some(stretch)) if found.distance() == 0.0 => {
                Around::Held(stretch.nearest(found))
            }
            _ => Around::Open(best),
        }
    }
}

impl<'a> Stretch<'a> {
    /// As [`Candidate::nearest`].
    #[inline(always)]
    fn nearest(&self, found: &Candidate<'a>) -> Nearest {
        let (s, piece) = (found.place.s(), &self.slab.piece);
        let line = normalize_angle(piece.curve.heading(s - piece.s));
        let position = found.place.position_with(&self.lane, line, self.ready.elevation(s));
        Nearest { lane: self.lane.lane_id(), position }
    }
}
