//! A point in a path's coordinates.

use super::along::tangent;
use super::arc::Near;
use super::boxes::{WIDTH, Wanted, least, within};
use super::{Path, PathBuffer, Span};
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::types::{Clamped, is_place};
use glam::DVec2;
use mapd_geometry::normalize_angle;

/// How far along the path from a hint the foot is looked for first `[m]`.
const HINT_REACH: f64 = 30.0;
/// Steps towards a foot at most; each gains several digits.
const STEPS: usize = 24;
/// Parts of a span whose ends are looked at where steps do not come to a foot.
const PARTS: usize = 16;
/// Halvings of two parts of a span at most: where S is so large that no number lies between two, no step gets short enough.
const MOST_HALVINGS: usize = 64;
/// A step by less than this is the last one towards a foot `[m]`: it leaves an error of its square.
const STEP: f64 = 5e-7;
/// Nearness to the line's centre of curvature, as a share of the radius, below which steps are not made longer.
const MIN_CONTRACTION: f64 = 0.2;
/// Between these S lies all of a path.
const EVERYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
/// Distances that differ by less are equal; the smaller S then wins `[m]`.
const EQUAL: f64 = 1e-9;

/// A point in a path's coordinates.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathPosition {
    /// S of the foot: the nearest point of the driven line in plan view `[m]`.
    pub along: f64,
    /// Offset to the left of the driven line there `[m]`.
    pub d: f64,
    /// Plan-view distance from the driven line `[m]`: |d| but before and after the path and at joints.
    pub distance: f64,
    /// Heading of the driven line at the foot `[rad]`, in (−π, π].
    pub heading: f64,
    /// The driven lane there.
    pub lane: LaneId,
    /// s on its road `[m]`.
    pub s: f64,
    /// Whether the point lies before the path's start or after its end.
    pub clamped: Clamped,
}

impl PathPosition {
    /// A heading less the driving direction at the foot `[rad]`, in (−π, π].
    pub fn heading_difference(&self, heading: f64) -> f64 {
        normalize_angle(heading - self.heading)
    }
}

/// The nearest place of one span.
#[derive(Clone, Copy)]
struct Foot<'b> {
    span: &'b Span,
    /// From the span's start `[m]`.
    gone: f64,
    distance: f64,
    /// Of the point from the foot, ahead and to the left `[m]`.
    ahead: f64,
    d: f64,
    /// Direction of the driven line.
    way: DVec2,
}

impl Foot<'_> {
    fn along(&self) -> f64 {
        self.span.along + self.gone
    }

    /// Of the driven line `[rad]`, in (−π, π].
    fn heading(&self) -> f64 {
        let Span { heading, turn, length, arc, .. } = self.span;
        // On a circle it turns evenly.
        if arc.is_exact {
            normalize_angle(heading + turn * (self.gone / length))
        } else {
            mapd_geometry::atan2(self.way.y, self.way.x)
        }
    }
}

impl<'b> Path<'_, 'b> {
    /// The nearest point of the driven line in plan view; of equally near ones that with the smaller S. With a `hint`, an S such as the
    /// one of the last answer, the nearest within 30 m along the path from it, so that the answer stays on its branch where the path
    /// crosses or repeats itself; only if that foot is the end of this stretch is the whole path looked at.
    ///
    /// Errors: coordinates or a hint that are not finite; a damaged archive.
    pub fn project(&self, point: DVec2, hint: Option<f64>) -> Result<PathPosition, QueryError> {
        if !(is_place(point) && hint.is_none_or(f64::is_finite)) {
            return Err(QueryError::NotFinite);
        }
        let local = point - self.map.origin();
        let near = hint.and_then(|hint| self.near_hint(local, hint));
        let foot = match near {
            Some(foot) => foot,
            None => self.nearest(local, EVERYWHERE).ok_or(QueryError::Corrupt)?,
        };
        let piece = self.buffer.pieces.get(foot.span.piece as usize).ok_or(QueryError::Corrupt)?;
        let (along, end) = (foot.along(), self.length());
        let clamped = match foot.ahead {
            ahead if ahead < -EQUAL && along <= 0.0 => Clamped::Before,
            ahead if ahead > EQUAL && along >= end => Clamped::After,
            _ => Clamped::No,
        };
        Ok(PathPosition {
            along,
            d: foot.d,
            distance: foot.distance,
            heading: foot.heading(),
            lane: LaneId::new(piece.lane, self.map.content()),
            s: foot.span.s_at(foot.gone),
            clamped,
        })
    }

    /// The nearest place around a hint; none where it is the end of the stretch that is looked at.
    fn near_hint(&self, local: DVec2, hint: f64) -> Option<Foot<'b>> {
        let (low, high) = (hint - HINT_REACH, hint + HINT_REACH);
        let foot = self.nearest(local, [low, high])?;
        let (from, to) = (foot.span.along, foot.span.end());
        // Spans that reach into the stretch are looked at whole.
        let is_start = foot.along() <= from && from < low && from > 0.0;
        let is_end = foot.along() >= to && to > high && to < self.length();
        (!is_start && !is_end).then_some(foot)
    }

    /// The nearest place of the spans that reach between two S.
    fn nearest(&self, local: DVec2, among: [f64; 2]) -> Option<Foot<'b>> {
        let boxes = &self.buffer.boxes;
        let wanted = boxes.wanted(local, among);
        // What is infinite lies elsewhere.
        let mut search = Search { path: *self, local, wanted, best: None, bound: f32::MAX };
        search.under(boxes.top(), 0);
        search.best
    }

    /// The nearest place of one span, by steps along the line's own direction.
    fn foot(&self, span: &'b Span, local: DVec2) -> Option<Foot<'b>> {
        if span.arc.is_exact
            && let Some(near) = span.arc.nearest(local)
        {
            let Near { gone, distance, ahead, d, way } = near;
            return Some(Foot { span, gone, distance, ahead, d, way });
        }
        let (piece, lane) = self.piece(span)?;
        let curvature = span.turn / span.length;
        let mut gone = mapd_geometry::clamp(span.arc.guess(local), 0.0, span.length);
        let mut best: Option<Foot<'b>> = None;
        for _ in 0..STEPS {
            let at = span.place(span.s_at(gone));
            let shift = self.shift_at(span, span.along + gone);
            let [place, way] = tangent(&lane, at, piece.forward, shift.as_ref())?;
            let away = local - place;
            let (ahead, d) = (away.dot(way), way.perp_dot(away));
            let room = (1.0 - curvature * d).max(MIN_CONTRACTION);
            let next = mapd_geometry::clamp(gone + ahead / room, 0.0, span.length);
            let step = next - gone;
            let is_last = step.abs() <= STEP;
            // A step this small changes nothing but the place along the line.
            let ahead = if is_last { ahead - step * room } else { ahead };
            let (distance, gone_now) =
                ((ahead * ahead + d * d).sqrt(), if is_last { next } else { gone });
            if best.is_none_or(|best| distance <= best.distance) {
                best = Some(Foot { span, gone: gone_now, distance, ahead, d, way });
            }
            if is_last {
                return best;
            }
            gone = next;
        }
        self.foot_by_halves(span, local).or(best)
    }

    /// The nearest place of a span that turns so tightly that steps lead to and fro: of some places the nearest, and from there by halves.
    #[cold]
    fn foot_by_halves(&self, span: &'b Span, local: DVec2) -> Option<Foot<'b>> {
        let part = span.length / PARTS as f64;
        let mut best = self.foot_at(span, local, 0.0)?;
        for number in 1..=PARTS {
            let end = self.foot_at(span, local, part * number as f64)?;
            if end.distance < best.distance {
                best = end;
            }
        }
        let mut low = (best.gone - part).max(0.0);
        let mut high = (best.gone + part).min(span.length);
        for _ in 0..MOST_HALVINGS {
            if high - low <= STEP {
                break;
            }
            let middle = self.foot_at(span, local, low.midpoint(high))?;
            *(if middle.ahead > 0.0 { &mut low } else { &mut high }) = middle.gone;
            if middle.distance <= best.distance {
                best = middle;
            }
        }
        Some(best)
    }

    /// The place at a length along a span, seen from a point.
    // Never inlined: it is rarely asked, and its code is long.
    #[inline(never)]
    fn foot_at(&self, span: &'b Span, local: DVec2, gone: f64) -> Option<Foot<'b>> {
        let (piece, lane) = self.piece(span)?;
        let at = span.place(span.s_at(gone));
        let shift = self.shift_at(span, span.along + gone);
        let [place, way] = tangent(&lane, at, piece.forward, shift.as_ref())?;
        let away = local - place;
        let (ahead, d) = (away.dot(way), way.perp_dot(away));
        Some(Foot { span, gone, distance: away.length(), ahead, d, way })
    }
}

/// A search for the nearest place.
struct Search<'a, 'b> {
    path: Path<'a, 'b>,
    local: DVec2,
    wanted: Wanted,
    best: Option<Foot<'b>>,
    /// Square of the distance beyond which nothing is looked at: the best one's and the largest slack.
    bound: f32,
}

impl<'b> Search<'_, 'b> {
    /// Looks at what lies under a box, the nearest first.
    fn under(&mut self, level: usize, number: usize) {
        let squares = self.path.buffer.boxes.squared_distances(level, number, &self.wanted);
        let least = least(&squares);
        if least > self.bound {
            return;
        }
        // None is where all are no numbers, as in a damaged archive.
        let nearest = within(&squares, least).trailing_zeros() as usize;
        if nearest >= WIDTH {
            return;
        }
        // The nearest one bounds the search for the others.
        self.look_at(level, number * WIDTH + nearest, least);
        let mut open = within(&squares, self.bound) & !(1 << nearest);
        while open != 0 {
            let i = open.trailing_zeros() as usize;
            open &= open - 1;
            if squares[i] <= self.bound {
                self.look_at(level, number * WIDTH + i, squares[i]);
            }
        }
    }

    /// Looks at a span, or at what lies under a box of the level below.
    #[inline(always)]
    fn look_at(&mut self, level: usize, number: usize, squared: f32) {
        if level > 0 {
            return self.under(level - 1, number);
        }
        let Some(span) = self.path.buffer.spans.get(number) else { return };
        let boxes = &self.path.buffer.boxes;
        let is_near = |best: &Foot<'_>| squared <= boxes.reach(best.distance + span.slack + EQUAL);
        if self.best.as_ref().is_none_or(is_near)
            && let Some(foot) = self.path.foot(span, self.local)
        {
            self.consider(foot);
        }
    }

    fn consider(&mut self, foot: Foot<'b>) {
        let Some(best) = self.best else {
            self.take(foot);
            return;
        };
        let equal = (foot.distance - best.distance).abs() <= EQUAL;
        // Where two spans meet, both have the joint; the later one answers there, as in `at`.
        let same = equal && (foot.along() - best.along()).abs() <= EQUAL;
        let wins = if same {
            foot.span.along > best.span.along
        } else if equal {
            foot.along() < best.along()
        } else {
            foot.distance < best.distance
        };
        if wins {
            self.take(foot);
        }
    }

    fn take(&mut self, foot: Foot<'b>) {
        let PathBuffer { boxes, slack, .. } = self.path.buffer;
        (self.best, self.bound) = (Some(foot), boxes.reach(foot.distance + slack + EQUAL));
    }
}
