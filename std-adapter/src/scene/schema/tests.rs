//! The schema accepts and refuses what the reader does.

use super::*;
use crate::scene::entries::{Entries, Written};
use crate::scene::{LIBRARY, Scene};

/// A file as JSON, as an editor hands it to its validator.
fn instance(text: &str) -> Value {
    let (entries, problems) = Entries::parse(text, &[]).unwrap();
    assert!(problems.is_empty(), "{problems:?}");
    let values = entries.values.into_iter().map(|(name, (value, _))| {
        let value = match value {
            Written::Number(x) => short(x),
            Written::Text(text) => text.into(),
            Written::Other(_) => Value::Null,
        };
        (name, value)
    });
    Value::Object(values.collect())
}

/// The keywords that the schema uses, after the draft's own words; panics on any other.
fn is_valid(schema: &Value, instance: &Value) -> bool {
    let Value::Object(rules) = schema else {
        return schema == &Value::Bool(true);
    };
    let all = |list: &Value| {
        list.as_array()
            .unwrap()
            .iter()
            .map(|s| is_valid(s, instance))
            .collect::<Vec<_>>()
    };
    let part = |name: &str| rules.get(name).is_none_or(|rule| is_valid(rule, instance));
    let x = instance.as_f64();
    let compare = |rule: &Value, holds: fn(f64, f64) -> bool| {
        x.is_none_or(|x| holds(x, rule.as_f64().unwrap()))
    };
    let is_of = |kind: &Value| match kind.as_str().unwrap() {
        "object" => instance.is_object(),
        "string" => instance.is_string(),
        "number" => x.is_some(),
        "integer" => x.is_some_and(|x| x.fract() == 0.0),
        other => panic!("type {other}"),
    };
    rules.iter().all(|(word, rule)| match word.as_str() {
        "$schema" | "title" | "description" | "default" | "deprecated" | "then" | "else" => true,
        "type" => match rule.as_array() {
            Some(kinds) => kinds.iter().any(is_of),
            None => is_of(rule),
        },
        "const" => match x {
            Some(x) => rule.as_f64() == Some(x),
            None => rule == instance,
        },
        "enum" => rule.as_array().unwrap().contains(instance),
        "minimum" => compare(rule, |x, bound| x >= bound),
        "exclusiveMinimum" => compare(rule, |x, bound| x > bound),
        "exclusiveMaximum" => compare(rule, |x, bound| x < bound),
        "maximum" => compare(rule, |x, bound| x <= bound),
        "required" => rule
            .as_array()
            .unwrap()
            .iter()
            .all(|name| instance.get(name.as_str().unwrap()).is_some()),
        "properties" => rule
            .as_object()
            .unwrap()
            .iter()
            .all(|(name, rule)| instance.get(name).is_none_or(|value| is_valid(rule, value))),
        "additionalProperties" => instance
            .as_object()
            .unwrap()
            .keys()
            .all(|name| rules["properties"].get(name).is_some()),
        "allOf" => all(rule).into_iter().all(|valid| valid),
        "anyOf" => all(rule).into_iter().any(|valid| valid),
        "not" => !is_valid(rule, instance),
        "oneOf" => all(rule).into_iter().filter(|valid| *valid).count() == 1,
        "if" => part(if is_valid(rule, instance) {
            "then"
        } else {
            "else"
        }),
        other => panic!("keyword {other}"),
    })
}

/// Schema and reader judge alike.
fn agreed(text: &str) -> bool {
    let by_schema = is_valid(&schema(None), &instance(text));
    assert_eq!(
        by_schema,
        Scene::parse("scene", text, &[]).is_ok(),
        "{text}"
    );
    by_schema
}

#[test]
fn every_scene_of_the_library_is_valid_and_a_misspelt_key_is_not() {
    for scene in LIBRARY {
        assert!(agreed(scene.text), "{}", scene.name);
        assert!(
            !agreed(&format!("{}\nspede = 1", scene.text)),
            "{}",
            scene.name
        );
        let one = schema(vocabulary(scene.body()).as_ref());
        assert!(is_valid(&one, &instance(scene.text)), "{}", scene.name);
    }
}

#[test]
fn every_key_is_there_with_its_meaning_and_its_domain_is_the_readers() {
    for known in bodies().filter_map(vocabulary) {
        let schema = schema(Some(&known));
        for key in known.keys.iter().filter(|key| key.name != "body") {
            let property = &schema["properties"][key.name];
            assert!(
                property["description"]
                    .as_str()
                    .unwrap()
                    .contains(key.meaning)
            );
            for x in [
                -1e300, -1.0, -0.5, 0.0, 1e-9, 0.5, 1.0, 2.0, 2.5, 1e4, 1e300,
            ] {
                let admitted = key.domain.admits(x);
                assert_eq!(is_valid(property, &short(x)), admitted, "{} {x}", key.name);
            }
            if let Some(default) = property.get("default") {
                assert!(is_valid(property, default), "{}", key.name);
            }
        }
    }
}

#[test]
fn what_must_be_given_is_what_the_reader_misses() {
    for known in bodies().filter_map(vocabulary) {
        assert!(agreed(&known.least_text()));
        let least = known.least();
        for (left_out, _) in least.iter().filter(|(key, _)| *key != "body") {
            let rest = least.iter().filter(|(key, _)| key != left_out);
            let text: String = rest
                .map(|(key, value)| format!("{key} = {value}\n"))
                .collect();
            assert!(!agreed(&text), "{}: {left_out}", known.body);
        }
    }
}

/// The text without the line of a key.
fn without(text: &str, key: &str) -> String {
    let is_other = |line: &&str| !line.starts_with(key);
    text.lines()
        .filter(is_other)
        .map(|line| format!("{line}\n"))
        .collect()
}

/// A word that a key may have besides this one.
fn another(known: &Vocabulary, key: &str, word: &str) -> &'static str {
    let key = known.keys.iter().find(|known| known.name == key).unwrap();
    let Domain::OneOf(words) = key.domain else {
        panic!("{} has no words", key.name);
    };
    words.iter().find(|other| **other != word).unwrap()
}

#[test]
fn keys_that_depend_on_others_are_judged_as_the_reader_does() {
    let disk = "speed = 1\nspin = 1\ngamma = 1\nalpha = 0\ninertia_ratio = 0.5\n";
    assert!(agreed(&format!(
        "{disk}units = \"dimensionless\"\nmass = 1.0"
    )));
    assert!(!agreed(&format!(
        "{disk}units = \"dimensionless\"\nmass = 2"
    )));
    assert!(!agreed(
        "body = \"powder\"\nwidth = 20\nheight = 60\ncount = 10"
    ));
    assert!(agreed("body = \"powder\"\nwidth = 20\ncount = 10"));
    for known in bodies().filter_map(vocabulary) {
        for key in known.keys {
            let value = match key.domain {
                Domain::OneOf(words) => format!("\"{}\"", words[0]),
                Domain::Count { from, .. } => format!("{from}"),
                Domain::Between { above, .. } if above >= 0.5 => format!("{}", above + 1.0),
                _ => "0.5".to_owned(),
            };
            let text = format!("{}{} = {value}\n", known.least_text(), key.name);
            if let Some(was) = key.was {
                let rest = without(&known.least_text(), key.name);
                let judged = |name: &str| {
                    let text = format!("{rest}{name} = {value}\n");
                    let by_schema = is_valid(&schema(None), &instance(&text));
                    [by_schema, Scene::parse("scene", &text, &[]).is_ok()]
                };
                assert_eq!(judged(was), judged(key.name), "{was}");
                let both = format!("{rest}{} = {value}\n{was} = {value}\n", key.name);
                assert!(!agreed(&both), "{both}");
            }
            match key.need {
                Need::PartOf(other, word) | Need::OnlyWith(other, word)
                    if known.defaults().get(other).and_then(Value::as_str) == Some(word) =>
                {
                    assert!(agreed(&text), "{text}");
                    let beside = format!("{text}{other} = \"{}\"", another(&known, other, word));
                    assert!(!agreed(&beside), "{beside}");
                }
                Need::PartOf(other, word) | Need::OnlyWith(other, word) => {
                    assert!(!agreed(&text), "{text}");
                    // A slid tip has a speed where a turned one has a torque.
                    let text = match (other, key.name) {
                        ("drive", "speed") => without(&text, "lambda"),
                        ("drive", _) => format!("{}speed = 1\n", without(&text, "lambda")),
                        // The period of a box without a floor is its height, and nothing bears the grains.
                        ("boundary_z", "shear_rate" | "inertial_number") => {
                            format!(
                                "{text}height = 0.5\ngravity = 0\nwall_stress_z = 10\nmethod = \"soft\"\n"
                            )
                        }
                        // A slot is narrower than its box.
                        (_, "orifice_width") => text.replace("width = 0.1", "width = 1"),
                        _ => text,
                    };
                    assert!(agreed(&format!("{text}{other} = \"{word}\"")), "{text}");
                }
                Need::NotWith(..) => {
                    assert!(agreed(&text), "{text}");
                    let fixed = "solver = \"gauss-seidel\"\nstop = \"fixed\"";
                    assert!(!agreed(&format!("{text}{fixed}")), "{text}");
                }
                _ => {}
            }
        }
    }
}
