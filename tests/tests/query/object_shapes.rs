//! Shapes of objects: each kind once, with corners worked out by hand.

use mapd_client::glam::{DVec2, DVec3};
use mapd_query::objects::Object;
use mapd_query::vocabulary::ObjectShape;
use mapd_tests::object_maps::{ObjectRoad, PLAIN, document, open};
use std::f64::consts::FRAC_PI_2;

/// Corners lie in single precision relative to the object, some metres from it `[m]`.
const SINGLE: f64 = 2e-6;

/// A road that runs north from (10, 20), rises by a tenth from a height of 5 m and leans to the right by 0.1 rad.
const TILTED: ObjectRoad<'_> = ObjectRoad {
    start: [10.0, 20.0, FRAC_PI_2],
    elevation: [5.0, 0.1],
    superelevation: 0.1,
    ..PLAIN
};

/// The first object's shape and footprint.
fn check(
    road: &ObjectRoad<'_>,
    object: &str,
    shape: ObjectShape,
    height: f64,
    corners: &[[f64; 3]],
) {
    let snapshot = open(&document(road, object));
    let first: Object<'_> = snapshot.map().objects().next().expect("an object");
    assert_eq!(first.shape(), shape, "{object}");
    assert!((first.height() - height).abs() < SINGLE, "{object}: height {}", first.height());
    let mut found = vec![];
    first.placements().next().expect("a place").footprint(&mut found);
    let near = |(a, b): (&DVec3, &[f64; 3])| a.distance(DVec3::from_array(*b)) < SINGLE;
    let fits = found.len() == corners.len() && found.iter().zip(corners).all(near);
    assert!(fits, "{object}\nfound    {found:?}\nexpected {corners:?}");
}

#[test]
fn a_point_stands_beside_the_line_at_its_height_and_offset() {
    let object = r#"<object id="1" type="tree" s="30" t="4" zOffset="0.5" orientation="none"/>"#;
    // Without tilt: (30, 4), 0.5 above the line at height 0.
    check(&PLAIN, object, ObjectShape::Point, 0.0, &[[30.0, 4.0, 0.5]]);
    // Northward, left is −x; t counts on the rolled plane, so x = 10 − 4·cos 0.1; y = 20 + 30; z = 5 + 0.1·30 + 0.5: the
    // line's height, not the rolled plane's.
    let x = 10.0 - 4.0 * 0.1f64.cos();
    check(&TILTED, object, ObjectShape::Point, 0.0, &[[x, 50.0, 8.5]]);
}

#[test]
fn a_box_turns_by_heading_then_pitch_then_roll() {
    // Half sizes 2 and 1 about (30, 4).
    let object = r#"<object id="1" type="obstacle" s="30" t="4" zOffset="0" orientation="none" length="4" width="2" height="1.5"/>"#;
    let corners = [[32.0, 3.0, 0.0], [32.0, 5.0, 0.0], [28.0, 5.0, 0.0], [28.0, 3.0, 0.0]];
    check(&PLAIN, object, ObjectShape::Box, 1.5, &corners);
    // A quarter turn to the left: u is +y, v is −x.
    let object = r#"<object id="1" type="obstacle" s="30" t="4" zOffset="0" hdg="1.5707963267948966" orientation="none" length="4" width="2" height="1.5"/>"#;
    let corners = [[31.0, 6.0, 0.0], [29.0, 6.0, 0.0], [29.0, 2.0, 0.0], [31.0, 2.0, 0.0]];
    check(&PLAIN, object, ObjectShape::Box, 1.5, &corners);
    // Pitch 0.2: the front goes down by 2·sin 0.2, and comes nearer: 30 + 2·cos 0.2.
    let object = r#"<object id="1" type="obstacle" s="30" t="4" zOffset="0" pitch="0.2" orientation="none" length="4" width="2"/>"#;
    let (u, w) = (2.0 * 0.2f64.cos(), 2.0 * 0.2f64.sin());
    let corners =
        [[30.0 + u, 3.0, -w], [30.0 + u, 5.0, -w], [30.0 - u, 5.0, w], [30.0 - u, 3.0, w]];
    check(&PLAIN, object, ObjectShape::Box, 0.0, &corners);
    // Roll 0.2: the left side goes up by sin 0.2.
    let object = r#"<object id="1" type="obstacle" s="30" t="4" zOffset="0" roll="0.2" orientation="none" length="4" width="2"/>"#;
    let (v, w) = (0.2f64.cos(), 0.2f64.sin());
    let corners =
        [[32.0, 4.0 - v, -w], [32.0, 4.0 + v, w], [28.0, 4.0 + v, w], [28.0, 4.0 - v, -w]];
    check(&PLAIN, object, ObjectShape::Box, 0.0, &corners);
}

#[test]
fn an_object_perpendicular_to_the_road_leans_with_it() {
    let object = r#"<object id="1" type="patch" s="30" t="0" zOffset="0" perpToRoad="true" orientation="none" length="2" width="2"/>"#;
    // Origin (10, 50, 8). Ahead: north, rising by atan 0.1; left: −x, raised by 0.1 rad, and, being turned about the
    // inclined u axis, tilted forward as much as u's own z component demands: v = (−cos r, −sin p·sin r, cos p·sin r) with
    // the slope's angle p and r = 0.1.
    let p = 0.1f64.atan();
    let (cp, sp) = (p.cos(), p.sin());
    let (cr, sr) = (0.1f64.cos(), 0.1f64.sin());
    let u = DVec3::new(0.0, cp, sp);
    let v = DVec3::new(-cr, -sp * sr, cp * sr);
    let origin = DVec3::new(10.0, 50.0, 8.0);
    let corners = [u - v, u + v, v - u, -u - v].map(|offset| (origin + offset).to_array());
    check(&TILTED, object, ObjectShape::Box, 0.0, &corners);
}

#[test]
fn a_cylinder_is_round() {
    let object = r#"<object id="1" type="pole" s="30" t="4" zOffset="0" radius="0.25" height="6" orientation="none"/>"#;
    let snapshot = open(&document(&PLAIN, object));
    let pole = snapshot.map().objects().next().expect("an object");
    let mut corners = vec![];
    pole.footprint(&mut corners);
    assert_eq!((pole.shape(), pole.height(), corners.len()), (ObjectShape::Cylinder, 6.0, 32));
    let centre = DVec3::new(30.0, 4.0, 0.0);
    assert!(corners.iter().all(|c| (c.distance(centre) - 0.25).abs() < SINGLE));
    let placement = pole.template();
    assert!((placement.distance(xy(31.0, 4.0)) - 0.75).abs() < SINGLE);
    assert_eq!(placement.distance(xy(30.1, 4.0)), 0.0);
}

fn xy(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

#[test]
fn corners_along_the_road_are_placed_by_s_and_t() {
    // dz counts from the line: 0.1 per metre of s, from 5 at s = 0; t shrinks by cos 0.1.
    let object = r#"<object id="1" type="crosswalk" s="30" t="0" zOffset="0" orientation="none"><outlines><outline id="0"><cornerRoad id="0" s="29" t="-3" dz="0" height="0.1"/><cornerRoad id="1" s="31" t="-3" dz="0.2" height="0.1"/><cornerRoad id="2" s="31" t="3" dz="0" height="0.3"/></outline></outlines></object>"#;
    let x = 3.0 * 0.1f64.cos();
    let corners = [[10.0 + x, 49.0, 7.9], [10.0 + x, 51.0, 8.3], [10.0 - x, 51.0, 8.1]];
    check(&TILTED, object, ObjectShape::Outlines, 0.3, &corners);
}

#[test]
fn corners_of_the_object_turn_with_it_in_the_old_form_too() {
    let corners = r#"<outline><cornerLocal u="1" v="0" z="0" height="2"/><cornerLocal u="0" v="1" z="0.5" height="2"/><cornerLocal u="-1" v="0" z="0" height="2"/></outline>"#;
    let object = |inside: String| {
        format!(
            r#"<object id="1" type="building" s="30" t="4" zOffset="1" hdg="1.5707963267948966" orientation="none">{inside}</object>"#
        )
    };
    // u is +y, v is −x.
    let expected = [[30.0, 5.0, 1.0], [29.0, 4.0, 1.5], [30.0, 3.0, 1.0]];
    let old = ObjectRoad { version: "1.4", ..PLAIN };
    check(&old, &object(corners.to_owned()), ObjectShape::Outlines, 2.0, &expected);
    let new = object(format!("<outlines>{corners}</outlines>"));
    check(&PLAIN, &new, ObjectShape::Outlines, 2.0, &expected);
}

#[test]
fn curves_of_an_outline_stay_within_the_tolerance() {
    // A half disc of radius 2 about (30, 0): a straight edge from (30, −2) to (30, 2) closes it.
    let object = r#"<object id="1" type="trafficIsland" s="30" t="0" zOffset="0" orientation="none"><outlines><outline id="0" closed="true"><curveLocal id="0" u="0" v="-2" z="0" height="0.2" hdg="0" length="6.283185307179586"><arc curvature="0.5"/></curveLocal><curveLocal id="1" u="0" v="2" z="0" height="0.2" hdg="-1.5707963267948966" length="4"><line/></curveLocal></outline></outlines></object>"#;
    let snapshot = open(&document(&ObjectRoad { version: "1.9", ..PLAIN }, object));
    let island = snapshot.map().objects().next().expect("an object");
    let mut corners = vec![];
    island.footprint(&mut corners);
    let centre = DVec3::new(30.0, 0.0, 0.0);
    assert!(corners.len() > 8, "{}", corners.len());
    assert!(corners.iter().all(|c| (c.distance(centre) - 2.0).abs() < SINGLE), "{corners:?}");
    let sagitta = corners.windows(2).map(|pair| 2.0 - ((pair[0] + pair[1]) / 2.0).distance(centre));
    assert!(sagitta.fold(0.0, f64::max) <= 0.01);
    assert_eq!(island.template().distance(xy(31.0, 0.5)), 0.0);
    assert!((island.template().distance(xy(28.5, 0.0)) - 1.5).abs() < SINGLE);
}

#[test]
fn a_hole_is_not_covered() {
    let corner = |u: f64, v: f64| format!(r#"<cornerLocal u="{u}" v="{v}" z="0" height="0"/>"#);
    let square = |h: f64| corner(h, -h) + &corner(h, h) + &corner(-h, h) + &corner(-h, -h);
    let object = format!(
        r#"<object id="1" type="trafficIsland" s="30" t="0" zOffset="0" orientation="none"><outlines><outline id="0" outer="true" closed="true">{}</outline><outline id="1" outer="false" closed="true">{}</outline></outlines></object>"#,
        square(4.0),
        square(1.0)
    );
    let snapshot = open(&document(&PLAIN, &object));
    let island = snapshot.map().objects().next().expect("an object").template();
    assert_eq!(island.distance(xy(32.0, 0.0)), 0.0);
    assert!((island.distance(xy(30.0, 0.25)) - 0.75).abs() < SINGLE);
    assert_eq!(island.outlines().filter(|outline| outline.is_outer()).count(), 1);
}
