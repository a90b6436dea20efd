//! Triangles of an outline, by cutting off its ears.

use mapd_query::glam::{DVec2, DVec3};

/// Corners of an outline up to which ears are cut; of a larger one, whose cost rises with the square, a fan is taken.
const MOST_CORNERS: usize = 2000;

/// Triangles that cover an outline in plan view, as numbers of its corners; none for less than three corners.
pub(crate) fn of(outline: &[DVec3]) -> Vec<[u32; 3]> {
    let places: Vec<DVec2> = outline.iter().map(|corner| corner.truncate()).collect();
    let mut left: Vec<u32> = (0..places.len() as u32).collect();
    if is_clockwise(&places) {
        left.reverse();
    }
    let mut triangles = Vec::with_capacity(left.len().saturating_sub(2));
    while left.len() > 3 && left.len() <= MOST_CORNERS {
        let count = left.len();
        let around = |i: usize| [left[(i + count - 1) % count], left[i], left[(i + 1) % count]];
        // An outline that crosses itself may have no ear.
        let Some(ear) = (0..count).find(|i| is_ear(around(*i), &left, &places)) else { break };
        triangles.push(around(ear));
        left.remove(ear);
    }
    triangles.extend(left.windows(2).skip(1).map(|pair| [left[0], pair[0], pair[1]]));
    triangles
}

fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

fn is_clockwise(places: &[DVec2]) -> bool {
    let next = places.iter().cycle().skip(1);
    let first = places.first().copied().unwrap_or_default();
    places.iter().zip(next).map(|(a, b)| (*a - first).perp_dot(*b - first)).sum::<f64>() < 0.0
}

/// Whether a corner can be cut off: it bends to the left, and no other corner lies in its triangle.
fn is_ear(corners: [u32; 3], left: &[u32], places: &[DVec2]) -> bool {
    let [a, b, c] = corners.map(|corner| places[corner as usize]);
    let bend = turn(a, b, c);
    let inside = |p: DVec2| turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
    let others =
        left.iter().filter(|corner| !corners.contains(corner)).map(|at| places[*at as usize]);
    // A straight corner is cut off without loss.
    bend == 0.0 || (bend > 0.0 && !others.into_iter().any(|p| p != a && p != c && inside(p)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(outline: &[(f64, f64)], expected: f64) {
        let outline: Vec<DVec3> = outline.iter().map(|(x, y)| DVec3::new(*x, *y, 0.0)).collect();
        for turned in [false, true] {
            let mut outline = outline.clone();
            if turned {
                outline.reverse();
            }
            let at = |i: u32| outline[i as usize].truncate();
            let area = |[a, b, c]: [u32; 3]| 0.5 * turn(at(a), at(b), at(c)).abs();
            let sum: f64 = of(&outline).into_iter().map(area).sum();
            assert!((sum - expected).abs() < 1e-12, "{outline:?}: {sum}");
        }
    }

    #[test]
    fn triangles_cover_the_outline_and_no_more() {
        check(&[], 0.0);
        check(&[(0.0, 0.0), (1.0, 0.0)], 0.0);
        check(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)], 2.0);
        // L, comb, straight corners.
        check(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)], 3.0);
        check(
            &[
                (0.0, 0.0),
                (5.0, 0.0),
                (5.0, 3.0),
                (4.0, 1.0),
                (3.0, 3.0),
                (2.0, 1.0),
                (1.0, 3.0),
                (0.0, 3.0),
            ],
            11.0,
        );
        check(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 2.0), (1.0, 2.0), (0.0, 2.0)], 4.0);
    }
}
