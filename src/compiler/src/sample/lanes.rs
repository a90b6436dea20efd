//! Samples every lane's centre line and border, through the queries that will answer later.

use super::allowance::Allowance;
use super::cuts::{Cuts, Memory};
use super::flatten::{Curve, Fault, Sample, flatten};
use crate::findings::TooLarge;
use crate::options::CompileOptions;
use glam::DVec3;
use mapd_archive::{Archive, Header, KeyedHash, LaneRow, PointCode, Rows, SectionRow};
use mapd_query::compiling::{ByRow as _, Parallel};
use mapd_query::{Lane, LaneEdges, LaneSection, Map};
use rayon::prelude::*;
use std::collections::HashMap;

/// Sections that one task samples; small enough to share work evenly, large enough to be worth a task.
const SECTIONS_PER_TASK: usize = 16;

/// Sections that are sampled before their points are appended: many tasks for each thread. What they yield is many small blocks; where those of a whole
/// map are freed, no table can get their memory. Builds with debug assertions join much smaller parts, so that tests have several.
const SECTIONS_AT_ONCE: usize = if cfg!(debug_assertions) { 2 * SECTIONS_PER_TASK } else { 4096 };

/// Share of the index' tolerance that centre lines use up. Shorter segments have sharper rectangles around them, but there are
/// more of them: of shares from 0.25 to 1, with this one queries on the carried town take the fewest instructions.
const INDEX_SHARE: f64 = 0.75;

/// Share of the tolerances that writing points in few bits may use up: their steps are at most this share of the smaller
/// one, so that a point is off by less than √3/2 of that.
const ROUNDING_SHARE: f64 = 1.0 / 16.0;

/// The sampled lines of some sections.
struct Lines {
    /// One for each section.
    frames: Vec<SectionEncoding>,
    lanes: Vec<Line>,
    /// Stations, section by section.
    stations: Vec<f32>,
    /// Centre line and border as they are written, lane by lane.
    bytes: Vec<u8>,
    /// Lanes whose lines have too many points, or points that cannot be written.
    unfit: Vec<u32>,
    /// Smallest and largest coordinates of any point.
    bounds: [DVec3; 2],
}

/// What the points of a section count from, and how they are written.
#[derive(Clone, Copy, Default)]
struct SectionEncoding {
    origin: [f32; 3],
    code: PointCode,
    /// Number of its stations.
    stations: usize,
}

/// What the points of one lane are.
struct Line {
    lane: u32,
    /// Points of the centre line.
    center: usize,
    /// Points of the border, which follow.
    border: usize,
    /// Bytes of both.
    bytes: usize,
}

/// Where sequences of stations begin, by their bytes.
type KnownStations = HashMap<Vec<u8>, u32, KeyedHash>;

/// Fills `point_stations`, `points`, what sections and lanes say of them, and the map's bounds. Sections are sampled in parallel and
/// joined in order. Yields lanes whose lines have more points than lines may have, or such as cannot be written; of a section with such a lane, not all lanes are
/// looked at. Where the allowance is exceeded, nothing of it is of use.
pub(crate) fn sample(
    rows: &mut Rows,
    options: &CompileOptions,
    allowance: &Allowance,
) -> Result<Vec<u32>, TooLarge> {
    let mut tables = PointTables::default();
    let numbers: Vec<u32> = (0..rows.sections.len() as u32).collect();
    let mut before = (&[][..], Vec::new());
    // While the points of some are appended the next ones are sampled.
    for numbers in numbers.chunks(SECTIONS_AT_ONCE).chain([&[][..]]) {
        let seen = &*rows;
        let (sampled, stored) = rayon::join(
            || {
                let archive = view(seen);
                let map = Map::new(&archive, 0);
                let chunks = numbers.par_chunks(SECTIONS_PER_TASK);
                let lines =
                    |room: &mut Room, sections| lines(map, sections, options, allowance, room);
                chunks.map_init(Room::new, lines).collect::<Vec<_>>()
            },
            || before.1.iter().map(|lines| tables.append(lines)).collect::<Result<Vec<_>, _>>(),
        );
        if allowance.is_exceeded() {
            return Ok(Vec::new());
        }
        let (mut numbers_before, lines) = std::mem::replace(&mut before, (numbers, sampled));
        for (lines, stored) in lines.iter().zip(stored?) {
            let (own, behind) = numbers_before.split_at(lines.frames.len());
            numbers_before = behind;
            place(rows, own, lines, stored)?;
        }
    }
    let PointTables { points, stations, bounds: [low, high], unfit, .. } = tables;
    (rows.points, rows.point_stations) = (points.into(), stations.into());
    if let Some(map) = rows.map.first_mut().filter(|_| low.is_finite() && high.is_finite()) {
        (map.min_x, map.min_y, map.min_z) = (low.x + map.origin_x, low.y + map.origin_y, low.z);
        (map.max_x, map.max_y, map.max_z) = (high.x + map.origin_x, high.y + map.origin_y, high.z);
    }
    Ok(unfit)
}

/// What is sampled of all sections.
struct PointTables {
    points: Vec<u8>,
    stations: Vec<f32>,
    /// Equal sections have equal stations: each sequence is written once.
    known: KnownStations,
    bounds: [DVec3; 2],
    unfit: Vec<u32>,
}

impl Default for PointTables {
    fn default() -> Self {
        let bounds = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let known = KnownStations::default();
        Self { points: Vec::new(), stations: Vec::new(), known, bounds, unfit: Vec::new() }
    }
}

/// Where the lines of some sections lie.
struct StoredAt {
    /// First byte of their points.
    byte: usize,
    /// First station of each section.
    stations: Vec<u32>,
}

impl PointTables {
    /// Appends the points of some sections.
    fn append(&mut self, lines: &Lines) -> Result<StoredAt, TooLarge> {
        let [low, high] = self.bounds;
        self.bounds = [low.min(lines.bounds[0]), high.max(lines.bounds[1])];
        self.unfit.extend_from_slice(&lines.unfit);
        let byte = self.points.len();
        self.points.extend_from_slice(&lines.bytes);
        let mut stored = StoredAt { byte, stations: Vec::with_capacity(lines.frames.len()) };
        let mut stations = lines.stations.as_slice();
        for frame in &lines.frames {
            let (own, others) = stations.split_at(frame.stations);
            let first = u32::try_from(self.stations.len());
            let first = first.map_err(|_| TooLarge::new("point_stations"))?;
            let key: &[u8] = bytemuck::cast_slice(own);
            stored.stations.push(match self.known.get(key) {
                Some(first) => *first,
                None => {
                    self.stations.extend_from_slice(own);
                    self.known.insert(key.to_vec(), first);
                    first
                }
            });
            stations = others;
        }
        Ok(stored)
    }
}

/// Says where the points of sections of these numbers lie.
fn place(
    rows: &mut Rows,
    numbers: &[u32],
    lines: &Lines,
    stored: StoredAt,
) -> Result<(), TooLarge> {
    for ((number, frame), station) in numbers.iter().zip(&lines.frames).zip(stored.stations) {
        let row: &mut SectionRow = &mut rows.sections[*number as usize];
        [row.x, row.y, row.z] = frame.origin;
        row.set_point_code(frame.code);
        row.first_station = station;
    }
    let mut first = stored.byte;
    for line in &lines.lanes {
        let Ok(first_byte) = u32::try_from(first) else {
            return Err(TooLarge::at_lane("points", rows, line.lane));
        };
        first += line.bytes;
        let row: &mut LaneRow = &mut rows.lanes[line.lane as usize];
        row.first_byte = first_byte;
        // Longer ones are among `unfit`.
        (row.center_count, row.border_count) = (line.center as u16, line.border as u16);
    }
    Ok(())
}

/// Unfinished rows, seen as an archive.
pub(crate) fn view(rows: &Rows) -> Archive<'_> {
    Archive { header: Header::default(), tables: rows.as_tables() }
}

/// Samples the lanes of some sections.
fn lines(
    map: Map<'_>,
    sections: &[u32],
    options: &CompileOptions,
    allowance: &Allowance,
    Room { memory, sampled, bytes }: &mut Room,
) -> Lines {
    let mut lines = Lines {
        frames: Vec::with_capacity(sections.len()),
        lanes: Vec::new(),
        stations: Vec::new(),
        bytes: std::mem::take(bytes),
        unfit: Vec::new(),
        bounds: [DVec3::INFINITY, DVec3::NEG_INFINITY],
    };
    for section in sections {
        sampled.samples.clear();
        let before = lines.lanes.len();
        let section = map.section_by_row(*section);
        let cuts = section.and_then(|section| Some((section, Cuts::new(section, memory)?)));
        let start = section.map_or(0.0, |section| section.s_start());
        if let Some((section, mut cuts)) = cuts {
            line_breaks(&section, &mut sampled.line_breaks);
            let unfit = lines.unfit.len();
            for (at, lane) in section.lanes().enumerate() {
                if lines.unfit.len() > unfit || allowance.is_exceeded() {
                    break;
                }
                let samples = sampled.samples.len();
                let along = (&mut cuts, at);
                if line(&lane, along, options, sampled, &mut lines).is_err() {
                    sampled.samples.truncate(samples);
                    lines.unfit.push(lane.lane_id().row());
                }
                allowance.take(sampled.samples.len() - samples);
            }
        }
        write(sampled, start, options, before, &mut lines);
    }
    // Exactly as many as there are: they are kept for a while.
    let written = lines.bytes.as_slice().into();
    *bytes = std::mem::replace(&mut lines.bytes, written);
    bytes.clear();
    lines
}

/// Room to work in, for one section after the other.
struct Room {
    memory: Memory,
    sampled: Sampled,
    /// Points as they are written.
    bytes: Vec<u8>,
}

impl Room {
    fn new() -> Self {
        Self { memory: Memory::new(), sampled: Sampled::default(), bytes: Vec::new() }
    }
}

/// What is sampled of one section.
#[derive(Default)]
struct Sampled {
    /// Centre line and border, lane by lane.
    samples: Vec<Sample>,
    line: Vec<Sample>,
    /// Stations of the samples, each in the upper half with the number of its sample below.
    order: Vec<u64>,
    stations: Vec<f32>,
    /// Number of each sample's station.
    ranks: Vec<u32>,
    /// Where records begin that shape all lanes, and where those that shape one.
    line_breaks: Vec<f64>,
    breaks: Vec<f64>,
}

impl Sampled {
    /// Finds the stations of a section that begins at an s, ascending, and which one each sample is at.
    fn find_stations(&mut self, s_start: f64) {
        let Self { samples, order, stations, ranks, .. } = self;
        order.clear();
        let key = |(number, sample): (usize, &Sample)| {
            u64::from(comparable((sample.s - s_start) as f32)) << u32::BITS | number as u64
        };
        order.extend(samples.iter().enumerate().map(key));
        // No two are equal.
        order.sort_unstable();
        stations.clear();
        ranks.clear();
        ranks.resize(samples.len(), 0);
        for key in order {
            let station = station((*key >> u32::BITS) as u32);
            if stations.last() != Some(&station) {
                stations.push(station);
            }
            ranks[*key as u32 as usize] = stations.len() as u32 - 1;
        }
    }
}

const SIGN: u32 = 1 << 31;

/// A number that compares as the station does.
fn comparable(station: f32) -> u32 {
    let bits = station.to_bits();
    if bits & SIGN == 0 { bits | SIGN } else { !bits }
}

/// The station of such a number.
fn station(comparable: u32) -> f32 {
    f32::from_bits(if comparable & SIGN == 0 { !comparable } else { comparable & !SIGN })
}

/// Samples the lane that is the `at`-th of its section from the left.
///
/// Errors: as those of [`flatten`].
fn line(
    lane: &Lane<'_>,
    (cuts, at): (&mut Cuts<'_, '_>, usize),
    options: &CompileOptions,
    sampled: &mut Sampled,
    lines: &mut Lines,
) -> Result<(), Fault> {
    breaks(lane, &sampled.line_breaks, &mut sampled.breaks);
    let row = lane.lane_id().row();
    let before = sampled.samples.len();
    if lane.number() != 0 {
        let mut curve = LaneCurve { cuts, lane: at, t: LaneEdges::center };
        let tolerance = INDEX_SHARE * options.index_tolerance;
        flatten(&sampled.breaks, tolerance, &mut curve, &mut sampled.line)?;
        sampled.samples.append(&mut sampled.line);
    }
    let center = sampled.samples.len() - before;
    let mut curve = LaneCurve { cuts, lane: at, t: |edges: LaneEdges| edges.outer };
    let tolerance = (1.0 - ROUNDING_SHARE) * options.bound_tolerance;
    flatten(&sampled.breaks, tolerance, &mut curve, &mut sampled.line)?;
    let border = sampled.line.len();
    for sample in &sampled.line {
        let [low, high] = lines.bounds;
        lines.bounds = [low.min(sample.position), high.max(sample.position)];
    }
    sampled.samples.append(&mut sampled.line);
    lines.lanes.push(Line { lane: row, center, border, bytes: 0 });
    Ok(())
}

/// Writes the points of a section, of whose lanes the first is the `before`-th of all.
fn write(
    sampled: &mut Sampled,
    s_start: f64,
    options: &CompileOptions,
    before: usize,
    lines: &mut Lines,
) {
    sampled.find_stations(s_start);
    let Sampled { samples, stations, ranks, .. } = sampled;
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for sample in samples.iter() {
        (low, high) = (low.min(sample.position), high.max(sample.position));
    }
    let step = ROUNDING_SHARE * options.index_tolerance.min(options.bound_tolerance);
    let origin = low.to_array().map(round_down);
    let from = DVec3::from_array(origin.map(f64::from));
    let code = PointCode::fitting((high - from).to_array(), stations.len(), step);
    // Where 128 bits are not enough for a point, steps are larger than the tolerances allow.
    let is_fine = |code: &PointCode| from.is_finite() && code.error() <= step;
    let Some(code) = code.filter(|code| !samples.is_empty() && is_fine(code)) else {
        // Nothing could be sampled, or nothing that can be written.
        let lost = lines.lanes.drain(before..).map(|line| line.lane);
        lines.unfit.extend(lost);
        let (code, none) = (PointCode::fitting([0.0; 3], 0, step), [0.0; 3]);
        let code = code.unwrap_or_default();
        lines.frames.push(SectionEncoding { origin: none, code, stations: 0 });
        return;
    };
    lines.frames.push(SectionEncoding { origin, code, stations: stations.len() });
    for (sample, station) in samples.iter().zip(ranks) {
        code.write((sample.position - from).to_array(), *station, &mut lines.bytes);
    }
    for line in lines.lanes.iter_mut().skip(before) {
        line.bytes = (line.center + line.border) * code.bytes();
    }
    lines.stations.extend_from_slice(stations);
}

/// The largest number of single precision that is not above this.
fn round_down(value: f64) -> f32 {
    let near = value as f32;
    if f64::from(near) > value { near.next_down() } else { near }
}

/// A line along a lane, between its edges.
struct LaneCurve<'c, 'm, 'a, T> {
    cuts: &'c mut Cuts<'m, 'a>,
    /// Counted from the left.
    lane: usize,
    t: T,
}

impl<'a, T: Fn(LaneEdges) -> f64> Curve<'a> for LaneCurve<'_, '_, 'a, T> {
    #[inline]
    fn at(&mut self, s: f64) -> Option<DVec3> {
        self.cuts.place(self.lane, s, &self.t)
    }

    fn is_straight(&mut self, from: f64, to: f64) -> bool {
        self.cuts.is_straight(self.lane, from, to)
    }

    fn arc(&mut self, from: f64, to: f64) -> Option<f64> {
        self.cuts.arc(self.lane, from, to)
    }

    fn parallel(&mut self, from: f64, to: f64) -> Option<Parallel<'a>> {
        self.cuts.parallel(self.lane, [from, to], &self.t)
    }
}

/// Both ends of a section, and every s between them at which a record begins that shapes all its lanes; ascending.
fn line_breaks(section: &LaneSection<'_>, breaks: &mut Vec<f64>) {
    let (start, end) = (section.s_start(), section.s_end());
    breaks.clear();
    breaks.extend([start, end]);
    // What shapes the centre lane shapes them all.
    let all = section.lane(0).into_iter().flat_map(|lane| lane.shape_breaks());
    breaks.extend(all.filter(|s| *s > start && *s < end));
    breaks.sort_by(f64::total_cmp);
    breaks.dedup();
    if breaks.len() == 1 {
        breaks.push(end);
    }
}

/// As [`line_breaks`], which `of_all` has, with the records that shape this lane.
fn breaks(lane: &Lane<'_>, of_all: &[f64], breaks: &mut Vec<f64>) {
    let section = lane.section();
    let (start, end) = (section.s_start(), section.s_end());
    breaks.clear();
    breaks.extend_from_slice(of_all);
    breaks.extend(lane.width_breaks().filter(|s| *s > start && *s < end));
    if breaks.len() > of_all.len() {
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
    }
}
