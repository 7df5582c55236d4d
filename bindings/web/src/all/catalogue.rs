//! The laws of the library.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde_json::{Value, json};
use tribos_friction::{LAWS, Law, LawEntry};

/// All of them as JSON.
pub fn laws() -> String {
    let entry = |law: &LawEntry| {
        let parameters = law.parameters.iter().map(|parameter| {
            json!({
                "name": parameter.name,
                "unit": parameter.unit,
                "meaning": parameter.meaning,
                "default": parameter.default,
            })
        });
        json!({
            "name": law.name,
            "summary": law.summary,
            "formula": law.formula,
            "source": law.source,
            "isLocal": law.local.is_some(),
            "parameters": parameters.collect::<Vec<_>>(),
        })
    };
    Value::Array(LAWS.iter().map(entry).collect()).to_string()
}

/// Name and parameters of a law as JSON.
pub fn parts(law: &Law) -> String {
    let values: serde_json::Map<String, Value> = law
        .values()
        .map(|(name, value)| (name.into(), json!(value)))
        .collect();
    json!({ "name": law.name(), "parameters": values, "text": law.to_string() }).to_string()
}
