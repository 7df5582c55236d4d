//! Folders of earlier versions: an interrupted run goes on to the summary that it would have had then.
//!
//! `before/` has runs of 27 November 2026, broken off by a signal, each with the summary of the same run left alone. That
//! of the powder is of the run's second half since walls are swept in turn.

use crate::program::{Outcome, json, succeed, summary};
use std::path::Path;
use tribos::scene::with_present_names;

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
        for (name, value) in quantities.iter().filter(|(name, _)| *name != "scene") {
            assert_eq!(now[name], *value, "{body}: {name}");
        }
        assert_eq!(now["scene"], with_present_names(&then["scene"]), "{body}");
    }
    Ok(())
}
