//! Maps compiled into another frame: places, widths, heights, landmarks, and what cannot be transformed.

use glam::DVec3;
use mapd_client::{Map, Snapshot, Track};
use mapd_compiler::{Compilation, CompileOptions, Target, Verdict, compile};
use mapd_geodesy::Geodetic;
use mapd_tests::{corpus, say};

/// Coordinates of millions of metres, on their way through degrees and back `[m]`.
const ROUNDING: f64 = 2e-8;
/// Largest gap between neighbours on a road `[m]`.
const GAP: f64 = 1e-6;

/// Two roads, one after the other, of all kinds of curves, from (x, y): 800 m to the east in all, with hills, superelevation
/// and a lane to each side. The second has no heights of its own.
fn roads(x: f64, y: f64) -> String {
    let lanes = r#"<lanes><laneSection s="0"><left><lane id="1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes>"#;
    let curves = [
        (200.0, "<line/>"),
        (60.0, r#"<spiral curvStart="0" curvEnd="0.01"/>"#),
        (80.0, r#"<arc curvature="0.01"/>"#),
        (120.0, r#"<spiral curvStart="0.01" curvEnd="-0.01"/>"#),
        (40.0, r#"<arc curvature="-0.01"/>"#),
    ];
    let mut text = String::new();
    let (mut s, mut at) = (0.0, mapd_geometry::Start::new(x, y, 0.1));
    for (length, shape) in curves {
        text += &format!(
            r#"<geometry s="{s}" x="{}" y="{}" hdg="{}" length="{length}">{shape}</geometry>"#,
            at.x, at.y, at.heading
        );
        at = end(at, length, shape);
        s += length;
    }
    let (u, v) = ((60.0, 0.0), (6e-3, -4e-5));
    let second = format!(
        r#"<geometry s="0" x="{}" y="{}" hdg="{}" length="60.2"><paramPoly3 aU="0" bU="{}" cU="{}" dU="0" aV="0" bV="0" cV="{}" dV="{}" pRange="normalized"/></geometry>"#,
        at.x, at.y, at.heading, u.0, u.1, v.0 * 300.0, v.1 * 900.0
    );
    format!(
        r#"<road id="1" length="{s}" junction="-1"><link><successor elementType="road" elementId="2" contactPoint="start"/></link><planView>{text}</planView>
<elevationProfile><elevation s="100" a="2" b="0.01" c="0" d="0"/></elevationProfile><lateralProfile><superelevation s="0" a="0.02" b="0" c="0" d="0"/></lateralProfile>{lanes}</road>
<road id="2" length="60.2" junction="-1"><link><predecessor elementType="road" elementId="1" contactPoint="end"/></link><planView>{second}</planView>{lanes}</road>"#
    )
}

/// Where a curve ends.
fn end(start: mapd_geometry::Start, length: f64, shape: &str) -> mapd_geometry::Start {
    let number = |name: &str| -> f64 {
        let at = shape.find(name).expect(name) + name.len() + 2;
        shape[at..].split('"').next().expect("a number").parse().expect("a number")
    };
    use mapd_geometry::Primitive::{Arc, Line, Spiral};
    let primitive = match shape.as_bytes()[1] {
        b'l' => Line,
        b'a' => Arc { curvature: number("curvature") },
        _ => Spiral { curvature_start: number("curvStart"), curvature_end: number("curvEnd") },
    };
    let compiled = mapd_geometry::compile(&primitive, length).expect("compiles");
    let curve = mapd_geometry::Curve::new(compiled.kind, start, length, &compiled.coefficients);
    let at = curve.expect("fits").evaluate(length);
    mapd_geometry::Start::new(at.x, at.y, at.heading)
}

fn document(header: &str, x: f64, y: f64, more: &str) -> String {
    format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="8" {header}</header>{}{more}</OpenDRIVE>"#,
        roads(x, y)
    )
}

fn geo(text: &str) -> String {
    format!("><geoReference><![CDATA[{text}]]></geoReference>")
}

fn options(crs: Option<&str>) -> CompileOptions {
    let crs = crs.map(|text| text.parse::<Target>().unwrap_or_else(|e| panic!("{text}: {e}")));
    CompileOptions { crs, ..CompileOptions::default() }
}

fn compiled(text: &str, crs: Option<&str>) -> (Compilation, Option<Snapshot>) {
    let compiled = compile(text.as_bytes(), &options(crs), &mut |_| {}).expect("reading works");
    let snapshot = compiled.rows.as_ref().map(|rows| {
        let bytes = mapd_archive::encode(rows, &compiled.provenance).expect("encodes");
        mapd_archive::verify(&bytes).expect("sound");
        Snapshot::from_bytes(bytes).expect("opens")
    });
    (compiled, snapshot)
}

/// Rules of the findings about the frame, with their messages.
fn findings(compiled: &Compilation) -> Vec<&str> {
    let ours = compiled.diagnostics.iter().map(|told| &told.finding);
    ours.filter(|f| f.rule == "mapd:compile.target_frame").map(|f| f.message.as_str()).collect()
}

/// Largest distance in plan view and height of a map from the exact images of another's points, as seen from the bounds that
/// it states; panics where it is farther off.
fn compare(name: &str, file: Map<'_>, map: Map<'_>) -> [f64; 2] {
    let frame = map.file_frame().expect("a transformed map");
    assert_eq!(frame.projection(), file.projection());
    assert_eq!(frame.offset(), file.header_offset());
    let from = map.file_projector().expect("a projector");
    let to = map.projector().expect("a projector");
    let (low, high) = frame.scale();
    let off_scale = (low - 1.0).abs().max((high - 1.0).abs());
    let mut worst = [0.0_f64; 2];
    for (road, other) in file.roads().zip(map.roads()) {
        assert_eq!((road.id(), road.length()), (other.id(), other.length()), "{name}");
        for i in 0..=40 {
            let s = road.length() * f64::from(i) / 40.0;
            for t in [0.0, 5.0, -3.5] {
                let track = Track { s, t, h: 0.0 };
                let written = road.to_inertial(track).expect("a pose");
                let found = other.to_inertial(track).expect("a pose");
                let place = from.to_geodetic(written.position).expect("a place");
                let exact = to.from_geodetic(place).expect("a point");
                let off = exact.truncate().distance(found.position.truncate());
                let allowed = frame.error() + t.abs() * off_scale + ROUNDING;
                assert!(off <= allowed, "{name}, road {} at {s}, {t}: {off:e} > {allowed:e}", road.id());
                let up = (exact.z - found.position.z).abs();
                assert!(up <= frame.height_error() + ROUNDING, "{name}: {up:e} m in height");
                worst = [worst[0].max(off), worst[1].max(up)];
                if s < road.reference_end() {
                    // s and t are the same from the other side.
                    let track = other.to_track(found.position.truncate()).expect("a foot");
                    let again = other.to_inertial(Track { s: track.s, t: track.t, h: 0.0 });
                    let again = again.expect("a pose").position.truncate();
                    assert!(again.distance(found.position.truncate()) <= 1e-6, "{name}");
                }
            }
        }
    }
    let ((low, high), (own_low, own_high)) = (frame.bounds(), file.bounds());
    // Polylines are not the same on both sides.
    let slack = 2.0 * file.tables().map[0].bound_tolerance() + 10.0 * off_scale + frame.error();
    let off = (low - own_low).abs().max((high - own_high).abs()).max_element();
    assert!(off <= slack, "{name}: {low} to {high}, {own_low} to {own_high}");
    worst
}

/// Compiles a map as it is and into a frame and compares them.
fn check(header: &str, (x, y): (f64, f64), crs: &str) -> (Compilation, Snapshot) {
    let text = document(header, x, y, "");
    let (_, file) = compiled(&text, None);
    let (compilation, snapshot) = compiled(&text, Some(crs));
    let snapshot = snapshot.unwrap_or_else(|| panic!("{header} {crs}: {:?}", findings(&compilation)));
    let file = file.expect("accepted");
    assert!(file.map().file_frame().is_none());
    let worst = compare(crs, file.map(), snapshot.map());
    let frame = snapshot.map().file_frame().expect("a transformed map");
    assert_eq!(frame.target(), crs);
    say(&format!(
        "{header} to {crs}: {:.1e} m (stated {:.1e}), {:.1e} m in height, scale {:.7} to {:.7}",
        worst[0],
        frame.error(),
        worst[1],
        frame.scale().0,
        frame.scale().1
    ));
    (compilation, snapshot)
}

/// A point of a frame, so that maps can be put where they belong.
fn point(definition: &str, latitude: f64, longitude: f64) -> (f64, f64) {
    let projector = mapd_geodesy::Projector::new(definition, Default::default()).expect(definition);
    let at = projector.from_geodetic(Geodetic { latitude, longitude, altitude: 0.0 });
    let at = at.expect("a point");
    (at.x, at.y)
}

#[test]
fn a_road_across_a_zone_boundary_stays_in_one_piece() {
    // 12° E: zones 32 and 33 meet.
    let utm = "+proj=utm +zone=32 +datum=WGS84";
    let (x, y) = point(utm, 48.0, 12.0);
    for crs in ["utm", "epsg:32633", "epsg:25833", "enu:48.0,12.0", "+proj=tmerc +lat_0=48 +lon_0=12 +k=1"] {
        let (compilation, snapshot) = check(&geo(utm), (x - 300.0, y), crs);
        assert_eq!(findings(&compilation), Vec::<&str>::new(), "{crs}");
        let map = snapshot.map();
        let zone_33 = map.projection().contains("zone=33");
        assert_eq!(zone_33, crs.ends_with("33"), "{}", map.projection());
        let (low, high) = map.file_frame().expect("a transformed map").scale();
        let projector = map.projector().expect("a projector");
        let mut before: Option<DVec3> = None;
        let mut sides = [false; 2];
        for road in map.roads() {
            let steps = (road.length() * 1000.0) as u32;
            for i in 0..=steps {
                let s = road.length() * f64::from(i) / f64::from(steps);
                let here = road.to_inertial(Track { s, t: 0.0, h: 0.0 }).expect("a pose");
                let at = here.position.with_z(0.0);
                let ds = if i == 0 { 0.0 } else { road.length() / f64::from(steps) };
                if let Some(before) = before {
                    let step = before.distance(at);
                    assert!(step <= ds * high + GAP && step >= ds * low * 0.99 - GAP, "{crs} {s}: {step}");
                }
                before = Some(at);
            }
            for s in [0.0, road.length()] {
                let at = road.to_inertial(Track { s, t: 0.0, h: 0.0 }).expect("a pose").position;
                let place = projector.to_geodetic(at).expect("a place");
                sides[usize::from(place.longitude > 12.0)] = true;
            }
            // Joints of geometries.
            for s in road.shape_breaks() {
                let at = |s: f64| road.to_inertial(Track { s, t: 3.5, h: 0.0 }).expect("a pose");
                let (a, b) = (at(s.next_down()), at(s));
                assert!(a.position.truncate().distance(b.position.truncate()) <= GAP);
                assert!((a.heading - b.heading).abs() <= 1e-8, "{crs} at {s}");
            }
        }
        assert_eq!(sides, [true, true], "the road crosses");
        // Widths: as written along the road's own normal, hence off by no more than the scale.
        for lane in map.lanes() {
            let [inner, outer] = lane.edge_points_at(10.0).expect("edges");
            let width = inner.truncate().distance(outer.truncate());
            let ground = 3.5 * 0.02_f64.cos();
            let roll = if lane.road().id() == "1" { ground } else { 3.5 };
            assert!((width - roll).abs() <= 1e-8, "{width}");
        }
    }
}
