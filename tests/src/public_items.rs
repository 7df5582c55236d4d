//! The public functions of the kernel, read from its source.
//!
//! They are told by keys without generics: `special::elliptic::CompleteElliptic::k` for a
//! method, `law::incline::critical_angle` for a free function, and
//! `coupling::closed::Hertz as Profile::factors` for a method of a trait. A function is public if
//! it is `pub` and its type (or itself) stands in a public module or is re-exported from one. What
//! a macro writes is not seen: its trait stands for it, as `Real::sqrt`, and so it does for methods
//! with a default.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{fs, io};
use syn::visit::{self, Visit};
use syn::{
    Attribute, Generics, ImplItem, Item, ItemImpl, ItemMod, TraitItem, Type, UseTree, Visibility,
};

/// Traits whose methods are words for people, not results.
const SPOKEN: [&str; 4] = ["Display", "Debug", "Error", "Format"];
/// The type parameter that stands for a precision.
const PRECISION: &str = "R";

/// In which precisions a function exists.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Precision {
    /// It names none, or is written for one.
    Fixed,
    /// f32 and f64.
    Both,
    /// Always inlined, `#[inline(always)]`: it leaves no symbol and is held by its callers.
    Inlined,
}

/// A method of an implementation.
#[derive(Debug)]
struct Method {
    owner: String,
    of_trait: Option<String>,
    name: String,
    /// Module of the implementation.
    module: String,
    precision: Precision,
}

/// What the source of a crate declares.
#[derive(Debug, Default)]
struct Source {
    /// Names that users can write.
    exported: BTreeSet<String>,
    /// Modules in which a type of a name is defined.
    homes: BTreeMap<String, BTreeSet<String>>,
    /// Free functions by name: key and precision.
    free: Vec<(String, String, Precision)>,
    methods: Vec<Method>,
    /// (trait, method) of declarations.
    declared: BTreeMap<(String, String), Precision>,
    /// (trait, method) with a body.
    provided: BTreeSet<(String, String)>,
}

/// Keys of all public functions of the crate whose `lib.rs` stands in `src`.
///
/// # Errors
/// A file that cannot be read or parsed.
pub fn public_functions(src: &Path) -> io::Result<BTreeMap<String, Precision>> {
    let mut source = Source::default();
    source.file(&src.join("lib.rs"), src, "", Reach::Public)?;
    let public = |name: &String| source.exported.contains(name);
    let mut keys = BTreeMap::new();
    for (name, key, precision) in source.free.iter().filter(|(name, ..)| public(name)) {
        debug_assert!(key.ends_with(name));
        keys.insert(key.clone(), *precision);
    }
    for method in source.methods.iter().filter(|method| public(&method.owner)) {
        keys.insert(source.key(method), method.precision);
    }
    let implemented: BTreeSet<_> = (source.methods.iter())
        .filter_map(|method| Some((method.of_trait.clone()?, method.name.clone())))
        .collect();
    // Defaults, and what only macros implement.
    for (pair, precision) in &source.declared {
        if public(&pair.0) && (source.provided.contains(pair) || !implemented.contains(pair)) {
            keys.insert(format!("{}::{}", pair.0, pair.1), *precision);
        }
    }
    Ok(keys)
}

/// Whether users can name a module.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reach {
    Public,
    Private,
}

/// Where items stand.
#[derive(Clone, Copy)]
struct Place<'a> {
    folder: &'a Path,
    /// Path of the module, with `::` behind it unless empty.
    module: &'a str,
    reach: Reach,
}

impl Source {
    /// The key of a method, by the module that defines its type.
    fn key(&self, method: &Method) -> String {
        let Method {
            owner,
            name,
            module,
            ..
        } = method;
        let homes = self.homes.get(owner);
        let home = homes.and_then(|homes| homes.get(module).or_else(|| homes.first()));
        let home = home.unwrap_or(module);
        match &method.of_trait {
            None => format!("{home}{owner}::{name}"),
            Some(of_trait) => format!("{home}{owner} as {of_trait}::{name}"),
        }
    }

    /// Reads a file whose submodules stand in `folder`.
    fn file(&mut self, path: &Path, folder: &Path, module: &str, reach: Reach) -> io::Result<()> {
        let text = fs::read_to_string(path)?;
        let wrong = |e| io::Error::other(format!("{}: {e}", path.display()));
        let items = syn::parse_file(&text).map_err(wrong)?.items;
        let place = Place {
            folder,
            module,
            reach,
        };
        self.items(&items, place)
    }

    fn items(&mut self, items: &[Item], place: Place<'_>) -> io::Result<()> {
        let exported = place.reach == Reach::Public;
        for item in items {
            match item {
                Item::Mod(module) => self.module(module, place)?,
                Item::Use(import) if exported && is_public(&import.vis) => {
                    names(&import.tree, &mut self.exported);
                }
                Item::Fn(f) if is_public(&f.vis) => {
                    self.declare(&f.sig.ident, place);
                    let name = f.sig.ident.to_string();
                    let key = format!("{}{name}", place.module);
                    self.free
                        .push((name, key, precision(&f.attrs, &[&f.sig.generics])));
                }
                Item::Struct(s) => self.type_at(&s.ident, &s.vis, place),
                Item::Enum(e) => self.type_at(&e.ident, &e.vis, place),
                Item::Trait(t) if is_public(&t.vis) => {
                    self.declare(&t.ident, place);
                    self.trait_methods(t);
                }
                Item::Type(t) if is_public(&t.vis) => self.declare(&t.ident, place),
                Item::Impl(block) => self.implementation(block, place.module, items),
                _ => {}
            }
        }
        Ok(())
    }

    fn declare(&mut self, name: &syn::Ident, place: Place<'_>) {
        if place.reach == Reach::Public {
            self.exported.insert(name.to_string());
        }
    }

    fn type_at(&mut self, name: &syn::Ident, visibility: &Visibility, place: Place<'_>) {
        let homes = self.homes.entry(name.to_string()).or_default();
        homes.insert(place.module.to_owned());
        if is_public(visibility) {
            self.declare(name, place);
        }
    }

    fn module(&mut self, module: &ItemMod, place: Place<'_>) -> io::Result<()> {
        // Tests, and conversions behind features.
        if module.attrs.iter().any(|a| a.path().is_ident("cfg")) {
            return Ok(());
        }
        let seen = place.reach == Reach::Public && is_public(&module.vis);
        let reach = if seen { Reach::Public } else { Reach::Private };
        let folder = place.folder.join(module.ident.to_string());
        let name = format!("{}{}::", place.module, module.ident);
        if let Some((_, items)) = &module.content {
            let (folder, module) = (folder.as_path(), name.as_str());
            return self.items(
                items,
                Place {
                    folder,
                    module,
                    reach,
                },
            );
        }
        let files: [PathBuf; 2] = [folder.with_extension("rs"), folder.join("mod.rs")];
        let file = files.iter().find(|path| path.is_file());
        let file = file.ok_or_else(|| io::Error::other(format!("no file for {name}")))?;
        self.file(file, &folder, &name, reach)
    }

    fn trait_methods(&mut self, item: &syn::ItemTrait) {
        for method in &item.items {
            if let TraitItem::Fn(f) = method {
                let pair = (item.ident.to_string(), f.sig.ident.to_string());
                if f.default.is_some() {
                    self.provided.insert(pair.clone());
                }
                let precision = precision(&f.attrs, &[&item.generics, &f.sig.generics]);
                self.declared.insert(pair, precision);
            }
        }
    }

    fn implementation(&mut self, block: &ItemImpl, module: &str, beside: &[Item]) {
        let of_trait = block.trait_.as_ref().and_then(|(_, path, _)| last(path));
        if of_trait.as_deref().is_some_and(|t| SPOKEN.contains(&t)) {
            return;
        }
        let Some(owner) = owner(&block.self_ty).map(|name| unaliased(name, beside)) else {
            return;
        };
        for item in &block.items {
            if let ImplItem::Fn(f) = item
                && (of_trait.is_some() || is_public(&f.vis))
            {
                self.methods.push(Method {
                    owner: owner.clone(),
                    of_trait: of_trait.clone(),
                    name: f.sig.ident.to_string(),
                    module: module.to_owned(),
                    precision: precision(&f.attrs, &[&block.generics, &f.sig.generics]),
                });
            }
        }
    }
}

fn precision(attributes: &[Attribute], generics: &[&Generics]) -> Precision {
    if attributes.iter().any(is_always_inlined) {
        return Precision::Inlined;
    }
    let mut parameters = generics.iter().flat_map(|generics| generics.type_params());
    if parameters.any(|parameter| parameter.ident == PRECISION) {
        Precision::Both
    } else {
        Precision::Fixed
    }
}

fn is_always_inlined(attribute: &Attribute) -> bool {
    attribute.path().is_ident("inline")
        && attribute
            .parse_args::<syn::Ident>()
            .is_ok_and(|how| how == "always")
}

/// The type that a name stands for, if it is an alias of the same module.
fn unaliased(name: String, items: &[Item]) -> String {
    let alias = items.iter().find_map(|item| match item {
        Item::Type(alias) if alias.ident == name => owner(&alias.ty),
        _ => None,
    });
    alias.unwrap_or(name)
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

fn last(path: &syn::Path) -> Option<String> {
    Some(path.segments.last()?.ident.to_string())
}

/// The type that methods belong to; references are only doors to others.
fn owner(of: &Type) -> Option<String> {
    match of {
        Type::Path(path) => last(&path.path),
        _ => None,
    }
}

/// The names that a `use` brings out.
fn names(tree: &UseTree, into: &mut BTreeSet<String>) {
    struct Names<'a>(&'a mut BTreeSet<String>);
    impl Visit<'_> for Names<'_> {
        fn visit_use_name(&mut self, name: &syn::UseName) {
            self.0.insert(name.ident.to_string());
        }
        fn visit_use_rename(&mut self, name: &syn::UseRename) {
            self.0.insert(name.ident.to_string());
        }
    }
    visit::visit_use_tree(&mut Names(into), tree);
}
