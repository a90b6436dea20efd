//! An error takes its part out of the map, or rejects the map: a map that is accepted whole has none, in any profile.

use mapd_compiler::{Compilation, CompileOptions, ReadOptions, Verdict, compile_from};
use mapd_rules::{Check, Grade, Profile, Settings, catalog};
use mapd_xodr::Severity;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn compiled(text: &[u8], rules: &Settings) -> Compilation {
    let reading = ReadOptions { rules: rules.clone(), ..ReadOptions::default() };
    compile_from(|| Ok(text), &reading, &CompileOptions::default(), &mut |_| {})
        .expect("reading from memory works")
}

fn of(profile: Profile) -> Settings {
    Settings { profile, ..Settings::default() }
}

/// What contradicts the meaning of an error.
fn fault(compiled: &Compilation) -> Option<String> {
    let errors = compiled.counts.of(Severity::Error);
    let is_whole = compiled.verdict == Verdict::Accepted;
    if is_whole != (errors == 0) {
        return Some(format!("{:?} with {errors} errors", compiled.verdict));
    }
    if (compiled.verdict == Verdict::Quarantined) == compiled.quarantined.is_empty() {
        return Some(format!("{:?} without {:?}", compiled.verdict, compiled.quarantined));
    }
    let other =
        |d: &&mapd_compiler::Diagnostic| d.rejects != (d.finding.severity == Severity::Error);
    compiled.diagnostics.iter().find(other).map(|d| format!("{d:?}"))
}

/// Every map in a folder and in those within it.
fn maps_in(folder: &Path, maps: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("it can be read").path();
        let is_map = path.extension().is_some_and(|end| end == "xodr" || end == "xodrz");
        if path.is_dir() {
            maps_in(&path, maps);
        } else if is_map {
            maps.push(path);
        }
    }
}

/// Of 149 maps, 35 were accepted with errors.
#[test]
fn a_map_that_is_accepted_whole_has_no_errors() {
    let carried = ["examples", "tests/data"].map(|folder| mapd_tests::workspace().join(folder));
    let mut maps = Vec::new();
    carried.iter().for_each(|folder| maps_in(folder, &mut maps));
    assert!(maps.len() > 10, "{maps:?}");
    for folder in ["maps", "found"] {
        match mapd_tests::shared(folder) {
            Some(folder) => maps_in(&folder, &mut maps),
            None => mapd_tests::say(&format!("SKIPPED in part: no {folder} beside the workspace")),
        }
    }
    let mut faults = Vec::new();
    for path in maps {
        let text = std::fs::read(&path).expect("the map is there");
        for (name, profile) in Profile::ALL {
            let fault = fault(&compiled(&text, &of(profile)));
            faults.extend(fault.map(|fault| format!("{}, {name}: {fault}", path.display())));
        }
    }
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

/// A rule that a configuration makes an error takes out what breaks it; a milder finding of the rule stays what it is.
#[test]
fn whatever_is_graded_an_error_takes_something_out() {
    let mut faults = Vec::new();
    for rule in catalog::all() {
        let Some(text) = rule.invalid.document(rule.example_version()) else { continue };
        let grades = [(Box::from(rule.id), Grade::Severity(Severity::Error))].into();
        let graded = Settings { grades, ..Settings::default() };
        for settings in [graded, of(Profile::Default), of(Profile::Strict), of(Profile::Asam)] {
            let compiled = compiled(text.as_bytes(), &settings);
            let own = compiled.diagnostics.iter().filter(|d| d.finding.rule == rule.id);
            let worst = own.map(|d| d.finding.severity).max();
            let mut fault = fault(&compiled);
            if fault.is_none() && !settings.grades.is_empty() && worst < Some(Severity::Error) {
                fault = Some(format!("{worst:?}"));
            }
            // Examples of what is built are for the versions that have them.
            if fault.is_none()
                && !matches!(rule.check, Check::Building)
                && worst < settings.severity(rule)
            {
                fault = Some(format!("{worst:?} in place of {:?}", settings.severity(rule)));
            }
            faults.extend(fault.map(|fault| format!("{}, {settings:?}: {fault}\n{text}", rule.id)));
        }
    }
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

/// What reading finds in the header or at the root is in no part.
#[test]
fn an_error_in_no_part_rejects_the_map() {
    const ROAD: &str = r#"<road id="1" length="9" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0"/></center></laneSection></lanes></road>"#;
    const HEADER: &str = r#"<header revMajor="1" revMinor="8"/>"#;
    let version = "asam.net:xodr:1.0.0:xml.version_is_defined";
    for (rule, inner) in [
        (
            "mapd:structure.unknown_attribute",
            format!("{}{ROAD}", HEADER.replace("/>", " new=\"1\"/>")),
        ),
        (
            "mapd:structure.unknown_attribute",
            format!("{ROAD}{}", HEADER.replace("/>", " new=\"1\"/>")),
        ),
        ("mapd:structure.unknown_element", format!("{HEADER}{ROAD}<street/>")),
        (version, format!("{}{ROAD}", HEADER.replace('8', "x"))),
    ] {
        let text = format!("<OpenDRIVE>{inner}</OpenDRIVE>");
        let whole = compiled(text.as_bytes(), &Settings::default());
        assert_eq!((whole.verdict, fault(&whole)), (Verdict::Accepted, None), "{text}");
        let grades = [(Box::from(rule), Grade::Severity(Severity::Error))].into();
        let graded = compiled(text.as_bytes(), &Settings { grades, ..Settings::default() });
        assert_eq!((graded.verdict, fault(&graded)), (Verdict::Rejected, None), "{text}");
    }
}

/// What can be built without a part is found even if the part is an error: the profile `asam` tells as much as the default profile.
#[test]
fn an_error_of_reading_hides_nothing_that_building_finds() {
    let objects =
        r#"<object id="1" type="lamppost" s="10" t="900" zOffset="0" orientation="none"/>"#;
    let text = mapd_rules::Example::Objects(objects).document(8).expect("a document");
    let told = |profile| -> BTreeSet<&str> {
        let compiled = compiled(text.as_bytes(), &of(profile));
        compiled.counts.iter().map(|(_, rule, _)| rule).collect()
    };
    let (word, lane) = ("mapd:value.enumeration", "mapd:compile.object_lane");
    for profile in [Profile::Default, Profile::Asam] {
        assert!(
            [word, lane].iter().all(|rule| told(profile).contains(rule)),
            "{:?}",
            told(profile)
        );
    }
}

/// The sentence stands in the documentation and in the help, word for word.
#[test]
fn the_same_sentence_says_it_everywhere() {
    let docs = ["docs/checks.md", "docs/reading.md", "docs/rules.md"];
    for page in docs {
        let text = std::fs::read_to_string(mapd_tests::workspace().join(page)).expect("the page");
        assert!(text.contains(mapd_rules::ERROR), "{page}");
    }
    let program = env!("CARGO_BIN_EXE_mapd_under_test");
    let help = mapd_tests::command::run(program, &["help", "check"], "");
    let said = String::from_utf8(help.stdout).expect("UTF-8");
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words(&said).contains(&words(mapd_rules::ERROR)), "{said}");
}
