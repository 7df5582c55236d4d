//! Regression test of bits across platforms: the digests of `subjects/digests.txt` were printed once
//! and have to come out everywhere, in every build profile.
//!
//! A change of them is a change of results: say so in the changelog under *Numerical results
//! changed*. New values stand in the failure of this test. `cargo run -p tribos-tests --bin cross`
//! computes them on every platform there is.

use tribos_subjects::SUBJECTS;

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
    let listed = include_str!("../../subjects/digests.txt").lines().count();
    let mut seen: Vec<u64> = SUBJECTS.iter().filter_map(|one| one.pinned()).collect();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!([listed, seen.len()], [SUBJECTS.len(); 2]);
}
