//! Every public item of the libraries stands in an example that is compiled and run.

use std::path::Path;
use tribos_tests::shown::without_example;

const LIBRARIES: [&str; 4] = ["core", "core/sqrt", "std-adapter", "rapier"];

#[test]
fn every_public_item_stands_in_an_example() {
    let mut lacking = Vec::new();
    for library in LIBRARIES {
        let src = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("..")
            .join(library)
            .join("src");
        let items = without_example(&src).expect("its source parses");
        lacking.extend(items.iter().map(|item| format!("{library}/src/{item}")));
    }
    assert!(
        lacking.is_empty(),
        "{} are in no example:\n{}",
        lacking.len(),
        lacking.join("\n")
    );
}
