//! Scenes of fitted laws run as they are.

use crate::program::{Outcome, succeed};
use std::path::Path;

/// Laws whose friction rises with the speed, so that the pull becomes steady, and the force in N by their formulas:
/// the coefficient at 0.05 m/s (1e-6 m/s for rate and state) times 10 N.
const FORCES: [(&str, f64); 3] = [
    ("tanh", 7.999_273),
    ("rising", 0.970_796),
    ("rate-state", 6.000_005),
];
/// Share of the force by which the mean over a whole number of rows may differ.
const NEAR: f64 = 1e-3;

#[test]
fn scenes_of_fitted_laws_run() -> Outcome {
    let page = "../std-adapter/motion/src/fit/usage/programs.md";
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(page))?;
    let folder = tempfile::tempdir()?;
    let mut count = 0;
    for law in page.split("\n## ").skip(1) {
        let (name, text) = law.split_once('\n').ok_or("a name")?;
        let Some((_, scene)) = text.split_once("```toml\n") else {
            continue;
        };
        let (scene, _) = scene.split_once("```").ok_or("its end")?;
        std::fs::write(folder.path().join("fitted.toml"), scene)?;
        let [told, _] = succeed(folder.path(), "run fitted.toml --out out")?;
        if let Some((_, wanted)) = FORCES.into_iter().find(|(known, _)| *known == name) {
            let mut force = told.split_whitespace().skip_while(|word| *word != "force");
            let force: f64 = force.nth(1).ok_or("a force")?.parse()?;
            assert!((force / wanted - 1.0).abs() < NEAR, "{name}\n{told}");
        }
        count += 1;
    }
    assert!(count >= 12, "{count} scenes");
    Ok(())
}
