//! In which order places are asked: along a curve that keeps near ones together.

use glam::DVec2;

/// Places that are ordered at once; of more, one such part after another, so that memory is bounded.
const PART: usize = 1 << 20;
/// Cells of the curve in either direction at most.
const CELLS: f64 = 65_535.0;
/// Width of a cell at least `[m]`: a finer order brings places no nearer to what they share.
const SMALLEST_CELL: f64 = 0.5;

/// Fewer keys than this are compared with each other.
const FEW: usize = 512;
/// Bits of a digit, and how many values it has.
const DIGIT: u32 = 11;
const DIGITS: usize = 1 << DIGIT;

/// Memory of the order: the place's cell along the curve above its number within the part.
#[derive(Clone, Debug, Default)]
pub(crate) struct Order {
    keys: Vec<u64>,
    spare: Vec<u64>,
}

impl Order {
    pub(crate) fn with_capacity(places: usize) -> Self {
        let room = places.min(PART);
        Self { keys: Vec::with_capacity(room), spare: Vec::with_capacity(room) }
    }

    /// Tells the numbers of all places, part by part, each part in the order of the curve.
    pub(crate) fn each_part<E>(
        &mut self,
        count: usize,
        place: impl Fn(usize) -> DVec2,
        mut visit: impl FnMut(&OrderedRun<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        for first in (0..count).step_by(PART) {
            let end = count.min(first + PART);
            let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            for i in first..end {
                let at = place(i);
                (low, high) = (low.min(at), high.max(at));
            }
            // Square cells: what is near along one axis is as near as along the other.
            let extent = (high - low).max_element();
            let scale = cells_per_metre(extent);
            let bits = 2 * (u64::BITS - ((extent * scale) as u64).leading_zeros());
            self.keys.clear();
            self.keys.extend(
                (first..end)
                    .map(|i| u64::from(curve(place(i), low, scale)) << 32 | (i - first) as u64),
            );
            sort(&mut self.keys, &mut self.spare, bits);
            visit(&OrderedRun { first, keys: &self.keys })?;
        }
        Ok(())
    }

    /// Tells the number of each place, along the curve.
    pub(crate) fn each<E>(
        &mut self,
        count: usize,
        place: impl Fn(usize) -> DVec2,
        mut visit: impl FnMut(usize) -> Result<(), E>,
    ) -> Result<(), E> {
        self.each_part(count, place, |part| part.numbers(0, part.len()).try_for_each(&mut visit))
    }
}

/// Sorts by so many of the lowest bits of the upper half, the only ones that are set, equal ones as they stood: digit by digit, which thousands of keys make worth while.
fn sort(keys: &mut Vec<u64>, spare: &mut Vec<u64>, bits: u32) {
    if keys.len() < FEW {
        // The lower halves ascend already.
        keys.sort_unstable();
        return;
    }
    spare.clear();
    spare.resize(keys.len(), 0);
    for pass in 0..bits.div_ceil(DIGIT) {
        let digit = |key: &u64| (key >> (32 + pass * DIGIT)) as usize & (DIGITS - 1);
        let mut starts = [0u32; DIGITS];
        keys.iter().for_each(|key| starts[digit(key)] += 1);
        let mut sum = 0;
        for start in &mut starts {
            (*start, sum) = (sum, sum + *start);
        }
        for key in keys.iter() {
            let start = &mut starts[digit(key)];
            if let Some(place) = spare.get_mut(*start as usize) {
                *place = *key;
            }
            *start += 1;
        }
        std::mem::swap(keys, spare);
    }
}

/// Places that are ordered.
pub(crate) struct OrderedRun<'o> {
    first: usize,
    keys: &'o [u64],
}

impl OrderedRun<'_> {
    pub(crate) fn len(&self) -> usize {
        self.keys.len()
    }

    /// Numbers of so many places along the curve, or of those that are left.
    #[inline]
    pub(crate) fn numbers(&self, from: usize, count: usize) -> impl Iterator<Item = usize> + '_ {
        let end = self.keys.len().min(from + count);
        let keys = self.keys.get(from..end).unwrap_or_default();
        keys.iter().map(|key| self.first + *key as u32 as usize)
    }
}

/// A place's cell along the curve, which is laid over the square that begins at the smallest coordinates of some places and reaches to the largest.
pub(crate) fn curve_key(place: DVec2, low: DVec2, high: DVec2) -> u32 {
    curve(place, low, cells_per_metre((high - low).max_element()))
}

fn cells_per_metre(extent: f64) -> f64 {
    (CELLS / extent.max(f64::MIN_POSITIVE)).min(1.0 / SMALLEST_CELL)
}

fn curve(place: DVec2, low: DVec2, scale: f64) -> u32 {
    let cell = (place - low) * scale;
    interleaved(cell.x as u16) | interleaved(cell.y as u16) << 1
}

/// A number's bits with a gap after each.
#[inline]
fn interleaved(number: u16) -> u32 {
    let mut bits = u32::from(number);
    for (shift, mask) in [(8, 0x00ff_00ff), (4, 0x0f0f_0f0f), (2, 0x3333_3333), (1, 0x5555_5555)] {
        bits = (bits | bits << shift) & mask;
    }
    bits
}
