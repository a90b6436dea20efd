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
    pub(super) fn squared_distance(&self, point: DVec2) -> f64 {
        (self.low - point).max(point - self.high).max(DVec2::ZERO).length_squared()
    }
}

/// Levels of boxes, the lowest first, each over [`WIDTH`] of what is below; the last has one.
#[derive(Clone, Default)]
pub(super) struct Boxes {
    all: Vec<Extent>,
    /// Where each level begins.
    levels: Vec<usize>,
}

impl Boxes {
    pub(super) fn clear(&mut self) {
        self.all.clear();
        self.levels.clear();
    }

    /// Boxes over these spans instead.
    pub(super) fn rebuild(&mut self, spans: &[Span]) {
        self.clear();
        self.levels.push(0);
        let own = |span: &Span| {
            let slack = DVec2::splat(span.slack);
            Extent::of(span.ends.iter().flat_map(|end| [*end - slack, *end + slack]))
        };
        let some = |all: &[Span]| all.iter().map(own).reduce(Extent::with);
        self.all.extend(spans.chunks(WIDTH).filter_map(some));
        let mut below = 0;
        while self.all.len() - below > 1 {
            let end = self.all.len();
            self.levels.push(end);
            while below < end {
                let next = end.min(below + WIDTH);
                let all = self.all.get(below..next).unwrap_or(&[]);
                let Some(own) = all.iter().copied().reduce(Extent::with) else { break };
                self.all.push(own);
                below = next;
            }
        }
    }

    /// The highest level.
    pub(super) fn top(&self) -> usize {
        self.levels.len().saturating_sub(1)
    }

    /// A level's boxes.
    pub(super) fn level(&self, level: usize) -> &[Extent] {
        let from = self.levels.get(level).copied().unwrap_or(0);
        let end = self.levels.get(level + 1).copied().unwrap_or(self.all.len());
        self.all.get(from..end).unwrap_or(&[])
    }
}
