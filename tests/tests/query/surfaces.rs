//! The road's surface: heights and normals worked out by hand, and normals against differences.

use mapd_archive::{
    CubicRow, ElevationGridRow, GridRowRow, GridTransitionRow, LaneHeightRow, LaneMaterialRow,
    Range, Rows, ShapeStationRow, SurfaceRow, SurfaceStripRow, encode,
};
use mapd_client::glam::DVec3;
use mapd_client::roads::LaneHeight;
use mapd_client::{LaneKey, Snapshot};
use mapd_compiler::{CompileOptions, compile};

/// Rounding of coordinates of some hundred metres `[m]`.
const ROUNDING: f64 = 1e-12;
/// Step of a difference `[m]`, and how far it may be from perpendicular to the normal.
const STEP: f64 = 1e-5;
const DIFFERENCE: f64 = 1e-8;

/// What a test road is made of, as OpenDRIVE writes it.
struct RoadText<'a> {
    geometry: &'a str,
    elevation: &'a str,
    superelevation: &'a str,
    junction: &'a str,
}

/// 100 m from the origin along x at a height of 10 m.
const PLAIN: RoadText<'_> = RoadText {
    geometry: "<line/>",
    elevation: "a=\"10\" b=\"0\" c=\"0\" d=\"0\"",
    superelevation: "a=\"0\" b=\"0\" c=\"0\" d=\"0\"",
    junction: "-1",
};

/// Row of lane 1, and of lanes −1 and −2; lane −2 is level.
const LANES: [u32; 3] = [0, 2, 3];

/// A map of one road with these rows besides its own.
fn open(road: &RoadText<'_>, add: impl FnOnce(&mut Rows)) -> Snapshot {
    let lane = |id: i32, level: bool, width: f64| {
        format!(
            "<lane id=\"{id}\" type=\"driving\" level=\"{level}\"><width sOffset=\"0\" a=\"{width}\" b=\"0\" c=\"0\" d=\"0\"/></lane>"
        )
    };
    let text = format!(
        "<OpenDRIVE><header revMajor=\"1\" revMinor=\"8\"/><road id=\"1\" length=\"100\" junction=\"{}\">\
         <planView><geometry s=\"0\" x=\"0\" y=\"0\" hdg=\"0\" length=\"100\">{}</geometry></planView>\
         <elevationProfile><elevation s=\"0\" {}/></elevationProfile>\
         <lateralProfile><superelevation s=\"0\" {}/></lateralProfile>\
         <lanes><laneSection s=\"0\"><left>{}</left><center><lane id=\"0\"/></center><right>{}{}</right></laneSection></lanes></road>\
         <junction id=\"7\" name=\"\"/></OpenDRIVE>",
        road.junction,
        road.geometry,
        road.elevation,
        road.superelevation,
        lane(1, false, 3.5),
        lane(-1, false, 3.5),
        lane(-2, true, 2.0)
    );
    let compiled =
        compile(text.as_bytes(), &CompileOptions::default(), &mut |_| {}).expect("reading works");
    let mut rows = compiled.rows.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    add(&mut rows);
    let bytes = encode(&rows, &compiled.provenance).expect("encodes");
    mapd_archive::verify(&bytes).expect("the rows are sound");
    Snapshot::from_bytes(bytes).expect("opens")
}

/// Records of four coefficients each, with the s at which they begin.
fn cubics(rows: &mut Rows, records: &[(f64, [f64; 4])]) -> Range {
    let first = rows.cubics.len();
    rows.cubics.extend(records.iter().map(|(s, [a, b, c, d])| CubicRow {
        s: *s,
        a: *a,
        b: *b,
        c: *c,
        d: *d,
    }));
    Range::between(first, rows.cubics.len()).expect("few")
}

fn surface() -> SurfaceRow {
    let none = Range::default();
    SurfaceRow {
        road: 0,
        shapes: none,
        crossfall_left: none,
        crossfall_right: none,
        strip_offset: none,
        strips: none,
    }
}

#[track_caller]
fn check(snapshot: &Snapshot, (s, t): (f64, f64), position: [f64; 3], normal: [f64; 3]) {
    let road = snapshot.map().road_by_id("1").expect("the road");
    let found = road.surface_at(s, t).expect("a surface");
    let expected = (DVec3::from(position), DVec3::from(normal).normalize());
    let off = found.position.distance(expected.0).max(found.normal.distance(expected.1));
    assert!(off <= ROUNDING, "{found:?} instead of {expected:?}");
}

#[test]
fn elevation_tilts_the_normal_backwards() {
    // 10 m + 0.02 s: at s = 50 11 m; the normal leans back by the slope.
    let road = RoadText { elevation: "a=\"10\" b=\"0.02\" c=\"0\" d=\"0\"", ..PLAIN };
    check(&open(&road, |_| {}), (50.0, 2.0), [50.0, 2.0, 11.0], [-0.02, 0.0, 1.0]);
}

#[test]
fn shape_stands_on_the_rolled_plane() {
    // Rolled by σ = 0.1: 2 m to the left lie at y = 2 cos σ, z = 10 + 2 sin σ. A shape of 0.3 m there, growing by 0.05 per
    // metre of t, moves the point along the plane's normal (0, −sin σ, cos σ) and tilts the surface's normal: its
    // direction across is (0, cos σ − 0.05 sin σ, sin σ + 0.05 cos σ).
    let road = RoadText { superelevation: "a=\"0.1\" b=\"0\" c=\"0\" d=\"0\"", ..PLAIN };
    let snapshot = open(&road, |rows| {
        let records = cubics(rows, &[(-10.0, [9.0, 0.0, 0.0, 0.0]), (0.0, [0.2, 0.05, 0.0, 0.0])]);
        rows.shape_stations.push(ShapeStationRow { s: 0.0, records });
        rows.surfaces.push(SurfaceRow { shapes: Range { first: 0, count: 1 }, ..surface() });
    });
    let (sin, cos) = (0.1f64.sin(), 0.1f64.cos());
    let across = [0.0, cos - 0.05 * sin, sin + 0.05 * cos];
    check(
        &snapshot,
        (50.0, 2.0),
        [50.0, 2.0 * cos - 0.3 * sin, 10.0 + 2.0 * sin + 0.3 * cos],
        [0.0, -across[2], across[1]],
    );
}

#[test]
fn crossfall_falls_to_both_sides() {
    // tan = 0.02 on the left, 0.04 on the right from s = 50 on: 0.07 m at t = 3.5, 0.06 m at t = −1.5.
    let snapshot = open(&PLAIN, |rows| {
        let crossfall_left = cubics(rows, &[(0.0, [0.02f64.atan(), 0.0, 0.0, 0.0])]);
        let crossfall_right = cubics(rows, &[(50.0, [0.04f64.atan(), 0.0, 0.0, 0.0])]);
        rows.surfaces.push(SurfaceRow { crossfall_left, crossfall_right, ..surface() });
    });
    check(&snapshot, (60.0, 3.5), [60.0, 3.5, 9.93], [0.0, 0.02, 1.0]);
    check(&snapshot, (60.0, -1.5), [60.0, -1.5, 9.94], [0.0, -0.04, 1.0]);
    check(&snapshot, (40.0, -1.5), [40.0, -1.5, 10.0], [0.0, 0.0, 1.0]);
}

#[test]
fn strips_count_from_a_shifted_middle() {
    // The middle at t = 1; an inner strip of 2 m that falls by 0.1 per metre, an outer one that rises by 0.2, relative.
    // t = 2: −0.1. t = 4: −0.2 + 0.2 = 0.
    let snapshot = open(&PLAIN, |rows| {
        let none = Range::default();
        let strip_offset = cubics(rows, &[(0.0, [1.0, 0.0, 0.0, 0.0])]);
        let width = cubics(rows, &[(0.0, [2.0, 0.0, 0.0, 0.0])]);
        let falls = cubics(rows, &[(0.0, [-0.1, 0.0, 0.0, 0.0])]);
        let rises = cubics(rows, &[(0.0, [0.2, 0.0, 0.0, 0.0])]);
        let strip = |id: i32, width: Range, linear: Range, mode: u32| SurfaceStripRow {
            width,
            constant: none,
            linear,
            quadratic: none,
            cubic: none,
            id,
            mode,
        };
        rows.surface_strips.push(strip(1, width, falls, 0));
        rows.surface_strips.push(strip(2, none, rises, 1));
        rows.surfaces.push(SurfaceRow {
            strip_offset,
            strips: Range { first: 0, count: 2 },
            ..surface()
        });
    });
    check(&snapshot, (50.0, 2.0), [50.0, 2.0, 9.9], [0.0, 0.1, 1.0]);
    check(&snapshot, (50.0, 4.0), [50.0, 4.0, 10.0], [0.0, -0.2, 1.0]);
    check(&snapshot, (50.0, -1.0), [50.0, -1.0, 10.0], [0.0, 0.0, 1.0]);
}

#[test]
fn lanes_rise_and_have_materials() {
    let [left, right, _] = LANES;
    let snapshot = open(&PLAIN, |rows| {
        for (lane, s, inner, outer) in
            [(left, 0.0, 0.1, 0.1), (right, 0.0, 0.0, 0.0), (right, 50.0, 0.1, 0.45)]
        {
            rows.lane_heights.push(LaneHeightRow { s, inner, outer, lane, reserved: 0 });
        }
        for (s, friction, roughness) in [(0.0, 0.8, -1.0), (50.0, 0.4, 0.015)] {
            rows.lane_materials.push(LaneMaterialRow {
                s,
                friction,
                roughness,
                lane: right,
                surface: 0,
            });
        }
    });
    // Lane 1 lies 0.1 m higher all along; lane −1 from s = 50 on by 0.1 m inside and 0.45 m outside, 0.275 m in its middle,
    // with a slope of 0.35 m over −3.5 m.
    check(&snapshot, (20.0, 1.0), [20.0, 1.0, 10.1], [0.0, 0.0, 1.0]);
    check(&snapshot, (20.0, -1.75), [20.0, -1.75, 10.0], [0.0, 0.0, 1.0]);
    check(&snapshot, (70.0, -1.75), [70.0, -1.75, 10.275], [0.0, 0.1, 1.0]);
    let road = snapshot.map().road_by_id("1").expect("the road");
    let material = |s: f64, t: f64| road.surface_at(s, t).expect("a surface").material;
    let (before, behind) = (material(20.0, -1.0).expect("one"), material(70.0, -1.0).expect("one"));
    assert_eq!((before.friction, before.roughness), (Some(0.8), None));
    assert_eq!((behind.friction, behind.roughness), (Some(0.4), Some(0.015)));
    assert_eq!(material(20.0, 1.0), None);
    let key: LaneKey<'_> = "1:0:-1".parse().expect("a key");
    let lane = snapshot.map().lane_by_key(&key).expect("the lane");
    assert_eq!(lane.height_at(70.0), LaneHeight { inner: 0.1, outer: 0.45 });
    assert_eq!(road.surface_at(70.0, -1.0).expect("a surface").lane, Some(lane.lane_id()));
    assert_eq!(road.surface_at(70.0, -9.0).expect("a surface").lane, None);
}

#[test]
fn level_lanes_are_level_from_their_inner_edge() {
    // Rolled by σ = 0.1 lane −2 begins at t = −3.5: y = −3.5 cos σ, z = 10 − 3.5 sin σ; a metre further out y is a metre
    // less and z the same. The level part ends with nothing: beyond the lane it goes on.
    let road = RoadText { superelevation: "a=\"0.1\" b=\"0\" c=\"0\" d=\"0\"", ..PLAIN };
    let snapshot = open(&road, |_| {});
    let (sin, cos) = (0.1f64.sin(), 0.1f64.cos());
    for beyond in [1.0, 5.0] {
        let position = [50.0, -3.5 * cos - beyond, 10.0 - 3.5 * sin];
        check(&snapshot, (50.0, -3.5 - beyond), position, [0.0, 0.0, 1.0]);
    }
    check(&snapshot, (50.0, -2.0), [50.0, -2.0 * cos, 10.0 - 2.0 * sin], [0.0, -sin, cos]);
}

/// A grid over x from 0 to 100 and y from −10 to 10 in steps of 10 m.
fn add_grid(rows: &mut Rows, height: impl Fn(f64, f64) -> f64, transition: f64) {
    for i in 0..=10 {
        let x = 10.0 * f64::from(i);
        let first = rows.grid_heights.len();
        rows.grid_heights.push(height(x, 10.0));
        rows.grid_heights.push(height(x, -10.0));
        let at = |first: usize| Range::between(first, first + 1).expect("few");
        rows.grid_rows.push(GridRowRow {
            center: height(x, 0.0),
            left: at(first),
            right: at(first + 1),
        });
    }
    if transition > 0.0 {
        let joint = GridTransitionRow {
            start_x: 0.0,
            start_y: 5.0,
            end_x: 0.0,
            end_y: -5.0,
            length: transition,
        };
        rows.grid_transitions.push(joint);
    }
    rows.elevation_grids.push(ElevationGridRow {
        // The line starts 20 m before the first row.
        x: -20.0,
        y: 0.0,
        cos: 1.0,
        sin: 0.0,
        s_start: 20.0,
        spacing: 10.0,
        junction: 0,
        rows: Range { first: 0, count: 11 },
        transitions: Range { first: 0, count: u32::from(transition > 0.0) },
        reserved: 0,
    });
}

#[test]
fn a_grid_replaces_the_height_of_roads_in_its_junction() {
    // Heights 12 + 0.1·x + 0.05·y, which a bicubic surface meets exactly; the road itself lies at 10 m.
    let road = RoadText { junction: "7", ..PLAIN };
    let plane = |x: f64, y: f64| 12.0 + 0.1 * x + 0.05 * y;
    let snapshot = open(&road, |rows| add_grid(rows, plane, 0.0));
    check(&snapshot, (34.0, 2.0), [34.0, 2.0, 15.5], [-0.1, -0.05, 1.0]);
    // Elsewhere than in the junction nothing changes.
    let snapshot = open(&PLAIN, |rows| add_grid(rows, plane, 0.0));
    check(&snapshot, (34.0, 2.0), [34.0, 2.0, 10.0], [0.0, 0.0, 1.0]);
    // A transition of 20 m from the joint at x = 0: at x = 5 a quarter of it, weight 5/32 of 12.5 − 10 m = 0.390625 m at
    // y = 0. The slope by x is 0.1·5/32 + 2.5·(6·1/4·3/4)/20 = 0.015625 + 0.140625; by y 0.05·5/32.
    let snapshot = open(&road, |rows| add_grid(rows, plane, 20.0));
    check(&snapshot, (5.0, 0.0), [5.0, 0.0, 10.390_625], [-0.156_25, -0.007_812_5, 1.0]);
    check(&snapshot, (0.0, 0.0), [0.0, 0.0, 10.0], [0.0, 0.0, 1.0]);
    check(&snapshot, (20.0, 0.0), [20.0, 0.0, 14.0], [-0.1, -0.05, 1.0]);
}

/// Where everything changes: normals are perpendicular to what differences show, positions bit-equal each time.
#[test]
fn normals_are_perpendicular_to_the_surface() {
    let curved = RoadText {
        geometry: "<spiral curvStart=\"0.002\" curvEnd=\"-0.01\"/>",
        elevation: "a=\"10\" b=\"0.02\" c=\"-0.001\" d=\"1e-5\"",
        superelevation: "a=\"0.05\" b=\"0.002\" c=\"-1e-5\" d=\"0\"",
        junction: "-1",
    };
    let profiles = |rows: &mut Rows| {
        let near = cubics(rows, &[(-20.0, [0.3, 0.01, 0.002, 1e-4])]);
        let far = cubics(rows, &[(-20.0, [0.1, -0.03, 0.001, 0.0])]);
        rows.shape_stations.push(ShapeStationRow { s: 0.0, records: near });
        rows.shape_stations.push(ShapeStationRow { s: 100.0, records: far });
        let crossfall_left = cubics(rows, &[(0.0, [0.02, 1e-4, 0.0, 0.0])]);
        rows.surfaces.push(SurfaceRow {
            shapes: Range { first: 0, count: 2 },
            crossfall_left,
            crossfall_right: crossfall_left,
            ..surface()
        });
        let lane = LANES[1];
        rows.lane_heights.push(LaneHeightRow { s: 0.0, inner: 0.1, outer: 0.3, lane, reserved: 0 });
    };
    let hilly = |x: f64, y: f64| 12.0 + (x / 9.0).sin() + 0.01 * x * y;
    let inside = RoadText { junction: "7", ..curved };
    for snapshot in [
        open(&curved, profiles),
        open(&inside, |rows| {
            profiles(rows);
            add_grid(rows, hilly, 30.0)
        }),
    ] {
        let road = snapshot.map().road_by_id("1").expect("the road");
        for s in [4.0, 13.0, 28.0, 55.5, 91.0] {
            for t in [-7.0, -4.0, -2.0, 1.0, 3.0, 6.0] {
                let at = |s: f64, t: f64| road.surface_at(s, t).expect("a surface").position;
                let normal = road.surface_at(s, t).expect("a surface").normal;
                let along = (at(s + STEP, t) - at(s - STEP, t)) / (2.0 * STEP);
                let across = (at(s, t + STEP) - at(s, t - STEP)) / (2.0 * STEP);
                for direction in [along, across] {
                    let off = normal.dot(direction).abs();
                    assert!(off < DIFFERENCE, "s = {s}, t = {t}: {off}");
                }
                assert!(normal.z > 0.0 && (normal.length() - 1.0).abs() < ROUNDING);
            }
        }
    }
}
