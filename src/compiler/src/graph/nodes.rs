//! Nodes: a lane, or a piece of one, travelled in one direction.

use super::cuts::Cuts;
use super::widths;
use crate::draft::Draft;
use crate::findings::TooLarge;
use mapd_archive::{
    LaneNodeRow, LaneRow, LaneType, NONE, NOT_BESIDE, Rows, SectionRow, beside_of, lane_flags,
    node_flags,
};

/// Appends the nodes of all lanes, then joins those beside each other.
pub(crate) fn build(draft: &mut Draft, cuts: &Cuts) -> Result<(), TooLarge> {
    for lane in 0..draft.rows.lanes.len() {
        add(draft, cuts, lane)?;
        if draft.rows.lane_nodes.len() >= NONE as usize {
            return Err(TooLarge::new("lane_nodes"));
        }
    }
    for node in 0..draft.rows.lane_nodes.len() {
        join(draft, node as u32)?;
    }
    Ok(())
}

fn add(draft: &mut Draft, cuts: &Cuts, lane: usize) -> Result<(), TooLarge> {
    let has_nodes = |row: &LaneRow| row.number != 0 && row.flags & lane_flags::TEMPORARY == 0;
    let Some(row) = draft.rows.lanes.get(lane).copied().filter(has_nodes) else {
        return Ok(());
    };
    let before = draft.rows.lane_nodes.len();
    let offsets = cuts.of(row.section);
    let section = draft.rows.sections.get(row.section as usize);
    let length = section.map_or(0.0, |section| section.s_end - section.s_start);
    let forward = row.flags & lane_flags::FORWARD != 0;
    let ways = 1 + usize::from(row.flags & lane_flags::TWO_WAY != 0);
    for way in [forward, !forward].into_iter().take(ways) {
        let pieces = offsets.len() + 1;
        for i in 0..pieces {
            let piece = if way { i } else { pieces - 1 - i };
            let s_from = piece.checked_sub(1).and_then(|i| offsets.get(i)).copied().unwrap_or(0.0);
            let s_to = offsets.get(piece).map_or(length, |s| f64::from(*s));
            let middle = 0.5 * (f64::from(s_from) + s_to);
            let kind = LaneType::from_code(row.kind);
            let mut access = draft.permissions.classes(lane as u32, kind, middle);
            if !has_width(&draft.rows, &row, middle) {
                access = 0;
            }
            draft.rows.lane_nodes.push(LaneNodeRow {
                lane: lane as u32,
                left: NOT_BESIDE,
                right: NOT_BESIDE,
                component: 0,
                bound: NONE,
                s_from,
                length: 0.0,
                time: 0.0,
                anchor_length: 0,
                anchor_time: 0,
                access,
                flags: if way { node_flags::FORWARD } else { 0 },
                reserved: 0,
            });
        }
    }
    let (Ok(first), Ok(count)) =
        (u32::try_from(before), u16::try_from(draft.rows.lane_nodes.len() - before))
    else {
        return Err(TooLarge::of_lane("lane_nodes", &draft.rows, lane as u32));
    };
    if let Some(row) = draft.rows.lanes.get_mut(lane) {
        (row.first_node, row.node_count) = (first, count);
    }
    Ok(())
}

/// Whether a lane is more than a line around a place: a stretch of no width may be linked, but nobody drives there.
fn has_width(rows: &Rows, lane: &LaneRow, offset: f64) -> bool {
    if lane.flags & lane_flags::BORDER != 0 {
        return true;
    }
    let Some(section) = rows.sections.get(lane.section as usize) else { return false };
    let ends = [section.s_start, section.s_end];
    widths::has_width(lane.widths().of(&rows.cubics), ends, offset)
}

/// Joins a node with the one on either side that travels the same way and may be used by somebody who may use this one;
/// says whether the border's marks allow the change.
fn join(draft: &mut Draft, node: u32) -> Result<(), TooLarge> {
    let rows = &draft.rows;
    let Some(own) = rows.lane_nodes.get(node as usize).copied() else { return Ok(()) };
    let Some(lane) = rows.lanes.get(own.lane as usize) else { return Ok(()) };
    let Some(section) = rows.sections.get(lane.section as usize) else { return Ok(()) };
    let forward = own.flags & node_flags::FORWARD != 0;
    let pieces = pieces(lane);
    let in_order = (node - lane.nodes().first) % pieces;
    let (mut joined, mut allowed) = ([NOT_BESIDE; 2], 0);
    // Rows run from left to right of the reference line, which is from right to left for who travels towards −s.
    for (side, to_lower_row) in [(0, forward), (1, !forward)] {
        let Some(beside) = beside(rows, section, own.lane, to_lower_row) else { continue };
        let Some(target) = rows.lanes.get(beside as usize) else { continue };
        let Some(first) = first_node(target, forward) else { continue };
        let other = first + in_order;
        if rows.lane_nodes.get(other as usize).is_none_or(|row| row.access & own.access == 0) {
            continue;
        }
        joined[side] = beside_of(node, other)
            .ok_or_else(|| TooLarge::of_lane("lane_nodes", rows, own.lane))?;
        let (increase, decrease) = permission(draft, cuts_middle(rows, node), own.lane, beside);
        if if target.number > lane.number { increase } else { decrease } {
            allowed |= [node_flags::CHANGE_LEFT, node_flags::CHANGE_RIGHT][side];
        }
    }
    if let Some(row) = draft.rows.lane_nodes.get_mut(node as usize) {
        [row.left, row.right] = joined;
        row.flags |= allowed;
    }
    Ok(())
}

/// Pieces that a lane is cut into.
pub(crate) fn pieces(lane: &LaneRow) -> u32 {
    let ways = if lane.flags & lane_flags::TWO_WAY != 0 { 2 } else { 1 };
    (lane.nodes().count / ways).max(1)
}

/// The first node, in driving order, of a lane's travel towards +s or −s; none if it is not travelled that way.
pub(crate) fn first_node(lane: &LaneRow, forward: bool) -> Option<u32> {
    if lane.nodes().count == 0 {
        return None;
    }
    if (lane.flags & lane_flags::FORWARD != 0) == forward {
        return Some(lane.nodes().first);
    }
    (lane.flags & lane_flags::TWO_WAY != 0).then(|| lane.nodes().first + pieces(lane))
}

/// Middle of a node's piece, from the section's start.
fn cuts_middle(rows: &Rows, node: u32) -> f64 {
    let (from, to) = piece_ends(rows, node);
    0.5 * (from + to)
}

/// Both ends of a node's piece, from the section's start; the smaller first.
pub(crate) fn piece_ends(rows: &Rows, node: u32) -> (f64, f64) {
    let Some(own) = rows.lane_nodes.get(node as usize) else { return (0.0, 0.0) };
    let Some(lane) = rows.lanes.get(own.lane as usize) else { return (0.0, 0.0) };
    let section = rows.sections.get(lane.section as usize);
    let length = section.map_or(0.0, |section| section.s_end - section.s_start);
    let in_order = (node - lane.nodes().first) % pieces(lane);
    let forward = own.flags & node_flags::FORWARD != 0;
    // The piece beyond, towards +s, is the next in driving order or the one before.
    let beyond = if forward {
        (in_order + 1 < pieces(lane)).then(|| node + 1)
    } else {
        (in_order > 0).then(|| node - 1)
    };
    let to = beyond.and_then(|node| rows.lane_nodes.get(node as usize));
    (f64::from(own.s_from), to.map_or(length, |row| f64::from(row.s_from)))
}

/// The next lane row of a section to the left or right of the reference line's direction; lane 0 is skipped.
fn beside(rows: &Rows, section: &SectionRow, lane: u32, to_lower_row: bool) -> Option<u32> {
    let mut at = lane;
    loop {
        at = if to_lower_row { at.checked_sub(1)? } else { at + 1 };
        if at < section.lanes.first || u64::from(at) >= section.lanes.end() {
            return None;
        }
        if rows.lanes.get(at as usize)?.number != 0 {
            return Some(at);
        }
    }
}

/// What the marks between two lanes beside each other allow: to higher and to lower numbers. The inner lane's marks lie
/// on the shared border; between ±1 it is lane 0's.
fn permission(draft: &Draft, s: f64, a: u32, b: u32) -> (bool, bool) {
    let number = |lane: u32| draft.rows.lanes.get(lane as usize).map_or(0, |row| row.number);
    let shared = if (number(a) > 0) != (number(b) > 0) {
        a.min(b) + 1
    } else if number(a).unsigned_abs() < number(b).unsigned_abs() {
        a
    } else {
        b
    };
    draft.permissions.changes(shared, s)
}
