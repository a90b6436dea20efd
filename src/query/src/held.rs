//! Stretches of lanes whose rectangles hold a point, in the order in which they are worth a closer look.

use crate::index::LaneSegment;

/// Stretches that are looked at together.
const TOGETHER: usize = 8;
/// Steps of a leaf by which the line through a segment may be off: both ends are written in steps, an end that would be the start is moved by one, and
/// single precision rounds less.
const STEPS_OFF: f32 = 2.0;

/// How far the centre of a lane may be from the line through a segment of it `[m]`, by the map's tolerance and the leaf's step.
#[inline]
pub(crate) fn slack(tolerance: f32, step: f32) -> f32 {
    tolerance + STEPS_OFF * step
}

/// A stretch whose rectangle holds a point.
#[derive(Clone, Copy)]
pub(crate) struct HeldBy {
    pub(crate) stretch: LaneSegment,
    /// The lane's centre is not nearer to the point than this `[m]`.
    pub(crate) off_center: f32,
}

/// Some stretches whose rectangles hold a point, the one whose centre may be nearest first.
pub(crate) struct Held {
    stretches: [HeldBy; TOGETHER],
    count: usize,
    /// How far a lane's centre may be from its line `[m]`, if nearer centres come first.
    tolerance: f32,
    /// Of the stretches so far, the least of what a centre can be off at most `[m]`. Only what is read ahead depends on it.
    nearest: f32,
}

impl Held {
    /// None yet. Without a tolerance nothing is known of the centres.
    pub(crate) fn new(tolerance: Option<f64>) -> Self {
        Self {
            stretches: [HeldBy { stretch: LaneSegment::NONE, off_center: 0.0 }; TOGETHER],
            count: 0,
            tolerance: tolerance.map_or(f32::INFINITY, |tolerance| tolerance as f32),
            nearest: f32::INFINITY,
        }
    }

    #[inline]
    pub(crate) fn is_full(&self) -> bool {
        self.count == TOGETHER
    }

    #[inline]
    pub(crate) fn clear(&mut self) {
        self.count = 0;
    }

    /// Adds a stretch by the squared distance of the point from the line through its segment `[m²]`, and the leaf's step `[m]`. Whether it may
    /// well be the nearest.
    #[inline(always)]
    pub(crate) fn add(&mut self, stretch: LaneSegment, beside_squared: f32, step: f32) -> bool {
        let (beside, slack) = (beside_squared.sqrt(), slack(self.tolerance, step));
        let off_center = beside - slack;
        if beside + slack < self.nearest {
            self.nearest = beside + slack;
        }
        // Insertion keeps the nearest first.
        let mut place = self.count.min(TOGETHER - 1);
        while place > 0 && off_center < self.stretches[place - 1].off_center {
            self.stretches[place] = self.stretches[place - 1];
            place -= 1;
        }
        self.stretches[place] = HeldBy { stretch, off_center };
        self.count = (self.count + 1).min(TOGETHER);
        off_center <= self.nearest
    }

    /// The stretches, nearest first.
    #[inline]
    pub(crate) fn stretches(&self) -> &[HeldBy] {
        self.stretches.get(..self.count).unwrap_or_default()
    }

    /// As [`Self::stretches`], those that may well be the nearest.
    #[inline]
    pub(crate) fn promising(&self) -> &[HeldBy] {
        let stretches = self.stretches();
        let count = stretches.iter().take_while(|held| held.off_center <= self.nearest).count();
        stretches.get(..count).unwrap_or_default()
    }
}
