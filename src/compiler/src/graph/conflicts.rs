//! Lanes of different roads whose areas meet within a junction: they cross, merge or overlap.
//!
//! Each lane is cut into short cells, quadrangles between its edges. Where cells of two lanes share more than a strip, the
//! lanes conflict; the interval on each reaches from the first to the last such cell. So intervals are too long by
//! at most a cell at either end, and never too short by more than what the chords cut off. Ways that only part from each
//! other are no conflict: who follows one has left the other, be it from its middle, as at virtual junctions. At direct
//! junctions they are: there, lanes that part lie on each other for a while. Who enters the middle of a lane merges into it.

use super::cells::{Bounds, Cell};
use super::zones::{Stretch, Zone, ZoneKind};
use crate::findings::finding;
use crate::sample::view;
use mapd_archive::{ConflictKind, ConflictRow, NO_RELATION, RelationReason, Rows, section_step};
use mapd_query::compiling::ByRow as _;
use mapd_query::compiling::SectionCutter;
use mapd_query::graph::LaneNode;
use mapd_query::roads::CrossSection;
use mapd_query::{Lane, LaneId, LaneSection, Map};
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity};
use rayon::prelude::*;
use std::ops::{Range, RangeInclusive};

/// Longest cell `[m]`.
const CELL: f64 = 0.5;
/// Cells of one lane at most; those of a longer lane are longer.
const MOST_CELLS: usize = 500;
/// Cells that are passed over together.
const BLOCK: usize = 8;
/// Lanes of a zone that are compared with each other; a zone that has more is passed over. Real junctions have up to a
/// hundred or two.
const MOST_LANES: usize = 512;
/// Lanes whose heights differ by more than this `[m]` pass over each other: the least clearance of bridges is above it.
const CLEARANCE: f64 = 2.0;

/// Both ends of a common area on one lane, from its section's start.
type Interval = (f32, f32);

/// A lane in a zone; its ranges are of the zone's [`Room`].
struct Candidate {
    row: u32,
    road: u32,
    /// Of places on its section `[m]`.
    step: f64,
    cells: Range<usize>,
    blocks: Range<usize>,
    bounds: Bounds,
    /// Lanes from which it is entered.
    entries: Range<usize>,
    /// Lanes that it leads to.
    exits: Range<usize>,
}

/// What the lanes of a zone are made of, lane by lane. The next zone uses the same memory.
#[derive(Default)]
struct Room {
    cells: Vec<Cell>,
    /// Of each cell, apart from them: most cells are passed over by their bounds.
    around_cells: Vec<Bounds>,
    /// Of [`BLOCK`] cells of a lane each.
    blocks: Vec<Bounds>,
    links: Vec<LaneId>,
    /// Where a section is cut.
    cuts: Vec<(f64, CrossSection)>,
}

/// The cells of a lane, or some that stand behind each other.
struct Area<'a> {
    cells: &'a [Cell],
    around_cells: &'a [Bounds],
    blocks: &'a [Bounds],
    bounds: Bounds,
}

/// Finds all conflicts, by lane; names the junctions that are passed over.
pub(crate) fn find(rows: &Rows, zones: &[Zone]) -> (Vec<ConflictRow>, Vec<Finding>) {
    let mut passed_over = Vec::new();
    let mut found: Vec<ConflictRow> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let of_zone = |room: &mut Room, zone| of_zone(rows, map, zone, room);
        let of_zones: Vec<Option<Vec<ConflictRow>>> =
            zones.par_iter().map_init(Room::default, of_zone).collect();
        for (zone, _) in zones.iter().zip(&of_zones).filter(|(_, found)| found.is_none()) {
            let message = format!(
                "expected a junction of at most {MOST_LANES} lanes, found more; their conflicts are not looked for"
            );
            let path = "OpenDRIVE/junction".to_owned();
            passed_over.push(finding(
                &building::CONFLICTS,
                Severity::Warning,
                zone.span,
                path,
                message,
                "",
            ));
        }
        of_zones.into_iter().flatten().collect::<Vec<_>>().concat()
    };
    // Of a pair that meets in two zones the first place counts. Those of each zone are in this order already.
    found.sort_by_key(in_table);
    found.dedup_by_key(|row| (row.lane, row.other));
    (found, passed_over)
}

fn of_zone(rows: &Rows, map: Map<'_>, zone: &Zone, room: &mut Room) -> Option<Vec<ConflictRow>> {
    let lanes_of = |stretch: &Stretch| {
        let sections = rows.roads.get(stretch.road as usize).map(|road| road.sections);
        let sections = sections.unwrap_or_default().of(&rows.sections).iter();
        sections.flat_map(|section| section.lanes.first..section.lanes.end() as u32)
    };
    if zone.stretches.iter().flat_map(lanes_of).nth(MOST_LANES).is_some() {
        return None;
    }
    room.clear();
    let mut candidates = Vec::new();
    for stretch in &zone.stretches {
        for section in sections_of(rows, map, *stretch) {
            room.add_section(map, section, *stretch, &mut candidates);
        }
    }
    let mut out = Vec::new();
    for (i, a) in candidates.iter().enumerate() {
        for b in candidates.get(i + 1..).unwrap_or(&[]).iter().filter(|b| b.road != a.road) {
            if let Some((kind, own, other)) = room.meet(map, a, b, zone.kind) {
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
    out.sort_by_key(in_table);
    Some(out)
}

/// What conflicts are ordered by.
fn in_table(row: &ConflictRow) -> (u32, u32, u16, u8) {
    (row.lane, row.other, row.from, row.kind)
}

/// Both ends of an interval in steps of its section, rounded outwards.
fn in_steps((from, to): Interval, step: f64) -> [u16; 2] {
    // Casts saturate.
    [(f64::from(from) / step).floor() as u16, (f64::from(to) / step).ceil() as u16]
}

/// The sections of a stretch's road.
fn sections_of<'a>(
    rows: &Rows,
    map: Map<'a>,
    stretch: Stretch,
) -> impl Iterator<Item = LaneSection<'a>> + use<'a> {
    let road = rows.roads.get(stretch.road as usize);
    let sections = road.map(|road| road.sections.rows(rows.sections.len())).unwrap_or_default();
    sections.filter_map(move |section| map.section_by_row(section))
}

fn around(cells: &[Bounds]) -> Bounds {
    cells.iter().fold(Bounds::NONE, |all, cell| all.with(cell))
}

impl Room {
    fn clear(&mut self) {
        self.cells.clear();
        self.around_cells.clear();
        self.blocks.clear();
        self.links.clear();
    }

    /// Adds the lanes of a section that somebody travels, as far as they lie in the stretch.
    fn add_section(
        &mut self,
        map: Map<'_>,
        section: LaneSection<'_>,
        stretch: Stretch,
        candidates: &mut Vec<Candidate>,
    ) {
        let (start, end) = (section.s_start(), section.s_end());
        let (from, to) = (start.max(stretch.s_from), end.min(stretch.s_to));
        let is_open = |lane: &Lane<'_>| lane.nodes().any(|node| node.is_open());
        let lanes = section.lanes().enumerate().filter(|(_, lane)| is_open(lane));
        let mut lanes = lanes.peekable();
        let Some(mut cutter) = SectionCutter::new(section).filter(|_| from < to) else { return };
        if lanes.peek().is_none() {
            return;
        }
        let count = (((to - from) / CELL).ceil() as usize).clamp(1, MOST_CELLS);
        let places = (0..=count).map(|i| from + (to - from) * i as f64 / count as f64);
        self.cuts.clear();
        self.cuts.extend(places.filter_map(|s| Some((s, cutter.cut(s)?))));
        let step = section_step(end - start);
        for (at, lane) in lanes {
            let [cells, blocks] = self.add_cells(map, &mut cutter, at, start);
            let bounds = around(self.blocks.get(blocks.clone()).unwrap_or_default());
            let entries = self.add_links(lane.predecessors());
            let exits = self.add_links(lane.successors());
            let (row, road) = (lane.lane_id().row(), stretch.road);
            candidates.push(Candidate { row, road, step, cells, blocks, bounds, entries, exits });
        }
    }

    /// Adds the cells of the lane that is the `at`-th of a section from the left, between its cuts, and their blocks.
    fn add_cells(
        &mut self,
        map: Map<'_>,
        cutter: &mut SectionCutter<'_>,
        at: usize,
        s_start: f64,
    ) -> [Range<usize>; 2] {
        let (first, first_block) = (self.cells.len(), self.blocks.len());
        let origin = map.local_origin().extend(0.0);
        let ends = self.cuts.iter().filter_map(|(s, cut)| {
            let edges = cutter.lane_edges(at, *s)?;
            let [inner, outer] = [edges.inner, edges.outer].map(|t| origin + cut.place(t));
            let s = (s - s_start) as f32;
            Some((s, [inner.truncate(), outer.truncate()], 0.5 * (inner.z + outer.z)))
        });
        let mut before = None;
        for end in ends {
            if let Some((s, edges, z)) = before.replace(end) {
                let cell = Cell::new([edges, end.1], 0.5 * (z + end.2), [s, end.0]);
                self.around_cells.push(cell.bounds());
                self.cells.push(cell);
            }
        }
        let own = self.around_cells.get(first..).unwrap_or_default();
        self.blocks.extend(own.chunks(BLOCK).map(around));
        [first..self.cells.len(), first_block..self.blocks.len()]
    }

    fn add_links(&mut self, lanes: impl Iterator<Item = LaneId>) -> Range<usize> {
        let first = self.links.len();
        self.links.extend(lanes);
        first..self.links.len()
    }

    /// How two lanes meet, and the common interval on each.
    fn meet(
        &self,
        map: Map<'_>,
        a: &Candidate,
        b: &Candidate,
        zone: ZoneKind,
    ) -> Option<(ConflictKind, Interval, Interval)> {
        if !a.bounds.meets(&b.bounds) {
            return None;
        }
        let links = |range: &Range<usize>| self.links.get(range.clone()).unwrap_or_default();
        let have_one = |a: &Range<usize>, b: &Range<usize>| {
            let (a, b) = (links(a), links(b));
            a.iter().any(|lane| b.contains(lane))
        };
        let (mut merge, mut part) =
            (have_one(&a.exits, &b.exits), have_one(&a.entries, &b.entries));
        for (from, to) in [(a, b), (b, a)] {
            if links(&from.exits).iter().any(|lane| lane.row() == to.row) {
                let [leaves, enters] = inside(map, from.row, to.row);
                part |= leaves && !enters;
                merge |= enters;
            }
        }
        if part && !merge && zone != ZoneKind::Direct {
            return None;
        }
        let (a, b) = (self.area(a), self.area(b));
        let own = a.common(&b)?;
        // Nothing of the other lane is common to cells outside these.
        let near_a = a.around(&own);
        let other = b.common(&near_a)?;
        let kind = if zone == ZoneKind::Crossing {
            ConflictKind::Crossing
        } else if merge {
            ConflictKind::Merge
        } else if !part && near_a.crosses(&b.around(&other)) {
            ConflictKind::Cross
        } else {
            ConflictKind::Overlap
        };
        Some((kind, a.interval(&own)?, b.interval(&other)?))
    }

    fn area(&self, lane: &Candidate) -> Area<'_> {
        Area {
            cells: self.cells.get(lane.cells.clone()).unwrap_or_default(),
            around_cells: self.around_cells.get(lane.cells.clone()).unwrap_or_default(),
            blocks: self.blocks.get(lane.blocks.clone()).unwrap_or_default(),
            bounds: lane.bounds,
        }
    }
}

/// Whether a lane leads into another from its own middle, so that all who follow it that way have left it; and whether it leads into the other's middle.
fn inside(map: Map<'_>, from: u32, to: u32) -> [bool; 2] {
    let Some(lane) = map.lane_by_row(from) else { return [false; 2] };
    let goes_on = |node: &LaneNode<'_>| {
        node.edges().any(|edge| edge.target().is_some_and(|next| are_along(&next, node)))
    };
    let mut found = [false; 2];
    for node in lane.nodes() {
        let targets = node.edges().filter_map(|edge| edge.target());
        for target in targets.filter(|target| is_of(target, to)) {
            found[0] |= goes_on(&node);
            found[1] |= target.predecessors().any(|before| are_along(&before, &target));
        }
    }
    // Who comes the other way meets those who leave.
    found[0] &= !lane.is_bidirectional();
    found
}

fn is_of(node: &LaneNode<'_>, lane: u32) -> bool {
    node.lane().is_some_and(|own| own.lane_id().row() == lane)
}

/// Whether both are pieces of one lane in one direction.
fn are_along(one: &LaneNode<'_>, other: &LaneNode<'_>) -> bool {
    let row = other.lane().map(|lane| lane.lane_id().row());
    one.is_forward() == other.is_forward() && row.is_some_and(|row| is_of(one, row))
}

/// Whether two cells whose bounds meet share more than a strip, and not as a bridge does with what is below.
fn share(one: &Cell, two: &Cell, hint: &mut usize) -> bool {
    // Heights that are no numbers keep nothing apart.
    let apart = (one.z - two.z).abs() > CLEARANCE;
    !apart && one.overlaps(two, hint)
}

impl<'a> Area<'a> {
    /// From the first to the last cell that shares more than a strip with another lane; cells in between do not matter.
    fn common(&self, other: &Area<'_>) -> Option<RangeInclusive<usize>> {
        let mut hint = 0;
        let mut is_common = |one: &Cell, two: &Cell| share(one, two, &mut hint);
        let first = self.first_near(other, false, &mut is_common)?;
        let last = self.first_near(other, true, &mut is_common)?;
        Some(first..=last)
    }

    /// Whether the centre lines of two lanes cross where the lanes share more than a strip.
    fn crosses(&self, other: &Area<'_>) -> bool {
        let mut hint = 0;
        let crosses = |one: &Cell, two: &Cell| one.centers_cross(two) && share(one, two, &mut hint);
        self.first_near(other, false, crosses).is_some()
    }

    /// The blocks that have these cells.
    fn around(&self, cells: &RangeInclusive<usize>) -> Self {
        let blocks = cells.start() / BLOCK..cells.end() / BLOCK + 1;
        let cells = blocks.start * BLOCK..self.cells.len().min(blocks.end * BLOCK);
        let blocks = self.blocks.get(blocks).unwrap_or_default();
        Self {
            cells: self.cells.get(cells.clone()).unwrap_or_default(),
            around_cells: self.around_cells.get(cells).unwrap_or_default(),
            blocks,
            bounds: around(blocks),
        }
    }

    /// Where these cells begin and end.
    fn interval(&self, cells: &RangeInclusive<usize>) -> Option<Interval> {
        Some((self.cells.get(*cells.start())?.s_from, self.cells.get(*cells.end())?.s_to))
    }

    /// Number of the first cell, or the last one, for which some cell of the other lane fits whose bounds meet its own.
    fn first_near(
        &self,
        other: &Area<'_>,
        backwards: bool,
        mut fits: impl FnMut(&Cell, &Cell) -> bool,
    ) -> Option<usize> {
        let turned = |i: usize, count: usize| if backwards { count - 1 - i } else { i };
        for i in 0..self.blocks.len() {
            let block = turned(i, self.blocks.len());
            let bounds = self.blocks.get(block)?;
            if !other.bounds.meets(bounds) {
                continue;
            }
            // The other's blocks that may meet any of these cells, from the first to the last.
            let Some(from) = other.blocks.iter().position(|block| block.meets(bounds)) else {
                continue;
            };
            let to = other.blocks.iter().rposition(|block| block.meets(bounds)).unwrap_or(from);
            let blocks = other.blocks.get(from..=to)?;
            let (cells, around_cells) = self.of_block(block);
            for i in 0..cells.len() {
                let at = turned(i, cells.len());
                let (one, bounds) = (cells.get(at)?, around_cells.get(at)?);
                for (two, around_block) in (from..).zip(blocks) {
                    if !around_block.meets(bounds) {
                        continue;
                    }
                    let (cells, around_cells) = other.of_block(two);
                    let mut others = around_cells.iter().zip(cells);
                    if others.any(|(around, two)| around.meets(bounds) && fits(one, two)) {
                        return Some(block * BLOCK + at);
                    }
                }
            }
        }
        None
    }

    /// The cells of a block, and what is around each.
    fn of_block(&self, block: usize) -> (&'a [Cell], &'a [Bounds]) {
        let from = block * BLOCK;
        let range = from..self.cells.len().min(from + BLOCK);
        let (cells, bounds) = (self.cells.get(range.clone()), self.around_cells.get(range));
        (cells.unwrap_or(&[]), bounds.unwrap_or(&[]))
    }
}
