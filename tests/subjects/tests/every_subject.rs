//! Every part of the kernel: its properties hold for half a million seeded inputs, and the digests of
//! `digests.txt`, which were printed once, come out everywhere, in every build profile. That no input takes long is
//! checked by the program `fuzz`.
//!
//! A change of a digest is a change of results: say so in the changelog under *Numerical results
//! changed*. New values stand in the failure of this test. `cargo run -p tribos-tests --bin cross`
//! computes them on every platform there is.

use std::ops::Range;
use std::panic::catch_unwind;
use tribos_subjects::{RUN, SUBJECTS, seed_of};

/// Inputs per unit of a subject's share: first some, since most faults break them already.
const FIRST: u64 = 32;
const INPUTS: u64 = 500;

#[test]
fn no_first_input_breaks_a_property() {
    assert_properties_of(0..FIRST);
}

#[test]
fn no_further_input_breaks_a_property() {
    assert_properties_of(FIRST..INPUTS);
}

fn assert_properties_of(inputs: Range<u64>) {
    for subject in SUBJECTS {
        for index in inputs.start * subject.share..inputs.end * subject.share {
            let seed = seed_of(RUN, index);
            let judged = catch_unwind(|| subject.take(seed, &mut |_| ()));
            assert!(
                matches!(judged, Ok(Ok(()))),
                "fuzz --only \"{}\" --repeat {seed}: {judged:?}",
                subject.name
            );
        }
    }
}

#[test]
fn every_subject_has_the_pinned_bits() {
    let mut wrong = Vec::new();
    for subject in SUBJECTS {
        let got = subject.digest();
        if subject.pinned() != Some(got) {
            wrong.push(format!("{} {got:#018x}", subject.name));
        }
    }
    assert!(wrong.is_empty(), "now:\n{}", wrong.join("\n"));
}

#[test]
fn every_pinned_digest_has_a_subject_and_is_its_own() {
    let listed = include_str!("../digests.txt").lines().count();
    let mut seen: Vec<u64> = SUBJECTS.iter().filter_map(|one| one.pinned()).collect();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!([listed, seen.len()], [SUBJECTS.len(); 2]);
}
