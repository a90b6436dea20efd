//! The course of one line of a road mark within a stretch of a lane, and its place that is nearest to a point.

use super::form::{Form, Round, Straight};
use super::{MarkFilter, MarkPoint, MarkSource, NearMark, Side};
use crate::area::Slab;
use crate::error::QueryError;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::profile::{self, At};
use crate::road_mark::{RoadMark, RoadMarkLine};
use crate::waypoints::MOST_STATIONS;
use core::cmp::Ordering;
use glam::{DVec2, DVec3};
use mapd_archive::{RoadMarkColor, RoadMarkKind};
use mapd_geometry::clamp;

/// Parts of a course that are looked at before the nearest is narrowed down.
const PARTS: usize = 8;
/// Longest part `[m]` of a course that sways: shorter than half a wave of what is painted.
const SWAY_PART: f64 = 1.0;
/// Most parts.
const MAX_PARTS: usize = 256;
/// Narrowings of two parts to 0.618 of them each: from metres to below a micrometre, and to 1e-12 m in the distance.
const NARROWINGS: usize = 36;
/// Share of a stretch that is kept by one narrowing: the golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Step along s for the course's direction at a place `[m]`.
const STEP: f64 = 1e-4;
/// How far a stretch may go on beyond what its geometry states `[m]`: by rounding alone.
const MOST_BEYOND: f64 = 1e-3;
/// What rounding makes of a distance `[m]`.
const SLACK: f64 = 1e-9;

/// One line of a mark along a stretch.
#[derive(Clone, Copy)]
pub(super) struct Course<'m> {
    owner: Lane<'m>,
    slab: Slab<'m>,
    mark: RoadMark<'m>,
    line: Option<RoadMarkLine>,
    /// First and last s `[m]`.
    s: [f64; 2],
    /// Which mark of the owner it is, and which line of the mark.
    number: [usize; 2],
}

/// Visits each line of each mark on the owner's border that the filter lets pass, as far as it lies along a stretch.
pub(super) fn along<'m>(
    owner: &Lane<'m>,
    slab: &Slab<'m>,
    filter: &MarkFilter,
    mut visit: impl FnMut(Course<'m>),
) {
    let (owner, slab) = (*owner, *slab);
    for (mark_number, mark) in owner.road_marks().enumerate() {
        let of_mark = [mark.s().max(slab.s_lo), mark.s_end().min(slab.s_hi)];
        if of_mark[0] > of_mark[1] {
            continue;
        }
        let kind = mark.kind();
        if kind == RoadMarkKind::None || !filter.kinds.contains(kind) {
            continue;
        }
        if mark.lines().len() == 0 {
            visit(Course { owner, slab, mark, line: None, s: of_mark, number: [mark_number, 0] });
        }
        for (line_number, line) in mark.lines().enumerate() {
            let [start, end] = mark.extent_of(&line).s;
            let s = [of_mark[0].max(start), of_mark[1].min(end)];
            if s[0] <= s[1] {
                let number = [mark_number, line_number];
                visit(Course { owner, slab, mark, line: Some(line), s, number });
            }
        }
    }
}

/// A place on a course.
pub(super) struct CoursePoint {
    pub(super) s: f64,
    /// From the local origin.
    pub(super) place: DVec2,
    /// Left of the reference line there.
    pub(super) normal: DVec2,
}

impl<'m> Course<'m> {
    /// The line's place at s, and the normal to the left of the reference line.
    fn at(&self, s: f64) -> (DVec2, DVec2) {
        let at = self.slab.at(s);
        let point = self.slab.piece.curve.evaluate(s - self.slab.piece.s);
        let normal = DVec2::new(-point.sin, point.cos);
        let lateral = self.t(at) * self.owner.road().roll(at).0;
        (DVec2::new(point.x, point.y) + normal * lateral, normal)
    }

    /// The line's lateral coordinate.
    fn t(&self, at: At) -> f64 {
        let sway = self.mark.sway(At::within(at.s, self.mark.s(), self.mark.s_end()));
        let offset = self.line.map_or(0.0, |line| line.t_offset);
        self.owner.edges(at).outer + sway + offset
    }

    /// Which of two courses comes first where both have a place equally near and of the same lane and s: the one of the first mark, line, stretch.
    pub(super) fn order(&self, other: &Self) -> Ordering {
        self.number.cmp(&other.number).then(self.slab.s_lo.total_cmp(&other.slab.s_lo))
    }

    /// Tells of the places at multiples of a spacing that are painted, or may be: s, and where, relative to the local origin.
    ///
    /// Errors: there are more than [`MOST_STATIONS`].
    pub(super) fn points(
        &self,
        spacing: f64,
        mut visit: impl FnMut(f64, DVec3),
    ) -> Result<(), QueryError> {
        let [from, to] = self.s;
        if (to - from) / spacing > MOST_STATIONS {
            return Err(QueryError::Option("spacing"));
        }
        let first = (from / spacing).ceil();
        let places = (0..=MOST_STATIONS as u32).map(|i| (first + f64::from(i)) * spacing);
        // What ends a stretch belongs to the next one.
        for s in places.take_while(|s| *s < to) {
            if self.painted(s) != Some(false) {
                let (at, road) = (self.slab.at(s), self.owner.road());
                let z = road.elevation(at) + self.t(at) * road.roll(at).1;
                visit(s, self.at(s).0.extend(z));
            }
        }
        Ok(())
    }

    pub(super) fn mark_point(&self, s: f64, position: DVec3) -> MarkPoint {
        let (color, width) = self.look();
        let source = MarkSource::Lane(self.lane());
        MarkPoint { position, source, s, kind: self.mark.kind(), color, width }
    }

    /// Colour and width: the line's own, or the mark's.
    fn look(&self) -> (RoadMarkColor, f64) {
        let line = self.line;
        let own_color = line.map(|l| l.color).filter(|color| *color != RoadMarkColor::NotGiven);
        let own_width = line.and_then(|line| line.width).filter(|width| *width > 0.0);
        let (color, width) = (self.mark.color(), self.mark.width_or_default());
        (own_color.unwrap_or(color), own_width.unwrap_or(width))
    }

    /// Whether a place is painted, if the file says so.
    fn painted(&self, s: f64) -> Option<bool> {
        let Some(line) = self.line else {
            use RoadMarkKind::{Curb, Edge, Grass, Solid, SolidSolid};
            let whole = [Solid, SolidSolid, Curb, Edge, Grass].contains(&self.mark.kind());
            return whole.then_some(true);
        };
        // An explicit line ends where its course does.
        Some(self.mark.extent_of(&line).is_in_dash(s))
    }

    /// What the course is made of: closed forms where the reference line is a line or an arc, and the line keeps beside it.
    pub(super) fn form(&self) -> Form {
        self.even_form().unwrap_or(Form::Searched)
    }

    fn even_form(&self) -> Option<Form> {
        let [from, end] = self.s;
        let piece = &self.slab.piece;
        // A stretch may go on a little beyond the length that its geometry states: all of that lies where the curve ends.
        let to = end.min(piece.s + piece.curve.length());
        let curvature = piece.curve.even_curvature_up_to(0.0)?;
        if self.mark.sways() || from > to || end - to > MOST_BEYOND {
            return None;
        }
        let at = self.slab.at(from);
        let mut t = self.owner.even_outer(at, to)?;
        t.value += self.line.map_or(0.0, |line| line.t_offset);
        let angle = profile::even(self.owner.road().superelevations(), at)?;
        if angle.derivative != 0.0 {
            return None;
        }
        let roll = profile::roll(angle.value).0;
        let start = piece.curve.tangent(from - piece.s);
        let (tangent, normal) =
            (DVec2::new(start.cos, start.sin), DVec2::new(-start.sin, start.cos));
        let first = DVec2::new(start.x, start.y) + normal * (t.value * roll);
        let growth = t.derivative * roll;
        if growth.abs() * (end - to) > SLACK {
            return None;
        }
        if curvature == 0.0 {
            return Some(Form::Straight(Straight::new(first, tangent, growth, [from, to])));
        }
        if growth != 0.0 {
            return None;
        }
        let end = piece.curve.tangent(to - piece.s);
        let tangents = [tangent, DVec2::new(end.cos, end.sin)];
        let offset = t.value * roll;
        let last = DVec2::new(end.x, end.y) + tangents[1].perp() * offset;
        Round::new([first, last], tangents, curvature, offset, [from, to]).map(Form::Round)
    }

    /// The nearest place, by looking: the best of several is narrowed down between its neighbours.
    pub(super) fn searched(&self, local: DVec2) -> CoursePoint {
        let [from, to] = self.s;
        let distance = |s: f64| self.at(s).0.distance_squared(local);
        let parts = match self.mark.sways() {
            true => (((to - from) / SWAY_PART).ceil() as usize).clamp(PARTS, MAX_PARTS),
            false => PARTS,
        };
        let part = (to - from) / parts as f64;
        let places = (0..=parts).map(|i| if i == parts { to } else { from + part * i as f64 });
        let mut best = places.fold((f64::INFINITY, from), |best, s| less(best, (distance(s), s)));
        let (mut low, mut high) = (clamp(best.1 - part, from, to), clamp(best.1 + part, from, to));
        let (mut a, mut b) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
        let (mut at_a, mut at_b) = (distance(a), distance(b));
        for _ in 0..NARROWINGS {
            best = less(less(best, (at_a, a)), (at_b, b));
            if at_a < at_b {
                (high, b, at_b) = (b, a, at_a);
                a = high - GOLDEN * (high - low);
                at_a = distance(a);
            } else {
                (low, a, at_a) = (a, b, at_b);
                b = low + GOLDEN * (high - low);
                at_b = distance(b);
            }
        }
        let s = self.polished(best.1, local);
        let (place, normal) = self.at(s);
        CoursePoint { s, place, normal }
    }

    /// Where the course, straight from place to place, is nearest: a minimum tells its place to half its digits only.
    fn polished(&self, s: f64, local: DVec2) -> f64 {
        let [from, to] = self.s;
        let (low, high) = (clamp(s - STEP, from, to), clamp(s + STEP, from, to));
        let (a, b) = (self.at(low).0, self.at(high).0);
        let along = (b - a) / (high - low);
        let next = clamp(s + (local - self.at(s).0).dot(along) / along.length_squared(), from, to);
        let nearer = |s: f64| self.at(s).0.distance(local);
        // What is no number is not nearer.
        if nearer(next) <= nearer(s) + SLACK { next } else { s }
    }
}

/// The nearer of two places.
fn less(best: (f64, f64), found: (f64, f64)) -> (f64, f64) {
    if found.0 < best.0 { found } else { best }
}

impl Course<'_> {
    pub(super) fn lane(&self) -> LaneId {
        self.owner.lane_id()
    }

    /// What is known of the mark at a place of the course.
    pub(super) fn near_mark(&self, at: &CoursePoint, local: DVec2, origin: DVec2) -> NearMark {
        let (color, width) = self.look();
        let away = at.place - local;
        let left = away.dot(at.normal) > 0.0;
        NearMark {
            lane: self.lane(),
            s: at.s,
            place: at.place + origin,
            distance: away.length(),
            side_of_reference_line: if left { Side::Left } else { Side::Right },
            kind: self.mark.kind(),
            color,
            width,
            painted: self.painted(at.s),
        }
    }
}
