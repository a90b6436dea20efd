//! The table against the lists of everything that the standard's schemas have, which lie outside the project.

use mapd_schemas::opendrive::{ADDITIONAL, Element, Table, VERSIONS, VersionSet, split_range};
use std::collections::{BTreeMap, HashMap};
use std::io::Write as _;
use std::path::{Path, PathBuf};

/// Says something aloud: on stderr itself, which the test harness does not swallow.
fn say(message: &str) {
    // A closed stderr is no reason to fail a test.
    let _ = writeln!(std::io::stderr(), "{message}");
}

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace").to_owned()
}

/// Rows of a list, by column name; none where the list is not there.
fn rows(name: &str) -> Option<Vec<HashMap<String, String>>> {
    let path = workspace().parent()?.join("shared/spec").join(name);
    let Ok(text) = std::fs::read_to_string(&path) else {
        say(&format!("SKIPPED: no {name} beside the workspace"));
        return None;
    };
    let mut lines = text.lines().map(|line| line.split('\t').map(str::to_owned));
    let headers: Vec<String> = lines.next()?.collect();
    let rows = lines.map(|row| headers.iter().cloned().zip(row).collect());
    Some(rows.flat_map(both_sides).collect())
}

/// A row about lanes of both sides stands for one of each.
fn both_sides(row: HashMap<String, String>) -> Vec<HashMap<String, String>> {
    const BOTH: &str = "/left|right";
    if row.get("path").is_none_or(|path| !path.contains(BOTH)) {
        return vec![row];
    }
    let side = |side: &str| {
        row.iter().map(|(name, value)| (name.clone(), value.replace(BOTH, side))).collect()
    };
    vec![side("/left"), side("/right")]
}

fn rank(version: &str) -> usize {
    VERSIONS.iter().position(|v| *v == version).unwrap_or_else(|| panic!("no version {version}"))
}

/// Ranks of the versions that a row of elements.tsv has.
fn stated(row: &HashMap<String, String>) -> Vec<usize> {
    let first = rank(&row["first"]);
    let until = row["removed"].strip_prefix("absent from ").map_or(VERSIONS.len(), rank);
    (first..until).collect()
}

fn ranks(set: VersionSet) -> Vec<usize> {
    (0..VERSIONS.len()).filter(|rank| set.has(*rank)).collect()
}

/// An element at a path, and the versions in which it stands there.
struct ElementAt<'a> {
    element: &'a Element,
    versions: VersionSet,
    occurs: Option<String>,
}

/// Every path of the table that begins a path of the list.
fn walk<'a>(
    table: &'a Table,
    path: String,
    place: ElementAt<'a>,
    wanted: &HashMap<String, ()>,
    out: &mut BTreeMap<String, ElementAt<'a>>,
) {
    for child in &place.element.children {
        let path = format!("{path}/{}", child.name);
        let element = table.element(&child.kind).expect("the table is checked");
        if wanted.contains_key(&path) {
            let versions = child.versions(table, place.element).and(place.versions);
            let newest = ranks(versions).last().copied().unwrap_or(0);
            let occurs = child.occurs.at(newest).map(|o| {
                format!("{}..{}", o.min, o.max.map_or("*".to_owned(), |max| max.to_string()))
            });
            walk(table, path, ElementAt { element, versions, occurs }, wanted, out);
        }
    }
    out.insert(path, place);
}

#[test]
fn every_element_and_attribute_is_in_the_table() {
    let Some(rows) = rows("elements.tsv") else { return };
    let table = Table::read(&workspace().join("schemas/opendrive")).expect("the table reads");
    let wanted: HashMap<String, ()> =
        rows.iter().filter(|r| r["kind"] == "E").map(|r| (r["path"].clone(), ())).collect();
    let root = table.element("OpenDrive").expect("the root");
    let mut places = BTreeMap::new();
    let place = ElementAt { element: root, versions: VersionSet::ALL, occurs: None };
    walk(&table, "OpenDRIVE".to_owned(), place, &wanted, &mut places);
    // The list has what may stand in many elements once.
    for (tag, kind) in ADDITIONAL {
        let element = table.element(kind).expect("the table is checked");
        let place = ElementAt { element, versions: element.versions(), occurs: None };
        walk(&table, format!("*/{tag}"), place, &wanted, &mut places);
    }
    let mut wrong = Vec::new();
    let mut counts = [[0_usize; 2]; VERSIONS.len()];
    for row in &rows {
        let (path, stated) = (row["path"].as_str(), stated(row));
        let (owner, is_attribute) = match row["kind"].as_str() {
            "A" => (row["parent"].as_str(), true),
            _ => (path, false),
        };
        for rank in &stated {
            counts[*rank][usize::from(is_attribute)] += 1;
        }
        let Some(place) = places.get(owner) else {
            wrong.push(format!("{path}: not in the table"));
            continue;
        };
        if !is_attribute {
            let found = ranks(place.versions);
            if found != stated {
                wrong.push(format!("{path}: versions {found:?}, expected {stated:?}"));
            }
            let steps = row["history"].split(" -> ").filter_map(|step| step.split_once(": "));
            let changed = steps.filter(|(_, occurs)| occurs.contains("..")).last();
            let whole = format!("{}..{}", row["min"], row["max"]);
            let occurs = changed.map_or(whole, |(_, occurs)| occurs.to_owned());
            if place.occurs.as_ref().is_some_and(|found| *found != occurs) {
                wrong.push(format!("{path}: occurs {:?}, expected {occurs}", place.occurs));
            }
            for (tag, _) in ADDITIONAL {
                // Where an element stands within itself, the list ends without saying.
                if row["content_flags"] == "recursive" {
                    continue;
                }
                let found = ranks(place.element.additional(tag).and(place.versions));
                let has = |rank: &usize| inside(&row["extension_children"], *rank).contains(&tag);
                let expected: Vec<usize> = stated.iter().copied().filter(has).collect();
                if found != expected {
                    wrong.push(format!("{path}: {tag} inside in {found:?}, expected {expected:?}"));
                }
            }
            continue;
        }
        let name = row["name"].trim_start_matches('@');
        let Some(attribute) = place.element.attributes.iter().find(|a| a.name == name) else {
            wrong.push(format!("{path}: not in the table"));
            continue;
        };
        let found = ranks(attribute.versions(place.element).and(place.versions));
        if found != stated {
            wrong.push(format!("{path}: versions {found:?}, expected {stated:?}"));
        }
        let required = ranks(attribute.required(place.element).and(place.versions));
        let expected: Vec<usize> =
            stated.iter().copied().filter(|rank| need(row, *rank) == "required").collect();
        if required != expected {
            wrong.push(format!("{path}: required in {required:?}, expected {expected:?}"));
        }
        let since = Some(row["deprecated_since"].trim_end_matches(".0")).filter(|s| !s.is_empty());
        let deprecated = attribute.deprecated.map(|version| version.to_string());
        if deprecated.as_deref() != since {
            wrong.push(format!("{path}: deprecated {deprecated:?}, expected {since:?}"));
        }
        let by_text = Some(row["use_in_1.9_text"].as_str())
            .filter(|text| ["required", "optional"].contains(text) && row["use"] != *text);
        if row["in_1.9"] == "yes" && attribute.text_use.as_deref() != by_text {
            let found = &attribute.text_use;
            wrong.push(format!("{path}: by the text {found:?}, expected {by_text:?}"));
        }
        let newest = stated.last().copied().unwrap_or(0);
        let (_, found) = split_range(attribute.kind.at(newest).map_or("", String::as_str));
        let expected = range(row);
        // The schema's range of places that may also be `start` or `end` leaves out the road's start; its text does not.
        let own =
            ["words ", "position_or_end"].iter().any(|k| attribute.kind.last().starts_with(k));
        if found != expected && !own {
            wrong.push(format!("{path}: range {found:?}, expected {expected:?}"));
        }
        if !is_of_type(&row["type"], &attribute.value_type().expect("a type")) {
            wrong.push(format!(
                "{path}: type {:?}, expected {}",
                attribute.value_type(),
                row["type"]
            ));
        }
    }
    for (version, [elements, attributes]) in VERSIONS.iter().zip(counts) {
        say(&format!("{version}: {elements} elements, {attributes} attributes"));
    }
    assert!(wrong.is_empty(), "{} differ:\n{}", wrong.len(), wrong.join("\n"));
}

/// What may stand inside in a version: "none", "include+userData", or steps of such with the version that begins each.
fn inside(column: &str, rank: usize) -> Vec<&str> {
    let steps = column.split(" -> ").map(|step| step.split_once(": ").unwrap_or(("1.4", step)));
    let since = steps.take_while(|(version, _)| self::rank(version) <= rank);
    since.last().map_or(Vec::new(), |(_, names)| names.split('+').collect())
}

/// The use of an attribute in a version: by its history, else as in the newest.
fn need(row: &HashMap<String, String>, rank: usize) -> String {
    let history = row["history"].split(" || ").find_map(|part| part.strip_prefix("use "));
    let Some(history) = history else { return row["use"].clone() };
    let steps = history.split(" -> ").filter_map(|step| step.split_once(": "));
    let since = steps.take_while(|(version, _)| self::rank(version) <= rank);
    since.last().map_or(String::new(), |(_, need)| need.to_owned())
}

/// The range of an attribute in the notation of the table.
fn range(row: &HashMap<String, String>) -> &str {
    match (row["type"].as_str(), row["range"].as_str(), row["default_or_fixed"].as_str()) {
        (_, _, "fixed=0") => "=0",
        (_, _, "fixed=1") => "=1",
        (_, _, "fixed=road") => "=road",
        ("uint(>=1)", ..) => ">=1",
        ("uint(>=1)|int(<=-1)", ..) => "!=0",
        (_, ">=0.0", _) => ">=0",
        (_, ">0.0", _) => ">0",
        (_, "<=1.0 >=0.0", _) => "0..1",
        _ => "",
    }
}

/// Whether a type of the table reads values of a type of the list.
fn is_of_type(listed: &str, found: &str) -> bool {
    let kinds: &[&str] = match listed.split([' ', '{', ':']).next().unwrap_or_default() {
        "double" => &["double", "lane_speed_limit"],
        "int" | "integer" => &["int"],
        "uint" | "nonNegativeInteger" | "ushort" => &["uint"],
        // One type of lane stands on both sides; on which one ids are positive is a rule's to check.
        "uint(>=1)|int(<=-1)" => &["int"],
        "bool" | "boolean" => &["boolean", "xs_boolean", "yes_no"],
        "string" => &["text", "country", "position_or_end"],
        _ => &[
            "words",
            "boolean",
            "yes_no",
            "xs_boolean",
            "speed_limit",
            "position_or_end",
            "country",
            "text",
            "uint",
        ],
    };
    kinds.contains(&found.split(' ').next().unwrap_or_default())
}

/// Attributes whose type had another name in older versions, with the same words: the type, and the ranks of those versions.
const RENAMED: [(&str, &[usize]); 2] = [("e_unit", &[0]), ("e_connection_type", &[1, 2])];

#[test]
fn every_word_is_in_the_table() {
    let Some(rows) = rows("enums.tsv") else { return };
    let table = Table::read(&workspace().join("schemas/opendrive")).expect("the table reads");
    let mut wrong = Vec::new();
    let mut counts = [0_usize; VERSIONS.len()];
    for row in &rows {
        let (list, word) = (&row["enum"], &row["value"]);
        let marked = |mark: &[&str]| -> Vec<usize> {
            let is = |rank: &usize| mark.contains(&row[VERSIONS[*rank]].as_str());
            (0..VERSIONS.len()).filter(is).collect()
        };
        let (mut stated, deprecated) = (marked(&["x", "d"]), marked(&["d"]));
        stated.iter().for_each(|rank| counts[*rank] += 1);
        let renamed = RENAMED.iter().filter(|(name, _)| name == list).flat_map(|(_, ranks)| *ranks);
        stated.extend(renamed);
        stated.sort_unstable();
        let words = table.words.iter().find(|words| words.schema == *list);
        let Some(found) = words.and_then(|w| w.words.iter().find(|w| w.word == *word)) else {
            wrong.push(format!("{list} {word}: not in the table"));
            continue;
        };
        for (what, found, expected) in [
            ("versions", ranks(found.versions()), stated),
            ("deprecated in", ranks(found.deprecations()), deprecated),
        ] {
            if found != expected {
                wrong.push(format!("{list} {word}: {what} {found:?}, expected {expected:?}"));
            }
        }
    }
    for (version, words) in VERSIONS.iter().zip(counts) {
        say(&format!("{version}: {words} words"));
    }
    assert!(wrong.is_empty(), "{} differ:\n{}", wrong.len(), wrong.join("\n"));
}
