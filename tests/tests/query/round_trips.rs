//! Points to track coordinates and back: on random roads of every kind of curve, degenerate ones among them, and on real maps.

use mapd_archive::encode;
use mapd_client::{Road, Snapshot, Track, glam::DVec2};
use mapd_compiler::{CompileOptions, compile};
use mapd_geometry::{Curve, ParameterRange, Primitive, Start};
use mapd_query::Clamped;
use mapd_tests::maps::{Random, carried_and, open};
use std::fmt::Write;

/// Random roads in all.
const ROADS: usize = 10_000;
/// Roads of one map.
const BATCH: usize = 1_000;
/// Points of each road.
const POINTS: usize = 4;
/// What a re-evaluated point may be off \[m\], besides rounding of absolute coordinates.
const TOLERANCE: f64 = 1e-9;
/// Units in the last place of absolute coordinates that count as rounding.
const ROUNDING: f64 = 4.0;
/// Points are taken where 1 − κt is at least this: beyond, the foot is not unique.
const MIN_BEND: f64 = 0.2;
/// Origin of every second map \[m\]: coordinates as UTM has them.
const FAR: DVec2 = DVec2::new(691_000.0, 5_336_000.0);

/// A random shape and its length. One in eight is degenerate: no or hardly any curvature, very short, very long.
fn shape(random: &mut Random) -> (Primitive, f64) {
    let degenerate = random.unit() < 0.125;
    let length = match (degenerate, (random.unit() * 3.0) as usize) {
        (false, _) => random.between(1.0, 200.0),
        (true, 0) => 1e-4,
        (true, 1) => 0.05,
        _ => 5_000.0,
    };
    // At most about half a turn, so that a foot far round the curve is not nearer.
    let curvature = |random: &mut Random| random.between(-3.0, 3.0) / length.max(10.0);
    let primitive = match (random.unit() * 5.0) as usize {
        0 => Primitive::Line,
        1 => Primitive::Arc { curvature: if degenerate { 0.0 } else { curvature(random) } },
        2 => {
            let start = curvature(random);
            let end = if degenerate { start + 1e-15 } else { curvature(random) };
            Primitive::Spiral { curvature_start: start, curvature_end: end }
        }
        3 => {
            let (c, d) = (curvature(random) / 8.0, curvature(random) / (12.0 * length));
            Primitive::Poly3 { v: [0.0, 0.0, c, d] }
        }
        _ => {
            let (c, d) = (
                curvature(random) * length.powi(2) / 8.0,
                curvature(random) * length.powi(2) / 12.0,
            );
            Primitive::ParamPoly3 {
                u: [0.0, length, 0.0, 0.0],
                v: [0.0, 0.0, c, d],
                range: ParameterRange::Normalized,
            }
        }
    };
    (primitive, length)
}

/// OpenDRIVE's element of a shape.
fn element(primitive: &Primitive) -> String {
    match *primitive {
        Primitive::Line => "<line/>".to_owned(),
        Primitive::Arc { curvature } => format!("<arc curvature=\"{curvature:e}\"/>"),
        Primitive::Spiral { curvature_start, curvature_end } => {
            format!("<spiral curvStart=\"{curvature_start:e}\" curvEnd=\"{curvature_end:e}\"/>")
        }
        Primitive::Poly3 { v: [a, b, c, d] } => {
            format!("<poly3 a=\"{a:e}\" b=\"{b:e}\" c=\"{c:e}\" d=\"{d:e}\"/>")
        }
        Primitive::ParamPoly3 { u, v, .. } => format!(
            "<paramPoly3 aU=\"{:e}\" bU=\"{:e}\" cU=\"{:e}\" dU=\"{:e}\" aV=\"{:e}\" bV=\"{:e}\" cV=\"{:e}\" dV=\"{:e}\" pRange=\"normalized\"/>",
            u[0], u[1], u[2], u[3], v[0], v[1], v[2], v[3]
        ),
    }
}

/// A road of one to three geometries, each beginning where the one before ends.
fn road(id: usize, origin: DVec2, random: &mut Random) -> String {
    let (mut at, mut heading) = (
        origin + DVec2::new(random.between(-500.0, 500.0), random.between(-500.0, 500.0)),
        random.between(-4.0, 4.0),
    );
    let (mut s, mut geometries) = (0.0, String::new());
    for _ in 0..1 + (random.unit() * 3.0) as usize {
        let (primitive, length) = shape(random);
        let _ = write!(
            geometries,
            "<geometry s=\"{s:e}\" x=\"{:e}\" y=\"{:e}\" hdg=\"{heading:e}\" length=\"{length:e}\">{}</geometry>",
            at.x,
            at.y,
            element(&primitive)
        );
        let compiled = mapd_geometry::compile(&primitive, length).expect("an honest curve");
        let start = Start::new(at.x, at.y, heading);
        let curve = Curve::new(compiled.kind, start, length, &compiled.coefficients);
        let end = curve.expect("fits").evaluate(length);
        (at, heading, s) = (DVec2::new(end.x, end.y), end.heading, s + length);
    }
    let superelevation = random.between(-0.1, 0.1);
    format!(
        "<road id=\"{id}\" length=\"{s:e}\" junction=\"-1\"><planView>{geometries}</planView>\
         <elevationProfile><elevation s=\"0\" a=\"{:e}\" b=\"{:e}\" c=\"0\" d=\"0\"/></elevationProfile>\
         <lateralProfile><superelevation s=\"0\" a=\"{superelevation:e}\" b=\"0\" c=\"0\" d=\"0\"/></lateralProfile>\
         <lanes><laneSection s=\"0\"><center><lane id=\"0\" type=\"none\"/></center><right><lane id=\"-1\" type=\"driving\">\
         <width sOffset=\"0\" a=\"3\" b=\"0\" c=\"0\" d=\"0\"/></lane></right></laneSection></lanes></road>",
        random.between(-50.0, 900.0),
        random.between(-0.05, 0.05),
    )
}

/// Goes from a place to a point, to a place, and to a point again. Returns whether the place allowed it.
fn check(road: &Road<'_>, s: f64, t: f64, h: f64) -> bool {
    let pose = road.to_inertial(Track { s, t, h }).expect("a pose");
    let lateral = t * pose.superelevation.cos() - h * pose.superelevation.sin();
    if (1.0 - pose.curvature * lateral).abs() < MIN_BEND {
        return false;
    }
    let found = road.to_track(pose.position).expect("a foot");
    let h = found.h.expect("the point has a height");
    let ulp = pose.position.abs().max_element() * f64::EPSILON;
    // Nothing is nearer than the foot that was found.
    assert!(found.distance <= lateral.abs() + TOLERANCE + ROUNDING * ulp, "{found:?} for t = {t}");
    // An end, or a bend that is not smooth, may be nearer than the place we came from; no normal leads from there.
    if !found.exact {
        let kink = road.to_inertial(Track { s: found.s, ..Track::default() }).expect("a pose");
        let foot = kink.position.truncate();
        let sideways =
            (pose.position.truncate() - foot).dot(DVec2::from_angle(kink.heading).perp());
        let beyond = found.clamped.is_clamped() || found.distance - sideways.abs() > 0.0;
        assert!(beyond, "a perpendicular foot is exact: {found:?}");
        return false;
    }
    assert!(!found.clamped.is_clamped(), "{found:?}");
    let again = road.to_inertial(Track { s: found.s, t: found.t, h }).expect("a pose");
    let off = again.position.distance(pose.position);
    assert!(
        off <= TOLERANCE + ROUNDING * ulp,
        "road {}, s = {s}, t = {t}: {found:?} is {off:e} m off",
        road.id()
    );
    true
}

#[test]
fn random_roads() {
    let mut random = Random(20);
    let mut checked = 0;
    for batch in 0..ROADS / BATCH {
        let origin = if batch % 2 == 0 { DVec2::ZERO } else { FAR };
        let roads: String = (0..BATCH).map(|id| road(id, origin, &mut random)).collect();
        let text = format!("<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>{roads}</OpenDRIVE>");
        let options = CompileOptions::default();
        let compiled = compile(text.as_bytes(), &options, &mut |_| {}).expect("reading works");
        let rows = compiled.rows.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        let bytes = encode(&rows, &compiled.provenance).expect("encodes");
        let snapshot = Snapshot::from_bytes(bytes).expect("opens");
        for road in snapshot.map().roads() {
            for point in 0..POINTS {
                // Both ends, and places between.
                let share = [0.0, 1.0, random.unit(), random.unit()][point];
                let (s, t) = (share * road.reference_end(), random.between(-12.0, 12.0));
                checked += usize::from(check(&road, s, t, random.between(-2.0, 2.0)));
            }
        }
    }
    assert!(checked > ROADS * POINTS / 2, "only {checked} points could be checked");
}

#[test]
fn real_roads() {
    for path in carried_and(&["carla/Town05", "esmini/velodrome", "esmini/soderleden"]) {
        let snapshot = open(&path);
        let mut random = Random(21);
        let mut checked = 0;
        for road in snapshot.map().roads() {
            for _ in 0..20 {
                let (s, t) = (random.unit() * road.reference_end(), random.between(-8.0, 8.0));
                checked += usize::from(check(&road, s, t, random.between(-1.0, 1.0)));
            }
        }
        assert!(checked > 0, "{}", path.display());
    }
}

/// A kinked line: 100 m east, then, turned to the left by half a radian, 100 m more.
const KINKED: &str = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/><road id=\"1\" length=\"200\" junction=\"-1\"><planView>\
    <geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"100\"><line/></geometry>\
    <geometry s=\"100\" x=\"100\" y=\"0\" hdg=\"0.5\" length=\"100\"><line/></geometry></planView>\
    <lanes><laneSection s=\"0\"><center><lane id=\"0\"/></center><right><lane id=\"-1\" type=\"driving\">\
    <width sOffset=\"0\" a=\"3\" b=\"0\" c=\"0\" d=\"0\"/></lane></right></laneSection></lanes></road></OpenDRIVE>";

/// Feet at an end or a kink were told as if the point lay at s and t.
#[test]
fn a_foot_that_is_not_the_point_says_so() {
    let snapshot = mapd_tests::maps::open_text(KINKED);
    let road = snapshot.map().road_by_id("1").expect("there");
    let end = DVec2::new(100.0, 0.0) + 100.0 * DVec2::from_angle(0.5);
    for (point, clamped, exact) in [
        (DVec2::new(50.0, 3.0), Clamped::No, true),
        (DVec2::new(100.0, 0.0), Clamped::No, true),
        (DVec2::new(-0.0, 7.0), Clamped::No, true),
        (DVec2::new(-1.0, 3.0), Clamped::Before, false),
        (end + DVec2::new(1.0, 1.0), Clamped::After, false),
        // Outside the bend no normal leads to the point.
        (DVec2::new(100.2, -2.0), Clamped::No, false),
    ] {
        let found = road.to_track(point).expect("a foot");
        assert_eq!((found.clamped, found.exact), (clamped, exact), "{point}: {found:?}");
        let track = Track { s: found.s, t: found.t, h: 0.0 };
        let again = road.to_inertial(track).expect("a pose").position.truncate();
        assert_eq!(again.distance(point) < TOLERANCE, exact, "{point}: {found:?}");
    }
}

/// A road of one cubic, as SUMO writes a turn.
const TURN: &str = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/><road id=\"1\" length=\"5.2897899\" junction=\"-1\"><planView>\
    <geometry s=\"0\" x=\"495.20500478\" y=\"385.81548171\" hdg=\"0.21325653\" length=\"5.2897899\">\
    <paramPoly3 aU=\"0\" bU=\"6.81489426\" cU=\"-3.33844786\" dU=\"0\" aV=\"0\" bV=\"0\" cV=\"3.07268177\" dV=\"0\" pRange=\"normalized\"/></geometry></planView>\
    <lanes><laneSection s=\"0\"><center><lane id=\"0\"/></center><right><lane id=\"-1\" type=\"driving\">\
    <width sOffset=\"0\" a=\"3\" b=\"0\" c=\"0\" d=\"0\"/></lane></right></laneSection></lanes></road></OpenDRIVE>";

/// Points beyond the end of a cubic were said to lie exactly at its s and t, up to metres away.
#[test]
fn points_beyond_a_cubic_are_clamped() {
    let snapshot = mapd_tests::maps::open_text(TURN);
    let road = snapshot.map().road_by_id("1").expect("there");
    for (s, way, expected) in [(0.0, -1.0, Clamped::Before), (5.2897899, 1.0, Clamped::After)] {
        for step in 1..=200 {
            // Outside of the bend, where nothing is nearer than the end.
            let (beyond, t) = (0.01 * f64::from(step), -0.015 * f64::from(step));
            let pose = road.to_inertial(Track { s, t, h: 0.0 }).expect("a pose");
            let ahead = way * beyond * DVec2::from_angle(pose.heading);
            let found = road.to_track(pose.position.truncate() + ahead).expect("a foot");
            assert_eq!((found.clamped, found.exact), (expected, false), "{step}: {found:?}");
        }
    }
}
