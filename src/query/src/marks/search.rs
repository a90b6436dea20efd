//! The search for the nearest mark to one point.

use super::course::{self, Course, CoursePoint};
use super::form::Form;
use super::{MARK_SHIFT, MarkFilter, NearMark};
use crate::area::{self, Slab};
use crate::index;
use crate::lane::Lane;
use crate::map::Map;
use crate::nearest::round_up;
use glam::DVec2;
use mapd_archive::NONE;

/// More styles of marks than this are not looked at to learn how far their lines leave the border.
const FEW_STYLES: usize = 64;

/// Lines whose own offset is greater `[m]` are found as if it were this: no road is so wide, and a search has to look as far.
const MOST_OFFSET: f64 = 50.0;

/// How far lines of marks may lie from their lane's border and still be found for sure `[m]`: 0 of a map whose marks all lie on it, and as far as their
/// own offsets say where there are few.
pub(super) fn shift(map: Map<'_>) -> f64 {
    let (styles, lines) = (map.tables().road_mark_styles, map.tables().road_mark_lines);
    if styles.len() > FEW_STYLES || lines.len() > FEW_STYLES {
        return MARK_SHIFT;
    }
    let sways = styles.iter().any(|style| style.sway().count > 0);
    let offsets = lines.iter().map(|line| line.t_offset().abs()).fold(0.0, f64::max);
    let offsets = offsets.min(MOST_OFFSET);
    if sways { MARK_SHIFT + offsets } else { offsets }
}

/// Visits the lanes whose borders count in a stretch of one of them: its own outer one, and lane 0's with one of the two lanes beside it.
fn each_owner<'m>(lane: &Lane<'m>, filter: &MarkFilter, mut visit: impl FnMut(&Lane<'m>)) {
    visit(lane);
    // The lane to the inside has its border itself, unless the filter leaves it out.
    if let Some(inner) = lane.inner() {
        let comes_itself = match inner.number() {
            0 => lane.number() > 0 && has_right(lane, filter),
            _ => filter.types.contains(inner.kind()),
        };
        if !comes_itself {
            visit(&inner);
        }
    }
}

/// Whether lane 0 comes with the lane to its right.
fn has_right(lane: &Lane<'_>, filter: &MarkFilter) -> bool {
    let right = lane.section().lane(-1);
    right.is_some_and(|right| filter.types.contains(right.kind()))
}

/// A course, and what it is made of.
#[derive(Clone, Copy)]
pub(super) struct Candidate<'m> {
    pub(super) course: Course<'m>,
    pub(super) form: Form,
}

impl<'m> Candidate<'m> {
    pub(super) fn new(course: Course<'m>) -> Self {
        Self { form: course.form(), course }
    }

    fn nearest(&self, local: DVec2) -> CoursePoint {
        self.form.nearest(local).unwrap_or_else(|| self.course.searched(local))
    }
}

/// The best so far of a point.
pub(super) struct Search<'m, 'f> {
    map: Map<'m>,
    filter: &'f MarkFilter,
    best: Option<(f64, Candidate<'m>)>,
}

impl<'m, 'f> Search<'m, 'f> {
    pub(super) fn new(map: Map<'m>, filter: &'f MarkFilter) -> Self {
        Self { map, filter, best: None }
    }

    /// Looks everywhere that the filter's radius allows.
    pub(super) fn everywhere(&mut self, local: DVec2) {
        let (map, filter) = (self.map, self.filter);
        courses_near(map, local, filter, [filter.radius, shift(map)], &mut |course| {
            self.consider(Candidate::new(course), local);
            self.limit()
        });
    }

    /// How far away what changes the answer may be `[m]`.
    #[inline]
    pub(super) fn limit(&self) -> f64 {
        self.best.as_ref().map_or(self.filter.radius, |(distance, _)| *distance)
    }

    /// Takes a course that is nearer than the best so far; of equally near ones that of the first lane, s, mark, line and stretch: whatever
    /// order they come in.
    #[inline]
    pub(super) fn consider(&mut self, candidate: Candidate<'m>, local: DVec2) {
        let distance = candidate.form.distance(local);
        let distance =
            distance.unwrap_or_else(|| candidate.course.searched(local).place.distance(local));
        let limit = self.limit();
        // What is no number is not near.
        let is_near = distance <= limit;
        if !is_near {
            return;
        }
        let is_better = match &self.best {
            Some((_, best)) if distance == limit => {
                let rank = |of: &Candidate<'m>| (of.course.lane(), of.nearest(local).s);
                let ((lane, s), (own, own_s)) = (rank(&candidate), rank(best));
                let order = lane.cmp(&own).then(s.total_cmp(&own_s));
                order.then_with(|| candidate.course.order(&best.course)).is_lt()
            }
            _ => true,
        };
        if is_better {
            self.best = Some((distance, candidate));
        }
    }

    pub(super) fn found(&self, local: DVec2) -> Option<NearMark> {
        let (_, best) = self.best.as_ref()?;
        Some(best.course.near_mark(&best.nearest(local), local, self.map.origin()))
    }
}

/// Lanes that are remembered to have no marks that count.
const REMEMBERED: usize = 8;

/// Lanes that were looked at last and have no marks that count: their other stretches, too, cost nothing.
pub(super) struct Markless {
    lanes: [u32; REMEMBERED],
    next: usize,
}

impl Markless {
    pub(super) const NONE: Self = Self { lanes: [NONE; REMEMBERED], next: 0 };

    fn add(&mut self, lane: u32) {
        if let Some(place) = self.lanes.get_mut(self.next) {
            *place = lane;
        }
        self.next = (self.next + 1) % REMEMBERED;
    }
}

/// Visits the courses whose borders are within a limit of a place and may lie a shift off them `[m]`, about the nearest first. `visit` answers how far
/// away, from then on, what still counts may be.
pub(super) fn courses_near<'m>(
    map: Map<'m>,
    local: DVec2,
    filter: &MarkFilter,
    [mut limit, shift]: [f64; 2],
    visit: &mut dyn FnMut(Course<'m>) -> f64,
) {
    let mut markless = Markless::NONE;
    let start = round_up(limit + shift);
    index::visit(map.tables(), local, None, start, |leaf, qx, qy, mut bound| {
        let (lanes, segments) = (leaf.lane(), leaf.segment());
        let lower = index::lower_bounds(leaf, qx, qy, None);
        let mut open = index::places_within(&lower, bound);
        while let Some(k) = index::least(&lower, open) {
            open &= !(1 << k);
            each_course(map, lanes[k], segments[k], filter, &mut markless, |course| {
                limit = visit(course);
            });
            bound = bound.min(round_up(limit + shift));
            open &= index::places_within(&lower, bound);
        }
        bound
    });
}

/// Visits each course along a stretch of the index.
#[inline]
pub(super) fn each_course<'m>(
    map: Map<'m>,
    row: u32,
    segment: u16,
    filter: &MarkFilter,
    markless: &mut Markless,
    mut visit: impl FnMut(Course<'m>),
) {
    // What stands for no lane is among them at first.
    if markless.lanes.contains(&row) {
        return;
    }
    let lane = Lane::new(map, row).filter(|lane| filter.types.contains(lane.kind()));
    let mut slab: Option<Slab<'m>> = None;
    let mut has_marks = false;
    if let Some(lane) = lane {
        each_owner(&lane, filter, |owner| {
            if owner.has_mark_of(filter.kinds) {
                has_marks = true;
                slab = slab.or_else(|| area::slab(&lane, usize::from(segment)));
                slab.iter().for_each(|slab| course::along(owner, slab, filter, &mut visit));
            }
        });
    }
    if !has_marks {
        markless.add(row);
    }
}
