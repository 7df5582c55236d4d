//! Shipped scenes have the bits of their golden files on every platform and in every profile.
//!
//! A change of them is a change of results: say so in the changelog under *Numerical results
//! changed*, and write the files again with `tribos golden write`.

use std::path::Path;
use tribos::golden::{Golden, Verdict, measure};
use tribos::scene::Scene;

type Outcome = Result<(), Box<dyn std::error::Error>>;

/// Runs the scenes of a golden file but for `left_out`; all that differ are told.
fn assert_pinned(file: &str, left_out: &str) -> Outcome {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let golden = Golden::parse(file, &std::fs::read_to_string(folder.join(file))?)?;
    assert!(!golden.scenes.is_empty());
    let mut wrong = Vec::new();
    for pinned in golden.scenes.iter().filter(|scene| scene.path != left_out) {
        let scene = Scene::read(&folder.join(&pinned.path), &pinned.overrides)?;
        match pinned.compare(&measure(&scene, || ())?) {
            Verdict::Same => {}
            Verdict::SceneChanged(what) => wrong.push(format!("{}: {what}", pinned.path)),
            Verdict::Differs(what) => wrong.push(format!("{}: {what}", pinned.path)),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    Ok(())
}

#[test]
fn bodies_that_slide_have_their_pinned_bits() -> Outcome {
    // The whole compaction is left to the optimised program.
    assert_pinned("golden.toml", "compaction-small.toml")
}

#[test]
fn the_first_steps_of_a_powder_have_their_pinned_bits() -> Outcome {
    assert_pinned("golden-short.toml", "")
}
