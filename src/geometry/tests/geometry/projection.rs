//! Projection: the inverse of evaluation, and never farther than any sampled point.

use crate::oracle::{Random, Sample};
use mapd_geometry::{Curve, ParameterRange, Primitive, Projection, Start, clamp};

/// Agreement of a foot with the point it came from, along the curve and across it `[m]`.
const ROUND_TRIP: f64 = 1e-7;
/// How much farther than the nearest sample a foot may be `[m]`.
const FARTHER: f64 = 1e-7;
/// Largest lateral offset `[m]`.
const LATERAL: f64 = 8.0;
/// Smallest 1 − κt: the foot is well conditioned there.
const CONDITION: f64 = 0.2;

/// A random curve, of at least a metre.
fn curve_of(random: &mut Random, turning: f64) -> Sample {
    loop {
        let (primitive, length) = match random.index(4) {
            0 => (Primitive::Line, random.magnitude(1.0, 1e3)),
            1 => random.cubic(),
            _ => random.arc_or_spiral(turning),
        };
        if length >= 1.0 {
            let start = random.start();
            return Sample::new(primitive, length, start);
        }
    }
}

/// What has to hold for every foot: it lies on the curve, and its numbers fit each other.
fn check_foot(curve: &Curve<'_>, foot: &Projection, x: f64, y: f64, lo: f64, hi: f64) {
    assert!(foot.u >= lo && foot.u <= hi, "{foot:?} outside [{lo}, {hi}]");
    let point = curve.evaluate(foot.u);
    assert!((point.x - foot.x).hypot(point.y - foot.y) < 1e-9, "{foot:?} is not at {point:?}");
    assert!((point.cos - foot.cos).hypot(point.sin - foot.sin) < 1e-12);
    assert_eq!(point.curvature.to_bits(), foot.curvature.to_bits());
    let (dx, dy) = (x - foot.x, y - foot.y);
    let scale = 1.0 + dx.hypot(dy);
    assert!((foot.distance_squared - (dx * dx + dy * dy)).abs() < 1e-8 * scale);
    assert!((foot.lateral - (dy * foot.cos - dx * foot.sin)).abs() < 1e-8 * scale);
    let ahead = dx * foot.cos + dy * foot.sin;
    if foot.clamped {
        assert!(foot.u == lo || foot.u == hi, "{foot:?} clamped inside [{lo}, {hi}]");
        assert!(ahead.abs() > 0.0);
    } else {
        assert!(ahead.abs() < 1e-5 * scale, "{foot:?}: point {ahead} m ahead of a free foot");
    }
}

/// The smallest distance to sampled points of [lo, hi].
fn sampled(curve: &Curve<'_>, x: f64, y: f64, lo: f64, hi: f64, count: usize) -> f64 {
    (0..=count)
        .map(|i| curve.evaluate(lo + (hi - lo) * i as f64 / count as f64))
        .map(|p| (p.x - x).hypot(p.y - y))
        .fold(f64::INFINITY, f64::min)
}

/// Whether 1 − κt stays positive from the seed to the foot, so that no other foot lies between.
fn one_foot_between(curve: &Curve<'_>, x: f64, y: f64, seed: f64, u: f64) -> bool {
    (0..=16).map(|i| curve.evaluate(seed + (u - seed) * f64::from(i) / 16.0)).all(|p| {
        let t = (y - p.y) * p.cos - (x - p.x) * p.sin;
        1.0 - p.curvature * t >= 0.5 * CONDITION
    })
}

#[test]
fn projection_from_a_seed_inverts_evaluation() {
    let mut random = Random(21);
    let mut checked = 0;
    for _ in 0..4000 {
        let sample = curve_of(&mut random, 100.0);
        let curve = sample.curve();
        let u = random.range(0.0, sample.length);
        let t = random.range(-LATERAL, LATERAL);
        let at = curve.evaluate(u);
        if 1.0 - at.curvature * t < CONDITION {
            continue;
        }
        let (x, y) = (at.x - t * at.sin, at.y + t * at.cos);
        // A seed as the index gives it: within 2.5 m, and within a quarter of a radian.
        let reach = 2.5f64.min(0.25 / at.curvature.abs().max(1e-9));
        let seed = u + random.range(-reach, reach);
        if !one_foot_between(&curve, x, y, clamp(seed, 0.0, sample.length), u) {
            continue;
        }
        checked += 1;
        let foot = curve.project_from(x, y, seed, 0.0, sample.length);
        let context =
            format!("{:?} over {}: u {u}, t {t}, seed {seed}", sample.primitive, sample.length);
        assert!((foot.u - u).abs() < ROUND_TRIP, "{context}: {foot:?}");
        assert!((foot.lateral - t).abs() < ROUND_TRIP, "{context}: {foot:?}");
        check_foot(&curve, &foot, x, y, 0.0, sample.length);
    }
    assert!(checked > 2000, "only {checked} of 4000 were well conditioned");
}

#[test]
fn projection_onto_the_whole_curve_is_nearest() {
    let mut random = Random(22);
    for _ in 0..1500 {
        let sample = curve_of(&mut random, 12.0);
        let curve = sample.curve();
        // Around the curve, out to about its own size.
        let near = curve.evaluate(random.range(0.0, sample.length));
        let reach = random.magnitude(0.01, 1.0) * sample.length.max(20.0);
        let (x, y) = (near.x + random.range(-reach, reach), near.y + random.range(-reach, reach));
        let foot = curve.project(x, y);
        check_foot(&curve, &foot, x, y, 0.0, sample.length);
        let nearest = sampled(&curve, x, y, 0.0, sample.length, 400);
        assert!(
            foot.distance_squared.sqrt() <= nearest + FARTHER,
            "{:?} over {} from ({x}, {y}): {foot:?}, but a sample is {nearest} away",
            sample.primitive,
            sample.length
        );
    }
}

/// Several turns of a spiral lie beside each other, and the centre is almost equally far from all of them.
#[test]
fn projection_finds_the_right_turn_of_a_winding_spiral() {
    let mut random = Random(23);
    let spirals = [
        (0.2, 0.02, 700.0),
        (0.02, 0.2, 700.0),
        (0.2, 0.19, 1000.0),
        (-0.2, 0.2, 300.0),
        (0.05, 0.0501, 500.0),
    ];
    for (curvature_start, curvature_end, length) in spirals {
        let primitive = Primitive::Spiral { curvature_start, curvature_end };
        let sample = Sample::new(primitive, length, Start::new(0.0, 0.0, 0.3));
        let curve = sample.curve();
        let check = |x: f64, y: f64| {
            let foot = curve.project(x, y);
            check_foot(&curve, &foot, x, y, 0.0, length);
            let nearest = sampled(&curve, x, y, 0.0, length, 8000);
            assert!(
                foot.distance_squared.sqrt() <= nearest + FARTHER,
                "{primitive:?} over {length} from ({x}, {y}): {foot:?}, but a sample is {nearest} away"
            );
        };
        for _ in 0..25 {
            let at = curve.evaluate(random.range(0.0, length));
            let t = random.range(-6.0, 6.0);
            check(at.x - t * at.sin, at.y + t * at.cos);
        }
        for _ in 0..6 {
            // Centres of curvature: the worst place to be.
            let at = curve.evaluate(random.range(0.0, length));
            let radius = clamp(1.0 / at.curvature, -1e3, 1e3);
            check(at.x - radius * at.sin, at.y + radius * at.cos);
        }
    }
}

#[test]
fn projection_onto_a_cubic_loop_is_nearest() {
    let primitive = Primitive::ParamPoly3 {
        u: [0.0, 70.0, -160.0, 320.0 / 3.0],
        v: [0.0, -40.0, 40.0, 0.0],
        range: ParameterRange::Normalized,
    };
    let sample = Sample::new(primitive, 40.0, Start::new(5.0, 6.0, -1.0));
    let curve = sample.curve();
    let mut random = Random(24);
    for _ in 0..300 {
        let at = curve.evaluate(random.range(0.0, 40.0));
        let (x, y) = (at.x + random.range(-8.0, 8.0), at.y + random.range(-8.0, 8.0));
        let foot = curve.project(x, y);
        check_foot(&curve, &foot, x, y, 0.0, 40.0);
        let nearest = sampled(&curve, x, y, 0.0, 40.0, 3000);
        assert!(
            foot.distance_squared.sqrt() <= nearest + FARTHER,
            "({x}, {y}): {foot:?}, {nearest}"
        );
    }
}

/// Lines and arcs are closed forms, so that a restricted range also gives its nearest point, from any seed.
#[test]
fn projection_onto_a_part_of_a_line_or_arc_is_nearest() {
    let mut random = Random(25);
    for _ in 0..1500 {
        let length = random.magnitude(1.0, 200.0);
        let curvature = random.range(-0.2, 0.2) * random.magnitude(1e-6, 1.0);
        let primitive = random.pick(&[Primitive::Line, Primitive::Arc { curvature }]);
        let sample = Sample::new(primitive, length, random.start());
        let curve = sample.curve();
        let (a, b) = (random.range(0.0, length), random.range(0.0, length));
        let (lo, hi) = (a.min(b), a.max(b));
        let near = curve.evaluate(random.range(0.0, length));
        let (x, y) = (near.x + random.range(-30.0, 30.0), near.y + random.range(-30.0, 30.0));
        let foot = curve.project_from(x, y, random.range(0.0, length), lo, hi);
        check_foot(&curve, &foot, x, y, lo, hi);
        let nearest = sampled(&curve, x, y, lo, hi, 400);
        assert!(
            foot.distance_squared.sqrt() <= nearest + FARTHER,
            "{primitive:?}, u in [{lo}, {hi}], from ({x}, {y}): {foot:?}, but a sample is {nearest} away"
        );
    }
}

/// A local search ends at a foot or at an end of its range, wherever the point and the seed are.
#[test]
fn projection_from_a_bad_seed_ends_at_a_foot_or_an_end() {
    let mut random = Random(26);
    for _ in 0..3000 {
        let sample = curve_of(&mut random, 6.0);
        let curve = sample.curve();
        let (a, b) = (random.range(0.0, sample.length), random.range(0.0, sample.length));
        let (lo, hi) = (a.min(b), a.max(b));
        let near = curve.evaluate(random.range(lo, hi));
        let (x, y) = (near.x + random.range(-40.0, 40.0), near.y + random.range(-40.0, 40.0));
        let seed = random.range(lo, hi);
        let foot = curve.project_from(x, y, seed, lo, hi);
        check_foot(&curve, &foot, x, y, lo, hi);
    }
}

/// What is told beside a range, for less, is what the projection says, to the bit; nothing is told of what lies ahead or behind.
#[test]
fn beside_a_range_the_projection_is_the_same() {
    let mut random = Random(28);
    let (mut told, mut in_closed_form) = (0, 0);
    for _ in 0..6000 {
        let (sample, full_turns) = (curve_of(&mut random, 6.0), random.range(0.0, 1.0) < 0.2);
        let curve = sample.curve();
        let (a, b) = (random.range(0.0, sample.length), random.range(0.0, sample.length));
        let (lo, hi) = if full_turns { (0.0, sample.length) } else { (a.min(b), a.max(b)) };
        let near = curve.evaluate(random.range(0.0, sample.length));
        let (x, y) = (near.x + random.range(-20.0, 20.0), near.y + random.range(-20.0, 20.0));
        let seed = 0.5 * (lo + hi);
        let foot = curve.project_from(x, y, seed, lo, hi);
        let expected = (!foot.clamped).then_some([foot.u, foot.lateral].map(f64::to_bits));
        let beside = curve.beside(x, y, seed, lo, hi).map(|found| found.map(f64::to_bits));
        assert_eq!(beside, expected, "{:?} in [{lo}, {hi}], from ({x}, {y})", sample.primitive);
        told += usize::from(beside.is_some());
        let closed = curve.closed_foot(x, y, lo, hi).map(|found| found.map(f64::to_bits));
        assert!(closed.is_none() || closed == expected, "{:?}", sample.primitive);
        in_closed_form += usize::from(closed.is_some());
    }
    assert!(told > 1000 && in_closed_form > 500, "{told}, {in_closed_form}");
}

#[test]
fn points_beyond_an_end_are_clamped() {
    let mut random = Random(27);
    for _ in 0..1000 {
        let sample = curve_of(&mut random, 1.0);
        let (curve, length) = (sample.curve(), sample.length);
        for (u, sign) in [(0.0, -1.0), (length, 1.0)] {
            let end = curve.evaluate(u);
            let beyond = random.range(1e-3, 2.0) * sign;
            let (x, y) = (end.x + beyond * end.cos, end.y + beyond * end.sin);
            let foot = curve.project_from(x, y, u, 0.0, length);
            check_foot(&curve, &foot, x, y, 0.0, length);
            assert!(foot.clamped && foot.u == u, "{:?} over {length}: {foot:?}", sample.primitive);
            // Exactly beside the end, the foot is perpendicular; on the outer side, where nothing else is nearer.
            let t = -end.curvature.signum();
            let beside =
                curve.project_from(end.x - t * end.sin, end.y + t * end.cos, u, 0.0, length);
            assert!(
                !beside.clamped && (beside.u - u).abs() < 1e-6,
                "{:?}: {beside:?}",
                sample.primitive
            );
        }
    }
}

/// The search over the whole curve ended just short of the end, where nothing was clamped: the foot of a point beyond counted as perpendicular.
#[test]
fn points_beyond_an_end_of_a_cubic_are_clamped_by_the_search() {
    let primitive = Primitive::ParamPoly3 {
        u: [0.0, 6.81489426, -3.33844786, 0.0],
        v: [0.0, 0.0, 3.07268177, 0.0],
        range: ParameterRange::Normalized,
    };
    let length = 5.2897899;
    let sample = Sample::new(primitive, length, Start::new(495.2, 385.8, 0.21325653));
    let (curve, mut random) = (sample.curve(), Random(28));
    for _ in 0..1000 {
        for (u, sign) in [(0.0, -1.0), (length, 1.0)] {
            let end = curve.evaluate(u);
            let (beyond, t) = (random.range(1e-3, 5.0) * sign, random.range(-3.0, 3.0));
            let x = end.x + beyond * end.cos - t * end.sin;
            let y = end.y + beyond * end.sin + t * end.cos;
            let foot = curve.project(x, y);
            check_foot(&curve, &foot, x, y, 0.0, length);
            let nearest = sampled(&curve, x, y, 0.0, length, 300);
            assert!(foot.distance_squared.sqrt() <= nearest + FARTHER, "({x}, {y}): {foot:?}");
        }
    }
}
