//! The area of an object in track coordinates of a road: which lanes it lies on, and from where to where.

use glam::DVec2;
use mapd_query::compiling::SectionCutter;
use mapd_query::{Lane, LaneEdges, LaneSection, Road};

/// An object whose area reaches into a lane by no more than this `[m]` touches it at most: borders and corners are
/// rounded.
const TOUCH: f64 = 0.02;

/// Corners whose places along the road are looked at: a building of 500 m every half metre. More are looked at in groups.
const MOST_STATIONS: usize = 1000;

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

    /// The area as it is compared with the lanes of a road.
    pub(super) fn along<'a>(self, road: &Road<'a>) -> Profile<'a> {
        let sections: Vec<LaneSection<'a>> = self.sections(road).collect();
        let ends = sections.iter().flat_map(|section| {
            self.s.map(|s| mapd_geometry::clamp(s, section.s_start(), section.s_end()))
        });
        let mut stations = self.stations();
        stations.extend(ends);
        stations.sort_by(f64::total_cmp);
        stations.dedup();
        let across = self.across(&stations);
        Profile { sections, stations, across }
    }

    /// Places along the road at which the area is compared with lanes: its corners, and the middles between them; of many
    /// corners, some.
    fn stations(&self) -> Vec<f64> {
        let mut stations: Vec<f64> = self.corners.iter().map(|c| c.x).collect();
        stations.push(self.s[1]);
        stations.sort_by(f64::total_cmp);
        stations.dedup();
        let last = stations.len() - 1;
        if stations.len() > MOST_STATIONS {
            let share = |i: usize| stations[i * last / (MOST_STATIONS - 1)];
            stations = (0..MOST_STATIONS).map(share).collect();
        }
        let middles: Vec<f64> = stations.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        stations.extend(middles);
        stations
    }

    /// Smallest and largest t of the area at each of some s in ascending order; at its nearest corner where s lies beyond it.
    /// Corners between two of them, of an area with many, count at the nearer one.
    fn across(&self, stations: &[f64]) -> Vec<[f64; 2]> {
        const NOTHING: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];
        let mut across = vec![NOTHING; stations.len()];
        let mut add = |at: usize, t: f64| {
            if let Some([low, high]) = across.get_mut(at) {
                (*low, *high) = (low.min(t), high.max(t));
            }
        };
        for (i, a) in self.corners.iter().enumerate() {
            let b = self.corners[(i + 1) % self.corners.len()];
            let (low, high) = if a.x <= b.x { (*a, b) } else { (b, *a) };
            let first = stations.partition_point(|s| *s < low.x);
            let held = stations[first..].iter().enumerate().take_while(|(_, s)| **s <= high.x);
            for (i, s) in held {
                let share = if high.x > low.x { (s - low.x) / (high.x - low.x) } else { 0.0 };
                add(first + i, low.y + (high.y - low.y) * share);
                if low.x == high.x {
                    add(first + i, high.y);
                }
            }
            // A corner between two stations, of which not all corners are one.
            let after = stations.partition_point(|s| *s < a.x);
            if after > 0 && stations.get(after).is_some_and(|s| *s > a.x) {
                let is_nearer = a.x - stations[after - 1] < stations[after] - a.x;
                add(if is_nearer { after - 1 } else { after }, a.y);
            }
        }
        // Beyond all corners, the outermost; the first of several.
        let by_s = |a: &&DVec2, b: &&DVec2| a.x.total_cmp(&b.x);
        let first = self.corners.iter().min_by(by_s);
        let last = self.corners.iter().rev().max_by(by_s);
        for (s, of) in stations.iter().zip(&mut across).filter(|(_, of)| of[0] > of[1]) {
            let nearest = if first.is_some_and(|first| *s < first.x) { first } else { last };
            *of = nearest.map_or([0.0; 2], |corner| [corner.y; 2]);
        }
        across
    }

    /// Sections that the area reaches into.
    fn sections<'a>(&self, road: &Road<'a>) -> impl Iterator<Item = LaneSection<'a>> {
        let (first, last) = (road.section_at(self.s[0]), road.section_at(self.s[1]));
        let number = |section: Option<LaneSection<'_>>| section.map(|section| section.number());
        let (from, to) = (number(first).unwrap_or(0), number(last).unwrap_or(0));
        let road = *road;
        (from..=to).filter_map(move |number| road.section(number))
    }
}

/// An area seen along a road.
pub(super) struct Profile<'a> {
    /// Sections that it reaches into.
    sections: Vec<LaneSection<'a>>,
    /// Places along the road, ascending.
    stations: Vec<f64>,
    /// Smallest and largest t of the area there.
    across: Vec<[f64; 2]>,
}

impl<'a> Profile<'a> {
    /// Lanes but lane 0 that the area lies on, or beside if `beside`, each with the stretch. A lane without width is under
    /// nothing.
    pub(super) fn lanes(&self, beside: bool) -> Vec<(Lane<'a>, Stretch)> {
        let mut out = Vec::new();
        for section in &self.sections {
            let lanes: Vec<Lane<'a>> = section.lanes().collect();
            let mut edges = vec![LaneEdges { inner: 0.0, outer: 0.0 }; lanes.len()];
            let mut found: Vec<Option<Stretch>> = vec![None; lanes.len()];
            // Widths add up from lane 0 outwards: once for all lanes, not for each one.
            let mut cutter = SectionCutter::new(*section);
            let first = self.stations.partition_point(|s| *s < section.s_start());
            let stations = self.stations.iter().zip(&self.across).skip(first);
            for (s, across) in stations.take_while(|(s, _)| **s <= section.s_end()) {
                let cut = cutter.as_mut().and_then(|cutter| cutter.edges(*s, &mut edges));
                if cut.is_none() {
                    let one_by_one = lanes.iter().map(|lane| lane.edges_at(*s));
                    edges.iter_mut().zip(one_by_one).for_each(|(edges, one)| *edges = one);
                }
                for (edges, found) in edges.iter().zip(&mut found) {
                    if let Some(distance) = distance(*across, *edges, beside) {
                        let stretch = found.get_or_insert(Stretch { s: [*s, *s], distance });
                        stretch.s = [stretch.s[0].min(*s), stretch.s[1].max(*s)];
                        stretch.distance = stretch.distance.min(distance);
                    }
                }
            }
            let found = lanes.into_iter().zip(found).filter(|(lane, _)| lane.number() != 0);
            out.extend(found.filter_map(|(lane, stretch)| Some((lane, stretch?))));
        }
        out
    }
}

/// How far an area from one t to another lies to the side of a lane `[m]`; none where it must lie on it and does not.
fn distance([from, to]: [f64; 2], edges: LaneEdges, beside: bool) -> Option<f64> {
    let (low, high) = (edges.inner.min(edges.outer), edges.inner.max(edges.outer));
    // Negative by as much as it reaches into the lane.
    let gap = (low - to).max(from - high);
    // What is narrower than a touch is on the lane if it is there at all.
    let least = if to - from > TOUCH { -TOUCH } else { 0.0 };
    let is_on = gap <= least && edges.width() > 0.0;
    (beside || is_on).then_some(gap.max(0.0))
}
