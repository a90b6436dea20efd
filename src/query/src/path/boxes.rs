//! Boxes over a path's spans, so that a search looks at few of them.
//!
//! They are in single precision from a place of the path, eight by eight, so that a search compares four at once. What that rounds is
//! in the bound of a search ([`Boxes::reach`]).

use super::Span;
use crate::nearest::round_up;
use glam::{DVec2, Vec2, Vec4};

/// Spans under a box, and boxes under one of the next level.
pub(super) const WIDTH: usize = 8;

/// A rectangle along the axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    low: DVec2,
    high: DVec2,
}

impl Extent {
    pub(super) fn of(points: impl IntoIterator<Item = DVec2>) -> Self {
        let nothing = Self { low: DVec2::INFINITY, high: DVec2::NEG_INFINITY };
        points
            .into_iter()
            .fold(nothing, |own, point| Self { low: own.low.min(point), high: own.high.max(point) })
    }

    fn with(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    pub(super) fn meets(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }
}

/// Spans in a row: the rectangle around them, and where they begin and end along the path `[m]`.
#[derive(Clone, Copy, Debug)]
struct SpanBox {
    extent: Extent,
    along: [f64; 2],
}

impl SpanBox {
    /// With those that follow.
    fn with(self, next: Self) -> Self {
        Self { extent: self.extent.with(next.extent), along: [self.along[0], next.along[1]] }
    }
}

/// What single precision may cost a distance, as a share of it and of the coordinates.
const ROUNDING: f64 = 1e-5;
/// Coordinates have 24 bits; differences, products and roots take some of the last ones.
const COORDINATES: f64 = 1e-6;

/// Eight numbers.
type Eight = [f32; WIDTH];

/// Eight numbers as two times four.
#[inline(always)]
fn fours(values: &Eight) -> [Vec4; 2] {
    let [a, b, c, d, e, f, g, h] = *values;
    [Vec4::new(a, b, c, d), Vec4::new(e, f, g, h)]
}

/// Which of eight numbers are not above a limit, as bits.
#[inline]
pub(super) fn within(values: &Eight, limit: f32) -> u32 {
    let limit = Vec4::splat(limit);
    let [low, high] = fours(values).map(|four| four.cmple(limit).bitmask());
    low | high << 4
}

/// The least of eight numbers.
#[inline]
pub(super) fn least(values: &Eight) -> f32 {
    let [low, high] = fours(values);
    low.min(high).min_element()
}

/// What is looked for: a place, and between which S.
#[derive(Clone, Copy)]
pub(super) struct Wanted {
    place: Vec2,
    among: [f32; 2],
}

/// S at the beginning and end of eight things, each rounded outwards.
#[derive(Clone, Copy)]
struct Alongs([Eight; 2]);

impl Alongs {
    const NOWHERE: Self = Self([[f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]]);

    fn set(&mut self, i: usize, [from, to]: [f64; 2]) {
        let [begin, end] = &mut self.0;
        (begin[i], end[i]) = (round_down(from), round_up(to));
    }

    /// Squares, infinite where nothing is between two S.
    #[inline(always)]
    fn only(&self, squares: [Vec4; 2], [low, high]: [f32; 2]) -> Eight {
        let (begin, end) = (fours(&self.0[0]), fours(&self.0[1]));
        let mut out = [0.0; WIDTH];
        for k in 0..2 {
            let inside = end[k].cmpge(Vec4::splat(low)) & begin[k].cmple(Vec4::splat(high));
            let own = Vec4::select(inside, squares[k], Vec4::INFINITY).to_array();
            out[4 * k..4 * k + 4].copy_from_slice(&own);
        }
        out
    }
}

/// Eight boxes, those that are none beyond all S.
#[derive(Clone, Copy)]
struct Overs {
    low: [Eight; 2],
    high: [Eight; 2],
    along: Alongs,
}

impl Overs {
    const NONE: Self =
        Self { low: [[0.0; WIDTH]; 2], high: [[0.0; WIDTH]; 2], along: Alongs::NOWHERE };

    #[inline(always)]
    fn squared_distances(&self, wanted: &Wanted) -> Eight {
        let mut squares = [Vec4::ZERO; 2];
        for (axis, at) in wanted.place.to_array().into_iter().enumerate() {
            let (low, high, at) =
                (fours(&self.low[axis]), fours(&self.high[axis]), Vec4::splat(at));
            for k in 0..2 {
                let away = (low[k] - at).max(at - high[k]).max(Vec4::ZERO);
                squares[k] += away * away;
            }
        }
        self.along.only(squares, wanted.among)
    }
}

/// What a search needs of eight spans: their chords.
#[derive(Clone, Copy)]
struct Chords {
    middle: [Eight; 2],
    way: [Eight; 2],
    /// Half the lengths `[m]`.
    half: Eight,
    along: Alongs,
}

impl Chords {
    const NONE: Self = Self {
        middle: [[0.0; WIDTH]; 2],
        way: [[0.0; WIDTH]; 2],
        half: [0.0; WIDTH],
        along: Alongs::NOWHERE,
    };

    #[inline(always)]
    fn squared_distances(&self, wanted: &Wanted) -> Eight {
        let [x, y] = [0, 1].map(|axis| fours(&self.middle[axis]));
        let [cos, sin] = [0, 1].map(|axis| fours(&self.way[axis]));
        let (half, [px, py]) = (fours(&self.half), wanted.place.to_array().map(Vec4::splat));
        let mut squares = [Vec4::ZERO; 2];
        for k in 0..2 {
            let (dx, dy) = (px - x[k], py - y[k]);
            let ahead = ((dx * cos[k] + dy * sin[k]).abs() - half[k]).max(Vec4::ZERO);
            let beside = cos[k] * dy - sin[k] * dx;
            squares[k] = ahead * ahead + beside * beside;
        }
        self.along.only(squares, wanted.among)
    }
}

/// Levels of boxes, the lowest first, each over [`WIDTH`] of what is below; the last has one.
#[derive(Clone, Default)]
pub(super) struct Boxes {
    /// What coordinates count from, relative to the local origin `[m]`.
    origin: DVec2,
    /// What single precision may cost a distance, but for its share `[m]`.
    rounding: f64,
    chords: Vec<Chords>,
    all: Vec<Overs>,
    /// Where each level begins in `all`.
    levels: Vec<usize>,
    /// The boxes of a level, while they are made.
    own: Vec<SpanBox>,
}

impl Boxes {
    pub(super) fn clear(&mut self) {
        self.chords.clear();
        self.all.clear();
        self.levels.clear();
        self.own.clear();
    }

    /// Boxes over these spans instead.
    pub(super) fn rebuild(&mut self, spans: &[Span]) {
        self.clear();
        self.origin = spans.first().map_or(DVec2::ZERO, |span| span.ends[0]);
        let origin = self.origin;
        for some in spans.chunks(WIDTH) {
            let mut chords = Chords::NONE;
            for (i, span) in some.iter().enumerate() {
                let [a, b] = span.ends.map(|end| end - origin);
                let (middle, way) = (0.5 * (a + b), (b - a).normalize_or(DVec2::X));
                for axis in 0..2 {
                    chords.middle[axis][i] = middle[axis] as f32;
                    chords.way[axis][i] = way[axis] as f32;
                }
                chords.half[i] = (0.5 * a.distance(b)) as f32;
                chords.along.set(i, [span.along, span.end()]);
            }
            self.chords.push(chords);
            let own = some.iter().map(|span| {
                let slack = DVec2::splat(span.slack);
                let ends = span.ends.map(|end| end - origin);
                SpanBox {
                    extent: Extent::of(ends.iter().flat_map(|end| [*end - slack, *end + slack])),
                    along: [span.along, span.end()],
                }
            });
            self.own.extend(own.reduce(SpanBox::with));
        }
        let whole = self.own.iter().copied().reduce(SpanBox::with);
        let farthest =
            whole.map_or(0.0, |own| own.extent.low.abs().max(own.extent.high.abs()).max_element());
        self.rounding = COORDINATES * farthest;
        // Of each level the boxes above it are made, in place.
        while self.own.len() > 1 {
            self.levels.push(self.all.len());
            let count = self.own.len().div_ceil(WIDTH);
            for number in 0..count {
                let end = self.own.len().min((number + 1) * WIDTH);
                let some = self.own.get(number * WIDTH..end).unwrap_or(&[]);
                let mut overs = Overs::NONE;
                for (i, SpanBox { extent: own, along }) in some.iter().enumerate() {
                    for axis in 0..2 {
                        overs.low[axis][i] = round_down(own.low[axis]);
                        overs.high[axis][i] = round_up(own.high[axis]);
                    }
                    overs.along.set(i, *along);
                }
                self.all.push(overs);
                if let Some(own) = some.iter().copied().reduce(SpanBox::with)
                    && let Some(place) = self.own.get_mut(number)
                {
                    *place = own;
                }
            }
            self.own.truncate(count);
        }
    }

    /// What a search for a place (relative to the local origin) compares with.
    pub(super) fn wanted(&self, local: DVec2, [low, high]: [f64; 2]) -> Wanted {
        Wanted { place: (local - self.origin).as_vec2(), among: [round_down(low), round_up(high)] }
    }

    /// The square of a distance, not smaller than what squares of things may be that are no farther away.
    #[inline]
    pub(super) fn reach(&self, distance: f64) -> f32 {
        let reach = distance * (1.0 + ROUNDING) + self.rounding;
        round_up(reach * reach)
    }

    /// The highest level; level 0 are the spans.
    pub(super) fn top(&self) -> usize {
        self.levels.len()
    }

    /// Squares of the distances of what lies under a box of a level, eight spans or boxes.
    #[inline]
    pub(super) fn squared_distances(&self, level: usize, number: usize, wanted: &Wanted) -> Eight {
        match level.checked_sub(1).map(|below| self.levels.get(below)) {
            None => self
                .chords
                .get(number)
                .map_or([f32::INFINITY; WIDTH], |own| own.squared_distances(wanted)),
            Some(from) => {
                let own = from.and_then(|from| self.all.get(from + number));
                own.map_or([f32::INFINITY; WIDTH], |own| own.squared_distances(wanted))
            }
        }
    }
}

/// To single precision, never larger.
fn round_down(value: f64) -> f32 {
    let rounded = value as f32;
    if f64::from(rounded) > value { rounded.next_down() } else { rounded }
}
