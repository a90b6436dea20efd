//! What the ends of a part tell of it holds at every place of it.

use mapd_geometry::{Bends, Curve, ParameterRange, Primitive, Start, compile};

/// Parts that curves are cut into, and places of each that are looked at.
const PARTS: [u32; 5] = [1, 3, 8, 21, 64];
const PLACES: u32 = 40;
/// What rounding may be off, and the displacement of a curve along itself [as a share].
const ROUNDING: f64 = 1e-6;

fn cubic(u: [f64; 4], v: [f64; 4], length: f64) -> (Primitive, f64) {
    (Primitive::ParamPoly3 { u, v, range: ParameterRange::Normalized }, length)
}

/// Curves with the share of their finest parts of which something is told, in hundredths.
pub(crate) fn curves() -> Vec<((Primitive, f64), usize)> {
    vec![
        ((Primitive::Line, 30.0), 100),
        ((Primitive::Arc { curvature: -0.2 }, 20.0), 100),
        ((Primitive::Spiral { curvature_start: -0.05, curvature_end: 0.2 }, 25.0), 100),
        ((Primitive::Poly3 { v: [0.0, 0.1, -0.03, 0.002] }, 18.0), 100),
        // Turns of a crossroads, an S, one written as twice as long as it is, and one with a cusp.
        (cubic([0.0, 19.2, -9.6, 0.0], [0.0, 0.0, 9.6, 0.0], 15.5697), 100),
        (cubic([0.0, 12.924, -14.773, 9.849], [0.0, 0.0, 9.6, -6.4], 9.0), 100),
        (cubic([0.0, 30.0, 0.0, 0.0], [0.0, 0.0, 24.0, -16.0], 31.9), 100),
        (cubic([0.0, 19.2, -9.6, 0.0], [0.0, 0.0, 9.6, 0.0], 31.1394), 100),
        (cubic([0.0, 4.0, -4.0, 0.0], [0.0, 2.0, -4.0, 4.0], 3.0), 90),
    ]
}

fn check(curve: &Curve<'_>, bends: &Bends, [from, to]: [f64; 2], name: &str) {
    let at = |i: u32| from + (to - from) * (f64::from(i) / f64::from(PLACES));
    let Bends { curvature: [low, high], change, squared_length } = *bends;
    let size = low.abs().max(high.abs());
    let mut before: Option<(f64, [f64; 2])> = None;
    let mut length = 0.0;
    for i in 0..=PLACES {
        let [speed, curvature] = curve.speed_and_curvature(at(i));
        let slack = ROUNDING * (1.0 + size);
        assert!(low - slack <= curvature && curvature <= high + slack, "{name} {i}: {curvature}");
        if let Some((u, [speed_before, curvature_before])) =
            before.replace((at(i), [speed, curvature]))
        {
            let step = 0.5 * (speed + speed_before) * (at(i) - u);
            length += step;
            let grown = (curvature - curvature_before).abs();
            assert!(grown <= change * step * 1.01 + slack, "{name} {i}: {grown} in {step}");
        }
    }
    assert!(length * length <= squared_length * 1.01 + ROUNDING, "{name}: {length}");
}

#[test]
fn ends_tell_how_parts_bend() {
    for (number, ((primitive, length), told_of)) in curves().into_iter().enumerate() {
        let compiled = compile(&primitive, length).expect("it compiles");
        let start = Start::new(10.0, -20.0, 0.3);
        let curve = Curve::new(compiled.kind, start, length, &compiled.coefficients);
        let curve = curve.expect("just compiled");
        for parts in PARTS {
            let mut walk = curve.bends_from(0.0).expect("no transformed curve");
            let mut told = 0;
            for part in 0..parts {
                let at = |part: u32| length * (f64::from(part) / f64::from(parts));
                let ends = [at(part), at(part + 1)];
                if let Some(bends) = walk.up_to(ends[1]) {
                    told += 1;
                    check(&curve, &bends, ends, &format!("curve {number}, {part} of {parts}"));
                }
            }
            assert!(parts < 64 || told >= 64 * told_of / 100, "curve {number}: {told} of {parts}");
        }
    }
}

/// What follows a place that is not on the curve, or lies behind, is never told of: its begin would be another.
#[test]
fn parts_come_one_behind_the_other() {
    let (primitive, length) = cubic([0.0, 19.2, -9.6, 0.0], [0.0, 0.0, 9.6, 0.0], 15.5697);
    let compiled = compile(&primitive, length).expect("it compiles");
    let start = Start::new(0.0, 0.0, 0.0);
    let curve = Curve::new(compiled.kind, start, length, &compiled.coefficients);
    let curve = curve.expect("just compiled");
    for astray in [-1.0, 0.5, 16.0, f64::NAN] {
        let mut walk = curve.bends_from(0.0).expect("a cubic");
        assert!(walk.up_to(1.0).is_some());
        assert!(walk.up_to(astray).is_none(), "{astray}");
        assert!(walk.up_to(2.0).is_none() && walk.up_to(3.0).is_none(), "{astray}");
    }
    assert!(curve.bends_from(-0.1).is_none_or(|mut walk| walk.up_to(1.0).is_none()));
}
