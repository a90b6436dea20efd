//! Curves moved into another plane, against the exact images of their points.

use core::f64::consts::TAU;
use glam::DVec2;
use mapd_geometry::{
    Chart, Curve, CurveKind, CurveTransform, ParameterRange, Primitive, Start, TransformError,
    compile,
};

/// A conformal map of about the bend that projections have: w = c + a·z + b·z², as complex numbers, near the point it is
/// expanded about.
#[derive(Clone, Copy)]
struct Bent {
    center: DVec2,
    factor: DVec2,
    bend: DVec2,
    reach: f64,
}

fn times(a: DVec2, b: DVec2) -> DVec2 {
    a.rotate(b)
}

impl Bent {
    fn whole(&self, point: DVec2) -> DVec2 {
        times(self.factor, point) + times(self.bend, times(point, point))
    }

    /// dw/dz: its length is the scale, its direction the turn.
    fn slope(&self, point: DVec2) -> DVec2 {
        self.factor + times(self.bend, point) * 2.0
    }
}

impl Chart for Bent {
    fn center(&self) -> DVec2 {
        self.center
    }
    fn origin(&self) -> DVec2 {
        self.whole(self.center)
    }
    fn reach(&self) -> f64 {
        self.reach
    }
    fn image(&self, point: DVec2) -> DVec2 {
        times(self.slope(self.center), point) + times(self.bend, times(point, point))
    }
    fn slopes(&self, point: DVec2) -> [DVec2; 2] {
        let slope = self.slope(self.center + point);
        [slope, slope.perp()]
    }
}

const BENT: Bent = Bent {
    center: DVec2::ZERO,
    factor: DVec2::new(0.92, 0.3),
    bend: DVec2::new(3e-9, -8e-9),
    reach: 700.0,
};

/// Compares a transformed curve with its source: positions, headings, curvatures, feet.
fn check(primitive: Primitive, length: f64, start: Start) {
    let compiled = compile(&primitive, length).expect("compiles");
    let source = Curve::new(compiled.kind, start, length, &compiled.coefficients).expect("fits");
    // Charts about multiples of 1,024 m, as a compiler would cache them.
    let chart = |at: DVec2| Some(Bent { center: (at / 1024.0).round() * 1024.0, ..BENT });
    let moved = CurveTransform::default().apply(&source, chart).expect("moves");
    assert!(moved.error <= 2e-9, "{primitive:?}: {}", moved.error);
    let kind = CurveKind::Transformed;
    let curve = Curve::new(kind, moved.start, length, &moved.coefficients).expect("fits");
    let mut before = curve.heading(0.0);
    for i in 0..=200 {
        let u = length * f64::from(i) / 200.0;
        let (from, to) = (source.evaluate(u), curve.evaluate(u));
        let place = DVec2::new(from.x, from.y);
        let (image, slope) = (BENT.whole(place), BENT.slope(place));
        // Coordinates of a million metres have 1e-10 m.
        let missed = image.distance(DVec2::new(to.x, to.y));
        assert!(missed <= moved.error + 2e-9, "{primitive:?} at {u}: {missed:e}");
        let tangent = times(slope, DVec2::new(from.cos, from.sin)).normalize();
        let off = tangent.distance(DVec2::new(to.cos, to.sin));
        assert!(off <= 1e-9, "{primitive:?} at {u}: tangent {off:e}");
        assert!(
            (to.cos - to.heading.cos()).abs() <= 1e-9 && (to.sin - to.heading.sin()).abs() <= 1e-9
        );
        // The turn of the plane hardly changes along a curve; a lost circle would show.
        let turn = to.heading - from.heading;
        assert!((turn - BENT.factor.to_angle()).abs() < 0.1, "{primitive:?} at {u}: {turn}");
        assert!((to.heading - before).abs() <= TAU / 4.0);
        before = to.heading;
        // κ′ = (κ + Im(w″/w′·t)) / |w′|
        let bent = times(BENT.bend * 2.0, DVec2::new(from.cos, from.sin));
        let extra = slope.perp_dot(bent) / slope.length_squared();
        let curvature = (from.curvature + extra) / slope.length();
        let off = (curvature - to.curvature).abs();
        assert!(off <= 2e-8 * (1.0 + curvature.abs()), "{primitive:?} at {u}: curvature {off:e}");
        assert!((curve.curvature(u) - to.curvature).abs() <= 1e-15);
        if i % 20 == 10 {
            let t = 2.5_f64.min(0.4 / to.curvature.abs());
            let aside = DVec2::new(to.x - t * to.sin, to.y + t * to.cos);
            let foot = curve.project_from(aside.x, aside.y, u - 1.0, 0.0, length);
            assert!((foot.u - u).abs() <= 2e-8 && (foot.lateral - t).abs() <= 1e-8, "{foot:?}");
            let whole = curve.project(aside.x, aside.y);
            assert!(whole.distance_squared <= foot.distance_squared + 1e-7);
        }
    }
}

#[test]
fn curves_keep_their_parameter_in_another_plane() {
    let starts = [Start::new(0.0, 0.0, 0.4), Start::new(512_000.0, -731_000.5, -2.9)];
    let cubic = ParameterRange::ArcLength;
    for start in starts {
        check(Primitive::Line, 1e-9, start);
        check(Primitive::Line, 0.02, start);
        check(Primitive::Line, 1.0, start);
        check(Primitive::Arc { curvature: 1.0 }, 0.5, start);
        check(Primitive::Arc { curvature: 0.02 }, 1.5, start);
        check(Primitive::Line, 250.0, start);
        check(Primitive::Line, 40_000.0, start);
        check(Primitive::Arc { curvature: 0.01 }, 2000.0, start);
        check(Primitive::Arc { curvature: -0.2 }, 30.0, start);
        check(Primitive::Spiral { curvature_start: -0.02, curvature_end: 0.03 }, 300.0, start);
        let v = [0.0, 0.0, 1e-3, -1e-5];
        check(Primitive::ParamPoly3 { u: [0.0, 1.0, 0.0, 0.0], v, range: cubic }, 60.0, start);
        check(Primitive::Poly3 { v }, 60.0, start);
    }
}

#[test]
fn what_cannot_be_moved_says_so() {
    let start = Start::new(7.0, 8.0, 0.5);
    let line = Curve::new(CurveKind::Line, start, 3000.0, &[]).expect("a line");
    let transform = CurveTransform::default();
    let nowhere = transform.apply(&line, |_| None::<Bent>);
    assert_eq!(nowhere, Err(TransformError::Outside { x: 7.0, y: 8.0 }));
    let narrow = Bent { reach: 1.0, ..BENT };
    let narrow = transform.apply(&line, |center| Some(Bent { center, ..narrow }));
    assert_eq!(narrow, Err(TransformError::TooManyPieces));
    let hole = Bent { factor: DVec2::new(f64::NAN, 0.0), ..BENT };
    let hole = transform.apply(&line, |center| Some(Bent { center, ..hole }));
    assert_eq!(hole, Err(TransformError::TooManyPieces));
    // A place without extent keeps its direction.
    let point = Curve::new(CurveKind::Line, start, 0.0, &[]).expect("a point");
    let moved = transform.apply(&point, |center| Some(Bent { center, ..BENT })).expect("moves");
    let curve = Curve::new(CurveKind::Transformed, moved.start, 0.0, &moved.coefficients);
    let at = curve.expect("fits").evaluate(0.0);
    assert!(BENT.whole(DVec2::new(7.0, 8.0)).distance(DVec2::new(at.x, at.y)) <= 1e-12);
    assert!((at.cos - 0.5f64.cos()).abs() <= 1e-12 && at.curvature == 0.0);
}
