//! Proving the polylines: lanes own their points, one lane after the other, at stations of their section that ascend. Lengths along lanes ascend, too.

use crate::Tables;
use crate::error::VerifyError;
use crate::verify::Check;

pub(crate) fn lines(tables: &Tables<'_>) -> Result<(), VerifyError> {
    lengths(tables)?;
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
        let points = counts.map(usize::from);
        let bytes = (points[0] + points[1]) * code.bytes();
        let Some(line) = tables.points.get(from..).filter(|line| line.len() >= bytes) else {
            return check.fail("first_byte", format!("{bytes} bytes behind it"), from);
        };
        // A point is read with what lies behind it: whole words are read faster than a few bytes.
        for numbers in [0..points[0], points[0]..points[0] + points[1]] {
            let mut before = f32::NEG_INFINITY;
            for number in numbers {
                let station = code.station(&line[number * code.bytes()..]);
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

fn lengths(tables: &Tables<'_>) -> Result<(), VerifyError> {
    for (row, pair) in tables.lane_lengths.windows(2).enumerate() {
        let (before, own) = (&pair[0], &pair[1]);
        let check = Check { table: "lane_lengths", row: row + 1 };
        if own.lane() < before.lane() {
            return check.fail("lane", format!("at least {}", before.lane()), own.lane());
        }
        if own.lane() == before.lane() && own.s() <= before.s() {
            return check.fail("s", format!("above {}", before.s()), own.s());
        }
        if own.lane() == before.lane() && own.length() < before.length() {
            return check.fail("length", format!("at least {}", before.length()), own.length());
        }
    }
    Ok(())
}
