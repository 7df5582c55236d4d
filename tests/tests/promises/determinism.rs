//! Regression test of bits across platforms: the digests of `digest/digests.txt` were printed once
//! and have to come out everywhere, in every build profile.
//!
//! A change of them is a change of results: say so in the changelog under *Numerical results
//! changed*. New values stand in the failure of this test. `cargo run -p tribos-tests --bin cross`
//! computes them on every platform there is.

use tribos_digest::{CHAPTERS, pinned};

#[test]
fn every_chapter_has_the_pinned_bits() {
    let mut wrong = Vec::new();
    for chapter in CHAPTERS {
        let got = (chapter.run)();
        if pinned(chapter.name) != Some(got) {
            wrong.push(format!("{} {got:#018x}", chapter.name));
        }
    }
    assert!(wrong.is_empty(), "now:\n{}", wrong.join("\n"));
}

#[test]
fn every_pinned_digest_has_a_chapter_and_is_its_own() {
    let listed = include_str!("../../digest/digests.txt").lines().count();
    let mut seen: Vec<u64> = CHAPTERS.iter().filter_map(|c| pinned(c.name)).collect();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!([listed, seen.len()], [CHAPTERS.len(); 2]);
}
