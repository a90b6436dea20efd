//! Who goes first where lanes meet outside junctions, where to wait, and how far the common place reaches.

use super::Path;
use super::along::center;
use super::conflicts::{ConflictLane, Yields};
use super::overlaps::STEP;
use crate::lane::Lane;
use crate::rules::{ENTRY_REACH, EntrySign};
use crate::signals::LaneSignal;
use crate::view::View;
use glam::DVec2;
use mapd_archive::{Class, ConflictKind, Relation, RelationReason};

/// How far a common place is followed to either side at most, in steps.
const MOST_STEPS: i32 = 50;
/// Lanes side by side touch: what is nearer to an edge than this is not looked at `[m]`.
const TOUCHES: f64 = 0.1;

/// By what one comes to a place where lanes meet.
struct Entry {
    sign: EntrySign,
    is_lit: bool,
    /// S of the last line to stop at, on a path.
    line: Option<f64>,
}

impl<'a> Path<'a, '_> {
    /// Completes a conflict outside junctions, of the piece of a number.
    pub(super) fn settle(&self, number: usize, view: Option<View<'a>>, own: &mut ConflictLane) {
        let Ok(other) = self.map.lane(own.other) else { return };
        let is_joint = own.along[0] == own.along[1];
        if own.kind == ConflictKind::Overlap || is_joint {
            self.widen(&other, -STEP, own);
        }
        if own.kind == ConflictKind::Overlap {
            self.widen(&other, STEP, own);
        }
        let mine = self.entry_at(number, view, own.along[0]);
        let theirs = entry_of(&other, view, own.other_s);
        let (relation, reason) = match mine.is_lit && theirs.is_lit {
            true => (Relation::Lights, RelationReason::Lights),
            false => mine.sign.against(theirs.sign).unwrap_or((own.relation, own.reason)),
        };
        (own.relation, own.reason, own.yields) = (relation, reason, Yields::of(relation, reason));
        own.wait = mine.line.unwrap_or(own.along[0]);
    }

    /// Moves an end of the common place as far as the driven lane lies in the other one.
    fn widen(&self, other: &Lane<'a>, step: f64, own: &mut ConflictLane) {
        let end = usize::from(step > 0.0);
        let begin = own.along[end];
        // From a place within on: the end itself may touch the other lane alone.
        for i in -1..=MOST_STEPS {
            let along = begin + f64::from(i) * step;
            if along < 0.0 || along > self.length() {
                return;
            }
            let mut is_common = false;
            for point in self.across(along).into_iter().flatten() {
                let Ok(found) = other.position_of(point) else { continue };
                if found.distance <= 0.0 {
                    is_common = true;
                    own.other_s[0] = own.other_s[0].min(found.s);
                    own.other_s[1] = own.other_s[1].max(found.s);
                }
            }
            match is_common {
                true if i > 0 => own.along[end] = along,
                false if i > 0 => return,
                _ => {}
            }
        }
    }

    /// The driven line and both edges of its lane, but for what touches others.
    fn across(&self, along: f64) -> Option<[DVec2; 3]> {
        // At a joint the lane before counts: who merges lies beside that.
        let spans = &self.buffer.spans;
        let span = spans.get(spans.partition_point(|span| span.end() < along))?;
        let (piece, lane) = self.piece(span)?;
        let at = span.place(span.s_at(along - span.along));
        let shift = self.shift_at(span, along);
        let place = center(&lane, at, piece.forward, shift.as_ref()).ok()?;
        let half = 0.5 * (place.edges.outer.value - place.edges.inner.value).abs() - TOUCHES;
        let (middle, left) = (place.position.truncate(), DVec2::from_angle(place.heading).perp());
        Some([middle + left * half.max(0.0), middle, middle - left * half.max(0.0)])
    }

    /// By what the path comes to S on a piece of it.
    fn entry_at(&self, number: usize, view: Option<View<'a>>, along: f64) -> Entry {
        let mut entry = Entry { sign: EntrySign::None, is_lit: false, line: None };
        for piece in self.buffer.pieces.get(..=number).unwrap_or(&[]).iter().rev() {
            if self.ends_of(piece)[1] < along - ENTRY_REACH {
                break;
            }
            let Some(lane) = Lane::new(self.map, piece.lane) else { break };
            let near = |s: f64| {
                let at = self.along_on(piece, s)?;
                (at <= along && along - at <= ENTRY_REACH).then_some(at)
            };
            for one in lane.signals().filter(|one| one.is_for(piece.forward)) {
                let signal = one.signal();
                if !signal.is_invalidated() && near(one.s_on(&lane)).is_some() {
                    entry.sign = entry.sign.and(EntrySign::of(signal.class()));
                    entry.is_lit |= is_lit(&one, view);
                }
            }
            for line in lane.all_lines(piece.forward) {
                if matches!(line.class, Class::StopLine | Class::WaitingLine) {
                    let known = entry.line.into_iter().chain(near(line.s));
                    entry.line = known.max_by(f64::total_cmp);
                }
            }
        }
        entry
    }
}

/// By what traffic comes to a stretch of a lane: signs on it, and on the lanes that lead to it alone.
fn entry_of<'a>(lane: &Lane<'a>, view: Option<View<'a>>, [low, high]: [f64; 2]) -> Entry {
    let mut entry = Entry { sign: EntrySign::None, is_lit: false, line: None };
    let (begin, end) = if lane.is_forward() { (low, high) } else { (high, low) };
    let section = lane.section();
    let start = if lane.is_forward() { section.s_start() } else { section.s_end() };
    let before_begin = lane.length_between(start, begin);
    // Lanes before it are so far from where the stretch begins, counted from the lane's end.
    let from_end = before_begin - lane.length_between(start, lane.exit_s());
    for (on, after) in lane.run(true, from_end) {
        let forward = on.is_forward();
        for one in on.signals().filter(|one| one.is_for(forward)) {
            let s = one.s_on(&on);
            let is_before = |place: f64| if forward { s <= place } else { s >= place };
            let distance = match on.lane_id() == lane.lane_id() {
                true if !is_before(end) => continue,
                true if !is_before(begin) => 0.0,
                true => on.length_between(s, begin),
                false => after + on.length_between(s, on.exit_s()),
            };
            if distance <= ENTRY_REACH && !one.signal().is_invalidated() {
                entry.sign = entry.sign.and(EntrySign::of(one.signal().class()));
                entry.is_lit |= is_lit(&one, view);
            }
        }
    }
    entry
}

/// Whether a signal is a light for vehicles that works.
pub(super) fn is_lit(one: &LaneSignal<'_>, view: Option<View<'_>>) -> bool {
    let works = || view.is_none_or(|view| view.is_in_service(one.signal().signal_id()));
    one.is_vehicle_light() && works()
}
