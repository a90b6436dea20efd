//! What the page draws and says of places, against an independent evaluator's values for every map of the shared corpus: borders, reference lines, areas of
//! lanes, and road, s, t and z at the pointer.

use mapd_client::glam::DVec2;
use mapd_client::{Map, Track};
use mapd_tests::maps::open_accepted;
use mapd_web::{Drawing, Layer, Question};
use serde_json::Value;
use std::path::Path;
use std::time::UNIX_EPOCH;

/// Largest distance of a drawn border from the exact one `[m]`: the default of `--bound-tolerance`.
const DRAWN: f64 = 0.01;
/// Single precision `[share of the distance from the map's middle]`.
const SINGLE: f64 = 1e-7;
/// s, t and z at the pointer `[m]`: roads with parametric curves are integrated.
const SAID: f64 = 1e-5;
/// Lanes up to this width have no area that a pixel could show `[m]`.
const NARROW: f64 = 0.05;

/// Rows of a file of the evaluator; the first column is a road's id.
fn rows(path: &Path) -> Vec<(String, Vec<f64>)> {
    let Ok(mut reader) = csv::Reader::from_path(path) else { return Vec::new() };
    let row = |record: csv::StringRecord| {
        let numbers = record.iter().skip(1).map(|field| field.parse().expect("a number")).collect();
        (record[0].to_owned(), numbers)
    };
    reader.records().map(|record| row(record.expect("a record"))).collect()
}

/// A drawing with what it is relative to.
struct Drawn {
    drawing: Drawing,
    middle: DVec2,
}

impl Drawn {
    fn near(&self, point: DVec2, reach: f64) -> impl Iterator<Item = &mapd_web::Chunk> {
        let at = point - self.middle;
        self.drawing.chunks.iter().filter(move |chunk| {
            let [a, b, c, d] = chunk.bounds.map(f64::from);
            a - reach <= at.x && at.x <= c + reach && b - reach <= at.y && at.y <= d + reach
        })
    }

    /// Distance of a place from the nearest line `[m]`, if one is near.
    fn distance(&self, point: DVec2) -> f64 {
        let at = point - self.middle;
        let place = |[x, y]: [f32; 2]| DVec2::new(f64::from(x), f64::from(y));
        let of_chunk = |chunk: &mapd_web::Chunk| {
            let [first, count] = chunk.strokes.map(|number| number as usize);
            self.drawing.strokes[first..first + count].iter()
        };
        let distances = self.near(point, 1.0).flat_map(of_chunk).map(|stroke| {
            let (from, to) = (place(stroke.from), place(stroke.to));
            let way = to - from;
            let share = (at - from).dot(way) / way.length_squared().max(f64::MIN_POSITIVE);
            let share = mapd_geometry::clamp(share, 0.0, 1.0);
            at.distance(from + share * way)
        });
        distances.fold(f64::INFINITY, f64::min)
    }

    /// Whether a place lies in an area.
    fn covers(&self, point: DVec2) -> bool {
        let at = point - self.middle;
        let corner = |number: u32| {
            let [x, y] = self.drawing.corners[number as usize].place.map(f64::from);
            DVec2::new(x, y) - at
        };
        let mut triangles = self.near(point, 0.0).flat_map(|chunk| {
            let [first, count] = chunk.triangles.map(|number| number as usize);
            self.drawing.triangles[first..first + count].chunks_exact(3)
        });
        triangles.any(|corners| {
            let [a, b, c] = [0, 1, 2].map(|i| corner(corners[i]));
            let sides = [a.perp_dot(b), b.perp_dot(c), c.perp_dot(a)];
            sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
        })
    }
}

/// Whether a road is flat across at a place, so that what the evaluator says of the lane's middle tells where its edges are; by its points beside each other.
fn is_flat_across(map: Map<'_>, road: &str, s: f64) -> bool {
    let road = map.road_by_id(road).expect("the road");
    let [a, b] =
        [-1.0, 1.0].map(|t| road.to_inertial(Track { s, t, h: 0.0 }).expect("a pose").position);
    (a.z - b.z).abs() < 1e-9
}

/// What is drawn of one map; how many places were compared.
fn check_drawn(
    map: Map<'_>,
    drawn: [&Drawn; 3],
    name: &str,
    lanes: &[(String, Vec<f64>)],
) -> usize {
    let [areas, borders, references] = drawn;
    let mut compared = 0;
    for (road, n) in lanes {
        if map.road_by_id(road).is_none() {
            assert!(map.quarantined().len() > 0, "{name} has no road {road:?}");
            continue;
        }
        let [s, number, width, inner, outer, x, y, heading] = n[..] else { panic!("{n:?}") };
        let middle = DVec2::new(x, y);
        let allowed = DRAWN + SINGLE * middle.distance(areas.middle);
        let at = format!("{name}: road {road:?} lane {number} at s {s}");
        if width > NARROW {
            assert!(areas.covers(middle), "{at}: the lane's middle {middle} is not in its area");
        }
        if !is_flat_across(map, road, s) {
            continue;
        }
        let across = DVec2::from_angle(heading).perp();
        let edge = |t: f64| middle + (t - 0.5 * (inner + outer)) * across;
        let found = borders.distance(edge(outer));
        assert!(found <= allowed, "{at}: its border is drawn {found} m away");
        let of_inner = if number.abs() == 1.0 { references } else { borders };
        let found = of_inner.distance(edge(inner));
        assert!(found <= allowed, "{at}: its inner border is drawn {found} m away");
        compared += 2;
    }
    compared
}

/// What is said at the evaluator's places; how many were compared: of roads above each other the highest is said.
fn check_said(
    view: mapd_client::view::View<'_>,
    name: &str,
    points: &[(String, Vec<f64>)],
) -> usize {
    let mut compared = 0;
    for (road, n) in points {
        let [s, t, x, y, z, _] = n[..] else { panic!("{n:?}") };
        let answer: Value =
            serde_json::from_str(&Question::Place([x, y]).answer(view).json).expect("JSON");
        let lane = &answer["lane"];
        if lane["road"] != road.as_str() || lane["distance"] != 0.0 {
            continue;
        }
        let said = ["s", "t", "z"].map(|which| lane[which].as_f64().expect("a number"));
        // In a bend a place may lie beside more than one s: the nearest is said, which must lead to the same place.
        if said[1].abs() < t.abs() - SAID {
            let track = Track { s: said[0], t: said[1], h: 0.0 };
            let road = view.map().road_by_id(road).expect("the road");
            let there = road.to_inertial(track).expect("a pose").position.truncate();
            assert!(there.distance(DVec2::new(x, y)) <= SAID, "{name}: {there}, not {x}, {y}");
            continue;
        }
        let away = [said[0] - s, said[1] - t, said[2] - z];
        assert!(
            away.iter().all(|away| away.abs() <= SAID),
            "{name}: road {road:?} at {x}, {y}: s, t, z {said:?}, not {:?}",
            [s, t, z]
        );
        compared += 1;
    }
    compared
}

#[test]
fn the_page_draws_and_says_what_an_independent_evaluator_has() {
    let (Some(corpus), Some(folder)) = (mapd_tests::corpus(), mapd_tests::shared("reference"))
    else {
        return mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
    };
    let (mut drawn, mut said) = (0, 0);
    for (name, path) in corpus {
        let key = name.replace('/', "__");
        let lanes = rows(&folder.join(format!("{key}.lanes.csv")));
        let points = rows(&folder.join(format!("{key}.points.csv")));
        let Some(snapshot) =
            Some(&path).filter(|_| !lanes.is_empty()).and_then(|path| open_accepted(path))
        else {
            continue;
        };
        let view = snapshot.view(UNIX_EPOCH);
        let about: Value = serde_json::from_str(&Question::Map.answer(view).json).expect("JSON");
        let [x, y] = [0, 1].map(|i| about["middle"][i].as_f64().expect("a number"));
        let draw = |layer: Layer| Drawn { drawing: layer.draw(view), middle: DVec2::new(x, y) };
        let [areas, borders, references] =
            [Layer::Lanes, Layer::Borders, Layer::ReferenceLines].map(draw);
        drawn += check_drawn(view.map(), [&areas, &borders, &references], &name, &lanes);
        said += check_said(view, &name, &points);
    }
    assert!(drawn > 10_000 && said > 4_000, "only {drawn} places of lines, {said} of the pointer");
    mapd_tests::say(&format!("{drawn} places of lines and {said} of the pointer agree"));
}
