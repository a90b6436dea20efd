//! Proving the polylines: lanes own their points, one lane after the other, at stations of their section that ascend.

use crate::Tables;
use crate::error::VerifyError;
use crate::verify::Check;

pub(crate) fn lines(tables: &Tables<'_>) -> Result<(), VerifyError> {
    for (row, section) in tables.sections.iter().enumerate() {
        if !section.point_code().is_sound() {
            let check = Check { table: "sections", row };
            return check.fail("point_bytes", "as many as the bits need", section.point_bytes());
        }
    }
    for (row, lane) in tables.lanes.iter().enumerate() {
        let check = Check { table: "lanes", row };
        let Some(section) = tables.sections.get(lane.section() as usize) else { continue };
        let code = section.point_code();
        let stations = tables.point_stations.get(section.first_station() as usize..);
        let (from, counts) =
            (lane.first_byte() as usize, [lane.center_count(), lane.border_count()]);
        let bytes = counts.map(|count| usize::from(count) * code.bytes());
        let Some(points) = tables.points.get(from..from + bytes[0] + bytes[1]) else {
            let expected = format!("{} bytes behind it", bytes[0] + bytes[1]);
            return check.fail("first_byte", expected, from);
        };
        let (center, border) = points.split_at(bytes[0]);
        for line in [center, border] {
            let mut before = f32::NEG_INFINITY;
            for point in line.chunks_exact(code.bytes()) {
                let station = code.station(point);
                let s = stations.and_then(|stations| stations.get(station as usize)).copied();
                match s {
                    None => return check.fail("first_byte", "points at stations", station),
                    Some(s) if s < before => {
                        return check.fail("first_byte", format!("points from s = {before} on"), s);
                    }
                    Some(s) => before = s,
                }
            }
        }
    }
    Ok(())
}
