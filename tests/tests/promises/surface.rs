//! The surface of the libraries is the one that is kept; every public type of the kernel can be
//! logged.

use std::collections::BTreeSet;
use tribos_api::{LIBRARIES, Library, kept};

#[test]
fn the_surface_changes_only_with_the_file_that_keeps_it() {
    for package in LIBRARIES {
        let now = Library::read(package, &[]).and_then(|library| library.lines());
        let now = now.unwrap_or_else(|error| panic!("{error}"));
        let text = std::fs::read_to_string(kept(package)).expect("it is kept");
        let lines: BTreeSet<&str> = text.lines().collect();
        let gone = lines
            .iter()
            .filter(|line| !now.iter().any(|other| other == *line));
        let gone = gone.map(|line| format!("- {line}\n"));
        let new = now.iter().filter(|line| !lines.contains(line.as_str()));
        let new = new.map(|line| format!("+ {line}\n"));
        let changes: String = gone.chain(new).collect();
        assert!(
            changes.is_empty(),
            "the surface of {package} changed; if it is meant to, cargo run -p tribos-api\n{changes}"
        );
    }
}

/// Items that a user has to know by name. The numbers may only fall; a rise needs a line in CHANGELOG.
const ITEMS: [(&str, usize); LIBRARIES.len()] = [("tribos-core", 198), ("tribos", 252)];

#[test]
fn no_library_has_more_items_than_it_had() {
    for (package, most) in ITEMS {
        let text = std::fs::read_to_string(kept(package)).expect("it is kept");
        let count = text.trim_start_matches("# ").split(' ').next();
        let count: usize = count.and_then(|count| count.parse().ok()).expect("a count");
        assert!(
            count == most,
            "{package} has {count} items and {most} are kept: lower `ITEMS` here, or raise it and tell why in CHANGELOG"
        );
    }
}

#[test]
fn every_public_type_of_the_kernel_can_be_logged() {
    let kernel = Library::read("tribos-core", &["defmt"]).expect("rustdoc runs");
    let without = kernel.without("Format").expect("the format is known");
    assert!(
        without.is_empty(),
        "without defmt::Format under the feature defmt: {without:#?}"
    );
}
