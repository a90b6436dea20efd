//! Where a stretch of a lane is cut into parts before its density is integrated.

/// Deviations to each side of a place where the density changes that are a part of their own.
const AROUND: f64 = 3.0;
/// Cuts nearer to each other than this, in the deviations of the latter, are one.
const LEAST_PART: f64 = 0.5;
/// Most cuts: for the corners, and for some places where a border passes one.
const MOST: usize = 96;

/// Places between two others, in any order.
pub(super) struct Cuts {
    pub(super) from: f64,
    pub(super) to: f64,
    /// Each with the deviation around it.
    places: [(f64, f64); MOST],
    count: usize,
}

impl Cuts {
    pub(super) fn new(from: f64, to: f64) -> Self {
        Self { from, to, places: [(0.0, 0.0); MOST], count: 0 }
    }

    /// Adds what lies around a place; without one that lies beyond the ends, or for which there is no room.
    pub(super) fn add(&mut self, s: f64, deviation: f64) {
        for place in [s - AROUND * deviation, s + AROUND * deviation] {
            let margin = LEAST_PART * deviation;
            if let Some(free) = self.places.get_mut(self.count)
                && self.from + margin < place
                && place < self.to - margin
            {
                *free = (place, deviation);
                self.count += 1;
            }
        }
    }

    /// Tells of the parts in order.
    pub(super) fn each_part(&mut self, mut tell: impl FnMut(f64, f64)) {
        let places = self.places.get_mut(..self.count).unwrap_or_default();
        places.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let mut begin = self.from;
        for (place, deviation) in places {
            if *place > begin + LEAST_PART * *deviation {
                tell(begin, *place);
                begin = *place;
            }
        }
        tell(begin, self.to);
    }
}
