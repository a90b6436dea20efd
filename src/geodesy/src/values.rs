//! Values that PROJ refuses, and with which a projection would answer all the same: with a place that is wrong.

use std::f64::consts::FRAC_PI_2;

/// Parameters that are latitudes: of ±90 degrees at most.
const LATITUDES: [&str; 4] = ["lat_0", "lat_1", "lat_2", "lat_ts"];
/// Parameters that are scales on the central meridian or at the origin: above 0.
const SCALES: [&str; 3] = ["k", "k_0", "k0"];
/// Zones of UTM.
const ZONES: std::ops::RangeInclusive<u8> = 1..=60;
/// Largest number in a shift between datums, metres, arc seconds or parts per million. No datum's centre lies farther from
/// the Earth's than some kilometres.
const MOST_SHIFT: f64 = 1e6;
/// Radians in a degree, minute and second of arc, each with what ends its number.
const UNITS: [(&[char], f64); 3] = [
    (&['d', 'D', '°'], std::f64::consts::PI / 180.0),
    (&['\''], std::f64::consts::PI / 10_800.0),
    (&['"'], std::f64::consts::PI / 648_000.0),
];

/// Looks at the values of PROJ parameters. Errors: which is out of its range.
pub(crate) fn check(definition: &str) -> Result<(), String> {
    let words = || definition.split_whitespace().map(|word| word.trim_start_matches('+'));
    // As in PROJ, the first of several counts.
    let get = |name: &str| words().find_map(|word| word.strip_prefix(name)?.strip_prefix('='));
    if get("proj") == Some("utm") {
        let zone = get("zone").ok_or("expected a zone of UTM, found none")?;
        if !zone.parse().is_ok_and(|zone| ZONES.contains(&zone)) {
            return Err(format!("expected a zone of UTM from 1 to 60, found {zone:?}"));
        }
    }
    for name in LATITUDES {
        let value = get(name).map(|text| (text, angle(text)));
        if let Some((text, None)) = value {
            return Err(format!("expected an angle for {name}, found {text:?}"));
        }
        // A rounding of radians is none.
        if let Some((text, Some(angle))) =
            value.filter(|(_, angle)| *angle > Some(FRAC_PI_2 + 1e-12))
        {
            let degrees = angle.to_degrees();
            return Err(format!(
                "expected at most 90 degrees for {name}, found {text:?} ({degrees})"
            ));
        }
    }
    for name in SCALES {
        if let Some(text) =
            get(name).filter(|text| !text.parse().is_ok_and(|k: f64| k > 0.0 && k.is_finite()))
        {
            return Err(format!("expected a scale above 0 for {name}, found {text:?}"));
        }
    }
    if let Some(text) = get("towgs84") {
        let is_sound = |number: &str| {
            number.trim().parse::<f64>().is_ok_and(|number| number.abs() <= MOST_SHIFT)
        };
        if !text.split(',').all(is_sound) {
            return Err(format!("expected numbers of at most {MOST_SHIFT} in towgs84={text}"));
        }
    }
    Ok(())
}

/// The size of an angle `[rad]` as PROJ has them: degrees, degrees with minutes and seconds, or radians (`r`), with a letter
/// of the compass or without.
fn angle(text: &str) -> Option<f64> {
    let text = text.trim_end_matches(['N', 'n', 'S', 's', 'E', 'e', 'W', 'w']);
    if let Some(radians) = text.strip_suffix(['r', 'R']) {
        return finite(radians);
    }
    let text = text.trim_start_matches(['+', '-']);
    let (mut rest, mut sum) = (text, 0.0);
    for (i, (marks, unit)) in UNITS.iter().enumerate() {
        let later = |c: char| UNITS[i + 1..].iter().any(|(marks, _)| marks.contains(&c));
        let (number, tail) = match rest.split_once(*marks) {
            Some(parts) => parts,
            // Minutes without degrees; the last number needs no mark.
            None if rest.contains(later) => continue,
            None => (rest, ""),
        };
        if !number.is_empty() {
            sum += finite(number)? * unit;
        }
        rest = tail;
    }
    (rest.is_empty() && !text.is_empty()).then_some(sum)
}

fn finite(text: &str) -> Option<f64> {
    text.parse::<f64>().ok().map(f64::abs).filter(|number| number.is_finite())
}
