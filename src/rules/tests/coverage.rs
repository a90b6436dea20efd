//! Every rule of the list beside the project is in the catalog, said by the schema, kept by what mapd does, or left out.

use mapd_rules::{Grade, Profile, Settings, catalog, structural};
use mapd_xodr::{Limits, Reader, Severity};
use std::collections::BTreeMap;
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
        let document = entry.invalid.document(8).expect("a document");
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
        let takes_out = rule.severity == Severity::Error;
        assert_eq!(takes_out, !rule.because.is_empty(), "{}", rule.id);
    }
}

#[test]
fn the_documentation_is_what_the_catalog_yields() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    for mapd_rules::Page { path, text } in mapd_rules::documentation() {
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

/// Ids in the code of a source: what stands between two marks and has an id's form.
fn ids_in(text: &str) -> impl Iterator<Item = &str> {
    let is_id = |quoted: &&str| {
        let is_own = quoted.starts_with("mapd:") || quoted.starts_with("asam.net:xodr:");
        let plain = |c: char| c.is_ascii_alphanumeric() || ":._".contains(c);
        is_own && quoted.contains('.') && !quoted.ends_with('.') && quoted.chars().all(plain)
    };
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    code.flat_map(|line| line.split('"')).filter(is_id)
}

/// Every source below a folder, with its path.
fn sources(folder: &Path, show: &mut dyn FnMut(&Path, &str)) {
    for entry in std::fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("it can be read").path();
        if path.is_dir() {
            sources(&path, show);
        } else if path.extension().is_some_and(|end| end == "rs") {
            show(&path, &std::fs::read_to_string(&path).expect("sources are text"));
        }
    }
}

#[test]
fn no_finding_is_written_outside_the_catalog() {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let reader = own.join("../xodr/src/rule_ids.rs");
    let (mut strays, mut of_reader, mut files) = (Vec::new(), Vec::new(), 0);
    for krate in std::fs::read_dir(own.join("..")).expect("the crates' folder") {
        let folder = krate.expect("it can be read").path().join("src");
        if !folder.is_dir() {
            continue;
        }
        sources(&folder, &mut |path, text| {
            files += 1;
            let is_catalog = path.starts_with(own.join("../rules/src/catalog"))
                || path.ends_with("rules/src/structural.rs");
            for id in ids_in(text).filter(|_| !is_catalog) {
                if path == reader {
                    of_reader.push(id.to_owned());
                } else {
                    strays.push(format!("{}: {id}", path.display()));
                }
            }
        });
    }
    assert!(strays.is_empty(), "ids outside of the catalog:\n{}", strays.join("\n"));
    assert!(files > 100 && of_reader.len() > 25, "{files} files, {} ids", of_reader.len());
    // The reader is below the catalog and has its own list, of which each id that it writes is an entry.
    let schema = "asam.net:xodr:1.0.0:xml.valid_schema";
    let document = "asam.net:xodr:1.0.0:xml.valid_xml_document";
    for id in of_reader.iter().filter(|id| *id != schema && *id != document) {
        assert!(catalog::of(id).is_some(), "{id} has no entry");
    }
}

#[test]
fn findings_of_reading_and_building_are_graded() {
    let finding = |rule: &'static str, severity| mapd_xodr::Finding {
        rule,
        severity,
        span: mapd_xodr::Span::default(),
        path: String::new(),
        subject: "".into(),
        message: String::new(),
        hint: String::new(),
        count: 1,
    };
    use Severity::{Error, Info, Warning};
    let (gap, missing) = ("mapd:graph.gap", "mapd:graph.missing_lane");
    let (fixed, other) = ("mapd:compile.unusable", "mapd:xodr:1.4.0:geometry.computable");
    for (rule, found, grade, expected) in [
        (gap, Warning, Grade::Off, None),
        (gap, Warning, Grade::Severity(Error), Some(Error)),
        (gap, Warning, Grade::Severity(Info), Some(Info)),
        (missing, Error, Grade::Severity(Warning), Some(Warning)),
        // Milder than usual.
        (missing, Warning, Grade::Severity(Error), Some(Warning)),
        (missing, Warning, Grade::Severity(Info), Some(Info)),
        (fixed, Error, Grade::Off, Some(Error)),
        // Graded where it is made.
        (other, Warning, Grade::Severity(Error), Some(Warning)),
    ] {
        let grades = [(Box::from(rule), grade)].into();
        let settings = Settings { grades, ..Settings::default() };
        let again = settings.graded(finding(rule, found)).and_then(|once| settings.graded(once));
        assert_eq!(again.map(|finding| finding.severity), expected, "{rule} {found:?}, twice");
        let graded = settings.graded(finding(rule, found)).map(|finding| finding.severity);
        assert_eq!(graded, expected, "{rule} {found:?} {grade:?}");
        assert!(settings.unknown().is_empty(), "{rule}");
        assert_eq!(settings.fixed().len(), usize::from(rule == fixed), "{rule}");
    }
}

/// What the schema forbids is an error for whoever keeps to it. In the default profile it is a warning where it can be no error.
#[test]
fn findings_of_reading_are_graded_by_the_profile() {
    use Severity::{Error, Info, Warning};
    let (word, missing) = ("mapd:value.enumeration", "mapd:structure.missing_attribute");
    for (profile, rule, found, expected) in [
        (Profile::Default, word, Error, Warning),
        (Profile::Default, word, Warning, Warning),
        (Profile::Default, missing, Error, Error),
        (Profile::Strict, word, Error, Error),
        (Profile::Strict, word, Warning, Warning),
        (Profile::Asam, word, Error, Error),
        (Profile::Asam, "mapd:graph.gap", Warning, Warning),
        (Profile::Strict, "mapd:structure.deprecated", Info, Info),
    ] {
        let settings = Settings { profile, ..Settings::default() };
        let rule = catalog::of(rule).expect("it is there");
        assert_eq!(settings.severity_of(rule, found), Some(expected), "{profile:?} {}", rule.id);
    }
}
