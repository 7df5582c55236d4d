//! The surface: every public item on one line.

use crate::document::{Library, field, id, ids, kind, list, text};
use serde_json::Value;
use std::collections::BTreeMap;

/// Kinds of items that are counted: what a user has to know by name.
const COUNTED: [&str; 8] = [
    "struct",
    "enum",
    "union",
    "trait",
    "function",
    "type_alias",
    "constant",
    "macro",
];

impl Library {
    /// A line with the number of items, and one for each item, field, method and implementation;
    /// sorted by path.
    ///
    /// # Errors
    /// A description that this reader does not know.
    pub fn lines(&self) -> Result<Vec<String>, String> {
        let mut surface = Surface {
            library: self,
            lines: Vec::new(),
        };
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        for (own, paths) in &self.public {
            let Some((hidden, _, path)) = paths.first() else {
                continue;
            };
            let item = &self.index[own];
            surface.item(path, item)?;
            for (.., other) in paths.iter().skip(1) {
                surface.line(other, format!("use {other} = {path}"));
            }
            let counted = COUNTED
                .iter()
                .find(|&&counted| kind(item).is_ok_and(|(k, _)| k == counted));
            if let (Some(counted), false) = (counted, hidden) {
                *counts.entry(counted).or_default() += 1;
            }
        }
        for item in self.index.values().filter(|item| item["crate_id"] == 0) {
            if let ("impl", inner) = kind(item)? {
                surface.implementation(item, inner)?;
            }
        }
        surface.lines.sort();
        let counts: Vec<String> = counts
            .iter()
            .map(|(kind, count)| format!("{kind} {count}"))
            .collect();
        let total = format!("# {} items: {}", self.count(), counts.join(", "));
        let lines = surface.lines.into_iter().map(|(_, line)| line);
        let mut lines: Vec<String> = [total].into_iter().chain(lines).collect();
        lines.dedup();
        Ok(lines)
    }

    /// How many items a user has to know by name: all but modules, and what is hidden from the
    /// documentation.
    pub fn count(&self) -> usize {
        let counted =
            |id: &str| kind(&self.index[id]).is_ok_and(|(kind, _)| COUNTED.contains(&kind));
        let shown = |paths: &std::collections::BTreeSet<(bool, usize, String)>| {
            paths.first().is_some_and(|(hidden, ..)| !hidden)
        };
        self.public
            .iter()
            .filter(|(id, paths)| counted(id) && shown(paths))
            .count()
    }

    /// Public structures and enumerations that do not implement a trait.
    ///
    /// # Errors
    /// A description that this reader does not know.
    pub fn without(&self, wanted: &str) -> Result<Vec<String>, String> {
        let mut without = Vec::new();
        for own in self.public.keys() {
            let (what, inner) = kind(&self.index[own])?;
            if !["struct", "enum"].contains(&what) {
                continue;
            }
            let implements = ids(field(inner, "impls")?)?.iter().any(|id| {
                let of = &self.index.get(id).unwrap_or(&Value::Null)["inner"]["impl"];
                let own = of["is_synthetic"] == false && of["blanket_impl"].is_null();
                own && of["trait"]["path"]
                    .as_str()
                    .is_some_and(|path| path.ends_with(wanted))
            });
            if !implements {
                without.extend(self.public_path(own).map(String::from));
            }
        }
        Ok(without)
    }
}

struct Surface<'a> {
    library: &'a Library,
    /// With the path to sort by.
    lines: Vec<(String, String)>,
}

impl Surface<'_> {
    fn line(&mut self, path: &str, line: String) {
        self.lines.push((path.into(), line));
    }

    fn item(&mut self, path: &str, item: &Value) -> Result<(), String> {
        let library = self.library;
        let generics = library.generics(item)?;
        let (what, inner) = kind(item)?;
        let line = match what {
            "module" => format!("mod {path}"),
            "function" => {
                library.signature(&format!("fn {path}{generics}"), field(inner, "sig")?)?
            }
            "type_alias" => {
                format!(
                    "type {path}{generics} = {}",
                    library.spelled(field(inner, "type")?)?
                )
            }
            "constant" | "static" => {
                format!("{what} {path}: {}", library.spelled(field(inner, "type")?)?)
            }
            "struct" => {
                let structure = field(inner, "kind")?;
                let (plain, tuple) = (&structure["plain"]["fields"], &structure["tuple"]);
                for field in plain.as_array().or(tuple.as_array()).into_iter().flatten() {
                    self.field(path, field)?;
                }
                format!("struct {path}{generics}{}", self.derives(inner)?)
            }
            "enum" => {
                for variant in ids(field(inner, "variants")?)? {
                    self.variant(path, &variant)?;
                }
                format!("enum {path}{generics}{}", self.derives(inner)?)
            }
            "trait" => {
                for member in ids(field(inner, "items")?)? {
                    let member = library
                        .index
                        .get(&member)
                        .ok_or("a member that is not listed")?;
                    self.member(path, member)?;
                }
                let bounds = library.bounds(field(inner, "bounds")?)?;
                let colon = if bounds.is_empty() { "" } else { ": " };
                format!("trait {path}{generics}{colon}{bounds}")
            }
            other => format!("{other} {path}"),
        };
        self.line(path, line);
        Ok(())
    }

    fn field(&mut self, owner: &str, field_id: &Value) -> Result<(), String> {
        // A private field of a tuple has no number.
        let item = id(field_id).ok().and_then(|id| self.library.index.get(&id));
        if let Some(item) = item.filter(|item| item["visibility"] == "public") {
            let path = format!("{owner}.{}", text(item, "name")?);
            let of = self.library.spelled(kind(item)?.1)?;
            self.line(&path, format!("field {path}: {of}"));
        }
        Ok(())
    }

    fn variant(&mut self, owner: &str, id: &str) -> Result<(), String> {
        let library = self.library;
        let item = library
            .index
            .get(id)
            .ok_or("a variant that is not listed")?;
        let shape = field(kind(item)?.1, "kind")?;
        let spelled = |ids: &Value, named: bool| -> Result<String, String> {
            let mut fields = Vec::new();
            for id in crate::document::ids(ids)? {
                let item = library.index.get(&id).ok_or("a field that is not listed")?;
                let of = library.spelled(kind(item)?.1)?;
                fields.push(match named {
                    true => format!("{}: {of}", text(item, "name")?),
                    false => of,
                });
            }
            Ok(fields.join(", "))
        };
        let contents = match (shape.get("tuple"), shape.get("struct")) {
            (Some(ids), _) => format!("({})", spelled(ids, false)?),
            (_, Some(shape)) => format!(" {{ {} }}", spelled(field(shape, "fields")?, true)?),
            _ => String::new(),
        };
        let path = format!("{owner}::{}", text(item, "name")?);
        self.line(&path, format!("variant {path}{contents}"));
        Ok(())
    }

    /// A function, constant or type of a trait or an implementation.
    fn member(&mut self, owner: &str, item: &Value) -> Result<(), String> {
        let path = format!("{owner}::{}", text(item, "name")?);
        if kind(item)?.0 == "function" {
            return self.item(&path, item);
        }
        let what = kind(item)?.0.trim_start_matches("assoc_");
        self.line(&path, format!("{what} {path}"));
        Ok(())
    }

    /// `: Clone + Copy`
    fn derives(&self, inner: &Value) -> Result<String, String> {
        let mut names = Vec::new();
        for id in ids(field(inner, "impls")?)? {
            let item = self.library.index.get(&id).unwrap_or(&Value::Null);
            let of = &item["inner"]["impl"];
            if is_derived(item) && of["is_synthetic"] == false {
                names.extend(
                    of["trait"]["path"]
                        .as_str()
                        .and_then(|path| path.rsplit("::").next()),
                );
            }
        }
        names.retain(|name| !["StructuralPartialEq", "TrivialClone"].contains(name));
        names.sort_unstable();
        let colon = if names.is_empty() { "" } else { ": " };
        Ok(format!("{colon}{}", names.join(" + ")))
    }

    fn implementation(&mut self, item: &Value, inner: &Value) -> Result<(), String> {
        let library = self.library;
        let foreign = inner["is_synthetic"] == true || !field(inner, "blanket_impl")?.is_null();
        let this = field(inner, "for")?;
        if foreign || is_derived(item) || !library.is_reachable(this) {
            return Ok(());
        }
        let spelled = library.spelled(this)?;
        let implemented = field(inner, "trait")?;
        if !implemented.is_null() {
            let declared = id(field(implemented, "id")?)?;
            let is_private = library
                .index
                .get(&declared)
                .is_some_and(|it| it["crate_id"] == 0)
                && library.public_path(&declared).is_none();
            if !is_private {
                let line = format!("impl {} for {spelled}", library.path(implemented)?);
                self.line(&spelled, line);
            }
            return Ok(());
        }
        for member in list(inner, "items")? {
            let member = library
                .index
                .get(&id(member)?)
                .ok_or("a member that is not listed")?;
            if member["visibility"] == "public" {
                self.member(&spelled, member)?;
            }
        }
        Ok(())
    }
}

fn is_derived(item: &Value) -> bool {
    let attributes = item["attrs"].as_array();
    attributes.is_some_and(|all| {
        all.iter()
            .any(|attribute| attribute == "automatically_derived")
    })
}
