//! Bridges, tunnels, references to objects, and railways: stored as written, ids made rows.

use super::attach::Reference;
use crate::draft::{LaneNumbers, Objects, Switch};
use crate::findings::TooLarge;
use crate::sample::view;
use mapd_archive::{
    LaneRangeRow, NONE, ObjectReferenceRow, Orientation, PlatformRow, PlatformSegmentRow, Range,
    Rows, StationRow, StructureRow, SwitchRow, string,
};
use mapd_query::Map;
use std::collections::HashMap;

/// Appends lane numbers.
pub(super) fn lane_ranges(rows: &mut Rows, validities: &[(i32, i32)]) -> Result<Range, TooLarge> {
    let before = rows.lane_ranges.len();
    rows.lane_ranges
        .extend(validities.iter().map(|(from, to)| LaneRangeRow { from: *from, to: *to }));
    Range::between(before, rows.lane_ranges.len()).ok_or_else(|| TooLarge::new("lane_ranges"))
}

/// Appends bridges, tunnels and references; the references come back with their objects' rows, in that order.
pub(super) fn append(
    rows: &mut Rows,
    written: &Objects,
) -> Result<Vec<(u32, Reference)>, TooLarge> {
    for structure in &written.structures {
        let validities = lane_ranges(rows, &structure.validities)?;
        rows.structures.push(StructureRow { validities, ..structure.row });
    }
    let mut references = Vec::new();
    for reference in &written.references {
        let object = {
            let archive = view(rows);
            let map = Map::new(&archive, 0);
            let id = string(map.tables(), reference.row.id);
            map.object_by_id(id).map(|object| object.object_id().row())
        };
        let row = &reference.row;
        if let Some(object) = object {
            let reference = Reference {
                road: row.road,
                s: row.s,
                t: row.t,
                valid_length: f64::from(row.valid_length),
                orientation: Orientation::from_code(row.orientation),
                lanes: LaneNumbers::new(&reference.validities),
            };
            references.push((object, reference));
        }
        let validities = lane_ranges(rows, &reference.validities)?;
        let object = object.unwrap_or(NONE);
        rows.object_references.push(ObjectReferenceRow { object, validities, ..*row });
    }
    references.sort_by_key(|(object, _)| *object);
    railways(rows, written)?;
    Ok(references)
}

fn railways(rows: &mut Rows, written: &Objects) -> Result<(), TooLarge> {
    if written.switches.is_empty() && written.stations.is_empty() {
        return Ok(());
    }
    let (switches, roads_of_segments): (Vec<SwitchRow>, Vec<u32>) = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let road = |id: &str| map.road_by_id(id).map_or(NONE, |road| road.road_id().row());
        let by_id: HashMap<&str, u32> = written
            .switches
            .iter()
            .enumerate()
            .map(|(number, switch)| (string(map.tables(), switch.row.id), number as u32))
            .collect();
        let switch = |switch: &Switch| SwitchRow {
            main: road(&switch.tracks[0]),
            side: road(&switch.tracks[1]),
            partner: by_id.get(switch.partner.as_str()).copied().unwrap_or(NONE),
            ..switch.row
        };
        let platforms = written.stations.iter().flat_map(|station| &station.platforms);
        let segments = platforms.flat_map(|platform| &platform.segments);
        (written.switches.iter().map(switch).collect(), segments.map(|(id, _)| road(id)).collect())
    };
    rows.switches = switches.into();
    let mut roads = roads_of_segments.into_iter();
    for station in &written.stations {
        let first = rows.platforms.len();
        for platform in &station.platforms {
            let before = rows.platform_segments.len();
            for (_, row) in &platform.segments {
                let road = roads.next().unwrap_or(NONE);
                rows.platform_segments.push(PlatformSegmentRow { road, ..*row });
            }
            let segments = Range::between(before, rows.platform_segments.len());
            let segments = segments.ok_or_else(|| TooLarge::new("platform_segments"))?;
            rows.platforms.push(PlatformRow { segments, ..platform.row });
        }
        let platforms = Range::between(first, rows.platforms.len())
            .ok_or_else(|| TooLarge::new("platforms"))?;
        rows.stations.push(StationRow { platforms, ..station.row });
    }
    Ok(())
}
