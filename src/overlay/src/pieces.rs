//! Cutting nodes of the lane graph where what is said of them changes.
//!
//! All lanes of a section are cut at the same places, so that a change of lane leads from each piece to the one beside it. As in the map itself, what
//! holds in the middle of a piece holds for all of it, and no piece is shorter than [`SHORTEST_PIECE`].

use mapd_archive::{
    CutsRow, OverlayEntryRow, OverlayNodeRow, OverlayRows, PieceRow, Range, TouchedRow,
    overlay_changes_ways,
};
use mapd_query::compiling::{ByRow as _, extremes_of_joined, is_first_joined};
use mapd_query::graph::LaneNode;
use mapd_query::{Lane, Map, SRange};
use std::cell::Cell;
use std::collections::BTreeMap;

/// Shortest piece `[m]`: a cut nearer than this to an end or to another cut is left out, as when a map is compiled.
pub(crate) const SHORTEST_PIECE: f64 = 0.1;

/// Share by which lengths or times that are equal may differ for having been summed.
const ROUNDING: f64 = 1e-9;

/// Where an entry holds on a node.
#[derive(Clone, Copy)]
pub(crate) struct Mark {
    pub(crate) s_from: f64,
    pub(crate) s_to: f64,
    pub(crate) entry: u32,
    /// Number of the place that it is from, among all places of all entries.
    pub(crate) place: u32,
}

/// Marks by row of the map's nodes.
pub(crate) type Marks = BTreeMap<u32, Vec<Mark>>;

/// Fills the tables of nodes and pieces. Notes of each place whether it holds on a piece: what is shorter than [`SHORTEST_PIECE`] on every lane may hold on none.
pub(crate) fn fill(map: Map<'_>, marks: &Marks, rows: &mut OverlayRows, held: &mut [bool]) {
    let cuts = cuts(map, marks);
    let own = |marks: &Vec<Mark>| vehicles(marks, &rows.entries);
    let mut touched: BTreeMap<u32, (&[f64], u16)> =
        marks.iter().map(|(node, marks)| (*node, (&[][..], own(marks)))).collect();
    for (first, cuts) in cuts.iter().filter(|(_, cuts)| !cuts.is_empty()) {
        let together = || map.lane_node_by_row(*first).into_iter().flat_map(|node| beside(&node));
        let all = together().filter_map(|node| marks.get(&row(&node)).map(own));
        let all = all.fold(0, |all, own| all | own);
        for node in together() {
            touched.insert(row(&node), (cuts, all));
        }
    }
    for (number, (cuts, vehicles)) in touched {
        let Some(node) = map.lane_node_by_row(number) else { continue };
        let first = rows.pieces.len() as u32;
        cut(&node, cuts, marks.get(&number).map_or(&[][..], Vec::as_slice), rows, held);
        let pieces = Range { first, count: rows.pieces.len() as u32 - first };
        rows.nodes.push(OverlayNodeRow { node: number, pieces });
        rows.node_vehicles.push(vehicles);
    }
    let by_cuts = saved(map, rows);
    rows.cuts.push(by_cuts);
    let words = rows.nodes.last().map_or(0, |node| node.node as usize / 64 + 1);
    let mut bits = vec![0_u64; words];
    for node in rows.nodes.iter() {
        bits[node.node as usize / 64] |= 1 << (node.node % 64);
    }
    let mut rank = 0;
    for bits in bits {
        rows.touched.push(TouchedRow { bits, rank, reserved: 0 });
        rank += bits.count_ones();
    }
}

/// What cutting nodes does to bounds: who changes lanes in the middle of nodes drives only a part of each, where the map's bounds have one of them whole. At least the shortest
/// of each piece is left. A way leaves each lane of them once at most.
fn saved(map: Map<'_>, rows: &OverlayRows) -> CutsRow {
    let mut row =
        CutsRow { length_saved: 0.0, length_factor: 1.0, time_saved: 0.0, time_factor: 1.0 };
    for own in rows.nodes.iter().filter(|own| own.pieces.count > 1) {
        let Some(node) = map.lane_node_by_row(own.node) else { continue };
        let pieces = own.pieces.of(&rows.pieces);
        if !is_first_joined(&node) {
            continue;
        }
        let add = |saved: &mut f64, factor: &mut f64, part: &dyn Fn(&Lane<'_>, f64, f64) -> f64| {
            let lanes = Cell::new(0.0);
            let whole = |node: &LaneNode<'_>| {
                lanes.set(lanes.get() + 1.0);
                let lane = node.lane();
                lane.map_or(f64::INFINITY, |lane| {
                    pieces.iter().map(|piece| part(&lane, piece.s_from, piece.s_to)).sum()
                })
            };
            let [_, most] = extremes_of_joined(&node, whole);
            let least = pieces.iter().map(|piece| {
                let of = |node: &LaneNode<'_>| {
                    node.lane().map_or(0.0, |lane| part(&lane, piece.s_from, piece.s_to))
                };
                extremes_of_joined(&node, of)[0]
            });
            let least: f64 = least.sum();
            if most * (1.0 - ROUNDING) > least {
                *saved = (*saved + (most - least) * lanes.get()).min(f64::MAX);
                *factor = factor.min(least / most);
            }
        };
        add(&mut row.length_saved, &mut row.length_factor, &|lane, from, to| {
            lane.length_between(from, to)
        });
        add(&mut row.time_saved, &mut row.time_factor, &|lane, from, to| {
            lane.time_between(from, to)
        });
    }
    row
}

/// Classes of vehicles for which marks close, open or slow something.
fn vehicles(marks: &[Mark], entries: &[OverlayEntryRow]) -> u16 {
    let entries = marks.iter().filter_map(|mark| entries.get(mark.entry as usize));
    let routed = entries.filter(|entry| overlay_changes_ways(entry.kind));
    routed.fold(0, |all, entry| all | entry.vehicles)
}

/// Places at which the nodes beside each other are cut, by the first row of them, ascending.
fn cuts(map: Map<'_>, marks: &Marks) -> BTreeMap<u32, Vec<f64>> {
    let mut wanted: BTreeMap<u32, Vec<f64>> = BTreeMap::new();
    for (number, own) in marks {
        let Some(node) = map.lane_node_by_row(*number) else { continue };
        let Some(first) = beside(&node).map(|node| row(&node)).min() else { continue };
        let places = wanted.entry(first).or_default();
        places.extend(own.iter().flat_map(|mark| [mark.s_from, mark.s_to]));
    }
    for (number, places) in &mut wanted {
        places.sort_by(f64::total_cmp);
        let node = map.lane_node_by_row(*number);
        let SRange { low: mut last, high: end } =
            node.map(|node| node.s_range()).unwrap_or_default();
        places.retain(|s| {
            let keeps = s - last >= SHORTEST_PIECE && end - s >= SHORTEST_PIECE;
            if keeps {
                last = *s;
            }
            keeps
        });
    }
    wanted
}

/// Cuts a node into pieces, in driving order.
fn cut(
    node: &LaneNode<'_>,
    cuts: &[f64],
    marks: &[Mark],
    rows: &mut OverlayRows,
    held: &mut [bool],
) {
    let SRange { low: start, high: end } = node.s_range();
    let mut ends: Vec<f64> = cuts.to_vec();
    ends.insert(0, start);
    ends.push(end);
    let spans = ends.windows(2).map(|pair| [pair[0], pair[1]]);
    let mut spans: Vec<_> = spans.zip(held_on(&ends, marks, held)).collect();
    if !node.is_forward() {
        spans.reverse();
    }
    let Some(lane) = node.lane() else { return };
    let whole = node.length();
    let own = rows.nodes.len() as u32;
    let mut passed = 0.0;
    for ([s_from, s_to], entries) in spans {
        let first = rows.piece_entries.len() as u32;
        rows.piece_entries.extend_from_slice(&entries);
        let is_whole = cuts.is_empty();
        let length = if is_whole { whole } else { lane.length_between(s_from, s_to) };
        let time = if is_whole { node.travel_time() } else { lane.time_between(s_from, s_to) };
        rows.pieces.push(PieceRow {
            s_from,
            s_to,
            node: own,
            entries: Range { first, count: entries.len() as u32 },
            before: if whole > 0.0 { (passed / whole).min(1.0) as f32 } else { 0.0 },
            length: length as f32,
            time: time as f32,
        });
        passed += length;
    }
}

/// The entries that hold in the middle of each part between two ends, ascending. Notes of their places that they hold.
fn held_on(ends: &[f64], marks: &[Mark], held: &mut [bool]) -> Vec<Vec<u32>> {
    let mut later: Vec<&Mark> = marks.iter().collect();
    later.sort_by(|a, b| b.s_from.total_cmp(&a.s_from));
    let mut open: Vec<&Mark> = Vec::new();
    let parts = ends.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let of = |middle: f64| {
        while let Some(mark) = later.pop_if(|mark| mark.s_from <= middle) {
            open.push(mark);
        }
        open.retain(|mark| middle <= mark.s_to);
        for mark in &open {
            held.get_mut(mark.place as usize).into_iter().for_each(|held| *held = true);
        }
        let mut entries: Vec<u32> = open.iter().map(|mark| mark.entry).collect();
        entries.sort_unstable();
        entries.dedup();
        entries
    };
    parts.map(of).collect()
}

fn row(node: &LaneNode<'_>) -> u32 {
    node.node_id().row()
}

/// The nodes that a node is cut together with: those of all the section's lanes over the same stretch, as when a map is compiled. It is among them.
fn beside<'a>(node: &LaneNode<'a>) -> impl Iterator<Item = LaneNode<'a>> + use<'a> {
    let SRange { low: start, high: _ } = node.s_range();
    let lanes = node.lane().into_iter().flat_map(|lane| lane.section().lanes());
    let nodes = lanes.flat_map(|lane| lane.nodes());
    nodes.filter(move |other| other.s_range().low == start)
}
