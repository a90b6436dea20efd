//! Builds the packed spatial index over the lanes' centre lines.

use super::lane_lines::{Around, Border, Line, Point, lines_of};
use super::packed::{Key, ROUNDING, joined, ordered, round_up, stack};
use crate::findings::TooLarge;
use crate::options::CompileOptions;
use crate::sample::view;
use glam::{DVec2, DVec3};
use mapd_archive::packed_index::{HEIGHT_UNIT, REACH_UNIT, WIDTH};
use mapd_archive::{IndexLeafRow, IndexNodeRow, NONE, Rows};
use mapd_geometry::clamp;
use mapd_query::Map;
use mapd_query::compiling::ByRow as _;
use mapd_query::roads::LinePoint;
use rayon::prelude::*;

/// Added to every reach, overshoot and height `[m]`, besides the tolerances: single precision within a leaf.
const REACH_MARGIN: f64 = 1e-4;
/// Least step of a leaf `[m]`: finer ones mean nothing, and products with them stay normal numbers.
const LEAST_STEP: f32 = 1.0 / (1 << 20) as f32;
/// Units of `reach` and `overshoot` in a metre.
const REACH_UNITS: f64 = 1.0 / REACH_UNIT as f64;
/// Units of `z_low` and `z_high` in a metre.
const HEIGHT_UNITS: f64 = 1.0 / HEIGHT_UNIT as f64;

/// A segment of a centre line. All of them are ordered at once, so that there is no more of each than its name; what is
/// stored of it is computed leaf by leaf.
#[derive(Clone, Copy, Debug)]
struct LaneSegment {
    lane: u32,
    segment: u16,
}

impl LaneSegment {
    /// One number for both, by which lanes come one behind the other.
    fn number(self) -> u64 {
        u64::from(self.lane) << u16::BITS | u64::from(self.segment)
    }

    /// The segment of such a number.
    fn of(number: u64) -> Self {
        Self { lane: (number >> u16::BITS) as u32, segment: number as u16 }
    }
}

/// A segment of a centre line as its leaf has it, with the area it stands for, relative to the local origin.
#[derive(Clone, Copy, Debug)]
struct Entry {
    a: DVec2,
    b: DVec2,
    extent: Extent,
    place: LaneSegment,
}

/// How far a lane's area reaches around a segment of its centre line.
#[derive(Clone, Copy, Debug)]
struct Extent {
    /// From the line through the segment `[m]`.
    reach: f64,
    /// Beyond the segment's ends, along it `[m]`.
    overshoot: f64,
    /// Heights `[m]`.
    z: [f64; 2],
}

/// Fills `index_levels`, `index_nodes` and `index_leaves`.
pub(crate) fn build(rows: &mut Rows, options: &CompileOptions) -> Result<(), TooLarge> {
    let archive = view(rows);
    let map = Map::new(&archive, 0);
    let lanes = (0..rows.lanes.len() as u32).into_par_iter();
    let keys = lanes.fold(Vec::new, |mut keys, lane| {
        add_places(map, lane, &mut keys);
        keys
    });
    let keys = joined(keys.collect());
    if keys.is_empty() {
        return Ok(());
    }
    u32::try_from(keys.len()).map_err(|_| TooLarge::new("index_leaves"))?;
    let places = ordered(keys);
    let leaf = |room: &mut _, places| leaf(map, places, options, room);
    let leaves = places.par_chunks(WIDTH).map_init(Room::default, leaf);
    let (leaves, boxes): (Vec<_>, Vec<_>) = leaves.unzip();
    let (levels, nodes) = stack(boxes, node);
    rows.index_levels = levels.into();
    rows.index_nodes = nodes.into();
    rows.index_leaves = leaves.into();
    Ok(())
}

/// Adds the segments of a lane that have an area, to be ordered by their middles. Both sides of a jump have none between them.
fn add_places(map: Map<'_>, lane: u32, keys: &mut Vec<Key>) {
    let row = map.lane_by_row(lane).filter(|lane| !lane.is_temporary());
    let Some(line) = row.map(|lane| lane.center_line()) else { return };
    let origin = map.local_origin();
    let (mut before, mut segment) = (None, 0);
    for LinePoint { s, position } in line.points() {
        let here = (position.truncate() - origin, s);
        if let Some((place, at)) = before.replace(here) {
            if at != s {
                keys.push(Key::new(place + here.0, LaneSegment { lane, segment }.number()));
            }
            segment += 1;
        }
    }
}

/// Both ends of a segment, and s there.
fn ends(center: &Line<'_>, segment: u16) -> [Point; 2] {
    let first = usize::from(segment);
    [first, first + 1].map(|i| center.point(i).unwrap_or_default())
}

impl Extent {
    const NONE: Self = Self { reach: 0.0, overshoot: 0.0, z: [f64::INFINITY, f64::NEG_INFINITY] };

    fn widened(self, margin: f64) -> Self {
        Self {
            reach: self.reach + margin,
            overshoot: self.overshoot + margin,
            z: [self.z[0] - margin, self.z[1] + margin],
        }
    }
}

/// The extent of a lane's area between two s. The area lies in the hull of both borders' stretches, and what is asked of
/// it (how far to the sides, beyond the ends, up and down) is greatest at a point of theirs, or where they are cut.
fn extent(borders: &mut [Border<'_>; 2], ends: [DVec2; 2], cuts: [f64; 2]) -> Extent {
    let along = ends[1] - ends[0];
    let length = along.length();
    let mut extent = Extent::NONE;
    let mut visit = |p: DVec3| {
        let away = p.truncate() - ends[0];
        let (forward, sideways) = if length > 0.0 {
            (away.dot(along) / length, away.perp_dot(along) / length)
        } else {
            (away.length(), away.length())
        };
        extent.reach = larger(extent.reach, sideways.abs());
        extent.overshoot = larger(larger(extent.overshoot, -forward), forward - length);
        extent.z = [-larger(-extent.z[0], -p.z), larger(extent.z[1], p.z)];
    };
    for border in borders {
        let Around { mut before, mut next, mut here } = border.around(cuts[0]);
        // A point at a cut is visited as itself.
        if here.is_some_and(|p| p.s > cuts[0]) {
            cut(before, here, cuts[0]).into_iter().for_each(&mut visit);
        }
        while let Some(p) = here.filter(|p| p.s <= cuts[1]) {
            visit(p.place);
            next += 1;
            (before, here) = (here, border.point(next));
        }
        if before.is_some_and(|p| p.s < cuts[1]) {
            cut(before, here, cuts[1]).into_iter().for_each(&mut visit);
        }
        border.pass(Around { before, next, here });
    }
    extent
}

/// The larger of two numbers, `a` where `b` is not a number: one instruction, where `max` looks at both for that.
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// The place at s between two points of a border.
fn cut(before: Option<Point>, after: Option<Point>, s: f64) -> Option<DVec3> {
    let (p, q) = before.zip(after)?;
    (q.s > p.s).then(|| p.place.lerp(q.place, clamp((s - p.s) / (q.s - p.s), 0.0, 1.0)))
}

/// A box in double precision: smallest x, y, z, largest x, y, z.
type Bounds = [DVec3; 2];

const EMPTY: Bounds = [DVec3::INFINITY, DVec3::NEG_INFINITY];

fn join(a: Bounds, b: Bounds) -> Bounds {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// The box of an entry's area.
fn bounds(e: &Entry) -> Bounds {
    let along = (e.b - e.a).normalize_or_zero();
    // Without a direction, both count in all directions.
    let (forward, sideways) = if along == DVec2::ZERO {
        (DVec2::splat(e.extent.overshoot), DVec2::splat(e.extent.reach))
    } else {
        (along.abs() * e.extent.overshoot, along.perp().abs() * e.extent.reach)
    };
    let around = forward + sideways;
    let (low, high) = (e.a.min(e.b) - around, e.a.max(e.b) + around);
    [low.extend(e.extent.z[0]), high.extend(e.extent.z[1])]
}

/// Where a leaf's segments are written from, and in which steps.
struct LeafFrame {
    corner: [f32; 2],
    step: f32,
}

impl LeafFrame {
    /// The frame in which all these places have numbers of 16 bits.
    fn around(low: DVec2, high: DVec2) -> Self {
        let corner = [low.x, low.y].map(round_down);
        let span = (high - DVec2::from(corner.map(f64::from))).max_element();
        // Divided by one number less than there are, so that rounding the quotient reaches none beyond.
        let step = round_up(span / f64::from(u16::MAX - 1)).max(LEAST_STEP);
        Self { corner, step }
    }

    /// A place in steps.
    fn steps(&self, place: DVec2) -> [u16; 2] {
        let away = place - DVec2::from(self.corner.map(f64::from));
        (away / f64::from(self.step)).to_array().map(nearest)
    }

    /// The place that so many steps stand for.
    fn place(&self, steps: [u16; 2]) -> DVec2 {
        let away = steps.map(|steps| f64::from(steps) * f64::from(self.step));
        DVec2::from(self.corner.map(f64::from)) + DVec2::from(away)
    }
}

/// Both ends of a segment in steps; never the same, so that each segment has a direction.
fn ends_in_steps(frame: &LeafFrame, ends: [DVec2; 2]) -> [[u16; 2]; 2] {
    let [start, mut end] = ends.map(|end| frame.steps(end));
    if start == end {
        end[0] = if start[0] == u16::MAX { start[0] - 1 } else { start[0] + 1 };
    }
    [start, end]
}

/// Room to work in, for one leaf after the other.
#[derive(Default)]
struct Room<'a> {
    /// Lanes, by row, with their borders.
    lanes: Vec<(u32, [Border<'a>; 2])>,
    entries: Vec<Entry>,
}

/// A leaf and the box of all areas in it. How far an area reaches is told from its segment as it is written, so that
/// writing it in steps loses nothing.
fn leaf<'a>(
    map: Map<'a>,
    places: &[u64],
    options: &CompileOptions,
    Room { lanes, entries }: &mut Room<'a>,
) -> (IndexLeafRow, Bounds) {
    let places = places.iter().copied().map(LaneSegment::of);
    lanes.clear();
    entries.clear();
    let mut segments = [[Point::default(); 2]; WIDTH];
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let mut line = None;
    for (segment, place) in segments.iter_mut().zip(places.clone()) {
        // Segments of one lane stand behind each other.
        if lanes.last().is_none_or(|(lane, _)| *lane != place.lane) {
            let lines = lines_of(map, place.lane);
            line = lines.map(|(center, borders)| {
                lanes.push((place.lane, borders));
                center
            });
        }
        let ends = line.map_or_else(Default::default, |line| ends(&line, place.segment));
        for end in ends.map(|end| end.place.truncate()) {
            (low, high) = (low.min(end), high.max(end));
        }
        *segment = ends;
    }
    let frame = LeafFrame::around(low, high);
    let mut row = IndexLeafRow {
        x: frame.corner[0],
        y: frame.corner[1],
        z: 0.0,
        step: frame.step,
        lane: [NONE; WIDTH],
        start_x: [0; WIDTH],
        start_y: [0; WIDTH],
        end_x: [1; WIDTH],
        end_y: [0; WIDTH],
        segment: [0; WIDTH],
        reach: [0; WIDTH],
        overshoot: [0; WIDTH],
        z_low: [0; WIDTH],
        z_high: [0; WIDTH],
    };
    let margin = 2.0 * options.bound_tolerance + REACH_MARGIN;
    for (k, (place, ends)) in places.zip(segments).enumerate().take(WIDTH) {
        let [start, end] = ends_in_steps(&frame, ends.map(|end| end.place.truncate()));
        ([row.start_x[k], row.start_y[k]], [row.end_x[k], row.end_y[k]]) = (start, end);
        let written = [start, end].map(|end| frame.place(end));
        let borders = lanes.iter_mut().find(|(lane, _)| *lane == place.lane);
        let cuts = ends.map(|end| end.s);
        let extent = borders.map_or(Extent::NONE, |(_, both)| extent(both, written, cuts));
        let [a, b] = written;
        entries.push(Entry { a, b, extent: extent.widened(margin), place });
    }
    let lowest = entries.iter().map(|e| e.extent.z[0]).fold(f64::INFINITY, f64::min);
    row.z = round_down(lowest);
    let z = f64::from(row.z);
    // A query has places relative to the corner in single precision.
    let rounding = f64::from(frame.step) * f64::from(u16::MAX) * ROUNDING;
    let mut all = EMPTY;
    for (k, e) in entries.iter().enumerate() {
        row.lane[k] = e.place.lane;
        row.segment[k] = e.place.segment;
        row.reach[k] = units((e.extent.reach + rounding) * REACH_UNITS);
        row.overshoot[k] = units((e.extent.overshoot + rounding) * REACH_UNITS);
        row.z_low[k] = ((e.extent.z[0] - z) * HEIGHT_UNITS) as u16;
        row.z_high[k] = units((e.extent.z[1] - z) * HEIGHT_UNITS);
        all = join(all, bounds(e));
    }
    (row, all)
}

/// To single precision, never larger.
fn round_down(value: f64) -> f32 {
    -round_up(-value)
}

// Casts drop what is behind the point and saturate; calls of the C library that round take several times as long.

/// The nearest whole number, of two the larger one.
fn nearest(value: f64) -> u16 {
    let down = value as u16;
    down.saturating_add(u16::from(value - f64::from(down) >= 0.5))
}

/// Rounded up; the largest value, which stands for any distance, where it does not fit.
fn units(value: f64) -> u16 {
    let down = value as u16;
    down.saturating_add(u16::from(value > f64::from(down)))
}

/// A node over the boxes of its children.
fn node(children: &[Bounds]) -> (IndexNodeRow, Bounds) {
    // Empty boxes: nothing is near them, and every number stays finite.
    let mut row = IndexNodeRow {
        min_x: [f32::MAX; WIDTH],
        min_y: [f32::MAX; WIDTH],
        max_x: [f32::MIN; WIDTH],
        max_y: [f32::MIN; WIDTH],
        min_z: [f32::MAX; WIDTH],
        max_z: [f32::MIN; WIDTH],
    };
    let mut all = EMPTY;
    for (k, child) in children.iter().enumerate().take(WIDTH) {
        let margin = child[0].abs().max(child[1].abs()).max_element() * ROUNDING;
        row.min_x[k] = -round_up(-(child[0].x - margin));
        row.min_y[k] = -round_up(-(child[0].y - margin));
        row.max_x[k] = round_up(child[1].x + margin);
        row.max_y[k] = round_up(child[1].y + margin);
        row.min_z[k] = -round_up(-(child[0].z - margin));
        row.max_z[k] = round_up(child[1].z + margin);
        all = join(all, *child);
    }
    (row, all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounds_as_the_library_does() {
        let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, -0.3, -0.7, -5.0, 1e300];
        let whole = [0.0, 1.0, 2.0, 777.0, 65_534.0, 65_535.0, 65_536.0];
        let near = whole.into_iter().flat_map(|whole: f64| {
            [whole, whole + 0.5].into_iter().flat_map(|x| [x.next_down(), x, x.next_up()])
        });
        for value in odd.into_iter().chain(near) {
            assert_eq!(nearest(value), value.round() as u16, "{value}");
            assert_eq!(units(value), value.ceil() as u16, "{value}");
            assert_eq!(value as u16, value.floor() as u16, "{value}");
        }
    }
}
