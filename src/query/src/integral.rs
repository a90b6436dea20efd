//! Integrals of functions that are smooth but for a few corners.

/// Places of Lobatto's rule of four points on −1 to 1, besides both ends: one over the square root of 5.
const LOBATTO: f64 = 0.447_213_595_499_957_9;
/// What Kronrod's rule of seven points adds to them, besides the middle: the square root of 2/3.
const KRONROD: f64 = 0.816_496_580_927_726;

/// Both rules may differ by this over a part, and by this share of its integral. Of smooth functions the finer rule, which counts, is then closer by far.
const TOLERANCE: f64 = 1e-9;
const RELATIVE: f64 = 1e-12;
/// Parts that are looked at: what is not smooth by then never is.
const MOST_PARTS: u32 = 1 << 12;
/// Parts that may wait for those before them: half of the last one is no number of its own.
const MOST_WAITING: usize = 60;

/// The integral of a function from one place up to another: Lobatto's rule and Kronrod's extension of it, over halves where they differ (W. Gander and
/// W. Gautschi, Adaptive Quadrature – Revisited, 2000). They look at both ends, so that no corner hides beside one.
pub(crate) fn integral(function: &mut dyn FnMut(f64) -> f64, from: f64, to: f64) -> f64 {
    // Ends of the parts that come later with the function there, the next one last.
    let mut later = [[0.0; 2]; MOST_WAITING];
    let (mut waiting, mut parts, mut sum) = (0, 0, 0.0);
    let mut begin = [from, function(from)];
    let mut end = [to, function(to)];
    loop {
        let (middle, half) = (0.5 * (begin[0] + end[0]), 0.5 * (end[0] - begin[0]));
        let mut pair =
            |place: f64| function(middle - half * place) + function(middle + half * place);
        let (inner, outer) = (pair(LOBATTO), pair(KRONROD));
        let (ends, center) = (begin[1] + end[1], function(middle));
        let coarse = half * (ends + 5.0 * inner) / 6.0;
        let fine = half * (77.0 * ends + 432.0 * outer + 625.0 * inner + 672.0 * center) / 1470.0;
        parts += 1;
        let differs = (fine - coarse).abs() > TOLERANCE + RELATIVE * fine.abs();
        let may_halve = parts < MOST_PARTS && begin[0] < middle && middle < end[0];
        if let Some(place) = later.get_mut(waiting).filter(|_| differs && may_halve) {
            *place = end;
            waiting += 1;
            end = [middle, center];
            continue;
        }
        sum += fine;
        if waiting == 0 {
            return sum;
        }
        waiting -= 1;
        begin = end;
        end = later.get(waiting).copied().unwrap_or(end);
    }
}
