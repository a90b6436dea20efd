//! Other values that a place may have.

use super::document::{Document, ValueLocation};
use mapd_schemas::opendrive::{Element, Table, split_range};

/// Texts to be tried where a text means something.
const TEXTS: [&str; 9] = ["b.xml", "US", "DE", "206", "205", "no limit", "end", "start", "-1"];

/// Values to be tried, the likeliest first; of an element as a whole that it is not there.
pub(super) fn of(
    table: &Table,
    element: &Element,
    name: &str,
    document: &Document,
    place: &ValueLocation,
) -> Vec<String> {
    if place.is_element {
        return vec![String::new()];
    }
    let written = document.value(place);
    let attribute = element.attributes.iter().find(|attribute| attribute.name == name);
    let kind = match attribute {
        Some(attribute) => split_range(attribute.kind.last()).0.to_owned(),
        None => element.content.clone().unwrap_or_default(),
    };
    let mut values = Vec::new();
    let number = written.trim().parse::<f64>().ok();
    if let Some(words) = kind.strip_prefix("words ").and_then(|name| table.words(name)) {
        values.extend(words.words.iter().map(|word| word.word.clone()));
    }
    if ["boolean", "yes_no", "xs_boolean"].contains(&kind.as_str()) {
        values.extend(["true", "false", "yes", "no"].map(str::to_owned));
    }
    if let Some(number) = number {
        if ["int", "uint", "text"].contains(&kind.as_str()) {
            values.extend([number + 1.0, number - 1.0].map(|n| n.to_string()));
        } else if !kind.starts_with("words") {
            let steps = [0.25, -0.25, 0.015625, 1.0, -1.0, 0.0009765625];
            values.extend(steps.map(|step| (number + step).to_string()));
            values.extend([number * 1.25, number * 0.5].map(|number| number.to_string()));
        }
    }
    if ["text", "country", "speed_limit", "lane_speed_limit", "position_or_end"]
        .contains(&kind.as_str())
    {
        if number.is_none() {
            values.push(format!("{written}x"));
            values.push("x".repeat(written.len().max(1)));
        }
        values.extend(TEXTS.map(str::to_owned));
        // What may be an id: those of others.
        let ids = document.places.iter().filter(|other| !other.is_element);
        let mut ids: Vec<String> =
            ids.map(|other| document.value(other).to_owned()).filter(|id| id.len() < 4).collect();
        ids.sort();
        ids.dedup();
        values.extend(ids);
    }
    values.retain(|value| value != written);
    values
}
