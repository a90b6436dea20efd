//! Inputs that fuzzing found, each named by what went wrong.

use mapd_xodr::{Finding, Limits, Reader, Severity, rule_ids};

fn read(text: &[u8]) -> Vec<Finding> {
    let mut reader = Reader::new(text, Limits::default());
    while reader.next().expect("memory does not fail").is_some() {}
    reader.take_findings()
}

#[test]
fn text_up_to_the_end_of_a_document_that_is_cut() {
    let findings = read(b"<OpenDRIVE> text without an end");
    let is_it = |f: &Finding| f.rule == rule_ids::XML && f.severity == Severity::Error;
    assert!(findings.iter().any(is_it), "{findings:?}");
}

#[test]
fn a_note_on_what_lies_behind_bytes_that_are_refused() {
    let mut text = b"<?xml version='1.0' standalone='yes'\xff encoding='ISO-8859-1'?>".to_vec();
    text.splice(..0, *b"\xef\xbb\xbf");
    for finding in read(&text) {
        assert!(finding.span.start <= 36, "{finding:?}");
    }
}
