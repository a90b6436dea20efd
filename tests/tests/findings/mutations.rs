//! Seeded mutations of good maps: none is accepted silently with another answer, unless what it changes is lawful either way.

use mapd_archive::encode;
use mapd_client::compiling::ByRow as _;
use mapd_compiler::{Compilation, CompileOptions, ReadOptions, Verdict, compile_from};
use std::collections::BTreeMap;

/// Mutations in all.
const MUTATIONS: usize = 1000;

/// Attributes of which another value is another lawful map: nothing in a file says which value is meant.
const LAWFUL: [(&str, &[&str]); 6] = [
    (
        "profiles that any number may shape",
        &["a", "b", "c", "d", "width", "height", "inner", "outer"],
    ),
    (
        "places of what stands alone or goes on from another place, where it faces, and lanes that it is for",
        &[
            "s",
            "t",
            "sOffset",
            "tOffset",
            "zOffset",
            "hOffset",
            "fromLane",
            "toLane",
            "orientation",
            "from",
            "to",
            "id",
        ],
    ),
    (
        "kinds and properties that the road does not tell otherwise",
        &[
            "type",
            "subtype",
            "max",
            "unit",
            "country",
            "value",
            "level",
            "lane",
            "rule",
            "color",
            "weight",
            "material",
            "laneChange",
            "space",
            "surface",
            "friction",
            "roughness",
            "text",
        ],
    ),
    ("names, and free texts", &["name", "vendor", "date", "version"]),
    (
        "heights measured on the spot, how far apart, from where on and how they go over into a road's; a row may have any number of them",
        &["left", "center", "right", "sStart", "gridSpacing", "transitionLength"],
    ),
    ("what the header says of the file", &["north", "south", "east", "west", "revMinor"]),
];

/// What no rule can tell from rounding: no point of the map moves farther `[m]`.
const ROUNDING: f64 = 0.01;

/// A small generator of numbers, the same on every machine (xorshift64*).
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let high = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33;
        usize::try_from(high).unwrap_or(0) % bound.max(1)
    }
}

/// Every attribute: where its name begins, where its value begins and ends.
fn attributes(text: &str) -> Vec<(usize, usize, usize)> {
    let mut found = Vec::new();
    for (at, _) in text.match_indices("=\"") {
        let name = text[..at].rfind([' ', '\n', '\t']).map_or(0, |space| space + 1);
        if let Some(length) = text[at + 2..].find('"') {
            found.push((name, at + 2, at + 2 + length));
        }
    }
    found
}

/// The text with one attribute changed, the attribute's name and what was done.
fn mutated(
    text: &str,
    places: &[(usize, usize, usize)],
    numbers: &mut Numbers,
) -> (String, String, &'static str) {
    let (name, from, to) = places[numbers.below(places.len())];
    let value = &text[from..to];
    let number: Option<f64> = value.parse().ok();
    let other = places[numbers.below(places.len())];
    let (what, new) = match (numbers.below(8), number) {
        (0, _) => ("removed", None),
        (1, _) => ("emptied", Some(String::new())),
        (2, _) => ("no number", Some("NaN".to_owned())),
        (3, Some(number)) if number != 0.0 => ("negated", Some((-number).to_string())),
        (4, Some(number)) => ("ten times", Some((10.0 * number).to_string())),
        (5, Some(number)) => ("five more", Some((number + 5.0).to_string())),
        (6, _) => ("another's", Some(text[other.1..other.2].to_owned())),
        _ => ("unknown", Some("mutant".to_owned())),
    };
    let key = text[name..from].trim_end_matches("=\"").to_owned();
    let out = match new {
        None => format!("{}{}", &text[..name], &text[to + 1..]),
        Some(new) => format!("{}{new}{}", &text[..from], &text[to..]),
    };
    (out, key, what)
}

fn compiled(text: &str) -> Compilation {
    let options = CompileOptions::default();
    compile_from(|| Ok(text.as_bytes()), &ReadOptions::default(), &options, &mut |_| {})
        .expect("reading works")
}

/// What is found, by rule.
fn findings(compiled: &Compilation) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    for d in &compiled.diagnostics {
        *counts.entry(d.finding.rule).or_default() += 1;
    }
    counts
}

fn body(compiled: &Compilation) -> Vec<u8> {
    let rows = compiled.rows.as_ref().expect("accepted");
    let bytes = encode(rows, &compiled.provenance).expect("encodes");
    bytes[mapd_archive::HEADER_LENGTH..].to_vec()
}

/// Good maps with their names: those that the project carries, and one with traffic lights, their controllers, objects and
/// junctions of a simulator.
fn maps() -> Vec<(String, String)> {
    let carried = ["one_road.xodr", "town.xodr", "surfaces.xodr"];
    let mut files: Vec<_> = carried.map(mapd_tests::carried).into();
    match mapd_tests::shared("maps") {
        Some(folder) => files.push(folder.join("esmini/fabriksgatan_traffic_lights.xodr")),
        None => mapd_tests::say("without the map of ../shared"),
    }
    let read = |path: &std::path::PathBuf| {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        (name, std::fs::read_to_string(path).expect("the map is there"))
    };
    files.iter().map(read).collect()
}

/// The farthest that a point of a lane has moved `[m]`; infinite where lanes or points are others.
fn farthest(a: &Compilation, b: &Compilation) -> f64 {
    let points = |compiled: &Compilation| -> Vec<[f64; 3]> {
        let rows = compiled.rows.as_ref().expect("accepted");
        let bytes = mapd_archive::encode(rows, &compiled.provenance).expect("encodes");
        let snapshot = mapd_client::Snapshot::from_bytes(bytes).expect("opens");
        let map = snapshot.map();
        let lanes = (0..rows.lanes.len() as u32).filter_map(|lane| map.lane_by_row(lane));
        let lines = lanes.flat_map(|lane| [lane.center_line(), lane.border()]);
        lines.flat_map(|line| line.positions()).map(|position| position.to_array()).collect()
    };
    let (a, b) = (points(a), points(b));
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    let differences =
        a.iter().zip(&b).flat_map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a - b).abs()));
    differences.fold(0.0, f64::max)
}

/// Whether what was changed is a geometry of a reference line or a curve of one: what moves lanes and nothing else.
fn is_curve(before: &str, after: &str) -> bool {
    let place = before.bytes().zip(after.bytes()).position(|(a, b)| a != b).unwrap_or(0);
    let tag = &before[before[..place].rfind('<').unwrap_or(0)..];
    ["<geometry ", "<arc ", "<spiral ", "<paramPoly3 "].iter().any(|name| tag.starts_with(name))
}

/// Whether what was changed stands in a vendor's own data, which the archive keeps as it is written.
fn is_user_data(before: &str, after: &str) -> bool {
    let place = before.bytes().zip(after.bytes()).position(|(a, b)| a != b).unwrap_or(0);
    let Some(start) = before[..place].rfind("<userData") else {
        return false;
    };
    let (inside, tag) = (&before[start..place], before[start..].find('>').unwrap_or(0));
    let closed = before[..start + tag].ends_with('/') && start + tag < place;
    !closed && !inside.contains("</userData>")
}

#[test]
fn no_mutation_is_accepted_silently() {
    let maps = maps();
    let (maps, texts): (Vec<String>, Vec<String>) = maps.into_iter().unzip();
    let mut numbers = Numbers(0x5EED);
    let (mut found, mut harmless, mut rounding, mut lawful) =
        (0, 0, 0, BTreeMap::<String, usize>::new());
    let mut silent = Vec::new();
    let good: Vec<_> = texts
        .iter()
        .map(|text| {
            let compiled = compiled(text);
            assert_eq!(compiled.verdict, Verdict::Accepted);
            let (findings, body) = (findings(&compiled), body(&compiled));
            (attributes(text), findings, body, compiled)
        })
        .collect();
    for round in 0..MUTATIONS {
        let (text, (places, before, bytes, whole)) =
            (&texts[round % texts.len()], &good[round % texts.len()]);
        let (text, name, what) = mutated(text, places, &mut numbers);
        let after = compiled(&text);
        if after.verdict != Verdict::Accepted || findings(&after) != *before {
            found += 1;
        } else if body(&after) == *bytes {
            harmless += 1;
        } else if LAWFUL.iter().any(|(_, names)| names.contains(&&*name)) {
            *lawful.entry(name).or_default() += 1;
        } else if is_user_data(&texts[round % texts.len()], &text) {
            *lawful.entry("userData".to_owned()).or_default() += 1;
        } else if is_curve(&texts[round % texts.len()], &text)
            && farthest(&after, whole) <= ROUNDING
        {
            rounding += 1;
        } else {
            let place =
                text.bytes().zip(texts[round % texts.len()].bytes()).position(|(a, b)| a != b);
            let place = place.unwrap_or(0);
            let tag = text[..place].rfind('<').unwrap_or(0);
            let map = &maps[round % texts.len()];
            silent.push(format!("{map}: {} {what}", &text[tag..(place + 40).min(text.len())]));
        }
    }
    mapd_tests::say(&format!(
        "{MUTATIONS} mutations: {found} found, {harmless} harmless, {rounding} rounding, lawful {lawful:?}"
    ));
    assert!(silent.is_empty(), "{} silent: {silent:?}", silent.len());
}
