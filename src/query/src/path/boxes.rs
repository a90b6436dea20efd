//! Boxes over a path's spans, so that a search looks at few of them.

use super::Span;
use glam::DVec2;

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

    /// Square of a point's distance, 0 inside.
    #[inline]
    fn squared_distance(&self, point: DVec2) -> f64 {
        (self.low - point).max(point - self.high).max(DVec2::ZERO).length_squared()
    }
}

/// What lies over some spans that follow each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Over {
    extent: Extent,
    /// S at the beginning and end.
    along: [f64; 2],
}

impl Over {
    fn with(self, later: Self) -> Self {
        Self { extent: self.extent.with(later.extent), along: [self.along[0], later.along[1]] }
    }

    /// Square of a point's distance, 0 inside; infinite where none of it is between two S.
    #[inline]
    pub(super) fn squared_distance(&self, point: DVec2, [low, high]: [f64; 2]) -> f64 {
        if self.along[1] < low || self.along[0] > high {
            return f64::INFINITY;
        }
        self.extent.squared_distance(point)
    }
}

/// What a search needs of a span: its chord.
#[derive(Clone, Copy)]
pub(super) struct Chord {
    middle: DVec2,
    way: DVec2,
    /// Half its length `[m]`.
    half: f64,
    /// S at the span's beginning and end.
    along: [f64; 2],
}

impl Chord {
    /// As of what lies over it.
    #[inline]
    pub(super) fn squared_distance(&self, point: DVec2, [low, high]: [f64; 2]) -> f64 {
        let away = point - self.middle;
        let (ahead, beside) = (away.dot(self.way).abs() - self.half, self.way.perp_dot(away));
        let ahead = if ahead > 0.0 { ahead } else { 0.0 };
        let is_apart = self.along[1] < low || self.along[0] > high;
        if is_apart { f64::INFINITY } else { ahead * ahead + beside * beside }
    }
}

/// Levels of boxes, the lowest first, each over [`WIDTH`] of what is below; the last has one.
#[derive(Clone, Default)]
pub(super) struct Boxes {
    chords: Vec<Chord>,
    all: Vec<Over>,
    /// Where each level begins.
    levels: Vec<usize>,
}

impl Boxes {
    pub(super) fn clear(&mut self) {
        self.chords.clear();
        self.all.clear();
        self.levels.clear();
    }

    /// Boxes over these spans instead.
    pub(super) fn rebuild(&mut self, spans: &[Span]) {
        self.clear();
        self.levels.push(0);
        let chord = |span: &Span| {
            let [a, b] = span.ends;
            let along = [span.along, span.end()];
            let (middle, way) = (0.5 * (a + b), (b - a).normalize_or(DVec2::X));
            Chord { middle, way, half: 0.5 * a.distance(b), along }
        };
        self.chords.extend(spans.iter().map(chord));
        let own = |span: &Span| {
            let slack = DVec2::splat(span.slack);
            let extent = Extent::of(span.ends.iter().flat_map(|end| [*end - slack, *end + slack]));
            Over { extent, along: [span.along, span.end()] }
        };
        let some = |all: &[Span]| all.iter().map(own).reduce(Over::with);
        self.all.extend(spans.chunks(WIDTH).filter_map(some));
        let mut below = 0;
        while self.all.len() - below > 1 {
            let end = self.all.len();
            self.levels.push(end);
            while below < end {
                let next = end.min(below + WIDTH);
                let all = self.all.get(below..next).unwrap_or(&[]);
                let Some(own) = all.iter().copied().reduce(Over::with) else { break };
                self.all.push(own);
                below = next;
            }
        }
    }

    /// A chord for each span.
    pub(super) fn chords(&self) -> &[Chord] {
        &self.chords
    }

    /// The highest level.
    pub(super) fn top(&self) -> usize {
        self.levels.len().saturating_sub(1)
    }

    /// A level's boxes.
    pub(super) fn level(&self, level: usize) -> &[Over] {
        let from = self.levels.get(level).copied().unwrap_or(0);
        let end = self.levels.get(level + 1).copied().unwrap_or(self.all.len());
        self.all.get(from..end).unwrap_or(&[])
    }
}
