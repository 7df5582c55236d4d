//! The vocabulary as JSON Schema, from the same tables that the reader uses.
//!
//! An editor that has it completes keys and marks what the reader would refuse, as far as a schema
//! can say it: that a pipe is narrower inside than outside is the reader's to tell.

use super::DEFAULT_BODY;
use super::body::BODY;
use super::key::{Domain, Form, Key, Need};
use super::vocabulary::{Vocabulary, bodies, vocabulary};
use serde_json::{Map, Number, Value, json};

/// The dialect.
const DRAFT: &str = "https://json-schema.org/draft/2020-12/schema";

/// The schema of scenes of one body, or of all.
///
/// ```
/// use tribos::scene::{schema, vocabulary};
/// let tip = schema(vocabulary("tip").as_ref());
/// assert_eq!(tip["properties"]["cutoff"]["exclusiveMinimum"], 1.0);
/// assert_eq!(tip["required"], serde_json::json!(["body"]));
/// ```
pub fn schema(body: Option<&Vocabulary>) -> Value {
    let mut schema = match body {
        Some(known) => branch(known),
        None => {
            let branches = bodies().filter_map(vocabulary);
            let branches: Vec<Value> = branches.map(|known| branch(&known).into()).collect();
            Map::from_iter([("oneOf".to_owned(), branches.into())])
        }
    };
    schema.insert("$schema".into(), DRAFT.into());
    let title = body.map_or("A scene of tribos".to_owned(), |known| {
        format!("A scene of tribos with body = \"{}\"", known.body)
    });
    schema.insert("title".into(), title.into());
    schema.into()
}

/// What holds for one body.
fn branch(known: &Vocabulary) -> Map<String, Value> {
    let defaults = known.defaults();
    let property = |key: &Key| (key.name.to_owned(), property(key, defaults.get(key.name)));
    let mut properties: Map<String, Value> = known.keys.iter().map(property).collect();
    for (key, was) in known.keys.iter().filter_map(|key| Some((key, key.was?))) {
        let mut earlier = properties[key.name].clone();
        earlier["deprecated"] = true.into();
        earlier["description"] = format!("Earlier name of `{}`.", key.name).into();
        properties.insert(was.into(), earlier);
    }
    let body = json!({"const": known.body, "description": BODY.meaning});
    properties.insert("body".into(), body);
    let mut branch = Map::new();
    branch.insert("title".into(), known.body.into());
    branch.insert("type".into(), "object".into());
    branch.insert("properties".into(), properties.into());
    branch.insert("required".into(), required(known).into());
    branch.insert("additionalProperties".into(), false.into());
    let conditions = conditions(known.keys, &defaults);
    if !conditions.is_empty() {
        branch.insert("allOf".into(), conditions.into());
    }
    branch
}

/// One key.
fn property(key: &Key, default: Option<&Value>) -> Value {
    let unit = match key.unit {
        "-" => String::new(),
        unit => format!(" [{unit}]"),
    };
    let mut property = Map::new();
    property.insert(
        "description".into(),
        format!("{}{unit}", key.meaning).into(),
    );
    property.extend(domain(&key.domain));
    let default = default.and_then(|value| match (value, key.domain) {
        (Value::Number(number), Domain::Count { .. }) => Some((number.as_f64()? as u64).into()),
        (Value::Number(number), _) => number.as_f64().map(short),
        (word, _) => Some(word.clone()),
    });
    property.extend(default.map(|value| ("default".to_owned(), value)));
    property.into()
}

/// What a value may be.
fn domain(domain: &Domain) -> Map<String, Value> {
    let rules = match *domain {
        // Bounds of numbers say nothing of a text.
        Domain::Form(Form {
            numbers: Some(numbers),
            ..
        }) => {
            let mut rules = self::domain(numbers);
            let number = rules.insert("type".into(), Value::Null);
            rules.insert("type".into(), json!([number, "string"]));
            return rules;
        }
        Domain::Finite => json!({"type": "number"}),
        Domain::NotNegative => json!({"type": "number", "minimum": 0}),
        Domain::Positive => json!({"type": "number", "exclusiveMinimum": 0}),
        Domain::Between { above, up_to } => json!({
            "type": "number", "exclusiveMinimum": short(above), "maximum": short(up_to)
        }),
        Domain::Below { from, below } => json!({
            "type": "number", "minimum": short(from), "exclusiveMaximum": short(below)
        }),
        Domain::Fraction => json!({"type": "number", "minimum": 0, "maximum": 1}),
        Domain::Count { from, up_to } => {
            json!({"type": "integer", "minimum": from as u64, "maximum": up_to as u64})
        }
        Domain::Form(_) | Domain::Path => json!({"type": "string"}),
        Domain::OneOf(words) => json!({"type": "string", "enum": words}),
    };
    match rules {
        Value::Object(rules) => rules,
        _ => Map::new(),
    }
}

/// The shortest text that reads back as the number.
fn short(x: f64) -> Value {
    Number::from_f64(x).map_or(Value::Null, Value::Number)
}

/// Keys that every scene of the body must have, in the order of the documentation, but for those with an earlier name.
fn required(known: &Vocabulary) -> Vec<&'static str> {
    let needed = known.keys.iter();
    let needed = needed.filter(|key| key.need == Need::Required && key.was.is_none());
    let body = (known.body != DEFAULT_BODY).then_some("body");
    needed.map(|key| key.name).chain(body).collect()
}

/// What keys say about each other.
fn conditions(keys: &[Key], defaults: &Map<String, Value>) -> Vec<Value> {
    // Present and earlier name of a key.
    let names = |name: &'static str| {
        let key = keys.iter().find(|key| key.name == name);
        [name].into_iter().chain(key.and_then(|key| key.was))
    };
    let any = |rules: Vec<Value>| match &rules[..] {
        [one] => one.clone(),
        _ => json!({"anyOf": rules}),
    };
    // True of scenes that give a key.
    let given = |key| any(names(key).map(|name| json!({"required": [name]})).collect());
    // True of scenes in which a key, where it is given, has a value; none if the value is false.
    let has = |key, value: Value| {
        let rules = names(key).map(|name| (name.to_owned(), value.clone()));
        json!({"properties": Map::from_iter(rules)})
    };
    // True of scenes in which a key has this word, given or by default.
    let says = |key, word: &str| {
        let is_word = has(key, json!({"const": word}));
        match defaults.get(key) {
            Some(default) if default == word => is_word,
            _ => json!({"allOf": [is_word, given(key)]}),
        }
    };
    let condition = |key: &Key| {
        let name = key.name;
        match key.need {
            Need::Required => key.was.map(|_| given(name)),
            Need::Optional => None,
            Need::UnlessGiven(other) => Some(json!({"oneOf": [given(name), given(other)]})),
            Need::UnlessEither(one, two) => {
                Some(json!({"oneOf": [given(name), given(one), given(two)]}))
            }
            Need::UnitWith(other, word) => Some(json!({
                "if": says(other, word), "then": has(name, json!({"const": 1})), "else": given(name)
            })),
            Need::PartOf(other, word) | Need::OnlyWith(other, word) => Some(json!({
                "if": says(other, word), "else": has(name, false.into())
            })),
            Need::NotWith(other, word) => Some(json!({
                "if": says(other, word), "then": has(name, false.into())
            })),
            Need::Without(other) => Some(json!({
                "if": given(other), "then": has(name, false.into())
            })),
        }
    };
    // A file gives one of two names.
    let once = |key: &Key| Some(json!({"not": {"required": [key.name, key.was?]}}));
    let conditions = keys.iter().filter_map(condition);
    conditions.chain(keys.iter().filter_map(once)).collect()
}

#[cfg(test)]
mod tests;
