//! The public functions of the kernel, read from its source; and those that a program holds.
//!
//! Both sides speak in keys: `CompleteElliptic::k` for a method, `critical_angle` for a free
//! function, `Hertz as Profile::force` for a method of a trait. A function is public if it is
//! `pub` and its type (or itself) stands in a public module or is re-exported from one. What a
//! macro writes is not seen: its trait stands for it, as `Real::sqrt`.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{fs, io};
use syn::visit::{self, Visit};
use syn::{ImplItem, Item, ItemImpl, ItemMod, TraitItem, Type, UseTree, Visibility};

/// Traits whose methods are words for people, not results.
const SPOKEN: [&str; 4] = ["Display", "Debug", "Error", "Format"];

/// What the source of a crate declares.
#[derive(Debug, Default)]
struct Source {
    /// Names that users can write.
    exported: BTreeSet<String>,
    /// Free functions.
    free: BTreeSet<String>,
    /// (type, trait, method) of implementations.
    methods: BTreeSet<(String, Option<String>, String)>,
    /// (trait, method) of declarations.
    declared: BTreeSet<(String, String)>,
    /// (trait, method) with a body.
    provided: BTreeSet<(String, String)>,
}

/// Keys of all public functions of the crate whose `lib.rs` stands in `src`, sorted.
///
/// # Errors
/// A file that cannot be read or parsed.
pub fn public_functions(src: &Path) -> io::Result<Vec<String>> {
    let mut source = Source::default();
    source.file(&src.join("lib.rs"), src, true)?;
    let public = |name: &String| source.exported.contains(name);
    let mut keys: BTreeSet<String> = source.free.iter().filter(|f| public(f)).cloned().collect();
    for (owner, of_trait, method) in &source.methods {
        match of_trait {
            _ if !public(owner) => {}
            None => drop(keys.insert(format!("{owner}::{method}"))),
            Some(name) => drop(keys.insert(format!("{owner} as {name}::{method}"))),
        }
    }
    let implemented: BTreeSet<_> = (source.methods.iter())
        .filter_map(|(_, name, method)| Some((name.clone()?, method.clone())))
        .collect();
    // Defaults, and what only macros implement.
    for (name, method) in &source.declared {
        let pair = (name.clone(), method.clone());
        if public(name) && (source.provided.contains(&pair) || !implemented.contains(&pair)) {
            keys.insert(format!("{name}::{method}"));
        }
    }
    Ok(keys.into_iter().collect())
}

impl Source {
    /// Reads a file whose submodules stand in `folder`.
    fn file(&mut self, path: &Path, folder: &Path, reachable: bool) -> io::Result<()> {
        let text = fs::read_to_string(path)?;
        let wrong = |e| io::Error::other(format!("{}: {e}", path.display()));
        let items = syn::parse_file(&text).map_err(wrong)?.items;
        self.items(&items, folder, reachable)
    }

    fn items(&mut self, items: &[Item], folder: &Path, reachable: bool) -> io::Result<()> {
        for item in items {
            match item {
                Item::Mod(module) => self.module(module, folder, reachable)?,
                Item::Use(import) if reachable && is_public(&import.vis) => {
                    names(&import.tree, &mut self.exported);
                }
                Item::Fn(f) if is_public(&f.vis) => {
                    self.declare(&f.sig.ident, reachable);
                    self.free.insert(f.sig.ident.to_string());
                }
                Item::Struct(s) if is_public(&s.vis) => self.declare(&s.ident, reachable),
                Item::Enum(e) if is_public(&e.vis) => self.declare(&e.ident, reachable),
                Item::Type(t) if is_public(&t.vis) => self.declare(&t.ident, reachable),
                Item::Trait(t) if is_public(&t.vis) => {
                    self.declare(&t.ident, reachable);
                    self.trait_methods(t);
                }
                Item::Impl(block) => self.implementation(block),
                _ => {}
            }
        }
        Ok(())
    }

    fn declare(&mut self, name: &syn::Ident, reachable: bool) {
        if reachable {
            self.exported.insert(name.to_string());
        }
    }

    fn module(&mut self, module: &ItemMod, folder: &Path, reachable: bool) -> io::Result<()> {
        // Tests, and conversions behind features.
        if module.attrs.iter().any(|a| a.path().is_ident("cfg")) {
            return Ok(());
        }
        let reachable = reachable && is_public(&module.vis);
        let inner = folder.join(module.ident.to_string());
        match &module.content {
            Some((_, items)) => self.items(items, &inner, reachable),
            None => {
                let beside = inner.with_extension("rs");
                let path: PathBuf = [beside, inner.join("mod.rs")]
                    .into_iter()
                    .find(|path| path.is_file())
                    .ok_or_else(|| io::Error::other(format!("no file for {}", inner.display())))?;
                self.file(&path, &inner, reachable)
            }
        }
    }

    fn trait_methods(&mut self, item: &syn::ItemTrait) {
        for method in &item.items {
            if let TraitItem::Fn(f) = method {
                let pair = (item.ident.to_string(), f.sig.ident.to_string());
                if f.default.is_some() {
                    self.provided.insert(pair.clone());
                }
                self.declared.insert(pair);
            }
        }
    }

    fn implementation(&mut self, block: &ItemImpl) {
        let of_trait = block.trait_.as_ref().and_then(|(_, path, _)| last(path));
        if of_trait.as_deref().is_some_and(|t| SPOKEN.contains(&t)) {
            return;
        }
        let Some(owner) = owner(&block.self_ty) else {
            return;
        };
        for item in &block.items {
            if let ImplItem::Fn(f) = item
                && (of_trait.is_some() || is_public(&f.vis))
            {
                let method = f.sig.ident.to_string();
                self.methods
                    .insert((owner.clone(), of_trait.clone(), method));
            }
        }
    }
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

fn last(path: &syn::Path) -> Option<String> {
    Some(path.segments.last()?.ident.to_string())
}

/// The type that methods belong to; references count as what they refer to.
fn owner(of: &Type) -> Option<String> {
    match of {
        Type::Path(path) => last(&path.path),
        Type::Reference(to) => owner(&to.elem),
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
