//! Both examples of every rule behave as they say.

use mapd_rules::{Check, Checker, Example, Rule, Settings, catalog};
use mapd_xodr::{Finding, Limits, Reader, Severity};
use std::collections::BTreeSet;

/// What reading and the rules find in a document.
fn findings(document: &str) -> (Vec<Finding>, Vec<Finding>) {
    let mut reader = Reader::new(document.as_bytes(), Limits::default());
    let mut checker = Checker::new(&Settings::default());
    let mut read = Vec::new();
    while let Some(mut item) = reader.next().expect("reading from memory works") {
        read.extend(reader.take_findings());
        checker.item(&mut item);
    }
    read.extend(reader.take_findings());
    checker.finish();
    (read, checker.take_findings())
}

/// None for words.
fn document(rule: &Rule, example: Example) -> Option<String> {
    example.document(rule.example_version())
}

/// What is wrong with the examples of a rule; nothing if they are as they should be.
fn faults(rule: &Rule) -> Vec<String> {
    let mut faults = Vec::new();
    let (is_read, is_built) =
        (matches!(rule.check, Check::Reading), matches!(rule.check, Check::Building));
    let text = document(rule, rule.valid).expect("what is valid is a document");
    let (read, found) = findings(&text);
    let mut fault =
        |what: String, text: &str| faults.push(format!("{}: {what}\n{text}\n", rule.id));
    for finding in read.iter().filter(|finding| finding.severity > Severity::Info) {
        fault(format!("the valid example is not as the schema has it: {finding:?}"), &text);
    }
    for finding in found.iter().filter(|f| f.severity > Severity::Info || f.rule == rule.id) {
        fault(format!("the valid example has a finding: {finding:?}"), &text);
    }
    // A test of the compiler's holds the examples of what building finds.
    let Some(text) = document(rule, rule.invalid).filter(|_| !is_built) else { return faults };
    let mut fault =
        |what: String, text: &str| faults.push(format!("{}: {what}\n{text}\n", rule.id));
    let (read, found) = findings(&text);
    let found = if is_read { read.clone() } else { found };
    for finding in read.iter().filter(|_| !is_read).filter(|f| f.rule.starts_with("mapd:xml")) {
        fault(format!("the invalid example is no document: {finding:?}"), &text);
    }
    match found.iter().find(|finding| finding.rule == rule.id) {
        None => fault(format!("the invalid example is not found; but {found:?}"), &text),
        Some(finding) => {
            // The reader takes it as the schema does.
            if finding.severity != if is_read { rule.strict } else { rule.severity } {
                fault(format!("the invalid example is {:?}", finding.severity), &text);
            }
            if !is_read && !finding.path.starts_with("OpenDRIVE") {
                fault(format!("a path of {:?}", finding.path), &text);
            }
        }
    }
    faults
}

#[test]
fn examples_behave_as_they_say() {
    let faults: Vec<String> = catalog::all().flat_map(faults).collect();
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn ids_are_unique_and_meanings_are_sentences() {
    let mut ids = BTreeSet::new();
    for rule in catalog::all() {
        assert!(ids.insert(rule.id), "{} occurs twice", rule.id);
        for alias in rule.aliases {
            assert!(ids.insert(alias), "{alias} occurs twice");
        }
        assert!(rule.meaning.ends_with('.'), "{}: {}", rule.id, rule.meaning);
        assert!(rule.valid != rule.invalid, "{}", rule.id);
        assert!(rule.since <= rule.until, "{}", rule.id);
    }
}
