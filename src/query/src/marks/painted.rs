//! Points along what is painted as an object: its markings, its borders of paint and kerb, and the outline of what is painted as a whole.

use super::MarkFilter;
use super::points::{MarkPoint, MarkSource};
use crate::class_set::ClassSet;
use crate::map::Map;
use crate::objects::{ObjectOutline, ObjectPlacement};
use crate::region::Region;
use glam::{DVec2, DVec3};
use mapd_archive::{Class, ObjectShape, ObjectSide, RoadMarkColor, RoadMarkKind};

/// What is painted as a whole: the outline is where the paint ends.
const PAINTED: ClassSet = LINES
    .with(Class::Crosswalk)
    .with(Class::BicycleCrossing)
    .with(Class::RestrictedArea)
    .with(Class::Arrow)
    .with(Class::SpeedMarking)
    .with(Class::Marking);
/// What fills its box where that is all that the file gives; the box of another is no edge of paint.
const LINES: ClassSet =
    ClassSet::NONE.with(Class::StopLine).with(Class::WaitingLine).with(Class::LaneLine);
/// Kind of a parking space's marking that is none (OpenDRIVE 1.4).
const NO_MARKING: &str = "none";
/// Longer lines `[m]` are none that anybody painted, and have no points.
const LONGEST: f64 = 1e4;
/// Area of an outline by the square of its length up to which it is a line.
const NO_AREA: f64 = 1e-4;

/// A line along an object, as a pattern of strokes.
#[derive(Clone, Copy)]
struct Strokes {
    /// Where the first one begins, and how far before its end the line ends `[m]`.
    start: f64,
    stop: f64,
    /// Lengths of stroke and gap `[m]`; no gap: one stroke.
    stroke: f64,
    gap: f64,
    /// Height above the object's foot `[m]`.
    rise: f64,
}

impl Strokes {
    const WHOLE: Self = Self { start: 0.0, stop: 0.0, stroke: 0.0, gap: 0.0, rise: 0.0 };

    fn has_gaps(&self) -> bool {
        self.stroke > 0.0 && self.gap > 0.0
    }

    /// Whether there is paint, so far behind the start of the first stroke.
    fn paints(&self, along: f64) -> bool {
        !self.has_gaps() || along.rem_euclid(self.stroke + self.gap) <= self.stroke
    }
}

/// Tells of the corners of a line, one after another. Not generic, as are those who take it: the code for each kind of line would be long.
type Corners<'a> = dyn Fn(&mut dyn FnMut(DVec3)) + 'a;

/// What is asked for.
pub(super) struct Asked<'f> {
    pub(super) region: Region,
    pub(super) spacing: f64,
    pub(super) filter: &'f MarkFilter,
}

/// Tells of the points along all painted objects in the region.
pub(super) fn each_point(map: Map<'_>, asked: &Asked<'_>, visit: &mut dyn FnMut(MarkPoint)) {
    if !asked.filter.objects {
        return;
    }
    map.visit_places(asked.region, |place| of_place(&place, asked, visit));
}

fn of_place(place: &ObjectPlacement<'_>, asked: &Asked<'_>, visit: &mut dyn FnMut(MarkPoint)) {
    // Copies without gaps have outlines of their own, which no marking names.
    let mut has_lines = false;
    let source = MarkSource::Line(place.placement_id());
    for marking in place.markings().take_while(|_| !place.is_swept()) {
        if marking.kind() == NO_MARKING {
            continue;
        }
        has_lines = true;
        let strokes = Strokes {
            start: marking.start_offset().max(0.0),
            stop: marking.stop_offset(),
            stroke: marking.stroke_length(),
            gap: marking.gap_length(),
            rise: marking.z_offset(),
        };
        let is_broken = strokes.has_gaps() || marking.kind() == RoadMarkKind::Broken.name();
        let kind = if is_broken { RoadMarkKind::Broken } else { RoadMarkKind::Solid };
        let paint = Paint {
            place,
            asked,
            source,
            kind,
            color: color(marking.color()),
            width: marking.width(),
        };
        if marking.corners().len() > 0 {
            paint.along(&|tell| marking.corners().for_each(tell), &strokes, visit);
        } else if let Some(outline) = marking.outline() {
            paint.around(&outline, outline.is_closed(), &strokes, visit);
        } else if let Some(ends) = marking.side().and_then(|side| side_of(place, side)) {
            paint.along(&|tell| ends.into_iter().for_each(tell), &strokes, visit);
        }
    }
    for border in place.borders().take_while(|_| !place.is_swept()) {
        let kind = match border.kind() {
            "curb" => RoadMarkKind::Curb,
            "paint" => RoadMarkKind::Solid,
            _ => continue,
        };
        has_lines |= kind == RoadMarkKind::Solid;
        let paint = Paint {
            place,
            asked,
            source,
            kind,
            color: RoadMarkColor::NotGiven,
            width: border.width(),
        };
        if border.corners().len() > 0 {
            paint.along(&|tell| border.corners().for_each(tell), &Strokes::WHOLE, visit);
        } else if let Some(outline) = border.outline() {
            paint.around(&outline, outline.is_closed(), &Strokes::WHOLE, visit);
        }
    }
    let class = place.object().class();
    if has_lines || !PAINTED.contains(class) {
        return;
    }
    let written = place.object().materials().map(|material| color(material.road_mark_color()));
    let color = written.into_iter().find(|color| *color != RoadMarkColor::NotGiven);
    let paint = Paint {
        place,
        asked,
        source: MarkSource::Outline(place.placement_id()),
        kind: RoadMarkKind::Solid,
        color: color.unwrap_or(RoadMarkColor::NotGiven),
        width: 0.0,
    };
    for outline in place.outlines() {
        let is_closed = outline.is_closed() && has_area(outline.positions());
        paint.around(&outline, is_closed, &Strokes::WHOLE, visit);
    }
    if place.shape() == ObjectShape::Box && LINES.contains(class) {
        let [front_right, front_left, rear_left, rear_right] = place.corners();
        // Without a width, or a length, it is a line.
        let around = [front_right, front_left, rear_left, rear_right, front_right];
        let line = match (place.length() > 0.0, place.width() > 0.0) {
            (true, true) => &around[..],
            (true, false) => &around[1..3],
            _ => &around[..2],
        };
        paint.along(&|tell| line.iter().copied().for_each(tell), &Strokes::WHOLE, visit);
    }
}

/// Lines of one object that look alike.
struct Paint<'p, 'm> {
    place: &'p ObjectPlacement<'m>,
    asked: &'p Asked<'p>,
    source: MarkSource,
    kind: RoadMarkKind,
    color: RoadMarkColor,
    width: f64,
}

impl Paint<'_, '_> {
    /// As [`Self::along`] an outline, back to its first corner where it is closed.
    fn around(
        &self,
        outline: &ObjectOutline<'_>,
        is_closed: bool,
        strokes: &Strokes,
        visit: &mut dyn FnMut(MarkPoint),
    ) {
        let back = usize::from(is_closed);
        let corners = || outline.positions().chain(outline.positions().take(back));
        self.along(&|tell| corners().for_each(tell), strokes, visit);
    }

    /// Tells of the places along a line, from corner to corner, at multiples of the spacing from the start of its first stroke. `line` tells
    /// of its corners.
    fn along(&self, line: &Corners<'_>, strokes: &Strokes, visit: &mut dyn FnMut(MarkPoint)) {
        if !self.asked.filter.kinds.contains(self.kind) {
            return;
        }
        let each_piece = |tell: &mut dyn FnMut(DVec3, DVec3)| {
            let mut before = None;
            line(&mut |corner| {
                if let Some(from) = before.replace(corner) {
                    tell(from, corner);
                }
            });
        };
        let mut length = 0.0;
        each_piece(&mut |from, to| length += from.distance(to));
        // Also where it is no number.
        let is_paint = length <= LONGEST;
        if !is_paint {
            return;
        }
        let (mut gone, last) = (0.0, length - strokes.stop);
        each_piece(&mut |from, to| {
            let begin = gone;
            gone += from.distance(to);
            self.along_piece([from, to], [begin, gone.min(last.next_up())], strokes, visit);
        });
    }

    /// Tells of the places along a piece of a line, which begins and ends so far along the line.
    fn along_piece(
        &self,
        [from, to]: [DVec3; 2],
        [begin, end]: [f64; 2],
        strokes: &Strokes,
        visit: &mut dyn FnMut(MarkPoint),
    ) {
        let Asked { region, spacing, .. } = *self.asked;
        let piece = from.distance(to);
        let Some([low, high]) = inside([from, to].map(DVec3::truncate), region) else { return };
        // One more on either side, so that rounding leaves none out; each is looked at once more.
        let first = ((begin + low * piece - strokes.start) / spacing).floor() - 1.0;
        let most = (begin + high * piece - strokes.start) / spacing + 1.0;
        let mut number = first.max(0.0);
        while number <= most {
            let along = number * spacing;
            let at = strokes.start + along;
            number += 1.0;
            // What ends a piece belongs to the next one.
            if !(at >= begin && at < end && strokes.paints(along)) {
                continue;
            }
            let position = from.lerp(to, (at - begin) / piece) + strokes.rise * DVec3::Z;
            if region.holds(position.truncate()) {
                visit(MarkPoint {
                    position,
                    source: self.source,
                    s: self.place.s(),
                    kind: self.kind,
                    color: self.color,
                    width: self.width,
                });
            }
        }
    }
}

/// Which part of a straight line, from 0 to 1, a rectangle holds; none where it holds nothing.
fn inside([from, to]: [DVec2; 2], region: Region) -> Option<[f64; 2]> {
    let way = to - from;
    let (mut low, mut high) = (0.0f64, 1.0f64);
    for axis in 0..2 {
        let (way, least, most) =
            (way[axis], region.low[axis] - from[axis], region.high[axis] - from[axis]);
        if way == 0.0 {
            if !(least <= 0.0 && 0.0 <= most) {
                return None;
            }
            continue;
        }
        let (a, b) = (least / way, most / way);
        (low, high) = (low.max(a.min(b)), high.min(a.max(b)));
    }
    // A little more than what rounding takes away from a corner that it only just holds.
    (low <= high + f64::EPSILON.sqrt()).then_some([low, high])
}

/// Both ends of a side of the object's box: from the rear to the front, or from the right to the left. None of an object without a box.
fn side_of(place: &ObjectPlacement<'_>, side: ObjectSide) -> Option<[DVec3; 2]> {
    if place.shape() != ObjectShape::Box {
        return None;
    }
    let [front_right, front_left, rear_left, rear_right] = place.corners();
    match side {
        ObjectSide::Left => Some([rear_left, front_left]),
        ObjectSide::Right => Some([rear_right, front_right]),
        ObjectSide::Front => Some([front_right, front_left]),
        ObjectSide::Rear => Some([rear_right, rear_left]),
        _ => None,
    }
}

/// Whether corners enclose more than a line.
fn has_area(corners: impl ExactSizeIterator<Item = DVec3>) -> bool {
    let (mut first, mut before) = (None, DVec2::ZERO);
    let (mut doubled, mut length) = (0.0, 0.0);
    for corner in corners {
        let own = corner.truncate() - *first.get_or_insert(corner.truncate());
        doubled += before.perp_dot(own);
        length += before.distance(own);
        before = own;
    }
    0.5 * f64::abs(doubled) > NO_AREA * length * length
}

/// The colour of a name.
fn color(name: &str) -> RoadMarkColor {
    let known = RoadMarkColor::ALL.iter().find(|color| color.name() == name);
    known.copied().unwrap_or(RoadMarkColor::NotGiven)
}
