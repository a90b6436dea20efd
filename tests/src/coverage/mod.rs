//! What becomes of every element and attribute of OpenDRIVE, found by writing each value in two ways.
//!
//! Small documents in `data/coverage` have every element and attribute of the table. For each value, a second document
//! has another one in its place; the archives of both are decoded by the layout alone and compared row by row.

mod compare;
mod document;
mod other_values;

use crate::workspace;
use compare::{Difference, compile, differences};
use document::{Document, ValueLocation};
use mapd_schemas::opendrive::coverage::Shown;
use mapd_schemas::opendrive::{Element, Table};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Tables that are named beside a value.
const MOST_TABLES: usize = 4;

/// Values that nothing in a map may follow from, and why: element, attribute, reason.
const CHECKED: &[(&str, &str, &str)] = &[
    ("PersonSemanticsType", "", "the standard has one word for it"),
    ("CurveLocalLine", "", "a curve of an outline is straight unless it has another shape"),
];

/// What was found: by element and attribute; of elements themselves the attribute is empty.
pub type Coverage = BTreeMap<(String, String), Shown>;

/// The table of OpenDRIVE.
pub fn table() -> Table {
    Table::read(&workspace().join("schemas/opendrive")).expect("the table reads")
}

/// The page that a run yields.
pub fn page(table: &Table, coverage: &Coverage) -> String {
    mapd_schemas::opendrive::coverage::page(table, &|element, attribute| {
        let key = (element.to_owned(), attribute.unwrap_or_default().to_owned());
        coverage.get(&key).cloned().unwrap_or_default()
    })
}

/// Tries every element and attribute; what no document shows is said in words.
pub fn run(table: &Table) -> (Coverage, Vec<String>) {
    let documents = documents(table);
    let wanted = table.elements().flat_map(|element| {
        let attributes = element.attributes.iter().map(move |a| (element, a.name.as_str()));
        std::iter::once((element, "")).chain(attributes)
    });
    let wanted: Vec<(&Element, &str)> = wanted.collect();
    let found: Vec<_> = wanted
        .par_iter()
        .map(|(element, attribute)| {
            (element, attribute, show(table, &documents, element, attribute))
        })
        .collect();
    let (mut coverage, mut missing) = (Coverage::new(), Vec::new());
    for (element, attribute, shown) in found {
        let key = (element.name.clone(), (*attribute).to_owned());
        match shown {
            Some(shown) => drop(coverage.insert(key, shown)),
            // An element with attributes is what its attributes are.
            None if attribute.is_empty() && !element.attributes.is_empty() => {}
            None => missing.push(format!("{} {attribute}", element.name)),
        }
    }
    for element in table.elements().filter(|element| !element.attributes.is_empty()) {
        let of = |word: &str| {
            let shown = element
                .attributes
                .iter()
                .filter_map(|a| coverage.get(&(element.name.clone(), a.name.clone())));
            shown.into_iter().any(|shown| shown.word == word)
        };
        let word = ["builds", "stores", "keeps", "checks"].into_iter().find(|word| of(word));
        let key = (element.name.clone(), String::new());
        let shown = Shown { word: word.unwrap_or_default(), places: String::new() };
        coverage.insert(key, shown);
    }
    (coverage, missing)
}

/// Where the documents lie; what they include lies in `parts`.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/coverage")
}

/// All documents, with the archive of each.
fn documents(table: &Table) -> Vec<(Document, Vec<mapd_schemas::decode::Rows>)> {
    let entries = std::fs::read_dir(folder()).expect("documents").flatten();
    let mut paths: Vec<_> =
        entries.map(|entry| entry.path()).filter(|path| path.is_file()).collect();
    paths.sort();
    let carried = paths.iter().map(|path| std::fs::read_to_string(path).expect("text"));
    // What else is tested of the lane graph has what these lack.
    let of_graphs = [
        crate::graph_maps::side_road("elementId=\"2\" elementS=\"0\" elementDir=\"+\""),
        crate::graph_maps::crossing_path("walking", 2),
        crate::graph_maps::slow_exit(" overlapZone=\"30\""),
    ];
    let inside = crate::graph_maps::all().into_iter().find(|map| map.text.contains("elementDir"));
    let texts: Vec<String> = carried.chain(of_graphs).chain(inside.map(|map| map.text)).collect();
    let read = |text: &String| {
        let document = Document::read(table, text.clone());
        let rows =
            compile(&document.text).unwrap_or_else(|told| panic!("not accepted: {told}\n{text}"));
        (document, rows)
    };
    texts.par_iter().map(read).collect()
}

type Documents = [(Document, Vec<mapd_schemas::decode::Rows>)];

/// What a value becomes: by the first document in which another one makes a difference.
fn show(table: &Table, documents: &Documents, element: &Element, name: &str) -> Option<Shown> {
    if let Some((.., why)) = CHECKED.iter().find(|(e, a, _)| *e == element.name && *a == name) {
        return Some(Shown { word: "checks", places: (*why).to_owned() });
    }
    let attribute = element.attributes.iter().find(|a| a.name == name);
    if let Some(only) = attribute.and_then(|a| fixed(a.kind.last())) {
        return Some(Shown { word: "checks", places: format!("always {only}") });
    }
    let mut weaker: Option<Shown> = None;
    for (document, rows) in documents {
        if weaker.is_some() {
            break;
        }
        for place in document.places(&element.name, name) {
            for value in other_values::of(table, element, name, document, place) {
                let text = document.with(place, &value);
                let Ok(changed) = compile(&text) else { continue };
                let written = (document.value(place), value.as_str());
                let shown = judge(&differences(rows, &changed), written, place);
                match shown {
                    Some(shown) if shown.word != "builds" => return Some(shown),
                    Some(shown) => weaker = weaker.or(Some(shown)),
                    None => {}
                }
            }
            // Without it no map can be built.
            if name.is_empty() && place.is_element && weaker.is_none() {
                weaker = compile(&document.with(place, "")).is_err().then(|| Shown {
                    word: "builds",
                    places: "no map is built without it".to_owned(),
                });
            }
        }
    }
    weaker
}

/// The value that an attribute has to have, where there is only one.
fn fixed(kind: &str) -> Option<&str> {
    kind.split(' ').next_back().and_then(|range| range.strip_prefix('='))
}

/// What differences say of a value.
fn judge(
    all: &[Difference],
    (written, value): (&str, &str),
    place: &ValueLocation,
) -> Option<Shown> {
    if all.is_empty() {
        return None;
    }
    let holds: Vec<&Difference> =
        all.iter().filter(|one| !place.is_element && one.holds(written, value)).collect();
    let only_kept = all.iter().all(|one| one.table == "annotations");
    let (word, mut places): (&str, Vec<String>) = if only_kept {
        if holds.is_empty() && !place.is_element {
            return None;
        }
        ("keeps", vec!["`annotations`".to_owned()])
    } else if !holds.is_empty() {
        ("stores", holds.iter().map(|one| format!("`{}.{}`", one.table, one.field)).collect())
    } else if !place.is_element && all.iter().all(|one| one.is_code) {
        ("stores", all.iter().map(|one| format!("`{}.{}`", one.table, one.field)).collect())
    } else {
        ("builds", all.iter().map(|one| format!("`{}`", one.table)).collect())
    };
    places.dedup();
    let more = places.len() > MOST_TABLES;
    places.truncate(MOST_TABLES);
    let more = if more { ", …" } else { "" };
    Some(Shown { word, places: places.join(", ") + more })
}
