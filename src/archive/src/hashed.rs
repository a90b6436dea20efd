//! Hashes of 64 bits: of short texts and rows, and maps from hashes, which are not hashed again.

use std::collections::HashMap;
use std::hash::{BuildHasher, BuildHasherDefault, Hasher, RandomState};

/// What is known by 64-bit hashes of it.
pub type ByHash<T> = HashMap<u64, T, BuildHasherDefault<Hashed>>;

/// Takes numbers that are hashes already.
#[derive(Clone, Copy, Debug, Default)]
pub struct Hashed(u64);

impl Hasher for Hashed {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        // Only 64-bit numbers are asked for.
        bytes.iter().for_each(|byte| self.0 = self.0.rotate_left(8) ^ u64::from(*byte));
    }

    fn write_u64(&mut self, hash: u64) {
        self.0 = hash;
    }
}

/// Hashes bytes sixteen at a time, with a key: compiling asks for some ten hashes for each lane, most of them of a few bytes.
///
/// Who does not know the key cannot tell which texts have one hash. With [`KeyedHash::fixed`] hashes are the same in every
/// run, and whoever takes them says what becomes of different things with one hash.
#[derive(Clone, Copy, Debug)]
pub struct KeyedHash {
    key: u64,
    state: u64,
}

impl Default for KeyedHash {
    /// With a key of its own.
    fn default() -> Self {
        let random = RandomState::new();
        Self { key: random.hash_one(0_u8), state: random.hash_one(1_u8) }
    }
}

impl KeyedHash {
    /// With a key that is always the same: digits of the circle's number.
    pub fn fixed() -> Self {
        Self { key: 0x243f_6a88_85a3_08d3, state: 0x1319_8a2e_0370_7344 }
    }

    /// The hash of some bytes.
    #[inline]
    pub fn of(mut self, bytes: &[u8]) -> u64 {
        self.write(bytes);
        self.state
    }

    /// Takes in sixteen bytes: all bits of their product with what came before.
    #[inline]
    fn fold(&mut self, low: u64, high: u64) {
        let product = u128::from(low ^ self.key) * u128::from(high ^ self.state);
        self.state = product as u64 ^ (product >> u64::BITS) as u64;
    }
}

impl Hasher for KeyedHash {
    fn finish(&self) -> u64 {
        self.state
    }

    #[inline]
    fn write(&mut self, bytes: &[u8]) {
        // Texts of zeros differ in their lengths alone.
        self.state = self.state.wrapping_add(self.key.wrapping_mul(bytes.len() as u64));
        let (all, rest) = bytes.as_chunks::<16>();
        for sixteen in all {
            let [low, high] = ends(sixteen);
            self.fold(low, high);
        }
        if !rest.is_empty() {
            let [low, high] = ends(rest);
            self.fold(low, high);
        }
    }
}

impl BuildHasher for KeyedHash {
    type Hasher = Self;

    fn build_hasher(&self) -> Self {
        *self
    }
}

/// The first and the last eight bytes of sixteen at most, which overlap where there are fewer.
#[inline]
fn ends(bytes: &[u8]) -> [u64; 2] {
    match (bytes.first_chunk(), bytes.last_chunk()) {
        (Some(first), Some(last)) => [*first, *last].map(u64::from_le_bytes),
        _ => match (bytes.first_chunk(), bytes.last_chunk()) {
            (Some(first), Some(last)) => [*first, *last].map(u32::from_le_bytes).map(u64::from),
            _ => [bytes.iter().fold(0, |all, byte| all << u8::BITS | u64::from(*byte)), 0],
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    /// Texts that differ in a single bit or in their length, as ids and rows of zeros do, have hashes that differ in both of their halves.
    #[test]
    fn what_differs_has_other_hashes() {
        for hash in [KeyedHash::fixed(), KeyedHash::default()] {
            let mut texts = HashSet::from([Vec::new()]);
            for length in 1..=80_usize {
                texts.insert(vec![0; length]);
                texts.insert(vec![b'1'; length]);
                for bit in 0..length * 8 {
                    let mut text = vec![b'0'; length];
                    text[bit / 8] ^= 1 << (bit % 8);
                    texts.insert(text);
                }
            }
            let hashes: HashSet<u64> = texts.iter().map(|text| hash.of(text)).collect();
            assert_eq!(hashes.len(), texts.len());
            for half in [0, 32] {
                let halves: HashSet<u32> = hashes.iter().map(|h| (h >> half) as u32).collect();
                assert!(halves.len() + 8 > texts.len(), "{} of {}", halves.len(), texts.len());
            }
        }
    }
}
