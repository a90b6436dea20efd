//! Positions and lanes against an independent evaluator, over every map of the shared corpus.

use glam::{DVec2, DVec3};
use mapd_archive::encode;
use mapd_client::{Map, Snapshot, Track};
use mapd_compiler::CompileOptions;
use std::path::Path;

/// Lines, arcs and spirals `[m]`.
const EXACT: f64 = 1e-9;
/// Absolute coordinates carry some units in the last place more `[relative]`.
const ULPS: f64 = 8.0 * f64::EPSILON;
/// Roads with parametric curves `[m]`.
const PARAMETRIC: f64 = 1e-6;
/// Widths and edges `[m]`.
const WIDTH: f64 = 1e-9;
/// Headings `[rad]`.
const HEADING: f64 = 1e-8;

fn open(path: &Path) -> Option<Snapshot> {
    let file = std::fs::File::open(path).expect("the map can be read");
    let compiled = mapd_compiler::compile(file, &CompileOptions::default(), &mut |_| {})
        .expect("reading works");
    let rows = compiled.rows?;
    Some(
        Snapshot::from_bytes(encode(&rows, &compiled.provenance).expect("encodes")).expect("opens"),
    )
}

/// Whether a road has curves whose parameter is not arc length.
fn tolerance(map: Map<'_>, road: &mapd_client::Road<'_>, size: f64) -> f64 {
    let row = &map.tables().roads[road.road_id().row() as usize];
    let parametric = row.geometries().of(map.tables().geometries).iter().any(|g| g.kind() >= 3);
    (if parametric { PARAMETRIC } else { EXACT }) + size * ULPS
}

/// Rows of a reference file as numbers; the first column is a road's id.
fn rows(path: &Path) -> Vec<(String, Vec<f64>)> {
    let Ok(mut reader) = csv::Reader::from_path(path) else { return Vec::new() };
    let row = |record: csv::StringRecord| {
        let numbers = record.iter().skip(1).map(|field| field.parse().expect("a number")).collect();
        (record[0].to_owned(), numbers)
    };
    reader.records().map(|record| row(record.expect("a record"))).collect()
}

/// Compares one map; returns how many rows were compared.
fn check(map: Map<'_>, name: &str, folder: &Path) -> usize {
    let key = name.replace('/', "__");
    let points = rows(&folder.join(format!("{key}.points.csv")));
    for (id, n) in &points {
        let road = map.road_by_id(id).unwrap_or_else(|| panic!("{name} has no road {id:?}"));
        let pose = road.to_inertial(Track { s: n[0], t: n[1], h: 0.0 }).expect("a pose");
        let expected = DVec3::new(n[2], n[3], n[4]);
        let error = pose.position.distance(expected);
        let allowed = tolerance(map, &road, expected.length());
        assert!(error <= allowed, "{name}: road {id:?} at {n:?}: off by {error:e} m: {pose:?}");
        let turn = angle_between(pose.heading, n[5]);
        assert!(turn <= HEADING, "{name}: road {id:?} at {n:?}: heading off by {turn:e}");
    }
    let lanes = rows(&folder.join(format!("{key}.lanes.csv")));
    for (id, n) in &lanes {
        let road = map.road_by_id(id).unwrap_or_else(|| panic!("{name} has no road {id:?}"));
        let lane = road.section_at(n[0]).and_then(|section| section.lane(n[1] as i32));
        let lane = lane.unwrap_or_else(|| panic!("{name}: road {id:?} at {n:?}: no such lane"));
        let edges = lane.edges_at(n[0]);
        for (what, found, expected) in [
            ("width", edges.width(), n[2]),
            ("inner", edges.inner, n[3]),
            ("outer", edges.outer, n[4]),
        ] {
            assert!((found - expected).abs() <= WIDTH, "{name}: {id:?} {n:?}: {what} is {found}");
        }
        let pose = lane.pose_at(n[0], 0.0).expect("a pose");
        let error = pose.position.truncate().distance(DVec2::new(n[5], n[6]));
        let allowed = tolerance(map, &road, DVec2::new(n[5], n[6]).length());
        assert!(error <= allowed, "{name}: road {id:?} lane at {n:?}: off by {error:e} m");
    }
    points.len() + lanes.len()
}

fn angle_between(a: f64, b: f64) -> f64 {
    let difference = a - b;
    difference.sin().atan2(difference.cos()).abs()
}

#[test]
fn every_compiled_map_agrees_with_the_independent_evaluator() {
    let (Some(corpus), Some(folder)) = (mapd_tests::corpus(), mapd_tests::shared("reference"))
    else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    let mut compared = 0;
    for (name, path) in corpus {
        if let Some(snapshot) = open(&path) {
            compared += check(snapshot.map(), &name, &folder);
        }
    }
    assert!(compared > 10_000, "only {compared} rows were compared");
    mapd_tests::say(&format!("{compared} rows agree"));
}
