//! Maps compiled into another frame: places, widths, heights, landmarks, and what cannot be transformed.

use glam::DVec3;
use mapd_client::{Map, Snapshot, Track};
use mapd_compiler::{Compilation, CompileOptions, Target, Verdict, compile};
use mapd_geodesy::Geodetic;
use mapd_query::Bounds;
use mapd_query::document::HeaderOffset;
use mapd_tests::{corpus, say};

/// Coordinates of millions of metres, on their way through degrees and back `[m]`.
const ROUNDING: f64 = 2e-8;
/// Largest archive that is compared point by point `[bytes]`.
const LARGEST: usize = 8_000_000;
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
        at.x,
        at.y,
        at.heading,
        u.0,
        u.1,
        v.0 * 300.0,
        v.1 * 900.0
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
/// it states; panics where it is farther off. On a simple map each point has one foot.
fn compare(name: &str, (file, map): (Map<'_>, Map<'_>), is_simple: bool) -> [f64; 2] {
    let frame = map.file_frame().expect("a transformed map");
    assert_eq!(frame.projection(), file.projection());
    assert_eq!(frame.offset(), file.header_offset());
    let from = map.file_projector().expect("a projector");
    let to = map.projector().expect("a projector");
    let (low, high) = (frame.scale_min(), frame.scale_max());
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
                // The scale is that of the reference line; beside it, it changes by some 1e-8 per metre, and where datums
                // are shifted, what is higher by superelevation leans by some 1e-5.
                let beside = t.abs() * (off_scale + 1e-8 * t.abs() + 0.02 * 2e-5);
                let allowed = frame.error() + beside + ROUNDING;
                let is_beyond = t * written.curvature > 0.9;
                assert!(
                    is_beyond || off <= allowed,
                    "{name}, road {} at {s}, {t}: {off:e} > {allowed:e}",
                    road.id()
                );
                let up = (exact.z - found.position.z).abs();
                assert!(up <= frame.height_error() + ROUNDING, "{name}: {up:e} m in height");
                worst = [worst[0].max(off), worst[1].max(up)];
                if is_simple {
                    let track = other.to_track(found.position.truncate()).expect("a foot");
                    assert!((track.s - s).abs() <= GAP && (track.t - t).abs() <= GAP, "{track:?}");
                }
            }
        }
    }
    let Bounds { low, high } = frame.bounds();
    let Bounds { low: own_low, high: own_high } = file.bounds();
    // Polylines are not the same on both sides, and widths stay as written on either.
    let slack = 2.0 * file.tables().map[0].bound_tolerance() + 100.0 * off_scale + frame.error();
    let off = (low - own_low).abs().max((high - own_high).abs()).max_element();
    assert!(off <= slack, "{name}: {low} to {high}, {own_low} to {own_high}");
    worst
}

/// Compiles a map as it is and into a frame and compares them.
fn check(header: &str, (x, y): (f64, f64), crs: &str) -> (Compilation, Snapshot) {
    let text = document(header, x, y, "");
    let (_, file) = compiled(&text, None);
    let (compilation, snapshot) = compiled(&text, Some(crs));
    let snapshot =
        snapshot.unwrap_or_else(|| panic!("{header} {crs}: {:?}", findings(&compilation)));
    let file = file.expect("accepted");
    assert!(file.map().file_frame().is_none());
    let worst = compare(crs, (file.map(), snapshot.map()), true);
    let frame = snapshot.map().file_frame().expect("a transformed map");
    assert_eq!(frame.target(), crs);
    say(&format!(
        "{header} to {crs}: {:.1e} m (stated {:.1e}), {:.1e} m in height, scale {:.7} to {:.7}",
        worst[0],
        frame.error(),
        worst[1],
        frame.scale_min(),
        frame.scale_max()
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
    for crs in
        ["utm", "epsg:32633", "epsg:25833", "enu:48.0,12.0", "+proj=tmerc +lat_0=48 +lon_0=12 +k=1"]
    {
        let (compilation, snapshot) = check(&geo(utm), (x - 300.0, y), crs);
        assert_eq!(findings(&compilation), Vec::<&str>::new(), "{crs}");
        let map = snapshot.map();
        let zone_33 = map.projection().contains("zone=33");
        assert_eq!(zone_33, crs.ends_with("33"), "{}", map.projection());
        let frame = map.file_frame().expect("a transformed map");
        let (low, high) = (frame.scale_min(), frame.scale_max());
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
                    assert!(
                        step <= ds * high + GAP && step >= ds * low * 0.99 - GAP,
                        "{crs} {s}: {step}"
                    );
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

#[test]
fn frames_of_all_sorts_meet() {
    let south = "+proj=utm +zone=56 +south +datum=WGS84";
    let bessel = "+proj=tmerc +lat_0=0 +lon_0=9 +k=1 +x_0=3500000 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7 +units=m";
    let three = "+proj=utm +zone=32 +ellps=intl +towgs84=-87,-98,-121";
    let feet = "+proj=lcc +lat_1=41.7 +lat_2=40.4333333333333 +lat_0=39.6666666666667 +lon_0=-82.5 +x_0=600000 +datum=NAD83 +units=us-ft";
    let carla = "+lat_0=42.0 +lon_0=2.0";
    for (file, at, frames) in [
        // Southern hemisphere.
        (south, (-33.9, 151.2), &["utm", "epsg:28356", "enu:-33.9,151.2,35"][..]),
        // False eastings, shifts by three and seven parameters, either way.
        (
            bessel,
            (48.1, 9.3),
            &["utm", "epsg:25832", "enu:48.1,9.3,500", "+proj=merc +lat_ts=48 +datum=WGS84"],
        ),
        (three, (48.1, 9.3), &["utm", bessel, "epsg:31467"]),
        ("+proj=utm +zone=32 +datum=WGS84", (48.1, 9.3), &[bessel, "epsg:3857", "epsg:27700"]),
        // Feet: coordinates are metres all the same, on either side.
        (feet, (40.0, -82.9), &["utm", "epsg:32617", feet]),
        ("+proj=utm +zone=17 +datum=WGS84", (40.0, -82.9), &[feet, "epsg:2834"]),
        (carla, (42.01, 2.02), &["utm", "enu:42.0,2.0"]),
        // The antimeridian.
        ("+proj=utm +zone=60 +datum=WGS84", (10.0, 179.999), &["epsg:32601", "enu:10,-180"]),
    ] {
        let read = mapd_geodesy::Reference::read(file).expect("a reference");
        let (x, y) = point(&read.definition.expect("understood"), at.0, at.1);
        for crs in frames {
            let (_, snapshot) = check(&geo(file), (x, y), crs);
            let [south, north, west, east] = snapshot.map().geodetic_bounds().expect("bounds");
            let within = |angle: f64| (west..=east).contains(&angle);
            assert!(south <= at.0 && at.0 <= north && (within(at.1) || within(at.1 + 360.0)));
        }
    }
    // With an offset that turns and shifts, and height.
    let header = format!(
        r#"{}<offset x="500100" y="5320000" z="512.5" hdg="0.7"/>"#,
        geo("+proj=utm +zone=32 +datum=WGS84")
    );
    let (_, snapshot) = check(&header, (120.0, 40.0), "epsg:25832");
    let frame = snapshot.map().file_frame().expect("a transformed map");
    assert_eq!((frame.height_shift(), frame.height_error()), (512.5, 0.0));
    assert_eq!(snapshot.map().header_offset(), HeaderOffset::default());
    let (_, snapshot) = check(&header, (120.0, 40.0), "enu:48.0,9.0,500");
    let frame = snapshot.map().file_frame().expect("a transformed map");
    assert_eq!(frame.height_shift(), 12.5);
}

/// What is wrong, as parts of messages, in order.
fn check_findings(
    header: &str,
    (x, y): (f64, f64),
    crs: &str,
    verdict: Verdict,
    expected: &[&str],
) {
    let (compilation, snapshot) = compiled(&document(header, x, y, ""), Some(crs));
    let found = findings(&compilation);
    assert_eq!(compilation.verdict, verdict, "{header} to {crs}: {found:?}");
    assert_eq!(snapshot.is_some(), verdict == Verdict::Accepted);
    assert_eq!(found.len(), expected.len(), "{header} to {crs}: {found:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.contains(expected), "{header} to {crs}: {found}");
    }
}

#[test]
fn what_cannot_be_transformed_or_only_with_doubts_is_found() {
    use Verdict::{Accepted, Rejected};
    let utm = geo("+proj=utm +zone=32 +datum=WGS84");
    let at = (5e5, 5.3e6);
    check_findings(&utm, at, "utm", Accepted, &[]);
    // Nothing to transform from: absent, not understood, grids.
    check_findings(">", at, "utm", Rejected, &["no georeference"]);
    check_findings(&geo("somewhere"), at, "utm", Rejected, &["no georeference"]);
    check_findings(
        &geo("+proj=utm +zone=10 +datum=NAD27"),
        at,
        "utm",
        Rejected,
        &["no georeference"],
    );
    let grid = "+proj=utm +zone=32 +ellps=bessel +nadgrids=BETA2007.gsb";
    check_findings(&geo(grid), at, "utm", Rejected, &["no georeference"]);
    // Outside the one frame or the other.
    check_findings(&utm, (1e9, 5e6), "utm", Rejected, &["its own projection"]);
    check_findings(&utm, at, "enu:-48,-171", Rejected, &["outside that frame's area"]);
    // Unknown and mixed datums.
    let unknown = "+proj=utm +zone=32 +ellps=bessel";
    check_findings(&geo(unknown), at, "utm", Accepted, &["datum of the map is unknown"]);
    let both = ["neither datum nor towgs84", "datum of the target frame is unknown"];
    check_findings(&utm, at, unknown, Accepted, &both);
    let mixed = "+proj=utm +zone=32 +datum=WGS84 +ellps=bessel";
    check_findings(&utm, at, mixed, Accepted, &["mixes datums"]);
    // Heights above a geoid are not shifted; a scale far from 1 is told.
    check_findings(&utm, at, "epsg:25832+7837", Accepted, &["EPSG:7837"]);
    check_findings(&utm, at, "epsg:3857", Accepted, &["distances are 1.4"]);
    // The map's own doubts are told whether or not it is transformed.
    let (compilation, _) = compiled(&document(&geo(unknown), at.0, at.1, ""), Some("utm"));
    let rules: Vec<_> = compilation.diagnostics.iter().map(|d| d.finding.rule).collect();
    assert!(rules.contains(&"mapd:compile.geo_reference"), "{rules:?}");
}

#[test]
fn targets_are_understood_or_refused() {
    let here = Geodetic { latitude: 48.1, longitude: 11.5, altitude: 0.0 };
    for (text, definition) in [
        ("utm", "+proj=utm +zone=32 +datum=WGS84"),
        (" UTM ", "+proj=utm +zone=32 +datum=WGS84"),
        ("enu:48.1,11.5", "+proj=topocentric +lat_0=48.1 +lon_0=11.5 +h_0=0 +datum=WGS84"),
        (
            "ENU: -48.1 , 11.5 , 512.25",
            "+proj=topocentric +lat_0=-48.1 +lon_0=11.5 +h_0=512.25 +datum=WGS84",
        ),
        ("epsg:32633", "+proj=utm +zone=33 +datum=WGS84"),
        ("32633", "+proj=utm +zone=33 +datum=WGS84"),
        ("+proj=tmerc +lat_0=48 +lon_0=12", "+proj=tmerc +lat_0=48 +lon_0=12 +datum=WGS84"),
    ] {
        let target: Target = text.parse().unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!(target.definition(here), definition);
        assert!(mapd_geodesy::Projector::new(definition, Default::default()).is_ok());
    }
    let east = [(0.0, 31), (5.999, 31), (6.0, 32), (12.0, 33), (179.9, 60), (180.0, 1), (190.0, 2)];
    let west = [(-0.1, 30), (-177.0, 1), (-180.0, 1)];
    for (longitude, zone) in east.into_iter().chain(west) {
        for (latitude, south) in [(1.0, ""), (-1.0, " +south")] {
            let at = Geodetic { latitude, longitude, altitude: 0.0 };
            let expected = format!("+proj=utm +zone={zone}{south} +datum=WGS84");
            assert_eq!("utm".parse::<Target>().expect("utm").definition(at), expected);
        }
    }
    for text in [
        "",
        "  ",
        "enu",
        "enu:",
        "enu:48",
        "enu:91,0",
        "enu:0,181",
        "enu:a,b",
        "enu:1,2,3,4",
        "enu:nan,0",
        "enu:0,0,inf",
        "epsg:4326",
        "epsg:99999",
        "epsg:26710",
        "utm:32",
        "nowhere",
        "+proj=longlat",
        "+proj=utm +zone=61",
        "+proj=utm +zone=32 +nadgrids=a.gsb",
    ] {
        assert!(text.parse::<Target>().is_err(), "{text}");
    }
}

/// Places that are written in x and y: a signal's, a grid's, objects of a junction; and heights.
#[test]
fn landmarks_move_with_the_map() {
    let utm = "+proj=utm +zone=32 +datum=WGS84";
    let (x, y) = point(utm, 48.0, 12.0);
    let grid = format!(
        r#"<junction id="9" type="default"><planView><geometry s="0" x="{x}" y="{y}" hdg="0.1" length="100"><line/></geometry></planView><elevationGrid gridSpacing="10" sStart="0"><elevation center="5" left="5.5 6" right="4.5 4"/><elevation center="5.1" left="5.6 6.1" right="4.6 4.1"/></elevationGrid></junction>"#
    );
    let signal = format!(
        r#"<signals><signal id="7" s="20" t="4" dynamic="no" orientation="+" zOffset="2" type="206" subtype="-1" country="DE"><positionInertial x="{}" y="{}" z="3.5" hdg="0.25" pitch="0" roll="0"/></signal></signals></road>"#,
        x + 30.0,
        y + 8.0
    );
    let header = format!(r#"{}<offset x="0" y="0" z="100" hdg="0"/>"#, geo(utm));
    let text = document(&header, x, y, &grid).replacen("</road>", &signal, 1);
    let (_, file) = compiled(&text, None);
    let file = file.expect("accepted");
    let (compilation, snapshot) = compiled(&text, Some("epsg:32633"));
    let snapshot = snapshot.unwrap_or_else(|| panic!("{:?}", findings(&compilation)));
    let (file, map) = (file.map(), snapshot.map());
    let from = map.file_projector().expect("a projector");
    let to = map.projector().expect("a projector");
    let image = |point: DVec3| {
        to.from_geodetic(from.to_geodetic(point).expect("a place")).expect("a point")
    };
    let (a, b) = (file.signals().next().expect("one"), map.signals().next().expect("one"));
    assert!(image(a.position()).distance(b.position()) <= ROUNDING);
    // The face turns with the meridians: by about 4.5 degrees here.
    let ahead = |heading: f64| DVec3::new(heading.cos(), heading.sin(), 0.0);
    let expected = image(a.position() + ahead(a.facing())) - image(a.position());
    let turned = expected.y.atan2(expected.x);
    assert!((turned - b.facing()).abs() <= 1e-6 && (a.facing() - b.facing()).abs() > 0.05);
    let (a, b) = (&file.tables().elevation_grids[0], &map.tables().elevation_grids[0]);
    let corner = |origin: glam::DVec2, x: f64, y: f64| DVec3::new(origin.x + x, origin.y + y, 0.0);
    let (a, b) = (
        [
            corner(file.local_origin(), a.x(), a.y()),
            corner(file.local_origin(), a.x() + 10.0 * a.cos(), a.y() + 10.0 * a.sin()),
        ],
        [
            corner(map.local_origin(), b.x(), b.y()),
            corner(
                map.local_origin(),
                b.x() + b.spacing() * b.cos(),
                b.y() + b.spacing() * b.sin(),
            ),
        ],
    );
    for (a, b) in a.into_iter().zip(b) {
        assert!(image(a).truncate().distance(b.truncate()) <= 1e-6);
    }
    let heights = |map: Map<'_>| -> Vec<f64> {
        let rows = map.tables().grid_rows.iter().map(|row| row.center());
        rows.chain(map.tables().grid_heights.iter().copied()).collect()
    };
    for (a, b) in heights(file).into_iter().zip(heights(map)) {
        assert_eq!(a + 100.0, b);
    }
}

/// Every map of the corpus that lies somewhere on Earth.
#[test]
fn maps_of_the_corpus_move() {
    let Some(maps) = corpus() else { return say("skipped: ../shared is not there") };
    let mut moved = 0;
    for (name, path) in maps {
        let of = |crs: Option<&str>| {
            let compiled =
                mapd::source::compile_file(&path, &options(crs), &mut |_| {}).expect("reads");
            let rows = compiled.rows.as_ref()?;
            let bytes = mapd_archive::encode(rows, &compiled.provenance).expect("encodes");
            mapd_archive::verify(&bytes).expect("sound");
            Some(Snapshot::from_bytes(bytes).expect("opens"))
        };
        let Some(file) = of(None) else { continue };
        if file.map().geodetic_bounds().is_none() || file.bytes().len() > LARGEST {
            continue;
        }
        let snapshot = of(Some("utm")).unwrap_or_else(|| panic!("{name} is rejected"));
        let [worst, up] = compare(&name, (file.map(), snapshot.map()), false);
        let frame = snapshot.map().file_frame().expect("a transformed map");
        say(&format!(
            "{name}: {worst:.1e} m (stated {:.1e}), {up:.1e} m in height, scale {:?}",
            frame.error(),
            (frame.scale_min(), frame.scale_max())
        ));
        moved += 1;
    }
    assert!(moved > 15, "{moved} maps");
}
