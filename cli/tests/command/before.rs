//! Folders of earlier versions: an interrupted run goes on to the summary that it would have had then.
//!
//! `before/` has runs of 27 November 2026, broken off by a signal, each with the summary of the same run left alone. Gas
//! and grains end with its numbers. A powder's contacts are solved in another way since: it ends in the same manner, with
//! measures close to those of then.

use crate::program::{Outcome, json, succeed, summary};
use std::path::Path;
use tribos::scene::with_present_names;

/// Measures of a powder that another way to solve changes little, and by how much of themselves at most: 0.6 % seen.
const POWDER: [&str; 9] = [
    "porosity_initial",
    "porosity_final",
    "porosity_bulk",
    "height_initial",
    "height_final",
    "particles",
    "steps",
    "stress_zz",
    "stress_zz_plus",
];
const POWDER_CHANGE: f64 = 0.02;

#[test]
fn runs_that_an_earlier_version_broke_off_end_as_they_would_have_then() -> Outcome {
    for body in ["gas", "grains", "powder"] {
        let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/command/before");
        let kept = kept.join(body);
        let folder = tempfile::tempdir()?;
        let out = folder.path().join("out");
        std::fs::create_dir(&out)?;
        for file in ["checkpoint.json", "tribos.json"] {
            std::fs::copy(kept.join(file), out.join(file))?;
        }
        std::fs::copy(kept.join("scene.toml"), folder.path().join("scene.toml"))?;
        succeed(folder.path(), "run scene.toml --out out --resume")?;
        let (then, now) = (json(&kept.join("summary.json"))?, summary(&out)?);
        let quantities = then.as_object().ok_or("no summary")?;
        assert!(quantities.len() > 10, "{body}");
        if body == "powder" {
            assert_eq!(now["ending"], then["ending"]);
            for name in POWDER {
                let [then, now] = [&then, &now].map(|of| of[name].as_f64().unwrap_or(f64::NAN));
                let change = (now - then).abs();
                assert!(change <= POWDER_CHANGE * then, "{name}: {now}, was {then}");
            }
        } else {
            for (name, value) in quantities.iter().filter(|(name, _)| *name != "scene") {
                assert_eq!(now[name], *value, "{body}: {name}");
            }
        }
        assert_eq!(now["scene"], with_present_names(&then["scene"]), "{body}");
    }
    Ok(())
}
