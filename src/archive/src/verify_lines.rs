//! Proving the polylines: lanes own their points, one lane after the other, at stations of their section that ascend.

use crate::Tables;
use crate::error::VerifyError;
use crate::verify::Check;

pub(crate) fn lines(tables: &Tables<'_>) -> Result<(), VerifyError> {
    stations(tables)?;
    for (row, lane) in tables.lanes.iter().enumerate() {
        let check = Check { table: "lanes", row };
        let Some(section) = tables.sections.get(lane.section() as usize) else { continue };
        let code = section.point_code();
        let (from, counts) =
            (lane.first_byte() as usize, [lane.center_count(), lane.border_count()]);
        let bytes = counts.map(|count| usize::from(count) * code.bytes());
        let Some(points) = tables.points.get(from..from + bytes[0] + bytes[1]) else {
            let expected = format!("{} bytes behind it", bytes[0] + bytes[1]);
            return check.fail("first_byte", expected, from);
        };
        let (center, border) = points.split_at(bytes[0]);
        for line in [center, border] {
            let mut before = 0;
            for point in line.chunks_exact(code.bytes()) {
                let station = code.station(point);
                if station < before {
                    return check.fail("first_byte", "points at ascending stations", station);
                }
                let place = section.first_station() as usize + station as usize;
                if station as usize >= tables.point_stations.len()
                    || place >= tables.point_stations.len()
                {
                    return check.fail("first_byte", "points at stations", station);
                }
                before = station;
            }
        }
    }
    Ok(())
}

/// Sections write their points in a code that fits, and own stations that ascend.
fn stations(tables: &Tables<'_>) -> Result<(), VerifyError> {
    let count = tables.point_stations.len() as u32;
    for (row, section) in tables.sections.iter().enumerate() {
        let check = Check { table: "sections", row };
        if !section.point_code().is_sound() {
            return check.fail("point_bytes", "as many as the bits need", section.point_bytes());
        }
        let first = section.first_station();
        let end = tables.sections.get(row + 1).map_or(count, |next| next.first_station());
        let own = tables.point_stations.get(first as usize..end as usize);
        if !own.is_some_and(|own| own.is_sorted_by(|a, b| a < b)) {
            return check.fail("first_station", format!("ascending stations up to {end}"), first);
        }
    }
    Ok(())
}
