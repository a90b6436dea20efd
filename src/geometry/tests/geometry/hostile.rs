//! Whatever the numbers are: an error or an answer, never a panic and never an endless loop.

use crate::oracle::{Random, shape};
use mapd_geometry::{Curve, CurveKind, ParameterRange, Primitive, Start, compile};

/// Numbers that break arithmetic.
const SPECIAL: [f64; 20] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.01,
    1e-6,
    1e-310,
    f64::MIN_POSITIVE,
    f64::EPSILON,
    1e6,
    -1e6,
    1e15,
    1e150,
    -1e150,
    f64::MAX,
    f64::MIN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    50.0,
];
/// More numbers than any honest curve needs.
const MOST_NUMBERS: usize = 400_000;
const KINDS: [CurveKind; 6] = [
    CurveKind::Line,
    CurveKind::Arc,
    CurveKind::Spiral,
    CurveKind::Poly3,
    CurveKind::ParamPoly3,
    CurveKind::Transformed,
];

fn four(random: &mut Random) -> [f64; 4] {
    std::array::from_fn(|_| random.pick(&SPECIAL))
}

/// Calls everything there is. Reaching the end is the test; what comes out may be not-a-number.
fn exercise(curve: &Curve<'_>, random: &mut Random) {
    let length = curve.length();
    for _ in 0..3 {
        let u = random.pick(&[0.0, length, 0.3 * length, f64::NAN, f64::INFINITY, -1.0]);
        let _ = (curve.evaluate(u), curve.heading(u), curve.curvature(u));
        let (x, y) = (random.pick(&SPECIAL), random.pick(&SPECIAL));
        let (lo, hi, seed) = (random.pick(&SPECIAL), random.pick(&SPECIAL), random.pick(&SPECIAL));
        for foot in [curve.project(x, y), curve.project_from(x, y, seed, lo, hi)] {
            assert!(foot.u >= 0.0 && foot.u <= length, "{curve:?}: {foot:?}");
        }
    }
}

#[test]
fn hostile_primitives_give_an_error_or_a_finite_curve() {
    let mut random = Random(31);
    for _ in 0..3000 {
        let length = random.pick(&SPECIAL);
        let primitive = match random.index(5) {
            0 => Primitive::Line,
            1 => Primitive::Arc { curvature: random.pick(&SPECIAL) },
            2 => Primitive::Spiral {
                curvature_start: random.pick(&SPECIAL),
                curvature_end: random.pick(&SPECIAL),
            },
            3 => Primitive::Poly3 { v: four(&mut random) },
            _ => Primitive::ParamPoly3 {
                u: four(&mut random),
                v: four(&mut random),
                range: random.pick(&[ParameterRange::ArcLength, ParameterRange::Normalized]),
            },
        };
        match compile(&primitive, length) {
            Err(error) => assert!(!error.to_string().is_empty()),
            Ok(compiled) => {
                assert!(length >= 0.0 && length.is_finite(), "accepted a length of {length}");
                assert!(compiled.coefficients.len() <= MOST_NUMBERS);
                assert!(
                    compiled.coefficients.iter().all(|c| c.is_finite()),
                    "{primitive:?} over {length}"
                );
                assert!(compiled.error.is_finite() && compiled.length_mismatch.is_finite());
                let start = Start::new(0.0, 0.0, 0.0);
                let curve = Curve::new(compiled.kind, start, length, &compiled.coefficients)
                    .expect("as compiled");
                for u in [0.0, 0.5 * length, length] {
                    let p = curve.evaluate(u);
                    assert!(
                        [p.x, p.y, p.cos, p.sin, p.heading].iter().all(|n| n.is_finite()),
                        "{primitive:?} over {length}: {p:?}"
                    );
                }
                exercise(&curve, &mut random);
            }
        }
    }
}

#[test]
fn numbers_that_are_not_finite_are_refused() {
    let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let fine = [0.0, 1.0, 0.0, 0.0];
    let mut primitives = vec![];
    for bad in bad {
        primitives.push(Primitive::Arc { curvature: bad });
        primitives.push(Primitive::Spiral { curvature_start: bad, curvature_end: 0.0 });
        primitives.push(Primitive::Spiral { curvature_start: 0.0, curvature_end: bad });
        for i in 0..4 {
            let mut c = fine;
            c[i] = bad;
            primitives.push(Primitive::Poly3 { v: c });
            for range in [ParameterRange::ArcLength, ParameterRange::Normalized] {
                primitives.push(Primitive::ParamPoly3 { u: c, v: fine, range });
                primitives.push(Primitive::ParamPoly3 { u: fine, v: c, range });
            }
        }
    }
    for primitive in primitives {
        for length in [0.0, 1.0, 100.0] {
            assert!(compile(&primitive, length).is_err(), "{primitive:?} over {length}");
        }
    }
    for length in [f64::NAN, f64::INFINITY, -1.0, -1e-12, f64::NEG_INFINITY] {
        assert!(compile(&Primitive::Line, length).is_err(), "length {length}");
    }
}

#[test]
fn absurd_curves_are_refused() {
    let parametric = |u, v| Primitive::ParamPoly3 { u, v, range: ParameterRange::Normalized };
    for (primitive, length) in [
        (Primitive::Arc { curvature: 1e12 }, 1e6),
        (Primitive::Spiral { curvature_start: 0.0, curvature_end: 1e6 }, 1e6),
        (Primitive::Spiral { curvature_start: 1e300, curvature_end: -1e300 }, 10.0),
        // Standing still: everywhere, at the start, at a cusp in the middle.
        (parametric([0.0; 4], [0.0; 4]), 10.0),
        (parametric([5.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]), 10.0),
        (parametric([0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]), 2.0),
        (parametric([0.0, 1.0, -1.0, 0.0], [0.0; 4]), 1.0),
        (parametric([0.0, 0.5, -0.5, 0.0], [0.0, 0.75, -1.5, 1.0]), 1.0),
    ] {
        assert!(compile(&primitive, length).is_err(), "{primitive:?} over {length}");
    }
}

/// A cusp that no regular grid of samples meets is found all the same.
#[test]
fn cusps_are_found_wherever_they_are() {
    let mut random = Random(32);
    for _ in 0..200 {
        let q = random.range(0.01, 0.99);
        // dr/dp = (p − q)·(1, p): both components vanish at q.
        let u = [0.0, -q, 0.5, 0.0];
        let v = [0.0, 0.0, -0.5 * q, 1.0 / 3.0];
        let primitive = Primitive::ParamPoly3 { u, v, range: ParameterRange::Normalized };
        assert!(compile(&primitive, 1.0).is_err(), "cusp at {q}");
    }
}

#[test]
fn slices_of_the_wrong_length_are_refused() {
    let start = Start::new(0.0, 0.0, 0.0);
    for kind in KINDS {
        let (parameters, numbers) = shape(kind);
        for count in 0..=120 {
            let coefficients = vec![0.1; count];
            let fits = match numbers {
                0 => count == parameters,
                _ => count > parameters && (count - parameters) % numbers == 0,
            };
            let curve = Curve::new(kind, start, 10.0, &coefficients);
            assert_eq!(curve.is_some(), fits, "{kind:?} with {count} numbers");
        }
        let coefficients = vec![0.1; parameters + 2 * numbers];
        assert!(Curve::new(kind, start, 10.0, &coefficients).is_some());
        for length in [-1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(Curve::new(kind, start, length, &coefficients).is_none(), "{kind:?}, {length}");
        }
    }
}

#[test]
fn garbage_coefficients_always_give_an_answer() {
    let mut random = Random(33);
    for round in 0..3000 {
        let kind = random.pick(&KINDS);
        let (parameters, numbers) = shape(kind);
        let count = parameters + numbers * (1 + random.index(5));
        let coefficients: Vec<f64> = (0..count)
            .map(|_| if round % 3 == 0 { random.range(-2.0, 2.0) } else { random.pick(&SPECIAL) })
            .collect();
        let start = Start {
            x: random.pick(&SPECIAL),
            y: random.pick(&SPECIAL),
            heading: random.pick(&SPECIAL),
            cos: random.pick(&SPECIAL),
            sin: random.pick(&SPECIAL),
        };
        let length = random.pick(&[0.0, 1e-310, 1e-6, 1.0, 50.0, 1e9, f64::MAX]);
        let curve = Curve::new(kind, start, length, &coefficients).expect("the count fits");
        exercise(&curve, &mut random);
    }
}
