//! `mapd query … objects`.

use super::kinds::{number, numbers, text};
use super::row::Row;
use mapd_client::Map;

/// The places of objects within `radius` of x and y, nearest first: the columns of one after those of the other.
pub(crate) fn answer(map: Map<'_>, row: &Row<'_>, out: &mut Vec<String>) -> Result<(), String> {
    let (point, radius) = row.circle()?;
    let mut near = Vec::new();
    map.objects_near(point, radius, &mut near).map_err(text)?;
    for found in near {
        let place = map.placement(found.place).map_err(text)?;
        let object = place.object();
        out.push(object.id().to_owned());
        out.push(object.class().name().to_owned());
        out.push(number(found.distance));
        // An object of a junction has no road; its s and t count along the junction's own line.
        out.push(object.road().map_or("", |road| road.id()).to_owned());
        numbers(out, &[place.s(), place.t()]);
        numbers(out, &place.position().to_array());
        out.push(object.value().map(number).unwrap_or_default());
    }
    Ok(())
}
