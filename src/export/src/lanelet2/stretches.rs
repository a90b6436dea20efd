//! Lane sections cut into pieces along which nothing changes that Lanelet2 says once of a lanelet.

use mapd_client::SRange;
use mapd_client::glam::DVec3;
use mapd_client::graph::LaneNode;
use mapd_client::roads::LinePoint;
use mapd_client::roads::RoadMark;
use mapd_client::{Lane, LaneSection, Map};
use std::collections::HashMap;

/// Shortest piece `[m]`: a cut nearer to another is left out, and a section that is shorter becomes part of its neighbours.
pub(super) const SHORTEST: f64 = 0.1;
/// Points of a border that are nearer to its ends than this along the road are those ends, but for what jumps there `[m]`.
const SAME_PLACE: f64 = 1e-3;
/// What is nearer to an end than this does not jump there `[m]`.
const SAME_POINT: f64 = 0.01;

/// A lane section with the places where its lanes are cut.
pub(super) struct Stretch<'a> {
    pub(super) section: LaneSection<'a>,
    /// All lanes from left to right, lane 0 among them: each stands for its border, too.
    pub(super) lanes: Vec<Lane<'a>>,
    /// s of all cuts, both ends among them, ascending `[m]`.
    pub(super) cuts: Vec<f64>,
    /// Number of the first corner: each border has one for each cut.
    first_corner: u32,
}

/// Where a node of the lane graph lies.
#[derive(Clone, Copy)]
pub(super) struct Span {
    pub(super) stretch: u32,
    /// Borders to the left and right of the reference line's direction.
    pub(super) borders: [u32; 2],
    /// Cuts at the smaller and at the larger s.
    pub(super) cuts: [u32; 2],
    pub(super) forward: bool,
}

/// All stretches of a map, and where the nodes of its lane graph lie on them.
pub(super) struct Stretches<'a> {
    pub(super) all: Vec<Stretch<'a>>,
    /// Where the corners lie `[m]`.
    pub(super) corners: Vec<DVec3>,
    /// By row of the node; none of lanes that nobody may use.
    spans: HashMap<u32, Span>,
}

impl<'a> Stretches<'a> {
    /// Cuts all permanent sections of a map.
    pub(super) fn of(map: Map<'a>) -> Self {
        let mut stretches = Self { all: Vec::new(), corners: Vec::new(), spans: HashMap::new() };
        for section in map.roads().flat_map(|road| road.sections()) {
            stretches.add(section);
        }
        stretches
    }

    fn add(&mut self, section: LaneSection<'a>) {
        let lanes: Vec<Lane<'a>> = section.lanes().collect();
        let cuts = cuts(&section, &lanes);
        let stretch = Stretch { section, lanes, cuts, first_corner: self.corners.len() as u32 };
        for border in &stretch.lanes {
            let place = |s: &f64| border.edge_points_at(*s).map_or(DVec3::NAN, |[_, outer]| outer);
            self.corners.extend(stretch.cuts.iter().map(place));
        }
        let number = self.all.len() as u32;
        for (at, lane) in stretch.lanes.iter().enumerate().filter(|(_, lane)| lane.number() != 0) {
            let borders = borders(lane, at);
            for node in lane.nodes().filter(LaneNode::is_open) {
                let SRange { low: from, high: to } = node.s_range();
                let cuts = [from, to].map(|s| stretch.cut_at(s));
                let span = Span { stretch: number, borders, cuts, forward: node.is_forward() };
                self.spans.insert(node.node_id().row(), span);
            }
        }
        self.all.push(stretch);
    }

    /// Where a node lies; none of one that nobody may use.
    pub(super) fn span(&self, node: &LaneNode<'_>) -> Option<Span> {
        self.spans.get(&node.node_id().row()).copied()
    }

    /// Corners on the left and right of travel where a span is entered, or where it is left.
    pub(super) fn ends(&self, span: &Span, at_end: bool) -> Option<[u32; 2]> {
        let stretch = self.all.get(span.stretch as usize)?;
        let [from, to] = span.cuts;
        let cut = if span.forward == at_end { to } else { from };
        let [left, right] = span.borders.map(|border| stretch.corner(border, cut));
        Some(if span.forward { [left, right] } else { [right, left] })
    }
}

impl<'a> Stretch<'a> {
    /// Number of the corner of a border at a cut.
    pub(super) fn corner(&self, border: u32, cut: u32) -> u32 {
        self.first_corner + border * self.cuts.len() as u32 + cut
    }

    /// The cut at s, which is one of them but for rounding.
    fn cut_at(&self, s: f64) -> u32 {
        let behind = self.cuts.partition_point(|cut| *cut < s);
        let near = |at: &usize| self.cuts.get(*at).map_or(f64::INFINITY, |cut| (cut - s).abs());
        let candidates = [behind.saturating_sub(1), behind];
        let best = candidates.into_iter().min_by(|a, b| near(a).total_cmp(&near(b)));
        best.unwrap_or(0) as u32
    }

    /// s of both ends of a piece `[m]`.
    pub(super) fn piece(&self, piece: u32) -> Option<(f64, f64)> {
        let at = piece as usize;
        Some((*self.cuts.get(at)?, *self.cuts.get(at + 1)?))
    }

    /// The piece that holds s.
    pub(super) fn piece_at(&self, s: f64) -> u32 {
        let last = self.cuts.len().saturating_sub(2);
        self.cuts.partition_point(|cut| *cut <= s).saturating_sub(1).min(last) as u32
    }

    /// Length along the road `[m]`.
    pub(super) fn length(&self) -> f64 {
        self.section.s_end() - self.section.s_start()
    }

    /// The points of a border within a piece, its ends left out, in ascending s. Where the border jumps at an end, the side of the jump that lies
    /// within the piece is not that end.
    pub(super) fn inner_points(&self, border: u32, piece: u32) -> Vec<DVec3> {
        let (from, to) = self.piece(piece).unwrap_or((0.0, 0.0));
        let Some(lane) = self.lanes.get(border as usize) else { return Vec::new() };
        let line = lane.border();
        let is_within = |at: &LinePoint| from - SAME_PLACE < at.s && at.s < to + SAME_PLACE;
        let points: Vec<LinePoint> = line.points().filter(is_within).collect();
        let reach = line.rounding() + SAME_POINT;
        let is_end = |s: f64| {
            let end = lane.edge_points_at(s).map_or(DVec3::NAN, |[_, outer]| outer);
            move |at: &LinePoint| at.position.distance(end) <= reach
        };
        let head = points.partition_point(|at| at.s <= from + SAME_PLACE);
        let tail = points.partition_point(|at| at.s < to - SAME_PLACE).max(head);
        let (heads, tails) = (points.get(..head), points.get(tail..));
        let first = heads.and_then(|heads| heads.iter().rposition(is_end(from)));
        let last = tails.and_then(|tails| tails.iter().position(is_end(to)));
        let range = first.map_or(head, |at| at + 1)..tail + last.unwrap_or(0);
        points.get(range).unwrap_or(&[]).iter().map(|at| at.position).collect()
    }
}

/// Borders to the left and right of the reference line's direction of the lane at a place in its section's list, which runs from
/// left to right.
pub(super) fn borders(lane: &Lane<'_>, at: usize) -> [u32; 2] {
    let at = at as u32;
    if lane.number() > 0 { [at, at + 1] } else { [at.saturating_sub(1), at] }
}

/// All places at which a section's lanes are cut, its ends among them: where the lane graph cuts them, where a speed limit or a
/// road mark changes.
fn cuts(section: &LaneSection<'_>, lanes: &[Lane<'_>]) -> Vec<f64> {
    let (start, end) = (section.s_start(), section.s_end());
    let nodes = lanes.iter().flat_map(|lane| lane.nodes());
    let mut cuts: Vec<f64> =
        nodes.map(|node| node.s_range()).flat_map(|range| [range.low, range.high]).collect();
    cuts.extend([start, end]);
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let mut wanted: Vec<f64> = lanes.iter().flat_map(changes).collect();
    if let Some(road) = section.road() {
        wanted.extend(road.types().map(|record| record.s));
    }
    wanted.sort_by(f64::total_cmp);
    for s in wanted {
        let at = cuts.partition_point(|cut| *cut < s);
        let before = at.checked_sub(1).and_then(|at| cuts.get(at));
        let is_free = |cut: Option<&f64>| cut.is_some_and(|cut| (cut - s).abs() >= SHORTEST);
        if is_free(before) && is_free(cuts.get(at)) {
            cuts.insert(at, s);
        }
    }
    cuts
}

/// Where a lane's speed limit or the mark on its border changes.
fn changes(lane: &Lane<'_>) -> Vec<f64> {
    let mut out: Vec<f64> = lane.speed_rules().skip(1).map(|own| own.s.low).collect();
    let marks: Vec<RoadMark<'_>> = lane.road_marks().collect();
    let look = |mark: &RoadMark<'_>| (mark.kind(), mark.color(), mark.weight());
    let pairs = marks.windows(2).filter(|pair| look(&pair[0]) != look(&pair[1]));
    out.extend(pairs.map(|pair| pair[1].s()));
    out
}
