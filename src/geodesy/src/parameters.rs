//! PROJ parameters: only those that are understood, in a canonical form.
//!
//! Names and meanings are those of PROJ (<https://proj.org/usage/projections.html>).

use crate::plain::UTM;
use crate::reference::{ReferenceError, shown};
use crate::warning::DefinitionWarning;
use std::collections::BTreeSet;

/// Parameters that are numbers.
const NUMBERS: [&str; 13] =
    ["zone", "k", "k_0", "x_0", "y_0", "h_0", "a", "b", "rf", "f", "es", "e", "R"];
/// Parameters that are angles, as numbers of degrees or in degrees, minutes and seconds.
const ANGLES: [&str; 9] =
    ["lat_0", "lon_0", "lat_1", "lat_2", "lat_ts", "alpha", "gamma", "lonc", "pm"];
/// Parameters that stand for themselves or name something.
const NAMES: [&str; 11] = [
    "proj", "south", "ellps", "datum", "no_uoff", "no_off", "no_rot", "approx", "algo", "R_A",
    "towgs84",
];
/// Parameters without meaning for a plane's points.
const IDLE: [&str; 7] = ["no_defs", "wktext", "type", "title", "north", "over", "init"];
/// Axes as OpenDRIVE has them.
const EAST_NORTH_UP: &str = "enu";
/// Names of the metre.
const METRES: [&str; 4] = ["m", "metre", "meter", "1"];
/// Datum that is given by grids.
const GRID_DATUM: &str = "NAD27";
/// Named datums without shift, on the ellipsoids of WGS 84 and GRS 80.
const WORLDWIDE: [&str; 2] = ["WGS84", "NAD83"];
/// The only other named datum on one of them.
const GREEK: &str = "GGRS87";
/// Ellipsoids whose latitudes and longitudes differ from those on WGS 84 by less than a millimetre.
const ALIKE: [&str; 2] = ["WGS84", "GRS80"];
/// Semi-major axis of WGS 84 and GRS 80 `[m]` and their inverse flattening as far as they agree.
const AXIS: f64 = 6_378_137.0;
const FLATTENING: f64 = 298.257_22;
/// Deviation from [`FLATTENING`] of the two.
const FLATTENING_DEVIATION: f64 = 1e-5;
/// Largest size of a number: what is larger is no length on Earth.
const LARGEST: f64 = 1e9;

/// The canonical form of some PROJ parameters and what is doubtful about them.
pub(crate) fn canonical(text: &str) -> Result<(String, Vec<DefinitionWarning>), ReferenceError> {
    let list = split(text);
    let get = |name: &str| list.iter().find(|(key, _)| *key == name).map(|(_, value)| *value);
    let mut warnings = Vec::new();
    let mut out = String::new();
    let mut push = |key: &str, value: &str| {
        let value = if value.is_empty() { String::new() } else { format!("={value}") };
        out.push_str(if out.is_empty() { "+" } else { " +" });
        out.push_str(key);
        out.push_str(&value);
    };
    // The projection first, so that definitions read alike.
    match get("proj") {
        Some("longlat" | "latlong" | "lonlat" | "latlon" | "geocent" | "cart") => {
            return Err(ReferenceError::Geographic);
        }
        Some(name) => push("proj", name),
        None if get("lat_0").is_some() && get("lon_0").is_some() => {
            push("proj", "tmerc");
            warnings.push(DefinitionWarning::Assumed);
        }
        None => return Err(ReferenceError::Unrecognized),
    }
    let mut seen = BTreeSet::from(["proj"]);
    let mut ignored = Vec::new();
    for (key, value) in &list {
        // As in PROJ, the first of several counts.
        if !seen.insert(key) {
            continue;
        }
        match *key {
            "nadgrids" if *value == "@null" => {}
            "nadgrids" => return Err(ReferenceError::Grid(shown(value))),
            "datum" if value.eq_ignore_ascii_case(GRID_DATUM) => {
                return Err(ReferenceError::Grid(shown(value)));
            }
            "geoidgrids" | "geoid_crs" => warnings.push(DefinitionWarning::Height(shown(value))),
            "units" | "to_meter" if is_metre(value) => {}
            "units" | "to_meter" => warnings.push(DefinitionWarning::Unit(shown(value))),
            "vunits" | "vto_meter" if is_metre(value) => {}
            "vunits" | "vto_meter" => warnings.push(DefinitionWarning::HeightUnit(shown(value))),
            "axis" if *value == EAST_NORTH_UP => {}
            "axis" => warnings.push(DefinitionWarning::Axes(shown(value))),
            key if IDLE.contains(&key) => {}
            key if NUMBERS.contains(&key) => {
                number(key, value)?;
                push(key, value);
            }
            key if ANGLES.contains(&key) || NAMES.contains(&key) => push(key, value),
            key => ignored.push(key),
        }
    }
    if !ignored.is_empty() {
        warnings.push(DefinitionWarning::Ignored(shown(&ignored.join(" "))));
    }
    if get("proj") == Some("utm") {
        let idle = without_effect(&get);
        if !idle.is_empty() {
            warnings.push(DefinitionWarning::NoEffect(shown(&idle)));
        }
    }
    let ellipsoid = ["ellps", "a", "R"].iter().any(|key| get(key).is_some());
    if !ellipsoid && get("datum").is_none() && get("towgs84").is_none() {
        push("datum", "WGS84");
    }
    let placed = ["datum", "towgs84", "nadgrids"].iter().any(|key| get(key).is_some());
    if !placed && ellipsoid && !is_alike(&get) {
        warnings.push(DefinitionWarning::Datum);
    }
    if is_mixed(&get, ellipsoid) {
        warnings.push(DefinitionWarning::Mixed);
    }
    Ok((out, warnings))
}

/// Names and values; a value is empty where there is none.
/// Parameters of UTM, and their values, that say something else than UTM itself: PROJ does not read them.
fn without_effect<'a>(get: &impl Fn(&str) -> Option<&'a str>) -> String {
    let (east, south, scale) = UTM;
    let north = if get("south").is_some() { south } else { 0.0 };
    let meridian =
        get("zone").and_then(|zone| zone.parse::<f64>().ok()).map(|zone| 6.0 * zone - 183.0);
    let own = [
        ("lat_0", Some(0.0)),
        ("lon_0", meridian),
        ("k", Some(scale)),
        ("k_0", Some(scale)),
        ("x_0", Some(east)),
        ("y_0", Some(north)),
    ];
    let others = own.into_iter().filter_map(|(name, own)| {
        let (written, own) = (get(name)?, own?);
        (written.parse() != Ok(own)).then(|| format!("+{name}={written}"))
    });
    others.collect::<Vec<_>>().join(" ")
}

fn split(text: &str) -> Vec<(&str, &str)> {
    let words = text.split_whitespace().map(|word| word.trim_start_matches('+'));
    let words = words.filter(|word| !word.is_empty());
    words
        .map(|word| word.split_once('=').unwrap_or((word, "")))
        .map(|(key, value)| (key, value.trim_matches(['"', '\''])))
        .collect()
}

fn is_metre(value: &str) -> bool {
    METRES.contains(&value) || value.parse() == Ok(1.0)
}

fn number(key: &str, value: &str) -> Result<(), ReferenceError> {
    match value.parse::<f64>() {
        Ok(number) if number.abs() <= LARGEST => Ok(()),
        _ => Err(ReferenceError::Value { name: key.to_owned(), value: shown(value) }),
    }
}

/// Whether the named datum contradicts the ellipsoid or the shift beside it.
fn is_mixed<'a>(get: &impl Fn(&str) -> Option<&'a str>, ellipsoid: bool) -> bool {
    let Some(datum) = get("datum") else { return false };
    let named = |names: &[&str]| names.iter().any(|name| datum.eq_ignore_ascii_case(name));
    let shifted = get("towgs84")
        .is_some_and(|shift| shift.split(',').any(|value| value.trim().parse() != Ok(0.0)));
    if named(&WORLDWIDE) {
        return shifted || (ellipsoid && !is_alike(get));
    }
    ellipsoid && is_alike(get) && !named(&[GREEK])
}

/// Whether the ellipsoid is that of WGS 84 or GRS 80.
fn is_alike<'a>(get: &impl Fn(&str) -> Option<&'a str>) -> bool {
    if let Some(name) = get("ellps") {
        return ALIKE.iter().any(|alike| name.eq_ignore_ascii_case(alike));
    }
    let number = |name: &str| get(name).and_then(|value| value.parse::<f64>().ok());
    number("a") == Some(AXIS)
        && number("rf").is_some_and(|rf| (rf - FLATTENING).abs() <= FLATTENING_DEVIATION)
}
