//! rustdoc's JSON, and the walk along public paths.

use crate::merge::merged;
use crate::parts;
use serde_json::{Map, Value};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

/// The format that this reader was written for, of rustdoc 1.95. Others may have the same fields: a
/// field that is missing is an error, which names both versions.
const FORMAT: u64 = 57;

/// A library and the paths of its public items.
#[derive(Debug)]
pub struct Library {
    pub(crate) index: Map<String, Value>,
    pub(crate) paths: Map<String, Value>,
    /// All public paths of each item with their depth, the shortest first; hidden ones last.
    pub(crate) public: BTreeMap<String, BTreeSet<(bool, usize, String)>>,
    /// All modules, public or not: `law::lugre`.
    modules: BTreeSet<String>,
}

impl Library {
    /// What a package of this workspace makes public with these features.
    ///
    /// # Errors
    /// rustdoc fails, or writes a format that this reader does not know.
    pub fn read(package: &str, features: &[&str]) -> Result<Self, String> {
        let read = |part: &str| -> Result<Value, String> {
            let file = document(part, if part == package { features } else { &[] })?;
            let told = |error: &dyn std::fmt::Display| format!("{}: {error}", file.display());
            let text = std::fs::read_to_string(&file).map_err(|error| told(&error))?;
            serde_json::from_str(&text).map_err(|error| told(&error))
        };
        let all = parts(package).iter().copied().chain([package]).map(read);
        let document = merged(all.collect::<Result<_, _>>()?)?;
        let version = document["format_version"].as_u64().unwrap_or_default();
        Self::of(document).map_err(|error| {
            format!(
                "{package}: rustdoc wrote format {version}, tests/api reads format {FORMAT}: {error}"
            )
        })
    }

    fn of(mut document: Value) -> Result<Self, String> {
        let mut table = |key: &str| match document[key].take() {
            Value::Object(table) => Ok(table),
            _ => Err(format!("no {key}")),
        };
        let (index, paths) = (table("index")?, table("paths")?);
        let mut library = Self {
            index,
            paths,
            public: BTreeMap::new(),
            modules: BTreeSet::new(),
        };
        let root = id(&document["root"])?;
        library.walk(&root, "", false)?;
        for (id, item) in &library.index {
            if kind(item)?.0 == "module" && item["crate_id"] == 0 {
                library.modules.insert(library.definition(id)?);
            }
        }
        library.modules.remove("");
        Ok(library)
    }

    /// All modules, public or not: `law::lugre`.
    pub fn modules(&self) -> &BTreeSet<String> {
        &self.modules
    }

    /// The shortest public path of an item.
    pub(crate) fn public_path(&self, id: &str) -> Option<&str> {
        let (.., path) = self.public.get(id)?.first()?;
        Some(path)
    }

    /// Where an item of this library is defined, without the library's name.
    pub(crate) fn definition(&self, id: &str) -> Result<String, String> {
        let path = field(self.paths.get(id).ok_or("an item without path")?, "path")?;
        let words = path.as_array().ok_or("a path that is no list")?;
        let words: Vec<&str> = words.iter().skip(1).filter_map(Value::as_str).collect();
        Ok(words.join("::"))
    }

    fn walk(&mut self, module: &str, prefix: &str, hidden: bool) -> Result<(), String> {
        for child in self.children(module)? {
            let Some(item) = self.index.get(&child) else {
                continue;
            };
            if item["visibility"] != "public" {
                continue;
            }
            let hidden = hidden || list(item, "attrs")?.iter().any(is_hidden);
            let (what, inner) = kind(item)?;
            if what != "use" {
                let name = item["name"].as_str().ok_or("an item without name")?;
                let path = inside(prefix, name);
                self.publish(child, path, hidden)?;
            } else if inner["is_glob"] == true {
                let target = id(&inner["id"])?;
                // Others are of another crate, with a list of its own.
                if self.index.contains_key(&target) {
                    self.walk(&target, prefix, hidden)?;
                }
            } else {
                let name = inner["name"].as_str().ok_or("an import without name")?;
                let (target, path) = (id(&inner["id"])?, inside(prefix, name));
                self.publish(target, path, hidden)?;
            }
        }
        Ok(())
    }

    fn publish(&mut self, id: String, path: String, hidden: bool) -> Result<(), String> {
        // Of another crate.
        let Some(item) = self.index.get(&id) else {
            return Ok(());
        };
        let hidden = hidden || list(item, "attrs")?.iter().any(is_hidden);
        if kind(item)?.0 == "module" {
            self.walk(&id, &path, hidden)?;
        }
        let depth = path.matches("::").count();
        self.public
            .entry(id)
            .or_default()
            .insert((hidden, depth, path));
        Ok(())
    }

    /// Items of a module.
    fn children(&self, id: &str) -> Result<Vec<String>, String> {
        let module = self.index.get(id).ok_or("a module that is not listed")?;
        ids(field(kind(module)?.1, "items")?)
    }
}

/// The path of something in a module.
pub(crate) fn inside(module: &str, name: &str) -> String {
    let between = if module.is_empty() { "" } else { "::" };
    format!("{module}{between}{name}")
}

/// What an item is, and its description.
pub(crate) fn kind(item: &Value) -> Result<(&str, &Value), String> {
    let inner = item["inner"]
        .as_object()
        .and_then(|inner| inner.iter().next());
    inner
        .map(|(kind, inner)| (kind.as_str(), inner))
        .ok_or(format!("an item without kind: {item}"))
}

/// `#[doc(hidden)]`
pub(crate) fn is_hidden(attribute: &Value) -> bool {
    attribute["other"] == "#[doc(hidden)]"
}

/// A field that has to be there.
pub(crate) fn field<'a>(value: &'a Value, name: &str) -> Result<&'a Value, String> {
    value.get(name).ok_or(format!("no {name} in {value}"))
}

/// A list that has to be there.
pub(crate) fn list<'a>(value: &'a Value, name: &str) -> Result<&'a Vec<Value>, String> {
    let list = field(value, name)?.as_array();
    list.ok_or(format!("{name} is no list in {value}"))
}

/// A text that has to be there.
pub(crate) fn text<'a>(value: &'a Value, name: &str) -> Result<&'a str, String> {
    let text = field(value, name)?.as_str();
    text.ok_or(format!("{name} is no text in {value}"))
}

/// The name of an item in the tables.
pub(crate) fn id(value: &Value) -> Result<String, String> {
    value
        .as_u64()
        .map(|id| id.to_string())
        .ok_or(format!("no id: {value}"))
}

pub(crate) fn ids(list: &Value) -> Result<Vec<String>, String> {
    list.as_array()
        .ok_or("no list of ids")?
        .iter()
        .map(id)
        .collect()
}

/// Runs rustdoc for a crate; where it wrote.
fn document(part: &str, features: &[&str]) -> Result<PathBuf, String> {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or(root.join("target"), PathBuf::from);
    // A folder of its own, so that the switch below rebuilds nothing else; one for each set of features, so that
    // tests that run at the same time do not take one document for another.
    let folder = [&["api"], features].concat().join("-");
    let target = target.join(folder);
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let output = Command::new(cargo)
        .current_dir(root)
        .args(["rustdoc", "--quiet", "--lib", "--package", part])
        .args(["--features", &features.join(","), "--target-dir"])
        .arg(&target)
        .args(["--", "-Zunstable-options", "--output-format=json"])
        .args(["--document-private-items", "--document-hidden-items"])
        .args(["--cap-lints=allow"])
        // rustdoc's JSON is not stable; the stable compiler writes it when told that we know.
        .env("RUSTC_BOOTSTRAP", "1")
        .env_remove("RUSTFLAGS")
        .env_remove("RUSTDOCFLAGS")
        .output()
        .map_err(|error| format!("cannot run cargo: {error}"))?;
    if !output.status.success() {
        let complaint = String::from_utf8_lossy(&output.stderr);
        return Err(format!("rustdoc of {part} failed: {complaint}"));
    }
    let name = part.replace('-', "_") + ".json";
    Ok(target.join("doc").join(name))
}
