//! Every rule of the list beside the project is in the catalog, said by the schema, kept by what mapd does, or left out.

use mapd_rules::{catalog, structural};
use mapd_xodr::{Limits, Reader, Severity};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Rules that may be left out.
const LEFT_OUT: usize = 15;

/// Ids with where they are accounted for.
fn accounted() -> BTreeMap<&'static str, &'static str> {
    let mut ids = BTreeMap::new();
    let mut add = |id, place| {
        let before = ids.insert(id, place);
        assert!(before.is_none(), "{id} is accounted for twice: {before:?} and {place}");
    };
    for rule in catalog::all() {
        add(rule.id, "catalog");
        rule.aliases.iter().for_each(|id| add(id, "catalog"));
    }
    for entry in structural::STRUCTURAL {
        entry.ids.iter().for_each(|id| add(id, "schema"));
    }
    structural::KEPT.iter().for_each(|(id, _)| add(id, "kept"));
    structural::LEFT_OUT.iter().for_each(|(id, _)| add(id, "left out"));
    ids
}

#[test]
fn every_listed_rule_is_accounted_for() {
    assert!(structural::LEFT_OUT.len() <= LEFT_OUT);
    let ids = accounted();
    let list = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/spec/rules.tsv");
    let Ok(list) = std::fs::read_to_string(&list) else {
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), "skipped: no list of rules at {}", list.display());
        return;
    };
    let due = list.lines().skip(1).filter_map(|line| {
        let fields: Vec<&str> = line.split('\t').collect();
        matches!(fields.get(4), Some(&"D" | &"G")).then(|| fields[0])
    });
    let missing: Vec<&str> = due.filter(|id| !ids.contains_key(id)).collect();
    assert!(missing.is_empty(), "{} rules are missing:\n{}", missing.len(), missing.join("\n"));
}

#[test]
fn the_schema_says_what_it_is_said_to() {
    for entry in structural::STRUCTURAL {
        let document = entry.invalid.document(8);
        let mut reader = Reader::new(document.as_bytes(), Limits::default());
        while reader.next().expect("reading from memory works").is_some() {}
        let findings = reader.take_findings();
        let is_said = findings.iter().any(|finding| {
            finding.rule == entry.by
                && (entry.subject.is_empty() || *finding.subject == *entry.subject)
        });
        assert!(
            is_said,
            "{:?}: {} is not found in\n{document}\nbut {findings:#?}",
            entry.ids, entry.by
        );
    }
}

#[test]
fn every_rule_that_takes_a_part_out_says_why() {
    for rule in catalog::all() {
        assert_eq!(rule.severity == Severity::Error, !rule.because.is_empty(), "{}", rule.id);
    }
}

#[test]
fn the_documentation_is_what_the_catalog_yields() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    for (path, text) in mapd_rules::documentation() {
        let written = std::fs::read_to_string(docs.join(&path)).unwrap_or_default();
        assert!(
            written == text,
            "docs/{path} is not clean: cargo run -p mapd-rules --example rules_doc"
        );
    }
    let checks = std::fs::read_to_string(docs.join("checks.md")).unwrap_or_default();
    assert!(
        mapd_rules::with_errors(&checks).as_ref() == Some(&checks),
        "docs/checks.md is not clean: cargo run -p mapd-rules --example rules_doc"
    );
}

/// Ids of the compiler's own findings in a text: `mapd:compile.…` and `mapd:graph.…` between two marks.
fn building_ids(text: &str, mark: char, into: &mut BTreeSet<String>) {
    for quoted in text.split(mark) {
        let name = quoted.strip_prefix("mapd:compile.").or(quoted.strip_prefix("mapd:graph."));
        let is_name = |name: &str| name.chars().all(|c| c.is_ascii_lowercase() || c == '_');
        if name.is_some_and(is_name) {
            into.insert(quoted.to_owned());
        }
    }
}

/// Every file of a folder, as text.
fn sources(folder: &Path, show: &mut dyn FnMut(&str)) {
    for entry in std::fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("it can be read").path();
        if path.is_dir() {
            sources(&path, show);
        } else {
            show(&std::fs::read_to_string(&path).expect("sources are text"));
        }
    }
}

#[test]
fn every_finding_of_the_compiler_is_on_the_page_of_checks() {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut written, mut listed) = (BTreeSet::new(), BTreeSet::new());
    sources(&own.join("../compiler/src"), &mut |text| building_ids(text, '"', &mut written));
    let page =
        std::fs::read_to_string(own.join("../../docs/checks.md")).expect("the page is there");
    let (_, list) = page.split_once("### What only building finds").expect("it has the list");
    building_ids(list.split_once("\n## ").map_or(list, |(list, _)| list), '`', &mut listed);
    assert!(written.contains("mapd:compile.unusable"), "{written:?}");
    assert_eq!(written, listed);
}
