//! The schema of entries that is published says what the reader reads.

use mapd_overlay::{Document, DocumentError, Kind, Limits};
use mapd_query::vocabulary::VehicleClass;
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

/// Whether a value is what a part of the schema says, as far as this one uses JSON Schema.
fn conforms(root: &Value, part: &Value, value: &Value) -> bool {
    let all = |items: &Value, to: &dyn Fn(&Value) -> bool| {
        items.as_array().is_some_and(|a| a.iter().all(to))
    };
    part.as_object().expect("an object").iter().all(|(word, said)| match word.as_str() {
        "$ref" => {
            let path = said.as_str().expect("a path").trim_start_matches('#');
            conforms(root, root.pointer(path).expect("known"), value)
        }
        "type" => {
            let is = |name: &str| match name {
                "object" => value.is_object(),
                "array" => value.is_array(),
                "string" => value.is_string(),
                "number" => value.is_number(),
                "integer" => value.is_i64(),
                other => panic!("{other}"),
            };
            match said {
                Value::String(name) => is(name),
                names => {
                    names.as_array().expect("names").iter().any(|n| is(n.as_str().expect("a name")))
                }
            }
        }
        "required" => all(said, &|name| value.get(name.as_str().expect("a name")).is_some()),
        "properties" => value.as_object().is_none_or(|own| {
            own.iter()
                .all(|(name, value)| said.get(name).is_none_or(|part| conforms(root, part, value)))
        }),
        "additionalProperties" => value
            .as_object()
            .is_none_or(|own| own.keys().all(|name| part["properties"].get(name).is_some())),
        "items" => value.as_array().is_none_or(|a| a.iter().all(|one| conforms(root, said, one))),
        "enum" => said.as_array().expect("values").contains(value),
        "const" => said == value,
        "not" => !conforms(root, said, value),
        "oneOf" => {
            let parts = said.as_array().expect("parts").iter();
            parts.filter(|part| conforms(root, part, value)).count() == 1
        }
        "minimum" => value.as_f64().is_none_or(|n| n >= said.as_f64().expect("a number")),
        "maximum" => value.as_f64().is_none_or(|n| n <= said.as_f64().expect("a number")),
        "minItems" => {
            value.as_array().is_none_or(|a| a.len() as u64 >= said.as_u64().expect("a number"))
        }
        "maxItems" => {
            value.as_array().is_none_or(|a| a.len() as u64 <= said.as_u64().expect("a number"))
        }
        "minLength" => {
            value.as_str().is_none_or(|t| t.len() as u64 >= said.as_u64().expect("a number"))
        }
        "maxLength" => {
            value.as_str().is_none_or(|t| t.len() as u64 <= said.as_u64().expect("a number"))
        }
        // What `24:00` and the like look like is the reader's.
        "pattern" | "$schema" | "$defs" | "title" | "description" => true,
        other => panic!("{other} is not known here"),
    })
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
            assert!(conforms(&root, &root, &value), "{text}");
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
        assert!(!conforms(&root, &root, &value), "{bad}");
        Document::read(bad.as_bytes(), &Limits::default()).expect_err(bad);
    }
}
