//! What only building finds has an entry in the catalog, whose examples behave as they say and which a configuration grades.

use mapd_compiler::{Compilation, CompileOptions, ReadOptions, compile_from};
use mapd_rules::{Check, Grade, Rule, Settings, catalog};
use mapd_xodr::Severity;
use std::collections::BTreeSet;

fn compile(text: &str, rules: &Settings) -> Compilation {
    let reading = ReadOptions { rules: rules.clone(), ..ReadOptions::default() };
    compile_from(|| Ok(text.as_bytes()), &reading, &CompileOptions::default(), &mut |_| {})
        .expect("reading from memory works")
}

/// The severities of a rule's findings in a document.
fn severities(text: &str, rule: &str, rules: &Settings) -> BTreeSet<Severity> {
    let compiled = compile(text, rules);
    let own = compiled.diagnostics.iter().filter(|d| d.finding.rule == rule);
    own.map(|d| d.finding.severity).collect()
}

fn graded(rule: &str, grade: Grade) -> Settings {
    Settings { grades: [(Box::from(rule), grade)].into(), ..Settings::default() }
}

/// What is wrong with the examples of a rule.
fn faults(rule: &Rule) -> Vec<String> {
    let document = |example: mapd_rules::Example| example.document(rule.example_version());
    let mut faults = Vec::new();
    let mut expect = |text: &str, settings: &Settings, expected: &[Severity]| {
        let found = severities(text, rule.id, settings);
        if found.iter().ne(expected) {
            faults.push(format!(
                "{}: expected {expected:?}, found {found:?} with {:?} in\n{text}\n",
                rule.id, settings.grades
            ));
        }
    };
    let valid = document(rule.valid).expect("what is valid is a document");
    expect(&valid, &Settings::default(), &[]);
    let Some(invalid) = document(rule.invalid) else { return faults };
    expect(&invalid, &Settings::default(), &[rule.severity]);
    let (off, info) = (Grade::Off, Severity::Info);
    if rule.fixed {
        expect(&invalid, &graded(rule.id, off), &[rule.severity]);
    } else {
        expect(&invalid, &graded(rule.id, off), &[]);
        expect(&invalid, &graded(rule.id, Grade::Severity(info)), &[info]);
    }
    faults
}

#[test]
fn examples_behave_as_they_say() {
    let built: Vec<_> = catalog::all().filter(|r| matches!(r.check, Check::Building)).collect();
    assert!(built.len() > 25, "{}", built.len());
    let faults: Vec<String> = built.into_iter().flat_map(faults).collect();
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn a_curve_that_cannot_be_evaluated_is_reported_once_and_always() {
    let rule = catalog::of(catalog::COMPUTABLE).expect("it is there");
    let text = rule.invalid.document(8).expect("a document");
    let unusable = catalog::building::UNUSABLE.id;
    let (off, warning) = (Grade::Off, Grade::Severity(Severity::Warning));
    for (settings, own, built) in [
        (Settings::default(), 1, 0),
        (graded(rule.id, off), 0, 1),
        (graded(rule.id, warning), 1, 1),
    ] {
        let compiled = compile(&text, &settings);
        let count = |id: &str| compiled.diagnostics.iter().filter(|d| d.finding.rule == id).count();
        let case = format!("{:?}: {:?}", settings.grades, compiled.diagnostics);
        assert_eq!([count(rule.id), count(unusable)], [own, built], "{case}");
        assert!(compiled.rows.is_none(), "{case}");
    }
}

#[test]
fn a_finding_of_reading_that_is_off_hides_no_reason() {
    let text = mapd_rules::Example::PlanView(
        r#"<geometry s="0" x="east" y="0" hdg="0" length="100"><line/></geometry>"#,
    );
    let text = text.document(8).expect("a document");
    let (value, unusable) = ("mapd:value.type", catalog::building::UNUSABLE.id);
    let (off, info) = (Grade::Off, Grade::Severity(Severity::Info));
    for (settings, expected) in [
        (Settings::default(), vec![(value, Severity::Error, true)]),
        (graded(value, off), vec![(unusable, Severity::Error, true)]),
        (
            graded(value, info),
            vec![(unusable, Severity::Error, true), (value, Severity::Info, false)],
        ),
    ] {
        let compiled = compile(&text, &settings);
        let mut found: Vec<_> = compiled
            .diagnostics
            .iter()
            .map(|d| (d.finding.rule, d.finding.severity, d.rejects))
            .filter(|(rule, ..)| [value, unusable].contains(rule))
            .collect();
        found.sort_unstable();
        assert_eq!(found, expected, "{:?}", settings.grades);
        assert!(compiled.rows.is_none());
    }
}
