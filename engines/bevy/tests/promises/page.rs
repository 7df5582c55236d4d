//! The page of the manual shows the program of the README, which is compiled as a documentation test.

use std::fs;
use std::path::Path;

#[test]
fn the_page_shows_the_program_of_the_readme() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    let readme = read("README.md");
    let (_, program) = readme.split_once("```rust").unwrap();
    let (_, program) = program.split_once('\n').unwrap();
    let (program, _) = program.split_once("\n```").unwrap();
    assert!(read("../../docs/games.md").contains(program));
}
