//! Lengths along a lane's centre line, and the speed limit there.

use crate::lane::Lane;
use crate::profile::{At, Slope};
use mapd_archive::SpeedKind;

/// Places of the two-point Gauss–Legendre rule on −1 to 1, one over the square root of 3.
const GAUSS: f64 = 0.577_350_269_189_625_8;

impl Lane<'_> {
    /// Length of the centre line in plan view between two places on the road `[m]`, from the file's own polynomials: where the
    /// stored polyline bends, the integral is cut. s outside the lane's section counts as its nearer end.
    pub fn length_between(&self, a: f64, b: f64) -> f64 {
        let section = self.section();
        let (start, end) = (section.s_start(), section.s_end());
        let inside = |s: f64| mapd_geometry::clamp(s, start, end.max(start));
        let (from, to) = (inside(a.min(b)), inside(a.max(b)));
        let line = self.center_line();
        let (mut sum, mut last) = (0.0, from);
        for s in line.stations().filter(|s| *s > from && *s < to).chain([to]) {
            if s > last {
                sum += self.stretch(last, s);
                last = s;
            }
        }
        sum
    }

    /// Length of a stretch on which the lane is smooth.
    fn stretch(&self, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        half * (self.growth(middle - half * GAUSS) + self.growth(middle + half * GAUSS))
    }

    /// Metres of centre line per metre of s, in plan view.
    fn growth(&self, s: f64) -> f64 {
        let at = At::new(s);
        let edges = self.edge_slopes(at);
        let center = Slope {
            value: 0.5 * (edges.inner.value + edges.outer.value),
            derivative: 0.5 * (edges.inner.derivative + edges.outer.derivative),
        };
        let (cos, sin) = self.road.roll(at);
        let piece = self.road.piece_at(at);
        let curvature = piece.map_or(0.0, |piece| piece.curve.curvature(at.s - piece.s));
        let along = 1.0 - curvature * center.value * cos;
        let turned = if sin == 0.0 { 0.0 } else { self.road.superelevation_slope(at) };
        let across = center.derivative * cos - center.value * sin * turned;
        (along * along + across * across).sqrt()
    }

    /// Speed limit at s `[m/s]`: the lane's own record, else that of the road's type (OpenDRIVE 1.8.1, 11.8.2, 10.4).
    /// Infinite where the file says `no limit`; none where it says nothing. Signals are not looked at.
    pub fn speed_limit_at(&self, s: f64) -> Option<f64> {
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
