//! What the lists of the public API in `docs/api` must be like: enums that may grow say so, and what does not is named here with its reason; the cause of
//! an error is its `source`.

use mapd_tests::workspace;
use std::collections::BTreeSet;

/// Enums that a caller may match without a case for others, and why no case will be added to them.
const EXHAUSTIVE: &[(&str, &str)] = &[
    ("mapd_archive::FromSide", "there are two sides"),
    ("mapd_archive::RowMapping", "how the compiler moves rows; who moves rows handles all ways"),
    ("mapd_client::overlay::Decision", "a new outcome is a new protocol; a planner handles all"),
    ("mapd_compiler::Progress", "the program passes every stage on between processes"),
    ("mapd_compiler::Treatment", "a part is gone, or its line is left"),
    ("mapd_compiler::Verdict", "a build ends with a map, with parts of it, or without one"),
    ("mapd_geodesy::Form", "what is none of the others is `Other`"),
    ("mapd_geometry::CurveKind", "who evaluates curves must know all shapes"),
    ("mapd_geometry::OnlyFoot", "there is one foot, none, or it cannot be told"),
    ("mapd_geometry::ParameterRange", "the two of OpenDRIVE"),
    ("mapd_geometry::Primitive", "who evaluates curves must know all shapes"),
    ("mapd_overlay::Across", "the two forms in JSON: a word, or numbers"),
    ("mapd_overlay::RoadId", "the two forms in JSON: text, or a number"),
    ("mapd_query::Clamped", "an s lies within, before or after"),
    ("mapd_query::localisation::LandmarkSource", "a map has signals and objects; C has both"),
    ("mapd_query::localisation::MarkSource", "of a road mark, or of an object; C has both"),
    ("mapd_query::localisation::Side", "there are two sides"),
    ("mapd_query::localisation::Tracked", "in a lane, in none, or unknown; a planner handles all"),
    ("mapd_query::roads::RoadLink", "OpenDRIVE links roads to roads and to junctions"),
    ("mapd_query::route::Enter", "how a lane can be entered; a planner handles all"),
    ("mapd_query::rules::LineSource", "a map has signals and objects; C has both"),
    ("mapd_query::rules::Turn", "four directions; a planner handles all"),
    ("mapd_rules::Grade", "a rule is off, or has a severity"),
    ("mapd_xodr::Severity", "an order, in which a caller compares"),
];

/// The lines of all lists.
fn lines() -> Vec<String> {
    let folder = std::fs::read_dir(workspace().join("docs/api")).expect("a folder");
    let files = folder.map(|file| file.expect("a file").path());
    let lists = files.filter(|path| !path.ends_with("mapd.txt"));
    let texts = lists.map(|path| std::fs::read_to_string(path).expect("text"));
    texts.flat_map(|text| text.lines().map(str::to_owned).collect::<Vec<_>>()).collect()
}

/// The enums of lists that are not `#[non_exhaustive]`.
fn exhaustive(lines: &[String]) -> BTreeSet<&str> {
    let enums = lines.iter().filter(|line| !line.contains("#[non_exhaustive]"));
    let names = enums.filter_map(|line| Some(line.split_once("pub enum ")?.1));
    names.map(|name| name.split('<').next().unwrap_or(name)).collect()
}

#[test]
fn enums_that_may_grow_say_so() {
    let lines = lines();
    let found = exhaustive(&lines);
    let known: BTreeSet<&str> = EXHAUSTIVE.iter().map(|(name, _)| *name).collect();
    let new: Vec<_> = found.difference(&known).collect();
    assert!(new.is_empty(), "neither #[non_exhaustive] nor listed with a reason: {new:?}");
    let gone: Vec<_> = known.difference(&found).collect();
    assert!(gone.is_empty(), "listed, and no longer exhaustive: {gone:?}");
}

#[test]
fn an_enum_without_the_attribute_is_found() {
    let lines = ["pub enum a::New", "#[non_exhaustive] pub enum a::Old", "pub enum a::Of<'a>"];
    let lines = lines.map(str::to_owned);
    assert_eq!(exhaustive(&lines), BTreeSet::from(["a::New", "a::Of"]));
}

/// Fields of errors that hold another error and are not its `source`.
fn causes(lines: &[String]) -> Vec<&str> {
    let of = |line: &'_ str| {
        let (field, kind) = line.strip_prefix("pub ")?.split_once(": ")?;
        let (owner, name) = field.rsplit_once("::")?;
        let is_error = owner.split("::").any(|part| part.ends_with("Error"));
        (is_error && kind.ends_with("Error") && name != "source").then_some(())
    };
    lines.iter().map(String::as_str).filter(|line| of(line).is_some()).collect()
}

#[test]
fn causes_of_errors_are_their_sources() {
    let lines = lines();
    assert_eq!(causes(&lines), Vec::<&str>::new());
    assert!(lines.iter().any(|line| line.contains("Error::Io::source: ")), "no cause is listed");
}

#[test]
fn a_cause_by_another_name_is_found() {
    let lines = [
        "pub a::ReadError::Io::error: std::io::error::Error",
        "pub a::ReadError::Io::source: std::io::error::Error",
        "pub a::ReadError::Io::path: std::path::PathBuf",
        "pub a::Finding::error: std::io::error::Error",
    ];
    let lines = lines.map(str::to_owned);
    assert_eq!(causes(&lines), ["pub a::ReadError::Io::error: std::io::error::Error"]);
}
