//! Feet on a path without a hint: the nearest place of all.

use crate::paths::each_path;
use mapd_client::QueryError;
use mapd_client::batch::Places;
use mapd_client::glam::DVec2;
use mapd_query::path::{Path, PathPositions};

/// Points around each path.
const POINTS: usize = 12;
/// Distance of the places that the foot is compared with `[m]`.
const STEP: f64 = 0.5;

/// Some points around a path, and beyond it.
fn points(path: &Path<'_, '_>, random: &mut mapd_tests::maps::Random) -> Vec<DVec2> {
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
