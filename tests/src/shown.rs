//! Which public items of a crate an example shows, read from its source.
//!
//! An item is shown if an example names it where its reader looks: in the file that defines it, in
//! its own words or those of its neighbours, or on the page of a module above. What is called by the
//! name of its type, such as a constructor, needs an example that names both. Fields, variants and
//! what a trait asks of others are shown by their owner.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{fs, io};
use syn::{Attribute, Expr, ImplItem, Item, Lit, Meta, TraitItem, Type, UseTree, Visibility};

/// An item that users can name.
#[derive(Debug)]
struct Declared {
    file: PathBuf,
    /// The type that it belongs to.
    owner: Option<String>,
    name: String,
    /// It is called by the name of its owner, not on a value.
    by_owner: bool,
}

#[derive(Debug, Default)]
struct Crate {
    /// Names that users can write.
    exported: BTreeSet<String>,
    declared: Vec<Declared>,
    /// The examples of each file, as their words.
    examples: BTreeMap<PathBuf, Vec<BTreeSet<String>>>,
}

/// Public items of the crate whose `lib.rs` stands in `src` that no example shows, as
/// `file: Owner::name`.
///
/// # Errors
/// A file that cannot be read or parsed.
pub fn without_example(src: &Path) -> io::Result<Vec<String>> {
    let mut found = Crate::default();
    found.file(&src.join("lib.rs"), src, true)?;
    let lacking = found.declared.iter().filter(|item| found.lacks(item));
    let place = |item: &Declared| {
        let file = item.file.strip_prefix(src).unwrap_or(&item.file);
        let owner = item.owner.iter().map(|owner| format!("{owner}::"));
        format!(
            "{}: {}{}",
            file.display(),
            owner.collect::<String>(),
            item.name
        )
    };
    Ok(lacking.map(place).collect())
}

impl Crate {
    fn lacks(&self, item: &Declared) -> bool {
        let public = item.owner.as_ref().unwrap_or(&item.name);
        let shows = |example: &BTreeSet<String>| {
            example.contains(&item.name) && (!item.by_owner || example.contains(public))
        };
        let pages = pages(&item.file);
        let mut examples = pages
            .iter()
            .filter_map(|page| self.examples.get(page))
            .flatten();
        self.exported.contains(public) && !examples.any(shows)
    }

    fn file(&mut self, path: &Path, folder: &Path, public: bool) -> io::Result<()> {
        let wrong = |e| io::Error::other(format!("{}: {e}", path.display()));
        let parsed = syn::parse_file(&fs::read_to_string(path)?).map_err(wrong)?;
        self.words(path, &parsed.attrs);
        self.items(&parsed.items, path, folder, public)
    }

    fn items(
        &mut self,
        items: &[Item],
        path: &Path,
        folder: &Path,
        public: bool,
    ) -> io::Result<()> {
        for item in items {
            match item {
                Item::Mod(module) if module.attrs.iter().all(|a| !a.path().is_ident("cfg")) => {
                    let seen = public && is_public(&module.vis);
                    let inner = folder.join(module.ident.to_string());
                    self.words(path, &module.attrs);
                    if let Some((_, items)) = &module.content {
                        self.items(items, path, &inner, seen)?;
                    } else {
                        let files = [inner.with_extension("rs"), inner.join("mod.rs")];
                        let file = files.iter().find(|file| file.is_file());
                        let file = file
                            .ok_or_else(|| io::Error::other(format!("no {}", inner.display())))?;
                        self.file(file, &inner, seen)?;
                    }
                }
                Item::Use(import) if public && is_public(&import.vis) => {
                    names(&import.tree, &mut self.exported)
                }
                Item::Fn(f) => self.declare(path, &f.attrs, &f.vis, &f.sig.ident, public),
                Item::Struct(s) => self.declare(path, &s.attrs, &s.vis, &s.ident, public),
                Item::Enum(e) => self.declare(path, &e.attrs, &e.vis, &e.ident, public),
                Item::Type(t) => self.declare(path, &t.attrs, &t.vis, &t.ident, public),
                Item::Const(c) => self.declare(path, &c.attrs, &c.vis, &c.ident, public),
                Item::Trait(t) => {
                    self.declare(path, &t.attrs, &t.vis, &t.ident, public);
                    for part in &t.items {
                        if let TraitItem::Fn(f) = part {
                            self.words(path, &f.attrs);
                        }
                    }
                }
                Item::Impl(block) => {
                    self.words(path, &block.attrs);
                    self.members(block, path);
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn declare(
        &mut self,
        path: &Path,
        attributes: &[Attribute],
        visibility: &Visibility,
        name: &syn::Ident,
        public: bool,
    ) {
        self.words(path, attributes);
        if !is_public(visibility) {
            return;
        }
        let name = name.to_string();
        if public {
            self.exported.insert(name.clone());
        }
        self.declared.push(Declared {
            file: path.to_owned(),
            owner: None,
            name,
            by_owner: false,
        });
    }

    fn members(&mut self, block: &syn::ItemImpl, path: &Path) {
        let owner = match &*block.self_ty {
            Type::Path(of) => of.path.segments.last().map(|last| last.ident.to_string()),
            _ => None,
        };
        for item in &block.items {
            let (attributes, visibility, name, by_owner) = match item {
                ImplItem::Fn(f) => (&f.attrs, &f.vis, &f.sig.ident, f.sig.receiver().is_none()),
                ImplItem::Const(c) => (&c.attrs, &c.vis, &c.ident, true),
                _ => continue,
            };
            self.words(path, attributes);
            // Methods of a trait are the trait's.
            if block.trait_.is_none() && is_public(visibility) {
                self.declared.push(Declared {
                    file: path.to_owned(),
                    owner: owner.clone(),
                    name: name.to_string(),
                    by_owner,
                });
            }
        }
    }

    /// Keeps the words of the examples in some documentation.
    fn words(&mut self, path: &Path, attributes: &[Attribute]) {
        let lines: Vec<String> = attributes.iter().filter_map(documentation).collect();
        let examples = self.examples.entry(path.to_owned()).or_default();
        for example in lines.join("\n").split("```").skip(1).step_by(2) {
            let words = example.split(|c: char| !c.is_alphanumeric() && c != '_');
            examples.push(words.map(String::from).collect());
        }
    }
}

/// The file and those of the modules above it, from which a reader comes; not the crate's own.
fn pages(file: &Path) -> Vec<PathBuf> {
    let mut pages = vec![file.to_owned()];
    for folder in file
        .ancestors()
        .skip(1)
        .take_while(|folder| !folder.ends_with("src"))
    {
        pages.extend([folder.join("mod.rs"), folder.with_extension("rs")]);
    }
    pages
}

fn documentation(attribute: &Attribute) -> Option<String> {
    let Meta::NameValue(pair) = &attribute.meta else {
        return None;
    };
    let Expr::Lit(literal) = &pair.value else {
        return None;
    };
    match &literal.lit {
        Lit::Str(text) if pair.path.is_ident("doc") => Some(text.value()),
        _ => None,
    }
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// The names that a `use` brings out.
fn names(tree: &UseTree, into: &mut BTreeSet<String>) {
    match tree {
        UseTree::Path(path) => names(&path.tree, into),
        UseTree::Group(group) => group.items.iter().for_each(|tree| names(tree, into)),
        UseTree::Name(name) => drop(into.insert(name.ident.to_string())),
        UseTree::Rename(name) => drop(into.insert(name.ident.to_string())),
        UseTree::Glob(_) => {}
    }
}
