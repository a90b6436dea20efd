//! Integrals of functions that are smooth but for a few corners.

/// Lobatto's rule of four points on −1 to 1: its place besides both ends, one over the square root of 5, and the weights of the ends and of that.
const LOBATTO: f64 = 0.447_213_595_499_957_9;
const OF_4: [f64; 2] = [1.0 / 6.0, 5.0 / 6.0];
/// What Kronrod's rule of seven points adds, besides the middle: the square root of 2/3. Weights of the ends, of Lobatto's place, of this one, of the middle.
const KRONROD: f64 = 0.816_496_580_927_726;
const OF_7: [f64; 4] = [77.0 / 1470.0, 625.0 / 1470.0, 432.0 / 1470.0, 672.0 / 1470.0];
/// What its extension to thirteen points adds. Weights in the same order, these last.
const FURTHER: [f64; 3] =
    [0.942_882_415_695_479_7, 0.641_853_342_345_781_3, 0.236_383_199_662_149_88];
const OF_13: [f64; 4] = [
    0.015_827_191_973_480_183,
    0.199_773_405_226_858_53,
    0.155_071_987_336_585_4,
    0.242_611_071_901_407_73,
];
const OF_FURTHER: [f64; 3] =
    [0.094_273_840_218_850_05, 0.188_821_573_960_182_45, 0.224_926_465_333_339_53];

/// Two rules may differ by this over a part, and by this share of its integral. Of smooth functions the finer one, which counts, is then closer by far.
const TOLERANCE: f64 = 1e-9;
const RELATIVE: f64 = 1e-12;
/// Parts that are looked at: what is not smooth by then never is.
const MOST_PARTS: u32 = 1 << 12;
/// Parts that may wait for those before them: half of the last one is no number of its own.
const MOST_WAITING: usize = 60;

/// The integral of a function from one place up to another: Lobatto's rule and Kronrod's two extensions of it, over halves where they differ (W. Gander and
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
        let known = [begin[1] + end[1], pair(LOBATTO), pair(KRONROD)];
        let center = function(middle);
        let by = |[of_ends, of_lobatto, of_kronrod, of_center]: [f64; 4]| {
            of_ends * known[0] + of_lobatto * known[1] + of_kronrod * known[2] + of_center * center
        };
        let differs = |a: f64, b: f64| half * (a - b).abs() > TOLERANCE + RELATIVE * half * b.abs();
        let mut fine = by(OF_7);
        let mut is_found = !differs(by([OF_4[0], OF_4[1], 0.0, 0.0]), fine);
        if !is_found {
            let mut pair =
                |place: f64| function(middle - half * place) + function(middle + half * place);
            let further = FURTHER.map(&mut pair);
            let finer: f64 = further.iter().zip(OF_FURTHER).map(|(sum, weight)| sum * weight).sum();
            let finer = by(OF_13) + finer;
            is_found = !differs(fine, finer);
            fine = finer;
        }
        parts += 1;
        let may_halve = parts < MOST_PARTS && begin[0] < middle && middle < end[0];
        if let Some(place) = later.get_mut(waiting).filter(|_| !is_found && may_halve) {
            *place = end;
            waiting += 1;
            end = [middle, center];
            continue;
        }
        sum += half * fine;
        if waiting == 0 {
            return sum;
        }
        waiting -= 1;
        begin = end;
        end = later.get(waiting).copied().unwrap_or(end);
    }
}
