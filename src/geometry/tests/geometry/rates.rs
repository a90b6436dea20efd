//! How speed and curvature change along a curve, against differences of both.

use crate::bends::curves;
use mapd_geometry::{Curve, Start, compile};

/// Half the stretch over which differences are taken `[m]`, and what they may be off, as a share.
const HALF: f64 = 1e-4;
const SHARE: f64 = 1e-4;
/// Change of speed that is left of parametric cubics, whose lengths are approximated `[1/m]`; it counts as none.
const UNEVEN: f64 = 1e-3;
/// Roundings by which both ways to a curvature may differ.
const ROUNDINGS: f64 = 64.0;

#[test]
fn rates_are_those_of_differences() {
    for (number, ((primitive, length), _)) in curves().into_iter().enumerate() {
        let compiled = compile(&primitive, length).expect("it compiles");
        let start = Start::new(10.0, -20.0, 0.3);
        let curve = Curve::new(compiled.kind, start, length, &compiled.coefficients);
        let curve = curve.expect("just compiled");
        for place in 1..20 {
            let u = length * f64::from(place) / 20.0;
            let rates = curve.rates(u);
            let [speed, curvature] = curve.speed_and_curvature(u);
            let off = (rates.speed - speed).abs().max((rates.curvature - curvature).abs());
            let most = ROUNDINGS * f64::EPSILON * (1.0 + curvature.abs());
            assert!(
                off <= most,
                "{number} at {u}: {rates:?}, not {speed} and {curvature}: off by {off:e}"
            );
            let change = |half: f64| {
                let (a, b) =
                    (curve.speed_and_curvature(u - half), curve.speed_and_curvature(u + half));
                [0, 1].map(|part| (b[part] - a[part]) / (2.0 * half))
            };
            let [[speed, curvature], [_, coarse]] = [change(HALF), change(2.0 * HALF)];
            let size = 1.0 + curvature.abs();
            assert!(
                (rates.speed_rate - speed).abs() <= UNEVEN,
                "{number} at {u}: {rates:?}, not {speed}"
            );
            if (coarse - curvature).abs() <= SHARE * size {
                let off = (rates.curvature_rate - curvature).abs();
                assert!(off <= 10.0 * SHARE * size, "{number} at {u}: {rates:?}, {curvature}");
            }
        }
    }
}
