//! Where other traffic meets a path.

use super::meets::TOUCHES;
use super::overlaps::{Looks, STEP};
use super::{Path, Piece};
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::map::Map;
use crate::rules::{Basis, by_rules, right_of_way};
use crate::view::View;
use mapd_archive::{ConflictKind, Relation, RelationReason, RoadRules};

/// Who goes first.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum Yields {
    /// The vehicle on the path gives way.
    Yields,
    /// The other gives way.
    Priority,
    /// Lights decide.
    Lights,
    /// The file does not say. A rule of the road may, which differs between countries and kinds of roads: the reason names it.
    Unknown,
}

impl Yields {
    /// `yields`, `priority`, `lights` or `unknown`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Yields => "yields",
            Self::Priority => "priority",
            Self::Lights => "lights",
            Self::Unknown => "unknown",
        }
    }

    pub(super) fn of(relation: Relation, reason: RelationReason) -> Self {
        match relation {
            _ if Basis::of(reason) == Basis::Rule => Self::Unknown,
            relation => Self::known(relation),
        }
    }

    /// The larger one decides where several lanes meet a path at one place: who yields to one of them yields.
    fn weight(self) -> u8 {
        match self {
            Self::Priority => 0,
            Self::Lights => 1,
            Self::Unknown => 2,
            Self::Yields => 3,
        }
    }

    fn known(relation: Relation) -> Self {
        match relation {
            Relation::Yields => Self::Yields,
            Relation::Priority => Self::Priority,
            Relation::Lights => Self::Lights,
            _ => Self::Unknown,
        }
    }
}

/// A place where the traffic of other lanes meets a path: of one lane, or of several that lead into each other.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathConflict {
    /// S of the first and last common place `[m]`, as of [`ConflictLane::along`].
    pub along: [f64; 2],
    /// The other lane, of several the one that meets the path first.
    pub other: LaneId,
    /// Both ends of the common place on its road `[m]`, the smaller s first.
    pub other_s: [f64; 2],
    /// Numbers of its lanes in the list of lanes: of the first, and of the one behind the last. [`PathConflict::lanes_of`] takes them out.
    pub lanes: [u32; 2],
    /// How they meet: [`ConflictKind::Merge`] where one merges, else [`ConflictKind::Cross`] where one crosses.
    pub kind: ConflictKind,
    /// Who goes first, by what the file says: [`Yields::Yields`] where the path yields to one lane, else [`Yields::Unknown`] where it does not say of one, else
    /// [`Yields::Lights`] where they decide about one.
    pub yields: Yields,
    /// Why: of the first lane of which that is said.
    pub reason: RelationReason,
    /// S at which to wait `[m]`: the earliest of its lanes.
    pub wait: f64,
}

/// A lane whose traffic meets a path.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ConflictLane {
    /// S of the first and last common place `[m]`; too long by up to half a metre at either end, outside junctions too short or too long by up to
    /// two. A merge ends where the other lane leads into the path's own, or the lane beside it ends.
    pub along: [f64; 2],
    /// The other lane.
    pub other: LaneId,
    /// Both ends of the common place on its road `[m]`, the smaller s first.
    pub other_s: [f64; 2],
    /// How the two meet.
    pub kind: ConflictKind,
    /// Who goes first, by what the file says.
    pub yields: Yields,
    /// Why; what a rule of the road would say where `yields` is [`Yields::Unknown`].
    pub reason: RelationReason,
    /// Who goes first in the map's own terms: as `yields`, and where a rule of the road would have to say, what right-before-left and the
    /// rule of turns say; [`Relation::Unknown`] where nothing decides.
    pub relation: Relation,
    /// Whether both come by equal roads, as far as the file says (of one type, with one speed limit, and no motorway), and neither joins a road on
    /// which the other goes straight on, as a ramp does. The rule of the side holds among such alone.
    pub equal_roads: bool,
    /// S at which to wait `[m]`: the line to stop at on the path, outside junctions up to 30 m before, else the last place before the common
    /// one.
    pub wait: f64,
}

/// Who goes first at a conflict, and what says so.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct YieldsBy {
    /// Who goes first.
    pub yields: Yields,
    /// What that rests on.
    pub basis: Basis,
}

impl YieldsBy {
    /// Who goes first at a conflict with these lanes, by what the file says, else by a country's rules; [`Yields::Unknown`] without lanes.
    pub fn of(lanes: impl Iterator<Item = ConflictLane>, rules: &RoadRules) -> Self {
        let each = lanes.map(|lane| lane.yields_by(rules));
        let none = Self { yields: Yields::Unknown, basis: Basis::Unknown };
        first_of_most(each, |one| one.yields.weight()).unwrap_or(none)
    }
}

impl PathConflict {
    /// Its lanes, of all that [`Path::conflicts`] has listed, in ascending S.
    pub fn lanes_of<'l>(&self, lanes: &'l [ConflictLane]) -> &'l [ConflictLane] {
        let [first, end] = self.lanes.map(|number| number as usize);
        lanes.get(first..end).unwrap_or(&[])
    }

    /// What `yields` rests on: [`Basis::Written`] or [`Basis::Unknown`].
    pub fn basis(&self) -> Basis {
        Basis::without_rules(self.reason)
    }

    /// Who goes first by what the file says, else by a country's rules ([`RoadRules::of`]), and what that rests on: of its lanes, as
    /// [`PathConflict::yields`]. `lanes` is the whole list.
    pub fn yields_by(&self, lanes: &[ConflictLane], rules: &RoadRules) -> YieldsBy {
        YieldsBy::of(self.lanes_of(lanes).iter().copied(), rules)
    }

    /// One of lanes that meet a path together, whose numbers are given.
    fn of(own: &[ConflictLane], numbers: [u32; 2]) -> Option<Self> {
        let first = own.first()?;
        let decides = first_of_most(own.iter(), |one| one.yields.weight())?;
        let all = |of: fn(&ConflictLane) -> f64, which: fn(f64, f64) -> f64| {
            own.iter().map(of).fold(of(first), which)
        };
        Some(Self {
            along: [first.along[0], all(|one| one.along[1], f64::max)],
            other: first.other,
            other_s: first.other_s,
            lanes: numbers,
            kind: first_of_most(own.iter(), |one| weight_of(one.kind))?.kind,
            yields: decides.yields,
            reason: decides.reason,
            wait: all(|one| one.wait, f64::min),
        })
    }
}

/// The larger one counts where several lanes meet a path at one place.
fn weight_of(kind: ConflictKind) -> u8 {
    match kind {
        ConflictKind::Merge => 2,
        ConflictKind::Cross => 1,
        _ => 0,
    }
}

/// Of those with the largest weight the first.
fn first_of_most<T>(all: impl Iterator<Item = T>, weight: impl Fn(&T) -> u8) -> Option<T> {
    all.reduce(|before, next| if weight(&next) > weight(&before) { next } else { before })
}

impl ConflictLane {
    /// What `yields` rests on: [`Basis::Written`] or [`Basis::Unknown`].
    pub fn basis(&self) -> Basis {
        Basis::without_rules(self.reason)
    }

    /// Who goes first by what the file says, else by a country's rules ([`RoadRules::of`]), and what that rests on.
    pub fn yields_by(&self, rules: &RoadRules) -> YieldsBy {
        let (yields, basis) = match Basis::of(self.reason) {
            Basis::Rule => match by_rules(rules, self.relation, self.reason, self.equal_roads) {
                Some(relation) => (Yields::known(relation), Basis::Rule),
                None => (Yields::Unknown, Basis::Unknown),
            },
            basis => (self.yields, basis),
        };
        YieldsBy { yields, basis }
    }
}

/// In ascending S. Sorting in place allocates nothing.
fn sort(lanes: &mut [ConflictLane]) {
    lanes.sort_unstable_by(|a, b| {
        let by_s = a.along[0].total_cmp(&b.along[0]);
        by_s.then(a.other.row().cmp(&b.other.row())).then(a.along[1].total_cmp(&b.along[1]))
    });
}

/// Nodes that are looked at between two lanes, at most: some maps have a few of a centimetre.
const MOST_BETWEEN: usize = 32;

/// Whether a lane leads into another, in either of its directions or in one, within so far `[m]` of what both have in common with a path.
pub(super) fn leads(
    map: Map<'_>,
    from: &ConflictLane,
    to: &ConflictLane,
    forward: Option<bool>,
    reach: f64,
) -> bool {
    let Ok(lane) = map.lane(from.other) else { return false };
    let mut looks = MOST_BETWEEN;
    lane.nodes().any(|node| {
        let left = reach - apart(from.other_s, [ends(&node)[1]; 2]).max(0.0);
        left >= 0.0 && goes_on(&node, to, forward, left, &mut looks)
    })
}

/// Whether a node leads to where a lane meets a path, within so far `[m]`.
fn goes_on(
    node: &LaneNode<'_>,
    to: &ConflictLane,
    forward: Option<bool>,
    left: f64,
    looks: &mut usize,
) -> bool {
    node.edges().filter_map(|edge| edge.target()).any(|next| {
        let [entry, exit] = ends(&next);
        if next.row.lane() == to.other.row() {
            let is_it = forward.is_none_or(|forward| next.is_forward() == forward);
            return is_it && apart(to.other_s, [entry; 2]) <= left;
        }
        let left = left - (exit - entry).abs();
        if *looks == 0 || left < 0.0 {
            return false;
        }
        *looks -= 1;
        goes_on(&next, to, forward, left, looks)
    })
}

/// s at which a node is entered, and left `[m]`.
fn ends(node: &LaneNode<'_>) -> [f64; 2] {
    let SRange { low, high } = node.s_range();
    if node.is_forward() { [low, high] } else { [high, low] }
}

/// How far two stretches are apart `[m]`, the smaller end of each first; below 0 where they overlap.
fn apart([a_low, a_high]: [f64; 2], [b_low, b_high]: [f64; 2]) -> f64 {
    (b_low - a_high).max(a_low - b_high)
}

impl<'a> Path<'a, '_> {
    /// Where other lanes meet the path, in ascending S: those of junctions that the map knows to conflict; lanes that lead into the path's own from
    /// elsewhere, and lanes beside it that end and have to be left for it ([`ConflictKind::Merge`]); and lanes of other roads in whose area the
    /// driven line lies on the same level ([`ConflictKind::Overlap`], looked for every 2 m, over thousands of kilometres only in part). Outside junctions, stop, give-way and priority signs up to 30 m before say
    /// who goes first. Left out are lanes that are closed to every
    /// vehicle outside junctions, and what is the path's own way: a stretch of another lane that the path drives just before or behind the common place.
    /// Others may come to it where the stretch begins before the path is on that lane, or where the path drives the lane at another time: such places
    /// are told. Steps that go on on the same lane count as one. Lanes that lead into each other are one conflict where what they have in common with the path
    /// touches, on the path and on them; `lanes` lists them all, those of a conflict behind each other. Both lists are emptied first; they grow only if their capacity is
    /// too small. What people on foot and bicycles cross on is [`Path::crossings`].
    pub fn conflicts(&self, out: &mut Vec<PathConflict>, lanes: &mut Vec<ConflictLane>) {
        self.conflicts_in(None, out, lanes);
    }

    /// As [`Path::conflicts`], with the lights that work in a view.
    pub(crate) fn conflicts_in(
        &self,
        view: Option<View<'a>>,
        out: &mut Vec<PathConflict>,
        lanes: &mut Vec<ConflictLane>,
    ) {
        self.meeting_lanes(view, lanes);
        self.group(lanes, out);
    }

    /// The lanes that meet the path, in ascending S.
    fn meeting_lanes(&self, view: Option<View<'a>>, out: &mut Vec<ConflictLane>) {
        let view = view.filter(View::has_signals_out);
        out.clear();
        let (mut next, mut looks) = (0, Looks::of(self.buffer.spans.len()));
        while let Some((piece, end)) = self.run(next) {
            let first = std::mem::replace(&mut next, end);
            let Some(lane) = Lane::new(self.map, piece.lane) else { continue };
            let works = |signal| view.is_none_or(|view| view.is_in_service(signal));
            let stop = lane.movement_stop_where(works);
            for conflict in lane.conflicts() {
                let Some(other) = conflict.other() else { continue };
                let Some(along) = self.common(&piece, conflict.s_range()) else { continue };
                let SRange { low: from, high: to } = conflict.other_range();
                if self.is_own_way(first, along, other.row_number(), [from, to]) {
                    continue;
                }
                let line = stop.and_then(|line| self.along_before(line.lane, line.s, along[0]));
                let is_decided = view.is_some() && conflict.has_relation();
                let today = || right_of_way::without_lights(&lane, &other, works);
                let today = if is_decided { today() } else { None };
                let stored = (conflict.stored_relation(), conflict.reason());
                let (relation, reason) = today.unwrap_or(stored);
                // Nothing decides: of what is not known, only directions tell it apart.
                let relation =
                    if relation == Relation::Open { Relation::Unknown } else { relation };
                out.push(ConflictLane {
                    along,
                    other: other.lane_id(),
                    other_s: [from, to],
                    kind: conflict.kind(),
                    yields: Yields::of(relation, reason),
                    reason,
                    relation,
                    equal_roads: lane.comes_by_equal_road(&other),
                    wait: line.unwrap_or(along[0]),
                });
            }
            let told = out.len();
            self.merges(first, &piece, &lane, out);
            self.overlaps(first, &piece, &lane, &mut looks, out);
            for own in out.get_mut(told..).unwrap_or(&mut []) {
                self.settle(end - 1, view, own);
            }
        }
        sort(out);
    }

    /// Brings lanes that meet the path together beside each other, and makes each such group one conflict.
    fn group(&self, lanes: &mut [ConflictLane], out: &mut Vec<PathConflict>) {
        out.clear();
        let (mut first, mut looks) = (0, Looks::of(lanes.len()));
        while let Some(begin) = lanes.get(first) {
            // All of the group but those from `next` on have been compared with the rest, which stays sorted.
            let (mut next, mut end, mut last) = (first, first + 1, begin.along[1]);
            while next < end {
                let mut at = end;
                while let (Some(own), Some(other)) = (lanes.get(next).copied(), lanes.get(at)) {
                    if other.along[0] > last + TOUCHES || !looks.take() {
                        break;
                    }
                    if self.is_one(&own, other) {
                        last = last.max(other.along[1]);
                        lanes.get_mut(end..=at).unwrap_or(&mut []).rotate_right(1);
                        end += 1;
                    }
                    at += 1;
                }
                next += 1;
            }
            let group = lanes.get_mut(first..end).unwrap_or(&mut []);
            sort(group);
            out.extend(PathConflict::of(group, [first as u32, end as u32]));
            first = end;
        }
    }

    /// Whether two lanes that meet the path are one, or one leads into the other, and what they have in common with the path touches on both sides.
    fn is_one(&self, a: &ConflictLane, b: &ConflictLane) -> bool {
        if apart(a.along, b.along) > TOUCHES {
            return false;
        }
        let is_looked_for = [a.kind, b.kind].contains(&ConflictKind::Overlap);
        let reach = if is_looked_for { STEP } else { TOUCHES };
        match a.other == b.other {
            true => apart(a.other_s, b.other_s) <= reach,
            false => {
                [(a, b), (b, a)].iter().any(|(from, to)| leads(self.map, from, to, None, reach))
            }
        }
    }

    /// The piece of a number as one with those behind it that go on where it ends, and the number behind them: a route's places on the way cut a lane.
    fn run(&self, number: usize) -> Option<(Piece, usize)> {
        let mut whole = *self.buffer.pieces.get(number)?;
        let mut end = number + 1;
        while let Some(next) = self.buffer.pieces.get(end) {
            let exit = self.spans_of(&whole).last().map(|span| span.s[1]);
            let entry = self.spans_of(next).first().map(|span| span.s[0]);
            if (next.lane, next.forward) != (whole.lane, whole.forward) || entry != exit {
                break;
            }
            whole.spans[1] = next.spans[1];
            end += 1;
        }
        Some((whole, end))
    }

    /// S at both ends of what a piece shares with another lane; none where that is not driven over.
    pub(super) fn common(&self, piece: &Piece, range: SRange) -> Option<[f64; 2]> {
        let SRange { low, high } = range;
        let spans = self.spans_of(piece);
        let meets = |span: &&super::Span| {
            let [a, b] = span.s;
            a.min(b) <= high && a.max(b) >= low
        };
        let first = spans.iter().find(meets)?;
        let last = spans.iter().rfind(meets)?;
        let [from, to] = if piece.forward { [low, high] } else { [high, low] };
        let inside = |span: &super::Span, s: f64| {
            let [a, b] = span.s;
            span.along_at(mapd_geometry::clamp(s, a.min(b), a.max(b)))
        };
        Some([inside(first, from)?, inside(last, to)?])
    }

    /// The largest S of a place on a lane that is not beyond a limit.
    fn along_before(&self, lane: LaneId, s: f64, limit: f64) -> Option<f64> {
        let own = self.buffer.pieces.iter().filter(|piece| piece.lane == lane.row());
        let all = own.flat_map(|piece| self.spans_of(piece).iter().find_map(|p| p.along_at(s)));
        all.filter(|along| *along <= limit).max_by(f64::total_cmp)
    }
}
