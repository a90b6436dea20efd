//! Feet on a path without a hint: the nearest place of all.

use crate::paths::each_path;
use mapd_client::QueryError;
use mapd_client::batch::Places;
use mapd_client::glam::DVec2;
use mapd_query::path::{Path, PathBuffer, PathOptions, PathPositions, steps_of_lanes};
use mapd_tests::maps::{Random, open_text};

/// Points around each path.
const POINTS: usize = 12;
/// Distance of the places that the foot is compared with `[m]`.
const STEP: f64 = 0.5;
/// The same around a tight turn `[m]`.
const FINE: f64 = 1e-3;

/// Some points around a path, and beyond it.
fn points(path: &Path<'_, '_>, random: &mut Random) -> Vec<DVec2> {
    let around = |random: &mut mapd_tests::maps::Random, reach: f64| {
        let along = random.between(0.0, path.length());
        let at = path.at(along).expect("a place").position.truncate();
        at + DVec2::new(random.between(-reach, reach), random.between(-reach, reach))
    };
    (0..POINTS).map(|i| around(random, if i % 2 == 0 { 5.0 } else { 300.0 })).collect()
}

#[test]
fn no_place_of_the_path_is_nearer_than_the_foot() {
    each_path(|_, path, _, name, random| {
        let (mut places, mut stations) = (Vec::new(), Vec::new());
        let mut along = 0.0;
        while along < path.length() {
            stations.push(along);
            along += STEP;
        }
        path.at_batch(&stations, &mut places).expect("places");
        let points = points(path, random);
        for point in &points {
            let foot = path.project(*point, None).expect("a foot");
            let away = places.iter().map(|own| own.position.truncate().distance(*point));
            let least = away.fold(f64::INFINITY, f64::min);
            assert!(foot.distance <= least + 1e-6, "{name}: {foot:?}, {least} of {point}");
            let there = path.at(foot.along).expect("a place").position.truncate();
            // At a joint the foot may lie on the side that `at` does not tell.
            let joint = path.joints().iter().any(|own| (own.along - foot.along).abs() < 1e-6);
            let off = (there.distance(*point) - foot.distance).abs();
            assert!(joint || off < 1e-6, "{name}: {foot:?}, {off}");
        }
    });
}

#[test]
fn a_batch_has_the_answers_of_single_points_bit_for_bit() {
    each_path(|_, path, _, name, random| {
        let mut feet = PathPositions::default();
        let points = points(path, random);
        let (x, y): (Vec<f64>, Vec<f64>) = points.iter().map(|point| (point.x, point.y)).unzip();
        path.project_batch(Places { x: &x, y: &y, ..Places::default() }, &mut feet).expect("feet");
        assert_eq!(feet.len(), points.len(), "{name}");
        for (i, point) in points.iter().enumerate() {
            assert_eq!(path.project(*point, None).ok(), feet.get(i), "{name}");
        }
        let ask = |x: &[f64], y: &[f64], feet: &mut PathPositions| {
            path.project_batch(Places { x, y, ..Places::default() }, feet)
        };
        assert_eq!(ask(&x, &y[1..], &mut feet), Err(QueryError::Length("y")), "{name}");
        let far = [x[0], x[1], f64::NAN];
        assert_eq!(ask(&far, &y[..3], &mut feet), Err(QueryError::NotFiniteAt(2)), "{name}");
        assert!(feet.is_empty() && feet.get(0).is_none(), "{name}");
    });
}

/// A path that comes by one place twice: without a hint the smaller S answers, with one its own.
#[test]
fn of_two_rounds_the_first_answers() {
    each_path(|_, path, _, name, random| {
        for _ in 0..4 {
            let along = random.between(0.0, path.length());
            let at = path.at(along).expect("a place").position.truncate();
            let foot = path.project(at, None).expect("a foot");
            assert!(foot.distance < 1e-6, "{name}: {foot:?}");
            // The same within what a foot is found to.
            assert!(foot.along < along + 1e-6, "{name}: {foot:?} of {along}");
        }
    });
}

/// A road that bends to the right, with a lane on its inside.
fn bend(shape: &str, length: f64, width: [f64; 4]) -> String {
    let [a, b, c, d] = width;
    format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="{length}" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="{length}">{shape}</geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="{a}" b="{b}" c="{c}" d="{d}"/></lane></right></laneSection></lanes></road></OpenDRIVE>"#
    )
}

/// Where the line turns within half a metre, the nearest place of all is found as well: steps led to and fro, and feet were off by millimetres.
#[test]
fn feet_where_the_line_turns_tightly() {
    let (arc, spiral) = (r#"<arc curvature="-0.5"/>"#, r#"<spiral curvStart="6" curvEnd="-6"/>"#);
    for (what, shape, length, width) in [
        ("a lane that widens", arc, 6.0, [3.2, 0.05, 0.0, 0.0]),
        ("a lane that narrows", arc, 6.0, [3.6, -0.1, 0.0, 0.0]),
        ("a lane that does both", arc, 6.0, [3.4, 0.2, -0.1, 0.01]),
        ("a spiral", spiral, 1.0, [0.1, 0.0, 0.0, 0.0]),
    ] {
        let snapshot = open_text(&bend(shape, length, width));
        let map = snapshot.map();
        let lane = map.lanes().find(|lane| lane.number() == -1).expect("a lane").lane_id();
        let (mut steps, mut buffer) = (Vec::new(), PathBuffer::default());
        steps_of_lanes(map, &[lane], [0.0, length], &mut steps).expect("steps");
        let path = map.path(&steps, &PathOptions::default(), &mut buffer).expect("a path");
        let stations: Vec<f64> =
            (0..=(path.length() / FINE) as usize).map(|i| i as f64 * FINE).collect();
        let mut places = Vec::new();
        path.at_batch(&stations, &mut places).expect("places");
        let most = places.iter().map(|at| at.curvature.abs()).fold(0.0, f64::max);
        assert!(most > 2.0, "{what}: {most}");
        let mut random = Random(11);
        for _ in 0..2000 {
            let own = &places[(random.unit() * places.len() as f64) as usize];
            let aside = DVec2::new(random.between(-0.5, 0.5), random.between(-0.5, 0.5));
            let point = own.position.truncate() + aside;
            let foot = path.project(point, None).expect("a foot");
            let away = places.iter().map(|own| own.position.truncate().distance(point));
            let least = away.fold(f64::INFINITY, f64::min);
            assert!(foot.distance <= least + 1e-6, "{what}, {most} /m: {foot:?}, {least}");
        }
    }
}
