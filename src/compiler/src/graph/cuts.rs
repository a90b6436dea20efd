//! Where sections are cut into pieces: wherever who may do what changes, and where virtual junctions and paths
//! across the road attach.
//!
//! All lanes of a section are cut at the same places, so that the pieces beside each other are known by their number and
//! a change of lane is allowed over a whole piece or not at all. Cuts never show in a `LaneKey`.

use super::{Source, cross_paths, virtual_connections, widths};
use crate::draft::{Draft, between};
use mapd_archive::{LaneType, Range, VehicleClass, lane_flags};
use mapd_rules::network::{Contact, LinkTarget};

/// Shortest piece `[m]`: a cut nearer than this to an end or to another cut is left out. What holds in the middle of a
/// piece holds for all of it, so a permission is off by at most half of this.
pub(crate) const SHORTEST_PIECE: f64 = 0.1;

/// Cuts of all sections.
pub(crate) struct Cuts {
    /// Per section a range of `offsets`.
    ranges: Vec<Range>,
    /// Ascending, from the section's start.
    offsets: Vec<f32>,
}

impl Cuts {
    pub(crate) fn new(source: Source<'_>) -> Self {
        let draft = source.draft;
        let rows = &draft.rows;
        let mut cuts =
            Self { ranges: Vec::with_capacity(rows.sections.len()), offsets: Vec::new() };
        let attached = attachments(source);
        let mut wanted = Vec::new();
        for section in rows.sections.iter() {
            let length = section.s_end - section.s_start;
            for lane in section.lanes.first..section.lanes.end() as u32 {
                wanted_by(draft, lane, &mut wanted);
            }
            let from = attached.partition_point(|(road, _)| *road < section.road);
            let own = attached.get(from..).unwrap_or(&[]);
            wanted.extend(
                own.iter()
                    .take_while(|(road, _)| *road == section.road)
                    .map(|(_, s)| s - section.s_start),
            );
            wanted.sort_by(f64::total_cmp);
            let before = cuts.offsets.len();
            let mut last = 0.0;
            for offset in wanted.drain(..) {
                if offset - last >= SHORTEST_PIECE && length - offset >= SHORTEST_PIECE {
                    cuts.offsets.push(offset as f32);
                    last = offset;
                }
            }
            cuts.ranges.push(between(before, cuts.offsets.len()));
        }
        cuts
    }

    /// Cuts of a section, ascending, from its start.
    pub(crate) fn of(&self, section: u32) -> &[f32] {
        self.ranges.get(section as usize).copied().unwrap_or_default().of(&self.offsets)
    }
}

/// Places on roads to which virtual junctions and paths across link roads and lanes: (road row, s), sorted.
fn attachments(source: Source<'_>) -> Vec<(u32, f64)> {
    let mut places = Vec::new();
    for (number, row) in source.draft.rows.roads.iter().enumerate() {
        for (end, target) in Contact::BOTH.into_iter().zip([row.predecessor, row.successor]) {
            if let Some(link) = source.links.road_link(number as u32, end)
                && let (Some(s), LinkTarget::Road(_)) = (link.s, link.target)
            {
                places.push((target, s));
            }
        }
    }
    places.extend(virtual_connections::places(source));
    places.extend(cross_paths::places(source));
    places.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    places
}

/// Cuts that a lane asks for.
fn wanted_by(draft: &Draft, lane: u32, wanted: &mut Vec<f64>) {
    let rows = &draft.rows;
    let Some(row) = rows.lanes.get(lane as usize) else { return };
    let permissions = &draft.permissions;
    if !usable(draft, lane) && row.number != 0 {
        return;
    }
    wanted.extend(permissions.accesses(lane).iter().map(|record| record.s));
    // The mark on the outer border concerns the lane beyond it; that on lane 0 both lanes beside it.
    let beyond = if row.number > 0 { lane.wrapping_sub(1) } else { lane + 1 };
    let own = if row.number == 0 { lane.wrapping_sub(1) } else { lane };
    if usable(draft, own) && usable(draft, beyond) && one_way(draft, own, beyond) {
        wanted.extend(permissions.mark_breaks(lane));
    }
    if row.flags & lane_flags::BORDER == 0
        && let Some(section) = rows.sections.get(row.section as usize)
    {
        let ends = [section.s_start, section.s_end];
        widths::borders(row.widths().of(&rows.cubics), ends, wanted);
    }
}

/// Whether anybody may use a lane anywhere.
fn usable(draft: &Draft, lane: u32) -> bool {
    let Some(row) = draft.rows.lanes.get(lane as usize).filter(|row| row.number != 0) else {
        return false;
    };
    VehicleClass::of_lane_type(LaneType::from_code(row.kind)) != 0
        || !draft.permissions.accesses(lane).is_empty()
}

/// Whether two lanes of one section share a direction of travel.
fn one_way(draft: &Draft, a: u32, b: u32) -> bool {
    let row = |lane: u32| draft.rows.lanes.get(lane as usize);
    let (Some(a), Some(b)) = (row(a), row(b)) else { return false };
    a.section == b.section
        && ((a.flags | b.flags) & lane_flags::TWO_WAY != 0
            || (a.flags ^ b.flags) & lane_flags::FORWARD == 0)
}
