//! Which bodies there are, which keys each has, and the least that a scene of each must say.

use super::body::VOCABULARIES;
use super::entries::Entries;
use super::key::{self, Key, Need, present_name};
use super::table::Table;
use super::{DEFAULT_BODY, Scene, toml_value};
use crate::results::{Quantity, Summary};
use serde_json::{Map, Value};

/// A body that scenes can be about.
///
/// ```
/// use tribos::scene::{Vocabulary, bodies, vocabulary, Scene};
/// for body in bodies() {
///     let known: Vocabulary = vocabulary(body).ok_or(body)?;
///     let scene = Scene::parse("least.toml", &known.least_text(), &[])?;
///     assert_eq!(scene.body(), body);
///     // What it leaves out holds by default.
///     let values = scene.json();
///     assert!(known.defaults().iter().all(|(name, value)| values[name] == *value));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Vocabulary {
    /// Value of the key `body`.
    pub body: &'static str,
    /// The title of a film of it.
    pub title: &'static str,
    /// Its keys, in the order of the documentation.
    pub keys: &'static [Key],
    /// The quantities of the summaries of its runs.
    #[doc(hidden)]
    pub results: &'static [Quantity],
    /// The default scene, as JSON.
    pub(super) example: fn() -> Value,
}

/// The vocabulary of a body, if there is one of that name.
///
/// ```
/// let tip = tribos::scene::vocabulary("tip").ok_or("no tip")?;
/// assert!(tip.keys.iter().any(|key| key.name == "lambda" && key.unit == "eps/sigma^2"));
/// # Ok::<(), &str>(())
/// ```
pub fn vocabulary(body: &str) -> Option<Vocabulary> {
    VOCABULARIES
        .iter()
        .copied()
        .find(|known| known.body == body)
}

/// All bodies, the default one first.
pub fn bodies() -> impl Iterator<Item = &'static str> {
    VOCABULARIES.iter().map(|known| known.body)
}

impl Vocabulary {
    /// That of a table of keys and one of results.
    pub(super) const fn of<T: Table, S: Summary>() -> Self {
        Self {
            body: T::BODY,
            title: T::TITLE,
            keys: T::TABLE,
            results: S::QUANTITIES,
            example: || T::default().values(),
        }
    }

    /// Keys that a file must give, with the values of the default scene as TOML.
    pub fn least(&self) -> Vec<(&'static str, String)> {
        let values = (self.example)();
        let is_needed = |key: &&Key| match key.need {
            Need::Required | Need::UnlessGiven(_) | Need::UnlessEither(..) | Need::UnitWith(..) => {
                true
            }
            _ => key.name == "body" && self.body != DEFAULT_BODY,
        };
        let keys = self.keys.iter().filter(is_needed);
        let setting = |key: &'static Key| Some((key.name, toml_value(key, &values[key.name])?));
        keys.filter_map(setting).collect()
    }

    /// The least scene as a file.
    pub fn least_text(&self) -> String {
        let least = self.least().into_iter();
        least
            .map(|(key, value)| format!("{key} = {value}\n"))
            .collect()
    }

    /// Values that keys have where they are left out of the least scene. Keys whose absence means
    /// that something is chosen or switched off are not there.
    pub fn defaults(&self) -> Map<String, Value> {
        let Value::Object(mut values) = (self.example)() else {
            return Map::new();
        };
        let least = self.least();
        values.retain(|name, value| {
            !value.is_null() && !least.iter().any(|(given, _)| given == name)
        });
        values
    }
}

/// Values in force in a scene; none if it cannot be read.
pub(super) fn resolved(text: &str) -> Map<String, Value> {
    match Scene::parse("scene", text, &[]).map(|scene| scene.json()) {
        Ok(Value::Object(values)) => values,
        _ => Map::new(),
    }
}

/// Present names of the keys that stand in a file.
pub(super) fn given(keys: &[Key], text: &str) -> Vec<String> {
    let entries = Entries::parse(text, &[]).map(|(entries, _)| entries.values);
    let names = entries.unwrap_or_default().into_keys();
    names
        .map(|name| present_name(keys, &name).to_owned())
        .collect()
}

/// [Values in force](super::Scene::json) that an earlier version may have written, by the present names of their keys;
/// keys that have come since have their defaults.
pub fn with_present_names(values: &Value) -> Value {
    let body = values.get("body").map_or(Some(DEFAULT_BODY), Value::as_str);
    match body.and_then(vocabulary) {
        Some(known) => key::with_present_names(known.keys, &(known.example)(), values),
        None => values.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_scene_of_every_body_is_accepted_and_says_nothing_in_vain() {
        for body in bodies() {
            let known = vocabulary(body).unwrap();
            let scene = Scene::parse(body, &known.least_text(), &[]);
            assert_eq!(scene.unwrap().body(), body);
            let least = known.least();
            for (left_out, _) in least.iter().filter(|(key, _)| *key != "body") {
                let rest = least.iter().filter(|(key, _)| key != left_out);
                let text: String = rest
                    .map(|(key, value)| format!("{key}={value}\n"))
                    .collect();
                assert!(
                    Scene::parse(body, &text, &[]).is_err(),
                    "{body}: {left_out}"
                );
            }
        }
        assert!(vocabulary("brick").is_none());
    }

    #[test]
    fn defaults_are_those_of_the_reader() {
        let powder = vocabulary("powder").unwrap().defaults();
        assert_eq!(powder["capture_radius"].as_f64(), Some(3.0));
        assert_eq!(powder["coupling"], "independent");
        assert!(!powder.contains_key("duration") && !powder.contains_key("width"));
    }
}
