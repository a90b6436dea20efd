//! A point in a path's coordinates.

use super::along::center;
use super::{Path, Span};
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::types::Clamped;
use glam::DVec2;
use mapd_geometry::normalize_angle;

/// How far along the path from a hint the foot is looked for first `[m]`.
const HINT_REACH: f64 = 30.0;
/// Steps towards a foot at most; each gains several digits.
const STEPS: usize = 24;
/// A step by less than this ends the search for a foot `[m]`.
const STEP: f64 = 1e-10;
/// Nearness to the line's centre of curvature, as a share of the radius, below which steps are not made longer.
const MIN_CONTRACTION: f64 = 0.2;
/// Distances that differ by less are equal; the smaller S then wins `[m]`.
const EQUAL: f64 = 1e-9;

/// A point in a path's coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    heading: f64,
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
            None => self.nearest(local, &self.buffer.spans).ok_or(QueryError::Corrupt)?,
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
            heading: foot.heading,
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
        let foot = self.nearest(local, spans.get(first..end)?)?;
        let along = foot.along();
        let is_start = first > 0 && spans.get(first).is_some_and(|span| along <= span.along);
        let is_end = end < spans.len() && spans.get(end).is_some_and(|span| along >= span.along);
        (!is_start && !is_end).then_some(foot)
    }

    /// The nearest place of some spans that follow each other.
    fn nearest(&self, local: DVec2, spans: &'b [Span]) -> Option<Foot<'b>> {
        let chord = |span: &Span| {
            let [a, b] = span.ends;
            let (edge, away) = (b - a, local - a);
            let along = away.dot(edge) / edge.length_squared().max(f64::MIN_POSITIVE);
            (away - edge * mapd_geometry::clamp(along, 0.0, 1.0)).length_squared()
        };
        let (mut nearest, mut squared) = (spans.first()?, f64::INFINITY);
        for span in spans {
            let own = chord(span);
            if own < squared {
                (nearest, squared) = (span, own);
            }
        }
        let mut best = self.foot(nearest, local)?;
        for span in spans {
            let reach = best.distance + span.slack + EQUAL;
            if std::ptr::eq(span, nearest) || chord(span) > reach * reach {
                continue;
            }
            let Some(foot) = self.foot(span, local) else { continue };
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
                best = foot;
            }
        }
        Some(best)
    }

    /// The nearest place of one span, by steps along the line's own direction.
    fn foot(&self, span: &'b Span, local: DVec2) -> Option<Foot<'b>> {
        let (piece, lane) = self.piece(span)?;
        let curvature = span.turn / span.length;
        let [a, b] = span.ends;
        let share = (local - a).dot(b - a) / (b - a).length_squared().max(f64::MIN_POSITIVE);
        let mut gone = span.length * mapd_geometry::clamp(share, 0.0, 1.0);
        let mut best: Option<Foot<'b>> = None;
        for _ in 0..STEPS {
            let own = center(&lane, span.place(span.s_at(gone)), piece.forward).ok()?;
            let away = local - (own.position.truncate() - self.map.origin());
            let (sin, cos) = cos_sin(own.heading);
            let (ahead, d) = (away.x * cos + away.y * sin, away.y * cos - away.x * sin);
            let distance = away.length();
            let foot = Foot { span, gone, distance, ahead, d, heading: own.heading };
            if best.is_none_or(|best| distance <= best.distance) {
                best = Some(foot);
            }
            let step = ahead / (1.0 - curvature * d).max(MIN_CONTRACTION);
            let next = mapd_geometry::clamp(gone + step, 0.0, span.length);
            if (next - gone).abs() <= STEP {
                break;
            }
            gone = next;
        }
        best
    }
}

/// Sine and cosine of a heading.
fn cos_sin(heading: f64) -> (f64, f64) {
    let (cos, sin) = mapd_geometry::cos_sin(heading);
    (sin, cos)
}
