//! Which way Lanelet2 reads a lanelet's borders.
//!
//! A file does not say in which direction a lanelet's borders run: Lanelet2 turns each so that the middle point of the other lies on its
//! proper side. In a narrow turn, whose inner border runs back, the point in the middle of the list can lie anywhere. A line with
//! more points is the same line, so that a point on its proper side can be made the middle one.

use mapd_client::glam::{DVec2, DVec3};

/// Parts of a line's length, one of which becomes the middle point, in the order in which they are tried.
const PARTS: [f64; 9] = [0.5, 0.4, 0.6, 0.25, 0.75, 0.15, 0.85, 0.05, 0.95];

/// Distances that differ by less may do so the other way round in another projection `[m]`.
const UNCLEAR: f64 = 1e-3;

/// What is shorter has no side that can be told `[m]`.
const SHORTEST_BORDER: f64 = 0.01;

/// Whether Lanelet2 finds that borders run as they do here, in the direction of travel. `is_forward` is whether that is the direction in
/// which they are written.
pub(super) fn is_read_as_meant(left: &[DVec3], right: &[DVec3], is_forward: bool) -> bool {
    let is_long = |line: &[DVec3]| length(line) >= SHORTEST_BORDER;
    let middle_of_right = if is_forward { middle(right) } else { middle_of_turned(right) };
    let is_right = side(left, middle_of_right) == Some(Side::Right);
    is_right && side(right, middle(left)) == Some(Side::Left) && is_long(left) && is_long(right)
}

/// The part of a line's length whose point lies on the proper side of all `others`: these run the same way and lie on the side
/// that stands with them.
pub(super) fn clear_part(line: &[DVec3], others: &[(Side, Vec<DVec3>)]) -> Option<f64> {
    PARTS.into_iter().find(|part| {
        let Some((_, point)) = at(line, *part) else { return false };
        let is_clear = |(own, other): &(Side, Vec<DVec3>)| {
            side(other, point.truncate()).is_some_and(|found| found != *own)
        };
        others.iter().all(is_clear)
    })
}

/// Length in plan view `[m]`.
fn length(line: &[DVec3]) -> f64 {
    line.windows(2).map(|pair| pair[0].truncate().distance(pair[1].truncate())).sum()
}

/// The point at a part of a line's length, and the number that it gets when it is inserted.
fn at(line: &[DVec3], part: f64) -> Option<(usize, DVec3)> {
    let (length, mut before) = (length(line), 0.0);
    for (number, pair) in line.windows(2).enumerate() {
        let own = pair[0].truncate().distance(pair[1].truncate());
        if before + own >= part * length || number + 2 == line.len() {
            let along = if own > 0.0 { (part * length - before) / own } else { 0.0 };
            return Some((number + 1, pair[0].lerp(pair[1], inside(along))));
        }
        before += own;
    }
    None
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// As it says, in the direction in which lines run.
    Left,
    /// As it says.
    Right,
}

/// The point that Lanelet2 takes for the middle of a line.
fn middle(line: &[DVec3]) -> DVec2 {
    match line {
        [a, b] => (0.5 * (*a + *b)).truncate(),
        _ => line.get(line.len() / 2).map_or(DVec2::NAN, |point| point.truncate()),
    }
}

/// As [`middle`], of the line in the other direction.
fn middle_of_turned(line: &[DVec3]) -> DVec2 {
    match line.len() {
        0..=2 => middle(line),
        count => line.get(count - 1 - count / 2).map_or(DVec2::NAN, |point| point.truncate()),
    }
}

/// The side of a line on which a point lies; none where the nearest segments differ, or where it lies on the line.
fn side(line: &[DVec3], point: DVec2) -> Option<Side> {
    let segments = || line.windows(2).map(|pair| [pair[0].truncate(), pair[1].truncate()]);
    let nearest = segments().map(|segment| foot(segment, point).0).fold(f64::INFINITY, f64::min);
    let mut found = None;
    for [a, b] in segments().filter(|segment| foot(*segment, point).0 <= nearest + UNCLEAR) {
        let own = if (b - a).perp_dot(point - a) > 0.0 { Side::Left } else { Side::Right };
        if *found.get_or_insert(own) != own {
            return None;
        }
    }
    found.filter(|_| nearest > UNCLEAR)
}

/// Adds points on a line so that the one in the middle of the list is the one at a part of its length.
pub(super) fn balance(line: &mut Vec<DVec3>, part: f64) {
    let Some((mut at, middle)) = at(line, part) else { return };
    let inner = 1..line.len().saturating_sub(1);
    let is_there = |at: &usize| {
        inner.contains(at) && line.get(*at).is_some_and(|own| own.distance(middle) <= UNCLEAR)
    };
    match [at - 1, at].into_iter().find(is_there) {
        Some(there) => at = there,
        None => line.insert(at, middle),
    }
    loop {
        let behind = line.len() - 1 - at;
        let range = match at.cmp(&behind) {
            std::cmp::Ordering::Equal => return,
            std::cmp::Ordering::Less => 0..at,
            std::cmp::Ordering::Greater => at..line.len() - 1,
        };
        let is_before = at < behind;
        let extent = |number: &usize| line[*number].distance_squared(line[number + 1]);
        let longest = range.max_by(|a, b| extent(a).total_cmp(&extent(b)));
        let Some(number) = longest else { return };
        line.insert(number + 1, 0.5 * (line[number] + line[number + 1]));
        at += usize::from(is_before);
    }
}

/// Cuts out where a line crosses itself, as the inner border of a turn does that is narrower than its lane. Returns how far the points that
/// are gone lie from the line `[m]`, at most; none where it does not cross itself.
pub(super) fn cut_loops(line: &mut Vec<DVec3>) -> Option<f64> {
    let mut gone: Vec<DVec3> = Vec::new();
    let mut at = 0;
    while at + 3 < line.len() {
        let crossing = (at + 2..line.len() - 1).find_map(|other| {
            Some((other, crossing([line[at], line[at + 1]], [line[other], line[other + 1]])?))
        });
        match crossing {
            Some((other, place)) => gone.extend(line.splice(at + 1..=other, [place])),
            None => at += 1,
        }
    }
    let distance = |point: &DVec3| {
        let segments = line
            .windows(2)
            .map(|pair| foot([pair[0].truncate(), pair[1].truncate()], point.truncate()));
        segments.fold(f64::INFINITY, |least, (distance, _)| least.min(distance))
    };
    gone.iter().map(distance).reduce(f64::max)
}

/// Where two segments cross in plan view; not where they only touch at their ends.
fn crossing([a, b]: [DVec3; 2], [c, d]: [DVec3; 2]) -> Option<DVec3> {
    let (first, second) = ((b - a).truncate(), (d - c).truncate());
    let scale = first.perp_dot(second);
    let between = (c - a).truncate();
    let (part, other) = (between.perp_dot(second) / scale, between.perp_dot(first) / scale);
    let is_within = |part: f64| 0.0 < part && part < 1.0;
    (is_within(part) && is_within(other)).then(|| a.lerp(b, part))
}

/// A part of a segment that is not before its beginning nor behind its end; of one without length its beginning.
fn inside(part: f64) -> f64 {
    if part > 0.0 { part.min(1.0) } else { 0.0 }
}

/// Distance of a point from a segment, and the part of the segment at its foot.
fn foot([a, b]: [DVec2; 2], point: DVec2) -> (f64, f64) {
    let along = b - a;
    let part = inside((point - a).dot(along) / along.length_squared());
    (point.distance(a + part * along), part)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(points: &[(f64, f64)]) -> Vec<DVec3> {
        points.iter().map(|(x, y)| DVec3::new(*x, *y, 0.0)).collect()
    }

    #[test]
    fn a_balanced_line_has_its_middle_in_the_middle() {
        for mut line in [
            line(&[(0.0, 0.0), (10.0, 0.0)]),
            line(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 0.0), (10.0, 0.0)]),
            line(&[(0.0, 0.0), (9.0, 0.0), (9.5, 0.0), (10.0, 0.0)]),
        ] {
            balance(&mut line, 0.5);
            assert_eq!(line.len() % 2, 1);
            assert_eq!(line[line.len() / 2], DVec3::new(5.0, 0.0, 0.0));
            assert!(line.windows(2).all(|pair| pair[0].x < pair[1].x), "{line:?}");
        }
    }

    #[test]
    fn a_line_that_crosses_itself_loses_its_loop() {
        let mut looped = line(&[(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (4.0, 2.0), (4.0, -3.0)]);
        assert_eq!(cut_loops(&mut looped), Some(8.0_f64.sqrt()));
        assert_eq!(looped, line(&[(0.0, 0.0), (4.0, 0.0), (4.0, -3.0)]));
        let mut plain = line(&[(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (4.0, 2.0), (4.0, 1.0)]);
        assert_eq!(cut_loops(&mut plain), None);
        assert_eq!(plain.len(), 5);
    }

    #[test]
    fn a_lane_is_read_as_meant_only_with_its_borders_on_their_sides() {
        let (left, right) = (line(&[(0.0, 2.0), (9.0, 2.0)]), line(&[(0.0, 0.0), (9.0, 0.0)]));
        for forward in [true, false] {
            assert!(is_read_as_meant(&left, &right, forward));
            assert!(!is_read_as_meant(&right, &left, forward));
            assert!(!is_read_as_meant(&left, &left, forward), "no width");
        }
    }
}
