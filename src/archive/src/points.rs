//! Points of polylines: so many bytes each as those of a section need.
//!
//! A point is one number, its lowest byte first: from the lowest bit on the number of its station within the section, then x, y
//! and z as steps from the section's frame. How many bits each has, the section says.

use crate::generated::network_rows::{ArchivedSectionRow, SectionRow};

/// What is added to the exponents of steps, so that they are not negative.
const BIAS: u8 = 128;
/// Most bits of a point.
const MOST_BITS: u32 = 128;
/// Most bits of a station's number.
const MOST_STATION_BITS: u32 = 24;
/// Exponent of the finest step `[m]`, a micrometre: bits that are left over are of no use beyond.
const FINEST: i32 = -20;

/// How the points of one section are written.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointCode {
    /// Bytes of a point.
    bytes: u8,
    /// Bits of the station's number, of x, y and z.
    bits: [u8; 4],
    /// Exponents of the steps of x and y, and of z, plus [`BIAS`].
    exponents: [u8; 2],
}

/// Exponent of the largest power of two that is not above a positive number.
pub(crate) fn exponent(value: f64) -> i32 {
    (value.to_bits() >> 52 & 0x7ff) as i32 - 1023
}

/// A power of two by its exponent plus [`BIAS`].
#[inline]
fn power(exponent: u8) -> f64 {
    f64::from_bits((u64::from(exponent) + 1023 - u64::from(BIAS)) << 52)
}

/// One over such a power of two.
#[inline]
fn inverse_power(exponent: u8) -> f64 {
    f64::from_bits((u64::from(BIAS) + 1023 - u64::from(exponent)) << 52)
}

/// Bits that numbers up to this one need, once it is rounded.
fn bits_for(most: f64) -> u32 {
    // Casts saturate; a call of the C library that rounds takes several times as long.
    let down = most as u64;
    let nearest = down.saturating_add(u64::from(most - down as f64 >= 0.5));
    u64::BITS - nearest.leading_zeros()
}

#[inline]
fn mask(bits: u8) -> u64 {
    !u64::MAX.unbounded_shl(bits.into())
}

impl PointCode {
    /// The shortest code for points that reach so far from their frame along x, y and z `[m]`, at so many stations, with steps of at most
    /// `step` `[m]`: bits that are left over make steps finer. Where a point would need more than 128 bits, as over
    /// 10⁶ km in millimetres, steps are larger. None for more than 2²⁴ stations.
    pub fn fitting(reach: [f64; 3], stations: usize, step: f64) -> Option<Self> {
        let for_station = bits_for(stations.saturating_sub(1) as f64);
        if for_station > MOST_STATION_BITS {
            return None;
        }
        let bits = |[xy, z]: [i32; 2]| {
            let along =
                |reach: f64, exponent: i32| bits_for(reach * inverse_power(biased(exponent)));
            [for_station, along(reach[0], xy), along(reach[1], xy), along(reach[2], z)]
        };
        let fits = |exponents: [i32; 2], limit: u32| {
            let bits = bits(exponents);
            bits.iter().sum::<u32>() <= limit && bits.iter().all(|bits| *bits < u64::BITS)
        };
        let mut exponents = [exponent(step); 2];
        while !fits(exponents, MOST_BITS) && exponents[0] < i32::from(u8::MAX - BIAS) {
            exponents = exponents.map(|exponent| exponent + 1);
        }
        let needed: u32 = bits(exponents).iter().sum();
        let bytes = needed.div_ceil(u8::BITS).max(1);
        // Finer all around while that costs nothing, then in plan view alone.
        for finer in [[1, 1], [1, 0]] {
            loop {
                let next = [exponents[0] - finer[0], exponents[1] - finer[1]];
                if next[0] < FINEST || !fits(next, bytes * u8::BITS) {
                    break;
                }
                exponents = next;
            }
        }
        let bits = bits(exponents).map(|bits| bits as u8);
        Some(Self { bytes: bytes as u8, bits, exponents: exponents.map(biased) })
    }

    /// Bytes of a point; at least 1.
    #[inline]
    pub fn bytes(&self) -> usize {
        usize::from(self.bytes).max(1)
    }

    /// Whether bits and bytes fit each other.
    pub(crate) fn is_sound(&self) -> bool {
        let sum: u32 = self.bits.iter().map(|bits| u32::from(*bits)).sum();
        let single = self.bits.iter().all(|bits| u32::from(*bits) < u64::BITS);
        let bytes = sum.div_ceil(u8::BITS).max(1);
        let fits = sum <= MOST_BITS && u32::from(self.bytes) == bytes;
        fits && single && u32::from(self.bits[0]) <= MOST_STATION_BITS
    }

    /// Largest distance of a written point from what was meant `[m]`.
    pub fn error(&self) -> f64 {
        let [xy, z] = self.exponents.map(power);
        0.5 * (2.0 * xy * xy + z * z).sqrt()
    }

    /// Number of the station within the section of the point that begins with the first of some bytes.
    #[inline]
    pub fn station(&self, bytes: &[u8]) -> u32 {
        (low(bytes) & mask(self.bits[0])) as u32
    }

    /// x, y and z from the section's frame of the point that begins with the first of some bytes `[m]`.
    #[inline]
    pub fn offset(&self, bytes: &[u8]) -> [f64; 3] {
        let [station, x, y, z] = self.bits;
        let [xy_step, z_step] = self.exponents.map(power);
        let [x, y, z] = if self.bytes <= 8 {
            let from_x = low(bytes).unbounded_shr(station.into());
            let from_y = from_x.unbounded_shr(x.into());
            let from_z = from_y.unbounded_shr(y.into());
            [from_x & mask(x), from_y & mask(y), from_z & mask(z)]
        } else {
            // Points of very large sections.
            let high = low(bytes.get(8..).unwrap_or(&[]));
            let all = u128::from(low(bytes)) | u128::from(high) << u64::BITS;
            let mut rest = all.unbounded_shr(station.into());
            [x, y, z].map(|count| {
                let part = rest as u64 & mask(count);
                rest = rest.unbounded_shr(count.into());
                part
            })
        };
        [x as f64 * xy_step, y as f64 * xy_step, z as f64 * z_step]
    }

    /// Appends a point; offsets from the frame are rounded to steps, and those outside the reach to its ends.
    #[inline]
    pub fn write(&self, offset: [f64; 3], station: u32, out: &mut Vec<u8>) {
        // Steps are powers of two, so that a product is what a quotient would be.
        let [xy, z] = self.exponents.map(inverse_power);
        let [for_station, x, y, for_z] = self.bits;
        let station = u64::from(station) & mask(for_station);
        let counts = [x, y, for_z];
        let steps: [u64; 3] = std::array::from_fn(|axis| {
            rounded(offset[axis] * [xy, xy, z][axis]).min(mask(counts[axis]))
        });
        let mut at = u32::from(for_station);
        if self.bytes <= 8 {
            let mut bits = station;
            for (steps, count) in steps.into_iter().zip(counts) {
                bits |= steps.unbounded_shl(at);
                at += u32::from(count);
            }
            // All eight, and those that are too many taken back: a copy of a length that is known is one instruction.
            let end = out.len() + self.bytes();
            out.extend_from_slice(&bits.to_le_bytes());
            out.truncate(end);
        } else {
            let mut bits = u128::from(station);
            for (steps, count) in steps.into_iter().zip(counts) {
                bits |= u128::from(steps).unbounded_shl(at);
                at += u32::from(count);
            }
            let bytes = bits.to_le_bytes();
            out.extend_from_slice(bytes.get(..self.bytes()).unwrap_or(&bytes));
        }
    }

    /// Ready to read many points.
    #[inline]
    pub fn reader(&self) -> PointReader {
        let [station, x, y, z] = self.bits;
        let [xy_step, z_step] = self.exponents.map(power);
        let behind_x = station.saturating_add(x);
        let shifts = [station, behind_x, behind_x.saturating_add(y)];
        let [of_station, of_x, of_y, of_z] = [station, x, y, z].map(mask);
        // What begins behind the last of 64 bits is 0, and a shift by so many would be none.
        let within = |mask: u64, shift: u8| if u32::from(shift) < u64::BITS { mask } else { 0 };
        PointReader {
            code: *self,
            shifts,
            masks: [
                of_station,
                within(of_x, shifts[0]),
                within(of_y, shifts[1]),
                within(of_z, shifts[2]),
            ],
            steps: [xy_step, xy_step, z_step],
        }
    }
}

/// A point as it is packed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PackedPoint {
    /// Number of its station.
    pub station: u32,
    /// x, y and z from the section's frame `[m]`.
    pub offset: [f64; 3],
}

/// A code with what is the same for all its points.
#[derive(Clone, Copy, Debug)]
pub struct PointReader {
    code: PointCode,
    /// Where x, y and z begin.
    shifts: [u8; 3],
    /// Of the station's number, of x, y and z.
    masks: [u64; 4],
    steps: [f64; 3],
}

impl PointReader {
    /// The point that begins with the first of some bytes: what [`PointCode::station`] and [`PointCode::offset`] give.
    #[inline]
    pub fn read(&self, bytes: &[u8]) -> PackedPoint {
        if self.code.bytes > 8 {
            let (station, offset) = (self.code.station(bytes), self.code.offset(bytes));
            return PackedPoint { station, offset };
        }
        let all = low(bytes);
        let [station, x, y, z] = self.masks;
        let steps = [x, y, z].into_iter().zip(self.shifts);
        let mut offset = self.steps;
        for (offset, (mask, shift)) in offset.iter_mut().zip(steps) {
            // Less than 2⁶³, so that the sign does not matter.
            *offset *= (all.wrapping_shr(shift.into()) & mask) as i64 as f64;
        }
        PackedPoint { station: (all & station) as u32, offset }
    }
}

/// The nearest whole number, of two the larger one, from 0 to 2⁶³ − 1, the most that a part of a point can be: 0 for what is
/// no number.
#[inline]
fn rounded(value: f64) -> u64 {
    // Casts saturate.
    let toward_zero = value as i64;
    let up = i64::from(value - toward_zero as f64 >= 0.5);
    toward_zero.saturating_add(up).max(0) as u64
}

fn biased(exponent: i32) -> u8 {
    // Steps from 2⁻¹²⁸ m to 2¹²⁷ m.
    u8::try_from(exponent + i32::from(BIAS)).unwrap_or(if exponent < 0 { 0 } else { u8::MAX })
}

/// The number that the first eight bytes are; those that are not there count as 0.
#[inline]
pub(crate) fn low(bytes: &[u8]) -> u64 {
    match bytes.first_chunk() {
        Some(bytes) => u64::from_le_bytes(*bytes),
        None => bytes.iter().rev().fold(0, |bits, byte| bits << u8::BITS | u64::from(*byte)),
    }
}

impl ArchivedSectionRow {
    /// How the section's points are written.
    #[inline]
    pub fn point_code(&self) -> PointCode {
        PointCode {
            bytes: self.point_bytes(),
            bits: [self.station_bits(), self.x_bits(), self.y_bits(), self.z_bits()],
            exponents: [self.xy_step(), self.z_step()],
        }
    }
}

impl SectionRow {
    /// Says how the section's points are written.
    pub fn set_point_code(&mut self, code: PointCode) {
        self.point_bytes = code.bytes;
        [self.station_bits, self.x_bits, self.y_bits, self.z_bits] = code.bits;
        [self.xy_step, self.z_step] = code.exponents;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Writes points of all kinds and reads them again, with another one behind and without: within half a step, at their
    /// station.
    #[track_caller]
    fn check(reach: [f64; 3], stations: usize, step: f64, bytes: usize) {
        let code = PointCode::fitting(reach, stations, step).expect("a code");
        assert!(code.is_sound(), "{code:?}");
        assert_eq!(code.bytes(), bytes, "{code:?}");
        for i in 0..=100u32 {
            let share = f64::from(i) / 100.0;
            let offset = reach.map(|reach| reach * share);
            let station = (share * (stations - 1) as f64) as u32;
            let mut out = Vec::new();
            code.write(offset, station, &mut out);
            assert_eq!(out.len(), bytes);
            for _ in 0..2 {
                assert_eq!(code.station(&out), station);
                let found = code.offset(&out);
                assert_eq!(code.reader().read(&out), PackedPoint { station, offset: found });
                for axis in 0..3 {
                    assert!((found[axis] - offset[axis]).abs() <= 0.5 * step, "{code:?} {axis}");
                }
                let off = found.iter().zip(offset).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
                assert!(off.sqrt() <= code.error() * (1.0 + 1e-9));
                code.write(reach, 0, &mut out);
            }
        }
    }

    #[test]
    fn rounds_as_the_library_does() {
        let odd = [0.0, -0.0, -0.5, -7.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300];
        let near = (0..64).flat_map(|exponent| {
            #[allow(clippy::disallowed_methods, reason = "powers of two are exact")]
            let power = 2f64.powi(exponent);
            [power, power - 0.5, power + 0.5, power.next_down(), power.next_up(), power - 0.25]
        });
        let halves = [0.5f64, 1.5, 2.5, 4_503_599_627_370_495.5];
        let halves = halves.into_iter().flat_map(|half| [half.next_down(), half, half.next_up()]);
        for value in odd.into_iter().chain(near).chain(halves) {
            let expected = value.round() as u64;
            assert_eq!(rounded(value), expected.min(i64::MAX as u64), "{value}");
            assert_eq!(bits_for(value), u64::BITS - expected.leading_zeros(), "{value}");
        }
    }

    #[test]
    fn points_come_back_within_half_a_step() {
        check([0.0; 3], 1, 1e-3, 1);
        check([20.0, 15.0, 0.0], 8, 1.0 / 2048.0, 5);
        check([20.0, 15.0, 0.5], 8, 1.0 / 2048.0, 6);
        check([200.0, 150.0, 5.0], 60, 1.0 / 2048.0, 8);
        check([1500.0, 2500.0, 80.0], 700, 1.0 / 2048.0, 10);
        check([6e6, 6e6, 9e3], 100_000, 1.0 / 65536.0, 16);
    }

    #[test]
    fn what_is_left_over_makes_steps_finer() {
        let code = PointCode::fitting([10.0, 10.0, 0.0], 2, 0.5).expect("a code");
        // 16 bits: one for the station, seven each for x and y.
        assert_eq!((code.bytes(), code.error()), (2, 0.5 * (3.0f64 / 64.0).sqrt()));
        assert_eq!(PointCode::fitting([1.0; 3], (1 << 24) + 1, 1.0), None);
    }

    /// What cannot be written within the step is written as well as 128 bits allow.
    #[test]
    fn beyond_all_measure_steps_grow() {
        let reach = [1e18, 1e18, 1e6];
        let code = PointCode::fitting(reach, 1000, 1e-3).expect("a code");
        let mut out = Vec::new();
        code.write(reach, 999, &mut out);
        let found = code.offset(&out);
        assert!(code.is_sound() && out.len() == 16, "{code:?}");
        for axis in 0..3 {
            assert!((found[axis] - reach[axis]).abs() <= code.error());
        }
    }

    /// Parts without bits behind 64 others: the shift to them was one by nothing.
    #[test]
    fn parts_behind_64_bits_are_none() {
        for bits in [[24, 40, 0, 0], [24, 20, 20, 0], [1, 63, 0, 0]] {
            let code = PointCode { bytes: 8, bits, exponents: [BIAS; 2] };
            assert!(code.is_sound());
            let read = code.reader().read(&[0xff; 8]);
            assert_eq!(read.offset, code.offset(&[0xff; 8]), "{bits:?}");
            assert_eq!(read.offset[2], 0.0, "{bits:?}");
        }
    }

    /// Codes of damaged archives: any bits yield numbers, nothing panics.
    #[test]
    fn damaged_codes_read_something() {
        for bits in [[0; 4], [255; 4], [64, 63, 1, 200], [24, 40, 40, 24]] {
            for bytes in 0..=17u8 {
                let code = PointCode { bytes, bits, exponents: [0, 255] };
                for length in 0..=18 {
                    let point = vec![0xff; length];
                    assert!(code.offset(&point).iter().all(|x| x.is_finite()));
                    let _ = (code.station(&point), code.is_sound());
                }
            }
        }
    }
}
