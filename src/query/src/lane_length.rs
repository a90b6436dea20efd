//! Lengths along a lane's centre line, and the speed limit there.

use crate::lane::Lane;
use crate::profile::{At, Slope};
use crate::road::{GeometryPiece, Road};
use mapd_archive::{ArchivedCubicRow, SpeedKind};

/// Speed assumed where the file states none `[m/s]`: 50 km/h, the usual limit in towns.
const ASSUMED_SPEED: f64 = 50.0 / 3.6;
/// Speed assumed where there is no limit `[m/s]`: 130 km/h, the recommended one on motorways.
const UNLIMITED_SPEED: f64 = 130.0 / 3.6;
/// Lowest speed counted `[m/s]`: a limit of 0 must not make a lane take for ever.
const LOWEST_SPEED: f64 = 0.1;

/// The speed that travel times count for a limit `[m/s]`.
pub fn travel_speed(limit: f64) -> f64 {
    mapd_geometry::clamp(limit, LOWEST_SPEED, UNLIMITED_SPEED)
}

/// What travelling along a lane between two places takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// As [`Lane::length_between`] has it `[m]`.
    pub length: f64,
    /// As [`Lane::time_between`] has it `[s]`.
    pub time: f64,
}

/// Both between two places of a lane: where one speed holds all along, the length is integrated once.
pub fn measures_between(lane: &Lane<'_>, a: f64, b: f64) -> Measures {
    let whole = lane.length_between(a, b);
    let (low, high) = (a.min(b), a.max(b));
    if !(low.is_finite() && high.is_finite()) {
        return Measures { length: whole, time: f64::NAN };
    }
    let length = |from: f64, to: f64| {
        if from == low && to == high { whole } else { lane.length_between(from, to) }
    };
    Measures { length: whole, time: lane.time_of(low, high, length) }
}

/// Places of the two-point Gauss–Legendre rule on −1 to 1, one over the square root of 3.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// A piece of the reference line, from which s on and up to which one it holds. Places that are asked for one behind the other
/// mostly lie on the same.
struct CachedGeometry<'a> {
    piece: Option<GeometryPiece<'a>>,
    from: f64,
    to: f64,
}

impl<'a> CachedGeometry<'a> {
    /// Holds nowhere.
    const NONE: Self = Self { piece: None, from: f64::INFINITY, to: f64::NEG_INFINITY };

    /// The piece that holds at s, as [`Road::piece_at`] finds it.
    #[inline]
    fn at(&mut self, road: &Road<'a>, s: f64) -> Option<GeometryPiece<'a>> {
        if !(s >= self.from && s < self.to) {
            let rows = road.geometries();
            let next = rows.partition_point(|g| g.s() <= s);
            let own = next.saturating_sub(1);
            self.piece = rows.get(own).and_then(|g| road.piece(g));
            // Before the first geometry, that one holds.
            self.from = if own == 0 { f64::NEG_INFINITY } else { rows.get(own)?.s() };
            self.to = rows.get(next).map_or(f64::INFINITY, |g| g.s());
        }
        self.piece
    }
}

/// Where the centre line lies beside the reference line at a place, and how the road is rolled there.
#[derive(Clone, Copy)]
struct Middle {
    /// t with its growth along s.
    center: Slope,
    /// Cosine and sine of the superelevation.
    cos: f64,
    sin: f64,
    /// Growth of the superelevation along s `[rad/m]`; 0 where it is level across.
    turned: f64,
}

/// Metres of a lane's centre line per metre of s, for places that are asked for one behind the other.
struct Growth<'l, 'a> {
    lane: &'l Lane<'a>,
    held: CachedGeometry<'a>,
    /// That of all places, where it does not change.
    middle: Option<Middle>,
}

impl Growth<'_, '_> {
    /// In plan view.
    fn at(&mut self, s: f64) -> f64 {
        let Middle { center, cos, sin, turned } =
            self.middle.unwrap_or_else(|| self.lane.middle(At::new(s)));
        let piece = self.held.at(&self.lane.road, s);
        let curvature = piece.map_or(0.0, |piece| piece.curve.curvature(s - piece.s));
        let along = 1.0 - curvature * center.value * cos;
        let across = center.derivative * cos - center.value * sin * turned;
        (along * along + across * across).sqrt()
    }

    /// The same all over from one s up to another: nothing of it changes, and the reference line is one line or one arc.
    fn even(&mut self, from: f64, to: f64) -> Option<f64> {
        let piece = self.held.at(&self.lane.road, from).filter(|_| to <= self.held.to)?;
        piece.curve.even_curvature_up_to(to - piece.s).filter(|_| self.middle.is_some())?;
        Some(self.at(0.5 * (from + to)))
    }

    /// Length of a stretch on which the lane is smooth.
    fn stretch(&mut self, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        half * (self.at(middle - half * GAUSS) + self.at(middle + half * GAUSS))
    }
}

/// Whether the value of a profile is the same all over from one s up to another.
fn is_constant(records: &[ArchivedCubicRow], from: f64, to: f64) -> bool {
    let next = records.partition_point(|record| record.s() <= from);
    let own = next.checked_sub(1).and_then(|own| records.get(own));
    // Before the first record, profiles are 0.
    own.is_none_or(|own| own.b() == 0.0 && own.c() == 0.0 && own.d() == 0.0)
        && records.get(next).is_none_or(|next| next.s() >= to)
}

/// Steps towards the place at a length along a lane.
const CUTS: usize = 6;

impl<'a> Lane<'a> {
    /// s at a length along the centre line from one place towards another `[m]`: in a bend the two are not in one proportion.
    pub(crate) fn s_after(&self, from: f64, to: f64, wanted: f64) -> f64 {
        let mut share = 1.0;
        for _ in 0..CUTS {
            let length = self.length_between(from, from + (to - from) * share);
            share *= if length > 0.0 { (wanted / length).min(1.0 / share) } else { 0.0 };
        }
        from + (to - from) * share
    }

    /// Length of the centre line in plan view between two places on the road `[m]`, from the file's own polynomials: where the
    /// stored polyline bends, the integral is cut. s outside the lane's section counts as its nearer end; with one that is not
    /// finite: NaN.
    pub fn length_between(&self, a: f64, b: f64) -> f64 {
        if !(a.is_finite() && b.is_finite()) {
            return f64::NAN;
        }
        let section = self.section();
        let (start, end) = (section.s_start(), section.s_end());
        let inside = |s: f64| mapd_geometry::clamp(s, start, end.max(start));
        let (from, to) = (inside(a.min(b)), inside(a.max(b)));
        let line = self.center_line();
        let (mut sum, mut last) = (0.0, from);
        let middle = self.even_middle(from, to);
        let mut growth = Growth { lane: self, held: CachedGeometry::NONE, middle };
        let even = growth.even(from, to);
        let within = line.points_before(from)..line.len();
        let cuts = within.map_while(|i| line.station(i).filter(|s| *s < to));
        for s in cuts.chain([to]) {
            if s > last {
                sum += match even {
                    Some(growth) => 0.5 * (s - last) * (growth + growth),
                    None => growth.stretch(last, s),
                };
                last = s;
            }
        }
        sum
    }

    /// Where the centre line lies from one s up to another, if that is the same all along: superelevation and widths do not change.
    fn even_middle(&self, from: f64, to: f64) -> Option<Middle> {
        let cubics = self.map.tables().cubics;
        let mut is_even = from < to
            && is_constant(self.own_lane_offsets(), from, to)
            && is_constant(self.road.superelevations(), from, to);
        if is_even {
            self.walk_outwards(|lane| is_even &= is_constant(lane.widths().of(cubics), from, to));
        }
        is_even.then(|| self.middle(At::new(0.5 * (from + to))))
    }

    /// Where the centre line lies at a place.
    fn middle(&self, at: At) -> Middle {
        let edges = self.edge_slopes(at);
        let center = Slope {
            value: 0.5 * (edges.inner.value + edges.outer.value),
            derivative: 0.5 * (edges.inner.derivative + edges.outer.derivative),
        };
        let (cos, sin) = self.road.roll(at);
        let turned = if sin == 0.0 { 0.0 } else { self.road.superelevation_slope(at) };
        Middle { center, cos, sin, turned }
    }

    /// Time to travel the centre line between two places on the road at the speed limit of [`Lane::speed_limit_at`] `[s]`: 50 km/h where there is none
    /// written, 130 km/h where there is no limit, and never less than 0.1 m/s. s outside the lane's section counts as its nearer end; with one that is
    /// not finite: NaN.
    pub fn time_between(&self, a: f64, b: f64) -> f64 {
        if !(a.is_finite() && b.is_finite()) {
            return f64::NAN;
        }
        self.time_of(a.min(b), a.max(b), |from, to| self.length_between(from, to))
    }

    /// As [`Self::time_between`], of finite s that ascend. `length` is that of a stretch.
    fn time_of(&self, from: f64, to: f64, length: impl Fn(f64, f64) -> f64) -> f64 {
        let (mut time, mut last) = (0.0, from);
        loop {
            let changes = self.speeds().map(|record| record.s);
            let changes = changes.chain(self.road.types().map(|record| record.s));
            let next = changes.filter(|s| *s > last && *s < to).fold(to, f64::min);
            let speed = self.speed_limit_at(0.5 * (last + next)).unwrap_or(ASSUMED_SPEED);
            time += length(last, next) / travel_speed(speed);
            if next >= to {
                return time;
            }
            last = next;
        }
    }

    /// Speed limit at s `[m/s]`: the lane's own record, else that of the road's type (OpenDRIVE 1.8.1, 11.8.2, 10.4).
    /// Infinite where the file says `no limit`; none where it says nothing, and for an s that is not finite. Signals are not
    /// looked at.
    pub fn speed_limit_at(&self, s: f64) -> Option<f64> {
        if !s.is_finite() {
            return None;
        }
        let limit = |kind: SpeedKind, value: f64| match kind {
            SpeedKind::Value => Some(value),
            SpeedKind::NoLimit => Some(f64::INFINITY),
            _ => None,
        };
        let own = self.speeds().take_while(|record| record.s <= s).last();
        let own = own.and_then(|record| limit(record.kind, record.max));
        own.or_else(|| {
            let of_road = self.road.types().take_while(|record| record.s <= s).last();
            of_road.and_then(|record| limit(record.speed_kind, record.speed))
        })
    }
}
