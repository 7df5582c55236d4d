//! The kernel's source files, read into items with their modules.

use std::path::Path;
use syn::{Attribute, Item};

/// An item and its module, such as `coupling::table`; the root is empty.
#[derive(Debug)]
pub struct Placed {
    /// The module.
    pub module: String,
    /// The item.
    pub item: Item,
    /// Whether the item is compiled conditionally: tests, features.
    pub conditional: bool,
}

/// All items of the kernel.
pub fn read() -> Result<Vec<Placed>, String> {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../core/src"));
    let mut items = Vec::new();
    read_folder(root, "", &mut items)?;
    Ok(items)
}

fn read_folder(folder: &Path, module: &str, items: &mut Vec<Placed>) -> Result<(), String> {
    let told = |error: std::io::Error| format!("{}: {error}", folder.display());
    for entry in std::fs::read_dir(folder).map_err(told)? {
        let path = entry.map_err(told)?.path();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let inner = inside(module, &stem);
        if path.is_dir() {
            read_folder(&path, &inner, items)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = std::fs::read_to_string(&path).map_err(told)?;
            let file = syn::parse_file(&text);
            let file = file.map_err(|error| format!("{}: {error}", path.display()))?;
            let is_own = stem == "mod" || stem == "lib";
            place(
                file.items,
                if is_own { module } else { &inner },
                false,
                items,
            );
        }
    }
    Ok(())
}

fn place(found: Vec<Item>, module: &str, around: bool, items: &mut Vec<Placed>) {
    for item in found {
        let conditional = around || is_conditional(attributes(&item));
        if let Item::Mod(inner) = &item
            && let Some((_, content)) = &inner.content
        {
            let module = inside(module, &inner.ident.to_string());
            place(content.clone(), &module, conditional, items);
        }
        items.push(Placed {
            module: module.into(),
            item,
            conditional,
        });
    }
}

/// The path of something in a module.
pub fn inside(module: &str, name: &str) -> String {
    if module.is_empty() {
        name.into()
    } else {
        format!("{module}::{name}")
    }
}

fn is_conditional(attributes: &[Attribute]) -> bool {
    attributes
        .iter()
        .any(|attribute| attribute.path().is_ident("cfg"))
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        _ => &[],
    }
}
