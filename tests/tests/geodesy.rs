//! Latitudes and longitudes: against figures of PROJ, there and back, and on maps.

use glam::DVec3;
use mapd_client::Snapshot;
use mapd_geodesy::{Geodetic, Offset, Projector, Reference};
use mapd_tests::{corpus, say, workspace};
use std::collections::HashMap;
use std::path::PathBuf;

/// Largest distance from PROJ's figures `[m]`, which are stored to a tenth of a millimetre.
const FROM_PROJ: f64 = 1e-3;
/// Largest distance of a point that went to Earth and back `[m]`.
const ROUND_TRIP: f64 = 1e-6;
/// Length of a degree of latitude `[m]`, roughly.
const DEGREE: f64 = 111_200.0;
/// As in `tests/differential/projections.py`, so that points need not be stored.
const MODULUS: usize = 10_007;

fn data(name: &str) -> csv::Reader<std::fs::File> {
    let path = workspace().join("tests/data").join(name);
    csv::Reader::from_path(&path).expect(name)
}

fn number(text: &str) -> f64 {
    text.parse().expect(text)
}

/// A projector for a georeference as written.
fn projector(text: &str, offset: Offset) -> Projector {
    let reference = Reference::read(text).expect("a reference");
    let definition = reference.definition.unwrap_or_else(|error| panic!("{text}: {error}"));
    Projector::new(&definition, offset).expect(text)
}

#[test]
fn projections_agree_with_proj_and_come_back() {
    let mut answers: HashMap<String, Vec<[f64; 2]>> = HashMap::new();
    for record in data("projections.csv").records() {
        let record = record.expect("a record");
        let answer = [number(&record[1]), number(&record[2])];
        answers.entry(record[0].to_owned()).or_default().push(answer);
    }
    let mut sets = 0;
    for record in data("projection_sets.csv").records() {
        let record = record.expect("a record");
        let (name, text) = (&record[0], &record[1]);
        let [south, north, west, east] = [3, 4, 5, 6].map(|i| number(&record[i]));
        let count: usize = record[2].parse().expect("a count");
        let projector = projector(text, Offset::default());
        let answers = &answers[name];
        assert_eq!(answers.len(), count, "{name}");
        let (mut worst, mut back) = (0f64, 0f64);
        for (i, [x, y]) in answers.iter().enumerate() {
            let share = |step: usize| (i * step % MODULUS) as f64 / MODULUS as f64;
            let latitude = south + (north - south) * share(7919);
            let longitude = west + (east - west) * share(104_729);
            let place = Geodetic { latitude, longitude, altitude: 0.0 };
            let found = projector.from_geodetic(place).expect(name);
            worst = worst.max(found.truncate().distance([*x, *y].into()));
            let again = projector.to_geodetic(found).expect(name);
            let (dlat, dlon) = (again.latitude - latitude, again.longitude - longitude);
            let degrees = dlat.hypot(dlon * latitude.to_radians().cos());
            back = back.max(degrees * DEGREE).max(again.altitude.abs());
            let point = projector.from_geodetic(again).expect(name);
            back = back.max(point.distance(found));
        }
        say(&format!("{name}: {worst:.1e} m from PROJ, {back:.1e} m there and back"));
        assert!(worst <= FROM_PROJ, "{name}: {worst} m");
        assert!(back <= ROUND_TRIP, "{name}: {back} m");
        sets += 1;
    }
    assert_eq!(sets, answers.len());
}

fn compiled(path: &std::path::Path) -> Snapshot {
    let compiled =
        mapd::source::compile_file(path, &Default::default(), &mut |_| {}).expect("reads");
    let rows = compiled.rows.expect("accepted");
    let bytes = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    mapd_archive::verify(&bytes).expect("sound");
    Snapshot::from_bytes(bytes).expect("opens")
}

#[test]
fn maps_of_the_corpus_lie_where_proj_puts_them() {
    let Some(maps) = corpus() else { return say("skipped: ../shared is not there") };
    let paths: HashMap<String, PathBuf> = maps.into_iter().collect();
    let mut points: Vec<(String, [f64; 4])> = Vec::new();
    for record in data("georeferences.csv").records() {
        let record = record.expect("a record");
        points.push((record[0].to_owned(), [1, 2, 3, 4].map(|i| number(&record[i]))));
    }
    for group in points.chunk_by(|a, b| a.0 == b.0) {
        let name = &group[0].0;
        let snapshot = compiled(&paths[name]);
        let projector = snapshot.map().projector().expect(name);
        let mut worst = 0f64;
        for (_, [x, y, latitude, longitude]) in group {
            let place = Geodetic { latitude: *latitude, longitude: *longitude, altitude: 0.0 };
            let point = projector.from_geodetic(place).expect(name);
            worst = worst.max(point.truncate().distance([*x, *y].into()));
            let point = DVec3::new(*x, *y, 1.5);
            let again = projector.to_geodetic(point).expect(name);
            assert!(projector.from_geodetic(again).expect(name).distance(point) <= ROUND_TRIP);
        }
        say(&format!("{name}: {worst:.1e} m from PROJ"));
        assert!(worst <= FROM_PROJ, "{name}: {worst} m");
    }
}
