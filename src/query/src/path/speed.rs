//! Speed limits along a path.

use super::{Path, PathBuffer, PathError, Piece, Span};
use crate::lane::Lane;
use crate::map::Map;
use crate::rules::{SpeedOrigin, SpeedRule, SpeedSigns, Zone, is_of_speed};
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

/// Nothing is known.
const NOTHING: SpeedRule = SpeedRule { max: None, origin: SpeedOrigin::None, signal: None };
/// S of a record and s of a place may differ by rounding `[m]`.
const ROUNDING: f64 = 1e-6;

/// Pieces before one that say which speed limit holds on it, noted once so that no answer looks back over the path.
#[derive(Clone, Copy)]
pub(super) struct Way {
    /// The last piece whose lane knows which zone its traffic leaves it in; none where the own lane knows, and where no piece does.
    zone: u32,
    /// For a piece in a junction the last one before with a limit, or that before the junction; none where the path begins in it.
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
            let Some(lane) = self.lane_of(number).filter(|_| begin < to) else { return };
            while along < end {
                let places = breaks(&lane).filter_map(|s| self.along_on(piece, s));
                let next = places.filter(|next| *next > along).fold(end, f64::min);
                let middle = 0.5 * (along + next);
                let spans = self.spans_of(piece);
                let at = spans.partition_point(|span| span.along <= middle).saturating_sub(1);
                let s = spans.get(at).map(|span| span.s_at(middle - span.along));
                let rule = s.and_then(|s| self.rule_on(number, s)).unwrap_or(NOTHING);
                tell(number, [along, next], rule);
                along = next;
            }
        }
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
        if lane.road().junction_row().is_none() {
            return Some(lane.default_speed(s));
        }
        let piece = self.buffer.pieces.get(number)?;
        let Some(before) = self.buffer.pieces.get(piece.way.entry as usize) else {
            return Some(rule);
        };
        Some(match self.speed_at_exit(piece.way.entry as usize, before) {
            Some(own) if own.origin == SpeedOrigin::Depends => own,
            Some(own) => SpeedRule { origin: SpeedOrigin::Entry, ..own },
            None => lane.default_speed(s),
        })
    }

    /// What is written for a piece where the path leaves it.
    fn speed_at_exit(&self, number: usize, piece: &Piece) -> Option<SpeedRule> {
        let lane = self.lane_of(number)?;
        let end = self.spans_of(piece).last()?.s[1];
        lane.speed_with(self.signs_at_entry(number, &lane), end)
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
        let junction = lane.road().junction_row();
        if junction.is_some() {
            let inside = from.road().junction_row() == junction;
            let goes_on = inside && self.speed_at_exit(before, piece).is_none();
            way.entry = if goes_on { piece.way.entry } else { before as u32 };
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
    matches!(signs.zone, Zone::Depends)
}

/// Every s at which the limit on a lane may change.
fn breaks(lane: &Lane<'_>) -> impl Iterator<Item = f64> {
    let signs = lane.signals().filter(is_of_speed).map(|one| one.s_on(lane));
    let records = lane.speeds().map(|record| record.s);
    signs.chain(records).chain(lane.road().types().map(|record| record.s))
}
