//! Where other traffic meets a path.

use super::overlaps::Looks;
use super::{Path, Piece};
use crate::extents::SRange;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::rules::{Basis, by_rules};
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

    fn known(relation: Relation) -> Self {
        match relation {
            Relation::Yields => Self::Yields,
            Relation::Priority => Self::Priority,
            Relation::Lights => Self::Lights,
            _ => Self::Unknown,
        }
    }
}

/// A place where the traffic of another lane meets a path.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathConflict {
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

impl PathConflict {
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

impl Path<'_, '_> {
    /// Where other lanes meet the path, in ascending S: those of junctions that the map knows to conflict; lanes that lead into the path's own from
    /// elsewhere, and lanes beside it that end and have to be left for it ([`ConflictKind::Merge`]); and lanes of other roads in whose area the
    /// driven line lies on the same level ([`ConflictKind::Overlap`], looked for every 2 m, over thousands of kilometres only in part). Outside junctions, stop, give-way and priority signs up to 30 m before say
    /// who goes first. Left out are lanes that are closed to every
    /// vehicle outside junctions, and what is the path's own way: a stretch of another lane that the path drives just before or behind the common place.
    /// Others may come to it where the stretch begins before the path is on that lane, or where the path drives the lane at another time: such places
    /// are told. Steps that go on on the same lane count as one. `out` is emptied first; it grows only if its capacity is too small. What people on foot and
    /// bicycles cross on is [`Path::crossings`].
    pub fn conflicts(&self, out: &mut Vec<PathConflict>) {
        out.clear();
        let (mut next, mut looks) = (0, Looks::of(self.buffer.spans.len()));
        while let Some((piece, end)) = self.run(next) {
            let first = std::mem::replace(&mut next, end);
            let Some(lane) = Lane::new(self.map, piece.lane) else { continue };
            let stop = lane.movement_stop();
            for conflict in lane.conflicts() {
                let Some(other) = conflict.other() else { continue };
                let Some(along) = self.common(&piece, conflict.s_range()) else { continue };
                let SRange { low: from, high: to } = conflict.other_range();
                if self.is_own_way(first, along, other.row_number(), [from, to]) {
                    continue;
                }
                let line = stop.and_then(|line| self.along_before(line.lane, line.s, along[0]));
                let (relation, reason) = (conflict.stored_relation(), conflict.reason());
                out.push(PathConflict {
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
                self.settle(end - 1, own);
            }
        }
        // Sorting in place allocates nothing.
        out.sort_unstable_by(|a, b| {
            a.along[0].total_cmp(&b.along[0]).then(a.other.row().cmp(&b.other.row()))
        });
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
