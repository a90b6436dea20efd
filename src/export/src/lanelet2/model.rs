//! What is written: lanelets, lines of their own, rules.

use super::align::{Side, balance, clear_part, cut_loops, is_read_as_meant};
use super::network::{Lanelet, Network};
use super::report::{Entry, Report};
use super::tags::Tag;
use mapd_client::Map;
use mapd_client::glam::DVec3;
use mapd_client::rules::LaneLine;
use mapd_client::vocabulary::Class;
use std::collections::{HashMap, HashSet};

/// Points of a line that are nearer to each other are one `[m]`.
pub(super) const DISTINCT: f64 = 1e-3;

/// A line that no lanelet shares with another: across lanes, of a sign or light, of a crossing.
pub(super) struct OwnLine<'a> {
    /// Points that only this line has, in the map's frame `[m]`.
    pub(super) points: Vec<DVec3>,
    pub(super) tags: Vec<Tag<'a>>,
    pub(super) ends: Ends,
}

/// Where a line of its own begins and ends.
#[derive(Clone, Copy)]
pub(super) enum Ends {
    /// At its first and last point.
    Own,
    /// It ends at the point where it begins.
    Ring,
    /// At the points of two corners, which borders have, too.
    Corners([u32; 2]),
}

/// An area.
pub(super) struct Area<'a> {
    /// The lines around it, clockwise.
    pub(super) outer: Vec<Edge>,
    /// Those of the rings around its holes.
    pub(super) inner: Vec<usize>,
    pub(super) tags: Vec<Tag<'a>>,
}

/// A part of what is around an area.
#[derive(Clone, Copy)]
pub(super) enum Edge {
    /// Number of a line among the model's.
    Line(usize),
    /// A border of a lane, which a lanelet beside the area has, too.
    Border(BorderLine),
}

/// A lanelet across lanes, for those who cross.
pub(super) struct Crossing<'a> {
    /// Numbers of its borders among the model's lines.
    pub(super) left: usize,
    pub(super) right: usize,
    pub(super) tags: Vec<Tag<'a>>,
    /// The rule that makes traffic heed it.
    pub(super) rule: Option<usize>,
}

/// What a rule refers to, by its number in its list.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Member {
    Line(usize),
    Lanelet(u32),
    Crossing(usize),
}

/// A regulatory element.
pub(super) struct Rule<'a> {
    pub(super) tags: Vec<Tag<'a>>,
    /// With their roles.
    pub(super) members: Vec<(&'static str, Member)>,
    /// Lanelets on which it holds.
    pub(super) lanelets: Vec<u32>,
}

/// All that a file has.
pub(super) struct Model<'a> {
    map: Map<'a>,
    pub(super) network: Network<'a>,
    pub(super) lines: Vec<OwnLine<'a>>,
    pub(super) crossings: Vec<Crossing<'a>>,
    pub(super) rules: Vec<Rule<'a>>,
    pub(super) areas: Vec<Area<'a>>,
    /// By the corner at which a border begins: the part of its length that is to be its middle, where it matters.
    middles: HashMap<u32, f64>,
    /// Corners at which borders begin of which what crosses itself is cut out.
    cut: HashSet<u32>,
    /// By row of the lane and s: the number of the line across it.
    stop_lines: HashMap<(u32, u64), usize>,
}

/// A border along a piece.
#[derive(Clone, Copy)]
pub(super) struct BorderLine {
    pub(super) stretch: u32,
    pub(super) border: u32,
    pub(super) piece: u32,
}

/// Borders that lanelets and areas have, and their ends.
pub(super) struct Lines {
    pub(super) used: Vec<BorderLine>,
    /// Corners that stand for points, ascending.
    pub(super) points: Vec<u32>,
    /// By the corner at which a border begins: its number among `used`.
    borders: Vec<Option<u32>>,
}

impl<'a> Model<'a> {
    /// Lanelets alone.
    pub(super) fn new(map: Map<'a>, network: Network<'a>) -> Self {
        let (lines, crossings, rules, areas) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (middles, cut, stop_lines) = (HashMap::new(), HashSet::new(), HashMap::new());
        Self { map, network, lines, crossings, rules, areas, middles, cut, stop_lines }
    }

    /// Adds a line of its own and returns its number.
    pub(super) fn add_line(&mut self, points: Vec<DVec3>, tags: Vec<Tag<'a>>) -> usize {
        self.lines.push(OwnLine { points, tags, ends: Ends::Own });
        self.lines.len() - 1
    }

    /// Adds a line that ends where it begins, by its corners, and returns its number.
    pub(super) fn add_ring(&mut self, points: Vec<DVec3>, tags: Vec<Tag<'a>>) -> usize {
        self.lines.push(OwnLine { points, tags, ends: Ends::Ring });
        self.lines.len() - 1
    }

    /// Adds a straight line between the points of two corners, and returns its number.
    pub(super) fn add_chord(&mut self, corners: [u32; 2], tags: Vec<Tag<'a>>) -> usize {
        self.lines.push(OwnLine { points: Vec::new(), tags, ends: Ends::Corners(corners) });
        self.lines.len() - 1
    }

    /// The line across a lane at which its traffic stops or gives way, the same one for all that stop there.
    pub(super) fn stop_line(&mut self, line: &LaneLine) -> Option<usize> {
        let lane = self.map.lane(line.lane).ok()?;
        let key = (lane.lane_id().row(), line.s.to_bits());
        if let Some(number) = self.stop_lines.get(&key) {
            return Some(*number);
        }
        let points = lane.bounds_at(line.s)?.to_vec();
        let subtype = match line.class {
            Class::StopLine => "solid",
            Class::WaitingLine => "dashed",
            _ => "virtual",
        };
        let number =
            self.add_line(points, vec![("type", "stop_line".into()), ("subtype", subtype.into())]);
        self.stop_lines.insert(key, number);
        Some(number)
    }

    /// The line of a border in ascending s `[m]`. Points that a moved end came near to are left out, so that it does not turn back.
    pub(super) fn points(&self, line: &BorderLine) -> Vec<DVec3> {
        let mut points = self.unbalanced(line);
        if let Some(part) = self.corner(line).and_then(|corner| self.middles.get(&corner)) {
            balance(&mut points, *part);
        }
        points
    }

    /// As [`Model::points`], without those that are there to make another one the middle.
    fn unbalanced(&self, line: &BorderLine) -> Vec<DVec3> {
        let network = &self.network;
        let Some(stretch) = network.stretches.all.get(line.stretch as usize) else {
            return Vec::new();
        };
        let ends = [line.piece, line.piece + 1].map(|cut| {
            let corner = stretch.corner(line.border, cut);
            let own = network.stretches.corners.get(corner as usize).copied();
            let place = network.joints.place(corner);
            (place, 2.0 * place.distance(own.unwrap_or(place)))
        });
        let inner = stretch.inner_points(line.border, line.piece);
        let is_free = |point: &DVec3| ends.iter().all(|(end, reach)| point.distance(*end) > *reach);
        let [(first, _), (last, _)] = ends;
        let inner = inner.into_iter().filter(is_free);
        let mut points: Vec<DVec3> = [first].into_iter().chain(inner).chain([last]).collect();
        if self.cut.contains(&stretch.corner(line.border, line.piece)) {
            cut_loops(&mut points);
        }
        let is_last = |at: usize| at + 1 == points.len();
        let mut distinct: Vec<DVec3> = Vec::with_capacity(points.len());
        for (at, point) in points.iter().enumerate() {
            let is_free = |other: &DVec3| point.distance(*other) > DISTINCT;
            if at == 0 || is_last(at) || distinct.last().is_some_and(is_free) && is_free(&last) {
                distinct.push(*point);
            }
        }
        distinct
    }

    /// Finds the lanelets whose borders Lanelet2 would turn the wrong way round, and gives these another middle; where that does not
    /// help, it cuts out where a border crosses itself. The report says what is cut, and where nothing helps.
    pub(super) fn align(&mut self, report: &mut Report) {
        self.middles = self.new_middles();
        let wrong: Vec<BorderLine> = self.misread().flat_map(Lanelet::lines).collect();
        for line in wrong {
            let Some(corner) = self.corner(&line) else { continue };
            let distance = cut_loops(&mut self.points(&line));
            if let (Some(distance), true) = (distance, self.cut.insert(corner)) {
                let lane = self.network.stretches.all.get(line.stretch as usize);
                let lane = lane.and_then(|stretch| stretch.lanes.get(line.border as usize));
                let name = lane.map_or_else(String::new, |lane| lane.key().to_string());
                report.add(
                    Entry::Cut { distance },
                    name,
                    String::new(),
                    self.network.joints.place(corner),
                );
            }
        }
        let more = self.new_middles();
        self.middles.extend(more);
        for lanelet in self.misread() {
            let place = lanelet.lane.pose_at(lanelet.node.s_range().low, 0.0);
            let place = place.map_or(DVec3::NAN, |pose| pose.position);
            report.add(Entry::Turned, lanelet.lane.key().to_string(), String::new(), place);
        }
    }

    /// Lanelets of which Lanelet2 would turn a border the wrong way round.
    fn misread(&self) -> impl Iterator<Item = &Lanelet<'a>> {
        self.network.lanelets.iter().filter(|one| !self.is_read_as_meant(one))
    }

    /// Middles for the borders of such lanelets, where there are any that help, by the corner at which they begin.
    fn new_middles(&self) -> HashMap<u32, f64> {
        let mut found = HashMap::new();
        for lanelet in self.misread() {
            for line in lanelet.lines() {
                let part = clear_part(&self.unbalanced(&line), &self.others(lanelet, line.border));
                found.extend(self.corner(&line).zip(part));
            }
        }
        found
    }

    /// The corner at which a border's line begins.
    pub(super) fn corner(&self, line: &BorderLine) -> Option<u32> {
        let stretch = self.network.stretches.all.get(line.stretch as usize)?;
        Some(stretch.corner(line.border, line.piece))
    }

    /// The line of a border of the lanelet's stretch along its piece.
    fn line(&self, lanelet: &Lanelet<'_>, border: u32) -> Vec<DVec3> {
        self.points(&BorderLine { stretch: lanelet.stretch, border, piece: lanelet.piece })
    }

    /// The borders across the lanelets that share a border with this one, and the side of each on which they lie seen from it.
    fn others(&self, lanelet: &Lanelet<'_>, border: u32) -> Vec<(Side, Vec<DVec3>)> {
        let lanes = self.network.stretches.all.get(lanelet.stretch as usize);
        let lanes = lanes.map_or(&[][..], |stretch| &stretch.lanes);
        let numbers = lanes.iter().filter_map(|lane| self.network.number(lane, lanelet.piece));
        let sharing = numbers.filter_map(|number| self.network.lanelets.get(number as usize));
        let across = |one: &Lanelet<'_>| match one.borders {
            [left, right] if left == border => Some((Side::Right, right)),
            [left, right] if right == border => Some((Side::Left, left)),
            _ => None,
        };
        sharing.filter_map(across).map(|(side, other)| (side, self.line(lanelet, other))).collect()
    }

    fn is_read_as_meant(&self, lanelet: &Lanelet<'_>) -> bool {
        let [mut left, mut right] = lanelet.borders.map(|border| self.line(lanelet, border));
        let is_forward = lanelet.lane.is_forward();
        if !is_forward {
            (left, right) = (right, left);
            left.reverse();
            right.reverse();
        }
        is_read_as_meant(&left, &right, is_forward)
    }

    /// Numbers of the rules that hold on each lanelet.
    pub(super) fn rules_of_lanelets(&self) -> Vec<Vec<usize>> {
        let mut rules = vec![Vec::new(); self.network.lanelets.len()];
        for (number, rule) in self.rules.iter().enumerate() {
            for lanelet in &rule.lanelets {
                if let Some(own) =
                    rules.get_mut(*lanelet as usize).filter(|own| !own.contains(&number))
                {
                    own.push(number);
                }
            }
        }
        rules
    }
}

impl Lanelet<'_> {
    /// The lines of both borders.
    fn lines(&self) -> [BorderLine; 2] {
        let (stretch, piece) = (self.stretch, self.piece);
        self.borders.map(|border| BorderLine { stretch, border, piece })
    }
}

impl Lines {
    pub(super) fn of(model: &Model<'_>) -> Self {
        let network = &model.network;
        let corners = network.stretches.corners.len();
        let (mut borders, mut is_point) = (vec![None; corners], vec![false; corners]);
        let mut used = Vec::new();
        let of_areas =
            model.areas.iter().flat_map(|area| &area.outer).filter_map(|edge| match edge {
                Edge::Border(line) => Some(*line),
                Edge::Line(_) => None,
            });
        for line in network.lanelets.iter().flat_map(Lanelet::lines).chain(of_areas) {
            let Some(corner) = model.corner(&line) else { continue };
            if let Some(number @ None) = borders.get_mut(corner as usize) {
                *number = Some(used.len() as u32);
                used.push(line);
            }
            for end in [corner, corner + 1] {
                if let Some(is_point) = is_point.get_mut(network.joints.point(end) as usize) {
                    *is_point = true;
                }
            }
        }
        let points = (0..).zip(is_point).filter(|(_, is)| *is).map(|(corner, _)| corner).collect();
        Self { used, points, borders }
    }

    /// Number of the border that begins at a corner.
    pub(super) fn number_of_border(&self, corner: u32) -> Option<u64> {
        self.borders.get(corner as usize).copied().flatten().map(u64::from)
    }

    /// Number of the point that a corner stands for.
    pub(super) fn number_of_point(&self, corner: u32) -> Option<u64> {
        self.points.binary_search(&corner).ok().map(|at| at as u64)
    }
}
