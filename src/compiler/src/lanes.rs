//! Samples every lane's centre line and border, through the queries that will answer later.

use crate::TooLarge;
use crate::allowance::Allowance;
use crate::cuts::{Cuts, Memory};
use crate::flatten::{Curve, Fault, Sample, flatten};
use crate::options::CompileOptions;
use glam::DVec3;
use mapd_archive::{Archive, Header, LaneRow, PointRow, Provenance, Range, Rows};
use mapd_query::{Lane, LaneEdges, Map};
use rayon::prelude::*;

/// Sections that one task samples; small enough to share work evenly, large enough to be worth a task.
const SECTIONS_PER_TASK: usize = 16;

/// Share of the index' tolerance that centre lines use up. Shorter segments have sharper rectangles around them, but there are
/// more of them: of shares from 0.25 to 1, with this one queries on the carried town take the fewest instructions.
const INDEX_SHARE: f64 = 0.75;

/// The sampled lines of some lanes.
struct Lines {
    lanes: Vec<Line>,
    /// Centre line and border, lane by lane.
    points: Vec<PointRow>,
    /// Lanes whose lines have too many points.
    long: Vec<u32>,
    /// Smallest and largest coordinates of any point.
    bounds: [DVec3; 2],
}

/// What the points of one lane are.
struct Line {
    lane: u32,
    origin: DVec3,
    /// Points of the centre line.
    center: usize,
    /// Points of the border, which follow.
    border: usize,
}

/// Fills `points`, the lanes' ranges into them and the map's bounds. Sections are sampled in parallel and joined in order.
/// Yields lanes whose lines have more points than lines may have; of a section with such a lane, not all lanes are looked at.
/// Where the allowance is exceeded, nothing of it is of use.
pub(crate) fn sample(
    rows: &mut Rows,
    options: &CompileOptions,
    allowance: &Allowance,
) -> Result<Vec<u32>, TooLarge> {
    let lines: Vec<Lines> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let numbers: Vec<u32> = (0..rows.sections.len() as u32).collect();
        let chunks = numbers.par_chunks(SECTIONS_PER_TASK);
        chunks.map(|sections| lines(map, sections, options, allowance)).collect()
    };
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    if allowance.is_exceeded() {
        return Ok(Vec::new());
    }
    let mut long = Vec::new();
    rows.points.reserve_exact(lines.iter().map(|lines| lines.points.len()).sum());
    for lines in lines {
        let mut first = rows.points.len();
        rows.points.extend_from_slice(&lines.points);
        for line in &lines.lanes {
            let middle = first + line.center;
            let end = middle + line.border;
            let (Some(center), Some(border)) =
                (Range::between(first, middle), Range::between(middle, end))
            else {
                return Err(TooLarge::at_lane("points", rows, line.lane));
            };
            first = end;
            let row: &mut LaneRow = &mut rows.lanes[line.lane as usize];
            (row.center, row.border) = (center, border);
            (row.x, row.y, row.z) = line.origin.into();
        }
        long.extend(lines.long);
        low = low.min(lines.bounds[0]);
        high = high.max(lines.bounds[1]);
    }
    if let Some(map) = rows.map.first_mut().filter(|_| low.is_finite() && high.is_finite()) {
        (map.min_x, map.min_y, map.min_z) = (low.x + map.origin_x, low.y + map.origin_y, low.z);
        (map.max_x, map.max_y, map.max_z) = (high.x + map.origin_x, high.y + map.origin_y, high.z);
    }
    Ok(long)
}

/// Unfinished rows, seen as an archive.
pub(crate) fn view(rows: &Rows) -> Archive<'_> {
    let header =
        Header { body_length: 0, content_hash: [0; 32], provenance: Provenance::default() };
    Archive { header, tables: rows.as_tables() }
}

/// Samples the lanes of some sections.
fn lines(map: Map<'_>, sections: &[u32], options: &CompileOptions, allowance: &Allowance) -> Lines {
    let bounds = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    let mut lines = Lines { lanes: Vec::new(), points: Vec::new(), long: Vec::new(), bounds };
    let mut memory = Memory::new();
    let mut samples = Vec::new();
    for section in sections.iter().filter_map(|section| map.section_by_row(*section)) {
        let Some(mut cuts) = Cuts::new(section, &mut memory) else { continue };
        let long = lines.long.len();
        for (at, lane) in section.lanes().enumerate() {
            if lines.long.len() > long || allowance.is_exceeded() {
                break;
            }
            let before = lines.points.len();
            let along = (&mut cuts, at);
            if let Err(fault) = line(&lane, along, options, &mut samples, &mut lines) {
                lines.points.truncate(before);
                if fault == Fault::TooManyPoints {
                    lines.long.push(lane.lane_id().row());
                }
            }
            allowance.take(lines.points.len() - before);
        }
    }
    lines.points.shrink_to_fit();
    lines
}

/// Samples the lane that is the `at`-th of its section from the left.
///
/// Errors: as those of [`flatten`].
fn line(
    lane: &Lane<'_>,
    (cuts, at): (&mut Cuts<'_, '_>, usize),
    options: &CompileOptions,
    samples: &mut Vec<Sample>,
    lines: &mut Lines,
) -> Result<(), Fault> {
    let breaks = breaks(lane);
    let s_start = lane.section().s_start();
    let mut border = LaneCurve { cuts, lane: at, t: |edges: LaneEdges| edges.outer };
    flatten(&breaks, options.bound_tolerance, &mut border, samples)?;
    let origin = samples.first().ok_or(Fault::NotFinite)?.position;
    let mut bounds = lines.bounds;
    for sample in samples.iter() {
        bounds = [bounds[0].min(sample.position), bounds[1].max(sample.position)];
    }
    // In the table the centre line comes first; the border gives the origin.
    let outer = points(samples, origin, s_start).collect::<Vec<_>>();
    let before = lines.points.len();
    if lane.number() != 0 {
        let mut center = LaneCurve { cuts, lane: at, t: LaneEdges::center };
        flatten(&breaks, INDEX_SHARE * options.index_tolerance, &mut center, samples)?;
        lines.points.extend(points(samples, origin, s_start));
    }
    let center = lines.points.len() - before;
    lines.points.extend_from_slice(&outer);
    let lane = lane.lane_id().row();
    lines.lanes.push(Line { lane, origin, center, border: outer.len() });
    lines.bounds = bounds;
    Ok(())
}

/// A line along a lane, between its edges.
struct LaneCurve<'c, 'm, 'a, T> {
    cuts: &'c mut Cuts<'m, 'a>,
    /// Counted from the left.
    lane: usize,
    t: T,
}

impl<T: Fn(LaneEdges) -> f64> Curve for LaneCurve<'_, '_, '_, T> {
    #[inline]
    fn at(&mut self, s: f64) -> Option<DVec3> {
        self.cuts.place(self.lane, s, &self.t)
    }

    fn is_straight(&mut self, from: f64, to: f64) -> bool {
        self.cuts.is_straight(self.lane, from, to)
    }
}

/// Points relative to an origin.
fn points(
    samples: &[Sample],
    origin: DVec3,
    s_start: f64,
) -> impl ExactSizeIterator<Item = PointRow> {
    samples.iter().map(move |sample| {
        let p = sample.position - origin;
        PointRow { x: p.x as f32, y: p.y as f32, z: p.z as f32, s: (sample.s - s_start) as f32 }
    })
}

/// Every s of the lane's section at which some record that shapes it begins, with both ends.
fn breaks(lane: &Lane<'_>) -> Vec<f64> {
    let section = lane.section();
    let (start, end) = (section.s_start(), section.s_end());
    let mut breaks: Vec<f64> = lane.shape_breaks().filter(|s| *s > start && *s < end).collect();
    breaks.push(start);
    breaks.push(end);
    breaks.sort_by(f64::total_cmp);
    breaks.dedup();
    if breaks.len() == 1 {
        breaks.push(end);
    }
    breaks
}
