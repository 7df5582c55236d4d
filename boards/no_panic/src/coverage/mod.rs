//! Whether the list is complete: the kernel's source against the names in the image.
//!
//! From the source come all public functions: free ones, methods of public types, and methods of
//! public traits for every type that implements them, provided methods included. The list gives the
//! compiler's names of its entries. Both are brought to one form, such as
//! `<coupling::table::Coulomb as coupling::Coupling>::reduced_wrench`.

mod declared;
mod names;
mod source;

pub use declared::Kernel;
pub use names::Name;

use crate::kept::{Keeper, everything};
use std::collections::{BTreeMap, BTreeSet};

/// Traits of the core library that are left out, and why.
pub const LEFT_OUT: [(&str, &str); 4] = [
    (
        "Display",
        "writes numbers through core::fmt, which has panics of its own",
    ),
    ("Debug", "the same"),
    ("Error", "has no method of its own here"),
    ("Format", "logging, behind a feature"),
];

/// A function that has to be in the image.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Required {
    /// In the form of [`Name::path`].
    pub path: String,
    /// "f32", "f64" or none.
    pub precision: Option<&'static str>,
}

/// The names of all functions that are kept, as the compiler spells them.
pub fn kept_names() -> Vec<&'static str> {
    struct Names(Vec<&'static str>);
    impl Keeper for Names {
        fn keep(&mut self, name: &'static str, _: *const ()) {
            self.0.push(name);
        }
    }
    let mut names = Names(Vec::new());
    everything(&mut names);
    names.0
}

/// Required functions that are not in the image.
pub fn missing(required: &BTreeSet<Required>, kept: &[&str]) -> Vec<Required> {
    let mut precisions: BTreeMap<String, BTreeSet<&str>> = BTreeMap::new();
    for name in kept.iter().map(|name| Name::of(name)) {
        precisions
            .entry(name.path)
            .or_default()
            .extend(name.precisions);
    }
    let is_kept = |required: &&Required| {
        precisions.get(&required.path).is_some_and(|present| {
            required
                .precision
                .is_none_or(|precision| present.contains(precision))
        })
    };
    required
        .iter()
        .filter(|required| !is_kept(required))
        .cloned()
        .collect()
}
