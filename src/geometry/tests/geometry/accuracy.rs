//! Compiled curves against quadrature of their definitions.

use crate::oracle::{Oracle, Random, Sample, shape};
use mapd_geometry::{CurveKind, ParameterRange, Primitive, Start, compile, normalize_angle};
use std::f64::consts::{PI, TAU};

/// Position error allowed to lines, arcs and spirals `[m]`.
const EXACT: f64 = 1e-9;
/// Heading error allowed to them `[rad]`, plus this per radian of heading for rounding.
const EXACT_HEADING: f64 = 1e-12;
/// Position error allowed to poly3 and paramPoly3 `[m]`.
const CUBIC: f64 = 1e-6;
/// Rounding of inertial coordinates of some 10 km, in the values and in the oracle `[m]`.
const ROUNDING: f64 = 2e-11;
/// Places looked at per curve, besides its ends and joints.
const PLACES: usize = 6;

/// Compares a primitive with the oracle; returns the largest position error.
fn check(primitive: Primitive, length: f64, start: Start, random: &mut Random) -> f64 {
    let sample = Sample::new(primitive, length, start);
    let (curve, oracle) = (sample.curve(), Oracle::new(&sample));
    let cubic = matches!(sample.compiled.kind, CurveKind::Poly3 | CurveKind::ParamPoly3);
    let mut places = vec![0.0, length];
    places.extend((0..PLACES).map(|_| random.range(0.0, length)));
    let pieces = sample.pieces();
    places.extend((1..pieces).step_by(pieces / 4 + 1).map(|i| length * i as f64 / pieces as f64));
    let mut worst = 0f64;
    for u in places {
        let (found, exact) = (curve.evaluate(u), oracle.at(u));
        let error = (found.x - exact.x).hypot(found.y - exact.y);
        let context =
            || format!("{primitive:?} over {length} at {u}: {found:?}, exactly {exact:?}");
        assert!(error <= if cubic { CUBIC } else { EXACT }, "{error:e} m: {}", context());
        assert!(
            error <= sample.compiled.error + ROUNDING,
            "promised {:e}, found {error:e}: {}",
            sample.compiled.error,
            context()
        );
        // A cubic errs along itself, so that its heading errs by curvature times that.
        let allowed = EXACT_HEADING * (1.0 + exact.heading.abs())
            + if cubic { CUBIC * exact.curvature.abs() } else { 0.0 };
        assert!((found.heading - exact.heading).abs() <= allowed, "heading: {}", context());
        let (sin, cos) = found.heading.sin_cos();
        assert!(
            (found.cos - cos).hypot(found.sin - sin) <= EXACT_HEADING * (1.0 + exact.heading.abs()),
            "tangent: {}",
            context()
        );
        let allowed = if cubic { 1e-4 } else { 1e-12 } * (1e-3 + exact.curvature.abs());
        assert!((found.curvature - exact.curvature).abs() <= allowed, "curvature: {}", context());
        assert_eq!(curve.heading(u).to_bits(), found.heading.to_bits());
        assert_eq!(curve.curvature(u).to_bits(), found.curvature.to_bits());
        worst = worst.max(error);
    }
    let mismatch = if matches!(primitive, Primitive::ParamPoly3 { .. }) {
        oracle.true_length() - length
    } else {
        0.0
    };
    assert!(
        (sample.compiled.length_mismatch - mismatch).abs() <= 1e-9 * (1.0 + length),
        "{primitive:?} over {length}: mismatch {} instead of {mismatch}",
        sample.compiled.length_mismatch
    );
    worst
}

#[test]
fn arcs_and_spirals_agree_with_quadrature() {
    let mut random = Random(1);
    for _ in 0..3000 {
        let (primitive, length) = random.arc_or_spiral(6.0);
        let start = random.start();
        check(primitive, length, start, &mut random);
    }
}

#[test]
fn windings_agree_with_quadrature() {
    let mut random = Random(2);
    for _ in 0..60 {
        let (primitive, length) = random.arc_or_spiral(200.0);
        let start = random.start();
        check(primitive, length, start, &mut random);
    }
}

#[test]
fn cubics_agree_with_quadrature() {
    let mut random = Random(3);
    for _ in 0..400 {
        let (primitive, length) = random.cubic();
        let start = random.start();
        check(primitive, length, start, &mut random);
    }
}

#[test]
fn degenerate_curves_agree_with_quadrature() {
    let spiral =
        |curvature_start, curvature_end| Primitive::Spiral { curvature_start, curvature_end };
    let arc = |curvature| Primitive::Arc { curvature };
    let start = Start::new(-3.0, 4.0, 1.0);
    let mut random = Random(4);
    for length in [0.0, 1e-9, 1e-6, 1.0, 1000.0] {
        for primitive in [
            Primitive::Line,
            arc(0.0),
            arc(-0.0),
            arc(1e-300),
            arc(1e-17),
            arc(-1e-9),
            arc(0.2),
            arc(-0.2),
            spiral(0.0, 0.0),
            spiral(0.01, 0.01),
            spiral(0.01, 0.01 + 1e-15),
            spiral(0.0, 1e-12),
            spiral(1e-17, -1e-17),
            spiral(-0.05, 0.05),
            spiral(0.2, 0.0),
            spiral(0.2, -0.2),
            spiral(0.2, 0.199),
        ] {
            check(primitive, length, start, &mut random);
        }
    }
    // A spiral so long that its pieces are limited by the error, not by the angle.
    check(spiral(-1e-3, 1e-3), 1000.0, start, &mut random);
    check(spiral(0.0, 1e-4), 1e4, start, &mut random);
}

#[test]
fn unusual_cubics_agree_with_quadrature() {
    let start = Start::new(1.0, 2.0, 0.5);
    let mut random = Random(5);
    let parametric = |u, v, range| Primitive::ParamPoly3 { u, v, range };
    for (primitive, length) in [
        // Straight, and of another length than written.
        (parametric([0.0, 10.0, 0.0, 0.0], [0.0; 4], ParameterRange::Normalized), 12.0),
        (parametric([0.0, 1.0, 0.0, 0.0], [0.0; 4], ParameterRange::ArcLength), 12.0),
        // The parameter's unit taken for the other one.
        (parametric([0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1e-2, 0.0], ParameterRange::Normalized), 30.0),
        // Not starting at the start, nor along it.
        (parametric([3.0, 1.0, 0.0, 0.0], [-2.0, 1.0, 0.01, 0.0], ParameterRange::ArcLength), 20.0),
        // Backwards: b < 0.
        (
            parametric([0.0, -20.0, 0.0, 0.0], [0.0, 0.0, 3.0, 0.0], ParameterRange::Normalized),
            20.0,
        ),
        // A tight quarter turn.
        (parametric([0.0, 8.0, 0.0, -3.0], [0.0, 0.0, 8.0, -3.0], ParameterRange::Normalized), 8.0),
        (Primitive::Poly3 { v: [0.0; 4] }, 50.0),
        (Primitive::Poly3 { v: [1.5, 2.0, 0.0, 0.0] }, 50.0),
        (Primitive::Poly3 { v: [0.0, 0.0, 0.05, -1e-3] }, 40.0),
        (Primitive::Poly3 { v: [0.0, 0.0, 0.0, 0.0] }, 1e-6),
        (Primitive::Poly3 { v: [0.0, 0.1, 0.0, 0.0] }, 0.0),
    ] {
        check(primitive, length, start, &mut random);
    }
}

/// The tangent of a cubic can turn by nearly a full circle, and its heading has to follow past ±π.
#[test]
fn heading_of_a_cubic_loop_is_continuous() {
    // dr/dp = (2q² − 1, ±2q) with q = 4p − 2 runs around the origin.
    let u = [0.0, 7.0, -16.0, 32.0 / 3.0];
    for side in [1.0, -1.0] {
        let v = [0.0, -4.0 * side, 4.0 * side, 0.0];
        let primitive = Primitive::ParamPoly3 { u, v, range: ParameterRange::Normalized };
        let mut random = Random(6);
        let sample = Sample::new(primitive, 3.0, Start::new(0.0, 0.0, 2.0));
        check(primitive, 3.0, sample.start, &mut random);
        let curve = sample.curve();
        let total = (curve.heading(3.0) - curve.heading(0.0)).abs();
        assert!((total - (TAU - 2.0 * 4f64.atan2(7.0))).abs() < 1e-6, "turned by {total}");
        let headings: Vec<f64> = (0..=3000).map(|i| curve.heading(i as f64 * 1e-3)).collect();
        for pair in headings.windows(2) {
            assert!((pair[1] - pair[0]).abs() < 0.05, "{pair:?}");
        }
    }
}

#[test]
fn pieces_join_without_a_gap() {
    let mut random = Random(7);
    for round in 0..400 {
        let (primitive, length) =
            if round % 2 == 0 { random.arc_or_spiral(100.0) } else { random.cubic() };
        let sample = Sample::new(primitive, length, Start::new(0.0, 0.0, 0.0));
        let (curve, pieces) = (sample.curve(), sample.pieces());
        for joint in 1..pieces {
            let u = length * joint as f64 / pieces as f64;
            // One part in 1e12 of the length to either side: the curve itself moves by less than the tolerance.
            let (a, b) = (curve.evaluate(u * (1.0 - 1e-12)), curve.evaluate(u * (1.0 + 1e-12)));
            let gap = (a.x - b.x).hypot(a.y - b.y);
            assert!(
                gap <= 2.0 * sample.compiled.error + 1e-11 * length,
                "{primitive:?}: {gap:e} m"
            );
        }
    }
}

#[test]
fn coefficients_are_the_primitive_and_whole_pieces() {
    let mut random = Random(8);
    for round in 0..200 {
        let (primitive, length) =
            if round % 2 == 0 { random.arc_or_spiral(20.0) } else { random.cubic() };
        let sample = Sample::new(primitive, length, Start::new(0.0, 0.0, 0.0));
        let written = match primitive {
            Primitive::Line => vec![],
            Primitive::Arc { curvature } => vec![curvature],
            Primitive::Spiral { curvature_start, curvature_end } => {
                vec![curvature_start, curvature_end]
            }
            Primitive::Poly3 { v } => v.to_vec(),
            Primitive::ParamPoly3 { u, v, .. } => [u, v].concat(),
        };
        let curve = sample.curve();
        assert_eq!(curve.primitive_parameters(), written);
        assert_eq!(curve.length().to_bits(), length.to_bits());
        let (parameters, numbers) = shape(sample.compiled.kind);
        assert_eq!(sample.compiled.coefficients.len(), parameters + sample.pieces() * numbers);
        assert_eq!(compile(&primitive, length).as_ref(), Ok(&sample.compiled), "not repeatable");
    }
}

#[test]
fn u_beyond_the_curve_is_its_end() {
    let mut random = Random(9);
    for round in 0..100 {
        let (primitive, length) =
            if round % 2 == 0 { random.arc_or_spiral(20.0) } else { random.cubic() };
        let sample = Sample::new(primitive, length, random.start());
        let curve = sample.curve();
        for u in [-1.0, -0.0, f64::NEG_INFINITY] {
            assert_eq!(curve.evaluate(u), curve.evaluate(0.0));
        }
        for u in [length * 1.5, f64::INFINITY] {
            assert_eq!(curve.evaluate(u), curve.evaluate(length));
        }
    }
}

#[test]
fn codes_of_kinds_are_total() {
    for code in 0..=u8::MAX {
        let kind = CurveKind::from_code(code);
        assert_eq!(kind.is_some(), code <= 5, "{code}");
        assert_eq!(kind.map(CurveKind::code), kind.map(|_| code));
    }
}

#[test]
fn angles_are_normalized() {
    let mut random = Random(10);
    let mut angles =
        vec![0.0, PI, -PI, 3.0 * PI, -3.0 * PI, TAU, -TAU, PI.next_up(), (-PI).next_down()];
    angles.extend((0..10_000).map(|_| random.range(-1e4, 1e4)));
    for angle in angles {
        let normal = normalize_angle(angle);
        assert!(normal > -PI && normal <= PI, "{angle} became {normal}");
        let turns = (angle - normal) / TAU;
        assert!((turns - turns.round()).abs() < 1e-11, "{angle} became {normal}");
    }
    for huge in [1e15, -1e18, 1e300, f64::MAX] {
        let normal = normalize_angle(huge);
        assert!(normal > -PI && normal <= PI, "{huge} became {normal}");
    }
    assert!(normalize_angle(f64::NAN).is_nan() && normalize_angle(f64::INFINITY).is_nan());
}

#[test]
fn cubic_and_its_derivatives() {
    let cubic = mapd_geometry::Cubic { a: 1.0, b: -2.0, c: 3.0, d: -4.0 };
    for (ds, value, slope, bend) in
        [(0.0, 1.0, -2.0, 6.0), (2.0, -23.0, -38.0, -42.0), (-1.0, 10.0, -20.0, 30.0)]
    {
        assert_eq!(cubic.value(ds), value);
        assert_eq!(cubic.derivative(ds), slope);
        assert_eq!(cubic.second_derivative(ds), bend);
    }
}
