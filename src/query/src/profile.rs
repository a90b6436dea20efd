//! Cubic records along s.

use crate::begun::begun;
use mapd_archive::ArchivedCubicRow;
use mapd_geometry::Cubic;

/// Value and derivative of a profile at s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Slope {
    pub(crate) value: f64,
    pub(crate) derivative: f64,
}

/// As [`Slope`], with the second derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bend {
    pub(crate) slope: Slope,
    pub(crate) second: f64,
}

/// A place on a road, and which records hold there: those that hold at `hold`. The two differ at the end of a stretch,
/// where the next one's records begin: a lane ends with what holds within it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct At {
    pub(crate) s: f64,
    pub(crate) hold: f64,
}

impl At {
    /// The place with what begins there.
    #[inline]
    pub(crate) fn new(s: f64) -> Self {
        Self { s, hold: s }
    }

    /// A place in a stretch: at its end, with what holds just below.
    #[inline]
    pub(crate) fn within(s: f64, start: f64, end: f64) -> Self {
        Self { s, hold: if s >= end && start < end { end.next_down() } else { s } }
    }
}

/// The record that holds at a place: the last one that starts at or before it (of equal ones the later). None before the
/// first record, where every profile is 0 (OpenDRIVE 1.8.1, 7.2).
#[inline]
fn record(records: &[ArchivedCubicRow], at: At) -> Option<&ArchivedCubicRow> {
    match records {
        [] => None,
        [only] => (only.s() <= at.hold).then_some(only),
        _ => among(records, at),
    }
}

/// As [`record`], of any number of them: there once, however many profiles are asked.
#[inline(never)]
fn among(records: &[ArchivedCubicRow], at: At) -> Option<&ArchivedCubicRow> {
    begun(records, at.hold, |r| r.s()).checked_sub(1).and_then(|i| records.get(i))
}

/// A record apart from the archive; 0 everywhere where none holds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Record {
    s: f64,
    cubic: Cubic,
}

impl Record {
    /// What holds before the first record: 0.
    pub(crate) const NONE: Self = Self { s: 0.0, cubic: Cubic { a: 0.0, b: 0.0, c: 0.0, d: 0.0 } };

    pub(crate) fn of(row: Option<&ArchivedCubicRow>) -> Self {
        row.map_or(Self::NONE, |row| Self { s: row.s(), cubic: cubic(row) })
    }

    #[inline]
    pub(crate) fn value(&self, s: f64) -> f64 {
        self.cubic.value(s - self.s)
    }

    #[inline]
    pub(crate) fn slope(&self, s: f64) -> Slope {
        let ds = s - self.s;
        Slope { value: self.cubic.value(ds), derivative: self.cubic.derivative(ds) }
    }

    /// Where it was cut off from another.
    pub(crate) fn start(&self) -> f64 {
        self.s
    }

    /// The same cubic, by the distance from another place.
    pub(crate) fn from(&self, s: f64) -> Self {
        let (ds, Cubic { c, d, .. }) = (s - self.s, self.cubic);
        let [a, b] = [self.cubic.value(ds), self.cubic.derivative(ds)];
        Self { s, cubic: Cubic { a, b, c: c + 3.0 * d * ds, d } }
    }

    /// What so many times another one adds to this, from a place on.
    pub(crate) fn plus(&self, times: f64, other: &Self, s: f64) -> Self {
        let (Cubic { a, b, c, d }, o) = (self.from(s).cubic, other.from(s).cubic);
        let cubic = Cubic {
            a: a + times * o.a,
            b: b + times * o.b,
            c: c + times * o.c,
            d: d + times * o.d,
        };
        Self { s, cubic }
    }

    pub(crate) fn is_constant(&self) -> bool {
        self.is_even() && self.cubic.b == 0.0
    }

    /// Whether it grows evenly.
    pub(crate) fn is_even(&self) -> bool {
        self.cubic.c == 0.0 && self.cubic.d == 0.0
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.is_even() && self.cubic.a == 0.0 && self.cubic.b == 0.0
    }
}

/// Halvings until a sign's change is known to the last digit.
const HALVINGS: u32 = 64;
/// What begins positive, or not, has to stay so for this `[m]`: at 0 rounding decides.
const SLIVER: f64 = 1e-9;

/// Where a record becomes positive between two s, or no longer is: the last s before or the first behind it, whichever is not positive `[m]`. The first such
/// place.
// There once, however many ask.
#[inline(never)]
pub(crate) fn sign_change(row: &ArchivedCubicRow, from: f64, to: f64) -> Option<f64> {
    let Cubic { b, c, d, .. } = cubic(row);
    let is_positive = |s: f64| cubic(row).value(s - row.s()) > 0.0;
    // Between its turns it only grows or only falls.
    let root = (c * c - 3.0 * b * d).sqrt();
    let sum = -(c + root.copysign(c));
    let turns = [sum / (3.0 * d), b / sum].map(|ds| row.s() + ds);
    let mut begin = from + SLIVER;
    for place in [turns[0].min(turns[1]), turns[0].max(turns[1]), to] {
        // There may be no turn, or none between.
        let end = if place > begin && place <= to { place } else { continue };
        let closes = is_positive(begin);
        if closes != is_positive(end) {
            let (mut near, mut far) = (begin, end);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (near + far);
                *(if is_positive(middle) == closes { &mut near } else { &mut far }) = middle;
            }
            return Some(if closes { far } else { near });
        }
        begin = end;
    }
    None
}

/// Where the width that holds at a place closes or opens between two s, as [`sign_change`].
pub(crate) fn corner(records: &[ArchivedCubicRow], at: At, from: f64, to: f64) -> Option<f64> {
    let row = record(records, at).filter(|row| !Record::of(Some(row)).is_constant())?;
    sign_change(row, from, to).filter(|s| *s > from && *s < to)
}

/// The record that holds at a place: its [`Record::value`] is [`value`] wherever the same holds.
pub(crate) fn held(records: &[ArchivedCubicRow], at: At) -> Record {
    Record::of(record(records, at))
}

#[inline]
pub(crate) fn value(records: &[ArchivedCubicRow], at: At) -> f64 {
    record(records, at).map_or(0.0, |r| cubic(r).value(at.s - r.s()))
}

/// As [`value`], where no record begins within `margin` `[m]` of the place; none otherwise. It asks no stretch which records hold.
#[inline]
pub(crate) fn apart(records: &[ArchivedCubicRow], s: f64, margin: f64) -> Option<f64> {
    apart_and_steady(records, s, margin).map(|(value, _)| value)
}

/// As [`apart`], and whether the record that holds changes nowhere.
#[inline]
pub(crate) fn apart_and_steady(
    records: &[ArchivedCubicRow],
    s: f64,
    margin: f64,
) -> Option<(f64, bool)> {
    match records {
        [] => Some((0.0, true)),
        [only] => {
            let ds = s - only.s();
            let value = if ds >= 0.0 { cubic(only).value(ds) } else { 0.0 };
            (ds.abs() > margin).then_some((value, is_steady(only)))
        }
        _ => apart_among(records, s, margin),
    }
}

/// As [`apart_and_steady`], of any number of records.
#[inline(never)]
fn apart_among(records: &[ArchivedCubicRow], s: f64, margin: f64) -> Option<(f64, bool)> {
    let count = begun(records, s, |r| r.s());
    if records.get(count).is_some_and(|next| next.s() - s <= margin) {
        return None;
    }
    let Some(row) = count.checked_sub(1).and_then(|i| records.get(i)) else {
        return Some((0.0, true));
    };
    let ds = s - row.s();
    (ds > margin).then(|| (cubic(row).value(ds), is_steady(row)))
}

#[inline]
pub(crate) fn slope(records: &[ArchivedCubicRow], at: At) -> Slope {
    record(records, at).map_or(Slope::default(), |r| Record::of(Some(r)).slope(at.s))
}

#[inline]
pub(crate) fn bend(records: &[ArchivedCubicRow], at: At) -> Bend {
    record(records, at).map_or(Bend::default(), |r| Bend {
        slope: Record::of(Some(r)).slope(at.s),
        second: cubic(r).second_derivative(at.s - r.s()),
    })
}

/// As [`value`], and whether the record that holds changes nowhere.
#[inline]
pub(crate) fn value_and_steady(records: &[ArchivedCubicRow], at: At) -> (f64, bool) {
    record(records, at).map_or((0.0, true), |r| (cubic(r).value(at.s - r.s()), is_steady(r)))
}

/// Whether a record has one value all along.
#[inline]
pub(crate) fn is_steady(r: &ArchivedCubicRow) -> bool {
    // As bits, which takes one comparison; that −0 counts as a change costs a closer look, no answer.
    (r.b().to_bits() | r.c().to_bits() | r.d().to_bits()) == 0
}

/// As [`slope`], of a record that grows evenly; none of another.
#[inline]
pub(crate) fn even(records: &[ArchivedCubicRow], at: At) -> Option<Slope> {
    record(records, at).map_or(Some(Slope::default()), |r| {
        let (a, b) = (r.a(), r.b());
        let is_even = r.c() == 0.0 && r.d() == 0.0;
        is_even.then(|| Slope { value: a + b * (at.s - r.s()), derivative: b })
    })
}

/// Cosine and sine of a superelevation; (1, 0) without any trigonometry where there is none.
#[inline]
pub(crate) fn roll(angle: f64) -> (f64, f64) {
    if angle == 0.0 { (1.0, 0.0) } else { mapd_geometry::cos_sin(angle) }
}

#[inline]
pub(crate) fn cubic(r: &ArchivedCubicRow) -> Cubic {
    Cubic { a: r.a(), b: r.b(), c: r.c(), d: r.d() }
}
