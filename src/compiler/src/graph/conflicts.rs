//! Lanes of different roads whose areas meet within a junction: they cross, merge or overlap.
//!
//! Each lane is cut into short cells, quadrangles between its edges. Where cells of two lanes share more than a strip, the
//! lanes conflict; the interval on each reaches from the first to the last such cell. So intervals are too long by
//! at most a cell at either end, and never too short by more than what the chords cut off. Ways that only part from each
//! other are no conflict: who follows one has left the other. At direct junctions they are: there, lanes that part lie on
//! each other for a while.

use super::zones::{Stretch, Zone, ZoneKind};
use crate::finding;
use crate::lanes::view;
use glam::DVec2;
use mapd_archive::{ConflictKind, ConflictRow, NO_RELATION, RelationReason, Rows, section_step};
use mapd_query::{Lane, LaneId, Map};
use mapd_xodr::{Finding, Severity};
use rayon::prelude::*;

/// Longest cell `[m]`.
const CELL: f64 = 0.5;
/// Cells of one lane at most; those of a longer lane are longer.
const MOST_CELLS: usize = 500;
/// Cells that are passed over together.
const BLOCK: usize = 16;
/// Lanes of a zone that are compared with each other; a zone that has more is passed over. Real junctions have up to a
/// hundred or two.
const MOST_LANES: usize = 512;
/// Areas that share a strip of at most this width `[m]` only touch: lanes side by side share their border.
const STRIP: f64 = 0.05;
/// Lanes whose heights differ by more than this `[m]` pass over each other: the least clearance of bridges is above it.
const CLEARANCE: f64 = 2.0;

/// Rule that names junctions that are passed over.
const TOO_MANY: &str = "mapd:graph.conflicts";

/// Both ends of a common area on one lane, from its section's start.
type Interval = (f32, f32);

/// A rectangle along the axes.
#[derive(Clone, Copy)]
struct Bounds {
    low: DVec2,
    high: DVec2,
}

impl Bounds {
    fn of(points: impl Iterator<Item = DVec2>) -> Self {
        let none = Self { low: DVec2::INFINITY, high: DVec2::NEG_INFINITY };
        points.fold(none, |all, p| Self { low: all.low.min(p), high: all.high.max(p) })
    }

    fn meets(&self, other: &Self) -> bool {
        self.low.x <= other.high.x
            && self.high.x >= other.low.x
            && self.low.y <= other.high.y
            && self.high.y >= other.low.y
    }
}

/// A side of a quadrangle: the direction across it, and from where to where the quadrangle reaches in that direction.
#[derive(Clone, Copy)]
struct Side {
    normal: DVec2,
    reach: (f64, f64),
}

/// A quadrangle of a lane's area.
struct Cell {
    corners: [DVec2; 4],
    /// Its sides but those that are too short to have a direction.
    sides: [Option<Side>; 4],
    bounds: Bounds,
    z: f64,
    /// From the section's start.
    s_from: f32,
    s_to: f32,
}

/// A lane in a zone.
struct Candidate {
    row: u32,
    road: u32,
    /// Of places on its section `[m]`.
    step: f64,
    cells: Vec<Cell>,
    /// Of [`BLOCK`] cells each.
    blocks: Vec<Bounds>,
    bounds: Bounds,
    entered_from: Vec<LaneId>,
    leads_to: Vec<LaneId>,
}

/// Finds all conflicts, by lane; names the junctions that are passed over.
pub(crate) fn find(rows: &Rows, zones: &[Zone]) -> (Vec<ConflictRow>, Vec<Finding>) {
    let mut passed_over = Vec::new();
    let mut found: Vec<ConflictRow> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let of_zones: Vec<Option<Vec<ConflictRow>>> =
            zones.par_iter().map(|zone| of_zone(rows, map, zone)).collect();
        for (zone, _) in zones.iter().zip(&of_zones).filter(|(_, found)| found.is_none()) {
            let message = format!(
                "expected a junction of at most {MOST_LANES} lanes, found more; their conflicts are not looked for"
            );
            let path = "OpenDRIVE/junction".to_owned();
            passed_over.push(finding(TOO_MANY, Severity::Warning, zone.span, path, message, ""));
        }
        of_zones.into_iter().flatten().flatten().collect()
    };
    // Of a pair that meets in two zones the first place counts.
    found.sort_by_key(|row| (row.lane, row.other, row.from, row.kind));
    found.dedup_by_key(|row| (row.lane, row.other));
    (found, passed_over)
}

fn of_zone(rows: &Rows, map: Map<'_>, zone: &Zone) -> Option<Vec<ConflictRow>> {
    let lanes_of = |stretch: &Stretch| {
        let sections = rows.roads.get(stretch.road as usize).map(|road| road.sections);
        let sections = sections.unwrap_or_default().of(&rows.sections).iter();
        sections.flat_map(|section| section.lanes.first..section.lanes.end() as u32)
    };
    if zone.stretches.iter().flat_map(lanes_of).nth(MOST_LANES).is_some() {
        return None;
    }
    let candidates: Vec<Candidate> = zone
        .stretches
        .iter()
        .flat_map(|stretch| lanes_of(stretch).map(move |lane| (stretch, lane)))
        .filter_map(|(stretch, lane)| candidate(&map.lane_by_row(lane)?, *stretch))
        .collect();
    let mut out = Vec::new();
    for (i, a) in candidates.iter().enumerate() {
        for b in candidates.get(i + 1..).unwrap_or(&[]).iter().filter(|b| b.road != a.road) {
            if let Some((kind, own, other)) = meet(a, b, zone.kind) {
                let row = |a: &Candidate, b: &Candidate, own: Interval, other: Interval| {
                    let [from, to] = in_steps(own, a.step);
                    let [other_from, other_to] = in_steps(other, b.step);
                    ConflictRow {
                        lane: a.row,
                        other: b.row,
                        from,
                        to,
                        other_from,
                        other_to,
                        kind: kind.code(),
                        relation: NO_RELATION,
                        reason: RelationReason::None.code(),
                        reserved: 0,
                    }
                };
                out.push(row(a, b, own, other));
                out.push(row(b, a, other, own));
            }
        }
    }
    Some(out)
}

/// Both ends of an interval in steps of its section, rounded outwards.
fn in_steps((from, to): Interval, step: f64) -> [u16; 2] {
    // Casts saturate.
    [(f64::from(from) / step).floor() as u16, (f64::from(to) / step).ceil() as u16]
}

/// A lane that somebody travels, as far as it lies in a stretch.
fn candidate(lane: &Lane<'_>, Stretch { road, s_from, s_to }: Stretch) -> Option<Candidate> {
    if !lane.nodes().any(|node| node.is_open()) {
        return None;
    }
    let section = lane.section();
    let (from, to) = (section.s_start().max(s_from), section.s_end().min(s_to));
    if from >= to {
        return None;
    }
    let count = (((to - from) / CELL).ceil() as usize).clamp(1, MOST_CELLS);
    let ends: Vec<(f64, [DVec2; 2], f64)> = (0..=count)
        .filter_map(|i| end(lane, from + (to - from) * i as f64 / count as f64))
        .collect();
    let cells: Vec<Cell> = ends
        .windows(2)
        .map(|pair| {
            let corners = [pair[0].1[0], pair[0].1[1], pair[1].1[1], pair[1].1[0]];
            let bounds = Bounds::of(corners.into_iter());
            let offset = |s: f64| (s - section.s_start()) as f32;
            let (s_from, s_to) = (offset(pair[0].0), offset(pair[1].0));
            let sides = sides(&corners);
            Cell { corners, sides, bounds, z: 0.5 * (pair[0].2 + pair[1].2), s_from, s_to }
        })
        .collect();
    let around = |cells: &[Cell]| Bounds::of(cells.iter().flat_map(|cell| cell.corners));
    Some(Candidate {
        row: lane.lane_id().row(),
        road,
        step: section_step(section.s_end() - section.s_start()),
        blocks: cells.chunks(BLOCK).map(around).collect(),
        bounds: around(&cells),
        cells,
        entered_from: lane.predecessors().collect(),
        leads_to: lane.successors().collect(),
    })
}

/// s, both edges and the height of a cross-section.
fn end(lane: &Lane<'_>, s: f64) -> Option<(f64, [DVec2; 2], f64)> {
    let [inner, outer] = lane.edge_points_at(s)?;
    Some((s, [inner.truncate(), outer.truncate()], 0.5 * (inner.z + outer.z)))
}

/// How two lanes meet, and the common interval on each.
fn meet(
    a: &Candidate,
    b: &Candidate,
    zone: ZoneKind,
) -> Option<(ConflictKind, Interval, Interval)> {
    let merge = a.leads_to.iter().any(|lane| b.leads_to.contains(lane));
    let part = a.entered_from.iter().any(|lane| b.entered_from.contains(lane));
    if (part && !merge && zone != ZoneKind::Direct) || !a.bounds.meets(&b.bounds) {
        return None;
    }
    let none = (f32::INFINITY, f32::NEG_INFINITY);
    let (mut own, mut other) = (none, none);
    // Whether the kind does not depend on where the lanes meet.
    let settled = merge || part || zone == ZoneKind::Crossing;
    let mut cross = false;
    let mut hint = 0;
    for one in from_both_ends(&a.cells).filter(|one| one.bounds.meets(&b.bounds)) {
        let blocks = b.cells.chunks(BLOCK).zip(&b.blocks);
        let near = blocks.filter(|(_, bounds)| bounds.meets(&one.bounds));
        for two in near.flat_map(|(cells, _)| cells).filter(|two| one.bounds.meets(&two.bounds)) {
            let known = own.0 <= one.s_from
                && own.1 >= one.s_to
                && other.0 <= two.s_from
                && other.1 >= two.s_to;
            // Within what is known to be common, only a crossing could be news.
            if (known && (settled || cross))
                || (one.z - two.z).abs() > CLEARANCE
                || !overlap(one, two, &mut hint)
            {
                continue;
            }
            own = (own.0.min(one.s_from), own.1.max(one.s_to));
            other = (other.0.min(two.s_from), other.1.max(two.s_to));
            cross |= !settled && centers_cross(one, two);
        }
    }
    if own.0 > own.1 {
        return None;
    }
    let kind = if zone == ZoneKind::Crossing {
        ConflictKind::Crossing
    } else if merge {
        ConflictKind::Merge
    } else if cross {
        ConflictKind::Cross
    } else {
        ConflictKind::Overlap
    };
    Some((kind, own, other))
}

/// Cells from the first and the last one inwards, in turns: what lies between two that are common is soon known.
fn from_both_ends(cells: &[Cell]) -> impl Iterator<Item = &Cell> {
    let mut rest = cells.iter();
    let mut front = false;
    std::iter::from_fn(move || {
        front = !front;
        if front { rest.next() } else { rest.next_back() }
    })
}

/// Whether two convex quadrangles share more than a strip: no edge's normal keeps them apart. `hint` is the edge that kept
/// apart those before, which are likely to lie alike: the first one's, then the other's.
fn overlap(a: &Cell, b: &Cell, hint: &mut usize) -> bool {
    let apart = |at: usize| {
        let (own, other) = if at < 4 { (a, b) } else { (b, a) };
        own.sides.get(at % 4).copied().flatten().is_some_and(|side| {
            let other = reach(&other.corners, side.normal);
            side.reach.1.min(other.1) - side.reach.0.max(other.0) <= STRIP
        })
    };
    if apart(*hint) {
        return false;
    }
    match (0..8).find(|at| at != hint && apart(*at)) {
        Some(at) => {
            *hint = at;
            false
        }
        None => true,
    }
}

fn sides(corners: &[DVec2; 4]) -> [Option<Side>; 4] {
    std::array::from_fn(|i| {
        let edge = corners[(i + 1) % 4] - corners[i];
        let length = edge.length();
        let normal = DVec2::new(-edge.y, edge.x) / length;
        (length >= STRIP).then(|| Side { normal, reach: reach(corners, normal) })
    })
}

/// From where to where a quadrangle reaches along an axis.
fn reach(corners: &[DVec2; 4], axis: DVec2) -> (f64, f64) {
    let along = corners.map(|corner| corner.dot(axis));
    let (low, high) = (f64::INFINITY, f64::NEG_INFINITY);
    along.into_iter().fold((low, high), |(low, high), d| {
        (if d < low { d } else { low }, if d > high { d } else { high })
    })
}

/// Whether the centre lines of two cells cross.
fn centers_cross(a: &Cell, b: &Cell) -> bool {
    let center = |cell: &Cell| {
        [0.5 * (cell.corners[0] + cell.corners[1]), 0.5 * (cell.corners[2] + cell.corners[3])]
    };
    let ([a0, a1], [b0, b1]) = (center(a), center(b));
    let side = |from: DVec2, to: DVec2, p: DVec2| (to - from).perp_dot(p - from);
    side(a0, a1, b0) * side(a0, a1, b1) <= 0.0 && side(b0, b1, a0) * side(b0, b1, a1) <= 0.0
}
