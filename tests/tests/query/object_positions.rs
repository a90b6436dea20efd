//! Where objects of the shared corpus stand, worked out by hand from what their files say, across vendors and versions: the
//! point of the reference line by the closed form of a line or arc, t to its left, elevation plus zOffset, and the first
//! corner of the footprint in plan view, with the area that it covers (length by width, the 32 corners of a circle, the outline's
//! own corners). None of these roads is superelevated there.

use mapd_client::glam::{DVec2, DVec3};
use mapd_tests::maps;
use std::path::Path;

/// Numbers below have nine digits after the point `[m]`, `[rad]`.
const ROUNDED: f64 = 1e-9;
/// Corners, pitch and sizes are stored in single precision `[m]`.
const SINGLE: f64 = 2e-6;
/// So far an area may be off `[m²]`: corners that are off by 2 µm, along edges of 75 m.
const AREA: f64 = 1.5e-4;

/// Map, road, object, position, heading, first corner of the footprint, area of the footprint in plan view `[m²]`.
type Case = (&'static str, &'static str, &'static str, [f64; 3], f64, [f64; 2], f64);

#[rustfmt::skip]
const CASES: &[Case] = &[
    // Line from (384.59, -0.02), heading 3.14106, u = 17.4723;
    // then t = -4.31972 to the left of heading 3.14106; z = 0 + 0.150966; hdg 0.00053128 more; the point itself.
    ("ad_map_access/Town01", "0", "435", [367.120000000, 4.308999905, 0.150966078], -3.141592610, [367.120000000, 4.308999905], 0.000000000),
    // Line from (290.364, 0.0300113), heading 3.14149, u = 108.664;
    // then t = -4.25739 to the left of heading 3.14149; z = 0 + 0.1; hdg 0.000106773 more; the point itself.
    ("ad_map_access/Town01", "1", "441", [181.700000000, 4.298999977, 0.100000000], -3.141592610, [181.700000000, 4.298999977], 0.000000000),
    // Line from (-109.341, -75.7833), heading 1.55959, u = 5.61573;
    // then t = -5.25 to the left of heading 1.55959; z = 0 + 0; hdg -4.27366e-10 more; half of 2.54103 ahead, half of 1.91813 to the right.
    ("Scenic/Town10HD", "5", "1028", [-104.028115472, -70.226799537, 0.000000000], 1.559587192, [-103.054870818, -68.967116148], 4.874013321),
    // Line from (-110.71, -50.7191), heading 3.13292, u = 29.635;
    // then t = 4.20205 to the left of heading 3.13292; z = 0 + 0; hdg -3.13292 more; the point itself.
    ("Scenic/Town07", "0", "1157", [-140.380000010, -54.664001104, 0.000000000], -0.000000133, [-140.380000010, -54.664001104], 0.000000000),
    // Line from (-158.268, -50.3066), heading 3.13292, u = 30.7724;
    // then t = -4.16991 to the left of heading 3.13292; z = 0 + 0; hdg 0.00867328 more; half of 0.0449658 ahead, half of 0.0449657 to the right.
    ("Scenic/Town07", "1", "1113", [-189.002999654, -45.870001362, 0.000000000], -3.141592610, [-189.025482568, -45.847518527], 0.002021918),
    // Line from (-11.4076, 159.487), heading 3.13183, u = 1.22986;
    // then t = 7.13167 to the left of heading 3.13183; z = 0.139954 + 0.153046; hdg -3.13183 more; half of 0.0449658 ahead, half of 0.0449657 to the right.
    ("Scenic/Town07", "3", "1134", [-12.707000406, 152.367995056, 0.293000000], 0.000000049, [-12.684517492, 152.345512221], 0.002021918),
    // Line from (1778, 0), heading 0, u = 2;
    // then t = 0 to the left of heading 0; z = 0 + 0; hdg 0 more; corner s = 1, t = 3.
    ("maliput_xodr/12_map_integration", "6", "0", [1780.000000000, 0.000000000, 0.000000000], 0.000000000, [1779.000000000, 3.000000000], 6.000000000),
    // Arc from (35.1275, -66.355), heading 2.03261, curvature -0.002, u = 14.7802;
    // then t = -4.94612 to the left of heading 2.00305; z = 0.0376472 + 0.3302; hdg -0.00903402 more; corner u = -17.9489, v = 0.511496 turned by it.
    ("drone_dataset/rdb2", "5", "78", [33.229553699, -50.955702007, 0.367847234], 1.994019621, [40.134828323, -67.531043526], 12.554879773),
    // Arc from (1.79898, -25.3943), heading -0.368031, curvature -0.0108427, u = 0.602667;
    // then t = -6.57348 to the left of heading -0.374565; z = 0.0773315 + 0.3302; hdg 3.14159 more; corner u = 5.5758, v = 0.311275 turned by it.
    ("drone_dataset/rdb2", "20", "77", [-0.044451823, -31.730662445, 0.407531530], 2.767021197, [-5.347542239, -29.980314972], 3.561287229),
    // Arc from (-21.7721, 55.4167), heading -1.19389, curvature -0.00208434, u = 22.0428;
    // then t = 0.181455 to the left of heading -1.23984; z = 0 + 1.90735e-06; hdg -3.09229 more; corner u = -12.0367, v = -0.956401 turned by it.
    ("drone_dataset/rdb5", "15", "78", [-13.961433293, 34.800993452, 0.000001907], 1.951061398, [-8.605740433, 23.979128454], 22.999230941),
    // Line from (-20, 50), heading -1.5708, u = 50;
    // then t = 20 to the left of heading -1.5708; z = 0 + 0; hdg 0 more; the point itself.
    ("ivsg/RR_junction_mainRoad", "67", "68", [0.000000000, 0.000000000, 0.000000000], -std::f64::consts::FRAC_PI_2, [0.000000000, 0.000000000], 0.000000000),
    // Line from (151.936, -120.156), heading 6.9356, u = 2.2056;
    // then t = 0.73153 to the left of heading 6.9356; z = 0 + 0; hdg 0 more; radius 0.608 ahead.
    ("ivsg/scenario1_3_WithObjects_WithSigns", "0", "2", [153.244197243, -118.235776468, 0.000000000], 0.652414693, [153.727326288, -117.866655450], 1.153885901),
    // Arc from (0, 0), heading 0, curvature 0.002, u = 20;
    // then t = -3.25 to the left of heading 0.04; z = 0 + 0; hdg 0 more; radius 0.286 ahead.
    ("ivsg/workzone_100m_Lane_Offset", "1", " 1", [20.124632429, -2.847453677, 0.000000000], 0.040000000, [20.410403660, -2.836016728], 0.255321728),
    // Arc from (100, 0), heading 0, curvature -0.02, u = 52;
    // then t = 0 to the left of heading -1.04; z = 0 + 0; hdg 1.5708 more; corner u = -3.2, v = -2 turned by it.
    ("esmini/parking_demo", "1", "3", [143.120211362, -24.688987138, 0.000000000], 0.530796400, [141.372958594, -28.033700544], 25.600000000),
    // Line from (0, 0), heading 0, u = 0;
    // then t = 3.57 to the left of heading 0; z = 0 + -0.2; hdg 0 more; half of 0.06 ahead, half of 0.06 to the right.
    ("esmini/straight_500m_signs", "1", "0", [0.000000000, 3.570000000, -0.200000000], 0.000000000, [0.030000000, 3.540000000], 0.003600000),
    // Line from (70, 360), heading 0, u = 50;
    // then t = 4.40536e-13 to the left of heading 0; z = 0 + 0; hdg 0 more; corner s = 52.5, t = 1.5.
    ("qc-opendrive/rule_178_junctions_priority_high_and_low_attrib_valid", "1", "0", [120.000000000, 360.000000000, 0.000000000], 0.000000000, [122.500000000, 361.500000000], 27.420000000),
    // Line from (-40.0145, -19.4626), heading 0.545554, u = 31.0642;
    // then t = 1.68862 to the left of heading 0.545554; z = 0 + 0; hdg 5.74012 more; half of 1.918 ahead, half of 3.223 to the right.
    ("qc-opendrive/rule_305_road.object.attributes_roadSurface_valid", "1", "2", [-14.335839544, -1.900172633, 0.000000000], 0.002485259, [-13.372837515, -3.509284296], 6.181714000),
];

fn check(maps: &Path, (map, road, id, position, heading, corner, area): &Case) {
    let snapshot = maps::open(&maps.join(format!("{map}.xodr")));
    let road = snapshot.map().road_by_id(road).expect("the road");
    let object = road.objects().find(|object| object.id() == *id).expect("the object");
    let what = format!("{map} road {} object {id}", road.id());
    let off = object.position() - DVec3::from_array(*position);
    assert!(off.abs().max_element() <= ROUNDED, "{what}: {}", object.position());
    let turned = mapd_geometry::normalize_angle(object.heading() - heading);
    assert!(turned.abs() <= ROUNDED, "{what}: heading {}", object.heading());
    let mut corners = Vec::new();
    object.footprint(&mut corners);
    let found = corners[0].truncate();
    assert!(found.distance(DVec2::from_array(*corner)) <= SINGLE, "{what}: corner {found}");
    // Twice the area of the triangles from the first corner; relative to it, so that no digits are lost.
    let edges = corners.windows(2).map(|pair| [pair[0], pair[1]].map(|p| p.truncate() - found));
    let found: f64 = edges.map(|[a, b]| 0.5 * a.perp_dot(b)).sum();
    assert!((found.abs() - area).abs() <= AREA, "{what}: covers {found}");
}

#[test]
fn objects_stand_where_their_files_say() {
    let Some(maps) = mapd_tests::shared("maps") else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    CASES.iter().for_each(|case| check(&maps, case));
}
