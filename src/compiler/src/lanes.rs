//! Samples every lane's centre line and border, through the queries that will answer later.

use crate::TooLarge;
use crate::flatten::{Sample, flatten};
use crate::options::CompileOptions;
use glam::DVec3;
use mapd_archive::{Archive, Header, LaneRow, PointRow, Provenance, Range, Rows};
use mapd_query::{Lane, Map, Track};
use rayon::prelude::*;

/// Lanes that one task samples; small enough to share work evenly, large enough to be worth a task.
const LANES_PER_TASK: usize = 64;

/// The sampled lines of one lane.
struct Lines {
    origin: DVec3,
    center: Vec<PointRow>,
    border: Vec<PointRow>,
    bounds: [DVec3; 2],
}

/// Fills `points`, the lanes' ranges into them and the map's bounds. Lanes are sampled in parallel and joined in order.
pub(crate) fn sample(rows: &mut Rows, options: &CompileOptions) -> Result<(), TooLarge> {
    let lines: Vec<Vec<Option<Lines>>> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let numbers: Vec<u32> = (0..rows.lanes.len() as u32).collect();
        numbers
            .par_chunks(LANES_PER_TASK)
            .map(|chunk| chunk.iter().map(|number| lines(map, *number, options)).collect())
            .collect()
    };
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for (lane, lines) in lines.into_iter().flatten().enumerate() {
        let Some(lines) = lines else { continue };
        let (Some(center), Some(border)) =
            (append(&mut rows.points, &lines.center), append(&mut rows.points, &lines.border))
        else {
            return Err(TooLarge::at_lane("points", rows, lane as u32));
        };
        let row: &mut LaneRow = &mut rows.lanes[lane];
        (row.center, row.border) = (center, border);
        (row.x, row.y, row.z) = lines.origin.into();
        low = low.min(lines.bounds[0]);
        high = high.max(lines.bounds[1]);
    }
    if let Some(map) = rows.map.first_mut().filter(|_| low.is_finite() && high.is_finite()) {
        (map.min_x, map.min_y, map.min_z) = (low.x + map.origin_x, low.y + map.origin_y, low.z);
        (map.max_x, map.max_y, map.max_z) = (high.x + map.origin_x, high.y + map.origin_y, high.z);
    }
    Ok(())
}

/// Unfinished rows, seen as an archive.
pub(crate) fn view(rows: &Rows) -> Archive<'_> {
    let header =
        Header { body_length: 0, content_hash: [0; 32], provenance: Provenance::default() };
    Archive { header, tables: rows.as_tables() }
}

fn append(points: &mut Vec<PointRow>, new: &[PointRow]) -> Option<Range> {
    let before = points.len();
    points.extend_from_slice(new);
    Range::between(before, points.len())
}

fn lines(map: Map<'_>, number: u32, options: &CompileOptions) -> Option<Lines> {
    let lane = map.lane_by_row(number)?;
    let road = lane.road();
    let origin = map.local_origin();
    let s_start = lane.section().s_start();
    let breaks = breaks(&lane);
    let at = |t: f64, s: f64| {
        let pose = road.to_inertial(Track { s, t, h: 0.0 }).ok()?;
        Some(DVec3::new(pose.position.x - origin.x, pose.position.y - origin.y, pose.position.z))
    };
    let mut samples = Vec::new();
    let border = |s: f64| at(lane.edges_at(s).outer, s);
    flatten(&breaks, options.bound_tolerance, &border, &mut samples)?;
    let first = samples.first()?.position;
    let mut bounds = [first; 2];
    for sample in &samples {
        bounds = [bounds[0].min(sample.position), bounds[1].max(sample.position)];
    }
    let border = points(&samples, first, s_start);
    let center = if lane.number() == 0 {
        Vec::new()
    } else {
        let center = |s: f64| at(lane.edges_at(s).center(), s);
        flatten(&breaks, options.index_tolerance, &center, &mut samples)?;
        points(&samples, first, s_start)
    };
    Some(Lines { origin: first, center, border, bounds })
}

/// Points relative to an origin.
fn points(samples: &[Sample], origin: DVec3, s_start: f64) -> Vec<PointRow> {
    let relative = |sample: &Sample| {
        let p = sample.position - origin;
        PointRow { x: p.x as f32, y: p.y as f32, z: p.z as f32, s: (sample.s - s_start) as f32 }
    };
    samples.iter().map(relative).collect()
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
