//! The lanelets of a map: which there are, which points they share, and what follows what because of it.

use super::joints::{Joints, SNAP};
use super::report::{Entry, Report};
use super::stretches::{SHORTEST, Span, Stretch, Stretches};
use mapd_client::glam::DVec3;
use mapd_client::graph::LaneNode;
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Lane, Map};
use std::collections::{BTreeSet, HashMap, HashSet};

/// Ends this near to each other were meant to be one: files round their coordinates. That they are put together is not worth a
/// line of the report `[m]`.
const ROUNDING: f64 = 1e-3;

/// A piece of a lane that is nowhere wider is no lanelet: nobody can tell its left border from its right one `[m]`.
const NARROWEST: f64 = 0.01;
/// A width is looked at at both ends of a piece and at this number less one of places between, besides those where its law changes.
const WIDTHS: u32 = 8;

/// A lanelet: a piece of a lane.
pub(super) struct Lanelet<'a> {
    pub(super) lane: Lane<'a>,
    /// The node of the lane's own direction that it is, or is a part of.
    pub(super) node: LaneNode<'a>,
    pub(super) stretch: u32,
    pub(super) piece: u32,
    /// Borders to the left and right of the reference line's direction.
    pub(super) borders: [u32; 2],
    /// Whether it is travelled both ways.
    pub(super) is_two_way: bool,
}

/// A lanelet, travelled in a direction.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(super) struct Way {
    pub(super) lanelet: u32,
    /// Whether it is travelled towards +s.
    pub(super) forward: bool,
}

/// A map as lanelets that share points.
pub(super) struct Network<'a> {
    pub(super) stretches: Stretches<'a>,
    pub(super) joints: Joints,
    pub(super) lanelets: Vec<Lanelet<'a>>,
    /// Numbers of lanelets by row of the lane and piece.
    numbers: HashMap<(u32, u32), u32>,
    /// Whether a stretch became part of its neighbours.
    merged: Vec<bool>,
}

/// Where a node of the lane graph is left for the next one.
struct Meeting<'a> {
    from: LaneNode<'a>,
    to: LaneNode<'a>,
    /// Corners of both, on the left and on the right.
    pairs: [(u32, u32); 2],
    /// The larger one of their distances `[m]`.
    distance: f64,
}

/// Two points of which one is on the left of travel, and the ways that end and begin at both.
#[derive(Default)]
struct Knot {
    ends: Vec<Way>,
    starts: Vec<Way>,
}

impl<'a> Network<'a> {
    /// Makes the lanelets of a map, and lists what could not be kept as it is.
    pub(super) fn of(map: Map<'a>, report: &mut Report) -> Self {
        let stretches = Stretches::of(map);
        let meetings = meetings(map, &stretches);
        let short = stretches.all.iter().map(|stretch| stretch.length() < SHORTEST).collect();
        let joints = Joints::new(&stretches.corners);
        let (lanelets, numbers) = (Vec::new(), HashMap::new());
        let mut network = Self { stretches, joints, lanelets, numbers, merged: short };
        // Each round keeps at least one more of the short stretches.
        let snapped = loop {
            let snapped = network.join(&meetings);
            network.number_lanelets();
            if !network.keep_what_must_be(&meetings) {
                break snapped;
            }
        };
        network.tell(&snapped, &meetings, report);
        network
    }

    /// Puts corners together: those that are one but for rounding, both ends of short stretches, then those that are near to each
    /// other, the nearest first. Returns the last ones.
    fn join<'m>(&mut self, meetings: &'m [Meeting<'a>]) -> Vec<&'m Meeting<'a>> {
        self.joints = Joints::new(&self.stretches.corners);
        let near = meetings.partition_point(|meeting| meeting.distance <= ROUNDING);
        for meeting in meetings.get(..near).unwrap_or(&[]) {
            self.joints.join(&meeting.pairs);
        }
        for (stretch, merged) in self.stretches.all.iter().zip(&mut self.merged) {
            let last = stretch.cuts.len().saturating_sub(1) as u32;
            let both = |border| (stretch.corner(border, 0), stretch.corner(border, last));
            let pairs: Vec<_> = (0..stretch.lanes.len() as u32).map(both).collect();
            *merged = *merged && self.joints.join(&pairs);
        }
        let rest = meetings.get(near..).unwrap_or(&[]).iter();
        let within = rest.take_while(|meeting| meeting.distance <= SNAP);
        within.filter(|meeting| self.joints.join(&meeting.pairs)).collect()
    }

    fn number_lanelets(&mut self) {
        self.lanelets.clear();
        self.numbers.clear();
        let stretches = self.stretches.all.iter().zip(&self.merged).enumerate();
        for (number, (stretch, _)) in stretches.filter(|(_, (_, merged))| !**merged) {
            for lane in stretch.lanes.iter().filter(|lane| lane.number() != 0) {
                let own = |node: &LaneNode<'_>| node.is_forward() == lane.is_forward();
                for node in lane.nodes().filter(own) {
                    let Some(span) = self.stretches.span(&node) else { continue };
                    let is_two_way =
                        lane.nodes().any(|node| node.is_forward() != lane.is_forward());
                    for piece in
                        (span.cuts[0]..span.cuts[1]).filter(|at| is_wide(lane, stretch, *at))
                    {
                        let key = (lane.lane_id().row(), piece);
                        self.numbers.insert(key, self.lanelets.len() as u32);
                        let (lane, borders) = (*lane, span.borders);
                        let stretch = number as u32;
                        let lanelet = Lanelet { lane, node, stretch, piece, borders, is_two_way };
                        self.lanelets.push(lanelet);
                    }
                }
            }
        }
    }

    /// Stretches that did not become part of their neighbours, with their numbers.
    pub(super) fn kept(&self) -> impl Iterator<Item = (u32, &Stretch<'a>)> {
        let all = (0..).zip(&self.stretches.all).zip(&self.merged);
        all.filter(|(_, merged)| !**merged).map(|(numbered, _)| numbered)
    }

    /// The number of the lanelet of a lane at a piece of its stretch.
    pub(super) fn number(&self, lane: &Lane<'_>, piece: u32) -> Option<u32> {
        self.numbers.get(&(lane.lane_id().row(), piece)).copied()
    }

    /// The stretch of a lane, and its number, where it did not become part of its neighbours.
    pub(super) fn lanelet_at(&self, lane: &Lane<'_>, s: f64) -> Option<u32> {
        let span = lane.nodes().find_map(|node| self.stretches.span(&node))?;
        self.number(lane, self.stretches.all.get(span.stretch as usize)?.piece_at(s))
    }

    /// Numbers of the lanelets of a lane, in its own driving direction.
    pub(super) fn lanelets_of(&self, lane: &Lane<'_>) -> Vec<u32> {
        let Some(span) = lane.nodes().find_map(|node| self.stretches.span(&node)) else {
            return Vec::new();
        };
        let stretch = self.stretches.all.get(span.stretch as usize);
        let pieces = stretch.map_or(0, |stretch| stretch.cuts.len()) as u32;
        let mut numbers: Vec<u32> = (0..pieces).filter_map(|at| self.number(lane, at)).collect();
        if !lane.is_forward() {
            numbers.reverse();
        }
        numbers
    }

    /// Points on the left and right of travel where a way begins, or where it ends.
    fn points(&self, way: Way, at_end: bool) -> Option<[u32; 2]> {
        let lanelet = self.lanelets.get(way.lanelet as usize)?;
        let cuts = [lanelet.piece, lanelet.piece + 1];
        let (stretch, borders, forward) = (lanelet.stretch, lanelet.borders, way.forward);
        let span = Span { stretch, borders, cuts, forward };
        Some(self.stretches.ends(&span, at_end)?.map(|corner| self.joints.point(corner)))
    }

    /// All ways.
    fn ways(&self) -> impl Iterator<Item = Way> + use<'_, 'a> {
        self.lanelets.iter().enumerate().flat_map(|(number, lanelet)| {
            let forward = lanelet.lane.is_forward();
            let own = Way { lanelet: number as u32, forward };
            let back = Way { forward: !forward, ..own };
            [Some(own), lanelet.is_two_way.then_some(back)].into_iter().flatten()
        })
    }

    fn knots(&self) -> HashMap<[u32; 2], Knot> {
        let mut knots: HashMap<[u32; 2], Knot> = HashMap::new();
        for way in self.ways() {
            if let (Some(start), Some(end)) = (self.points(way, false), self.points(way, true)) {
                knots.entry(start).or_default().starts.push(way);
                knots.entry(end).or_default().ends.push(way);
            }
        }
        knots
    }

    /// Whether there is somebody who may use a way and other ways.
    fn is_shared(&self, ways: &[Way], class: VehicleClass) -> bool {
        let allows = |way: &&Way| {
            self.lanelets.get(way.lanelet as usize).is_some_and(|one| one.node.allows(class))
        };
        ways.iter().filter(allows).count() > 1
    }

    /// Short stretches stay lanelets of their own where Lanelet2 would refuse the map, which it does where several ways come together and
    /// part at the same two points, and where they would keep ends apart that are near enough. Returns whether any stays that
    /// did not before.
    fn keep_what_must_be(&mut self, meetings: &[Meeting<'a>]) -> bool {
        let mut crowded = HashSet::new();
        for (points, knot) in self.knots() {
            let both = |class: &VehicleClass| {
                self.is_shared(&knot.ends, *class) && self.is_shared(&knot.starts, *class)
            };
            if VehicleClass::ALL.iter().any(both) {
                crowded.extend(points);
            }
        }
        for meeting in meetings.iter().take_while(|meeting| meeting.distance <= SNAP) {
            let is_joined = |(a, b): &(u32, u32)| self.joints.point(*a) == self.joints.point(*b);
            if !meeting.pairs.iter().all(is_joined) {
                let corners = meeting.pairs.iter().flat_map(|(a, b)| [*a, *b]);
                crowded.extend(corners.map(|corner| self.joints.point(corner)));
            }
        }
        let mut is_kept = false;
        for (stretch, merged) in self.stretches.all.iter().zip(&mut self.merged) {
            let mut corners =
                (0..stretch.lanes.len() as u32).map(|border| stretch.corner(border, 0));
            if *merged && corners.any(|corner| crowded.contains(&self.joints.point(corner))) {
                (*merged, is_kept) = (false, true);
            }
        }
        is_kept
    }

    /// The ways that follow a way in the map's lane graph, over stretches that became part of their neighbours.
    fn successors(&self, way: Way) -> BTreeSet<Way> {
        let mut found = BTreeSet::new();
        let Some(lanelet) = self.lanelets.get(way.lanelet as usize) else { return found };
        let beyond =
            if way.forward { lanelet.piece.checked_add(1) } else { lanelet.piece.checked_sub(1) };
        let (lane, forward) = (lanelet.lane, way.forward);
        let Some(stretch) = self.stretches.all.get(lanelet.stretch as usize) else { return found };
        let Some((from, to)) = stretch.piece(lanelet.piece) else { return found };
        let Some(node) = lane.node_at(0.5 * (from + to), forward) else { return found };
        let span = self.stretches.span(&node);
        if let Some(beyond) =
            beyond.filter(|at| span.is_some_and(|span| (span.cuts[0]..span.cuts[1]).contains(at)))
        {
            found.extend(self.number(&lane, beyond).map(|lanelet| Way { lanelet, forward }));
            return found;
        }
        let (mut open, mut seen) = (vec![node], HashSet::new());
        while let Some(node) = open.pop() {
            for target in node.edges().filter_map(|edge| edge.target()) {
                let Some(span) = self.stretches.span(&target) else { continue };
                if self.merged.get(span.stretch as usize) == Some(&true) {
                    if seen.insert(target.node_id()) {
                        open.push(target);
                    }
                    continue;
                }
                let piece =
                    if span.forward { span.cuts[0] } else { span.cuts[1].saturating_sub(1) };
                let lanelet = target.lane().and_then(|lane| self.number(&lane, piece));
                found.extend(lanelet.map(|lanelet| Way { lanelet, forward: span.forward }));
            }
        }
        found
    }

    /// Lists what is put together, and where what follows what is not as in the map.
    fn tell(&self, snapped: &[&Meeting<'a>], meetings: &[Meeting<'a>], report: &mut Report) {
        for meeting in snapped {
            let [place, _] = meeting.pairs.map(|(corner, _)| self.joints.place(corner));
            let entry = Entry::Snapped { distance: meeting.distance };
            report.add(entry, name(&meeting.from), name(&meeting.to), place);
        }
        let merged = self.stretches.all.iter().zip(&self.merged).filter(|(_, merged)| **merged);
        for (stretch, _) in merged {
            let lane = stretch.lanes.iter().find(|lane| lane.number() != 0);
            let Some(lane) = lane else { continue };
            let entry = Entry::Merged { length: stretch.length() };
            report.add(
                entry,
                lane.key().to_string(),
                String::new(),
                self.joints.place(stretch.corner(0, 0)),
            );
        }
        for (stretch, lane) in self.narrow() {
            let place = self.joints.place(stretch.corner(0, 0));
            report.add(Entry::Narrow, lane.key().to_string(), String::new(), place);
        }
        let distances: HashMap<_, _> = meetings
            .iter()
            .map(|one| ((one.from.node_id(), one.to.node_id()), one.distance))
            .collect();
        let knots = self.knots();
        for way in self.ways() {
            let expected = self.successors(way);
            let end = self.points(way, true);
            let there = end.and_then(|end| knots.get(&end)).map_or(&[][..], |knot| &knot.starts);
            let there: BTreeSet<Way> = there.iter().copied().collect();
            for lost in expected.difference(&there) {
                let ends = [way, *lost].map(|way| self.node(way).map(|node| node.node_id()));
                let distance = match ends {
                    [Some(from), Some(to)] => distances.get(&(from, to)).copied(),
                    _ => None,
                };
                self.tell_of(Entry::Lost { distance }, way, *lost, report);
            }
            for extra in there.difference(&expected).filter(|extra| self.share(way, **extra)) {
                self.tell_of(Entry::Extra, way, *extra, report);
            }
        }
    }

    /// Lanes that somebody may use, and of which a piece is too narrow for a lanelet.
    fn narrow(&self) -> impl Iterator<Item = (&Stretch<'a>, &Lane<'a>)> {
        self.kept().flat_map(move |(_, stretch)| {
            let is_narrow = |lane: &&Lane<'a>| {
                let span = lane.nodes().find_map(|node| self.stretches.span(&node));
                span.is_some_and(|span| {
                    (span.cuts[0]..span.cuts[1]).any(|at| !is_wide(lane, stretch, at))
                })
            };
            stretch
                .lanes
                .iter()
                .filter(|lane| lane.number() != 0)
                .filter(is_narrow)
                .map(move |lane| (stretch, lane))
        })
    }

    fn tell_of(&self, entry: Entry, from: Way, to: Way, report: &mut Report) {
        let text = |way: Way| self.node(way).map_or_else(String::new, |node| name(&node));
        let place = self.points(from, true).map_or(DVec3::NAN, |[left, _]| self.joints.place(left));
        report.add(entry, text(from), text(to), place);
    }

    /// Whether somebody may use both ways.
    fn share(&self, a: Way, b: Way) -> bool {
        let (Some(a), Some(b)) = (self.node(a), self.node(b)) else { return false };
        VehicleClass::ALL.iter().any(|class| a.allows(*class) && b.allows(*class))
    }

    /// The node of the lane graph that a way is a part of.
    fn node(&self, way: Way) -> Option<LaneNode<'a>> {
        let lanelet = self.lanelets.get(way.lanelet as usize)?;
        let (from, to) = self.stretches.all.get(lanelet.stretch as usize)?.piece(lanelet.piece)?;
        lanelet.lane.node_at(0.5 * (from + to), way.forward)
    }
}

/// Whether a lane is anywhere along a piece as wide as a lanelet has to be.
pub(super) fn is_wide(lane: &Lane<'_>, stretch: &Stretch<'_>, piece: u32) -> bool {
    let Some((from, to)) = stretch.piece(piece) else { return false };
    let steps = (0..=WIDTHS).map(|step| from + (to - from) * f64::from(step) / f64::from(WIDTHS));
    let places = steps.chain(lane.shape_breaks().filter(|s| (from..=to).contains(s)));
    places.map(|s| lane.width_at(s)).any(|width| width >= NARROWEST)
}

/// Key of the lane of a node.
fn name(node: &LaneNode<'_>) -> String {
    node.lane().map_or_else(String::new, |lane| lane.key().to_string())
}

/// Where nodes that somebody may use follow each other, the nearest ends first.
fn meetings<'a>(map: Map<'a>, stretches: &Stretches<'a>) -> Vec<Meeting<'a>> {
    let mut meetings = Vec::new();
    for from in map.lane_nodes() {
        let Some(ends) = stretches.span(&from).and_then(|span| stretches.ends(&span, true)) else {
            continue;
        };
        for to in from.edges().filter_map(|edge| edge.target()) {
            let span = stretches.span(&to);
            let Some(starts) = span.and_then(|span| stretches.ends(&span, false)) else { continue };
            let pairs = [(ends[0], starts[0]), (ends[1], starts[1])];
            let corner = |corner: u32| stretches.corners.get(corner as usize).copied();
            let apart = pairs.map(|(a, b)| match (corner(a), corner(b)) {
                (Some(a), Some(b)) => a.distance(b),
                _ => f64::INFINITY,
            });
            meetings.push(Meeting { from, to, pairs, distance: apart[0].max(apart[1]) });
        }
    }
    meetings.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    meetings
}
