//! What ASAM's checker finds in the files of its own tests, mapd finds too: the same rule, as bad, as often.
//!
//! Where it says so otherwise, `differential/asam_expected.tsv` has what it says and why.

use mapd_compiler::{ReadOptions, check_from};
use mapd_rules::{Profile, Settings};
use mapd_xodr::{Severity, rule_ids};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// A table of tab-separated columns: its rows without the header.
fn table(path: &Path) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(path).expect("the table is there");
    let rows = text.lines().skip(1).filter(|line| !line.is_empty());
    rows.map(|line| line.split('\t').map(str::to_owned).collect()).collect()
}

/// A rule's name in both: in small letters, without its version and what joins words.
fn name(rule: &str) -> String {
    let name = rule.rsplit(':').next().unwrap_or_default();
    name.to_lowercase().replace('_', "")
}

/// Findings of a document in the profile `asam`.
fn findings(text: &[u8]) -> Vec<mapd_xodr::Finding> {
    let settings = Settings { profile: Profile::Asam, ..Settings::default() };
    let options = ReadOptions { rules: settings, ..ReadOptions::default() };
    let checked = check_from(|| Ok(text), &options, &mut |_| {}).expect("reads");
    checked.diagnostics.into_iter().map(|diagnostic| diagnostic.finding).collect()
}

/// How often a map breaks each rule in the profile `asam`, and how bad that is, such as `2 error`.
fn found(map: &Path) -> BTreeMap<String, String> {
    let text = std::fs::read(map).expect("the map is there");
    let mut counts: BTreeMap<String, (usize, Severity)> = BTreeMap::new();
    for finding in findings(&text) {
        let entry = counts.entry(name(finding.rule)).or_insert((0, finding.severity));
        *entry = (entry.0 + 1, entry.1.max(finding.severity));
    }
    let say = |(count, severity): (usize, Severity)| format!("{count} {}", severity_name(severity));
    counts.into_iter().map(|(rule, counted)| (rule, say(counted))).collect()
}

fn severity_name(severity: Severity) -> &'static str {
    match severity {
        Severity::Info => "information",
        Severity::Warning => "warning",
        Severity::Error => "error",
    }
}

#[test]
fn what_the_checker_expects_is_found_as_bad_and_as_often() {
    let Some(folder) = mapd_tests::shared("found/qc-opendrive") else {
        mapd_tests::say("SKIPPED: no files of ASAM's checker beside the workspace");
        return;
    };
    let explained = mapd_tests::workspace().join("tests/differential/asam_expected.tsv");
    let mut explained: BTreeMap<(String, String), (String, String)> = table(&explained)
        .into_iter()
        .map(|row| {
            let [file, rule, theirs, ours, why] = row.try_into().expect("five columns");
            assert!(!why.is_empty(), "{file}, {rule}: a reason");
            assert_ne!(theirs, ours, "{file}, {rule}: a difference");
            ((file, rule), (theirs, ours))
        })
        .collect();
    let expected = table(&folder.join("expected.tsv"));
    assert!(!expected.is_empty(), "the checker expects something");
    let mut faults = Vec::new();
    let mut maps: BTreeMap<String, BTreeMap<String, String>> = BTreeMap::new();
    for row in expected {
        let [file, rule, count, severity] = row.try_into().expect("four columns");
        let theirs = format!("{count} {severity}");
        let map = maps.entry(file.clone()).or_insert_with(|| found(&folder.join(&file)));
        let ours = map.get(&name(&rule)).cloned().unwrap_or_else(|| "none".to_owned());
        let due = match explained.remove(&(file.clone(), rule.clone())) {
            Some((said, due)) => {
                assert_eq!(said, theirs, "{file}, {rule}: what the checker says");
                due
            }
            None => theirs,
        };
        if ours != due {
            faults.push(format!("{file}\t{rule}\tdue {due}\tfound {ours}"));
        }
    }
    assert!(faults.is_empty(), "{} differ:\n{}", faults.len(), faults.join("\n"));
    assert!(explained.is_empty(), "explained, but not expected: {explained:?}");
}

/// What the checker says of a document as a whole stands under its own id, as an error; a revision that is a number is defined
/// for it, whichever it is.
#[test]
fn documents_are_graded_as_the_checker_does() {
    const HEADER: &str = "asam.net:xodr:1.0.0:xml.fileheader_is_present";
    const VERSION: &str = "asam.net:xodr:1.0.0:xml.version_is_defined";
    const SCHEMA: &str = "asam.net:xodr:1.0.0:xml.valid_schema";
    const ROOT: &str = "asam.net:xodr:1.0.0:xml.root_tag_is_opendrive";
    const XML: &str = "asam.net:xodr:1.0.0:xml.valid_xml_document";
    const ROAD: &str = r#"<road id="1" length="9" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>"#;
    let with = |header: &str| format!("<OpenDRIVE>{header}{ROAD}</OpenDRIVE>");
    let of = |revision: &str| with(&format!("<header {revision}/>"));
    let sound = of(r#"revMajor="1" revMinor="7""#);
    let cases: [(String, &[&str]); 13] = [
        (sound.clone(), &[]),
        (with(""), &[HEADER]),
        (of(""), &[SCHEMA, VERSION]),
        (of(r#"revMajor="1""#), &[SCHEMA, VERSION]),
        (of(r#"revMajor="1" revMinor="x""#), &[SCHEMA, VERSION]),
        (of(r#"revMajor="1" revMinor="-1""#), &[VERSION]),
        (of(r#"revMajor="1" revMinor="65536""#), &[VERSION]),
        (of(r#"revMajor="1" revMinor="7.5""#), &[SCHEMA, VERSION]),
        // No schema is known: the checker says nothing, and mapd warns.
        (of(r#"revMajor="1" revMinor="99""#), &[]),
        (of(r#"revMajor="1" revMinor="3""#), &[]),
        (sound.replace("<line/>", ""), &[SCHEMA]),
        (sound.replace("OpenDRIVE", "ODrive"), &[ROOT]),
        (sound.replace("</OpenDRIVE>", ""), &[XML]),
    ];
    for (document, due) in cases {
        let findings = findings(document.as_bytes()).into_iter();
        let errors = findings.filter(|finding| finding.severity == Severity::Error);
        let errors: BTreeSet<_> = errors.filter_map(|found| rule_ids::asam(found.rule)).collect();
        assert_eq!(errors.into_iter().collect::<Vec<_>>(), due, "{document}");
    }
}
