//! Speed limits along a path.

use super::{Path, PathBuffer, PathError, Piece, Span};
use crate::lane::Lane;
use crate::map::Map;
use crate::rules::{Carried, Limits, NOTHING, SpeedRule, SpeedSigns, Zone};
use mapd_archive::NONE;

/// A stretch of a path on which one speed limit holds.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathSpeed {
    /// S of its beginning and end `[m]`.
    pub along: [f64; 2],
    /// What holds there.
    pub rule: SpeedRule,
}

/// How long a path or a part of it takes at the speed limits.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathTime {
    /// Time where a limit is known and above 0 `[s]`.
    pub time: f64,
    /// Length of the rest, where no limit is known or there is none `[m]`: its time is the caller's to say.
    pub unlimited: f64,
}

impl PathTime {
    /// Adds a stretch and the limit on it.
    pub(crate) fn add(&mut self, [begin, end]: [f64; 2], max: Option<f64>) {
        match max.filter(|max| *max > 0.0 && max.is_finite()) {
            Some(max) => self.time += (end - begin) / max,
            None => self.unlimited += end - begin,
        }
    }
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

/// S of a record and s of a place may differ by rounding `[m]`.
const ROUNDING: f64 = 1e-6;

/// Pieces before one that say which speed limit holds on it, noted once so that no answer looks back over the path.
#[derive(Clone, Copy)]
pub(super) struct Way {
    /// The last piece whose lane knows which zone its traffic leaves it in; none where the own lane knows, and where no piece does.
    zone: u32,
    /// For a piece in a junction the last one before on which a limit is stated, or that before the junction, or the path's first; none for that itself.
    entry: u32,
}

impl Way {
    /// Nothing before says anything.
    pub(super) const NONE: Self = Self { zone: NONE, entry: NONE };
}

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
        self.each_limit([0.0, self.length()], |_, along, rule| match out.last_mut() {
            Some(before) if before.rule == rule => before.along[1] = along[1],
            _ => out.push(PathSpeed { along, rule }),
        });
    }

    /// How long a vehicle takes from S to S at the speed limits. S outside the path is moved to its nearer end.
    ///
    /// Errors: two S that are not finite or not in order.
    pub fn travel_time(&self, [from, to]: [f64; 2]) -> Result<PathTime, PathError> {
        let part = self.part([from, to])?;
        let mut sum = PathTime { time: 0.0, unlimited: 0.0 };
        self.each_limit(part, |_, along, rule| sum.add(along, rule.max));
        Ok(sum)
    }

    /// Two S, each moved to the path's nearer end where it lies outside.
    ///
    /// Errors: two S that are not finite or not in order.
    pub(crate) fn part(&self, [from, to]: [f64; 2]) -> Result<[f64; 2], PathError> {
        if !(from <= to && (to - from).is_finite()) {
            return Err(PathError::NotInOrder);
        }
        Ok([from, to].map(|along| mapd_geometry::clamp(along, 0.0, self.length())))
    }

    /// Tells the limits between two S on the path, in ascending S without gaps, each with the number of its lane among [`Path::lanes`].
    pub(crate) fn each_limit(
        &self,
        [from, to]: [f64; 2],
        mut tell: impl FnMut(usize, [f64; 2], SpeedRule),
    ) {
        let first = self.span_at(from).map_or(0, |span| span.piece as usize);
        for (number, piece) in self.buffer.pieces.iter().enumerate().skip(first) {
            let [begin, end] = self.ends_of(piece);
            let (mut along, end) = (begin.max(from), end.min(to));
            let Some(limits) = self.limits_on(number).filter(|_| begin < to) else { return };
            for own in limits.stretches(piece.forward) {
                if along >= end {
                    break;
                }
                let s = if piece.forward { own.s.high } else { own.s.low };
                // Where the lane is left before the stretch ends, or not entered yet, no S is its end.
                let next = match self.along_on(piece, s) {
                    Some(next) => next.min(end),
                    None if self.is_ahead(piece, s) => end,
                    None => continue,
                };
                if next > along {
                    tell(number, [along, next], own.rule);
                    along = next;
                }
            }
            if along < end {
                // Beyond the section's end by rounding.
                let last = self.spans_of(piece).last().map(|span| limits.at(span.s[1]));
                tell(number, [along, end], last.unwrap_or(NOTHING));
            }
        }
    }

    /// The limit at S, which is s on a piece, and how long nothing on the piece can change it.
    pub(super) fn limit_from(&self, number: usize, along: f64, s: f64) -> Limit {
        let piece = self.buffer.pieces.get(number);
        let (Some(piece), Some(lane)) = (piece, self.lane_of(number)) else { return Limit::NONE };
        let rule = self.rule_on(number, s).unwrap_or(NOTHING);
        let next = lane.speed_breaks().filter_map(|s| self.along_on(piece, s));
        let next = next.filter(|next| next + ROUNDING > along);
        Limit { rule, until: next.fold(self.ends_of(piece)[1], f64::min) }
    }

    /// The limit at s on a piece, by the way that the path has come.
    fn rule_on(&self, number: usize, s: f64) -> Option<SpeedRule> {
        Some(self.limits_on(number)?.at(s))
    }

    /// The limits of a piece's lane, by the way that the path has come.
    fn limits_on(&self, number: usize) -> Option<Limits<'a, impl Fn() -> Carried + Copy>> {
        let (path, lane) = (*self, self.lane_of(number)?);
        let carried = move || path.carried(number, &lane);
        Some(Limits { lane, signs: self.signs_at_entry(number, &lane), carried })
    }

    /// What the path brings onto a piece in a junction; where it begins in the junction, all that may come.
    fn carried(&self, number: usize, lane: &Lane<'a>) -> Carried {
        let piece = self.buffer.pieces.get(number);
        let entry = piece.map_or(NONE, |piece| piece.way.entry) as usize;
        let (Some(piece), Some(last)) = (self.buffer.pieces.get(entry), self.lane_of(entry)) else {
            return lane.carried_by_all();
        };
        let stated = self.stated_at_exit(entry, piece);
        match stated.is_none() && last.is_in_junction() {
            true => last.carried_by_all(),
            false => Carried::by(stated),
        }
    }

    /// What is stated for a piece where the path leaves it.
    fn stated_at_exit(&self, number: usize, piece: &Piece) -> Option<SpeedRule> {
        let end = self.spans_of(piece).last()?.s[1];
        self.limits_on(number)?.stated_at(end)
    }

    /// Where a piece has its speed limit from, if the way to it says; of those before it that is known.
    fn way_to(&self, number: usize) -> Option<Way> {
        let lane = self.lane_of(number)?;
        let before = number.checked_sub(1)?;
        let (from, piece) = (self.lane_of(before)?, self.buffer.pieces.get(before)?);
        let mut way = Way::NONE;
        if depends(&lane.speed_signs_at_entry()) {
            let at_exit = from.speed_signs_after(from.speed_signs_at_entry(), None);
            way.zone = if depends(&at_exit) { piece.way.zone } else { before as u32 };
        }
        if lane.is_in_junction() {
            let goes_on = from.is_in_junction() && self.stated_at_exit(before, piece).is_none();
            let known = goes_on && piece.way.entry != NONE;
            way.entry = if known { piece.way.entry } else { before as u32 };
        }
        Some(way)
    }

    /// The signs that hold where a piece's lane is entered, by the way that the path has come.
    fn signs_at_entry(&self, number: usize, lane: &Lane<'a>) -> SpeedSigns<'a> {
        let own = lane.speed_signs_at_entry();
        if !depends(&own) {
            return own;
        }
        // From the last lane that does not depend on the way to it on, no sign says anything of zones: its lane would know.
        let first =
            self.buffer.pieces.get(number).and_then(|piece| self.lane_of(piece.way.zone as usize));
        let zone =
            first.map(|first| first.speed_signs_after(first.speed_signs_at_entry(), None).zone);
        SpeedSigns { zone: zone.unwrap_or(own.zone), ..own }
    }

    fn lane_of(&self, number: usize) -> Option<Lane<'a>> {
        Lane::new(self.map, self.buffer.pieces.get(number)?.lane)
    }

    /// S at a piece's beginning and end.
    pub(super) fn ends_of(&self, piece: &Piece) -> [f64; 2] {
        let spans = self.spans_of(piece);
        [spans.first().map_or(0.0, |span| span.along), spans.last().map_or(0.0, |span| span.end())]
    }

    /// Whether the piece is left before s.
    fn is_ahead(&self, piece: &Piece, s: f64) -> bool {
        let end = self.spans_of(piece).last().map(|span| span.s[1]);
        end.is_some_and(|end| if piece.forward { s > end } else { s < end })
    }

    /// S of a place on a piece; none where it is not driven over.
    pub(super) fn along_on(&self, piece: &Piece, s: f64) -> Option<f64> {
        let spans = self.spans_of(piece);
        let before = |span: &Span| if piece.forward { span.s[1] < s } else { span.s[1] > s };
        spans.get(spans.partition_point(before))?.along_at(s)
    }
}

/// Notes of each piece where it has its speed limit from.
pub(super) fn note_ways(map: Map<'_>, buffer: &mut PathBuffer) {
    for number in 0..buffer.pieces.len() {
        let way = Path { map, buffer }.way_to(number);
        if let Some(piece) = buffer.pieces.get_mut(number) {
            piece.way = way.unwrap_or(Way::NONE);
        }
    }
}

fn depends(signs: &SpeedSigns<'_>) -> bool {
    matches!(signs.zone, Zone::Depends(_))
}
