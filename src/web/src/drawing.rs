//! What a graphics card draws: areas as triangles and strokes as rectangles, in chunks that lie apart.

use mapd_query::glam::{DVec2, DVec3};

/// Edge of the squares by which chunks are cut `[m]`: what is not on the screen is left out chunk by chunk.
pub const TILE: f64 = 256.0;

/// Heights that differ by more than this are drawn one above the other `[m]`.
pub const LEVEL: f64 = 3.0;

/// Level 0 as it is written: levels are written from 0 up.
const LEVEL_ZERO: i64 = 1 << 15;

/// A corner of an area. Sixteen bytes, as the page's shader reads them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Corner {
    /// Place from the drawing's middle `[m]`.
    pub place: [f32; 2],
    /// Height from the drawing's middle `[m]`.
    pub height: f32,
    /// Paint in the low eight bits, above them the level.
    pub paint: u32,
}

/// A straight piece of a line. Thirty-six bytes, as the page's shader reads them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Stroke {
    /// First end from the drawing's middle `[m]`.
    pub from: [f32; 2],
    /// Second end `[m]`.
    pub to: [f32; 2],
    /// Length from the beginning of a dash to that of this piece `[m]`.
    pub along: f32,
    /// Width `[m]`; 0 for a line that is as thin as can be seen.
    pub width: f32,
    /// Length of a dash `[m]`.
    pub dash: f32,
    /// Gap between dashes `[m]`; 0 for a line that is drawn through.
    pub gap: f32,
    /// Paint in the low eight bits, above them the level.
    pub paint: u32,
}

/// What lies near each other: ranges of triangles' corners and strokes, and the box around them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Chunk {
    /// Smallest x and y, largest x and y, from the drawing's middle `[m]`.
    pub bounds: [f32; 4],
    /// First entry and number of entries of [`Drawing::triangles`].
    pub triangles: [u32; 2],
    /// First stroke and number of strokes.
    pub strokes: [u32; 2],
}

/// A point of a line beside a road.
#[derive(Clone, Copy, Debug)]
pub struct EdgePoint {
    /// Along the road `[m]`.
    pub s: f64,
    /// In space `[m]`.
    pub position: DVec3,
}

/// How an area is filled.
#[derive(Clone, Copy, Debug)]
pub struct Fill {
    /// Number of the paint.
    pub paint: u8,
    /// Level on which it lies.
    pub level: i64,
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pen {
    /// Number of the paint.
    pub paint: u8,
    /// Level on which it lies.
    pub level: i64,
    /// Width `[m]`; 0 for as thin as can be seen.
    pub width: f64,
}

/// How a line beside a road is broken.
#[derive(Clone, Copy, Debug)]
pub struct Dashes {
    /// s at which a dash begins `[m]`.
    pub from: f64,
    /// Dash and gap `[m]` of s.
    pub lengths: [f64; 2],
}

/// Shapes, relative to a middle, so that single precision is enough.
#[derive(Default)]
pub struct Drawing {
    middle: DVec3,
    /// Corners of areas.
    pub corners: Vec<Corner>,
    /// Three corners each, by number.
    pub triangles: Vec<u32>,
    /// Pieces of lines.
    pub strokes: Vec<Stroke>,
    /// Parts that lie near each other.
    pub chunks: Vec<Chunk>,
    tile: Option<[i64; 2]>,
}

/// The level on which a height is drawn.
pub(crate) fn level(height: f64) -> i64 {
    (height / LEVEL).round() as i64
}

fn code(paint: u8, level: i64) -> u32 {
    // What lies outside is drawn on the lowest or highest level.
    u32::from(paint) | ((level + LEVEL_ZERO).clamp(0, 2 * LEVEL_ZERO - 1) as u32) << 8
}

impl Drawing {
    /// An empty one.
    pub fn new(middle: DVec3) -> Self {
        Self { middle, ..Self::default() }
    }

    /// Begins a new chunk if a place lies in another square than what came before.
    pub fn near(&mut self, place: DVec2) {
        let tile = [(place.x / TILE).floor() as i64, (place.y / TILE).floor() as i64];
        if self.tile != Some(tile) {
            self.tile = Some(tile);
            let first = [self.triangles.len() as u32, self.strokes.len() as u32];
            let [x, y] = [f32::INFINITY, f32::NEG_INFINITY];
            self.chunks.push(Chunk {
                bounds: [x, x, y, y],
                triangles: [first[0], 0],
                strokes: [first[1], 0],
            });
        }
    }

    fn corner(&mut self, place: DVec3, paint: u32) {
        let at = place - self.middle;
        let corner = Corner { place: [at.x as f32, at.y as f32], height: at.z as f32, paint };
        self.corners.push(corner);
    }

    /// Adds the strip between two lines of ascending s.
    pub fn strip(
        &mut self,
        left: impl Iterator<Item = EdgePoint>,
        right: impl Iterator<Item = EdgePoint>,
        fill: Fill,
    ) {
        let paint = code(fill.paint, fill.level);
        let (mut left, mut right) = (left.peekable(), right.peekable());
        let mut last: [Option<u32>; 2] = [None, None];
        loop {
            // The line whose next point comes first goes on; at the start both have one.
            let side = match (left.peek(), right.peek()) {
                (Some(a), Some(b)) => usize::from(last[0].is_some() && b.s < a.s),
                (Some(_), None) => 0,
                (None, Some(_)) => 1,
                (None, None) => break,
            };
            let Some(point) = (if side == 0 { left.next() } else { right.next() }) else {
                break;
            };
            let number = self.corners.len() as u32;
            self.corner(point.position, paint);
            if let [Some(a), Some(b)] = last {
                self.triangles.extend([a, b, number]);
            }
            last[side] = Some(number);
            if last[1].is_none()
                && let Some(point) = right.next()
            {
                last[1] = Some(self.corners.len() as u32);
                self.corner(point.position, paint);
            }
        }
    }

    /// Adds an area by its outline, whose last corner is not the first again. An outline that crosses itself is filled
    /// somehow.
    pub fn area(&mut self, outline: &[DVec3], paint: u8, level: i64) {
        let first = self.corners.len() as u32;
        let paint = code(paint, level);
        for place in outline {
            self.corner(*place, paint);
        }
        for triangle in crate::triangles::of(outline) {
            self.triangles.extend(triangle.map(|corner| first + corner));
        }
    }

    /// Adds a line.
    pub fn line(&mut self, points: impl Iterator<Item = DVec3>, pen: &Pen) {
        self.line_along(points.map(|position| EdgePoint { s: 0.0, position }), None, pen);
    }

    /// Adds a line beside a road. Its dashes lie at s: what is drawn has those lengths where it runs beside the reference line, and others in bends.
    pub fn line_along(
        &mut self,
        points: impl Iterator<Item = EdgePoint>,
        dashes: Option<Dashes>,
        pen: &Pen,
    ) {
        let mut last = None::<(f64, DVec2)>;
        for EdgePoint { s, position } in points {
            let point = (position - self.middle).truncate();
            if let Some((s_from, from)) = last.replace((s, point)) {
                let drawn = from.distance(point) / (s - s_from);
                let dashes = dashes.filter(|_| drawn.is_finite());
                let [along, dash, gap] = dashes.map_or([0.0; 3], |own| {
                    let [dash, gap] = own.lengths;
                    // From the dash's beginning, so that single precision holds it on long lines.
                    let along = (s_from - own.from).rem_euclid(dash + gap);
                    [along, dash, gap].map(|of_s| of_s * drawn)
                });
                self.strokes.push(Stroke {
                    from: [from.x as f32, from.y as f32],
                    to: [point.x as f32, point.y as f32],
                    along: along as f32,
                    width: pen.width as f32,
                    dash: dash as f32,
                    gap: gap as f32,
                    paint: code(pen.paint, pen.level),
                });
            }
        }
    }

    /// Adds a line that ends where it begins.
    pub fn ring(&mut self, outline: &[DVec3], pen: &Pen) {
        self.line(outline.iter().chain(outline.first()).copied(), pen);
    }

    /// Ends the drawing: every chunk gets its counts and its box.
    pub fn finish(&mut self) {
        let ends = |chunks: &[Chunk], i: usize, of: fn(&Chunk) -> u32, all: usize| {
            chunks.get(i + 1).map_or(all as u32, of)
        };
        for i in 0..self.chunks.len() {
            let triangles = ends(&self.chunks, i, |chunk| chunk.triangles[0], self.triangles.len());
            let strokes = ends(&self.chunks, i, |chunk| chunk.strokes[0], self.strokes.len());
            let Some(chunk) = self.chunks.get_mut(i) else { return };
            chunk.triangles[1] = triangles - chunk.triangles[0];
            chunk.strokes[1] = strokes - chunk.strokes[0];
            let mut include = |[x, y]: [f32; 2], around: f32| {
                let [low_x, low_y, high_x, high_y] = chunk.bounds;
                chunk.bounds = [
                    low_x.min(x - around),
                    low_y.min(y - around),
                    high_x.max(x + around),
                    high_y.max(y + around),
                ];
            };
            let own = chunk.triangles[0] as usize..triangles as usize;
            for corner in self.triangles.get(own).unwrap_or_default() {
                if let Some(corner) = self.corners.get(*corner as usize) {
                    include(corner.place, 0.0);
                }
            }
            let own = chunk.strokes[0] as usize..strokes as usize;
            for stroke in self.strokes.get(own).unwrap_or_default() {
                include(stroke.from, stroke.width);
                include(stroke.to, stroke.width);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(drawing: &Drawing) -> f64 {
        let at = |i: &u32| drawing.corners[*i as usize].place.map(f64::from);
        let area = |t: &[u32]| {
            let [a, b, c] = [at(&t[0]), at(&t[1]), at(&t[2])];
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])).abs()
        };
        drawing.triangles.chunks_exact(3).map(area).sum()
    }

    #[test]
    fn a_strip_covers_what_lies_between_its_lines() {
        let mut drawing = Drawing::new(DVec3::ZERO);
        let point = |s: f64, y: f64| EdgePoint { s, position: DVec3::new(s, y, 0.0) };
        let line = |y: f64, s: &[f64]| s.iter().map(|s| point(*s, y)).collect::<Vec<_>>();
        drawing.near(DVec2::ZERO);
        let (left, right) = (line(3.0, &[0.0, 1.0, 4.0, 10.0]), line(0.0, &[0.0, 10.0]));
        drawing.strip(left.into_iter(), right.into_iter(), Fill { paint: 1, level: 0 });
        drawing.finish();
        assert!((area(&drawing) - 30.0).abs() < 1e-4, "{}", area(&drawing));
        assert_eq!(drawing.chunks[0].bounds, [0.0, 0.0, 10.0, 3.0]);
        assert_eq!(drawing.chunks[0].triangles, [0, 12]);
    }

    #[test]
    fn a_chunk_holds_what_lies_in_one_square() {
        let mut drawing = Drawing::new(DVec3::ZERO);
        for x in [10.0, 20.0, 10.0 + TILE, 20.0 + TILE] {
            drawing.near(DVec2::new(x, 0.0));
            drawing
                .line([x, x + 1.0].into_iter().map(|x| DVec3::new(x, 0.0, 0.0)), &Pen::default());
        }
        drawing.finish();
        let counts: Vec<[u32; 2]> = drawing.chunks.iter().map(|chunk| chunk.strokes).collect();
        assert_eq!(counts, [[0, 2], [2, 2]]);
    }
}
