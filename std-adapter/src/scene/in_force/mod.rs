//! A scene as JSON: what its fields say, whatever it was read from.
//!
//! The reader's values are where this starts: they hold what has no field, such as the rate of a
//! thermostat that is not used. Every field is then put over them, so that a field that was changed
//! in Rust is what the JSON says. Where a number was converted as it was read, the value as written
//! stays as long as it converts to the field. What the vocabulary cannot say gets a name of its own.

mod planar;
mod powder;
mod tip;

use super::key::{Domain, Key};
use crate::record::json_number;
use serde_json::{Map, Value};

/// Values of a scene under their keys.
pub(super) struct InForce(Map<String, Value>);

impl InForce {
    /// Starts from the values that were read.
    fn from_read(values: &Map<String, Value>) -> Self {
        Self(values.clone())
    }

    fn number(&mut self, key: Key, value: f64) {
        self.0.insert(key.name.into(), json_number(value));
    }

    fn count(&mut self, key: Key, value: u64) {
        self.0.insert(key.name.into(), value.into());
    }

    /// A number that may be off.
    fn optional(&mut self, key: Key, value: Option<f64>) {
        let json = value.map_or(Value::Null, json_number);
        self.0.insert(key.name.into(), json);
    }

    /// The word of this index.
    fn word(&mut self, key: Key, index: usize) {
        if let Domain::OneOf(words) = key.domain {
            let word = words.get(index).copied().unwrap_or_default();
            self.0.insert(key.name.into(), word.into());
        }
    }

    /// The number that was read or put before.
    fn value(&self, key: Key) -> Option<f64> {
        self.0.get(key.name).and_then(Value::as_f64)
    }

    /// Something that no key says.
    fn beside(&mut self, name: &str, value: Value) {
        self.0.insert(name.into(), value);
    }

    fn json(self) -> Value {
        Value::Object(self.0)
    }
}

#[cfg(test)]
mod tests;
