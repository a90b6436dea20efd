//! Gauss–Legendre quadrature with twelve nodes (Abramowitz and Stegun, 25.4.30 and table 25.4).

/// Positive nodes and their weights; the rule is symmetric.
const NODES: [(f64, f64); 6] = [
    (0.125_233_408_511_468_92, 0.249_147_045_813_402_79),
    (0.367_831_498_998_180_2, 0.233_492_536_538_354_8),
    (0.587_317_954_286_617_4, 0.203_167_426_723_065_92),
    (0.769_902_674_194_304_7, 0.160_078_328_543_346_23),
    (0.904_117_256_370_474_9, 0.106_939_325_995_318_43),
    (0.981_560_634_246_719_3, 0.047_175_336_386_511_83),
];

/// Integral over [a, b] of a function with two components.
#[inline]
pub(crate) fn integrate2(a: f64, b: f64, f: impl Fn(f64) -> (f64, f64)) -> (f64, f64) {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let (mut x, mut y) = (0.0, 0.0);
    for (node, weight) in NODES {
        let (left, right) = (f(middle - half * node), f(middle + half * node));
        x += weight * (left.0 + right.0);
        y += weight * (left.1 + right.1);
    }
    (half * x, half * y)
}

/// Integral over [a, b].
#[inline]
pub(crate) fn integrate(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    integrate2(a, b, |x| (f(x), 0.0)).0
}
