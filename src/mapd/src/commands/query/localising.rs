//! `mapd query … ground` and `… nearest-marks`.

use super::kinds::{number, numbers, text};
use mapd_client::localisation::{GroundScratch, MarkFilter};
use mapd_client::{Map, NearestOptions, Point};

/// Columns of `ground`.
pub(super) const GROUND: &[&str] = &["z", "nx", "ny", "nz", "lane", "material", "level"];
/// Columns of `nearest-marks`.
pub(super) const MARKS: &[&str] = &["distance", "side", "kind", "color", "lane", "s", "painted"];

/// The ground at a point, on the level that its z says.
pub(super) fn ground(map: Map<'_>, point: Point, out: &mut Vec<String>) -> Result<(), String> {
    let ground = map.ground_at(point, &[], &mut GroundScratch::default()).map_err(text)?;
    let ground = ground.ok_or("no lane holds the point")?;
    numbers(out, &[ground.z, ground.normal.x, ground.normal.y, ground.normal.z]);
    out.push(map.lane(ground.lane).map_err(text)?.key().to_string());
    out.push(ground.material.map_or("", |material| material.surface).to_owned());
    out.push(ground.level.to_string());
    Ok(())
}

/// The road mark that is nearest to a point.
pub(super) fn mark(
    map: Map<'_>,
    point: Point,
    options: &NearestOptions,
    out: &mut Vec<String>,
) -> Result<(), String> {
    let NearestOptions { radius, types, .. } = *options;
    let filter = MarkFilter { radius, types, ..MarkFilter::default() };
    let found = map.nearest_mark(point.xy, &filter).map_err(text)?;
    let found = found.ok_or_else(|| format!("no road mark within {radius} m"))?;
    out.push(number(found.distance));
    for word in [found.side_of_reference_line.name(), found.kind.name(), found.color.name()] {
        out.push(word.to_owned());
    }
    out.push(map.lane(found.lane).map_err(text)?.key().to_string());
    out.push(number(found.s));
    out.push(found.painted.map_or("", |painted| if painted { "1" } else { "0" }).to_owned());
    Ok(())
}
