//! Batches that are checked and lowered by themselves give the archive and the findings of one element after the other,
//! wherever the text is cut.

use mapd_archive::encode;
use mapd_compiler::{CompileOptions, Diagnostic, ReadOptions, Verdict, compile_from};
use mapd_rules::{Check, Profile, Settings, catalog};
use mapd_tests::crossroads::furnished;
use mapd_tests::{carried, corpus, say};

/// Bytes of the batches: about one road each, and several.
const BATCHES: [usize; 2] = [1, 5_000];

/// All that compiling a document yields.
#[derive(PartialEq)]
struct Yield {
    archive: Option<Vec<u8>>,
    diagnostics: Vec<Diagnostic>,
    rest: String,
}

fn compile(text: &[u8], rules: &Settings, batch_bytes: Option<usize>) -> Yield {
    let threads = if batch_bytes.is_some() { 3 } else { 1 };
    let reading = ReadOptions { rules: rules.clone(), batch_bytes, ..ReadOptions::default() };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let compiled = pool.install(|| {
        compile_from(|| Ok(text), &reading, &CompileOptions::default(), &mut |_| {})
            .expect("reading works")
    });
    let archive = compiled.rows.map(|rows| encode(&rows, &compiled.provenance).expect("encodes"));
    Yield {
        archive: archive.map(|bytes| bytes.to_vec()),
        diagnostics: compiled.diagnostics,
        rest: format!("{:?} {:?} {:?}", compiled.verdict, compiled.dropped, compiled.quarantined),
    }
}

/// Compares; whether the whole map was built.
fn check(name: &str, text: &[u8], rules: &Settings) -> bool {
    let expected = compile(text, rules, None);
    for bytes in BATCHES {
        let found = compile(text, rules, Some(bytes));
        let name = format!("{name}, batches of {bytes} bytes");
        assert_eq!(found.rest, expected.rest, "{name}");
        for (found, expected) in found.diagnostics.iter().zip(&expected.diagnostics) {
            assert_eq!(found, expected, "{name}");
        }
        assert_eq!(found.diagnostics.len(), expected.diagnostics.len(), "{name}");
        assert!(found.archive == expected.archive, "{name}: other bytes");
    }
    expected.rest.starts_with(&format!("{:?}", Verdict::Accepted))
}

/// Settings that keep so many findings of a rule.
fn keeping(findings_of_a_rule: u32, profile: Profile) -> Settings {
    Settings { findings_of_a_rule, profile, ..Settings::default() }
}

#[test]
fn maps_are_the_same() {
    let mut maps = vec![carried("town.xodr"), carried("one_road.xodr")];
    match corpus() {
        Some(all) => maps.extend(all.into_iter().map(|(_, path)| path)),
        None => say("SKIPPED in part: no shared corpus beside the workspace"),
    }
    for path in maps {
        let text = std::fs::read(&path).expect("the map can be read");
        // The largest ones are compared where it is fast.
        if cfg!(debug_assertions) && text.len() > 1_000_000 {
            continue;
        }
        check(&path.display().to_string(), &text, &Settings::default());
    }
}

/// What a document has behind its header, and what it has before.
fn split(document: &str) -> (&str, &str) {
    let header = document.find("<header").expect("a header");
    let tag = document[header..].find('>').expect("a tag") + header;
    let is_empty = document[..tag].ends_with('/');
    let end = if is_empty {
        tag + 1
    } else {
        document.find("</header>").expect("an end") + "</header>".len()
    };
    document.split_at(end)
}

#[test]
fn every_part_of_the_standard_is_the_same() {
    let crossroads = furnished();
    let (_, beside) = split(&crossroads);
    let beside = beside.trim_end().strip_suffix("</OpenDRIVE>").expect("an end");
    // Ids of its own.
    let beside = beside.replace("oad=\"", "oad=\"x").replace("id=\"", "id=\"x");
    let beside = beside.replace("Id=\"", "Id=\"x").replace("junction=\"100", "junction=\"x100");
    let beside = beside.replace("lane id=\"x", "lane id=\"").replace("ssor id=\"x", "ssor id=\"");
    let mut accepted = 0;
    // Examples of what reading finds may have no header.
    let is_read = |check: &Check| matches!(check, Check::Reading);
    let all: Vec<_> = catalog::all().filter(|rule| !is_read(&rule.check)).collect();
    for rule in &all {
        for example in [rule.valid, rule.invalid] {
            let Some(document) = example.document(rule.example_version()) else { continue };
            let (before, behind) = split(&document);
            let text = format!("{before}{beside}{behind}");
            let is_whole = check(rule.id, text.as_bytes(), &Settings::default());
            accepted += usize::from(is_whole);
        }
    }
    say(&format!("{accepted} whole maps of {} rules", all.len()));
    assert!(accepted > all.len(), "{accepted}");
}

#[test]
fn limits_on_findings_are_passed_in_the_same_places() {
    // Widths that are negative, elevations out of order or without a number, and objects without size: findings of several rules in each road.
    let road = |id: usize| {
        let x = id * 100;
        let (word, b) = if id.is_multiple_of(7) { ("none", "steep") } else { ("driving", "0") };
        format!(
            "<road id=\"{id}\" length=\"50\" junction=\"-1\"><link><successor elementType=\"road\" elementId=\"x\"/></link>\
             <planView><geometry s=\"0\" x=\"{x}\" y=\"0\" hdg=\"0\" length=\"49\"><line/></geometry></planView>\
             <elevationProfile><elevation s=\"5\" a=\"0\" b=\"0\" c=\"0\" d=\"0\"/><elevation s=\"3\" a=\"0\" b=\"{b}\" c=\"0\" d=\"0\"/></elevationProfile>\
             <lanes><laneSection s=\"0\"><center><lane id=\"0\" type=\"none\"/></center><right>\
             <lane id=\"-1\" type=\"{word}\"><width sOffset=\"0\" a=\"-3\" b=\"0\" c=\"0\" d=\"0\"/></lane>\
             <lane id=\"-3\" type=\"odd\"><width sOffset=\"9\" a=\"3\" b=\"0\" c=\"0\" d=\"0\"/></lane></right></laneSection></lanes>\
             <objects><object id=\"{id}\" type=\"pole\" s=\"90\" t=\"1\" zOffset=\"0\" length=\"-1\" orientation=\"none\"/></objects></road>\n"
        )
    };
    let roads = (0..150).map(road).collect::<String>();
    let text = format!("<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>\n{roads}</OpenDRIVE>\n");
    for limit in [0, 1, 7, 100, 1000] {
        for (_, profile) in Profile::ALL {
            check(&format!("limit {limit}"), text.as_bytes(), &keeping(limit, profile));
        }
    }
    let told = compile(text.as_bytes(), &keeping(7, Profile::Default), Some(3_000));
    let more =
        told.diagnostics.iter().filter(|told| told.finding.message.contains("more findings"));
    assert!(more.count() > 2, "{}", told.rest);
    assert!(!told.rest.starts_with(&format!("{:?}", Verdict::Accepted)), "{}", told.rest);
}
