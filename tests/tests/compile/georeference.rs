//! Georeferences, header offsets and stated bounds of maps: what the archive stores and what is found.

use glam::DVec3;
use mapd_archive::GeoReferenceForm;
use mapd_client::geodesy::GeodeticPoint;
use mapd_client::{NearestOptions, Snapshot};
use mapd_compiler::{Compilation, CompileOptions, OffsetSign, compile};

/// A straight road of 500 m to the east from (x, y) with a lane to each side, under a header.
fn document(header: &str, x: f64, y: f64) -> String {
    format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="7" {header}</header>
<road id="1" length="500" junction="-1"><planView><geometry s="0" x="{x}" y="{y}" hdg="0" length="500"><line/></geometry></planView>
<lanes><laneSection s="0"><left><lane id="1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></left><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road></OpenDRIVE>"#
    )
}

fn compiled(header: &str, (x, y): (f64, f64), sign: OffsetSign) -> (Compilation, Snapshot) {
    let options = CompileOptions { offset_sign: sign, ..CompileOptions::default() };
    let text = document(header, x, y);
    let compiled = compile(text.as_bytes(), &options, &mut |_| {}).expect("reading works");
    let bytes =
        mapd_archive::encode(compiled.rows.as_ref().expect("accepted"), &compiled.provenance);
    let bytes = bytes.expect("encodes");
    mapd_archive::verify(&bytes).expect("sound");
    (compiled, Snapshot::from_bytes(bytes).expect("opens"))
}

/// Rules of the findings about the map's place on Earth.
fn rules(compiled: &Compilation) -> Vec<&str> {
    const OURS: [&str; 4] = ["geo_reference", "offset_sign", "offset_order", "stated_bounds"];
    let rules = compiled.diagnostics.iter().map(|told| told.finding.rule);
    rules
        .filter_map(|rule| rule.strip_prefix("mapd:compile."))
        .filter(|rule| OURS.contains(rule))
        .collect()
}

fn check(header: &str, at: (f64, f64), form: GeoReferenceForm, expected: &[&str]) {
    let (compilation, snapshot) = compiled(header, at, OffsetSign::Auto);
    assert_eq!(snapshot.map().geo_reference_form(), form, "{header}");
    assert_eq!(rules(&compilation), expected, "{header}");
}

#[test]
fn what_is_doubtful_is_found() {
    use GeoReferenceForm::{Absent, Epsg, Other, Parameters, Proj, Wkt1};
    let utm = "<geoReference><![CDATA[+proj=utm +zone=32 +datum=WGS84]]></geoReference>";
    check(">", (0.0, 0.0), Absent, &[]);
    check("><geoReference/>", (0.0, 0.0), Absent, &[]);
    check(&format!(">{utm}"), (5e5, 5e6), Proj, &[]);
    check(
        "><geoReference>+proj=utm +zone=32<userData code=\"a\" value=\"b\"/></geoReference>",
        (5e5, 5e6),
        Proj,
        &[],
    );
    check("><geoReference>epsg:25832</geoReference>", (5e5, 5e6), Epsg, &[]);
    // Its shift to WGS 84 has three numbers.
    check("><geoReference>EPSG:5514</geoReference>", (-7e5, -1e6), Epsg, &["geo_reference"]);
    check(
        "><geoReference>+lat_0=49 +lon_0=8</geoReference>",
        (0.0, 0.0),
        Parameters,
        &["geo_reference"],
    );
    check("><geoReference>somewhere</geoReference>", (0.0, 0.0), Other, &["geo_reference"]);
    check("><geoReference>PROJCS[\"a\"]</geoReference>", (0.0, 0.0), Wkt1, &["geo_reference"]);
    check(
        "><geoReference>+proj=utm +zone=32 +ellps=bessel</geoReference>",
        (5e5, 5e6),
        Proj,
        &["geo_reference"],
    );
    // Bounds: as stated, a little beyond, far beyond, not stated.
    check(r#"south="0" north="0" west="0" east="500">"#, (0.0, 0.0), Absent, &[]);
    check(r#"south="0" north="0" west="0" east="460">"#, (0.0, 0.0), Absent, &[]);
    check(r#"south="0" north="0" west="0" east="400">"#, (0.0, 0.0), Absent, &["stated_bounds"]);
    check(r#"south="0" north="0" west="0" east="0">"#, (0.0, 0.0), Absent, &[]);
    // Offsets: as the standard has it, of the other sign, turned.
    let offset =
        |x: f64, y: f64, hdg: f64| format!(r#"<offset x="{x}" y="{y}" z="0" hdg="{hdg}"/>"#);
    check(&format!(">{utm}{}", offset(4e5, 5e6, 0.0)), (0.0, 0.0), Proj, &[]);
    check(&format!(">{utm}{}", offset(-4e5, -5e6, 0.0)), (0.0, 0.0), Proj, &["offset_sign"]);
    check(
        &format!(r#"vendor="Eclipse SUMO">{}"#, offset(4.0, 5.0, 0.0)),
        (0.0, 0.0),
        Absent,
        &["offset_sign"],
    );
    check(&format!(">{utm}{}", offset(4e5, 5e6, 0.5)), (0.0, 0.0), Proj, &["offset_order"]);
}

#[test]
fn the_sign_of_the_offset_can_be_said() {
    let header = "><geoReference>+proj=utm +zone=33 +datum=WGS84</geoReference><offset x=\"-399345\" y=\"-5809365\" z=\"0\" hdg=\"0\"/>";
    for (sign, shift, negated) in [
        (OffsetSign::Auto, 399_345.0, true),
        (OffsetSign::Negated, 399_345.0, true),
        (OffsetSign::Standard, -399_345.0, false),
    ] {
        let (compilation, snapshot) = compiled(header, (0.0, 0.0), sign);
        let map = snapshot.map();
        assert_eq!((map.header_offset().shift.x, map.offset_is_negated()), (shift, negated));
        assert_eq!(rules(&compilation).contains(&"offset_sign"), sign == OffsetSign::Auto);
        if negated {
            let place =
                map.projector().expect("a projector").to_geodetic(DVec3::ZERO).expect("a place");
            assert!(
                (place.latitude - 52.425).abs() < 0.01 && (place.longitude - 13.52).abs() < 0.01,
                "{place:?}"
            );
        }
    }
}

/// A road across 12° E, where UTM's zones 32 and 33 meet: its places are continuous, and its lanes are found by them.
#[test]
fn nothing_happens_where_zones_meet() {
    // 12° E lies 200 to 250 km east of the central meridian of zone 32 at this latitude.
    let header = "><geoReference>+proj=utm +zone=32 +datum=WGS84</geoReference>";
    let bare = compiled(header, (7e5, 5.3e6), OffsetSign::Auto).1;
    let at = mapd_client::geodesy::Geodetic { latitude: 48.0, longitude: 12.0, altitude: 0.0 };
    let border = bare.map().projector().expect("a projector").from_geodetic(at).expect("a point");
    let (_, snapshot) = compiled(header, (border.x - 250.0, border.y), OffsetSign::Auto);
    let map = snapshot.map();
    let projector = map.projector().expect("a projector");
    let road = map.road_by_id("1").expect("a road");
    let (mut before, mut zones) = (None::<DVec3>, [false; 2]);
    for s in 0..=500 {
        let track = mapd_client::Track { s: f64::from(s), t: -1.75, h: 0.0 };
        let point = road.to_inertial(track).expect("a pose").position;
        let place = projector.to_geodetic(point).expect("a place");
        zones[usize::from(place.longitude >= 12.0)] = true;
        let again = projector.from_geodetic(place).expect("a point");
        assert!(again.distance(point) <= 1e-6);
        if let Some(before) = before {
            assert!((again.distance(before) - 1.0).abs() <= 1e-6);
        }
        before = Some(again);
        let (lat, lon) = (place.latitude, place.longitude);
        let options = NearestOptions::default();
        let hit = map
            .nearest_lane_geodetic(
                &projector,
                GeodeticPoint { latitude: lat, longitude: lon, altitude: None },
                &options,
            )
            .expect("an answer");
        let hit = hit.expect("a lane");
        assert_eq!(map.lane(hit.lane).expect("known").number(), -1);
        assert!((hit.position.s - f64::from(s)).abs() <= 1e-6 && hit.position.offset.abs() <= 1e-6);
    }
    assert_eq!(zones, [true, true], "the road crosses");
}
