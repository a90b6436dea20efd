//! Compiled curves against adaptive integration with 32 digits, in the curve's own frame.

use crate::double::{Double, Rule};
use crate::oracle::{Random, Sample};
use mapd_geometry::{ParameterRange, Primitive, Start};

/// Position error allowed to lines, arcs and spirals `[m]`, and heading error `[rad]`, once more per radian of heading.
const EXACT: f64 = 1e-9;
const EXACT_HEADING: f64 = 1e-12;
/// Position error allowed to poly3 and paramPoly3 `[m]`.
const CUBIC: f64 = 1e-6;
/// Random curves of each kind.
const CURVES: usize = 150;
/// Places looked at on each.
const PLACES: usize = 4;
/// Newton's steps to a parameter: from 16 digits to 32, and one more.
const STEPS: usize = 6;

const ORIGIN: Start = Start { x: 0.0, y: 0.0, heading: 0.0, cos: 1.0, sin: 0.0 };

/// What the double-double numbers themselves must give.
#[test]
fn thirty_digits() {
    let near =
        |a: Double, b: Double, what: &str| assert!((a - b).abs() < 1e-29, "{what}: {a:?}, {b:?}");
    let third = Double::from(1.0) / 3.0.into();
    near(third * 3.0.into(), 1.0.into(), "a third");
    near(Double::from(2.0).sqrt() * Double::from(2.0).sqrt(), 2.0.into(), "root of two");
    for x in [0.1, 0.7, 2.0, 5.0, -9.3] {
        let (sin, cos) = Double::from(x).sin_cos();
        near(sin * sin + cos * cos, 1.0.into(), "a circle");
        assert!(
            (sin.value() - x.sin()).abs() < 1e-15 && (cos.value() - x.cos()).abs() < 1e-15,
            "{x}"
        );
        // The integral of the cosine is the sine.
        let [area] = Rule::new().integrate(&|t: Double| [t.sin_cos().1], 0.0.into(), x.into());
        assert!((area - sin).abs() < 1e-23, "{x}: {area:?}");
    }
}

#[test]
fn lines_arcs_and_spirals() {
    let (mut random, rule) = (Random(40), Rule::new());
    let mut shapes = vec![
        (Primitive::Line, 123.4),
        (Primitive::Arc { curvature: 0.0 }, 50.0),
        (Primitive::Spiral { curvature_start: 0.01, curvature_end: 0.01 + 1e-15 }, 80.0),
        (Primitive::Spiral { curvature_start: -0.05, curvature_end: 0.05 }, 200.0),
        (Primitive::Spiral { curvature_start: 0.0, curvature_end: 1e-12 }, 1_000.0),
    ];
    shapes.extend((0..CURVES).map(|_| random.arc_or_spiral(6.0)));
    for (primitive, length) in shapes {
        let (from, to) = match primitive {
            Primitive::Arc { curvature } => (curvature, curvature),
            Primitive::Spiral { curvature_start, curvature_end } => {
                (curvature_start, curvature_end)
            }
            _ => (0.0, 0.0),
        };
        let change = (Double::from(to) - from.into()) / length.into();
        let heading = |w: Double| w * (Double::from(from) + change * w * 0.5.into());
        let sample = Sample::new(primitive, length, ORIGIN);
        let mut places = vec![length];
        places.extend((0..PLACES).map(|_| random.range(0.0, length)));
        for u in places {
            let direction = |w: Double| {
                let (sin, cos) = heading(w).sin_cos();
                [cos, sin]
            };
            let [x, y] = rule.integrate(&direction, 0.0.into(), u.into());
            let found = sample.curve().evaluate(u);
            let off = (Double::from(found.x) - x).abs().hypot((Double::from(found.y) - y).abs());
            assert!(off <= EXACT, "{primitive:?} over {length} at {u}: {off:e} m");
            let turned = heading(u.into());
            let off = (Double::from(found.heading) - turned).abs();
            assert!(
                off <= EXACT_HEADING * (1.0 + turned.abs()),
                "{primitive:?} over {length} at {u}: {off:e} rad"
            );
        }
    }
}

#[test]
fn cubics() {
    let (mut random, rule) = (Random(41), Rule::new());
    for _ in 0..CURVES {
        let (primitive, length) = random.cubic();
        let (u, v, end) = match primitive {
            Primitive::Poly3 { v } => ([0.0, 1.0, 0.0, 0.0], v, None),
            Primitive::ParamPoly3 { u, v, range: ParameterRange::Normalized } => (u, v, Some(1.0)),
            Primitive::ParamPoly3 { u, v, .. } => (u, v, Some(length)),
            _ => continue,
        };
        let value = |c: &[f64; 4], p: Double| {
            ((Double::from(c[3]) * p + c[2].into()) * p + c[1].into()) * p + c[0].into()
        };
        let slope = |c: &[f64; 4], p: Double| {
            (Double::from(c[3]) * 3.0.into() * p + (2.0 * c[2]).into()) * p + c[1].into()
        };
        let speed = |p: Double| {
            let (a, b) = (slope(&u, p), slope(&v, p));
            [(a * a + b * b).sqrt()]
        };
        let arc = |p: Double| rule.integrate(&speed, 0.0.into(), p)[0];
        // A poly3 ends where its true length is the stated one; a paramPoly3 is scaled to it.
        let scale = end.map_or(Double::from(1.0), |end| arc(end.into()) / length.into());
        let sample = Sample::new(primitive, length, ORIGIN);
        for place in 0..PLACES {
            let at = if place == 0 { length } else { random.range(0.0, length) };
            let wanted = scale * at.into();
            let mut p = Double::from(end.unwrap_or(length) * at / length);
            for _ in 0..STEPS {
                p = p - (arc(p) - wanted) / speed(p)[0];
            }
            let found = sample.curve().evaluate(at);
            let off = (Double::from(found.x) - value(&u, p))
                .abs()
                .hypot((Double::from(found.y) - value(&v, p)).abs());
            assert!(off <= CUBIC, "{primitive:?} over {length} at {at}: {off:e} m");
        }
    }
}
