//! All public functions: free ones, methods of public types, and methods of public traits for every
//! type that implements them, provided methods included.

use crate::document::{Library, field, id, ids, is_hidden, kind, list, text};
use serde_json::Value;

/// Traits of the standard library whose methods no proof speaks of, and why.
pub const LEFT_OUT: [(&str, &str); 4] = [
    (
        "Debug",
        "writes through core::fmt, which has panics of its own",
    ),
    ("Display", "the same"),
    ("Error", "has no method of its own here"),
    ("Format", "logging, behind a feature"),
];

/// A public function.
#[derive(Clone, Debug)]
pub struct Function {
    /// As Rust writes it: `<coupling::DryProfile<P> as coupling::ReducedFriction<R>>::reduced_wrench`.
    pub path: String,
    /// Where it is defined, without generic arguments: `law::drag::reynolds`,
    /// `coupling::dry::Dry::new` or `coupling::dry::Dry as FrictionCoupling::reduced_wrench`; none where the
    /// type is not of this library.
    pub symbol: Option<String>,
    /// Generic parameters of the implementation and of the function; those of `impl Trait` are
    /// named by their place.
    pub parameters: Vec<Parameter>,
    /// Further conditions, as Rust writes them.
    pub conditions: Vec<String>,
    /// Arguments to be given to the function itself: `N`, `F`.
    pub own: Vec<String>,
    /// Types of arguments, `_` where they say nothing of a parameter of `impl Trait`.
    pub inputs: Vec<String>,
    /// `#[inline(always)]`: it has no symbol of its own.
    pub always_inlined: bool,
    /// Written by a derive.
    pub derived: bool,
}

/// A generic parameter.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// Its type if it is a constant.
    pub constant: Option<String>,
    /// Its bounds as Rust writes them.
    pub bounds: Vec<String>,
    /// It stands for `impl Trait` and cannot be given.
    pub is_synthetic: bool,
}

/// What the functions of an implementation share.
#[derive(Clone, Default)]
struct Owner {
    path: String,
    symbol: Option<String>,
    parameters: Vec<Parameter>,
    conditions: Vec<String>,
    derived: bool,
}

impl Library {
    /// All of them.
    ///
    /// # Errors
    /// A description that this reader does not know.
    pub fn functions(&self) -> Result<Vec<Function>, String> {
        let mut functions = Vec::new();
        for (own, item) in &self.index {
            let what = kind(item)?.0;
            if let (true, Some(path)) = (what == "function", self.public_path(own)) {
                let owner = Owner {
                    path: path.into(),
                    symbol: Some(self.definition(own)?),
                    ..Owner::default()
                };
                functions.push(self.function(&owner, item, item)?);
            } else if what == "impl" && item["crate_id"] == 0 {
                self.implemented(item, &mut functions)?;
            }
        }
        functions.sort_by(|a, b| a.path.cmp(&b.path));
        Ok(functions)
    }

    fn implemented(&self, item: &Value, functions: &mut Vec<Function>) -> Result<(), String> {
        let inner = kind(item)?.1;
        let foreign = inner["is_synthetic"] == true || !field(inner, "blanket_impl")?.is_null();
        let this = field(inner, "for")?;
        if foreign || !self.is_reachable(this) {
            return Ok(());
        }
        let implemented = field(inner, "trait")?;
        let (spelled, defined) = (self.spelled(this)?, self.defined(this)?);
        let mut owner = Owner {
            derived: list(item, "attrs")?
                .iter()
                .any(|a| a == "automatically_derived"),
            ..Owner::default()
        };
        self.parameters(
            field(inner, "generics")?,
            &mut owner.parameters,
            &mut owner.conditions,
        )?;
        let methods: Vec<&Value> = if implemented.is_null() {
            (owner.path, owner.symbol) = (format!("<{spelled}>"), defined);
            let methods = self.listed(inner)?.into_iter();
            methods
                .filter(|method| method["visibility"] == "public")
                .collect()
        } else {
            let name = text(implemented, "path")?
                .rsplit("::")
                .next()
                .unwrap_or_default();
            owner.path = format!("<{spelled} as {}>", self.path(implemented)?);
            owner.symbol = defined.map(|defined| format!("{defined} as {name}"));
            let declared = id(field(implemented, "id")?)?;
            match self.index.get(&declared) {
                Some(_) if self.public_path(&declared).is_none() => return Ok(()),
                // Provided methods too.
                Some(declared) if declared["crate_id"] == 0 => self.listed(kind(declared)?.1)?,
                _ if LEFT_OUT.iter().any(|(left_out, _)| *left_out == name) => return Ok(()),
                _ => self.listed(inner)?,
            }
        };
        for method in methods {
            let hidden = list(method, "attrs")?.iter().any(is_hidden);
            if kind(method)?.0 == "function" && !(owner.derived && hidden) {
                let name = text(method, "name")?;
                let owner = Owner {
                    path: format!("{}::{name}", owner.path),
                    symbol: owner
                        .symbol
                        .as_ref()
                        .map(|symbol| format!("{symbol}::{name}")),
                    ..owner.clone()
                };
                let written = self
                    .listed(inner)?
                    .into_iter()
                    .find(|own| own["name"] == name);
                functions.push(self.function(&owner, method, written.unwrap_or(method))?);
            }
        }
        Ok(())
    }

    fn listed(&self, of: &Value) -> Result<Vec<&Value>, String> {
        let ids = ids(field(of, "items")?)?;
        Ok(ids.iter().filter_map(|id| self.index.get(id)).collect())
    }

    /// Types that a user can name; types of other crates are.
    pub(crate) fn is_reachable(&self, this: &Value) -> bool {
        match this["resolved_path"].get("id").map(id) {
            Some(Ok(id)) => self.public_path(&id).is_some() || !self.index.contains_key(&id),
            _ => true,
        }
    }

    /// Where a type of this library or a primitive is defined.
    fn defined(&self, this: &Value) -> Result<Option<String>, String> {
        if let Some(primitive) = this["primitive"].as_str() {
            return Ok(Some(primitive.into()));
        }
        let Some(path) = this.get("resolved_path") else {
            return Ok(None);
        };
        let id = id(field(path, "id")?)?;
        let Some(item) = self.index.get(&id).filter(|item| item["crate_id"] == 0) else {
            return Ok(None);
        };
        match kind(item)? {
            ("type_alias", alias) => self.defined(field(alias, "type")?),
            _ => self.definition(&id).map(Some),
        }
    }

    /// The function `item` of an owner, whose body is that of `written`.
    fn function(&self, owner: &Owner, item: &Value, written: &Value) -> Result<Function, String> {
        let inner = kind(item)?.1;
        let mut parameters = owner.parameters.clone();
        let mut conditions = owner.conditions.clone();
        let outer = parameters.len();
        self.parameters(field(inner, "generics")?, &mut parameters, &mut conditions)?;
        let synthetic = |parameter: &&Parameter| parameter.is_synthetic;
        let mut places = parameters.iter().filter(synthetic);
        let mut inputs = Vec::new();
        for input in list(field(inner, "sig")?, "inputs")? {
            let mut of = input[1].clone();
            inputs.push(match named(&mut of, &mut places) {
                true => self.spelled(&of)?,
                false => "_".into(),
            });
        }
        let own = parameters.iter().skip(outer).filter(|p| !p.is_synthetic);
        Ok(Function {
            path: owner.path.clone(),
            symbol: owner.symbol.clone(),
            own: own.map(|parameter| parameter.name.clone()).collect(),
            inputs,
            always_inlined: list(written, "attrs")?
                .iter()
                .any(|attribute| attribute["other"] == "#[attr = Inline(Always)]"),
            derived: owner.derived,
            parameters,
            conditions,
        })
    }

    fn parameters(
        &self,
        generics: &Value,
        into: &mut Vec<Parameter>,
        conditions: &mut Vec<String>,
    ) -> Result<(), String> {
        for parameter in list(generics, "params")? {
            let (name, of) = (text(parameter, "name")?, field(parameter, "kind")?);
            if of.get("lifetime").is_some() {
                continue;
            }
            let is_synthetic = of["type"]["is_synthetic"] == true;
            let name = match is_synthetic {
                true => format!("Given{}", into.len()),
                false => name.into(),
            };
            let mut parameter = Parameter {
                name,
                is_synthetic,
                ..Parameter::default()
            };
            match of.get("const") {
                Some(of) => parameter.constant = Some(self.spelled(field(of, "type")?)?),
                None => parameter.bounds = self.each_bound(field(&of["type"], "bounds")?)?,
            }
            into.push(parameter);
        }
        for condition in list(generics, "where_predicates")? {
            let bound = field(condition, "bound_predicate")?;
            let (of, bounds) = (
                self.spelled(field(bound, "type")?)?,
                field(bound, "bounds")?,
            );
            match into.iter_mut().find(|parameter| parameter.name == of) {
                Some(parameter) => parameter.bounds.extend(self.each_bound(bounds)?),
                None => conditions.push(format!("{of}: {}", self.bounds(bounds)?)),
            }
        }
        Ok(())
    }

    fn each_bound(&self, bounds: &Value) -> Result<Vec<String>, String> {
        let bounds = bounds.as_array().ok_or("bounds that are no list")?;
        let one = |bound: &Value| self.bounds(&Value::Array(vec![bound.clone()]));
        bounds.iter().map(one).collect()
    }
}

/// Puts the names of parameters in the places of `impl Trait`; true if there was one.
fn named<'a>(of: &mut Value, names: &mut impl Iterator<Item = &'a Parameter>) -> bool {
    if of.get("impl_trait").is_some() {
        let name = names.next().map(|parameter| parameter.name.as_str());
        *of = serde_json::json!({ "generic": name.unwrap_or("_") });
        return true;
    }
    match of {
        // Every part has its own names: none is left out.
        Value::Array(parts) => {
            let named = parts.iter_mut().map(|part| named(part, names));
            named.filter(|any| *any).count() > 0
        }
        Value::Object(parts) => {
            let named = parts.values_mut().map(|part| named(part, names));
            named.filter(|any| *any).count() > 0
        }
        _ => false,
    }
}
