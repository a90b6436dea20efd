//! Latitudes and longitudes: against figures of PROJ, there and back, and on maps.

use glam::DVec3;
use mapd_client::Snapshot;
use mapd_geodesy::{
    DefinitionWarning, Form, Geodetic, Offset, ProjectionError, Projector, Reference,
    ReferenceError, UtmZone,
};
use mapd_tests::{corpus, say, workspace};
use std::collections::HashMap;
use std::f64::consts::FRAC_PI_2;
use std::path::PathBuf;

/// Largest distance from PROJ's figures `[m]`, which are stored to a tenth of a millimetre.
const FROM_PROJ: f64 = 1e-3;
/// Largest distance of a point that went to Earth and back `[m]`.
const ROUND_TRIP: f64 = 1e-6;
/// Largest difference of a grid's convergence from PROJ's `[deg]`.
const CONVERGENCE: f64 = 1e-6;
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

/// Places in zones of UTM, on their edges and beyond: all in the zone of the map, with the convergence of its grid.
#[test]
fn fixes_beyond_a_zone_are_in_the_zone_of_the_map() {
    let mut points: HashMap<String, Vec<DVec3>> = HashMap::new();
    let mut norths: HashMap<String, Vec<f64>> = HashMap::new();
    for record in data("convergences.csv").records() {
        let record = record.expect("a record");
        let [latitude, longitude, x, y, convergence] = [1, 2, 3, 4, 5].map(|i| number(&record[i]));
        let projector = projector(&record[0], Offset::default());
        let place = Geodetic { latitude, longitude, altitude: 7.0 };
        let point = projector.from_geodetic(place).expect("a point");
        let what = format!("{} at {latitude} {longitude}", &record[0]);
        assert!(point.distance(DVec3::new(x, y, 7.0)) <= FROM_PROJ, "{what}: {point}");
        let back = projector.to_geodetic(point).expect("a place");
        let around = (back.longitude - longitude).rem_euclid(360.0);
        let off = (back.latitude - latitude).abs() + around.min(360.0 - around);
        assert!(off * DEGREE <= ROUND_TRIP, "{what}: {back:?}");
        let north = projector.north_at(point).expect("a direction");
        let turned = (north - FRAC_PI_2).to_degrees();
        assert!(
            (turned - convergence).abs() <= CONVERGENCE,
            "{what}: {turned}, PROJ {convergence}"
        );
        points.entry(record[0].to_owned()).or_default().push(point);
        norths.entry(record[0].to_owned()).or_default().push(north);
    }
    for (definition, points) in &mut points {
        let projector = projector(definition, Offset::default());
        points.push(DVec3::NAN);
        let mut all = Vec::new();
        projector.north_at_batch(points, &mut all);
        let (last, before) = all.split_last().expect("answers");
        assert_eq!(*last, Err(ProjectionError::NotFinite));
        assert_eq!(
            before.iter().copied().collect::<Result<Vec<_>, _>>(),
            Ok(norths[definition].clone())
        );
    }
    assert_eq!(points.len(), 4);
}

/// The header's offset turns the map, and north with it.
#[test]
fn north_turns_with_the_map() {
    let heading = 0.3;
    let turned = Offset { shift: DVec3::new(690_000.0, 5_330_000.0, 0.0), heading };
    let plain = Offset { heading: 0.0, ..turned };
    let north = |offset| {
        let projector = projector("+proj=utm +zone=32 +datum=WGS84", offset);
        projector.north_at(DVec3::ZERO).expect("a direction")
    };
    assert!((north(plain) - north(turned) - heading).abs() < 1e-9);
}

#[test]
fn east_north_and_up_are_those_of_proj() {
    let mut count = 0;
    for record in data("enu.csv").records() {
        let record = record.expect("a record");
        let at = |i: usize| Geodetic {
            latitude: number(&record[i]),
            longitude: number(&record[i + 1]),
            altitude: number(&record[i + 2]),
        };
        // The map's own frame is turned and shifted: east is east all the same.
        let offset = Offset { shift: DVec3::new(100.0, -50.0, 20.0), heading: 0.4 };
        let projector = projector(&record[0], offset);
        let point = |place: Geodetic| projector.from_geodetic(place).expect("a point");
        let frame = projector.enu_at(point(at(1))).expect("a frame");
        let expected = DVec3::from_array([7, 8, 9].map(|i| number(&record[i])));
        let found = frame.to_enu(point(at(4))).expect("a place");
        assert!(found.distance(expected) <= FROM_PROJ, "{record:?}: {found}");
        let back = frame.from_enu(found).expect("a point");
        assert!(back.distance(point(at(4))) <= ROUND_TRIP, "{record:?}: {back}");
        let (mut there, mut again) = (Vec::new(), Vec::new());
        frame.to_enu_batch(&[point(at(4)), DVec3::NAN], &mut there);
        frame.from_enu_batch(&[found, DVec3::INFINITY], &mut again);
        assert_eq!(there, [Ok(found), Err(ProjectionError::NotFinite)]);
        assert_eq!(again, [Ok(back), Err(ProjectionError::NotFinite)]);
        count += 1;
    }
    assert_eq!(count, 28);
}

#[test]
fn zones_of_utm_have_edges() {
    let check = |latitude: f64, longitude: f64, expected: Option<&str>| {
        let zone = UtmZone::of(latitude, longitude).map(|zone| zone.to_string());
        assert_eq!(zone.as_deref(), expected, "{latitude} {longitude}");
    };
    check(48.0, 11.999_999, Some("32N"));
    check(48.0, 12.0, Some("33N"));
    check(48.0, 6.0, Some("32N"));
    check(48.0, 5.999_999, Some("31N"));
    check(0.0, 0.0, Some("31N"));
    check(-1e-9, -1e-9, Some("30S"));
    check(10.0, 180.0, Some("1N"));
    check(10.0, 179.999, Some("60N"));
    check(10.0, -180.0, Some("1N"));
    check(10.0, 371.0, Some("32N"));
    // Regular there, too: no exception for Norway or Svalbard.
    check(60.0, 4.0, Some("31N"));
    check(78.0, 8.0, Some("32N"));
    for (latitude, zone) in [(84.0, Some("32N")), (84.1, None), (-80.0, Some("32S")), (-80.1, None)]
    {
        check(latitude, 9.0, zone);
    }
    check(f64::NAN, 9.0, None);
    check(9.0, f64::INFINITY, None);
    assert_eq!(
        UtmZone { number: 56, is_north: false }.definition(),
        "+proj=utm +zone=56 +south +datum=WGS84"
    );
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

/// What is expected of a georeference: its form, and the definition or the error.
type Expected<'a> = (Form, Result<&'a str, ReferenceError>, &'a [DefinitionWarning]);

fn check(text: &str, (form, definition, warnings): Expected<'_>) {
    let read = Reference::read(text).expect(text);
    assert_eq!(read.form, form, "{text}");
    assert_eq!(read.definition.as_deref(), definition.as_ref().copied(), "{text}");
    assert_eq!(read.warnings, warnings, "{text}");
}

#[test]
fn georeferences_are_understood_or_refused() {
    let utm = "+proj=utm +zone=32 +datum=WGS84";
    let bessel = "+proj=tmerc +lon_0=9 +ellps=bessel";
    let value = |name: &str, value: &str| {
        Err(ReferenceError::Value { name: name.into(), value: value.into() })
    };
    for text in ["", "  \n\t ", "\"\""] {
        assert_eq!(Reference::read(text), None, "{text:?}");
    }
    check(
        "+proj=utm +zone=32 +datum=WGS84 +units=m +vunits=m +no_defs +type=crs",
        (Form::Proj, Ok(utm), &[]),
    );
    check("\n proj=utm zone=32  datum=WGS84\n", (Form::Proj, Ok(utm), &[]));
    check("+proj=utm +zone=32", (Form::Proj, Ok(utm), &[]));
    check("+zone=32 +proj=utm +zone=33 +datum=WGS84", (Form::Proj, Ok(utm), &[]));
    check("epsg:32632", (Form::Epsg, Ok(utm), &[]));
    check(
        "EPSG:32632+5773",
        (Form::Epsg, Ok(utm), &[DefinitionWarning::Height("EPSG:5773".into())]),
    );
    check("32632", (Form::Epsg, Ok(utm), &[]));
    check("http://www.opengis.net/def/crs/EPSG/0/32632", (Form::Epsg, Ok(utm), &[]));
    check(
        "+lat_0=49 +lon_0=8",
        (
            Form::Parameters,
            Ok("+proj=tmerc +lat_0=49 +lon_0=8 +datum=WGS84"),
            &[DefinitionWarning::Assumed],
        ),
    );
    check(
        "+proj=utm +zone=32 +datum=WGS84 +geoidgrids=egm96_15.gtx",
        (Form::Proj, Ok(utm), &[DefinitionWarning::Height("egm96_15.gtx".into())]),
    );
    check(
        "+proj=utm +zone=32 +datum=WGS84 +units=us-ft",
        (Form::Proj, Ok(utm), &[DefinitionWarning::Unit("us-ft".into())]),
    );
    check(
        "+proj=utm +zone=32 +datum=WGS84 +vunits=ft",
        (Form::Proj, Ok(utm), &[DefinitionWarning::HeightUnit("ft".into())]),
    );
    check(
        "+proj=utm +zone=32 +datum=WGS84 +axis=neu",
        (Form::Proj, Ok(utm), &[DefinitionWarning::Axes("neu".into())]),
    );
    check(
        "+proj=utm +zone=32 +datum=WGS84 +odd=1 +odder",
        (Form::Proj, Ok(utm), &[DefinitionWarning::Ignored("odd odder".into())]),
    );
    check(
        "+proj=tmerc +lon_0=9 +ellps=bessel",
        (Form::Proj, Ok(bessel), &[DefinitionWarning::Datum]),
    );
    check("+proj=tmerc +lon_0=9 +ellps=bessel +nadgrids=@null", (Form::Proj, Ok(bessel), &[]));
    let (shifted, turned) = (
        "+proj=utm +zone=32 +datum=WGS84 +towgs84=1,2,3",
        "+proj=utm +zone=32 +datum=WGS84 +ellps=bessel",
    );
    for mixed in [shifted, turned, "+proj=utm +zone=32 +datum=potsdam +ellps=GRS80"] {
        check(mixed, (Form::Proj, Ok(mixed), &[DefinitionWarning::Mixed]));
    }
    let same = "+proj=utm +zone=32 +datum=WGS84 +ellps=GRS80 +towgs84=0,0,0";
    check(same, (Form::Proj, Ok(same), &[]));
    // What cannot be used.
    check("here", (Form::Other, Err(ReferenceError::Unrecognized), &[]));
    check("+zone=32 +datum=WGS84", (Form::Other, Err(ReferenceError::Unrecognized), &[]));
    check("+proj=longlat +datum=WGS84", (Form::Proj, Err(ReferenceError::Geographic), &[]));
    check("EPSG:4326", (Form::Epsg, Err(ReferenceError::Geographic), &[]));
    check("EPSG:1", (Form::Epsg, Err(ReferenceError::Code("1".into())), &[]));
    check(
        "EPSG:99999999999999999999",
        (Form::Epsg, Err(ReferenceError::Code("99999999999999999999".into())), &[]),
    );
    check(
        "+proj=utm +zone=32 +nadgrids=BETA2007.gsb",
        (Form::Proj, Err(ReferenceError::Grid("BETA2007.gsb".into())), &[]),
    );
    check(
        "+proj=utm +zone=15 +datum=NAD27",
        (Form::Proj, Err(ReferenceError::Grid("NAD27".into())), &[]),
    );
    check("+proj=utm +zone=x", (Form::Proj, value("zone", "x"), &[]));
    check("+proj=tmerc +lat_0=0 +lon_0=9 +x_0=inf", (Form::Proj, value("x_0", "inf"), &[]));
    check(&"[".repeat(100), (Form::Other, Err(ReferenceError::TooLarge), &[]));
    check(
        &format!("PROJCS{}", "[".repeat(100_000)),
        (Form::Other, Err(ReferenceError::TooLarge), &[]),
    );
    let odd = [
        "+proj=odd +lat_0=1 +lon_0=2",
        "+proj=utm +zone=77",
        "PROJCS[\"a\"]",
        "PROJCRS[\"a\",FOO[1]]",
        "LOCAL_CS[\"a\"]",
        "+proj=tmerc +lat_0=x +lon_0=1",
        "+proj=lcc +lat_1=30 +lat_2=-30",
    ];
    for text in odd {
        assert!(Reference::read(text).expect(text).definition.is_err(), "{text}");
    }
}

/// Any text at all is read, and whatever is understood projects without a panic.
#[test]
fn damaged_georeferences_never_panic() {
    let mut texts: Vec<String> = Vec::new();
    for record in data("projection_sets.csv").records() {
        texts.push(record.expect("a record")[1].to_owned());
    }
    let pieces = [
        "=",
        "+",
        " ",
        "[",
        "]",
        "\"",
        ",",
        "-",
        "9e99",
        "é",
        "\u{0}",
        "+R=0",
        "+a=0",
        "+es=2",
        "+k=0",
        "+lat_0=90",
        "+lat_ts=100",
        "+towgs84=1,x",
    ];
    let mut state = 1u64;
    let mut next = |below: usize| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    let mut usable = 0;
    for round in 0..20_000 {
        let mut text: Vec<char> = texts[round % texts.len()].chars().collect();
        for _ in 0..=next(3) {
            let at = next(text.len() + 1);
            let until = (at + next(8)).min(text.len());
            let piece =
                pieces[next(pieces.len())].chars().filter(|_| next(4) > 0).collect::<Vec<_>>();
            text.splice(at..until, piece);
        }
        let text: String = text.into_iter().collect();
        // As from a damaged archive: no text at all is trusted.
        let raw = Projector::new(&text, Offset::default());
        let Some(Ok(definition)) = Reference::read(&text).map(|read| read.definition) else {
            continue;
        };
        usable += 1;
        let projector = Projector::new(&definition, Offset::default()).expect("was tried");
        for projector in raw.iter().chain([&projector]) {
            for point in [DVec3::ZERO, DVec3::new(5e5, 5e6, 1.0), DVec3::splat(1e300), DVec3::NAN] {
                if let Ok(place) = projector.to_geodetic(point) {
                    assert!(place.latitude.abs() <= 90.0 && place.longitude.is_finite());
                    let _ = projector.from_geodetic(place);
                }
            }
        }
    }
    assert!(usable > 1000, "{usable} of the damaged texts can still be used");
}

#[test]
fn offsets_turn_then_shift_and_come_back() {
    let offset =
        Offset { shift: DVec3::new(1000.0, -2000.0, 5.0), heading: std::f64::consts::FRAC_PI_2 };
    let p = DVec3::new(10.0, 1.0, 2.0);
    assert!(offset.apply(p).distance(DVec3::new(999.0, -1990.0, 7.0)) < 1e-12);
    assert!(offset.invert(offset.apply(p)).distance(p) < 1e-12);
    assert!(offset.negated().apply(p).distance(DVec3::new(-1001.0, 2010.0, -3.0)) < 1e-12);
    let utm = "+proj=utm +zone=32 +datum=WGS84";
    let (bare, shifted) = (projector(utm, Offset::default()), projector(utm, offset));
    let there = bare.to_geodetic(offset.apply(DVec3::new(4e5, 5e5, 2.0))).expect("a place");
    assert_eq!(shifted.to_geodetic(DVec3::new(4e5, 5e5, 2.0)), Ok(there));
    assert!(
        shifted.from_geodetic(there).expect("a point").distance(DVec3::new(4e5, 5e5, 2.0)) < 1e-6
    );
}

/// Definitions with the point at 46.2° N, 10.5° E on WGS 84, by PROJ 9.5.1 (from EPSG:4979, through pyproj 3.7.2).
const FIGURES: [(&str, [f64; 2]); 25] = [
    // On a sphere only; of whatever ellipsoid the datum is.
    ("+proj=eqc +datum=WGS84", [1_168_854.653_329, 5_142_960.474_649]),
    ("+proj=eqc +lat_ts=46 +lon_0=10 +datum=WGS84", [38_664.508_037, 5_142_960.474_649]),
    ("+proj=eqc +ellps=bessel +towgs84=598.1,73.7,418.2", [1_168_771.755_515, 5_142_442.273_369]),
    ("+proj=eqc +R_A +ellps=WGS84", [1_167_548.045_770, 5_137_211.401_388]),
    ("+proj=moll +datum=WGS84", [836_763.377_456, 5_469_916.382_662]),
    ("+proj=moll +R=6371000", [835_827.056_987, 5_463_795.662_266]),
    ("+proj=mill +datum=WGS84", [1_167_548.045_770, 5_535_720.914_073]),
    ("+proj=robin +datum=WGS84", [882_597.807_170, 4_931_058.920_493]),
    ("+proj=mill +ellps=bessel +towgs84=598.1,73.7,418.2", [1_167_469.152_872, 5_535_195.300_718]),
    ("+proj=mill +R=6371000", [1_167_546.729_768, 5_535_714.674_484]),
    ("+proj=moll +ellps=bessel +towgs84=598.1,73.7,418.2", [836_697.290_420, 5_469_357.656_494]),
    ("+proj=merc +a=6378137 +b=6378137", [1_168_854.653_329, 5_812_457.491_342]),
    // On one ellipsoid only.
    ("+proj=krovak +datum=WGS84", [-1_100_968.419_672, -1_422_553.598_050]),
    ("+proj=krovak +ellps=bessel +towgs84=589,76,480", [-1_100_930.803_571, -1_422_530.827_853]),
    // On any.
    ("+proj=eqearth +datum=WGS84", [855_402.538_124, 5_594_033.717_714]),
    ("+proj=sinu +datum=WGS84", [810_429.131_072, 5_118_316.580_847]),
    ("+proj=cea +datum=WGS84", [1_168_854.653_329, 4_583_332.625_599]),
    ("+proj=poly +lon_0=10 +datum=WGS84", [38_591.608_218, 5_118_438.116_763]),
    ("+proj=cass +lon_0=10 +datum=WGS84", [38_591.608_214, 5_118_438.118_617]),
    ("+proj=eqdc +lat_1=40 +lat_2=50 +lon_0=10 +datum=WGS84", [38_451.688_153, 5_118_435.070_078]),
    ("+proj=aea +lat_1=40 +lat_2=50 +lon_0=10 +datum=WGS84", [38_450.966_488, 4_796_045.756_197]),
    ("+proj=gnom +lat_0=46 +lon_0=10 +datum=WGS84", [38_592.315_984, 22_352.283_654]),
    ("+proj=laea +lat_0=46 +lon_0=10 +datum=WGS84", [38_591.760_400, 22_351.438_307]),
    ("+proj=omerc +lat_0=46 +lonc=10 +alpha=30 +datum=WGS84", [38_591.686_685, 22_352.100_690]),
    ("+proj=sterea +lat_0=46 +lon_0=10 +datum=WGS84", [38_591.844_384, 22_352.010_511]),
];

/// The sphere that a projection computes on was taken for the datum's ellipsoid, and shifted to WGS 84: 16 to 21 km off, and
/// 11 km too high.
#[test]
fn projections_of_a_sphere_keep_the_datum_of_the_ellipsoid() {
    let place = Geodetic { latitude: 46.2, longitude: 10.5, altitude: 0.0 };
    for (text, expected) in FIGURES {
        let projector = projector(text, Offset::default());
        let point = projector.from_geodetic(place).expect(text);
        let off = point.truncate().distance(expected.into());
        assert!(off <= FROM_PROJ, "{text}: {off} m from PROJ");
        let again = projector.to_geodetic(point).expect(text);
        let back = (again.latitude - 46.2).hypot(again.longitude - 10.5) * DEGREE;
        assert!(back <= ROUND_TRIP && again.altitude.abs() <= ROUND_TRIP, "{text}: {again:?}");
    }
}

/// Values that PROJ refuses: places were wrong, or nowhere, and nothing was said.
#[test]
fn values_that_proj_refuses_are_refused() {
    let refused = [
        "+proj=utm +datum=WGS84",
        "+proj=utm +lon_0=9 +datum=WGS84",
        "+proj=utm +zone=0 +datum=WGS84",
        "+proj=utm +zone=61 +datum=WGS84",
        "+proj=utm +zone=-32 +datum=WGS84",
        "+proj=utm +zone=32.7 +datum=WGS84",
        "+proj=tmerc +lat_0=490 +lon_0=8 +datum=WGS84",
        "+proj=tmerc +lat_0=-90.001 +lon_0=8 +datum=WGS84",
        "+proj=tmerc +lat_0=90d30'N +lon_0=8 +datum=WGS84",
        "+proj=tmerc +lat_0=1.6r +lon_0=8 +datum=WGS84",
        "+proj=tmerc +lat_0=nan +lon_0=8 +datum=WGS84",
        "+proj=lcc +lat_1=100 +lat_2=40 +lon_0=8",
        "+proj=merc +lat_ts=100",
        "+proj=tmerc +lon_0=8 +k=0",
        "+proj=tmerc +lon_0=8 +k_0=-1",
        "+proj=tmerc +lon_0=8 +ellps=bessel +towgs84=nan,0,0",
        "+proj=tmerc +lon_0=8 +ellps=bessel +towgs84=1e300,0,0",
        "+proj=tmerc +lon_0=8 +ellps=bessel +towgs84=inf,0,0",
        "+proj=tmerc +lon_0=8 +ellps=bessel +towgs84=1,2",
    ];
    for text in refused {
        let read = Reference::read(text).expect(text).definition;
        assert!(read.is_err(), "{text}: {read:?}");
        assert!(Projector::new(text, Offset::default()).is_err(), "{text}");
    }
    // What looks odd and is none of it, with the latitude of the plane's origin.
    let sound = [
        ("+proj=tmerc +lat_0=90 +lon_0=8 +datum=WGS84", 90.0),
        ("+proj=tmerc +lat_0=49d30'36\"N +lon_0=8 +datum=WGS84", 49.51),
        ("+proj=tmerc +lat_0=30'S +lon_0=8 +datum=WGS84", -0.5),
        ("+proj=tmerc +lat_0=0.5r +lon_0=8 +datum=WGS84", 28.647_889_756_541_16),
        ("+proj=tmerc +lat_0=49 +lon_0=8000 +datum=WGS84", 49.0),
    ];
    for (text, latitude) in sound {
        let origin = projector(text, Offset::default()).to_geodetic(DVec3::ZERO).expect(text);
        assert!((origin.latitude - latitude).abs() < 1e-9, "{text}: {origin:?}");
    }
    // Heights that count downwards are no more understood than axes that point west.
    let down = Reference::read("+proj=utm +zone=32 +datum=WGS84 +axis=end").expect("a reference");
    assert_eq!(down.warnings, [DefinitionWarning::Axes("end".into())]);
}

#[test]
fn places_that_are_none_have_errors_of_their_own() {
    use mapd_geodesy::{DefinitionError, ProjectionError};
    let projector = projector("+proj=utm +zone=32 +datum=WGS84", Offset::default());
    let place = |latitude, longitude| Geodetic { latitude, longitude, altitude: 0.0 };
    assert_eq!(projector.from_geodetic(place(f64::NAN, 9.0)), Err(ProjectionError::NotFinite));
    assert_eq!(projector.from_geodetic(place(91.0, 9.0)), Err(ProjectionError::OutOfRange));
    assert_eq!(projector.from_geodetic(place(0.0, 99.0)), Err(ProjectionError::Outside));
    assert_eq!(projector.to_geodetic(DVec3::INFINITY), Err(ProjectionError::NotFinite));
    assert_eq!(Projector::new("", Offset::default()).err(), Some(DefinitionError::None));
    let grid = Projector::new("+proj=utm +zone=32 +nadgrids=/etc/passwd", Offset::default());
    assert!(matches!(grid, Err(DefinitionError::Unusable { .. })));
}

/// True north in UTM leaves grid north by γ = atan(tan(λ − λ₀) sin φ), on the sphere exactly, on the ellipsoid within 1e-5 for
/// places of a zone; and the header's turn goes with it.
#[test]
fn true_north_is_told_from_grid_north() {
    let check = |latitude: f64, longitude: f64, turn: f64| {
        let offset = Offset { heading: turn, ..Offset::default() };
        let projector =
            Projector::new("+proj=utm +zone=32 +datum=WGS84", offset).expect("a projector");
        let place = Geodetic { latitude, longitude, altitude: 0.0 };
        let point = projector.from_geodetic(place).expect("a point");
        let north = projector.north_at(point).expect("an answer");
        let (away, up) = ((longitude - 9.0).to_radians(), latitude.to_radians());
        let convergence = (away.tan() * up.sin()).atan();
        // Eastwards of the middle meridian the grid's north lies clockwise from the true one.
        let expected = std::f64::consts::FRAC_PI_2 + convergence - turn;
        assert!(
            (north - expected).abs() < 1e-5,
            "{latitude}, {longitude}: {north}, not {expected}"
        );
    };
    for (latitude, longitude) in
        [(48.0, 9.0), (48.0, 11.5), (60.0, 7.0), (0.0, 10.0), (-33.0, 11.0)]
    {
        check(latitude, longitude, 0.0);
        check(latitude, longitude, 0.4);
    }
}
