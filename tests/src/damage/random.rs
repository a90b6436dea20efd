//! Random damage to archives and overlays whose hashes are then made to fit, the same for a seed.

use super::seal;
use mapd_archive::{AlignedBytes, HEADER_LENGTH, TableInfo};

/// Small and repeatable (Marsaglia's xorshift).
pub struct Random(u64);

impl Random {
    /// Of a seed.
    pub fn new(seed: u64) -> Self {
        // Neighbouring seeds shall differ in all bits; 0 would stay 0.
        let mut random = Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
        (0..8).for_each(|_| _ = random.next());
        random
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// Below a bound, which is not 0.
    pub fn below(&mut self, bound: usize) -> usize {
        (self.next() >> 11) as usize % bound
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }
}

/// Numbers in double precision that hurt: those beyond 2⁵³ have no neighbour at a distance of 1.
const NUMBERS: [f64; 20] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    0.0,
    -0.0,
    1.0,
    -1.0,
    1e-9,
    1e3,
    1e7,
    -1e7,
    1e10,
    1e14,
    9_007_199_254_740_992.0,
    1e17,
    -1e17,
];

/// Whole numbers that hurt.
const WHOLE: [u32; 10] =
    [0, 1, 2, 0x7fff, 0xffff, 0x7fff_ffff, 0x8000_0000, u32::MAX - 1, u32::MAX, 1 << 20];

/// Where the bytes of each table that has rows lie, and how long its rows are.
pub fn places(tables: &[TableInfo], base: usize) -> Vec<(std::ops::Range<usize>, usize)> {
    let place = |info: &TableInfo| {
        let start = info.address - base;
        (start..start + info.count * info.element_bytes, info.element_bytes)
    };
    tables.iter().filter(|info| info.count > 0).map(place).collect()
}

/// Damages some places of an archive, each table as likely as another, and makes its hashes fit.
pub fn damage(
    bytes: &mut AlignedBytes,
    places: &[(std::ops::Range<usize>, usize)],
    random: &mut Random,
) {
    for _ in 0..=random.below(3) {
        let (table, row) = places[random.below(places.len())].clone();
        let at = table.start + random.below(table.len());
        // Numbers lie at multiples of their size within a row.
        let whole = |size: usize| at - (at - table.start) % row % size;
        match random.below(8) {
            0 => bytes[at] ^= 1 << random.below(8),
            1 => bytes[at] = random.one_of(&[0, 1, 0x7f, 0x80, 0xfe, 0xff]),
            2..=4 => put(bytes, whole(8), &random.one_of(&NUMBERS).to_le_bytes()),
            5 => put(bytes, whole(4), &random.one_of(&WHOLE).to_le_bytes()),
            6 => put(bytes, whole(4), &(random.one_of(&NUMBERS) as f32).to_le_bytes()),
            _ => {
                // What another row has there.
                let other = table.start + (at - table.start) % row;
                let other = other + random.below(table.len() / row) * row;
                bytes[at] = bytes[other];
            }
        }
    }
    seal(bytes);
}

fn put(bytes: &mut [u8], at: usize, new: &[u8]) {
    if let Some(old) = bytes.get_mut(at..at + new.len()).filter(|_| at >= HEADER_LENGTH) {
        old.copy_from_slice(new);
    }
}
