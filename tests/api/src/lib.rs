//! The public items of a library, as the compiler lists them.
//!
//! rustdoc writes what it knows of a crate as JSON; [`Library::read`] runs it and follows public
//! modules and re-exports from the root. What macros and derives write is in it like everything
//! else. [`Library::functions`] feeds the coverage of the proofs (digests, fuzzing, no panic,
//! prices); [`Library::lines`] is the surface, one item a line, kept beside this file:
//! `cargo run -p tribos-api` rewrites it.

mod document;
mod functions;
mod instances;
mod merge;
mod surface;
mod types;

pub use document::Library;
pub use functions::{Function, Parameter};
pub use instances::{CONSTANTS, EVERY, INSTANCES, Instance, THOROUGH, UNBOUNDED};

/// The libraries whose surface is kept.
pub const LIBRARIES: [&str; 2] = ["tribos-core", "tribos"];

/// The crates whose items a library shows as its own.
pub(crate) fn parts(package: &str) -> &'static [&'static str] {
    match package {
        "tribos" => &[
            "tribos-base",
            "tribos-friction",
            "tribos-contacts",
            "tribos-grains",
            "tribos-atoms",
            "tribos-motion",
        ],
        _ => &[],
    }
}

/// The file that keeps the surface of a library.
pub fn kept(package: &str) -> std::path::PathBuf {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    folder.join("surface").join(format!("{package}.txt"))
}
