//! A point in a path's coordinates.

use super::along::tangent;
use super::boxes::WIDTH;
use super::{Path, Span};
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::types::Clamped;
use glam::DVec2;
use mapd_geometry::normalize_angle;
use std::ops::Range;

/// How far along the path from a hint the foot is looked for first `[m]`.
const HINT_REACH: f64 = 30.0;
/// Steps towards a foot at most; each gains several digits.
const STEPS: usize = 24;
/// A step by less than this is the last one towards a foot `[m]`: it leaves an error of its square.
const STEP: f64 = 1e-7;
/// Nearness to the line's centre of curvature, as a share of the radius, below which steps are not made longer.
const MIN_CONTRACTION: f64 = 0.2;
/// Distances that differ by less are equal; the smaller S then wins `[m]`.
const EQUAL: f64 = 1e-9;

/// A point in a path's coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
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
}

impl<'b> Path<'_, 'b> {
    /// The nearest point of the driven line in plan view; of equally near ones that with the smaller S. With a `hint`, an S such as the
    /// one of the last answer, the nearest within 30 m along the path from it, so that the answer stays on its branch where the path
    /// crosses or repeats itself; only if that foot is the end of this stretch is the whole path looked at.
    ///
    /// Errors: coordinates or a hint that are not finite; a damaged archive.
    pub fn project(&self, point: DVec2, hint: Option<f64>) -> Result<PathPosition, QueryError> {
        if !(point.is_finite() && hint.is_none_or(f64::is_finite)) {
            return Err(QueryError::NotFinite);
        }
        let local = point - self.map.origin();
        let near = hint.and_then(|hint| self.near_hint(local, hint));
        let foot = match near {
            Some(foot) => foot,
            None => self.nearest(local, 0..self.buffer.spans.len()).ok_or(QueryError::Corrupt)?,
        };
        let (_, lane) = self.piece(foot.span).ok_or(QueryError::Corrupt)?;
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
            heading: mapd_geometry::atan2(foot.way.y, foot.way.x),
            lane: lane.lane_id(),
            s: foot.span.s_at(foot.gone),
            clamped,
        })
    }

    /// As [`Path::project`] without a hint, for many points; `out` is emptied first.
    ///
    /// Errors: as [`Path::project`].
    pub fn project_batch(
        &self,
        points: &[DVec2],
        out: &mut Vec<PathPosition>,
    ) -> Result<(), QueryError> {
        out.clear();
        points.iter().try_for_each(|point| {
            out.push(self.project(*point, None)?);
            Ok(())
        })
    }

    /// The nearest place around a hint; none where it is the end of the stretch that is looked at.
    fn near_hint(&self, local: DVec2, hint: f64) -> Option<Foot<'b>> {
        let spans = &self.buffer.spans;
        let (low, high) = (hint - HINT_REACH, hint + HINT_REACH);
        let first = spans.partition_point(|span| span.end() < low);
        let end = spans.partition_point(|span| span.along <= high);
        let foot = self.nearest(local, first..end)?;
        let along = foot.along();
        let is_start = first > 0 && spans.get(first).is_some_and(|span| along <= span.along);
        let is_end = end < spans.len() && spans.get(end).is_some_and(|span| along >= span.along);
        (!is_start && !is_end).then_some(foot)
    }

    /// The nearest place of some spans that follow each other.
    fn nearest(&self, local: DVec2, among: Range<usize>) -> Option<Foot<'b>> {
        let mut search = Search { path: *self, local, among, best: None };
        search.under(self.buffer.boxes.top(), 0);
        search.best
    }

    /// The nearest place of one span, by steps along the line's own direction.
    fn foot(&self, span: &'b Span, local: DVec2) -> Option<Foot<'b>> {
        let (piece, lane) = self.piece(span)?;
        let shift = self.shift(span);
        let curvature = span.turn / span.length;
        let mut gone = mapd_geometry::clamp(span.guess(local), 0.0, span.length);
        let mut best: Option<Foot<'b>> = None;
        for _ in 0..STEPS {
            let at = span.place(span.s_at(gone));
            let [place, way] = tangent(&lane, at, piece.forward, shift)?;
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
                break;
            }
            gone = next;
        }
        best
    }
}

impl Span {
    /// Square of a point's distance from the chord.
    #[inline]
    fn squared_from_chord(&self, local: DVec2) -> f64 {
        let [a, b] = self.ends;
        let (edge, away) = (b - a, local - a);
        let along = away.dot(edge) / edge.length_squared().max(f64::MIN_POSITIVE);
        (away - edge * mapd_geometry::clamp(along, 0.0, 1.0)).length_squared()
    }

    /// About where the foot of a point is, from the span's start: exact for a line, and for an arc but for the series of the arc tangent.
    fn guess(&self, local: DVec2) -> f64 {
        let [a, b] = self.ends;
        let chord = b - a;
        let length = chord.length().max(f64::MIN_POSITIVE);
        let way = chord / length;
        // An arc's middle lies beside that of its chord, away from the centre.
        let middle = 0.5 * (a + b) - way.perp() * (0.125 * self.length * self.turn);
        let away = local - middle;
        let curvature = self.turn / self.length;
        let room = (1.0 - curvature * way.perp_dot(away)).max(MIN_CONTRACTION);
        let u = away.dot(way) * curvature / room;
        let series = if u.abs() < 1.0 { 1.0 - u * u * (1.0 / 3.0 - u * u * 0.2) } else { 1.0 };
        0.5 * self.length + away.dot(way) / room * series
    }
}

/// A search for the nearest place.
struct Search<'a, 'b> {
    path: Path<'a, 'b>,
    local: DVec2,
    among: Range<usize>,
    best: Option<Foot<'b>>,
}

impl<'b> Search<'_, 'b> {
    /// Looks at what lies under a box, the nearest first.
    fn under(&mut self, level: usize, number: usize) {
        let first = number * WIDTH;
        let mut near = [(f64::INFINITY, 0); WIDTH];
        let mut count = 0;
        let mut add = |squared: f64, number: usize| {
            let mut at = count;
            while at > 0 && near[at - 1].0 > squared {
                near[at] = near[at - 1];
                at -= 1;
            }
            near[at] = (squared, number);
            count += 1;
        };
        let path = self.path;
        if level == 0 {
            let (from, end) = (first.max(self.among.start), (first + WIDTH).min(self.among.end));
            for (i, span) in (from..).zip(path.buffer.spans.get(from..end).unwrap_or(&[])) {
                add(span.squared_from_chord(self.local), i);
            }
        } else {
            let below = path.buffer.boxes.level(level - 1);
            let size = WIDTH.pow(level as u32);
            let end = (first + WIDTH).min(below.len());
            for (i, own) in (first..).zip(below.get(first..end).unwrap_or(&[])) {
                if i * size < self.among.end && (i + 1) * size > self.among.start {
                    add(own.squared_distance(self.local), i);
                }
            }
        }
        for (squared, i) in near.into_iter().take(count) {
            let within = |slack: f64| {
                self.best.is_none_or(|best| {
                    let reach = best.distance + slack + EQUAL;
                    squared <= reach * reach
                })
            };
            if level > 0 {
                if within(0.0) {
                    self.under(level - 1, i);
                }
            } else if let Some(span) = path.buffer.spans.get(i)
                && within(span.slack)
                && let Some(foot) = path.foot(span, self.local)
            {
                self.consider(foot);
            }
        }
    }

    fn consider(&mut self, foot: Foot<'b>) {
        let Some(best) = self.best else {
            self.best = Some(foot);
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
            self.best = Some(foot);
        }
    }
}
