//! Names of types say what the things are.

use std::fs;
use std::path::{Path, PathBuf};

/// Words that name no thing by themselves: participles, pronouns, adverbs.
const BARE: &str = "Kept Told Seen Made Found Held Given Lent Begun Lying Ran Drawn Posed Judged Stated Wanted Asked \
                    Thrown Stepped Moved Laden Taken Which Many One Either Own By On Until Now Nobody Nowhere Everywhere \
                    Otherwise Around Beside Inside Watch Look Way Place Piece Course Pace";
/// What begins the definition of a type.
const KINDS: [&str; 5] = ["struct", "enum", "trait", "type", "union"];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the folder is readable") {
        let path = entry.expect("the entry is readable").path();
        let name = path
            .file_name()
            .map(|name| name.to_string_lossy().into_owned());
        if path.is_dir() {
            if name.is_none_or(|name| {
                name != "target" && name != "node_modules" && !name.starts_with('.')
            }) {
                sources(&path, found);
            }
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// The name of the type that a line of source defines.
fn defined(line: &str) -> Option<&str> {
    let mut words = line
        .split_whitespace()
        .skip_while(|word| word.starts_with("pub"));
    let kind = words.next()?;
    let name = words.next()?;
    let end = name
        .find(|c: char| !c.is_alphanumeric())
        .unwrap_or(name.len());
    KINDS.contains(&kind).then_some(&name[..end])
}

#[test]
fn no_type_is_named_by_a_bare_word() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = Vec::new();
    sources(&root, &mut files);
    assert!(files.len() > 1000, "the sources are found");
    let mut bare = Vec::new();
    for file in &files {
        let text = fs::read_to_string(file).expect("a source is text");
        let named = text.lines().filter_map(defined);
        for name in named.filter(|name| BARE.split_whitespace().any(|word| word == *name)) {
            bare.push(format!("{}: {name}", file.display()));
        }
    }
    assert!(bare.is_empty(), "name the thing instead: {bare:#?}");
}
