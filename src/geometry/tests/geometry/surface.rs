//! Heights worked out by hand, and slopes against differences.

use mapd_geometry::Cubic;
use mapd_geometry::surface::{
    Along, CellCorner, Height, LaneRise, Station, StripProfile, crossfall, grid_cell, lane_height,
    shape, strip_heights, transition,
};

/// Rounding of a few operations on numbers of order one.
const ROUNDING: f64 = 1e-14;
/// Step of a central difference, and what it may be off: its own error is of the order of its square.
const STEP: f64 = 1e-5;
const DIFFERENCE: f64 = 1e-8;

fn along(value: f64) -> Along {
    Along { value, by_s: 0.0 }
}

fn check(found: Height, h: f64, by_s: f64, by_t: f64) {
    for (found, expected) in [(found.h, h), (found.by_s, by_s), (found.by_t, by_t)] {
        assert!((found - expected).abs() <= ROUNDING, "{found:?} instead of {h}, {by_s}, {by_t}");
    }
}

#[test]
fn crossfall_falls_outwards() {
    // tan(atan 0.02) = 0.02, so 3 m to either side lie 0.06 m lower; the slope by t is −0.02 on the left, +0.02 right.
    let angle = along(0.02f64.atan());
    check(crossfall(angle, 3.0), -0.06, 0.0, -0.02);
    check(crossfall(angle, -3.0), -0.06, 0.0, 0.02);
    // An angle that grows by 0.001 rad/m: d tan(a) = (1 + tan²a) da = 1.0004 · 0.001, times 3 m, downwards.
    check(crossfall(Along { by_s: 0.001, ..angle }, 3.0), -0.06, -0.003_001_2, -0.02);
}

#[test]
fn shapes_are_cubics_across_and_linear_along() {
    // At s = 100: from t = −4 upwards h = 0.1 − 0.02·(t + 4). At s = 120: h = 0.3 + 0.01·(t + 4)².
    let before = Station { s: 100.0, t: -4.0, cubic: Cubic::new([0.1, -0.02, 0.0, 0.0]) };
    let behind = Station { s: 120.0, t: -4.0, cubic: Cubic::new([0.3, 0.0, 0.01, 0.0]) };
    // At t = −2, so dt = 2: the profiles give 0.1 − 0.04 = 0.06 and 0.3 + 0.04 = 0.34, their slopes −0.02 and 0.04.
    // A quarter of the way, s = 105: 0.06 + 0.25·0.28 = 0.13; by s 0.28/20 = 0.014; by t −0.02 + 0.25·0.06 = −0.005.
    check(shape(before, Some(behind), 105.0, -2.0), 0.13, 0.014, -0.005);
    // At a station its profile alone; before the first and behind the last one it holds.
    check(shape(before, Some(behind), 100.0, -2.0), 0.06, 0.0, -0.02);
    check(shape(before, Some(behind), 90.0, -2.0), 0.06, 0.0, -0.02);
    check(shape(behind, None, 200.0, -2.0), 0.34, 0.0, 0.04);
}

#[test]
fn lanes_rise_linearly_from_edge_to_edge() {
    // A pavement from t = −3.5 to −5.5, raised by 0.12 m inside and 0.16 m outside: 0.14 m in its middle; the height grows
    // by 0.04 m over −2 m of t, a slope of −0.02.
    let rise = LaneRise { inner: 0.12, outer: 0.16 };
    check(lane_height(rise, along(-3.5), along(-5.5), -4.5), 0.14, 0.0, -0.02);
    check(lane_height(rise, along(-3.5), along(-5.5), -3.5), 0.12, 0.0, 0.0);
    check(lane_height(rise, along(-3.5), along(-5.5), -5.5), 0.16, 0.0, 0.0);
    // No width: as at the inner edge.
    check(lane_height(rise, along(-3.5), along(-3.5), -3.5), 0.12, 0.0, 0.0);
}

#[test]
fn strips_follow_each_other_outwards() {
    // The middle lies at t = 0.5. To the left an inner strip of 3 m: h = 0.02·dt. Then an outer one: h = −0.05·dt,
    // relative to the inner one's edge at dt = 3, where h = 0.06.
    let [zero, middle] = [along(0.0), along(0.5)];
    let strip = |linear: f64, width: Option<f64>, relative| StripProfile {
        width: width.map(along),
        coefficients: [zero, along(linear), zero, zero],
        relative,
    };
    let (inner, outer) = (Some(strip(0.02, Some(3.0), false)), Some(strip(-0.05, None, true)));
    // t = 2.5: dt = 2, h = 0.04.
    check(strip_heights(middle, inner, outer, 2.5), 0.04, 0.0, 0.02);
    // t = 5.5: dt = 5, 2 m into the outer strip: 0.06 − 0.1 = −0.04.
    check(strip_heights(middle, inner, outer, 5.5), -0.04, 0.0, -0.05);
    // The same strip absolute: −0.1.
    let absolute = Some(strip(-0.05, None, false));
    check(strip_heights(middle, inner, absolute, 5.5), -0.1, 0.0, -0.05);
    // On the right distances are negative: t = −1.5 gives dt = −2 and h = −0.04; beyond the edge dt = −3, h = −0.06, the
    // outer strip adds −0.05·(−2) = 0.1.
    check(strip_heights(middle, inner, outer, -1.5), -0.04, 0.0, 0.02);
    check(strip_heights(middle, inner, outer, -4.5), 0.04, 0.0, -0.05);
    // Nothing beyond the inner strip: its edge's height holds. No strip at all: flat.
    check(strip_heights(middle, inner, None, 5.5), 0.06, 0.0, 0.0);
    check(strip_heights(middle, None, None, 5.5), 0.0, 0.0, 0.0);
    // A middle that moves left by 0.1 per metre: dt shrinks as fast, so 0.02·dt falls by 0.002 per metre.
    check(strip_heights(Along { value: 0.5, by_s: 0.1 }, inner, outer, 2.5), 0.04, -0.002, 0.02);
    // A cubic one: 1 + 2·2 + 3·4 + 4·8 = 49, slope 2 + 6·2 + 12·4 = 62.
    let cubic = StripProfile {
        coefficients: [along(1.0), along(2.0), along(3.0), along(4.0)],
        ..StripProfile::default()
    };
    check(strip_heights(zero, Some(cubic), None, 2.0), 49.0, 0.0, 62.0);
}

/// Slopes along the road of strips all of whose numbers change, against differences.
#[test]
fn strips_change_along_the_road() {
    let number = |value: f64, by_s: f64, s: f64| Along { value: value + by_s * s, by_s };
    let at = |s: f64, t: f64| {
        let inner = StripProfile {
            width: Some(number(3.0, 0.2, s)),
            coefficients: [
                number(0.1, 0.03, s),
                number(0.2, -0.01, s),
                number(0.02, 0.002, s),
                number(0.01, 0.001, s),
            ],
            relative: false,
        };
        let outer = StripProfile { relative: true, width: None, ..inner };
        strip_heights(number(0.4, -0.3, s), Some(inner), Some(outer), t)
    };
    for t in [-6.0, -2.0, 1.0, 5.0] {
        let difference = (at(STEP, t).h - at(-STEP, t).h) / (2.0 * STEP);
        assert!((at(0.0, t).by_s - difference).abs() < DIFFERENCE, "by s at {t}");
        let difference = (at(0.0, t + STEP).h - at(0.0, t - STEP).h) / (2.0 * STEP);
        assert!((at(0.0, t).by_t - difference).abs() < DIFFERENCE, "by t at {t}");
    }
}

#[test]
fn a_grid_cell_is_bicubic() {
    let corner = |z: f64| CellCorner { z, ..CellCorner::default() };
    // Without derivatives the middle is the mean of the corners, (0 + 1 + 2 + 5) / 4.
    let cell = [[corner(0.0), corner(1.0)], [corner(2.0), corner(5.0)]];
    assert!((grid_cell(&cell, 0.5, 0.5)[0] - 2.0).abs() < ROUNDING);
    // At a corner, its height.
    assert_eq!(grid_cell(&cell, 1.0, 0.0)[0], 2.0);
    // A quarter along the side from 0 to 2: Hermite's weight of the far end is 3/16 − 2/64 = 5/32, so 10/32.
    assert!((grid_cell(&cell, 0.25, 0.0)[0] - 0.3125).abs() < ROUNDING);
    // A plane z = 3x + 4y + 2xy with its own derivatives is met everywhere: at (0.3, 0.6) 0.9 + 2.4 + 0.36 = 3.66, slopes
    // 3 + 1.2 = 4.2 and 4 + 0.6 = 4.6.
    let plane = |x: f64, y: f64| CellCorner {
        z: 3.0 * x + 4.0 * y + 2.0 * x * y,
        along: 3.0 + 2.0 * y,
        across: 4.0 + 2.0 * x,
        twist: 2.0,
    };
    let cell = [[plane(0.0, 0.0), plane(0.0, 1.0)], [plane(1.0, 0.0), plane(1.0, 1.0)]];
    for (found, expected) in grid_cell(&cell, 0.3, 0.6).into_iter().zip([3.66, 4.2, 4.6]) {
        assert!((found - expected).abs() < ROUNDING, "{found} instead of {expected}");
    }
}

#[test]
fn transitions_are_flat_at_both_ends() {
    // A quarter of the way from 10 to 12 m: 1/16·(3 − 1/2) = 5/32 of 2 m.
    assert!((transition(10.0, 12.0, 0.25) - 10.3125).abs() < ROUNDING);
    assert_eq!([transition(10.0, 12.0, 0.0), transition(10.0, 12.0, 1.0)], [10.0, 12.0]);
    assert_eq!([transition(10.0, 12.0, -1.0), transition(10.0, 12.0, 2.0)], [10.0, 12.0]);
}
