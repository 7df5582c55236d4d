//! Which public items of a crate an example shows, read from its source.
//!
//! An item is shown if an example names it where a reader looks: in the docs of the file that
//! defines it, or on the page of a parent module. A method has to be called; an associated
//! function that is called by the name of its type, such as a constructor, needs an example that
//! names both. Fields, variants and required methods of traits are shown by their owner.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{fs, io};
use syn::{Attribute, Expr, ImplItem, Item, Lit, Meta, TraitItem, Type, UseTree, Visibility};

/// An item with `pub`.
#[derive(Debug)]
struct Declared {
    file: PathBuf,
    name: String,
    /// It stands in a public module.
    public: bool,
}

/// A function or a constant of a type.
#[derive(Debug)]
struct Member {
    file: PathBuf,
    owner: String,
    name: String,
    /// It is called by the name of its owner, not on a value.
    by_owner: bool,
}

#[derive(Debug, Default)]
struct Crate {
    declared: Vec<Declared>,
    members: Vec<Member>,
    /// Names that public modules bring out, with the file of the module.
    uses: BTreeSet<(PathBuf, String)>,
    /// The examples of each file.
    examples: BTreeMap<PathBuf, Vec<String>>,
}

/// Public items of the crate whose `lib.rs` stands in `src` that no example shows, as
/// `file: Owner::name`.
///
/// # Errors
/// A file that cannot be read or parsed.
pub fn without_example(src: &Path) -> io::Result<Vec<String>> {
    let mut found = Crate::default();
    found.file(&src.join("lib.rs"), src, true)?;
    let items = found.declared.iter().filter(|item| found.is_public(item));
    let items = items.filter(|item| !found.shows(&item.file, |text| has_word(text, &item.name)));
    let members = found
        .members
        .iter()
        .filter(|member| found.owner_is_public(member));
    let members = members.filter(|member| {
        !found.shows(&member.file, |text| {
            is_called(text, &member.name) && (!member.by_owner || has_word(text, &member.owner))
        })
    });
    let file = |path: &Path| path.strip_prefix(src).unwrap_or(path).display().to_string();
    let items = items.map(|item| format!("{}: {}", file(&item.file), item.name));
    let members =
        members.map(|member| format!("{}: {}::{}", file(&member.file), member.owner, member.name));
    Ok(items.chain(members).collect())
}

impl Crate {
    fn is_public(&self, item: &Declared) -> bool {
        let brought = |page: PathBuf| self.uses.contains(&(page, item.name.clone()));
        item.public || above(&item.file).into_iter().any(brought)
    }

    /// The owner stands in the same folder, or in a module above.
    fn owner_is_public(&self, member: &Member) -> bool {
        let near = |item: &&Declared| {
            item.name == member.owner
                && (item.file.parent() == member.file.parent()
                    || pages(&member.file).contains(&item.file))
        };
        self.declared
            .iter()
            .filter(near)
            .any(|item| self.is_public(item))
    }

    fn shows(&self, file: &Path, what: impl Fn(&str) -> bool) -> bool {
        let pages = pages(file);
        let mut examples = pages
            .iter()
            .filter_map(|page| self.examples.get(page))
            .flatten();
        examples.any(|text| what(text))
    }

    fn file(&mut self, path: &Path, folder: &Path, public: bool) -> io::Result<()> {
        let wrong = |e| io::Error::other(format!("{}: {e}", path.display()));
        let parsed = syn::parse_file(&fs::read_to_string(path)?).map_err(wrong)?;
        self.keep_examples(path, &parsed.attrs);
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
                    self.keep_examples(path, &module.attrs);
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
                    names(&import.tree, path, &mut self.uses)
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
                            self.keep_examples(path, &f.attrs);
                        }
                    }
                }
                Item::Impl(block) => {
                    self.keep_examples(path, &block.attrs);
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
        self.keep_examples(path, attributes);
        if !is_public(visibility) {
            return;
        }
        self.declared.push(Declared {
            file: path.to_owned(),
            name: name.to_string(),
            public,
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
            self.keep_examples(path, attributes);
            // Methods of a trait are the trait's.
            if let (None, true, Some(owner)) = (&block.trait_, is_public(visibility), &owner) {
                self.members.push(Member {
                    file: path.to_owned(),
                    owner: owner.clone(),
                    name: name.to_string(),
                    by_owner,
                });
            }
        }
    }

    /// Keeps the examples in some documentation.
    fn keep_examples(&mut self, path: &Path, attributes: &[Attribute]) {
        let lines: Vec<String> = attributes.iter().filter_map(documentation).collect();
        let text = lines.join("\n");
        let blocks = text.split("```").skip(1).step_by(2);
        let examples = blocks
            .filter(|block| !block.starts_with("text"))
            .map(String::from);
        self.examples
            .entry(path.to_owned())
            .or_default()
            .extend(examples);
    }
}

fn is_in_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn has_word(text: &str, name: &str) -> bool {
    text.split(|c| !is_in_word(c)).any(|word| word == name)
}

/// `.name` or `::name`.
fn is_called(text: &str, name: &str) -> bool {
    text.match_indices(name).any(|(at, _)| {
        let (before, after) = (&text[..at], &text[at + name.len()..]);
        (before.ends_with('.') || before.ends_with("::")) && !after.starts_with(is_in_word)
    })
}

/// The files of the modules above one, from which a reader comes, up to the crate's own.
fn above(file: &Path) -> Vec<PathBuf> {
    let mut pages = Vec::new();
    for folder in file.ancestors().skip(1) {
        if folder.ends_with("src") {
            pages.push(folder.join("lib.rs"));
            break;
        }
        pages.extend([folder.join("mod.rs"), folder.with_extension("rs")]);
    }
    pages
}

/// The file and those above it but the crate's own.
fn pages(file: &Path) -> Vec<PathBuf> {
    let mut pages = above(file);
    pages.pop();
    pages.push(file.to_owned());
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
fn names(tree: &UseTree, file: &Path, into: &mut BTreeSet<(PathBuf, String)>) {
    let name = match tree {
        UseTree::Path(path) => return names(&path.tree, file, into),
        UseTree::Group(group) => {
            return group.items.iter().for_each(|tree| names(tree, file, into));
        }
        UseTree::Glob(_) => return,
        UseTree::Name(name) => &name.ident,
        UseTree::Rename(name) => &name.ident,
    };
    into.insert((file.to_owned(), name.to_string()));
}
