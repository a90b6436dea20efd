//! Rings of roundabouts: lanes from which a way leads round within a junction group and back.

use super::components::strong_components;
use mapd_archive::{JunctionGroupKind, LinkKind, NONE, Range, RoadRow, Rows};

/// Fills the rings of groups that are roundabouts, once the lane graph has its edges. Linear in the graph: of groups that
/// share a junction or road, the first has it.
pub(crate) fn rings(rows: &mut Rows) {
    let is_ring = |kind: u8| kind == JunctionGroupKind::Roundabout.code();
    if !rows.junction_groups.iter().any(|group| is_ring(group.kind)) {
        return;
    }
    let mut of_junction = vec![NONE; rows.junctions.len()];
    for (number, group) in (0..).zip(rows.junction_groups.iter()).filter(|(_, g)| is_ring(g.kind)) {
        for member in group.members.of(&rows.junction_group_members) {
            if let Some(of) = of_junction.get_mut(member.junction as usize) {
                *of = number.min(*of);
            }
        }
    }
    let of_road: Vec<u32> = rows.roads.iter().map(|road| group_of(road, &of_junction)).collect();
    let of_node: Vec<u32> = rows
        .lane_nodes
        .iter()
        .map(|node| {
            let section = rows.lanes.get(node.lane as usize).map(|lane| lane.section);
            let road =
                section.and_then(|section| rows.sections.get(section as usize)).map(|s| s.road);
            road.and_then(|road| of_road.get(road as usize)).copied().unwrap_or(NONE)
        })
        .collect();
    let own = |node: u32| of_node.get(node as usize).copied().unwrap_or(NONE);
    let order: Vec<u32> =
        (0..rows.lane_nodes.len() as u32).filter(|node| own(*node) != NONE).collect();
    let within = |from: u32, to: u32| own(from) == own(to);
    let (component, count) = strong_components(rows, &order, within);
    let mut sizes = vec![0u32; count as usize];
    for node in &order {
        if let Some(size) = sizes.get_mut(component[*node as usize] as usize) {
            *size += 1;
        }
    }
    // A component of several nodes goes round.
    let goes_round = |node: &&u32| {
        let size = sizes.get(component[**node as usize] as usize);
        size.is_some_and(|size| *size > 1)
    };
    let mut ring: Vec<(u32, u32)> = order
        .iter()
        .filter(goes_round)
        .map(|node| (own(*node), rows.lane_nodes[*node as usize].lane))
        .collect();
    ring.sort_unstable();
    ring.dedup();
    for of_group in ring.chunk_by(|a, b| a.0 == b.0) {
        let before = rows.ring_lanes.len();
        rows.ring_lanes.extend(of_group.iter().map(|(_, lane)| *lane));
        let range = Range::between(before, rows.ring_lanes.len()).unwrap_or_default();
        let group = of_group.first().map_or(NONE, |(group, _)| *group);
        if let Some(group) = rows.junction_groups.get_mut(group as usize) {
            group.ring = range;
        }
    }
}

/// The group that a road lies in: that of its junction, or of the junctions at both of its ends.
fn group_of(road: &RoadRow, of_junction: &[u32]) -> u32 {
    let of = |junction: u32| of_junction.get(junction as usize).copied().unwrap_or(NONE);
    if road.junction != NONE {
        return of(road.junction);
    }
    let junction = LinkKind::Junction.code();
    if road.predecessor_kind != junction || road.successor_kind != junction {
        return NONE;
    }
    let (before, behind) = (of(road.predecessor), of(road.successor));
    if before == behind { before } else { NONE }
}
