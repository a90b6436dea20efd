//! The area of an object in track coordinates of a road: which lanes it lies on, and from where to where.

use glam::DVec2;
use mapd_query::{Lane, LaneSection, Road};

/// An object whose area reaches into a lane by no more than this `[m]` touches it at most: borders and corners are
/// rounded.
const TOUCH: f64 = 0.02;

/// Corners (s, t) of an area; one corner is a point, two are a line.
pub(super) struct TrackArea {
    corners: Vec<DVec2>,
    /// Smallest and largest s.
    pub(super) s: [f64; 2],
}

/// A stretch of a lane, and how far to the side of it the area lies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    pub(super) s: [f64; 2],
    pub(super) distance: f64,
}

impl TrackArea {
    pub(super) fn new(corners: Vec<DVec2>) -> Option<Self> {
        let low = corners.iter().map(|c| c.x).fold(f64::INFINITY, f64::min);
        let high = corners.iter().map(|c| c.x).fold(f64::NEG_INFINITY, f64::max);
        (low <= high).then_some(Self { corners, s: [low, high] })
    }

    /// The area, longer towards larger s: what holds for a length.
    pub(super) fn lengthened(mut self, to: f64) -> Self {
        self.s[1] = self.s[1].max(to);
        self
    }

    /// Smallest and largest t of the area at s; at its nearest corner where s lies beyond it.
    fn across(&self, s: f64) -> [f64; 2] {
        let [mut low_t, mut high_t] = [f64::INFINITY, f64::NEG_INFINITY];
        for (i, a) in self.corners.iter().enumerate() {
            let b = self.corners[(i + 1) % self.corners.len()];
            let (low, high) = if a.x <= b.x { (*a, b) } else { (b, *a) };
            if low.x <= s && s <= high.x {
                let share = if high.x > low.x { (s - low.x) / (high.x - low.x) } else { 0.0 };
                let t = low.y + (high.y - low.y) * share;
                (low_t, high_t) = (low_t.min(t), high_t.max(t));
                if low.x == high.x {
                    (low_t, high_t) = (low_t.min(high.y), high_t.max(high.y));
                }
            }
        }
        if low_t > high_t {
            let distance = |c: &DVec2| (c.x - s).abs();
            let nearest = self.corners.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            return nearest.map_or([0.0; 2], |corner| [corner.y; 2]);
        }
        [low_t, high_t]
    }

    /// Places along the road at which the area is compared with lanes: its corners, and the middles between them.
    fn stations(&self) -> Vec<f64> {
        let mut stations: Vec<f64> = self.corners.iter().map(|c| c.x).collect();
        stations.push(self.s[1]);
        stations.sort_by(f64::total_cmp);
        stations.dedup();
        let middles: Vec<f64> = stations.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        stations.extend(middles);
        stations.sort_by(f64::total_cmp);
        stations
    }

    /// How far the area lies to the side of a lane at s `[m]`; negative by as much as it reaches into it.
    fn gap(&self, lane: &Lane<'_>, s: f64) -> f64 {
        let edges = lane.edges_at(s);
        let (low, high) = (edges.inner.min(edges.outer), edges.inner.max(edges.outer));
        let [from, to] = self.across(s);
        (low - to).max(from - high)
    }

    /// The stretch of a lane along which the area lies on it, or beside it if `beside`. A lane without width is under
    /// nothing.
    pub(super) fn on(&self, lane: &Lane<'_>, beside: bool) -> Option<Stretch> {
        let section = lane.section();
        let within = |s: f64| mapd_geometry::clamp(s, section.s_start(), section.s_end());
        let mut found: Option<Stretch> = None;
        let mut add = |s: f64| {
            let gap = self.gap(lane, s);
            let [from, to] = self.across(s);
            // What is narrower than a touch is on the lane if it is there at all.
            let least = if to - from > TOUCH { -TOUCH } else { 0.0 };
            if !beside && (gap > least || lane.width_at(s) <= 0.0) {
                return;
            }
            let distance = gap.max(0.0);
            let stretch = found.get_or_insert(Stretch { s: [s, s], distance });
            stretch.s = [stretch.s[0].min(s), stretch.s[1].max(s)];
            stretch.distance = stretch.distance.min(distance);
        };
        let inside = self.stations().into_iter().filter(|s| within(*s) == *s);
        inside.chain(self.s.map(within)).for_each(&mut add);
        found
    }

    /// Sections that the area reaches into.
    pub(super) fn sections<'a>(&self, road: &Road<'a>) -> impl Iterator<Item = LaneSection<'a>> {
        let (first, last) = (road.section_at(self.s[0]), road.section_at(self.s[1]));
        let number = |section: Option<LaneSection<'_>>| section.map(|section| section.number());
        let (from, to) = (number(first).unwrap_or(0), number(last).unwrap_or(0));
        let road = *road;
        (from..=to).filter_map(move |number| road.section(number))
    }
}
