//! Reads any bytes as a document. The size of the reads does not matter; every finding has a place; and where the whole
//! document is read, the reader and the scan for well-formedness agree on whether it is XML.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mapd_xodr::source::{Inputs, Refusal, RefusalKind, Source, SourceLimits};
use mapd_xodr::well_formed::scan;
use mapd_xodr::{Finding, Item, Limits, Reader, Severity, rule_ids};
use std::io::{Cursor, Read};

/// Findings beyond which an input of some kilobytes shows that their number is not bounded.
const FINDINGS: usize = 100_000;

/// The bytes in two pieces, which reads do not cross.
fn torn(bytes: &[u8]) -> Box<dyn Read + Send + '_> {
    let (first, second) = bytes.split_at(bytes.len() / 2);
    Box::new(Cursor::new(first).chain(Cursor::new(second)))
}

/// The decoded text, where it ends, where it is refused, and how much there is to note.
fn decode<'a>(input: Box<dyn Read + Send + 'a>) -> (Vec<u8>, u64, Option<Refusal>, usize) {
    let mut source = Inputs::new(SourceLimits::default()).open(input, "");
    let mut text = Vec::new();
    let end = source.read_to_end(&mut text).err();
    let refusal = end.map(|error| Source::refusal(&error).cloned().expect("memory does not fail"));
    (text, source.offset(), refusal, source.take_notes().len())
}

fn read<'a>(input: Box<dyn Read + Send + 'a>, end: u64) -> (Vec<Item>, Vec<Finding>) {
    let mut reader = Reader::new(input, Limits::default());
    let (mut items, mut findings) = (Vec::new(), Vec::new());
    loop {
        let item = reader.next().expect("memory does not fail");
        findings.append(&mut reader.take_findings());
        match item {
            Some(item) => items.push(item),
            None => break,
        }
    }
    for finding in &findings {
        let at = reader.position(finding.span.start);
        assert!(at.line >= 1 && at.column >= 1);
        assert!(finding.span.start <= end, "{finding:?} lies behind the end");
        assert!(!finding.message.is_empty());
    }
    (items, findings)
}

fuzz_target!(|bytes: &[u8]| {
    let text = decode(Box::new(bytes));
    assert!(std::str::from_utf8(&text.0).is_ok(), "text that is no UTF-8 was handed out");

    let (items, findings) = read(Box::new(bytes), text.1);
    assert!(findings.len() < FINDINGS);
    // How much text comes before damage to compressed data depends on how it was read. Reading once more takes as long again:
    // every eighth input is enough.
    let is_damaged = text.2.as_ref().is_some_and(|r| matches!(r.kind, RefusalKind::Gzip(_)));
    if bytes.len().is_multiple_of(8) && !is_damaged {
        assert_eq!(text, decode(torn(bytes)));
        let other = read(torn(bytes), text.1);
        assert_eq!((&items, &findings), (&other.0, &other.1));
    }

    let source = Inputs::new(SourceLimits::default()).open(Box::new(bytes), "");
    let scanned = scan(source, &Limits::default()).expect("memory does not fail");
    let errors: Vec<&Finding> = findings
        .iter()
        .filter(|finding| finding.severity == Severity::Error)
        .filter(|finding| !rule_ids::is_structural(finding.rule))
        .collect();
    // Reading ends at a foreign root.
    if !findings.iter().any(|finding| finding.rule == rule_ids::ROOT) {
        assert_eq!(errors.is_empty(), scanned.is_well_formed(), "{errors:?}\n{scanned:?}");
    }
});
