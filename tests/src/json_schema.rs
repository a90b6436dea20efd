//! Values against JSON schemas, as far as mapd's own use them; stricter in one thing: a field that the schema does not list is wrong, though users must bear it.

use serde_json::Value;
use std::fs;

/// A published schema, by its name: of `schemas/NAME.schema.json`.
pub fn schema(name: &str) -> Value {
    file(&format!("{name}.schema.json"))
}

fn file(name: &str) -> Value {
    let path = crate::workspace().join("schemas").join(name);
    serde_json::from_slice(&fs::read(&path).expect(name)).expect("JSON")
}

/// What is wrong with a value, with its place; none if it is what the schema says.
pub fn wrong(schema: &Value, value: &Value) -> Option<String> {
    Schema { root: schema }.wrong(schema, value, "")
}

struct Schema<'a> {
    root: &'a Value,
}

fn list(said: &Value) -> impl Iterator<Item = &Value> {
    said.as_array().expect("a list in the schema").iter()
}

fn number(said: &Value) -> u64 {
    said.as_u64().expect("a number in the schema")
}

fn is(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        other => panic!("the type {other} is not known here"),
    }
}

impl Schema<'_> {
    fn wrong(&self, part: &Value, value: &Value, place: &str) -> Option<String> {
        let words = part.as_object().expect("an object in the schema");
        let wrong =
            words.iter().find_map(|(word, said)| self.by_word(part, word, said, value, place));
        wrong.or_else(|| {
            let (known, own) = (words.get("properties")?, value.as_object()?);
            let is_open = words.get("additionalProperties").is_some_and(|more| more.is_object());
            let unknown = own.keys().find(|name| !is_open && known.get(name).is_none())?;
            Some(format!("{place}: {unknown:?} is not in the schema"))
        })
    }

    fn by_word(
        &self,
        part: &Value,
        word: &str,
        said: &Value,
        value: &Value,
        place: &str,
    ) -> Option<String> {
        let conforms = |part: &Value| self.wrong(part, value, place).is_none();
        let items = || value.as_array().into_iter().flatten().enumerate();
        let fields = || value.as_object().into_iter().flatten();
        let length = value.as_str().map(|text| text.chars().count() as u64);
        let count = value.as_array().map(|all| all.len() as u64);
        let holds = match word {
            "$ref" => {
                let (other, path) =
                    said.as_str().and_then(|path| path.split_once('#')).expect("a path");
                if other.is_empty() {
                    return self.wrong(self.root.pointer(path).expect(path), value, place);
                }
                let root = file(other);
                return Schema { root: &root }.wrong(root.pointer(path).expect(path), value, place);
            }
            "properties" => {
                return fields().find_map(|(name, value)| {
                    self.wrong(said.get(name)?, value, &format!("{place}.{name}"))
                });
            }
            "additionalProperties" if said.is_object() => {
                let listed = |name: &str| part["properties"].get(name).is_some();
                return fields()
                    .filter(|(name, _)| !listed(name))
                    .find_map(|(name, value)| self.wrong(said, value, &format!("{place}.{name}")));
            }
            "items" => {
                return items()
                    .find_map(|(i, value)| self.wrong(said, value, &format!("{place}[{i}]")));
            }
            "prefixItems" => {
                return items().zip(list(said)).find_map(|((i, value), part)| {
                    self.wrong(part, value, &format!("{place}[{i}]"))
                });
            }
            "type" => match said {
                Value::String(name) => is(value, name),
                names => list(names).any(|name| is(value, name.as_str().expect("a name"))),
            },
            "required" => list(said).all(|name| {
                !value.is_object() || value.get(name.as_str().expect("a name")).is_some()
            }),
            "enum" => list(said).any(|one| one == value),
            "const" => said == value,
            "not" => !conforms(said),
            "anyOf" => list(said).any(conforms),
            "oneOf" => list(said).filter(|part| conforms(part)).count() == 1,
            "minimum" => value.as_f64().is_none_or(|n| n >= said.as_f64().expect("a number")),
            "maximum" => value.as_f64().is_none_or(|n| n <= said.as_f64().expect("a number")),
            "minItems" => count.is_none_or(|count| count >= number(said)),
            "maxItems" => count.is_none_or(|count| count <= number(said)),
            "minLength" => length.is_none_or(|length| length >= number(said)),
            "maxLength" => length.is_none_or(|length| length <= number(said)),
            // What texts look like is told to people; unknown fields are always wrong here.
            "pattern" | "additionalProperties" | "$schema" | "$defs" | "title" | "description" => {
                true
            }
            other => panic!("the word {other} is not known here"),
        };
        (!holds).then(|| format!("{place}: {word} {said}, found {value}"))
    }
}
