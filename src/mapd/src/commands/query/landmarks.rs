//! `mapd query … landmarks`.

use super::kinds::{number, numbers, text};
use super::row::Row;
use mapd_client::Map;
use mapd_query::localisation::LandmarkSource;
use mapd_query::vocabulary::{Class, ClassSet};

/// Columns of the answer.
pub(super) const COLUMNS: &[&str] = &[
    "id", "class", "distance", "road_id", "s", "t", "x", "y", "z", "hdg", "length", "width",
    "height", "kind",
];

/// Signals and places of objects within `radius` of x and y that localisers use, or that are of one of `classes`, nearest first.
pub(super) fn answer(map: Map<'_>, row: &Row<'_>, out: &mut Vec<String>) -> Result<(), String> {
    let (point, radius) = row.circle()?;
    let mut near = Vec::new();
    map.landmarks_near(point, radius, classes(row)?, &mut near).map_err(text)?;
    for found in near {
        let (id, road, [s, t], kind) = match found.source {
            LandmarkSource::Signal(id) => {
                let signal = map.signal(id).map_err(text)?;
                let [s, t, ..] = signal.track();
                (signal.id(), signal.road(), [s, t], "signal")
            }
            LandmarkSource::Object(id) => {
                let place = map.placement(id).map_err(text)?;
                let object = place.object();
                (object.id(), object.road(), [place.s(), place.t()], "object")
            }
        };
        out.push(id.to_owned());
        out.push(found.class.name().to_owned());
        out.push(number(found.distance));
        // An object of a junction has no road; its s and t count along the junction's own line.
        out.push(road.map_or("", |road| road.id()).to_owned());
        numbers(out, &[s, t]);
        numbers(out, &found.position.to_array());
        numbers(out, &[found.heading]);
        numbers(out, &found.size);
        out.push(kind.to_owned());
    }
    Ok(())
}

/// The classes that a row names, separated by `;`; those of landmarks where it names none.
fn classes(row: &Row<'_>) -> Result<ClassSet, String> {
    let names = row.text("classes").unwrap_or("").trim();
    if names.is_empty() {
        return Ok(ClassSet::LANDMARKS);
    }
    names.split(';').try_fold(ClassSet::NONE, |set, name| {
        let name = name.trim();
        match Class::from_name(name) {
            Class::Unknown if name != Class::Unknown.name() => {
                Err(format!("expected a class of the vocabulary, found {name:?}"))
            }
            class => Ok(set.with(class)),
        }
    })
}
