//! The schema of entries that is published says what the reader reads.

use mapd_overlay::{Document, DocumentError, Kind, Limits};
use mapd_query::vocabulary::VehicleClass;
use mapd_tests::json_schema::wrong;
use serde_json::Value;
use std::collections::BTreeSet;

const SCHEMA: &str = include_str!("../../../schemas/overlay.schema.json");
const PAGE: &str = include_str!("../../../docs/overlay.md");

fn schema() -> Value {
    serde_json::from_str(SCHEMA).expect("JSON")
}

fn words<'a>(values: impl Iterator<Item = &'a str>) -> BTreeSet<String> {
    values.map(str::to_owned).collect()
}

/// Names in an answer such as "unknown field `x`, expected one of `a`, `b`", the first left out.
fn expected(text: &str) -> BTreeSet<String> {
    let error = Document::read(text.as_bytes(), &Limits::default()).expect_err(text);
    let DocumentError::Json { why, .. } = &error else { panic!("{error}") };
    assert!(why.contains("unknown"), "{text}: {why}");
    words(why.split('`').skip(1).step_by(2).skip(1))
}

/// Each object has the same fields in both, and each list of words the same words.
#[test]
fn fields_and_words_are_the_same() {
    let schema = schema();
    let fields = |name: &str| {
        let of = match name {
            "" => &schema,
            name => &schema["$defs"][name],
        };
        assert_eq!(of["additionalProperties"], false, "{name}");
        words(of["properties"].as_object().expect(name).keys().map(String::as_str))
    };
    let entry = |more: &str| format!(r#"{{"entries":[{{"id":"a","kind":"closed",{more}}}]}}"#);
    assert_eq!(expected(r#"{"?":0}"#), fields(""));
    assert_eq!(expected(&entry(r#""?":0"#)), fields("entry"));
    assert_eq!(expected(&entry(r#""lanes":[{"?":0}]"#)), fields("place"));
    assert_eq!(expected(&entry(r#""places":[{"?":0}]"#)), fields("earth"));
    assert_eq!(expected(&entry(r#""weekly":[{"?":0}]"#)), fields("weekly"));
    let listed = |place: &Value| {
        words(place["enum"].as_array().expect("words").iter().filter_map(Value::as_str))
    };
    let entry_fields = &schema["$defs"]["entry"]["properties"];
    let kinds = expected(r#"{"entries":[{"id":"a","kind":"?"}]}"#);
    assert_eq!(kinds, listed(&entry_fields["kind"]));
    assert!(kinds.contains(Kind::SignalOff.name()));
    let classes = VehicleClass::ALL.iter().map(|class| class.name());
    assert_eq!(words(classes), listed(&entry_fields["vehicles"]["items"]));
    let days = expected(&entry(r#""weekly":[{"days":["?"],"from":"07:00","until":"08:00"}]"#));
    assert_eq!(days, listed(&schema["$defs"]["weekly"]["properties"]["days"]["items"]));
    for word in ["nearest", "all"] {
        let text = entry(&format!(r#""places":[{{"line":[[48,11],[48.1,11]],"lanes":"{word}"}}]"#));
        Document::read(text.as_bytes(), &Limits::default()).expect(word);
    }
}

/// Examples of the page are what the schema says, and are read.
#[test]
fn examples_conform() {
    let root = schema();
    let blocks = PAGE.split("```json\n").skip(1).filter_map(|rest| rest.split("```").next());
    let mut count = 0;
    for block in blocks {
        let documents: Vec<String> = match block.starts_with("{\"entries\"") {
            true => vec![block.to_owned()],
            false => block.lines().map(|line| format!(r#"{{"entries":[{line}]}}"#)).collect(),
        };
        for text in documents {
            let value: Value = serde_json::from_str(&text).expect(&text);
            assert_eq!(wrong(&root, &value), None, "{text}");
            Document::read(text.as_bytes(), &Limits::default()).expect(&text);
            count += 1;
        }
    }
    assert!(count >= 3, "{count} examples");
    for bad in [
        r#"{"entries":[{"id":"a"}]}"#,
        r#"{"entries":[{"id":"a","kind":"shut"}]}"#,
        r#"{"entries":[{"id":"a","kind":"closed","lanes":[{"road":"1","lane":0}]}]}"#,
        r#"{"entries":[{"id":"a","kind":"closed","places":[{"line":[[48,11]]}]}]}"#,
        r#"{"entries":[{"id":"a","kind":"closed","confidence":2}]}"#,
    ] {
        let value: Value = serde_json::from_str(bad).expect(bad);
        assert!(wrong(&root, &value).is_some(), "{bad}");
        Document::read(bad.as_bytes(), &Limits::default()).expect_err(bad);
    }
}
