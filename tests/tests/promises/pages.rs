//! The book keeps its form: one title a page, tables that fit a screen, one dialect of the command, no program that is not run.

use std::fs;
use std::path::{Path, PathBuf};
use tribos_tests::pages::PAGES;

/// Rows of a table that a reader takes in; longer ones are files beside the page.
const ROWS: usize = 12;
/// Their tables are made by programs, or are the bytes of a file.
const LISTS: [&str; 4] = ["exhibits.md", "formats.md", "keys.md", "results.md"];
/// Their programs in Rust need crates of the engines' workspace, which compiles them.
const ENGINES: [&str; 1] = ["games.md"];

fn pages() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let paths = fs::read_dir(folder).expect("the book");
    let mut paths: Vec<PathBuf> = paths.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    assert!(paths.len() > 40, "{} pages", paths.len());
    let read = |path: PathBuf| {
        let name = path.file_name().expect("a name").to_string_lossy();
        (
            name.into_owned(),
            fs::read_to_string(&path).expect("a page"),
        )
    };
    paths.into_iter().map(read).collect()
}

#[test]
fn a_page_has_one_title_and_tables_that_fit_a_screen() {
    for (name, text) in pages() {
        assert!(text.starts_with("# "), "{name}");
        let mut code = false;
        let (mut titles, mut rows) = (0, 0);
        for line in text.lines() {
            let fence = line.trim_start().strip_prefix("```");
            // Tools take a block without a language for Rust, or guess.
            assert!(
                code || fence != Some(""),
                "{name}: a block without a language"
            );
            code ^= fence.is_some();
            titles += usize::from(!code && line.starts_with("# "));
            rows = if line.starts_with('|') { rows + 1 } else { 0 };
            let fits = rows <= ROWS + 2 || LISTS.contains(&&*name);
            assert!(fits, "{name}: a table of more than {ROWS} rows: {line}");
        }
        assert!(titles == 1 && !code, "{name}: {titles} titles");
    }
}

#[test]
fn commands_have_one_dialect() {
    for (name, text) in pages() {
        assert!(!text.contains("cargo run --release -- "), "{name}");
        let indented = text.lines().find(|line| line.starts_with("    tribos "));
        assert_eq!(indented, None, "{name}");
    }
}

#[test]
fn every_program_in_rust_is_compiled() {
    for (name, text) in pages() {
        let has_rust = text.contains("```rust");
        let listed = PAGES.contains(&&*format!("docs/{name}"));
        assert_eq!(has_rust && !ENGINES.contains(&&*name), listed, "{name}");
        assert!(!text.contains("```rust,ignore"), "{name}");
    }
}

#[test]
fn programs_for_engines_are_those_that_their_readmes_compile() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let read = |name: &str| fs::read_to_string(root.join(name)).expect("a page");
    let page = read("docs/games.md");
    for engine in ["bevy", "rapier2d"] {
        let readme = read(&format!("engines/{engine}/README.md"));
        let (_, block) = readme.split_once("```rust").expect("a program");
        let (_, program) = block.split_once('\n').expect("its first line");
        let (program, _) = program.split_once("\n```").expect("its end");
        assert!(page.contains(program), "{engine}");
    }
}
