//! A finished run of a powder.

use super::{packing, summary};
use crate::command::explain::line;
use crate::command::explain::powder::{MODES, SWITCHES, coefficients};
use crate::failure::Failure;
use std::path::Path;
use tribos::powder::PowderCost;
use tribos::scene::PowderScene;

/// The account of the run in `out`; `command` runs the scene anew, with one more override.
pub fn text(scene: &PowderScene, out: &Path, command: &str) -> Result<String, Failure> {
    let summary = summary(out, PowderScene::KEYS, &scene.json())?;
    let advice = |mode, share| advice(scene, mode, share, command);
    Ok(packing::text(&summary, coefficients(scene), advice))
}

/// A mode that did next to nothing.
fn advice(scene: &PowderScene, mode: usize, share: f64, command: &str) -> String {
    let name = MODES[mode];
    let before = scene.material().carried().modes.unknowns();
    let after = PowderCost::unknowns_without(scene, mode);
    let saved = if after < before {
        format!("{before} unknowns a contact become {after}")
    } else {
        format!("though contacts keep {before} unknowns")
    };
    let percent = 100.0 * share;
    line(
        "could go",
        format!(
            "{name} dissipated {percent:.2} %: could be left out, {saved}; a threshold that is never reached still holds, so check with"
        ),
    ) + &line("", format!("  {command} --set {}=0", SWITCHES[mode]))
}
