//! Scenes of fitted laws run as they are.

use crate::program::{Outcome, succeed};
use std::path::Path;

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
        let [told, _] = succeed(folder.path(), "run fitted.toml")?;
        println!("{name}\n{told}");
        count += 1;
    }
    assert!(count >= 12, "{count} scenes");
    Ok(())
}
