//! In which order places are asked: along a curve that keeps near ones together.

use glam::DVec2;

/// Places that are ordered at once; of more, one such part after another, so that memory is bounded.
const PART: usize = 1 << 20;
/// Cells of the curve in either direction.
const CELLS: f64 = 65_536.0;

/// Memory of the order: the place's cell along the curve above its number within the part.
#[derive(Clone, Debug, Default)]
pub(crate) struct Order {
    keys: Vec<u64>,
}

impl Order {
    pub(crate) fn with_capacity(places: usize) -> Self {
        Self { keys: Vec::with_capacity(places.min(PART)) }
    }

    /// Tells the numbers of all places, part by part, each part in the order of the curve. `number_of` makes a place's number of an entry and the
    /// part's first number.
    pub(crate) fn each_part<E>(
        &mut self,
        count: usize,
        place: impl Fn(usize) -> DVec2,
        mut visit: impl FnMut(&Part<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        for first in (0..count).step_by(PART) {
            let end = count.min(first + PART);
            let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            for i in first..end {
                let at = place(i);
                (low, high) = (low.min(at), high.max(at));
            }
            // Square cells: what is near along one axis is as near as along the other.
            let scale = CELLS / (high - low).max_element().max(f64::MIN_POSITIVE);
            self.keys.clear();
            self.keys.extend((first..end).map(|i| {
                let cell = (place(i) - low) * scale;
                let curve = interleaved(cell.x as u16) | interleaved(cell.y as u16) << 1;
                u64::from(curve) << 32 | (i - first) as u64
            }));
            self.keys.sort_unstable();
            visit(&Part { first, keys: &self.keys })?;
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
        self.each_part(count, place, |part| (0..part.len()).try_for_each(|k| visit(part.number(k))))
    }
}

/// Places that are ordered.
pub(crate) struct Part<'o> {
    first: usize,
    keys: &'o [u64],
}

impl Part<'_> {
    pub(crate) fn len(&self) -> usize {
        self.keys.len()
    }

    /// Number of the k-th place along the curve.
    #[inline]
    pub(crate) fn number(&self, k: usize) -> usize {
        self.first + self.keys.get(k).map_or(0, |key| *key as u32 as usize)
    }
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
