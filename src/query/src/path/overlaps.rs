//! Lanes of other roads that lie where a path does.
//!
//! Each chunk of the path asks the index once which of them come near. Most chunks have none; on the others the driven line is compared
//! with them every 2 m.

use super::along::center;
use super::conflicts::ConflictLane;
use super::{Path, Piece, Span};
use crate::index::{self, LaneSegment};
use crate::lane::Lane;
use crate::nearest::{NearestOptions, round_up};
use crate::types::Point;
use glam::DVec2;
use mapd_archive::ConflictKind;

/// Distance of the places of the driven line at which lanes of other roads are looked for `[m]`.
pub(super) const STEP: f64 = 2.0;
/// A lane farther above or below is on another level `[m]`: less than any vehicle passes under.
const LEVEL: f64 = 2.0;
/// A lane that the path drives within this of a place `[m]` is its own way there: nothing on wheels turns back to where it was on less.
const OWN_WAY: f64 = 24.0;
/// Length of the chunks that ask the index once `[m]`.
const CHUNK: f64 = 24.0;
/// Stretches of lanes near a chunk that are kept for its places; where there are more, each place asks the index.
const MOST_NEAR: usize = 64;
/// Looks at chunks, places and what is known there already of one path, besides one for each of its spans: those of more than 1,900 km where few lanes overlap. Only a
/// damaged archive has longer ones, of any length.
const MOST_LOOKS: usize = 1 << 20;

/// Stretches of other roads' lanes near a chunk: row of the lane and number of the segment.
struct Near {
    stretches: [LaneSegment; MOST_NEAR],
    count: usize,
    /// Whether there was no room for all.
    is_full: bool,
}

/// Looks that a path has left.
pub(super) struct Looks(usize);

impl Looks {
    /// Of a path with so many spans.
    pub(super) fn of(spans: usize) -> Self {
        Self(spans.saturating_add(MOST_LOOKS))
    }

    /// Takes one; whether there was one left.
    pub(super) fn take(&mut self) -> bool {
        let is_left = self.0 > 0;
        self.spend(1);
        is_left
    }

    fn spend(&mut self, count: usize) {
        self.0 = self.0.saturating_sub(count);
    }
}

/// A piece that is looked along.
struct Along<'a, 'p> {
    /// Of its first piece, if it is several.
    number: usize,
    piece: &'p Piece,
    lane: &'p Lane<'a>,
}

impl<'a> Path<'a, '_> {
    /// Adds lanes of other roads in whose area the driven line lies, on the same level.
    pub(super) fn overlaps(
        &self,
        number: usize,
        piece: &Piece,
        lane: &Lane<'a>,
        looks: &mut Looks,
        out: &mut Vec<ConflictLane>,
    ) {
        let own = Along { number, piece, lane };
        let before = out.len();
        let mut rest = self.spans_of(piece);
        while let Some(first) = rest.first() {
            let fits = |span: &&Span| span.end() - first.along <= CHUNK;
            let count = rest.iter().take_while(fits).count().max(1);
            let (chunk, later) = rest.split_at(count);
            rest = later;
            let parts = (first.length / CHUNK).ceil().max(1.0);
            // Casts saturate; what is that long runs out of looks.
            for part in 0..parts as u64 {
                if !looks.take() {
                    return;
                }
                let shares = [part as f64 / parts, (part + 1) as f64 / parts];
                self.overlaps_of(&own, chunk, shares, before, looks, out);
            }
        }
    }

    /// Adds those of a chunk: of some spans, or of a share of one.
    fn overlaps_of(
        &self,
        own: &Along<'a, '_>,
        chunk: &[Span],
        shares: [f64; 2],
        before: usize,
        looks: &mut Looks,
        out: &mut Vec<ConflictLane>,
    ) {
        let Some(near) = self.near(own, chunk, shares) else { return };
        for span in chunk {
            let parts = (span.length / STEP).ceil().max(1.0);
            let reach = 0.5 * span.length / parts;
            let first = (shares[0] * parts - 0.5).ceil().max(0.0) as u64;
            let middles = (first..u64::MAX).map(|part| part as f64 + 0.5);
            for part in middles.take_while(|part| *part < parts * shares[1]) {
                if !looks.take() {
                    return;
                }
                let gone = span.length * part / parts;
                let at = span.place(span.s_at(gone));
                let shift = self.shift_at(span, span.along + gone);
                let place = center(own.lane, at, own.piece.forward, shift.as_ref());
                let Ok(place) = place else { continue };
                let along = [span.along + gone - reach, span.along + gone + reach];
                let point = Point::from(place.position);
                looks.spend(self.overlaps_at(own, &near, point, along, before, out));
            }
        }
    }

    /// Adds lanes that hold a place of the driven line; how many of those that are known it has looked at.
    fn overlaps_at(
        &self,
        own: &Along<'a, '_>,
        near: &Near,
        point: Point,
        along: [f64; 2],
        before: usize,
        out: &mut Vec<ConflictLane>,
    ) -> usize {
        let mut looked_at = 0;
        let options =
            NearestOptions { radius: 0.0, z_tolerance: Some(LEVEL), ..Default::default() };
        let mut found = |other: &Lane<'a>, s: f64| {
            if self.is_near_way(own.number, along, other.row_number(), [s; 2], OWN_WAY) {
                return;
            }
            // What goes on was added lately.
            let mut all = out.get_mut(before..).unwrap_or(&mut []).iter_mut().rev();
            let known = all.find(|known| {
                looked_at += 1;
                known.other == other.lane_id() && known.along[1] + STEP >= along[0]
            });
            match known {
                Some(known) => {
                    known.along[1] = known.along[1].max(along[1]);
                    known.other_s[0] = known.other_s[0].min(s);
                    known.other_s[1] = known.other_s[1].max(s);
                }
                None => self.add(own.lane, other, along, [s; 2], ConflictKind::Overlap, out),
            }
        };
        if near.is_full {
            let counts = |other: &Lane<'a>| self.may_overlap(own, other);
            self.map.each_lane_at(point, &options, counts, found);
            return looked_at;
        }
        let local = point.xy - self.map.origin();
        for stretch in &near.stretches[..near.count] {
            let held = self.map.candidate(*stretch, point, local, &options);
            let held = held.filter(|held| held.distance() <= 0.0).and_then(|h| h.nearest(self.map));
            if let Some((held, other)) = held.zip(Lane::new(self.map, stretch.lane)) {
                found(&other, held.position.s);
            }
        }
        looked_at
    }

    /// The stretches of other roads' lanes near a chunk; none where there are none.
    fn near(&self, own: &Along<'a, '_>, chunk: &[Span], shares: [f64; 2]) -> Option<Near> {
        let (first, last) = (chunk.first()?, chunk.last()?);
        let (middle, radius) = if shares == [0.0, 1.0] {
            let middle = 0.5 * (first.ends[0] + last.ends[1]);
            let far = |span: &Span| {
                let [a, b] = span.ends.map(|end| end.distance(middle));
                a.max(b) + span.slack
            };
            (middle, chunk.iter().map(far).fold(0.0, f64::max))
        } else {
            // A long span lies near its chord, and what it is longer is within its slack twice.
            let [a, b] = first.ends;
            let at = |share: f64| a + (b - a) * share;
            let middle = at(0.5 * (shares[0] + shares[1]));
            let beyond: DVec2 = at(shares[1]) - middle;
            (middle, beyond.length() + 3.0 * first.slack)
        };
        let mut near = Near { stretches: [LaneSegment::NONE; MOST_NEAR], count: 0, is_full: false };
        // Segments of one lane follow each other: each lane is examined once in a row.
        let mut last: Option<(u32, bool)> = None;
        let radius = round_up(radius);
        index::visit(self.map.tables(), middle, None, radius, |leaf, qx, qy, bound| {
            let (lanes, segments) = (leaf.lane(), leaf.segment());
            let lower = index::lower_bounds(leaf, qx, qy, None);
            for k in (0..lower.len()).filter(|k| lower[*k] <= bound) {
                let (row, segment) = (lanes[k], segments[k]);
                let counts = match last {
                    Some((known, counts)) if known == row => counts,
                    _ => Lane::new(self.map, row).is_some_and(|lane| self.may_overlap(own, &lane)),
                };
                last = Some((row, counts));
                if !counts {
                    continue;
                }
                match near.stretches.get_mut(near.count) {
                    Some(place) => {
                        (*place, near.count) = (LaneSegment { lane: row, segment }, near.count + 1)
                    }
                    None => near.is_full = true,
                }
            }
            bound
        });
        (near.count > 0).then_some(near)
    }

    /// Whether a lane counts where it lies in the same place: one of another road, open, that the path's lane neither comes from nor goes to.
    fn may_overlap(&self, own: &Along<'a, '_>, other: &Lane<'a>) -> bool {
        let (road, other_road) = (own.lane.road(), other.road());
        if road.road_id() == other_road.road_id() {
            return false;
        }
        let junction = road.junction_row();
        // Lanes of one junction that meet are the map's own to tell.
        if junction.is_some() && other_road.junction_row() == junction {
            return false;
        }
        let row = other.row_number();
        let linked = |id: crate::ids::LaneId| id.row() == row;
        let follows = own.lane.successors_towards(own.piece.forward).any(linked)
            || own.lane.predecessors_towards(own.piece.forward).any(linked);
        !follows && other.nodes().any(|node| node.is_open())
    }
}
