//! The public items of the kernel.

use super::source::{self, Placed, inside};
use super::{LEFT_OUT, Required};
use proc_macro2::{TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use syn::{GenericParam, Generics, ImplItem, Item, ItemImpl, TraitItem, Type, UseTree, Visibility};

/// The types and traits of the kernel, and which of them can be named from outside.
#[derive(Debug)]
pub struct Kernel {
    items: Vec<Placed>,
    /// Types with a hand-written `defmt::Format`.
    formatted: BTreeSet<String>,
    /// Types by path; aliases with their targets.
    types: BTreeMap<String, Option<Type>>,
    /// Methods of traits by path.
    traits: BTreeMap<String, Vec<String>>,
    public: BTreeSet<String>,
}

/// Macros that implement traits: for the types in their arguments these.
const MACROS: [(&str, &[&str]); 4] = [
    (
        "coupled",
        &["coupling::Coupling", "coupling::lateral::Lateral"],
    ),
    (
        "dry_profiles",
        &[
            "coupling::Coupling",
            "coupling::lateral::Lateral",
            "coupling::profile::Profile",
            "coupling::profile::SmoothProfile",
        ],
    ),
    ("impl_real", &["real::Real"]),
    // A trait without methods.
    ("modes", &[]),
];

const BOTH: [Option<&str>; 2] = [Some("f32"), Some("f64")];

impl Kernel {
    /// From the source.
    pub fn read() -> Result<Self, String> {
        let mut items = source::read()?;
        let formatted = formatted(&items);
        items.retain(|placed| !placed.conditional);
        let mut kernel = Self {
            items: Vec::new(),
            formatted,
            types: BTreeMap::new(),
            traits: BTreeMap::new(),
            public: BTreeSet::new(),
        };
        for Placed { module, item, .. } in &items {
            kernel.declare(module, item);
        }
        kernel.publish(&items);
        kernel.items = items;
        Ok(kernel)
    }

    fn declare(&mut self, module: &str, item: &Item) {
        match item {
            Item::Struct(item) => {
                self.types
                    .insert(inside(module, &item.ident.to_string()), None);
            }
            Item::Enum(item) => {
                self.types
                    .insert(inside(module, &item.ident.to_string()), None);
            }
            Item::Type(item) => {
                let path = inside(module, &item.ident.to_string());
                self.types.insert(path, Some((*item.ty).clone()));
            }
            Item::Trait(item) => {
                let method = |item: &TraitItem| match item {
                    TraitItem::Fn(method) => Some(method.sig.ident.to_string()),
                    _ => None,
                };
                let methods = item.items.iter().filter_map(method).collect();
                self.traits
                    .insert(inside(module, &item.ident.to_string()), methods);
            }
            _ => {}
        }
    }

    /// An item is public if it and all modules around it are, or a public module names it.
    fn publish(&mut self, items: &[Placed]) {
        let mut modules = BTreeSet::from([String::new()]);
        // Each round reaches one level deeper.
        for _ in 0..4 {
            for Placed { module, item, .. } in items {
                if let Item::Mod(inner) = item
                    && is_public(&inner.vis)
                    && modules.contains(module)
                {
                    modules.insert(inside(module, &inner.ident.to_string()));
                }
            }
        }
        for Placed { module, item, .. } in items {
            if !modules.contains(module) {
                continue;
            }
            match item {
                Item::Use(item) if is_public(&item.vis) => {
                    self.reexport(module, String::new(), &item.tree);
                }
                item => {
                    if let Some(name) = public_name(item) {
                        self.public.insert(inside(module, &name));
                    }
                }
            }
        }
    }

    fn reexport(&mut self, module: &str, prefix: String, tree: &UseTree) {
        match tree {
            UseTree::Path(path) => {
                let segment = path.ident.to_string();
                let parent = module.rsplit_once("::").map_or("", |(parent, _)| parent);
                let prefix = match segment.as_str() {
                    "crate" => String::new(),
                    "super" => parent.into(),
                    _ if prefix.is_empty() && !module.is_empty() => inside(module, &segment),
                    _ => inside(&prefix, &segment),
                };
                self.reexport(module, prefix, &path.tree);
            }
            UseTree::Name(name) => {
                self.public.insert(inside(&prefix, &name.ident.to_string()));
            }
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.reexport(module, prefix.clone(), tree);
                }
            }
            UseTree::Rename(_) | UseTree::Glob(_) => {}
        }
    }

    /// All functions that have to be in the image.
    pub fn functions(&self) -> Result<BTreeSet<Required>, String> {
        let mut required = BTreeSet::new();
        for Placed { module, item, .. } in &self.items {
            match item {
                Item::Fn(item) => {
                    let path = inside(module, &item.sig.ident.to_string());
                    if self.public.contains(&path) {
                        let precisions = precisions(&[&item.sig.generics], "");
                        required.extend(each(&path, &precisions));
                    }
                }
                Item::Impl(item) => self.implemented(module, item, &mut required)?,
                Item::Macro(item) if item.ident.is_none() => {
                    let name = item.mac.path.segments.last().map(|s| s.ident.to_string());
                    let name = name.unwrap_or_default();
                    self.expanded(module, &name, &item.mac.tokens, &mut required)?;
                }
                _ => {}
            }
        }
        Ok(required)
    }

    fn implemented(
        &self,
        module: &str,
        item: &ItemImpl,
        required: &mut BTreeSet<Required>,
    ) -> Result<(), String> {
        let Some(this) = self.type_path(module, &item.self_ty) else {
            return Ok(());
        };
        let Some((_, implemented, _)) = &item.trait_ else {
            for method in &item.items {
                if let ImplItem::Fn(method) = method
                    && is_public(&method.vis)
                {
                    let path = inside(&this, &method.sig.ident.to_string());
                    let generics = [&item.generics, &method.sig.generics];
                    let precisions = precisions(&generics, &self.spelled(module, &item.self_ty));
                    required.extend(each(&path, &precisions));
                }
            }
            return Ok(());
        };
        let last = implemented
            .segments
            .last()
            .map(|segment| segment.ident.to_string());
        let last = last.unwrap_or_default();
        let (path, methods) = match (self.find(module, &last, self.traits.keys()), last.as_str()) {
            (Some(path), _) if self.public.contains(&path) => {
                let methods = self.traits[&path].clone();
                (path, methods)
            }
            // The kernel's own and private.
            (Some(_), _) => return Ok(()),
            (None, "From") => ("core::convert::From".into(), vec!["from".into()]),
            (None, "Default") => ("core::default::Default".into(), vec!["default".into()]),
            (None, last) if LEFT_OUT.iter().any(|(left_out, _)| *left_out == last) => {
                return Ok(());
            }
            (None, last) => return Err(format!("the proof knows no trait {last}: teach it")),
        };
        let text = self.spelled(module, &item.self_ty) + &text_of(implemented);
        let precisions = precisions(&[&item.generics], &text);
        for method in methods {
            required.extend(each(&format!("<{this} as {path}>::{method}"), &precisions));
        }
        Ok(())
    }

    /// The traits that a macro of the kernel implements.
    fn expanded(
        &self,
        module: &str,
        name: &str,
        arguments: &TokenStream,
        required: &mut BTreeSet<Required>,
    ) -> Result<(), String> {
        let known = MACROS.iter().find(|(known, _)| *known == name);
        let (_, traits) = known.ok_or(format!("the proof knows no macro {name}: teach it"))?;
        // The capitalized words before a semicolon or closure name types or their arguments.
        let words = arguments.clone().into_iter().take_while(|token| {
            !matches!(token, TokenTree::Punct(mark) if mark.as_char() == '|' || mark.as_char() == ';')
        });
        for word in words {
            let TokenTree::Ident(word) = word else {
                continue;
            };
            let word = word.to_string();
            let (this, precisions) = match word.as_str() {
                "f32" | "f64" => (Some(word.clone()), precisions(&[], &word)),
                _ => (self.find(module, &word, self.types.keys()), BOTH.to_vec()),
            };
            let Some(this) = this else { continue };
            for implemented in *traits {
                for method in &self.traits[*implemented] {
                    let path = format!("<{this} as {implemented}>::{method}");
                    required.extend(each(&path, &precisions));
                }
            }
        }
        Ok(())
    }

    /// Public types of the kernel without `defmt::Format` behind the feature `defmt`.
    pub fn types_without_format(&self) -> Vec<String> {
        let mut without = Vec::new();
        for Placed { module, item, .. } in &self.items {
            let (name, attributes) = match item {
                Item::Struct(item) => (item.ident.to_string(), &item.attrs),
                Item::Enum(item) => (item.ident.to_string(), &item.attrs),
                // Types that a macro declares.
                Item::Macro(item) => {
                    let text = text_of(&item.mac.tokens);
                    if text.contains("pub struct") && !text.contains("defmt :: Format") {
                        without.push(format!("the types of a macro in {module}"));
                    }
                    continue;
                }
                _ => continue,
            };
            let is_derived = attributes.iter().any(|attribute| {
                let text = text_of(attribute);
                text.contains("cfg_attr") && text.contains("defmt :: Format")
            });
            let path = inside(module, &name);
            if self.public.contains(&path) && !is_derived && !self.formatted.contains(&name) {
                without.push(path);
            }
        }
        without
    }

    /// The path of a public type, `&` for a reference, the last word of a foreign one.
    fn type_path(&self, module: &str, this: &Type) -> Option<String> {
        match this {
            Type::Reference(_) => Some("&".into()),
            Type::Path(path) => {
                let last = path.path.segments.last()?.ident.to_string();
                match self.find(module, &last, self.types.keys()) {
                    Some(path) => match &self.types[&path] {
                        Some(meant) => self.type_path(module, meant),
                        None => self.public.contains(&path).then_some(path),
                    },
                    // nalgebra's vectors are matrices.
                    None if last == "Vector3" => Some("nalgebra::base::matrix::Matrix".into()),
                    None => Some(last),
                }
            }
            _ => None,
        }
    }

    /// The text of a type, aliases resolved.
    fn spelled(&self, module: &str, this: &Type) -> String {
        if let Type::Path(path) = this
            && let Some(last) = path.path.segments.last()
            && let Some(found) = self.find(module, &last.ident.to_string(), self.types.keys())
            && let Some(meant) = &self.types[&found]
        {
            return text_of(meant);
        }
        text_of(this)
    }

    /// What `name` means in `module`: declared there or in the nearest module around it, or the only
    /// one of that name.
    fn find<'a>(
        &self,
        module: &str,
        name: &str,
        paths: impl Iterator<Item = &'a String>,
    ) -> Option<String> {
        let last = |path: &&String| path.rsplit("::").next() == Some(name);
        let same: Vec<&String> = paths.filter(last).collect();
        let mut around = Some(module);
        while let Some(here) = around {
            let path = inside(here, name);
            if same.contains(&&path) {
                return Some(path);
            }
            around = match here.rsplit_once("::") {
                Some((parent, _)) => Some(parent),
                None if here.is_empty() => None,
                None => Some(""),
            };
        }
        match same[..] {
            [only] => Some(only.clone()),
            _ => None,
        }
    }
}

/// Implementors of `defmt::Format`.
fn formatted(items: &[Placed]) -> BTreeSet<String> {
    let implementor = |placed: &Placed| match &placed.item {
        Item::Impl(item) => {
            let (_, implemented, _) = item.trait_.as_ref()?;
            let Type::Path(this) = &*item.self_ty else {
                return None;
            };
            let is_format = implemented.segments.last()?.ident == "Format";
            is_format.then_some(this.path.segments.last()?.ident.to_string())
        }
        _ => None,
    };
    items.iter().filter_map(implementor).collect()
}

fn each<'a>(
    path: &'a str,
    precisions: &'a [Option<&'static str>],
) -> impl Iterator<Item = Required> + 'a {
    precisions.iter().map(|&precision| Required {
        path: path.into(),
        precision,
    })
}

/// Both where the scalar `R` is a parameter, else those named in `text`.
fn precisions(generics: &[&Generics], text: &str) -> Vec<Option<&'static str>> {
    let is_scalar = |parameter: &GenericParam| match parameter {
        GenericParam::Type(parameter) => parameter.ident == "R",
        _ => false,
    };
    if generics
        .iter()
        .any(|generics| generics.params.iter().any(is_scalar))
    {
        return BOTH.to_vec();
    }
    let named: Vec<_> = BOTH
        .into_iter()
        .filter(|p| p.is_some_and(|p| text.contains(p)))
        .collect();
    if named.is_empty() { vec![None] } else { named }
}

fn public_name(item: &Item) -> Option<String> {
    let (visibility, name) = match item {
        Item::Fn(item) => (&item.vis, &item.sig.ident),
        Item::Struct(item) => (&item.vis, &item.ident),
        Item::Enum(item) => (&item.vis, &item.ident),
        Item::Trait(item) => (&item.vis, &item.ident),
        Item::Type(item) => (&item.vis, &item.ident),
        _ => return None,
    };
    is_public(visibility).then(|| name.to_string())
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

fn text_of(tokens: &impl quote::ToTokens) -> String {
    tokens.to_token_stream().to_string()
}
