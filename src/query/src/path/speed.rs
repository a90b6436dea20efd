//! Speed limits along a path.

use super::{Path, Piece};
use crate::lane::Lane;
use crate::rules::{SpeedOrigin, SpeedRule, SpeedSigns, Zone, is_of_speed};

/// A stretch of a path on which one speed limit holds.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PathSpeed {
    /// S of its beginning and end `[m]`.
    pub along: [f64; 2],
    /// What holds there.
    pub rule: SpeedRule,
}

/// A limit, and the S from which on it is to be looked up again.
#[derive(Clone, Copy)]
pub(super) struct Limit {
    pub(super) rule: SpeedRule,
    pub(super) until: f64,
}

impl Limit {
    /// Nothing is looked up yet.
    pub(super) const NONE: Self = Self { rule: NOTHING, until: f64::NEG_INFINITY };
}

/// Nothing is known.
const NOTHING: SpeedRule = SpeedRule { max: None, origin: SpeedOrigin::None, signal: None };
/// S of a record and s of a place may differ by rounding `[m]`.
const ROUNDING: f64 = 1e-6;

impl<'a> Path<'a, '_> {
    /// The speed limit at S, which is moved to the path's nearer end where it lies outside. What came in with the vehicle is known: in a
    /// junction where nothing else is written the limit where the path enters it, and the zone that it has driven into. None for an
    /// S that is not finite.
    pub fn speed_at(&self, along: f64) -> Option<SpeedRule> {
        if !along.is_finite() {
            return None;
        }
        let span = self.span_at(mapd_geometry::clamp(along, 0.0, self.length()))?;
        let s = span.s_at(mapd_geometry::clamp(along - span.along, 0.0, span.length));
        self.rule_on(span.piece as usize, s)
    }

    /// The speed limits along the path, in ascending S without gaps. `out` is emptied first; it grows only if its capacity is too
    /// small.
    pub fn speeds(&self, out: &mut Vec<PathSpeed>) {
        out.clear();
        for (number, piece) in self.buffer.pieces.iter().enumerate() {
            let Some(lane) = Lane::new(self.map, piece.lane) else { continue };
            let first = out.len();
            let [begin, end] = self.ends_of(piece);
            let mut cut = |along: f64| {
                out.push(PathSpeed { along: [along, end], rule: NOTHING });
            };
            cut(begin);
            for s in breaks(&lane) {
                if let Some(along) = self.along_on(piece, s).filter(|s| *s > begin && *s < end) {
                    cut(along);
                }
            }
            let own = out.get_mut(first..).unwrap_or(&mut []);
            own.sort_unstable_by(|a, b| a.along[0].total_cmp(&b.along[0]));
            for i in first..out.len() {
                let until = out.get(i + 1).map_or(end, |next| next.along[0]);
                let Some(own) = out.get_mut(i) else { continue };
                own.along[1] = until;
                let middle = 0.5 * (own.along[0] + until);
                let span = self.spans_of(piece).iter().rfind(|span| span.along <= middle);
                let s = span.map(|span| span.s_at(middle - span.along));
                if let Some(rule) = s.and_then(|s| self.rule_on(number, s)) {
                    own.rule = rule;
                }
            }
        }
        out.dedup_by(|next, before| {
            let same = next.rule == before.rule || next.along[0] == next.along[1];
            if same {
                before.along[1] = next.along[1];
            }
            same
        });
    }

    /// The limit at S, which is s on a piece, and how long nothing on the piece can change it.
    pub(super) fn limit_from(&self, number: usize, along: f64, s: f64) -> Limit {
        let piece = self.buffer.pieces.get(number);
        let (Some(piece), Some(lane)) = (piece, self.lane_of(number)) else { return Limit::NONE };
        let rule = self.rule_on(number, s).unwrap_or(NOTHING);
        let next = breaks(&lane).filter_map(|s| self.along_on(piece, s));
        let next = next.filter(|next| next + ROUNDING > along);
        Limit { rule, until: next.fold(self.ends_of(piece)[1], f64::min) }
    }

    /// The limit at s on a piece, by the way that the path has come.
    fn rule_on(&self, number: usize, s: f64) -> Option<SpeedRule> {
        let lane = self.lane_of(number)?;
        let rule = lane.speed_rule_at(s);
        if !matches!(rule.origin, SpeedOrigin::Entry | SpeedOrigin::Depends) {
            return Some(rule);
        }
        let signs = self.signs_at_entry(number, &lane);
        if let Some(own) = lane.speed_with(signs, s) {
            return Some(own);
        }
        // No sign holds that the path has passed: what remains is what comes with it into a junction.
        let Some(junction) = lane.road().junction_row() else { return Some(lane.default_speed(s)) };
        for before in (0..number).rev() {
            let from = self.lane_of(before)?;
            let end = self.spans_of(self.buffer.pieces.get(before)?).last()?.s[1];
            let signs = self.signs_at_entry(before, &from);
            let inside = from.road().junction_row() == Some(junction);
            match from.speed_with(signs, end) {
                Some(own) if own.origin == SpeedOrigin::Depends => return Some(own),
                Some(own) => return Some(SpeedRule { origin: SpeedOrigin::Entry, ..own }),
                None if inside => {}
                None => return Some(lane.default_speed(s)),
            }
        }
        Some(rule)
    }

    /// The signs that hold where a piece's lane is entered, by the way that the path has come.
    fn signs_at_entry(&self, number: usize, lane: &Lane<'a>) -> SpeedSigns<'a> {
        let own = lane.speed_signs_at_entry();
        if !matches!(own.zone, Zone::Depends) {
            return own;
        }
        // Back to the last lane that does not depend on the way to it, and from there on again.
        let knows = |number: &usize| {
            self.lane_of(*number).is_some_and(|lane| {
                let at_entry = lane.speed_signs_at_entry();
                !matches!(lane.speed_signs_after(at_entry, None).zone, Zone::Depends)
            })
        };
        let Some(first) = (0..number).rev().find(knows) else { return own };
        let zone = self.lane_of(first).map_or(Zone::None, |lane| {
            lane.speed_signs_after(lane.speed_signs_at_entry(), None).zone
        });
        // On the lanes between no sign says anything of zones: they would know.
        SpeedSigns { zone, ..own }
    }

    fn lane_of(&self, number: usize) -> Option<Lane<'a>> {
        Lane::new(self.map, self.buffer.pieces.get(number)?.lane)
    }

    /// S at a piece's beginning and end.
    pub(super) fn ends_of(&self, piece: &Piece) -> [f64; 2] {
        let spans = self.spans_of(piece);
        [spans.first().map_or(0.0, |span| span.along), spans.last().map_or(0.0, |span| span.end())]
    }

    /// S of a place on a piece; none where it is not driven over.
    pub(super) fn along_on(&self, piece: &Piece, s: f64) -> Option<f64> {
        self.spans_of(piece).iter().find_map(|span| span.along_at(s))
    }
}

/// Every s at which the limit on a lane may change.
fn breaks(lane: &Lane<'_>) -> impl Iterator<Item = f64> {
    let signs = lane.signals().filter(is_of_speed).map(|one| one.s_on(lane));
    let records = lane.speeds().map(|record| record.s);
    signs.chain(records).chain(lane.road().types().map(|record| record.s))
}
