//! How many findings are kept is a matter of what is told. What is left out of the map is the same.

use mapd_compiler::{Compilation, CompileOptions, ReadOptions, Verdict, compile_from};
use mapd_rules::{Grade, Settings};
use mapd_tests::object_maps::{ObjectRoad, PLAIN, document};
use mapd_xodr::{Severity, rule_ids};

/// Objects of each kind of fault: more than are kept of one kind by default.
const OBJECTS: usize = 130;

/// A road with many objects and signals, from this number on, of which each has this fault; and one of each that has none.
fn road(first: usize, object: &str, signal: &str) -> String {
    let ids = first..first + OBJECTS;
    let objects: String = ids.clone().map(|id| object.replace("ID", &format!("o{id}"))).collect();
    let signals: String = ids.map(|id| signal.replace("ID", &format!("s{id}"))).collect();
    let sound = |id| {
        format!(
            r#"<object id="{id}" type="pole" s="40" t="8" zOffset="0" radius="0.2" orientation="none"/>"#
        )
    };
    document(&ObjectRoad { version: "1.7", ..PLAIN }, &(sound(format!("sound{first}")) + &objects))
        .replace("</objects>", &format!("</objects><signals>{signals}</signals>"))
}

/// Roads behind each other in one document, by number.
fn roads(all: &[String]) -> String {
    let inner = |text: &String| {
        let (start, end) =
            (text.find("<road").expect("a road"), text.rfind("</OpenDRIVE>").expect("an end"));
        text[start..end].to_owned()
    };
    let roads = all.iter().map(inner).enumerate();
    let roads: String = roads
        .map(|(at, road)| road.replacen("id=\"1\"", &format!("id=\"{}\"", at + 1), 1))
        .collect();
    format!(r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>{roads}</OpenDRIVE>"#)
}

fn compile(text: &str, limit: u32, batch: Option<usize>, rules: &Settings) -> Compilation {
    let mut reading =
        ReadOptions { batch_bytes: batch, rules: rules.clone(), ..ReadOptions::default() };
    reading.limits.findings_of_a_kind = limit;
    let options = CompileOptions::default();
    compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {}).expect("reading works")
}

/// What is left out of a document of so many parts, whatever is kept and however it is read: so many parts of each road.
fn check(what: &str, text: &str, rules: &Settings, lost: usize) {
    let mut told = Vec::new();
    for (limit, batch) in
        [(100_000, None), (100, None), (100, Some(1)), (1, Some(3000)), (0, None), (0, Some(1))]
    {
        let compiled = compile(text, limit, batch, rules);
        let parts: Vec<_> = compiled
            .quarantined
            .iter()
            .map(|part| (part.name(), part.rule, part.line, part.column))
            .collect();
        let verdict = if lost == 0 { Verdict::Accepted } else { Verdict::Quarantined };
        assert_eq!((parts.len(), compiled.verdict), (lost, verdict), "{what}, {limit}, {batch:?}");
        let errors = compiled.counts.of(Severity::Error);
        told.push((limit, batch, (parts, errors)));
    }
    let (.., first) = &told[0];
    for (limit, batch, one) in &told {
        assert_eq!(one, first, "{what}, {limit} kept, batches of {batch:?}");
    }
}

const OBJECT: &str = r#"<object id="ID" type="pole" s="30" t="4" zOffset="0" hdg="0" height="1" radius="0.1" orientation="none"/>"#;
const SIGNAL: &str = r#"<signal id="ID" s="20" t="-7" zOffset="2" orientation="+" dynamic="no" country="DE" type="274" subtype="-1" value="50" unit="km/h" height="1" width="1"/>"#;

#[test]
fn how_many_findings_are_kept_decides_nothing() {
    let marking = OBJECT.replace(
        "/>",
        r#"><markings><marking side="front" color="white" spaceLength="abc" lineLength="1" startOffset="0" stopOffset="0"/></markings></object>"#,
    );
    let with = |text: &str, from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    };
    let cases = [
        (
            "a height that is no number",
            with(OBJECT, "zOffset=\"0\"", "zOffset=\"abc\""),
            SIGNAL.into(),
            OBJECTS,
        ),
        (
            "a number that is not finite",
            with(OBJECT, "radius=\"0.1\"", "radius=\"1e999\""),
            SIGNAL.into(),
            OBJECTS,
        ),
        ("no place", with(OBJECT, "s=\"30\" ", ""), SIGNAL.into(), OBJECTS),
        ("an empty place", with(OBJECT, "t=\"4\"", "t=\"\""), SIGNAL.into(), OBJECTS),
        (
            "both",
            with(OBJECT, "s=\"30\" t=\"4\"", "s=\"\" t=\"x\""),
            with(SIGNAL, "t=\"-7\"", "t=\"x\""),
            2 * OBJECTS,
        ),
        (
            "a signal's value",
            OBJECT.into(),
            with(SIGNAL, "value=\"50\"", "value=\"fifty\""),
            OBJECTS,
        ),
        ("what hinders nothing", marking, SIGNAL.into(), 0),
    ];
    for (what, object, signal, lost) in cases {
        let text = roads(&[road(0, &object, &signal), road(1000, &object, &signal)]);
        check(what, &text, &Settings::default(), 2 * lost);
    }
}

#[test]
fn a_grade_holds_for_what_is_only_counted() {
    let text = roads(&[road(0, &OBJECT.replace("zOffset=\"0\"", "zOffset=\"abc\""), SIGNAL)]);
    let graded = |rule: &str, grade| Settings {
        grades: [(Box::from(rule), grade)].into_iter().collect(),
        ..Settings::default()
    };
    check("an error", &text, &graded(rule_ids::VALUE, Grade::Severity(Severity::Error)), OBJECTS);
    check("a warning", &text, &graded(rule_ids::VALUE, Grade::Severity(Severity::Warning)), 0);
    check("off", &text, &graded(rule_ids::VALUE, Grade::Off), 0);
    // What hinders nothing takes nothing out, unless it is graded so.
    for (rule, from, to) in [
        (rule_ids::ENUMERATION, "type=\"pole\"", "type=\"lamppost\""),
        (rule_ids::RANGE, "height=\"1\"", "height=\"-1\""),
        (rule_ids::UNKNOWN_ATTRIBUTE, "height=\"1\"", "tall=\"1\""),
        (rule_ids::UNKNOWN_ELEMENT, "/>", "><tall/></object>"),
    ] {
        assert!(OBJECT.contains(from), "{from}");
        let text = roads(&[road(0, &OBJECT.replace(from, to), SIGNAL)]);
        check(rule, &text, &Settings::default(), 0);
        check(rule, &text, &graded(rule, Grade::Severity(Severity::Error)), OBJECTS);
    }
}

/// Of findings of one kind, which are only counted, those are errors that something is built from, and no others.
#[test]
fn what_is_only_counted_is_an_error_where_it_takes_something_out() {
    let plan = |x: &str| {
        format!(
            r#"<planView><geometry s="0" x="{x}" y="0" hdg="0" length="9"><line/></geometry></planView>"#
        )
    };
    let road = |id: u32, x: &str| {
        let lanes =
            r#"<lanes><laneSection s="0"><center><lane id="0"/></center></laneSection></lanes>"#;
        format!(r#"<road id="{id}" length="9" junction="-1">{}{lanes}</road>"#, plan(x))
    };
    // Nothing is built along the line of a junction without objects and heights.
    let junction = |id: u32| format!(r#"<junction id="{id}" name="">{}</junction>"#, plan("east"));
    let text = format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="9"/>{}{}{}{}{}</OpenDRIVE>"#,
        road(1, "0"),
        road(2, "east"),
        road(3, "20"),
        junction(8),
        junction(9)
    );
    for limit in [0, 1, 2, 3, 100] {
        let compiled = compile(&text, limit, None, &Settings::default());
        let lost: Vec<String> = compiled.quarantined.iter().map(|part| part.name()).collect();
        assert_eq!(lost, ["road 2"], "{limit}");
        let of = |severity| {
            let own = compiled.counts.iter().filter(|(own, rule, _)| {
                *own == severity && (*rule == rule_ids::VALUE || severity == Severity::Error)
            });
            own.map(|(_, _, count)| count).sum::<usize>()
        };
        assert_eq!((of(Severity::Error), of(Severity::Warning)), (1, 2), "{limit} kept");
    }
}
