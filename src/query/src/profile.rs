//! Cubic records along s.

use mapd_archive::ArchivedCubicRow;
use mapd_geometry::Cubic;

/// Value and derivative of a profile at s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Slope {
    pub(crate) value: f64,
    pub(crate) derivative: f64,
}

/// The record that holds at s: the last one that starts at or before it (of equal ones the later). None before the
/// first record, where every profile is 0 (OpenDRIVE 1.8.1, 7.2).
#[inline]
fn record(records: &[ArchivedCubicRow], s: f64) -> Option<&ArchivedCubicRow> {
    match records {
        [] => None,
        [only] => (only.s() <= s).then_some(only),
        _ => records.partition_point(|r| r.s() <= s).checked_sub(1).and_then(|i| records.get(i)),
    }
}

#[inline]
pub(crate) fn value(records: &[ArchivedCubicRow], s: f64) -> f64 {
    record(records, s).map_or(0.0, |r| cubic(r).value(s - r.s()))
}

#[inline]
pub(crate) fn slope(records: &[ArchivedCubicRow], s: f64) -> Slope {
    record(records, s).map_or(Slope::default(), |r| {
        let (cubic, ds) = (cubic(r), s - r.s());
        Slope { value: cubic.value(ds), derivative: cubic.derivative(ds) }
    })
}

#[inline]
fn cubic(r: &ArchivedCubicRow) -> Cubic {
    Cubic { a: r.a(), b: r.b(), c: r.c(), d: r.d() }
}
