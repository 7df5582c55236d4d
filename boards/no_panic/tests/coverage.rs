//! The proof speaks of every public function, and every public type can be logged.

use std::collections::BTreeSet;
use tribos_no_panic::coverage::{Kernel, Required, kept_names, missing};

fn kernel() -> Kernel {
    Kernel::read().expect("the kernel's source can be read")
}

#[test]
fn every_public_function_is_in_the_image_in_both_precisions() {
    let required = kernel().functions().unwrap();
    // Far fewer would mean that the source was not understood.
    assert!(required.len() > 900, "{} functions", required.len());
    let missing = missing(&required, &kept_names());
    assert!(missing.is_empty(), "add these to kept/: {missing:#?}");
}

#[test]
fn a_function_that_is_not_kept_is_missed() {
    let required = |path: &str, precision| Required {
        path: path.into(),
        precision,
    };
    let kept = ["tribos_core::law::drag::reynolds<f32>"];
    let narrow = required("law::drag::reynolds", Some("f32"));
    let wide = required("law::drag::reynolds", Some("f64"));
    let other = required("law::drag::crossover_reynolds", Some("f32"));
    let all = BTreeSet::from([narrow, wide.clone(), other.clone()]);
    assert_eq!(missing(&all, &kept), [other, wide]);
}

#[test]
fn every_public_type_can_be_logged() {
    let without = kernel().types_without_format();
    assert!(
        without.is_empty(),
        "without defmt::Format under the feature defmt: {without:#?}"
    );
}
