//! A finished run of grains.

use super::{packing, summary};
use crate::command::explain::line;
use crate::command::explain::powder::{MODES, SWITCHES};
use crate::failure::Failure;
use std::path::Path;
use tribos::scene::GrainsScene;

/// The account of the run in `out`.
pub fn text(scene: &GrainsScene, out: &Path) -> Result<String, Failure> {
    let summary = summary(out, GrainsScene::KEYS, &scene.json())?;
    let coefficients = [scene.mu, scene.mu_rolling, scene.mu_torsion];
    let advice = |mode: usize, _| {
        let [name, key] = [MODES[mode], SWITCHES[mode]];
        let text = format!("{name} dissipated less than 1 %; check with --set {key}=0");
        line("could go", text)
    };
    Ok(packing::text(&summary, coefficients, advice))
}
