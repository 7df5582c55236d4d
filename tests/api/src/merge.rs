//! Descriptions of several crates as one: the crate that users name shows items of those below it.

use serde_json::{Map, Value};
use std::collections::HashMap;

/// Numbers of one description are below this.
const RANGE: u64 = 1 << 32;

/// The descriptions as one, whose root is that of the last.
///
/// # Errors
/// A description that this reader does not know.
pub(crate) fn merged(documents: Vec<Value>) -> Result<Value, String> {
    let mut own = HashMap::new();
    for (number, document) in documents.iter().enumerate() {
        for (id, path) in paths(document)? {
            if path["crate_id"] == 0 {
                own.insert(name(path), shifted(number, parsed(id)?));
            }
        }
    }
    let mut whole = Map::new();
    for (number, mut document) in documents.into_iter().enumerate() {
        // What another of the crates defines has its number there.
        let mut known = HashMap::new();
        for (id, path) in paths(&document)? {
            if let (Some(there), false) = (own.get(&name(path)), path["crate_id"] == 0) {
                known.insert(parsed(id)?, *there);
            }
        }
        let of = |id: u64| known.get(&id).copied().unwrap_or(shifted(number, id));
        for table in ["index", "paths"] {
            let Value::Object(rows) = document[table].take() else {
                return Err(format!("no {table}"));
            };
            let all = whole.entry(table).or_insert_with(|| Map::new().into());
            for (id, mut row) in rows {
                let (id, is_elsewhere) = (parsed(&id)?, known.contains_key(&parsed(&id)?));
                renumber(&mut row, &of);
                if let (Some(all), false) = (all.as_object_mut(), is_elsewhere) {
                    all.insert(of(id).to_string(), row);
                }
            }
        }
        let root = document["root"].as_u64().ok_or("no root")?;
        whole.insert("root".into(), of(root).into());
        whole.insert("format_version".into(), document["format_version"].take());
    }
    Ok(whole.into())
}

fn paths(document: &Value) -> Result<&Map<String, Value>, String> {
    document["paths"].as_object().ok_or("no paths".into())
}

fn parsed(id: &str) -> Result<u64, String> {
    id.parse().map_err(|_| format!("no id: {id}"))
}

fn shifted(document: usize, id: u64) -> u64 {
    document as u64 * RANGE + id
}

/// Kind and path of definition: what is the same in all descriptions.
fn name(path: &Value) -> String {
    format!("{} {}", path["kind"], path["path"])
}

/// Changes every number of an item in a description.
fn renumber(value: &mut Value, of: &impl Fn(u64) -> u64) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                match (key.as_str(), value.as_u64()) {
                    ("id", Some(id)) => *value = of(id).into(),
                    (
                        "items" | "impls" | "variants" | "fields" | "implementations" | "tuple",
                        _,
                    ) => {
                        for one in value.as_array_mut().into_iter().flatten() {
                            if let Some(id) = one.as_u64() {
                                *one = of(id).into();
                            }
                        }
                        renumber(value, of);
                    }
                    _ => renumber(value, of),
                }
            }
        }
        Value::Array(list) => list.iter_mut().for_each(|value| renumber(value, of)),
        _ => {}
    }
}
