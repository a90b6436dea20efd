//! `mapd query … match`.

use super::kinds::{number, numbers};
use super::row::Row;
use mapd_client::localisation::{LaneMatch, MatchOptions, VehicleOutline, VehiclePose};
use mapd_client::{Map, NearestOptions, Point};
use mapd_query::glam::{DMat3, DVec2, DVec3};

/// Columns of the answer.
pub(super) const COLUMNS: &[&str] =
    &["lane", "direction", "probability", "s", "offset", "heading_difference", "mahalanobis"];
/// Deviations around a pose in which parts in quarantine are named: as far as lanes count.
const REACH: f64 = 6.0;
/// Largest size of an outline to each side `[m]`.
const MOST_SIZE: f64 = 100.0;

/// A row for each lane that the pose may be in, the most probable first, and one for `none`, where it is by its probability.
pub(super) fn answer(
    map: Map<'_>,
    nearest: &NearestOptions,
    outline: Option<VehicleOutline>,
    row: &Row<'_>,
    out: &mut Vec<String>,
) -> Result<(), String> {
    let deviations = deviations(row)?;
    let pose = VehiclePose {
        position: Point { xy: place(row)?, z: row.optional("z")? },
        heading: row.number("hdg")?,
    };
    let options = MatchOptions {
        types: nearest.types,
        z_tolerance: nearest.z_tolerance,
        vehicle: nearest.vehicle,
        outline,
        ..MatchOptions::default()
    };
    let covariance = DMat3::from_diagonal(deviations * deviations);
    let mut found = Vec::new();
    let none = map
        .match_pose(&pose, &covariance, &options, &mut found)
        .map_err(|error| error.to_string())?;
    let before = found.partition_point(|found| found.probability >= none);
    let (more, less) = found.split_at(before);
    write(map, more, out)?;
    out.extend([String::new(), String::new(), number(none)]);
    out.extend([const { String::new() }; 4]);
    write(map, less, out)
}

fn write(map: Map<'_>, found: &[LaneMatch], out: &mut Vec<String>) -> Result<(), String> {
    for found in found {
        let lane = map.lane(found.lane).map_err(super::kinds::text)?;
        out.push(lane.key().to_string());
        out.push(if found.forward { "+" } else { "-" }.to_owned());
        let offset = found.position.offset_of_reference_line;
        let difference = found.heading_difference;
        numbers(out, &[found.probability, found.position.s, offset, difference, found.mahalanobis]);
    }
    Ok(())
}

fn place(row: &Row<'_>) -> Result<DVec2, String> {
    Ok(DVec2::new(row.number("x")?, row.number("y")?))
}

/// Standard deviations of x, y and heading.
fn deviations(row: &Row<'_>) -> Result<DVec3, String> {
    let one = |name: &str| row.not_negative(name);
    Ok(DVec3::new(one("sx")?, one("sy")?, one("shdg")?))
}

/// Where lanes count.
pub(super) fn circle(
    row: &Row<'_>,
    outline: Option<VehicleOutline>,
) -> Result<(DVec2, f64), String> {
    let deviations = deviations(row)?;
    let radius = outline
        .map_or(0.0, |own| DVec2::new(own.front.max(own.back), own.left.max(own.right)).length());
    Ok((place(row)?, REACH * deviations.x.max(deviations.y) + radius))
}

/// Reads `FRONT,BACK,LEFT,RIGHT`.
///
/// Errors: that is not four sizes.
pub(super) fn outline(text: &str) -> Result<VehicleOutline, String> {
    let size =
        |part: &str| part.trim().parse::<f64>().ok().filter(|n| (0.0..=MOST_SIZE).contains(n));
    let sizes: Option<Vec<f64>> = text.split(',').map(size).collect();
    match sizes.as_deref() {
        Some(&[front, back, left, right]) => Ok(VehicleOutline { front, back, left, right }),
        _ => Err("expected FRONT,BACK,LEFT,RIGHT, each 0 to 100 m".to_owned()),
    }
}
