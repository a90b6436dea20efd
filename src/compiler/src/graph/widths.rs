//! Stretches on which a lane has no width: written as 0, or by a cubic that goes below 0 there.

use super::cuts::SHORTEST_PIECE;
use mapd_archive::CubicRow;

/// Halvings that find where a cubic becomes 0: as many as a number has digits.
const HALVINGS: usize = 60;

/// Appends where a lane's stretches without width begin and end, from the section's start.
pub(super) fn borders(widths: &[CubicRow], section: [f64; 2], out: &mut Vec<f64>) {
    let first = out.len();
    for (rank, _) in widths.iter().enumerate() {
        for [from, to] in without(widths, rank, section).into_iter().flatten() {
            // One that goes on over several records has no borders between them.
            match out.last() == Some(&from) && out.len() > first {
                true => _ = out.pop(),
                false => out.push(from),
            }
            out.push(to);
        }
    }
}

/// Whether a lane is more than a line at a place, from the section's start.
pub(super) fn has_width(widths: &[CubicRow], section: [f64; 2], offset: f64) -> bool {
    let after = widths.partition_point(|record| record.s <= section[0] + offset);
    after.checked_sub(1).is_some_and(|rank| {
        let mut none = without(widths, rank, section).into_iter().flatten();
        !none.any(|[from, to]| from <= offset && offset <= to)
    })
}

/// The stretches of a record without width, from the section's start. Of a cubic those shorter than a piece are none: written with few digits, one that ends
/// at 0 goes below it a little before.
fn without(widths: &[CubicRow], rank: usize, [start, end]: [f64; 2]) -> [Option<[f64; 2]>; 2] {
    let Some(own) = widths.get(rank) else { return [None; 2] };
    let next = widths.get(rank + 1).map_or(end, |next| next.s);
    let (begin, end) = (own.s - start, next - start);
    if own.b == 0.0 && own.c == 0.0 && own.d == 0.0 {
        return [(own.a <= 0.0).then_some([begin, end]), None];
    }
    let length = end - begin;
    let turns = turns(own).map(|turn| turn.filter(|turn| *turn > 0.0 && *turn < length));
    let mut found: [Option<[f64; 2]>; 2] = [None; 2];
    let (mut from, mut count) = (0.0, 0);
    // Between the turns it rises or falls all along.
    for to in turns.into_iter().flatten().chain([length]) {
        let stretch = match [value(own, from) <= 0.0, value(own, to) <= 0.0] {
            [true, true] => Some([from, to]),
            [true, false] => Some([from, root(own, from, to)]),
            [false, true] => Some([root(own, to, from), to]),
            [false, false] => None,
        };
        from = to;
        let Some([low, high]) = stretch else { continue };
        let place = |ds: f64| if ds >= length { end } else { begin + ds };
        match found.get_mut(count.max(1) - 1) {
            Some(Some([_, last])) if *last == place(low) => *last = place(high),
            _ => {
                if let Some(free) = found.get_mut(count) {
                    *free = Some([place(low), place(high)]);
                    count += 1;
                }
            }
        }
    }
    found.map(|stretch| stretch.filter(|[low, high]| high - low >= SHORTEST_PIECE))
}

/// Where a cubic's slope b + 2c·ds + 3d·ds² is 0, the smaller first.
fn turns(cubic: &CubicRow) -> [Option<f64>; 2] {
    let (b, c, d) = (cubic.b, 2.0 * cubic.c, 3.0 * cubic.d);
    let root = (c * c - 4.0 * d * b).sqrt();
    // Of both roots, each by the form that loses no digits.
    let q = -0.5 * (c + root.copysign(c));
    let finite = |turn: f64| Some(turn).filter(|turn| turn.is_finite());
    let (one, two) = (finite(q / d), finite(b / q));
    match one.zip(two) {
        Some((one, two)) if one > two => [Some(two), Some(one)],
        _ => [one, two],
    }
}

/// Where a cubic that is not above 0 at one place, and above it at another, becomes 0 between.
fn root(cubic: &CubicRow, mut none: f64, mut some: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (none + some);
        *(if value(cubic, middle) <= 0.0 { &mut none } else { &mut some }) = middle;
    }
    none
}

fn value(cubic: &CubicRow, ds: f64) -> f64 {
    cubic.a + ds * (cubic.b + ds * (cubic.c + ds * cubic.d))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Borders of the stretches without width on 100 m.
    fn check(records: &[(f64, [f64; 4])], expected: &[f64]) {
        let section = [10.0, 110.0];
        let row = |(s, [a, b, c, d]): &(f64, [f64; 4])| CubicRow {
            s: 10.0 + s,
            a: *a,
            b: *b,
            c: *c,
            d: *d,
        };
        let widths: Vec<CubicRow> = records.iter().map(row).collect();
        let mut found = Vec::new();
        borders(&widths, section, &mut found);
        let near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-9;
        assert!(
            found.len() == expected.len() && found.iter().zip(expected).all(near),
            "{records:?}: {found:?}"
        );
        for i in 0..400 {
            let offset = 0.125 + 0.25 * f64::from(i);
            let inside = expected.chunks(2).any(|own| own[0] <= offset && offset <= own[1]);
            assert_eq!(has_width(&widths, section, offset), !inside, "{records:?} at {offset}");
        }
    }

    #[test]
    fn a_width_of_0_or_below_is_none() {
        let falls = [3.0, -0.075, 0.0, 0.0];
        check(&[(0.0, [3.0, 0.0, 0.0, 0.0])], &[]);
        check(&[(0.0, falls), (40.0, [0.0; 4])], &[40.0, 100.0]);
        check(&[(0.0, falls)], &[40.0, 100.0]);
        check(&[(0.0, falls), (60.0, [-1.0, 0.0, 0.0, 0.0])], &[40.0, 100.0]);
        check(&[(0.0, falls), (60.0, [-1.0, 0.1, 0.0, 0.0])], &[40.0, 70.0]);
        // A parabola that is below 0 from 20 to 60 m, and one that only touches it.
        check(&[(0.0, [1.2, -0.08, 0.001, 0.0])], &[20.0, 60.0]);
        check(&[(0.0, [1.6, -0.08, 0.001, 0.0])], &[]);
        // A cubic with roots at 10, 30 and 80 m.
        check(&[(0.0, [-2.4, 0.35, -0.012, 0.0001])], &[0.0, 10.0, 30.0, 80.0]);
        // A taper that misses its end by a few digits.
        check(&[(0.0, [3.5, 0.0, -0.00105, 0.000006999999])], &[]);
    }
}
