//! From a route's steps to a path.

use super::along::center;
use super::arc::Arc;
use super::change::{LaneChange, MOST_PARTS, Shift, ShiftAt, shift_at};
use super::room::{Changes, is_change};
use super::speed::{Way, note_ways};
use super::{Path, PathBuffer, PathError, PathJoint, PathOptions, Piece, Span};
use crate::area;
use crate::error::QueryError;
use crate::extents::SRange;
use crate::ids::LaneId;
use crate::lane::Lane;
use crate::map::Map;
use crate::profile::At;
use crate::route::{Enter, RouteStep};
use glam::DVec2;
use mapd_archive::NONE;
use mapd_geometry::normalize_angle;

/// A gap up to this is rounding and not listed `[m]`.
const GAP: f64 = 1e-6;
/// A kink up to this is rounding and not listed `[rad]`.
const KINK: f64 = 1e-6;
/// S within a span may differ from what is driven by about this `[m]`; else the span is halved.
const UNEVEN: f64 = 1e-4;
/// Times that the span between two stations may be halved: those of tight bends are a metre long.
const MOST_HALVINGS: u32 = 6;
/// Share of what the growth at a span's end says too much, by which S is off in between: if the growth has a square term, which is the most.
const OFF: f64 = 0.1;
/// Bound on a span's `bend`: S grows with s all along.
const MOST_BENT: f64 = 0.99;
/// Step of s by which the length of a curve is taken `[m]`, and most steps on half a span.
const LENGTH_STEP: f64 = 0.25;
const MOST_LENGTH_STEPS: f64 = 32.0;
/// Shares of a span at which it is compared with a circle.
const PLACES: [f64; 3] = [0.2, 0.5, 0.8];
/// A span that lies this near to a circle is one `[m]`.
const EXACT: f64 = 1e-9;
/// What is added to the bound on a span's distance from its chord, for the rounding of its length `[m]`.
const ROUNDING: f64 = 1e-3;

impl<'a> Map<'a> {
    /// The path along a route's steps, written into a buffer. The steps may be those of [`Map::route`] or [`steps_of_lanes`], or made
    /// by hand.
    ///
    /// Errors: [`PathError`], which names the step; options out of their domain.
    pub fn path<'b>(
        &self,
        steps: &[RouteStep],
        options: &PathOptions,
        buffer: &'b mut PathBuffer,
    ) -> Result<Path<'a, 'b>, PathError> {
        buffer.steps.clear();
        buffer.steps.extend_from_slice(steps);
        buffer.pieces.clear();
        buffer.spans.clear();
        buffer.joints.clear();
        buffer.shifts.clear();
        buffer.open.clear();
        buffer.boxes.clear();
        buffer.content = self.content();
        options.check()?;
        let mut before: Option<&RouteStep> = None;
        let mut builder = Builder {
            map: *self,
            changes: Changes { map: *self, steps, options },
            options,
            buffer,
            entered: Enter::Start,
            before: None,
            short: false,
        };
        for (number, step) in steps.iter().enumerate() {
            let wrong = |source| PathError::Step { step: number, source };
            let lane = self.lane(step.lane).map_err(wrong)?;
            let places = [step.s_from, step.s_to, step.s_latest];
            if !places.iter().all(|s| s.is_finite()) {
                return Err(wrong(QueryError::NotFinite));
            }
            let (low, high) = (lane.section().s_start(), lane.section().s_end());
            if places.iter().any(|s| *s < low - GAP || *s > high + GAP) {
                return Err(PathError::OutsideLane { step: number });
            }
            if (step.s_to - step.s_from) * sign(step.forward) < 0.0 {
                return Err(PathError::Backwards { step: number });
            }
            if let Some(before) = before {
                follows(*self, before, step, number)?;
            }
            builder.add(&lane, step, number);
            before = Some(step);
        }
        if builder.buffer.spans.is_empty() {
            return Err(PathError::Empty);
        }
        let PathBuffer { boxes, spans, slack, .. } = buffer;
        boxes.rebuild(spans);
        *slack = spans.iter().map(|span| span.slack).fold(0.0, f64::max);
        note_ways(*self, buffer);
        Ok(Path { map: *self, buffer })
    }
}

/// The steps over lanes that follow each other, as [`LaneSequences`](crate::route::LaneSequences) lists them, from s on the first to s on the last `[m]`, each
/// moved to its lane's nearer end where it lies beyond. Each lane is driven in its own direction; one for both directions in the one that links ask for, and alone
/// in the one from s to s. `out` is emptied first.
///
/// Errors: by the step's number, an id of another map, an s that is not finite, a lane that does not follow the one before.
pub fn steps_of_lanes(
    map: Map<'_>,
    lanes: &[LaneId],
    ends: [f64; 2],
    out: &mut Vec<RouteStep>,
) -> Result<(), PathError> {
    let last = lanes.len().saturating_sub(1);
    for (step, s) in [0, last].into_iter().zip(ends) {
        if !s.is_finite() {
            return Err(PathError::Step { step, source: QueryError::NotFinite });
        }
    }
    let Some(first) = lanes.first() else {
        out.clear();
        return Ok(());
    };
    let wrong = |source| PathError::Step { step: 0, source };
    let first = map.lane(*first).map_err(wrong)?;
    let own = first.is_forward();
    let begins_back =
        last == 0 && first.is_bidirectional() && (ends[1] - ends[0]) * sign(own) < 0.0;
    let begin = own != begins_back;
    let done = chain(map, lanes, ends, begin, out);
    if done.is_ok() || last == 0 || !first.is_bidirectional() {
        return done;
    }
    // The other way, if the lanes follow each other there.
    let length = out.len();
    match chain(map, lanes, ends, !begin, out) {
        Ok(()) => Ok(()),
        Err(farther) if out.len() > length => Err(farther),
        Err(_) => done,
    }
}

/// Steps over lanes of which the first one is driven in a direction, as far as they follow each other.
fn chain(
    map: Map<'_>,
    lanes: &[LaneId],
    [from, to]: [f64; 2],
    begin: bool,
    out: &mut Vec<RouteStep>,
) -> Result<(), PathError> {
    out.clear();
    for (number, id) in lanes.iter().enumerate() {
        let lane = map.lane(*id).map_err(|source| PathError::Step { step: number, source })?;
        let (low, high) = (lane.section().s_start(), lane.section().s_end());
        let inside = |s: f64| mapd_geometry::clamp(s, low, high);
        let driven = |forward: bool| {
            let [begin, end] = if forward { [low, high] } else { [high, low] };
            let (s_from, enter) =
                if number == 0 { (inside(from), Enter::Start) } else { (begin, Enter::Ahead) };
            let s_to = if number + 1 == lanes.len() { inside(to) } else { end };
            RouteStep { lane: *id, forward, enter, s_from, s_to, s_latest: s_from }
        };
        let own = lane.is_forward();
        let step = match out.last() {
            None => driven(begin),
            Some(before) => match follows(map, before, &driven(own), number) {
                Ok(()) => driven(own),
                Err(error) => {
                    let other = Some(driven(!own)).filter(|_| lane.is_bidirectional());
                    let other = other.filter(|step| follows(map, before, step, number).is_ok());
                    other.ok_or(error)?
                }
            },
        };
        out.push(step);
    }
    Ok(())
}

impl Path<'_, '_> {
    /// The steps of the part of the path between two S, of the steps that it was built on: what is left to drive (`[S, length]`), or what is driven
    /// until a place (`[0, S]`). S outside is moved to the nearer end. `out` is emptied first.
    ///
    /// Errors: two S that are not finite or not in order; steps that are not the path's.
    pub fn steps_between(
        &self,
        steps: &[RouteStep],
        [from, to]: [f64; 2],
        out: &mut Vec<RouteStep>,
    ) -> Result<(), PathError> {
        out.clear();
        if !(from <= to && (to - from).is_finite()) {
            return Err(PathError::NotInOrder);
        }
        let place = |along: f64, later: bool| {
            let along = mapd_geometry::clamp(along, 0.0, self.length());
            let mut span = self.span_at(along)?;
            if !later && along <= span.along {
                // At a joint the part that is driven ends with the lane before.
                span = self.buffer.spans.iter().rfind(|own| own.along < along).unwrap_or(span);
            }
            let piece = self.buffer.pieces.get(span.piece as usize)?;
            Some((piece.step as usize, span.s_at(along - span.along)))
        };
        let ends = place(from, true).zip(place(to, from == to));
        let ((first, s_from), (last, s_to)) = ends.ok_or(PathError::Empty)?;
        if self.lanes().any(|lane| steps.get(lane.step).is_none_or(|step| step.lane != lane.lane)) {
            return Err(PathError::OtherSteps);
        }
        out.extend_from_slice(steps.get(first..=last).ok_or(PathError::OtherSteps)?);
        if let Some(begin) = out.first_mut() {
            *begin = RouteStep { enter: Enter::Start, s_from, s_latest: s_from, ..*begin };
        }
        if let Some(end) = out.last_mut() {
            end.s_to = s_to;
            let behind = if end.forward { end.s_latest > s_to } else { end.s_latest < s_to };
            if behind {
                end.s_latest = s_to;
            }
        }
        Ok(())
    }
}

fn sign(forward: bool) -> f64 {
    if forward { 1.0 } else { -1.0 }
}

/// Whether a step follows another.
fn follows(
    map: Map<'_>,
    before: &RouteStep,
    step: &RouteStep,
    number: usize,
) -> Result<(), PathError> {
    let wrong = |source| PathError::Step { step: number, source };
    let (from, to) = (map.lane(before.lane).map_err(wrong)?, step.lane.row());
    let is_it = |node: &crate::graph::LaneNode<'_>| {
        node.row.lane() == to && node.is_forward() == step.forward
    };
    let goes_on = before.lane == step.lane && before.forward == step.forward;
    match step.enter {
        Enter::Start | Enter::Ahead => {
            // A lane may be cut into pieces; the route leaves it at the end of any.
            let mut nodes = from.nodes().filter(|node| node.is_forward() == before.forward);
            let linked = nodes
                .any(|node| node.edges().filter_map(|edge| edge.target()).any(|next| is_it(&next)));
            let here = goes_on && before.s_to == step.s_from;
            if linked || here { Ok(()) } else { Err(PathError::NotLinked { step: number }) }
        }
        Enter::Left | Enter::Right => {
            let left = step.enter == Enter::Left;
            let mut beside = false;
            for node in from.nodes().filter(|node| node.is_forward() == before.forward) {
                let SRange { low, high } = node.s_range();
                if step.s_from < low || step.s_from > high {
                    continue;
                }
                let (next, change) = match left {
                    true => (node.left(), node.change_left()),
                    false => (node.right(), node.change_right()),
                };
                if change.is_some_and(|next| is_it(&next)) {
                    return Ok(());
                }
                beside |= next.is_some_and(|next| is_it(&next));
            }
            Err(match beside {
                true => PathError::ChangeForbidden { step: number },
                false => PathError::NotBeside { step: number },
            })
        }
    }
}

struct Builder<'a, 'b, 'o> {
    map: Map<'a>,
    changes: Changes<'a, 'o>,
    options: &'o PathOptions,
    buffer: &'b mut PathBuffer,
    /// How the next piece is entered, with changes over lanes that are not driven on.
    entered: Enter,
    /// The lane of the step before.
    before: Option<u32>,
    /// Whether the next piece is entered by a change that has no room for its curve.
    short: bool,
}

impl Builder<'_, '_, '_> {
    fn add(&mut self, lane: &Lane<'_>, step: &RouteStep, number: usize) {
        if is_change(step) || !matches!(self.entered, Enter::Left | Enter::Right) {
            self.entered = step.enter;
        }
        self.go_on(lane, step);
        if is_change(step) {
            self.change(lane, step, number);
        }
        self.before = Some(lane.row_number());
        let (low, high) = (step.s_from.min(step.s_to), step.s_from.max(step.s_to));
        if low >= high {
            return;
        }
        let first = self.buffer.spans.len() as u32;
        let piece = self.buffer.pieces.len() as u32;
        let mut shift = self.buffer.shifts.len() as u32;
        let PathBuffer { shifts, open, .. } = &mut *self.buffer;
        shifts.extend(open.iter().map(|own| Shift { piece, ..*own }));
        let segments = usize::from(lane.row.center_count()).saturating_sub(1);
        for i in 0..segments {
            let segment = if step.forward { i } else { segments - 1 - i };
            let Some(slab) = area::slab(lane, segment) else { continue };
            let (from, to) = (slab.s_lo.max(low), slab.s_hi.min(high));
            if from < to {
                let [mut begin, end] = if step.forward { [from, to] } else { [to, from] };
                let hold = 0.5 * (slab.s_lo + slab.s_hi);
                // Between large numbers a part has no end of its own: the last one has all that is left.
                for number in 0..=MOST_PARTS {
                    if begin == end {
                        break;
                    }
                    let along = self.along();
                    let own = self.buffer.shifts.get(shift as usize..).unwrap_or(&[]);
                    shift += own.iter().take_while(|own| own.along[1] <= along).count() as u32;
                    let own = self.buffer.shifts.get(shift as usize);
                    let least = (to - from) / f64::from(MOST_PARTS);
                    let is_cut = own.is_some() && number < MOST_PARTS;
                    let cut =
                        own.filter(|_| is_cut).map_or(end, |own| own.cut([begin, end], least));
                    let cut = if cut == begin { end } else { cut };
                    let number = if own.is_some() { shift } else { NONE };
                    self.span(lane, [begin, cut], hold, [piece, number], MOST_HALVINGS);
                    begin = cut;
                }
            }
        }
        let end = self.buffer.spans.len() as u32;
        if end > first {
            let (lane, forward) = (lane.row_number(), step.forward);
            let step = number as u32;
            let (spans, way) = ([first, end], Way::NONE);
            self.buffer.pieces.push(Piece { lane, forward, step, spans, way });
        }
    }

    /// S up to which the line is made.
    fn along(&self) -> f64 {
        self.buffer.spans.last().map_or(0.0, Span::end)
    }

    /// Takes curves that are not done on to a step's section: beside its lane, the lanes that those before lead to.
    fn go_on(&mut self, lane: &Lane<'_>, step: &RouteStep) {
        let along = self.along();
        let open = &mut self.buffer.open;
        open.retain(|own| along < own.along[1]);
        let before = self.before.and_then(|before| Lane::new(self.map, before));
        if open.is_empty() || before.is_none_or(|own| own.row.section() == lane.row.section()) {
            return;
        }
        let mut next = lane.node_at(step.s_from, step.forward);
        for own in open.iter_mut().rev() {
            let beside = next.and_then(|next| if own.left { next.right() } else { next.left() });
            let from = Lane::new(self.map, own.from);
            let beside = beside.filter(|beside| {
                from.is_some_and(|from| {
                    let targets = from.nodes().flat_map(|node| node.edges());
                    targets.filter_map(|edge| edge.target()).any(|to| to.number == beside.number)
                })
            });
            let Some((to, from)) = next.zip(beside) else {
                open.clear();
                return;
            };
            (own.to, own.from) = (to.row.lane(), from.row.lane());
            next = Some(from);
        }
    }

    /// Begins the curve of a change into a step's lane; where there is no room for one, the line jumps, also out of those that are not done.
    fn change(&mut self, lane: &Lane<'_>, step: &RouteStep, number: usize) {
        let LaneChange::Lateral(_) = self.options.change else { return };
        let along = self.along();
        let done = self.buffer.open.last().map_or(along, |last| last.along[1].max(along));
        let curve = self.changes.place(number, done - along).zip(self.before);
        let Some((curve, from)) = curve else {
            self.short = true;
            self.buffer.open.clear();
            return;
        };
        let to = lane.row_number();
        let left = step.enter == Enter::Left;
        let along = curve.map(|gone| along + gone);
        self.buffer.open.push(Shift { from, to, left, piece: NONE, along });
    }

    /// Adds what is driven between two s, in halves where S bends too much. `number`: of its piece and its curve.
    fn span(&mut self, lane: &Lane<'_>, s: [f64; 2], hold: f64, number: [u32; 2], halvings: u32) {
        let [piece, shift] = number;
        let forward = s[0] < s[1];
        let curves = self.buffer.shifts.get(shift as usize).is_some();
        let along = self.along();
        let shifts = &self.buffer.shifts;
        let at = |s: f64, gone: f64| {
            let own: Option<ShiftAt> = shift_at(shifts, shift, along + gone);
            center(lane, At { s, hold }, forward, own.as_ref()).ok()
        };
        let middle = 0.5 * (s[0] + s[1]);
        let measure = |from: f64, to: f64, gone: f64| match curves {
            false => lane.length_between(from, to),
            true => {
                let line = lane.road().reference_end();
                let growth = |s: f64, gone| at(s, gone).map_or(f64::NAN, |own| own.growth);
                length_of(growth, [from.min(line), to.min(line)], gone)
            }
        };
        let first = measure(s[0], middle, 0.0);
        let halves = [first, measure(middle, s[1], first)];
        let length = halves[0] + halves[1];
        let (Some(a), Some(b)) = (at(s[0], 0.0), at(s[1], length)) else { return };
        if !(length > 0.0 && length.is_finite()) {
            return;
        }
        // S is right in the middle.
        let bend = (halves[1] - halves[0]) * 2.0 / length;
        let bend = mapd_geometry::clamp(bend, -MOST_BENT, MOST_BENT);
        let run = (s[1] - s[0]).abs();
        let promised = [(a.growth, 1.0 - bend), (b.growth, 1.0 + bend)];
        let off = promised.map(|(growth, share)| (growth * run - length * share).abs() * OFF);
        if off[0].max(off[1]) > UNEVEN && halvings > 0 {
            for half in [[s[0], middle], [middle, s[1]]] {
                self.span(lane, half, hold, number, halvings - 1);
            }
            return;
        }
        let origin = self.map.origin();
        let ends = [a.position.truncate() - origin, b.position.truncate() - origin];
        let chord = ends[0].distance(ends[1]);
        // What lies on a line of some length between two points lies in an ellipse around them.
        let slack = 0.5 * (length * length - chord * chord).max(0.0).sqrt() + ROUNDING;
        let turn = normalize_angle(b.heading - a.heading);
        let heading = a.heading;
        let arc = Arc::new(ends, length, turn);
        let mut span =
            Span { along, length, s, bend, ends, heading, turn, slack, arc, piece, shift };
        // Whether it lies on the circle shows in places between.
        let off = |share: f64| {
            let gone = share * length;
            let own = at(span.s_at(gone), gone).map(|own| own.position.truncate() - origin);
            own.map_or(f64::INFINITY, |own| own.distance(span.arc.at(gone)))
        };
        span.arc.is_exact = PLACES.into_iter().all(|share| off(share) <= EXACT);
        self.joint(along, ends[0], heading, piece, curves);
        self.buffer.spans.push(span);
    }

    /// Lists what lies between the last span and one that begins here, on a curve or not.
    fn joint(&mut self, along: f64, begin: DVec2, heading: f64, piece: u32, curved: bool) {
        let Some(last) = self.buffer.spans.last() else {
            (self.entered, self.short) = (Enter::Ahead, false);
            return;
        };
        let gap = last.ends[1].distance(begin);
        let kink = normalize_angle(heading - (last.heading + last.turn));
        let enter = if last.piece == piece { Enter::Ahead } else { self.entered };
        let changes = matches!(enter, Enter::Left | Enter::Right);
        if changes || gap > GAP || kink.abs() > KINK {
            let apart = (!changes || curved) && gap > self.options.broken_gap;
            let broken = apart || kink.abs() > self.options.broken_kink;
            let short = changes && self.short;
            let broken = broken || (short && self.options.shortest_change.is_some());
            self.buffer.joints.push(PathJoint { along, gap, kink, enter, short, broken });
        }
        (self.entered, self.short) = (Enter::Ahead, false);
    }
}

/// Length of a line from one s to another, where its metres per metre of s depend on the length up to there: by Runge and Kutta's method of fourth order.
fn length_of(growth: impl Fn(f64, f64) -> f64, [from, to]: [f64; 2], gone: f64) -> f64 {
    let run = (to - from).abs();
    let steps = mapd_geometry::clamp((run / LENGTH_STEP).ceil(), 1.0, MOST_LENGTH_STEPS);
    let (step, way) = (run / steps, (to - from) / steps);
    let mut along = gone;
    for i in 0..steps as usize {
        let s = from + way * i as f64;
        let a = growth(s, along);
        let b = growth(s + 0.5 * way, along + 0.5 * step * a);
        let c = growth(s + 0.5 * way, along + 0.5 * step * b);
        let d = growth(s + way, along + step * c);
        along += step / 6.0 * (a + 2.0 * (b + c) + d);
    }
    along - gone
}
