//! Types, bounds and parameters as Rust writes them, with public paths.

use crate::document::{Library, field, id, kind, list, text};
use serde_json::Value;

impl Library {
    /// A type; types of this library by their public paths.
    pub(crate) fn spelled(&self, of: &Value) -> Result<String, String> {
        let (what, inner) = of
            .as_object()
            .and_then(|object| object.iter().next())
            .ok_or(format!("no type: {of}"))?;
        Ok(match what.as_str() {
            "generic" | "primitive" => inner.as_str().unwrap_or_default().into(),
            "resolved_path" => self.path(inner)?,
            "borrowed_ref" => {
                let lifetime = inner["lifetime"].as_str().map(|name| format!("{name} "));
                let mutable = if inner["is_mutable"] == true {
                    "mut "
                } else {
                    ""
                };
                let lifetime = lifetime.unwrap_or_default();
                format!(
                    "&{lifetime}{mutable}{}",
                    self.spelled(field(inner, "type")?)?
                )
            }
            "array" => {
                let element = self.spelled(field(inner, "type")?)?;
                format!("[{element}; {}]", text(inner, "len")?)
            }
            "slice" => format!("[{}]", self.spelled(inner)?),
            "tuple" => {
                let parts = inner.as_array().ok_or("a tuple that is no list")?;
                format!("({})", self.all(parts)?)
            }
            "impl_trait" => format!("impl {}", self.bounds(inner)?),
            "dyn_trait" => {
                let bounds = list(inner, "traits")?.iter();
                let bounds: Result<Vec<_>, _> =
                    bounds.map(|t| self.path(field(t, "trait")?)).collect();
                let lifetime = inner["lifetime"].as_str().map(|name| format!(" + {name}"));
                format!(
                    "dyn {}{}",
                    bounds?.join(" + "),
                    lifetime.unwrap_or_default()
                )
            }
            "function_pointer" => self.signature("fn", field(inner, "sig")?)?,
            "qualified_path" => {
                let this = self.spelled(field(inner, "self_type")?)?;
                let name = text(inner, "name")?;
                match inner["trait"]["id"].as_u64() {
                    Some(_) => format!("<{this} as {}>::{name}", self.path(&inner["trait"])?),
                    None => format!("{this}::{name}"),
                }
            }
            other => return Err(format!("a type of unknown kind {other}")),
        })
    }

    fn all(&self, types: &[Value]) -> Result<String, String> {
        let types: Result<Vec<_>, _> = types.iter().map(|t| self.spelled(t)).collect();
        Ok(types?.join(", "))
    }

    /// The name of a trait or type, and its arguments.
    pub(crate) fn path(&self, of: &Value) -> Result<String, String> {
        Ok(self.name(of)? + &self.arguments(&of["args"])?)
    }

    /// The name of a trait or type, without arguments: public paths; of foreign ones, which may be
    /// defined in private modules, crate, first module (of the standard library) and name.
    pub(crate) fn name(&self, of: &Value) -> Result<String, String> {
        let id = id(field(of, "id")?)?;
        if let Some(path) = self.public_path(&id) {
            return Ok(path.into());
        }
        let path = self.paths.get(&id).and_then(|path| path["path"].as_array());
        let words: Vec<&str> = path
            .into_iter()
            .flatten()
            .filter_map(Value::as_str)
            .collect();
        Ok(match words[..] {
            [crate_name @ ("core" | "alloc" | "std"), module, .., last] => {
                format!("{crate_name}::{module}::{last}")
            }
            [first, .., last] => format!("{first}::{last}"),
            _ => text(of, "path")?.into(),
        })
    }

    fn arguments(&self, of: &Value) -> Result<String, String> {
        if let Some(called) = of.get("parenthesized") {
            let output = match &called["output"] {
                Value::Null => String::new(),
                output => format!(" -> {}", self.spelled(output)?),
            };
            return Ok(format!("({}){output}", self.all(list(called, "inputs")?)?));
        }
        let Some(angles) = of.get("angle_bracketed") else {
            return Ok(String::new());
        };
        let mut arguments = Vec::new();
        for argument in list(angles, "args")? {
            arguments.push(if let Some(of) = argument.get("type") {
                self.spelled(of)?
            } else if let Some(constant) = argument.get("const") {
                self.constant(text(constant, "expr")?)
            } else {
                argument["lifetime"].as_str().unwrap_or("_").into()
            });
        }
        for constraint in list(angles, "constraints")? {
            let name = text(constraint, "name")?;
            let binding = field(constraint, "binding")?;
            arguments.push(match binding["equality"].get("type") {
                Some(value) => format!("{name} = {}", self.spelled(value)?),
                None => format!("{name}: {}", self.bounds(field(binding, "constraint")?)?),
            });
        }
        Ok(match arguments[..] {
            [] => String::new(),
            _ => format!("<{}>", arguments.join(", ")),
        })
    }

    /// The value of a constant that may be private, by its name.
    fn constant(&self, expression: &str) -> String {
        let named = self
            .index
            .values()
            .find(|item| item["name"] == expression && item["inner"].get("constant").is_some());
        let value = named.and_then(|item| item["inner"]["constant"]["const"]["value"].as_str());
        value
            .map_or(expression, |value| value.trim_end_matches("usize"))
            .into()
    }

    /// `A + B`.
    pub(crate) fn bounds(&self, of: &Value) -> Result<String, String> {
        let bounds = of.as_array().ok_or("bounds that are no list")?;
        let bounds: Result<Vec<_>, _> = bounds.iter().map(|bound| self.bound(bound)).collect();
        Ok(bounds?.join(" + "))
    }

    fn bound(&self, of: &Value) -> Result<String, String> {
        let Some(bound) = of.get("trait_bound") else {
            return Ok(of["outlives"].as_str().unwrap_or("use<..>").into());
        };
        let optional = if bound["modifier"] == "maybe" {
            "?"
        } else {
            ""
        };
        Ok(optional.to_string() + &self.path(field(bound, "trait")?)?)
    }

    /// `fn name(inputs) -> output`.
    pub(crate) fn signature(&self, head: &str, of: &Value) -> Result<String, String> {
        let mut inputs = Vec::new();
        for input in list(of, "inputs")? {
            let (name, of) = (input[0].as_str().unwrap_or("_"), self.spelled(&input[1])?);
            inputs.push(match (name, of.as_str()) {
                ("self", "Self") => "self".into(),
                ("self", "&Self") => "&self".into(),
                ("self", "&mut Self") => "&mut self".into(),
                _ => format!("{name}: {of}"),
            });
        }
        let output = match &of["output"] {
            Value::Null => String::new(),
            output => format!(" -> {}", self.spelled(output)?),
        };
        Ok(format!("{head}({}){output}", inputs.join(", ")))
    }

    /// `<R, const N: usize>` of an item, its bounds left to the documentation.
    pub(crate) fn generics(&self, item: &Value) -> Result<String, String> {
        let Some(generics) = kind(item)?.1.get("generics") else {
            return Ok(String::new());
        };
        let mut names = Vec::new();
        for parameter in list(generics, "params")? {
            let (name, of) = (text(parameter, "name")?, field(parameter, "kind")?);
            if of["type"]["is_synthetic"] != true {
                let constant = of.get("const").map_or("", |_| "const ");
                names.push(format!("{constant}{name}"));
            }
        }
        Ok(match names[..] {
            [] => String::new(),
            _ => format!("<{}>", names.join(", ")),
        })
    }
}
