//! Where objects of the shared corpus stand, worked out by hand from what their files say, across vendors and versions: the
//! point of the reference line by the closed form of a line or arc, t to its left, elevation plus zOffset, and the first
//! corner of the footprint in plan view. None of these roads is superelevated there.

use mapd_tests::maps;

/// Numbers below have nine digits after the point `[m]`, `[rad]`.
const ROUNDED: f64 = 1e-9;
/// Corners, pitch and sizes are stored in single precision `[m]`.
const SINGLE: f64 = 2e-6;

/// An object, and what must be found.
struct At {
    map: &'static str,
    road: &'static str,
    object: &'static str,
    position: [f64; 3],
    heading: f64,
    corner: [f64; 2],
}

const ALL: &[At] = &[
    // Line from (384.59, -0.02), heading 3.14106, u = 17.4723;
    // then t = -4.31972 to the left of heading 3.14106; z = 0 + 0.150966; hdg 0.00053128 more; the point itself.
    At {
        map: "ad_map_access/Town01",
        road: "0",
        object: "435",
        position: [367.120000000, 4.308999905, 0.150966078],
        heading: -3.141592610,
        corner: [367.120000000, 4.308999905],
    },
    // Line from (290.364, 0.0300113), heading 3.14149, u = 108.664;
    // then t = -4.25739 to the left of heading 3.14149; z = 0 + 0.1; hdg 0.000106773 more; the point itself.
    At {
        map: "ad_map_access/Town01",
        road: "1",
        object: "441",
        position: [181.700000000, 4.298999977, 0.100000000],
        heading: -3.141592610,
        corner: [181.700000000, 4.298999977],
    },
    // Line from (-109.341, -75.7833), heading 1.55959, u = 5.61573;
    // then t = -5.25 to the left of heading 1.55959; z = 0 + 0; hdg -4.27366e-10 more; half of 2.54103 ahead, half of 1.91813 to the right.
    At {
        map: "Scenic/Town10HD",
        road: "5",
        object: "1028",
        position: [-104.028115472, -70.226799537, 0.000000000],
        heading: 1.559587192,
        corner: [-103.054870818, -68.967116148],
    },
    // Line from (-110.71, -50.7191), heading 3.13292, u = 29.635;
    // then t = 4.20205 to the left of heading 3.13292; z = 0 + 0; hdg -3.13292 more; the point itself.
    At {
        map: "Scenic/Town07",
        road: "0",
        object: "1157",
        position: [-140.380000010, -54.664001104, 0.000000000],
        heading: -0.000000133,
        corner: [-140.380000010, -54.664001104],
    },
    // Line from (-158.268, -50.3066), heading 3.13292, u = 30.7724;
    // then t = -4.16991 to the left of heading 3.13292; z = 0 + 0; hdg 0.00867328 more; half of 0.0449658 ahead, half of 0.0449657 to the right.
    At {
        map: "Scenic/Town07",
        road: "1",
        object: "1113",
        position: [-189.002999654, -45.870001362, 0.000000000],
        heading: -3.141592610,
        corner: [-189.025482568, -45.847518527],
    },
    // Line from (-11.4076, 159.487), heading 3.13183, u = 1.22986;
    // then t = 7.13167 to the left of heading 3.13183; z = 0.139954 + 0.153046; hdg -3.13183 more; half of 0.0449658 ahead, half of 0.0449657 to the right.
    At {
        map: "Scenic/Town07",
        road: "3",
        object: "1134",
        position: [-12.707000406, 152.367995056, 0.293000000],
        heading: 0.000000049,
        corner: [-12.684517492, 152.345512221],
    },
    // Line from (1778, 0), heading 0, u = 2;
    // then t = 0 to the left of heading 0; z = 0 + 0; hdg 0 more; corner s = 1, t = 3.
    At {
        map: "maliput_xodr/12_map_integration",
        road: "6",
        object: "0",
        position: [1780.000000000, 0.000000000, 0.000000000],
        heading: 0.000000000,
        corner: [1779.000000000, 3.000000000],
    },
    // Arc from (35.1275, -66.355), heading 2.03261, curvature -0.002, u = 14.7802;
    // then t = -4.94612 to the left of heading 2.00305; z = 0.0376472 + 0.3302; hdg -0.00903402 more; corner u = -17.9489, v = 0.511496 turned by it.
    At {
        map: "drone_dataset/rdb2",
        road: "5",
        object: "78",
        position: [33.229553699, -50.955702007, 0.367847234],
        heading: 1.994019621,
        corner: [40.134828323, -67.531043526],
    },
    // Arc from (1.79898, -25.3943), heading -0.368031, curvature -0.0108427, u = 0.602667;
    // then t = -6.57348 to the left of heading -0.374565; z = 0.0773315 + 0.3302; hdg 3.14159 more; corner u = 5.5758, v = 0.311275 turned by it.
    At {
        map: "drone_dataset/rdb2",
        road: "20",
        object: "77",
        position: [-0.044451823, -31.730662445, 0.407531530],
        heading: 2.767021197,
        corner: [-5.347542239, -29.980314972],
    },
    // Arc from (-21.7721, 55.4167), heading -1.19389, curvature -0.00208434, u = 22.0428;
    // then t = 0.181455 to the left of heading -1.23984; z = 0 + 1.90735e-06; hdg -3.09229 more; corner u = -12.0367, v = -0.956401 turned by it.
    At {
        map: "drone_dataset/rdb5",
        road: "15",
        object: "78",
        position: [-13.961433293, 34.800993452, 0.000001907],
        heading: 1.951061398,
        corner: [-8.605740433, 23.979128454],
    },
    // Line from (-20, 50), heading -1.5708, u = 50;
    // then t = 20 to the left of heading -1.5708; z = 0 + 0; hdg 0 more; the point itself.
    At {
        map: "ivsg/RR_junction_mainRoad",
        road: "67",
        object: "68",
        position: [0.000000000, 0.000000000, 0.000000000],
        heading: -std::f64::consts::FRAC_PI_2,
        corner: [0.000000000, 0.000000000],
    },
    // Line from (151.936, -120.156), heading 6.9356, u = 2.2056;
    // then t = 0.73153 to the left of heading 6.9356; z = 0 + 0; hdg 0 more; radius 0.608 ahead.
    At {
        map: "ivsg/scenario1_3_WithObjects_WithSigns",
        road: "0",
        object: "2",
        position: [153.244197243, -118.235776468, 0.000000000],
        heading: 0.652414693,
        corner: [153.727326288, -117.866655450],
    },
    // Arc from (0, 0), heading 0, curvature 0.002, u = 20;
    // then t = -3.25 to the left of heading 0.04; z = 0 + 0; hdg 0 more; radius 0.286 ahead.
    At {
        map: "ivsg/workzone_100m_Lane_Offset",
        road: "1",
        object: " 1",
        position: [20.124632429, -2.847453677, 0.000000000],
        heading: 0.040000000,
        corner: [20.410403660, -2.836016728],
    },
    // Arc from (100, 0), heading 0, curvature -0.02, u = 52;
    // then t = 0 to the left of heading -1.04; z = 0 + 0; hdg 1.5708 more; corner u = -3.2, v = -2 turned by it.
    At {
        map: "esmini/parking_demo",
        road: "1",
        object: "3",
        position: [143.120211362, -24.688987138, 0.000000000],
        heading: 0.530796400,
        corner: [141.372958594, -28.033700544],
    },
    // Line from (0, 0), heading 0, u = 0;
    // then t = 3.57 to the left of heading 0; z = 0 + -0.2; hdg 0 more; half of 0.06 ahead, half of 0.06 to the right.
    At {
        map: "esmini/straight_500m_signs",
        road: "1",
        object: "0",
        position: [0.000000000, 3.570000000, -0.200000000],
        heading: 0.000000000,
        corner: [0.030000000, 3.540000000],
    },
    // Line from (70, 360), heading 0, u = 50;
    // then t = 4.40536e-13 to the left of heading 0; z = 0 + 0; hdg 0 more; corner s = 52.5, t = 1.5.
    At {
        map: "qc-opendrive/rule_178_junctions_priority_high_and_low_attrib_valid",
        road: "1",
        object: "0",
        position: [120.000000000, 360.000000000, 0.000000000],
        heading: 0.000000000,
        corner: [122.500000000, 361.500000000],
    },
    // Line from (-40.0145, -19.4626), heading 0.545554, u = 31.0642;
    // then t = 1.68862 to the left of heading 0.545554; z = 0 + 0; hdg 5.74012 more; half of 1.918 ahead, half of 3.223 to the right.
    At {
        map: "qc-opendrive/rule_305_road.object.attributes_roadSurface_valid",
        road: "1",
        object: "2",
        position: [-14.335839544, -1.900172633, 0.000000000],
        heading: 0.002485259,
        corner: [-13.372837515, -3.509284296],
    },
];

#[test]
fn objects_stand_where_their_files_say() {
    if mapd_tests::shared("maps").is_none() {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    }
    let mut corners = Vec::new();
    for at in ALL {
        let folder = mapd_tests::shared("maps").expect("there");
        let snapshot = maps::open(&folder.join(format!("{}.xodr", at.map)));
        let road = snapshot.map().road_by_id(at.road).expect("the road");
        let object = road.objects().find(|object| object.id() == at.object).expect("the object");
        let what = format!("{} road {} object {}", at.map, at.road, at.object);
        let off = object.position() - mapd_client::glam::DVec3::from_array(at.position);
        assert!(off.abs().max_element() <= ROUNDED, "{what}: {}", object.position());
        let turned = mapd_geometry::normalize_angle(object.heading() - at.heading);
        assert!(turned.abs() <= ROUNDED, "{what}: heading {}", object.heading());
        object.footprint(&mut corners);
        let corner = corners[0].truncate();
        let expected = mapd_client::glam::DVec2::from_array(at.corner);
        assert!(corner.distance(expected) <= SINGLE, "{what}: corner {corner}");
    }
    assert!(ALL.len() >= 15);
}
